#!/usr/bin/env node
// Runs a module of target wasm: node run.js MODULE.wasm [OPTION...]. Its options are those of the other targets.
"use strict";
const fs = require("fs");
const {Simulation, kDrivers} = require("./simulation.js");

const kDone = 0, kProblem = 1, kBadUsage = 2, kBadFile = 3, kSelfTestFailed = 4;
const kMost32 = 2n ** 32n - 1n, kMost64 = 2n ** 64n - 1n;

class Failure extends Error {
  constructor(code, message, help) {
    super(message);
    this.code = code;
    this.help = help;
  }
}

const kHelp = `Options (defaults in brackets):
  --steps N         steps of each episode [300, or what the graph's task says]
  --episodes N      episodes [1]
  --seed N          what random numbers are sampled from [1]
  --environment N   one of many environments with this seed [0]
  --agent NAME      policy, zero or random [the agent of the graph]
  --set NAME=VALUE  of a state at each reset, VALUE@STEP of a tunable parameter from that step on; may be repeated
  --hash            only the line with the hash of the trace
  --time            also how long the steps took
  --help            this text
`;

/** Options as {steps, episodes, seed, environment, agent, sets}; numbers are BigInts. */
function parse(words) {
  const options = {episodes: 1n, seed: 1n, environment: 0n, sets: []};
  const most = {steps: kMost64, episodes: kMost32, seed: kMost64, environment: kMost32};
  for (let i = 0; i < words.length; ++i) {
    const name = words[i].replace(/^--/, "");
    if (["hash", "time", "help"].includes(name) && words[i].startsWith("--")) {
      options[name] = true;
      continue;
    }
    const value = words[++i];
    if (words[i - 1] === "--agent" && kDrivers.slice(0, 3).includes(value)) {
      options.agent = value;
    } else if (words[i - 1] === "--set" && value !== undefined) {
      options.sets.push(value);
    } else if (
        words[i - 1].startsWith("--") && name in most && /^\d{1,20}$/.test(value) && BigInt(value) <= most[name]) {
      options[name] = BigInt(value);
      if (["steps", "episodes"].includes(name) && options[name] === 0n) throw wrong(words[i - 1], value);
    } else {
      throw wrong(words[i - 1], value);
    }
  }
  return options;
}
function wrong(word, value) {
  return new Failure(
      kBadUsage, `wrong option or value at ${word}${value === undefined ? "" : ` ${value}`}`,
      "[--steps N] [--episodes N] [--seed N] [--environment N] [--agent policy|zero|random] " +
          "[--set NAME=VALUE] [--hash] [--time]");
}

/** Parses NAME=VALUE,… or NAME=VALUE,…@STEP into {first, values, step}. */
function settingOf(text, simulation) {
  const {about, statesLow, statesHigh} = simulation,
                           [, name, list, at] = /^([^=]+)=([^@]+)(?:@(\d{1,19}))?$/.exec(text) || [];
  const refuse = (message, help) => new Failure(kBadUsage, `\`--set ${text}\`: ${message}`, help);
  const values = (list || "").split(",").map((value) => value.trim() === "" ? NaN : Number(value));
  if (!values.every(Number.isFinite)) throw refuse("this is not a setting", "write NAME=NUMBER, or NAME=NUMBER@STEP");
  const field = about.states.find((each) => each.name === name);
  if (!field)
    throw refuse(
        `there is no state \`${name}\``, `it has ${about.states.map((each) => each.name).join(", ") || "none"}`);
  const {first, numbers} = field;
  if (values.length !== 1 && values.length !== numbers) throw refuse(`it has ${numbers} numbers`);
  if (at !== undefined && !about.tunable.includes(name))
    throw refuse(
        "it can be set at a reset, not while an episode runs",
        `while it runs one can set ${about.tunable.join(", ") || "nothing of this program"}`);
  const all = Array.from({length: numbers}, (_, i) => values.length === 1 ? values[0] : values[i]);
  const outside = all.find((value, i) => value < statesLow[first + i] || value > statesHigh[first + i]);
  if (outside !== undefined) throw refuse(`${outside} is out of its space`);
  return {first, values: all, step: at === undefined ? null : BigInt(at)};
}

async function load(path) {
  let bytes;
  try {
    bytes = fs.readFileSync(path);
  } catch (problem) {
    throw new Failure(kBadFile, `cannot read \`${path}\`: ${problem.code}`);
  }
  try {
    return await Simulation.of(bytes);
  } catch (problem) {
    throw new Failure(problem instanceof WebAssembly.CompileError ? kBadFile : kSelfTestFailed, problem.message);
  }
}

/** Agent of the run. */
function agentOf(options, about) {
  const agent = options.agent || about.agent;
  if (agent === "csv")
    throw new Failure(
        kBadUsage, "the agent of the graph is a file of actions, which is for Linux",
        "give `--agent zero` or `random`");
  if (agent === "policy" && !about.policy)
    throw new Failure(kBadUsage, "this program has no policy", "give `--agent zero` or `random`");
  return agent;
}

async function main(words) {
  const [path, ...rest] = words;
  if (path === undefined || path === "--help") {
    process.stdout.write(`usage: node run.js MODULE.wasm [OPTION...]\n${kHelp}`);
    return path ? kDone : kBadUsage;
  }
  const options = parse(rest);
  if (options.help) {
    process.stdout.write(kHelp);
    return kDone;
  }
  const simulation = await load(path), {about} = simulation;
  const agent = agentOf(options, about), steps = options.steps ?? BigInt(about.steps);
  const sets = options.sets.map((text) => settingOf(text, simulation));
  simulation.begin(options.seed, {environment: Number(options.environment)});
  const began = process.hrtime.bigint();
  const done = simulation.episodes(agent, options.episodes, steps, sets);
  const seconds = Number(process.hrtime.bigint() - began) * 1e-9;
  const lines = options.hash ? [] : [
    `graph ${about.graph}`, `engine ${about.engine}`, "target wasm", `agent ${agent}`, `seed ${options.seed}`,
    `episodes ${options.episodes}`, `steps ${done}`,
    ...Object.entries(simulation.counts).map(([name, count]) => `${name} ${count}`)
  ];
  if (options.time) lines.push(`steps per second ${Math.round(Number(done) / seconds)}`);
  process.stdout.write([...lines, `trace hash ${simulation.hash}`, ""].join("\n"));
  const broken = Object.entries(simulation.counts).filter(([name]) => name.startsWith("not finite: "));
  for (const [name, count] of broken) process.stderr.write(`error: ${name} in ${count} of ${done} steps\n`);
  return broken.length ? kProblem : kDone;
}

main(process.argv.slice(2))
    .then(
        (code) => {
          process.exitCode = code;
        },
        (problem) => {
          process.stderr.write(`error: ${problem.message}\n${problem.help ? `help: ${problem.help}\n` : ""}`);
          process.exitCode = problem.code ?? 1;
        });
