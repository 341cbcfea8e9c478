#!/usr/bin/env python3
"""Prints the share of public names with a comment, by room; fails for an installed one without.

usage: tests/documented_names.py [--list]
--list adds the names without a comment.

Names are types, functions, variables, aliases, enumerations and their values in headers. What is
private, defaulted or deleted has no meaning of its own, nor has a destructor.
"""
import collections
import shutil
import sys
import tempfile
import xml.etree.ElementTree as xml
from pathlib import Path

sys.dont_write_bytecode = True
ROOT = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT / "docs"), str(ROOT / "tests")]
from build_reference import SKIPPED, run_doxygen
from public_headers import SOURCES, public_headers

KINDS = {"class", "struct", "union", "namespace"}


def is_documented(element) -> bool:
    return any("".join(element.find(part).itertext()).strip()
               for part in ("briefdescription", "detaileddescription") if element.find(part) is not None)


def is_counted(member) -> bool:
    text = (member.findtext("argsstring") or "").replace(" ", "")
    return (member.get("kind") in {"function", "variable", "typedef", "enum"} and member.get("prot") == "public"
            and not text.endswith(("=default", "=delete")) and not member.findtext("name").startswith("~"))


def names_of(compound):
    """(header, name, whether it is documented) of a compound and its members."""
    own = compound.findtext("compoundname")
    if compound.get("kind") != "namespace":
        yield compound.find("location").get("file"), own, is_documented(compound)
    for member in compound.iter("memberdef"):
        if not is_counted(member):
            continue
        header, name = member.find("location").get("file"), f"{own}::{member.findtext('name')}"
        yield header, name, is_documented(member)
        for value in member.iter("enumvalue"):
            yield header, f"{name}::{value.findtext('name')}", is_documented(value)


def all_names(headers: list) -> dict:
    """Whether each (header, name) is documented; of several declarations one is enough."""
    names = collections.defaultdict(bool)
    with tempfile.TemporaryDirectory(prefix="keiko-names-") as folder:
        run_doxygen(headers, Path(folder), GENERATE_HTML="NO", GENERATE_XML="YES", XML_PROGRAMLISTING="NO",
                    EXTRACT_ALL="YES", EXTRACT_ANON_NSPACES="NO", WARNINGS="NO")
        for path in sorted(Path(folder, "xml").glob("*.xml")):
            for compound in xml.parse(path).getroot().findall("compounddef"):
                if compound.get("kind") in KINDS and compound.get("prot", "public") == "public":
                    for header, name, documented in names_of(compound):
                        names[header, name] |= documented
    return names


def share(flags: list) -> str:
    return f"{100 * sum(flags) / len(flags):6.1f} % of {len(flags):5}"


def main(arguments: list) -> int:
    if not shutil.which("doxygen"):
        print("names are not counted: there is no doxygen")
        return SKIPPED
    public = set(public_headers())
    names = all_names(sorted(str(path.relative_to(SOURCES)) for path in SOURCES.rglob("*.h")))
    rooms = collections.defaultdict(list)
    for (header, _), documented in names.items():
        rooms["installed" if header in public else Path(header).parts[1]].append(documented)
    for room, flags in sorted(rooms.items(), key=lambda item: (item[0] != "installed", item[0])):
        print(f"{room:12}{share(flags)}")
    others = [flag for room, flags in rooms.items() if room != "installed" for flag in flags]
    print(f"{'others':12}{share(others)}")
    missing = [f"{header}: {name}" for (header, name), documented in names.items() if not documented]
    undocumented = [line for line in missing if line.partition(":")[0] in public]
    print("\n".join(missing if "--list" in arguments else undocumented))
    return bool(undocumented)


if __name__ == "__main__":
    if sys.argv[1:] not in ([], ["--list"]):
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1:]))
