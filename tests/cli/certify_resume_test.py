# SPDX-License-Identifier: GPL-3.0-or-later
"""Whatever is killed at whatever moment: no verdict is lost, none is found twice. Reports that go on: transcripts/certify_resume.md."""
import json
import os
import pathlib
import random
import signal
import subprocess
import threading
import time
import unittest
import xml.etree.ElementTree

from certify_harness import CertifyTest, boxes, liar
from harness import EXECUTABLE, PATIENCE

COUNT = 40
STREAM = "".join(boxes(i, marked=i % 10 == 3) for i in range(COUNT))
EXPECTED = {f"box::{i}": "too-deep" if i % 10 == 3 else "pass" for i in range(COUNT)}


def children(pid):
    """The processes below one, however deep."""
    below = {}
    for entry in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            parent = int((entry / "stat").read_text().rpartition(")")[2].split()[1])
        except (OSError, ValueError, IndexError):
            continue
        below.setdefault(parent, []).append(int(entry.name))
    found = list(below.get(pid, []))
    for child in found:
        found += below.get(child, [])
    return found


class Killed(CertifyTest):
    def setUp(self):
        super().setUp()
        self.cases = self.file("cases.jsonl", STREAM)
        self.report = self.folder / "report.jsonl"
        self.words = ["certify", "--jobs", "2", "--subject", liar("too-deep", 0.01), "--report", str(self.report), self.cases]

    def lines(self):
        return [json.loads(line) for line in self.report.read_text().splitlines()]

    def whole_lines(self):
        """Of a report that may end in the middle of a line; without a summary, which a resumed run takes away and writes anew."""
        text = self.report.read_text() if self.report.exists() else ""
        return [line for line in text.split("\n")[:-1] if '"type":"summary"' not in line]

    def check_complete(self):
        lines = self.lines()
        self.assertEqual([line["type"] for line in lines], ["header"] + COUNT * ["case"] + ["summary"])
        self.assertEqual(self.verdicts(lines), EXPECTED)
        self.assertEqual({k: v for k, v in lines[-1].items() if isinstance(v, int)},
                         {"cases": COUNT, "passed": COUNT - 4, "failed": 4, "unsupported": 0, "unattributed": 0})

    def test_fathom(self):
        """kill -9 at random moments, until a run comes through."""
        rng = random.Random(7)
        kills, kept = 0, []
        while True:
            resume = ["--resume"] if self.report.exists() else []
            with subprocess.Popen([EXECUTABLE, *self.words, *resume], stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
                try:
                    _, err = process.communicate(timeout=rng.uniform(0.05, 0.35) if kills < 12 else PATIENCE)
                except subprocess.TimeoutExpired:
                    process.kill()
                    process.communicate()
                    kills += 1
                    now = self.whole_lines()
                    self.assertTrue(now[:len(kept)] == kept, "a line was lost or changed")
                    kept = now
                    continue
            self.assertEqual((process.returncode, err), (1, b""))
            break
        self.assertGreater(kills, 1)
        self.assertTrue(self.whole_lines()[:len(kept)] == kept, "a line was lost or changed")
        self.check_complete()

    def test_subjects(self):
        """kill -9 of the subjects at random moments: only the cases at hand are blamed, and there are no others than these."""
        rng = random.Random(8)
        with subprocess.Popen([EXECUTABLE, *self.words], stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
            done = threading.Event()
            kills = []

            def kill():
                while len(self.whole_lines()) < 3 and not done.wait(0.01):
                    pass
                while not done.wait(rng.uniform(0.03, 0.12)) and len(kills) < 6:
                    if victims := children(process.pid):
                        try:
                            os.kill(rng.choice(victims), signal.SIGKILL)
                            kills.append(1)
                        except ProcessLookupError:
                            pass

            killer = threading.Thread(target=kill)
            killer.start()
            process.communicate(timeout=PATIENCE)
            done.set()
            killer.join()
        lines = self.lines()
        self.assertEqual(process.returncode, 4 if lines[-1]["type"] != "summary" else 1)
        found = self.verdicts(lines)
        crashed = {i for i, verdict in found.items() if verdict == "crash"}
        things = sum(line["type"] == "unattributed" for line in lines)
        self.assertLessEqual(2 * len(crashed) + things, len(kills), "a case is blamed for two kills of its own")
        others = found.keys() - crashed
        self.assertEqual({i: found[i] for i in others}, {i: EXPECTED[i] for i in others})
        if lines[-1]["type"] == "summary":
            self.assertEqual(found.keys(), EXPECTED.keys())

    def interrupt(self, *words, lines, stdin=subprocess.DEVNULL, text=b""):
        """stdout of a run that gets a SIGINT once so many lines are in its report. `text` is all that it reads, and no end."""
        with subprocess.Popen([EXECUTABLE, *words], stdin=stdin, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
            if text:
                process.stdin.write(text)
                process.stdin.flush()
            while len(self.whole_lines()) < lines:
                time.sleep(0.01)
            process.send_signal(signal.SIGINT)
            out, err = process.stdout.read(), process.stderr.read()
            self.assertEqual(process.wait(timeout=PATIENCE), 130)
        self.assertIn(b"--resume goes on from there", err)
        self.assertTrue(err.endswith(b"fathom: interrupted\n"))
        return out.decode()

    def check_partial(self, out, junit, html, done):
        """Table, JUnit and page are of the `done` cases that the report holds, and say that there are more."""
        self.assertTrue(out, "a table")
        total = out.splitlines()[-1]
        self.assertIn(f"{done} case{'s' * (done > 1)}: ", total)
        root = xml.etree.ElementTree.parse(junit).getroot()
        self.assertEqual(len(list(root.iter("testcase"))), done)
        self.assertIn(("cut short", "interrupted"), {(p.get("name"), p.get("value")) for p in root.iter("property")})
        page = html.read_text()
        self.assertIn("interrupted; this is what was judged", page)
        self.assertIn(total, page)

    def test_interrupted(self):
        junit, html, known = self.folder / "junit.xml", self.folder / "page.html", self.folder / "known.txt"
        known.write_text("".join(f"too-deep box::{i}\n" for i in range(3, COUNT, 10)))
        out = self.interrupt(*self.words, "--junit", str(junit), "--html", str(html), "--expect-fail", str(known), lines=6)
        self.check_partial(out, junit, html, len(self.whole_lines()) - 1)
        self.assertEqual(xml.etree.ElementTree.parse(junit).getroot().get("failures"), "0", "what was not run is nobody's failure")
        code, _, err = self.run_cli(*self.words, "--resume")
        self.assertEqual((code, err), (1, ""))
        self.check_complete()

    def test_interrupted_while_it_waits(self):
        """For a case that does not come, and for a subject that does not answer."""
        junit, html = self.folder / "junit.xml", self.folder / "page.html"
        reports = ["--junit", str(junit), "--html", str(html), "--report", str(self.report)]
        out = self.interrupt("certify", "--subject", liar("honest"), *reports, "-", lines=2, stdin=subprocess.PIPE, text=boxes(1).encode())
        self.check_partial(out, junit, html, 1)
        self.report.unlink()
        cases = self.file("cases.jsonl", boxes(0) + boxes(1, marked=True))
        out = self.interrupt("certify", "--jobs", "1", "--time-out", "1000", "--subject", liar("hang"), *reports, cases, lines=2)
        self.check_partial(out, junit, html, 1)

    def test_interrupted_before_the_first_answer(self):
        """There is nothing to report."""
        cases = self.file("cases.jsonl", boxes(1, marked=True))
        page = self.folder / "page.html"
        out = self.interrupt("certify", "--time-out", "1000", "--subject", liar("hang"), "--report", str(self.report), "--html", str(page),
                             cases, lines=1)
        self.assertEqual(out, "")
        self.assertFalse(page.exists())


if __name__ == "__main__":
    unittest.main()
