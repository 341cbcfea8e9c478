"""What to mend first: faults planted into the concept car, which has none of its own."""
import json
import re
import unittest

from keiko_process import SMALL, KeikoTest, surface
from step_text import StepText

# Face, degrees and side of each, those that an eye sees most first. The first is on both sides of the car.
PLANTED = [[("body-c05-r1", 0.9, False), ("body-c16-r1", 0.9, False)], [("body-c08-r2", 0.8, True)],
           [("body-c18-r2", 0.45, False)], [("body-c14-r3", 0.35, False)], [("body-c03-r3", 0.25, False)]]


class Triage(KeikoTest):
    def test_planted_faults_come_first_in_the_order_of_what_is_seen(self):
        car = StepText(surface("concept-car.step"))
        by_name = {re.search(r"'([^']*)'", car.entities[face])[1]: face for face in car.faces()}
        for fault in PLANTED:
            for name, degrees, at_end in fault:
                car.kink_at_side(by_name[name], degrees, at_end)
        car.write(self.folder / "car.step")
        run = self.keiko("inspect", "car.step", "-o", "out", "--view", "high-left", "-q", *SMALL)
        self.assertEqual((run.returncode, run.stderr), (1, ""))
        report = json.loads((self.folder / "out/report.json").read_text())
        seams = [seam["faces"] for seam in report["seams"]]
        items = report["triage"]["items"]
        planted = [name for fault in PLANTED for name, *_ in fault]
        for item in items:
            shown = " ".join(seams[seam - 1] for seam in item["seams"])
            self.assertTrue(any(name in shown for name in planted), shown)
        tangents = [item for item in items if item["mending"] == "tangent"]
        self.assertIs(tangents[0], items[0])
        self.assertEqual(len(tangents), len(PLANTED), "the mirrored twins are one item")
        for item, fault in zip(tangents, PLANTED):
            shown = " ".join(seams[seam - 1] for seam in item["seams"])
            self.assertTrue(all(name in shown for name, *_ in fault), (shown, fault))
            self.assertEqual(item["mirrored"], len(fault) == 2)
        self.assertEqual([item["weight"] for item in tangents],
                         sorted((item["weight"] for item in tangents), reverse=True))


if __name__ == "__main__":
    unittest.main()
