# SPDX-License-Identifier: GPL-3.0-or-later
"""What the commands around depth say of shapes: how near, what ran, which faces meet, what coincides, and who answers instead."""
import json
import unittest
from fractions import Fraction

from harness import UNIT, CliTest, case
from schemas import validator

STUDY = validator("study")
CURVED = ("cylinder:r=1,h=2", "cone:r=1,h=1,quaternion=2:1:0:0,at=0.5:0.25:2.5")
OCTAHEDRON = [[2, 0, 0], [-2, 0, 0], [0, 2, 0], [0, -2, 0], [0, 0, 2], [0, 0, -2]]


class Nearness(CliTest):
    def width_of_bounds(self, *options):
        result = self.result("depth", *options, "--digits", "60", *CURVED)
        low, high = map(Fraction, result["depth"]["enclosure"])
        return float(high - low)

    def test_bits(self):
        widths = [self.width_of_bounds("--bits", bits) for bits in (10, 40, 120)]
        for width, bits in zip(widths, (10, 40, 120), strict=True):
            self.assertTrue(0 < width <= 2.0**-bits * 10, (bits, width))
        self.assertGreater(widths[0], widths[1])

    def test_digits_ask_for_bits(self):
        for digits in (5, 20, 50):
            result = self.result("depth", "--digits", digits, *CURVED)
            low, high = map(Fraction, result["depth"]["enclosure"])
            self.assertTrue(0 < high - low <= Fraction(3, 10**digits), digits)
        bounds = self.result("depth", "--digits", "30", "--bits", "8", *CURVED)["depth"]["enclosure"]
        self.assertGreater(Fraction(bounds[1]) - Fraction(bounds[0]), Fraction(1, 10**8), "bits that are given count")
        inside = self.result("depth", *CURVED)["signed_depth"]
        self.assertTrue(Fraction(bounds[0]) <= inside["high"] and inside["low"] <= Fraction(bounds[1]))

    def test_of_what_is_apart(self):
        result = self.result("depth", "--digits", "12", "sphere:r=1", "ellipsoid:radii=1:2:3,at=4:1:1")
        low, high = map(Fraction, result["distance"]["enclosure"])
        self.assertTrue(0 < low <= high < low + Fraction(1, 10**9))
        self.assertTrue(low <= -result["signed_depth"]["low"] and -result["signed_depth"]["high"] <= high)
        self.assertIn("enclosure", self.answer("depth", "--digits", "12", "sphere:r=1", "ellipsoid:radii=1:2:3,at=4:1:1"))


class Counters(CliTest):
    def test_say_what_ran(self):
        counters = {}
        for name, pair in {"curved": CURVED, "plane": ("sphere:r=1", "halfspace:normal=0:0:1,offset=0"),
                           "cores": ("box:half=1:1:1,margin=0.5", "box:half=1:2:3,at=1:1:1"),
                           "apart": ("sphere:r=1", "sphere:r=1,at=3:4:5")}.items():
            result = self.result("depth", "--counters", *pair)
            counters[name] = result["counters"]
            text = self.answer("depth", "--counters", *pair)
            self.assertIn("counted", text)
            for stage in result["counters"]["stages"]:
                self.assertIn(stage, text)
        self.assertEqual({name: found["stages"] for name, found in counters.items()},
                         {"curved": ["expanding polytope", "supports"], "plane": ["supports"], "cores": ["expanding polytope"],
                          "apart": ["position"]})
        self.assertGreater(counters["curved"]["support_calls"], 4)
        self.assertEqual(counters["plane"]["support_calls"], 1)
        self.assertNotIn("counted", self.answer("depth", *CURVED))


class Contacts(CliTest):
    def test_of_disjoint_bodies(self):
        far = [[4, 5, 6], [9, 9, 9]]
        slanted = [[3, 0.5, -1], [3, 0.5, 2], [5, 0, 0], [5, 1, 0]]
        for b, kind in ((far, "vertex-vertex"), ([[3, 0.5, 0.5]], "facet-vertex"), (slanted, "facet-edge"),
                        ([[2, 2, -1], [2, 2, 3]], "edge-edge"), ([[2, 2, 0.5]], "edge-vertex"),
                        ([[2, 0, 0], [2, 1, 0], [2, 0, 1]], "facet-facet")):
            result = json.loads(self.answer("depth", "--json", "-", stdin=case(UNIT, b)))
            self.assertEqual((result["status"], result["contact"]["kind"]), ("disjoint", kind))
            swapped = json.loads(self.answer("depth", "--json", "-", stdin=case(b, UNIT)))["contact"]
            self.assertEqual((swapped["a"], swapped["b"]), (result["contact"]["b"], result["contact"]["a"]))
            self.assertIn(kind, self.answer("depth", "-", stdin=case(UNIT, b)))

    def test_of_rounded_bodies(self):
        for pair, status, kind in ((("sphere:r=1", "box:half=1:1:1,at=0:0:2"), "touching", "vertex-facet"),
                                   (("sphere:r=1", "capsule:r=1,h=1,at=1:0:0"), "penetrating", "vertex-edge"),
                                   (("capsule:r=1,h=2", "capsule:r=1,h=1,axis=x,at=0:0:2"), "penetrating", "vertex-edge"),
                                   (("capsule:r=1,h=2", "capsule:r=1,h=1,at=3:0:0"), "disjoint", "edge-edge")):
            result = self.result("depth", *pair)
            self.assertEqual((result["status"], result["contact"]["kind"]), (status, kind), pair)
        for pair in (CURVED, ("sphere:r=1", "halfspace:normal=0:0:1,offset=-1")):
            self.assertIsNone(self.result("depth", *pair)["contact"])


class Width(CliTest):
    def test_of_rounded_bodies(self):
        for body, squared in (("sphere:r=1", "4"), ("capsule:r=1,h=5", "4"), ("box:half=1:2:3,margin=0.5", "9"), ("hull", "1")):
            if body == "hull":
                body = self.file("unit.xyz", UNIT)
            result = self.result("width", body)
            self.assertEqual((result["width"], result["width"]["squared"]), (result["depth"], squared), body)
            self.assertTrue(self.answer("width", body).startswith("width "))

    def test_of_curved_bodies(self):
        result = self.result("width", "--bits", "20", "ellipsoid:radii=1:2:3")
        self.assertTrue(result["signed_depth"]["low"] <= 2 <= result["signed_depth"]["high"] < 2 + 1e-5)

    def test_of_a_stream(self):
        pair = json.dumps({"id": "x", "a": {"shape": "sphere", "radius": 2}, "b": {"vertices": UNIT}})
        self.assertEqual(self.answer("width", "-", stdin=pair), "x: width 4; direction (-1, 0, 0)\n")
        self.assertEqual(self.answer("width", "--exact", "-", stdin=pair), "x: width 4; exactly 4; direction (-1, 0, 0)\n")
        other = json.dumps({"a": {"vertices": UNIT}, "b": {"shape": "sphere", "radius": 2}})
        self.assertEqual(json.loads(self.answer("width", "--json", "-", stdin=other))["width"]["squared"], "1")


class Others(CliTest):
    def test_say_which_command_answers(self):
        for command in (["approx"], ["ray", "--direction=1,0,0"], ["metric", "--ball", self.file("ball.xyz", OCTAHEDRON)]):
            for pair in (("sphere:r=1", "sphere:r=1"), (self.file("unit.xyz", UNIT), "cylinder:r=1,h=1")):
                error = self.refused(*command, *pair)
                self.assertTrue("expected a polytope" in error and "depth" in error, error)
            self.answer(*command, "box:half=1:1:1", "box:half=1:1:1")


class Study(CliTest):
    def counts(self, *pair):
        study = self.result("study", *pair)
        return {name: found["count"] for name, found in study["coincidences"].items() if found["count"]}, study

    def test_obeys_its_schema(self):
        names = ("sphere", "rim_on", "apex_on", "cones_along", "margin", "tapered", "sum_on", "capsules_crossing")
        cases = [line for line in self.answer("cases", "--catalogue", "--shapes").splitlines() if json.loads(line)["id"].startswith(names)]
        for option in ([], ["--all"]):
            lines = self.answer("study", "--json", *option, "-", stdin="\n".join(cases)).splitlines()
            self.assertEqual(len(lines), len(cases))
        self.assertGreater(len(cases), 20)

    def test_the_schema_has_teeth(self):
        _, good = self.counts("sphere:r=1", "cylinder:r=1,h=1,at=0:0:2")
        for field in good:
            if field != "cores":
                self.assertFalse(STUDY.is_valid({key: good[key] for key in good if key != field}), field)
        for wrong in ({**good, "more": 1}, {**good, "status": "inside"},
                      {**good, "contact": {"a": {"feature": "nose"}, "b": {"feature": "face"}}}):
            self.assertFalse(STUDY.is_valid(wrong))

    def test_names(self):
        counts, study = self.counts("cone:r=1,h=1,quaternion=0:1:0:0,at=0:0:2", "box:half=1:1:1")
        self.assertEqual((counts["apex_on_face"], study["contact"]["a"]["feature"], study["contact"]["b"]["feature"]), (1, "apex", "face"))
        self.assertNotIn("cores", study)
        counts, study = self.counts("capsule:r=1,h=1", "capsule:r=1,h=1,at=2:0:0")
        self.assertEqual((counts["tangent_generators"], counts["equal_radii"], counts["distance_of_radii"]), (1, 1, 1))
        self.assertEqual(study["cores"]["coincidences"]["parallel_edges"]["count"], 1)
        self.assertEqual(self.counts("ellipsoid:radii=1:2:3", "box:half=1:2:4,quaternion=1:2:3:4")[0], {"concentric": 1})

    def test_text(self):
        text = self.answer("study", "sphere:r=1", "box:half=1:1:1,at=0:0:2")
        for words in ("touching; signed depth 0\n", "A  1 point, radius 1\n",
                      "tangent to face              1  A smooth point (0, 0, 1), B face (0, 0, -1)", "none: equal bodies, ",
                      "\ncores\n"):
            self.assertIn(words, text)
        line = self.answer("study", "-",
                           stdin=json.dumps({"id": "x", "a": {"shape": "sphere", "radius": 1}, "b": {"shape": "sphere", "radius": 2}}))
        self.assertEqual(line, "x: penetrating; signed depth 3; concentric 1; touching cores 1\n")

    def test_of_a_mixed_stream(self):
        shapes = json.dumps({"id": "s", "a": {"shape": "sphere", "radius": 1}, "b": {"vertices": UNIT}}) + "\n"
        kinds = ["predicates" in json.loads(line) for line in self.answer("study", "--json", "-",
                                                                          stdin=case(UNIT, UNIT) + shapes).splitlines()]
        self.assertEqual(kinds, [True, False])
        code, out, _ = self.run_cli("study", "--csv", "-", stdin=case(UNIT, UNIT, id="p") + shapes)
        rows = out.splitlines()
        self.assertEqual((code, len(rows)), (2, 3))
        self.assertIn("--json takes both", rows[2])
        self.assertIn("expected one half-space at most", self.refused("study", "halfspace:normal=0:0:1,offset=1",
                                                                      "halfspace:normal=0:0:1,offset=1"))


if __name__ == "__main__":
    unittest.main()
