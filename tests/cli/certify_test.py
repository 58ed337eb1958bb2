# SPDX-License-Identifier: GPL-3.0-or-later
"""fathom certify: its options, its exit codes, replays, the worked subjects, and that every line obeys the schemas."""
import json
import os
import pty
import re
import shlex
import shutil
import subprocess
import sys
import unittest

import jsonschema  # Debian: python3-jsonschema
from certify_harness import CertifyTest, boxes, liar
from certify_schemas import SUBJECT, VERDICT, validator
from harness import DATA, EXECUTABLE, PATIENCE, ROOT, UNIT, box, case
from terminals import run_on_terminal

EXAMPLES = ROOT / "verify" / "examples"
PYTHON = f"exec '{sys.executable}' -B '{EXAMPLES / 'subject.py'}'"
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

    def test_flat_bodies_have_no_faces(self):
        code, lines, said = self.traffic([sys.executable, "-B", str(EXAMPLES / "subject.py")],
                                         case(UNIT, [[0.5, 0.5, 0.5]], id="flat") + boxes(0))
        self.assertEqual((code, self.verdicts(lines)), (0, {"flat": "unsupported", "box::0": "pass"}))
        run = json.loads(next(line for line in said if '"run"' in line)[2:])
        self.assertEqual((len(run["a"]["faces"]), "faces" in run["b"]), (6, False))

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
                                 and field not in ("variant", "after", "judgement", "solid", "metre_sized", "policy", "dearer", "parts")
                                 and (field, line["type"]) != ("detail", "case"), field)
            self.assertFalse(validator(VERDICT).is_valid({**line, "more": 1}))
        good = {"type": "reply", "id": "1", "overlap": True, "depth": "0x1.8p3", "direction": [1, "nan", "-inf"]}
        validator(SUBJECT).validate(good)
        for wrong in ({"overlap": 1}, {"depth": "deep"}, {"direction": [1, 2]}, {"witness": {"a": 1}}, {"id": None}, {"type": "repl"}):
            self.assertFalse(validator(SUBJECT).is_valid({**good, **wrong}), wrong)


class Agreement(CertifyTest):
    """The program takes just what the schema allows."""

    HELLO = {"type": "hello", "protocol": "fathom/subject/1", "name": "mine", "version": "1", "precision": "binary64",
             "conventions": {"touching": "either", "depth": "positive", "moves": "a", "unit": True}}
    REPLY = {"type": "reply", "id": "7", "overlap": True}

    def takes(self, *lines):
        another = json.dumps({**self.REPLY, "id": "8"})  # so that a case is judged
        replies = self.file("replies.jsonl", "".join(line + "\n" for line in (*lines, another)))
        code, _, err = self.certify("--replay", replies, "-", stdin=boxes(0).replace("box::0", "7") + boxes(1).replace("box::1", "8"))
        self.assertIn(code, (0, 1, 2, 4), err)  # 2: the hello; 4: a case has no reply
        return code < 2

    def check(self, part, message):
        line = json.dumps(message)
        with self.subTest(line):
            self.assertEqual(self.takes(line), validator(SUBJECT, (part,)).is_valid(message))

    def test_numbers(self):
        for number in (1, -1.5, 0, 1e300, "1", "+1", "-1.5", "1.", ".5", ".", "", "-", "1e5", "1e", "1e+", "1E-5", "1/1", "4/2", "0x1.8p3",
                       "0x",
                       "0x.", "0x.8", "0xp1", "0X1P+1", "1p3", "nan", "-NaN", "nan(0x1)", "nan()", "nan(", "nan(-)", "nanx", "nano", "inf",
                       "+INF", "infinity",
                       "infinit", "--1", "1 ", " 1", "1,5", "one", "0b1", "1_0", "true", True, None, [], [1], {}, {"": 1}):
            self.check("reply", {**self.REPLY, "depth": number})

    def test_replies(self):
        for changes in ({"overlap": False}, {"overlap": "true"}, {"overlap": 1}, {"overlap": None}, {"overlap": "1/1"}, {"id": 7},
                        {"id": 7.0}, {"id": 7.5}, {"id": None},
                        {"id": True}, {"id": ["7"]}, {"type": "Reply"}, {"type": None}, {"more": None}, {"direction": [1, "0", "nan"]},
                        {"direction": [1, 2]},
                        {"direction": [1, 2, None]}, {"direction": None}, {"direction": []}, {"direction": "1,2,3"}, {"witness": None},
                        {"witness": {}},
                        {"witness": {"a": None}}, {"witness": {"a": [1, 2, 3]}}, {"witness": {"a": [1, 2, 3], "b": "x"}}, {"witness": [1]},
                        {"hull": {}}, {"hull": {"a": [[1, 2, 3]]}}, {"hull": {"a": [["0x1p3", "2", .5], [1, 2, 3]], "b": [[0, 0, 0]]}},
                        {"hull": {"a": []}},
                        {"hull": {"b": [[1, 2]]}}, {"hull": {"a": [[1, 2, "nan"]]}}, {"hull": {"b": [[1, 2, None]]}},
                        {"hull": {"a": [[1, "inf", 3]]}},
                        {"hull": None}, {"hull": []}, {"hull": {"a": None}}, {"hull": {"a": 7}}, {"hull": {"a": ["123"]}},
                        {"hull": {"b": [7]}},
                        {"microseconds": 3.5}, {"microseconds": "soon"}, {"microseconds": None}, {"microseconds": -1},
                        {"distance": "inf"}, {"distance": None}, {"contacts": None}, {"contacts": []}, {"contacts": {}},
                        {"contacts": [{"position": [1, 2, "nan"], "depth": "inf"}, {"position": [1, 2, 3]}]},
                        {"contacts": [{"position": [1]}]}, {"contacts": [{}]},
                        {"contacts": [[1, 2, 3]]}, {"contacts": [{"position": [1, 2, 3], "depth": None}]},
                        {"contacts": [{"position": [1, 2, 3], "more": 1}]},
                        {"unsupported": "x"}, {"failed": "x"}, {"unsupported": None}, {"failed": 7}):
            self.check("reply", {**self.REPLY, **changes})
            self.check("reply", {**self.REPLY, "overlap": False, **changes})
        nothing = {"type": "reply", "id": "7"}
        self.check("reply", nothing)
        for name in ("unsupported", "failed"):
            for value in ("x", "", 7, None, True, ["x"]):
                self.check("reply", {**nothing, name: value})
            for other in ({"depth": 1}, {"direction": [1, 0, 0]}, {"witness": {}}, {"hull": {}}, {"distance": 1},
                          {"contacts": [{"position": [1, 0, 0]}]},
                          {"unsupported": "y"}, {"failed": "y"}, {"more": 1}):
                self.check("reply", {**nothing, name: "x", **other})

    def test_hellos(self):
        good = json.dumps(self.REPLY)
        for changes in ({}, {"name": ""}, {"name": 7}, {"name": None}, {"version": 2.1}, {"version": ""}, {"version": None},
                        {"library": "fcl"}, {"library": None},
                        {"library": 1}, {"precision": "binary16"}, {"precision": 64}, {"settings": None}, {"settings": []},
                        {"settings": {"a": [1, None]}},
                        {"capabilities": None}, {"capabilities": {}}, {"capabilities": {"faces": 1}}, {"capabilities": {"faces": None}},
                        {"conventions": None}, {"conventions": {}}, {"promises": []}, {"promises": ["depth", "direction", "witness"]},
                        {"promises": ["distance", "contacts"]},
                        {"promises": ["depth", "depth"]}, {"promises": ["overlap"]}, {"promises": "depth"}, {"promises": None},
                        {"promises": [1]},
                        {"precision": {"points": "binary32", "answers": "binary64"}}, {"precision": {"points": "binary32"}},
                        {"precision": {}},
                        {"precision": {"points": "binary32", "answers": 64}}, {"rounding": 0.5}, {"rounding": 0}, {"rounding": -1},
                        {"rounding": "0.5"},
                        {"rounding": None}, {"rounding": {}}, {"rounding": {"vertices": 0.5, "box": 0}}, {"rounding": {"margin": 1}},
                        {"rounding": {"box": -1}},
                        {"rounding": {"rounded_box": 1}}, {"rounding": [1]}, {"protocol": 1}, {"more": None}):
            hello = {**self.HELLO, **changes}
            with self.subTest(changes):
                self.assertEqual(self.takes(json.dumps(hello), good), validator(SUBJECT, ("hello",)).is_valid(hello))
        for name, value in (("touching", "maybe"), ("depth", None), ("moves", "A"), ("unit", "true"), ("unit", 1), ("unit", None),
                            ("claims", "separating"),
                            ("claims", "minimum"), ("claims", "manifold"), ("claims", None)):
            hello = {**self.HELLO, "conventions": {**self.HELLO["conventions"], name: value}}
            with self.subTest(hello["conventions"]):
                self.assertEqual(self.takes(json.dumps(hello), good), validator(SUBJECT, ("hello",)).is_valid(hello))

    def test_bare_words(self):
        """What is no JSON: numbers as printf and Lua write them, and nothing else."""
        for text, taken in {"nan": True, "-inf": True, "0x1p3": True, ".5": True, "+1": True, "7.": True, "nano": False, "yes": False,
                            "True": False,
                            "1/1": False, "'1'": False}.items():
            with self.subTest(text):
                self.assertEqual(self.takes(f'{{"type":"reply","id":"7","overlap":true,"depth":{text}}}'), taken)
        for line in ('{type:"reply","id":"7","overlap":true}', '{"type":reply,"id":"7","overlap":true}',
                     '{"type":"reply","id":"7","overlap":"true"}'):
            self.assertFalse(self.takes(line), line)
        self.assertTrue(self.takes('{"type":"reply","id":7.0,"overlap":true}'))

    def test_distances(self):
        """Of the boxes, which are 0.5 apart."""
        hello = json.dumps({**self.HELLO, "promises": ["distance"]})
        bodies = {"id": "7", "a": {"vertices": [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)]},
                  "b": {"vertices": [[x, y, z] for x in (1.5, 2.5) for y in (0, 1) for z in (0, 1)]}}
        for reply, verdict, says in (({"distance": 0.5}, "pass", "right: 0.5 is claimed, the distance is 0.5 (correctly rounded)"),
                                     ({"distance": 0.75}, "too-far", "too far by 0.25"),
                                     ({"distance": 0.25}, "too-near", "too near by 0.25"),
                                     ({"distance": 0.5, "direction": [1, 0, 0]}, "wrong-sign", "the direction points the wrong way"),
                                     ({"distance": 0.5, "witness": {"a": [1, 0, 0], "b": [1.5, 1, 0]}}, "witness-off",
                                      "miss the distance by"),
                                     ({}, "inconsistent", "inconsistent: the hello promises distance, and the reply has none")):
            with self.subTest(reply):
                replies = self.file("replies.jsonl", hello + "\n" + json.dumps({**self.REPLY, "overlap": False, **reply}) + "\n")
                _, lines, _ = self.certify("--replay", replies, "-", stdin=json.dumps(bodies) + "\n")
                self.assertEqual(lines[1]["verdict"], verdict)
                self.assertIn(says, lines[1]["judgement"]["sentence"])
                self.assertEqual(lines[1]["judgement"]["distance_squared"], "1/4")
                self.assertEqual(lines[2]["judged"]["distance"], 1 if "distance" in reply else 0)

    def test_claims_and_policies(self):
        """The boxes overlap by 0.5 along x, and by 1 along y, which is answered."""
        separating = {**self.HELLO, "conventions": {**self.HELLO["conventions"], "claims": "separating"}}
        reply = json.dumps({**self.REPLY, "depth": 1, "direction": [0, 1, 0]})
        for hello, policy, verdict in ((self.HELLO, None, "too-deep"), (self.HELLO, "declared", "too-deep"),
                                       (self.HELLO, "minimum", "too-deep"),
                                       (self.HELLO, "separating", "pass"), (separating, None, "pass"), (separating, "minimum", "too-deep"),
                                       (self.HELLO, "within=100%", "pass"), (separating, "within=99.999%", "too-deep")):
            with self.subTest((hello["conventions"], policy)):
                replies = self.file("replies.jsonl", json.dumps(hello) + "\n" + reply + "\n")
                more = [] if policy is None else ["--policy", policy]
                for again in ([], ["--method", "exact"]):
                    code, lines, err = self.certify("--replay", replies, "-", *more, *again, stdin=boxes(0).replace("box::0", "7"))
                    self.assertEqual((code, lines[1]["verdict"]), (0 if verdict == "pass" else 1, verdict), err)
                    for line in lines:
                        validator(VERDICT).validate(line)
                    self.assertEqual(lines[0]["policy"], {None: "declared", "within=99.999%": "within=99999/1000%"}.get(policy, policy))
                    self.assertEqual(lines[1]["judgement"]["dearer"], 1)
                    self.assertEqual(lines[1]["judgement"].get("longer", False), verdict == "pass")
                    self.assertEqual(lines[2]["dearer"], {"answers": 1, "median": 1, "worst": 1, "longer_pass": int(verdict == "pass")})
        _, table, _ = self.run_cli("certify", "--replay", replies, "-", "--policy", "separating", stdin=boxes(0).replace("box::0", "7"))
        self.assertIn("price        median 1 above the depth, worst 1, of 1 direction; 1 longer translation passes by the policy", table)
        self.assertIn("claims: separating", " ".join(table.split()))
        for policy in ("", "within=5", "within=-1%", "manifold"):
            code, _, err = self.certify("--replay", replies, "-", "--policy", policy, stdin=boxes(0))
            self.assertEqual(code, 2)
            self.assertIn("declared, minimum, separating or within=P%", err)

    def test_solid_and_metre_sized(self):
        """Of four cases: both, flat, too small, and one whose bodies touch, a unit and 101 units long."""
        def pair(name, b, scale=1):
            a = [[x * scale, y * scale, z * scale] for x in (0, 1) for y in (0, 1) for z in (0, 1)]
            return json.dumps({"id": name, "a": {"vertices": a},
                               "b": {"vertices": [[x * scale, y * scale, z * scale] for x, y, z in b]}}) + "\n"
        solid, flat = [[0.5, 0, 0], [2, 0, 0], [0.5, 1, 0], [0.5, 0, 1]], [[0.5, 0, 0], [2, 0, 0], [0.5, 1, 0]]
        cases = pair("both", solid) + pair("flat", flat) + pair("small", solid,
                                                                1 / 256) + pair("long", [[1, 0, 0], [102, 0, 0], [1, 1, 0], [1, 0, 1]])
        _, lines, _ = self.certify("--subject", liar("honest"), "-", stdin=cases)
        found = {line["id"]: (line["solid"], line["metre_sized"]) for line in lines if line["type"] == "case"}
        self.assertEqual(found, {"both": (True, True), "flat": (False, True), "small": (True, False), "long": (True, False)})
        parts = lines[-1]["parts"]
        self.assertEqual({name: part["cases"] for name, part in parts.items()}, {"solid": 3, "metre_sized": 2, "solid_and_metre_sized": 1})
        for part in parts.values():
            self.assertEqual(sum(part["verdicts"].values()), part["cases"])
            self.assertEqual(part["passed"] + part["failed"] + part["unsupported"], part["cases"])
        _, table, _ = self.run_cli("certify", "--subject", liar("honest"), "-", stdin=cases)
        rows = [line.split()[:2] for line in table.splitlines()]
        for row in (["all", "4"], ["solid", "3"], ["metre-sized", "2"], ["both", "1"]):
            self.assertIn(row, rows)

    def test_promises(self):
        hello = json.dumps({**self.HELLO, "promises": ["depth", "direction", "witness"]})
        direction, witness = {"direction": [-1, 0, 0]}, {"witness": {"a": [1, 0, 0], "b": [0.5, 0, 0]}}
        for reply, verdict, says in (({"depth": 0.5, **direction, **witness}, "pass", "right"),
                                     ({**direction, **witness}, "inconsistent",
                                      "inconsistent: the hello promises depth, and the reply has none"),
                                     ({"depht": 0.5}, "inconsistent", "inconsistent: the hello promises depth, direction, witness, and"),
                                     ({"depth": 0.5, **direction, "witness": {"a": [1, 0, 0]}}, "inconsistent",
                                      "inconsistent: the hello promises witness"),
                                     ({"depth": 0.25, **direction}, "too-shallow",
                                      "inconsistent: the hello promises witness, and the reply has none"),
                                     ({"overlap": False}, "false-separation", "said to be apart"),
                                     ({"overlap": False, "distance": 1}, "false-separation",
                                      "too far by 1: 1 is claimed, the distance is 0")):
            with self.subTest(reply):
                replies = self.file("replies.jsonl", hello + "\n" + json.dumps({**self.REPLY, **reply}) + "\n")
                _, lines, _ = self.certify("--replay", replies, "-", stdin=boxes(0).replace("box::0", "7"))
                self.assertEqual(lines[0]["subject"]["promises"], ["depth", "direction", "witness"])
                self.assertEqual(lines[1]["verdict"], verdict)
                self.assertIn(says, lines[1]["judgement"]["sentence"])
                self.assertEqual("inconsistent" in lines[1]["judgement"]["findings"], "promises" in says)
                for line in lines:
                    validator(VERDICT).validate(line)


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

    def test_ids_too_long_for_the_name_of_a_file(self):
        long = "x" * 300
        stream = boxes(0, marked=True).replace("box::0", long) + boxes(1, marked=True).replace("box::1", long + "y") + boxes(2)
        code, lines, err = self.certify("--certificates", self.folder / "proofs", "--shrink", self.folder / "small", "--html",
                                        self.folder / "page",
                                        "--junit", self.folder / "junit", "--report", self.folder / "r", "--subject", liar("too-deep"), "-",
                                        stdin=stream)
        self.assertEqual((code, lines[-1]["failed"]), (1, 2), err)
        self.assertEqual(len(list((self.folder / "proofs").iterdir())), 2)

    def test_long_time_outs(self):
        for seconds in ("1e6", "1e9", "1e30", "1e400"):
            code, lines, err = self.certify("--time-out", seconds, "--subject", liar("honest"), "-", stdin=boxes(0))
            self.assertEqual((code, self.verdicts(lines), err), (0, {"box::0": "pass"}, ""))

    def test_adapters(self):
        names = [line.split()[0] for line in self.answer("certify", "--list-adapters").splitlines()]
        self.assertEqual(len(names), len(set(names)))
        self.assertIn("libccd-epa", names)
        self.refused("certify", "--adapter", "libccd", DATA / "real_cases.jsonl")

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


class Replays(CertifyTest):
    REPLY = '{"type":"reply","id":"box::0","overlap":true,"depth":0.5,"direction":[-1,0,0]}\n'

    def replay(self, replies, stream):
        return self.certify("--replay", self.file("replies.jsonl", replies), "-", stdin=stream)

    def test_whole(self):
        code, lines, err = self.replay(self.REPLY, boxes(0))
        self.assertEqual((code, self.verdicts(lines), err), (0, {"box::0": "pass"}, ""))
        self.assertEqual(lines[0]["subject"]["name"], "replay")

    def test_from_standard_input(self):
        cases = self.file("cases.jsonl", boxes(0))
        code, lines, err = self.certify("--replay", "-", cases, stdin=self.REPLY)
        self.assertEqual((code, self.verdicts(lines), err), (0, {"box::0": "pass"}, ""))
        code, _, err = self.certify("--replay", "-", cases, stdin="noise\n")
        self.assertIn("<stdin>:1: expected a JSON object, found 'noise'", err)
        self.assertIn("cannot both come from standard input", self.refused("certify", "--replay", "-", "-", stdin=self.REPLY))

    def test_hello_and_order(self):
        hello = ('{"type":"hello","protocol":"fathom/subject/1","name":"mine","version":"3","precision":"binary32",'
                 '"conventions":{"touching":"either","depth":"negative","moves":"b","unit":true}}\n')
        mirrored = self.REPLY.replace("-1,", "1,")
        replies = mirrored.replace("0.5", "-0.4").replace("::0", "::100") + mirrored.replace("0.5", "-0.5")
        code, lines, err = self.replay(hello + replies, boxes(0) + boxes(100))
        self.assertEqual((code, set(self.verdicts(lines).values()), lines[0]["subject"]["precision"]), (0, {"pass"}, "binary32"), err)

    def test_lacks_a_case(self):
        code, lines, err = self.replay(self.REPLY, boxes(0) + boxes(1))
        self.assertEqual((code, self.verdicts(lines), lines[-1]["type"]), (4, {"box::0": "pass"}, "case"))
        self.assertIn("no reply to case 'box::1'", err)

    def test_more_than_asked(self):
        code, lines, err = self.replay(self.REPLY + self.REPLY.replace("::0", "::9"), boxes(0))
        self.assertEqual((code, self.verdicts(lines)), (0, {"box::0": "pass"}))
        self.assertIn("the reply to 'box::9' is to no case", err)

    def test_two_replies(self):
        code, lines, _ = self.replay(self.REPLY + self.REPLY, boxes(0))
        self.assertEqual((code, self.verdicts(lines)), (1, {"box::0": "garbage"}))

    def test_bad_lines(self):
        code, lines, err = self.replay(self.REPLY + "noise\n" + self.REPLY[:30], boxes(0))
        self.assertEqual((code, self.verdicts(lines)), (2, {"box::0": "pass"}))
        self.assertIn("replies.jsonl:2: expected a JSON object, found 'noise'", err)
        self.assertIn("replies.jsonl:3: ", err)

    def test_empty(self):
        self.refused("certify", "--replay", self.file("empty.jsonl", "\n"), "-", stdin=boxes(0))
        self.refused("certify", "--replay", self.file("hello.jsonl", '{"type":"hello"}\n'), "-", stdin=boxes(0))
        self.refused("certify", "--replay", self.folder / "missing", "-", stdin=boxes(0))


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
    def test_refusals(self):
        for words in ([], ["x.jsonl"], ["--subject", "x"], ["--subject", "x", "--replay", "y", "z"], ["--subject", "x", "a", "b"],
                      ["--subject", "x", "--resume", "z"], ["--subject", "x", "--jobs", "0", "z"],
                      ["--subject", "x", "--time-out", "0", "z"],
                      ["--subject", "x", "--tol-rel", "-1", "z"], ["--subject", "x", "--tol-ulps", "1.5", "z"],
                      ["--subject", "x", "--metamorphic=turn", "z"], ["--replay", "x", "--metamorphic", "z"],
                      ["--replay", "x", "--shrink", "d", "z"],
                      ["--list-adapters", "z"], ["--subject", "x", "--max-errors", "-1", "z"],
                      ["--subject", "true", "/nowhere/cases.jsonl"],
                      ["--subject", "true", "--expect-fail", "/nowhere/list", "-"]):
            with self.subTest(words):
                self.refused("certify", *words)

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
