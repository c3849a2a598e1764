#!/usr/bin/env node
// Modules of WebAssembly that eagerx-gen has not made, as simulation.js and the page get them: node
// tests/wasm/hostile.js Each is refused with an error that says why; none changes anything but itself. Needs no
// Emscripten: the modules are written here, byte by byte.
"use strict";
const path = require("path");
const root = path.resolve(__dirname, "../..");
const {Simulation} = require(path.join(root, "targets/wasm/simulation.js"));

// ---- Modules --------------------------------------------------------------------------------------------------------
const I32 = 0x7f, I64 = 0x7e;
function number(value) {  // LEB128 without a sign
  const bytes = [];
  do {
    bytes.push((value & 0x7f) | (value > 0x7f ? 0x80 : 0));
    value = Math.floor(value / 128);
  } while (value > 0);
  return bytes;
}
function signed(value) {
  const bytes = [];
  for (;;) {
    const byte = value & 0x7f;
    value >>= 7;
    if ((value === 0 && !(byte & 0x40)) || (value === -1 && byte & 0x40)) return [...bytes, byte];
    bytes.push(byte | 0x80);
  }
}
const text = (words) => [...number(Buffer.byteLength(words)), ...Buffer.from(words)];
const list = (items) => [...number(items.length), ...items.flat()];
const section = (id, content) => [id, ...number(content.length), ...content];
const i32 = (value) => [0x41, ...signed(value)];
const kTrap = [0x00];

const kAbout = {
  graph: "g",
  engine: "e",
  rate: [30, 1],
  agent: "zero",
  policy: false,
  steps: 5,
  render: false,
  actions: [{name: "u", dtype: "float32", first: 0, numbers: 2, messages: 1}],
  states: [],
  tunable: [],
  messages: [
    {name: "a/</script><script>alert(1)</script>", dtype: "float32", first: 0, numbers: 1},
    {name: "__proto__", dtype: "float32", first: 1, numbers: 2}
  ],
  outcome: []
};
const kTypes = {
  value: [[], [I32]],
  hash: [[], [I64]],
  begin: [[I64, I32, I32], []],
  pair: [[I32, I32], [I32]]
};
const kSignatures = {
  begin: "begin",
  hash: "hash",
  step: "pair",
  picture: "pair"
};
const kTextAt = 1024, kRowAt = 32768;
const kNames = [
  "check", "describe", "begin", "reset", "tune", "step", "ended", "hash", "picture", "counts", "actions", "actions_low",
  "actions_high", "settings", "states", "states_low", "states_high", "messages", "outcome"
];

/** A module as eagerx-gen makes them, but for `change`: {bodies, about, data, without, pages, imports, memory}. */
function moduleOf(change = {}) {
  const about = change.data || Buffer.from(`${JSON.stringify({...kAbout, ...change.about})}\0`);
  const bodies = {
    check: i32(0),
    describe: i32(kTextAt),
    begin: [],
    reset: i32(1),
    step: i32(1),
    ended: i32(0),
    hash: [0x42, 0x2a],
    picture: i32(0),
    counts: i32(kTextAt),
    ...change.bodies
  };
  const types = Object.keys(kTypes), imports = change.imports || [];
  const code = kNames.map((name) => {
    const body = [0x00, ...(bodies[name] || i32(kRowAt)), 0x0b];
    return [...number(body.length), ...body];
  });
  const exported = kNames.filter((name) => name !== change.without)
                       .map((name) => [...text(`eagerx_${name}`), 0, ...number(imports.length + kNames.indexOf(name))]);
  if (change.memory !== false) exported.push([...text("memory"), 2, 0]);
  return Uint8Array.from([
    0x00, 0x61, 0x73, 0x6d, 1, 0, 0, 0,
    ...section(1, list(Object.values(kTypes).map(([from, to]) => [0x60, ...list(from), ...list(to)]))),
    ...section(2, list(imports.map(([from, name]) => [...text(from), ...text(name), 0, 0]))),
    ...section(3, list(kNames.map((name) => number(types.indexOf(kSignatures[name] || "value"))))),
    ...section(5, list([[0, ...number(change.pages || 1)]])), ...section(7, list(exported)), ...section(10, list(code)),
    ...section(11, list([[0, ...i32(kTextAt), 0x0b, ...number(about.length), ...about]]))
  ]);
}

// ---- Checks ---------------------------------------------------------------------------------------------------------
let checks = 0, failures = 0;
function expect(good, what) {
  ++checks;
  if (good) return;
  ++failures;
  console.log(`FAILED: ${what}`);
}

async function refuse(what, bytes, why) {
  try {
    await Simulation.of(bytes);
    expect(false, `${what}: it is taken`);
  } catch (problem) {
    expect(problem instanceof Error && why.test(problem.message), `${what}: ${problem.message}`);
  }
}

async function main() {
  const simulation = await Simulation.of(moduleOf());
  simulation.begin(1);
  expect(
      simulation.reset() && simulation.step("zero") === 1 && simulation.hash === "0x000000000000002a",
      "a right module runs");
  expect(simulation.messages.length === 3 && simulation.actions.length === 2, "its rows have their lengths");

  const none = /module that eagerx-gen has made: /;
  const right = moduleOf();
  await refuse("nothing", new Uint8Array(), /./);
  await refuse("a page", Buffer.from("<!doctype html><script>alert(1)</script>"), /./);
  for (let end = 1; end < right.length; end += 37) await refuse(`the first ${end} bytes`, right.slice(0, end), /./);
  for (const name of kNames)
    await refuse(`without ${name}`, moduleOf({without: name}), new RegExp(`no function eagerx_${name}$`));
  await refuse("without memory", moduleOf({memory: false}), /it has no memory$/);
  await refuse("too much memory", moduleOf({pages: 70000}), /./);
  for (const from of ["__proto__", "constructor", "env"]) {
    await refuse(
        `imports of ${from}`, moduleOf({imports: [[from, "toString"], [from, "__proto__"]], without: "step"}), none);
    expect(
        ({}).toString() === "[object Object]" && Object.getPrototypeOf({}) === Object.prototype,
        `${from}: objects are as before`);
  }
  await refuse(
      "many imports", moduleOf({imports: Array.from({length: 1001}, (_, i) => ["env", `f${i}`])}),
      /imports 1001 functions/);
  for (const name of ["check", "describe", "messages"])
    await refuse(`a trap in ${name}`, moduleOf({bodies: {[name]: kTrap}}), /unreachable/);
  await refuse("no end of calls", moduleOf({bodies: {check: [0x10, 0x00]}}), /stack/);
  await refuse("another machine", moduleOf({bodies: {check: i32(1)}}), /denormal/);

  for (const at of [-1, 1 << 20]) await refuse(`a text at ${at}`, moduleOf({bodies: {describe: i32(at)}}), /./);
  await refuse("a text without an end", moduleOf({data: Buffer.alloc(65536 - kTextAt, "A")}), /does not end/);
  for (const said of ["", "{", "null", "[]", "1", "\"</script>\"", "\xff"])
    await refuse(`it says ${said}`, moduleOf({data: Buffer.from(`${said}\0`)}), none);
  const field = kAbout.actions[0];
  for (const about
           of [{graph: 1}, {agent: null}, {rate: [30]}, {rate: [0, 1]}, {rate: "30"}, {steps: -1}, {steps: "5"},
               {actions: null}, {states: {}}, {messages: [null]}, {messages: ["a"]},
               {actions: [{...field, numbers: 0}]}, {actions: [{...field, numbers: -2}]},
               {actions: [{...field, numbers: 1.5}]}, {actions: [{...field, numbers: 2 ** 53}]},
               {actions: [{...field, numbers: 1e9}]}, {actions: [{...field, first: 1}]},
               {actions: [{...field, name: {}}]}, {actions: [{...field, dtype: 5}]}])
    await refuse(`about ${JSON.stringify(about)}`, moduleOf({about}), none);
  for (const at of [-8, 4, 65536]) await refuse(`a row at ${at}`, moduleOf({bodies: {messages: i32(at)}}), /./);
  console.log(`${checks} checks, ${failures} failures`);
  process.exitCode = failures ? 1 : 0;
}

main().catch((problem) => {
  console.log(`FAILED: ${problem.stack}`);
  process.exitCode = 1;
});
