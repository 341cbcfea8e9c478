"""Runs the real program in a folder of its own."""
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

BINARY = os.environ["KEIKO_BINARY"]
SOURCE = Path(os.environ["KEIKO_SOURCE_DIR"])
SMALL = ("--size", "64x36")
# A hundred thin lamps over the seam fixtures, slanting to every seam.
ASLANT = """format = "keiko-rig/1"
name = "aslant"
[[c_plane]]
origin = [600, -2800, 1500]
u = [1800, 2400, 0]
v = [-2400, 1800, 0]
lamps = 100
diameter = 10
luminance = 9000
"""


def surface(name: str) -> str:
    return str(SOURCE / "surfaces" / name)


def luminaire(name: str) -> str:
    return str(SOURCE / "tests" / "data" / "oracle" / "photometric_files" / name)


class KeikoTest(unittest.TestCase):
    """Every test runs in an empty working directory."""

    patience = 120  # seconds that a command may take

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="keiko-cli-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def keiko(self, *arguments: str, **options) -> subprocess.CompletedProcess:
        return subprocess.run([BINARY, *arguments], cwd=self.folder, capture_output=True,
                              text=True, timeout=self.patience, **options)

    def succeed(self, *arguments: str) -> str:
        """What is printed by a command that must exit with 0 and have nothing to complain of."""
        run = self.keiko(*arguments)
        self.assertEqual((run.returncode, run.stderr), (0, ""), arguments)
        return run.stdout

    def expect_same_picture_for_any_threads(self, scene: str):
        for threads in ("1", "2"):
            self.succeed("render", scene, "-o", f"{threads}.exr", "--threads", threads, "-q")
        self.assertEqual((self.folder / "1.exr").read_bytes(), (self.folder / "2.exr").read_bytes())

    def write(self, name: str, text: str) -> str:
        (self.folder / name).write_text(text)
        return name

    def content(self) -> list:
        """Everything in the folder, hidden files too, by relative path."""
        return sorted(str(p.relative_to(self.folder)) for p in self.folder.rglob("*"))
