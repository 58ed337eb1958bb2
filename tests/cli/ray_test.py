# SPDX-License-Identifier: GPL-3.0-or-later
"""`fathom ray`: how far A must move in one direction."""
import json
import unittest
from fractions import Fraction

import jsonschema  # Debian: python3-jsonschema
from harness import DATA, ROOT, UNIT, CliTest, box, case

SCHEMA = json.loads((ROOT / "cli/output/ray.schema.json").read_text())
VALIDATOR = jsonschema.Draft202012Validator(SCHEMA)
CUBE, ICOSAHEDRON = str(DATA / "cube.off"), str(DATA / "icosahedron.off")
SHIFTED = box([0.75, 0.25, 0.125], [1.75, 1.25, 1.125])
SQUARE = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]
STREAM = "".join([case(UNIT, SHIFTED, id="deep"), case(UNIT, box([1, 0, 0], [2, 1, 1]), id="touching"),
                  case(UNIT, box([2, 0, 0], [3, 1, 1]), id="apart"), case([[0.5, 0.5, 0.25]], UNIT, id="point"),
                  case(SQUARE, SQUARE), "noise\n"])


class Ray(CliTest):
    def ray(self, direction, *arguments):
        result = self.result("ray", f"--direction={direction}", *arguments)
        VALIDATOR.validate(result)
        return result

    def test_two_boxes(self):
        a, b = self.file("a.xyz", UNIT), self.file("b.xyz", SHIFTED)
        for direction, factor, normal in (("-1,0,0", "1/4", [-1, 0, 0]), ("1,0,0", "7/4", [1, 0, 0]), ("-2,0,0", "1/8", [-1, 0, 0]),
                                          ("0,0,0.5", "9/4", [0, 0, 1]), ("-1/3,-1/3,-1/3", "3/4", [-1, 0, 0]),
                                          ("0, -1, 0", "3/4", [0, -1, 0])):
            result = self.ray(direction, a, b)
            self.assertEqual((result["factor"], result["normal"]), (factor, [str(x) for x in normal]), direction)
            ray = [Fraction(x) for x in result["ray"]]
            self.assertEqual(ray, [Fraction(x) for x in direction.split(",")])
            translation = [Fraction(factor) * x for x in ray]
            self.assertEqual([Fraction(x) for x in result["translation"]], translation)
            self.assertEqual(Fraction(result["length"]["squared"]), sum(x * x for x in translation))
            witness = result["witness"]
            self.assertEqual([Fraction(y) - Fraction(x) for x, y in zip(witness["a"], witness["b"])], translation)
            self.assertEqual(result["contact"]["kind"], "facet-facet")

    def test_along_the_optimum_it_is_the_depth(self):
        depth = self.result("depth", CUBE, ICOSAHEDRON)
        ray = self.ray(",".join(depth["direction"]), CUBE, ICOSAHEDRON)
        for one, other in (("length", "depth"), ("translation", "translation"), ("normal", "direction"), ("contact", "contact")):
            self.assertEqual(ray[one], depth[other])

    def test_stream(self):
        code, out, err = self.run_cli("ray", "--json", "--direction", "0,0,1", "--digits", "4", "-", stdin=STREAM)
        self.assertEqual((code, err), (2, "fathom: errors: 1 of 6 lines\n"))
        lines = [json.loads(line) for line in out.splitlines()]
        for line in lines:
            VALIDATOR.validate(line)
        self.assertEqual([line["factor"] for line in lines[:5]], ["9/8", "0", "0", "3/4", "0"])
        self.assertEqual([line["status"] for line in lines[:5]], ["penetrating", "touching", "disjoint", "penetrating", "touching"])
        self.assertEqual([line["flat"] for line in lines[:5]], [[], [], [], ["a"], ["a", "b"]])
        self.assertEqual(list(lines[5]), ["schema", "id", "line", "error"])
        text = self.run_cli("ray", "--direction", "0,0,1", self.file("cases.jsonl", STREAM))[1].splitlines()
        self.assertEqual(text[0], "deep: penetrating; length 1.125; translation (0, 0, 1.125); normal (0, 0, 1); facet-facet")
        self.assertEqual(text[3], "point: penetrating; length 0.75; translation (0, 0, 0.75); normal (0, 0, 1); vertex-facet; flat A")

    def test_text(self):
        a, b = self.file("a.xyz", UNIT), self.file("b.xyz", SHIFTED)
        out = self.answer("ray", "--direction", "-1,0,0", "--digits", "2", a, b).splitlines()
        self.assertEqual(out[:5], ["penetrating", "depth along  (-1, 0, 0)", "length       0.25", "enclosure    [0.25, 0.25]",
                                   "translation  (-0.25, 0, 0)"])
        self.assertIn("normal       (-1, 0, 0)", out)
        exact = self.answer("ray", "--direction", "-1,0,0", "--digits", "2", "--exact", a, b).splitlines()
        self.assertEqual(exact[:7], ["penetrating", "depth along  (-1, 0, 0)", "length       0.25", "length^2     1/16",
                                     "enclosure    [0.25, 0.25]", "factor       1/4", "translation  (-1/4, 0, 0)"])

    def test_says_that_hulls_are_taken(self):
        path = self.file("a.xyz", UNIT + [["1/2", "1/2", "1/2"]])
        self.assertIn("A: 1 of 9 points are not extreme; the convex hull is taken",
                      self.run_cli("ray", "--direction", "1,0,0", path, CUBE)[2])
        stream = case(UNIT + [[0.5, 0.5, 0.5]], UNIT)
        self.assertIn("<stdin>:1: A: 1 of 9 points are not extreme", self.run_cli("ray", "--direction", "1,0,0", "-", stdin=stream)[2])

    def test_misuse(self):
        self.assertIn("ray expects --direction X,Y,Z", self.refused("ray", CUBE, CUBE))
        for direction in ("0,0,0", "1,2", "1,2,3,4", "1,2,x", "", "1 2 3", "inf,0,0", "1,,2"):
            words = [f"--direction={direction}"] if direction else ["--direction", ""]
            err = self.refused("ray", *words, CUBE, CUBE)
            self.assertIn("--direction: expected three numbers such as 1,0,-1/2, not all zero", err)
        self.assertIn("ray expects two meshes", self.refused("ray", "--direction", "1,0,0"))
        self.assertIn("expected a readable file", self.refused("ray", "--direction", "1,0,0", CUBE, self.folder / "none.off"))

    def test_the_schema_has_teeth(self):
        jsonschema.Draft202012Validator.check_schema(SCHEMA)
        good = self.ray("1,0,0", CUBE, ICOSAHEDRON)
        for field in good:
            self.assertFalse(VALIDATOR.is_valid({key: value for key, value in good.items() if key != field}), field)
        for change in ({"factor": "0"}, {"factor": "-1"}, {"normal": None}, {"status": "disjoint"}, {"ray": ["1", "0"]}, {"more": 1},
                       {"witness": None}, {"steps": -1}):
            self.assertFalse(VALIDATOR.is_valid({**good, **change}), change)


if __name__ == "__main__":
    unittest.main()
