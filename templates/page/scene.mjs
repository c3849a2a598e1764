// Painting of scenes: rows of 16 numbers as in runtime/eagerx/scene.hpp, in the plane or in space. The result is that
// of `--render`, except that texts use the font of the page.

const kShapes = [
  "none", "view", "line", "polyline", "polygon", "circle", "rectangle", "arrow", "text", "camera", "plane", "box",
  "sphere", "capsule", "cylinder", "segment", "facet"
];
export const kOnScreen = 32, kColumns = 16;

/** Row of a scene that can be painted whatever its numbers are, or null. */
export function sceneRow(scene, row) {
  const [kind, colour, opacity, width] = scene.subarray(row * kColumns, row * kColumns + 4);
  const shape = kind >= 0 && kind < 2 * kOnScreen ? kShapes[Math.trunc(kind) % kOnScreen] : undefined;
  if (!shape || shape === "none") return null;
  const rgb = colour >= 0 && colour <= 0xffffff ? Math.trunc(colour) : 0;
  return {
    shape,
    onScreen: kind >= kOnScreen,
    rgb: [rgb >> 16, (rgb >> 8) & 255, rgb & 255],
    opacity: opacity > 0 ? Math.min(opacity, 1) : 0,
    width,
    n: scene.subarray(row * kColumns + 4, (row + 1) * kColumns)
  };
}

function paintOf(row, light = 1) {
  const [r, g, b] = row.rgb.map((part) => Math.min(255, Math.round(part * light)));
  return `rgba(${r}, ${g}, ${b}, ${row.opacity})`;
}

export function sceneText({n}) {
  let text = "";
  for (let i = 0; i < 18; ++i) {
    const packed = n[6 + Math.trunc(i / 3)];
    const code = packed >= 0 && packed <= 0xffffff ? (packed >> (16 - 8 * (i % 3))) & 255 : 0;
    if (!code) break;
    text += String.fromCharCode(code);
  }
  return n[4] >= 0 && n[4] <= 6 ? text.replaceAll("#", Number.isFinite(n[3]) ? n[3].toFixed(n[4]) : "–") : text;
}

// ---- Plane ----------------------------------------------------------------------------------------------------------
function traceOut(context, points, closed) {
  context.beginPath();
  points.forEach(([x, y], i) => (i ? context.lineTo(x, y) : context.moveTo(x, y)));
  if (closed) context.closePath();
}

/** Paints an arrow from `a` to `b`, with a head of at most `head` pixels. */
function paintArrow(context, a, b, head) {
  const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
  if (!(length > 0.5)) return;
  const size = Math.min(head, length), [c, s] = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
  const base = [b[0] - size * c, b[1] - size * s];
  traceOut(context, [a, base], false);
  context.stroke();
  traceOut(
      context, [b, [base[0] - size * s / 2, base[1] + size * c / 2], [base[0] + size * s / 2, base[1] - size * c / 2]],
      true);
  context.fill();
}

function paintRectangle(context, row, [x, y], scale) {
  const [, , w, h, angle, corner] = row.n;
  context.save();
  context.translate(x, y);
  context.rotate(-angle || 0);
  context.beginPath();
  const radius = Math.max(0, Math.min(corner, w / 2, h / 2) * scale || 0);
  context.roundRect(-w / 2 * scale, -h / 2 * scale, w * scale, h * scale, radius);
  row.width === 0 ? context.fill() : context.stroke();
  context.restore();
}

function paintFlat(context, row, frame, height) {
  const {n, shape} = row, scale = frame.scale, at = (i) => frame.at(n[i], n[i + 1]);
  context.fillStyle = context.strokeStyle = paintOf(row);
  context.lineWidth = row.width >= 0 ? row.width * scale : -row.width * height / 480;
  context.lineCap = context.lineJoin = "round";
  if (shape === "line") {
    traceOut(context, [at(0), at(2)], false);
    context.stroke();
  } else if (shape === "polyline" || shape === "polygon") {
    traceOut(context, [0, 2, 4, 6, 8, 10].map(at), shape === "polygon");
    shape === "polygon" && row.width === 0 ? context.fill() : context.stroke();
  } else if (shape === "circle" && n[2] > 0) {
    context.beginPath();
    context.arc(...at(0), n[2] * scale, 0, 2 * Math.PI);
    row.width === 0 ? context.fill() : context.stroke();
  } else if (shape === "rectangle") {
    paintRectangle(context, row, at(0), scale);
  } else if (shape === "arrow") {
    paintArrow(context, at(0), at(2), n[4] * scale);
  } else if (shape === "text") {
    context.textBaseline = "alphabetic";
    context.textAlign = n[5] === 1 ? "center" : n[5] === 2 ? "right" : "left";
    context.font =
        `${Math.max(1, n[2] * scale / 0.72)}px ui-monospace, 'DejaVu Sans Mono', 'Liberation Mono', monospace`;
    context.fillText(sceneText(row), ...at(0));
  }
}

// ---- Space ----------------------------------------------------------------------------------------------------------
const plus = (a, b) => a.map((x, i) => x + b[i]);
const minus = (a, b) => a.map((x, i) => x - b[i]);
const times = (s, a) => a.map((x) => s * x);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
function unit(a) {
  const length = Math.sqrt(dot(a, a));
  return length > 0 ? times(1 / length, a) : [0, 0, 1];
}
/** Vector `p` of a body's frame, rotated into the frame of the scene: `n` has a position and a quaternion. */
function turned(n, p) {
  const v = [n[4], n[5], n[6]], t = times(2, cross(v, p));
  return plus(plus(p, times(n[3], t)), cross(v, t));
}
const placed = (n, p) => plus([n[0], n[1], n[2]], turned(n, p));
const kToLight = [0.36, -0.48, 0.8];
function lightOn(normal) {
  const towards = dot(normal, kToLight);
  return 0.62 + 0.38 * (towards > 0 ? towards : 0.35 * towards);
}

class SceneCamera {
  constructor(n, width, height) {
    this.eye = [n[0], n[1], n[2]];
    this.forward = unit(minus([n[3], n[4], n[5]], this.eye));
    this.right = unit(cross(this.forward, Math.abs(this.forward[2]) > 0.999 ? [0, 1, 0] : [0, 0, 1]));
    this.up = cross(this.right, this.forward);
    this.focal = height / 2 / Math.tan(Math.min(Math.max(n[6] / 2, 0.01), 1.5));
    this.middle = [width / 2, height / 2];
  }
  depth(p) {
    return dot(minus(p, this.eye), this.forward);
  }
  /** Projection of a point; null if the point is behind the camera or too close to it. */
  see(p) {
    const d = minus(p, this.eye), z = dot(d, this.forward);
    if (!(z > 0.01)) return null;
    return [this.middle[0] + this.focal / z * dot(d, this.right), this.middle[1] - this.focal / z * dot(d, this.up)];
  }
  size(p, length) {
    return length * this.focal / Math.max(this.depth(p), 0.01);
  }
}

function paintFace(context, camera, corners, fill) {
  const points = corners.map((corner) => camera.see(corner));
  if (points.includes(null)) return;
  traceOut(context, points, true);
  context.fillStyle = context.strokeStyle = fill;
  context.fill();
  context.lineWidth = 0.7;  // hides seams between adjacent faces
  context.stroke();
}

function paintPlane(context, camera, row) {
  const [x, y, z, half, width] = row.n;
  const side = width > 0 ? width : 2 * half, count = Math.trunc(Math.min(32, Math.max(1, 2 * half / side || 1)));
  for (let i = 0; i < count; ++i)
    for (let k = 0; k < count; ++k) {
      const [left, near] = [x - half + i * side, y - half + k * side];
      const corners = [[left, near, z], [left + side, near, z], [left + side, near + side, z], [left, near + side, z]];
      paintFace(context, camera, corners, paintOf(row, (i + k) % 2 ? 1 : 0.94));
    }
}

/** Paints the faces of `corners` that point toward the camera; a face is [corners, normal]. */
function paintFaces(context, camera, row, faces) {
  for (const [corners, normal] of faces)
    if (dot(normal, minus(camera.eye, corners[0])) > 0)
      paintFace(context, camera, corners, paintOf(row, lightOn(normal)));
}

function paintBox(context, camera, row) {
  const {n} = row, half = [n[7] / 2, n[8] / 2, n[9] / 2];
  const faces = [0, 1, 2].flatMap((axis) => [-1, 1].map((sign) => {
    const [u, v] = [(axis + 1) % 3, (axis + 2) % 3], normal = [0, 0, 0];
    normal[axis] = sign;
    const corners = [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([a, b]) => {
      const p = [0, 0, 0];
      [p[axis], p[u], p[v]] = [sign * half[axis], a * half[u], b * half[v]];
      return placed(n, p);
    });
    return [corners, turned(n, normal)];
  }));
  paintFaces(context, camera, row, faces);
}

function paintCylinder(context, camera, row) {
  const kSides = 16, {n} = row, half = n[8] / 2;
  const circle = (k) => [Math.cos(k * 2 * Math.PI / kSides), Math.sin(k * 2 * Math.PI / kSides)];
  const rim = (k, z) => placed(n, [n[7] * circle(k)[0], n[7] * circle(k)[1], z]);
  const around = Array.from({length: kSides}, (_, k) => k);
  paintFaces(context, camera, row, [
    ...around.map(
        (k) => [
            [rim(k, -half), rim(k + 1, -half), rim(k + 1, half), rim(k, half)], turned(n, [...circle(k + 0.5), 0])]),
    [around.map((k) => rim(k, half)), turned(n, [0, 0, 1])], [around.map((k) => rim(k, -half)), turned(n, [0, 0, -1])]
  ]);
}

/** Paints the convex hull of two discs. */
function paintHull(context, a, ra, b, rb, fill) {
  if (!(ra >= 0 && rb >= 0)) return;
  context.fillStyle = fill;
  const angle = Math.atan2(b[1] - a[1], b[0] - a[0]), length = Math.hypot(b[0] - a[0], b[1] - a[1]);
  context.beginPath();
  if (!(length > Math.abs(ra - rb)) || !(length > 0.001)) {
    context.arc(...(ra >= rb ? a : b), Math.max(ra, rb), 0, 2 * Math.PI);
  } else {
    const half = Math.acos((ra - rb) / length);
    context.arc(...b, rb, angle - half, angle + half);
    context.arc(...a, ra, angle + half, angle - half + 2 * Math.PI);
    context.closePath();
  }
  context.fill();
}

/** Paints a sphere, or a capsule from a to b, shaded by a light above and to the left. */
function paintRound(context, camera, row, a, b, radius) {
  const [pa, pb] = [camera.see(a), camera.see(b)];
  if (!pa || !pb) return;
  const [ra, rb] = [camera.size(a, radius), camera.size(b, radius)];
  paintHull(context, pa, ra, pb, rb, paintOf(row, 0.66));
  [0.86, 0.66, 0.42].forEach((part, i) => {
    const off = 0.32 * (1 - part), moved = ([x, y], r) => [x - off * r, y - 1.6 * off * r];
    paintHull(context, moved(pa, ra), part * ra, moved(pb, rb), part * rb, paintOf(row, 0.78 + 0.1 * i));
  });
}

const facetCorners = (n) => [0, 3, 6, 9].map((i) => [...n.subarray(i, i + 3)]);

/** Center of a row in space. */
function middleOf({n, shape}) {
  if (shape === "segment") return [(n[0] + n[3]) / 2, (n[1] + n[4]) / 2, (n[2] + n[5]) / 2];
  if (shape === "facet") return times(0.25, facetCorners(n).reduce(plus));
  return [n[0], n[1], n[2]];
}

function paintInSpace(context, camera, row, height) {
  const {n, shape} = row, at = [n[0], n[1], n[2]];
  if (shape === "plane") return paintPlane(context, camera, row);
  if (shape === "box") return paintBox(context, camera, row);
  if (shape === "cylinder") return paintCylinder(context, camera, row);
  if (shape === "sphere") return paintRound(context, camera, row, at, at, n[3]);
  if (shape === "capsule") {
    const half = times(n[8] / 2, turned(n, [0, 0, 1]));
    return paintRound(context, camera, row, minus(at, half), plus(at, half), n[7]);
  }
  if (shape === "facet") {
    const corners = facetCorners(n), [a, b, c] = corners, normal = unit(cross(minus(b, a), minus(c, a)));
    const seen = dot(normal, minus(camera.eye, a)) < 0 ? times(-1, normal) : normal;
    return paintFace(context, camera, corners, paintOf(row, lightOn(seen)));
  }
  const end = [n[3], n[4], n[5]], [pa, pb] = [camera.see(at), camera.see(end)];
  if (!pa || !pb) return;
  const radius = (p) => (row.width < 0 ? -row.width * height / 480 : camera.size(p, row.width)) / 2;
  paintHull(context, pa, radius(at), pb, radius(end), paintOf(row));
}

/** Paints the whole picture: first shapes in space, the farthest first, then those of the plane in their order. */
export function paintScene(context, scene, width, height) {
  const rows = [];
  for (let row = 0; row < scene.length / kColumns && scene[row * kColumns] !== 0; ++row)
    rows.push(sceneRow(scene, row));
  const known = rows.filter(Boolean);
  const seen = known.find((row) => row.shape === "camera" || (row.shape === "view" && row.n[2] > 0));
  context.fillStyle = seen ? paintOf({...seen, opacity: 1}) : "white";
  context.fillRect(0, 0, width, height);
  const screen = {scale: height, at: (x, y) => [x * width, (1 - y) * height]};
  let view = screen;
  if (seen && seen.shape === "view") {
    const scale = height / seen.n[2];
    view = {scale, at: (x, y) => [width / 2 + (x - seen.n[0]) * scale, height / 2 - (y - seen.n[1]) * scale]};
  } else if (seen) {
    const camera = new SceneCamera(seen.n, width, height), first = kShapes.indexOf("plane");
    const depth = (row) => (row.shape === "plane" ? Infinity : camera.depth(middleOf(row)));
    known.filter((row) => kShapes.indexOf(row.shape) >= first)
        .map((row) => [depth(row), row])
        .sort(([a], [b]) => (a === b ? 0 : b - a))
        .forEach(([, row]) => paintInSpace(context, camera, row, height));
  }
  for (const row of known)
    if (kShapes.indexOf(row.shape) < kShapes.indexOf("camera"))
      paintFlat(context, row, row.onScreen ? screen : view, height);
}
