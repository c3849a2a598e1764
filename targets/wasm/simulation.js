// JavaScript interface to a simulation that eagerx-gen generates for target wasm. This file runs in Node, and is part
// of the pages of `eagerx-gen report --simulate`.
"use strict";

/** Sources of actions; `hand`: the numbers in `actions`. */
const kDrivers = ["policy", "zero", "random", "hand"];
/** Maximum in one call of a module. */
const kMostSteps = 2n ** 32n - 1n;

/** Rows of numbers, each with the list in the module's description that defines its columns. */
const kRows = {
  actions: "actions",
  actions_low: "actions",
  actions_high: "actions",
  settings: "states",
  states: "states",
  states_low: "states",
  states_high: "states",
  messages: "messages",
  outcome: "outcome"
};
const kCalls = [
  "check", "describe", "begin", "reset", "tune", "step", "ended", "hash", "picture", "counts", ...Object.keys(kRows)
];
/** Limits of a text in bytes, and of the number of imports. */
const kLongestText = 1 << 24, kMostImports = 1000;

/** Throws Error unless `exports` has all functions and the memory of a module of eagerx-gen. */
function checkExports(exports) {
  const missing = kCalls.find((name) => typeof exports[`eagerx_${name}`] !== "function");
  if (missing) throw new Error(`this is no module that eagerx-gen has made: it has no function eagerx_${missing}`);
  if (!(exports.memory instanceof WebAssembly.Memory))
    throw new Error("this is not a module that eagerx-gen has made: it has no memory");
}

/** Parses the description of a module. Throws Error if it is malformed or does not fit into the memory. */
function readAbout(text, memoryBytes) {
  const wrong = (what) => new Error(`this is no module that eagerx-gen has made: ${what}`);
  let about;
  try {
    about = JSON.parse(text);
  } catch (problem) {
    throw wrong(`what it says of itself is no JSON: ${problem.message}`);
  }
  const positive = (number) => Number.isSafeInteger(number) && number > 0;
  if (about === null || typeof about !== "object") throw wrong("it says nothing of itself");
  for (const name of ["graph", "engine", "agent"])
    if (typeof about[name] !== "string") throw wrong(`\`${name}\` is not a text`);
  if (!Array.isArray(about.rate) || about.rate.length !== 2 || !about.rate.every(positive))
    throw wrong("`rate` is not two whole numbers");
  if (!Array.isArray(about.tunable) || !about.tunable.every((name) => typeof name === "string"))
    throw wrong("`tunable` is not a list of names");
  if (!Number.isInteger(about.steps) || about.steps < 0) throw wrong("`steps` is not a whole number");
  for (const name of new Set(Object.values(kRows))) {
    const fields = about[name];
    if (!Array.isArray(fields)) throw wrong(`\`${name}\` is no list`);
    let first = 0;
    for (const field of fields) {
      if (field === null || typeof field !== "object" || typeof field.name !== "string" ||
          typeof field.dtype !== "string" || field.first !== first || !positive(field.numbers))
        throw wrong(`\`${name}\` is no list of names and numbers`);
      first += field.numbers;
    }
    if (first * Float64Array.BYTES_PER_ELEMENT > memoryBytes) throw wrong(`\`${name}\` does not fit into its memory`);
  }
  return about;
}

class Simulation {
  /** Instantiates a module from its bytes. Throws Error if results on this machine would differ. */
  static async of(bytes) {
    const module = await WebAssembly.compile(bytes);
    // The object has no prototype because a module may import from `__proto__`.
    const imports = Object.create(null), names = WebAssembly.Module.imports(module);
    if (names.length > kMostImports) throw new Error(`a module that imports ${names.length} functions is none of ours`);
    // A module calls its few imports only where a program would abort.
    for (const {module: from, name} of names) {
      imports[from] = imports[from] || Object.create(null);
      imports[from][name] = () => {
        throw new Error(`the simulation has stopped in ${name}`);
      };
    }
    return new Simulation(await WebAssembly.instantiate(module, imports));
  }

  constructor(instance) {
    this.calls = instance.exports;
    checkExports(this.calls);
    if (this.calls._initialize) this.calls._initialize();
    const problem = [
      null, "this machine flushes denormal numbers, or does not round to nearest",
      "this module was compiled with flags that change the bits of its numbers",
      "this machine's answers of the policy differ from the generator's"
    ][this.calls.eagerx_check()];
    if (problem) throw new Error(problem);
    /**
     * Description of the module: {graph, engine, rate: [num, den], agent, policy, steps, render, actions, states,
     * tunable, messages, outcome}. `tunable` lists the states that tune() sets. actions, states, messages and outcome
     * are lists of {name, dtype, first, numbers, messages}, which locate the columns in the rows of these names.
     */
    this.about = readAbout(this.text(this.calls.eagerx_describe()), this.calls.memory.buffer.byteLength);
    const row = (name) => {
      const numbers = this.about[kRows[name]].reduce((sum, field) => sum + field.numbers, 0);
      return new Float64Array(this.calls.memory.buffer, this.calls[`eagerx_${name}`](), numbers);
    };
    this.actions = row("actions");
    this.actionsLow = row("actions_low");
    this.actionsHigh = row("actions_high");
    /** Values for the next episodes; NaN: sampled as the graph specifies. */
    this.settings = row("settings");
    /** Initial values of the episode. */
    this.states = row("states");
    this.statesLow = row("states_low");
    this.statesHigh = row("states_high");
    /** Newest message of each channel. */
    this.messages = row("messages");
    this.outcome = row("outcome");
  }

  text(pointer) {
    const bytes = new Uint8Array(this.calls.memory.buffer, pointer), end = bytes.indexOf(0);
    if (end < 0 || end > kLongestText) throw new Error("a text of the module does not end");
    return new TextDecoder().decode(bytes.subarray(0, end));
  }

  /** Begins a run, in the state of a program that has just started. `watched` enables `messages` and pictures. */
  begin(seed, {environment = 0, watched = false} = {}) {
    this.calls.eagerx_begin(BigInt.asUintN(64, BigInt(seed)), environment, watched ? 1 : 0);
  }

  /** Begins the next episode. Returns false and does nothing if a value in `settings` is outside of its space. */
  reset() {
    return this.calls.eagerx_reset() === 1;
  }

  /**
   * Applies the values of `about.tunable` in `settings` before the next step. Returns false and does nothing if a value
   * in `settings` is outside of its space.
   */
  tune() {
    return this.calls.eagerx_tune() === 1;
  }

  /** Runs at most `steps` steps, fewer if the graph's task ends the episode. Returns the number of steps. */
  step(driver, steps = 1) {
    return this.calls.eagerx_step(kDrivers.indexOf(driver), steps);
  }

  /**
   * Runs whole episodes of at most `steps` steps, including resets. Returns the total number of steps; both numbers are
   * BigInts. `sets`: [{first, values, step}] are values for `settings` from index `first` on, set before that step of
   * each episode or, if it is null, at its reset.
   */
  episodes(driver, episodes, steps, sets = []) {
    const least = (a, b) => a < b ? a : b;
    let done = 0n;
    for (let episode = 0n; episode < episodes; ++episode) {
      this.take(sets, null);
      this.reset();
      for (let step = 0n; step < steps && !this.ended;) {
        if (this.take(sets, step)) this.tune();
        const next = sets.reduce((next, set) => set.step > step ? least(next, set.step) : next, steps);
        const taken = BigInt(this.step(driver, Number(least(next - step, kMostSteps))));
        done += taken;
        step += taken;
      }
    }
    return done;
  }
  /** Fills `settings` with the values to set before a step. Returns false if there are none. */
  take(sets, step) {
    const now = sets.filter((set) => set.step === step);
    this.settings.fill(NaN);
    for (const set of now) this.settings.set(set.values, set.first);
    return now.length > 0;
  }

  /** True if the graph's task has ended the episode. */
  get ended() {
    return this.calls.eagerx_ended() === 1;
  }

  /** Hash of all messages since begin(), equal to the one that `--hash` prints. */
  get hash() {
    return `0x${BigInt.asUintN(64, this.calls.eagerx_hash()).toString(16).padStart(16, "0")}`;
  }

  /** Picture of `render:` as bytes [height][width][4], valid until the next call; null if there is none. */
  picture(width, height) {
    const pointer = this.calls.eagerx_picture(width, height);
    if (!pointer) return null;
    return new Uint8ClampedArray(this.calls.memory.buffer, pointer, 4 * width * height);
  }

  /** Counts of guards and nodes that are not 0: {name: count}. */
  get counts() {
    return JSON.parse(this.text(this.calls.eagerx_counts()));
  }
}

if (typeof module !== "undefined") module.exports = {Simulation, kDrivers};
