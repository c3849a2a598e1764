"""The libraries of the generator as a layered drawing. What it shows comes from the links alone."""
import hashlib
import html
import pathlib

import layout

TOP = "generator/"
SPINE = ("read", "eagerx-gen")  # in the middle: the longest chain between these two
WAY_END = "emit"  # up to here it is the way of a graph
TITLE = "The stages of eagerx-gen and who links whom"
NOTES = (
    "An arrow leads from a library to those that link it and may include it.",
    "What follows from two arrows has none of its own.",
)

MARGIN, GAP_X, GAP_Y, PADDING = 24, 22, 34, 12
NAME_SIZE, SMALL_SIZE = 14, 12
NAME_ADVANCE, SMALL_ADVANCE = 8.6, 7.4  # of a character of a monospaced font, with something to spare
LINE, HEAD = 16, 78
KINDS = {  # fill, stroke, what it means
    "way": ("#cfe8ff", "#0550ae", "the way from a graph to a program's text"),
    "stage": ("#f1f3f5", "#57606a", "other stages"),
    "other": ("#fff3c4", "#7d5a00", "folders beside generator/"),
    "program": ("#d3f5dc", "#116329", "programs"),
}


class Box:
    def __init__(self, label, kind, libraries):
        self.label, self.kind, self.libraries = label, kind, libraries
        self.width = 2 * PADDING + max([len(label) * NAME_ADVANCE] + [len(l) * SMALL_ADVANCE for l in libraries])
        self.height = 30 + LINE * len(libraries)


def shown(declared):
    """{name: names of what it links}: the targets of generator/, and what they link, without what others imply."""
    todo = [t.name for t in declared.targets.values() if t.folder.startswith(TOP)]
    links = {}
    while todo:
        name = todo.pop()
        if name not in links:
            links[name] = declared.below(name)
            todo += links[name]

    def all_below(name):
        return links[name].union(*(all_below(library) for library in links[name]))

    return {name: {library for library in below if not any(library in all_below(other) for other in below - {library})}
            for name, below in links.items()}


def longest_chain(links, first, last):
    """Names from `first`, which is linked, to `last`; the first one in the alphabet of equally long ones."""
    chains = {first: [first]}

    def chain(name):
        if name not in chains:
            below = [chain(library) for library in sorted(links[name])]
            best = max((c for c in below if c), key=len, default=None)
            chains[name] = best + [name] if best else None
        return chains[name]

    return chain(last) or []


def boxes_of(declared, links):
    label = {}
    for name in links:
        target = declared.targets[name]
        label[name] = name if target.kind == "EXECUTABLE" else target.folder.removeprefix(TOP)
    by_label = {label[name]: name for name in links}
    spine = longest_chain(links, by_label[SPINE[0]], by_label[SPINE[1]])
    way = spine[:spine.index(by_label[WAY_END]) + 1]
    boxes = {}
    for name in links:
        target = declared.targets[name]
        if target.kind == "EXECUTABLE":
            kind = "program"
        elif not target.folder.startswith(TOP):
            kind = "other"
        else:
            kind = "way" if name in way else "stage"
        of_others = [] if kind == "program" else sorted(declared.foreign(name) - {"fmt"}, key=str.lower)
        boxes[name] = Box(label[name], kind, of_others)
    return boxes, spine, way


def text(x, y, words, size=SMALL_SIZE, anchor="middle", weight="normal", fill="#1f2328"):
    return (f'<text x="{x:g}" y="{y:g}" font-size="{size}" text-anchor="{anchor}" font-weight="{weight}" '
            f'fill="{fill}">{html.escape(words)}</text>')


def box_svg(box, x, top):
    fill, stroke, _ = KINDS[box.kind]
    width = round(box.width)
    lines = [f'<rect x="{x - width / 2:g}" y="{top:g}" width="{width}" height="{box.height}" rx="5" fill="{fill}" '
             f'stroke="{stroke}" stroke-width="{2 if box.kind == "way" else 1}"/>',
             text(x, top + 20, box.label, NAME_SIZE, weight="bold")]
    lines += [text(x, top + 20 + LINE * (i + 1), library) for i, library in enumerate(box.libraries)]
    return lines


def edge_svg(points, color, width):
    """`points`: x, top and bottom of the line's way through each row; it is straight there, and curved between rows."""
    path = f"M{points[0][0]:g} {points[0][1]:g}"
    for (x0, _, y0), (x1, y1, _) in zip(points, points[1:]):
        middle = (y0 + y1) / 2
        path += f" V{y0:g} C{x0:g} {middle:g} {x1:g} {middle:g} {x1:g} {y1:g}"
    return f'<path d="{path}" fill="none" stroke="{color}" stroke-width="{width}" marker-end="url(#head)"/>'


def sum_of(*texts):
    return hashlib.sha256("\n".join(texts).encode()).hexdigest()


def stamp(declared):
    """What the picture depends on: the libraries, and how they are drawn."""
    links = shown(declared)
    boxes, spine, way = boxes_of(declared, links)
    seen = [(name, boxes[name].label, boxes[name].kind, boxes[name].libraries, sorted(links[name])) for name in sorted(links)]
    code = [pathlib.Path(module).read_text() for module in (__file__, layout.__file__)]
    return sum_of(repr((seen, spine, way)), *code)


def sealed(body, declared):
    """With two sums, so that a picture is known to be right without drawing it again: see `is_of`."""
    return f"{body}<!-- of {stamp(declared)}, drawn as {sum_of(body)} -->\n"


def is_of(drawn, declared):
    """Whether `drawn` was drawn of these libraries with this code, and not changed since."""
    body, end, _ = drawn.rpartition("<!-- of ")
    return bool(end) and drawn == sealed(body, declared)


def draw(declared):
    links = shown(declared)
    boxes, spine, way = boxes_of(declared, links)
    rows, columns, ways = layout.place(links, spine)
    # Columns as wide as their widest box, rows as high as their highest.
    used = sorted({columns[item] for item in columns})
    widths = {c: max([24] + [boxes[n].width for n in boxes if columns[n] == c]) for c in used}
    center, x = {}, MARGIN
    for c in used:
        center[c] = round(x + widths[c] / 2)
        x += widths[c] + GAP_X
    heights = [max((boxes[n].height for n in boxes if rows[n] == r), default=0) for r in range(max(rows.values()) + 1)]
    tops, y = [], HEAD
    for height in heights:
        tops.append(y)
        y += height + GAP_Y
    total_width = max(round(x - GAP_X + MARGIN), 640)
    legend_top = y
    total_height = legend_top + LINE * 2 * ((len(KINDS) + 1) // 2) + 8

    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{total_width}" height="{total_height}" '
             f'viewBox="0 0 {total_width} {total_height}" '
             'font-family="ui-monospace, \'DejaVu Sans Mono\', Menlo, Consolas, monospace" role="img">',
             "<!-- Made by tests/architecture/run. Do not edit. -->",
             f"<title>{TITLE}</title>",
             '<defs><marker id="head" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="8" markerHeight="8" '
             'markerUnits="userSpaceOnUse" orient="auto"><path d="M0 0 8 4 0 8z" fill="#424a53"/></marker></defs>',
             f'<rect width="{total_width}" height="{total_height}" fill="#ffffff"/>',
             text(MARGIN, 26, TITLE, 15, "start", "bold")]
    lines += [text(MARGIN, 46 + LINE * i, note, anchor="start") for i, note in enumerate(NOTES)]
    for source, target in sorted(ways):
        points = []
        for item in ways[source, target]:
            row = rows[item]
            begin = tops[row] + (boxes[item].height if item == source else 0)
            points.append((center[columns[item]], begin, tops[row] + heights[row]))
        on_way = source in way and target in way
        lines.append(edge_svg(points, KINDS["way"][1] if on_way else "#424a53", 2 if on_way else 1))
    for name in sorted(boxes):
        lines += box_svg(boxes[name], center[columns[name]], tops[rows[name]])
    for i, (fill, stroke, meaning) in enumerate(KINDS.values()):
        left, top = MARGIN + (i % 2) * (total_width // 2), legend_top + 2 * LINE * (i // 2)
        lines.append(f'<rect x="{left}" y="{top}" width="22" height="16" rx="3" fill="{fill}" stroke="{stroke}"/>')
        lines.append(text(left + 30, top + 13, meaning, anchor="start"))
    return sealed("\n".join(lines + ["</svg>"]) + "\n", declared)
