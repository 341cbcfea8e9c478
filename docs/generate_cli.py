#!/usr/bin/env python3
"""Prints docs/cli.md, made from the help texts of the program.

usage: docs/generate_cli.py build/release/bin/keiko > docs/cli.md
"""
import re
import subprocess
import sys

INTRODUCTION = """\
# Command line

<!-- Written by docs/generate_cli.py from the help texts; change those, not this file. -->

`./dev run ARGS` builds what is needed and runs `keiko ARGS`. What the options mean for the work is
told in the [guide](guide.md); the files they name in [scene format](scene-format.md) and
[file formats](file-formats.md).
"""


def help_text(binary, *command):
    """What `keiko COMMAND --help` prints, without trailing blanks."""
    run = subprocess.run([binary, *command, "--help"], capture_output=True, text=True, check=True)
    return "\n".join(line.rstrip() for line in run.stdout.splitlines()).strip("\n")


def command_names(main_help):
    """The commands that the main help lists, in its order."""
    listed = main_help.split("Subcommands:", 1)[1].split("\n\n", 1)[0]
    return re.findall(r"^  (\w[\w-]*)", listed, re.MULTILINE)


def section(title, text):
    return f"## {title}\n\n```text\n{text}\n```\n"


def cli_page(binary):
    """The whole page."""
    main_help = help_text(binary)
    sections = [section("keiko", main_help)]
    for name in command_names(main_help):
        sections.append(section(f"keiko {name}", help_text(binary, name)))
    return INTRODUCTION + "\n" + "\n".join(sections)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.stdout.write(cli_page(sys.argv[1]))
