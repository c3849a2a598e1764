// Keys that steer the simulation add to a tunable parameter while they are held.
import assert from "node:assert/strict";
import test from "node:test";

import {become, smallData} from "./dom.mjs";

const listeners = new Map();
become(smallData());
document.addEventListener = (name, listener) => listeners.set(name, listener);
window.addEventListener = (name, listener) => listeners.set(name, listener);
const {SteeringKeys} = await import("../../templates/page/simulation_keys.mjs");
const {StateControls} = await import("../../templates/page/simulation_controls.mjs");

const kKeys = [
  {key: "ArrowUp", parameter: "commands.value", add: [0.75, 0]}, {key: "a", parameter: "commands.value", add: [0, 0.5]},
  {key: "ArrowDown", parameter: "commands.value", add: [-9, 0]}
];
/** A simulation whose parameter follows 70 other numbers, so that the page shows no slider for it. */
function simulation() {
  const states = new Float64Array(72).fill(0.25);
  return {
    about: {
      states: [
        {name: "robot.pose", dtype: "float32", first: 0, numbers: 70},
        {name: "commands.value", dtype: "float32", first: 70, numbers: 2}
      ],
      tunable: ["commands.value"]
    },
    states,
    statesLow: states.map(() => -1),
    statesHigh: states.map(() => 1),
    settings: states.map(() => NaN),
    tuned: 0,
    tune() {
      return ++this.tuned > 0;
    }
  };
}
const at = {
  inField: false,
  active: true,
  stopped: 0
};
const event = (key, more = {}) => ({
  key,
  target: {matches: () => at.inField},
  preventDefault: () => ++at.stopped,
  stopImmediatePropagation() {},
  ...more
});
const press = (key, more) => listeners.get("keydown")(event(key, more));
const release = (key) => listeners.get("keyup")(event(key));

test("held keys are summed up, and released ones leave the value of the episode", () => {
  const simulated = simulation();
  const controls = new StateControls(simulated, () => 7);
  const keys = new SteeringKeys(kKeys, () => at.active, (name, add) => controls.steer(name, add));
  const value = () => Array.from(simulated.settings.subarray(70));
  assert.match(keys.element.textContent, /ArrowUp commands.value 0.75, 0/);

  press("ArrowUp");
  assert.deepEqual(value(), [1, 0.25]);
  press("ArrowUp");  // repeated by the keyboard
  assert.equal(simulated.tuned, 1);
  press("A");  // with Shift
  assert.deepEqual(value(), [1, 0.75]);
  assert.deepEqual(controls.tuned, ["--set commands.value=1,0.75@7"]);
  release("ArrowUp");
  assert.deepEqual(value(), [0.25, 0.75]);
  listeners.get("blur")();
  assert.deepEqual(value(), [0.25, 0.25]);
  assert.ok(Number.isNaN(simulated.settings[0]));

  press("ArrowDown");  // beyond the parameter's bounds
  assert.deepEqual(value(), [0.25, 0.25]);
  release("ArrowDown");
});

test("a parameter that no reset samples begins at 0", () => {
  const simulated = simulation();
  simulated.states.fill(NaN);
  const controls = new StateControls(simulated, () => 0);
  assert.ok(controls.steer("commands.value", [0.5, 0]));
  assert.deepEqual(controls.tuned, ["--set commands.value=0.5,0@0"]);
});

test("other keys, other views, shortcuts and fields keep their meaning", () => {
  let changes = 0;
  new SteeringKeys(kKeys, () => at.active, () => ++changes);
  at.stopped = 0;
  press("b");
  press("a", {ctrlKey: true});
  at.active = false;
  press("a");
  at.active = true;
  at.inField = true;
  press("a");
  at.inField = false;
  assert.deepEqual([changes, at.stopped], [0, 0]);
  press("a");
  assert.deepEqual([changes, at.stopped], [1, 1]);
});

test("without keys there is nothing to show or to listen to", () => {
  listeners.clear();
  assert.equal(new SteeringKeys([], () => true, () => {}).element, null);
  assert.equal(listeners.size, 0);
});
