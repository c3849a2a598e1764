"""Part of a graph in Python: reads part.json in the same folder, communicates with the hub and calls the nodes.

`python3 FOLDER --listen unix:PATH` serves one hub. nodes.py implements the nodes: a class for each node, with
`__init__(config)`, `reset(**states)` and `step(n, **inputs)`.
"""
import argparse
import json
import os
import struct
import sys

try:
    import numpy as np
except ImportError:
    sys.exit("error: there is no numpy\nhelp: install it with `apt install python3-numpy`")

from eagerx_key import Key, KeyProblem
from eagerx_line import LinkClosed, LinkForged, is_tcp_address, listen, open_serial
from eagerx_link import PartLink, ProtocolError, SessionOver

STEP, RESET, FINISH, SAFE_STEP = 1, 2, 3, 4
EPISODE = struct.Struct("<QIIB")  # seed, environment, episode, agent
REPORT = struct.Struct("<II")  # stack (not measured here), dropped frames; named counts would follow
NO_COUNTS = b"\0"


class PartError(Exception):
    """An error in a node or in part.json."""


def check(condition, text):
    if not condition:
        raise PartError(text)


def space_text(dtype, shape):
    return f"{dtype} [{', '.join(str(size) for size in shape)}]"


class Message:
    """Newest messages of one output. Message `seq` is at index `seq % keep`."""

    def __init__(self, layout):
        self.name, self.bytes, self.keep = layout["name"], layout["bytes"], layout["keep"]
        self.shape = tuple(layout["shape"])
        self.dtype = np.dtype(layout["dtype"]).newbyteorder("<")
        self.ring = np.zeros((self.keep, *self.shape), self.dtype)
        check(self.ring.nbytes == self.keep * self.bytes, f"`{self.name}`: {self.bytes} bytes are no "
              f"{space_text(self.dtype.name, self.shape)}")

    def receive(self, seq, data):
        kind = np.uint8 if self.dtype == bool else self.dtype
        values = np.frombuffer(data, kind).reshape(self.shape)
        self.ring[seq % self.keep] = values != 0 if self.dtype == bool else values

    def set(self, seq, value, where):
        """Stores the value that a node returned, and returns its bytes."""
        given = np.asarray(value)
        wanted = space_text(self.dtype.name, self.shape)
        fits = np.can_cast(given.dtype, self.dtype, "same_kind") or (
            given.dtype.kind in "iu" and self.dtype.kind in "iu" and bool(np.all(given.astype(self.dtype) == given)))
        check(given.shape == self.shape and fits,
              f"{where} is {wanted}, but step() gave {space_text(given.dtype.name, given.shape)}")
        self.ring[seq % self.keep] = given
        return self.ring[seq % self.keep].tobytes()

    def window(self, end, size):
        """Copy of the last `size` of `end` messages, oldest first: an array [size, *shape]."""
        return self.ring[np.arange(end - size, end) % self.keep]


class Input:
    """Input of a node, and the number of messages that it has received: runtime/SEMANTICS.md, section 3."""

    def __init__(self, layout, messages):
        self.name, self.message = layout["name"], messages[layout["message"]]
        self.most, self.skip = layout["window"], layout["skip"]
        self.a, self.b, self.x, self.off = (layout[key] for key in ("a", "b", "x", "off"))
        self.reset()

    def reset(self):
        self.received = 0

    def _sent(self, n):
        return (self.a * n - self.x) // self.b

    def take(self, n):
        """Messages in the window at tick n. Must be called once at every tick."""
        before = self.received
        if not self.skip:
            self.received = max(1, self._sent(n) + 1)
        elif n > 0:
            arriving = self._sent(n + self.off) - self._sent(n + self.off - 1)
            self.received += max(0, min(arriving, self._sent(n) + 1))
        size = min(self.most, self.received) if self.most > 0 else self.received - before
        return self.message.window(self.received, size)


class Node:
    """Node of this part: its inputs, its class in nodes.py, and its outputs."""

    def __init__(self, layout, messages, classes):
        self.name = layout["name"]
        check(self.name in classes, f"nodes.py has no class for the node `{self.name}`")
        self.inputs = [Input(item, messages) for item in layout["inputs"]]
        self.outputs = [(item["name"], messages[item["message"]]) for item in layout["outputs"]]
        self.states = {name: np.array(value["value"], value["dtype"]).reshape(value["shape"])
                       for name, value in layout["states"].items()}
        self.instance = classes[self.name](layout["config"])

    def reset(self):
        for item in self.inputs:
            item.reset()
        self.instance.reset(**self.states)

    def step(self, n):
        """Runs the node, and returns the bytes of its outputs."""
        given = self.instance.step(n, **{item.name: item.take(n) for item in self.inputs})
        if not isinstance(given, dict):
            check(len(self.outputs) == 1, f"node `{self.name}` has {len(self.outputs)} outputs: step() returns a dict")
            given = {self.outputs[0][0]: given}
        names = [name for name, _ in self.outputs]
        check(sorted(given) == sorted(names), f"node `{self.name}` has the outputs {names}, but step() gave "
              f"{sorted(given)}")
        return b"".join(message.set(n, given[name], f"node `{self.name}`: output `{name}`")
                        for name, message in self.outputs)


class Turn:
    """Node at a tick: it runs here, or its messages come from the hub."""

    def __init__(self, layout, messages, nodes):
        self.rate, self.node = layout["rate"], nodes.get(layout["node"])
        self.messages = [messages[item] for item in layout["messages"]]

    def take(self, n, link):
        if self.node is not None:
            link.write(self.node.step(n))
            return
        for message in self.messages:
            message.receive(n, link.read(message.bytes))


class Part:
    """Schedule of part.json, in lockstep with the hub."""

    def __init__(self, layout, classes):
        check(layout.get("format") == "eagerx part 1", "part.json is of another version of eagerx-gen")
        check(not layout["decides"], "the agent is in this part, which has to be a program in C++")
        messages = [Message(item) for item in layout["messages"]]
        self.nodes = {item["name"]: Node(item, messages, classes) for item in layout["nodes"]}
        self.before, self.after = ([Turn(item, messages, self.nodes) for item in layout[key]]
                                   for key in ("before", "after"))
        self.actions = [messages[item] for item in layout["actions"]]
        self.periods = [item["period"] for item in layout["rates"]]
        self.step_rate = layout["step_rate"]
        self.safe_steps = layout["safe_steps"]

    def reset(self, link):
        self.time = 0
        self.ticks = [0] * len(self.periods)
        for node in self.nodes.values():
            node.reset()
        self._begin_slot(link)

    def step(self, link):
        """Advances to the next tick of the environment."""
        for action in self.actions:
            action.receive(self.ticks[self.step_rate] - 1, link.read(action.bytes))
        while True:
            self._take_turns(self.after, link)
            self.time = min((self.time // period + 1) * period for period in self.periods)
            self._begin_slot(link)
            if self._is_due(self.step_rate):
                return

    def _is_due(self, rate):
        return self.time % self.periods[rate] == 0

    def _begin_slot(self, link):
        for rate in range(len(self.ticks)):
            self.ticks[rate] += self._is_due(rate)
        self._take_turns(self.before, link)

    def _take_turns(self, turns, link):
        for turn in turns:
            if self._is_due(turn.rate):
                turn.take(self.ticks[turn.rate] - 1, link)


def _run_session(link, part):
    command = link.read(1)[0]
    has_begun = False
    while True:
        if command == RESET:
            EPISODE.unpack(link.read(EPISODE.size))  # only parts in C++ have sampled states
            part.reset(link)
            has_begun = True
        elif has_begun and (command == STEP or (command == SAFE_STEP and part.safe_steps)):
            link.read(1)  # lateness, which only a program with the agent uses
            part.step(link)
        elif command == FINISH:
            link.write(REPORT.pack(0, link.damaged) + NO_COUNTS)
        else:
            raise ProtocolError(f"a hub of this graph never says {command}")
        command = link.read(1)[0]


def serve(port, layout, classes):
    """Serves one hub after the other, until the connection ends."""
    major, minor = (int(text) for text in layout["runtime"].split("."))
    part = Part(layout, classes)
    link = PartLink(port, int(layout["hash"], 16), major * 256 + minor, layout["payload"]["to_part"],
                    layout["payload"]["to_hub"], layout["depth"])
    while True:
        try:
            link.wait_for_hub()
            _run_session(link, part)
        except SessionOver:
            pass


def read_layout(folder):
    with open(os.path.join(folder, "part.json"), encoding="utf-8") as file:
        return json.load(file)


def read_options(layout, folder):
    parser = argparse.ArgumentParser(prog=f"python3 {folder}", allow_abbrev=False,
                                     description=f"serves part `{layout['part']}` of graph `{layout['graph']}`")
    line = parser.add_mutually_exclusive_group(required=True)
    line.add_argument("--listen", metavar="ADDRESS",
                      help="unix:PATH, :PORT for this machine only, or HOST:PORT, which beyond this machine needs --key")
    line.add_argument("--link", metavar="TTY", help="a serial line to the hub")
    parser.add_argument("--baud", type=int, default=115200, help="of the serial line (default: 115200)")
    parser.add_argument("--key", metavar="FILE", help="of TCP: only a hub that has the same key is let in")
    return parser.parse_args()


def open_line(options):
    """Opens the connection that the options specify. Raises OSError or KeyProblem on failure."""
    if options.key is not None and not is_tcp_address(options.listen or "unix:"):
        raise KeyProblem(f"`--key {options.key}` does nothing: it is for TCP, and serial lines and unix sockets need "
                         "none\nhelp: leave it out")
    if options.listen is None:
        return open_serial(options.link, options.baud)
    return listen(options.listen, None if options.key is None else Key(options.key))


def run(port, address, layout, classes):
    """Serves until the connection ends. Returns the exit code."""
    try:
        serve(port, layout, classes)
    except LinkForged as problem:
        print(f"error: the line `{address}` is closed: {problem}", file=sys.stderr)
        return 3
    except LinkClosed:
        return 0
    except (PartError, ProtocolError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    finally:
        port.close()


def main(classes, folder):
    """Program of a part: `classes` maps node names to classes, `folder` contains part.json. Returns the exit code."""
    layout = read_layout(folder)
    options = read_options(layout, folder)
    address = options.listen or options.link
    try:
        try:
            port = open_line(options)
        except KeyProblem as problem:
            print(f"error: {problem}", file=sys.stderr)
            return 3
        except OSError as error:
            print(f"error: cannot open `{address}`: {error.strerror or error}", file=sys.stderr)
            return 3
        return run(port, address, layout, classes)
    except KeyboardInterrupt:
        return 130
