# SPDX-License-Identifier: GPL-3.0-or-later
"""`fathom certify --claims`: what was published, against the truth."""
import collections
import json
import unittest

import jsonschema  # Debian: python3-jsonschema
from harness import ROOT, CliTest

FOLDER = ROOT / "verify" / "claims"
FILES = {FOLDER / "claims.jsonl": {"right": 89, "wrong": 7, "not-judgeable": 4}, FOLDER / "reports.jsonl": {"right": 33, "wrong": 9}}
SCHEMAS = {f"{name}.schema.json": json.loads(next(ROOT.glob(f"*/*/{name}.schema.json")).read_text()) for name in ("claim", "result")}
VALIDATOR = jsonschema.Draft202012Validator(
    SCHEMAS["claim.schema.json"],
    resolver=jsonschema.RefResolver("claim.schema.json", SCHEMAS["claim.schema.json"], store=SCHEMAS))


def ball(radius, x=0, y=0, z=0):
    return {"shape": "sphere", "radius": radius, "pose": {"quaternion": [1, 0, 0, 0], "translation": [x, y, z]}}


def line_of(claim, a=None, b=None):
    """Without bodies: two balls, 3 - sqrt(5) = 0.76393202 deep along (2, 1, 0). The claim may be text, to say how it is written."""
    line = json.dumps({"id": "x", "source": "nowhere", "kind": "test", "a": a or ball(1), "b": b or ball(2, 2, 1, 0), "claim": "?"})
    return line.replace('"?"', claim if isinstance(claim, str) else json.dumps(claim)) + "\n"


class Claims(CliTest):
    def result_of(self, claim, a=None, b=None):
        code, out, err = self.run_cli("certify", "--claims", "-", "--json", stdin=line_of(claim, a, b))
        result = json.loads(out)
        VALIDATOR.validate(result)
        self.assertEqual((code, err), (1 if result["verdict"] == "wrong" else 0, ""))
        return result

    def judged(self, claim, a=None, b=None):
        """The verdict on the claim, and on each statement."""
        result = self.result_of(claim, a, b)
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

    def test_digits_are_those_that_were_written(self):
        for number, verdict in (("0.7600", "wrong"), ("0.76", "right"), ("76e-2", "right"), ("760E-3", "wrong"), ("7.639e-1", "right"),
                                ("0.763932022500210303590826", "right"), ("0.763932022500210303590827", "wrong"), ("1", "right"),
                                ("1.0", "wrong"), ("1e0", "right")):
            result = self.result_of(f'{{"depth": {number}}}')
            self.assertEqual([result["statements"][0][field] for field in ("text", "finding")], ["depth " + number, verdict])
        apart = {"a": ball(1), "b": ball(1, 3, 4)}
        texts = [statement["text"] for statement in self.result_of(
            '{"distance": 3.00, "depth_below": 1.0E-4, "direction": [3.0, 4.000, -1.03648825], "direction/0": 7.5}', **apart)["statements"]]
        self.assertEqual(texts, ["distance 3.00", "depth below 1.0E-4", "direction [3.0,4.000,-1.03648825]"])

    def test_blank_lines_are_passed_over(self):
        bad = '{"claim": 1}\n'
        code, out, err = self.run_cli("certify", "--claims", "-", stdin="\n \r\n" + line_of({"depth": 0.76}) + "\t\n\n" + bad + "\n")
        self.assertEqual((code, out.splitlines()[-1]), (2, "1 claims: 1 right, 0 wrong, 0 undecided, 0 not judgeable"))
        self.assertTrue(err.startswith("fathom: <stdin>:6: "), err)
        for blank in ("", "\n", " \n\r\n\n"):
            self.assertEqual(self.refused("certify", "--claims", "-", stdin=blank),
                             "fathom: <stdin>:1: expected at least one claim, found an empty input\n")
        path = self.file("blank.jsonl", "\n\n")
        self.assertIn(f"{path}:1: expected at least one claim", self.refused("certify", "--claims", path))

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

    def test_a_direction_beside_a_half_space(self):
        """Along a line at an angle to its normal the way is longer; within what rounding explains it is none."""
        half = {"shape": "halfspace", "normal": [1, 2, 3], "offset": 0}
        unit = [x / 14 ** 0.5 for x in (1, 2, 3)]
        for body in (ball(1), ball(1, 1, 1, 1), ball(1, -7, 0, 1)):  # they overlap, are apart, and lie deep inside
            for claim, verdict in (([1, 2, 3], "right"), ([-1, -2, -3], "right"), (unit, "right"), ([1, 2, 3.001], "wrong"), ("z", "wrong"),
                                   ([2, -1, 0], "wrong"), ("axis", "wrong")):
                self.assertEqual(self.judged({"direction": claim}, body, half), [verdict] * 2, (body, claim))
                self.assertEqual(self.judged({"direction": claim}, half, body), [verdict] * 2, (body, claim))
        floor = {"shape": "halfspace", "normal": [0, 0, 1], "offset": 0}
        for x, tolerance, verdict in ((3, 0.1249, "wrong"), (3, 0.1251, "right"), (0, 0, "right")):  # 1/2 deep: 5/8 along (3, 0, 4)
            self.assertEqual(self.judged({"direction": [x, 0, 4], "tol": tolerance}, ball(1, 0, 0, 0.5), floor), [verdict] * 2)
        result = self.result_of({"depth": 0.5, "direction": [3, 0, 4]}, ball(1, 0, 0, 0.5), floor)
        self.assertEqual([statement["truth"] for statement in result["statements"]],
                         ["the depth is 0.5", "the way along it is 0.625, 0.125 more than the least"])
        self.assertEqual(self.judged({"direction": "z"}, ball(1, 0, 0, 1), floor), ["right"] * 2, "they touch")
        self.assertEqual(self.judged({"direction": [0, 1e-3, 1]}, ball(1, 0, 0, 1), floor), ["wrong"] * 2)

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
                            (line_of({"direction": "up"}), "claim.direction: expected"),
                            (line_of({"direction": [0, 0, 0]}), "found [0,0,0]"), (line_of({"direction": [1, "2", 3]}), "found [1,"),
                            (line_of({"direction": "u\n" * 5000}), "or 'axis', found u\\x0au\\x0a"),
                            (line_of({"direction": ["u\n" * 5000, 1, 2]}), "or 'axis', found ["),
                            (line_of('{"depth": 1e-999999999}'), "claim.depth: "),
                            (line_of({"depth": 1}, {"pieces": [{"shape": "box", "half": [1, 1, 1]}]}), "found a union of pieces"),
                            (line_of({"depth": 1}, *2 * [{"shape": "halfspace", "normal": [0, 0, 1], "offset": 0}]), "found two")):
            code, out, err = self.run_cli("certify", "--claims", "-", stdin="\n" + line.strip("\n") + "\n" + line_of({"depth": 0.76}))
            self.assertEqual((code, out.splitlines()[-1]), (2, "1 claims: 1 right, 0 wrong, 0 undecided, 0 not judgeable"))
            self.assertTrue(err.startswith("fathom: <stdin>:2: ") and err.count("\n") == 1 and len(err) < 200, err)
            self.assertIn(words, err)
        self.assertIn("takes no subject", self.refused("certify", "--claims", *FILES, "--subject", "x"))

    def test_what_was_published(self):
        """The page beside the claims is what the program says of them."""
        page = (FOLDER / "RESULTS.md").read_text()
        verdicts = {}
        for path, counts in FILES.items():
            code, out, err = self.run_cli("certify", "--claims", path, "--json")
            self.assertEqual((code, err), (1, ""))
            found = {}
            for line in out.splitlines():
                result = json.loads(line)
                VALIDATOR.validate(result)
                found[result["id"]] = result["verdict"]
                for statement in result["statements"]:
                    if statement["finding"] == result["verdict"]:
                        self.assertTrue(statement["text"] in page and statement["truth"] in page, result["id"])
            self.assertEqual(list(found), [json.loads(line)["id"] for line in path.read_text().splitlines()])
            self.assertEqual(collections.Counter(found.values()), counts)
            verdicts.update(found)
        for identity, verdict in verdicts.items():
            self.assertRegex(page, rf"(?m)^\| {identity} \|.*\| {verdict} \|")
        self.assertEqual(len(verdicts), 142)
        # FCL and Coal assert different normals for the same two cones: one of them is wrong.
        self.assertEqual((verdicts["fcl-cone-cone-9.9"], verdicts["coal-cylinder-cone-9.9"]), ("wrong", "right"))

    def test_each_report_says_what_it_shows(self):
        for line in (FOLDER / "reports.jsonl").read_text().splitlines():
            claim = json.loads(line)
            self.assertRegex(claim["shows"], r"^[a-z].{9,98}[^.]$", claim["id"])
            self.assertRegex(claim["source"], r"#[0-9]+|@[0-9a-f]{7}|test", claim["id"])


if __name__ == "__main__":
    unittest.main()
