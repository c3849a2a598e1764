// Scenes as they are painted: whatever numbers a program sends, nothing breaks.
import assert from "node:assert/strict";
import test from "node:test";

import {kColumns, paintScene, sceneRow, sceneText} from "../../templates/page/scene.mjs";

import {Element} from "./dom.mjs";

const row = (...numbers) => Float32Array.from({length: kColumns}, (_, i) => numbers[i] ?? 0);
const scene = (...rows) => Float32Array.from(rows.flatMap((one) => [...one]));

/** What is called on a canvas of 200 by 100. */
function painted(numbers) {
  const context = new Element("canvas").getContext("2d");
  paintScene(context, numbers, 200, 100);
  return context.calls;
}
const of = (calls, name) => calls.filter(([what]) => what === name);

test("the middle of the view is the middle of the canvas, in metres", () => {
  const calls = painted(scene(row(1, 0xffffff, 1, 0, 1, 2, 4), row(5, 0x3366cc, 0.5, 0, 1, 2, 0.4)));
  assert.deepEqual(
      of(calls, "arc").map((call) => call.slice(1, 4).map((x) => Math.round(x * 1e4) / 1e4)), [[100, 50, 10]]);
  assert.deepEqual(of(calls, "fillStyle =").at(-1), ["fillStyle =", "rgba(51, 102, 204, 0.5)"]);
});

test("every shape of the plane and of space paints something, a row of zeros ends the scene", () => {
  const numbers = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.2, 0.3, 0.2, 0.1, 0.1, 0.1];
  const paints = (kind, first) => {
    const calls = painted(scene(first, row(kind, 0, 1, 0.01, ...numbers)));
    return calls.length - painted(scene(first)).length;
  };
  for (const kind of [2, 3, 4, 5, 6, 7]) assert.ok(paints(kind, row(1, 0, 1, 0, 0, 0, 2)) > 0, `shape ${kind}`);
  for (const kind of [10, 11, 12, 13, 14, 15, 16])
    assert.ok(paints(kind, row(9, 0, 1, 0, 3, 3, 2, 0, 0, 0, 1)) > 0, `shape ${kind}`);
  assert.equal(painted(scene(row(), row(5, 0, 1, 0, 0, 0, 9))).length, painted(scene(row())).length);
});

test("what is near the eye stands before what is far", () => {
  const sphere = (colour, x) => row(12, colour, 1, 0, x, 0, 0, 0.1);
  const order = (...rows) =>
      of(painted(scene(row(9, 0, 1, 0, 5, 0, 0, 0, 0, 0, 1), ...rows)), "fillStyle =").map(([, fill]) => fill);
  const [near, far] = [sphere(0xff0000, 2), sphere(0x0000ff, -2)];
  assert.match(order(near, far).at(-1), /^rgba\(\d+, 0, 0/);
  assert.deepEqual(order(near, far), order(far, near));
});

test("a facet is a flat piece in the light", () => {
  const camera = row(9, 0, 1, 0, 0, 0, 5, 0, 0, 0, 1);
  const facet = (...corners) => painted(scene(camera, row(16, 0x808080, 1, 0, ...corners)));
  const seen = facet(-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0);
  assert.equal(of(seen, "moveTo").length, 1);
  assert.equal(of(seen, "lineTo").length, 3);
  const light = (calls) => Number(/^rgba\((\d+)/.exec(of(calls, "fillStyle =").at(-1)[1])[1]);
  assert.ok(light(seen) > light(facet(-1, 0, -1, 1, 0, -1, 1, 0, 1, -1, 0, 1)));    // upright
  assert.equal(light(seen), light(facet(-1, 1, 0, 1, 1, 0, 1, -1, 0, -1, -1, 0)));  // both sides
  // The nearer one is painted last, wherever its first corner is.
  const low = row(16, 0xff0000, 1, 0, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 0);
  const high = row(16, 0x0000ff, 1, 0, 0, 0, 0.9, 1, 0, 2, 1, 1, 2, 0, 1, 2);
  assert.match(of(painted(scene(camera, high, low)), "fillStyle =").at(-1)[1], /^rgba\(0, 0/);
});

test("no number is too strange", () => {
  const strange = [NaN, Infinity, -Infinity, 1e38, -1e38, 0, -1, 1e-40, 0.5, 31.9, 64, 2 ** 24];
  let state = 1;
  const random = () => (state = (state * 48271) % 2147483647) / 2147483647;
  for (let trial = 0; trial < 1000; ++trial) {
    const rows = Array.from({length: 3}, () => {
      const numbers = Array.from(
          {length: kColumns},
          () => (random() < 0.4 ? strange[Math.floor(random() * strange.length)] : 4 * random() - 2));
      if (random() < 0.9) numbers[0] = Math.floor(random() * 48);
      return row(...numbers);
    });
    painted(scene(...rows));
  }
  assert.equal(sceneRow(row(NaN), 0), null);
  assert.equal(sceneRow(row(17), 0), null);
});

test("texts: three letters a number, # is the value", () => {
  const packed =
      (text) => [0, 3, 6, 9, 12, 15].map((at) => Buffer.from(text.slice(at, at + 3).padEnd(3, "\0")).readUIntBE(0, 3));
  const text = (value, digits, words) =>
      sceneText(sceneRow(row(8, 0, 1, 0, 0, 0, 1, value, digits, 0, ...packed(words)), 0));
  assert.equal(text(1.25, 2, "t = # s"), "t = 1.25 s");
  assert.equal(text(NaN, 2, "#"), "–");
  assert.equal(text(1, -1, "100 #"), "100 #");
  assert.equal(text(0, -1, "eighteen letters!!"), "eighteen letters!!");
});
