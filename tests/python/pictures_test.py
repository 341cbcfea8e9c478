"""Pictures and rays of the Python module beside those of the command line, byte for byte.

usage: pictures_test.py KEIKO
"""
import json
import pickle
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

import keiko

ROOT = Path(__file__).resolve().parents[2]
HOOD = ROOT / "surfaces/hood-scene.toml"
SPHERE = ROOT / "surfaces/rational-sphere.step"
TUNNEL = ROOT / "lightrigs/tunnel-12.toml"
SIZE = {"width": 64, "height": 36}
PROGRAM = sys.argv.pop(1)


def run(*arguments, stdin: bytes = b"") -> bytes:
    command = [PROGRAM, *map(str, arguments), "-q"]
    return subprocess.run(command, input=stdin, stdout=subprocess.PIPE, check=False).stdout


class PicturesTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def rendered(self, *arguments, name: str = "picture.png") -> bytes:
        """What `keiko render` writes."""
        path = self.folder / name
        run("render", *arguments, "--size", "64x36", "-o", path)
        return path.read_bytes()

    def test_tone_and_exposure_are_those_of_the_program(self):
        film = keiko.render(HOOD, **SIZE)
        self.assertEqual(film.png(), self.rendered(HOOD))
        self.assertEqual(film.png("log", ev=9), self.rendered(HOOD, "--tone", "log", "--ev", "9"))
        self.assertEqual(film.png(tone="reinhard"), self.rendered(HOOD, "--tone", "reinhard"))
        self.assertEqual(film.exr(), self.rendered(HOOD, name="picture.exr"))
        with self.assertRaisesRegex(keiko.Error, "^tone: 'curved' is none of linear, log, reinhard"):
            film.png("curved")

    def test_false_colors_are_those_of_the_program(self):
        film = keiko.render(HOOD, **SIZE)
        colored = film.false_colors(1, 5000, iso_lines=True)
        self.assertEqual(colored._repr_png_(), self.rendered(HOOD, "--false-color", "--scale", "1:5000", "--iso-lines"))
        lit = keiko.render(HOOD, aovs=["illuminance"], **SIZE)
        self.assertEqual(lit.false_colors(quantity="illuminance").png,
                         self.rendered(HOOD, "--false-color", "--quantity", "illuminance"))
        colored.write(self.folder / "own.png")
        self.assertEqual((self.folder / "own.png").read_bytes(), colored.png)
        with self.assertRaisesRegex(keiko.Error, "^minimum: "):
            film.false_colors(5, 1)
        with self.assertRaises(keiko.Error):
            film.false_colors(quantity="illuminance")

    def test_analysis_pictures_are_those_of_the_program(self):
        scene = keiko.open_scene(HOOD)
        for look, ours, theirs in (("zebra", {}, []), ("curvature:mean", {"scale": (-0.01, 0.01)}, ["--scale=-0.01:0.01"]),
                                   ("draft", {"pull": (1, 0, 1), "draft": 5}, ["--pull", "1,0,1", "--draft", "5"]),
                                   ("below-radius", {"radius": 800}, ["--radius", "800"]),
                                   ("curvature:section", {"section": (1, 0, 0)}, ["--section", "1,0,0"]),
                                   ("highlight", {"rig": TUNNEL}, ["--rig", TUNNEL]), ("patches", {}, [])):
            picture = keiko.analysis_picture(scene, look, "high-left", **SIZE, **ours)
            self.assertEqual(picture.png, self.rendered(HOOD, "--view", "high-left", "--look", look, *theirs), look)
        for look, wrong, reason in (("below-radius", {}, "^radius: is needed"), ("stripes", {}, "look"),
                                    ("draft", {"pull": (0, 0, 0)}, "^pull: "), ("draft", {"draft": 91}, "^draft: "),
                                    ("radius", {"scale": (-1, 5)}, "^scale: "), ("curvature:k1=0.1", {}, "^look: ")):
            with self.assertRaisesRegex(keiko.Error, reason):
                keiko.analysis_picture(scene, look, **wrong)

    def test_penumbrae_are_those_of_the_program(self):
        scene = keiko.open_scene(HOOD, shadows=True)
        film = keiko.render(scene, penumbrae="axis", light_error=0.01, edge_samples=1, **SIZE)
        self.assertEqual(film.png(), self.rendered(HOOD, "--shadows", "--penumbrae", "axis", "--light-error", "0.01",
                                                   "--edge-samples", "1"))
        for wrong in {"penumbrae": "round"}, {"light_error": 0.2}, {"edge_samples": 0}:
            with self.assertRaisesRegex(keiko.Error, "^" + next(iter(wrong)) + ": "):
                keiko.render(scene, **wrong)

    def test_frames_are_those_of_the_program(self):
        moving = ROOT / "surfaces/turning-dots-scene.toml"
        run("render", moving, "--size", "64x36", "--frames", "7:7", "-o", self.folder / "film.png")
        scene = keiko.open_scene(moving, frame=7)
        self.assertEqual(keiko.render(scene, **SIZE).png(), (self.folder / "film-0007.png").read_bytes())
        again = pickle.loads(pickle.dumps(scene))
        self.assertEqual(keiko.render(again, **SIZE).png(), (self.folder / "film-0007.png").read_bytes())

    def test_compared_views_are_those_of_the_program(self):
        before, after = ROOT / "surfaces/seam-g0-gap.step", ROOT / "surfaces/seam-g1-angle.step"
        run("compare", before, after, "--view", "top", "--rig", TUNNEL, "--size", "64x36", "-o", self.folder / "out")
        compared = keiko.compare(before, after, views="top", rig=TUNNEL, **SIZE)
        pickle.loads(pickle.dumps(compared)).write(self.folder / "ours")
        names = sorted(path.name for path in (self.folder / "out").iterdir())
        self.assertEqual(sorted(path.name for path in (self.folder / "ours").iterdir()), names)
        for name in names:
            self.assertEqual((self.folder / "ours" / name).read_bytes(), (self.folder / "out" / name).read_bytes(), name)
        self.assertEqual(compared.html, (self.folder / "out/compare.html").read_text(encoding="utf-8"))
        at_hand = keiko.compare(before, after, views="top", rig=keiko.Rig(TUNNEL.read_text()), **SIZE)
        pictures = [name for name in names if name.endswith(".png")]
        self.assertTrue(pictures)
        for name in pictures:
            self.assertEqual(at_hand._files[name], compared._files[name], name)
        with self.assertRaisesRegex(keiko.Error, "^width: "):
            keiko.compare(before, after, views="top", width=64)
        with self.assertRaisesRegex(keiko.Error, "^rig: needs views"):
            keiko.compare(before, after, rig=TUNNEL)

    def test_a_compared_part_is_that_of_the_program(self):
        before, after = ROOT / "surfaces/seam-g0-gap.step", ROOT / "surfaces/seam-g1-angle.step"
        run("compare", before, after, "--faces", "left", "--json", self.folder / "part.json")
        self.assertEqual(keiko.compare(before, after, faces="left").to_json(),
                         (self.folder / "part.json").read_text(encoding="utf-8"))


class ReflectedLightTest(unittest.TestCase):
    """The light that surfaces reflect, beside that of the command line."""

    SPHERE = """format = "keiko-scene/1"
[[primitive]]
kind = "sphere"
center = [0, 0, 0]
radius = 2000
material = { diffuse = 0.6, refractive_index = 1 }
[[point]]
position = [0, 0, 0]
intensity = 1000
[radiosity]
element = 900
deviation = 60
rays = 256
[camera]
eye = [0, -1500, 0]
target = [0, 0, 0]
size = [64, 36]
"""
    POINTS, NORMALS = [[2000, 0, 0], [0, -2000, 0]], [[-1, 0, 0], [0, 1, 0]]

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.path = self.folder / "scene.toml"
        self.path.write_text(self.SPHERE, encoding="utf-8")
        self.scene = keiko.open_scene(self.path, shadows=True)
        self.solution = keiko.radiosity(self.scene)

    def test_a_solution_is_that_of_the_program(self):
        run("radiosity", self.path, "-o", self.folder / "theirs")
        self.solution.write(self.folder / "ours")
        pickle.loads(pickle.dumps(self.solution)).write(self.folder / "again")
        keiko.Solution.read(self.folder / "theirs").write(self.folder / "read")
        theirs = (self.folder / "theirs").read_bytes()
        for name in "ours", "again", "read":
            self.assertEqual((self.folder / name).read_bytes(), theirs, name)

    def test_its_balance_is_that_of_an_integrating_sphere(self):
        first = 4 * np.pi * 1000 * 0.6
        self.assertAlmostEqual(self.solution.emitted, first, delta=0.05 * first)
        self.assertLess(abs(self.solution.escaped), 1e-5 * first)
        self.assertAlmostEqual(self.solution.missing,
                               self.solution.emitted - self.solution.absorbed - self.solution.escaped, delta=1e-9 * first)
        self.assertTrue(0 < self.solution.remaining < 1e-2)
        self.assertGreater(self.solution.factor_rows, self.solution.elements / 2)
        self.assertEqual(self.solution.remarks, [])

    def test_points_and_pictures_have_its_light(self):
        self.solution.write(self.folder / "a.solution")
        direct, ratio = 1000 / 2 ** 2, 0.6 / (1 - 0.6)
        for solution in self.solution, self.folder / "a.solution":
            lux = keiko.illuminance(self.scene, self.POINTS, self.NORMALS, solution=solution)
            self.assertEqual(lux.dtype.names, ("point.0", "reflected", "sum"))
            np.testing.assert_allclose(lux["reflected"], direct * ratio, rtol=1e-3)
        film = keiko.render(self.path, solution=self.solution)
        for ours, options in (film, ()), (keiko.render(self.scene, solution=self.solution, gather=16), ("--gather", 16)):
            run("render", self.path, "--shadows", "--solution", self.folder / "a.solution", *options,
                "-o", self.folder / "theirs.exr")
            self.assertEqual(ours.exr(), (self.folder / "theirs.exr").read_bytes())
        self.assertNotEqual(film.exr(), keiko.render(self.scene).exr())

    def test_it_holds_for_these_lamps_at_any_level(self):
        rig = keiko.Rig('format = "keiko-rig/1"\n[[point]]\nposition = [0, 0, 0]\nintensity = 2000\n')
        at = (self.scene, self.POINTS, self.NORMALS)
        twice = keiko.illuminance(*at, solution=self.solution, rig=rig)
        once = keiko.illuminance(*at, solution=self.solution)
        np.testing.assert_allclose(twice["reflected"], 2 * once["reflected"], rtol=1e-12)
        moved = keiko.Rig(rig.text.replace("0, 0, 0", "0, 0, 1").replace("[0, 0, 0]", "[0, 0, 1]"))
        self.assertNotEqual(moved, rig)
        with self.assertRaisesRegex(keiko.Error, "^solution:lighting: is of other lamps"):
            keiko.illuminance(*at, solution=self.solution, rig=moved)
        with self.assertRaisesRegex(keiko.Error, "^solution:lighting: is of other lamps"):
            keiko.render(self.scene, solution=self.solution, rig=moved)

    def test_what_does_not_fit_is_refused(self):
        plain = keiko.open_scene(self.path)
        wrong = self.folder / "b.solution"
        wrong.write_text("keiko-rig/1\n", encoding="utf-8")
        for call, reason in (
            (lambda: keiko.radiosity(plain), "^shadows: "),
            (lambda: keiko.radiosity(keiko.open_scene(SPHERE, shadows=True)), "^rig: the scene has no lamps"),
            (lambda: keiko.render(plain, solution=self.solution), "^solution: is for a scene opened with shadows"),
            (lambda: keiko.render(HOOD, solution=self.solution), "^solution:geometry: is of other geometry"),
            (lambda: keiko.render(self.scene, solution=wrong), "b.solution:line 1: expected"),
            (lambda: keiko.render(self.scene, gather=16), "^gather: is of the light of a solution"),
            (lambda: keiko.render(self.scene, solution=self.solution, gather=65537), "^gather: is not 0 to 65536"),
        ):
            with self.assertRaisesRegex(keiko.Error, reason):
                call()
        with self.assertRaises(TypeError):
            keiko.render(self.scene, solution=7)


class RaysTest(unittest.TestCase):
    def test_all_hits_are_those_of_the_program(self):
        rays = np.array([[10, 5, 300, 0, 0, -2.0], [500, 0, 300, 0, 0, -1], [30, 20, 300, 0, 0.1, -1]])
        ray, hits = keiko.open_scene(SPHERE).trace_all(rays)
        self.assertEqual((ray.tolist(), hits.dtype), ([0, 0, 2, 2], keiko.hit_dtype))
        rise = np.sqrt(100 ** 2 - 10 ** 2 - 5 ** 2)
        np.testing.assert_allclose(hits["t"][:2], [(300 - rise) / 2, (300 + rise) / 2], rtol=1e-12)
        text = "".join(",".join(map(str, one)) + "\n" for one in rays.tolist())
        rows = run("trace", SPHERE, "--all", "--out", "t,face,x", stdin=text.encode()).decode().splitlines()[1:]
        found = [[float(cell) for cell in row.split(",")] for row in rows if not row.endswith(",")]
        self.assertEqual(found, [[i, hit["t"], hit["face"], hit["position"][0]] for i, hit in zip(ray, hits)])
        none = keiko.open_scene(SPHERE).trace_all(rays[1:2])
        self.assertEqual((len(none[0]), len(none[1])), (0, 0))
        with self.assertRaisesRegex(keiko.Error, r"rays\[0\]"):
            keiko.open_scene(SPHERE).trace_all(np.zeros((1, 6)))

    def test_luminance_is_that_of_the_program(self):
        scene = keiko.open_scene(HOOD)
        low, high = scene.bounds
        rng = np.random.default_rng(3)
        count = 200
        rays = np.zeros((count, 6))
        rays[:, :3] = rng.uniform(low, high, (count, 3))
        rays[:, 2], rays[:, 3:] = high[2] + 500, [0.1, 0.2, -1]
        text = "".join(",".join(map(repr, one)) + "\n" for one in rays.tolist())
        rows = run("trace", HOOD, "--out", "r,g,b", stdin=text.encode()).decode().splitlines()[1:]
        found = keiko.luminance(scene, rays)
        self.assertEqual(found.shape, (count, 3))
        hit = np.array([row != ",," for row in rows])
        self.assertGreater(hit.sum(), count / 4)
        theirs = np.array([[float(cell) for cell in row.split(",")] for row in rows if row != ",,"])
        np.testing.assert_array_equal(found[hit], theirs)
        self.assertGreater(found.max(), 0)
        np.testing.assert_array_equal(keiko.luminance(scene, rays, threads=1), found)
        self.assertNotEqual(keiko.luminance(scene, rays, rig=TUNNEL).tobytes(), found.tobytes())
        with self.assertRaisesRegex(keiko.Error, "^rig: "):
            keiko.luminance(SPHERE, rays)


class SettingsTest(unittest.TestCase):
    def test_a_report_names_the_files_of_its_settings(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            preset, accepted = folder / "limits.toml", folder / "accepted.json"
            preset.write_text('format = "keiko-preset/1"\nname = "own"\n[seam]\ngap = 0.02\nangle = 0.1\n', encoding="utf-8")
            seam = ROOT / "surfaces/seam-g0-gap.step"
            (folder / "check.json").write_text(keiko.check(seam, preset).to_json(), encoding="utf-8")
            keiko.accept(folder / "check.json", 1, accepted, why="hidden", who="Ann")
            run("inspect", seam, "--view", "top", "--preset", preset, "--accepted", accepted, "-o", folder / "out")
            report = keiko.inspect(seam, preset, views="top", accepted=accepted)
            self.assertEqual(report.to_json(), (folder / "out/report.json").read_text(encoding="utf-8"))
            named = [Path(entry["path"]).name for entry in json.loads(report.to_json())["inputs"]]
            self.assertIn("limits.toml", named)
            self.assertIn("accepted.json", named)


if __name__ == "__main__":
    unittest.main()
