// Whole pages as the generator makes them, in a browser without layout: each view makes itself, everything can be
// selected, and no text says `undefined`. tests/browser looks at them in a real one.
import assert from "node:assert/strict";
import test from "node:test";
import vm from "node:vm";

import {browserWith, passFrames} from "./dom.mjs";
import {pageOf} from "./generator.mjs";

/** A page that has been opened; `run` evaluates text within it. */
function open(graph, ...options) {
  return opened(graph, pageOf(graph, ...options));
}

function opened(graph, {data, script}) {
  const browser = browserWith(data);
  const context = vm.createContext(
      {...browser.globals, atob, performance, TextDecoder, setTimeout: (call) => browser.timers.push(call)});
  context.window = context;
  vm.runInContext(script, context, {filename: graph});
  passFrames(browser.frames);
  return {...browser, data, run: (text) => vm.runInContext(text, context)};
}

function readable(element, what) {
  const wrong = /undefined|\bNaN\b|\[object|\bnull\b/.exec(element.textContent);
  assert.ok(!wrong, `${what}: ${element.textContent.slice(Math.max(0, wrong?.index - 60), wrong?.index + 60)}`);
}

const kGraphs = [
  ["examples/pendulum_swing_up/graph.yaml"], ["tests/golden/multi_rate/graph.yaml"], ["tests/compose/graphs/arm.yaml"],
  ["examples/quadruped_trot/graph.yaml"], ["examples/pendulum_with_safety/graph.yaml"],
  ["examples/pendulum_swing_up/controller.yaml"], ["tests/asynchronous/graph.yaml"], ["tests/page/odd_rates.yaml"]
];
for (const [graph, ...options] of kGraphs) {
  test(`${graph}: every view, and everything selected`, () => {
    const {data, run, document, frames} = open(graph, ...options);
    assert.equal(document.getElementById("title").textContent, data.info.name);
    const views = run("views.map((view) => view.id)");
    for (const id of views) {
      run(`showView(${JSON.stringify(id)})`);
      passFrames(frames);
      const panel = document.getElementById(`view-${id}`);
      assert.ok(!panel.hidden && (id === "timetable" || panel.textContent.length > 10), `${id} is empty`);
      if (id !== "source") readable(panel, id);  // the file may say anything
    }
    const inspector = document.getElementById("inspector");
    const all = [
      ...data.nodes.map((_, node) => ({node})), ...data.objects.map((_, object) => ({object})),
      ...data.composites.map((_, composite) => ({composite})),
      ...data.nodes.flatMap((node, n) => node.inputs.map((_, i) => ({input: [n, i]})))
    ];
    for (const selected of all) {
      run(`select(${JSON.stringify(selected)}); showInGraph()`);
      passFrames(frames);
      readable(inspector, JSON.stringify(selected));
      assert.ok(inspector.textContent.length > 10, JSON.stringify(selected));
      assert.ok(
          run("graphView.shown.boxElements.concat(graphView.shown.wireElements).some((element) => element.classList.contains('on'))"),
          `${JSON.stringify(selected)} is not marked`);
      run("showView('timetable')");
      passFrames(frames);
    }
    run("select(null)");
    assert.equal(inspector.textContent, "");
  });
}

test("keys go from view to view and from box to box, and Enter opens composites", () => {
  const {run, document, frames} = open("tests/compose/graphs/arm.yaml");
  const press = (key, target = document.body) => (document.send("keydown", {key, target}), passFrames(frames));
  press("2");
  assert.equal(run("state.view.id"), "timetable");
  press("1");
  const graph = run("graphSvg");
  for (const key of ["0", "+", "ArrowRight", "ArrowRight", "ArrowDown", "e", "e", "-"]) graph.send("keydown", {key});
  passFrames(frames);
  assert.notEqual(run("state.selected"), null);
  const closed = run("graphView.shown.boxes.length");
  graph.send("keydown", {key: "o"});
  assert.ok(run("graphView.shown.boxes.length") > closed);
  graph.send("keydown", {key: "o"});
  assert.equal(run("graphView.shown.boxes.length"), closed);
  press("Escape");
  assert.equal(run("state.selected"), null);
  press("?");
  assert.ok(document.getElementById("help").open);
});

test("Fit shows all of a graph, and again its whole width, if only the height made it small", () => {
  const {run, document, frames} = open("tests/compose/graphs/levels.yaml");
  run("showView('graph')");
  const fit =
      document.getElementById("view-graph").querySelectorAll("button").find((each) => each.textContent === "Fit");
  const press = () => (fit.click(), passFrames(frames), run("({...graphView, shown: null})"));
  const graphs = [{width: 2000, height: 3000}, {width: 6000, height: 500}, {width: 100, height: 500}];
  const [tall, wide, small] = graphs.map((size) => {
    run(`Object.assign(graphView.shown, ${JSON.stringify(size)}); graphView.moved = true`);
    const views = [press(), press(), press()];
    assert.ok(views[0].x >= 0 && views[0].x + size.width * views[0].zoom <= 800.001);
    assert.ok(views[0].y >= 0 && views[0].y + size.height * views[0].zoom <= 600.001);
    assert.equal(views[2].zoom, views[0].zoom, "a third time: all of it");
    return views;
  });
  assert.equal(tall[1].x, 16);
  assert.ok(Math.abs(2000 * tall[1].zoom - (800 - 2 * 16)) < 1e-9, "the whole width");
  assert.ok(tall[1].zoom > 2 * tall[0].zoom);
  assert.equal(wide[1].zoom, wide[0].zoom, "it is as wide already");
  assert.ok(small[1].zoom <= 1.5, "text does not become larger than it must");
});

test("an open composite that is selected is marked with all that is in it, however deep", () => {
  const {run, data, frames} = open("tests/compose/graphs/levels.yaml");
  const deep = data.composites.findIndex(({name}) => name === "deep");
  run(`showView('graph'); toggleAll(); select({composite: ${deep}})`);
  passFrames(frames);
  const isInside = (b) => {
    const {around, composite} = run(`graphView.shown.boxes[${b}]`);
    return composite === "deep" || (around !== undefined && isInside(around));
  };
  const boxes = [...Array(run("graphView.shown.boxes.length")).keys()], inside = boxes.filter(isInside);
  assert.ok(inside.length > 4);
  for (const b of inside) assert.ok(run(`graphView.shown.boxElements[${b}].classList.contains("on")`), `box ${b}`);
  assert.ok(boxes.some((b) => !run(`graphView.shown.boxElements[${b}].classList.contains("on")`)));
});

test("the timetable says what a tick reads, and what is not known", () => {
  const {run, document, data, frames} = open("tests/page/odd_rates.yaml");
  run("showView('timetable')");
  passFrames(frames);
  const tip = (name) => {
    const row = run("order").findIndex((node) => data.nodes[node].name === name);
    run("timetable.canvas")
        .parentElement.send("pointermove", {clientX: 300, clientY: run("kHead + kRow / 2") + row * run("kRow")});
    return document.getElementById("tip").textContent;
  };
  assert.match(tip("a"), /^a, tick \d+.*actions\.u: message \d+, /);
  assert.match(tip("d"), /c\.y: not known/);
});

test("the timetable shows the bound of an image", () => {
  const page = pageOf("examples/pendulum_swing_up/graph.yaml");
  const row = (name, most, bound) => ({name, most, bound, cycles: 2 * most, us: 0.08 * most});
  const slot = {name: "30 Hz", us: 2275.6, until_next_us: 33333.3, load: 0.068};
  const time = {
    parts: [row("step", 26026, true), row("policy", 10401, false)],
    slots: [row("30 Hz", 25969, true)],
    nodes: [row("smooth", 77, true)],
    missing: [{what: "the loop", place: "x.hpp:3", function: "f", of: ["policy"]}],
    fit: {busiest: slot, longest: slot, outputs: [{rate: "30 Hz", latest_us: 1588.9}]}
  };
  page.data.images =
      [{name: "swing.elf", size: {nodes: {}, others: {}, flash: 1, ram: 1, stack: {bytes: 1, calls: []}}, time}];
  const {run, document, frames} = opened("swing_up", page);
  run("showView('timetable')");
  passFrames(frames);
  const text = document.getElementById("view-timetable").textContent;
  assert.match(text, /Bound of swing\.elf: the slot of 30 Hz takes up to .* of .*, 6\.8 %\./);
  assert.match(text, /step26.026/);
  assert.match(text, /the loop at x\.hpp:3: none for policy/);
  assert.ok(!/policy10.401/.test(text), "a row without a bound");
  readable(document.getElementById("view-timetable"), "timetable");
  const tip = () => {
    run("timetable.canvas").parentElement.send("pointermove", {clientX: 300, clientY: run("kHead + kRow / 2")});
    return document.getElementById("tip").textContent;
  };
  assert.match(tip(), /at most 1\.589 ms after its time, by the image's bound/);
  assert.doesNotMatch(tip(), /measured/);
  run("timetable.measured = new Map([[order[0], {first: 0, late: new Array(1000).fill(0.0012)}]])");
  assert.match(tip(), /at most 1\.589 ms after its time, by the image's bound.*measured 1\.2 ms after its time/);
});

test("search finds what has a name, the nearest first", () => {
  const {run, document, frames} = open("examples/pendulum_swing_up/graph.yaml");
  const box = document.getElementById("search"), found = document.getElementById("found");
  box.value = "Smooth";
  box.send("input");
  assert.equal(found.children[0].textContent, "smoothnode");
  box.send("keydown", {key: "Enter"});
  passFrames(frames);
  assert.equal(run("nodes[state.selected.node].name"), "smooth");
  box.value = "there is no such thing";
  box.send("input");
  assert.equal(found.textContent, "nothing");
});

test("Fit shows all of a high graph and, again, its whole width from the top", () => {
  const {run, frames} = open("examples/pendulum_swing_up/graph.yaml");
  run("showView('graph')");
  passFrames(frames);
  const {width, height} = run("graphSvg.getBoundingClientRect()");
  assert.ok(width > 400 && height > 100);
  run(`graphView.shown.width = ${width / 2}; graphView.shown.height = ${10 * height}; zoomGraph(3); fitGraphOrWidth()`);
  const all = run("({...graphView})");
  assert.ok(all.y + 10 * height * all.zoom <= height, "all of it is in the window");
  run("fitGraphOrWidth()");
  const wide = run("({...graphView})");
  assert.equal(wide.zoom, 1.5, "at most");
  assert.equal(wide.x, (width - 1.5 * width / 2) / 2);
  assert.equal(wide.y, 50);
  run("fitGraphOrWidth()");
  assert.equal(run("graphView.zoom"), all.zoom);
});
