# SPDX-License-Identifier: GPL-3.0-or-later
"""fathom study --sweep: the counts of the exact method by size, as text, CSV and chart."""
import csv
import io
import math
import re
import signal
import subprocess
import unittest
import xml.etree.ElementTree as xml

from harness import EXECUTABLE, PATIENCE, CliTest

NAME = "{http://www.w3.org/2000/svg}"
COLUMNS = ["size", "status", "edges_a", "edges_b", "edges", "crossings", "canonical_pairs", "sum", "pairs_evaluated", "blocks_tested",
           "blocks_cleared"]
COUNTS = COLUMNS[5:]


def rows_of(text):
    return list(csv.DictReader(io.StringIO(text, newline=""), strict=True))


def slope(places):
    """Of the line that fits best through the logarithms."""
    logs = [(math.log(x), math.log(y)) for x, y in places if x > 0 and y > 0]
    x, y = (sum(values) / len(logs) for values in zip(*logs))
    return sum((u - x) * (v - y) for u, v in logs) / sum((u - x) ** 2 for u, _ in logs)


class Sweep(CliTest):
    def sweep(self, *options):
        picture = self.folder / "growth.svg"
        rows = rows_of(self.answer("study", "--sweep", *options, "--csv", "--svg", picture))
        return rows, xml.fromstring(picture.read_bytes())

    def test_the_counts_are_those_of_depth(self):
        for family, seed in (("crossed_fans", 1), ("random_sphere", 7), ("random_disjoint", 1)):
            rows, _ = self.sweep(family, "--sizes", "4,10,25", "--seed", seed)
            self.assertEqual(([row["size"] for row in rows], list(rows[0])), (["4", "10", "25"], COLUMNS))
            for row in rows:
                pair = self.answer("cases", "--family", family, "--size", row["size"], "--seed", seed)
                single = self.result("depth", "--method", "exact", "--counters", "-", stdin=pair)
                counts = single["counters"]
                self.assertEqual(row["status"], single["status"])
                expected = {"edges": counts["edges_a"] + counts["edges_b"], "sum": counts["sum_a"] + counts["sum_b"],
                            "blocks_tested": counts["block_tests"],
                            "blocks_cleared": counts["vertex_clears"] + counts["frame_clears"] + counts["wide_clears"]}
                for column in COLUMNS[2:]:
                    self.assertEqual(int(row[column]), expected.get(column, counts.get(column)), column)

    def test_sizes(self):
        for sizes, expected in (("10..100", [10, 20, 50, 100]), ("7..60", [7, 10, 20, 50, 60]), ("5..5", [5]), ("3,4,9", [3, 4, 9]),
                                ("12", [12])):
            self.assertEqual([int(row["size"]) for row in self.sweep("random_lattice", "--sizes", sizes)[0]], expected)

    def test_text_and_chart_agree_with_csv(self):
        options = ["crossed_fans", "--sizes", "4..40"]
        rows, chart = self.sweep(*options)
        lines = self.answer("study", "--sweep", *options).splitlines()
        self.assertEqual(len(lines), len(rows) + 3)
        for row, line in zip(rows, lines[2:]):
            self.assertEqual(line.split(), [row[column] for column in COLUMNS if column not in ("edges_a", "edges_b")])
        titles = [title.text for title in chart.iter(NAME + "title")][1:]
        for column in COUNTS:
            drawn = [row for row in rows if row[column] != "0"]
            for row in drawn:
                self.assertIn(f"size {row['size']}, {row['edges']} edges: {row[column]}", titles, column)
        legend = [text.text for text in chart.iter(NAME + "text") if "(m + n)^" in text.text]
        growth = lines[-1].split()[-len(COUNTS):]
        self.assertTrue(lines[-1].startswith("growth"))
        for column, exponent in zip(COUNTS, growth):
            if exponent == "-":
                continue
            places = [(int(row["edges"]), int(row[column])) for row in rows]
            self.assertAlmostEqual(float(exponent), slope(places), delta=0.006)
            self.assertIn(f"^{exponent}", " ".join(legend))
        self.assertIn("crossings: (m + n)^", " ".join(legend))

    def test_crossed_fans_have_quadratic_crossings(self):
        line = self.answer("study", "--sweep", "crossed_fans", "--sizes", "20,50,100,200").splitlines()[-1]
        crossings, _, total = (float(text) for text in line.split()[-6:-3])
        self.assertAlmostEqual(crossings, 2, delta=0.15)
        self.assertLess(total, 1.5)

    def test_the_chart_is_well_made(self):
        _, chart = self.sweep("random_ball", "--sizes", "5..50", "--times")
        self.assertEqual((chart.get("role"), chart.get("aria-labelledby")), ("img", "sweep-t sweep-d"))
        ids = [element.get("id") for element in chart.iter() if element.get("id")]
        self.assertEqual((len(ids), ids[:2]), (len(set(ids)), ["sweep-t", "sweep-d"]))
        self.assertIn("Time", [text.text for text in chart.iter(NAME + "text")])

    def test_times_only_on_demand(self):
        rows, chart = self.sweep("random_ball", "--sizes", "5,10", "--times")
        self.assertEqual(list(rows[0]), COLUMNS + ["seconds"])
        self.assertTrue(all(float(row["seconds"]) > 0 for row in rows))
        rows, chart = self.sweep("random_ball", "--sizes", "5,10")
        self.assertNotIn("seconds", " ".join(text.text for text in chart.iter(NAME + "text")))

    def test_the_same_bytes_twice(self):
        texts = []
        for name in ("one.svg", "two.svg"):
            out = self.answer("study", "--sweep", "random_ball", "--sizes", "5..50", "--svg", self.folder / name)
            texts.append((out, (self.folder / name).read_bytes()))
        self.assertEqual(*texts)

    def test_an_interrupt_keeps_what_is_done(self):
        picture = self.folder / "part.svg"
        run = subprocess.Popen([EXECUTABLE, "study", "--sweep", "random_sphere", "--sizes", "5,10,900000", "--csv", "--svg", picture],
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        lines = [run.stdout.readline() for _ in range(3)]
        run.send_signal(signal.SIGINT)
        out, err = run.communicate(timeout=PATIENCE)
        self.assertEqual((run.returncode, out), (130, ""), err)
        self.assertIn("interrupted", err)
        self.assertEqual([line.split(",")[0] for line in lines], ["size", "5", "10"])
        if "after 2 of 3 sizes" in err:  # else the work had no good moment to stop within its second
            self.assertIn("of 2 sizes", xml.parse(picture).getroot().find(NAME + "desc").text)


class Misuse(CliTest):
    def test_the_nearest_families_are_some_that_are_taken(self):
        taken = {line.split()[0] for line in self.answer("cases", "--list").splitlines()}
        nearest = re.search(r"nearest: ([^;]+);", self.refused("study", "--sweep", "cubes")).group(1).split(", ")
        self.assertLessEqual(set(nearest), taken, "no family of shapes, which would be refused")


if __name__ == "__main__":
    unittest.main()
