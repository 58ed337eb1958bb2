# SPDX-License-Identifier: GPL-3.0-or-later
"""`fathom width`: the depth of a body against itself, told as a width."""
import json
import unittest
from fractions import Fraction

from harness import UNIT, CliTest, box, case

SLAB = box([0, 0, 0], [3, "1/2", 2])
FLAT = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]


class Width(CliTest):
    def test_fields(self):
        path = self.file("slab.xyz", SLAB)
        result = self.result("width", "--counters", path)
        self.assertEqual(list(result), ["schema", "fathom", "id", "status", "signed_depth", "depth", "translation", "direction", "contact",
                                        "witness", "unit_f64", "translation_f64", "witness_f64", "optima", "sizes", "flat", "method",
                                        "counters", "width"])
        self.assertEqual((result["id"], result["width"]["squared"], result["width"]["value"]), (path, "1/4", 0.5))
        self.assertEqual(result["width"], result["depth"])
        self.assertEqual([optimum["direction"] for optimum in result["optima"]], [["0", "-1", "0"], ["0", "1", "0"]])

    def test_is_the_depth_against_itself(self):
        path = self.file("slab.xyz", SLAB)
        width, depth = self.result("width", path), self.result("depth", path, path)
        self.assertEqual((width.pop("width"), width.pop("id")), (depth["depth"], path))
        depth.pop("id")
        del depth["sizes"]["b"]
        self.assertEqual(width, depth)

    def test_text(self):
        code, out, err = self.run_cli("width", "--digits", "3", self.file("slab.xyz", SLAB))
        self.assertEqual((code, err), (0, ""))
        lines = out.splitlines()
        self.assertEqual(lines[:4], ["width      0.5", "enclosure  [0.5, 0.5]", "direction  (0, -1, 0)",
                                     "contact    facet-facet: points 2 3 6 7 of A, 0 1 4 5 of A"])
        self.assertRegex(lines[4], r"^witness    \(.*, 0.5, .*\) of A, \(.*, 0, .*\) of A$")
        self.assertEqual(lines[5:7], ["ties       none", "sizes      A 3 x 0.5 x 2"])
        self.assertRegex(lines[7], r"^method     certificate: an inner polytope of \d+ facets$")
        self.assertEqual(self.answer("width", "--exact", self.file("slab.xyz", SLAB)).splitlines()[:2],
                         ["width      0.5", "width^2    1/4"])
        self.assertIn("3 pairs of planes", self.answer("width", self.file("unit.xyz", UNIT)))

    def test_flat_body(self):
        path = self.file("flat.xyz", FLAT)
        result = self.result("width", path)
        self.assertEqual((result["width"]["squared"], result["status"]), ("0", "touching"))
        self.assertIn("a", result["flat"])
        out = self.answer("width", path)
        self.assertTrue(out.startswith("width         0\n"), out)
        self.assertIn("\nflat          A\n", out)

    def test_methods_agree(self):
        path = self.file("slab.xyz", SLAB)
        exact, naive = self.result("width", "--method", "exact", path), self.result("width", "--method", "naive", path)
        shallow = self.result("width", "--method", "shallow", path)
        self.assertEqual([result.pop("method") for result in (exact, naive, shallow)], ["exact", "naive", "shallow"])
        self.assertEqual(exact, naive)
        self.assertEqual(exact, shallow)
        auto = self.result("width", path)
        self.assertEqual(auto.pop("method"), "certificate")
        self.assertEqual(auto, exact)

    def test_stream_takes_body_a(self):
        slab = [[float(Fraction(x)) for x in point] for point in SLAB]
        stream = case(slab, UNIT, id="one") + case(UNIT, slab, id="two") + case(FLAT, slab)
        for arguments in (["-"], [self.file("cases.jsonl", stream)], [self.file("cases.ndjson", stream)]):
            out = self.answer("width", "--json", *arguments, stdin=stream)
            self.assertEqual([(r["id"], r["width"]["squared"]) for r in map(json.loads, out.splitlines())],
                             [("one", "1/4"), ("two", "1"), ("3", "0")])
        self.assertEqual(self.answer("width", "-", stdin=stream).splitlines(), [
            "one: width 0.5; direction (0, -1, 0); facet-facet",
            "two: width 1; direction (-1, 0, 0); facet-facet; 3 ties", "3: width 0; direction (0, 0, 1); flat A"])


if __name__ == "__main__":
    unittest.main()
