// File of the graph, with diagnostics at their lines.
import {data} from "./data.mjs";
import {button, el} from "./elements.mjs";
import {counted} from "./numbers.mjs";
import {showView} from "./views.mjs";

const lineElements = new Map();

function problemElement(problem) {
  const marker = problem.column && problem.length ?
      el("pre.marker", {}, " ".repeat(problem.column - 1) + "^".repeat(problem.length)) :
      null;
  return el(
      "div.problem." + problem.severity, {}, problem.line ? marker : null,
      el("p", {}, el("b", {}, problem.code ? `${problem.severity} ${problem.code}` : problem.severity), ": ",
         problem.message),
      problem.notes.map((note) => el("p", {}, note)),
      problem.help ? el("p", {}, el("b", {}, "help"), ": ", problem.help) : null);
}

export function sourceLine(text, i) {
  // A comment begins with a # at the beginning of the line or after a blank, outside quotes.
  const comment = /^(?:[^"'#]|"[^"]*"|'[^']*'|\S#)*?(?:^|\s)(#.*)$/.exec(text);
  const at = comment ? text.length - comment[1].length : text.length;
  const key = /^(\s*(?:- )?)([\w./-]+)(:)(?=\s|$)/.exec(text.slice(0, at));
  const rest = key ? key[0].length : 0;
  return el(
      "div.line", {}, el("span.number", {"aria-hidden": true}, i + 1),
      el("code", {}, key ? [key[1], el("span.key", {}, key[2]), key[3]] : null, text.slice(rest, at),
         at < text.length ? el("span.comment", {}, text.slice(at)) : null));
}

export function showLine(line) {
  showView("source");
  const element = lineElements.get(line);
  if (!element) return;
  for (const other of lineElements.values()) other.classList.remove("chosen");
  element.classList.add("chosen");
  element.scrollIntoView({block: "center"});
}

export function makeSourceView(panel) {
  const elsewhere = data.diagnostics.filter((problem) => !problem.line);
  const at = new Map();
  for (const problem of data.diagnostics) at.set(problem.line, [...(at.get(problem.line) || []), problem]);
  const counts = ["error", "warning", "note"]
                     .map((severity) => [severity, data.diagnostics.filter((p) => p.severity === severity)])
                     .filter(([, found]) => found.length);
  panel.append(
      el("div.toolbar", {}, el("h2", {}, data.source.name),
         counts.length ? counts.map(
                             ([severity, found]) => button(
                                 counted(found.length, severity), () => found[0].line && showLine(found[0].line),
                                 {className: "problem " + severity})) :
                         el("p.note", {}, "no problems")));
  panel.append(...elsewhere.map(problemElement));
  const lines = data.source.lines.map(sourceLine);
  lines.forEach((line, i) => lineElements.set(i + 1, line));
  panel.append(
      el("div.source", {tabIndex: 0}, lines.map((line, i) => [line, (at.get(i + 1) || []).map(problemElement)])));
  return {shown() {}, resized() {}};
}
