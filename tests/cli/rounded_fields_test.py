# SPDX-License-Identifier: GPL-3.0-or-later
"""unit_f64, translation_f64, witness_f64: to the nearest double, of every exact vector beside which they stand."""
import json
import math
import unittest
from decimal import Decimal, localcontext
from fractions import Fraction

from harness import DATA, UNIT, CliTest, box, case

TETRAHEDRON = [["1/3", 0, 0], [0, "2/7", 0], [0, 0, "1/9"], ["-1/5", "-1/3", "-1/4"]]
PAIRS = [(UNIT, box(["3/4", "1/4", "1/8"], ["7/4", "5/4", "9/8"])), (TETRAHEDRON, UNIT),
         (TETRAHEDRON, [["1/10", "1/7", "1/30"], [3, 2, 1]]),
         (UNIT, [["4/3", "5/3", "9/7"], [3, 3, 3]]), (UNIT, box([1, 0, 0], [2, 1, 1])), (UNIT[:4], UNIT)]
SHAPES = [{"shape": "sphere", "radius": "1/3"}, {"shape": "capsule", "radius": 0.1, "half_length": 1, "pose": {"quaternion": [3, 1, 2, 1]}},
          {"vertices": TETRAHEDRON, "margin": "1/7"}, {"shape": "box", "half": [1, 2, 3], "margin": 0.25, "pose": "xyz=2,1,0 quat=5,1,1,2"},
          {"shape": "sphere", "radius": 2, "pose": {"xyz": [5, "1/3", -4]}}]


def decimal(value):
    value = Fraction(value)
    return Decimal(value.numerator) / Decimal(value.denominator)


def along(start, factor, normal):
    """start + factor normal/|normal|, to a hundred digits."""
    n = [Decimal(x) for x in normal]
    length = sum(x * x for x in n).sqrt()
    return [s + decimal(factor) * x / length for s, x in zip(start, n)]


def place(exact):
    """The coordinates of an exact point or vector, in each of its forms."""
    if isinstance(exact, list):
        return [decimal(x) for x in exact]
    if "core" in exact:
        return along(place(exact["core"]), exact["distance"], exact["normal"])
    return along([decimal(exact["alpha"]) * Decimal(x) for x in exact["normal"]], exact["beta"], exact["normal"])


def nearest(coordinates):
    floats = [float(x) for x in coordinates]
    return floats if all(map(math.isfinite, floats)) else None


class RoundedFields(CliTest):
    def check(self, result):
        with localcontext() as context:
            context.prec = 100
            for fields in (result, *([result["distance"]] if "distance" in result else [])):
                self.assertEqual(fields["unit_f64"], nearest(along([Decimal(0)] * 3, 1, fields["direction"])))
                translation, witness = fields["translation"], fields["witness"]
                self.assertEqual(fields["translation_f64"], translation and nearest(place(translation)))
                self.assertEqual(fields["witness_f64"], witness and {body: nearest(place(witness[body])) for body in "ab"})

    def test_polytopes(self):
        stream = "".join(case(a, b) for a, b in PAIRS)
        for command in (["depth"], ["width"], ["approx", "--delta", "1/7"], ["width", "--delta", "1/3"], ["depth", "--method", "exact"]):
            results = [json.loads(line) for line in self.answer(*command, "--json", "-", stdin=stream).splitlines()]
            self.assertEqual(len(results), len(PAIRS))
            for result in results:
                self.check(result)
        self.check(self.result("depth", DATA / "cube.off", DATA / "icosahedron.off"))

    def test_shapes(self):
        stream = "".join(json.dumps({"a": a, "b": b}) + "\n" for a in SHAPES for b in SHAPES)
        results = [json.loads(line) for line in self.answer("depth", "--json", "-", stdin=stream).splitlines()]
        for result in results:
            self.check(result)
        self.assertEqual({result["status"] for result in results}, {"penetrating", "disjoint"})
        self.assertTrue(any(isinstance(result["translation"], dict) for result in results), "some are irrational")

    def test_what_is_not_known_is_null(self):
        result = self.result("depth", "ellipsoid:radii=1:2:3", "sphere:r=1,at=1:1:1")
        self.check(result)
        self.assertEqual((result["translation_f64"], result["witness_f64"]), (None, None))
        self.assertAlmostEqual(math.hypot(*result["unit_f64"]), 1)

    def test_beyond_binary64(self):
        def scaled(factor):
            return [[str(x * factor) for x in point] for point in UNIT], [[str((x + Fraction(1, 2)) * factor) for x in point]
                                                                          for point in UNIT]
        huge = self.result("depth", "-", stdin=case(*scaled(Fraction(10) ** 400)))
        tiny = self.result("depth", "-", stdin=case(*scaled(Fraction(1, 10 ** 400))))
        self.assertEqual((huge["unit_f64"], huge["translation_f64"], tiny["translation_f64"]), ([-1, 0, 0], None, [0, 0, 0]))
        self.check(huge)
        self.check(tiny)


if __name__ == "__main__":
    unittest.main()
