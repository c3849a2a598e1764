// File next to the drawing: its current text, with the last change highlighted and problems at their lines.
import {changedLines} from "./edit_changes.mjs";
import {editing} from "./edit_store.mjs";
import {add, el} from "./elements.mjs";
import {sourceLine} from "./source.mjs";

export const textPanel = el("div.text", {tabIndex: 0, "aria-label": "The file, read only"});
let textLines = [];

function shownLines(text) {
  const lines = text.split(/\r?\n/);
  if (lines.at(-1) === "") lines.pop();
  return lines;
}

export function showText() {
  const {state, before} = editing.client;
  const {changed, removed} = changedLines(before, state.text), severities = new Map();
  for (const {line, severity} of state.problems)
    if (line && severities.get(line) !== "error") severities.set(line, severity);
  textLines = shownLines(state.text).map((text, i) => {
    const line = sourceLine(text, i);
    if (changed.has(i)) line.classList.add("changed");
    if (removed.has(i)) line.classList.add("removed");
    if (severities.has(i + 1)) line.classList.add(severities.get(i + 1));
    return line;
  });
  textPanel.replaceChildren();
  add(textPanel, textLines.length ? textLines : [
    el("p.note", {}, state.exists ? "The file is empty." : "There is no such file yet: the first change makes it.")
  ]);
  const first = [...changed].sort((a, b) => a - b)[0];
  if (first !== undefined) textLines[first]?.scrollIntoView({block: "nearest"});
}

export function showTextLine(line) {
  for (const other of textLines) other.classList.remove("chosen");
  const element = textLines[line - 1];
  if (!element) return;
  element.classList.add("chosen");
  element.scrollIntoView({block: "nearest"});
}
