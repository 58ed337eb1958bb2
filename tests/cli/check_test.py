#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""fathom check: the independent checker behind fathom's command line, and the proved one beside it."""
import os
import shutil
import subprocess
import unittest

from harness import DATA, EXECUTABLE, CliTest

CUBES = DATA / "certificates" / "depth_cubes.cert"
TEXT = CUBES.read_text()


class Check(CliTest):
    def test_exit_codes(self):
        self.assertEqual(self.run_cli("check", CUBES), (0, "s VERIFIED penetrating depth_squared=1 optima=1 two%20cubes\n", ""))
        code, out, _ = self.run_cli("check", "-", stdin=TEXT.replace("claim depth 1", "claim depth 2"))
        self.assertEqual((code, out[:23]), (1, "s REFUSED two%20cubes:2"))
        code, out, _ = self.run_cli("check", "-", stdin=TEXT[:-1])
        self.assertEqual((code, out.count("\n")), (2, 1))
        self.assertEqual(self.run_cli("check", "-")[0], 2)

    def test_misuse(self):
        code, out, err = self.run_cli("check")
        self.assertEqual((code, out), (2, ""))
        self.assertTrue(err.startswith("fathom check: expected certificates"), err)
        self.assertTrue(self.answer("check", "--help").startswith("Usage: fathom check "))

    def test_output_that_cannot_be_written(self):
        """By fathom's table of exit codes; the program by itself has its own."""
        for program, wanted in (([EXECUTABLE, "check"], 3), ([os.environ["FATHOM_CHECK"]], 2)):
            with open("/dev/full", "wb") as full:
                done = subprocess.run([*program, CUBES], stdout=full, stderr=subprocess.PIPE)
            self.assertEqual(done.returncode, wanted)
            self.assertIn(b"cannot write to standard output", done.stderr)

    def test_what_fathom_writes(self):
        case = self.file("case.json", '{"id": "a b", "a": {"vertices": [[0,0,0],[1,0,0],[0,1,0],[0,0,1]]}, '
                                      '"b": {"vertices": [[0.1,0.1,0.1],[1,0,0.1],[0,1,0.1],[0.1,0.1,1]]}}')
        self.answer("depth", "--certificate", self.folder / "proofs", case)
        proof = next((self.folder / "proofs").glob("*.cert"))
        self.assertIn("s VERIFIED penetrating ", self.answer("check", "--case", case, proof))
        results = self.answer("depth", "--json", "--embed-certificate", case)
        self.assertIn("s VERIFIED penetrating ", self.answer("check", "--case", case, "--results", "-", stdin=results))

    def test_proved(self):
        """A copy of fathom finds the program beside itself first."""
        copy = self.folder / "fathom"
        shutil.copy(EXECUTABLE, copy)
        sibling = self.folder / "fathom-check-proved"
        sibling.write_text('#!/bin/sh\nprintf "%s|" "$@"\nexit 1\n')
        sibling.chmod(0o755)
        import harness
        original, harness.EXECUTABLE = harness.EXECUTABLE, str(copy)
        self.addCleanup(setattr, harness, "EXECUTABLE", original)
        self.assertEqual(self.run_cli("check", "a b", "--proved", "c"), (1, "a b|c|", ""))
        sibling.unlink()
        code, out, err = self.run_cli("check", "--proved", CUBES, env={**os.environ, "PATH": str(self.folder)})
        self.assertEqual((code, out), (3, ""))
        self.assertIn("fathom-check-proved is not here", err)


if __name__ == "__main__":
    unittest.main()
