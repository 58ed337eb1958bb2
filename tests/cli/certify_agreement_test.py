# SPDX-License-Identifier: GPL-3.0-or-later
"""fathom certify: the schemas and the program accept the same lines of subjects, and say why they refuse others."""
import json
import unittest

from certify_harness import CertifyTest, boxes
from certify_schemas import SUBJECT, validator


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
                        {"more": None}, {"direction": [1, "0", "nan"]}, {"direction": [1]}, {"direction": [1, 2, 3, 4]},
                        {"direction": [1, 2, None]}, {"direction": None}, {"direction": []}, {"direction": "1,2,3"}, {"witness": None}, {"witness": {}},
                        {"witness": {"a": None}}, {"witness": {"a": [1, 2, 3]}}, {"witness": {"a": [1, 2, 3], "b": "x"}}, {"witness": [1]},
                        {"hull": {}}, {"hull": {"a": [[1, 2, 3]]}}, {"hull": {"a": [["0x1p3", "2", .5], [1, 2, 3]], "b": [[0, 0, 0]]}},
                        {"hull": {"a": []}}, {"hull": {"b": [[1]]}}, {"hull": {"a": [[1, 2, "nan"]]}}, {"hull": {"b": [[1, 2, None]]}},
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
        for plane in ({"direction": [1, 2]}, {"hull": {"b": [[1, 2]]}}):  # one line does not say of what the subject is
            self.assertFalse(self.takes(json.dumps({**self.REPLY, **plane})))
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


if __name__ == "__main__":
    unittest.main()
