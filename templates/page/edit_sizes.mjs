// Sizes of boxes, and positions of their ports.

export const kPortHeight = 22, kBoxHead = 46, kBoxGap = 26, kColumnGap = 90, kPortReach = 11;

const textWidth = (text, wide = 6.8) => text.length * wide;

/** {width, height} of a box, from the lengths of its texts. */
export function sizeOf(box) {
  const rows = Math.max(box.inputs.length, box.outputs.length, 1);
  const longest = (ports) => Math.max(0, ...ports.map(({name}) => textWidth(name)));
  const ports = longest(box.inputs) + longest(box.outputs) + 48;
  const width = Math.max(130, textWidth(box.title, 8.6) + 24, textWidth(box.subtitle) + 24, ports);
  return {width: Math.ceil(width), height: kBoxHead + rows * kPortHeight + 6};
}

/** Center of a port, relative to the corner of its box. */
export function portPlace(size, side, number) {
  return [side === "outputs" ? size.width : 0, kBoxHead + number * kPortHeight + kPortHeight / 2 - 4];
}
