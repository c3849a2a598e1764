"""All pages of the site, in order: facts first, for documents link to them."""
import html
import json
import pathlib
import posixpath
import re

import yaml

from colours import Code
from commands import Commands
from entities import Entities
from frame import Frame
from keys import Keys
from markup import plain, rewrite
from plots import all_plots
from sources import Sources, relative
from words import Words

HERE = pathlib.Path(__file__).resolve().parent
ASSETS = ("site.css", "theme.js", "search.js")
SPEC = "generator/frontend/spec/index.html"
EXPLAINED = {  # where the graph file's page says more of a key
    "objects": "objects-sensors-actuators", "nodes": "nodes", "connections": "connections", "agent": "the-agent-and-policies",
    "task": "task", "render": "render", "safety": "safety", "telemetry": "telemetry", "budget": "budget", "allow": "warnings",
    "tunable": "tunable-parameters", "extends": "variants", "variants": "variants", "remove": "variants", "engine": "the-top-level",
}


TABLES = {  # headings of that page: which keys their tables explain
    "the-top-level": (), "objects-sensors-actuators": ("objects", "NAME"), "nodes": ("nodes", "NAME"), "connections": ("connections", "[]"),
    "spaces": ("actions", "NAME", "space"), "the-agent-and-policies": ("agent",), "task": ("task",), "render": ("render",),
    "safety": ("safety",), "telemetry": ("telemetry",), "budget": ("budget",),
}


def manifest_roots(schema):
    """The tables of manifests by kind; of what can be a composite both."""
    roots = {}
    for each in schema["allOf"]:
        kind = each["if"]["properties"]["kind"]["const"]
        then = each["then"]
        roots[(kind,)] = {"anyOf": [then["then"], then["else"]]} if "else" in then else then
    return roots


class Site:
    """`run` asks eagerx-gen, `library` is its `info --json`."""

    def __init__(self, root, run, library):
        self.sources = Sources(root)
        self.words = Words()
        self.version = run("--version").split()[-1]
        self.graph_keys = Keys("keys.html", {(): json.loads(run("schema"))})
        self.manifest_keys = Keys("manifest-keys.html", manifest_roots(json.loads(run("schema", "--manifest"))))
        self.settings_keys = Keys("settings-keys.html", {(): json.loads(run("schema", "--train-settings"))})
        self.code = Code(self.words, self.graph_keys, self.manifest_keys, self.settings_keys)
        self.commands = Commands(run, self.words, self.code)  # first: `docs linearize` opens the command, not the target
        self.entities = Entities(library, self.sources, self.words, self.code)
        self.codes = [path for path in self.sources.documents if path.startswith("generator/support/diagnostics/codes/")]
        self.add_words()
        self.find_users()
        contents = yaml.safe_load((HERE / "contents.yaml").read_text(encoding="utf-8"))
        self.frame = Frame(self.version, [(title, [(name, self.sources.page_of(page) if page.endswith(".md") else page)
                                                   for name, page in pages]) for title, pages in contents.items()])
        self.entities.pictures.update(all_plots(HERE, self.code, lambda word: f"entities/{word}.html"))
        self.drawings = {path.stem: path for path in sorted((HERE / "drawings").glob("*.png"))}
        for name in self.drawings:
            self.entities.drawings[name] = f"drawings/{name}.png"
        self.made = {}
        self.index = []  # [title, page, group, text] for the search

    def add_words(self):
        for path in self.codes:
            self.words.add(pathlib.Path(path).stem, self.sources.page_of(path))
        for place, *_ in self.graph_keys.rows:
            page = self.graph_keys.page(place)
            if len(place) == 1:
                self.words.top_keys[place[0]] = page
            self.words.add(place[-1], page)
        for anchor, place in TABLES.items():
            self.words.tables[SPEC, anchor] = lambda name, place=place: self.graph_keys.page(self.graph_keys.step(place, name) or ("",))
        for path in self.sources.documents:
            name = posixpath.basename(posixpath.dirname(path)) if path.endswith("README.md") else pathlib.Path(path).stem
            self.words.add(name.lower() or "readme", self.sources.page_of(path))
        for place, *_ in self.settings_keys.rows:
            self.words.add(place[-1], self.settings_keys.page(place))

    def find_users(self):
        """Which examples use an entity: those with a graph that names it."""
        for path in self.sources.documents:
            folder = posixpath.dirname(path)
            if posixpath.dirname(folder) != "examples":
                continue
            named = set()
            for graph in sorted((self.sources.root / folder).glob("*.yaml")):
                named |= set(re.findall(r"[A-Za-z]\w*", graph.read_text(encoding="utf-8"))) & set(self.words.entities)
            for word in sorted(named):
                self.entities.users.setdefault(word, []).append((posixpath.basename(folder), self.sources.page_of(path)))

    def add(self, page, title, body, headings, words, group):
        self.made[page] = self.frame(page, title, body, headings)
        self.index.append([title, page, group, plain(words)])

    def add_documents(self):
        for path in self.sources.documents:
            page = self.sources.page_of(path)
            made = rewrite(self.sources.text(path), page, lambda link, path=path: self.sources.target(path, link), self.words, self.code)
            self.made[page] = self.frame(page, made.title, "".join(made.out), made.contents)
            group = "code" if path in self.codes else "page"
            if group == "code":
                self.index.append([made.title, page, group, plain(word for section in made.sections for word in section[2])])
                continue
            for title, anchor, words in made.sections:
                if not title:
                    continue
                here = page if title == made.title else f"{page}#{anchor}"
                shown = title if title == made.title else f"{title} · {made.title}"
                self.index.append([shown, here, group if title == made.title else "section", plain(words)])

    def add_facts(self):
        for entity in self.entities.all:
            self.add(*self.entities.page(entity), "entity")
        self.add(*self.entities.index(), "page")
        for name in self.commands.names:
            self.add(*self.commands.page(name), "command")
        for name in self.commands.topics:
            self.add(*self.commands.topic(name), "page")
        self.add(*self.commands.index(), "page")
        self.add_codes()
        self.add_keys(self.graph_keys, "key", "Keys of the graph file", f'What the JSON schema says of each key (<code>eagerx-gen schema</code>). '
                      f'<a href="{SPEC}">The graph file, key by key</a> explains them.', EXPLAINED)
        self.add_keys(self.manifest_keys, "manifest key", "Keys of manifests", 'What the JSON schema says of each key '
                      '(<code>eagerx-gen schema --manifest</code>), by the kind of manifest. <a href="models/index.html#keys-of-a-manifest">Models</a> explains them.', {})
        self.add_keys(self.settings_keys, "setting", "Settings of a training", 'What <code>train --settings FILE.yaml</code> takes, from the '
                      'JSON schema (<code>eagerx-gen schema --train-settings</code>). '
                      '<a href="targets/environments/train/index.html#settings">The trainer</a> explains them.', {})

    def add_keys(self, keys, group, title, text, explained):
        links = {name: f"{SPEC}#{anchor}" for name, anchor in explained.items()}
        if any(len(place) > 1 for place, *_ in keys.rows):
            text += " NAME is a name that you give, [] an item of a list."
        self.add(keys.page_name, title, f"<h1>{title}</h1>\n<p>{text}</p>\n" + keys.html(links), [], [], "page")
        for place, schema, *_ in keys.rows:
            self.index.append([".".join(place), keys.page(place), group, schema.get("description", "")])

    def add_codes(self):
        rows = []
        for path in self.codes:
            title = self.sources.text(path).splitlines()[0].removeprefix("# ")
            code, _, about = title.partition(": ")
            rows.append(f'<tr><td><a href="{code}.html"><code>{code}</code></a></td><td>{html.escape(about)}</td></tr>')
        self.add("codes/index.html", "Errors and warnings", "<h1>Errors and warnings</h1>\n<p>What <code>eagerx-gen explain CODE</code> "
                 f'prints.</p>\n<div class="wide"><table><tbody>{"".join(rows)}</tbody></table></div>', [], [], "page")

    def add_files(self):
        """Pages of the files that documents link to; a folder's page leads to its files, but makes no pages for them."""
        for path, page in sorted(self.sources.files.items()):
            if page.endswith("/index.html"):
                rows = []
                for name, is_folder in self.sources.listing(path):
                    inner = f"{path}/{name}"
                    target = self.sources.entity_folders.get(inner) or self.sources.files.get(inner) or \
                        (self.sources.page_of(inner) if inner in self.sources.documents else None)
                    shown = html.escape(name) + ("/" if is_folder else "")
                    rows.append(f'<li><a href="{relative(page, target)}">{shown}</a></li>' if target else f"<li>{shown}</li>")
                body = f"<ul>{''.join(rows)}</ul>"
            else:
                text = self.sources.shown(path)
                language = {".yaml": "yaml", ".hpp": "cpp", ".cpp": "cpp", ".h": "cpp", ".py": "python"}.get(pathlib.Path(path).suffix, "text")
                body = self.code.block(text, language, page) if text is not None else \
                    f"<p>{(self.sources.root / path).stat().st_size} bytes, which are not text for people.</p>"
            self.made[page] = self.frame(page, path, f'<p class="kind">file</p><h1>{html.escape(path)}</h1>\n{body}')

    def files(self):
        """{path: text or bytes} of the whole site."""
        self.add_facts()
        self.add_documents()
        self.add_files()
        files = dict(self.made)
        files.update({path: (self.sources.root / path).read_bytes() for path in self.sources.pictures})
        files.update({f"drawings/{name}.png": path.read_bytes() for name, path in self.drawings.items()})
        files.update({name: (HERE / name).read_bytes() for name in ASSETS})
        files["words.json"] = json.dumps(dict(sorted(self.words.pages.items())), ensure_ascii=False, indent=0) + "\n"
        files["index-of-search.js"] = "globalThis.siteIndex = " + json.dumps(self.index, ensure_ascii=False, separators=(",", ":")) + ";\n"
        return files
