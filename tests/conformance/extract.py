#!/usr/bin/env python3
"""Makes a recording for this folder's programs out of a trace of EAGERx.

  extract.py TRACE.json.xz OUTPUT.csv [--without NODE]... [--tolerance NODE.OUTPUT=VALUES]...

--without leaves a node out that our graph does not have. --tolerance (one value, or one for each element,
with commas) holds for an output and for every input that it is connected to. The engine's inputs are left out: they are EAGERx's way to keep the engine behind its
engine nodes, ours is the schedule. The format of OUTPUT.csv is described in README.md.
"""
import argparse
import json
import lzma


def flat(value):
    if isinstance(value, list):
        return [item for part in value for item in flat(part)]
    return [value]


def cell(value):
    if isinstance(value, bool):
        return str(int(value))
    if isinstance(value, float):
        return repr(int(value)) if value == int(value) else repr(value)
    return str(value)


def line(*cells):
    return ",".join(cell(item) for item in flat(list(cells)))


def tolerance_lines(nodes, without, tolerances):
    for port, value in tolerances.items():
        node, output = port.split(".")
        yield f"tolerance,{port},{value}"
        for reader, description in nodes.items():
            if reader == "engine" or reader in without:
                continue
            for item in description.get("inputs", []):
                if item["source"] == f"{node}/outputs/{output}":
                    yield f"tolerance,{reader}.{item['name']},{value}"


def tick_lines(node, tick):
    yield line("tick", node, tick["tick"], tick["t_n"])
    if node != "engine":
        for name, window in tick["inputs"].items():
            yield line("in", name, len(window["seq"]), window["seq"], window["sc"], window["msgs"])
    for name, value in (tick.get("out") or {}).items():
        if value is not None:
            yield line("out", name, value)


def lines(trace, without, tolerances):
    yield f"# {trace['name']}: {trace['doc'].strip()}" if trace.get("doc") else f"# {trace['name']}"
    yield "# Made by tests/conformance/extract.py from a run of EAGERx 0.1.40; the format is in README.md."
    if without:
        yield f"# Without {', '.join(without)}."
    yield from tolerance_lines(trace["nodes"], without, tolerances)
    for index, episode in enumerate(trace["env_trace"]):
        yield "episode"
        for name, value in episode["states"].items():
            yield line("state", name.replace("/", "_"), value)
        observations = [episode["reset_obs"]] + [step["obs"] for step in episode["steps"]]
        for node, ticks in trace["node_trace"].items():
            if node in without:
                continue
            for tick in ticks[index]:
                yield from tick_lines(node, tick)
                if node != "environment":
                    continue
                for name, value in observations[tick["tick"]].items():
                    yield line("obs", name, value)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("trace")
    parser.add_argument("output")
    parser.add_argument("--without", action="append", default=[])
    parser.add_argument("--tolerance", action="append", default=[])
    arguments = parser.parse_args()
    with lzma.open(arguments.trace) as file:
        trace = json.load(file)
    tolerances = dict(item.split("=") for item in arguments.tolerance)
    with open(arguments.output, "w") as file:
        file.write("\n".join(lines(trace, arguments.without, tolerances)) + "\n")


if __name__ == "__main__":
    main()
