"""Citations in sources: sections of runtime/SEMANTICS.md, and no document outside the repository."""
import re

from markdown import files

CITED = re.compile(r"\bSEMANTICS\b(?!\.(?:md|html))(?: §(\d+))?")
OWN = re.compile(r"§(\d+)")  # SEMANTICS.md's own references
ELSEWHERE = re.compile(r"\b(RECIPES|DESIGN)\b")  # notes of the first days, in nobody's repository
SECTION = re.compile(r"^## (\d+)\. ", re.MULTILINE)


def check_citations(root):
    semantics = root / "runtime" / "SEMANTICS.md"
    sections = set(SECTION.findall(semantics.read_text(encoding="utf-8")))
    problems, count = [], 0
    for path in files(root):
        if path.parent == root / "tests" / "documents":
            continue  # speaks of citations
        try:
            text = path.read_text(encoding="utf-8")
        except UnicodeDecodeError:
            continue  # not a text
        for number, line in enumerate(text.splitlines(), 1):
            where = f"{path.relative_to(root)}:{number}"
            cited = [match.group(1) for match in CITED.finditer(line)]
            if path == semantics:
                cited = OWN.findall(line)
            count += len(cited)
            problems += [f"{where}: `SEMANTICS` is cited without a section" if section is None else
                         f"{where}: SEMANTICS.md has no section {section}"
                         for section in cited if section not in sections]
            problems += [f"{where}: `{name}` is not in the repository" for name in ELSEWHERE.findall(line)]
    return problems, f"{count} citations"
