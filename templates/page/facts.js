// What is fixed of the graph: spaces, parameters, what a reset draws, the task, safety; and the policies.
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
    for (const drawn of item.states)
      rows.push({what: `${item.name}.${drawn.name}`, space: drawn.space, random: drawn.random, selected});
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
            {name: "state or delay", cell: (row) => row.what},
            {name: "drawn", cell: (row) => randomText(row.random)},
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

function makeFactsView(panel) {
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
  if (data.info.why_no_packs)
    panel.append(card(
        "Many environments at once",
        el("p", {}, `They run one by one, not in packs of SIMD lanes: ${data.info.why_no_packs}.`)));
  return {shown() {}, resized() {}};
}

// ---- Policies -------------------------------------------------------------------------------------------------------
function normalizationCard(policy) {
  const {normalization} = policy.contract;
  if (!normalization) return null;
  const names = policy.contract.observations.flatMap(
      (part) => Array.from({length: part.size}, (_, i) => (part.size > 1 ? `${part.name}[${i}]` : part.name)));
  const rows =
      normalization.mean.map((mean, i) => ({mean, variance: normalization.variance[i], name: names[i] || String(i)}));
  return [
    el("h3", {}, "Normalised"),
    el("p.note", {},
       `(x − mean) / √(variance + ${short(normalization.epsilon)})` +
           (normalization.clip < 1e300 ? `, clipped to ±${short(normalization.clip)}` : "") +
           ` from ${normalization.source}`),
    table(
        [
          {name: "input", cell: (row) => row.name},
          {name: "mean", number: true, cell: (row) => short(row.mean, 5)},
          {name: "variance", number: true, cell: (row) => short(row.variance, 5)},
        ],
        rows, 40)
  ];
}

const meanings = {
  raw: "clipped to the bounds",
  squashed: "from −1 … 1 to the bounds",
  argmax: "the index of the largest output",
  binary: "1 where an output is above zero"
};

function useTable(title, rows) {
  return [
    el("h3", {}, title),
    table(
        [
          {name: "name", cell: (row) => row.name},
          {name: "space", cell: (row) => row.space},
          {name: "window", cell: (row) => (row.window === undefined || row.window === 1 ? "" : row.window)},
          {name: "bounds", cell: (row) => bounds(row)},
        ],
        rows)
  ];
}

function layersTable(policy) {
  const most = Math.max(1, ...policy.layers.map((layer) => layer.bytes));
  return [
    el("h3", {}, "Layers"),
    table(
        [
          {name: "", number: true, cell: (layer) => layer.number},
          {name: "from → to", cell: (layer) => `${layer.inputs} → ${layer.outputs}`},
          {name: "kind", cell: (layer) => layer.note || "dense"},
          {name: "parameters", number: true, cell: (layer) => count(layer.parameters)},
          {name: "multiply-adds", number: true, cell: (layer) => count(layer.multiply_adds)},
          {name: "flash, B", cell: (layer) => withBar(layer.bytes, most, "flash")},
        ],
        policy.layers.map((layer, i) => ({...layer, number: i + 1})))
  ];
}

function policyCard(policy) {
  const {contract, use, layers} = policy;
  const sum = (of) => layers.reduce((all, layer) => all + of(layer), 0);
  const rate = contract.rate_hz;
  return card(
      policy.name === "agent" ? `The agent: ${policy.file}` : `${policy.name}: ${policy.file}`, tiles([
        ["inputs", count(policy.inputs)], ["outputs", count(policy.outputs)],
        ["parameters", count(sum((l) => l.parameters))], ["flash", bytes(sum((l) => l.bytes))],
        ["multiply-adds", count(sum((l) => l.multiply_adds))],
        sum((l) => l.remembers) ? ["remembers", counted(sum((l) => l.remembers), "number")] : null
      ].filter(Boolean)),
      pairs([
        ["file", policy.format], ["written in", lineLink(use.line)], ["trained by", contract.algorithm],
        ["rate in training", rate ? `${short(rate)} Hz, here ${use.rate} Hz` : `not in the file; here ${use.rate} Hz`],
        ["action", meanings[use.kind]],
        [
          "bounds in training",
          contract.action_low.length ? `[${list(contract.action_low)}] … [${list(contract.action_high)}]` : null
        ],
        [
          "arithmetic",
          policy.profile === "fast" ? "as fast as the machine can: bits differ from build to build" :
                                      "the same bits on every machine"
        ],
        ["known answers", policy.known_answers ? `${policy.known_answers}, checked when a program starts` : null],
        ["assumed", policy.assumed.join("; ")], ["not used", list(policy.ignored, 12)]
      ]),
      useTable("What the graph gives it", use.inputs), useTable("What becomes of its answer", use.outputs),
      layersTable(policy), normalizationCard(policy));
}

function makePolicyView(panel) {
  panel.append(...data.policies.map(policyCard));
  return {shown() {}, resized() {}};
}
