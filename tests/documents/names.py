"""Files that documents name between backquotes: each is one of the repository, by its path or the end of it."""
import fnmatch
import re

from markdown import files, prose

NAME = re.compile(r"`([^`\s]+)`")
PATH = re.compile(r"[\w.+{},*-]+(?:/[\w.+{},*-]+)+/?")
KINDS = ("md", "hpp", "cpp", "yaml", "csv", "py", "cmake", "h", "sh", "js", "json", "svg", "png", "css", "mustache", "onnx", "proto")
PLACEHOLDER = re.compile(r"\b[A-Z][A-Z]+(?:\b|_)|my_|NNN")  # the reader's own names
FILE_COLUMNS = ("file", "header")  # of tables: every name in that column is a file
# Files that documents ask the reader to write, or that programs generate.
MADE = ("models/nodes/limited_gain/*", "build/*", "build-*", "generated/*", "frames/*", "docs/*", "lib/*", "src/*", "libraries/*",
        "vision/*", "part.json")


class Names:
    """The files of a folder: whole paths, and every suffix of them, with and without the extension."""

    def __init__(self, root, every):
        self.ends, self.tops = set(), set()
        for path in every:
            parts = path.relative_to(root).parts
            self.tops.add(parts[0])
            for depth in range(len(parts)):
                self.add("/".join(parts[depth:]))
                for end in range(depth + 1, len(parts)):
                    self.ends.add("/".join(parts[depth:end]))

    def add(self, end):
        self.ends.add(end)
        stem = end.rpartition("/")[2]
        if "." in stem[1:]:
            self.ends.add(end[:len(end) - len(stem)] + stem[:stem.index(".", 1)])

    def has(self, name):
        """`{a,b}` is both, `*` is anything."""
        braces = re.search(r"\{([^{}]*)\}", name)
        if braces:
            return all(self.has(name[:braces.start()] + part + name[braces.end():]) for part in braces.group(1).split(","))
        name = name.rstrip("/")
        if "*" in name:
            pattern = re.compile(fnmatch.translate(name))
            return any(pattern.match(end) for end in self.ends)
        return name in self.ends


def cells(line):
    return [cell.strip() for cell in re.sub(r"\\\|", "¦", line.strip().strip("|")).split("|")]


def named(text):
    """(line, name, whether its form alone says that it is a file) of what a document names as files."""
    column = None
    before = ""
    for number, line in prose(text):
        if not line.lstrip().startswith("|"):
            column = None
        elif re.fullmatch(r"[\s|:-]+", line):
            heads = [head.lower() for head in cells(before)]
            column = next((heads.index(word) for word in FILE_COLUMNS if word in heads), None)
        elif column is not None and column < len(cells(line)):
            yield from ((number, name, True) for name in NAME.findall(cells(line)[column]))
        before = line
        yield from ((number, name, False) for name in NAME.findall(line) if PATH.fullmatch(name))


def check_names(root):
    every = list(files(root))
    names, folders, problems, count = Names(root, every), {}, [], 0
    for path in every:
        if path.suffix != ".md" or path.name == "CHANGELOG.md":  # that tells of files that are no more
            continue
        for line, name, is_file in named(path.read_text(encoding="utf-8")):
            like_one = name.rstrip("/").rpartition(".")[2] in KINDS or name.split("/")[0] in names.tops
            if not (is_file or like_one) or PLACEHOLDER.search(name) or any(fnmatch.fnmatch(name, made) for made in MADE):
                continue
            count += 1
            if is_file and "/" not in name:  # in a table of files: one of the document's own folder
                if path.parent not in folders:
                    folders[path.parent] = Names(path.parent, [each for each in every if each.is_relative_to(path.parent)])
                here = folders[path.parent]
            else:
                here = names
            if not (here.has(name) or name.startswith("../")):
                problems.append(f"{path.relative_to(root)}:{line}: there is no file `{name}`")
    return problems, f"{count} names of files"
