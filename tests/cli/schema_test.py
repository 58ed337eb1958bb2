# SPDX-License-Identifier: GPL-3.0-or-later
"""Everything that --json prints obeys reference/output/result.schema.json, and the schema has teeth."""
import copy
import json
import unittest

import jsonschema  # Debian: python3-jsonschema
from harness import DATA, ROOT, UNIT, CliTest, box, case

SCHEMA = json.loads((ROOT / "reference/output/result.schema.json").read_text())
VALIDATOR = jsonschema.Draft202012Validator(SCHEMA)
SQUARE = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]
STREAM = "".join([
    case(UNIT, UNIT, id="ties"), case(UNIT, box([1, 0, 0], [2, 1, 1])), case(UNIT, box([2, 0, 0], [3, 1, 1])),
    case(SQUARE, UNIT), case(SQUARE, SQUARE), case(UNIT, box([0.3, 0.1, 0.2], [1, 1.5, 9])), "noise\n", '{"id": "cut"\n',
    case([["0", "0", "0"], ["1e400", "0", "0"], ["0", "1e400", "0"], ["0", "0", "1e400"]], [["1e399", "1e399", "1e399"]]),
    case([["0", "0", "0"], ["1e-400", "0", "0"], ["0", "1e-400", "0"], ["0", "0", "1e-400"]], [["1e-401", "1e-401", "1e-401"]])])


class Schema(CliTest):
    def lines(self, *arguments, stdin=""):
        _, out, _ = self.run_cli(*arguments, "--json", stdin=stdin)
        return [json.loads(line) for line in out.splitlines()]

    def test_is_a_schema(self):
        jsonschema.Draft202012Validator.check_schema(SCHEMA)

    def test_all_output(self):
        count = 0
        for command in ("depth", "width"):
            for options in ([], ["--counters", "--digits", "25"], ["--method", "naive"], ["--method", "shallow", "--counters"],
                            ["--method", "certificate", "--embed-certificate"], ["--method", "exact", "--counters"]):
                lines = self.lines(command, *options, "-", stdin=STREAM)
                self.assertEqual(len(lines), STREAM.count("\n"))
                count += len(lines)
                for line in lines:
                    VALIDATOR.validate(line)
        for line in self.lines("depth", DATA / "real_cases.jsonl"):
            VALIDATOR.validate(line)
            count += 1
        self.assertGreater(count, 120)

    def test_rejects_what_is_wrong(self):
        good, error = self.lines("depth", "--counters", "--digits", "5", "-", stdin=case(UNIT, UNIT, id="x") + "noise\n")
        VALIDATOR.validate(good)
        VALIDATOR.validate(error)

        def broken(result, *path_and_value):
            *path, last, value = path_and_value
            changed = copy.deepcopy(result)
            place = changed
            for step in path:
                place = place[step]
            if value is None:
                del place[last]
            else:
                place[last] = value
            return changed

        for wrong in (
                *(broken(good, field, None) for field in good if field not in ("counters", "sizes") and not field.endswith("_f64")),
                broken(good, "more", 1), broken(good, "certificate", "trust me"), broken(good, "status", "inside"),
                broken(good, "depth", "squared", 1), broken(good, "depth", "squared", "-1"), broken(good, "depth", "value", "1"),
                broken(good, "depth", "rounded", "f64", "rn", "1.0"), broken(good, "depth", "enclosure", ["1"]),
                broken(good, "translation", [0, 0, 0]), broken(good, "translation", ["1", "0"]),
                broken(good, "direction", ["1/2", "0", "0"]), broken(good, "contact", "kind", "edge-vertex"),
                broken(good, "contact", "a", [-1]), broken(good, "optima", []), broken(good, "flat", ["c"]), broken(good, "method", "auto"),
                broken(good, "counters", "crossings", -1), broken(good, "status", "touching"),
                *(broken(error, field, None) for field in error), broken(error, "line", 0), broken(error, "status", "disjoint")):
            self.assertFalse(VALIDATOR.is_valid(wrong), wrong)


if __name__ == "__main__":
    unittest.main()
