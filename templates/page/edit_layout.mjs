// Places of boxes: what somebody chose, and for the rest columns along the way of messages.

export const kPortHeight = 22, kBoxHead = 46, kBoxGap = 26, kColumnGap = 90, kPortReach = 11;

const textWidth = (text, wide = 6.8) => text.length * wide;

/** {width, height} of a box, from its texts. */
export function sizeOf(box) {
  const rows = Math.max(box.inputs.length, box.outputs.length, 1);
  const longest = (ports) => Math.max(0, ...ports.map(({name}) => textWidth(name)));
  const ports = longest(box.inputs) + longest(box.outputs) + 48;
  const width = Math.max(130, textWidth(box.title, 8.6) + 24, textWidth(box.subtitle) + 24, ports);
  return {width: Math.ceil(width), height: kBoxHead + rows * kPortHeight + 6};
}

/** The middle of a port, from the corner of its box. */
export function portPlace(size, side, number) {
  return [side === "outputs" ? size.width : 0, kBoxHead + number * kPortHeight + kPortHeight / 2 - 4];
}

/** How many wires lie before each box at most; wires that skip, or would close a circle, do not count. */
function columnsOf(model) {
  const columns = model.boxes.map(({section}) => (section === "actions" ? 0 : 1)), doing = new Set(), done = new Set();
  const follow = (b) => {
    if (done.has(b)) return;
    doing.add(b);
    for (const {from, to, connection} of model.wires) {
      if (to !== b || doing.has(from) || connection.skip === "true") continue;
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

/** A place for each box by its name, in columns from left to right. */
export function columnPlaces(model) {
  const columns = columnsOf(model), places = {};
  let x = 0;
  for (let column = 0; column <= Math.max(...columns); ++column) {
    const here = model.boxes.filter((_, b) => columns[b] === column);
    if (!here.length) continue;
    const sizes = here.map(sizeOf);
    const total = sizes.reduce((sum, {height}) => sum + height + kBoxGap, -kBoxGap);
    let y = Math.round(-total / 2);
    here.forEach((box, i) => {
      places[box.name] = [x, y];
      y += sizes[i].height + kBoxGap;
    });
    x += Math.max(...sizes.map(({width}) => width)) + kColumnGap;
  }
  return places;
}

const overlaps = (a, b) =>
    a.x < b.x + b.width + 10 && b.x < a.x + a.width + 10 && a.y < b.y + b.height + 10 && b.y < a.y + a.height + 10;

/** `wanted` moved down until it lies over none of `others` ({x, y, width, height}). */
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
 * Boxes with {x, y, width, height}. `chosen` are places by names: boxes that have one keep it, others get the place of
 * their column where nothing lies yet.
 */
export function placedBoxes(model, chosen) {
  const isPlaced = (box) => Array.isArray(chosen[box.name]);
  const fallback = columnPlaces(model);
  const placed = new Map();
  const put = (box, [x, y]) => placed.set(box, {...sizeOf(box), x, y});
  for (const box of model.boxes.filter(isPlaced)) put(box, chosen[box.name]);
  // What the agent sees is last in the list and right of everything.
  for (const box of model.boxes.filter((one) => !isPlaced(one))) {
    const [x, y] = fallback[box.name], others = [...placed.values()];
    const right =
        box.section === "observations" ? Math.max(...others.map((other) => other.x + other.width)) + kColumnGap : x;
    const free = freePlace({...sizeOf(box), x: Math.max(x, right), y}, others);
    put(box, [free.x, free.y]);
  }
  return model.boxes.map((box) => placed.get(box));
}

/** The d of a wire from [x, y] to [x, y]. */
export function wirePath([x, y], [toX, toY]) {
  const bend = Math.max(40, Math.abs(toX - x) / 2);
  if (toX > x + 20) return `M${x} ${y}C${x + bend} ${y} ${toX - bend} ${toY} ${toX} ${toY}`;
  const reach = Math.min(160, 50 + Math.abs(toY - y) / 4);
  return `M${x} ${y}C${x + reach} ${y} ${x + reach} ${y + (toY > y ? 60 : -60)} ${(x + toX) / 2} ${(y + toY) / 2}` +
      `S${toX - reach} ${toY} ${toX} ${toY}`;
}

/** What lies at a point: {box, side, number} a port, {box}, or null. Boxes that are drawn last lie above. */
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

/** Where a wire would end if it were let go here: the port, or of a row the port of that row on `side`. */
export function targetAt(model, places, side, x, y) {
  const hit = hitAt(model, places, x, y);
  if (!hit || hit.number !== undefined) return hit && hit.side === side ? hit : null;
  const number = Math.floor((y - places[hit.box].y - kBoxHead + 4) / kPortHeight);
  const isEnd = model.boxes[hit.box].section === (side === "outputs" ? "actions" : "observations");
  if (number >= 0 && number < model.boxes[hit.box][side].length) return {box: hit.box, side, number};
  return isEnd ? {box: hit.box, side, number: -1} : null;  // a new one
}

/** {x, y, width, height} of all boxes together. */
export function extentOf(places) {
  const left = Math.min(...places.map(({x}) => x)), top = Math.min(...places.map(({y}) => y));
  const right = Math.max(...places.map(({x, width}) => x + width));
  const bottom = Math.max(...places.map(({y, height}) => y + height));
  return {x: left, y: top, width: right - left, height: bottom - top};
}
