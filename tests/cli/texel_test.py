"""Scenes with fur and cloth: what `keiko trace` and `keiko render` show of texels."""
import csv
import io
import math
import unittest

from keiko_process import KeikoTest, surface

SADDLE = surface("saddle.bpt")  # z = (x^2 - y^2) / 400 over +-100 mm
FUR = f"""format = "keiko-scene/1"
background = 0
ambient = 0
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
    def rows(self, scene: str, rays: list) -> list:
        run = self.keiko("trace", self.write("scene.toml", scene), "--out", "t,luminance", "--shadows", "-q",
                         input="ox,oy,oz,dx,dy,dz\n" + "\n".join(rays) + "\n")
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        return list(csv.DictReader(io.StringIO(run.stdout)))

    def light(self, scene: str) -> list:
        return [float(row["luminance"]) for row in self.rows(scene, RAYS)]

    def refused(self, scene: str) -> str:
        run = self.keiko("render", self.write("scene.toml", scene), "-o", "a.png", "-q")
        self.assertEqual((run.returncode, run.stderr.count("\n")), (2, 1), run.stderr)
        return run.stderr

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

    def test_fur_stands_out_beyond_the_body(self):
        # A black wall behind the saddle's ridge is seen through what stands above it.
        wall = f'''[[model]]
file = "{surface("wall.bpt")}"
material = {{ diffuse = 0, refractive_index = 1 }}
transform = {{ translate = [-100, 4900, -100] }}
'''
        past = [f"{x}.3,-300,{z},0,1,0" for x in range(-9, 9) for z in (5, 15)]
        for ray, row in zip(past, self.rows(FUR + wall + SUN, past)):
            self.assertGreater(float(row["t"]), 1000)
            if ",15," in ray:
                self.assertEqual(float(row["luminance"]), 0)
            else:
                self.assertGreater(float(row["luminance"]), 1)

    def test_pictures_are_the_same_for_any_number_of_threads(self):
        self.expect_same_picture_for_any_threads(self.write("scene.toml", FUR + SUN))

    def test_what_cannot_be_is_told_in_a_line(self):
        self.assertIn("texels: stand in no fog", self.refused(FUR + "[fog]\nextinction = 0.1\n"))
        self.assertRegex(self.refused(FUR.replace("hairs = 100", "hairs = 0.2")),
                         r"scene\.toml:12:9: .*texels\.hairs: a block has less than one hair: make it larger\n\Z")
        self.assertRegex(self.refused(FUR.replace("fur", "silk")), r"scene\.toml:10:8: .*texels\.kind: ")


if __name__ == "__main__":
    unittest.main()
