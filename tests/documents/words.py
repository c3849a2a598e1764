"""Words to avoid, in documents and in all other texts: words.yaml lists them, and the files that may keep some."""
import re

import yaml

from markdown import files, prose

PLACE = "tests/documents/words.yaml"
BEFORE = "instead of"  # the head of a table's first column, which quotes what not to write


def pattern_of(words, before=r"[\w-]", after=r"[\w-]"):
    """One expression for all words; each is whole, and `*` in it is any end of a word."""
    parts = [re.escape(word).replace(r"\*", r"\w*") for word in sorted(words, key=len, reverse=True)]
    return re.compile(rf"(?<!{before})(?:{'|'.join(parts)})(?!{after})", re.IGNORECASE)


def sentences(text):
    """(line, text) outside of code, links' targets and the columns that quote what not to write."""
    quotes, before = False, ""
    for number, line in prose(text):
        if not line.lstrip().startswith("|"):
            quotes = False
        elif re.fullmatch(r"[\s|:-]+", line):
            quotes = before.strip().strip("|").split("|")[0].strip().lower() == BEFORE
        before = line
        shown = re.sub(r"\]\([^)]*\)", "]", re.sub(r"`[^`]*`", "``", line))
        yield number, re.sub(r"^\s*\|[^|]*", "", shown) if quotes else shown


def code_lines(text):
    """(line, text) of a file that is not a document, without the marks that comments begin with."""
    for number, line in enumerate(text.splitlines(), 1):
        yield number, re.sub(r"^\s*(?:///?|#+|\*+|--|;|\")?\s*", "", line)


def found_in(lines, pattern):
    """(line, word as it stands there) of every word to avoid; a word may go over the end of a line."""
    lines = list(lines)
    for index, (number, line) in enumerate(lines):
        following = lines[index + 1] if index + 1 < len(lines) else (0, "")
        joined = f"{line} {following[1].lstrip()}" if following[0] == number + 1 else line
        yield from ((number, match.group(0)) for match in pattern.finditer(joined) if match.start() < len(line))


def words_of(root, words):
    """The words of every text, by its path. In code, parts of names count too: `is_told`."""
    prose, code = pattern_of(words), pattern_of(words, "[A-Za-z-]", "[A-Za-z-]")
    found = {}
    for path in files(root):
        if path.parent == root / "tests" / "documents":
            continue  # speaks of words
        try:
            text = path.read_text(encoding="utf-8")
        except UnicodeDecodeError:
            continue  # not a text
        each = list(found_in(sentences(text), prose) if path.suffix == ".md" else found_in(code_lines(text), code))
        if each:
            found[str(path.relative_to(root))] = each
    return found


def check_words(root):
    if not (root / PLACE).exists():
        return [], "0 words to avoid"
    listed = yaml.safe_load((root / PLACE).read_text(encoding="utf-8"))
    avoided, left = listed["avoid"], listed.get("left") or {}
    found, problems = words_of(root, avoided), []
    for file, kept in (listed.get("keep") or {}).items():
        there = [each for each in found.get(file, []) if each[1].lower() == kept["word"]]
        if there:
            found[file] = [each for each in found[file] if each not in there]
        else:
            problems.append(f"{PLACE}: {file} has no `{kept['word']}`: delete its line")
    for file, words in found.items():
        if len(words) > left.get(file, 0):
            allowed = f"; {PLACE} lets it keep {left[file]}" if file in left else ""
            problems += [f"{file}:{line}: `{word}`: {advice_of(word, avoided)}{allowed}" for line, word in words]
    for file, count in left.items():
        now = len(found.get(file, []))
        if now < count:
            problems.append(f"{PLACE}: {file} has {now} words to avoid, not {count}: " + (f"write {now}" if now else "delete its line"))
    return problems, f"{sum(len(words) for words in found.values())} words to avoid in {sum(map(bool, found.values()))} files"


def advice_of(word, avoided):
    """The words to write instead of a word as it stands in a text."""
    return next(advice for each, advice in avoided.items() if pattern_of([each]).fullmatch(word))
