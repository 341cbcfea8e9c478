"""Whatever the user gets wrong is told in one clear line, with exit code 2 and nothing written."""
import os
import socket
import shutil
import subprocess
import unittest

from keiko_process import BINARY, SMALL, SOURCE, KeikoTest, luminaire, surface

SADDLE = surface("saddle.bpt")
ONE_TUBE = str(SOURCE / "lightrigs/single-tube.toml")
PATCH = "1\n1 1\n0 0 0\n0 1 0\n1 0 0\n1 1 2\n"


class Errors(KeikoTest):
    def fails(self, reason: str, *arguments: str):
        """The command must end with one line that holds `reason`, and leave the folder alone."""
        before = self.content()
        run = self.keiko(*arguments, "-q")
        self.assertEqual(run.returncode, 2, (arguments, run.stderr))
        self.assertEqual(run.stderr.count("\n"), 1, run.stderr)
        self.assertTrue(run.stderr.startswith("keiko: "), run.stderr)
        self.assertIn(reason, run.stderr)
        self.assertEqual(run.stdout, "")
        self.assertEqual(self.content(), before)

    def every_command_fails_on(self, model: str, reason: str):
        self.fails(reason, "info", model)
        self.every_command_but_info_fails_on(model, reason)

    def every_command_but_info_fails_on(self, model: str, reason: str):
        self.fails(reason, "inspect", model, "-o", "out")
        self.fails(reason, "place", model, "-o", "rig.toml")
        self.fails(reason, "render", model, "-o", "picture.png")
        self.fails(reason, "trace", model)

    def file_fails(self, model: str, reason: str):
        self.fails(reason, "render", model, "-o", "picture.png")

    def test_progress_stands_before_the_line_and_nothing_behind(self):
        run = self.keiko("info", self.write("a.bpt", PATCH.replace("1 1 2", "1 1 x")))
        self.assertEqual(run.returncode, 2)
        self.assertRegex(run.stderr, r"\A(keiko: [a-z ]+\n)*keiko: a\.bpt:6: not a finite.*\n\Z")

    def test_scales_of_false_colours_that_are_none(self):
        for scale in "10", "10:1", "0:5", "1:inf", "1:2:3", "a:b":
            self.fails("is not MIN:MAX with 0 < MIN < MAX", "render", SADDLE, "-o", "a.png",
                       "--false-color", "--scale", scale)
        self.fails("--false-color", "render", SADDLE, "-o", "a.png", "--scale", "1:10")

    def test_axes_that_no_body_can_have(self):
        for command, *rest in (["info"], ["trace"], ["check"], ["compare", SADDLE], ["illuminance"],
                               ["render", "-o", "a.png"], ["place", "-o", "a.toml"],
                               ["inspect", "-o", "out"], ["lines", "-o", "a.json", "--rig", ONE_TUBE]):
            self.fails('saddle.bpt: axes "x,z,y": would mirror the body', command, SADDLE, *rest,
                       "--axes", "x,z,y")
        self.fails("not three words of x, y, z", "info", SADDLE, "--axes", "up")

    def test_a_model_that_is_no_file(self):
        self.every_command_fails_on("none.step", "none.step: no such file")
        self.every_command_fails_on(".", ".: is a directory")
        self.every_command_fails_on(self.write("a.step", ""), "a.step: the file is empty")

    def test_a_model_that_is_none(self):
        self.every_command_fails_on(self.write("a.step", "Dear customer,\n"),
                                    "a.step: not a model file")

    def test_files_of_use_elsewhere_are_told_as_what_they_are(self):
        rig = str(SOURCE / "lightrigs/bench-6.toml")
        self.fails("no model, but a scene: inspect, check, render and trace take it", "info",
                   surface("hood-scene.toml"))
        self.fails("no model, but a rig: inspect, render and lines take it as their rig", "info", rig)
        self.fails("is 'keiko-rig/1', a rig: inspect, render and lines take it as their rig; expected", "check", rig)
        self.every_command_but_info_fails_on(luminaire("sym4.ldt"), "no model, but a luminaire: info takes it")

    def test_a_command_that_there_is_not(self):
        self.fails('there is no command "rendr" (did you mean \'render\'?); see keiko --help', "rendr", SADDLE)
        self.fails('there is no command "qqqqqq"; see keiko --help', "qqqqqq")

    def test_a_model_cut_short(self):
        hood = (SOURCE / "surfaces/hood.step").read_text()
        self.file_fails(self.write("half.step", hood[:len(hood) // 2]),
                        "half.step: the STEP file is cut short")

    def test_a_model_whose_end_hides_that_it_was_cut(self):
        hood = (SOURCE / "surfaces/hood.step").read_text()
        text = hood[:len(hood) // 2] + "\nENDSEC;\nEND-ISO-10303-21;\n"
        self.file_fails(self.write("half.step", text), "half.step: ")

    def test_patch_files_with_wrong_lines(self):
        self.file_fails(self.write("a.bpt", PATCH.replace("1 1 2", "1 1 nan")),
                        'a.bpt:6: not a finite number: "nan"')
        self.file_fails(self.write("a.bpt", PATCH.replace("1 0 0\n", "")), "a.bpt:6: ")
        for count in "0", "-1":
            for text in count, count + PATCH[1:]:
                self.file_fails(self.write("a.bpt", text), "a.bpt:1: out of range: the number of patches")

    def test_a_file_name_with_a_line_break(self):
        self.fails("a?b.step: no such file", "info", "a\nb.step")

    def test_a_pipe_is_no_input(self):
        for name in "a.bpt", "a.step", "a.toml", "a.ies":
            os.mkfifo(self.folder / name)
            self.fails(f"{name}: is a pipe, not a file: save what comes out of it", "info", name)
            if not name.endswith(".ies"):
                self.fails(f"{name}: is a pipe", "check", name)
        self.fails("a.toml: is a pipe", "render", SADDLE, "-o", "p.png", "--rig", "a.toml")
        self.fails("a.toml: is a pipe", "check", SADDLE, "--preset", "a.toml")
        self.write("scene.toml", 'format = "keiko-scene/1"\n[[model]]\nfile = "a.bpt"\n')
        self.fails("scene.toml:3:8: model[0].file: a.bpt: is a pipe", "render", "scene.toml", "-o",
                   "p.png")

    def test_a_path_with_a_nul(self):
        shutil.copy(SADDLE, self.folder / "a.bpt")
        self.write("scene.toml", 'format = "keiko-scene/1"\n[[model]]\nfile = "a.bpt\\u0000.evil"\n')
        self.fails('scene.toml:3:8: model[0].file: "a.bpt?.evil" has a NUL character', "render",
                   "scene.toml", "-o", "p.png")

    def test_file_names_that_would_control_the_terminal(self):
        self.fails("a?[31m?b?c.step: no such file", "info", "a\x1b[31m\u009bb\u202ec.step")
        run = subprocess.run([BINARY, "info", b"a\xff\x9b.step"], cwd=self.folder,
                             capture_output=True)
        self.assertEqual((run.returncode, run.stderr), (2, b"keiko: a??.step: no such file\n"))

    def test_a_rig_with_a_misspelt_key(self):
        rig = (SOURCE / "lightrigs/single-tube.toml").read_text()
        line = rig[:rig.index("\ndiameter")].count("\n") + 2
        self.write("rig.toml", rig.replace("\ndiameter", "\n diametre"))
        reason = f"keiko: rig.toml:{line}:2: unknown key 'c_plane[0].diametre'"
        self.fails(reason, "render", SADDLE, "-o", "a.png", "--rig", "rig.toml")
        self.fails(reason, "inspect", SADDLE, "-o", "out", "--rig", "rig.toml")

    def test_a_rig_that_is_missing(self):
        self.fails("none.toml: no such file", "render", SADDLE, "-o", "a.png", "--rig", "none.toml")
        self.fails("none.toml: no such file", "inspect", SADDLE, "-o", "o", "--rig", "none.toml")

    def test_texts_of_other_encodings_and_of_any_size(self):
        (self.folder / "wide.toml").write_bytes('format = "keiko-scene/1"\n'.encode("utf-16"))
        self.fails("wide.toml: is text in UTF-16 or UTF-32: save it as UTF-8", "render", "wide.toml", "-o", "a.png")
        self.fails("wide.toml: is text in UTF-16", "render", SADDLE, "-o", "a.png", "--rig", "wide.toml")
        with open(self.folder / "endless.toml", "w") as file:
            file.truncate(6 << 30)
        self.fails("endless.toml: has 6442450944 bytes; a text may have 1073741824", "render", SADDLE, "-o", "a.png",
                   "--rig", "endless.toml")

    def test_a_scene_of_a_missing_model(self):
        self.write("scene.toml", 'format = "keiko-scene/1"\n[[model]]\nfile = "none.step"\n')
        for command, output in ("render", "a.png"), ("place", "a.toml"), ("inspect", "out"):
            self.fails("scene.toml:3:8: model[0].file: none.step: no such file", command,
                       "scene.toml", "-o", output)

    def test_unknown_names(self):
        for command, output in ("render", "a.png"), ("place", "a.toml"), ("inspect", "out"):
            self.fails("unknown view 'sideways'", command, SADDLE, "-o", output, "--view",
                       "sideways")
            self.fails("unknown material 'wood'", command, SADDLE, "-o", output, "--material",
                       "wood")
        self.fails("unknown material 'wood'", "render", SOURCE / "surfaces/hood-scene.toml", "-o",
                   "a.png", "--material", "wood")
        self.fails("unknown preset 'lax'", "inspect", SADDLE, "-o", "out", "--preset", "lax")
        self.fails('no AOV is called "hue"', "render", SADDLE, "-o", "a.exr", "--aov", "depth,hue")
        self.fails('"depth" is asked for twice', "render", SADDLE, "-o", "a.exr", "--aov",
                   "depth,normal,depth")
        self.fails('unknown length unit "furlong"', "info", SADDLE, "--unit", "furlong")

    def test_an_option_that_names_nothing(self):
        for option, name in ("--aov", "a.exr"), ("--frames", "a.png"), ("--view", "a.png"), ("--rig", "a.png"):
            self.fails(f"{option}: is empty", "render", SADDLE, "-o", name, option, "")
        self.fails("--scale: is empty", "render", SADDLE, "-o", "a.png", "--false-color", "--scale",
                   "")

    def test_an_exposure_that_false_colours_do_not_have(self):
        self.fails("--false-color excludes --ev", "render", SADDLE, "-o", "a.png", "--false-color",
                   "--ev", "9")

    def test_what_the_library_refuses_is_named_by_its_option(self):
        hood = surface("hood.step")
        self.fails("keiko: --faces: no face has the number or a name like 'roof'", "place", hood, "-o",
                   "a.toml", "--faces", "roof")
        self.fails("keiko: --section: 'q=1' is not x=MM", "check", SADDLE, "--section", "q=1",
                   "--combs", "c.csv")
        self.fails("keiko: --view: the scene has no camera of its own", "render", SADDLE, "-o", "a.png",
                   "--view", "scene")
        self.fails('keiko: --out: the column "t" stands there twice', "trace", SADDLE, "--out", "t,t")
        (self.folder / "shard").mkdir()
        self.fails("keiko: shard: holds no shard that is done", "merge", "shard")
        self.write("shard/regression.json", "{}")
        self.fails("keiko: --output: shard is a shard itself", "merge", "shard", "-o", "shard")

    def test_wrong_sizes(self):
        for size in "12", "0x9", "16x-9", "16x9x", "99999x9":
            self.fails("--size: ", "render", SADDLE, "-o", "a.png", "--size", size)

    def test_numbers_out_of_range(self):
        self.fails("--threads: ", "info", SADDLE, "--threads", "-1")
        self.fails("--threads", "info", SADDLE, "--threads", "1.5")
        self.fails("--lamps: ", "place", SADDLE, "-o", "a.toml", "--lamps", "65")
        self.fails("--ev: ", "render", SADDLE, "-o", "a.png", "--ev", "nan")
        self.fails("--import-timeout: ", "info", SADDLE, "--import-timeout", "1e300")
        for limit in "0", "-1", "nan", "4G":
            self.fails("--cache-limit: ", "info", SADDLE, "--cache", "kept", "--cache-limit", limit)

    def test_a_cache_that_others_may_write(self):
        (self.folder / "kept").mkdir()
        (self.folder / "kept").chmod(0o777)
        self.fails("kept: others may write in the folder", "info", surface("hood.step"), "--cache", "kept")

    def test_outputs_that_are_no_files(self):
        with socket.socket(socket.AF_UNIX) as server:
            server.bind(str(self.folder / "a.png"))
            self.fails("a.png: is a socket, not a file", "render", SADDLE, "-o", "a.png")

    def test_a_join_distance_that_would_find_no_seam(self):
        for join in "nan", "inf", "0", "-1":
            self.fails("--join: ", "inspect", SADDLE, "-o", "out", "--join", join)

    def test_usage(self):
        self.fails("--output is required; see keiko render --help", "render", SADDLE)
        self.fails("--colour", "info", SADDLE, "--colour")

    def test_an_output_of_unknown_kind(self):
        self.fails("use .exr or .png", "render", SADDLE, "-o", "a.jpeg")
        self.fails("ends in .toml", "place", SADDLE, "-o", "saddle.bpt")
        self.fails("--false-color makes a .png", "render", SADDLE, "-o", "a.exr", "--false-color")

    def test_an_output_where_there_is_no_folder(self):
        self.write("file", "kept")
        self.fails("no folder none", "render", SADDLE, "-o", "none/a.png")
        self.fails("no folder none", "place", SADDLE, "-o", "none/a.toml")
        self.fails("file is a file, not a folder", "render", SADDLE, "-o", "file/a.png")
        self.fails("file is a file, not a folder", "inspect", SADDLE, "-o", "file")
        self.fails("file is a file, not a folder", "inspect", SADDLE, "-o", "file/deeper/out")
        (self.folder / "a.png").mkdir()
        self.fails("a.png: is a directory, not a file", "render", SADDLE, "-o", "a.png")
        self.assertEqual((self.folder / "file").read_text(), "kept")

    @unittest.skipIf(os.geteuid() == 0, "root may write anywhere")
    def test_an_output_folder_without_permission(self):
        (self.folder / "locked").mkdir(mode=0o500)
        for command, output in ("render", "a.png"), ("place", "a.toml"), ("inspect", "out"):
            self.fails("no permission to write in locked", command, SADDLE, "-o",
                       f"locked/{output}", *SMALL)

    @unittest.skipUnless(os.path.exists("/dev/full"), "no /dev/full")
    def test_standard_output_that_takes_nothing(self):
        with open("/dev/full", "w") as full:
            run = subprocess.run([BINARY, "info", SADDLE, "-q"], stdout=full,
                                 stderr=subprocess.PIPE, text=True)
        self.assertEqual((run.returncode, run.stderr),
                         (2, "keiko: standard output: cannot write: No space left on device\n"))


if __name__ == "__main__":
    unittest.main()
