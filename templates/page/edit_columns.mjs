// Layout of boxes in columns along the flow of messages, with lanes between them for wires that pass a column.
import {kBoxGap, kColumnGap, portPlace, sizeOf} from "./edit_sizes.mjs";

const kLaneHeight = 16;

/** Column of each box: the longest chain of wires to it, without wires that skip or would close a cycle. */
function columnsOf(model) {
  const columns = model.boxes.map(({section}) => (section === "actions" ? 0 : 1)), doing = new Set(), done = new Set();
  const follow = (b) => {
    if (done.has(b)) return;
    doing.add(b);
    for (const {from, connection} of model.incoming[b].map((w) => model.wires[w])) {
      if (doing.has(from) || connection.skip === "true") continue;
      follow(from);
      columns[b] = Math.max(columns[b], columns[from] + 1);
    }
    doing.delete(b);
    done.add(b);
  };
  model.boxes.forEach((_, b) => follow(b));
  columns[columns.length - 1] = Math.max(1, ...columns.slice(0, -1)) + 1;  // observations
  return columns;
}

/** True if a wire goes from left to right. */
export function isForward(wire, columns) {
  return columns[wire.from] < columns[wire.to];
}

/** Items of each column: boxes, and lanes of wires that pass it. */
function itemsOf(model, columns) {
  const items = Array.from({length: Math.max(...columns) + 1}, () => []);
  model.boxes.forEach((box, b) => items[columns[b]].push({box: b, ...sizeOf(box)}));
  model.wires.forEach((wire, w) => {
    if (!isForward(wire, columns)) return;
    for (let column = columns[wire.from] + 1; column < columns[wire.to]; ++column)
      items[column].push({wire: w, width: 0, height: kLaneHeight});
  });
  return items;
}

/** Vertical position that aligns an item with what enters it from the left; null if nothing does. */
function wantedY(item, model, columns, columnOfLanes, placed) {
  const heightAt = (w, column) => {
    const wire = model.wires[w];
    if (columns[wire.from] === column) {
      const from = placed.get(`box ${wire.from}`);
      return from && from.y + portPlace(from, "outputs", wire.output)[1];
    }
    const lane = placed.get(`lane ${w} ${column}`);
    return lane && lane.y + kLaneHeight / 2;
  };
  if (item.wire !== undefined) return heightAt(item.wire, columnOfLanes - 1) - kLaneHeight / 2;
  const ys = model.incoming[item.box].flatMap((w) => {
    const wire = model.wires[w];
    if (!isForward(wire, columns)) return [];
    return [heightAt(w, columnOfLanes - 1) - portPlace(item, "inputs", wire.input)[1]];
  });
  return ys.length ? ys.reduce((sum, y) => sum + y, 0) / ys.length : null;
}

/** Vertical positions in one column: each item is as close to its wanted position as the others allow. */
function stack(items) {
  const known = items.filter(({wanted}) => wanted !== null);
  const middle =
      known.length ? known.reduce((sum, {wanted, height}) => sum + wanted + height / 2, 0) / known.length : 0;
  for (const item of items) item.order = item.wanted === null ? Infinity : item.wanted + item.height / 2;
  items.sort((a, b) => a.order - b.order);
  let y = -Infinity;
  for (const item of items) {
    item.y = Math.max(item.wanted ?? (y === -Infinity ? middle - item.height / 2 : y), y);
    y = item.y + item.height + (item.wire === undefined ? kBoxGap : 6);
  }
  // Compensates for items that others pushed down, by moving the whole column up.
  const pushed = known.reduce((sum, item) => sum + item.y - item.wanted, 0) / Math.max(1, known.length);
  const free = items.every(({wanted}) => wanted === null) ? (y - items[0].y - kBoxGap) / 2 - items[0].height / 2 : 0;
  for (const item of items) item.y = Math.round(item.y - pushed - free);
}

/**
 * {places: positions of boxes by name, lanes: for each wire, points [left, right, y] at the columns that it passes}.
 */
export function columnLayout(model) {
  if (!layouts.has(model)) layouts.set(model, newLayout(model));
  return layouts.get(model);
}
const layouts = new WeakMap();

function newLayout(model) {
  const columns = columnsOf(model), items = itemsOf(model, columns), placed = new Map(), places = {};
  const lanes = model.wires.map(() => []);
  let x = 0;
  items.forEach((here, column) => {
    if (!here.length) return;
    for (const item of here) item.wanted = wantedY(item, model, columns, column, placed);
    stack(here);
    const width = Math.max(...here.map((item) => item.width));
    for (const item of here) {
      placed.set(item.wire === undefined ? `box ${item.box}` : `lane ${item.wire} ${column}`, item);
      if (item.wire === undefined)
        places[model.boxes[item.box].name] = [x, item.y];
      else
        lanes[item.wire].push([x, x + width, item.y + kLaneHeight / 2]);
    }
    x += width + kColumnGap;
  });
  return {places, lanes};
}
