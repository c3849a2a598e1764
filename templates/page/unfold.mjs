// Drawings with open composites. The generator places composites closed, and the content of each one separately. A box
// that opens moves boxes on its right to the right, and boxes below it in its column down.

/** SVG path through points, with right angles if it runs against the reading direction. */
export function pathOf(points, backwards) {
  const [first, ...rest] = points;
  let d = `M${first[0]} ${first[1]}`, [x, y] = first;
  for (const [toX, toY] of rest) {
    const middle = Math.round((x + toX) / 2);
    d += backwards || y === toY ? `L${toX} ${toY}` : `C${middle} ${y} ${middle} ${toY} ${toX} ${toY}`;
    [x, y] = [toX, toY];
  }
  return d;
}

/** Shifts that open boxes cause: `x(at)`, and `y(right, at)` in the column that ends at `right`. */
function stretchOf(boxes) {
  const columns = new Map();  // by right edge: added width, and height added below which position
  for (const {box, width, height} of boxes) {
    const right = box.x + box.width;
    const column = columns.get(right) || {wider: 0, lower: []};
    column.wider = Math.max(column.wider, width - box.width);
    column.lower.push([box.y + box.height, height - box.height]);
    columns.set(right, column);
  }
  const below = (column, at) =>
      column ? column.lower.reduce((sum, [from, more]) => sum + (from <= at ? more : 0), 0) : 0;
  return {
    x: (at) => [...columns].reduce((sum, [right, {wider}]) => sum + (right <= at ? wider : 0), at),
    y: (right, at) => at + below(columns.get(right), at),
    lowest: Math.max(0, ...[...columns.values()].map((column) => below(column, Infinity))),
  };
}

/**
 * Drawing with all boxes in one list and all wires in another, including those in open composites. An open box has
 * `open`; boxes in it have its index as `around`.
 */
export function unfold(drawing, opened) {
  const inner =
      drawing.boxes.map((box) => (box.inside && opened.has(box.composite) ? unfold(box.inside, opened) : null));
  const sizes = drawing.boxes.map((box, i) => ({
                                    box,
                                    width: Math.max(box.width, inner[i] ? inner[i].width : 0),
                                    height: Math.max(box.height, inner[i] ? inner[i].height : 0),
                                  }));
  const stretch = stretchOf(sizes.filter((size, i) => inner[i]));
  const result = {
    width: stretch.x(drawing.width),
    height: drawing.height + stretch.lowest,
    boxes: [],
    wires: [],
  };
  const numbers = drawing.boxes.map((box, i) => {
    const {width, height} = sizes[i];
    const right = box.x + box.width;
    const portsAt = (ports, end) => ports.map((port, p) => ({...port, y: end ? end.y + end.ports[p].y : port.y}));
    result.boxes.push({
      ...box,
      x: stretch.x(box.x),
      y: stretch.y(right, box.y),
      width,
      height,
      open: inner[i] !== null,
      inputs: portsAt(box.inputs, inner[i] && inner[i].entry),
      outputs: portsAt(box.outputs, inner[i] && inner[i].exit),
    });
    return result.boxes.length - 1;
  });
  drawing.wires.forEach((wire) => {
    const from = result.boxes[numbers[wire.from]], to = result.boxes[numbers[wire.to]];
    const begin = [from.x + from.width, from.y + from.outputs[wire.output].y];
    const end = [to.x, to.y + to.inputs[wire.input].y];
    const edge = drawing.boxes[wire.from].x + drawing.boxes[wire.from].width;
    const inside = wire.points.slice(1, -1);
    let points;
    if (wire.backwards) {
      const [right, , left] = inside;
      const lane = right && inside[1][1] + stretch.lowest;
      points = [
        [stretch.x(right[0]), begin[1]], [stretch.x(right[0]), lane], [stretch.x(left[0]), lane],
        [stretch.x(left[0]), end[1]]
      ];
    } else {
      // Pairs of points at the left and right of each column that the wire passes.
      points = inside.map(([x, y], p) => [stretch.x(x), stretch.y(inside[p | 1][0], y)]);
      if (stretch.x(edge) > begin[0]) points.unshift([stretch.x(edge), begin[1]]);
    }
    result.wires.push({...wire, from: numbers[wire.from], to: numbers[wire.to], points: [begin, ...points, end]});
  });
  inner.forEach((part, i) => {
    if (part) place(part, numbers[i]);
  });

  /** Adds the content of the open box `around` to the drawing. */
  function place(part, around) {
    const frame = result.boxes[around];
    const base = result.boxes.length - 2;  // the two ends of the part are the frame itself
    for (const box of part.boxes.slice(2))
      result.boxes.push({
        ...box,
        x: box.x + frame.x,
        y: box.y + frame.y,
        around: box.around === undefined ? around : box.around + base,
      });
    const number = (box) => (box < 2 ? around : box + base);
    for (const wire of part.wires) {
      const points = wire.points.map(([x, y]) => [x + frame.x, y + frame.y]);
      if (wire.to === 1) points[points.length - 1][0] += frame.width - part.width;
      result.wires.push({...wire, from: number(wire.from), to: number(wire.to), points});
    }
  }

  if (drawing.boxes[0].kind === "entry") {
    const [entry, exit] = result.boxes;
    result.entry = {y: entry.y, ports: entry.outputs};
    result.exit = {y: exit.y, ports: exit.inputs};
  }
  return result;
}

/** True if `is` accepts a box, or one inside it. */
export function holds(box, is) {
  return is(box) || (box.inside !== undefined && box.inside.boxes.some((inner) => holds(inner, is)));
}
