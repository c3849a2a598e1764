// Form fields for any part of the file: existing keys, and keys that can be added.
import {field, shownValue} from "./edit_forms.mjs";
import {change} from "./edit_store.mjs";
import {button, el} from "./elements.mjs";

/** Sets the value at `path`, or removes it if the text is empty. */
export function setOrRemove(path, text) {
  const value = text.trim();
  return change([value ? {kind: "set", path, value} : {kind: "remove", path}]);
}

const isMapping = (value) => value !== null && typeof value === "object" && !Array.isArray(value);

/** Field for one key. `about`: {name, about, values, required} from the format, if known. */
export function keyField(path, value, about = {}) {
  const key = path.join("."), values = (about.values ?? []).map(({text}) => text);
  const isChoice =
      values.length > 0 && (value === undefined || value === null || values.includes(value)) && about.kind !== "map";
  return field({
    key,
    label: String(path.at(-1)),
    about: about.about,
    value: shownValue(value),
    empty: isChoice    ? "default" :
        about.required ? "required" :
                         "",
    choices: isChoice ? values.map((text) => [text, text]) : null,
    changed: (text) => setOrRemove(path, text)
  });
}

/** Row for a new key and its value. */
function newKey(path, keys) {
  const name = field({key: `${path.join(".")}+name`, label: "new", suggestions: keys.map((key) => key.name)});
  const value = field({key: `${path.join(".")}+value`, label: "value"});
  const add = () => {
    if (!name.text().trim() || !value.text().trim()) return (name.text().trim() ? value : name).input.focus();
    change([{kind: "set", path: [...path, name.text().trim()], value: value.text().trim()}]);
    name.input.value = value.input.value = "";
    name.input.focus();
  };
  for (const one of [name, value]) one.input.addEventListener("keydown", (event) => event.key === "Enter" && add());
  return el("div.new", {}, name, value, button("Add", add));
}

/** Fields for everything below `path`, and a row for a new key. `keys`: keys that the format allows there. */
export function mapFields(path, value, keys = [], depth = 0) {
  const about = new Map(keys.map((key) => [key.name, key]));
  const rows = Object.entries(isMapping(value) ? value : {}).map(([name, item]) => {
    const here = [...path, name];
    if (!isMapping(item) || depth > 2) return keyField(here, item, about.get(name));
    return el(
        "fieldset", {},
        el("legend", {}, name,
           button("×", () => setOrRemove(here, ""), {className: "plain remove", title: `Remove ${name}`})),
        mapFields(here, item, [], depth + 1));
  });
  return [...rows, newKey(path, keys.filter(({name}) => !isMapping(value) || !(name in value)))];
}

/** Collapsible part of a form, which stays open or closed when the form changes. */
const isOpen = new Map();
export function part(title, hint, children, open = false) {
  const details =
      el("details.part", {open: isOpen.get(title) ?? open},
         el("summary", {}, title, hint ? el("small", {}, ` ${hint}`) : null), children);
  details.addEventListener("toggle", () => isOpen.set(title, details.open));
  return details;
}
