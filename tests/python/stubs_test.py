"""The stubs of the module against the module itself, by mypy's stubtest. Exits with 77 without mypy."""
import importlib.util
import os
import subprocess
import sys
import tempfile
from pathlib import Path

# What pybind11 gives its classes: their metaclass, and an __init__ that only raises.
OF_PYBIND11 = "".join(rf"keiko\.{name}(\.__init__)?{os.linesep}" for name in ("Curve", "DeepBuffer", "Drawing", "Film", "Mesh", "Model", "Placement", "Scene", "Solution",
                                                               "Spline"))


def main() -> int:
    if importlib.util.find_spec("mypy") is None:
        print("skipped: there is no mypy")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        allowed = Path(folder) / "allowed"
        allowed.write_text(OF_PYBIND11, encoding="utf-8")
        command = [sys.executable, "-B", "-m", "mypy.stubtest", "keiko", "--concise", "--allowlist", allowed]
        return subprocess.run(command, cwd=folder, check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
