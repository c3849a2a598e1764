"""The libraries as CMake links them, and the includes of the sources."""
import collections
import dataclasses
import os
import re

TOPS = ("generator", "runtime", "models", "targets")
KINDS = (".hpp", ".cpp", ".mustache", ".blank")
RAW_STRING = re.compile(r'R"(\w*)\(.*?\)\1"', re.DOTALL)  # generated text has includes of its own
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^">\n]+)[>"]', re.MULTILINE)


@dataclasses.dataclass
class Target:
    name: str
    kind: str
    folder: str = ""  # empty: none in the sources
    sources: list = dataclasses.field(default_factory=list)
    links: dict = dataclasses.field(default_factory=dict)  # library: whether its users link it too


class Declared:
    """The output of links.cmake."""

    def __init__(self, text):
        self.targets = {}
        for line in text.splitlines():
            word, name, *more = line.split()
            if word == "target":
                target = self.targets[name] = Target(name, more[0], "" if more[1] == "-" else more[1])
            elif word == "source":
                target.sources.append(name)
            else:
                target.links[name] = word == "public"
        for target in self.targets.values():
            folders = sorted({os.path.dirname(source) for source in target.sources})
            if not target.folder and folders:
                target.folder = os.path.commonpath(folders)
        self.target_of_source = {s: t for t in self.targets.values() for s in t.sources}
        self.library_of_folder = {t.folder: t for t in self.targets.values() if t.folder and t.kind != "EXECUTABLE"}

    def library_of(self, path):
        """The library whose folder `path` is in, the innermost one; None if there is none."""
        while path := os.path.dirname(path):
            if path in self.library_of_folder:
                return self.library_of_folder[path]
        return None

    def reach(self, target):
        """Names of the libraries that a target may include: those it links, and what these hand on."""
        seen, todo = set(), list(target.links)
        while todo:
            name = todo.pop()
            if name not in seen:
                seen.add(name)
                links = self.targets[name].links if name in self.targets else {}
                todo += [library for library, is_public in links.items() if is_public]
        return seen

    def below(self, name):
        """Targets that `name` links, with a folder in the sources; through libraries without one."""
        found = set()
        for library in self.targets[name].links:
            if library in self.targets:
                found |= {library} if self.targets[library].folder else self.below(library)
        return found

    def foreign(self, name):
        """Foreign libraries that only this target links, by the names their packages have."""
        found = set()
        for library in self.targets[name].links:
            if library not in self.targets:
                found.add(library.split("::")[-1])
            elif not self.targets[library].folder and library != "eagerx_gen_base":
                found |= self.foreign(library)
        return found

    def circles(self):
        """Static libraries may link each other in a circle, and CMake accepts it."""
        order, done, problems = [], set(), []

        def visit(name):
            if name in order:
                problems.append("libraries in a circle: " + " -> ".join(order[order.index(name):] + [name]))
            elif name not in done and name in self.targets:
                order.append(name)
                for library in sorted(self.targets[name].links):
                    visit(library)
                done.add(order.pop())

        for name in sorted(self.targets):
            visit(name)
        return problems


def included(root, path, quoted, name):
    """The file of the repository that an include means; None if it is not ours."""
    places = ([os.path.join(os.path.dirname(path), name)] if quoted else []) + [name, os.path.join("runtime", name)]
    for place in map(os.path.normpath, places):
        if place.startswith(tuple(top + "/" for top in TOPS)) and (root / place).is_file():
            return place
    return None


def edges(root, declared):
    """{(folder, included folder): includes}, of the folders of sources, and what is wrong, a line each."""
    found, problems = collections.Counter(), []
    paths = sorted(p for top in TOPS for p in (root / top).rglob("*") if p.suffix in KINDS and p.is_file())
    for file in paths:
        path = file.relative_to(root).as_posix()
        home = declared.library_of(path)
        if home is None:
            problems.append(f"{path}: belongs to no library")
            continue
        user = declared.target_of_source.get(path, home)
        text = RAW_STRING.sub(lambda raw: "\n" * raw.group().count("\n"), file.read_text())
        for match in INCLUDE.finditer(text):
            place = included(root, path, match[1] == '"', match[2])
            library = declared.library_of(place) if place else None
            if library is None:
                continue
            here, there = os.path.dirname(path), os.path.dirname(place)
            if here != there:
                found[here, there] += 1
            if library.name not in (home.name, user.name) and library.name not in declared.reach(user):
                line = text.count("\n", 0, match.start(2)) + 1
                problems.append(f"{path}:{line}: includes `{match[2]}`, but {user.name} does not link {library.name}")
    return found, problems


def folder_circles(edges):
    """Folders of generator/ that include each other in a circle, a line each: data go one way within a library, too."""
    below = collections.defaultdict(set)
    for a, b in edges:
        if a.startswith("generator/") and b.startswith("generator/"):
            below[a].add(b)
    order, done, problems = [], set(), []

    def visit(folder):
        if folder in order:
            problems.append("folders in a circle: " + " -> ".join(order[order.index(folder):] + [folder]))
        elif folder not in done:
            order.append(folder)
            for included in sorted(below[folder]):
                visit(included)
            done.add(order.pop())

    for folder in sorted(below):
        visit(folder)
    return problems


def equal_names(root):
    """Types of generator/ that two headers define with one name: the linker would mix their functions."""
    headers = {}
    for path in sorted((root / "generator").rglob("*.hpp")):
        text = path.read_text()
        namespace = re.search(r"^(?:inline )?namespace ([\w:]+) \{", text, re.MULTILINE)
        for name in set(re.findall(r"^(?:struct|class|enum class|enum) (\w+)\b[^;]*\{", text, re.MULTILINE)):
            headers.setdefault((namespace[1] if namespace else "", name), []).append(str(path.relative_to(root)))
    return [f"{' and '.join(paths)} both define {scope}::{name}" for (scope, name), paths in headers.items()
            if len(paths) > 1]
