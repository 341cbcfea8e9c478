"""Zones and scope: --faces, --layers, --colors and --zone of check, inspect, lines and compare."""
import json
import re
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from keiko_process import ASLANT, SMALL, KeikoTest, surface
from step_text import StepText

LIMITS = """format = "keiko-preset/1"
name = "own"
[seam]
gap = 0.01
angle = 0.1
[lines]
turn = 0.1
"""


def strips(*slopes: float) -> str:
    """Five flat strips side by side along x, 20 mm wide; slopes in mm of z a strip."""
    text, z = f"{len(slopes)}\n", 0.0
    for i, slope in enumerate(slopes):
        text += f"1 1\n{20 * i} 0 {z}\n{20 * i} 100 {z}\n{20 * i + 20} 0 {z + slope}\n{20 * i + 20} 100 {z + slope}\n"
        z += slope
    return text


BENT = strips(0, 0.2, 0.2, 0.2, 0.2)  # 0.57 degrees between the faces 1 and 2, nothing else


def zone(name: str, keys: str, seam: str = "") -> str:
    return f'[[zone]]\nname = "{name}"\n{keys}\n' + (f"[zone.seam]\n{seam}\n" if seam else "")


def styled(source: str, target: Path, layers: dict, colors: dict):
    """A STEP file with faces on layers and in colours, by the names of the faces."""
    step = StepText(source)
    context = step.references(step.of_type("ADVANCED_BREP_SHAPE_REPRESENTATION|MANIFOLD_SURFACE_SHAPE_REPRESENTATION"
                                           "|SHAPE_REPRESENTATION")[0])[-1]
    faces = {re.search(r"'(.*?)'", step.entities[n])[1]: n for n in step.faces()}
    for name, layer in layers.items():
        step.add(f"PRESENTATION_LAYER_ASSIGNMENT('{layer}','',(#{faces[name]}))")
    items = []
    for name, parts in colors.items():
        color = step.add("COLOUR_RGB('',{},{},{})".format(*parts))
        filled = step.add(f"FILL_AREA_STYLE_COLOUR('',#{color})")
        area = step.add(f"FILL_AREA_STYLE('',(#{filled}))")
        fill = step.add(f"SURFACE_STYLE_FILL_AREA(#{area})")
        side = step.add(f"SURFACE_SIDE_STYLE('',(#{fill}))")
        usage = step.add(f"SURFACE_STYLE_USAGE(.BOTH.,#{side})")
        style = step.add(f"PRESENTATION_STYLE_ASSIGNMENT((#{usage}))")
        items.append(step.add(f"STYLED_ITEM('color',(#{style}),#{faces[name]})"))
    if items:
        step.add("MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION('',("
                 + ",".join(f"#{n}" for n in items) + f"),#{context})")
    step.write(target)


class Zones(KeikoTest):
    def check(self, *arguments: str) -> tuple:
        run = self.keiko("check", *arguments, "-q", "--json", "check.json")
        self.assertEqual(run.stderr, "", arguments)
        return run.returncode, run.stdout, json.loads((self.folder / "check.json").read_text())

    def refused(self, *arguments: str) -> str:
        run = self.keiko(*arguments, "-q")
        self.assertEqual((run.returncode, run.stdout), (2, ""), arguments)
        return run.stderr

    def test_a_fault_beside_the_scope_passes_aloud(self):
        bent = self.write("bent.bpt", BENT)
        code, text, found = self.check(bent)
        self.assertEqual((code, found["counts"]["fail"]), (1, 1))
        self.assertNotIn("scope", found)
        code, text, found = self.check(bent, "--faces", "4", "--faces", "5")
        self.assertEqual(code, 0)
        self.assertIn("; by class-a-outer; 2 of 5 faces judged (faces 4, 5)\n"
                      "out of scope, not judged: 3 faces of 5, 2 seams of 4; judged: faces 4, 5\n", text)
        scope = found["scope"]
        self.assertEqual((scope["faces"], scope["all_faces"], scope["seams"], scope["all_seams"]), (2, 5, 2, 4))
        self.assertEqual(scope["out_of_scope"], ["face 1", "face 2", "face 3"])
        self.assertEqual([(f["in_scope"], f["verdict"]) for f in found["faces"]],
                         3 * [(False, None)] + 2 * [(True, "pass")])
        self.assertEqual([s["faces"] for s in found["seams"]], ["face 3 | face 4", "face 4 | face 5"])

    def test_a_seam_with_one_side_in_the_scope_is_judged(self):
        bent = self.write("bent.bpt", BENT)
        for face in "1", "2":
            code, text, found = self.check(bent, "--faces", face)
            self.assertEqual(code, 1, face)
            self.assertIn("face 1 | face 2: the angle of", text)

    def test_names_layers_and_colours_come_from_the_file(self):
        styled(surface("hood.step"), self.folder / "hood.step", {"dome": "SKIN", "wing-left": "SKIN-2"},
               {"wing-right": (1.0, 0.0, 0.0), "dome": (0.5, 0.5, 0.5)})
        models = (surface("seam-g1-angle.step"), "hood.step")
        self.assertEqual(self.check(*models)[0], 1)
        for options, faces in ((("--faces", "wing-*"), 2), (("--layers", "SKIN"), 1), (("--layers", "SKIN*"), 2),
                               (("--colors", "#FF0000"), 1), (("--layers", "SKIN", "--faces", "dome"), 1)):
            code, text, found = self.check(*models, *options)
            self.assertEqual((code, found["scope"]["faces"]), (0, faces), options)
        self.assertEqual(self.check(*models, "--faces", "left", "--faces", "dome")[0], 1)

    def test_a_colour_is_that_of_the_screen(self):
        # OpenCASCADE 7.6 reads the parts of a STEP file as those of sRGB.
        styled(surface("hood.step"), self.folder / "grey.step", {}, {"dome": (0.5, 0.5, 0.5)})
        error = self.refused("check", "grey.step", "--colors", "#ff0000")
        self.assertIn("--colors: no face has the colour #ff0000; there are #808080", error)

    def test_words_that_select_nothing_are_errors(self):
        bent = self.write("bent.bpt", BENT)
        for options, reason in ((("--faces", "door*"), "--faces: no face has the number or a name like 'door*'"),
                                (("--layers", "SKIN"), "--layers: no face is on a layer like 'SKIN'; there are no layers"),
                                (("--colors", "#00ff00"), "--colors: no face has the colour #00ff00; there are no colours"),
                                (("--colors", "green"), "--colors: 'green' is no colour such as #c0c0c0"),
                                (("--zone", "A"), "--zone: preset class-a-outer has no zone 'A'"),
                                (("--faces", "1", "--faces", ""), "--faces")):
            self.assertIn(reason, self.refused("check", bent, *options))

    def test_zones_have_limits_of_their_own_and_say_what_they_let_pass(self):
        bent = self.write("bent.bpt", BENT)
        loose = "gap = 0.01\nangle = 1"
        self.write("c.toml", LIMITS + zone("C", 'faces = ["1", "2"]', loose))
        code, text, found = self.check(bent, "--preset", "c.toml")
        self.assertEqual(code, 0)
        self.assertIn("\nzone C: 2 faces (faces 1, 2), looser than own: angle 1 degrees instead of 0.1 degrees, "
                      "fading 0.0142857 degrees/mm instead of 0.00142857 degrees/mm; "
                      "1 stretch of seams passes by these alone\n"
                      "in no zone: 3 faces, judged by the limits of own itself\n", text)
        self.assertEqual(found["scope"]["zones"][0]["excused_seams"], 1)
        self.assertEqual(found["scope"]["zones"][0]["limits"]["angle"], 1)
        self.assertEqual([s["zones"] for s in found["seams"]],
                         [["C", "C"], ["C", None], [None, None], [None, None]])
        self.assertEqual(found["seams"][0]["angle"]["limit"], 1)
        self.assertEqual(found["faces"][0]["zone"], "C")
        # A seam between the zone and the rest is held to the stricter limit.
        self.write("one.toml", LIMITS + zone("C", 'faces = ["1"]', loose))
        code, text, found = self.check(bent, "--preset", "one.toml")
        self.assertEqual((code, found["seams"][0]["angle"]["limit"]), (1, 0.1))
        # A zone may be stricter.
        slight = self.write("slight.bpt", strips(0, 0.02, 0.02))
        self.write("a.toml", LIMITS + zone("A", 'faces = ["1"]', "gap = 0.01\nangle = 0.01"))
        self.assertEqual(self.check(slight)[0], 0)
        code, text, found = self.check(slight, "--preset", "a.toml")
        self.assertEqual(code, 1)
        self.assertIn("zone A: 1 face (faces 1), no limit looser than those of own\n", text)

    def test_zones_without_faces_are_errors_that_name_file_and_zone(self):
        bent = self.write("bent.bpt", BENT)
        for keys, reason in (('faces = ["door"]', "zone 'A', faces: no face has the number or a name like 'door'"),
                             ("box = [[0, 0, 5], [1, 1, 6]]", "zone 'A': no face meets all its conditions: box "),
                             ('colors = ["#010203"]', "zone 'A', colors: no face has the colour #010203")):
            self.write("own.toml", LIMITS + zone("A", keys))
            error = self.refused("check", bent, "--preset", "own.toml")
            self.assertIn("own.toml:" + reason, error)
        self.write("own.toml", LIMITS + zone("A", 'faces = ["1"]', "gap = 0.01\nangle = -1"))
        self.assertIn("zone[0].seam.angle", self.refused("check", bent, "--preset", "own.toml"))

    def test_a_zone_may_be_the_scope(self):
        bent = self.write("bent.bpt", BENT)
        self.write("own.toml", LIMITS + zone("left", 'faces = ["1", "2"]') + zone("right", "box = [[59, -1, -1], [101, 101, 5]]"))
        for name, expected in ("left", 1), ("right", 0):
            code, text, found = self.check(bent, "--preset", "own.toml", "--zone", name)
            self.assertEqual((code, found["scope"]["faces"]), (expected, 2), name)
            self.assertIn(f"2 of 5 faces judged (zone {name})", text)

    def test_the_outer_skin_is_found(self):
        # A bent floor under a roof so low that nobody looks below it.
        roof = "1 1\n-20 -20 2\n-20 120 2\n120 -20 2\n120 120 2\n"
        body = self.write("body.bpt", BENT.replace("5\n", "6\n", 1) + roof)
        self.assertEqual(self.check(body)[0], 1)
        run = self.keiko("check", body, "--zone", "outer-skin", "-q")
        self.assertEqual((run.returncode, run.stderr),
                         (0, "keiko: warning: no seam was judged: none is on a face in the scope\n"))
        self.assertIn("1 of 6 faces judged (zone outer-skin)\n", run.stdout)

    def test_files_for_other_programs_have_the_scope(self):
        bent = self.write("bent.bpt", BENT)
        self.keiko("check", bent, "--faces", "5", "--junit", "a.xml", "--sarif", "a.sarif", "--csv", "a.csv", "-q")
        properties = ElementTree.parse(self.folder / "a.xml").getroot().iter("property")
        sentence = "out of scope, not judged: 4 faces of 5, 3 seams of 4; judged: faces 5"
        self.assertIn(("scope", sentence), [(p.get("name"), p.get("value")) for p in properties])
        run, = json.loads((self.folder / "a.sarif").read_text())["runs"]
        self.assertEqual((run["properties"]["scope"], run["results"]), ([sentence], []))
        self.assertNotIn("face 1 | face 2", (self.folder / "a.csv").read_text())

    def test_the_report_has_scope_and_zones(self):
        bent = self.write("bent.bpt", BENT)
        self.write("own.toml", LIMITS + zone("C", 'faces = ["1", "2"]', "gap = 0.01\nangle = 1"))
        run = self.keiko("inspect", bent, "--faces", "5", "--preset", "own.toml", "-o", "out", "--view", "top", *SMALL, "-q")
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        self.assertIn("; 1 of 5 faces judged (faces 5); see ", run.stdout)
        self.assertIn("\nout of scope, not judged: 4 faces of 5", run.stdout)
        report = json.loads((self.folder / "out" / "report.json").read_text())
        self.assertEqual(report["scope"]["faces"], 1)
        self.assertEqual(report["scope"]["zones"][0]["name"], "C")
        page = (self.folder / "out" / "report.html").read_text()
        self.assertIn("1 of 5 faces judged (faces 5)", page)
        self.assertIn("<h2>Scope and zones</h2>", page)
        self.assertIn("zone C: 2 faces", page)
        run = self.keiko("inspect", bent, "--faces", "1", "-o", "bad", "--view", "top", *SMALL, "-q")
        self.assertEqual(run.returncode, 1)

    def test_lines_are_judged_in_the_scope(self):
        self.write("aslant.toml", ASLANT)
        model = self.write("bent.bpt", BENT)
        def lines(*options: str) -> tuple:
            run = self.keiko("lines", model, "--rig", "aslant.toml", "--view", "top", "-o", "l.json", "-q", *options)
            return run.returncode, run.stdout, json.loads((self.folder / "l.json").read_text())
        code, text, found = lines()
        self.assertEqual(code, 1)
        faults = [c for c in found["crossings"] if c["verdict"] == "fail"]
        self.assertEqual({c["faces"] for c in faults}, {"face 1 | face 2"})
        whole = len(found["crossings"])
        code, text, found = lines("--faces", "5")
        self.assertEqual(code, 0)
        self.assertEqual({c["faces"] for c in found["crossings"]}, {"face 4 | face 5"})
        self.assertEqual(found["counts"]["out_of_scope"], whole - len(found["crossings"]))
        self.assertRegex(text, r"; 1 of 5 faces judged \(faces 5\), \d+ crossings out of scope; see ")
        self.assertEqual(lines("--faces", "1")[0], 1)
        self.write("own.toml", LIMITS + zone("C", 'faces = ["1", "2"]') + "[zone.lines]\nturn = 5\n")
        code, text, found = lines("--preset", "own.toml")
        self.assertEqual(code, 0)
        self.assertIn("looser than own: turn of lines 5 degrees instead of 0.1 degrees", text)

    def test_revisions_are_compared_in_the_scope(self):
        self.write("before.bpt", strips(0, 0.2, 0.2, 0.2, 0.2))
        self.write("after.bpt", strips(0, 0.2, 0.2, 0.2, 0.4))
        def compare(*options: str) -> tuple:
            run = self.keiko("compare", "before.bpt", "after.bpt", "--json", "c.json", "-q", *options)
            return run.returncode, run.stdout, json.loads((self.folder / "c.json").read_text())
        self.assertEqual(compare()[0], 1)
        code, text, found = compare("--faces", "1", "--faces", "2")
        self.assertEqual((code, found["verdict"]), (0, "same"), text)
        self.assertIn("same within tolerance; 2 of 5 faces judged (faces 1, 2)\n", text)
        self.assertIn("before: out of scope, not judged: 3 faces of 5", text)
        self.assertEqual(found["scope"]["after"]["faces"], 2)
        self.assertEqual(compare("--faces", "5")[0], 1)
        pictures = ("--view", "top", "--rig", self.write("aslant.toml", ASLANT), *SMALL)
        code, text, found = compare("--faces", "1", "--faces", "2", *pictures)
        self.assertEqual(code, 0, text)
        self.assertEqual(compare("--faces", "5", *pictures)[0], 1)
        self.assertIn("--faces: no face has the number or a name like 'door'",
                      self.refused("compare", "before.bpt", "after.bpt", "--faces", "door"))


if __name__ == "__main__":
    unittest.main()
