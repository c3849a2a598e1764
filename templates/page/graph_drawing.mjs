// Drawing of the graph. The generator places the boxes; this module displays, pans and zooms the drawing.
import {onFrame} from "./canvas.mjs";
import {data} from "./data.mjs";
import {svg} from "./elements.mjs";
import {pathOf, unfold} from "./unfold.mjs";

export const graphView = {
  drawing: "user",
  zoom: 1,
  x: 0,
  y: 0,
  shown: null,
  moved: false,
  opened: new Set()  // names of composites
};
export const unfolded = {};  // drawings with open composites, by name

export const graphSvg = svg("svg", {
  class: "graph",
  tabindex: "0",
  role: "application",
  "aria-label": "Drawing of the graph. Arrow keys go from box to box, Enter opens and closes, plus and minus zoom."
});

function portTexts(box, ports, right) {
  return ports.map((port) => {
    const x = right ? box.x + box.width - 10 : box.x + 10, y = box.y + port.y + 4;
    const name = svg("text", {class: right ? "port out" : "port", x, y}, port.name);
    if (!port.detail) return name;
    return [name, svg("text", {class: right ? "detail out" : "detail", x, y: y + 13}, port.detail)];
  });
}

/** Sign that opens and closes a composite. */
function signOf(box) {
  const x = box.x + box.width - 24, y = box.y + 8;
  return svg(
      "g", {class: "sign"}, svg("title", {}, box.open ? "Close (Enter)" : "Open (Enter)"),
      svg("rect", {x, y, width: 16, height: 16, rx: 4}),
      svg("path", {d: `M${x + 4} ${y + 8}h8` + (box.open ? "" : "m-4 -4v8")}));
}

function boxElement(box) {
  const group =
      svg("g", {class: "box " + box.kind + (box.inside ? " composite" : "") + (box.open ? " open" : "")},
          svg("rect", {x: box.x, y: box.y, width: box.width, height: box.height, rx: 8}),
          svg("text", {class: "name", x: box.x + 10, y: box.y + 19}, box.title),
          svg("text", {class: "type", x: box.x + 10, y: box.y + 34}, box.subtitle), portTexts(box, box.inputs, false),
          portTexts(box, box.outputs, true), box.inside ? signOf(box) : null);
  if (box.about) group.append(svg("title", {}, `${box.name}: ${box.about}`));
  return group;
}

function wireElement(wire) {
  const [x, y] = wire.points[wire.points.length - 1], d = pathOf(wire.points, wire.backwards);
  return svg(
      "g", {class: wire.state ? "wire state" : "wire"}, svg("title", {}, wire.about), svg("path", {class: "near", d}),
      svg("path", {class: "line", d}), svg("path", {class: "tip", d: `M${x} ${y}l-8 -4v8z`}));
}

/** Elements of a drawing, created when it is first shown. */
export function drawingOf(name) {
  if (unfolded[name]) return unfolded[name];
  const drawing = unfolded[name] = unfold(data.drawings[name], graphView.opened);
  drawing.wireElements = drawing.wires.map(wireElement);
  drawing.boxElements = drawing.boxes.map(boxElement);
  const frames = drawing.boxElements.filter((_, i) => drawing.boxes[i].open);
  const others = drawing.boxElements.filter((_, i) => !drawing.boxes[i].open);
  drawing.group = svg("g", {class: "drawing"}, frames, drawing.wireElements, others);
  drawing.boxElements.forEach((element, i) => {
    element.item = {box: i};
  });
  drawing.wireElements.forEach((element, i) => {
    element.item = {wire: i};
  });
  return drawing;
}

export function place() {
  const {zoom, x, y} = graphView;
  cull();
  graphView.shown.group.setAttribute("transform", `translate(${x} ${y}) scale(${zoom})`);
  graphSvg.classList.toggle("far", zoom < 0.5);
  graphSvg.classList.toggle("farther", zoom < 0.25);
}
export const placeSoon = onFrame(place);

/** Bounding rectangle of points. */
function around(points) {
  const xs = points.map(([x]) => x), ys = points.map(([, y]) => y);
  const x = Math.min(...xs), y = Math.min(...ys);
  return {x, y, width: Math.max(...xs) - x, height: Math.max(...ys) - y};
}

/** Browsers lay out everything again when the scale changes, so a large graph shows only what is within the window. */
function cull() {
  const {shown, zoom, x, y} = graphView;
  if (shown.boxes.length < 200) return;
  const {width, height} = graphSvg.getBoundingClientRect();
  shown.around = shown.around || [...shown.boxes, ...shown.wires.map((wire) => around(wire.points))];
  shown.all = shown.all || [...shown.boxElements, ...shown.wireElements];
  shown.around.forEach((place, i) => {
    const left = x + place.x * zoom, top = y + place.y * zoom;
    const out = left > width || top > height || left + place.width * zoom < 0 || top + place.height * zoom < 0;
    if (place.out !== out) shown.all[i].classList.toggle("out", out);
    place.out = out;
  });
}

export function zoomGraph(factor, at) {
  const box = graphSvg.getBoundingClientRect();
  const [px, py] = at || [box.width / 2, box.height / 2];
  const zoom = Math.min(4, Math.max(0.02, graphView.zoom * factor));
  const real = zoom / graphView.zoom;
  graphView.moved = true;
  graphView.x = px - (px - graphView.x) * real;
  graphView.y = py - (py - graphView.y) * real;
  graphView.zoom = zoom;
  placeSoon();
}

export function fitGraph() {
  const box = graphSvg.getBoundingClientRect();
  const {width, height} = graphView.shown;
  if (!box.width || !box.height) return;
  const side = 16, above = 50, below = 16;  // the buttons are at the top
  const zoom = Math.min(2, (box.width - 2 * side) / width, (box.height - above - below) / height);
  graphView.zoom = zoom;
  graphView.moved = false;
  graphView.x = (box.width - width * zoom) / 2;
  graphView.y = above + (box.height - above - below - height * zoom) / 2;
  place();
}

/**
 * Fit button: shows the whole graph or, if its height limits the scale, the whole width from the top when pressed
 * again.
 */
export function fitGraphOrWidth() {
  const box = graphSvg.getBoundingClientRect(), {width, height} = graphView.shown;
  const {x, y, zoom, moved} = graphView;
  fitGraph();
  const same = !moved && zoom === graphView.zoom && x === graphView.x && y === graphView.y;
  const wide = Math.min(1.5, (box.width - 32) / width);
  if (!same || wide <= zoom || !(height > 0)) return;
  graphView.zoom = wide;
  graphView.x = (box.width - width * wide) / 2;
  graphView.y = 50;
  graphView.moved = true;
  place();
}

/** Shows the whole graph, or the beginning of a large one. */
export function beginGraph() {
  fitGraph();
  const readable = 0.5, [first] = graphView.shown.boxes;
  if (graphView.zoom >= readable) return;
  const box = graphSvg.getBoundingClientRect();
  graphView.zoom = readable;
  graphView.moved = true;
  graphView.x = 30 - first.x * readable;
  graphView.y = box.height / 2 - first.y * readable;
  place();
}

/** Centers boxes in the window, at a readable scale if possible. */
export function frame(boxes) {
  if (!boxes.length) return;
  graphView.moved = true;
  const left = Math.min(...boxes.map((box) => box.x)), right = Math.max(...boxes.map((box) => box.x + box.width));
  const top = Math.min(...boxes.map((box) => box.y)), bottom = Math.max(...boxes.map((box) => box.y + box.height));
  const place = graphSvg.getBoundingClientRect();
  const room = Math.min((place.width - 60) / (right - left), (place.height - 120) / (bottom - top));
  graphView.zoom = Math.min(room, Math.max(graphView.zoom, 0.8), 4);
  graphView.x = place.width / 2 - ((left + right) / 2) * graphView.zoom;
  graphView.y = 20 + place.height / 2 - ((top + bottom) / 2) * graphView.zoom;
  placeSoon();
}

export function isWithinWindow(box) {
  const {zoom, x, y} = graphView, place = graphSvg.getBoundingClientRect();
  const left = x + box.x * zoom, top = y + box.y * zoom;
  return left >= 0 && top >= 0 && left + box.width * zoom <= place.width && top + box.height * zoom <= place.height;
}
