// Views of the page, one of which is visible.
import {hideTip} from "./pointer.mjs";
import {state} from "./selection.mjs";

/** {id, name, make(panel), there, badge, tab, panel, parts} of the views of this page, in the order of their tabs. */
export const views = [];

/** Functions that create views of only some pages, by ID. The modules of these views add them. */
export const moreViews = new Map();

/**
 * State of the data on a page with the editor. Stale data are those of an older graph: only the editor is up to date.
 */
export const freshness = {
  stale: false,
  shown: undefined  // revision of the data
};

/** Shows a view, and creates it the first time. */
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
