"""What the program says of itself."""
import re
import unittest

from keiko_process import SOURCE, KeikoTest


class Help(KeikoTest):
    def commands(self) -> list:
        """As keiko --help lists them, each on an indented line below a heading."""
        listed = self.succeed("--help").split("ubcommands:\n", 1)[1]
        return re.findall(r"^  ([a-z-]+) ", listed, re.M)

    def test_there_are_the_documented_commands(self):
        self.assertLessEqual({"illuminance", "info", "inspect", "place", "render", "trace"}, set(self.commands()))

    def test_every_help_holds_an_example_of_its_command(self):
        for command in self.commands():
            self.assertRegex(self.succeed(command, "--help"), rf"\nExample: keiko {command} \S")

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


if __name__ == "__main__":
    unittest.main()
