"""Debian packages as cpack makes them: their fields, their files, and the program in them."""
import gzip
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

BUILD, SOURCE = Path(os.environ["KEIKO_BUILD_DIR"]), Path(os.environ["KEIKO_SOURCE_DIR"])
VERSION = re.search(r"project\(keiko VERSION (\S+)", (SOURCE / "CMakeLists.txt").read_text())[1]
SKIPPED = 77
# Paths that a package must have, and patterns of those that it may have besides.
FILES = {
    "keiko": (["usr/bin/keiko", "usr/libexec/keiko/keiko-import", "usr/share/keiko/rigs/car-12.toml",
               "usr/share/keiko/presets/class-a-outer.toml", "usr/share/keiko/schema/keiko.schema.json",
               "usr/share/keiko/keiko-array.sbatch",
               "usr/share/man/man1/keiko.1.gz", "usr/share/bash-completion/completions/keiko",
               "usr/share/zsh/vendor-completions/_keiko", "usr/share/fish/vendor_completions.d/keiko.fish"],
              r"usr/lib/(\S+/)?libkeiko\.so\.[\d.]+|usr/share/keiko/((rigs|presets|schema)/.*|keiko-array\.sbatch)|usr/share/man/man1/.*"),
    "keiko-dev": (["usr/include/keiko/api/check.h"], r"usr/include/keiko/.*\.h|"
                  r"usr/lib/(\S+/)?(libkeiko\.so|pkgconfig/keiko\.pc|cmake/keiko/keiko\w+\.cmake)"),
    "keiko-doc": (["usr/share/doc/keiko/library.md", "usr/share/doc/keiko/install/Dockerfile"],
                  r"usr/share/doc/keiko/.*"),
    "python3-keiko": ([f"usr/lib/python3/dist-packages/keiko/{name}" for name in
                       ("__init__.py", "__init__.pyi", "_arguments.py", "_documents.py", "_pages.py", "_picture.py", "_rig.py", "py.typed", "pytest_plugin.py")],
                      r"usr/lib/python3/dist-packages/keiko(/_keiko\.cpython-\d+-\S+\.so|"
                      r"-[\d.]+\.dist-info/(METADATA|INSTALLER))"),
}


def output_of(*command, **options) -> str:
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=500, **options)
    if done.returncode:
        raise AssertionError(f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
    return done.stdout


def setUpModule():
    """Makes the packages once for all tests, and unpacks them into one folder."""
    folder = Path(tempfile.mkdtemp(prefix="packages-", dir=BUILD))
    unittest.addModuleCleanup(shutil.rmtree, folder)
    output_of("cpack", "-G", "DEB", "-B", folder, "--config", BUILD / "CPackConfig.cmake")
    Packages.packages = {file.name.partition("_")[0]: file for file in folder.glob("*.deb")}
    Packages.root = folder / "root"
    for package in Packages.packages.values():
        output_of("dpkg-deb", "-x", package, Packages.root)


class Packages(unittest.TestCase):
    def field(self, package: str, name: str) -> str:
        return output_of("dpkg-deb", "-f", self.packages[package], name).strip()

    def files(self, package: str) -> list:
        """(mode and owner, path) of each file and link of a package."""
        found = []
        for line in output_of("dpkg-deb", "-c", self.packages[package]).splitlines():
            mode, owner, _, _, _, path = line.split(maxsplit=5)
            if not mode.startswith("d"):
                found.append((f"{mode} {owner}", path.partition(" -> ")[0].removeprefix("./")))
        return found

    def control_file(self, package: str, name: str) -> str:
        return output_of("dpkg-deb", "-I", self.packages[package], name)


class Fields(Packages):
    def test_there_are_the_packages_of_this_version(self):
        self.assertLessEqual({"keiko", "keiko-dev", "keiko-doc"}, set(self.packages))
        for name, file in self.packages.items():
            self.assertEqual(file.name, f"{name}_{VERSION}_{self.field(name, 'Architecture')}.deb")
            self.assertEqual((self.field(name, "Package"), self.field(name, "Version")), (name, VERSION))
            self.assertRegex(self.field(name, "Maintainer"), r"^[^<>]+ <\S+@\S+>$")

    def test_packages_of_one_build_belong_together(self):
        for name in set(self.packages) - {"keiko", "keiko-doc"}:
            self.assertIn(f"keiko (= {VERSION})", self.field(name, "Depends").split(", "))
        self.assertIn("libimath-dev", self.field("keiko-dev", "Depends").split(", "))
        self.assertEqual(self.field("keiko-doc", "Depends"), "")

    def test_libraries_are_dependencies(self):
        for library in "libembree", "libtbb", "libocct-", "libosd", "libopenimageio", "libc6 (>=":
            self.assertRegex(self.field("keiko", "Depends"), rf"(^|, ){re.escape(library)}")

    def test_sections_and_descriptions_differ(self):
        sections = {name: self.field(name, "Section") for name in self.packages}
        expected = {"keiko": "science", "keiko-dev": "libdevel", "keiko-doc": "doc", "python3-keiko": "python"}
        self.assertEqual(sections, {name: expected[name] for name in sections})
        self.assertEqual(len({self.field(name, "Description").splitlines()[0] for name in sections}), len(sections))

    def test_programs_find_the_library_and_its_package(self):
        soname = ".".join(VERSION.split(".")[:2])
        self.assertEqual(self.control_file("keiko", "shlibs"), f"libkeiko {soname} keiko (>= {VERSION})\n")
        self.assertIn("activate-noawait ldconfig\n", self.control_file("keiko", "triggers"))


class Files(Packages):
    def test_each_package_has_its_files_and_no_others(self):
        for name in self.packages:
            needed, allowed = FILES[name]
            needed = [*needed, *(f"usr/share/doc/{name}/{file}" for file in ("copyright", "changelog.gz"))]
            paths = [path for _, path in self.files(name)]
            self.assertFalse(set(needed) - set(paths), name)
            self.assertFalse([path for path in paths if path not in needed and not re.fullmatch(allowed, path)], name)

    def test_no_file_is_in_two_packages(self):
        paths = [path for name in self.packages for _, path in self.files(name)]
        self.assertEqual(len(paths), len(set(paths)))

    def test_files_belong_to_root_and_nobody_else_writes_them(self):
        for name in self.packages:
            for mode, path in self.files(name):
                self.assertRegex(mode, r"^(-rw-r--r--|-rwxr-xr-x|lrwxrwxrwx) (root/root|0/0)$", path)

    def test_programs_are_stripped_and_search_no_folder_of_the_build(self):
        binaries = [path for name in self.packages for mode, path in self.files(name)
                    if mode.startswith("-") and re.search(r"/keiko$|keiko-import$|\.so(\.[\d.]+)?$", path)
                    and "completions" not in path]
        self.assertGreaterEqual(len(binaries), 3)
        for path in binaries:
            sections = output_of("readelf", "-SdW", self.root / path)
            self.assertNotRegex(sections, r"\.symtab|\.debug_info|RUNPATH|RPATH", path)

    def test_the_changelog_begins_with_this_version(self):
        text = gzip.decompress((self.root / "usr/share/doc/keiko/changelog.gz").read_bytes()).decode()
        self.assertTrue(text.startswith(f"keiko ({VERSION}) "), text[:40])

    def test_every_command_has_a_man_page(self):
        listed = output_of(self.root / "usr/bin/keiko", "--help").split("ubcommands:\n", 1)[1]
        names = {"keiko", *(f"keiko-{name}" for name in re.findall(r"^  ([a-z-]+) ", listed, re.M))}
        pages = {path.name: gzip.decompress(path.read_bytes()).decode()
                 for path in (self.root / "usr/share/man/man1").iterdir()}
        self.assertEqual(set(pages), {f"{name}.1.gz" for name in names})
        for name in names - {"keiko"}:
            command = name.partition("-")[2]
            options = set(re.findall(r"^  (?:-\w,)?(--[a-z-]+)",
                                     output_of(self.root / "usr/bin/keiko", command, "--help"), re.M))
            told = pages[f"{name}.1.gz"].replace("\\-", "-")
            self.assertFalse([option for option in options if f"{option}\\fR" not in told], name)
            self.assertIn(f".SH NAME\n{name} - ", told)


class Unpacked(Packages):
    def environment(self) -> dict:
        library = next(self.root.rglob("libkeiko.so.*")).parent
        kept = {key: value for key, value in os.environ.items() if key != "KEIKO_IMPORT"}
        return {**kept, "LD_LIBRARY_PATH": str(library),
                "PYTHONPATH": str(self.root / "usr/lib/python3/dist-packages")}

    def test_the_program_reads_with_the_worker_of_its_package(self):
        facts = output_of(self.root / "usr/bin/keiko", "--version", "--verbose", env=self.environment())
        self.assertIn(f"reader      {self.root}/usr/libexec/keiko/keiko-import\n", facts)
        said = output_of(self.root / "usr/bin/keiko", "info", SOURCE / "surfaces/seam-g0-gap.step",
                         env=self.environment())
        self.assertIn("seam-g0-gap", said)

    def test_the_module_uses_library_and_worker_of_the_program(self):
        if "python3-keiko" not in self.packages:
            self.skipTest("there is no python3-keiko")
        script = ("import keiko, sys; keiko.info(sys.argv[1]); "
                  "print([line.split()[-1] for line in open('/proc/self/maps') if 'libkeiko' in line][0])")
        said = output_of("/usr/bin/python3", "-B", "-c", script, SOURCE / "surfaces/seam-g0-gap.step",
                         env=self.environment())
        self.assertTrue(said.startswith(f"{self.root}/usr/lib/libkeiko.so."), said)

    def test_pip_knows_the_module(self):
        if "python3-keiko" not in self.packages:
            self.skipTest("there is no python3-keiko")
        script = ("import importlib.metadata as m, keiko; d = m.distribution('keiko'); "
                  "print(d.version == keiko.__version__, d.read_text('INSTALLER').strip(), d.requires)")
        said = output_of("/usr/bin/python3", "-B", "-c", script, env=self.environment())
        self.assertEqual(said, "True debian ['numpy>=1.24']\n")

    def test_the_script_for_cad_systems_reads_what_fails(self):
        page = (SOURCE / "docs/install/cad-script.md").read_text(encoding="utf-8")
        script = re.search(r"```python\n(.*?)```", page, re.S)[1]
        part = shutil.copy(SOURCE / "surfaces/seam-g0-gap.step", self.root)
        environment = {**self.environment(), "PATH": f"{self.root}/usr/bin:{os.environ['PATH']}"}
        said = output_of(sys.executable, "-c", f"{script}\nshow({str(part)!r})", env=environment)
        self.assertRegex(said, r"^fail\n1 face 1 .* gap of 0\.05 mm .*\[0\.0, -54\.06.*\]\n$")
        with self.assertRaisesRegex(AssertionError, "RuntimeError: keiko: .*no-such"):
            output_of(sys.executable, "-c", f"{script}\nshow('no-such.step')", env=environment)


if __name__ == "__main__":
    for needed in "cpack", "dpkg-deb", "dpkg-shlibdeps", "file", "readelf":
        if not shutil.which(needed):
            print(f"packages are not tested: there is no {needed}")
            sys.exit(SKIPPED)
    unittest.main()
