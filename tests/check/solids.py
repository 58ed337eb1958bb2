# SPDX-License-Identifier: GPL-3.0-or-later
"""Certificates of format 2, made by definition (cores.py), and whether what one claims is true.

A body is a dictionary: `points`, a list; or `terms`, each a list of atoms, each a list of vectors, the center first; or `plane`, (m, d);
and its `radius`.
"""
import collections
import itertools
import random
from fractions import Fraction

from cores import O, UNITS, Core, dot, plus, primitive, root, square, times

# Shapes.

def height(term, s):
    """Not below the support of the term, and equal to it if that is rational."""
    return max(dot(s, c) + root(sum(dot(s, u)**2 for u in axes), True) for c, *axes in term)


PARAMETERS = {0: [O], 2: [(x, y, 0) for x, y in ((1, 0), (-1, 0), (0, 1), (0, -1))], 3: [u for e in UNITS for u in (e, times(-1, e))]}


def inner_points(terms, rng, most):
    """(row, point) of some points of the shape: all extreme parameters of every atom if these are few, else some."""
    places = []
    for term in terms:
        places.append([(i, y) for i, atom in enumerate(term) for y in PARAMETERS[len(atom) - 1]])
        if rng.random() < 0.3:  # off the axes
            t = Fraction(rng.randrange(1, 9), rng.randrange(1, 9))
            turned = (2 * t / (1 + t * t), (1 - t * t) / (1 + t * t), 0)
            places[-1] += [(i, turned) for i, atom in enumerate(term) if len(atom) > 1]
    rows = list(itertools.product(*places))
    found = []
    for row in rng.sample(rows, min(most, len(rows))):
        point = O
        for term, (i, y) in zip(terms, row):
            center, *axes = term[i]
            point = plus(point, center)
            for x, axis in zip(y, axes):
                point = plus(point, times(x, axis))
        found.append((row, point))
    return found


# Texts.

def words(vector):
    return " ".join(map(str, vector))


class Writer:
    def __init__(self, name):
        self.lines, self.counts = ["fathom-certificate 2", f"id {name}"], []

    def part(self, word, rows, more=""):
        self.counts.append(len(rows))
        self.lines.append(f"{word} {len(rows)}{more}")
        self.lines += rows

    def body(self, name, body):
        if "points" in body:
            self.part(name, [words(p) for p in body["points"]])
        elif "terms" in body:
            self.counts.append(len(body["terms"]))
            self.lines.append(f"shape_{name} {len(body['terms'])}")
            for term in body["terms"]:
                self.part("term", [f"{ {1: 'point', 3: 'disc', 4: 'ball'}[len(atom)]} {' '.join(map(words, atom))}" for atom in term])
        else:
            self.lines.append(f"halfspace_{name} {words(body['plane'][0])} {body['plane'][1]}")
        if body["radius"] or body.get("says_radius"):
            self.lines.append(f"radius_{name} {body['radius']}")

    def claim(self, *claim):
        self.lines.append(" ".join(map(str, ("claim", *claim))))

    def directions(self, rows, which="some"):
        self.part("directions", list(map(words, rows)), " " + which)

    def inner(self, core):
        vertices = list(dict.fromkeys(p for _, _, corners in core.facets for p in corners))
        self.part("vertices", [words(core.pairs[p]) for p in vertices])
        self.part("facets", [f"{len(corners)} {words(vertices.index(p) for p in corners)}" for _, _, corners in core.facets])

    def weights(self, core):
        for name, k in (("a", 1), ("b", 0)):
            sums = collections.Counter()
            for d, w in core.weights.items():
                sums[core.pairs[d][k]] += w
            self.part("weights_" + name, [f"{i} {w}" for i, w in sorted(sums.items())])

    def text(self):
        return "\n".join(self.lines + [f"end {words(self.counts)}"]) + "\n"


class Pair:
    """Two bodies: bounds of the value of their cores, which are equal unless there is a shape, and a direction that shows the upper one."""

    def __init__(self, a, b, rng, most):
        self.bodies, self.rho = {"a": a, "b": b}, Fraction(a["radius"] + b["radius"])
        self.shapes = [x for x in "ab" if "terms" in self.bodies[x]]
        self.inner = {x: inner_points(self.bodies[x]["terms"], rng, most) for x in self.shapes}
        points = {x: [p for _, p in self.inner[x]] if x in self.shapes else self.bodies[x].get("points") for x in "ab"}
        self.core, self.lines, self.rays = None, [], []
        plane = next((x for x in "ab" if not points[x]), None)
        if plane:
            self.n = primitive(self.towards(plane, self.bodies[plane]["plane"][0]))
        else:
            self.core = Core(points["a"], points["b"])
            self.lines, self.rays = self.core.cone() if self.core.value == 0 else ([], [])
            self.n = (self.core.optima() if self.core.inside else self.rays + self.lines or [primitive(times(-1, self.core.z))])[0]
        low = sum(self.reach(x, lambda x, s: max(dot(s, p) for p in points[x])) for x in "ab")
        high = sum(self.reach(x, lambda x, s: sum(height(term, s) for term in self.bodies[x]["terms"])
                              if x in self.shapes else max(dot(s, p) for p in points[x])) for x in "ab")
        self.low = self.core.value if self.core else square(low) / dot(self.n, self.n)
        self.high = square(high) / dot(self.n, self.n)

    @staticmethod
    def towards(x, n):
        return n if x == "b" else times(-1, n)

    def reach(self, x, of_core):
        """How far the core reaches in its direction."""
        s = self.towards(x, self.n)
        if "plane" not in self.bodies[x]:
            return of_core(x, s)
        m, d = self.bodies[x]["plane"]
        return d * Fraction(dot(s, m)) / dot(m, m)

    def heights(self, x):
        return [height(term, self.towards(x, self.n)) for term in self.bodies[x]["terms"]]


def certificate(name, a, b, rng):
    """The text that proves the signed depth of these bodies, exactly or within bounds."""
    pair, text = Pair(a, b, rng, 5), Writer(name)
    core = pair.core
    text.body("a", a)
    text.body("b", b)
    exact = not pair.shapes and rng.random() < 0.9
    every = exact and core and core.inside and rng.random() < 0.7
    if not exact:
        text.claim("signed_bounds", pair.rho + root(pair.low, False), pair.rho + root(pair.high, True))
    else:
        text.claim(*(("depth", pair.low) if pair.low > 0 else ("touching",) if pair.low == 0 else ("apart", -pair.low)))
    text.directions(core.optima() if every else [pair.n], "all" if every else "some")
    for x in pair.shapes:
        text.part("heights_" + x, list(map(str, pair.heights(x))))
    for x in pair.shapes:
        text.part("inner_" + x, [" ".join(f"{i} {words(y)}" for i, y in row) for row, _ in pair.inner[x]])
    if core:
        text.inner(core) if core.inside else text.weights(core)
    if core and exact and pair.low == 0 and rng.random() < 0.9:
        text.part("lineality", list(map(words, pair.lines)))
        text.part("rays", list(map(words, pair.rays)))
        text.part("differences", [words(core.pairs[d]) for d in core.proof_of_cone(pair.lines, pair.rays)])
    return text.text()


def body_of(rows, name):
    """The body that these parts of a certificate say."""
    numbers = lambda row: tuple(map(Fraction, row))
    body = {"radius": Fraction((rows.get("radius_" + name) or [["0"]])[0][0])}
    if name in rows:
        body["points"] = list(map(numbers, rows[name]))
    elif "halfspace_" + name in rows:
        *m, d = numbers(rows["halfspace_" + name][0])
        body["plane"] = (tuple(m), d)
    else:
        body["terms"] = []
        for row in rows["shape_" + name]:
            if row == ["term"]:
                body["terms"].append([])
            else:
                body["terms"][-1].append([numbers(row[k:k + 3]) for k in range(1, len(row), 3)])
    return body


def is_true(parts):
    """Whether the claim of an accepted certificate (parts.Parts) agrees with the definitions, as far as these bounds tell."""
    pair = Pair(body_of(parts.rows, "a"), body_of(parts.rows, "b"), random.Random(1), 12)
    word, *numbers = parts.claim
    numbers = list(map(Fraction, numbers))
    vectors = {part: [tuple(map(int, row)) for row in parts.rows.get(part, [])] for part in ("directions", "lineality", "rays")}
    if word == "signed_bounds":
        return square(numbers[0] - pair.rho) <= pair.high and square(numbers[1] - pair.rho) >= pair.low
    claimed = {"depth": 1, "touching": 0, "apart": -1}[word] * sum(numbers)
    if not claimed == pair.low == pair.high:
        return False
    if parts.which == "all" and vectors["directions"] != pair.core.optima():
        return False
    if "lineality" not in parts.rows:
        return True
    zero = all(dot(l, d) == 0 for l in vectors["lineality"] for d in pair.core.points)
    return zero and len(vectors["lineality"]) == len(pair.lines) and vectors["rays"] == pair.rays
