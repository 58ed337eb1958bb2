# SPDX-License-Identifier: GPL-3.0-or-later
"""Interrupts, readers that go away, output that cannot be written, and the progress bar."""
import json
import os
import pathlib
import pty
import random
import signal
import subprocess
import tempfile
import threading
import unittest

from harness import DATA, EXECUTABLE, PATIENCE, UNIT, CliTest, case
from terminals import run_on_terminal

A, B = str(DATA / "cube.off"), str(DATA / "icosahedron.off")
GOOD = case(UNIT, UNIT)


def on_sphere(count, seed):
    rng = random.Random(seed)
    points = [[rng.gauss(0, 1) for _ in range(3)] for _ in range(count)]
    return [[x / sum(y * y for y in point) ** 0.5 for x in point] for point in points]


# Far more than a second of work for the naive method, in little memory; a second or two; the former for the exact method.
LONG = case(on_sphere(1800, 1), on_sphere(1800, 2))
MIDDLE = case(on_sphere(400, 1), on_sphere(400, 2))


class Interrupts(CliTest):
    def interrupted(self, stream):
        """Sends the stream, waits for its first answer, interrupts."""
        with subprocess.Popen([EXECUTABLE, "depth", "--method", "naive", "-"], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE) as process:
            process.stdin.write(stream.encode())
            process.stdin.flush()
            self.assertIn(b"depth 1;", process.stdout.readline())
            process.send_signal(signal.SIGINT)
            self.assertEqual(process.stdout.read(), b"")
            self.assertEqual(process.stderr.read(), b"fathom: interrupted\n")
            self.assertEqual(process.wait(PATIENCE), 130)

    def test_while_waiting_for_input(self):
        self.interrupted(GOOD)

    def test_while_computing(self):
        self.interrupted(GOOD + LONG)

    def test_ignored_stays_ignored(self):
        """As in a shell's background job."""
        with subprocess.Popen([EXECUTABLE, "depth", "-"], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                              preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_IGN)) as process:
            for _ in range(2):
                process.stdin.write(GOOD.encode())
                process.stdin.flush()
                self.assertIn(b"depth 1;", process.stdout.readline())
                process.send_signal(signal.SIGINT)
            process.stdin.close()
            self.assertEqual(process.wait(PATIENCE), 0)


class Output(CliTest):
    def test_a_reader_that_has_enough(self):
        """As `| head -1` does: no message, no further work; also where the parent ignores SIGPIPE."""
        for ignored in (False, True):
            with subprocess.Popen([EXECUTABLE, "depth", "-"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                  restore_signals=not ignored) as process:
                process.stdin.write(GOOD.encode())
                process.stdin.flush()
                self.assertIn(b"depth 1;", process.stdout.readline())
                process.stdout.close()
                process.stdin.write(GOOD.encode())
                process.stdin.flush()
                self.assertEqual(process.stderr.read(), b"")
                self.assertEqual(process.wait(PATIENCE), -signal.SIGPIPE)

    def test_output_that_cannot_be_written(self):
        for arguments in (["depth", A, B], ["depth", "--json", A, B], ["width", A], ["--help"], ["--version"]):
            with open("/dev/full", "wb") as full:
                code, _, err = self.run_cli(*arguments, stdout=full)
            self.assertEqual((code, err), (3, "fathom: cannot write to standard output: No space left on device\n"))
            done = subprocess.run(["sh", "-c", 'exec "$@" >&-', "sh", EXECUTABLE, *arguments], capture_output=True)
            self.assertEqual((done.returncode, done.stderr), (3, b"fathom: cannot write to standard output: Bad file descriptor\n"))

    def test_no_report_takes_the_place_of_a_closed_stream(self):
        with tempfile.TemporaryDirectory() as folder:
            report = pathlib.Path(folder) / "report"
            cases = pathlib.Path(folder) / "cases"
            cases.write_text(case(UNIT, UNIT, id="good"))
            replies = pathlib.Path(folder) / "replies"
            replies.write_text('{"type":"reply","id":"good","overlap":false}\n')
            done = subprocess.run(["sh", "-c", 'exec "$@" <&- >&- 2>&-', "sh", EXECUTABLE, "certify", "--report", report, "--replay",
                                   replies, cases])
            self.assertEqual(done.returncode, 3)
            self.assertEqual([json.loads(line)["type"] for line in report.read_text().splitlines()], ["header", "case", "summary"])

    def test_closed_stderr_and_stdin(self):
        done = subprocess.run(["sh", "-c", 'exec "$@" 2>&- <&-', "sh", EXECUTABLE, "depth", A, B], capture_output=True)
        self.assertEqual(done.returncode, 0)
        self.assertTrue(done.stdout.startswith(b"penetrating\n"))
        done = subprocess.run(["sh", "-c", 'exec "$@" 2>&-', "sh", EXECUTABLE, "depth", A, "missing"], capture_output=True)
        self.assertEqual((done.returncode, done.stdout), (2, b""))
        done = subprocess.run(["sh", "-c", 'exec "$@" <&-', "sh", EXECUTABLE, "depth", "-"], capture_output=True)
        self.assertEqual((done.returncode, done.stdout), (2, b""))


class Bar(CliTest):
    def test_none_without_a_terminal(self):
        code, _, err = self.run_cli("depth", "--method", "naive", "-", stdin=MIDDLE)
        self.assertEqual((code, err), (0, ""))

    def test_none_for_short_work(self):
        code, out, seen = run_on_terminal("depth", A, B)
        self.assertEqual((code, seen), (0, b""))
        self.assertTrue(out.startswith(b"penetrating\n"))

    def test_long_work_on_a_terminal(self):
        """Shown, and wiped before the last words; whether the stage can be interrupted or not."""
        path = self.file("long.jsonl", LONG)
        code, out, seen = run_on_terminal("depth", "--method", "naive", path, stop_at=b"hull of all differences")
        self.assertEqual((code, out), (130, b""))
        self.assertRegex(seen, rb"\r\x1b\[K\[\.+\]   0% 0 of 1 cases; line 1: hull of all differences, \d+ s\r")
        self.assertTrue(seen.endswith(b"\r\x1b[Kfathom: interrupted\r\n"), seen[-80:])

        a, b = self.file("a.xyz", on_sphere(80000, 1)), self.file("b.xyz", on_sphere(80000, 2))
        code, out, seen = run_on_terminal("depth", "--method", "exact", a, b, stop_at=b"% ")
        self.assertEqual((code, out), (130, b""))
        self.assertTrue(seen.endswith(b"\r\x1b[Kfathom: interrupted\r\n"), seen[-80:])

    def test_fits_the_terminal(self):
        path = self.file("long.jsonl", LONG)
        for columns in (20, 40, 60):
            code, _, seen = run_on_terminal("depth", "--method", "naive", path, stop_at=b"0 of 1", columns=columns)
            self.assertEqual(code, 130)
            lines = seen.replace(b"fathom: interrupted\r\n", b"").split(b"\r\x1b[K")
            self.assertGreater(max(map(len, lines)), columns // 2, lines)
            self.assertLess(max(map(len, lines)), columns, lines)
            for line in lines:  # what does not fit whole is left out: half a number says another one
                self.assertRegex(line, rb"^((\[[#.]+\] +\d+% )?0 of 1 cases(; line 1: hull[a-z ]*, \d+ s)?)?$")

    def test_short_cases_into_a_file(self):
        """The number of cases is shown, and stays from case to case; it is wiped at the end."""
        ours, theirs = pty.openpty()
        with subprocess.Popen([EXECUTABLE, "depth", "-"], stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, stderr=theirs) as process:
            os.close(theirs)
            enough = threading.Event()

            def feed():
                while not enough.is_set():
                    process.stdin.write(GOOD.encode() * 100)
                process.stdin.close()

            writer = threading.Thread(target=feed)
            writer.start()
            seen = b""
            try:
                while True:
                    seen += os.read(ours, 4096)
                    if seen.count(b" cases") >= 3:
                        enough.set()
            except OSError:  # the other side is closed
                enough.set()
            writer.join()
            os.close(ours)
            self.assertEqual(process.wait(PATIENCE), 0)
        shown = seen.split(b"\r\x1b[K")
        self.assertEqual((shown[0], shown[-1]), (b"", b""), seen)
        for line in shown[1:-1]:
            self.assertRegex(line, rb"^\d+ cases, [\d.e+]+/s, \d+ s$", "not wiped between cases")

    def test_counts_cases_and_says_time_left(self):
        """Of a file it is known how many there are, also where a case takes several lines. The last one takes long, and is named."""
        several_lines = json.dumps(json.loads(GOOD), indent=1) + "\n"
        path = self.file("cases.jsonl", GOOD + several_lines + GOOD + LONG)
        code, out, seen = run_on_terminal("depth", "--threads", "1", "--method", "naive", path, stop_at=b"hull of all differences",
                                          columns=160)
        self.assertEqual((code, out.count(b"\n")), (130, 3))
        self.assertRegex(seen, rb"\[#+\.+\]  75% 3 of 4 cases, [\d.]+/s, [\d hmins]+ left; line \d+: hull of all differences, \d+ s")
        self.assertTrue(seen.endswith(b"\r\x1b[Kfathom: interrupted\r\n"), seen[-80:])


if __name__ == "__main__":
    unittest.main()
