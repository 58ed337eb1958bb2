#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Ten thousand random pairs of shapes of every family: each answer carries its proof, and all checkers accept it with that answer."""
import unittest

from pairs import FATHOM, accepted_answers, families, family, run

COUNT = 10_000


class ShapePairs(unittest.TestCase):
    maxDiff = None

    def test_all_checkers_accept_the_answers(self):
        results = accepted_answers(self, run(FATHOM, "cases", "--family", "all", "--shapes", "--count", COUNT, "--seed", 2))
        self.assertEqual(len(results), COUNT)
        self.assertEqual({family(result) for result in results}, set(families("--shapes")))
        self.assertLessEqual({"penetrating", "touching", "disjoint"}, {result["status"] for result in results})


if __name__ == "__main__":
    unittest.main()
