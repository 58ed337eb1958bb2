#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Poses on the command line and in cases, and what is said about slips in them: poses that are no rotations, misspelt fields, units."""
import json
import unittest

from harness import UNIT, CliTest, case

SHAPES = ("sphere:r=1", "capsule:r=1,h=2")
QUARTER = [[0, -1, 0, 1], [1, 0, 0, 2], [0, 0, 1, 3]]
FORMS = ("0 -1 0 1; 1 0 0 2; 0 0 1 3", json.dumps(QUARTER), json.dumps(QUARTER + [[0, 0, 0, 1]]), "xyz=1,2,3 quat=1,0,0,1",
         "xyz=1,2,3 xyzw=0,0,1,1", "xyz=1,2,3 rpy=0,0,90deg")
IN_JSON = (QUARTER, QUARTER + [[0, 0, 0, 1]], {"quaternion": [1, 0, 0, 1], "translation": [1, 2, 3]},
           {"quat": [1, 0, 0, 1], "xyz": [1, 2, 3]}, {"xyzw": [0, 0, 1, 1], "xyz": [1, 2, 3]},
           {"rpy": [0, 0, 90], "unit": "deg", "xyz": [1, 2, 3]}, *FORMS)


class Poses(CliTest):
    def setUp(self):
        super().setUp()
        self.unit = self.file("unit.xyz", UNIT)
        self.placed = self.file("placed.xyz", [[1 - y, 2 + x, 3 + z] for x, y, z in UNIT])
        self.other = self.file("other.xyz", [[0.5 * x + 0.25, 2 + y, 3.5 - z] for x, y, z in UNIT])

    def same(self, one, other):
        """Equal but for the names of the inputs."""
        self.assertEqual({**one, "id": ""}, {**other, "id": ""})

    def test_every_form_places_a_mesh(self):
        direct = self.result("depth", self.placed, self.other)
        mirrored = self.result("depth", self.other, self.placed)
        (self.folder / "pose.txt").write_text("0 -1 0 1\n1 0 0 2\n0 0 1 3\n0 0 0 1\n")
        for form in (*FORMS, f"@{self.folder / 'pose.txt'}"):
            self.same(self.result("depth", self.unit, self.other, "--pose-a", form), direct)
            self.same(self.result("depth", self.other, self.unit, "--pose-b", form), mirrored)

    def test_every_command_has_poses(self):
        ball = self.file("ball.xyz", [[x - 0.5, y - 0.5, z - 0.5] for x, y, z in UNIT])
        for command in (["depth"], ["approx"], ["ray", "--direction", "1,2,3"], ["metric", "--ball", ball], ["study"]):
            self.same(self.result(*command, self.unit, self.other, "--pose-a", FORMS[0]), self.result(*command, self.placed, self.other))
        for option in ("--pose", "--pose-a"):
            self.same(self.result("width", self.other, option, "rpy=90,0,0deg"), self.result("width", self.file(
                "turned.xyz", [[0.5 * x + 0.25, z - 3.5, 2 + y] for x, y, z in UNIT])))

    def test_shapes_are_placed(self):
        moved = self.result("depth", "capsule:r=1,h=2,at=1:2:3,quaternion=1:1:0:0", "sphere:r=2")
        self.same(self.result("depth", "capsule:r=1,h=2", "sphere:r=2", "--pose-a", "xyz=1,2,3 rpy=90,0,0deg"), moved)
        code, out, err = self.run_cli("depth", *SHAPES, "--pose-b", "2 0 0 0; 0 2 0 0; 0 0 2 0")
        self.assertEqual((code, err), (0, "fathom: --pose-b: det 8, not a rotation: the body is scaled by 2; its radius or margin stays "
                                           "(of a tapered capsule the smaller radius: what the larger has more is mapped)\n"))
        self.assertIn("the matrix of a pose is singular", self.refused("depth", "cylinder:r=1,h=1", SHAPES[0], "--pose-a",
                                                                       "1 0 0 0; 1 0 0 0; 0 0 1 0"))

    def test_every_form_stands_in_a_case(self):
        b = {"vertices": [[0.5 * x + 0.25, 2 + y, 3.5 - z] for x, y, z in UNIT]}
        direct = self.result("depth", "-", stdin=json.dumps({"a": {"vertices": [[1 - y, 2 + x, 3 + z] for x, y, z in UNIT]}, "b": b}))
        for pose in IN_JSON:
            self.assertEqual(self.result("depth", "-", stdin=json.dumps({"a": {"vertices": UNIT, "pose": pose}, "b": b})), direct, pose)
        for pose, fault in (({"rpy": [0, 0, 90], "xyz": [1, 2, 3]}, 'a.pose.unit: expected "deg" or "rad", of rpy, found null'),
                            ({"quaternion": [1, 0, 0, 0], "xyzw": [0, 0, 0, 1]}, "a.pose: expected one rotation, found two"),
                            ({"xyz": [1, 2]}, "a.pose.xyz: expected three numbers"),
                            ("1 0 0", "a.pose: expected three rows of four numbers"),
                            (QUARTER + [[0, 0, 0, 2]], "a.pose: expected the last row 0 0 0 1"),
                            ({"pos": [1, 2, 3]}, "a.pose: expected three rows"),
                            (QUARTER + [[0, 0, 0, 1]] * 2, "a.pose: expected three rows")):
            code, out, err = self.run_cli("depth", "-", stdin=json.dumps({"a": {"vertices": UNIT, "pose": pose}, "b": b}))
            self.assertEqual((code, out), (2, ""), pose)
            self.assertIn(fault, err)

    def test_bad_poses_are_refused(self):
        for pose, fault in (("1 0 0; 0 1 0; 0 0 1", "found 3 rows of 3"), ("0 0 0 1 0 0 0", "both orders"),
                            ("nan 0 0 0; 0 1 0 0; 0 0 1 0", "row 1, number 1"), ("@missing", "missing: expected a readable file"),
                            ("rpy=0,0,1", "deg or rad"), ("quat=0,0,0,0", "not 0"),
                            (f"@{self.file('empty', '')}", "empty: expected three rows")):
            self.assertIn(fault, self.refused("depth", self.unit, self.other, f"--pose-a={pose}"))
        self.assertIn("--pose-b: expected bodies, found a stream of cases", self.refused("depth", "-", "--pose-b", FORMS[0]))
        self.assertIn("--pose-a: expected bodies, found a stream of cases", self.refused("width", "-", "--pose", FORMS[0]))


class Notes(CliTest):
    def notes(self, *cases):
        code, out, err = self.run_cli("depth", "-", stdin="".join(json.dumps(c) + "\n" for c in cases))
        self.assertEqual((code, out.count("\n")), (0, len(cases)), err)
        return err.splitlines()

    def test_misspelt_fields(self):
        a, b = {"vertices": UNIT}, {"vertices": UNIT}
        self.assertEqual(self.notes({"a": {**a, "poze": QUARTER}, "b": b}),
                         ["fathom: <stdin>:1: a: the field 'poze' is not read: is 'pose' meant?"])
        self.assertEqual(self.notes({"a": a, "b": b, "pose_roundin": "binary64"}, {"a": a, "b": {**b, "magrin": 1}}),
                         ["fathom: <stdin>:1: the field 'pose_roundin' is not read: is 'pose_rounding' meant?",
                          "fathom: later fields that look misspelt: 1"])
        ball = {"shape": "cylinder", "radius": 1, "half_length": 1}
        self.assertEqual(self.notes({"a": {**ball, "axes": "x"}, "b": b}),
                         ["fathom: <stdin>:1: a: the field 'axes' is not read: is 'axis' meant?"])
        pose = {"quaternion": [1, 0, 0, 0], "translatoin": [1, 2, 3]}
        self.assertEqual(self.notes({"a": a, "b": {**b, "pose": pose}}),
                         ["fathom: <stdin>:1: b.pose: the field 'translatoin' is not read: is 'translation' meant?"])
        for fine in ({"flags": [], "source": {"poze": 1}, "comment": "x"}, {"name": 1, "poses": 2}):
            self.assertEqual(self.notes({"a": a, "b": b, **fine}), [])
        self.assertEqual(self.notes({"a": {**a, "pose": QUARTER, "poses": 1}, "b": b}), [], "the pose is there")
        code, _, err = self.run_cli("depth", "-", stdin='{"a":{"vertice":[[0,0,0]]},"b":{"vertices":[[0,0,0]]}}')
        self.assertEqual(code, 2)
        self.assertIn("expected a field 'vertices', found none; a: the field 'vertice' is not read: is 'vertices' meant?", err)
        two = {"vertces": "x", "vertices": UNIT, "pose": {"xyz": [0, 0, 0]}}, {"poze": [1], "vertices": UNIT, "more": {}}
        self.assertEqual(self.notes({"a": two[0], "b": two[1]}), ["fathom: <stdin>:1: b: the field 'poze' is not read: is 'pose' meant?"],
                         "arrays are fields too: vertices are there, a pose is not")

    def test_poses_of_cases(self):
        def scaled(s):
            return {"a": {"vertices": UNIT, "pose": [[s, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]}, "b": {"vertices": UNIT}}
        self.assertEqual(self.notes(scaled(1), scaled(0.98), scaled(2), scaled(-1)),
                         ["fathom: <stdin>:2: a.pose: det 0.98, not a rotation: the body is scaled or sheared by it",
                          "fathom: later poses that are no rotations: 2"])

    def test_sizes(self):
        large = self.file("large.xyz", [[1000 * x, 1000 * y, 1000 * z] for x, y, z in UNIT])
        small = self.file("small.xyz", UNIT)
        code, out, err = self.run_cli("depth", large, small)
        self.assertEqual((code, err),
                         (0, "fathom: A is 1000 times as large as B (sizes: A 1000 x 1000 x 1000, B 1 x 1 x 1): are both in the same unit?\n"))
        self.assertRegex(out, r"\nsizes +A 1000 x 1000 x 1000, B 1 x 1 x 1\n")
        self.assertEqual(self.result("depth", large, small)["sizes"], {"a": [1000, 1000, 1000], "b": [1, 1, 1]})
        self.assertEqual(self.result("width", small)["sizes"], {"a": [1, 1, 1]})
        beyond = self.file("beyond.xyz", [["1e100000", 0, 0], [0, 0, 0]])
        self.assertIn("A is over 1.798e+308 times as large as B (sizes: A over 1.798e+308 x 0 x 0, B 1 x 1 x 1)",
                      self.run_cli("depth", "--exact-decimals", beyond, small)[2])
        hundred = {"a": {"vertices": [[0, 0, 0], [100, 0, 0]]}, "b": {"vertices": UNIT}}
        self.assertEqual(self.notes(hundred), [])
        more = {"a": {"vertices": [[0, 0, 0], [100.5, 0, 0]]}, "b": {"vertices": UNIT}}
        self.assertEqual(len(self.notes(more, hundred, more)), 2)
        shapes = self.result("depth", "cylinder:r=0.5,h=1,quaternion=1:1:0:0", "halfspace:normal=0:0:1,offset=0")["sizes"]
        self.assertEqual(shapes, {"a": [1, 2, 1], "b": None})
        self.assertEqual(self.result("depth", "capsule:r=0.5,h=1", "sphere:r=1/3")["sizes"], {"a": [1, 1, 3], "b": [2 / 3] * 3})


if __name__ == "__main__":
    unittest.main()
