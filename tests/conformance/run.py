"""The output of our program (driver.hpp), by episode, node and tick."""


def number(word):
    return float(word) if any(letter in word for letter in ".enai") else int(word)


class Window:
    def __init__(self, count, parts):
        self.seq = [int(word) for word in parts[:count]]
        self.sent = [float(word) for word in parts[count:2 * count]]
        self.values = [number(word) for word in parts[2 * count:]]


class Tick:
    """`time`: None of the engine, which has no inputs in our programs. `phase`: in the routine of the reset nodes."""

    def __init__(self, time, phase):
        self.time, self.phase = time, phase
        self.windows = {}
        self.sent = {}
        self.callbacks = 0  # before this one


class Episode:
    """With the routine of the reset nodes that comes after it."""

    def __init__(self):
        self.phase = False
        self.ticks = {}  # node → {tick: Tick}
        self.before_engine = {}  # tick of the engine → [(node, output, seq, values)] sent since its last one
        self.simulators = {}  # (object, tick of the engine) → {"input": values, "state": values}
        self.observations = []  # {name: values}

    def rename(self, old, new):
        if old in self.ticks:
            self.ticks[new] = self.ticks.pop(old)
        for tick, sent in self.before_engine.items():
            self.before_engine[tick] = [(new if item[0] == old else item[0], *item[1:]) for item in sent]

    def tick(self, node, tick, time=None):
        ticks = self.ticks.setdefault(node, {})
        if tick not in ticks:
            ticks[tick] = Tick(time, self.phase)
            ticks[tick].callbacks = len(ticks) - 1
        return ticks[tick]


def parse(text):
    """All episodes, the initialisation too."""
    episodes, now, pending = [], None, []
    episode, ended = None, True
    for line in text.splitlines():
        word, *rest = line.split(" ")
        if word == "reset":
            ended = True
            continue
        if word == "phase":
            episode.phase, ended = rest[0] == "1", rest[0] == "0"
            continue
        if ended:
            episode, pending, ended = Episode(), [], False
            episodes.append(episode)
        if word == "window":
            now.windows[rest[0]] = Window(int(rest[1]), rest[2:])
        elif word == "tick":
            now = episode.tick(rest[0], int(rest[1]), float(rest[2]))
        elif word == "sent":
            node, output = rest[0].rsplit("/", 1)
            seq, values = int(rest[1]), [number(value) for value in rest[2:]]
            episode.tick(node, seq).sent[output] = values
            if node == "engine":
                episode.before_engine[seq] = pending
                pending = []
            else:
                pending.append((node, output, seq, values))
        elif word in ("input", "state"):
            episode.simulators.setdefault((rest[0], int(rest[1])), {})[word] = [number(value) for value in rest[2:]]
        elif word == "observation":
            episode.observations.append({})
        elif word == "seen":
            episode.observations[-1][rest[0]] = [number(value) for value in rest[1:]]
        elif word == "hash":
            break
        else:
            raise ValueError(f"line `{line}`")
    return episodes
