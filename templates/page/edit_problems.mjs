// Problems of the graph, each with its place. Help that is a change of text becomes a button.
import {revealBox} from "./edit_drawing.mjs";
import {drawnAs} from "./edit_model.mjs";
import {change, editing, selectDrawn} from "./edit_store.mjs";
import {button, el} from "./elements.mjs";

/** Path in the file as text, such as "nodes › smooth › rate". */
export function placeText(path) {
  return (path ?? []).map((key) => (typeof key === "number" ? `${key + 1}.` : key)).join(" › ");
}

function problemRow(problem, index, showText) {
  const place = drawnAs(editing.model, problem.path);
  const where = problem.file || (problem.line ? `line ${problem.line}` : "");
  const go = () => {
    selectDrawn(place);
    if (place?.box !== undefined) revealBox(place.box);
    if (problem.line) showText(problem.line);
  };
  return el(
      "li." + problem.severity, {},
      el("p", {}, el("b", {}, `${problem.severity} ${problem.code}`), ": ", problem.message, " ",
         problem.line || place ?
             button(
                 [placeText(problem.path) || where, where && placeText(problem.path) ? `, ${where}` : ""], go,
                 {className: "plain", title: "Show the place"}) :
             el("small", {}, where)),
      (problem.notes ?? []).map((note) => el("p.note", {}, note)),
      problem.help ?
          el("p", {}, el("b", {}, "help"), ": ", problem.help, " ",
             problem.fix ? button(problem.fix, () => change([{kind: "fix", problem: index}]), {className: "fix"}) :
                           null) :
          null);
}

/** List of the graph's problems. `showText(line)` shows the line in the file. */
export function problemList(showText) {
  const {problems} = editing.client.state;
  if (!problems.length) return el("p.note", {}, "No problems.");
  return el("ul.problems", {}, problems.map((problem, index) => problemRow(problem, index, showText)));
}

export function problemCounts(problems) {
  const count = (severity) => problems.filter((problem) => problem.severity === severity).length;
  return {errors: count("error"), warnings: count("warning")};
}
