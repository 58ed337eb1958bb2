# SPDX-License-Identifier: GPL-3.0-or-later
"""Streams of cases: one line out for one line in, at once; bad cases are told and passed over; no input is never a success."""
import json
import os
import subprocess
import unittest

from harness import DATA, EXECUTABLE, PATIENCE, UNIT, CliTest, box, case

SHIFTED = box([0.75, 0.25, 0.125], [1.75, 1.25, 1.125])
GOOD = case(UNIT, SHIFTED, id="good")
LINE = "good: penetrating; depth 0.25; direction (-1, 0, 0); facet-facet\n"

# What stands on a line -> (id, part of the error)
BAD = {
    '{"id": "nan", "a": {"vertices": [[NaN, 0, 0]]}, "b": {"vertices": [[0, 0, 0]]}}': ("nan", "expected JSON"),
    '{"id": "nan", "a": {"vertices": [["nan", 0, 0]]}, "b": {"vertices": [[0, 0, 0]]}}': ("nan", "'nan'"),
    '{"id": "inf", "a": {"vertices": [["inf", 0, 0]]}, "b": {"vertices": [[0, 0, 0]]}}': ("inf", "'inf'"),
    '{"id": "big", "a": {"vertices": [[1e400, 0, 0]]}, "b": {"vertices": [[0, 0, 0]]}}': ("big", "1e400"),
    '{"id": "vast", "a": {"vertices": [["1e100001", 0, 0]]}, "b": {"vertices": [[0, 0, 0]]}}': ("vast", "1e100001"),
    '{"id": "none", "a": {"vertices": []}, "b": {"vertices": [[0, 0, 0]]}}': ("none", "a.vertices"),
    '{"id": "text", "a": {"vertices": [["x", 0, 0]]}, "b": {"vertices": [[0, 0, 0]]}}': ("text", "expected a number"),
    '{"id": "two", "a": {"vertices": [[0, 0]]}, "b": {"vertices": [[0, 0, 0]]}}': ("two", "a.vertices[0]"),
    '{"id": "lone", "a": {"vertices": [[0, 0, 0]]}}': ("lone", "'b'"),
    '{"id": "cut", "a": {"vertices": [[0, 0': ("cut", "expected JSON"),
    '[]': (None, "expected"),
    'noise \x01\x02': (None, "expected JSON"),
}


class Results(CliTest):
    def test_text_and_json(self):
        for arguments in (["-"], [self.file("cases.jsonl", GOOD)], [self.file("cases", GOOD)], [self.file("case.json", GOOD)]):
            self.assertEqual(self.run_cli("depth", *arguments, stdin=GOOD), (0, LINE, ""))
            self.assertEqual(self.result("depth", *arguments, stdin=GOOD)["id"], "good")

    def test_agrees_with_meshes(self):
        single = self.result("depth", "--counters", "--digits", "9", self.file("a.xyz", UNIT), self.file("b.xyz", SHIFTED))
        streamed = self.result("depth", "--counters", "--digits", "9", "-", stdin=GOOD)
        self.assertEqual((single.pop("id") and streamed.pop("id")), "good")
        self.assertEqual(streamed, single)

    def test_options_in_text(self):
        out = self.answer("depth", "--method", "exact", "--digits", "3", "--counters", "-", stdin=GOOD)
        self.assertTrue(out.startswith(LINE[:LINE.index("; direction")] + "; in [0.25, 0.25]; direction "), out)
        self.assertIn("; vertices_a 8; ", out)
        self.assertEqual(out.count("\n"), 1)

    def test_ids(self):
        stream = "\n" + case(UNIT, UNIT) + case(UNIT, UNIT, id="two\nlines \u001b[2J") + "  \n" + case(UNIT, UNIT, id="\u00e9")
        ids = [json.loads(line)["id"] for line in self.answer("depth", "--json", "-", stdin=stream).splitlines()]
        self.assertEqual(ids, ["2", "two\nlines \x1b[2J", "\u00e9"])
        out = self.answer("depth", "-", stdin=stream)
        self.assertEqual(out.count("\n"), 3)
        self.assertNotIn("\x1b", out)

    def test_poses(self):
        self.assertEqual(self.result("depth", DATA / "posed_boxes.json")["depth"]["squared"], "1/16")

    def test_flat_and_ties(self):
        square = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]
        self.assertTrue(self.answer("depth", "-", stdin=case(square, box([-1, -1, -1], [2, 2, 1]))).endswith("; 2 ties; flat A\n"))

    def test_hulls_are_told_of(self):
        """With every method and status; exactly of the first such case, for a stream of many would take a hull each to tell."""
        inner, far = UNIT + [[0.5, 0.5, 0.5]], box([5, 5, 5], [6, 6, 6])
        said = ("fathom: <stdin>:2: B: 1 of 9 points are not extreme; the convex hull is taken; later cases are counted\n"
                "fathom: later cases that may have points which are not extreme: 1\n")
        for command in (["depth"], ["depth", "--method=exact"], ["depth", "--method=naive"], ["depth", "--method=shallow"], ["approx"],
                        ["ray", "--direction=1,0,0"], ["metric", "--ball", self.file("ball.xyz", box([-1, -1, -1], [1, 1, 1]))], ["study"]):
            for a in (UNIT, far):
                code, _, err = self.run_cli(*command, "-", stdin=GOOD + case(a, inner) + GOOD + case(inner, UNIT))
                self.assertEqual((code, err), (0, said), command)
        self.assertEqual(self.run_cli("width", "-", stdin=case(UNIT, inner))[2], "", "B is not looked at")


class BadCases(CliTest):
    def test_each_gets_its_line_and_the_rest_is_answered(self):
        stream = GOOD + "".join(line + "\n" + GOOD for line in BAD)
        code, out, err = self.run_cli("depth", "--json", "-", stdin=stream)
        self.assertEqual(code, 2)
        self.assertEqual(err, f"fathom: errors: {len(BAD)} of {2 * len(BAD) + 1} lines\n")
        results = [json.loads(line) for line in out.splitlines()]
        self.assertEqual(len(results), 2 * len(BAD) + 1)
        for result in results[::2]:
            self.assertEqual((result["id"], result["depth"]["squared"]), ("good", "1/16"))
        for number, (result, (name, says)) in enumerate(zip(results[1::2], BAD.values())):
            line = 2 * number + 2
            with self.subTest(line=line):
                self.assertEqual(list(result), ["schema", "id", "line", "error"])
                self.assertEqual((result["schema"], result["line"]), ("fathom/result/2", line))
                self.assertEqual(result["id"], name or str(line))
                self.assertTrue(result["error"].startswith(f"<stdin>:{line}: "), result["error"])
                self.assertIn("expected ", result["error"])
                self.assertIn(says, result["error"])

    def test_text_mode_tells_on_stderr(self):
        path = self.file("cases.jsonl", GOOD + next(iter(BAD)) + "\n" + GOOD)
        code, out, err = self.run_cli("depth", path)
        self.assertEqual((code, out), (2, LINE + LINE))
        self.assertTrue(err.startswith(f"fathom: {path}:2: expected JSON"), err)
        self.assertEqual(err.count("\n"), 1)

    def test_no_case_is_never_a_success(self):
        for content in ("", "\n \n", "\ufeff"):
            path = self.file("empty.jsonl", content)
            for command in ("depth", "width"):
                self.assertIn(f"{path}:1: expected at least one case", self.refused(command, path))
                self.assertIn("<stdin>:1: expected at least one case", self.refused(command, "-", stdin=content))
            code, out, _ = self.run_cli("depth", "--json", path)
            self.assertEqual((code, json.loads(out)["line"]), (2, 1))

    def test_truncated(self):
        for cut in (1, len(GOOD) // 2, len(GOOD) - 3):
            code, out, err = self.run_cli("depth", "-", stdin=GOOD + GOOD[:cut])
            self.assertEqual((code, out), (2, LINE), err)
            self.assertIn("fathom: <stdin>:2: expected JSON", err)
        self.assertEqual(self.run_cli("depth", "-", stdin=GOOD[:-1]), (0, LINE, ""))  # only the last newline is missing

    def test_inputs_that_are_no_files(self):
        self.assertIn("found a directory", self.refused("depth", self.folder))
        self.assertIn("found none of this name", self.refused("depth", self.folder / "missing.jsonl"))
        folder = os.open(self.folder, os.O_RDONLY)
        self.addCleanup(os.close, folder)
        done = subprocess.run([EXECUTABLE, "depth", "-"], stdin=folder, capture_output=True)
        self.assertEqual((done.returncode, done.stdout), (2, b""))
        self.assertIn(b"<stdin>:1: expected", done.stderr)


class Pipes(CliTest):
    def test_each_answer_comes_before_the_next_case_is_sent(self):
        for options in ([], ["--json"]):
            with subprocess.Popen([EXECUTABLE, "depth", *options, "-"], stdin=subprocess.PIPE, stdout=subprocess.PIPE) as process:
                for _ in range(3):
                    process.stdin.write(GOOD.encode())
                    process.stdin.flush()
                    self.assertIn(b"0.25", process.stdout.readline())
                process.stdin.close()
                self.assertEqual((process.stdout.read(), process.wait(PATIENCE)), (b"", 0))


if __name__ == "__main__":
    unittest.main()
