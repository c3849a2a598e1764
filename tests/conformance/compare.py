"""Compares a run of our program with a recording of EAGERx, tick by tick."""
import math

from doubles import Counters, divides
from recording import flat
from trust import Trust

STAMP_TOLERANCE_S = 1.5e-12  # EAGERx rounds stamps to 12 decimals
FLOAT_TOLERANCE = 1e-5  # of values that are not integers; FORMAT.md suggests it for the pendulum


class Difference(Exception):
    def __init__(self, node, episode, tick, field, expected, got):
        super().__init__(f"node `{node}`, episode {episode}, tick {tick}, {field}\n  expected {short(expected)}\n  got      {short(got)}")


def short(value, most=300):
    text = str(value)
    return text if len(text) <= most else text[:most] + " …"


class Totals:
    def __init__(self):
        self.ticks = self.inputs = self.messages = self.observations = self.simulators = 0
        self.values = 0  # numbers compared
        self.late = 0  # inputs of the engine where EAGERx hands a message over later than ours has it
        self.reset_tail = 0  # ticks of the reset nodes' routine that our program does not execute
        self.processed = 0  # outputs behind a processor
        self.deviating = 0  # inputs at which EAGERx's doubles count otherwise
        self.distrusted = 0  # values behind such inputs and behind processors that EAGERx loses
        self.foreign = 0  # states of objects that only the engine knows
        self.hidden = 0  # states and inputs of objects that our simulators or EAGERx's do not show
        self.late_routines = 0  # routines of reset nodes that begin later in EAGERx
        self.largest = 0.0  # deviation
        self.where = ""
        self.pictures = []
        self.first_deviation = None  # (episode, time, input)

    def add(self, other):
        for name, value in vars(other).items():
            if isinstance(value, int):
                setattr(self, name, getattr(self, name) + value)
        if other.largest > self.largest:
            self.largest, self.where = other.largest, other.where
        self.pictures += [name for name in other.pictures if name not in self.pictures]


class Comparison:
    """Of one episode."""

    def __init__(self, recording, index, episode, lost, totals):
        self.recording, self.index, self.episode, self.totals = recording, index, episode, totals
        self.end = recording.end(index)  # until then nothing may happen that is not recorded
        self.phase_end = recording.phase_end(index)
        self.late = self.phase_end is not None and self.begins_late()
        if self.late:
            totals.late_routines += 1
        elif self.phase_end is not None:
            self.end = self.phase_end
        self.counters = {}
        self.first_seen = {}
        self.trust = Trust(recording, index, lost)
        self.tolerances = {}

    def begins_late(self):
        """A reset node whose feedthrough is delayed still passes it on for a while in EAGERx."""
        for name in self.recording.reset_nodes():
            ours = [tick for tick, item in self.episode.ticks.get(name, {}).items() if item.phase]
            theirs = [record["tick"] for record in self.recording.phase(name, self.index)]
            delayed = any(port.get("delay", 0) for port in self.recording.nodes[name]["feedthroughs"])
            if delayed and ours and theirs and min(ours) < min(theirs):
                return True
        return False

    def run(self):
        self.find_deviations()
        for node in self.recording.nodes:
            if self.recording.is_picture(node):
                self.picture(node)
            else:
                self.node(node)
        self.observations()

    def fail(self, node, tick, field, expected, got):
        raise Difference(node, self.index, tick, field, expected, got)

    def equal(self, node, tick, field, expected, got):
        if expected != got:
            self.fail(node, tick, field, expected, got)

    def picture(self, node):
        readers = [name for name, item in self.recording.nodes.items() if name != "engine"
                   for port in item["inputs"] if port["source"].startswith(node + "/outputs/")]
        if readers or node in self.episode.ticks:
            self.fail(node, 0, "pictures", "nothing reads them", f"read by {readers}")
        if node not in self.totals.pictures:
            self.totals.pictures.append(node)

    def node(self, node):
        records = self.recording.ticks[node][self.index] + self.recording.phase(node, self.index)
        expected = {record["tick"]: record for record in records}
        got = self.episode.ticks.get(node, {})
        for tick, record in expected.items():
            if self.late and record["t_n"] > self.end - STAMP_TOLERANCE_S:
                self.totals.reset_tail += 1
            elif tick in got:
                self.tick(node, tick, record, got[tick])
            elif self.may_be_missing(node, record):
                self.totals.reset_tail += 1
            else:
                self.fail(node, tick, "tick", f"executed at {record['t_n']} s", "not executed")
        for tick in got:
            if self.phase_end is not None and expected and tick > max(expected):
                self.totals.reset_tail += 1  # the last common tick of a routine
            elif tick not in expected and tick / self.recording.nodes[node]["rate"] < self.end - STAMP_TOLERANCE_S:
                self.fail(node, tick, "tick", "not executed", "executed")

    def may_be_missing(self, node, record):
        """In the routine of the reset nodes: our environment sees nothing of it, and how far other nodes get after
        the last callback of a reset node is a matter of chance in EAGERx."""
        if self.phase_end is None:
            return False
        if record.get("phase") == "reset" and node == "environment":
            return True
        slack = STAMP_TOLERANCE_S if self.recording.nodes[node].get("targets") else -STAMP_TOLERANCE_S
        return record["t_n"] > self.phase_end + slack

    def tick(self, node, tick, record, got):
        time = got.time if got.time is not None else tick / self.recording.nodes[node]["rate"]
        if not near(time, record["t_n"]):
            self.fail(node, tick, "t_n", record["t_n"], time)
        if "num_ticks" in record:
            self.equal(node, tick, "num_ticks", record["num_ticks"], self.callbacks(node, tick, got))
        if node == "engine":
            self.engine_inputs(tick, record)
            self.simulators(tick, record)
        else:
            self.inputs(node, tick, record, got)
        self.outputs(node, tick, record, got)
        self.totals.ticks += 1

    def callbacks(self, node, tick, got):
        """Callbacks before this one; a reset node has them in its routine only."""
        if not self.recording.nodes[node].get("targets"):
            return got.callbacks
        return sum(other.phase for number, other in self.episode.ticks[node].items() if number < tick)

    def inputs(self, node, tick, record, got):
        given = given_inputs(record)
        self.equal(node, tick, "inputs", sorted(given), sorted(got.windows))
        for name, expected in given.items():
            port = self.port(node, record, name)
            window, field = got.windows[name], f"input `{name}`"
            rate_in = self.recording.nodes[port["source"].split("/outputs/")[0]]["rate"]
            self.equal(node, tick, f"{field}, rate of the source", expected["rate_in"], rate_in)
            self.totals.inputs += 1
            if self.trust.deviates(node, tick, name):
                self.totals.deviating += 1
                continue
            handed = self.handed(node, tick, name, expected, window)
            self.equal(node, tick, f"{field}, number of messages", len(expected["seq"]), len(window.seq))
            self.equal(node, tick, f"{field}, seq", expected["seq"], window.seq)
            self.stamps(node, tick, f"{field}, sent at", expected["sc"], window.sent)
            self.equal(node, tick, f"{field}, handed over at tick", expected["t_node_seq"], handed)
            self.stamps(node, tick, f"{field}, handed over at", expected["t_node_sc"],
                        [n / self.recording.nodes[node]["rate"] for n in handed])
            if self.trust.input(node, tick, name):
                self.values(node, tick, f"{field}, values", expected["msgs"], window.values, port["source"])
            else:
                self.totals.distrusted += len(window.values)
            self.totals.messages += len(window.seq)

    def port(self, node, record, name):
        ports = self.recording.nodes[node]["feedthroughs" if record.get("feedthrough") else "inputs"]
        return next(port for port in ports if port["name"] == name)

    def handed(self, node, tick, name, expected, window):
        """The tick that first had each message."""
        before = dict(zip(expected["seq"], expected["t_node_seq"]))
        return [self.first_seen.setdefault((node, name, seq), self.first(node, tick, before.get(seq, tick))) for seq in window.seq]

    def find_deviations(self):
        """Inputs at which EAGERx has other messages than we have because it counts in doubles."""
        for node in self.recording.nodes:
            rate = self.recording.nodes[node]["rate"]
            differing = set()  # inputs that had other messages before
            for record in self.recording.ticks[node][self.index] if node != "engine" else ():
                got = self.episode.ticks.get(node, {}).get(record["tick"])
                for name, expected in record["inputs"].items() if got is not None else ():
                    window = got.windows.get(name)
                    if window is None or window.seq == expected["seq"] and name not in differing:
                        continue
                    if name not in differing:
                        differing.add(name)
                        self.see_all_before(node, record["tick"], name)
                    pairs = list(zip(window.seq, self.handed(node, record["tick"], name, expected, window)))
                    theirs = list(zip(expected["seq"], expected["t_node_seq"]))
                    port = self.port(node, record, name)
                    if pairs != theirs and self.explained(node, name, port, expected["rate_in"], rate, record["tick"], theirs, pairs):
                        self.deviation(node, record, name)
        self.engine_deviations()
        self.trust.spread()

    def see_all_before(self, node, tick, name):
        for record in self.recording.ticks[node][self.index]:
            got = self.episode.ticks[node].get(record["tick"])
            if record["tick"] < tick and got is not None and name in got.windows:
                self.handed(node, record["tick"], name, record["inputs"][name], got.windows[name])

    def engine_deviations(self):
        rate = self.recording.nodes["engine"]["rate"]
        ports = [port for port in self.recording.nodes["engine"]["inputs"] if divides(self.rate_of(port["source"]), rate)]
        for record in self.recording.ticks["engine"][self.index]:
            sent = {}
            for node, output, seq, _ in self.episode.before_engine.get(record["tick"], []):
                sent.setdefault(f"{node}/outputs/{output}", []).append(seq)
            for port in ports:
                expected, got = record["inputs"][port["name"]]["seq"], sent.get(port["source"], [])
                theirs, ours = [[(seq, record["tick"]) for seq in seqs] for seqs in (expected, got)]
                if expected != got and self.explained("engine", port["name"], port, self.rate_of(port["source"]), rate, record["tick"], theirs, ours):
                    self.deviation("engine", record, port["name"], port["source"])

    def rate_of(self, source):
        return self.recording.nodes[source.split("/outputs/")[0]]["rate"]

    def explained(self, node, name, port, rate_in, rate, tick, theirs, ours):
        key = (node, name)
        if key not in self.counters:
            self.counters[key] = Counters(rate_in, rate, port)
        return self.counters[key].explain(tick, theirs, ours)

    def deviation(self, node, record, name, source=None):
        self.trust.deviation(node, record["tick"], name, record["t_n"], source)
        first = self.totals.first_deviation
        if first is None or (self.index, record["t_n"]) < first[:2]:
            self.totals.first_deviation = (self.index, record["t_n"], f"{node}/{name}")

    def first(self, node, tick, recorded):
        """The tick that first sees a message. Our program shows a reset node's inputs in its routine only: what came
        before is as recorded."""
        before = self.episode.ticks[node].get(recorded)
        hidden = self.recording.nodes[node].get("targets") and before is not None and not before.phase and self.episode.ticks[node][tick].phase
        return recorded if hidden else tick

    def engine_inputs(self, tick, record):
        """EAGERx holds the engine back with inputs from its engine nodes. Ours is ordered by its schedule: what is
        compared is what was sent between two of its ticks."""
        engine_rate = self.recording.nodes["engine"]["rate"]
        sent = {}
        for node, output, seq, values in self.episode.before_engine.get(tick, []):
            sent.setdefault(f"{node}/outputs/{output}", []).append((seq, values))
        for port in self.recording.nodes["engine"]["inputs"]:
            source = port["source"].split("/outputs/")[0]
            if self.recording.is_picture(source):
                continue
            expected, field = record["inputs"][port["name"]], f"input `{port['name']}`"
            got = sent.get(port["source"], [])
            rate = self.recording.nodes[source]["rate"]
            if not divides(rate, engine_rate) or self.trust.deviates("engine", tick, port["name"]):
                got = self.not_before(tick, port["source"], source, field, expected)
            self.equal("engine", tick, f"{field}, seq", expected["seq"], [seq for seq, _ in got])
            self.stamps("engine", tick, f"{field}, sent at", expected["sc"], [seq / rate for seq, _ in got])
            self.equal("engine", tick, f"{field}, handed over at tick", expected["t_node_seq"], [tick] * len(got))
            values = [value for _, values in got for value in values]
            if all(self.trust.node(source, time) for time in expected["sc"]):
                self.values("engine", tick, f"{field}, values", expected["msgs"], values, source)
            else:
                self.totals.distrusted += len(values)
            self.totals.inputs += 1
            self.totals.messages += len(got)

    def not_before(self, tick, address, source, field, expected):
        """Where no rate divides the other EAGERx hands over late (SEMANTICS §9): ours must have been sent by then."""
        output = address.split("/outputs/")[1]
        rate, engine_rate = self.recording.nodes[source]["rate"], self.recording.nodes["engine"]["rate"]
        messages = []
        for seq in expected["seq"]:
            tick_sent = self.episode.ticks.get(source, {}).get(seq)
            if tick_sent is None or seq / rate > tick / engine_rate - STAMP_TOLERANCE_S:
                self.fail("engine", tick, f"{field}, seq {seq}", "sent before", "not sent")
            messages.append((seq, tick_sent.sent[output]))
        self.totals.late += 1
        return messages

    def simulators(self, tick, record):
        for thing, expected in record.get("sim", {}).items():
            if thing not in self.recording.objects():
                self.totals.foreign += 1
                continue
            if not self.trust.object(thing, record["t_n"]):
                self.totals.distrusted += 1
                continue
            got = self.episode.simulators.get((thing, tick))
            if got is None:
                self.fail("engine", tick, f"object `{thing}`", expected, "nothing")
            for part, value in expected.items():
                if not got.get(part) or None in (flat(value) or [None]):
                    self.totals.hidden += 1
                    continue
                self.values("engine", tick, f"{part} of `{thing}`", value, got.get(part, []))
            self.totals.simulators += 1

    def outputs(self, node, tick, record, got):
        processed = {port["name"] for port in self.recording.nodes[node]["outputs"] if port["processor"]}
        after_last_action = node == "environment" and tick >= len(self.recording.episodes[self.index]["steps"])
        for name, value in (record["out"] or {}).items():
            if name.endswith("/done") or value is None and after_last_action:
                continue
            if name not in got.sent:
                self.fail(node, tick, f"output `{name}`", value, "nothing")
            if name in processed:  # recorded before the processor; its receivers' messages are behind it
                self.totals.processed += 1
            elif self.trust.node(node, record["t_n"]):
                self.values(node, tick, f"output `{name}`", value, got.sent[name], node)
            else:
                self.totals.distrusted += len(got.sent[name])

    def observations(self):
        episode = self.recording.episodes[self.index]
        expected = [episode["reset_obs"]] + [step["obs"] for step in episode["steps"]]
        for tick, observation in enumerate(expected):
            got = self.episode.observations[tick]
            self.equal("environment", tick, "observations", sorted(observation), sorted(got))
            for name, value in observation.items():
                if not self.trust.input("environment", tick, name):
                    self.totals.distrusted += len(got[name])
                    continue
                self.values("environment", tick, f"observation `{name}`", value, got[name], self.recording.source("environment", name), missing_is_zero=True)
                self.totals.observations += 1

    def stamps(self, node, tick, field, expected, got):
        if len(expected) != len(got) or not all(near(a, b) for a, b in zip(got, expected)):
            self.fail(node, tick, field, expected, got)

    def tolerance_of(self, source):
        """Of what a node sends. One that takes differences of its inputs amplifies what they differ by."""
        node = source.split("/outputs/")[0]
        if node not in self.tolerances:
            amplifies = "/" not in node and node != "environment"
            self.tolerances[node] = FLOAT_TOLERANCE + (2 * self.recording.nodes[node]["rate"] * self.largest_difference(node) if amplifies else 0)
        return self.tolerances[node]

    def largest_difference(self, node):
        """Of the inputs of a node in this episode, at most the tolerance."""
        largest = 0.0
        for record in self.recording.ticks[node][self.index]:
            windows = self.episode.ticks.get(node, {}).get(record["tick"])
            for name, expected in given_inputs(record).items() if windows is not None else ():
                for a, b in zip(flat(expected["msgs"]) or [], windows.windows[name].values if name in windows.windows else []):
                    if isinstance(a, float) and not math.isnan(a):
                        largest = max(largest, abs(a - b))
        return min(largest, FLOAT_TOLERANCE)

    def values(self, node, tick, field, expected, got, source=None, missing_is_zero=False):
        numbers = flat(expected)
        if numbers is None:
            self.fail(node, tick, field, expected, got)
        if len(numbers) != len(got):
            self.fail(node, tick, field, expected, got)
        if not self.recording.exact:
            return
        for place, (a, b) in enumerate(zip(numbers, got)):
            if isinstance(a, float) and math.isnan(a):  # EAGERx's NaN of a missing observation is zero
                if not (b == 0 if missing_is_zero else math.isnan(b)):
                    self.fail(node, tick, field, expected, got)
                continue
            deviation = abs(a - b)
            if not deviation <= (FLOAT_TOLERANCE if isinstance(a, float) else 0) and not (
                    source and isinstance(a, float) and deviation <= self.tolerance_of(source)):
                self.fail(node, tick, f"{field}, element {place}", expected, got)
            if deviation > self.totals.largest:
                self.totals.largest = deviation
                self.totals.where = f"{self.recording.name}, node `{node}`, episode {self.index}, tick {tick}, {field}"
        self.totals.values += len(numbers)


def given_inputs(record):
    return {name: item for name, item in record["inputs"].items() if not item.get("target")}


def near(a, b):
    return abs(a - b) <= STAMP_TOLERANCE_S


def compare(recording, episodes, lost=()):
    """Totals; raises Difference at the first one. `episodes` begin with the initialisation, which EAGERx does not
    record either."""
    totals = Totals()
    same_names(recording, episodes)
    for index, episode in enumerate(episodes[1:len(recording.episodes) + 1]):
        Comparison(recording, index, episode, lost, totals).run()
    return totals


def same_names(recording, episodes):
    """Gives our engine nodes the names of the recorded ones that are called differently and send and take the same."""
    def ports(node):
        record = recording.ticks[node][0][0] if recording.ticks[node] and recording.ticks[node][0] else {"inputs": {}, "out": {}}
        return node.split("/")[0], sorted(record["inputs"].keys() - {"tick"}), sorted(record["out"] or {})

    def our_ports(node):
        tick = next(episode.ticks[node] for episode in episodes if node in episode.ticks).get(0)
        return (node.split("/")[0], sorted(tick.windows.keys() - {"tick"}), sorted(tick.sent)) if tick else None

    ours = {node for episode in episodes for node in episode.ticks}
    for node in [name for name in recording.nodes if "/" in name and name not in ours and not recording.is_picture(name)]:
        same = [other for other in ours - set(recording.nodes) if our_ports(other) == ports(node)]
        if len(same) == 1:
            for episode in episodes:
                episode.rename(same[0], node)
