"""The table of the worked example in runtime/SEMANTICS.md against the rule in tests/semantics/kahn.py."""
import math
import re
from fractions import Fraction

from kahn import count

SOURCE_HZ, RATE_HZ, DELAY_S = Fraction(20), Fraction(30), Fraction("0.06")
ROW = re.compile(r"^\| (\d+) \| (\S+) \| (\S+) \| (\d+) \| (.+?) \| (.+?) \| (\d+) \| (.+?) \|$")


def received(delay, skip, tick):
    """Messages up to a tick; none before tick 0."""
    return sum(count(SOURCE_HZ, RATE_HZ, delay, skip, n) for n in range(tick + 1))


def shown(first, end):
    return " ".join(str(seq) for seq in range(max(0, first), end)) or "–"


def expected(tick):
    """The cells of a row behind its tick."""
    total, skipped = received(DELAY_S, False, tick), received(Fraction(0), True, tick)
    passed = (tick / RATE_HZ - DELAY_S) * SOURCE_HZ  # the newest message whose delay has passed
    return [f"{tick}/{RATE_HZ}" if tick else "0", str(math.floor(passed)).replace("-", "−"), str(total), shown(total - 3, total),
            shown(received(DELAY_S, False, tick - 1), total), str(skipped), shown(skipped - 1, skipped)]


def check_example(root):
    path = root / "runtime" / "SEMANTICS.md"
    rows = [ROW.match(line).groups() for line in path.read_text(encoding="utf-8").splitlines() if ROW.match(line)]
    problems = [f"runtime/SEMANTICS.md: tick {tick} of the worked example: {', '.join(cells)} instead of {', '.join(expected(int(tick)))}"
                for tick, *cells in rows if cells != expected(int(tick))]
    if [int(row[0]) for row in rows] != list(range(10)):
        problems.append("runtime/SEMANTICS.md: the worked example has not the ticks 0 to 9")
    return problems, f"{len(rows)} ticks of the worked example"
