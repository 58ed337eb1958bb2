# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact patches and rates by definition, and certificates of format 4: those of others with these added. Plain fractions, all subsets
tried. Shares nothing with fathom or its checkers."""
import functools
import itertools
import random
from fractions import Fraction

import random_solids
from cores import O, UNITS, combined, cross, dot, foot, minus, plus, primitive, square, times
from parts import Parts
from solids import body_of, certificate


def weights_of(p, points):
    """Index -> weight > 0 of at most three of these points, whose sum is p; None if p is not in their hull."""
    near = [minus(q, p) for q in points]
    for size in (1, 2, 3):
        for chosen in itertools.combinations(range(len(points)), size):
            weights = foot([near[k] for k in chosen]) if size > 1 or near[chosen[0]] == O else None
            if weights and min(weights) > 0 and not any(sum(w * near[k][i] for w, k in zip(weights, chosen)) for i in range(3)):
                return dict(zip(chosen, weights))
    return None


def crossing(p, q, r, s, n):
    """The point where the line p q meets the line r s, of a plane with the normal n; None if they are parallel."""
    u, v = minus(q, p), minus(s, r)
    area = dot(n, cross(u, v))
    return plus(p, times(Fraction(dot(n, cross(minus(r, p), v))) / area, u)) if area else None


def extreme(points):
    points = sorted(set(points))
    return [p for p in points if weights_of(p, [q for q in points if q != p]) is None]


class Patch:
    """Of two cores, each a list of points or, if it is a half-space, None, that are this far (h(n)) along n."""

    def __init__(self, points, n, h):
        self.n, self.t = n, times(Fraction(h) / dot(n, n), n)
        sign = {"a": -1, "b": 1}
        most = {x: max(dot(p, n) * sign[x] for p in body) for x, body in points.items() if body}
        self.face = {x: list(dict.fromkeys(p for p in points[x] if dot(p, n) * sign[x] == most[x])) for x in most}
        known = {x: [minus(p, self.t) if x == "b" else p for p in face] for x, face in self.face.items()}
        self.known, (first, *second) = known, known.values()
        self.corners = extreme(first)  # points of A, or where A would have them
        if second:
            inside = lambda points, hull: [p for p in points if weights_of(p, hull) is not None]
            edges = [list(itertools.combinations(extreme(hull), 2)) for hull in known.values()]
            found = [crossing(*e, *f, n) for e in edges[0] for f in edges[1]]
            found = [p for p in found if p is not None]
            for hull in known.values():
                found = inside(found, hull)
            self.corners = extreme(inside(first, second[0]) + inside(second[0], first) + found)

    def rows_of_corners(self, points):
        """Words of each, with the numbers of the body's points."""
        rows = []
        for p in self.corners:
            words = []
            for x in "ab":
                weights = weights_of(p, self.known[x]) if x in self.known else {}
                index = {k: points[x].index(self.face[x][k]) for k in weights}
                words += [str(len(weights)), *(str(y) for k, w in weights.items() for y in (index[k], w))]
            rows.append(words)
        return rows

    def sides(self):
        """(body, m, corner): the lines along and across every two points of a face that touch the patch, in order, as few as serve."""
        across = next(u for u in (cross(self.n, e) for e in UNITS) if any(u))
        found = {}
        for x, face in self.known.items():
            edges = [minus(q, p) for p, q in itertools.permutations(extreme(face), 2)]
            for m in edges + [cross(self.n, e) for e in edges] + [y for e in (across, cross(self.n, across)) for y in (e, times(-1, e))]:
                m = primitive(minus(m, times(Fraction(dot(m, self.n)) / dot(self.n, self.n), self.n)))
                if min(dot(m, p) for p in face) == min(dot(m, p) for p in self.corners):
                    found.setdefault(m, x)
        start = next(iter(found))
        turn = lambda u, v: dot(self.n, cross(u, v))
        half = lambda m: 0 if turn(start, m) > 0 or (turn(start, m) == 0 and dot(start, m) > 0) else 1
        before = lambda u, v: half(u) - half(v) or (-1 if turn(u, v) > 0 else 1 if turn(u, v) < 0 else 0)
        order = sorted(found, key=functools.cmp_to_key(before))
        for m in list(order):
            fewer = [u for u in order if u != m]
            if self.named(fewer):
                order = fewer
        return [(found[m], m, k) for m, k in zip(order, self.named(order))]

    def named(self, order):
        """The corner between each of these sides and the next one; None if they do not serve."""
        named = []
        for u, v in zip(order, order[1:] + order[:1]):
            least = [{k for k, p in enumerate(self.corners) if dot(m, p) == min(dot(m, q) for q in self.corners)} for m in (u, v)]
            if dot(self.n, cross(u, v)) <= 0 or not least[0] & least[1]:
                return None
            named.append(min(least[0] & least[1]))
        return named if set(named) == set(range(len(self.corners))) else None

    def rate(self, v, w):
        """Of the signed depth in this direction, squared with its sign."""
        return Fraction(square(max(-dot(self.n, plus(v, cross(w, p))) for p in self.corners))) / dot(self.n, self.n)


def patches_of(parts):
    """(points of both bodies, a Patch for each direction) of a certificate without shapes."""
    bodies = {x: body_of(parts.rows, x) for x in "ab"}
    points, found = {x: body.get("points") for x, body in bodies.items()}, []
    for n in (tuple(map(int, row)) for row in parts.rows["directions"]):
        h = Fraction(0)
        for x, s in (("a", times(-1, n)), ("b", n)):
            m, d = bodies[x].get("plane", (None, None))
            h += max(dot(s, p) for p in points[x]) if points[x] else d * Fraction(dot(s, m)) / dot(m, m)
        found.append(Patch(points, n, h))
    return points, found


def knows_all_optima(parts):
    return parts.claim[0] == "apart" or parts.which == "all" or "halfspace_a" in parts.rows or "halfspace_b" in parts.rows


def with_patches(text, rng):
    """A certificate of the claims depth, touching or apart without shapes, in format 4."""
    parts = Parts(text)
    parts.format = "4"
    points, found = patches_of(parts)
    parts.rows["patches"] = []
    for patch in found:
        parts.rows["patches"] += [["patch"], *patch.rows_of_corners(points)]
        parts.rows["patches"] += [[x, *map(str, m), str(k)] for x, m, k in patch.sides()]
    if knows_all_optima(parts) and rng.random() < 0.8:
        parts.rows["rates"] = []
        for _ in range(rng.randrange(1, 4)):
            v, w = random_solids.vector(rng), random_solids.vector(rng)
            rate = min(patch.rate(v, w) for patch in found)
            parts.rows["rates"].append([*map(str, (*v, *w, (rate > 0) - (rate < 0), abs(rate)))])
    return parts.text()


def can_have_patches(text):
    parts = Parts(text)
    return parts.claim[0] in ("depth", "touching", "apart") and not any(part.startswith("shape") for part in parts.rows)


def bodies(kind, rng):
    """Two of them, without shapes."""
    if kind == "plane":
        plane, body = random_solids.plane_body(rng), random_solids.points_body(rng)
        if rng.random() < 0.4:  # a box that stands on it
            plane["plane"], body = (times(rng.choice([-1, 1]), rng.choice(UNITS)), plane["plane"][1]), random_solids.points_body(rng, "box")
        if rng.random() < 0.3:
            plane["plane"] = (plane["plane"][0], min(dot(plane["plane"][0], p) for p in body["points"]))
        return rng.sample([plane, body], 2)
    if kind in ("points", "box"):
        return [random_solids.points_body(rng, kind if kind == "box" else None) for _ in "ab"]
    if kind == "same":
        body = random_solids.points_body(rng, rng.choice(["box", "triangle", "hull"]))
        return [body, {**body, "radius": random_solids.radius(rng)}]
    return random_solids.touching_bodies(rng, kind)


def genuine(count, seed):
    """Certificates with patches: of spheres, capsules, hulls, boxes face on face, bodies on themselves, half-spaces, cones of all kinds."""
    rng, kinds, made = random.Random(seed), ["points", "box", "plane", "points", "same", *random_solids.KINDS], 0
    for kind in itertools.cycle(kinds):
        if made == count:
            return
        text = certificate("of_" + "_".join(map(str, kind if isinstance(kind, tuple) else [kind])), *bodies(kind, rng), rng)
        if can_have_patches(text):
            made += 1
            yield with_patches(text, rng)


def claimed(parts):
    """The corners of each patch, each its points of both bodies (of a half-space none), and the rates."""
    points, found = {x: body_of(parts.rows, x).get("points") for x in "ab"}, []
    for row in parts.rows["patches"]:
        if row == ["patch"]:
            found.append([])
        elif row[0] not in "ab":
            of_a = 1 + 2 * int(row[0])
            found[-1].append((combined_of(points["a"], row[1:of_a]), combined_of(points["b"], row[of_a + 1:])))
    return [sorted(corners) for corners in found], [tuple(map(Fraction, row)) for row in parts.rows.get("rates", [])]


def combined_of(points, words):
    total = O if points else ()
    for i, w in zip(words[::2], words[1::2]):
        total = plus(total, times(Fraction(w), points[int(i)]))
    return total


def is_true(parts):
    """Whether the patches and rates of a certificate whose other claims are true are those of the definitions."""
    points, found = patches_of(parts)
    corners, rates = claimed(parts)
    ends = lambda patch: sorted((p if points["a"] else (), plus(p, patch.t) if points["b"] else ()) for p in patch.corners)
    if corners != list(map(ends, found)) or (rates and not knows_all_optima(parts)):
        return False
    return all(sign * root == min(patch.rate(v, w) for patch in found) for *v, p, q, r, sign, root in rates for w in [(p, q, r)])
