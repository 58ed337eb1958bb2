# SPDX-License-Identifier: GPL-3.0-or-later
"""The claims of verify/claims: their verdicts are those of the page beside them. How a claim is judged: transcripts/claims.md."""
import collections
import json
import unittest

from harness import ROOT, CliTest

FOLDER = ROOT / "verify" / "claims"
FILES = {FOLDER / "claims.jsonl": {"right": 89, "wrong": 7, "not-judgeable": 4}, FOLDER / "reports.jsonl": {"right": 33, "wrong": 9}}


class Claims(CliTest):
    def test_what_was_published(self):
        """The page beside the claims is what the program says of them."""
        page = (FOLDER / "RESULTS.md").read_text()
        verdicts = {}
        for path, counts in FILES.items():
            code, out, err = self.run_cli("certify", "--claims", path, "--json")
            self.assertEqual((code, err), (1, ""))
            found = {}
            for line in out.splitlines():
                result = json.loads(line)
                found[result["id"]] = result["verdict"]
                for statement in result["statements"]:
                    if statement["finding"] == result["verdict"]:
                        self.assertTrue(statement["text"] in page and statement["truth"] in page, result["id"])
            self.assertEqual(list(found), [json.loads(line)["id"] for line in path.read_text().splitlines()])
            self.assertEqual(collections.Counter(found.values()), counts)
            verdicts.update(found)
        for identity, verdict in verdicts.items():
            self.assertRegex(page, rf"(?m)^\| {identity} \|.*\| {verdict} \|")
        self.assertEqual(len(verdicts), 142)
        # FCL and Coal assert different normals for the same two cones: one of them is wrong.
        self.assertEqual((verdicts["fcl-cone-cone-9.9"], verdicts["coal-cylinder-cone-9.9"]), ("wrong", "right"))

    def test_each_report_says_what_it_shows(self):
        for line in (FOLDER / "reports.jsonl").read_text().splitlines():
            claim = json.loads(line)
            self.assertRegex(claim["shows"], r"^[a-z].{9,98}[^.]$", claim["id"])
            self.assertRegex(claim["source"], r"#[0-9]+|@[0-9a-f]{7}|test", claim["id"])


if __name__ == "__main__":
    unittest.main()
