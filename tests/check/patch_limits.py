#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The limits of verify/check/FORMAT.md, section 13, as limits.py has those of section 8; with the same options."""
import pathlib
import sys
from fractions import Fraction

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parent))
from limits import NUMBERS, POINT, ZERO, Certificate, bits, cost, main, numbers_of, pair, width  # noqa: E402


class Fourth(Certificate):
    """Claims patches and rates and proves nothing: its first direction is zero. A patch is (corners, sides), which may name nothing."""

    def __init__(self, a=tuple(POINT), directions=(ZERO,), patches=(), rates=()):
        self.a, self.directions, self.patches, self.rates = a, directions, patches, rates

    def lines(self):
        counts = [len(self.a), 1, len(self.directions), 0, 0, len(self.patches)]
        yield from ("fathom-certificate 4", f"a {len(self.a)}", *self.a, "b 1", *POINT, "claim depth 1")
        yield from (f"directions {len(self.directions)} some", *self.directions, "vertices 0", "facets 0", f"patches {len(self.patches)}")
        for corners, sides in self.patches:
            counts += [len(corners), len(sides)]
            yield from (f"patch {len(corners)} {len(sides)}", *corners, *sides)
        if self.rates:
            counts.append(len(self.rates))
            yield from (f"rates {len(self.rates)}", *self.rates)
        yield "end " + " ".join(map(str, counts))

    def size_and_work(self):
        """The page's formulas, from the page's definitions."""
        n, k, v = len(self.a) + 1, len(self.directions), width(numbers_of(self.a))
        corners, sides = ([row for patch in self.patches for row in patch[part]] for part in (0, 1))
        weights, widest = 0, {row: self.width_of(row.split(" ")) for row in set(corners)}
        for row in corners:
            weights += row.count(" ") // 2
        x = max(widest.values(), default=0)
        u = max(bits(int(m)) for row in {*self.directions, *(side[2:side.rindex(" ")] for side in set(sides))} for m in row.split(" "))
        r = max((sum(map(self.length_of, row.split(" ")[:6] + row.split(" ")[7:])) for row in set(self.rates)), default=0)
        c, s, m = len(corners), len(sides), len(self.rates)
        b = 2 * (1 + 1 + 1 + 1)  # of 1/1 and two radii of 0/1
        size = n * v + (weights + 2 * c) * (v + x)
        work = n * k * cost(v, u) + n * cost(v, v) + 4 * k * cost(v, b)
        work += s * n * cost(v, u) + 4 * (weights + 8 * c) * cost(v + x + 2 * u, v + x + 2 * u) + 4 * s * cost(v + x + u, 2 * u)
        return size, work + 8 * m * c * cost(v + x + u + r, v + x + u + r)

    @staticmethod
    def width_of(words):
        of_a = 1 + 2 * int(words[0])
        return width([Fraction(w) for w in words[2:of_a:2] + words[of_a + 2::2]])

    @staticmethod
    def length_of(word):
        return bits(Fraction(word).numerator) + bits(Fraction(word).denominator)


POINTS = [f"1/3 {2**100 - 1} -{2**70}/5"] * 300
WIDE, WEIGHT = [f"0 0 {2**319_998}"], f"1 0 1/{2**200_000} 1 0 -{3**50_000}/{5**9}"


def corner(weights):
    return f"{weights}" + " 0 1/3" * weights + " 0"


def sizes():
    yield from pair("weights of a corner", lambda k: Fourth(WIDE, patches=[([corner(k)], [])]), 1_000, 13_000)
    yield from pair("weights of corners", lambda k: Fourth(patches=[([WEIGHT], []), ([corner(1)] * k, []), ([corner(1_000)], [])]), 10,
                    90_000)
    yield from pair("wide corners", lambda k: Fourth(patches=[([WEIGHT, "0 1 7 1/7", corner(k)], [])]), 1_000, 30_000)


def works():
    wide, steep = f"1/{7**9_000} 0 0", f"a {-7**9_000} 0 1 0"
    yield from pair("sides", lambda k: Fourth(POINTS * 30, patches=[([], [steep, "b 1 2 3 99"]), ([], ["a 0 0 0 0"] * k)]), 10, 90_000)
    yield from pair("long sides", lambda k: Fourth(patches=[(["0 0"], [f"a 0 0 {2**300_000} 0"] + ["b 0 0 0 0"] * k)]), 10, 900_000)
    yield from pair("corners", lambda k: Fourth([wide], patches=[(["0 0"] * k, [])]), 10, 900_000)
    yield from pair("corners and weights", lambda k: Fourth([wide], patches=[([WEIGHT] + [corner(3)] * k, ["a 1 0 0 0"])]), 10, 900_000)
    yield from pair("corners and long directions", lambda k: Fourth(directions=[ZERO, f"0 {5**9_000} 0"], patches=[(["0 0"] * k, [])]), 10,
                    900_000)
    yield from pair("sides that pass by wide corners", lambda k: Fourth([wide], patches=[([WEIGHT], [f"b 0 0 {5**9_000} 0"] * k)]), 10,
                    900_000)
    rate = f"0 1/{3**9_000} 0 -{2**9_000}/7 5 0 1 {7**900}/{11**90}"
    yield from pair("rates", lambda k: Fourth(patches=[(["0 0"] * 50, [])], rates=[rate] + ["0 0 0 0 0 0 0 0"] * k), 10, 900_000)
    signs = "0 0 0 0 0 0 " + "9" * 900 + " 0"  # these do not count
    yield from pair("rates of wide corners", lambda k: Fourth([wide], patches=[([WEIGHT] * 3, [f"b 0 0 {5**9_000} 0"])], rates=[signs] * k),
                    10, 900_000)


def numbers():
    count = 700_000
    for more in (0, 1):
        left = NUMBERS + more - 9 - 11 * count - 8  # points and a direction; patches of a corner of one weight and a side; a rate
        sides = left % 2
        weights = (left - 2 - 5 * sides - 2) // 2
        patches = [(["1 0 1 0"], ["a 0 0 0 0"])] * count + [([corner(weights)], ["a 0 0 0 0"] * sides)]
        text = list(Fourth(patches=patches, rates=["0 0 0 0 0 0 0 0"]).lines())
        yield f"{NUMBERS + more} numbers", text, len(text) - 1 if more else None


if __name__ == "__main__":
    sys.exit(main((sizes, works), (numbers,)))
