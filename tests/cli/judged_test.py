# SPDX-License-Identifier: GPL-3.0-or-later
"""The rows of tests/data/judged.jsonl by `fathom certify --replay`: findings and fields are those of tests/doors/judged_test.cpp."""
import collections
import json
import unittest

from harness import DATA, CliTest

USUAL = {"touching": "either", "depth": "positive", "moves": "a", "unit": True}
SHAPES = ["sphere", "capsule", "cylinder", "halfspace", "pieces"]


class Rows(CliTest):
    def test_every_row(self):
        groups, pairs = collections.defaultdict(list), {}
        for line in (DATA / "judged.jsonl").read_text().splitlines():
            row = json.loads(line)
            if "pair" in row:
                pairs[row["pair"]] = row
            else:
                groups[json.dumps([row.get("declared", {}), row.get("by", {})])].append(row)
        for settings, rows in groups.items():
            with self.subTest(settings):
                self.check_group(*json.loads(settings), rows, pairs)

    def check_group(self, declared, by, rows, pairs):
        points = declared.get("precision", "binary64")
        hello = {"type": "hello", "protocol": "fathom/subject/1", "name": "rows", "version": "1",
                 "precision": {"points": points, "answers": declared.get("answers", points)},
                 "conventions": {**USUAL, **{name: declared[name] for name in (*USUAL, "claims") if name in declared}},
                 "capabilities": {"shapes": SHAPES}, **{name: declared[name] for name in ("manifold",) if name in declared}}
        replies = [hello, *({"type": "reply", "id": str(i), **row["reply"]} for i, row in enumerate(rows))]
        cases = [{"id": str(i), "a": pairs[row["of"]]["a"], "b": pairs[row["of"]]["b"]} for i, row in enumerate(rows)]
        options = {"relative": "--tol-rel", "absolute": "--tol-abs", "ulps": "--tol-ulps", "policy": "--policy"}
        words = [word for name, value in by.items() for word in (options[name], str(value))]
        lines = lambda name, objects: self.file(name, "".join(json.dumps(each) + "\n" for each in objects))
        code, out, err = self.run_cli("certify", "--json", "--replay", lines("replies", replies), *words, lines("cases.jsonl", cases))
        self.assertEqual(code, 1 if any(row["found"] for row in rows) else 0, err)
        judged = {each["id"]: each["judgement"] for each in map(json.loads, out.splitlines()) if each["type"] == "case"}
        self.assertEqual(len(judged), len(rows))
        for i, row in enumerate(rows):
            found = judged[str(i)]
            self.assertEqual(found["findings"], row["found"], row)
            for name, value in row.get("told", {}).items():
                self.assertEqual(found.get(name), value, (name, row))


if __name__ == "__main__":
    unittest.main()
