// Pointer and keyboard input of the drawing: moves boxes, connects ports with wires, and navigates between boxes.
import {askConnection} from "./edit_connect.mjs";
import {
  drawEdit,
  editSvg,
  editView,
  fitEdit,
  inDrawing,
  looseWire,
  placeEditSoon,
  portPoint,
  revealBox,
  zoomEdit
} from "./edit_drawing.mjs";
import {hitAt, targetAt} from "./edit_layout.mjs";
import {fitOf} from "./edit_ports.mjs";
import {loosePath} from "./edit_routes.mjs";
import {change, editing, keepPlaces, selectDrawn, selectedBox, selectedWire} from "./edit_store.mjs";

const opposite = (side) => (side === "outputs" ? "inputs" : "outputs");
const portAt = ({box, side, number}) => editing.model.boxes[box][side][number];

let gesture = null;  // {kind: "box" | "wire" | "pan", from: [x, y] in the window, far, …}

function beginGesture(event) {
  if (event.button !== 0 || gesture) return;
  const [x, y] = inDrawing(event), hit = hitAt(editing.model, editing.places, x, y);
  gesture = {kind: "pan", from: [event.clientX, event.clientY], last: [event.clientX, event.clientY], far: false, hit};
  if (hit?.number !== undefined)
    gesture.kind = "wire";
  else if (hit) {
    gesture.kind = "box";
    const place = editing.places[hit.box];
    gesture.grip = [x - place.x, y - place.y];
  }
}

/** Highlights ports where the wire can end. */
function showPartners(start) {
  const port = portAt(start), side = opposite(start.side);
  for (const element of editSvg.querySelectorAll("g.port")) {
    const place = element.port;
    if (place.side !== side || place.box === undefined) continue;
    const other = portAt(place);
    const fit = start.side === "outputs" ? fitOf(port, other) : fitOf(other, port);
    element.classList.add(["differs", "perhaps", "fits"][fit]);
  }
  editSvg.classList.add("connecting");
}

function endConnecting() {
  looseWire.setAttribute("d", "");
  editSvg.classList.remove("connecting");
  for (const element of editSvg.querySelectorAll("g.port"))
    element.classList.remove("differs", "perhaps", "fits", "target");
}

function pullWire(event) {
  const {hit} = gesture, side = opposite(hit.side);
  const start = portPoint(hit.box, hit.side, hit.number), here = inDrawing(event);
  looseWire.setAttribute("d", hit.side === "outputs" ? loosePath(start, here) : loosePath(here, start));
  const target = targetAt(editing.model, editing.places, side, ...here);
  for (const element of editSvg.querySelectorAll("g.port")) {
    const {box, side: which, number} = element.port;
    element.classList.toggle(
        "target", target !== null && box === target.box && which === side && number === target.number);
  }
}

function moveGesture(event) {
  if (!gesture) return;
  const far = Math.hypot(event.clientX - gesture.from[0], event.clientY - gesture.from[1]);
  if (!gesture.far) {
    if (far < 4) return;
    gesture.far = true;
    editSvg.setPointerCapture(event.pointerId);
    if (gesture.kind === "wire") showPartners(gesture.hit);
  }
  if (gesture.kind === "wire")
    pullWire(event);
  else if (gesture.kind === "box") {
    const [x, y] = inDrawing(event), place = editing.places[gesture.hit.box];
    place.x = x - gesture.grip[0];
    place.y = y - gesture.grip[1];
    editView.moved = editView.dragging = true;
    drawEdit();
  } else {
    editView.x += event.clientX - gesture.last[0];
    editView.y += event.clientY - gesture.last[1];
    editView.moved = true;
    placeEditSoon();
  }
  gesture.last = [event.clientX, event.clientY];
}

function endWire(hit, event) {
  const side = opposite(hit.side), target = targetAt(editing.model, editing.places, side, ...inDrawing(event));
  if (!target) return;
  const section = target.number < 0 ? editing.model.boxes[target.box].section : "";
  const mine = portAt(hit).address, other = section ? "" : portAt(target).address;
  if (hit.side === "outputs")
    askConnection({from: mine, to: other, section});
  else
    askConnection({from: other, to: mine, section});
}

function wireUnder(event) {
  const wire = event.target.closest?.("g.wire");
  return wire ? wire.drawn : null;
}

function endGesture(event) {
  if (!gesture) return;
  const {kind, far, hit} = gesture;
  gesture = null;
  editView.dragging = false;
  endConnecting();
  if (event.type !== "pointerup") return drawEdit();
  if (!far) return selectDrawn(hit ? {box: hit.box} : wireUnder(event));
  if (kind === "wire") endWire(hit, event);
  if (kind === "box") keepPlaces();
}

/** Deletes the selection. */
export function removeSelected() {
  const b = selectedBox(), w = selectedWire(), {model} = editing;
  if (w >= 0) return change([{kind: "remove", path: ["connections", model.wires[w].number]}], null);
  if (b < 0 || model.boxes[b].kind === "end") return false;
  return change([{kind: "remove", path: [model.boxes[b].section, model.boxes[b].name]}], null);
}

/** Nearest box in a direction. */
export function boxBeside(places, from, dx, dy) {
  if (from < 0) return 0;
  const middle = ({x, y, width, height}) => [x + width / 2, y + height / 2];
  const [x, y] = middle(places[from]);
  let best = from, least = Infinity;
  places.forEach((place, b) => {
    const [px, py] = middle(place), along = (px - x) * dx + (py - y) * dy;
    const distance = along + 2 * Math.abs((px - x) * dy + (py - y) * dx);
    if (b === from || along <= 1 || distance >= least) return;
    least = distance;
    best = b;
  });
  return best;
}

const kEditArrows = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1]
};
function arrowKey([dx, dy], isMoving) {
  const b = selectedBox();
  if (isMoving && b >= 0) {
    editing.places[b].x += 10 * dx;
    editing.places[b].y += 10 * dy;
    editView.moved = true;
    keepPlaces();
    return drawEdit();
  }
  const next = boxBeside(editing.places, b, dx, dy);
  selectDrawn({box: next});
  revealBox(next);
}

/** Opens the form that connects the selected box. */
export function connectSelected() {
  const box = editing.model.boxes[selectedBox()];
  const output = box?.outputs.find(({used}) => !used) ?? box?.outputs[0], input = box?.inputs.find(({taken}) => !taken);
  if (output)
    askConnection({from: output.address, to: "", section: ""});
  else if (input)
    askConnection({from: "", to: input.address, section: ""});
}

function editKey(event) {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const arrow = kEditArrows[event.key];
  if (arrow)
    arrowKey(arrow, event.shiftKey);
  else if (event.key === "Delete" || event.key === "Backspace")
    removeSelected();
  else if (event.key === "Enter")
    document.querySelector(".inspect")?.querySelector("input, select")?.focus();
  else if (event.key === "c")
    connectSelected();
  else if (event.key === "Escape")
    selectDrawn(null);
  else if (event.key === "+" || event.key === "=")
    zoomEdit(1.25);
  else if (event.key === "-")
    zoomEdit(0.8);
  else if (event.key === "0")
    fitEdit();
  else
    return;
  event.preventDefault();
  event.stopPropagation();
}

editSvg.addEventListener("pointerdown", beginGesture);
editSvg.addEventListener("pointermove", moveGesture);
editSvg.addEventListener("pointerup", endGesture);
editSvg.addEventListener("pointercancel", endGesture);
editSvg.addEventListener("keydown", editKey);
editSvg.addEventListener("wheel", (event) => {
  event.preventDefault();
  const box = editSvg.getBoundingClientRect(), lines = event.deltaMode === 1 ? 16 : 1;
  zoomEdit(
      Math.exp(-event.deltaY * lines * (event.ctrlKey ? 0.01 : 0.0015)),
      [event.clientX - box.left, event.clientY - box.top]);
}, {passive: false});
