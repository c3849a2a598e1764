"""Which file of the repository becomes which page."""
import pathlib
import posixpath
import re
import urllib.parse

PICTURES = {".png", ".svg", ".gif", ".jpg"}
TEXTS = {".yaml", ".hpp", ".cpp", ".h", ".cmake", ".py", ".sh", ".txt", ".csv", ".ld", ".json", ".toml", ".mustache", ".blank", ""}
MOST_BYTES = 200_000  # of a text that gets a page
NOT_OURS = re.compile(r"build.*|generated|out|\..*")  # at the top, as .gitignore says


class LinkError(Exception):
    """A link in a document that leads nowhere."""


def is_skipped(path):
    """Files that a build or an editor leaves behind."""
    return any(part in ("__pycache__", "generated") or part.startswith(".") for part in path.parts)


class Sources:
    """The repository: its documents, and pages for what these link to."""

    def __init__(self, root):
        self.root = pathlib.Path(root).resolve()
        every = (p.relative_to(self.root) for top in sorted(self.root.iterdir()) if not NOT_OURS.fullmatch(top.name)
                 for p in ([top] if top.is_file() else sorted(top.rglob("*.md"))))
        self.documents = [str(p) for p in every if p.suffix == ".md" and not is_skipped(p) and p.parts[0] != "tests" or
                          str(p) in ("tests/README.md", "tests/bench/README.md", "tests/conformance/README.md")]
        self.entity_folders = {}  # "models/nodes/gain": "entities/Gain.html"
        self.files = {}           # files and folders that are linked to: their pages
        self.pictures = set()     # that are shown

    def text(self, path):
        return (self.root / path).read_text(encoding="utf-8")

    def page_of(self, path):
        """The page of a document, from the top of the site."""
        folder, name = posixpath.split(path)
        if folder == "generator/support/diagnostics/codes":
            folder = "codes"
        stem = "index" if name == "README.md" else name.removesuffix(".md")
        return posixpath.join(folder, stem + ".html")

    def target(self, document, link):
        """Where a link in a document leads: a page of the site with its anchor. Unchanged if it is another site's."""
        if urllib.parse.urlsplit(link).scheme:
            return link
        name, mark, anchor = link.partition("#")
        if not name:
            return self.page_of(document) + mark + anchor
        path = posixpath.normpath(posixpath.join(posixpath.dirname(document), urllib.parse.unquote(name)))
        return self.page(path, f"{document}: `{link}`") + mark + anchor

    def page(self, path, asked_by):
        """The page that shows this file or folder; it will be made."""
        place = self.root / path
        if path in self.entity_folders:
            return self.entity_folders[path]
        if place.is_dir() and (place / "README.md").is_file() and posixpath.join(path, "README.md").removeprefix("./") in self.documents:
            return self.page_of(posixpath.join(path, "README.md").removeprefix("./"))
        if path in self.documents:
            return self.page_of(path)
        if place.suffix in PICTURES and place.is_file():
            self.pictures.add(path)
            return path
        if not place.exists():
            raise LinkError(f"{asked_by} does not exist")
        page = f"files/{path}/index.html" if place.is_dir() else f"files/{path}.html"
        self.files.setdefault(path, page)
        return page

    def shown(self, path):
        """The text of a file that has a page; None if it is none for people."""
        place = self.root / path
        if place.suffix not in TEXTS or place.stat().st_size > MOST_BYTES:
            return None
        try:
            return place.read_text(encoding="utf-8")
        except UnicodeDecodeError:
            return None

    def listing(self, path):
        """[(name, whether it is a folder)] of a folder."""
        return [(p.name, p.is_dir()) for p in sorted((self.root / path).iterdir()) if not is_skipped(pathlib.Path(p.name))]


def relative(page, target):
    """`target` as a link on `page`; both are from the top of the site."""
    if urllib.parse.urlsplit(target).scheme:
        return target
    name, mark, anchor = target.partition("#")
    if name == page:
        return mark + anchor if mark else posixpath.basename(page)
    return urllib.parse.quote(posixpath.relpath(name, posixpath.dirname(page) or ".")) + mark + anchor
