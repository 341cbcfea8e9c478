"""Which check of keiko regress catches which change of a part, at the default tolerances.

Everything of 10 um or 0.02 degrees and above must be caught, and nothing else. KEIKO_TABLE=1 prints
the table of docs/regression.md; KEIKO_LONG=1 asks `keiko compare` as well, and takes the real panels of
../shared/models where they are: some minutes.
"""
import json
import os
import subprocess
import unittest
from pathlib import Path

from keiko_process import SOURCE, KeikoTest, surface
from step_text import StepText

FIXTURE = """format = "keiko-fixture/1"
model = "part.step"
views = ["high-front"]
layers = ["face", "normal", "depth", "uv", "c_plane_uv"]
rig = "rig.toml"
"""
# A row of lamps over parts about the origin, and one over the hood.
RIG = """format = "keiko-rig/1"
[[c_plane]]
origin = [{x}, -1500, 1600]
u = [0, 3000, 0]
v = [3000, 0, 0]
lamps = 20
diameter = 60
"""
LAYERS = "color", "normal", "depth", "uv", "c_plane_uv"
CHECKS = "shape", "seams", "lines", *LAYERS, "silhouette"

POINT = [(f"control point moved by {n} um", lambda step, mm=n / 1000: step.move_inner_point(step.faces()[0], mm))
         for n in (1, 10, 100)]
FACES = [("a face dropped", lambda step: step.drop_face(step.faces()[1])),
         ("a face turned round", lambda step: step.flip_face(step.faces()[0]))]
PARTS = {
    "seam-g1-only": [
        *POINT,
        ("tangents at the seam turned by 0.02 degrees", lambda step: step.tilt_at_end(step.faces()[0], 0.02)),
        *FACES],
    "hood": [
        *POINT,
        ("a knot moved by 1 % of its span", lambda step: step.change_knot(step.faces()[1], 0.01)),
        *FACES],
    "rational-sphere": [
        *POINT,
        ("a weight changed by 0.1 %", lambda step: step.change_weight(step.faces()[0], 1.001)),
        *FACES],
    "trimmed-hole": [
        *POINT,
        ("a trim moved by 10 um", lambda step: step.move_inner_loop(step.faces()[0], 0.01, 200)),
        ("a face turned round", lambda step: step.flip_face(step.faces()[0]))],
}

LONG = bool(os.environ.get("KEIKO_LONG"))
SHARED = SOURCE.parent / "shared" / "models"
# Where lamps begin over each.
PANELS = {"car-hood.brep": -1730, "car-front-fender.brep": -1625, "car-rear-deck-half-panel.brep": 1306}
PANEL_CHANGES = [
    *POINT,
    ("tangents at a border turned by 0.02 degrees", lambda step: step.tilt_at_end(step.faces()[0], 0.02)),
    *FACES]


def reexport(before, after):
    subprocess.run([os.environ["KEIKO_REEXPORT"], str(before), str(after)], check=True, timeout=600,
                   stdout=subprocess.DEVNULL)


class Mutations(KeikoTest):
    patience = 1200 if LONG else KeikoTest.patience

    def regress(self, *arguments: str):
        return self.keiko("regress", "-q", ".", "-o", "out", *arguments)

    def caught_by(self) -> list:
        outcome = json.loads((self.folder / "out/regression.json").read_text())["fixtures"][0]
        self.assertNotEqual(outcome["state"], "error", outcome["error"])
        caught = {metric["check"] for metric in outcome["metrics"]}
        for picture in outcome["pictures"]:
            caught.update(layer["layer"] for layer in picture["layers"] if not layer["within"])
            if not picture["flips_within"]:
                caught.add("silhouette")
        return [check for check in CHECKS if check in caught]

    def prepare(self, source, x: float = -1500):
        (self.folder / "part.toml").write_text(FIXTURE)
        (self.folder / "rig.toml").write_text(RIG.format(x=x))
        StepText(source).write(self.folder / "part.step")
        run = self.regress("--update", "part")
        self.assertEqual((run.returncode, run.stderr), (0, ""))

    def mutate(self, source, change) -> list:
        step = StepText(source)
        change(step)
        step.write(self.folder / "part.step")
        run = self.regress()
        self.assertIn(run.returncode, (0, 1), run.stderr + run.stdout)
        caught = self.caught_by()
        self.assertEqual(run.returncode, 1 if caught else 0)
        return caught

    def compared(self, source) -> list:
        run = self.keiko("compare", "-q", str(source), "part.step")
        self.assertIn(run.returncode, (0, 1), run.stderr)
        return ["keiko compare"] if run.returncode == 1 else []

    def study(self, part: str, source, changes: list):
        for name, change in changes:
            with self.subTest(part=part, change=name):
                caught = self.mutate(source, change)
                compared = self.compared(source) if LONG else []
                if os.environ.get("KEIKO_TABLE"):
                    print(f"| {part} | {name} | {', '.join(caught + compared) or '–'} |", flush=True)
                if "by 1 um" not in name:
                    self.assertTrue(caught, "not caught by keiko regress")
                    self.assertTrue(compared or not LONG, "not caught by keiko compare")
        with self.subTest(part=part, change="none"):
            self.assertEqual(self.mutate(source, lambda step: None), [])

    def study_fixture(self, part: str):
        source = surface(f"{part}.step")
        self.prepare(source, -900 if part == "hood" else -1500)
        self.study(part, source, PARTS[part])

    def test_a_seam(self):
        self.study_fixture("seam-g1-only")

    def test_spline_faces_with_inner_knots(self):
        self.study_fixture("hood")

    def test_rational_patches(self):
        self.study_fixture("rational-sphere")

    def test_a_trimmed_face(self):
        self.study_fixture("trimmed-hole")

    def test_a_second_import_other_threads_and_a_file_written_anew_raise_no_alarm(self):
        self.prepare(surface("seam-g1-only.step"))
        self.assert_threads_do_not_matter()
        original = Path(surface("seam-g1-only.step")).read_text()
        for text in original, original.replace(";\n#", ";\n\n#").replace(",(", ", ("):
            (self.folder / "part.step").write_text(text)
            self.assert_same()

    def assert_threads_do_not_matter(self):
        for threads in "1", "3":
            self.assert_same("--fresh", "--threads", threads)

    def assert_same(self, *arguments: str):
        run = self.regress(*arguments)
        self.assertEqual((run.returncode, self.caught_by()), (0, []), run.stdout + run.stderr)

    def test_a_part_that_was_written_anew_raises_no_alarm_in_compare(self):
        parts = PARTS if LONG else ("seam-g1-only", "trimmed-hole")
        for part in parts:
            for ending in "step", "brep":
                with self.subTest(part=part, ending=ending):
                    reexport(surface(f"{part}.step"), self.folder / f"again.{ending}")
                    run = self.keiko("compare", "-q", "--samples", "2000", surface(f"{part}.step"),
                                     f"again.{ending}")
                    self.assertEqual((run.returncode, run.stderr), (0, ""), run.stdout)

    def test_a_part_that_was_written_anew_raises_no_alarm_in_regress(self):
        for part in PARTS if LONG else ("seam-g1-only",):
            self.prepare(surface(f"{part}.step"), -900 if part == "hood" else -1500)
            with self.subTest(part=part):
                reexport(surface(f"{part}.step"), self.folder / "part.step")
                self.assert_same()

    @unittest.skipUnless(LONG, "only with KEIKO_LONG=1")
    def test_real_panels(self):
        for panel, x in PANELS.items():
            if not (SHARED / panel).exists():
                self.skipTest(f"{SHARED / panel} is not there")
            source = self.settled(SHARED / panel)
            self.prepare(source, x)
            with self.subTest(panel=panel, change="other threads"):
                self.assert_threads_do_not_matter()
            with self.subTest(panel=panel, change="written anew as STEP"):
                reexport(source, self.folder / "part.step")
                self.assertEqual(self.compared(source), [])
                self.assert_same()
            self.study(panel, source, PANEL_CHANGES)

    def settled(self, panel: Path) -> Path:
        """The panel as STEP. Its p-curves lie up to 0.3 mm beside its edges, so that OpenCASCADE makes
        some of them anew when it reads them, until it finds them as it would make them itself."""
        source = panel
        for again in range(6):
            written = self.folder / f"written-{again}.step"
            reexport(source, written)
            source = written
        return source


if __name__ == "__main__":
    unittest.main()
