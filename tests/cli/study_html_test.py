# SPDX-License-Identifier: GPL-3.0-or-later
"""fathom study --html: every number of the page is that of --json, every picture has something in it, and nothing is asked of elsewhere."""
import html.parser
import json
import unittest
import xml.etree.ElementTree

from harness import DATA, UNIT, CliTest, box, case

CUBE, ICOSAHEDRON = str(DATA / "cube.off"), str(DATA / "icosahedron.off")
SQUARE = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]
SHIFTED = box([0.75, 0.25, 0.125], [1.75, 1.25, 1.125])
HOSTILE = "<script>alert(1)</script>&\"'\x1b]]>"
CASES = [case(UNIT, SHIFTED, id=HOSTILE), case(UNIT, UNIT, id="same"), case(UNIT, box([1, 0, 0], [2, 1, 1]), id="touching"),
         case(UNIT, box([2, 0, 0], [3, 1, 1]), id="apart"), case(SQUARE, SQUARE, id="flat"), case([[0, 0, 0]], UNIT, id="point")]
BAD = '{"id": "cut", "a": {}}\n'
BALL, CAPSULE = {"shape": "sphere", "radius": 1}, {"shape": "capsule", "half_length": 1, "radius": 0.5}
VOID = {"meta", "input", "br"}


class Element:
    def __init__(self, tag, attributes):
        self.tag, self.attributes, self.children, self.text = tag, attributes, [], ""
        self.inside = []  # texts and elements, in order

    def all(self, tag=None, **attributes):
        """What is below, in order."""
        wanted = {name.replace("_", "-"): value for name, value in attributes.items()}
        for child in self.children:
            if tag in (None, child.tag) and wanted.items() <= child.attributes.items():
                yield child
            yield from child.all(tag, **attributes)

    def words(self):
        return " ".join(" ".join(piece if isinstance(piece, str) else piece.words() for piece in self.inside).split())


class Reader(html.parser.HTMLParser):
    """A page as a browser's parser reads it."""

    def __init__(self, text):
        super().__init__()
        self.root = Element("", {})
        self.path = [self.root]
        self.feed(text)
        self.close()
        assert len(self.path) == 1, self.path[-1].tag

    def handle_starttag(self, tag, attrs):
        element = Element(tag, dict(attrs))
        self.add(element)
        if tag not in VOID:
            self.path.append(element)

    def handle_startendtag(self, tag, attrs):
        self.add(Element(tag, dict(attrs)))

    def handle_endtag(self, tag):
        assert self.path.pop().tag == tag

    def handle_data(self, data):
        self.path[-1].text += data
        self.path[-1].inside.append(data)

    def add(self, element):
        self.path[-1].children.append(element)
        self.path[-1].inside.append(element)


def spoken(name):
    words = name.replace("_", " ")
    return words[:-1] + words[-1].upper() if words.endswith((" of a", " of b")) else words


def rows(table):
    return [[cell.words() for cell in row.children] for row in next(table.all("tbody")).all("tr")]


class Pages(CliTest):
    def page(self, *arguments, code=0, stdin=""):
        """The page's root, and what --json says beside it."""
        path = self.folder / "page.html"
        got, out, err = self.run_cli("study", "--json", "--html", path, *arguments, stdin=stdin)
        self.assertEqual(got, code, err)
        text = path.read_text(encoding="utf-8")
        xml.etree.ElementTree.fromstring(text.split("\n", 1)[1])  # well-formed as XML too
        root = Reader(text).root
        self.check(root, text)
        return root, [json.loads(line) for line in out.splitlines()]

    def check(self, root, text):
        policy = next(root.all("meta", http_equiv="Content-Security-Policy")).attributes["content"]
        self.assertTrue(policy.startswith("default-src 'none'; script-src 'sha256-"), policy)
        for elsewhere in ("http:", "https:", "//www", "@import"):
            self.assertFalse(elsewhere in text, elsewhere)
        self.assertEqual(text.count("url("), text.count("url(#"))
        self.assertEqual(len(list(root.all("script"))), 1)
        ids = [element.attributes["id"] for element in root.all() if "id" in element.attributes]
        self.assertEqual(len(ids), len(set(ids)))
        for element in root.all():
            self.assertEqual({"src", "style"} & set(element.attributes), set())
            self.assertEqual([name for name in element.attributes if name.startswith("on")], [])
            for name in ("href", "data-of", "data-lights"):
                for word in element.attributes.get(name, "").split():
                    self.assertIn(word.lstrip("#"), ids, name)
        for picture in root.all("svg"):
            shapes = [element for element in picture.all() if element.tag in ("path", "circle", "rect")]
            self.assertGreater(len(shapes), 0)
            for path in picture.all("path"):
                self.assertTrue(path.attributes["d"].startswith("M"), path.attributes)

    def compare(self, part, study):
        """The tables of one case and its JSON."""
        table = next(part.all(aria_label="What the perturbation decided"))
        self.assertEqual(rows(table), [[spoken(name), *(str(found[field]) for field in ("calls", "exact", "zero")),
                                        ", ".join(f"{decision['name']}: {decision['count']}" for decision in found["decided_by"])]
                                       for name, found in study["predicates"].items()])
        counts = {spoken(kind): found["count"] for kind, found in study["coincidences"].items()}
        legend = {next(item.all("a")).text: int(next(item.all("b")).text) for item in next(part.all("ul"), Element("", {})).all("li")}
        self.assertEqual(legend, {kind: count for kind, count in counts.items() if count})
        listed = [(spoken(kind), k + 1, one["a"], one["b"]) for kind, found in study["coincidences"].items()
                  for k, one in enumerate(found["listed"])]
        shown = [[row.children[0].words(), row.children[1].words(), *([link.text for link in cell.all("a")] for cell in row.children[2:])]
                 for row in next(next(part.all(aria_label="Coincidences")).all("tbody")).all("tr")] if listed else []
        self.assertEqual(shown, [[kind, str(k), *([" ".join(map(str, feature)) for feature in features] for features in (a, b))]
                                 for kind, k, a, b in listed])
        for row in part.all("tr"):
            if "data-lights" in row.attributes:
                marks = [next(part.all(id=mark)) for mark in row.attributes["data-lights"].split()]
                self.assertEqual(len(marks), len(list(row.all("a"))))
                for mark in marks:
                    self.assertIn("mark", mark.attributes["class"].split())

    def facts(self, part):
        listed = next(part.all("dl")).children
        return {what.text: said.words() for what, said in zip(listed[::2], listed[1::2])}

    def test_two_meshes(self):
        root, (study,) = self.page("--all", CUBE, ICOSAHEDRON)
        self.compare(root, study)
        facts = self.facts(root)
        self.assertEqual((facts["status"], facts["depth^2"], facts["optima"]), (study["status"], study["squared"], str(study["optima"])))
        self.assertEqual(facts["A"], "8 vertices, 12 edges, 6 facets")
        self.assertEqual(len(list(root.all("details", open="open"))), 0)
        self.assertIn("--html page.html", next(root.all("footer")).words())

    def test_a_stream(self):
        root, studies = self.page("-", stdin="".join(CASES) + BAD, code=2)
        parts = [part for part in next(root.all(id="list")).children if part.tag == "details"]
        self.assertEqual(len(parts), len(CASES))
        for part, study in zip(parts, studies):
            self.assertNotIn("open", part.attributes)
            self.assertEqual(part.attributes["data-kind"], study["status"])
            self.compare(part, study)
            self.assertGreaterEqual(len(list(part.all("svg"))), 1)
            copied = json.loads(next(part.all("pre")).text)
            self.assertEqual(copied["id"], study["id"])
        self.assertEqual([len(list(part.all("script"))) for part in parts], [0] * len(CASES))
        kinds = list(studies[0]["coincidences"])
        totals = {kind: [sum(study["coincidences"][kind]["count"] > 0 for study in studies[:-1]),
                         sum(study["coincidences"][kind]["count"] for study in studies[:-1])] for kind in kinds}
        self.assertEqual(rows(next(root.all(aria_label="Coincidences of all cases"))),
                         [[spoken(kind), str(cases), str(count)] for kind, (cases, count) in totals.items() if cases])
        self.assertEqual(next(root.all("p")).text, f"{len(CASES)} cases, 1 error")
        self.assertIn(":7: ", [item.text for item in root.all("li")][-1])
        bar = {item.text.strip(): int(next(item.all("b")).text) for item in next(root.all("ul")).all("li")}
        statuses = [study["status"] for study in studies[:-1]]
        self.assertEqual(bar, {status: statuses.count(status) for status in set(statuses)})

    def test_shapes(self):
        root, studies = self.page("-", stdin="".join(json.dumps({"id": str(i), "a": a, "b": b}) + "\n" for i, (a, b) in enumerate(
            [(BALL, BALL), (CAPSULE, BALL), (CAPSULE, {"vertices": UNIT})])))
        for part, study in zip(next(root.all(id="list")).children, studies):
            table = list(part.all(aria_label="Coincidences"))
            listed = [[spoken(kind), str(k + 1)] for kind, found in study["coincidences"].items()
                      for k in range(len(found["listed"]))]
            self.assertEqual([row[:2] for row in rows(table[0])] if listed else [], listed)
            self.assertGreaterEqual(len(list(part.all("svg"))), 1)

    def test_no_word_of_the_page_goes_to_standard_output(self):
        alone = self.answer("study", CUBE, CUBE)
        self.assertEqual(self.answer("study", "--html", self.folder / "page.html", CUBE, CUBE), alone)

    def test_the_same_bytes_with_any_number_of_threads(self):
        texts = []
        for threads in ("1", "4"):
            path = self.folder / f"page{threads}.html"
            self.run_cli("study", "--threads", threads, "--html", path, DATA / "real_cases.jsonl")
            texts.append(path.read_text().split("<footer>")[0])
        self.assertEqual(*texts)

    def test_where_it_cannot_write(self):
        code, out, err = self.run_cli("study", "--html", self.folder / "none" / "page.html", CUBE, CUBE)
        self.assertEqual((code, out), (2, ""))
        self.assertIn("none/page.html: cannot write a page: No such file or directory", err)
        code, _, err = self.run_cli("study", "--html", "/dev/full", CUBE, CUBE)
        self.assertEqual(code, 3, err)
        self.assertIn("/dev/full: cannot write the page: No space left", err)


if __name__ == "__main__":
    unittest.main()
