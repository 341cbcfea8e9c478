"""Half-typed commands, completed by the scripts of `keiko completion` in the shells themselves."""
import os
import pty
import re
import select
import shutil
import subprocess
import time
import unittest

from keiko_process import KeikoTest

# In place of the program: shows the words that it would get.
SHOW = "keiko() { printf '<%s>' \"$@\"; echo; }"
SETUP = ["bind 'set enable-bracketed-paste off'", "bind 'set show-all-if-ambiguous on'",
         "bind 'set completion-query-items 0'", "bind 'set page-completions off'", "source keiko.bash", SHOW]


class Bash:
    """An interactive bash on a terminal of its own."""

    def __init__(self, folder):
        self.process, self.terminal = pty.fork()
        if self.process == 0:
            os.chdir(folder)
            os.execve("/bin/bash", ["bash", "--norc", "--noprofile", "-i"],
                      {"TERM": "dumb", "PS1": "$ ", "PATH": os.environ["PATH"], "COLUMNS": "500", "LC_ALL": "C"})
        for line in SETUP:
            self.type(line)

    def type(self, keys: str) -> str:
        """What the terminal shows after these keys, up to the end of the command line that they are on."""
        # The mark is typed in two halves, so that the echo of the keys is none.
        os.write(self.terminal, f"{keys}\necho EN''D\n".encode())
        shown, end = "", time.monotonic() + 20
        while "END" not in shown.replace("EN''D", ""):
            if not select.select([self.terminal], [], [], max(0, end - time.monotonic()))[0]:
                raise AssertionError(f"bash does not answer: {shown!r}")
            shown += os.read(self.terminal, 65536).decode(errors="replace")
        return shown

    def words(self, keys: str) -> list:
        """The words that the program gets of a line with completed words."""
        shown = re.findall(r"(?m)^(?:<[^>]*>)+\r?$", self.type(keys))
        return re.findall(r"<([^>]*)>", shown[-1]) if shown else []

    def close(self):
        os.close(self.terminal)
        os.waitpid(self.process, 0)


class Scripts(KeikoTest):
    """Each test has the script of its shell in its folder."""

    def write_script(self, shell: str, name: str):
        self.write(name, self.succeed("completion", shell))

    def all_commands(self) -> list:
        return re.findall(r"^  ([a-z-]+) ", self.succeed("--help").split("ubcommands:\n", 1)[1], re.M)

    def options_of(self, *command: str) -> set:
        """The long options of a command, of which its help has one a line."""
        return set(re.findall(r"^  (?:-\w,)?(--[a-z-]+)", self.succeed(*command, "--help"), re.M))


class InBash(Scripts):
    def setUp(self):
        super().setUp()
        self.write_script("bash", "keiko.bash")
        self.bash = Bash(self.folder)
        self.addCleanup(self.bash.close)

    def test_a_command_is_completed(self):
        self.assertEqual(self.bash.words("keiko insp\t"), ["inspect"])

    def test_every_command_is_proposed(self):
        shown = self.bash.type("keiko \t\x15")
        self.assertLessEqual(set(self.all_commands()), set(shown.split()))

    def test_an_option_is_completed(self):
        self.assertEqual(self.bash.words("keiko check --sar\t"), ["check", "--sarif"])
        self.assertEqual(self.bash.words("keiko --vers\t"), ["--version"])

    def test_every_option_of_every_command_is_proposed(self):
        for command in self.all_commands():
            shown = self.bash.type(f"keiko {command} -\t\x15")
            self.assertLessEqual(self.options_of(command), set(shown.split()), command)

    def test_names_of_files_are_completed_for_arguments_and_options(self):
        self.write("left fender.step", "")
        self.assertEqual(self.bash.words("keiko check left\t"), ["check", "left fender.step"])
        self.assertEqual(self.bash.words("keiko check --json left\t"), ["check", "--json", "left fender.step"])
        self.assertEqual(self.bash.words("keiko check --json=left\t"), ["check", "--json=left fender.step"])

    def test_words_of_a_choice_are_completed(self):
        self.assertEqual(self.bash.words("keiko trace --intersector cl\t"), ["trace", "--intersector", "clipping"])
        self.assertEqual(self.bash.words("keiko trace --intersector=cl\t"), ["trace", "--intersector=clipping"])
        self.assertEqual(self.bash.words("keiko completion f\t"), ["completion", "fish"])

    def test_nothing_is_proposed_for_a_number(self):
        self.write("1.step", "")
        self.assertEqual(self.bash.words("keiko check --join 1\t"), ["check", "--join", "1"])


class InOtherShells(Scripts):
    def run_shell(self, *command: str) -> str:
        if not shutil.which(command[0]):
            self.skipTest(f"there is no {command[0]}")
        done = subprocess.run(command, cwd=self.folder, capture_output=True, text=True, timeout=60,
                              env={**os.environ, "HOME": str(self.folder), "TERM": "dumb"})
        self.assertEqual((done.returncode, done.stderr), (0, ""), command)
        return done.stdout

    def test_zsh_reads_the_script(self):
        self.write_script("zsh", "_keiko")
        self.run_shell("zsh", "-f", "-n", "_keiko")
        said = self.run_shell("zsh", "-f", "-c", "fpath=($PWD $fpath); autoload -Uz compinit; compinit -u -d dump; "
                              "print $_comps[keiko]")
        self.assertEqual(said, "_keiko\n")

    def test_fish_reads_the_script_and_completes(self):
        def completed(line: str) -> list:
            said = self.run_shell("fish", "--no-config", "-c", f"source keiko.fish; complete -C '{line}'")
            return [proposal.split("\t")[0] for proposal in said.splitlines()]
        self.write_script("fish", "keiko.fish")
        self.write("left.step", "")
        self.assertEqual(completed("keiko insp"), ["inspect"])
        self.assertEqual(completed("keiko check --sar"), ["--sarif"])
        self.assertEqual(completed("keiko trace --intersector cl"), ["clipping"])
        self.assertEqual(completed("keiko check lef"), ["left.step"])
        self.assertEqual(completed("keiko lef"), [])


class Errors(KeikoTest):
    def test_another_shell_is_refused_in_one_line(self):
        run = self.keiko("completion", "tcsh")
        self.assertEqual((run.returncode, run.stdout), (2, ""))
        self.assertRegex(run.stderr, r"\Akeiko: .*tcsh.*\n\Z")


if __name__ == "__main__":
    unittest.main()
