// Programs that the server runs: their output and, during a training, the learning curve.
import {curveBox, drawCurve} from "./edit_curve.mjs";
import {editing, say} from "./edit_store.mjs";
import {button, el} from "./elements.mjs";

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

const kNothingYet = {
  next: 0,
  row: 0,
  lines: [],
  columns: [],
  rows: []
};

/** Adds the server's answer: lines from `next` on, and rows of the curve. Returns true if there is anything new. */
export function takeRun(known, answer) {
  if (answer.id !== known.id) {
    const wasAskedFromThere = known.next > 0 || known.row > 0;
    Object.assign(known, structuredClone(kNothingYet), {id: answer.id});
    if (wasAskedFromThere) return true;  // another run, which is requested from its beginning
  }
  const isOther = known.running !== answer.running;
  Object.assign(known, {
    kind: answer.kind,
    running: answer.running,
    exit_code: answer.exit_code,
    result: answer.result,
    next: answer.next
  });
  known.lines.push(...answer.lines);
  known.lines.splice(0, known.lines.length - kMostShown);
  if (answer.curve) {
    known.columns = answer.curve.columns;
    known.rows.push(...answer.curve.rows);
    known.row = answer.curve.next;
  }
  return isOther || answer.lines.length > 0 || (answer.curve?.rows.length ?? 0) > 0;
}

const linesBox = el("pre.lines", {tabIndex: 0, "aria-label": "What the program prints", "aria-live": "polite"});
let follows = true;  // shows the last line, until the user scrolls up
linesBox.addEventListener("scroll", () => {
  follows = linesBox.scrollTop + linesBox.clientHeight >= linesBox.scrollHeight - 30;
});
const runStatus = el("p.note", {role: "status"}, "Nothing has run yet.");
export const runPanel = el("div.run", {}, runStatus, linesBox, curveBox);

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
  linesBox.replaceChildren(...run.lines.map(({text, error}) => el("span" + (error ? ".error" : ""), {}, text + "\n")));
  drawCurve(run);
  if (follows) linesBox.scrollTop = linesBox.scrollHeight;
  for (const one of runButtons) one.disabled = run.running || (one.needsGood && !editing.client.state?.good);
  stopButton.disabled = !run.running;
}

async function askForMore() {
  for (let more = true; more;) {
    const answer = await editing.client.get(`run?after=${run.next}&row=${run.row}`);
    if (!answer) return false;
    const isNew = takeRun(run, answer);
    showRun();
    more = answer.running || isNew;
  }
  return true;
}
let following = null;
/** Polls until the program has ended and all its output has arrived. Returns false if the server does not answer. */
export function followRun() {
  following ??= askForMore().finally(() => (following = null));
  return following;
}

/** Called with true when a program starts, to show its output. */
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

/** Words of a command line, split as in a shell, with quotes. */
export function wordsOf(text) {
  return [...text.matchAll(/"([^"]*)"|'([^']*)'|(\S+)/g)].map(([, a, b, c]) => a ?? b ?? c);
}

const runKinds = [
  ["Check", "check", "eagerx-gen check: all of it, as before a commit", false],
  ["Run", "run", "eagerx-gen run: build the program and run it", true],
  ["Report", "report", "eagerx-gen report: a page to send to others", true],
  ["Simulate", "simulate", "eagerx-gen report --simulate: a page with the simulation in it", true],
  ["Train", "train", "eagerx-gen train: a policy for this graph's task", true]
];
const stopButton =
    button("Stop", () => editing.client.call("./stop", {}), {title: "Interrupts the program", disabled: true});
const runButtons = runKinds.map(([name, kind, title, needsGood]) => {
  const one = button(
      name, () => startRun(kind, kind === "run" || kind === "train" ? wordsOf(runArguments.value) : []), {title});
  one.needsGood = needsGood;
  return one;
});
export const runTools =
    el("div.segments", {}, el("div.segment", {role: "group", "aria-label": "Programs"}, runButtons), runArguments,
       stopButton);
