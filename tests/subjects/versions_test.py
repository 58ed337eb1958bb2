# SPDX-License-Identifier: GPL-3.0-or-later
"""What MuJoCo's older versions answered, by verify/survey/results.json, is what versions.py makes today. WebAssembly answers alike on every
machine. Skipped where node, npm or the network is absent."""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import web_install
from client import Client
from client import ROOT

SURVEY = ROOT / "verify" / "survey"


class Versions(unittest.TestCase):
    maxDiff = None

    def test_history(self):
        with tempfile.TemporaryDirectory() as folder:
            made = pathlib.Path(shutil.copy(SURVEY / "results.json", folder))
            done = subprocess.run([sys.executable, "-B", SURVEY / "versions.py", "--fathom", os.environ["FATHOM_EXECUTABLE"], "--out",
                                   folder, "--work", folder], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            now, then = ([self.told(subject) for subject in json.loads(path.read_text(encoding="utf-8"))["subjects"]]
                         for path in (made, SURVEY / "results.json"))
            self.assertEqual(now, then)

    @staticmethod
    def told(subject):
        """The subject without the days on which older versions were asked."""
        for stage in subject.get("earlier", []):
            for found in stage["sets"].values():
                del found["made"]["date"]
        return subject

    def test_unknown_versions(self):
        for version in ("3.11.0", "../..", "3.14"):
            client = Client("mujoco.mjs", "native", f"version={version}")
            code, talk = client.wait()
            self.assertEqual((code, client.line()), (2, ""), talk)
            self.assertIn("is not in history/node_modules", talk)


if __name__ == "__main__":
    missing = web_install.install("history")
    if missing:
        print(f"versions_test.py: skipped: {missing}", file=sys.stderr)
        sys.exit(web_install.SKIPPED)
    unittest.main()
