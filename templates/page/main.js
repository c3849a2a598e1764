// Views, search, keys.
const views = [
  // Only pages that are told what a run sends have its function.
  {id: "live", name: "Live", make: (panel) => makeStreamView(panel), there: data.live === true},
  {id: "graph", name: "Graph", make: makeGraphView, there: true},
  {id: "timetable", name: "Timetable", make: makeTimetableView, there: true},
  {id: "memory", name: "Memory", make: makeMemoryView, there: true},
  {id: "ages", name: "Ages", make: makeAgesView, there: true},
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
  // Only pages with a module have its function.
  {id: "simulation", name: "Simulation", make: (panel) => makeSimulationView(panel), there: data.module !== undefined},
].filter((view) => view.there);

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

/** A view is made when it is looked at first. */
function showView(id) {
  const view = views.find((other) => other.id === id) || views[0];
  for (const other of views) {
    other.panel.hidden = other !== view;
    other.tab.setAttribute("aria-selected", other === view);
    other.tab.tabIndex = other === view ? 0 : -1;
  }
  state.view = view;
  hideTip();
  if (!view.parts) view.parts = view.make(view.panel);
  view.parts.shown();
  if (location.hash.slice(1) !== view.id) history.replaceState(null, "", `#${view.id}`);
}

document.getElementById("tabs").addEventListener("keydown", (event) => {
  const step = {ArrowLeft: -1, ArrowRight: 1}[event.key];
  if (!step) return;
  const next = views[(views.indexOf(state.view) + step + views.length) % views.length];
  showView(next.id);
  next.tab.focus();
});

// ---- Search ---------------------------------------------------------------------------------------------------------
const searchBox = document.getElementById("search"), foundBox = document.getElementById("found");
const searchable = [
  ...data.objects.map((object, i) => ({text: object.name, kind: "object", selected: {object: i}})),
  ...data.composites.map((composite, i) => ({text: composite.name, kind: "composite", selected: {composite: i}})),
  ...nodes.map((node, i) => ({text: node.name, kind: node.role, selected: {node: i}})),
  ...nodes.flatMap((node) => node.outputs.map((output, o) => ({
                                                text: outputName(node.number, o),
                                                kind: node.number === 0 ? "action" : "output",
                                                selected: {node: node.number}
                                              }))),
  ...nodes.flatMap((node) => node.inputs.map((input) => ({
                                               text: input.written,
                                               kind: node.number === 0 ? "observation" : "input",
                                               selected: {input: [node.number, input.number]}
                                             }))),
].map((item) => ({...item, lower: item.text.toLowerCase()}));
let found = [], current = 0;

function find() {
  const wanted = searchBox.value.trim().toLowerCase();
  const rank = (item) => (item.lower === wanted ? 0 : item.lower.startsWith(wanted) ? 1 : 2);
  found = wanted ?
      searchable.filter((item) => item.lower.includes(wanted)).sort((a, b) => rank(a) - rank(b)).slice(0, 12) :
      [];
  current = 0;
  foundBox.replaceChildren(...found.map(
      (item, i) =>
          el("li", {
            role: "option",
            onpointerdown: (event) => {
              event.preventDefault();
              choose(i);
            }
          },
             el("span", {}, item.text), el("small", {}, item.kind))));
  if (wanted && !found.length) foundBox.append(el("li.none", {}, "nothing"));
  foundBox.hidden = !wanted;
  markFound();
}
function markFound() {
  [...foundBox.children].forEach((child, i) => child.setAttribute("aria-selected", i === current));
}
function choose(i) {
  if (!found[i]) return;
  foundBox.hidden = true;
  select(found[i].selected);
  if (state.view.id === "timetable")
    state.view.parts.shown();
  else
    showInGraph();
  (state.view.parts.focus || searchBox).focus();
}
searchBox.addEventListener("input", find);
searchBox.addEventListener("focus", find);
searchBox.addEventListener("blur", () => {
  foundBox.hidden = true;
});
searchBox.addEventListener("keydown", (event) => {
  if (event.key === "ArrowDown")
    current = Math.min(found.length - 1, current + 1);
  else if (event.key === "ArrowUp")
    current = Math.max(0, current - 1);
  else if (event.key === "Enter")
    return choose(current);
  else if (event.key === "Escape") {
    searchBox.value = "";
    return searchBox.blur();
  } else
    return;
  event.preventDefault();
  markFound();
});

// ---- Keys -----------------------------------------------------------------------------------------------------------
const help = document.getElementById("help");
function showHelp() {
  const keys = [
    ["1 … 9", "views"], ["/", "search"], ["Escape", "nothing is selected"], ["t", "light or dark"],
    ["arrows", "graph: from box to box; timetable and plots: move"], ["Shift and arrows", "graph: move"],
    ["+ −", "zoom"], ["0", "show all"], ["e", "graph: as written, as it runs"],
    ["Enter", "graph: opens a composite, or closes the one around"], ["o", "graph: all of them"],
    ["Space", "plots: plays the drawing"], ["wheel", "zoom where the pointer is; in a long timetable with Ctrl"],
    ["?", "these keys"]
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
  if (number >= 1 && number <= views.length)
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

// ---- Begin ----------------------------------------------------------------------------------------------------------
const {info} = data;
document.title = `${info.name} – eagerx-gen report`;
document.getElementById("title").textContent = info.name;
document.getElementById("summary").textContent = [
  counted(nodes.length, "node"), info.engine === "none" ? "no engine" : `on ${info.engine}`, `${nodes[0].rate} Hz`,
  `agent ${data.agent}`
].join(" · ");
new ResizeObserver(onFrame(() => state.view && state.view.parts.resized())).observe(document.getElementById("views"));
addEventListener("hashchange", () => showView(location.hash.slice(1)));
showTheme(prefersDark.matches);
showView(location.hash.slice(1) || (data.live ? "live" : data.module ? "simulation" : "graph"));
