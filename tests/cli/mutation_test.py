"""Which check of keiko regress catches which change of a part, at the default tolerances.

Everything of 10 um or 0.02 degrees and above must be caught, and nothing else. KEIKO_TABLE=1 prints
the table of docs/regression.md; KEIKO_LONG=1 asks `keiko compare` as well, and takes the real panels of
../shared/models where they are.
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
PANELS = "car-hood.brep", "car-rear-deck-half-panel.brep", "car-front-fender.brep"


def reexport(before, after):
    subprocess.run([os.environ["KEIKO_REEXPORT"], str(before), str(after)], check=True, timeout=120,
                   stdout=subprocess.DEVNULL)


class Mutations(KeikoTest):
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

    def prepare(self, part: str):
        (self.folder / "part.toml").write_text(FIXTURE)
        (self.folder / "rig.toml").write_text(RIG.format(x=-900 if part == "hood" else -1500))
        StepText(surface(f"{part}.step")).write(self.folder / "part.step")
        run = self.regress("--update", "part")
        self.assertEqual((run.returncode, run.stderr), (0, ""))

    def mutate(self, part: str, change) -> list:
        step = StepText(surface(f"{part}.step"))
        change(step)
        step.write(self.folder / "part.step")
        run = self.regress()
        self.assertIn(run.returncode, (0, 1), run.stderr + run.stdout)
        caught = self.caught_by()
        self.assertEqual(run.returncode, 1 if caught else 0)
        return caught

    def compared(self, part: str) -> list:
        run = self.keiko("compare", "-q", surface(f"{part}.step"), "part.step")
        self.assertIn(run.returncode, (0, 1), run.stderr)
        return ["keiko compare"] if run.returncode == 1 else []

    def study(self, part: str):
        self.prepare(part)
        for name, change in PARTS[part]:
            with self.subTest(part=part, change=name):
                caught = self.mutate(part, change)
                if LONG:
                    caught += self.compared(part)
                if os.environ.get("KEIKO_TABLE"):
                    print(f"| {part} | {name} | {', '.join(caught) or '–'} |", flush=True)
                if "by 1 um" not in name:
                    self.assertTrue(caught, "not caught")
        with self.subTest(part=part, change="none"):
            self.assertEqual(self.mutate(part, lambda step: None), [])

    def test_a_seam(self):
        self.study("seam-g1-only")

    def test_spline_faces_with_inner_knots(self):
        self.study("hood")

    def test_rational_patches(self):
        self.study("rational-sphere")

    def test_a_trimmed_face(self):
        self.study("trimmed-hole")

    def test_a_second_import_other_threads_and_a_file_written_anew_raise_no_alarm(self):
        self.prepare("seam-g1-only")
        for threads in "1", "3":
            self.assertEqual(self.regress("--fresh", "--threads", threads).returncode, 0)
        original = Path(surface("seam-g1-only.step")).read_text()
        for text in original, original.replace(";\n#", ";\n\n#").replace(",(", ", ("):
            (self.folder / "part.step").write_text(text)
            run = self.regress()
            self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
            self.assertEqual(self.caught_by(), [])

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
            self.prepare(part)
            with self.subTest(part=part):
                reexport(surface(f"{part}.step"), self.folder / "part.step")
                run = self.regress()
                self.assertEqual((run.returncode, self.caught_by()), (0, []), run.stdout)

    @unittest.skipUnless(LONG, "only with KEIKO_LONG=1")
    def test_real_panels(self):
        for panel in PANELS:
            if not (SHARED / panel).exists():
                self.skipTest(f"{SHARED / panel} is not there")
            original, changed = self.folder / "original.step", self.folder / "changed.step"
            reexport(SHARED / panel, original)
            self.assert_compared(panel, "written anew as STEP", SHARED / panel, original, 0)
            for name, change in [*POINT[1:], *FACES]:
                step = StepText(original)
                change(step)
                step.write(changed)
                self.assert_compared(panel, name, original, changed, 1)

    def assert_compared(self, panel: str, name: str, before, after, expected: int):
        with self.subTest(panel=panel, change=name):
            run = subprocess.run([os.environ["KEIKO_BINARY"], "compare", "-q", str(before), str(after)],
                                 capture_output=True, text=True, timeout=600)
            if os.environ.get("KEIKO_TABLE"):
                print(f"| {panel} | {name} | {run.returncode} |", flush=True)
            self.assertEqual(run.returncode, expected, run.stdout + run.stderr)


if __name__ == "__main__":
    unittest.main()
