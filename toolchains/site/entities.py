"""A page for every entity, from what `eagerx-gen info --json` says of it."""
import html
import json
import re
import textwrap

from sources import relative
from symbols import symbol

KINDS = [("object", "Objects"), ("node", "Nodes"), ("reset node", "Reset nodes"), ("processor", "Processors"), ("engine", "Engines"),
         ("engine node", "Engine nodes"), ("engine state", "Engine states"), ("target", "Targets")]
PORTS = [("sensors", "Sensors"), ("actuators", "Actuators"), ("inputs", "Inputs"), ("outputs", "Outputs"), ("targets", "Targets")]


def page_of(entity):
    return f"entities/{entity['id']}.html"


def escape(text):
    return html.escape(str(text), quote=False)


def number(value):
    """A number as written in a graph, a list in brackets; a long list becomes its first and its last number."""
    if isinstance(value, list):
        return "[" + ", ".join(number(item) for item in value) + "]"
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float):
        return f"{value:.6g}"
    return str(value)


def bounds(port):
    if "low" not in port and "high" not in port:
        return ""
    low, high = number(port.get("low", "")), number(port.get("high", ""))
    return f"{low} … {high}" if low != high else f"= {low}"


def table(heads, rows):
    if not rows:
        return ""
    used = [i for i in range(len(heads)) if any(row[i] for row in rows)]
    head = "".join(f"<th>{heads[i]}</th>" for i in used)
    body = "\n".join("<tr>" + "".join(f"<td>{row[i]}</td>" for i in used) + "</tr>" for row in rows)
    return f'<div class="wide"><table><thead><tr>{head}</tr></thead><tbody>\n{body}\n</tbody></table></div>'


class Entities:
    """`users`: {id: [(title, page) of examples that use it]}."""

    def __init__(self, library, sources, words, code):
        self.library, self.sources, self.words, self.code = library, sources, words, code
        self.all = library["entities"] + library["targets"]
        self.users = {}
        self.pictures = {}  # id: HTML of responses
        self.drawings = {}  # id: picture, from the top of the site
        for entity in self.all:
            words.add_entity(entity["id"], page_of(entity))
            if "manifest" in entity and not entity["manifest"].startswith(".."):
                sources.entity_folders[entity["manifest"].rpartition("/")[0]] = page_of(entity)
        self.made_of = {}  # id of an engine node or state: objects that have it
        for entity in self.all:
            for made in entity.get("made_for", []):
                for part in made.get("nodes", []) + made.get("states", []):
                    self.made_of.setdefault(part["type"], {})[entity["id"]] = None

    def link(self, page, name):
        target = self.words.entity(name)
        return f'<a href="{relative(page, target)}">{escape(name)}</a>' if target else escape(name)

    def about(self, page, text):
        """A text of a manifest: what stands between backquotes is code, entities and codes are links."""
        shown = self.words.in_text(escape(text), lambda target, word: f'<a href="{relative(page, target)}">{word}</a>'
                                   if target != page else word)
        return re.sub(r"`([^`\n]+)`", r"<code>\1</code>", shown)

    def description(self, page, text):
        """Paragraphs; lines that are set in become equations, as they stand. Sources have a paragraph of their own."""
        out, lines = [], text.splitlines()
        while lines:
            inset = lines[0].startswith("  ")
            taken = []
            while lines and (lines[0].startswith("  ") == inset or not lines[0].strip()):
                taken.append(lines.pop(0))
            if inset:
                out.append('<pre class="equation" tabindex="0">' + self.about(page, textwrap.dedent("\n".join(taken)).rstrip()) + "</pre>")
            else:
                out += [f"<p>{self.about(page, part)}</p>" for part in re.split(r"\n\s*\n|\n(?=Source)", "\n".join(taken)) if part.strip()]
        return "\n".join(out)

    def ports(self, page, ports):
        rows = []
        for port in ports:
            space = f"like {port['like']}" if "like" in port else " ".join(
                str(part) for part in (port.get("dtype", "any dtype"), number(port["shape"]) if "shape" in port else "any shape"))
            notes = [f"{word} {number(port[word])}{unit}" for word, unit in
                     (("window", ""), ("delay", " s"), ("max_delay", " s")) if word in port]
            notes += [word for word in ("skip", "optional") if port.get(word)]
            if port.get("running"):
                notes.append("can be set while it runs")
            if "eagerx" in port:
                notes.append(f"in EAGERx <code>{escape(port['eagerx'])}</code>")
            rate = f"{number(port['rate'])} Hz" if "rate" in port else ""
            rows.append((f"<code>{port['name']}</code>", escape(space), escape(bounds(port)), escape(port.get("unit", "")), escape(rate),
                         self.about(page, port.get("about", "")) + (f" <i>({', '.join(notes)})</i>" if notes else "")))
        return table(("name", "message", "bounds", "unit", "rate", "what it is"), rows)

    def parameters(self, page, parameters):
        rows = []
        for p in parameters:
            kind = " | ".join(f"<code>{word}</code>" for word in p["options"]) if "options" in p else escape(p["type"])
            if "engine" in p:
                kind += " " + self.link(page, p["engine"])
            limits = " ".join(f"{sign} {number(p[word])}" for word, sign in (("low", "≥"), ("high", "≤")) if word in p)
            notes = [{"running": "tunable while it runs", "reset": "tunable at a reset"}[p["tunable"]]] if "tunable" in p else []
            if "eagerx" in p:
                notes.append(f"in EAGERx <code>{escape(p['eagerx'])}</code>")
            default = f"<code>{escape(json.dumps(p['default']) if isinstance(p['default'], str) else number(p['default']))}</code>" \
                if "default" in p else "required"
            rows.append((f"<code>{p['name']}</code>", kind, escape(p.get("unit", "")), default, escape(limits),
                         self.about(page, p.get("about", "")) + (f" <i>({', '.join(notes)})</i>" if notes else "")))
        return table(("parameter", "type", "unit", "default", "range", "what it says"), rows)

    def engines(self, page, entity):
        rows = []
        for made in entity.get("made_for", []):
            parts = [self.link(page, part) for part in dict.fromkeys(p["type"] for p in made.get("nodes", []))]
            states = [self.link(page, part) for part in dict.fromkeys(p["type"] for p in made.get("states", []))]
            rows.append((self.link(page, made["engine"]), "yes" if made["vectorized"] else "no", self.header(page, entity, made.get("model")),
                         ", ".join(parts), ", ".join(states), self.about(page, made.get("summary", ""))))
        return table(("engine", "vectorized", "model", "engine nodes", "engine states", "note"), rows)

    def header(self, page, entity, cpp):
        if not cpp or not cpp.get("header"):
            return ""
        path = cpp["header"]
        if not (self.sources.root / path).is_file():
            return escape(path)
        return f'<a href="{relative(page, self.sources.page(path, entity["id"]))}"><code>{escape(path.rpartition("/")[2])}</code></a>'

    def facts(self, page, entity):
        rows = [("kind", escape(entity["kind"]))]
        if entity["kind"] not in ("object", "target", "engine state") and "composite" not in entity:
            rows.append(("vectorized (SIMD lanes)", {True: "yes", False: "no, one lane after the other"}.get(
                entity["vectorized"], "with some parameters")))
        for name, title in (("engines", "works on"), ("runs", "runs what is made for")):
            if name in entity:
                rows.append((title, ", ".join(self.link(page, each) for each in entity[name])))
        if "eagerx" in entity:
            rows.append(("in EAGERx", ", ".join(f"<code>{escape(each['id'])}</code>" for each in entity["eagerx"])))
        for name, title in (("system", "needs"), ("family", "family of boards")):
            if name in entity:
                rows.append((title, escape(entity[name])))
        for name, title in (("packages", "libraries"), ("moves", "sets what changes"), ("counts", "counts")):
            if name in entity:
                rows.append((title, escape(", ".join(entity[name]))))
        rows += [(escape(name), f"<code>{escape(value)}</code>") for name, value in entity.get("facts", {}).items()]
        if "manifest" in entity and (self.sources.root / entity["manifest"]).is_file():
            manifest = self.sources.page(entity["manifest"], entity["id"])
            code = self.header(page, entity, entity.get("cpp"))
            rows.append(("files", f'<a href="{relative(page, manifest)}"><code>manifest.yaml</code></a> {code}'))
        if entity["id"] in self.made_of:
            rows.append(("part of", ", ".join(self.link(page, each) for each in self.made_of[entity["id"]])))
        if entity["id"] in self.users:
            rows.append(("used by", ", ".join(f'<a href="{relative(page, target)}">{escape(title)}</a>'
                                              for title, target in self.users[entity["id"]])))
        return table(("", ""), rows).replace("<thead><tr><th></th><th></th></tr></thead>", "")

    def inside(self, page, entity):
        """Of a composite the graph in its manifest, as it stands."""
        if "composite" not in entity:
            return ""
        text = self.sources.text(entity["manifest"])
        return self.code.block(text[text.index("\ngraph:") + 1:], "yaml", page)

    def drawing(self, page, entity):
        if entity["id"] not in self.drawings:
            return ""
        return (f'<img class="drawing" src="{relative(page, self.drawings[entity["id"]])}" width="320" height="240" '
                f'alt="a drawing of {escape(entity["id"])}" title="as `--render` draws it at the beginning">')

    def page(self, entity):
        """(page, title, HTML, headings, text for the search)."""
        page = page_of(entity)
        parts, headings = [], []

        def section(title, content):
            if content:
                anchor = title.lower().replace(" ", "-")
                headings.append((2, title, anchor))
                parts.append(f'<h2 id="{anchor}">{title}</h2>\n{content}')

        if entity["kind"] != "target":
            parts.append(f'<figure>{symbol(entity)}{self.drawing(page, entity)}</figure>')
        parts.append(self.description(page, entity.get("description", "")))
        section("Response", self.pictures.get(entity["id"], ""))
        for name, title in PORTS:
            section(title, self.ports(page, entity.get(name, [])))
        section("Parameters", self.parameters(page, entity.get("config", [])))
        section("States", self.ports(page, entity.get("states", [])))
        section("Requires", table(("condition", "because"), [(f"<code>{escape(each['that'])}</code>", self.about(page, each["because"]))
                                                             for each in entity.get("requires", [])]))
        section("Inside", self.inside(page, entity))
        section("Made for", self.engines(page, entity))
        section("Facts", self.facts(page, entity))
        head = (f'<p class="kind"><a href="{relative(page, "entities/index.html")}">{escape(entity["kind"])}</a></p>'
                f'<h1>{escape(entity["id"])}</h1>\n<p class="summary">{self.about(page, entity["summary"])}</p>\n')
        words = [entity["summary"], entity.get("description", "")]
        for name in ("sensors", "actuators", "inputs", "outputs", "states", "targets", "config"):
            words += [f"{each['name']} {each.get('about', '')}" for each in entity.get(name, [])]
        return page, entity["id"], head + "\n".join(parts), headings, words

    def index(self):
        page = "entities/index.html"
        parts, headings = ["<h1>Entities</h1>\n<p>What a graph can be made of. Each page is made from the entity's manifest.</p>"], []
        for kind, title in KINDS:
            rows = [(self.link(page, each["id"]), self.about(page, each["summary"])) for each in self.all if each["kind"] == kind]
            anchor = title.lower().replace(" ", "-")
            headings.append((2, title, anchor))
            parts.append(f'<h2 id="{anchor}">{title} ({len(rows)})</h2>\n' + table(("id", "what it is"), rows))
        return page, "Entities", "\n".join(parts), headings, []
