#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The workflow file for other projects, examples/ci/certify.yml: its commands run, and are red when a failure is not the expected one."""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

from harness import EXECUTABLE, ROOT

WORKFLOW = pathlib.Path(ROOT) / "examples/ci/certify.yml"
KIT = pathlib.Path(ROOT) / "verify/subjects/kit"


def commands():
    """Those of fathom, in order; that of the comment, which writes the list, stands apart."""
    text = WORKFLOW.read_text()
    return re.search(r"^#     (fathom .*)$", text, re.MULTILINE)[1], re.findall(r"^ +(\./fathom/fathom .*)$", text, re.MULTILINE)


class CiExample(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.root = pathlib.Path(self.folder.name)
        (self.root / "fathom").mkdir()
        (self.root / "fathom/fathom").symlink_to(EXECUTABLE)
        (self.root / "build").mkdir()
        for file in ("example.py", "fathom_subject.py"):
            shutil.copy(KIT / file, self.root)
        subject = self.root / "build/subject"
        subject.write_text(f"#!/bin/sh\nexec {sys.executable} -B example.py\n")
        subject.chmod(0o755)

    def run_command(self, command):
        return subprocess.run(["bash", "-c", command], cwd=self.root, capture_output=True, text=True, timeout=600)

    def test_what_builds_is_pinned(self):
        text = WORKFLOW.read_text()
        self.assertIn('fetch --depth 1 "$FATHOM_REPOSITORY" "${FATHOM_COMMIT:?', text)
        self.assertIn("key: 'fathom-${{ vars.FATHOM_COMMIT }}'", text)  # what a cache holds is never replaced under the same key
        self.assertNotIn("git clone", text)

    def test_commands(self):
        writes_list, run = commands()
        version, *makes_cases, certify = run
        self.assertTrue(all(" cases " in command for command in makes_cases) and makes_cases, makes_cases)
        for command in (version, *makes_cases):
            done = self.run_command(command)
            self.assertEqual(done.returncode, 0, f"{command}\n{done.stderr}")
        self.run_command("./fathom/" + writes_list)
        known = self.root / "known_failures.txt"
        listed = known.read_text().splitlines(keepends=True)
        done = self.run_command(certify)
        self.assertEqual(done.returncode, 0, done.stderr + done.stdout)
        for made in ("certify.xml", "certify.html"):
            self.assertGreater((self.root / made).stat().st_size, 1000)
        # Law: one failure that is not listed makes the run red, and so does one that does not occur.
        known.write_text("".join(listed[:-1]))
        self.assertEqual(self.run_command(certify).returncode, 1)
        known.write_text("".join(listed) + listed[-1].replace(listed[-1].split()[0], "no_such_case"))
        self.assertNotEqual(self.run_command(certify).returncode, 0)


if __name__ == "__main__":
    unittest.main()
