// Numbers as text.
import assert from "node:assert/strict";
import test from "node:test";

import {
  bounds,
  bytes,
  count,
  counted,
  floats,
  list,
  parse,
  seconds,
  short,
  stepOf
} from "../../templates/page/numbers.mjs";

test("thousands stand apart, and what is counted has its plural", () => {
  assert.equal(count(1234567), "1\u202f234\u202f567");
  assert.equal(count(999), "999");
  assert.equal(bytes(1024), "1\u202f024 B");
  assert.deepEqual(
      [counted(1, "node"), counted(2, "node"), counted(2, "mesh"), counted(0, "pass")],
      ["1 node", "2 nodes", "2 meshes", "0 passes"]);
});

test("digits that count, whatever the size", () => {
  const cases = [
    [0, "0"], [1 / 3, "0.3333"], [-12345.678, "-12350"], [1e6, "1.00e6"], [4.2e-7, "4.20e-7"], [NaN, "–"], [null, "–"],
    [Infinity, "Infinity"]
  ];
  for (const [value, text] of cases) assert.equal(short(value), text);
  assert.equal(short(0.1 + 0.2, 6), "0.3");
});

test("times have the unit that they are read in", () => {
  const cases = [
    [0, "0 s"], [2e-8, "20 ns"], [1.5e-5, "15 µs"], [0.0333333, "33.33 ms"], [-0.002, "-2 ms"], [75, "75 s"],
    [null, "unknown"]
  ];
  for (const [value, text] of cases) assert.equal(seconds(value), text);
});

test("long lists end in how long they are", () => {
  assert.equal(list([1, 2.5, "a"]), "1, 2.5, a");
  assert.equal(list([...Array(10).keys()], 3), "0, 1, 2, … (10)");
  assert.equal(list([]), "");
});

test("bounds: equal ones once, and null is infinite", () => {
  assert.equal(bounds({low: [], high: []}), "no bounds");
  assert.equal(bounds({low: [-1, -1], high: [1, 1]}), "-1 … 1");
  assert.equal(bounds({low: [-1, 0], high: [1, null]}), "[-1, 0] … [1, ∞]");
  assert.equal(bounds({low: [null], high: [null]}), "−∞ … ∞");
});

test("rates are fractions", () => {
  assert.equal(parse("30"), 30);
  assert.equal(parse("30000/1001"), 30000 / 1001);
});

test("steps of axes are 1, 2 or 5 times a power of ten, and few enough", () => {
  for (const span of [1e-9, 0.037, 1, 7.3, 86400, 3e11])
    for (const most of [1, 4, 13]) {
      const step = stepOf(span, most), leading = Number(step.toExponential(6).slice(0, 8));
      assert.ok([1, 2, 5].some((factor) => Math.abs(leading - factor) < 1e-4), `${span} in ${most}: ${step}`);
      assert.ok(span / step <= most * (1 + 1e-9) && span / step > most / 2.6, `${span} in ${most}: ${step}`);
    }
});

test("float32 as base64, little-endian on every machine", () => {
  const bytes = Buffer.alloc(12);
  [1.5, -0.25, NaN].forEach((value, i) => bytes.writeFloatLE(value, 4 * i));
  assert.deepEqual([...floats(bytes.toString("base64"))], [1.5, -0.25, NaN]);
  assert.equal(floats("").length, 0);
});
