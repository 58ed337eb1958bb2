# SPDX-License-Identifier: GPL-3.0-or-later
"""`fathom golden` on unions: level U0 is the same bytes on any number of threads, goes on where it was stopped, is proved, computed again, and
refused where it is forged."""
import json
import os
import shutil
import subprocess
import unittest

import jsonschema  # Debian: python3-jsonschema
from golden_release import GoldenTest, contents, packed, repair, sha256, unpacked
from harness import ROOT

RECORDS, CERTIFICATES = ".jsonl.zst", ".cert.zst"


class Unions(GoldenTest):
    LEVEL = "U0"

    def lines(self, shard=0):
        return unpacked(self.release / (self.shards[shard] + RECORDS)).splitlines(keepends=True)

    def all_lines(self):
        return [line for shard in range(len(self.shards)) for line in self.lines(shard)]

    def test_whole_and_proved(self):
        names = {"LICENSE", "NOTES.md", "SHA256SUMS", "dataset.json", "dataset.schema.json", "golden.schema.json", "shard.schema.json"}
        for shard in self.shards:
            names |= {shard + end for end in (".json", RECORDS, CERTIFICATES)}
        self.assertEqual(set(contents(self.release)), names)
        records = json.loads((self.release / "dataset.json").read_text())["records"]
        self.assertGreater(records, 150)
        out = self.answer("golden", "verify", "--method", "exact", "--method", "naive", self.release)
        self.assertRegex(out, f"^s VERIFIED U0 version=[0-9.]+ seed=1 shards={len(self.shards)} records={records} agreed=exact,naive ")

    def test_same_bytes_on_one_thread(self):
        folder = self.folder / "one"
        self.assertEqual(self.generate(folder, "--jobs", "1")[0], 0)
        self.same_as_release(folder)

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
        def validator(path):
            schema = json.loads(path.read_text())
            jsonschema.Draft202012Validator.check_schema(schema)
            return jsonschema.Draft202012Validator(schema)

        dataset, shard, record = (validator(self.release / f"{name}.schema.json") for name in ("dataset", "shard", "golden"))
        case = validator(ROOT / "schemas" / "case.schema.json")
        value = json.loads((self.release / "dataset.json").read_text())
        dataset.validate(value)
        for entry in value["shards"]:
            shard.validate(entry)
            self.assertFalse(shard.is_valid({**entry, "files": entry["files"] * 2}))
        for line in self.all_lines():
            record.validate(json.loads(line))
            case.validate(json.loads(line))
        good = json.loads(self.lines()[0])
        for field in good:
            self.assertFalse(record.is_valid({key: value for key, value in good.items() if key != field}), field)
        self.assertFalse(record.is_valid({**good, "flags": []}))
        self.assertFalse(record.is_valid({**good, "expected": {**good["expected"], "status": "disjoint"}}))

    def test_certificates_alone(self):
        """By the independent checker, and where it is built the one that was extracted from the proof."""
        stream = b"".join(unpacked(self.release / (name + CERTIFICATES)) for name in self.shards)
        expected = [json.loads(line) for line in self.all_lines()]
        checkers = [os.environ["FATHOM_CHECK"]] + [p for p in [os.environ.get("FATHOM_CHECK_PROVED")] if p and os.path.exists(p)]
        for checker in checkers:
            done = subprocess.run([checker, "-"], input=stream, capture_output=True)
            self.assertEqual(done.returncode, 0, done.stdout[-500:])
            verdicts = [line.split() for line in done.stdout.decode().splitlines()]
            self.assertEqual([(v[1], v[2], v[-1]) for v in verdicts], [("VERIFIED", r["expected"]["status"], r["id"]) for r in expected])

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

    def forged(self, number, change):
        """A release in which one record is another, and all sums, its certificate's too, are made right; `change` gets both texts."""
        folder = self.folder / "forged"
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(self.release, folder)
        name = self.shards[0]
        lines, text = self.lines(), unpacked(self.release / (name + CERTIFICATES)).decode()
        parts = ["fathom-certificate" + part for part in text.split("fathom-certificate")[1:]]
        record = json.loads(lines[number])
        parts[number] = change(record, parts[number])
        record["certificate"]["sha256"] = sha256(parts[number].encode())
        lines[number] = json.dumps(record, separators=(",", ":")).encode() + b"\n"
        (folder / (name + RECORDS)).write_bytes(packed(b"".join(lines)))
        (folder / (name + CERTIFICATES)).write_bytes(packed("".join(parts).encode()))
        repair(folder)
        return folder

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
        self.assertIn("holds unions, and exports are of polytopes", err)


if __name__ == "__main__":
    unittest.main()
