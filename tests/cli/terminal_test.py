# SPDX-License-Identifier: GPL-3.0-or-later
"""Whatever a person sees fits the terminal; files and pipes get whole lines."""
import os
import subprocess
import unittest

from harness import EXECUTABLE, ROOT, CliTest
from pages import page_names
from terminals import run_on_terminal

WIDTHS = (40, 80, 200)
DATA = ROOT / "examples" / "data"
WITHOUT_COLUMNS = {name: value for name, value in os.environ.items() if name != "COLUMNS"}


def on_terminal(columns, *arguments, environment=None):
    """(exit code, the lines that appeared on a terminal of this width, on standard output and error)."""
    code, _, seen = run_on_terminal(*arguments, columns=columns, stdout=None, cwd=DATA, stdin=subprocess.DEVNULL, env=environment
                                    or WITHOUT_COLUMNS)
    return code, seen.decode().replace("\x1b[K", "").replace("\r\n", "\n").splitlines()


class Width(CliTest):
    def fits(self, lines, columns):
        for line in lines:
            self.assertLessEqual(len(line), columns, line)

    def test_help(self):
        for name in page_names(self):
            pages = {}
            for columns in WIDTHS:
                done = subprocess.run([EXECUTABLE, *name.split(), "--help"], env={**os.environ, "COLUMNS": str(columns)},
                                      capture_output=True)
                self.assertEqual((done.returncode, done.stderr), (0, b""))
                pages[columns] = done.stdout.decode()
                self.assertTrue(pages[columns].startswith("Examples\n"))
                self.fits(pages[columns].splitlines(), columns)
            words = [" ".join(page.replace("\\\n", " ").split()) for page in pages.values()]
            self.assertEqual(len(set(words)), 1, "the same words at every width")
            self.assertEqual(self.answer("help", *name.split()), self.answer(*name.split(), "--help"))
        self.assertGreater(max(map(len, pages[200].splitlines())), 80)

    def test_help_asks_the_terminal(self):
        for columns in WIDTHS:
            self.fits(on_terminal(columns, "depth", "--help")[1], columns)
        wide, narrow = (on_terminal(columns, "depth", "--help")[1] for columns in (100, 50))
        self.assertLess(len(wide), len(narrow))
        self.assertEqual(on_terminal(100, "depth", "--help", environment={**os.environ, "COLUMNS": "50"})[1], narrow)
        for columns in ("0", "-1", "x", "", "99999999999999999999"):  # no numbers of columns
            self.assertEqual(on_terminal(50, "depth", "--help", environment={**os.environ, "COLUMNS": columns})[1], narrow)

    def test_results(self):
        for arguments in (["depth", "a.off", "b.stl"], ["depth", "--counters", "a.off", "b.stl"], ["width", "a.off"],
                          ["depth", "cases.jsonl"], ["approx", "a.off", "b.stl"], ["ray", "--direction", "1,2,3", "a.off", "b.stl"],
                          ["study", "a.off", "b.stl"], ["metric", "--ball", "q.off", "a.off", "b.stl"], ["cases", "--list"],
                          ["certify", "--list-adapters"], ["certify", "--subject", "./mine", "cases.jsonl"],
                          ["depth", "sphere:r=1", "box:half=1:1:1"]):
            whole = subprocess.run([EXECUTABLE, *arguments], cwd=DATA, env={**os.environ, "COLUMNS": "40"},
                                   capture_output=True).stdout.decode()
            for columns in WIDTHS:
                with self.subTest(arguments=arguments, columns=columns):
                    _, lines = on_terminal(columns, *arguments)
                    self.fits(lines, columns)
                    if arguments[0] != "certify":  # its table is made for the width
                        self.assertEqual(" ".join(" ".join(lines).split()), " ".join(whole.split()))
            if arguments[0] == "certify":
                continue
            _, lines = on_terminal(1000, *arguments)
            self.assertEqual("\n".join(lines) + "\n", whole, "files and pipes get whole lines")

    def test_messages(self):
        for columns in WIDTHS:
            for arguments in (["dept"], ["depth", "a.off"], ["a.off", "b.off"], ["depth", "--method", "exat", "a.off", "b.off"]):
                code, lines = on_terminal(columns, *arguments)
                self.assertEqual(code, 2)
                self.fits(lines, columns)

    def test_the_checker_alone(self):
        out = subprocess.run([os.environ["FATHOM_CHECK"], "--help"], capture_output=True, check=True).stdout.decode()
        self.fits(out.splitlines(), 80)


if __name__ == "__main__":
    unittest.main()
