"""A problem of a graph's file, and the texts that come of doing what its help says: what tests/diagnostics/helps tries."""
import re

import yaml

from yaml_nodes import Document, closed, entry_of, is_connection, is_map, merged, names_of, node_of, value_at


class Trial:
    """A problem of a case, and the texts that come of doing what its help says. Each is (text, options)."""

    def __init__(self, text, options, problem, problems):
        self.text, self.options, self.problem, self.problems = text, options, problem, problems
        span = problem["span"]
        self.line, self.column, self.length = (span["line"], span["column"], span["length"]) if span else (0, 0, 0)
        lines = text.splitlines(keepends=True)
        self.token = lines[self.line - 1][self.column - 1:][:self.length] if 0 < self.line <= len(lines) else ""

    def opened(self):
        """A fresh document, and the way to the problem; None if the text is not YAML."""
        try:
            document = Document(self.text)
        except yaml.YAMLError:
            return None, []
        return document, document.way_to(self.line, self.column)

    def with_token(self, word):
        """The text with `word` where the problem is."""
        lines = self.text.splitlines(keepends=True)
        if not 0 < self.line <= len(lines) or self.token in ("", "[", "{", "-"):
            return
        begin, line = self.column - 1, lines[self.line - 1]
        quote = self.token[:1] if self.token[:1] in "\"'" else ""
        word = word if word[:1] in "\"'" else f"{quote}{word}{quote}"
        lines[self.line - 1] = line[:begin] + word + line[begin + self.length:]
        yield "".join(lines), self.options

    def with_value(self, word):
        """The text with `word` instead of the value where the problem is, or whose key is there."""
        document, way = self.opened()
        if not way:
            return
        collection, i, is_key = way[-1]
        try:
            new = node_of(word)
        except yaml.YAMLError:
            return
        if is_map(collection):
            collection.value[i] = (collection.value[i][0], new)
        else:
            collection.value[i] = new
        yield document.text(), self.options

    def with_option(self, word):
        """The options with `word` instead of the one that the message names."""
        for named in re.findall("`([^`]*)`", self.problem["message"]):
            if named in self.options:
                yield self.text, [word if option == named else option for option in self.options]
            for option in self.options:
                if named and "," in option and named in option.split(","):
                    yield self.text, [",".join(word if part == named else part for part in each.split(",")) if each == option
                                      else each for each in self.options]

    def instead(self, word):
        """`word` instead of what is wrong, or of the part of it that the message names."""
        if not self.line:
            yield from self.with_option(word)
            return
        yield from self.with_token(word)
        for named in re.findall("`([^`]*)`", self.problem["message"])[::-1]:
            if named and named in self.token and named != self.token:
                yield from self.with_token(self.token.replace(named, word))
        if "." in self.token:
            yield from self.with_token(f"{self.token.rpartition('.')[0]}.{word}")
        yield from self.with_value(word)

    def without(self, name=None):
        """The text without the entry where the problem is, or without the nearest one around it that is called `name`."""
        document, way = self.opened()
        if document is None:
            return
        if name is None:
            if way:
                collection, i, _ = way[-1]
                del collection.value[i]
                yield document.text(), self.options
            return
        around = [collection for collection, _, _ in reversed(way)] + ([document.root] if not way else [])
        for mapping in filter(is_map, around):
            if name in names_of(mapping):
                del mapping.value[names_of(mapping).index(name)]
                yield document.text(), self.options
                return

    def connecting(self, to):
        """A connection to `to` from each of what the file sends somewhere."""
        for source in dict.fromkeys(re.findall(r"from: ([\w./]+)", self.text)):
            document, _ = self.opened()
            merged(document.root, node_of(f"{{connections: [{{from: {source}, to: {to}}}]}}"))
            yield document.text(), self.options

    def in_list(self, name, word):
        """`word` added to the list `name` of the entry around the problem, or of the graph."""
        document, way = self.opened()
        for mapping in [each for each, _, _ in way[::-1] if is_map(each)] + [document.root]:
            for key, value in mapping.value:
                if key.value == name and isinstance(value, yaml.SequenceNode):
                    value.value.append(node_of(word))
                    yield document.text(), self.options
                    return

    def entity_called(self, name):
        """The object or node that the help names, with the name that the message says is missing."""
        missing = self.problem["message"].split("`")[1]
        document, _ = self.opened()
        for key, section in document.root.value:
            for i, (entry, value) in enumerate(section.value if key.value in ("objects", "nodes") and is_map(section) else []):
                if entry.value == name:
                    section.value[i] = (node_of(missing), value)
                    yield document.text(), self.options

    def unquoted(self):
        lines = self.text.splitlines(keepends=True)
        line, begin = lines[self.line - 1], self.column - 1
        lines[self.line - 1] = line[:begin] + self.token.strip("\"'") + line[begin + self.length:]
        yield "".join(lines), self.options

    def with_option_value(self, option, value):
        if option in self.options:
            i = self.options.index(option) + 1
            yield self.text, [*self.options[:i], value, *self.options[i + 1:]]

    def without_item(self):
        """The text without the item of a list around the problem."""
        document, way = self.opened()
        for collection, i, _ in way[::-1]:
            if not is_map(collection):
                del collection.value[i]
                yield document.text(), self.options
                return

    def without_connection(self):
        """The text without the connection of the port at the problem, and without the action or the observation of it."""
        document, _ = self.opened()
        taken = []
        for key, value in document.root.value:
            if key.value == "connections":
                kept = [each for each in value.value if self.token not in [end.value for _, end in each.value]]
                used = {end.value for each in kept for _, end in each.value}
                taken = [end.value for each in value.value if each not in kept for _, end in each.value if end.value not in used]
                value.value = kept
        for end in taken:
            section, _, name = end.partition(".")
            for key, value in document.root.value:
                if key.value == section and section in ("actions", "observations"):
                    value.value = [each for each in value.value if (each[0] if isinstance(each, tuple) else each).value != name]
        yield document.text(), self.options

    def without_option(self, option):
        """The options without this one and its value."""
        if option in self.options:
            i = self.options.index(option)
            yield self.text, self.options[:i] + self.options[i + 2:]

    def without_entities(self, names):
        """The text without these objects and nodes, and without their connections."""
        document, _ = self.opened()
        if document is None:
            return
        before = document.text()
        for mapping in [value for key, value in document.root.value if key.value in ("objects", "nodes") and is_map(value)]:
            mapping.value = [(key, value) for key, value in mapping.value if key.value not in names]
        for key, value in document.root.value:
            if key.value == "connections":
                value.value = [each for each in value.value if not is_connection(each) or not any(
                    end.value.split(".")[0].split("[")[0] in names for name, end in each.value if name.value in ("from", "to"))]
        document.root.value = [(key, value) for key, value in document.root.value if value.value or key.value in ("actions", "observations")]
        if document.text() != before:
            yield document.text(), self.options

    def of_one_kind(self):
        """[] or the texts without all objects and nodes that have this problem; not of elements of an array, which stays."""
        names = [re.findall("`([^`]*)", each["message"])[0] for each in self.problems if each["code"] == self.problem["code"]]
        return [] if "[" in "".join(names) or "--of" in self.options else [self.without_entities(names)]

    def for_engine_node(self, snippet):
        """The snippet laid over the engine node, of a manifest, whose port is at the problem."""
        document, _ = self.opened()
        for engine in [each for key, value in document.root.value if key.value == "engines" for _, each in value.value]:
            for nodes in [value for key, value in engine.value if key.value == "nodes"]:
                for key, value in nodes.value:
                    if key.value == self.token.split(".")[0]:
                        merged(value, node_of("{" + snippet + "}"))
                        yield document.text(), self.options

    def choosing(self, snippet):
        """The snippet laid over the graph, and ChooseValue on the connection of its action."""
        document, _ = self.opened()
        new = node_of("{" + snippet + "}")
        action, space = new.value[0][1].value[0]
        count = int(re.search(r"high: (\d+)", snippet)[1]) + 1
        merged(document.root, new)
        for key, value in document.root.value:
            for each in value.value if key.value == "connections" else []:
                if any(end.value == f"actions.{action.value}" for _, end in each.value):
                    values = ", ".join(f"{i}.0" for i in range(count))
                    merged(each, node_of(f"{{processor: {{type: ChooseValue, config: {{values: [{values}]}}}}}}"))
        yield document.text(), self.options

    def filled(self, snippet, moved):
        """The snippet as nodes, `…` replaced: by the value at the problem if that moves there, else by one of its kind."""
        own = self.token.strip("\"'")

        if moved is not None:
            snippet = snippet.replace(f"{own}: …", f"{own}: {moved}")
        text = snippet.replace(", …}", "}")
        text = re.sub(r", (?=\})", "", text)
        if re.search(r"\[…|\{…|… |NAME", text) or re.search(r"\b[A-Z]{3,}\b", text):
            return None
        try:
            node = node_of(text)
        except yaml.YAMLError:
            return None
        return node if is_map(node) else None

    def merging(self, snippet):
        """The snippet laid over each mapping around the problem, from the inside out; with and without the entry at it."""
        for leave in (False, True):
            for depth in range(len(self.opened()[1]), -1, -1):
                document, way = self.opened()
                moved = None
                if leave and (not way or not is_map(way[-1][0]) or not way[-1][2]):
                    break
                target = value_at(way[depth]) if depth < len(way) else value_at(way[-1]) if way else document and document.root
                if leave:
                    moved = yaml.serialize(way[-1][0].value.pop(way[-1][1])[1]).strip().removesuffix("...").strip()
                    target = way[depth][0] if depth < len(way) else target
                new = self.filled(snippet, moved)
                if new is None:
                    return
                if target is not None and is_map(target):
                    merged(target, new)
                    yield document.text(), self.options
        yield from self.merging_named(snippet)

    def moving(self, snippet):
        """The entry at the problem taken away, and the snippet, with its value, laid over each mapping around it."""
        _, way = self.opened()
        collection, i, is_key = way[-1]
        own = collection.value[i][0].value
        for depth in range(len(way) - 2, -1, -1):
            document, way = self.opened()
            collection, i, _ = way[-1]
            value = yaml.serialize(collection.value.pop(i)[1]).strip().removesuffix("...").strip()
            if is_map(way[depth][0]):
                merged(way[depth][0], node_of("{" + snippet.replace(f"{own}: …", f"{own}: {value}") + "}"))
                yield document.text(), self.options

    def merging_named(self, snippet):
        """The snippet laid over the entry of an object or a node that the message names, and over the graph."""
        named = {re.split(r"[./\[]", name)[0] for name in re.findall("`([^`]+)`", self.problem["message"])}
        document, _ = self.opened()
        if document is None or not is_map(document.root):
            return
        for section in [value for key, value in document.root.value if key.value in ("objects", "nodes") and is_map(value)]:
            for name in named & set(names_of(section)):
                document, _ = self.opened()
                yield from self.over(document, lambda root: entry_of(root, name), snippet)
        document, _ = self.opened()
        yield from self.over(document, lambda root: root, snippet)

    def over(self, document, find, snippet):
        new, target = self.filled(snippet, None), find(document.root)
        if new is not None and target is not None:
            merged(target, new)
            yield document.text(), self.options

    def skipping(self, ends=None):
        """The text with `skip: true` on the connection around the problem, or on that between `ends`."""
        document, way = self.opened()
        if document is None:
            return
        found = [collection for collection, _, _ in way if is_connection(collection)]
        if way and not is_map(way[-1][0]) and is_connection(way[-1][0].value[way[-1][1]]):
            found.append(way[-1][0].value[way[-1][1]])
        for key, value in document.root.value:
            if ends and key.value == "connections":
                found = [each for each in value.value if is_connection(each) and
                         tuple(dict((name.value, end.value) for name, end in each.value if name.value in ("from", "to")).values()) == ends]
        for connection in found[:1]:
            merged(connection, node_of("{skip: true}"))
            yield document.text(), self.options

    def renamed(self, word):
        """The text with another name wherever the name of the problem stands as a whole word."""
        name = self.token.split(".")[0].strip("\"'")
        yield re.sub(rf"(?<![\w-]){re.escape(name)}(?![\w-])", word, self.text), self.options

    def moved_to(self, section):
        """The entry at the problem, moved to a section of the graph."""
        document, way = self.opened()
        if len(way) < 2 or not is_map(way[1][0]):
            return
        mapping, i, _ = way[1]
        entry = mapping.value[i]
        del mapping.value[i]
        if is_map(entry[1]) and section == "nodes":
            merged(entry[1], node_of("{rate: 30}"))
        elif is_map(entry[1]):
            entry[1].value = [each for each in entry[1].value if each[0].value not in ("rate", "config")]
        new = yaml.MappingNode("tag:yaml.org,2002:map", [(node_of(section), yaml.MappingNode("tag:yaml.org,2002:map", [entry]))])
        merged(document.root, new)
        yield document.text(), self.options

    def after(self):
        """The text after the beginning of the problem."""
        return self.text.splitlines()[self.line - 1][self.column - 1:]

    def of_kind(self, word):
        """The kind of value that the problem has, sampled in one way."""
        document, way = self.opened()
        collection, i, _ = way[-1]
        value = collection.value[i][1] if is_map(collection) else collection.value[i]
        value.value = [entry for entry in value.value if entry[0].value == word]
        if value.value:
            yield document.text(), self.options

    def line_with(self, entry):
        """The entry `key: value` where it stands in another spelling: `key = value`, `key:value`, `key: 9,5`."""
        key, _, value = entry.partition(": ")
        spelled = rf"{re.escape(key)}\s*[:=]?\s*{re.escape(value)}".replace(r"\.", "[.,]")
        yield from self.around(spelled, entry)

    def merging_all(self, snippets):
        """Several snippets laid over the mapping around the problem, after the entry at it is taken away."""
        document, way = self.opened()
        collection, i, _ = way[-1]
        del collection.value[i]
        target = [each for each, _, _ in way if is_map(each)][-1]
        for snippet in snippets:
            merged(target, node_of(f"{{{snippet}}}"))
        yield document.text(), self.options

    def as_mapping(self, keys):
        """A mapping with these keys, whose values stand there now or are of their kind, instead of the value at the problem."""
        new = self.filled(keys, None)
        if new is not None:
            closed(new, "")
            yield from self.with_value(yaml.serialize(new).strip())

    def has(self, key):
        """Whether the mapping at the problem has this key."""
        document, way = self.opened()
        value = way[-1][0].value[way[-1][1]] if way else None
        value = value[1] if isinstance(value, tuple) else value
        return value is not None and is_map(value) and key in names_of(value)

    def around(self, pattern, word):
        """The file with a match replaced, in the line of the problem, or in the nearest before or behind it that changes."""
        lines = self.text.splitlines(keepends=True)
        for i in sorted(range(len(lines)), key=lambda i: (abs(i + 1 - self.line), i)):
            changed = re.sub(pattern, word, lines[i], count=1)
            if changed != lines[i]:
                yield "".join(lines[:i] + [changed] + lines[i + 1:]), self.options
                return

    def indexed(self, index):
        """Another index behind the port or the name at the problem."""
        yield from self.with_token(re.sub(r"\[[^\]]*\]?", lambda _: index, self.token, count=1))

    def with_engine(self, engine):
        yield from self.with_option(engine)
        document, _ = self.opened()
        merged(document.root, node_of(f"{{engine: {{type: {engine}}}}}"))
        yield document.text(), self.options

    def with_rates(self, rates):
        document, _ = self.opened()
        for name, rate in rates.items():
            section = {"environment": "rate: {rate}", "engine": "engine: {{rate: {rate}}}"}[name]
            merged(document.root, node_of("{" + section.format(rate=rate) + "}"))
        yield document.text(), self.options

    def on_connection(self, snippet):
        """The snippet merged into the connection around the problem."""
        document, way = self.opened()
        for collection, _, _ in way:
            if is_connection(collection):
                merged(collection, node_of(snippet))
                yield document.text(), self.options

    def to_connection(self):
        """The entry at the problem, moved to the connection of its port."""
        document, way = self.opened()
        collection, i, _ = way[-1]
        entry = collection.value.pop(i)
        port = way[-2][0].value[way[-2][1]][0].value
        for name, value in document.root.value:
            for each in value.value if name.value == "connections" else []:
                ends = {end.value for side, end in each.value if side.value in ("from", "to")} if is_connection(each) else set()
                if any(end.split(".")[-1] == port for end in ends):
                    merged(each, yaml.MappingNode("tag:yaml.org,2002:map", [entry]))
                    yield document.text(), self.options

    def with_unit(self, unit):
        """The quantity at the problem with another unit."""
        yield from self.with_value(re.sub(r"[A-Za-z]+$", unit, self.token))

    def without_any(self, name):
        yield from self.without(name)
        yield from self.without()

    def without_line(self):
        lines = self.text.splitlines(keepends=True)
        yield "".join(lines[:self.line - 1] + lines[self.line:]), self.options


def listed(text):
    return [word.strip(" `") for word in re.split(", | and | or ", text)]


def word_or_entry(trial, word):
    """`X`: a value or a name instead of what is wrong; `key: value`: an entry around it, or the line as it should be."""
    if re.match(r"\w+: ", word):
        if "…" not in word:
            yield from trial.line_with(word)
        yield from trial.merging(word)
    elif "…" in word:
        yield from trial.as_mapping(word)
    else:
        yield from trial.instead(word)
        if word.startswith("{"):
            yield from trial.merging(word)
