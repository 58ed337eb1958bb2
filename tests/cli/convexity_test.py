#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes that are not convex: what is said of them, and --require-convex."""
import json
import struct
import unittest

from harness import UNIT, CliTest

CUBE = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
# The cube of side 4 whose top is a pyramid down to (2, 2, 1).
DENTED = [[4 * x for x in point] for point in UNIT] + [[2, 2, 1]]
PYRAMID = [CUBE[0], *CUBE[2:], [4, 5, 8], [5, 7, 8], [7, 6, 8], [6, 4, 8]]
SENTENCE = "A is not convex: the hull holds 1.33 times its volume, its deepest point is 1 inside"


def off(points, faces):
    return "OFF\n{} {} 0\n".format(len(points), len(faces)) + "".join("{} {} {}\n".format(*p) for p in points) + "".join(
        " ".join(map(str, [len(f), *f])) + "\n" for f in faces)


def obj(points, faces):
    return "".join("v {} {} {}\n".format(*p) for p in points) + "".join("f " + " ".join(str(i + 1) for i in f) + "\n" for f in faces)


def backward_obj(points, faces):
    return "".join("v {} {} {}\n".format(*p) for p in points) + "".join(
        "f " + " ".join("{0}/1/1".format(i - len(points)) for i in f) + "\n" for f in faces)


def ply(points, faces):
    return ("ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\nelement face {}\n"
            "property list uchar int vertex_indices\nend_header\n").format(len(points), len(faces)) + off(points, faces).split("\n", 2)[2]


def triangles(points, faces):
    return [[points[i] for i in (f[0], f[k], f[k + 1])] for f in faces for k in range(1, len(f) - 1)]


def stl(points, faces):
    found = triangles(points, faces)
    return bytes(80) + struct.pack("<I", len(found)) + b"".join(struct.pack("<12fH", 0, 0, 0, *(x for p in t for x in p), 0) for t in found)


def text_stl(points, faces):
    return "solid\n" + "".join("facet normal 0 0 0\nouter loop\n" + "".join("vertex {} {} {}\n".format(*p) for p in t) +
                               "endloop\nendfacet\n"
                               for t in triangles(points, faces)) + "endsolid\n"


FORMATS = {"off": off, "obj": obj, "back.obj": backward_obj, "ply": ply, "stl": stl, "text.stl": text_stl}


class Convexity(CliTest):
    def test_every_format(self):
        other = self.file("other.off", off(UNIT, CUBE))
        for name, written in FORMATS.items():
            dented, convex = self.file("dented." + name, written(DENTED, PYRAMID)), self.file("convex." + name, written(UNIT, CUBE))
            result = self.result("depth", dented, other)
            self.assertEqual(result["hull"]["b"], {"convex": True})
            found = result["hull"]["a"]
            self.assertEqual((found["convex"], found["volume_ratio"]["exact"], found["deepest"]["depth"]["squared"]), (False, "4/3", "1"),
                             name)
            if "stl" not in name:
                self.assertEqual(found["deepest"]["point"], 8)
            self.assertIn("\nhull ", self.answer("depth", dented, other))
            self.assertIn(SENTENCE, self.answer("depth", dented, other))
            code, out, err = self.run_cli("depth", convex, other)
            self.assertEqual((code, err), (0, ""), name)
            self.assertNotIn("convex", out)

    def test_every_command_says_it(self):
        dented, cube = self.file("dented.off", off(DENTED, PYRAMID)), self.file("cube.off", off(UNIT, CUBE))
        ball = self.file("ball.xyz", [[x - 0.5, y - 0.5, z - 0.5] for x, y, z in UNIT])
        for command in (["ray", "--direction", "1,2,3"], ["metric", "--ball", ball], ["study"], ["depth", "--json"], ["approx", "--json"]):
            code, out, err = self.run_cli(*command, dented, cube)
            self.assertEqual(code, 0, err)
            self.assertIn(f"fathom: {SENTENCE}\n", err)
        for command in (["width", dented], ["width", "--delta", "1/2", dented], ["approx", dented, cube]):
            self.assertIn(SENTENCE, self.answer(*command))
        self.assertIn("B is not convex", self.answer("depth", "sphere:r=1", dented))

    def test_require_convex(self):
        dented, cube = self.file("dented.off", off(DENTED, PYRAMID)), self.file("cube.off", off(UNIT, CUBE))
        self.assertIn("expected convex meshes, as --require-convex says: " + SENTENCE, self.refused("depth", "--require-convex", dented,
                                                                                                    cube))
        self.assertIn("B is not convex", self.refused("approx", "--require-convex", cube, dented))
        self.assertIn("A is not convex", self.refused("width", "--require-convex", dented))
        self.assertIn("penetrating", self.answer("depth", "--require-convex", cube, cube))
        points = self.file("points.xyz", DENTED)
        self.assertIn("penetrating", self.answer("depth", "--require-convex", points, cube), "no faces, nothing to compare")

    def test_streams(self):
        def case(faces):
            return json.dumps({"a": {"vertices": DENTED, "faces": faces}, "b": {"vertices": UNIT}}) + "\n"
        code, out, err = self.run_cli("depth", "--json", "-", stdin=case(PYRAMID) + case(CUBE) + case(PYRAMID))
        self.assertEqual(code, 0)
        results = [json.loads(line) for line in out.splitlines()]
        self.assertEqual([result["hull"]["a"]["convex"] for result in results], [False, True, False])
        self.assertIn(f"fathom: <stdin>:1: {SENTENCE}\n", err)
        self.assertIn("fathom: later meshes that are not convex: 1\n", err)
        code, out, err = self.run_cli("depth", "--require-convex", "-", stdin=case(PYRAMID) + case(CUBE))
        self.assertEqual((code, out.count("\n")), (2, 1))
        self.assertIn("<stdin>:1: expected convex meshes", err)
        for faces, fault in (([[0, 1, 9]], "a.faces[0]: expected vertex indices below 9, found 9"), ([[0, 1, -1]], "found -1"),
                             ([3], "a.faces[0]: expected an array"), ({}, "a.faces: expected an array of faces"),
                             (7, "a.faces: expected an array of faces"), ([["0", 1, 2]], "found \"0\"")):
            code, out, err = self.run_cli("depth", "-", stdin=case(faces))
            self.assertEqual((code, out), (2, ""))
            self.assertIn(fault, err)
        self.assertNotIn("hull", self.result("depth", "-", stdin=case(None)))

    def test_faces_of_every_kind_of_hull(self):
        """Whichever way the pose is written; those of a hull with a margin are not read."""
        def found(**body):
            return self.result("depth", "-", stdin=json.dumps({"a": body, "b": {"vertices": UNIT}})).get("hull", {}).get("a")
        mesh, turn = {"vertices": DENTED, "faces": PYRAMID}, {"quaternion": [1, 2, 3, 4]}
        for body in (mesh, {**mesh, "pose": "rpy=1,2,3deg"}, {**mesh, "pose": turn}, {**mesh, "shape": "hull"}, {**mesh, "margin": 0},
                     {**mesh, "pose": [[1, 0, 0, 5], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]},
                     {**mesh, "pose": turn, "pose_rounding": "binary64"}):
            self.assertFalse(found(**body)["convex"], body)
        self.assertIsNone(found(**mesh, margin=1))

    def test_poses_keep_faces(self):
        dented, cube = self.file("dented.off", off(DENTED, PYRAMID)), self.file("cube.off", off(UNIT, CUBE))
        self.assertIn(SENTENCE, self.answer("depth", dented, cube, "--pose-a", "xyz=1,2,3 rpy=10,20,30deg"))
        self.assertEqual(self.result("depth", dented, cube, "--pose-b", "-1 0 0 0; 0 1 0 0; 0 0 1 0")["hull"]["b"], {"convex": True})

    def test_without_volume(self):
        hole = self.file("hole.off", off(DENTED, PYRAMID[1:]))
        self.assertIn("A is not convex: its faces are not closed, its deepest point is 1 inside", self.answer("depth", hole, hole))
        tetrahedra = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]]
        diagonal = self.file("diagonal.off", off(tetrahedra, [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 4], [2, 3, 4], [3, 1, 4], [1, 2, 3]]))
        self.assertIn("all its points are on the hull", self.answer("depth", diagonal, diagonal))


if __name__ == "__main__":
    unittest.main()
