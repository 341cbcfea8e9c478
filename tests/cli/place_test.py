"""`keiko place`: a rig, what it reaches, and the same told of a rig that is there."""
import json
import unittest

from keiko_process import SMALL, KeikoTest, surface

HOOD = surface("hood.step")
QUICK = ("-q", "--samples", "2000", *SMALL)


class Place(KeikoTest):
    def report(self) -> dict:
        return json.loads((self.folder / "out" / "placement.json").read_text())

    def test_report_and_rating_agree(self):
        self.succeed("place", HOOD, "--view", "high-front", "-o", "rig.toml", "--report", "out", *QUICK)
        self.assertEqual(sorted(p.name for p in (self.folder / "out").iterdir()),
                         ["histogram-1.png", "placement.json", "plan.png"])
        placed = self.report()
        self.assertEqual(placed["format"], "keiko-placement/1")
        self.assertEqual(placed["views"], ["high-front"])
        self.assertGreater(placed["coverage"], 0.8)
        self.succeed("place", HOOD, "--view", "high-front", "--rate", "rig.toml", "--report", "out",
                     *QUICK)
        self.assertAlmostEqual(self.report()["coverage"], placed["coverage"], delta=1e-9)
        self.assertEqual(self.report()["unreached"], placed["unreached"])

    def test_a_rig_for_each_view_on_a_given_plane(self):
        self.succeed("place", HOOD, "--view", "front", "--view", "top", "--each", "--plane", "above",
                     "-o", "rig.toml", *QUICK)
        self.assertEqual(self.content(), ["rig-front.toml", "rig-top.toml"])

    def test_only_the_faces_that_were_named_count(self):
        self.succeed("place", HOOD, "--view", "high-front", "--faces", "1", "-o", "rig.toml",
                     "--report", "out", *QUICK)
        self.assertEqual([face["id"] for face in self.report()["faces"]], [1])

    def test_verbose_tells_how_hits_were_found(self):
        run = self.keiko("place", HOOD, "--view", "high-front", "-o", "rig.toml", "--verbose",
                         *QUICK[1:])
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertRegex(run.stderr,
                         r"(?m)^keiko: looks of [1-9]\d* hits: [\d.]+ % unique, [\d.]+ % clipped, "
                         r"[\d.]+ % tangential$")

    def test_refusals_are_one_line(self):
        for arguments, word in ((("--faces", "door*"), "door*"), (("--stripes", "9:3"), "9:3"),
                                (("--plane", "below"), "below"), ((), "--output")):
            output = () if word == "--output" else ("-o", "rig.toml")
            run = self.keiko("place", HOOD, *output, *arguments, *QUICK)
            self.assertEqual(run.returncode, 2, arguments)
            self.assertEqual(len(run.stderr.splitlines()), 1, run.stderr)
            self.assertIn(word, run.stderr)
            self.assertEqual(self.content(), [])


if __name__ == "__main__":
    unittest.main()
