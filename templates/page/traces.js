// Plots of what runs sent: one cursor through all, episodes over each other or side by side. Of long traces each point
// is the least and the greatest value of a part of the time.
function floats(text) {
  const raw = atob(text), values = new Float32Array(raw.length / 4);
  const view = new DataView(Uint8Array.from(raw, (c) => c.charCodeAt(0)).buffer);
  for (let i = 0; i < values.length; ++i) values[i] = view.getFloat32(4 * i, true);
  return values;
}

// A run is an episode of a trace.
const runs = data.logs.flatMap(
    (log, l) => log.episodes.map(
        (episode) => ({
          log,
          episode,
          name: data.logs.length > 1 ? `${l + 1}: episode ${episode.number}` : `episode ${episode.number}`
        })));
runs.forEach((run, number) => {
  run.number = number;
});
const plots = {
  runs: new Set(),
  series: new Set(),
  beside: false,
  begin: 0,
  span: 1,
  cursor: null,
  rows: [],
  draw: null,
  stage: null
};
const seriesList = [];

/** What can be plotted: a channel, or how late its messages were. */
function makeSeries() {
  const names = new Map();
  for (const log of data.logs)
    for (const channel of log.channels)
      if (!names.has(channel.name)) names.set(channel.name, channel);
  for (const [name, channel] of names) {
    const known = data.channels.find((other) => other.name === name);
    const output = known && nodes[known.node].outputs[known.output];
    const title = known ? outputName(known.node, known.output) : name;
    seriesList.push({
      name,
      title,
      unit: output ? output.unit : "",
      node: known ? known.node : null,
      size: channel.size,
      late: false
    });
  }
  if (data.logs.some((log) => log.paced))
    for (const {name, title} of [...seriesList])
      seriesList.push({name, title: `late: ${title}`, unit: "s", node: null, size: 1, late: true});
  seriesList.forEach((series, number) => {
    series.number = number;
  });
}

/** The points of a series in a run; null if it has none. */
function pointsOf(series, run) {
  const key = `points${series.number}`;
  if (run[key] !== undefined) return run[key];
  const number = run.log.channels.findIndex((channel) => channel.name === series.name);
  const channel = number < 0 ? null : run.episode.channels[number];
  const elements = !channel || !channel.messages ? [] :
      series.late                                ? [channel.lateness].filter(Boolean) :
                                                   channel.elements;
  if (!elements.length) return (run[key] = null);
  const {rate_hz} = run.log.channels[number];
  return (run[key] = {
    begin: channel.first / rate_hz,
    step: channel.per / rate_hz,
    messages: channel.messages,
    thinned: channel.per > 1 ? channel.per : 0,
    elements: elements.map((element) => ({
                             low: floats(element.low),
                             high: element.high ? floats(element.high) : null,
                             notFinite: element.not_finite || 0
                           }))
  });
}

function defaultSeries() {
  const important = new Set();
  nodes[0].outputs.forEach((_, o) => important.add(`0/${o}`));
  nodes[0].inputs.forEach((input) => important.add(input.source.join("/")));
  const names = new Set(data.channels.filter((channel) => important.has(`${channel.node}/${channel.output}`))
                            .map((channel) => channel.name));
  return seriesList.filter((series) => !series.late && names.has(series.name)).slice(0, 6);
}

const chosenRuns = () => runs.filter((run) => plots.runs.has(run.number));

function wholeSpan() {
  let end = 0;
  for (const run of chosenRuns())
    for (const [c, channel] of run.episode.channels.entries())
      end = Math.max(end, (channel.first + channel.messages) / run.log.channels[c].rate_hz);
  return end || 1;
}

function placePlots(begin, span) {
  const whole = wholeSpan();
  plots.span = Math.min(Math.max(span, whole * 1e-5), whole * 1.02);
  plots.begin = Math.min(Math.max(begin, -0.01 * whole), whole * 1.01 - plots.span);
  plots.draw();
}
const fitPlots = () => placePlots(0, wholeSpan());
function zoomPlots(factor, time = null) {
  const at = time ?? plots.cursor ?? plots.begin + plots.span / 2;
  placePlots(at - (at - plots.begin) * factor, plots.span * factor);
}

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
    const title = series.node !== null ? button(series.title, () => select({node: series.node}), {className: "plain"}) :
                                         el("span", {}, series.title);
    const groups = plots.beside ? of.map((run) => [run]) : [of];
    const cells = groups.map((group) => ({runs: group, canvas: el("canvas")}));
    const element =
        el("article.plot", {}, el("header", {}, title, el("small", {}, more), values),
           el("div.cells", {},
              cells.map(
                  (cell) =>
                      el("div.cell", {}, plots.beside && of.length > 1 ? el("small.over", {}, cell.runs[0].name) : null,
                         cell.canvas))));
    return {series, element, cells, values};
  });
  layOutPictures();
  plots.stage.replaceChildren(...plots.rows.map((row) => row.element));
  if (!plots.rows.length || !of.length) plots.stage.append(el("p.note", {}, "Choose a channel and an episode."));
  plots.draw();
}

function plotNode(number) {
  showView("traces");
  plots.series =
      new Set(seriesList.filter((series) => series.node === number && !series.late).map((series) => series.number));
  showChoices();
  layOutPlots();
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
                   el("span", {}, series.title))),
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

/** The time under the pointer, and how many seconds a pixel is; null if it is on no plot. */
function plotAt(event) {
  const canvas = event.target.closest("canvas");
  if (!canvas) return null;
  const box = canvas.getBoundingClientRect(), scale = plots.span / (box.width - kLeft);
  return {time: plots.begin + (event.clientX - box.left - kLeft) * scale, scale};
}

function makeTracesView(panel) {
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
                             (beside) => {
                               plots.beside = beside;
                               layOutPlots();
                             }) :
                         null,
       el("div.segment", {role: "group", "aria-label": "Zoom"}, button("−", () => zoomPlots(1.25)),
          button("+", () => zoomPlots(0.8)), button("Fit", fitPlots)),
       runChooser(), plots.time),
    ...data.logs.map(logNote), statesNote(),
    el("div.split", {}, el("div.beside", {}, playbackCard(), seriesChooser()), plots.stage)
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
    if (!at || event.shiftKey) return;  // scrolls
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
