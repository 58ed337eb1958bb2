# SPDX-License-Identifier: GPL-3.0-or-later
"""fathom certify --shrink: small cases with the same verdict, their certificates and snippets; and cases from FCL's exception text."""
import json
import sys
import unittest

from harness import CliTest, case

# Answers for boxes. RULE "shallow": a depth of 0 whenever A has five points or more. "dies": ends where A has four or more. "lopsided": a
# little too deep where A has more points than B, and a little too shallow elsewhere, both within the tolerance.
SUBJECT = """
import json, sys
for line in sys.stdin:
    message = json.loads(line)
    if message["type"] == "stop":
        break
    if message["type"] == "hello":
        answer = {"type": "hello", "protocol": "fathom/subject/1", "name": "shallow", "version": "1", "precision": "binary64",
                  "conventions": {"touching": "either", "depth": "positive", "moves": "a", "unit": True}}
    else:
        a, b = message["a"]["vertices"], message["b"]["vertices"]
        if RULE == "dies" and len(a) > 3:
            sys.exit(3)
        apart = any(max(p[i] for p in a) <= min(p[i] for p in b) or max(p[i] for p in b) <= min(p[i] for p in a) for i in range(3))
        answer = {"type": "reply", "id": message["id"], "overlap": not apart}
        if not apart:
            reach = [min(max(p[i] for p in a) - min(p[i] for p in b), max(p[i] for p in b) - min(p[i] for p in a)) for i in range(3)]
            factor = {"shallow": len(a) <= 4, "lopsided": 1.0008 if len(a) > len(b) else 0.9992}[RULE]
            answer["depth"] = factor * min(reach)
    print(json.dumps(answer), flush=True)
"""

BOX = """  Original error message: gjk_libccd-inl.h:(1715): it failed.
  Shape 1: Box2 2 2
  X_FS1
1 0 0 0
0 1 0 0
0 0 1 0.10000000000000000555
0 0 0 1
  Shape 2:
Box<double>(2, 2, 2);
  X_FS2
1, 0, 0, 0,
0, 1, 0, 0,
0, 0, 1, 1.5,
0, 0, 0, 1;
"""


class Shrink(CliTest):
    def subject(self, rule):
        path = self.file(f"{rule}.py", f"RULE = {rule!r}\n" + SUBJECT)
        return f"{sys.executable} -B {path}"

    def boxes(self):
        corners = [[x, y, z] for x in (0, 1.25) for y in (0, 1.5) for z in (0, 1.75)]
        moved = [[x + 0.3125, y + 0.125, z + 1.0625] for x, y, z in corners]
        return case(corners, moved[:7], id="boxes")

    def shrink(self, rule, *options):
        folder = self.folder / f"small_{rule}"
        code, out, err = self.run_cli("certify", "--subject", self.subject(rule), "--jobs", 1, *options, "--shrink", folder, "-",
                                      stdin=self.boxes())
        self.assertEqual(code, 1, err)
        return folder, out

    def test_a_wrong_depth(self):
        folder, out = self.shrink("shallow")
        self.assertEqual({path.name for path in folder.iterdir()}, {f"too-shallow.{ending}" for ending in ("case.json", "cert", "cpp")})
        small = json.loads((folder / "too-shallow.case.json").read_text())
        self.assertEqual(len(small["a"]["vertices"]), 5)
        for body in ("a", "b"):
            for vertex in small[body]["vertices"]:
                for value in vertex:
                    self.assertIn(value, range(-4, 5))
        self.assertIn("s VERIFIED penetrating", self.answer("check", folder / "too-shallow.cert"))
        self.assertIn("fathom::judge", (folder / "too-shallow.cpp").read_text())
        self.assertIn("too-shallow of boxes", out)
        code, out, err = self.run_cli("certify", "--json", "--subject", self.subject("shallow"), folder / "too-shallow.case.json")
        self.assertEqual(code, 1, err)
        self.assertEqual([json.loads(line)["verdict"] for line in out.splitlines() if '"verdict"' in line], ["too-shallow"])

    def test_a_silent_exit(self):
        folder, _ = self.shrink("dies")
        path, = folder.glob("*.case.json")
        small = json.loads(path.read_text())
        self.assertEqual([len(small[body]["vertices"]) for body in ("a", "b")], [4, 4])
        self.assertEqual({value for body in ("a", "b") for vertex in small[body]["vertices"] for value in vertex}, {0, 1})
        self.assertEqual(len(list(folder.iterdir())), 3)

    def test_an_answer_that_a_swap_changes(self):
        folder, out = self.shrink("lopsided", "--metamorphic=swap,scale")
        self.assertEqual({path.name for path in folder.iterdir()},
                         {f"not-invariant~swap.{ending}" for ending in ("case.json", "cert", "cpp")})
        self.assertIn("differ by ", (folder / "not-invariant~swap.cpp").read_text())
        self.assertIn(f"\n  {folder}/not-invariant~swap.cert\n", out)

    def test_no_control_character_of_an_id_reaches_a_terminal(self):
        evil = "x\x1b[2J\x9b31m\nfathom: fine"
        stream = self.boxes().replace('"boxes"', json.dumps(evil))
        code, out, err = self.run_cli("certify", "--subject", self.subject("shallow"), "--jobs", 1, "--shrink", self.folder / "small", "-",
                                      stdin=stream)
        self.assertEqual(code, 1, err)
        self.assertIn("too-shallow of x\\x1b[2J\\xc2\\x9b31m\\x0afathom: fine: ", out)
        self.assertEqual([c for c in out + err if c != "\n" and not c.isprintable()], [])


class FromFcl(CliTest):
    def test_a_log_becomes_cases(self):
        path = self.file("error.log", "noise\n" + BOX + "noise\n" + BOX.replace("1.5", "1.625"))
        lines = self.answer("cases", "--from-fcl", path).splitlines()
        cases = [json.loads(line) for line in lines]
        self.assertEqual([one["id"] for one in cases], [f"{path}:3", f"{path}:18"])
        self.assertEqual(cases[0]["pose_rounding"], "binary64")
        self.assertEqual(cases[0]["comment"], "gjk_libccd-inl.h:(1715): it failed.")
        self.assertEqual(cases[1]["b"]["pose"][2], [0, 0, 1, 1.625])
        # -1 + 0.1 and 1 + 0.1 are rounded once: the upper side of A lies at the binary64 number 1.1.
        answers = [json.loads(line) for line in self.answer("depth", "--json", "-", stdin="\n".join(lines) + "\n").splitlines()]
        self.assertEqual(answers[0]["depth"]["value"], 1.1 - 0.5)
        self.assertEqual(self.answer("cases", "--from-fcl", "-", stdin=BOX).count("\n"), 1)


if __name__ == "__main__":
    unittest.main()
