"""Which values of an episode a recording can judge: not those behind an input that had other messages in EAGERx,
because it counts in doubles, nor those behind a processor that EAGERx loses."""
import math


class Trust:
    """Messages of a node count until a time; a node hands on what it gets, the environment does not."""

    def __init__(self, recording, index, lost):
        self.recording, self.index = recording, index
        self.inputs = set()  # (node, tick, input) with other messages
        self.lost = set(lost)  # (node, input) with another processor
        self.nodes = {}  # node → time from which on what it sends is not to be judged
        self.objects = {}  # the same of objects

    def deviation(self, node, tick, name, time, source):
        self.inputs.add((node, tick, name))
        if node != "engine":
            self.distrust(self.nodes, node, time)
        elif source is not None:  # what an actuator sets may act an engine's tick later
            self.distrust(self.objects, source.split("/")[0], time)

    @staticmethod
    def distrust(times, name, time):
        changed = time < times.get(name, math.inf)
        if changed:
            times[name] = time
        return changed

    def deviates(self, node, tick, name):
        return (node, tick, name) in self.inputs

    def node(self, name, time):
        return name == "environment" or time < self.nodes.get(name.split("/outputs/")[0], math.inf) - 1e-9

    def object(self, name, time):
        return time < self.objects.get(name, math.inf) - 1e-9

    def input(self, node, tick, name):
        """Whether the values of an input are to be judged."""
        if self.deviates(node, tick, name) or (node, name) in self.lost:
            return False
        if not self.inputs and not self.lost:
            return True
        record = self.record(node, tick)
        item = record["inputs"].get(name) if record else None
        return item is None or self.is_good(node, name, item)

    def record(self, node, tick):
        ticks = self.recording.ticks[node][self.index]
        if tick < len(ticks) and ticks[tick]["tick"] == tick:
            return ticks[tick]
        return next((record for record in ticks if record["tick"] == tick), None)

    def is_good(self, node, name, item):
        ports = self.recording.nodes[node]["inputs"] + self.recording.nodes[node].get("feedthroughs", [])
        source = next((port["source"] for port in ports if port["name"] == name), None)
        return source is None or all(self.node(source, time) for time in item["sc"])

    def spread(self):
        """From input to output, from engine node to object and back, until nothing changes."""
        if not self.inputs and not self.lost:
            return
        while any([self.spread_at(node, record) for node in self.recording.nodes if node not in ("environment", "engine")
                   for record in self.recording.ticks[node][self.index]]):
            pass

    def spread_at(self, node, record):
        owner, time = node.split("/")[0] if "/" in node else None, record["t_n"]
        changed = False
        reads_object = "tick" in record["inputs"] and owner is not None and not self.object(owner, time)
        if reads_object or any((node, name) in self.lost or not self.is_good(node, name, item)
                               for name, item in record["inputs"].items() if not item.get("target")):
            changed = self.distrust(self.nodes, node, time)
        if owner is not None and not self.node(node, time):
            changed = self.distrust(self.objects, owner, time) or changed
        return changed
