"""Nodes of YAML files, which keep their styles: what tests/diagnostics/trials changes."""
import yaml

# Values for what a help leaves open, by the key before it.
OPEN = {
    "low": "-1.0", "high": "1.0", "dtype": "float32", "shape": "[1]", "rate": "30", "delay": "0.01", "max_delay": "0.1",
    "window": "1", "skip": "true", "mean": "0.0", "std": "1.0", "at_most": "1 s", "after": "10 s", "over_last": "1 s",
    "value": "0.0", "processor": "GetIndex", "success": "0.9", "return": "100", "weight": "1.0"
}


class Document:
    """The nodes of a YAML file, which keep their styles."""

    def __init__(self, text):
        self.root = yaml.compose(text)

    def text(self):
        return yaml.serialize(self.root, width=100000, allow_unicode=True).replace("!!null ''", "")

    def way_to(self, line, column):
        """[(collection, index, is_key)] from the root to the node that begins there; () if there is none."""

        def seek(node, way):
            """The innermost one: a block begins where its first key does."""
            is_mapping = is_map(node)
            if not is_mapping and not isinstance(node, yaml.SequenceNode):
                return None
            for i, entry in enumerate(node.value):
                key, child = entry if is_mapping else (None, entry)
                if key is not None and at(key):
                    return [*way, (node, i, True)]
                found = seek(child, [*way, (node, i, False)])
                if found or at(child):
                    return found or [*way, (node, i, False)]
            return None

        def at(node):
            return (node.start_mark.line + 1, node.start_mark.column + 1) == (line, column)

        return seek(self.root, []) or []


def node_of(text):
    return yaml.compose(text)


def is_map(node):
    return isinstance(node, yaml.MappingNode)


def names_of(mapping):
    return [key.value for key, _ in mapping.value]


def merged(into, new):
    """`new` laid over the mapping `into`: mappings are merged, lists are continued, what is open (`…`) stays as it is, the
    rest is replaced, also a space with another `dtype`."""
    for key, value in new.value:
        names = names_of(into)
        if key.value not in names:
            into.value.append((key, closed(value, key.value)))
            continue
        i = names.index(key.value)
        own = into.value[i][1]
        if value.value == "…":
            continue
        if is_map(value) and isinstance(own, yaml.SequenceNode) and key.value in ("actions", "observations"):
            own = node_of("{" + ", ".join(f"{name.value}: {{}}" for name in own.value) + "}")
            into.value[i] = (into.value[i][0], own)
        if is_map(own) and is_map(value) and "dtype" not in names_of(value):
            merged(own, value)
        elif key.value in ("connections", "critic") and isinstance(own, yaml.SequenceNode):
            own.value += value.value
        else:
            into.value[i] = (into.value[i][0], closed(value, key.value))


def closed(node, key):
    """The node with values of their kind for what is open."""
    if is_map(node):
        node.value = [(name, closed(value, name.value)) for name, value in node.value]
    return node_of(OPEN.get(key, "1")) if node.value == "…" else node


def value_at(step):
    """The node at a step of a path."""
    collection, i, _ = step
    return collection.value[i][1] if is_map(collection) else collection.value[i]


def is_connection(node):
    return is_map(node) and {"from", "to"} <= set(names_of(node))


def entry_of(root, name):
    """The mapping of the object or node of this name."""
    for key, section in root.value:
        for entry, value in section.value if key.value in ("objects", "nodes") and is_map(section) else []:
            if entry.value == name and is_map(value):
                return value
    return None
