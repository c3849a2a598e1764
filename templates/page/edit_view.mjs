// Editor view: library, drawing and form, and below them problems, file and programs.
import {nodes} from "./data.mjs";
import {connectDialog} from "./edit_connect.mjs";
import {editSvg, fitEdit, zoomEdit} from "./edit_drawing.mjs";
import {removeSelected} from "./edit_gestures.mjs";
import {inspectPanel} from "./edit_inspector.mjs";
import {libraryPanel} from "./edit_library.mjs";
import {problemCounts, problemList} from "./edit_problems.mjs";
import {followRun, onRun, runPanel, runTools, showRun} from "./edit_runs.mjs";
import {arrange, editing, openGraph, say, stepBack, watchEditing} from "./edit_store.mjs";
import {showText, showTextLine, textPanel} from "./edit_text.mjs";
import {button, el} from "./elements.mjs";
import {counted} from "./numbers.mjs";
import {select, state} from "./selection.mjs";
import {freshness, moreViews, views} from "./views.mjs";

const editLibrary = libraryPanel();
const noticeBox = el("p.notice", {role: "status", hidden: true});
const undoButton = button("↶ Undo", () => stepBack("undo"), {disabled: true}),
      redoButton = button("↷ Redo", () => stepBack("redo"), {disabled: true});
const problemsBox = el("div.list"), goodness = el("p.goodness", {role: "status"});

// ---- Lower panel: one of three tabs -------------------------------------------------------------------------------
const lower =
    [["problems", "Problems", problemsBox], ["text", "File", textPanel], ["programs", "Programs", runPanel]].map(
        ([id, name, panel]) =>
            ({id, panel, tab: button(name, () => showLower(id), {role: "tab", "data-key": `lower.${id}`})}));
function showLower(id) {
  for (const one of lower) {
    one.panel.hidden = one.id !== id;
    one.tab.setAttribute("aria-selected", one.id === id);
  }
  if (id === "programs") showRun();
  if (id === "text" && editing.client.state) showText();  // scrolling to a change requires that the panel is visible
}
const lowerPanel =
    el("div.lower", {},
       el("div.lower-tabs", {role: "tablist", "aria-label": "Below the drawing"}, lower.map(({tab}) => tab), goodness),
       el("div.lower-panels", {}, lower.map(({panel}) => panel)));
const showLineBelow = (line) => {
  showLower("text");
  showTextLine(line);
};

function showSteps({undo, redo}) {
  for (const [one, reason, key] of [[undoButton, undo, "Ctrl+Z"], [redoButton, redo, "Ctrl+Shift+Z"]]) {
    one.disabled = !reason;
    one.title = reason ? `${one === undoButton ? "Undo" : "Redo"}: ${reason} (${key})` : "";
  }
}

function showGoodness({good, problems}) {
  const {errors, warnings} = problemCounts(problems);
  const parts = [errors ? counted(errors, "error") : "", warnings ? counted(warnings, "warning") : ""].filter(Boolean);
  goodness.textContent = parts.join(", ") || (good ? "The graph is good." : "");
  goodness.className = `goodness ${errors ? "error" : warnings ? "warning" : "good"}`;
  lower[0].tab.textContent = problems.length ? `Problems (${problems.length})` : "Problems";
}

/** Enables the other views once the graph is valid. They show the last valid graph, and reload when opened. */
function showFreshness({page, page_revision}) {
  const none = !page, newest = none ? null : page_revision;
  freshness.shown ??= nodes.length ? newest : -1;
  freshness.stale = !none && newest !== freshness.shown;
  for (const view of views) {
    if (view.id === "edit" || !view.tab) continue;
    view.tab.disabled = none;
    view.tab.title = none ? "when the graph is good for the first time" : "";
  }
}

function showNotice() {
  noticeBox.hidden = !editing.notice;
  noticeBox.replaceChildren(
      editing.notice, button("×", () => say(""), {className: "plain", title: "Close", "aria-label": "Close"}));
}

watchEditing((what) => {
  showNotice();
  if (what === "library") editLibrary.show();
  if (what !== "state") return;
  const state = editing.client.state;
  document.title = `${state.file} – eagerx-gen`;
  document.getElementById("title").textContent = state.file;
  document.getElementById("summary").textContent = editing.client.lost ? "no connection to eagerx-gen serve" : "";
  showSteps(state);
  showGoodness(state);
  showFreshness(state);
  problemsBox.replaceChildren(problemList(showLineBelow));
  showText();
  showRun();
});

// ---- Keyboard shortcuts of the whole view -------------------------------------------------------------------------
function isTyping(target) {
  return target.matches("input, select, textarea");
}
document.addEventListener("keydown", (event) => {
  if (state.view?.id !== "edit" || connectDialog.open) return;
  const isCommand = event.ctrlKey || event.metaKey;
  if (isCommand && !isTyping(event.target) && (event.key.toLowerCase() === "z" || event.key === "y")) {
    stepBack(event.shiftKey || event.key === "y" ? "redo" : "undo");
    event.preventDefault();
  } else if (event.key === "Delete" && !isTyping(event.target) && event.target !== editSvg) {
    removeSelected();
  } else if (event.key === "l" && !isTyping(event.target) && !isCommand) {
    editLibrary.search.focus();
    event.preventDefault();
  } else if (event.key === "Escape" && isTyping(event.target) && event.target !== editSvg) {
    editSvg.focus();
  }
});

connectDialog.addEventListener("keydown", (event) => event.stopPropagation());  // shortcuts are inactive there

function makeEditView(panel) {
  panel.append(
      el("div.toolbar", {}, el("div.segment", {role: "group", "aria-label": "Steps"}, undoButton, redoButton), runTools,
         el("div.segment", {role: "group", "aria-label": "Zoom"},
            button("−", () => zoomEdit(0.8), {title: "Zoom out ( - )"}),
            button("+", () => zoomEdit(1.25), {title: "Zoom in ( + )"}),
            button("Fit", fitEdit, {title: "Show all ( 0 )"}),
            button("Arrange", arrange, {title: "Find places for all boxes anew"}))),
      noticeBox, editLibrary.panel, el("div.stage-of-graph", {}, editSvg), inspectPanel, lowerPanel, connectDialog);
  showLower("problems");
  onRun(() => showLower("programs"));
  openGraph().then(followRun);
  return {
    shown() {
      select(null);
      fitEdit();
    },
    resized: fitEdit,
    focus: editSvg
  };
}
moreViews.set("edit", makeEditView);
