#!/usr/bin/env python3
"""Fails when a source or a page that code or docs name cannot be looked up.

usage: tests/check_citations.py

A citation is a key in brackets, with a place in the source after a comma: [Igehy1999, section 3].
docs/references.md resolves it. Each source there is cited somewhere, or stands under "Further
reading". Comments may name a page of the docs and a heading of it, docs/theory.md#seams.
"""
import io
import re
import sys
import tokenize
from pathlib import Path

from markdown_text import CODE, anchors

ROOT = Path(__file__).resolve().parent.parent
FOLDERS = ("docs", "src", "tests", "surfaces", "lightrigs")
REFERENCES = "docs/references.md"
SKIPPED = (REFERENCES, "docs/CHANGELOG.md")
FURTHER = "Further reading"

CITATION = re.compile(r"(?<![\w)\]])\[([A-Z][\w.-]*\w)(?:,\s[^\[\]]*)?\](?![(\[])")
REFERENCE = re.compile(r"^- \[([^\]]+)\] \S", re.MULTILINE)
PAGE = re.compile(r"\b(docs/[\w./-]+\.md)(?:#([\w-]+))?")
BARE_EQUATION = re.compile(r"\beqs?\.\s+\(?\d")
UNPUBLISHED = re.compile(r"\b[Pp]hysics\s+\(?\d|\[00\d\]")
USAGE = re.compile(r"^usage:.*", re.MULTILINE)
STATEMENT_ENDS = (tokenize.NEWLINE, tokenize.INDENT, tokenize.DEDENT)
BETWEEN = (tokenize.NL, tokenize.COMMENT)  # statements
QUOTED = re.compile(r'"(?:\\.|[^"\\])*"')


def blanked(text):
    """As many lines, all empty."""
    return "\n" * text.count("\n")


def comments_after(mark, text):
    """The comments of a text, each on its line."""
    found = (re.search(rf"(?:^|\s){mark}(.*)", QUOTED.sub('""', line)) for line in text.split("\n"))
    return "\n".join(comment[1] if comment else "" for comment in found)


def python_comments(text):
    """Comments and docstrings, each on its line."""
    lines = [""] * (text.count("\n") + 1)
    begins = True
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.COMMENT or (token.type == tokenize.STRING and begins):
            for i, line in enumerate(token.string.split("\n")):
                lines[token.start[0] - 1 + i] += line.lstrip("#")
        if token.type not in BETWEEN:
            begins = token.type in STATEMENT_ENDS
    return "\n".join(lines)


def prose(path):
    """What a file says to people, on the lines where it stands."""
    text = path.read_text(encoding="utf-8")
    if path.suffix == ".md":
        return CODE.sub(lambda code: blanked(code[0]), text)
    if path.suffix == ".py":
        return USAGE.sub("", python_comments(text))
    return comments_after("//[/<]*" if path.suffix in (".h", ".cpp") else "#", text)


def files(root):
    names = [root / "README.md"]
    for folder in FOLDERS:
        names += sorted((root / folder).rglob("*"))
    kinds = (".h", ".cpp", ".py", ".md", ".toml")
    wanted = [p for p in names if p.suffix in kinds or p.name == "CMakeLists.txt"]
    return [p for p in wanted if p.is_file() and str(p.relative_to(root)) not in SKIPPED]


class References:
    """The sources of docs/references.md."""

    def __init__(self, root):
        text = (root / REFERENCES).read_text(encoding="utf-8")
        above, _, below = text.partition(f"## {FURTHER}")
        self.main, self.further = REFERENCE.findall(above), REFERENCE.findall(below)

    def faults(self, cited):
        every = self.main + self.further
        found = [f"two sources are called {key}" for key in sorted({k for k in every if every.count(k) > 1})]
        found += [f"{key} is cited nowhere: \"{FURTHER}\"?" for key in self.main if key not in cited]
        found += [f"{key} is cited: not \"{FURTHER}\"" for key in self.further if key in cited]
        return [f"{REFERENCES}: {fault}" for fault in found]


def page_fault(root, page, anchor):
    if not (root / page).is_file():
        return f"no such page: {page}"
    if anchor and anchor not in anchors(root / page):
        return f"no such heading: {page}#{anchor}"
    return None


def faults_of(root, path, known):
    """Pairs of a line and what is wrong there."""
    text = prose(path)

    def line(match):
        return text.count("\n", 0, match.start()) + 1

    for match in CITATION.finditer(text):
        if match[1] not in known:
            yield line(match), f"no source in {REFERENCES}: [{match[1]}]"
    for match in PAGE.finditer(text):
        if fault := page_fault(root, match[1], match[2]):
            yield line(match), fault
    for match in UNPUBLISHED.finditer(text):
        yield line(match), f"not published: {' '.join(match[0].split())}"
    if path.suffix != ".md":
        for match in BARE_EQUATION.finditer(CITATION.sub(lambda cited: blanked(cited[0]), text)):
            yield line(match), f"an equation of no source: {' '.join(match[0].split())}"


def all_faults(root):
    references = References(root)
    known = set(references.main + references.further)
    found, cited = [], set()
    for path in files(root):
        cited |= {match[1] for match in CITATION.finditer(prose(path))}
        for line, fault in sorted(faults_of(root, path, known)):
            found.append(f"{path.relative_to(root)}:{line}: {fault}")
    return found + references.faults(cited)


def main():
    if len(sys.argv) != 1:
        sys.exit(__doc__)
    faults = all_faults(ROOT)
    for fault in faults:
        print(fault)
    if faults:
        sys.exit(1)
    print("citations hold")


if __name__ == "__main__":
    main()
