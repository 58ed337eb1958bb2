# SPDX-License-Identifier: GPL-3.0-or-later
"""Certificates of unions, cut into their parts and put together again; and unions of boxes, whose depth is found here by its definition."""
import itertools
from fractions import Fraction


class Union:
    """A certificate of format 3 without comments and id. Rows are lists of words."""
    header, apart = "fathom-certificate 3", "separations"

    def __init__(self, text):
        self.lines = [line.split(" ") for line in text.split("\n")[:-1] if not line.startswith(("#", "id "))]
        assert self.lines[0] == self.header.split(" ") and self.lines[-1][0] == "end"
        self.at = 1
        self.a, self.b = self.body("a"), self.body("b")
        self.claim = self.line()[1:]
        self.optima, self.polytopes, self.tree, self.nearest, self.weights_a, self.weights_b = [], [], [], [], [], []
        if self.claim[0] == "depth":
            self.optima = [(self.line()[1:], self.part()) for _ in range(int(self.line()[1]))]
            self.polytopes = [(self.line()[1:], self.part(), self.part()) for _ in range(int(self.line()[1]))]
            self.tree = self.part()
        else:
            self.optima = [([], self.part())]
            self.nearest = self.line()[1:]
            self.weights_a, self.weights_b = self.part(), self.part()
        del self.lines, self.at

    def line(self):
        self.at += 1
        return self.lines[self.at - 1]

    def part(self):
        return [list(self.line()) for _ in range(int(self.line()[1]))]

    def body(self, x):
        return self.pieces()

    def pieces(self):
        return [self.part() for _ in range(int(self.line()[1]))]

    def text(self):
        out, counts = [self.header], []

        def announce(word, items):
            counts.append(len(items))
            out.append(f"{word} {len(items)}")

        def part(word, rows):
            announce(word, rows)
            out.extend(" ".join(row) for row in rows)

        self.announce_body("a", self.a, announce, part)
        self.announce_body("b", self.b, announce, part)
        out.append(" ".join(["claim", *self.claim]))
        if self.claim[0] == "depth":
            announce("optima", self.optima)
            for t, separations in self.optima:
                out.append(" ".join(["optimum", *t]))
                part(self.apart, separations)
            announce("polytopes", self.polytopes)
            for which, vertices, facets in self.polytopes:
                out.append(" ".join(["polytope", *which]))
                part("vertices", vertices)
                part("facets", facets)
            part("tree", self.tree)
        else:
            part(self.apart, self.optima[0][1])
            out.append(" ".join(["nearest", *self.nearest]))
            part("weights_a", self.weights_a)
            part("weights_b", self.weights_b)
        return "\n".join(out + [" ".join(map(str, ["end", *counts]))]) + "\n"

    def announce_body(self, x, pieces, announce, part):
        announce("pieces_" + x, pieces)
        for piece in pieces:
            part(x, piece)

    def bodies(self):
        return [self.a, self.b]

    def statement(self):
        """What it claims, as exact values."""
        bodies = [[[tuple(map(Fraction, p)) for p in piece] for piece in pieces] for pieces in self.bodies()]
        return bodies, self.claim[0], [Fraction(q) for q in self.claim[1:]], [tuple(map(Fraction, t)) for t, _ in self.optima if t]


def corners(box):
    """Corner s of a box (low, high) has its coordinates in the bits of s, x lowest."""
    return [tuple(box[s >> k & 1][k] for k in range(3)) for s in range(8)]


def boxes_of(pieces):
    """The pieces as boxes, or None if one is none."""
    found = []
    for piece in pieces:
        box = tuple(map(min, zip(*piece))), tuple(map(max, zip(*piece)))
        if sorted(set(piece)) != sorted(corners(box)) or any(l >= h for l, h in zip(*box)):
            return None
        found.append(box)
    return found


def differences(a, b):
    """The P_ij of boxes, boxes too."""
    return [(tuple(l - h for l, h in zip(q[0], p[1])), tuple(h - l for h, l in zip(q[1], p[0]))) for p in a for q in b]


def depth_of_boxes(a, b):
    """The squared depth and the optima of unions of boxes, by the definition: an optimum has in each coordinate 0 or that of a facet. The
    squared depth is 0 if they do not penetrate; then the squared distance is the third value."""
    blocks = differences(a, b)
    free = lambda t: not any(all(l < x < h for l, x, h in zip(low, t, high)) for low, high in blocks)
    if free((0, 0, 0)):
        gaps = [sum(max(l, -h, 0)**2 for l, h in zip(low, high)) for low, high in blocks]
        return 0, [], min(gaps)
    values = [sorted({Fraction(0)} | {x[k] for block in blocks for x in block}) for k in range(3)]
    best, found = None, []
    for t in itertools.product(*values):
        squared = sum(x * x for x in t)
        if (best is None or squared <= best) and free(t):
            found = [t] + (found if squared == best else [])
            best = squared
    return best, sorted(found), 0


def block_polytope(i, j):
    """The polytope of two boxes that is all of P_ij. Facets: x low, x high, y low, .."""
    facets = ["0 4 6 2", "1 3 7 5", "0 1 5 4", "2 6 7 3", "0 2 3 1", "4 5 7 6"]
    return [str(i), str(j)], [[str(s), str(7 - s)] for s in range(8)], [["4", *f.split()] for f in facets]


def box_certificate(a, b, q, optima, polytopes, tree):
    """A certificate about boxes, true or not. polytopes: pairs (i, j). The separations are axes that do separate, where there are any."""
    c = object.__new__(Union)
    c.a, c.b = ([[list(map(str, p)) for p in corners(box)] for box in boxes] for boxes in (a, b))
    c.claim = ["depth", str(q)]
    c.optima = [(list(map(str, t)), [separation(block, t) for block in differences(a, b)]) for t in optima]
    c.polytopes = [block_polytope(i, j) for i, j in polytopes]
    c.tree, c.nearest, c.weights_a, c.weights_b = [node.split(" ") for node in tree], [], [], []
    return c


def separation(block, t):
    for k in range(3):
        for sign, beyond in ((-1, t[k] <= block[0][k]), (1, t[k] >= block[1][k])):
            if beyond:
                return [str(sign * (m == k)) for m in range(3)]
    return ["1", "0", "0"]
