"""The promises of a version, as lists: tests/commands/stability compares them with those of earlier versions, and
tests/data/stability/add writes them."""
import ast
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
HEADER = ROOT / "targets/environments/eagerx_environments.h"
PACKAGE = ROOT / "targets/environments/python/eagerx_gen"
PROTOCOL = ROOT / "targets/PROTOCOL.md"
SCHEMAS = {"graph": [], "manifest": ["--manifest"], "train-settings": ["--train-settings"], "train-sweep": ["--train-sweep"]}
EXPERIMENTAL = "(experimental)"


def functions_of_library():
    """Functions of the C interface."""
    text = HEADER.read_text(encoding="utf-8")
    return set(re.findall(r"\b(eagerx_\w+)\(", re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL)))


def names_of_package():
    """Public names of the Python package, and public methods of its classes with their arguments: `Env.step(action)`."""
    names = set(re.findall(r'"(\w+)"', re.search(r"__all__ = \[(.*?)\]", (PACKAGE / "__init__.py").read_text(encoding="utf-8"), re.DOTALL)[1]))
    for path in sorted(PACKAGE.glob("*.py")):
        for node in ast.parse(path.read_text(encoding="utf-8")).body:
            if isinstance(node, ast.FunctionDef) and node.name in names:
                names |= arguments_of(node, node.name)
            if isinstance(node, ast.ClassDef) and (node.name in names or path.name.startswith(("gymnasium", "real_time", "stable_baselines3"))):
                for inner in node.body:
                    if isinstance(inner, ast.FunctionDef) and (inner.name == "__init__" or not inner.name.startswith("_")):
                        names |= arguments_of(inner, f"{node.name}.{inner.name}")
    return names


def arguments_of(function, name):
    """`name()`, and `name(argument)` for each argument."""
    all_of = function.args.posonlyargs + function.args.args + function.args.kwonlyargs
    return {f"{name}()"} | {f"{name}({each.arg})" for each in all_of if each.arg not in ("self", "library")}


def commands_of(rows, help_of):
    """Rows of the table of commands, without what is experimental. `help_of`: the first line of a command's help."""
    young = {name for name in {row["command"] for row in rows} if any(help_of(" ".join(name.split()[:i + 1])).endswith(EXPERIMENTAL)
                                                                      for i in range(len(name.split())))}
    return [row for row in rows if row["command"] not in young and not row["about"].endswith(EXPERIMENTAL)]


def codes_of(explained):
    return set(re.findall(r"\b[EW]0\d{3}\b", explained))


def first_elements(value):
    """JSON with each list cut to its first element."""
    if isinstance(value, dict):
        return {key: first_elements(each) for key, each in value.items()}
    return [first_elements(each) for each in value[:1]] if isinstance(value, list) else value


def missing_keys(old, new, place):
    """Keys and types of `old` that `new` does not have. Lists may grow: some element must be like the first one of `old`."""
    if isinstance(old, dict):
        if not isinstance(new, dict):
            yield place
            return
        for key, value in old.items():
            if key in new:
                yield from missing_keys(value, new[key], f"{place}.{key}")
            else:
                yield f"{place}.{key}"
    elif isinstance(old, list):
        if not isinstance(new, list) or (old and not new):
            yield place
        elif old:
            yield from min((list(missing_keys(old[0], each, f"{place}[]")) for each in new), key=len)
    elif isinstance(old, bool) != isinstance(new, bool) or isinstance(old, str) != isinstance(new, str):
        yield place


def narrower(old, new, place):
    """Where a JSON schema accepts less than an earlier one: a key or a choice is gone, a bound is tighter, more is required."""
    if isinstance(old, list) and isinstance(new, list):
        # Alternatives: each old one must be within a new one.
        for i, each in enumerate(old):
            yield from min((list(narrower(each, other, f"{place}[{i}]")) for other in new), key=len, default=[f"{place}[{i}]"])
        return
    if not isinstance(old, dict) or not isinstance(new, dict):
        if old != new:
            yield place
        return
    for key in ("anyOf", "allOf"):
        if key in old:
            yield from narrower(old[key], new.get(key, []), f"{place}.{key}") if key in new else [f"{place}.{key}"]
    if "anyOf" in new and "anyOf" not in old:  # one form has become several
        yield from min((list(narrower(old, each, place)) for each in new["anyOf"]), key=len)
        return
    for key, value in old.get("properties", {}).items():
        if key in new.get("properties", {}):
            yield from narrower(value, new["properties"][key], f"{place}.{key}")
        elif new.get("additionalProperties", True) is not True:
            yield f"{place}.{key}"
    for key in ("additionalProperties", "items", "if", "then", "else", "propertyNames"):
        if isinstance(old.get(key), dict):
            yield from narrower(old[key], new.get(key, {}), f"{place}.{key}") if isinstance(new.get(key), (dict, type(None))) else []
    if {*new.get("required", [])} - {*old.get("required", [])}:
        yield f"{place} requires {', '.join(sorted({*new['required']} - {*old.get('required', [])}))}"
    if "enum" in new and ("enum" not in old or not {*map(str, old["enum"])} <= {*map(str, new["enum"])}):
        yield f"{place} lacks {', '.join(sorted({*map(str, old.get('enum', ['anything']))} - {*map(str, new['enum'])}))}"
    for key, sign in (("minimum", 1), ("exclusiveMinimum", 1), ("minItems", 1), ("maximum", -1), ("exclusiveMaximum", -1), ("maxItems", -1)):
        if key in new and (key not in old or sign * new[key] > sign * old[key]):
            yield f"{place} {key} {new[key]}"
    if "type" in new and not {*types_of(old)} <= {*types_of(new)}:
        yield f"{place} is {new['type']}"


def types_of(schema):
    kinds = schema.get("type", ["anything"])
    return [kinds] if isinstance(kinds, str) else kinds


def frames_of_page():
    """[(bytes in hex, kind, number, payload in hex)] of the session in the page of the protocol, as the part in Python reads them."""
    rows = []
    example = PROTOCOL.read_text(encoding="utf-8").partition("\n## An example in bytes\n")[2].partition("\n## ")[0]
    for line in re.findall(r"^(?:hub|part): +([0-9a-f ]+)$", example, re.MULTILINE):
        rows.append((line, *read_frame(line, first_greeting(rows))))
    return rows


def first_greeting(rows):
    """The greeting that the checksums of a session begin from; None before it."""
    return bytes.fromhex(rows[0][3]) if rows else None


def read_frame(line, greeting):
    """(kind, number, payload in hex) of a frame, read with targets/python. Its checksum must be right. `greeting`: of the hello."""
    program = ("import sys; sys.path.insert(0, sys.argv[1]); import eagerx_link as link\n"
               "kind, number, payload, body = link.decode_frame(bytes.fromhex(sys.argv[2]).strip(b'\\0'))\n"
               "link.check_crc(body, link.crc32c(bytes.fromhex(sys.argv[3])) if kind > link.WELCOME else 0)\n"
               "print(kind, number, payload.hex())")
    python = next((each for each in (sys.executable, "/usr/bin/python3")
                   if subprocess.run([each, "-c", "import numpy"], capture_output=True, check=False).returncode == 0), sys.executable)
    done = subprocess.run([python, "-B", "-c", program, str(ROOT / "targets/python"), line, greeting.hex() if greeting else ""],
                          capture_output=True, text=True, check=False)
    words = (done.stdout.split(" ") + ["", ""])[:3]
    return (words[0], words[1], words[2].strip()) if done.returncode == 0 else (done.stderr, "", "")


def without_texts(schema):
    """A JSON schema without what only people read."""
    if isinstance(schema, dict):
        return {key: without_texts(value) for key, value in schema.items() if not (key in ("description", "title", "$id") and isinstance(value, str))}
    return [without_texts(each) for each in schema] if isinstance(schema, list) else schema
