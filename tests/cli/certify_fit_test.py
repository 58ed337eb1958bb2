# SPDX-License-Identifier: GPL-3.0-or-later
"""fathom certify --fit, and what subjects declare and tell of their numbers, bodies and time: judged as they saw it, reported as it was
asked."""
import json
import math
import pathlib
import struct
import subprocess
import sys
import unittest
from fractions import Fraction

from certify_harness import CertifyTest, boxes
from certify_schemas import VERDICT, validator
from harness import EXECUTABLE, ROOT, box, case

# Right about boxes along the axes, times a factor; writes down what it gets.
BOXES = """
import json, struct, sys
sys.path.insert(0, sys.argv[1])
import fathom_subject

options = json.loads(sys.argv[3])
log = open(sys.argv[2], "a")
asked = 0


def solve(a, b):
    global asked
    print(json.dumps([vars(a), vars(b)]), file=log, flush=True)
    asked += 1
    grow = options.get("grow", 0)
    ways = []
    for axis in range(3):
        for sign in (-1, 1):
            reach = max(sign * p[axis] for p in b.vertices) - min(sign * p[axis] for p in a.vertices) + grow
            ways.append((reach, [sign * (i == axis) for i in range(3)]))
    depth, direction = min(ways)
    depth *= options.get("factor", 1)
    if asked % 2 == 0:
        depth *= options.get("second", 1)
    hulls = [[[x + options["hull"] for x in v] for v in a.vertices], None] if "hull" in options else None
    if "stretch" in options:
        hulls = [None, [[x * options["stretch"] for x in v] for v in b.vertices]]
    return fathom_subject.Reply(depth > 0, max(depth, 0), direction, hull=hulls)


fathom_subject.run(solve, name="boxes", version="1", **options.get("hello", {}))
"""


def scaled(points, exponent):
    """Exactly, as texts."""
    return [[str(Fraction(x) * Fraction(2) ** exponent) for x in p] for p in points]


def small(exponent, name):
    """Boxes of side 1 and 1.25 that overlap by 0.25, times 2^exponent."""
    return case(scaled(box([0, 0, 0], [1, 1, 1]), exponent), scaled(box([0.75, -0.125, 0], [2, 1, 1.25]), exponent), id=name)


class Subject(CertifyTest):
    def subject(self, **options):
        self.log = self.folder / "log"
        self.log.write_text("")
        program = self.file("boxes.py", BOXES)
        return f"exec '{sys.executable}' -B '{program}' '{ROOT}/verify/subjects/kit' '{self.log}' '{json.dumps(options)}'"

    def seen(self):
        return [json.loads(line) for line in self.log.read_text().splitlines()]

    def judged(self, *arguments, stdin="", **options):
        code, lines, err = self.certify("--jobs", "1", "--subject", self.subject(**options), *arguments, "-", stdin=stdin)
        for line in lines:
            validator(VERDICT).validate(line)
        return code, lines, err


def extent(pair):
    return max(max(p[k] for p in body["vertices"]) - min(p[k] for p in body["vertices"]) for body in pair for k in range(3))


class Fit(Subject):
    def test_the_subject_sees_the_size_and_the_report_the_case(self):
        for exponent in (-1030, -300, -3, 0, 5, 900):
            with self.subTest(exponent):
                code, lines, err = self.judged("--fit", "64", stdin=small(exponent, "small"))
                self.assertEqual((code, lines[1]["verdict"]), (0, "pass"), err)
                self.assertEqual(extent(self.seen()[0]), 1.25 * 2 ** 5)
                self.assertEqual(lines[0]["fit"], "64")
                self.assertEqual(lines[1].get("fit", 0), 5 - exponent)
                judgement = lines[1]["judgement"]
                self.assertEqual(Fraction(judgement["depth_squared"]), Fraction(2) ** (2 * exponent - 4))
                self.assertEqual(lines[1]["reply"]["depth"], math.ldexp(0.25, exponent))
                self.assertEqual(lines[1]["reply"]["direction"], [-1, 0, 0])
                self.assertEqual((judgement["error"], judgement["accuracy"]), (0, "correctly rounded"))
                self.assertTrue(judgement["sentence"].startswith("right: "), judgement["sentence"])
                self.assertEqual(float(judgement["sentence"].split()[1]), math.ldexp(0.25, exponent))

    def test_the_size_is_less_than_the_number(self):
        for size, sees in (("40", 20), ("40.001", 40), ("2.5", 1.25), ("1/3", 0.3125)):
            self.judged("--fit", size, stdin=small(0, "small"))
            self.assertEqual(extent(self.seen()[0]), sees, size)

    def test_points_are_left_as_they_are(self):
        _, lines, _ = self.judged("--fit", "64", stdin=case([[1, 2, 3]], [[1, 2, 3]], id="point"))
        self.assertEqual((self.seen()[0][0]["vertices"], "fit" in lines[1]), ([[1, 2, 3]], False))

    def test_verdicts_are_those_of_the_fitted_unit(self):
        """In binary32 nothing is left of 2^-1030; fitted, an ulp is one there."""
        narrow = {"hello": {"precision": "binary32"}}
        _, lines, _ = self.judged(stdin=small(-1030, "small"), **narrow)
        self.assertNotEqual(lines[1]["verdict"], "pass")
        _, lines, _ = self.judged("--fit", "64", stdin=small(-1030, "small"), **narrow)
        self.assertEqual(lines[1]["verdict"], "pass")
        above = struct.unpack("f", struct.pack("I", struct.unpack("I", struct.pack("f", 1))[0] + 1))[0]
        exact = ("--tol-rel", "0", "--tol-abs", "0", "--fit", "64")
        _, lines, _ = self.judged(*exact, stdin=small(-900, "small"), factor=above, **narrow)
        judgement = lines[1]["judgement"]
        self.assertEqual((lines[1]["verdict"], judgement["error_ulps"], judgement["error"]),
                         ("too-deep", 1, math.ldexp(0.25, -900) * 2 ** -23))
        _, lines, _ = self.judged(*exact, "--tol-ulps", "1", stdin=small(-900, "small"), factor=above, **narrow)
        self.assertEqual((lines[1]["verdict"], lines[1]["judgement"]["accuracy"]), ("pass", "4 ulp"))

    def test_reports_with_and_without_it_say_the_same(self):
        cases = subprocess.run([EXECUTABLE, "cases", "--family", "boxes_aligned", "--count", "40"], capture_output=True, text=True,
                               check=True).stdout

        def told(lines):
            return [{k: v for k, v in line.items() if k not in ("seconds", "microseconds", "fit")} for line in lines
                    if line["type"] == "case"]

        plain, fitted = self.judged(stdin=cases, factor=1.5)[1], self.judged("--fit", "64", stdin=cases, factor=1.5)[1]
        self.assertEqual(told(plain), told(fitted))
        self.assertTrue(any("fit" in line for line in fitted))

    def test_a_report_of_another_fit_is_refused(self):
        report = str(self.folder / "report.jsonl")
        cases = small(0, "one") + small(-1030, "two")
        self.judged("--report", report, "--fit", "64", "--metamorphic", stdin=cases)
        for other in (("--fit", "32"), ()):
            code, _, err = self.judged("--report", report, "--resume", *other, stdin=cases)
            self.assertEqual(code, 2)
            self.assertIn("fit", err)
        whole = (self.folder / "report.jsonl").read_text().splitlines(keepends=True)
        (self.folder / "report.jsonl").write_text("".join(whole[:2]))  # the first case, without its variants
        code, again, _ = self.judged("--report", report, "--resume", "--fit", "64", "--metamorphic", stdin=cases)
        self.assertEqual((code, set(self.verdicts(again).values())), (0, {"pass"}))
        self.assertEqual(len((self.folder / "report.jsonl").read_text().splitlines()), len(whole))

    def test_replays_answer_the_fitted_case(self):
        replies = self.file("replies.jsonl", '{"type":"reply","id":"small","overlap":true,"depth":8,"direction":[-1,0,0]}\n')
        code, lines, _ = self.certify("--replay", replies, "--fit", "64", "-", stdin=small(-20, "small"))
        self.assertEqual((code, lines[1]["reply"]["depth"]), (0, 0.25 * 2 ** -20))

    def test_certificates_and_pages_are_of_the_case(self):
        folder, page = self.folder / "certificates", self.folder / "page.html"
        self.judged("--fit", "64", "--certificates", str(folder), "--html", str(page), stdin=small(-1030, "small"), factor=1.5)
        [certificate] = folder.iterdir()
        done = subprocess.run([EXECUTABLE, "check", str(certificate)], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        depth = math.ldexp(0.25, -1030)
        text = page.read_text()
        self.assertIn(f"<dt>depth</dt><dd class=\"number\">{1.5 * depth}</dd>", text)
        self.assertIn("less than 64, and at least half of that", text)

    def test_shrinking_fits_each_step(self):
        folder = self.folder / "shrunk"
        self.judged("--fit", "64", "--shrink", str(folder), stdin=small(-1030, "small"), factor=1.5)
        self.assertTrue((folder / "too-deep.case.json").exists())
        for pair in self.seen():
            self.assertTrue(32 <= extent(pair) < 64 or extent(pair) == 0, extent(pair))

    def test_shapes(self):
        ball = {"shape": "sphere", "radius": 1, "pose": [[2, 0, 0, 4], [0, 1, 0, 5], [0, 0, 1, 6]]}
        pair = {"id": "balls", "a": ball, "b": {"shape": "rounded_box", "half": [1, 2, 3], "margin": 0.5}}
        self.judged("--fit", "64", stdin=json.dumps(pair) + "\n", hello={"shapes": ["sphere", "box", "margin"]})
        [[a, b]] = self.seen()
        self.assertEqual((a["radius"], a["rotation"], a["translation"]), (8, [[2, 0, 0], [0, 1, 0], [0, 0, 1]], [32, 40, 48]))
        self.assertEqual((b["half"], b["margin"]), ([8, 16, 24], 4))

    def test_numbers_that_are_none(self):
        for size in ("0", "-1", "much", "nan"):
            code, _, err = self.judged("--fit", size, stdin=small(0, "small"))
            self.assertEqual(code, 2)
            self.assertIn("expected a number above 0", err)


class Declared(Subject):
    def test_repeat_finds_what_depends_on_history(self):
        code, lines, _ = self.judged("--metamorphic=repeat", stdin=boxes(0))
        self.assertEqual((code, self.verdicts(lines)), (0, {"box::0": "pass", "box::0~repeat": "pass"}))
        code, lines, _ = self.judged("--metamorphic=repeat", "--tol-rel", "1/10", stdin=boxes(0) + boxes(1), second=1.125, factor=0.9375)
        self.assertEqual(self.verdicts(lines)["box::0~repeat"], "not-invariant")
        self.assertEqual(code, 1)

    def test_times(self):
        cases = boxes(0) + boxes(1) + boxes(2)
        _, lines, _ = self.judged(stdin=cases)
        times = {line["id"]: line["microseconds"] for line in lines if line["type"] == "case"}
        worst = max(times, key=lambda name: (times[name], name))
        self.assertEqual(lines[-1]["microseconds"], {"answers": 3, "median": sorted(times.values())[1], "worst": times[worst],
                                                     "worst_case": worst})
        page = self.folder / "page.html"
        code, out, _ = self.run_cli("certify", "--html", str(page), "--subject", self.subject(), "-", stdin=cases)
        self.assertEqual(code, 0)
        self.assertRegex(out, r"time +median [0-9.e+]+ us; worst [0-9.e+]+ us \(box::[012]\)")
        self.assertIn("<dt>time</dt><dd>median ", page.read_text())

    def test_two_precisions(self):
        """Points in binary32, answers in binary64: 0.1 is another number, and an ulp is that of binary64."""
        tenth = case(box([0, 0, 0], [1, 1, 1]), box([0.1, 0, 0], [2, 1, 1]), id="tenth")
        near = struct.unpack("f", struct.pack("f", 0.1))[0]
        for hello, accuracy in (({"points": "binary32", "answers": "binary64"}, "correctly rounded"), ("binary64", "correctly rounded")):
            _, lines, _ = self.judged(stdin=tenth, hello={"precision": hello})
            self.assertEqual(lines[0]["subject"]["precision"], hello)
            self.assertEqual(lines[1]["judgement"]["accuracy"], accuracy)
            self.assertEqual(min(p[0] for p in self.seen()[0][1]["vertices"]), near if hello != "binary64" else 0.1)
        _, lines, _ = self.judged("--tol-rel", "0", "--tol-abs", "0", stdin=tenth, factor=1 + 2 ** -52,
                                  hello={"precision": {"points": "binary32", "answers": "binary64"}})
        judgement = lines[1]["judgement"]
        depth = 1 - near
        self.assertEqual((lines[1]["verdict"], judgement["error_ulps"]), ("too-deep", (depth * (1 + 2 ** -52) - depth) / 2 ** -53))
        self.assertEqual(judgement["error_u_r"], judgement["error"] / (2 ** -24 * 2))

    def test_rounded_bodies(self):
        radius = 0.125
        code, lines, _ = self.judged(stdin=boxes(0), grow=2 * radius, hello={"rounding": radius})
        self.assertEqual((code, lines[0]["subject"]["rounding"]), (0, radius))
        self.assertEqual(lines[1]["judgement"]["signed_depth"], {"low": 0.75, "high": 0.75})
        code, lines, _ = self.judged(stdin=boxes(0), hello={"rounding": {"vertices": radius, "box": 7}})
        self.assertEqual(lines[1]["verdict"], "too-shallow")
        self.assertEqual(lines[1]["judgement"]["error"], -0.25)
        code, lines, _ = self.judged(stdin=boxes(0), hello={"rounding": {"box": 7}})
        self.assertEqual((code, lines[1]["verdict"]), (0, "pass"))
        self.assertEqual(lines[1]["judgement"]["depth_squared"], "1/4")

    def test_a_radius_widens_no_tolerance(self):
        """A program that looks at nothing, and claims twice its radius and a half."""
        cases = "".join(case(box([0, 0, 0], [1, 1, 1]), box([1 - depth, 0, 0], [2, 1, 1]), id=f"c::{depth}") for depth in (0.25, 0.5, 0.75))
        hello = {"type": "hello", "protocol": "fathom/subject/1", "name": "blind", "version": "1", "precision": "binary64", "rounding": 1e6,
                 "conventions": {"touching": "either", "depth": "positive", "moves": "a", "unit": True}}
        blind = self.file("blind.py", "import json, sys\n"
                          "for line in sys.stdin:\n"
                          "  m = json.loads(line)\n"
                          f"  if m['type'] == 'hello': print({json.dumps(hello)!r}, flush=True)\n"
                          "  if m['type'] == 'run': print(json.dumps({'type': 'reply', 'id': m['id'], 'overlap': True,"
                          " 'depth': 2000000.5}),"
                          " flush=True)\n")
        code, lines, _ = self.certify("--subject", f"exec '{sys.executable}' '{blind}'", "-", stdin=cases)
        self.assertEqual((code, self.verdicts(lines)), (1, {"c::0.25": "too-deep", "c::0.5": "pass", "c::0.75": "too-shallow"}))
        self.assertEqual({line["radii"] for line in lines if line["type"] == "case"}, {"2000000"})
        _, out, _ = self.run_cli("certify", "--subject", f"exec '{sys.executable}' '{blind}'", "-", stdin=cases)
        self.assertEqual(out.splitlines()[0], "blind 1 (binary64); its own radii are larger than the bodies in 3 of 3 cases")
        self.file("blind.py", pathlib.Path(blind).read_text().replace("1000000.0", "1e30"))
        code, lines, _ = self.certify("--subject", f"exec '{sys.executable}' '{blind}'", "-", stdin=cases)
        self.assertEqual((code, set(self.verdicts(lines).values())), (4, {"unsupported"}), "its numbers cannot tell these bodies")
        self.assertIn("beside which numbers of binary64 do not tell bodies as long as 1", lines[1]["detail"])

    def test_the_radius_is_in_the_fitted_unit(self):
        code, lines, _ = self.judged("--fit", "64", stdin=small(-40, "small"), grow=0.5, hello={"rounding": 0.25})
        self.assertEqual((code, lines[1]["verdict"]), (0, "pass"))
        depth = math.ldexp(8.5, -45)
        self.assertEqual(lines[1]["judgement"]["signed_depth"], {"low": depth, "high": depth})

    def test_certificates_and_steps_are_of_the_rounded_bodies(self):
        folder, shrunk = self.folder / "certificates", self.folder / "shrunk"
        _, _, err = self.judged("--certificates", str(folder), "--shrink", str(shrunk), "--method", "exact", "--metamorphic",
                                stdin=boxes(0), hello={"rounding": 0.125})
        self.assertIn("scale is no symmetry of a subject that rounds", err)
        for certificate in [*folder.iterdir(), shrunk / "too-shallow.cert"]:
            done = subprocess.run([EXECUTABLE, "check", str(certificate)], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_used_hulls(self):
        """A is moved by 0.125 along each axis: right about that, and wrong about what was asked."""
        cases = boxes(0) + boxes(1)
        code, lines, _ = self.judged(stdin=cases, hull=0.125)
        self.assertEqual((code, lines[1]["verdict"]), (0, "pass"))
        hulls = lines[1]["hulls"]
        self.assertEqual(hulls["query"]["verdict"], "too-shallow")
        self.assertEqual(hulls["query"]["error"], -0.125)
        self.assertEqual((hulls["lost_squared"], hulls["grown_squared"]), ("3/64", "3/64"))
        self.assertEqual((hulls["lost"], hulls["grown"]), (math.sqrt(3 / 64), math.sqrt(3 / 64)))
        most = {"length": math.sqrt(3 / 64), "case": "box::0"}
        self.assertEqual(lines[-1]["hulls"], {"answers": 2, "query_passed": 0, "lost": most, "grown": most})
        _, lines, _ = self.judged(stdin=cases, hull=0)
        self.assertEqual((lines[1]["hulls"]["query"]["verdict"], lines[1]["hulls"]["lost_squared"]), ("pass", "0"))
        self.assertEqual(lines[-1]["hulls"]["query_passed"], 2)
        page = self.folder / "page.html"
        _, out, _ = self.run_cli("certify", "--html", str(page), "--subject", self.subject(hull=0.125, factor=2), "-", stdin=cases)
        self.assertRegex(out,
                         r"hulls +told in 2 answers; by them 0 pass; lost at most 0\.2165 \(box::0\); grown at most 0\.2165 \(box::0\)")
        self.assertIn("Hulls that it used", page.read_text())

    def test_lost_is_not_grown(self):
        """A unit cube, and about it its own hull twice as large or half as large."""
        for stretch, lost, grown in ((2, "0", "3"), (0.5, "3/4", "0")):
            _, lines, _ = self.judged(stdin=case(box([4, 0, 0], [5, 1, 1]), box([0, 0, 0], [1, 1, 1]), id="cube"), stretch=stretch)
            self.assertEqual((lines[1]["hulls"]["lost_squared"], lines[1]["hulls"]["grown_squared"]), (lost, grown))

    def test_used_hulls_are_of_the_fitted_case(self):
        _, lines, _ = self.judged("--fit", "64", stdin=small(-40, "small"), hull=0.125)
        self.assertEqual(lines[1]["hulls"]["lost_squared"], str(Fraction(3, 64) / 2 ** 90))

    def test_hulls_of_shapes_are_garbage(self):
        hello = json.dumps({"type": "hello", "protocol": "fathom/subject/1", "name": "x", "version": "1", "precision": "binary64",
                            "conventions": {"touching": "either", "depth": "positive", "moves": "a", "unit": True},
                            "capabilities": {"shapes": ["box"]}})
        reply = '{"type":"reply","id":"x","overlap":true,"hull":{"b":[[0,0,0]]}}'
        replies = self.file("replies.jsonl", f"{hello}\n{reply}\n")
        pair = json.dumps({"id": "x", "a": {"vertices": box([0, 0, 0], [1, 1, 1])}, "b": {"shape": "box", "half": [1, 1, 1]}}) + "\n"
        _, lines, _ = self.certify("--replay", replies, "-", stdin=pair)
        self.assertEqual((lines[1]["verdict"], lines[1]["detail"]), ("garbage", 'expected no "hull.b": the body was sent as a shape'))


if __name__ == "__main__":
    unittest.main()
