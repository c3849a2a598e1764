// Line charts: axes, lines with a legend, dots, and a readout at the pointer.
import {colour, onFrame, prepare, shade} from "./canvas.mjs";
import {el} from "./elements.mjs";
import {count, short, stepOf} from "./numbers.mjs";

const chartRoom = {
  left: 64,
  right: 14,
  top: 8,
  bottom: 36  // tick labels, and the title of the axis
};

/** {right, low, high}: range of a chart. The horizontal axis begins at 0. */
export function chartRange({lines, labels, unit}) {
  let right = 1, low = Infinity, high = -Infinity;
  for (const line of lines) {
    line.x.forEach((x, i) => {
      right = Math.max(right, x);
      low = Math.min(low, (line.low ?? line.y)[i]);
      high = Math.max(high, (line.high ?? line.y)[i]);
    });
  }
  if (labels) right = labels.length;
  if (unit === "%") return {right, low: 0, high: 1};
  if (low > high) return {right, low: 0, high: 1};
  const room = (high - low) * 0.04 || Math.abs(high) * 0.1 || 1;
  return {right, low: low - room, high: high + room};
}

/** Conversion of values to pixels from the top left corner. Labels are centered in their intervals. */
function chartPlaces({labels}, {right, low, high}, width, height) {
  const {left, top, bottom} = chartRoom, wide = width - left - chartRoom.right, high_px = height - top - bottom;
  return {
    x: (value) => left + ((value + (labels ? 0.5 : 0)) / right) * wide,
    y: (value) => top + (1 - (value - low) / (high - low)) * high_px
  };
}

/** Short form of a large number: "250 k" for 250000. */
function largeNumber(value) {
  const [size, unit] = value >= 1e6 ? [1e6, " M"] : value >= 1e4 ? [1e3, " k"] : [1, ""];
  return short(value / size, 4) + unit;
}

export const chartNumber = (unit, value, digits = 4) =>
    unit === "%" ? `${short(value * 100, digits)} %` : short(value, digits);

function paintAxes(context, chart, range, {x, y}, width, height) {
  context.fillStyle = colour("faint");
  context.strokeStyle = colour("grid");
  context.lineWidth = 1;
  context.textAlign = "right";
  context.beginPath();
  const step = stepOf(range.high - range.low, (height - 30) / 30);
  for (let i = Math.ceil(range.low / step - 1e-9); i * step <= range.high + 1e-9 * step; ++i) {
    const at = Math.round(y(i * step)) + 0.5;
    context.moveTo(chartRoom.left, at);
    context.lineTo(width - chartRoom.right, at);
    context.fillText(chartNumber(chart.unit, i * step), chartRoom.left - 8, at);
  }
  context.stroke();
  context.textAlign = "center";
  const below = height - 23;
  if (chart.labels) return chart.labels.forEach((label, i) => context.fillText(label, x(i), below));
  const stride = stepOf(range.right, (width - 80) / 110);
  for (let i = 0; i * stride <= range.right * (1 + 1e-9); ++i) {
    const text = largeNumber(i * stride), half = context.measureText?.(text)?.width / 2 || 0;
    context.fillText(text, Math.min(x(i * stride), width - half - 2), below);
  }
  if (!chart.over) return;
  context.textAlign = "right";
  context.fillText(chart.over, width - chartRoom.right, height - 7);
}

function paintLine(context, line, {x, y}, fill) {
  context.strokeStyle = context.fillStyle = fill;
  if (line.dots || line.x.length === 1) {  // a line of one point would be invisible
    line.x.forEach((value, i) => {
      context.beginPath();
      context.arc(x(value), y(line.y[i]), 3, 0, 2 * Math.PI);
      context.fill();
    });
    return;
  }
  if (line.low) {
    context.globalAlpha = 0.2;
    context.beginPath();
    line.x.forEach((value, i) => context[i ? "lineTo" : "moveTo"](x(value), y(line.high[i])));
    for (let i = line.x.length - 1; i >= 0; --i) context.lineTo(x(line.x[i]), y(line.low[i]));
    context.fill();
    context.globalAlpha = 1;
  }
  context.lineWidth = 1.6;
  context.beginPath();
  line.x.forEach((value, i) => context[i ? "lineTo" : "moveTo"](x(value), y(line.y[i])));
  context.stroke();
}

/**
 * `chart`: {lines: [{x, y, low?, high?, dots?}], unit, over?, labels?}, where `over` is the title of the horizontal
 * axis. `cursor`: position of the pointer on that axis, in its unit.
 */
export function paintChart(context, chart, width, height, cursor = null) {
  const range = chartRange(chart), places = chartPlaces(chart, range, width, height);
  paintAxes(context, chart, range, places, width, height);
  chart.lines.forEach((line, i) => paintLine(context, line, places, shade(line.shade ?? i)));
  if (cursor === null) return;
  context.strokeStyle = colour("cursor");
  context.lineWidth = 1;
  context.beginPath();
  context.moveTo(Math.round(places.x(cursor)) + 0.5, chartRoom.top);
  context.lineTo(Math.round(places.x(cursor)) + 0.5, height - chartRoom.bottom);
  context.stroke();
}

/** Index of the last point of a line at or before `at`, or of its first point. */
export function chartPointAt(line, at) {
  let found = 0;
  while (found + 1 < line.x.length && line.x[found + 1] <= at) ++found;
  return found;
}

/** Article with the chart, its legend and the values at the pointer. `draw()` paints it. */
export function chartBox(chart, over, height = 190) {
  const canvas = el("canvas", {role: "img", "aria-label": `${chart.name} over ${over}`});
  let cursor = null;
  const marks = chart.lines.map((line, i) => {
    const mark = el("i.mark"), value = el("b");
    mark.style.background = shade(line.shade ?? i);
    const name = line.name === chart.name ? "" : line.name;
    return {line, mark, value, element: el("span", {}, mark, name, " ", value)};
  });
  const where = el("span");
  const readAt = () => {
    where.textContent = cursor === null ? "" : `${over} ${count(Math.round(cursor))}`;
    for (const {line, value} of marks) {
      const i = cursor === null ? line.x.length - 1 : chartPointAt(line, cursor);
      value.textContent = line.dots ? "" :
          line.low ? `${chartNumber(chart.unit, line.y[i])} (${chartNumber(chart.unit, line.low[i])} to ${
                         chartNumber(chart.unit, line.high[i])})` :
                     chartNumber(chart.unit, line.y[i]);
    }
  };
  const draw = onFrame(() => {
    const width = Math.floor(canvas.parentElement.getBoundingClientRect().width);
    const context = prepare(canvas, width, height);
    if (context) paintChart(context, {...chart, over}, width, height, cursor);
    marks.forEach(({line, mark}, i) => (mark.style.background = shade(line.shade ?? i)));
  });
  const moved = (event) => {
    const box = canvas.getBoundingClientRect(), {right} = chartRange(chart);
    const at = (event.clientX - box.left - chartRoom.left) / (box.width - chartRoom.left - chartRoom.right);
    cursor = event.type === "pointerleave" || chart.labels ? null : Math.min(right, Math.max(0, at * right));
    readAt();
    draw();
  };
  canvas.addEventListener("pointermove", moved);
  canvas.addEventListener("pointerleave", moved);
  readAt();
  const element =
      el("article.plot.chart", {},
         el("header", {}, el("span", {}, chart.name), el("span.values", {}, marks.map((m) => m.element), where)),
         el("div.cell", {}, canvas));
  return {element, draw};
}
