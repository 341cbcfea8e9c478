#!/usr/bin/env python3
"""Draws the house as it is into docs/images/house.svg: rooms, chambers, arrows and lines.

usage: docs/draw_house.py [--check]
--check writes nothing and fails where the picture is not true any more: where a room, a chamber or
an arrow differs, or the lines of a room by more than a tenth.
"""
import re
import sys
from pathlib import Path

sys.dont_write_bytecode = True
ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests"))
from house import CHAMBERS, ROOMS, reachable

PICTURE = ROOT / "docs/images/house.svg"
WIDTH, GAP, LEFT, SPACE = 150, 26, 20, 34
STYLE = ("text{font:12px sans-serif;fill:#222}.room{font-weight:bold;font-size:13px}.small{font-size:10px;fill:#555}"
         "rect{fill:#f4f6fa;stroke:#8090a8}path{fill:none;stroke:#8090a8;marker-end:url(#tip)}")


def lines_of(room: str) -> int:
    """Lines of all sources of a room."""
    files = [p for p in (ROOT / "src/keiko" / room).rglob("*") if p.suffix in {".h", ".cpp"}]
    return sum(len(p.read_text(encoding="utf-8").splitlines()) for p in files)


def arrows() -> list:
    """Pairs of a room and one that it is built on, without those that follow from others."""
    return [(room, low) for room, lower in ROOMS.items() for low in sorted(lower)
            if not any(low in reachable(ROOMS, other) for other in lower - {low})]


def floors() -> list:
    """Rooms by the longest way down to the ground, the lowest first."""
    level = {}
    for room, lower in ROOMS.items():
        level[room] = 1 + max((level[low] for low in lower), default=-1)
    return [[r for r in ROOMS if level[r] == floor] for floor in range(max(level.values()) + 1)]


def height(room: str) -> int:
    return 28 + 13 * ((len(CHAMBERS.get(room, {})) + 1) // 2)


def places() -> dict:
    """Upper left corner of each room's box."""
    rows = floors()[::-1]
    widest = max(len(row) for row in rows)
    found, top = {}, 20
    for row in rows:
        left = LEFT + (widest - len(row)) * (WIDTH + GAP) / 2
        for i, room in enumerate(row):
            found[room] = (left + i * (WIDTH + GAP), top)
        top += max(map(height, row)) + SPACE
    return found


def box(room: str, x: float, y: float, lines: int) -> str:
    chambers = list(CHAMBERS.get(room, {}))
    words = [", ".join(chambers[i:i + 2]) for i in range(0, len(chambers), 2)]
    rows = "".join(f'<text x="{x + 8:g}" y="{y + 34 + 13 * i:g}" class="small">{word}</text>'
                   for i, word in enumerate(words))
    return (f'<g id="{room}" data-lines="{lines}" data-chambers="{" ".join(chambers)}">'
            f'<rect x="{x:g}" y="{y:g}" width="{WIDTH}" height="{height(room)}" rx="5"/>'
            f'<text x="{x + 8:g}" y="{y + 18:g}" class="room">{room}</text>'
            f'<text x="{x + WIDTH - 8:g}" y="{y + 18:g}" class="small" text-anchor="end">{lines:,}</text>{rows}</g>')


def arrow(room: str, low: str, at: dict) -> str:
    (x0, y0), (x1, y1) = at[room], at[low]
    x0, y0, x1 = x0 + WIDTH / 2, y0 + height(room), x1 + WIDTH / 2
    bend = (y1 - y0) / 2
    return (f'<path data-from="{room}" data-to="{low}" '
            f'd="M{x0:g} {y0:g}C{x0:g} {y0 + bend:g} {x1:g} {y1 - bend:g} {x1:g} {y1 - 4:g}"/>')


def drawn() -> str:
    at = places()
    width = max(x for x, _ in at.values()) + WIDTH + LEFT
    depth = max(y + height(room) for room, (_, y) in at.items()) + 20
    parts = [arrow(room, low, at) for room, low in arrows()]
    parts += [box(room, x, y, round(lines_of(room), -2)) for room, (x, y) in at.items()]
    tip = ('<defs><marker id="tip" markerWidth="8" markerHeight="8" refX="6" refY="3" orient="auto">'
           '<path d="M0 0L6 3L0 6" style="marker-end:none"/></marker></defs>')
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:g}" height="{depth:g}" '
            f'viewBox="0 0 {width:g} {depth:g}"><style>{STYLE}</style>{tip}\n' + "\n".join(parts) + "\n</svg>\n")


def facts(svg: str) -> tuple:
    """Rooms with chambers and lines, and the arrows, as a picture has them."""
    rooms = {name: (chambers, int(lines)) for name, lines, chambers in
             re.findall(r'<g id="(\w+)" data-lines="(\d+)" data-chambers="([^"]*)"', svg)}
    return rooms, set(re.findall(r'data-from="(\w+)" data-to="(\w+)"', svg))


def faults(svg: str):
    rooms, ways = facts(svg)
    true_rooms, true_ways = facts(drawn())
    for room in sorted(rooms.keys() | true_rooms.keys()):
        chambers, lines = rooms.get(room, (None, 0))
        true_chambers, true_lines = true_rooms.get(room, (None, 0))
        if chambers != true_chambers:
            yield f"room {room} is not as it is drawn"
        elif abs(lines - true_lines) > 0.1 * true_lines + 100:
            yield f"room {room} has {true_lines} lines and is drawn with {lines}"
    for room, low in sorted(ways ^ true_ways):
        yield f"the arrow from {room} to {low} is not as it is drawn"


if __name__ == "__main__":
    if sys.argv[1:] == ["--check"]:
        found = list(faults(PICTURE.read_text(encoding="utf-8")))
        print("\n".join(f"{PICTURE.name}: {fault}; run docs/draw_house.py" for fault in found) or "the house is true")
        sys.exit(bool(found))
    PICTURE.write_text(drawn(), encoding="utf-8")
