"""Pages of eagerx-gen report, and graphs and traces to make them of. Used by tests/report and tests/browser."""
import json
import os
import pathlib
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
MULTI_RATE = ROOT / "tests/golden/multi_rate/graph.yaml"
SWING_UP = ROOT / "examples/pendulum_swing_up/graph.yaml"
DATA = re.compile(r'<script type="application/json" id="data">(.*?)</script>', re.S)


class Generator:
    def __init__(self, build):
        self.program = pathlib.Path(build).resolve() / "eagerx-gen"

    def __call__(self, *words, folder=None):
        environment = dict(os.environ, EAGERX_HOME=str(ROOT))
        return subprocess.run([self.program, *map(str, words)], capture_output=True, text=True, env=environment, cwd=folder)

    def page(self, graph, output, *options):
        """The text of the page and what is in its block of data."""
        done = self("report", graph, "-o", output, *options)
        assert done.returncode == 0, f"{graph}: {done.stdout}{done.stderr}"
        text = output.read_text()
        return text, json.loads(DATA.search(text).group(1))


def thousand():
    """A graph of 1,000 nodes at three rates, each of which reads a near one; one is on a way that ends."""
    rates = (10, 20, 5)
    lines = ["name: thousand", "rate: 10", "allow: [W0104]", "nodes:"]
    for n in range(1000):
        lines.append(f"  n{n}: {{type: Gain, rate: {rates[n % 3]}, config: {{gain: [1.0]}}, "
                     "inputs: {signal: {space: {dtype: float32, shape: [1]}}}}")
    lines += ["actions: {u: {space: {dtype: float32, shape: [1], low: -1, high: 1}}}", "observations: [y]", "connections:",
              "  - {from: actions.u, to: n0.signal}"]
    lines += [f"  - {{from: n{max(0, n - 1 - (n * 7919) % 12)}.y, to: n{n}.signal}}" for n in range(1, 1000)]
    return "\n".join([*lines, "  - {from: n999.y, to: observations.y, skip: true}", ""])


def trace(page, messages, value, episodes=1, late_s=None):
    """The text of a trace of the graph of this page. `value(channel, episode, seq, element)`; the fastest channel
    has `messages` in each episode. With `late_s(channel, episode, seq)` it has time stamps."""
    info = page["info"]
    sizes = []
    lines = ["# eagerx trace 1", f"# graph {info['name']}", f"# engine {info['engine']}", "# rate 30/1", "# seed 1",
             "# environment 0", "# agent policy"]
    for channel in page["channels"]:
        node = page["nodes"][channel["node"]]
        space = node["outputs"][channel["output"]]["space"]
        dtype, shape = re.fullmatch(r"(\w+) \[([\d, ]*)\]", space["text"]).groups()
        size = 1
        for length in filter(None, shape.split(", ")):
            size *= int(length)
        rate = node["rate"] if "/" in node["rate"] else node["rate"] + "/1"
        lines.append(f"# channel {channel['name']} {dtype} {size} {rate}")
        sizes.append((channel["name"], dtype, size, eval_rate(rate)))
    lines.append("episode,channel,seq,time_ns,values" if late_s else "episode,channel,seq,values")
    fastest = max(rate for *_, rate in sizes)
    for episode in range(episodes):
        rows = []
        for name, dtype, size, rate in sizes:
            for seq in range(int(messages * rate / fastest)):
                stamp = ""
                if late_s:
                    begin = episode * messages / fastest
                    stamp = f"{round((begin + seq / rate + late_s(name, episode, seq)) * 1e9)},"
                numbers = (value(name, episode, seq, element) for element in range(size))
                texts = (str(int(number)) if "int" in dtype else repr(number) for number in numbers)
                rows.append((seq / rate, f"{episode},{name},{seq},{stamp}{','.join(texts)}"))
        rows.sort(key=lambda row: row[0])
        lines += [text for _, text in rows]
    return "\n".join(lines) + "\n"


def scenes(ticks, row, rate="30/1", episodes=1):
    """Lines with scenes, as --trace-scenes writes them. `row(episode, tick)`: the numbers of one."""
    lines, before = [f"# scenes {rate}"], []
    for episode in range(episodes):
        for tick in range(ticks):
            numbers = row(episode, tick)
            before += [0.0] * (len(numbers) - len(before))
            changed = [f"{i}={number!r}" for i, number in enumerate(numbers) if number != before[i]]
            before = list(numbers)
            lines.append(f"# scene {episode} {tick} {len(numbers) // 16}" + (f" {','.join(changed)}" if changed else ""))
    return "\n".join(lines) + "\n"


def eval_rate(rate):
    above, below = rate.split("/")
    return float(above) / float(below)
