// Composites that open within a drawing.
import assert from "node:assert/strict";
import test from "node:test";

import {holds, pathOf, unfold} from "../../templates/page/unfold.mjs";

import {pageOf} from "./generator.mjs";

const namesIn = (drawing) =>
    drawing.boxes.flatMap((box) => (box.inside ? [box.composite, ...namesIn(box.inside)] : []));

/** What is wrong with places: boxes over each other, outside of their frame, wires that do not end at their ports. */
function check(drawing, name) {
  const inside = (box, frame) => box.x >= frame.x && box.y >= frame.y && box.x + box.width <= frame.x + frame.width &&
      box.y + box.height <= frame.y + frame.height;
  const whole = {x: 0, y: 0, width: drawing.width, height: drawing.height};
  drawing.boxes.forEach((box, b) => {
    assert.ok(
        inside(box, box.around === undefined ? whole : drawing.boxes[box.around]),
        `${name}: ${box.name} is outside of its frame`);
    for (const other of drawing.boxes.slice(b + 1)) {
      if (other.around !== box.around) continue;
      const apart = box.x + box.width <= other.x || other.x + other.width <= box.x || box.y + box.height <= other.y ||
          other.y + other.height <= box.y;
      assert.ok(apart, `${name}: ${box.name} and ${other.name} lie over each other`);
    }
  });
  for (const wire of drawing.wires) {
    const [from, to] = [drawing.boxes[wire.from], drawing.boxes[wire.to]];
    const [first, last] = [wire.points[0], wire.points.at(-1)];
    // A wire within a frame ends at the label of the frame's port, inside.
    const within = (box, other, x) => other.around === drawing.boxes.indexOf(box) && x > box.x && x < box.x + box.width;
    const leaves = first[0] === from.x + from.width || within(from, to, first[0]);
    const arrives = last[0] === to.x || within(to, from, last[0]);
    assert.ok(leaves && arrives, `${name}: a wire from ${from.name} to ${to.name} begins or ends in the air`);
    const heights = (box) => [...box.inputs, ...box.outputs].map((port) => box.y + port.y);
    assert.ok(
        heights(from).includes(first[1]) && heights(to).includes(last[1]),
        `${name}: a wire from ${from.name} to ${to.name} misses a port`);
  }
}

for (const graph
         of ["tests/compose/graphs/arm.yaml", "tests/compose/graphs/levels.yaml", "examples/cascade/graph.yaml",
             "tests/compose/graphs/legs.yaml"]) {
  test(`${graph}: any of them open`, () => {
    const {drawings, composites} = pageOf(graph).data;
    for (const [which, drawing] of Object.entries(drawings)) {
      const names = namesIn(drawing);
      assert.deepEqual(new Set(names), new Set(composites.map(({name}) => name)));
      const sets = [[], names, ...names.map((name) => [name]), names.filter((_, i) => i % 2)];
      const sizes = sets.map((opened) => {
        const shown = unfold(drawing, new Set(opened));
        check(shown, `${which}, open: ${opened}`);
        return shown.boxes.length;
      });
      assert.equal(sizes[0], drawing.boxes.length);
      if (names.length) assert.ok(sizes[1] > sizes[0]);
    }
  });
}

test("a box holds what is in it, however deep", () => {
  const deep = {name: "a", inside: {boxes: [{name: "b", inside: {boxes: [{name: "c"}]}}]}};
  assert.ok(holds(deep, (box) => box.name === "c") && !holds(deep, (box) => box.name === "d"));
});

test("paths: curves forwards, right angles backwards", () => {
  assert.equal(pathOf([[0, 0], [10, 4], [20, 4]], false), "M0 0C5 0 5 4 10 4L20 4");
  assert.equal(pathOf([[20, 0], [20, 9], [0, 9]], true), "M20 0L20 9L0 9");
});
