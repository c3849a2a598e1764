"""A second implementation of the semantics (SEMANTICS §3 to §8), written from their description only: nodes with
queues that fire, in any order, when EAGERx's formula is satisfied. Nothing here knows how the generated programs count,
order or store anything. Rates and delays are fractions.
"""
import copy
import functools
import json
import math
import random
from fractions import Fraction

MODULUS = 1000003


@functools.lru_cache(maxsize=None)
def count(rate_in, rate, delay, skip, tick):
    """Messages that an input gets at a tick (SEMANTICS §3): EAGERx's formula as EAGERx has it, in exact arithmetic."""
    if tick == 0:
        return 0 if skip else 1
    offset = 0
    if skip:
        offset = int((rate - Fraction(1, 10**9)) / rate_in) if rate > rate_in else -1

    def sent(k):
        return math.floor((rate_in * k - rate * rate_in * delay) / rate)

    delta = sent(tick + offset) - sent(tick + offset - 1)
    j = delta - (1 if skip else 0)
    time = (rate_in * tick - rate * rate_in * delay - rate * j) / (rate * rate_in)
    return delta - min(delta, max(0, -math.floor(time * rate_in)))


class Input:
    def __init__(self, name, source, output, window=1, delay=Fraction(0), skip=False, add=None):
        self.name, self.source, self.output = name, source, output
        self.window, self.delay, self.skip, self.add = window, delay, skip, add
        self.counts = []  # messages of each tick, as far as it was asked for

    def reset(self):
        self.consumed = 0

    def count(self, nodes, node, tick):
        """count() of this input of `node`."""
        for k in range(len(self.counts), tick + 1):
            self.counts.append(count(nodes[self.source].rate, node.rate, self.delay, self.skip, k))
        return self.counts[tick]

    def available(self, nodes, node, tick):
        return len(nodes[self.source].sent[self.output]) >= self.consumed + self.count(nodes, node, tick)

    def take(self, nodes, node, tick):
        """The window at a tick as (seq, message) pairs."""
        new = self.count(nodes, node, tick)
        self.consumed += new
        held = new if self.window == 0 else min(self.window, self.consumed)
        messages = nodes[self.source].sent[self.output]
        result = []
        for seq in range(self.consumed - held, self.consumed):
            message = messages[seq]
            if self.add is not None:
                message = (message[0], message[1] + self.add)
            result.append((seq, message))
        return result


    def writes_what_it_reads(self, nodes, node):
        """A callback's output is written where its input still is, unless a processor stands between."""
        return self.source == node.name and self.output not in node.add and self.add is None

    def most_held(self, nodes, node, source_first):
        """The most messages from the oldest in the window to the newest sent, at any tick: what a ring must hold.
        The pattern repeats when the rates have come together once after delay and window."""
        source = nodes[self.source]
        ratio = source.rate / node.rate
        full = max(1, self.window) * math.ceil(1 / ratio) + math.ceil(self.delay * node.rate)
        consumed, most = 0, 1
        for tick in range(full + 2 * ratio.denominator + 8):
            new = self.count(nodes, node, tick)
            consumed += new
            held = new if self.window == 0 else min(self.window, consumed)
            latest = ratio * tick  # the source's newest tick, perhaps of this instant
            sent = math.floor(latest) + (1 if source_first or latest.denominator > 1 else 0)
            if held:
                most = max(most, sent - (consumed - held))
        return most


class Node:
    """kind: environment, engine, count, sensor, actuator or reset."""

    def __init__(self, name, kind, rate, nid=0, inputs=(), outputs=("o0",), thing=None, add=None, feedthroughs=(), target=None, callbacks=0):
        self.name, self.kind, self.rate, self.nid = name, kind, rate, nid
        self.inputs, self.outputs = list(inputs), list(outputs)
        self.thing = thing  # of engine nodes: their object
        self.add = add or {}  # output: what its processor adds
        # Of reset nodes: what they pass on in an episode, the object whose state they bring about in that number of callbacks.
        self.feedthroughs, self.target, self.callbacks = list(feedthroughs), target, callbacks
        self.times = []  # of each tick, as far as it was asked for

    def reset(self, state):
        self.tick = 0
        self.sum = state or 0
        self.called = 0  # callbacks so far: of reset nodes, in their routine
        self.sent = {output: [] for output in self.outputs}
        for item in self.inputs + self.feedthroughs:
            item.reset()

    def time(self, tick=None):
        tick = self.tick if tick is None else tick
        for k in range(len(self.times), tick + 1):
            self.times.append(k / self.rate)
        return self.times[tick]


def fold(windows, h):
    for name, window in windows:
        h = (h * 131 + len(window) + 1) % MODULUS
        if name != "tick":
            for _, message in window:
                h = (h * 131 + message[0] * 7 + message[1]) % MODULUS
    return h


class Record:
    """The events at a tick of a node."""

    def __init__(self, time, called, windows, sent, simulators, target):
        self.time, self.called, self.windows, self.sent, self.simulators = time, called, windows, sent, simulators
        self.target = target  # of a reset node in its routine, otherwise None


class Network:
    """`nodes`: all of them, by name; with `environment` and `engine`."""

    def __init__(self, nodes):
        self.nodes = nodes
        self.state = {}
        self.objects = sorted({node.thing for node in nodes.values() if node.thing})
        self.behind = self._behind_environment()
        coupled = [node.name for node in nodes.values() if node.thing or node.kind == "engine"]
        self.readers = {name: [] for name in nodes}  # and who else waits for it
        for node in nodes.values():
            for item in node.inputs + node.feedthroughs:
                self.readers[item.source].append(node.name)
        for name in coupled:
            self.readers[name] += coupled

    def _behind_environment(self):
        """Nodes that need the action of the same instant: the program runs them in the next step."""
        behind = {"environment"}
        while True:
            more = {node.name for node in self.nodes.values()
                    if any(not item.skip and item.source in behind for item in node.inputs + node.feedthroughs)} - behind
            if not more:
                return behind - {"environment"}
            behind |= more

    def start(self, states):
        """Objects with a target begin where they are; at the very first reset they are set too."""
        reached = {node.target: self.state[node.target] for node in self.nodes.values() if node.target and self.state}
        for node in self.nodes.values():
            node.reset(states.get((node.name, "s0")))
        self.targets = {}  # while reset nodes are at work: the state that each object is to be brought to
        self.state = {thing: reached.get(thing, states.get((thing, "st0"), (0, 0))[0]) for thing in self.objects}
        self.inputs = {thing: {} for thing in self.objects}

    def run(self, steps, states, actions, order):
        """Records of an episode up to the environment's tick `steps`: (node, tick) → Record.
        `actions[k][name]`: message; `order`: a random.Random that chooses who fires."""
        self.start(states)
        end = Fraction(steps) / self.nodes["environment"].rate
        return self._fire_all(lambda node: node.time() < end or node.time() == end and node.name not in self.behind,
                              actions, order)

    def bring_about(self, states, order):
        """Records of the routine of the reset nodes, until the last one is done."""
        self.targets = {node.target: states[node.target, "st0"] for node in self.nodes.values() if (node.target, "st0") in states}
        end = max((node.time(node.tick + node.callbacks - 1) for node in self.nodes.values() if node.target in self.targets),
                  default=Fraction(-1))
        return self._fire_all(lambda node: node.time() <= end and node.kind != "environment", [], order)

    def _fire_all(self, may_fire, actions, order):
        records = {}
        waiting = sorted(self.nodes)  # who may have become ready
        while waiting:
            place = order.randrange(len(waiting))
            waiting[place], waiting[-1] = waiting[-1], waiting[place]
            node = self.nodes[waiting.pop()]
            while may_fire(node) and self.is_ready(node):
                tick = node.tick
                records[node.name, tick] = self.fire(node, actions if tick < len(actions) else None)
                waiting += [name for name in self.readers[node.name] if name not in waiting]
                if order.random() < 0.5:
                    waiting.append(node.name)
                    break
        return records

    def is_ready(self, node):
        """Whether its messages are there, and, of the engine and its nodes, whether it is their turn."""
        waits_for = node.inputs + ([] if self.targets else node.feedthroughs)
        if not all(item.available(self.nodes, node, node.tick) for item in waits_for):
            return False
        others = self.nodes.values()
        if node.kind == "engine":  # earliest first
            return all(other.time() >= node.time() for other in others if other.thing)
        if node.thing:  # the engine first at equal times
            return self.nodes["engine"].time() > node.time()
        return True

    def fire(self, node, actions):
        windows = [(item.name, item.take(self.nodes, node, node.tick)) for item in node.inputs]
        if node.feedthroughs and not self.targets:
            windows += [(item.name, item.take(self.nodes, node, node.tick)) for item in node.feedthroughs]
        sent = getattr(self, "_" + node.kind)(node, windows, actions)
        for output, message in sent.items():
            if output in node.add:
                message = (message[0], message[1] + node.add[output])
            node.sent[output].append(message)
        simulators = {thing: {"state": self.state[thing], "input": sum(self.inputs[thing].values()) % MODULUS}
                      for thing in (self.objects if node.kind == "engine" else [])}
        record = Record(node.time(), node.called, windows, {output: node.sent[output][-1] for output in sent}, simulators,
                        self.targets.get(node.target))
        node.called += node.kind != "reset" or bool(self.targets)
        node.tick += 1
        return record

    def _message(self, node, h):
        return {output: (node.nid * 100000 + node.called, (h * 31 + j) % MODULUS) for j, output in enumerate(node.outputs)}

    def _environment(self, node, windows, actions):
        return dict(actions[node.tick]) if actions is not None else {}

    def _engine(self, node, windows, actions):
        if node.tick > 0:
            for thing in self.objects:
                total = sum(self.inputs[thing].values()) % MODULUS
                self.state[thing] = (self.state[thing] * 131 + total * 7 + node.tick) % MODULUS
        return {"tick": node.tick}

    def _count(self, node, windows, actions):
        node.sum = fold(windows, node.sum)
        return self._message(node, node.sum)

    def _reset(self, node, windows, actions):
        if not self.targets:
            return {name: window[-1][1] for name, window in windows if name in node.outputs}
        node.sum = (fold(windows, node.sum) * 131 + self.targets[node.target][0]) % MODULUS
        return self._message(node, node.sum)

    def _sensor(self, node, windows, actions):
        return self._message(node, fold(windows, self.state[node.thing]))

    def _actuator(self, node, windows, actions):
        h = fold(windows, 0)
        self.inputs[node.thing][node.name] = h
        return self._message(node, h)


def recording(name, network, steps, episodes, seed):
    """The recording that EAGERx would have made, in its format (tests/conformance/README.md). `episodes`: the
    states of each. Every episode is simulated twice in different firing orders, which must make no difference."""
    chooser = random.Random(seed)
    content = {"name": name, "env_rate": number(network.nodes["environment"].rate), "env_trace": [],
               "nodes": {node.name: described(network, node) for node in network.nodes.values()},
               "node_trace": {name: [] for name in network.nodes}, "reset_trace": {name: [] for name in network.nodes}}
    twin = copy.deepcopy(network)
    for index, states in enumerate(episodes):
        actions = [{output: (chooser.randrange(1000), chooser.randrange(1000)) for output in network.nodes["environment"].outputs}
                   for _ in range(steps)]
        after = episodes[min(index + 1, len(episodes) - 1)]
        records, again = [(one.run(steps, states, actions, order), one.bring_about(after, order))
                          for one, order in ((network, random.Random(1)), (twin, random.Random(2)))]
        for part, other in zip(records, again):
            assert {k: v.__dict__ for k, v in part.items()} == {k: v.__dict__ for k, v in other.items()}
        episode, phase = records
        observations = [{item.name: padded(item, window) for item, (_, window) in
                         zip(network.nodes["environment"].inputs, episode["environment", k].windows)} for k in range(steps + 1)]
        content["env_trace"].append({
            "states": {f"{owner}/{state}": value for (owner, state), value in states.items()}, "reset_obs": observations[0],
            "steps": [{"action": action, "obs": seen} for action, seen in zip(actions, observations[1:])]})
        for node in network.nodes.values():
            both = list(recorded(network, node, {**episode, **phase}))
            first = sum((node.name, k) in episode for k in range(node.tick))
            content["node_trace"][node.name].append(both[:first])
            content["reset_trace"][node.name].append(both[first:])
    return json.loads(json.dumps(content))  # lists for tuples


def number(rate):
    return int(rate) if rate.denominator == 1 else float(rate)


def described(network, node):
    def ports(items):
        return [{"name": item.name, "source": f"{item.source}/outputs/{item.output}", "skip": item.skip} for item in items]

    outputs = [{"name": output, "processor": None, "shape": [2]} for output in node.outputs]
    targets = [{"name": "g0", "source": f"{node.target}/states/st0"}] if node.target else []
    return {"rate": number(node.rate), "inputs": ports(node.inputs), "feedthroughs": ports(node.feedthroughs),
            "outputs": outputs, "targets": targets}


def recorded(network, node, records):
    """The ticks of an episode and of the routine behind it; a message is handed over at the first tick that has it."""
    handed = {}
    for tick in range(node.tick):
        record = records[node.name, tick]
        passes = bool(node.feedthroughs) and record.target is None
        inputs = {}
        for item, (_, window) in zip(node.inputs + node.feedthroughs, record.windows):
            source = network.nodes[item.source]
            first = [handed.setdefault((item.name, seq), tick) for seq, _ in window]
            if passes and item not in node.feedthroughs:
                continue  # consumed, but not shown
            inputs[item.name] = {
                "rate_in": number(source.rate), "seq": [seq for seq, _ in window], "sc": [stamp(source, seq) for seq, _ in window],
                "t_node_seq": first, "t_node_sc": [stamp(node, n) for n in first], "msgs": [message for _, message in window]}
        result = {"tick": tick, "t_n": stamp(node, tick), "num_ticks": record.called, "inputs": inputs, "out": record.sent or None}
        if record.target:
            inputs["g0"] = {"msgs": [record.target], "target": True}
        if passes:
            result["feedthrough"] = True
        if node.kind == "engine":
            result["sim"] = record.simulators
        yield result


def stamp(node, tick):
    return round(float(node.time(tick)), 12)


def padded(item, window):
    """An observation as the agent sees it: copies of the oldest message in front, "nan" without any."""
    messages = [message for _, message in window]
    if item.window > 0:
        missing = item.window - len(messages)
        messages = [messages[0] if messages else ("nan", "nan")] * missing + messages
    return messages
