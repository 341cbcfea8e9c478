"""A small suite of fixtures, made in the folder of a test."""
import hashlib
import json
import shutil
from pathlib import Path

from keiko_process import SOURCE, KeikoTest, surface

FIXTURE = """format = "keiko-fixture/1"
model = "{model}"
views = ["high-front"]
rig = "rig.toml"
size = [32, 18]
layers = ["face", "depth", "normal"]
"""


class RegressTest(KeikoTest):
    """Has a folder `suite` with the fixtures that a test asks for."""

    def add_fixture(self, name: str, model: str = "dome.bpt", more: str = "") -> Path:
        suite = self.folder / "suite"
        suite.mkdir(exist_ok=True)
        shutil.copy(SOURCE / "lightrigs" / "bench-6.toml", suite / "rig.toml")
        shutil.copy(surface(model), suite / f"{name}{Path(model).suffix}")
        text = FIXTURE.format(model=f"{name}{Path(model).suffix}") + more
        (suite / f"{name}.toml").write_text(text)
        return suite / f"{name}{Path(model).suffix}"

    def regress(self, *arguments: str, output: str = "out"):
        return self.keiko("regress", "-q", "suite", "-o", output, *arguments)

    def accept(self, *names: str):
        updates = [word for name in names for word in ("--update", name)]
        run = self.regress(*updates, "--reason", "first", "--by", "tester")
        self.assertEqual((run.returncode, run.stderr), (0, ""), run.stdout)

    def reports(self, folder: str) -> dict:
        return {name: (self.folder / folder / name).read_bytes()
                for name in ("regression.json", "junit.xml", "index.html")}

    def assert_sound(self, record: Path):
        """Every file of a kept record is what its manifest says, and none is missing or too many."""
        manifest = json.loads((record / "manifest.json").read_text())
        found = {p.name: hashlib.sha256(p.read_bytes()).hexdigest()
                 for p in record.iterdir() if p.name != "manifest.json"}
        self.assertEqual(found, manifest["files"], record)


def move_point_of_dome(path: Path, millimetres: float):
    """Raises an inner control point of the first patch of dome.bpt (degree 3 x 5)."""
    lines = path.read_text().splitlines()
    line = 2 + 1 * 6 + 2
    x, y, z = map(float, lines[line].split())
    lines[line] = f"{x!r} {y!r} {z + millimetres!r}"
    path.write_text("\n".join(lines) + "\n")
