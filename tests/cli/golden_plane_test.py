# SPDX-License-Identifier: GPL-3.0-or-later
"""`fathom golden` on bodies of the plane: level F0 is the same bytes on any number of threads, is proved, computed again, and refused where it
is forged."""
import json
import unittest

from golden_release import RECORDS, GoldenTest, LevelTests


class Plane(LevelTests, GoldenTest):
    LEVEL = "F0"

    def test_whole_and_proved(self):
        records = self.records_of_whole()
        self.assertGreater(records, 200)
        out = self.answer("golden", "verify", "--method", "exact", "--method", "naive", self.release)
        self.assertRegex(out, f"^s VERIFIED F0 version=[0-9.]+ seed=1 shards={len(self.shards)} records={records} agreed=exact,naive ")

    def test_schemas(self):
        record, good = self.validated()
        for other in ({"dimension": 3}, {"a": {"vertices": [["0", "0", "0"]]}}, {"expected": {**good["expected"], "direction": ["1", "0", "0"]}}):
            self.assertFalse(record.is_valid({**good, **other}), other)

    def test_records_are_cases(self):
        """Answered again by a command that knows nothing of golden data."""
        lines = [json.loads(line) for line in self.all_lines()]
        stream = b"".join(self.all_lines()).decode()
        results = [json.loads(line) for line in self.answer("depth", "--json", "-", stdin=stream).splitlines()]
        self.assertEqual(len(lines), len(results))
        for line, result in zip(lines, results):
            expected = line["expected"]
            self.assertEqual((line["id"], expected["status"], 2), (result["id"], result["status"], result["dimension"]))
            self.assertEqual([expected["signed_depth"]["exact"][part] for part in ("root", "plus")],
                             [result["signed_depth"]["exact"][part] for part in ("root", "plus")], line["id"])
            if expected["status"] == "penetrating" and "optimal_cone" not in expected:
                self.assertEqual([t["normal"] for t in expected["translations"]], [o["direction"] for o in result["optima"]], line["id"])
                self.assertEqual([t["contact"] for t in expected["translations"]], [o["contact"] for o in result["optima"]], line["id"])

    def test_forged(self):
        number = next(i for i, line in enumerate(self.lines()) if json.loads(line)["expected"]["status"] == "penetrating")

        def nothing(record, proof):
            return proof

        def status(record, proof):
            record["expected"]["status"] = "touching"
            return proof

        def contact(record, proof):
            record["expected"]["translations"][0]["contact"]["a"] = [0]
            return proof

        def space(record, proof):
            record["dimension"] = 3
            return proof

        self.assertIn("s VERIFIED", self.answer("golden", "verify", self.forged(number, nothing)))
        for change, reason in ((status, "expected.status"), (contact, "expected.translations.0.contact"), (space, "dimension")):
            folder = self.forged(number, change)
            code, out, err = self.run_cli("golden", "verify", folder)
            self.assertEqual((code, err), (1, ""), (change.__name__, out))
            self.assertRegex(out, f"^s REFUSED {self.shards[0]}{RECORDS}:{number + 1}: .*{reason}", change.__name__)


if __name__ == "__main__":
    unittest.main()
