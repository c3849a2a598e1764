"""Figures that documents say: each has one source, or all that say it say the same (figures.yaml)."""
import re

import yaml

WORDS = "zero one two three four five six seven eight nine ten eleven twelve thirteen fourteen fifteen sixteen".split()


def number_of(text):
    """12, `12,990`, `3'000'000`, "nine"; a version stays a text."""
    if text.lower() in WORDS:
        return float(WORDS.index(text.lower()))
    plain = text.replace(",", "").replace("'", "")
    return float(plain) if re.fullmatch(r"\d+(?:\.\d+)?", plain) else text


def part_of(text, rule):
    """Between the patterns `from` and `to`, where the rule has them."""
    if "from" in rule:
        text = text[re.search(rule["from"], text).end():]
    if "to" in rule:
        text = text[:re.search(rule["to"], text).start()]
    return text


def right_one(root, rule):
    text = part_of((root / rule["in"]).read_text(encoding="utf-8"), rule)
    if "count" in rule:
        return float(len(re.findall(rule["count"], text, re.MULTILINE))) - rule.get("less", 0)
    value = number_of(".".join(re.search(rule["value"], text, re.MULTILINE).groups()))
    return round(value * rule["times"], 9) if "times" in rule else value


def said_by(root, documents):
    """(document, what it says, its number); None where the pattern finds nothing."""
    for name, patterns in documents.items():
        text = re.sub(r"\n(?:/// )?(?=\w)", " ", (root / name).read_text(encoding="utf-8")) if name.endswith(".hpp") else \
            (root / name).read_text(encoding="utf-8")
        for pattern in [patterns] if isinstance(patterns, str) else patterns:
            found = re.search(pattern.replace(" ", r"\s+"), text, re.MULTILINE)
            yield name, found.group(1) if found else None


def check_figures(root):
    place = root / "tests" / "documents" / "figures.yaml"
    figures = yaml.safe_load(place.read_text(encoding="utf-8")) if place.is_file() else []
    problems = []
    for figure in figures:
        right = right_one(root, figure["is"]) if "is" in figure else None
        for name, said in said_by(root, figure["said"]):
            if said is None:
                problems.append(f"{name}: nothing is said of {figure['what']}, though figures.yaml says so")
                continue
            right = number_of(said) if right is None else right
            if number_of(said) != right:
                shown = f"{right:g}" if isinstance(right, float) else right
                problems.append(f"{name}: `{said}` is not the number of {figure['what']}: {shown}")
    return problems, f"{len(figures)} figures"
