// Memory use: buffers and, with an image, flash, RAM and stack of each node.
import {data, inputOf, nodes, outputName} from "./data.mjs";
import {bar, card, el, table, tiles} from "./elements.mjs";
import {bytes, count, counted, list} from "./numbers.mjs";
import {select} from "./selection.mjs";

function memoryRows() {
  const rows = new Map();
  const row = (name, node) => {
    if (!rows.has(name))
      rows.set(name, {name, node, buffers: 0, flash: data.images.map(() => 0), ram: data.images.map(() => 0)});
    return rows.get(name);
  };
  for (const ring of data.rings) row(nodes[ring.node].name, ring.node).buffers += ring.bytes;
  const numberOf = new Map(nodes.map((node) => [node.name, node.number]));
  data.images.forEach((image, i) => {
    for (const [group, isNode] of [[image.size.nodes, true], [image.size.others, false]]) {
      for (const [name, used] of Object.entries(group || {})) {
        // An item that several nodes share can have the name of a node.
        const at = row(isNode ? name : `(${name})`, isNode ? numberOf.get(name) : undefined);
        at.flash[i] += used.flash;
        at.ram[i] += used.ram;
      }
    }
  });
  const weight = (r) => (data.images.length ? r.flash[0] + r.ram[0] : r.buffers);
  return [...rows.values()].sort((a, b) => weight(b) - weight(a) || (a.name < b.name ? -1 : 1));
}

export function withBar(value, most, kind) {
  return el("div.measure", {}, el("span", {}, value ? count(value) : "–"), bar(most ? value / most : 0, null, kind));
}

function memoryColumns(rows) {
  const most = (of) => Math.max(1, ...rows.map(of));
  const columns = [{name: "node", cell: (row) => row.name}];
  const buffers = most((row) => row.buffers);
  columns.push({name: "buffers, B", cell: (row) => withBar(row.buffers, buffers, "")});
  data.images.forEach((image, i) => {
    const label = data.images.length > 1 ? ` of ${image.name}` : "";
    const flash = most((row) => row.flash[i]), ram = most((row) => row.ram[i]);
    columns.push({name: `flash${label}, B`, cell: (row) => withBar(row.flash[i], flash, "flash")});
    columns.push({name: `RAM${label}, B`, cell: (row) => withBar(row.ram[i], ram, "ram")});
  });
  return columns;
}

function imageCard(image) {
  const {size} = image;
  const {stack, instructions} = size;
  return card(
      image.name, tiles([
        ["flash", bytes(size.flash)], ["RAM", bytes(size.ram), "without the stack"],
        ["stack", bytes(stack.bytes), "at most; interrupts come on top"],
        instructions ? ["instructions a slot", count(instructions.most), "at most"] : null
      ].filter(Boolean)),
      stack.calls.length ?
          el("details", {}, el("summary", {}, `The deepest chain: ${counted(stack.calls.length, "function")}`),
             el("ol.calls", {},
                stack.calls.map(
                    (call) => el("li", {}, `${call.function}, ${bytes(call.bytes)}, ${call.node || call.part}`)))) :
          null,
      stack.unbounded.length ?
          el("p.note", {}, `Not counted are calls through pointers or of themselves in: ${list(stack.unbounded, 12)}`) :
          null);
}

/** Reader that needs the most messages. A buffer of one message may have no reader. */
export function whyText(ring) {
  return ring.why || "one message is always kept";
}

export function makeMemoryView(panel) {
  const rows = memoryRows();
  const rings = [...data.rings].sort((a, b) => b.bytes - a.bytes || a.number - b.number);
  const sum = (of) => rings.reduce((all, ring) => all + of(ring), 0);
  panel.append(card(
      "Buffers", tiles([
        ["buffers", count(rings.length)], ["messages", count(sum((ring) => ring.messages))],
        ["bytes", count(sum((ring) => ring.bytes))]
      ]),
      el("p.note", {},
         "A buffer holds the newest messages of an output. It has room for the reader that needs most; this is " +
             "rounded up to a power of two, except where messages are large.")));
  panel.append(...data.images.map(imageCard));
  panel.append(card(
      "Nodes", table(memoryColumns(rows), rows, 100, (row) => row.node !== undefined && select({node: row.node}))));
  const most = Math.max(1, ...rings.map((ring) => ring.bytes));
  panel.append(card(
      "Why each buffer has its size",
      table(
          [
            {
              name: "buffer",
              cell: (ring) => outputName(ring.node, ring.output) +
                  (ring.reader ? `, converted for ${nodes[ring.reader[0]].inputs[ring.reader[1]].written}` : "")
            },
            {name: "message", cell: (ring) => ring.space.text},
            {name: "needs", number: true, cell: (ring) => count(ring.needed)},
            {name: "has", number: true, cell: (ring) => count(ring.messages)},
            {name: "bytes", cell: (ring) => withBar(ring.bytes, most, "")},
            {name: "because of", cell: (ring) => whyText(ring)},
          ],
          rings, 100, (ring) => {
            const due = ring.reader ||
                [...inputOf.values()]
                    .filter((input) => input.ring === ring.number && ring.why.includes(input.written))
                    .map((input) => [input.node, input.number])[0];
            select(due ? {input: due} : {node: ring.node});
          })));
  return {shown() {}, resized() {}};
}
