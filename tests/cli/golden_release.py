# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of `fathom golden` share: a release made once, comparing folders, and forging one with all its sums made right."""
import hashlib
import json
import pathlib
import subprocess
import tempfile

from harness import DATA, EXECUTABLE, CliTest

COMMITTED = DATA / "golden"
ENDS = (".jsonl.zst", ".cert.zst", ".csv.zst")


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
