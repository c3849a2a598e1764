"""Compares a run of our program with a recording of EAGERx, tick by tick."""
import math
from fractions import Fraction

from recording import flat

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
        self.largest = 0.0  # deviation
        self.where = ""
        self.pictures = []

    def add(self, other):
        for name, value in vars(other).items():
            if isinstance(value, int):
                setattr(self, name, getattr(self, name) + value)
        if other.largest > self.largest:
            self.largest, self.where = other.largest, other.where
        self.pictures += [name for name in other.pictures if name not in self.pictures]


class Comparison:
    """Of one episode."""

    def __init__(self, recording, index, episode, totals):
        self.recording, self.index, self.episode, self.totals = recording, index, episode, totals
        self.end = recording.end(index)  # until then nothing may happen that is not recorded
        self.phase_end = recording.phase_end(index)
        if self.phase_end is not None:
            self.end = self.phase_end

    def run(self):
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
            self.fail(node, 0, "pictures", "nobody reads them", f"read by {readers}")
        if node not in self.totals.pictures:
            self.totals.pictures.append(node)

    def node(self, node):
        records = self.recording.ticks[node][self.index] + self.recording.phase(node, self.index)
        expected = {record["tick"]: record for record in records}
        got = self.episode.ticks.get(node, {})
        first_seen = {}
        for tick, record in expected.items():
            if tick in got:
                self.tick(node, tick, record, got[tick], first_seen)
            elif self.may_be_missing(node, record):
                self.totals.reset_tail += 1
            else:
                self.fail(node, tick, "tick", f"executed at {record['t_n']} s", "not executed")
        for tick in got:
            if tick not in expected and tick / self.recording.nodes[node]["rate"] < self.end - STAMP_TOLERANCE_S:
                self.fail(node, tick, "tick", "not executed", "executed")

    def may_be_missing(self, node, record):
        """In the routine of the reset nodes: our environment sees nothing of it, and how far other nodes get after
        the last callback of a reset node is a matter of chance in EAGERx."""
        if self.phase_end is None:
            return False
        if record.get("phase") == "reset" and node == "environment":
            return True
        return record["t_n"] > self.phase_end - STAMP_TOLERANCE_S and not self.recording.nodes[node].get("targets")

    def tick(self, node, tick, record, got, first_seen):
        time = got.time if got.time is not None else tick / self.recording.nodes[node]["rate"]
        if not near(time, record["t_n"]):
            self.fail(node, tick, "t_n", record["t_n"], time)
        if "num_ticks" in record:
            self.equal(node, tick, "num_ticks", record["num_ticks"], self.callbacks(node, tick, got))
        if node == "engine":
            self.engine_inputs(tick, record)
            self.simulators(tick, record)
        else:
            self.inputs(node, tick, record, got, first_seen)
        self.outputs(node, tick, record, got)
        self.totals.ticks += 1

    def callbacks(self, node, tick, got):
        """Callbacks before this one; a reset node has them in its routine only."""
        if not self.recording.nodes[node].get("targets"):
            return got.callbacks
        return sum(other.phase for number, other in self.episode.ticks[node].items() if number < tick)

    def inputs(self, node, tick, record, got, first_seen):
        given = {name: item for name, item in record["inputs"].items() if not item.get("target")}
        self.equal(node, tick, "inputs", sorted(given), sorted(got.windows))
        ports = {port["name"]: port for port in self.recording.nodes[node]["inputs"]}
        if bool(record.get("feedthrough")):
            ports = {port["name"]: port for port in self.recording.nodes[node]["feedthroughs"]}
        for name, expected in given.items():
            window, field = got.windows[name], f"input `{name}`"
            rate_in = self.recording.nodes[ports[name]["source"].split("/outputs/")[0]]["rate"]
            self.equal(node, tick, f"{field}, rate of the source", expected["rate_in"], rate_in)
            self.equal(node, tick, f"{field}, number of messages", len(expected["seq"]), len(window.seq))
            self.equal(node, tick, f"{field}, seq", expected["seq"], window.seq)
            self.stamps(node, tick, f"{field}, sent at", expected["sc"], window.sent)
            handed = [first_seen.setdefault((name, seq), self.first(node, tick, before)) for seq, before in zip(window.seq, expected["t_node_seq"])]
            self.equal(node, tick, f"{field}, handed over at tick", expected["t_node_seq"], handed)
            self.stamps(node, tick, f"{field}, handed over at", expected["t_node_sc"],
                        [n / self.recording.nodes[node]["rate"] for n in handed])
            self.values(node, tick, f"{field}, values", expected["msgs"], window.values)
            self.totals.inputs += 1
            self.totals.messages += len(window.seq)

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
            if not divides(rate, engine_rate):
                got = self.not_before(tick, port["source"], source, field, expected)
            self.equal("engine", tick, f"{field}, seq", expected["seq"], [seq for seq, _ in got])
            self.stamps("engine", tick, f"{field}, sent at", expected["sc"], [seq / rate for seq, _ in got])
            self.equal("engine", tick, f"{field}, handed over at tick", expected["t_node_seq"], [tick] * len(got))
            self.values("engine", tick, f"{field}, values", expected["msgs"], [value for _, values in got for value in values])
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
            got = self.episode.simulators.get((thing, tick), {})
            for part, value in expected.items():
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
            else:
                self.values(node, tick, f"output `{name}`", value, got.sent[name])

    def observations(self):
        episode = self.recording.episodes[self.index]
        expected = [episode["reset_obs"]] + [step["obs"] for step in episode["steps"]]
        for tick, observation in enumerate(expected):
            got = self.episode.observations[tick]
            self.equal("environment", tick, "observations", sorted(observation), sorted(got))
            for name, value in observation.items():
                self.values("environment", tick, f"observation `{name}`", value, got[name], missing_is_zero=True)
                self.totals.observations += 1

    def stamps(self, node, tick, field, expected, got):
        if len(expected) != len(got) or not all(near(a, b) for a, b in zip(got, expected)):
            self.fail(node, tick, field, expected, got)

    def values(self, node, tick, field, expected, got, missing_is_zero=False):
        numbers = flat(expected)
        if numbers is None:
            self.fail(node, tick, field, expected, got)
        if len(numbers) != len(got):
            self.fail(node, tick, field, expected, got)
        if not self.recording.exact:
            return
        for place, (a, b) in enumerate(zip(numbers, got)):
            if isinstance(a, float) and math.isnan(a):  # integers have no NaN: a missing observation is zero
                if not (math.isnan(b) or (missing_is_zero and isinstance(b, int) and b == 0)):
                    self.fail(node, tick, field, expected, got)
                continue
            deviation = abs(a - b)
            tolerance = FLOAT_TOLERANCE if isinstance(a, float) else 0
            if not deviation <= tolerance:
                self.fail(node, tick, f"{field}, element {place}", expected, got)
            if deviation > self.totals.largest:
                self.totals.largest = deviation
                self.totals.where = f"{self.recording.name}, node `{node}`, episode {self.index}, tick {tick}, {field}"
        self.totals.values += len(numbers)


def divides(rate, other):
    return (Fraction(str(other)) / Fraction(str(rate))).denominator == 1


def near(a, b):
    return abs(a - b) <= STAMP_TOLERANCE_S


def compare(recording, episodes):
    """Totals; raises Difference at the first one. `episodes` begin with the initialisation, which EAGERx does not
    record either."""
    totals = Totals()
    for index, episode in enumerate(episodes[1:len(recording.episodes) + 1]):
        Comparison(recording, index, episode, totals).run()
    return totals
