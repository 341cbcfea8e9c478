"""Scenes with fur and cloth: what `keiko trace` and `keiko render` show of texels."""
import csv
import io
import math
import unittest

from keiko_process import KeikoTest, surface

SADDLE = surface("saddle.bpt")  # z = (x^2 - y^2) / 400 over +-100 mm
FUR = f"""format = "keiko-scene/1"
[[model]]
file = "{SADDLE}"
[model.material]
diffuse = 0
refractive_index = 1
[model.material.texels]
kind = "fur"
thickness = 10
hairs = 100
lean = 0
droop = 0
voxels = 32
[camera]
eye = [0, -420, 200]
target = [0, 30, 0]
size = [64, 36]
"""
SUN = "[sun]\ndirection = [0, 0, -1]\nilluminance = 1000\n"
VOXELS = """format = "keiko-voxels/1"
raw = "cube.raw"
nodes = [2, 2, 2]
type = "uint8"
origin = [-300, -300, 300]
spacing = [600, 600, 600]
"""
DEPTH = 0.9
CLOUD = f"""[[volume]]
file = "voxels.toml"
extinction = [[0, {DEPTH / 0.6}]] # 1/m
emits = [[0, 0]]
"""
BALL_UNDER_LAMP = f"""[[model]]
file = "{surface("rational-sphere.step")}"
material = "solid-glass"
transform = {{ scale = 0.45, translate = [0, -20, 120] }}
[[spotlight]]
position = [0, -20, 900]
aim = [0, -20, 0]
half_angle = 20
intensity = 900
"""
RAYS = [f"{x},-80,60,0,{60 + y},{-60 + z}"  # below the ball
        for x in range(-20, 21, 4) for y in (0, 20, 40) for z in (0, 2)]


class Texels(KeikoTest):
    def light(self, scene: str) -> list:
        run = self.keiko("trace", self.write("scene.toml", scene), "--out", "luminance", "--shadows", "-q",
                         input="ox,oy,oz,dx,dy,dz\n" + "\n".join(RAYS) + "\n")
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        return [float(row["luminance"]) for row in csv.DictReader(io.StringIO(run.stdout))]

    def test_caustics_leave_the_light_that_glass_lets_straight_through(self):
        straight, bent = (self.light(FUR + BALL_UNDER_LAMP + more) for more in ("", "[caustics]\n"))
        self.assertGreater(sum(straight) / len(straight), 1)
        self.assertEqual(bent, straight)

    def test_volumes_dim_the_light_that_arrives(self):
        (self.folder / "cube.raw").write_bytes(b"\xff" * 8)
        self.write("voxels.toml", VOXELS)
        clear, dimmed = self.light(FUR + SUN), self.light(FUR + SUN + CLOUD)
        self.assertGreater(sum(clear) / len(clear), 1)
        for before, after in zip(clear, dimmed):
            self.assertAlmostEqual(after, before * math.exp(-DEPTH), delta=1e-6 * before)


if __name__ == "__main__":
    unittest.main()
