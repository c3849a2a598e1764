"""Shared by all pages: head, navigation, search, theme."""
import html
import posixpath

from sources import relative

FORM = """<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>{title}eagerx-gen {version}</title>
<link rel="stylesheet" href="{top}site.css">
<script src="{top}theme.js"></script>
<script defer src="{top}search.js"></script>
</head>
<body data-top="{top}">
<header>
<a class="home" href="{top}index.html">eagerx-gen</a> <span class="version">{version}</span>
<div class="search"><input id="search" type="search" placeholder="Search ( / )" aria-label="search" autocomplete="off" spellcheck="false"
 role="combobox" aria-expanded="false" aria-controls="found"><ul id="found" role="listbox" hidden></ul></div>
<button id="theme" type="button" aria-label="light or dark">◐</button>
</header>
<div class="columns">
<nav class="site" aria-label="pages"><details class="menu"{menu}><summary>All pages</summary>{nav}</details></nav>
<main id="main">
{body}
</main>
{contents}
</div>
</body>
</html>
"""


INDEXED = ("entities/", "commands/", "codes/")  # folders whose index alone is in the navigation


class Frame:
    """`contents`: [(title of a section, [(title, page)])]."""

    def __init__(self, version, contents):
        self.version, self.contents = version, contents

    def nav(self, page):
        out = []
        for title, pages in self.contents:
            over = f"{posixpath.dirname(page)}/index.html" if page.startswith(INDEXED) else page
            open_here = " open" if any(target == over for _, target in pages) else ""
            items = "".join(f'<li><a href="{relative(page, target)}"{" aria-current=page" if target == page else ""}>'
                            f"{html.escape(name, quote=False)}</a></li>" for name, target in pages)
            out.append(f"<details{open_here}><summary>{html.escape(title, quote=False)}</summary><ul>{items}</ul></details>")
        return "".join(out)

    def __call__(self, page, title, body, headings=()):
        """The text of a page. `headings`: (level, title, anchor) for the list next to it."""
        inner = [(level, text, anchor) for level, text, anchor in headings if 2 <= level <= 3]
        contents = "".join(f'<li class="l{level}"><a href="#{anchor}">{html.escape(text, quote=False)}</a></li>'
                           for level, text, anchor in inner)
        depth = page.count("/")
        return FORM.format(
            title=html.escape(title, quote=False) + " · " if title and page != "index.html" else "", version=html.escape(self.version),
            top="../" * depth, nav=self.nav(page), menu="", body=body,
            contents=f'<nav class="page" aria-label="on this page"><ul>{contents}</ul></nav>' if len(inner) > 1 else "")

