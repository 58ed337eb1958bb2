# SPDX-License-Identifier: GPL-3.0-or-later
"""Vectors, and cores that are hulls of points: the least h(u) of all |u| = 1, kept as its square with its sign, and what proves it. Made by
definition: plain fractions, all subsets tried. Shares nothing with fathom or its checkers."""
import itertools
from fractions import Fraction
from math import gcd, isqrt, lcm

O = (0, 0, 0)
UNITS = ((1, 0, 0), (0, 1, 0), (0, 0, 1))


def dot(u, v):
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


def cross(u, v):
    return (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])


def plus(u, v):
    return tuple(x + y for x, y in zip(u, v))


def minus(u, v):
    return tuple(x - y for x, y in zip(u, v))


def times(x, u):
    return tuple(x * y for y in u)


def square(x):
    return x * abs(x)


def primitive(v):
    """The integer vector without a common divisor in the direction of v."""
    common = lcm(*(Fraction(x).denominator for x in v))
    v = [int(x * common) for x in v]
    return tuple(x // gcd(*v) for x in v)


def root(q, up, bits=24):
    """A rational near the root of |q|, with the sign of q: not below it if `up`, else not above it; the root itself if it is rational."""
    if q < 0:
        return -root(-q, not up, bits)
    q = Fraction(q)
    p, r = isqrt(q.numerator), isqrt(q.denominator)
    if p * p == q.numerator and r * r == q.denominator:
        return Fraction(p, r)
    below = isqrt(q.numerator * 4**bits // q.denominator)
    return Fraction(below + up, 2**bits)


class Core:
    """P of two lists of points: its value, and what proves it. Within, all is scaled to integers."""

    def __init__(self, a, b):
        self.scale = lcm(*(Fraction(x).denominator for p in a + b for x in p))
        whole = [[tuple(int(x * self.scale) for x in p) for p in body] for body in (a, b)]
        self.pairs = {}
        for (i, p), (j, q) in itertools.product(enumerate(whole[0]), enumerate(whole[1])):
            self.pairs.setdefault(minus(q, p), (j, i))
        self.points = list(self.pairs)
        self.facets = self.find_facets(*whole)
        self.inside = bool(self.facets) and all(c > 0 for _, c, _ in self.facets)
        if self.inside:
            self.value = min(self.squared(n, c) for n, c, _ in self.facets)
        else:
            self.weights = self.nearest()  # of differences: the point of P nearest to O
            self.z = combined(self.weights)
            self.value = -dot(self.z, self.z) / Fraction(self.scale**2)

    def squared(self, n, c):
        return Fraction(c * c, dot(n, n) * self.scale**2)

    def h(self, n):
        return max(dot(n, d) for d in self.points)

    @staticmethod
    def find_facets(a, b):
        """(outward normal, c, corners in order) of each facet; nothing if P is flat. Two edges of a facet with different directions are
        edges of A or B, moved: so every normal is across two lines, each through two points of one body."""
        lines = {max(u, times(-1, u)) for body in (a, b) for p, q in itertools.combinations(set(body), 2) for u in [primitive(minus(q, p))]}
        across, facets = (cross(u, v) for u, v in itertools.combinations(lines, 2)), []
        for n in sorted({primitive(times(s, n)) for n in across if any(n) for s in (1, -1)}):
            of_a, of_b = [dot(n, p) for p in a], [dot(n, q) for q in b]
            if min(of_a) == max(of_a) and min(of_b) == max(of_b):
                return []
            on = [minus(q, p) for q, y in zip(b, of_b) if y == max(of_b) for p, x in zip(a, of_a) if x == min(of_a)]
            if any(any(cross(minus(q, on[0]), minus(r, on[0]))) for q, r in itertools.combinations(on, 2)):
                facets.append((n, dot(n, on[0]), Core.in_order(n, on)))
        return facets

    @staticmethod
    def in_order(n, points):
        """The extreme ones, counter-clockwise seen from outside."""
        order, start = [], min(points)
        while not order or start != order[0]:
            order.append(start)
            other = next(p for p in points if p != start)
            for p in points:
                turn = dot(n, cross(minus(other, start), minus(p, start)))
                farther = dot(minus(p, start), minus(p, start)) > dot(minus(other, start), minus(other, start))
                if p != start and (turn < 0 or (turn == 0 and farther)):
                    other = p
            start = other
        return order

    def nearest(self):
        """Weights of the nearest point of P, O not being inside: of at most three differences."""
        for among in [corners for _, c, corners in self.facets if c <= 0] or [self.points]:
            for chosen in itertools.chain.from_iterable(itertools.combinations(among, size) for size in (1, 2, 3)):
                weights = foot(chosen)
                if weights and min(weights) > 0:
                    z = combined(dict(zip(chosen, weights)))
                    if all(dot(z, d) >= dot(z, z) for d in self.points):
                        return dict(zip(chosen, weights))
        raise AssertionError("no nearest point")

    def optima(self):
        """Primitive normals of the nearest facets, ascending."""
        return sorted(n for n, c, _ in self.facets if self.squared(n, c) == self.value)

    def cone(self):
        """(lineality, rays) of all u with h(u) = 0, by definition: the vectors that are orthogonal to two generators, or nearly so."""
        span = []
        for d in self.points:
            if (len(span) == 0 and any(d)) or (len(span) == 1 and any(cross(span[0], d))) or (len(span) == 2 and dot(cross(*span), d)):
                span.append(d)
        if not span:
            return list(UNITS), []
        if len(span) == 1:
            first = next(u for u in (cross(span[0], e) for e in UNITS) if any(u))
            lines = [first, cross(span[0], first)]
            candidates = span
        elif len(span) == 2:
            lines = [cross(*span)]
            candidates = [cross(lines[0], d) for d in self.points if any(d)]
        else:
            lines, candidates = [], [u for u in itertools.starmap(cross, itertools.combinations(self.points, 2)) if any(u)]
        candidates = {primitive(times(s, u)) for u in candidates for s in (1, -1)}
        return [primitive(u) for u in lines], sorted(u for u in candidates if self.h(u) <= 0)

    def proof_of_cone(self, lines, rays):
        """Differences, as few as the page asks for where there are three rays or more."""
        zeros = {d: frozenset(r for r in rays if dot(d, r) == 0) for d in self.points}
        if len(rays) >= 3:
            sides = {zero: d for d, zero in zeros.items() if len(zero) == 2}
            return list(sides.values())
        found = [next(d for d in self.points if zeros[d] == frozenset(rays) - {r}) for r in rays]
        flat = [d for d in self.points if len(zeros[d]) == len(rays) and any(d)]
        return found + (flat if len(lines) + len(rays) < 3 else [])


def combined(weights):
    """The sum of the points, each times its weight."""
    result = O
    for p, w in weights.items():
        result = plus(result, times(w, p))
    return result


def foot(points):
    """Weights, with sum 1, of the point nearest to O of the plane, line or point through these; None if they are dependent."""
    p, *others = points
    edges = [minus(q, p) for q in others]
    if len(edges) == 0:
        return [Fraction(1)]
    if len(edges) == 1:
        t = -Fraction(dot(p, edges[0])) / dot(edges[0], edges[0])
        return [1 - t, t]
    u, v = edges
    uu, uv, vv, pu, pv = dot(u, u), dot(u, v), dot(v, v), dot(p, u), dot(p, v)
    det = Fraction(uu * vv - uv * uv)
    if det == 0:
        return None
    s, t = (uv * pv - vv * pu) / det, (uv * pu - uu * pv) / det
    return [1 - s - t, s, t]
