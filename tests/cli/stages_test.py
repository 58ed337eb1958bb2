# SPDX-License-Identifier: GPL-3.0-or-later
"""fathom stages: JSON under view/stages/stages.schema.json for every kind of input, its numbers those of depth; a summary for people."""
import copy
import json
import math
import unittest

from harness import DATA, UNIT, CliTest, box, case
from schemas import validator

VALIDATOR = validator("stages")
CUBE, ICOSAHEDRON = DATA / "cube.off", DATA / "icosahedron.off"
SQUARE = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]
BAD = '{"schema": "fathom/case/1", "id": "cut", "a":\n'
ODD = [
    case(UNIT, UNIT, id="ties"), case(UNIT, box([1, 0, 0], [2, 1, 1]), id="touch"), case(UNIT, box([2, 0, 0], [3, 1, 1]), id="apart"),
    case(SQUARE, UNIT, id="flat"), case(SQUARE, SQUARE, id="both flat"), case([[0, 0, 0]], UNIT, id="point"),
    case([[5, 5, 5]], [[5, 5, 5]], id="points"),
    case([[0, 0, 0], [1, 1, 1]], [[1, 0, 0], [0, 1, 1]], id="segments"), case([[0, 0, 0], [1, 1, 1]], UNIT, id="segment"),
    case([["0", "0", "0"], ["1e400", "0", "0"], ["0", "1e400", "0"], ["0", "0", "1e400"]], [["1e399", "1e399", "1e399"]], id="huge"),
    case([["1e300", "0", "0"], ["-1e300", "0", "0"], ["0", "1e300", "0"], ["0", "0", "1e300"]],
         [["1e-300", "1e-300", "0"], ["0", "0", "1e-300"]], id="wide"),
    case([["1/3", "0", "0"], ["0", "1/7", "0"], ["0", "0", "1/11"], ["1", "1", "1"]], UNIT, id="thirds"),
]


def pairs_of(crossings):
    return sum(len(pair["a"]) * len(pair["b"]) for pair in crossings)


class Stages(CliTest):
    def stages(self, *arguments, stdin):
        lines = [json.loads(line) for line in self.answer("stages", "--json", *arguments, "-", stdin=stdin).splitlines()]
        return lines

    def check_against_depth(self, stdin):
        """Every number that depth has too is that of depth."""
        results = [json.loads(line) for line in self.answer("depth", "--json", "-", stdin=stdin).splitlines()]
        exact = [json.loads(line) for line in self.answer("depth", "--json", "--method", "exact", "--counters", "-",
                                                          stdin=stdin).splitlines()]
        for stages, depth, run in zip(self.stages(stdin=stdin), results, exact, strict=True):
            with self.subTest(depth["id"]):
                self.check_answer(stages, depth)
                self.check_counts(stages, run["counters"])

    def check_answer(self, stages, depth):
        overlap = depth["status"] == "penetrating"
        self.assertEqual((stages["id"], stages["status"]), (depth["id"], depth["status"]))
        self.assertEqual(stages["depth"], depth["depth"]["value"] if overlap else None)
        self.assertEqual(stages["depth_squared"], depth["depth"]["squared"] if overlap else None)
        contact, unit = stages["contact"], depth["unit_f64"]
        if overlap:
            self.assertLess(math.dist(contact["direction"], unit), 1e-5)
            self.assertEqual([optimum["kind"] for optimum in contact["optima"]],
                             [optimum["contact"]["kind"] for optimum in depth["optima"]])
            self.assertEqual([optimum["features"] for optimum in contact["optima"]],
                             [{body: optimum["contact"][body] for body in "ab"} for optimum in depth["optima"]])
            self.assertEqual([facet["distance_squared"] for facet in stages["sum"]["facets"] if facet["optimal"]],
                             [stages["depth_squared"]] * len(depth["optima"]))
        else:
            self.assertEqual((contact["optima"], stages["winner"], stages["cutting"]), ([], None, None))

    def check_counts(self, stages, counters):
        self.assertEqual(stages["counts"], {name: count for name, count in counters.items() if name not in ("stages", "predicates")})
        if stages["status"] == "penetrating":  # of others `study` has them: study_html_test.py
            self.assertEqual({found["predicate"]: found["zero"] for found in stages["decided"]},
                             {name: counts["zero"] for name, counts in counters["predicates"].items()})
            pairs = stages["pairs"]
            self.assertEqual((len(pairs), pairs_of(pairs)), (counters["canonical_pairs"], counters["crossings"]))
            self.assertEqual(sum(pair["evaluated"] for pair in pairs), counters["pairs_evaluated"])

    def test_odd_bodies(self):
        self.check_against_depth("".join(ODD))

    def test_families_and_catalogue(self):
        self.check_against_depth(self.answer("cases", "--family", "all", "--count", "60", "--size", "14"))
        self.check_against_depth(self.answer("cases", "--catalogue"))

    def test_shapes(self):
        stdin = self.answer("cases", "--family", "all", "--shapes", "--count", "40") + self.answer("cases", "--catalogue", "--shapes")
        results = [json.loads(line) for line in self.answer("depth", "--json", "-", stdin=stdin).splitlines()]
        for stages, depth in zip(self.stages(stdin=stdin), results, strict=True):
            with self.subTest(depth["id"]):
                overlap = depth["status"] == "penetrating"
                self.assertEqual(stages["status"], depth["status"])
                self.assertEqual(stages["depth"], depth["depth"]["value"] if overlap else None)
                self.assertEqual(stages["depth_squared"], depth["depth"]["squared"] if overlap else None)
                if "sampled" in stages["a"]:
                    self.assertTrue(any("left out" in sentence for sentence in stages["left_out"]))

    def test_size(self):
        """Two bodies of 2,100 edges together take about 0.3 MB beside P."""
        line = self.answer("cases", "--family", "random_sphere", "--size", "352", "--count", "1")
        stages = self.stages(stdin=line)[0]
        self.assertEqual(sum(len(stages[body]["edges"]) for body in "ab"), 2100)
        stages["sum"] = {}
        size = len(json.dumps(stages, separators=(",", ":")))
        self.assertTrue(150_000 < size < 400_000, size)

    def test_is_the_same_in_every_run(self):
        stdin = self.answer("cases", "--family", "all", "--count", "30", "--size", "20")
        one, other = (self.answer("stages", "--json", "--threads", threads, "-", stdin=stdin) for threads in ("1", "2"))
        self.assertEqual(one, other)

    def test_times(self):
        stages = self.result("stages", "--times", CUBE, ICOSAHEDRON)
        self.assertLessEqual({"hulls", "charts", "canonical subsets", "closest lines"}, set(stages["seconds"]))
        self.assertTrue(any("seconds" in bound for bound in stages["bounds"]))
        self.assertNotIn("seconds", self.result("stages", CUBE, ICOSAHEDRON))

    def test_errors(self):
        code, out, err = self.run_cli("stages", "--json", "-", stdin=ODD[0] + BAD + ODD[1])
        self.assertEqual(code, 2)
        lines = [json.loads(line) for line in out.splitlines()]
        self.assertEqual([line.get("line") for line in lines], [None, 2, None])
        self.assertIn("errors: 1 of 3", err)

    def test_text(self):
        text = self.answer("stages", CUBE, ICOSAHEDRON)
        for words in ("penetrating; depth ", "A              8 vertices, 12 edges, 6 facets", "upper chart", "canonical pair", "winner"):
            self.assertIn(words, text)
        lines = self.answer("stages", "-", stdin="".join(ODD)).splitlines()
        self.assertEqual(len(lines), len(ODD))
        self.assertRegex(lines[0], r"^ties: penetrating; depth 1; \d+ canonical pairs with \d+ crossings; a facet of A$")
        self.assertIn("left out", self.answer("stages", "sphere:r=1", "box:half=1:1:1"))

    def test_schema_has_teeth(self):
        good = self.result("stages", CUBE, ICOSAHEDRON)
        for change in (lambda s: s.pop("pairs"), lambda s: s["pairs"][0].pop("strip"), lambda s: s["a"].update(arcs_of="A"),
                       lambda s: s["charts"][0]["walls"].append(["c", 0]), lambda s: s.update(depth=0),
                       lambda s: s.update(depth_squared="2/-3"), lambda s: s["a"]["arcs"][0].append(1),
                       lambda s: s["winner"].update(kind="edge"), lambda s: s.update(more=1)):
            wrong = copy.deepcopy(good)
            change(wrong)
            self.assertFalse(VALIDATOR.is_valid(wrong))


if __name__ == "__main__":
    unittest.main()
