// Values of a graph's file as text: conversion to YAML, and validation of the user's input.

const kPlain = /^[A-Za-z_./][\w./-]*( [\w./-]+)*$/;
const kOther = /^(true|false|yes|no|on|off|null|~|nan|inf|\.nan|\.inf|[-+]?[0-9.]+(e[-+]?\d+)?)$/i;

/** Text as a YAML scalar, quoted if it would mean something else without quotes. */
export function yamlText(text) {
  return kPlain.test(text) && !kOther.test(text) ? text : JSON.stringify(text);
}

/** Value of the file's tree (strings, lists, mappings) as one line of YAML, for a form. */
export function flowText(value) {
  if (value === null || value === undefined) return "";
  if (Array.isArray(value)) return `[${value.map(flowText).join(", ")}]`;
  if (typeof value === "object")
    return `{${Object.entries(value).map(([key, item]) => `${key}: ${flowText(item)}`.trimEnd()).join(", ")}}`;
  const text = String(value);
  return /^[-+]?[0-9.]|^[$]/.test(text) && !/[,[\]{}:#]/.test(text) || kPlain.test(text) ? text : JSON.stringify(text);
}

/** True if a text is a valid name of an object, a node or an action. */
export function isName(text) {
  return /^[A-Za-z][A-Za-z0-9_]*$/.test(text);
}

/** Name for an entity type: `butterworth_filter` for `ButterworthFilter`. */
export function nameOfType(id) {
  return id.replace(/([a-z0-9])([A-Z])/g, "$1_$2").replace(/([A-Z])([A-Z][a-z])/g, "$1_$2").toLowerCase();
}

/** `name`, with a number appended if `taken` already contains it. */
export function freeName(name, taken) {
  if (!taken.has(name)) return name;
  let number = 2;
  while (taken.has(`${name}_${number}`)) ++number;
  return `${name}_${number}`;
}

/** Numbers in "1, 2" or "[1, 2]"; null if the text is not a list of numbers. */
export function numberList(text) {
  const inner = /^\[(.*)\]$/s.exec(text.trim())?.[1] ?? text;
  const words = inner.split(/[,\s]+/).filter(Boolean);
  const numbers = words.map(Number);
  return words.length && numbers.every(Number.isFinite) ? numbers : null;
}

function outOfBounds({low, high}, number) {
  if (typeof low === "number" && number < low) return `at least ${low}`;
  if (typeof high === "number" && number > high) return `at most ${high}`;
  return "";
}

/** Reason why a text is invalid as the value of a parameter; "" if it is valid, or only the generator can tell. */
export function faultOf(parameter, text) {
  const trimmed = text.trim();
  if (trimmed === "") return parameter.required ? "required" : "";
  if (/^[{$]/.test(trimmed)) return "";  // {each: …}, {csv: …}, $(index)
  const isOne = parameter.type === "int" || parameter.type === "float";
  if (isOne || parameter.type === "ints" || parameter.type === "floats") {
    if (/[A-Za-zµμ]$/.test(trimmed) && parameter.unit) return "";  // with an explicit unit
    if (isOne && /^[-+]?\d+\/\d+$/.test(trimmed)) return "";
    const numbers = numberList(trimmed);
    if (!numbers || (isOne && (numbers.length !== 1 || trimmed.startsWith("["))))
      return isOne ? "a number" : "numbers: [1, 2]";
    if (parameter.type.startsWith("int") && !numbers.every(Number.isInteger)) return "whole numbers only";
    return numbers.map((number) => outOfBounds(parameter, number)).find(Boolean) ?? "";
  }
  if (parameter.type === "bool" && !/^(true|false)$/.test(trimmed)) return "true or false";
  if (parameter.type === "choice" && !parameter.options.includes(trimmed))
    return `one of ${parameter.options.join(", ")}`;
  return "";
}

/** User input for a parameter, as YAML. */
export function parameterText(parameter, text) {
  const trimmed = text.trim();
  if (/^[{$[]/.test(trimmed) && parameter.type !== "string") return trimmed;
  if (parameter.type === "floats" || parameter.type === "ints") return trimmed.includes(",") ? `[${trimmed}]` : trimmed;
  if (parameter.type === "string" || parameter.type === "choice") return yamlText(trimmed);
  return trimmed;
}

/** Type, range, unit and default of a parameter, such as "float, 0 … 10 Hz, default 2". */
export function limitsOf(parameter) {
  const {type, unit, low, high} = parameter;
  const range = low !== undefined && high !== undefined ? `${low} … ${high}` :
      low !== undefined ? `at least ${low}` :
      high !== undefined ? `at most ${high}` :
                           "";
  return [type === "choice" ? "" : type, [range, unit].filter(Boolean).join(" ")].filter(Boolean).join(", ");
}
