"""Words that have a page: entities, targets, codes, commands, keys."""
import re


class Words:
    """`pages`: {word: page}, for `eagerx-gen docs WORD`. Where two things have a name, the first one that is added keeps it."""

    def __init__(self):
        self.pages = {}
        self.entities = {}
        self.commands = {}
        self.top_keys = {}
        self.tables = {}  # (page, anchor): which keys the tables below this heading explain, as a function from name to page

    def add(self, word, page):
        self.pages.setdefault(word, page)

    def entity(self, word):
        return self.entities.get(word)

    def add_entity(self, word, page):
        self.entities[word] = page
        self.add(word, page)

    def of_code(self, text, page):
        """The page of what stands between backquotes: `Pendulum`, `E0307`, `eagerx-gen train …`, `budget:`."""
        target = self.entities.get(text)
        if re.fullmatch(r"[EW]\d{4}", text):
            target = self.pages.get(text)
        elif text.startswith("eagerx-gen"):
            target = self.command(text)
        elif text.endswith(":"):
            target = self.top_keys.get(text[:-1])
        return None if target == page else target

    def of_row(self, page, anchor, name):
        """The page of a key that a table explains; None if it is none."""
        table = self.tables.get((page, anchor))
        return table(name) if table else None

    def command(self, text):
        """The page of `eagerx-gen COMMAND …`; a graph in its place is short for generate."""
        typed = text.split()[1:]
        if not typed:
            return None
        return self.commands.get(typed[0])

    def in_text(self, text, link):
        """A text of a manifest as HTML (already escaped), in which entities and codes are links."""
        def shown(match):
            target = self.entities.get(match.group()) or (self.pages.get(match.group()) if match.group()[1:].isdigit() else None)
            return link(target, match.group()) if target else match.group()
        return re.sub(r"\b(?:[A-Z][A-Za-z0-9]+|[EW]\d{4})\b", shown, text)
