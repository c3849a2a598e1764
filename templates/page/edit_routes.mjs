// Routes of wires: from left to right past other boxes, and back below them.
import {columnLayout} from "./edit_columns.mjs";
import {portPlace} from "./edit_sizes.mjs";

/** SVG path of a wire that is being drawn, from one point to another. */
export function loosePath([x, y], [toX, toY]) {
  const bend = Math.max(40, Math.abs(toX - x) / 2);
  return `M${x} ${y}C${x + bend} ${y} ${toX - bend} ${toY} ${toX} ${toY}`;
}

const kCorner = 8, kReach = 22;

/** SVG path along points, with rounded right angles. */
function roundedPath(points) {
  let d = `M${points[0].join(" ")}`;
  for (let i = 1; i + 1 < points.length; ++i) {
    const [x, y] = points[i], [px, py] = points[i - 1], [nx, ny] = points[i + 1];
    const before = Math.min(kCorner, Math.hypot(x - px, y - py) / 2),
          after = Math.min(kCorner, Math.hypot(nx - x, ny - y) / 2);
    d += `L${x - Math.sign(x - px) * before} ${y - Math.sign(y - py) * before}`;
    d += `Q${x} ${y} ${x + Math.sign(nx - x) * after} ${y + Math.sign(ny - y) * after}`;
  }
  return d + `L${points.at(-1).join(" ")}`;
}

/** Height at which a return wire meets no box: between the two boxes, or below everything between them. */
function heightOfReturn(places, source, target, left, right) {
  const [upper, lower] = source.y < target.y ? [source, target] : [target, source];
  const between = places.filter((place) => place.x < right && place.x + place.width > left);
  const y = (lower.y + upper.y + upper.height) / 2;
  const isClear = (place) => y < place.y - 4 || y > place.y + place.height + 4;
  if (lower.y - (upper.y + upper.height) > 16 && between.every(isClear)) return y;
  return Math.max(...between.map((place) => place.y + place.height)) + 14;
}

/**
 * SVG path of each wire. Return wires run side by side. `isFree`: the user has moved no box, so the lanes of the
 * columns are valid.
 */
export function wireRoutes(model, places, isFree) {
  const lanes = isFree ? columnLayout(model).lanes : [];
  let returns = 0;
  return model.wires.map((wire, w) => {
    const source = places[wire.from], target = places[wire.to];
    const [dx, dy] = portPlace(source, "outputs", wire.output), [ex, ey] = portPlace(target, "inputs", wire.input);
    const from = [source.x + dx, source.y + dy], to = [target.x + ex, target.y + ey];
    if (to[0] > from[0] + 20) return forwardRoute(from, to, lanes[w] ?? []);
    const shift = 6 * (returns++ % 6), right = from[0] + kReach + shift, left = to[0] - kReach - shift;
    const y = heightOfReturn(places, source, target, left, right) + shift;
    return roundedPath([from, [right, from[1]], [right, y], [left, y], [left, to[1]], to]);
  });
}

/** SVG path past columns on straight lanes, with curves between them. */
function forwardRoute(from, to, lanes) {
  let d = `M${from.join(" ")}`, [x, y] = from;
  const curve = (toX, toY) => {
    const middle = (x + toX) / 2;
    d += `C${middle} ${y} ${middle} ${toY} ${toX} ${toY}`;
    [x, y] = [toX, toY];
  };
  for (const [left, right, height] of lanes) {
    curve(left, height);
    d += `L${right} ${height}`;
    x = right;
  }
  curve(...to);
  return d;
}
