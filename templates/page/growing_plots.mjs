// Plots of channels that still receive messages.
import {prepare, shade} from "./canvas.mjs";
import {data, nodes} from "./data.mjs";
import {breakable, el} from "./elements.mjs";
import {kPlottedElements} from "./history.mjs";
import {count, list} from "./numbers.mjs";
import {drawAxes, drawElement, kLeft} from "./plots.mjs";

/** Range of the last `count` points, with a margin. */
export function newestRange(points, count) {
  let [low, high] = [Infinity, -Infinity];
  for (const {low: values} of points.elements) {
    for (let i = Math.max(0, values.length - count); i < values.length; ++i) {
      if (values[i] < low) low = values[i];
      if (values[i] > high) high = values[i];
    }
  }
  if (!(low <= high) || !Number.isFinite(high - low)) return [0, 1];
  const room = (high - low || Math.abs(high) || 1) * 0.08;
  return [low - room, high + room];
}

/** Channels that the environment sends or reads, which most users look at first. */
function firstChannels(fields) {
  const known = new Set();
  nodes[0].outputs.forEach((_, o) => known.add(`0/${o}`));
  nodes[0].inputs.forEach((input) => known.add(input.source.join("/")));
  const chosen =
      data.channels.map((channel, c) => c)
          .filter((c) => c < fields.length && known.has(`${data.channels[c].node}/${data.channels[c].output}`));
  return new Set((chosen.length ? chosen : fields.map((_, f) => f)).slice(0, 5));
}

export class GrowingPlots {
  /**
   * `changed()` is called when the user chooses other channels. `history` is a StepHistory, or has the same members.
   */
  constructor(fields, changed = () => {}) {
    this.fields = fields;
    this.chosen = firstChannels(fields);
    this.stage = el("div.plots");
    this.chooser =
        el("details.channels", {}, el("summary", {}, "Channels"),
           fields.slice(0, 300).map(
               (field, f) =>
                   el("label", {}, el("input", {
                        type: "checkbox",
                        checked: this.chosen.has(f),
                        onchange: (event) => {
                          this.chosen[event.target.checked ? "add" : "delete"](f);
                          this.layOut();
                          this.draw();
                          changed();
                        }
                      }),
                      el("span", {}, breakable(field.name)))));
    this.history = null;
    this.layOut();
  }

  layOut() {
    this.rows = [...this.chosen].sort((a, b) => a - b).map((f) => {
      const canvas = el("canvas"), values = el("span.values");
      const more = this.fields[f].numbers > kPlottedElements ?
          `first ${kPlottedElements} of ${count(this.fields[f].numbers)} elements` :
          "";
      const element =
          el("article.plot", {},
             el("header", {}, el("span", {}, breakable(this.fields[f].name)), el("small", {}, more), values),
             el("div.cell", {}, canvas));
      return {f, canvas, values, element};
    });
    this.stage.replaceChildren(...this.rows.map((row) => row.element));
  }

  draw() {
    if (!this.history) return;
    const {end_s: end, kept_s: span} = this.history;
    const frame = {begin: Math.max(0, end - span), span};
    this.rows.forEach((row, r) => {
      const points = this.history.points(row.f);
      const width = Math.floor(row.canvas.parentElement.getBoundingClientRect().width);
      const last = r === this.rows.length - 1, height = last ? 104 : 88;
      const context = prepare(row.canvas, width, height);
      if (!context) return;
      const axes = drawAxes(context, width, height, newestRange(points, span / points.step), last, frame);
      context.save();
      context.beginPath();
      context.rect(kLeft, 0, width - kLeft, axes.bottom + 2);
      context.clip();
      points.elements.forEach((element, e) => drawElement(context, points, element, axes, shade(e), frame));
      context.restore();
      row.values.textContent = list(points.elements.map(({low}) => low[low.length - 1] ?? NaN), 4);
    });
  }
}
