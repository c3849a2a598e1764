// Selection in the drawing.
import {ageWay, data, nodes} from "./data.mjs";
import {graphSvg, graphView} from "./graph_drawing.mjs";
import {select, state, watch} from "./selection.mjs";
import {holds} from "./unfold.mjs";

export function nameOf({node, object, composite}) {
  if (node !== undefined) return nodes[node].name;
  return (object !== undefined ? data.objects[object] : data.composites[composite]).name;
}

/** Selected connections; null if something else is selected. */
export function inputsOf({input, way}) {
  if (way) return ageWay(way).map((hop) => [hop.node, hop.number]);
  return input ? [input] : null;
}

export function boxOf(drawing, selected) {
  if (inputsOf(selected)) return -1;
  const find = (is) => {
    const own = drawing.boxes.findIndex(is);
    return own >= 0 ? own : drawing.boxes.findIndex((box) => !box.open && holds(box, is));
  };
  if (selected.composite !== undefined) {
    const {name} = data.composites[selected.composite];
    return find((box) => box.composite === name);
  }
  if (selected.object !== undefined) return find((box) => box.object === selected.object);
  const own = find((box) => box.node === selected.node);
  if (own >= 0 || nodes[selected.node].object === null) return own;
  return find((box) => box.object === nodes[selected.node].object);
}

/** Indices of all wires of a connection, which crosses the frames of composites. */
export function wiresOf(drawing, [node, input]) {
  return drawing.wires.flatMap(
      ({readers}, w) => (readers.some((reader) => reader[0] === node && reader[1] === input) ? [w] : []));
}

export function markGraph() {
  const drawing = graphView.shown;
  if (!drawing) return;
  const boxes = new Set(), wires = new Set(), chosen = new Set();
  const withEnds = (w) => {
    wires.add(w);
    boxes.add(drawing.wires[w].from).add(drawing.wires[w].to);
  };
  const {selected} = state;
  if (selected && inputsOf(selected)) {
    for (const w of inputsOf(selected).flatMap((input) => wiresOf(drawing, input))) withEnds(w);
  } else if (selected) {
    const b = boxOf(drawing, selected);
    chosen.add(b);
    boxes.add(b);
    drawing.wires.forEach((wire, w) => {
      if (wire.from === b || wire.to === b) withEnds(w);
    });
  }
  // Also mark frames around marked boxes, and the boxes in a selected frame.
  drawing.boxes.forEach((box, b) => {
    for (let frame = box.around; frame !== undefined; frame = drawing.boxes[frame].around) {
      if (boxes.has(b)) boxes.add(frame);
      if (chosen.has(frame)) boxes.add(b);
    }
  });
  graphSvg.classList.toggle("marked", boxes.size > 0 && !boxes.has(-1));
  drawing.boxElements.forEach((element, i) => {
    element.classList.toggle("on", boxes.has(i));
    element.classList.toggle("chosen", chosen.has(i));
  });
  drawing.wireElements.forEach((element, i) => element.classList.toggle("on", wires.has(i)));
}
watch(markGraph);

export function selectBox(b) {
  const box = graphView.shown.boxes[b];
  if (box.inside)
    select({composite: data.composites.findIndex(({name}) => name === box.composite)});
  else
    select(box.node !== null ? {node: box.node} : {object: box.object});
}

/** Nearest box in the direction of an arrow key. */
export function neighbour(dx, dy) {
  const {boxes} = graphView.shown;
  const from = state.selected ? boxOf(graphView.shown, state.selected) : -1;
  if (from < 0) return 0;
  const middle = (box) => [box.x + box.width / 2, box.y + box.height / 2];
  const [x, y] = middle(boxes[from]);
  let best = from, least = Infinity;
  boxes.forEach((box, i) => {
    const [bx, by] = middle(box);
    const along = (bx - x) * dx + (by - y) * dy, across = Math.abs((bx - x) * dy) + Math.abs((by - y) * dx);
    if (i === from || along <= 1) return;
    const distance = along + 2 * across;
    if (distance < least) {
      least = distance;
      best = i;
    }
  });
  return best;
}
