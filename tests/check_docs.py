#!/usr/bin/env python3
"""Fails when docs/cli.md is not what the program says, when a link of the docs leads nowhere, when prose breaks
a rule of tests/prose_rules.py, or when CITATION.cff has another version than CMakeLists.txt.

usage: tests/check_docs.py KEIKO
"""
import importlib.util
import re
import sys
from pathlib import Path

import prose_rules
from markdown_text import CODE, anchors

ROOT = Path(__file__).resolve().parent.parent
sys.dont_write_bytecode = True

LINK = re.compile(r"\]\(([^)\s]+)\)|(?:src|href)=\"([^\"]+)\"")


def load_generator():
    spec = importlib.util.spec_from_file_location("generate_cli", ROOT / "docs" / "generate_cli.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def cli_faults(binary):
    page = ROOT / "docs" / "cli.md"
    if page.is_file() and page.read_text(encoding="utf-8") == load_generator().cli_page(binary):
        return []
    return ["docs/cli.md is not what the program says; docs/generate_cli.py KEIKO > docs/cli.md"]


def citation_faults():
    """CITATION.cff and CMakeLists.txt each state the version once."""
    project = re.search(r"^project\(keiko VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(), re.M)
    citation = re.search(r"^version: ([\d.]+)$", (ROOT / "CITATION.cff").read_text(), re.M)
    if project and citation and project[1] == citation[1]:
        return []
    return ["CITATION.cff: its version is not that of CMakeLists.txt"]


def link_faults(page):
    text = CODE.sub("", page.read_text(encoding="utf-8"))
    faults = []
    for match in LINK.finditer(text):
        link = match[1] or match[2]
        if re.match(r"[a-z]+:", link):
            continue
        path, _, anchor = link.partition("#")
        target = (page.parent / path).resolve() if path else page
        if not target.is_relative_to(ROOT) or not target.exists():
            faults.append(f"{page.relative_to(ROOT)}: no such file: {link}")
        elif anchor and target.suffix == ".md" and anchor not in anchors(target):
            faults.append(f"{page.relative_to(ROOT)}: no such heading: {link}")
    return faults


def pages():
    found = [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]
    return found + [ROOT / folder / "README.md" for folder in ("lightrigs", "surfaces")]


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    faults = cli_faults(sys.argv[1]) + citation_faults()
    for page in pages():
        faults += link_faults(page)
    faults += prose_rules.faults(ROOT)
    for fault in faults:
        print(fault)
    if faults:
        sys.exit(1)
    print("docs hold")


main()
