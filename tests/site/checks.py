"""Problems in a folder of HTML: links, anchors, pages without a link to them."""
import collections
import html.parser
import posixpath
import re
import urllib.parse
import xml.etree.ElementTree


class Page(html.parser.HTMLParser):
    """Links and anchors of a page, and whether its elements are closed in order."""

    VOID = {"meta", "link", "img", "input", "br", "hr", "wbr", "path", "rect", "circle", "line"}

    def __init__(self, text):
        super().__init__()
        self.links, self.ids, self.open, self.problems, self.title = [], [], [], [], ""
        self.feed(text)
        if not any("closes nothing" in problem for problem in self.problems):
            self.problems += [f"<{tag}> is not closed" for tag in self.open]

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        if "id" in attributes:
            self.ids.append(attributes["id"])
        self.links += [attributes[name] for name in ("href", "src") if name in attributes]
        if tag == "img" and not attributes.get("alt"):
            self.problems.append(f"a picture without a text: {attributes.get('src')}")
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        if tag in self.VOID:
            return
        if (not self.open or self.open.pop() != tag) and not any("closes nothing" in problem for problem in self.problems):
            self.problems.append(f"</{tag}> at line {self.getpos()[0]} closes nothing")

    def handle_startendtag(self, tag, attributes):
        if "id" in dict(attributes):
            self.ids.append(dict(attributes)["id"])


def check_pictures(name, text):
    """A drawing is XML, also in a page: a browser is content with less, and draws less."""
    problems = []
    for drawing in re.findall(r"<svg\b.*?</svg>", text, re.DOTALL):
        try:
            xml.etree.ElementTree.fromstring(drawing)
        except xml.etree.ElementTree.ParseError as error:
            problems.append(f"{name}: a drawing is not XML: {error}: {drawing[:60]}")
    return problems


def check(site):
    """Problems of the folder, and how many links were followed."""
    files = {path.relative_to(site).as_posix(): path for path in sorted(site.rglob("*")) if path.is_file()}
    pages = {name: Page(path.read_text(encoding="utf-8")) for name, path in files.items() if name.endswith(".html")}
    problems, count, reached = [], 0, {name: set() for name in pages}
    for name, path in files.items():
        if name.endswith((".html", ".svg")):
            problems += check_pictures(name, path.read_text(encoding="utf-8"))
    for name, page in pages.items():
        problems += [f"{name}: {problem}" for problem in page.problems]
        problems += [f"{name}: the anchor `{one}` is there {times} times" for one, times in collections.Counter(page.ids).items() if times > 1]
        for link in page.links:
            parts = urllib.parse.urlsplit(link)
            if parts.scheme or parts.netloc:
                if not parts.scheme.startswith("http") and parts.scheme != "mailto":
                    problems.append(f"{name}: `{link}` is not an address for a page")
                continue
            count += 1
            target = posixpath.normpath(posixpath.join(posixpath.dirname(name), urllib.parse.unquote(parts.path))) if parts.path else name
            if target not in files:
                problems.append(f"{name}: `{link}` leads nowhere")
            elif parts.fragment and urllib.parse.unquote(parts.fragment) not in pages.get(target, page).ids:
                problems.append(f"{name}: `{link}` has no such place")
            elif target in pages:
                reached[name].add(target)
    return problems + unreached(reached), count


def unreached(links):
    """Pages that no way leads to from the first one."""
    seen, todo = {"index.html"}, ["index.html"]
    while todo:
        new = links.get(todo.pop(), set()) - seen
        seen |= new
        todo += sorted(new)
    return [f"{name}: no page leads here" for name in sorted(set(links) - seen)]
