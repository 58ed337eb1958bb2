# SPDX-License-Identifier: GPL-3.0-or-later
"""`fathom depth --svg`: pictures that are whole, need nothing else, and say the numbers of the answer."""
import re
import unittest
import xml.etree.ElementTree as ElementTree

from harness import DATA, ROOT, UNIT, CliTest, box, case

CUBE, ICOSAHEDRON = str(DATA / "cube.off"), str(DATA / "icosahedron.off")
SVG = "{http://www.w3.org/2000/svg}"
NUMBER = r"-?\d+(?:\.\d)?"
PATH = re.compile(rf"(M{NUMBER} {NUMBER}(L{NUMBER} {NUMBER})*Z?)+")
BESIDE = box([0.75, 0.25, 0.25], [1.75, 1.25, 1.25])


class Svg(CliTest):
    def answer(self, *arguments, stdin="", **options):
        """stdout of a run that must succeed; options are those of subprocess.run."""
        code, out, err = self.run_cli(*arguments, stdin=stdin, **options)
        self.assertEqual(code, 0, err)
        return out

    def drawn(self, *arguments, stdin=""):
        """The picture of one case, checked."""
        path = self.folder / "out.svg"
        path.unlink(missing_ok=True)
        self.answer("depth", "--svg", path, *arguments, stdin=stdin)
        return self.checked(path)

    def checked(self, path):
        """The root of a picture that keeps the laws of all pictures."""
        text = path.read_text(encoding="utf-8")
        root = ElementTree.fromstring(text)
        self.assertEqual(root.tag, SVG + "svg")
        self.assertEqual(root.get("role"), "img")
        self.assertEqual([child.tag for child in root[:2]], [SVG + "title", SVG + "desc"])
        self.assertEqual(root.get("aria-labelledby").split(), [child.get("id") for child in root[:2]])
        ids = [element.get("id") for element in root.iter() if element.get("id")]
        self.assertEqual(len(ids), len(set(ids)))
        for element in root.iter():
            self.assertNotIn(element.tag, (SVG + "script", SVG + "image", SVG + "use", SVG + "foreignObject"))
            for name, value in element.attrib.items():
                self.assertFalse(name.startswith("on") or "href" in name or name == "style", name)
                for target in re.findall(r"url\((.*?)\)", value):
                    self.assertIn(target.removeprefix("#"), ids)
                self.assertNotRegex(value, r"\b(nan|inf)\b")
            if element.tag == SVG + "path":
                self.assertRegex(element.get("d"), PATH)
                self.assertIsNotNone(PATH.fullmatch(element.get("d")) or element.get("class") == "body-b stripe", element.get("d"))
        self.assertEqual(re.findall(r"\w+://[^\"]*", text), ["http://www.w3.org/2000/svg"])
        self.assertNotIn("@import", text)
        return root

    def of_class(self, root, name):
        return [element for element in root.iter() if name in (element.get("class") or "").split()]

    def says(self, root):
        """The text of the picture, a line for each element."""
        return [element.text for element in root.iter(SVG + "text")]

    def test_the_picture_of_the_readme(self):
        out = self.folder / "way_out.svg"
        self.answer("depth", "--svg", out, "tests/data/cube.off", "tests/data/icosahedron.off", cwd=ROOT)
        self.assertEqual(out.read_bytes(), (ROOT / "docs" / "pictures" / "way_out.svg").read_bytes(),
                         "make it again: ./fathom depth --svg docs/pictures/way_out.svg tests/data/cube.off tests/data/icosahedron.off")

    def test_numbers_are_those_of_the_answer(self):
        path = self.folder / "out.svg"
        depth = self.result("depth", "--svg", path, CUBE, ICOSAHEDRON)
        text = " ".join(self.says(self.checked(path)))
        self.assertIn(f"penetrating: depth {depth['depth']['value']}", text)
        self.assertIn("({}, {}, {})".format(*(f"{x:g}" if x == 0 else repr(x) for x in depth["translation_f64"])), text)
        self.assertIn("edge-facet: points 3 7 of A, 5 10 11 of B", text)
        self.assertIn("A 1 x 1 x 1, B 1.618 x 1.618 x 1.618", text)

    def test_what_is_drawn(self):
        root = self.drawn(CUBE, ICOSAHEDRON)
        for name, count in (("toned body-a", 1), ("hatched", 1), ("hidden", 2), ("wire", 2), ("ghost", 1), ("feature", 2), ("shaft", 1),
                            ("letter", 2), ("bar", 1)):
            with self.subTest(name):
                found = set.intersection(*(set(self.of_class(root, part)) for part in name.split()))
                self.assertEqual(len(found), count)
        self.assertEqual(self.of_class(root, "note"), [])

    def test_without_a_way(self):
        a = self.file("a.xyz", UNIT)
        for b, words in ((box([1, 0, 0], [2, 1, 1]), "touching: depth 0"), (box([3, 0, 0], [4, 1, 1]), "disjoint: distance 2")):
            root = self.drawn(a, self.file("b.xyz", b))
            self.assertIn(words, self.says(root))
            self.assertEqual(len(self.of_class(root, "shaft")), 1 if "disjoint" in words else 0)
            self.assertEqual(len(self.of_class(root, "ghost")), 1 if "disjoint" in words else 0)

    def test_a_short_way_gets_a_close_up(self):
        root = self.drawn(self.file("a.xyz", UNIT), self.file("b.xyz", box([0.999, 0, 0], [2, 1, 1])))
        self.assertEqual(len(root.findall(SVG + "svg")), 2)
        self.assertIn("close-up", self.says(root))

    def test_needles_have_their_axes_scaled_apart(self):
        root = self.drawn(self.file("a.xyz", box([0, 0, 0], [1, 1000, 1])), self.file("b.xyz", box([0.5, 0, 0], [2, 1000, 1])))
        self.assertIn("axes scaled apart", self.says(root))
        self.assertEqual(len(self.of_class(root, "bar")), 2)

    def test_extremes(self):
        huge, tiny = box([0, 0, 0], [1e300, 1e300, 1e300]), box([-1e-300, 0, 0], [1e-300, 1e-300, 1e-300])
        for a, b in ((huge, tiny), (tiny, huge), (huge, huge), (tiny, tiny)):
            root = self.drawn(self.file("a.xyz", a), self.file("b.xyz", b))
            self.assertGreaterEqual(len(self.of_class(root, "body-a")), 2)
            self.assertGreaterEqual(len(self.of_class(root, "body-b")), 2)

    def test_flat_bodies(self):
        point, segment, square = [[0, 0, 0]], [[0, 0, 0], [1, 2, 3]], [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]
        for a in (point, segment, square):
            for b in (point, segment, square, UNIT):
                root = self.drawn(self.file("a.xyz", a), self.file("b.xyz", b))
                self.assertTrue(self.of_class(root, "body-a"))

    def test_every_family_and_the_catalogue(self):
        cases = "".join(self.answer("cases", *words, "--count", "1") for words in
                        [("--family", name) for name in self.families()] + [("--family", name) for name in self.families("--shapes")])
        cases += self.answer("cases", "--catalogue")
        folder = self.folder / "all"
        self.answer("depth", "--svg", folder, "-", stdin=cases)
        self.assertEqual(len(list(folder.iterdir())), cases.count("\n"))
        for path in folder.iterdir():
            with self.subTest(path.name):
                root = self.checked(path)
                for body in ("body-a", "body-b"):
                    self.assertTrue(self.of_class(root, body))
                self.assertLess(path.stat().st_size, 200_000)

    def families(self, *words):
        return re.findall(r"^(\w+)", self.answer("cases", "--list", *words), re.MULTILINE)

    def test_a_stream_fills_a_folder(self):
        folder = self.folder / "pictures"
        stream = case(UNIT, BESIDE, id="one") + case(UNIT, BESIDE, id="a/b") + "{}\n" + case(UNIT, BESIDE)
        code, out, _ = self.run_cli("depth", "--svg", folder, "-", stdin=stream)
        self.assertEqual((code, out.count("\n")), (2, 3))
        self.assertEqual(sorted(path.name for path in folder.iterdir()), ["4.svg", "a%2Fb.svg", "one.svg"])
        self.assertIn("a/b", self.says(self.checked(folder / "a%2Fb.svg")))

    def test_hostile_ids(self):
        folder = self.folder / "pictures"
        self.answer("depth", "--svg", folder, "-", stdin=case(UNIT, BESIDE, id="<script>alert(1)</script>&\"'\u0001\u202e") +
                    case(UNIT, BESIDE, id="long " * 200))
        for path in folder.iterdir():
            self.checked(path)

    def test_the_same_bytes_each_time(self):
        stream = self.answer("cases", "--catalogue")
        for folder, threads in (("one", 1), ("two", 4)):
            self.answer("depth", "--svg", self.folder / folder, "--threads", threads, "-", stdin=stream)
        names = sorted(path.name for path in (self.folder / "one").iterdir())
        self.assertEqual(names, sorted(path.name for path in (self.folder / "two").iterdir()))
        for name in names:
            self.assertEqual((self.folder / "one" / name).read_bytes(), (self.folder / "two" / name).read_bytes(), name)

    def test_beside_a_certificate(self):
        proof, drawing = self.folder / "p.cert", self.folder / "p.svg"
        self.answer("depth", "--certificate", proof, "--svg", drawing, CUBE, ICOSAHEDRON)
        self.assertTrue(proof.read_text().startswith("fathom"))
        self.checked(drawing)

    def test_shapes(self):
        root = self.drawn("sphere:r=1,at=1.5:0:0", "box:half=1:1:1")
        self.assertIn("approximate outlines", self.says(root))
        answer = self.result("depth", "sphere:r=1,at=1.5:0:0", "box:half=1:1:1")
        self.assertIn(f"penetrating: depth {answer['depth']['value']:g}", self.says(root))


if __name__ == "__main__":
    unittest.main()
