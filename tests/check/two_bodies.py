# SPDX-License-Identifier: GPL-3.0-or-later
"""Certificates about two bodies, verify/check/FORMAT.md, section 15: cut into their parts and put together again, and made of those of
format 3."""
import itertools
from fractions import Fraction

import tilings
import unions


class Solid:
    """Rows are lists of words; pieces are lists of facets."""

    def __init__(self, points, mesh, pieces):
        self.points, self.mesh, self.pieces = points, mesh, pieces

    def corners(self):
        """Of each piece: its points by their numbers."""
        return [{k: self.points[int(k)] for f in piece for k in f[1:] if int(k) < len(self.points)} for piece in self.pieces]


class Pieces:
    def __init__(self, pieces):
        self.pieces = pieces

    def corners(self):
        return [{str(k): p for k, p in enumerate(piece)} for piece in self.pieces]


class Two(unions.Union):
    """Optima have blocks in the place of separations."""
    header = "fathom-certificate 5"

    def body(self, x):
        if self.lines[self.at][0] == "pieces_" + x:
            return Pieces(self.pieces())
        points, mesh = self.part(), self.part()
        return Solid(points, mesh, self.pieces())

    def announce_body(self, x, body, announce, part):
        if isinstance(body, Solid):
            part("solid_" + x, body.points)
            part("mesh", body.mesh)
        announce("pieces" if isinstance(body, Solid) else "pieces_" + x, body.pieces)
        for piece in body.pieces:
            part("piece" if isinstance(body, Solid) else x, piece)

    apart = "apart"

    def bodies(self):
        return [[list(corners.values()) for corners in body.corners()] for body in (self.a, self.b)]


def of_union(union, solids):
    """The same statement about solids, where `solids` names the body."""
    c = object.__new__(Two)
    c.claim, c.tree, c.weights_a, c.weights_b, c.nearest = union.claim, union.tree, union.weights_a, union.weights_b, union.nearest
    c.a, c.b = (solid_of(pieces) if x in solids else Pieces(pieces) for x, pieces in (("a", union.a), ("b", union.b)))
    number = {x: renumbered(pieces, body) for x, pieces, body in (("a", union.a, c.a), ("b", union.b, c.b))}
    corner = lambda x, i, k: number[x][int(i)][int(k)]
    c.polytopes = [([i, j], [[corner("b", j, l), corner("a", i, k)] for l, k in vertices], facets)
                   for (i, j), vertices, facets in union.polytopes]
    if c.nearest:
        i, j = c.nearest
        c.weights_a = [[corner("a", i, k), w] for k, w in union.weights_a]
        c.weights_b = [[corner("b", j, l), w] for l, w in union.weights_b]
    bodies = [[[tuple(map(Fraction, p)) for p in piece] for piece in pieces] for pieces in c.bodies()]
    c.optima = [(t, blocks_of(bodies, [Fraction(x) for x in t] or [0, 0, 0], separations, c.claim)) for t, separations in union.optima]
    return c


def quartered(c):
    """The same, four times as small: points get several denominators."""
    times = lambda p: [str(Fraction(x) / 4) for x in p]
    for body in (c.a, c.b):
        if isinstance(body, Solid):
            body.points = list(map(times, body.points))
        else:
            body.pieces = [list(map(times, piece)) for piece in body.pieces]
    c.claim = [c.claim[0], *(str(Fraction(q) / 16) for q in c.claim[1:])]
    c.optima = [(times(t), blocks) for t, blocks in c.optima]
    return c


def solid_of(pieces):
    """Each piece is a component of its mesh."""
    hulls = [tilings.hull([tuple(map(Fraction, p)) for p in piece]) for piece in pieces]
    indexed = tilings.Tiling([t for facets in hulls for t in tilings.surface(facets)], hulls).indexed()
    words = lambda row: list(map(str, row))
    return Solid(indexed.points, [words(t) for t in indexed.mesh], [[words([len(f), *f]) for f in piece] for piece in indexed.pieces])


def renumbered(pieces, body):
    """The names of a piece's points among the corners of the body."""
    if isinstance(body, Pieces):
        return [list(map(str, range(len(piece)))) for piece in pieces]
    names = [{tuple(map(Fraction, p)): k for k, p in corners.items()} for corners in body.corners()]
    return [[of_piece.get(tuple(map(Fraction, p))) for p in piece] for piece, of_piece in zip(pieces, names)]


def dot(u, v):
    return sum(x * y for x, y in zip(u, v))


def blocks_of(bodies, t, separations, claim):
    """One vector for a block where one of its pairs has one that is good enough for all of it."""
    a, b = bodies
    vectors = [tuple(map(int, u)) for u in separations]

    def is_apart(u, rows, columns):
        h = max(dot(u, p) for j in columns for p in b[j]) - min(dot(u, p) for i in rows for p in a[i])
        if claim[0] == "apart":
            return h < 0 and h * h >= Fraction(claim[1]) * dot(u, u)
        return dot(u, t) >= h

    def block(rows, columns):
        candidates = sorted({vectors[i * len(b) + j] for i in rows for j in columns})
        found = next((u for u in candidates if is_apart(u, rows, columns)), None)
        if found or len(rows) == len(columns) == 1:
            return [list(map(str, found or candidates[0]))]
        split = rows if len(rows) >= len(columns) else columns
        halves = split[:len(split) // 2], split[len(split) // 2:]
        return [["a" if split is rows else "b"],
                *itertools.chain(*(block(half, columns) if split is rows else block(rows, half) for half in halves))]

    return block(range(len(a)), range(len(b)))
