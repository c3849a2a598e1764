// Learning curve of a training in progress.
import {prepare} from "./canvas.mjs";
import {paintChart} from "./charts.mjs";
import {el} from "./elements.mjs";

/** Points [steps, value] of the first column in `names` that the curve has, without values that cannot be plotted. */
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
/** Plots the return over the steps of a training in progress. */
export function drawCurve(run) {
  const {columns, rows} = run;
  const lines = [curveOf(columns, rows, ["return"]), curveOf(columns, rows, ["eval_return"])];
  curveBox.hidden = run.kind !== "train" || lines.every((line) => !line.length);
  if (curveBox.hidden) return;
  const width = curveBox.clientWidth - 8, height = 140, context = prepare(curveCanvas, width, height);
  if (!context) return;
  const of = (line) => ({x: line.map(([x]) => x), y: line.map(([, y]) => y)});
  paintChart(context, {unit: "", lines: lines.map(of)}, width, height);
}
