"""`keiko check`: verdict, exit code, and files that other programs read."""
import csv
import json
import math
import re
import shutil
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from keiko_process import SMALL, SOURCE, KeikoTest, surface
from sarif_rules import faults_of_log, path_of
from step_text import StepText

GAP = surface("seam-g0-gap.step")


class Check(KeikoTest):
    def check(self, *arguments: str) -> tuple:
        """Exit code and what is printed."""
        run = self.keiko("check", *arguments, "-q")
        self.assertEqual(run.stderr, "", arguments)
        return run.returncode, run.stdout

    def test_a_gap_is_a_finding(self):
        code, text = self.check(GAP)
        self.assertEqual(code, 1)
        self.assertRegex(text, r"\Afail: stretches of seams 1 fail, 0 undecided, 0 pass, 0 creases; 800.2 of 1200.7 mm of borders meet no other; by class-a-outer\n")
        self.assertRegex(text, r"\nfail  G-SU-LG  #1  face 1 \(left\) of seam-g0-gap [\d.]+ \| face 2 \(right\) of seam-g0-gap [\d.]+: the gap of 0.05 mm is over the "
                               r"limit of 0.01 mm, at [-\d.]+, [-\d.]+, [-\d.]+\n\Z")

    def test_faces_too_far_apart_for_a_seam_pass_with_a_warning(self):
        def sheet(x: float) -> str:
            return f"1 1\n{x} 0 0\n{x} 100 0\n{x + 100} 0 0\n{x + 100} 100 0\n"
        apart = self.write("apart.bpt", "2\n" + sheet(0) + sheet(100.6))
        run = self.keiko("check", apart, "-q")
        self.assertEqual((run.returncode, run.stdout), (0, "pass: stretches of seams 0 fail, 0 undecided, 0 pass, 0 creases; "
                                                           "800.0 of 800.0 mm of borders meet no other; by class-a-outer\n"))
        self.assertEqual(run.stderr, "keiko: warning: no seam was judged: of 2 faces no two have borders that run along each other "
                                     "within the join distance, 0.5 mm\n")
        run = self.keiko("inspect", apart, "-q", "-o", "out", "--view", "top", *SMALL)
        self.assertEqual(run.returncode, 0)
        self.assertIn("; 800.0 of 800.0 mm of borders meet no other; lines ", run.stdout)
        self.assertIn("no seam was judged", run.stderr)
        code, text = self.check(apart, "--join", "1")
        self.assertEqual((code, text[:46]), (1, "fail: stretches of seams 1 fail, 0 undecided, "))
        self.assertIn("600.0 of 800.0 mm of borders meet no other", text)
        self.assertEqual(self.check(self.write("one.bpt", "1\n" + sheet(0)))[0], 0)

    def test_a_closed_body_has_no_borders_to_tell_of(self):
        self.assertNotIn("borders", self.check(surface("rational-sphere.step"))[1])

    def test_the_preset_decides(self):
        self.assertEqual(self.check(surface("seam-g1-angle.step"))[0], 1)
        self.assertEqual(self.check(surface("seam-g1-angle.step"), "--preset", "engineering")[0], 0)

    def test_a_file_of_which_a_face_or_a_trim_is_lost_does_not_pass(self):
        def lost(edited: str, entity: int, faces: int) -> str:
            step = StepText(surface(edited))
            step.entities[entity] = "UN" + step.entities[entity]
            step.write(self.folder / "lost.step")
            run = self.keiko("check", "lost.step", "--preset", "engineering", "-q", "--json", "a.json",
                             "--junit", "a.xml", "--sarif", "a.sarif")
            report = json.loads((self.folder / "a.json").read_text())
            self.assertEqual((run.returncode, report["verdict"], report["model"]["faces"]), (1, "undecided", faces))
            face, = report["model"]["lost_faces"]
            self.assertIn(f"face {face['id']} is missing: {face['reason']}", run.stderr)
            for name in "a.xml", "a.sarif":
                self.assertIn(face["reason"], (self.folder / name).read_text())
            return face["reason"]

        self.assertEqual(self.check(surface("hood.step"), "--preset", "engineering")[0], 0)
        hood = StepText(surface("hood.step"))
        face = hood.faces()[1]
        of = hood.surface_of(face)
        self.assertRegex(lost("hood.step", of, 2),
                         rf"\A#{face} in line \d+ gave no face; its surface is #{of} of kind UN\w+\Z")
        hole = StepText(surface("trimmed-two-holes.step"))
        bound = hole.references(hole.faces()[0])[1]
        edge = hole.references(hole.references(hole.references(bound)[0])[0])[-1]
        self.assertRegex(lost("trimmed-two-holes.step", edge, 0), rf"\Abound #{bound} in line \d+ lacks edge 1 ")

    def test_several_files_form_one_body(self):
        code, _ = self.check(surface("seam-g2-only.step"), surface("trimmed-hole.step"), "--json", "a.json")
        self.assertEqual(code, 0)
        model = json.loads((self.folder / "a.json").read_text())["model"]
        self.assertIn("trimmed-hole.step", model["source"])

    def test_it_finds_what_inspect_finds(self):
        self.check(GAP, "--json", "a.json")
        self.keiko("inspect", GAP, "-o", "out", "--view", "top", *SMALL, "--csv", "a.csv")
        alone = json.loads((self.folder / "a.json").read_text())
        whole = json.loads((self.folder / "out/report.json").read_text())
        for key in "verdict", "counts", "seams", "faces", "findings":
            self.assertEqual(alone[key], whole[key])
        self.check(GAP, "--csv", "b.csv")
        self.assertEqual((self.folder / "a.csv").read_bytes(), (self.folder / "b.csv").read_bytes())

    def test_two_runs_give_the_same_bytes_for_any_number_of_threads(self):
        names = "a.json", "a.xml", "a.sarif", "a.csv"
        outputs = [part for name in names for part in ("-o", name)]

        def files(threads: str):
            self.check(surface("seam-g1-only.step"), *outputs, "--threads", threads)
            return [(self.folder / name).read_bytes() for name in names]
        self.assertEqual(files("1"), files("3"))

    def test_the_ending_names_the_format(self):
        self.check(GAP, "-o", "a.csv", "-o", "b.xml", "--csv", "c", "--junit", "d")
        self.assertEqual((self.folder / "a.csv").read_bytes(), (self.folder / "c").read_bytes())
        self.assertEqual((self.folder / "b.xml").read_bytes(), (self.folder / "d").read_bytes())

    def test_what_cannot_be_written_is_told_before_the_work(self):
        for path, reason in (("a.txt", r"--output: 'a\.txt' ends in none of"),
                             ("none/a.csv", r"none/a\.csv: there is no folder none")):
            run = self.keiko("check", "missing.step", "-o", path)
            self.assertEqual((run.returncode, run.stdout), (2, ""))
            self.assertRegex(run.stderr, rf"\Akeiko: {reason}.*\n\Z")
        self.assertEqual(self.content(), [])

    def test_files_of_an_earlier_run_are_withdrawn(self):
        files = ("--sarif", "a.sarif", "--csv", "a.csv", "--json", "link.json", "--junit", "a.xml")
        (self.folder / "link.json").symlink_to("a.json")
        self.check(GAP, *files)
        self.assertEqual(len(self.content()), 5)
        for wrong in (("none.step",), (GAP, "--preset", "none.toml")):
            self.check(GAP, *files)
            run = self.keiko("check", *wrong, *files)
            self.assertEqual((run.returncode, run.stdout), (2, ""))
            self.assertEqual(self.content(), ["link.json"])
            self.assertTrue((self.folder / "link.json").is_symlink())

    def test_names_of_faces_do_not_reach_the_terminal_as_they_are(self):
        text = Path(GAP).read_text()
        self.assertIn("'left'", text)
        self.write("evil.step", text.replace("'left'", "'left\x1b[2J'"))
        run = self.keiko("check", "evil.step", "--json", "a.json", "-q")
        self.assertEqual(run.returncode, 1)
        self.assertNotIn("\x1b", run.stdout + run.stderr)
        self.assertIn("left?[2J", run.stdout)
        report = json.loads((self.folder / "a.json").read_text())
        self.assertIn("left\x1b[2J", report["faces"][0]["name"])
        facts = self.keiko("info", "evil.step", "--json", "-q")
        self.assertNotIn("\x1b", facts.stdout)

    def test_a_file_is_not_asked_for_twice(self):
        run = self.keiko("check", "missing.step", "-o", "a.json", "--junit", "./a.json")
        self.assertEqual((run.returncode, run.stdout), (2, ""))
        self.assertEqual(run.stderr, "keiko: a.json: is named for two outputs\n")

    def test_junit_counts_its_cases(self):
        for name, preset in (("seam-g0-gap.step", "class-a-strict"), ("dome.bpt", "class-a-strict")):
            self.check(surface(name), "--preset", preset, "--junit", "a.xml", "--csv", "a.csv")
            root = ElementTree.parse(self.folder / "a.xml").getroot()
            self.assertEqual(root.tag, "testsuites")
            suite, = root
            cases = suite.findall("testcase")
            self.assertEqual(suite[0].tag, "properties")
            self.assertEqual({e.tag for e in suite[1:]}, {"testcase"})
            self.assertEqual(int(suite.get("tests")), len(cases))
            for attribute, element in (("failures", "failure"), ("errors", "error"),
                                       ("skipped", "skipped")):
                self.assertEqual(int(suite.get(attribute)), len(suite.findall(f"testcase/{element}")))
            self.assertEqual(len(cases), len({case.get("name") for case in cases}))
            for case in cases:
                self.assertEqual(case.get("classname"), surface(name))
                self.assertLessEqual(len(case), 1)
            for fault in suite.findall("testcase/failure"):
                self.assertRegex(fault.get("type"), r"\A(G-[A-Z]{2}-[A-Z]{2}|KEIKO-\w+)\Z")
                self.assertIn(fault.get("message"), fault.text)
            rows = (self.folder / "a.csv").read_bytes().count(b"\r\n") - 1
            self.assertEqual(rows, len(cases))

    def test_sarif_has_what_its_schema_requires(self):
        code, _ = self.check(surface("seam-g0-gap.step"), "--sarif", "a.sarif")
        log = json.loads((self.folder / "a.sarif").read_text())
        self.assertEqual(faults_of_log(log), [])
        run, = log["runs"]
        driver = run["tool"]["driver"]
        self.assertEqual(driver["name"], "Keiko")
        ids = [rule["id"] for rule in driver["rules"]]
        self.assertEqual(len(ids), len(set(ids)))
        for rule in driver["rules"]:
            self.assertTrue(rule["shortDescription"]["text"].endswith("."))
        for invocation in run["invocations"]:
            self.assertIs(invocation["executionSuccessful"], True)
        result, = run["results"]
        self.assertEqual(ids[result["ruleIndex"]], result["ruleId"])
        self.assertEqual((result["ruleId"], result["level"]), ("G-SU-LG", "error"))
        self.assertIn("the gap of 0.05 mm", result["message"]["text"])
        location, = result["locations"]
        artifact = location["physicalLocation"]["artifactLocation"]
        self.assertEqual(run["artifacts"][artifact["index"]]["location"]["uri"], artifact["uri"])
        self.assertEqual(path_of(run, artifact), GAP)
        line = location["physicalLocation"]["region"]["startLine"]
        self.assertRegex(Path(GAP).read_text().splitlines()[line - 1], r"\A#\d+ ?= ?ADVANCED_FACE")
        self.assertRegex(location["logicalLocations"][0]["name"], r"\Aface 1 .* \| face 2 ")
        self.assertAlmostEqual(result["properties"]["value"], 0.05, delta=1e-9)
        self.assertEqual(len(result["properties"]["place"]), 3)

    def test_sarif_keeps_to_its_rules_whatever_is_found(self):
        awkward = "ä {0} [b](c)#%?&'.step"
        shutil.copy(GAP, self.folder / awkward)
        for models, preset, code in (([surface("dent.step")], "class-a-waviness", 1),
                                     ([surface("hood.step")], "vda-4955", 0),
                                     ([surface("seam-g2-only.step")], "class-a-strict", 1),
                                     ([GAP, surface("dent.step")], "class-a-outer", 1),
                                     ([awkward], "class-a-outer", 1)):
            with self.subTest(models=models):
                self.check(*models, "--preset", preset, "--sarif", "a.sarif")
                log = json.loads((self.folder / "a.sarif").read_text())
                self.assertEqual(faults_of_log(log), [])
                run, = log["runs"]
                self.assertEqual([path_of(run, artifact["location"]) for artifact in run["artifacts"]], models)
                self.assertEqual(bool(run["results"]), code == 1)

    def test_sarif_has_both_files_of_a_seam_between_two(self):
        one = self.write("upper.bpt", "1\n1 1\n0 0.05 0\n0 50 0\n100 0.05 0\n100 50 0\n")
        other = self.write("lower.bpt", "1\n1 1\n0 -50 0\n0 0 0\n100 -50 0\n100 0 0\n")
        self.check(one, other, "--sarif", "a.sarif")
        log = json.loads((self.folder / "a.sarif").read_text())
        self.assertEqual(faults_of_log(log), [])
        run, = log["runs"]
        result, = run["results"]
        first, related = result["locations"][0], result["relatedLocations"][0]
        self.assertEqual(first["physicalLocation"]["artifactLocation"]["uri"], one)
        self.assertEqual(related["physicalLocation"]["artifactLocation"]["uri"], other)

    def test_a_csv_row_holds_every_measure(self):
        self.check(GAP, "--preset", "class-a-strict", "--csv", "a.csv")
        data = (self.folder / "a.csv").read_bytes()
        self.assertEqual(data.count(b"\n"), data.count(b"\r\n"))
        rows = list(csv.DictReader(data.decode().splitlines(keepends=True), strict=True))
        self.assertEqual([row["quantity"] for row in rows],
                         ["gap", "angle", "curvature", "curvature_slope"])
        self.assertAlmostEqual(float(rows[0]["value"]), 0.05, delta=1e-9)
        self.assertEqual(float(rows[0]["limit"]), 0.001)
        self.assertEqual([row["verdict"] for row in rows], ["fail", "pass", "not judged", "not judged"])
        self.assertEqual(rows[2]["value"], "")

    def test_combs_of_sections_and_iso_curves(self):
        hood = surface("hood.step")
        self.succeed("check", hood, "--section", "y=120", "--section", "1,0,1=900", "--iso-curves",
                     "1", "--combs", "c.csv", "--combs", "c.json", "--combs", "c.svg", "-q")
        self.assertEqual(self.content(), ["c-1,0,1=900.svg", "c-iso-curves.svg", "c-y=120.svg",
                                          "c.csv", "c.json"])
        combs = json.loads((self.folder / "c.json").read_text())
        section = combs["curves"][0]
        self.assertEqual((combs["format"], section["name"]), ("keiko-combs/1", "y=120"))
        self.assertAlmostEqual(section["length"], 1154, delta=1)
        rows = list(csv.DictReader((self.folder / "c.csv").read_text().splitlines(), strict=True))
        for row in rows:
            if row["curve"] == "0":
                self.assertAlmostEqual(float(row["y"]), 120, delta=1e-6)
        self.assertEqual(len({row["curve"] for row in rows}), len(combs["curves"]))

    def test_sections_and_inflections_go_out_as_curves(self):
        self.succeed("check", surface("hood.step"), "--section", "y=120", "--curves", "c.step",
                     "--json", "c.json", "-q")
        step = (self.folder / "c.step").read_text().replace("\n", "")
        self.assertIn("'section y=120, within ", step)
        report = json.loads((self.folder / "c.json").read_text())
        inflections = sum(len(face["inflections"]) for face in report["faces"])
        self.assertGreater(inflections, 0)
        names = re.findall(r"PRODUCT\( *'([^']*)'", step)
        self.assertEqual(len([n for n in names if ": inflection, within " in n]), inflections)
        self.assertEqual(len([n for n in names if n.startswith("section y=120")]), 1)
        seams = sum(not seam["scrap"] for seam in report["seams"])
        self.assertGreater(seams, 0)
        self.assertEqual(len([n for n in names if re.match(r"seam \d+: pass, ", n)]), seams)

    def test_a_section_that_misses_the_body_is_warned_about(self):
        hood = surface("hood.step")
        run = self.keiko("check", hood, "--section", "y=5000", "--combs", "c.json", "-q")
        self.assertIn("warning: section y=5000 misses the body, whose patches reach from", run.stderr)
        combs = json.loads((self.folder / "c.json").read_text())
        self.assertEqual([r["kind"] for r in combs["remarks"]], ["missed"])

    def test_combs_that_make_no_sense_are_refused(self):
        hood = surface("hood.step")
        for arguments, words in ((("--section", "y=120"), "--combs: names no file"),
                                 (("--section", "q=1", "--combs", "c.csv"), "'q=1' is not x=MM"),
                                 (("--combs", "c.csv"), "needs --section or --iso-curves"),
                                 (("--iso-curves", "1", "--combs", "c.txt"), "ends in none of")):
            run = self.keiko("check", hood, *arguments, "-q")
            self.assertEqual(run.returncode, 2)
            self.assertIn(words, run.stderr)
        self.assertEqual(self.content(), [])

    def test_profiles_of_seams_as_json_and_csv(self):
        self.check(GAP, "--profiles", "p.json", "--profiles", "p.csv")
        profiles = json.loads((self.folder / "p.json").read_text())
        self.assertEqual(profiles["format"], "keiko-profiles/1")
        self.validate(profiles)
        (profile,) = profiles["profiles"]
        gap = profile["gap"]
        self.assertAlmostEqual(gap["largest"], 0.05, delta=1e-9)
        self.assertEqual((gap["limit"], gap["judged"], gap["beyond"]["bound"]), (0.01, True, 0))
        self.assertAlmostEqual(gap["beyond"]["share"], 1, delta=1e-9)
        self.assertFalse(profile["curvature"]["judged"])
        self.assertEqual(profile["curvature"]["limit"], 0.1)
        rows = list(csv.DictReader((self.folder / "p.csv").read_text().splitlines(), strict=True))
        self.assertEqual(len(rows), len(profile["samples"]))
        for row, sample in zip(rows, profile["samples"]):
            self.assertEqual(float(row["along"]), sample["along"])
            self.assertEqual(float(row["curvature_b"]), sample["curvatures"][1])
            self.assertEqual((row["gap_limit"], row["slope_limit"]), ("0.01", ""))
            self.assertEqual(float(row["gap_beyond"]), gap["beyond"]["share"])
        self.assertAlmostEqual(float(rows[-1]["along"]), profile["length"], delta=1e-9)

    def validate(self, profiles):
        try:
            import jsonschema
        except ImportError:
            return
        path = SOURCE / "docs" / "schema" / "keiko-profiles.schema.json"
        jsonschema.validate(profiles, json.loads(path.read_text()))

    def test_profiles_of_every_surface_keep_the_schema(self):
        for name in ("hood.step", "concept-car.step"):
            self.check(surface(name), "--profiles", "p.json")
            profiles = json.loads((self.folder / "p.json").read_text())
            self.validate(profiles)
            for profile in profiles["profiles"]:
                along = [sample["along"] for sample in profile["samples"]]
                self.assertEqual(along, sorted(along))

    def test_profiles_that_make_no_sense_are_refused(self):
        hood = surface("hood.step")
        for arguments, words in ((("--profiles", "p.svg"), "--profiles: 'p.svg' ends in none of"),
                                 (("--profiles", "p"), "ends in none of .json and .csv"),
                                 (("--profiles", "p.csv", "--profiles", "p.csv"), "is asked for twice"),
                                 (("--profiles", "no/p.csv"), "there is no folder no"),
                                 (("--profiles", "p.csv", "--csv", "p.csv"), "is named for two outputs")):
            run = self.keiko("check", hood, *arguments, "-q")
            self.assertEqual(run.returncode, 2)
            self.assertIn(words, run.stderr)
            self.assertEqual(len(run.stderr.splitlines()), 1)
        self.assertEqual(self.content(), [])

    def test_inflection_curves_are_told(self):
        self.succeed("check", surface("hood.step"), "--json", "c.json", "-q")
        faces = json.loads((self.folder / "c.json").read_text())["faces"]
        self.assertEqual([len(face["inflections"]) for face in faces], [1, 2, 1])
        for face in faces:
            for curve in face["inflections"]:
                self.assertTrue(curve["proved"])
                self.assertAlmostEqual(curve["length"], 1153, delta=3)

    def test_a_body_is_held_against_its_mirror_image(self):
        car = surface("concept-car.step")
        code, text = self.check(car, "--symmetry", "y", "--json", "car.json")
        self.assertEqual(code, 0)
        self.assertIn("\npass  KEIKO-SYMMETRY  face ", text)
        found = json.loads((self.folder / "car.json").read_text())["symmetry"]
        self.assertLess(found["value"], 1e-4)
        # 5 um beside its plane the body is 10 um beside its image.
        code, text = self.check(car, "--symmetry", "y=0.005", "--symmetry-limit", "0.0098", "--csv", "car.csv")
        self.assertEqual(code, 1)
        self.assertIn("the deviation from the mirror image at y = 0.005 of 0.01 mm is over the limit of 0.0098 mm, at ", text)
        with open(self.folder / "car.csv", newline="") as file:
            value, = (float(row["value"]) for row in csv.DictReader(file) if row["code"] == "KEIKO-SYMMETRY")
        self.assertAlmostEqual(value, 0.01, delta=1e-4)

    def test_joints_are_measured_where_requested(self):
        line = surface("shut-line.step")
        self.assertNotIn("joint", self.check(line, "--json", "plain.json")[1])
        self.assertNotIn("joint", (self.folder / "plain.json").read_text())
        code, text = self.check(line, "--joints", "--json", "joints.json")
        self.assertEqual(code, 1)
        self.assertRegex(text, r"\n1 joint between panels that stand apart\njoint 1  face 1 \(fender-skin\).* \| face 4 \(door-skin\).*: gap ")
        self.assertIn("gap 3.500 to 4.547 mm, flush 0.400 to 0.400 mm, radius from 2.000 mm, 600.0 mm long\n", text)
        self.assertRegex(text, r"\nfail  KEIKO-JOINT-PARALLEL  #\d+  .* of 1.05 mm is over the limit of 0.5 mm")
        joint, = json.loads((self.folder / "joints.json").read_text())["joints"]
        # Both foremost lines meet in a tip, and the gap is 2 tan(taper / 2) of the way from there.
        taper = math.radians(0.1)
        rear = (8.5 - 3 * math.cos(taper), 300 + 3 * math.sin(taper))
        tip = rear[1] - (rear[0] - 2) / math.tan(taper)
        for section in joint["sections"]:
            x, _, z = section["sides"][0]["border"]
            way = (x - 2) * math.sin(taper / 2) + (z - tip) * math.cos(taper / 2)
            self.assertAlmostEqual(section["gap"], 2 * math.tan(taper / 2) * way, delta=1e-6)
            self.assertAlmostEqual(section["flush"], 0.4, delta=1e-6)
            self.assertAlmostEqual(section["sides"][0]["radius"], 2, delta=1e-6)
            self.assertAlmostEqual(section["sides"][1]["radius"], 3, delta=1e-6)

    def test_limits_of_joints_are_those_of_the_preset(self):
        seam = 'format = "keiko-preset/1"\nname = "p"\n[seam]\ngap = 1\nangle = 1\n'
        line = surface("shut-line.step")
        limits = '[joint]\ngap = { nominal = 4, tolerance = 0.6 }\nflush = { nominal = 0.4, tolerance = 0.1 }\nradius = 1.5\n'
        code, text = self.check(line, "--joints", "--preset", self.write("p.toml", seam + limits))
        self.assertEqual(code, 0, text)
        code, text = self.check(line, "--joints", "--preset", self.write("q.toml", seam + limits.replace("1.5", "2.5")))
        self.assertEqual(code, 1)
        self.assertIn("the radius of an edge of 2 mm is under the limit of 2.5 mm", text)
        run = self.keiko("check", line, "--joints", "--preset", self.write("r.toml", seam), "-q")
        self.assertEqual(run.stderr, "keiko: warning: no joint was judged: the preset p has no limits in [joint]\n")
        run = self.keiko("check", line, "--preset", "q.toml", "-q")
        self.assertEqual(run.stderr, "keiko: warning: no joint was judged: [joint] has limits, but joints were not sought\n")
        run = self.keiko("check", GAP, "--joints", "-q")
        self.assertEqual(run.stderr, "keiko: warning: no joint was found: no two panels end side by side within 15 mm\n")

    def test_a_plane_of_symmetry_is_checked(self):
        for arguments, reason in ((["--symmetry", "w"], "'w' is no plane to mirror at"),
                                  (["--symmetry-limit", "0.1"], "--symmetry-limit asks for --symmetry too")):
            run = self.keiko("check", GAP, *arguments)
            self.assertEqual(run.returncode, 2)
            self.assertIn(reason, run.stderr)
        preset = self.write("p.toml", 'format = "keiko-preset/1"\nname = "p"\n[seam]\ngap = 1\nangle = 1\n[surface]\n'
                                      'symmetry = { plane = "y=a", distance = 0.1 }\n')
        run = self.keiko("check", GAP, "--preset", preset)
        self.assertEqual(run.returncode, 2)
        self.assertIn("surface.symmetry.plane: 'y=a' is no plane to mirror at", run.stderr)

    def test_faces_are_told_by_their_curvature(self):
        self.check(surface("rational-sphere.step"), "--preset", "vda-4955", "--json", "a.json")
        data = json.loads((self.folder / "a.json").read_text())
        self.assertEqual(data["preset"]["minimum_radius"], 0.5)
        for face in data["faces"]:
            curvature = face["curvature"]
            self.assertAlmostEqual(face["radius"]["value"] * abs(curvature["smallest"]["value"]), 1, delta=1e-9)
            self.assertEqual(face["radius"]["limit"], 0.5)
            self.assertGreater(curvature["singular"], 0)

    def test_structure_is_judged_where_the_preset_limits_it(self):
        path = self.folder / "poles.toml"
        path.write_text('format = "keiko-preset/1"\nname = "poles"\n[seam]\ngap = 0.02\nangle = 0.1\n[structure]\n'
                        "degree = 11\nknot_distance = 0.02\npatch_edge = 0.2\ndegenerate_edge = 0.02\n"
                        "corner_angle = 2\nshort_edge = 0.02\nsmall_face = 0.02\n")
        code, out = self.check(surface("rational-sphere.step"), "--preset", str(path), "--json", "a.json",
                               "--sarif", "a.sarif", "--csv", "a.csv")
        self.assertEqual(code, 1)
        self.assertIn("the most degenerate edge of a patch of 0 mm is under the limit of 0.02 mm", out)
        data = json.loads((self.folder / "a.json").read_text())
        self.assertEqual(data["preset"]["structure"], {"degree": 11, "knot_distance": 0.02, "patch_edge": 0.2,
                                                       "degenerate_edge": 0.02, "corner_angle": 2,
                                                       "short_edge": 0.02, "small_face": 0.02})
        self.assertEqual({finding["code"] for finding in data["findings"]}, {"G-SU-DC"})
        self.assertEqual(faults_of_log(json.loads((self.folder / "a.sarif").read_text())), [])
        self.assertIn(",G-SU-HD,degree,pass,2,", (self.folder / "a.csv").read_text())

    def test_json_is_what_report_json_holds_without_pictures(self):
        self.check(GAP, "--json", "a.json")
        data = json.loads((self.folder / "a.json").read_text())
        self.assertEqual(data["format"], "keiko-inspection/1")
        self.assertNotIn("pictures", data)


if __name__ == "__main__":
    unittest.main()
