"""Keys of graph files and manifests, from the JSON schemas that `eagerx-gen schema` prints."""
import html
import json
import re


def alternatives(schema):
    """The schema and all that it may be instead."""
    yield schema
    for word in ("anyOf", "oneOf", "allOf"):
        for inner in schema.get(word, []):
            yield from alternatives(inner)


def range_of(schema):
    """Bounds of a number as they follow the word: ` 0 to 1`, ` ≥ 0`."""
    low, high = schema.get("minimum"), schema.get("maximum")
    if low is not None and high is not None:
        return f" {low:.10g} to {high:.10g}"
    for sign, bound in (("≥", low), ("≤", high), ("&gt;", schema.get("exclusiveMinimum"))):
        if bound is not None:
            return f" {sign} {bound:.10g}"
    return ""


def shape_of(schema):
    """The description of a value in words."""
    kinds = []
    for each in alternatives(schema):
        if "enum" in each:
            kinds.append(" | ".join(f"<code>{html.escape(str(word))}</code>" for word in each["enum"]))
        elif isinstance(each.get("type"), str):
            kinds.append({"object": "mapping", "array": "list", "string": "text", "integer": "whole number",
                          "boolean": "true or false"}.get(each["type"], each["type"]) + range_of(each))
        elif isinstance(each.get("type"), list):
            kinds.append("mapping" if "object" in each["type"] else "value")
    return " or ".join(dict.fromkeys(kinds)) or "any value"


class Keys:
    """Every key by its place: ("nodes", "NAME", "rate"). What has the same keys as an earlier place leads there."""

    def __init__(self, page, roots):
        """`roots`: {place: schema}."""
        self.page_name = page
        self.rows = []     # (place, schema, required, place with the same keys or None)
        self.anchors = {}  # place: anchor
        self.same = {}     # text of a schema: its first place
        self.moved = {}    # place: first place with the same keys
        for place, schema in roots.items():
            self.read(place, schema)
        self.begun = {place[:i] for place in self.anchors for i in range(1, len(place) + 1)}
        self.top = {place[0] for place, *_ in self.rows if len(place) == 1}

    def read(self, place, schema):
        for each in alternatives(schema):
            for name, inner in each.get("properties", {}).items():
                here = place + (name,)
                if here in self.anchors:
                    continue
                self.anchors[here] = ".".join(here)
                row = [here, inner, name in each.get("required", []), None]
                self.rows.append(row)  # above those of what is below it
                row[3] = self.go_on(here, inner)
            for word, name in (("additionalProperties", "NAME"), ("items", "[]")):
                if isinstance(each.get(word), dict) and each[word]:
                    self.read(place + (name,), each[word])

    def go_on(self, here, schema):
        """Reads what is below a key, unless it is like another one; the place of that."""
        text = json.dumps({k: v for k, v in schema.items() if k != "description"}, sort_keys=True)
        if '"properties"' not in text:
            return None
        if text in self.same:
            self.moved[here] = self.same[text]
            return self.same[text]
        self.same[text] = here
        self.read(here, schema)
        return None

    def step(self, place, name):
        """The place of a key below `place`; None if there is none."""
        place = self.moved.get(place, place)
        if place + (name,) in self.anchors:
            return place + (name,)
        anything = place + ("NAME",)
        return anything if anything in self.begun else None

    def page(self, place):
        """Page and anchor of a key; None of a name that the user gives."""
        return f"{self.page_name}#{self.anchors[place]}" if place in self.anchors else None

    def html(self, explained):
        """All keys as one table. `explained`: {first word of a place: link to the text about it}."""
        rows = []
        for place, schema, required, same in self.rows:
            about = re.sub(r"`([^`]+)`", r"<code>\1</code>", html.escape(schema.get("description", ""), quote=False))
            notes = []
            if required:
                notes.append("required")
            if same:
                notes.append(f'keys as in <a href="#{self.anchors[same]}">{".".join(same)}</a>')
            if len(place) == 1 and place[0] in explained:
                notes.append(f'<a href="{explained[place[0]]}">more</a>')
            before = "".join(f"{word}.<wbr>" for word in place[:-1])
            name = f'<span class="faint">{before}</span><b>{place[-1]}</b>'
            rows.append(f'<tr id="{self.anchors[place]}"><td class="key"><code>{name}</code></td><td>{shape_of(schema)}</td>'
                        f'<td>{about}{"; " if about and notes else ""}{", ".join(notes)}</td></tr>')
        return ('<div class="wide entries"><table class="keys"><thead><tr><th>key</th><th>value</th><th>what it says</th></tr></thead><tbody>'
                + "\n".join(rows) + "</tbody></table></div>")
