# SPDX-License-Identifier: GPL-3.0-or-later
"""fathom depth --along: one exact continuous curve, the same as text, CSV, JSON and chart."""
import csv
import io
import re
import unittest
import xml.etree.ElementTree as xml
from decimal import Decimal, localcontext
from fractions import Fraction

from harness import DATA, ROOT, CliTest, box

CUBE, ICOSAHEDRON = str(DATA / "cube.off"), str(DATA / "icosahedron.off")
NAME = "{http://www.w3.org/2000/svg}"
# Bodies, and a path that leads through touching: exactly at a step, or between two.
PATHS = [(CUBE, CUBE, "2,0,0", 32), (CUBE, ICOSAHEDRON, "3,1/3,-0.1", 16), (ICOSAHEDRON, CUBE, "-5,-5,-5", 7),
         ("sphere:r=1", "sphere:r=1/2,at=1/2:0:0", "3,0,0", 12), ("capsule:r=1/3,half_length=1", CUBE, "0,0,4", 9)]
# Paths on which A is turned too.
TURNS = [(CUBE, ICOSAHEDRON, "3,1/3,-0.1,1,-1/2,2/3", 9), ("capsule:r=1/3,half_length=1", CUBE, "0,0,0,1,0,0", 5),
         (CUBE, "halfspace:normal=1:2:3,offset=0", "0,0,1,0,0.3,0", 4)]
# Bodies of the plane, which turn by the half-angle s W/2.
KITE, PLATE = (str(ROOT / "examples" / "data" / name) for name in ("kite.txt", "plate.svg"))
PLANE = [(KITE, PLATE, "-4,0", 8), (PLATE, KITE, "1,1/3,1", 5), (KITE, KITE, "0,0,-1/2", 3)]
CURVED = ("cylinder:r=1,half_length=1", "cone:r=1,half_length=1", "3,0,1", 8)


def number(exact):
    """sign * sqrt(root) + plus, to 60 digits."""
    with localcontext() as context:
        context.prec = 60
        root, plus = (Decimal(value.numerator) / Decimal(value.denominator) for value in map(Fraction, (exact["root"], exact["plus"])))
        return exact["sign"] * root.sqrt() + plus


def vector(text):
    return [Fraction(part) for part in text.split(",")]


class Along(CliTest):
    def curve(self, a, b, path, steps, *options):
        return self.result("depth", f"--along={path}", "--steps", steps, *options, a, b)

    def placed(self, a, b, path, share):
        """What `depth` says of A where it is then."""
        move = [part * share for part in vector(path)]
        turn = ",".join(str(part / 2) for part in move[3:] or [0, 0, 0])
        return self.result("depth", "--optima", 1, f"--pose-a=xyz={','.join(map(str, move[:3]))} quat=1,{turn}", a, b)

    def test_obeys_its_schema(self):
        for a, b, path, steps in PATHS + TURNS + [CURVED]:
            found = self.curve(a, b, path, steps)
            self.assertEqual(([value["step"] for value in found["values"]], found["id"]), (list(range(steps + 1)), f"{a} {b}"))
            self.assertEqual([Fraction(value["s"]) for value in found["values"]], [Fraction(i, steps) for i in range(steps + 1)])
            self.assertEqual([Fraction(part) for part in found["along"] + found.get("turn", [])], vector(path))

    def test_each_step_is_the_answer_of_depth(self):
        for a, b, path, steps in PATHS + TURNS + [CURVED]:
            for value in self.curve(a, b, path, steps)["values"]:
                with self.subTest(a=a, b=b, s=value["s"]):
                    single = self.placed(a, b, path, Fraction(value["s"]))
                    for field in ("status", "signed_depth", "direction", "contact"):
                        self.assertEqual(value[field], single[field], field)

    def test_in_the_plane(self):
        for a, b, path, steps in PLANE:
            x, y, w = (vector(path) + [Fraction(0)])[:3]
            found = self.curve(a, b, path, steps)
            self.assertEqual((found["dimension"], found["along"], found.get("turn")), (2, [str(x), str(y)], str(w) if w else None))
            for value in found["values"]:
                single = self.placed(a, b, f"{x},{y},0,0,0,{w}", Fraction(value["s"]))
                for field in ("status", "signed_depth", "direction", "contact"):
                    self.assertEqual(value[field], single[field], field)
            rate = number(self.result("depth", f"--twist={x},{y},{w}", a, b)["derivative"]["rate"]["exact"])
            tiny = ",".join(str(part / 10 ** 12) for part in (x, y, w))
            start, end = [number(value["signed_depth"]["exact"]) for value in self.curve(a, b, tiny, 1)["values"]]
            self.assertLess(abs((end - start) * 10 ** 12 - rate), Decimal("1e-9"), path)
            turned = "turned by the half-angle s/2 " + str(w) + ", then " if w else ""
            self.assertIn(f"{turned}along ({x}, {y})\n", self.answer("depth", f"--along={path}", a, b))

    def test_is_continuous(self):
        for a, b, path, steps in PATHS:
            values = self.curve(a, b, path, steps)["values"]
            stride = Decimal(sum(float(part) ** 2 for part in vector(path))).sqrt() / steps * (1 + Decimal("1e-12"))
            numbers = [number(value["signed_depth"]["exact"]) for value in values]
            for before, after in zip(numbers, numbers[1:]):
                self.assertLessEqual(abs(after - before), stride, "law: A moves by a length, the depth changes by no more")
            for value, exact in zip(values, numbers):
                self.assertEqual((exact > 0) - (exact < 0), {"penetrating": 1, "touching": 0, "disjoint": -1}[value["status"]])
                self.assertEqual(value["value"], float(exact))
                self.assertLessEqual(value["signed_depth"]["low"], value["value"])
                self.assertGreaterEqual(value["signed_depth"]["high"], value["value"])

    def test_sets_out_with_the_velocity_of_the_twist(self):
        for a, b, path, _ in TURNS:
            rate = number(self.result("depth", f"--twist={path}", a, b)["derivative"]["rate"]["exact"])
            tiny = [part / 10 ** 12 for part in vector(path)]
            start, end = [number(value["signed_depth"]["exact"]) for value in self.curve(a, b, ",".join(map(str, tiny)), 1)["values"]]
            self.assertLess(abs((end - start) * 10 ** 12 - rate), Decimal("1e-9"), path)

    def test_through_touching(self):
        values = self.curve(*PATHS[0])["values"]
        self.assertEqual([value["status"] for value in values], ["penetrating"] * 16 + ["touching"] + ["disjoint"] * 16)
        self.assertEqual([value["value"] for value in values], [1 - i / 16 for i in range(33)])
        signs = {value["status"] for value in self.curve(*PATHS[1])["values"]}
        self.assertEqual(signs, {"penetrating", "disjoint"}, "the touching is between two steps")

    def test_swapped_bodies_move_the_other_way(self):
        for a, b, path, steps in PATHS:
            back = ",".join(str(-part) for part in vector(path))
            numbers = [[value["signed_depth"] for value in self.curve(*bodies, steps)["values"]] for bodies in ((a, b, path), (b, a, back))]
            self.assertEqual(*numbers)

    def test_every_method(self):
        expected = [value["signed_depth"] for value in self.curve(*PATHS[1])["values"]]
        for method in ("exact", "naive", "certificate"):
            self.assertEqual([value["signed_depth"] for value in self.curve(*PATHS[1], "--method", method)["values"]], expected)

    def test_bounds_of_curved_bodies(self):
        widths = []
        for bits in (10, 60):
            coaxial, *depths = [value["signed_depth"] for value in self.curve(*CURVED, "--bits", bits)["values"]]
            self.assertEqual(coaxial["exact"], {"sign": 1, "root": "16/5", "plus": "0"})
            self.assertTrue(all(depth["low"] < depth["high"] and "exact" not in depth for depth in depths))
            widths.append(max(depth["high"] - depth["low"] for depth in depths))
        self.assertLess(widths[1], widths[0])


class Forms(CliTest):
    def forms(self, a, b, path, steps, *options):
        """JSON, rows of CSV, lines of text, the chart."""
        arguments = ["depth", f"--along={path}", "--steps", steps, *options, a, b]
        picture = self.folder / "along.svg"
        rows = list(csv.DictReader(io.StringIO(self.answer(*arguments, "--csv", "--svg", picture), newline=""), strict=True))
        return self.result(*arguments), rows, self.answer(*arguments).splitlines(), xml.fromstring(picture.read_bytes())

    def test_agree(self):
        for a, b, path, steps in PATHS + TURNS + [CURVED]:
            found, rows, lines, chart = self.forms(a, b, path, steps)
            values = found["values"]
            titles = [title.text for title in chart.iter(NAME + "title")][1:]
            self.assertEqual((len(rows), len(lines), len(titles)), (steps + 1, steps + 3, steps + 1))
            told = {title.split(":")[0]: title.split(": ")[1].rsplit(", ", 2 if title.count("-") and "," in title else 1)
                    for title in titles}
            for value, row, line in zip(values, rows, lines[2:]):
                depth = value["signed_depth"]
                self.assertEqual((row["step"], row["s"], row["status"]), (str(value["step"]), value["s"], value["status"]))
                self.assertEqual((float(row["low"]), float(row["high"])), (depth["low"], depth["high"]))
                self.assertEqual(row["contact"], value["contact"]["kind"] if value["contact"] else "")
                self.assertEqual(line.split()[:2], [value["s"], value["status"]])
                text = f"[{row['low']}, {row['high']}]" if "exact" not in depth else row["value"]
                self.assertIn(text, line)
                self.assertTrue(any(title.startswith(f"s = {value['s']}: {text}, {value['status']}") for title in titles), (told, text))
                if "exact" in depth:
                    self.assertEqual(float(row["value"]), value["value"])
                    self.assertEqual((int(row["sign"]), row["root"], row["plus"]),
                                     tuple(depth["exact"][key] for key in ("sign", "root", "plus")))
                else:
                    self.assertEqual((value["value"], row["value"], row["sign"], row["root"], row["plus"]), (None, "", "", "", ""))

    def test_a_turn_is_told_before_the_translation_it_comes_before(self):
        _, _, lines, chart = self.forms(CUBE, ICOSAHEDRON, "1,0,0,0,0,2", 1)
        turned = "turned by the quaternion (1, s/2 (0, 0, 2)), then "
        self.assertEqual(lines[0], f"{turned}along (1, 0, 0)")
        self.assertIn(f"A is {turned}moved by s (1, 0, 0)", chart.find(NAME + "desc").text)

    def test_the_chart_is_a_curve(self):
        chart = self.forms(*PATHS[0])[3]
        line = next(path.get("d") for path in chart.iter(NAME + "path") if path.get("class") == "look-0" and path.get("d").startswith("M")
                    and "L" in path.get("d"))
        places = [tuple(map(float, place.split())) for place in re.split("[ML]", line)[1:]]
        self.assertEqual(len(places), 33)
        slopes = [(y1 - y0) / (x1 - x0) for (x0, y0), (x1, y1) in zip(places, places[1:])]
        self.assertLess(max(slopes) - min(slopes), 0.02)
        self.assertEqual((chart.get("role"), chart.get("class")), ("img", "plot"))
        self.assertIn("penetrating from s = 0 to 15/32, touching at s = 1/2, disjoint from s = 17/32 to 1", chart.find(NAME + "desc").text)
        ids = [element.get("id") for element in chart.iter() if element.get("id")]
        self.assertEqual(len(ids), len(set(ids)))

    def test_the_same_bytes_twice(self):
        texts = []
        for name in ("one.svg", "two.svg"):
            out = self.answer("depth", "--along=1,2,3", "--svg", self.folder / name, CUBE, ICOSAHEDRON)
            texts.append((out, (self.folder / name).read_bytes()))
        self.assertEqual(*texts)

    def test_many_steps(self):
        found, rows, _, chart = self.forms(CUBE, CUBE, "2,0,0", 1000)
        self.assertEqual((len(found["values"]), len(rows)), (1001, 1001))
        self.assertLess(len(list(chart.iter(NAME + "title"))), 1100)

    def test_extreme_sizes(self):
        tiny, huge = self.file("tiny.xyz", box([0, 0, 0], [1e-300] * 3)), self.file("huge.xyz", box([0, 0, 0], [1e300] * 3))
        for a, b, path in ((tiny, tiny, "1e-300,0,0"), (huge, huge, "2e300,0,0"), (tiny, huge, "1e300,0,0"), (huge, huge, "1e309,0,0")):
            found, rows, _, chart = self.forms(a, b, path, 4)
            self.assertEqual(len(rows), 5)
            self.assertNotIn("nan", xml.tostring(chart).decode())


if __name__ == "__main__":
    unittest.main()
