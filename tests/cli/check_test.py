#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""fathom check --proved with the proved checker itself, where it is built. All else: transcripts/check.md."""
import json
import os
import shutil
import sys
import unittest

import harness
from harness import DATA, EXECUTABLE, ROOT, CliTest

CUBES = DATA / "certificates" / "depth_cubes.cert"
TEXT = CUBES.read_text()
CASE = {"id": "two cubes", "a": {"vertices": [[x, y, z] for z in (0, 2) for y in (0, 2) for x in (0, 2)]},
        "b": {"vertices": [[x, y, z] for z in (0, 2) for y in (0, 2) for x in (1, 3)]}}
WIDTH = "".join(line + "\n" for line in (
    "fathom-certificate 1", "id a", "a 2", "0 1/2 0", "1 1/2 0", "b 2", "0 2/4 0", "1 1/2 0", "claim touching", "directions 1 some",
    "0 1 0", "weights_a 1", "0 1", "weights_b 1", "0 1", "end 2 2 1 1 1"))
PROVED = os.environ.get("FATHOM_CHECK_PROVED", "")


class Check(CliTest):
    def stand_in(self, script):
        """A copy of fathom, and beside it a program of this script for the proved checker."""
        copy = self.folder / "fathom"
        shutil.copy(EXECUTABLE, copy)
        sibling = self.folder / "fathom-check-proved"
        sibling.write_text("#!/bin/sh\n" + script)
        sibling.chmod(0o755)
        original, harness.EXECUTABLE = harness.EXECUTABLE, str(copy)
        self.addCleanup(setattr, harness, "EXECUTABLE", original)

    def test_what_is_handed_over_says_the_same(self):
        """check.py stands in for the proved checker: it reads each certificate as the C++ checker writes it again. Those about two bodies
        are not handed over whole."""
        reader = ROOT / "verify" / "check" / "check.py"
        self.stand_in(f'[ "$1" = --width ] && shift; exec "{sys.executable}" -B "{reader}" "$@"\n')
        names = sorted(name for name in (DATA / "certificates").rglob("*.cert") if name.parent.name not in ("refused", "two_bodies"))
        _, direct, _ = self.run_cli("check", *names)
        code, out, _ = self.run_cli("check", "--proved", "--echo", *names)
        self.assertEqual((code, [line for line in out.splitlines() if line.startswith("s ")]), (0, direct.splitlines()))

    @unittest.skipUnless(os.path.exists(PROVED), "the proved checker is not built")
    def test_proved_compares(self):
        """Cases, results and widths with the real program, by the exit codes of FORMAT.md."""
        self.stand_in(f'exec {PROVED} "$@"\n')
        fine = "s VERIFIED penetrating depth_squared=1 optima=1 two%20cubes\n"
        case = self.file("case.json", json.dumps(CASE))
        moved = json.loads(json.dumps(CASE))
        moved["b"]["vertices"][3][2] = "1/3"
        other = self.file("other.json", json.dumps(moved))
        self.assertEqual(self.run_cli("check", "--proved", "--case", case, CUBES), (0, fine, ""))
        code, out, _ = self.run_cli("check", "--proved", "--case", other, CUBES)
        self.assertEqual((code, out[:22]), (1, "s REFUSED two%20cubes:"))
        false = self.file("false.cert", TEXT.replace("claim depth 1", "claim depth 2"))
        self.assertEqual(self.run_cli("check", "--proved", "--case", case, false, CUBES)[0], 1)
        self.assertEqual(self.run_cli("check", "--proved", "--case", case, "-", stdin=TEXT[:-1])[0], 2)
        self.assertEqual(self.run_cli("check", "--proved", "--case", "/nowhere", CUBES)[0], 2)
        self.assertEqual(self.run_cli("check", "--proved", "--width", CUBES)[0], 1)
        self.assertEqual(self.run_cli("check", "--proved", "--width", "--case", case, CUBES)[0], 1)
        square = self.file("square.cert", WIDTH)
        for options in (), ("--echo",):
            code, out, _ = self.run_cli("check", "--proved", "--width", *options, square)
            self.assertEqual((code, out.splitlines()[-1]), (0, "s VERIFIED touching depth_squared=0 a"))
        results = self.answer("depth", "--json", "--embed-certificate", case)
        self.assertEqual(self.run_cli("check", "--proved", "--results", "-", "--case", case, stdin=results), (0, fine, ""))
        wrong = results.replace('"squared":"1"', '"squared":"2"')
        self.assertNotEqual(wrong, results)
        self.assertEqual(self.run_cli("check", "--proved", "--results", "-", stdin=wrong)[0], 1)
        for name in sorted((DATA / "certificates").glob("*.cert")):
            code, out, _ = self.run_cli("check", "--proved", name)
            self.assertEqual(self.run_cli("check", "--proved", "--echo", name)[0], code)
            echoed = self.run_cli("check", "--proved", "--echo", name)[1]
            self.assertEqual([line for line in echoed.splitlines() if line.startswith("s ")], out.splitlines())


if __name__ == "__main__":
    unittest.main()
