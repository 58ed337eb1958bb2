# SPDX-License-Identifier: GPL-3.0-or-later
"""`fathom golden` on bodies of the plane: level F0 is the same bytes on any number of threads, is proved, computed again, exported, and
refused where it is forged."""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import unittest

from golden_release import RECORDS, GoldenTest, LevelTests, validator
from harness import ROOT

KIT = ROOT / "verify" / "golden" / "kit"
sys.path.insert(0, str(KIT))
import fathom_golden  # noqa: E402

# Each prints the separating distances of all directions of each case, and whether the answer is accepted, and a shorter depth.
READERS = {
    "c": """
#include "cases.c"
#include <stdio.h>
int main(void)
{
  const fathom_golden_tolerance none = {0, 0};
  int k;
  for (k = 0; k < fathom_golden_count; ++k) {
    const fathom_golden_case *golden = fathom_golden_cases + k;
    size_t i;
    for (i = 0; i < golden->direction_count; ++i) {
      const double *u = golden->directions + (size_t)golden->dimension * i;
      printf("%.17g %d%d\\n", fathom_golden_separating_distance(golden, u), fathom_golden_accept(golden, u, golden->signed_depth, none),
             fathom_golden_accept(golden, u, golden->signed_depth - 1e-3, none));
    }
  }
  return 0;
}
""",
    "rust": """
include!("cases.rust");
fn main() {
    let none = Tolerance { relative: 0.0, absolute: 0.0 };
    for golden in &CASES {
        for &u in golden.directions {
            let right = |depth| golden.accept(Some(u), depth, none) as i32;
            println!("{:?} {}{}", golden.separating_distance(u), right(golden.signed_depth), right(golden.signed_depth - 1e-3));
        }
    }
}
""",
    "json": """
import { readFileSync } from 'node:fs';
import { accept, read, separatingDistance } from './fathom_golden.mjs';
for (const golden of read('cases.json')) {
  for (const u of golden.directions) {
    const right = (depth) => Number(accept(golden, u, depth, { relative: 0 }));
    console.log(`${separatingDistance(golden, u)} ${right(golden.signed_depth)}${right(golden.signed_depth - 1e-3)}`);
  }
}
""",
}


class Plane(LevelTests, GoldenTest):
    LEVEL = "F0"

    def test_whole_and_proved(self):
        records = self.records_of_whole()
        self.assertGreater(records, 200)
        out = self.answer("golden", "verify", "--method", "exact", "--method", "naive", self.release)
        self.assertRegex(out, f"^s VERIFIED F0 version=[0-9.]+ seed=1 shards={len(self.shards)} records={records} agreed=exact,naive ")

    def test_schemas(self):
        record, good = self.validated()
        expected = {**good["expected"], "direction": ["1", "0", "0"]}
        for other in ({"dimension": 3}, {"a": {"vertices": [["0", "0", "0"]]}}, {"expected": expected}):
            self.assertFalse(record.is_valid({**good, **other}), other)

    def test_records_are_cases(self):
        """Answered again by a command that knows nothing of golden data."""
        lines = [json.loads(line) for line in self.all_lines()]
        stream = b"".join(self.all_lines()).decode()
        results = [json.loads(line) for line in self.answer("depth", "--json", "-", stdin=stream).splitlines()]
        self.assertEqual(len(lines), len(results))
        for line, result in zip(lines, results):
            expected = line["expected"]
            self.assertEqual((line["id"], expected["status"], 2), (result["id"], result["status"], result["dimension"]))
            self.assertEqual([expected["signed_depth"]["exact"][part] for part in ("root", "plus")],
                             [result["signed_depth"]["exact"][part] for part in ("root", "plus")], line["id"])
            if expected["status"] == "penetrating" and "optimal_cone" not in expected:
                self.assertEqual([t["normal"] for t in expected["translations"]], [o["direction"] for o in result["optima"]], line["id"])
                self.assertEqual([t["contact"] for t in expected["translations"]], [o["contact"] for o in result["optima"]], line["id"])

    def test_exported(self):
        """Polygons, in every format, with two coordinates: what the records say, read and judged alike in each language."""
        records = {line["id"]: line for line in map(json.loads, self.all_lines()) if not any("margin" in line[body] for body in "ab")}
        for name in ("c", "csv", "json", "rust"):
            (self.folder / f"cases.{name}").write_text(self.answer("golden", "export", "--format", name, self.release))
        validator(ROOT / "verify/golden/golden-export.schema.json").validate(json.loads((self.folder / "cases.json").read_text()))
        cases = fathom_golden.read(self.folder / "cases.json")
        self.assertEqual(cases, fathom_golden.read(self.folder / "cases.csv"))
        self.assertEqual([case.name for case in cases], list(records))
        for case in cases:
            expected = records[case.name]["expected"]
            self.assertEqual((case.dimension, case.status), (2, expected["status"]))
            self.assertEqual(case.signed_depth, float.fromhex(expected["signed_depth"]["f64"]["rn"]), case.name)
            self.assertEqual(str(case.squared), expected["signed_depth"]["exact"]["root"], case.name)
            for points, body in ((case.a, "a"), (case.b, "b")):
                self.assertEqual(points, [[float.fromhex(x) for x in point] for point in records[case.name][body]["vertices"]], case.name)
            self.assertEqual(case.directions[0], [float.fromhex(x) for x in expected["unit"]["f64"]["rn"]], case.name)
            overlap = expected["status"] == "penetrating"
            self.assertEqual(len(case.directions), len(expected["translations"]) if overlap else 1)
            self.assertEqual(set(case.contacts), {way["contact"]["kind"] for way in expected["translations"]} if overlap else set())
            with self.assertRaises(ValueError):
                fathom_golden.separating_distance(case, [0.0, 0.0, 1.0])
        expected = [(fathom_golden.separating_distance(case, u), case.largest) for case in cases for u in case.directions]
        for name, printed in self.printed().items():
            self.assertEqual(len(printed), len(expected), name)
            for line, (distance, largest) in zip(printed, expected):
                self.assertLessEqual(abs(float(line.split()[0]) - distance), 2.0 ** -46 * largest, name)
                self.assertEqual(line.split()[1], "10", name)

    def printed(self):
        """What the readers print, of the languages that are installed."""
        shutil.copy(KIT / "fathom_golden.mjs", self.folder)
        rustc = shutil.which("rustc") or shutil.which(os.path.expanduser("~/.cargo/bin/rustc"))
        programs = {"c": ["cc", "-std=c89", "-pedantic-errors", "-Wall", "-Wextra", "-Werror", "-o", "c", "reader.c", "-lm"],
                    "rust": [rustc, "--edition", "2021", "-D", "warnings", "-A", "dead_code", "-o", "rust", "reader.rust"]}
        runs = {"c": ["./c"], "rust": rustc and ["./rust"], "json": shutil.which("node") and ["node", "reader.mjs"]}
        found = {}
        for name, run in runs.items():
            if run:
                pathlib.Path(self.folder / ("reader.mjs" if name == "json" else f"reader.{name}")).write_text(READERS[name])
                if name in programs:
                    subprocess.run(programs[name], check=True, cwd=self.folder)
                found[name] = subprocess.run(run, check=True, cwd=self.folder, stdout=subprocess.PIPE, text=True).stdout.splitlines()
        return found

    def test_selected(self):
        self.refused("golden", "export", "--format", "c", "--contact", "facet-vertex", self.release)
        text = self.answer("golden", "export", "--format", "json", "--contact", "edge-edge", "--family", "plane_parallel*", self.release)
        self.assertEqual({case["family"] for case in json.loads(text)["cases"]}, {"plane_parallel_edges"})
        proofs = self.folder / "proofs.cert"
        chosen = self.answer("golden", "export", "--format", "json", "--count", "20", "--certificates", proofs, self.release)
        self.assertRegex(self.answer("check", "--case", self.file("chosen.json", chosen), proofs), "(s VERIFIED [^\n]* dimension=2[^\n]*\n){20}")

    def test_own_cases(self):
        own = {"id": "own", "dimension": 2, "a": {"vertices": [[0, 0], [2, 0], [2, 2], [0, 2]]},
               "b": {"vertices": [[1.5, 0.5], [4, 0.5], [4, 1]]}}
        proofs = self.folder / "own.cert"
        text = self.answer("golden", "export", "--format", "json", "--certificates", proofs, self.file("own.jsonl", json.dumps(own)))
        [found] = json.loads(text)["cases"]
        self.assertEqual((found["dimension"], found["signed_depth"], found["a"]), (2, 0.5, own["a"]["vertices"]))
        self.assertRegex(self.answer("check", "--case", self.file("own.json", text), proofs), "s VERIFIED [^\n]* dimension=2 own\n")
        both = json.dumps(own) + "\n" + json.dumps({"id": "space", "a": {"vertices": [[0, 0, 0]]}, "b": {"vertices": [[0, 0, 0]]}})
        self.assertIn("expected bodies that are all of the plane or all of space, found both",
                      self.refused("golden", "export", "--format", "c", self.file("both.jsonl", both)))

    def test_forged(self):
        number = next(i for i, line in enumerate(self.lines()) if json.loads(line)["expected"]["status"] == "penetrating")

        def nothing(record, proof):
            return proof

        def status(record, proof):
            record["expected"]["status"] = "touching"
            return proof

        def contact(record, proof):
            record["expected"]["translations"][0]["contact"]["a"] = [0]
            return proof

        def space(record, proof):
            record["dimension"] = 3
            return proof

        self.assertIn("s VERIFIED", self.answer("golden", "verify", self.forged(number, nothing)))
        for change, reason in ((status, "expected.status"), (contact, "expected.translations.0.contact"), (space, "dimension")):
            folder = self.forged(number, change)
            code, out, err = self.run_cli("golden", "verify", folder)
            self.assertEqual((code, err), (1, ""), (change.__name__, out))
            self.assertRegex(out, f"^s REFUSED {self.shards[0]}{RECORDS}:{number + 1}: .*{reason}", change.__name__)


if __name__ == "__main__":
    unittest.main()
