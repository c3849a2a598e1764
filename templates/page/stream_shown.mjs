// Live data of a run in other views: values at the wires of the drawing, and measured times in the timetable.
import {data, nodes} from "./data.mjs";
import {svg} from "./elements.mjs";
import {graphView} from "./graph_drawing.mjs";
import {short} from "./numbers.mjs";
import {periodOf} from "./schedule.mjs";
import {state} from "./selection.mjs";
import {fitTimetable, placeTimetable, timetable} from "./timetable_canvas.mjs";

// ---- Wires ----------------------------------------------------------------------------------------------------------
const kWireValues = 3;

/** Channel that a wire carries; null if it carries none. */
function channelOfWire(wire) {
  if (!wire.readers.length) return null;
  const [reader, input] = wire.readers[0];
  const [node, output] = nodes[reader].inputs[input].source;
  const number = nodes[node].channels[output];
  return number === null ? null : data.channels[number].name;
}

/** Texts at the wires of a drawing, created when it is first shown. */
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

/** `latest`: data of /monitor by channel. */
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
/** Newest times of each node, from its first channel that has sent a message. */
function measureStream(channels) {
  const times = new Map();
  for (const said of channels) {
    const known = data.channels.find((other) => other.name === said.name);
    if (known && said.came_late_s && !times.has(known.node))
      times.set(known.node, {first: said.first, late: said.came_late_s});
  }
  return times;
}

/** Scrolls the timetable so that it contains the latest ticks. */
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
