#!/usr/bin/env python3
"""Writes the reference of the installed headers as pages, and fails where Doxygen warns.

usage: docs/build_reference.py FOLDER

A public name without a comment is a warning. Line numbers in warnings are those of the header.
"""
import shutil
import subprocess
import sys
from pathlib import Path

sys.dont_write_bytecode = True
ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests"))
from doxygen_filter import filtered
from public_headers import SOURCES, public_headers

SKIPPED = 77


def copy_filtered(headers: list, folder: Path):
    """Copies of headers, paths below SOURCES, as Doxygen reads them, and of nothing else."""
    shutil.rmtree(folder, ignore_errors=True)
    for header in headers:
        copy = folder / header
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_text(filtered((SOURCES / header).read_text(encoding="utf-8")), encoding="utf-8")


def run_doxygen(headers: list, folder: Path, **settings: str) -> list:
    """Runs Doxygen over headers into a folder; returns its warnings, naming files of SOURCES."""
    copies = folder / "headers"
    copy_filtered(headers, copies)
    own = {"OUTPUT_DIRECTORY": folder, "INPUT": copies, "STRIP_FROM_PATH": copies,
           "STRIP_FROM_INC_PATH": copies, **settings}
    text = (ROOT / "docs/Doxyfile").read_text() + "".join(f'{key} = "{value}"\n' for key, value in own.items())
    run = subprocess.run(["doxygen", "-"], input=text, stderr=subprocess.PIPE, text=True, check=False)
    if run.returncode:
        sys.exit(run.stderr)
    return run.stderr.replace(str(copies), str(SOURCES)).splitlines()


def main(folder: Path) -> int:
    if not shutil.which("doxygen"):
        print("the reference is not built: there is no doxygen")
        return SKIPPED
    warnings = run_doxygen(public_headers(), folder)
    print("\n".join(warnings) or f"reference written to {folder / 'html/index.html'}")
    return bool(warnings)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.exit(main(Path(sys.argv[1]).resolve()))
