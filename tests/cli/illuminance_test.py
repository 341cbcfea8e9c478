"""`keiko illuminance`: points from standard input, lux to standard output."""
import csv
import io
import math
import unittest

from keiko_process import KeikoTest, surface

SADDLE = surface("saddle.bpt")
HEADER = "x,y,z,nx,ny,nz\n"
# One thin tube of 1 m, 1 m over the origin, and a spotlight beside it.
SCENE = f"""format = "keiko-scene/1"
[[model]]
file = "{SADDLE}"
[[spotlight]]
position = [0, 0, 2000]
aim = [0, 0, 0]
intensity = 400
[[c_plane]]
origin = [-500, -20, 1000]
u = [1000, 0, 0]
v = [0, 40, 0]
lamps = 1
diameter = 10
luminance = 9000
"""


class Illuminance(KeikoTest):
    def rows(self, points: str, *arguments: str, scene: str = SCENE) -> list:
        run = self.keiko("illuminance", self.write("scene.toml", scene), *arguments, "-q",
                         input=points)
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        return list(csv.DictReader(io.StringIO(run.stdout)))

    def test_sources_and_their_sum_in_lux(self):
        for header in "", HEADER:
            up, down = self.rows(header + "0,0,0,0,0,3\n0,0,0,0,0,-1\n")
            self.assertEqual(list(up), ["spotlight.0", "c_plane.0", "sum"])
            self.assertAlmostEqual(float(up["spotlight.0"]), 400 / 4, delta=1e-9)
            # A thin tube over its middle: L d (h l / r^2 + atan l / h) in closed form.
            line = 9000 * 0.01 * (0.5 / (1 + 0.25) + math.atan(0.5))
            self.assertAlmostEqual(float(up["c_plane.0"]), line, delta=5e-3 * line)
            self.assertAlmostEqual(float(up["sum"]), sum(float(up[s]) for s in list(up)[:2]),
                                   delta=1e-9)
            self.assertEqual(list(down.values()), ["0", "0", "0"])

    def test_glass_dims_what_is_behind_it(self):
        self.write("pane.bpt", "1\n1 1\n-300 -300 500\n300 -300 500\n-300 300 500\n300 300 500\n")
        scene = """format = "keiko-scene/1"
[[model]]
file = "pane.bpt"
material = { refractive_index = 1.5, glass = { absorption = 0.05, pane = 4 } }
[[spotlight]]
position = [0, 0, 2000]
aim = [0, 0, 0]
intensity = 400
"""
        point = "0,0,0,0,0,1\n"
        dimmed, = self.rows(point, scene=scene)
        shaded, = self.rows(point, scene=scene.replace("{ refractive_index", "{ diffuse = 0 } # ("))
        crossing, mirrored = math.exp(-0.05 * 4), 0.04
        passed = (1 - mirrored) ** 2 * crossing / (1 - (mirrored * crossing) ** 2)
        self.assertAlmostEqual(float(dimmed["sum"]), 100 * passed, delta=1e-9)
        self.assertEqual(float(shaded["sum"]), 0)

    def test_mirrors_and_water_throw_light_with_caustics(self):
        square = "1\n1 1\n{0} {0} {1}\n{2} {0} {1}\n{0} {2} {1}\n{2} {2} {1}\n"
        self.write("floor.bpt", square.format(-300, 0, 300))
        self.write("above.bpt", square.format(-900, 1000, 900))
        scene = """format = "keiko-scene/1"
[caustics]
detail = 8
[[model]]
file = "floor.bpt"
material = "clay"
[[model]]
file = "above.bpt"
material = { refractive_index = 1.333, glass = { absorption = 0.0001 } }
[[point]]
position = [0, 0, HEIGHT]
intensity = 100
"""
        point, n = "0,0,0,0,0,1\n", 1.333
        passed = 1 - ((n - 1) / (n + 1)) ** 2
        # From above the water a depth of z looks like z / n: so much nearer, the light spreads less.
        wet, = self.rows(point, scene=scene.replace("HEIGHT", "3000"))
        lux = 100 / (2 + 1 / n) ** 2 * passed * math.exp(-0.0001 * 1000)
        self.assertAlmostEqual(float(wet["sum"]), lux, delta=1e-6 * lux)
        # Below a mirror the lamp's image stands as far above it.
        mirror = scene.replace("{ refractive_index = 1.333, glass = { absorption = 0.0001 } }", '"chrome"')
        lit, = self.rows(point, scene=mirror.replace("HEIGHT", "400"))
        direct, = self.rows(point, scene=mirror.replace("HEIGHT", "400").replace("[caustics]\ndetail = 8\n", ""))
        self.assertAlmostEqual(float(direct["sum"]), 100 / 0.4**2, delta=1e-9)
        share = (float(lit["sum"]) - float(direct["sum"])) / (100 / 1.6**2)
        self.assertTrue(0.64 < share < 0.70, share)

    def test_points_in_a_focus_of_caustics_are_refused(self):
        # Rays from between 50 and 75 mm below its middle on meet on the axis of the ball of glass.
        ball = """format = "keiko-scene/1"
[[primitive]]
kind = "sphere"
center = [0, 0, 65]
radius = 50
material = { refractive_index = 1.5, glass = { absorption = 0 } }
[[primitive]]
kind = "plane"
origin = [-200, -200, 0]
u = [400, 0, 0]
v = [0, 400, 0]
material = "clay"
[caustics]
detail = 64
interfaces = 2
[sun]
direction = [0, 0, -1]
illuminance = 10000
"""
        points = "0.01,0,0,0,0,1\n0,0,0,0,0,1\n"
        reason = "lies in a focus of caustics of sun.0, where the light has no limit"
        for arguments, rows in ((), 2), (("--summary",), 0):
            run = self.keiko("illuminance", self.write("scene.toml", ball), *arguments, "-q",
                             input=points)
            self.assertEqual((run.returncode, len(run.stdout.splitlines())), (2, rows))
            self.assertIn(f"standard input:2: x,y,z {reason}", run.stderr)
        # Two rays of the ball's own geometry, and one near the axis.
        rows = self.rows("1e-3,0,0,0,0,1\n1e-2,0,0,0,0,1\n0.1,0,0,0,0,1\n", scene=ball)
        for row, lux in zip(rows, (1554960113.8, 155964324.05, 16081242.16)):
            self.assertAlmostEqual(float(row["sum"]) / lux, 1, delta=1e-5)

    def test_a_summary_has_mean_and_uniformity(self):
        points = "0,0,0,0,0,1\n200,0,0,0,0,1\n"
        lux = [float(row["sum"]) for row in self.rows(points)]
        *sources, total = self.rows(points, "--summary")
        self.assertEqual([row["source"] for row in sources], ["spotlight.0", "c_plane.0"])
        mean = sum(lux) / 2
        for column, value in (("points", 2), ("minimum", min(lux)), ("mean", mean),
                              ("maximum", max(lux)), ("uniformity", min(lux) / mean)):
            self.assertAlmostEqual(float(total[column]), value, delta=1e-9)

    def test_same_bytes_for_any_number_of_threads(self):
        points = "".join(f"{i},{i % 7},3,0.1,{i % 3},1\n" for i in range(5000))
        self.assertEqual(self.rows(points, "--threads", "1"), self.rows(points, "--threads", "2"))

    def test_the_paper_is_reproduced_on_request(self):
        thick = SCENE.replace("-20, 1000", "-100, 1000").replace("[0, 40, 0]", "[0, 200, 0]")
        thick = thick.replace("diameter = 10", "diameter = 100")
        lux = {}
        for word in "paper", "exact":
            row = self.rows("0,0,0,0,0,1\n", scene=thick + f'fidelity = "{word}"\n')[0]
            lux[word] = float(row["c_plane.0"])
        # d / D is 0.1: the paper is about 2.8 % too dark.
        self.assertAlmostEqual(lux["paper"] / lux["exact"], 1 - 0.028, delta=0.004)

    def test_sight_tells_how_far_lamps_and_signs_are_seen(self):
        scene = SCENE + """[[sign]]
corners = [[3000, -500, 500], [3000, -500, 1500], [3000, 500, 1500], [3000, 500, 500]]
[[sign.legend]]
corners = [[3000, -200, 800], [3000, -200, 1200], [3000, 200, 1200], [3000, 200, 800]]
[fog]
extinction = 0.02
ambient = 5
"""
        eye = "0,0,500,0,0,-1\n"
        row, = self.rows(eye, "--sight", scene=scene)
        self.assertEqual(list(row), ["distance_m", "near_contrast", "contrast", "visible_to_m", "sign.0.contrast",
                                     "sign.0.legible_to_m", "spotlight.0.lux", "spotlight.0.visible_to_m"])
        self.assertAlmostEqual(float(row["distance_m"]), 0.5, delta=1e-6)
        self.assertAlmostEqual(float(row["spotlight.0.lux"]), 400 * math.exp(-0.02 * 1.5) / 1.5 ** 2, delta=1e-9)
        left = math.exp(-0.02 * 3.041381)
        self.assertAlmostEqual(float(row["sign.0.contrast"]), 360 * left / (40 * left + 5 * (1 - left)), delta=0.05)
        near, = self.rows(eye, "--sight", "--least-contrast", "0.5", "--least-lux", "1e-3", scene=scene)
        for column in ("sign.0.legible_to_m", "spotlight.0.visible_to_m"):
            self.assertLess(float(near[column]), float(row[column]))
        lux = float(near["spotlight.0.visible_to_m"])
        self.assertAlmostEqual(400 * math.exp(-0.02 * lux) / lux ** 2, 1e-3, delta=1e-12)

    def test_sight_needs_fog(self):
        for arguments, said in ((("--sight",), "sight needs a scene file with a rig and [fog]"),
                                (("--sight", "--summary"), "--summary"), (("--least-lux", "1"), "--sight")):
            run = self.keiko("illuminance", self.write("scene.toml", SCENE), *arguments, "-q", input="0,0,0,0,0,1\n")
            self.assertEqual((run.returncode, run.stdout, run.stderr.count("\n")), (2, "", 1))
            self.assertIn(said, run.stderr)

    def test_a_malformed_line_ends_it_with_its_number(self):
        for line, reason in (("1,2,3,4,5\n", "expected x,y,z,nx,ny,nz, got 5 fields"),
                             ("1,2,3,0,0,0\n", "nx,ny,nz is no direction: all are 0"),
                             ("1,b,3,0,0,1\n", 'y is not a number: "b"')):
            run = self.keiko("illuminance", self.write("scene.toml", SCENE), "-q",
                             input="0,0,0,0,0,1\n" + line)
            self.assertEqual(run.returncode, 2)
            self.assertEqual(run.stderr, f"keiko: standard input:2: {reason}\n")
            self.assertEqual(run.stdout.count("\n"), 2)

    def test_a_point_inside_a_lamp_ends_it_with_its_number(self):
        run = self.keiko("illuminance", self.write("scene.toml", SCENE), "-q",
                         input="0,0,0,0,0,1\n0,1,1004,0,0,1\n")
        self.assertEqual(run.returncode, 2)
        self.assertEqual(run.stderr,
                         "keiko: standard input:2: x,y,z lies in a lamp of c_plane.0\n")
        self.assertEqual(run.stdout.count("\n"), 2)

    def test_no_points_are_told(self):
        for nothing in "", "\n", HEADER:
            for option in (), ("--summary",):
                run = self.keiko("illuminance", self.write("scene.toml", SCENE), *option, "-q",
                                 input=nothing)
                self.assertEqual(run.returncode, 2)
                self.assertEqual(run.stderr, "keiko: standard input: holds no points\n")

    def test_a_body_without_a_rig_is_refused(self):
        run = self.keiko("illuminance", SADDLE, "-q", input="0,0,0,0,0,1\n")
        self.assertEqual((run.returncode, run.stdout), (2, ""))
        self.assertEqual(run.stderr, "keiko: illuminance needs a scene file with a rig\n")


if __name__ == "__main__":
    unittest.main()
