# SPDX-License-Identifier: GPL-3.0-or-later
"""fathom certify: the worked subjects, what they say, and that every line obeys the schemas."""
import json
import re
import shlex
import shutil
import subprocess
import sys
import unittest

import jsonschema  # Debian: python3-jsonschema
from certify_harness import CertifyTest, boxes, liar
from certify_schemas import SUBJECT, VERDICT, validator
from harness import ROOT, UNIT, box, case

EXAMPLES = ROOT / "verify" / "examples"
# Passes on what a subject and fathom say to each other, and writes it down.
TEE = """
import subprocess, sys, threading
log = open(sys.argv[1], "a")
child = subprocess.Popen(sys.argv[2:], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
def copy(source, target, mark):
    for line in source:
        log.write(mark + line.decode())
        log.flush()
        target.write(line)
        target.flush()
    target.close()
thread = threading.Thread(target=copy, args=(sys.stdin.buffer, child.stdin, "> "))
thread.start()
copy(child.stdout, sys.stdout.buffer, "< ")
thread.join()
sys.exit(child.wait())
"""


# Takes polygons for the boxes around them.
PLANE_BOXES = """
import sys
sys.path.insert(0, "{kit}")
import fathom_subject
def solve(a, b):
    way = (float("inf"), None)
    for axis in range(2):
        (low_a, high_a), (low_b, high_b) = ((min(p[axis] for p in body.vertices), max(p[axis] for p in body.vertices)) for body in (a, b))
        for sign, length in ((1, high_b - low_a), (-1, high_a - low_b)):
            way = min(way, (length, [sign * (i == axis) for i in range(2)]))
    return fathom_subject.Reply(way[0] > 0, *way)
fathom_subject.run(solve, name="boxes", version="1", dimension=2)
"""


class Subjects(CertifyTest):
    def traffic(self, words, stream):
        """Runs a subject on the stream and checks every line that is said."""
        log, tee = self.folder / "log", self.file("tee.py", TEE)
        command = shlex.join([sys.executable, tee, str(log), *words])
        code, lines, err = self.certify("--jobs", "1", "--subject", command, "-", stdin=stream)
        self.assertEqual(err, "")
        for line in lines:
            validator(VERDICT).validate(line)
        said = log.read_text().splitlines()
        for line in said:
            validator(SUBJECT, ("hello_to_subject", "run", "stop") if line[0] == ">" else ("hello", "reply")).validate(json.loads(line[2:]))
        self.assertEqual([json.loads(line[2:])["type"] for line in said[:2]], ["hello", "hello"])
        self.assertEqual(json.loads(said[-1][2:]), {"type": "stop"})
        return code, lines, said

    def check(self, words):
        stream = boxes(0) + boxes(7)
        stream += case(UNIT, box([2, 0, 0], [3, 1, 1]), id="apart") + case(UNIT, box([1, 0, 0], [2, 1, 1]), id="touching")
        stream += case([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [["1/10", "1/3", 0.1], [1, 1, 0], [0, 1, 1], ["1e-3", 0, 1]],
                       id="tilted", expected={"depth": 1}, comment="never sent")
        code, lines, said = self.traffic(words, stream)
        self.assertEqual(code, 0)
        self.assertEqual(self.verdicts(lines), {"box::0": "pass", "box::7": "pass", "apart": "pass", "touching": "touching-by-convention",
                                                "tilted": "pass"})
        self.assertEqual(sum('"type":"run"' in line for line in said), 5)
        for secret in ("box::", "tilted", "expected", "never sent"):
            self.assertNotIn(secret, "".join(said))

    def test_worked_subject_in_python(self):
        self.check([sys.executable, "-B", str(EXAMPLES / "subject.py")])

    def test_worked_subject_in_c(self):
        program = str(self.folder / "subject")
        flags = ["-O2", "-Wall", "-Wextra", "-Werror", "-std=c11"]
        subprocess.run([shutil.which("cc"), *flags, str(EXAMPLES / "subject.c"), "-o", program, "-lm"], check=True)
        self.check([program])

    def test_cases_of_the_plane_are_made_smaller(self):
        """The boxes around polygons are deeper than these; circles stand for their boxes too."""
        subject = self.file("boxes.py", PLANE_BOXES.format(kit=ROOT / "verify" / "subjects" / "kit"))
        cases = [{"id": "polygons", "dimension": 2, "a": {"vertices": [[0, 0], [3.1, 0.2], [3, 2.9], [1.5, 3.3], [0.1, 3]]},
                  "b": {"vertices": [[2, 2.2], [5, 2], [5.5, 5], [2.7, 4.9]]}}]
        stream = "".join(json.dumps(each) + "\n" for each in cases)
        code, lines, err = self.certify("--jobs", "1", "--subject", f"exec '{sys.executable}' -B {subject}", "--shrink", self.folder / "small",
                                        "-", stdin=stream)
        self.assertEqual((code, self.verdicts(lines)), (1, {"polygons": "too-deep"}), err)
        self.assertRegex(err, r"too-deep of polygons: 6 points are left; [1-9]\d* of \d+ tries made it smaller")
        small = json.loads((self.folder / "small" / "too-deep.case.json").read_text())
        self.assertEqual((small["dimension"], {len(p) for body in "ab" for p in small[body]["vertices"]}), (2, {2}))
        self.assertIn("dimension=2", self.answer("check", self.folder / "small" / "too-deep.cert"))
        self.assertIn("truth.dimension = 2;", (self.folder / "small" / "too-deep.cpp").read_text())

    def test_flat_bodies_have_no_faces(self):
        code, lines, said = self.traffic([sys.executable, "-B", str(EXAMPLES / "subject.py")],
                                         case(UNIT, [[0.5, 0.5, 0.5]], id="flat") + boxes(0))
        self.assertEqual((code, self.verdicts(lines)), (0, {"flat": "unsupported", "box::0": "pass"}))
        run = json.loads(next(line for line in said if '"run"' in line)[2:])
        self.assertEqual((len(run["a"]["faces"]), "faces" in run["b"]), (6, False))

    def test_shapes_and_unions_on_the_wire(self):
        """As messages to a subject that declares them, which says of all that they are apart."""
        program = self.file("apart.py", "import sys\nsys.path.insert(0, sys.argv[1])\nimport fathom_subject\n"
                            "fathom_subject.run(lambda a, b: fathom_subject.Reply(False), name='apart', version='1',"
                            " shapes=['sphere', 'margin', 'pieces'])\n")
        ball = {"shape": "sphere", "radius": 1, "pose": {"quaternion": [1, 0, 0, 0], "translation": [9, 0, 0]}}
        cube, other = {"vertices": UNIT}, {"vertices": box([3, 0, 0], [4, 1, 1])}
        pairs = [({**ball, "shape": "rounded_sphere", "margin": 0.5}, cube),
                 ({"pieces": [other, {"vertices": box([2, 0, 0], [3, 1, 1])}]}, cube)]
        _, _, said = self.traffic([sys.executable, "-B", program, str(ROOT / "verify/subjects/kit")],
                                  "".join(json.dumps({"a": a, "b": b}) + "\n" for a, b in pairs))
        round_one, union = (json.loads(line[2:]) for line in said if '"run"' in line)
        self.assertEqual(round_one["a"], {**ball, "margin": 0.5})
        self.assertEqual(union["a"]["pieces"][0], other)
        check = validator(SUBJECT, ("run",))
        for damage in ({"margin": 0}, {"shape": "rounded_sphere"}, {"radius": None}, {"radius": "1"}, {"color": 1},
                       {"shape": "cylinder", "half_length": 1}):
            self.assertFalse(check.is_valid({**round_one, "a": {**round_one["a"], **damage}}), damage)
        self.assertFalse(check.is_valid({**union, "a": {"pieces": union["a"]["pieces"][:1]}}))

    def test_the_page_tells_the_truth(self):
        """The example of PROTOCOL.md, replayed."""
        page = (ROOT / "verify" / "PROTOCOL.md").read_text()
        said = [json.loads(line) for line in re.findall(r"^ +(?:fathom|subject) +(\{.*\})$", page, re.MULTILINE)]
        hello, run, reply = said[1:4]
        for message in said:
            validator(SUBJECT).validate(message)
        replay = self.file("replay.jsonl", json.dumps(hello) + "\n" + json.dumps(reply) + "\n")
        code, lines, err = self.certify("--replay", replay, "-", stdin=case(run["a"]["vertices"], run["b"]["vertices"], id="1"))
        self.assertEqual((code, self.verdicts(lines)), (0, {"1": "pass"}), err)
        self.assertIn(lines[1]["judgement"]["accuracy"], ("correctly rounded", "4 ulp"))

    def test_schemas(self):
        for schema in (SUBJECT, VERDICT):
            jsonschema.Draft202012Validator.check_schema(schema)
        _, lines, _ = self.certify("--metamorphic", "--subject", liar("nan"), "-", stdin=boxes(0) + boxes(1, marked=True))
        for line in lines:
            validator(VERDICT).validate(line)
        self.assertEqual({line.get("variant") for line in lines}, {None, "swap", "translate", "permute", "scale", "repeat"})
        _, things, _ = self.certify("--subject", liar("one-shot"), "-", stdin=boxes(0))
        self.assertEqual([line["type"] for line in things], ["header", "case", "unattributed", "summary"])
        lines += things
        for line in lines:
            for field in line:
                self.assertFalse(validator(VERDICT).is_valid({k: v for k, v in line.items() if k != field})
                                 and field not in ("variant", "after", "judgement", "solid", "metre_sized", "policy", "relative_excess", "parts")
                                 and (field, line["type"]) != ("detail", "case"), field)
            self.assertFalse(validator(VERDICT).is_valid({**line, "more": 1}))
        good = {"type": "reply", "id": "1", "overlap": True, "depth": "0x1.8p3", "direction": [1, "nan", "-inf"]}
        validator(SUBJECT).validate(good)
        for wrong in ({"overlap": 1}, {"depth": "deep"}, {"direction": [1]}, {"witness": {"a": 1}}, {"id": None}, {"type": "repl"}):
            self.assertFalse(validator(SUBJECT).is_valid({**good, **wrong}), wrong)


if __name__ == "__main__":
    unittest.main()
