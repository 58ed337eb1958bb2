# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies at random, and their certificates (solids.py)."""
import random
from fractions import Fraction

from cores import O, Core, combined, plus, root, times
from solids import certificate

KINDS = [(0, 1), (0, 2), (0, 3), (0, 4), (0, 5), (1, 0), (1, 1), (1, 2), (2, 0), (2, 1), (3, 0)]  # lineality and rays of cones


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
            "box": lambda: [[plus(c, plus(times(x, u), plus(times(y, v), times(z, w))))] for x in (-r, r) for y in (-s, s)
                            for z in (-t, t)]}
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
