// Messages that a connection has received: the page adds up the generator's counts. This test counts in another way,
// message by message in exact fractions.
import assert from "node:assert/strict";
import test from "node:test";

import {become, smallData} from "./dom.mjs";
import {pageOf} from "./generator.mjs";

become(smallData());
const {newestAt, receivedBy, periodOf, wholePeriod} = await import("../../templates/page/schedule.mjs");

const fraction = (text) => {
  const [num, den] = String(text).split("/");
  const places = num.includes(".") ? num.length - num.indexOf(".") - 1 : 0;
  return [BigInt(num.replace(".", "")), BigInt(den || 1) * 10n ** BigInt(places)];
};
const floor = (num, den) => num >= 0n || num % den === 0n ? num / den : num / den - 1n;

/** The newest message s with s / source + delay <= n / rate; message 0 is always there. */
function newest(source, rate, delay, n) {
  const [a, b] = fraction(source), [c, d] = fraction(rate), [e, f] = fraction(delay);
  // (n d / c - e / f) a / b
  const last = floor((BigInt(n) * d * f - e * c) * a, c * f * b);
  return Number(last > 0n ? last : 0n);
}

function compare(data, name) {
  let compared = 0;
  for (const node of data.nodes)
    for (const input of node.inputs) {
      if (!input.received || input.skip) continue;
      const source = data.nodes[input.source[0]].rate, delay = (input.longest_delay ?? input.delay).exact;
      for (let n = 0; n < 300; ++n)
        assert.equal(newestAt(input, n), newest(source, node.rate, delay, n), `${name}: ${input.written}, tick ${n}`);
      ++compared;
    }
  return compared;
}

test("the messages that ticks read are those that have come", () => {
  const graphs = [
    "tests/golden/multi_rate/graph.yaml", "examples/pendulum_swing_up/graph.yaml", "examples/cascade/graph.yaml",
    "tests/delays/of_connection.yaml"
  ];
  for (const graph of graphs) assert.ok(compare(pageOf(graph).data, graph) > 1, graph);
});

test("what has a long cycle is counted, too, and what does not come by count is not known", () => {
  const {nodes, schedule} = pageOf("tests/page/odd_rates.yaml").data;
  assert.equal(schedule.hyperperiod, null);
  const named = new Map(nodes.flatMap((node) => node.inputs.map((input) => [input.written, [node, input]])));
  const [b, fromA] = named.get("b.signal");
  assert.equal(fromA.received.cycle.length, 17123);
  for (const n of [0, 1, 2, 17122, 17123, 17124, 99999, 12345678])
    assert.equal(newestAt(fromA, n), newest("29.97", b.rate, "0", n), `tick ${n}`);
  assert.equal(newestAt(named.get("d.signal")[1], 5), null);
});

test("a skipped connection has nothing at the first tick, and then the message before", () => {
  const {nodes} = pageOf("tests/own_loop/skipped.yaml").data;
  const skipped = nodes.flatMap((node) => node.inputs.map((input) => [node, input]))
                      .filter(([, input]) => input.skip && input.received);
  assert.ok(skipped.length > 0);
  for (const [node, input] of skipped) {
    assert.equal(newestAt(input, 0), -1);
    if (nodes[input.source[0]].rate === node.rate)
      assert.deepEqual([1, 2, 9].map((n) => newestAt(input, n)), [0, 1, 8]);
  }
});

test("first ticks, then a cycle over and over", () => {
  const received = {begin: [1, 0, 0], cycle: [2, 0, 1]};
  assert.deepEqual(Array.from({length: 10}, (_, n) => receivedBy(received, n)), [1, 1, 1, 3, 3, 4, 6, 6, 7, 9]);
  assert.equal(receivedBy(received, 3 + 3 * 1e9), 1 + 3e9 + 2);
  assert.equal(newestAt({received: null}, 5), null);
});

test("periods are those of the rates", () => {
  assert.deepEqual([periodOf(0), periodOf(1), wholePeriod], [0.1, 0.05, 0.1]);
});
