// Graph view: choice of drawing, open composites, keyboard and pointer.
import {data, nodes} from "./data.mjs";
import {button, el, segment} from "./elements.mjs";
import {
  beginGraph,
  drawingOf,
  fitGraph,
  fitGraphOrWidth,
  frame,
  graphSvg,
  graphView,
  isWithinWindow,
  place,
  placeSoon,
  unfolded,
  zoomGraph
} from "./graph_drawing.mjs";
import {boxOf, inputsOf, markGraph, nameOf, neighbour, selectBox, wiresOf} from "./graph_selection.mjs";
import {draggable} from "./pointer.mjs";
import {select, state} from "./selection.mjs";
import {showView} from "./views.mjs";

function showDrawing(name) {
  graphView.drawing = name;
  graphView.shown = drawingOf(name);
  graphSvg.replaceChildren(graphView.shown.group);
  beginGraph();
  markGraph();
}

// ---- Open composites ----------------------------------------------------------------------------------------------
/** Shows the drawing with different composites open. The box of `still` stays where it is. */
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

export function toggle(composite) {
  const opened = new Set(graphView.opened);
  if (!opened.delete(composite)) opened.add(composite);
  reopen(opened, composite);
}

/** Opens or closes the selected composite, or the one around the selected box. */
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

/** Opens the composites that contain the nodes or the object of `selected`. */
function openTo(selected) {
  const inputs = inputsOf(selected);
  const names = inputs ?
      inputs.flatMap(([node, input]) => [node, nodes[node].inputs[input].source[0]]).map((n) => nodes[n].name) :
      [nameOf(selected)];
  const inside = data.composites.filter(({name}) => names.some((other) => other.startsWith(name + "/")));
  if (inside.every(({name}) => graphView.opened.has(name))) return;
  reopen(new Set([...graphView.opened, ...inside.map(({name}) => name)]), null);
}

/** Shows the selection in the drawing that contains it. */
export function showInGraph() {
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

export function makeGraphView(panel) {
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
            button("Fit", fitGraphOrWidth, {title: "Show all; again: the whole width ( 0 )"})),
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
