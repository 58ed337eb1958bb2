# SPDX-License-Identifier: GPL-3.0-or-later
"""fathom study --html: of two bodies the page of explain, with all that study --json says; of a stream the table of its cases."""
import json
import re
import unittest

from explain_test import CUBE, DATA, ICOSAHEDRON, POLYTOPES, ExplainTest, Page
from harness import UNIT, case
from schemas import validator

HOSTILE = "<script>alert(1)</script>&\"'\x1b]]>"
SHAPES = [["sphere:r=1", "sphere:r=1"], ["capsule:r=1/4,h=2", CUBE], ["cylinder:r=1,h=1,at=0:0:2", "box:half=4:4:1"],
          ["cylinder:r=1,h=5", "cone:r=1,h=1,at=0.5:0.25:1"], ["sphere:r=1", "halfspace:normal=0:0:1,offset=0"]]


def spoken(name):
    words = name.replace("_", " ")
    return words[:-1] + words[-1].upper() if words.endswith((" of a", " of b")) else words


class Studied(ExplainTest):
    def studied(self, *words, stdin=""):
        """The page, and what --json says, whether or not there is one."""
        path = self.folder / "studied.html"
        out = self.answer("study", "--json", "--html", path, *words, stdin=stdin)
        self.assertEqual(out, self.answer("study", "--json", *words, stdin=stdin))
        return path.read_text(), [json.loads(line) for line in out.splitlines()]

    def compare(self, coincidences, study):
        found = {kind: all_of for kind, all_of in study["coincidences"].items() if all_of["count"]}
        self.assertEqual([kind["kind"] for kind in coincidences], list(found))
        for kind in coincidences:
            listed = found[kind["kind"]]["listed"]
            self.assertEqual((kind["count"], len(kind["listed"])), (found[kind["kind"]]["count"], len(listed)))
            for shown, one in zip(kind["listed"], listed):
                for body in ("a", "b"):
                    if "features" not in shown:
                        self.assertEqual(shown[body], one[body])
                        continue
                    self.assertEqual(shown["features"][body].pop("length", None) is None, one[body].pop("length", None) is None)
                    self.assertEqual(shown["features"][body], one[body])

    def check_page(self, text, study):
        stages = json.loads(Page(text).block("stages"))
        validator("stages").validate(stages)
        self.compare(stages["coincidences"], study)
        self.compare(stages.get("cores", []), study.get("cores", {"coincidences": {}}))
        decided = {row["predicate"]: {"calls": row["calls"], "exact": row["exact"], "zero": row["zero"],
                                      "decided_by": row["monomials"]} for row in stages["decided"]}
        asked = {} if "signed_depth" in study and "cores" not in study else study.get("cores", study)["predicates"]
        for found in asked.values():
            for decision in found["decided_by"]:
                del decision["monomial"]
        self.assertEqual(decided, asked)

    def test_two_bodies_have_the_page_of_explain(self):
        for words in [[CUBE, ICOSAHEDRON], *SHAPES]:
            with self.subTest(words):
                text, (study,) = self.studied(*words)
                self.assertEqual(text.replace(' data-opens="coincided">', ">", 1), self.page_text(*words))
                self.check_page(text, study)

    def test_polytopes_of_every_kind(self):
        for name, line in POLYTOPES.items():
            with self.subTest(name):
                text, (study,) = self.studied("--all", "--case", name, "-", stdin=line)
                self.check_page(text, study)

    def test_a_stream(self):
        lines = "".join(POLYTOPES.values()) + case(UNIT, UNIT, id=HOSTILE) + self.answer("cases", "--shapes", "--catalogue")
        path = self.folder / "table.html"
        code, out, _ = self.run_cli("study", "--json", "--html", path, "-", stdin=lines + '{"id": "cut", "a": {}}\n')
        self.assertEqual(code, 2)
        studies = [json.loads(line) for line in out.splitlines()][:-1]
        page = Page(path.read_text())
        rows = page.rows("data-kind")
        self.assertEqual([row["data-kind"] for row in rows], [study["status"] for study in studies])
        text = re.sub(r"\s+", " ", page.texts["list"])
        self.assertIn("<script>alert(1)</script>&\"'\\x1b]]>", text)
        totals = {}
        for study in studies:
            present = {kind: all_of["count"] for kind, all_of in study["coincidences"].items() if all_of["count"]}
            self.assertIn("".join(f"; {spoken(kind)}: {count}" for kind, count in present.items()), text)
            for kind, count in present.items():
                cases, all_of_it = totals.get(kind, (0, 0))
                totals[kind] = (cases + 1, all_of_it + count)
        told = re.findall(r'data-find="; ([^"]*):">[^<]*</a></th><td>(\d+)</td><td>(\d+)</td>', path.read_text())
        self.assertEqual({kind: (int(cases), int(count)) for kind, cases, count in told},
                         {spoken(kind): found for kind, found in totals.items()})
        self.assertIn(f"{len(studies)} cases, 1 error", path.read_text())
        self.assertIn(f":{len(studies) + 1}: ", path.read_text())

    def test_the_same_bytes_with_any_number_of_threads(self):
        texts = []
        for threads in ("1", "4"):
            path = self.folder / f"page{threads}.html"
            self.run_cli("study", "--threads", threads, "--html", path, DATA / "real_cases.jsonl")
            texts.append(path.read_text().split("<footer>")[0])
        self.assertEqual(*texts)

    def test_where_it_cannot_write(self):
        code, _, err = self.run_cli("study", "--html", "/dev/full", CUBE, CUBE)
        self.assertEqual(code, 3, err)
        self.assertIn("/dev/full: cannot write the page: No space left", err)


if __name__ == "__main__":
    unittest.main()
