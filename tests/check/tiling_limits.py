#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The limits of verify/check/FORMAT.md, section 14, as limits.py has those of section 8; with the same options."""
import functools
import pathlib
import sys
from fractions import Fraction
from math import lcm

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parent))
from limits import NUMBERS, ZERO, Certificate, bits, cost, main, pair  # noqa: E402


class Solid(Certificate):
    """Claims a tiling and proves nothing: a triangle has a corner that is no point. A piece is a list of facets."""

    def __init__(self, points=(ZERO,), mesh=(), pieces=((),)):
        self.points, self.mesh, self.pieces = points, [f"0 0 {2**70}", *mesh], pieces

    def lines(self):
        counts = [len(self.points), len(self.mesh), len(self.pieces), *map(len, self.pieces)]
        yield from ("fathom-certificate 5", f"solid_a {len(self.points)}", *self.points, f"mesh {len(self.mesh)}", *self.mesh)
        yield f"pieces {len(self.pieces)}"
        for facets in self.pieces:
            yield from (f"piece {len(facets)}", *facets)
        yield from ("claim solid", "end " + " ".join(map(str, counts)))

    def size_and_work(self):
        """The page's formulas, from the page's definitions."""
        n, f, c = len(self.points), len(self.mesh), sum(row.count(" ") for facets in self.pieces for row in facets)
        named = [{int(word) for row in set(facets) for word in row.split(" ")[1:]} for facets in self.pieces]
        s = sum(len(facets) * len({k for k in names if k < n}) for facets, names in zip(self.pieces, named))
        h = max(map(self.width_of, set(self.points)), default=0)
        return (n + 10 * f + 4 * c) * h, 3 * (3 * f + c) * cost(4 * h, 4 * h) + s * cost(5 * h, h)

    @staticmethod
    @functools.cache
    def width_of(row):
        p = [Fraction(word) for word in row.split(" ")]
        unit = lcm(*(x.denominator for x in p))
        return bits(unit) + max(bits(int(x * unit)) for x in p)


def facet(corners):
    return f"{corners} " + " ".join("0" * corners)


WIDE = f"1/{2**50_000} {7**20_000} 5/{3**30_000}"


def sizes():
    yield from pair("points", lambda k: Solid([WIDE, *[ZERO] * k]), 1_000, 60_000)
    yield from pair("triangles", lambda k: Solid([f"0 0 {2**19_000}"], ["0 0 0"] * k), 1_000, 30_000)
    yield from pair("corners", lambda k: Solid([f"{3**9_000} 1/2 0"], [], [[facet(3)] * 10, [facet(k), facet(2)]]), 1_000, 90_000)


def works():
    """Size alone keeps triangles and corners from being too much work: they pass this limit beside a large piece."""
    points = [f"{k} 1/3 0" for k in range(4_000)] + [f"1/{3**900} 0 0"]
    names = [f"20 {' '.join(map(str, range(k, k + 20)))}" for k in range(0, 4_000, 20)]
    unknown = [f"3 4001 {2**32} {2**64}"] * 7  # these name no points
    piece = [*names, *unknown, *["0"] * 1_400]
    yield from pair("facets and points", lambda k: Solid(points, [], [["0"] * 9, piece + ["0"] * k, names[:9] * 2]), 10, 9_000)
    yield from pair("triangles", lambda k: Solid(points, ["0 0 0"] * k, [piece]), 1_000, 200_000)
    yield from pair("corners", lambda k: Solid(points, [], [piece, [facet(k), facet(3)], [facet(3)] * 9]), 1_000, 400_000)


def numbers():
    for more in (0, 1):
        left = NUMBERS + more - 3 - 3 - 600_000 * (1 + 2)
        text = list(Solid(pieces=[["1 0"]] * 600_000 + [[]] * (left % 3), mesh=["0 0 0"] * (left // 3)).lines())
        yield f"{NUMBERS + more} numbers", text, len(text) - 2 if more else None  # that of the last piece


if __name__ == "__main__":
    sys.exit(main((sizes, works), (numbers,)))
