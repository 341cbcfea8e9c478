"""Ctrl-C ends a command soon, with exit code 130 and nothing written."""
import os
import signal
import subprocess
import time
import unittest

from keiko_process import BINARY, SOURCE, KeikoTest, surface

CAR = surface("concept-car.step")
LARGE = ("--size", "1920x1080", "--view", "front")


FOG = """format = "keiko-scene/1"
[[model]]
file = "%s"
[camera]
eye = [-6000, -5000, 1900]
target = [2000, 100, 400]
size = [320, 180]
[[spotlight]]
position = [-1500, -2600, 4600]
aim = [700, -300, 400]
half_angle = 22
luminous_flux = 9000
[fog]
extinction = 0.8
layer = { height = 380, extinction_above = 0.02, bump = "noise", amplitude = 75, wavelength = 300 }
"""


class Interrupted(KeikoTest):
    def interrupt(self, stage: str, stop: int, *arguments: str):
        """Sends a signal once the progress tells of `stage`."""
        process = subprocess.Popen([BINARY, *arguments, "--verbose"], cwd=self.folder, text=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        for line in process.stderr:
            if line.rstrip("\n").split(" ")[1] == stage:
                break
        process.send_signal(stop)
        start = time.monotonic()
        output, errors = process.communicate(timeout=60)
        self.assertEqual((process.returncode, output), (130, ""), (stage, errors))
        self.assertTrue(errors.endswith("keiko: interrupted\n"), errors)
        self.assertLess(time.monotonic() - start, 5)
        self.assertEqual(self.content(), [])

    def test_while_rendering(self):
        for stop in signal.SIGINT, signal.SIGTERM, signal.SIGHUP:
            self.interrupt("render", stop, "render", CAR, "-o", "a.png", *LARGE)

    def test_a_hangup_that_is_ignored_stops_nothing(self):
        """As nohup has it."""
        process = subprocess.Popen([BINARY, "render", CAR, "-o", "a.png", "--verbose", "--size", "96x54", "--view", "front"],
                                   cwd=self.folder, text=True, stderr=subprocess.PIPE,
                                   preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
        next(process.stderr)
        process.send_signal(signal.SIGHUP)
        errors = process.communicate(timeout=120)[1]
        self.assertEqual(process.returncode, 0, errors)
        self.assertEqual(self.content(), ["a.png"])

    def test_while_the_worker_reads_the_file(self):
        for command, output in ("render", "a.png"), ("inspect", "out"), ("place", "a.toml"):
            self.interrupt("import", signal.SIGINT, command, CAR, "-o", output)

    def test_while_lamps_are_placed(self):
        self.interrupt("place", signal.SIGINT, "place", CAR, "-o", "a.toml", *LARGE)

    def test_while_inspecting(self):
        self.interrupt("render", signal.SIGINT, "inspect", CAR, "-o", "out", *LARGE)


class EveryCommand(KeikoTest):
    """Each of them ends within ten seconds of Ctrl-C, whatever it is at."""

    def start(self, *arguments: str) -> subprocess.Popen:
        never_written, end = os.pipe()
        self.addCleanup(os.close, end)
        process = subprocess.Popen([BINARY, *arguments, "--verbose"], cwd=self.folder, text=True,
                                   stdin=never_written, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE)
        os.close(never_written)
        self.addCleanup(process.kill)
        return process

    def ends(self, process: subprocess.Popen, stage: str = "", delay: float = 0.5):
        """Sends SIGINT so many seconds after the progress names the stage."""
        for line in process.stderr if stage else ():
            if f" {stage}" in line:
                break
        time.sleep(delay)
        self.assertIsNone(process.poll(), "it has ended before the signal")
        process.send_signal(signal.SIGINT)
        output, errors = process.communicate(timeout=10)
        self.assertEqual(process.returncode, 130, (process.args, errors))
        self.assertTrue(errors.endswith("keiko: interrupted\n"), (process.args, errors))

    def test_check(self):
        self.ends(self.start("check", CAR, "--preset", "class-a-waviness"), "import", 0)

    def test_compare(self):
        self.ends(self.start("compare", CAR, CAR, "--samples", "10000000"), "deviation")

    def test_illuminance_while_it_waits_for_points(self):
        self.ends(self.start("illuminance", surface("lights-scene.toml")), "build")

    def test_info(self):
        self.ends(self.start("info", CAR), "import", 0)

    def test_inspect(self):
        self.ends(self.start("inspect", CAR, "-o", "out", *LARGE), "render")

    def test_lines_of_a_thousand_lamps(self):
        rig = (SOURCE / "lightrigs/car-12.toml").read_text()
        self.write("many.toml", rig.replace("lamps = 12", "lamps = 1000")
                   .replace("diameter = 60", "diameter = 1"))
        self.ends(self.start("lines", CAR, "--rig", "many.toml", "-o", "lines.json"), "lines")

    def test_place(self):
        self.ends(self.start("place", CAR, "-o", "a.toml", "--samples", "4000000", *LARGE), "look")

    def test_regress(self):
        self.write("car.toml", f'format = "keiko-fixture/1"\nmodel = "{CAR}"\n'
                               'views = ["front"]\nsize = [4096, 4096]\n')
        self.ends(self.start("regress", ".", "-o", "out"), "import")

    def test_render_under_fog_with_short_waves(self):
        self.write("fog.toml", FOG % CAR)
        self.ends(self.start("render", "fog.toml", "-o", "a.png"), "render", 3)

    def test_trace_while_it_waits_for_rays(self):
        self.ends(self.start("trace", surface("saddle.bpt")), "build")

    def test_a_pipe_that_nobody_reads(self):
        os.mkfifo(self.folder / "pipe.json")
        self.ends(self.start("check", surface("saddle.bpt"), "--json", "pipe.json"), "faces", 1)


if __name__ == "__main__":
    unittest.main()
