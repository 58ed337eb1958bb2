# SPDX-License-Identifier: GPL-3.0-or-later
"""fathom depth --pieces: unions of convex pieces, from OBJ files with groups; the same as text and JSON; bad input."""
import json
import pathlib
import re
import unittest
import xml.etree.ElementTree as ElementTree
from fractions import Fraction

from harness import DATA, ROOT, CliTest, box, changed
from schemas import validator
from terminals import run_on_terminal

VALIDATOR = validator("union")
SVG = "{http://www.w3.org/2000/svg}"
COMB, KEY = str(DATA / "comb.obj"), str(DATA / "key.obj")
FACES = [[1, 3, 4, 2], [5, 6, 8, 7], [1, 2, 6, 5], [3, 7, 8, 4], [1, 5, 7, 3], [2, 4, 8, 6]]


def obj(*boxes, group="o"):
    """Boxes as the tools for convex decomposition write them: a group each, with vertices of its own."""
    text = ""
    for k, (low, high) in enumerate(boxes):
        text += f"{group} convex_{k}\n" + "".join("v {} {} {}\n".format(*p) for p in box(low, high))
        text += "".join("f " + " ".join(str(8 * k + i) for i in face) + "\n" for face in FACES)
    return text


SLOT = obj([[-9, -5, -5], [0, 5, 5]], [[1, -5, -5], [10, 5, 5]])
PLATE = obj([[0.75, -1, -1], [1.75, 1, 1]])


class Pieces(CliTest):
    def pieces(self, a, b, *options):
        return self.result("depth", "--pieces", *options, self.file("a.obj", a), self.file("b.obj", b))

    def refused(self, sentence, *arguments):
        code, out, err = self.run_cli("depth", *arguments)
        self.assertEqual((code, out), (2, ""), err)
        self.assertIn(sentence, err)

    def test_the_schema_has_teeth(self):
        good = self.pieces(PLATE, SLOT)
        for path, value in ((["status"], "inside"), (["complete"], 1), (["optima", 0, "clearance"], "none"),
                            (["optima", 0, "translation", 0], 0.5), (["deepest_pair", "pieces"], [0]), (["extra"], 1)):
            self.assertFalse(VALIDATOR.is_valid(changed(good, path, value)), path)

    def test_an_exact_fit(self):
        found = self.pieces(PLATE, SLOT)
        self.assertEqual((found["status"], found["depth"]["squared"], found["complete"]), ("penetrating", "9/16", True))
        self.assertEqual([o["translation"] for o in found["optima"]], [["-3/4", "0", "0"]])
        self.assertEqual((found["optima"][0]["clearance"], len(found["optima"][0]["contacts"])), (False, 2))
        text = self.answer("depth", "--pieces", "--exact", self.file("a.obj", PLATE), self.file("b.obj", SLOT))
        for line in ("penetrating", "depth         0.75", "depth^2       9/16", "translation   (-3/4, 0, 0)",
                     "clearance     none: an exact fit", "ties          none"):
            self.assertIn(line + "\n", text)

    def test_a_gap_has_clearance(self):
        wide = self.pieces(PLATE, obj([[-9, -5, -5], [0, 5, 5]], [[1.125, -5, -5], [10, 5, 5]]))
        self.assertEqual((wide["depth"]["squared"], wide["optima"][0]["clearance"]), (str(Fraction(25, 64)), True))

    def test_groups_of_any_kind_are_pieces(self):
        expected = self.pieces(PLATE, SLOT)
        for text in (obj([[-9, -5, -5], [0, 5, 5]], [[1, -5, -5], [10, 5, 5]], group="g"), SLOT.replace("o convex_1", "o\ng x y"),
                     "mtllib none.mtl\n" + SLOT.replace("f ", "usemtl m\nf ")):
            self.assertEqual(self.pieces(PLATE, text)["optima"], expected["optima"])
        hull = self.pieces(PLATE, SLOT.replace("o convex_0\n", "").replace("o convex_1\n", ""))
        self.assertEqual(hull["depth"]["squared"], "36", "without groups it is one piece")

    def test_touching_and_disjoint(self):
        touching = self.pieces(PLATE, obj([[1.75, 1, 1], [10, 10, 10]]))
        self.assertEqual((touching["status"], touching["optima"][0]["contacts"][0]["contact"]["kind"]), ("touching", "vertex-vertex"))
        apart = self.pieces(PLATE, obj([[50, 0, 0], [51, 1, 1]], [[3.75, 0, 0], [4, 1, 1]]))
        self.assertEqual((apart["status"], apart["apart"]["distance"]["squared"], apart["apart"]["pieces"]), ("disjoint", "4", [0, 1]))
        self.assertIn("between   piece 0 of A, piece 1 of B\n",
                      self.answer("depth", "--pieces", self.file("a.obj", PLATE),
                                  self.file("b.obj", obj([[50, 0, 0], [51, 1, 1]], [[3.75, 0, 0], [4, 1, 1]]))))

    def test_the_comb_and_the_key(self):
        found = self.result("depth", "--pieces", KEY, COMB)
        squared, pair, hulls = (Fraction(x["squared"]) for x in (found["depth"], found["deepest_pair"]["depth"], found["hulls"]))
        self.assertEqual((pair, squared, hulls), (Fraction(1, 4), Fraction(5, 8), Fraction(9, 4)))
        self.assertEqual([each["translation"] for each in found["optima"]], [["-1/4", "3/4", "0"]])

    def cases(self, *cases):
        return self.file("cases.jsonl", "".join(json.dumps(case) + "\n" for case in cases))

    def test_cases_with_pieces(self):
        piece = lambda low, high: {"vertices": [list(p) for p in box(low, high)]}
        slot = {"pieces": [piece([-9, -5, -5], [0, 5, 5]), piece([1, -5, -5], [10, 5, 5])]}
        plate = piece([0.75, -1, -1], [1.75, 1, 1])
        moved = {"pieces": [{"shape": "box", "half": [0.5, 1, 1], "pose": "xyz=1.25,0,7"}], "pose": "xyz=0,0,-7"}
        path = self.cases({"id": "fit", "a": plate, "b": slot}, {"id": "moved", "a": moved, "b": slot},
                          {"id": "whole", "a": plate, "b": plate},
                          {"id": "apart", "a": moved, "b": {"pieces": [piece([50, 0, 0], [51, 1, 1]), piece([3.75, 0, 0], [4, 1, 1])]}})
        folder = str(self.folder / "proofs")
        lines = [json.loads(line) for line in self.answer("depth", "--json", "--embed-certificate", "--certificate", folder,
                                                          path).splitlines()]
        self.assertEqual([(r["schema"], r["id"], r["depth"]["squared"]) for r in lines],
                         [("fathom/union/1", "fit", "9/16"), ("fathom/union/1", "moved", "9/16"), ("fathom/result/2", "whole", "1"),
                          ("fathom/union/1", "apart", "0")])
        self.assertEqual(lines[0]["optima"], lines[1]["optima"])
        for result, line in zip(lines, self.answer("check", *(f"{folder}/{r['id']}.cert" for r in lines)).splitlines()):
            self.assertIn("VERIFIED " + result["status"], line)
        text = self.answer("depth", path).splitlines()
        self.assertEqual(text[0], "fit: penetrating; depth 0.75; translation (-0.75, 0, 0); an exact fit; deepest pair 0.75")
        self.assertEqual(text[3], "apart: disjoint; depth 0; distance 2")
        one = self.result("depth", "--case", "fit", path)
        self.assertEqual(one["optima"], lines[0]["optima"])

    def test_certificates_of_files(self):
        proof = str(self.folder / "proof.cert")
        found = self.result("depth", "--pieces", "--embed-certificate", "--certificate", proof, KEY, COMB)
        self.assertEqual(found["certificate"], pathlib.Path(proof).read_text())
        self.assertIn("VERIFIED penetrating depth_squared=5/8 optima=1 pieces=3x5 ", self.answer("check", proof))
        self.assertIn("VERIFIED", self.answer("check", "--results", self.file("results.jsonl", json.dumps(found) + "\n")))

    def test_the_picture_of_the_page_on_unions(self):
        out = self.folder / "comb_and_key.svg"
        code, _, err = self.run_cli("depth", "--pieces", "--svg", out, "tests/data/key.obj", "tests/data/comb.obj", cwd=ROOT)
        self.assertEqual(code, 0, err)
        self.assertEqual(out.read_bytes(), (ROOT / "docs" / "pictures" / "comb_and_key.svg").read_bytes(),
                         "make it again: ./fathom depth --pieces --svg docs/pictures/comb_and_key.svg tests/data/key.obj tests/data/comb.obj")

    def test_what_is_drawn(self):
        out = self.folder / "out.svg"
        found = self.result("depth", "--pieces", "--svg", out, KEY, COMB)
        root = ElementTree.fromstring(out.read_text())
        text = " ".join(element.text for element in root.iter(SVG + "text"))
        for words in (f"penetrating: depth {found['depth']['value']}", "translation of A: (-0.25, 0.75, 0)",
                      "piece 1 of A touches piece 1 of B: facet-facet", "deepest pair: 0.5, piece 0 of A and piece 1 of B; hulls: 1.5"):
            self.assertIn(words, text)
        kinds = [element.get("class") for element in root.iter() if element.get("class")]
        for kind in ("ghost", "true shaft", "body-a seam", "body-b seam", "body-a in-contact toned", "body-b in-contact toned"):
            self.assertIn(kind, kinds)

    def test_pictures_of_touching_and_disjoint_bodies(self):
        out = self.folder / "out.svg"
        for b, words in ((obj([[1.75, 1, 1], [10, 10, 10]]), "touching: depth 0"), (obj([[3.75, 0, 0], [4, 1, 1]]), "disjoint: distance 2"),
                         (SLOT, "an exact fit, without clearance")):
            self.pieces(PLATE, b, "--svg", out)
            self.assertIn(words, " ".join(element.text for element in ElementTree.fromstring(out.read_text()).iter(SVG + "text")))
        self.refused("cannot write a picture", "--pieces", "--svg", self.folder, KEY, COMB)

    def test_a_folder_of_files(self):
        """As tools for convex decomposition write them too: a file for each piece."""
        folder = self.folder / "slot"
        folder.mkdir()
        for name, low, high in (("piece_10.obj", [1, -5, -5], [10, 5, 5]), ("piece_9.obj", [-9, -5, -5], [0, 5, 5])):
            (folder / name).write_text(obj([low, high]))
        (folder / "piece_9.mtl").write_text("no mesh")
        expected, found = self.pieces(PLATE, SLOT), self.result("depth", "--pieces", self.file("a.obj", PLATE), folder)
        self.assertEqual((found["depth"], found["optima"], found["deepest_pair"]),
                         (expected["depth"], expected["optima"], expected["deepest_pair"]))
        proof = self.folder / "proof.cert"
        self.answer("depth", "--pieces", "--certificate", proof, folder, str(folder) + "/")
        self.assertIn("VERIFIED penetrating depth_squared=100 optima=4 pieces=2x2 ", self.answer("check", proof))
        (folder / "piece_1.off").write_text("OFF\n4 0 0\n0 0 0\n1 0 0\n0 1 0\n0 0 x\n")
        self.refused("slot/piece_1.off:6: expected a number", "--pieces", folder, KEY)
        empty = self.folder / "empty"
        empty.mkdir()
        self.refused("empty: expected a folder with mesh files (.off, .obj, .ply, .stl), the pieces, found none there", "--pieces", empty,
                     KEY)

    def test_names_with_a_hash(self):
        """They run to the end of their line: pieces of different names are different ones."""
        apart = obj([[-5, -5, -5], [0, 5, 5]], [[3, -5, -5], [8, 5, 5]])
        plate = obj([[1, -1, -1], [2, 1, 1]])
        for names in (("wall#1", "wall#2"), ("wall #1", "wall #2"), ("wall", "wall")):
            text = apart.replace("convex_0", names[0]).replace("convex_1", names[1])
            found = self.pieces(plate, text)
            self.assertEqual((found["status"], found["apart"]["distance"]["squared"]), ("disjoint", "1"), names)

    def test_poses_meshes_and_shapes(self):
        expected = self.pieces(PLATE, SLOT)
        mesh = self.file("plate.xyz", box([0.75, -1, -1], [1.75, 1, 1]))
        slot, moved = self.file("slot.obj", SLOT), self.file("moved.obj", PLATE.replace("v 0.75", "v 7.75").replace("v 1.75", "v 8.75"))
        for a in ([mesh], ["box:half=0.5:1:1,at=1.25:0:0"], ["--pose-a", "xyz=-7,0,0", moved]):
            found = self.result("depth", "--pieces", *a, slot)
            self.assertEqual((found["depth"], found["optima"]), (expected["depth"], expected["optima"]), a)
        self.assertEqual(self.result("depth", "--pieces", "--pose-b=xyz=1/4,0,0", mesh, slot)["depth"]["squared"], "1/4")
        page = self.folder / "page.html"
        self.answer("explain", "--pieces", "--pose-b=xyz=1/4,0,0", mesh, slot, "-o", page)
        self.assertIn("0.5", page.read_text())

    def test_groups_that_are_not_convex(self):
        """Two boxes in one group are taken as their hull, and that is said."""
        merged = SLOT.replace("o convex_1\n", "")
        sentence = "piece 0 of B is not convex: the hull holds 1.06 times its volume, all its points are on the hull"
        a, b = self.file("a.obj", PLATE), self.file("b.obj", merged)
        self.assertIn("hull          " + sentence, self.answer("depth", "--pieces", a, b))
        found = self.result("depth", "--pieces", a, b)
        self.assertEqual((found["hull"]["a"], [dent["piece"] for dent in found["hull"]["b"]]), ([], [0]))
        self.assertIn(sentence, self.run_cli("depth", "--pieces", "--json", a, b)[2])
        self.refused("expected convex meshes, as --require-convex says: " + sentence, "--pieces", "--require-convex", a, b)
        picture, page = self.folder / "out.svg", self.folder / "out.html"
        self.answer("depth", "--pieces", "--svg", picture, a, b)
        self.answer("explain", "--pieces", a, b, "-o", page)
        for written in (picture, page):
            self.assertIn(sentence, written.read_text())
        code, _, err = self.run_cli("explain", "--pieces", "--require-convex", a, b, "-o", page)
        self.assertEqual(code, 2)
        self.assertIn("expected convex meshes", err)
        self.assertEqual(self.pieces(PLATE, SLOT)["hull"], {"a": [], "b": []})

    def test_pieces_of_cases_that_are_not_convex(self):
        dent = {"vertices": [[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4], [1, 1, 1]],
                "faces": [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 4], [2, 3, 4], [3, 1, 4]]}
        plain = {"vertices": [[1, 1, 1], [3, 3, 3], [3, 1, 1], [1, 3, 1]]}
        path = self.cases({"id": "d", "a": {"pieces": [plain, dent]}, "b": plain}, {"id": "e", "a": {"pieces": [plain]}, "b": plain})
        code, out, err = self.run_cli("depth", "--json", path)
        self.assertEqual(code, 0, err)
        self.assertIn("cases.jsonl:1: piece 1 of A is not convex: the hull holds 1.33 times its volume", err)
        first, second = map(json.loads, out.splitlines())
        self.assertEqual((first["hull"]["a"][0]["piece"], "hull" in second), (1, False))
        code, out, err = self.run_cli("depth", "--require-convex", path)
        self.assertEqual((code, out.count("\n")), (2, 1))
        self.assertIn("expected convex meshes, as --require-convex says: piece 1 of A is not convex", err)

    def test_options_that_lines_and_json_obey(self):
        found = self.pieces(PLATE, SLOT, "--digits", "5")
        self.assertEqual(found["depth"]["enclosure"], ["0.75", "0.75"])
        apart = self.pieces(PLATE, obj([[3.75, 0, 0], [4, 1, 1]]), "--digits", "5")
        self.assertEqual(apart["apart"]["distance"]["enclosure"], ["2", "2"])
        path = self.cases({"a": {"pieces": [{"shape": "box", "half": [1, 1, 1]}]}, "b": {"shape": "box", "half": [1, 1, 1]}})
        self.assertIn("; counted ", self.answer("depth", "--counters", path))
        self.assertNotIn("counted", self.answer("depth", path))

    def test_an_interrupt_prints_the_bounds_that_are_proved(self):
        """Of a union in a stream, and of one case of it."""
        path = self.file("cases.jsonl", self.answer("cases", "--family", "clusters", "--size", 300))
        number = rb"([0-9.]+)"
        for words, pattern in (([path], rb"clusters-n300-s1: interrupted; depth at least %s; at most %s\n" % (number, number)),
                               (["--case", "clusters-n300-s1", path], rb"interrupted\nat least +%s\nat most +%s\n" % (number, number))):
            code, out, _ = run_on_terminal("depth", *words, stop_at=b"depth between", columns=160)
            self.assertEqual(code, 130)
            self.assertRegex(out, b"^" + pattern)
            low, high = map(float, re.match(pattern, out).groups())
            self.assertTrue(0 < low <= high, out)


if __name__ == "__main__":
    unittest.main()
