// Charts, and the view of a training: what a record says becomes text.
import assert from "node:assert/strict";
import test from "node:test";

import {become, Element, passFrames, smallData} from "./dom.mjs";

const kNasty = "<img src=x onerror=alert(1)>";
const line = {
  name: kNasty,
  x: [10, 20, 30],
  y: [-3, -2, -1]
};
const training = {
  ...{
    kind: "record",
    name: kNasty,
    graph: "small",
    algorithm: "ppo",
    steps: 40,
    seed: 1,
    seeds: 2,
    has_success: true,
    terms: [kNasty, "effort"],
    best: 0
  },
  settings: [
    {name: "clip", value: kNasty, default: "0.2", differs: true, about: ""},
    {name: "horizon", value: "32", default: "32", differs: false, about: ""}
  ],
  trainings: [
    {
      ...{seed: 1, ended: "steps", steps: 30, seconds: 1, kernels: "avx2", policy: kNasty, signs: [kNasty]},
      time: {
        ...{threads: 2, simulation_s: 0.5, inference_s: 0.25, learning_s: 1, evaluation_s: 0.05, waiting_s: 0.2},
        ...{
          steps: 30, samples: 60, inference_gflop: 1, learning_gflop: 8
        }
      },
      evaluation:
          {episodes: 400, successes: 100, return: -1, lowest: -3, highest: 0, steps: 9, saturated: 0.5, terms: [-3, 1]}
    },
    {seed: 2, ended: "failed", steps: 10, problem: kNasty, help: ""}
  ],
  charts: [{name: "Return", unit: "", lines: [line]}],
  returns: [[-3, 0], [0, 1]],
  shown: [
    {what: "best", seed: "13835058055282163712", environment: 3, return: 0, steps: 9, success: true, command: kNasty}
  ],
  why_not: "",
  run: "eagerx-gen run small.yaml",
  next: [{about: "run it", command: kNasty}]
};
const {frames} = become({...smallData(), training});
const {chartPointAt, chartRange, paintChart} = await import("../../templates/page/charts.mjs");
await import("../../templates/page/training_view.mjs");
const {moreViews} = await import("../../templates/page/views.mjs");

test("a chart reaches from zero steps to the last, and over all that its lines stand for", () => {
  const {right, low, high} = chartRange({unit: "", lines: [{...line, low: [-9, -2, -1], high: [-3, -2, 5]}]});
  assert.equal(right, 30);
  assert.ok(low < -9 && low > -10.1 && high > 5 && high < 6.1);
  assert.deepEqual(chartRange({unit: "%", lines: [line]}), {right: 30, low: 0, high: 1});
  assert.deepEqual(chartRange({unit: "", lines: []}), {right: 1, low: 0, high: 1});
  const flat = chartRange({unit: "", lines: [{x: [1], y: [7]}]});
  assert.ok(flat.low < 7 && flat.high > 7);
});

test("the pointer reads the point at or before it", () => {
  assert.deepEqual([0, 10, 19, 20, 99].map((at) => chartPointAt(line, at)), [0, 0, 0, 1, 2]);
});

test("points are where they belong", () => {
  const context = new Element("canvas").getContext();
  paintChart(context, {unit: "%", lines: [{x: [0, 50, 100], y: [0, 1, 0.5]}]}, 278, 130);
  const places = context.calls.filter(([name]) => /^(moveTo|lineTo)$/.test(name)).slice(-3);
  assert.deepEqual(places, [["moveTo", 64, 94], ["lineTo", 164, 8], ["lineTo", 264, 51]]);
});

test("the view says what the record says, and all of it is text", () => {
  const panel = new Element("section");
  const view = moreViews.get("training")(panel);
  view.shown();
  passFrames(frames);
  const text = panel.textContent;
  for (const words
           of ["the steps are used up", "25 % of 400 episodes", "What holds it", "The best", "60 steps/s a thread",
               "learning50 % 60 samples/s a thread, 8 Gflop/s", "waiting10 %"])
    assert.ok(text.includes(words), words);
  assert.ok(text.includes("eagerx-gen run small.yaml " + kNasty));
  assert.ok(text.split(kNasty).length > 8);
  assert.ok(!panel.querySelector("img"));
  const painted = panel.querySelectorAll("canvas").filter((canvas) => canvas.context?.calls.length > 10);
  assert.equal(painted.length, 2, "a chart of the curve and one of the episodes");
  assert.ok(text.includes("1 setting with the default"));
});
