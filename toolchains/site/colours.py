"""Blocks of code: colours, and links from the words that have a page."""
import html
import re

import yaml

from sources import relative

CPP = re.compile(r"(?P<c>//[^\n]*|/\*.*?\*/)|(?P<s>\"(?:\\.|[^\"\\\n])*\"|'(?:\\.|[^'\\\n])+')|"
                 r"(?P<p>^[ \t]*\#[ \t]*\w+)|"
                 r"(?P<k>\b(?:class|struct|template|typename|using|namespace|const|constexpr|static|inline|return|if|else|for|while|"
                 r"auto|void|int|float|double|bool|public|private|true|false|enum|requires|concept|noexcept|explicit|operator)\b)",
                 re.DOTALL | re.MULTILINE)
PYTHON = re.compile(r"(?P<c>#[^\n]*)|(?P<s>\"(?:\\.|[^\"\\\n])*\"|'(?:\\.|[^'\\\n])*')|"
                    r"(?P<k>\b(?:def|class|return|import|from|if|elif|else|for|while|in|not|and|or|with|as|lambda|None|True|False)\b)")
SHELL = re.compile(r"(?P<c>(?:^|(?<=\s))#[^\n]*)|(?P<x>\beagerx-gen(?: [a-z]+)?\b)|(?P<e>\b[EW]\d{4}\b)", re.MULTILINE)
LANGUAGES = {"cpp": CPP, "c++": CPP, "hpp": CPP, "c": CPP, "python": PYTHON, "py": PYTHON}
LOADER = getattr(yaml, "CSafeLoader", yaml.SafeLoader)


def span(kind, text):
    return f'<span class="{kind}">{html.escape(text, quote=False)}</span>'


def coloured(text, rule):
    out, at = [], 0
    for match in rule.finditer(text):
        out += [html.escape(text[at:match.start()], quote=False), span(match.lastgroup, match.group())]
        at = match.end()
    return "".join(out) + html.escape(text[at:], quote=False)


class Code:
    def __init__(self, words, graph_keys, manifest_keys, settings_keys):
        self.words, self.graph_keys, self.manifest_keys, self.settings_keys = words, graph_keys, manifest_keys, settings_keys

    def block(self, text, language, page):
        """A block as HTML. Without a language it is typed text, or output of a program."""
        if language in ("yaml", "yml"):
            shown = self.yaml(text, page)
        elif language in LANGUAGES:
            shown = coloured(text, LANGUAGES[language])
        else:
            shown = self.typed(text, page)
        return f'<pre tabindex="0"><code>{shown}</code></pre>'

    def link(self, page, target, text):
        return f'<a href="{relative(page, target)}">{html.escape(text, quote=False)}</a>'

    def typed(self, text, page):
        out, at = [], 0
        for match in SHELL.finditer(text):
            out.append(html.escape(text[at:match.start()], quote=False))
            target = None if match.lastgroup == "c" else self.words.of_code(match.group(), page)
            out.append(self.link(page, target, match.group()) if target else
                       span("c", match.group()) if match.lastgroup == "c" else html.escape(match.group(), quote=False))
            at = match.end()
        return "".join(out) + html.escape(text[at:], quote=False)

    def yaml(self, text, page):
        """Keys lead to their rows, ids to their entities. What is not YAML (an excerpt with dots) has no links."""
        marks = []
        try:
            for root in yaml.compose_all(text, Loader=LOADER):
                if root is not None:
                    keys, place = self.root_of(root)
                    self.walk(root, keys, place, page, marks)
        except yaml.YAMLError:
            marks = []
        out, at = [], 0
        for begin, end, opening in sorted(marks):
            if begin >= at:
                closing = "</a>" if opening.startswith("<a") else "</span>"
                out += [self.between(text[at:begin]), opening, html.escape(text[begin:end], quote=False), closing]
                at = end
        return "".join(out) + self.between(text[at:])

    @staticmethod
    def between(text):
        return coloured(text, re.compile(r"(?P<c>(?:^|(?<=\s))#[^\n]*)|(?P<s>\"[^\"\n]*\")", re.MULTILINE))

    def root_of(self, root):
        """Which keys an excerpt has: a whole graph or manifest, settings of a training, entities, connections."""
        if isinstance(root, yaml.SequenceNode):
            return self.graph_keys, ("connections",)
        if not isinstance(root, yaml.MappingNode):
            return None, ()
        names = {key.value for key, _ in root.value if isinstance(key, yaml.ScalarNode)}
        if "kind" in names:
            kind = next(value.value for key, value in root.value if key.value == "kind")
            return self.manifest_keys, (kind,)
        if names == {"graph"}:  # of a composite's manifest
            return self.manifest_keys, ("node",)
        if names & self.graph_keys.top:
            return self.graph_keys, ()
        if names and names <= self.settings_keys.top:
            return self.settings_keys, ()
        if {"from", "to"} <= names:
            return self.graph_keys, ("connections", "[]")
        inner = {key.value for _, value in root.value if isinstance(value, yaml.MappingNode) for key, _ in value.value if isinstance(key, yaml.ScalarNode)}
        if inner & {"type", "policy"}:
            return self.graph_keys, ("nodes" if inner & {"rate", "policy", "inputs", "outputs"} else "objects",)
        return None, ()

    def walk(self, node, keys, place, page, marks):
        """Adds (begin, end, how it is shown) for every key, and for values that are entities."""
        if isinstance(node, yaml.SequenceNode):
            for item in node.value:
                self.walk(item, keys, place + ("[]",) if place is not None else None, page, marks)
        elif isinstance(node, yaml.MappingNode):
            for key, value in node.value:
                if not isinstance(key, yaml.ScalarNode):
                    continue
                below = keys.step(place, key.value) if keys and place is not None else None
                target = keys.page(below) if below is not None else None
                marks.append((key.start_mark.index, key.end_mark.index,
                              f'<a class="k" href="{relative(page, target)}">' if target else '<span class="n">'))
                self.walk(value, keys, below, page, marks)
        elif isinstance(node, yaml.ScalarNode) and node.style is None:
            target = self.words.entity(node.value)
            if target and target != page:
                marks.append((node.start_mark.index, node.end_mark.index, f'<a href="{relative(page, target)}">'))
