"use strict";
// Everything below comes from files of others: it becomes text, never markup.
const data = JSON.parse(document.getElementById("data").textContent);

// ---- Elements -------------------------------------------------------------------------------------------------------
/** el("td.number", {title: "x"}, "text", child): classes follow dots; what is no element becomes text. */
function el(what, properties, ...children) {
  const [tag, ...classes] = what.split(".");
  const element = document.createElement(tag || "div");
  if (classes.length) element.className = classes.join(" ");
  for (const [name, value] of Object.entries(properties || {})) {
    if (value === undefined || value === null) continue;
    if (name.startsWith("on"))
      element.addEventListener(name.slice(2), value);
    else if (name in element && name !== "list")
      element[name] = value;
    else
      element.setAttribute(name, value);
  }
  add(element, children);
  return element;
}

function add(element, children) {
  for (const child of children.flat(3)) {
    if (child === null || child === undefined || child === false) continue;
    element.append(child instanceof Node ? child : document.createTextNode(String(child)));
  }
}

const SVG = "http://www.w3.org/2000/svg";
function svg(tag, attributes, ...children) {
  const element = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes || {})) element.setAttribute(name, value);
  add(element, children);
  return element;
}

function button(text, action, properties) {
  return el("button", {type: "button", onclick: action, ...properties}, text);
}

/** A group of buttons of which one is pressed. `choices`: [value, text]. */
function segment(label, choices, current, chosen) {
  const buttons = choices.map(([value, text]) => button(text, () => choose(value)));
  function choose(value) {
    choices.forEach(([other], i) => buttons[i].setAttribute("aria-pressed", other === value));
    chosen(value);
  }
  choices.forEach(([value], i) => buttons[i].setAttribute("aria-pressed", value === current));
  const group = el("div.segment", {role: "group", "aria-label": label}, buttons);
  group.choose = choose;
  return group;
}

/** A table; columns: {name, number?, cell(row)}. More than `most` rows wait behind a button. */
function table(columns, rows, most = 200, activate = null) {
  const body = el("tbody");
  const show = (from, to) => {
    for (const row of rows.slice(from, to)) {
      const line = el("tr", {}, columns.map((column) => el(column.number ? "td.number" : "td", {}, column.cell(row))));
      if (activate) {
        line.classList.add("link");
        line.tabIndex = 0;
        line.addEventListener("click", () => activate(row));
        line.addEventListener("keydown", (event) => {
          if (event.key === "Enter" && event.target === line) activate(row);
        });
      }
      body.append(line);
    }
  };
  show(0, most);
  const head =
      el("thead", {}, el("tr", {}, columns.map((c) => el(c.number ? "th.number" : "th", {scope: "col"}, c.name))));
  const box = el("div.scroll", {}, el("table", {}, head, body));
  if (rows.length > most) {
    const more = button(`Show all ${count(rows.length)}`, () => {
      show(most, rows.length);
      more.remove();
    });
    box.append(more);
  }
  return box;
}

function card(title, ...children) {
  return el("section.card", {}, title ? el("h2", {}, title) : null, children);
}

function tiles(pairs) {
  return el(
      "dl.tiles", {},
      pairs.map(
          ([name, value, more]) =>
              el("div", {}, el("dt", {}, name), el("dd", {}, value, more ? el("small", {}, " " + more) : null))));
}

function pairs(list) {
  return el(
      "dl.pairs", {},
      list.filter((pair) => pair && pair[1] !== "" && pair[1] !== null && pair[1] !== undefined)
          .map(([name, value]) => [el("dt", {}, name), el("dd", {}, value)]));
}

/** A bar with one or two lengths, as parts of the whole. */
function bar(part, second = null, kind = "") {
  const box = el("div.bar" + (kind ? "." + kind : ""));
  for (const [name, value] of [["behind", second], ["front", part]]) {
    if (value === null) continue;
    const length = el("i." + name);
    length.style.width = `${Math.max(0, Math.min(1, value)) * 100}%`;
    box.append(length);
  }
  return box;
}

// ---- Numbers as text ------------------------------------------------------------------------------------------------
function count(value) {
  return String(value).replace(/\B(?=(\d{3})+(?!\d))/g, "\u202f");
}
function counted(value, one) {
  return `${count(value)} ${one}${value === 1 ? "" : /(s|x|sh)$/.test(one) ? "es" : "s"}`;
}
function bytes(value) {
  return `${count(value)} B`;
}
/** With `digits` that count. */
function short(value, digits = 4) {
  if (value === null || value === undefined || Number.isNaN(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e6 || size < 1e-4) return value.toExponential(Math.max(0, digits - 2)).replace("e+", "e");
  return String(Number(value.toPrecision(digits)));
}
function seconds(value) {
  if (value === null || value === undefined) return "unknown";
  const size = Math.abs(value);
  if (size === 0) return "0 s";
  if (size < 1e-6) return `${short(value * 1e9, 3)} ns`;
  if (size < 1e-3) return `${short(value * 1e6, 3)} µs`;
  if (size < 1) return `${short(value * 1e3, 4)} ms`;
  return `${short(value, 5)} s`;
}
function list(values, most = 8) {
  const texts = values.slice(0, most).map((value) => (typeof value === "number" ? short(value, 6) : String(value)));
  return texts.join(", ") + (values.length > most ? `, … (${values.length})` : "");
}
/** Bounds of a space as text. */
function bounds(space) {
  if (!space.low.length && !space.high.length) return "no bounds";
  const same = (values) => values.every((value) => value === values[0]);
  // JSON has no infinity: it is null.
  const finite = (values, infinity) => values.map((value) => (value === null ? infinity : value));
  const low = finite(space.low, "−∞"), high = finite(space.high, "∞");
  if (same(low) && same(high)) return `${list(low.slice(0, 1))} … ${list(high.slice(0, 1))}`;
  return `[${list(low)}] … [${list(high)}]`;
}
function parse(fraction) {
  const [above, below] = String(fraction).split("/");
  return Number(above) / Number(below || 1);
}

// ---- What is known, found fast --------------------------------------------------------------------------------------
const nodes = data.nodes;
nodes.forEach((node, number) => {
  node.number = number;
  node.rate_hz = parse(node.rate);
  node.rings = [];
  node.readers = node.outputs.map(() => []);
  node.channels = node.outputs.map(() => null);
});
nodes.forEach((node) => node.inputs.forEach((input, i) => {
  input.node = node.number;
  input.number = i;
  nodes[input.source[0]].readers[input.source[1]].push(input);
}));
data.rings.forEach((ring, number) => {
  ring.number = number;
  nodes[ring.node].rings.push(ring);
});
data.channels.forEach((channel, number) => {
  nodes[channel.node].channels[channel.output] = number;
});
const inputOf = new Map();  // by the name that ages use
nodes.forEach((node) => node.inputs.forEach((input) => inputOf.set(input.written, input)));

function outputName(node, o) {
  const output = nodes[node].outputs[o];
  return output.sensor || (node === 0 ? `actions.${output.name}` : `${nodes[node].name}.${output.name}`);
}

// ---- What is selected: {node}, {object}, {input: [node, input]}, {way: age} or null ---------------------------------
const state = {
  selected: null,
  view: null
};
const watchers = [];
function watch(changed) {
  watchers.push(changed);
}
function select(selected) {
  state.selected = selected;
  for (const changed of watchers) changed(selected);
}

function isSelected(kind, number) {
  return state.selected !== null && state.selected[kind] === number;
}

// ---- Colours --------------------------------------------------------------------------------------------------------
function isDark() {
  return document.documentElement.dataset.theme === "dark";
}
function colour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue("--" + name).trim();
}
/** Of episodes, rates and elements. */
function shade(number) {
  return colour(`c${number % 8}`);
}

// ---- Canvases -------------------------------------------------------------------------------------------------------
/** Fits the canvas to its place on the screen and clears it; null if it is not to be seen. */
function prepare(canvas, width, height) {
  if (width < 2 || height < 2) return null;
  const scale = window.devicePixelRatio || 1;
  const w = Math.round(width * scale), h = Math.round(height * scale);
  if (canvas.width !== w || canvas.height !== h) {
    canvas.width = w;
    canvas.height = h;
    canvas.style.width = `${width}px`;
    canvas.style.height = `${height}px`;
  }
  const context = canvas.getContext("2d");
  context.setTransform(scale, 0, 0, scale, 0, 0);
  context.clearRect(0, 0, width, height);
  context.font = "12px system-ui, 'Segoe UI', Roboto, 'Liberation Sans', Arial, sans-serif";
  context.textBaseline = "middle";
  return context;
}

/** Calls `draw` once before the next frame, however often it is asked to. */
function onFrame(draw) {
  let asked = false;
  return () => {
    if (asked) return;
    asked = true;
    requestAnimationFrame(() => {
      asked = false;
      draw();
    });
  };
}

/** Steps of 1, 2 or 5 times a power of ten, so that about `most` fit. */
function stepOf(span, most) {
  const raw = span / Math.max(1, most);
  const power = 10 ** Math.floor(Math.log10(raw));
  return power * ([1, 2, 5, 10].find((factor) => power * factor >= raw) || 10);
}

const tip = document.getElementById("tip");
function showTip(event, lines) {
  tip.replaceChildren(...lines.filter(Boolean).map((line, i) => el(i ? "div" : "b", {}, line)));
  tip.hidden = false;
  const box = tip.getBoundingClientRect();
  tip.style.left = `${Math.min(event.clientX + 14, innerWidth - box.width - 8)}px`;
  tip.style.top = `${Math.min(event.clientY + 16, innerHeight - box.height - 8)}px`;
}
function hideTip() {
  tip.hidden = true;
}

/** Drags: `moved(dx, dy, event)` while a button is down; `clicked(event)` if it did not move. */
function draggable(element, moved, clicked) {
  let from = null, far = false;
  element.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    from = [event.clientX, event.clientY];
    far = false;
  });
  element.addEventListener("pointermove", (event) => {
    if (!from) return;
    const [dx, dy] = [event.clientX - from[0], event.clientY - from[1]];
    if (!far && Math.hypot(dx, dy) < 4) return;
    if (!far) element.setPointerCapture(event.pointerId);
    far = true;
    from = [event.clientX, event.clientY];
    moved(dx, dy, event);
  });
  const end = (event) => {
    if (from && !far && event.type === "pointerup") clicked(event);
    from = null;
  };
  element.addEventListener("pointerup", end);
  element.addEventListener("pointercancel", end);
}
