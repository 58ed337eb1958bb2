#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Forges certificates about two bodies, as union_forgeries.py does those of unions; with the same options.

The genuine ones are those of fathom about random boxes, put into other words: verify/check/FORMAT.md, section 15, and two_bodies.py.
"""
import sys
from fractions import Fraction

sys.dont_write_bytecode = True
sys.path.insert(0, __file__.rpartition("/")[0] or ".")
import two_bodies  # noqa: E402
import union_forgeries  # noqa: E402
import unions  # noqa: E402
from two_bodies import Solid, Two  # noqa: E402

WORDS = {"a": "b", "b": "a", "split": "leaf", "leaf": "split"}
NOT_HERE = ("a separation too", "no pieces", "a flat piece", "a piece without points", "a vertex of no point", "a polytope of no piece")


def aimed():
    """(what it aims at, the text): none of them is true, but for those that are called genuine."""
    for k, (name, text) in enumerate(union_forgeries.aimed()):
        if not name.startswith(NOT_HERE):
            yield name, two_bodies.quartered(two_bodies.of_union(unions.Union(text), ("", "a", "b", "ab")[k % 4])).text()
    for solids in ("", "a", "b", "ab"):
        for claim, make in (("depth", deep), ("touching", touching), ("apart", apart)):
            yield "genuine: " + claim, two_bodies.quartered(make(solids)).text()
            of_claim = OF_DEPTH if claim == "depth" else OF_NEAREST + OF_GAP * (claim == "apart")
            for name, change in OF_BLOCKS + of_claim + OF_UNION * ("b" not in solids) + OF_SOLID * ("a" in solids):
                c = make(solids)
                change(c)
                yield f"{name}: {claim}, {solids}", two_bodies.quartered(c).text()


def deep(solids):
    """A beam in two pieces, and one across it that is deeper in it than thick; a piece of B is far away."""
    beam = [((0, 0, 0), (5, 2, 2)), ((5, 0, 0), (10, 2, 2))]
    across = [((4, -5, 1), (6, 5, 3)), ((40, 0, 0), (41, 1, 1))]
    c = unions.box_certificate(beam, across, 1, [(0, 0, -1)], [(0, 0), (1, 0)], ["split 0 0 4", "split 1 1", "leaf 0 1", "leaf 1"])
    return two_bodies.of_union(c, solids)


def not_deep(claim, across, nearest, weights, separations, solids):
    c = unions.box_certificate([((0, 0, 0), (5, 2, 2)), ((5, 0, 0), (10, 2, 2))], across, 0, [], [], [])
    c.claim, c.nearest, (c.weights_a, c.weights_b) = claim, nearest, weights
    c.optima = [([], separations)]
    return two_bodies.of_union(c, solids)


def touching(solids):
    """On top, at (4, 0, 2)."""
    across = [((4, -5, 2), (6, 5, 3)), ((40, 0, 0), (41, 1, 1))]
    weights = [["4", "1/5"], ["5", "4/5"]], [["0", "1/2"], ["2", "1/2"]]
    return not_deep(["touching"], across, ["0", "0"], weights, [["0", "0", "-1"], ["-1", "0", "0"]] * 2, solids)


def apart(solids):
    """One above the middle at a distance of 3."""
    across = [((4, -5, 5), (6, 5, 6)), ((40, 0, 0), (41, 1, 1))]
    weights = [["4", "1/5"], ["5", "4/5"]], [["0", "1/2"], ["2", "1/2"]]
    return not_deep(["apart", "9"], across, ["0", "0"], weights, [["0", "0", "-1"], ["-1", "0", "0"]] * 2, solids)


def blocks(c):
    return c.optima[0][1]


def first_vector(c):
    return next(block for block in blocks(c) if len(block) == 3)


OF_BLOCKS = (("a vector that separates nothing", lambda c: first_vector(c).__setitem__(slice(3), ["0", "1", "0"])),
             ("a vector of nothing", lambda c: first_vector(c).__setitem__(slice(3), ["0", "0", "0"])),
             ("a vector turned round", lambda c: [first_vector(c).__setitem__(k, str(-int(x))) for k, x in enumerate(first_vector(c))]),
             ("no blocks", lambda c: blocks(c).clear()),
             ("a block too few", lambda c: blocks(c).pop()),
             ("a block too many", lambda c: blocks(c).append(["0", "0", "-1"])),
             ("a split of one piece", lambda c: blocks(c).__setitem__(slice(None), [["a"], ["a"], *blocks(c), *blocks(c), *blocks(c)])),
             ("a split of one piece of b", lambda c: blocks(c).__setitem__(slice(None), [["b"], ["b"], *blocks(c)])),
             ("one vector for all", lambda c: blocks(c).__setitem__(slice(None), [["0", "0", "-1"]])),
             ("halves the other way", lambda c: c.b.pieces.reverse()))
OF_DEPTH = (("an optimum missing", lambda c: c.optima.clear()),
            ("an optimum at another place", lambda c: c.optima[0][0].__setitem__(slice(3), ["0", "0", "1"])),
            ("a vertex of no corner", lambda c: c.polytopes[0][1][0].__setitem__(0, "999")),
            ("a vertex of another piece", lambda c: c.polytopes[0][0].__setitem__(1, "1")),
            ("a polytope of no piece", lambda c: c.polytopes[0][0].__setitem__(1, "2")),
            ("a facet of no vertex", lambda c: c.polytopes[0][2][0].__setitem__(1, "8")),
            ("a facet in two", lambda c: c.polytopes[0][2].__setitem__(0, ["3", *c.polytopes[0][2][0][1:4]]) or
             c.polytopes[0][2].append(["3", c.polytopes[0][2][0][1], c.polytopes[0][2][0][3], "2"])),
            ("a facet of nothing", lambda c: c.polytopes[0][2].append(["0"])),
            ("a facet that is open", lambda c: c.polytopes[0][2].pop()),
            ("a depth that is too large", lambda c: c.claim.__setitem__(1, "4")))
OF_NEAREST = (("weights of another piece", lambda c: c.nearest.__setitem__(1, "1")),
              ("weights of no piece", lambda c: c.nearest.__setitem__(0, "2")),
              ("a weight of no corner", lambda c: c.weights_a[0].__setitem__(0, "999")),
              ("weights that sum to more", lambda c: c.weights_a[0].__setitem__(1, "2/5")),
              ("a weight below nothing", lambda c: c.weights_b.extend([[c.weights_b[0][0], "-1"], [c.weights_b[0][0], "1"]])),
              ("no weights", lambda c: c.weights_b.clear()))
OF_GAP = (("a gap too large", lambda c: c.claim.__setitem__(1, "901/100")),
          ("a gap too small", lambda c: c.claim.__setitem__(1, "899/100")))
OF_UNION = (("no pieces", lambda c: c.b.pieces.clear()),
            ("a flat piece", lambda c: c.b.pieces.__setitem__(1, [["40", y, z] for y in "01" for z in "01"])),
            ("a piece without points", lambda c: c.b.pieces[1].clear()))
OF_SOLID = (("a triangle gone", lambda c: c.a.mesh.pop()),
            ("a triangle turned round", lambda c: c.a.mesh[3].reverse()),
            ("a piece gone", lambda c: c.a.pieces.pop()),
            ("a facet gone", lambda c: c.a.pieces[1].pop()),
            ("a facet of nothing", lambda c: c.a.pieces[1].append(["0"])),
            ("a facet turned round", lambda c: c.a.pieces[1][2].__setitem__(slice(1, None), c.a.pieces[1][2][:0:-1])),
            ("a point moved", lambda c: c.a.points[0].__setitem__(0, "-1/1000000")),
            ("a point twice", lambda c: c.a.points.append(c.a.points[0])))


def lists_of(c):
    """Every list of rows that may lose one, or get one twice; and the rows that are on their own."""
    of_body = lambda body: [body.pieces, *body.pieces, *([body.points, body.mesh] if isinstance(body, Solid) else [])]
    lists = [*of_body(c.a), *of_body(c.b), c.polytopes, c.tree, c.weights_a, c.weights_b, *(each for _, each in c.optima)]
    lists += [part for polytope in c.polytopes for part in polytope[1:]] + [c.optima] * (c.claim[0] == "depth")
    single = [*(t for t, _ in c.optima if t), *(polytope[0] for polytope in c.polytopes), *([c.nearest] if c.nearest else [])]
    return [rows for rows in lists if rows], single


def damaged(text, rng):
    """(kind of damage, text)."""
    c = Two(text)
    lists, single = lists_of(c)
    kind = rng.choice(("number", "number", "number", "row", "twice", "swap", "claim", "block"))
    if kind == "number":
        rows = rng.choice([rows for rows in [*lists, single] if rows and isinstance(rows[0][0], str)])
        row = rng.choice(rows)
        k = rng.randrange(len(row))
        row[k] = WORDS.get(row[k]) or str(rng.choice(around(Fraction(row[k]))))
    elif kind in ("row", "twice", "swap"):
        rows = rng.choice(lists)
        i, k = rng.randrange(len(rows)), rng.randrange(len(rows))
        if kind == "row":
            del rows[i]
        elif kind == "twice":
            rows.insert(k, rows[i])
        else:
            rows[i], rows[k] = rows[k], rows[i]
    elif kind == "claim":
        q = Fraction(c.claim[1]) if len(c.claim) > 1 else Fraction(1)
        c.claim[1:] = [str(rng.choice((q * (1 + Fraction(1, 10**9)), q * (1 - Fraction(1, 10**9)), *around(q))))] * (len(c.claim) > 1)
        if rng.random() < 0.2 and c.claim[0] != "depth":
            c.claim = ["touching"] if c.claim[0] == "apart" else ["apart", str(q)]
    else:
        rows = rng.choice([each for _, each in c.optima] or [[]])
        rows.insert(rng.randrange(len(rows) + 1), rng.choice([["a"], ["b"], ["1", "0", "0"], *rows]))
    return kind, c.text()


def around(value):
    return value + 1, value - 1, -value, value + Fraction(1, 2), Fraction(0), Fraction(7), Fraction(2**32), Fraction(2**64)


class Campaign(union_forgeries.Campaign):
    read, aimed, damaged = Two, staticmethod(aimed), staticmethod(damaged)

    def solve(self, a, b):
        """With the certificate in the words of section 15, about solids now and then."""
        answer, text = super().solve(a, b)
        if text is not None:
            solids = ("", "a", "b", "ab")[sum(map(len, a + b)) // 8 % 4]
            text = two_bodies.of_union(unions.Union(text), solids).text()
        return answer, text

    def genuine(self, count, seed):
        return [two_bodies.quartered(Two(text)).text() for text in super().genuine(count, seed)]


if __name__ == "__main__":
    sys.exit(union_forgeries.main(Campaign))
