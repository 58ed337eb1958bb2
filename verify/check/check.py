#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""FORMAT.md as a program, to be read: check.py FILE... (- is standard input). One verdict line per certificate; exit code 0 all
accepted, 1 some refused, 2 some malformed. Needs nothing but Python. fathom-check is the fast one."""
import os
import re
import sys
from fractions import Fraction
from math import gcd


Refused, Malformed = (type(name, (Exception,), {}) for name in ("Refused", "Malformed"))
NATURAL, INTEGER, RATIONAL = (re.compile(p) for p in (r"[0-9]+", r"-?[0-9]+", r"-?[0-9]+(/0*[1-9][0-9]*)?"))
ID = re.compile(r"id ([ -$&-~]|%[0-9A-Fa-f]{2})+\n")
NUMBERS = {"depth": 1, "bounds": 2, "touching": 0, "disjoint": 0}


def demand(true, reason, kind=Refused):
    if not true:
        raise kind(reason)


def dot(u, v):
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


def cross(u, v):
    return (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])


class Reader:
    """Section 2: the grammar. `number` is that of the line at hand, from 1."""

    def __init__(self, lines):
        self.lines, self.number = lines, 0

    def at(self):
        return self.lines[self.number - 1].decode("latin-1") if self.number <= len(self.lines) else ""

    def advance(self):
        self.number += 1
        while self.at().startswith("#") and self.at().endswith("\n"):
            self.number += 1

    def these(self, *shape):
        """The fields of the line at hand, by their shapes: a word, or a pattern."""
        found = self.at()[:-1].split(" ")
        good = self.at().endswith("\n") and len(found) == len(shape)
        good = good and all(f == s if isinstance(s, str) else s.fullmatch(f) for f, s in zip(found, shape))
        demand(good, "expected " + " ".join(s if isinstance(s, str) else s.pattern for s in shape), Malformed)
        return found

    def next(self, *shape):
        self.advance()
        return self.these(*shape)

    def rows(self, count, shape, number):
        return [tuple(map(number, self.next(*shape))) for _ in range(count)]

    def part(self, word, shape, number):
        return self.rows(int(self.next(word, NATURAL)[1]), shape, number)

    def facet(self):
        self.advance()
        found = self.these(*[NATURAL] * (self.at().count(" ") + 1))
        demand(int(found[0]) == len(found) - 1, "expected as many corners as announced", Malformed)
        return tuple(map(int, found[1:]))

    def certificate(self, c):
        self.these("fathom-certificate", "1")
        self.advance()
        if self.at().split(" ")[0].rstrip("\n") == "id":
            c["id"] = self.at()[3:-1] if ID.fullmatch(self.at()) else demand(False, "expected an id in printable ASCII", Malformed)
            self.advance()
        c["a"] = self.rows(int(self.these("a", NATURAL)[1]), [RATIONAL] * 3, Fraction)
        c["b"] = self.part("b", [RATIONAL] * 3, Fraction)
        self.advance()
        word = (self.at()[:-1].split(" ") + [""])[1]
        shape = [RATIONAL] * NUMBERS[word] if word in NUMBERS else demand(False, "expected a claim", Malformed)
        c["claim"], *bounds = self.these("claim", word, *shape)[1:]
        c["bounds"] = [Fraction(x) for x in bounds]
        _, count, c["which"] = self.next("directions", NATURAL, re.compile("some|all"))
        c["directions"] = self.rows(int(count), [INTEGER] * 3, int)
        if bounds:
            c["vertices"] = self.part("vertices", [NATURAL] * 2, int)
            c["facets"] = [self.facet() for _ in range(int(self.next("facets", NATURAL)[1]))]
        elif word == "touching":
            c["weights_a"] = self.part("weights_a", [NATURAL, RATIONAL], Fraction)
            c["weights_b"] = self.part("weights_b", [NATURAL, RATIONAL], Fraction)
        counts = [len(c["a"]), len(c["b"]), len(c["directions"])]
        counts += [len(c["vertices"] + c["weights_a"]), len(c["facets"] + c["weights_b"])]
        demand(list(map(int, self.next("end", *[NATURAL] * 5)[1:])) == counts, "expected the counts of the parts again", Malformed)


def check_inner(c, q):
    """The polytope Q inside P holds the ball of squared radius q."""
    for j, i in c["vertices"]:
        demand(j < len(c["b"]) and i < len(c["a"]), "a vertex without a point")
    vertices = [tuple(y - x for x, y in zip(c["a"][i], c["b"][j])) for j, i in c["vertices"]]
    demand(c["facets"], "no facet")
    planes, across = [], {}
    for f, corners in enumerate(c["facets"]):
        demand(len(corners) >= 3 and max(corners) < len(vertices), "a facet without corners")
        v = [vertices[k] for k in corners]
        normal = tuple(map(sum, zip(*(cross(v[k - 1], v[k]) for k in range(len(v))))))
        plane = dot(normal, v[0])
        planes.append((normal, plane))
        demand(plane > 0 and plane * plane >= q * dot(normal, normal), "a facet nearer than claimed")
        demand(all(dot(normal, w) == plane for w in v), "corners not on one plane")
        demand(all(dot(v[0], cross(v[k], v[k + 1])) > 0 for k in range(1, len(v) - 1)), "corners do not turn one way")
        for k in range(len(corners)):
            across.setdefault((corners[k], corners[k - 1]), f)  # seen from the other side; the first facet counts
        if c["which"] == "all" and plane * plane == q * dot(normal, normal):
            parallel = [n for n in c["directions"] if cross(n, normal) == (0, 0, 0) and dot(n, normal) > 0]
            demand(parallel, "a nearest facet that is not listed")
    for corners in c["facets"]:
        for k in range(len(corners)):
            u, v = corners[k - 1], corners[k]
            demand((u, v) in across, "an edge with one facet")
            normal, plane = planes[across[u, v]]
            demand(dot(normal, vertices[u]) == plane == dot(normal, vertices[v]), "an edge off the plane across")
            inward = cross(vertices[u], vertices[v])  # det(u, v, w) = <u x v, w>
            demand(any(dot(inward, vertices[w]) > 0 and dot(normal, vertices[w]) < plane for w in corners), "not convex across an edge")
    demand(any(dot(normal, planes[0][0]) < 0 for normal, _ in planes), "no facet faces away from the first")


def combination(weights, points):
    demand(all(i < len(points) and w > 0 for i, w in weights), "weights are positive, of points that exist")
    demand(sum(w for _, w in weights) == 1, "weights sum to 1")
    return [sum(w * points[int(i)][k] for i, w in weights) for k in range(3)]


def check(c):
    """Section 4. What is proved, for the verdict line."""
    claim, bounds, directions = c["claim"], c["bounds"], c["directions"]
    demand(c["a"] and c["b"] and directions, "no points, or no direction")
    demand(claim == "depth" or (len(directions) == 1 and c["which"] == "some"), "exactly one direction, and some")
    for n in directions:
        demand(any(n), "a direction that is zero proves nothing")
        h = max(dot(n, b) for b in c["b"]) - min(dot(n, a) for a in c["a"])
        if claim in ("depth", "bounds"):
            reached, allowed = h * h, bounds[-1] * dot(n, n)
            demand(h > 0 and (reached == allowed or (claim == "bounds" and reached < allowed)), "not the distance claimed")
        else:
            demand(h == 0 if claim == "touching" else h < 0, "O not on, or not above, the plane")
    if c["which"] == "all":
        demand(all(gcd(*n) == 1 for n in directions), "a direction that is not primitive")
        demand(all(n < m for n, m in zip(directions, directions[1:])), "directions not in ascending order")
    points = [combination(c["weights_" + x], c[x]) for x in "ab" if claim == "touching"]
    demand(points[:1] == points[1:], "weights of different points")
    if claim in ("touching", "disjoint"):
        return claim + " depth_squared=0"
    demand(0 <= bounds[0] <= bounds[-1] > 0 and (claim == "bounds" or bounds[0] > 0), "not the bounds of a depth")
    check_inner(c, bounds[0])
    if claim == "bounds":
        return "penetrating depth_squared_in=[%s,%s]" % tuple(bounds)
    return f"penetrating depth_squared={bounds[0]}" + (f" optima={len(directions)}" if c["which"] == "all" else "")


def verdicts(lines, name):
    """One (exit code, line) per certificate; at least one."""
    reader, any_yet = Reader(lines), False
    reader.advance()
    while reader.number <= len(lines) or not any_yet:
        any_yet, first = True, reader.number
        c = {"id": "", "vertices": [], "facets": [], "weights_a": [], "weights_b": []}
        try:
            reader.certificate(c)
            yield 0, f"s VERIFIED {check(c)} {c['id'] or name}"
            reader.advance()
        except Refused as error:
            yield 1, f"s REFUSED {c['id'] or name}:{reader.number}: {error}"
            reader.advance()
        except Malformed as error:
            yield 2, f"s MALFORMED {c['id'] or name}:{reader.number}: {error}"
            reader.number += reader.number == first
            while reader.number <= len(lines) and not reader.at().startswith("fathom-certificate"):
                reader.number += 1


def main(names):
    worst = 0 if names else 2
    for name in names:
        lines = []
        try:
            lines = (sys.stdin.buffer if name == "-" else open(name, "rb")).readlines()
        except OSError as error:
            print(f"c {error}")
        label = b"<stdin>" if name == "-" else re.sub(rb"[^ -$&-~]", lambda m: b"%%%02X" % m[0][0], os.fsencode(name))
        for code, line in verdicts(lines, label.decode()):
            print(line, flush=True)
            worst = max(worst, code)
    return worst


if __name__ == "__main__":
    getattr(sys, "set_int_max_str_digits", int)(0)  # no limit
    sys.exit(main(sys.argv[1:]))

