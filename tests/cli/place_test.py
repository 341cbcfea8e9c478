"""`keiko place`: a rig, what it reaches, and the same told of a rig that is there."""
import json
import unittest

from keiko_process import SMALL, SOURCE, KeikoTest, surface

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

    def test_a_screen_and_a_panel_hang_where_tubes_would(self):
        rigs = {}
        for kind in ("tube", "screen", "panel"):
            self.succeed("place", HOOD, "--view", "high-front", "--lamp", kind, "-o", f"{kind}.toml", "--report", "out",
                         *QUICK)
            report = self.report()
            self.assertEqual(report["lamp"], kind)
            text = (self.folder / f"{kind}.toml").read_text()
            rows = sum(row["lamps"] for row in report["planes"])
            self.assertEqual(text.count("[[polygon]]"),
                             {"tube": 0, "screen": rows, "panel": len(report["planes"])}[kind])
            self.assertEqual("[[c_plane]]" in text, kind == "tube")
            rigs[kind] = report
        self.assertEqual(rigs["screen"]["coverage"], rigs["tube"]["coverage"])
        self.assertEqual(rigs["panel"]["planes"], rigs["tube"]["planes"])
        self.succeed("render", HOOD, "--view", "high-front", "--rig", "screen.toml", "-o", "bars.png", "-q", *SMALL)
        for kind in "screen", "panel":
            self.succeed("place", HOOD, "--view", "high-front", "--rate", f"{kind}.toml", "--report", "out", *QUICK)
            self.assertEqual(self.report()["lamp"], kind)
            self.assertAlmostEqual(self.report()["coverage"], rigs[kind]["coverage"], delta=1e-9)
        run = self.keiko("place", HOOD, "--rate", str(SOURCE / "lightrigs" / "one-globe.toml"), *QUICK)
        self.assertEqual(run.returncode, 2)
        self.assertIn("neither tubes on a C-plane nor rectangular panels", run.stderr)

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

    def test_the_best_row_need_not_be_the_first_of_the_best_rows(self):
        """Hung first, the best single row leaves no room for more than 48 % from these sides."""
        self.succeed("place", HOOD, "--view", "high-front", "--view", "top", "--view",
                     "high-three-quarter-rear", "-o", "rig.toml", "--report", "out", *QUICK)
        self.assertGreater(self.report()["coverage"], 0.65)

    def test_registered_hits_give_the_same_rig(self):
        """Whether a picture registered them or `place` looks itself; with the same choices."""
        self.succeed("render", HOOD, "-o", "hood.png", "--view", "high-front", "--register",
                     "hits.json", "-q", *SMALL)
        for choices in ((), ("--plane", "above", "--faces", "1", "--weigh-pixels")):
            self.succeed("place", HOOD, "--view", "high-front", "-o", "looked.toml", "--report",
                         "looked", *choices, "-q", *SMALL)
            self.succeed("place", HOOD, "--from", "hits.json", "-o", "read.toml", "--report",
                         "read", *choices, "-q")
            for name in ("placement.json", "plan.png", "histogram-1.png"):
                self.assertEqual((self.folder / "read" / name).read_bytes(),
                                 (self.folder / "looked" / name).read_bytes(), name)
            self.assertEqual((self.folder / "read.toml").read_bytes(),
                             (self.folder / "looked.toml").read_bytes())

    def test_an_inspection_registers_all_its_views(self):
        self.keiko("inspect", HOOD, "-o", "report", "--view", "front", "--view", "top",
                   "--register", "hits.json", "-q", *SMALL)
        hits = json.loads((self.folder / "hits.json").read_text())
        self.assertEqual([view["name"] for view in hits["views"]], ["front", "top"])
        self.assertEqual({hit[0] for hit in hits["hits"]}, {0, 1})
        self.succeed("place", HOOD, "--from", "hits.json", "-o", "rig.toml", "-q")

    def test_hits_of_another_body_and_damaged_ones_are_refused(self):
        self.succeed("render", HOOD, "-o", "hood.png", "--view", "front", "--register", "hits.json",
                     "-q", *SMALL)
        whole = (self.folder / "hits.json").read_text()
        (self.folder / "cut.json").write_text(whole[:len(whole) // 2])
        (self.folder / "short.json").write_text(whole.replace(",", "", 40)[:-20] + "]}")
        wrong = json.loads(whole)
        wrong["hits"][3][2] = 99999
        (self.folder / "wrong.json").write_text(json.dumps(wrong))
        for model, file, word in ((surface("dent.step"), "hits.json", "--from: the hits were registered on another body"),
                                  (HOOD, "cut.json", "cut.json"), (HOOD, "short.json", "short.json"),
                                  (HOOD, "wrong.json", "not there"), (HOOD, "none.json", "none.json")):
            run = self.keiko("place", model, "--from", file, "-o", "rig.toml", "-q")
            self.assertEqual(run.returncode, 2, file)
            self.assertEqual(len(run.stderr.splitlines()), 1, run.stderr)
            self.assertIn(word, run.stderr)
            self.assertNotIn("rig.toml", self.content())

    def test_hits_of_cameras_that_cannot_be_are_refused(self):
        self.succeed("render", HOOD, "-o", "hood.png", "--view", "front", "--register", "hits.json",
                     "-q", *SMALL)
        whole = json.loads((self.folder / "hits.json").read_text())
        weight = whole["columns"].index("solid_angle")

        def camera(**changes):
            def change(hits):
                hits["views"][0]["camera"].update(changes)
            return change

        def hit(column, value):
            def change(hits):
                hits["hits"][3][column] = value
            return change

        def no_hits(hits):
            hits["hits"] = []

        eye = whole["views"][0]["camera"]["eye"]
        for change, reason in ((camera(height=0), "views: the camera of 'front': width and height"),
                               (camera(width=-1), "width and height must be 1 or more"),
                               (camera(vertical_fov=0), "vertical_fov must be above 0"),
                               (camera(vertical_fov=-5), "vertical_fov must be above 0"),
                               (camera(target=eye), "target must differ from eye"),
                               (camera(up=[0, 0, 0]), "up must not be along"),
                               (camera(eye=["a", 0, 0]), "views: a member is missing or not of the right kind"),
                               (hit(weight, -1), "hits: one has no solid_angle above 0"),
                               (hit(weight, "x"), "hits: "), (no_hits, "hits: there is none")):
            damaged = json.loads(json.dumps(whole))
            change(damaged)
            (self.folder / "damaged.json").write_text(json.dumps(damaged))
            run = self.keiko("place", HOOD, "--from", "damaged.json", "-o", "rig.toml", "-q")
            self.assertEqual(run.returncode, 2, reason)
            self.assertEqual(len(run.stderr.splitlines()), 1, run.stderr)
            self.assertIn("damaged.json:", run.stderr)
            self.assertIn(reason, run.stderr)
            self.assertNotIn("json.exception", run.stderr)

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
