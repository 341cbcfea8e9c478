"""The Python module beside the command line, on the surfaces of the repository.

usage: module_test.py KEIKO
"""
import json
import os
import pickle
import re
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from pathlib import Path

import numpy as np

import keiko

ROOT = Path(__file__).resolve().parents[2]
CAR = ROOT / "surfaces/concept-car.step"
PROGRAM = sys.argv.pop(1)
SHEETS = "2\n1 1\n0 0 0\n0 100 0\n300 0 0\n300 100 0\n1 1\n0 0 0\n0 -100 {z}\n300 0 0\n300 -100 {z}\n"


def told(*arguments) -> bytes:
    return subprocess.run([PROGRAM, *map(str, arguments)], stdout=subprocess.PIPE, check=False).stdout


class PageTest(unittest.TestCase):
    def test_first_script_runs(self):
        page = (ROOT / "docs/python.md").read_text(encoding="utf-8")
        script = re.search(r"```python\n(.*?)```", page, re.S)[1]
        with tempfile.TemporaryDirectory() as folder:
            script = script.replace("build/car-report", folder + "/report")
            run = subprocess.run([sys.executable, "-c", script], cwd=ROOT, stdout=subprocess.PIPE, text=True,
                                 check=True)
            self.assertTrue((Path(folder) / "report/report.html").is_file())
        self.assertRegex(run.stdout, r"highest point \[.*\]\n(pass|undecided|fail) \d+ ")


class NotebookTest(unittest.TestCase):
    def test_cells_run_in_order(self):
        notebook = json.loads((ROOT / "docs/examples/hood.ipynb").read_text(encoding="utf-8"))
        cells = ["".join(cell["source"]) for cell in notebook["cells"] if cell["cell_type"] == "code"]
        self.assertGreaterEqual(len(cells), 5)
        names, before = {}, os.getcwd()
        os.chdir(ROOT)
        try:
            for cell in cells:
                *lines, last = cell.splitlines()
                exec("\n".join(lines), names)
                shown = eval(last, names)
                self.assertIsNotNone(shown, last)
        finally:
            os.chdir(before)
        self.assertTrue(names["found"].mean() > 0.5)
        self.assertIn(names["report"].verdict, ("pass", "undecided", "fail"))


class InstallTest(unittest.TestCase):
    def test_installed_package_needs_nothing_beside_it(self):
        build = Path(keiko.__file__).resolve().parents[2]
        with tempfile.TemporaryDirectory() as folder:
            install = subprocess.run(["cmake", "--install", build, "--component", "python", "--prefix", folder],
                                     stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
            self.assertEqual(install.returncode, 0, install.stdout)
            script = f"import keiko; print(keiko.__file__, len(keiko.open_scene({str(CAR)!r}).faces))"
            environment = {key: value for key, value in os.environ.items() if key != "KEIKO_IMPORT"}
            environment["PYTHONPATH"] = folder
            run = subprocess.run([sys.executable, "-B", "-c", script], env=environment, cwd=folder,
                                 stdout=subprocess.PIPE, text=True, check=True)
            where, faces = run.stdout.split()
            self.assertTrue(where.startswith(folder))
            self.assertEqual(int(faces), len(keiko.open_scene(CAR).faces))
            linked = subprocess.run(["ldd", *Path(folder, "keiko").glob("_keiko*.so")], stdout=subprocess.PIPE,
                                    text=True, check=True)
            self.assertIn(folder, re.search(r"libkeiko\S* => (\S+)", linked.stdout)[1])


class PytestTest(unittest.TestCase):
    def run_pytest(self, folder, *arguments):
        run = subprocess.run([sys.executable, "-B", "-m", "pytest", "-p", "keiko.pytest_plugin", "-p", "no:cacheprovider",
                              "-q", "-rA", "--keiko-output", folder / "out", folder, *arguments], cwd=folder,
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        return run.returncode, run.stdout

    def test_fixtures_are_items(self):
        try:
            import pytest  # noqa: F401
        except ImportError:
            self.skipTest("pytest is not installed")
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            (folder / "sheets.bpt").write_text(SHEETS.format(z=0.1), encoding="utf-8")
            (folder / "sheets.toml").write_text('format = "keiko-fixture/1"\nmodel = "sheets.bpt"\n'
                                                'checks = ["shape", "seams"]\nviews = []\n', encoding="utf-8")
            (folder / "settings.toml").write_text("format = 7\n", encoding="utf-8")
            code, text = self.run_pytest(folder)
            self.assertEqual(code, 1, text)
            self.assertIn("sheets has no baseline", text)
            code, text = self.run_pytest(folder, "--keiko-update", "first")
            self.assertEqual(code, 0, text)
            self.assertRegex(text, r"3 passed, 2 skipped", text)
            code, text = self.run_pytest(folder)
            self.assertEqual(code, 0, text)
            (folder / "sheets.bpt").write_text(SHEETS.format(z=0.3), encoding="utf-8")
            code, text = self.run_pytest(folder)
            self.assertEqual(code, 1, text)
            self.assertRegex(text, r"(?s)FAILED .*seams.*FAILED .*state", text)
            self.assertNotIn("settings", text)


class ModuleTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.sheets = Path(cls.folder.name) / "sheets.bpt"
        cls.sheets.write_text(SHEETS.format(z=1), encoding="utf-8")
        cls.scene = keiko.open_scene(cls.sheets)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_version_is_that_of_the_program(self):
        self.assertIn(keiko.version(), told("--version").decode())

    def test_scene_has_faces_and_bounds(self):
        self.assertEqual([face[0] for face in self.scene.faces], [1, 2])
        np.testing.assert_allclose(self.scene.bounds, [[0, -100, 0], [300, 100, 1]], atol=1e-9)
        self.assertEqual(self.scene.paths, [self.sheets])
        self.assertEqual(self.scene.lost_faces, [])

    def test_hits_of_planes_are_exact(self):
        rng = np.random.default_rng(1)
        count = 20000
        rays = np.column_stack([rng.uniform(-10, 310, count), rng.uniform(-110, 110, count), np.full(count, 50.0),
                                np.zeros((count, 2)), np.full(count, -2.0)])
        hits = self.scene.trace(rays)
        self.assertEqual(hits.dtype, keiko.hit_dtype)
        x, y = rays[:, 0], rays[:, 1]
        inside = (x > 0) & (x < 300) & (abs(y) < 100)
        np.testing.assert_array_equal(np.isfinite(hits["t"]), inside)
        z = np.where(y > 0, 0, -y / 100)
        np.testing.assert_allclose(hits["t"][inside], (50 - z[inside]) / 2, rtol=1e-12)
        np.testing.assert_array_equal(hits["face"][inside], np.where(y[inside] > 0, 1, 2))
        np.testing.assert_allclose(hits["position"][inside, 2], z[inside], atol=1e-10)
        np.testing.assert_allclose(abs(hits["k1"][inside]), 0, atol=1e-12)
        self.assertTrue((hits["bound"][inside] < 1e-6).all())
        self.assertTrue(np.isnan(hits["position"][~inside]).all())
        self.assertTrue((hits["face"][~inside] == 0).all())

    def test_hits_do_not_depend_on_threads_and_outlive_the_scene(self):
        scene = keiko.open_scene(CAR)
        low, high = scene.bounds
        rng = np.random.default_rng(2)
        origins = rng.uniform(low - 500, high + 500, (5000, 3))
        rays = np.hstack([origins, rng.uniform(low, high, (5000, 3)) - origins])
        hits = scene.trace(rays, threads=1)
        self.assertEqual(hits.tobytes(), scene.trace(rays, threads=2).tobytes())
        del scene
        found = hits[np.isfinite(hits["t"])]
        self.assertGreater(len(found), 1000)
        on_ray = rays[np.isfinite(hits["t"])]
        np.testing.assert_allclose(on_ray[:, :3] + found["t"][:, None] * on_ray[:, 3:], found["position"],
                                   atol=1e-5)
        np.testing.assert_allclose(np.linalg.norm(found["normal"], axis=1), 1, atol=1e-12)

    def test_hits_are_those_of_the_program(self):
        rays = np.array([[150, 50, 40, 0.1, 0.2, -1], [150, -50, 40, 0, 0, -1], [0, 0, -5, 0, 0, -1]])
        path = Path(self.folder.name) / "rays.csv"
        np.savetxt(path, rays, fmt="%.17g", delimiter=",")
        with open(path, "rb") as file:
            run = subprocess.run([PROGRAM, "trace", self.sheets, "--out", "t,face,x,y,z"], stdin=file,
                                 stdout=subprocess.PIPE, check=True)
        rows = run.stdout.decode().splitlines()[1:]
        self.assertEqual(len(rows), 3)
        hits = self.scene.trace(rays)
        for row, hit in zip(rows, hits):
            cells = row.split(",")
            if not cells[0]:
                self.assertEqual(hit["t"], np.inf)
                continue
            self.assertEqual([float(cells[0]), int(cells[1]), *map(float, cells[2:])],
                             [hit["t"], hit["face"], *hit["position"]])

    def test_rays_see_the_ground_as_those_of_the_program_do(self):
        path = Path(self.folder.name) / "ground.toml"
        path.write_text('format = "keiko-scene/1"\n[[model]]\nfile = "sheets.bpt"\n[ground]\nz = -60.0\n', encoding="utf-8")
        run = subprocess.run([PROGRAM, "trace", path, "--out", "t,face"], input=b"400,0,100,0,0,-1\n",
                             stdout=subprocess.PIPE, check=True)
        self.assertEqual(run.stdout.decode().splitlines()[1], "160,0")
        hit = keiko.open_scene(path).trace(np.array([[400, 0, 100, 0, 0, -1]]))[0]
        self.assertEqual((hit["t"], hit["face"]), (160, 0))

    def test_rays_of_another_shape_are_refused(self):
        with self.assertRaisesRegex(keiko.Error, "rays: an array of n rows of 6"):
            self.scene.trace(np.zeros((4, 5)))

    def test_rays_that_the_program_refuses_are_refused(self):
        good = [0, 0, 10, 0, 0, -1]
        for bad, reason in (([0, 0, 10, 0, 0, 0], "dx,dy,dz is no direction: all are 0"),
                            ([np.nan, 0, 10, 0, 0, -1], "ox,oy,oz is not finite"),
                            ([0, 0, 10, 0, 0, np.inf], "dx,dy,dz is not finite"),
                            ([0, 0, 1e14, 0, 0, -1], "ox,oy,oz is over 1e8 times the body's size away"),
                            ([0, 0, 1e16, 0, 0, -1], "ox,oy,oz ")):
            with self.assertRaisesRegex(keiko.Error, rf"rays\[2\]: {re.escape(reason)}"):
                self.scene.trace(np.array([good, good, bad]))
        lit = keiko.open_scene(ROOT / "surfaces/hood-scene.toml")
        with self.assertRaisesRegex(keiko.Error, r"points\[0\]: nx,ny,nz is no direction"):
            keiko.illuminance(lit, [[0, 0, 900]], [[0, 0, 0]])

    def test_check_is_that_of_the_program(self):
        checked = keiko.check(self.sheets)
        path = Path(self.folder.name) / "check.json"
        told("check", self.sheets, "--json", path, "-q")
        self.assertEqual(checked.to_json(), path.read_text(encoding="utf-8"))
        self.assertEqual(checked.verdict, "fail")
        self.assertEqual(checked.findings[0]["code"], "G-SU-NT")
        self.assertAlmostEqual(checked.seams[0]["angle"]["value"], np.degrees(np.arctan(0.01)), places=9)
        self.assertIn("G-SU-NT", checked._repr_html_())
        self.assertEqual(pickle.loads(pickle.dumps(checked)).to_dict(), checked.to_dict())
        self.assertEqual(keiko.check([self.sheets], "class-b").verdict, "fail")

    def test_a_part_is_judged_as_by_the_program(self):
        path = Path(self.folder.name) / "part.json"
        part = keiko.check(CAR, faces=["roof*", 7])
        told("check", CAR, "--faces", "roof*", "--faces", "7", "--json", path, "-q")
        self.assertEqual(part.to_json(), path.read_text(encoding="utf-8"))
        with self.assertRaisesRegex(keiko.Error, "no-such-layer"):
            keiko.check(CAR, layers="no-such-layer")
        with self.assertRaises(keiko.Error):
            keiko.check(CAR, colors="blue-ish")

    def test_curves_and_joints_are_those_of_the_program(self):
        line, folder = ROOT / "surfaces/shut-line.step", Path(self.folder.name)
        found = keiko.check(line, joints=True, sections="x=100", iso_curves=1, profiles=True)
        told("check", line, "--joints", "--section", "x=100", "--iso-curves", "1", "--combs", folder / "combs.json",
             "--profiles", folder / "profiles.json", "--json", folder / "joints.json", "-q")
        self.assertEqual(found.to_json(), (folder / "joints.json").read_text(encoding="utf-8"))
        self.assertEqual(found.combs, json.loads((folder / "combs.json").read_text())["curves"])
        self.assertEqual(found.profiles, json.loads((folder / "profiles.json").read_text())["profiles"])
        self.assertEqual(len(found.joints), 1)
        again = pickle.loads(pickle.dumps(found))
        self.assertEqual((again.combs, again.profiles), (found.combs, found.profiles))
        plain = keiko.check(line)
        self.assertEqual((plain.joints, plain.combs, plain.profiles), ([], [], []))
        report = keiko.inspect(line, views="top", joints=True, sections=["x=100"], close_ups=1)
        self.assertEqual(report.joints, found.joints)
        self.assertEqual(len(report.combs), 1)
        self.assertLessEqual(len(report.to_dict()["close_ups"]), 1)

    def test_accepted_findings_have_no_part_in_the_verdict(self):
        folder = Path(self.folder.name)
        (folder / "found.json").write_text(keiko.check(self.sheets).to_json(), encoding="utf-8")
        held = keiko.accept(folder / "found.json", 1, folder / "accepted.json", why="hidden", who="Ann")
        self.assertEqual(held, 1)
        entry, = json.loads((folder / "accepted.json").read_text())["accepted"]
        self.assertEqual((entry["why"], entry["who"]), ("hidden", "Ann"))
        accepting = keiko.check(self.sheets, accepted=folder / "accepted.json")
        self.assertEqual((accepting.verdict, accepting.findings), ("pass", []))
        keiko.inspect(self.sheets, views="top").write(folder / "report")
        fault = json.loads((folder / "report/report.json").read_text())["triage"]["items"][0]
        held = keiko.accept(folder / "report/report.json", 1, folder / "fault.json", why="hidden")
        self.assertEqual(held, len(fault["findings"]))
        held = keiko.accept(folder / "report/report.json", [], folder / "one.json", findings=fault["findings"][0], why="hidden")
        self.assertEqual(held, 1)
        with self.assertRaisesRegex(keiko.Error, "until"):
            keiko.accept(folder / "found.json", 1, folder / "accepted.json", why="again", until="2020-01-01")

    def test_inspect_is_that_of_the_program(self):
        out, ours = Path(self.folder.name) / "out", Path(self.folder.name) / "ours"
        told("inspect", self.sheets, "-o", out, "-q", "--view", "top")
        report = keiko.inspect(self.scene, views=["top"])
        report.write(ours)
        self.assertEqual(sorted(p.name for p in ours.iterdir()), sorted(p.name for p in out.iterdir()))
        for path in out.iterdir():
            self.assertEqual((ours / path.name).read_bytes(), path.read_bytes(), path.name)
        self.assertEqual(report.html, (out / "report.html").read_text(encoding="utf-8"))
        self.assertTrue(report._repr_html_().startswith("<iframe"))
        self.assertEqual(pickle.loads(pickle.dumps(report)).verdict, report.verdict)

    def test_a_report_replaces_the_one_before(self):
        ours = Path(self.folder.name) / "replaced"
        keiko.inspect(self.scene, views=["top"]).write(ours)
        (ours / "mine.txt").write_text("mine", encoding="utf-8")
        self.assertTrue((ours / "top-marked.png").is_file())
        keiko.inspect(self.scene, views=["high-left"]).write(ours)
        self.assertFalse((ours / "top-marked.png").exists())
        self.assertTrue((ours / "high-left-marked.png").is_file())
        self.assertTrue((ours / "mine.txt").is_file())

    def test_a_written_rig_finds_its_luminaires(self):
        luminaire = Path(self.folder.name) / "lamp.ies"
        luminaire.write_bytes((ROOT / "surfaces/road-lantern.ies").read_bytes())
        rig, out = Path(self.folder.name) / "lit.toml", Path(self.folder.name) / "deep" / "lit"
        rig.write_text('format = "keiko-rig/1"\n[[luminaire]]\nfile = "lamp.ies"\nposition = [0.0, 0.0, 3000.0]\n'
                       'aim = [0.0, 0.0, 0.0]\n', encoding="utf-8")
        report = keiko.inspect(self.scene, views=["top"], rig=rig)
        pickle.loads(pickle.dumps(report)).write(out)
        ours = (out / "rig.toml").read_bytes()
        told("inspect", self.sheets, "-o", out, "--view", "top", "--rig", rig, "-q")
        self.assertEqual(ours, (out / "rig.toml").read_bytes())
        self.assertIn(b"lamp.ies", ours)

    def test_findings_are_what_the_verdict_rests_on(self):
        car = keiko.check(CAR)
        self.assertEqual(car.verdict, "pass")
        self.assertEqual(car.findings, [])
        self.assertGreater(len(car.looks), 0)
        self.assertEqual(len(car.findings) + len(car.looks), len(car.to_dict()["findings"]))
        self.assertIn(f"{len(car.looks)} looks", repr(car))

    def test_pictures_have_the_size_and_the_ground_of_the_program(self):
        scene = Path(self.folder.name) / "camera.toml"
        scene.write_text('format = "keiko-scene/1"\n[[model]]\nfile = "sheets.bpt"\n[ground]\nz = -60.0\n[camera]\n'
                         'eye = [-500.0, -900.0, 700.0]\ntarget = [150.0, 0.0, 0.0]\n', encoding="utf-8")
        path = Path(self.folder.name) / "sized.png"
        opened = keiko.open_scene(scene)
        for view in ("", "scene", "standing-left", "auto"):
            named = ["--view", view] if view else []
            told("render", scene, *named, "--size", "64x36", "-o", path, "-q")
            film = keiko.render(opened, view, width=64, height=36)
            self.assertEqual(np.asarray(film).shape, (36, 64, 3), view)
            self.assertEqual(film._repr_png_(), path.read_bytes(), view)
        told("render", self.sheets, "--size", "64x36", "-o", path, "-q")
        self.assertEqual(keiko.render(self.sheets, width=64, height=36)._repr_png_(), path.read_bytes())

    def test_deep_buffers_hold_what_pictures_show(self):
        film = keiko.render(self.scene, "top", width=64, height=36, aovs=["depth", "normal", "face"])
        deep = keiko.deep_view(self.scene, "top", width=64, height=36)
        samples = deep.samples
        self.assertEqual(samples.shape, (36, 64))
        self.assertTrue((samples["t"] == film.aovs["depth"][:, :, 0]).all())
        seen = np.isfinite(samples["t"])
        self.assertTrue(0.3 < seen.mean() < 1)
        self.assertTrue((samples["face"][~seen] == 0).all() and (samples["face"][seen] >= 1).all())
        size = np.abs(film.aovs["normal"]).sum(axis=2)
        upper = seen & (film.aovs["normal"][:, :, 2] > 0)  # the eye is above, and so are facing normals
        place = film.aovs["normal"][:, :, 0][upper] / size[upper]
        self.assertLess(np.abs(samples["normal_x"][upper] - place).max(), 1e-6)
        self.assertEqual(deep.bounces.dtype.names, ("pixel", "sample"))
        one = keiko.deep_view(self.scene, "top", width=64, height=36, reflections=1)
        self.assertTrue((one.samples["way"] == samples["way"]).all())
        self.assertEqual(len(one.bounces), 0)
        with self.assertRaises(keiko.Error):
            keiko.deep_view(self.scene, "top", reflections=9)
        del deep
        self.assertTrue(np.isfinite(samples["t"][seen]).all(), "the array keeps the buffer")

    def test_pictures_are_arrays(self):
        film = keiko.render(self.scene, "top", width=64, height=36, aovs=["depth", "normal"])
        picture = np.asarray(film)
        self.assertEqual((picture.shape, picture.dtype), ((36, 64, 3), np.float32))
        self.assertTrue(np.isfinite(picture).all())
        self.assertGreater(film.alpha.mean(), 0.3)
        self.assertEqual(film.aovs["normal"].shape, (36, 64, 3))
        self.assertEqual(film._repr_png_()[1:4], b"PNG")
        path = Path(self.folder.name) / "picture.png"
        told("render", self.sheets, "--view", "top", "--size", "64x36", "-o", path, "-q")
        self.assertEqual(film._repr_png_(), path.read_bytes())
        color = film.color
        del film
        self.assertTrue(np.isfinite(color).all(), "the array keeps the film")

    def test_placed_lamps_serve_lines(self):
        placed = keiko.place(self.scene, views=["top"])
        rig = Path(self.folder.name) / "placed.toml"
        told("place", self.sheets, "-o", rig, "--view", "top", "-q")
        self.assertEqual(placed.rig.text, rig.read_text(encoding="utf-8"))
        self.assertEqual(placed.rig, keiko.Rig.read(rig))
        self.assertGreater(placed.coverage, 0.9)
        lines = keiko.lines(self.scene, rig, views=["top"])
        path = Path(self.folder.name) / "lines.json"
        told("lines", self.sheets, "--rig", rig, "--view", "top", "-o", path, "-q")
        self.assertEqual(lines.to_json(), path.read_text(encoding="utf-8"))
        self.assertEqual(lines.verdict, "pass")
        at_hand = pickle.loads(pickle.dumps(placed.rig))
        self.assertEqual(keiko.lines(self.scene, at_hand, views=["top"]).to_json(), lines.to_json())
        by_file = keiko.render(self.scene, "top", rig=rig, width=32, height=18)
        np.testing.assert_array_equal(by_file, keiko.render(self.scene, "top", rig=at_hand, width=32, height=18))
        report = keiko.inspect(self.scene, views=["top"], rig=at_hand, close_ups=0)
        self.assertEqual(keiko.Rig(report._files["rig.toml"].decode()), at_hand)
        with self.assertRaisesRegex(keiko.Error, "^rig:1"):
            keiko.Rig("nothing")
        self.assertEqual(sum(lines.to_dict()["counts"].values()), 0, "the lamps run along the seam")
        with self.assertRaises(keiko.Error):
            keiko.lines(self.scene)

    def test_comparison_is_that_of_the_program(self):
        path, revised = Path(self.folder.name) / "compare.json", Path(self.folder.name) / "revised.bpt"
        revised.write_text(SHEETS.format(z=1.5), encoding="utf-8")
        told("compare", self.sheets, revised, "--json", path, "-q")
        compared = keiko.compare(self.sheets, revised)
        self.assertEqual(compared.to_json(), path.read_text(encoding="utf-8"))
        self.assertNotEqual(compared.verdict, keiko.compare(self.sheets, self.sheets).verdict)

    def test_info_is_that_of_the_program(self):
        facts = keiko.info(self.sheets)
        self.assertEqual(facts.to_json(), told("info", self.sheets, "--json", "-q").decode())
        self.assertEqual(facts.to_dict()["faces"], 2)

    def test_regress_is_that_of_the_program(self):
        suite = ROOT / "surfaces"
        ours, out = Path(self.folder.name) / "regress", Path(self.folder.name) / "regress-program"
        name = "seam-g0-gap"
        found = keiko.regress(suite, ours, only=[name])
        told("regress", suite, "-o", out, "--only", name, "-q")
        self.assertEqual(found.to_json(), (ours / "regression.json").read_text(encoding="utf-8"))
        values, of_program = found.to_dict(), json.loads((out / "regression.json").read_bytes())
        self.assertNotEqual(values.pop("suite_key"), of_program.pop("suite_key"), "of another binary")
        self.assertEqual(values, of_program)
        self.assertIn(found.state, ("same", "different", "missing"))

    def test_illuminance_is_that_of_the_program(self):
        scene = ROOT / "surfaces/hood-scene.toml"
        points, normals = [[0, 0, 900], [100, 50, 950.5]], [[0, 0, 1], [0, 0.6, 0.8]]
        found = keiko.illuminance(keiko.open_scene(scene), points, normals)
        text = "".join(",".join(map(str, p + n)) + "\n" for p, n in zip(points, normals))
        run = subprocess.run([PROGRAM, "illuminance", scene], input=text.encode(), stdout=subprocess.PIPE, check=True)
        header, *rows = run.stdout.decode().splitlines()
        self.assertEqual(list(found.dtype.names), header.split(","))
        self.assertEqual([list(row) for row in found.tolist()], [list(map(float, row.split(","))) for row in rows])
        self.assertGreater(found["sum"].min(), 0)

    def test_lamps_at_hand_light_points(self):
        scene = keiko.open_scene(ROOT / "surfaces/hood-scene.toml")
        points, normals = np.array([[0, 0, 900], [100, 50, 950]]), np.array([[0, 0, 1], [0, 0, 2]])
        rig = keiko.place(self.scene, views=["top"]).rig
        found = keiko.illuminance(scene, points, normals, rig=rig)
        self.assertEqual(found.shape, (2,))
        self.assertEqual(sum(name.startswith("c_plane.") for name in found.dtype.names), len(found.dtype.names) - 1)
        np.testing.assert_allclose(sum(found[name] for name in found.dtype.names[:-1]), found["sum"], rtol=1e-12)
        one = keiko.illuminance(scene, points, normals, rig=rig, threads=1)
        np.testing.assert_array_equal(found, one)
        self.assertNotEqual(found["sum"][0], keiko.illuminance(scene, points, normals)["sum"][0])
        with self.assertRaisesRegex(keiko.Error, "rig: the scene has no lamps"):
            keiko.illuminance(self.scene, points, normals)
        with self.assertRaisesRegex(keiko.Error, r"points\[1\]"):
            keiko.illuminance(scene, points, normals * [[1], [0]])

    def test_a_model_serves_every_verb(self):
        model = keiko.load(self.sheets)
        revised = Path(self.folder.name) / "moved.bpt"
        revised.write_text(SHEETS.format(z=1.5), encoding="utf-8")
        again = pickle.loads(pickle.dumps(model))
        self.assertEqual(model.faces, self.scene.faces)
        for one in (model, again, self.scene):
            self.assertEqual(keiko.check(one).to_json(), keiko.check(self.sheets).to_json())
            self.assertEqual(keiko.info(one).to_json(), keiko.info(self.sheets).to_json())
            self.assertEqual(keiko.compare(one, revised).to_json(), keiko.compare(self.sheets, revised).to_json())
        rays = np.array([[100, 50, 500, 0, 0, -1.0], [100, -50, 500, 0, 0, -1.0]])
        scene = keiko.open_scene(again)
        np.testing.assert_array_equal(scene.trace(rays), self.scene.trace(rays))
        np.testing.assert_array_equal(pickle.loads(pickle.dumps(scene)).trace(rays), self.scene.trace(rays))
        with self.assertRaisesRegex(keiko.Error, "^unit: "):
            keiko.open_scene(model, unit="m")
        for verb in keiko.check, keiko.info:
            with self.assertRaisesRegex(keiko.Error, "^axes: "):
                verb(model, axes="y-up")
        with self.assertRaisesRegex(keiko.Error, "no file is named"):
            keiko.load([])

    def test_bytes_are_a_model(self):
        model = keiko.load(self.sheets.read_bytes(), name="sheets in memory")
        self.assertEqual(model.source, "sheets in memory")
        self.assertEqual(keiko.check(model).verdict, keiko.check(self.sheets).verdict)
        self.assertIn("sheets in memory", keiko.inspect(model, views=["top"], close_ups=0).html)
        with self.assertRaises(keiko.Error) as caught:
            keiko.load(b"nothing of a model")
        self.assertEqual(caught.exception.file, "bytes")

    def test_curves_that_were_written_are_read(self):
        path = Path(self.folder.name) / "seams.step"
        told("check", self.sheets, "--curves", path, "-q")
        curves = keiko.read_curves(path)
        self.assertGreater(len(curves), 0)
        for curve in curves:
            self.assertTrue(curve.name)
            for piece in curve.pieces:
                self.assertEqual(len(piece.knots), len(piece.points) + piece.degree + 1)
                self.assertEqual(piece.points.shape[1], 4)
        ends = np.vstack([piece.points[[0, -1], :3] for piece in curves[0].pieces])
        np.testing.assert_allclose(ends[:, 1:], 0, atol=1e-6)  # the seam runs along x
        with self.assertRaises(keiko.Error):
            keiko.read_curves(self.sheets)

    def test_scenes_are_picklable(self):
        again = pickle.loads(pickle.dumps(self.scene))
        np.testing.assert_array_equal(again.bounds, self.scene.bounds)

    def test_errors_have_parts(self):
        missing = Path(self.folder.name) / "missing.step"
        with self.assertRaises(keiko.Error) as caught:
            keiko.open_scene(missing)
        self.assertEqual(caught.exception.file, str(missing))
        self.assertTrue(caught.exception.reason)
        self.assertIsInstance(caught.exception, ValueError)
        with self.assertRaises(keiko.Error):
            keiko.check(self.sheets, "no-such-preset")
        for wrong in (7, [1, 2], [self.sheets, None], b"bytes"):
            with self.assertRaises(TypeError):
                keiko.open_scene(wrong)
        with self.assertRaisesRegex(keiko.Error, "no file is named"):
            keiko.open_scene([])

    def test_everything_public_is_explained(self):
        dumb = []
        for name in keiko.__all__:
            given = getattr(keiko, name)
            if not callable(given):
                continue
            parts = vars(given).items() if isinstance(given, type) else ()
            for part, meaning in [("", given), *((p, m) for p, m in parts if not p.startswith("_"))]:
                words = re.sub(r"^\w+\(.*\n*", "", meaning.__doc__ or "")  # what pybind11 writes by itself
                if not words.strip():
                    dumb.append(f"{name}.{part}")
        self.assertEqual(dumb, [])

    def test_arguments_of_a_wrong_type_are_named(self):
        wrong = [(keiko.check, self.sheets, {"join": "wide"}, "join: a number is needed, not 'wide'"),
                 (keiko.check, self.sheets, {"joints": "yes"}, "joints: True or False is needed"),
                 (keiko.check, self.sheets, {"iso_curves": 1.5}, "iso_curves: a whole number"),
                 (keiko.check, self.sheets, {"accepted": 7}, "accepted: a path or None"),
                 (keiko.lines, self.scene, {"look": 3}, "look: a text is needed, not 3"),
                 (keiko.compare, self.sheets, {"after": self.sheets, "width": None}, "width: a whole number"),
                 (keiko.render, self.scene, {"light_error": "low"}, "light_error: a number")]
        for verb, body, arguments, words in wrong:
            with self.assertRaisesRegex(TypeError, f"^{re.escape(words)}"):
                verb(body, **arguments, **({"views": ()} if "width" in arguments else {}))
        for settings in ({"pull": (0, 1)}, {"pull": "up "[:2]}, {"scale": 1.0}, {"radius": "small"}, {"draft": None}):
            (name,) = settings
            with self.assertRaisesRegex(TypeError, f"^{name}: "):
                keiko.analysis_picture(self.scene, "zebra", **settings)
        with self.assertRaisesRegex(TypeError, "^scale: two numbers or None is needed, not [^\n]*$"):
            keiko.analysis_picture(self.scene, "zebra", scale=np.zeros((2, 2)))
        with self.assertRaisesRegex(TypeError, "^a path is needed, not [^\n]{,63}$"):
            keiko.load({"wide": "é" * 500})
        for join in (0, -1, 1e4, float("nan")):
            for verb in (keiko.check, keiko.lines, keiko.info):
                with self.assertRaisesRegex(keiko.Error, "^join: is not 1e-6 to 1000 mm"):
                    verb(self.sheets, join=join)

    def test_numbers_out_of_range_and_other_shapes_are_refused(self):
        points, normals = np.zeros((2, 3)), np.ones((2, 3))
        rig = ROOT / "lightrigs/tunnel-12.toml"
        wrong = [(keiko.illuminance, (self.scene, points, normals[:1]), {"rig": rig}, "normals: are 1, of 2 points"),
                 (keiko.illuminance, (self.scene, np.zeros((2, 2)), np.ones((2, 4))), {"rig": rig}, "points: "),
                 (keiko.illuminance, (self.scene, [["a", 0, 0]], normals[:1]), {"rig": rig}, "points: "),
                 (keiko.illuminance, (self.scene, points * 1j, normals), {"rig": rig}, "points: "),
                 (keiko.luminance, (self.scene, [[1, 2], [3]]), {"rig": rig}, "rays: "),
                 (self.scene.trace, ([["0"] * 6],), {}, "rays: "), (self.scene.trace_all, (np.zeros((3, 5)),), {}, "rays: "),
                 (self.scene.trace, ([[10 ** 400, 0, 0, 0, 0, 1]],), {}, "rays: "),
                 (keiko.compare_scan, (self.scene, [["a", "b", "c"]]), {}, "scan: "),
                 (keiko.compare_scan, (self.scene, 5), {}, "scan: "),
                 (keiko.compare_scan, (self.scene, points), {"reach": -1}, "reach: "),
                 (keiko.read_scan, ("a.xyz",), {"millimetres": float("nan")}, "millimetres: "),
                 (keiko.mesh, (self.scene,), {"reach": float("nan")}, "reach: "),
                 (keiko.place, (self.scene,), {"lamps": -1}, "lamps: "), (keiko.place, (self.scene,), {"planes": 0}, "planes: "),
                 (keiko.place, (self.scene,), {"lamp": "bulb"}, "lamp: is tube, panel or screen"),
                 (keiko.check, (self.sheets,), {"iso_curves": -1}, "iso_curves: "),
                 (keiko.check, (self.sheets,), {"threads": -1}, "threads: "),
                 (keiko.compare, (self.sheets, self.sheets), {"views": (), "width": 10 ** 6, "height": 9}, "width: "),
                 (keiko.accept, ("report.json", 1, "out.json"), {"why": " "}, "why: is empty"),
                 (keiko.load, (self.sheets.read_text(),), {}, "input: is a text of several lines"),
                 (keiko.Curve, ("x", keiko.check(self.sheets, curves=True).curves[0].pieces), {"deviation": float("nan")}, "deviation: ")]
        for verb, inputs, arguments, words in wrong:
            with self.assertRaisesRegex(keiko.Error, f"^{re.escape(words)}", msg=words):
                verb(*inputs, **arguments)
        for path in ("bad\0name.step", None, 7, open(os.devnull, encoding="utf-8")):
            with self.assertRaisesRegex(TypeError, "^a path is needed"):
                keiko.load(path)
        with self.assertRaisesRegex(TypeError, "^threads: a whole number is needed, not 1.5$"):
            keiko.load(self.sheets, threads=1.5)
        mesh = keiko.mesh(self.scene, "k1")
        for span in ((1, 0), (0, 0), (float("nan"), 1)):
            with self.assertRaisesRegex(keiko.Error, "^range: "):
                mesh.ply(span)
        self.assertNotIn("check_json", dir(keiko))
        self.assertIn("check", dir(keiko))

    def test_progress_is_told_and_may_stop(self):
        stages = []
        keiko.open_scene(CAR, progress=lambda stage, share: stages.append((stage, share)))
        self.assertTrue(stages)
        self.assertTrue(all(0 <= share <= 1 for _, share in stages))

        def refuse(stage, share):
            raise RuntimeError("enough")
        with self.assertRaisesRegex(RuntimeError, "enough"):
            keiko.inspect(CAR, progress=refuse)

    def test_progress_of_a_comparison_never_falls(self):
        shares = []
        keiko.compare(CAR, CAR, progress=lambda stage, share: shares.append(share))
        self.assertGreater(len(shares), 2)
        self.assertEqual(shares, sorted(shares))

    def test_interrupts_end_long_work(self):
        def interrupt():
            time.sleep(1.0)
            os.kill(os.getpid(), signal.SIGINT)
        begin = time.monotonic()
        threading.Thread(target=interrupt).start()
        with self.assertRaises(KeyboardInterrupt):
            while True:
                keiko.inspect(CAR)
        self.assertLess(time.monotonic() - begin, 30)

    def test_other_threads_run_meanwhile(self):
        count = 0
        done = threading.Event()

        def work():
            keiko.open_scene(CAR)
            done.set()
        thread = threading.Thread(target=work)
        thread.start()
        while not done.wait(0.001):
            count += 1
        thread.join()
        self.assertGreater(count, 10)


class ScanTest(unittest.TestCase):
    """Points over a plate of 100 x 100 mm at height 0, its outside upwards."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.plate = Path(self.folder.name) / "plate.bpt"
        self.plate.write_text("1\n1 1\n0 0 0\n0 100 0\n100 0 0\n100 100 0\n", encoding="utf-8")
        x, y = (axis.ravel() for axis in np.meshgrid(np.linspace(1, 99, 50), np.linspace(1, 99, 50)))
        self.points = np.column_stack([x, y, np.where(x < 25, 0.3, -0.05)])

    def test_deviations_are_an_array_in_the_order_of_the_points(self):
        compared = keiko.compare_scan(self.plate, self.points, tolerance=0.1, align=False, threads=1)
        np.testing.assert_allclose(compared.deviations["distance"], self.points[:, 2], atol=1e-12)
        np.testing.assert_allclose(compared.deviations["closest"][:, :2], self.points[:, :2], atol=1e-9)
        self.assertTrue((compared.deviations["face"] == 1).all())
        self.assertEqual(compared.verdict, "fail")
        self.assertAlmostEqual(compared.to_dict()["within"], np.mean(self.points[:, 0] >= 25))
        self.assertIn("histogram", compared._repr_html_())
        self.assertEqual(pickle.loads(pickle.dumps(compared)).to_json(), compared.to_json())
        judged = keiko.compare_scan(self.plate, self.points, tolerance=0.1, least_share=0.5, align=False)
        self.assertEqual(judged.verdict, "pass")

    def test_a_file_gives_what_the_command_line_writes(self):
        scan, path = Path(self.folder.name) / "scan.xyz", Path(self.folder.name) / "scan.json"
        np.savetxt(scan, self.points)
        np.testing.assert_array_equal(keiko.read_scan(scan), np.loadtxt(scan))
        np.testing.assert_array_equal(keiko.read_scan(scan, millimetres=10), 10 * np.loadtxt(scan))
        told("compare", self.plate, scan, "--tolerance", "0.1", "--json", path, "-q")
        self.assertEqual(keiko.compare_scan(self.plate, scan, tolerance=0.1).to_json(),
                         path.read_text(encoding="utf-8"))

    def test_wrong_arguments_are_refused(self):
        for points, options in ((np.zeros((3, 2)), {}), (np.zeros((0, 3)), {}), (np.full((2, 3), np.nan), {}),
                                (self.points, {"tolerance": -1}), (self.points, {"least_share": 2})):
            with self.assertRaises(keiko.Error):
                keiko.compare_scan(self.plate, points, **options)


class MeshTest(unittest.TestCase):
    def test_corners_lie_on_the_exact_surface(self):
        sphere = ROOT / "surfaces/rational-sphere.step"
        mesh = keiko.mesh(sphere, ["mean", "draft"], deviation=0.5)
        np.testing.assert_allclose(np.linalg.norm(mesh.points, axis=1), 100, atol=1e-9)
        np.testing.assert_allclose(mesh.normals * 100, mesh.points, atol=1e-5)
        np.testing.assert_allclose(np.sin(np.radians(mesh.fields["draft"])), mesh.points[:, 2] / 100, atol=1e-7)
        self.assertEqual(mesh.triangles.shape, (len(mesh.faces), 3))
        self.assertTrue(0 < mesh.deviation <= 0.5)
        self.assertEqual(mesh.lost_faces, [])
        self.assertTrue(mesh.vtp().startswith(b"<?xml") and mesh.ply().startswith(b"ply\n"))
        self.assertTrue(mesh.glb((-0.1, 0.1)).startswith(b"glTF"))

    def test_the_deviation_is_that_from_another_body(self):
        dome = ROOT / "surfaces/dome.bpt"
        mesh = keiko.mesh(dome, "deviation", against=keiko.open_scene(dome))
        np.testing.assert_allclose(mesh.fields["deviation"], 0, atol=1e-8)
        with self.assertRaisesRegex(keiko.Error, "against"):
            keiko.mesh(dome, "deviation")


class MeshErrorTest(unittest.TestCase):
    dent = ROOT / "surfaces/dent.step"
    small = {"views": "three-quarter-front", "width": 240, "height": 160}

    def test_it_is_what_the_command_line_writes(self):
        errors = keiko.mesh_error(self.dent, [1, 0.2], **self.small)
        with tempfile.TemporaryDirectory() as folder:
            told("mesh-error", self.dent, "--size", "240x160", "--view", "three-quarter-front", "--mesh", "1,0.2", "-o",
                 f"{folder}/program", "-q")
            errors.write(f"{folder}/module")
            program, module = (sorted(Path(folder, name).iterdir()) for name in ("program", "module"))
            self.assertEqual([path.name for path in program], [path.name for path in module])
            for one, other in zip(program, module):
                if one.name in ("mesh-error.json", "mesh-error.html"):
                    continue  # they name the files as each was called
                self.assertEqual(one.read_bytes(), other.read_bytes(), one.name)
            written = json.loads((Path(folder) / "program/mesh-error.json").read_text())
        self.assertEqual(written["views"], errors.to_dict()["views"])
        self.assertIn("data:image/png;base64,", errors.html)
        self.assertEqual(pickle.loads(pickle.dumps(errors)).to_json(), errors.to_json())

    def test_figures_have_a_row_a_view_and_mesh(self):
        errors = keiko.mesh_error(self.dent, [0.1, 0.01], mesher="spans", rig=ROOT / "lightrigs/tunnel-12.toml",
                                  **{**self.small, "views": ["three-quarter-front", "top"]})
        figures = errors.figures
        self.assertEqual(list(zip(figures["view"], figures["asked"])),
                         [(view, asked) for view in ("three-quarter-front", "top") for asked in (0.1, 0.01)])
        for row, mesh in zip(figures, [mesh for view in errors.to_dict()["views"] for mesh in view["meshes"]]):
            told_errors = mesh["errors"]
            self.assertEqual(row["wrong"], told_errors["wrong"])
            self.assertEqual(row["missed_inside"], told_errors["missed"]["inside"])
            self.assertEqual(row["on_part_p99"], told_errors["displacement"]["on_part"]["p99"])
            self.assertEqual(row["band_gouraud"], mesh["facet_bands"]["gouraud"])
        for i, mesh in enumerate(errors.meshes):
            of_mesh = figures[figures["asked"] == mesh["asked"]]
            self.assertAlmostEqual(of_mesh["wrong"].sum() / of_mesh["compared"].sum(), mesh["wrong_share"])
            self.assertLessEqual(mesh["deviation"], mesh["asked"])
        self.assertGreater(figures["pixels_p99"][0], 2 * figures["pixels_p99"][1])
        self.assertEqual(errors.to_dict()["deviations"], "proved")

    def test_figures_of_a_view_without_lamps_are_no_numbers(self):
        row, = keiko.mesh_error(self.dent, 0.1, mesher="spans", rig=ROOT / "lightrigs/tunnel-12.toml",
                                **{**self.small, "views": "bottom"}).figures
        self.assertEqual((row["compared"], row["wrong"]), (0, 0))
        sizes = [f"{size}_{of}" for size in ("pixels", "on_part", "at_lamps", "normal")
                 for of in ("median", "p99", "largest")]
        self.assertTrue(all(np.isnan(row[name]) for name in sizes))
        self.assertGreater(row["band_places"], 0)
        self.assertGreater(row["band_constant"], 0)

    def test_meshes_are_of_any_iterable(self):
        several = (deviation for deviation in (0.5, np.float32(0.25)))
        for mesh, asked in ((several, [0.5, 0.25]), (np.array(0.5), [0.5]), (1, [1])):
            errors = keiko.mesh_error(self.dent, mesh, mesher="spans", **self.small)
            self.assertEqual([one["asked"] for one in errors.meshes], asked)

    def test_wrong_arguments_are_refused(self):
        for options, field in (({"mesh": 0}, "mesh"), ({"mesh": []}, "mesh"), ({"mesh": [1, 1]}, "mesh"),
                               ({"mesher": "delaunay"}, "mesher"), ({"normals": "flat"}, "normals"),
                               ({"width": 100}, "width"), ({"views": ["inside"]}, "inside"),
                               ({"rig": ROOT / "lightrigs/one-point.toml"}, "no rows of tubes")):
            with self.assertRaisesRegex(keiko.Error, field):
                keiko.mesh_error(self.dent, **options)
        with self.assertRaisesRegex(TypeError, "mesher"):
            keiko.mesh_error(self.dent, mesher=3)
        for wrong in ("0.1", None, [True], [[1]]):
            with self.assertRaisesRegex(TypeError, "mesh"):
                keiko.mesh_error(self.dent, wrong)


class DrawingTest(unittest.TestCase):
    block = ROOT / "surfaces/bored-block.step"

    def test_it_is_what_the_command_line_writes(self):
        drawing = keiko.draw(self.block, hidden="dash", sections=["z=10"], paper="A4")
        self.assertIn("sections", drawing.layers)
        with tempfile.TemporaryDirectory() as folder:
            for ending, content in (("svg", drawing.svg().encode()), ("dxf", drawing.dxf()), ("pdf", drawing.pdf())):
                path, written = Path(folder) / f"sheet.{ending}", Path(folder) / f"written.{ending}"
                told("draw", self.block, "-o", path, "--hidden", "dash", "--section", "z=10", "--paper", "A4", "-q")
                drawing.write(written)
                self.assertEqual(content, path.read_bytes())
                self.assertEqual(content, written.read_bytes())
            with self.assertRaisesRegex(keiko.Error, "svg"):
                drawing.write(Path(folder) / "sheet.png")

    def test_wrong_arguments_are_refused(self):
        for options, field in (({"hidden": "blur"}, "hidden"), ({"without": ["ink"]}, "without"),
                               ({"paper": "B5"}, "paper"), ({"crease": 200}, "crease"), ({"iso_curves": -1}, "iso"),
                               ({"join": 0}, "join"), ({"views": ["inside"]}, "inside")):
            with self.assertRaisesRegex(keiko.Error, field):
                keiko.draw(self.block, **options)


if __name__ == "__main__":
    unittest.main()
