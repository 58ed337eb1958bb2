# SPDX-License-Identifier: GPL-3.0-or-later
"""Shapes at the door: in cases, on the command line, and what is said of them. Answers that can be found by hand."""
import json
import math
import os
import subprocess
import unittest
from fractions import Fraction

from harness import UNIT, CliTest
from schemas import validator

CASE = validator("case")


def at(x, y, z):
    return {"quaternion": [1, 0, 0, 0], "translation": [x, y, z]}


def ball(radius, x=0, y=0, z=0):
    return {"shape": "sphere", "radius": radius, "pose": at(x, y, z)}


ROOT_OF_TWO = f"{math.isqrt(2 << 400)}/{1 << 200}"
GRAZING = [{"shape": "ellipsoid", "radii": [1, 1, 2], "pose": pose} for pose in (at(0, 0, 0), at(ROOT_OF_TWO, ROOT_OF_TWO, 0))]


class Shapes(CliTest):
    def of(self, a, b, *options):
        pair = {"a": a, "b": b}
        CASE.validate(pair)
        result = self.result("depth", *options, "-", stdin=json.dumps(pair) + "\n")
        return result

    def exactly(self, a, b):
        exact = self.of(a, b)["signed_depth"]["exact"]
        return exact["sign"] * math.sqrt(Fraction(exact["root"])) + float(Fraction(exact["plus"]))

    def test_spheres(self):
        result = self.of(ball(1), ball(2, 2, 1, 0))
        self.assertEqual(result["signed_depth"]["exact"], {"sign": -1, "root": "5", "plus": "3"})
        self.assertEqual((result["status"], result["depth"]["squared"], result["method"]), ("penetrating", None, "exact"))
        self.assertEqual(result["contact"], {"kind": "vertex-vertex", "a": [0], "b": [0]})
        self.assertEqual(result["depth"]["value"], 0.7639320225002103, "of 3 - sqrt(5); in doubles 3 - 5 ** 0.5 is another")
        self.assertEqual(result["translation"], {"normal": ["-2", "-1", "0"], "alpha": "-1", "beta": "3"})
        apart = self.of(ball(1), ball(2, 3, 4, 0))
        self.assertEqual((apart["status"], apart["distance"]["squared"], apart["distance"]["translation"]),
                         ("disjoint", "4", ["6/5", "8/5", "0"]))
        self.assertEqual(apart["distance"]["witness"], {"a": ["3/5", "4/5", "0"], "b": ["9/5", "12/5", "0"]})
        self.assertEqual(apart["signed_depth"], {"low": -2, "high": -2, "exact": {"sign": -1, "root": "25", "plus": "3"}})
        self.assertEqual(self.of(ball("3"), ball(2, 3, 4, 0))["status"], "touching")
        self.assertEqual([self.of(ball(radius), ball(2, 3, 4, 0))["status"]
                          for radius in ("3.0000000000000000000001", "2.9999999999999999999999")],
                         ["penetrating", "disjoint"])

    def test_concentric_spheres_have_every_direction(self):
        result = self.of(ball(1), ball("1/2"))
        self.assertEqual(result["optimal_cone"], {"lineality": "all", "axis": None, "rays": []})
        self.assertEqual((result["signed_depth"]["low"], result["depth"]["squared"], result["direction"]), (1.5, "9/4", ["-1", "0", "0"]))

    def test_every_name(self):
        radii = {"radius_low": 1, "radius_high": "1/2", "half_length": 2}
        plane = {"shape": "halfspace", "normal": [0, 0, 1], "offset": 0}
        depths = {"sphere": ({"radius": 1}, 1), "capsule": ({"radius": 1, "half_length": 2}, 3), "tapered_capsule": (radii, 3),
                  "box": ({"half": [1, 2, 3]}, 3), "cylinder": ({"radius": 1, "half_length": 2}, 2),
                  "cone": ({"radius": 1, "half_length": 2}, 2),
                  "frustum": (radii, 2), "ellipsoid": ({"radii": [1, 2, 3]}, 3), "hull": ({"vertices": UNIT}, 0),
                  "triangle": ({"vertices": [[0, 0, 0], [1, 0, 0], [0, 0, 1]]}, 0),
                  "sum": ({"terms": [ball(1), {"shape": "box", "half": [1, 1, 1]}]}, 2)}
        for name, (fields, depth) in depths.items():
            for axis in ({}, {"axis": "x"}) if "half_length" in fields else ({},):
                result = self.of({"shape": name, **fields, **axis, "pose": at(0, 0, 0)}, plane)["signed_depth"]
                across = {"cylinder": 1, "cone": 1, "frustum": 1, "capsule": 1, "tapered_capsule": 1}[name] if axis else depth
                self.assertTrue(result["low"] <= across <= result["high"] <= across * (1 + 1e-9), (name, axis, result))
                rounded = self.of({"shape": "rounded_" + name, **fields, **axis, "margin": 0.25}, plane)["signed_depth"]
                self.assertTrue(rounded["low"] <= across + 0.25 <= rounded["high"] <= (across + 0.25) * (1 + 1e-9), (name, axis, rounded))

    def test_a_margin_is_in_units_of_the_world(self):
        double = [[2, 0, 0, 0], [0, 2, 0, 0], [0, 0, 2, 0]]
        plane = {"shape": "halfspace", "normal": [0, 0, 1], "offset": 0}
        self.assertEqual(self.exactly({"shape": "capsule", "radius": 1, "half_length": 2, "pose": double}, plane), 5)
        self.assertEqual(self.exactly({"vertices": UNIT, "margin": 1, "pose": double}, plane), 1)

    def test_poses(self):
        turned = {"shape": "box", "half": [1, 2, 3], "pose": {"quaternion": [1, 1, 0, 0]}}
        plane = {"shape": "halfspace", "normal": [0, 0, 1], "offset": 0}
        self.assertEqual(self.exactly(turned, plane), 2)
        quarter = {"quaternion": [1, 1, 0, 0], "translation": [0, 1, "1/4"]}
        result = self.of({"vertices": UNIT, "pose": quarter}, {"vertices": UNIT})
        self.assertEqual((result["method"], result["depth"]["squared"], result["direction"]), ("certificate", "9/16", ["0", "0", "1"]))

    def test_on_the_command_line(self):
        result = self.result("depth", "capsule:r=0.1,h=0.5", "box:half=1:1:0.25,at=0:0:0.8")
        self.assertEqual((result["status"], result["id"]), ("penetrating", "capsule:r=0.1,h=0.5 box:half=1:1:0.25,at=0:0:0.8"))
        self.assertAlmostEqual(result["signed_depth"]["low"], 0.05)
        turned = self.result("depth", "rounded_box:half=1:2:3,margin=1/2,quaternion=1:1:0:0", "halfspace:normal=0:0:1,offset=0")
        self.assertEqual(turned["signed_depth"]["low"], 2.5)
        exact = self.result("depth", "--exact-decimals", "sphere:r=0.1", "sphere:radius=0.2,at=0.3:0:0")
        self.assertEqual((exact["status"], self.result("depth", "sphere:r=0.1", "sphere:r=0.2,at=0.3:0:0")["status"]),
                         ("touching", "penetrating"))
        plain = self.result("depth", "box:half=1:1:1", "box:half=1:1:1,at=1:0:0")
        self.assertEqual((plain["method"], len(plain["optima"])), ("certificate", 1))

    def test_text(self):
        question = ["depth", "--digits", "3", "sphere:r=1", "sphere:r=2,at=2:1:0"]
        out, exact = self.answer(*question).splitlines(), self.answer(*question, "--exact").splitlines()
        self.assertEqual(out[0], "penetrating")
        self.assertIn("exactly      -sqrt(5) + 3", exact)
        self.assertFalse([line for line in out if line.startswith("exactly")])
        self.assertIn("enclosure    [0.763, 0.764]", out)

    def test_undecided_is_an_answer(self):
        """Two ellipsoids with less than 2^-200 between them."""
        signed_depth = self.of(*GRAZING)["signed_depth"]
        self.assertEqual(self.of(*GRAZING)["status"], "undecided")
        self.assertTrue(-1e-40 < signed_depth["low"] < 0 < signed_depth["high"] < 1e-40, signed_depth)

    def test_every_answer_is_proved(self):
        """A checker that shares nothing with the rest finds what each result says in its certificate."""
        cases = self.answer("cases", "--family", "all", "--shapes", "--count", "94") + self.answer("cases", "--catalogue", "--shapes")
        cases += json.dumps({"a": GRAZING[0], "b": GRAZING[1]}) + "\n"
        results = self.run_cli("depth", "--json", "--embed-certificate", "-", stdin=cases)[1]
        statuses = set()
        for line in results.splitlines():
            result = json.loads(line)
            statuses.add(result["status"])
        self.assertEqual(statuses, {"penetrating", "touching", "disjoint", "undecided"})
        done = subprocess.run([os.environ["FATHOM_CHECK"], "--results", "-"], input=results.encode(), stdout=subprocess.PIPE, check=False)
        self.assertEqual([line for line in done.stdout.decode().splitlines() if not line.startswith("s VERIFIED ")], [])
        self.assertEqual((done.returncode, done.stdout.count(b"\n")), (0, cases.count("\n")))


if __name__ == "__main__":
    unittest.main()
