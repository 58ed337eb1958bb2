# SPDX-License-Identifier: GPL-3.0-or-later
"""`fathom-depth`, which the launcher builds first: what it answers is what `fathom` answers, and it answers `depth` alone."""
import os
import subprocess
import unittest

from harness import DATA, EXECUTABLE, PATIENCE, UNIT, CliTest, box, case

DEPTH_ALONE = os.environ["FATHOM_DEPTH_EXECUTABLE"]
CUBE, ICOSAHEDRON = str(DATA / "cube.off"), str(DATA / "icosahedron.off")
STREAM = "".join(case(UNIT, box([x / 8, 0, 0], [x / 8 + 1, 1, 1]), id=f"{'long ' * 60}{x}") for x in range(12)) + "{}\n"


def said(program, *arguments, stdin=""):
    """(exit code, stdout, stderr)"""
    done = subprocess.run([program, *arguments], input=stdin.encode(), timeout=PATIENCE, capture_output=True)
    return done.returncode, done.stdout, done.stderr


class DepthAlone(CliTest):
    def expect_same(self, *arguments, stdin=""):
        expected = said(EXECUTABLE, *arguments, stdin=stdin)
        self.assertEqual(said(DEPTH_ALONE, *arguments, stdin=stdin), expected)
        return expected[0]

    def test_same_answers(self):
        for options in ((), ("--json", "--counters", "--digits", "30"), ("--method", "exact"), ("--method", "naive"),
                        ("--method", "shallow"), ("--method", "exact", "--closest-lines", "sampled", "--seed", "5"),
                        ("--json", "--embed-certificate")):
            with self.subTest(options=options):
                self.assertEqual(self.expect_same("depth", *options, CUBE, ICOSAHEDRON), 0)
                self.assertEqual(self.expect_same("depth", *options, "-", stdin=STREAM), 2)  # its last line is no case

    def test_same_files(self):
        for option in ("--certificate", "--svg"):
            folders = {}
            for name, program in (("depth", DEPTH_ALONE), ("all", EXECUTABLE)):
                folder = self.folder / f"{name}{option}"
                said(program, "depth", option, str(folder), "-", stdin=STREAM)
                folders[name] = {path.name: path.read_bytes() for path in folder.iterdir()}
            self.assertEqual(folders["depth"], folders["all"])
            self.assertEqual(len(folders["depth"]), 12)

    def test_same_words(self):
        for arguments in (("depth", "--help"), ("--help",), ("--version",), ("-V",), (), ("depth",), ("dept", CUBE), (CUBE, CUBE),
                          ("depth", "--metod", CUBE, CUBE), ("depth", "--method", "x", CUBE, CUBE), ("depth", "no-such.off", CUBE),
                          ("explain",)):
            with self.subTest(arguments=arguments):
                self.expect_same(*arguments)

    def test_other_commands_are_refused(self):
        for arguments in (("width", CUBE), ("check", CUBE), ("golden", "verify", "."), ("cases", "--list"), ("help",), ("man", "depth")):
            with self.subTest(arguments=arguments):
                code, out, err = said(DEPTH_ALONE, *arguments)
                self.assertEqual((code, out), (2, b""))
                self.assertIn(b"fathom-depth answers depth alone", err)


if __name__ == "__main__":
    unittest.main()
