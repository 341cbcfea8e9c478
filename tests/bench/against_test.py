"""tests/bench/against.py, with programs that stand in for two builds of the benchmarks."""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

AGAINST = Path(__file__).with_name("against.py")
STAND_IN = """#!{python}
import json, sys
from pathlib import Path
if "--help" in sys.argv: sys.exit(print("--json --alone"))
assert "--alone" in sys.argv
runs = Path(__file__ + ".runs")
turn = int(runs.read_text()) if runs.exists() else 0
runs.write_text(str(turn + 1))
rates = {rates}
measurements = [{{"kind": kind, "mode": "single", "rays_per_second": each[turn % len(each)]}} for kind, each in rates.items()]
results = {{"scenes": [{{"scene": "hood", "classes": [{{"class": "primary", "measurements": measurements}}]}}]}}
Path(sys.argv[sys.argv.index("--json") + 1]).write_text(json.dumps(results))
"""


class Against(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="keiko-against-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def program(self, name: str, **rates) -> str:
        file = self.folder / name
        file.write_text(STAND_IN.format(python=sys.executable, rates=rates))
        file.chmod(0o755)
        return str(file)

    def against(self, base: str, head: str, *arguments: str) -> subprocess.CompletedProcess:
        return subprocess.run([sys.executable, AGAINST, base, head, *arguments], capture_output=True, text=True)

    def test_the_same_rates_are_not_slower(self):
        run = self.against(self.program("base", keiko=[100]), self.program("head", keiko=[97]))
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("| hood | primary | keiko, single | 0.970 |", run.stdout)

    def test_a_tenth_less_in_every_pair_is_slower(self):
        run = self.against(self.program("base", keiko=[100, 50]), self.program("head", keiko=[90, 45]))
        self.assertEqual(run.returncode, 1, run.stderr)
        self.assertIn("slower", run.stdout)

    def test_one_bad_pair_is_not(self):
        run = self.against(self.program("base", keiko=[100]), self.program("head", keiko=[100, 100, 40, 101, 100]))
        self.assertEqual(run.returncode, 0, run.stdout)

    def test_what_looks_slower_is_measured_again(self):
        base = self.program("base", keiko=[100])
        once = self.program("once", keiko=[90] * 9 + [100] * 9)
        run = self.against(base, once)
        self.assertEqual(run.returncode, 0, run.stdout)
        self.assertIn("1 of 1 rates look slower: once more", run.stderr)

    def test_what_a_loss_may_be_is_told_by_the_limit(self):
        programs = self.program("base", keiko=[100]), self.program("head", keiko=[97])
        self.assertEqual(self.against(*programs, "--limit", "0.01").returncode, 1)

    def test_peers_are_not_looked_at(self):
        run = self.against(self.program("base", keiko=[1], mesh=[100]), self.program("head", keiko=[1], mesh=[10]))
        self.assertEqual(run.returncode, 0)
        self.assertNotIn("mesh", run.stdout)

    def test_nothing_in_common_or_no_program_is_an_error(self):
        one = self.program("base", mesh=[1])
        for head in one, str(self.folder / "nowhere"):
            run = self.against(one, head)
            self.assertEqual((run.returncode, run.stdout), (2, ""))
            self.assertIn("against: ", run.stderr)


if __name__ == "__main__":
    unittest.main()
