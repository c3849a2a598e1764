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
        self.phases = content.get("reset_trace", {})  # after each episode: the routine of the reset nodes
        self.has_reset_nodes = any(node.get("targets") for node in self.nodes.values())
        self.exact = content.get("values_exact", True)
        self.rate = content["env_rate"]
        self.pictures = {}  # node → whether it sends pictures

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
        if name not in self.pictures:
            self.pictures[name] = any(flat(value) is None for ticks in self.ticks[name] for tick in ticks
                                      for value in (tick["out"] or {}).values())
        return self.pictures[name]

    def end(self, episode):
        """Time of the environment's last tick."""
        return len(self.episodes[episode]["steps"]) / self.rate

    def states(self, episode):
        """The states that are set, by their address. After the last episode: what the reset nodes were asked for."""
        if episode < len(self.episodes):
            return dict(self.episodes[episode]["states"]) | self.stale_states(episode)
        states = {}
        for name, node in self.nodes.items():
            for target in node.get("targets", []):
                for tick in self.phase(name, episode - 1)[:1]:
                    states[target["source"].replace("/states/", "/")] = tick["inputs"][target["name"]]["msgs"][0]
        return states

    def stale_states(self, episode):
        """In EAGERx a node may get the state of the reset before; its program continues with what it got."""
        if episode == 0:
            return {}
        asked, before = self.episodes[episode]["states"], self.episodes[episode - 1]["states"]
        stale = {}
        for event, name, states in self.episodes[episode].get("reset_events_unordered", []):
            for state, value in states.items() if event == "node.reset" else ():
                address = f"{name}/{state}"
                if value is not None and address in asked and value != asked[address] and value == before.get(address):
                    stale[address] = value
        return stale

    def phase(self, node, episode):
        """Ticks of the routine of the reset nodes after an episode."""
        phases = self.phases.get(node, [])
        return phases[episode] if episode < len(phases) else []

    def phase_end(self, episode):
        """Time at which all targets of all reset nodes are reached after an episode, from where on it is a matter of
        chance how far EAGERx gets; None without a routine."""
        flags, now = [], {}
        for name in self.reset_nodes():
            for tick in self.phase(name, episode):
                for target in self.nodes[name]["targets"]:
                    done = (tick["out"] or {}).get(f"{target['name']}/done")
                    flags.append((tick["t_n"], f"{name}/{target['name']}", bool(done)))
                    now[f"{name}/{target['name']}"] = False
        flags.sort()
        for place, (time, target, done) in enumerate(flags):
            now[target] = done
            if all(now.values()) and (place + 1 == len(flags) or flags[place + 1][0] > time):
                return time
        return flags[-1][0] if flags else None

    def reset_nodes(self):
        return [name for name, node in self.nodes.items() if node.get("targets")]

    def all_states(self):
        """Addresses of the states that a reset may set."""
        return [state for node in self.content["nodes"].values() if "rate" not in node for state in node.get("states", [])]

    def objects(self):
        """Objects of the graph: the engine may know more."""
        return {name.split("/")[0] for name in [*self.nodes, *self.all_states()] if "/" in name}

    def source(self, node, name):
        return next(port["source"] for port in self.nodes[node]["inputs"] if port["name"] == name)

    def asks_reset_nodes(self, episode):
        targets = {target["source"].replace("/states/", "/") for node in self.nodes.values() for target in node.get("targets", [])}
        return bool(targets & set(self.states(episode)))

    def begins_in(self, episode):
        """States of objects that no reset sets, or not all: where the routine, or the episode before, happened to
        end. Objects that only the engine knows are not ours."""
        asked = set(self.states(episode))
        open_states = {state.split("/")[0] for state in self.all_states() if state.count("/") == 1 and state not in asked}
        chosen = {address.split("/")[0] for address in asked} - open_states
        return {thing: flat(sim["state"]) for thing, sim in self.ticks["engine"][episode][0].get("sim", {}).items()
                if thing in self.objects() and None not in (flat(sim.get("state")) or [None]) and (self.has_reset_nodes or thing not in chosen)}

    def script(self):
        """Writes the input of tests/conformance/driver.hpp. EAGERx resets twice before the first episode; programs do that
        themselves where reset nodes are at work. After the last step of an episode more steps, with actions zero, reach what other
        nodes had already executed; the routine of the reset nodes reaches it too."""
        lines = []
        for index, episode in enumerate(self.episodes):
            for _ in range(2 if index == 0 and not self.asks_reset_nodes(index) else 1):
                lines += [words("state", name, flat(value)) for name, value in self.states(index).items()]
                lines += [words("object", name, values) for name, values in self.begins_in(index).items()]
                lines.append("reset")
            for step in episode["steps"]:
                lines += [words("action", name, flat(value)) for name, value in step["action"].items()]
                lines.append("step")
            if self.phase_end(index) is None:
                lines += self.more_steps(index)
        if self.phase_end(len(self.episodes) - 1) is not None:
            lines += [words("state", name, flat(value)) for name, value in self.states(len(self.episodes)).items()]
            lines.append("reset")
        return "\n".join(lines) + "\n"

    def more_steps(self, index):
        lines = [words("action", output["name"], [0] * math.prod(output["shape"])) for output in self.nodes["environment"]["outputs"]]
        last = max(ticks[index][-1]["t_n"] for ticks in self.ticks.values() if ticks[index])
        return lines + ["step"] * (1 + math.ceil((last - self.end(index)) * self.rate))


def words(*parts):
    items = []
    for part in parts:
        items += [repr(int(value) if isinstance(value, bool) else value) for value in part] if isinstance(part, list) else [part]
    return " ".join(items)
