#!/usr/bin/env python3
"""Fails when a C++ example of a page does not compile against the headers of src.

usage: tests/check_examples.py COMPILER PAGE...
"""
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
EXAMPLE = re.compile(r"^```cpp\n(.*?)^```", re.MULTILINE | re.DOTALL)


def examples(page):
    """The examples of a page that are whole programs."""
    found = EXAMPLE.findall(page.read_text(encoding="utf-8"))
    return [example for example in found if "int main(" in example]


def fault(compiler, example):
    command = [compiler, "-std=c++20", "-fsyntax-only", "-Wall", "-Werror", f"-I{ROOT / 'src'}", "-x", "c++", "-"]
    return subprocess.run(command, input=example, capture_output=True, text=True, check=False).stderr


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    for page in sys.argv[2:]:
        found = examples(ROOT / page)
        faults = [text for example in found if (text := fault(sys.argv[1], example))]
        if faults or not found:
            sys.exit(f"{page}: " + "\n".join(faults or ["no example"]))
        print(f"{page}: {len(found)} examples compile")


main()
