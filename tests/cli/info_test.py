"""`keiko info` of the fixtures, for people and for programs."""
import json
import unittest

from keiko_process import KeikoTest, surface

FACES = {"concept-car.step": 185, "dent.step": 1, "dome.bpt": 4, "hood.step": 3, "pole.step": 4,
         "saddle.bpt": 4, "seam-g0-gap.step": 2, "rational-sphere.step": 8, "trimmed-hole.step": 1,
         "trimmed-island.step": 2, "trimmed-two-holes.step": 1}


class Info(KeikoTest):
    def facts(self, name: str) -> dict:
        return json.loads(self.succeed("info", surface(name), "--json", "-q"))

    def test_faces_are_counted(self):
        for name, faces in FACES.items():
            facts = self.facts(name)
            self.assertEqual((facts["faces"], facts["placed_faces"]), (faces, faces), name)
            self.assertEqual((facts["lost_faces"], facts["diagnostics"]), ([], []), name)

    def test_the_text_tells_the_same(self):
        text = self.succeed("info", surface("hood.step"), "-q")
        facts = self.facts("hood.step")
        self.assertRegex(text, rf"(?m)^faces\s+{facts['faces']}\b")
        self.assertRegex(text, rf"(?m)^patches\s+{facts['patches']}\b")

    def test_a_unit_given_by_hand_scales_the_model(self):
        plain = self.facts("saddle.bpt")["bounds"]["upper"]
        inches = json.loads(self.succeed("info", surface("saddle.bpt"), "--json", "-q", "--unit",
                                         "in"))["bounds"]["upper"]
        for a, b in zip(plain, inches):
            self.assertAlmostEqual(b, 25.4 * a, delta=1e-9)


if __name__ == "__main__":
    unittest.main()
