# SPDX-License-Identifier: GPL-3.0-or-later
"""The distance of disjoint bodies in what `fathom depth` says: with it, one signed function of a sweep across contact."""
import json
import math
import re
import unittest
from fractions import Fraction

import jsonschema  # Debian: python3-jsonschema
from harness import DATA, ROOT, UNIT, CliTest, box, case

VALIDATOR = jsonschema.Draft202012Validator(json.loads((ROOT / "reference/output/result.schema.json").read_text()))


def numbers(point):
    return [Fraction(x) for x in point]


class Distance(CliTest):
    def check(self, result):
        """The laws of the fields, and that the translation is as long as they say."""
        VALIDATOR.validate(result)
        if result["status"] != "disjoint":
            self.assertNotIn("distance", result)
            return
        distance = result["distance"]
        t, n = numbers(distance["translation"]), numbers(distance["direction"])
        self.assertEqual(sum(x * x for x in t), Fraction(distance["squared"]))
        self.assertLess(sum(x * y for x, y in zip(t, n)), 0)
        self.assertEqual([t[0] * n[1], t[1] * n[2], t[2] * n[0]], [t[1] * n[0], t[2] * n[1], t[0] * n[2]], "parallel")
        self.assertEqual(result["direction"], distance["direction"], "the direction is the distance's")
        witness = distance["witness"]
        self.assertEqual([y - x for x, y in zip(numbers(witness["a"]), numbers(witness["b"]))], t)

    def test_fields(self):
        corner = [[3, 3, 3], [4, 3, 3], [3, 4, 3], [3, 3, 4]]
        result = self.result("depth", "--digits", "4", self.file("a.xyz", UNIT), self.file("b.xyz", corner))
        self.check(result)
        self.assertEqual(list(result), ["schema", "fathom", "id", "status", "signed_depth", "depth", "translation", "direction", "contact",
                                        "witness", "unit_f64", "translation_f64", "witness_f64", "optima", "distance", "sizes", "flat",
                                        "method"])
        self.assertEqual({key: value for key, value in result["distance"].items() if key != "rounded"},
                         {"squared": "12", "value": 12 ** 0.5, "enclosure": ["3.464", "3.465"], "direction": ["-1", "-1", "-1"],
                          "translation": ["2", "2", "2"], "witness": {"a": ["1", "1", "1"], "b": ["3", "3", "3"]},
                          "unit_f64": [-0.5773502691896257] * 3, "translation_f64": [2, 2, 2],
                          "witness_f64": {"a": [1, 1, 1], "b": [3, 3, 3]}})
        self.assertEqual((result["unit_f64"], result["translation_f64"], result["witness_f64"]),
                         ([-0.5773502691896257] * 3, [0, 0, 0], None))

    def test_signed_depth(self):
        """low <= the number that `exact` says <= high, neighbours among the doubles or equal, whatever the size."""
        def scaled(points, factor):
            return [[str(Fraction(x) * factor) for x in p] for p in points]

        sweep = [box([Fraction(x, 8), 0, 0], [Fraction(x, 8) + 1, 1, 1]) for x in range(5, 12)] + [[[3, 3, 3], [4, 3, 3], [3, 4, 3],
                                                                                                    [3, 3, 4]]]
        stream = "".join(case(scaled(UNIT, factor), scaled(b, factor)) for factor in (1, Fraction(1, 3), Fraction(10)**400,
                                                                                      Fraction(1, 10**330))
                         for b in sweep)
        values = []
        for line in self.answer("depth", "--json", "-", stdin=stream).splitlines():
            result = json.loads(line)
            self.check(result)
            low, high, exact = (result["signed_depth"][field] for field in ("low", "high", "exact"))
            root, sign = Fraction(exact["root"]), exact["sign"]
            self.assertEqual((exact["plus"], sign), ("0", {"penetrating": 1, "touching": 0, "disjoint": -1}[result["status"]]))
            self.assertEqual(root, Fraction((result["distance"] if sign < 0 else result["depth"])["squared"]))
            square = root * sign
            if low is not None:
                self.assertLessEqual(Fraction(low) * abs(Fraction(low)), square)
            if high is not None:
                self.assertGreaterEqual(Fraction(high) * abs(Fraction(high)), square)
            if low is not None and high is not None:
                self.assertTrue(high == low or math.nextafter(low, math.inf) == high, (low, high))
                self.assertEqual(low == high, Fraction(high) * abs(Fraction(high)) == square)
            values.append((low, high))
        largest = math.nextafter(math.inf, 0)
        self.assertEqual(values[:7], [(x / 8, x / 8) for x in (3, 2, 1, 0, -1, -2, -3)])
        self.assertEqual(values[16:24], [(largest, None)] * 3 + [(0, 0)] + [(None, -largest)] * 4)
        self.assertEqual(values[24:], [(0, 5e-324)] * 3 + [(0, 0)] + [(-5e-324, 0)] * 4)
        self.assertNotIn("-0", re.findall(r'"(?:low|high)":(-?0)[,}]', self.answer("depth", "--json", "-", stdin=stream)))

    def test_an_approximation_is_signed_too(self):
        stream = case(UNIT, box([0.3, 0.1, 0.2], [1, 1.5, 9])) + case(UNIT,
                                                                      box([1, 0, 0], [2, 1, 1])) + case(UNIT, box([2, 0, 0], [3, 1, 1]))
        deep, touching, apart = (json.loads(line)["signed_depth"] for line in self.answer("approx", "--json", "-",
                                                                                          stdin=stream).splitlines())
        exact = json.loads(self.answer("depth", "--json", "-", stdin=stream).splitlines()[0])["signed_depth"]
        self.assertTrue(0 < deep["low"] <= exact["low"] <= exact["high"] <= deep["high"] <= deep["low"] * 1.02)
        self.assertEqual((touching, apart), ({"low": 0, "high": 0}, {"low": None, "high": 0}))

    def test_text(self):
        a, b = self.file("a.xyz", UNIT), self.file("b.xyz", box([3, 0, 0], [4, 1, 1]))
        out = self.answer("depth", "--digits", "2", a, b).splitlines()
        self.assertEqual(out[:4], ["disjoint", "depth      0", "distance   2", "enclosure  [2, 2]"])
        self.assertRegex(out[4], r"^nearest    \(1, .*\) of A, \(3, .*\) of B$")
        self.assertEqual(out[5:7], ["A to B     (2, 0, 0)", "direction  (-1, 0, 0)"])
        exact = self.answer("depth", "--exact", a, b).splitlines()
        self.assertEqual(exact[:5], ["disjoint", "depth       0", "depth^2     0", "distance    2", "distance^2  4"])
        line = self.answer("depth", "-", stdin=case(UNIT, box([3, 0, 0], [4, 1, 1]), id="apart"))
        self.assertTrue(line.startswith("apart: disjoint; depth 0; distance 2; direction (-1, "), line)

    def test_a_separating_normal_is_called_one(self):
        """Whoever finds no distance shows some plane between the bodies, and does not call it the direction."""
        a, b = self.file("a.xyz", UNIT), self.file("b.xyz", box([3, 4, 5], [4, 5, 6]))
        ball = self.file("ball.xyz", box([-1, -1, -1], [1, 1, 1]))
        for command in (["approx"], ["metric", "--ball", ball], ["ray", "--direction=1,0,0"]):
            out = self.answer(*command, a, b)
            self.assertRegex(out, r"(?m)^separating normal +\(-?\d", command)
            self.assertNotRegex(out, r"(?m)^(direction|normal) ", command)
            self.assertIn("; separating normal (", self.answer(*command, "-", stdin=case(UNIT, box([3, 4, 5], [4, 5, 6]))))

    def test_a_sweep_across_contact_is_one_function(self):
        stream = "".join(case(UNIT, box([f"{16 + step}/16", "1/4", 0], [4, 2, 1])) for step in range(-4, 5))
        signed = []
        for line in self.answer("depth", "--json", "-", stdin=stream).splitlines():
            result = json.loads(line)
            self.check(result)
            signed.append(-Fraction(result["distance"]["squared"]) if "distance" in result else Fraction(result["depth"]["squared"]))
        self.assertEqual(signed, [Fraction(-step * abs(step), 256) for step in range(-4, 5)])

    def test_real_cases(self):
        disjoint = 0
        for line in self.answer("depth", "--json", DATA / "real_cases.jsonl").splitlines():
            result = json.loads(line)
            self.check(result)
            disjoint += result["status"] == "disjoint"
        self.assertGreater(disjoint, 3)

    def test_the_schema_has_teeth(self):
        good = self.result("depth", self.file("a.xyz", UNIT), self.file("b.xyz", box([3, 0, 0], [4, 1, 1])))
        for change in ({"squared": "0"}, {"squared": "-4"}, {"witness": None}, {"direction": None}, {"more": 1}):
            self.assertFalse(VALIDATOR.is_valid({**good, "distance": {**good["distance"], **change}}), change)
        self.assertFalse(VALIDATOR.is_valid({**good, "status": "touching"}))


if __name__ == "__main__":
    unittest.main()
