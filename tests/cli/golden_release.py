# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of `fathom golden` share: a release made once, comparing folders, and forging one with all its sums made right."""
import hashlib
import json
import os
import pathlib
import shutil
import subprocess
import tempfile

import jsonschema  # Debian: python3-jsonschema
from harness import DATA, EXECUTABLE, ROOT, CliTest

COMMITTED = DATA / "golden"
RECORDS, CERTIFICATES = ".jsonl.zst", ".cert.zst"
CONTENTS = "CONTENT_SHA256SUMS"
PAGES = {"LICENSE", "NOTES.md", "SHA256SUMS", CONTENTS, "dataset.json", "dataset.schema.json", "golden.schema.json", "shard.schema.json"}
ENDS = (RECORDS, CERTIFICATES, ".csv.zst")


def unpacked(path):
    return subprocess.run(["zstd", "-dcq", path], check=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE).stdout


def packed(content):
    return subprocess.run(["zstd", "-cq9", "--check"], check=True, stdout=subprocess.PIPE, input=content).stdout


def contents(folder):
    """Every file by its name."""
    return {path.name: path.read_bytes() for path in pathlib.Path(folder).iterdir()}


def sha256(data):
    return hashlib.sha256(data).hexdigest()


def page(value):
    return (json.dumps(value, indent=2) + "\n").encode()


def write_contents(folder, dataset):
    """The page of the sums of contents, and its own sum in dataset.json."""
    sums = {entry["name"].removesuffix(".zst"): entry["content_sha256"] for shard in dataset["shards"] for entry in shard["files"]}
    (folder / CONTENTS).write_text("".join(f"{sums[name]}  {name}\n" for name in sorted(sums)))
    before, dataset["content_sha256"] = dataset["content_sha256"], sha256((folder / CONTENTS).read_bytes())
    dataset["cite"] = dataset["cite"].replace(before, dataset["content_sha256"])


def write_sums(folder):
    lines = [f"{sha256(path.read_bytes())}  {path.name}\n" for path in sorted(folder.iterdir()) if path.name != "SHA256SUMS"]
    (folder / "SHA256SUMS").write_text("".join(lines))


def repair(folder):
    """Makes the pages, counts and sums of a folder agree with its files, as a forger would."""
    dataset = json.loads((folder / "dataset.json").read_text())
    for shard in dataset["shards"]:
        for entry in shard["files"]:
            data = (folder / entry["name"]).read_bytes()
            entry["bytes"], entry["sha256"] = len(data), sha256(data)
            try:
                content = unpacked(folder / entry["name"])
            except subprocess.CalledProcessError:
                continue
            entry["content_bytes"], entry["content_sha256"] = len(content), sha256(content)
            if entry["name"].endswith(ENDS[0]):
                shard["records"] = content.count(b"\n")
        (folder / (shard["name"] + ".json")).write_bytes(page(shard))
    dataset["records"] = sum(shard["records"] for shard in dataset["shards"])
    write_contents(folder, dataset)
    (folder / "dataset.json").write_bytes(page(dataset))
    write_sums(folder)


class GoldenTest(CliTest):
    """Has a release of level LEVEL in `self.release`, made once for each class."""

    LEVEL = "L0"

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.release = pathlib.Path(folder.name) / "release"
        subprocess.run([EXECUTABLE, "golden", "generate", "--level", cls.LEVEL, "--seed", "1", "--out", cls.release], check=True,
                       stdout=subprocess.PIPE)
        cls.shards = [shard["name"] for shard in json.loads((cls.release / "dataset.json").read_text())["shards"]]

    def generate(self, folder, *more, **options):
        return self.run_cli("golden", "generate", "--level", self.LEVEL, "--seed", "1", "--out", folder, *more, **options)

    def same_as_release(self, folder):
        ours, theirs = contents(folder), contents(self.release)
        self.assertEqual(sorted(ours), sorted(theirs))
        self.assertEqual([name for name in ours if ours[name] != theirs[name]], [])


def validator(path):
    schema = json.loads(path.read_text())
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


class LevelTests:
    """What is asked of each level whose records are no point sets; beside GoldenTest."""

    def lines(self, shard=0):
        return unpacked(self.release / (self.shards[shard] + RECORDS)).splitlines(keepends=True)

    def all_lines(self):
        return [line for shard in range(len(self.shards)) for line in self.lines(shard)]

    def records_of_whole(self):
        """How many records there are; the release has its files, and no others."""
        names = set(PAGES)
        for shard in self.shards:
            names |= {shard + end for end in (".json", RECORDS, CERTIFICATES)}
        self.assertEqual(set(contents(self.release)), names)
        records = json.loads((self.release / "dataset.json").read_text())["records"]
        return records

    def validator(self, name):
        """Of the schema of this name in the release."""
        return validator(self.release / f"{name}.schema.json")

    def validated(self):
        """(the validator of records, a good one): all pages and records obey their schemas, which have teeth."""
        dataset, shard, record = map(self.validator, ("dataset", "shard", "golden"))
        case = validator(ROOT / "reference/files/case.schema.json")
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
        if "flags" not in good:
            self.assertFalse(record.is_valid({**good, "flags": []}), "only point sets have flags")
        return record, good

    def test_same_bytes_on_one_thread(self):
        folder = self.folder / "one"
        self.assertEqual(self.generate(folder, "--jobs", "1")[0], 0)
        self.same_as_release(folder)

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
