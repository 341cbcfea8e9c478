"""Arrays of shards on a Slurm cluster of three nodes. Exits with 77 where none can be started.

Where CI is set, missing packages are a failure.
"""
import os
import sys
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path += [str(HERE.parent / "cli")]
import slurm_cluster
from keiko_process import BINARY, SOURCE
from regress_suite import RegressTest

SKIPPED = 77
SCRIPT = str(SOURCE / "src/cmake/slurm/keiko-array.sbatch")
# Tells that a task has begun, and lets it go on once the test opens the gate.
GATED_KEIKO = """#!/bin/sh
if [ -n "$SLURM_ARRAY_TASK_ID" ]; then
  : >"{folder}/begun-$SLURM_ARRAY_TASK_ID-${{SLURM_RESTART_COUNT:-0}}"
  until [ -e "{folder}/gate" ]; do sleep 0.1; done
fi
exec "{binary}" "$@"
"""


class Arrays(RegressTest):
    @classmethod
    def setUpClass(cls):
        cls.cluster = slurm_cluster.Cluster(3)
        cls.addClassCleanup(cls.cluster.close)

    def setUp(self):
        super().setUp()
        for name, model in (("dome", "dome.bpt"), ("saddle", "saddle.bpt")):
            self.add_fixture(name, model)
        self.accept("dome")  # the other one has no baseline: findings, exit code 1
        self.assertEqual(self.regress(output="whole").returncode, 1)
        program = self.folder / "bin/keiko"
        program.parent.mkdir()
        program.write_text(GATED_KEIKO.format(folder=self.folder, binary=BINARY))
        program.chmod(0o755)
        self.cluster.environment["PATH"] = f"{program.parent}:{os.environ['PATH']}"

    def submit(self, tasks: str, *arguments: str) -> str:
        return self.cluster.run("sbatch", "--parsable", f"--array={tasks}", SCRIPT, *arguments, cwd=self.folder).strip()

    def submit_merge(self, after: str) -> str:
        return self.cluster.run("sbatch", "--parsable", f"--dependency=afterany:{after}", "-o", "merge.log",
                                "--wrap", "keiko merge out", cwd=self.folder).strip()

    def wait_for_tasks(self, *tasks: str):
        """Until tasks have begun, each "INDEX-RESTARTS"."""
        for task in tasks:
            self.cluster.wait_for((self.folder / f"begun-{task}").exists, f"task {task}")

    def open_gate(self):
        (self.folder / "gate").touch()

    def jobs(self, job: str) -> dict:
        """Fields of the tasks of a job by their index, of a job without tasks by ""."""
        lines = self.cluster.run("scontrol", "show", "job", "-o", job).splitlines()
        fields = [dict(word.partition("=")[::2] for word in line.split()) for line in lines]
        return {task.get("ArrayTaskId", ""): task for task in fields}

    def end_of(self, job: str) -> dict:
        """Its fields once it has ended, and with it all on which it depends."""
        def ended():
            return self.jobs(job)[""]["JobState"] in ("COMPLETED", "FAILED", "CANCELLED")
        self.cluster.wait_for(ended, f"job {job}", 90)
        return self.jobs(job)[""]

    def log_of(self, job: str) -> str:
        return "".join(path.read_text() for path in sorted(self.folder.glob(f"keiko-{job}_*.log")))

    def test_a_node_that_is_lost_loses_nothing(self):
        array = self.submit("1-2", "regress", "suite", "-o", "out")
        merge = self.submit_merge(array)
        self.wait_for_tasks("1-0", "2-0")
        self.assertEqual({task["JobState"] for task in self.jobs(array).values()}, {"RUNNING"})
        lost = self.jobs(array)["2"]["NodeList"]
        self.cluster.kill_node(lost)
        self.open_gate()
        end = self.end_of(merge)
        tasks = self.jobs(array)
        self.assertEqual([tasks[index]["Restarts"] for index in "12"], ["0", "1"])
        self.assertNotEqual(tasks["2"]["NodeList"], lost)
        # Slurm states any exit code but 0 as a failure, findings too.
        self.assertEqual(sorted((tasks[index]["JobState"], tasks[index]["ExitCode"]) for index in "12"),
                         [("COMPLETED", "0:0"), ("FAILED", "1:0")], self.log_of(array))
        self.assertEqual(end["ExitCode"], "1:0", (self.folder / "merge.log").read_text())
        self.assertEqual(self.reports("out"), self.reports("whole"))
        self.cluster.start_node(lost)
        self.cluster.wait_for_nodes()

    def test_a_task_that_is_cancelled_is_named_and_can_be_run_again(self):
        array = self.submit("1-2", "regress", "suite", "-o", "out")
        merge = self.submit_merge(array)
        self.wait_for_tasks("1-0", "2-0")
        self.cluster.run("scancel", f"{array}_2")
        self.open_gate()
        self.assertEqual(self.end_of(merge)["ExitCode"], "2:0")
        self.assertIn("keiko: shard 2 of 2 is missing, with ", (self.folder / "merge.log").read_text())
        self.assertFalse((self.folder / "out/index.html").exists())
        merge = self.submit_merge(self.submit("2", "regress", "suite", "-o", "out", "--shard", "auto/2"))
        self.assertEqual(self.end_of(merge)["ExitCode"], "1:0", (self.folder / "merge.log").read_text())
        self.assertEqual(self.reports("out"), self.reports("whole"))

    def test_a_task_whose_step_died_meets_its_old_copy(self):
        array = self.submit("1-2", "regress", "suite", "-o", "out")
        self.wait_for_tasks("1-0", "2-0")
        node = self.jobs(array)["1"]["NodeList"]
        steps = self.cluster.steps_on(node)
        copies = [task for task in self.cluster.tasks_on(node) if slurm_cluster.parent_of(task) in steps]
        self.cluster.kill_step(node)
        self.cluster.run("scontrol", "requeue", f"{array}_1")
        merge = self.submit_merge(array)
        self.wait_for_tasks("1-1")
        self.assertEqual([Path(f"/proc/{copy}").exists() for copy in copies], [True])
        self.open_gate()  # for both copies
        self.assertEqual(self.end_of(merge)["ExitCode"], "1:0", (self.folder / "merge.log").read_text())
        self.assertEqual(self.jobs(array)["1"]["Restarts"], "1")
        self.assertEqual(self.reports("out"), self.reports("whole"))


if __name__ == "__main__":
    reason = slurm_cluster.reason_against()
    if reason:
        print(f"skipped: no Slurm cluster can be started here: {reason}")
        sys.exit(1 if os.environ.get("CI") and "packages" in reason else SKIPPED)
    slurm_cluster.in_own_processes()
    unittest.main()
