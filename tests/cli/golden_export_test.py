# SPDX-License-Identifier: GPL-3.0-or-later
"""`fathom golden export`: the exports say what the records say, in every format, and the kit's `accept` measures directions as it
promises."""
import decimal
import json
import random
import shutil
import subprocess
import sys
import tempfile
import unittest
from collections import Counter
from fractions import Fraction

import jsonschema  # Debian: python3-jsonschema
from golden_release import COMMITTED, packed, repair, unpacked
from harness import EXECUTABLE, ROOT, UNIT, CliTest

KIT = ROOT / "verify" / "golden" / "kit"
sys.path.insert(0, str(KIT))
import fathom_golden  # noqa: E402

SAMPLE = ["--exclude", "flat,huge,tiny", "--max-points", "8", "--count", "50"]
ENDS = {"c": "h", "csv": "csv", "json": "json", "rust": "rs"}
FIRST = "golden-L0-0000.jsonl.zst"

# Prints each case of an export as C sees it, the separating distance of each direction, whether it is accepted, and what stands against it.
READER = r"""
#include "cases.h"
#include <stdio.h>

static void print_points(const double *p, size_t count)
{
  size_t i;
  for (i = 0; i < 3 * count; ++i) printf(" %.17g", p[i]);
  printf("\n");
}

int main(void)
{
  int i;
  const fathom_golden_tolerance none = {0, 0}, half = {0.5, 0};
  for (i = 0; i < fathom_golden_count; ++i) {
    const fathom_golden_case *golden = &fathom_golden_cases[i];
    size_t j;
    printf("%s\n%d\n%.17g\n%s\n%s\n%.17g %.17g\n", golden->name, (int)golden->status, golden->signed_depth,
           golden->squared ? golden->squared : "too long", golden->flags, golden->size, golden->largest);
    print_points(golden->a, golden->a_count);
    print_points(golden->b, golden->b_count);
    print_points(golden->directions, golden->direction_count);
    for (j = 0; j < golden->direction_count; ++j) {
      const double *u = golden->directions + 3 * j;
      const double far = golden->signed_depth + golden->largest / 1e9;
      printf("%.17g %d%d%d%d%d\n", fathom_golden_separating_distance(golden, u),
             fathom_golden_accept(golden, u, golden->signed_depth, none),
             fathom_golden_accept(golden, u, far, none), fathom_golden_accept(golden, NULL, 1.25 * golden->signed_depth, half),
             fathom_golden_accept_apart(golden, none), fathom_golden_accept_apart(golden, half));
    }
  }
  return 0;
}
"""


def records():
    """The records of the committed release, by id."""
    lines = b"".join(unpacked(path) for path in sorted(COMMITTED.glob("*.jsonl.zst"))).splitlines()
    return {record["id"]: record for record in map(json.loads, lines)}


def numbers(points):
    return [[float.fromhex(coordinate) for coordinate in point] for point in points]


def group(record):
    return record["source"]["name"] if record["source"]["kind"] == "family" else record["source"]["kind"]


class Export(CliTest):
    @classmethod
    def setUpClass(cls):
        cls.records = records()
        done = subprocess.run([EXECUTABLE, "golden", "export", "--format", "json", COMMITTED], check=True, capture_output=True)
        with tempfile.NamedTemporaryFile(suffix=".json") as file:
            file.write(done.stdout)
            file.flush()
            cls.everything = fathom_golden.read(file.name)

    def export(self, *options, format="json", folder=COMMITTED):
        """The path of an export."""
        path = self.folder / f"cases.{ENDS[format]}"
        path.write_text(self.answer("golden", "export", "--format", format, *options, folder))
        return path

    def names(self, *options):
        return [case.name for case in fathom_golden.read(self.export(*options))]

    def test_the_sample_is_what_is_exported(self):
        subprocess.run([KIT / "make.sh", self.folder / "made", EXECUTABLE], check=True)
        made = sorted((self.folder / "made").iterdir())
        self.assertEqual([path.name for path in made], sorted(f"fathom_golden_sample.{end}" for end in ENDS.values()))
        for format, end in ENDS.items():
            sample = self.folder / "made" / f"fathom_golden_sample.{end}"
            self.assertEqual(self.export(*SAMPLE, format=format).read_text(), sample.read_text(), sample)
        self.assertLess(sum(path.stat().st_size for path in made), 1 << 20)

    def test_every_number_is_that_of_the_record(self):
        cases = self.everything
        fitting = [name for name, record in self.records.items() if "binary64" in record["formats"]]
        self.assertEqual([case.name for case in cases], fitting)
        for case in cases:
            record = self.records[case.name]
            expected = record["expected"]
            apart = expected["status"] == "disjoint"
            length = expected["distance" if apart else "depth"]
            self.assertEqual((case.status, case.flags), (expected["status"], record["flags"]))
            self.assertEqual(case.signed_depth, (-1 if apart else 1) * float.fromhex(length["f64"]["rn"]), case.name)
            self.assertEqual(case.squared, Fraction(length["squared"]), case.name)
            self.assertEqual([case.a, case.b], [numbers(record[body]["vertices"]) for body in "ab"], case.name)
            optima = expected["optima"] or [expected]
            self.assertEqual(case.directions, numbers(optimum["unit"]["f64"]["rn"] for optimum in optima), case.name)
            extents = [max(p[i] for p in body) - min(p[i] for p in body) for body in (case.a, case.b) for i in range(3)]
            self.assertEqual(case.size, max(extents), case.name)
            self.assertEqual(case.largest, max(abs(x) for p in case.a + case.b for x in p), case.name)

    def test_json_obeys_its_schema_and_says_the_same_as_csv(self):
        schema = json.loads((ROOT / "verify/golden/golden-export.schema.json").read_text())
        jsonschema.Draft202012Validator.check_schema(schema)
        path = self.export("--exclude", "ties,disjoint")
        jsonschema.Draft202012Validator(schema).validate(json.loads(path.read_text()))
        own = self.answer("golden", "export", "--format", "json", self.file("own.jsonl", json.dumps({"id": "own", "a": {"vertices": UNIT}, "b": {"vertices": UNIT}})))
        jsonschema.Draft202012Validator(schema).validate(json.loads(own))
        source = json.loads(path.read_text())["source"]
        self.assertEqual(source, {"level": "L0", "seed": "1", "version": "1.3.0",
                                  "command": "fathom golden export --format json --exclude ties,disjoint"})
        self.assertEqual(fathom_golden.read(path), fathom_golden.read(self.export("--exclude", "ties,disjoint", format="csv")))

    def test_c_says_the_same(self):
        """In C89 and in C++, without a warning: all of L0."""
        self.export(format="c")
        cases = self.everything
        (self.folder / "reader.c").write_text(READER)
        printed = []
        for compiler in (["cc", "-std=c89"], ["c++", "-std=c++11", "-xc++"]):
            program = self.folder / "reader"
            subprocess.run([*compiler, "-pedantic-errors", "-Wall", "-Wextra", "-Werror", "-o", program, self.folder / "reader.c", "-lm"],
                           check=True)
            printed.append(subprocess.run([program], check=True, stdout=subprocess.PIPE, text=True).stdout)
        self.assertEqual(printed[0], printed[1])
        lines = iter(printed[0].splitlines())
        for case in cases:
            self.assertEqual(next(lines), case.name)
            self.assertEqual(int(next(lines)), ["penetrating", "touching", "disjoint"].index(case.status))
            self.assertEqual(float(next(lines)), case.signed_depth)
            squared, exact = next(lines), str(case.squared)
            self.assertEqual(squared, exact if len(exact) <= 509 else "too long")
            self.assertEqual(next(lines).split(), case.flags)
            self.assertEqual([float(word) for word in next(lines).split()], [case.size, case.largest])
            for points in (case.a, case.b, case.directions):
                self.assertEqual([float(word) for word in next(lines).split()], sum(points, []), case.name)
            for direction in case.directions:
                printed, accepted = next(lines).split()
                expected = fathom_golden.separating_distance(case, direction)
                self.assertLessEqual(abs(float(printed) - expected), 2.0 ** -46 * case.largest, case.name)
                far = case.signed_depth + case.largest / 1e9
                expected = [fathom_golden.accept(case, direction, case.signed_depth, relative=0),
                            fathom_golden.accept(case, direction, far, relative=0),
                            fathom_golden.accept(case, None, 1.25 * case.signed_depth, relative=0.5),
                            fathom_golden.accept_apart(case, relative=0), fathom_golden.accept_apart(case, relative=0.5)]
                self.assertEqual(accepted, "".join(str(int(value)) for value in expected), case.name)
        self.assertEqual(list(lines), [])

    def test_true_answers_are_accepted_and_wrong_ones_are_not(self):
        for case in self.everything:
            for direction in case.directions:
                long = [1e5 * x for x in direction]
                self.assertTrue(fathom_golden.accept(case, direction, case.signed_depth, relative=0), case.name)
                self.assertTrue(fathom_golden.accept(case, long, case.signed_depth, relative=0), case.name)
            slack = fathom_golden.allowance(case, 0, 0)
            for wrong in (case.signed_depth + 2 * slack, case.signed_depth - 2 * slack, float("nan"), float("inf")):
                self.assertFalse(fathom_golden.accept(case, None, wrong, relative=0), case.name)
            for nothing in ([0.0, 0.0, 0.0], [float("nan"), 0.0, 1.0], [float("inf"), 0.0, 1.0]):
                self.assertFalse(fathom_golden.accept(case, nothing, case.signed_depth, relative=1), case.name)
            self.assertEqual(fathom_golden.accept_apart(case, relative=0), case.signed_depth <= slack, case.name)
            self.assertEqual(fathom_golden.accept(case, None, 0, relative=0), abs(case.signed_depth) <= slack, case.name)

    def test_separating_distances_are_as_near_as_promised(self):
        """Law: a separating distance is off by less than 2^-47 of the largest coordinate, and none is below the depth."""
        decimal.getcontext().prec = 700  # coordinates from 1e-300 to 1e300
        source = random.Random(7)
        for case in self.everything:
            directions = [[source.gauss(0, 1) for _ in range(3)], [source.gauss(0, 1), 0.0, 1e-200], *case.directions[:1]]
            for direction in directions:
                u = [Fraction(x) for x in direction]
                of_a, of_b = ([sum(x * Fraction(y) for x, y in zip(u, p)) for p in body] for body in (case.a, case.b))
                h, square = (decimal.Decimal(q.numerator) / q.denominator for q in (max(of_b) - min(of_a), sum(x * x for x in u)))
                exact = h / square.sqrt()
                allowed = decimal.Decimal(case.largest) / 2 ** 47 + decimal.Decimal(2) ** -1068
                self.assertLess(abs(decimal.Decimal(fathom_golden.separating_distance(case, direction)) - exact), allowed, case.name)
                self.assertGreaterEqual(exact, decimal.Decimal(case.signed_depth) - allowed, case.name)

    def test_count_is_spread_over_the_families(self):
        everything = [case.name for case in self.everything]
        there = Counter(group(self.records[name]) for name in everything)
        for count in (1, 7, len(there), 300, len(everything), len(everything) + 1):
            chosen = self.names("--count", count)
            self.assertEqual(len(chosen), min(count, len(everything)))
            self.assertEqual(chosen, [name for name in everything if name in set(chosen)])  # in the order of the release, and no two alike
            shares = Counter(group(self.records[name]) for name in chosen)
            most = max(shares.values())
            self.assertEqual([name for name in there if shares[name] < min(most - 1, there[name])], [], count)
        self.assertLess(len([name for name in self.names("--count", 50) if name in everything[:len(everything) // 2]]), 45)

    def test_excluded(self):
        def kept(condition):
            return [case.name for case in self.everything if condition(self.records[case.name])]

        for words, flags in (("ties", {"ties"}), ("flat", {"flat_a", "flat_b", "flat_difference"}),
                             ("near_tie,huge", {"near_tie", "huge_coordinates"})):
            self.assertEqual(self.names("--exclude", words), kept(lambda record: not flags & set(record["flags"])), words)
        self.assertEqual(self.names("--exclude", "touching,disjoint"), kept(lambda record: record["expected"]["status"] == "penetrating"))
        sizes = lambda record: [len(record[body]["vertices"]) for body in "ab"]
        self.assertEqual(self.names("--max-points", "6"), kept(lambda record: max(sizes(record)) <= 6))

    def test_only(self):
        def kept(condition):
            return [case.name for case in self.everything if condition(self.records[case.name])]

        def contacts(record):
            return {optimum["contact"]["kind"] for optimum in record["expected"]["optima"]}

        self.assertEqual(self.names("--only", "ties,huge"), kept(lambda record: {"ties", "huge_coordinates"} & set(record["flags"])))
        self.assertEqual(self.names("--only", "touching"), kept(lambda record: record["expected"]["status"] == "touching"))
        self.assertEqual(self.names("--family", "boxes_aligned,real"), kept(lambda record: group(record) in ("boxes_aligned", "real")))
        self.assertEqual(self.names("--family", "far_*", "--family", "real"),
                         kept(lambda record: group(record).startswith("far_") or group(record) == "real"))
        self.assertEqual(self.names("--contact", "edge-edge"), kept(lambda record: "edge-edge" in contacts(record)))
        self.assertEqual(self.names("--exact-in", "binary32"), kept(lambda record: "binary32" in record["formats"]))
        self.assertEqual(self.names("--exact-in", "binary64"), kept(lambda record: True))
        chosen = self.names("--contact", "edge-edge,facet-facet", "--exact-in", "binary32", "--only", "thin", "--exclude", "ties")
        self.assertEqual(chosen, kept(lambda record: contacts(record) & {"edge-edge", "facet-facet"} and "binary32" in record["formats"]
                                      and {"thin_penetration", "thin_clearance"} & set(record["flags"]) and "ties" not in record["flags"]))
        self.assertGreater(len(chosen), 5)
        self.assertGreater(len(self.names("--family", "far_*")), 5)
        for case in self.everything:
            record = self.records[case.name]
            self.assertEqual((case.family, [*case.formats]), (group(record), [f for f in record["formats"] if f != "exact"]))
            self.assertEqual(set(case.contacts), contacts(record))

    def test_wrong_folders(self):
        def changed(change, all_sums_right=False):
            folder = self.folder / "changed"
            shutil.rmtree(folder, ignore_errors=True)
            shutil.copytree(COMMITTED, folder)
            (folder / FIRST).write_bytes(change(folder / FIRST))
            if all_sums_right:
                repair(folder)
            return self.refused("golden", "export", "--format", "c", folder)

        self.assertIn(f"changed/{FIRST}: the content is not what the shard's page says",
                      changed(lambda path: packed(unpacked(path)[:-1] + b" \n")))
        self.assertIn(f"changed/{FIRST}: ", changed(lambda path: path.read_bytes()[:-9]))
        for found, put in ((b'"id":"', b'"id":"\\" };'), (b'"flags":["', b'"flags":["new_'),
                           (b'"distance":{"squared":"', b'"distance":{"squared":"-'),
                           (b'"unit":{"f64":{"rn":["', b'"unit":{"f64":{"rn":["y'), (b'"vertices":[[', b'"vertices":[[]],"x":[['),
                           (b'"expected":', b'"told":')):
            sentence = changed(lambda path: packed(unpacked(path).replace(found, put, 1)), all_sums_right=True)
            self.assertRegex(sentence, rf"changed/{FIRST}:1: expected .*, found ", put)

    def test_shapes_are_not_exported(self):
        folder = self.folder / "P0"
        self.answer("golden", "generate", "--level", "P0", "--out", folder)
        said = self.refused("golden", "export", "--format", "c", folder)
        self.assertIn("holds shapes, and a case of an export is two lists of points", said)


if __name__ == "__main__":
    unittest.main()
