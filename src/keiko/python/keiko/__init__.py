"""Evaluate the quality of free-form surfaces by what they reflect.

Lengths are in mm, angles in degrees, luminances in cd/m2. Long functions release the interpreter's
lock, call `progress(stage, fraction)` if one is given, and end on Ctrl-C. Bad input raises Error, an argument
of a wrong type TypeError.
"""
from __future__ import annotations

import getpass as _getpass
import os as _os
import pathlib as _pathlib
import tempfile as _tempfile

import numpy as _np

from . import _pages
from ._arguments import checked as _checked, each_number as _each_number, error as _error, rows as _rows
from ._documents import Check, Comparison, Document, Facts, Judged, Lines, MeshErrors, Regression, Report, ScanComparison
from ._keiko import (Curve, DeepBuffer, Drawing, Error, Film, Mesh, Model, Placement, Scene, Solution, Spline, accept_baselines,
                     accept_findings, analysis_png, check_json, comparison_files, deep_buffer, draw_sheet, find_lines, hit_dtype,
                     illuminance_numbers, info_json, load_model, luminance_numbers, mesh_error_files, open_scene, place_lamps,
                     read_curves, regress_json, render_film, report_files, scan_deviations, scan_points, solved_radiosity,
                     surface_mesh,
                     unpickled_model, version, write_curves)
from ._picture import Picture
from ._rig import Rig

__version__ = version()
__all__ = ["Check", "Comparison", "Curve", "DeepBuffer", "Document", "Drawing", "Error", "Facts", "Film", "Lines", "Mesh", "MeshErrors", "Model",
           "Picture", "Placement", "Regression", "Report", "Rig", "ScanComparison", "Scene", "Solution", "Spline", "accept",
           "accept_baselines", "analysis_picture", "check", "compare", "compare_scan", "deep_view", "draw", "hit_dtype",
           "illuminance", "info", "inspect", "lines", "load", "luminance", "mesh", "mesh_error", "open_scene", "place",
           "radiosity", "read_curves", "read_scan", "regress", "render", "version", "write_curves"]

for _type in (Check, Comparison, Document, Facts, Judged, Lines, MeshErrors, Picture, Regression, Report, ScanComparison, Rig):
    _type.__module__ = __name__  # what pickles and help() name


def _shown_by(page):
    """The method by which a notebook shows a result."""
    def _repr_html_(self) -> str:
        return page(self)
    return _repr_html_


for _type, _page in ((Mesh, _pages.mesh), (Model, _pages.model), (Placement, _pages.placement), (Scene, _pages.scene)):
    _type._repr_html_ = _shown_by(_page)


def __dir__() -> list:
    """The public names."""
    return [*__all__, "__doc__", "__version__"]


def _unpickled(content, paths) -> Model:
    """A model from a pickle."""
    return unpickled_model(content, paths)


def _reopen(paths, options) -> Scene:
    """A scene from a pickle."""
    return open_scene(paths, **options)


@_checked
def load(input, *, name: str = "", unit: str = "", axes: str = "", progress=None, threads: int = 0) -> Model:
    """Reads a body once, for many verbs: a model file, several ones, or the bytes of one.

    `check`, `info`, `compare`, `open_scene` and all that take a scene take the Model too. `name` stands for the
    file in reports and errors; bytes of a STEP, IGES or BREP file, of what kind is found from them, are called
    "bytes" without one. `unit` and `axes` are those of `keiko check`. A Model is pickled by its content.
    """
    if not isinstance(input, (bytes, bytearray, memoryview)):
        return load_model(input, name, unit, axes, progress, threads)
    with _tempfile.TemporaryDirectory() as folder:
        path = _pathlib.Path(folder) / "model"
        path.write_bytes(input)
        return load_model([path], name or "bytes", unit, axes, progress, threads)


def _opened(scene, progress, threads, shadows: bool = False) -> Scene:
    """A scene, or the one that model files or a scene file make."""
    if isinstance(scene, Scene):
        return scene
    return open_scene(scene, shadows=shadows, progress=progress, threads=threads)


def _words(one_or_more) -> list:
    """Words of one word, or of several words or numbers."""
    alone = isinstance(one_or_more, (str, int))
    return [str(word) for word in ([one_or_more] if alone else one_or_more)]


def _scope(faces, layers, colors, zones) -> dict:
    """The part of a body that is judged."""
    return {"faces": _words(faces), "layers": _words(layers), "colors": _words(colors), "zones": _words(zones)}


def _judging(preset, join, scope, joints, sections, iso_curves, accepted) -> dict:
    """What check and inspect judge alike."""
    if not 0 <= iso_curves <= 1000:
        raise _error("iso_curves", "is not 0 to 1000")
    return {"preset": str(preset), "join": join, "joints": joints, "sections": _words(sections),
            "iso_curves": iso_curves, "accepted": accepted, **scope}


@_checked
def check(input, preset: str = "class-a-outer", *, join: float = 0.5, unit: str = "", axes: str = "",
          faces=(), layers=(), colors=(), zones=(), joints: bool = False, sections=(), iso_curves: int = 0,
          profiles: bool = False, curves: bool = False, accepted=None, progress=None, threads: int = 0) -> Check:
    """Judges the geometry of model files, of one scene file, a Model or a Scene, by a preset or a preset file.

    `faces`, `layers`, `colors` and `zones` judge a part of the body, by the words of `keiko check`. `joints`
    measures gap and flush between panels. `sections` ("y=120") and `iso_curves` fill `combs`, `profiles`
    fills `profiles`. `curves` fills `curves`: sections, iso-curves, inflections of faces and seams as B-splines,
    for write_curves. `accepted` is a file of accepted findings.
    """
    judging = _judging(preset, join, _scope(faces, layers, colors, zones), joints, sections, iso_curves, accepted)
    return Check(*check_json(input, judging, unit, axes, profiles, curves, progress, threads))


@_checked
def inspect(scene, preset: str = "class-a-outer", *, join: float = 0.5, views=(), rig=None, faces=(),
            layers=(), colors=(), zones=(), joints: bool = False, sections=(), iso_curves: int = 0,
            accepted=None, close_ups: int = 12, progress=None, threads: int = 0) -> Report:
    """Places lamps, renders views, measures and judges. `scene`: a Scene, or what opens one.

    What `check` has too means the same. `rig` is a rig file or a Rig. `close_ups`: pictures of the worst findings, at most.
    """
    scene = _opened(scene, progress, threads)
    judging = _judging(preset, join, _scope(faces, layers, colors, zones), joints, sections, iso_curves, accepted)
    files = report_files(scene, judging, _words(views), rig, close_ups, progress, threads)
    return Report(files, _os.getcwd())


def _numbers(one_or_more) -> list:
    return [one_or_more] if isinstance(one_or_more, int) else list(one_or_more)


@_checked
def accept(report, items, output, *, findings=(), why: str, who: str = "", until: str = "") -> int:
    """Accepts faults and findings of a report, by their numbers from 1, as `keiko accept` does.

    `report` is a report.json, or the file of a check. `items` are faults of the report, each with all of its
    findings; of a check they are findings. `findings` are single ones of either. `output` is the file of accepted findings that they
    are added to; it is made if missing. `who` is the login name unless given, `until` a date as
    2026-11-27. Returns the number of findings in the file.
    """
    if not why.strip():
        raise _error("why", "is empty")
    return accept_findings(report, _numbers(items), output, findings=_numbers(findings), why=why,
                           who=who or _getpass.getuser(), until=until)


@_checked
def place(scene, *, views=(), lamp: str = "tube", lamps: int = 12, planes: int = 3, progress=None,
          threads: int = 0) -> Placement:
    """Places rows of `lamps` lamps on up to `planes` planes where the body reflects the eyes of the views.

    `lamps` is 0 to 64, 0: as many as fit; `planes` 1 to 16. `lamp` is what hangs in a row: tube, panel (a single
    one) or screen (bright bars).
    The result has the `rig`, the share of the body that mirrors it as `coverage`, and `remarks`.
    """
    if not 0 <= lamps <= 64:
        raise _error("lamps", "is not 0 to 64")
    if not 1 <= planes <= 16:
        raise _error("planes", "is not 1 to 16")
    return place_lamps(_opened(scene, progress, threads), _words(views), lamp, lamps, planes, progress, threads)


@_checked
def lines(scene, rig=None, preset: str = "class-a-outer", *, views=(), look: str = "reflection", chord: float = 0.01,
          join: float = 0.5, faces=(), layers=(), colors=(), zones=(), curves: bool = False, contours: bool = False,
          progress=None, threads: int = 0) -> Lines:
    """Follows the reflections of lamps on the surfaces and judges them where they cross seams.

    `rig` is a rig file or a Rig; without one the lamps are the scene's own. `look` is reflection, highlight or
    isophote, `chord` the distance in mm between a line and the chords of its points. `faces`, `layers`, `colors`
    and `zones` judge a part of the body. `curves` fills `curves` of the result with the lines as B-splines, for
    write_curves; `contours` adds the contours of the views, hidden ones too.
    """
    scene = _opened(scene, progress, threads)
    options = {"views": _words(views), "preset": str(preset), "look": look, "chord": chord, "join": join,
               "curves": curves, "contours": contours, **_scope(faces, layers, colors, zones)}
    return Lines(*find_lines(scene, rig, options, progress, threads))


@_checked
def draw(scene, *, views=(), perspective: bool = False, hidden: str = "remove", without=(), sections=(),
         iso_curves: int = 0, rig=None, findings: bool = False, preset: str = "class-a-outer", crease: float = 1,
         join: float = 0.5, paper: str = "A3", title: str = "", progress=None, threads: int = 0) -> Drawing:
    """Draws outlines, edges and other curves of a body as vectors, as keiko draw does.

    `views` are names, () for left, front and top. `hidden` lines are removed (remove), dashed (dash), or drawn like
    all others (draw). `without` names layers that are left out. `sections` are planes like x=MM, `iso_curves` a number
    for each face, `rig` lamps whose reflection lines are drawn. `findings` numbers what the body fails by `preset`.
    A seam is a crease above `crease` degrees. `paper` is A4 to A0.
    """
    scene = _opened(scene, progress, threads)
    options = {"views": _words(views), "perspective": perspective, "hidden": hidden, "without": _words(without),
               "sections": _words(sections), "iso_curves": iso_curves, "findings": findings, "preset": str(preset),
               "crease": crease, "join": join, "paper": paper, "title": title}
    return draw_sheet(scene, rig, options, progress, threads)


@_checked
def compare(before, after, preset: str = "class-a-outer", *, join: float = 0.5, align: bool = False, faces=(),
            layers=(), colors=(), zones=(), views=None, rig=None, width: int = 0, height: int = 0, progress=None,
            threads: int = 0) -> Comparison:
    """Compares the geometry, seams and findings of two bodies: model files, scene files, Models or Scenes.

    With `views`, () for three automatic ones, pictures and lines are compared too, under the lamps of `rig`, a
    file or a Rig, or those of the former. `width` and `height` are pixels of these pictures, 0: the size of its scene.
    """
    options = {"preset": str(preset), "join": join, "align": align, "rig": rig, "width": width, "height": height,
               "views": None if views is None else _words(views), **_scope(faces, layers, colors, zones)}
    return Comparison(comparison_files(before, after, options, progress, threads), _os.getcwd())


def _require_reach(reach):
    if not 0 <= reach < float("inf"):
        raise _error("reach", "is not 0 mm or above")


@_checked
def read_scan(file, *, millimetres: float = 1):
    """Points of a scan, .stl, .ply, .asc or .xyz, as an array (n, 3) in mm.

    `millimetres`: those in one unit of the file.
    """
    if not 0 < millimetres < float("inf"):
        raise _error("millimetres", "is not above 0")
    return scan_points(file, millimetres)


@_checked
def compare_scan(nominal, scan, *, tolerance: float | None = None, least_share: float = 1, align: bool = True,
                 reach: float = 0, views=None, progress=None, threads: int = 0) -> ScanComparison:
    """Measures how far points lie from the exact surface, and judges them by a tolerance in mm.

    `nominal` is a Scene, or what opens one. `scan` is a file, or points (n, 3) in mm and in the coordinates of
    the scene. `least_share` of them, 0 to 1, must be within the tolerance. With `align` they are moved onto the
    surface first. Points farther than `reach` mm are outside of any tolerance; 0: a fiftieth of the size of
    the nominal. `views` are those of the maps in `html`: () for three automatic ones, None for no maps.
    """
    _require_reach(reach)
    is_file = isinstance(scan, (str, _os.PathLike))
    points = read_scan(scan) if is_file else _rows("scan", scan, 3, "x, y and z in mm")
    name = _os.fspath(scan) if is_file else f"{len(points)} points"
    nominal = _opened(nominal, progress, threads)
    return ScanComparison(*scan_deviations(nominal, points, name, tolerance, least_share, align, reach,
                                           None if views is None else _words(views), progress, threads))


@_checked
def mesh(scene, fields=(), *, deviation: float = 0.1, pull=(0, 0, 1), against=None, reach: float = 0, progress=None,
         threads: int = 0) -> Mesh:
    """A body in triangles, whose corners lie on the exact surface, with numbers of it at each corner.

    `fields` are of k1, k2, mean, absolute (1/mm), gauss (1/mm2), draft (degrees against `pull`) and deviation (mm
    from `against`, a Scene or what opens one, sought within `reach` mm; 0: a fiftieth of its size). The surface
    leaves the triangles by about `deviation` mm at most. `points`, `normals` (n, 3), `triangles` (m, 3), `faces`
    (m) and `fields` are arrays; `vtp()`, `ply(range)` and `glb(range)` are the bytes of files, coloured by the
    first field over a range (low, high).
    """
    _require_reach(reach)
    scene = _opened(scene, progress, threads)
    other = None if against is None else _opened(against, progress, threads)
    return surface_mesh(scene, deviation, _words(fields), tuple(pull), other, reach, progress, threads)


@_checked
def mesh_error(scene, mesh=(1, 0.1), *, views=(), rig=None, mesher: str = "opencascade", normals: str = "surface",
               width: int = 0, height: int = 0, progress=None, threads: int = 0) -> MeshErrors:
    """Compares what meshes of a body mirror of rows of lamps with what its exact surface mirrors.

    `mesh` is a deviation in mm, or several: a mesh each. `views` are names, () for three automatic ones. `rig` is a
    rig file or a Rig; without one the lamps are the scene's own, or placed. `mesher` is opencascade, as viewports
    have it, its deviation measured, or spans, within a proved bound. `normals` of corners are the surface's, or
    averaged over the triangles around. `width` and `height` are pixels of the pictures, 0: the scene's own size.
    """
    deviations = _each_number("mesh", mesh)
    options = {"views": _words(views), "mesher": mesher, "normals": normals, "width": width, "height": height}
    scene = _opened(scene, progress, threads)
    return MeshErrors(mesh_error_files(scene, deviations, rig, options, progress, threads), _os.getcwd())


@_checked
def info(file, *, unit: str = "", axes: str = "", join: float = 0.5, progress=None,
         threads: int = 0) -> Facts:
    """Summarises a model file or a Model: faces, patches, borders, losses and repairs."""
    return Facts(info_json(file, unit, axes, join, progress, threads))


@_checked
def regress(suite, output="keiko-regress", *, baselines="", only=(), fresh: bool = False,
            progress=None, threads: int = 0) -> Regression:
    """Runs the fixtures of a folder and holds them against their baselines."""
    return Regression(regress_json(suite, output, baselines, _words(only), fresh, progress, threads))


@_checked
def radiosity(scene, *, rig=None, progress=None, threads: int = 0) -> Solution:
    """Solves the light that diffuse surfaces reflect onto each other, of the scene's lamps or those of `rig`.

    The scene must have been opened with shadows, and `[radiosity]` of its file says how fine the elements are. The
    Solution has its balance, `emitted`, `absorbed`, `escaped` and `missing` (lm), and `remaining`, the bound of the
    light that it lacks. It holds for any view, and for these lamps at any levels. `write(file)` keeps it.
    """
    return solved_radiosity(_opened(scene, progress, threads, shadows=True), rig, progress, threads)


@_checked
def illuminance(scene, points, normals, *, rig=None, solution=None, progress=None, threads: int = 0):
    """Illuminance in lx at points (n, 3), in mm, with normals (n, 3), by the scene's lamps or those of `rig`.

    Returns a structured array of n rows: a column for each source, "c_plane.0", and "sum". With a `solution`, a
    Solution or its file, a column "reflected" stands before the sum: the light that surfaces reflect of these lamps.
    """
    points = _rows("points", points, 3, "x, y and z in mm")
    normals = _rows("normals", normals, 3, "x, y and z of the normals of the points")
    if len(points) != len(normals):
        raise _error("normals", f"are {len(normals)}, of {len(points)} points")
    rows = _np.hstack([points, normals])
    scene = _opened(scene, progress, threads, shadows=solution is not None)
    names, numbers = illuminance_numbers(scene, rows, rig, solution, progress, threads)
    return numbers.view([(name, float) for name in names]).reshape(len(rows))


@_checked
def luminance(scene, rays, *, rig=None, progress=None, threads: int = 0):
    """Luminance in cd/m2 that rays (n, 6) meet, by the scene's lamps or those of `rig`: n rows of red, green, blue.

    It is that of a picture whose pixels have no width. Rays that meet nothing have what is
    beyond: the sky, or else the scene's background.
    """
    rays = _rows("rays", rays, 6, "origin and direction")
    return luminance_numbers(_opened(scene, progress, threads), rays, rig, progress, threads)


@_checked
def analysis_picture(scene, look: str, view: str = "", *, rig=None, width: int | None = None,
                     height: int | None = None, scale=None, pull=(0, 0, 1), draft: float = 3,
                     radius: float | None = None, section=(0, 1, 0), progress=None, threads: int = 0) -> Picture:
    """The picture of `keiko render --look`: zebra, isophote, highlight, draft, curvature:gauss, radius and others.

    `scale` (low, high) is the range of colours in the unit of the look; by default that of what is seen. `pull` and
    `draft` (degrees) are of draft, `radius` (mm) of below-radius, `section`, the normal of the planes, of
    curvature:section, `rig` of highlight. View and size are those of render().
    """
    options = {"scale": scale, "pull": tuple(pull), "draft": draft, "radius": radius, "section": tuple(section)}
    scene = _opened(scene, progress, threads)
    return Picture(analysis_png(scene, look, view, rig, width, height, options, progress, threads))


@_checked
def deep_view(scene, view: str = "", *, width: int | None = None, height: int | None = None, reflections: int = 3,
              progress=None, threads: int = 0) -> DeepBuffer:
    """The surfaces on the paths of a picture's rays, from which any lamps light it without tracing.

    `samples` is a structured array of height x width: t, normal_x, normal_y (on the octahedron), shape_xx,
    shape_xy, shape_yy (1/mm), way and face, as keiko-deep/1 has them. `bounces` are the surfaces that mirrors
    show, each with its pixel. View and size are those of render().
    """
    return deep_buffer(_opened(scene, progress, threads), view, width, height, reflections, progress, threads)


@_checked
def render(scene, view: str = "", *, rig=None, solution=None, width: int | None = None, height: int | None = None,
           aovs=(), penumbrae: str = "width", light_error: float = 2e-3, edge_samples: int = 8, gather: int = 0,
           progress=None, threads: int = 0) -> Film:
    """The picture of a scene: `numpy.asarray` of it is height x width x 3, cd/m2.

    `view` is what `keiko render --view` takes: a name, "auto", "scene", or a view file; empty for the
    scene's own, or else the one that shows the body best. `rig` is a rig file or a Rig; without one the lamps
    are the scene's own, or placed for the view. `solution` is a Solution of these lamps, or its file: its reflected
    light takes the place of ambient light. Without width and height: the scene's own size. `penumbrae`,
    `light_error`, `edge_samples` and `gather` are those of `keiko render`.
    """
    scene = _opened(scene, progress, threads, shadows=solution is not None)
    accuracy = {"penumbrae": penumbrae, "light_error": light_error, "edge_samples": edge_samples, "gather": gather}
    return render_film(scene, view, rig, solution, width, height, _words(aovs), accuracy, progress, threads)
