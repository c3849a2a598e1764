// Plots of what runs sent: one cursor through all, episodes over each other or side by side. Of long traces each point
// is the least and the greatest value of a part of the time.
function floats(text) {
  const raw = atob(text), values = new Float32Array(raw.length / 4);
  const view = new DataView(Uint8Array.from(raw, (c) => c.charCodeAt(0)).buffer);
  for (let i = 0; i < values.length; ++i) values[i] = view.getFloat32(4 * i, true);
  return values;
}

// A run is an episode of a trace.
const runs = data.logs.flatMap((log, l) => log.episodes.map((episode) => ({log, episode,
  name: data.logs.length > 1 ? `${l + 1}: episode ${episode.number}` : `episode ${episode.number}`})));
runs.forEach((run, number) => { run.number = number; });
const plots = {runs: new Set(), series: new Set(), beside: false, begin: 0, span: 1, cursor: null, rows: [], draw: null, stage: null};
const seriesList = [];

/** What can be plotted: a channel, or how late its messages were. */
function makeSeries() {
  const names = new Map();
  for (const log of data.logs) for (const channel of log.channels) if (!names.has(channel.name)) names.set(channel.name, channel);
  for (const [name, channel] of names) {
    const known = data.channels.find((other) => other.name === name);
    const output = known && nodes[known.node].outputs[known.output];
    const title = known ? outputName(known.node, known.output) : name;
    seriesList.push({name, title, unit: output ? output.unit : "", node: known ? known.node : null, size: channel.size, late: false});
  }
  if (data.logs.some((log) => log.paced))
    for (const {name, title} of [...seriesList]) seriesList.push({name, title: `late: ${title}`, unit: "s", node: null, size: 1, late: true});
  seriesList.forEach((series, number) => { series.number = number; });
}

/** The points of a series in a run; null if it has none. */
function pointsOf(series, run) {
  const key = `points${series.number}`;
  if (run[key] !== undefined) return run[key];
  const number = run.log.channels.findIndex((channel) => channel.name === series.name);
  const channel = number < 0 ? null : run.episode.channels[number];
  const elements = !channel || !channel.messages ? [] : series.late ? [channel.lateness].filter(Boolean) : channel.elements;
  if (!elements.length) return (run[key] = null);
  const {rate_hz} = run.log.channels[number];
  return (run[key] = {begin: channel.first / rate_hz, step: channel.per / rate_hz, messages: channel.messages,
    thinned: channel.per > 1 ? channel.per : 0,
    elements: elements.map((element) => ({low: floats(element.low), high: element.high ? floats(element.high) : null, notFinite: element.not_finite || 0}))});
}

function defaultSeries() {
  const important = new Set();
  nodes[0].outputs.forEach((_, o) => important.add(`0/${o}`));
  nodes[0].inputs.forEach((input) => important.add(input.source.join("/")));
  const names = new Set(data.channels.filter((channel) => important.has(`${channel.node}/${channel.output}`)).map((channel) => channel.name));
  return seriesList.filter((series) => !series.late && names.has(series.name)).slice(0, 6);
}

const chosenRuns = () => runs.filter((run) => plots.runs.has(run.number));

function wholeSpan() {
  let end = 0;
  for (const run of chosenRuns()) for (const [c, channel] of run.episode.channels.entries())
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

// ---- Drawing --------------------------------------------------------------------------------------------------------
const kLeft = 62, kBottom = 18;

/** Least and greatest of what is to be seen. */
function rangeOf(series, of) {
  let [low, high] = [Infinity, -Infinity];
  for (const run of of) {
    const points = pointsOf(series, run);
    if (!points) continue;
    const from = Math.max(0, Math.floor((plots.begin - points.begin) / points.step));
    for (const element of points.elements) {
      const to = Math.min(element.low.length - 1, Math.ceil((plots.begin + plots.span - points.begin) / points.step));
      for (let i = from; i <= to; ++i) {
        if (element.low[i] < low) low = element.low[i];
        const top = element.high ? element.high[i] : element.low[i];
        if (top > high) high = top;
      }
    }
  }
  if (low > high) return [0, 1];
  const room = (high - low || Math.abs(high) || 1) * 0.08;
  return [low - room, high + room];
}

function drawAxes(context, width, height, [low, high], last) {
  const bottom = height - (last ? kBottom : 4), y = (value) => bottom - ((value - low) / (high - low)) * (bottom - 6);
  context.strokeStyle = colour("grid");
  context.fillStyle = colour("faint");
  context.lineWidth = 1;
  context.textAlign = "right";
  context.beginPath();
  const step = stepOf(high - low, Math.max(2, (bottom - 6) / 26));
  for (let i = Math.ceil(low / step); i * step <= high; ++i) {
    const at = Math.round(y(i * step)) + 0.5;
    context.moveTo(kLeft, at);
    context.lineTo(width, at);
    context.fillText(short(i * step, 4), kLeft - 8, at);
  }
  const x = (time) => kLeft + ((time - plots.begin) / plots.span) * (width - kLeft);
  const seconds10 = stepOf(plots.span, (width - kLeft) / 90);
  const digits = Math.max(0, -Math.floor(Math.log10(seconds10)));
  context.textAlign = "center";
  for (let i = Math.max(0, Math.ceil(plots.begin / seconds10)); i * seconds10 <= plots.begin + plots.span; ++i) {
    const at = Math.round(x(i * seconds10)) + 0.5;
    context.moveTo(at, 6);
    context.lineTo(at, bottom);
    if (last && at < width - 14) context.fillText(`${(i * seconds10).toFixed(digits)} s`, at, height - 7);
  }
  context.stroke();
  return {x, y, bottom};
}

function drawElement(context, points, element, {x, y}, fill) {
  const from = Math.max(0, Math.floor((plots.begin - points.begin) / points.step) - 1);
  const to = Math.min(element.low.length - 1, Math.ceil((plots.begin + plots.span - points.begin) / points.step) + 1);
  const at = (i) => x(points.begin + i * points.step);
  context.strokeStyle = context.fillStyle = fill;
  context.lineWidth = 1.4;
  if (element.high) {  // a band, and its outline so that a thin one can be seen
    context.beginPath();
    for (let i = from; i <= to; ++i) {
      if (Number.isNaN(element.low[i])) continue;
      const top = y(element.high[i]), below = y(element.low[i]);
      context.rect(at(i), top - 0.6, Math.max(0.8, at(i + 1) - at(i)), below - top + 1.2);
    }
    return context.fill();
  }
  context.beginPath();
  let before = null;
  for (let i = from; i <= to; ++i) {
    const value = element.low[i];
    if (Number.isNaN(value)) { before = null; continue; }
    if (before === null) context.moveTo(at(i), y(value));
    else { context.lineTo(at(i), y(before)); context.lineTo(at(i), y(value)); }  // a message holds until the next
    before = value;
  }
  if (before !== null) context.lineTo(at(to + 1), y(before));
  context.stroke();
}

/** Several runs have a colour each; a single one has one for each element. */
function colourOf(run, element) {
  const place = chosenRuns().indexOf(run);
  return shade(plots.runs.size > 1 ? place + (plots.beside ? element : 0) : element);
}

function drawCanvas(row, cell, range, last) {
  const box = cell.canvas.parentElement.getBoundingClientRect(), height = last ? 128 : 112;
  const width = Math.floor(box.width);
  const context = prepare(cell.canvas, width, height);
  if (!context) return;
  const axes = drawAxes(context, width, height, range, last);
  context.save();
  context.beginPath();
  context.rect(kLeft, 0, width - kLeft, axes.bottom + 2);
  context.clip();
  for (const run of cell.runs) {
    const points = pointsOf(row.series, run);
    if (points) points.elements.forEach((element, e) => drawElement(context, points, element, axes, colourOf(run, e)));
  }
  if (plots.cursor !== null) {
    context.strokeStyle = colour("cursor");
    context.lineWidth = 1;
    context.beginPath();
    const at = Math.round(axes.x(plots.cursor)) + 0.5;
    context.moveTo(at, 0);
    context.lineTo(at, axes.bottom);
    context.stroke();
  }
  context.restore();
}

/** What is at the cursor. */
function readOut(row) {
  if (plots.cursor === null) return row.values.replaceChildren();
  const parts = [];
  const of = chosenRuns();
  for (const run of of) {
    const points = pointsOf(row.series, run);
    if (!points) continue;
    const i = Math.floor((plots.cursor - points.begin) / points.step + 1e-6);
    points.elements.slice(0, 6).forEach((element, e) => {
      if (i < 0 || i >= element.low.length) return;
      const text = element.high ? `${short(element.low[i])} … ${short(element.high[i])}` : short(element.low[i], 6);
      const mark = el("i.mark");
      mark.style.background = colourOf(run, e);
      parts.push(el("span", {title: run.name + (points.elements.length > 1 ? `, element ${e}` : "")}, mark, text));
    });
  }
  row.values.replaceChildren(...parts.slice(0, 16));
}

function drawPlots() {
  const frame = plots.stage.getBoundingClientRect();
  const of = chosenRuns();
  plots.rows.forEach((row, r) => {
    const box = row.element.getBoundingClientRect();
    if (box.bottom < frame.top - 50 || box.top > frame.bottom + 50) return;
    const range = rangeOf(row.series, of);
    for (const cell of row.cells) drawCanvas(row, cell, range, r === plots.rows.length - 1 || r % 4 === 3);
    readOut(row);
  });
  plots.time.textContent = plots.cursor === null ? "" : `cursor at ${seconds(plots.cursor)}`;
}
plots.draw = onFrame(drawPlots);

// ---- Rows -----------------------------------------------------------------------------------------------------------
function layOutPlots() {
  const of = chosenRuns();
  for (const run of runs) if (run.chip) run.chip.firstChild.style.background = of.length > 1 && of.includes(run) ? colourOf(run, 0) : "transparent";
  plots.rows = seriesList.filter((series) => plots.series.has(series.number)).map((series) => {
    const values = el("span.values");
    const thinned = Math.max(0, ...of.map((run) => (pointsOf(series, run) || {thinned: 0}).thinned));
    const bad = of.reduce((sum, run) => sum + (pointsOf(series, run) || {elements: []}).elements.reduce((all, e) => all + e.notFinite, 0), 0);
    const more = [series.unit, series.size > 16 ? `first 16 of ${count(series.size)} elements` : "",
      thinned ? `least and greatest of ${count(thinned)} messages` : "", bad ? `${count(bad)} not finite` : ""].filter(Boolean).join(", ");
    const title = series.node !== null ? button(series.title, () => select({node: series.node}), {className: "plain"}) : el("span", {}, series.title);
    const groups = plots.beside ? of.map((run) => [run]) : [of];
    const cells = groups.map((group) => ({runs: group, canvas: el("canvas")}));
    const element = el("article.plot", {}, el("header", {}, title, el("small", {}, more), values),
      el("div.cells", {}, cells.map((cell) => el("div.cell", {}, plots.beside && of.length > 1 ? el("small.over", {}, cell.runs[0].name) : null, cell.canvas))));
    return {series, element, cells, values};
  });
  plots.stage.replaceChildren(...plots.rows.map((row) => row.element));
  if (!plots.rows.length || !of.length) plots.stage.append(el("p.note", {}, "Choose a channel and an episode."));
  plots.draw();
}

function plotNode(number) {
  showView("traces");
  plots.series = new Set(seriesList.filter((series) => series.node === number && !series.late).map((series) => series.number));
  showChoices();
  layOutPlots();
}

let showChoices = () => {};
function seriesChooser() {
  const box = el("div.channels"), filter = el("input", {type: "search", placeholder: "Filter channels", "aria-label": "Filter channels"});
  showChoices = () => {
    const wanted = filter.value.trim().toLowerCase();
    const shown = seriesList.filter((series) => series.title.toLowerCase().includes(wanted));
    const group = (late) => {
      const own = shown.filter((series) => series.late === late);
      return [own.slice(0, 300).map((series) => el("label", {}, el("input", {type: "checkbox", checked: plots.series.has(series.number),
        onchange: (event) => { plots.series[event.target.checked ? "add" : "delete"](series.number); layOutPlots(); }}), el("span", {}, series.title))),
      own.length > 300 ? el("p.note", {}, `and ${count(own.length - 300)} more`) : null];
    };
    const late = group(true);
    box.replaceChildren();
    add(box, [group(false), late[0].length ? el("details", {open: wanted !== ""}, el("summary", {}, "How late messages were"), late) : null]);
  };
  filter.addEventListener("input", () => showChoices());
  return el("div.chooser", {}, filter, box);
}

function runChooser() {
  return el("div.runs", {role: "group", "aria-label": "Episodes"}, runs.map((run) => {
    const chip = el("button.chip", {type: "button", onclick: () => {
      if (!plots.runs.delete(run.number)) plots.runs.add(run.number);
      chip.setAttribute("aria-pressed", plots.runs.has(run.number));
      layOutPlots();
    }}, el("i.mark"), run.name);
    chip.setAttribute("aria-pressed", plots.runs.has(run.number));
    run.chip = chip;
    return chip;
  }));
}

function logNote(log, l) {
  const parts = [data.logs.length > 1 ? `${l + 1}: ${log.name}` : log.name, `agent ${log.agent}`, `seed ${log.seed}`, counted(log.messages, "message"),
    log.all_episodes > log.episodes.length ? `the first ${log.episodes.length} of ${counted(log.all_episodes, "episode")}` : counted(log.all_episodes, "episode"),
    log.complete ? `hash ${log.hash}` : "ends early", log.timed && !log.paced ? "not paced: its times say nothing of the timetable" : ""];
  return el("p.note", {}, parts.filter(Boolean).join(" · "));
}

function statesNote() {
  const rows = runs.flatMap((run) => run.episode.states.map((begun) => ({run, begun})));
  if (!rows.length) return null;
  return el("details", {}, el("summary", {}, "What the episodes began with"), table([
    {name: "episode", cell: (row) => row.run.name}, {name: "state", cell: (row) => row.begun.name},
    {name: "value", cell: (row) => list(row.begun.values, 12)}], rows, 60));
}

function plotsKey(event) {
  const step = plots.span / 200;
  const move = (by) => { plots.cursor = Math.max(0, (plots.cursor ?? plots.begin + plots.span / 2) + by); };
  const actions = {ArrowLeft: () => (event.shiftKey ? placePlots(plots.begin - plots.span * 0.2, plots.span) : move(-step)),
    ArrowRight: () => (event.shiftKey ? placePlots(plots.begin + plots.span * 0.2, plots.span) : move(step)),
    "+": () => zoomPlots(0.8), "=": () => zoomPlots(0.8), "-": () => zoomPlots(1.25), 0: fitPlots};
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
  plots.stage = el("div.plots", {tabIndex: 0, role: "application", "aria-label": "Plots. Arrow keys move the cursor, plus and minus zoom."});
  plots.time = el("span.note");
  add(panel, [el("div.toolbar", {}, runs.length > 1 ? segment("Episodes", [[false, "Overlaid"], [true, "Side by side"]], false, (beside) => { plots.beside = beside; layOutPlots(); }) : null,
    el("div.segment", {role: "group", "aria-label": "Zoom"}, button("−", () => zoomPlots(1.25)), button("+", () => zoomPlots(0.8)), button("Fit", fitPlots)),
    runChooser(), plots.time),
  ...data.logs.map(logNote), statesNote(), el("div.split", {}, seriesChooser(), plots.stage)]);
  let scale = 0;
  plots.stage.addEventListener("pointerdown", (event) => { const at = plotAt(event); scale = at ? at.scale : 0; });
  draggable(plots.stage, (dx) => placePlots(plots.begin - dx * scale, plots.span), () => {});
  plots.stage.addEventListener("pointermove", (event) => {
    const at = plotAt(event);
    if (at) { plots.cursor = Math.max(0, at.time); plots.draw(); }
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
  return {shown() { plots.draw(); }, resized: layOutPlots, focus: plots.stage};
}
