// Formatting and conversion of numbers.

export function count(value) {
  return String(value).replace(/\B(?=(\d{3})+(?!\d))/g, "\u202f");
}
export function counted(value, one) {
  return `${count(value)} ${one}${value === 1 ? "" : /(s|x|sh)$/.test(one) ? "es" : "s"}`;
}
export function bytes(value) {
  return `${count(value)} B`;
}
/** Number with `digits` significant digits. */
export function short(value, digits = 4) {
  if (value === null || value === undefined || Number.isNaN(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e6 || size < 1e-4) return value.toExponential(Math.max(0, digits - 2)).replace("e+", "e");
  return String(Number(value.toPrecision(digits)));
}
export function seconds(value) {
  if (value === null || value === undefined) return "unknown";
  const size = Math.abs(value);
  if (size === 0) return "0 s";
  if (size < 1e-6) return `${short(value * 1e9, 3)} ns`;
  if (size < 1e-3) return `${short(value * 1e6, 3)} µs`;
  if (size < 1) return `${short(value * 1e3, 4)} ms`;
  return `${short(value, 5)} s`;
}
export function list(values, most = 8) {
  const texts = values.slice(0, most).map((value) => (typeof value === "number" ? short(value, 6) : String(value)));
  return texts.join(", ") + (values.length > most ? `, … (${values.length})` : "");
}
/** Bounds of a space as text. */
export function bounds(space) {
  if (!space.low.length && !space.high.length) return "no bounds";
  const same = (values) => values.every((value) => value === values[0]);
  // JSON cannot represent infinity, so an infinite bound is null.
  const finite = (values, infinity) => values.map((value) => (value === null ? infinity : value));
  const low = finite(space.low, "−∞"), high = finite(space.high, "∞");
  if (same(low) && same(high)) return `${list(low.slice(0, 1))} … ${list(high.slice(0, 1))}`;
  return `[${list(low)}] … [${list(high)}]`;
}
export function parse(fraction) {
  const [above, below] = String(fraction).split("/");
  return Number(above) / Number(below || 1);
}

/** Step of 1, 2 or 5 times a power of ten that divides `span` into about `most` parts. */
export function stepOf(span, most) {
  const raw = span / Math.max(1, most);
  const power = 10 ** Math.floor(Math.log10(raw));
  return power * ([1, 2, 5, 10].find((factor) => power * factor >= raw) || 10);
}

// Numbers from the Base64 text of little-endian float32 values.
export function floats(text) {
  const raw = atob(text), values = new Float32Array(raw.length / 4);
  const view = new DataView(Uint8Array.from(raw, (c) => c.charCodeAt(0)).buffer);
  for (let i = 0; i < values.length; ++i) values[i] = view.getFloat32(4 * i, true);
  return values;
}
