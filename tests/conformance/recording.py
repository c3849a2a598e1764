"""A recording of EAGERx (NAME.json.xz) and the script that makes our program repeat it."""
import json
import lzma
import math
import re


def flat(value):
    """All numbers of a message or of a list of messages in order; NaN for "nan"; None for a picture."""
    if isinstance(value, dict):
        return None
    if not isinstance(value, list):
        return [math.nan if value == "nan" else value]
    numbers = []
    for item in value:
        part = flat(item)
        if part is None:
            return None
        numbers += part
    return numbers


class Recording:
    """`content`: what the JSON file holds; see README.md for the parts that are used."""

    def __init__(self, content):
        self.content = content
        self.name = content["name"]
        self.rejected = content.get("error", "refused") if content.get("rejected") else None
        self.nodes = {name: node for name, node in content.get("nodes", {}).items() if "rate" in node}
        self.episodes = content.get("env_trace", [])
        self.ticks = content.get("node_trace", {})
        self.exact = content.get("values_exact", True)
        self.rate = content["env_rate"]

    @staticmethod
    def load(path):
        with lzma.open(path, "rt") as file:
            return Recording(json.load(file))

    def loops(self):
        """The nodes of each cycle that EAGERx names."""
        loops = []
        for part in re.split(r"Loop \d+:", self.rejected or "")[1:]:
            loops.append(sorted(set(re.findall(r"\[([^\[\]]+?)/(?:inputs|outputs|sensors|actuators)/", part))))
        return loops

    def drops_callbacks(self):
        """A node whose first callbacks EAGERx drops for an empty input, after which its next reset hangs."""
        for name, episodes in self.ticks.items():
            if any(tick.get("skipped") for ticks in episodes for tick in ticks):
                return name
        return None

    def is_picture(self, name):
        """Nodes that send pictures: recorded as checksums, and our objects have none."""
        return any(flat(value) is None for ticks in self.ticks[name] for tick in ticks for value in (tick["out"] or {}).values())

    def end(self, episode):
        """Time of the environment's last tick."""
        return len(self.episodes[episode]["steps"]) / self.rate

    def states(self, episode):
        """The states that are set, by their address."""
        return dict(self.episodes[episode]["states"])

    def script(self):
        """What tests/conformance/driver.hpp reads. EAGERx resets twice before the first episode. After the last
        step of an episode more steps, with actions zero, reach what other nodes had already executed."""
        lines = []
        for index, episode in enumerate(self.episodes):
            for _ in range(2 if index == 0 else 1):
                for name, value in self.states(index).items():
                    lines.append(words("state", name, flat(value)))
                lines.append("reset")
            for step in episode["steps"]:
                for name, value in step["action"].items():
                    lines.append(words("action", name, flat(value)))
                lines.append("step")
            for output in self.nodes["environment"]["outputs"]:
                lines.append(words("action", output["name"], [0] * math.prod(output["shape"])))
            last = max(ticks[index][-1]["t_n"] for ticks in self.ticks.values() if ticks[index])
            lines += ["step"] * (1 + math.ceil((last - self.end(index)) * self.rate))
        return "\n".join(lines) + "\n"


def words(*parts):
    items = []
    for part in parts:
        items += [repr(value) for value in part] if isinstance(part, list) else [part]
    return " ".join(items)
