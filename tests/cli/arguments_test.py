# SPDX-License-Identifier: GPL-3.0-or-later
"""What --version says is true of this repository. The other words: transcripts/arguments.md and outputs.md."""
import re
import subprocess
import unittest

from harness import ROOT, VERSION, CliTest


class Version(CliTest):
    def test_version(self):
        for option in ("--version", "-V"):
            first, *others = self.answer(option).splitlines()
            self.assertEqual(first, f"fathom {VERSION}")
            told = dict(line.split(" ", 1) for line in others)
            data = re.search(r'data_version = "(.*)"', (ROOT / "verify/golden/shards/plan.hpp").read_text())[1]
            self.assertEqual((told["golden"], told["licence"]), (f"data {data}", "GPL-3.0-or-later"))
            if (ROOT / ".git").exists():
                subprocess.run(["git", "rev-parse", "--verify", told["commit"].removesuffix("-dirty") + "^{commit}"], cwd=ROOT, check=True,
                               capture_output=True)


if __name__ == "__main__":
    unittest.main()
