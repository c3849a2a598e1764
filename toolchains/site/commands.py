"""Pages of commands, from the help that eagerx-gen prints."""
import html
import re

from markup import slug_of
from sources import relative

ENTRY = re.compile(r"^  (\S.*?)(?:\s{2,}(\S.*))?$")


def escape(text):
    return html.escape(text, quote=False)


def read_help(text):
    """(what it does, usage, {title: [(name, about)]}, [(comment, command)], what follows)."""
    lines = text.rstrip().splitlines()
    about, usage, sections, examples, rest = lines[0], "", {}, [], []
    title = None
    for line in lines[1:]:
        if line.startswith("Usage: "):
            usage = line.removeprefix("Usage: ")
        elif re.fullmatch(r"[A-Z][^:]*:", line):
            title = line[:-1]
            sections.setdefault(title, [])
        elif not line.strip():
            title = None if title not in ("Examples",) else title
        elif title == "Examples":
            examples.append(line[2:])
        elif title and line.startswith("   ") and sections[title]:
            name, words = sections[title][-1]
            sections[title][-1] = (name, (words + " " + line.strip()).strip())
        elif title and (match := ENTRY.match(line)):
            sections[title].append((match.group(1), match.group(2) or ""))
        else:
            rest.append(line)
    sections.pop("Examples", None)
    return about, usage, sections, examples, rest


def names_in(text):
    """Names of the commands, or topics, that a help lists."""
    _, _, sections, _, _ = read_help(text)
    return [name.split()[0] for title, rows in sections.items() if title == "Subcommands" for name, _ in rows], \
           [name.split()[0] for title, rows in sections.items() if title.startswith("Topics") for name, _ in rows]


class Commands:
    """`run`: what eagerx-gen prints for arguments."""

    def __init__(self, run, words, code):
        self.run, self.words, self.code = run, words, code
        self.names, self.topics = names_in(run("help"))
        for name in self.names:
            words.commands[name] = f"commands/{name}.html"
        for name in self.names + self.topics:
            words.add(name, f"commands/{name}.html")

    def options(self, page, text, level, prefix=""):
        """One help as HTML."""
        about, usage, sections, examples, rest = read_help(text)
        parts = [f'<p class="summary">{escape(about)}</p>', f'<pre tabindex="0"><code>{escape(usage)}</code></pre>']
        for title, rows in sections.items():
            if not rows or title == "Subcommands":
                continue
            cells = []
            for name, words in rows:
                first = re.search(r"--[\w-]+", name)
                anchor = f' id="{prefix}{first.group()}"' if first else ""
                cells.append(f'<tr{anchor}><td class="key"><code>{escape(name)}</code></td><td>{escape(words)}</td></tr>')
            parts.append(f'<h{level} id="{prefix}{slug_of(title)}">{escape(title)}</h{level}>'
                         f'<div class="wide entries"><table><tbody>{"".join(cells)}</tbody></table></div>')
        if examples:
            parts.append(f'<h{level} id="{prefix}examples">Examples</h{level}>' + self.code.block("\n".join(examples), "", page))
        parts += [f"<p>{escape(line)}</p>" for line in rest]
        return about, "\n".join(parts)

    def page(self, name):
        page = f"commands/{name}.html"
        text = self.run("help", name)
        about, body = self.options(page, text, 2)
        inner, _ = names_in(text)
        headings = []
        for each in inner:
            anchor = f"{name}-{each}"
            headings.append((2, f"{name} {each}", anchor))
            body += f'\n<h2 id="{anchor}">eagerx-gen {name} {each}</h2>\n' + self.options(page, self.run(name, each, "--help"), 3, each + "-")[1]
            self.words.add(f"{name} {each}", f"{page}#{anchor}")
        return page, f"eagerx-gen {name}", f"<h1>eagerx-gen {name}</h1>\n{body}", headings, [about, re.sub(r"\s+", " ", text)]

    def topic(self, name):
        page, text = f"commands/{name}.html", self.run("help", name)
        return page, name, f"<h1>{name}</h1>\n" + self.code.block(text, "text", page), [], [text]

    def index(self):
        page = "commands/index.html"
        rows = []
        for name in self.names:
            about = self.run("help", name).splitlines()[0]
            rows.append(f'<tr><td><a href="{relative(page, f"commands/{name}.html")}"><code>eagerx-gen {name}</code></a></td>'
                        f"<td>{escape(about)}</td></tr>")
        topics = "".join(f'<li><a href="{name}.html">{name}</a></li>' for name in self.topics)
        body = ("<h1>Commands</h1>\n<p>What <code>eagerx-gen help COMMAND</code> prints. "
                f'<a href="{relative(page, "generator/driver/commands/index.html")}">Another page</a> says how they go together.</p>\n'
                f'<div class="wide"><table><tbody>{"".join(rows)}</tbody></table></div>\n<h2 id="topics">Topics</h2>\n<ul>{topics}</ul>')
        return page, "Commands", body, [], []
