// The drawing: places come from the generator, here it is only shown, moved and searched.
const graphView = {
  drawing: "user",
  zoom: 1,
  x: 0,
  y: 0,
  shown: null,
  moved: false,
  opened: new Set()  // names of composites
};
const unfolded = {};  // drawings with what is open, by their names

const graphSvg = svg("svg", {
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

/** Opens and closes a composite. */
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

/** Elements of a drawing; made when it is looked at first. */
function drawingOf(name) {
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

function place() {
  const {zoom, x, y} = graphView;
  cull();
  graphView.shown.group.setAttribute("transform", `translate(${x} ${y}) scale(${zoom})`);
  graphSvg.classList.toggle("far", zoom < 0.5);
  graphSvg.classList.toggle("farther", zoom < 0.25);
}
const placeSoon = onFrame(place);

/** The rectangle around points. */
function around(points) {
  const xs = points.map(([x]) => x), ys = points.map(([, y]) => y);
  const x = Math.min(...xs), y = Math.min(...ys);
  return {x, y, width: Math.max(...xs) - x, height: Math.max(...ys) - y};
}

/**
 * Browsers lay out everything anew when the scale changes: of a large graph only what is within the window is there.
 */
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

function zoomGraph(factor, at) {
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

function fitGraph() {
  const box = graphSvg.getBoundingClientRect();
  const {width, height} = graphView.shown;
  if (!box.width || !box.height) return;
  const zoom = Math.min(1.5, (box.width - 40) / width, (box.height - 90) / height);
  graphView.zoom = zoom;
  graphView.moved = false;
  graphView.x = (box.width - width * zoom) / 2;
  graphView.y = 50 + (box.height - 50 - height * zoom) / 2;
  place();
}

/** All of it, or of a large graph the beginning. */
function beginGraph() {
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

/** Brings boxes into the middle, readable if they can be. */
function frame(boxes) {
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

function showDrawing(name) {
  graphView.drawing = name;
  graphView.shown = drawingOf(name);
  graphSvg.replaceChildren(graphView.shown.group);
  beginGraph();
  markGraph();
}

// ---- What is open -------------------------------------------------------------------------------------------------
/** Shows the drawing with other composites open; the box of `still` stays where it is. */
function reopen(opened, still) {
  const cornerOf = () => graphView.shown.boxes.find((box) => box.composite === still);
  const before = cornerOf();
  graphView.opened = opened;
  for (const name of Object.keys(unfolded)) delete unfolded[name];
  graphView.shown = drawingOf(graphView.drawing);
  graphSvg.replaceChildren(graphView.shown.group);
  const after = cornerOf();
  if (before && after) {
    graphView.moved = true;
    graphView.x += (before.x - after.x) * graphView.zoom;
    graphView.y += (before.y - after.y) * graphView.zoom;
    place();
    if (after.open && !isWithinWindow(after)) frame([after]);
  } else
    beginGraph();
  select(state.selected);
}

function isWithinWindow(box) {
  const {zoom, x, y} = graphView, place = graphSvg.getBoundingClientRect();
  const left = x + box.x * zoom, top = y + box.y * zoom;
  return left >= 0 && top >= 0 && left + box.width * zoom <= place.width && top + box.height * zoom <= place.height;
}

function toggle(composite) {
  const opened = new Set(graphView.opened);
  if (!opened.delete(composite)) opened.add(composite);
  reopen(opened, composite);
}

/** Of the box that is selected, or of the one around it. */
function toggleSelected() {
  const {boxes} = graphView.shown;
  const box = state.selected && boxes[boxOf(graphView.shown, state.selected)];
  if (!box) return;
  const composite = box.inside ? box : boxes[box.around];
  if (!composite) return;
  selectBox(boxes.indexOf(composite));
  toggle(composite.composite);
}

function toggleAll() {
  reopen(new Set(graphView.opened.size ? [] : data.composites.map(({name}) => name)), null);
}

/** Opens what the nodes or the object of `selected` are in. */
function openTo(selected) {
  const inputs = inputsOf(selected);
  const names = inputs ?
      inputs.flatMap(([node, input]) => [node, nodes[node].inputs[input].source[0]]).map((n) => nodes[n].name) :
      [nameOf(selected)];
  const inside = data.composites.filter(({name}) => names.some((other) => other.startsWith(name + "/")));
  if (inside.every(({name}) => graphView.opened.has(name))) return;
  reopen(new Set([...graphView.opened, ...inside.map(({name}) => name)]), null);
}

function nameOf({node, object, composite}) {
  if (node !== undefined) return nodes[node].name;
  return (object !== undefined ? data.objects[object] : data.composites[composite]).name;
}

// ---- What of it is selected -----------------------------------------------------------------------------------------
/** The connections that are selected; null if it is something else. */
function inputsOf({input, way}) {
  if (way) return ageWay(way).map((hop) => [hop.node, hop.number]);
  return input ? [input] : null;
}

function boxOf(drawing, selected) {
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

/** All pieces of it, through the frames of composites. */
function wiresOf(drawing, [node, input]) {
  return drawing.wires.flatMap(
      ({readers}, w) => (readers.some((reader) => reader[0] === node && reader[1] === input) ? [w] : []));
}

function markGraph() {
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
  // Frames around what is marked, and what is in a chosen one.
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

/** Shows the selected thing in the drawing that has it. */
function showInGraph() {
  showView("graph");
  const {selected} = state;
  if (!selected) return;
  openTo(selected);
  const inputs = inputsOf(selected);
  const visible =
      inputs ? inputs.every((input) => wiresOf(graphView.shown, input).length) : boxOf(graphView.shown, selected) >= 0;
  if (!visible) graphSwitch.choose(graphView.drawing === "user" ? "engine" : "user");
  const {boxes, wires} = graphView.shown;
  frame(
      inputs ? inputs.flatMap((input) => wiresOf(graphView.shown, input).map((w) => wires[w]))
                   .flatMap(({from, to}) => [boxes[from], boxes[to]]) :
               [boxes[boxOf(graphView.shown, selected)]].filter(Boolean));
}

function selectBox(b) {
  const box = graphView.shown.boxes[b];
  if (box.inside)
    select({composite: data.composites.findIndex(({name}) => name === box.composite)});
  else
    select(box.node !== null ? {node: box.node} : {object: box.object});
}

/** The nearest box in the direction of an arrow key. */
function neighbour(dx, dy) {
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

function graphKey(event) {
  const arrows = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]};
  const arrow = arrows[event.key];
  if (arrow && event.shiftKey) {
    graphView.x -= arrow[0] * 80;
    graphView.y -= arrow[1] * 80;
    placeSoon();
  } else if (arrow) {
    const b = neighbour(...arrow);
    selectBox(b);
    frame([graphView.shown.boxes[b]]);
  } else if (event.key === "+" || event.key === "=")
    zoomGraph(1.25);
  else if (event.key === "-")
    zoomGraph(0.8);
  else if (event.key === "0")
    fitGraph();
  else if (event.key === "Enter")
    toggleSelected();
  else if (event.key === "o" && data.composites.length)
    toggleAll();
  else if (event.key === "e")
    graphSwitch.choose(graphView.drawing === "user" ? "engine" : "user");
  else
    return;
  event.preventDefault();
}

draggable(
    graphSvg,
    (dx, dy) => {
      graphView.x += dx;
      graphView.y += dy;
      graphView.moved = true;
      placeSoon();
    },
    (event) => {
      const group = event.target.closest("g.box, g.wire");
      if (!group) return select(null);
      if (group.item.box !== undefined) {
        selectBox(group.item.box);
        if (event.target.closest("g.sign")) toggle(graphView.shown.boxes[group.item.box].composite);
        return;
      }
      const {readers, from} = graphView.shown.wires[group.item.wire];
      if (readers.length)
        select({input: readers[0]});
      else
        selectBox(from);
    });
graphSvg.addEventListener("wheel", (event) => {
  event.preventDefault();
  const box = graphSvg.getBoundingClientRect();
  const lines = event.deltaMode === 1 ? 16 : 1;
  zoomGraph(
      Math.exp(-event.deltaY * lines * (event.ctrlKey ? 0.01 : 0.0015)),
      [event.clientX - box.left, event.clientY - box.top]);
}, {passive: false});
graphSvg.addEventListener("keydown", graphKey);
graphSvg.addEventListener("dblclick", (event) => {
  const group = event.target.closest("g.box.composite");
  if (group && !event.target.closest("g.sign")) toggle(graphView.shown.boxes[group.item.box].composite);
});

const graphSwitch = segment("Which graph", [["user", "As written"], ["engine", "As it runs"]], "user", showDrawing);

function makeGraphView(panel) {
  const kinds = [
    ["node", "node"], ["object", "object"], ["engine", "engine"], ["engine-node", "engine node"],
    ["reset", "reset node"], ["task", "task"]
  ];
  const used = new Set([...data.drawings.user.boxes, ...data.drawings.engine.boxes].map((box) => box.kind));
  panel.append(
      el("div.toolbar.over", {}, graphSwitch,
         el("div.segment", {role: "group", "aria-label": "Zoom"},
            button("−", () => zoomGraph(0.8), {title: "Zoom out ( - )"}),
            button("+", () => zoomGraph(1.25), {title: "Zoom in ( + )"}),
            button("Fit", fitGraph, {title: "Show all ( 0 )"})),
         data.composites.length ?
             el("div.segment", {},
                button("Open / close", toggleAll, {title: "Show what composites are made of ( o )"})) :
             null,
         el("p.legend", {},
            kinds.filter(([kind]) => used.has(kind)).map(([kind, name]) => el("span", {}, el("i." + kind), name)))),
      graphSvg);
  let first = true;
  return {
    shown() {
      if (first) {
        first = false;
        showDrawing("user");
      }
    },
    resized() {
      if (!graphView.moved) fitGraph();
    },
    focus: graphSvg
  };
}
