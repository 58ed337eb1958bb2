# SPDX-License-Identifier: GPL-3.0-or-later
"""Subjects that are deaf, or misbehave when no case is at hand. Verdicts on the case at hand: transcripts/certify.md."""
import unittest

from certify_harness import CertifyTest, boxes, liar

STREAM = boxes(0) + boxes(1, marked=True) + boxes(2)


class Liars(CertifyTest):
    def test_no_shell_holds_the_output_open(self):
        """It is seen to be closed at once: no time is up."""
        plain = liar("close-output").removeprefix("exec ")
        code, lines, _ = self.certify("--jobs", "1", "--time-out", "1e9", "--subject", plain, "-", stdin=STREAM)
        self.assertEqual((code, self.verdicts(lines)), (1, {"box::0": "pass", "box::1": "silent", "box::2": "pass"}))

    def test_stops_reading(self):
        """A case larger than a pipe holds, and a subject that is deaf from the start."""
        many = [[i / 1000, i % 7, i % 11] for i in range(20000)]
        stream = boxes(0) + boxes(1).replace("[2, 1, 1]", "[2, 1, 1], " + str(many)[1:-1])
        code, lines, _ = self.certify("--jobs", "1", "--time-out", "0.5", "--subject", liar("hello-then-deaf"), "-", stdin=stream)
        self.assertEqual((code, self.verdicts(lines)), (1, {"box::0": "time-out", "box::1": "time-out"}))
        self.assertRegex(lines[2]["detail"], r"no answer within 0.5 s; it has not read the last \d+ of the case's \d+ bytes")


class NoCasesFault(CertifyTest):
    """What a subject does after a good answer, or at its end, is no case's fault: it is in the report, and in the exit code."""

    def check(self, way, *expected, verdicts=None, options=()):
        code, lines, err = self.certify("--jobs", "1", *options, "--subject", liar(way), "-", stdin=STREAM)
        self.assertEqual((code, self.verdicts(lines)), (1, verdicts or {f"box::{i}": "pass" for i in range(3)}), err)
        things = [(line.get("after"), line["detail"]) for line in lines if line["type"] == "unattributed"]
        self.assertEqual(len(things), len(expected), things)
        for (after, detail), (case, text) in zip(things, expected):
            self.assertEqual(after, case)
            self.assertTrue(detail.startswith(text), detail)
        self.assertEqual(lines[-1]["unattributed"], len(expected))
        self.assertIn("fathom: no case's fault: the subject, after case 'box::", err)

    def test_each_way(self):
        killed = "killed by signal 11 (Segmentation fault); last words: about to go"
        self.check("one-shot", *((f"box::{i}", "ended with exit code 0") for i in range(3)))
        self.check("twice-late", *((f"box::{i}", "wrote '{") for i in range(3)))
        self.check("twice", ("box::1", "wrote '{"))
        self.check("crash-at-stop", ("box::2", "after stop: " + killed))
        self.check("fail-at-stop", ("box::2", "after stop: ended with exit code 3"))
        self.check("deaf", *((f"box::{i}", "no answer within 0.5 s") for i in range(2)), options=("--time-out", "0.5"))
        self.check("dies-soon", ("box::0", killed), ("box::2", killed), verdicts={"box::0": "pass", "box::1": "crash", "box::2": "pass"})

    def test_a_reply_that_is_sent_twice(self):
        """Whichever it is: also where the next case has the same answer, and where there is no next case."""
        count = 6
        for marked in range(count):
            stream = "".join(boxes(0, marked=i == marked).replace("box::0", f"box::{i}") for i in range(count))
            with self.subTest(marked):
                code, lines, err = self.certify("--subject", liar("twice"), "-", stdin=stream)
                self.assertEqual((code, set(self.verdicts(lines).values()), lines[-1]["unattributed"]), (1, {"pass"}, 1), err)
        stream = "".join(boxes(0).replace("box::0", f"box::{i}") for i in range(count))
        code, lines, err = self.certify("--jobs", "1", "--subject", liar("guesses"), "-", stdin=stream)
        self.assertEqual((code, set(self.verdicts(lines).values()), lines[-1]["unattributed"]), (1, {"pass"}, count), err)

    def test_that_does_not_end_at_stop(self):
        code, lines, err = self.certify("--jobs", "1", "--subject", liar("ignore-stop"), "-", stdin=STREAM)
        self.assertEqual((code, set(self.verdicts(lines).values()), err), (0, {"pass"}, ""))

    def test_in_the_table(self):
        code, out, _ = self.run_cli("certify", "--jobs", "1", "--subject", liar("exits-soon"), "-", stdin=boxes(0) + boxes(1) + boxes(2))
        self.assertEqual(code, 1)
        self.assertIn("\nunattributed 3 x ended with exit code 3\n", out)
        self.assertTrue(out.endswith("\n3 cases: 3 pass, 0 fail; 3 unattributed\n"), out)

    def test_resumed(self):
        """What the first run saw is counted in the second."""
        report = self.folder / "report"
        words = ("--jobs", "1", "--report", report, "--subject", liar("exits-soon"), "-")
        self.certify(*words, stdin=boxes(0) + boxes(1))
        code, lines, _ = self.certify("--resume", *words, stdin=boxes(0) + boxes(1) + boxes(2))
        self.assertEqual((code, lines[-1]["unattributed"]), (1, 3))
        self.assertEqual(report.read_text().count('"type":"unattributed"'), 3)

    def test_the_same_report_each_time(self):
        """Whenever it happens: before the next case is sent, while it is on its way, or when it has come."""
        stream = "".join(boxes(i, marked=i == 2) for i in range(6))

        def report(way, jobs):
            code, lines, _ = self.certify("--jobs", jobs, "--subject", liar(way), "-", stdin=stream)
            lines = [{field: value for field, value in line.items() if field != "seconds"} for line in lines]
            return code, lines if jobs == 1 else sorted(map(str, lines))

        # Two at once answer again the runs of ids that depend on who got which case.
        for way, jobs, runs in (("dies-soon", 1, 24), ("dies-soon", 2, 6), ("talks-soon", 1, 6), ("talks-soon", 2, 4),
                                ("talks-and-dies-soon", 1, 4), ("answers-again-soon", 1, 4)):
            first = report(way, jobs)
            for _ in range(runs):
                self.assertEqual(report(way, jobs), first, way)


if __name__ == "__main__":
    unittest.main()
