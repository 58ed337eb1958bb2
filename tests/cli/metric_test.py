# SPDX-License-Identifier: GPL-3.0-or-later
"""`fathom metric`: depths in polyhedral norms and gauges."""
import json
import unittest
from fractions import Fraction

import jsonschema  # Debian: python3-jsonschema
from harness import DATA, ROOT, UNIT, CliTest, box, case

SCHEMA = json.loads((ROOT / "cli/output/metric.schema.json").read_text())
VALIDATOR = jsonschema.Draft202012Validator(SCHEMA)
CUBE, ICOSAHEDRON = str(DATA / "cube.off"), str(DATA / "icosahedron.off")
SHIFTED = box([0.75, 0.25, 0.125], [1.75, 1.25, 1.125])
OCTAHEDRON = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]]
SKEW = [[3, 0, 0], [0, 1, 0], [0, 0, 1], ["-1/8", "-1/8", "-1/8"], [0, 0, 0]]
SQUARE = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]
STREAM = "".join([case(UNIT, SHIFTED, id="deep"), case(UNIT, UNIT, id="same"), case(UNIT, box([1, 0, 0], [2, 1, 1]), id="touching"),
                  case(UNIT, box([2, 0, 0], [3, 1, 1]), id="apart"), case(SQUARE, UNIT, id="flat"), "noise\n"])


class Metric(CliTest):
    def setUp(self):
        super().setUp()
        self.balls = {name: self.file(name + ".xyz", points) for name, points in
                      (("octahedron", OCTAHEDRON), ("cube", box([-1, -1, -1], [1, 1, 1])), ("skew", SKEW))}

    def metric(self, ball, *arguments, **options):
        result = self.result("metric", "--ball", self.balls[ball], *arguments, **options)
        VALIDATOR.validate(result)
        return result

    def test_two_boxes(self):
        a, b = self.file("a.xyz", UNIT), self.file("b.xyz", SHIFTED)
        octahedron = self.metric("octahedron", a, b)
        self.assertEqual(list(octahedron), ["schema", "id", "status", "ball", "depth", "direction", "optima", "flat", "rays"])
        self.assertEqual((octahedron["ball"], octahedron["rays"]), ({"kind": "norm", "vertices": 6}, 6))
        self.assertEqual((octahedron["depth"]["exact"], octahedron["depth"]["value"]), ("1/4", 0.25))
        self.assertEqual([(o["vertex"], o["translation"]) for o in octahedron["optima"]], [(1, ["-1/4", "0", "0"])])
        cube = self.metric("cube", a, b)
        self.assertEqual((cube["depth"]["exact"], [o["vertex"] for o in cube["optima"]]), ("1/4", [0, 2, 4, 6]))
        skew = self.metric("skew", a, b)
        self.assertEqual((skew["ball"], skew["depth"]["exact"]), ({"kind": "gauge", "vertices": 4}, "7/12"))
        self.assertEqual([(o["vertex"], o["translation"]) for o in skew["optima"]], [(0, ["7/4", "0", "0"])])
        back = self.metric("skew", b, a)
        self.assertEqual((back["depth"]["exact"], back["optima"][0]["translation"]), ("1/12", ["1/4", "0", "0"]))

    def test_every_optimum_separates(self):
        for ball in self.balls:
            for result in (self.metric(ball, CUBE, ICOSAHEDRON), self.metric(ball, CUBE, CUBE)):
                self.assertEqual(result["direction"], result["optima"][0]["direction"])
                for optimum in result["optima"]:
                    t = [Fraction(x) for x in optimum["translation"]]
                    witness = optimum["witness"]
                    self.assertEqual([Fraction(y) - Fraction(x) for x, y in zip(witness["a"], witness["b"])], t)

    def test_stream(self):
        code, out, err = self.run_cli("metric", "--json", "--ball", self.balls["octahedron"], "-", stdin=STREAM)
        self.assertEqual((code, err), (2, "fathom: errors: 1 of 6 lines\n"))
        lines = [json.loads(line) for line in out.splitlines()]
        for line in lines:
            VALIDATOR.validate(line)
        self.assertEqual([line["depth"]["exact"] for line in lines[:5]], ["1/4", "1", "0", "0", "0"])
        self.assertEqual([len(line["optima"]) for line in lines[:5]], [1, 6, 0, 0, 0])
        self.assertEqual(list(lines[5]), ["schema", "id", "line", "error"])
        text = self.run_cli("metric", "--ball", self.balls["octahedron"], self.file("cases.jsonl", STREAM))[1].splitlines()
        self.assertEqual(text[0], "deep: penetrating; depth 0.25 in the norm; translation (-0.25, 0, 0); facet-facet")
        self.assertTrue(text[1].endswith("; 6 ties"), text[1])
        self.assertTrue(text[3].startswith("apart: disjoint; depth 0 in the norm; separating normal (-1, "), text[3])

    def test_text_says_norm_or_gauge(self):
        a, b = self.file("a.xyz", UNIT), self.file("b.xyz", SHIFTED)
        out = self.answer("metric", "--ball", self.balls["cube"], a, b).splitlines()
        self.assertEqual(out[:4], ["penetrating", "depth        0.25", "unit ball    norm: symmetric about O; 8 vertices",
                                   "vertices     0 2 4 6 of the ball; the first is shown, --json lists all"])
        self.assertIn("exactly      1/4\n", self.answer("metric", "--ball", self.balls["cube"], "--exact", a, b))
        self.assertIn("gauge: not symmetric about O", self.answer("metric", "--ball", self.balls["skew"], a, b))

    def test_a_large_ball(self):
        points = [[x, y, z] for x in range(-22, 23) for y in range(-22, 23) for z in (-3, 3)]
        points = [[f"{x}/{1 + x * x + y * y}", f"{y}/{1 + x * x + y * y}", f"{(x * x + y * y) * z}/{(1 + x * x + y * y) * abs(z)}"]
                  for x, y, z in points]  # on spheres through O, moved apart: about half are extreme
        path = self.file("large.xyz", points)
        result = self.result("metric", "--ball", path, CUBE, ICOSAHEDRON)
        VALIDATOR.validate(result)
        self.assertEqual(result["rays"], result["ball"]["vertices"])

    def test_says_that_hulls_are_taken(self):
        path = self.file("a.xyz", UNIT + [["1/2", "1/2", "1/2"]])
        self.assertIn("B: 1 of 9 points are not extreme; the convex hull is taken",
                      self.run_cli("metric", "--ball", self.balls["cube"], CUBE, path)[2])

    def test_bad_balls(self):
        a = self.file("a.xyz", UNIT)
        for points, why in ((UNIT, "O on its boundary"), (box([1, 1, 1], [2, 2, 2]), "does not contain O"), (SQUARE, "flat"),
                            ([[0, 0, 0]], "flat")):
            path = self.file("ball.xyz", points)
            err = self.refused("metric", "--ball", path, a, a)
            self.assertTrue(err.startswith(f"fathom: {path}: the unit ball "), err)
            self.assertIn(why, err)
        self.assertIn("expected a readable file", self.refused("metric", "--ball", self.folder / "none.off", a, a))
        self.assertIn("ball.xyz", self.refused("metric", "--ball", self.file("ball.xyz", ""), a, a))
        self.assertIn("metric expects --ball Q", self.refused("metric", a, a))
        self.assertIn("metric expects two meshes", self.refused("metric", "--ball", self.balls["cube"]))

    def test_the_schema_has_teeth(self):
        jsonschema.Draft202012Validator.check_schema(SCHEMA)
        good = self.metric("skew", CUBE, ICOSAHEDRON)
        for field in good:
            self.assertFalse(VALIDATOR.is_valid({key: value for key, value in good.items() if key != field}), field)
        for change in ({"depth": {"exact": "1"}}, {"ball": {"kind": "ball", "vertices": 4}}, {"optima": []}, {"status": "touching"},
                       {"rays": -1}, {"more": 1}, {"optima": [{**good["optima"][0], "vertex": "0"}]}):
            self.assertFalse(VALIDATOR.is_valid({**good, **change}), change)


if __name__ == "__main__":
    unittest.main()
