"""Markdown to HTML: cmark-gfm, GitHub's own parser, and links between pages on top of it."""
import html
import html.parser
import re
import subprocess

from sources import relative

HEADINGS = {"h1", "h2", "h3", "h4", "h5", "h6"}
VOID = {"img", "br", "hr", "input"}


def to_html(text):
    command = ["cmark-gfm", "--extension", "table", "--extension", "strikethrough", "--extension", "autolink"]
    made = subprocess.run(command, input=text, capture_output=True, text=True, check=True).stdout
    if "<!-- raw HTML omitted -->" in made:
        raise ValueError("a document has HTML in it, which the site leaves out")
    return made


def slug_of(text):
    """GitHub's: lower case, without punctuation, hyphens for blanks."""
    return re.sub(r"[^\w\- ]", "", text.strip().lower()).replace(" ", "-")


class Slugs:
    """Anchors of one page; the second heading of a name gets a number."""

    def __init__(self):
        self.seen = {}

    def __call__(self, text):
        slug = slug_of(text)
        times = self.seen[slug] = self.seen.get(slug, -1) + 1
        return f"{slug}-{times}" if times else slug


class Rewriter(html.parser.HTMLParser):
    """Gives headings anchors, links their pages, code its colours and links; keeps what a search looks through.

    `link` turns a target of the document into one of the site, `words` knows the pages of words, `code` colours blocks.
    """

    def __init__(self, page, link, words, code):
        super().__init__(convert_charrefs=True)
        self.page, self.link, self.words, self.code = page, link, words, code
        self.out, self.slugs = [], Slugs()
        self.sections = [["", "", []]]  # title, anchor, words
        self.contents = []              # (level, title, anchor) of the headings
        self.title = ""
        self.held = []                  # where output went before a heading or code began
        self.inside = []
        self.cells = 0                  # of the row of a table

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.inside.append(tag)
        self.cells = 0 if tag == "tr" else self.cells + (tag == "td")
        if tag in HEADINGS or tag == "pre" or (tag == "code" and "pre" not in self.inside):
            self.held.append((self.out, attributes))
            self.out = []
            if tag == "code":
                return
        if tag == "code":  # of a block
            self.held[-1] = (self.held[-1][0], attributes)
            return
        if tag == "a" and "href" in attributes:
            attributes["href"] = relative(self.page, self.link(attributes["href"]))
        if tag == "img":
            attributes["src"] = relative(self.page, self.link(attributes["src"]))
            attributes["loading"] = "lazy"
        if tag == "table":
            self.out.append('<div class="wide">')
        if tag not in HEADINGS and tag != "pre":
            self.out.append("<" + tag + "".join(f' {k}="{html.escape(v or "")}"' for k, v in attributes.items()) + ">")
        if tag in VOID:
            self.inside.pop()

    def handle_endtag(self, tag):
        if tag in VOID:
            return
        self.inside.pop()
        if tag in HEADINGS:
            self.end_heading(tag)
        elif tag == "pre":
            self.end_block()
        elif tag == "code" and "pre" not in self.inside:
            text = "".join(self.out)
            self.out = self.held.pop()[0]
            page = None if "a" in self.inside or HEADINGS & set(self.inside) else self.page_of_code(html.unescape(text))
            shown = f"<code>{text}</code>"
            self.out.append(f'<a href="{relative(self.page, page)}">{shown}</a>' if page else shown)
        elif tag != "code":
            self.out.append(f"</{tag}>" + ("</div>" if tag == "table" else ""))

    def page_of_code(self, text):
        """In the first column of a table about keys it is the key's row."""
        if "td" in self.inside and self.cells == 1:
            row = self.words.of_row(self.page, self.sections[-1][1], text)
            if row:
                return row
        return self.words.of_code(text, self.page)

    def handle_data(self, data):
        self.sections[-1][2].append(data)
        self.out.append(html.escape(data, quote=False))

    def end_heading(self, tag):
        text = "".join(self.out)
        plain = html.unescape(re.sub(r"<[^>]*>", "", text))
        self.out = self.held.pop()[0]
        anchor = self.slugs(plain)
        self.sections[-1][2] = self.sections[-1][2][:-1] if self.sections[-1][2] else []
        self.sections.append([plain, anchor, []])
        self.contents.append((int(tag[1]), plain, anchor))
        if tag == "h1" and not self.title:
            self.title = plain
        self.out.append(f'<{tag} id="{anchor}">{text}<a class="here" href="#{anchor}" aria-label="link to this heading">#</a></{tag}>')

    def end_block(self):
        text = html.unescape("".join(self.out))
        self.out, attributes = self.held.pop()
        language = (attributes.get("class") or "").removeprefix("language-")
        self.out.append(self.code.block(text, language, self.page))


def rewrite(text, page, link, words, code):
    """The page of a document: its Rewriter, whose `out` is the HTML."""
    rewriter = Rewriter(page, link, words, code)
    rewriter.feed(to_html(text))
    rewriter.close()
    return rewriter


def plain(words):
    """Text for the search, in one line."""
    return re.sub(r"\s+", " ", " ".join(words)).strip()
