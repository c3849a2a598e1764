"""Responses of entities as SVG, from what their generated program wrote (responses.csv)."""
import cmath
import csv
import html
import io
import math
import re

import yaml

WIDTH, HEIGHT = 400, 210
LEFT, RIGHT, TOP, BOTTOM = 46, 12, 26, 34
FLOOR_DB = -80.0
LOADER = getattr(yaml, "CSafeLoader", yaml.SafeLoader)


def read_table(text):
    """{column: values} of a table that a program wrote; a message with one element goes by its name alone."""
    rows = list(csv.reader(io.StringIO(text)))
    table = {name: [float(row[i]) if row[i] else math.nan for row in rows[1:]] for i, name in enumerate(rows[0])}
    for name in list(table):
        if name.endswith("[0]") and name[:-3] + "[1]" not in table:
            table[name[:-3]] = table[name]
    return table


def ticks(low, high, most=6):
    """Round numbers within the range."""
    raw = (high - low) / most
    power = 10.0 ** math.floor(math.log10(raw))
    step = next(power * factor for factor in (1, 2, 5, 10) if power * factor >= raw * 0.999)
    first = math.ceil(low / step - 1e-9)
    return [i * step for i in range(first, math.floor(high / step + 1e-9) + 1)]


def shown(value):
    return f"{value + 0.0:.6g}".replace("-", "−")


class Axes:
    """Places of points in a picture; x may be logarithmic."""

    def __init__(self, x, y, log_x=False):
        self.x, self.y, self.log_x = x, y, log_x

    def at(self, x, y):
        (x0, x1), (y0, y1) = self.x, self.y
        if self.log_x:
            x, x0, x1 = math.log10(x), math.log10(x0), math.log10(x1)
        return (LEFT + (x - x0) / (x1 - x0) * (WIDTH - LEFT - RIGHT), HEIGHT - BOTTOM - (y - y0) / (y1 - y0) * (HEIGHT - TOP - BOTTOM))

    def x_ticks(self):
        if not self.log_x:
            return ticks(*self.x)
        low, high = (math.log10(end) for end in self.x)
        return [factor * 10.0 ** power for power in range(math.floor(low), math.ceil(high) + 1) for factor in (1, 2, 5)
                if low - 1e-9 <= math.log10(factor * 10.0 ** power) <= high + 1e-9]

    def grid(self, x_name, y_name):
        out = []
        for value in ticks(*self.y):
            _, y = self.at(self.x[0], value)
            out.append(f'<path class="grid" d="M{LEFT} {y:.1f}H{WIDTH - RIGHT}"/>'
                       f'<text x="{LEFT - 6}" y="{y + 4:.1f}" text-anchor="end">{shown(value)}</text>')
        for value in self.x_ticks():
            x, _ = self.at(value, self.y[0])
            out.append(f'<path class="grid" d="M{x:.1f} {TOP}V{HEIGHT - BOTTOM}"/>'
                       f'<text x="{x:.1f}" y="{HEIGHT - BOTTOM + 15}" text-anchor="middle">{shown(value)}</text>')
        return "".join(out) + (f'<text x="{WIDTH - RIGHT}" y="{HEIGHT - 4}" text-anchor="end">{html.escape(x_name)}</text>'
                               f'<text x="4" y="14">{html.escape(y_name)}</text>')

    def curve(self, xs, ys, number, stairs=False):
        points = [self.at(x, y) for x, y in zip(xs, ys) if math.isfinite(y)]
        path = "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in points)
        if stairs:
            path = "M" + f"{points[0][0]:.1f} {points[0][1]:.1f}" + "".join(f"H{x:.1f}V{y:.1f}" for x, y in points[1:])
        return f'<path class="curve c{number}" d="{path}"/>'


def span_of(columns):
    values = [value for column in columns for value in column if math.isfinite(value)]
    low, high = min(values), max(values)
    margin = (high - low or 1.0) * 0.06
    return low - margin, high + margin


def picture(title, inner):
    return (f'<svg class="plot" role="img" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}">'
            f"<title>{html.escape(title)}</title>{inner}</svg>")


def legend(names):
    """The names of curves in their colours, above the picture, from the right."""
    out, x = [], WIDTH - RIGHT
    for i, name in reversed(list(enumerate(names))):
        width = 6.5 * len(name)
        out.append(f'<text class="name" x="{x:.1f}" y="14" text-anchor="end">{html.escape(name)}</text>'
                   f'<path class="curve c{i}" d="M{x - width - 20:.1f} 10h15"/>')
        x -= width + 32
    return "".join(out)


def over_time(table, names):
    times, columns = table["time_s"], [table[name] for name in names]
    axes = Axes((times[0], times[-1]), span_of(columns))
    curves = "".join(axes.curve(times, column, i, stairs=True) for i, column in enumerate(columns))
    return picture(f"{', '.join(names)} over time", axes.grid("s", "") + curves + legend(names))


def over_input(table, source, result):
    axes = Axes(span_of([table[source]]), span_of([table[result]]))
    return picture(f"{result} over {source}", axes.grid("input", "output") + axes.curve(table[source], table[result], 1))


def frequency_response(times, step, answer):
    """(frequencies in Hz, gains in dB): the answer to the step, differenced, is that to an impulse (both at one rate)."""
    period = times[1] - times[0]
    begin = next(i for i, value in enumerate(step) if value != step[0])
    impulse = [b - a for a, b in zip([answer[begin - 1]] + answer[begin:], answer[begin:])]
    top = 0.5 / period
    frequencies = [top * 10.0 ** (-2.0 + 2.0 * i / 120) for i in range(120)]
    gains = [abs(sum(h * cmath.exp(-2j * math.pi * f * period * n) for n, h in enumerate(impulse))) for f in frequencies]
    return frequencies, [max(20.0 * math.log10(gain), FLOOR_DB) if gain > 0.0 else FLOOR_DB for gain in gains]


def bode(table, source, result):
    frequencies, gains = frequency_response(table["time_s"], table[source], table[result])
    low, high = min(gains), max(gains)
    axes = Axes((frequencies[0], frequencies[-1]), (math.floor(low / 10) * 10, math.ceil((high + 1) / 10) * 10), log_x=True)
    return picture(f"gain of {result} over frequency", axes.grid("Hz", "dB") + axes.curve(frequencies, gains, 1))


def node_text(graph, name):
    """The lines of a node in the graph's file."""
    return re.search(rf"^  {name}:.*\n(?:    .*\n)*", graph, re.MULTILINE).group()


def all_plots(folder, code, page_of):
    """{id: HTML}: the pictures, and the lines of the graph that they are of."""
    graph = (folder / "responses.yaml").read_text(encoding="utf-8")
    table = read_table((folder / "responses.csv").read_text(encoding="utf-8"))
    made = {}
    for plot in yaml.load((folder / "plots.yaml").read_text(encoding="utf-8"), Loader=LOADER):
        names = plot["curves"]
        pictures = [over_time(table, names)]
        if plot.get("over"):
            pictures.append(over_input(table, *names))
        if plot.get("bode"):
            pictures.append(bode(table, *names))
        about = plot.get("about", {"step": "the answer to a step"}.get(names[0], "the input and the output")
                         + (", and the gain over the frequency, up to half the rate" if plot.get("bode") else ""))
        about = re.sub(r"`([^`]+)`", r"<code>\1</code>", html.escape(about))
        made[plot["entity"]] = (f'<div class="plots">{"".join(pictures)}</div>'
                                f"<p>Recorded from the generated program of this node at 100 Hz: {about}.</p>"
                                + code.block("nodes:\n" + node_text(graph, plot["node"]), "yaml", page_of(plot["entity"])))
    return made
