"""Forms of documents: tables that are none for GitHub, and colons with nothing behind them."""
import html.parser
import re
import subprocess

from markdown import files


class Paragraphs(html.parser.HTMLParser):
    """Text that GitHub's parser shows as running text, outside of code."""

    def __init__(self):
        super().__init__()
        self.found, self.depth, self.code = [], 0, 0

    def handle_starttag(self, tag, attributes):
        self.depth += tag in ("p", "li")
        self.code += tag in ("code", "pre")

    def handle_endtag(self, tag):
        self.depth -= tag in ("p", "li")
        self.code -= tag in ("code", "pre")

    def handle_data(self, data):
        if self.depth and not self.code:
            self.found += [line for line in data.splitlines() if re.match(r"\s*\|", line)]


def broken_tables(text):
    """Lines that begin like a row and are none."""
    made = subprocess.run(["cmark-gfm", "--extension", "table"], input=text, capture_output=True, text=True, check=True).stdout
    paragraphs = Paragraphs()
    paragraphs.feed(made)
    return paragraphs.found


def open_colons(text):
    """Numbers of lines that end with a colon before a heading, or at the end."""
    lines, fenced = text.splitlines(), False
    for i, line in enumerate(lines):
        fenced ^= bool(re.match(r"\s*(```|~~~)", line))
        if fenced or not line.rstrip().endswith(":") or line.lstrip().startswith(("|", "#")):
            continue
        behind = next((later for later in lines[i + 1:] if later.strip()), "#")
        if behind.startswith("#"):
            yield i + 1


def check_forms(root):
    problems, count = [], 0
    for path in files(root):
        if path.suffix != ".md":
            continue
        count += 1
        text, name = path.read_text(encoding="utf-8"), path.relative_to(root)
        problems += [f"{name}: no table, though it looks like one: `{line.strip()}`" for line in broken_tables(text)]
        problems += [f"{name}:{line}: a colon with nothing behind it" for line in open_colons(text)]
    return problems, f"{count} documents"
