"""keiko compare: what it tells of two revisions, and its exit codes."""
import unittest
from pathlib import Path

from keiko_process import KeikoTest, surface

DOME = surface("dome.bpt")
# What the tests tell apart shows at these as well, in a tenth of the time.
FEW = "compare", "-q", "--samples", "500"


class Compare(KeikoTest):
    def dome_with_point_moved(self, millimetres: float) -> str:
        """The dome with an inner control point of its first patch (degree 3 x 5) raised."""
        lines = Path(DOME).read_text().splitlines()
        line = 2 + 1 * 6 + 2
        x, y, z = map(float, lines[line].split())
        lines[line] = f"{x!r} {y!r} {z + millimetres!r}"
        return self.write("moved.bpt", "\n".join(lines) + "\n")

    def test_a_part_is_the_same_as_itself(self):
        self.assertTrue(self.succeed(*FEW, DOME, DOME).startswith("same within tolerance\n"))

    def test_a_control_point_moved_by_ten_micrometres_is_found_from_both_sides(self):
        moved = self.dome_with_point_moved(0.01)
        for command, pair in (("compare", "-q"), (DOME, moved)), (FEW, (moved, DOME)):
            run = self.keiko(*command, *pair)
            self.assertEqual((run.returncode, run.stderr), (1, ""), run.stdout)
            self.assertTrue(run.stdout.startswith("different\n"), run.stdout)

    def test_one_micrometre_of_a_control_point_is_within_the_tolerance_unless_told(self):
        moved = self.dome_with_point_moved(0.001)
        self.assertEqual(self.keiko(*FEW, DOME, moved).returncode, 0)
        strict = self.keiko(*FEW, DOME, moved, "--tolerance", "1e-5")
        self.assertEqual(strict.returncode, 1, strict.stdout)

    def test_another_trim_is_another_part(self):
        run = self.keiko(*FEW, surface("trimmed-hole.step"), surface("trimmed-two-holes.step"))
        self.assertEqual(run.returncode, 1)
        self.assertIn("not proved on", run.stdout)

    def test_findings_come_and_go(self):
        run = self.keiko(*FEW, surface("seam-g1-angle.step"), surface("seam-g1-only.step"))
        self.assertEqual(run.returncode, 1)
        self.assertIn("finding new: ", run.stdout)
        self.assertIn("finding fixed: ", run.stdout)

    def test_the_text_does_not_depend_on_threads(self):
        pair = surface("seam-g1-angle.step"), surface("seam-g0-gap.step")
        texts = {self.keiko(*FEW, *pair, "--threads", n).stdout for n in ("1", "2")}
        self.assertEqual(len(texts), 1)

    def test_a_missing_file_is_an_error(self):
        run = self.keiko("compare", DOME, "nowhere.step")
        self.assertEqual((run.returncode, run.stdout), (2, ""))
        self.assertIn("nowhere.step", run.stderr)


if __name__ == "__main__":
    unittest.main()
