# SPDX-License-Identifier: GPL-3.0-or-later
"""The worked examples of golden cases in other people's tests: GoogleTest by FetchContent, pytest, and Rust where it is installed."""
import os
import shutil
import subprocess
import sys
import unittest

from harness import EXECUTABLE, ROOT, CliTest

EXAMPLES = ROOT / "verify" / "examples" / "golden"
KIT = ROOT / "verify" / "golden" / "kit"


class Examples(CliTest):
    def example(self, name):
        """A copy of an example, with the kit and its sample beside it."""
        for path in (EXAMPLES / name, KIT / "fathom_golden.py"):
            shutil.copy(path, self.folder)
        self.run_it(KIT / "make.sh", self.folder, EXECUTABLE)
        return self.folder / name

    def run_it(self, *words, folder=None):
        """What is printed by a command that must succeed."""
        done = subprocess.run(list(map(str, words)), cwd=folder or self.folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.assertEqual(done.returncode, 0, done.stdout)
        return done.stdout

    def repository(self):
        """The address of a repository with the kit, and its commit as `fathom --version` names one."""
        folder = self.folder / "repository"
        for part in ("verify/golden/kit", "tests/data/golden"):
            shutil.copytree(ROOT / part, folder / part)
        git = ("git", "-c", "user.name=somebody", "-c", "user.email=somebody@localhost")
        for words in (["init", "-q"], ["add", "."], ["commit", "-q", "-m", "the kit"]):
            self.run_it(*git, *words, folder=folder)
        return folder.as_uri(), self.run_it("git", "rev-parse", "--short=12", "HEAD", folder=folder).strip()

    @unittest.skipUnless(shutil.which("git"), "FetchContent needs git")
    def test_googletest(self):
        build = self.folder / "build"
        address, commit = self.repository()
        self.run_it("cmake", "-S", EXAMPLES, "-B", build, f"-DFATHOM={address}", f"-DCOMMIT={commit}",
                    f"-DFATHOM_PROGRAM={EXECUTABLE}")
        self.run_it("cmake", "--build", build)
        self.assertIn("[  PASSED  ] 2 tests.", self.run_it(build / "golden_test"))

    def test_pytest(self):
        self.assertRegex(self.run_it(sys.executable, "-B", "-m", "pytest", "-q", "-p", "no:cacheprovider", self.example("golden_test.py")),
                         r"\n51 passed")

    def test_rust(self):
        for name in ("rustc", os.path.expanduser("~/.cargo/bin/rustc")):
            if shutil.which(name):
                break
        else:
            self.skipTest("rustc is not installed")
        example = self.example("golden_test.rs")
        self.run_it(name, "--edition", "2021", "-D", "warnings", "--test", "-o", self.folder / "golden_test", example)
        self.assertIn("2 passed; 0 failed", self.run_it(self.folder / "golden_test"))


if __name__ == "__main__":
    unittest.main()
