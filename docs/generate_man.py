#!/usr/bin/env python3
"""Writes man pages, keiko.1.gz and one for each command, made from the help texts of the program.

usage: docs/generate_man.py KEIKO FOLDER
"""
import gzip
import re
import subprocess
import sys
from pathlib import Path

from generate_cli import command_names, help_text

# Column of the help at which what an option means begins.
MEANING = 30


def roff(text):
    """Text as roff prints it: hyphens that can be copied, and no line that begins with a request."""
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return re.sub(r"(?m)^([.'])", r"\\&\1", text)


def entries(lines):
    """[spelling, meaning] of each option, argument or command in the indented lines of a help text.

    The meaning stands in its column, on a line of its own where the spelling is too long for that.
    """
    found = []
    for line, following in zip(lines, [*lines[1:], ""]):
        if line.startswith(" " * MEANING):
            found[-1][1] = line.strip()
        elif following.startswith(" " * MEANING):
            found.append([line.strip(), ""])
        else:
            found.append([line[:MEANING].strip(), line[MEANING:].strip()])
    return found


def parts(help_lines):
    """The blocks of a help text: its first lines under "", others by their title, and the last lines under "end"."""
    found = {"": [], "end": []}
    title = ""
    for line in help_lines:
        if re.fullmatch(r"[A-Z]\w+:", line):
            title = line[:-1]
            found[title] = []
        elif title and line and not line.startswith(" "):
            title = "end"
            found[title].append(line)
        elif line:
            found[title].append(line)
    return found


def listed(title, lines):
    """A section of options, arguments or commands."""
    text = f".SH {title}\n"
    for spelling, meaning in entries(lines):
        names, _, kind = spelling.partition(" ")
        text += f".TP\n\\fB{roff(names.replace(',', ', '))}\\fR"
        text += f" \\fI{roff(kind)}\\fR" if kind else ""
        text += f"\n{roff(meaning)}\n" if meaning else "\n\\&\n"
    return text


def closing(lines):
    """Sections of what follows the options: examples, exit codes and notes."""
    examples = [line.partition(": ")[2] for line in lines if line.startswith("Example:")]
    codes = [line.partition(": ")[2] for line in lines if line.startswith("Exit codes:")]
    notes = [line for line in lines if not line.startswith(("Example:", "Exit codes:"))]
    text = ""
    if notes:
        text += ".SH NOTES\n" + "\n.br\n".join(map(roff, notes)) + "\n"
    if codes:
        text += ".SH EXIT STATUS\n" + roff(" ".join(codes)) + "\n"
    if examples:
        text += ".SH EXAMPLES\n.nf\n" + "\n".join(map(roff, examples)) + "\n.fi\n"
    return text


def page(name, meaning, text, version, others):
    """One man page, from the help text of a command."""
    blocks = parts(text.splitlines())
    usage = next(line.partition(": ")[2] for line in blocks[""] if line.startswith("Usage:"))
    before = [line for line in blocks[""] if not line.startswith("Usage:")]
    roff_text = (f'.TH {roff(name.upper())} 1 "" "Keiko {version}" "User Commands"\n'
                 f".SH NAME\n{roff(name)} \\- {roff(meaning)}\n"
                 f".SH SYNOPSIS\n{roff(usage)}\n.SH DESCRIPTION\n{roff(' '.join(before))}\n")
    for title, heading in ("Subcommands", "COMMANDS"), ("Positionals", "ARGUMENTS"), ("Options", "OPTIONS"):
        if title in blocks:
            roff_text += listed(heading, blocks[title])
    return roff_text + closing(blocks["end"]) + ".SH SEE ALSO\n" + ",\n".join(
        f"\\fB{roff(other)}\\fR(1)" for other in others if other != name) + "\n"


def pages(binary):
    """The text of every man page, by its name."""
    main_help = help_text(binary)
    version = subprocess.run([binary, "--version"], capture_output=True, text=True, check=True).stdout.strip()
    names = ["keiko", *(f"keiko-{command}" for command in command_names(main_help))]
    found = {"keiko": page("keiko", "judge free-form surfaces by the reflections of lamps", main_help, version, names)}
    for command in command_names(main_help):
        text = help_text(binary, command)
        found[f"keiko-{command}"] = page(f"keiko-{command}", text.splitlines()[0], text, version, names)
    return found


def write_pages(binary, folder):
    """Writes all pages, and removes those of commands that are no more."""
    folder.mkdir(parents=True, exist_ok=True)
    for stale in folder.glob("*.1.gz"):
        stale.unlink()
    for name, text in pages(binary).items():
        # Without a time, so that the same text gives the same bytes.
        (folder / f"{name}.1.gz").write_bytes(gzip.compress(text.encode(), 9, mtime=0))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    write_pages(sys.argv[1], Path(sys.argv[2]))
