// Messages received while the page is open; in a simulation, the newest message after each step.

export const kKeptSteps = 6000, kShown_s = 20, kPlottedElements = 16;

/** Messages since a reset. */
export class StepHistory {
  constructor(fields, step_s) {
    this.step_s = step_s;
    this.first = 0;  // step of the first point
    this.rows = fields.map((field) => Array.from({length: Math.min(field.numbers, kPlottedElements)}, () => []));
    this.fields = fields;
  }

  get length() {
    return this.rows.length && this.rows[0].length ? this.rows[0][0].length : 0;
  }

  get end_s() {
    return (this.first + this.length) * this.step_s;
  }

  get kept_s() {
    return Math.min(kShown_s, kKeptSteps * this.step_s);
  }

  add(values) {
    this.fields.forEach((field, f) => this.rows[f].forEach((row, i) => row.push(values[field.first + i])));
    if (this.length < 2 * kKeptSteps) return;
    for (const elements of this.rows)
      for (const row of elements) row.splice(0, kKeptSteps);
    this.first += kKeptSteps;
  }

  /** Points for drawElement(). */
  points(f) {
    return {
      begin: this.first * this.step_s,
      step: this.step_s,
      elements: this.rows[f].map((row) => ({low: row, high: null}))
    };
  }
}

/** Messages of the plotted channels: points at the rate of each channel, in seconds of the run. */
export class StreamHistory {
  constructor(fields) {
    this.fields = fields;
    this.rows = fields.map(() => null);
    this.end_s = 0;
  }

  add(f, values, time_s) {
    const step = 1 / this.fields[f].rate_hz, place = Math.round(time_s / step);
    const shown = values.slice(0, kPlottedElements).map((value) => (value === null ? NaN : Number(value)));
    let row = this.rows[f];
    // Missing messages leave a gap. After a long gap or a jump back in time, the history starts again.
    const gap = row ? place - row.first - row.elements[0].length : -1;
    if (gap < 0 || gap > kKeptSteps || row.elements.length !== shown.length)
      row = this.rows[f] = {first: place, step, elements: shown.map(() => [])};
    else
      for (let i = 0; i < gap; ++i) row.elements.forEach((element) => element.push(NaN));
    row.elements.forEach((element, i) => element.push(shown[i]));
    if (row.elements[0].length > 2 * kKeptSteps) {
      for (const element of row.elements) element.splice(0, kKeptSteps);
      row.first += kKeptSteps;
    }
    this.end_s = Math.max(this.end_s, time_s);
  }

  get kept_s() {
    return kShown_s;
  }

  points(f) {
    const row = this.rows[f];
    if (!row) return {begin: 0, step: 1, elements: []};
    return {begin: row.first * row.step, step: row.step, elements: row.elements.map((low) => ({low, high: null}))};
  }
}
