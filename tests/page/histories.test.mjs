// Histories of live messages, and of the scenes of a trace.
import assert from "node:assert/strict";
import test from "node:test";

import {Film} from "../../templates/page/film.mjs";
import {kKeptSteps, kPlottedElements, StepHistory, StreamHistory} from "../../templates/page/history.mjs";

test("of a simulation the newest steps are kept, and their times stay", () => {
  const history = new StepHistory([{first: 0, numbers: 1}, {first: 1, numbers: 40}], 0.5);
  for (let i = 0; i < 2 * kKeptSteps + 7; ++i) history.add([i, ...Array(40).fill(-i)]);
  const [one, many] = [history.points(0), history.points(1)];
  assert.equal(many.elements.length, kPlottedElements);
  assert.equal(history.end_s, (2 * kKeptSteps + 7) * 0.5);
  assert.equal(one.begin, kKeptSteps * 0.5);
  assert.deepEqual([one.elements[0].low[0], one.elements[0].low.at(-1)], [kKeptSteps, 2 * kKeptSteps + 6]);
  assert.equal(new StepHistory([], 0.1).end_s, 0);
});

test("of a stream: gaps where messages were lost, and a new beginning where time goes back", () => {
  const history = new StreamHistory([{rate_hz: 10}]);
  const low = () => history.points(0).elements[0].low;
  assert.deepEqual(history.points(0), {begin: 0, step: 1, elements: []});
  history.add(0, [1], 2.0);
  history.add(0, [2], 2.1);
  history.add(0, [5], 2.4);
  assert.deepEqual([low(), history.points(0).begin, history.end_s], [[1, 2, NaN, NaN, 5], 2, 2.4]);
  history.add(0, [null], 2.5);
  assert.ok(Number.isNaN(low().at(-1)));
  history.add(0, [7], 0.3);  // the next episode
  assert.deepEqual([low(), history.points(0).begin.toFixed(6)], [[7], "0.300000"]);
  history.add(0, [8, 9], 0.4);  // another number of elements
  assert.deepEqual(history.points(0).elements.map((element) => element.low), [[8], [9]]);
  history.add(0, [1, 1], 1e9);  // no gap of a billion
  assert.deepEqual(history.points(0).elements.map((element) => element.low), [[1], [1]]);
});

test("of a stream no more than twice what is shown is kept", () => {
  const history = new StreamHistory([{rate_hz: 1000}]);
  for (let i = 0; i < 5 * kKeptSteps; ++i) history.add(0, [i], i / 1000);
  const {begin, step, elements: [{low}]} = history.points(0);
  assert.ok(low.length <= 2 * kKeptSteps && low.length >= kKeptSteps);
  assert.equal(Math.round(begin / step), low[0]);
});

/** As generator/tools/page/scenes.cpp writes it: scenes of [tick, numbers]. */
function encoded(scenes) {
  const bytes = [], shown = [];
  const put = (value, size) => {
    for (let i = 0; i < size; ++i) bytes.push((value >> (8 * i)) & 255);
  };
  const bits = (value) => new Uint32Array(new Float32Array([value]).buffer)[0];
  for (const [tick, numbers] of scenes) {
    const changes = numbers.flatMap((value, i) => (bits(shown[i] ?? 0) === bits(value) ? [] : [[i, value]]));
    put(tick, 4), put(numbers.length / 16, 2), put(changes.length, 2);
    for (const [i, value] of changes) put(i, 2), put(bits(value), 4), shown[i] = value;
  }
  return {rate_hz: 10, every: 2, scenes: scenes.length, changes: Buffer.from(bytes).toString("base64")};
}

test("scenes of a trace: forwards, backwards and far away they are what they were", () => {
  const scenes = Array.from(
      {length: 300},
      (_, s) =>
          [2 * s, Array.from({length: 16 * (1 + (s % 3))}, (_, i) => ((i * 7 + s) % 5 ? i : Math.fround(s / 3 + i)))]);
  const film = new Film(encoded(scenes));
  for (const number of [0, 1, 2, 150, 299, 3, 64, 63, 128, 65, 299, 0, 200, 199])
    assert.deepEqual([...film.go(number)], scenes[number][1], `scene ${number}`);
  assert.equal(film.end_s, 60);
});

test("the scene of a time is the newest known scene", () => {
  const film = new Film(encoded([[0, Array(16).fill(1)], [4, Array(16).fill(2)], [6, Array(16).fill(3)]]));
  assert.deepEqual([0, 0.39, 0.4, 0.59, 0.6, 99, -1].map((time) => film.numberAt(time)), [0, 0, 1, 1, 2, 2, 0]);
});
