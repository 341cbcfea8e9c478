#!/usr/bin/env python3
"""Writes the table of docs/placement.md, between its markers: rigs that `keiko place` hangs beside
tubes hung by hand over the body, as lightrigs/overhead.toml has them, with as many lamps.

usage: tests/placement_table.py KEIKO
"""
import json
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
MODELS = ROOT.parent / "shared" / "models"
PAGE = ROOT / "docs" / "placement.md"
BEGIN, END = "<!-- begin placements -->\n", "<!-- end placements -->\n"
# With views that show much of them from below the lamps.
BODIES = {ROOT / "surfaces" / "hood.step": "high-front",
          ROOT / "surfaces" / "concept-car.step": "high-left",
          MODELS / "car-hood.brep": "high-front",
          MODELS / "car-front-fender.brep": "left",
          MODELS / "car-rear-deck-half-panel.brep": "high-rear"}


def keiko(program: str, *arguments: str) -> str:
    return subprocess.run([program, *arguments, "-q"], capture_output=True, text=True,
                          check=True).stdout


def overhead(bounds: dict, lamps: int, across: bool) -> str:
    """A rig over the body's box in x and y, enlarged by half, 1500 mm above its top."""
    low, high = bounds["lower"], bounds["upper"]
    size = [1.5 * (high[k] - low[k]) for k in range(2)]
    corner = [(low[k] + high[k]) / 2 - size[k] / 2 for k in range(2)] + [high[2] + 1500]
    u, v = [size[0], 0, 0], [0, size[1], 0]
    if across:  # the normal, u x v, shall look down on the body
        u, v = v, u
    else:
        corner[1] += size[1]
        v[1] = -size[1]
    pitch = max(map(abs, v)) / lamps
    return (f'format = "keiko-rig/1"\nname = "overhead"\n[[c_plane]]\norigin = {corner}\n'
            f"u = {u}\nv = {v}\nlamps = {lamps}\ndiameter = {0.3 * pitch}\nluminance = 9000\n")


def told(program: str, folder: Path, body: Path, *arguments: str) -> dict:
    report = folder / "report"
    keiko(program, "place", str(body), "--report", str(report), *arguments)
    return json.loads((report / "placement.json").read_text())


def row(name: str, rig: str, placement: dict) -> str:
    stripes = placement["stripes"]
    lamps = sum(plane["lamps"] for plane in placement["planes"])
    return (f"| {name} | {rig} | {lamps} | {100 * placement['coverage']:.1f} % "
            f"| {stripes['narrow']:.0f} / {stripes['median']:.0f} / {stripes['wide']:.0f} "
            f"| {100 * stripes['in_range']:.0f} % | {stripes['uniformity']:.2f} |")


def rows(program: str, folder: Path, body: Path, view: str):
    """Placed in up to three rows, in one, and hung by hand both ways."""
    rig = folder / "rig.toml"
    bounds = json.loads(keiko(program, "info", str(body), "--json"))["bounds"]
    placed = told(program, folder, body, "--view", view, "-o", str(rig))
    yield row(f"`{body.name}`, {view}", "placed", placed)
    if len(placed["planes"]) > 1:
        single = told(program, folder, body, "--view", view, "--planes", "1", "-o", str(rig))
        yield row("", "placed, one row", single)
    lamps = sum(plane["lamps"] for plane in placed["planes"])
    for across in (False, True):
        rig.write_text(overhead(bounds, lamps, across))
        rated = told(program, folder, body, "--view", view, "--rate", str(rig))
        yield row("", "overhead, " + ("across" if across else "along"), rated)


def table(program: str) -> str:
    text = ("| body, view | rig | lamps | coverage | stripes px, narrow / median / wide | as wanted "
            "| evenness |\n|---|---|--:|--:|--:|--:|--:|\n")
    with tempfile.TemporaryDirectory() as folder:
        for body, view in BODIES.items():
            if body.exists():
                text += "\n".join(rows(program, Path(folder), body, view)) + "\n"
            else:
                print(f"{body.name} is not there: left out", file=sys.stderr)
    return text


def main():
    page = PAGE.read_text()
    begin, end = page.index(BEGIN) + len(BEGIN), page.index(END)
    PAGE.write_text(page[:begin] + table(sys.argv[1]) + page[end:])


if __name__ == "__main__":
    main()
