# SPDX-License-Identifier: GPL-3.0-or-later
"""Bad files: exit code 2, one sentence with file, line where there is one, and what was expected. Never a crash, never silence."""
import math
import os
import subprocess
import unittest

from harness import DATA, EXECUTABLE, UNIT, CliTest, box

CUBE = str(DATA / "cube.off")
HEAD, TAIL = "OFF\n4 0 0\n0 0 0\n", "0 1 0\n0 0 1\n"

# name -> (content, what follows the name in the message)
BAD = {
    "nan.off": (HEAD + "1 0 nan\n" + TAIL, ":4: expected a number, found 'nan'"),
    "infinity.off": (HEAD + "1 0 -Infinity\n" + TAIL, ":4: expected a number, found '-Infinity'"),
    "inf.xyz": ("0 0 0\n0 inf 0\n", ":2: expected a number, found 'inf'"),
    "empty.off": ("", ": expected a mesh, found an empty file"),
    "empty.xyz": ("", ": expected a mesh, found an empty file"),
    "zero.off": ("OFF\n0 0 0\n", ":2: expected at least one vertex, found '0'"),
    "truncated.off": (HEAD + "1 0 0\n", ":4: expected vertex 3 of 4, found the end of the file"),
    "index.off": ("OFF\n4 1 0\n0 0 0\n1 0 0\n" + TAIL + "3 0 1 4\n", ":7: expected a vertex index below 4, found '4'"),
    "text.off": (HEAD + "1 zero 0\n" + TAIL, ":4: expected a number, found 'zero'"),
    "huge.off": (HEAD + "1e400 0 0\n" + TAIL, ":4: expected a number, found '1e400': beyond binary64"),
    "vast.off": (HEAD + "1e99999999999 0 0\n" + TAIL, ":4: expected a number, found '1e99999999999': beyond binary64"),
    "noise.off": (bytes(range(128, 256)), ":1: expected the header 'OFF'"),
    "noise": (bytes(range(128, 256)), ":1: expected a mesh"),
    "zero.xyz": ("# nothing\n", ":1: expected at least one point x y z, found the end of the file"),
}


class BadMeshes(CliTest):
    def check(self, *arguments, says):
        err = self.refused(*arguments)
        self.assertEqual(err.count("\n"), 1, err)
        self.assertIn(says, err)

    def test_every_kind_in_every_place(self):
        for name, (content, says) in BAD.items():
            path = self.file(name, content)
            for arguments in (["depth", path, CUBE], ["depth", CUBE, path], ["depth", "--json", path, CUBE], ["width", path]):
                with self.subTest(name=name, arguments=arguments[:2]):
                    self.check(*arguments, says=path + says)

    def test_missing_and_directory(self):
        missing = str(self.folder / "missing")
        for path, found in ((missing, "none of this name"), (str(self.folder), "a directory"), ("", "none of this name")):
            for arguments in (["depth", path, CUBE], ["depth", CUBE, path], ["width", path], ["depth", path]):
                with self.subTest(path=path, arguments=arguments[:1]):
                    self.check(*arguments, says=": expected a readable file, found " + found)

    def test_input_output_error(self):
        self.check("depth", "/proc/self/mem", CUBE, says="/proc/self/mem: expected a readable file, found 'Input/output error'")

    def test_without_permission(self):
        """Root is tried without the capabilities that make permissions void."""
        powerless = [] if os.geteuid() else ["setpriv", "--bounding-set=-dac_override,-dac_read_search"]
        if powerless and subprocess.run([*powerless, "true"], capture_output=True).returncode:
            self.skipTest("root cannot drop capabilities here")
        mesh, stream = self.file("secret.off", "OFF\n"), self.file("secret.jsonl", "")
        os.chmod(mesh, 0)
        os.chmod(stream, 0)
        for arguments in (["depth", mesh, CUBE], ["width", mesh], ["depth", stream]):
            done = subprocess.run([*powerless, EXECUTABLE, *arguments], capture_output=True)
            self.assertEqual((done.returncode, done.stdout), (2, b""), done.stderr)
            self.assertIn(b": expected a readable file, found 'Permission denied'", done.stderr)

    def test_exact_decimals_have_a_limit_too(self):
        path = self.file("huge.off", HEAD + "1e100001 0 0\n" + TAIL)
        self.check("width", "--exact-decimals", path, says=path + ":4: expected a number, found '1e100001'")


class Harmless(CliTest):
    """What looks bad but has an answer."""

    def test_duplicates_and_inner_points(self):
        path = self.file("many.xyz", [[0, 0, 0], [4, 0, 0], [0, 0, 0], [0, 4, 0], [0, 0, 4], [1, 1, 1], [2, 0, 0]])
        code, out, err = self.run_cli("width", "--exact", path)
        self.assertEqual(code, 0)
        self.assertIn("width^2    16/3\n", out)
        self.assertEqual(err, "fathom: A: 2 of 7 points are not extreme; the convex hull is taken\n")

    def test_non_convex_mesh(self):
        points = [[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4], ["1/2", "1/2", "1/2"]]
        path = self.file("dent.off", "OFF\n5 2 0\n" + "".join("{} {} {}\n".format(*p) for p in points) + "3 0 1 2\n3 1 2 4\n")
        code, _, err = self.run_cli("depth", path, path)
        self.assertEqual(code, 0)
        self.assertEqual(err, "fathom: A: 1 of 5 points are not extreme; B: 1 of 5 points are not extreme; the convex hull is taken\n")

    def test_non_convex_mesh_of_any_size(self):
        """A torus, with every method and status; the repeated corners of an STL are no dents."""
        def ring(i, j, n=160):
            u, v = 2 * math.pi * i / n, 2 * math.pi * j / n
            return [(3 + math.cos(v)) * math.cos(u), (3 + math.cos(v)) * math.sin(u), math.sin(v)]

        torus = self.file("torus.xyz", [ring(i, j) for i in range(160) for j in range(160)])
        said = r"^fathom: A: \d+ of 25600 points are not extreme; the convex hull is taken\n$"
        inside, apart, touching = UNIT, box([9, 0, 0], [10, 1, 1]), box([4, -1, -1], [5, 1, 1])
        for command, other in ((["depth"], inside), (["depth"], apart), (["depth"], touching), (["depth", "--method=exact"], inside),
                               (["approx"], inside), (["ray", "--direction=1,0,0"], apart)):
            code, _, err = self.run_cli(*command, torus, self.file("other.xyz", other))
            self.assertEqual(code, 0, err)
            self.assertRegex(err, said, command)
        triangles = [(0, 1, 3), (0, 3, 2), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4), (2, 3, 7), (2, 7, 6), (0, 2, 6), (0, 6, 4),
                     (1, 3, 7), (1, 7, 5)]
        facets = "".join("facet normal 0 0 0\nouter loop\n" + "".join("vertex {} {} {}\n".format(*UNIT[i]) for i in t) +
                         "endloop\nendfacet\n"
                         for t in triangles)
        self.assertEqual(self.run_cli("width", self.file("cube.stl", f"solid cube\n{facets}endsolid cube\n"))[2], "")


if __name__ == "__main__":
    unittest.main()
