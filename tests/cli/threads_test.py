# SPDX-License-Identifier: GPL-3.0-or-later
"""Streams on several threads: the bytes that one thread prints, in order, with the same messages and exit code; no answer waits."""
import json
import os
import subprocess
import unittest

from harness import DATA, EXECUTABLE, PATIENCE, UNIT, CliTest, box, case

SHIFTED = box([0.75, 0.25, 0.125], [1.75, 1.25, 1.125])
INNER = UNIT + [[0.5, 0.5, 0.5]]
GOOD = case(UNIT, SHIFTED, id="good")
LINE = b"good: penetrating; depth 0.25; direction (-1, 0, 0); facet-facet\n"
THREADS = ("1", "2", "5")


def families():
    """Pairs of ten families, which take from microseconds to tens of milliseconds: what is begun later is often ready sooner."""
    for family in ("random_sphere", "near_ties", "boxes_posed", "crossed_fans", "needles"):
        for size in ("8", "40"):
            yield subprocess.run([EXECUTABLE, "cases", "--family", family, "--size", size, "--count", "3"], capture_output=True,
                                 check=True).stdout.decode()


def mixed():
    """Good and bad cases; without, and then with, points that are not extreme; touching, disjoint and flat ones; one over many lines; one
    whose text is long; ids that occur twice; a last line that is cut short."""
    bad = ["noise\n", '{"id": "lone", "a": {"vertices": [[0, 0, 0]]}}\n', "{}\n", "\n", case(UNIT, [[1e300, "x", 0]], id="text"),
           case(UNIT, UNIT, id="twice", schema="other").replace("fathom/case/1", "other")]
    shapes = [case(UNIT, box([1, 0, 0], [2, 1, 1]), id="touching"), case(UNIT, box([3, 3, 3], [4, 4, 4]), id="disjoint"),
              case([[0, 0, 0], [1, 0, 0], [0, 1, 0]], UNIT, id="flat"), case([[0.5, 0.5, 0.5]], UNIT, id="point"),
              case(INNER, UNIT, id="inner"), case(UNIT, INNER, id="good"), case(UNIT, SHIFTED),
              case(UNIT, SHIFTED, comment="x" * (1 << 20)),
              "{\n" + GOOD.lstrip("{").rstrip("}\n") + "\n}\n"]
    made = [line for text in families() for line in text.splitlines(keepends=True)]
    lines = []
    for i, line in enumerate(made):
        lines += [line, bad[i % len(bad)]] if i % 3 == 0 else [line, shapes[i % len(shapes)]]
    return GOOD + "".join(lines) + "".join(shapes) + "".join(bad) + GOOD + GOOD[:30]


class TheSameBytes(CliTest):
    def test_every_command(self):
        stream = mixed()
        path = self.file("cases.jsonl", stream)
        ball = self.file("ball.xyz", box([-1, -1, -1], [1, 1, 1]))
        commands = [["depth"], ["depth", "--json"], ["depth", "--json", "--method=exact", "--counters", "--digits=20"],
                    ["depth", "--json", "--embed-certificate"], ["width", "--json"], ["width", "--delta=1/2"], ["approx", "--delta=1/2"],
                    ["approx", "--delta=1/2", "--json"], ["ray", "--direction=1,2,3"], ["ray", "--direction=1,2,3", "--json"],
                    ["ray", "--growth"], ["ray", "--growth", "--json"],
                    ["metric", "--ball", ball], ["metric", "--ball", ball, "--json"], ["study"], ["study", "--json"], ["study", "--csv"]]
        for command in commands:
            with self.subTest(command=command):
                one = self.run_cli(*command, "--threads=1", "-", stdin=stream)
                self.assertEqual(one[0], 2)
                self.assertGreater(one[1].count("\n"), 40)
                self.assertRegex(one[2], r"<stdin>:\d+: [AB]: 1 of 9 points are not extreme")
                for threads in THREADS[1:] + (None,):
                    options = ["--threads", threads] if threads else []
                    self.assertEqual(self.run_cli(*command, *options, "-", stdin=stream), one)
                    code, out, err = self.run_cli(*command, *options, path)
                    self.assertEqual((code, out.replace(path, "<stdin>"), err.replace(path, "<stdin>")), one)

    def test_certificates(self):
        """The first of two cases with one id gets the file."""
        stream, told, files = mixed(), [], []
        for threads in THREADS:
            folder = self.folder / f"proofs{threads}"
            code, out, err = self.run_cli("depth", "--certificate", folder, "--threads", threads, "-", stdin=stream)
            told.append((code, out, err.replace(str(folder), "FOLDER")))
            files.append({path.name: path.read_bytes() for path in folder.iterdir()})
        self.assertIn("it belongs to an earlier case with the same id", told[0][2])
        self.assertGreater(len(files[0]), 30)
        self.assertEqual(told[1:], told[:1] * 2)
        self.assertEqual(files[1:], files[:1] * 2)

    def test_more_cases_than_are_under_way(self):
        """Each is answered in its place."""
        stream = "".join(case(UNIT, box([0.5, 0, 0], [1.5, 1, 1]), id=f"n{i}") for i in range(3000))
        for threads in THREADS:
            out = self.answer("depth", "--json", "--threads", threads, "-", stdin=stream)
            self.assertEqual([json.loads(line)["id"] for line in out.splitlines()], [f"n{i}" for i in range(3000)])


def certificates():
    """Texts of certificates: good, refused, malformed in many ways, with comments, cut short, one of very many lines."""
    names = sorted((DATA / "certificates").glob("*.cert"))
    good = [name.read_text() for name in names if "bounds" not in name.name]
    texts = ["# a comment\n"] + good + [name.read_text() for name in sorted((DATA / "certificates" / "refused").glob("*.cert"))]
    for i, text in enumerate(good):
        lines = text.splitlines(keepends=True)
        for changed in (text.replace("claim depth 1", "claim depth 2"), "".join(lines[:len(lines) // 2]), "".join(lines[1:]),
                        "".join(reversed(lines)), text + "garbage\n", text.replace("\nend ", "\nend 1"), text.replace("id ", "id %")):
            texts += [changed, good[(i + 1) % len(good)]]
    points = "".join(f"{i} {i * i} 0\n" for i in range(12000))
    texts += [f"fathom-certificate 1\nid many\na 12000\n{points}b 12000\n{points}claim touching\n", good[0], good[0][:-5]]
    return texts


class Check(CliTest):
    """`fathom check`, beside the checker's own program, which has one thread."""

    def compare(self, *arguments, stdin=""):
        done = subprocess.run([os.environ["FATHOM_CHECK"], *map(str, arguments)], input=stdin.encode(), capture_output=True,
                              timeout=PATIENCE)
        one = done.returncode, done.stdout.decode(), done.stderr.decode()
        for threads in THREADS:
            self.assertEqual(self.run_cli("check", "--threads", threads, *arguments, stdin=stdin), one)
        self.assertEqual(self.run_cli("check", *arguments, stdin=stdin), one)
        return one

    def test_certificates(self):
        texts = certificates()
        code, out, _ = self.compare("-", stdin="".join(texts))
        self.assertEqual(code, 2)
        for word in ("VERIFIED", "REFUSED", "MALFORMED"):
            self.assertGreater(out.count(f"s {word} "), 5, out)
        self.compare("--echo", "-", stdin="".join(texts))
        files = [self.file(f"{i}.cert", text) for i, text in enumerate(texts)]
        code, out, _ = self.compare(*files[:9], "missing.cert", "-", self.folder, *files[9:], stdin="".join(texts[:5]))
        self.assertIn("missing.cert:0: cannot be opened", out)
        self.compare("-", stdin="")

    def test_results(self):
        stream = mixed()
        results = self.run_cli("depth", "--json", "--embed-certificate", "-", stdin=stream)[1]
        lines = results.splitlines(keepends=True)
        bad = ["noise\n", "\n", lines[0].replace('"penetrating"', '"touching"'), lines[0].replace("claim", "blame"), "{}\n",
               lines[0].replace("{", '{"x":"' + "y" * (1 << 20) + '",', 1)]
        text = "".join(line + bad[i % len(bad)] for i, line in enumerate(lines)) + lines[0][:-9]
        for options in ([], ["--echo"], ["--case", self.file("case.jsonl", GOOD)]):
            code, out, _ = self.compare(*options, "--results", "-", stdin=text)
            self.assertEqual(code, 2)
            self.assertGreater(out.count("s MALFORMED "), 20)
            self.assertGreater(out.count("s VERIFIED "), 1)
        self.compare("--results", "-", stdin="\n")
        self.compare("--results", self.folder, stdin="")

    def test_each_verdict_comes_before_the_next_certificate_is_sent(self):
        text = (DATA / "certificates" / "depth_cubes.cert").read_bytes()
        for threads in THREADS:
            with subprocess.Popen([EXECUTABLE, "check", f"--threads={threads}", "-"], stdin=subprocess.PIPE,
                                  stdout=subprocess.PIPE) as process:
                for count in (1, 3, 1):
                    process.stdin.write(text * count)
                    process.stdin.flush()
                    for _ in range(count):
                        self.assertIn(b"s VERIFIED ", process.stdout.readline())
                process.stdin.close()
                self.assertEqual((process.stdout.read(), process.wait(PATIENCE)), (b"", 0))

    def test_words(self):
        for words in (["--threads"], ["--threads", "0", "-"], ["--threads=x", "-"], ["--threads", "2", "--proved", "-"]):
            self.assertIn("--threads", self.refused("check", *words))
        self.assertIn("--threads N", self.answer("check", "--help"))
        self.assertIn("cannot be opened", self.run_cli("check", "--", "--threads")[1])


class NoAnswerWaits(CliTest):
    def start(self, threads, *inputs, **pipes):
        process = subprocess.Popen([EXECUTABLE, "depth", "--threads", threads, *(inputs or ["-"])], stderr=subprocess.PIPE, **pipes)
        self.addCleanup(process.stderr.close)
        return process

    def test_for_the_rest_of_the_stream(self):
        """Each case comes after the answers to all before it; a part of the next may be there."""
        for threads in THREADS:
            with self.start(threads, stdin=subprocess.PIPE, stdout=subprocess.PIPE) as process:
                sent = 0  # of the next case, in bytes
                for count in (1, 1, 2, 7, 1, 40, 3, 1):
                    process.stdin.write((GOOD * count)[sent:].encode() + GOOD[:20].encode())
                    process.stdin.flush()
                    sent = 20
                    self.assertEqual([process.stdout.readline() for _ in range(count)], [LINE] * count)
                process.stdin.write(GOOD[sent:].encode())
                process.stdin.close()
                self.assertEqual((process.stdout.read(), process.wait(PATIENCE)), (LINE, 0))

    def test_in_a_pipe_with_a_name(self):
        for threads in THREADS:
            path = self.folder / f"pipe{threads}"
            os.mkfifo(path)
            with self.start(threads, path, stdout=subprocess.PIPE) as process, open(path, "wb") as pipe:
                for _ in range(2):
                    pipe.write(GOOD.encode())
                    pipe.flush()
                    self.assertEqual(process.stdout.readline(), LINE)
                pipe.close()
                self.assertEqual((process.stdout.read(), process.wait(PATIENCE)), (b"", 0))

    def test_output_that_cannot_be_written_ends_the_run(self):
        """Though the input is still open."""
        for threads in THREADS:
            with open("/dev/full", "wb") as full, self.start(threads, stdin=subprocess.PIPE, stdout=full) as process:
                process.stdin.write(GOOD.encode())
                process.stdin.flush()
                self.assertEqual(process.stderr.read(), b"fathom: cannot write to standard output: No space left on device\n")
                self.assertEqual(process.wait(PATIENCE), 3)


if __name__ == "__main__":
    unittest.main()
