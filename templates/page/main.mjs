// The page: its views, keyboard shortcuts and colors.
import "./inspector.mjs";

import {makeAgesView} from "./ages.mjs";
import {isDark, onFrame} from "./canvas.mjs";
import {data, nodes} from "./data.mjs";
import {button, el} from "./elements.mjs";
import {makeFactsView} from "./facts.mjs";
import {makeGraphView} from "./graph.mjs";
import {makeMemoryView} from "./memory.mjs";
import {counted} from "./numbers.mjs";
import {makePolicyView} from "./policies.mjs";
import {searchBox} from "./search.mjs";
import {select, state} from "./selection.mjs";
import {makeSourceView} from "./source.mjs";
import {makeTimetableView} from "./timetable.mjs";
import {makeTracesView} from "./traces.mjs";
import {moreViews, showView, views} from "./views.mjs";

const allViews = [
  {id: "edit", name: "Edit", make: moreViews.get("edit"), there: moreViews.has("edit")},
  {id: "live", name: "Live", make: moreViews.get("live"), there: moreViews.has("live")},
  {id: "training", name: "Training", make: moreViews.get("training"), there: moreViews.has("training")},
  {id: "graph", name: "Graph", make: makeGraphView, there: true},
  {id: "timetable", name: "Timetable", make: makeTimetableView, there: true},
  {id: "memory", name: "Memory", make: makeMemoryView, there: true},
  {id: "ages", name: "Ages", make: makeAgesView, there: true},
  {id: "loop", name: "Loop", make: moreViews.get("loop"), there: moreViews.has("loop")},
  {
    id: "policy",
    name: data.policies.length > 1 ? "Policies" : "Policy",
    make: makePolicyView,
    there: data.policies.length > 0
  },
  {id: "facts", name: "Facts", make: makeFactsView, there: true},
  {
    id: "source",
    name: "File",
    make: makeSourceView,
    there: data.source.lines.length > 0,
    badge: data.diagnostics.filter((problem) => problem.severity === "warning").length
  },
  {id: "traces", name: "Traces", make: makeTracesView, there: data.logs.length > 0},
  {id: "simulation", name: "Simulation", make: moreViews.get("simulation"), there: moreViews.has("simulation")},
];
views.push(...allViews.filter((view) => view.there));

for (const view of views) {
  view.tab =
      el("button", {
        type: "button",
        id: `tab-${view.id}`,
        role: "tab",
        "aria-controls": `view-${view.id}`,
        onclick: () => showView(view.id)
      },
         view.name, view.badge ? el("span.badge", {title: counted(view.badge, "warning")}, view.badge) : null);
  view.panel =
      el("section." + view.id,
         {id: `view-${view.id}`, role: "tabpanel", "aria-labelledby": `tab-${view.id}`, hidden: true});
  document.getElementById("tabs").append(view.tab);
  document.getElementById("views").append(view.panel);
}

document.getElementById("tabs").addEventListener("keydown", (event) => {
  const step = {ArrowLeft: -1, ArrowRight: 1}[event.key];
  if (!step) return;
  const open = views.filter((view) => !view.tab.disabled);
  const next = open[(open.indexOf(state.view) + step + open.length) % open.length];
  showView(next.id);
  next.tab.focus();
});

const kEditKeys = [
  ["l", "edit: search the library"], ["c", "edit: connect the box"], ["Shift and arrows", "edit: move the box"],
  ["Enter", "edit: to the form, or send what was typed"], ["Delete", "edit: delete what is selected"],
  ["Ctrl+Z, Ctrl+Shift+Z", "edit: undo, redo"]
];

// ---- Keyboard shortcuts ---------------------------------------------------------------------------------------------
const help = document.getElementById("help");
function showHelp() {
  const keys = [
    ["1 … 9", "views"], ["/", "search"], ["Escape", "nothing is selected"], ["t", "light or dark"],
    ["arrows", "graph: from box to box; timetable and plots: move"], ["Shift and arrows", "graph: move"],
    ["+ −", "zoom"], ["0", "show all"], ["e", "graph: as written, as it runs"],
    ["Enter", "graph: opens a composite, or closes the one around"], ["o", "graph: all of them"],
    ["Space", "plots: plays the drawing"], ["wheel", "zoom where the pointer is; in a long timetable with Ctrl"],
    ...(moreViews.has("edit") ? kEditKeys : []), ["?", "these keys"]
  ];
  help.replaceChildren(
      el("h2", {}, "Keys"),
      el("dl.pairs", {}, keys.map(([key, what]) => [el("dt", {}, el("kbd", {}, key)), el("dd", {}, what)])),
      button("Close", () => help.close()));
  help.showModal();
}
document.getElementById("keys").addEventListener("click", showHelp);

const prefersDark = matchMedia("(prefers-color-scheme: dark)");
function showTheme(dark) {
  document.documentElement.dataset.theme = dark ? "dark" : "light";
  document.getElementById("theme").textContent = dark ? "☀" : "☾";
  if (state.view) state.view.parts.resized();
}
const changeTheme = () => showTheme(!isDark());
document.getElementById("theme").addEventListener("click", changeTheme);
prefersDark.addEventListener("change", () => showTheme(prefersDark.matches));

document.addEventListener("keydown", (event) => {
  if (event.target.matches("input, select, textarea") || event.ctrlKey || event.metaKey || event.altKey || help.open)
    return;
  const number = Number(event.key);
  if (number >= 1 && number <= views.length && !views[number - 1].tab.disabled)
    showView(views[number - 1].id);
  else if (event.key === "/")
    searchBox.focus();
  else if (event.key === "?")
    showHelp();
  else if (event.key === "t")
    changeTheme();
  else if (event.key === "Escape")
    select(null);
  else
    return;
  event.preventDefault();
});

// ---- Startup --------------------------------------------------------------------------------------------------------
const {info} = data;
document.title = `${info.name} – eagerx-gen report`;
document.getElementById("title").textContent = info.name;
document.getElementById("summary").textContent = nodes.length ?
    [
      counted(nodes.length, "node"), info.engine === "none" ? "no engine" : `on ${info.engine}`, `${nodes[0].rate} Hz`,
      `agent ${data.agent}`
    ].join(" · ") :
                                                              "";
new ResizeObserver(onFrame(() => state.view && state.view.parts.resized())).observe(document.getElementById("views"));
addEventListener("hashchange", () => showView(location.hash.slice(1)));
showTheme(prefersDark.matches);
const firstView = data.served ? "edit" :
    data.live                 ? "live" :
    data.training             ? "training" :
    data.module               ? "simulation" :
                                "graph";
showView(nodes.length ? location.hash.slice(1) || firstView : firstView);
