# SPDX-License-Identifier: GPL-3.0-or-later
"""fathom stages --svg: the charts as a picture; that of docs/pictures is made by the command on docs/algorithm.md."""
import re
import unittest
import xml.etree.ElementTree as xml

from harness import DATA, ROOT, UNIT, CliTest, box, case

NAME = "{http://www.w3.org/2000/svg}"
CUBE, ICOSAHEDRON = str(DATA / "cube.off"), str(DATA / "icosahedron.off")
SHIFTED = box([0.75, 0.25, 0.125], [1.75, 1.25, 1.125])


class Charts(CliTest):
    def test_the_picture_in_the_manual(self):
        page = (ROOT / "docs" / "algorithm.md").read_text()
        family, size, name = re.search(r"fathom cases --family (\w+) --size (\d+) \|\s*> ./fathom stages --case (\S+)", page).groups()
        picture = self.folder / "charts.svg"
        stream = self.answer("cases", "--family", family, "--size", size)
        self.answer("stages", "--case", name, "--svg", picture, "-", stdin=stream)
        self.assertEqual(picture.read_bytes(), (ROOT / "docs" / "pictures" / "charts.svg").read_bytes(),
                         "make it again by the command on that page")

    def test_lights_the_pair_with_the_optimum(self):
        picture = self.folder / "charts.svg"
        self.answer("stages", "--svg", picture, CUBE, ICOSAHEDRON)
        chart = xml.parse(picture).getroot()
        stages = self.result("stages", CUBE, ICOSAHEDRON)
        lit = [0, 0]
        for i, _ in enumerate(stages["charts"]):
            pairs = [pair for pair in stages["pairs"] if pair["chart"] == i]
            winner = stages["winner"]["pair"]
            shown = stages["pairs"][winner] if winner is not None and stages["pairs"][winner]["chart"] == i else \
                max(pairs, key=lambda pair: len(pair["a"]) * len(pair["b"]))
            lit = [count + len(shown[body]) for count, body in zip(lit, "ab")]
        found = [sum(1 for path in chart.iter(NAME + "path") if path.get("class") == f"arc of-{body} lit") - 1 for body in "ab"]
        self.assertEqual(found, lit, "one element for each arc, and one in the legend")
        ids = [element.get("id") for element in chart.iter() if element.get("id")]
        self.assertEqual((len(ids), chart.get("role")), (len(set(ids)), "img"))
        texts = {text.text for text in chart.iter(NAME + "text")}
        self.assertLessEqual({"-90°", "0°", "90°", "longitude", "latitude", "Upper hemisphere", "Lower hemisphere"}, texts)

    def test_a_folder_for_a_stream(self):
        stream = case(UNIT, SHIFTED, id="one") + case(UNIT, UNIT, id="two") + "{}\n"
        code, out, _ = self.run_cli("stages", "--json", "--svg", self.folder / "charts", "-", stdin=stream)
        self.assertEqual((code, out.count("\n")), (2, 3))
        self.assertEqual(sorted(path.name for path in (self.folder / "charts").iterdir()), ["one.svg", "two.svg"])
        single = self.folder / "single.svg"
        self.answer("stages", "--case", "two", "--svg", single, "-", stdin=stream)
        self.assertEqual(single.read_bytes(), (self.folder / "charts" / "two.svg").read_bytes())


if __name__ == "__main__":
    unittest.main()
