// Search for everything that has a name.
import {data, nodes, outputName} from "./data.mjs";
import {el} from "./elements.mjs";
import {showInGraph} from "./graph.mjs";
import {select, state} from "./selection.mjs";

export const searchBox = document.getElementById("search");
const foundBox = document.getElementById("found");
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
