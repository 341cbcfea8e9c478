"""HTML that a notebook shows of results: the verdict first, then the worst in a table."""
from __future__ import annotations

import html

MOST_ROWS = 20


def framed(page: str) -> str:
    """A page in a frame of a notebook."""
    return f'<iframe srcdoc="{html.escape(page)}" width="100%" height="720" frameborder="0"></iframe>'


def heading(first: str, rest: str) -> str:
    """A line that begins with the verdict, or with a name."""
    return f"<p><b>{html.escape(first)}</b>, {html.escape(rest)}</p>"


def table(columns: list, rows) -> str:
    """The first of some rows of cells in a table, with a line that counts the others; empty without rows."""
    rows = list(rows)
    if not rows:
        return ""

    def line(cells, tag: str) -> str:
        marked = (f"<{tag} style='text-align:left'>{html.escape(str(cell))}</{tag}>" for cell in cells)
        return f"<tr>{''.join(marked)}</tr>"
    more = f"<p>and {len(rows) - MOST_ROWS} more</p>" if len(rows) > MOST_ROWS else ""
    lines = "".join(line(row, "td") for row in rows[:MOST_ROWS])
    return f"<table>{line(columns, 'th')}{lines}</table>{more}"


def counted(number: int, one: str) -> str:
    """ "1 face", "2 faces"."""
    return f"{number} {one}{'' if number == 1 else 's'}"


def _size(bounds) -> str:
    return " x ".join(f"{side:.6g}" for side in bounds[1] - bounds[0]) + " mm"


def _body(name: str, body) -> str:
    faces, lost = body.faces, body.lost_faces
    rest = f"{counted(len(faces), 'face')}, {_size(body.bounds)}, {counted(len(lost), 'lost face')}"
    return (heading(name, rest) + table(["lost"], ([reason] for reason in lost))
            + table(["face", "name", "layer"], (face for face in faces if any(face[1:]))))


def model(body) -> str:
    """A Model: its source, its size and its faces with names or layers."""
    return _body(body.source, body)


def scene(body) -> str:
    """A Scene: its files, its size and its faces with names or layers."""
    return _body(" + ".join(path.name for path in body.paths) or "a body from bytes", body)


def placement(placed) -> str:
    """A Placement: the share that mirrors lamps, remarks, and the text of its rig."""
    return (heading(f"{placed.coverage:.1%} covered", counted(placed.rig.text.count("[["), "source"))
            + table(["remark"], ([remark] for remark in placed.remarks))
            + f"<details><summary>rig</summary><pre>{html.escape(placed.rig.text)}</pre></details>")


def mesh(triangles) -> str:
    """A Mesh: its size, its deviation, and the range of each field."""
    def span(values) -> list:
        known = values[abs(values) < float("inf")]
        return [f"{known.min():.6g}", f"{known.max():.6g}"] if len(known) else ["", ""]
    rest = (f"{counted(len(triangles.points), 'point')}, within {triangles.deviation:.3g} mm of the surface, "
            f"{counted(len(triangles.lost_faces), 'lost face')}")
    return (heading(counted(len(triangles.triangles), "triangle"), rest)
            + table(["lost"], ([reason] for reason in triangles.lost_faces))
            + table(["field", "lowest", "highest"],
                    ([name, *span(values)] for name, values in triangles.fields.items())))
