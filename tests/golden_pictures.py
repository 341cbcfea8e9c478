#!/usr/bin/env python3
"""Fails when a scene of the docs looks otherwise than its golden picture, 160 pixels wide.

usage: tests/golden_pictures.py KEIKO [--update] [NAME...]

A picture is the same if each channel of each pixel is within TOLERANCE of 255 levels, but for MOST_OTHER of
the pixels: rounding, on another processor say, may carry an edge across a few. --update writes the golden
pictures anew, into tests/data/golden. Look at them before you commit them.
"""
import argparse
import shutil
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.dont_write_bytecode = True
sys.path.append(str(ROOT / "docs"))

from make_images import SCENES, render_scene  # noqa: E402
from png_file import read_png  # noqa: E402

GOLDEN = ROOT / "tests" / "data" / "golden"
WIDTH = 160
TOLERANCE = 2  # levels of 255, per channel
MOST_OTHER = 0.002  # share of the pixels


def small_size(name):
    width, height = SCENES[name][2]
    return WIDTH, round(WIDTH * height / width)


def fault(golden, picture):
    """What is wrong with a picture, as text, or nothing."""
    *shape, old = read_png(golden)
    *new_shape, new = read_png(picture)
    if shape != new_shape:
        return f"{new_shape} instead of {shape} (width, height, channels)"
    step, pixels = shape[2], shape[0] * shape[1]
    off = [max(abs(a - b) for a, b in zip(old[i:i + step], new[i:i + step])) for i in range(0, len(old), step)]
    other = sum(value > TOLERANCE for value in off)
    if other <= MOST_OTHER * pixels:
        return None
    return f"{other} of {pixels} pixels differ by more than {TOLERANCE} levels, by up to {max(off)}"


def check(program, name, update):
    golden = GOLDEN / f"{name}.png"
    with tempfile.TemporaryDirectory() as folder:
        picture = render_scene(program, name, Path(folder), small_size(name))
        if update:
            shutil.copyfile(picture, golden)
        elif not golden.is_file():
            return "has no golden picture; --update"
        return fault(golden, picture)


def strays():
    return sorted(path.name for path in GOLDEN.iterdir() if path.stem not in SCENES)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("keiko", type=Path)
    parser.add_argument("--update", action="store_true")
    parser.add_argument("names", nargs="*", metavar="NAME")
    arguments = parser.parse_intermixed_args()
    GOLDEN.mkdir(exist_ok=True)
    faults = [f"{name}: of no scene" for name in strays()]
    for name in arguments.names or SCENES:
        if what := check(arguments.keiko.resolve(), name, arguments.update):
            faults.append(f"{name}: {what}")
    if faults:
        sys.exit("\n".join(faults))
    print("pictures hold")


if __name__ == "__main__":
    main()
