# SPDX-License-Identifier: GPL-3.0-or-later
"""One adapter, FATHOM_SUBJECT, on the real cases: it must answer what was measured on the packaged libraries by other programs, which the
cases keep in `measured`. Where the figures are another version's, the test is skipped; verify/subjects/README.md says what cannot agree."""
import json
import os
import unittest

from client import ROOT, Client

PROGRAM = os.environ["FATHOM_SUBJECT"]
VERSIONS = {"libccd": "2.1", "fcl": "0.7.0", "bullet": "3.24", "bullet64": "3.24", "ode": "0.16.2"}  # of the figures
# Program, its arguments, the name of its figures. The float figures are of bodies that were centred in binary64 before they were rounded.
FIGURES = {"ccdEPA": ("libccd", "epa"), "ccdMPR": ("libccd", "mpr"), "fclSD": ("fcl", "signed"), "fclCol": ("fcl", "collide"),
           "fclIND": ("fcl", "indep"), "bt32": ("bullet", "epa", "centre_in_binary64=1"), "bt64": ("bullet64", "epa"),
           "btPD64": ("bullet64", "pair", "margin=0"), "odeDef": ("ode", "collide")}
# What was not run then because its face lists were made with a tolerance: the exact ones are answered.
NOT_RUN = {"fclSD": "failed", "fclCol": "overlap", "fclIND": "overlap", "odeDef": "overlap"}


def cases():
    with open(ROOT / "tests" / "data" / "real_cases.jsonl", encoding="utf-8") as lines:
        return [json.loads(line) for line in lines]


def agrees(figure, reply, code):
    """Whether the reply is the figure, to the last bit."""
    if figure.startswith("not run (flat"):
        return "flat" in reply.get("unsupported", "")
    if figure.startswith("not run"):
        return NOT_RUN[code] in reply
    if figure.startswith("throw: "):
        return figure.split()[1] in reply.get("failed", "")
    if figure == "reports no penetration":
        return reply.get("overlap") is False
    if code in ("fclSD", "btPD64") and float(figure) > 0:  # a distance of bodies that are apart
        return reply.get("overlap") is False and reply["distance"] == float(figure)
    return reply.get("overlap") is True and reply["depth"] == float(figure)


class Measured(unittest.TestCase):
    def test_every_figure(self):
        ran = 0
        for code, (program, *arguments) in FIGURES.items():
            if program != PROGRAM:
                continue
            with Client(program, *arguments) as subject:
                if not subject.hello["version"].removeprefix("2:").startswith(VERSIONS[program]):
                    self.skipTest(f"the figures are of {VERSIONS[program]}, this is {subject.hello['version']}")
                for case in cases():
                    figure = case["measured"][code]
                    with self.subTest(code, case=case["id"], figure=figure):
                        reply = subject.ask(case["a"]["vertices"], case["b"]["vertices"])
                        self.assertTrue(agrees(figure, reply, code), reply)
                        ran += 1
        self.assertEqual(ran, 63 * sum(program == PROGRAM for program, *_ in FIGURES.values()))


if __name__ == "__main__":
    unittest.main()
