"""keiko regress killed at random moments: nothing is ever half written, and the next run goes on."""
import json
import os
import random
import subprocess
import time
import unittest
import xml.etree.ElementTree as ElementTree

from keiko_process import BINARY
from regress_suite import RegressTest, move_point_of_dome

NAMES = "a", "b", "c"
KILLS = 100 if os.environ.get("KEIKO_LONG") else 8


class Killed(RegressTest):
    def command(self, turn: int) -> list:
        """Every other time baselines are replaced rather than compared."""
        common = [BINARY, "regress", "-q", "suite", "-o", "out"]
        if turn % 2 == 0:
            return [*common, "--fresh"]
        return [*common, *(word for name in NAMES for word in ("--update", name))]

    def run_to_the_end(self, turn: int) -> float:
        start = time.monotonic()
        run = subprocess.run(self.command(turn), cwd=self.folder, capture_output=True, text=True, timeout=120)
        self.assertIn(run.returncode, (0, 1), run.stderr)
        return time.monotonic() - start

    def kill_after(self, seconds: float, turn: int):
        process = subprocess.Popen(self.command(turn), cwd=self.folder,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            process.wait(timeout=seconds)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()

    def assert_whole(self):
        """What stands there under its own name is whole."""
        for name in NAMES:
            self.assert_sound(self.folder / "suite/baselines" / name)
            candidate = self.folder / "out" / name / "candidate"
            if candidate.exists():
                self.assert_sound(candidate)
        out = self.folder / "out"
        if (out / "regression.json").exists():
            json.loads((out / "regression.json").read_text())
        if (out / "junit.xml").exists():
            ElementTree.parse(out / "junit.xml")
        if (out / "index.html").exists():
            self.assertTrue((out / "index.html").read_text().endswith("</html>\n"))

    def test_no_file_is_ever_damaged_and_the_next_run_ends_well(self):
        models = [self.add_fixture(name) for name in NAMES]
        self.accept(*NAMES)
        whole = max(self.run_to_the_end(0), self.run_to_the_end(1))
        moments = random.Random(20261121)
        for turn in range(KILLS):
            move_point_of_dome(models[turn % len(models)], 0.5)
            self.kill_after(moments.uniform(0, whole), turn)
            with self.subTest(turn=turn):
                self.assert_whole()
        run = self.regress(*(word for name in NAMES for word in ("--update", name)))
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        run = self.regress()
        self.assertEqual((run.returncode, run.stderr), (0, ""), run.stdout)
        self.assert_whole()
        self.assertEqual([p for p in self.content() if ".tmp" in p or ".before" in p], [])

    def test_a_run_that_was_killed_is_taken_up_where_it_was(self):
        for name in NAMES:
            self.add_fixture(name)
        slow = self.folder / "suite/c.toml"
        quick = slow.read_text()
        slow.write_text(quick.replace("[32, 18]", "[2400, 1350]"))
        process = subprocess.Popen([BINARY, "regress", "suite", "-o", "out", "--verbose"], cwd=self.folder,
                                   text=True, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        for line in process.stderr:
            if line == "keiko: 3/3 c: render\n":
                break
        process.kill()
        process.communicate()
        manifests = [self.folder / "out" / name / "candidate/manifest.json" for name in NAMES]
        self.assertEqual([m.exists() for m in manifests], [True, True, False])
        before = [m.stat().st_mtime_ns for m in manifests[:2]]
        slow.write_text(quick)
        run = self.regress()
        self.assertEqual((run.returncode, run.stderr), (1, ""))
        self.assertEqual([m.stat().st_mtime_ns for m in manifests[:2]], before)
        self.assertTrue(manifests[2].exists())


if __name__ == "__main__":
    unittest.main()
