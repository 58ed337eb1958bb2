#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""fathom-check and check.py as programs, on certificates of unions."""
import json
import re
import sys
import unittest

sys.dont_write_bytecode = True
import check_program_test as program  # noqa: E402


class Unions(program.ProgramTest):
    def test_accepted(self):
        files = sorted((program.DATA / "format_3").glob("*.cert"))
        self.assertEqual(self.both(*files), (0, [
            "s VERIFIED penetrating depth_squared=1 optima=1 pieces=2x1 a%20cube%20in%20two%20pieces",
            "s VERIFIED disjoint distance_squared=25 pieces=2x2 pieces%20apart",
            "s VERIFIED touching depth_squared=0 pieces=2x2 pieces%20touching"]))
        texts = [file.read_text() for file in files]
        code, lines = self.both("-", stdin=program.CUBES.join(texts) + texts[0].replace("claim depth 1", "claim depth 2") + texts[1][:-1] +
                                program.APART)
        self.assertEqual((code, lines[1], lines[3:6]),
                         (2, program.CUBES_OK, [program.CUBES_OK, lines[4], "s REFUSED a%20cube%20in%20two%20pieces"]))
        self.assertTrue(lines[6].startswith("s MALFORMED pieces%20apart:"), lines)

    def test_echo(self):
        code, lines, _ = self.run_program(program.CHECK, "--echo", program.DATA / "format_3" / "cube_in_two_pieces.cert")
        self.assertEqual((code, lines[:4], lines[11:13], lines[20:24], lines[-2]),
                         (0, ["c id a%20cube%20in%20two%20pieces", "c pieces_a 2", "c a 8", "c 0 0 0"], ["c a 8", "c 1 0 0"],
                          ["c pieces_b 1", "c b 8", "c 1 0 0", "c 3 0 0"], "c claim depth 1"))
        code, lines, _ = self.run_program(program.CHECK, "--echo", program.DATA / "format_3" / "pieces_apart.cert")
        self.assertEqual((code, lines[-2]), (0, "c claim apart 25"))

    def test_width(self):
        certificate = program.DATA / "format_3" / "cube_in_two_pieces.cert"
        code, lines, _ = self.run_program(program.CHECK, "--width", certificate)
        self.assertEqual((code, program.reason(lines[0])), (1, "unions have no width here: it is that of a convex body"))

    def test_case(self):
        def box(low, high):
            return {"vertices": [[(low, high)[s >> k & 1][k] for k in range(3)] for s in range(8)]}

        def checked(a, b, name="cube_in_two_pieces", **more):
            case = self.file("case.json", json.dumps({"a": a, "b": b, **more}))
            code, lines, _ = self.run_program(program.CHECK, "--case", case, program.DATA / f"{name}.cert" if "/" in name
                                              else program.DATA / "format_3" / f"{name}.cert")
            return code, program.reason(lines[0]) if code == 1 else ""

        left, right, b = box((0, 0, 0), (1, 2, 2)), box((1, 0, 0), (2, 2, 2)), box((1, 0, 0), (3, 2, 2))
        whole = {"pieces": [left, right]}
        self.assertEqual(checked(whole, b), (0, ""))
        self.assertEqual(checked(whole, {"pieces": [b]}), (0, ""))
        self.assertEqual(checked({**whole, "pieces": [right, left]}, b), (1, "point 0 of piece 0 of a is not that of the case"))
        self.assertEqual(checked({"pieces": [left]}, b), (1, "the case has 1 pieces in a, the certificate 2"))
        self.assertEqual(checked(left, b), (1, "the case has 1 pieces in a, the certificate 2"))
        self.assertEqual(checked({"pieces": [left, {"vertices": right["vertices"][:7]}]}, b),
                         (1, "the case has 7 points in piece 1 of a, the certificate 8"))
        self.assertEqual(checked(whole, left), (1, "point 0 of piece 0 of b is not that of the case"))
        right["vertices"][7] = [2, 2, "2000000001/1000000000"]
        self.assertEqual(checked(whole, b), (1, "point 7 of piece 1 of a is not that of the case"))
        self.assertEqual(checked(whole, b, pose_rounding="binary64")[0], 1)
        right["vertices"][7] = [2, 2, "20000000000000000001/10000000000000000000"]
        self.assertEqual(checked(whole, b)[0], 1)
        self.assertEqual(checked(whole, b, pose_rounding="binary64")[0], 0)
        # A piece's own pose comes first: the turn by a right angle around z, then the body's, a translation.
        turned = {"vertices": [[y, -x, z] for x, y, z in box((0, -2, 0), (1, 0, 2))["vertices"]],
                  "pose": [[0, -1, 0, 0], [1, 0, 0, 0], [0, 0, 1, 0]]}
        moved = {"vertices": [[x, y - 2, z] for x, y, z in box((1, 0, 0), (2, 2, 2))["vertices"]]}
        self.assertEqual(checked({"pieces": [turned, moved], "pose": [[1, 0, 0, 0], [0, 1, 0, 2], [0, 0, 1, 0]]}, b), (0, ""))
        self.assertEqual(checked({"pieces": [turned, moved]}, b)[0], 1)
        for wrong in ({"pieces": []}, {"pieces": 2}, {"pieces": [7]}, {"pieces": [{}]}, {"pieces": [left], "vertices": []},
                      {"pieces": [{**left, "pose_rounding": "binary64"}]}, {"pieces": [left], "pose": 1}, {"pieces": None}):
            self.assertEqual(checked(wrong, b)[0], 2, wrong)
        self.assertEqual(checked({"pieces": [box((0, 0, 0), (2, 2, 2))]}, b, "../certificates/depth_cubes"),
                         (1, "the case has pieces in a, the certificate is about a convex body"))

    def test_results(self):
        text = {name: re.sub("id .*\n", "", (program.DATA / "format_3" / f"{name}.cert").read_text())
                for name in ("cube_in_two_pieces", "pieces_touching", "pieces_apart")}

        def code(name, **fields):
            return self.run_program(program.CHECK, "--results", "-", stdin=json.dumps({"id": "x", "certificate": text[name], **fields}))[0]

        for name, status, squared in (("cube_in_two_pieces", "penetrating", "1"), ("pieces_touching", "touching", "0"),
                                      ("pieces_apart", "disjoint", "0")):
            self.assertEqual(code(name, status=status, depth={"squared": squared}), 0)
            self.assertEqual(code(name), 0)
            for wrong in ({"depth": {"squared": "2"}}, {"depth": {"squared": "25"}}, {"depth": {"squared": None}}, {"status": "undecided"},
                          {"bound": {"squared": squared}}, {"signed_depth": {"low": 1, "high": 1}},
                          {"signed_depth": {"low": None, "high": None}}):
                self.assertEqual(code(name, **wrong), 1, (name, wrong))
            self.assertEqual(code(name, depth=squared), 2)
            right = 0 if name == "pieces_apart" else 1
            self.assertEqual(code(name, apart={"distance": {"squared": "25"}}), right)
            self.assertEqual(code(name, distance={"squared": "25"}), right)
            for wrong in ({"squared": "26"}, {"squared": None}):
                self.assertEqual(code(name, apart={"distance": wrong}), 1)
            self.assertEqual(code(name, apart=None), 0)
            self.assertEqual(code(name, apart=25), 2)
        self.assertEqual(code("pieces_touching", status="penetrating"), 1)


if __name__ == "__main__":
    unittest.main()
