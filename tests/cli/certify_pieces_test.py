# SPDX-License-Identifier: GPL-3.0-or-later
"""fathom certify on unions of convex pieces: pairs of pieces are put to the subject, and the deepest of its answers is priced."""
import json
import math
import re
import sys
import unittest

from certify_harness import CertifyTest
from certify_schemas import SUBJECT, VERDICT, validator
from harness import DATA, ROOT, box

# Exact on boxes along the axes, times a factor; boxes whose first coordinate is 99 end it.
BOXES = """
import json, os, sys
sys.path.insert(0, sys.argv[1])
import fathom_subject

log = open(sys.argv[3], "a")


def reach(vertices):
    return [(min(v[k] for v in vertices), max(v[k] for v in vertices)) for k in range(3)]


def pair(a, b):
    a, b = reach(a), reach(b)
    if a[0][0] == 99:
        os.kill(os.getpid(), 9)
    ways = []
    for k in range(3):
        for way, depth in ((-1, a[k][1] - b[k][0]), (1, b[k][1] - a[k][0])):
            ways.append((depth, [way if i == k else 0 for i in range(3)]))
    return min(ways, key=lambda w: w[0])


def solve(a, b):
    print(json.dumps([a.vertices, b.vertices, a.pieces, b.pieces]), file=log, flush=True)
    lists = [[piece["vertices"] for piece in body.pieces] or [body.vertices] for body in (a, b)]
    depth, direction = max((pair(p, q) for p in lists[0] for q in lists[1]), key=lambda w: w[0])
    return fathom_subject.Reply(True, depth * float(sys.argv[2]), direction) if depth > 0 else fathom_subject.Reply(False)


fathom_subject.run(solve, name="boxes", version="1", precision=sys.argv[4], **json.loads(sys.argv[5]))
"""


def pieces_of(name):
    """The groups of an OBJ file as pieces."""
    vertices, groups = [], []
    for line in (DATA / name).read_text().splitlines():
        kind, *words = line.split() or [""]
        if kind == "o":
            groups.append(set())
        if kind == "v":
            vertices.append([float(w) for w in words])
        if kind == "f":
            groups[-1] |= {int(w) - 1 for w in words}
    return {"pieces": [{"vertices": [vertices[i] for i in sorted(group)]} for group in groups]}


def hull(low, high):
    return {"vertices": box(low, high)}


def pair(name, a, b):
    return json.dumps({"id": name, "a": a, "b": b}) + "\n"


KEY, COMB = pieces_of("key.obj"), pieces_of("comb.obj")
KEY_IN_COMB = pair("key", KEY, COMB)
# One half deep in the only piece that it meets.
EASY = pair("easy", hull([0, 0, 0], [1, 1, 1]), {"pieces": [hull([0.5, -9, -9], [9, 9, 9]), hull([20, 0, 0], [21, 1, 1])]})
APART = pair("apart", hull([0, 0, 0], [1, 1, 1]), {"pieces": [hull([3, 0, 0], [4, 1, 1]), hull([2, 0, 0], [4, 1, 1])]})


class Pieces(CertifyTest):
    def subject(self, factor=1, precision="binary64", **more):
        self.log = self.folder / "log"
        program = self.file("boxes.py", BOXES)
        return (f"exec '{sys.executable}' -B '{program}' '{ROOT / 'verify' / 'subjects' / 'kit'}' {factor} '{self.log}' {precision} "
                f"'{json.dumps(more)}'")

    def judged(self, *arguments, stdin=KEY_IN_COMB + EASY + APART, **how):
        code, lines, err = self.certify("--jobs", "1", *arguments, "--subject", self.subject(**how), "-", stdin=stdin)
        for line in lines:
            validator(VERDICT).validate(line)
        return code, {line.get("id", line["type"]): line for line in lines if line["type"] != "header"}, err

    def asked(self):
        return [json.loads(line) for line in self.log.read_text().splitlines()]

    def test_the_price_of_the_deepest_pair(self):
        code, found, err = self.judged()
        self.assertEqual((code, err), (1, ""))
        self.assertEqual({name: line["verdict"] for name, line in found.items() if name != "summary"},
                         {"key": "too-shallow", "easy": "pass", "apart": "pass"})
        key = found["key"]
        self.assertEqual((key["reply"]["depth"], key["judgement"]["depth_squared"]), (0.5, "5/8"))
        self.assertEqual(key["judgement"]["findings"], ["too-shallow", "not-separating"])
        self.assertEqual(key["judgement"]["deepest_pair"], {"squared": "1/4", "pieces": [0, 1]})
        self.assertEqual((key["judgement"]["deeper_squared"], key["judgement"]["hulls_squared"]), ("5/2", "9/4"))
        self.assertEqual(key["judgement"]["deeper"], math.sqrt(2.5))
        self.assertEqual(key["judgement"]["sentence"],
                         "too shallow by 0.2906: 0.5 is claimed, the depth is 0.7905694150420949, 1.581 times as "
                         "much; not separating: 0.3536 of overlap is left after its translation")
        self.assertEqual((key["pieces"]["pairs"], key["pieces"]["answer_of"], key["pieces"]["query"]["verdict"]), (15, [0, 1], "pass"))
        self.assertEqual(found["easy"]["judgement"]["deeper_squared"], "1")
        self.assertEqual(found["summary"]["unions"], {
            "overlapping": 2, "pair_enough": 1, "answers": 2, "deeper": 1,
            "times": {"amount": math.sqrt(2.5), "case": "key"}, "by": {"amount": -key["judgement"]["error"], "case": "key"}})
        self.assertEqual(len(self.asked()), 15 + 2 + 2)

    def test_what_it_is_asked(self):
        self.judged(stdin=EASY)
        self.assertEqual(self.asked(), [[box([0, 0, 0], [1, 1, 1]), b, [], []]
                                        for b in (box([0.5, -9, -9], [9, 9, 9]), box([20, 0, 0], [21, 1, 1]))])

    def test_in_its_own_precision_and_size(self):
        tenth = pair("tenth", hull([0, 0, 0], [1, 1, 1]), {"pieces": [hull([0.9, -9, -9], [9, 9, 9]), hull([30, 0, 0], [31, 1, 1])]})
        _, found, _ = self.judged("--fit", "1", stdin=tenth, precision="binary32")
        self.assertEqual((found["tenth"]["verdict"], found["tenth"]["fit"]), ("pass", -5), "the longest side of the whole union is 31.1")
        self.assertNotEqual(found["tenth"]["judgement"]["depth_squared"], "1/100")
        self.assertEqual(found["tenth"]["judgement"]["accuracy"], "correctly rounded")
        self.assertEqual(max(max(v) for v in self.asked()[0][0]), 1 / 32)

    def test_the_table(self):
        code, out, err = self.run_cli("certify", "--jobs", "1", "--subject", self.subject(), "-", stdin=KEY_IN_COMB + EASY)
        self.assertEqual((code, err), (1, ""))
        text = " ".join(out.split())
        self.assertIn("unions the deepest pair of pieces is enough in 1 of 2; deeper than 1 of 2 answers; up to 1.581 times as deep (key); "
                      "deeper by up to 0.2906 (key)", text)

    def test_a_wrong_engine_is_told_from_a_wrong_idea(self):
        _, found, _ = self.judged(factor=2)
        self.assertEqual(found["key"]["verdict"], "too-deep")
        self.assertEqual(found["key"]["pieces"]["query"]["verdict"], "too-deep")

    def test_certificates_prove_the_unions(self):
        folder = self.folder / "proofs"
        self.judged("--certificates", str(folder))
        self.assertEqual([path.name for path in folder.iterdir()], ["key.cert"])
        code, out, err = self.run_cli("check", str(folder / "key.cert"))
        self.assertEqual((code, out), (0, "s VERIFIED penetrating depth_squared=5/8 optima=1 pieces=3x5 key\n"), err)

    def test_methods_ask_for_the_proof(self):
        self.assertEqual(self.judged("--method", "exact", "--method", "naive")[1]["key"]["verdict"], "too-shallow")

    def test_the_page(self):
        page = self.folder / "page.html"
        self.judged("--html", str(page))
        text = page.read_text()
        for part in ("Unions of key", "1.5811388300841898 times (squared: 5/2)", "piece 0 of A, piece 1 of B",
                     "pass: right: 0.5 is claimed, the depth is 0.5 (correctly rounded)", "the deepest pair of pieces is enough in 1 of 2"):
            self.assertIn(part, text)
        self.assertIn("&quot;pieces&quot;", text, "the case to be copied")

    def test_a_report_is_resumed(self):
        report = str(self.folder / "report.jsonl")
        _, first, _ = self.judged("--report", report)
        _, again, _ = self.judged("--report", report, "--resume")
        self.assertEqual(len(self.asked()), 19, "nothing is asked again")
        for name in ("key", "easy", "apart"):
            self.assertEqual(first[name], again[name])
        self.assertEqual(first["summary"]["unions"], again["summary"]["unions"])

    def test_symmetries(self):
        code, lines, err = self.certify("--jobs", "1", "--metamorphic", "--subject", self.subject(), "-", stdin=EASY + APART)
        self.assertEqual((code, err), (0, ""))
        self.assertEqual(sorted(line["variant"] for line in lines if "variant" in line),
                         sorted(2 * ["swap", "translate", "permute", "scale", "repeat"]))

    def test_small_cases_are_not_looked_for(self):
        folder = self.folder / "small"
        code, out, err = self.run_cli("certify", "--jobs", "1", "--shrink", str(folder), "--subject", self.subject(), "-",
                                      stdin=KEY_IN_COMB)
        self.assertEqual(code, 1)
        self.assertIn("too-shallow of key: cases of unions are not made smaller; the case as it was seen: ", err)
        self.assertEqual(json.loads((folder / "too-shallow.case.json").read_text())["b"], COMB)

    def test_no_answer_about_one_pair_is_none(self):
        deadly = pair("deadly", {"pieces": [hull([0, 0, 0], [1, 1, 1]), hull([99, 0, 0], [100, 1, 1])]}, hull([0.5, 0, 0], [2, 2, 2]))
        code, found, _ = self.judged(stdin=deadly + EASY)
        self.assertEqual((found["deadly"]["verdict"], found["easy"]["verdict"]), ("crash", "pass"))
        self.assertEqual(found["deadly"]["detail"], "piece 1 of A, piece 0 of B: killed by signal 9 (Killed)")

    def test_what_it_declares_it_gets_whole(self):
        code, found, err = self.judged(stdin=KEY_IN_COMB + EASY, shapes=["pieces"])
        self.assertEqual((found["key"]["verdict"], found["easy"]["verdict"]), ("too-shallow", "pass"))
        self.assertNotIn("pieces", found["key"])
        self.assertEqual(len(self.asked()), 2)
        self.assertEqual(self.asked()[0][2:], [KEY["pieces"], COMB["pieces"]])
        self.assertEqual(self.asked()[1][0], box([0, 0, 0], [1, 1, 1]), "a plain body is one")

    def test_messages_obey_their_schema(self):
        whole = {"type": "run", "id": "1", "a": KEY, "b": hull([0, 0, 0], [1, 1, 1])}
        validator(SUBJECT).validate(whole)
        self.assertFalse(validator(SUBJECT).is_valid({**whole, "a": {"pieces": KEY["pieces"][:1]}}))

    def test_rounding_is_declined(self):
        _, found, _ = self.judged(stdin=KEY_IN_COMB, rounding=0.125)
        self.assertEqual((found["key"]["verdict"], found["key"]["detail"]),
                         ("unsupported", "the subject rounds bodies by a radius, and the depth of unions with radii is not known"))

    def test_pieces_need_interiors(self):
        flat = pair("flat", {"pieces": [hull([0, 0, 0], [1, 1, 1]), hull([0, 0, 0], [1, 1, 0])]}, hull([0.5, 0, 0], [2, 2, 2]))
        code, found, err = self.judged(stdin=EASY + flat)
        self.assertEqual((code, found["easy"]["verdict"]), (2, "pass"))
        self.assertIn("a: piece 1 is flat: the pieces of a union need interiors", err)
        thin = pair("thin", {"pieces": [hull([0, 0, 0], [1, 1, 1]), hull([0, 0, 1], [1, 1, 1 + 2**-40])]}, hull([0.5, 0, 0], [2, 2, 2]))
        _, found, _ = self.judged(stdin=thin, precision="binary32")
        self.assertEqual(found["thin"]["detail"], "piece 1 of A has no interior in binary32, the precision of the subject")

    def test_round_bodies_beside_unions_are_refused(self):
        code, _, err = self.run_cli("certify", "--subject", self.subject(), "-",
                                    stdin=EASY + pair("round", {"shape": "sphere", "radius": 1}, COMB))
        self.assertEqual(code, 2)
        self.assertIn("expected pieces or a polytope", err)

    def replayed(self, replies, cases):
        path = self.file("replies.jsonl", "".join(json.dumps({"type": "reply", **reply}) + "\n" for reply in replies))
        code, lines, err = self.certify("--replay", path, self.file("cases.jsonl", cases))
        return code, {line["id"]: line for line in lines if line["type"] == "case"}, err

    def test_replies_from_a_file(self):
        deep = {"overlap": True, "depth": 0.5, "direction": [-1, 0, 0]}
        of_pairs = [{"id": "easy[0,0]", **deep}, {"id": "easy[0,1]", "overlap": False}]
        code, found, err = self.replayed(of_pairs, EASY)
        self.assertEqual((code, found["easy"]["verdict"], found["easy"]["pieces"]["pairs"], err), (0, "pass", 2, ""))
        code, found, err = self.replayed([{"id": "easy", **deep}], EASY)
        self.assertEqual((code, found["easy"]["verdict"], "pieces" in found["easy"], err), (0, "pass", False, ""))
        code, found, err = self.replayed(of_pairs[:1], EASY)
        self.assertEqual((code, found), (4, {}))
        self.assertIn("no reply to case 'easy[0,1]'", err)
        code, found, err = self.replayed([*of_pairs, {"id": "easy[1,0]", "overlap": False}], EASY)
        self.assertIn("the reply to 'easy[1,0]' is to no case", err)

    def test_libraries(self):
        code, out, _ = self.run_cli("certify", "--list-adapters")
        for name in ("libccd-epa", "fcl-signed"):
            with self.subTest(name):
                if re.search(rf"^{name} .*not built", out, re.MULTILINE):
                    self.skipTest(f"{name} is not built")
                code, lines, err = self.certify("--adapter", name, "-", stdin=KEY_IN_COMB + EASY)
                found = {line["id"]: line for line in lines if line["type"] == "case"}
                self.assertEqual(found["easy"]["verdict"], "pass", found["easy"])
                self.assertEqual(found["key"]["verdict"], "too-shallow", found["key"])
                self.assertAlmostEqual(found["key"]["judgement"]["deeper"], math.sqrt(2.5), places=3)


if __name__ == "__main__":
    unittest.main()
