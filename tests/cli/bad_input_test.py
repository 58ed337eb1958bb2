# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that may not be read, and large meshes that are not convex. Other bad files: transcripts/bad_input.md."""
import math
import os
import subprocess
import unittest

from harness import DATA, EXECUTABLE, UNIT, CliTest, box

CUBE = str(DATA / "cube.off")


class BadMeshes(CliTest):
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


class Harmless(CliTest):
    """What looks bad but has an answer."""

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
