# SPDX-License-Identifier: GPL-3.0-or-later
"""Subjects that are wrong, lie, crash, hang or babble: the verdict on the case at hand, and nothing else suffers."""
import unittest

from certify_harness import CertifyTest, boxes, liar

STREAM = boxes(0) + boxes(1, marked=True) + boxes(2)
# What the liar does with the marked case, the verdict on it, and what is told of it.
WAYS = {
    "too-deep": ("too-deep", None), "too-shallow": ("too-shallow", None), "negative-depth": ("wrong-sign", None),
    "turned-direction": ("wrong-sign", None), "nan": ("nan", None), "infinite": ("nan", None), "separation": ("false-separation", None),
    "zero-direction": ("not-a-direction", None), "failed": ("failed", 'std::logic_error: no "hull"'),
    "crash": ("crash", "killed by signal 11 (Segmentation fault); last words: about to go"),
    "abort": ("crash", "killed by signal 6 (Aborted); last words: about to go"), "exit": ("crash", "ended with exit code 3"),
    "silent": ("silent", "ended with exit code 0"), "garbage": ("garbage", "expected a JSON object, found 'Segmentation fault?'"),
    "empty-line": ("garbage", "expected a JSON object, found an empty line"),
    "noise": ("garbage", "expected a JSON object, found a null byte in '\\x00"),
    "no-fields": ("garbage", 'expected "overlap" in the reply, found none'), "wrong-types": ("garbage", 'expected a number for "depth"'),
    "array": ("garbage", "expected a JSON object"), "nested": ("garbage", "expected a JSON object, found '[[["),
    "huge-line": ("garbage", "a line of more than 16777216 bytes"), "half-line": ("garbage", "a line that was cut off: '{"),
    "cut-line": ("garbage", "a line that was cut off: '{"), "other-id": ("garbage", "found one to '99999'"),
    "null-depth": ("garbage", 'expected a number for "depth" (NaN is "nan"), found \'null\''),
    "null-apart": ("garbage", 'expected three numbers for "direction", found \'null\''),
    "no-id": ("garbage", 'expected "id" in the reply, found none; the line: \'{"type": "reply", "overlap": true'),
    "close-output": ("silent", "closed its output and lived on"), "linger": ("crash", "ended with exit code 9"),
    "second-hello": ("garbage", 'expected a message of type "reply"'), "dribble": ("pass", None),
}
# Those where no answer can come.
ENDLESS = {"no-newline": "no answer within 0.5 s; 106 bytes came, no end of line: '{\"type\": \"reply\", \"id\": \"2",
           "hang": "no answer within 0.5 s", "busy": "no answer within 0.5 s", "dribble-forever": "no answer within 0.5 s",
           "flood": "no answer within 0.5 s; no byte came: does it flush its output?; last words: "}


class Liars(CertifyTest):
    def check(self, way, verdict, detail, *options):
        code, lines, err = self.certify("--jobs", "1", *options, "--subject", liar(way), "-", stdin=STREAM)
        self.assertEqual(code, 0 if verdict == "pass" else 1, err)
        self.assertEqual(self.verdicts(lines), {"box::0": "pass", "box::1": verdict, "box::2": "pass"})
        self.assertEqual(lines[-1]["type"], "summary")
        told = {line.get("id"): line.get("detail") for line in lines}["box::1"]
        if detail is None:
            self.assertIsNone(told)
        else:
            self.assertIn(detail, told)

    def test_each_way(self):
        for way, (verdict, detail) in WAYS.items():
            with self.subTest(way):
                self.check(way, verdict, detail)

    def test_endless(self):
        for way, detail in ENDLESS.items():
            with self.subTest(way):
                self.check(way, "time-out", detail, "--time-out", "0.5")

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

    def test_unsupported_is_not_judged(self):
        code, lines, _ = self.certify("--subject", liar("unsupported"), "-", stdin=STREAM)
        self.assertEqual((code, self.verdicts(lines)["box::1"]), (0, "unsupported"))
        code, lines, err = self.certify("--subject", liar("unsupported"), "-", stdin=boxes(1, marked=True))
        self.assertEqual((code, err), (4, "fathom: no case was judged: the subject declined all of them\n"))

    def test_overflow_of_binary32(self):
        stream = boxes(0) + boxes(1).replace("[[1,", "[[1e39,")
        code, lines, _ = self.certify("--subject", liar("binary32"), "-", stdin=stream)
        self.assertEqual((code, self.verdicts(lines)), (0, {"box::0": "pass", "box::1": "unsupported"}))


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


class Hellos(CertifyTest):
    def test_wrong_ones(self):
        for way, told in {"hello-silent": "the subject said no hello: ended with exit code 0",
                          "hello-crash": "the subject said no hello: killed by signal 11 (Segmentation fault); last words: about to go",
                          "hello-garbage": "the subject said no hello: ended with exit code 0; what the subject wrote before its hello is no "
                                           "JSON object, and passed over: 'liar 1.0, ready'",
                          "hello-half": "the subject's hello is wrong: expected a JSON object, found '{\"type\":'",
                          "hello-flood": "the subject said no hello within 10 s; ",
                          "hello-without-name": "the subject's hello is wrong: expected \"name\" in the hello, found none",
                          "hello-without-unit": "the subject's hello is wrong: expected \"unit\" in the hello's conventions, found none",
                          "hello-other-protocol": "hello is wrong: expected protocol fathom/subject/1, found 'fathom/subject/2'",
                          "hello-precision": "expected binary64, binary32 for \"precision\" in the hello, found 'binary16'"}.items():
            with self.subTest(way):
                code, lines, err = self.certify("--subject", liar(way), "-", stdin=STREAM)
                self.assertEqual((code, lines), (4, []))
                self.assertIn(told, err)
                self.assertIn("nothing was judged", err)

    def test_behind_the_greeting_of_a_library(self):
        code, lines, err = self.certify("--jobs", "2", "--subject", liar("hello-late"), "-", stdin=STREAM)
        self.assertEqual((code, set(self.verdicts(lines).values())), (0, {"pass"}))
        self.assertEqual(err, "fathom: what the subject wrote before its hello is no JSON object, and passed over: 'liar 1.0', ...\n")

    def test_that_is_all_there_is(self):
        code, lines, err = self.certify("--jobs", "1", "--subject", liar("hello-then-crash"), "-", stdin=STREAM)
        self.assertEqual((code, [line["type"] for line in lines]), (4, ["header"] + 3 * ["unattributed"]))
        self.assertIn("fathom: the subject ends each time before it reads a case: killed by signal 11", err)

    def test_without_end_of_line(self):
        code, lines, err = self.certify("--time-out", "0.5", "--subject", "printf hello; sleep 60", "-", stdin=STREAM)
        self.assertEqual((code, lines), (4, []))
        self.assertIn("the subject said no hello within 10 s; 5 bytes came, no end of line: 'hello'", err)

    def test_no_such_program(self):
        code, lines, err = self.certify("--subject", "./no/such/program", "-", stdin=STREAM)
        self.assertEqual((code, lines), (4, []))
        self.assertIn("not found", err)

    def test_that_changes(self):
        code, _, err = self.certify("--jobs", "2", "--subject", liar("hello-changes"), "-", stdin=STREAM)
        self.assertEqual(code, 4)
        self.assertIn("says something else of itself each time", err)


if __name__ == "__main__":
    unittest.main()
