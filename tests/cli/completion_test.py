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

# In place of the program: writes the words that it would get, a line each.
SHOW = "keiko() { printf '%s\\n' \"$@\" >words.new; mv words.new words; }"
BASH = (["bash", "--norc", "--noprofile", "-i"],
        ["bind 'set enable-bracketed-paste off'", "bind 'set show-all-if-ambiguous on'",
         "bind 'set completion-query-items 0'", "bind 'set page-completions off'", "source keiko.bash", SHOW])
ZSH = (["zsh", "-f", "-i"], ["fpath=($PWD $fpath)", "autoload -Uz compinit", "compinit -u -d dump", SHOW])
# Words that the program gets of a line, in which a tab is typed.
COMPLETED = {
    "keiko insp\t": ["inspect"],
    "keiko --vers\t": ["--version"],
    "keiko check --sar\t": ["check", "--sarif"],
    "keiko check left\t": ["check", "left fender.step"],
    "keiko check --json left\t": ["check", "--json", "left fender.step"],
    "keiko check --json=left\t": ["check", "--json=left fender.step"],
    "keiko trace --intersector cl\t": ["trace", "--intersector", "clipping"],
    "keiko trace --intersector=cl\t": ["trace", "--intersector=clipping"],
    "keiko completion f\t": ["completion", "fish"],
    "keiko check --join 1\t": ["check", "--join", "1"],  # a number, although there is a file 1.step
}


class Shell:
    """An interactive shell on a terminal of its own, in a folder."""

    def __init__(self, folder, command: list, setup: list):
        self.folder = folder
        self.process, self.terminal = pty.fork()
        if self.process == 0:
            os.chdir(folder)
            os.execvpe(command[0], command, {"TERM": "dumb", "PS1": "$ ", "PATH": os.environ["PATH"],
                                             "HOME": str(folder), "COLUMNS": "500", "LC_ALL": "C"})
        for line in setup:
            self.show(line)

    def show(self, keys: str) -> str:
        """What the terminal shows after these keys, up to the end of the command line that they are on."""
        completed, tab, rest = keys.rpartition("\t")
        os.write(self.terminal, (completed + tab).encode())
        shown, end = "", time.monotonic() + 30
        # A shell that has further keys to read may list nothing.
        while tab and (not shown or select.select([self.terminal], [], [], 0.3)[0]):
            shown += os.read(self.terminal, 65536).decode(errors="replace")
        # The mark is typed in two halves, so that the echo of the keys is none.
        os.write(self.terminal, f"{rest}\necho EN''D\n".encode())
        while not re.search(r"(?m)^END\r?$", shown):
            if not select.select([self.terminal], [], [], max(0, end - time.monotonic()))[0]:
                raise AssertionError(f"the shell does not answer: {shown!r}")
            shown += os.read(self.terminal, 65536).decode(errors="replace")
        return shown

    def words(self, keys: str) -> list:
        """The words that the program gets of a line with completed words."""
        self.show(keys)
        return (self.folder / "words").read_text().splitlines()

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


class Typed(Scripts):
    def start(self, command: list, setup: list) -> Shell:
        if not shutil.which(command[0]):
            self.skipTest(f"there is no {command[0]}")
        self.write("left fender.step", "")
        self.write("1.step", "")
        shell = Shell(self.folder, command, setup)
        self.addCleanup(shell.close)
        return shell

    def start_bash(self) -> Shell:
        self.write_script("bash", "keiko.bash")
        return self.start(*BASH)

    def check_completions(self, shell: Shell):
        for keys, words in COMPLETED.items():
            with self.subTest(keys):
                self.assertEqual(shell.words(keys), words)

    def test_bash_completes_commands_options_choices_and_files(self):
        self.check_completions(self.start_bash())

    def test_zsh_completes_commands_options_choices_and_files(self):
        self.write_script("zsh", "_keiko")
        self.check_completions(self.start(*ZSH))

    def test_bash_proposes_every_command(self):
        shown = self.start_bash().show("keiko \t\x15")
        self.assertLessEqual(set(self.all_commands()), set(shown.split()))

    def test_bash_proposes_every_option_of_every_command(self):
        bash = self.start_bash()
        for command in self.all_commands():
            shown = bash.show(f"keiko {command} -\t\x15")
            self.assertLessEqual(self.options_of(command), set(shown.split()), command)


class InFish(Scripts):
    def run_fish(self, script: str) -> str:
        done = subprocess.run(["fish", "--no-config", "-c", script], cwd=self.folder, capture_output=True, text=True,
                              timeout=60, env={**os.environ, "HOME": str(self.folder), "TERM": "dumb"})
        self.assertEqual((done.returncode, done.stderr), (0, ""), script)
        return done.stdout

    @unittest.skipUnless(shutil.which("fish"), "there is no fish")
    def test_fish_completes_commands_options_choices_and_files(self):
        def completed(line: str) -> list:
            said = self.run_fish(f"source keiko.fish; complete -C '{line}'")
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
