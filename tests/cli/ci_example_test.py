#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The composite action for other projects, examples/ci/action.yml: its steps run, and are red when a failure is not the expected one. The
workflow certify.yml uses it with inputs that it has."""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

from harness import EXECUTABLE, PATIENCE, ROOT

CI = pathlib.Path(ROOT) / "examples/ci"
KIT = pathlib.Path(ROOT) / "verify/subjects/kit"


def steps(text):
    """Returns {name: (its variables, its command)} of the steps with a command, in order."""
    found = {}
    for step in re.split(r"^    +- name: ", text, flags=re.MULTILINE)[1:]:
        name, _, rest = step.partition("\n")
        if "run: |" in rest:
            variables = dict(re.findall(r"^ +([A-Z]+): \$\{\{ inputs\.([a-z-]+) \}\}$", rest, re.MULTILINE))
            found[name] = variables, rest.partition("run: |\n")[2]
    return found


def inputs(text):
    """Returns {input: its default, or None if it is required}."""
    block = text.partition("\ninputs:\n")[2].partition("\nruns:")[0]
    return {name: None if "required: true" in rest else re.search(r"default: (.*)", rest)[1].strip("'")
            for name, rest in re.findall(r"^  ([a-z-]+):\n((?:    .*\n?)+)", block, re.MULTILINE)}


class CiExample(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.root = pathlib.Path(self.folder.name)
        (self.root / "fathom/examples").mkdir(parents=True)
        (self.root / "fathom/fathom").symlink_to(EXECUTABLE)
        shutil.copytree(CI, self.root / "fathom/examples/ci")
        (self.root / "build").mkdir()
        for file in ("example.py", "fathom_subject.py"):
            shutil.copy(KIT / file, self.root)
        subject = self.root / "build/subject"
        subject.write_text(f"#!/bin/sh\nexec {sys.executable} -B example.py\n")
        subject.chmod(0o755)
        self.action, self.workflow = (CI / "action.yml").read_text(), (CI / "certify.yml").read_text()

    def run_command(self, command, **variables):
        given = {"PATH": f"{self.root / 'fathom'}:/usr/bin:/bin", "GITHUB_ACTION_PATH": str(self.root / "fathom/examples/ci"), **variables}
        return subprocess.run(["bash", "-e", "-c", command], cwd=self.root, env=given, capture_output=True, text=True, timeout=PATIENCE)

    def run_step(self, name, given):
        variables, command = steps(self.action)[name]
        return self.run_command(command, **{variable: given[input_] for variable, input_ in variables.items()})

    def given(self):
        """The inputs that the workflow gives, over the defaults."""
        words = re.search(r"uses: \./fathom/examples/ci\n +with: \{(.*)\}", self.workflow)[1]
        given = dict(pair.split(": ") for pair in words.split(", "))
        self.assertLessEqual(given.keys(), inputs(self.action).keys())
        found = {**inputs(self.action), **given}
        self.assertNotIn(None, found.values(), "a required input is missing")
        return found

    def test_what_builds_is_pinned(self):
        self.assertIn('fetch --depth 1 "$FATHOM_REPOSITORY" "${FATHOM_COMMIT:?', self.workflow)
        self.assertIn("key: 'fathom-${{ vars.FATHOM_COMMIT }}'", self.workflow)  # what a cache holds is never replaced under the same key
        self.assertNotIn("git clone", self.workflow)

    def test_steps(self):
        given = self.given()
        self.assertEqual(list(steps(self.action)), ["Make cases", "Certify", "Badge"])
        done = self.run_step("Make cases", given)
        self.assertEqual(done.returncode, 0, done.stderr)
        writes_list = re.search(r"^#     (fathom .*)$", self.workflow, re.MULTILINE)[1]
        self.run_command(writes_list)
        known = self.root / given["known-failures"]
        listed = known.read_text().splitlines(keepends=True)
        for step in ("Certify", "Badge"):
            done = self.run_step(step, given)
            self.assertEqual(done.returncode, 0, done.stderr + done.stdout)
        for made in ("certify.jsonl", "certify.xml", "certify.html"):
            self.assertGreater((self.root / made).stat().st_size, 1000)
        failing = sum(not line.startswith("#") for line in listed)
        title = xml.etree.ElementTree.parse(self.root / "certify.svg").getroot()[0].text
        right, judged = map(int, re.fullmatch(r"penetration depth: (\d+) of (\d+) right", title).groups())
        self.assertEqual(judged - right, failing)
        # Law: one failure that is not listed makes the run red, so does one that does not occur, and so does any without a list.
        known.write_text("".join(listed[:-1]))
        self.assertEqual(self.run_step("Certify", given).returncode, 1)
        known.write_text("".join(listed) + listed[-1].replace(listed[-1].split()[0], "no_such_case"))
        self.assertNotEqual(self.run_step("Certify", given).returncode, 0)
        self.assertEqual(self.run_step("Certify", {**given, "known-failures": ""}).returncode, 1)

    def test_a_badge_of_no_report(self):
        for words in ([], [self.root / "none.jsonl", self.root / "badge.svg"], [self.root / "example.py", self.root / "badge.svg"]):
            done = subprocess.run([sys.executable, "-B", CI / "badge.py", *words], capture_output=True, text=True)
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertIn("badge.py", done.stderr)
        self.assertFalse((self.root / "badge.svg").exists())


if __name__ == "__main__":
    unittest.main()
