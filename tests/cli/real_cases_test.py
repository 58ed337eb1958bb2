# SPDX-License-Identifier: GPL-3.0-or-later
"""The cases from other projects' issue trackers and test suites, end to end: what is printed is the answer stated with each case."""
import itertools
import json
import math
import unittest
from fractions import Fraction

from harness import DATA, CliTest

PATH = DATA / "real_cases.jsonl"
SHAPES = DATA / "real_shapes.jsonl"
BOXES = 47  # pairs of boxes among them
ROUNDING = Fraction(1, 10**15)  # of a corner, in parts of the largest coordinate


def fractions(numbers):
    return [Fraction(x) for x in numbers]


def corners(box):
    """Of a box of the shapes, exactly."""
    pose, half = box.get("pose", {"translation": [0, 0, 0]}), fractions(box["half"])
    rows = pose if isinstance(pose, list) else [[int(i == j) for j in range(3)] + [pose["translation"][i]] for i in range(3)]
    for signs in itertools.product((-1, 1), repeat=3):
        point = [sign * length for sign, length in zip(signs, half)]
        yield [sum(m * x for m, x in zip(row, point)) + row[3] for row in map(fractions, rows)]


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

    def test_as_shapes(self):
        """Law: the cases as in their reports are the same bodies: each box has the corners of its hull, to the rounding of their numbers,
        and the depth is that of the hulls."""
        cases, shapes = ([json.loads(line) for line in path.read_text().splitlines()] for path in (PATH, SHAPES))
        results = [json.loads(line) for line in self.answer("depth", "--json", SHAPES).splitlines()]
        boxes = 0
        for case, shape, result in zip(cases, shapes, results, strict=True):
            with self.subTest(case["id"]):
                self.assertEqual((shape["id"], shape["source"]), (case["id"], case["source"]))
                self.assertEqual(shape["a"].get("shape"), shape["b"].get("shape"))
                extent = max(abs(Fraction(x)) for body in "ab" for vertex in case[body]["vertices"] for x in vertex)
                if "shape" in shape["a"]:
                    boxes += 1
                    for body in "ab":
                        left = [fractions(vertex) for vertex in case[body]["vertices"]]
                        for corner in corners(shape[body]):
                            nearest = min(left, key=lambda v: max(abs(x - y) for x, y in zip(corner, v)))
                            self.assertLessEqual(max(abs(x - y) for x, y in zip(corner, nearest)), ROUNDING * extent)
                            left.remove(nearest)
                        self.assertEqual([], left)
                else:
                    self.assertEqual((shape["a"], shape["b"]), (case["a"], case["b"]))
                self.assertAlmostEqual(result["depth"]["value"], math.sqrt(Fraction(case["expected"]["depth_squared"])),
                                       delta=10 * ROUNDING * extent)
        self.assertEqual(boxes, BOXES)


if __name__ == "__main__":
    unittest.main()
