"""The rules of prose that comments, docstrings and docs keep.

  subject    a docstring's first sentence does not begin with Of, The same, What, Where, Those, That, As, But
  idiom      no private idiom: told, tells of, amid, asked for, looked at, of which, but for, so many
  sentence   a sentence has at most 35 words
  paragraph  a paragraph of a page has at most 110 words
  line       a line of a page has at most 120 characters, tables and links aside
  citation   a source can be looked up: no section of notes that are not published, no bare number in brackets
"""
import re

SUBJECT = re.compile(r"^(Of|The same|What|Where|Those|That|As|But|Nothing|Whether what)\b")
IDIOM = re.compile(
    r"\b(told|tells of|tell of|amid|asked for|looked at|looks at|of which|but for|so many|"
    r"as it has it|what of|takes it that|hang(?:s|ing)? lamps|seen past|are off by|is off by)\b",
    re.IGNORECASE)
CITATION = re.compile(r"\bphysics \(?\d|\[00[0-4]\]")
COMMENT = re.compile(r"^\s*(///?<?)\s?(.*)$")
TRAILING = re.compile(r"\S\s+(///?<)\s?(.*)$")
ITEM = re.compile(r"^\s*([-*]|\d+\.)\s")
NOT_PLAIN = ("#", "|", "    ", "```", "!", "<")
LINKS = ("|", "](", "http")

MOST_SENTENCE, MOST_PARAGRAPH, MOST_LINE = 35, 110, 120
FOLDERS = ("src", "surfaces", "lightrigs", "tests", "docs")
KINDS = (".h", ".cpp", ".md")
GENERATED = ("docs/cli.md",)


def files(root):
    """The files of a repository that hold prose, sorted."""
    inside = [path for folder in FOLDERS for path in (root / folder).rglob("*")]
    names = {path.relative_to(root).as_posix(): path for path in [root / "README.md", *inside]}
    return [path for name, path in sorted(names.items()) if path.suffix in KINDS and name not in GENERATED]


def sentences(text):
    return [s for s in re.split(r"(?<=[.;:!?])\s+(?=[A-Z`*(])", text) if s.strip()]


def comments(text):
    """Runs of comment lines of a C++ file: line, text, whether it is a docstring."""
    run, start, doc = [], 0, False
    for number, line in enumerate(text.split("\n") + [""], 1):
        found, trailing = COMMENT.match(line), TRAILING.search(line)
        if found and not found[1].endswith("<"):
            start, doc = (start, doc) if run else (number, found[1] == "///")
            run.append(found[2])
            continue
        if run:
            yield start, " ".join(run), doc
        run = []
        if trailing:
            yield number, trailing[2], False


def paragraphs(text):
    """Paragraphs and items of lists of a page, without headings, tables and code: line, text."""
    run, start, fenced = [], 0, False
    for number, line in enumerate(text.split("\n") + [""], 1):
        fenced ^= line.startswith("```")
        plain = not fenced and line.strip() and not line.startswith(NOT_PLAIN)
        if run and not (plain and not ITEM.match(line)):
            yield start, " ".join(run)
            run = []
        if plain:
            start = start if run else number
            run.append(line.strip())


def long_lines(text):
    for number, line in enumerate(text.split("\n"), 1):
        if len(line) > MOST_LINE and not any(mark in line for mark in LINKS):
            yield number, "line", f"{len(line)} characters"


def block_findings(number, block):
    for found in IDIOM.finditer(block):
        yield number, "idiom", found[0]
    for found in CITATION.finditer(block):
        yield number, "citation", block[max(0, found.start() - 10):found.end() + 6]
    for sentence in sentences(block):
        if (words := len(sentence.split())) > MOST_SENTENCE:
            yield number, "sentence", f"{words} words: {sentence[:60]}"


def page_findings(text):
    yield from long_lines(text)
    for number, block in paragraphs(text):
        if (words := len(block.split())) > MOST_PARAGRAPH:
            yield number, "paragraph", f"{words} words"
        yield from block_findings(number, block)


def source_findings(text):
    for number, block, doc in comments(text):
        if doc and SUBJECT.match(block):
            yield number, "subject", block[:70]
        yield from block_findings(number, block)


def findings(name, text):
    """Line, rule and text of each finding in a file."""
    return list(page_findings(text) if name.endswith(".md") else source_findings(text))


def faults(root):
    """What breaks the rules in a repository, one line of text each."""
    found = []
    for path in files(root):
        name, text = path.relative_to(root).as_posix(), path.read_text(encoding="utf-8")
        found += [f"{name}:{number}: {rule}: {what}" for number, rule, what in findings(name, text)]
    return found
