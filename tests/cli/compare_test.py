"""keiko compare: what it tells of two revisions, and its exit codes."""
import json
import os
import shutil
import signal
import subprocess
import unittest
import xml.etree.ElementTree as ElementTree
from html.parser import HTMLParser
from pathlib import Path

from keiko_process import BINARY, SOURCE, KeikoTest, surface
from step_text import StepText

DOME = surface("dome.bpt")
# What the tests tell apart shows at these as well, in a tenth of the time.
FEW = "compare", "-q", "--samples", "500"
VIEW = "--view", "high-front", "--size", "64x36", "--rig", str(SOURCE / "lightrigs" / "bench-6.toml")
HOLED = surface("trimmed-hole.step")
PIXEL = 1.25  # mm
ABOVE = """format = "keiko-view/1"
projection = "orthographic"
eye = [0, 0, 3000]
target = [0, 0, 0]
up = [0, 1, 0]
orthographic_height = 250
"""
SHARED = SOURCE.parent / "shared" / "models"
# The same parts in several formats; the first of each is what the others were written from.
FORMATS = (("car-hood.brep", "car-hood-converted.step", "car-hood-converted.igs"),
           ("car-front-fender.brep", "car-front-fender-converted.igs"),
           ("cube-unit-mm.step", "cube-unit-in.step"))
SCHEMA = json.loads((SOURCE / "docs" / "schema" / "keiko-comparison.schema.json").read_text())


class Page(HTMLParser):
    """What a page holds: its tags, its text, and whether every tag is closed."""

    VOID = {"meta", "img", "input", "br", "link"}

    def __init__(self, text: str):
        super().__init__()
        self.tags, self.open, self.text = [], [], ""
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        self.tags.append((tag, dict(attributes)))
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag, tag

    def handle_data(self, data):
        self.text += data

    def sources(self) -> list:
        return [attributes["src"] for tag, attributes in self.tags if "src" in attributes]


class Compare(KeikoTest):
    def dome_with_point_moved(self, millimetres: float) -> str:
        """The dome with an inner control point of its first patch (degree 3 x 5) raised."""
        lines = Path(DOME).read_text().splitlines()
        line = 2 + 1 * 6 + 2
        x, y, z = map(float, lines[line].split())
        lines[line] = f"{x!r} {y!r} {z + millimetres!r}"
        return self.write("moved.bpt", "\n".join(lines) + "\n")

    def test_a_part_is_the_same_as_itself(self):
        self.assertTrue(self.succeed(*FEW, DOME, DOME).startswith("same within tolerance\n"))

    def test_a_control_point_moved_by_ten_micrometres_is_found_from_both_sides(self):
        moved = self.dome_with_point_moved(0.01)
        for command, pair in (("compare", "-q"), (DOME, moved)), (FEW, (moved, DOME)):
            run = self.keiko(*command, *pair)
            self.assertEqual((run.returncode, run.stderr), (1, ""), run.stdout)
            self.assertTrue(run.stdout.startswith("different\n! deviation of "), run.stdout)
            self.assertEqual(run.stdout.count("; 0.0005 mm allowed; "), 2, run.stdout)

    def test_one_micrometre_of_a_control_point_is_within_the_tolerance_unless_told(self):
        moved = self.dome_with_point_moved(0.001)
        self.assertEqual(self.keiko(*FEW, DOME, moved).returncode, 0)
        strict = self.keiko(*FEW, DOME, moved, "--tolerance", "1e-5")
        self.assertEqual(strict.returncode, 1, strict.stdout)

    def test_a_symmetric_body_is_its_own_mirror_image(self):
        out = self.succeed(*FEW, surface("hood.step"), "--mirror", "y")
        self.assertTrue(out.startswith("same within tolerance\n"), out)
        self.assertIn("mirrored at y = 0", out)

    def test_a_dent_on_one_side_is_a_deviation_from_symmetry(self):
        run = self.keiko(*FEW, surface("dent.step"), "--mirror", "y=0", "--json", "a.json")
        self.assertEqual((run.returncode, run.stderr), (1, ""), run.stdout)
        worst = json.loads((self.folder / "a.json").read_text())["deviation"]["worst"]
        self.assertAlmostEqual(abs(worst["value"]), 0.1, delta=2e-3)
        self.assertAlmostEqual(worst["place"][0], 40, delta=5)
        self.assertAlmostEqual(abs(worst["place"][1]), 20, delta=5)

    def test_a_plane_that_is_none_is_told(self):
        for plane in "q", "y=", "y12", "y=1x", "y=inf":
            run = self.keiko(*FEW, DOME, "--mirror", plane)
            self.assertEqual(run.returncode, 2)
            self.assertIn(f"'{plane}' is no plane to mirror at", run.stderr)
        run = self.keiko("compare", DOME)
        self.assertEqual(run.returncode, 2)
        self.assertIn("AFTER: is missing", run.stderr)

    def test_another_trim_is_another_part(self):
        run = self.keiko(*FEW, surface("trimmed-hole.step"), surface("trimmed-two-holes.step"))
        self.assertEqual(run.returncode, 1)
        self.assertIn("not proved on", run.stdout)

    def test_findings_come_and_go(self):
        run = self.keiko(*FEW, surface("seam-g1-angle.step"), surface("seam-g1-only.step"))
        self.assertEqual(run.returncode, 1)
        self.assertIn("finding new: ", run.stdout)
        self.assertIn("finding fixed: ", run.stdout)

    def test_the_text_does_not_depend_on_threads(self):
        pair = surface("seam-g1-angle.step"), surface("seam-g0-gap.step")
        texts = {self.keiko(*FEW, *pair, "--threads", n).stdout for n in ("1", "2")}
        self.assertEqual(len(texts), 1)

    def test_bodies_that_have_nothing_in_common_are_told_soon(self):
        run = self.keiko(*FEW, DOME, surface("hood.step"), "--reach", "30")
        self.assertEqual((run.returncode, run.stderr), (1, ""))
        self.assertIn("further than 30 mm", run.stdout)
        self.assertIn("face gone: ", run.stdout)
        self.assertIn("face new: ", run.stdout)
        self.assertIn("? normals cannot be compared: nothing of one part lies within 30 mm", run.stdout)
        self.assertNotIn("at most 0 ", run.stdout)

    def test_a_number_of_one_has_no_plural(self):
        step = StepText(surface("seam-g1-only.step"))
        step.drop_face(step.faces()[1])
        step.write(self.folder / "less.step")
        run = self.keiko(*FEW, surface("seam-g1-only.step"), "less.step")
        self.assertIn("! 1 face gone, 0 new", run.stdout)

    def test_a_dropped_face_is_told_by_name(self):
        step = StepText(surface("seam-g1-only.step"))
        step.drop_face(step.faces()[1])
        step.write(self.folder / "less.step")
        run = self.keiko(*FEW, surface("seam-g1-only.step"), "less.step")
        self.assertEqual(run.returncode, 1)
        self.assertIn("face gone: face 2", run.stdout)
        self.assertIn("seam gone: ", run.stdout)
        back = self.keiko(*FEW, "less.step", surface("seam-g1-only.step"))
        self.assertIn("face new: face 2", back.stdout)

    def test_a_part_that_was_moved_is_found_and_told(self):
        moved = self.write("scene.toml", f'''format = "keiko-scene/1"
[[model]]
file = "{surface('hood.step')}"
transform = {{ rotate = [0, 0, 1, 0.25], translate = [3, -2, 1] }}
''')
        self.assertEqual(self.keiko(*FEW, surface("hood.step"), moved).returncode, 1)
        run = self.keiko(*FEW, surface("hood.step"), moved, "--align", "--json", "out.json")
        self.assertEqual((run.returncode, run.stderr), (0, ""), run.stdout)
        self.assertIn("aligned: turned by 0.25 degrees", run.stdout)
        found = json.loads((self.folder / "out.json").read_text())
        self.assertTrue(found["alignment"]["converged"])
        self.assertLess(found["alignment"]["residual"], 1e-6)
        self.assertLess(abs(found["deviation"]["worst"]["value"]), 1e-6)

    def test_a_missing_file_is_an_error(self):
        run = self.keiko("compare", DOME, "nowhere.step")
        self.assertEqual((run.returncode, run.stdout), (2, ""))
        self.assertIn("nowhere.step", run.stderr)


class Formats(KeikoTest):
    """Parts that differ by their file format alone are the same in every picture, both ways round."""

    patience = 600

    def test_a_part_is_the_same_in_every_format(self):
        size = () if os.environ.get("KEIKO_LONG") else ("--size", "320x180")
        for names in FORMATS:
            files = [SHARED / name for name in names]
            if not all(file.exists() for file in files):
                self.skipTest(f"{SHARED} is not there")
            first, *others = map(str, files)
            for pair in [p for other in others for p in ((first, other), (other, first))]:
                with self.subTest(pair=pair):
                    run = self.keiko("compare", "-q", "--samples", "2000", *pair, "-o", "out", *size)
                    self.assertEqual((run.returncode, run.stderr), (0, ""), run.stdout)
                    shutil.rmtree(self.folder / "out")


class Reports(KeikoTest):
    def moved(self, millimetres: float) -> str:
        step = StepText(surface("seam-g1-only.step"))
        step.move_inner_point(step.faces()[0], millimetres)
        step.write(self.folder / "moved.step")
        return "moved.step"

    def compare(self, *arguments: str):
        run = self.keiko(*FEW, surface("seam-g1-only.step"), *arguments)
        self.assertEqual(run.stderr, "")
        return run

    def found(self) -> dict:
        found = json.loads((self.folder / "out.json").read_text())
        try:
            import jsonschema
            jsonschema.validate(found, SCHEMA)
        except ImportError:
            pass
        self.assertEqual(set(found), set(SCHEMA["required"]))
        return found

    def test_the_page_stands_alone_and_tells_the_verdict_first(self):
        run = self.compare(self.moved(0.5), "-o", "page.html", *VIEW)
        self.assertEqual(run.returncode, 1, run.stdout)
        self.assertEqual(self.content(), ["moved.step", "page.html"])
        text = (self.folder / "page.html").read_text()
        page = Page(text)
        self.assertEqual(page.open, [])
        self.assertNotIn("http", text)
        self.assertTrue(all(source.startswith("data:image/png;base64,") for source in page.sources()))
        self.assertEqual(len(page.sources()), 4)  # map, before, after, difference
        self.assertIn(("input", "range"), [(tag, a.get("type")) for tag, a in page.tags])
        for part in "different", "Deviation", "Worst places", "View high-front", "99.9 %", "moved in the mean":
            self.assertIn(part, page.text)
        self.assertLess(page.text.index("different"), page.text.index("Checks"))

    def test_a_page_may_end_in_htm(self):
        self.compare(self.moved(0.5), "-o", "page.HTM", *VIEW)
        self.assertEqual(self.content(), ["moved.step", "page.HTM"])

    def test_an_input_is_not_written_over(self):
        shutil.copy(surface("seam-g1-only.step"), self.folder / "copy.step")
        run = self.keiko(*FEW, surface("seam-g1-only.step"), "copy.step", "--json", "./copy.step")
        self.assertEqual((run.returncode, run.stdout), (2, ""))
        self.assertIn("./copy.step: is an input as well", run.stderr)
        self.assertTrue((self.folder / "copy.step").read_text().startswith("ISO-10303-21"))

    def test_nothing_is_written_where_one_of_the_outputs_cannot_be(self):
        # One byte too long for a name.
        run = self.keiko(*FEW, surface("seam-g1-only.step"), self.moved(0.5), "-o", "out", "--json", "a.json",
                         "--junit", "j" * 252 + ".xml", *VIEW)
        self.assertEqual((run.returncode, run.stdout), (2, ""))
        self.assertIn("keiko: jjj", run.stderr)
        self.assertEqual(self.content(), ["moved.step"])

    def test_progress_is_silent_for_a_while_where_there_is_no_terminal(self):
        run = self.keiko("compare", "--samples", "500", surface("seam-g1-only.step"), self.moved(0.5))
        self.assertEqual(run.stderr, "")

    def test_a_folder_gets_page_numbers_pictures_and_lamps(self):
        self.compare(self.moved(0.5), "-o", "out", *VIEW)
        self.assertEqual([p for p in self.content() if p.startswith("out/")],
                         ["out/.keiko-results", "out/compare.html", "out/compare.json", "out/high-front-after.png",
                          "out/high-front-before.png", "out/high-front-deviation.png",
                          "out/high-front-difference.png", "out/rig.toml"])

    def test_results_of_an_earlier_run_are_withdrawn(self):
        moved = self.moved(0.5)
        self.compare(moved, "-o", "out", "--json", "a.json", *VIEW)
        run = self.keiko("compare", moved, "none.step", "-o", "out", "--json", "a.json", "-q")
        self.assertEqual(run.returncode, 2)
        self.assertEqual(self.content(), ["moved.step", "out"])

    def test_the_json_holds_its_schema_and_what_was_moved(self):
        self.compare(self.moved(0.5), "--json", "out.json", *VIEW)
        found = self.found()
        self.assertEqual((found["format"], found["verdict"]), ("keiko-comparison/1", "different"))
        self.assertGreater(found["deviation"]["worst"]["value"], 0.01)
        self.assertEqual(found["faces"]["gone"] + found["faces"]["new"], [])
        view = found["views"][0]
        self.assertEqual(view["view"], "high-front")
        self.assertGreater(max(line["largest"] for line in view["lines"]), 0.1)
        self.assertFalse(view["lines_within"])

    def test_the_same_part_is_the_same_in_every_report(self):
        shutil.copy(surface("seam-g1-only.step"), self.folder / "copy.step")
        run = self.compare("copy.step", "-o", "out", "--json", "out.json", "--junit", "out.xml", *VIEW)
        self.assertEqual(run.returncode, 0, run.stdout)
        found = self.found()
        self.assertEqual(found["verdict"], "same")
        self.assertTrue(all(check["within"] for check in found["checks"]))
        self.assertEqual([layer["beyond"] for layer in found["views"][0]["layers"]], [0, 0, 0])
        suites = ElementTree.parse(self.folder / "out.xml").getroot()
        self.assertEqual(suites.get("failures"), "0")

    def test_junit_has_a_case_for_every_check_view_and_layer(self):
        self.compare(self.moved(0.5), "--junit", "out.xml", *VIEW)
        suites = ElementTree.parse(self.folder / "out.xml").getroot()
        cases = {case.get("name"): case.find("failure") is not None for case in suites.iter("testcase")}
        for name in ("deviation", "missing", "normals", "borders", "faces", "seams", "findings",
                     "high-front: lines", "high-front: outlines", "high-front: silhouette", "high-front: color"):
            self.assertIn(name, cases)
        self.assertTrue(cases["deviation"])
        self.assertFalse(cases["faces"])
        self.assertEqual(int(suites.get("failures")), sum(cases.values()))

    def moved_hole(self, millimetres: float) -> str:
        step = StepText(HOLED)
        step.move_inner_loop(step.faces()[0], millimetres, 200)
        step.write(self.folder / "hole.step")
        return "hole.step"

    def outlines(self, before: str, after: str) -> dict:
        """What the picture from above shows of outlines where the geometry may differ as it likes."""
        self.write("above.toml", ABOVE)
        run = self.keiko(*FEW, before, after, "--json", "out.json", "--view", "above.toml", "--size", "200x200",
                         "--rig", str(SOURCE / "lightrigs" / "bench-6.toml"), "--border-tolerance", "1",
                         "--tolerance", "1", "--angle-tolerance", "1", "--line-tolerance", "1")
        found = self.found()
        self.assertEqual(run.returncode, 0 if found["verdict"] == "same" else 1, run.stdout)
        return found["views"][0]["outlines"]

    def test_a_hole_that_moved_by_less_than_a_twentieth_pixel_is_the_same_in_pictures(self):
        for share in 0.5, 0.9, 1.1, 4:
            moved = share * 0.05 * PIXEL
            for pair in ((HOLED, self.moved_hole(moved)), (self.moved_hole(moved), HOLED)):
                with self.subTest(share=share, before=pair[0]):
                    outlines = self.outlines(*pair)
                    self.assertEqual(outlines["within"], share < 1, outlines)
                    if share > 1:
                        self.assertAlmostEqual(outlines["distance"], moved, delta=0.05 * moved)

    def test_geometry_alone_needs_no_pictures(self):
        self.compare(self.moved(0.5), "--json", "out.json")
        self.assertEqual(self.found()["views"], [])

    def test_the_bytes_do_not_depend_on_threads(self):
        pages = set()
        for threads in "1", "2":
            self.compare(self.moved(0.5), "-o", "page.html", *VIEW, "--threads", threads)
            pages.add((self.folder / "page.html").read_bytes())
        self.assertEqual(len(pages), 1)

    def test_what_cannot_be_written_or_read_is_told_before_the_work(self):
        part = surface("seam-g1-only.step")
        for arguments, reason in ((("-o", "nowhere/page.html"), "there is no folder"),
                                  (("--json", "nowhere/a.json"), "there is no folder"),
                                  (("--json", "a", "--junit", "./a"), "./a: is named for two outputs"),
                                  (("-o", "a.html", "--json", "a.html"), "is named for two outputs"),
                                  (("-o", "out", "--json", "out/compare.json"), "for two outputs"),
                                  (("--view", "sideways", "-o", "out"), "sideways"),
                                  (("--size", "0x9", "-o", "out"), "--size"),
                                  (("--rig", "none.toml"), "none.toml")):
            run = self.keiko("compare", part, part, *arguments)
            self.assertEqual((run.returncode, run.stdout), (2, ""), arguments)
            self.assertIn(reason, run.stderr)
            self.assertEqual(self.content(), [])

    def test_ctrl_c_leaves_nothing(self):
        car = surface("concept-car.step")
        process = subprocess.Popen([BINARY, "compare", car, car, "-o", "out", "--json", "out.json", "--verbose"],
                                   cwd=self.folder, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        for line in process.stderr:
            if line == "keiko: deviation\n":
                break
        process.send_signal(signal.SIGINT)
        output, errors = process.communicate(timeout=60)
        self.assertEqual((process.returncode, output), (130, ""), errors)
        self.assertEqual(self.content(), [])


if __name__ == "__main__":
    unittest.main()
