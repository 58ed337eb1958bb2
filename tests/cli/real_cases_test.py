# SPDX-License-Identifier: GPL-3.0-or-later
"""The cases from other projects' issue trackers and test suites, end to end: what is printed is the answer stated with each case."""
import json
import unittest

from harness import DATA, CliTest

PATH = DATA / "real_cases.jsonl"


class RealCases(CliTest):
    def check(self, *options):
        cases = [json.loads(line) for line in PATH.read_text().splitlines()]
        results = [json.loads(line) for line in self.answer("depth", "--json", *options, PATH).splitlines()]
        self.assertEqual([result["id"] for result in results], [case["id"] for case in cases])
        self.assertGreater(len(cases), 60)
        for case, result in zip(cases, results):
            with self.subTest(case["id"]):
                expected = case["expected"]
                self.assertEqual((result["status"], result["depth"]["squared"]), (expected["status"], expected["depth_squared"]))
                translations = [optimum["translation"] for optimum in result["optima"]] or [result["translation"]]
                self.assertEqual(sorted(translations), sorted(expected["translations"]))

    def test_auto(self):
        self.check()

    def test_exact(self):
        self.check("--method", "exact")

    def test_naive(self):
        self.check("--method", "naive")

    def test_shallow(self):
        self.check("--method", "shallow")


if __name__ == "__main__":
    unittest.main()
