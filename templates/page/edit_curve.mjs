// The learning curve of a training while it grows.
import {colour, prepare} from "./canvas.mjs";
import {el} from "./elements.mjs";
import {short, stepOf} from "./numbers.mjs";

/** [steps, value] of a column of the curve that can be plotted, by the first of `names` that there is. */
export function curveOf(columns, rows, names) {
  const x = columns.findIndex((name) => /step/.test(name)),
        y = names.map((name) => columns.indexOf(name)).find((at) => at >= 0);
  if (x < 0 || y === undefined) return [];
  return rows.map((row) => [Number(row[x]), row[y] === "" || row[y] === null ? NaN : Number(row[y])])
      .filter(([, value]) => Number.isFinite(value));
}

const curveCanvas = el("canvas", {role: "img", "aria-label": "Learning curve: return over steps"});
export const curveBox =
    el("div.curve", {hidden: true}, curveCanvas,
       el("small.block", {}, el("i.mean"), "return", el("i.evaluation"), "return without noise, over steps"));
/** Return over steps of what trains, of its table as it grows. */
export function drawCurve(run) {
  const {columns, rows} = run;
  const lines = [["c0", curveOf(columns, rows, ["return"])], ["c1", curveOf(columns, rows, ["evaluation_return"])]];
  const points = lines.flatMap(([, line]) => line);
  curveBox.hidden = run.kind !== "train" || points.length < 1;
  if (curveBox.hidden) return;
  const width = curveBox.clientWidth - 8, height = 140, context = prepare(curveCanvas, width, height);
  if (!context) return;
  const right = Math.max(1, ...points.map(([x]) => x)), ys = points.map(([, y]) => y);
  let low = Math.min(...ys), high = Math.max(...ys);
  if (high - low < 1e-9) [low, high] = [low - 1, high + 1];
  const left = 64, top = 8, bottom = height - 20;
  const px = (x) => left + (x / right) * (width - left - 12),
        py = (y) => bottom - ((y - low) / (high - low)) * (bottom - top);
  context.fillStyle = colour("faint");
  context.strokeStyle = colour("grid");
  const step = stepOf(high - low, 4);
  for (let y = Math.ceil(low / step) * step; y <= high; y += step) {
    context.fillText(short(y, 3), 4, py(y));
    context.beginPath();
    context.moveTo(left, py(y));
    context.lineTo(width - 12, py(y));
    context.stroke();
  }
  context.fillText("0", left, height - 8);
  context.fillText(`${short(right, 3)} steps`, width - 90, height - 8);
  for (const [name, line] of lines) {
    context.strokeStyle = colour(name);
    context.lineWidth = 2;
    context.beginPath();
    line.forEach(([x, y], i) => context[i ? "lineTo" : "moveTo"](px(x), py(y)));
    context.stroke();
  }
}
