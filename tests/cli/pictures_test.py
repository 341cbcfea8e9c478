"""`keiko render` and `keiko place`: the files they write, byte by byte."""
import struct
import unittest

from keiko_process import SMALL, SOURCE, KeikoTest, surface

HOOD = surface("hood.step")


class Pictures(KeikoTest):
    def written(self, name: str, *arguments: str) -> bytes:
        self.succeed("render", HOOD, "-o", name, "-q", *SMALL, *arguments)
        return (self.folder / name).read_bytes()

    def refused(self, *arguments: str, told: str):
        run = self.keiko(*arguments)
        self.assertEqual(run.returncode, 2, arguments)
        self.assertIn(told, run.stderr)

    def test_a_png_of_the_size_asked_for(self):
        png = self.written("a.png")
        self.assertEqual(png[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(struct.unpack(">II", png[16:24]), (64, 36))
        self.assertEqual(self.content(), ["a.png"])

    def test_an_exr_with_the_layers_asked_for(self):
        plain, layers = self.written("a.exr"), self.written("b.exr", "--aov", "normal,depth")
        for exr in plain, layers:
            self.assertEqual(exr[:4], b"\x76\x2f\x31\x01")
        self.assertNotIn(b"normal.X\0", plain)
        self.assertIn(b"normal.X\0", layers)

    def test_two_runs_and_any_number_of_threads_give_the_same_bytes(self):
        for name in "png", "exr":
            first = self.written(f"1.{name}", "--threads", "1")
            self.assertEqual(first, self.written(f"2.{name}", "--threads", "1"))
            self.assertEqual(first, self.written(f"3.{name}", "--threads", "2"))
            self.assertEqual(first, self.written(f"4.{name}"))

    def test_the_view_the_paint_and_the_exposure_count(self):
        base = ("--view", "front", "--ev", "8")
        others = (("--view", "top", "--ev", "8"), (*base[:3], "9"), (*base, "--material", "white"),
                  (*base[:2], "--false-color"), (*base, "--tone", "log"), (*base, "--tone", "reinhard"),
                  (*base, "--edge-samples", "1"))
        first = self.written("a.png", *base)
        for other in others:
            self.assertNotEqual(first, self.written("b.png", *other), other)

    def test_two_eyes_see_two_pictures(self):
        png = self.written("both.png", "--stereo", "side-by-side")
        self.assertEqual(struct.unpack(">II", png[16:24]), (128, 36))
        red_and_cyan = self.written("red.png", "--stereo", "anaglyph")
        self.assertEqual(struct.unpack(">II", red_and_cyan[16:24]), (64, 36))
        for other in (("--eye-distance", "30"), ("--screen-distance", "1800")):
            self.assertNotEqual(red_and_cyan, self.written("b.png", "--stereo", "anaglyph", *other))
        self.assertIn(b"depth.Z\0", self.written("both.exr", "--stereo", "side-by-side", "--aov",
                                                 "depth"))
        for options, told in (
                (("--stereo", "anaglyph", "--aov", "depth"),
                 "--aov: an anaglyph has no layers: --stereo side-by-side has"),
                (("--stereo", "anaglyph", "--look", "zebra"),
                 "--look zebra: shows the surface by itself, without --stereo"),
                (("--eye-distance", "30"), "--eye-distance requires --stereo")):
            name = "c.exr" if "--aov" in options else "c.png"
            self.refused("render", HOOD, "-o", name, "-q", *SMALL, *options, told=told)

    def test_eyes_that_can_hardly_fuse_are_warned_of(self):
        run = self.keiko("render", HOOD, "-o", "a.png", *SMALL, "--stereo", "anaglyph",
                         "--screen-distance", "20000")
        self.assertEqual(run.returncode, 0)
        self.assertRegex(run.stderr, r"the body's parallax reaches -[\d.e+]+ mm, more than half of the "
                                     "eyes' distance")

    def test_an_orthographic_camera_has_no_two_eyes(self):
        scene = self.write("flat.toml", f"""format = "keiko-scene/1"
[[model]]
file = "{HOOD}"
[camera]
projection = "orthographic"
orthographic_height = 900
eye = [0, -900, 900]
target = [700, 0, 0]
""")
        self.refused("render", scene, "-o", "a.png", "-q", "--stereo", "anaglyph",
                     told="an orthographic camera has no eye to put two beside")

    def test_penumbrae_of_all_three_kinds_differ(self):
        self.write("scene.toml", 'format = "keiko-scene/1"\n'
                                 f'[[model]]\nfile = "{HOOD}"\n'
                                 '[ground]\nz = -300\n'
                                 '[[c_plane]]\norigin = [0, -1500, 1500]\nu = [1200, 0, 0]\n'
                                 'v = [0, 3000, 0]\nlamps = 3\ndiameter = 200\n'
                                 '[camera]\neye = [-2000, -2500, 1500]\ntarget = [700, 0, 0]\n'
                                 'size = [64, 36]\n')
        kinds = "axis", "width", "exact"
        for kind in kinds:
            self.succeed("render", "scene.toml", "--shadows", "--penumbrae", kind, "--light-error",
                         "0", "-o", f"{kind}.exr", "-q")
        self.assertEqual(len({(self.folder / f"{kind}.exr").read_bytes() for kind in kinds}), 3)

    def test_a_view_may_stand_in_a_file(self):
        eye = 'format = "keiko-view/1"\neye = [-900, 0, 1200]\ntarget = [700, 0, 700]\n'
        (self.folder / "other").mkdir()
        for name in "mine.toml", "other/mine.toml":
            self.write(name, eye)
        self.assertNotEqual(self.written("a.png", "--view", "mine.toml"),
                            self.written("b.png", "--view", "front"))
        run = self.keiko("place", HOOD, "-o", "r.toml", "--view", "mine.toml",
                         "--view", "other/mine.toml", "-q")
        self.assertEqual((run.returncode, run.stderr),
                         (2, "keiko: --view: two views are called 'mine'\n"))
        run = self.keiko("render", HOOD, "-o", "c.png", "--view", "none.toml", "-q")
        self.assertEqual(run.returncode, 2)
        self.assertRegex(run.stderr, r"\Akeiko: none\.toml: .+\n\Z")

    def test_fog_too_thick_for_single_scattering_is_told(self):
        light = '[[spotlight]]\nposition = [0, 0, 9000]\naim = [0, 0, 0]\n'
        camera = '[camera]\neye = [0, -9000, 500]\ntarget = [0, 0, 0]\nsize = [8, 6]\n'
        for extinction, told in ("0.01", False), ("0.5", True):
            self.write("fog.toml", f'format = "keiko-scene/1"\n[[model]]\nfile = "{HOOD}"\n{camera}{light}'
                                   f"[fog]\nextinction = {extinction}\n")
            run = self.keiko("render", "fog.toml", "-o", "a.png", "-q")
            self.assertEqual(run.returncode, 0)
            self.assertEqual("the fog is thick" in run.stderr, told, run.stderr)

    def test_the_scenes_of_the_repository_with_fog(self):
        """Parse, trace and light up; their full size is for the gallery."""
        for scene in sorted(SOURCE.glob("surfaces/*-scene.toml")):
            if "[fog]" in scene.read_text():
                run = self.keiko("render", str(scene), "-o", "a.png", "-q", "--shadows", "--size", "8x5")
                self.assertEqual(run.returncode, 0, run.stderr)
                self.assertRegex(run.stderr, r"\A(keiko: warning: (the fog is thick|lamps): [^\n]*\n)*\Z")

    def test_false_colours_have_a_legend_a_scale_and_lines(self):
        base = ("--view", "front", "--false-color")
        plain = self.written("a.png", *base)
        width, height = struct.unpack(">II", plain[16:24])
        self.assertGreater(width, 64 + 50)
        self.assertGreaterEqual(height, 36)
        for other in ((*base, "--scale", "5:500"), (*base, "--iso-lines"),
                      (*base, "--quantity", "illuminance")):
            self.assertNotEqual(plain, self.written("b.png", *other), other)

    def test_other_looks_need_no_lamps_and_are_all_different(self):
        looks = ("lamps", "zebra", "isophote", "highlight", "curvature:gauss", "curvature:mean",
                 "curvature:k1", "curvature:k2", "draft", "curvature:absolute", "curvature:section",
                 "radius", "isoparms", "patches")
        pictures = [self.written("a.png", "--look", look) for look in looks]
        self.assertEqual(len(set(pictures)), len(looks))
        self.assertNotEqual(self.written("b.png", "--look", "curvature:gauss=1"), pictures[4])
        self.assertIn(b"curvature.gauss\0", self.written("a.exr", "--aov", "curvature"))
        self.assertEqual(self.written("b.png", "--look", "zebra", "--threads", "1"), pictures[1])
        for arguments, words in ((("-o", "a.exr", "--look", "zebra"), "--look zebra makes a .png"),
                                 (("-o", "a.png", "--look", "zebr"), "(did you mean 'zebra'?)"),
                                 (("-o", "a.png", "--look", "zebra=1"), "not curvature:KIND=C"),
                                 (("-o", "a.png", "--look", "curvature:k1=0"), "not curvature:KIND=C"),
                                 (("-o", "a.png", "--look", "zebra", "--ev", "5"), "without --ev"),
                                 (("-o", "a.png", "--look", "zebra", "--shadows"), "without --shadows"),
                                 (("-o", "a.png", "--look", "zebra", "--rig", "auto"), "without --rig")):
            run = self.keiko("render", HOOD, *arguments, *SMALL)
            self.assertEqual(run.returncode, 2)
            self.assertIn(words, run.stderr)

    def test_looks_have_settings_of_their_own(self):
        def look(*arguments: str) -> bytes:
            return self.written("a.png", "--look", *arguments)

        drafts = [look("draft", *more) for more in
                  ((), ("--pull", "1,0,0"), ("--draft", "89"), ("--scale", "0:90"), ("--scale", "50%"))]
        self.assertEqual(len(set(drafts)), len(drafts))
        self.assertEqual(drafts[0], look("draft", "--pull", "0,0,7", "--draft", "3"))
        self.assertEqual(look("curvature:k1"), look("curvature:k1", "--scale", "98%"))
        self.assertEqual(look("curvature:k1=0.01"), look("curvature:k1", "--scale", "-0.01:0.01"))
        self.assertNotEqual(look("curvature:section"), look("curvature:section", "--section", "1,0,0"))
        self.assertEqual(len({look("below-radius", "--radius", radius) for radius in ("1", "900", "5000")}), 3)
        self.assertNotEqual(look("radius"), look("radius", "--scale", "10:1000"))
        for arguments, words in ((("--look", "draft", "--pull", "0,0,0"), "--pull: '0,0,0' is not a direction"),
                                 (("--look", "draft", "--pull", "0,0"), "--pull: '0,0' is not a direction"),
                                 (("--look", "draft", "--pull", "0,0,1e999"), "is not a direction"),
                                 (("--look", "zebra", "--pull", "0,0,1"), "--pull: is for --look draft"),
                                 (("--draft", "3"), "--draft: is for --look draft"),
                                 (("--look", "draft", "--draft", "91"), "--draft"),
                                 (("--look", "zebra", "--scale", "98%"), "--scale: is for a --look with"),
                                 (("--look", "curvature:k1=1", "--scale", "98%"), "--scale: is for a --look"),
                                 (("--look", "draft", "--scale", "3:3"), "neither MIN:MAX with"),
                                 (("--look", "draft", "--scale", "0%"), "neither MIN:MAX with"),
                                 (("--look", "draft", "--scale", "5%x"), "neither MIN:MAX with"),
                                 (("--look", "below-radius"), "--look below-radius: needs --radius MM"),
                                 (("--look", "radius", "--radius", "5"), "--radius: is for --look below-radius"),
                                 (("--look", "radius", "--scale", "0:5"), "is not MIN:MAX with 0 < MIN"),
                                 (("--look", "patches", "--scale", "9%"), "--scale: is for a --look with"),
                                 (("--look", "draft", "--section", "1,0,0"), "--section: is for --look curv"),
                                 (("--scale", "1:2"), "--scale: is for --false-color")):
            run = self.keiko("render", HOOD, "-o", "a.png", *arguments, *SMALL)
            self.assertEqual((run.returncode, run.stderr.count("\n")), (2, 1), run.stderr)
            self.assertIn(words, run.stderr)

    def test_frames_resume_where_files_and_options_are_the_same(self):
        scene = ('format = "keiko-scene/1"\n'
                 f'[[model]]\nfile = "{HOOD}"\n[[animation]]\ntarget = "camera.vertical_fov"\n'
                 'keys = [[0, 20], [4, 30]]\n[camera]\neye = [-3000, 0, 3000]\ntarget = [500, 0, 700]\n'
                 'size = [32, 18]\n')

        def made(*arguments: str) -> list:
            """The frames that a run makes anew."""
            before = {p.name: p.stat().st_mtime_ns for p in self.folder.glob("a-*.png")}
            self.succeed("render", "s.toml", "-o", "a.png", "--frames", "0:2", *arguments, "-q")
            return sorted(p.name for p in self.folder.glob("a-*.png")
                          if before.get(p.name) != p.stat().st_mtime_ns)

        every = ["a-0000.png", "a-0001.png", "a-0002.png"]
        self.write("s.toml", scene)
        self.assertEqual(made("--resume"), every)
        self.assertEqual(made("--resume"), [])
        (self.folder / "a-0001.png").unlink()
        self.assertEqual(made("--resume"), ["a-0001.png"])
        self.assertEqual(made("--resume", "--ev", "5"), every)
        self.assertEqual(made("--resume", "--ev", "5"), [])
        self.assertEqual(made("--resume", "--ev", "5", "--edge-samples", "1"), every)
        self.assertEqual(made("--resume", "--ev", "5"), every)
        self.write("s.toml", scene.replace("[4, 30]", "[4, 31]"))
        self.assertEqual(made("--resume", "--ev", "5"), every)
        self.assertEqual(made("--ev", "5"), every)
        (self.folder / "a-frames.txt").write_text("no frames 0 at all\n")
        self.assertEqual(made("--resume", "--ev", "5"), every)
        self.assertEqual(len(set((self.folder / name).read_bytes() for name in every)), 3)

    def test_options_that_the_format_has_no_use_for_are_refused(self):
        for name, arguments, word in (("a.exr", ("--tone", "log"), "--tone"), ("a.exr", ("--ev", "3"), "--ev"),
                                      ("a.exr", ("--false-color",), "--false-color"),
                                      ("a.png", ("--aov", "depth"), "--aov")):
            run = self.keiko("render", HOOD, "-o", name, *arguments, "-q", *SMALL)
            self.assertEqual(run.returncode, 2, arguments)
            self.assertRegex(run.stderr, rf"\Akeiko: {name}: {word} .*\n\Z")
            self.assertEqual(self.content(), [])

    def test_ground_sun_and_reflections_of_a_scene_count(self):
        scene = 'format = "keiko-scene/1"\nview = "high-front"\nsize = [32, 18]\n'
        model = f'ambient = 100\n[[model]]\nfile = "{HOOD}"\nmaterial = "chrome"\n'
        pictures = set()
        for head, tail in (("", ""), ("", "[ground]\nz = -300\n"), ("max_depth = 0\n", ""),
                           ("", "[sun]\ndirection = [0, 1, -1]\nilluminance = 50000\n"
                                "[ground]\nz = -300\n")):
            self.write("scene.toml", scene + head + model + tail)
            self.succeed("render", "scene.toml", "-o", "a.exr", "-q")
            pictures.add((self.folder / "a.exr").read_bytes())
        self.assertEqual(len(pictures), 4)

    def test_an_old_picture_is_replaced(self):
        self.write("a.png", "old")
        self.assertGreater(len(self.written("a.png")), 100)

    def test_a_placed_rig_gives_the_picture_that_auto_gives(self):
        view = ("--view", "high-front")
        self.succeed("place", HOOD, "-o", "rig.toml", "-q", *SMALL, *view)
        self.assertEqual(self.written("a.exr", *view, "--rig", "rig.toml"),
                         self.written("b.exr", *view))
        self.assertEqual(self.content(), ["a.exr", "b.exr", "rig.toml"])

    def test_a_scene_file_tells_model_view_and_size(self):
        self.write("scene.toml", 'format = "keiko-scene/1"\nview = "front"\nsize = [32, 18]\n'
                                 f'[[model]]\nfile = "{HOOD}"\n')
        self.succeed("render", "scene.toml", "-o", "a.png", "-q")
        self.assertEqual(struct.unpack(">II", (self.folder / "a.png").read_bytes()[16:24]),
                         (32, 18))


if __name__ == "__main__":
    unittest.main()
