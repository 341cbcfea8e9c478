"""Results with the keys and values of the JSON documents of the command line."""
from __future__ import annotations

import json
from math import inf

import numpy as np

from . import _pages
from ._keiko import write_report  # type: ignore[import]


class Document:
    """A result with the keys and values of the JSON that the command line writes."""

    def __init__(self, text: str):
        self._text = text
        self._values = json.loads(text)

    def to_json(self) -> str:
        """The text of the JSON document."""
        return self._text

    def to_dict(self) -> dict:
        """The whole document."""
        return self._values

    def __reduce__(self):
        return type(self), (self._text,)

    def __repr__(self) -> str:
        return f"<{type(self).__name__} of {len(self._text)} bytes>"


class Judged(Document):
    """A document with a verdict."""

    @property
    def verdict(self) -> str:
        """"pass", "undecided" or "fail"; of a comparison "same" or "different"."""
        return self._values["verdict"]

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {self.verdict}>"


class Check(Judged):
    """A body judged by criteria, as `keiko check --json` has it."""

    def __init__(self, text: str, combs: str | None = None, profiles: str | None = None, curves=()):
        super().__init__(text)
        self._combs, self._profiles = combs, profiles
        self.curves = list(curves)  # a Curve each, empty unless requested

    @property
    def findings(self) -> list:
        """What the verdict rests on: all that fails or is undecided, the worst first."""
        return [finding for finding in self._values["findings"] if finding["severity"] == "judged"]

    @property
    def looks(self) -> list:
        """Places worth a look, which no limit judges."""
        return [finding for finding in self._values["findings"] if finding["severity"] == "look"]

    @property
    def seams(self) -> list:
        """Every stretch of every seam with its gap, angle and curvatures."""
        return self._values["seams"]

    @property
    def faces(self) -> list:
        """Every placed face with its curvature and flaws."""
        return self._values["faces"]

    @property
    def joints(self) -> list:
        """Joints between panels with their sections; empty where they were not sought."""
        return self._values.get("joints", [])

    @property
    def combs(self) -> list:
        """Sections and iso-curves with their curvature, as `keiko check --combs` has them."""
        return json.loads(self._combs)["curves"] if self._combs else []

    @property
    def profiles(self) -> list:
        """Stretches with their values all along, as `keiko check --profiles` has them."""
        return json.loads(self._profiles)["profiles"] if self._profiles else []

    def __reduce__(self):
        return type(self), (self._text, self._combs, self._profiles, self.curves)

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {self.verdict}, {len(self.findings)} findings, {len(self.looks)} looks>"

    def _repr_html_(self) -> str:
        rows = ((i, f["code"], f["faces"], f["message"]) for i, f in enumerate(self.findings + self.looks, 1))
        return (_pages.heading(self.verdict, f"{len(self.findings)} findings, {len(self.looks)} looks")
                + _pages.table(["#", "code", "faces", "what"], rows))


class Report(Check):
    """The whole inspection of a body: the keys and values of report.json, with page and pictures."""

    def __init__(self, files: dict, base: str):
        combs = files.get("combs.json")
        super().__init__(files["report.json"].decode(), combs and combs.decode())
        self._files, self._base = files, base

    @property
    def html(self) -> str:
        """The page for people, pictures included."""
        return self._files["report.html"].decode()

    def write(self, folder) -> None:
        """Writes what `keiko inspect -o folder` writes, in place of earlier results there."""
        write_report(folder, self._files, self._base)

    def __reduce__(self):
        return type(self), (self._files, self._base)

    def _repr_html_(self) -> str:
        return _pages.framed(self.html)


class Lines(Judged):
    """Lines of the lamps on a body, as `keiko lines` writes them."""

    def __init__(self, text: str, curves=()):
        super().__init__(text)
        self.curves = list(curves)  # a Curve each, empty unless requested

    def __reduce__(self):
        return type(self), (self._text, self.curves)

    def _repr_html_(self) -> str:
        counts, found = self._values["counts"], self._values["lines"]
        words = ", ".join(f"{count} {name.replace('_', ' ')}" for name, count in counts.items())
        length = sum(line["length"] for line in found)
        order = ["fail", "undecided", "pass"]
        judged = sorted((c for c in self._values["crossings"] if c["verdict"] in order),
                        key=lambda c: (order.index(c["verdict"]), -(inf if c["severity"] is None else c["severity"])))
        rows = ((i, c["verdict"], c["view"], c["faces"], ", ".join(f"{x:.1f}" for x in c["place"]))
                for i, c in enumerate(judged, 1))
        return (_pages.heading(self.verdict, f"crossings: {words}; {len(found)} lines of {length:.0f} mm")
                + _pages.table(["#", "verdict", "view", "faces", "place"], rows))


class Comparison(Judged):
    """Two revisions of a part, as `keiko compare --json` has them, with page and pictures."""

    def __init__(self, files: dict, base: str):
        super().__init__(files["compare.json"].decode())
        self._files, self._base = files, base

    @property
    def html(self) -> str:
        """The page for people, pictures included."""
        return self._files["compare.html"].decode()

    def write(self, folder) -> None:
        """Writes what `keiko compare -o folder` writes, in place of earlier results there."""
        write_report(folder, self._files, self._base)

    def __reduce__(self):
        return type(self), (self._files, self._base)

    def _repr_html_(self) -> str:
        values = self._values
        rows = [("within" if c["within"] else "beyond" if c["judged"] else "not judged", c["name"], c["message"])
                for c in values["checks"]]
        findings = values["findings"]
        changed = [(state, f["code"], f["faces"], f["message"]) for state in ("new", "fixed") for f in findings[state]]
        return (_pages.heading(self.verdict, f"{values['before']} and {values['after']}")
                + _pages.table(["", "check", "what"], rows)
                + _pages.table(["finding", "code", "faces", "what"], changed))


class MeshErrors(Document):
    """What meshes of a part do to its reflections, as `keiko mesh-error --json` has it, with page and pictures."""

    def __init__(self, files: dict, base: str):
        super().__init__(files["mesh-error.json"].decode())
        self._files, self._base = files, base

    @property
    def meshes(self) -> list:
        """A dictionary a mesh: `asked` and `deviation` in mm, `triangles`, `lost_faces`, and `wrong_share`.

        `wrong_share` is the share of the compared pixels of all views that are wrong, None if none mirrors lamps.
        """
        return self._values["meshes"]

    @property
    def figures(self) -> np.ndarray:
        """The errors in numbers: a structured array with a row for each view and mesh.

        `view` and `asked` (mm) name the row. Numbers of pixels are `body`, `compared`, `wrong` (lamps fill another
        share, by more than 0.1), `reversed` (by more than 0.5), `missed`, `added` and `other_face`, and of these the
        ones inside of faces, `missed_inside` and so on. Sizes are `pixels`, `on_part` and `at_lamps`, the displacement
        of mirrored lines in pixels and in mm, and `normal`, in seconds of arc: each has `_median`, `_p99` and
        `_largest`. Mach bands at `band_places` borders of facets are `band_truth` of the surface, `band_constant`,
        `band_gouraud` and `band_phong`: second differences from pixel to pixel, in shares of the largest luminance.
        Sizes are NaN where `compared` is 0, Mach bands where `band_places` is: nothing was measured there.
        """
        rows = [_figures(view["view"], mesh) for view in self._values["views"] for mesh in view["meshes"]]
        kinds = {str: f"U{max(len(row['view']) for row in rows)}", int: "i8", float: "f8"}
        columns = [(name, kinds[type(value)]) for name, value in rows[0].items()]
        return np.array([tuple(row.values()) for row in rows], columns)

    @property
    def html(self) -> str:
        """The page for people, pictures included."""
        return self._files["mesh-error.html"].decode()

    def write(self, folder) -> None:
        """Writes what `keiko mesh-error -o folder` writes, in place of earlier results there."""
        write_report(folder, self._files, self._base)

    def __reduce__(self):
        return type(self), (self._files, self._base)

    def __repr__(self) -> str:
        return f"<MeshErrors: {_pages.counted(len(self.figures), 'row')}, one a view and mesh>"

    def _repr_html_(self) -> str:
        return _pages.framed(self.html)


def _figures(view: str, mesh: dict) -> dict:
    """The errors of a mesh in a view by the columns of MeshErrors.figures."""
    errors, bands = mesh["errors"], mesh["facet_bands"]
    row = {"view": view, "asked": float(mesh["asked"])}
    row |= {name: errors[name] for name in ("body", "compared", "wrong", "reversed")}
    for name in ("missed", "added", "other_face"):
        row |= {name: errors[name]["all"], f"{name}_inside": errors[name]["inside"]}
    for name, sizes in (*errors["displacement"].items(), ("normal", errors["normal_arcsec"])):
        row |= {f"{name}_{quantile}": _measured(size, errors["compared"]) for quantile, size in sizes.items()}
    row["band_places"] = bands["places"]
    return row | {f"band_{name}": _measured(bands[name], bands["places"])
                  for name in ("truth", "constant", "gouraud", "phong")}


def _measured(size: float, places: int) -> float:
    """A size that was measured at a number of places, NaN at none."""
    return float(size) if places else float("nan")


class ScanComparison(Judged):
    """The points of a scan held against the exact surface, as `keiko compare --json` has them.

    `verdict` is "pass", "fail" or "not judged". `deviations` has a row a point: distance (mm, positive
    outside; infinite where nothing is within reach), closest (mm), face (its number; 0 beyond reach), beside
    (beyond a free border) and certain (proved).
    """

    def __init__(self, text: str, html: str, deviations):
        super().__init__(text)
        self.html, self.deviations = html, deviations

    def __reduce__(self):
        return type(self), (self._text, self.html, self.deviations)

    def _repr_html_(self) -> str:
        return _pages.framed(self.html)


class Facts(Document):
    """Contents of a model file, as `keiko info --json` has them."""


class Regression(Document):
    """A suite held against its baselines, as regression.json has it."""

    @property
    def state(self) -> str:
        """"same", "different", "missing" or "error": the worst of all fixtures."""
        return self._values["state"]

    def _repr_html_(self) -> str:
        fixtures = self._values["fixtures"]
        return (_pages.heading(self.state, _pages.counted(len(fixtures), "fixture"))
                + _pages.table(["state", "fixture"], ((one["state"], one["name"]) for one in fixtures)))
