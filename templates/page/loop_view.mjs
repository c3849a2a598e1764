// Loop opened at a port: Bode plot with margins, Nyquist plot, poles, and step response.
import {data} from "./data.mjs";
import {add, card, el, svg, tiles} from "./elements.mjs";
import {counted, seconds, short, stepOf} from "./numbers.mjs";
import {moreViews} from "./views.mjs";

const kWide = 640, kLow = 190, kSquare = 320;
const loopRoom = {
  left: 58,
  right: 12,
  top: 10,
  bottom: 34
};
// Circles are round: the plot is as high as it is wide.
const kSquareHigh = kSquare - loopRoom.left - loopRoom.right + loopRoom.top + loopRoom.bottom;
const degrees = (value) => `${short(value)}°`;
const decibels = (factor) => `${short(20 * Math.log10(factor))} dB`;

/** Multiples within a range of 1, 2 or 5 times a power of ten. */
function gridMarks([low, high], most) {
  const step = stepOf(high - low, most), marks = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i)
    marks.push([i * step, short(i * step)]);
  return marks;
}
function decades([low, high]) {
  const marks = [];
  for (let power = Math.ceil(low); power <= high; ++power) marks.push([power, short(10 ** power)]);
  return marks;
}

/** Multiples 2 to 9 of the powers of ten within a logarithmic range, unless there are too many. */
function betweenDecades([low, high]) {
  const marks = [];
  if (high - low > 7) return marks;
  for (let power = Math.floor(low); power <= high; ++power)
    for (let i = 2; i < 10; ++i) marks.push(power + Math.log10(i));
  return marks.filter((at) => at >= low && at <= high);
}

/**
 * Axes as SVG: {element, x, y, line(points, look), dot, cross, circle, level, guide, upright, arrow}, in the units of
 * the plot. `columns` and `rows`: [value, text] of the grid lines; `minor`: columns without a text; `under` and
 * `left`: words at the axes.
 */
function axesOf({width, height, x: xs, y: ys, columns, minor = [], rows, under, left, label}) {
  const inside = (value, [low, high]) => value >= low && value <= high;
  const x = (value) => loopRoom.left + ((value - xs[0]) / (xs[1] - xs[0])) * (width - loopRoom.left - loopRoom.right);
  const y = (value) =>
      height - loopRoom.bottom - ((value - ys[0]) / (ys[1] - ys[0])) * (height - loopRoom.top - loopRoom.bottom);
  const element = svg("svg", {viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": label});
  const text = (at, down, anchor, words, look = "") =>
      add(element, [svg("text", {x: at, y: down, "text-anchor": anchor, class: look}, words)]);
  const path = (d, look) => add(element, [svg("path", {d, class: look})]);
  for (const [value, words] of rows) {
    path(`M${loopRoom.left} ${y(value)}H${width - loopRoom.right}`, "grid");
    text(loopRoom.left - 6, y(value) + 4, "end", words);
  }
  for (const value of minor) path(`M${x(value)} ${loopRoom.top}V${height - loopRoom.bottom}`, "grid minor");
  for (const [value, words] of columns) {
    path(`M${x(value)} ${loopRoom.top}V${height - loopRoom.bottom}`, "grid");
    text(x(value), height - loopRoom.bottom + 15, "middle", words);
  }
  text(width - loopRoom.right, height - 4, "end", under);
  const middle = (loopRoom.top + height - loopRoom.bottom) / 2;
  if (left)
    add(element, [svg("text", {transform: `translate(12 ${middle}) rotate(-90)`, "text-anchor": "middle"}, left)]);
  return {
    element,
    x,
    /** Draws a line, split where it leaves and enters the plot. */
    line(points, look) {
      let piece = "";
      for (const [at, value] of points) {
        const here = inside(at, xs) && inside(value, ys);
        if (here) piece += `${piece && !piece.endsWith(" ") ? "L" : "M"}${x(at).toFixed(1)} ${y(value).toFixed(1)}`;
        if (!here && piece && !piece.endsWith(" ")) piece += " ";
      }
      if (piece) path(piece, `curve ${look}`);
    },
    dot(at, value, look) {
      if (inside(at, xs) && inside(value, ys))
        add(element, [svg("circle", {cx: x(at), cy: y(value), r: 3.5, class: look})]);
    },
    cross(at, value, look) {
      if (inside(at, xs) && inside(value, ys)) path(`M${x(at) - 4} ${y(value) - 4}l8 8m0 -8l-8 8`, `curve ${look}`);
    },
    circle(at, radius, look = "limit dashed") {
      if (inside(at - radius, xs) && inside(at + radius, xs))
        add(element, [svg("circle", {cx: x(at), cy: y(0), r: x(at + radius) - x(at), class: `curve ${look}`})]);
    },
    /** Draws a vertical line through the plot. */
    guide: (at) => inside(at, xs) && path(`M${x(at)} ${loopRoom.top}V${height - loopRoom.bottom}`, "curve guide"),
    /** Draws the head of an arrow at `to`, in the direction from `from`. */
    arrow(from, to, look) {
      const turn = (Math.atan2(y(to[1]) - y(from[1]), x(to[0]) - x(from[0])) * 180) / Math.PI;
      const place = `translate(${x(to[0]).toFixed(1)} ${y(to[1]).toFixed(1)}) rotate(${turn.toFixed(1)})`;
      if (inside(to[0], xs) && inside(to[1], ys))
        add(element, [svg("path", {d: "M4 0l-8 -4v8z", transform: place, class: `arrow ${look}`})]);
    },
    level: (value) =>
        inside(value, ys) && path(`M${loopRoom.left} ${y(value)}H${width - loopRoom.right}`, "curve limit dashed"),
    /** Draws a margin: a vertical line from one value to another, with a label. */
    upright(at, from, to, words) {
      if (!inside(at, xs) || !inside(from, ys) || !inside(to, ys)) return;
      path(`M${x(at)} ${y(from)}V${y(to)}`, "curve limit");
      const right = x(at) > 0.7 * width;
      text(x(at) + (right ? -6 : 6), (y(from) + y(to)) / 2 + 4, right ? "end" : "start", words, "limit");
    }
  };
}

const loopExtent = (values, ...more) => [Math.min(...values, ...more), Math.max(...values, ...more)];
const widened = ([low, high], by) => [low - by, high + by];
const loopPlot = (title, axes, wide, ...more) =>
    el("article.plot.loop" + (wide ? ".wide" : ""), {}, el("header", {}, el("span", {}, title), more), axes.element);

/** Draws lines at the frequencies of the margins, the same in gain and phase. */
function marginGuides(axes, margins) {
  for (const at of [margins.crossover_hz, margins.gain_frequency_hz, margins.least_gain_frequency_hz])
    if (at > 0) axes.guide(Math.log10(at));
}

function gainPlot({bode, margins}) {
  const xs = loopExtent(bode.map(([f]) => Math.log10(f)));
  const ys = widened(loopExtent(bode.map(([, gain]) => Math.max(-80, Math.min(80, gain))), 0), 5);
  const axes = axesOf({
    width: kWide,
    height: kLow,
    x: xs,
    y: ys,
    columns: decades(xs),
    minor: betweenDecades(xs),
    rows: gridMarks(ys, 5),
    under: "frequency [Hz]",
    left: "gain [dB]",
    label: "gain over frequency"
  });
  marginGuides(axes, margins);
  axes.level(0);
  axes.line(bode.map(([f, gain]) => [Math.log10(f), gain]), "c0");
  for (const [factor, at] of [
           [margins.gain, margins.gain_frequency_hz], [margins.least_gain, margins.least_gain_frequency_hz]])
    if (factor && at > 0) {
      axes.dot(Math.log10(at), -20 * Math.log10(factor), "limit");
      axes.upright(Math.log10(at), 0, -20 * Math.log10(factor), decibels(factor));
    }
  if (margins.crossover_hz) axes.dot(Math.log10(margins.crossover_hz), 0, "limit");
  return axes;
}

function phasePlot({bode, margins}) {
  const xs = loopExtent(bode.map(([f]) => Math.log10(f)));
  const ys = widened(loopExtent(bode.map(([, , phase]) => Math.max(-1080, Math.min(1080, phase))), -180), 10);
  const step = ys[1] - ys[0] > 720 ? 180 : 90, rows = [];
  for (let at = Math.ceil(ys[0] / step) * step; at <= ys[1]; at += step) rows.push([at, String(at)]);
  const axes = axesOf({
    width: kWide,
    height: kLow,
    x: xs,
    y: ys,
    columns: decades(xs),
    minor: betweenDecades(xs),
    rows,
    under: "frequency [Hz]",
    left: "phase [deg]",
    label: "phase over frequency"
  });
  marginGuides(axes, margins);
  for (let at = -900; at <= 900; at += 360) axes.level(at);
  axes.line(bode.map(([f, , phase]) => [Math.log10(f), phase]), "c0");
  if (margins.phase_deg !== null) {
    const at = Math.log10(margins.crossover_hz), there = margins.phase_deg - 180;
    axes.dot(at, there, "limit");
    axes.upright(at, -180, there, degrees(margins.phase_deg));
  }
  return axes;
}

function nyquistPlot({bode, margins}) {
  const range = [-3, 3], marks = gridMarks(range, 6);
  const axes = axesOf({
    width: kSquare,
    height: kSquareHigh,
    x: range,
    y: range,
    columns: marks,
    rows: marks,
    under: "real part",
    left: "imaginary part",
    label: "Nyquist plot"
  });
  axes.circle(0, 1, "guide");
  axes.circle(-1, 1 / margins.sensitivity);
  axes.line(bode.map(([, , , re, im]) => [re, im]), "c0");
  axes.line(bode.map(([, , , re, im]) => [re, -im]), "c0 faint");
  // An arrow to higher frequencies where the curve is last beyond 1.5.
  const far = bode.findLastIndex(([, , , re, im]) => Math.hypot(re, im) > 1.5 && Math.hypot(re, im) < 2.8);
  const tip = far > 0 ? far : Math.floor(bode.length / 2);
  if (tip > 0) axes.arrow(bode[tip - 1].slice(3), bode[tip].slice(3), "c0");
  axes.cross(-1, 0, "limit");
  return axes;
}

/** z = exp(s·T) of all s with this damping, up to half a turn. */
function damped(damping) {
  const decay = damping / Math.sqrt(1 - damping * damping);
  return Array.from({length: 97}, (_, i) => {
    const angle = (Math.PI * (i - 48)) / 48, size = Math.exp(-decay * Math.abs(angle));
    return [size * Math.cos(angle), size * Math.sin(angle)];
  });
}

function polesPlot({open_poles, closed_poles}) {
  const most = Math.max(1.1, ...closed_poles.map(([re, im]) => Math.min(3, Math.hypot(re, im) + 0.1)));
  const range = [-most, most], marks = gridMarks(range, 6);
  const axes = axesOf({
    width: kSquare,
    height: kSquareHigh,
    x: range,
    y: range,
    columns: marks,
    rows: marks,
    under: "real part",
    left: "imaginary part",
    label: "poles"
  });
  for (const damping of [0.2, 0.4, 0.6, 0.8]) axes.line(damped(damping), "guide");
  axes.circle(0, 1);
  for (const [re, im] of open_poles) axes.dot(re, im, "c2");
  for (const [re, im] of closed_poles) axes.cross(re, im, "c0");
  return axes;
}

/** Range of the linear response, which the simulated response can extend by one height in each direction. */
function stepRange(step, simulated) {
  const [low, high] = loopExtent(step.flatMap(([, t, s]) => [t, s]), 0, 1), height = high - low;
  const all = loopExtent(simulated.flatMap(([, t, s]) => [t, s]), low, high);
  return widened([Math.max(low - height, all[0]), Math.min(high + height, all[1])], 0.05);
}

function stepPlot({step, simulated}) {
  const program = simulated?.step ?? [];
  const xs = [0, step.at(-1)[0]], ys = stepRange(step, program);
  const axes = axesOf({
    width: kWide,
    height: kLow,
    x: xs,
    y: ys,
    columns: gridMarks(xs, 8),
    rows: gridMarks(ys, 5),
    under: "time [s]",
    left: "response",
    label: "step response"
  });
  axes.line(step.map(([at, , s]) => [at, s]), "c2");
  axes.line(step.map(([at, t]) => [at, t]), "c0");
  axes.line(program.map(([at, , s]) => [at, s]), "simulated dashed");
  axes.line(program.map(([at, t]) => [at, t]), "simulated dashed");
  return axes;
}

/** Readout of the frequency, gain and phase at the pointer. */
function bodeReadout(loop, axes) {
  const words = el("span.values", {}, "");
  const logs = loop.bode.map(([f]) => Math.log10(f));
  axes.element.addEventListener("pointermove", (event) => {
    const box = axes.element.getBoundingClientRect(), at = ((event.clientX - box.left) / box.width) * kWide;
    let near = 0;
    logs.forEach((log, i) => {
      if (Math.abs(axes.x(log) - at) < Math.abs(axes.x(logs[near]) - at)) near = i;
    });
    const [frequency, gain, phase] = loop.bode[near];
    words.textContent = `${short(frequency)} Hz: ${short(gain)} dB, ${degrees(phase)}`;
  });
  axes.element.addEventListener("pointerleave", () => (words.textContent = ""));
  return words;
}

function factsOf({margins, simulated}) {
  const at = (hz) => `at ${short(hz)} Hz`;
  return [
    ["closed loop", margins.stable ? "stable" : "unstable", `spectral radius ${short(margins.spectral_radius, 6)}`],
    margins.phase_deg === null ? null : ["phase margin", degrees(margins.phase_deg), at(margins.crossover_hz)],
    margins.gain === null ? null : ["gain margin", decibels(margins.gain), at(margins.gain_frequency_hz)],
    margins.least_gain === null ? null :
                                  ["least gain", decibels(margins.least_gain), at(margins.least_gain_frequency_hz)],
    margins.delay_s === null ? null : ["delay margin", seconds(margins.delay_s), at(margins.delay_frequency_hz)],
    margins.stable_messages === null ? null :
                                       ["stable with", counted(margins.stable_messages, "more message"), "of delay"],
    ["peak of sensitivity", short(margins.sensitivity), at(margins.sensitivity_hz)],
    simulated && margins.stable ?
        [
          "simulated step", `within ${short(100 * simulated.difference, 3)} %`,
          `of the linear model, for ${short(simulated.size)}${simulated.unit ? ` ${simulated.unit}` : ""}`
        ] :
        null,
    ...margins.ages.map(({from, to, newest_s}) => ["age of data", seconds(newest_s), `from ${from} to ${to}`])
  ].filter(Boolean);
}

export function loopCard(loop) {
  const gain = gainPlot(loop), phase = phasePlot(loop);
  return card(
      `The loop opened at ${loop.margins.port}`, tiles(factsOf(loop)),
      el("p.note", {},
         "Of the program as it runs, with its rates, delays and windows, linearized at the operating point."),
      el("div.loops", {}, loopPlot("Gain [dB]", gain, true, bodeReadout(loop, gain)),
         loopPlot("Phase [deg]", phase, true, bodeReadout(loop, phase)),
         loopPlot("Nyquist plot; dotted: |L| = 1; dashed: peak of |S|", nyquistPlot(loop)),
         loopPlot("Poles z: open (dots), closed (crosses); dotted: damping", polesPlot(loop)),
         loopPlot(
             "Unit step at the port: T (blue) returns, its readers get S = 1 − T (green)" +
                 (loop.simulated ? "; dashed: as the program simulates it" : ""),
             stepPlot(loop), true)));
}

function makeLoopView(panel) {
  add(panel, data.loops.map(loopCard));
  return {shown() {}, resized() {}};
}
moreViews.set("loop", makeLoopView);
