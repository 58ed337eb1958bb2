# SPDX-License-Identifier: GPL-3.0-or-later
"""fathom explain: the numbers of the page are those of `depth --json`, and it asks nobody for anything."""
import base64
import hashlib
import html.parser
import json
import math
import re
import unittest
from fractions import Fraction

from harness import DATA, UNIT, VERSION, CliTest, box, case
from schemas import validator

VALIDATOR = validator("stages")
CUBE, ICOSAHEDRON = str(DATA / "cube.off"), str(DATA / "icosahedron.off")
SQUARE = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]
SHIFTED = box([0.75, 0.25, 0.125], [1.75, 1.25, 1.125])
SECTIONS = ["what", "why", "where", "coincided", "cost"]
VOID = {"meta", "br", "img", "link", "input", "hr"}
NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[+-]?\d+)?")


def scaled(points, factor):
    return [[x * factor for x in point] for point in points]


POLYTOPES = {
    "shifted": case(UNIT, SHIFTED, id="shifted"),
    "same": case(UNIT, UNIT, id="same"),
    "touching": case(UNIT, box([1, 0, 0], [2, 1, 1]), id="touching"),
    "apart": case(UNIT, box([3, 2, 0], [4, 3, 1]), id="apart"),
    "flat": case(SQUARE, SQUARE, id="flat"),
    "flat in solid": case(UNIT, [[0.25, 0.25, 0.5], [0.75, 0.25, 0.5], [0.25, 0.75, 0.5]], id="flat in solid"),
    "needle in solid": case([[0.5, 0.5, 0.25], [0.5, 0.25, 0.75]], UNIT, id="needle in solid"),
    "point": case([[0.5, 0.25, 0.5]], UNIT, id="point"),
    "huge": case(scaled(UNIT, 1e300), scaled(SHIFTED, 1e300), id="huge"),
    "tiny": case(scaled(UNIT, 1e-300), scaled(SHIFTED, 1e-300), id="tiny"),
    "far": case([[x + 1e15 for x in p] for p in UNIT], [[x + 1e15 for x in p] for p in box([0.5, 0, 0], [1.5, 1, 1])], id="far"),
}


class Page(html.parser.HTMLParser):
    """What tests ask of a page. Fails where elements do not close in order."""

    def __init__(self, text):
        super().__init__(convert_charrefs=True)
        self.elements, self.fields, self.raw, self.texts, self.open = [], {}, [], {}, []
        self.feed(text)
        self.close()
        if self.open:
            raise AssertionError(f"not closed: {self.open}")

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.elements.append((tag, attributes))
        if tag not in VOID:
            self.open.append((tag, attributes))
        if tag in ("script", "style"):
            self.raw.append([tag, attributes, ""])

    def handle_startendtag(self, tag, attributes):
        self.elements.append((tag, dict(attributes)))

    def handle_endtag(self, tag):
        if not self.open or self.open[-1][0] != tag:
            raise AssertionError(f"</{tag}> in {[name for name, _ in self.open]}")
        self.open.pop()

    def handle_data(self, data):
        if self.open and self.open[-1][0] in ("script", "style"):
            self.raw[-1][2] += data
            return
        for _, attributes in self.open:
            if "data-field" in attributes:
                name = attributes["data-field"]
                self.fields[name] = self.fields.get(name, "") + data
            if "id" in attributes:
                self.texts[attributes["id"]] = self.texts.get(attributes["id"], "") + data

    def block(self, name):
        return next(text for tag, attributes, text in self.raw if attributes.get("id") == name)

    def rows(self, key):
        return [attributes for tag, attributes in self.elements if tag == "tr" and key in attributes]


def numbers(text):
    return [float(number) for number in NUMBER.findall(text)]


class ExplainTest(CliTest):
    def page_text(self, *arguments, stdin=""):
        path = self.folder / "page.html"
        self.assertEqual(self.answer("explain", *arguments, "-o", path, stdin=stdin), "")
        return path.read_text()

    def page(self, *arguments, stdin=""):
        return Page(self.page_text(*arguments, stdin=stdin))


class Content(ExplainTest):
    def check_numbers(self, page, depth):
        told = depth.get("distance", depth)
        length = told.get("value") if "distance" in depth else depth["depth"]["value"]
        field = page.fields.get("distance" if "distance" in depth else "depth")
        if depth["status"] in ("penetrating", "disjoint") and length is not None:
            self.assertEqual(numbers(field), [length])
            self.assertIn(str(field), page.texts["answer"])
        for name, values in (("unit", told["unit_f64"]), ("translation", told["translation_f64"])):
            if values is not None and depth["status"] != "touching":
                self.assertEqual(numbers(page.fields[name]), values, name)
        for body in ("a", "b"):
            if told["witness_f64"] is not None:
                self.assertEqual(numbers(page.fields[f"witness_{body}"]), told["witness_f64"][body])
            if depth["sizes"][body] is not None:
                self.assertEqual(numbers(page.fields[f"size_{body}"]), depth["sizes"][body])
        self.assertEqual(page.fields["status"], depth["status"])
        if depth["status"] == "penetrating" and depth["method"] == "enclosure":
            self.assertNotIn("optima", page.fields)
        elif depth["status"] == "penetrating" and len(depth.get("optimal_cone", {"rays": [0]})["rays"]) != 1:
            self.assertRegex(page.fields["optima"], "^(every|all) direction")
        elif depth["status"] == "penetrating":
            self.assertEqual(int(page.fields["optima"]), len(depth["optima"]))
            self.assertEqual(len(page.rows("data-optimum")), min(20, len(depth["optima"])) if len(depth["optima"]) > 1 else 0)

    def check_page(self, page, words, stdin=""):
        """The page is about what these words are about for `depth` and `stages`."""
        of_files = lambda text: text.replace(f"{DATA}/", "")  # the page names no folder
        depth = of_files(self.answer("depth", "--patch", "--json", *words, stdin=stdin))
        self.assertEqual(page.block("depth") + "\n", depth.replace("<", "\\u003c"))
        self.check_numbers(page, json.loads(depth))
        stages = json.loads(page.block("stages"))
        VALIDATOR.validate(stages)
        self.assertEqual(stages, json.loads(of_files(self.answer("stages", "--json", *words, stdin=stdin))))
        again = self.result("depth", "--patch", "-", stdin=page.block("case") + "\n")
        self.assertEqual({**again, "hull": None}, {**json.loads(depth), "hull": None})
        sections = [attributes["id"] for tag, attributes in page.elements if tag == "section"]
        self.assertEqual(sections[:5], SECTIONS)
        ids = [attributes["id"] for _, attributes in page.elements if "id" in attributes]
        self.assertEqual(len(ids), len(set(ids)))
        return stages

    def test_two_meshes(self):
        stages = self.check_page(self.page(CUBE, ICOSAHEDRON), [CUBE, ICOSAHEDRON])
        self.assertEqual(stages["sum"]["kind"], "P")

    def test_polytopes_of_every_kind(self):
        for name, line in POLYTOPES.items():
            with self.subTest(name):
                page = self.page("-", stdin=line)
                stages = self.check_page(page, ["-"], stdin=line)
                depth = json.loads(page.block("depth"))
                inside = depth["status"] == "penetrating"
                self.assertEqual(stages["sum"]["kind"], "P" if inside else "none")
                self.assertEqual(bool(stages["left_out"]), "left-out" in page.texts)
                self.assertEqual(sum(facet["optimal"] for facet in stages["sum"]["facets"]), len(depth["optima"]))

    def test_shapes(self):
        for words in (["sphere:r=1", "box:half=1:1:1"], ["sphere:r=1", "halfspace:normal=0:0:1,offset=0"], ["capsule:r=1/4,h=2", CUBE],
                      ["cylinder:r=1,h=2", "cone:r=1,h=1,quaternion=2:1:0:0,at=0.5:0.25:2"], ["sphere:r=1", "sphere:r=1,at=5:0:0"]):
            with self.subTest(words):
                page = self.page(*words)
                stages = self.check_page(page, words)
                self.assertTrue(any(word in sentence for sentence in stages["left_out"] for word in ("left out", "not drawn")))
                self.assertIn("left-out", page.texts)
                found = {kind: all_of["count"] for kind, all_of in self.result("study", *words)["coincidences"].items() if all_of["count"]}
                self.assertEqual({kind["kind"]: kind["count"] for kind in stages["coincidences"]}, found)

    def test_ways_out_are_counted_only_where_they_are_known(self):
        for words, subtitle, optima in (
                (["sphere:r=1", "sphere:r=1"], "a continuum of shortest ways out", "every direction"),
                (["capsule:r=1,h=2", "capsule:r=1,h=2"], "a continuum of shortest ways out", "every direction orthogonal to (0, 0, 1)"),
                (["sphere:r=1", "sphere:r=1,at=1:0:0"], "one shortest way out", "1"),
                (["box:half=1:1:1", "sphere:r=1"], "6 shortest ways out", "6"),
                (["cylinder:r=1,h=5", "cylinder:r=1,h=5"], None, None),
                (["cylinder:r=1,h=2", "cone:r=1,h=1,at=0.5:0.25:1"], None, None)):
            with self.subTest(words):
                text = self.page_text(*words)
                page = Page(text)
                self.assertEqual(page.fields.get("optima"), optima)
                self.assertEqual(page.fields["status"], "penetrating")
                if subtitle is None:
                    self.assertIsNone(re.search(r"shortest ways? out", text))
                else:
                    self.assertIn(f"&middot; {subtitle}", text)

    def test_decimals_are_written_as_in_the_text_of_the_answer(self):
        page = self.page("box:half=1:1:1", "box:half=1:1:1,at=1:0:0")
        self.assertEqual((page.fields["depth"], page.fields["unit"]), ("1", "(-1, 0, 0)"))

    def test_files_are_named_without_their_folders(self):
        for command in (["explain", CUBE, ICOSAHEDRON, "-o"], ["depth", CUBE, ICOSAHEDRON, "--svg"], ["study", CUBE, ICOSAHEDRON, "--html"],
                        ["depth", CUBE, ICOSAHEDRON, "--along", "1,0,0", "--svg"]):
            path = self.folder / "page"
            self.answer(*command, path)
            text = path.read_text()
            self.assertIn("cube.off icosahedron.off", text, command)
            self.assertNotIn(str(DATA), text, command)
            self.assertNotIn(str(self.folder), text, command)

    def test_every_case_of_the_catalogue(self):
        cases = [json.loads(line) for line in self.answer("cases", "--catalogue").splitlines()]
        path = self.file("cases.jsonl", self.answer("cases", "--catalogue"))
        for single in cases[::12]:
            with self.subTest(single["id"]):
                page = self.page(path, "--case", single["id"])
                self.check_numbers(page, self.result("depth", "-", stdin=json.dumps(single) + "\n"))

    def test_coincidences_are_those_of_the_study(self):
        for line in (POLYTOPES["same"], POLYTOPES["touching"], POLYTOPES["flat in solid"]):
            page = self.page("-", stdin=line)
            study = self.result("study", "-", stdin=line)
            found = {kind: all_of["count"] for kind, all_of in study["coincidences"].items() if all_of["count"]}
            self.assertEqual({kind["kind"]: kind["count"] for kind in json.loads(page.block("stages"))["coincidences"]}, found)

    def test_a_mesh_that_is_not_convex_is_said_to_be(self):
        dented = "OFF\n5 6 0\n0 0 0\n2 0 0\n0 2 0\n0 0 2\n0.25 0.25 0.25\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 4\n3 2 3 4\n3 3 1 4\n"
        path = self.file("dented.off", dented)
        self.assertIn("A is not convex", self.page_text(path, CUBE))
        self.assertNotIn("is not convex", self.page_text(CUBE, CUBE))
        self.assertIn("not convex", self.refused("explain", path, CUBE, "--require-convex", "-o", self.folder / "none.html"))
        self.assertFalse((self.folder / "none.html").exists())


class Touching(ExplainTest):
    def test_corners_are_those_of_the_answer(self):
        for words in (["box:half=1:1:1", "box:half=1:1:1,at=1.5:0.5:0.25"], [CUBE, ICOSAHEDRON], ["capsule:r=1/4,h=2", "box:half=1:1:1,at=0.5:0.2:1.8"],
                      ["sphere:r=1", "sphere:r=1/2,at=1/2:1/3:1/7"], ["--pieces", DATA / "key.obj", DATA / "comb.obj"]):
            with self.subTest(words):
                text = self.page_text(*words)
                manifold = self.result("depth", "--patch", *words)["manifold"]
                tables = re.findall(r'<div data-patch="(\d+)"[^>]*>(.*?)</table>', text, re.DOTALL)
                self.assertEqual(len(tables), len(manifold["patches"]))
                for (_, table), patch in zip(tables, manifold["patches"]):
                    rows = re.findall(r"<tr>(<th scope=\"row\">.*?)</tr>", table, re.DOTALL)
                    self.assertEqual(len(rows), len(patch["corners"]))
                    for row, corner in zip(rows, patch["corners"]):
                        cells = re.findall(r"<t[dh][^>]*>(.*?)</t[dh]>", row)
                        self.assertEqual([cells[2], cells[4]], [", ".join(map(str, corner[on] or ["-"])) for on in ("on_a", "on_b")])
                        for cell, place in ((cells[1], corner["a"]), (cells[3], corner["b"])):
                            if isinstance(place, list):
                                self.assertEqual(numbers(cell), [float(Fraction(x)) for x in place])
                            else:  # core + distance n/|n|
                                n = [int(x) for x in place["normal"]]
                                length = math.sqrt(sum(x * x for x in n))
                                far = float(Fraction(place["distance"])) / length
                                near = [float(Fraction(c)) + far * x for c, x in zip(place["core"], n)]
                                for shown, true in zip(numbers(cell), near):
                                    self.assertAlmostEqual(shown, true, 14)

    def test_what_is_not_told_is_said(self):
        page = self.page("cylinder:r=1,h=2", "cone:r=1,h=1,at=0.5:0.25:1")
        self.assertEqual((page.fields["patch"], json.loads(page.block("motions"))), ("not told: curved", []))
        self.assertIn("Of curved bodies no motion is followed", page.texts["motion"])

    def test_a_caption_names_what_is_drawn(self):
        for words, green in ((["cylinder:r=1,h=2", "cone:r=1,h=1,at=0.5:0.25:1"], "the arrow."), ([CUBE, ICOSAHEDRON], "the arrow, and where they touch then."),
                             (["box:half=1:1:1", "box:half=1:1:1,at=2:0:0"], "where they touch."),
                             (["sphere:r=1", "sphere:r=1,at=5:0:0"], "the arrow, and where they are nearest.")):
            with self.subTest(words):
                self.assertIn(f'<span class="key-patch">green</span>: {green}</figcaption>', self.page_text(*words))

    def test_a_motion_can_be_repeated(self):
        text = self.page_text("--twist=1,0,1/3,0,0.5,1", CUBE, ICOSAHEDRON)
        self.assertIn("--along=1,0,1/3,0,1/2,1 --steps 40", text)
        self.assertIn("<code>fathom depth --patch --twist --json</code>", text)

    def test_motions_are_curves_of_depth(self):
        """Of each, the block is what `depth` prints of the path, and of the twist."""
        for words, options, steps in (([CUBE, ICOSAHEDRON], [], [10] * 4), ([CUBE, ICOSAHEDRON], ["--twist=1,0,1/3,0,0.5,1"], [40]),
                                      (["sphere:r=1", "box:half=1:1:1,at=3:1:0"], [], [10] * 4), ([CUBE, CUBE], [], [10] * 4),
                                      (["box:half=1:1:1", "box:half=1:1:1,at=2:0:0"], [], [10] * 4)):
            with self.subTest(words=words, options=options):
                page = self.page(*options, *words)
                motions = json.loads(page.block("motions"))
                self.assertEqual([motion["path"]["steps"] for motion in motions], steps)
                for motion in motions:
                    path, zero = motion["path"], ["0"] * 3
                    twist = ",".join(path["along"] + path.get("turn", []))
                    along = self.result("depth", f"--along={twist}", "--steps", path["steps"], *words)
                    self.assertEqual({**path, "id": None}, {**along, "id": None})
                    whole = ",".join(path["along"] + path.get("turn", zero))
                    self.assertEqual(motion["derivative"], self.result("depth", f"--twist={whole}", *words)["derivative"])
                if options:
                    self.assertEqual(json.loads(page.block("depth"))["derivative"], motions[0]["derivative"])
                    self.assertEqual(numbers(page.fields["derivative"]), [motions[0]["derivative"]["value"]])

    def test_motions_of_b(self):
        """Alone it is that of the first body with both exchanged; beside one of A the difference to both."""
        twist, words = "1,0,1/3,0,0.5,1", [CUBE, ICOSAHEDRON]
        [motion] = json.loads(self.page(f"--twist-b={twist}", *words).block("motions"))
        exchanged = self.result("depth", f"--along={twist}", "--steps=40", *reversed(words))
        values = lambda path: [(value["s"], value["signed_depth"]["exact"]) for value in path["values"]]
        self.assertEqual(values(motion["path"]), values(exchanged))
        self.assertEqual(motion["derivative"], self.result("depth", f"--twist-b={twist}", *words)["derivative"])
        self.assertEqual(motion["path"]["along_b"] + motion["path"]["turn_b"], ["1", "0", "1/3", "0", "1/2", "1"])
        page = self.page(f"--twist={twist}", f"--twist-b={twist}", *words)
        [both] = json.loads(page.block("motions"))
        self.assertEqual(both["derivative"]["value"], 0)
        self.assertEqual({exact["root"] for _, exact in values(both["path"])}, {values(both["path"])[0][1]["root"]})
        self.assertIn("A and B move by the twist", page.texts["motion"])

    def test_motions_of_bodies_of_every_size(self):
        """No step is found by a quotient that vanishes or is infinite; and where there is no length, that is said."""
        flat = lambda side, x: [[x, 0, 0], [x, side, 0], [x, 0, side]]
        far = ["1e400", 0, 0]
        for name, a, b, turn in (("huge", box([-8e307] * 3, [8e307] * 3), box([-8e307] * 3, [8e307] * 3), -1),
                                 ("small and far", flat(1e-30, 1e300), flat(1e-30, 1e300), -60),
                                 ("least and far", flat(1e-200, 1e300), flat(1e-200, 1e300), -60),
                                 ("subnormal", scaled(UNIT, 1e-310), scaled(UNIT, 1e-310), -1),
                                 ("beyond", [far, [0, 1, 0], [0, 0, 1]], [far, [0, 1, 0], [0, 0, 1]], None),
                                 ("points", [[0, 0, 0]], [[0, 0, 0]], None)):
            with self.subTest(name):
                page = self.page("-", stdin=case(a, b, id=name))
                motions = json.loads(page.block("motions"))
                turns = [max(abs(Fraction(w)) for w in motion["path"]["turn"]) for motion in motions[1:]]
                self.assertEqual(turns, [Fraction(2) ** turn] * 3 if turn else [])
                self.assertEqual("Bodies without a length that binary64 holds" in page.texts["motion"], turn is None)

    def test_a_turn_about_a_point_contact_does_not_change_the_depth_at_first(self):
        motions = json.loads(self.page("-", stdin=POLYTOPES["point"]).block("motions"))
        self.assertEqual([motion["derivative"]["value"] for motion in motions[1:]], [0, 0, 0])

    def test_large_bodies_are_followed_only_if_asked(self):
        grid = [[x / 16, y / 16, 0] for x in range(33) for y in range(33)]
        line = case(grid, [[x, y, 1 - z] for x, y, z in grid], id="large")
        self.assertEqual(json.loads(self.page("-", stdin=line).block("motions")), [])
        self.assertEqual(len(json.loads(self.page("-", "--twist=0,0,1,0,0,0", stdin=line).block("motions"))), 1)


class Safety(ExplainTest):
    def test_policy_names_what_is_there_and_nothing_else(self):
        page = self.page(CUBE, ICOSAHEDRON)
        policy = next(attributes["content"] for tag, attributes in page.elements
                      if attributes.get("http-equiv") == "Content-Security-Policy")
        scripts = [text for tag, attributes, text in page.raw if tag == "script" and "type" not in attributes]
        styles = [text for tag, _, text in page.raw if tag == "style"]
        self.assertEqual((len(scripts), len(styles)), (1, 1))
        name = lambda text: "'sha256-" + base64.b64encode(hashlib.sha256(text.encode()).digest()).decode() + "'"
        self.assertIn(f"script-src {name(scripts[0])};", policy)
        self.assertIn(f"style-src {name(styles[0])};", policy)
        self.assertTrue(policy.startswith("default-src 'none';"))
        self.assertNotIn("unsafe", policy)

    def test_nothing_is_loaded_from_elsewhere(self):
        page = self.page(CUBE, ICOSAHEDRON)
        for tag, attributes in page.elements:
            self.assertNotIn(tag, ("img", "link", "iframe", "object", "embed", "base", "form"))
            for key, value in attributes.items():
                self.assertFalse(key.startswith("on"), (tag, key))
                self.assertNotEqual(key, "style", tag)
                if key in ("src", "href", "xlink:href", "action"):
                    self.assertTrue(value.startswith("#"), (tag, key, value))
        style = next(text for tag, _, text in page.raw if tag == "style")
        self.assertNotIn("@import", style)
        self.assertFalse(re.search(r"url\((?!#|\"?data:)", style))

    def test_hostile_names_change_nothing(self):
        plain = self.page("-", stdin=case(UNIT, SHIFTED, id="plain"))
        for name in ("</script><script>alert(1)</script>", "<!-- <script>", "\" onclick=\"alert(1)", "{{script}}", "&lt;b&gt;",
                     "a\nb\x1b[31m\u202e", "]]>"):
            with self.subTest(name):
                page = self.page("-", stdin=case(UNIT, SHIFTED, id=name))
                self.assertEqual(page.elements, plain.elements)
                self.assertEqual(json.loads(page.block("depth"))["id"], name)
                self.assertEqual(json.loads(page.block("stages"))["id"], name)
                self.assertEqual(json.loads(page.block("case"))["id"], name)

    def test_same_input_same_bytes(self):
        self.assertEqual(self.page_text(CUBE, ICOSAHEDRON), self.page_text(CUBE, ICOSAHEDRON))
        self.assertNotIn("seconds", json.loads(self.page(CUBE, ICOSAHEDRON).block("stages")))
        timed = self.page(CUBE, ICOSAHEDRON, "--times")
        self.assertTrue(json.loads(timed.block("stages"))["seconds"])


class Input(ExplainTest):
    def test_one_case_needs_no_id(self):
        self.assertEqual(json.loads(self.page("-", stdin=POLYTOPES["shifted"]).block("depth"))["id"], "shifted")
        two = self.file("cases.jsonl", POLYTOPES["shifted"] + POLYTOPES["same"])
        self.assertEqual(json.loads(self.page(two, "--case", "same").block("depth"))["id"], "same")

    def test_version(self):
        self.assertIn(f"fathom {VERSION}", self.page_text(CUBE, CUBE))


if __name__ == "__main__":
    unittest.main()
