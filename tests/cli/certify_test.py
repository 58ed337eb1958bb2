# SPDX-License-Identifier: GPL-3.0-or-later
"""fathom certify: its options, its exit codes, its bar of progress."""
import json
import math
import os
import pty
import re
import shutil
import subprocess
import unittest

from certify_harness import CertifyTest, boxes, liar
from harness import DATA, EXECUTABLE, PATIENCE
from terminals import run_on_terminal


class Runs(CertifyTest):
    def test_table(self):
        code, out, err = self.run_cli("certify", "--subject", liar("too-deep"), "-", stdin=boxes(0) + boxes(1, marked=True))
        self.assertEqual((code, err), (1, ""))
        self.assertTrue(out.startswith("liar 1 (binary64)\n"), out)
        self.assertTrue(out.endswith("2 cases: 1 pass, 1 fail\n"), out)

    def test_jobs_find_the_same(self):
        stream = "".join(boxes(i, marked=i % 5 == 0) for i in range(30))
        found = [self.certify("--jobs", jobs, "--subject", liar("crash"), "-", stdin=stream) for jobs in ("1", "4")]
        self.assertEqual(*(self.verdicts(lines) for _, lines, _ in found))
        self.assertEqual(sum(v == "crash" for v in self.verdicts(found[0][1]).values()), 6)

    def test_bad_cases_among_good_ones(self):
        stream = "noise\n" + boxes(0) + boxes(0) + '{"id": "cut"\n' + boxes(1)
        code, lines, err = self.certify("--subject", liar("honest"), "-", stdin=stream)
        self.assertEqual((code, self.verdicts(lines)), (2, {"box::0": "pass", "box::1": "pass"}))
        self.assertIn("<stdin>:3: the id 'box::0' was there before", err)
        self.assertEqual(err.count("\n"), 3, err)

    def test_no_cases(self):
        for stream in ("", "\n\n", "noise\n"):
            code, lines, err = self.certify("--subject", liar("honest"), "-", stdin=stream)
            self.assertIn(code, (2, 4), err)
            self.assertEqual(self.verdicts(lines), {})

    def test_tolerance(self):
        stream = boxes(1, marked=True)
        for words, code in ((["--tol-rel", "0.6"], 0), (["--tol-rel", "1/3"], 1), (["--tol-abs", "1"], 0),
                            (["--tol-ulps", "18446744073709551615"], 0)):
            self.assertEqual(self.certify(*words, "--subject", liar("too-deep"), "-", stdin=stream)[0], code, words)

    def test_max_errors(self):
        stream = boxes(0) + boxes(1, marked=True) + boxes(2, marked=True)
        for most, code in ((0, 1), (1, 1), (2, 0)):
            self.assertEqual(self.certify("--max-errors", most, "--subject", liar("nan"), "-", stdin=stream)[0], code)

    def test_metamorphic(self):
        code, lines, _ = self.certify("--metamorphic=swap,scale", "--subject", liar("honest"), "-", stdin=boxes(0))
        self.assertEqual((code, self.verdicts(lines)), (0, {"box::0": "pass", "box::0~swap": "pass", "box::0~scale": "pass"}))
        self.assertEqual(lines[-1]["cases"], 3)
        # Scaled by 1024, the first point of A is where the liar lies.
        code, lines, _ = self.certify("--metamorphic=scale", "--subject", liar("too-deep"), "-", stdin=boxes(0))
        self.assertEqual((code, self.verdicts(lines)), (1, {"box::0": "pass", "box::0~scale": "too-deep"}))

    def test_certificates(self):
        folder = self.folder / "proofs"
        stream = boxes(0) + boxes(1, marked=True)
        code, _, _ = self.run_cli("certify", "--certificates", folder, "--subject", liar("crash"), "-", stdin=stream)
        self.assertEqual((code, [path.name for path in folder.iterdir()]), (1, ["box%3A%3A1.cert"]))
        out = self.answer("check", folder / "box%3A%3A1.cert")
        self.assertTrue(out.startswith("s VERIFIED penetrating depth_squared="), out)

    def test_a_case_whose_certificate_no_checker_would_read_goes_without(self):
        """An id of 6 MB, of which each byte takes three there, makes a line that passes the limit."""
        folder = self.folder / "proofs"
        stream = boxes(0, marked=True).replace("box::0", " " * 6000000) + boxes(1, marked=True)
        code, _, err = self.run_cli("certify", "--certificates", folder, "--subject", liar("crash"), "-", stdin=stream)
        self.assertEqual((code, [path.name for path in folder.iterdir()]), (1, ["box%3A%3A1.cert"]), err[-500:])
        self.assertIn("no certificate is written, since all checkers would refuse to read it: expected 'a'", err)

    def test_ids_too_long_for_the_name_of_a_file(self):
        long = "x" * 300
        stream = boxes(0, marked=True).replace("box::0", long) + boxes(1, marked=True).replace("box::1", long + "y") + boxes(2)
        code, lines, err = self.certify("--certificates", self.folder / "proofs", "--shrink", self.folder / "small", "--html",
                                        self.folder / "page", "--junit", self.folder / "junit", "--report", self.folder / "r", "--subject",
                                        liar("too-deep"), "-", stdin=stream)
        self.assertEqual((code, lines[-1]["failed"]), (1, 2), err)
        self.assertEqual(len(list((self.folder / "proofs").iterdir())), 2)

    def test_one_case_as_lines_to_paste(self):
        """--print-input writes what the subject would read, and the subject answers it."""
        path = self.file("cases.jsonl", boxes(1) + boxes(2))
        code, out, err = self.run_cli("certify", "--subject", liar("honest"), "--print-input", "box::2", path)
        hello, run, stop = map(json.loads, out.splitlines())
        self.assertEqual((code, hello["type"], run["type"], stop), (0, "hello", "run", {"type": "stop"}), err)
        self.assertEqual([run[body]["vertices"] for body in "ab"], [json.loads(boxes(2))[body]["vertices"] for body in "ab"])
        done = subprocess.run(liar("honest"), shell=True, input=out, stdout=subprocess.PIPE, text=True, timeout=PATIENCE, check=False)
        answer = json.loads(done.stdout.splitlines()[-1])
        self.assertEqual((answer["id"], answer["depth"]), (run["id"], 0.498))
        code, _, err = self.run_cli("certify", "--subject", liar("honest"), "--print-input", "box::3", path)
        self.assertEqual(code, 2)
        self.assertIn("box::3", err)

    def test_it_says_why_no_case_was_judged(self):
        wide = boxes(0).replace("[[1,", "[[1e39,")
        self.assertNotEqual(wide, boxes(0))
        code, _, err = self.run_cli("certify", "--subject", liar("binary32"), "-", stdin=wide)
        self.assertEqual((code, err), (4, "fathom: no case was judged: none could be put to the subject: a coordinate overflows binary32, "
                                          "the precision of the subject\n"))

    def test_long_time_outs(self):
        for seconds in ("1e6", "1e9", "1e30", "1e400"):
            code, lines, err = self.certify("--time-out", seconds, "--subject", liar("honest"), "-", stdin=boxes(0))
            self.assertEqual((code, self.verdicts(lines), err), (0, {"box::0": "pass"}, ""))

    def test_adapters(self):
        names = [line.split()[0] for line in self.answer("certify", "--list-adapters").splitlines()]
        self.assertEqual(len(names), len(set(names)))
        self.assertIn("libccd-epa", names)
        self.refused("certify", "--adapter", "libccd", DATA / "real_cases.jsonl")

    def test_adapters_of_unions(self):
        """The key is one half deep in a piece of the comb, and that is not enough."""
        for name in ("libccd-epa", "fcl-signed"):
            with self.subTest(name):
                if re.search(rf"^{name} .*not built", self.answer("certify", "--list-adapters"), re.MULTILINE):
                    self.skipTest(f"{name} is not built")
                _, lines, err = self.certify("--adapter", name, DATA / "unions.jsonl")
                self.assertEqual(lines[1]["id"], "key_in_comb")
                self.assertEqual(lines[1]["verdict"], "too-shallow", err)
                self.assertAlmostEqual(lines[1]["judgement"]["deeper"], math.sqrt(2.5), places=3)

    def test_adapter_without_its_packages(self):
        """A copy of the program has nothing beside it."""
        shutil.copy(EXECUTABLE, self.folder / "fathom")
        for adapter, why in (("jolt", "verify/subjects/web"), ("libccd-epa", "Debian package")):
            done = subprocess.run([self.folder / "fathom", "certify", "--adapter", adapter, "-"], input="", capture_output=True, text=True,
                                  check=False)
            self.assertEqual(done.returncode, 2)
            self.assertIn(f"--adapter: {'web-subjects/jolt.mjs' if adapter == 'jolt' else 'fathom-subject-libccd'} is not beside",
                          done.stderr)
            self.assertIn(why, " ".join(done.stderr.split()))

    def test_output_that_cannot_be_written(self):
        for option in ("--report", "--junit", "--html", "--write-expect-fail"):
            err = self.refused("certify", option, "/nowhere/file", "--subject", liar("honest"), "-", stdin=boxes(0))
            self.assertIn("/nowhere/file", err)
        with open("/dev/full", "wb") as full:
            code, _, err = self.run_cli("certify", "--subject", liar("honest"), "-", stdin=boxes(0), stdout=full)
        self.assertEqual((code, err), (3, "fathom: cannot write to standard output: No space left on device\n"))


class Bar(CertifyTest):
    def test_rate_time_left_and_worst_error(self):
        path = self.file("cases.jsonl", boxes(0, marked=True) + "".join(boxes(i) for i in range(1, 300)))
        code, out, seen = run_on_terminal("certify", "--jobs", "1", "--subject", liar("too-deep", 0.02), path, stop_at=b"worst error",
                                          columns=100)
        self.assertEqual((code, out[:7]), (130, b"liar 1 "))
        self.assertRegex(seen, rb"\r\x1b\[K\[#*\.+\] +\d+% \d+ of 300 cases, [0-9.]+/s, \d+ s left, 1 failed, worst error 0\.5")

    def test_of_a_pipe(self):
        """Of which nobody knows how much is to come."""
        ours, theirs = pty.openpty()
        stream = "".join(boxes(i) for i in range(150))
        with subprocess.Popen([EXECUTABLE, "certify", "--jobs", "1", "--subject", liar("honest", 0.02), "-"], stdin=subprocess.PIPE,
                              stdout=subprocess.PIPE, stderr=theirs) as process:
            os.close(theirs)
            process.communicate(stream.encode(), timeout=PATIENCE)
        seen = os.read(ours, 1 << 20)
        os.close(ours)
        self.assertRegex(seen, rb"^\r\x1b\[K\d+ cases, [0-9.]+/s, \d+ s, 0 failed, worst error [0-9.e-]+")


class Usage(CertifyTest):
    def test_help(self):
        out = self.answer("certify", "--help")
        for option in ("--subject", "--adapter", "--replay", "--jobs", "--time-out", "--tol-rel", "--report", "--resume", "--json",
                       "--metamorphic", "--expect-fail", "--max-errors", "--junit", "--html", "--certificates", "--shrink",
                       "--list-adapters"):
            self.assertIn(option, out)
        self.assertLess(out.index("Examples"), out.index("Usage"))
        self.assertLessEqual(max(map(len, out.splitlines())), 120)


if __name__ == "__main__":
    unittest.main()
