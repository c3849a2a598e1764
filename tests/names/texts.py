"""Tokens of generated files, read by the rules of their languages and by nothing of the generator.

`tokens(path, text)` gives a list that comments have no part in; strings are what the program would see.
"""
import json
import re
import shlex

import yaml

LOADER = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
CPP_ESCAPES = {"n": "\n", "t": "\t", "r": "\r", "a": "\a", "b": "\b", "f": "\f", "v": "\v", "0": "\0"}


def cpp(text):
    """Tokens of C++, with the trigraphs that older compilers know and lines joined by a backslash."""
    lines = text.split("\n")
    for third, meant in zip("=/'()!<>-", "#\\^[]|{}~"):
        lines = [line if line.startswith("#include") else line.replace("??" + third, meant) for line in lines]
    text = "\n".join(lines)
    text = re.sub(r"\\[ \t]*\n", "", text)
    found = []
    at = 0
    directive = False
    while at < len(text):
        rest = text[at:at + 2]
        if text[at].isspace():
            end = re.compile(r"\s+").match(text, at).end()
            if directive and "\n" in text[at:end]:
                found.append("\n")
                directive = False
            at = end
        elif rest == "//":
            at = text.index("\n", at)
        elif rest == "/*":
            at = text.index("*/", at + 2) + 2
        elif found[-1:] == ["include"] and text[at] in "<\"":
            end = text.index(">" if text[at] == "<" else '"', at + 1)
            found.append(("header", text[at + 1:end]))
            at = end + 1
        elif text[at] == '"' or (text[at] == "'" and not text[at - 1:at].isalnum()):
            value, at = cpp_string(text, at)
            found.append(("string", value))
        else:
            word = re.compile(r"[\w.']+|[^\w\s]").match(text, at)
            directive = directive or word.group() == "#"
            found.append(word.group())
            at = word.end()
    return found


def cpp_string(text, at):
    quote = text[at]
    value = bytearray()
    at += 1
    while text[at] != quote:
        if text[at] == "\n":
            raise ValueError("a string goes over the end of a line")
        if text[at] != "\\":
            value += text[at].encode("utf-8", "surrogateescape")
            at += 1
            continue
        octal = re.compile(r"\\([0-7]{1,3})").match(text, at)
        if octal:
            value.append(int(octal.group(1), 8))
            at = octal.end()
        else:
            value += CPP_ESCAPES.get(text[at + 1], text[at + 1]).encode()
            at += 2
    return bytes(value).decode("utf-8", "surrogateescape"), at + 1


def cmake(text):
    """Commands of CMake with their arguments."""
    found = []
    at = 0
    while at < len(text):
        bracket = re.compile(r"#?\[(=*)\[").match(text, at)
        if bracket:
            end = text.index("]" + bracket.group(1) + "]", at)
            if text[at] != "#":
                found.append(("bracket", text[bracket.end():end]))
            at = end + 2 + len(bracket.group(1))
        elif text[at] == "#":
            at = text.index("\n", at)
        elif text[at].isspace():
            at += 1
        elif text[at] == '"':
            value = ""
            at += 1
            while text[at] != '"':
                if text[at] == "\\":
                    value += {"n": "\n", "t": "\t", "r": "\r"}.get(text[at + 1], text[at + 1])
                    at += 2
                else:
                    if text[at:at + 2] in ("${", "$<") or text[at] == "@":
                        value += "\0"  # is looked at by CMake: not allowed in foreign text
                    value += text[at]
                    at += 1
            found.append(("string", value))
            at += 1
        else:
            word = re.compile(r'(?:[^\s()#"\\]|\\.)+|[()]').match(text, at)
            found.append(word.group())
            at = word.end()
    return found


def depfile(text):
    """Targets and prerequisites of a rule of make."""
    text = text.replace("\\\n", " ")
    words = re.findall(r"(?:(?:\\\\)*\\[ \t]|[^ \t\n])+", text)
    blank = lambda found: "\\" * (len(found.group(1)) // 2) + found.group(2)
    return [re.sub(r"(\\+)([ \t])", blank, word).replace("\\#", "#").replace("$$", "$") for word in words]


def keys(text):
    """Lines of a form that has no quotes: what comes before the first `=`, and how many there are."""
    for line in text.split("\n"):
        if re.search(r"[\x00-\x08\x0b-\x1f\x7f]", line):
            raise ValueError(f"a control character in {line!r}")
    return [line.split("=")[0] if "=" in line and not line.startswith("#") else "line" for line in text.splitlines()]


def tokens(path, text):
    name = path.rsplit("/", 1)[-1]
    if re.search(r"\.(hpp|cpp|h|ino)$", name):
        return cpp(text)
    if name == "CMakeLists.txt" or name.endswith(".cmake"):
        return cmake(text)
    if re.search(r"\.ya?ml$", name):
        return yaml.load(text, LOADER)
    if name.endswith(".json"):
        return json.loads(text)
    if name.endswith(".sh"):
        return shlex.split(text, comments=True)
    if name.endswith(".ld"):
        return re.sub(r"/\*.*?\*/", "", text, flags=re.S).split()
    return keys(text)


def replaced(item, old, new):
    """The tokens with `old` in strings replaced, as the tokens of the other text must be."""
    if isinstance(item, dict):
        return {replaced(key, old, new): replaced(value, old, new) for key, value in item.items()}
    if isinstance(item, (list, tuple)):
        return type(item)(replaced(part, old, new) for part in item)
    return item.replace(old, new) if isinstance(item, str) else item
