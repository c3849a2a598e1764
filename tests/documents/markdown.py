"""Links and headings of Markdown files, as GitHub reads them."""
import pathlib
import re
import urllib.parse

IGNORED = re.compile(r"^(build.*|generated|out|\.git|\.cache)$")  # at the top, as .gitignore says
LINK = re.compile(r"!?\[(?:[^\[\]]|\[[^\]]*\])*\]\(\s*<?([^)\s>]+)>?(?:\s+\"[^\"]*\")?\s*\)")


def files(root):
    """The repository's files, sorted."""
    for entry in sorted(root.iterdir()):
        if IGNORED.match(entry.name):
            continue
        found = sorted(entry.rglob("*")) if entry.is_dir() else [entry]
        yield from (path for path in found if path.is_file() and "__pycache__" not in path.parts)


def prose(text):
    """The lines of a text with their numbers, without blocks of code."""
    fence = None
    for number, line in enumerate(text.splitlines(), 1):
        mark = re.match(r"\s*(```+|~~~+)", line)
        if mark and (fence is None or mark.group(1).startswith(fence)):
            fence = mark.group(1) if fence is None else None
            continue
        if fence is None:
            yield number, line


def anchors(text):
    """Anchors of headings: lower case, without punctuation, hyphens for blanks, numbered if repeated."""
    seen, result = {}, set()
    for _, line in prose(text):
        heading = re.match(r"#{1,6}\s+(.*?)\s*#*\s*$", line)
        if heading:
            shown = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading.group(1))
            slug = re.sub(r"[^\w\- ]", "", shown.lower()).replace(" ", "-")
            times = seen[slug] = seen.get(slug, -1) + 1
            result.add(f"{slug}-{times}" if times else slug)
    return result


def links(text):
    """(line, target) of every link that is not inside of code."""
    for number, line in prose(text):
        for target in LINK.findall(re.sub(r"`[^`]*`", "``", line)):
            yield number, target


def check_links(root):
    problems, count = [], 0
    for path in files(root):
        if path.suffix != ".md":
            continue
        for line, target in links(path.read_text(encoding="utf-8")):
            if re.match(r"[a-z][a-z0-9+.-]*:", target):
                continue  # another site
            count += 1
            problem = problem_of(root, path, target)
            if problem:
                problems.append(f"{path.relative_to(root)}:{line}: `{target}` {problem}")
    return problems, f"{count} links"


def problem_of(root, path, target):
    """Why a link leads nowhere; None if it does not."""
    name, _, anchor = target.partition("#")
    end = (path.parent / urllib.parse.unquote(name)).resolve() if name else path
    if not end.is_relative_to(root):
        return "leads out of the repository"
    if not end.exists():
        return "does not exist"
    document = end / "README.md" if end.is_dir() else pathlib.Path(end)
    if anchor and (document.suffix != ".md" or not document.is_file() or anchor not in anchors(document.read_text(encoding="utf-8"))):
        return "has no such heading"
    return None
