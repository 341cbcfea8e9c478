#!/usr/bin/env python3
"""Installs the Debian packages in a fresh minimal Debian 12 as docs/install says, and uses them there.

usage: tests/install/try_packages.py PACKAGES SYSTEM

As root. SYSTEM is the folder for the fresh system, which replaces what stands there. Debian is read from
KEIKO_MIRROR, or else from deb.debian.org.
"""
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
MIRROR = os.environ.get("KEIKO_MIRROR", "http://deb.debian.org/debian")
# Run in a mount namespace of its own, which ends with the process: no mount is left behind.
ENTER = 'mount -t proc proc "$0/proc" && exec chroot "$0" /bin/sh -ec "$1"'
PROJECT = """cmake_minimum_required(VERSION 3.25)
project(first LANGUAGES CXX)
find_package(keiko 0.1 REQUIRED)
add_executable(first first.cpp)
target_link_libraries(first PRIVATE keiko::keiko)
"""


class Failure(Exception):
    """What does not work, in a line."""


def run(*command, **options) -> str:
    """Output of a command that must succeed; its last lines are the failure."""
    done = subprocess.run(list(map(str, command)), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          errors="replace", timeout=1800, **options)
    if done.returncode:
        last = " | ".join(done.stdout.strip().splitlines()[-4:])
        raise Failure(f"{command[-1]}: exit code {done.returncode}: {last}")
    return done.stdout


def dockerfile() -> dict:
    """The instructions of the Dockerfile by name, their lines joined."""
    text = (SOURCE / "docs/install/Dockerfile").read_text().replace("\\\n", " ")
    return dict(re.findall(r"^([A-Z]+) (.*)$", text, re.M))


class System:
    """A Debian in a folder."""

    def __init__(self, folder: Path, packages: Path):
        self.folder, self.packages = folder, packages
        self.work = folder / "work"

    def make(self):
        if self.folder.exists():
            shutil.rmtree(self.folder)
        cache = self.folder.with_name("debootstrap")
        cache.mkdir(parents=True, exist_ok=True)
        run("debootstrap", "--variant=minbase", f"--cache-dir={cache.resolve()}", "bookworm", self.folder, MIRROR)
        self.work.mkdir()
        shutil.copytree(SOURCE / "surfaces", self.work / "surfaces", ignore=shutil.ignore_patterns("baselines"))

    def run(self, script: str) -> str:
        environment = {"PATH": "/usr/sbin:/usr/bin:/sbin:/bin", "LC_ALL": "C.UTF-8", "HOME": "/root",
                       "DEBIAN_FRONTEND": "noninteractive"}
        environment |= {name: value for name, value in os.environ.items() if name.lower().endswith("_proxy")}
        return run("unshare", "--mount", "sh", "-ec", ENTER, self.folder, f"cd /work\n{script}", env=environment)

    def install_as_in_docker(self):
        """What the Dockerfile copies and runs."""
        instructions = dockerfile()
        pattern, target = instructions["COPY"].split()
        for package in self.packages.glob(pattern):
            shutil.copy(package, self.folder / target.strip("/"))
        self.run(instructions["RUN"])

    def install(self, name: str, *others: str):
        for package in self.packages.glob(f"{name}_*.deb"):
            shutil.copy(package, self.work)
        self.run(f"apt-get update && apt-get install -y --no-install-recommends ./{name}_*.deb {' '.join(others)}")


def expect(pattern: str, text: str, what: str):
    if not re.search(pattern, text):
        raise Failure(f"{what}: no {pattern!r} in: {' '.join(text[-300:].split())}")


def try_program(system: System):
    """The command line, its pages and its completion."""
    system.install_as_in_docker()
    facts = system.run("keiko --version --verbose")
    expect(r"reader +/usr/libexec/keiko/keiko-import\n", facts, "keiko --version --verbose")
    expect(r"OpenCASCADE \d", facts, "keiko --version --verbose")
    said = system.run("keiko inspect surfaces/hood.step -o out || [ $? = 1 ]")
    expect(r"out/report.html", said, "keiko inspect")
    expect("<html", (system.work / "out/report.html").read_text()[:500], "report.html")
    system.run("test -f /usr/share/man/man1/keiko-inspect.1.gz")
    expect("_keiko", system.run("bash -c 'source /usr/share/bash-completion/completions/keiko; complete -p keiko'"),
           "completion")


def try_python(system: System):
    """The module, in Debian's own Python."""
    system.install("python3-keiko")
    script = "import keiko; print(keiko.__file__, keiko.check('surfaces/hood.step').verdict)"
    said = system.run(f'python3 -c "{script}"')
    expect(r"/usr/lib/python3/dist-packages/keiko/__init__.py (pass|fail|undecided)\n", said, "import keiko")


def try_library(system: System):
    """The program of the README, built by CMake and by pkg-config."""
    system.install("keiko-dev", "g++", "make", "cmake", "pkg-config")
    readme = (SOURCE / "README.md").read_text(encoding="utf-8")
    (system.work / "first.cpp").write_text(re.search(r"```cpp\n(.*?)```", readme, re.S)[1])
    (system.work / "CMakeLists.txt").write_text(PROJECT)
    for build in ("cmake -B build . && cmake --build build && build/first",
                  "g++ -std=c++20 first.cpp -o first $(pkg-config --cflags --libs keiko) && ./first"):
        expect(r"\nG-SU-NT 0\.2 ± \S+ deg\n", "\n" + system.run(f"({build}) || [ $? = 1 ]"), build)


def try_removal(system: System):
    """Nothing is left of the packages."""
    system.run("apt-get purge -y keiko-dev python3-keiko keiko")
    left = system.run("find /usr /etc -name '*keiko*'")
    if left:
        raise Failure(f"left after removal: {' '.join(left.split())}")


def main() -> int:
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    if os.geteuid() != 0:
        print("try_packages: only root can make a system to try the packages in", file=sys.stderr)
        return 2
    system = System(Path(sys.argv[2]).resolve(), Path(sys.argv[1]))
    try:
        for step in (System.make, try_program, try_python, try_library, try_removal):
            step(system)
            print(f"{step.__name__}: done", flush=True)
    except (Failure, OSError, subprocess.SubprocessError) as failure:
        print(f"try_packages: {failure}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
