"""`keiko lines`: the curves of lamps on a body, as JSON and CSV."""
import csv
import json
import unittest

from keiko_process import SOURCE, KeikoTest, surface

HOLE = surface("trimmed-hole.step")
TUNNEL = str(SOURCE / "lightrigs" / "tunnel-12.toml")
SUN = """format = "keiko-rig/1"
name = "sun alone"
[sun]
direction = [0, 0, -1]
illuminance = 1000
"""


class Lines(KeikoTest):
    def lines(self, *arguments: str) -> dict:
        self.succeed("lines", HOLE, "--rig", TUNNEL, "-o", "lines.json", "-q", *arguments)
        return json.loads((self.folder / "lines.json").read_text())

    def test_each_look_gives_curves_with_points(self):
        for look in "reflection", "highlight", "isophote":
            found = self.lines("--view", "high-front", "--look", look)
            self.assertEqual((found["format"], found["look"]), ("keiko-lines/1", look))
            self.assertEqual(found["rig"], "tunnel-12")
            self.assertEqual([view["name"] for view in found["views"]], ["high-front"])
            self.assertTrue(found["lines"], look)
            for line in found["lines"]:
                self.assertGreaterEqual(len(line["points"]), 2)
                self.assertGreater(line["length"], 0)
                self.assertLess(line["lamp"], 6 if line["plane"] == 0 else 3)

    def test_csv_has_the_points_of_the_json(self):
        found = self.lines("--view", "high-front", "--view", "top", "--csv", "lines.csv")
        with open(self.folder / "lines.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        points = [(i, line["view"], p) for i, line in enumerate(found["lines"])
                  for p in line["points"]]
        self.assertEqual({view for _, view, _ in points}, {"high-front", "top"})
        self.assertEqual([(int(r["line"]), r["view"], [float(r[c]) for c in "xyz"]) for r in rows],
                         points)

    def test_same_bytes_for_any_number_of_threads(self):
        texts = []
        for threads in "1", "2":
            self.lines("--view", "high-front", "--threads", threads)
            texts.append((self.folder / "lines.json").read_bytes())
        self.assertEqual(*texts)

    def test_a_finer_chord_gives_more_points_and_less_deviation(self):
        coarse = self.lines("--view", "high-front", "--chord", "1")["lines"]
        fine = self.lines("--view", "high-front", "--chord", "0.0001")["lines"]
        count = [sum(len(line["points"]) for line in lines) for lines in (coarse, fine)]
        self.assertGreater(count[1], count[0])
        self.assertLessEqual(max(line["deviation"] for line in fine), 0.0001)

    def test_bad_input_is_one_line_and_leaves_nothing(self):
        rig = self.write("sun.toml", SUN)
        for arguments, reason in (
                (("-o", "l.json"), "keiko: --rig: lines need a rig, as the scene has none of its own"),
                (("-o", "l.json", "--rig", rig),
                 "keiko: rig 'sun alone': has no C-plane, so that there are no lines"),
                (("-o", "none/l.json", "--rig", TUNNEL), "keiko: none/l.json: there is no folder none")):
            run = self.keiko("lines", HOLE, "-q", *arguments)
            self.assertEqual((run.returncode, run.stdout, run.stderr), (2, "", reason + "\n"))
        self.assertEqual(self.content(), ["sun.toml"])


if __name__ == "__main__":
    unittest.main()
