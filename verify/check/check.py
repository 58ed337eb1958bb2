#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""FORMAT.md as a program, to be read: check.py FILE... (- is standard input). One verdict line per certificate; exit code 0 all
accepted, 1 some refused, 2 some malformed. Needs nothing but Python. fathom-check is the fast one."""
import os
import re
import sys
from collections import Counter
from fractions import Fraction
from itertools import accumulate
from math import gcd, lcm

Refused, Malformed = (type(name, (Exception,), {}) for name in ("Refused", "Malformed"))
LONGEST_LINE, LONGEST_NUMBER, LONGEST_CERTIFICATE, MOST_NUMBERS = 2**24, 10**5, 10**9, 10**7
LARGEST_SIZE, MOST_WORK = 4 * 10**9, 10**14
NATURAL = re.compile("[0-9]{1,%d}" % LONGEST_NUMBER)
INTEGER = re.compile("-?" + NATURAL.pattern)
RATIONAL = re.compile(INTEGER.pattern + "(/(?!0+$)" + NATURAL.pattern + ")?")
TEXT = re.compile("([!-$&-~]|%[0-9A-Fa-f]{2})+")
NUMBERS = {1: {"depth": 1, "bounds": 2, "touching": 0, "disjoint": 0},  # of each format: how many a claim has
           2: {"depth": 1, "touching": 0, "apart": 1, "signed_bounds": 2},
           3: {"depth": 1, "touching": 0, "apart": 1},
           4: {"depth": 1, "touching": 0, "apart": 1},
           5: {"solid": 0},  # of one solid; those of two bodies are as in format 3
           6: {"apart": 0, "grazing": 0, "contact": 1}}
ATOMS = {"point": 1, "disc": 3, "ball": 4}  # vectors: the center, then the axes
PIECES = {"b": [INTEGER] * 3, "a": [INTEGER] * 3, "ab": [INTEGER] * 6, "near": [RATIONAL]}  # of a motion, behind their end


def demand(true, reason, kind=Refused):
    if not true:
        raise kind(reason)


def dot(u, v):
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


def cross(u, v):
    return (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])


def square(x):
    """x^[2], with the sign of x."""
    return x * abs(x)


def minus(u):
    return tuple(-x for x in u)


def towards(x, n):
    """The direction in which body x counts in h(n)."""
    return n if x == "b" else minus(n)


def rational(text):
    p, _, q = text.partition("/")
    return Fraction(int(p), int(q or 1))


class Reader:
    """Section 2: the grammar. `line` is the line at hand, None behind the last one; `number` its number, from 1."""

    def __init__(self, file):
        self.file, self.number, self.line, self.bytes, self.numbers = file, 0, "", 0, 0

    def step(self):
        """To the next line. One that is too long is read as an empty one, without a line feed."""
        line = part = self.file.readline(LONGEST_LINE + 1)
        while len(part) > LONGEST_LINE and not part.endswith(b"\n"):
            line, part = b"-", self.file.readline(LONGEST_LINE + 1)
        self.number += 1
        self.line = line.decode("latin-1") if line else None

    def advance(self):
        self.step()
        while self.line and self.line.startswith("#") and self.line.endswith("\n"):
            self.step()

    def fields(self):
        return (self.line or "")[:-1].split(" ")

    def these(self, *shape):
        """The fields of the line at hand, by their shapes: a word, or a pattern."""
        found, expected = self.fields(), "expected " + " ".join(s if isinstance(s, str) else s.pattern for s in shape[:6])
        demand(self.line and self.line.endswith("\n") and len(found) == len(shape), expected, Malformed)
        demand(all(f == s if isinstance(s, str) else s.fullmatch(f) for f, s in zip(found, shape)), expected, Malformed)
        self.bytes += len(self.line) - 1
        demand(self.bytes <= LONGEST_CERTIFICATE, f"a certificate of more than {LONGEST_CERTIFICATE} bytes", Malformed)
        return found

    def count_numbers(self, count):
        self.numbers += count
        demand(self.numbers <= MOST_NUMBERS, f"a certificate of more than {MOST_NUMBERS} numbers", Malformed)

    def row(self, *shape):
        self.advance()
        found = self.these(*shape)
        self.count_numbers(len(found))
        return found

    def header(self, word, *shape):
        """The line at hand announces a part: how many lines follow."""
        found = self.these(word, NATURAL, *shape)
        self.counts.append(int(found[1]))
        return range(self.counts[-1])

    def rows(self, count, shape, number):
        """The lines of a part. The line behind it is at hand afterwards."""
        found = [tuple(map(number, self.row(*shape))) for _ in count]
        self.advance()
        return found

    def part(self, word, shape, number):
        return self.rows(self.header(word), shape, number)

    def facets(self, word="facets"):
        found = []
        for _ in self.header(word):
            self.advance()
            row = self.these(*[NATURAL] * len(self.fields()))
            demand(int(row[0]) == len(row) - 1, "expected as many corners as announced", Malformed)
            self.count_numbers(len(row))
            found.append(tuple(map(int, row[1:])))
        self.advance()
        return found

    def term(self):
        """Its atoms, each a list of vectors."""
        self.advance()
        count, atoms = self.header("term"), []
        self.count_numbers(1)
        for _ in count:
            self.advance()
            kind = self.fields()[0]
            demand(kind in ATOMS, "expected an atom", Malformed)
            numbers = list(map(rational, self.these(kind, *[RATIONAL] * 3 * ATOMS[kind])[1:]))
            self.count_numbers(len(numbers))
            atoms.append([tuple(numbers[k:k + 3]) for k in range(0, len(numbers), 3)])
        return atoms

    def in_plane(self):
        return self.height is not None

    def points(self, x, levels=(-1, 1)):
        """Those of the plane stand once at each level, in heights: section 16."""
        found = self.part(x, [RATIONAL] * (2 if self.in_plane() else 3), rational)
        return [(*p, level * self.height) for level in levels for p in found] if self.in_plane() else found

    def half_space(self, word):
        numbers = list(map(rational, self.these(word, *[RATIONAL] * (3 if self.in_plane() else 4))[1:]))
        self.advance()
        return [*numbers[:2], 0, numbers[2]] if self.in_plane() else numbers

    def body(self, c, x):
        word = self.fields()[0] if c["format"] in (2, 4) else x
        if word == "shape_" + x and c["format"] == 2 and not self.in_plane():
            c["terms_" + x] = [self.term() for _ in self.header(word)]
            self.advance()
        elif word == "halfspace_" + x:
            c["halfspace_" + x] = self.half_space(word)
        else:
            c[x] = self.points(x, (0,) if x == "a" else (-1, 1))
        if c["format"] in (2, 4) and self.fields()[0] == "radius_" + x:
            c["radius_" + x] = rational(self.these("radius_" + x, RATIONAL)[1])
            self.advance()

    def claim(self, c, claims=None):
        word, claims = (self.fields() + [""])[1], claims or NUMBERS[c["format"]]
        demand(word in claims and not (self.in_plane() and word == "signed_bounds"), "expected a claim", Malformed)
        c["claim"], *bounds = self.these("claim", word, *[RATIONAL] * claims[word])[1:]
        c["bounds"] = [rational(q) for q in bounds]
        self.advance()

    def pieces(self, x):
        """The pieces of a union, each a list of points."""
        count, found = self.header("pieces_" + x), []
        self.advance()
        for _ in count:
            self.count_numbers(1)
            found.append(self.points(x))
        return found

    def separations(self):
        return self.part("separations", [INTEGER] * 3, int)

    def blocks(self):
        """Of an apart tree, each a word or a vector."""
        found = []
        for _ in self.header("apart"):
            self.advance()
            split = self.fields() in (["a"], ["b"])
            row = self.these(*(self.fields() if split else [INTEGER] * 3))
            self.count_numbers(len(row))
            found.append(row[0] if split else tuple(map(int, row)))
        self.advance()
        return found

    def optimum(self, apart):
        t = tuple(map(rational, self.these("optimum", *[RATIONAL] * 3)[1:]))
        self.count_numbers(3)
        self.advance()
        return t, apart()

    def indices(self, word):
        """Two on one line, behind a word."""
        i, j = self.these(word, NATURAL, NATURAL)[1:]
        self.count_numbers(2)
        self.advance()
        return int(i), int(j)

    def polytope(self):
        return *self.indices("polytope"), self.part("vertices", [NATURAL] * 2, int), self.facets()

    def tree(self):
        nodes = []
        for _ in self.header("tree"):
            self.advance()
            word, *rest = self.fields()
            demand(word == "leaf" or (word == "split" and rest), "expected split or leaf", Malformed)
            nodes.append((word, *map(int, self.these(word, *[NATURAL] * len(rest))[1:])))
            self.count_numbers(1 + len(rest))
        self.advance()
        return nodes

    def union(self, c):
        c["pieces_a"], c["pieces_b"] = self.pieces("a"), self.pieces("b")
        self.proof_of_unions(c, self.separations)

    def proof_of_unions(self, c, apart):
        self.claim(c, NUMBERS[3])
        c["optima"], c["polytopes"], c["tree"] = [], [], []
        if c["claim"] == "depth":
            count = self.header("optima")
            self.advance()
            c["optima"] = [self.optimum(apart) for _ in count]
            count = self.header("polytopes")
            self.advance()
            c["polytopes"] = [self.polytope() for _ in count]
            c["tree"] = self.tree()
        else:
            c["optima"] = [((0, 0, 0), apart())]
            c["nearest"] = self.indices("nearest")
            self.weights(c)

    def solid(self, x):
        points, mesh = self.part("solid_" + x, [RATIONAL] * 3, rational), self.part("mesh", [NATURAL] * 3, int)
        count, pieces = self.header("pieces"), []
        self.advance()
        for _ in count:
            self.count_numbers(1)
            pieces.append(self.facets("piece"))
        return points, mesh, pieces

    def solids(self, c):
        """One solid, or two bodies."""
        for x in "ab":
            if self.in_plane() or self.fields()[0] == "pieces_" + x:
                c["body_" + x] = Body(self.pieces(x))
            else:
                c["body_" + x] = Body(solid=self.solid(x))
                if x == "a" and self.fields()[0] == "claim":
                    return self.claim(c)
        return self.proof_of_unions(c, self.blocks)

    def weights(self, c):
        c["weights_a"] = self.part("weights_a", [NATURAL, RATIONAL], rational)
        c["weights_b"] = self.part("weights_b", [NATURAL, RATIONAL], rational)

    def motion(self, word):
        """Two quaternions, two places."""
        self.these(word)
        found = [tuple(map(rational, self.row(*[RATIONAL] * count))) for count in (4, 4, 3, 3)]
        self.advance()
        return found

    def motions(self, c):
        c["a"], c["b"] = self.points("a"), self.points("b")
        c["motion_a"], c["motion_b"] = self.motion("motion_a"), self.motion("motion_b")
        self.claim(c)
        count, c["pieces"] = self.header("pieces"), []
        self.advance()
        for _ in count:
            kind = (self.fields() + [""])[1]
            demand(kind in PIECES, "expected a piece", Malformed)
            end, _, *row = self.these(RATIONAL, kind, *PIECES[kind])
            self.count_numbers(1 + len(row))
            self.advance()
            near = {}
            if kind == "near":
                self.weights(near)
            c["pieces"].append((kind, rational(end), [*map(rational, row)], near))
        if c["claim"] == "contact":
            self.weights(c)

    def certificate(self, c):
        self.bytes, self.numbers, self.counts, self.height = 0, 0, [], None
        c["format"] = int(self.these("fathom-certificate", re.compile("[123456]"))[1])
        self.advance()
        if self.fields()[0] == "id":
            c["id"] = self.these("id", TEXT)[1]
            self.advance()
        if self.fields()[0] == "plane" and c["format"] not in (4, 6):
            self.height = c["height"] = rational(self.these("plane", RATIONAL)[1])
            self.advance()
        {3: self.union, 5: self.solids, 6: self.motions}.get(c["format"], self.convex)(c)
        if c["format"] == 4:
            self.patches(c)
        counts = self.counts + [0] * (5 - len(self.counts) if c["format"] == 1 else 0)
        demand(list(map(int, self.these("end", *[NATURAL] * len(counts))[1:])) == counts, "expected the counts of the parts again",
               Malformed)

    def convex(self, c):
        self.body(c, "a")
        self.body(c, "b")
        shapes, plane = [x for x in "ab" if c["terms_" + x] is not None], c["halfspace_a"] or c["halfspace_b"]
        demand(not shapes or self.fields()[1:2] == ["signed_bounds"], "expected a claim of bounds", Malformed)
        self.claim(c)
        word = c["claim"]
        c["which"] = self.fields()[-1]
        c["directions"] = self.rows(self.header("directions", re.compile("some|all")), [INTEGER] * 3, int)
        for x in shapes:
            c["heights_" + x] = [t for t, in self.part("heights_" + x, [RATIONAL], rational)]
        for x in shapes:
            c["inner_" + x] = self.part("inner_" + x, [NATURAL, *[RATIONAL] * 3] * len(c["terms_" + x]), rational)
        facets = word in ("depth", "bounds") or (word == "signed_bounds" and self.fields()[0] == "vertices")
        if facets and not plane:
            c["vertices"] = self.part("vertices", [NATURAL] * 2, int)
            c["facets"] = self.facets()
        elif word != "disjoint" and not plane:
            self.weights(c)
        if c["format"] in (2, 4) and word == "touching" and not plane and self.fields()[0] == "lineality":
            c["cone"] = True
            c["lineality"] = self.part("lineality", [INTEGER] * 3, int)
            c["rays"] = self.part("rays", [INTEGER] * 3, int)
            c["differences"] = self.part("differences", [NATURAL] * 2, int)

    def corner(self):
        """Two lists of weights: of points of a, and of b."""
        self.advance()
        row, found = self.these(*[RATIONAL] * len(self.fields())), []
        self.count_numbers(len(row))
        for _ in "ab":
            demand(row and NATURAL.fullmatch(row[0]), "expected the number of weights", Malformed)
            count = int(row[0])
            indices, weights, row = row[1:2 * count + 1:2], row[2:2 * count + 1:2], row[2 * count + 1:]
            demand(len(weights) == count and all(map(NATURAL.fullmatch, indices)), "expected as many weights as announced", Malformed)
            found.append([(int(i), rational(w)) for i, w in zip(indices, weights)])
        demand(not row, "expected the end of the corner", Malformed)
        return found

    def patches(self, c):
        count = self.header("patches")
        self.advance()
        for _ in count:
            corners, sides = map(int, self.these("patch", NATURAL, NATURAL)[1:])
            self.count_numbers(2)
            self.counts += [corners, sides]
            corners = [self.corner() for _ in range(corners)]
            rows = [self.row(re.compile("[ab]"), *[INTEGER] * 3, NATURAL) for _ in range(sides)]
            c["patches"].append((corners, [(x, tuple(map(int, m)), int(k)) for x, *m, k in rows]))
            self.advance()
        if self.fields()[0] == "rates":
            c["rates"] = self.part("rates", [*[RATIONAL] * 6, INTEGER, RATIONAL], rational)


def widest(numbers):
    return max((abs(n).bit_length() for n in numbers), default=0)


def common_denominator(numbers, vectors):
    """Of these numbers, and how wide they become over it."""
    common = 1
    for denominator in {x.denominator for x in numbers}:
        common = lcm(common, denominator)
        demand(vectors * common.bit_length() <= LARGEST_SIZE, f"a certificate of a size above {LARGEST_SIZE}", Malformed)
    return common, common.bit_length() + widest(x.numerator for x in numbers)


def cost(s, t):
    return (256 + max(s, t)) * (256 + min(s, t, 4000))


def require_limits(c):
    """Section 8: size and work. From here on the points and the weights are integers, over common denominators."""
    points, weights = c["a"] + c["b"], c["weights_a"] + c["weights_b"]
    points += [v for x in "ab" for term in c["terms_" + x] or [] for atom in term for v in atom]
    parameters = [y for row in c["inner_a"] + c["inner_b"] for k, y in enumerate(row) if k % 4]
    places, heights = len(parameters) // 3, c["heights_a"] + c["heights_b"]
    facets, rays, differences = c["facets"] or [], c["rays"], len(c["differences"])
    vectors = len(points) + places + len(c["vertices"]) + 3 * len(facets) + differences
    c["unit"], w = common_denominator([x for p in points for x in p], vectors)
    c["fine"], y = common_denominator(parameters, vectors)
    c["whole"], x = common_denominator([weight for _, weight in weights], len(weights))
    _, g = common_denominator(heights, len(heights))
    v = w + y if places else w
    size = vectors * v + len(weights) * x + len(heights) * g
    demand(size <= LARGEST_SIZE, f"a certificate of a size above {LARGEST_SIZE}", Malformed)
    directions, sides = len(c["directions"]) + len(rays) + 2 * len(c["lineality"]), [m for _, sides in c["patches"] for _, m, _ in sides]
    u = widest(n for row in c["directions"] + rays + c["lineality"] + sides for n in row)
    numbers = [n for q in c["bounds"] + ([c["radius_a"], c["radius_b"]] if c["format"] != 1 else []) for n in q.as_integer_ratio()]
    b = widest(numbers) if c["format"] == 1 else 2 * sum(map(int.bit_length, numbers))
    work = (len(points) + places) * directions * cost(v, u)
    work += (len(points) + 4 * places + 4 * sum(len(corners)**2 for corners in facets)) * cost(v, v)
    work += 4 * (directions + len(facets)) * cost(v, b)
    work += 4 * len(weights) * cost(v + x, v + x)
    work += 4 * len(points) * cost(v + u + g, v + u + g) if heights else 0
    work += differences * (len(rays) + differences) * cost(v + u, v + u)
    work += work_of_patches(c, v, u, size)
    demand(work <= MOST_WORK, f"a certificate of work above {MOST_WORK}", Malformed)
    fine = c["unit"] * c["fine"]
    for x in "ab":
        c[x] = [scaled(p, fine) for p in c[x]]
        c["terms_" + x] = c["terms_" + x] and [[[scaled(v, fine) for v in atom] for atom in term] for term in c["terms_" + x]]
        c["weights_" + x] = [(int(i), w.numerator * (c["whole"] // w.denominator)) for i, w in c["weights_" + x]]
    c["unit"] = fine


def work_of_patches(c, v, u, size):
    """Section 13. With v, u and the size so far."""
    corners = [[w for each in corner for _, w in each] for corners, _ in c["patches"] for corner in corners]
    sides, vectors = sum(len(sides) for _, sides in c["patches"]), sum(map(len, corners)) + 2 * len(corners)
    x = max((common_denominator(weights, vectors)[1] for weights in corners), default=0)
    demand(size + vectors * (v + x) <= LARGEST_SIZE, f"a certificate of a size above {LARGEST_SIZE}", Malformed)
    r = max((sum(abs(n).bit_length() for q in (*rate[:6], rate[7]) for n in q.as_integer_ratio()) for rate in c["rates"]), default=0)
    work = sides * (len(c["a"]) + len(c["b"])) * cost(v, u) + 4 * sides * cost(v + x + u, 2 * u)
    work += 4 * (vectors + 6 * len(corners)) * cost(v + x + 2 * u, v + x + 2 * u)
    return work + 8 * len(c["rates"]) * len(corners) * cost(v + x + u + r, v + x + u + r)


def require_union_limits(c):
    """Section 12: the same of unions. From here on the points and the weights are integers, over common denominators."""
    pieces, weights, depth = c["pieces_a"] + c["pieces_b"], c["weights_a"] + c["weights_b"], c["claim"] == "depth"
    points = [p for piece in pieces for p in piece]
    corners = [len(corners) for polytope in c["polytopes"] for corners in polytope[3]]
    vectors = len(points) + sum(len(polytope[2]) for polytope in c["polytopes"]) + 3 * len(corners)
    c["unit"], w = common_denominator([x for p in points for x in p], vectors)
    c["whole"], x = common_denominator([weight for _, weight in weights], len(weights))
    _, e = common_denominator([x for t, _ in c["optima"] for x in t], len(c["optima"])) if depth and c["optima"] else (1, 0)
    separations = [u for _, each in c["optima"] for u in each]
    u, v = widest(x for u in separations for x in u), w + 32
    size = vectors * v + len(separations) * u + len(c["optima"]) * e + len(weights) * x
    demand(size <= LARGEST_SIZE, f"a certificate of a size above {LARGEST_SIZE}", Malformed)
    b = widest(n for q in c["bounds"] for n in q.as_integer_ratio())
    products = len(c["optima"]) * sum(len(c["pieces_" + y]) * sum(map(len, c["pieces_" + x])) for x, y in ("ab", "ba"))
    leaves = [len(node) - 1 for node in c["tree"] if node[0] == "leaf"]
    work = products * cost(w + e, u) + 16 * (len(points) + sum(k**2 for k in corners)) * cost(v, v)
    work += 4 * len(weights) * cost(v + x, v + x) + 8 * leaves.count(4) * cost(9 * v, 9 * v)
    for r, count in enumerate([len(corners), leaves.count(1), leaves.count(2), leaves.count(3)]):  # a facet is done by itself
        work += 16 * count * cost((4 * r + 3) * v + b, (4 * r + 3) * v + b + e)
    demand(work <= MOST_WORK, f"a certificate of work above {MOST_WORK}", Malformed)
    for x in "ab":
        c["pieces_" + x] = [[scaled(p, c["unit"]) for p in piece] for piece in c["pieces_" + x]]
        c["weights_" + x] = [(int(i), w.numerator * (c["whole"] // w.denominator)) for i, w in c["weights_" + x]]


class Body:
    """Of format 5. Each piece has the numbers of its corners among the points."""

    def __init__(self, pieces=(), solid=None):
        ends = [*accumulate(map(len, pieces), initial=0)]
        self.points, self.mesh, self.facets = solid or ([p for piece in pieces for p in piece], None, [])
        self.pieces = [range(*between) for between in zip(ends, ends[1:])]
        self.pieces += [{k for f in facets for k in f if k < len(self.points)} for facets in self.facets]
        units = [lcm(*(x.denominator for x in p)) for p in self.points]  # x y z w, integers, stand for x/w, y/w, z/w, with w > 0
        self.homogeneous = [(*scaled(p, unit), unit) for p, unit in zip(self.points, units)]

    def corner(self, i, k):
        """The number of corner k of piece i; None if there is none."""
        corners = self.pieces[i] if i < len(self.pieces) else ()
        k += corners[0] if self.mesh is None and corners else 0
        return k if k in corners else None


def size_and_work(bodies):
    """Section 14, and h."""
    h = max((p[3].bit_length() + widest(p[:3]) for body in bodies for p in body.homogeneous), default=0)
    triangles = sum(len(body.mesh or ()) for body in bodies)
    corners = sum(len(f) for body in bodies for facets in body.facets for f in facets)
    corners += sum(len(body.points) for body in bodies if body.mesh is None)
    products = sum(len(facets) * len(named) for body in bodies for facets, named in zip(body.facets, body.pieces))
    size = (sum(len(body.points) for body in bodies) + 10 * triangles + 4 * corners) * h
    return size, 3 * (3 * triangles + corners) * cost(4 * h, 4 * h) + products * cost(5 * h, h), h


def require_solid_limits(c):
    size, work, _ = size_and_work([c["body_a"]])
    demand(size <= LARGEST_SIZE, f"a certificate of a size above {LARGEST_SIZE}", Malformed)
    demand(work <= MOST_WORK, f"a certificate of work above {MOST_WORK}", Malformed)


def require_limits_of_two(c):
    """Section 15; those of the tree come later."""
    a, b = bodies = c["body_a"], c["body_b"]
    size, work, h = size_and_work(bodies)
    for _, _, vertices, facets in c["polytopes"]:
        size += (2 * len(vertices) + 12 * len(facets)) * h
        named = {k for f in facets for k in f if k < len(vertices)}
        work += 3 * sum(map(len, facets)) * cost(8 * h, 8 * h) + len(facets) * len(named) * cost(10 * h, 2 * h)
    depth, vectors = c["claim"] == "depth", [u for _, blocks in c["optima"] for u in blocks if u not in ("a", "b")]
    u, c["b"] = widest(x for v in vectors for x in v), widest(n for q in c["bounds"] for n in q.as_integer_ratio())
    _, c["e"] = common_denominator([x for t, _ in c["optima"] for x in t], len(c["optima"])) if depth and c["optima"] else (1, 0)
    weights = c["weights_a"] + c["weights_b"]
    numbers = [w for _, w in weights]
    for x, body, i in zip("ab", bodies, c.get("nearest", ())):
        named = {body.corner(i, int(k)) for k, _ in c["weights_" + x]} - {None}
        numbers += [y for k in named for y in body.points[k]]
    x = common_denominator(numbers, len(weights))[1] if weights else 0
    size += len(vectors) * u + len(c["optima"]) * c["e"] + len(weights) * x
    demand(size <= LARGEST_SIZE, f"a certificate of a size above {LARGEST_SIZE}", Malformed)
    sums = [[*accumulate(map(len, body.pieces), initial=0)] for body in bodies]
    products = 0
    for _, blocks in c["optima"]:
        for _, *both in ranges(blocks, len(a.pieces), len(b.pieces))[0]:
            products += sum(of_body[pieces.stop] - of_body[pieces.start] for of_body, pieces in zip(sums, both))
    z = 4 * h + 2 * u + c["b"] + c["e"]
    work += 4 * products * cost(h + u, h) + 8 * len(vectors) * cost(z, z) + 4 * len(weights) * cost(2 * x, 2 * x)
    demand(work <= MOST_WORK, f"a certificate of work above {MOST_WORK}", Malformed)
    c["work"] = work
    for x in "ab":
        c["weights_" + x] = [(int(k), w) for k, w in c["weights_" + x]]


def require_motion_limits(c):
    """Section 17. From here on there are only integers, but for times and distances."""
    motions, pieces = [c["motion_a"], c["motion_b"]], c["pieces"]
    ends = [near for kind, *_, near in pieces if kind == "near"] + [c] * (c["claim"] == "contact")
    weights, points = [w for near in ends for x in "ab" for w in near["weights_" + x]], len(c["a"]) + len(c["b"])
    places = [p for motion in motions for p in motion[2:]]
    c["unit"], w = common_denominator([x for p in c["a"] + c["b"] + places for x in p], points + 4)
    turning, y = common_denominator([x for motion in motions for q in motion[:2] for x in q], 4)
    c["whole"], x = common_denominator([weight for _, weight in weights], len(weights))
    planes = [row for kind, _, row, _ in pieces if kind != "near"]
    u = widest(n.numerator for row in planes for n in row)
    size = (points + 4) * w + 4 * y + len(weights) * x + 2 * len(planes) * u
    demand(size <= LARGEST_SIZE, f"a certificate of a size above {LARGEST_SIZE}", Malformed)
    numbers = [e for _, e, _, _ in pieces] + [row[0] for kind, _, row, _ in pieces if kind == "near"] + c["bounds"]
    b = max((sum(abs(n).bit_length() for n in q.as_integer_ratio()) for q in numbers), default=1)
    z = 2 * w + 4 * y + 12 * b + 2 * u + 32
    work = 6 * points * len(planes) * cost(z, w) + (200 * len(planes) + 8 * points * len(ends)) * cost(z, z)
    work += 4 * len(weights) * cost(z + x, z + x)
    demand(work <= MOST_WORK, f"a certificate of work above {MOST_WORK}", Malformed)
    for x, motion in zip("ab", motions):
        c[x] = [scaled(p, c["unit"]) for p in c[x]]
        c["motion_" + x] = [scaled(q, turning) for q in motion[:2]] + [scaled(p, c["unit"]) for p in motion[2:]]
    for near in ends:
        for x in "ab":
            near["weights_" + x] = [(int(i), w.numerator * (c["whole"] // w.denominator)) for i, w in near["weights_" + x]]


def spend(c, planes, r=0):
    """Section 15: the work of facets, or of a leaf with r constraints of these planes."""
    p = widest(x for n, h in planes for x in (*n, h))
    y = (2 * r + 2) * (p + 8) + c["b"]
    c["work"] += 8 * cost(5 * p + 40, 5 * p + 40) if r == 4 else 16 * cost(y, y + c["e"])
    demand(c["work"] <= MOST_WORK, f"a certificate of work above {MOST_WORK}", Malformed)


def scaled(numbers, unit):
    return tuple(q.numerator * (unit // q.denominator) for q in numbers)


def inner_point(terms, row):
    """The sum over the terms of a point of an atom, each given by the atom's number and its parameters y."""
    total = [0, 0, 0]
    for k, term in enumerate(terms):
        i, *y = row[4 * k:4 * k + 4]
        demand(i < len(term), "there is no atom of this number")
        demand(sum(p * p for p in y) <= 1, "parameters outside of the unit ball")
        center, *axes = term[int(i)]
        total = [t + x + sum(p * axis[m] for p, axis in zip(y, axes)) for m, (t, x) in enumerate(zip(total, center))]
    return tuple(map(int, total))  # they are integers, as all is over the common denominators


def require_bodies(c):
    """What every claim demands of the bodies. From here on each has its core points."""
    demand(not (c["halfspace_a"] and c["halfspace_b"]), "two half-spaces")
    for x in "ab":
        terms, plane = c["terms_" + x], c["halfspace_" + x]
        demand(c["radius_" + x] >= 0, "a negative radius")
        demand(plane is None or any(plane[:3]), "a half-space without a normal")
        if terms is not None:
            demand(terms and all(terms), "a shape without terms, or a term without atoms")
            c[x] = [inner_point(terms, row) for row in c["inner_" + x]]
        demand(c[x] or plane, "no points")


def support(c, x, s):
    return max(dot(s, p) for p in c[x])


def height(c, x, s):
    """H_X(s): not below <s,p> for any p in the core."""
    if c["halfspace_" + x]:
        *m, d = c["halfspace_" + x]
        demand(not any(cross(s, m)) and dot(s, m) > 0, "a direction that is not the half-space's")
        return d * c["unit"] * dot(s, m) / dot(m, m)
    terms, heights = c["terms_" + x], c["heights_" + x]
    if terms is None:
        return support(c, x, s)
    demand(len(heights) == len(terms), "expected one height for each term")
    for t, term in zip(heights, terms):
        for center, *axes in term:
            demand(square(t * c["unit"] - dot(s, center)) >= sum(dot(s, u)**2 for u in axes), "a height that is too small")
    return sum(heights) * c["unit"]


def differences(a, b, pairs):
    demand(all(j < len(b) and i < len(a) for j, i in pairs), "a difference without a point")
    return [tuple(y - x for x, y in zip(a[i], b[j])) for j, i in pairs]


def plane_through(corners):
    """Its normal N, and <N,v> of each corner v."""
    normal = tuple(map(sum, zip(*(cross(corners[k - 1], corners[k]) for k in range(len(corners))))))
    return normal, dot(normal, corners[0])


def check_inner(vertices, facets, q, listed=None):
    """The polytope holds the ball round O of squared radius q. If normals are listed, then those of all facets at that distance."""
    demand(facets, "no facet")
    planes, across = [], {}
    for f, corners in enumerate(facets):
        demand(len(corners) >= 3 and max(corners) < len(vertices), "a facet without corners")
        v = [vertices[k] for k in corners]
        normal, plane = plane_through(v)
        planes.append((normal, plane))
        reached, needed = plane * plane * q.denominator, q.numerator * dot(normal, normal)
        demand(plane > 0 and reached >= needed, "a facet nearer than claimed")
        demand(all(dot(normal, w) == plane for w in v), "corners not on one plane")
        demand(all(dot(v[0], cross(v[k], v[k + 1])) > 0 for k in range(1, len(v) - 1)), "corners do not turn one way")
        for k in range(len(corners)):
            across.setdefault((corners[k], corners[k - 1]), f)  # seen from the other side; the first facet counts
        if listed is not None and reached == needed:
            demand(tuple(x // gcd(*normal) for x in normal) in listed, "a nearest facet that is not listed")
    for corners in facets:
        for k in range(len(corners)):
            u, v = corners[k - 1], corners[k]
            demand((u, v) in across, "an edge with one facet")
            normal, plane = planes[across[u, v]]
            demand(dot(normal, vertices[u]) == plane == dot(normal, vertices[v]), "an edge off the plane across")
            inward = cross(vertices[u], vertices[v])  # det(u, v, w) = <u x v, w>
            demand(any(dot(inward, vertices[w]) > 0 and dot(normal, vertices[w]) < plane for w in corners), "not convex across an edge")
    demand(any(dot(normal, planes[0][0]) < 0 for normal, _ in planes), "no facet faces away from the first")


def combination(weights, points, whole):
    demand(all(i < len(points) and w > 0 for i, w in weights), "weights are positive, of points that exist")
    demand(sum(w for _, w in weights) == whole, "weights sum to 1")
    return [sum(w * points[i][k] for i, w in weights) for k in range(3)]


def check_cone(c):
    """Exactly the sums of multiples of the lineality and multiples >= 0 of the rays have h = 0."""
    lines, rays = c["lineality"], c["rays"]
    k, r = len(lines), len(rays)
    demand(k < 2 or any(cross(lines[0], lines[1])), "lineality vectors that are not independent")
    demand(k < 4 and all(map(any, lines)) and (k < 3 or dot(lines[0], cross(lines[1], lines[2]))),
           "lineality vectors that are not independent")
    for u in rays + lines + [minus(l) for l in lines]:
        demand(sum(support(c, x, towards(x, u)) for x in "ab") == 0, "a vector of the cone with h > 0")
    demand(all(gcd(*u) == 1 and not any(dot(u, l) for l in lines) for u in rays), "a ray that is not primitive, or not orthogonal")
    demand(all(u < v for u, v in zip(rays, rays[1:])) and k + r >= 1, "rays not in ascending order, or none")
    across = differences(c["a"], c["b"], c["differences"])
    zeros = [frozenset(i for i, u in enumerate(rays) if dot(d, u) == 0) for d in across]
    if r >= 3:
        sides = Counter(i for zero in set(zeros) for i in zero)
        demand(all(len(zero) == 2 for zero in zeros), "a difference that is not orthogonal to two rays")
        return demand(all(sides[i] >= 2 for i in range(r)), "a ray that is not the end of two sides")
    demand(k + r <= 3 and (r < 2 or any(cross(*rays))), "too many vectors, or opposite rays")
    for i in range(r):
        demand({*range(r)} - {i} in zeros, "the cone may go on behind a ray")
    flat = [d for d, zero in zip(across, zeros) if len(zero) == r]
    if k + r == 2:
        demand(any(dot(d, e) < 0 for d in flat for e in flat), "the cone may be wider")
    if k + r == 1:
        p, = lines + rays
        demand(flat and all(any(dot(p, cross(d, e)) > 0 for e in flat) for d in flat), "the cone may be wider")


def check(c):
    """Section 4. What is proved, for the verdict line."""
    claim, bounds, directions = c["claim"], c["bounds"], c["directions"]
    demand(directions and all(map(any, directions)), "no direction, or one that is zero and proves nothing")
    demand(claim == "depth" or (len(directions) == 1 and c["which"] == "some"), "exactly one direction, and some")
    require_bodies(c)
    rho, plane = c["radius_a"] + c["radius_b"], c["halfspace_a"] or c["halfspace_b"]
    demand(claim not in ("depth", "apart") or bounds[0] > 0, "a distance that is not positive")
    demand(claim != "bounds" or 0 <= bounds[0] <= bounds[1] > 0, "not the bounds of a depth")
    demand(bounds[:1] <= bounds[-1:], "a lower bound above the upper one")
    # What is claimed of h(n)/|n|, squared with its sign, in the units of the points.
    of_cores = {"apart": [-q for q in bounds], "signed_bounds": [square(x - rho) for x in bounds]}.get(claim, bounds or [0])
    least, most = of_cores[0] * c["unit"]**2, of_cores[-1] * c["unit"]**2
    for n in directions:
        h = square(sum(height(c, x, towards(x, n)) for x in "ab"))
        demand(h < 0 if claim == "disjoint" else h <= most * dot(n, n), "the boundary of P is farther than claimed")
        demand(claim in ("bounds", "disjoint", "signed_bounds") or h == most * dot(n, n), "the boundary of P is nearer than claimed")
    if c["which"] == "all":
        demand(all(gcd(*n) == 1 for n in directions), "a direction that is not primitive")
        demand(all(n < m for n, m in zip(directions, directions[1:])), "directions not in ascending order")
    if plane:
        demand(len(directions) == 1 and c["which"] == "some", "a half-space has one direction")
        h = square(sum((height if c["halfspace_" + x] else support)(c, x, towards(x, directions[0])) for x in "ab"))
        demand(h >= least * dot(directions[0], directions[0]), "the boundary of P may be nearer than claimed")
    elif c["facets"] is not None:
        listed = set(directions) if c["which"] == "all" else None
        check_inner(differences(c["a"], c["b"], c["vertices"]), c["facets"], max(least, 0), listed)
    elif claim != "disjoint":
        a, b = (combination(c["weights_" + x], c[x], c["whole"]) for x in "ab")
        z = [y - x for x, y in zip(a, b)]
        demand(dot(z, z) <= -least * c["whole"]**2, "weights of points too far from each other")
    if c["cone"]:
        check_cone(c)
    if c["format"] == 4:
        check_patches(c)
    return proved(c, rho)


def check_patches(c):
    """Section 13."""
    directions, plane = c["directions"], c["halfspace_a"] or c["halfspace_b"]
    demand(len(c["patches"]) == len(directions), "expected one patch for each direction")
    patches = [(n, check_patch(c, n, *patch)) for n, patch in zip(directions, c["patches"])]
    demand(not c["rates"] or plane or c["claim"] == "apart" or c["which"] == "all", "a rate without all optimal directions")
    for rate in c["rates"]:
        check_rate(c, patches, rate)


def check_patch(c, n, corners, sides):
    """The p in A with p + t in B are the hull of the corners that are returned, and these are its extreme points. t = (h(n)/<n,n>) n."""
    h = sum(height(c, x, towards(x, n)) for x in "ab")
    level = {x: support(c, x, towards(x, n)) for x in "ab" if c[x]}  # of its face; a half-space has no points
    face = {x: [p for p in c[x] if dot(towards(x, n), p) == level[x]] for x in level}
    found = []
    for corner in corners:
        demand(all(bool(weights) == (x in level) for x, weights in zip("ab", corner)), "weights of a half-space, or none of points")
        whole = lcm(*(w.denominator for weights in corner for _, w in weights))
        whole_weights = {x: [(i, int(w * whole)) for i, w in weights] for x, weights in zip("ab", corner)}
        end = {x: combination(whole_weights[x], c[x], whole) for x in level}
        demand(all(dot(towards(x, n), p) == level[x] * whole for x, p in end.items()), "a corner that is not in the faces")
        demand(len(end) < 2 or all(dot(n, n) * (q - p) == h * whole * k for p, q, k in zip(end["a"], end["b"], n)), "ends that do not meet")
        found.append(tuple(Fraction(x, whole) for x in next(iter(end.values()))))
    demand(len(set(found)) == len(found), "two corners at one point")
    demand(sides and {k for *_, k in sides} == {*range(len(found))}, "no side, one without its corner, or a corner without a side")
    demand(all(x in level and dot(n, m) == 0 for x, m, _ in sides), "a side of a half-space, or not orthogonal to the direction")
    for l, (x, m, k) in enumerate(sides):
        _, before, other = sides[l - 1]
        lowest = min(dot(m, p) for p in face[x])
        demand(dot(n, cross(before, m)) > 0, "sides that do not turn one way")
        demand(dot(m, found[k]) == lowest == dot(m, found[other]), "a side that passes by its corner")
    return found


def check_rate(c, patches, rate):
    """As A moves with the velocity v + w x p at each of its points p, the signed depth grows at the rate sign sqrt(root)."""
    v, w, (sign, root) = [x * c["unit"] for x in rate[:3]], rate[3:6], rate[6:]
    demand(sign in (-1, 0, 1) and root >= 0 and (sign == 0) == (root == 0), "no number with a sign")
    fastest = [max(-dot(n, v) - dot(n, cross(w, p)) for p in corners) for n, corners in patches]
    least = min(Fraction(square(speed), dot(n, n)) for speed, (n, _) in zip(fastest, patches))
    demand(least == sign * root * c["unit"]**2, "another rate than claimed")


def require_height(c):
    """Section 16: no way out of the raised bodies that is not longer than the depth leaves the plane."""
    left = c["height"] - c["radius_a"] - c["radius_b"]
    demand(left > 0, "a height that is not above the radii")
    demand(c["claim"] not in ("depth", "bounds") or c["bounds"][-1] < left**2, "a height that is not above the depth")


def proved(c, rho):
    """For the verdict line."""
    claim, bounds = c["claim"], c["bounds"]
    optima = f" optima={len(c['directions'])}" if c["which"] == "all" else ""
    if c["format"] == 1 and claim == "bounds":
        return "penetrating depth_squared_in=[%s,%s]" % tuple(bounds)
    if c["format"] == 1:
        return f"{claim} depth_squared=0" if not bounds else f"penetrating depth_squared={bounds[0]}{optima}"
    if claim == "signed_bounds":
        low, high = bounds
        status = "penetrating" if low > 0 else "disjoint" if high < 0 else "touching" if low == high else "undecided"
        return f"{status} signed_depth_in=[{low},{high}]"
    value = square(rho) - bounds[0] if claim == "apart" else rho + sum(bounds)  # has the sign of the signed depth
    status = "penetrating" if value > 0 else "disjoint" if value < 0 else "touching"
    cone = f" cone={len(c['lineality'])}+{len(c['rays'])}" if c["cone"] else ""
    patches = f" patches={'+'.join(str(len(corners)) for corners, _ in c['patches'])}" if c["format"] == 4 else ""
    rates = f" rates={len(c['rates'])}" if c["rates"] else ""
    return f"{status} signed_depth={'-' if claim == 'apart' else ''}sqrt({bounds[0] if bounds else 0})+{rho}{optima}{cone}{patches}{rates}"


def has_interior(points):
    """Whether some four of them, each x y z w, do not lie in one plane."""
    edges = [edge(points[0], p) for p in points]
    u = next(filter(any, edges), (0, 0, 0))
    n = next(filter(any, (cross(u, v) for v in edges)), (0, 0, 0))
    return any(dot(n, v) for v in edges)


def require_separations(c, vectors, separates):
    """One for each pair of pieces: separates(u, h) with the height h of P_ij."""
    a, b = c["pieces_a"], c["pieces_b"]
    demand(len(vectors) == len(a) * len(b), "expected one separation for each pair of pieces")
    for k, u in enumerate(vectors):
        demand(any(u), "a separation that is zero and proves nothing")
        h = max(dot(u, p) for p in b[k % len(b)]) - min(dot(u, p) for p in a[k // len(b)])
        demand(separates(u, h), "a pair of pieces that is not separated")


def facet_planes(c, polytope):
    """The planes of the facets of a polytope inside a P_ij, which holds all that lies below them."""
    i, j, pairs, facets = polytope
    demand(i < len(c["pieces_a"]) and j < len(c["pieces_b"]), "a polytope without a piece")
    vertices = differences(c["pieces_a"][i], c["pieces_b"][j], pairs)
    total = tuple(map(sum, zip(*vertices)))
    check_inner([tuple(len(vertices) * x - t for x, t in zip(v, total)) for v in vertices], facets, 0)
    return [plane_through([vertices[k] for k in corners]) for corners in facets]


def determinant(rows):
    return sum((-1)**k * x * determinant([row[:k] + row[k + 1:] for row in rows[1:]]) for k, x in enumerate(rows[0])) if rows else 1


def adjugate(rows):
    """Of a symmetric matrix."""
    without = lambda i, j: [row[:j] + row[j + 1:] for row in rows[:i] + rows[i + 1:]]
    return [[(-1)**(i + j) * determinant(without(i, j)) for j in range(len(rows))] for i in range(len(rows))]


def multipliers(half_spaces):
    """With them the half-spaces add up to one that is as far away as all of them together."""
    if len(half_spaces) == 4:
        return multipliers_of_four([n for n, _ in half_spaces])
    gram, heights = [[dot(n, m) for m, _ in half_spaces] for n, _ in half_spaces], [h for _, h in half_spaces]
    adjugated = adjugate(gram)
    if determinant(gram):
        return [dot_all(row, heights) for row in adjugated]
    return next(filter(any, adjugated), [])


def multipliers_of_four(normals):
    """The same, by another way to the adjugate: its entries are d_i d_j (Cauchy and Binet)."""
    d = [dot(a, cross(b, c)) for a, b, c in (normals[:i] + normals[i + 1:] for i in range(4))]
    d = [d[0], -d[1], d[2], -d[3]]
    first = next(filter(None, d), 0)
    return [first * x for x in d]


def dot_all(u, v):
    return sum(x * y for x, y in zip(u, v))


def check_tree(nodes, polytopes, done, take):
    """No point that is nearer than the optima, and none as near but they, is outside of all polytopes: each a list of planes. Of each leaf
    take(its planes) is called before it is checked."""
    undone = [{f for f, plane in enumerate(planes) if not done(*plane)} for planes in polytopes]
    path, splits, complete = [], [], False  # of each split above: its planes, its children, the next one, the path before it
    for word, *numbers in nodes:
        demand(not complete, "nodes behind the tree")
        if word == "split":
            s, *children = numbers
            demand(s < len(polytopes) and all(f < len(polytopes[s]) for f in children), "no such polytope, or no such facet")
            demand(undone[s] <= set(children), "a facet that is not done and has no child")
            splits.append([polytopes[s], children, 0, len(path)])
        else:
            demand(len(numbers) <= 4 and all(i < len(path) for i in numbers), "more than four constraints, or one that is not on the path")
            used = [path[i] for i in numbers]
            take(used)
            factors = multipliers(used)
            demand(all(l >= 0 for l in factors), "a constraint that does not count")
            normal = tuple(sum(l * n[k] for l, (n, _) in zip(factors, used)) for k in range(3))
            demand(done(normal, sum(l * h for l, (_, h) in zip(factors, used))), "a cell that is nearer than claimed")
        while splits and splits[-1][2] == len(splits[-1][1]):
            splits.pop()
        if splits:
            planes, children, k, before = splits[-1]
            del path[before + max(k - 1, 0):]
            if k > 0:
                normal, h = planes[children[k - 1]]
                path.append((minus(normal), -h))
            path.append(planes[children[k]])
            splits[-1][2] += 1
        else:
            complete = True
    demand(complete, "a tree that is cut off")


def check_union(c):
    """Section 12. What is proved, for the verdict line."""
    a, b, unit = c["pieces_a"], c["pieces_b"], c["unit"]
    demand(a and b and all(has_interior([(*p, 1) for p in piece]) for piece in a + b), "no pieces, or one without an interior")

    def z(i, j):
        demand(i < len(a) and j < len(b), "no such piece")
        ends = combination(c["weights_a"], a[i], c["whole"]), combination(c["weights_b"], b[j], c["whole"])
        return [Fraction(y - x, unit * c["whole"]) for x, y in zip(*ends)]

    planes = lambda: [facet_planes(c, polytope) for polytope in c["polytopes"]]
    return check_proof(c, unit, lambda *apart: require_separations(c, *apart), planes, z, lambda _: None) + f" pieces={len(a)}x{len(b)}"


def check_proof(c, unit, require_apart, planes, z, take):
    """Of two unions; with what formats 3 and 5 do in ways of their own."""
    q = c["bounds"][0] if c["bounds"] else 0
    demand(c["claim"] == "touching" or q > 0, "a distance that is not positive")
    if c["claim"] == "depth":
        found = [t for t, _ in c["optima"]]
        demand(found and all(t < s for t, s in zip(found, found[1:])), "no optimum, or not in ascending order")
        for t, vectors in c["optima"]:
            demand(dot(t, t) == q, "an optimum that is not as far as claimed")
            require_apart(vectors, lambda u, h: dot(u, t) * unit >= h)
        listed, squared = set(found), q * unit**2

        def done(n, h):  # the half-space <n,x> >= h, in units of the points
            reached, needed = h * h * squared.denominator, squared.numerator * dot(n, n)
            return h > 0 and (reached > needed or (reached == needed and tuple(Fraction(h * x, dot(n, n) * unit) for x in n) in listed))

        check_tree(c["tree"], planes(), done, take)
        return f"penetrating depth_squared={q} optima={len(found)}"
    require_apart(c["optima"][0][1], lambda u, h: square(h) <= -q * unit**2 * dot(u, u))
    difference = z(*c["nearest"])
    demand(dot(difference, difference) == q, "points that are not as far from each other as claimed")
    return f"disjoint distance_squared={q}" if q else "touching depth_squared=0"


def primitive(v):
    """A vector that is not zero, divided by the greatest common divisor of its entries."""
    return tuple(x // gcd(*v) for x in v)


def unsigned(v):
    """One for v and -v."""
    return max(v, minus(v))


def edge(p, q):
    """A positive multiple of q - p; points are x y z w."""
    return tuple(y * p[3] - x * q[3] for x, y in zip(p[:3], q[:3]))


def normal_of(points, polygon):
    """The primitive vector of which the normals of all triangles are positive multiples that are fanned out from the first corner."""
    demand(len(polygon) > 2, "fewer than three corners, or some on a line")
    first, *others = [points[k] for k in polygon]
    fan = [cross(edge(first, p), edge(first, q)) for p, q in zip(others, others[1:])]
    demand(all(map(any, fan)), "fewer than three corners, or some on a line")
    normal, *others = map(primitive, fan)
    demand(all(n == normal for n in others), "not a flat and convex polygon")
    demand(len(set(polygon)) == len(polygon), "a corner twice")
    return normal


def check_piece(points, facets):
    """It is the hull of its corners, and each of its faces is one facet. The normals of the facets."""
    normals = [normal_of(points, f) for f in facets]
    demand(len(set(normals)) == len(facets) > 0, "no facets, or two with the same normal")
    corners = [points[k] for k in {k for f in facets for k in f}]
    for n, (k, *_) in zip(normals, facets):
        sides = [dot(n, edge(points[k], p)) for p in corners]
        demand(max(sides) <= 0 > min(sides), "a corner above a facet, or none below")
    edges = {(u, v) for f in facets for u, v in zip(f, f[1:] + f[:1])}
    demand(all((v, u) in edges for u, v in edges), "an edge with one facet")
    return normals


def check_tiling(body):
    """Section 14: the pieces tile what the mesh encloses."""
    points, mesh, pieces = body.homogeneous, body.mesh, body.facets
    demand(pieces, "no pieces")
    demand(all(k < len(points) for facets in [mesh, *pieces] for f in facets for k in f), "there is no point of this number")
    demand(len(set(points)) == len(points), "a point that is there twice")
    triangles = [t for t in mesh if any(cross(*(edge(points[t[0]], points[k]) for k in t[1:])))]
    polygons = [(t, normal_of(points, t), 1) for t in triangles]
    polygons += [(f, n, -1) for facets in pieces for f, n in zip(facets, check_piece(points, facets))]
    flags = Counter()
    for polygon, n, sign in polygons:
        for u, v in zip(polygon, polygon[1:] + polygon[:1]):
            along = unsigned(primitive(edge(points[u], points[v])))
            flags[v, unsigned(n), along] += sign
            flags[u, unsigned(n), along] -= sign
    demand(not any(flags.values()), "the pieces do not tile what the mesh encloses")


def check_solid(c):
    """Section 14. What is proved, for the verdict line."""
    check_tiling(c["body_a"])
    return f"solid triangles={len(c['body_a'].mesh)} pieces={len(c['body_a'].facets)}"


def ranges(blocks, m, n):
    """The vectors of an apart tree, each with the pieces of A and of B that it is for; and what shows that the blocks are no tree."""
    found, left = [], [(range(m), range(n))]
    for block in blocks:
        if not left:
            return found, "blocks behind the tree"
        of_a, of_b = left.pop()
        whole = {"a": of_a, "b": of_b}.get(block)
        if whole is None:
            found.append((block, of_a, of_b))
        elif len(whole) < 2:
            return found, "a split of fewer than two pieces"
        else:
            halves = whole[len(whole) // 2:], whole[:len(whole) // 2]
            left += [(half, of_b) if block == "a" else (of_a, half) for half in halves]
    return found, "a block is missing" if left else ""


def require_blocks(a, b, blocks, separates):
    """They form a tree, and separates(u, h) holds of each vector u and the largest <u,b> minus the smallest <u,a> of its corners."""
    found, fault = ranges(blocks, len(a.pieces), len(b.pieces))
    demand(not fault, fault)
    for u, of_a, of_b in found:
        demand(any(u), "a separation that is zero and proves nothing")
        heights = [[Fraction(dot(u, p), p[3]) for p in {body.homogeneous[k] for i in pieces for k in body.pieces[i]}]
                   for body, pieces in ((a, of_a), (b, of_b))]
        demand(separates(u, max(heights[1]) - min(heights[0])), "a pair of pieces that is not separated")


def primitive_planes(a, b, i, j, pairs, facets):
    """The planes <N,x> = d of the facets of a polytope inside P_ij, of integers without a common divisor."""
    ends = [(a.corner(i, k), b.corner(j, l)) for l, k in pairs]
    demand(None not in {k for both in ends for k in both}, "a polytope or a vertex without its pieces")
    vertices = [(*edge(a.homogeneous[k], b.homogeneous[l]), a.homogeneous[k][3] * b.homogeneous[l][3]) for k, l in ends]
    demand(all(k < len(vertices) for f in facets for k in f), "a facet without corners")
    heights = [(n, Fraction(dot(n, vertices[f[0]]), vertices[f[0]][3])) for n, f in zip(check_piece(vertices, facets), facets)]
    return [(tuple(x * d.denominator for x in n), d.numerator) for n, d in heights]


def check_two(c):
    """Section 15. What is proved, for the verdict line."""
    a, b = bodies = c["body_a"], c["body_b"]
    for body in bodies:
        demand(body.pieces, "no pieces")
        if body.mesh is None:
            demand(all(has_interior([body.homogeneous[k] for k in corners]) for corners in body.pieces), "a piece without an interior")
        else:
            check_tiling(body)

    def planes():
        found = [primitive_planes(a, b, *polytope) for polytope in c["polytopes"]]
        for each in found:
            for plane in each:
                spend(c, [plane])
        return found

    def z(*pair):
        ends = []
        for x, body, i in zip("ab", bodies, pair):
            weights = [(body.corner(i, k), w) for k, w in c["weights_" + x]]
            demand(i < len(body.pieces) and all(k is not None for k, _ in weights), "no such piece, or no such corner")
            ends.append(combination(weights, body.points, 1))
        return [y - x for x, y in zip(*ends)]

    said = check_proof(c, 1, lambda *apart: require_blocks(a, b, *apart), planes, z, lambda used: used and spend(c, used, len(used)))
    triangles = ["-" if body.mesh is None else len(body.mesh) for body in bodies]
    return f"{said} pieces={len(a.pieces)}x{len(b.pieces)} triangles={triangles[0]}x{triangles[1]}"


class Polynomial:
    """A homogeneous one of v and u: the coefficients of v^(n-k) u^k."""

    def __init__(self, coefficients):
        self.coefficients = coefficients

    def __add__(self, p):
        return Polynomial([x + y for x, y in zip(self.coefficients, p.coefficients)])

    def __neg__(self):
        return Polynomial([-x for x in self.coefficients])

    def __sub__(self, p):
        return self + -p

    def __mul__(self, p):
        product = [0] * (len(self.coefficients) + len(p.coefficients) - 1)
        for i, x in enumerate(self.coefficients):
            for j, y in enumerate(p.coefficients):
                product[i + j] += x * y
        return Polynomial(product)


def times(k, u):
    return tuple(k * x for x in u)


def rotated(r, v, x):
    """By the quaternion r + v, times its squared length."""
    turned = [y + z for y, z in zip(times(dot(v, x), v), times(r, cross(v, x)))]
    return tuple(y + z + z for y, z in zip(times(r * r - dot(v, v), x), turned))


def conditions(kind, row, motions):
    """Section 17: D, u and v."""
    (wa, ra, va, pa), (wb, rb, vb, pb) = ((r * r + dot(v, v), r, v, p) for (r, *v), p in motions)
    d = tuple(x - y for x, y in zip(pa, pb))
    n, g = ([Polynomial([x]) for x in vector] for vector in (row[:3], row[-3:]))
    if kind == "b":
        h = rotated(rb, vb, n)
        return wa * dot(h, d), rotated(ra, minus(va), h), times(wa * wb, n)
    h = rotated(ra, va, n)
    if kind == "a":
        return wb * dot(h, d), times(wa * wb, n), rotated(rb, minus(vb), h)
    k = rotated(rb, vb, g)
    return dot(cross(h, k), d), cross(n, rotated(ra, minus(va), k)), cross(rotated(rb, minus(vb), h), g)


def require_apart(c, kind, row, s, e):
    """At each time from s to e."""
    def between(x, y):  # a number of the motion, times both denominators
        return Polynomial([other.denominator * ((t.denominator - t.numerator) * x + t.numerator * y) for t, other in ((s, e), (e, s))])

    motions = [[[between(x, y) for x, y in zip(*ends)] for ends in (motion[:2], motion[2:])] for motion in (c["motion_a"], c["motion_b"])]
    distance, *vectors = conditions(kind, [int(n) for n in row], motions)
    of_a, of_b = (zip(*((x * Polynomial([1, 1])).coefficients for x in vector)) for vector in vectors)  # raised to degree 5
    for h, u, v in zip(distance.coefficients, of_a, of_b):
        h += s.denominator * e.denominator * (min(dot(u, a) for a in c["a"]) - max(dot(v, b) for b in c["b"]))
        demand(h > 0, "a piece that does not show that the bodies are apart")


def require_near(c, t, delta, weights):
    """At the time t two points are at most delta from each other."""
    ends = []
    for x in "ab":
        (r, *v), p = ([(1 - t) * y + t * z for y, z in zip(*ends)] for ends in (c["motion_" + x][:2], c["motion_" + x][2:]))
        length = r * r + dot(v, v)
        demand(length > 0, "a quaternion that is zero")
        corner = [Fraction(y, c["whole"]) for y in combination(weights["weights_" + x], c[x], c["whole"])]
        ends.append([y + z / length for y, z in zip(p, rotated(r, v, corner))])
    z = [y - x for x, y in zip(*ends)]
    demand(dot(z, z) <= (delta * c["unit"])**2, "weights of points too far from each other")


def check_motion(c):
    """Section 17. What is proved, for the verdict line."""
    demand(c["a"] and c["b"], "a body without points")
    s, before, near = Fraction(0), "near", []
    for kind, e, row, weights in c["pieces"]:
        demand(s <= e <= 1, "pieces that are not in order, or beyond the end")
        if kind == "near":
            demand(before != "near", "a piece of the kind near that is the first one, or behind another")
            demand(row[0] >= 0, "a negative distance")
            require_near(c, e, row[0], weights)
            near.append(f"({s},{e}):{row[0]}")
        else:
            require_apart(c, kind, row, s, e)
        s, before = e, kind
    demand(not c["pieces"] or before != "near", "a piece of the kind near that is the last one")
    said = " near=" + "+".join(near) if near else ""
    if c["claim"] != "contact":
        demand(c["pieces"] and s == 1, "pieces that do not end at 1")
        demand(bool(near) == (c["claim"] == "grazing"), "a claim that does not fit the pieces of the kind near")
        return f"{c['claim']} until=1{said}"
    t = c["bounds"][0]
    demand(s < t <= 1 if c["pieces"] else t == 0, "a contact before the end of the pieces, or beyond 1")
    require_near(c, t, 0, c)
    return f"contact until={s} at={t}{said}" if c["pieces"] else "contact at=0"


def place(c, name):
    return f" (in {name})" if c["id"] else ""


def verdicts(file, name):
    """One (exit code, line) per certificate; at least one."""
    reader, any_yet = Reader(file), False
    reader.advance()
    while reader.line is not None or not any_yet:
        any_yet, first = True, reader.number
        c = {"id": "", "radius_a": 0, "radius_b": 0, "cone": False, "height": None}
        c.update((f"{part}_{x}", None) for part in ("terms", "halfspace", "body") for x in "ab")
        c.update((f"{part}{x}", []) for part in ("", "heights_", "inner_", "weights_") for x in "ab")
        c.update({"vertices": [], "facets": None, "lineality": [], "rays": [], "differences": [], "patches": [], "rates": []})
        try:
            reader.certificate(c)
            require, judge = {3: (require_union_limits, check_union), 5: (require_limits_of_two, check_two),
                              6: (require_motion_limits, check_motion)}.get(c["format"], (require_limits, check))
            if c["claim"] == "solid":
                require, judge = require_solid_limits, check_solid
            require(c)
            c["complete"] = True
            if c["height"] is not None:
                require_height(c)
            yield 0, f"s VERIFIED {judge(c)}{'' if c['height'] is None else ' dimension=2'} {c['id'] or name}"
            reader.advance()
        except Refused as error:
            yield 1, f"s REFUSED {c['id'] or name}:{reader.number}: {error}{place(c, name)}"
            reader.advance()
        except (Malformed, MemoryError) as error:
            yield 2, f"s MALFORMED {c['id'] or name}:{reader.number}: {error or 'out of memory'}{place(c, name)}"
            if "complete" in c:
                reader.advance()
                continue
            if reader.number == first:
                reader.step()
            while reader.line is not None and not reader.line.startswith("fathom-certificate"):
                reader.step()


def judged(name):
    label = b"<stdin>" if name == "-" else re.sub(rb"[^!-$&-~]", lambda m: b"%%%02X" % m[0][0], os.fsencode(name))
    try:
        with open(0 if name == "-" else name, "rb", closefd=name != "-") as file:
            yield from verdicts(file, label.decode())
    except OSError as error:
        yield 2, f"s MALFORMED {label.decode()}:0: {error.strerror}"


def main(names):
    worst = 0
    if names in (["--help"], ["-h"]):
        print("check.py FILE...   checks the certificates in these files, or - for standard input, as FORMAT.md says;\n"
              "                   one line for each. Exit code: 0 all accepted, 1 some refused, 2 some malformed.")
        return 0
    if not names or sys.stdout is None:
        expected = "standard output, which is closed" if names else "certificates: files, or - for standard input"
        sys.stderr.write(f"check.py: expected {expected}\n")
        return 2
    for code, line in (verdict for name in names for verdict in judged(name)):
        try:
            print(line, flush=True)
        except OSError as error:
            sys.stderr.write(f"check.py: cannot write to standard output: {error.strerror}\n")
            os._exit(2)  # Python would try once more to write
        worst = max(worst, code)
    return worst


if __name__ == "__main__":
    getattr(sys, "set_int_max_str_digits", int)(0)  # no limit
    sys.exit(main(sys.argv[1:]))
