# SPDX-License-Identifier: GPL-3.0-or-later
"""fathom certify: the schemas and the program accept the same lines of subjects, and say why they refuse others."""
import json
import unittest

from certify_harness import CertifyTest, boxes, liar
from certify_schemas import SUBJECT, VERDICT, validator


class Agreement(CertifyTest):
    """The program takes just what the schema allows."""

    HELLO = {"type": "hello", "protocol": "fathom/subject/1", "name": "mine", "version": "1", "precision": "binary64",
             "conventions": {"touching": "either", "depth": "positive", "moves": "a", "unit": True}}
    REPLY = {"type": "reply", "id": "7", "overlap": True}

    def takes(self, *lines):
        another = json.dumps({**self.REPLY, "id": "8"})  # so that a case is judged
        replies = self.file("replies.jsonl", "".join(line + "\n" for line in (*lines, another)))
        code, _, err = self.certify("--replay", replies, "-", stdin=boxes(0).replace("box::0", "7") + boxes(1).replace("box::1", "8"))
        self.assertIn(code, (0, 1, 2, 4), err)  # 2: the hello; 4: a case has no reply
        return code < 2

    def check(self, part, message):
        line = json.dumps(message)
        with self.subTest(line):
            self.assertEqual(self.takes(line), validator(SUBJECT, (part,)).is_valid(message))

    def test_numbers(self):
        for number in (1, -1.5, 0, 1e300, "1", "+1", "-1.5", "1.", ".5", ".", "", "-", "1e5", "1e", "1e+", "1E-5", "1/1", "4/2", "0x1.8p3",
                       "0x", "0x.", "0x.8", "0xp1", "0X1P+1", "1p3", "nan", "-NaN", "nan(0x1)", "nan()", "nan(", "nan(-)", "nanx", "nano",
                       "inf", "+INF", "infinity", "infinit", "--1", "1 ", " 1", "1,5", "one", "0b1", "1_0", "true", True, None, [], [1], {},
                       {"": 1}):
            self.check("reply", {**self.REPLY, "depth": number})

    def test_replies(self):
        for changes in ({"overlap": False}, {"overlap": "true"}, {"overlap": 1}, {"overlap": None}, {"overlap": "1/1"}, {"id": 7},
                        {"id": 7.0}, {"id": 7.5}, {"id": None}, {"id": True}, {"id": ["7"]}, {"type": "Reply"}, {"type": None},
                        {"more": None}, {"direction": [1, "0", "nan"]}, {"direction": [1, 2]}, {"direction": [1, 2, None]},
                        {"direction": None}, {"direction": []}, {"direction": "1,2,3"}, {"witness": None}, {"witness": {}},
                        {"witness": {"a": None}}, {"witness": {"a": [1, 2, 3]}}, {"witness": {"a": [1, 2, 3], "b": "x"}}, {"witness": [1]},
                        {"hull": {}}, {"hull": {"a": [[1, 2, 3]]}}, {"hull": {"a": [["0x1p3", "2", .5], [1, 2, 3]], "b": [[0, 0, 0]]}},
                        {"hull": {"a": []}}, {"hull": {"b": [[1, 2]]}}, {"hull": {"a": [[1, 2, "nan"]]}}, {"hull": {"b": [[1, 2, None]]}},
                        {"hull": {"a": [[1, "inf", 3]]}}, {"hull": None}, {"hull": []}, {"hull": {"a": None}}, {"hull": {"a": 7}},
                        {"hull": {"a": ["123"]}}, {"hull": {"b": [7]}}, {"microseconds": 3.5}, {"microseconds": "soon"},
                        {"microseconds": None}, {"microseconds": -1}, {"distance": "inf"}, {"distance": None}, {"contacts": None},
                        {"contacts": []}, {"contacts": {}},
                        {"contacts": [{"position": [1, 2, "nan"], "depth": "inf"}, {"position": [1, 2, 3]}]},
                        {"contacts": [{"position": [1]}]}, {"contacts": [{}]}, {"contacts": [[1, 2, 3]]},
                        {"contacts": [{"position": [1, 2, 3], "depth": None}]}, {"contacts": [{"position": [1, 2, 3], "more": 1}]},
                        {"unsupported": "x"}, {"failed": "x"}, {"unsupported": None}, {"failed": 7}):
            self.check("reply", {**self.REPLY, **changes})
            self.check("reply", {**self.REPLY, "overlap": False, **changes})
        nothing = {"type": "reply", "id": "7"}
        self.check("reply", nothing)
        for name in ("unsupported", "failed"):
            for value in ("x", "", 7, None, True, ["x"]):
                self.check("reply", {**nothing, name: value})
            for other in ({"depth": 1}, {"direction": [1, 0, 0]}, {"witness": {}}, {"hull": {}}, {"distance": 1},
                          {"contacts": [{"position": [1, 0, 0]}]}, {"unsupported": "y"}, {"failed": "y"}, {"more": 1}):
                self.check("reply", {**nothing, name: "x", **other})

    def test_hellos(self):
        good = json.dumps(self.REPLY)
        for changes in ({}, {"name": ""}, {"name": 7}, {"name": None}, {"version": 2.1}, {"version": ""}, {"version": None},
                        {"library": "fcl"}, {"library": None}, {"library": 1}, {"precision": "binary16"}, {"precision": 64},
                        {"settings": None}, {"settings": []}, {"settings": {"a": [1, None]}}, {"capabilities": None}, {"capabilities": {}},
                        {"capabilities": {"faces": 1}}, {"capabilities": {"faces": None}}, {"conventions": None}, {"conventions": {}},
                        {"promises": []}, {"promises": ["depth", "direction", "witness"]}, {"promises": ["distance", "contacts"]},
                        {"promises": ["depth", "depth"]}, {"promises": ["overlap"]}, {"promises": "depth"}, {"promises": None},
                        {"promises": [1]}, {"precision": {"points": "binary32", "answers": "binary64"}},
                        {"precision": {"points": "binary32"}}, {"precision": {}}, {"precision": {"points": "binary32", "answers": 64}},
                        {"rounding": 0.5}, {"rounding": 0}, {"rounding": -1}, {"rounding": "0.5"},
                        {"rounding": None}, {"rounding": {}}, {"rounding": {"vertices": 0.5, "box": 0}}, {"rounding": {"margin": 1}},
                        {"rounding": {"box": -1}}, {"rounding": {"rounded_box": 1}}, {"rounding": [1]}, {"protocol": 1}, {"more": None}):
            hello = {**self.HELLO, **changes}
            with self.subTest(changes):
                self.assertEqual(self.takes(json.dumps(hello), good), validator(SUBJECT, ("hello",)).is_valid(hello))
        for name, value in (("touching", "maybe"), ("depth", None), ("moves", "A"), ("unit", "true"), ("unit", 1), ("unit", None),
                            ("claims", "separating"), ("claims", "minimum"), ("claims", "manifold"), ("claims", None)):
            hello = {**self.HELLO, "conventions": {**self.HELLO["conventions"], name: value}}
            with self.subTest(hello["conventions"]):
                self.assertEqual(self.takes(json.dumps(hello), good), validator(SUBJECT, ("hello",)).is_valid(hello))

    def test_bare_words(self):
        """What is no JSON: numbers as printf and Lua write them, and nothing else."""
        for text, taken in {"nan": True, "-inf": True, "0x1p3": True, ".5": True, "+1": True, "7.": True, "nano": False, "yes": False,
                            "True": False, "1/1": False, "'1'": False}.items():
            with self.subTest(text):
                self.assertEqual(self.takes(f'{{"type":"reply","id":"7","overlap":true,"depth":{text}}}'), taken)
        for line in ('{type:"reply","id":"7","overlap":true}', '{"type":reply,"id":"7","overlap":true}',
                     '{"type":"reply","id":"7","overlap":"true"}'):
            self.assertFalse(self.takes(line), line)
        self.assertTrue(self.takes('{"type":"reply","id":7.0,"overlap":true}'))

    def test_distances(self):
        """Of the boxes, which are 0.5 apart."""
        hello = json.dumps({**self.HELLO, "promises": ["distance"]})
        bodies = {"id": "7", "a": {"vertices": [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)]},
                  "b": {"vertices": [[x, y, z] for x in (1.5, 2.5) for y in (0, 1) for z in (0, 1)]}}
        for reply, verdict, says in (({"distance": 0.5}, "pass", "right: 0.5 is claimed, the distance is 0.5 (correctly rounded)"),
                                     ({"distance": 0.75}, "too-far", "too far by 0.25"),
                                     ({"distance": 0.25}, "too-near", "too near by 0.25"),
                                     ({"distance": 0.5, "direction": [1, 0, 0]}, "wrong-sign", "the direction points the wrong way"),
                                     ({"distance": 0.5, "witness": {"a": [1, 0, 0], "b": [1.5, 1, 0]}}, "witness-off",
                                      "miss the distance by"),
                                     ({}, "inconsistent", "inconsistent: the hello promises distance, and the reply has none")):
            with self.subTest(reply):
                replies = self.file("replies.jsonl", hello + "\n" + json.dumps({**self.REPLY, "overlap": False, **reply}) + "\n")
                _, lines, _ = self.certify("--replay", replies, "-", stdin=json.dumps(bodies) + "\n")
                self.assertEqual(lines[1]["verdict"], verdict)
                self.assertIn(says, lines[1]["judgement"]["sentence"])
                self.assertEqual(lines[1]["judgement"]["distance_squared"], "1/4")
                self.assertEqual(lines[2]["judged"]["distance"], 1 if "distance" in reply else 0)

    def test_claims_and_policies(self):
        """The boxes overlap by 0.5 along x, and by 1 along y, which is answered."""
        separating = {**self.HELLO, "conventions": {**self.HELLO["conventions"], "claims": "separating"}}
        reply = json.dumps({**self.REPLY, "depth": 1, "direction": [0, 1, 0]})
        for hello, policy, verdict in ((self.HELLO, None, "too-deep"), (self.HELLO, "declared", "too-deep"),
                                       (self.HELLO, "minimum", "too-deep"), (self.HELLO, "separating", "pass"), (separating, None, "pass"),
                                       (separating, "minimum", "too-deep"), (self.HELLO, "within=100%", "pass"),
                                       (separating, "within=99.999%", "too-deep")):
            with self.subTest((hello["conventions"], policy)):
                replies = self.file("replies.jsonl", json.dumps(hello) + "\n" + reply + "\n")
                more = [] if policy is None else ["--policy", policy]
                for again in ([], ["--method", "exact"]):
                    code, lines, err = self.certify("--replay", replies, "-", *more, *again, stdin=boxes(0).replace("box::0", "7"))
                    self.assertEqual((code, lines[1]["verdict"]), (0 if verdict == "pass" else 1, verdict), err)
                    for line in lines:
                        validator(VERDICT).validate(line)
                    self.assertEqual(lines[0]["policy"], {None: "declared", "within=99.999%": "within=99999/1000%"}.get(policy, policy))
                    self.assertEqual(lines[1]["judgement"]["dearer"], 1)
                    self.assertEqual(lines[1]["judgement"].get("longer", False), verdict == "pass")
                    self.assertEqual(lines[2]["dearer"], {"answers": 1, "median": 1, "worst": 1, "longer_pass": int(verdict == "pass")})
        _, table, _ = self.run_cli("certify", "--replay", replies, "-", "--policy", "separating", stdin=boxes(0).replace("box::0", "7"))
        self.assertIn("price        median 1 above the depth, worst 1, of 1 direction; 1 longer translation passes by the policy", table)
        self.assertIn("claims: separating", " ".join(table.split()))
        for policy in ("", "within=5", "within=-1%", "manifold"):
            code, _, err = self.certify("--replay", replies, "-", "--policy", policy, stdin=boxes(0))
            self.assertEqual(code, 2)
            self.assertIn("declared, minimum, separating or within=P%", err)

    def test_solid_and_metre_sized(self):
        """Of four cases: both, flat, too small, and one whose bodies touch, a unit and 101 units long."""
        def pair(name, b, scale=1):
            a = [[x * scale, y * scale, z * scale] for x in (0, 1) for y in (0, 1) for z in (0, 1)]
            return json.dumps({"id": name, "a": {"vertices": a},
                               "b": {"vertices": [[x * scale, y * scale, z * scale] for x, y, z in b]}}) + "\n"
        solid, flat = [[0.5, 0, 0], [2, 0, 0], [0.5, 1, 0], [0.5, 0, 1]], [[0.5, 0, 0], [2, 0, 0], [0.5, 1, 0]]
        cases = pair("both", solid) + pair("flat", flat) + pair("small", solid,
                                                                1 / 256) + pair("long", [[1, 0, 0], [102, 0, 0], [1, 1, 0], [1, 0, 1]])
        _, lines, _ = self.certify("--subject", liar("honest"), "-", stdin=cases)
        found = {line["id"]: (line["solid"], line["metre_sized"]) for line in lines if line["type"] == "case"}
        self.assertEqual(found, {"both": (True, True), "flat": (False, True), "small": (True, False), "long": (True, False)})
        parts = lines[-1]["parts"]
        self.assertEqual({name: part["cases"] for name, part in parts.items()}, {"solid": 3, "metre_sized": 2, "solid_and_metre_sized": 1})
        for part in parts.values():
            self.assertEqual(sum(part["verdicts"].values()), part["cases"])
            self.assertEqual(part["passed"] + part["failed"] + part["unsupported"], part["cases"])
        _, table, _ = self.run_cli("certify", "--subject", liar("honest"), "-", stdin=cases)
        rows = [line.split()[:2] for line in table.splitlines()]
        for row in (["all", "4"], ["solid", "3"], ["metre-sized", "2"], ["both", "1"]):
            self.assertIn(row, rows)

    def test_promises(self):
        hello = json.dumps({**self.HELLO, "promises": ["depth", "direction", "witness"]})
        direction, witness = {"direction": [-1, 0, 0]}, {"witness": {"a": [1, 0, 0], "b": [0.5, 0, 0]}}
        for reply, verdict, says in (({"depth": 0.5, **direction, **witness}, "pass", "right"),
                                     ({**direction, **witness}, "inconsistent",
                                      "inconsistent: the hello promises depth, and the reply has none"),
                                     ({"depht": 0.5}, "inconsistent", "inconsistent: the hello promises depth, direction, witness, and"),
                                     ({"depth": 0.5, **direction, "witness": {"a": [1, 0, 0]}}, "inconsistent",
                                      "inconsistent: the hello promises witness"),
                                     ({"depth": 0.25, **direction}, "too-shallow",
                                      "inconsistent: the hello promises witness, and the reply has none"),
                                     ({"overlap": False}, "false-separation", "said to be apart"),
                                     ({"overlap": False, "distance": 1}, "false-separation",
                                      "too far by 1: 1 is claimed, the distance is 0")):
            with self.subTest(reply):
                replies = self.file("replies.jsonl", hello + "\n" + json.dumps({**self.REPLY, **reply}) + "\n")
                _, lines, _ = self.certify("--replay", replies, "-", stdin=boxes(0).replace("box::0", "7"))
                self.assertEqual(lines[0]["subject"]["promises"], ["depth", "direction", "witness"])
                self.assertEqual(lines[1]["verdict"], verdict)
                self.assertIn(says, lines[1]["judgement"]["sentence"])
                self.assertEqual("inconsistent" in lines[1]["judgement"]["findings"], "promises" in says)
                for line in lines:
                    validator(VERDICT).validate(line)


if __name__ == "__main__":
    unittest.main()
