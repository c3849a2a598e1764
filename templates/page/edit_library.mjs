// Library panel: search for entities that can be added, and the form that adds one.
import {editSvg, inDrawing} from "./edit_drawing.mjs";
import {field, parameterFields, parametersOf} from "./edit_forms.mjs";
import {takenNames} from "./edit_model.mjs";
import {change, editing, keepPlaceOf, selectToEdit} from "./edit_store.mjs";
import {freeName, isName, nameOfType} from "./edit_values.mjs";
import {button, el} from "./elements.mjs";

const kAddable = [["object", "Objects"], ["node", "Nodes"], ["reset node", "Reset nodes"]];

/** Rank of an entity in a search: 2 if its ID matches, 1 for its summary, 0 for its description, -1 for no match. */
function rankOf(entity, words) {
  const id = `${entity.id} ${nameOfType(entity.id).replaceAll("_", " ")}`.toLowerCase();
  const summary = `${id} ${entity.summary ?? ""}`.toLowerCase();
  const texts = [id, summary, `${summary} ${entity.description ?? ""}`.toLowerCase()];
  const first = texts.findIndex((text) => words.every((word) => text.includes(word)));
  return first < 0 ? -1 : 2 - first;
}

/** [[title, entities]]: entities that match all words of a text, best matches first. */
export function foundIn(library, text) {
  const words = text.toLowerCase().split(/\s+/).filter(Boolean);
  const byRank = (a, b) => b.rank - a.rank || a.entity.id.localeCompare(b.entity.id);
  const groups = kAddable.map(([kind, title]) => {
    const entities = [...library.values()].filter((entity) => entity.kind === kind);
    const found = entities.map((entity) => ({entity, rank: rankOf(entity, words)})).filter(({rank}) => rank >= 0);
    return {title, found: found.sort(byRank)};
  });
  return groups.filter(({found}) => found.length)
      .sort((a, b) => b.found[0].rank - a.found[0].rank)
      .map(({title, found}) => [title, found.map(({entity}) => entity)]);
}

/** Focuses the first field that is required and empty, or the name. */
function beginForm(fields) {
  (fields.find((one) => one.key.startsWith("config.") && one.fault() !== "" && one.text() === "") ?? fields[0])
      .input.focus();
  for (const one of fields) one.querySelector(".wrong").textContent = "";
}

export function beginAdding(id, place = null) {
  selectToEdit({adding: id, place});
}

/** Makes an entry draggable: the box appears where the entry is dropped on the drawing. */
function dragOut(entry, id) {
  let from = null;
  const shadow = el("div.shadow", {hidden: true}, id);
  entry.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    entry.wasDragged = false;
    from = [event.clientX, event.clientY];
    entry.setPointerCapture(event.pointerId);
  });
  entry.addEventListener("pointermove", (event) => {
    if (!from || Math.hypot(event.clientX - from[0], event.clientY - from[1]) < 6) return;
    if (shadow.hidden) document.body.append(shadow);
    shadow.hidden = false;
    shadow.style.left = `${event.clientX + 8}px`;
    shadow.style.top = `${event.clientY + 8}px`;
  });
  const end = (event) => {
    const wasDragged = !shadow.hidden;
    from = null;
    shadow.hidden = true;
    shadow.remove();
    if (!wasDragged || event.type !== "pointerup") return;
    const box = editSvg.getBoundingClientRect();
    const isOver = event.clientX >= box.left && event.clientX <= box.right && event.clientY >= box.top &&
        event.clientY <= box.bottom;
    entry.wasDragged = true;
    if (isOver) beginAdding(id, inDrawing(event).map(Math.round));
  };
  entry.addEventListener("pointerup", end);
  entry.addEventListener("pointercancel", end);
}

function entryOf(entity) {
  const entry = button([el("b", {}, entity.id), el("small.block", {}, entity.summary ?? "")], () => {
    if (entry.wasDragged) return void (entry.wasDragged = false);
    beginAdding(entity.id);
  }, {className: "entry", title: entity.summary});
  dragOut(entry, entity.id);
  return entry;
}

export function libraryPanel() {
  const search = el("input", {
    type: "search",
    placeholder: "Search the library",
    "aria-label": "Search the library",
    autocomplete: "off",
    spellcheck: false
  });
  const found = el("div.entries");
  const show = () => {
    const groups = foundIn(editing.library, search.value);
    found.replaceChildren(...groups.flatMap(([title, entities]) => [el("h3", {}, title), ...entities.map(entryOf)]));
    if (!groups.length) found.append(el("p.note", {}, "nothing"));
  };
  search.addEventListener("input", show);
  search.addEventListener("keydown", (event) => {
    const first = found.querySelector(".entry");
    if (event.key !== "Enter" && event.key !== "ArrowDown") return;
    event.preventDefault();
    if (event.key === "Enter")
      first?.click();
    else
      first?.focus();
  });
  found.addEventListener("keydown", (event) => {
    const entries = [...found.querySelectorAll(".entry")], at = entries.indexOf(document.activeElement);
    const step = {ArrowDown: 1, ArrowUp: -1}[event.key];
    if (!step || at < 0) return;
    (entries[at + step] ?? search).focus();
    event.preventDefault();
  });
  return {panel: el("div.library", {"aria-label": "Library"}, search, found), show, search};
}

/** Field for the engine. Objects need one, so the first object sets it. */
function engineField(entity) {
  if (entity.kind !== "object" || editing.model.top.engine) return null;
  const made = (entity.made_for ?? []).map(({engine}) => engine);
  const simulated = made.filter((id) => /ode|gym|dynamics/i.test(id)), choices = simulated.length ? simulated : made;
  return field({
    key: "engine",
    label: "engine",
    value: choices[0] ?? "",
    choices: made.map((id) => [id, id]),
    about: "what objects run on: the graph has none yet"
  });
}

function addEdits(entity, name, rate, engine, parameters) {
  const section = entity.kind === "object" ? "objects" : "nodes";
  const add = {kind: "add", section, name, type: entity.id, keys: rate ? {rate} : {}, parameters};
  const environment = editing.model.top.rate ?? "30";
  return engine ? [{kind: "set", path: ["engine"], value: `{type: ${engine}, rate: ${environment}}`}, add] : [add];
}

/** Form that adds an entity. */
export function addForm({adding, place}) {
  const entity = editing.library.get(adding), taken = takenNames(editing.model);
  const name = field({
    key: "name",
    label: "name",
    value: freeName(nameOfType(adding), taken),
    fault: (text) =>
        (!isName(text)       ? "letters, digits and _, a letter first" :
             taken.has(text) ? "there is one of this name" :
                               "")
  });
  const isNode = entity.kind !== "object";
  const rate = isNode ? field({
    key: "rate",
    label: "rate",
    limits: "Hz",
    value: editing.model.top.rate ?? "30",
    fault: (text) => (text.trim() ? "" : "required")
  }) :
                        null;
  const engine = engineField(entity), parameters = parameterFields(entity);
  const fields = [name, rate, engine, ...parameters].filter(Boolean);
  const submit = () => {
    const wrong = fields.filter((one) => one.fault());
    if (wrong.length) return wrong[0].input.focus();
    const values = parametersOf(entity, parameters), section = isNode ? "nodes" : "objects";
    if (place) keepPlaceOf(name.text(), place);
    const edits = addEdits(entity, name.text(), rate?.text().trim(), engine?.text(), values);
    editSvg.focus();
    return change(edits, {section, name: name.text()});
  };
  const form = el(
      "form", {
        onsubmit: (event) => {
          event.preventDefault();
          submit();
        }
      },
      el("p.kind", {}, `new ${entity.kind}`), el("h2", {}, entity.id), el("p", {}, entity.summary ?? ""),
      entity.description ? el("details", {}, el("summary", {}, "More"), el("pre.description", {}, entity.description)) :
                           null,
      fields,
      el("p.actions", {}, el("button.primary", {type: "submit"}, "Add"), button("Cancel", () => selectToEdit(null))));
  return {form, begin: () => beginForm(fields)};
}
