# SPDX-License-Identifier: GPL-3.0-or-later
"""fathom certify --method: every truth and judgement is found again. What happens if they differ: tests/harness/two_ways_test.cpp."""
import json
import unittest

from certify_harness import CertifyTest, boxes, liar
from certify_schemas import VERDICT, validator
from harness import DATA, ROOT


class TwoWays(CertifyTest):
    def test_the_same_verdicts(self):
        """Of right answers and wrong ones, whether one method finds the truth or three do."""
        stream = "".join(boxes(i, marked=i % 3 == 0) for i in range(12))
        for way in ("too-deep", "turned-direction", "nan"):
            reports = []
            for options in ([], ["--method", "exact", "--method", "naive"]):
                code, lines, err = self.certify("--subject", liar(way), *options, "-", stdin=stream)
                self.assertIn(code, (0, 1), err)
                header = lines.pop(0)
                self.assertEqual(header.get("methods"), ["exact", "naive"] if options else None)
                for line in lines:
                    line.pop("seconds", None)
                reports.append(sorted(lines, key=json.dumps))
            self.assertEqual(*reports)
            self.assertEqual(len(reports[0]), 13)

    def test_a_replay(self):
        replies = self.file("replies.jsonl", json.dumps({"type": "reply", "id": "box::1", "overlap": True, "depth": 0.499}) + "\n")
        code, lines, err = self.certify("--replay", replies, "--method", "exact", "-", stdin=boxes(1))
        self.assertEqual((code, self.verdicts(lines)), (0, {"box::1": "pass"}), err)

    def test_a_report_says_so(self):
        """A report that was judged in one way is not gone on with in two."""
        report = str(self.folder / "report.jsonl")
        cases = self.file("cases.jsonl", boxes(1) + boxes(2))
        words = ["--subject", liar("honest"), "--report", report]
        self.assertEqual(self.certify(*words, "--method", "exact", cases)[0], 0)
        lines = [json.loads(line) for line in open(report)]
        self.assertEqual(lines[0]["methods"], ["exact"])
        checker = validator(VERDICT)
        for line in lines:
            checker.validate(line)
        self.assertFalse(checker.is_valid({**lines[0], "methods": ["auto"]}))
        self.assertEqual(self.certify(*words, "--method", "exact", "--resume", cases)[0], 0)
        for options in ([], ["--method", "naive"]):
            self.assertIn("of another subject, version, setting, tolerance or policy", self.refused("certify", *words, *options, "--resume",
                                                                                                    cases))

    def test_real_cases(self):
        """No difference on the pairs from issue trackers."""
        subject = f"python3 -B '{ROOT}/verify/examples/subject.py'"
        code, lines, err = self.certify("--subject", subject, "--method", "exact", str(DATA / "real_cases.jsonl"))
        self.assertIn(code, (0, 1), err)
        self.assertEqual(len(self.verdicts(lines)), 63)


if __name__ == "__main__":
    unittest.main()
