"""Block symbols: a box with the ports of an entity, drawn from its manifest."""
import html
import re

CHARACTER = 6.9  # width of a letter, in the symbol's 12-pixel font
ROW = 26
ENDS = {"object": ("actuators", "sensors"), "processor": ("inputs", "outputs")}


def width_of(texts):
    return max((len(text) for text in texts), default=0) * CHARACTER


def label(port):
    return port["name"]


def size_of(port):
    """`[4] rad`, as it stands at the wire."""
    shape = port.get("shape")
    parts = []
    if isinstance(shape, list) and shape:
        parts.append("[" + ", ".join(re.sub(r"\$\((?:config |size )?([^()]*)\)", r"\1", str(n)) for n in shape) + "]")
    if port.get("unit"):
        parts.append(port["unit"])
    return " ".join(parts)


def text(x, y, words, anchor="start", kind=""):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}"{f" class={chr(34)}{kind}{chr(34)}" if kind else ""}>{html.escape(words)}</text>'


def arrow(x, y, length, dashed):
    """To the right, with its point at x + length."""
    kind = ' class="dashed"' if dashed else ""
    line = f'<path d="M{x:.1f} {y:.1f}h{length:.1f}"{kind}/>'
    return line + f'<path class="tip" d="M{x + length:.1f} {y:.1f}l-7 -3.5v7z"/>'


def symbol(entity):
    """SVG. Ports that a graph may leave out are dashed; states come from below, targets of reset nodes from above."""
    kind = entity["kind"]
    into, out = ENDS.get(kind, ("inputs", "outputs"))
    left, right = entity.get(into, []), entity.get(out, [])
    below = [port for port in entity.get("states", []) if not port.get("optional")]
    above = entity.get("targets", [])
    inner = max(width_of([entity["id"]]) + 24, width_of(map(label, left)) + width_of(map(label, right)) + 40,
                150)
    margin_left = max(width_of(map(size_of, left)), 30) + 26
    margin_right = max(width_of(map(size_of, right)), 30) + 26
    rows = max(len(left), len(right), 1)
    top = 24 * len(above) + 8
    height = rows * ROW + 34
    full = margin_left + inner + margin_right
    out_parts = [f'<rect x="{margin_left:.1f}" y="{top}" width="{inner:.1f}" height="{height}" rx="4"/>',
                 text(margin_left + inner / 2, top + 19, entity["id"], "middle", "id")]
    for i, port in enumerate(left):
        y = top + 40 + i * ROW
        out_parts += [arrow(4, y, margin_left - 4, port.get("optional")), text(margin_left + 8, y + 4, label(port)),
                      text(margin_left - 12, y - 5, size_of(port), "end", "faint")]
    for i, port in enumerate(right):
        y = top + 40 + i * ROW
        out_parts += [arrow(margin_left + inner, y, margin_right - 6, port.get("optional")),
                      text(margin_left + inner - 8, y + 4, label(port), "end"),
                      text(margin_left + inner + 8, y - 5, size_of(port), "start", "faint")]
    for i, port in enumerate(above):
        out_parts.append(text(margin_left + 14, 14 + 24 * i, f"▾ target {label(port)}", "start", "faint"))
    for i, port in enumerate(below):
        out_parts.append(text(margin_left + 14, top + height + 17 + 18 * i, f"▴ state {label(port)}", "start", "faint"))
    total = top + height + 18 * len(below) + 10
    title = f'<title>{html.escape(entity["id"])}: ' + html.escape(
        ", ".join(p["name"] for p in left) or "nothing") + " → " + html.escape(", ".join(p["name"] for p in right) or "nothing") + "</title>"
    return (f'<svg class="symbol" role="img" viewBox="0 0 {full:.0f} {total}" width="{full:.0f}" height="{total}">{title}'
            + "".join(out_parts) + "</svg>")
