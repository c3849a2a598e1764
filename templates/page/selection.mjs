// Selection, which is {node}, {object}, {composite}, {input: [node, input]}, {way: age} or null, and the current view.

export const state = {
  selected: null,
  view: null
};
const watchers = [];
export function watch(changed) {
  watchers.push(changed);
}
export function select(selected) {
  state.selected = selected;
  for (const changed of watchers) changed(selected);
}

export function isSelected(kind, number) {
  return state.selected !== null && state.selected[kind] === number;
}
