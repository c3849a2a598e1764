"""How many messages EAGERx hands over, in its doubles and exactly (runtime/SEMANTICS.md §3 and §9)."""
import functools
import math
from collections import deque
from fractions import Fraction


def meant(number):
    """The simplest fraction that rounds to a double; else its decimals."""
    fraction = Fraction(number).limit_denominator(10**6)
    return fraction if float(fraction) == number else Fraction(repr(number))


@functools.lru_cache(maxsize=None)
def divides(rate, other):
    return (meant(other) / meant(rate)).denominator == 1


class Counter:
    """Messages that one input has received: exact with Fractions, as EAGERx computes them with doubles."""

    def __init__(self, rate_in, rate, delay, skip, window):
        self.rate_in, self.rate, self.delay, self.skip = rate_in, rate, delay, skip
        self.windows = []  # for each tick [(seq, tick that first had it)]
        self.received = 0
        self.kept = deque(maxlen=window or None)

    def off(self):
        if not self.skip:
            return 0
        if self.rate <= self.rate_in:
            return -1
        if isinstance(self.rate, Fraction):
            return math.ceil(self.rate / self.rate_in) - 1
        return int((self.rate - 1e-9) / self.rate_in)

    def cumulated(self, k):
        return (self.rate_in * k - self.rate * self.rate_in * self.delay) // self.rate

    def count(self, n):
        if n == 0:
            return 0 if self.skip else 1
        delta = self.cumulated(n + self.off()) - self.cumulated(n + self.off() - 1)
        j = delta - (1 if self.skip else 0)
        t = (self.rate_in * n - self.rate * self.rate_in * self.delay - self.rate * j) / (self.rate * self.rate_in)
        return int(delta - min(delta, max(0, -math.floor(t * self.rate_in))))

    def at(self, tick):
        while len(self.windows) <= tick:
            n = len(self.windows)
            new = [(self.received + i, n) for i in range(self.count(n))]
            self.received += len(new)
            if self.kept.maxlen is None:
                self.kept.clear()
            self.kept.extend(new)
            self.windows.append(list(self.kept))
        return self.windows[tick]


class Counters:
    """Of one input: whether EAGERx's doubles are why it has other messages than we have."""

    def __init__(self, rate_in, rate, port):
        settings = port["skip"], port["window"]
        self.theirs = Counter(float(rate_in), float(rate), float(port["delay"]), *settings)
        self.exact = Counter(meant(rate_in), meant(rate), meant(port["delay"]), *settings)

    def explain(self, tick, expected, got):
        """Lists of (seq, tick that first had it)."""
        theirs, exact = self.theirs.at(tick), self.exact.at(tick)
        return theirs != exact and expected == theirs and got == exact
