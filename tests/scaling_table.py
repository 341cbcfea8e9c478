#!/usr/bin/env python3
"""Writes the table of docs/benchmarks.md on how inspection grows with the number of seams: a gently
curved panel of n x n bicubic patches, each a face of its own.

usage: tests/scaling_table.py KEIKO
"""
import json
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

PAGE = Path(__file__).resolve().parent.parent / "docs" / "benchmarks.md"
BEGIN, END = "<!-- begin scaling -->\n", "<!-- end scaling -->\n"
SIZE = 3000  # mm, of the panel
ROUNDS = 3


def square(begin: float, end: float) -> list:
    """Cubic Bernstein coefficients of t^2 over a patch."""
    return [begin**2, (begin**2 + 2 * begin * end) / 3, (2 * begin * end + end**2) / 3, end**2]


def panel(count: int) -> str:
    """A patch file of z = -x^2 / 6000 - y^2 / 8000."""
    lines, edge = [str(count * count)], SIZE / count
    at = [i * edge - SIZE / 2 for i in range(count + 1)]
    for i in range(count):
        for j in range(count):
            lines.append("3 3")
            along, across = square(at[i], at[i + 1]), square(at[j], at[j + 1])
            lines += [f"{at[i] + a * edge / 3!r} {at[j] + b * edge / 3!r} "
                      f"{-along[a] / 6000 - across[b] / 8000!r}" for a in range(4) for b in range(4)]
    return "\n".join(lines) + "\n"


def seconds(*command: str) -> float:
    """Least processor time of some runs."""
    best = float("inf")
    for _ in range(ROUNDS):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run(command, capture_output=True, check=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        best = min(best, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
    return best


def row(keiko: str, folder: Path, count: int) -> str:
    model, rig, lines = folder / "panel.bpt", folder / "rig.toml", folder / "lines.json"
    model.write_text(panel(count))
    view = ("--view", "high-front", "-q")
    subprocess.run([keiko, "place", model, "-o", rig, *view], capture_output=True, check=True)
    check = seconds(keiko, "check", str(model), "-q")
    found = seconds(keiko, "lines", str(model), "--rig", str(rig), "-o", str(lines), *view)
    crossings = len(json.loads(lines.read_text())["crossings"])
    return (f"| {count * count} | {2 * count * (count - 1)} | {check:.2f} s | {crossings} | "
            f"{found:.2f} s |\n")


def main() -> None:
    table = ("| faces | seams | `keiko check` | crossings of lines and seams | `keiko lines` |\n"
             "|--:|--:|--:|--:|--:|\n")
    with tempfile.TemporaryDirectory() as folder:
        for count in 15, 30, 60, 120:
            table += row(sys.argv[1], Path(folder), count)
    page = PAGE.read_text()
    PAGE.write_text(page[:page.index(BEGIN) + len(BEGIN)] + table + page[page.index(END):])


if __name__ == "__main__":
    main()
