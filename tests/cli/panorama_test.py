"""`keiko panorama`, and pictures in the surroundings that it makes."""
import unittest

from keiko_process import KeikoTest, surface

DOME = surface("dome.bpt")
SCENE = f"""format = "keiko-scene/1"
[[model]]
file = "{DOME}"
[camera]
eye = [0, -420, 260]
target = [0, 30, 55]
size = [64, 36]
"""
LAMPS = """[[polygon]]
corners = [[-300, -300, 900], [-300, 300, 900], [300, 300, 900], [300, -300, 900]]
luminance = 3000
"""


class Panorama(KeikoTest):
    def panorama(self, *arguments: str) -> None:
        run = self.keiko("panorama", self.write("lamps.toml", SCENE + LAMPS), "--at", "0,0,300", *arguments, "-q")
        self.assertEqual((run.returncode, run.stderr), (0, ""))

    def test_a_scene_shows_the_panorama_and_its_limits_are_told(self):
        for layout, options in ("lat-long", ("--width", "128")), ("cube", ("--width", "32", "--cube")):
            self.panorama("-o", "studio.exr", *options)
            scene = self.write("scene.toml", SCENE + f'[environment]\nfile = "studio.exr"\nlayout = "{layout}"\n')
            run = self.keiko("render", scene, "-o", "a.png", "-q")
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertRegex(run.stderr, r"without parallax, and its light has no shadows and is off by up to [\d.]+ %")
            self.assertEqual(len(run.stderr.splitlines()), 1)

    def test_the_surroundings_are_not_written_over(self):
        self.panorama("-o", "studio.exr", "--width", "128")
        before = (self.folder / "studio.exr").read_bytes()
        scene = self.write("scene.toml", SCENE + '[environment]\nfile = "studio.exr"\nlayout = "lat-long"\n')
        run = self.keiko("render", scene, "-o", "./studio.exr", "-q")
        self.assertEqual((run.returncode, run.stderr), (2, "keiko: ./studio.exr: is an input as well\n"))
        self.assertEqual((self.folder / "studio.exr").read_bytes(), before)

    def test_the_other_layout_is_refused(self):
        self.panorama("-o", "studio.exr", "--width", "128")
        scene = self.write("scene.toml", SCENE + '[environment]\nfile = "studio.exr"\nlayout = "cube"\n')
        run = self.keiko("render", scene, "-o", "a.png", "-q")
        self.assertEqual(run.returncode, 2)
        self.assertRegex(run.stderr, r"studio\.exr: is no cube map of six squares in a row: 128 x 64 pixels\n\Z")

    def test_what_cannot_be_is_told_in_a_line(self):
        lamps = self.write("lamps.toml", SCENE + LAMPS)
        for reason, *arguments in (("--at", lamps, "-o", "a.exr"), ("--at", lamps, "--at", "1,2", "-o", "a.exr"),
                                   ("coordinates must be from", lamps, "--at", "0,0,1e10", "-o", "a.exr"),
                                   ("use .exr or .png", lamps, "--at", "0,0,0", "-o", "a.jpg"),
                                   ("has no lamps to be seen", DOME, "--at", "0,0,0", "-o", "a.exr")):
            run = self.keiko("panorama", *arguments, "-q")
            self.assertEqual(run.returncode, 2, arguments)
            self.assertIn(reason, run.stderr)
            self.assertEqual(len(run.stderr.splitlines()), 1, run.stderr)


if __name__ == "__main__":
    unittest.main()
