# SPDX-License-Identifier: GPL-3.0-or-later
"""The worst cases: the files of verify/worst are what make.py writes with the answers of today; and `fathom certify --worst` puts them all
to a subject, which passes with these answers and fails with others."""
import json
import subprocess
import sys
import unittest
from fractions import Fraction

from certify_harness import CertifyTest
from harness import EXECUTABLE, ROOT
from schemas import validator

WORST = ROOT / "verify" / "worst"
HELLO = {"type": "hello", "protocol": "fathom/subject/1", "name": "replayed", "version": "1", "precision": "binary64",
         "conventions": {"touching": "either", "depth": "positive", "moves": "a", "unit": False},
         "capabilities": {"shapes": ["box", "capsule", "cylinder", "ellipsoid", "pieces", "sphere"]}}


def right(answer):
    """The reply of a subject that says what is true."""
    signed = answer["signed_depth"]["low"]
    if answer["status"] == "disjoint":
        return {"overlap": False, "distance": -signed}
    ways = answer["translations"]
    if answer["status"] == "touching" or not ways:
        return {"overlap": True, "depth": signed}
    way = ways[0]["along"] if isinstance(ways[0], dict) else ways[0]
    return {"overlap": True, "depth": signed, "direction": [float(Fraction(x)) for x in way]}


class Worst(CertifyTest):
    maxDiff = None

    def setUp(self):
        super().setUp()
        self.files = {path.stem: json.loads(path.read_text()) for path in sorted(WORST.glob("*.json"))}

    def replayed(self, reply):
        """(exit code, verdicts) of a subject with this reply to each answer."""
        replies = [{"type": "reply", "id": case["id"], **reply(case["answer"])} for case in self.files.values()]
        path = self.folder / "replies.jsonl"
        path.write_text("".join(json.dumps(line) + "\n" for line in [HELLO, *replies]))
        code, lines, err = self.certify("--worst", "--replay", str(path))
        self.assertEqual(err, "")
        return code, self.verdicts(lines)

    def test_made(self):
        done = subprocess.run([sys.executable, "-B", WORST / "make.py", "--check", "--fathom", EXECUTABLE], capture_output=True,
                              check=False)
        self.assertEqual((done.returncode, done.stderr), (0, b""), "verify/worst/make.py makes them anew")

    def test_small(self):
        self.assertGreater(len(self.files), 20)
        for name, case in self.files.items():
            self.assertEqual(list(validator("case").iter_errors(case)), [], name)
            self.assertEqual(case["id"], f"worst::{name}")
            self.assertLess((WORST / f"{name}.json").stat().st_size, 2600, name)

    def test_who_is_right_passes(self):
        passes = {case["id"]: "touching-by-convention" if case["answer"]["status"] == "touching" else "pass"
                  for case in self.files.values()}
        self.assertEqual(self.replayed(right), (0, passes))

    def test_who_lies_fails(self):
        lies = {"penetrating": "too-deep", "touching": "too-deep", "disjoint": "false-overlap"}
        code, verdicts = self.replayed(lambda answer: {"overlap": True, "depth": 1 + 2 * abs(answer["signed_depth"]["high"])})
        self.assertEqual((code, verdicts), (1, {case["id"]: lies[case["answer"]["status"]] for case in self.files.values()}))


if __name__ == "__main__":
    unittest.main()
