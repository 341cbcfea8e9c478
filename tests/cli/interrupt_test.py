"""Ctrl-C ends a command soon, with exit code 130 and nothing written."""
import signal
import subprocess
import time
import unittest

from keiko_process import BINARY, KeikoTest, surface

CAR = surface("concept-car.step")
LARGE = ("--size", "1920x1080", "--view", "front")


class Interrupted(KeikoTest):
    def interrupt(self, stage: str, stop: int, *arguments: str):
        """Sends a signal once the progress tells of `stage`."""
        process = subprocess.Popen([BINARY, *arguments, "--verbose"], cwd=self.folder, text=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        for line in process.stderr:
            if line == f"keiko: {stage}\n":
                break
        process.send_signal(stop)
        start = time.monotonic()
        output, errors = process.communicate(timeout=60)
        self.assertEqual((process.returncode, output), (130, ""), (stage, errors))
        self.assertTrue(errors.endswith("keiko: interrupted\n"), errors)
        self.assertLess(time.monotonic() - start, 5)
        self.assertEqual(self.content(), [])

    def test_while_rendering(self):
        for stop in signal.SIGINT, signal.SIGTERM:
            self.interrupt("render", stop, "render", CAR, "-o", "a.png", *LARGE)

    def test_while_the_worker_reads_the_file(self):
        for command, output in ("render", "a.png"), ("inspect", "out"), ("place", "a.toml"):
            self.interrupt("import", signal.SIGINT, command, CAR, "-o", output)

    def test_while_lamps_are_placed(self):
        self.interrupt("place", signal.SIGINT, "place", CAR, "-o", "a.toml", *LARGE)

    def test_while_inspecting(self):
        self.interrupt("render", signal.SIGINT, "inspect", CAR, "-o", "out", *LARGE)


if __name__ == "__main__":
    unittest.main()
