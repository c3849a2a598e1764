// Form for a new connection: sender, receiver, and settings of the connection.
import {portTitle} from "./edit_drawing.mjs";
import {field, parameterFields, parametersOf} from "./edit_forms.mjs";
import {connectEdits, connectionKeys, endNameFor, fitOf, partnersOf, sideOf} from "./edit_ports.mjs";
import {change, editing} from "./edit_store.mjs";
import {isName} from "./edit_values.mjs";
import {button, el} from "./elements.mjs";

export const connectDialog = el("dialog.connect", {"aria-label": "New connection"});

export function portCalled(address) {
  for (const box of editing.model.boxes)
    for (const side of ["inputs", "outputs"])
      for (const port of box[side])
        if (port.address === address) return port;
  return null;
}

const kFitWords = ["needs a processor", "", "fits"];

/** Field for choosing a port, those that fit listed first. `known` is the port if it is already given. */
function portField(side, known, partner) {
  const label = side === "outputs" ? "from" : "to";
  const every = partner ? partnersOf(editing.model, partner, side) :
                          editing.model.boxes.flatMap((box) => box[side].map((port) => ({port, fit: 1})));
  const choices = every.map(({port, fit}) => [port.address, [
                              port.address, kFitWords[fit], side === "inputs" && port.taken ? "is connected" : ""
                            ].filter(Boolean).join(" – ")]);
  const end = side === "outputs" ? ["actions", "a new action"] : ["observations", "a new observation"];
  return field({
    key: label,
    label,
    value: known,
    choices: [...choices, end],
    empty: known ? undefined : "choose …",
    fault: (text) => (text ? "" : "choose a port")
  });
}

/** Field for the input whose bounds a new action copies. */
function boundsField() {
  const known =
      editing.model.boxes.flatMap(({kind, inputs}) => (kind === "object" ? inputs : [])).filter(({unsaid}) => !unsaid);
  return field({
    key: "like",
    label: "bounds of",
    value: "",
    empty: "the port that it is connected to",
    choices: known.map(({address}) => [address, address])
  });
}

function processorFields(type, holder) {
  const entity = editing.library.get(type), fields = parameterFields(entity);
  holder.replaceChildren(...(entity ? [el("small.block", {}, entity.summary)] : []), ...fields);
  return fields;
}

export function processorField(properties) {
  const all = [...editing.library.values()].filter(({kind}) => kind === "processor").map(({id}) => [id, id]);
  return field({key: "processor", label: "processor", empty: "none", choices: all, ...properties});
}

function submitConnection(form) {
  const ends = [form.from, form.to], wrong = [...ends, ...form.rest].filter((one) => one.fault());
  if (wrong.length) return wrong[0].input.focus();
  const processor = form.processor.text();
  const parameters = processor ? parametersOf(editing.library.get(processor), form.parameters) : {};
  if (!parameters) return;
  let [from, to] = ends.map((one) => one.text());
  const edits = [], section = from === "actions" ? from : to === "observations" ? to : "";
  if (section) {
    const name = form.name.text(), like = section === "actions" && form.like.text();
    edits.push({kind: "add", section, name, ...(like ? {keys: {space: `{like: ${like}}`}} : {})});
    if (section === "actions")
      from = `actions.${name}`;
    else
      to = `observations.${name}`;
  }
  const keys = connectionKeys(
      {window: form.window.text(), delay: form.delay.text(), skip: form.skip.text() === "true", processor, parameters});
  connectDialog.close();
  change([...edits, ...connectEdits(editing.model, from, to, keys)], {from, to});
}

/** Shows what is known about the two ends, and a field for the name of a new action or observation. */
function showEnds(form) {
  const from = form.from.text(), to = form.to.text();
  const section = from === "actions" ? from : to === "observations" ? to : "";
  form.name.hidden = form.like.hidden = !section;
  if (section !== "actions") form.like.hidden = true;
  const [output, input] = [portCalled(from), portCalled(to)];
  const other = section === "actions" ? input : output;
  if (section && !form.name.input.value) form.name.input.value = other ? endNameFor(editing.model, section, other) : "";
  const said = [output, input].filter(Boolean).map((port) => el("small.block", {}, portTitle(port)));
  if (output && input && fitOf(output, input) === 0)
    said.push(el("small.block.wrong", {}, "The spaces differ: a processor has to convert the messages."));
  if (input?.taken) said.push(el("small.block.wrong", {}, "It has a sender already: this one takes its place."));
  form.said.replaceChildren(...said);
}

function nameFault(form, text) {
  if (form.name.hidden) return "";
  if (!isName(text)) return "letters, digits and _, a letter first";
  const section = form.from.text() === "actions" ? "actions" : "observations";
  const box = editing.model.boxes.find((one) => one.section === section);
  return box[sideOf(section)].some(({name}) => name === text) ? "there is one of this name" : "";
}

/** {from, to}: addresses, or "" if the user chooses; `section`: the other end is a new action or observation. */
export function askConnection({from, to, section}) {
  const form = {parameters: []};
  form.from = portField("outputs", section === "actions" ? "actions" : from, portCalled(to));
  form.to = portField("inputs", section === "observations" ? "observations" : to, portCalled(from));
  form.name = field({key: "name", label: "its name", value: "", fault: (text) => nameFault(form, text)});
  form.like = boundsField();
  const holder = el("div.parameters");
  form.processor = processorField({value: ""});
  form.processor.input.addEventListener(
      "change", () => (form.parameters = processorFields(form.processor.text(), holder)));
  form.window = field({
    key: "window",
    label: "window",
    empty: "1",
    about: "how many of the last messages the receiver sees; 0: those that are new",
    fault: (text) => (/^\d*$/.test(text.trim()) ? "" : "a whole number")
  });
  form.delay = field(
      {key: "delay", label: "delay", limits: "s", empty: "0", about: "also 10 ms, or {uniform: {low: 0, high: 0.05}}"});
  form.skip = field({
    key: "skip",
    label: "skip",
    checked: false,
    about: "the receiver takes the message of the tick before: this breaks a circle"
  });
  form.rest = [form.name, form.window, form.delay];
  form.said = el("div.said");
  for (const end of [form.from, form.to]) end.input.addEventListener("change", () => showEnds(form));
  connectDialog.replaceChildren(
      el("form", {
        method: "dialog",
        onsubmit: (event) => {
          event.preventDefault();
          submitConnection(form);
        }
      },
         el("h2", {}, "New connection"), form.from, form.to, form.said, form.name, form.like, form.window, form.delay,
         form.skip, form.processor, holder,
         el("p.actions", {}, el("button.primary", {type: "submit"}, "Connect"),
            button("Cancel", () => connectDialog.close()))));
  showEnds(form);
  connectDialog.showModal();
  (section ? form.name : from && to ? form.window : from ? form.to : form.from).input.focus();
  if (section) form.name.input.select();
}
