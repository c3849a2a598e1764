// Timetable view: zoom, keyboard, data at the pointer, measured times.
import {data, nodes} from "./data.mjs";
import {add, button, el, segment, table} from "./elements.mjs";
import {count, counted, floats, seconds} from "./numbers.mjs";
import {draggable, hideTip, showTip} from "./pointer.mjs";
import {newestAt, order, periodOf, quantum, rowOf, wholePeriod} from "./schedule.mjs";
import {select, state, watch} from "./selection.mjs";
import {
  fitTimetable,
  kHead,
  kRow,
  placeTimetable,
  scrollRows,
  timeAt,
  timetable,
  timetableSize,
  zoomTimetable
} from "./timetable_canvas.mjs";

function lateText(late) {
  return `measured ${seconds(Math.abs(late))} ${late < 0 ? "before" : "after"} its time`;
}

function boundText(node) {
  const latest = timetable.bound && timetable.bound[nodes[node].rate_class];
  return latest ? `at most ${seconds(latest)} after its time, by the image's bound` : null;
}

function hoverTimetable(event) {
  const box = timetable.canvas.getBoundingClientRect();
  const row = Math.floor((event.clientY - box.top - kHead + timetable.scroll) / kRow);
  if (event.clientY - box.top < kHead || row >= order.length || event.clientX - box.left < timetableSize().left)
    return hideTip();
  const node = order[row], period = periodOf(node);
  const n = Math.max(0, Math.round(timeAt(event.clientX - box.left) / period));
  const reads = nodes[node].inputs.slice(0, 8).map((input) => {
    const m = newestAt(input, n);
    if (m === null) return `${input.from}: not known`;
    if (m < 0) return `${input.from}: nothing yet`;
    return `${input.from}: message ${m}, ${seconds(Math.max(0, n * period - m * periodOf(input.source[0])))} old`;
  });
  const stamps = timetable.measured && timetable.measured.get(node);
  const late = stamps && n >= stamps.first && n - stamps.first < stamps.late.length ?
      lateText(stamps.late[n - stamps.first]) :
      null;
  showTip(event, [
    `${nodes[node].name}, tick ${n}`, `at ${seconds(n * period)}, ${row + 1}. in the order`, boundText(node), late,
    ...(data.schedule.asynchronous ? [] : reads)
  ]);
}

function latestOf(channel) {
  const known = data.channels.find((other) => other.name === channel.name);
  const latest = known && timetable.bound[nodes[known.node].rate_class];
  return latest ? seconds(latest) : "–";
}

/** Measured times of a paced trace: for each node, those of its first channel. */
function measure(log) {
  timetable.measured = null;
  if (log) {
    timetable.measured = new Map();
    for (const channel of log.episodes[0].channels) {
      const known = data.channels.find((other) => other.name === log.channels[channel.channel].name);
      if (!known || !channel.stamps || timetable.measured.has(known.node)) continue;
      timetable.measured.set(known.node, {first: channel.first, late: floats(channel.stamps)});
    }
  }
  timetable.draw();
}

/** Image whose bounds are shown: the first one with times of all slots. */
function boundImage() {
  return data.images.find((image) => image.time && image.time.fit);
}

/** Load of a rate as text: "the slot of 30 Hz takes up to 6.8 % of its time". */
function loadText({name, time}) {
  const {busiest} = time.fit;
  const percent = (100 * busiest.load).toFixed(1);
  return `Bound of ${name}: the slot of ${busiest.name} takes up to ${seconds(busiest.us * 1e-6)} of ` +
      `${seconds(busiest.until_next_us * 1e-6)}, ${percent} %.`;
}

function boundTable({name, time}) {
  const number = (key, text) =>
      ({name: text, number: true, cell: (row) => row[key] === undefined ? "–" : count(Math.round(row[key]))});
  const steps = time.steps ? [time.steps.longest, time.steps.hyperperiod] : [];
  const rows = [...time.slots, ...steps, ...time.parts, ...time.nodes].filter((row) => row.bound);
  const missing =
      time.missing.map(({what, place, of}) => el("li", {}, `${what} at ${place}: none for ${of.join(", ")}`));
  return el(
      "details", {}, el("summary", {}, `Bounds from ${name}: the most of each slot, part of a step, and node`),
      table(
          [
            {name: "what", cell: (row) => row.name}, number("most", "instructions"), number("cycles", "cycles"),
            {name: "time", number: true, cell: (row) => row.us === undefined ? "–" : seconds(row.us * 1e-6)}
          ],
          rows),
      missing.length ? el("p.note", {}, "Without a bound:") : null, missing.length ? el("ul", {}, missing) : null);
}

function latenessTable(log) {
  const rows = log.episodes[0].channels.filter((channel) => channel.late);
  return el(
      "details", {}, el("summary", {}, `Measured in ${log.name}, episode 0: how long after its time a message is sent`),
      el("p.note", {},
         "Less than zero: before its time. A simulation computes its sensors' next messages as soon as it has the action."),
      table(
          [
            {name: "channel", cell: (row) => log.channels[row.channel].name},
            ...[["least", "least"], ["mean", "mean"], ["p99", "99 %"], ["most", "most"]].map(
                ([key, name]) => ({name, number: true, cell: (row) => seconds(row.late[key])})),
            ...(timetable.bound ? [{name: "bound", number: true, cell: (row) => latestOf(log.channels[row.channel])}] :
                                  []),
          ],
          rows));
}

function timetableKey(event) {
  const page = timetable.span * 0.2;
  const actions = {
    ArrowLeft: () => placeTimetable(timetable.begin - page, timetable.span),
    ArrowRight: () => placeTimetable(timetable.begin + page, timetable.span),
    ArrowUp: () => scrollRows(-kRow),
    ArrowDown: () => scrollRows(kRow),
    PageUp: () => scrollRows(-10 * kRow),
    PageDown: () => scrollRows(10 * kRow),
    "+": () => zoomTimetable(0.8),
    "=": () => zoomTimetable(0.8),
    "-": () => zoomTimetable(1.25),
    0: fitTimetable
  };
  if (!actions[event.key]) return;
  actions[event.key]();
  event.preventDefault();
}

export function makeTimetableView(panel) {
  const {slots, form, asynchronous} = data.schedule;
  const bound = boundImage();
  timetable.bound = bound ? bound.time.fit.outputs.map(({latest_us}) => latest_us * 1e-6) : null;
  const facts = [
    slots ? `${counted(slots, "slot")} in a hyperperiod` + (wholePeriod ? ` of ${seconds(wholePeriod)}` : "") :
                                                                          "too many slots in a hyperperiod to count",
    form, `grid of ${seconds(quantum)}`
  ];
  if (asynchronous) facts.push("inputs take what has arrived");
  const paced = data.logs.filter((log) => log.paced);
  const choices = [[-1, "Planned"], ...paced.map((log, i) => [i, paced.length > 1 ? `Measured ${i + 1}` : "Measured"])];
  const stage = el(
      "div.stage", {tabIndex: 0, role: "application", "aria-label": "Timetable. Arrow keys move, plus and minus zoom."},
      timetable.canvas);
  add(panel, [
    el("div.toolbar", {},
       el("div.segment", {role: "group", "aria-label": "Zoom"}, button("−", () => zoomTimetable(1.25)),
          button("+", () => zoomTimetable(0.8)), button("Fit", fitTimetable)),
       paced.length ? segment("Times", choices, -1, (i) => measure(i < 0 ? null : paced[i])) : null,
       timetable.stream ?
           segment("Times", [[false, "Planned"], [true, "As it comes"]], false, (on) => timetable.stream.choose(on)) :
           null,
       el("p.legend", {},
          data.schedule.rates.slice(0, 8).map((rate, i) => el("span", {}, el(`i.shade${i % 8}`), `${rate.rate} Hz`)))),
    el("p.note", {}, facts.join(" · "),
       ". Rows are in the order in which nodes run within a slot. Select a node to see what it reads at each tick."),
    bound ? el("p.note", {}, loadText(bound)) : null, stage, ...paced.map(latenessTable),
    ...data.images.filter((image) => image.time).map(boundTable)
  ]);
  draggable(
      stage,
      (dx, dy) => {
        const {width, left} = timetableSize();
        placeTimetable(timetable.begin - (dx / (width - left)) * timetable.span, timetable.span);
        scrollRows(-dy);
      },
      (event) => {
        const row = Math.floor(
            (event.clientY - timetable.canvas.getBoundingClientRect().top - kHead + timetable.scroll) / kRow);
        select(row >= 0 && row < order.length ? {node: order[row]} : null);
      });
  stage.addEventListener("pointermove", hoverTimetable);
  stage.addEventListener("pointerleave", hideTip);
  stage.addEventListener("keydown", timetableKey);
  stage.addEventListener("wheel", (event) => {
    event.preventDefault();
    const fits = order.length * kRow + kHead <= timetableSize().height;
    const box = timetable.canvas.getBoundingClientRect();
    if (event.ctrlKey || fits || event.clientY - box.top < kHead)
      zoomTimetable(Math.exp(event.deltaY * 0.0015), event.clientX - box.left);
    else if (event.shiftKey)
      placeTimetable(timetable.begin + (event.deltaY / 600) * timetable.span, timetable.span);
    else
      scrollRows(event.deltaY);
  }, {passive: false});
  watch(timetable.draw);
  let first = true;
  return {
    shown() {
      if (first) {
        first = false;
        fitTimetable();
      }
      revealRow();
      timetable.draw();
    },
    resized: timetable.draw,
    focus: stage
  };
}

function revealRow() {
  const {selected} = state;
  const node = selected && (selected.node ?? (selected.input && selected.input[0]));
  if (node === undefined || node === null) return;
  const at = rowOf.get(node) * kRow, {height} = timetableSize();
  if (at < timetable.scroll || at > timetable.scroll + height - kHead - kRow)
    scrollRows(at - timetable.scroll - (height - kHead) / 2);
}
