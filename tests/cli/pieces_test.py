# SPDX-License-Identifier: GPL-3.0-or-later
"""fathom depth --pieces: what an interrupt leaves. All else: transcripts/pieces.md."""
import json
import re
import unittest

from harness import CliTest
from terminals import run_on_terminal


class Pieces(CliTest):
    def test_an_interrupt_prints_the_bounds_that_are_proved(self):
        """Of a union in a stream, and of one case of it."""
        def grid(at):
            return {"pieces": [{"vertices": [[i + x + at, j + y + at, k + z + at] for x in (0, 1) for y in (0, 1) for z in (0, 1)]}
                               for i in range(10) for j in range(10) for k in range(10)]}
        path = self.file("cases.jsonl", json.dumps({"id": "grids", "a": grid(0), "b": grid(0.5)}) + "\n")
        number = rb"([0-9.]+)"
        for words, pattern in (([path], rb"grids: interrupted; depth at least %s; at most %s\n" % (number, number)),
                               (["--case", "grids", path], rb"interrupted\nat least +%s\nat most +%s\n" % (number, number))):
            code, out, _ = run_on_terminal("depth", *words, stop_at=b"depth between", columns=160)
            self.assertEqual(code, 130)
            self.assertRegex(out, b"^" + pattern)
            low, high = map(float, re.match(pattern, out).groups())
            self.assertTrue(0 < low <= high, out)


if __name__ == "__main__":
    unittest.main()
