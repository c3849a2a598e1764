// The view that edits, in a browser without layout, with a server that only notes what it is asked: gestures and forms
// become edits, answers become what is shown.
import assert from "node:assert/strict";
import test from "node:test";

import {changedLines} from "../../templates/page/edit_changes.mjs";
import {EditClient} from "../../templates/page/edit_client.mjs";

import {become, passFrames} from "./dom.mjs";

const kEntities = [
  {
    id: "Motor",
    kind: "object",
    summary: "A motor.",
    description: "A slow one.",
    made_for: [{engine: "RealEngine"}, {engine: "OdeEngine"}],
    config: [{name: "gear", type: "float", default: 1, low: 0.1}],
    actuators: [{name: "u", dtype: "float32", shape: [1], unit: "V"}],
    sensors: [{name: "angle", dtype: "float32", shape: []}],
    states: [{name: "speed", dtype: "float32", shape: [], low: -1, high: 1, unit: "rad/s"}]
  },
  {
    id: "LowPassFilter",
    kind: "node",
    summary: "Smooths a signal.",
    config: [
      {name: "order", type: "int", default: 2, low: 1, high: 8, about: "its order"},
      {name: "cutoff_hz", type: "floats", unit: "Hz", low: 0.001},
      {name: "form", type: "choice", options: ["low", "high"], default: "low"}
    ],
    inputs: [{name: "signal", dtype: "float32"}],
    outputs: [{name: "y", dtype: "float32"}]
  },
  {id: "Wrap", kind: "processor", summary: "Wraps an angle.", config: [{name: "turn", type: "float", default: 6.28}]},
  {id: "OdeEngine", kind: "engine", config: [{name: "substeps", type: "int", default: 10}]}
];
const kSections = {
  top: [
    {name: "name", about: "its name", required: true, kind: "", values: []},
    {name: "task", about: "what is wanted", kind: "map", values: []},
    {name: "real", about: "the type", kind: "", values: [{text: "float"}, {text: "double"}]}
  ],
  agent: [{name: "policy", about: "weights", kind: "", values: []}],
  connections: [{name: "window", about: "how many", kind: "", values: []}]
};
const kState = {
  revision: 1,
  file: "graph.yaml",
  exists: true,
  text: "name: servo\n",
  good: false,
  problems: [],
  page: null,
  page_revision: null,
  layout: {},
  undo: null,
  redo: null,
  tree: {name: "servo", rate: "50"},
  running: null
};
const kNoRun = {
  id: 0,
  kind: "",
  running: false,
  exit_code: null,
  lines: [],
  next: 0,
  curve: null,
  result: false
};

/** Answers as the server does; `asked` are the bodies of POSTs. What waits for a change waits forever. */
function serverWith(state) {
  const server = {state: {...kState, ...state}, asked: [], read: [], refuse: null};
  server.ask = async (address, options = {}) => {
    const reply = (body, status = 200) => ({status, json: async () => structuredClone(body)});
    const name = address.replace("./", "").replace(/\?.*/, "");
    if (options.method !== "POST") {
      server.read.push(name);
      const answers = {library: {entities: kEntities}, schema: {sections: kSections}, run: kNoRun, state: server.state};
      return name === "changes" ? new Promise(() => {}) : reply(answers[name]);
    }
    const body = JSON.parse(options.body);
    server.asked.push([name, body]);
    if (name === "layout") return reply({});
    if (server.refuse) return reply(...server.refuse);
    server.state = {...server.state, revision: server.state.revision + 1, ...server.next};
    return reply(server.state);
  };
  return server;
}

let server = serverWith({});
const browser = become({served: true});
globalThis.fetch = (...words) => server.ask(...words);
await import("../../templates/page/edit_view.mjs");
const {views, moreViews} = await import("../../templates/page/views.mjs");
const {state: shownView} = await import("../../templates/page/selection.mjs");
const {editing, selectToEdit} = await import("../../templates/page/edit_store.mjs");
const {editSvg, editView, portPoint} = await import("../../templates/page/edit_drawing.mjs");
const {beginAdding, foundIn} = await import("../../templates/page/edit_library.mjs");
const {inspectPanel} = await import("../../templates/page/edit_inspector.mjs");
const {connectDialog} = await import("../../templates/page/edit_connect.mjs");
const {takeRun, wordsOf} = await import("../../templates/page/edit_runs.mjs");
const {curveOf} = await import("../../templates/page/edit_curve.mjs");
const {kindOfAgent} = await import("../../templates/page/edit_graph_form.mjs");
const {placeText} = await import("../../templates/page/edit_problems.mjs");

const panel = browser.document.createElement("section");
browser.body.append(panel);
const parts = moreViews.get("edit")(panel);
views.push({id: "edit", parts, panel});
shownView.view = views[0];

const settle = async () => {
  for (let i = 0; i < 20; ++i) await new Promise((done) => setImmediate(done));
  passFrames(browser.frames);
};

/** The page as of a state. */
async function show(state) {
  server = serverWith({...state, revision: editing.client.state ? editing.client.state.revision + 1 : 1});
  await settle();
  await editing.client.load();
  selectToEdit(null);
  await settle();
  server.asked.length = 0;
}
const edits = () => server.asked.filter(([name]) => name === "edit").flatMap(([, body]) => body.edits);
const fieldOf = (key, where = inspectPanel) =>
    where.querySelectorAll("div.field").find((row) => row.key === key) ?? assert.fail(`no field ${key}`);
function type(key, text, where = inspectPanel) {
  const {input} = fieldOf(key, where);
  input.value = text;
  input.send("input");
  input.send("change");
}
const press = (text, where = inspectPanel) =>
    where.querySelectorAll("button").find((one) => one.textContent === text).click();
const box = (name) => editing.model.boxes.findIndex((one) => one.name === name);

/** The place of the window over a place of the drawing. */
const at = ([x, y]) => ({clientX: x * editView.zoom + editView.x, clientY: y * editView.zoom + editView.y});
function drag(from, to) {
  const [begin, end] = [at(from), at(to)];
  editSvg.send("pointerdown", begin);
  editSvg.send("pointermove", {clientX: (begin.clientX + end.clientX) / 2, clientY: (begin.clientY + end.clientY) / 2});
  editSvg.send("pointermove", end);
  editSvg.send("pointerup", end);
}

const kServo = {
  name: "servo",
  rate: "50",
  engine: {type: "OdeEngine", rate: "50"},
  objects: {motor: {type: "Motor", config: {gear: "2"}}},
  nodes: {smooth: {type: "LowPassFilter", rate: "50", config: {cutoff_hz: "5"}}},
  actions: ["voltage"],
  observations: {angle: null},
  connections: [{from: "motor.angle", to: "observations.angle", window: "3"}]
};

test("an empty file has the two ends of the environment, and forms to begin with", async () => {
  await show({tree: null, text: "", exists: false});
  assert.deepEqual(editing.model.boxes.map(({name}) => name), ["actions", "observations"]);
  type("name", "my_robot");
  await settle();
  assert.deepEqual(edits(), [{kind: "set", path: ["name"], value: "my_robot"}]);
  type("name", "1 robot");
  await settle();
  assert.equal(edits().length, 1);
  assert.match(fieldOf("name").textContent, /a letter first/);
});

test("the form of a node comes from its manifest, and refuses what it refuses", async () => {
  await show({tree: kServo});
  beginAdding("LowPassFilter");
  const keys = inspectPanel.querySelectorAll("div.field").map((row) => row.key);
  assert.deepEqual(keys, ["name", "rate", "config.cutoff_hz", "config.order", "config.form"]);  // required first
  assert.equal(fieldOf("rate").input.value, "50");
  assert.equal(fieldOf("config.order").input.getAttribute("placeholder"), "2");
  assert.match(fieldOf("config.order").textContent, /int, 1 … 8.*its order/);
  const form = inspectPanel.querySelector("form");
  form.send("submit");
  await settle();
  assert.deepEqual(edits(), []);
  assert.match(fieldOf("config.cutoff_hz").textContent, /required/);
  type("config.cutoff_hz", "5, 10");
  type("config.order", "9");
  form.send("submit");
  await settle();
  assert.deepEqual(edits(), []);
  type("config.order", "3");
  type("config.form", "high");
  type("name", "smooth");
  form.send("submit");
  assert.match(fieldOf("name").textContent, /there is one/);
  type("name", "smooth_2");
  form.send("submit");
  await settle();
  assert.deepEqual(edits(), [{
                     kind: "add",
                     section: "nodes",
                     name: "smooth_2",
                     type: "LowPassFilter",
                     keys: {rate: "50"},
                     parameters: {cutoff_hz: "[5, 10]", order: "3", form: "high"}
                   }]);
});

test("the first object brings an engine", async () => {
  await show({tree: {name: "a", rate: "25"}});
  beginAdding("Motor");
  assert.equal(fieldOf("engine").input.value, "OdeEngine");
  inspectPanel.querySelector("form").send("submit");
  await settle();
  assert.deepEqual(edits().map((edit) => edit.value ?? edit.name), ["{type: OdeEngine, rate: 25}", "motor"]);
});

test("forms of what is selected set, remove and rename", async () => {
  await show({tree: kServo});
  selectToEdit({section: "nodes", name: "smooth"});
  type("config.order", "4");
  type("config.cutoff_hz", "");  // is required
  type("name", "filter");
  await settle();
  selectToEdit({section: "objects", name: "motor"});
  type("config.gear", "");
  type("states.speed", "uniform");
  await settle();
  assert.deepEqual(edits(), [
    {kind: "set", path: ["nodes", "smooth", "config", "order"], value: "4"},
    {kind: "rename", path: ["nodes", "smooth"], name: "filter"},
    {kind: "remove", path: ["objects", "motor", "config", "gear"]},
    {kind: "set", path: ["objects", "motor", "states", "speed"], value: "uniform"}
  ]);
});

test("settings of a connection, with a processor and its parameters", async () => {
  await show({tree: kServo});
  selectToEdit({from: "motor.angle", to: "observations.angle"});
  assert.equal(fieldOf("connections.0.window").input.value, "3");
  type("connections.0.window", "");
  type("processor", "Wrap");
  await settle();
  assert.deepEqual(edits(), [
    {kind: "remove", path: ["connections", 0, "window"]},
    {kind: "set", path: ["connections", 0, "processor"], value: "Wrap"}
  ]);
  const connections = [{...kServo.connections[0], processor: {type: "Wrap", config: {turn: "1"}}}];
  await show({tree: {...kServo, connections}});
  selectToEdit({from: "motor.angle", to: "observations.angle"});
  type("config.turn", "3.14");
  await settle();
  assert.deepEqual(
      edits(), [{kind: "set", path: ["connections", 0, "processor"], value: "{type: Wrap, config: {turn: 3.14}}"}]);
});

test("a wire from an output to an input asks for its settings and connects", async () => {
  await show({tree: kServo});
  drag(portPoint(box("smooth"), "outputs", 0), portPoint(box("motor"), "inputs", 0));
  assert.ok(connectDialog.open);
  type("window", "2", connectDialog);
  connectDialog.querySelector("form").send("submit");
  await settle();
  assert.ok(!connectDialog.open);
  assert.deepEqual(edits(), [{kind: "connect", from: "smooth.y", to: "motor.u", keys: {window: "2"}}]);
});

test("a wire to the observations makes one, also pulled from the input's side", async () => {
  await show({tree: kServo});
  const end = editing.places[box("observations")];
  drag(portPoint(box("smooth"), "outputs", 0), [end.x + 30, end.y + 8]);
  assert.equal(fieldOf("name", connectDialog).input.value, "y");
  type("name", "smoothed", connectDialog);
  connectDialog.querySelector("form").send("submit");
  await settle();
  const begin = editing.places[box("actions")];
  drag(portPoint(box("smooth"), "inputs", 0), [begin.x + 30, begin.y + 8]);
  type("name", "raw", connectDialog);
  type("like", "motor.u", connectDialog);
  connectDialog.querySelector("form").send("submit");
  await settle();
  assert.deepEqual(edits(), [
    {kind: "add", section: "observations", name: "smoothed"},
    {kind: "connect", from: "smooth.y", to: "observations.smoothed", keys: {}},
    {kind: "add", section: "actions", name: "raw", keys: {space: "{like: motor.u}"}},
    {kind: "connect", from: "actions.raw", to: "smooth.signal", keys: {}}
  ]);
});

test("a wire that is let go over nothing is not a connection", async () => {
  await show({tree: kServo});
  drag(portPoint(box("smooth"), "outputs", 0), [-4000, -4000]);
  assert.ok(!connectDialog.open);
  assert.ok(!editSvg.querySelectorAll("g.port").some((port) => port.classList.contains("fits")));
});

test("a box that is moved keeps its place, and so do all others", async () => {
  await show({tree: kServo});
  const {x, y} = editing.places[box("motor")];
  drag([x + 40, y + 10], [x + 90, y + 60]);
  await settle();
  const [[name, body]] = server.asked;
  assert.equal(name, "layout");
  assert.deepEqual(body.places.motor, [x + 50, y + 50]);
  assert.equal(Object.keys(body.places).length, editing.model.boxes.length);
});

test("keys: from box to box, Delete, undo", async () => {
  await show({tree: kServo, undo: "Add `motor`"});
  const key = (name, more = {}) => editSvg.send("keydown", {key: name, stopPropagation() {}, ...more});
  key("ArrowRight");
  assert.notEqual(editing.selected, null);
  selectToEdit({section: "nodes", name: "smooth"});
  key("Delete");
  await settle();
  assert.deepEqual(edits(), [{kind: "remove", path: ["nodes", "smooth"]}]);
  browser.document.send("keydown", {key: "z", ctrlKey: true, target: browser.body});
  browser.document.send("keydown", {key: "Z", ctrlKey: true, shiftKey: true, target: browser.body});
  await settle();
  assert.deepEqual(server.asked.slice(-2).map(([name]) => name), ["undo", "redo"]);
  selectToEdit({section: "actions", name: "actions"});
  key("Delete");  // an end of the environment stays
  await settle();
  assert.equal(edits().length, 1);
});

test("problems mark their box and offer their help", async () => {
  const problem = {
    code: "E0307",
    severity: "error",
    message: "<b>no</b> `x`",
    help: "did you mean `y`?",
    notes: ["it is here"],
    line: 3,
    column: 1,
    path: ["nodes", "smooth", "rate"],
    file: "",
    fix: "Change to `y`"
  };
  await show({tree: kServo, problems: [problem]});
  assert.ok(editView.boxElements[box("smooth")].classList.contains("faulty"));
  const list = panel.querySelector("ul.problems");
  assert.match(list.textContent, /error E0307: <b>no<\/b> `x`.*nodes › smooth › rate, line 3/);
  press("Change to `y`", list);
  await settle();
  assert.deepEqual(edits(), [{kind: "fix", problem: 0}]);
  assert.equal(placeText(["connections", 0, "from"]), "connections › 1. › from");
});

test("the page shows what the server refuses, and the state of the disk is taken over", async () => {
  await show({tree: kServo});
  const newest = {...server.state, revision: 99, tree: {name: "other"}, text: "name: other\n"};
  server.refuse = [{error: "the file was changed on the disk", help: "look at it", state: newest}, 409];
  selectToEdit({section: "nodes", name: "smooth"});
  type("config.order", "4");
  await settle();
  assert.equal(editing.client.state.revision, 99);
  assert.equal(editing.selected, null);  // there is no `smooth` any more
  assert.match(panel.querySelector("p.notice").textContent, /changed on the disk: look at it/);
});

test("selecting something else while an edit is on its way is not undone by its answer", async () => {
  await show({tree: kServo});
  selectToEdit({section: "nodes", name: "smooth"});
  type("name", "filter");
  beginAdding("Motor");
  await settle();
  assert.deepEqual(editing.selected, {adding: "Motor", place: null});
});

test("the file's lines that the last change touched are marked", async () => {
  const lines = changedLines("a\nb\nc\nd\n", "a\nx\nc\nd\ne\n");
  assert.deepEqual([[...lines.changed], [...lines.removed]], [[1, 4], []]);
  assert.deepEqual([...changedLines("a\nb\nc", "a\nc").removed], [1]);
  assert.deepEqual([...changedLines("a\r\nb", "a\nb").changed], []);
  await show({tree: kServo, text: "name: servo\nrate: 50\n"});
  server.next = {text: "name: servo\nrate: 60\n"};
  await editing.client.edit([]);
  assert.deepEqual(panel.querySelectorAll("div.line").map((line) => line.classList.contains("changed")), [false, true]);
});

test("the library is searched by words", () => {
  const library = new Map(kEntities.map((entity) => [entity.id, entity]));
  const found = (text) => foundIn(library, text).flatMap(([, entities]) => entities.map(({id}) => id));
  assert.deepEqual(found(""), ["Motor", "LowPassFilter"]);
  assert.deepEqual(found("low pass"), ["LowPassFilter"]);
  assert.deepEqual(found("smooths"), ["LowPassFilter"]);
  assert.deepEqual(found("low"), ["LowPassFilter", "Motor"]);  // ids before texts, whatever the kind
  assert.deepEqual(found("xyz"), []);
});

test("the library is asked for again when the file names other folders", async () => {
  await show({tree: kServo});
  server.next = {tree: {...kServo, library: ["mine"]}};
  await editing.client.edit([]);
  await settle();
  assert.ok(server.read.includes("library"));
  server.read.length = 0;
  await editing.client.edit([]);
  await settle();
  assert.ok(!server.read.includes("library"));
});

test("agents, words of a command line, output of programs, curves", () => {
  assert.deepEqual([undefined, "zero", {policy: "a"}, {csv: "a"}].map(kindOfAgent), ["", "zero", "policy", "csv"]);
  assert.deepEqual(wordsOf("--steps 300  --name \"a b\" 'c d'"), ["--steps", "300", "--name", "a b", "c d"]);
  const known = {id: 1, next: 5, row: 2, lines: [{text: "old"}], columns: [], rows: [[1]]};
  const answer =
      {id: 2, kind: "train", running: true, exit_code: null, next: 1, result: false, lines: [{n: 0, text: "new"}]};
  assert.ok(takeRun(known, {...answer, next: 9, lines: []}));  // lines before the fifth were not sent
  assert.deepEqual([known.id, known.next, known.lines.length], [2, 0, 0]);
  assert.ok(takeRun(known, {...answer, curve: {columns: ["steps", "return"], rows: [[10, 1]], next: 1}}));
  assert.deepEqual([known.lines.length, known.rows, known.row], [1, [[10, 1]], 1]);
  assert.ok(!takeRun(known, {...answer, lines: [], curve: {columns: ["steps", "return"], rows: [], next: 1}}));
  assert.deepEqual(curveOf(["steps", "return"], [[10, 1], [20, ""]], ["return"]), [[10, 1]]);
  assert.deepEqual(curveOf(["a", "b"], [[1, 2]], ["return"]), []);
});

test("the client asks one thing after the other, and takes over what changed on the disk", async () => {
  const notes = [], asked = [];
  let revision = 1, on_disk = 1;
  const client = new EditClient((why) => notes.push(why), async (address, options) => {
    asked.push(address);
    if (address.startsWith("./changes")) return {status: 200, json: async () => ({revision: on_disk})};
    if (options?.method === "POST") on_disk = ++revision;
    return {status: 200, json: async () => ({...kState, revision: on_disk})};
  });
  await client.load();
  await Promise.all([client.edit([]), client.edit([])]);
  assert.equal(client.state.revision, 3);
  assert.ok(await client.follow());
  assert.ok(!asked.slice(3).includes("./state"));  // its own edits are no news
  on_disk = 7;
  assert.ok(await client.follow());
  assert.equal(client.state.revision, 7);
  assert.match(notes.at(-1), /changed on the disk/);
  client.ask = async () => {
    throw new Error("connection refused");
  };
  assert.ok(!await client.follow());
  assert.match(notes.at(-1), /does not run any more/);
  assert.match(await client.edit([]), /does not run any more/);
});
