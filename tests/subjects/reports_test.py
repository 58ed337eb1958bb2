# SPDX-License-Identifier: GPL-3.0-or-later
"""verify/reports: each folder is whole and in the table, its proof is accepted by both checkers, the adapter gets the verdict that the
table tells, and the program for the library prints what the folder's page shows. What needs a library that is not here is left out; with
argument `programs` only the programs and adapters are tried, with `proofs` the rest."""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import web_install
from client import ROOT

REPORTS = ROOT / "verify" / "reports"
FATHOM = os.environ["FATHOM_EXECUTABLE"]
BUILT = pathlib.Path(os.environ["FATHOM_SUBJECTS"])
ROW = re.compile(r"^\| \[([\w-]+)\]\(\1/README\.md\) \| (\S+) (\S+) \| ([\w,=-]+) \| ([\w-]+) \|$", re.MULTILINE)
TABLE = {name: (library, version, adapter, verdict)
         for name, library, version, adapter, verdict in ROW.findall((REPORTS / "README.md").read_text(encoding="utf-8"))}
PACKAGES = {"libccd": ("ccd", "libccd-dev"), "Bullet": ("bullet", "libbullet-dev"), "FCL": ("fcl", "libfcl-dev")}
PATIENCE = 300  # seconds until a hung process is given up


def run(*command, **options):
    return subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE, check=False, **options)


def shown(name):
    """(commands, output) of the page's one console block."""
    block = re.search(r"^```console\n(.*?)^```$", (REPORTS / name / "README.md").read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)[1]
    commands = re.findall(r"^\$ (.*)$", block, re.MULTILINE)
    return commands, re.sub(r"^\$ .*\n", "", block, flags=re.MULTILINE)


def is_for_node(name):
    return (REPORTS / name / "reproduce.mjs").exists()


def missing(name):
    """Why the library of a report is not here, in the version of the table; None if it is."""
    if is_for_node(name):
        return NO_WEB
    package, debian = PACKAGES[TABLE[name][0]]
    if not shutil.which("dpkg-query") or run("pkg-config", "--exists", package).returncode:
        return f"{debian} is not here"
    version = run("dpkg-query", "-W", "-f", "${Version}", debian).stdout.split(":")[-1]
    return None if version == TABLE[name][1] else f"{debian} is here as {version}"


class Proofs(unittest.TestCase):
    def test_folders(self):
        self.assertEqual(sorted(TABLE), sorted(path.name for path in REPORTS.iterdir() if path.is_dir()))
        self.assertEqual(len(TABLE), 11)
        for name in TABLE:
            with self.subTest(name):
                files = sorted(path.name for path in (REPORTS / name).iterdir())
                program = "reproduce.mjs" if is_for_node(name) else "reproduce.cpp"
                self.assertEqual(files, ["README.md", "case.json", "proof.cert", program])
                source = (REPORTS / name / program).read_text(encoding="utf-8").splitlines()
                self.assertEqual(re.split(" && |; ", source[1].removeprefix("// ")), shown(name)[0])
                page = (REPORTS / name / "README.md").read_text(encoding="utf-8")
                for part in ("Version", "Right", "Misuse ruled out", "Cause", "Known"):
                    self.assertRegex(page, rf"(?m)^- \*{part}")

    def test_proofs(self):
        for name in TABLE:
            with self.subTest(name):
                proof, case = REPORTS / name / "proof.cert", REPORTS / name / "case.json"
                bodies = json.loads(case.read_text(encoding="utf-8"))
                self.assertEqual(bodies["id"], name)
                if "shape" in bodies["a"]:  # check --case reads vertices alone: what fathom proves of the case is the proof
                    with tempfile.TemporaryDirectory() as folder:
                        run(FATHOM, "depth", "--certificate", folder, case)
                        self.assertEqual((pathlib.Path(folder) / f"{name}.cert").read_text(encoding="utf-8"),
                                         proof.read_text(encoding="utf-8"))
                same = ["--case", case] if "vertices" in bodies["a"] else []
                for command in ([FATHOM, "check", *same, proof], [sys.executable, "-B", ROOT / "verify" / "check" / "check.py", proof]):
                    done = run(*command)
                    self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
                    self.assertTrue(done.stdout.startswith("s VERIFIED penetrating "), done.stdout)


class Programs(unittest.TestCase):
    maxDiff = None

    def each(self):
        for name in TABLE:
            with self.subTest(name):
                why = missing(name)
                if why:
                    print(f"reports: {name}: left out: {why}", file=sys.stderr)
                else:
                    yield name

    def test_verdicts(self):
        for name in self.each():
            _, _, adapter, verdict = TABLE[name]
            done = run(FATHOM, "certify", "--adapter", adapter, "--json", REPORTS / name / "case.json")
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertEqual([json.loads(line)["verdict"] for line in done.stdout.splitlines() if '"type":"case"' in line], [verdict])

    def test_programs(self):
        for name in self.each():
            commands, output = shown(name)
            if is_for_node(name):  # npm is not asked again: the packages are beside the adapters
                folder = BUILT / "web-subjects" / "reports" / name
                folder.mkdir(parents=True, exist_ok=True)
                shutil.copy(REPORTS / name / "reproduce.mjs", folder)
                self.assertEqual(commands[1:], ["node reproduce.mjs"])
                done = run("node", folder / "reproduce.mjs")
            else:
                with tempfile.TemporaryDirectory() as folder:
                    shutil.copy(REPORTS / name / "reproduce.cpp", folder)
                    done = run("bash", "-c", " && ".join(commands), cwd=folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(done.stdout, output)


if __name__ == "__main__":
    part = sys.argv.pop(1)
    if part == "programs":
        NO_WEB = web_install.install()
        if all(missing(name) for name in TABLE):
            print("reports_test.py: skipped: none of the libraries is here", file=sys.stderr)
            sys.exit(web_install.SKIPPED)
    unittest.main(defaultTest={"programs": "Programs", "proofs": "Proofs"}[part])
