// The tab of a loop on a page that is served: the port and the sliders become options of `linearize`, one run after the
// other, and what the server wrote is shown.
import assert from "node:assert/strict";
import test from "node:test";

import {become, passFrames} from "./dom.mjs";

const space = (text, numbers) => ({text, numbers, bytes: 4 * numbers, low: [], high: []});
const output = (name, text, numbers, sensor = "") => ({name, sensor, space: space(text, numbers), unit: ""});
const node = (name, role, outputs) => ({name, role, rate: "100", inputs: [], outputs, order: 0, parameters: []});
const kNodes = [
  node("environment", "environment", [output("push", "float32", 1)]),
  node("engine", "engine", [output("tick", "uint64", 1)]),
  node("motor/angle", "engine node", [output("observation", "float32[2]", 2, "motor.angle, motor.same")]),
  node("motor/input", "engine node", [output("unread", "float32", 1)]),
  node("controller", "node", [output("u", "float32", 1), output("count", "uint32", 1)])
];
const kLoop = {
  bode: [[0.1, 20, -90, 0, -10], [1, 0, -120, -0.5, -0.87], [10, -20, -200, -0.09, 0.03]],
  open_poles: [[0.9, 0]],
  closed_poles: [[0.8, 0.1], [0.8, -0.1]],
  step: [[0, 0, 1], [0.01, 0.5, 0.5], [0.02, 1, 0]],
  margins: {
    ...{port: "controller.u", message_s: 0.01, stable: true, spectral_radius: 0.81, integrators: 0, gain: 4},
    ...{gain_frequency_hz: 5, least_gain: null, least_gain_frequency_hz: null, phase_deg: 60, crossover_hz: 1},
    ...{delay_s: 0.1, delay_frequency_hz: 1, stable_messages: 9, tried_messages: 9, sensitivity: 1.4},
    ...{
      sensitivity_hz: 3, other_frequencies: 0, ages: []
    }
  },
  parameters: [
    {name: "controller.kp", values: [2], low: [0], high: [null]},
    {name: "motor.gains", values: [1, 5], low: [0, 0], high: [10, 10]}
  ]
};

const page = {
  served: true,
  ...{info: {name: "servo", engine: "OdeEngine", ages: []}, nodes: kNodes, objects: [], composites: [], rings: []},
  ...{channels: [], policies: [], source: {name: "", lines: []}, diagnostics: [], images: [], logs: [], shows: ""},
  ...{
    agent: "zero", schedule: {order: [], quantum: {seconds: 1}, hyperperiod: null, rates: []}
  }
};

/** Runs end at once, or when `end()` is called. */
const server = {
  asked: [],
  id: 0,
  exit_code: 0,
  lines: [],
  refuse: null,
  waits: false,
  end: () => {}
};
server.ask = async (address, options = {}) => {
  const reply = (body, status = 200) => ({status, json: async () => structuredClone(body)});
  const name = address.replace("./", "").replace(/\?.*/, "");
  if (options.method === "POST") {
    if (server.refuse) return reply(server.refuse, 409);
    server.asked.push(JSON.parse(options.body));
    return reply({id: ++server.id});
  }
  if (name === "loop") return reply(kLoop);
  assert.equal(name, "run");
  if (server.waits) await new Promise((done) => (server.end = done));
  const {id, exit_code, lines} = server;
  const facts = {id, kind: "linearize", running: false, exit_code, curve: null, result: false};
  const after = Number(/after=(\d+)/.exec(address)[1]);
  return reply({...facts, lines: lines.slice(after), next: lines.length});
};

const browser = become(page);
globalThis.fetch = (...words) => server.ask(...words);
await import("../../templates/page/edit_loop.mjs");
const {moreViews} = await import("../../templates/page/views.mjs");
const {run} = await import("../../templates/page/edit_runs.mjs");
const panel = browser.document.createElement("section");
browser.body.append(panel);
moreViews.get("loop")(panel);

const settle = async () => {
  for (let i = 0; i < 30; ++i) await new Promise((done) => setImmediate(done));
  passFrames(browser.frames);
};
const sliders = () => panel.querySelectorAll("input").filter((input) => input.type === "range");
function choose(port) {
  const ports = panel.querySelector("select");
  ports.value = port;
  ports.send("change");
}
function move(slider, value) {
  slider.value = value;
  slider.send("input");
}
const settled = () => new Promise((done) => setTimeout(done, 200)).then(settle);

test("ports of a loop are single numbers that nodes and sensors send", () => {
  const ports = panel.querySelectorAll("option").map((option) => option.value);
  assert.deepEqual(ports, ["", "motor.angle[0]", "motor.angle[1]", "controller.u"]);
});

test("a port is linearized, and sliders of its parameters appear", async () => {
  choose("controller.u");
  await settle();
  assert.deepEqual(server.asked, [{kind: "linearize", arguments: ["--open", "controller.u"]}]);
  const text = panel.textContent;
  assert.match(text, /The loop opened at controller.u/);
  assert.match(text, /phase margin60°/);
  assert.match(text, /motor.gains\[1\]/);
  assert.doesNotMatch(text, /undefined|\bNaN\b|\[object|\bnull\b/);
  assert.equal(sliders().length, 3);
  const [first, second] = sliders();
  assert.deepEqual([first.min, first.max], [0, 6], "around the value, as it has no bound");
  assert.deepEqual([second.getAttribute("max"), second.value], ["10", 1]);
});

test("a slider that moves sets all numbers of its parameter; the last of several moves counts", async () => {
  server.asked.length = 0;
  const [kp, , gain] = sliders();
  move(gain, "7");
  move(kp, "3");
  move(kp, "4");
  await settled();
  assert.deepEqual(
      server.asked.map((body) => body.arguments),
      [["--open", "controller.u", "--at", "motor.gains=1,7", "--at", "controller.kp=4"]]);
  assert.equal(sliders()[0], kp, "they stay");
  server.asked.length = 0;
  server.waits = true;
  move(kp, "5");
  await settled();
  move(kp, "5.5");
  await settled();
  move(kp, "6");
  await settled();
  assert.equal(server.asked.length, 1, "one run at a time");
  server.waits = false;
  server.end();
  await settled();
  assert.deepEqual(server.asked.map((body) => body.arguments.at(-1)), ["controller.kp=5", "controller.kp=6"]);
  panel.querySelectorAll("button").find((one) => one.textContent === "As in the graph").click();
  await settled();
  assert.deepEqual(server.asked.at(-1).arguments, ["--open", "controller.u"]);
});

test("what linearize or the server says is shown", async () => {
  Object.assign(server, {exit_code: 1, lines: [{n: 0, text: "error[E0520]: no <b>derivative</b>", error: true}]});
  choose("motor.angle[0]");
  await settled();
  assert.equal(panel.querySelector("pre").textContent, "error[E0520]: no <b>derivative</b>");
  server.refuse = {error: "`train` runs already", help: "stop it first"};
  choose("controller.u");
  await settled();
  assert.match(panel.textContent, /`train` runs already: stop it first/);
  server.refuse = null;
  globalThis.fetch = async () => {
    throw new Error("gone");
  };
  choose("controller.u");
  await settled();
  assert.match(panel.textContent, /`eagerx-gen serve` does not run any more/);
  assert.equal(run.running, false);
});
