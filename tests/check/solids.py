# SPDX-License-Identifier: GPL-3.0-or-later
"""Certificates of format 2, made by definition: small bodies, plain fractions, all subsets tried. Shares nothing with fathom or its checkers.

A body is a dictionary: `points`, a list; or `terms`, each a list of atoms, each a list of vectors, the center first; or `plane`, (m, d); and
its `radius`. A core value, the least h(u) of all |u| = 1, is kept as its square with its sign.
"""
import collections
import itertools
import random
from fractions import Fraction
from math import gcd, isqrt, lcm

O = (0, 0, 0)
UNITS = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
KINDS = [(0, 1), (0, 2), (0, 3), (0, 4), (0, 5), (1, 0), (1, 1), (1, 2), (2, 0), (2, 1), (3, 0)]  # lineality and rays of cones


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


# Cores that are hulls of points.

class Core:
    """P of two lists of points: its value, and what proves it. Within, all is scaled to integers."""

    def __init__(self, a, b):
        self.scale = lcm(*(Fraction(x).denominator for p in a + b for x in p))
        whole = [[tuple(int(x * self.scale) for x in p) for p in body] for body in (a, b)]
        self.pairs = {}
        for (i, p), (j, q) in itertools.product(enumerate(whole[0]), enumerate(whole[1])):
            self.pairs.setdefault(minus(q, p), (j, i))
        self.points = list(self.pairs)
        self.facets = self.find_facets()
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

    def find_facets(self):
        """(outward normal, c, corners in order) of each facet; nothing if P is flat."""
        planes = {}
        for p, q, r in itertools.combinations(self.points, 3):
            n = cross(minus(q, p), minus(r, p))
            if not any(n):
                continue
            c, least, most = dot(n, p), 0, 0
            for x in self.points:
                side = dot(n, x) - c
                least, most = min(least, side), max(most, side)
                if least < 0 < most:
                    break
            else:
                if least == most:
                    return []
                n = primitive(n if most == 0 else times(-1, n))
                planes.setdefault(n, [x for x in self.points if dot(n, x) == dot(n, p)])
        return [(n, dot(n, on[0]), self.in_order(n, on)) for n, on in planes.items()]

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
    """Whether the claim of an accepted certificate (forging.Parts) agrees with the definitions, as far as these bounds tell."""
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


# Bodies at random.

def small(rng, size=2):
    return Fraction(rng.randint(-2 * size, 2 * size), rng.choice([1, 1, 1, 2, 3]))


def vector(rng, size=2):
    return (small(rng, size), small(rng, size), small(rng, size))


def radius(rng):
    return rng.choice([Fraction(0), Fraction(1), Fraction(1, 2), Fraction(rng.randrange(1, 40), rng.randrange(1, 9))])


def points_body(rng, kind=None):
    """Spheres, capsules, rounded boxes and hulls."""
    kind = kind or rng.choice(["sphere", "capsule", "triangle", "box", "hull"])
    if kind == "box":
        low, high = vector(rng), vector(rng)
        points = [tuple(min(l, h) - (l == h) if s == "0" else max(l, h) for s, l, h in zip(f"{k:03b}", low, high)) for k in range(8)]
    else:
        count = {"sphere": 1, "capsule": 2, "triangle": 3, "hull": rng.randrange(4, 7)}[kind]
        points = [vector(rng) for _ in range(count)]
    return {"points": points, "radius": radius(rng), "says_radius": rng.random() < 0.5}


def turned(rng):
    """Rows of a rational rotation, and some that are no rotation."""
    w, x, y, z = (rng.randint(-2, 2) for _ in range(4))
    n = w * w + x * x + y * y + z * z
    if n == 0 or rng.random() < 0.2:
        return [vector(rng) for _ in range(3)]
    rows = [(w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)),
            (2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)),
            (2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z)]
    return [times(Fraction(1, n), row) for row in rows]


def shape_body(rng, kind=None):
    """Cylinders, cones, ellipsoids, boxes, frustums, and sums of two."""
    kind = kind or rng.choice(["cylinder", "cone", "ellipsoid", "box", "frustum", "sum", "capsule"])
    c, (u, v, w) = vector(rng), turned(rng)
    r, s, t = (Fraction(rng.randrange(1, 7), 2) for _ in range(3))
    if kind == "sum":
        one, two = (shape_body(rng, rng.choice(["ellipsoid", "capsule", "cone", "cylinder"])) for _ in range(2))
        return {"terms": one["terms"] + two["terms"], "radius": radius(rng)}
    disc = lambda at, by: [plus(c, times(at, w)), times(by, u), times(by, v)]
    term = {"cylinder": lambda: [disc(s, r), disc(-s, r)], "cone": lambda: [disc(-s, r), [plus(c, times(s, w))]],
            "frustum": lambda: [disc(s, r), disc(-s, t)], "ellipsoid": lambda: [[c, times(r, u), times(s, v), times(t, w)]],
            "capsule": lambda: [[plus(c, times(s, w))], [plus(c, times(-s, w))]],
            "box": lambda: [[plus(c, plus(times(x, u), plus(times(y, v), times(z, w))))] for x in (-r, r) for y in (-s, s) for z in (-t, t)]}
    return {"terms": [term[kind]()], "radius": radius(rng)}


def plane_body(rng):
    m = vector(rng)
    return {"plane": (m if any(m) else (0, 0, 1), small(rng)), "radius": radius(rng)}


def touching_bodies(rng, kind):
    """Two lists of points that touch with this kind of cone: P lies in the span of as many vectors as the lineality leaves."""
    while True:
        basis = [tuple(rng.randint(-1, 1) for _ in range(3)) for _ in range(3 - kind[0])]
        size = rng.choice([1, 1, 2])
        a, b = ([combined({u: rng.randint(-size, size) for u in basis}) for _ in range(rng.randint(1, 5))] for _ in "ab")
        if kind[1] >= 4:  # the apex of a pyramid
            a, b = [O], [O] + [(rng.randint(-2, 2), rng.randint(1, 2), rng.randint(-2, 2)) for _ in range(kind[1] + 1)]
        core = Core(a, b)
        if core.value != 0:
            continue
        lines, rays = core.cone()
        if (len(lines), len(rays)) == kind:
            scale, shift = Fraction(rng.randrange(1, 4), rng.randrange(1, 4)), vector(rng)
            return [{"points": [plus(shift, times(scale, p)) for p in points], "radius": radius(rng)} for points in (a, b)]


def genuine(count, seed):
    """(name, text, bodies) of certificates of all kinds."""
    rng = random.Random(seed)
    makers = {"points": lambda: (points_body(rng), points_body(rng)), "shapes": lambda: (shape_body(rng), shape_body(rng)),
              "mixed": lambda: rng.sample([points_body(rng), shape_body(rng)], 2),
              "plane": lambda: rng.sample([plane_body(rng), points_body(rng)], 2),
              "plane_shape": lambda: rng.sample([plane_body(rng), shape_body(rng)], 2)}
    kinds = list(makers) + KINDS
    for number in range(count):
        kind = kinds[number % len(kinds)]
        name = f"{kind if isinstance(kind, str) else 'cone_%d_%d' % kind}_{number}"
        a, b = makers[kind]() if kind in makers else touching_bodies(rng, kind)
        if kind == "points" and rng.random() < 0.3:
            balance(a, b)
        yield name, certificate(name, a, b, rng), (a, b)


def balance(a, b):
    """Radii whose sum is the distance of the cores, if that is rational."""
    distance = root(-Core(a["points"], b["points"]).value, False)
    if distance > 0 and distance**2 == -Core(a["points"], b["points"]).value:
        a["radius"], b["radius"] = distance / 3, 2 * distance / 3
