// Computations of the editing page: values as text, ports that fit, places, the element under the pointer, edits.
import assert from "node:assert/strict";
import test from "node:test";

import {columnLayout} from "../../templates/page/edit_columns.mjs";
import {freePlace, hitAt, placedBoxes, targetAt} from "../../templates/page/edit_layout.mjs";
import {drawnAs, endOf, modelOf} from "../../templates/page/edit_model.mjs";
import {connectEdits, connectionKeys, endNameFor, fitOf, partnersOf} from "../../templates/page/edit_ports.mjs";
import {wireRoutes} from "../../templates/page/edit_routes.mjs";
import {portPlace, sizeOf} from "../../templates/page/edit_sizes.mjs";
import {
  faultOf,
  flowText,
  freeName,
  limitsOf,
  nameOfType,
  parameterText,
  yamlText
} from "../../templates/page/edit_values.mjs";

const kLibrary = new Map([
  {
    id: "Motor",
    kind: "object",
    summary: "A motor.",
    actuators: [{name: "u", dtype: "float32", shape: [1], unit: "V"}],
    sensors: [{name: "angle", dtype: "float32", shape: []}, {name: "pose", dtype: "float32", shape: [7]}]
  },
  {
    id: "Filter",
    kind: "node",
    inputs: [{name: "signal", dtype: "float32"}],
    outputs: [{name: "y", dtype: "float32", like: "signal"}]
  },
  {
    id: "Bring",
    kind: "reset node",
    inputs: [{name: "angle", dtype: "float32", shape: []}],
    outputs: [{name: "u", dtype: "float32", shape: [1]}],
    targets: [{name: "goal", dtype: "float32", shape: [2]}]
  },
].map((entity) => [entity.id, entity]));

const kTree = {
  name: "servo",
  actions: {voltage: {space: {dtype: "float32", shape: ["1"]}}},
  observations: ["angle"],
  objects: {motor: {type: "Motor"}},
  nodes: {smooth: {type: "Filter", rate: "30"}, strange: {type: "Unknown"}},
  connections: [
    {from: "actions.voltage", to: "smooth.signal"}, {from: "smooth.y", to: "motor.u"},
    {from: "motor.angle", to: "observations.angle"}, {from: "motor.pose", to: "strange.x"},
    {from: "nowhere.y", to: "motor.u"}
  ]
};
const modelHere = () => modelOf(kTree, kLibrary);
const boxCalled = (model, name) => model.boxes.find((box) => box.name === name);

test("texts become scalars of YAML that are texts again", () => {
  for (const [text, written] of [
           ["lowpass", "lowpass"], ["swing_up.onnx", "swing_up.onnx"], ["a/b.csv", "a/b.csv"], ["true", "\"true\""],
           ["12", "\"12\""], ["1e3", "\"1e3\""], ["a: b", "\"a: b\""], ["a, b", "\"a, b\""], ["# no", "\"# no\""],
           ["", "\"\""], ["say \"x\"", "\"say \\\"x\\\"\""], ["two words", "two words"], ["- x", "\"- x\""]])
    assert.equal(yamlText(text), written, text);
});

test("values of the file are shown on one line", () => {
  assert.equal(flowText(["1", "2.5"]), "[1, 2.5]");
  assert.equal(flowText({value: ["0.0", "1"], space: {low: "-1"}}), "{value: [0.0, 1], space: {low: -1}}");
  assert.equal(flowText({like: "pendulum.u"}), "{like: pendulum.u}");
  assert.equal(flowText({model_state: null}), "{model_state:}");
  assert.equal(flowText("a: b"), "\"a: b\"");
  assert.equal(flowText(undefined), "");
});

test("names come from types and are free", () => {
  assert.equal(nameOfType("ButterworthFilter"), "butterworth_filter");
  assert.equal(nameOfType("LookupTable2d"), "lookup_table2d");
  assert.equal(freeName("a", new Set(["a", "a_2"])), "a_3");
});

test("a value is compared with its manifest", () => {
  const order = {type: "int", low: 1, high: 8}, corner = {type: "floats", unit: "Hz", low: 1e-6, required: true};
  for (const [parameter, text, fault] of [
           [order, "2", ""], [order, "9", "at most 8"], [order, "0", "at least 1"],
           [order, "2.5", "whole numbers only"], [order, "two", "a number"], [order, "", ""],
           [order, "{each: [1, 2]}", ""], [order, "$(index)", ""], [corner, "", "required"], [corner, "12", ""],
           [corner, "1, 12", ""], [corner, "[1, 12]", ""], [corner, "0.5 kHz", ""], [corner, "-1", "at least 0.000001"],
           [{type: "float"}, "1/3", ""], [{type: "bool"}, "yes", "true or false"],
           [{type: "choice", options: ["a", "b"]}, "c", "one of a, b"], [{type: "string"}, "anything: at all", ""]])
    assert.equal(faultOf(parameter, text), fault, `${parameter.type} ${text}`);
  assert.equal(parameterText(corner, "1, 12"), "[1, 12]");
  assert.equal(parameterText({type: "string"}, "true"), "\"true\"");
  assert.equal(limitsOf(order), "int, 1 … 8");
  assert.equal(limitsOf({type: "float", unit: "s", low: 0}), "float, at least 0 s");
});

test("ends of connections, with arrays and what is in composites", () => {
  assert.deepEqual(endOf("leg[i + 1].x"), {entity: "leg", port: "x"});
  assert.deepEqual(endOf("robot.position[*]"), {entity: "robot", port: "position"});
  assert.deepEqual(endOf("arm/position.u"), {entity: "arm/position", port: "u"});
  assert.deepEqual(endOf("leg[2]/knee.u"), {entity: "leg/knee", port: "u"});
  assert.deepEqual(endOf("pendulum.states.model_state"), {entity: "pendulum", port: "states.model_state"});
  assert.equal(endOf("pendulum"), null);
  assert.equal(endOf(undefined), null);
});

test("boxes have the ports of the library, and those that connections name", () => {
  const model = modelHere();
  assert.deepEqual(
      model.boxes.map(({name, kind}) => `${name} ${kind}`),
      ["actions end", "motor object", "smooth node", "strange node", "observations end"]);
  assert.equal(model.wires.length, 4);  // what comes from nowhere is a problem of the file, not a wire
  const strange = boxCalled(model, "strange");
  assert.deepEqual(strange.inputs.map(({name, unsaid}) => [name, unsaid]), [["x", true]]);
  assert.equal(boxCalled(model, "motor").inputs[0].taken, true);
  assert.equal(boxCalled(model, "smooth").subtitle, "Filter · 30 Hz");
  assert.deepEqual(drawnAs(model, ["nodes", "smooth", "config", "order"]), {box: 2});
  assert.deepEqual(drawnAs(model, ["connections", 3, "from"]), {wire: 3});
  assert.equal(drawnAs(model, ["connections", 4]), null);
  assert.deepEqual(drawnAs(model, ["observations", "angle"]), {box: 4});
});

test("of a reset node, goals and feedthroughs are ports", () => {
  const model = modelOf({nodes: {bring: {type: "Bring"}}}, kLibrary);
  assert.deepEqual(
      boxCalled(model, "bring").inputs.map(({address}) => address),
      ["bring.angle", "bring.targets.goal", "bring.feedthroughs.u"]);
});

test("any file makes a model: empty, half written, of another form", () => {
  for (const tree
           of [null, undefined, "x", [], {}, {nodes: null}, {nodes: []}, {nodes: {a: null, b: "x", c: ["y"]}},
               {connections: {from: "a.b"}}, {connections: ["a", null, {from: null}]}, {actions: "x"},
               {objects: {a: {type: {b: "c"}}}}]) {
    const model = modelOf(tree, kLibrary);
    assert.ok(model.boxes.length >= 2, JSON.stringify(tree));
    assert.equal(placedBoxes(model, {}).length, model.boxes.length);
  }
});

test("ports fit by dtype and shape", () => {
  const scalar = {dtype: "float32", shape: []}, vector = {dtype: "float32", shape: [3]};
  assert.equal(fitOf(scalar, scalar), 2);
  assert.equal(fitOf(scalar, vector), 0);
  assert.equal(fitOf(scalar, {dtype: "int64", shape: []}), 0);
  assert.equal(fitOf(scalar, {dtype: "float32"}), 1);
  assert.equal(fitOf({}, vector), 1);
  assert.equal(fitOf(vector, {dtype: "float32", shape: ["$(config size)"]}), 1);
  assert.equal(fitOf({dtype: "float32", shape: ["3"]}, vector), 2);
});

test("what fits and is free comes first", () => {
  const model = modelOf({...kTree, connections: []}, kLibrary);
  const found = partnersOf(model, boxCalled(model, "motor").outputs[0], "inputs").map(({port}) => port.address);
  assert.equal(found[0], "smooth.signal");
  assert.ok(found.includes("motor.u"));
  assert.equal(partnersOf(modelHere(), {address: "a.b"}, "inputs").at(-1).port.taken, true);
});

test("connecting an input that has a sender replaces it", () => {
  assert.deepEqual(connectEdits(modelHere(), "actions.voltage", "motor.u", {}), [
    {kind: "remove", path: ["connections", 1]}, {kind: "connect", from: "actions.voltage", to: "motor.u", keys: {}}
  ]);
});

test("settings of a connection are those that say something", () => {
  assert.deepEqual(connectionKeys({window: "1", delay: "0", skip: false, processor: ""}), {});
  assert.deepEqual(
      connectionKeys({window: "3", delay: "0.01", skip: true, processor: "GetIndex", parameters: {index: "1"}}),
      {window: "3", delay: "0.01", skip: "true", processor: "{type: GetIndex, config: {index: 1}}"});
});

test("a new end is called as its port, with a name that is free", () => {
  const model = modelHere();
  assert.equal(endNameFor(model, "observations", {name: "pose"}), "pose");
  assert.equal(endNameFor(model, "observations", {name: "angle"}), "angle_2");
  assert.equal(endNameFor(model, "observations", {name: "states.model_state"}), "model_state");
});

test("boxes lie apart, columns follow the messages, and chosen places stay", () => {
  const model = modelHere(), places = columnLayout(model).places;
  assert.ok(places.actions[0] < places.smooth[0] && places.smooth[0] < places.motor[0]);
  assert.ok(places.motor[0] < places.observations[0] && places.strange[0] < places.observations[0]);
  for (const chosen of [{}, {motor: [300, 10]}, {smooth: places.motor, strange: [5, 5]}]) {
    const boxes = placedBoxes(model, chosen);
    boxes.forEach((a, i) => boxes.slice(0, i).forEach((b) => {
      assert.ok(
          a.x >= b.x + b.width || b.x >= a.x + a.width || a.y >= b.y + b.height || b.y >= a.y + a.height,
          JSON.stringify([chosen, a, b]));
    }));
    for (const [name, place] of Object.entries(chosen)) {
      const {x, y} = boxes[model.boxes.indexOf(boxCalled(model, name))];
      assert.deepEqual([x, y], place);
    }
  }
  const box = {x: 0, y: 0, width: 10, height: 10};
  assert.ok(freePlace(box, [box]).y > 10);
});

test("wires that pass a column go past its boxes, and those that return go below", () => {
  const model = modelOf(
      {
        nodes: {a: {type: "Filter"}, b: {type: "Filter"}},
        actions: ["u"],
        observations: ["far", "near"],
        connections: [
          {from: "actions.u", to: "a.signal"}, {from: "a.y", to: "b.signal"}, {from: "b.y", to: "observations.near"},
          {from: "actions.u", to: "observations.far"}, {from: "b.y", to: "a.signal", skip: "true"}
        ]
      },
      kLibrary);
  const {lanes} = columnLayout(model), places = placedBoxes(model, {});
  assert.deepEqual(lanes.map((points) => points.length), [0, 0, 0, 2, 0]);
  for (const [left, right, y] of lanes[3])
    for (const place of places)
      assert.ok(place.x >= right || place.x + place.width <= left || y <= place.y || y >= place.y + place.height);
  const routes = wireRoutes(model, places, true);
  assert.ok(routes.every((d) => /^M[-\d. ]+[CL]/.test(d) && !/NaN|undefined/.test(d)));
  const lowest = Math.max(...routes[4].match(/-?[\d.]+/g).map(Number).filter((_, i) => i % 2));
  assert.ok(lowest > Math.max(...places.slice(1, 3).map(({y, height}) => y + height)));
});

test("a circle of connections has columns", () => {
  const loop = modelOf(
      {
        nodes: {a: {type: "Filter"}, b: {type: "Filter"}},
        connections: [{from: "a.y", to: "b.signal"}, {from: "b.y", to: "a.signal"}]
      },
      kLibrary);
  assert.ok(Object.values(columnLayout(loop).places).flat().every(Number.isFinite));
});

test("the pointer finds ports, boxes and nothing, and wires end at rows", () => {
  const model = modelHere(), places = placedBoxes(model, {});
  const b = model.boxes.findIndex(({name}) => name === "motor"), place = places[b];
  const [dx, dy] = portPlace(place, "outputs", 1);
  assert.deepEqual(hitAt(model, places, place.x + dx + 4, place.y + dy), {box: b, side: "outputs", number: 1});
  assert.deepEqual(hitAt(model, places, place.x + 60, place.y + 10), {box: b});
  assert.equal(hitAt(model, places, -5000, 0), null);
  const [ix, iy] = portPlace(place, "inputs", 0);
  assert.deepEqual(
      targetAt(model, places, "inputs", place.x + ix + 30, place.y + iy), {box: b, side: "inputs", number: 0});
  assert.equal(targetAt(model, places, "inputs", place.x + dx, place.y + dy), null);  // an output
  const end = places.at(-1);
  assert.deepEqual(
      targetAt(model, places, "inputs", end.x + 20, end.y + 5),
      {box: model.boxes.length - 1, side: "inputs", number: -1});
  assert.ok(sizeOf({...model.boxes[b], title: "a very long name of an object"}).width > place.width);
});
