# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of the command line share: running it, small bodies, temporary files."""
import copy
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

from schemas import check_lines

EXECUTABLE = os.environ["FATHOM_EXECUTABLE"]
ROOT = pathlib.Path(os.environ["FATHOM_ROOT"])
DATA = ROOT / "tests" / "data"
VERSION = os.environ["FATHOM_VERSION"]
PATIENCE = 300  # seconds until a hung process is given up; no test depends on how long anything takes


def box(low, high):
    """The corners of an axis-parallel box, x fastest: corner i has bit 0 of i in x, bit 1 in y, bit 2 in z."""
    return [[(low, high)[i >> axis & 1][axis] for axis in range(3)] for i in range(8)]


UNIT = box([0, 0, 0], [1, 1, 1])


def case(a, b, **fields):
    """One line of a stream."""
    return json.dumps({"schema": "fathom/case/1", **fields, "a": {"vertices": a}, "b": {"vertices": b}}) + "\n"


def changed(value, path, new):
    """A copy of a JSON value with another one at the end of the path, of keys and indices."""
    result = copy.deepcopy(value)
    place = result
    for step in path[:-1]:
        place = place[step]
    place[path[-1]] = new
    return result


class CliTest(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def file(self, name, content):
        """A file in a folder of its own. Content: text, bytes, or a list of points."""
        path = self.folder / name
        if isinstance(content, list):
            content = "".join("{} {} {}\n".format(*point) for point in content)
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return str(path)

    def run_cli(self, *arguments, stdin="", **options):
        """(exit code, stdout, stderr); each line of JSON obeys the schema that it names."""
        done = subprocess.run([EXECUTABLE, *map(str, arguments)], input=stdin.encode(), timeout=PATIENCE,
                              stdout=options.pop("stdout", subprocess.PIPE), stderr=subprocess.PIPE, **options)
        out = (done.stdout or b"").decode()
        check_lines(out)
        return done.returncode, out, done.stderr.decode()

    def answer(self, *arguments, stdin=""):
        """stdout of a run that must succeed."""
        code, out, err = self.run_cli(*arguments, stdin=stdin)
        self.assertEqual(code, 0, err)
        return out

    def result(self, *arguments, stdin=""):
        """The only JSON object of a run that must succeed."""
        out = self.answer(*arguments, "--json", stdin=stdin)
        self.assertEqual(out.count("\n"), 1)
        return json.loads(out)

    def refused(self, *arguments, stdin="", code=2):
        """stderr of a run that must fail without a result and without an accident."""
        got, out, err = self.run_cli(*arguments, stdin=stdin)
        self.assertEqual((got, out), (code, ""), err)
        self.assertTrue(err.startswith("fathom: "), err)
        return err
