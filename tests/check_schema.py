#!/usr/bin/env python3
"""Fails when a scene or rig of the repository breaks docs/schema/keiko.schema.json, when an example of
its pages does, when the schema lets a misspelt key pass, or when docs/scene-format.md leaves out a key.

usage: tests/check_schema.py; needs python3-jsonschema, and is skipped (exit code 77) without it
"""
import copy
import json
import re
import sys
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FORMATS = ("keiko-scene/1", "keiko-rig/1")
SKIPPED = 77


def documents():
    """Every TOML file and every example of the pages, by name."""
    pages = [ROOT / "README.md"]
    for folder in ("docs", "lightrigs", "surfaces", "tests"):
        pages += sorted((ROOT / folder).rglob("*.md"))
        for path in sorted((ROOT / folder).rglob("*.toml")):
            yield str(path.relative_to(ROOT)), tomllib.loads(path.read_text(encoding="utf-8"))
    for page in pages:
        text = page.read_text(encoding="utf-8")
        for number, example in enumerate(re.findall(r"^```toml\n(.*?)^```", text, re.MULTILINE | re.DOTALL)):
            yield f"example {number} of {page.relative_to(ROOT)}", tomllib.loads(example)


def keys(schema):
    """Every key that the schema knows of, at any depth."""
    if isinstance(schema, dict):
        yield from schema.get("properties", {})
    for child in schema.values() if isinstance(schema, dict) else schema if isinstance(schema, list) else ():
        yield from keys(child)


def undocumented(schema):
    """Keys that no code on the page names."""
    page = (ROOT / "docs" / "scene-format.md").read_text(encoding="utf-8")
    code = " ".join(re.findall(r"```.*?```|`[^`\n]*`", page, re.DOTALL))
    return sorted(set(keys(schema)) - set(re.findall(r"\w+", code)))


def tables(value):
    """The value and every table in it."""
    if isinstance(value, dict):
        yield value
    for child in value.values() if isinstance(value, dict) else value if isinstance(value, list) else ():
        yield from tables(child)


def misspelt(document):
    """Copies of the document with an unknown key in one table each."""
    for place in range(sum(1 for _ in tables(document))):
        changed = copy.deepcopy(document)
        list(tables(changed))[place]["no_such_key"] = 1
        yield changed


def main():
    try:
        import jsonschema
    except ImportError:
        print("python3-jsonschema is not installed")
        return SKIPPED
    schema = json.loads((ROOT / "docs" / "schema" / "keiko.schema.json").read_text(encoding="utf-8"))
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    faults, checked = [f"docs/scene-format.md: no {key}" for key in undocumented(schema)], 0
    for name, document in documents():
        if document.get("format") not in FORMATS:
            continue
        checked += 1
        faults += [f"{name}: {error.json_path}: {error.message}" for error in validator.iter_errors(document)]
        faults += [f"{name}: a misspelt key passes" for wrong in misspelt(document) if validator.is_valid(wrong)]
    print("\n".join(faults) or f"{checked} scenes and rigs keep to the schema")
    return 1 if faults or checked == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
