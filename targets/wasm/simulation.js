// A simulation that eagerx-gen has made for target wasm, for JavaScript. The same file is part of pages of
// `eagerx-gen report --simulate` and runs in Node.
"use strict";

/** What decides on actions; `hand`: the numbers of `actions`. */
const kDrivers = ["policy", "zero", "random", "hand"];
/** Of one call of a module. */
const kMostSteps = 2n ** 32n - 1n;

class Simulation {
  /** Of the bytes of a module. Throws Error if this machine's results would differ. */
  static async of(bytes) {
    const module = await WebAssembly.compile(bytes);
    const imports = {};
    // The few that there may be are called where a program would abort.
    for (const {module: from, name} of WebAssembly.Module.imports(module)) {
      imports[from] = imports[from] || {};
      imports[from][name] = () => {
        throw new Error(`the simulation has stopped in ${name}`);
      };
    }
    return new Simulation(await WebAssembly.instantiate(module, imports));
  }

  constructor(instance) {
    this.calls = instance.exports;
    if (this.calls._initialize) this.calls._initialize();
    const problem = [
      null, "this machine does not keep denormal numbers, or rounds otherwise",
      "this module was compiled with flags that change the bits of its numbers",
      "this machine's answers of the policy differ from the generator's"
    ][this.calls.eagerx_check()];
    if (problem) throw new Error(problem);
    /**
       {graph, engine, rate: [num, den], agent, policy, steps, render, actions, states, messages, outcome}, the last
        four lists of {name, dtype, first, numbers, messages}: places in the rows of these names.
     */
    this.about = JSON.parse(this.text(this.calls.eagerx_describe()));
    const row = (name, fields) => {
      const numbers = fields.reduce((sum, field) => sum + field.numbers, 0);
      return new Float64Array(this.calls.memory.buffer, this.calls[`eagerx_${name}`](), numbers);
    };
    const {actions, states, messages, outcome} = this.about;
    this.actions = row("actions", actions);
    this.actionsLow = row("actions_low", actions);
    this.actionsHigh = row("actions_high", actions);
    /** Of the next episodes; NaN: drawn as the graph says. */
    this.settings = row("settings", states);
    /** What the episode began with. */
    this.states = row("states", states);
    this.statesLow = row("states_low", states);
    this.statesHigh = row("states_high", states);
    /** The newest message of each channel. */
    this.messages = row("messages", messages);
    this.outcome = row("outcome", outcome);
  }

  text(pointer) {
    const bytes = new Uint8Array(this.calls.memory.buffer, pointer);
    return new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0)));
  }

  /** A run begins, as a program that has just been started. `watched`: `messages` and pictures are wanted. */
  begin(seed, {environment = 0, watched = false} = {}) {
    this.calls.eagerx_begin(BigInt.asUintN(64, BigInt(seed)), environment, watched ? 1 : 0);
  }

  /** The next episode begins. False if one of `settings` is outside of its space: then nothing happens. */
  reset() {
    return this.calls.eagerx_reset() === 1;
  }

  /** At most `steps` steps, fewer if the graph's task ends the episode; how many it were. */
  step(driver, steps = 1) {
    return this.calls.eagerx_step(kDrivers.indexOf(driver), steps);
  }

  /** Whole episodes of at most `steps` steps (BigInt, as what comes back), reset included: how many steps they were. */
  episodes(driver, episodes, steps) {
    let done = 0n;
    for (let episode = 0n; episode < episodes; ++episode) {
      this.reset();
      for (let left = steps; left > 0n && !this.ended;) {
        const taken = BigInt(this.step(driver, Number(left < kMostSteps ? left : kMostSteps)));
        done += taken;
        left -= taken;
      }
    }
    return done;
  }

  /** Whether the graph's task has ended the episode. */
  get ended() {
    return this.calls.eagerx_ended() === 1;
  }

  /** Of all messages since begin(): the one that `--hash` prints. */
  get hash() {
    return `0x${BigInt.asUintN(64, this.calls.eagerx_hash()).toString(16).padStart(16, "0")}`;
  }

  /** What `render:` shows as bytes [height][width][4]: valid until the next call; null if there is none. */
  picture(width, height) {
    const pointer = this.calls.eagerx_picture(width, height);
    if (!pointer) return null;
    return new Uint8ClampedArray(this.calls.memory.buffer, pointer, 4 * width * height);
  }

  /** What guards and nodes have counted that is not 0: {name: count}. */
  get counts() {
    return JSON.parse(this.text(this.calls.eagerx_counts()));
  }
}

if (typeof module !== "undefined") module.exports = {Simulation, kDrivers};
