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
    "empty-line": ("garbage", "expected a JSON object, found an empty line"), "noise": ("garbage", "expected a JSON object, found '\\x00"),
    "no-fields": ("garbage", 'expected "overlap" in the reply, found none'), "wrong-types": ("garbage", 'expected a number for "depth"'),
    "array": ("garbage", "expected a JSON object"), "nested": ("garbage", "expected a JSON object, found '[[["),
    "huge-line": ("garbage", "a line of more than 16777216 bytes"), "half-line": ("garbage", "a line that was cut off: '{"),
    "cut-line": ("garbage", "a line that was cut off: '{"), "other-id": ("garbage", "found one to '99999'"),
    "no-id": ("garbage", 'expected "id" in the reply, found none'), "twice": ("garbage", "more than its reply: '{"),
    "close-output": ("silent", "closed its output and lived on"), "linger": ("crash", "ended with exit code 9"),
    "second-hello": ("garbage", 'expected a message of type "reply"'), "dribble": ("pass", None),
}
# Those where no answer can come.
ENDLESS = {"hang": "no answer within 0.5 s", "busy": "no answer within 0.5 s", "dribble-forever": "no answer within 0.5 s",
           "flood": "no answer within 0.5 s; last words: "}


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

    def test_stops_reading(self):
        """A case larger than a pipe holds."""
        many = [[i / 1000, i % 7, i % 11] for i in range(20000)]
        stream = boxes(0) + boxes(1).replace("[2, 1, 1]", "[2, 1, 1], " + str(many)[1:-1])
        code, lines, _ = self.certify("--jobs", "1", "--time-out", "0.5", "--subject", liar("deaf"), "-", stdin=stream)
        self.assertEqual((code, self.verdicts(lines)), (1, {"box::0": "pass", "box::1": "time-out"}))
        self.assertRegex(lines[2]["detail"], r"no answer within 0.5 s; it has not read the last \d+ of the case's \d+ bytes")

    def test_no_fault_of_any_case(self):
        for way in ("one-shot", "twice-late", "ignore-stop"):
            with self.subTest(way):
                code, lines, err = self.certify("--jobs", "1", "--subject", liar(way), "-", stdin=STREAM)
                self.assertEqual((code, set(self.verdicts(lines).values())), (0, {"pass"}), err)
                if way != "ignore-stop":
                    self.assertRegex(err, "^fathom: (between two cases the subject wrote|the subject (ended|answered an earlier case))")

    def test_unsupported_is_not_judged(self):
        code, lines, _ = self.certify("--subject", liar("unsupported"), "-", stdin=STREAM)
        self.assertEqual((code, self.verdicts(lines)["box::1"]), (0, "unsupported"))
        code, lines, err = self.certify("--subject", liar("unsupported"), "-", stdin=boxes(1, marked=True))
        self.assertEqual((code, err), (4, "fathom: no case was judged: the subject declined all of them\n"))

    def test_overflow_of_binary32(self):
        stream = boxes(0) + boxes(1).replace("[[1,", "[[1e39,")
        code, lines, _ = self.certify("--subject", liar("binary32"), "-", stdin=stream)
        self.assertEqual((code, self.verdicts(lines)), (0, {"box::0": "pass", "box::1": "unsupported"}))


class Hellos(CertifyTest):
    def test_wrong_ones(self):
        for way, told in {"hello-silent": "the subject said no hello: ended with exit code 0",
                          "hello-crash": "the subject said no hello: killed by signal 11 (Segmentation fault); last words: about to go",
                          "hello-garbage": "the subject's hello is wrong: expected a JSON object, found 'liar 1.0, ready'",
                          "hello-without-name": "the subject's hello is wrong: expected \"name\" in the hello, found none",
                          "hello-without-unit": "the subject's hello is wrong: expected \"unit\" in the hello's conventions, found none",
                          "hello-other-protocol": "hello is wrong: expected protocol fathom/subject/1, found 'fathom/subject/2'",
                          "hello-precision": "expected binary64, binary32 for \"precision\" in the hello, found 'binary16'"}.items():
            with self.subTest(way):
                code, lines, err = self.certify("--subject", liar(way), "-", stdin=STREAM)
                self.assertEqual((code, lines), (4, []))
                self.assertIn(told, err)
                self.assertIn("nothing was judged", err)

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
