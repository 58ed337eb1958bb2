#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The limits of verify/check/FORMAT.md, section 15, as limits.py has those of section 8; with the same options."""
import functools
import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parent))
import two_bodies  # noqa: E402
import union_forgeries  # noqa: E402
from limits import NUMBERS, POINT, SIZE, WORK, ZERO, Certificate, bits, cost, fraction, main, numbers_of, pair, width  # noqa: E402
from tiling_limits import Solid, facet  # noqa: E402
from union_limits import Union  # noqa: E402


class Two(Union):
    """Claims something and proves nothing: its first piece is flat. A body is a list of pieces, or a Solid; lists have blocks."""
    format, list_name = 5, "apart"

    def __init__(self, a=(POINT,), b=(POINT,), nearest="0 0", apart=(), **more):
        super().__init__(a, b, separations=apart, **more)
        self.nearest = nearest

    @staticmethod
    def body(name, pieces, part, announced):
        if not isinstance(pieces, Solid):
            yield from Union.body(name, pieces, part, announced)
            return
        yield from part("solid_" + name, pieces.points)
        yield from part("mesh", pieces.mesh)
        yield from announced("pieces", pieces.pieces)
        for facets in pieces.pieces:
            yield from part("piece", facets)

    def size_and_work(self):
        """The page's formulas, from the page's definitions; without the tree."""
        n = f = c = s = 0
        rows, corners = set(), []
        for body in (self.a, self.b):
            if isinstance(body, Solid):
                named = [{int(word) for row in set(piece) for word in row.split(" ")[1:]} for piece in body.pieces]
                corners.append([[k for k in names if k < len(body.points)] for names in named])
                n, f = n + len(body.points), f + len(body.mesh)
                c += sum(row.count(" ") for piece in body.pieces for row in piece)
                s += sum(len(piece) * len(names) for piece, names in zip(body.pieces, corners[-1]))
                rows |= set(body.points)
            else:
                corners.append(body)
                n, c = n + sum(map(len, body)), c + sum(map(len, body))
                rows |= {row for piece in body for row in piece}
        h = max(map(Solid.width_of, rows), default=0)
        v, p = sum(len(vertices) for vertices, _ in self.polytopes), sum(len(facets) for _, facets in self.polytopes)
        q = sum(row.count(" ") for _, facets in self.polytopes for row in facets)
        g = sum(len(facets) * len({k for row in set(facets) for k in row.split(" ")[1:] if int(k) < len(vertices)})
                for vertices, facets in self.polytopes)
        vectors = [row for rows in self.lists for row in rows if row not in ("a", "b")]
        u = max((bits(int(word)) for word in numbers_of(vectors)), default=0)
        of_a, of_b = ([len(piece) for piece in pieces] for pieces in corners)
        e = sum(sum(of_a[i:j]) + sum(of_b[k:m]) for rows in self.lists for i, j, k, m in self.ranges(rows, len(of_a), len(of_b)))
        m, wide = len(self.optima), width(numbers_of([t for t, _ in self.optima])) if self.optima else 0
        b = max((max(bits(x.numerator), bits(x.denominator)) for x in numbers_of([self.claim], 1)), default=0)
        weights = [fraction(row.split(" ")[1]) for rows in self.weights for row in rows]
        numbers = list(weights)
        for pieces, rows, piece in zip((self.a, self.b), self.weights, self.nearest.split(" ")):
            points = pieces[int(piece)] if any(rows) and int(piece) < len(pieces) else []
            numbers += numbers_of([points[k] for k in {int(row.split(" ")[0]) for row in rows} if k < len(points)])
        x = width(numbers) if weights else 0
        size = (n + 10 * f + 4 * c + 2 * v + 12 * p) * h + len(vectors) * u + m * wide + len(weights) * x
        work = 3 * (3 * f + c) * cost(4 * h, 4 * h) + s * cost(5 * h, h) + 3 * q * cost(8 * h, 8 * h) + g * cost(10 * h, 2 * h)
        z = 4 * h + 2 * u + b + wide
        self.b_and_e = b, wide
        return size, work + 4 * e * cost(h + u, h) + 8 * len(vectors) * cost(z, z) + 4 * len(weights) * cost(2 * x, 2 * x)

    @staticmethod
    def ranges(rows, m, n):
        """By the page: the pieces from i to j of A, from k to l of B, of each vector in front of the first fault."""
        left = [(0, m, 0, n)]
        for row in rows:
            if not left:
                return
            i, j, k, l = left.pop()
            if row == "a" and j - i > 1:
                left += [((i + j) // 2, j, k, l), (i, (i + j) // 2, k, l)]
            elif row == "b" and l - k > 1:
                left += [(i, j, (k + l) // 2, l), (i, j, k, (k + l) // 2)]
            elif row in ("a", "b"):
                return
            else:
                yield i, j, k, l


POINTS = [f"1/3 {2**100 - 1} -{2**70}/5"] * 300


def sizes():
    wide = [[f"0 0 {2**319_998}"]]
    yield from pair("vertices", lambda k: Two(wide, claim="depth 1", polytopes=[(["0 0"] * 7, []), (["0 0"] * k, [])]), 5_000, 9_000)
    yield from pair("facets", lambda k: Two(wide, claim="depth 1", polytopes=[([], ["0"] * 9), (["0 0"] * k, ["0"] * 400)]), 3_000, 9_000)
    yield from pair("points", lambda k: Two([wide[0] + [ZERO] * k]), 100, 9_000)
    yield from pair("triangles", lambda k: Two(Solid([f"0 0 {2**19_000}"], ["0 0 0"] * k), claim="depth 1"), 1_000, 30_000)
    yield from pair("corners", lambda k: Two([POINTS], Solid([f"{3**9_000} 1/2 0"], [], [[facet(3)] * 10, [facet(k), facet(2)]])), 1_000,
                    90_000)
    vector, large = f"{-2**49_998} 0 1", Solid([*wide[0], *[ZERO] * 12_480])  # vectors alone would be too much work
    yield from pair("vectors", lambda k: Two(large, apart=["a", vector] + ["1 0 0"] * k), 10, 900)
    optimum = ("0 0 0", ["b", vector] * 9)
    yield from pair("vectors of optima", lambda k: Two(large, claim="depth 1", optima=[optimum, ("0 0 0", ["1 0 0"] * k)]), 10, 900)
    place = f"1/{3**100_000} 0 {7**90_000}/{7**50_000}"
    yield from pair("optima", lambda k: Two(claim="depth 1", optima=[(place, [])] + [("0 1 0", [])] * k), 1_000, 30_000)
    weights = [f"0 {2**150_000}/{3**100_000}", f"0 1/{5**60_000}"]
    yield from pair("weights", lambda k: Two(weights=(weights, ["0 -7/9"] * k)), 100, 100_000)
    near = [[f"1/{7**40_000} 0 0", f"0 0 {11**50_000}/{13**2_000}"]]
    yield from pair("corners of weights", lambda k: Two(near, weights=(["0 1/3", "1 7", "2 1"], ["0 -7/9"] * k)), 100, 100_000)


def works():
    long = f"{7**30_000} 0 0"
    many, tree = [POINTS] * 5, ["a", "b", long, "1 0 0", "a", "1 0 0"]  # the rest, where the list is no tree, does not count
    tree += ["a", "b", "0 0 1", "0 0 1"]
    yield from pair("vectors and corners", lambda k: Two(many, many, apart=[*tree, *["0 0 1"] * k]), 1_000, 900_000)
    optima = [("1/7 0 0", ["0 0 1"]), ("1 1 1", ["b", "b", "1 0 0", "1 0 0"]), ("1 0 0", ["a", "0 0 1"])]
    yield from pair("optima", lambda k: Two([POINTS] * 9, many, claim="depth 1", optima=optima * k), 1_000, 900_000)
    yield from pair("vectors and a claim", lambda k: Two(claim=f"apart 1/{7**20_000}", apart=[long] + ["1 0 0"] * k), 100, 900_000)
    place = f"{11**20_000}/{2**60_000} 1 1"
    yield from pair("long optima", lambda k: Two(claim="depth 1", optima=[(place, ["1 0 0"] * k)]), 100, 900_000)
    yield from pair("points", lambda k: Two([[f"1/{7**500} 2 3"] + ["0 0 0"] * k]), 1_000, 900_000)
    solid = Solid([f"{k} 1/3 0" for k in range(400)] + [f"1/{3**900} 0 0"], [], [[facet(30)] + [f"3 {k} 9 401" for k in range(400)]] * 40)
    yield from pair("pieces of solids", lambda k: Two(solid, Solid(solid.points, [], [["0"] * k + [solid.pieces[0][7]]])), 1_000, 9_000_000)
    yield from pair("triangles", lambda k: Two(many, Solid([f"1/{7**300} 2 3"], ["0 0 0"] * k)), 1_000, 900_000)
    wide, names = [[f"1/{3**900} 0 0"]], [f"4 {k} {k + 1} 0 7" for k in range(60)]
    yield from pair("corners of facets", lambda k: Two(wide, claim="depth 1", polytopes=[(["0 0"] * 9, names), ([], [facet(k), facet(3)])]),
                    1_000, 900_000)
    yield from pair("facets and vertices", lambda k: Two(wide, claim="depth 1", polytopes=[(["0 0"] * 50, names + ["0"] * k)]), 10, 90_000)
    weights = [f"0 {k}/{2**9_000 * 3**k}" for k in range(1, 1000)]
    for nearest in ("0 0", "1 0"):
        yield from pair("weights", lambda k: Two([[f"1/{5**9_000} 0 0"]], nearest=nearest, claim=f"apart {5**9}/7",
                                                 weights=(weights, weights[:7] + ["0 1"] * k)), 9, 900_000)


class Deep(Certificate):
    """All of it is true, but that a node follows behind the tree. B less A is a box, whose far sides are in the path of the leaf's kind:
    each split but the last has one child, and each child of that is a leaf."""
    unit = 10**4_000
    chains = ((), (0,), (0, 2), (0, 2, 4))  # of splits, for leaves of one constraint more

    def __init__(self, kind, leaves):
        self.certificate, self.chain, self.leaves, self.last = self.box(), self.chains[kind - 1], leaves, (0, 2, 4, 1)[kind - 1]

    @classmethod
    @functools.cache
    def box(cls):
        x = cls.unit
        box = ((-4 * x, -x, -4 * x), (4 * x, 4 * x, 4 * x))
        return two_bodies.of_union(union_forgeries.about(x * x, [(0, -x, 0)], ["leaf"], box), "")

    def lines(self):
        names, n = "".join(f" {k}" for k in range(len(self.chain))), len(self.chain)
        tree = [*(f"split 0 {f}" for f in self.chain), "split 0" + f" {self.last}" * self.leaves]
        tree += [f"leaf{names} {n + k}" for k in range(self.leaves)] + ["leaf"]
        self.certificate.tree = [node.split(" ") for node in tree]
        return self.certificate.text().split("\n")[:-1]

    def within(self):
        (size, work), (b, e), x = *self.without_leaves(), self.unit
        p, r = [bits(d) for d in (4 * x, 4 * x, x, 4 * x, 4 * x, 4 * x)], len(self.chain) + 1
        y = lambda r, p: (2 * r + 2) * (p + 8) + b
        work += sum(16 * cost(y(0, p), y(0, p) + e) for p in p)
        wide = max(p[f] for f in (*self.chain, self.last))
        each = 8 * cost(5 * wide + 40, 5 * wide + 40) if r == 4 else 16 * cost(y(r, wide), y(r, wide) + e)
        return size <= SIZE and work + self.leaves * each <= WORK

    @classmethod
    @functools.cache
    def without_leaves(cls):
        c, words = cls.box(), lambda rows: [" ".join(row) for row in rows]
        two = Two([words(piece) for piece in c.a.pieces], [words(piece) for piece in c.b.pieces], claim=" ".join(c.claim),
                  optima=[(" ".join(t), words(rows)) for t, rows in c.optima],
                  polytopes=[(words(vertices), words(facets)) for _, vertices, facets in c.polytopes])
        return two.size_and_work(), two.b_and_e


def trees():
    for kind in (1, 2, 3, 4):
        yield from pair(f"leaves of {kind}", lambda k: Deep(kind, k), 10, 900_000)


def numbers():
    for more in (0, 1):
        left = NUMBERS + more - 2 * (1 + 3) - 2 * 3 - 3 * 10**6 - 10**6  # without pieces and their points, optima and the rest of the list
        for kind, rows in (("splits", ["a", "b"] * (left // 2) + ["a"] * (left % 2)),
                           ("vectors", ["0 0 1"] * (left // 3) + ["b"] * (left % 3))):
            text = list(Two(claim="depth 1", optima=[("0 0 0", []), ("0 0 0", ["1 1 1"] * 10**6 + ["a"] * 10**6 + rows)]).lines())
            yield f"{NUMBERS + more} numbers, {kind}", text, len(text) - 3 if more else None


if __name__ == "__main__":
    sys.exit(main((sizes, works, trees), (numbers,)))
