# SPDX-License-Identifier: GPL-3.0-or-later
"""Certificates of format 6 for tests: a second writer, which tries all planes of facets and edges, and the truth at single times."""
import copy
import importlib.util
import itertools
import pathlib
from fractions import Fraction

_spec = importlib.util.spec_from_file_location("check", pathlib.Path(__file__).parent / ".." / ".." / "verify" / "check" / "check.py")
check = importlib.util.module_from_spec(_spec)
_spec.loader.exec_module(check)
dot, cross = check.dot, check.cross

REST = [[1, 0, 0, 0], [1, 0, 0, 0], [0, 0, 0], [0, 0, 0]]


def box(low, high):
    return [list(p) for p in itertools.product(*zip(low, high))]


class Motion:
    """Two bodies, how they move, and what is claimed: each piece is [kind, end, numbers, [weights of a, weights of b]]."""

    def __init__(self, a, b, motion_a=None, motion_b=None):
        self.bodies, self.motions = [a, b], [motion_a or REST, motion_b or REST]
        self.claim, self.pieces, self.weights = ["apart"], [], None

    def text(self, name=None):
        rows = lambda word, lines: [f"{word} {len(lines)}"] + [" ".join(map(str, row)) for row in lines]
        lines, counts = ["fathom-certificate 6"] + [f"id {name}"] * bool(name), [len(body) for body in self.bodies] + [len(self.pieces)]
        lines += [line for word, body in zip("ab", self.bodies) for line in rows(word, body)]
        for word, motion in zip(("motion_a", "motion_b"), self.motions):
            lines += [word] + [" ".join(map(str, row)) for row in motion]
        lines += ["claim " + " ".join(map(str, self.claim)), f"pieces {len(self.pieces)}"]
        for kind, end, numbers, weights in self.pieces + ([["", "", "", self.weights]] if self.weights else []):
            lines += [" ".join(map(str, [end, kind, *numbers]))] if kind else []
            for word, each in zip(("weights_a", "weights_b"), weights or ()):
                lines += rows(word, each)
                counts.append(len(each))
        return "\n".join(lines + ["end " + " ".join(map(str, counts))]) + "\n"

    def copy(self):
        return copy.deepcopy(self)

    # ---- single times, by definition ----
    def place(self, x, t):
        """Where the points of a body are."""
        q0, q1, p0, p1 = ([Fraction(n) for n in row] for row in self.motions[x])
        r, *v = ((1 - t) * y + t * z for y, z in zip(q0, q1))
        w = r * r + dot(v, v)
        if w == 0:
            return None
        p = [(1 - t) * y + t * z for y, z in zip(p0, p1)]
        points = [[Fraction(n) for n in point] for point in self.bodies[x]]
        return [[y + z / w for y, z in zip(p, check.rotated(r, v, point))] for point in points]

    def meet_at(self, t):
        """Whether they have a point in common: no facet of the difference body has O strictly outside. None: a quaternion is O."""
        a, b = self.place(0, t), self.place(1, t)
        if not (a and b):
            return None
        sides = [edges for body in (a, b) for edges in [[[y - x for x, y in zip(p, q)] for p, q in itertools.combinations(body, 2)]]]
        normals = [cross(u, v) for u, v in [*itertools.combinations(sides[0], 2), *itertools.combinations(sides[1], 2),
                                            *itertools.product(*sides)]]
        if not normals:  # of segments and points: where the difference body, a segment, is nearest to O
            ends = [[x - y for x, y in zip(p, q)] for p in a for q in b]
            normals = ends + [foot(p, q) for p, q in itertools.combinations(ends, 2)]
        for n in filter(any, normals + [check.minus(n) for n in normals]):
            if min(dot(n, p) for p in a) > max(dot(n, p) for p in b):
                return False
        return True

    # ---- the writer ----
    def candidates(self):
        edges = [[[y - x for x, y in zip(p, q)] for p, q in itertools.combinations(body, 2)] for body in self.bodies]
        for kind, own in (("b", edges[1]), ("a", edges[0])):
            for u, v in itertools.combinations(own, 2):
                for sign in (1, -1):
                    yield kind, [sign * n for n in cross(u, v)]
        for u, v in itertools.product(*edges):
            for sign in (1, -1):
                yield "ab", [sign * n for n in u] + list(v)

    def holds(self, c, kind, row, begin, end):
        try:
            check.require_apart(c, kind, row, begin, end)
            return True
        except check.Refused:
            return False

    def prove(self, rng, bits=10):
        """Pieces as far as planes are found, in units of 2^-bits; the points and places must be integers. The end."""
        c = {"unit": 1, **{x: [tuple(p) for p in body] for x, body in zip("ab", self.bodies)},
             **{"motion_" + x: [tuple(row) for row in motion] for x, motion in zip("ab", self.motions)}}
        self.pieces, done, grid = [], 0, 2**bits
        planes = [plane for plane in self.candidates() if any(plane[1])]
        rng.shuffle(planes)
        while done < grid:
            t = Fraction(done, grid)
            found = next((plane for plane in planes if self.holds(c, *plane, t, t)), None)
            if found is None:
                break
            low, high = done, grid + 1  # holds up to low, and not up to high
            while high - low > 1:
                middle = (low + high) // 2
                low, high = (middle, high) if self.holds(c, *found, t, Fraction(middle, grid)) else (low, middle)
            if low == done:
                break
            self.pieces.append([found[0], Fraction(low, grid), found[1], None])
            done = low
        return Fraction(done, grid)

    def contact_in_box(self, t):
        """If a corner of A is at t in B, which is a box: the weights."""
        low, high = self.bodies[1][0], self.bodies[1][-1]
        q0, q1, p0, p1 = ([Fraction(n) for n in row] for row in self.motions[1])
        r, *v = ((1 - t) * y + t * z for y, z in zip(q0, q1))
        p = [(1 - t) * y + t * z for y, z in zip(p0, p1)]
        for k, corner in enumerate(self.place(0, t)):
            inside = [n / (r * r + dot(v, v)) for n in check.rotated(r, check.minus(v), [x - y for x, y in zip(corner, p)])]
            shares = [(x - low_x) / Fraction(high_x - low_x) for x, low_x, high_x in zip(inside, low, high)]
            if all(0 <= share <= 1 for share in shares):
                weights = [[j, share_of(bits, shares)] for j, bits in enumerate(itertools.product((0, 1), repeat=3))]
                self.claim, self.weights = ["contact", t], [[[k, 1]], [row for row in weights if row[1] > 0]]
                return True
        return False


def foot(p, q):
    """Where the line through two points is nearest to O."""
    along = [y - x for x, y in zip(p, q)]
    t = -dot(p, along) / (dot(along, along) or 1)
    return [x + t * y for x, y in zip(p, along)]


def share_of(bits, shares):
    product = Fraction(1)
    for bit, share in zip(bits, shares):
        product *= share if bit else 1 - share
    return product


def random_motion(rng):
    """A tetrahedron or a box, and a box; a certificate that all accept, or None."""
    corner = lambda: [rng.randint(-3, 3) for _ in range(3)]
    a = [corner() for _ in range(4)] if rng.random() < 0.6 else box([-1, -2, -1], [1, 1, 2])
    turning = lambda: [rng.choice([[1, 0, 0, 0], [2, 0, 1, 0], [3, 1, -1, 1], [1, 1, 0, -1]]) for _ in "ab"]
    far = [rng.choice([-9, 9]), rng.randint(-6, 6), rng.randint(-6, 6)]
    to = [rng.randint(-9, 9) for _ in range(3)]
    m = Motion(a, box([-2, -1, -2], [2, 2, 1]), [*turning(), far, to],
               [*turning(), [0, 0, 0], [0, 0, 0]] if rng.random() < 0.4 else None)
    end = m.prove(rng)
    if end == 1:
        return m
    later = end + Fraction(rng.choice([1, 8, 40]), 1024)
    return m if m.pieces and later <= 1 and m.contact_in_box(later) else None
