# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that Assimp reads: the same body as in OFF, to the bit; transforms exact; names; broken and hostile files. What
is told of a good one: docs/command_line.md."""
import json
import os
import struct
import unittest
from fractions import Fraction

import scene_makers as makers
from harness import CliTest


def binary32(value):
    return Fraction(struct.unpack("<f", struct.pack("<f", value))[0])


class Scenes(CliTest):
    def points(self, path):
        """The points of a mesh as they were read, exactly."""
        line = json.loads(self.answer("cases", "--from", path, self.file("o.xyz", [(0, 0, 0)])))
        return [tuple(Fraction(c) for c in point) for point in line["a"]["vertices"]]

    def test_each_format_is_the_body_in_off(self):
        b = self.file("b.off", makers.off([(x + 0.25, y + 0.125, z) for x, y, z in makers.POINTS]))
        points = [(0, 0, 0), (0.1, 0, 0), (0, 0.7, 0), (0, 0, 1e-3)]
        rounded = [tuple(float(binary32(c)) for c in p) for p in points]
        a = self.file("a.off", makers.off(rounded))
        wanted = self.result("depth", a, b)
        for ending, make in makers.MAKERS.items():
            with self.subTest(ending):
                path = self.file("a." + ending, make(points))
                found = self.result("depth", path, b)
                for field in ("status", "depth", "squared", "translation"):
                    self.assertEqual(found.get(field), wanted.get(field), field)
                self.assertEqual(set(self.points(path)), {tuple(map(binary32, p)) for p in points})
                solid = self.result("solid", path)["solid"]
                self.assertEqual(solid["volume"], self.result("solid", a)["solid"]["volume"])
                self.assertEqual(found["hull"] if "hull" in found else None, wanted.get("hull"))

    def test_transforms_are_applied_exactly(self):
        """A mirror and a translation by the binary32 next to 1/10; below it, in glTF, a scale by three of the node above."""
        moved = {tuple(map(Fraction, (x + binary32(0.1), -y, z))) for x, y, z in makers.POINTS}
        files = {
            "gltf": makers.gltf(nodes=[{"name": "n", "mesh": 0, "scale": [1, -1, 1], "translation": [0.1, 0, 0]}]),
            "dae": makers.dae(matrix="1 0 0 0.1 0 -1 0 0 0 0 1 0 0 0 0 1"),
            "3mf": makers.threemf(transform="1 0 0 0 -1 0 0 0 1 0.1 0 0")}
        for ending, content in files.items():
            with self.subTest(ending):
                path = self.file("m." + ending, content)
                self.assertEqual(set(self.points(path)), moved)
                code, out, err = self.run_cli("solid", path)
                self.assertEqual(code, 0, err)
                self.assertIn("is applied, exactly: det -1, a reflection: the body is mirrored", err)
                self.assertNotIn("inwards", out)  # its faces are turned with it
        nodes = [{"name": "above", "children": [1], "scale": [3, 3, 3]}, {"name": "n", "mesh": 0, "translation": [0.1, 0, 0]}]
        path = self.file("two.glb", makers.glb(nodes=nodes))
        wanted = {tuple(map(Fraction, (3 * (x + binary32(0.1)), 3 * y, 3 * z))) for x, y, z in makers.POINTS}
        self.assertEqual(set(self.points(path)), wanted)

    def test_units_and_up_axis(self):
        path = self.file("inch.dae", makers.dae(unit="0.0254", up="Z_UP"))
        inch = binary32(0.0254)
        self.assertEqual(set(self.points(path)), {(x * inch, z * inch, -y * inch) for x, y, z in makers.POINTS})
        _, _, err = self.run_cli("depth", path, path)
        self.assertIn("its unit of 0.0254 m is applied", err)
        self.assertIn("its up axis is Z: all is turned so that y points up", err)

    def test_several_meshes_are_pieces_or_solids_by_name(self):
        nodes = [{"name": "left", "mesh": 0}, {"name": "right", "mesh": 0, "translation": [4, 0, 0]},
                 {"name": "twin", "mesh": 0, "translation": [0, 4, 0]}, {"name": "twin", "mesh": 0}]
        path = self.file("all.glb", makers.glb(nodes=nodes))
        self.assertEqual(set(self.points(path + "#right")), {(x + 4, y, z) for x, y, z in makers.POINTS})
        self.assertEqual(len(self.points(path)), 16)
        self.assertEqual(self.result("depth", "--pieces", path + "#right", path)["deepest_pair"]["pieces"], [0, 1])
        self.assertIn("'body', found 4 among 'left', 'right', 'twin', 'twin'", self.refused("depth", path + "#body", path))
        self.assertIn("'twin', found 2 among", self.refused("depth", path + "#twin", path))
        self.assertIn("'lid', found none among", self.refused("depth", path + "#lid", path))
        apart = self.file("apart.glb", makers.glb(nodes=nodes[:2]))
        self.assertEqual(self.result("solid", apart)["solid"]["pieces"], 2)

    def test_buffers_lie_beside_the_file(self):
        parts, buffer = makers.gltf_parts(uri="a%20b.bin")
        path = self.file("a.gltf", json.dumps(parts))
        self.assertIn("buffers[0].uri: expected a file beside this one, found 'a%20b.bin'", self.refused("depth", path, path))
        self.file("a b.bin", buffer)
        self.assertEqual(set(self.points(path)), set(makers.POINTS))
        self.file("a b.bin", buffer[:-1])
        self.assertIn("buffers[0]: expected 72 bytes, found 71 bytes", self.refused("depth", path, path))
        (self.folder / "within").mkdir()
        os.mkfifo(self.folder / "secret.bin")  # who opens it waits for ever
        for uri in ("../secret.bin", "..%2fsecret.bin", str(self.folder / "secret.bin"), "file:secret.bin", "..", "http://a/b"):
            hostile = self.file("within/h.gltf", json.dumps(makers.gltf_parts(uri=uri)[0]))
            self.assertIn("buffers[0].uri: expected a file in the folder of this one, by its name alone",
                          self.refused("depth", hostile, hostile), uri)
        hostile = self.file("h.gltf", json.dumps(makers.gltf_parts(uri="secret.bin")[0]))
        self.assertIn("expected a file beside this one", self.refused("depth", hostile, hostile))
        other = self.file("h.dae", makers.dae(url="secret.dae#g"))
        self.assertIn("expected an element of this file, as url=\"#...\", found 'secret.dae#g'",
                      self.refused("depth", other, other))

    def test_broken_files(self):
        """(name, content, what is said), each with exit code 2."""
        nan, wrong = [(float("nan"), 0, 0)] + makers.POINTS[1:], [(0, 2, 9)] + makers.FACES[1:]
        parts, _ = makers.gltf_parts()
        cyclic = makers.gltf(nodes=[{"name": "n", "mesh": 0, "children": [1]}, {"name": "m", "children": [0]}],
                             scenes=[{"nodes": [0]}])
        draco = makers.gltf(extensionsRequired=["KHR_draco_mesh_compression"])
        short = json.loads(makers.gltf())
        short["accessors"][0]["componentType"] = 5122
        for name, content, says in (
                ("cut.gltf", makers.gltf()[:300], "expected"),
                ("cut.glb", makers.glb()[:-10], "bytes, as the header says"),
                ("cut.dae", makers.dae()[:900], "the end of the file"),
                ("cut.3mf", makers.threemf()[:-30], "expected a ZIP archive with its directory at the end"),
                ("i.gltf", makers.gltf(faces=wrong),
                 "meshes[0].primitives[0].indices: expected a vertex index below 4, found 9 as number 2"),
                ("i.glb", makers.glb(faces=wrong), "expected a vertex index below 4, found 9 as number 2"),
                ("i.dae", makers.dae(faces=wrong), "expected an index below 4 in the <p> of a geometry, found 9"),
                ("i.3mf", makers.threemf(faces=wrong), "face 0: expected a vertex index below 4, found 9"),
                ("n.gltf", makers.gltf(nan), "POSITION: expected finite numbers, found nan in vertex 0"),
                ("n.dae", makers.dae(nan), "expected finite numbers, found nan"),
                ("n.3mf", makers.threemf(nan), "vertex 0: expected finite numbers, found nan"),
                ("c.gltf", cyclic, "expected a node"), ("d.gltf", draco, "extensionsRequired: expected"),
                ("s.gltf", json.dumps(short), "accessors[0].componentType: expected 5126"),
                ("b.gltf", json.dumps(parts), "buffers[0].uri: expected where its bytes are, found none"),
                ("o.gltf", json.dumps({**parts, "asset": {"version": "1.0"}}), "asset.version: expected 2.0, found '1.0'"),
                ("t.dae", makers.dae().replace(b"</mesh>", b"</mash>"), "t.dae:9: expected '</mesh>', for line 4, found '</mash>'"),
                ("x.3mf", b"PK\5\6" + bytes(18), "cannot be read as 3MF")):
            with self.subTest(name):
                told = self.refused("depth", self.file(name, content), self.file("b.off", makers.off()))
                self.assertIn(says, told)
                self.assertIn(name + ":", told)

    def test_mutants_crash_nothing(self):
        b = self.file("b.off", makers.off())
        codes = set()
        for seed in range(int(os.environ.get("FATHOM_MUTANTS", "150"))):
            ending, content = makers.mutant(seed)
            code, _, err = self.run_cli("depth", self.file("m." + ending, content), b)
            codes.add(code)
            self.assertIn(code, (0, 2), f"mutant {seed}: {err}")
            if code == 2:
                self.assertTrue(err.startswith("fathom: "), f"mutant {seed}: {err}")
        self.assertEqual(codes, {0, 2})


if __name__ == "__main__":
    unittest.main()
