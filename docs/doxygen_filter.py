"""What Doxygen does not read by itself in a header, written so that it does, line by line.

A comment on `double u = 0, v = 0;` counts for both names, while Doxygen takes it for one of them.
A comparison that is `= default` means what the language says. A page with an anchor (fog.md#grids)
is no link to a symbol named grids.
"""
import re

DECLARATION = re.compile(r"^(?P<indent> +)(?P<type>(?:const |mutable |static |unsigned )*[\w:]+(?:<.*>)?[*&]? )"
                         r"(?P<names>[a-z]\w*\b[^()]*,.*);(?P<rest> *(?:///<.*)?)$")
DEFAULTED = re.compile(r"^ +(?:friend )?(?:bool|auto|std::\w+) operator(==|<=>)\(.*= default;$")
MEANINGS = {"==": "True if all members are equal.", "<=>": "Compares the members in order."}


def split_names(text: str) -> list:
    """The parts of a text between commas that stand in no brackets; `{1, 2}` is one part."""
    parts, depth = [""], 0
    for character in text:
        depth += (character in "{([<") - (character in "})]>")
        if character == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += character
    return [part.strip() for part in parts]


def comment_after(lines: list, number: int) -> str:
    """Text of the `///<` behind a line and of those that go on below it."""
    text = lines[number].partition("///<")[2]
    for line in lines[number + 1:]:
        if not line.strip().startswith("///<"):
            break
        text += line.partition("///<")[2]
    return text.strip()


def comment_before(lines: list, number: int) -> str:
    text = []
    while number > 0 and re.match(r" *///(?!<)", lines[number - 1]):
        number -= 1
        text.insert(0, lines[number].strip()[3:])
    return "".join(text).strip()


def spread(lines: list, number: int) -> str:
    """The line with its comment at each of the names that it declares."""
    found = DECLARATION.match(lines[number])
    if not found or len(split_names(found["names"])) < 2:
        return lines[number]
    text = comment_after(lines, number) or comment_before(lines, number)
    if not text:
        return lines[number]
    text = text.replace("*/", "")
    return found["indent"] + " ".join(f"{found['type']}{name}; /**< {text} */" if comment_after(lines, number)
                                      else f"/** {text} */ {found['type']}{name};"
                                      for name in split_names(found["names"]))


def filtered(text: str) -> str:
    lines = re.sub(r"(\w\.md)#(\w)", r"\1\\#\2", text).split("\n")
    out, spread_above = [], False
    for number, line in enumerate(lines):
        if spread_above and line.strip().startswith("///<"):
            out.append("")
            continue
        new = spread(lines, number)
        spread_above = new != line and "/**<" in new
        if (defaulted := DEFAULTED.match(line)) and not comment_before(lines, number):
            new = f"{line} /**< {MEANINGS[defaulted[1]]} */"
        out.append(new)
    return "\n".join(out)
