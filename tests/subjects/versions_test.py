# SPDX-License-Identifier: GPL-3.0-or-later
"""verify/survey/history.json is what versions.py makes today: every version of the engine answers as it is told there. WebAssembly answers
alike on every machine. Skipped where node, npm or the network is absent."""
import json
import os
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
            made = os.path.join(folder, "history.json")
            done = subprocess.run([sys.executable, "-B", SURVEY / "versions.py", "--fathom", os.environ["FATHOM_EXECUTABLE"], "--out",
                                   made],
                                  capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            with open(made, encoding="utf-8") as file:
                self.assertEqual(json.load(file), json.loads((SURVEY / "history.json").read_text(encoding="utf-8")))

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
