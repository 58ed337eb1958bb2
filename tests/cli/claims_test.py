# SPDX-License-Identifier: GPL-3.0-or-later
"""`fathom certify --claims`: what was published, against the truth."""
import json
import unittest

import jsonschema  # Debian: python3-jsonschema
from harness import ROOT, CliTest

FILE = ROOT / "verify" / "claims" / "claims.jsonl"
SCHEMAS = {f"{name}.schema.json": json.loads((ROOT / "schemas" / f"{name}.schema.json").read_text()) for name in ("claim", "result")}
VALIDATOR = jsonschema.Draft202012Validator(
    SCHEMAS["claim.schema.json"],
    resolver=jsonschema.RefResolver("claim.schema.json", SCHEMAS["claim.schema.json"], store=SCHEMAS))


def ball(radius, x=0, y=0, z=0):
    return {"shape": "sphere", "radius": radius, "pose": {"quaternion": [1, 0, 0, 0], "translation": [x, y, z]}}


class Claims(CliTest):
    def judged(self, claim, a=None, b=None):
        """The verdict on the claim, and on each statement. Without bodies: two balls, 3 - sqrt(5) = 0.76393202 deep along (2, 1, 0)."""
        line = json.dumps({"id": "x", "source": "nowhere", "kind": "test", "a": a or ball(1), "b": b or ball(2, 2, 1, 0), "claim": claim})
        code, out, err = self.run_cli("certify", "--claims", "-", "--json", stdin=line + "\n")
        result = json.loads(out)
        VALIDATOR.validate(result)
        self.assertEqual((code, err), (1 if result["verdict"] == "wrong" else 0, ""))
        return [result["verdict"], *(statement["finding"] for statement in result["statements"])]

    def test_status(self):
        for status in ("penetrating", "touching", "disjoint"):
            self.assertEqual(self.judged({"status": status}), ["right" if status == "penetrating" else "wrong"] * 2)
        self.assertEqual(self.judged({"status": "near"}), ["not-judgeable"])
        self.assertEqual(self.judged({"text": "a wrong depth"}), ["not-judgeable"])

    def test_a_tolerance_is_absolute(self):
        for depth, tolerance, verdict in ((0.7639, 1e-4, "right"), (0.7639, 1e-6, "wrong"), (0.8, 0.037, "right"), (0.8, 0.036, "wrong"),
                                          (0.7639320225002103, 1e-16, "right"), (0.7639320225002103, 1e-18, "wrong")):
            self.assertEqual(self.judged({"depth": depth, "tol": tolerance}), [verdict] * 2, (depth, tolerance))

    def test_without_a_tolerance_the_digits_count(self):
        for depth, verdict in ((0.764, "right"), (0.7639, "right"), (0.763, "wrong"), (0.76, "right"), (1, "right"), (0.765, "wrong"),
                               (7.6e-1, "right")):
            self.assertEqual(self.judged({"depth": depth}), [verdict] * 2, depth)

    def test_distance_and_bound(self):
        apart = {"a": ball(1), "b": ball(1, 3, 4)}
        self.assertEqual(self.judged({"distance": 3, "tol": 0}, **apart), ["right"] * 2)
        self.assertEqual(self.judged({"status": "disjoint", "distance": 3.1, "tol": 1e-3}, **apart), ["wrong", "right", "wrong"])
        self.assertEqual(self.judged({"depth": 0, "tol": 0}, **apart), ["right"] * 2)
        self.assertEqual(self.judged({"depth_below": 1e-4}, **apart), ["right"] * 2)
        self.assertEqual(self.judged({"depth_below": 0.763}), ["wrong"] * 2)

    def test_a_direction_is_a_line_and_has_a_price(self):
        unit = [2 / 5 ** 0.5, 1 / 5 ** 0.5, 0]
        for direction, verdict in (([2, 1, 0], "right"), ([-2, -1, 0], "right"), (unit, "right"), ([-x for x in unit], "right"),
                                   ("x", "wrong"), ([2, 1, 1e-7], "wrong"), ("axis", "wrong")):
            self.assertEqual(self.judged({"direction": direction}), [verdict] * 2, direction)
        self.assertEqual(self.judged({"direction": [2, 1, 1e-7], "tol": 1e-6}), ["right"] * 2)
        boxes = {"a": {"shape": "box", "half": [1, 1, 1]}, "b": {"shape": "box", "half": [1, 1, 1], "pose": ball(1, 1)["pose"]}}
        for direction, verdict in (("x", "right"), ("-x", "right"), ("+-x", "right"), ("y", "wrong"), ("axis", "right")):
            self.assertEqual(self.judged({"direction": direction}, **boxes), [verdict] * 2, direction)

    def test_a_direction_whose_price_is_the_depth_with_too_many_digits(self):
        """9.9 in binary64 has 47 decimals."""
        cone = {"shape": "cone", "radius": 5, "half_length": 5}
        above = {**cone, "pose": {"quaternion": [1, 0, 0, 0], "translation": [0, 0, 9.9]}}
        self.assertEqual(self.judged({"direction": "z"}, cone, above), ["right"] * 2)

    def test_bad_lines(self):
        for line, words in (("{", "expected JSON"), ('{"a": {"shape": "sphere"}, "b": {}}', "a field"),
                            (json.dumps({"a": ball(1), "b": ball(1)}), "expected a field 'claim'"),
                            (json.dumps({"a": ball(1), "b": ball(1), "claim": 3}), "claim: expected an object"),
                            (json.dumps({"a": ball(1), "b": ball(1), "claim": {"depth": "x"}}), "claim.depth: expected a number"),
                            (json.dumps({"a": ball(1), "b": ball(1), "claim": {"direction": "up"}}), "claim.direction: expected")):
            code, _, err = self.run_cli("certify", "--claims", "-", stdin=line + "\n")
            self.assertEqual(code, 2)
            self.assertIn(words, err)
        self.assertIn("found nothing", self.refused("certify", "--claims", "-"))
        self.assertIn("takes no subject", self.refused("certify", "--claims", FILE, "--subject", "x"))

    def test_what_was_published(self):
        """The page beside the claims is what the program says of them."""
        code, out, err = self.run_cli("certify", "--claims", FILE, "--json")
        self.assertEqual((code, err), (1, ""))
        verdicts = {}
        for line in out.splitlines():
            result = json.loads(line)
            VALIDATOR.validate(result)
            verdicts[result["id"]] = result["verdict"]
        self.assertEqual(list(verdicts), [json.loads(line)["id"] for line in FILE.read_text().splitlines()])
        page = (FILE.parent / "RESULTS.md").read_text()
        for identity, verdict in verdicts.items():
            self.assertRegex(page, rf"(?m)^\| {identity} \|.*\| {verdict} \|")
        # FCL and Coal assert different normals for the same two cones: one of them is wrong.
        self.assertEqual((verdicts["fcl-cone-cone-9.9"], verdicts["coal-cylinder-cone-9.9"]), ("wrong", "right"))


if __name__ == "__main__":
    unittest.main()
