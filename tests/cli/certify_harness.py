# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of `fathom certify` share: the liar, cases of boxes, verdict lines."""
import json
import sys

from harness import ROOT, CliTest, box, case

LIAR = ROOT / "tests" / "harness" / "liar.py"


def liar(way, seconds=0):
    """The shell command of a subject that misbehaves on marked cases; see liar.py."""
    return f"exec '{sys.executable}' -B '{LIAR}' {way} {seconds}"


def boxes(number, marked=False):
    """A case of two boxes with a depth of its own: 1/2 - number/1000."""
    x = 1000 if marked else 0
    return case(box([x + 1, 0, 0], [x, 1, 1]), box([x + 0.5 + number / 1000, 0, 0], [x + 2, 1, 1]), id=f"box::{number}")


class CertifyTest(CliTest):
    def certify(self, *arguments, stdin=""):
        """(exit code, the lines of --json, stderr)"""
        code, out, err = self.run_cli("certify", "--json", *arguments, stdin=stdin)
        return code, [json.loads(line) for line in out.splitlines()], err

    @staticmethod
    def verdicts(lines):
        return {line["id"] + ("~" + line["variant"] if "variant" in line else ""): line["verdict"] for line in lines
                if line["type"] == "case"}
