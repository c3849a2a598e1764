// Ticks of the nodes, and messages received by each tick: sums of the generator's counts.
import {data, nodes} from "./data.mjs";

export const order = data.schedule.order;
export const rowOf = new Map(order.map((node, row) => [node, row]));
export const quantum = data.schedule.quantum.seconds;

/** Hyperperiod in seconds; null if it is too long to represent. */
export const wholePeriod = data.schedule.hyperperiod && data.schedule.hyperperiod.seconds;

export function periodOf(node) {
  return data.schedule.rates[nodes[node].rate_class].period * quantum;
}

const known = new WeakMap();
/** Prefix sums of a list, one more than it has numbers. */
function sumsOf(numbers) {
  if (!known.has(numbers)) {
    let sum = 0;
    known.set(numbers, [0, ...numbers.map((number) => (sum += number))]);
  }
  return known.get(numbers);
}

/**
 * Number of messages that a connection has received by tick n: `begin` for the first ticks, then `cycle` repeatedly.
 */
export function receivedBy({begin, cycle}, n) {
  const first = sumsOf(begin);
  if (n < begin.length) return first[n + 1];
  const later = n - begin.length, inCycle = sumsOf(cycle);
  return first[begin.length] + Math.floor(later / cycle.length) * inCycle[cycle.length] +
      inCycle[later % cycle.length + 1];
}

/** Index of the newest message that the node has at tick n; -1 if there is none yet, null if it is unknown. */
export function newestAt(input, n) {
  return input.received && receivedBy(input.received, n) - 1;
}
