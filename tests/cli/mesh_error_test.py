"""keiko mesh-error, and the meshes that keiko render shows."""
import json
import sys
import unittest

from keiko_process import SOURCE, KeikoTest, surface

sys.path.append(str(SOURCE / "tests"))
from png_file import read_png  # noqa: E402

SCHEMA = json.loads((SOURCE / "docs" / "schema" / "keiko-mesh-error.schema.json").read_text())
DENT = surface("dent.step")
SMALL = ("--size", "240x160", "--view", "three-quarter-front", "-q")


class MeshTest(KeikoTest):
    def refuse(self, *arguments: str, mentioning: str):
        run = self.keiko(*arguments)
        self.assertEqual((run.returncode, run.stdout), (2, ""), arguments)
        self.assertEqual(run.stderr.count("\n"), 1, run.stderr)
        self.assertIn(mentioning, run.stderr)


class MeshError(MeshTest):
    def report(self, *arguments: str) -> dict:
        self.succeed("mesh-error", DENT, *SMALL, "-o", "out", *arguments)
        return json.loads((self.folder / "out" / "mesh-error.json").read_text())

    def test_errors_fall_with_the_deviation(self):
        report = self.report("--mesh", "1,0.05", "--json", "numbers.json")
        self.assertEqual(json.loads((self.folder / "numbers.json").read_text()), report)
        try:
            import jsonschema
            jsonschema.validate(report, SCHEMA)
        except ImportError:
            pass
        coarse, fine = report["meshes"]
        self.assertLess(coarse["triangles"], fine["triangles"])
        self.assertLessEqual(fine["deviation"], 0.05)
        coarse, fine = (mesh["errors"] for mesh in report["views"][0]["meshes"])
        self.assertGreater(coarse["compared"], 1000)
        self.assertGreater(coarse["displacement"]["pixels"]["p99"], 2 * fine["displacement"]["pixels"]["p99"])
        self.assertGreater(coarse["normal_arcsec"]["p99"], fine["normal_arcsec"]["p99"])
        self.assertEqual(fine["missed"]["inside"], 0)

    def test_averaged_normals_are_worse(self):
        own, averaged = (self.report("--mesh", "0.5", "--normals", normals)["views"][0]["meshes"][0]["errors"]
                         for normals in ("surface", "averaged"))
        self.assertGreater(averaged["normal_arcsec"]["p99"], 2 * own["normal_arcsec"]["p99"])

    def test_the_page_holds_all_its_pictures(self):
        report = self.report("--mesh", "1")
        page = (self.folder / "out" / "mesh-error.html").read_text()
        # Of the view: mesh, surface and wrong pixels, and both close-ups.
        self.assertEqual(page.count("data:image/png;base64,"), 5)
        self.assertNotIn("http://", page)
        view = report["views"][0]
        names = [view["truth"], view["close_up"]] + [view["meshes"][0][key] for key in ("mirror", "wrong", "close_up")]
        for name in names:
            self.assertTrue((self.folder / "out" / name).read_bytes().startswith(b"\x89PNG"), name)

    def test_any_number_of_threads_gives_the_same_bytes(self):
        files = []
        for threads in ("1", "4"):
            self.succeed("mesh-error", DENT, *SMALL, "--mesh", "0.2", "-o", threads, "--threads", threads)
            files.append({path.name: path.read_bytes() for path in (self.folder / threads).iterdir()})
        self.assertEqual(*files)

    def test_tells_that_nothing_was_compared(self):
        # Lamps below the part, which is seen from above and mirrors to the sky.
        (self.folder / "below.toml").write_text(
            'format = "keiko-rig/1"\nname = "below"\n[[c_plane]]\norigin = [-600, -210, -9000]\nu = [1200, 0, 0]\n'
            'v = [0, 420, 0]\nlamps = 6\npitch = 70\ndiameter = 26\nluminance = 9000\n')
        run = self.keiko("mesh-error", DENT, "--size", "240x160", "--view", "three-quarter-front", "--mesh", "1",
                         "--rig", "below.toml", "-o", "out")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("nothing was compared", run.stderr)
        self.assertIn("no pixel mirrors the lamps", run.stdout)
        self.assertNotIn("0.00 %", run.stdout)
        report = json.loads((self.folder / "out" / "mesh-error.json").read_text())
        self.assertIsNone(report["meshes"][0]["wrong_share"])
        self.assertIsNone(report["views"][0]["close_up"])
        self.assertIn("no pixel mirrors the lamps", (self.folder / "out" / "mesh-error.html").read_text())

    def test_proved_meshes_of_spans_take_fine_deviations(self):
        report = self.report("--mesh", "0.1,0.01,0.001", "--mesher", "spans")
        self.assertEqual((report["deviations"], self.report("--mesh", "1")["deviations"]), ("proved", "measured"))
        for mesh in report["meshes"]:
            self.assertLessEqual(mesh["deviation"], mesh["asked"])
        sizes = [mesh["errors"]["displacement"]["pixels"]["p99"] for mesh in report["views"][0]["meshes"]]
        self.assertGreater(sizes[0], 2 * sizes[1])
        self.assertGreater(sizes[1], 2 * sizes[2])

    def test_refuses_meshes_beyond_memory_in_one_line(self):
        self.refuse("mesh-error", surface("concept-car.step"), "--mesher", "spans", "--mesh", "0.00001", "-q",
                    "-o", "out", mentioning="its mesh within 1e-05 mm has more than 50000000 cells or triangles")

    def test_refuses_a_deviation_that_is_none(self):
        for mesh in ("0", "-1", "nan", "1,1"):
            self.refuse("mesh-error", DENT, "--mesh", mesh, "-o", "out", mentioning="--mesh")

    def test_refuses_a_rig_without_tubes(self):
        self.refuse("mesh-error", DENT, *SMALL, "--rig", str(SOURCE / "lightrigs" / "one-point.toml"), "-o", "out",
                    mentioning="no rows of tubes")


class MeshLook(MeshTest):
    def picture(self, *arguments: str) -> bytes:
        self.succeed("render", DENT, *SMALL, "-o", "picture.png", *arguments)
        return (self.folder / "picture.png").read_bytes()

    def test_each_shading_gives_a_picture_of_its_own(self):
        looks = ("lamps", "mesh:constant", "mesh:gouraud", "mesh:phong")
        pictures = [self.picture("--look", look) for look in looks]
        self.assertEqual(len(set(pictures)), len(looks))
        self.assertNotEqual(pictures[3], self.picture("--look", "mesh:phong", "--mesh", "2"))

    def test_facets_of_a_pixel_show_the_surface_itself(self):
        def samples(*arguments: str) -> bytes:
            self.picture("--ev", "9", *arguments)
            return read_png(self.folder / "picture.png")[3]

        exact = samples("--look", "lamps", "--edge-samples", "1")
        unlike = [sum(abs(a - b) > 16 for a, b in zip(exact, samples("--look", "mesh:phong", "--mesh", mesh)))
                  for mesh in ("1", "pixel")]
        self.assertGreater(unlike[0], len(exact) // 200)
        self.assertLess(unlike[1], unlike[0] // 4)
        pixel = ("--look", "mesh:phong", "--mesh", "pixel")
        self.assertEqual(samples(*pixel), samples(*pixel, "--hidden-surfaces", "z-buffer", "--mesh-shadows", "none"))

    def test_all_algorithms_show_the_same(self):
        pictures = {self.picture("--look", "mesh:phong", "--hidden-surfaces", by)
                    for by in ("z-buffer", "scan-line", "painter")}
        self.assertEqual(len(pictures), 1)

    def test_shadows_are_those_of_the_surface_by_every_algorithm(self):
        ball = surface("rational-sphere.step")
        (self.folder / "scene.toml").write_text(
            f'format = "keiko-scene/1"\nambient = 2000\n[[model]]\nfile = "{ball}"\nmaterial = "concrete"\n'
            '[ground]\nz = -140\nmaterial = "concrete"\n[sun]\ndirection = [-1, 0.5, -1.5]\nilluminance = 50000\n'
            '[camera]\neye = [900, 500, 500]\ntarget = [-60, 20, -60]\nvertical_fov = 30\nsize = [120, 80]\n')
        fixed = ("render", "scene.toml", "--ev", "12", "-q", "-o", "picture.png")

        def samples(*arguments: str) -> bytes:
            self.succeed(*fixed, *arguments)
            return read_png(self.folder / "picture.png")[3]

        def unlike(one: bytes, other: bytes) -> int:
            return sum(abs(a - b) > 8 for a, b in zip(one, other))

        exact = samples("--shadows", "--edge-samples", "1")
        bare = samples("--look", "mesh:phong", "--mesh", "0.05")
        shaded = {by: samples("--look", "mesh:phong", "--mesh", "0.05", "--mesh-shadows", by)
                  for by in ("none", "ray", "scan-line", "map", "polygons", "volumes")}
        self.assertEqual(bare, shaded.pop("none"))
        for by, picture in shaded.items():
            self.assertGreater(unlike(bare, picture), len(exact) // 80, by)
            self.assertLess(unlike(exact, picture), len(exact) // 200, by)

    def test_refuses_what_meshes_do_not_have(self):
        for wrong, named in ((("--look", "mesh:flat"), "mesh:constant, mesh:gouraud, mesh:phong"),
                             (("--look", "mesh:phong", "--shadows"), "--shadows"),
                             (("--look", "zebra", "--mesh", "1"), "--mesh"),
                             (("--look", "mesh:phong", "--mesh", "fine"), "--mesh"),
                             (("--look", "mesh:phong", "--mesh", "nan"), "--mesh"),
                             (("--look", "mesh:phong", "--mesh", "pixel", "--mesh-shadows", "ray"), "--mesh-shadows"),
                             (("--look", "mesh:phong", "--mesh", "pixel", "--hidden-surfaces", "painter"),
                              "--hidden-surfaces"),
                             (("--hidden-surfaces", "scan-line"), "--hidden-surfaces"),
                             (("--mesh-shadows", "ray"), "--mesh-shadows")):
            self.refuse("render", DENT, *SMALL, "-o", "picture.png", *wrong, mentioning=named)

    def test_refuses_scenes_that_meshes_would_show_in_part(self):
        casting = str(SOURCE / "surfaces" / "casting-scene.toml")
        self.refuse("render", casting, "--look", "mesh:phong", "--mesh", "1", "--size", "32x18",
                    "-o", "picture.png", mentioning="without volumes")
        caustics = str(SOURCE / "surfaces" / "caustics-scene.toml")
        self.refuse("render", caustics, "--look", "mesh:phong", "--mesh", "1", "--size", "32x18",
                    "-o", "picture.png", mentioning="without caustics")


if __name__ == "__main__":
    unittest.main()
