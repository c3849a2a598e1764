// Painting of plots: axes, lines, the cursor and its readout.
import {colour, onFrame, prepare, shade} from "./canvas.mjs";
import {el} from "./elements.mjs";
import {seconds, short, stepOf} from "./numbers.mjs";
import {drawPictures} from "./playback.mjs";
import {chosenRuns, plots, pointsOf} from "./runs.mjs";

export const kLeft = 62, kBottom = 18;

/** Range of the visible values. */
function rangeOf(series, of) {
  let [low, high] = [Infinity, -Infinity];
  for (const run of of ) {
    const points = pointsOf(series, run);
    if (!points) continue;
    const from = Math.max(0, Math.floor((plots.begin - points.begin) / points.step));
    for (const element of points.elements) {
      const to = Math.min(element.low.length - 1, Math.ceil((plots.begin + plots.span - points.begin) / points.step));
      for (let i = from; i <= to; ++i) {
        if (element.low[i] < low) low = element.low[i];
        const top = element.high ? element.high[i] : element.low[i];
        if (top > high) high = top;
      }
    }
  }
  if (low > high) return [0, 1];
  const room = (high - low || Math.abs(high) || 1) * 0.08;
  return [low - room, high + room];
}

/** `frame`: visible time {begin, span}, in seconds. */
export function drawAxes(context, width, height, [low, high], last, frame = plots) {
  const bottom = height - (last ? kBottom : 4), y = (value) => bottom - ((value - low) / (high - low)) * (bottom - 6);
  context.strokeStyle = colour("grid");
  context.fillStyle = colour("faint");
  context.lineWidth = 1;
  context.textAlign = "right";
  context.beginPath();
  const step = stepOf(high - low, Math.max(2, (bottom - 6) / 26));
  for (let i = Math.ceil(low / step); i * step <= high; ++i) {
    const at = Math.round(y(i * step)) + 0.5;
    context.moveTo(kLeft, at);
    context.lineTo(width, at);
    context.fillText(short(i * step, 4), kLeft - 8, at);
  }
  const x = (time) => kLeft + ((time - frame.begin) / frame.span) * (width - kLeft);
  const seconds10 = stepOf(frame.span, (width - kLeft) / 90);
  const digits = Math.max(0, -Math.floor(Math.log10(seconds10)));
  context.textAlign = "center";
  for (let i = Math.max(0, Math.ceil(frame.begin / seconds10)); i * seconds10 <= frame.begin + frame.span; ++i) {
    const at = Math.round(x(i * seconds10)) + 0.5;
    context.moveTo(at, 6);
    context.lineTo(at, bottom);
    if (last && at < width - 14) context.fillText(`${(i * seconds10).toFixed(digits)} s`, at, height - 7);
  }
  context.stroke();
  return {x, y, bottom};
}

/** Draws the unit vertically, to the left of the tick labels. */
function drawUnit(context, unit, y) {
  if (!unit) return;
  context.save();
  context.textAlign = "center";
  context.fillStyle = colour("faint");
  context.translate(8, y);
  context.rotate(-Math.PI / 2);
  context.fillText(`[${unit}]`, 0, 0);
  context.restore();
}

export function drawElement(context, points, element, {x, y}, fill, frame = plots) {
  const from = Math.max(0, Math.floor((frame.begin - points.begin) / points.step) - 1);
  const to = Math.min(element.low.length - 1, Math.ceil((frame.begin + frame.span - points.begin) / points.step) + 1);
  const at = (i) => x(points.begin + i * points.step);
  context.strokeStyle = context.fillStyle = fill;
  context.lineWidth = 1.4;
  if (element.high) {  // a band, with an outline that keeps a thin one visible
    context.beginPath();
    for (let i = from; i <= to; ++i) {
      if (Number.isNaN(element.low[i])) continue;
      const top = y(element.high[i]), below = y(element.low[i]);
      context.rect(at(i), top - 0.6, Math.max(0.8, at(i + 1) - at(i)), below - top + 1.2);
    }
    return context.fill();
  }
  context.beginPath();
  let before = null;
  for (let i = from; i <= to; ++i) {
    const value = element.low[i];
    if (Number.isNaN(value)) {
      before = null;
      continue;
    }
    if (before === null)
      context.moveTo(at(i), y(value));
    else {
      context.lineTo(at(i), y(before));
      context.lineTo(at(i), y(value));
    }  // a message holds until the next one
    before = value;
  }
  if (before !== null) context.lineTo(at(to + 1), y(before));
  context.stroke();
}

/** Color of a line: one for each run, or one for each element of a single run. */
export function colourOf(run, element) {
  const place = chosenRuns().indexOf(run);
  return shade(plots.runs.size > 1 ? place + (plots.sideBySide ? element : 0) : element);
}

function drawCanvas(row, cell, range, last) {
  const box = cell.canvas.parentElement.getBoundingClientRect(), height = last ? 128 : 112;
  const width = Math.floor(box.width);
  const context = prepare(cell.canvas, width, height);
  if (!context) return;
  const axes = drawAxes(context, width, height, range, last);
  drawUnit(context, row.series.unit, axes.bottom / 2);
  context.save();
  context.beginPath();
  context.rect(kLeft, 0, width - kLeft, axes.bottom + 2);
  context.clip();
  for (const run of cell.runs) {
    const points = pointsOf(row.series, run);
    if (points) points.elements.forEach((element, e) => drawElement(context, points, element, axes, colourOf(run, e)));
  }
  if (plots.cursor !== null) {
    context.strokeStyle = colour("cursor");
    context.lineWidth = 1;
    context.beginPath();
    const at = Math.round(axes.x(plots.cursor)) + 0.5;
    context.moveTo(at, 0);
    context.lineTo(at, axes.bottom);
    context.stroke();
  }
  context.restore();
}

/** Shows the values at the cursor. */
function readOut(row) {
  if (plots.cursor === null) return row.values.replaceChildren();
  const parts = [];
  const of = chosenRuns();
  for (const run of of ) {
    const points = pointsOf(row.series, run);
    if (!points) continue;
    const i = Math.floor((plots.cursor - points.begin) / points.step + 1e-6);
    points.elements.slice(0, 6).forEach((element, e) => {
      if (i < 0 || i >= element.low.length) return;
      const text = element.high ? `${short(element.low[i])} … ${short(element.high[i])}` : short(element.low[i], 6);
      const mark = el("i.mark");
      mark.style.background = colourOf(run, e);
      parts.push(el("span", {title: run.name + (points.elements.length > 1 ? `, element ${e}` : "")}, mark, text));
    });
  }
  row.values.replaceChildren(...parts.slice(0, 16));
}

function drawPlots() {
  const frame = plots.stage.getBoundingClientRect();
  const of = chosenRuns();
  plots.rows.forEach((row, r) => {
    const box = row.element.getBoundingClientRect();
    if (box.bottom < frame.top - 50 || box.top > frame.bottom + 50) return;
    const range = rangeOf(row.series, of);
    for (const cell of row.cells) drawCanvas(row, cell, range, r === plots.rows.length - 1 || r % 4 === 3);
    readOut(row);
  });
  drawPictures();
  plots.time.textContent = plots.cursor === null ? "" : `cursor at ${seconds(plots.cursor)}`;
}
plots.draw = onFrame(drawPlots);
