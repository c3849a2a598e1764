"""Graphs of integer entities (tests/conformance/models): written by hand, and sampled at random. A graph is made
here once and turned into both the generator's YAML and the network of kahn.py.
"""
import random
from fractions import Fraction

from kahn import Input, Network, Node, count


class Graph:
    def __init__(self, name, rate, engine_rate):
        self.name, self.rate, self.engine_rate = name, rate, engine_rate
        self.things = {}  # object: (nid, {port: rate})
        self.count_nodes = {}  # node: (nid, rate, inputs, outputs, {output: k})
        self.reset_nodes = {}  # node: (nid, rate, inputs, outputs, callbacks, object)
        self.actions, self.observations = [], []
        self.connections = []  # (from, to, settings)
        self.states = []

    def thing(self, name, nid, **rates):
        self.things[name] = (nid, rates)
        return self

    def node(self, name, nid, rate, inputs, outputs=("o0",), add=None):
        self.count_nodes[name] = (nid, rate, list(inputs), list(outputs), add or {})
        return self

    def reset_node(self, name, nid, rate, inputs, callbacks, thing, outputs=("o0",)):
        """`callbacks`: how many it takes to bring about the state of the object `thing`."""
        self.reset_nodes[name] = (nid, rate, list(inputs), list(outputs), callbacks, thing)
        return self

    def connect(self, source, target, **settings):
        """`settings`: window, delay (text), skip, add."""
        for end, names in ((source, self.actions), (target, self.observations)):
            owner, port = end.split(".", 1)
            if owner in ("actions", "observations") and port not in names:
                names.append(port)
        self.connections.append((source, target, settings))
        return self

    def yaml(self):
        lines = [f"name: {self.name}", f"rate: {self.rate}"]
        if self.engine_rate:
            lines.append(f"engine: {{type: OracleEngine, rate: {self.engine_rate}}}")
        if self.things:
            lines.append("objects:")
        for name, (nid, rates) in self.things.items():
            lines.append(f"  {name}:\n    type: OObject\n    config: {{nid: {nid}}}\n    states: {{st0: uniform}}")
            for kind, first in (("sensors", "s"), ("actuators", "a")):
                chosen = [f"{port}: {{rate: {rate}}}" for port, rate in rates.items() if port[0] == first]
                if chosen:
                    lines.append(f"    {kind}: {{{', '.join(chosen)}}}")
        if self.count_nodes or self.reset_nodes:
            lines.append("nodes:")
        for name, (nid, rate, inputs, outputs, callbacks, _) in self.reset_nodes.items():
            lines.append(f"  {name}: {{type: CountReset, rate: {rate}, config: {{nid: {nid}, n_reset: {callbacks}}}, "
                         f"inputs: [{', '.join(inputs)}], outputs: [{', '.join(outputs)}]}}")
        for name, (nid, rate, inputs, outputs, add) in self.count_nodes.items():
            chosen = ", ".join(f"{o}: {{processor: {{type: AddProc, config: {{k: {add[o]}}}}}}}" if o in add else f"{o}: {{}}" for o in outputs)
            lines.append(f"  {name}: {{type: CountNode, rate: {rate}, config: {{nid: {nid}}}, inputs: [{', '.join(inputs)}], "
                         f"outputs: {{{chosen}}}, states: {{s0: uniform}}}}")
        lines.append("actions:")
        for action in self.actions:
            lines.append(f"  {action}: {{space: {{dtype: int64, shape: [2], low: 0, high: 1000}}}}")
        lines.append(f"observations: [{', '.join(self.observations)}]")
        lines.append("connections:")
        for source, target, settings in self.connections:
            text = "".join(f", {key}: {value}" for key, value in (("window", settings.get("window")), ("delay", settings.get("delay"))) if value is not None)
            if settings.get("skip"):
                text += ", skip: true"
            if "add" in settings:
                text += f", processor: {{type: AddProc, config: {{k: {settings['add']}}}}}"
            lines.append(f"  - {{from: {source}, to: {target}{text}}}")
        for name, (*_, thing) in self.reset_nodes.items():
            lines.append(f"  - {{from: {thing}.states.st0, to: {name}.targets.g0}}")
        lines.append("agent: random")
        return "\n".join(lines) + "\n"

    def _source(self, source):
        owner, port = source.split(".")
        if owner == "actions":
            return "environment", port
        return (f"{owner}/{port}", "o0") if owner in self.things else (owner, port)

    def _input(self, target, name):
        for source, to, settings in self.connections:
            if to == target:
                node, output = self._source(source)
                return Input(name, node, output, settings.get("window", 1), Fraction(settings.get("delay", "0")),
                             settings.get("skip", False), settings.get("add"))
        raise KeyError(target)

    def network(self):
        nodes = {
            "environment": Node("environment", "environment", Fraction(self.rate), outputs=self.actions,
                                inputs=[self._input(f"observations.{o}", o) for o in self.observations]),
        }
        if self.engine_rate:
            nodes["engine"] = Node("engine", "engine", Fraction(self.engine_rate), outputs=["tick"])
        for thing, (nid, rates) in self.things.items():
            for port, rate in rates.items():
                name = f"{thing}/{port}"
                inputs = [Input("tick", "engine", "tick")]
                if port[0] == "a":
                    inputs.append(self._input(f"{thing}.{port}", "i0"))
                kind, first = ("actuator", nid + 10) if port[0] == "a" else ("sensor", nid)
                nodes[name] = Node(name, kind, Fraction(rate), first + int(port[1]), inputs, thing=thing)
        for name, (nid, rate, inputs, outputs, add) in self.count_nodes.items():
            nodes[name] = Node(name, "count", Fraction(rate), nid, [self._input(f"{name}.{i}", i) for i in inputs], outputs, add=add)
        for name, (nid, rate, inputs, outputs, callbacks, thing) in self.reset_nodes.items():
            nodes[name] = Node(name, "reset", Fraction(rate), nid, [self._input(f"{name}.{i}", i) for i in inputs], outputs,
                               feedthroughs=[self._input(f"{name}.feedthroughs.{o}", o) for o in outputs], target=thing, callbacks=callbacks)
        return Network(nodes)

    def sample_episodes(self, seed):
        """The states of two episodes: none set, then all."""
        chooser = random.Random(seed)
        states = {(thing, "st0"): (chooser.randrange(1000), 0) for thing in self.things}
        states.update({(node, "s0"): chooser.randrange(1000) for node in self.count_nodes})
        return [{}, states]


# Sets of rates in Hz that lead to each form of the schedule; the first of each is the environment's.
RATES = {
    "constants": [["10", "10", "20", "40"], ["5", "10", "20", "5"], ["0.5", "0.5", "1", "2.5", "5"], ["10", "30", "60", "20"],
                  ["30", "30"], ["7.5", "15", "7.5", "30"]],
    "table": [["20", "30", "7", "20"], ["30", "20", "10", "12", "15"], ["3", "20", "8", "5"], ["50", "25", "20", "10"],
              ["8", "30", "3", "50", "25"], ["7", "30", "7"], ["30", "0.5", "20"], ["12.5", "10", "25", "40"]],
    "countdown": [["29.97", "30", "10"], ["30", "29.97", "7"], ["30", "0.333", "100.1", "20"], ["60", "59.94", "23.976", "24"]],
}
DELAYS = ["0.001", "0.015", "0.04", "0.05", "0.1", "0.1", "0.12", "0.2", "0.3", "0.25", "1", "0.0333"]


class RandomGraph:
    """A graph that the generator must accept: no cycle without skip, nothing skipped and windowed that stays empty."""

    def __init__(self, seed, form):
        self.random = random.Random(f"{seed}")
        self.rates = self.random.choice(RATES[form])
        self.graph = Graph(f"random_{seed}", self.rates[0], self.pick_rate())
        self.sources = {"actions.u0": self.rates[0]}  # source: its rate
        self.make()

    def pick_rate(self):
        return self.random.choice(self.rates)

    def settings(self, source_rate, rate, skip):
        settings = {"window": self.random.choice([1, 1, 1, 0, 0, 2, 3, 5, 17])}
        if self.random.random() < 0.4:
            settings["delay"] = self.random.choice(DELAYS)
        if self.random.random() < 0.15:
            settings["add"] = self.random.randrange(1, 100)
        if skip:
            settings["skip"] = True
            arrived = [count(Fraction(source_rate), Fraction(rate), Fraction(settings.get("delay", "0")), True, n) for n in (0, 1)]
            if sum(arrived) == 0:  # EAGERx drops the callback, the generator refuses the graph
                settings["window"] = 0
        return settings

    def connect(self, target, rate, before, anything):
        """From one of `before`, or skipped from one of `anything`."""
        skip = not before or self.random.random() < 0.3
        source = self.random.choice(sorted(anything if skip else before))
        self.graph.connect(source, target, **self.settings(self.sources[source], rate, skip))

    def make(self):
        graph, chooser = self.graph, self.random
        sensors = []
        for i in range(chooser.choice([1, 1, 2])):
            ports = {f"s{k}": self.pick_rate() for k in range(chooser.randrange(1, 4))}
            ports.update({f"a{k}": self.pick_rate() for k in range(chooser.randrange(1, 3))})
            graph.thing(f"ob{i}", 20 + 20 * i, **ports)
            for port, rate in ports.items():
                if port[0] == "s":
                    sensors.append(f"ob{i}.{port}")
                    self.sources[sensors[-1]] = rate
        count_nodes = []
        for i in range(chooser.randrange(2, 8)):
            outputs = chooser.choice([["o0"], ["o0", "o1"], ["o1"]])
            inputs = ["i0", "i1", "i2", "i3"][: chooser.randrange(1, 5)]
            add = {o: chooser.randrange(1, 100) for o in outputs if chooser.random() < 0.2}
            rate = self.pick_rate()
            graph.node(f"n{i}", 200 + i, rate, inputs, outputs, add)
            own = [f"n{i}.{o}" for o in outputs]
            self.sources.update({source: rate for source in own})
            count_nodes.append((f"n{i}", rate, inputs, own, chooser.random() < 0.5))
        everything = list(self.sources)
        upstream, downstream = list(sensors), ["actions.u0", *sensors]  # what may be used without skip
        graph.connect("actions.u0", "ob0.a0", **self.settings(self.rates[0], graph.things["ob0"][1]["a0"], False))
        for name, rate, inputs, own, behind_action in count_nodes:
            for item in inputs:
                self.connect(f"{name}.{item}", rate, downstream if behind_action else upstream, everything)
            downstream += own
            if not behind_action:
                upstream += own
        for thing, (_, rates) in graph.things.items():
            for port, rate in rates.items():
                if port[0] == "a" and (thing, port) != ("ob0", "a0"):
                    self.connect(f"{thing}.{port}", rate, downstream, everything)
        for i in range(chooser.randrange(1, 5)):
            self.connect(f"observations.x{i}", self.rates[0], upstream, everything)


class RandomNodes(RandomGraph):
    """The same without engine and objects: from actions through nodes to observations."""

    def make(self):
        self.graph.name, self.graph.engine_rate = self.graph.name.replace("random", "nodes"), None
        graph, chooser = self.graph, self.random
        self.sources["actions.u1"] = self.rates[0]
        count_nodes = [(f"n{i}", self.pick_rate(), ["i0", "i1", "i2"][: chooser.randrange(1, 4)]) for i in range(chooser.randrange(1, 7))]
        before = list(self.sources)
        self.sources.update({f"{name}.o0": rate for name, rate, _ in count_nodes})
        everything = list(self.sources)
        for i, (name, rate, inputs) in enumerate(count_nodes):
            graph.node(name, 200 + i, rate, inputs)
            for item in inputs:
                self.connect(f"{name}.{item}", rate, before, everything)
            before.append(f"{name}.o0")
        for action in ("actions.u0", "actions.u1"):  # each has a reader
            graph.node(f"r{action[-1]}", 300, self.rates[0], ["i0"]).connect(action, f"r{action[-1]}.i0")
        for i in range(chooser.randrange(1, 4)):  # what is seen needs no action of its instant
            self.connect(f"observations.x{i}", self.rates[0], [], everything)


def by_hand():
    """Small graphs for one thing each."""

    def loop(name, rate, engine_rate, sensor_rate, actuator_rate, node_rate, **settings):
        graph = Graph(name, rate, engine_rate).thing("ob", 20, s0=sensor_rate, a0=actuator_rate)
        graph.node("n", 200, node_rate, ["i0"])
        graph.connect("ob.s0", "n.i0", **settings)
        graph.connect("n.o0", "observations.n").connect("ob.s0", "observations.s", window=3)
        return graph.connect("actions.u", "ob.a0")

    yield loop("equal", "30", "30", "30", "30", "30")
    yield loop("window_0", "10", "30", "30", "10", "10", window=0)
    yield loop("window_n", "10", "30", "30", "10", "20", window=5)
    yield loop("thirty_twenty", "20", "30", "30", "20", "30", window=0)
    yield loop("ntsc", "29.97", "30", "30", "29.97", "30", window=2)
    yield loop("seven_thirty", "30", "30", "7", "7", "30")
    yield loop("half_a_hertz", "0.5", "20", "20", "0.5", "5", window=0)
    yield loop("env_fast", "50", "25", "10", "10", "20", window=0)
    yield loop("env_slow", "3", "20", "20", "5", "8")
    yield loop("sensor_fast", "10", "10", "40", "20", "10", window=0)
    yield loop("delay_exact", "20", "20", "20", "20", "20", delay="0.15")
    yield loop("delay_long", "20", "20", "20", "20", "30", delay="2.01", window=0)
    yield loop("delay_odd", "7", "30", "30", "7", "30", delay="0.1", window=4)
    yield loop("skip", "10", "20", "20", "10", "20", skip=True)
    yield loop("skip_odd", "10", "30", "3", "10", "5", skip=True, window=0)
    yield loop("skip_delay", "10", "20", "20", "10", "7", skip=True, window=0, delay="0.3")
    # The worked example of runtime/SEMANTICS.md, whose table tests/documents checks.
    graph = Graph("worked_example", "10", "60").thing("ob", 20, s0="20", a0="10").node("n", 200, "30", ["i0", "i1", "i2"])
    graph.connect("ob.s0", "n.i0", delay="0.06", window=3).connect("ob.s0", "n.i1", delay="0.06", window=0)
    graph.connect("ob.s0", "n.i2", skip=True).connect("n.o0", "observations.n")
    yield graph.connect("actions.u", "ob.a0")
    graph = loop("feedback", "10", "20", "20", "10", "20")
    graph.node("m", 201, "30", ["i0", "i1", "i2"], ["o0", "o1"], add={"o1": 7})
    graph.connect("n.o0", "m.i0", skip=True, window=2).connect("m.o1", "m.i1", skip=True, window=0)
    graph.connect("actions.u", "m.i2", add=5).connect("m.o0", "observations.m", skip=True, window=2)
    yield graph.connect("m.o1", "observations.late", skip=True, window=0, delay="0.15")
    yield from with_reset_nodes()
    yield many("many_constants", "10", ["10", "20"])
    yield many("many_table", "30", ["20", "30", "7"])
    yield many("many_countdown", "30", ["29.97", "30"])


def with_reset_nodes():
    """Reset nodes between the agent and one object or two, at rates that give each form of schedule."""
    rates = {"same": ["10"] * 6, "divide": ["10", "20", "20", "10", "5", "20"], "odd": ["7", "30", "30", "7", "30", "20"],
             "slow": ["10", "20", "20", "10", "2.5", "10"], "ntsc": ["29.97", "30", "30", "29.97", "30", "29.97"]}
    for name, (rate, engine_rate, sensor, actuator, reset, node) in rates.items():
        graph = Graph(f"reset_{name}", rate, engine_rate).thing("ob", 20, s0=sensor, a0=actuator)
        graph.reset_node("rst", 300, reset, ["i0", "i1"], 7, "ob").node("n", 200, node, ["i0"]).node("hold", 201, reset, ["i0"])
        graph.connect("actions.u", "hold.i0").connect("hold.o0", "rst.feedthroughs.o0", window=2).connect("rst.o0", "ob.a0")
        graph.connect("ob.s0", "n.i0", window=0).connect("n.o0", "rst.i0", window=3).connect("ob.s0", "rst.i1", window=0)
        yield graph.connect("n.o0", "observations.n").connect("rst.o0", "observations.r", skip=True)
        graph = Graph(f"reset_two_{name}", rate, engine_rate).thing("ob", 20, s0=sensor, a0=actuator).thing("other", 40, s0=node, a0=rate)
        graph.reset_node("rst", 300, reset, ["i0"], 5, "ob", ["o0", "o1"]).reset_node("again", 301, node, ["i0"], 9, "other")
        graph.node("pass", 200, actuator, ["i0", "i1"]).node("hold", 201, reset, ["i0"]).node("also", 202, node, ["i0"])
        graph.connect("actions.u", "hold.i0").connect("actions.v", "also.i0", window=2)
        graph.connect("hold.o0", "rst.feedthroughs.o0").connect("hold.o0", "rst.feedthroughs.o1", delay="0.05")
        graph.connect("also.o0", "again.feedthroughs.o0", add=11)
        graph.connect("rst.o0", "pass.i0").connect("rst.o1", "pass.i1", skip=True, window=0).connect("pass.o0", "ob.a0", delay="0.1")
        graph.connect("again.o0", "other.a0").connect("other.s0", "rst.i0", window=2).connect("ob.s0", "again.i0", delay="0.04")
        yield graph.connect("ob.s0", "observations.s", window=2).connect("other.s0", "observations.t")


def many(name, rate, rates):
    """More nodes than fit into one function."""
    graph = Graph(name, rate, rates[0]).thing("ob", 20, s0=rates[-1], a0=rates[0])
    before, behind = ["ob.s0"], ["ob.s0", "actions.u"]
    for i in range(70):
        for letter, sources in (("b", before), ("c", behind)):
            node = f"{letter}{i}"
            graph.node(node, 200 + i, rates[i % len(rates)], ["i0", "i1"])
            graph.connect(sources[(7 * i) % len(sources)], f"{node}.i0", window=i % 3)
            graph.connect(sources[-1], f"{node}.i1")
            sources.append(f"{node}.o0")
    graph.connect("b69.o0", "observations.x").connect("c69.o0", "observations.y", skip=True, window=2)
    return graph.connect("c68.o0", "ob.a0")
