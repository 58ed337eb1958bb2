# SPDX-License-Identifier: GPL-3.0-or-later
"""No answer of a stream waits for the next case. What else there is about streams: transcripts/stream.md."""
import subprocess
import unittest

from harness import EXECUTABLE, PATIENCE, UNIT, CliTest, box, case

GOOD = case(UNIT, box([0.75, 0.25, 0.125], [1.75, 1.25, 1.125]), id="good")


class Pipes(CliTest):
    def test_each_answer_comes_before_the_next_case_is_sent(self):
        for options in ([], ["--json"]):
            with subprocess.Popen([EXECUTABLE, "depth", *options, "-"], stdin=subprocess.PIPE, stdout=subprocess.PIPE) as process:
                for _ in range(3):
                    process.stdin.write(GOOD.encode())
                    process.stdin.flush()
                    self.assertIn(b"0.25", process.stdout.readline())
                process.stdin.close()
                self.assertEqual((process.stdout.read(), process.wait(PATIENCE)), (b"", 0))


if __name__ == "__main__":
    unittest.main()
