// The views of the page, of which one is shown.
import {hideTip} from "./pointer.mjs";
import {state} from "./selection.mjs";

/** {id, name, make(panel), there, badge, tab, panel, parts}: those of this page, in the order of their tabs. */
export const views = [];

/** Functions that make views which only some pages have, by their ids: their modules put them here. */
export const moreViews = new Map();

/** Of a page that edits: whether its data are those of an older graph. Then only the view that edits is right. */
export const freshness = {
  stale: false,
  shown: undefined  // revision of the data
};

/** A view is made when it is looked at first. */
export function showView(id) {
  const view = views.find((other) => other.id === id) || views[0];
  if (freshness.stale && view.id !== "edit") {
    history.replaceState(null, "", `#${view.id}`);
    return location.reload();
  }
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
