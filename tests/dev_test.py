"""./dev keeps the log that its output goes to, lints what the last commit changed, and makes packages."""
import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

DEV = Path(__file__).resolve().parent.parent / "dev"
# In place of the programs that would install, configure, build and lint.
PROGRAMS = {
    "dpkg-query": 'shift 3; for package; do printf "%s:ii " "$package"; done',
    "cmake": """case $1 in
  --preset)
    echo "-- Configuring done"
    mkdir -p build/release/bin
    echo '"command": "g++ -mmemset-strategy=vector_loop:512:noalign -flto -ffat-lto-objects -O3 -c a.cpp"' \\
      >build/release/compile_commands.json
    : >build/release/build.ninja ;;
  --build)
    echo "[1/1] Linking"
    printf '#!/bin/sh\\necho "keiko $*"\\n' >build/release/bin/keiko
    chmod +x build/release/bin/keiko ;;
esac""",
    "cpack": """echo "cpack $*" >>made
: >build/package/keiko_1_all.deb""",
    "python3": 'echo "python3 $*"',
    "clang-tidy": """for file; do :; done
echo "linted $file"
! grep -q bug "$file"
""",
}
NEEDED = "bash cat date dirname env git grep ls mkdir nproc paste rm sed sh sort xargs chmod".split()


class DevTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="keiko-dev-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name) / "checkout"
        self.programs = Path(folder.name) / "bin"
        self.folder.mkdir()
        self.programs.mkdir()
        shutil.copy(DEV, self.folder / "dev")
        for name, text in PROGRAMS.items():
            (self.programs / name).write_text("#!/bin/sh\n" + text + "\n")
            (self.programs / name).chmod(0o755)
        for name in NEEDED:
            (self.programs / name).symlink_to(shutil.which(name))

    def dev(self, *arguments: str, **options):
        environment = {"PATH": str(self.programs), "HOME": str(self.folder), "GIT_CEILING_DIRECTORIES":
                       str(self.folder.parent)}
        return subprocess.run(["./dev", *arguments], cwd=self.folder, env=environment, text=True, **options)


class Logs(DevTest):
    def log_of(self, *arguments: str) -> str:
        log = self.folder.parent / "log"
        with open(log, "w") as file:
            file.write("what stood there before\n")
            file.flush()
            self.dev(*arguments, stdout=file, stderr=subprocess.STDOUT, check=True)
        return log.read_text()

    def test_the_first_configuration_leaves_the_log_whole(self):
        self.assertEqual(self.log_of("run", "info"), "what stood there before\n-- Configuring done\n"
                                                     "[1/1] Linking\nkeiko info\n")

    def test_later_ones_are_silent(self):
        self.log_of("build")
        self.assertEqual(self.log_of("build"), "what stood there before\n[1/1] Linking\n")


class Packages(DevTest):
    def test_are_made_anew_and_listed(self):
        stale = self.folder / "build/package/old_0_all.deb"
        stale.parent.mkdir(parents=True)
        stale.write_text("")
        run = self.dev("package", capture_output=True, check=True)
        self.assertEqual(run.stdout, "build/package/keiko_1_all.deb\n")
        self.assertFalse(stale.exists())
        self.assertRegex((self.folder / "made").read_text(), r"^cpack -G DEB -B build/package --config build/release/")

    def test_are_tried_only_on_request(self):
        run = self.dev("package", "--try", capture_output=True, check=True)
        self.assertRegex(run.stdout, r"\.deb\npython3 -B tests/install/try_packages\.py build/package build/try/debian\n$")
        run = self.dev("package", "--tri", capture_output=True)
        self.assertEqual((run.returncode, run.stdout), (2, ""))
        self.assertIn("package --try", run.stderr)


class LintOfTheLastCommit(DevTest):
    def git(self, *arguments: str):
        subprocess.run(["git", "-c", "user.name=x", "-c", "user.email=x@y", "-c", "commit.gpgsign=false",
                        *arguments], cwd=self.folder, check=True, capture_output=True)

    def commit(self, **files: str):
        """Commits a_cpp="..." as src/a.cpp."""
        if not (self.folder / ".git").exists():
            self.git("init", "-q")
        (self.folder / "src").mkdir(exist_ok=True)
        for name, text in files.items():
            (self.folder / "src" / name.replace("_", ".")).write_text(text)
        self.git("add", "src")
        self.git("commit", "-q", "-m", "change")

    def lint(self):
        return self.dev("lint", "--changed", capture_output=True)

    def assert_skipped(self, reason: str):
        run = self.lint()
        self.assertEqual((run.returncode, run.stdout), (0, ""))
        self.assertEqual(run.stderr, f"lint of the last commit skipped: {reason}\n")

    def test_is_skipped_without_history(self):
        self.assert_skipped("there is no commit before it")
        self.commit(a_cpp="")
        self.assert_skipped("there is no commit before it")

    def test_is_skipped_without_clang_tidy(self):
        self.commit(a_cpp="")
        self.commit(a_cpp="bug")
        (self.programs / "clang-tidy").unlink()
        self.assert_skipped("there is no clang-tidy")

    def test_fails_for_what_changed_alone(self):
        self.commit(a_cpp="bug", b_cpp="")
        self.commit(b_cpp="fine")
        run = self.lint()
        self.assertEqual((run.returncode, run.stdout), (0, "linted src/b.cpp\n"), run.stderr)
        self.commit(b_cpp="bug")
        self.assertNotEqual(self.lint().returncode, 0)

    def test_a_header_is_linted_with_its_source(self):
        self.commit(a_cpp="", a_h="", b_h="")
        self.commit(a_h="x", b_h="x")
        self.assertEqual(self.lint().stdout, "linted src/a.cpp\n")

    def test_a_file_that_was_moved_is_no_change(self):
        text = "bug\n" + "line\n" * 20
        self.commit(a_cpp=text)
        self.git("mv", "src/a.cpp", "src/b.cpp")
        self.commit(b_cpp=text + "line\n", c_cpp="")
        self.assertEqual(self.lint().stdout, "linted src/c.cpp\n")

    def test_of_many_files_the_first_are_linted(self):
        self.commit(a_cpp="")
        self.commit(**{f"f{i:02}_cpp": "" for i in range(25)})
        run = self.lint()
        self.assertIn("clang-tidy over 20 of 25 changed files\n", run.stderr)
        self.assertEqual(run.stdout.count("linted"), 20)

    def test_flags_of_gcc_alone_are_kept_from_clang_tidy(self):
        self.commit(a_cpp="")
        self.commit(a_cpp="fine")
        self.lint()
        self.assertEqual((self.folder / "build/lint/compile_commands.json").read_text(),
                         '"command": "g++ -O3 -c a.cpp"\n')


if __name__ == "__main__":
    unittest.main()
