# SPDX-License-Identifier: GPL-3.0-or-later
"""mpirun -np N fathom: golden verify, certify and depth print the same on any number of processes; a dead one is named, and the next run
goes on. golden generate: golden_mpi_test.py."""
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time
import unittest

from certify_harness import boxes, liar
from golden_mpi_test import MPIRUN, descendants
from golden_release import COMMITTED, ENDS, GoldenTest, packed, repair, unpacked
from harness import EXECUTABLE, PATIENCE, ROOT

PROGRAM = pathlib.Path(EXECUTABLE).with_name("fathom-mpi")
STREAM = "".join(boxes(i, marked=i % 10 == 3) for i in range(60))


def command(ranks, *words):
    start = [MPIRUN, "--allow-run-as-root", "--oversubscribe", "-np", str(ranks)] if ranks > 1 else []
    return [*start, EXECUTABLE, *map(str, words)]


def ours(text):
    """Without what mpirun adds when a process exits with another code than 0."""
    return "".join(line for line in text.splitlines(keepends=True) if line.startswith("fathom: "))


@unittest.skipUnless(MPIRUN and PROGRAM.exists(), "Open MPI or Boost.MPI is not here (openmpi-bin, libopenmpi-dev, libboost-mpi-dev)")
class Mpi(GoldenTest):
    def on_ranks(self, ranks, *words, stdin=""):
        """(exit code, stdout, our part of stderr)"""
        done = subprocess.run(command(ranks, *words), input=stdin, capture_output=True, text=True, timeout=PATIENCE)
        return done.returncode, done.stdout, ours(done.stderr)

    def same_on_all(self, *words, stdin=""):
        one, two, three = (self.on_ranks(ranks, *words, stdin=stdin) for ranks in (1, 2, 3))
        self.assertEqual(one, two)
        self.assertEqual(one, three)
        return one

    def test_verify(self):
        self.assertRegex(self.same_on_all("golden", "verify", "--method", "exact", COMMITTED)[1], "^s VERIFIED L0 .* agreed=exact ")
        self.assertEqual(self.same_on_all("golden", "verify", self.folder / "nothing")[0], 2)
        self.assertEqual(self.same_on_all("golden", "verify")[0], 2)
        self.assertIn("Examples", self.same_on_all("golden", "verify", "--help")[1])

    def test_verify_refuses_the_same(self):
        """The first fault in the order of the records, though another rank may meet another one sooner."""
        folder = self.folder / "forged"
        shutil.copytree(self.release, folder)
        for shard in self.shards[1:]:
            path = folder / (shard + ENDS[0])
            lines = unpacked(path).splitlines(keepends=True)
            lines[2] = lines[2].replace(b'"status":"', b'"status":"x')
            path.write_bytes(packed(b"".join(lines)))
        repair(folder)
        code, out, _ = self.same_on_all("golden", "verify", folder)
        self.assertEqual(code, 1)
        self.assertRegex(out, rf"^s REFUSED {self.shards[1]}.jsonl.zst:3: expected.status: .*\n$")
        (folder / "NOTES.md").write_text("x")
        self.assertEqual(self.same_on_all("golden", "verify", folder)[0], 1)

    def test_certify(self):
        """Verdicts, table and exit code; the lines of a report come in the order in which answers do."""
        for way in ("honest", "too-deep", "nan", "crash", "garbage"):
            code, table, _ = self.same_on_all("certify", "--method", "exact", "--subject", liar(way), "-", stdin=STREAM)
            self.assertEqual(code, 0 if way == "honest" else 1)
            self.assertIn("60 cases", table)
        reports = []
        for ranks in (1, 3):
            report = self.folder / f"{ranks}.jsonl"
            self.on_ranks(ranks, "certify", "--metamorphic", "--subject", liar("too-deep"), "--report", report, "-", stdin=STREAM)
            lines = [json.loads(line) for line in report.read_text().splitlines()]
            for line in lines:
                line.pop("seconds", None)
                line.pop("command", None)
            reports.append(sorted(map(json.dumps, lines)))
        self.assertEqual(*reports)

    def test_certify_without_a_subject(self):
        code, out, err = self.same_on_all("certify", "--subject", "exec false", "-", stdin=STREAM)
        self.assertEqual((code, out), (4, ""))
        self.assertIn("nothing was judged", err)
        self.assertEqual(self.same_on_all("certify", "--subject", "x", "nothing.jsonl")[0], 2)
        self.assertEqual(self.same_on_all("certify", "--list-adapters")[0], 0)

    def test_depth(self):
        """A stream of many blocks, with bad cases, cases over several lines, and a note on hulls: the same bytes everywhere."""
        box = json.loads(boxes(7))
        cases = []
        for i in range(300):
            box["id"] = f"case {i}"
            if i % 90 == 50:
                box["a"]["vertices"].append([0.75, 0.5, 0.5])  # within
            cases.append(json.dumps(box, indent=1 if i % 40 == 3 else None).replace("\n ", "\n  ") + "\n")
        cases[5], cases[70], cases[71], cases[299] = "noise\n", '{"id": "cut"\n', '{"id": "x", "a": 1}\n', "\n"
        stream = "".join(cases)
        code, out, err = self.same_on_all("depth", "--json", "-", stdin=stream)
        self.assertEqual(code, 2)
        self.assertEqual(out.count("\n"), 299)
        self.assertIn("<stdin>:", err)
        self.assertIn("errors: 3 of 299 lines", err)
        path = self.file("cases.jsonl", stream)
        for words in (["depth", path], ["depth", "--json", "--embed-certificate", "--counters", path],
                      ["depth", "--method", "exact", path]):
            self.assertEqual(self.same_on_all(*words)[0], 2)
        self.assertEqual(self.same_on_all("depth", "-", stdin="")[0], 2)
        self.assertEqual(self.same_on_all("depth", self.folder / "nothing.jsonl")[0], 2)

    def test_what_rank_0_does_alone(self):
        cube = ROOT / "tests" / "data" / "cube.off"
        self.assertIn("penetrating", self.same_on_all("depth", cube, cube)[1])
        self.assertEqual(self.same_on_all("depth", "--certificate", self.folder / "proofs", "-", stdin="")[0], 2)
        for ranks in (1, 3):
            folder = self.folder / str(ranks)
            self.on_ranks(ranks, "depth", "--certificate", folder, "-", stdin=STREAM)
            self.assertEqual(len(list(folder.iterdir())), 60)

    def killed(self, under_way, *words):
        """Kills the last of three ranks once under_way() says that the work has begun. Returns (exit code, all of stderr)."""
        with subprocess.Popen(command(3, *words), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
            while process.poll() is None and not under_way():
                time.sleep(0.01)
            last = [number for number, name in descendants(process.pid)
                    if b"OMPI_COMM_WORLD_RANK=2" in pathlib.Path(f"/proc/{number}/environ").read_bytes().split(b"\0")]
            os.kill(min(last), signal.SIGKILL)  # what it started came after it
            _, err = process.communicate(timeout=PATIENCE)
            return process.returncode, err

    def test_a_killed_rank(self):
        """mpirun names it; rank 0 says what each was at; the report holds what was judged, and the next run does the rest."""
        cases, report = self.file("cases.jsonl", STREAM), self.folder / "report.jsonl"
        words = ["certify", "--subject", liar("too-deep", 0.1), "--report", report, cases]
        judged = lambda: [line for line in report.read_text().splitlines() if '"type":"case"' in line] if report.exists() else []
        code, err = self.killed(judged, *words)
        self.assertNotEqual(code, 0)
        self.assertRegex(err, r"rank \d with PID \d+ on node \S+ exited on signal 9")
        self.assertRegex(err, r"fathom: rank \d was at case box::\d+")
        self.assertTrue(0 < len(judged()) < 60)
        self.assertEqual(self.on_ranks(2, *words[:-1], "--resume", cases)[0], 1)
        lines = [json.loads(line) for line in report.read_text().splitlines()]
        self.assertEqual({line["id"]: line["verdict"] for line in lines if line["type"] == "case"},
                         {f"box::{i}": "too-deep" if i % 10 == 3 else "pass" for i in range(60)})
        self.assertEqual(sum(line["type"] == "case" for line in lines), 60)
        self.assertEqual(lines[-1]["type"], "summary")

    def test_a_subject_that_is_fathom(self):
        """A program that a rank starts is no part of the job."""
        wrapper = self.file("wrapper.py", f"""
import json, subprocess, sys
print(json.dumps({{"type": "hello", "protocol": "fathom/subject/1", "name": "self", "version": "1", "precision": "binary64",
                  "conventions": {{"touching": "either", "depth": "positive", "moves": "a", "unit": True}}}}), flush=True)
for line in sys.stdin:
    run = json.loads(line)
    if run["type"] == "run":
        case = json.dumps({{"a": run["a"], "b": run["b"]}})
        out = subprocess.run([{EXECUTABLE!r}, "depth", "--json", "-"], input=case, capture_output=True, text=True, check=True).stdout
        overlap = json.loads(out)["status"] == "penetrating"
        print(json.dumps({{"type": "reply", "id": run["id"], "overlap": overlap, "depth": 0.5}}), flush=True)
    elif run["type"] == "stop":
        break
""")
        code, out, err = self.on_ranks(2, "certify", "--subject", f"{sys.executable} -B {wrapper}", "-", stdin=boxes(0))
        self.assertEqual(code, 0, err)
        self.assertIn("1 case: 1 pass, 0 fail", out)


if __name__ == "__main__":
    unittest.main()
