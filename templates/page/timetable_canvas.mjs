// Painting of the timetable: ticks of the schedule, messages that the selected node reads at each tick, measured times
// of a paced trace, and upper bounds of the times for an image. Times are in seconds since the beginning of an episode.
import {colour, onFrame, prepare, shade} from "./canvas.mjs";
import {data, nodes} from "./data.mjs";
import {el} from "./elements.mjs";
import {inputsOf} from "./graph_selection.mjs";
import {stepOf} from "./numbers.mjs";
import {newestAt, order, periodOf, quantum, rowOf, wholePeriod} from "./schedule.mjs";
import {isSelected, state} from "./selection.mjs";

export const timetable = {
  begin: 0,
  span: 1,
  scroll: 0,
  measured: null,
  bound: null,   // [rate classes] latest time of outputs in their slots
  stream: null,  // on pages that receive live messages: {choose(whether their times are shown)}
  canvas: el("canvas"),
  draw: null
};
export const kRow = 22, kHead = 46;

function labelWidth(width) {
  return Math.min(220, Math.max(110, width * 0.2));
}

export function timetableSize() {
  const box = timetable.canvas.parentElement.getBoundingClientRect();
  return {width: Math.floor(box.width), height: Math.floor(box.height), left: labelWidth(box.width)};
}

export function timeAt(x) {
  const {width, left} = timetableSize();
  return timetable.begin + ((x - left) / (width - left)) * timetable.span;
}

export function placeTimetable(begin, span) {
  const slowest = Math.max(...data.schedule.rates.map((rate) => rate.period)) * quantum;
  timetable.span = Math.min(Math.max(span, quantum * 0.05), slowest * 2000);
  timetable.begin = Math.max(begin, -timetable.span * 0.02);
  timetable.draw();
}

export function zoomTimetable(factor, at = null) {
  const {width, left} = timetableSize();
  const time = timeAt(at === null ? (left + width) / 2 : Math.max(at, left));
  placeTimetable(time - (time - timetable.begin) * factor, timetable.span * factor);
}

export function fitTimetable() {
  const slowest = Math.max(...data.schedule.rates.map((rate) => rate.period)) * quantum;
  const {slots} = data.schedule;
  const whole = wholePeriod && slots && slots <= 200 ? wholePeriod : slowest * 4;
  const span = slots === 1 ? slowest * 4 : whole;
  placeTimetable(-span * 0.02, span * 1.06);
}

export function scrollRows(by) {
  const most = Math.max(0, order.length * kRow + kHead + 8 - timetableSize().height);
  timetable.scroll = Math.min(most, Math.max(0, timetable.scroll + by));
  timetable.draw();
}

function drawTimetable() {
  const {width, height, left} = timetableSize();
  const context = prepare(timetable.canvas, width, height);
  if (!context) return;
  const x = (time) => left + ((time - timetable.begin) / timetable.span) * (width - left);
  const y = (row) => kHead + row * kRow - timetable.scroll + kRow / 2;
  const view = {
    context,
    width,
    height,
    left,
    x,
    y,
    first: Math.max(0, Math.floor(timetable.scroll / kRow)),
    last: Math.min(order.length - 1, Math.ceil((timetable.scroll + height - kHead) / kRow))
  };
  context.save();
  context.beginPath();
  context.rect(0, kHead, width, height - kHead);
  context.clip();
  drawRows(view);
  context.beginPath();
  context.rect(left, kHead, width - left, height - kHead);
  context.clip();
  drawGrid(view, kHead);
  for (let row = view.first; row <= view.last; ++row) drawTicks(view, order[row], y(row));
  drawReads(view);
  context.restore();
  drawLabels(view);
  drawAxis(view);
}
timetable.draw = onFrame(drawTimetable);

function drawRows({context, width, y, first, last}) {
  for (let row = first; row <= last; ++row) {
    const chosen = isSelected("node", order[row]) ||
        (state.selected && state.selected.input && state.selected.input[0] === order[row]);
    if (!chosen && row % 2) continue;
    context.fillStyle = chosen ? colour("chosen") : colour("stripe");
    context.fillRect(0, y(row) - kRow / 2, width, kRow);
  }
}

/** Draws the beginnings of hyperperiods and of environment steps. */
function drawGrid({context, width, height, left, x, y}, top) {
  const bottom = Math.min(height, y(order.length - 1) + kRow / 2);
  const line = (period, style, thick) => {
    if (!period || (period / timetable.span) * (width - left) < 6) return;
    context.strokeStyle = colour(style);
    context.lineWidth = thick;
    context.beginPath();
    for (let i = Math.max(0, Math.ceil(timetable.begin / period)); i * period < timetable.begin + timetable.span; ++i) {
      context.moveTo(x(i * period), top);
      context.lineTo(x(i * period), bottom);
    }
    context.stroke();
  };
  line(periodOf(0), "grid", 1);
  line(wholePeriod || 0, "strong", 1.5);
}

function drawTicks({context, width, left, x}, node, y) {
  const period = periodOf(node), step = (period / timetable.span) * (width - left);
  const fill = shade(nodes[node].rate_class);
  context.fillStyle = fill;
  const from = Math.max(0, Math.floor(timetable.begin / period));
  const to = Math.ceil((timetable.begin + timetable.span) / period);
  if (step < 3) {
    context.globalAlpha = 0.45;
    const begin = x(Math.max(0, timetable.begin));
    context.fillRect(begin, y - 5, width - begin, 10);
    context.globalAlpha = 1;
  } else {
    const thick = Math.min(6, Math.max(2, step * 0.3));
    for (let n = from; n <= to; ++n) context.fillRect(x(n * period) - thick / 2, y - 6, thick, 12);
    if (step > 46) {
      context.fillStyle = colour("faint");
      context.textAlign = "left";
      for (let n = from; n <= to; ++n) context.fillText(String(n), x(n * period) + thick / 2 + 4, y);
    }
  }
  drawBound(context, node, y, x, step, from, to);
  drawMeasured(context, node, y, x, step, from, to);
}

function drawBound(context, node, y, x, step, from, to) {
  const latest = timetable.bound && timetable.bound[nodes[node].rate_class];
  if (!latest || step < 3) return;
  const period = periodOf(node);
  context.fillStyle = colour("measured");
  context.globalAlpha = 0.25;
  for (let n = from; n <= to; ++n) context.fillRect(x(n * period), y + 5, x(n * period + latest) - x(n * period), 5);
  context.globalAlpha = 1;
}

function drawMeasured(context, node, y, x, step, from, to) {
  if (!timetable.measured || step < 3) return;
  const stamps = timetable.measured.get(node);
  if (!stamps) return;
  const period = periodOf(node);
  const lines = (draw) => {
    context.beginPath();
    for (let n = Math.max(from, stamps.first); n <= to + 1 && n - stamps.first < stamps.late.length; ++n)
      draw(x(n * period), x(n * period + stamps.late[n - stamps.first]));
    context.stroke();
  };
  context.strokeStyle = colour("measured");
  context.lineWidth = 1;
  context.globalAlpha = 0.5;
  lines((planned, at) => {
    context.moveTo(planned, y + 8);
    context.lineTo(at, y + 8);
  });
  context.lineWidth = 1.5;
  context.globalAlpha = 1;
  lines((_, at) => {
    context.moveTo(at, y - 8);
    context.lineTo(at, y + 9);
  });
}

/** Draws lines from messages of the selection to the ticks that read them. */
function drawReads({context, width, left, x, y}) {
  const {selected} = state;
  if (!selected || selected.object !== undefined || selected.composite !== undefined) return;
  const chosen = inputsOf(selected);
  const inputs = chosen ? chosen.map(([n, i]) => nodes[n].inputs[i]) : nodes[selected.node].inputs;
  context.lineWidth = 2;
  for (const input of inputs) {
    const period = periodOf(input.node), before = periodOf(input.source[0]);
    if ((period / timetable.span) * (width - left) < 4) continue;
    context.strokeStyle = shade(nodes[input.source[0]].rate_class);
    const rows = [y(rowOf.get(input.source[0])), y(rowOf.get(input.node))];
    const to = Math.ceil((timetable.begin + timetable.span) / period);
    context.beginPath();
    for (let n = Math.max(0, Math.floor(timetable.begin / period)); n <= to + 1; ++n) {
      const m = newestAt(input, n);
      if (m === null || m < 0) continue;
      const [a, b] = [x(m * before), x(n * period)];
      context.moveTo(a, rows[0]);
      if (Math.abs(a - b) < 1)
        context.lineTo(b, rows[1]);
      else
        context.bezierCurveTo((a + b) / 2, rows[0], (a + b) / 2, rows[1], b, rows[1]);
    }
    context.stroke();
  }
}

function drawLabels({context, left, height, y, first, last}) {
  context.save();
  context.beginPath();
  context.rect(0, kHead, left - 8, height - kHead);
  context.clip();
  context.textAlign = "left";
  for (let row = first; row <= last; ++row) {
    context.fillStyle = shade(nodes[order[row]].rate_class);
    context.fillRect(10, y(row) - 4, 8, 8);
    context.fillStyle = colour("text");
    context.fillText(nodes[order[row]].name, 26, y(row));
  }
  context.restore();
}

function drawAxis({context, width, left, x}) {
  context.fillStyle = colour("paper");
  context.fillRect(0, 0, width, kHead);
  context.strokeStyle = colour("line");
  context.lineWidth = 1;
  context.beginPath();
  context.moveTo(0, kHead - 0.5);
  context.lineTo(width, kHead - 0.5);
  const step = stepOf(timetable.span, (width - left) / 110);
  const digits = Math.max(0, -Math.floor(Math.log10(step * 1000)));
  context.fillStyle = colour("faint");
  context.textAlign = "left";
  context.fillText("ms", left - 26, kHead - 13);
  context.textAlign = "center";
  for (let i = Math.max(0, Math.ceil(timetable.begin / step)); i * step <= timetable.begin + timetable.span; ++i) {
    const at = x(i * step);
    if (at < left) continue;
    context.moveTo(at, kHead - 5);
    context.lineTo(at, kHead);
    context.fillText((i * step * 1000).toFixed(digits), at, kHead - 13);
  }
  context.stroke();
  if (!wholePeriod) return;
  const period = wholePeriod, length = (period / timetable.span) * (width - left);
  if (length < 60) return;
  for (let i = Math.max(0, Math.floor(timetable.begin / period)); i * period < timetable.begin + timetable.span; ++i) {
    const from = Math.max(x(i * period), left), to = Math.min(x((i + 1) * period), width);
    if (to - from < 90) continue;
    context.fillText(`hyperperiod ${i + 1}`, (from + to) / 2, 12);
    context.strokeStyle = colour("strong");
    context.beginPath();
    context.moveTo(from + 3, 23);
    context.lineTo(to - 3, 23);
    context.stroke();
  }
}
