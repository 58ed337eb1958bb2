# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes and the convex pieces that tile them, as certificates of format 5: cut here out of hulls by brute force, and judged by their
winding numbers, point by point."""
import itertools
from fractions import Fraction

Q = Fraction


def minus(p, q):
    return tuple(x - y for x, y in zip(p, q))


def dot(u, v):
    return sum(x * y for x, y in zip(u, v))


def det(u, v, w):
    return dot(cross(u, v), w)


def cross(u, v):
    return (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])


def normal(p, q, r):
    return cross(minus(q, p), minus(r, p))


def hull(points):
    """The facets of the hull, each its corners counter-clockwise from outside."""
    facets = {}
    for p, q, r in itertools.combinations(points, 3):
        n = normal(p, q, r)
        sides = [dot(n, minus(x, p)) for x in points]
        if any(n) and (min(sides) == 0 or max(sides) == 0):
            n = n if max(sides) == 0 else minus((0, 0, 0), n)
            flat = [x for x, side in zip(points, sides) if side == 0]
            facets.setdefault(frozenset(flat), round_about(flat, n))
    return list(facets.values())


def round_about(flat, n):
    corners = [min(flat)]
    while len(corners) == 1 or corners[-1] != corners[0]:
        p, best = corners[-1], None
        for q in flat:
            if q == p:
                continue
            turn = 0 if best is None else det(n, minus(best, p), minus(q, p))
            if best is None or turn < 0 or (turn == 0 and dot(minus(q, p), minus(q, p)) > dot(minus(best, p), minus(best, p))):
                best = q
        corners.append(best)
    return corners[:-1]


def cut(points, n, d):
    """The points below the plane <n,x> = d and in it, of their hull, then those above and in it; None where there are no others."""
    sides = [dot(n, p) - d for p in points]
    between = [tuple((x * t - y * s) / (t - s) for x, y in zip(p, q))
               for (p, s), (q, t) in itertools.permutations(zip(points, sides), 2) if s < 0 < t]
    parts = ([p for p, s in zip(points, sides) if keep * s >= 0] + sorted(set(between)) for keep in (-1, 1))
    return [part if any(keep * s > 0 for s in sides) else None for keep, part in zip((-1, 1), parts)]


def corners_of(facets):
    return sorted({p for f in facets for p in f})


def pieces_of(points, planes):
    parts = [points]
    for plane in planes:
        parts = [corners_of(hull(part)) for each in parts for part in cut(each, *plane) if part]
    return [hull(part) for part in parts]


def box(low, high):
    return [tuple(Q((low, high)[s >> k & 1][k]) for k in range(3)) for s in range(8)]


def fan(polygon):
    return [(polygon[0], p, q) for p, q in zip(polygon[1:], polygon[2:])]


def surface(facets):
    return [t for f in facets for t in fan(f)]


def turned(triangles):
    return [t[::-1] for t in triangles]


class Tiling:
    """Triangles and facets, by their corners. Or, once it is indexed, by numbers of points."""

    def __init__(self, mesh, pieces):
        self.mesh, self.pieces = [list(t) for t in mesh], [[list(f) for f in piece] for piece in pieces]

    def mapped(self, rows, shift):
        """Moved by a map of positive determinant."""
        image = lambda p: tuple(dot(row, p) + s for row, s in zip(rows, shift))
        return Tiling([map(image, t) for t in self.mesh], [[map(image, f) for f in piece] for piece in self.pieces])

    def indexed(self, rng=None):
        order = sorted({p for f in itertools.chain(self.mesh, *self.pieces) for p in f})
        if rng:
            rng.shuffle(order)
        number = {p: k for k, p in enumerate(order)}
        result = Tiling([[number[p] for p in t] for t in self.mesh], [[[number[p] for p in f] for f in piece] for piece in self.pieces])
        result.points = [list(map(str, p)) for p in order]
        return result

    def text(self, name=""):
        """Of an indexed one; its points are words."""
        rows = lambda word, rows: [f"{word} {len(rows)}", *(" ".join(map(str, row)) for row in rows)]
        lines = ["fathom-certificate 5", *([f"id {name}"] if name else []), *rows("solid_a", self.points), *rows("mesh", self.mesh)]
        lines.append(f"pieces {len(self.pieces)}")
        for piece in self.pieces:
            lines += rows("piece", [[len(f), *f] for f in piece])
        counts = [len(self.points), len(self.mesh), len(self.pieces), *map(len, self.pieces)]
        return "\n".join([*lines, "claim solid", " ".join(["end", *map(str, counts)])]) + "\n"

    def is_true(self, rng, places=24):
        """Whether the pieces hold points as often as the mesh goes around them: at places here and there, and near corners."""
        points = [tuple(map(Q, p)) for p in self.points]
        mesh, pieces = [[points[k] for k in t] for t in self.mesh], [[[points[k] for k in f] for f in piece] for piece in self.pieces]
        used = [p for f in itertools.chain(mesh, *pieces) for p in f]
        low, high = ([bound(p[k] for p in used) for k in range(3)] for bound in (min, max))
        for place in range(places):
            random = tuple(Q(rng.randrange(-10**5, 11 * 10**5), 10**6 + 3) for _ in range(3))
            x = tuple(l + (h - l) * t for l, h, t in zip(low, high, random))
            if place % 2:
                near, q = rng.choice(used), Q(1, 10**rng.randrange(1, 9))
                x = tuple(c + (y - c) * q for c, y in zip(near, x))
            if winding(mesh, x, rng) != sum(holds(piece, x) for piece in pieces):
                return False
        return True


def winding(mesh, x, rng):
    v = tuple(rng.randrange(-10**6, 10**6) for _ in range(3))
    total = 0
    for t in mesh:
        p, q, r = (minus(c, x) for c in t)
        n = normal(p, q, r)
        seen = [det(v, p, q), det(v, q, r), det(v, r, p)]
        if any(n) and (min(seen) > 0 or max(seen) < 0) and dot(n, p) * dot(n, v) > 0:
            total += 1 if dot(n, v) > 0 else -1
    return total


def holds(piece, x):
    return all(dot(normal(*f[:3]), minus(x, f[0])) < 0 for f in piece)


def extruded(polygon, height):
    """Of a polygon whose fan from its first corner may turn both ways."""
    low, high = ([(Q(x), Q(y), Q(z)) for x, y in polygon] for z in (0, height))
    sides = [(p, q, v, u) for p, q, u, v in zip(low, low[1:] + low[:1], high, high[1:] + high[:1])]
    return surface([low[::-1], high, *sides])


def two_tetrahedra():
    corners = [(Q(0),) * 3, *(tuple(Q(2 * (k == m)) for m in range(3)) for k in range(3))]
    return Tiling(surface(hull(corners)), pieces_of(corners, [((1, -1, 0), 0)]))


def ell():
    boxes = [hull(box((0, 0, 0), (3, 1, 1))), hull(box((0, 1, 0), (1, 3, 1)))]
    return Tiling(extruded([(3, 0), (3, 1), (1, 1), (1, 3), (0, 3), (0, 0)], 1), boxes)


def cavity():
    outer, inner = box((-3, -3, -3), (3, 3, 3)), box((-1, -1, -1), (1, 1, 1))
    pieces = [hull([p for p in outer + inner if p[k] * sign == max(map(abs, p))]) for k in range(3) for sign in (-1, 1)]
    return Tiling(surface(hull(outer)) + turned(surface(hull(inner))), pieces)


def joined(*tilings):
    return Tiling([t for each in tilings for t in each.mesh], [p for each in tilings for p in each.pieces])


def with_t_junction(tiling):
    p, q, r = tiling.mesh[0]
    middle = tuple((x + y) / 2 for x, y in zip(p, q))
    return Tiling([(p, middle, r), (middle, q, r), *tiling.mesh[1:]], tiling.pieces)


def with_flap(tiling):
    p, q, _ = tiling.mesh[0]
    flap = (p, q, tuple(5 + x for x in q))
    return Tiling([flap, *tiling.mesh, flap[::-1]], tiling.pieces)


def random_tiling(rng):
    """Of a random kind, in a random place."""
    number = lambda most: Q(rng.randint(-most, most), rng.choice((1, 1, 2, 3, 10, 1000)))
    kind = rng.randrange(5)
    if kind < 3:
        points = [tuple(number(5) for _ in range(3)) for _ in range(rng.randint(5, 8))]
        facets = hull(points)
        if len(facets) < 4:
            return random_tiling(rng)
        planes = [(n, dot(n, rng.choice(points)) + number(2)) for n in (tuple(number(4) for _ in range(3)) for _ in range(kind)) if any(n)]
        tiling = Tiling(surface(facets), pieces_of(corners_of(facets), planes))
    else:
        tiling = ell() if kind == 3 else cavity()
    for change, chance in ((with_t_junction, 0.3), (with_flap, 0.2)):
        tiling = change(tiling) if rng.random() < chance else tiling
    while True:
        rows, shift = [[number(4) for _ in range(3)] for _ in range(3)], [number(9) for _ in range(3)]
        if det(*rows) > 0:
            break
    moved = tiling.mapped(rows, shift)
    return joined(moved, random_tiling(rng)) if rng.random() < 0.2 else joined(moved, moved) if rng.random() < 0.1 else moved
