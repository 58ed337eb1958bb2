#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Random pairs of unions of every family, and the catalogue: each answer carries its proof, and all checkers accept it with that answer."""
import json
import pathlib
import tempfile
import unittest

from checkers_test import CHECKERS, FATHOM, run

ROUNDS = 30  # of all families


class UnionPairs(unittest.TestCase):
    maxDiff = None

    def test_all_checkers_accept_the_answers(self):
        families = {line.split()[0] for line in run(FATHOM, "cases", "--list", "--unions").splitlines() if line.strip()}
        cases = run(FATHOM, "cases", "--family", "all", "--unions", "--count", ROUNDS * len(families), "--seed", 2, "--size", 4)
        cases += run(FATHOM, "cases", "--catalogue", "--unions")
        lines = run(FATHOM, "depth", "--json", "--embed-certificate", "-", stdin=cases)
        results = [json.loads(line) for line in lines.splitlines()]
        self.assertGreater(len(results), ROUNDS * len(families))
        self.assertLessEqual(families, {result["id"].rsplit("-n", 1)[0] for result in results})
        self.assertEqual({"penetrating", "touching", "disjoint"}, {result["status"] for result in results})
        with tempfile.TemporaryDirectory() as folder:
            answers, certificates = pathlib.Path(folder, "answers.jsonl"), pathlib.Path(folder, "certificates")
            answers.write_text(lines)
            certificates.write_text("".join(result["certificate"] for result in results))
            wanted = run(*CHECKERS["fathom-check"], "--results", answers).splitlines()  # compares each with its certificate, field by field
            self.assertEqual(len(wanted), len(results))
            for result, line in zip(results, wanted):
                self.assertTrue(line.startswith(f"s VERIFIED {result['status']} ") and line.endswith(" " + result["id"]), line)
            for checker, command in CHECKERS.items():
                with self.subTest(checker=checker):
                    self.assertEqual(run(*command, certificates).splitlines(), wanted)


if __name__ == "__main__":
    unittest.main()
