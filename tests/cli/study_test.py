# SPDX-License-Identifier: GPL-3.0-or-later
"""fathom study: tables, JSON under cli/output/study.schema.json, a row of CSV for every case."""
import csv
import io
import json
import unittest

from harness import DATA, UNIT, CliTest, box, case, changed
from schemas import SCHEMAS, validator

VALIDATOR = validator("study")
CUBE, ICOSAHEDRON = str(DATA / "cube.off"), str(DATA / "icosahedron.off")
SQUARE = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]
SHIFTED = box([0.75, 0.25, 0.125], [1.75, 1.25, 1.125])
CASES = [case(UNIT, SHIFTED, id="shifted, \"quoted\""), case(UNIT, UNIT, id="same"), case(UNIT, box([1, 0, 0], [2, 1, 1]), id="touching"),
         case(UNIT, box([2, 0, 0], [3, 1, 1]), id="apart"), case(SQUARE, SQUARE, id="flat"), case([[0, 0, 0]], UNIT, id="point")]
BAD = '{"id": "cut, \\"off\\"", "a": {}}\n'
KINDS = list(SCHEMAS["study.schema.json"]["$defs"]["study"]["properties"]["coincidences"]["properties"])
PREDICATES = list(SCHEMAS["study.schema.json"]["$defs"]["study"]["properties"]["predicates"]["properties"])


class Json(CliTest):
    def studies(self, *options, stdin):
        code, out, err = self.run_cli("study", "--json", *options, "-", stdin=stdin)
        return code, [json.loads(line) for line in out.splitlines()], err

    def test_obeys_its_schema(self):
        code, lines, err = self.studies(stdin="".join(CASES) + BAD)
        self.assertEqual((code, len(lines), err), (2, len(CASES) + 1, f"fathom: errors: 1 of {len(CASES) + 1} lines\n"))
        lines += self.studies("--all", stdin="".join(CASES))[1]
        lines += [json.loads(line) for line in self.answer("study", "--json", DATA / "real_cases.jsonl").splitlines()]
        lines.append(self.result("study", CUBE, ICOSAHEDRON))
        self.assertEqual(list(lines[len(CASES)]), ["schema", "id", "line", "error"])

    def test_the_schema_has_teeth(self):
        good = self.studies(stdin=CASES[0])[1][0]
        for path, value in ((["status"], "inside"), (["squared"], "0.5"), (["predicates", "x_order", "zero"], -1), (["more"], 1),
                            (["coincidences", "ties", "listed"], [{"a": [[]], "b": []}]), (["bodies", "a", "rank"], 4),
                            (["predicates", "x_order", "decided_by"], [{"monomial": "e1", "name": "E44", "count": 1}])):
            self.assertFalse(VALIDATOR.is_valid(changed(good, path, value)), path)
        for field in good:
            self.assertFalse(VALIDATOR.is_valid({key: good[key] for key in good if key != field}), field)

    def test_two_cubes(self):
        study = self.result("study", self.file("a.xyz", UNIT), self.file("b.xyz", SHIFTED))
        counts = {kind: found["count"] for kind, found in study["coincidences"].items()}
        self.assertEqual((study["status"], study["squared"], study["optima"]), ("penetrating", "1/16", 1))
        self.assertEqual((counts["parallel_edges"], counts["parallel_edges_of_a"], counts["parallel_edges_of_b"]), (48, 18, 18))
        self.assertEqual((counts["coincident_normals"], counts["equal_normals"], counts["coplanar_facets"], counts["ties"]), (6, 6, 0, 0))
        for predicate in study["predicates"].values():
            self.assertEqual(sum(decision["count"] for decision in predicate["decided_by"]), predicate["zero"])

    def test_listings(self):
        first, every = (self.studies(*options, stdin=CASES[1])[1][0]["coincidences"] for options in ([], ["--all"]))
        self.assertEqual({kind: found["count"] for kind, found in first.items()}, {kind: found["count"] for kind, found in every.items()})
        for kind in KINDS:
            self.assertEqual(len(every[kind]["listed"]), every[kind]["count"])
            self.assertEqual(first[kind]["listed"], every[kind]["listed"][:20])
        self.assertEqual(every["ties"]["count"], 6)
        self.assertIn({"a": [[0, 1, 2, 3]], "b": [[4, 5, 6, 7]]}, every["ties"]["listed"])


class Csv(CliTest):
    def rows(self, text):
        self.assertTrue(text.endswith("\n"))
        return list(csv.DictReader(io.StringIO(text, newline=""), strict=True))

    def test_a_row_per_case(self):
        code, out, err = self.run_cli("study", "--csv", "-", stdin="".join(CASES[:3]) + BAD + "".join(CASES[3:]))
        rows = self.rows(out)
        self.assertEqual((code, len(rows), err), (2, len(CASES) + 1, f"fathom: errors: 1 of {len(CASES) + 1} lines\n"))
        self.assertEqual([row["id"] for row in rows], ["shifted, \"quoted\"", "same", "touching", "cut, \"off\"", "apart", "flat", "point"])
        self.assertIn("<stdin>:4: ", rows.pop(3)["error"])
        self.assertEqual([row["status"] for row in rows], ["penetrating", "penetrating", "touching", "disjoint", "touching", "touching"])
        studies = [json.loads(line) for line in self.answer("study", "--json", "-", stdin="".join(CASES)).splitlines()]
        for row, study in zip(rows, studies):
            self.assertEqual((row["squared"], row["optima"], row["error"]), (study["squared"], str(study["optima"]), ""))
            self.assertEqual([row[kind] for kind in KINDS], [str(study["coincidences"][kind]["count"]) for kind in KINDS])
            for predicate in PREDICATES:
                for tier in ("calls", "exact", "zero"):
                    self.assertEqual(row[f"{predicate}_{tier}"], str(study["predicates"][predicate][tier]))

    def test_no_control_character_reaches_a_terminal(self):
        evil = "\x1b[2J\x7f\x9b31m\n"
        bad = case([[0, 0]], UNIT, id=evil + "bad")
        _, out, err = self.run_cli("study", "--csv", "-", stdin=case(UNIT, UNIT, id=evil) + bad)
        self.assertEqual([c for c in out + err if c != "\n" and not c.isprintable()], [])
        self.assertEqual([json.loads(row["id"]) for row in self.rows(out)], [evil, evil + "bad"])
        err = self.refused("study", f"{self.folder}/none\x1b[2J.off", CUBE)
        self.assertEqual([c for c in err if c != "\n" and not c.isprintable()], [])

    def test_two_meshes(self):
        self.assertEqual([row["id"] for row in self.rows(self.answer("study", "--csv", CUBE, ICOSAHEDRON))], [f"{CUBE} {ICOSAHEDRON}"])


class Text(CliTest):
    def test_tables(self):
        short, full = (self.answer("study", *options, CUBE, CUBE) for options in ([], ["--all"]))
        self.assertTrue(short.startswith("penetrating; depth^2 1; 6 optima\nA  8 vertices, 12 edges, 6 facets\nB  8 vertices, "), short)
        words = " ".join(short.split())
        for line in ("side of arc ", "decided by", "parallel edges 48 A ", "parallel edges of A 18 A ", "coincident normals 6 A ",
                     "none: "):
            self.assertIn(line, words)
        self.assertGreater(len(full.splitlines()), 100)
        self.assertLessEqual(max(map(len, short.splitlines())), 140)
        self.assertEqual(short, "\n".join(line.rstrip() for line in short.split("\n")))
        self.assertTrue(set(short.splitlines()[:10]) <= set(full.splitlines()))

    def test_a_line_per_case(self):
        code, out, err = self.run_cli("study", "-", stdin="".join(CASES) + BAD)
        self.assertEqual((code, out.count("\n")), (2, len(CASES)))
        self.assertTrue(err.startswith("fathom: <stdin>:7: "), err)
        self.assertIn("\napart: disjoint; side of equator ", out)
        self.assertIn("; parallel edges 48; ", out)


if __name__ == "__main__":
    unittest.main()
