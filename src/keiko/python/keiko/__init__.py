"""Evaluate the quality of free-form surfaces by what they reflect.

Lengths are in mm, angles in degrees, luminances in cd/m2. Long functions release the interpreter's
lock, call `progress(stage, fraction)` if one is given, and end on Ctrl-C. Bad input raises Error.
"""
import html as _html
import json as _json
import os as _os

from ._keiko import Error, Film, Scene, check_json, hit_dtype, inspect_texts, open_scene, render_film, version

__version__ = version()
__all__ = ["Check", "Error", "Film", "Report", "Scene", "check", "hit_dtype", "inspect", "open_scene",
           "render", "version"]


class Check:
    """A body judged by criteria: the keys and values of `keiko check --json`."""

    def __init__(self, text: str):
        self._text = text
        self._values = _json.loads(text)

    @property
    def verdict(self) -> str:
        """"pass", "undecided" or "fail"."""
        return self._values["verdict"]

    @property
    def findings(self) -> list:
        """What does not pass, the worst first."""
        return self._values["findings"]

    @property
    def seams(self) -> list:
        """Every stretch of every seam with its gap, angle and curvatures."""
        return self._values["seams"]

    @property
    def faces(self) -> list:
        """Every placed face with its curvature and flaws."""
        return self._values["faces"]

    def to_json(self) -> str:
        """The text of the JSON document."""
        return self._text

    def to_dict(self) -> dict:
        """The whole document."""
        return self._values

    def __reduce__(self):
        return type(self), (self._text,)

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {self.verdict}, {len(self.findings)} findings>"

    def _repr_html_(self) -> str:
        rows = "".join(
            f"<tr><td>{i}</td><td>{_html.escape(f['code'])}</td><td>{_html.escape(f['faces'])}</td>"
            f"<td style='text-align:left'>{_html.escape(f['message'])}</td></tr>"
            for i, f in enumerate(self.findings[:20], 1))
        return (f"<p><b>{self.verdict}</b>, {len(self.findings)} findings</p>"
                f"<table><tr><th>#</th><th>code</th><th>faces</th><th>what</th></tr>{rows}</table>")


class Report(Check):
    """The whole inspection of a body: the keys and values of report.json, with page and pictures."""

    def __init__(self, text: str, page: str, files=None):
        super().__init__(text)
        self._page = page
        self._files = files or {}

    @property
    def html(self) -> str:
        """The page for people, pictures included."""
        return self._page

    def write(self, folder) -> None:
        """Writes what `keiko inspect -o folder` writes."""
        _os.makedirs(folder, exist_ok=True)
        for name, content in self._files.items():
            with open(_os.path.join(folder, name), "wb") as file:
                file.write(content)

    def __reduce__(self):
        return type(self), (self._text, self._page, self._files)

    def _repr_html_(self) -> str:
        return (f'<iframe srcdoc="{_html.escape(self._page)}" width="100%" height="720" '
                'frameborder="0"></iframe>')


def _reopen(paths, options) -> Scene:
    """A scene from a pickle."""
    return open_scene(paths, **options)


def check(input, preset: str = "class-a-outer", *, join: float = 0.5, unit: str = "", axes: str = "",
          progress=None, threads: int = 0) -> Check:
    """Judges the geometry of model files, or of one scene file, by a preset or a preset file."""
    return Check(check_json(input, preset, join, unit, axes, progress, threads))


def inspect(scene, preset: str = "class-a-outer", *, join: float = 0.5, views=(), rig=None,
            progress=None, threads: int = 0) -> Report:
    """Places lamps, renders views, measures and judges. `scene`: a Scene, or what opens one."""
    if not isinstance(scene, Scene):
        scene = open_scene(scene, progress=progress, threads=threads)
    texts = inspect_texts(scene, preset, join, list(views), rig, progress, threads)
    return Report(texts.json, texts.html, texts.files("."))


def render(scene, view: str = "", *, rig=None, width: int = 960, height: int = 540, aovs=(),
           progress=None, threads: int = 0) -> Film:
    """The picture of a scene: `numpy.asarray` of it is height x width x 3, cd/m2.

    `view` is a named view, or empty for the scene's own. `rig` is a rig file; without one the lamps
    are the scene's own, or placed for the view.
    """
    if not isinstance(scene, Scene):
        scene = open_scene(scene, progress=progress, threads=threads)
    return render_film(scene, view, rig, width, height, list(aovs), progress, threads)
