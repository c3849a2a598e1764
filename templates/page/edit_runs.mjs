// Programs that the server starts: what they print, and of training the curve as it grows.
import {colour, prepare} from "./canvas.mjs";
import {editing, say} from "./edit_store.mjs";
import {button, el} from "./elements.mjs";
import {short, stepOf} from "./numbers.mjs";

const kMostShown = 2000;  // lines
export const run = {
  id: 0,
  kind: "",
  running: false,
  next: 0,
  row: 0,
  lines: [],
  columns: [],
  rows: [],
  exit_code: null,
  result: false
};

/** Adds what the server tells: lines from `next` on, rows of the curve. True: there is something new. */
export function takeRun(known, told) {
  if (told.id !== known.id) Object.assign(known, {id: told.id, next: 0, row: 0, lines: [], columns: [], rows: []});
  const isOther = known.running !== told.running;
  Object.assign(
      known, {kind: told.kind, running: told.running, exit_code: told.exit_code, result: told.result, next: told.next});
  known.lines.push(...told.lines);
  known.lines.splice(0, known.lines.length - kMostShown);
  if (told.curve) {
    known.columns = told.curve.columns;
    known.rows.push(...told.curve.rows);
    known.row = told.curve.next;
  }
  return isOther || told.lines.length > 0 || (told.curve?.rows.length ?? 0) > 0;
}

/** [steps, value] of a column of the curve that can be plotted, by the first of `names` that there is. */
export function curveOf(columns, rows, names) {
  const x = columns.findIndex((name) => /step/.test(name)),
        y = names.map((name) => columns.indexOf(name)).find((at) => at >= 0);
  if (x < 0 || y === undefined) return [];
  return rows.map((row) => [Number(row[x]), row[y] === "" || row[y] === null ? NaN : Number(row[y])])
      .filter(([, value]) => Number.isFinite(value));
}

const curveCanvas = el("canvas", {role: "img", "aria-label": "Learning curve: return over steps"});
const curveBox =
    el("div.curve", {hidden: true}, curveCanvas,
       el("small.block", {}, el("i.mean"), "return, ", el("i.evaluation"), "of episodes without noise, over steps"));
const linesBox = el("pre.lines", {tabIndex: 0, "aria-label": "What the program prints", "aria-live": "polite"});
const runStatus = el("p.note", {role: "status"}, "Nothing has run yet.");
export const runPanel = el("div.run", {}, runStatus, curveBox, linesBox);

function drawCurve() {
  const lines = [
    ["c0", curveOf(run.columns, run.rows, ["return"])], ["c1", curveOf(run.columns, run.rows, ["evaluation_return"])]
  ];
  const points = lines.flatMap(([, line]) => line);
  curveBox.hidden = run.kind !== "train" || points.length < 1;
  if (curveBox.hidden) return;
  const width = curveBox.clientWidth - 8, height = 170, context = prepare(curveCanvas, width, height);
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

function statusText() {
  if (!run.id) return "Nothing has run yet.";
  if (run.running) return `eagerx-gen ${run.kind} is running.`;
  if (run.exit_code === 0) return `eagerx-gen ${run.kind} is done.`;
  return `eagerx-gen ${run.kind} ended with exit code ${run.exit_code}.`;
}

export function showRun() {
  runStatus.replaceChildren(
      statusText(),
      ...(run.result && !run.running ?
              [" ", el("a", {href: "./result", target: "_blank", rel: "noopener"}, "Open the page")] :
              []));
  const atEnd = runPanel.scrollTop + runPanel.clientHeight >= runPanel.scrollHeight - 30;
  linesBox.replaceChildren(...run.lines.map(({text, error}) => el("span" + (error ? ".error" : ""), {}, text + "\n")));
  if (atEnd) runPanel.scrollTop = runPanel.scrollHeight;
  drawCurve();
  for (const one of runButtons) one.disabled = run.running || (one.needsGood && !editing.client.state?.good);
  stopButton.disabled = !run.running;
}

let following = false;
/** Asks for more until the program has ended and all is told. */
export async function followRun() {
  if (following) return;
  following = true;
  for (let more = true; more;) {
    const told = await editing.client.get(`run?after=${run.next}&row=${run.row}`);
    if (!told) break;
    const isNew = takeRun(run, told);
    showRun();
    more = told.running || (isNew && told.lines.length > 0);
  }
  following = false;
}

/** Called with true when a program begins: its output is shown. */
let begun = () => {};
export function onRun(call) {
  begun = call;
}

export async function startRun(kind, words = []) {
  const {status, body} = await editing.client.call("./run", {kind, arguments: words});
  if (status !== 200) return say([body.error, body.help].filter(Boolean).join(": "));
  begun();
  return followRun();
}

const runArguments = el("input", {
  type: "text",
  placeholder: "options, such as --steps 300",
  "aria-label": "Options of the program",
  title: "Options of the command, as in a terminal",
  autocomplete: "off",
  spellcheck: false
});

/** Words as a shell would have them, with quotes. */
export function wordsOf(text) {
  return [...text.matchAll(/"([^"]*)"|'([^']*)'|(\S+)/g)].map(([, a, b, c]) => a ?? b ?? c);
}

const runKinds = [
  ["Check", "check", "eagerx-gen check: all of it, as before a commit", false],
  ["Run", "run", "eagerx-gen run: build the program and run it", true],
  ["Report", "report", "eagerx-gen report: a page to send to others", true],
  ["Train", "train", "eagerx-gen train: a policy for this graph's task", true]
];
const stopButton =
    button("Stop", () => editing.client.call("./stop", {}), {title: "Interrupts the program", disabled: true});
const runButtons = runKinds.map(([name, kind, title, needsGood]) => {
  const one = button(
      name, () => startRun(kind, kind === "check" || kind === "report" ? [] : wordsOf(runArguments.value)), {title});
  one.needsGood = needsGood;
  return one;
});
export const runTools =
    el("div.segments", {}, el("div.segment", {role: "group", "aria-label": "Programs"}, runButtons), runArguments,
       stopButton);
