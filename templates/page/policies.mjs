// Policies: their layers, their costs, and what their files say about the training.
import {data} from "./data.mjs";
import {card, el, pairs, table, tiles} from "./elements.mjs";
import {lineLink} from "./inspector.mjs";
import {withBar} from "./memory.mjs";
import {bounds, bytes, count, counted, list, short} from "./numbers.mjs";

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

export function makePolicyView(panel) {
  panel.append(...data.policies.map(policyCard));
  return {shown() {}, resized() {}};
}
