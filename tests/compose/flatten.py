#!/usr/bin/env python3
"""The output of `eagerx-gen info --flat`, as a handwritten graph.

    flatten.py FLAT.yaml OUT.yaml     names of what is inside become identifiers: arm/leg[2] → arm_ab
    flatten.py --names FLAT.yaml TEXT         the same names in a generated text, on the standard output
"""
import re
import sys

KEY = re.compile(r"^  '?([A-Za-z][\w/\[\]]*)'?:")


def inner_names(flat):
    """Of objects and nodes, the longest first."""
    names, section = [], ""
    for line in flat.splitlines():
        if line[:1].isalpha():
            section = line.split(":")[0]
        found = KEY.match(line)
        if section in ("objects", "nodes") and found and re.search(r"[/\[]", found.group(1)):
            names.append(found.group(1))
    return sorted(names, key=len, reverse=True)


def snake(name):
    return name.replace("]", "").replace("[", "_").replace("/", "_")


def camel(name):
    return "".join(part[:1].upper() + part[1:] for part in snake(name).split("_"))


def identifiers(names):
    """For each name an identifier that is sorted among the others as the name is: channels are numbered in this order."""
    letters = "abcdefghijklmnopqrstuvwxyz"
    ranks = {name: rank for rank, name in enumerate(sorted(names, key=lambda name: (name + "/").encode()))}
    return {name: f"{re.split('[/[]', name)[0]}_{letters[rank // 26]}{letters[rank % 26]}" for name, rank in ranks.items()}


def renamed(text, names):
    """The names, and in C++ what is made of them."""
    new = identifiers(names)
    forms = {}
    for name in names:  # arrays of equal nodes are called by what their names have in common
        for end in [found.start() for found in re.finditer(r"[/[]", name)]:
            base = re.split("[/[]", name)[0]
            forms.update({camel(name[:end]): camel(base), snake(name[:end]): base})
    for name, flat in new.items():
        forms.update({camel(name): camel(flat), snake(name): flat, name: flat})
    for form in sorted(forms, key=len, reverse=True):
        text = re.sub(r"(?<![A-Za-z0-9_/])(k(?:NamesOf|ChannelOf)?)?" + re.escape(form) + r"(?![0-9a-z]|_[0-9])", lambda found: (found.group(1) or "") + forms[form], text)
    return text


def main():
    if sys.argv[1] == "--names":
        with open(sys.argv[2]) as flat, open(sys.argv[3]) as text:
            sys.stdout.write(renamed(text.read(), inner_names(flat.read())))
        return
    with open(sys.argv[1]) as file:
        flat = file.read()
    with open(sys.argv[2], "w") as file:
        file.write(renamed(re.sub(r"^library:.*$", "", flat, flags=re.M), inner_names(flat)))


if __name__ == "__main__":
    main()
