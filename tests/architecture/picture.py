"""The libraries of the generator as a ladder, each above those it includes, with the folders it is made of."""
import html

TOP = "generator/"
TITLE = "The libraries of eagerx-gen"
NOTE = "A library may include those below it. A dot: it does."
MARGIN, HEAD, WIDTH, GAP = 24, 62, 620, 34
LINE, ADVANCE = 17, 7.3  # of a line, and of a character of the small monospaced font
STEP = 74  # from one column of numbers to the next


def text(x, y, words, size=12, anchor="start", weight="normal", fill="#1f2328"):
    return (f'<text x="{x:g}" y="{y:g}" font-size="{size}" text-anchor="{anchor}" font-weight="{weight}" '
            f'fill="{fill}">{html.escape(words)}</text>')


def wrapped(words, width):
    """Lines of words, each at most `width` characters long."""
    lines = [""]
    for word in words:
        if lines[-1] and len(lines[-1]) + 1 + len(word) > width:
            lines.append("")
        lines[-1] += (" " if lines[-1] else "") + word
    return lines


def ladder(declared):
    """The libraries of generator/ in the order of their links, the last one first."""
    names = [t.name for t in declared.targets.values() if t.folder.startswith(TOP) and t.kind == "STATIC_LIBRARY"]
    return sorted(names, key=lambda name: (-len(declared.reach(declared.targets[name]) & set(names)), name))


def includes_between(declared, edges):
    """{(library, included library)}, of the libraries of generator/."""
    used = set()
    for a, b in edges:
        source, target = declared.library_of(a + "/x"), declared.library_of(b + "/x")
        if source and target and source is not target:
            used.add((source.name, target.name))
    return used


def box(declared, name, top):
    """The lines of a library's box, and its height."""
    target = declared.targets[name]
    folders = sorted({source.removeprefix(target.folder + "/").split("/")[0] for source in target.sources
                      if "/" in source.removeprefix(target.folder + "/")})
    foreign = sorted(declared.foreign(name) - {"fmt"}, key=str.lower)
    room = int((WIDTH - 160) / ADVANCE)
    rows = wrapped(folders or ["one folder"], room) + (wrapped(["uses"] + foreign, room) if foreign else [])
    height = 16 + LINE * len(rows)
    lines = [f'<rect x="{MARGIN}" y="{top}" width="{WIDTH}" height="{height}" rx="5" fill="#cfe8ff" stroke="#0550ae"/>',
             text(MARGIN + 14, top + 22, target.folder.removeprefix(TOP), 14, weight="bold")]
    lines += [text(MARGIN + 146, top + 21 + LINE * i, row) for i, row in enumerate(rows)]
    return lines, height


def draw(declared, edges):
    order = ladder(declared)
    lines, centers, y = [], {}, HEAD
    for name in order:
        drawn, height = box(declared, name, y)
        lines += drawn
        centers[name] = (y, height)
        y += height + GAP
    used = includes_between(declared, edges)
    left = MARGIN + WIDTH + STEP
    for column, name in enumerate(order[1:]):
        x = left + STEP * column
        lines.append(text(x, HEAD - 10, name.removeprefix("eagerx_gen_"), 12, "middle", "bold"))
        for source in order[:column + 1]:
            top, height = centers[source]
            lines.append(text(x, top + height / 2 + 4, "●" if (source, name) in used else "", 12, "middle"))
    middle = MARGIN + 60
    for upper, lower in zip(order, order[1:]):
        top, height = centers[upper]
        lines.append(f'<path d="M{middle} {top + height} V{centers[lower][0]}" stroke="#424a53" marker-end="url(#head)"/>')
    width, height = round(left + STEP * (len(order) - 1.5) + MARGIN), y - GAP + MARGIN
    head = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}" '
            'font-family="ui-monospace, \'DejaVu Sans Mono\', Menlo, Consolas, monospace" role="img">',
            "<!-- Made by tests/architecture/run. Do not edit. -->", f"<title>{TITLE}</title>",
            '<defs><marker id="head" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="8" markerHeight="8" '
            'markerUnits="userSpaceOnUse" orient="auto"><path d="M0 0 8 4 0 8z" fill="#424a53"/></marker></defs>',
            f'<rect width="{width}" height="{height}" fill="#ffffff"/>',
            text(MARGIN, 26, TITLE, 15, weight="bold"), text(MARGIN, 46, NOTE)]
    return "\n".join(head + lines + ["</svg>"]) + "\n"
