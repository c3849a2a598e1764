// Plots of runs with a common cursor, and episodes superimposed or side by side. In long traces, each point is the
// minimum and the maximum over an interval.
import {data} from "./data.mjs";
import {add, breakable, button, el, segment, table} from "./elements.mjs";
import {count, counted, list} from "./numbers.mjs";
import {layOutPictures, playback, playbackCard, playTrace} from "./playback.mjs";
import {colourOf, kLeft} from "./plots.mjs";
import {draggable} from "./pointer.mjs";
import {
  chosenRuns,
  defaultSeries,
  fitPlots,
  makeSeries,
  placePlots,
  plots,
  pointsOf,
  runs,
  seriesList,
  zoomPlots
} from "./runs.mjs";
import {select} from "./selection.mjs";
import {showView} from "./views.mjs";

// ---- Rows -----------------------------------------------------------------------------------------------------------
function layOutPlots() {
  const of = chosenRuns();
  for (const run of runs)
    if (run.chip)
      run.chip.firstChild.style.background = of.length > 1 && of.includes(run) ? colourOf(run, 0) : "transparent";
  plots.rows = seriesList.filter((series) => plots.series.has(series.number)).map((series) => {
    const values = el("span.values");
    const thinned = Math.max(0, ...of.map((run) => (pointsOf(series, run) || {thinned: 0}).thinned));
    const bad = of.reduce(
        (sum, run) => sum + (pointsOf(series, run) || {elements: []}).elements.reduce((all, e) => all + e.notFinite, 0),
        0);
    const more = [
      series.unit, series.size > 16 ? `first 16 of ${count(series.size)} elements` : "",
      thinned ? `least and greatest of ${count(thinned)} messages` : "", bad ? `${count(bad)} not finite` : ""
    ].filter(Boolean).join(", ");
    const title = series.node !== null ?
        button(breakable(series.title), () => select({node: series.node}), {className: "plain"}) :
        el("span", {}, breakable(series.title));
    const groups = plots.sideBySide ? of.map((run) => [run]) : [of];
    const cells = groups.map((group) => ({runs: group, canvas: el("canvas")}));
    const element = el(
        "article.plot", {}, el("header", {}, title, el("small", {}, more), values),
        el("div.cells", {},
           cells.map(
               (cell) => el(
                   "div.cell", {}, plots.sideBySide && of.length > 1 ? el("small.over", {}, cell.runs[0].name) : null,
                   cell.canvas))));
    return {series, element, cells, values};
  });
  layOutPictures();
  plots.stage.replaceChildren(...plots.rows.map((row) => row.element));
  if (!plots.rows.length || !of.length) plots.stage.append(el("p.note", {}, "Choose a channel and an episode."));
  plots.draw();
}

export function plotNode(number) {
  showView("traces");
  plots.series =
      new Set(seriesList.filter((series) => series.node === number && !series.late).map((series) => series.number));
  showChoices();
  layOutPlots();
}

/** Shows these runs, side by side if there are several. */
export function plotRuns(chosen) {
  showView("traces");
  plots.runs = new Set(chosen.map((run) => run.number));
  for (const run of runs) run.chip.setAttribute("aria-pressed", plots.runs.has(run.number));
  layOutPlots();
  fitPlots();
}

let showChoices = () => {};
function seriesChooser() {
  const box = el("div.channels"),
        filter = el("input", {type: "search", placeholder: "Filter channels", "aria-label": "Filter channels"});
  showChoices = () => {
    const wanted = filter.value.trim().toLowerCase();
    const shown = seriesList.filter((series) => series.title.toLowerCase().includes(wanted));
    const group = (late) => {
      const own = shown.filter((series) => series.late === late);
      return [
        own.slice(0, 300).map(
            (series) =>
                el("label", {}, el("input", {
                     type: "checkbox",
                     checked: plots.series.has(series.number),
                     onchange: (event) => {
                       plots.series[event.target.checked ? "add" : "delete"](series.number);
                       layOutPlots();
                     }
                   }),
                   el("span", {}, breakable(series.title)))),
        own.length > 300 ? el("p.note", {}, `and ${count(own.length - 300)} more`) : null
      ];
    };
    const late = group(true);
    box.replaceChildren();
    add(box, [
      group(false),
      late[0].length ? el("details", {open: wanted !== ""}, el("summary", {}, "How late messages were"), late) : null
    ]);
  };
  filter.addEventListener("input", () => showChoices());
  return el("div.chooser", {}, filter, box);
}

function runChooser() {
  return el("div.runs", {role: "group", "aria-label": "Episodes"}, runs.map((run) => {
    const chip =
        el("button.chip", {
          type: "button",
          onclick: () => {
            if (!plots.runs.delete(run.number)) plots.runs.add(run.number);
            chip.setAttribute("aria-pressed", plots.runs.has(run.number));
            layOutPlots();
          }
        },
           el("i.mark"), run.name);
    chip.setAttribute("aria-pressed", plots.runs.has(run.number));
    run.chip = chip;
    return chip;
  }));
}

function logNote(log, l) {
  const parts = [
    data.logs.length > 1 ? `${l + 1}: ${log.name}` : log.name, `agent ${log.agent}`, `seed ${log.seed}`,
    counted(log.messages, "message"),
    log.all_episodes > log.episodes.length ?
        `the first ${log.episodes.length} of ${counted(log.all_episodes, "episode")}` :
        counted(log.all_episodes, "episode"),
    log.complete ? `hash ${log.hash}` : "ends early",
    log.timed && !log.paced ? "not paced: its times say nothing of the timetable" : ""
  ];
  return el("p.note", {}, parts.filter(Boolean).join(" · "));
}

function statesNote() {
  const rows = runs.flatMap((run) => run.episode.states.map((begun) => ({run, begun})));
  if (!rows.length) return null;
  return el(
      "details", {}, el("summary", {}, "What the episodes began with"),
      table(
          [
            {name: "episode", cell: (row) => row.run.name}, {name: "state", cell: (row) => row.begun.name},
            {name: "value", cell: (row) => list(row.begun.values, 12)}
          ],
          rows, 60));
}

function plotsKey(event) {
  const step = plots.span / 200;
  const move = (by) => {
    plots.cursor = Math.max(0, (plots.cursor ?? plots.begin + plots.span / 2) + by);
  };
  const actions = {
    ArrowLeft: () => (event.shiftKey ? placePlots(plots.begin - plots.span * 0.2, plots.span) : move(-step)),
    ArrowRight: () => (event.shiftKey ? placePlots(plots.begin + plots.span * 0.2, plots.span) : move(step)),
    "+": () => zoomPlots(0.8),
    "=": () => zoomPlots(0.8),
    "-": () => zoomPlots(1.25),
    0: fitPlots,
    " ": () => playback.pictures.length && playTrace(!playback.playing)
  };
  if (!actions[event.key] || event.target.matches("input")) return;
  actions[event.key]();
  plots.draw();
  event.preventDefault();
}

/** Time at the pointer, and seconds per pixel; null if the pointer is not on a plot. */
function plotAt(event) {
  const canvas = event.target.closest("canvas");
  if (!canvas) return null;
  const box = canvas.getBoundingClientRect(), scale = plots.span / (box.width - kLeft);
  return {time: plots.begin + (event.clientX - box.left - kLeft) * scale, scale};
}

export function makeTracesView(panel) {
  makeSeries();
  runs.slice(0, 3).forEach((run) => plots.runs.add(run.number));
  defaultSeries().forEach((series) => plots.series.add(series.number));
  plots.stage = el("div.plots", {
    tabIndex: 0,
    role: "application",
    "aria-label": "Plots. Arrow keys move the cursor, plus and minus zoom, Space plays."
  });
  plots.time = el("span.note");
  add(panel, [
    el("div.toolbar", {},
       runs.length > 1 ? segment(
                             "Episodes", [[false, "Overlaid"], [true, "Side by side"]], false,
                             (sideBySide) => {
                               plots.sideBySide = sideBySide;
                               layOutPlots();
                             }) :
                         null,
       el("div.segment", {role: "group", "aria-label": "Zoom"}, button("−", () => zoomPlots(1.25)),
          button("+", () => zoomPlots(0.8)), button("Fit", fitPlots)),
       runChooser(), plots.time),
    ...data.logs.map(logNote), statesNote(),
    el("div.split", {}, el("div.side", {}, playbackCard(), seriesChooser()), plots.stage)
  ]);
  let scale = 0;
  plots.stage.addEventListener("pointerdown", (event) => {
    const at = plotAt(event);
    scale = at ? at.scale : 0;
  });
  draggable(plots.stage, (dx) => placePlots(plots.begin - dx * scale, plots.span), () => {});
  plots.stage.addEventListener("pointermove", (event) => {
    const at = plotAt(event);
    if (at && !playback.playing) {
      plots.cursor = Math.max(0, at.time);
      plots.draw();
    }
  });
  plots.stage.addEventListener("wheel", (event) => {
    const at = plotAt(event);
    if (!at || event.shiftKey) return;  // the page scrolls
    event.preventDefault();
    zoomPlots(Math.exp(event.deltaY * 0.0015), at.time);
  }, {passive: false});
  plots.stage.addEventListener("scroll", plots.draw);
  plots.stage.addEventListener("keydown", plotsKey);
  showChoices();
  layOutPlots();
  fitPlots();
  return {
    shown() {
      plots.draw();
    },
    resized: layOutPlots,
    focus: plots.stage
  };
}
