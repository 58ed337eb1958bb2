# SPDX-License-Identifier: GPL-3.0-or-later
"""`fathom golden verify` refuses by default: damage that the sums show, and forgeries whose sums, counts and pages have been made right."""
import hashlib
import json
import re
import shutil
import subprocess
import unittest

from golden_release import ENDS, GoldenTest, contents, packed, page, repair, unpacked, write_sums
from harness import changed

RECORDS, CERTIFICATES, CSV = ENDS


def proofs_in(content):
    return re.findall(rb"fathom-certificate.*?\nend [^\n]*\n", content, re.DOTALL)


class Verify(GoldenTest):
    def copy(self):
        folder = self.folder / "copy"
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(self.release, folder)
        return folder

    def refusal(self, folder, place, reason="", code=1):
        got, out, err = self.run_cli("golden", "verify", folder)
        self.assertEqual((got, err), (code, ""), out)
        self.assertNotIn("VERIFIED", out)
        self.assertRegex(out, rf"(?m)^s REFUSED {re.escape(place)}[^ ]*: .*{re.escape(reason)}", out)

    def forged(self, end, change, shard=0):
        """A release in which one file has other content and everything else has been made to agree with it."""
        folder = self.copy()
        path = folder / (self.shards[shard] + end)
        path.write_bytes(packed(change(unpacked(path))))
        repair(folder)
        return folder

    def test_the_forger_is_good(self):
        """A folder that is repaired without a forgery is accepted, so a refusal below is about the forgery."""
        folder = self.forged(RECORDS, lambda content: content)
        self.assertIn("s VERIFIED L0", self.answer("golden", "verify", folder))

    def test_damage(self):
        for name, data in contents(self.release).items():
            folder = self.copy()
            (folder / name).write_bytes(data[:-1])
            self.refusal(folder, name)
            (folder / name).write_bytes(data[:len(data) // 2] + bytes([data[len(data) // 2] ^ 1]) + data[len(data) // 2 + 1:])
            got, out, _ = self.run_cli("golden", "verify", folder)
            self.assertEqual(got, 1, name)
            self.assertIn("s REFUSED ", out)

    def test_missing_and_unknown_files(self):
        for name in contents(self.release):
            folder = self.copy()
            (folder / name).unlink()
            self.refusal(folder, name, "the file is missing")
        folder = self.copy()
        (folder / "more.txt").write_text("more")
        self.refusal(folder, "more.txt", "no file of this release")
        write_sums(folder)
        self.refusal(folder, "more.txt", "no file of this release")
        folder = self.copy()
        (folder / "NOTES.md").rename(self.folder / "elsewhere")
        (folder / "NOTES.md").symlink_to(self.folder / "elsewhere")
        self.refusal(folder, "NOTES.md")

    def test_sums(self):
        text = (self.release / "SHA256SUMS").read_text()
        lines = text.splitlines(keepends=True)
        for wrong in ("", text + lines[-1], "".join(lines[1:]), "".join(reversed(lines)), text.rstrip("\n"), text.upper(),
                      text.replace("  ", " *"), text + "\n", text.replace(lines[0][:64], 64 * "0")):
            folder = self.copy()
            (folder / "SHA256SUMS").write_text(wrong)
            got, out, _ = self.run_cli("golden", "verify", folder)
            self.assertEqual(got, 1, wrong)

    def test_pages(self):
        for name in ("NOTES.md", "LICENSE", "golden.schema.json", "dataset.schema.json", "shard.schema.json"):
            folder = self.copy()
            (folder / name).write_text((folder / name).read_text() + "more\n")
            write_sums(folder)
            self.refusal(folder, name, "the page is not the one")
        good = json.loads((self.release / "dataset.json").read_text())
        for field, value in (("schema", "x"), ("licence", "mine"), ("level", "L1"), ("records", 1), ("recipes", 1), ("version", "1.0.1"),
                             ("date", "today"), ("shards", []), ("shards", good["shards"][:-1]), ("name", "x"), ("schemas", {}),
                             ("generator", {**good["generator"], "seed": "2"}),
                             ("generator", {**good["generator"], "data_version": "2.0.0"})):
            folder = self.copy()
            (folder / "dataset.json").write_bytes(page({**good, field: value}))
            write_sums(folder)
            self.refusal(folder, "dataset.json")
        folder = self.copy()
        shard = json.loads((folder / (self.shards[0] + ".json")).read_text())
        (folder / (self.shards[0] + ".json")).write_bytes(page({**shard, "records": shard["records"] + 1}))
        write_sums(folder)
        self.refusal(folder, self.shards[0] + ".json", "differs from the shard's entry")

    def test_frames(self):
        for end in ENDS:
            name = self.shards[0] + end
            data = (self.release / name).read_bytes()
            for wrong in (data[:-1], b"", data + b"x", data + packed(b"more\n"), b"noise" + data):
                folder = self.copy()
                (folder / name).write_bytes(wrong)
                repair(folder)
                self.refusal(folder, name)

    def test_values(self):
        """A few values of one record; that every field is proved again is tested where the proof is."""
        name = self.shards[0] + RECORDS
        lines = unpacked(self.release / name).splitlines(keepends=True)
        number = next(i for i, line in enumerate(lines) if b'"penetrating"' in line and b'"binary32"' in line)
        for path, value in ((["expected", "depth", "f64", "rn"], "0x1.8p+3"), (["expected", "depth", "f32", "rd"], "0x1.8p+3"),
                            (["expected", "depth", "squared"], "9/4"), (["expected", "status"], "touching"), (["id"], "another"),
                            (["expected", "optima"], []), (["flags"], []), (["more"], 1)):
            with self.subTest(path):
                record = json.loads(lines[number])
                self.assertEqual(json.dumps(record, separators=(",", ":")).encode() + b"\n", lines[number])
                wrong = json.dumps(changed(record, path, value), separators=(",", ":")).encode() + b"\n"
                folder = self.forged(RECORDS, lambda _: b"".join([*lines[:number], wrong, *lines[number + 1:]]))
                self.refusal(folder, f"{name}:{number + 1}")

    def test_lines(self):
        """Lost, doubled, exchanged and added lines, in each of the three files."""
        for end in ENDS:
            for change in (lambda lines: lines[:-1], lambda lines: lines + lines[-1:],
                           lambda lines: lines[:2] + lines[3:1:-1] + lines[4:], lambda lines: lines + [b"\n"],
                           lambda lines: lines[:-1] + [lines[-1][:-1]], lambda lines: lines[:5] + [b"x\n"] + lines[5:]):
                folder = self.forged(end, lambda content: b"".join(change(content.splitlines(keepends=True))))
                got, out, err = self.run_cli("golden", "verify", folder)
                self.assertEqual((got, err), (1, ""), (end, out))
                self.assertRegex(out, rf"(?m)^s REFUSED {self.shards[0]}")

    def test_records_moved_with_all_that_is_theirs(self):
        """Lost, doubled or moved in all files at once: only the plan shows it."""
        name = self.shards[0]
        content = {end: unpacked(self.release / (name + end)) for end in ENDS}
        records, proofs = content[RECORDS].splitlines(keepends=True), proofs_in(content[CERTIFICATES])
        rows = content[CSV].splitlines(keepends=True)
        self.assertEqual(len(records), len(proofs))
        ids = [json.loads(line)["id"] for line in records]
        rounded = next(i for i, each in enumerate(ids) if each.endswith(".b32"))
        for kept in ([i for i in range(len(ids)) if i != rounded], [*range(len(ids)), len(ids) - 1], [*range(1, len(ids)), 0],
                     [*range(len(ids) - 1)]):
            folder = self.copy()
            lines = {RECORDS: [records[i] for i in kept], CERTIFICATES: [proofs[i] for i in kept], CSV: rows[:1]}
            for i in kept:
                lines[CSV] += [row for row in rows if row.startswith(f"{ids[i]},".encode())]
            for end in ENDS:
                (folder / (name + end)).write_bytes(packed(b"".join(lines[end])))
            repair(folder)
            self.refusal(folder, name + RECORDS)

    def test_certificates_that_prove_something_else(self):
        """Exchanged between two records, and one that is no proof."""
        def exchange(content):
            parts = proofs_in(content)
            return b"".join([parts[1], parts[0], *parts[2:]])

        name = self.shards[0]
        self.refusal(self.forged(CERTIFICATES, exchange), f"{name}{RECORDS}:1")
        self.refusal(self.forged(CERTIFICATES, lambda content: content.replace(b"\nclaim ", b"\nclaim bounds 0 ", 1)), name + RECORDS)

    def test_every_shard_is_looked_at(self):
        for shard in range(len(self.shards)):
            folder = self.forged(CSV, lambda content: content.replace(b"0x1", b"0x2", 1), shard)
            self.refusal(folder, self.shards[shard] + CSV)

    def test_threads(self):
        for jobs in ("1", "7"):
            self.assertIn("s VERIFIED", self.answer("golden", "verify", self.release, "--jobs", jobs))

    def test_unreadable(self):
        for words in (["golden", "verify", self.folder / "nothing"], ["golden", "verify", self.release / "NOTES.md"]):
            self.assertIn("cannot read the folder", self.refused(*words))
        empty = self.folder / "empty"
        empty.mkdir()
        self.refusal(empty, "dataset.json", "the file is missing")

    def test_memory(self):
        """A frame that unpacks to far more than it should is refused in little memory."""
        folder = self.copy()
        name = self.shards[0] + RECORDS
        bomb = subprocess.run("head -c 2000000000 /dev/zero | zstd -c1", shell=True, check=True, stdout=subprocess.PIPE).stdout
        (folder / name).write_bytes(bomb)
        shard = json.loads((folder / (self.shards[0] + ".json")).read_text())
        dataset = json.loads((folder / "dataset.json").read_text())
        for value in (shard, dataset["shards"][0]):
            value["files"][0]["bytes"], value["files"][0]["sha256"] = len(bomb), hashlib.sha256(bomb).hexdigest()
        (folder / (self.shards[0] + ".json")).write_bytes(page(shard))
        (folder / "dataset.json").write_bytes(page(dataset))
        write_sums(folder)
        self.refusal(folder, name, "a line is too long")


if __name__ == "__main__":
    unittest.main()
