#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""fathom check: the independent checker behind fathom's command line, and the proved one beside it."""
import json
import os
import shutil
import subprocess
import unittest

import harness
from harness import DATA, EXECUTABLE, CliTest

CUBES = DATA / "certificates" / "depth_cubes.cert"
TEXT = CUBES.read_text()
CASE = {"id": "two cubes", "a": {"vertices": [[x, y, z] for z in (0, 2) for y in (0, 2) for x in (0, 2)]},
        "b": {"vertices": [[x, y, z] for z in (0, 2) for y in (0, 2) for x in (1, 3)]}}
WIDTH = "".join(line + "\n" for line in (
    "fathom-certificate 1", "id a", "a 2", "0 1/2 0", "1 1/2 0", "b 2", "0 2/4 0", "1 1/2 0", "claim touching", "directions 1 some",
    "0 1 0", "weights_a 1", "0 1", "weights_b 1", "0 1", "end 2 2 1 1 1"))
PROVED = os.environ.get("FATHOM_CHECK_PROVED", "")


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
        self.assertTrue(self.answer("check", "--help").startswith("Examples\n  fathom check "))
        self.assertIn("fathom check: unknown option '--bogus'", self.run_cli("check", "--bogus", CUBES)[2])
        self.assertIn("unknown option '--resluts'; did you mean '--results'?", self.refused("check", "--resluts", CUBES))

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
        original, harness.EXECUTABLE = harness.EXECUTABLE, str(copy)
        self.addCleanup(setattr, harness, "EXECUTABLE", original)
        self.assertEqual(self.run_cli("check", "a b", "--proved", "c"), (1, "a b|c|", ""))
        case = self.file("case.json", json.dumps(CASE))
        self.assertEqual(self.run_cli("check", "--proved", "--case", case, CUBES)[0], 3)  # a program that gives no verdict
        sibling.unlink()
        code, out, err = self.run_cli("check", "--proved", CUBES, env={**os.environ, "PATH": str(self.folder)})
        self.assertEqual((code, out), (3, ""))
        self.assertIn("fathom-check-proved is not here", err)
        code, out, err = self.run_cli("check", "--proved", "--case", case, CUBES, env={**os.environ, "PATH": str(self.folder)})
        self.assertEqual((code, out), (3, ""))
        self.assertIn("fathom-check-proved is not here", err)

    def stand_in(self, script):
        """A copy of fathom, and beside it a program of this script for the proved checker."""
        copy = self.folder / "fathom"
        shutil.copy(EXECUTABLE, copy)
        sibling = self.folder / "fathom-check-proved"
        sibling.write_text("#!/bin/sh\n" + script)
        sibling.chmod(0o755)
        original, harness.EXECUTABLE = harness.EXECUTABLE, str(copy)
        self.addCleanup(setattr, harness, "EXECUTABLE", original)

    def test_proved_has_the_last_word(self):
        """What the C++ checker accepts is printed as the proved one prints it, or refused with it; the options reach it."""
        case = self.file("case.json", json.dumps(CASE))
        log = self.folder / "log"
        read = f'echo "$@" >>{log}; while read -r line; do echo "$line" >>{log}; case $line in end*) '
        self.stand_in(read + 'echo "s VERIFIED this two%20cubes";; esac; done\n')
        self.assertEqual(self.run_cli("check", "--proved", "--case", case, CUBES, CUBES), (0, "s VERIFIED this two%20cubes\n" * 2, ""))
        points = "".join("{}/1 {}/1 {}/1\n".format(*p) for p in CASE["a"]["vertices"])
        self.assertTrue(log.read_text().startswith("-\nfathom-certificate 1\nid two%20cubes\na 8\n" + points), log.read_text())
        for word, expected in (("REFUSED", 1), ("MALFORMED", 2)):
            self.stand_in(read + f'echo "s {word} two%20cubes:7: so: there";; esac; done\n')
            line = TEXT.splitlines().index("claim depth 1") + 1
            self.assertEqual(self.run_cli("check", "--proved", "--echo", CUBES)[0], expected)
            self.assertEqual(self.run_cli("check", "--proved", "--case", case, CUBES),
                             (expected, f"s {word} two%20cubes:{line}: by fathom-check-proved alone: so: there\n", ""))
        log.unlink()
        self.stand_in(read + 'echo "s VERIFIED this a";; esac; done\n')
        square = self.file("square.cert", WIDTH)
        self.assertEqual(self.run_cli("check", "--proved", "--echo", "--width", square)[0], 0)
        self.assertTrue(log.read_text().startswith("--width -\n"))
        self.stand_in("read -r line; kill -9 $$\n")
        code, out, err = self.run_cli("check", "--proved", "--case", case, CUBES)
        self.assertEqual((code, out), (3, ""))
        self.assertIn("fathom-check-proved killed by signal 9", err)

    def test_unions_reach_the_proved_checker_whole(self):
        """What is handed over is the certificate again, fractions aside."""
        for file in sorted((DATA / "certificates" / "format_3").glob("*.cert")):
            log = self.folder / file.name
            name = file.read_text().split("\nid ")[1].split("\n")[0]
            self.stand_in(f'while read -r line; do echo "$line" >>{log}; case $line in end*) echo "s VERIFIED this {name}";; esac; done\n')
            self.assertEqual(self.run_cli("check", "--proved", "--echo", file)[0], 0)
            text = "".join(line + "\n" for line in file.read_text().splitlines() if not line.startswith("#"))
            self.assertEqual(log.read_text().replace("/1 ", " ").replace("/1\n", "\n"), text)

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
