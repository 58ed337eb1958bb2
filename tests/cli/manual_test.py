# SPDX-License-Identifier: GPL-3.0-or-later
"""Manual pages and completion say what help says, and man and the shells take them."""
import pathlib
import re
import shutil
import subprocess
import unittest

from harness import CliTest
from pages import page_names, section


def options(page):
    """The names of the options of a page of help."""
    titles = [line for line in section(page, "Options") if line.startswith("  -")]
    return [name for title in titles for name in re.findall(r"(?:^|\s)(--?[A-Za-z][\w-]*)", title.strip().split("  ")[0])]


class Manual(CliTest):
    def test_pages(self):
        folder = self.folder / "man1"
        self.assertEqual(self.answer("man", "--all", folder), "")
        commands = [name for name in page_names(self) if " " not in name]
        self.assertEqual({path.name for path in folder.iterdir()},
                         {f"fathom-{name}.1" if name else "fathom.1" for name in commands})
        for name in commands:
            page = (folder / (f"fathom-{name}.1" if name else "fathom.1")).read_text()
            self.assertEqual(self.answer("man", *name.split()), page)
            for option in options(self.answer("help", *name.split())):
                self.assertIn("\\fB" + option.replace("-", "\\-") + "\\fR", page)
        self.assertIn("\\fB\\-\\-shard\\fR", (folder / "fathom-golden.1").read_text(), "those of its tasks too")

    @unittest.skipUnless(shutil.which("groff") and shutil.which("man"), "needs man and groff")
    def test_no_warnings(self):
        self.answer("man", "--all", self.folder)
        for path in sorted(self.folder.glob("*.1")):
            done = subprocess.run(["man", "--warnings", "-E", "UTF-8", "-l", "-Tutf8", path], capture_output=True, check=True,
                                  env={"PATH": "/usr/bin:/bin", "LC_ALL": "C.UTF-8", "MANWIDTH": "80", "MANPAGER": "cat"})
            self.assertEqual(done.stderr, b"", path)
            text = subprocess.run(["groff", "-ww", "-man", "-Tascii", path], capture_output=True, check=True)
            self.assertEqual(text.stderr, b"", path)
            self.assertIn(b"EXIT STATUS", re.sub(rb".\x08", b"", done.stdout))


class Bash(CliTest):
    def completed(self, line):
        """What bash offers for the last word of a line; more of it: transcripts/completion.md."""
        words = line.split() + [""] * line.endswith(" ")
        script = 'eval "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _fathom; printf "%s\\n" "${COMPREPLY[@]}"'
        done = subprocess.run(["bash", "-c", script, "bash", self.answer("completion", "bash"), *words], cwd=self.folder,
                              capture_output=True)
        self.assertEqual(done.stderr, b"")
        return done.stdout.decode().split()

    def test_words(self):
        commands = [name for name in page_names(self) if name and " " not in name]
        self.assertEqual(self.completed("fathom "), commands)
        self.assertEqual(self.completed("fathom golden "), [name.split()[1] for name in page_names(self) if name.startswith("golden ")])

    def test_options(self):
        for name in page_names(self):
            if name:
                self.assertEqual(self.completed(f"fathom {name} -"), options(self.answer("help", *name.split())), name)

    def test_values_from_the_tables_of_the_program(self):
        lists = [self.answer("cases", "--list", *kind) for kind in ([], ["--shapes"], ["--unions"], ["--plane"])]
        families = [line.split()[0] for text in lists for line in text.splitlines()]
        adapters = [line.split()[0] for line in self.answer("certify", "--list-adapters").splitlines()]
        self.assertEqual(self.completed("fathom cases --family "), ["all", *families])
        self.assertEqual(self.completed("fathom certify --adapter "), adapters)
        for policy in self.completed("fathom certify --policy "):
            self.assertIn("nothing.jsonl", self.refused("certify", "--policy", policy, "--subject", "x", "nothing.jsonl"))


class OtherShells(CliTest):
    def check(self, shell, name):
        script = self.answer("completion", shell)
        for page in page_names(self):
            for option in options(self.answer("help", *page.split())):
                self.assertIn(option if shell == "zsh" else f" -{'l' if option.startswith('--') else 's'} {option.lstrip('-')} ", script)
        program = shutil.which(shell)
        if program is None:
            self.skipTest(f"{shell} is not here")
        path = pathlib.Path(self.file(name, script))
        done = subprocess.run([program, "-n", path], capture_output=True)
        self.assertEqual((done.returncode, done.stderr), (0, b""))
        return program, path

    def test_zsh(self):
        program, path = self.check("zsh", "_fathom")
        script = "autoload -Uz compinit && compinit -u -D && source $1 && whence _fathom"
        done = subprocess.run([program, "-f", "-c", script, "zsh", path], capture_output=True)
        self.assertEqual((done.returncode, done.stderr), (0, b""))

    def test_fish(self):
        program, path = self.check("fish", "fathom.fish")
        script = "source $argv[1]; complete -C 'fathom depth --method ex'; complete -C 'fathom golden ver'; complete -C 'fathom wid'"
        done = subprocess.run([program, "--no-config", "-c", script, path], capture_output=True, cwd=self.folder)
        self.assertEqual([line.split("\t")[0] for line in done.stdout.decode().splitlines()], ["exact", "verify", "width"], done.stderr)


if __name__ == "__main__":
    unittest.main()
