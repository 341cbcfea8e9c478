"""--shard of regress, check and inspect, and keiko merge: shares, resuming, what is refused."""
import json
import os
import resource
import signal
import subprocess
import unittest

from keiko_process import BINARY, SMALL, SOURCE, KeikoTest, surface
from regress_suite import RegressTest, move_point_of_dome
from step_text import StepText

REPORTS = ("parts.json", "index.html", "junit.xml")
MODELS = ("dome.bpt", "saddle.bpt", "seam-g0-gap.step")


def slurm_task(number: int, count: int) -> dict:
    """Environment of a task of an array from 1."""
    return {**os.environ, "SLURM_JOB_ID": "7", "SLURM_ARRAY_TASK_ID": str(number), "SLURM_ARRAY_TASK_MIN": "1",
            "SLURM_ARRAY_TASK_MAX": str(count), "SLURM_ARRAY_TASK_COUNT": str(count)}


def files_up_to(size: int) -> dict:
    """Options of a process whose files cannot grow beyond `size` bytes, like those on a disk that is full."""
    return {"preexec_fn": lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))}


class Regressions(RegressTest):
    def shard(self, number: int, count: int, *arguments: str, output: str = "out"):
        return self.regress("--shard", f"{number}/{count}", *arguments, output=output)

    def merge(self, *folders: str):
        return self.keiko("merge", "-q", *(folders or ("out",)))

    def refuses_to_merge(self, reason: str, *folders: str):
        run = self.merge(*folders)
        self.assertEqual((run.returncode, run.stdout, run.stderr.count("\n")), (2, "", 1))
        self.assertIn(reason, run.stderr)

    def test_merged_are_the_whole_run(self):
        for name in "a", "b", "c":
            self.add_fixture(name)
        self.accept("b")
        whole = self.regress(output="whole")
        for number in 1, 2:
            run = self.shard(number, 2)
            self.assertIn(f"see out/shard-{number}/index.html\n", run.stdout)
        for _ in "again", "and again":
            run = self.merge()
            self.assertEqual((run.returncode, run.stderr), (whole.returncode, ""))
            self.assertEqual(run.stdout.replace("out/", "whole/"), whole.stdout)
            self.assertEqual(self.reports("out"), self.reports("whole"))
        run = self.merge("out/shard-2", "out/shard-1", "-o", "joined")
        self.assertEqual((run.returncode, self.reports("joined")), (whole.returncode, self.reports("whole")))

    def test_the_most_expensive_fixture_has_a_shard_of_its_own(self):
        self.add_fixture("a")
        self.add_fixture("b")
        self.add_fixture("c")
        large = self.folder / "suite/b.toml"
        large.write_text(large.read_text().replace("[32, 18]", "[160, 90]"))
        self.shard(1, 2)
        self.shard(2, 2)
        shares = [[f["name"] for f in json.loads((self.folder / f"out/shard-{n}/regression.json").read_text())["fixtures"]]
                  for n in (1, 2)]
        self.assertEqual(shares, [["b"], ["a", "c"]])

    def test_auto_is_the_task_of_the_array(self):
        for name in "a", "b":
            self.add_fixture(name)
        whole = self.regress(output="whole")
        for number in 1, 2:
            run = self.keiko("regress", "-q", "suite", "-o", "out", "--shard", "auto", env=slurm_task(number, 2))
            self.assertEqual((run.returncode, run.stderr), (1, ""))
        self.assertEqual(self.merge().returncode, whole.returncode)
        self.assertEqual(self.reports("out"), self.reports("whole"))
        alone = {name: value for name, value in os.environ.items()
                 if not name.startswith(("SLURM_", "CI_NODE", "SGE_", "PBS_", "JOB_COMPLETION"))}
        run = self.keiko("regress", "suite", "-o", "new", "--shard", "auto", env=alone)
        self.assertEqual((run.returncode, run.stderr.count("\n")), (2, 1))
        self.assertIn('--shard: "auto": this is no task of an array', run.stderr)
        self.assertFalse((self.folder / "new").exists())

    def test_missing_shards_are_named_with_their_fixtures(self):
        for name in "a", "b", "c":
            self.add_fixture(name)
        self.shard(2, 3)
        self.refuses_to_merge("shards 1, 3 of 3 are missing, with a, c; run again as shard 1/3")
        for number in 1, 3:
            self.shard(number, 3)
        self.assertEqual(self.merge().returncode, 1)
        (self.folder / "out/shard-3/regression.json").unlink()
        self.refuses_to_merge("shard 3 of 3 is missing, with c")
        self.assertFalse((self.folder / "out/index.html").exists())
        self.refuses_to_merge("--output: is needed", "out/shard-1", "out/shard-2")

    def test_a_folder_is_that_of_one_run(self):
        models = [self.add_fixture(name) for name in ("a", "b")]
        self.shard(1, 2)
        before = self.content()
        for arguments, reason in (((1, 3), "it has 2 shards, here 3"),
                                  ((2, 2, "--only", "a"), '"b" is in it'),
                                  ((1, 2, "--unit", "m"), 'files or options of "a" were others')):
            run = self.shard(*arguments)
            self.assertEqual((run.returncode, run.stdout, run.stderr.count("\n")), (2, "", 1))
            self.assertIn(f"out/shards.json: is the plan of another run: {reason}", run.stderr)
        move_point_of_dome(models[1], 1)
        self.assertIn('files or options of "b" were others', self.shard(2, 2).stderr)
        self.assertEqual(self.content(), before)
        (self.folder / "out/shards.json").unlink()
        self.shard(2, 2)
        self.refuses_to_merge("out/shard-1: is a shard of another run: files, options, baselines or the program")
        self.shard(1, 2)
        self.assertEqual(self.merge().returncode, 1)

    def test_a_shard_of_another_version_is_refused_by_name(self):
        for name in "a", "b":
            self.add_fixture(name)
        for number in 1, 2:
            self.shard(number, 2)
        record = self.folder / "out/shard-2/regression.json"
        text = record.read_text()
        version = json.loads(text)["tool"]["version"]
        record.write_text(text.replace(f'"version": "{version}"', '"version": "0.0.9"'))
        self.refuses_to_merge("out/shard-2: is a shard of another run: it is of Keiko 0.0.9")
        plan = self.folder / "out/shards.json"
        plan.write_text(plan.read_text().replace(f'"version": "{version}"', '"version": "0.0.9"'))
        self.assertIn("is the plan of another run: it is of Keiko 0.0.9", self.shard(1, 2).stderr)

    def test_two_copies_of_a_task_do_not_meet(self):
        for name in "a", "b":
            self.add_fixture(name)
        self.regress(output="whole")
        command = [BINARY, "regress", "-q", "suite", "-o", "out", "--shard", "1/1"]
        copies = [subprocess.Popen(command, cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
                  for _ in range(3)]
        for copy in copies:
            _, errors = copy.communicate(timeout=60)
            self.assertEqual((copy.returncode, errors), (1, ""))
        self.assertEqual(self.merge().returncode, 1)
        self.assertEqual(self.reports("out"), self.reports("whole"))
        for name in "a", "b":
            self.assert_sound(self.folder / "out/shard-1" / name / "candidate")

    def test_a_shard_that_is_stopped_goes_on_where_it_was(self):
        self.add_fixture("a")
        slow = self.folder / "suite/b.toml"
        self.add_fixture("b")
        slow.write_text(slow.read_text().replace("[32, 18]", "[2400, 1350]"))
        process = subprocess.Popen([BINARY, "regress", "suite", "-o", "out", "--shard", "1/1", "--verbose"],
                                   cwd=self.folder, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        for line in process.stderr:
            if line == "keiko: 2/2 b: render\n":
                break
        process.send_signal(signal.SIGTERM)  # as the time limit of Slurm does
        output, errors = process.communicate(timeout=60)
        self.assertEqual((process.returncode, output), (130, ""), errors)
        self.refuses_to_merge("shard 1 of 1 is missing, with a, b")
        kept = (self.folder / "out/shard-1/a/candidate/manifest.json").stat().st_mtime_ns
        self.assertEqual(self.shard(1, 1).returncode, 1)
        self.assertEqual((self.folder / "out/shard-1/a/candidate/manifest.json").stat().st_mtime_ns, kept)
        self.assertEqual(self.merge().returncode, 1)

    def test_a_full_disk_loses_nothing(self):
        for name in "a", "b":
            self.add_fixture(name)
        self.regress(output="whole")
        command = ("regress", "-q", "suite", "-o", "out", "--shard", "1/1")
        run = self.keiko(*command, **files_up_to(1000))
        self.assertRegex(run.stderr, r"\Akeiko: out/shard-1/\S+: cannot write: File too large\n\Z")
        self.assertEqual((run.returncode, run.stdout), (2, ""))
        self.refuses_to_merge("shard 1 of 1 is missing, with a, b")
        self.assertEqual([name for name in self.content() if ".keiko-" in name], [])
        self.assertEqual(self.keiko(*command).returncode, 1)
        run = self.keiko("merge", "-q", "out", **files_up_to(1000))
        self.assertRegex(run.stderr, r"\Akeiko: out/\S+: cannot write: File too large\n\Z")
        self.assertEqual((run.returncode, run.stdout), (2, ""))
        written = {"regression.json", "junit.xml", "index.html"} & set(os.listdir(self.folder / "out"))
        self.assertEqual((written, [name for name in self.content() if ".keiko-" in name]), (set(), []))
        self.assertEqual(self.merge().returncode, 1)
        self.assertEqual(self.reports("out"), self.reports("whole"))

    def test_more_shards_than_fixtures_are_no_error(self):
        self.add_fixture("a")
        self.regress(output="whole")
        for number in 1, 2, 3:
            self.assertEqual(self.shard(number, 3).returncode, 1 if number == 1 else 0)
        self.merge()
        self.assertEqual(self.reports("out"), self.reports("whole"))

    def test_what_is_no_shard_is_refused(self):
        self.add_fixture("dome")
        for shard in "0/2", "3/2", "1", "1/2x", "":
            run = self.regress("--shard", shard)
            self.assertEqual((run.returncode, run.stdout), (2, ""), shard)
        self.refuses_to_merge("suite: holds no shard that is done", "suite")
        self.refuses_to_merge("no such file", "nowhere")
        self.add_fixture("shard-1")
        self.assertIn("shard-1.toml: is called as the folder of a shard", self.shard(1, 2).stderr)
        self.assertFalse((self.folder / "out").exists())


class Bodies(KeikoTest):
    def run_shard(self, number: int, count: int, *arguments: str, command: str = "check", output: str = "out"):
        return self.keiko(command, "-q", *map(surface, MODELS), "-o", output, "--shard", f"{number}/{count}", *arguments)

    def reports(self, folder: str) -> dict:
        """Bytes of the reports of a run and of its parts."""
        files = [*(self.folder / folder / name for name in REPORTS), *(self.folder / folder / "parts").rglob("*.*")]
        return {str(path.relative_to(self.folder / folder)): path.read_bytes() for path in files}

    def check_division(self, command: str, page: str, *arguments: str):
        """Runs all on one machine and in three shards, and compares every byte."""
        self.run_shard(1, 1, *arguments, command=command, output="whole")
        whole = self.keiko("merge", "-q", "whole")
        self.assertEqual(whole.returncode, 1, whole.stderr)
        (self.folder / "whole").rename(self.folder / "kept")
        for number in 3, 1, 2:
            self.run_shard(number, 3, *arguments, command=command, output="whole")
        for _ in "again", "and again":
            run = self.keiko("merge", "-q", "whole")
            self.assertEqual((run.returncode, run.stdout), (1, whole.stdout))
            self.assertEqual(self.reports("whole"), self.reports("kept"))
        for name in "dome", "saddle", "seam-g0-gap":
            self.assertTrue((self.folder / "whole/parts" / name / "results" / page).is_file())
        self.assertIn("fail seam-g0-gap: ", run.stdout)

    def test_checked_on_one_machine_and_in_shards_are_the_same(self):
        self.check_division("check", "inspection.json")

    def test_inspected_on_one_machine_and_in_shards_are_the_same(self):
        self.check_division("inspect", "report.html", "--view", "high-front", *SMALL)

    def test_a_part_is_judged_as_check_does_alone(self):
        self.run_shard(1, 1)
        self.keiko("check", "-q", surface("seam-g0-gap.step"), "-o", "alone.json", "--csv", "alone.csv")
        results = self.folder / "out/parts/seam-g0-gap/results"
        self.assertEqual((results / "inspection.json").read_bytes(), (self.folder / "alone.json").read_bytes())
        self.assertEqual((results / "findings.csv").read_bytes(), (self.folder / "alone.csv").read_bytes())

    def test_other_options_are_another_run(self):
        preset = self.write("mine.toml", (SOURCE / "lightrigs/presets/vda-4955.toml").read_text())
        self.assertEqual(self.run_shard(1, 2, "--preset", preset).stderr, "")
        for arguments in ((), ("--preset", "vda-4955"), ("--preset", preset, "--join", "0.4")):
            self.assertIn("out/shards.json: is the plan of another run: files or options of",
                          self.run_shard(2, 2, *arguments).stderr)
        self.assertEqual(self.run_shard(2, 2, "--preset", preset, "--threads", "1").stderr, "")
        (self.folder / preset).write_text((self.folder / preset).read_text() + "# changed\n")
        self.assertIn("is the plan of another run", self.run_shard(2, 2, "--preset", preset).stderr)
        run = self.run_shard(1, 2, command="inspect")
        self.assertIn("is the plan of another run: it is one of keiko check", run.stderr)

    def test_a_body_that_cannot_be_read_is_an_error_and_the_others_are_judged(self):
        self.write("broken.step", "no STEP")
        run = self.keiko("check", "-q", "broken.step", "nowhere.step", surface("dome.bpt"), "-o", "out", "--shard", "1/1")
        self.assertEqual(run.returncode, 2)
        lines = run.stdout.splitlines()
        self.assertRegex(lines[0], "^error broken: .*broken.step")
        self.assertRegex(lines[1], "^error nowhere: .*nowhere.step")
        self.assertRegex(lines[2], "^(pass|undecided|fail) dome")
        merged = self.keiko("merge", "-q", "out")
        self.assertEqual(merged.returncode, 2)
        self.assertEqual(merged.stdout.splitlines()[:3], lines[:3])

    def test_a_full_disk_loses_nothing(self):
        command = ("check", "-q", *map(surface, MODELS), "-o", "out", "--shard", "1/1")
        run = self.keiko(*command, **files_up_to(10_000))
        lines = run.stdout.splitlines()
        for name, line in zip(("dome", "saddle"), lines):
            self.assertEqual(line, f"error {name}: out/parts/{name}/results/inspection.json: cannot write: File too large")
        self.assertRegex(lines[2], "^fail seam-g0-gap: ")
        self.assertEqual((run.returncode, run.stderr), (2, ""))
        self.assertEqual([name for name in self.content() if ".keiko-" in name], [])
        kept = (self.folder / "out/parts/seam-g0-gap/results/inspection.json").stat().st_mtime_ns
        run = self.keiko(*command, **files_up_to(700))  # the parts that are missing, and the record of the shard
        self.assertEqual(run.stderr, "keiko: out/shard-1/parts.json: cannot write: File too large\n")
        self.assertEqual((run.returncode, run.stdout), (2, ""))
        self.assertEqual(self.keiko(*command).returncode, 1)
        self.assertEqual((self.folder / "out/parts/seam-g0-gap/results/inspection.json").stat().st_mtime_ns, kept)
        run = self.keiko("merge", "-q", "out", **files_up_to(3000))  # less than index.html
        self.assertEqual(run.stderr, "keiko: out/index.html: cannot write: File too large\n")
        self.assertEqual((run.returncode, run.stdout), (2, ""))
        self.assertEqual(sorted(os.listdir(self.folder / "out")), ["parts", "shard-1", "shards.json"])
        with open("/dev/full", "w") as full:
            run = subprocess.run([BINARY, "merge", "-q", "out"], cwd=self.folder, stdout=full, stderr=subprocess.PIPE,
                                 text=True)
        self.assertEqual((run.returncode, run.stderr),
                         (2, "keiko: standard output: cannot write: No space left on device\n"))
        run = self.keiko("merge", "-q", "out")
        self.assertEqual(run.returncode, 1)
        self.assertTrue(run.stdout.endswith("see out/index.html\n"))
        self.assertTrue((self.folder / "out/index.html").is_file())

    def test_warnings_name_the_body_that_they_are_of(self):
        step = StepText(surface("hood.step"))
        of = step.surface_of(step.faces()[1])
        step.entities[of] = "UN" + step.entities[of]
        step.write(self.folder / "torn.step")
        for command, *more in ("check",), ("inspect", "--view", "high-front", *SMALL):
            run = self.keiko(command, "-q", "torn.step", surface("dome.bpt"), "-o", command, "--shard", "1/1", *more)
            self.assertRegex(run.stderr, r"\A(keiko: warning: torn: .*\n)+\Z")
            self.assertRegex(run.stderr, r"torn: face \d+ is missing: ")

    def test_options_that_name_one_place_for_all_are_refused(self):
        for more in (("--json", "a.json"), ("--csv", "a.csv")):
            run = self.run_shard(1, 1, *more)
            self.assertEqual((run.returncode, run.stderr.count("\n")), (2, 1))
        run = self.keiko("check", surface("dome.bpt"), "--shard", "1/1")
        self.assertIn("--output: is the folder of the run with --shard", run.stderr)
        self.run_shard(1, 1)
        for more in (("-o", "elsewhere"), ("out/shard-1", "-o", "out")):
            run = self.keiko("merge", "-q", "out", *more)
            self.assertEqual((run.returncode, run.stdout), (2, ""))
            self.assertIn("--output: is not for a run of check or inspect", run.stderr)


if __name__ == "__main__":
    unittest.main()
