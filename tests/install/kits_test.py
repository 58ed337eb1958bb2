#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The packages of the kits, installed from the packed files, without a network: a subject in JavaScript is certified, and the golden sample
accepts its own answers in JavaScript and Python, and refuses others."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(os.environ["FATHOM_ROOT"])
FATHOM = os.environ["FATHOM_EXECUTABLE"]
OFFLINE = ["--offline", "--no-audit", "--no-fund", "--ignore-scripts", "--silent"]
ACCEPTS = """import { accept, acceptApart, sample } from 'fathom-golden';
const tolerance = { relative: 1e-12 };
let right = 0, wrong = 0;
for (const golden of sample()) {
  right += accept(golden, golden.directions[0] ?? null, golden.signed_depth, tolerance);
  wrong += accept(golden, null, golden.signed_depth + golden.size, tolerance);
  wrong += accept(golden, [0, 0, 0], golden.signed_depth, tolerance);
  if (golden.status === 'penetrating' && golden.signed_depth > 1e-3 * golden.size) wrong += acceptApart(golden, tolerance);
}
console.log(right, wrong);
"""
ACCEPTS_PYTHON = """import fathom_golden
cases = fathom_golden.sample()
right = sum(fathom_golden.accept(case, case.directions[0], case.signed_depth, relative=1e-12) for case in cases)
wrong = sum(fathom_golden.accept(case, None, case.signed_depth + case.size, relative=1e-12) for case in cases)
print(fathom_golden.__file__, right, wrong)
"""


def run(*words, **options):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, **options)
    assert done.returncode == 0, f"{words} ended with {done.returncode}\n{done.stdout}{done.stderr}"
    return done.stdout


class Kits(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        run(ROOT / "packaging" / "kits.sh", cls.folder / "packed", FATHOM)
        (cls.folder / "package.json").write_text('{"private": true, "type": "module"}')
        run("npm", "install", *OFFLINE, *sorted((cls.folder / "packed").glob("*.tgz")), cwd=cls.folder)

    def test_what_is_packed(self):
        packed = {re.split(r"-\d", path.name)[0] for path in (self.folder / "packed").iterdir()}
        self.assertEqual(packed, {"fathom-subject", "fathom-golden", "fathom_golden"})
        for name, files in (("fathom-subject", "example.mjs fathom_subject.mjs"), ("fathom-golden", "fathom_golden.mjs fathom_golden_sample.json")):
            there = {path.name for path in (self.folder / "node_modules" / name).iterdir()}
            self.assertEqual(there, {*files.split(), "LICENSE", "README.md", "package.json"})

    def test_a_subject_in_javascript(self):
        example = (ROOT / "verify" / "subjects" / "kit" / "example.mjs").read_text(encoding="utf-8")
        self.assertIn("from './fathom_subject.mjs'", example)
        (self.folder / "mine.mjs").write_text(example.replace("'./fathom_subject.mjs'", "'fathom-subject'"))
        (self.folder / "cases.jsonl").write_text(run(FATHOM, "cases", "--family", "boxes_aligned", "--count", "20"))
        said = run(FATHOM, "certify", "--subject", "node mine.mjs", "cases.jsonl", cwd=self.folder)
        self.assertIn("20 cases: 20 pass, 0 fail", said)

    def test_the_sample_in_javascript(self):
        (self.folder / "golden.mjs").write_text(ACCEPTS)
        self.assertEqual(run("node", "golden.mjs", cwd=self.folder), "50 0\n")

    def test_the_sample_in_python(self):
        [wheel] = (self.folder / "packed").glob("fathom_golden-*-py3-none-any.whl")
        run(sys.executable, "-m", "pip", "-q", "install", "--no-index", "--no-deps", "--target", self.folder / "site", wheel)
        said = run(sys.executable, "-c", ACCEPTS_PYTHON, cwd=self.folder, env={**os.environ, "PYTHONPATH": str(self.folder / "site")})
        self.assertEqual(said, f"{self.folder}/site/fathom_golden/__init__.py 50 0\n")


if __name__ == "__main__":
    unittest.main()
