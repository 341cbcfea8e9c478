"""What the program says of itself."""
import os
import re
import subprocess
import unittest
from pathlib import Path

from keiko_process import BINARY, SOURCE, KeikoTest


class Help(KeikoTest):
    def commands(self) -> list:
        """As keiko --help lists them, each on an indented line below a heading."""
        listed = self.succeed("--help").split("ubcommands:\n", 1)[1]
        return re.findall(r"^  ([a-z-]+) ", listed, re.M)

    def test_there_are_the_documented_commands(self):
        self.assertLessEqual({"illuminance", "info", "inspect", "place", "render", "trace"}, set(self.commands()))

    def test_every_help_holds_an_example_of_its_command(self):
        for command in self.commands():
            self.assertRegex(self.succeed(command, "--help"), rf"\nExamples?: keiko {command} \S")

    def test_every_option_is_explained(self):
        for command in self.commands():
            options = self.succeed(command, "--help").split("Options:\n", 1)[1]
            for option in re.findall(r"^  (-.*(?:\n {10}.*)*)", options, re.M):
                self.assertRegex(option, r"\s[a-z0-9]\S+", command)

    def test_every_command_that_traces_lets_the_intersector_be_chosen(self):
        for command in "illuminance", "inspect", "place", "render", "trace":
            self.assertRegex(self.succeed(command, "--help"), r"--intersector .*clipping")

    def test_no_command_is_an_error(self):
        run = self.keiko()
        self.assertEqual((run.returncode, run.stdout), (2, ""))
        self.assertRegex(run.stderr, r"\Akeiko: .*see keiko --help\n\Z")

    def test_the_version_is_that_of_the_project(self):
        project = (SOURCE / "CMakeLists.txt").read_text()
        version = re.search(r"project\(keiko VERSION (\S+)", project)[1]
        self.assertEqual(self.succeed("--version"), version + "\n")

    def facts(self, **options) -> dict:
        """What --version --verbose states, lists of values by their names."""
        run = self.keiko("--version", "--verbose", **options)
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        found = {}
        for line in run.stdout.splitlines():
            found.setdefault(line[:12].strip(), []).append(line[12:])
        return found

    def test_the_verbose_version_states_the_build_and_its_libraries(self):
        facts = self.facts()
        self.assertEqual(facts["version"], [self.succeed("--version").strip()])
        notes = subprocess.run(["readelf", "-n", BINARY], capture_output=True, text=True).stdout
        self.assertIn(f"Build ID: {facts['build id'][0]}\n", notes)
        self.assertRegex(facts["compiler"][0], r"^(GCC|Clang) \d+\.")
        self.assertRegex(facts["SIMD"][0], r"^[A-Z][A-Z0-9_]+$")
        self.assertEqual(facts["reader"], [str(Path(BINARY).resolve().with_name("keiko-import"))])
        libraries = dict(line.rsplit(" ", 1) for line in facts["library"])
        self.assertEqual(set(libraries), {"Embree", "oneTBB", "OpenImageIO", "OpenCASCADE", "OpenSubdiv"})
        for version in libraries.values():
            self.assertRegex(version, r"^\d+(\.\d+)+$")

    def test_the_verbose_version_states_what_is_wrong_with_the_reader(self):
        for reader, fault in (str(self.folder / "none"), "No such file"), ("/bin/false", "does not state"):
            facts = self.facts(env={**os.environ, "KEIKO_IMPORT": reader})
            self.assertRegex(facts["reader"][0], f"^{reader}: .*{fault}")
            self.assertEqual(len(facts["library"]), 3)

    def test_verbose_without_version_or_command_is_an_error(self):
        run = self.keiko("--verbose")
        self.assertEqual((run.returncode, run.stdout), (2, ""))
        self.assertRegex(run.stderr, r"\Akeiko: .*\n\Z")


if __name__ == "__main__":
    unittest.main()
