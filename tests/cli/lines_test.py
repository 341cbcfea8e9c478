"""`keiko lines`: the curves of lamps on a body and their crossings with seams, as JSON, CSV, PNG."""
import csv
import json
import math
import os
import re
import subprocess
import unittest

from keiko_process import ASLANT, BINARY, SOURCE, KeikoTest, surface

HOLE = surface("trimmed-hole.step")
TUNNEL = str(SOURCE / "lightrigs" / "tunnel-12.toml")
CAR_RIG = str(SOURCE / "lightrigs" / "car-12.toml")
SUN = """format = "keiko-rig/1"
name = "sun alone"
[sun]
direction = [0, 0, -1]
illuminance = 1000
"""
# Two of its edges are mirrored in the middle of a level face.
PANEL = """format = "keiko-rig/1"
name = "panel"
[[polygon]]
corners = [[1190, 0, 1000], [1190, 2000, 1000], [3190, 2000, 1000], [3190, 0, 1000]]
"""


class Lines(KeikoTest):
    def lines(self, *arguments: str) -> dict:
        self.succeed("lines", HOLE, "--rig", TUNNEL, "-o", "lines.json", "-q", *arguments)
        return json.loads((self.folder / "lines.json").read_text())

    def test_a_pipe_is_written_into_where_its_folder_takes_no_file(self):
        (self.folder / "locked").mkdir()
        pipe = self.folder / "locked" / "pipe.csv"
        os.mkfifo(pipe)
        pipe.parent.chmod(0o500)
        reader = subprocess.Popen(["cat", pipe], stdout=subprocess.PIPE, text=True)
        self.addCleanup(reader.communicate)
        self.addCleanup(reader.kill)  # first, or it waits for ever where nothing is written
        self.lines("--view", "high-front", "--csv", str(pipe))
        self.assertTrue(reader.stdout.read().startswith("view,line,"))
        self.assertTrue(pipe.is_fifo())

    def test_curves_go_out_as_step_and_iges_with_their_verdicts(self):
        found = self.lines("--view", "high-front", "--curves", "lines.step", "--curves", "lines.igs")
        step = (self.folder / "lines.step").read_text().replace("\n", "")
        places = [[float(x) for x in m.split(",")] for m in
                  re.findall(r"CARTESIAN_POINT\('',\(([^)]*)\)\)", step) if m.count(",") == 2]
        for number, line in enumerate(found["lines"]):
            self.assertIn(f"'reflection line {number}: ", step)
            for end in line["pieces"][0]["points"][0], line["pieces"][-1]["points"][-1]:
                self.assertLess(min(math.dist(place, end) for place in places), 1e-9)
        iges = (self.folder / "lines.igs").read_text().replace("\n", "")
        self.assertEqual(len(re.findall(r"PRODUCT\( *'", step)), len(found["lines"]))
        self.assertIn("B_SPLINE_CURVE_WITH_KNOTS", step)
        self.assertGreaterEqual(iges.count("     126 "), len(found["lines"]))

    def test_curves_have_the_same_bytes_in_each_run(self):
        for name in "step", "igs":
            runs = set()
            for number in range(4):  # of addresses that change, some agree by chance
                file = self.folder / f"{number}.{name}"
                self.succeed("lines", surface("rational-sphere.step"), "--rig", TUNNEL, "--contours",
                             "--curves", file.name, "-o", "lines.json", "-q")
                runs.add(file.read_bytes())
            self.assertEqual(len(runs), 1, name)

    def test_contours_of_the_views_go_out_among_the_curves(self):
        # A sphere of 100 mm: its contour is a circle on it, in one view of one octant after the other.
        run = self.keiko("lines", surface("rational-sphere.step"), "--rig", TUNNEL, "--view", "high-front",
                         "-o", "l.json", "--contours", "--curves", "c.step", "-q")
        self.assertEqual(run.stderr, "")
        step = (self.folder / "c.step").read_text().replace("\n", "")
        contours = re.findall(r"PRODUCT\( *'(contour: high-front, face [^']*, within [^']* mm)'", step)
        self.assertGreaterEqual(len(contours), 4)
        run = self.keiko("lines", HOLE, "--rig", TUNNEL, "-o", "m.json", "--contours", "-q")
        self.assertEqual((run.returncode, run.stdout), (2, ""))
        self.assertIn("--contours: needs a file of --curves", run.stderr)

    def test_curves_of_another_kind_are_refused_before_the_work(self):
        run = self.keiko("lines", HOLE, "--rig", TUNNEL, "-o", "l.json", "--curves", "l.obj", "-q")
        self.assertEqual((run.returncode, run.stdout), (2, ""))
        self.assertIn("--curves: 'l.obj' ends in none of .step, .stp, .iges, .igs and .vtp", run.stderr)
        self.assertEqual(self.content(), [])

    def test_looks_are_asked_for_by_name(self):
        for look in "foo", "1":
            run = self.keiko("lines", HOLE, "--rig", TUNNEL, "--look", look, "-o", "l.json", "-q")
            self.assertEqual((run.returncode, run.stdout), (2, ""))
            self.assertIn(f"--look: {look} not in {{reflection,highlight,isophote}}", run.stderr)

    def test_each_look_gives_curves_with_points(self):
        for look in "reflection", "highlight", "isophote":
            found = self.lines("--view", "high-front", "--look", look)
            self.assertEqual((found["format"], found["look"]), ("keiko-lines/2", look))
            self.assertEqual(found["rig"], "tunnel-12")
            self.assertEqual([view["name"] for view in found["views"]], ["high-front"])
            self.assertTrue(found["lines"], look)
            for line in found["lines"]:
                for piece in line["pieces"]:
                    self.assertGreaterEqual(len(piece["points"]), 2)
                self.assertGreater(line["length"], 0)
                self.assertAlmostEqual(line["length"], sum(p["length"] for p in line["pieces"]))
                self.assertLess(line["lamp"], 6 if line["plane"] == 0 else 3)

    def test_lamps_along_the_seams_judge_nothing_and_say_so(self):
        run = self.keiko("lines", surface("hood.step"), "--rig", TUNNEL, "-o", "lines.json", "-q")
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assertIn("no line crosses a seam: nothing is judged", run.stdout)

    def test_a_body_as_large_as_an_orbit_is_done_in_a_moment(self):
        def scaled(line: str) -> str:
            numbers = line.split("#")[0].split()
            return " ".join(f"{float(x) * 1e12!r}" for x in numbers) if len(numbers) == 3 else line
        with open(surface("saddle.bpt")) as saddle:
            self.write("huge.bpt", "\n".join(map(scaled, saddle.read().splitlines())) + "\n")
        keiko = subprocess.run([BINARY, "lines", "huge.bpt", "--rig", CAR_RIG, "--chord", "1e-6",
                                "-o", "lines.json", "-q"], cwd=self.folder, timeout=30)
        self.assertEqual(keiko.returncode, 0)

    def test_csv_has_the_points_of_the_json(self):
        found = self.lines("--view", "high-front", "--view", "top", "--csv", "lines.csv")
        with open(self.folder / "lines.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        points = [(i, k, line["view"], p) for i, line in enumerate(found["lines"])
                  for k, piece in enumerate(line["pieces"]) for p in piece["points"]]
        self.assertEqual({view for _, _, view, _ in points}, {"high-front", "top"})
        self.assertEqual([(int(r["line"]), int(r["piece"]), r["view"],
                           [float(r[c]) for c in "xyz"]) for r in rows], points)

    def test_inflections_have_places(self):
        self.succeed("lines", surface("hood.step"), "--rig", TUNNEL, "--view", "high-front", "-o", "lines.json",
                     "--inflections", "turns.csv", "-q")
        lines = json.loads((self.folder / "lines.json").read_text())["lines"]
        with open(self.folder / "turns.csv", newline="") as file:
            rows = [(int(r["line"]), float(r["along"]), [float(r[c]) for c in "xyz"])
                    for r in csv.DictReader(file)]
        self.assertEqual(rows, [(i, turn["along"], turn["place"]) for i, line in enumerate(lines)
                                for turn in line["inflections"]])
        self.assertTrue(rows)
        for line in lines:
            self.assertEqual(len(line["inflections"]), sum(s["inflections"] for s in line["shapes"]))
            along = [turn["along"] for turn in line["inflections"]]
            self.assertEqual(along, sorted(along))
            self.assertTrue(all(0 <= a <= line["length"] + 1e-9 for a in along))

    def test_same_bytes_for_any_number_of_threads(self):
        texts = []
        for threads in "1", "2":
            self.lines("--view", "high-front", "--threads", threads)
            texts.append((self.folder / "lines.json").read_bytes())
        self.assertEqual(*texts)

    def test_a_finer_chord_gives_more_points_and_less_deviation(self):
        def pieces(chord: str) -> list:
            lines = self.lines("--view", "high-front", "--chord", chord)["lines"]
            return [piece for line in lines for piece in line["pieces"]]
        coarse, fine = pieces("1"), pieces("0.0001")
        count = [sum(len(piece["points"]) for piece in some) for some in (coarse, fine)]
        self.assertGreater(count[1], count[0])
        self.assertLessEqual(max(piece["deviation"] for piece in fine), 0.0001)

    def seam(self, name: str, expected: int, *arguments: str) -> dict:
        rig = self.write("aslant.toml", ASLANT)
        run = self.keiko("lines", surface(f"seam-{name}.step"), "--rig", rig, "--view", "high-front",
                         "-o", "seam.json", "-q", *arguments)
        self.assertEqual((run.returncode, run.stderr), (expected, ""))
        self.printed = run.stdout
        return json.loads((self.folder / "seam.json").read_text())

    def test_a_broken_seam_fails_and_a_smooth_one_passes(self):
        for name, expected, verdict in ("g1-angle", 1, "fail"), ("g2-only", 0, "pass"):
            found = self.seam(name, expected)
            self.assertEqual(found["verdict"], verdict)
            continued = [c for c in found["crossings"] if c["continued"]]
            self.assertGreater(len(continued), 5)
            self.assertEqual(found["counts"][verdict], len(
                [c for c in found["crossings"] if c["verdict"] == verdict]))
            for crossing in continued:
                line = found["lines"][crossing["line"]]
                self.assertEqual((line["plane"], line["lamp"]), (crossing["plane"], crossing["lamp"]))
                self.assertRegex(crossing["faces"], r"face 1 \(left\).* \| face 2 \(right\)")
                self.assertLess(abs(crossing["place"][0]), 1e-6)
            severity = [c["severity"] for c in found["crossings"] if c["verdict"]]
            self.assertEqual(severity, sorted(severity, reverse=True))
            self.assertTrue(self.printed.splitlines()[-1].startswith(f"{verdict}: "))

    def test_the_preset_decides(self):
        self.assertEqual(self.seam("g1-angle", 0, "--preset", "engineering")["preset"]["turn"], 0.5)
        limits = "[seam]\ngap = 1\nangle = 1\n[lines]\njump = 0.01\n"
        mine = self.write("mine.toml", 'format = "keiko-preset/1"\nname = "mine"\n' + limits)
        found = self.seam("g1-angle", 1, "--preset", mine)
        worst = found["crossings"][0]
        self.assertEqual((worst["jump"]["limit"], worst["jump"]["verdict"]), (0.01, "fail"))
        self.assertIsNone(worst["turn"]["limit"])

    def test_crossings_and_picture_are_written_beside(self):
        found = self.seam("g1-angle", 1, "--crossings", "c.csv", "--picture", "p.png", "--rows", "3",
                          "--size", "320x180")
        with open(self.folder / "c.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([(int(r["line"]), r["faces"], float(r["plane_jump"])) for r in rows],
                         [(c["line"], c["faces"], c["plane_jump"]) for c in found["crossings"]])
        self.assertEqual((self.folder / "p.png").read_bytes()[:8], b"\x89PNG\r\n\x1a\n")
        table = self.printed.splitlines()
        self.assertTrue(table[0].startswith("  #  verdict "))
        self.assertEqual(len(table), 1 + 3 + 1 + 1)

    def test_edges_of_panels_have_lines(self):
        rig = self.write("panel.toml", PANEL)
        self.succeed("lines", HOLE, "--rig", rig, "--view", "high-front", "-o", "l.json", "-q")
        found = json.loads((self.folder / "l.json").read_text())
        self.assertEqual([plane["kind"] for plane in found["planes"]], ["edges"] * 4)
        corners = [plane["lamps"][0][0] for plane in found["planes"]]
        for plane, after in zip(found["planes"], corners[1:] + corners[:1]):
            (edge,) = plane["lamps"]
            self.assertLess(math.dist(edge[1], after), 1e-9)
        self.assertTrue(found["lines"])
        run = self.keiko("lines", HOLE, "--rig", rig, "--look", "isophote", "-o", "m.json", "-q")
        self.assertEqual((run.returncode, run.stderr), (
            2, "keiko: rig 'panel': has no C-plane, so that there are no isophotes\n"))

    def test_bad_input_is_one_line_and_leaves_nothing(self):
        rig = self.write("sun.toml", SUN)
        for arguments, reason in (
                (("-o", "l.json"), "keiko: --rig: lines need a rig, as the scene has none of its own"),
                (("-o", "l.json", "--rig", rig),
                 "keiko: rig 'sun alone': has neither a C-plane nor a panel, so that there are no lines"),
                (("-o", "l.json", "--rig", TUNNEL, "--picture", "p.jpg"),
                 "keiko: p.jpg: --picture makes a .png"),
                (("-o", "none/l.json", "--rig", TUNNEL), "keiko: none/l.json: there is no folder none")):
            run = self.keiko("lines", HOLE, "-q", *arguments)
            self.assertEqual((run.returncode, run.stdout, run.stderr), (2, "", reason + "\n"))
        self.assertEqual(self.content(), ["sun.toml"])


if __name__ == "__main__":
    unittest.main()
