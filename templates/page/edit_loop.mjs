// Loop view of a page that is served. The server linearizes the graph, opened at the chosen port, and again after each
// change of a slider. It compiles the program once, because the sliders change only what a reset sets.
import {nodes, outputName} from "./data.mjs";
import {followRun, run} from "./edit_runs.mjs";
import {editing} from "./edit_store.mjs";
import {breakable, button, card, el} from "./elements.mjs";
import {loopCard} from "./loop_view.mjs";
import {numberControl} from "./simulation_controls.mjs";
import {moreViews} from "./views.mjs";

const kMostSliders = 64;
const kSettling_ms = 150;  // delay after the last change of a slider

/** Signals where a loop can be opened: single elements of what nodes and sensors send. */
export function portsOf(all) {
  const ports = [];
  for (const node of all) {
    if (node.role === "environment" || node.role === "engine") continue;
    node.outputs.forEach(({sensor, space}, o) => {
      if ((node.role !== "node" && !sensor) || !space.text.startsWith("float")) return;
      const name = outputName(node.number, o).split(", ")[0];
      for (let i = 0; i < space.numbers; ++i) ports.push(space.numbers > 1 ? `${name}[${i}]` : name);
    });
  }
  return ports;
}

/** Elements of all parameters, one after the other: {name, parameter, at, value, low, high}. */
export function slidersOf(parameters) {
  const rows = parameters.flatMap(
      (parameter) =>
          parameter.values.map((value, at) => ({
                                 name: parameter.values.length > 1 ? `${parameter.name}[${at}]` : parameter.name,
                                 parameter,
                                 at,
                                 value,
                                 low: parameter.low[at] ?? -Infinity,
                                 high: parameter.high[at] ?? Infinity,
                                 tunable: true
                               })));
  return rows.slice(0, kMostSliders);
}

/** Options of `linearize`: parameters that the user changed, with all their elements. */
export function optionsOf(port, moved) {
  return ["--open", port, ...[...moved].flatMap(([name, values]) => ["--at", `${name}=${values.join(",")}`])];
}

const kNoServer = "no answer: `eagerx-gen serve` does not run any more";

/** Runs `linearize` on the server. Returns {loop}, or {problem} with the message. */
async function linearized(words) {
  const {status, body} = await editing.client.call("./run", {kind: "linearize", arguments: words});
  if (status !== 200) return {problem: [body.error, body.help].filter(Boolean).join(": ")};
  do {  // the first run to finish may be an earlier one
    if (!await followRun()) return {problem: kNoServer};
  } while (run.id < body.id || (run.id === body.id && run.running));
  const loop = run.id === body.id && run.exit_code === 0 ? await editing.client.get("loop") : null;
  if (loop) return {loop};
  return {problem: run.lines.map(({text}) => text).join("\n") || "it was stopped"};
}

class LoopView {
  constructor(panel) {
    this.moved = new Map();  // values of parameters, by name
    this.ports =
        el("select", {"aria-label": "Where the loop is opened", onchange: () => this.open()},
           el("option", {value: ""}, "Open the loop at …"),
           portsOf(nodes).map((port) => el("option", {value: port}, port)));
    this.reset = button("As in the graph", () => this.open(), {disabled: true});
    this.status =
        el("p.note", {role: "status"}, "Choose a port. The first time, the program of the graph is compiled.");
    this.sliders = el("div");
    this.drawn = el("div");
    panel.append(el("div.toolbar", {}, this.ports, this.reset), this.status, this.sliders, this.drawn);
  }

  /** Opens the loop at another port, or resets the parameters to those of the graph. */
  open() {
    this.moved.clear();
    this.sliders.replaceChildren();
    this.ask();
  }

  move(row, value) {
    const values = this.moved.get(row.parameter.name) ?? [...row.parameter.values];
    values[row.at] = value;
    this.moved.set(row.parameter.name, values);
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.ask(), kSettling_ms);
  }

  /** Linearizes the graph. Of several requests during a run, only the last one counts. */
  async ask() {
    this.waits = true;
    if (this.asks) return;
    this.asks = true;
    while (this.waits && this.ports.value) {
      this.waits = false;
      this.status.textContent = "Linearizing …";
      this.reset.disabled = this.moved.size === 0;
      this.show(await linearized(optionsOf(this.ports.value, this.moved)));
    }
    this.asks = false;
  }

  show({loop, problem}) {
    this.status.textContent = loop ? "" : "There is no loop to show:";
    this.drawn.replaceChildren(loop ? loopCard(loop) : el("pre", {}, problem));
    if (!loop) return;
    if (!this.sliders.firstChild && loop.parameters.length) this.makeSliders(slidersOf(loop.parameters));
  }

  makeSliders(rows) {
    const controls = rows.map((row) => {
      const control = numberControl(row, (value) => this.move(row, value));
      control.around(row.value);
      control.show(row.value);
      return [el("span", {}, breakable(row.name)), el("span"), ...control.elements];
    });
    this.sliders.replaceChildren(card(
        "Parameters", el("p.note", {}, "What a reset sets. The graph keeps its values."),
        el("div.numbers", {}, controls)));
  }
}

function makeServedLoop(panel) {
  new LoopView(panel);
  return {shown() {}, resized() {}};
}
moreViews.set("loop", makeServedLoop);
