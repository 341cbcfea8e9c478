"""Curves of lines and checks as values, written to STEP and IGES files and read back.

usage: curves_test.py KEIKO
"""
import pickle
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

import keiko

ROOT = Path(__file__).resolve().parents[2]
SEAM = ROOT / "surfaces/seam-g1-angle.step"
TUNNEL = ROOT / "lightrigs/tunnel-12.toml"
PROGRAM = sys.argv.pop(1)


def quarter_circle() -> keiko.Spline:
    """A quarter of the circle of 10 mm around the origin, in the plane z = 5."""
    half = np.sqrt(0.5)
    return keiko.Spline(2, [0, 0, 0, 1, 1, 1], [[10, 0, 5, 1], [10, 10, 5, half], [0, 10, 5, 1]])


class CurvesTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def assert_read_back(self, curves, ending):
        """Names, colours, and control points to 1e-9 mm; STEP loses the colour of curves in several pieces."""
        path = self.folder / f"curves.{ending}"
        keiko.write_curves(curves, path)
        read = keiko.read_curves(path)
        self.assertEqual([curve.name for curve in read], [curve.name for curve in curves])
        for before, after in zip(curves, read):
            if ending.startswith("i") or len(before.pieces) == 1:
                np.testing.assert_allclose(after.color or [], before.color or [], atol=0.01)
            self.assertEqual(len(after.pieces), len(before.pieces))
            for a, b in zip(after.pieces, before.pieces):
                self.assertEqual((a.degree, len(a.knots)), (b.degree, len(b.knots)))
                np.testing.assert_allclose(a.points, b.points, rtol=0, atol=1e-9)

    def assert_those_of_the_program(self, curves, *command):
        path = self.folder / "program.step"
        subprocess.run([PROGRAM, *map(str, command), "--curves", path, "-q"], stdout=subprocess.PIPE, check=False)
        theirs = keiko.read_curves(path)
        self.assertEqual([curve.name for curve in curves], [curve.name for curve in theirs])
        for ours, read in zip(curves, theirs):
            self.assertEqual(len(ours.pieces), len(read.pieces))
            for a, b in zip(ours.pieces, read.pieces):
                np.testing.assert_allclose(a.points, b.points, rtol=0, atol=1e-9)

    def test_lines_and_contours_are_those_of_the_program(self):
        found = keiko.lines(ROOT / "surfaces/rational-sphere.step", TUNNEL, views="high-left", look="highlight",
                            curves=True, contours=True)
        kinds = {curve.name.split()[0] for curve in found.curves}
        self.assertEqual(kinds, {"highlight", "contour:"})
        self.assertTrue(all(", within " in curve.name and curve.deviation > 0 for curve in found.curves))
        self.assert_those_of_the_program(found.curves, "lines", ROOT / "surfaces/rational-sphere.step", "--rig", TUNNEL,
                                         "--view", "high-left", "--look", "highlight", "--contours",
                                         "-o", self.folder / "lines.json")
        for ending in "step", "iges":
            self.assert_read_back(found.curves, ending)

    def test_lines_carry_their_verdicts(self):
        found = keiko.lines(SEAM, TUNNEL, views="high-left", curves=True)
        self.assertTrue(any(": pass, high-left" in curve.name for curve in found.curves))
        again = pickle.loads(pickle.dumps(found))
        self.assertEqual([curve.name for curve in again.curves], [curve.name for curve in found.curves])
        np.testing.assert_array_equal(again.curves[0].pieces[0].points, found.curves[0].pieces[0].points)
        self.assertEqual(keiko.lines(SEAM, TUNNEL, views="high-left").curves, [])

    def test_lines_judge_a_part_of_the_body(self):
        part = keiko.lines(SEAM, TUNNEL, views="high-left", faces=1, chord=0.1, join=0.4)
        path = self.folder / "part.json"
        subprocess.run([PROGRAM, "lines", SEAM, "--rig", TUNNEL, "--view", "high-left", "--faces", "1", "--chord", "0.1",
                        "--join", "0.4", "-o", path, "-q"], stdout=subprocess.PIPE, check=False)
        self.assertEqual(part.to_json(), path.read_text(encoding="utf-8"))
        for wrong, reason in (({"look": "zebra"}, "^look: "), ({"chord": 0}, "^chord: ")):
            with self.assertRaisesRegex(keiko.Error, reason):
                keiko.lines(SEAM, TUNNEL, **wrong)

    def test_sections_and_seams_of_a_check_are_those_of_the_program(self):
        found = keiko.check(SEAM, sections="y=12", iso_curves=1, curves=True)
        names = [curve.name for curve in found.curves]
        self.assertTrue(names[0].startswith("section "))
        self.assertTrue(any(name.startswith("seam 1: fail") for name in names))
        self.assert_those_of_the_program(found.curves, "check", SEAM, "--section", "y=12", "--iso-curves", "1",
                                         "--combs", self.folder / "combs.json")
        for ending in "stp", "igs":
            self.assert_read_back(found.curves, ending)
        self.assertEqual(len(pickle.loads(pickle.dumps(found)).curves), len(names))
        self.assertEqual(keiko.check(SEAM).curves, [])

    def test_own_curves_are_written(self):
        arc = keiko.Curve("arc", [quarter_circle()], color=[1, 0, 0])
        for ending in "step", "iges":
            self.assert_read_back([arc], ending)
        path = self.folder / "arc.vtp"
        keiko.write_curves([arc], path)
        self.assertIn(b"97 114 99 0", path.read_bytes(), "the name in VTK's codes")
        self.assertEqual(repr(arc), "<Curve: arc>")

    def test_what_is_no_curve_is_refused(self):
        points = [[0, 0, 0, 1], [1, 0, 0, 1]]
        for degree, knots, rows, reason in ((1, [0, 0, 1], points, "wrong number of knots"),
                                            (1, [0, 1, 0, 1], points, "knots that do not rise"),
                                            (1, [0, 0, 1, np.nan], points, "a knot that is not finite"),
                                            (0, [0, 1, 1], points, "impossible degree"),
                                            (1, [0, 0, 1, 1], [[0, 0, 0, 1], [1, 0, 0, 0]], "weight that is not positive"),
                                            (1, [0, 0, 1, 1], [[0, 0, 0, 1], [1, np.inf, 0, 1]], "point that is not finite"),
                                            (1, [0, 0, 1, 1], [[0, 0, 0], [1, 0, 0]], "n rows of 4"),
                                            (1, [[0, 0, 1, 1]], points, "^knots: ")):
            with self.assertRaisesRegex(keiko.Error, reason):
                keiko.Spline(degree, knots, rows)
        with self.assertRaisesRegex(keiko.Error, "^pieces: "):
            keiko.Curve("none", [])
        with self.assertRaisesRegex(keiko.Error, "there is no curve"):
            keiko.write_curves([], self.folder / "none.step")
        with self.assertRaisesRegex(keiko.Error, r"ends in none of"):
            keiko.write_curves([keiko.Curve("arc", [quarter_circle()])], self.folder / "arc.brep")


if __name__ == "__main__":
    unittest.main()
