#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The limits of certificates of unions, as limits.py does it for the others: verify/check/FORMAT.md, section 12.

union_limits.py [--heavy] --checker COMMAND [--checker COMMAND]..     --heavy: the texts of ten million numbers instead
"""
import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parent))
from limits import NUMBERS, POINT, Certificate, bits, cost, main, numbers_of, pair, width  # noqa: E402


class Union(Certificate):
    """A certificate that claims something and proves nothing: its first piece is flat. Pieces are lists of points, optima pairs of a
    translation and separations, polytopes pairs of vertices and facets."""

    def __init__(self, a=(POINT,), b=(POINT,), claim="touching", separations=(), optima=(), polytopes=(), tree=(), weights=((), ())):
        self.a, self.b, self.claim, self.optima, self.polytopes, self.tree, self.weights = a, b, claim, optima, polytopes, tree, weights
        self.depth = claim.startswith("depth")
        self.lists = [rows for _, rows in optima] if self.depth else [separations]

    format, list_name, nearest = 3, "separations", "0 0"

    @staticmethod
    def body(name, pieces, part, announced):
        yield from announced("pieces_" + name, pieces)
        for points in pieces:
            yield from part(name, points)

    def lines(self):
        counts = []

        def part(name, rows):
            counts.append(len(rows))
            return [f"{name} {len(rows)}", *rows]

        def announced(name, items):
            counts.append(len(items))
            return [f"{name} {len(items)}"]

        yield f"fathom-certificate {self.format}"
        yield from self.body("a", self.a, part, announced)
        yield from self.body("b", self.b, part, announced)
        yield f"claim {self.claim}"
        if self.depth:
            yield from announced("optima", self.optima)
            for t, rows in self.optima:
                yield "optimum " + t
                yield from part(self.list_name, rows)
            yield from announced("polytopes", self.polytopes)
            for vertices, facets in self.polytopes:
                yield "polytope 0 0"
                yield from part("vertices", vertices)
                yield from part("facets", facets)
            yield from part("tree", self.tree)
        else:
            yield from part(self.list_name, self.lists[0])
            yield "nearest " + self.nearest
            yield from part("weights_a", self.weights[0])
            yield from part("weights_b", self.weights[1])
        yield "end " + " ".join(map(str, counts))

    def size_and_work(self):
        """The page's formulas, from the page's definitions."""
        n_a, n_b = (sum(map(len, pieces)) for pieces in (self.a, self.b))
        facets = [row.count(" ") for _, rows in self.polytopes for row in rows]
        v_count, f, t = sum(len(rows) for rows, _ in self.polytopes), len(facets), sum(k * k for k in facets)
        weights = [*self.weights[0], *self.weights[1]]
        n, k, r, m = n_a + n_b, sum(map(len, self.lists)), len(weights), len(self.optima)
        s = len(self.lists) * (len(self.b) * n_a + len(self.a) * n_b)
        constraints = [row.count(" ") for row in self.tree if row.startswith("leaf")]
        w = width(numbers_of({row for pieces in (self.a, self.b) for points in pieces for row in points}))
        e = width(numbers_of([t for t, _ in self.optima])) if self.optima else 0
        x = width(numbers_of(weights, 1)) if weights else 0
        u = max((bits(int(number)) for number in numbers_of({row for rows in self.lists for row in rows})), default=0)
        b = max((max(bits(q.numerator), bits(q.denominator)) for q in numbers_of([self.claim], 1)), default=0)
        v = w + 32
        work = s * cost(w + e, u) + 16 * (n + t) * cost(v, v) + 4 * r * cost(v + x, v + x) + 8 * constraints.count(4) * cost(9 * v, 9 * v)
        for r, count in enumerate([f, *(constraints.count(r) for r in (1, 2, 3))]):
            work += 16 * count * cost((4 * r + 3) * v + b, (4 * r + 3) * v + b + e)
        return (n + v_count + 3 * f) * v + k * u + m * e + len(weights) * x, work


WIDE = [[f"0 0 {2**319_998}"]]
POINTS = [f"1/3 {2**100 - 1} -{2**70}/5"] * 300


def sizes():
    points = [WIDE[0] + ["1/3 2/6 -1/5"] * 300]  # more of them are too much work
    yield from pair("vertices", lambda k: Union(points, claim="depth 1", polytopes=[(["0 0"] * 7, []), (["0 0"] * k, [])]), 10_000, 13_000)
    facets = ["0"] * 400  # as many as reach this size are too much work
    yield from pair("facets", lambda k: Union(WIDE, claim="depth 1", polytopes=[([], ["2 0 0"] * 9), (["0 0"] * k, facets)]), 10_000,
                    13_000)
    wide = f"{-2**319_998} 0 1"
    yield from pair("separations", lambda k: Union(separations=[wide] + ["1 0 0"] * k), 12_000, 13_000)
    yield from pair("separations of optima", lambda k: Union(claim="depth 1", optima=[("0 0 0", [wide] * 9), ("0 0 0", ["1 0 0"] * k)]),
                    12_000, 13_000)
    place = f"1/{3**100_000} 0 {7**90_000}/{7**50_000}"
    yield from pair("optima", lambda k: Union(claim="depth 1", optima=[(place, [])] + [("0 1 0", [])] * k), 1_000, 30_000)
    yield from pair("weights", lambda k: Union(weights=([f"0 {2**150_000}/{3**100_000}", f"0 1/{5**60_000}"], ["0 -7/9"] * k)), 100,
                    100_000)


def works():
    long = f"{7**30_000} 0 0"
    yield from pair("separations of many pieces", lambda k: Union([POINTS] * 40, [POINT] * k, separations=[long]), 10, 90_000)
    yield from pair("pieces of one point", lambda k: Union([POINT] * k, [POINT] * 2_000, separations=[long]), 1_000, 900_000)
    yield from pair("lists", lambda k: Union([POINTS] * 9, [POINTS] * 9, "depth 1", optima=[("1/7 0 0", [])] * k), 1_000, 900_000)
    place = f"{11**20_000}/{2**60_000} 1 1"
    yield from pair("long optima", lambda k: Union([POINTS] * k, [POINTS] * 9, "depth 1", optima=[(place, [long]), ("1 1 1", [])]), 10,
                    90_000)
    yield from pair("points", lambda k: Union([[f"1/{7**5_000} 2 3"] + ["0 0 0"] * k], claim="depth 1"), 1_000, 900_000)
    yield from pair("corners", lambda k: Union(claim="depth 1", polytopes=[([], ["3 0 0 0"]), ([], [f"{k} " + " ".join("0" * k)])]), 1_000,
                    30_000)
    claim = f"depth {7**20_000}/{3**1000}"
    yield from pair("facets", lambda k: Union([POINTS], claim=claim, polytopes=[([], ["3 0 0 0"] * k)]), 1_000, 900_000)
    yield from pair("the claim's denominator", lambda k: Union([POINTS], claim=f"depth 1/{7**20_000}", polytopes=[([], ["0"] * k)]), 1_000,
                    900_000)
    weights = [f"0 {k}/{2**9_000 * 3**k}" for k in range(1, 1000)]
    yield from pair("weights", lambda k: Union([POINTS], claim=f"apart {5**9}/7", weights=(weights, weights[:7] + ["0 1"] * k)), 9, 900_000)
    claim, optimum = f"depth 2/{7**300}", [(f"1/{7**9_000} 0 0", [])]  # numbers of which none is so long that the others do not count
    yield from pair("facets and optima", lambda k: Union([POINTS], claim=claim, optima=optimum, polytopes=[([], ["0"] * k)]), 1_000,
                    900_000)
    for count in (1, 2, 3):
        leaf = "leaf" + " 0" * count
        yield from pair(f"leaves of {count}", lambda k: Union([POINTS], claim=claim, optima=optimum, tree=[leaf] * k), 1_000, 900_000)
    tree = ["leaf 0 1 2 3"] * 60_000  # as many as reach this work make a long text
    yield from pair("leaves of 4", lambda k: Union([POINTS], claim=claim, optima=optimum, tree=[*tree, *["leaf 0 1 2"] * k]), 1_000,
                    900_000)
    # what a checker refuses, or only looks up, is not counted
    tree = ["split 0" + " 1" * 9_000, "leaf"] + ["split 7 1 2", "leaf", "leaf 0 1 2 3 4"] * 9_000
    yield from pair("uncounted", lambda k: Union([POINTS], claim=claim, optima=optimum, tree=[*tree, *["leaf 0"] * k]), 1_000, 900_000)


def padded(made, numbers):
    """With so many numbers more, in leaves."""
    full, rest = divmod(numbers - 1, 10**6)
    made.tree = [*made.tree, *["leaf" + " 0" * (10**6 - 1)] * full, "leaf" + " 0" * rest]
    return made


def numbers():
    each, points = 300_000, 2 * (1 + 3)  # two pieces of a point each
    for more in (0, 1):
        for kind, counted, made in (("pieces", 1, Union([POINT] + [[]] * each, claim="depth 1")),
                                    ("optima", 6, Union(claim="depth 1", optima=[("0 0 0", ["0 0 0"])] * each)),
                                    ("polytopes", 2 + 2 + 1, Union(claim="depth 1", polytopes=[(["0 0"], ["0"])] * each)),
                                    ("nodes", 1 + 2 + 3, Union(claim="depth 1", tree=["leaf", "split 0", "split 0 1"] * each))):
            text = list(padded(made, NUMBERS + more - points - counted * each).lines())
            yield f"{NUMBERS + more} numbers, {kind}", text, len(text) - 1 if more else None
        weights = ["0 1"] * ((NUMBERS - points - 2) // 2)  # two are those of `nearest`
        text = list(Union(weights=(weights, ["0 1"] * more)).lines())
        yield f"{NUMBERS + 2 * more} numbers, weights", text, len(text) - 1 if more else None


if __name__ == "__main__":
    sys.exit(main((sizes, works), (numbers,)))
