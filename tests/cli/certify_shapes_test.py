# SPDX-License-Identifier: GPL-3.0-or-later
"""fathom certify on round and curved bodies: subjects see the shapes that they declare, and are judged on them by proved bounds."""
import json
import os
import pathlib
import struct
import subprocess
import sys
import unittest

import jsonschema  # Debian: python3-jsonschema
from certify_harness import CertifyTest
from certify_schemas import SUBJECT, VERDICT, validator
from harness import ROOT

# Right about two balls, times a factor; of all else it says that the bodies are apart.
BALLS = """
import json, math, sys
sys.path.insert(0, sys.argv[1])
import fathom_subject

log = open(sys.argv[4], "a")


def solve(a, b):
    print(json.dumps([vars(a), vars(b)]), file=log, flush=True)
    if a.shape != "sphere" or b.shape != "sphere":
        return fathom_subject.Reply(False)
    way = [p - q for p, q in zip(a.translation, b.translation)]
    length = math.hypot(*way)
    depth = a.radius + a.margin + b.radius + b.margin - length
    return fathom_subject.Reply(depth > 0, float(sys.argv[2]) * abs(depth), [x / length for x in way])


fathom_subject.run(solve, name="balls", version="1", precision=sys.argv[3], shapes=["sphere", "margin"])
"""


def at(*place):
    return {"quaternion": [1, 0, 0, 0], "translation": list(place)}


def ball(radius, *place, **more):
    return {"shape": "sphere", "radius": radius, "pose": at(*place), **more}


def pair(name, a, b):
    return json.dumps({"id": name, "a": a, "b": b}) + "\n"


BOX = {"shape": "box", "half": [1, 1, 1]}
CYLINDER = {"shape": "cylinder", "radius": 1, "half_length": 1}
DEEP = pair("deep", ball(1, 0, 0, 0), ball(1, 1.5, 0.25, 0))
CASES = (DEEP + pair("margins", ball(1, 0, 0, 0, shape="rounded_sphere", margin=0.5), ball(0.25, 0.5, 0.7, 1))
         + pair("apart", ball(1, 0, 0, 0), ball(1, 3, 0.25, 0)) + pair("touching", ball(1, 0, 0, 0), ball(1, 2, 0, 0))
         + pair("declined", ball(1, 0, 0, 0), CYLINDER) + pair("points", BOX, BOX))


class Shapes(CertifyTest):
    def subject(self, factor=1, precision="binary64"):
        self.log = self.folder / "log"
        program = self.file("balls.py", BALLS)
        return f"exec '{sys.executable}' -B '{program}' '{ROOT / 'verify' / 'subjects' / 'kit'}' {factor} {precision} '{self.log}'"

    def judged(self, *arguments, factor=1, precision="binary64", stdin=CASES):
        code, lines, err = self.certify("--jobs", "1", *arguments, "--subject", self.subject(factor, precision), "-", stdin=stdin)
        for line in lines:
            validator(VERDICT).validate(line)
        return code, {line["id"]: line for line in lines if line["type"] == "case"}, err

    def test_a_subject_sees_what_it_declares(self):
        code, found, err = self.judged()
        self.assertEqual(err, "")
        self.assertEqual({name: line["verdict"] for name, line in found.items()},
                         {"deep": "pass", "margins": "pass", "apart": "pass", "touching": "touching-by-convention",
                          "declined": "unsupported", "points": "false-separation"})
        self.assertEqual(code, 1)
        self.assertEqual(found["declined"]["detail"], 'the subject does not declare "cylinder" among its shapes')
        seen = [json.loads(line) for line in self.log.read_text().splitlines()]
        self.assertEqual([(a["shape"], len(a["vertices"])) for a, _ in seen], [("sphere", 0)] * 4 + [(None, 8)] * (len(seen) - 4))
        self.assertEqual(seen[1][0]["margin"], 0.5)
        self.assertEqual(seen[1][1]["translation"], [0.5, 0.7, 1])

    def test_the_wire_obeys_the_schema(self):
        tee = self.file("tee.py", "import sys, subprocess\nlog = open(sys.argv[1], 'w')\n"
                        "child = subprocess.Popen(['/bin/sh', '-c', sys.argv[2]], stdin=subprocess.PIPE)\n"
                        "for line in sys.stdin:\n    log.write(line)\n    log.flush()\n    child.stdin.write(line.encode())\n"
                        "    child.stdin.flush()\nchild.stdin.close()\nsys.exit(child.wait())\n")
        said, inner = self.folder / "said", self.file("inner.sh", self.subject())
        code, _, err = self.certify("--jobs", "1", "--subject", f"exec '{sys.executable}' -B '{tee}' '{said}' '. {inner}'", "-",
                                    stdin=CASES)
        self.assertEqual((code, err), (1, ""))
        lines = [json.loads(line) for line in said.read_text().splitlines()]
        runs = [line for line in lines if line["type"] == "run"]
        for line in lines:
            validator(SUBJECT, ("hello_to_subject", "run", "stop")).validate(line)
        self.assertEqual(runs[1]["a"], {"shape": "sphere", "radius": 1, "margin": 0.5, "pose": at(0, 0, 0)})
        damages = ({"margin": 0}, {"shape": "rounded_sphere"}, {"radius": None}, {"radius": "1"}, {"color": 1},
                   {"shape": "cylinder", "half_length": 1})
        for damage in damages:
            with self.subTest(damage), self.assertRaises(jsonschema.ValidationError):
                validator(SUBJECT, ("run",)).validate({**runs[1], "a": {**runs[1]["a"], **damage}})

    def test_wrong_answers(self):
        for factor, verdict in ((1.5, "too-deep"), (0.5, "too-shallow"), (-1, "wrong-sign"), ("nan", "nan")):
            with self.subTest(verdict):
                code, found, _ = self.judged(factor=factor, stdin=DEEP)
                self.assertEqual((code, found["deep"]["verdict"]), (1, verdict))
        judgement = self.judged(factor=1.5, stdin=DEEP)[1]["deep"]["judgement"]
        self.assertEqual(judgement["status"], "penetrating")
        depth = 2 - (1.5**2 + 0.25**2)**0.5
        for between in (judgement["signed_depth"], judgement["price"]):
            self.assertLessEqual(between["low"], between["high"])
            self.assertAlmostEqual(between["low"], depth, 12)

    def test_a_subject_in_binary32_is_judged_on_what_it_sees(self):
        case = pair("seen", ball(0.1, 0, 0, 0), ball(0.1, 0.15, 0, 0))
        code, found, _ = self.judged("--tol-rel", "0", "--tol-abs", "0", precision="binary32", stdin=case)
        self.assertEqual((code, found["seen"]["verdict"]), (0, "pass"))
        a, b = json.loads(self.log.read_text())
        self.assertEqual(a["radius"], struct.unpack("f", struct.pack("f", 0.1))[0])
        exact = found["seen"]["judgement"]["signed_depth"]["low"]
        self.assertNotAlmostEqual(exact, 0.05, 10)
        self.assertAlmostEqual(exact, 0.05, 7)
        code, found, err = self.judged(precision="binary32", stdin=pair("small", ball(1e-60, 0, 0, 0), ball(1, 0, 0, 0)))
        self.assertEqual((code, found["small"]["verdict"]), (4, "unsupported"))
        self.assertIn("no case was judged", err)
        self.assertIn("leaves no shape", found["small"]["detail"])

    def test_certificates_and_the_page(self):
        folder, page = self.folder / "proofs", self.folder / "page.html"
        code, found, _ = self.judged("--certificates", str(folder), "--html", str(page), factor=2)
        self.assertEqual(code, 1)
        failing = sum(line["verdict"] not in ("pass", "unsupported", "touching-by-convention") for line in found.values())
        proofs = sorted(folder.glob("*.cert"))
        self.assertEqual(len(proofs), failing)
        for proof in proofs:
            result = subprocess.run([os.environ["FATHOM_CHECK"], proof], capture_output=True, text=True)
            self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        self.assertTrue(any(proof.read_text().startswith("fathom-certificate 2") for proof in proofs))
        self.assertIn("deep", page.read_text())

    def test_a_second_way_agrees(self):
        for method in ("exact", "naive"):
            code, found, err = self.judged("--method", method, stdin=DEEP)
            self.assertEqual((code, found["deep"]["verdict"], err), (0, "pass", ""))

    def test_variants_pass_and_reports_are_resumed(self):
        report = str(self.folder / "report.jsonl")
        code, found, _ = self.judged("--metamorphic", "--report", report, stdin=DEEP)
        lines = pathlib.Path(report).read_text().splitlines()
        cases = [json.loads(line) for line in lines if json.loads(line)["type"] == "case"]
        self.assertEqual(code, 0)
        self.assertIn("swap", {line.get("variant") for line in cases})
        self.assertEqual({line["verdict"] for line in cases}, {"pass"})
        self.log.write_text("")
        self.assertEqual(self.judged("--metamorphic", "--report", report, "--resume", stdin=DEEP)[0], 0)
        self.assertEqual(self.log.read_text(), "")  # nothing was asked again

    def test_shapes_are_made_simpler_and_no_word_is_lost(self):
        """And the program that is written calls the user's own engine, if there is one."""
        folder = self.folder / "small"
        own = self.file("own.txt", "a = @A@\nb = @B@\nagain @A@\njson @A_JSON@ @B_JSON@\n")
        for more, ending in (([], ".cpp"), (["--harness", own], ".txt")):
            code, lines, err = self.judged("--shrink", str(folder), *more, factor=2, stdin=DEEP)
            self.assertEqual(code, 1)
            self.assertIn("too-deep.case.json", err)
            kept = json.loads((folder / "too-deep.case.json").read_text())
            self.assertEqual(kept["a"]["shape"], "sphere")
            text = (folder / f"too-deep{ending}").read_text()
            self.assertIn("fathom::sphere(", text)
            self.assertNotIn("@", text)
            self.assertTrue((folder / "too-deep.cert").read_text())
        self.assertIn('json {"shape":"sphere","radius":', text)
        code, _, err = self.run_cli("certify", "--subject", "true", "--harness", own, "-")
        self.assertEqual(code, 2)
        self.assertIn("--harness is filled with what --shrink finds, and needs --shrink", err)


if __name__ == "__main__":
    unittest.main()
