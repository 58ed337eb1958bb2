# SPDX-License-Identifier: GPL-3.0-or-later
"""Every line of JSON that a transcript shows obeys the schema that it names; and each schema refuses what is wrong."""
import collections
import json
import sys
import unittest

import jsonschema  # Debian: python3-jsonschema
from harness import DATA, ROOT, UNIT, CliTest, box, case, changed
from schemas import NAMES, SCHEMAS, validator

sys.path.insert(0, str(ROOT / "tests" / "docs"))
from console import blocks, commands  # noqa: E402

PRESENT = object()  # in place of a value: any


def shown():
    """(page, value) of each whole line of JSON with a schema that is expected of a command."""
    for page in sorted((ROOT / "tests/cli/transcripts").glob("*.md")):
        for _, _, lines in blocks(page.read_text()):
            for _, output in commands(lines):
                for line in output:
                    if line.startswith('{"schema":') and line.endswith("}") and "..." not in line:
                        yield page.name, json.loads(line)


# By schema: what the line that is changed has, the fields that need not be there, and each wrong change, as path and value.
TEETH = {
    "result": [
        ({"status": "penetrating", "method": "certificate"}, {"unit_f64", "translation_f64", "witness_f64", "sizes", "hull", "width"}, [
            (["more"], 1), (["certificate"], "trust me"), (["status"], "inside"), (["depth", "squared"], 1),
            (["depth", "squared"], "-1"), (["depth", "value"], "1"), (["depth", "rounded", "f64", "rn"], "1.0"),
            (["depth", "enclosure"], ["1"]), (["translation"], [0, 0, 0]), (["translation"], ["1", "0"]),
            (["direction"], ["1/2", "0", "0"]), (["contact", "kind"], "edge-vertex"), (["contact", "a"], [-1]),
            (["optima"], []), (["flat"], ["c"]), (["method"], "auto"), (["counters"], {"crossings": -1}),
            (["status"], "touching")]),
        ({"status": "disjoint", "distance": PRESENT}, {"unit_f64", "translation_f64", "witness_f64", "sizes", "hull", "distance"}, [
            (["distance", "squared"], "0"), (["distance", "squared"], "-4"), (["distance", "witness"], None),
            (["distance", "direction"], None), (["distance", "more"], 1), (["status"], "touching")]),
        ({"dimension": 2, "status": "penetrating"}, {"unit_f64", "translation_f64", "witness_f64", "sizes"}, [
            (["dimension"], 3), (["direction"], ["-1", "0", "0"]), (["translation"], ["-1", "0", "0"]), (["unit_f64"], [-1.0, 0.0, 0.0]),
            (["contact", "kind"], "facet-edge"), (["contact", "kind"], "vertex-vertex"), (["optima"], [])]),
        ({"method": "approx"}, {"unit_f64", "translation_f64", "witness_f64", "sizes", "hull"}, [
            (["delta"], "0"), (["delta"], 1), (["rays"], -1), (["bound"], None), (["method"], "exact"), (["optima"], [{}]),
            (["witness"], 1), (["counters"], {}), (["distance"], None)]),
        ({"line": PRESENT}, set(), [(["line"], 0), (["status"], "disjoint")])],
    "metric": [({"status": "penetrating"}, set(), [
        (["depth"], {"exact": "1"}), (["ball"], {"kind": "ball", "vertices": 4}), (["optima"], []),
        (["status"], "touching"), (["rays"], -1), (["more"], 1), (["optima", 0, "vertex"], "0")]),
        ({"dimension": 2, "status": "penetrating"}, set(), [
            (["direction"], ["1", "0", "0"]), (["optima", 0, "contact", "kind"], "facet-edge"), (["dimension"], 3)])],
    "ray": [({"status": "penetrating", "ray": ["-1", "0", "0"]}, set(), [
        (["factor"], "0"), (["factor"], "-1"), (["normal"], None), (["status"], "disjoint"), (["ray"], ["1", "0"]),
        (["more"], 1), (["witness"], None), (["steps"], -1)]),
        ({"dimension": 2, "status": "penetrating"}, set(), [
            (["ray"], ["1", "0", "0"]), (["translation"], ["1", "0", "0"]), (["normal"], ["1", "0", "0"]),
            (["contact", "kind"], "facet-edge"), (["dimension"], 3)])],
    "growth": [
        ({"status": "disjoint"}, set(), [
            (["growth", "exact"], "0"), (["growth", "exact"], "-1"), (["normal"], None), (["normal"], ["1/2", "0", "0"]),
            (["weights"], None), (["weights", "a"], []), (["weights", "a", 0], [0, "1/2", 1]), (["weights", "a", 0, 1], "0"),
            (["witness", "a"], ["1", "0"]), (["centers", "b"], None), (["more"], 1), (["flat"], ["b", "a"]), (["steps"], -1)]),
        ({"dimension": 2, "status": "penetrating"}, set(), [
            (["normal"], ["1", "0", "0"]), (["centers", "a"], ["1", "0", "0"]), (["contact", "kind"], "facet-edge"), (["dimension"], 3)]),
        ({"status": "penetrating", "normal": None}, set(), [(["status"], "touching"), (["normal"], ["1", "0", "0"]), (["witness"], {})])],
    "impact": [
        ({"status": "contact"}, set(), [
            (["status"], "apart"), (["first_contact"], None), (["first_contact", "t0", "exact"], "-1"),
            (["first_contact", "point"], ["1", "0"]), (["first_contact", "normal"], ["1/2", "0", "0"]),
            (["first_contact", "weights", "a"], []),
            (["first_contact", "contact", "a"], [-1]),
            (["pieces"], []), (["pieces", 0, "gap"], "1"), (["pieces", 0, "plane"], "edge"), (["pieces", 0, "until"], 1),
            (["more"], 1),
            (["motion", "a", "q0"], ["1", "0", "0"]), (["beginning"], {}), (["questions"], 0)]),
        ({"status": "grazing"}, set(), [(["pieces", 1, "gap"], "0"), (["pieces", 1, "gap"], None), (["pieces", 1, "directions"], [])])],
    "along": [({"steps": 4}, set(), [
        (["steps"], 0), (["values", 0, "s"], "0.5"), (["values", 0, "status"], "inside"), (["values", 0, "value"], "1"),
        (["values", 0, "signed_depth", "exact", "root"], "-1"), (["values", 0, "more"], 1), (["along"], ["1", "0"])])],
    "study": [
        ({"squared": "1/16"}, set(), [
            (["status"], "inside"), (["squared"], "0.5"), (["predicates", "x_order", "zero"], -1), (["more"], 1),
            (["coincidences", "ties", "listed"], [{"a": [[]], "b": []}]), (["bodies", "a", "rank"], 4),
            (["predicates", "x_order", "decided_by"], [{"monomial": "e1", "name": "E44", "count": 1}])]),
        ({"signed_depth": PRESENT}, {"cores"}, [
            (["more"], 1), (["status"], "inside"), (["contact", "a", "feature"], "nose")])],
    "solid": [({"solid": PRESENT}, set(), [
        (["more"], 1), (["solid", "pieces"], 0), (["solid", "points", "all"], 3), (["solid", "volume", "exact"], "0.5"),
        (["solid", "turned"], 1), (["solid", "more"], 1), (["solid"], None)]), ({"coverage": PRESENT}, {"coverage"}, [
        (["coverage"], None), (["coverage", "tiles"], 1), (["coverage", "missing", "exact"], "0.5"), (["coverage", "outside"], "1"),
        (["coverage", "most_outside", "piece"], -1), (["coverage", "stray"], ["1", "2"]), (["coverage", "uncovered"], [1, 2, 3]),
        (["coverage", "overlap"], None), (["coverage", "more"], 1)])],
    "robot": [({"pairs": PRESENT}, set(), [
        (["more"], 1), (["links"], []), (["links", 0, "elements"], -1), (["joints", 0, "value"], 0.5), (["adjacent"], -1),
        (["angles", "off_by_less_than"], "1"), (["pairs", 0, "status"], "inside"), (["pairs", 0, "more"], 1),
        (["pairs", 0, "signed_depth", "exact", "root"], "-1"), (["pairs", 0, "signed_depth", "low"], "1"), (["notes"], [1])])],
    "union": [({"status": "penetrating"}, {"hull", "solids"}, [
        (["status"], "inside"), (["complete"], 1), (["optima", 0, "clearance"], "none"), (["extra"], 1),
        (["optima", 0, "translation", 0], 0.5), (["deepest_pair", "pieces"], [0])])],
}


SQUARE = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]
STREAM = "".join([
    case(UNIT, UNIT, id="ties"), case(UNIT, box([1, 0, 0], [2, 1, 1])), case(UNIT, box([2, 0, 0], [3, 1, 1])),
    case(SQUARE, UNIT), case(SQUARE, SQUARE), case(UNIT, box([0.3, 0.1, 0.2], [1, 1.5, 9])), "noise\n", '{"id": "cut"\n',
    case([["0", "0", "0"], ["1e400", "0", "0"], ["0", "1e400", "0"], ["0", "0", "1e400"]], [["1e399", "1e399", "1e399"]]),
    case([["0", "0", "0"], ["1e-400", "0", "0"], ["0", "1e-400", "0"], ["0", "0", "1e-400"]],
         [["1e-401", "1e-401", "1e-401"]])])


class Schemas(CliTest):
    lines = list(shown())

    def test_every_line_obeys_its_schema(self):
        seen = collections.Counter()
        for page, value in self.lines:
            with self.subTest(page=page, id=value.get("id")):
                validator(NAMES[value["schema"]]).validate(value)
                seen[value["schema"]] += 1
        self.assertLessEqual(set(TEETH), {NAMES[schema] for schema in seen}, seen)

    def test_results_of_every_method(self):
        """Too many and too long to be shown."""
        count = 0
        runs = [(command, *options, "-") for command in ("depth", "width") for options in (
            [], ["--counters", "--digits", "25"], ["--method", "naive"], ["--method", "shallow", "--counters"],
            ["--method", "certificate", "--embed-certificate"], ["--method", "exact", "--counters"])]
        runs.append(("depth", "--patch", "--twist", "1,0,0,0,1/2,1", "--embed-certificate", "-"))
        for run in [*runs, ("depth", DATA / "real_cases.jsonl")]:
            lines = self.run_cli(*run, "--json", stdin=STREAM)[1].splitlines()
            self.assertEqual(len(lines), STREAM.count("\n") if run[-1] == "-" else 63)
            for line in lines:
                validator("result").validate(json.loads(line))
            count += len(lines)
        self.assertGreater(count, 120)

    def test_they_are_schemas(self):
        for schema in SCHEMAS.values():
            jsonschema.Draft202012Validator.check_schema(schema)

    def test_they_have_teeth(self):
        for name, cases in TEETH.items():
            check = validator(name)
            for wanted, optional, changes in cases:
                good = next(value for _, value in self.lines if NAMES[value["schema"]] == name and all(
                    field in value if want is PRESENT else value.get(field) == want for field, want in wanted.items()))
                for field in good.keys() - optional:
                    less = {key: good[key] for key in good if key != field}
                    self.assertFalse(check.is_valid(less), (name, wanted, field))
                for path, value in changes:
                    self.assertFalse(check.is_valid(changed(good, path, value)), (name, path, value))


if __name__ == "__main__":
    unittest.main()
