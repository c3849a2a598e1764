// Details of the selection: a node, an object, or a connection with its costs.
import {data, inputOf, nodes} from "./data.mjs";
import {add, breakable, button, el, pairs, table} from "./elements.mjs";
import {showInGraph, toggle} from "./graph.mjs";
import {graphView} from "./graph_drawing.mjs";
import {whyText} from "./memory.mjs";
import {bounds, bytes, count, counted, list, seconds, short} from "./numbers.mjs";
import {select, watch} from "./selection.mjs";
import {showLine} from "./source.mjs";
import {plotNode} from "./traces.mjs";
import {showView} from "./views.mjs";

const inspector = document.getElementById("inspector");

export function lineLink(line) {
  if (!line || !data.source.lines.length) return null;
  return button(`${data.source.name}:${line}`, () => showLine(line), {className: "plain", title: "Show the line"});
}

function nodeLink(number) {
  return button(nodes[number].name, () => select({node: number}), {className: "plain"});
}

export function inputLink(input, text) {
  return button(text, () => select({input: [input.node, input.number]}), {className: "plain"});
}

export function valueText(value) {
  return Array.isArray(value) ? `[${list(value)}]` : typeof value === "number" ? short(value, 6) : String(value);
}

function configTable(config) {
  if (!config.length) return null;
  return [
    el("h3", {}, "Parameters"),
    table(
        [
          {name: "name", cell: (item) => el("span", {title: item.about}, item.name)},
          {name: "value", cell: (item) => [valueText(item.value), item.unit ? el("small", {}, " " + item.unit) : null]},
          {name: "", cell: (item) => el("small", {}, item.given ? "given" : "default")},
        ],
        config)
  ];
}

export function randomText(random) {
  if (!random) return "set by the program only";
  const one = (values) => (values.length === 1 ? short(values[0], 6) : `[${list(values)}]`);
  switch (random.kind) {
    case "value":
      return `always ${one(random.first)}`;
    case "uniform":
      return `uniform, ${one(random.first)} … ${one(random.second)}`;
    case "log-uniform":
      return `log-uniform, ${one(random.first)} … ${one(random.second)}`;
    case "normal":
      return `normal, mean ${one(random.first)}, deviation ${one(random.second)}`;
    default:
      return `one of ${random.choices.map(one).join("; ")}`;
  }
}

function statesTable(states) {
  if (!states.length) return null;
  return [
    el("h3", {}, "States at a reset"),
    table(
        [
          {name: "name", cell: (item) => breakable(item.name)},
          {name: "sampled from", cell: (item) => randomText(item.random)},
        ],
        states)
  ];
}

export function settingsText(input) {
  const parts = [];
  if (input.processor) parts.push(`through ${input.processor.type}`);
  if (input.window !== 1) parts.push(input.window === 0 ? "all new messages" : `window ${input.window}`);
  if (input.longest_delay)
    parts.push(`delay up to ${seconds(input.longest_delay.seconds)}`);
  else if (input.delay.seconds > 0)
    parts.push(`delay ${seconds(input.delay.seconds)}`);
  if (input.skip) parts.push("skips the first message");
  return parts.join(", ");
}

function inputsTable(node) {
  if (!node.inputs.length) return null;
  return [
    el("h3", {}, node.number === 0 ? "Observations" : "Inputs"),
    el("ul.ports", {},
       node.inputs.map(
           (input) =>
               el("li", {}, inputLink(input, input.name), el("small", {}, ` ← ${input.from}`),
                  settingsText(input) ? el("small.block", {}, settingsText(input)) : null)))
  ];
}

function outputsTable(node) {
  if (!node.outputs.length) return null;
  return [
    el("h3", {}, node.number === 0 ? "Actions" : "Outputs"),
    el("ul.ports", {},
       node.outputs.map(
           (output, o) =>
               el("li", {}, el("b", {}, output.name),
                  el("small", {}, ` ${output.space.text}${output.unit ? ", " + output.unit : ""}`),
                  output.processor ? el("small.block", {}, `through ${output.processor.type}`) : null,
                  el("small.block", {}, bounds(output.space)),
                  node.readers[o].map((reader) => el("small.block", {}, "→ ", inputLink(reader, reader.written))))))
  ];
}

function imagePairs(name) {
  return data.images.filter((image) => image.size.nodes && image.size.nodes[name]).map((image) => {
    const used = image.size.nodes[name];
    return [image.name, `${bytes(used.flash)} flash, ${bytes(used.ram)} RAM`];
  });
}

function showNode(number) {
  const node = nodes[number];
  const held = node.rings.reduce((sum, ring) => sum + ring.bytes, 0);
  const plotted = data.logs.length && node.channels.some((channel) => channel !== null);
  return [
    el("p.kind", {}, node.role),
    el("h2", {}, node.name),
    node.about ? el("p", {}, node.about) : null,
    pairs([
      ["type", node.type], ["rate", `${node.rate} Hz, every ${seconds(1 / node.rate_hz)}`],
      [
        "object",
        node.object !== null ?
            button(data.objects[node.object].name, () => select({object: node.object}), {className: "plain"}) :
            null
      ],
      ["written in", lineLink(node.line)],
      ["buffers", node.rings.length ? `${node.rings.length}, ${bytes(held)}` : null], ...imagePairs(node.name)
    ]),
    el("p.actions", {}, button("Timetable", () => showView("timetable")), button("Graph", () => showInGraph()),
       plotted ? button("Plots", () => plotNode(number)) : null),
    inputsTable(node),
    outputsTable(node),
    configTable(node.config),
    statesTable(node.states),
  ];
}

function showObject(number) {
  const object = data.objects[number];
  const parts = nodes.filter((node) => node.object === number);
  return [
    el("p.kind", {}, "object"),
    el("h2", {}, object.name),
    object.about ? el("p", {}, object.about) : null,
    pairs([["type", object.type], ["made for", object.engine], ["written in", lineLink(object.line)]]),
    el("h3", {}, "Engine nodes"),
    el("ul.ports", {}, parts.map((node) => el("li", {}, nodeLink(node.number), el("small", {}, ` ${node.rate} Hz`)))),
    configTable(object.config),
    statesTable(object.states),
  ];
}

function showComposite(number) {
  const composite = data.composites[number];
  const isIn = ({name}, other) => name.startsWith(other.name + "/");
  const others = data.composites.filter((other) => isIn(other, composite));
  const isInside = (part) => isIn(part, composite) && !others.some((other) => isIn(part, other));
  const open = graphView.opened.has(composite.name);
  const link = (name, selected) =>
      button(name.slice(composite.name.length + 1), () => select(selected), {className: "plain"});
  return [
    el("p.kind", {}, "composite"),
    el("h2", {}, composite.name),
    composite.about ? el("p", {}, composite.about) : null,
    pairs([
      ["type", composite.type], ["rate", composite.rate ? `${composite.rate} Hz` : null],
      ["written in", lineLink(composite.line)]
    ]),
    el("p.actions", {},
       button(
           open ? "Close" : "Open",
           () => {
             showInGraph();
             toggle(composite.name);
             select({composite: number});
           })),
    el("h3", {}, "Inside"),
    el("ul.ports", {},
       [["composite", data.composites], ["object", data.objects]].map(
           ([kind, parts]) => parts.map(
               (part, i) =>
                   (isInside(part) ? el("li", {}, link(part.name, {[kind]: i}), el("small", {}, ` ${part.type}`)) :
                                     null))),
       nodes.filter((node) => isInside(node) && node.object === null)
           .map(
               (node) => el(
                   "li", {}, link(node.name, {node: node.number}), el("small", {}, ` ${node.type}, ${node.rate} Hz`)))),
  ];
}

/** Ratio of message rates as text: "2 messages a tick". */
function ratioText(hop) {
  if (!hop) return null;
  if (hop.a === hop.b) return "one message a tick";
  if (hop.b === 1) return `${hop.a} messages a tick`;
  if (hop.a === 1) return `one message in ${hop.b} ticks`;
  return `${hop.a} messages in ${hop.b} ticks`;
}

function showInput(n, i) {
  const input = nodes[n].inputs[i], source = nodes[input.source[0]];
  const output = source.outputs[input.source[1]];
  const ring = data.rings[input.ring];
  const sharing = nodes.flatMap((node) => node.inputs).filter((other) => other.ring === input.ring).length;
  const random = input.random_delay ? randomText(input.random_delay) + " s" : null;
  return [
    el("p.kind", {}, "connection"),
    el("h2", {}, `${input.from} → ${input.written}`),
    pairs([
      ["from", nodeLink(source.number)], ["to", nodeLink(n)], ["written in", lineLink(input.line)],
      ["rates", `${source.rate} Hz → ${nodes[n].rate} Hz`], ["received", ratioText(input.hop)],
      ["window", input.window === 0 ? "all new messages" : input.window],
      ["delay", input.delay.seconds ? `${input.delay.exact} s` : null],
      ["longest delay", input.longest_delay ? `${input.longest_delay.exact} s` : null], ["sampled from", random],
      ["skip", input.skip ? "reads the previous message, which cuts a loop" : null],
      ["processor", input.processor ? input.processor.type : null], ["space", input.space.text],
      ["bounds", bounds(input.space)]
    ]),
    el("h3", {}, "What it costs"),
    pairs([
      [
        "messages",
        `${bytes(output.space.bytes)} each, ${short(source.rate_hz)} a second: ${
            count(Math.round(output.space.bytes * source.rate_hz))} B/s`
      ],
      [
        "buffer",
        `${counted(ring.messages, "message")}, ${bytes(ring.bytes)}` +
            (sharing > 1 ? `, shared by ${sharing} connections` : "")
      ],
      ["of which it needs", counted(input.keep, "message")], ["size is due to", whyText(ring)],
      ["age, newest", input.hop ? `at most ${seconds(input.hop.newest.seconds)}` : "not by count"],
      ["age, oldest", input.hop && input.most > 1 ? `at most ${seconds(input.hop.oldest.seconds)}` : null]
    ]),
    input.processor ? configTable(input.processor.config) : null,
    el("p.actions", {}, button("Timetable", () => showView("timetable")), button("Graph", () => showInGraph())),
  ];
}

function showWholeWay(age) {
  return [
    el("p.kind", {}, "way of data"),
    el("h2", {}, `${age.sensor} → ${age.actuator}`),
    pairs([
      ["newest data", `at most ${seconds(age.newest.seconds)}`],
      ["oldest data", age.oldest ? `at most ${seconds(age.oldest.seconds)}` : "unknown"]
    ]),
    el("h3", {}, "Over"),
    el("ul.ports", {},
       age.way.map(
           (hop) =>
               el("li", {},
                  inputOf.has(hop.input) ?
                      inputLink(inputOf.get(hop.input), `${inputOf.get(hop.input).from} → ${hop.input}`) :
                      hop.input,
                  el("small.block", {}, hop.newest.seconds ? `+ ${seconds(hop.newest.seconds)}` : "at once")))),
    el("p.actions", {}, button("Ages", () => showView("ages"))),
  ];
}

function inspect(selected) {
  document.body.classList.toggle("inspecting", selected !== null);
  if (selected === null) return inspector.replaceChildren();
  const parts = selected.node !== undefined ? showNode(selected.node) :
      selected.object !== undefined         ? showObject(selected.object) :
      selected.composite !== undefined      ? showComposite(selected.composite) :
      selected.way                          ? showWholeWay(selected.way) :
                                              showInput(...selected.input);
  inspector.replaceChildren(button("×", () => select(null), {className: "close", title: "Close (Escape)"}));
  add(inspector, parts);
  inspector.scrollTop = 0;
}
watch(inspect);
