# SPDX-License-Identifier: GPL-3.0-or-later
"""`fathom depth A B`: every field and every option, on bodies whose answers can be found by hand."""
import json
import math
import re
import unittest
from fractions import Fraction

from harness import DATA, UNIT, VERSION, CliTest, box, case

SHIFTED = box([0.75, 0.25, 0.125], [1.75, 1.25, 1.125])
CUBE, ICOSAHEDRON = str(DATA / "cube.off"), str(DATA / "icosahedron.off")


class Fields(CliTest):
    def test_one_optimum(self):
        a, b = self.file("a.xyz", UNIT), self.file("b.xyz", SHIFTED)
        result = self.result("depth", a, b)
        witness, rounded_witness = result.pop("witness"), result.pop("witness_f64")
        self.assertEqual(rounded_witness, {body: [float(Fraction(x)) for x in witness[body]] for body in "ab"})
        contact = {"kind": "facet-facet", "a": [1, 3, 5, 7], "b": [0, 2, 4, 6]}
        quarter = {"rn": "0x1p-2", "rd": "0x1p-2", "ru": "0x1p-2"}
        expected = {
            "schema": "fathom/result/2", "fathom": VERSION, "id": f"{a} {b}", "status": "penetrating",
            "signed_depth": {"low": 0.25, "high": 0.25, "exact": {"sign": 1, "root": "1/16", "plus": "0"}},
            "depth": {"squared": "1/16", "value": 0.25, "rounded": {"f64": quarter, "f32": quarter}},
            "unit_f64": [-1, 0, 0], "translation_f64": [-0.25, 0, 0],
            "translation": ["-1/4", "0", "0"], "direction": ["-1", "0", "0"], "contact": contact,
            "optima": [{"direction": ["-1", "0", "0"], "translation": ["-1/4", "0", "0"], "contact": contact}],
            "sizes": {"a": [1, 1, 1], "b": [1, 1, 1]}, "flat": [], "method": "certificate"}
        self.assertEqual(result, expected)
        point_a, point_b = ([Fraction(x) for x in witness[body]] for body in "ab")
        self.assertEqual([y - x for x, y in zip(point_a, point_b)], [Fraction(-1, 4), 0, 0])
        self.assertEqual((point_a[0], point_b[0]), (1, Fraction(3, 4)))

    def test_order_of_fields(self):
        out = self.answer("depth", "--json", "--counters", "--digits", "3", CUBE, ICOSAHEDRON)
        self.assertEqual(list(json.loads(out)), ["schema", "fathom", "id", "status", "signed_depth", "depth", "translation", "direction",
                                                 "contact", "witness", "unit_f64", "translation_f64", "witness_f64", "optima", "sizes",
                                                 "hull", "flat", "method", "counters"])
        self.assertEqual(list(json.loads(out)["depth"]), ["squared", "value", "rounded", "enclosure"])

    def test_ties_are_listed_in_order(self):
        a = self.file("a.xyz", UNIT)
        result = self.result("depth", a, a)
        self.assertEqual([optimum["direction"] for optimum in result["optima"]],
                         [["-1", "0", "0"], ["0", "-1", "0"], ["0", "0", "-1"], ["0", "0", "1"], ["0", "1", "0"], ["1", "0", "0"]])
        for field in ("direction", "translation", "contact"):
            self.assertEqual(result[field], result["optima"][0][field])

    def test_contact_kinds(self):
        def wedge(x, body, along):
            """An edge at x, long in y or z; the rest of the body lies on the side `body` of it."""
            points = [[x, 0, z] for z in (-4, 4)] + [[x + 9 * body, y, z] for y in (-1, 1) for z in (-4, 4)]
            return [[x, z, y] for x, y, z in points] if along == "y" else points

        def tip(x, body):
            return [[x, 0, 0]] + [[x + 9 * body, y, z] for y in (-1, 1) for z in (-1, 1)]

        left, right = box([-8, -20, -20], [1, 20, 20]), box([0, -20, -20], [8, 20, 20])
        pairs = {"facet-vertex": (left, tip(0, 1)), "vertex-facet": (tip(1, -1), right), "facet-edge": (left, wedge(0, 1, "z")),
                 "edge-facet": (wedge(1, -1, "y"), right), "facet-facet": (left, box([0, -1, -1], [8, 1, 1])),
                 "edge-edge": (wedge(1, -1, "y"), wedge(0, 1, "z"))}
        for kind, (a, b) in pairs.items():
            with self.subTest(kind=kind):
                result = self.result("depth", self.file("a.xyz", a), self.file("b.xyz", b))
                self.assertEqual((result["contact"]["kind"], result["direction"]), (kind, ["-1", "0", "0"]))

    def test_touching_and_disjoint(self):
        nothing = {"rn": "0x0p+0", "rd": "0x0p+0", "ru": "0x0p+0"}
        for low, status in ((1, "touching"), ("5/4", "disjoint")):
            result = self.result("depth", self.file("a.xyz", UNIT), self.file("b.xyz", [[low, 0, 0], [3, 0, 0], [2, 1, 0], [2, 0, 1]]))
            self.assertEqual(result["status"], status)
            self.assertEqual(result["depth"], {"squared": "0", "value": 0, "rounded": {"f64": nothing, "f32": nothing}})
            contact = None if status == "touching" else {"kind": "facet-vertex", "a": [1, 3, 5, 7], "b": [0]}
            self.assertEqual((result["translation"], result["contact"], result["optima"]), (["0", "0", "0"], contact, []))
            self.assertLess(int(result["direction"][0]), 0) if status == "disjoint" else self.assertEqual(result["direction"],
                                                                                                       ["-1", "0", "0"])
            self.assertEqual(result["witness"], {"a": ["1", "0", "0"], "b": ["1", "0", "0"]} if status == "touching" else None)

    def test_flat_bodies(self):
        square = self.file("square.xyz", [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]])
        cube = self.file("cube.xyz", box([-1, -1, -1], [2, 2, "1/4"]))
        self.assertEqual(self.result("depth", square, cube)["flat"], ["a"])
        self.assertEqual(self.result("depth", cube, square)["flat"], ["b"])
        both = self.result("depth", square, square)
        self.assertEqual((both["flat"], both["status"], both["depth"]["squared"]), (["a", "b"], "touching", "0"))
        self.assertIn("A has no interior", self.answer("depth", square, cube))
        self.assertNotIn("A has no interior", self.answer("depth", cube, square))

    def test_beyond_binary64(self):
        def solved(scale):
            factor = Fraction(scale)
            return self.result("depth", *(self.file(name, [[Fraction(x) * factor for x in p] for p in points])
                                          for name, points in (("a.xyz", UNIT), ("b.xyz", SHIFTED))))["depth"]

        large, small, edge = solved(10**400), solved(Fraction(1, 10**400)), solved(Fraction(1, 2**1072))
        self.assertEqual(large["squared"], str(Fraction(10**800, 16)))
        self.assertIsNone(large["value"])
        self.assertEqual(large["rounded"]["f64"], {"rn": "inf", "rd": "0x1.fffffffffffffp+1023", "ru": "inf"})
        self.assertIsNone(small["value"])
        self.assertEqual(small["squared"], str(Fraction(1, 16 * 10**800)))
        self.assertEqual(small["rounded"]["f64"], {"rn": "0x0p+0", "rd": "0x0p+0", "ru": "0x0.0000000000001p-1022"})
        self.assertEqual(edge["value"], 5e-324)
        self.assertEqual(edge["rounded"]["f32"], {"rn": "0x0p+0", "rd": "0x0p+0", "ru": "0x1p-149"})

    def test_any_file_name(self):
        name = self.folder / "caf\u00e9 \x01.xyz"
        name.write_text("0 0 0\n")
        self.assertEqual(self.result("depth", name, name)["id"], f"{name} {name}")
        raw = bytes(self.folder) + b"/\xff.xyz"
        with open(raw, "w", encoding="ascii") as file:
            file.write("0 0 0\n")
        self.assertIn("\ufffd", json.loads(self.run_cli("depth", "--json", "--", name, raw.decode(errors="surrogateescape"))[1])["id"])


class Options(CliTest):
    def test_method(self):
        exact = self.result("depth", "--method", "exact", CUBE, ICOSAHEDRON)
        naive = self.result("depth", "--method", "naive", CUBE, ICOSAHEDRON)
        self.assertEqual((exact.pop("method"), naive.pop("method")), ("exact", "naive"))
        self.assertEqual(exact, naive)
        shallow = self.result("depth", "--method", "shallow", "--counters", CUBE, ICOSAHEDRON)
        counters = shallow.pop("counters")
        self.assertEqual(shallow.pop("method"), "shallow")
        self.assertEqual(exact, shallow)
        self.assertTrue(counters["rays"] > 0 and 0 < counters["facets_visited"] and counters["crossings"] == 0)
        for arguments in ([], ["--method", "auto"], ["--method", "certificate"], ["--seed", "7"]):
            again = self.result("depth", *arguments, CUBE, ICOSAHEDRON)
            self.assertEqual(again.pop("method"), "certificate")
            self.assertEqual(again, exact)
        for arguments in (["--method=exact"], ["--closest-lines", "naive"], ["--closest-lines", "cutting"], ["--closest-lines", "sampled"],
                          ["--closest-lines", "naive", "--method", "exact"]):
            again = self.result("depth", *arguments, CUBE, ICOSAHEDRON)
            self.assertEqual(again.pop("method"), "exact")
            self.assertEqual(again, exact)

    def test_counters(self):
        self.assertNotIn("counters", self.result("depth", CUBE, ICOSAHEDRON))
        counters = self.result("depth", "--method", "exact", "--counters", CUBE, ICOSAHEDRON)["counters"]
        self.assertEqual([counters[f"{what}_{body}"] for what in ("vertices", "edges", "facets") for body in "ab"], [8, 12, 12, 30, 6, 20])
        self.assertGreater(counters["crossings"], 0)
        self.assertGreater(counters["predicates"]["order_on_vertical"]["calls"], 0)
        self.assertEqual(counters["stages"], ["hulls", "position", "vertex-facet pairs", "canonical subsets", "closest lines"])
        out = self.answer("depth", "--counters", CUBE, ICOSAHEDRON)
        self.assertIn("\ncounted       expanding polytope\nexpansions ", out)
        self.assertNotRegex(out, "crossings|seed|vertices_a|rays|calls", "what did not run has no counts")
        out = self.answer("depth", "--method", "exact", "--counters", CUBE, ICOSAHEDRON)
        self.assertRegex(out, "\ncounted +hulls, position, vertex-facet pairs, canonical subsets, closest lines\nvertices_a +8\n")
        self.assertNotIn("inner_facets", out)
        self.assertRegex(out, r"\nvertices_b +12\n")
        self.assertRegex(out, r"\norder_on_vertical +\d+ calls, \d+ exact, \d+ zero\n")

    def test_text_names_the_method(self):
        self.assertRegex(self.answer("depth", CUBE, ICOSAHEDRON), r"\nmethod +certificate: an inner polytope of \d+ facets\n")
        self.assertRegex(self.answer("depth", "--method", "exact", CUBE, ICOSAHEDRON), r"\nmethod +exact\n")
        near_ties = self.file("ties.jsonl", self.answer("cases", "--family", "crossed_ties", "--size", "40"))
        self.assertEqual(self.result("depth", near_ties)["method"], "exact")

    def test_optima(self):
        a = self.file("a.xyz", UNIT)
        everything = self.result("depth", a, a)
        self.assertNotIn("optima_count", everything)
        for method in ("auto", "exact", "naive", "shallow"):
            for listed in (1, 4, 6, 2**63):
                some = self.result("depth", "--method", method, "--optima", listed, a, a)
                self.assertEqual(some.pop("optima_count"), 6)
                self.assertEqual(some["optima"], everything["optima"][:listed])
                for field in ("direction", "translation", "contact", "witness", "depth"):
                    self.assertEqual(some[field], everything[field])
        self.assertEqual(self.result("depth", "--optima", 3, a, self.file("b.xyz", [[2, 0, 0]]))["optima_count"], 0)
        self.assertIn("\nties         6 nearest facets; the first is shown, --json lists all\n", self.answer("depth", "--optima", 1, a, a))
        for wrong in ("0", "-1", "x", "1.5", str(2**64)):
            self.assertIn("expected an integer from 1 on", self.refused("depth", f"--optima={wrong}", a, a))
        self.refused("width", "--optima", "1", a)

    def test_optima_with_certificate(self):
        a = self.file("a.xyz", UNIT)
        for listed, word, verdict in ((2, "some", "depth_squared=1 "), (6, "all", "depth_squared=1 optima=6 ")):
            result = self.result("depth", "--optima", listed, "--embed-certificate", a, a)
            self.assertIn(f"\ndirections {listed} {word}\n", result["certificate"])
            self.assertIn(verdict, self.answer("check", self.file("proof.cert", result["certificate"])))

    def test_digits(self):
        low, high = self.result("depth", "--digits", "40", CUBE, ICOSAHEDRON)["depth"]["enclosure"]
        squared = Fraction(self.result("depth", CUBE, ICOSAHEDRON)["depth"]["squared"])
        self.assertTrue(Fraction(low) ** 2 < squared < Fraction(high) ** 2)
        self.assertEqual(Fraction(high) - Fraction(low), Fraction(1, 10**40))
        self.assertIn(f"\nenclosure    [{low}, {high}]\n", self.answer("depth", "--digits", "40", CUBE, ICOSAHEDRON))
        same = self.file("same.xyz", UNIT)
        self.assertEqual(self.result("depth", "--digits", "5", same, same)["depth"]["enclosure"], ["1", "1"])

    def test_exact_decimals(self):
        a, b = self.file("a.xyz", UNIT), self.file("b.xyz", box(["0.9", 0, 0], [3, 1, 1]))
        self.assertEqual(self.result("depth", "--exact-decimals", a, b)["depth"]["squared"], "1/100")
        rounded = self.result("depth", a, b)["depth"]
        self.assertEqual(rounded["squared"], str((1 - Fraction(0.9)) ** 2))
        self.assertEqual(rounded["value"], 1 - 0.9)
        huge = self.file("huge.xyz", [["1e400", 0, 0], [0, "1e400", 0], [0, 0, "1e400"], [0, 0, 0]])
        self.assertIsNone(self.result("depth", "--exact-decimals", huge, huge)["depth"]["value"])


class Text(CliTest):
    def test_block(self):
        a, b = self.file("a.xyz", UNIT), self.file("b.xyz", SHIFTED)
        code, out, err = self.run_cli("depth", a, b)
        self.assertEqual((code, err), (0, ""))
        self.assertEqual(out.splitlines()[:5], [
            "penetrating", "depth        0.25", "direction    (-1, 0, 0)", "translation  (-0.25, 0, 0)",
            "contact      facet-facet: points 1 3 5 7 of A, 0 2 4 6 of B"])
        self.assertEqual(out.splitlines()[6:8], ["ties         none", "sizes        A 1 x 1 x 1, B 1 x 1 x 1"])
        self.assertRegex(out.splitlines()[8], r"^method       certificate: an inner polytope of \d+ facets$")
        exact = self.answer("depth", "--exact", a, b).splitlines()
        self.assertEqual(exact[:5], ["penetrating", "depth        0.25", "depth^2      1/16", "direction    (-1, 0, 0)",
                                     "translation  (-1/4, 0, 0)"])
        self.assertEqual(len(exact), len(out.splitlines()) + 1)
        self.assertEqual(self.answer("depth", "--exact", "-", stdin=case(UNIT, SHIFTED, id="x")),
                         "x: penetrating; depth 0.25; depth^2 1/16; direction (-1, 0, 0); facet-facet\n")
        self.assertIn("--exact is about text", self.refused("depth", "--exact", "--json", a, b))
        self.assertIn("\nties         6 nearest facets; the first is shown, --json lists all\n", self.answer("depth", a, a))

    def test_long_numbers(self):
        """Decimals are the shortest ones of the nearest doubles, which fit a terminal; fractions are in full."""
        out, exact = self.answer("depth", CUBE, ICOSAHEDRON), self.answer("depth", "--exact", CUBE, ICOSAHEDRON)
        result = self.result("depth", CUBE, ICOSAHEDRON)
        for text in (out, exact):
            self.assertIn(f"\ndepth        {result['depth']['value']!r}\n", text)
        self.assertIn(f"\ndepth^2      {result['depth']['squared']}\n", exact)
        self.assertNotIn("/", out)
        self.assertLessEqual(max(map(len, out.splitlines())), 80)
        first, witness = Fraction(result["translation"][0]), result["witness"]
        self.assertIn(f"\ntranslation  ({float(first)!r}, ", out)
        self.assertIn(f"\ntranslation  ({', '.join(result['translation'])})\n", exact)
        points = ["({})".format(", ".join(repr(float(Fraction(x))).removesuffix(".0") for x in witness[body])) for body in "ab"]
        self.assertIn(f"\nwitness      {points[0]} of A\n             {points[1]} of B\n", out)
        unit = [x / math.hypot(*map(float, result["direction"])) for x in map(float, result["direction"])]
        shown = re.search(r"\ndirection    \((.*)\)\n", out)[1]
        for x, y in zip(map(float, shown.split(", ")), unit):
            self.assertAlmostEqual(x, y, delta=1e-15)
        self.assertIn(f"\ndirection    ({', '.join(result['direction'])})\n", exact)

    def test_beyond_binary64(self):
        huge = self.file("huge.xyz", [[f"{10**400}", 0, 0], [0, f"{10**400}", 0], [0, 0, f"{10**400}"], [0, 0, 0]])
        out = self.answer("depth", huge, huge)
        self.assertIn("\ndepth        5.7735026918962576e399\n", out)
        self.assertIn("\ntranslation  (-3.3333333333333333e399, -3.3", out)

    def test_touching_and_disjoint(self):
        a = self.file("a.xyz", UNIT)
        out = self.answer("depth", a, self.file("b.xyz", box([1, 0, 0], [2, 1, 1])))
        self.assertTrue(out.startswith("touching\ndepth         0\n"), out)
        self.assertIn("\ncommon point  (1, ", out)
        self.assertTrue(self.answer("depth", a, self.file("b.xyz", box([2, 0, 0], [3, 1, 1]))).startswith("disjoint\ndepth      0\n"))


if __name__ == "__main__":
    unittest.main()
