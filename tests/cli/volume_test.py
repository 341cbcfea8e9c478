"""Scenes with [[volume]]: what `keiko trace` and `keiko render` show of voxels and surfaces."""
import csv
import io
import json
import math
import unittest

from keiko_process import SOURCE, KeikoTest, surface

SADDLE = surface("saddle.bpt")  # z = (x^2 - y^2) / 400 over +-100 mm
VOXELS = """format = "keiko-voxels/1"
raw = "cube.raw"
nodes = [2, 2, 2]
type = "uint8"
origin = [-50, -50, -50]
spacing = [100, 100, 100]
"""
KAPPA, OWN = 0.012, 70  # 1/mm, cd/m2
VOLUME = f"""[[volume]]
file = "voxels.toml"
extinction = [[0, 0], [1, {1000 * KAPPA}]]
emits = [[0, {OWN}]]
step = 1
"""
SCENE = f"""format = "keiko-scene/1"
background = 100
ambient = 500
[[model]]
file = "{SADDLE}"
material = {{ metal = {{ n = 1, k = 5 }} }}
[camera]
eye = [0, -420, 260]
target = [0, 30, 55]
size = [64, 36]
"""
PANEL = """[[polygon]]
corners = [[-900, -900, 300], [-900, 900, 300], [900, 900, 300], [900, -900, 300]]
luminance = 3000
"""
COLUMNS = "t,x,y,z,nx,ny,nz,luminance"
RAYS = ("3,7,200,0,0,-1",         # onto the saddle in the volume
        "3,7,20,0,0,-1",          # from within
        "300,0,0,-1,0.01,0.2",    # past the saddle, through the volume
        "500,0,200,0,0,-1",       # past both
        "95,3,200,-0.05,0,-1",    # mirrored into the volume
        "20,10,-120,0.01,0,-1")   # away from both


def to_exit(origin, direction):
    """Lengths of a ray before and in the cube."""
    near, far = 0, math.inf
    for o, d in zip(origin, direction):
        if d:
            a, b = sorted(((-50 - o) / d, (50 - o) / d))
            near, far = max(near, a), min(far, b)
        elif abs(o) > 50:
            return 0, 0
    return (near, far) if near < far else (0, 0)


class Volume(KeikoTest):
    def setUp(self):
        super().setUp()
        (self.folder / "cube.raw").write_bytes(b"\xff" * 8)
        self.write("voxels.toml", VOXELS)

    def rows(self, scene: str, rays=RAYS) -> list:
        run = self.keiko("trace", self.write("scene.toml", scene), "--out", COLUMNS, "-q",
                         input="ox,oy,oz,dx,dy,dz\n" + "\n".join(rays) + "\n")
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        return list(csv.DictReader(io.StringIO(run.stdout)))

    def refused(self, scene: str, *arguments: str) -> str:
        run = self.keiko("render", self.write("scene.toml", scene), "-o", "a.png", "-q", *arguments)
        self.assertEqual((run.returncode, run.stderr.count("\n")), (2, 1), run.stderr)
        return run.stderr

    @staticmethod
    def seen_through(origin, direction, end, behind):
        near, far = to_exit(origin, direction)
        passed = math.exp(-KAPPA * max(0, min(far, end) - near))
        return OWN * (1 - passed) + behind * passed

    def test_surfaces_and_panels_end_the_way_through_voxels(self):
        # All that the bare metal shows is the ambient light in its mirror image, or the panel.
        for scene, mirrored_light in (SCENE, 500 / math.pi), (SCENE + PANEL, 3000):
            clear, filled = self.rows(scene), self.rows(scene + VOLUME)
            hits = 0
            for ray, before, after in zip(RAYS, clear, filled):
                o, d = [[float(x) for x in ray.split(",")[i:i + 3]] for i in (0, 3)]
                length = math.hypot(*d)
                d = [x / length for x in d]
                self.assertEqual(after["t"], before["t"])
                if not before["t"]:
                    continue
                hits += 1
                n = [float(before[k]) for k in ("nx", "ny", "nz")]
                place = [float(before[k]) for k in "xyz"]
                cosine = sum(a * b for a, b in zip(n, d))
                mirrored = [a - 2 * cosine * b for a, b in zip(d, n)]
                in_mirror = self.seen_through(place, mirrored, math.inf, mirrored_light)
                behind = float(before["luminance"]) / mirrored_light * in_mirror
                expected = self.seen_through(o, d, float(before["t"]) * length, behind)
                self.assertAlmostEqual(float(after["luminance"]) / expected, 1, delta=1e-6, msg=ray)
            self.assertEqual(hits, 3)

    def test_pictures_are_the_same_for_any_number_of_threads(self):
        self.expect_same_picture_for_any_threads(self.write("scene.toml", SCENE + VOLUME))

    def test_what_cannot_be_is_told_in_a_line(self):
        self.assertRegex(self.refused(SCENE + VOLUME.replace("step", "stop")),
                         r"scene\.toml:\d+:1: unknown key 'volume\[0\]\.stop' \(did you mean 'step'\?\)\n\Z")
        self.assertIn("volume: stands in no fog", self.refused(SCENE + "[fog]\nextinction = 0.1\n" + VOLUME))
        rig = self.write("rig.toml", 'format = "keiko-rig/1"\nambient = 9\n[fog]\nextinction = 0.1\n')
        lampless = SCENE.replace("ambient = 500\n", "")
        self.assertRegex(self.refused(lampless + VOLUME, "--rig", rig),
                         r"rig\.toml:fog: cannot surround the scene's \[\[volume\]\]\n\Z")
        (self.folder / "cube.raw").write_bytes(b"1234567")
        self.assertRegex(self.refused(SCENE + VOLUME), r"cube\.raw: has 7 bytes, but .*voxels\.toml states 8\n\Z")

    def test_a_surface_in_voxels_is_compared_with_the_part(self):
        block, voxels = surface("bored-block.step"), str(SOURCE / "surfaces" / "casting-voxels.toml")
        compare = ("compare", block, voxels, "--no-align", "--tolerance", "0.3", "-q")
        run = self.keiko(*compare, "--iso", "0.43", "--json", "a.json")
        self.assertEqual((run.returncode, run.stderr), (1, ""))
        found = json.loads((self.folder / "a.json").read_text())
        # All but the pores lie on the part, by far nearer than a voxel of 0.75 mm.
        self.assertLess(found["deviation"]["root_mean_square"], 0.15 / 3)
        self.assertLess(max(abs(found["deviation"][end]["value"]) for end in ("lowest", "highest")), 0.75 / 2)
        self.assertGreater(found["points"]["beyond"], 500)
        run = self.keiko("compare", block, SADDLE, "--iso", "0.43", "-q")
        self.assertEqual((run.returncode, run.stderr.count("\n")), (2, 1), run.stderr)


if __name__ == "__main__":
    unittest.main()
