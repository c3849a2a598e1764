// What a run sends, where the page has a place for it: values at the wires of the drawing, measured times in the
// timetable.
import {data, nodes} from "./data.mjs";
import {svg} from "./elements.mjs";
import {graphView} from "./graph_drawing.mjs";
import {short} from "./numbers.mjs";
import {periodOf} from "./schedule.mjs";
import {state} from "./selection.mjs";
import {fitTimetable, placeTimetable, timetable} from "./timetable_canvas.mjs";

// ---- Wires ----------------------------------------------------------------------------------------------------------
const kWireValues = 3;

/** The channel that a wire carries; null: none of a graph's channels. */
function channelOfWire(wire) {
  if (!wire.readers.length) return null;
  const [reader, input] = wire.readers[0];
  const [node, output] = nodes[reader].inputs[input].source;
  const number = nodes[node].channels[output];
  return number === null ? null : data.channels[number].name;
}

/** Texts for the wires of a drawing; made when it is shown first. */
function wireValues(drawing) {
  drawing.values ??= drawing.wires.map((wire) => {
    const channel = channelOfWire(wire);
    if (channel === null) return null;
    const [x, y] = wire.points[wire.points.length - 1], text = svg("text", {class: "value", x: x - 10, y: y - 4});
    drawing.group.append(text);
    return {channel, text};
  });
  return drawing.values.filter(Boolean);
}

/** `latest`: channel: what /monitor says of it. */
export function showOnWires(latest) {
  if (state.view.id !== "graph" || !graphView.shown) return;
  for (const {channel, text} of wireValues(graphView.shown)) {
    const said = latest.get(channel);
    if (!said || !said.messages) continue;
    const values = said.value.map((value) => (value === null ? "–" : short(value, 4)));
    text.textContent = values.slice(0, kWireValues).join("  ") + (said.elements > kWireValues ? "  …" : "");
    text.classList.toggle("wrong", !["ok", "safe"].includes(said.state));
  }
}

// ---- Timetable ------------------------------------------------------------------------------------------------------
/** The newest times of each node, by its first channel that has come. */
function measureStream(channels) {
  const times = new Map();
  for (const said of channels) {
    const known = data.channels.find((other) => other.name === said.name);
    if (known && said.came_late_s && !times.has(known.node))
      times.set(known.node, {first: said.first, late: said.came_late_s});
  }
  return times;
}

/** The timetable moves on so that the last ticks are in it. */
function followTimetable() {
  let end = 0;
  for (const [node, {first, late}] of timetable.measured) end = Math.max(end, (first + late.length) * periodOf(node));
  placeTimetable(end - timetable.span * 0.95, timetable.span);
}

export const streamTimes = {
  measured: false,
  show(channels) {
    if (!this.measured) return;
    timetable.measured = measureStream(channels);
    if (state.view.id === "timetable") followTimetable();
  },
  choose(measured) {
    this.measured = measured;
    if (measured) return;
    timetable.measured = null;
    fitTimetable();
  }
};
timetable.stream = streamTimes;
