// Compatibility of ports, and the edits that connect them.
import {freeName, yamlText} from "./edit_values.mjs";

const isKnown = (value) => typeof value === "number" || (typeof value === "string" && /^\d+$/.test(value));

/** Compatibility of an output and an input: 2 for equal spaces, 1 if unknown, 0 if they need a processor. */
export function fitOf(output, input) {
  if (output.dtype && input.dtype && output.dtype !== input.dtype) return 0;
  const [from, to] = [output.shape, input.shape];
  if (!output.dtype || !input.dtype || !Array.isArray(from) || !Array.isArray(to)) return 1;
  if (!from.every(isKnown) || !to.every(isKnown)) return 1;
  return from.length === to.length && from.every((size, i) => Number(size) === Number(to[i])) ? 2 : 0;
}

/** Ports on `side` that `port` can be connected to: {box, number, port, fit}, compatible and free ones first. */
export function partnersOf(model, port, side) {
  const found = model.boxes.flatMap(
      (box, b) => box[side].map(
          (other, number) =>
              ({box: b, number, port: other, fit: side === "inputs" ? fitOf(port, other) : fitOf(other, port)})));
  const rank = ({fit, port: other}) => fit * 2 - (side === "inputs" && other.taken ? 3 : 0);
  return found.filter(({port: other}) => other.address !== port.address).sort((a, b) => rank(b) - rank(a));
}

/** Keys of a connection in the file, without settings that equal their defaults. */
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

/** Edits that remove the connection to an input, which accepts only one sender. */
function freed(model, to) {
  return model.wires.filter(({connection}) => connection.to === to)
      .map(({number}) => number)
      .sort((a, b) => b - a)
      .map((number) => ({kind: "remove", path: ["connections", number]}));
}

/** Edits that connect two addresses. */
export function connectEdits(model, from, to, keys) {
  return [...freed(model, to), {kind: "connect", from, to, keys}];
}

/** Name of a new action or observation that is connected to `port`. */
export function endNameFor(model, section, port) {
  const taken = new Set(model.boxes.find((box) => box.section === section)[sideOf(section)].map(({name}) => name));
  return freeName(port.name.replace(/^.*\./, "").replace(/\W/g, "_"), taken);
}

export function sideOf(section) {
  return section === "actions" ? "outputs" : "inputs";
}
