"""`keiko inspect`: verdict, exit code and report."""
import hashlib
import json
import pathlib
import re
import unittest

from keiko_process import ASLANT, SMALL, KeikoTest, surface

ONE_VIEW = ("--view", "high-front", "-q", *SMALL)


class Inspect(KeikoTest):
    def inspect(self, name: str, *arguments: str) -> tuple:
        """Exit code and report.json."""
        run = self.keiko("inspect", surface(name), "-o", "out", *ONE_VIEW, *arguments)
        self.assertEqual(run.stderr, "")
        self.assertIn("report.html", run.stdout)
        return run.returncode, json.loads((self.folder / "out/report.json").read_text())

    def test_a_gap_is_a_finding(self):
        code, report = self.inspect("seam-g0-gap.step")
        self.assertEqual((code, report["verdict"], len(report["findings"])), (1, "fail", 1))
        finding = report["findings"][0]
        self.assertEqual((finding["quantity"], finding["unit"]), ("gap", "mm"))
        self.assertAlmostEqual(finding["value"], 0.05, delta=1e-9)

    def test_a_jump_beyond_curvature_passes(self):
        code, report = self.inspect("seam-g2-only.step")
        self.assertEqual((code, report["verdict"], report["findings"]), (0, "pass", []))
        self.assertEqual(report["counts"]["pass"], 1)

    def test_lines_are_those_of_the_same_rig_and_count_for_the_verdict(self):
        report = self.inspect("seam-g1-angle.step", "--rig", self.write("aslant.toml", ASLANT))[1]
        lines = report["lines"]
        run = self.keiko("lines", surface("seam-g1-angle.step"), "--rig", "aslant.toml", "--view",
                         "high-front", "-o", "lines.json", "-q", *SMALL)
        self.assertEqual(run.returncode, 1)
        found = json.loads((self.folder / "lines.json").read_text())
        self.assertGreater(lines["counts"]["fail"], 0)
        for key in "rig", "look", "preset", "verdict", "counts", "crossings":
            self.assertEqual(lines[key], found[key])
        html = (self.folder / "out/report.html").read_text()
        self.assertIn(f'<b>{lines["counts"]["fail"]}</b>line crossings fail', html)

    def test_lines_alone_can_fail(self):
        limits = "[seam]\ngap = 1\nangle = 1\n[lines]\nturn = 0.1\n"
        mine = self.write("mine.toml", 'format = "keiko-preset/1"\nname = "mine"\n' + limits)
        code, report = self.inspect("seam-g1-angle.step", "--preset", mine, "--rig",
                                    self.write("aslant.toml", ASLANT))
        self.assertEqual((code, report["counts"]["fail"], report["verdict"]), (1, 0, "fail"))
        self.assertEqual(report["lines"]["verdict"], "fail")

    def test_a_rig_without_planes_has_no_lines(self):
        sun = 'format = "keiko-rig/1"\n[sun]\ndirection = [0, 0, -1]\nilluminance = 1000\n'
        code, report = self.inspect("seam-g2-only.step", "--rig", self.write("sun.toml", sun))
        self.assertEqual((code, report["lines"], report["line_pictures"]), (0, None, []))

    def test_the_preset_decides(self):
        self.assertEqual(self.inspect("seam-g1-angle.step")[0], 1)
        self.assertEqual(self.inspect("seam-g1-angle.step", "--preset", "engineering")[0], 0)

    def test_every_file_that_the_report_names_is_there(self):
        report = self.inspect("seam-g0-gap.step")[1]
        kinds = "standing_pictures", "pictures", "line_pictures", "curvature_pictures", "close_ups"
        for kind in kinds:
            self.assertGreaterEqual(len(report[kind]), 1, kind)
        names = [p["file"] for kind in kinds for p in report[kind]]
        for name in names:
            png = (self.folder / "out" / name).read_bytes()
            self.assertEqual(png[:4], b"\x89PNG", name)
        rest = {"high-front-marked.png", "rig.toml", "report.html", "report.json", "faults.json",
                ".keiko-results"}
        self.assertEqual({p.name for p in (self.folder / "out").iterdir()}, rest | set(names))

    def test_the_faults_are_those_of_the_triage_with_their_profiles(self):
        report = self.inspect("seam-g1-angle.step")[1]
        faults = json.loads((self.folder / "out/faults.json").read_text())
        self.assertEqual((faults["format"], faults["preset"]), ("keiko-faults/1", report["preset"]["name"]))
        for kind in "items", "hidden":
            common = [{key: fault[key] for key in item}
                      for fault, item in zip(faults[kind], report["triage"][kind], strict=True)]
            self.assertEqual(common, report["triage"][kind])
        first = faults["items"][0]
        self.assertEqual(first["message"], report["findings"][first["findings"][0] - 1]["message"])
        self.assertEqual(first["profile"]["seam"], first["seams"][0])

    def test_standing_pictures_are_of_the_views_of_the_faults(self):
        report = self.inspect("seam-g1-angle.step")[1]
        items = report["triage"]["items"]
        views = list(dict.fromkeys(item["view"] for item in items[:7]))[:3]
        self.assertEqual([p["title"] for p in report["standing_pictures"]], views)
        markers = [m["number"] for p in report["standing_pictures"] for m in p["markers"]]
        self.assertEqual(set(markers), set(range(1, len(items) + 1)))

    def test_close_ups_are_as_many_as_requested(self):
        def close_ups(*options):
            return self.inspect("shut-line.step", "--view", "top", *options)[1]["close_ups"]

        usual = close_ups()
        self.assertIn("seam", usual[0])
        self.assertEqual(len({(kind, one.get(kind)) for one in usual
                              for kind in ("seam", "face", "crossing") if kind in one}), len(usual))
        self.assertGreater(len(usual), 1)
        self.assertEqual([one["seam"] for one in close_ups("--close-ups", "1")], [usual[0]["seam"]])
        self.assertEqual(close_ups("--close-ups", "0"), [])

    def test_joints_are_in_the_report_where_requested(self):
        self.assertNotIn("joints", self.inspect("shut-line.step", "--view", "top")[1])
        report = self.inspect("shut-line.step", "--view", "top", "--joints")[1]
        self.assertEqual(len(report["joints"]), 1)
        self.assertIn("<h2>Joints</h2>", (self.folder / "out/report.html").read_text())

    def test_pictures_in_candela_are_written_with_the_layers_asked_for(self):
        self.inspect("seam-g0-gap.step", "--aov", "normal,depth")
        exr = (self.folder / "out/high-front.exr").read_bytes()
        self.assertEqual(exr[:4], b"\x76\x2f\x31\x01")
        header = exr[:2000]
        self.assertTrue(all(name in header for name in (b"normal.X", b"depth.Z")), header)
        self.assertFalse(any(name in header for name in (b"curvature.k1", b"face.id")), header)
        run = self.keiko("inspect", surface("seam-g0-gap.step"), "--aov", "hue", "-o", "none")
        self.assertEqual(run.returncode, 2)
        self.assertIn('no AOV is called "hue"', run.stderr)

    def test_results_of_an_earlier_run_are_withdrawn(self):
        self.inspect("seam-g0-gap.step", "--view", "top", "--sarif", "a.sarif")
        out = self.folder / "out"
        self.assertTrue((out / "top.png").exists())
        (out / "notes.txt").write_text("mine")
        (out / "high-front.png").write_bytes(b"drawn on by hand")
        run = self.keiko("inspect", surface("pole.step"), "-o", "out", "--preset", "none.toml", "-q",
                         "--sarif", "a.sarif")
        self.assertEqual(run.returncode, 2)
        self.assertEqual(self.content(), ["out", "out/high-front.png", "out/notes.txt"])
        self.inspect("pole.step")
        self.assertNotIn("out/top.png", self.content())
        self.assertEqual((out / "notes.txt").read_text(), "mine")

    def test_the_report_names_what_it_rests_on(self):
        def digest(path):
            return hashlib.sha256(pathlib.Path(path).read_bytes()).hexdigest()

        report = self.inspect("seam-g2-only.step")[1]
        model = surface("seam-g2-only.step")
        self.assertEqual(report["inputs"], [{"path": model, "sha256": digest(model)}])
        self.assertEqual([view["name"] for view in report["views"]], ["high-front"])
        rig = self.folder / "out/rig.toml"
        before = digest(rig)
        report = self.inspect("hood-scene.toml", "--rig", "out/rig.toml")[1]
        inputs = {pathlib.Path(entry["path"]).name: entry["sha256"] for entry in report["inputs"]}
        self.assertEqual(inputs, {"hood-scene.toml": digest(surface("hood-scene.toml")),
                                  "hood.step": digest(surface("hood.step")), "rig.toml": before})
        self.write("mine.toml", 'format = "keiko-preset/1"\nname = "mine"\n[seam]\ngap = 0.1\nangle = 0.2\n')
        self.write("ok.json", '{"format": "keiko-accepted/1", "accepted": []}')
        report = self.inspect("seam-g2-only.step", "--preset", "mine.toml", "--accepted", "ok.json")[1]
        self.assertEqual(sorted((entry["path"], entry["sha256"]) for entry in report["inputs"]),
                         sorted((str(path), digest(self.folder / path)) for path in (model, "mine.toml", "ok.json")))

    def test_an_earlier_rig_that_is_read_again_stays(self):
        self.inspect("seam-g2-only.step")
        rig = (self.folder / "out/rig.toml").read_bytes()
        self.inspect("seam-g2-only.step", "--rig", "out/rig.toml")
        run = self.keiko("inspect", "none.step", "-o", "out", "--rig", "out/rig.toml")
        self.assertEqual(run.returncode, 2)
        self.assertEqual(self.content(), ["out", "out/rig.toml"])
        self.assertIn(b"c_plane", rig)

    def test_a_manifest_of_another_withdraws_nothing_elsewhere(self):
        digest = hashlib.sha256(b"mine").hexdigest()
        (self.folder / "out").mkdir()
        self.write("mine.txt", "mine")
        (self.folder / "out/link").symlink_to("../mine.txt")
        self.write("out/.keiko-results", f"keiko-results/1\n{digest} ../mine.txt\n"
                   f"{digest} {self.folder}/mine.txt\n{digest} link\n")
        self.assertEqual(self.keiko("inspect", "none.step", "-o", "out").returncode, 2)
        self.assertEqual(self.content(), ["mine.txt", "out", "out/link"])

    def test_the_report_needs_no_other_file(self):
        self.inspect("seam-g0-gap.step")
        html = (self.folder / "out/report.html").read_text()
        targets = re.findall(r"""(?:src|href)\s*=\s*["']?([^"'\s>]+)""", html)
        self.assertTrue(any(t.startswith("data:image/png;base64,") for t in targets))
        for target in targets:
            self.assertRegex(target, r"\A(data:|#)")
        self.assertNotRegex(html, r"@import|url\((?!['\"]?(data:|#))")

    def test_two_runs_give_the_same_files(self):
        def files():
            self.inspect("seam-g1-only.step")
            return {p.name: p.read_bytes() for p in (self.folder / "out").iterdir()}
        self.assertEqual(files(), files())

    def test_the_report_is_the_same_for_any_thread_count_and_tells_no_time(self):
        def reports(threads: str):
            tracing = self.inspect("trimmed-hole.step", "--threads", threads)[1]["model"]["tracing"]
            self.assertEqual(set(tracing), {"sub_patches", "mixed_sub_patches", "trimmed_away_sub_patches",
                                            "bytes"})
            return [(self.folder / "out" / n).read_bytes() for n in ("report.json", "report.html")]
        self.assertEqual(reports("1"), reports("3"))

    def test_verbose_tells_how_hits_were_found(self):
        view = ("-o", "out", "--view", "high-front", *SMALL, "--verbose")
        run = self.keiko("inspect", surface("seam-g2-only.step"), *view)
        self.assertRegex(run.stderr, r"(?m)^keiko: picture of \d+ hits: [\d.]+ % unique")
        run = self.keiko("inspect", surface("seam-g2-only.step"), *view, "--intersector",
                         "clipping")
        self.assertRegex(run.stderr, r"(?m)^keiko: picture of \d+ hits: 0.00 % unique")
        self.assertEqual(run.returncode, 0)

    def test_its_rig_lights_a_render(self):
        self.inspect("seam-g2-only.step")
        self.succeed("render", surface("seam-g2-only.step"), "-o", "a.png", "--rig",
                     "out/rig.toml", *ONE_VIEW)


if __name__ == "__main__":
    unittest.main()
