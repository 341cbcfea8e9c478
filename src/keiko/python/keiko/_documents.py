"""Results with the keys and values of the JSON documents of the command line."""
from __future__ import annotations

import html
import json

from ._keiko import write_report  # type: ignore[import]


def _framed(page: str) -> str:
    """A page in a frame of a notebook."""
    return f'<iframe srcdoc="{html.escape(page)}" width="100%" height="720" frameborder="0"></iframe>'


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

    def __init__(self, text: str, combs: str | None = None, profiles: str | None = None):
        super().__init__(text)
        self._combs, self._profiles = combs, profiles

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
        return type(self), (self._text, self._combs, self._profiles)

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {self.verdict}, {len(self.findings)} findings, {len(self.looks)} looks>"

    def _repr_html_(self) -> str:
        rows = "".join(
            f"<tr><td>{i}</td><td>{html.escape(f['code'])}</td><td>{html.escape(f['faces'])}</td>"
            f"<td style='text-align:left'>{html.escape(f['message'])}</td></tr>"
            for i, f in enumerate((self.findings + self.looks)[:20], 1))
        return (f"<p><b>{self.verdict}</b>, {len(self.findings)} findings, {len(self.looks)} looks</p>"
                f"<table><tr><th>#</th><th>code</th><th>faces</th><th>what</th></tr>{rows}</table>")


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
        return _framed(self.html)


class Lines(Judged):
    """Lines of the lamps on a body, as `keiko lines` writes them."""


class Comparison(Judged):
    """Two revisions of a part, as `keiko compare --json` has them."""


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
        return _framed(self.html)


class Facts(Document):
    """Contents of a model file, as `keiko info --json` has them."""


class Regression(Document):
    """A suite held against its baselines, as regression.json has it."""

    @property
    def state(self) -> str:
        """"same", "different", "missing" or "error": the worst of all fixtures."""
        return self._values["state"]
