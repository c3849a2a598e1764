// Positions of boxes: those that the user chose, and columns along the flow of messages for the rest.
import {columnLayout} from "./edit_columns.mjs";
import {kBoxGap, kBoxHead, kColumnGap, kPortHeight, kPortReach, portPlace, sizeOf} from "./edit_sizes.mjs";

const overlaps = (a, b) =>
    a.x < b.x + b.width + 10 && b.x < a.x + a.width + 10 && a.y < b.y + b.height + 10 && b.y < a.y + a.height + 10;

/** `wanted`, moved down until it overlaps none of `others` ({x, y, width, height}). */
export function freePlace(wanted, others) {
  const place = {...wanted};
  for (let tries = 0; tries < 1000; ++tries) {
    const under = others.find((other) => overlaps(place, other));
    if (!under) break;
    place.y = under.y + under.height + kBoxGap;
  }
  return place;
}

/**
 * Boxes with {x, y, width, height}. `chosen`: positions by name. Boxes that have one keep it; others get their position
 * in the columns, moved to free space.
 */
export function placedBoxes(model, chosen) {
  const isPlaced = (box) => Array.isArray(chosen[box.name]);
  const fallback = columnLayout(model).places;
  const placed = new Map();
  const put = (box, [x, y]) => placed.set(box, {...sizeOf(box), x, y});
  for (const box of model.boxes.filter(isPlaced)) put(box, chosen[box.name]);
  // Observations are last in the list, and belong to the right of everything else.
  for (const box of model.boxes.filter((one) => !isPlaced(one))) {
    const [x, y] = fallback[box.name], others = [...placed.values()];
    const right =
        box.section === "observations" ? Math.max(...others.map((other) => other.x + other.width)) + kColumnGap : x;
    const free = freePlace({...sizeOf(box), x: Math.max(x, right), y}, others);
    put(box, [free.x, free.y]);
  }
  return model.boxes.map((box) => placed.get(box));
}

/**
 * Element at a point: {box, side, number} for a port, {box} for a box, or null. Boxes that are drawn last are on top.
 */
export function hitAt(model, places, x, y) {
  for (let b = places.length - 1; b >= 0; --b) {
    const place = places[b], box = model.boxes[b];
    for (const side of ["inputs", "outputs"])
      for (let number = 0; number < box[side].length; ++number) {
        const [dx, dy] = portPlace(place, side, number);
        if (Math.hypot(place.x + dx - x, place.y + dy - y) <= kPortReach) return {box: b, side, number};
      }
    if (x >= place.x && x <= place.x + place.width && y >= place.y && y <= place.y + place.height) return {box: b};
  }
  return null;
}

/** Port at which a wire ends if it is dropped here: a port on `side`, or the one in the row under the pointer. */
export function targetAt(model, places, side, x, y) {
  const hit = hitAt(model, places, x, y);
  if (!hit || hit.number !== undefined) return hit && hit.side === side ? hit : null;
  const number = Math.floor((y - places[hit.box].y - kBoxHead + 4) / kPortHeight);
  const isEnd = model.boxes[hit.box].section === (side === "outputs" ? "actions" : "observations");
  if (number >= 0 && number < model.boxes[hit.box][side].length) return {box: hit.box, side, number};
  return isEnd ? {box: hit.box, side, number: -1} : null;  // a new action or observation
}

/** Bounding box {x, y, width, height} of all boxes. */
export function extentOf(places) {
  const left = Math.min(...places.map(({x}) => x)), top = Math.min(...places.map(({y}) => y));
  const right = Math.max(...places.map(({x, width}) => x + width));
  const bottom = Math.max(...places.map(({y, height}) => y + height));
  return {x: left, y: top, width: right - left, height: bottom - top};
}
