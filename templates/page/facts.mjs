// Constant properties of the graph: spaces, parameters, values that a reset samples, the task, safety.
import {data, inputOf, nodes} from "./data.mjs";
import {add, breakable, card, el, pairs, table, tiles} from "./elements.mjs";
import {lineLink, randomText, valueText} from "./inspector.mjs";
import {bounds, count, counted, list, seconds, short} from "./numbers.mjs";
import {select} from "./selection.mjs";

function spacesTable(ports, name) {
  return table(
      [
        {name: "name", cell: (port) => name(port)},
        {name: "space", cell: (port) => port.space.text},
        {name: "bounds", cell: (port) => bounds(port.space)},
        {
          name: "",
          cell: (port) => [port.unit, port.processor ? `through ${port.processor.type}` : ""].filter(Boolean).join(", ")
        },
      ],
      ports);
}

function parametersTable() {
  const rows = [];
  for (const [item, selected] of
           [...data.objects.map((object, i) => [object, {object: i}]), ...nodes.map((node, i) => [node, {node: i}])]) {
    // An engine node's parameters follow from its object.
    if (item.role === "engine node") continue;
    for (const parameter of item.config) rows.push({item, selected, parameter});
  }
  if (!rows.length) return null;
  return card(
      "Parameters",
      table(
          [
            {name: "of", cell: (row) => row.item.name},
            {name: "parameter", cell: (row) => row.parameter.name},
            {
              name: "value",
              cell: (row) =>
                  [valueText(row.parameter.value), el("small", {}, row.parameter.unit ? " " + row.parameter.unit : "")]
            },
            {name: "", cell: (row) => el("small", {}, row.parameter.given ? "given" : "default")},
            {name: "meaning", cell: (row) => row.parameter.about},
          ],
          rows, 100, (row) => select(row.selected)));
}

function randomTable() {
  const rows = [];
  for (const [item, selected] of
           [...data.objects.map((object, i) => [object, {object: i}]), ...nodes.map((node, i) => [node, {node: i}])])
    for (const state of item.states)
      rows.push({what: `${item.name}.${state.name}`, space: state.space, random: state.random, selected});
  for (const node of nodes)
    for (const input of node.inputs)
      if (input.random_delay)
        rows.push({
          what: `delay of ${input.written}, in s`,
          space: null,
          random: input.random_delay,
          selected: {input: [node.number, input.number]}
        });
  if (!rows.length) return null;
  return card(
      "What a reset sets",
      table(
          [
            {name: "state or delay", cell: (row) => breakable(row.what)},
            {name: "sampled from", cell: (row) => randomText(row.random)},
            {name: "space", cell: (row) => (row.space ? row.space.text : "")},
            {name: "bounds", cell: (row) => (row.space ? bounds(row.space) : "")},
          ],
          rows, 100, (row) => select(row.selected)));
}

function taskCard() {
  const {task} = data.info;
  if (!task) return null;
  const rows = [];
  for (const [name, term] of Object.entries(task.reward))
    rows.push(["reward", name, term.weight === 1 ? term.value : `${short(term.weight)} · (${term.value})`]);
  for (const what of ["terminated", "truncated", "success"])
    for (const [name, condition] of Object.entries(task[what])) rows.push([what, name, condition]);
  if (task.episode_steps) rows.push(["truncated", "", `after ${counted(task.episode_steps, "step")}`]);
  if (Object.keys(task.success).length)
    rows.push(["success", "", `over the last ${counted(task.success_steps, "step")}`]);
  return card(
      "Task", pairs(Object.entries(task.inputs)),
      table(
          [
            {name: "", cell: (row) => row[0]},
            {name: "name", cell: (row) => row[1]},
            {name: "value", cell: (row) => el("code", {}, row[2])},
          ],
          rows));
}

function safetyCard() {
  const {safety} = data;
  if (!safety) return null;
  return card("Safety", pairs([
                ["written in", lineLink(safety.line)],
                ["too late", `after ${seconds(safety.max_lateness.seconds)}, ${safety.late} times in a row`],
                ["missed", `${safety.missed} in a row`], ["recovers", `after ${safety.recover} in time`],
                ["link", `${seconds(safety.link_timeout.seconds)} without a message`],
                ["actions out of their space", safety.clips ? "are moved into it" : "give the safe action"],
                ["actions that are not finite", safety.holds ? "repeat the one before" : "give the safe action"],
                ...safety.actions.map((action) => [`safe ${action.name}`, `[${list(action.value)}]`])
              ]));
}

function delaysCard() {
  const {delays} = data.info;
  if (!delays.length) return null;
  return card(
      "Delays",
      table(
          [
            {name: "from", cell: (row) => row.from},
            {name: "to", cell: (row) => row.input},
            {name: "delay", number: true, cell: (row) => seconds(row.delay.seconds)},
            {name: "longest", number: true, cell: (row) => seconds(row.longest.seconds)},
          ],
          delays, 100,
          (row) =>
              inputOf.has(row.input) && select({input: [inputOf.get(row.input).node, inputOf.get(row.input).number]})));
}

export function makeFactsView(panel) {
  const environment = nodes[0];
  const parts = [
    card(null, tiles([
           ["rate", `${environment.rate} Hz`], ["engine", data.info.engine], ["agent", data.agent],
           ["numbers", data.real], ["nodes", count(nodes.length)], ["channels", count(data.channels.length)]
         ])),
    environment.outputs.length ? card("Actions", spacesTable(environment.outputs, (port) => port.name)) : null,
    environment.inputs.length ? card("Observations", spacesTable(environment.inputs, (port) => port.name)) : null,
    taskCard(),
    safetyCard(),
    randomTable(),
    delaysCard(),
    parametersTable(),
  ];
  add(panel, parts);
  if (data.info.why_not_vectorized)
    panel.append(card(
        "Many environments at once",
        el("p", {}, `They run one by one, not vectorized: ${data.info.why_not_vectorized}.`)));
  return {shown() {}, resized() {}};
}
