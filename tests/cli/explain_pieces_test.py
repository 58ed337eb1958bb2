# SPDX-License-Identifier: GPL-3.0-or-later
"""fathom explain --pieces: the numbers of the page are those of `depth --pieces --json`, and its data obey their schema."""
import json
import unittest
from fractions import Fraction

from explain_test import Page, numbers
from harness import DATA, CliTest, box, changed
from schemas import validator

VALIDATOR = validator("union_stages")
COMB, KEY = str(DATA / "comb.obj"), str(DATA / "key.obj")
FACES = [[1, 3, 4, 2], [5, 6, 8, 7], [1, 2, 6, 5], [3, 7, 8, 4], [1, 5, 7, 3], [2, 4, 8, 6]]


def obj(*boxes):
    """Boxes as the tools for convex decomposition write them: a group each, with vertices of its own."""
    text = ""
    for k, corners in enumerate(boxes):
        text += f"o convex_{k}\n" + "".join("v {} {} {}\n".format(*p) for p in box(*corners))
        text += "".join("f " + " ".join(str(8 * k + i) for i in face) + "\n" for face in FACES)
    return text


SLOT = obj([[-9, -5, -5], [0, 5, 5]], [[1, -5, -5], [10, 5, 5]])
PLATE = obj([[0.75, -1, -1], [1.75, 1, 1]])
CUBE = obj([[-1, -1, -1], [1, 1, 1]])
SLABS = obj([[-9, -9, -2], [9, 9, 0]], [[-9, -9, 0], [9, 9, 2]])
APART = obj([[50, 0, 0], [51, 1, 1]], [[3.75, 0, 0], [4, 1, 1]])


class ExplainPieces(CliTest):
    def page(self, a, b):
        path = self.folder / "page.html"
        self.assertEqual(self.answer("explain", "--pieces", a, b, "-o", path), "")
        return Page(path.read_text())

    def files(self, a, b):
        return self.file("a.obj", a), self.file("b.obj", b)

    def check(self, a, b):
        """The page is about what these files are about for `depth --pieces`."""
        page = self.page(a, b)
        text = self.answer("depth", "--pieces", "--patch", "--json", a, b)
        text = text.replace(f"{self.folder}/", "").replace(f"{DATA}/", "")  # the page names no folder
        self.assertEqual(page.block("depth") + "\n", text.replace("<", "\\u003c"))
        depth, stages = json.loads(text), json.loads(page.block("stages"))
        VALIDATOR.validate(stages)
        self.assertEqual(page.fields["status"], depth["status"])
        sections = [attributes["id"] for tag, attributes in page.elements if tag == "section"]
        self.assertEqual(sections, ["what", "why", "left-out"])
        self.assertIn("stages of the algorithm", page.texts["left-out"])
        ids = [attributes["id"] for _, attributes in page.elements if "id" in attributes]
        self.assertEqual(len(ids), len(set(ids)))
        if depth["status"] == "penetrating":
            self.check_overlap(page, depth, stages)
        return page, depth, stages

    def check_overlap(self, page, depth, stages):
        for field, length in (("depth", depth["depth"]), ("deepest_pair", depth["deepest_pair"]["depth"]), ("hulls", depth["hulls"])):
            self.assertEqual(numbers(page.fields[field]), [length["value"]], field)
        self.assertIn(depth["depth"]["value"], numbers(page.texts["answer"]))
        first = depth["optima"][0]
        self.assertEqual(numbers(page.fields["translation"]), [float(Fraction(x)) for x in first["translation"]])
        self.assertEqual(page.fields["clearance"], "yes" if first["clearance"] else "none: an exact fit")
        self.assertEqual(int(page.fields["optima"]), len(depth["optima"]))
        self.assertEqual(numbers(page.fields["deepest_pieces"]), depth["deepest_pair"]["pieces"])
        self.assertEqual(len(page.rows("data-optimum")), len(depth["optima"]) if len(depth["optima"]) > 1 else 0)
        self.assertEqual([len(way["contacts"]) for way in stages["ways"]], [len(optimum["contacts"]) for optimum in depth["optima"]])
        touching = {tuple(contact["pieces"]) for optimum in depth["optima"] for contact in optimum["contacts"]}
        self.assertEqual({tuple(each["pieces"]) for each in stages["sums"] if each["touches"]}, touching)
        inside = {tuple(each["pieces"]): Fraction(each["distance_squared"]) for each in stages["sums"] if each["inside"]}
        self.assertEqual(max(inside.values()), Fraction(depth["deepest_pair"]["depth"]["squared"]))
        for each in stages["sums"]:
            self.assertLessEqual(Fraction(each["distance_squared"]), Fraction(depth["depth"]["squared"]))

    def test_the_comb_and_the_key(self):
        _, _, stages = self.check(KEY, COMB)
        self.assertEqual([each["pieces"] for each in stages["sums"] if each["touches"]], [[1, 1], [2, 3]])

    def test_an_exact_fit_and_ties(self):
        self.check(*self.files(PLATE, SLOT))
        _, depth, _ = self.check(*self.files(CUBE, SLABS))
        self.assertEqual(len(depth["optima"]), 2)

    def test_touching_and_disjoint(self):
        page, _, stages = self.check(*self.files(PLATE, obj([[1.75, 1, 1], [10, 10, 10]])))
        self.assertEqual((stages["ways"][0]["translation"], stages["sums"]), ([0, 0, 0], []))
        page, depth, _ = self.check(*self.files(PLATE, APART))
        self.assertEqual(numbers(page.fields["distance"]), [depth["apart"]["distance"]["value"]])
        self.assertEqual(numbers(page.fields["between"]), depth["apart"]["pieces"])
        for body in "ab":
            self.assertEqual(numbers(page.fields[f"witness_{body}"]), [float(Fraction(x)) for x in depth["apart"]["witness"][body]])

    def test_tiny_and_huge_bodies(self):
        for unit in (1e-200, 1e300):
            scaled = lambda *boxes: obj(*([[x * unit for x in corner] for corner in each] for each in boxes))
            page, _, _ = self.check(*self.files(scaled([[-1, -1, -1], [1, 1, 1]]),
                                                scaled([[-9, -9, -2], [9, 9, 0]], [[-9, -9, 0], [9, 9, 2]])))
            self.assertEqual(numbers(page.fields["depth"]), [3 * unit])

    def test_the_same_input_makes_the_same_page(self):
        page = self.folder / "page.html"
        texts = []
        for _ in range(2):
            self.answer("explain", "--pieces", KEY, COMB, "-o", page)
            texts.append(page.read_bytes())
        self.assertEqual(texts[0], texts[1])

    def test_ids_are_text(self):
        self.check(self.file("<b>&amp;.obj", PLATE), self.file("</script>.obj".replace("/", "_"), SLOT))

    def test_the_schema_has_teeth(self):
        good = json.loads(self.page(KEY, COMB).block("stages"))
        for path, value in ((["status"], "inside"), (["sums", 0, "distance_squared"], 0.25), (["ways", 0, "contacts"], []),
                            (["a", 0, "ids"], [-1]), (["sums", 0, "through"], [[1]]), (["extra"], 1)):
            self.assertFalse(VALIDATOR.is_valid(changed(good, path, value)), path)


if __name__ == "__main__":
    unittest.main()
