"""keiko regress: baselines, what is caught, resuming."""
import fcntl
import json
import os
import shutil
import signal
import subprocess
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from keiko_process import BINARY
from regress_suite import RegressTest, move_point_of_dome


class Baselines(RegressTest):
    def test_a_missing_baseline_fails_and_leaves_the_candidate(self):
        self.add_fixture("dome")
        run = self.regress()
        self.assertEqual((run.returncode, run.stderr), (1, ""), run.stdout)
        self.assertTrue(run.stdout.startswith("missing dome\n"), run.stdout)
        self.assertIn("accept them with keiko regress --update NAME\n", run.stdout)
        self.assert_sound(self.folder / "out" / "dome" / "candidate")
        self.assertTrue((self.folder / "out/dome/pictures/high-front-after.png").is_file())
        self.assertFalse((self.folder / "suite/baselines").exists())

    def test_what_was_accepted_is_the_same_and_the_manifest_tells_who_accepted_it(self):
        model = self.add_fixture("dome")
        self.accept("dome")
        baseline = self.folder / "suite/baselines/dome"
        self.assert_sound(baseline)
        run = self.regress()
        self.assertEqual((run.returncode, run.stdout.splitlines()[0]), (0, "same dome"))

        move_point_of_dome(model, 0.01)
        run = self.regress("--update", "dome", "--by", "someone else", "--reason", "a bulge")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assert_sound(baseline)
        changes = json.loads((baseline / "manifest.json").read_text())["changes"]
        self.assertEqual([(c["by"], c["reason"]) for c in changes],
                         [("tester", "first"), ("someone else", "a bulge")])
        self.assertIn("centre z", " ".join(changes[1]["changed"]))
        self.assertEqual(self.regress().returncode, 0)

    def test_accepting_what_is_there_changes_nothing(self):
        self.add_fixture("dome")
        self.accept("dome")
        manifest = self.folder / "suite/baselines/dome/manifest.json"
        before = manifest.read_bytes()
        run = self.regress("--update", "dome")
        self.assertEqual((run.returncode, run.stdout), (0, "unchanged dome\n"))
        self.assertEqual(manifest.read_bytes(), before)

    def test_only_fixtures_by_name_are_accepted(self):
        self.add_fixture("dome")
        for name in "all", "dom*", "dome2":
            run = self.regress("--update", name)
            self.assertEqual((run.returncode, run.stdout), (2, ""))
            self.assertIn(f"no fixture is called '{name}'", run.stderr)
        self.assertFalse((self.folder / "suite/baselines").exists())

    def test_a_damaged_baseline_is_an_error_and_can_be_replaced(self):
        self.add_fixture("dome")
        self.accept("dome")
        picture = self.folder / "suite/baselines/dome/high-front.depth.exr"
        picture.write_bytes(picture.read_bytes()[:-7])
        run = self.regress()
        self.assertEqual(run.returncode, 2, run.stdout)
        self.assertIn("high-front.depth.exr", run.stdout)
        self.assertIn("damaged or edited", run.stdout)
        self.accept("dome")
        self.assertEqual(self.regress().returncode, 0)
        changes = json.loads((self.folder / "suite/baselines/dome/manifest.json").read_text())["changes"]
        self.assertEqual(len(changes), 2)  # the first one is still known
        self.assertIn("replaces a baseline that was damaged", changes[1]["changed"][0])

    def test_a_baseline_without_a_fixture_fails(self):
        self.add_fixture("dome")
        self.accept("dome")
        (self.folder / "suite/baselines/dome").rename(self.folder / "suite/baselines/gone")
        self.assertEqual(self.regress().returncode, 1)
        self.add_fixture("gone")
        self.accept("dome")
        self.assertEqual(self.regress().returncode, 0)
        (self.folder / "suite/gone.toml").unlink()
        run = self.regress()
        self.assertEqual(run.returncode, 1)
        self.assertIn("stale baseline gone: no fixture has this name\n", run.stdout)
        suites = ElementTree.parse(self.folder / "out/junit.xml").getroot()
        self.assertEqual((suites.get("failures"), suites.get("errors")), ("1", "0"))
        self.assertIn("gone", (self.folder / "out/index.html").read_text())
        self.add_fixture("saddle")
        run = self.keiko("regress", "suite", "-o", "out", "--only", "saddle", "-q")
        self.assertIn("stale baseline gone: ", run.stdout)
        self.assertNotIn("stale baseline dome", run.stdout)

    def test_baselines_are_not_read_while_another_writes_them(self):
        self.add_fixture("dome")
        self.accept("dome")
        held = os.open(self.folder / "suite/baselines", os.O_RDONLY)
        fcntl.flock(held, fcntl.LOCK_EX)
        process = subprocess.Popen([BINARY, "regress", "-q", "suite", "-o", "out"], cwd=self.folder,
                                   stdout=subprocess.PIPE, text=True)
        with self.assertRaises(subprocess.TimeoutExpired):
            process.communicate(timeout=3)
        os.close(held)
        output, _ = process.communicate(timeout=60)
        self.assertEqual((process.returncode, output.splitlines()[0]), (0, "same dome"))

    def test_hidden_files_are_no_fixtures_and_names_of_reports_are_refused(self):
        model = self.add_fixture("dome")
        (self.folder / "suite/.#dome.toml").write_text("half a line of an edi")
        self.assertEqual(self.regress().stdout.splitlines()[0], "missing dome")
        (self.folder / "suite/regression.json.toml").write_text(
            (self.folder / "suite/dome.toml").read_text())
        run = self.regress(output="other")
        self.assertEqual((run.returncode, run.stdout), (2, ""))
        self.assertIn("regression.json.toml: is called as a file that keiko regress writes", run.stderr)
        self.assertTrue(model.exists())


class OutputFolders(RegressTest):
    def refuses(self, output: str, reason: str, *arguments: str):
        before = self.content()
        run = self.regress(*arguments, output=output)
        self.assertEqual((run.returncode, run.stdout), (2, ""))
        self.assertIn(reason, run.stderr)
        self.assertEqual(run.stderr.count("\n"), 1)
        self.assertEqual(self.content(), before)

    def test_reports_do_not_go_into_the_baselines(self):
        self.add_fixture("a")
        self.accept("a")
        (self.folder / "link").symlink_to("suite/baselines")
        for output in "suite/baselines", "link", "link/deep", "suite/../suite/baselines/a":
            for more in (), ("--update", "a"):
                self.refuses(output, "is in the folder of the baselines", *more)
        self.refuses("kept/out", "is in the folder of the baselines", "--baseline", "kept")

    def test_a_fixture_has_no_folder_in_the_baselines(self):
        self.add_fixture("baselines")
        self.add_fixture("kept")
        self.refuses("suite", "would hold the reports of fixture 'baselines'")
        self.refuses("out", "would hold the reports of fixture 'kept'", "--baseline",
                     "out/kept/deep")

    def test_a_merge_that_fails_leaves_no_reports_of_an_earlier_one(self):
        self.add_fixture("a")
        self.regress("--shard", "1/1")
        self.assertEqual(self.keiko("merge", "-q", "out", "-o", "joined").returncode, 1)
        self.assertEqual(self.keiko("merge", "-q", "nowhere", "-o", "joined").returncode, 2)
        self.assertEqual([p.name for p in (self.folder / "joined").glob("*.*")], [])


class Differences(RegressTest):
    def test_ten_micrometres_of_a_control_point_are_caught(self):
        model = self.add_fixture("dome")
        self.accept("dome")
        move_point_of_dome(model, 0.01)
        run = self.regress()
        self.assertEqual((run.returncode, run.stderr), (1, ""))
        self.assertTrue(run.stdout.startswith("different dome: "), run.stdout)
        suites = ElementTree.parse(self.folder / "out/junit.xml").getroot()
        failed = [case.get("name") for case in suites.iter("testcase") if case.find("failure") is not None]
        self.assertIn("shape", failed)
        self.assertEqual(int(suites.get("failures")), len(failed))

    def test_a_part_that_grew_is_seen_from_the_same_place_under_the_same_lamps(self):
        model = self.add_fixture("dome")
        fixture = self.folder / "suite/dome.toml"
        fixture.write_text(fixture.read_text().replace('rig = "rig.toml"\n', ""))
        self.accept("dome")
        move_point_of_dome(model, 200)
        self.assertEqual(self.regress().returncode, 1)
        kept, seen = (json.loads((self.folder / record / "metrics.json").read_text())
                      for record in ("suite/baselines/dome", "out/dome/candidate"))
        self.assertEqual(kept["eyes"], seen["eyes"])
        self.assertNotEqual(kept["metrics"], seen["metrics"])
        self.regress("--baseline", "none", output="alone")
        rigs = [(self.folder / record / "rig.toml").read_text()
                for record in ("suite/baselines/dome", "out/dome/candidate", "alone/dome/candidate")]
        self.assertEqual(rigs[0], rigs[1])
        self.assertNotEqual(rigs[0], rigs[2])
        alone = json.loads((self.folder / "alone/dome/candidate/metrics.json").read_text())
        self.assertNotEqual(alone["eyes"], seen["eyes"])

    def test_a_picture_that_differs_is_shown_before_after_and_as_difference(self):
        self.add_fixture("dome")
        self.accept("dome")
        rig = self.folder / "suite/rig.toml"
        rig.write_text(rig.read_text().replace("diameter = 26", "diameter = 30"))
        run = self.regress()
        self.assertEqual(run.returncode, 1, run.stdout)
        page = (self.folder / "out/index.html").read_text()
        self.assertEqual(page.count("data:image/png;base64,"), 3)
        self.assertNotIn("http", page)
        outcome = json.loads((self.folder / "out/regression.json").read_text())["fixtures"][0]
        layers = {layer["layer"]: layer["within"] for layer in outcome["pictures"][0]["layers"]}
        self.assertEqual(layers, {"color": False, "depth": True, "normal": True})
        self.assertIn("; high-front: color\n", run.stdout)

    def test_tolerances_of_the_fixture_are_those_it_is_held_to(self):
        model = self.add_fixture("dome", more='checks = ["shape"]\n[tolerance]\nplace = 0.1\n'
                                              "area = 10\ndirection = 1\nlength = 1\n")
        self.accept("dome")
        move_point_of_dome(model, 0.01)
        self.assertEqual(self.regress().returncode, 0)

    def test_junit_tells_only_of_what_was_asked_for(self):
        self.add_fixture("dome", more='checks = ["shape"]\n')
        self.accept("dome")
        self.assertEqual(self.regress().returncode, 0)
        suites = ElementTree.parse(self.folder / "out/junit.xml").getroot()
        self.assertEqual([case.get("name") for case in suites.iter("testcase")], ["shape"])

    def test_a_fixture_that_cannot_be_read_is_an_error_and_the_others_run(self):
        self.add_fixture("dome")
        self.add_fixture("broken")
        self.accept("dome")
        (self.folder / "suite/broken.bpt").write_text("1\n3 3\n0 0 zero\n")
        run = self.regress()
        self.assertEqual((run.returncode, run.stderr), (2, ""))
        self.assertRegex(run.stdout, r"^error broken: .*broken\.bpt:3")
        self.assertIn("\nsame dome\n", run.stdout)

    def test_what_is_wrong_with_one_fixture_is_told_with_its_line_and_the_others_run(self):
        self.add_fixture("dome", more="vews = []\n")
        self.add_fixture("saddle", "saddle.bpt")
        self.accept("saddle")
        (self.folder / "suite/lost.toml").write_text('format = "keiko-fixture/1"\nmodel = "nowhere.step"\n')
        (self.folder / "suite/other.toml").write_text("answer = 42\n")
        run = self.regress()
        self.assertEqual((run.returncode, run.stderr), (2, ""))
        dome, lost, other, saddle, _ = run.stdout.splitlines()
        self.assertIn("dome.toml:7:1: unknown key 'vews' (did you mean 'views'?)", dome)
        self.assertIn("nowhere.step", lost)
        self.assertIn('must begin with format = "keiko-fixture/1"', other)
        self.assertEqual(saddle, "same saddle")
        suites = ElementTree.parse(self.folder / "out/junit.xml").getroot()
        self.assertEqual(suites.get("errors"), "3")

    def test_a_suite_that_cannot_be_read_leaves_no_reports_of_an_earlier_run(self):
        self.add_fixture("dome")
        self.accept("dome")
        self.assertEqual(self.regress().returncode, 0)
        (self.folder / "suite/junit.xml.toml").write_text("")
        run = self.regress()
        self.assertEqual((run.returncode, run.stdout), (2, ""))
        for report in "junit.xml", "index.html", "regression.json":
            self.assertFalse((self.folder / "out" / report).exists())

    def test_a_fixture_that_is_not_there_leaves_no_reports_of_an_earlier_run(self):
        self.add_fixture("dome")
        self.accept("dome")
        self.assertEqual(self.regress().returncode, 0)
        self.assertEqual(self.regress("--only", "saddle").returncode, 2)
        for report in "junit.xml", "index.html", "regression.json":
            self.assertFalse((self.folder / "out" / report).exists())

    def test_bytes_do_not_depend_on_threads(self):
        self.add_fixture("dome")
        self.add_fixture("gap", "seam-g0-gap.step")
        for threads in "1", "2":
            self.regress("--threads", threads, output=threads)
        self.assertEqual(self.reports("1"), self.reports("2"))
        for name in "dome", "gap":
            for file in (self.folder / "1" / name / "candidate").iterdir():
                self.assertEqual(file.read_bytes(), (self.folder / "2" / name / "candidate" / file.name).read_bytes())


class Runs(RegressTest):
    def candidate(self, name: str) -> int:
        return (self.folder / "out" / name / "candidate/manifest.json").stat().st_mtime_ns

    def test_what_is_finished_is_not_run_again_unless_its_inputs_change(self):
        model = self.add_fixture("dome")
        self.add_fixture("saddle", "saddle.bpt")
        self.regress()
        first = self.candidate("dome"), self.candidate("saddle")
        self.regress()
        self.assertEqual((self.candidate("dome"), self.candidate("saddle")), first)
        move_point_of_dome(model, 1)
        self.regress()
        self.assertNotEqual(self.candidate("dome"), first[0])
        self.assertEqual(self.candidate("saddle"), first[1])
        self.regress("--fresh")
        self.assertNotEqual(self.candidate("saddle"), first[1])

    def test_what_one_build_has_finished_is_finished_wherever_its_program_lies(self):
        self.add_fixture("dome")
        self.regress()
        first = self.candidate("dome")
        moved = self.folder / "moved"
        shutil.copy(BINARY, moved)
        with moved.open("ab") as program:
            program.write(b"signed")  # behind all that is ever loaded
        worker = os.environ.get("KEIKO_IMPORT", str(Path(BINARY).parent / "keiko-import"))
        subprocess.run([moved, "regress", "-q", "suite", "-o", "out"], cwd=self.folder, capture_output=True,
                       env={**os.environ, "KEIKO_IMPORT": worker}, timeout=self.patience)
        self.assertEqual(self.candidate("dome"), first)

    def test_a_damaged_candidate_is_made_again(self):
        self.add_fixture("dome")
        self.accept("dome")
        (self.folder / "out/dome/candidate/metrics.json").write_text("{")
        self.assertEqual(self.regress().returncode, 0)
        self.assert_sound(self.folder / "out/dome/candidate")

    def test_two_runs_do_not_share_an_output_folder(self):
        self.add_fixture("dome")
        (self.folder / "out").mkdir()
        held = os.open(self.folder / "out", os.O_RDONLY)
        fcntl.flock(held, fcntl.LOCK_EX)
        run = self.regress()
        os.close(held)
        self.assertEqual((run.returncode, run.stdout), (2, ""))
        self.assertIn("another process is writing", run.stderr)

    def test_ctrl_c_leaves_no_report_and_the_next_run_goes_on(self):
        self.add_fixture("a")
        self.add_fixture("b", more='preset = "vda-4955"\n')
        self.regress()
        (self.folder / "suite/b.toml").write_text(
            (self.folder / "suite/b.toml").read_text().replace("[32, 18]", "[2400, 1350]"))
        kept = self.candidate("a")
        process = subprocess.Popen([BINARY, "regress", "suite", "-o", "out", "--verbose"], cwd=self.folder, text=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        for line in process.stderr:
            if line == "keiko: 2/2 b: render\n":
                break
        process.send_signal(signal.SIGINT)
        output, errors = process.communicate(timeout=60)
        self.assertEqual((process.returncode, output), (130, ""), errors)
        self.assertEqual([p.name for p in (self.folder / "out").iterdir() if p.is_file()], [])
        (self.folder / "suite/b.toml").write_text(
            (self.folder / "suite/b.toml").read_text().replace("[2400, 1350]", "[32, 18]"))
        self.assertEqual(self.regress().returncode, 1)
        self.assertEqual(self.candidate("a"), kept)


if __name__ == "__main__":
    unittest.main()
