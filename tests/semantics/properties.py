"""Properties that must hold for every run of any simulation."""
import random
import re
from fractions import Fraction


class Violation(Exception):
    pass


def events(printed):
    """(kind, node, tick or output) of every episode after the first reset, in the program's order: ("tick", node,
    tick, windows) before a callback, with {input: seq of its window}; ("sent", node, output, seq)."""
    episode, ended = [], False
    for line in printed.splitlines():
        word, *rest = line.split(" ")
        if word == "phase":
            ended = rest[0] == "0"
            episode.append((word,))
            continue
        if word == "reset":
            ended = bool(episode)
            continue
        if ended:
            yield [event for event in episode if event[0] != "phase" or event is not episode[-1]]
            episode, ended = [], False
        if word == "tick":
            episode.append(("tick", rest[0], int(rest[1]), {}))
        elif word == "window":
            count = int(rest[1])
            episode[-1][3][rest[0]] = [int(seq) for seq in rest[2:2 + count]]
        elif word == "sent":
            node, output = rest[0].rsplit("/", 1)
            if node == "engine":
                episode.append(("tick", node, int(rest[1]), {}))
            episode.append(("sent", node, output, int(rest[1])))
    yield episode


def check_properties(network, recording, printed):
    episodes = list(events(printed))[1:]  # without the initialisation
    for index, episode in enumerate(episodes[:len(recording.episodes)]):
        actions = [{name: tuple(value) for name, value in step["action"].items()} for step in recording.episodes[index]["steps"]]
        states = {tuple(address.split("/")): tuple(value) if isinstance(value, list) else value
                  for address, value in recording.states(index).items()}
        replay(network, states, recording.states(index + 1), actions, [event for event in episode if event[0] != "sent"])
        for event in episode:
            if event[0] == "tick":
                check_stamps(network, *event[1:])


def replay(network, states, after, actions, ticks):
    """Every callback of the program is one that a Kahn process network could run at that moment, with the engine as
    early as possible; the ticks of each node are 0, 1, 2, … at tick/rate; and time never runs back."""
    network.start(states)
    now = Fraction(0)
    zeros = {name: (0, 0) for name in network.nodes["environment"].outputs}
    for kind, *event in ticks:
        if kind == "phase":
            network.targets = {address.split("/")[0]: value for address, value in after.items() if address.endswith("/st0")}
            continue
        name, tick, _ = event
        node = network.nodes[name]
        if node.tick != tick:
            raise Violation(f"`{name}` runs tick {tick} instead of {node.tick}")
        if node.time() < now:
            raise Violation(f"`{name}` runs tick {tick} of {node.time()} s at {now} s")
        now = node.time()
        if not network.is_ready(node):
            raise Violation(f"`{name}` runs tick {tick} before it is ready")
        network.fire(node, actions + [zeros] * max(0, tick + 1 - len(actions)))


def check_stamps(network, name, tick, windows):
    """No message comes from the future; a skipped one is from an earlier instant."""
    node = network.nodes[name]
    for item in shown(node, windows):
        for seq in windows[item.name]:
            sent, now = Fraction(seq) / network.nodes[item.source].rate, node.time(tick)
            if sent > now or (item.skip and sent == now):
                raise Violation(f"`{name}` gets message {seq} of `{item.name}`, sent at {sent} s, at {now} s")


class Rings:
    """How many messages every ring must hold, by the program and by what happens."""

    def __init__(self):
        self.rings = self.reached = self.later = self.messages = 0

    def add(self, other):
        self.rings += other.rings
        self.reached += other.reached
        self.messages += other.messages
        self.later += other.later

    def __str__(self):
        return (f"{self.rings} rings of {self.messages} messages: none overflows, {self.reached} are filled in the run, "
                f"{self.later} when their rates come together later")

    def check(self, network, folder, printed):
        header = next(folder.glob("*/program.hpp")).read_text()
        memory = header[header.index("// Messages: as many"):header.index("// Simulators, engine and nodes")]
        # The comment after a member may take several lines.
        needs = re.compile(r"needs(?:\s|//)+(\d+)")
        found = {member: (int(capacity), int((needs.search(behind) or [0, 1])[1])) for member, capacity, behind in
                 re.findall(r"(\w+)_\[(\d+)\]\{\};((?:[ \n]*//[^\n]*)*)", memory)}
        held = dict.fromkeys(found, 1)
        episodes = list(events(printed))
        for episode in episodes:
            occupy(network, episode, held)
        orders = first_written(max(episodes, key=len))
        for ring, (capacity, needed) in found.items():
            if capacity != places(needed):
                raise Violation(f"ring `{ring}` has {capacity} places for {needed} messages")
            if held[ring] > needed:
                raise Violation(f"ring `{ring}` holds {needed} messages, but {held[ring]} are needed")
            self.rings += 1
            self.messages += needed
            if held[ring] == needed:
                self.reached += 1
            elif later(network, orders, ring) == needed:
                self.later += 1
            else:
                raise Violation(f"ring `{ring}` has room for {needed} messages, but {later(network, orders, ring)} are enough")


def places(needed):
    """A power of two, unless that wastes more than 256 bytes (messages have 16)."""
    power = 1 << (needed - 1).bit_length()
    return power if (power - needed) * 16 <= 256 else needed


def first_written(episode):
    """The place in the program's order of the first message of each node and of the first tick of each."""
    written, read = {}, {}
    for place, event in enumerate(episode):
        if event[0] != "phase":
            (read if event[0] == "tick" else written).setdefault(event[1], place)
    return written, read


def later(network, orders, ring):
    """The most that the ring's readers need in as many ticks as the pattern takes to repeat: for rates that come
    together too seldom for a short run."""
    written, read = orders
    most = 1
    for node in network.nodes.values():
        for item in node.inputs + node.feedthroughs:
            if ring_of(network, node, item) == ring:
                first = written[item.source] < read[node.name] or item.writes_what_it_reads(network.nodes, node)
                most = max(most, item.most_held(network.nodes, node, first))
    return most


def occupy(network, episode, held):
    """The most messages between the oldest in a window and the newest that was written, at every callback."""
    sent = {}
    for kind, *event in episode:
        if kind == "phase":
            continue
        if kind == "sent":
            name, output, seq = event
            sent[name, output] = seq + 1
            continue
        name, tick, windows = event
        node = network.nodes[name]
        for item in shown(node, windows):
            if not windows[item.name]:
                continue
            written = sent[item.source, item.output]
            if item.writes_what_it_reads(network.nodes, node):
                written = tick + 1
            ring = ring_of(network, node, item)
            held[ring] = max(held[ring], written - windows[item.name][0])


def shown(node, windows):
    """The inputs that a callback gets; of a reset node in an episode, its feedthroughs."""
    return [item for item in node.inputs + node.feedthroughs if item.name in windows]


def ring_of(network, node, item):
    def place(name, word):
        return word if name == "environment" else name.replace("/", "_")

    if item.add is not None:
        return f"{place(node.name, 'observation')}_{item.name}"
    return f"{place(item.source, 'action')}_{item.output}"


def reordered(text, seed):
    """The same graph with its objects, nodes and connections written in another order."""
    chooser = random.Random(f"order of {seed}")
    lines, blocks, result = text.splitlines(), [], []

    def flush():
        chooser.shuffle(blocks)
        result.extend(line for block in blocks for line in block)
        blocks.clear()

    section = ""
    for line in lines:
        if not line.startswith(" "):
            flush()
            section = line.split(":")[0]
            result.append(line)
        elif section not in ("objects", "nodes", "connections"):
            result.append(line)
        elif line.startswith("  ") and line[2] != " ":
            blocks.append([line])
        else:
            blocks[-1].append(line)
    flush()
    return "\n".join(result) + "\n"
