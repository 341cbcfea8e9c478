#!/usr/bin/env python3
"""Fails when a scene or rig of the repository breaks docs/schema/keiko.schema.json, when an example of
its pages does, when the schema lets a misspelt key pass, or when docs/scene-format.md leaves out a key.
The same for examples of accepted findings and of analyses, their schemas and docs/file-formats.md.

usage: tests/check_schema.py; needs python3-jsonschema, and is skipped (exit code 77) without it
"""
import copy
import json
import re
import sys
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
# Of each schema: its formats, and the page that describes its keys.
SCHEMAS = {
    "keiko.schema.json": (("keiko-scene/1", "keiko-rig/1"), "scene-format.md"),
    "keiko-accepted.schema.json": (("keiko-accepted/1",), "file-formats.md"),
    "keiko-analysis.schema.json": (("keiko-analysis/1",), "file-formats.md"),
}
SKIPPED = 77


def as_json(text):
    """What editors hold against a schema: dates are strings."""
    return json.loads(json.dumps(tomllib.loads(text), default=str))


def documents():
    """Every TOML file and every example of the pages, by name."""
    pages = [ROOT / "README.md"]
    for folder in ("docs", "lightrigs", "surfaces", "tests"):
        pages += sorted((ROOT / folder).rglob("*.md"))
        for path in sorted((ROOT / folder).rglob("*.toml")):
            yield str(path.relative_to(ROOT)), as_json(path.read_text(encoding="utf-8"))
    for page in pages:
        text = page.read_text(encoding="utf-8")
        for language, parse in (("toml", as_json), ("json", json.loads)):
            examples = re.findall(rf"^```{language}\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
            for number, example in enumerate(examples):
                yield f"{language} example {number} of {page.relative_to(ROOT)}", parse(example)


def keys(schema):
    """Every key that the schema knows of, at any depth."""
    if isinstance(schema, dict):
        yield from schema.get("properties", {})
    for child in schema.values() if isinstance(schema, dict) else schema if isinstance(schema, list) else ():
        yield from keys(child)


def undocumented(schema, page_name):
    """Keys that no code on the page names."""
    page = (ROOT / "docs" / page_name).read_text(encoding="utf-8")
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


def faults_of(schema_name, jsonschema):
    """Faults of the documents of a schema, and the number of these documents."""
    formats, page = SCHEMAS[schema_name]
    schema = json.loads((ROOT / "docs" / "schema" / schema_name).read_text(encoding="utf-8"))
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    faults, checked = [f"docs/{page}: no {key}" for key in undocumented(schema, page)], 0
    for name, document in documents():
        if not isinstance(document, dict) or document.get("format") not in formats:
            continue
        checked += 1
        faults += [f"{name}: {error.json_path}: {error.message}" for error in validator.iter_errors(document)]
        faults += [f"{name}: a misspelt key passes" for wrong in misspelt(document) if validator.is_valid(wrong)]
    return faults or ([] if checked else [f"{schema_name}: nothing to check"]), checked


def main():
    try:
        import jsonschema
    except ImportError:
        print("python3-jsonschema is not installed")
        return SKIPPED
    faults, total = [], 0
    for schema_name in SCHEMAS:
        found, checked = faults_of(schema_name, jsonschema)
        faults, total = faults + found, total + checked
    print("\n".join(faults) or f"{total} documents keep to their schemas")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
