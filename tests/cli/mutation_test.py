"""Which check of keiko regress catches which change of a part, at the default tolerances.

Everything of 10 um or 0.02 degrees and above must be caught, and nothing else. KEIKO_TABLE=1 prints
the table of docs/regression.md; KEIKO_LONG=1 asks `keiko compare` as well.
"""
import json
import os
import unittest
from pathlib import Path

from keiko_process import KeikoTest, surface
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
                if os.environ.get("KEIKO_LONG"):
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


if __name__ == "__main__":
    unittest.main()
