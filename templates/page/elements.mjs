// Elements that views consist of. Strings become text nodes, never markup.
import {count} from "./numbers.mjs";

/** Element, as in el("td.number", {title: "x"}, "text", child): dots precede classes; non-elements become text. */
export function el(what, properties, ...children) {
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

export function add(element, children) {
  for (const child of children.flat(3)) {
    if (child === null || child === undefined || child === false) continue;
    element.append(child instanceof Node ? child : document.createTextNode(String(child)));
  }
}

const SVG = "http://www.w3.org/2000/svg";
export function svg(tag, attributes, ...children) {
  const element = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes || {})) element.setAttribute(name, value);
  add(element, children);
  return element;
}

export function button(text, action, properties) {
  return el("button", {type: "button", onclick: action, ...properties}, text);
}

/** Group of buttons, one of which is pressed. `choices`: [value, text]. */
export function segment(label, choices, current, chosen) {
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

/** Table; columns: {name, number?, cell(row)}. A button shows the rows beyond `most`. */
export function table(columns, rows, most = 200, activate = null) {
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

export function card(title, ...children) {
  return el("section.card", {}, title ? el("h2", {}, title) : null, children);
}

export function tiles(pairs) {
  return el(
      "dl.tiles", {},
      pairs.map(
          ([name, value, more]) =>
              el("div", {}, el("dt", {}, name), el("dd", {}, value, more ? el("small", {}, " " + more) : null))));
}

export function pairs(list) {
  return el(
      "dl.pairs", {},
      list.filter((pair) => pair && pair[1] !== "" && pair[1] !== null && pair[1] !== undefined)
          .map(([name, value]) => [el("dt", {}, name), el("dd", {}, value)]));
}

/** Pieces of a name, between which a line may break. */
export function piecesOf(name) {
  return name.split(/(?<=[._/])(?=[^._/])|(?=\[)/);
}

/** Name that breaks after dots, slashes and underscores and before an index, but not within a word. */
export function breakable(name) {
  return piecesOf(name).flatMap((piece, i) => (i ? [el("wbr"), piece] : [piece]));
}

/** Bar with one or two lengths, as fractions of the whole. */
export function bar(part, second = null, kind = "") {
  const box = el("div.bar" + (kind ? "." + kind : ""));
  for (const [name, value] of [["behind", second], ["front", part]]) {
    if (value === null) continue;
    const length = el("i." + name);
    length.style.width = `${Math.max(0, Math.min(1, value)) * 100}%`;
    box.append(length);
  }
  return box;
}
