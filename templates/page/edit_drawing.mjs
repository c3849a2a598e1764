// Drawing in the editor: boxes with ports, wires, the selection, and problems.
import {onFrame} from "./canvas.mjs";
import {extentOf} from "./edit_layout.mjs";
import {drawnAs} from "./edit_model.mjs";
import {wireRoutes} from "./edit_routes.mjs";
import {portPlace} from "./edit_sizes.mjs";
import {editing, selectedBox, selectedWire, watchEditing} from "./edit_store.mjs";
import {svg} from "./elements.mjs";

export const editView = {
  zoom: 1,
  x: 0,
  y: 0,
  moved: false,     // by the user: then the view stays in place
  dragging: false,  // a box
  boxElements: [],
  wireElements: []
};
const drawn = svg("g", {class: "drawing"});
export const looseWire = svg("path", {class: "loose"});
export const editSvg =
    svg("svg", {
      class: "graph editor",
      tabindex: "0",
      role: "application",
      "aria-label":
          "Drawing of the graph. Arrow keys go from box to box, with Shift they move it, Enter goes to its form, " +
          "c connects it, Delete removes it."
    },
        svg("g", {class: "all"}, drawn, looseWire));

/** Position of a port in the drawing. */
export function portPoint(b, side, number) {
  const place = editing.places[b], [x, y] = portPlace(place, side, number);
  return [place.x + x, place.y + y];
}

function portElement(box, b, side, number) {
  const port = box[side][number], [x, y] = portPoint(b, side, number);
  const isMissing = side === "inputs" && box.kind === "node" && !port.taken && !port.optional && !port.unsaid;
  const isOut = side === "outputs";
  const name = [
    "port", isOut ? "output" : "", port.unsaid && (box.entity || box.kind === "end") ? "unsaid" : "",
    isMissing ? "missing" : ""
  ].filter(Boolean);
  const element = svg(
      "g", {class: name.join(" ")}, svg("title", {}, portTitle(port, isMissing)), svg("circle", {cx: x, cy: y, r: 5}),
      svg("text", {x: x + (isOut ? -12 : 12), y: y + 4, class: isOut ? "out" : "in"}, port.name));
  element.port = {box: b, side, number};
  return element;
}

/** Description of a port, such as "pendulum.u: float32 [1], V; voltage of the motor". */
export function portTitle(port, isMissing = false) {
  const space = [port.dtype, port.shape ? `[${port.shape.join(", ")}]` : "", port.unit].filter(Boolean).join(" ");
  return `${port.address}${space ? `: ${space}` : ""}${port.about ? `; ${port.about}` : ""}` +
      (isMissing ? "; nothing is connected to it" : "") + (port.unsaid ? "; the library knows of no such port" : "");
}

function boxOfEdit(box, b) {
  const {x, y, width, height} = editing.places[b];
  const element =
      svg("g", {class: `box ${box.kind}`}, box.about ? svg("title", {}, `${box.name}: ${box.about}`) : null,
          svg("rect", {x, y, width, height, rx: 8}), svg("text", {class: "name", x: x + 12, y: y + 20}, box.title),
          svg("text", {class: "type", x: x + 12, y: y + 36}, box.subtitle),
          ["inputs", "outputs"].map((side) => box[side].map((_, number) => portElement(box, b, side, number))),
          box.kind === "end" && !box.inputs.length && !box.outputs.length ?
              svg("text", {class: "type", x: x + 12, y: y + 58}, "none yet") :
              null);
  element.drawn = {box: b};
  return element;
}

function wireOfEdit(wire, w, d) {
  const {connection} = wire;
  const settings = ["window", "delay", "skip", "processor"].filter((key) => connection[key] !== undefined);
  const element = svg(
      "g", {class: connection.skip === "true" ? "wire state" : "wire"},
      svg("title", {}, `${connection.from} → ${connection.to}${settings.length ? ` (${settings.join(", ")})` : ""}`),
      svg("path", {class: "near", d}), svg("path", {class: "line", d}));
  element.drawn = {wire: w};
  return element;
}

/** {error, warning}: number of problems of each box and each wire. */
function faultsOf(model, problems) {
  const boxes = model.boxes.map(() => null), wires = model.wires.map(() => null);
  for (const problem of problems) {
    const place = drawnAs(model, problem.path);
    if (!place) continue;
    const [list, at] = place.box !== undefined ? [boxes, place.box] : [wires, place.wire];
    if (list[at] !== "error") list[at] = problem.severity;
  }
  return {boxes, wires};
}

function markEdit() {
  const b = selectedBox(), w = selectedWire();
  editView.boxElements.forEach((element, i) => element.classList.toggle("chosen", i === b));
  editView.wireElements.forEach((element, i) => {
    const {from, to} = editing.model.wires[i];
    element.classList.toggle("on", i === w || from === b || to === b);
  });
}

export function drawEdit() {
  const {model} = editing;
  const isFree = !Object.keys(editing.client.state?.layout ?? {}).length && !editView.dragging;
  const routes = wireRoutes(model, editing.places, isFree);
  editView.wireElements = model.wires.map((wire, w) => wireOfEdit(wire, w, routes[w]));
  editView.boxElements = model.boxes.map(boxOfEdit);
  const faults = faultsOf(model, editing.client.state?.problems ?? []);
  editView.boxElements.forEach((element, i) => faults.boxes[i] && element.classList.add("faulty", faults.boxes[i]));
  editView.wireElements.forEach((element, i) => faults.wires[i] && element.classList.add("faulty", faults.wires[i]));
  drawn.replaceChildren(...editView.wireElements, ...editView.boxElements);
  markEdit();
  if (!editView.moved) fitEdit();
}
watchEditing((what) => (what === "selected" ? markEdit() : what === "state" ? drawEdit() : null));

export function placeEdit() {
  editSvg.firstChild.setAttribute("transform", `translate(${editView.x} ${editView.y}) scale(${editView.zoom})`);
}
export const placeEditSoon = onFrame(placeEdit);

/** Position of a pointer event in the drawing. */
export function inDrawing({clientX, clientY}) {
  const box = editSvg.getBoundingClientRect();
  return [(clientX - box.left - editView.x) / editView.zoom, (clientY - box.top - editView.y) / editView.zoom];
}

export function fitEdit() {
  const box = editSvg.getBoundingClientRect();
  if (!box.width || !box.height || !editing.places.length) return;
  const all = extentOf(editing.places);
  editView.zoom = Math.max(0.2, Math.min(1.25, (box.width - 60) / all.width, (box.height - 60) / all.height));
  editView.x = (box.width - all.width * editView.zoom) / 2 - all.x * editView.zoom;
  editView.y = (box.height - all.height * editView.zoom) / 2 - all.y * editView.zoom;
  editView.moved = false;
  placeEdit();
}

export function zoomEdit(factor, at) {
  const box = editSvg.getBoundingClientRect();
  const [px, py] = at ?? [box.width / 2, box.height / 2];
  const zoom = Math.min(4, Math.max(0.05, editView.zoom * factor)), real = zoom / editView.zoom;
  editView.x = px - (px - editView.x) * real;
  editView.y = py - (py - editView.y) * real;
  editView.zoom = zoom;
  editView.moved = true;
  placeEditSoon();
}

/** Scrolls to a box that is outside the window. */
export function revealBox(b) {
  const place = editing.places[b], box = editSvg.getBoundingClientRect();
  if (!place) return;
  const {zoom} = editView, left = editView.x + place.x * zoom, top = editView.y + place.y * zoom;
  const isWithin =
      left >= 0 && top >= 0 && left + place.width * zoom <= box.width && top + place.height * zoom <= box.height;
  if (isWithin) return;
  editView.x = box.width / 2 - (place.x + place.width / 2) * zoom;
  editView.y = box.height / 2 - (place.y + place.height / 2) * zoom;
  editView.moved = true;
  placeEditSoon();
}
