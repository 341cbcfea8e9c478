"""Keiko installed into a prefix that is moved afterwards, and programs built and run with it there."""
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

BUILD, SOURCE = Path(os.environ["KEIKO_BUILD_DIR"]), Path(os.environ["KEIKO_SOURCE_DIR"])
COMPILER = os.environ["KEIKO_COMPILER"]
SURFACES = SOURCE / "surfaces"
COMPONENTS = ("runtime", "dev", "doc")
# Folders of /usr/include that belong to the system or the compiler; each other one is a library's.
SYSTEM = {"asm", "asm-generic", "bits", "c++", "gnu", "linux", "sys", "x86_64-linux-gnu", "aarch64-linux-gnu"}

sys.path.insert(0, str(SOURCE / "tests"))
from public_headers import public_headers


def run(*command, **options):
    # Only what is installed is to be found: no worker, no library that a developer has set.
    environment = {key: value for key, value in os.environ.items()
                   if key not in ("KEIKO_IMPORT", "LD_LIBRARY_PATH", "DESTDIR")}
    environment.update(options.pop("environment", {}))
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, env=environment,
                          timeout=300, **options)


def output_of(*command, **options) -> str:
    done = run(*command, **options)
    if done.returncode:
        raise AssertionError(f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
    return done.stdout


def first_program() -> str:
    """The program that docs/library.md begins with."""
    return re.search(r"```cpp\n(.*?)```", (SOURCE / "docs/library.md").read_text(encoding="utf-8"), re.S)[1]


class InstallTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp(prefix="install-", dir=BUILD))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        for component in COMPONENTS:
            output_of("cmake", "--install", BUILD, "--prefix", cls.folder / "first", "--component", component)
        cls.prefix = (cls.folder / "first").rename(cls.folder / "moved")
        cls.libraries = next(cls.prefix.rglob("libkeiko.*")).parent

    def check_worker_is_asked(self, program, *arguments, **options):
        """Runs a program on a CAD file, with the installed worker and without."""
        worker = self.prefix / "libexec/keiko/keiko-import"
        answer = run(program, *arguments, SURFACES / "seam-g0-gap.step", **options)
        self.assertIn(answer.returncode, (0, 1), answer.stderr)
        aside = worker.rename(worker.with_name("aside"))
        try:
            refused = run(program, *arguments, SURFACES / "seam-g0-gap.step", **options)
        finally:
            aside.rename(worker)
        self.assertEqual(refused.returncode, 2)
        self.assertIn("no reader at", refused.stderr)
        return answer


class Program(InstallTest):
    def test_finds_the_worker_in_libexec(self):
        answer = self.check_worker_is_asked(self.prefix / "bin/keiko", "info")
        self.assertIn("seam-g0-gap", answer.stdout)

    def test_comes_with_its_data_and_pages(self):
        for path in ("share/keiko/rigs/car-12.toml", "share/keiko/presets/class-a-outer.toml",
                     "share/keiko/schema/keiko.schema.json", "share/keiko/keiko-array.sbatch", "share/doc/keiko/library.md",
                     "share/doc/keiko/examples/check_part.cpp"):
            self.assertTrue((self.prefix / path).is_file(), path)


class Headers(InstallTest):
    def dependencies_of(self, header: str) -> set:
        """Compiles a header alone; returns all files that it reads."""
        name = self.folder / header.replace("/", "_")
        unit, listing = name.with_suffix(".cpp"), name.with_suffix(".d")
        unit.write_text(f'#include "{header}"\n')
        output_of(COMPILER, "-std=c++20", "-fsyntax-only", "-Wall", "-Wextra", "-Wpedantic", "-Werror",
                  "-I", self.prefix / "include", "-MD", "-MF", listing, unit)
        return set(listing.read_text().replace("\\\n", " ").split()[2:])

    def libraries_of(self, header: str) -> set:
        """The libraries whose headers a header pulls in, Keiko and the compiler's own not counted."""
        found = set()
        for file in map(Path, self.dependencies_of(header)):
            path = Path(os.path.normpath(file))
            if path.is_relative_to("/usr/include") and len(path.parts) > 4 and path.parts[3] not in SYSTEM:
                found.add(path.parts[3])
            elif not path.is_relative_to("/usr") and not path.is_relative_to(self.prefix):
                found.add(str(path))
        return found

    def test_are_those_of_api_and_what_they_reach(self):
        include = self.prefix / "include"
        installed = sorted(str(path.relative_to(include)) for path in include.rglob("*") if path.is_file())
        self.assertEqual(installed, sorted(public_headers()))

    def test_of_api_compile_alone_and_show_no_library_but_imath(self):
        every = bool(os.environ.get("KEIKO_LONG"))
        headers = [header for header in public_headers() if every or header.startswith("keiko/api/")]
        with ThreadPoolExecutor(os.cpu_count()) as threads:
            for header, libraries in zip(headers, threads.map(self.libraries_of, headers)):
                self.assertLessEqual(libraries, {"Imath"}, header)


class Library(InstallTest):
    def test_shows_only_what_the_headers_declare(self):
        shared = self.libraries / "libkeiko.so"
        if not shared.is_file():
            self.skipTest("the library is static")
        if "Free Software Foundation" not in output_of(COMPILER, "--version"):
            self.skipTest("only gcc hides what is not marked")
        symbols = output_of("nm", "-D", "-C", "--defined-only", shared).splitlines()
        names = [line.split(" ", 2)[2] for line in symbols if line.split(" ", 2)[1] in "TDBR"]
        shown = {name.partition("(")[0] for name in names}
        self.assertFalse({"keiko::check_models", "keiko::operator*", "keiko::SurfaceModel::patch"} - shown)
        for name in names:
            self.assertRegex(name, r"(^|\b(typeinfo( name)?|vtable|VTT) for )keiko::", "a symbol of another library")
            self.assertNotRegex(name, r"^keiko::(build_id|binary_path|sha256|log_\w+)\b", "an inner function")

    def test_serves_a_program_that_finds_it_by_pkg_config(self):
        if not shutil.which("pkg-config"):
            self.skipTest("there is no pkg-config")
        source, program = self.folder / "first.cpp", self.folder / "first"
        source.write_text(first_program())
        static = [] if (self.libraries / "libkeiko.so").is_file() else ["--static"]
        flags = output_of("pkg-config", *static, "--cflags", "--libs", "keiko >= 0.1",
                          environment={"PKG_CONFIG_PATH": str(self.libraries / "pkgconfig")}).split()
        output_of(COMPILER, "-std=c++20", source, "-o", program, *flags)
        answer = self.check_worker_is_asked(program, environment={"LD_LIBRARY_PATH": str(self.libraries)})
        self.assertIn("verdict", answer.stdout)

    def test_serves_the_examples_that_find_it_by_cmake(self):
        build = self.folder / "examples"
        output_of("cmake", "-S", SOURCE / "docs/examples", "-B", build, "-DCMAKE_BUILD_TYPE=Debug",
                  "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Werror", f"-DCMAKE_PREFIX_PATH={self.prefix}")
        output_of("cmake", "--build", build, "-j", os.cpu_count())
        with self.subTest("check_part"):
            answer = self.check_worker_is_asked(build / "check_part")
            self.assertEqual(answer.returncode, 1)
            self.assertRegex(answer.stdout, r"(?m)^face 1.*: fail, gap 0\.05\d* .*\n(.*\n)*verdict: fail$")
        with self.subTest("reflect_part"):
            picture, rig = self.folder / "hood.png", self.folder / "hood.toml"
            text = output_of(build / "reflect_part", SURFACES / "hood.step", picture, rig)
            self.assertRegex(text, r"lamps cover (9\d|100)")
            self.assertEqual(picture.read_bytes()[1:4], b"PNG")
            self.assertIn("[[c_plane]]", rig.read_text())


if __name__ == "__main__":
    unittest.main()
