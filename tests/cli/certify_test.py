# SPDX-License-Identifier: GPL-3.0-or-later
"""fathom certify: adapters, the bar of progress. Verdicts and exit codes: transcripts/certify.md."""
import math
import os
import pty
import re
import shutil
import subprocess
import unittest

from certify_harness import CertifyTest, boxes, liar
from harness import DATA, EXECUTABLE, PATIENCE
from terminals import run_on_terminal


class Runs(CertifyTest):
    def test_adapters(self):
        names = [line.split()[0] for line in self.answer("certify", "--list-adapters").splitlines()]
        self.assertEqual(len(names), len(set(names)))
        self.assertIn("libccd-epa", names)
        self.refused("certify", "--adapter", "libccd", DATA / "real_cases.jsonl")

    def test_adapters_of_unions(self):
        """The key is one half deep in a piece of the comb, and that is not enough."""
        for name in ("libccd-epa", "fcl-signed"):
            with self.subTest(name):
                if re.search(rf"^{name} .*not built", self.answer("certify", "--list-adapters"), re.MULTILINE):
                    self.skipTest(f"{name} is not built")
                _, lines, err = self.certify("--adapter", name, DATA / "unions.jsonl")
                key = next(line for line in lines if line.get("id") == "key_in_comb")  # lines come as verdicts are found
                self.assertEqual(key["verdict"], "too-shallow", err)
                self.assertAlmostEqual(key["judgement"]["deeper"], math.sqrt(2.5), places=3)

    def test_adapter_without_its_packages(self):
        """A copy of the program has nothing beside it."""
        shutil.copy(EXECUTABLE, self.folder / "fathom")
        for adapter, why in (("jolt", "verify/subjects/web"), ("libccd-epa", "Debian package")):
            done = subprocess.run([self.folder / "fathom", "certify", "--adapter", adapter, "-"], input="", capture_output=True, text=True,
                                  check=False)
            self.assertEqual(done.returncode, 2)
            self.assertIn(f"--adapter: {'web-subjects/jolt.mjs' if adapter == 'jolt' else 'fathom-subject-libccd'} is not beside",
                          done.stderr)
            self.assertIn(why, " ".join(done.stderr.split()))


class Bar(CertifyTest):
    def test_rate_time_left_and_worst_error(self):
        path = self.file("cases.jsonl", boxes(0, marked=True) + "".join(boxes(i) for i in range(1, 300)))
        code, out, seen = run_on_terminal("certify", "--jobs", "1", "--subject", liar("too-deep", 0.02), path, stop_at=b"worst error",
                                          columns=100)
        self.assertEqual((code, out[:7]), (130, b"liar 1 "))
        self.assertRegex(seen, rb"\r\x1b\[K\[#*\.+\] +\d+% \d+ of 300 cases, [0-9.]+/s, \d+ s left, 1 failed, worst error 0\.5")

    def test_of_a_pipe(self):
        """Of which nobody knows how much is to come."""
        ours, theirs = pty.openpty()
        stream = "".join(boxes(i) for i in range(150))
        with subprocess.Popen([EXECUTABLE, "certify", "--jobs", "1", "--subject", liar("honest", 0.02), "-"], stdin=subprocess.PIPE,
                              stdout=subprocess.PIPE, stderr=theirs) as process:
            os.close(theirs)
            process.communicate(stream.encode(), timeout=PATIENCE)
        seen = os.read(ours, 1 << 20)
        os.close(ours)
        self.assertRegex(seen, rb"^\r\x1b\[K\d+ cases, [0-9.]+/s, \d+ s, 0 failed, worst error [0-9.e-]+")


if __name__ == "__main__":
    unittest.main()
