// Data that the generator embeds in the page, with indices for fast lookup. All of it comes from untrusted files, so it
// becomes text, never markup.
import {parse} from "./numbers.mjs";

// Data of a page that is served before its graph is valid for the first time.
const kNoGraph = {
  ...{
    info: {name: "", engine: "none", ages: []},
    schedule: {order: [], quantum: {seconds: 1}, hyperperiod: null, rates: []}
  },
  ...{agent: "zero", nodes: [], objects: [], composites: [], rings: [], channels: []},
  ...{
    policies: [], source: {name: "", lines: []}, diagnostics: [], images: [], logs: [], shows: ""
  }
};
const page = JSON.parse(document.getElementById("data").textContent);
export const data = page.nodes ? page : {...kNoGraph, ...page};

export const nodes = data.nodes;
nodes.forEach((node, number) => {
  node.number = number;
  node.rate_hz = parse(node.rate);
  node.rings = [];
  node.readers = node.outputs.map(() => []);
  node.channels = node.outputs.map(() => null);
});
nodes.forEach((node) => node.inputs.forEach((input, i) => {
  input.node = node.number;
  input.number = i;
  nodes[input.source[0]].readers[input.source[1]].push(input);
}));
data.rings.forEach((ring, number) => {
  ring.number = number;
  nodes[ring.node].rings.push(ring);
});
data.channels.forEach((channel, number) => {
  nodes[channel.node].channels[channel.output] = number;
});
export const inputOf = new Map();  // by the name that ages use
nodes.forEach((node) => node.inputs.forEach((input) => inputOf.set(input.written, input)));

export function outputName(node, o) {
  const output = nodes[node].outputs[o];
  return output.sensor || (node === 0 ? `actions.${output.name}` : `${nodes[node].name}.${output.name}`);
}

export function ageWay(age) {
  return age.way.map((hop) => inputOf.get(hop.input)).filter(Boolean);
}
