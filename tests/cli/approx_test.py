# SPDX-License-Identifier: GPL-3.0-or-later
"""`fathom approx` and `fathom width --delta`: within a factor, by the exact commands' own answers."""
import copy
import json
import signal
import subprocess
import unittest
from fractions import Fraction

import jsonschema  # Debian: python3-jsonschema
from harness import DATA, EXECUTABLE, PATIENCE, ROOT, UNIT, CliTest, box, case

VALIDATOR = jsonschema.Draft202012Validator(json.loads((ROOT / "reference/output/result.schema.json").read_text()))
CUBE, ICOSAHEDRON = str(DATA / "cube.off"), str(DATA / "icosahedron.off")
SQUARE = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]
SHIFTED = box([0.75, 0.25, 0.125], [1.75, 1.25, 1.125])
STREAM = "".join([case(UNIT, SHIFTED, id="deep"), case(UNIT, box([1, 0, 0], [2, 1, 1]), id="touching"),
                  case(UNIT, box([2, 0, 0], [3, 1, 1]), id="apart"), case(SQUARE, UNIT, id="flat"), "noise\n"])


class Approx(CliTest):
    def check(self, approx, exact, field="depth"):
        """bound <= depth <= |t| <= (1 + delta) bound."""
        VALIDATOR.validate(approx)
        self.assertEqual((approx["id"], approx["status"], approx["flat"]), (exact["id"], exact["status"], exact["flat"]))
        length, bound, true = (Fraction(x["squared"]) for x in (approx[field], approx["bound"], exact[field]))
        delta = Fraction(approx["delta"])
        self.assertTrue(bound <= true <= length <= (1 + delta) ** 2 * bound, (bound, true, length))
        self.assertEqual(sum(Fraction(x) ** 2 for x in approx["translation"]), Fraction(approx["depth"]["squared"]))
        self.assertEqual((approx["method"], approx["optima"]), ("approx", []))

    def test_fields(self):
        result = self.result("approx", "--delta", "1/4", CUBE, ICOSAHEDRON)
        self.assertEqual(list(result), ["schema", "fathom", "id", "status", "signed_depth", "depth", "translation", "direction", "contact",
                                        "witness", "unit_f64", "translation_f64", "witness_f64", "optima", "sizes", "hull", "flat",
                                        "method", "delta", "rays", "bound"])
        self.assertEqual((result["delta"], result["rays"]), ("1/4", 24))
        self.check(result, self.result("depth", CUBE, ICOSAHEDRON))

    def test_a_delta_that_takes_days_is_not_silent_and_can_be_interrupted(self):
        for command, rays in ((["approx", CUBE, CUBE], 4), (["width", CUBE], 2)):
            with subprocess.Popen([EXECUTABLE, *command, "--delta", "1e-9"], stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
                words = process.stderr.readline().decode()
                process.send_signal(signal.SIGINT)  # while the grid is made, which takes minutes
                self.assertEqual((process.stderr.read(), process.wait(PATIENCE)), (b"fathom: interrupted\n", 130))
            self.assertEqual(words, f"fathom: --delta 1/1000000000 asks for about {rays}000000000 rays a case\n")
        self.assertEqual(self.run_cli("approx", "--delta", "1e-4", CUBE, CUBE)[2], "")

    def test_deltas(self):
        exact = self.result("depth", CUBE, ICOSAHEDRON)
        rays = []
        for text, delta in (("1", "1"), ("0.25", "1/4"), ("1/100", "1/100"), ("4e-4", "1/2500"), ("1000", "1000")):
            result = self.result("approx", "--delta", text, CUBE, ICOSAHEDRON)
            self.assertEqual(result["delta"], delta)
            self.check(result, exact)
            rays.append(result["rays"])
        self.assertEqual(rays[0], 6)
        self.assertEqual(rays[-1], 6)
        self.assertTrue(rays[0] < rays[1] < rays[2] < rays[3] < 5 * 2500)
        self.assertEqual(self.result("approx", CUBE, ICOSAHEDRON)["delta"], "1/100", "unless given")

    def test_stream(self):
        code, out, err = self.run_cli("approx", "--json", "--delta", "1/10", "-", stdin=STREAM)
        self.assertEqual((code, err), (2, "fathom: errors: 1 of 5 lines\n"))
        lines = [json.loads(line) for line in out.splitlines()]
        exact = [json.loads(line) for line in self.run_cli("depth", "--json", "-", stdin=STREAM)[1].splitlines()]
        for one, other in zip(lines[:4], exact[:4]):
            self.check(one, other)
        self.assertEqual(lines[4], exact[4])
        self.assertEqual([line["rays"] > 0 for line in lines[:4]], [True, False, False, False])
        text = self.run_cli("approx", "--delta", "1/10", self.file("cases.jsonl", STREAM))[1].splitlines()
        self.assertTrue(text[0].startswith("deep: penetrating; depth at most 0.25; at least 0.2"), text[0])
        self.assertTrue(text[1].startswith("touching: touching; depth at most 0; at least 0; direction "), text[1])

    def test_real_cases(self):
        def lines(*arguments):
            return [json.loads(line) for line in self.answer(*arguments, "--json", DATA / "real_cases.jsonl").splitlines()]
        for one, other in zip(lines("approx", "--delta", "1/5"), lines("depth"), strict=True):
            self.check(one, other)

    def test_text(self):
        a, b = self.file("a.xyz", UNIT), self.file("b.xyz", box(["3/4", "1/4", "1/8"], ["7/4", "5/4", "9/8"]))
        out = self.answer("approx", "--delta", "1/2", "--digits", "3", a, b).splitlines()
        self.assertEqual(out[:2], ["penetrating", "depth at most   0.25"])
        self.assertIn("enclosure       [0.25, 0.25]", out)
        self.assertIn("delta           1/2", out)
        self.assertIn("translation     (-0.25, 0, 0)", out)
        self.assertIn("contact         facet-facet: points 1 3 5 7 of A, 0 2 4 6 of B", out)
        self.assertIn("sizes           A 1 x 1 x 1, B 1 x 1 x 1", out)
        exact = self.answer("approx", "--delta", "1/2", "--exact", a, b).splitlines()
        self.assertEqual(exact[:3], ["penetrating", "depth at most    0.25", "depth^2 at most  1/16"])
        self.assertIn("translation      (-1/4, 0, 0)", exact)

    def test_says_that_hulls_are_taken(self):
        path = self.file("a.xyz", UNIT + [["1/2", "1/2", "1/2"]])
        self.assertIn("A: 1 of 9 points are not extreme", self.run_cli("approx", path, CUBE)[2])
        self.assertIn("1 of 9 points are not extreme", self.run_cli("width", "--delta", "1", path)[2])

    def test_misuse(self):
        for delta in ("0", "-1", "x", "", "1/0", "1e-10", "nan"):
            self.assertIn("--delta: expected a positive number such as 1/100", self.refused("approx", f"--delta={delta}", CUBE, CUBE)
                          if delta else self.refused("approx", "--delta", "", CUBE, CUBE))
        self.assertIn("approx expects two meshes, or one stream", self.refused("approx", "--delta", "1"))
        self.assertIn("found the single mesh", self.refused("approx", CUBE))
        for option in ("--method", "--counters", "--closest-lines", "--csv"):
            self.assertIn(option, self.refused("approx", option, "exact", CUBE, CUBE))
        self.assertIn("expected a readable file", self.refused("approx", CUBE, self.folder / "none.off"))

    def test_the_schema_has_teeth(self):
        good = self.result("approx", CUBE, ICOSAHEDRON)
        VALIDATOR.validate(good)
        for change in ({"delta": "0"}, {"delta": 1}, {"rays": -1}, {"bound": None}, {"method": "exact"}, {"optima": [{}]}, {"witness": 1},
                       {"counters": {}}, {"distance": None}):
            self.assertFalse(VALIDATOR.is_valid({**copy.deepcopy(good), **change}), change)
        optional = {"unit_f64", "translation_f64", "witness_f64", "sizes", "hull"}
        for field in good.keys() - optional:
            self.assertFalse(VALIDATOR.is_valid({key: value for key, value in good.items() if key != field}), field)


class Width(Approx):
    def test_fields(self):
        result, exact = self.result("width", "--delta", "1/4", ICOSAHEDRON), self.result("width", ICOSAHEDRON)
        self.assertEqual(list(result)[-4:], ["delta", "rays", "bound", "width"])
        self.assertEqual((result["rays"], result["width"]), (12, result["depth"]), "half of the rays suffice")
        self.check(result, exact, "width")

    def test_text(self):
        out = self.answer("width", "--delta", "1", CUBE).splitlines()
        self.assertEqual(out[:3], ["width at most   1", "width at least  0.5", "delta           1"])
        flat = self.answer("width", "--delta", "1", self.file("flat.xyz", SQUARE))
        self.assertTrue(flat.startswith("width at most   0\n"), flat)
        self.assertIn("\nflat            A\n", flat + "\n")

    def test_stream(self):
        stream = case(UNIT, SQUARE, id="cube") + case(SQUARE, UNIT, id="flat")
        for one, other in zip(*([json.loads(line) for line in self.answer("width", "--json", *options, "-", stdin=stream).splitlines()]
                                for options in (["--delta", "1/3"], []))):
            self.check(one, other, "width")
        self.assertTrue(self.answer("width", "--delta", "1", "-", stdin=stream).startswith("cube: width at most 1; at least 0.5"))

    def test_misuse(self):
        for options in (["--method", "naive"], ["--closest-lines", "naive"], ["--counters"]):
            self.assertIn("cannot be combined", self.refused("width", "--delta", "1/2", *options, CUBE))
        self.assertIn("--delta: expected one value, once", self.refused("width", CUBE, "--delta"))

    def test_deltas(self):
        exact = self.result("width", ICOSAHEDRON)
        for delta in ("1", "1/7", "1/900"):
            self.check(self.result("width", "--delta", delta, ICOSAHEDRON), exact, "width")

    test_real_cases = test_says_that_hulls_are_taken = test_the_schema_has_teeth = None


if __name__ == "__main__":
    unittest.main()
