# SPDX-License-Identifier: GPL-3.0-or-later
"""`fathom golden` on shapes: level P0 is the same bytes on any number of threads, proved, computed again, and refused where it is
forged."""
import collections
import json
import pathlib
import shutil
import unittest

from golden_release import RECORDS, GoldenTest, LevelTests, packed, repair


class Shapes(LevelTests, GoldenTest):
    LEVEL = "P0"

    def test_whole_and_proved(self):
        records = self.records_of_whole()
        self.assertGreater(records, 800)
        out = self.answer("golden", "verify", "--method", "exact", self.release)
        self.assertEqual(out,
                         f"s VERIFIED P0 version=1.3.0 seed=1 shards={len(self.shards)} records={records} agreed=exact {self.release}\n")

    def test_schemas(self):
        self.validated()

    def test_records_are_cases(self):
        """Answered again by a command that knows nothing of golden data."""
        lines = [json.loads(line) for line in self.lines(1)]
        results = [json.loads(line) for line in self.answer("depth", "--json", "-", stdin=b"".join(self.lines(1)).decode()).splitlines()]
        self.assertEqual([line["id"] for line in lines], [result["id"] for result in results])
        for line, result in zip(lines, results):
            expected, found = line["expected"], result["signed_depth"]
            if "exact" in expected["signed_depth"]:
                self.assertEqual(expected["status"], result["status"], line["id"])
            self.assertLessEqual(float.fromhex(expected["signed_depth"]["low"]), found["high"], line["id"])
            self.assertGreaterEqual(float.fromhex(expected["signed_depth"]["high"]), found["low"], line["id"])

    def test_forged(self):
        numbers = collections.defaultdict(list)
        for i, line in enumerate(self.lines()):
            value = json.loads(line)["expected"]
            numbers[value["status"], "bounds" if "bounds" in value["signed_depth"] else "exact"].append(i)
        exact, enclosed = numbers["penetrating", "exact"][0], numbers["penetrating", "bounds"][0]

        def nothing(record, proof):
            return proof

        def status(record, proof):
            record["expected"]["status"] = "disjoint"
            return proof

        def crossed(record, proof):
            low, high = record["expected"]["signed_depth"]["bounds"]
            record["expected"]["signed_depth"]["bounds"] = [high, low]
            return proof.replace(f"signed_bounds {low} {high}\n", f"signed_bounds {high} {low}\n")

        def raised(record, proof):
            low, high = record["expected"]["signed_depth"]["bounds"]
            record["expected"]["signed_depth"]["bounds"] = [high, "1000"]
            return proof.replace(f"signed_bounds {low} {high}\n", f"signed_bounds {high} 1000\n")

        def bare(record, proof):
            kept = [line for line in proof.splitlines(keepends=True) if not line.startswith("radius_")]
            self.assertNotEqual("".join(kept), proof)
            return "".join(kept)

        def known(record, proof):
            record["source"]["signed_depth"]["plus"] = "100"
            return proof

        self.assertIn("s VERIFIED", self.answer("golden", "verify", self.forged(exact, nothing)))
        for number, change, reason in ((exact, status, "expected.status"), (enclosed, status, "expected.status"),
                                       (enclosed, crossed, "not accepted"), (enclosed, raised, "not accepted"),
                                       (exact, bare, "about other bodies"), (exact, known, "source.signed_depth")):
            folder = self.forged(number, change)
            code, out, err = self.run_cli("golden", "verify", folder)
            self.assertEqual((code, err), (1, ""), (change.__name__, out))
            self.assertRegex(out, f"^s REFUSED {self.shards[0]}{RECORDS}:{number + 1}: .*{reason}", change.__name__)

    def test_sum_of_the_certificate(self):
        folder = pathlib.Path(shutil.copytree(self.release, self.folder / "copy"))
        path = folder / (self.shards[0] + RECORDS)
        lines = self.lines()
        record = json.loads(lines[0])
        record["certificate"]["sha256"] = 64 * "0"
        path.write_bytes(packed(json.dumps(record, separators=(",", ":")).encode() + b"\n" + b"".join(lines[1:])))
        repair(folder)
        code, out, _ = self.run_cli("golden", "verify", folder)
        self.assertEqual(code, 1)
        self.assertIn("certificate.sha256: expected", out)

    def test_folders_do_not_mix(self):
        code, _, err = self.run_cli("golden", "generate", "--level", "L0", "--out", self.release)
        self.assertEqual(code, 2)
        self.assertIn("which is no file of this release", err)
        code, out, err = self.generate(self.release)
        self.assertEqual((code, out), (0, f"{self.release}: 0 of {len(self.shards)} shards made; the release is complete\n"), err)


if __name__ == "__main__":
    unittest.main()
