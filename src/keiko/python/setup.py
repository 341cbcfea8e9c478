"""Builds the module by CMake, in build/release of the repository, and packs what it installs."""
import os
import re
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parents[3]
BUILD = ROOT / "build/release"


class CMakeBuild(build_ext):
    """Configures, builds and installs the component `python` beside the package."""

    def run(self):
        package = Path(self.get_ext_fullpath("keiko._keiko")).resolve().parent
        commands = [["cmake", "--preset", "release", f"-DKEIKO_PYTHON={sys.executable}"],
                    ["cmake", "--build", BUILD, "--target", "keiko_python", "keiko-import",
                     "--parallel", str(os.cpu_count())],
                    ["cmake", "--install", BUILD, "--component", "python", "--prefix", package.parent]]
        for command in commands:
            subprocess.run(list(map(str, command)), cwd=ROOT, check=True)


def version() -> str:
    """That of the project."""
    return re.search(r"project\(keiko VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text())[1]


setup(version=version(), ext_modules=[Extension("keiko._keiko", [])], cmdclass={"build_ext": CMakeBuild})
