// Form fields generated from manifests and from keys of the format, each with its problem next to it.
import {faultOf, flowText, limitsOf, parameterText} from "./edit_values.mjs";
import {el} from "./elements.mjs";

let fieldCount = 0;

function inputOfField({choices, value, empty, checked}) {
  if (checked !== undefined) return el("input", {type: "checkbox", checked});
  if (choices) {
    const known = choices.some(([choice]) => choice === value) || value === "";
    const all = [...(empty === undefined ? [] : [["", empty]]), ...choices, ...(known ? [] : [[value, value]])];
    const select = el("select", {}, all.map(([choice, text]) => el("option", {value: choice}, text)));
    select.value = value;
    return select;
  }
  const input = el("input", {type: "text", autocomplete: "off", spellcheck: false, placeholder: empty ?? ""});
  input.value = input.defaultValue = value;
  return input;
}

/**
 * Row of a form. {key: identifier of the field, label, about, limits, value, empty: meaning of an empty field, choices:
 * [[value, text]], suggestions: [text], checked, fault(text): reason why the text is invalid, or "", changed(text)}.
 * The row has `key`, `text()` and `fault()`.
 */
export function field(properties) {
  const {key, label, about, limits, suggestions, fault = () => "", changed, checked, choices} = properties;
  const id = `field-${++fieldCount}`;
  const list = suggestions?.length ?
      el("datalist", {id: `${id}-list`}, suggestions.map((text) => el("option", {value: text}))) :
      null;
  const input = inputOfField({...properties, value: properties.value ?? ""});
  input.id = id;
  input.dataset.key = key;
  if (list) input.setAttribute("list", list.id);
  const wrong = el("small.wrong", {role: "alert"});
  const row =
      el("div.field" + (checked !== undefined ? ".flag" : ""), {},
         el("label", {htmlFor: id}, label, limits ? el("small", {}, " " + limits) : null), input, wrong, list,
         about ? el("small.block", {}, about) : null);
  const text = () => (checked !== undefined ? String(input.checked) : input.value);
  const look = () => {
    wrong.textContent = fault(text());
    input.setAttribute("aria-invalid", wrong.textContent !== "");
    return wrong.textContent;
  };
  let sent = properties.value ?? text();
  const commit = () => {
    if (look() || text() === sent) return;
    sent = text();
    changed?.(sent);
  };
  input.addEventListener("input", () => wrong.textContent && look());
  input.addEventListener("change", commit);
  input.addEventListener("keydown", (event) => {
    if (event.key === "Escape" && changed && !choices && checked === undefined) input.value = sent;
    if (event.key === "Enter" && changed) commit();  // also commits the initial values of a new form
  });
  return Object.assign(row, {key, input, text, fault: look});
}

const required = (parameter) => parameter.default === undefined;

/** Fields for the parameters of an entity, required ones first. `given`: values in the file. */
export function parameterFields(entity, given = {}, changed = null) {
  const parameters = [...(entity?.config ?? [])].sort((a, b) => required(b) - required(a));
  return parameters.map((parameter) => {
    const whole = {...parameter, required: required(parameter)};
    const choices = parameter.type === "choice" ? parameter.options.map((option) => [option, option]) :
        parameter.type === "bool"               ? [["true", "true"], ["false", "false"]] :
                                                  null;
    const empty = required(parameter) ? "required" : flowText(jsonTexts(parameter.default));
    return field({
      key: `config.${parameter.name}`,
      label: parameter.name,
      about: parameter.about,
      limits: limitsOf(parameter),
      value: shownValue(given[parameter.name]),
      empty: choices && empty !== "required" ? `${empty} (default)` : empty,
      choices,
      fault: (text) => faultOf(whole, text),
      changed: changed && ((text) => changed(parameter.name, text.trim() ? parameterText(whole, text) : ""))
    });
  });
}

/** Value of the file as a field shows it: strings unchanged, everything else on one line. */
export function shownValue(value) {
  return typeof value === "string" ? value : flowText(value);
}

/** Converts numbers of JSON to strings, as in the tree of the file. */
function jsonTexts(value) {
  if (Array.isArray(value)) return value.map(jsonTexts);
  if (value && typeof value === "object")
    return Object.fromEntries(Object.entries(value).map(([key, item]) => [key, jsonTexts(item)]));
  return value === null || value === undefined ? value : String(value);
}

/**
 * Values of parameter fields as YAML, without empty ones, which stand for the default. If one is invalid, focuses it
 * and returns null.
 */
export function parametersOf(entity, fields) {
  const wrong = fields.filter((one) => one.fault());
  if (wrong.length) {
    wrong[0].input.focus();
    return null;
  }
  const values = {};
  for (const one of fields) {
    const parameter = (entity?.config ?? []).find(({name}) => one.key === `config.${name}`);
    if (parameter && one.text().trim()) values[parameter.name] = parameterText(parameter, one.text());
  }
  return values;
}

/** Replaces the content of `panel`, but keeps the focus and the text that is being typed. */
export function refill(panel, children) {
  const active = document.activeElement;
  const key = active?.dataset?.key, isHere = key && panel.contains(active);
  const kept = isHere ? {value: active.value, start: active.selectionStart, end: active.selectionEnd} : null;
  const wasTyped = isHere && active.tagName === "INPUT" && active.value !== active.defaultValue;
  panel.replaceChildren(...children.flat(3).filter(Boolean));
  if (!isHere) return;
  const again = [...panel.querySelectorAll("input, select, button")].find((other) => other.dataset.key === key);
  if (!again) return;
  again.focus();
  if (again.tagName !== "INPUT" || again.type === "checkbox") return;
  if (wasTyped) again.value = kept.value;
  again.setSelectionRange(kept.start, kept.end);
}
