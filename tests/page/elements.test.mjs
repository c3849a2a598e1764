// The elements of views.
import assert from "node:assert/strict";
import test from "node:test";

import {become, smallData} from "./dom.mjs";

become(smallData());
const {breakable, el, piecesOf, segment, table} = await import("../../templates/page/elements.mjs");
const {numbersOf} = await import("../../templates/page/simulation_controls.mjs");
const {newestRange} = await import("../../templates/page/growing_plots.mjs");
const {sourceLine} = await import("../../templates/page/source.mjs");

test("names break behind dots, slashes and underscores and before an index, never within a word", () => {
  assert.deepEqual(piecesOf("pendulum.model_state[0]"), ["pendulum.", "model_", "state", "[0]"]);
  assert.deepEqual(piecesOf("arm/joint__a.q"), ["arm/", "joint__", "a.", "q"]);
  for (const name of ["", "x", "_", "a_", "[0]", "...", "pendulum"]) assert.equal(piecesOf(name).join(""), name);
  const box = el("span", {}, breakable("a.b_c"));
  assert.equal(box.textContent, "a.b_c");
  assert.deepEqual(box.children.map((child) => child.tagName), ["wbr", "wbr"]);
});

test("what is not an element is text", () => {
  const box = el("p.a.b", {title: "t", "aria-label": "l"}, "<b>", 5, null, [["&"]], el("i", {}, "x"));
  assert.equal(box.textContent, "<b>5&x");
  assert.deepEqual(
      [box.className, box.title, box.getAttribute("aria-label"), box.children.length], ["a b", "t", "l", 1]);
});

test("a long table waits behind a button, and rows answer to the keyboard", () => {
  const chosen = [];
  const box = table([{name: "n", cell: (row) => row}], [...Array(500).keys()], 200, (row) => chosen.push(row));
  const rows = () => box.querySelectorAll("tr").length - 1;
  assert.equal(rows(), 200);
  box.querySelector("button").click();
  assert.equal(rows(), 500);
  assert.equal(box.querySelector("button"), null);
  const [, , third] = box.querySelector("tbody").children;
  third.click();
  third.send("keydown", {key: "Enter"});
  third.send("keydown", {key: "a"});
  assert.deepEqual(chosen, [2, 2]);
});

test("of a group of buttons one is pressed", () => {
  const chosen = [], group = segment("which", [["a", "A"], ["b", "B"]], "a", (value) => chosen.push(value));
  const pressed = () => group.children.map((button) => button.getAttribute("aria-pressed"));
  assert.deepEqual(pressed(), ["true", "false"]);
  group.children[1].click();
  assert.deepEqual([pressed(), chosen], [["false", "true"], ["b"]]);
});

test("a row for each number of a state, with its bounds, and no more than fit", () => {
  const fields =
      [{name: "mass", first: 0, numbers: 1, dtype: "float32"}, {name: "q", first: 1, numbers: 2, dtype: "int64"}];
  assert.deepEqual(numbersOf(fields, [0, -1, -2], [9, 1, 2]), [
    {name: "mass", at: 0, whole: false, low: 0, high: 9}, {name: "q[0]", at: 1, whole: true, low: -1, high: 1},
    {name: "q[1]", at: 2, whole: true, low: -2, high: 2}
  ]);
  assert.equal(numbersOf([{name: "x", first: 0, numbers: 900, dtype: "float32"}], [], []).length, 64);
});

test("the range of a plot that grows has room, and stands what is not finite", () => {
  const points = (...values) => ({elements: [{low: values}]});
  const near = (found, wanted) =>
      found.forEach((value, i) => assert.ok(Math.abs(value - wanted[i]) < 1e-9, `${found}`));
  near(newestRange(points(-5, 0, 1), 2), [-0.08, 1.08]);
  near(newestRange(points(2, 2), 9), [1.84, 2.16]);
  for (const none of [points(), points(NaN), points(Infinity)]) assert.deepEqual(newestRange(none, 9), [0, 1]);
});

test("a line of the file: its key, and a comment that is one", () => {
  const parts = (text) => {
    const code = sourceLine(text, 0).querySelector("code");
    assert.equal(code.textContent, text);
    return [code.querySelector("span.key")?.textContent ?? "", code.querySelector("span.comment")?.textContent ?? ""];
  };
  assert.deepEqual(parts("  rate: 30 # fast"), ["rate", "# fast"]);
  assert.deepEqual(parts("- {from: a.b, to: c.d}"), ["", ""]);
  assert.deepEqual(parts("name: \"a # b\" # c"), ["name", "# c"]);
  assert.deepEqual(parts("name: 'a # b'"), ["name", ""]);
  assert.deepEqual(parts("colour: a#b"), ["colour", ""]);
  assert.deepEqual(parts("# all of it"), ["", "# all of it"]);
  assert.deepEqual(parts("</code><img src=x>"), ["", ""]);
});
