// Form of the selection: an object, a node, the actions or observations, a connection, or the graph.
import {askConnection, processorField} from "./edit_connect.mjs";
import {field, parameterFields, refill, shownValue} from "./edit_forms.mjs";
import {connectSelected, removeSelected} from "./edit_gestures.mjs";
import {graphForm} from "./edit_graph_form.mjs";
import {addForm} from "./edit_library.mjs";
import {keyField, part, setOrRemove} from "./edit_map_form.mjs";
import {takenNames} from "./edit_model.mjs";
import {sideOf} from "./edit_ports.mjs";
import {change, editing, keepPlaceOf, selectedBox, selectedWire, selectToEdit, watchEditing} from "./edit_store.mjs";
import {flowText, isName} from "./edit_values.mjs";
import {button, el} from "./elements.mjs";
import {bounds} from "./numbers.mjs";

const aboutOf = (section, name) => (editing.sections[section] ?? []).find((key) => key.name === name) ?? {};
const removeButton = (what, action) =>
    button(`Delete ${what}`, action, {className: "danger", title: `Delete ${what} (Delete)`});

function nameField(path, taken, key = "name") {
  const old = path.at(-1);
  return field({
    key,
    label: "name",
    value: old,
    fault: (text) =>
        (text === old        ? "" :
             !isName(text)   ? "letters, digits and _, a letter first" :
             taken.has(text) ? "there is one of this name" :
                               ""),
    changed: (name) => rename(path, name)
  });
}

function rename(path, name) {
  const [section, old] = path, b = editing.model.boxes.findIndex((box) => box.section === section && box.name === old);
  const place = b >= 0 && editing.client.state.layout?.[old];
  if (place) keepPlaceOf(name, place);
  const selected = editing.selected?.name === old ? {section, name} : editing.selected;
  return change([{kind: "rename", path, name}], selected);
}

/** Connections of a port, and a button that adds one. */
function portRow(b, side, number) {
  const {model} = editing, port = model.boxes[b][side][number], isOut = side === "outputs";
  const wires = model.wires.filter(
      (wire) => (isOut ? wire.from === b && wire.output === number : wire.to === b && wire.input === number));
  const space = [port.dtype, port.shape ? `[${port.shape.join(", ")}]` : "", port.unit].filter(Boolean).join(" ");
  return el(
      "li", {}, el("b", {}, port.name), space ? el("small", {}, ` ${space}`) : null,
      button(
          "Connect …",
          () => askConnection(
              isOut ? {from: port.address, to: "", section: ""} : {from: "", to: port.address, section: ""}),
          {className: "plain connect", "data-key": `connect.${side}.${port.name}`}),
      port.about ? el("small.block", {}, port.about) : null,
      wires.map(
          ({connection}) =>
              el("small.block", {}, isOut ? "→ " : "← ",
                 button(
                     isOut ? connection.to : connection.from,
                     () => selectToEdit({from: connection.from, to: connection.to}), {className: "plain"}))));
}

function portList(b, side, title) {
  const ports = editing.model.boxes[b][side];
  if (!ports.length) return null;
  return [el("h3", {}, title), el("ul.ports", {}, ports.map((_, number) => portRow(b, side, number)))];
}

const kDraws =
    ["uniform", "{value: 0.0}", "{uniform: {low: -1, high: 1}}", "{normal: {mean: 0, std: 1}}", "{choice: [0, 1]}"];

/** Bounds and unit of a state, without bounds that are long. */
function stateRange({low, high, unit}) {
  const isShort = low !== undefined && high !== undefined && [low].flat().length <= 3;
  return [isShort ? bounds({low: [low].flat(), high: [high].flat()}) : "", unit].filter(Boolean).join(" ");
}

function stateField(path, state, given) {
  return field({
    key: `states.${state.name}`,
    label: state.name,
    limits: stateRange(state),
    about: state.about,
    value: state.name in given ? shownValue(given[state.name]) : "",
    empty: "keeps its value",
    suggestions: kDraws,
    changed: (text) => setOrRemove([...path, "states", state.name], text)
  });
}

function stateFields(path, entity, given) {
  const states = entity?.states ?? [];
  return states.length ? part("states at a reset", "", states.map((state) => stateField(path, state, given)), true) :
                         null;
}

function boxForm(b) {
  const box = editing.model.boxes[b], {section, name, settings, entity} = box, path = [section, name];
  const others =
      (editing.sections[section] ?? []).filter((key) => !["type", "rate", "config", "states"].includes(key.name));
  const isObject = section === "objects";
  return [
    el("p.kind", {}, entity?.kind ?? (isObject ? "object" : "node")),
    el("h2", {}, box.type ?? (settings.policy ? "policy" : "no type")), box.about ? el("p", {}, box.about) : null,
    entity?.description ? el("details", {}, el("summary", {}, "More"), el("pre.description", {}, entity.description)) :
                          null,
    nameField(path, takenNames(editing.model)),
    entity ? null : keyField([...path, "type"], settings.type, {required: !settings.policy}),
    isObject ? null : keyField([...path, "rate"], settings.rate, {about: "in Hz", required: true}),
    parameterFields(entity, settings.config ?? {}, (key, value) => setOrRemove([...path, "config", key], value)),
    stateFields(path, entity, settings.states ?? {}),
    part("more keys", "", others.map((key) => keyField([...path, key.name], settings[key.name], key))),
    portList(b, "inputs", isObject ? "Actuators" : "Inputs"), portList(b, "outputs", isObject ? "Sensors" : "Outputs"),
    el("p.actions", {}, button("Connect … (c)", connectSelected), removeButton(name, removeSelected))
  ];
}

function endEntry(b, side, number) {
  const box = editing.model.boxes[b], {section} = box, port = box[side][number], path = [section, port.name];
  const settings = editing.model.top[section];
  const given = Array.isArray(settings) ? undefined : settings?.[port.name];
  const taken = new Set(box[side].map(({name}) => name));
  return el(
      "fieldset", {}, el("legend", {}, port.name), nameField(path, taken, `${section}.${port.name}.name`),
      keyField([...path, "space"], given?.space, aboutOf(section, "space")),
      el("ul.ports", {}, portRow(b, side, number)),
      button(`Delete ${port.name}`, () => change([{kind: "remove", path}]), {className: "danger"}));
}

function endForm(b) {
  const box = editing.model.boxes[b], side = sideOf(box.section), one = box.section.slice(0, -1);
  const taken = new Set(box[side].map(({name}) => name));
  const name = field({
    key: "new-end",
    label: `new ${one}`,
    fault: (text) =>
        (text && !isName(text) ? "letters, digits and _, a letter first" :
             taken.has(text)   ? "there is one of this name" :
                                 "")
  });
  const add = () =>
      (!name.text() || name.fault() ? name.input.focus() :
                                      change([{kind: "add", section: box.section, name: name.text()}]));
  name.input.addEventListener("keydown", (event) => event.key === "Enter" && add());
  return [
    el("p.kind", {}, "environment"), el("h2", {}, box.section), el("p", {}, `${box.subtitle}, at every step.`),
    box[side].map((_, number) => endEntry(b, side, number)), name, el("p.actions", {}, button("Add", add))
  ];
}

function setProcessor(path, type, given) {
  if (!type) return setOrRemove(path, "");
  return change([{kind: "set", path, value: given ? `{type: ${type}, config: ${flowText(given)}}` : type}]);
}

function processorParts(path, written) {
  if (Array.isArray(written)) return [keyField(path, written, {about: "processors, one after the other"})];
  const type = typeof written === "string" ? written : written?.type ?? "", given = written?.config ?? {};
  const entity = editing.library.get(type);
  const set = (name, value) => {
    const config = {...given, [name]: value};
    if (!value) delete config[name];
    const texts = Object.entries(config).map(([key, item]) => `${key}: ${key === name ? item : flowText(item)}`);
    return change([{kind: "set", path, value: texts.length ? `{type: ${type}, config: {${texts.join(", ")}}}` : type}]);
  };
  return [
    processorField({value: type, about: entity?.summary, changed: (chosen) => setProcessor(path, chosen, null)}),
    parameterFields(entity, given, set)
  ];
}

function connectionForm(w) {
  const {number, connection, from, to} = editing.model.wires[w], path = ["connections", number];
  const link = (b, text) => button(
      text, () => selectToEdit({section: editing.model.boxes[b].section, name: editing.model.boxes[b].name}),
      {className: "plain"});
  const keys = (editing.sections.connections ?? []).filter(({name}) => !["from", "to", "processor"].includes(name));
  return [
    el("p.kind", {}, "connection"), el("h2", {}, `${connection.from} → ${connection.to}`),
    el("p", {}, "from ", link(from, editing.model.boxes[from].name), " to ", link(to, editing.model.boxes[to].name)),
    keys.map((key) => keyField([...path, key.name], connection[key.name], key)),
    processorParts([...path, "processor"], connection.processor),
    el("p.actions", {}, removeButton("the connection", removeSelected))
  ];
}

export const inspectPanel = el("div.inspect", {"aria-label": "Selected", tabIndex: -1});

function showForm(what) {
  if (what === "notice" || what === "library") return;
  const {selected} = editing, b = selectedBox(), w = selectedWire();
  if (selected?.adding) {
    if (what === "state" && inspectPanel.querySelector("form")) return;  // keeps what is being typed
    const {form, begin} = addForm(selected);
    inspectPanel.replaceChildren(form);
    return begin();
  }
  const form = w >= 0                       ? connectionForm(w) :
      b < 0                                 ? graphForm() :
      editing.model.boxes[b].kind === "end" ? endForm(b) :
                                              boxForm(b);
  if (what === "selected") inspectPanel.scrollTop = 0;
  refill(inspectPanel, form);
}
watchEditing(showForm);
