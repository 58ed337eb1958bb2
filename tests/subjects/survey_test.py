# SPDX-License-Identifier: GPL-3.0-or-later
"""verify/survey/survey.sh, small: it makes its tables, and finds on the real cases what the committed results say of them."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
SURVEY = ROOT / "verify" / "survey"
PATIENCE = 600  # seconds until a hung run is given up


def run(*arguments):
    return subprocess.run([SURVEY / "survey.sh", "--fathom", os.environ["FATHOM_EXECUTABLE"], *map(str, arguments)], capture_output=True,
                          text=True, timeout=PATIENCE, check=False)


class Survey(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_small(self):
        out, work = self.folder / "out", self.folder / "work"
        done = run("--count", 92, "--work", work, "--out", out)
        self.assertEqual(done.returncode, 0, done.stderr)
        results = json.loads((out / "results.json").read_text())
        committed = json.loads((SURVEY / "results.json").read_text())
        of_name = {subject["hello"]["name"]: subject for subject in results["subjects"]}
        for known in committed["subjects"]:
            name = known["hello"]["name"]
            made = of_name[name]
            self.assertEqual(sum(made["sets"]["generated"]["verdicts"].values()), 92, name)
            if made["hello"]["version"] == known["hello"]["version"]:
                with self.subTest(name):
                    self.assertEqual(made["hello"], known["hello"])
                    self.assertEqual(made["sets"]["real"], known["sets"]["real"])
        tables = (out / "RESULTS.md").read_text()
        self.assertEqual(tables.count("\n## "), 4)
        before = {path.name: path.read_bytes() for path in out.iterdir()}
        again = run("--count", 92, "--work", work, "--out", out, "--resume")
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertEqual({path.name: path.read_bytes() for path in out.iterdir()}, before)

    def test_wrong_arguments(self):
        for arguments in (["--counts", 3], ["--count"], ["x"]):
            self.assertEqual(run("--work", self.folder / "work", "--out", self.folder, *arguments).returncode, 2)
        self.assertEqual(list(self.folder.iterdir()), [])


if __name__ == "__main__":
    unittest.main()
