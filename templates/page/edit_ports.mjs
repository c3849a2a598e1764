// Which ports fit together, and the edits that connect them.
import {freeName, yamlText} from "./edit_values.mjs";

const isKnown = (value) => typeof value === "number" || (typeof value === "string" && /^\d+$/.test(value));

/** Of an output and an input: 2 the same space, 1 perhaps, 0 a processor would be needed. */
export function fitOf(output, input) {
  if (output.dtype && input.dtype && output.dtype !== input.dtype) return 0;
  const [from, to] = [output.shape, input.shape];
  if (!output.dtype || !input.dtype || !Array.isArray(from) || !Array.isArray(to)) return 1;
  if (!from.every(isKnown) || !to.every(isKnown)) return 1;
  return from.length === to.length && from.every((size, i) => Number(size) === Number(to[i])) ? 2 : 0;
}

/** Ports of `side` that `port` can be connected to: {box, number, port, fit}, those that fit and are free first. */
export function partnersOf(model, port, side) {
  const found = model.boxes.flatMap(
      (box, b) => box[side].map(
          (other, number) =>
              ({box: b, number, port: other, fit: side === "inputs" ? fitOf(port, other) : fitOf(other, port)})));
  const rank = ({fit, port: other}) => fit * 2 - (side === "inputs" && other.taken ? 3 : 0);
  return found.filter(({port: other}) => other.address !== port.address).sort((a, b) => rank(b) - rank(a));
}

/** Settings of a connection as the file has them: only those that say something. */
export function connectionKeys({window, delay, skip, processor, parameters}) {
  const keys = {};
  if (window?.trim() && window.trim() !== "1") keys.window = window.trim();
  if (delay?.trim() && delay.trim() !== "0") keys.delay = delay.trim();
  if (skip) keys.skip = "true";
  if (processor) {
    const given = Object.entries(parameters ?? {}).map(([name, value]) => `${name}: ${value}`);
    keys.processor = given.length ? `{type: ${processor}, config: {${given.join(", ")}}}` : yamlText(processor);
  }
  return keys;
}

/** Removes what an input has already: it gets one message at a time from one sender. */
function freed(model, to) {
  return model.wires.filter(({connection}) => connection.to === to)
      .map(({number}) => number)
      .sort((a, b) => b - a)
      .map((number) => ({kind: "remove", path: ["connections", number]}));
}

/** The edits of a new connection between two addresses. */
export function connectEdits(model, from, to, keys) {
  return [...freed(model, to), {kind: "connect", from, to, keys}];
}

/** A name for a new action or observation that is connected to `port`. */
export function endNameFor(model, section, port) {
  const taken = new Set(model.boxes.find((box) => box.section === section)[sideOf(section)].map(({name}) => name));
  return freeName(port.name.replace(/^.*\./, "").replace(/\W/g, "_"), taken);
}

export function sideOf(section) {
  return section === "actions" ? "outputs" : "inputs";
}
