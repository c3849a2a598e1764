#!/usr/bin/env python3
"""Writes a graph of many trivial nodes, always the same one for the same number of nodes.

    make_graph.py NODES FOLDER [NAME]

FOLDER/graph.yaml: layers of 50 nodes `Mix` at 10, 20, 30, 40 and 60 Hz; the first half of the layers is
sensing, the second half acts on what the environment decides. Every node takes one or two messages from the two
layers before it; one input in ten has a window, one in fifteen a delay, one in fifteen is skipped feedback from
a later layer.
FOLDER/by_hand.hpp: the same nodes sorted by rate and windows, for tests/bench/nodes/by_hand.cpp.
"""
import random
import sys
from pathlib import Path

WIDTH = 50
RATES_HZ = [10, 20, 30, 40, 60]
ENVIRONMENT_HZ = 20
ENGINE_HZ = 10
SEED = 20


class Input:
    def __init__(self, source):
        self.source = source  # a node's number, or None for the action
        self.window = 1
        self.delay_s = 0
        self.skip = False


class Mix:
    def __init__(self, number, rate_hz, inputs):
        self.number, self.rate_hz, self.inputs = number, rate_hz, inputs

    @property
    def name(self):
        return f"mix_{self.number:04}"


def pick_input(rng, number, layer, half, count):
    """An input of node `number`; sources are at most two layers back, on the same side of the environment or before."""
    first = max(0, (layer - 2) * WIDTH)
    end = layer * WIDTH
    feedback = rng.random() < 1 / 15 and number + WIDTH < count
    if feedback or end == 0:
        item = Input(rng.randrange(number + 1, min(count, number + 3 * WIDTH)))
        item.skip = True
    elif layer == half and rng.random() < 0.5:
        item = Input(None)
    else:
        item = Input(rng.randrange(first, end))
    if rng.random() < 1 / 10:
        item.window = rng.randrange(2, 5)
    elif not item.skip and rng.random() < 1 / 15:
        item.delay_s = rng.randrange(1, 6) / 100
    return item


def make_nodes(count, rates_hz=RATES_HZ):
    rng = random.Random(SEED)
    half = max(1, (count // WIDTH) // 2)  # layer from which on nodes act
    nodes = []
    for number in range(count):
        layer = number // WIDTH
        ports = 1 if rng.random() < 0.4 else 2
        inputs = [pick_input(rng, number, layer, half, count) for _ in range(ports)]
        nodes.append(Mix(number, rng.choice(rates_hz), inputs))
    return nodes, half


def graph_text(name, nodes, half):
    """The graph file. The last sensing layer is observed, the last acting one has no reader."""
    observed = nodes[max(0, half - 1) * WIDTH:half * WIDTH][:8]
    lines = [
        f"# {len(nodes)} trivial nodes, made by tests/bench/make_graph.py.",
        f"name: {name}",
        f"rate: {ENVIRONMENT_HZ}",
        f"engine: {{type: OdeEngine, rate: {ENGINE_HZ}}}",
        "actions:",
        "  drive: {space: {dtype: uint32, shape: [], low: 0, high: 1000}}",
        f"observations: [{', '.join(f'seen_{i}' for i in range(len(observed)))}]",
        "agent: random",
        "nodes:",
    ]
    for node in nodes:
        ports = "" if len(node.inputs) == 2 else ", inputs: [a]"
        lines.append(f"  {node.name}: {{type: Mix, rate: {node.rate_hz}{ports}}}")
    lines.append("connections:")
    for node in nodes:
        for port, item in zip("ab", node.inputs):
            source = "actions.drive" if item.source is None else f"{nodes[item.source].name}.mixed"
            settings = ""
            if item.window != 1:
                settings += f", window: {item.window}"
            if item.delay_s:
                settings += f", delay: {item.delay_s}"
            if item.skip:
                settings += ", skip: true"
            lines.append(f"  - {{from: {source}, to: {node.name}.{port}{settings}}}")
    for i, node in enumerate(observed):
        lines.append(f"  - {{from: {node.name}.mixed, to: observations.seen_{i}}}")
    lines.append("allow: [W0104] # many nodes are there to be run, not for what they send")
    return "\n".join(lines) + "\n"


def by_hand_text(nodes):
    """Groups of alike nodes with the places of their sources in a plain array; the action is the last place."""
    groups = {}
    for node in nodes:
        windows = tuple(item.window for item in node.inputs) + (0,) * (2 - len(node.inputs))
        groups.setdefault((node.rate_hz, *windows), []).append(node)
    lines = [
        "// The nodes of graph.yaml without its schedule and rings, made by tests/bench/make_graph.py.",
        "#pragma once",
        "",
        "namespace eagerx::bench {",
        "",
        f"inline constexpr std::size_t kNodes = {len(nodes)};",
        f"inline constexpr int kEnvironmentHz = {ENVIRONMENT_HZ};",
        "",
        "/// calls f.operator()<rate in Hz, window of a, window of b, number of nodes>(sources, place of the first node)",
        "template <class F>",
        "void for_each_group(F&& f) {",
    ]
    place = {}
    for members in groups.values():
        for node in members:
            place[node.number] = len(place)
    place[None] = len(nodes)
    for (rate_hz, a, b), members in sorted(groups.items()):
        sources = ", ".join(
            "{" + ", ".join(str(place[item.source]) for item in node.inputs) + (", 0" if b == 0 else "") + "}"
            for node in members)
        lines += [
            "  {",
            f"    static constexpr Sources kSources[] = {{{sources}}};",
            f"    f.template operator()<{rate_hz}, {a}, {b}, {len(members)}>(kSources, {place[members[0].number]});",
            "  }",
        ]
    return "\n".join(lines + ["}", "", "}  // namespace eagerx::bench", ""])


def write(count, folder, name, rates_hz=RATES_HZ):
    nodes, half = make_nodes(count, rates_hz)
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "graph.yaml").write_text(graph_text(name, nodes, half))
    (folder / "by_hand.hpp").write_text(by_hand_text(nodes))


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    write(int(sys.argv[1]), sys.argv[2], sys.argv[3] if len(sys.argv) == 4 else "many_nodes")
