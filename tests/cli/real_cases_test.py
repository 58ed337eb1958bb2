# SPDX-License-Identifier: GPL-3.0-or-later
"""The cases from other projects' issue trackers and test suites, end to end: what is printed is the answer stated with each case; it is
what is known from the reports, and each says which class of bug it shows."""
import itertools
import json
import math
import unittest
from fractions import Fraction

from harness import DATA, CliTest

PATH = DATA / "real_cases.jsonl"
REPORTS = DATA / "report_cases.jsonl"  # 59 sources, of this shape and others
SHAPES = DATA / "real_shapes.jsonl"
POINTS = (None, "hull", "box", "triangle")  # without a margin
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


def read(path):
    return [json.loads(line) for line in path.read_text().splitlines()]


def is_convex(case):
    return "pieces" not in case["a"] and "pieces" not in case["b"]


def is_of_points(case):
    return is_convex(case) and all(case[body].get("shape") in POINTS and "margin" not in case[body] for body in "ab")


def signed_depth(result):
    """As results about convex bodies have it, of unions too."""
    if "signed_depth" in result:
        return result["signed_depth"]
    sign = {"penetrating": 1, "touching": 0, "disjoint": -1}[result["status"]]
    length = result["apart"]["distance"] if sign < 0 else result["depth"]
    low, high = sorted(sign * float.fromhex(length["rounded"]["f64"][mode]) for mode in ("rd", "ru"))
    return {"low": low, "high": high, "exact": {"sign": sign, "root": length["squared"], "plus": "0"}}


class RealCases(CliTest):
    def check(self, *options, wanted=lambda case: True, counts):
        """Of the cases that are wanted, of each file as many as are counted."""
        for path, count in zip((PATH, REPORTS), counts, strict=True):
            cases = list(filter(wanted, read(path)))
            self.assertEqual(len(cases), count)
            lines = "".join(json.dumps(case) + "\n" for case in cases)
            results = [json.loads(line) for line in self.answer("depth", "--json", *options, "-", stdin=lines).splitlines()]
            for case, result in zip(cases, results, strict=True):
                with self.subTest(case["id"]):
                    self.assertEqual(result["id"], case["id"])
                    answer = case.get("answer") or case["expected"]
                    self.assertEqual((result["status"], result["depth"]["squared"]), (answer["status"], answer["depth_squared"]))
                    translations = [way["translation"] for way in result["optima"]] or [result.get("translation", ["0"] * 3)]
                    self.assertEqual(None if None in translations else sorted(translations),
                                     answer["translations"] and sorted(answer["translations"]))
                    if "signed_depth" in answer:
                        self.assertEqual(signed_depth(result), answer["signed_depth"])

    def test_auto(self):
        self.check(counts=(63, 141))

    def test_exact(self):
        self.check("--method", "exact", wanted=is_convex, counts=(63, 132))

    def test_naive(self):
        self.check("--method", "naive", wanted=is_convex, counts=(63, 132))

    def test_shallow(self):
        self.check("--method", "shallow", wanted=is_of_points, counts=(63, 93))

    def test_answers_are_what_the_reports_know(self):
        """Depths and distances within their tolerances, and directions: as `certify --claims` judges them. A length is a double here."""
        known = [case for case in read(REPORTS) if "expected" in case]
        self.assertEqual(len(known), 90)
        claims = []
        for case in known:
            expected = case["expected"]
            self.assertEqual(expected["status"], case["answer"]["status"], case["id"])
            length = expected.get("depth", expected.get("distance"))
            if length is not None:
                expected["tol"] = max(expected.get("tol", 1e-6), math.ulp(length) / 2)
                value, sign = case["answer"]["signed_depth"], 1 if "depth" in expected else -1
                self.assertLessEqual(value["low"], sign * length + expected["tol"], case["id"])
                self.assertGreaterEqual(value["high"], sign * length - expected["tol"], case["id"])
            if is_convex(case):
                claims.append(json.dumps({**case, "claim": expected}) + "\n")
        out = self.answer("certify", "--claims", "-", stdin="".join(claims))
        self.assertIn(f"{len(claims)} claims: {len(claims)} right, 0 wrong, 0 undecided, 0 not judgeable", out)

    def test_each_report_is_credited_and_says_what_it_shows(self):
        cases = read(REPORTS)
        self.assertEqual(len({case["id"] for case in cases}), 141)
        self.assertEqual(len({case["source"]["name"] for case in cases}), 59)
        for case in cases:
            self.assertRegex(case["source"]["name"], r"#[0-9]+|@[0-9a-f]{7}|test|Assets/", case["id"])
            self.assertRegex(case["shows"], r"^[a-z].{9,98}[^.]$", case["id"])
            self.assertTrue(case["comment"], case["id"])

    def test_as_shapes(self):
        """Law: the cases as in their reports are the same bodies: each box has the corners of its hull, to the rounding of their numbers,
        and the depth is that of the hulls."""
        cases, shapes = read(PATH), read(SHAPES)
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
