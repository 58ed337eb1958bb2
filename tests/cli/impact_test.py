#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""`fathom impact`: what it writes is accepted by all three checkers, and says what it prints; streams; poses beside cases."""
import json
import os
import random
import subprocess
import sys
import unittest
from fractions import Fraction

from harness import PATIENCE, ROOT, UNIT, CliTest

CHECKERS = [[os.environ["FATHOM_CHECK"]], [os.environ["FATHOM_CHECK_PROVED"]], [sys.executable, "-B", str(ROOT / "verify" / "check" / "check.py")]]


def turn(source, shorter_than=9):
    """A quaternion of integers that is not 0."""
    q = [source.randint(-shorter_than, shorter_than) for _ in range(4)]
    return q if any(q) else turn(source, shorter_than)


def motion(source, near):
    first = [source.randint(-8, 8) + 8 * near for _ in range(3)]
    last = [source.randint(-2, 2) - c // 2 for c in first]
    return {"from": {"quaternion": turn(source), "translation": first}, "to": {"quaternion": turn(source), "translation": last}}


def cases(count, seed=6):
    """Bodies of any rank, up to 9 points; a third with both moving; opposite quaternions among them are refused."""
    source = random.Random(seed)
    for i in range(count):
        body = lambda: [[source.randint(-8, 8) / 4 for _ in range(3)] for _ in range(source.randint(1, 9))]
        moves = {"a": motion(source, 1)}
        if i % 3 == 0:
            moves["b"] = motion(source, -1)
        yield {"schema": "fathom/case/1", "id": f"m{i}", "a": {"vertices": body()}, "b": {"vertices": body()}, "motion": moves}


class ImpactTest(CliTest):
    def verdicts(self, checker, texts):
        done = subprocess.run([*checker, "-"], input="".join(texts).encode(), stdout=subprocess.PIPE, timeout=PATIENCE)
        return done.stdout.decode().splitlines()

    def test_all_checkers_accept_what_is_written(self):
        self.accepted(40, 240, 60)

    def test_on_coarse_grids_too(self):
        for bits in (1, 2):
            self.accepted(bits, 60, 3)

    def accepted(self, bits, count, contacts):
        stream = "".join(json.dumps(case) + "\n" for case in cases(count))
        folder = self.folder / f"proofs_{bits}"
        out = self.answer("impact", "--json", "--bits", bits, "--certificate", folder, "-", stdin=stream)
        results = [json.loads(line) for line in out.splitlines()]
        texts = [(folder / f"{each['id']}.cert").read_text() for each in results]
        expected = []
        for each in results:
            first, pieces = each["first_contact"], each["pieces"]
            if each["status"] == "apart":
                expected.append(f"s VERIFIED apart until=1 {each['id']}")
            elif first:
                expected.append(f"s VERIFIED contact until={first['t0']['exact']} at={first['t1']['exact']} {each['id']}")
                self.assertEqual(Fraction(first["t1"]["exact"]) - Fraction(first["t0"]["exact"]), Fraction(1, 2**bits))
            else:
                expected.append(None)
            self.assertTrue(pieces or each["beginning"])
        statuses = {each["status"] for each in results}
        self.assertLessEqual({"apart", "contact"}, statuses)
        self.assertGreater(sum(each["status"] == "contact" for each in results), contacts)
        for checker in CHECKERS:
            lines = self.verdicts(checker, texts)
            self.assertEqual(len(lines), len(texts))
            for line, wanted in zip(lines, expected):
                self.assertTrue(line.startswith("s VERIFIED "), line)
                if wanted and " near=" not in line:
                    self.assertEqual(line, wanted)

    def test_a_case_alone_is_as_in_a_stream(self):
        stream = list(cases(4))
        path = self.file("moves.jsonl", "".join(json.dumps(case) + "\n" for case in stream))
        all_of_it = self.answer("impact", "--json", path).splitlines()
        for case, line in zip(stream, all_of_it):
            self.assertEqual(self.answer("impact", "--json", path, "--case", case["id"]).strip(), line)
        alone = self.file("one.json", json.dumps(stream[0]))
        self.assertEqual(self.answer("impact", "--json", alone).strip(), all_of_it[0])
        self.assertEqual(self.answer("impact", "--json", "--threads", "3", path).splitlines(), all_of_it)

    def test_options_say_what_fields_say(self):
        box = self.file("box.xyz", UNIT)
        poses = {"from": "xyz=4,0,0 quat=1,0,0,0", "to": "xyz=0,0,0 quat=-1,0,-1/2,0"}
        by_options = self.result("impact", box, box, "--b-from", poses["from"], "--b-to", poses["to"])
        case = {"id": by_options["id"], "a": {"vertices": UNIT}, "b": {"vertices": UNIT}, "motion": {"b": poses}}
        self.assertEqual(self.result("impact", "-", stdin=json.dumps(case)), by_options)
        self.assertEqual(by_options["motion"]["b"]["q1"], ["1", "0", "1/2", "0"])  # the shorter way


if __name__ == "__main__":
    unittest.main()
