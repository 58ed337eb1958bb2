# SPDX-License-Identifier: GPL-3.0-or-later
"""nightly.sh and fathom-two-ways, on a few hundred cases: they agree; planted differences are found, made smaller and kept."""
import json
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
FATHOM = pathlib.Path(os.environ["FATHOM_EXECUTABLE"])
TWO_WAYS = pathlib.Path(os.environ["FATHOM_TWO_WAYS"])
PLANTED = TWO_WAYS.with_name("fathom-two-ways-planted")
PATIENCE = 600  # seconds until a hung process is given up


class Nightly(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_words(self, *words):
        done = subprocess.run([str(word) for word in words], cwd=self.folder, capture_output=True, text=True, timeout=PATIENCE)
        return done.returncode, done.stdout, done.stderr

    def script(self, two_ways, *words):
        """Golden data of the least level, and programs as --built finds them."""
        built = self.folder / "built"
        built.mkdir(exist_ok=True)
        for name, program in (("fathom", FATHOM), ("fathom-two-ways", two_ways)):
            (built / name).unlink(missing_ok=True)
            (built / name).symlink_to(program)
        return self.run_words(HERE / "nightly.sh", "--built", built, "--level", "L0", "--work", self.folder / "work", *words)

    def test_the_ways_agree(self):
        code, out, err = self.script(TWO_WAYS, "--seed", "7", "--cases", "240")
        self.assertEqual(code, 0, out + err)
        self.assertRegex(out, r"(?m)^s VERIFIED L0 .* agreed=exact ")
        self.assertIn("seed 7, cases 0 to 240: automatic and exact agree in every field; goes on: --seed 7 --from 240\n", out)
        self.assertIn("seed 7, from case 0\n", err)
        self.assertFalse((self.folder / "work" / "differences").exists())
        code, out, _ = self.script(TWO_WAYS, "--seed", "7", "--from", "240", "--cases", "10")
        self.assertEqual(code, 0, out)
        self.assertRegex(out, r"golden-L0: 0 of \d+ shards made")
        self.assertIn("cases 240 to 250", out)

    def test_a_planted_difference(self):
        code, out, err = self.script(PLANTED, "--seed", "7", "--cases", "240")
        self.assertEqual(code, 1, out + err)
        found = re.search(r"^seed 7, case (\d+), (\S+): automatic and exact differ: squared: \S+ and \S+$", out, re.MULTILINE)
        self.assertTrue(found, out)
        number = int(found[1])
        self.assertIn(f"goes on: --seed 7 --from {number + 1}\n", out)
        kept = self.folder / "work" / "differences" / "difference.case.json"
        pair = json.loads(kept.read_text())
        self.assertEqual(pair["id"], found[2])
        self.assertIn("automatic and exact differ: squared: ", pair["comment"])
        # The plant needs six points of A; of B a simplex is left. Their numbers are small.
        self.assertEqual((len(pair["a"]["vertices"]), len(pair["b"]["vertices"])), (6, 4))
        self.assertLessEqual(max(abs(x) for body in "ab" for point in pair[body]["vertices"] for x in point), 16)
        self.assertIn(f"kept as {kept}, 6 and 4 points", out)
        self.assertEqual(self.run_words(FATHOM, "depth", kept)[0], 0)
        # No earlier case differs, on any number of threads.
        for jobs in ("1", "3"):
            code, out, _ = self.run_words(PLANTED, "--seed", "7", "--cases", "240", "--jobs", jobs, "--keep", self.folder / jobs)
            self.assertEqual(code, 1)
            self.assertIn(f"seed 7, case {number}, {found[2]}: ", out)
            self.assertEqual((self.folder / jobs / kept.name).read_bytes(), kept.read_bytes())

    def test_unions(self):
        code, out, err = self.run_words(TWO_WAYS, "--seed", "7", "--cases", "72", "--unions")
        self.assertEqual(code, 0, out + err)
        self.assertIn("seed 7, cases 0 to 72: automatic and exact agree in every field; goes on: --seed 7 --from 72 --unions\n", out)

    def test_the_small_world(self):
        code, out, err = self.run_words(TWO_WAYS, "--seed", "7", "--small-world", "--from", "6463100", "--cases", "200")
        self.assertEqual(code, 0, out + err)
        self.assertIn("cases 6463100 to 6463188: automatic and naive agree in every field; ", out)
        self.assertIn("goes on: --seed 7 --from 6463188 --small-world", out)
        self.assertEqual(self.run_words(TWO_WAYS, "--small-world", "--unions")[0], 2)

    def test_a_planted_difference_of_unions(self):
        code, out, err = self.run_words(PLANTED, "--seed", "7", "--cases", "72", "--unions", "--keep", self.folder)
        self.assertEqual(code, 1, out + err)
        found = re.search(r"^seed 7, case (\d+), (\S+): automatic and exact differ: translations: \S.* and \S.*$", out, re.MULTILINE)
        self.assertTrue(found, out)
        kept = self.folder / "difference.case.json"
        pair = json.loads(kept.read_text())
        self.assertEqual(pair["id"], found[2])
        # The plant needs three pieces of B and a tie; of A one piece is left, or as many as a tie takes.
        self.assertEqual(len(pair["b"]["pieces"]), 3)
        self.assertIn(f"kept as {kept}, {len(pair['a']['pieces'])} and 3 pieces: automatic and exact differ: translations: ", out)
        self.assertIn(f"goes on: --seed 7 --from {int(found[1]) + 1} --unions\n", out)
        self.assertEqual(self.run_words(FATHOM, "depth", kept)[0], 0)
        # Every fifth case of the whole stream is one of unions: there the plant is found too.
        fifth = 5 * int(found[1]) + 4
        code, out, _ = self.run_words(PLANTED, "--seed", "7", "--from", fifth, "--cases", "1", "--keep", self.folder / "fifth")
        self.assertEqual(code, 1, out)
        self.assertIn(f"seed 7, case {fifth}, {found[2]}: ", out)

    def test_a_time(self):
        code, out, _ = self.run_words(TWO_WAYS, "--seed", "3", "--until", "1s", "--jobs", "1")
        self.assertEqual(code, 0)
        self.assertRegex(out, r"^seed 3, cases 0 to [1-9]\d*: ")

    def test_a_new_seed_each_night(self):
        seeds = {self.run_words(TWO_WAYS, "--cases", "1")[1].split(",")[0] for _ in range(3)}
        self.assertEqual(len(seeds), 3)

    def test_wrong_words(self):
        for words in (["--until", "soon"], ["--until", "10"], ["--cases", "-1"], ["--seed", "x"], ["more"], ["--jobs", "0"]):
            code, out, err = self.run_words(TWO_WAYS, *words)
            self.assertEqual((code, out), (2, ""), words)
            self.assertIn(words[0].lstrip("-"), err)
        for words in (["--until"], ["more"]):
            code, out, err = self.run_words(HERE / "nightly.sh", *words)
            self.assertEqual((code, out), (2, ""), words)
            self.assertIn("nightly: ", err)

    def test_a_folder_that_cannot_be_written(self):
        (self.folder / "taken").write_text("")
        code, _, err = self.run_words(PLANTED, "--seed", "7", "--cases", "240", "--keep", self.folder / "taken")
        self.assertEqual(code, 3)
        self.assertIn("taken", err)


if __name__ == "__main__":
    unittest.main()
