#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every limit of verify/check/FORMAT.md, section 8: at the limit a text is refused for what it says, one beyond it is malformed, and on
the line that the page names; by every checker.

limits.py [--heavy] --checker COMMAND [--checker COMMAND]..     a checker takes - for standard input; --heavy: the texts of a gigabyte
                                                                instead
"""
import argparse
import functools
import re
import shlex
import subprocess
import sys
from fractions import Fraction
from math import lcm

getattr(sys, "set_int_max_str_digits", int)(0)
LINE, DIGITS, BYTES, NUMBERS, SIZE, WORK = 2**24, 10**5, 10**9, 10**7, 4 * 10**9, 10**14


fraction = functools.cache(Fraction)  # of a text: some have 100,000 digits, and stand in every text that is tried


def numbers_of(rows, first=0):
    return [fraction(word) for row in set(rows) for word in row.split(" ")[first:]]


def bits(n):
    return len(format(abs(n), "b").lstrip("0"))


def width(fractions):
    return bits(lcm(*{x.denominator for x in fractions})) + max((bits(x.numerator) for x in fractions), default=0)


def cost(s, t):
    return (256 + max(s, t)) * (256 + min(s, t, 4000))


class Certificate:
    def within(self):
        size, work = self.size_and_work()
        return size <= SIZE and work <= WORK


class Text(Certificate):
    """A certificate that claims something and proves nothing: its first direction is zero, so a checker may stop there."""

    def __init__(self, a, b, claim, directions, vertices=(), facets=(), weights_a=(), weights_b=()):
        self.a, self.b, self.claim, self.directions, self.vertices, self.facets = a, b, claim, directions, vertices, facets
        self.weights = [weights_a, weights_b]

    def lines(self):
        yield "fathom-certificate 1"
        for name, rows in (("a", self.a), ("b", self.b)):
            yield f"{name} {len(rows)}"
            yield from rows
        yield f"claim {self.claim}"
        yield f"directions {len(self.directions)} some"
        yield from self.directions
        last = {"touching": [("weights_a", self.weights[0]), ("weights_b", self.weights[1])], "disjoint": []}
        last = last.get(self.claim, [("vertices", self.vertices), ("facets", self.facets)])
        for name, rows in last:
            yield f"{name} {len(rows)}"
            yield from rows
        counts = [len(rows) for _, rows in last] or [0, 0]
        yield f"end {len(self.a)} {len(self.b)} {len(self.directions)} {counts[0]} {counts[1]}"

    def size_and_work(self):
        """The page's formulas, from the page's definitions."""
        n, v, k, f = len(self.a) + len(self.b), len(self.vertices), len(self.directions), len(self.facets)
        total = len(self.weights[0]) + len(self.weights[1])
        t = sum((len(row.split(" ")) - 1)**2 for row in self.facets)
        w = width(numbers_of(self.a) + numbers_of(self.b))
        x = width(numbers_of(self.weights[0], 1) + numbers_of(self.weights[1], 1))
        u = max(bits(int(m)) for m in numbers_of(self.directions))
        z = max((max(bits(q.numerator), bits(q.denominator)) for q in numbers_of([self.claim], 1)), default=0)
        work = n * k * cost(w, u) + (n + 4 * t) * cost(w, w) + 4 * (k + f) * cost(w, z) + 4 * total * cost(w + x, w + x)
        return (n + v + 3 * f) * w + total * x, work


class Second(Certificate):
    """The same of format 2: A is points or a shape, a list of terms, each a list of atoms; B is points. `parts` are what the claim demands
    behind the directions, by name."""

    def __init__(self, a, b, claim, directions, parts, radius="0"):
        self.a, self.b, self.claim, self.directions, self.parts, self.radius = a, b, claim, directions, parts, radius
        self.shape = isinstance(a[0], list)

    def lines(self):
        counts = []

        def part(name, rows, more=""):
            counts.append(len(rows))
            return [f"{name} {len(rows)}{more}", *rows]

        yield "fathom-certificate 2"
        if self.shape:
            counts.append(len(self.a))
            yield f"shape_a {len(self.a)}"
            for term in self.a:
                yield from part("term", term)
        else:
            yield from part("a", self.a)
        yield f"radius_a {self.radius}"
        yield from part("b", self.b)
        yield f"claim {self.claim}"
        yield from part("directions", self.directions, " some")
        for name, rows in self.parts.items():
            yield from part(name, rows)
        yield "end " + " ".join(map(str, counts))

    def size_and_work(self):
        """The page's formulas, from the page's definitions."""
        parts = {name: self.parts.get(name, []) for name in ("heights_a", "inner_a", "vertices", "facets", "weights_a", "weights_b",
                                                             "lineality",
                                                              "rays", "differences")}
        atoms = [atom for term in self.a for atom in term] if self.shape else []
        coordinates = numbers_of(atoms, 1) + numbers_of(self.b) + ([] if self.shape else numbers_of(self.a))
        n = len(self.b) + (sum(len(atom.split(" ")) // 3 for atom in atoms) if self.shape else len(self.a))
        i, parameters = len(parts["inner_a"]) * len(self.a), []
        for row in set(parts["inner_a"]):
            parameters += [Fraction(word) for k, word in enumerate(row.split(" ")) if k % 4]
        v, f, e, j, r = (len(parts[name]) for name in ("vertices", "facets", "differences", "heights_a", "rays"))
        k = len(self.directions) + r + 2 * len(parts["lineality"])
        t = sum((len(row.split(" ")) - 1)**2 for row in parts["facets"])
        weights = parts["weights_a"] + parts["weights_b"]
        wide = width(coordinates) + (width(parameters) if i else 0)
        x, g = width(numbers_of(weights, 1)), width(numbers_of(parts["heights_a"]))
        u = max(bits(int(m)) for m in numbers_of(self.directions + parts["rays"] + parts["lineality"]))
        claimed = numbers_of([self.claim], 1) + [Fraction(self.radius), Fraction(0)]
        b = 2 * sum(bits(q.numerator) + bits(q.denominator) for q in claimed)
        work = (n + i) * k * cost(wide, u) + (n + 4 * i + 4 * t) * cost(wide, wide) + 4 * (k + f) * cost(wide, b)
        work += 4 * len(weights) * cost(wide + x, wide + x) + (4 * n * cost(wide + u + g, wide + u + g) if j else 0)
        work += e * (r + e) * cost(wide + u, wide + u)
        return (n + i + v + 3 * f + e) * wide + len(weights) * x + j * g, work


ZERO, POINT = "0 0 0", ["0 0 0"]


def most(made, least, beyond):
    """The largest number for which the text made of it is within the limits."""
    assert made(least).within() and not made(beyond).within()
    while beyond - least > 1:
        middle = (least + beyond) // 2
        least, beyond = (middle, beyond) if made(middle).within() else (least, middle)
    return least


def pair(name, made, least, beyond):
    """At the limit and beyond it, by size or work."""
    count = most(made, least, beyond)
    yield f"{name}, {count}", list(made(count).lines()), None
    text = list(made(count + 1).lines())
    yield f"{name}, {count + 1}", text, len(text)


def digits():
    nines = "9" * DIGITS
    for number, line in ((nines, None), ("-" + nines, None), (f"-{nines}/{nines}", None), ("0" + nines, 3), ("-0" + nines, 3),
                         ("1/0" + nines, 3)):
        yield f"{len(number)} characters of digits", list(Text([f"0 0 {number}"], POINT, "disjoint", [ZERO]).lines()), line
    lines = list(Text(POINT, POINT, "depth 1", [ZERO], ["0 0"], ["1 2"]).lines())
    for number, line in enumerate(lines[1:], 2):  # indices, counts, bounds: the last digit of each line, with zeros in front of it
        at = re.search(r"[0-9](?=\D*$)", line).start()
        for zeros in (DIGITS - 1, DIGITS):
            text = lines[:number - 1] + [line[:at] + "0" * zeros + line[at:]] + lines[number:]
            yield f"{zeros} zeros before {line!r}", text, number if zeros == DIGITS else None


def long_lines():
    text = list(Text(POINT, POINT, "disjoint", [ZERO]).lines())
    for length, line in ((LINE, None), (LINE + 1, 4)):
        yield f"a comment of {length} bytes", text[:3] + ["#" + " " * (length - 1)] + text[3:], line
        yield f"an id of {length} bytes", text[:1] + ["id " + "x" * (length - 3)] + text[1:], 2 if line else None
    yield "a long line that looks like a header", [text[0], "fathom-certificate 1".ljust(LINE + 1), *text[1:]], 2


def numbers():
    corners, before = 30, 9  # a few of them per facet: the work for a facet grows with their square
    rows = ["%d %s" % (corners, " ".join("0" * corners))] * ((NUMBERS - before) // (corners + 1))
    left = NUMBERS - before - len(rows) * (corners + 1)
    for more in (0, 1):
        last = ["%d %s" % (left + more - 1, " ".join("0" * (left + more - 1)))]
        text = list(Text(POINT, POINT, "depth 1", [ZERO], [], rows + last).lines())
        yield f"{NUMBERS + more} numbers", text, len(text) - 1 if more else None


def bytes_of_lines():
    """Indices with zeros in front. Comments do not count."""
    corners = 160
    row = f"{corners} " + " ".join(["0" * DIGITS] * corners)
    text = list(Text(POINT, POINT, "depth 1", [ZERO], [], [row] * ((BYTES - LINE) // len(row)) + ["1 0"] * 400).lines())
    text[7:7] = ["#" + "x" * 1000] * 1000
    missing = BYTES - sum(len(line) for line in text if line[0] != "#")
    for k in range(400):  # spread over the last lines
        text[-2 - k] = "1 " + "0" * (1 + missing // 400 + (k < missing % 400))
    yield f"{BYTES} bytes", text, None
    yield f"{BYTES + 1} bytes", text[:-1] + [text[-1].replace("end ", "end 0")], len(text)


def sizes():
    wide = [f"0 0 {2**319_998}"]
    yield from pair("vertices", lambda k: Text(wide, POINT, "depth 1", [ZERO], ["0 0"] * k), 12_000, 13_000)
    yield from pair("facets", lambda k: Text(wide, POINT, "depth 1", [ZERO], ["0 0"] * 5, ["2 0 0"] * k), 4_000, 5_000)
    yield from pair("points", lambda k: Text(wide + ["1/3 2/6 -1/5"] * k, POINT, "disjoint", [ZERO]), 12_000, 13_000)
    unlike = [f"1/{3 * 2**100_000} 5/{5**40_000} {7 * 2**90_000}/{7 * 2**50_000}"]
    yield from pair("denominators", lambda k: Text(unlike, POINT, "depth 1", [ZERO], ["0 0"] * k), 1_000, 40_000)
    weights = [f"0 {2**150_000}/{3**100_000}", f"0 1/{5**60_000}"]
    yield from pair("weights", lambda k: Text(POINT, POINT, "touching", [ZERO], (), (), weights, ["0 -7/9"] * k), 100, 100_000)


def works():
    points = [f"1/3 {2**100 - 1} -{2**70}/5"] * 30_000  # about as many as what is counted beside them, so that texts are short
    yield from pair("directions", lambda k: Text(points, POINT, "disjoint", [ZERO, f"1 -{2**40} 1"] + ["1 0 0"] * k), 1_000, 900_000)
    claim = f"bounds {7**20_000}/{3**1000} {11**9_000}/{2**4_000}"
    facets = ["0"] + ["%d %s" % (k, " ".join("0" * k)) for k in (3, 4, 90, 2)]
    wide = points[:3_000] + [f"{2**4_000} 0 0"]
    yield from pair("facets", lambda k: Text(wide, POINT, claim, [ZERO, "5 -9 1"], ["0 0"], facets + ["1 0"] * k), 1_000, 900_000)
    yield from pair("corners", lambda k: Text(POINT, POINT, "depth 1", [ZERO], [], [f"{k} " + " ".join("0" * k)]), 10_000, 30_000)
    weights = [f"0 {k}/{2**9_000 * 3**k}" for k in range(1, 1000)]
    yield from pair("weights", lambda k: Text(points, POINT, "touching", [ZERO] + ["1 1 1"] * k, (), (), weights, weights[:7]), 9, 900_000)


def second(point=POINT, heights=("0",), inner=("0 0 0 0",), claim="signed_bounds 0 1", facets=(), vertices=(),
           terms=((f"point {POINT[0]}",),), directions=(ZERO,), radius="0"):
    """Of format 2, with a shape."""
    parts = {"heights_a": list(heights), "inner_a": list(inner), "vertices": list(vertices), "facets": list(facets)}
    return Second([list(term) for term in terms], point, claim, list(directions), parts, radius)


def touching(points, rays, differences, lineality=()):
    parts = {"weights_a": ["0 1"], "weights_b": ["0 1"], "lineality": list(lineality), "rays": rays, "differences": differences}
    return Second(points, POINT, "touching", [ZERO], parts)


def sizes_of_format_2():
    wide = [f"0 0 {2**319_998}"]
    deep, high = f"0 1/{2**200_000} 0 -1/{3**50_000}", f"-{7**100_000}/{2**300_000}"
    yield from pair("inner points", lambda k: second(wide, inner=[deep] + ["0 0 0 0"] * k), 1_000, 30_000)
    yield from pair("atoms", lambda k: second(wide, terms=[["disc 0 0 0 1 0 0 1/3 0 0"] * k]), 1_000, 10_000)
    yield from pair("balls", lambda k: second(wide, terms=[["ball 0 0 0 1 0 0 1/3 0 0 1 2 3"] * k]), 1_000, 10_000)
    yield from pair("heights", lambda k: second(heights=[high] + ["1/5"] * k), 1_000, 30_000)
    yield from pair("facets and vertices", lambda k: second(wide, vertices=["0 0"] * k, facets=["0"] * k), 100, 10_000)
    yield from pair("differences", lambda k: touching(wide, [], ["0 0"] * k), 100, 30_000)


def works_of_format_2():
    points = [f"1/3 {2**100 - 1} -{2**70}/5"] * 30_000
    inner, high, steep = f"0 1/{7**30_000} 0 0", f"1/{3**40_000}", f"{7**3_000} 0 0"
    yield from pair("rays", lambda k: touching(points, [f"1 -{2**40} 1"] + ["1 0 0"] * k, ["0 0"] * 7), 1_000, 900_000)
    yield from pair("lineality", lambda k: touching(points, [], ["0 0"], ["1 0 0", f"0 0 {2**90}"] * k), 1_000, 900_000)
    yield from pair("differences", lambda k: touching(points, ["1 2 3"] * 40, ["0 0"] * k), 1_000, 90_000)
    yield from pair("inner points", lambda k: second(points, inner=[inner] + ["0 0 0 0"] * k), 100, 900_000)
    yield from pair("places", lambda k: second(points, terms=[["point 0 0 0"]] * 9, inner=[inner + " 0 0 0 0" * 8] +
                                               ["0 0 0 0" + " 0 0 0 0" * 8] * k),
                    10, 90_000)
    yield from pair("heights", lambda k: second(points, heights=[high], directions=[steep, ZERO],
                                                terms=[["point 0 0 0"] * k]),
                    1_000, 900_000)
    claim, wide = f"signed_bounds {7**6_000}/{3**1000} {11**3_000}/{2**2_000}", points[:3_000] + [f"{2**4_000} 0 0"]
    yield from pair("claim", lambda k: second(wide, claim=claim, radius=f"-{5**2_000}/{2**1_000}", facets=["1 0"] * k), 1_000, 900_000)


def judged(command, lines):
    """The verdict, and the line of a malformed text."""
    text = ("\n".join(lines) + "\n").encode()
    done = subprocess.run([*shlex.split(command), "-"], input=text, stdout=subprocess.PIPE)
    match = re.fullmatch(r"s (REFUSED|MALFORMED) [^ ]*:(\d+): [^\n]*\n", done.stdout.decode())
    if not match or done.returncode != {"REFUSED": 1, "MALFORMED": 2}[match[1]]:
        return f"exit code {done.returncode}, {done.stdout[:200]}"
    return match[1] if match[1] == "REFUSED" else f"MALFORMED on line {match[2]}"


def main(quick, heavy):
    parser = argparse.ArgumentParser(description=sys.modules["__main__"].__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--checker", action="append", required=True)
    parser.add_argument("--heavy", action="store_true")
    options = parser.parse_args()
    texts, wrong = 0, 0
    for group in heavy if options.heavy else quick:
        for name, lines, line in group():
            texts += 1
            expected = "REFUSED" if line is None else f"MALFORMED on line {line}"
            for command in options.checker:
                found = judged(command, lines)
                if found != expected:
                    wrong += 1
                    print(f"{group.__name__}: {name[:60]}: expected {expected}, {command} says {found}")
    print(f"{texts} texts, {wrong} wrong verdicts")
    return 1 if wrong or not texts else 0


if __name__ == "__main__":
    sys.exit(main((digits, long_lines, sizes, works, sizes_of_format_2, works_of_format_2), (numbers, bytes_of_lines)))
