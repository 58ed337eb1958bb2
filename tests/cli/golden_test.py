# SPDX-License-Identifier: GPL-3.0-or-later
"""`fathom golden generate`: the same bytes however it is run, and no half of anything whatever happens. The release in tests/data."""
import copy
import json
import os
import resource
import signal
import subprocess
import time
import unittest

import jsonschema  # Debian: python3-jsonschema
from golden_release import COMMITTED, CONTENTS, ENDS, PAGES, GoldenTest, contents, sha256, unpacked
from harness import EXECUTABLE, PATIENCE, ROOT


class Release(GoldenTest):
    def test_whole(self):
        names = set(PAGES)
        for shard in self.shards:
            names |= {shard + end for end in (".json", *ENDS)}
        self.assertEqual(set(contents(self.release)), names)
        done = subprocess.run(["sha256sum", "-c", "--strict", "SHA256SUMS"], cwd=self.release, capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(done.stdout.count(": OK\n"), len(names) - 1)
        self.assertEqual((self.release / "LICENSE").read_bytes(), (ROOT / "LICENSES" / "CC0-1.0.txt").read_bytes())
        code, out, err = self.run_cli("golden", "verify", self.release)
        self.assertEqual((code, err), (0, ""), out)
        records = json.loads((self.release / "dataset.json").read_text())["records"]
        self.assertEqual(out, f"s VERIFIED L0 version=1.3.0 seed=1 shards={len(self.shards)} records={records} {self.release}\n")

    def test_sums_of_contents(self):
        """They are of the decompressed files, whoever compressed these, and one sum stands for all of them."""
        unpacked_files = self.folder / "unpacked"
        unpacked_files.mkdir()
        subprocess.run(["zstd", "-dq", "--output-dir-flat", unpacked_files, *self.release.glob("*.zst")], check=True)
        done = subprocess.run(["sha256sum", "-c", "--strict", self.release / CONTENTS], cwd=unpacked_files, capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(done.stdout.count(": OK\n"), len(list(self.release.glob("*.zst"))))
        dataset = json.loads((self.release / "dataset.json").read_text())
        self.assertEqual(dataset["content_sha256"], sha256((self.release / CONTENTS).read_bytes()))
        self.assertEqual(dataset["cite"], "The fathom developers: fathom golden data L0, version 1.3.0, seed 1. CC0-1.0. Content SHA-256: "
                         + dataset["content_sha256"])

    def test_same_bytes_on_any_number_of_threads(self):
        for jobs in ("1", "3"):
            folder = self.folder / jobs
            self.assertEqual(self.generate(folder, "--jobs", jobs)[0], 0)
            self.same_as_release(folder)

    def test_in_parts(self):
        folder = self.folder / "parts"
        for part in ("2/2", "1/2"):
            code, out, err = self.generate(folder, "--shard", part)
            self.assertEqual((code, err), (0, ""))
            self.assertFalse((folder / "SHA256SUMS").exists())
        code, out, _ = self.generate(folder)
        self.assertEqual((code, out), (0, f"{folder}: 0 of {len(self.shards)} shards made; the release is complete\n"))
        self.same_as_release(folder)

    def test_another_seed_is_other_data(self):
        folder = self.folder / "other"
        self.answer("golden", "generate", "--level", "L0", "--seed", "2", "--out", folder)
        ours, theirs = contents(folder), contents(self.release)
        self.assertFalse(ours[self.shards[-1] + ENDS[0]] == theirs[self.shards[-1] + ENDS[0]])
        code, out, _ = self.run_cli("golden", "verify", folder)
        self.assertEqual(code, 0, out)
        self.assertIn("golden-L0-0000.json was made from seed 2 instead of 1", self.refused(*self.words(folder)))

    def words(self, folder):
        return "golden", "generate", "--level", "L0", "--seed", "1", "--out", folder

    def test_schemas(self):
        def validator(name):
            schema = json.loads((self.release / name).read_text())
            jsonschema.Draft202012Validator.check_schema(schema)
            return jsonschema.Draft202012Validator(schema)

        dataset, shard, record = (validator(f"{name}.schema.json") for name in ("dataset", "shard", "golden"))
        case = jsonschema.Draft202012Validator(json.loads((ROOT / "reference/files/case.schema.json").read_text()))
        value = json.loads((self.release / "dataset.json").read_text())
        dataset.validate(value)
        for name, entry in zip(self.shards, value["shards"]):
            shard.validate(entry)
            self.assertEqual(entry, json.loads((self.release / f"{name}.json").read_text()))
            for line in unpacked(self.release / (name + ENDS[0])).splitlines():
                record.validate(json.loads(line))
                case.validate(json.loads(line))
        for schema, good in ((dataset, value), (shard, value["shards"][0])):
            for field in good:
                wrong = copy.deepcopy(good)
                del wrong[field]
                self.assertFalse(schema.is_valid(wrong), field)
                wrong = copy.deepcopy(good)
                wrong[field] = None
                self.assertFalse(schema.is_valid(wrong), field)
            self.assertFalse(schema.is_valid({**good, "date": "today"}))

    def test_certificates_alone(self):
        """By the independent checker, and where it is built the one that was extracted from the proof."""
        stream = b"".join(unpacked(self.release / (name + ENDS[1])) for name in self.shards)
        records = json.loads((self.release / "dataset.json").read_text())["records"]
        checkers = [os.environ["FATHOM_CHECK"]] + [p for p in [os.environ.get("FATHOM_CHECK_PROVED")] if p and os.path.exists(p)]
        for checker in checkers:
            done = subprocess.run([checker, "-"], input=stream, capture_output=True)
            self.assertEqual(done.returncode, 0, done.stdout[-500:])
            self.assertEqual(done.stdout.count(b"s VERIFIED "), records)
            self.assertEqual(done.stdout.count(b"\n"), records)

    def test_records_are_cases(self):
        """Every record, answered again by a command that knows nothing of golden data."""
        lines = [json.loads(line) for name in self.shards for line in unpacked(self.release / (name + ENDS[0])).splitlines()]
        stream = "".join(json.dumps(line) + "\n" for line in lines)
        results = [json.loads(line) for line in self.answer("depth", "--json", "--method", "exact", "-", stdin=stream).splitlines()]
        self.assertEqual(len(lines), len(results))
        for line, result in zip(lines, results):
            expected = line["expected"]
            self.assertEqual((line["id"], expected["status"]), (result["id"], result["status"]))
            self.assertEqual(expected["depth"]["squared"], result["depth"]["squared"], line["id"])


class Committed(GoldenTest):
    def test_verified(self):
        code, out, err = self.run_cli("golden", "verify", COMMITTED)
        self.assertEqual((code, err), (0, ""), out)
        self.assertTrue(out.startswith("s VERIFIED L0 version=1.3.0 seed=1 "), out)

    def test_made_again(self):
        """The same content; and the same bytes where the same version of libzstd compressed it."""
        ours, theirs = (json.loads((folder / "dataset.json").read_text()) for folder in (self.release, COMMITTED))
        if [s["zstd"] for s in ours["shards"]] == [s["zstd"] for s in theirs["shards"]]:
            committed = contents(COMMITTED)
            del committed["agreement.json"]  # of who computed it again: golden_two_ways_test
            self.assertEqual(committed, contents(self.release))
        for dataset in (ours, theirs):
            for shard in dataset["shards"]:
                del shard["zstd"]
                for entry in shard["files"]:
                    del entry["bytes"], entry["sha256"]
        self.assertEqual(ours, theirs)
        self.assertEqual((self.release / CONTENTS).read_bytes(), (COMMITTED / CONTENTS).read_bytes())

    def test_small(self):
        self.assertLess(sum(path.stat().st_size for path in COMMITTED.iterdir()), 2_500_000)


class Accidents(GoldenTest):
    def nothing_half(self, folder):
        """Only whole shards, no hidden file, no page of a complete release."""
        names = set(contents(folder))
        for name in self.shards:
            if name + ".json" in names:
                names -= {name + end for end in (".json", *ENDS)}
        self.assertEqual(names, set())

    def completed(self, folder):
        code, _, err = self.generate(folder)
        self.assertEqual((code, err), (0, ""))
        self.same_as_release(folder)

    def stopped(self, folder, seconds, how):
        """Runs, sends the signal after that time; the exit code."""
        with subprocess.Popen([EXECUTABLE, "golden", "generate", "--level", "L0", "--seed", "1", "--out", folder, "--jobs", "1"],
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
            time.sleep(seconds)
            process.send_signal(how)
            process.communicate(timeout=PATIENCE)
            return process.returncode

    def test_killed_again_and_again(self):
        folder = self.folder / "killed"
        for i in range(12):
            self.stopped(folder, 0.03 * i, signal.SIGKILL)
        self.completed(folder)

    def test_interrupted(self):
        folder = self.folder / "interrupted"
        code = self.stopped(folder, 0.2, signal.SIGINT)
        self.assertIn(code, (0, 130))  # 0: it was faster
        if code == 130:
            self.nothing_half(folder)
        self.completed(folder)

    def test_disk_full(self):
        """A limit on the size of files stands for a full disk: the system refuses in the middle of a write."""
        folder = self.folder / "full"
        limit = (4096, 4096)
        code, out, err = self.generate(folder, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, limit))
        self.assertEqual((code, out), (3, ""))
        self.assertRegex(err, r"^fathom: cannot write .*/golden-L0-0000\.[a-z]+\.zst: File too large\n$")
        self.nothing_half(folder)
        self.completed(folder)

    def test_disk_really_full(self):
        folder = self.folder / "tmpfs"
        folder.mkdir()
        script = 'mount -t tmpfs -o size=64k none "$1" && "$2" golden generate --level L0 --seed 1 --out "$1"; echo "$?"; ls -A "$1"'
        done = subprocess.run(["unshare", "-rm", "sh", "-c", script, "sh", folder, EXECUTABLE], capture_output=True, text=True)
        if "mount:" in done.stderr or "unshare:" in done.stderr:
            self.skipTest("this system lets us mount nothing")
        self.assertEqual(done.stdout, "3\n", done.stderr)
        self.assertRegex(done.stderr, r"^fathom: cannot write .*: No space left on device\n$")

    def test_read_only_folder(self):
        folder = self.folder / "locked"
        folder.mkdir(mode=0o555)
        self.folder.chmod(0o755)

        def somebody():
            if os.getuid() == 0:
                os.setgid(65534)
                os.setuid(65534)

        try:
            subprocess.run([EXECUTABLE, "--version"], preexec_fn=somebody, check=True, capture_output=True)
        except (OSError, subprocess.SubprocessError):
            self.skipTest("not everybody may run the program")
        code, out, err = self.generate(folder, preexec_fn=somebody)
        self.assertEqual((code, out), (3, ""))
        self.assertRegex(err, r"^fathom: cannot write .*/locked/golden-L0-0000\.[a-z]+\.zst: Permission denied\n$")
        self.assertEqual(contents(folder), {})

    def test_a_name_that_is_taken(self):
        """One shard cannot be written; those before it stay, and count when the obstacle is gone."""
        folder = self.folder / "taken"
        obstacle = folder / (self.shards[-1] + ENDS[1])
        obstacle.mkdir(parents=True)
        code, _, err = self.generate(folder)
        self.assertEqual(code, 3)
        self.assertIn(f"cannot write {obstacle}: Is a directory", err)
        obstacle.rmdir()
        self.nothing_half(folder)
        code, out, _ = self.generate(folder)
        self.assertEqual((code, out), (0, f"{folder}: 1 of {len(self.shards)} shards made; the release is complete\n"))
        self.same_as_release(folder)

    def test_damage_is_mended(self):
        folder = self.folder / "damaged"
        self.completed(folder)
        for name, change in ((self.shards[0] + ENDS[2], lambda data: data[:-1]), (self.shards[-1] + ".json", lambda data: data[:9]),
                             ("NOTES.md", lambda data: b""), ("SHA256SUMS", lambda data: b"x")):
            path = folder / name
            path.write_bytes(change(path.read_bytes()))
            self.completed(folder)
        (folder / (self.shards[0] + ENDS[0])).unlink()
        (folder / ".new-dataset.json").write_text("left behind")
        self.completed(folder)

    def test_folders_of_others(self):
        folder = self.folder / "mine"
        folder.mkdir()
        (folder / "letter.txt").write_text("dear")
        code, out, err = self.generate(folder)
        self.assertEqual((code, out), (2, ""))
        self.assertIn("holds 'letter.txt', which is no file of this release", err)
        self.assertEqual(contents(folder), {"letter.txt": b"dear"})
        code, _, err = self.generate(folder / "letter.txt")
        self.assertEqual(code, 3)
        self.assertIn("letter.txt", err)


if __name__ == "__main__":
    unittest.main()
