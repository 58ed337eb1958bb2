# SPDX-License-Identifier: GPL-3.0-or-later
"""`fathom golden` on unions: level U0 is the same bytes on any number of threads, goes on where it was stopped, is proved, computed again,
and refused where it is forged."""
import json
import shutil
import unittest

from golden_release import CERTIFICATES, RECORDS, GoldenTest, LevelTests


class Unions(LevelTests, GoldenTest):
    LEVEL = "U0"

    def test_whole_and_proved(self):
        records = self.records_of_whole()
        self.assertGreater(records, 150)
        out = self.answer("golden", "verify", "--method", "exact", "--method", "naive", self.release)
        self.assertRegex(out, f"^s VERIFIED U0 version=[0-9.]+ seed=1 shards={len(self.shards)} records={records} agreed=exact,naive ")

    def test_goes_on_where_it_was_stopped(self):
        """Shards that are whole stay as they are, one that is cut off or missing is made anew."""
        folder = self.folder / "stopped"
        shutil.copytree(self.release, folder)
        for name in ("dataset.json", "SHA256SUMS", self.shards[1] + ".json", self.shards[2] + CERTIFICATES):
            (folder / name).unlink()
        kept = (folder / (self.shards[0] + RECORDS)).stat()
        code, out, err = self.generate(folder)
        self.assertEqual((code, out), (0, f"{folder}: 2 of {len(self.shards)} shards made; the release is complete\n"), err)
        self.assertEqual((folder / (self.shards[0] + RECORDS)).stat().st_mtime_ns, kept.st_mtime_ns)
        self.same_as_release(folder)

    def test_schemas(self):
        record, good = self.validated()
        self.assertFalse(record.is_valid({**good, "expected": {**good["expected"], "status": "disjoint"}}))

    def test_records_are_cases(self):
        """Answered again by a command that knows nothing of golden data."""
        stream = b"".join(self.all_lines()).decode()
        results = [json.loads(line) for line in self.answer("depth", "--json", "-", stdin=stream).splitlines()]
        lines = [json.loads(line) for line in self.all_lines()]
        self.assertEqual(len(lines), len(results))
        for line, result in zip(lines, results):
            expected = line["expected"]
            self.assertEqual((line["id"], expected["status"]), (result["id"], result["status"]))
            self.assertEqual(expected["depth"]["squared"], result["depth"]["squared"], line["id"])
            if expected["status"] == "penetrating":
                self.assertEqual([o["translation"] for o in expected["optima"]], [o["translation"] for o in result["optima"]], line["id"])

    def test_forged(self):
        number = [json.loads(line)["id"] for line in self.lines()].index("union_catalogue-slot_exact_fit")

        def nothing(record, proof):
            return proof

        def status(record, proof):
            record["expected"]["status"] = "touching"
            return proof

        def depth(record, proof):
            record["expected"]["depth"]["squared"] = "1"
            return proof.replace("claim depth 9/16\n", "claim depth 1\n")

        def optimum(record, proof):
            record["expected"]["optima"][0]["translation"][0] = "3/4"
            return proof

        def known(record, proof):
            record["source"]["known"]["squared"] = "1"
            return proof

        self.assertIn("s VERIFIED", self.answer("golden", "verify", self.forged(number, nothing)))
        for change, reason in ((status, "expected.status"), (depth, "not accepted"), (optimum, "expected.optima.0.translation"),
                               (known, "source.known.squared")):
            folder = self.forged(number, change)
            code, out, err = self.run_cli("golden", "verify", folder)
            self.assertEqual((code, err), (1, ""), (change.__name__, out))
            self.assertRegex(out, f"^s REFUSED {self.shards[0]}{RECORDS}:{number + 1}: .*{reason}", change.__name__)

    def test_unions_are_not_exported(self):
        code, out, err = self.run_cli("golden", "export", "--format", "c", self.release)
        self.assertEqual((code, out), (2, ""))
        self.assertIn("holds unions, and a case of an export is two lists of points", err)


if __name__ == "__main__":
    unittest.main()
