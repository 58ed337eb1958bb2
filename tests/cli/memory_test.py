# SPDX-License-Identifier: GPL-3.0-or-later
"""Where memory ends: a message and exit code 3, and a stream loses the case that does not fit and no other. Never a signal."""
import json
import math
import resource
import subprocess
import unittest

from harness import DATA, EXECUTABLE, PATIENCE, UNIT, VERSION, CliTest, box, case

GOOD = case(UNIT, box([0.75, 0.25, 0.125], [1.75, 1.25, 1.125]), id="good")
MIB = 1 << 20
A_MEMORY_MESSAGE = r"^fathom: (out of memory|internal error: pthread_create has failed: .*)\n$"  # the latter is oneTBB's


def spread(count):
    """Points on a sphere, of doubles that need all their bits."""
    turn = math.pi * (3 - math.sqrt(5))
    heights = [(2 * i + 1) / count - 1 for i in range(count)]
    return [[math.cos(turn * i) * math.sqrt(1 - z * z), math.sin(turn * i) * math.sqrt(1 - z * z), z] for i, z in enumerate(heights)]


HUGE = spread(200000)


def run_within(limit, *arguments, stdin=b""):
    """(exit code, stdout, stderr) of a run within so many bytes of address space."""
    done = subprocess.run([EXECUTABLE, *map(str, arguments)], input=stdin, capture_output=True, timeout=PATIENCE,
                          preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)))
    return done.returncode, done.stdout.decode(), done.stderr.decode()


def least_limit():
    """In steps of a MiB, what an answer to two cubes takes; None where no limit works, as under AddressSanitizer."""
    for limit in range(16, 512):
        if run_within(limit * MIB, "depth", DATA / "cube.off", DATA / "cube.off")[0] == 0:
            return limit * MIB
    return None


LEAST = least_limit()


@unittest.skipIf(LEAST is None, "this build does not run within a limit on its address space")
class OutOfMemory(CliTest):
    def test_meshes(self):
        mesh = self.file("sphere.xyz", HUGE)
        for more in (0, 24):
            for command in (["depth", "--method", "exact"], ["width"], ["study"], ["approx"]):
                inputs = [mesh] if command == ["width"] else [mesh, mesh]
                with self.subTest(more=more, command=command):
                    self.assertEqual(run_within(LEAST + more * MIB, *command, *inputs), (3, "", "fathom: out of memory\n"))

    def test_threads_that_would_take_all_of_it_are_not_begun(self):
        stream = GOOD.encode() * 300
        self.assertEqual(run_within(2000 * MIB, "depth", "--threads", "1024", "-", stdin=stream),
                         (0, self.answer("depth", "-", stdin=GOOD * 300), ""))

    def test_a_stream_loses_what_does_not_fit_and_nothing_else(self):
        """At limits where a huge case ends while it is read, and while it is solved: by C++'s vectors, and by GMP's numbers."""
        huge = case(HUGE[::3], HUGE[1::3], id="huge").encode()
        longer = b'{"padding": "' + b"x" * (64 * MIB) + b'", ' + huge[1:]
        stream = GOOD.encode() + huge + GOOD.encode() + longer + GOOD.encode()
        ids = set()
        for more in range(1, 130, 32):
            with self.subTest(more=more):
                code, out, err = run_within(LEAST + more * MIB, "depth", "--method", "exact", "--json", "-", stdin=stream)
                self.assertEqual((code, err), (3, "fathom: errors: 2 of 5 lines\n"))
                rows = [json.loads(line) for line in out.splitlines()]
                self.assertEqual([row["id"] for row in rows[::2]], ["good"] * 3)
                self.assertEqual([row["depth"]["squared"] for row in rows[::2]], ["1/16"] * 3)
                for line, row in zip((2, 4), rows[1::2]):
                    self.assertEqual((row["line"], row["error"]), (line, f"<stdin>:{line}: out of memory"))
                    ids.add(row["id"])
        self.assertEqual(ids, {"4", "huge"})  # lost while it was read, and later

    def test_in_words(self):
        huge = case(HUGE, UNIT, id="huge")
        code, out, err = run_within(LEAST + MIB, "depth", "-", stdin=(GOOD + huge + GOOD).encode())
        self.assertEqual((code, out.count("good: penetrating; depth 0.25;"), err), (3, 2, "fathom: <stdin>:2: out of memory\n"))

    def test_certify(self):
        """Replies are there for all: only the exact answer to one of them does not fit."""
        cases = GOOD + case(HUGE, UNIT, id="huge") + case(UNIT, UNIT, id="last")
        replies = "".join(json.dumps({"type": "reply", "id": name, "overlap": True, "depth": depth}) + "\n"
                          for name, depth in (("good", 0.25), ("huge", 1), ("last", 1)))
        arguments = ["certify", "--json", "--replay", self.file("replies.jsonl", replies), self.file("cases.jsonl", cases)]
        code, out, err = run_within(LEAST + MIB, *arguments, "--jobs", "1")
        rows = [json.loads(line) for line in out.splitlines()]
        self.assertEqual([row["id"] for row in rows if row.get("verdict") == "pass"], ["good", "last"], err)
        self.assertEqual(code, 3)
        self.assertRegex(err, "^fathom: ([^\\n]*:2|huge): out of memory\\n")
        code, _, err = run_within(LEAST + MIB, *arguments, "--jobs", "64")  # more threads than fit
        self.assertEqual(code, 3)
        self.assertIn("out of memory\n", err)

    def test_golden(self):
        for limit in range(LEAST, LEAST + 64 * MIB, 16 * MIB):
            with self.subTest(limit=limit):
                code, out, err = run_within(limit, "golden", "generate", "--level", "L0", "--out", self.folder / f"{limit}")
                if code != 0:
                    self.assertEqual((code, out), (3, ""))
                    self.assertRegex(err, A_MEMORY_MESSAGE)
                code, out, err = run_within(limit, "golden", "verify", DATA / "golden")
                if code != 0:
                    self.assertEqual((code, out), (3, ""))
                    self.assertRegex(err, A_MEMORY_MESSAGE)

    def test_not_even_a_start(self):
        """Below what the allocator asks for before main()."""
        started = [run_within(limit, "--version") for limit in range(LEAST // 2, LEAST, 4 * MIB)]
        for code, out, err in started:  # 0: an allocator asks for a little more or less from run to run
            if code == 0:
                self.assertEqual((out.splitlines()[0], err), (f"fathom {VERSION}", ""))
            else:
                self.assertIn((code, out, err), [(3, "", "fathom: out of memory\n"), (127, "", err)])


class LongLines(CliTest):
    def test_an_input_without_an_end(self):
        with open("/dev/zero", "rb") as zero:
            done = subprocess.run([EXECUTABLE, "depth", "-"], stdin=zero, capture_output=True, timeout=PATIENCE)
        self.assertEqual((done.returncode, done.stdout, done.stderr.decode()),
                         (2, b"", "fathom: <stdin>:1: expected a case of at most 256 MiB, found one without an end\n"))


if __name__ == "__main__":
    unittest.main()
