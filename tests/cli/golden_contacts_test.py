# SPDX-License-Identifier: GPL-3.0-or-later
"""`fathom golden` on contacts: level C0, of polytopes and of shapes, is the same bytes on any number of threads, is proved, computed again,
and refused where it is forged."""
import json
import pathlib
import re
import subprocess
import sys
import unittest
from fractions import Fraction

from golden_release import RECORDS, GoldenTest, LevelTests, validator
from harness import ROOT

sys.path.insert(0, str(ROOT / "verify" / "golden" / "kit"))
import fathom_golden  # noqa: E402

FORMATS = ("c", "csv", "json", "rust")
READER = """
#include "cases.c"
#include <stdio.h>
int main(void)
{
  int k;
  for (k = 0; k < fathom_golden_count; ++k) {
    const fathom_golden_case *golden = fathom_golden_cases + k;
    size_t i, all = 0;
    for (i = 0; i < golden->direction_count; ++i) all += 3 * golden->corner_counts[i];
    for (i = 0; i < all; ++i) printf("%.17g ", golden->corners[i]);
    for (i = 0; golden->gradient && i < 6; ++i) printf("%.17g ", golden->gradient[i]);
    printf("\\n");
  }
  return 0;
}
"""


class Contacts(LevelTests, GoldenTest):
    LEVEL = "C0"

    def test_whole_and_proved(self):
        records = self.records_of_whole()
        self.assertGreater(records, 400)
        out = self.answer("golden", "verify", "--method", "exact", "--method", "naive", self.release)
        self.assertRegex(out, f"^s VERIFIED C0 version=[0-9.]+ seed=1 shards={len(self.shards)} records={records} agreed=exact,naive ")

    def test_schemas(self):
        self.validated()

    def test_what_it_holds(self):
        """Points, segments and polygons, of bodies that penetrate, touch and are apart; gradients, and every reason why there is none."""
        ranks, kinds, kinks = set(), set(), set()
        record, lines = self.validator("golden"), self.all_lines()
        for line in map(json.loads, lines):
            record.validate(line)
            self.assertTrue(line["id"].startswith("contacts-"))
            expected, manifold = line["expected"], line["expected"]["manifold"]
            kinds.add((line["golden"], expected["status"]))
            kinks |= set(manifold["kinks"])
            for patch in manifold["patches"]:
                ranks.add((expected["status"], patch["rank"]))
            self.assertEqual(manifold["gradient"] is None, bool(manifold["kinks"]))
            self.assertEqual(len(expected["derivatives"]), 3)
        self.assertEqual(len(ranks), 9)
        self.assertEqual(len(kinds), 6)
        self.assertEqual(kinks, {"ties", "extended", "cone"})
        self.assertFalse(record.is_valid({**json.loads(lines[0]), "golden": "fathom/golden/2"}))

    def test_as_the_command_says(self):
        """Answered again by a command that knows nothing of golden data."""
        stream = b"".join(self.all_lines()).decode()
        motions = json.loads(self.lines()[0])["expected"]["derivatives"]
        for number, motion in enumerate(motions):
            twist = ",".join(motion["v"] + motion["w"])
            lines = self.answer("depth", "--json", "--patch", f"--twist={twist}", "-", stdin=stream).splitlines()
            results = [json.loads(line) for line in lines]
            self.assertEqual(len(results), len(self.all_lines()))
            for line, result in zip(map(json.loads, self.all_lines()), results):
                expected = line["expected"]
                self.assertEqual((line["id"], expected["manifold"]), (result["id"], result["manifold"]))
                self.assertEqual(expected["derivatives"][number]["derivative"], result["derivative"])

    def test_exported(self):
        """Polytopes, in every format: all corners and gradients as the doubles nearest to those of the records."""
        of_polytopes = {line["id"]: line for line in map(json.loads, self.all_lines()) if line["golden"] == "fathom/golden/1"}
        paths = {name: self.file(f"cases.{name}", self.answer("golden", "export", "--format", name, self.release)) for name in FORMATS}
        cases = fathom_golden.read(paths["json"])
        schema = validator(ROOT / "verify/golden/golden-export.schema.json")
        schema.validate(json.loads(pathlib.Path(paths["json"]).read_text()))
        self.assertEqual(cases, fathom_golden.read(paths["csv"]))
        self.assertGreater(len(cases), 250)
        for case in cases:
            manifold = of_polytopes[case.name]["expected"]["manifold"]
            corners = [[[float(Fraction(x)) for x in corner["a"]] for corner in patch["corners"]] for patch in manifold["patches"]]
            self.assertEqual((case.patches, len(case.patches)), (corners, len(case.directions)), case.name)
            self.assertEqual(case.gradient, manifold["gradient_f64"] and [manifold["gradient_f64"][part] for part in "vw"])
        program = self.folder / "reader"
        reader = self.file("reader.c", READER)
        subprocess.run(["cc", "-std=c89", "-pedantic-errors", "-Wall", "-Wextra", "-Werror", "-o", program, reader, "-lm"],
                       check=True)
        printed = subprocess.run([program], check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines()
        expected = [sum((sum(patch, []) for patch in case.patches), []) + sum(case.gradient or [], []) for case in cases]
        self.assertEqual([[float(word) for word in line.split()] for line in printed], expected)
        rust = pathlib.Path(paths["rust"]).read_text()
        self.assertEqual(rust.count("gradient: Some(["), sum(case.gradient is not None for case in cases))

    def test_forged(self):
        number = [json.loads(line)["id"] for line in self.lines()].index("contacts-catalogue-contact_facet_facet")

        def nothing(record, proof):
            return proof

        def gradient(record, proof):
            record["expected"]["manifold"]["smooth"] = not record["expected"]["manifold"]["smooth"]
            return proof

        def without(record, proof):
            del record["expected"]["manifold"], record["expected"]["derivatives"]
            return proof

        def rates(record, proof):
            start, end = proof.index("\nrates "), proof.index("\nend ")
            return proof[:start] + re.sub(r" \S+\n$", "\n", proof[end:])

        self.assertIn("s VERIFIED", self.answer("golden", "verify", self.forged(number, nothing)))
        for change, reason in ((gradient, "expected.manifold.smooth"), (without, "id: it is not that of its source"),
                               (rates, "expected.derivatives: the certificate does not prove them")):
            code, out, err = self.run_cli("golden", "verify", self.forged(number, change))
            self.assertEqual((code, err), (1, ""), (change.__name__, out))
            self.assertRegex(out, f"^s REFUSED {self.shards[0]}{RECORDS}:{number + 1}: .*{reason}", change.__name__)


if __name__ == "__main__":
    unittest.main()
