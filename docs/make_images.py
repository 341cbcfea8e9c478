#!/usr/bin/env python3
"""Makes the pictures of docs/images, from the files of this repository alone.

usage: docs/make_images.py KEIKO [--bench KEIKO_BENCH] [NAME...]

Without names all of them. Those of the benchmarks need KEIKO_BENCH, and are left out without it; so are
penumbra-cost.svg and shaft-costs.svg, plots of what a run measured, unless they are named.
docs/draw_house.py draws house.svg, docs/draw_beams.py beam-*.svg, and seam-stretches.svg is a drawing.
"""
import argparse
import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
IMAGES = ROOT / "docs" / "images"
SURFACES = ROOT / "surfaces"
sys.dont_write_bytecode = True
sys.path += [str(ROOT / "tests"), str(ROOT / "tests" / "cli")]

from line_pictures import line_picture  # noqa: E402

SHADED = ("--shadows", "--tone", "reinhard")

# Pictures of scenes: the scene file, the options of `keiko render`, the size in pixels.
SCENES = {
    "concept-car": ("concept-car-scene", (), (1600, 900)),
    "concept-car-lamps": ("concept-car-lamps-scene", ("--shadows", "--ev", "8"), (1280, 720)),
    "concept-car-lamps-paper": (
        "concept-car-lamps-scene",
        ("--shadows", "--ev", "8", "--rig", str(ROOT / "lightrigs" / "car-12-paper.toml")), (960, 540)),
    "distributions": ("distributions-scene", SHADED, (1200, 240)),
    **{f"elements-{element}": (f"elements-{scene}-scene", (*options, "--ev", "8"), (360, 300))
       for element, scene, options in (("ambient", "ambient", ()), ("diffuse", "diffuse", ()), ("gloss", "gloss", ()),
                                       ("mirror", "mirror", ()), ("shadows", "mirror", ("--shadows",)),
                                       ("fog", "fog", ("--shadows",)))},
    **{f"five-spots-{frame}": ("five-spots-scene", (*SHADED, "--frames", f"{frame}:{frame}"), (480, 270))
       for frame in (3, 9, 15, 21)},
    "fog-beams-on-wall": ("beams-on-wall-scene", SHADED, (960, 540)),
    "fog-dots": ("fog-dots-scene", ("--shadows",), (960, 540)),
    "fog-dry-ice": ("dry-ice-scene", SHADED, (480, 270)),
    "fog-edges": ("fog-edges-scene", ("--shadows",), (960, 540)),
    "fog-headlights": ("headlights-scene", SHADED, (960, 540)),
    "fog-rainbow-lamps": ("rainbow-lamps-scene", SHADED, (960, 540)),
    "fog-searchlights": ("searchlights-scene", SHADED, (960, 540)),
    "fog-street": ("street-scene", SHADED, (480, 270)),
    "fog-studio-spots": ("studio-spots-scene", SHADED, (960, 540)),
    "fog-sun-window": ("sun-window-scene", SHADED, (960, 540)),
    "fog-tunnel": ("foggy-tunnel-scene", SHADED, (800, 450)),
    "brushed-steel": ("brushed-scene", SHADED, (1200, 320)),
    "fur": ("fur-scene", SHADED, (960, 540)),
    "casting": ("casting-scene", ("--tone", "reinhard"), (960, 540)),
    "caustics": ("caustics-scene", SHADED, (960, 540)),
    "caustics-ripples": ("ripples-scene", SHADED, (960, 540)),
    "glass": ("glass-scene", ("--shadows",), (1200, 400)),
    "glass-teapot": ("glass-teapot-scene", SHADED, (640, 448)),
    "hood": ("hood-scene", (), (1200, 560)),
    "hood-anaglyph": ("hood-scene", ("--stereo", "anaglyph"), (960, 448)),
    "indices": ("indices-scene", SHADED, (1200, 320)),
    "leather-and-marble": ("leather-and-marble-scene", SHADED, (960, 430)),
    "low-beam": ("low-beam-scene", SHADED, (960, 540)),
    "orange-peel": ("orange-peel-scene", (), (960, 540)),
    "curved-lamps": ("curved-lamps-scene", SHADED, (640, 360)),
    **{f"ladder-{rung}": (f"ladder-{rung}-scene", SHADED, (640, 448)) for rung in ("shaded", "textured")},
    "lamps-in-a-row": ("lamps-in-a-row-scene", SHADED, (640, 360)),
    "panels-in-fog": ("panels-in-fog-scene", SHADED, (640, 360)),
    "overcast": ("overcast-scene", ("--tone", "reinhard"), (960, 540)),
    **{name: ("room-scene", ("--shadows", "--ev", "7"), (720, 600)) for name in ("room", "room-direct")},
    "seams": ("seams-scene", (), (1200, 400)),
    "phong-exponents": ("exponents-scene", SHADED, (1200, 320)),
    **{f"shadow-{light}": ("shadows-scene", (*SHADED, "--rig", str(ROOT / f"lightrigs/one-{light}.toml")), (360, 240))
       for light in ("point", "line", "tube", "panel", "globe", "sky")},
    "turning-dots-0": ("turning-dots-scene", (*SHADED, "--frames", "0:0"), (480, 270)),
    "turning-dots-1": ("turning-dots-scene", (*SHADED, "--frames", "1:1"), (480, 270)),
    "turning-dots-2": ("turning-dots-scene", (*SHADED, "--frames", "2:2"), (480, 270)),
    "turning-dots-3": ("turning-dots-scene", (*SHADED, "--frames", "3:3"), (480, 270)),
    "white-tunnel": ("white-tunnel-scene", SHADED, (960, 540)),
    "windscreen": ("windscreen-scene", ("--look", "distortion"), (960, 540)),
    "workshop": ("workshop-scene", SHADED, (800, 500)),
    "workshop-lux": (
        "workshop-scene",
        ("--shadows", "--false-color", "--quantity", "illuminance", "--scale", "50:2000", "--iso-lines"),
        (800, 500)),
}
# Those with the reflected light of `keiko radiosity`.
SOLVED = {"room", "white-tunnel"}


def keiko(program, *arguments):
    """Output of a command, which may judge a body as failed (exit code 1), but not end with an error."""
    run = subprocess.run([str(program), *map(str, arguments), "-q"], capture_output=True, text=True, check=False)
    if run.returncode not in (0, 1):
        sys.exit(f"{' '.join(map(str, run.args))}: {run.stderr}")
    return run.stdout


def render_scene(program, name, folder, size=None):
    """Renders one of SCENES as a PNG file in an empty folder."""
    scene, options, own_size = SCENES[name]
    if name in SOLVED:
        solution = folder / f"{name}.solution"
        keiko(program, "radiosity", SURFACES / f"{scene}.toml", "-o", solution)
        options = (*options, "--solution", solution)
    width, height = size or own_size
    keiko(program, "render", SURFACES / f"{scene}.toml", *options, "--size", f"{width}x{height}", "-o",
          folder / f"{name}.png")
    picture, = folder.glob("*.png")  # one of --frames has its number in its name
    return picture


def seam_lines(program, folder):
    keiko(program, "lines", SURFACES / "seams-scene.toml", "-o", folder / "lines.json", "--picture", folder / "a.png")
    return {"seams-lines": folder / "a.png"}


def hood_inspection(program, folder):
    keiko(program, "inspect", SURFACES / "hood.step", "-o", folder)
    return {"hood-lines": folder / "high-front-lines.png",
            "hood-inflections": folder / "high-front-curvature.png"}


def car_lines(program, folder):
    keiko(program, "lines", SURFACES / "concept-car-scene.toml", "-o", folder / "lines.json", "--picture",
          folder / "a.png", "--size", "1200x675")
    return {"concept-car-lines": folder / "a.png"}


def car_drawing(program, folder):
    """Three views of the car as lines."""
    keiko(program, "draw", SURFACES / "concept-car.step", "--hidden", "dash", "--title", "Concept car", "-o",
          folder / "a.svg")
    return {"drawing": folder / "a.svg"}


def ladder_lines(program, folder):
    """The first rungs of the ladder: all lines of the teapot, and those that nothing hides."""
    shaded = render_scene(program, "ladder-shaded", folder)
    made = {}
    for name, options in ("ladder-wireframe", ("--wireframe",)), ("ladder-hidden-line", ()):
        sheet = folder / "sheet.svg"
        keiko(program, "draw", SURFACES / "ladder-shaded-scene.toml", "--view", "scene", "--perspective",
              "--iso-curves", "4", *options, "-o", sheet)
        made[name] = folder / f"{name}.svg"
        made[name].write_text(line_picture(sheet.read_text(encoding="utf-8"), shaded), encoding="utf-8")
    return made


def hood_meshes(program, folder):
    """The same close-up of the hood's stripes in two meshes and in the surface."""
    keiko(program, "mesh-error", SURFACES / "hood.step", "--mesh", "1,0.1", "--view", "high-front", "-o", folder)
    return {"mesh-error-coarse": folder / "high-front-mesh-1-close-up.png",
            "mesh-error-fine": folder / "high-front-mesh-2-close-up.png",
            "mesh-error-surface": folder / "high-front-surface-close-up.png"}


def raised_sheet(program, folder):
    """The distance map of a sheet of which an inner control point is 0.5 mm higher."""
    from step_text import StepText
    part = SURFACES / "seam-g1-only.step"
    step = StepText(part)
    step.move_inner_point(step.of_type("ADVANCED_FACE")[0], 0.5)
    step.write(folder / "raised.step")
    keiko(program, "compare", part, folder / "raised.step", "--view", "top", "-o", folder / "out")
    return {"compare": folder / "out" / "top-deviation.png"}


def overhead_rig(program, body, report, across):
    """A rig over the body of as many lamps as were placed, along or across it."""
    from placement_table import overhead
    bounds = json.loads(keiko(program, "info", body, "--json"))["bounds"]
    placed = json.loads((report / "placement.json").read_text(encoding="utf-8"))
    return overhead(bounds, sum(plane["lamps"] for plane in placed["planes"]), across)


def placements(program, folder):
    """Stripes under placed lamps and under as many overhead, and the hits of the first row."""
    made = {}
    for name, view, across in ("hood", "high-front", False), ("concept-car", "high-left", True):
        body, rig, report = SURFACES / f"{name}.step", folder / "rig.toml", folder / name
        keiko(program, "place", body, "--view", view, "-o", rig, "--report", report)
        short = name.removeprefix("concept-")
        for kind, text in (("", rig.read_text()), ("-overhead", overhead_rig(program, body, report, across))):
            rig.write_text(text)
            picture = made[f"placement-{short}{kind}"] = folder / f"{short}{kind}.png"
            keiko(program, "render", body, "--view", view, "--rig", rig, "--size", "480x270", "-o", picture)
    return made | {"placement-histogram": folder / "concept-car" / "histogram-1.png"}


def benchmark(command):
    def make(program, folder):
        subprocess.run([program, *command, "-o", folder / "a.png"], check=True, cwd=ROOT, stdout=subprocess.DEVNULL)
        return folder / "a.png"
    return make


def measurement(command):
    def make(program, folder):
        subprocess.run([program, *command, "--plot", folder / "a.svg"], check=True, cwd=ROOT)
        return folder / "a.svg"
    return make


# Functions of the program and an empty folder, which return the files of some pictures.
COMMANDS = {
    ("seams-lines",): seam_lines,
    ("hood-lines", "hood-inflections"): hood_inspection,
    ("concept-car-lines",): car_lines,
    ("drawing",): car_drawing,
    ("ladder-wireframe", "ladder-hidden-line"): ladder_lines,
    ("mesh-error-coarse", "mesh-error-fine", "mesh-error-surface"): hood_meshes,
    ("compare",): raised_sheet,
    ("placement-hood", "placement-hood-overhead", "placement-car", "placement-car-overhead",
     "placement-histogram"): placements,
}
BENCHMARKS = {
    "mesh-or-surface": benchmark(["picture"]),
    "three-lights": benchmark(["lights"]),
    "fog-cut-shaft": benchmark(["shafts"]),
}
MEASUREMENTS = {
    "penumbra-cost": measurement(["penumbra"]),
    "shaft-costs": measurement(["shafts", "--rays", "48"]),
}


def keep(name, file):
    shutil.copyfile(file, IMAGES / f"{name}{file.suffix}")
    print(f"docs/images/{name}{file.suffix}", flush=True)


def make_all(program, bench, wanted):
    """Makes the pictures for which wanted(name) holds."""
    jobs = [((name,), lambda folder, name=name: {name: render_scene(program, name, folder)}) for name in SCENES]
    jobs += [(names, lambda folder, make=make: make(program, folder)) for names, make in COMMANDS.items()]
    if bench:
        jobs += [((name,), lambda folder, name=name, make=make: {name: make(bench, folder)})
                 for name, make in (BENCHMARKS | MEASUREMENTS).items()]
    for names, make in jobs:
        if not any(map(wanted, names)):
            continue
        with tempfile.TemporaryDirectory() as folder:
            for name, file in make(Path(folder)).items():
                if wanted(name):
                    keep(name, file)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("keiko", type=Path)
    parser.add_argument("--bench", type=Path)
    parser.add_argument("names", nargs="*", metavar="NAME")
    arguments = parser.parse_intermixed_args()
    known = {*SCENES, *(name for names in COMMANDS for name in names), *BENCHMARKS, *MEASUREMENTS}
    if unknown := set(arguments.names) - known:
        parser.error(f"no picture is called {', '.join(sorted(unknown))}")
    wanted = set(arguments.names) or known - set(MEASUREMENTS)
    bench = arguments.bench and arguments.bench.resolve()
    make_all(arguments.keiko.resolve(), bench, wanted.__contains__)


if __name__ == "__main__":
    main()
