// Controls of the simulation: actions by hand, and initial states of episodes.
import {breakable, card, el} from "./elements.mjs";
import {short} from "./numbers.mjs";

/** Row for each number of `fields`: {name, at, whole, low, high}. */
export function numbersOf(fields, low, high, most = 64) {
  const rows = fields.flatMap(
      (field) => Array.from({length: field.numbers}, (_, i) => ({
                                                       name: field.numbers > 1 ? `${field.name}[${i}]` : field.name,
                                                       at: field.first + i,
                                                       whole: !field.dtype.startsWith("float"),
                                                       low: low[field.first + i],
                                                       high: high[field.first + i]
                                                     })));
  return rows.slice(0, most);
}

/**
 * Slider and field for one number. Calls `changed(value)` when the user changes it; `show(value)` sets it. A number
 * without bounds has a slider if it is `tunable`: its range follows the last `around(value)` or typed number.
 */
export function numberControl(row, changed) {
  const bounded = Number.isFinite(row.high - row.low);
  const step = row.whole ? 1 : "any";
  const limits = {
    min: Number.isFinite(row.low) ? row.low : undefined,
    max: Number.isFinite(row.high) ? row.high : undefined
  };
  const label = {"aria-label": row.name};
  const slider = bounded || row.tunable ? el("input", {type: "range", ...limits, step, ...label}) : null;
  if (slider && !bounded) slider.style.visibility = "hidden";
  const field = el("input", {type: "number", ...limits, step, ...label});
  const around = (value) => {
    if (!slider || bounded) return;
    slider.min = Math.max(row.low, Math.min(0, 3 * value));
    slider.max = Math.min(row.high, Math.max(0, 3 * value));
    slider.style.visibility = value === 0 ? "hidden" : "visible";
  };
  const take = (event) => {
    const value = event.target.valueAsNumber;
    if (Number.isNaN(value)) return;
    const inside = Math.min(row.high, Math.max(row.low, value));
    if (event.target !== slider) around(inside);
    if (slider && event.target !== slider) slider.value = inside;
    if (event.target !== field) field.value = short(inside, 5);
    changed(inside);
  };
  for (const input of [slider, field])
    if (input) input.addEventListener("input", take);
  // A typed number may be outside the range.
  field.addEventListener("change", () => {
    if (slider && bounded && !Number.isNaN(field.valueAsNumber)) field.value = short(slider.valueAsNumber, 5);
  });
  return {
    elements: [slider || el("span"), field],
    around,
    show(value) {
      if (slider) slider.value = value;
      if (document.activeElement !== field) field.value = Number.isNaN(value) ? "" : short(value, 5);
    }
  };
}

/** Controls of the actions, which follow the agent until the user moves one and takes over. */
export class ActionControls {
  constructor(simulation, taken) {
    this.simulation = simulation;
    const rows = numbersOf(simulation.about.actions, simulation.actionsLow, simulation.actionsHigh);
    this.controls = rows.map((row) => ({
                               row,
                               ...numberControl(
                                   row,
                                   (value) => {
                                     simulation.actions[row.at] = value;
                                     taken();
                                   })
                             }));
    this.element = rows.length ?
        card(
            "Actions",
            el("div.numbers", {},
               this.controls.map(
                   ({row, elements}) => [el("span", {}, breakable(row.name)), el("span"), ...elements]))) :
        null;
  }

  show() {
    for (const {row, show} of this.controls) show(this.simulation.actions[row.at]);
  }
}

/**
 * Controls of states, parameters and delays of the next episodes: sampled, or fixed if the box is checked. Tunable
 * parameters also change immediately. `step()` is the step before which they do, or null if no episode runs.
 */
export class StateControls {
  constructor(simulation, step) {
    this.simulation = simulation;
    this.step = step;
    /** Options of the program that make the same changes in the first episode. */
    this.tuned = [];
    this.steered = new Map();  // numbers of parameters that keys add to, without keys
    const {about} = simulation;
    const rows = about.states.flatMap(
        (field) => numbersOf([field], simulation.statesLow, simulation.statesHigh)
                       .map((row) => ({...row, field, tunable: about.tunable.includes(field.name)})));
    this.controls = rows.slice(0, 64).map((row) => {
      const box = el("input", {
        type: "checkbox",
        "aria-label": `set ${row.name}`,
        onchange: () => this.set(row, box.checked ? this.simulation.states[row.at] : NaN)
      });
      const control = numberControl(row, (value) => {
        box.checked = true;
        this.set(row, value);
      });
      return {row, box, atReset: false, ...control};
    });
    this.element = rows.length ?
        card(
            "An episode begins with",
            el("p.note", {},
               "Drawn as the graph says; where the box is ticked, it is the value next to it from the next reset on" +
                   (about.tunable.length ? ". What is tunable (bold) changes at once, too." : ".")),
            el("div.numbers", {},
               this.controls.map(
                   ({row,
                     box,
                     elements}) => [el(row.tunable ? "b" : "span", {}, breakable(row.name)), box, ...elements]))) :
        null;
  }

  /** Sets a number; NaN means that it is sampled again. */
  set(row, value) {
    this.simulation.settings[row.at] = value;
    if (row.tunable) this.tune(row.field);
  }

  /**
   * Sets a tunable parameter from the next step on: adds to the numbers that the reset before the first call sampled,
   * or to 0. Returns false if a sum is outside of the parameter's bounds.
   */
  steer(name, add) {
    const {about, states, statesLow, statesHigh, settings} = this.simulation;
    const field = about.states.find((state) => state.name === name);
    if (!field || !about.tunable.includes(name)) return false;
    if (!this.steered.has(name)) this.steered.set(name, states.slice(field.first, field.first + field.numbers));
    const sums = Array.from(this.steered.get(name), (value, i) => (Number.isNaN(value) ? 0 : value) + add[i]);
    if (sums.some((x, i) => !(x >= statesLow[field.first + i] && x <= statesHigh[field.first + i]))) return false;
    settings.set(sums, field.first);
    for (const {row, box, show} of this.controls) {
      if (row.field !== field) continue;
      box.checked = true;
      show(settings[row.at]);
    }
    this.tune(field);
    return true;
  }

  /** Hands the settings of a parameter to the running episode. */
  tune({first, numbers, name}) {
    const step = this.step();
    if (step === null || !this.simulation.tune()) return;
    const values = Array.from(this.simulation.settings.subarray(first, first + numbers));
    if (values.some(Number.isNaN)) return;
    // Of several changes before one step, only the last one counts.
    this.tuned = this.tuned.filter((option) => !option.startsWith(`--set ${name}=`) || !option.endsWith(`@${step}`));
    this.tuned.push(`--set ${name}=${values.join(",")}@${step}`);
  }

  /** Shows what a new episode began with, except where a value is set. */
  show() {
    this.tuned = [];
    for (const control of this.controls) {
      control.atReset = control.box.checked;
      if (!control.box.checked) control.show(this.simulation.states[control.row.at]);
    }
  }

  /** True if the episode began with a value that the user set. */
  get any() {
    return this.controls.some(({atReset}) => atReset);
  }
}
