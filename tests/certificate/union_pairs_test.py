#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Random pairs of unions of every family, and the catalogue: each answer carries its proof, and all checkers accept it with that answer."""
import unittest

from pairs import FATHOM, accepted_answers, families, family, run

ROUNDS = 30  # of all families


class UnionPairs(unittest.TestCase):
    maxDiff = None

    def test_all_checkers_accept_the_answers(self):
        names = set(families("--unions"))
        cases = run(FATHOM, "cases", "--family", "all", "--unions", "--count", ROUNDS * len(names), "--seed", 2, "--size", 4)
        cases += run(FATHOM, "cases", "--catalogue", "--unions")
        results = accepted_answers(self, cases)
        self.assertGreater(len(results), ROUNDS * len(names))
        self.assertLessEqual(names, {family(result) for result in results})
        self.assertEqual({"penetrating", "touching", "disjoint"}, {result["status"] for result in results})


if __name__ == "__main__":
    unittest.main()
