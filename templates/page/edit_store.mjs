// State of the editor: the newest state of the server, the drawing of it, and the selection.
import {EditClient} from "./edit_client.mjs";
import {placedBoxes} from "./edit_layout.mjs";
import {modelOf} from "./edit_model.mjs";

export const editing = {
  model: modelOf(null, new Map()),
  places: [],          // positions of the boxes
  library: new Map(),  // entities by ID
  sections: {},        // keys that entries of sections can have
  // {section, name}, a connection {from, to}, an entity being added {adding: id, place}, or null for the graph itself
  selected: null,
  notice: ""  // what failed, and why
};

const editWatchers = [];
/** Registers `changed(what)`, which is called with "state", "selected", "library" or "notice". */
export function watchEditing(changed) {
  editWatchers.push(changed);
}
function tellEditing(what) {
  for (const changed of editWatchers) changed(what);
}

let folders = "";  // of entities, as written in the file

function takeState(why) {
  const {state} = editing.client, now = JSON.stringify(state.tree?.library ?? null);
  if (folders !== "" && folders !== now) learn().then(() => takeState());
  folders = now;
  if (why !== undefined) editing.notice = why;
  editing.model = modelOf(state.tree, editing.library);
  editing.places = placedBoxes(editing.model, state.layout ?? {});
  if (!isThere(editing.selected)) editing.selected = null;
  tellEditing("state");
}
editing.client = new EditClient(takeState);

export function say(notice) {
  editing.notice = notice;
  tellEditing("notice");
}

export function selectedBox() {
  const {selected, model} = editing;
  return selected && selected.name !== undefined ?
      model.boxes.findIndex(({section, name}) => section === selected.section && name === selected.name) :
      -1;
}

export function selectedWire() {
  const {selected, model} = editing;
  return selected && selected.from !== undefined ?
      model.wires.findIndex(({connection}) => connection.from === selected.from && connection.to === selected.to) :
      -1;
}

function isThere(selected) {
  return selected === null || selected.adding !== undefined || selectedBox() >= 0 || selectedWire() >= 0;
}

export function selectToEdit(selected) {
  editing.selected = selected;
  tellEditing("selected");
}

export function selectDrawn(drawn) {
  const {model} = editing;
  if (!drawn) return selectToEdit(null);
  if (drawn.wire !== undefined) {
    const {from, to} = model.wires[drawn.wire].connection;
    return selectToEdit({from, to});
  }
  const {section, name} = model.boxes[drawn.box];
  selectToEdit({section, name});
}

/** Sends edits. Returns true on success, and selects `then` unless the user has selected something else meanwhile. */
export async function change(edits, then) {
  const before = editing.selected;
  const problem = await editing.client.edit(edits);
  if (problem) say(problem);
  const isOther = JSON.stringify(then) !== JSON.stringify(editing.selected);
  if (!problem && then !== undefined && isOther && (editing.selected === before || !editing.selected))
    selectToEdit(then);
  return !problem;
}

export async function stepBack(which) {
  const problem = await editing.client[which]();
  if (problem) say(problem);
}

/** Fixes all boxes at their current positions. */
export function keepPlaces() {
  const places = editing.places.map(({x, y}) => [Math.round(x), Math.round(y)]);
  const all = Object.fromEntries(editing.model.boxes.map(({name}, b) => [name, places[b]]));
  editing.client.places(all);
  editing.places = placedBoxes(editing.model, all);
}

/** Saves the position of a box that is about to be added. */
export function keepPlaceOf(name, place) {
  editing.client.places({...editing.client.state.layout, [name]: place});
}

/** Discards all positions, and places the boxes automatically. */
export function arrange() {
  editing.client.places({});
  editing.places = placedBoxes(editing.model, {});
  tellEditing("state");
}

/** Requests the available entities and keys, both of which depend on the file's `library:`. */
async function learn() {
  const [library, schema] = await Promise.all([editing.client.get("library"), editing.client.get("schema")]);
  editing.library = new Map((library?.entities ?? []).map((entity) => [entity.id, entity]));
  editing.sections = schema?.sections ?? {};
  tellEditing("library");
}

export async function openGraph() {
  await learn();
  if (await editing.client.load())
    editing.client.followForEver();
  else
    say("no answer: `eagerx-gen serve` does not run any more");
}
