#!/usr/bin/env python3
"""Fails unless exactly the installed headers are marked, and these show no third-party library.

usage: tests/public_headers.py [--mark]
--mark writes the marks: `namespace KEIKO_API keiko` and the include of base/export.h.

Installed are the headers of api and what they reach (src/cmake/public_headers.cmake). What such a
header declares without its mark is hidden in the library: programs that use it do not link.
"""
import re
import subprocess
import sys
from pathlib import Path

SOURCES = Path(__file__).resolve().parent.parent / "src"
EXPORT = "keiko/base/export.h"
MARKED, PLAIN = "namespace KEIKO_API keiko {", "namespace keiko {"
MOST_API_HEADERS = 14
INCLUDE = re.compile(r'^#include ["<]([^">]+)[">]\n', re.M)
FRIEND = re.compile(r"^ +friend (?!class |struct )[^;{}=]*?\b(operator\W+?|\w+)\([^;{}=]*\);", re.M)
# Third-party libraries whose headers an installed header may include; the others stay hidden.
SHOWN = ("Imath/",)


def public_headers() -> list:
    """Paths of the installed headers below SOURCES."""
    script = SOURCES / "cmake/public_headers.cmake"
    run = subprocess.run(["cmake", "-P", str(script)], stderr=subprocess.PIPE, text=True, check=False)
    if run.returncode:
        sys.exit(run.stderr)
    return run.stderr.split()


def with_include(text: str) -> str:
    """The text with the include of EXPORT, in its place among those of the project."""
    if f'#include "{EXPORT}"\n' in text:
        return text
    own = [m for m in INCLUDE.finditer(text) if m[1].startswith("keiko/")]
    line = f'#include "{EXPORT}"\n'
    for include in own:
        if include[1] > EXPORT:
            return text[:include.start()] + line + text[include.start():]
    if own:
        return text[:own[-1].end()] + line + text[own[-1].end():]
    return text.replace("#pragma once\n\n", f"#pragma once\n\n{line}\n", 1)


def marked(text: str) -> str:
    return with_include(text).replace(PLAIN, MARKED) if PLAIN in text else text


def unmarked(text: str) -> str:
    text = text.replace(MARKED, PLAIN)
    return re.sub(rf'#include "{re.escape(EXPORT)}"\n(\n(?=#include <|\n|///|namespace))?', "", text)


def shows_too_much(text: str) -> list:
    """Includes of an installed header that are neither the project's, the standard's nor SHOWN."""
    return [name for name in INCLUDE.findall(text)
            if not name.startswith(("keiko/", *SHOWN)) and not re.fullmatch(r"[a-z_]+", name)]


def hidden_friends(text: str) -> list:
    """Functions that a class declares as friends before the marked namespace does: they stay hidden."""
    return [m[1] for m in FRIEND.finditer(text)
            if not re.search(rf"^(?!friend)\w[^\n]*\b{re.escape(m[1])}\(", text[:m.start()], re.M)]


def faults(public: list):
    verbs = [header for header in public if header.startswith("keiko/api/")]
    if len(verbs) > MOST_API_HEADERS:
        yield f"api has {len(verbs)} headers, more than {MOST_API_HEADERS}"
    for path in sorted(SOURCES.rglob("*.h")):
        header, text = str(path.relative_to(SOURCES)), path.read_text(encoding="utf-8")
        if header == EXPORT:
            continue
        if header not in public:
            if MARKED in text:
                yield f"{header} is marked, but no header of api reaches it"
            continue
        if PLAIN in text:
            yield f"{header} is installed, but not marked"
        for name in hidden_friends(text):
            yield f"{header} declares {name} as a friend first: declare it in the namespace before"
        for name in shows_too_much(text):
            yield f"{header} is installed, and shows <{name}>"


def mark(public: list):
    for path in sorted(SOURCES.rglob("*.h")):
        header, text = str(path.relative_to(SOURCES)), path.read_text(encoding="utf-8")
        new = marked(text) if header in public else unmarked(text) if MARKED in text else text
        if new != text:
            path.write_text(new, encoding="utf-8")


def main(arguments: list) -> int:
    public = public_headers()
    if arguments == ["--mark"]:
        mark(public)
    found = list(faults(public))
    print("\n".join(found) or f"{len(public)} installed headers are marked, and no others")
    return bool(found)


if __name__ == "__main__":
    if sys.argv[1:] not in ([], ["--mark"]):
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1:]))
