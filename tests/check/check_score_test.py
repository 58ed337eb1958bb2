#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The corpus of true and false certificates, and score.py: both checkers have 100 %, and those that are not checkers have less."""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(os.environ["FATHOM_ROOT"])
CHECK = os.environ["FATHOM_CHECK"]
FOLDER = ROOT / "verify" / "check"
FAULTS = (ROOT / "tests" / "data" / "certificates" / "faults.jsonl").read_text()
# Nothing is known that only this check refuses: of a surface without a boundary the normals sum to O.
NEVER_ALONE = {"no facet faces away from the first"}


def score(*words):
    """(exit code, lines)"""
    done = subprocess.run([sys.executable, "-B", FOLDER / "score.py", *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)
    return done.returncode, done.stdout.decode().splitlines()


class Score(unittest.TestCase):
    maxDiff = None

    def test_both_checkers_find_all(self):
        for checker in ([CHECK], [sys.executable, "-B", str(FOLDER / "check.py")]):
            code, lines = score(*checker)
            self.assertEqual(code, 0, lines)
            self.assertRegex(lines[-1], r"^(\d+) of \1 certificates, 100 %; 0 false ones accepted$")
            self.assertEqual([line.split()[0] for line in lines[:-1]], [
                "format1", "format2", "format3", "format4", "format5-solid", "format5-two-bodies", "format6", "no-format"])

    def test_who_is_no_checker(self):
        rows = FAULTS.splitlines()
        true = len({row for row in rows if '"says": "s VERIFIED' in row})
        for words, number, false in ((["true"], true, len(rows) - true), (["sh", "-c", "kill -9 $$"], 0, 0),
                                     (["sh", "-c", "exit 3"], 0, 0), (["sh", "-c", "echo s REFUSED x:1: no; exit 0"], 0, 0)):
            code, lines = score(*words)
            self.assertEqual((code, lines[-1]), (1, f"{number} of {len(rows)} certificates, {100 * number // len(rows)} %; "
                                                    f"{false} false ones accepted"), words)

    def test_one_lie_is_enough(self):
        """A checker that forgets one rule: its certificates are named, and the rule does not count."""
        with tempfile.TemporaryDirectory() as folder:
            forgetful = pathlib.Path(folder) / "forgetful"
            forgetful.write_text(f'#!/bin/sh\ncase $1 in *weight-is-positive*) exit 0 ;; esac\nexec {CHECK} "$1"\n')
            forgetful.chmod(0o755)
            code, lines = score("--without", "format5-solid", forgetful)
            wrong = [line for line in lines if ": expected" in line]
            self.assertTrue(all(re.fullmatch(r"format[1-6][-a-z]*-refused-a-weight-is-positive-this-one-is-not-\d+\.cert: "
                                             "expected REFUSED, found VERIFIED", line) for line in wrong), wrong)
            self.assertEqual((code, lines[-1].split("; ")[1]), (1, f"{len(wrong)} false ones accepted"))
            self.assertFalse([line for line in lines if line.startswith("format5-solid")])
            counts = {words[0]: (words[1], words[3]) for words in map(str.split, lines) if words[-1] == "rules"}
            self.assertEqual(int(counts["format3"][0]) + 1, int(counts["format3"][1]))
            self.assertEqual(*counts["no-format"])

    def test_files(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(score("--files", folder), (0, []))
            files = {path.name: path.read_bytes() for path in pathlib.Path(folder).iterdir()}
            self.assertEqual(len(files), len(FAULTS.splitlines()))
            self.assertEqual(len(set(files.values())), len(files))
            self.assertIn(b"claim depth -", files["format1-refused-a-depth-is-positive-the-claim-is-not-2.cert"])
            self.assertLess(max(map(len, files.values())), 2000)

    def test_misuse(self):
        for words in ([], ["--files", "x", "true"], ["--data", "nowhere", "true"], ["--what"]):
            self.assertEqual(score(*words), (2, []), words)

    def test_each_rule_is_broken(self):
        """Each sentence with which fathom-check refuses a certificate is said of one of them."""
        said = {row["says"] for row in map(json.loads, FAULTS.splitlines())}
        for path in FOLDER.glob("check*.cpp"):
            for rule in re.findall(r'refused\((?:[^"();]|\([^()]*\))*"([^"]+)"', path.read_text()):
                self.assertTrue(rule in NEVER_ALONE or any(f": {rule}" in line for line in said), (path.name, rule))


if __name__ == "__main__":
    unittest.main()
