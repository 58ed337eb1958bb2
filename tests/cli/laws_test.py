# SPDX-License-Identifier: GPL-3.0-or-later
"""Laws that join the answers of several commands: `depth` and `approx`, distances, and depths in other metrics."""
import json
import math
import re
import signal
import subprocess
import unittest
from fractions import Fraction

from harness import DATA, EXECUTABLE, PATIENCE, UNIT, CliTest, box, case
from schemas_test import SQUARE

CUBE, ICOSAHEDRON = str(DATA / "cube.off"), str(DATA / "icosahedron.off")
OCTAHEDRON = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]]
SKEW = [[3, 0, 0], [0, 1, 0], [0, 0, 1], ["-1/8", "-1/8", "-1/8"], [0, 0, 0]]
SHIFTED = box([0.75, 0.25, 0.125], [1.75, 1.25, 1.125])
STREAM = "".join([case(UNIT, SHIFTED, id="deep"), case(UNIT, box([1, 0, 0], [2, 1, 1]), id="touching"),
                  case(UNIT, box([2, 0, 0], [3, 1, 1]), id="apart"), case(SQUARE, UNIT, id="flat"), "noise\n"])


def numbers(point):
    return [Fraction(x) for x in point]


class Approx(CliTest):
    def check(self, approx, exact, field):
        """bound <= depth <= |t| <= (1 + delta) bound."""
        self.assertEqual((approx["id"], approx["status"], approx["flat"]), (exact["id"], exact["status"], exact["flat"]))
        length, bound, true = (Fraction(x["squared"]) for x in (approx[field], approx["bound"], exact[field]))
        delta = Fraction(approx["delta"])
        self.assertTrue(bound <= true <= length <= (1 + delta) ** 2 * bound, (bound, true, length))
        self.assertEqual(sum(Fraction(x) ** 2 for x in approx["translation"]), Fraction(approx["depth"]["squared"]))
        self.assertEqual((approx["method"], approx["optima"]), ("approx", []))

    def test_an_approximation_keeps_its_promise(self):
        real = DATA / "real_cases.jsonl"
        stream = case(UNIT, SQUARE, id="cube") + case(SQUARE, UNIT, id="flat")
        for field, approx, exact, deltas, inputs, stdin in (
                ("depth", "approx", "depth", ("1", "0.25", "1/100", "4e-4", "1000"), [CUBE, ICOSAHEDRON], ""),
                ("depth", "approx", "depth", ("1/10",), ["-"], STREAM), ("depth", "approx", "depth", ("1/5",), [real], ""),
                ("width", "width", "width", ("1", "1/4", "1/7", "1/900"), [ICOSAHEDRON], ""),
                ("width", "width", "width", ("1/3",), ["-"], stream)):
            truth = list(map(json.loads, self.run_cli(exact, "--json", *inputs, stdin=stdin)[1].splitlines()))
            for delta in deltas:
                out = self.run_cli(approx, "--json", "--delta", delta, *inputs, stdin=stdin)[1]
                for one, other in zip(map(json.loads, out.splitlines()), truth, strict=True):
                    if "error" in other:
                        self.assertEqual(one, other)
                    else:
                        self.check(one, other, field)

    def test_a_delta_that_takes_days_is_not_silent_and_can_be_interrupted(self):
        for command, rays in ((["approx", CUBE, CUBE], 4), (["width", CUBE], 2)):
            with subprocess.Popen([EXECUTABLE, *command, "--delta", "1e-9"], stdout=subprocess.PIPE,
                                  stderr=subprocess.PIPE) as process:
                words = process.stderr.readline().decode()
                process.send_signal(signal.SIGINT)  # while the grid is made, which takes minutes
                self.assertEqual((process.stderr.read(), process.wait(PATIENCE)), (b"fathom: interrupted\n", 130))
            self.assertEqual(words, f"fathom: --delta 1/1000000000 asks for about {rays}000000000 rays a case\n")


class Distance(CliTest):
    def check(self, result):
        """The laws of the fields, and that the translation is as long as they say."""
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

    def test_real_cases(self):
        disjoint = 0
        for line in self.answer("depth", "--json", DATA / "real_cases.jsonl").splitlines():
            result = json.loads(line)
            self.check(result)
            disjoint += result["status"] == "disjoint"
        self.assertGreater(disjoint, 3)


class Metric(CliTest):
    def metric(self, ball, *arguments):
        result = self.result("metric", "--ball", ball, *arguments)
        return result

    def test_every_optimum_separates(self):
        for points in (OCTAHEDRON, box([-1, -1, -1], [1, 1, 1]), SKEW):
            ball = self.file("ball.xyz", points)
            for result in (self.metric(ball, CUBE, ICOSAHEDRON), self.metric(ball, CUBE, CUBE)):
                self.assertEqual(result["direction"], result["optima"][0]["direction"])
                for optimum in result["optima"]:
                    t = [Fraction(x) for x in optimum["translation"]]
                    witness = optimum["witness"]
                    self.assertEqual([Fraction(y) - Fraction(x) for x, y in zip(witness["a"], witness["b"])], t)

    def test_a_large_ball(self):
        points = [[x, y, z] for x in range(-22, 23) for y in range(-22, 23) for z in (-3, 3)]
        points = [[f"{x}/{1 + x * x + y * y}", f"{y}/{1 + x * x + y * y}", f"{(x * x + y * y) * z}/{(1 + x * x + y * y) * abs(z)}"]
                  for x, y, z in points]  # on spheres through O, moved apart: about half are extreme
        path = self.file("large.xyz", points)
        result = self.metric(path, CUBE, ICOSAHEDRON)
        self.assertEqual(result["rays"], result["ball"]["vertices"])


if __name__ == "__main__":
    unittest.main()
