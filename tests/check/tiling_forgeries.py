#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Forges certificates of solids, and demands that all checkers agree on each and accept none whose claim is untrue.

tiling_forgeries.py --checker COMMAND [--checker COMMAND].. [--count N] [--share K] [--seed S] [FILE..]

The genuine ones are those of the files, and others cut here out of hulls. Of NEVER none may be accepted; ALWAYS say the same in other
words; MAYBE is judged by winding numbers where it is accepted. Exit codes: 0 fine; 1 a fault; 2 usage.
"""
import collections
import copy
import pathlib
import random
import sys
import tempfile
from fractions import Fraction

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parent))
import forgeries  # noqa: E402
import tilings  # noqa: E402


def read(text):
    """A certificate of format 5, without id."""
    lines = [line.split(" ") for line in text.split("\n")[:-1] if not line.startswith(("#", "id "))]
    result, at = tilings.Tiling([], []), 1

    def part():
        nonlocal at
        count = int(lines[at][1])
        at += 1 + count
        return lines[at - count:at]

    result.points = part()
    result.mesh = [list(map(int, row)) for row in part()]
    at += 1
    for _ in range(int(lines[at - 1][1])):
        result.pieces.append([list(map(int, row[1:])) for row in part()])
    return result


def values(t):
    return [tuple(map(Fraction, p)) for p in t.points]


def add_point(t, p):
    t.points.append(list(map(str, p)))
    return len(t.points) - 1


def add_box(t, size):
    """A box beside all else, as a list of facets."""
    far = max(abs(x) for p in values(t) for x in p) + 1
    facets = tilings.hull([tuple(far + size * x for x in p) for p in tilings.box((0, 0, 0), (1, 1, 1))])
    number = {p: add_point(t, p) for p in tilings.corners_of(facets)}
    return [[number[p] for p in f] for f in facets]


def some_facet(t, rng, least=3):
    found = [f for piece in t.pieces for f in piece if len(f) >= least]
    return rng.choice(found) if found else None


def solid_triangles(t):
    p = values(t)
    return [k for k, f in enumerate(t.mesh) if any(tilings.normal(*(p[i] for i in f)))]


# What is not true, or not a tiling by polytopes in normal form. Each changes t; False where it does not apply.

def piece_gone(t, rng):
    del t.pieces[rng.randrange(len(t.pieces))]


def piece_twice(t, rng):
    t.pieces.append(rng.choice(t.pieces))


def piece_moved(t, rng):
    """It overlaps on one side and leaves a gap of the same volume on the other."""
    k, p = rng.randrange(len(t.pieces)), values(t)
    by = Fraction(1, 10**rng.randrange(0, 20))
    number = {i: add_point(t, (p[i][0] + by, *p[i][1:])) for i in {i for f in t.pieces[k] for i in f}}
    t.pieces[k] = [[number[i] for i in f] for f in t.pieces[k]]


def piece_inside_out(t, rng):
    k = rng.randrange(len(t.pieces))
    t.pieces[k] = [f[::-1] for f in t.pieces[k]]


def box_and_the_same_inside_out(t, rng):
    box = add_box(t, 1)
    t.pieces += [box, [f[::-1] for f in box]]


def box_inside_out_in_mesh_and_pieces(t, rng):
    box = [f[::-1] for f in add_box(t, 1)]
    t.pieces.append(box)
    t.mesh += [list(x) for x in tilings.surface(box)]


def cavity_filled(t, rng):
    """A box whose shell is turned inwards, and its piece."""
    box = add_box(t, 1)
    t.mesh += [list(x) for x in tilings.turned(tilings.surface(box))]
    if rng.random() < 0.5:
        t.pieces.append(box)


def two_pieces_as_one(t, rng):
    if len(t.pieces) < 2:
        return False
    a, b = rng.sample(range(len(t.pieces)), 2)
    t.pieces[a] = t.pieces[a] + t.pieces[b]
    del t.pieces[b]


def flat_piece(t, rng):
    f = some_facet(t, rng)
    t.pieces.append([f, f[::-1]])


def facet_gone(t, rng):
    piece = rng.choice(t.pieces)
    del piece[rng.randrange(len(piece))]


def facet_twice(t, rng):
    piece = rng.choice(t.pieces)
    piece.append(rng.choice(piece))


def facet_reversed(t, rng):
    some_facet(t, rng).reverse()


def corners_exchanged(t, rng):
    f = some_facet(t, rng)
    i, k = rng.sample(range(len(f)), 2)
    f[i], f[k] = f[k], f[i]


def facet_twice_round(t, rng):
    f = some_facet(t, rng)
    f += f


def facet_in_two(t, rng):
    f = some_facet(t, rng, 4)
    if f is None:
        return False
    piece = next(piece for piece in t.pieces if any(g is f for g in piece))
    piece.append([f[0], *f[2:]])
    del f[3:]


def corner_gone(t, rng):
    f = some_facet(t, rng)
    del f[rng.randrange(len(f))]


def triangle_gone(t, rng):
    del t.mesh[rng.choice(solid_triangles(t))]


def triangle_reversed(t, rng):
    t.mesh[rng.choice(solid_triangles(t))].reverse()


def triangle_twice(t, rng):
    t.mesh.append(t.mesh[rng.choice(solid_triangles(t))])


def mesh_inside_out(t, rng):
    t.mesh = [x[::-1] for x in t.mesh]


def mesh_twice(t, rng):
    t.mesh = t.mesh * 2


def point_twice(t, rng):
    add_point(t, rng.choice(values(t)))


def nearly_the_same_point(t, rng):
    f, k = rng.choice([some_facet(t, rng), t.mesh[rng.choice(solid_triangles(t))]]), rng.randrange(3)
    x, y, z = values(t)[f[k]]
    f[k] = add_point(t, (x, y, z + Fraction(1, 10**30)))


def index_too_large(t, rng):
    f = rng.choice([some_facet(t, rng), rng.choice(t.mesh)])
    f[rng.randrange(len(f))] = rng.choice((len(t.points), 2**32 - 1, 2**32, 2**64, 2**64 + 1))


def no_pieces(t, rng):
    t.pieces.clear()
    t.mesh = [] if rng.random() < 0.5 else t.mesh


def no_facets(t, rng):
    t.pieces.append([])


# What says the same.

def numbers_not_in_lowest_terms(t, rng):
    for p in t.points:
        k, factor = rng.randrange(3), rng.choice((2, 3, 7**20))
        x = Fraction(p[k])
        p[k] = f"{x.numerator * factor}/{x.denominator * factor}"


def lists_in_another_order(t, rng):
    rng.shuffle(t.mesh)
    rng.shuffle(t.pieces)
    for f in [*t.mesh, *(f for piece in t.pieces for f in piece)]:
        k = rng.randrange(len(f))
        f[:] = f[k:] + f[:k]
    for piece in t.pieces:
        rng.shuffle(piece)


def all_twice(t, rng):
    t.mesh, t.pieces = t.mesh * 2, t.pieces * 2


def triangle_without_area(t, rng):
    p, (i, j, _) = values(t), t.mesh[0]
    on = add_point(t, [x + (y - x) / (10**9 + 7) for x, y in zip(p[i], p[j])]) if rng.random() < 0.5 else j
    t.mesh.append([i, j, on])


def unused_point(t, rng):
    add_point(t, [12345 + rng.randrange(10**9), 0, 0])


ALWAYS = (numbers_not_in_lowest_terms, lists_in_another_order, all_twice, triangle_without_area, unused_point)


# What nobody knows.

def corner_on_an_edge(t, rng):
    """In both facets that share it."""
    p, f = values(t), some_facet(t, rng)
    u, v = f[-1], f[0]
    middle = add_point(t, [(x + y) / 2 for x, y in zip(p[u], p[v])])
    for g in next(piece for piece in t.pieces if any(g is f for g in piece)):
        for k in range(len(g)):
            if {g[k - 1], g[k]} == {u, v}:
                g.insert(k, middle)
                break


def index_changed(t, rng):
    f = rng.choice([some_facet(t, rng), rng.choice(t.mesh)])
    f[rng.randrange(len(f))] = rng.randrange(len(t.points))


def point_moved(t, rng):
    p = rng.choice(t.points)
    k = rng.randrange(3)
    p[k] = str(Fraction(p[k]) + rng.choice((1, -1, Fraction(1, 2), Fraction(1, 10**12), -Fraction(1, 10**12))))


def point_on_another(t, rng):
    """In the mesh alone."""
    i, j = rng.sample(range(len(t.points)), 2)
    t.mesh = [[j if k == i else k for k in f] for f in t.mesh]


def pieces_exchanged_in_part(t, rng):
    a, b = rng.choice(t.pieces), rng.choice(t.pieces)
    i, j = rng.randrange(len(a)), rng.randrange(len(b))
    a[i], b[j] = b[j], a[i]


MAYBE = (corner_on_an_edge, index_changed, point_moved, point_on_another, pieces_exchanged_in_part)
NEVER = (piece_gone, piece_twice, piece_moved, piece_inside_out, box_and_the_same_inside_out, box_inside_out_in_mesh_and_pieces,
         cavity_filled, two_pieces_as_one, flat_piece, facet_gone, facet_twice, facet_reversed, corners_exchanged, facet_twice_round,
         facet_in_two, corner_gone, triangle_gone, triangle_reversed, triangle_twice, mesh_inside_out, mesh_twice,
         point_twice, nearly_the_same_point, index_too_large, no_pieces, no_facets)


class Campaign:
    def __init__(self, options, folder, rng):
        self.options, self.folder, self.rng = options, pathlib.Path(folder), rng
        self.tries, self.accepted, self.faults = collections.Counter(), collections.Counter(), []

    def fault(self, sentence, text):
        path = pathlib.Path(tempfile.gettempdir()) / f"tiling_forgery_{len(self.faults)}.cert"
        path.write_text(text)
        self.faults.append(f"{sentence}: {path}")

    def judge(self, batch):
        """batch: (kind, tiling, whether it must be accepted; None: nobody knows)."""
        texts = [t.text() for _, t, _ in batch]
        found = forgeries.verdicts_of(self.options, self.folder, texts, self.fault)
        for (kind, t, expected), name, text in zip(batch, found, texts):
            accepted = found[name] == (f"VERIFIED solid triangles={len(t.mesh)} pieces={len(t.pieces)}",)
            self.tries[kind] += 1
            self.accepted[kind] += accepted
            if expected not in (None, accepted):
                self.fault(f"{kind}: {found[name]}", text)
            elif accepted and not t.is_true(self.rng):
                self.fault(f"{kind}: what is accepted is not true", text)


def main():
    parser = forgeries.campaign_arguments(2000)
    parser.add_argument("files", nargs="*", type=pathlib.Path)
    options = parser.parse_args()
    rng = random.Random(options.seed)
    genuine = [read(file.read_text()) for file in options.files] + [tilings.random_tiling(rng).indexed(rng) for _ in range(40)]
    kinds = [*((change, False) for change in NEVER), *((change, True) for change in ALWAYS), *((change, None) for change in MAYBE * 3)]
    batch = []
    while len(batch) < options.count:
        (change, expected), t = kinds[len(batch) % len(kinds)], copy.deepcopy(rng.choice(genuine))
        if change(t, rng) is not False:
            batch.append((change.__name__, t, expected))
    with tempfile.TemporaryDirectory() as folder:
        campaign = Campaign(options, folder, rng)
        for k in range(0, len(batch), forgeries.BATCH):
            campaign.judge([("genuine", t, True) for t in genuine] * (k == 0) + batch[k:k + forgeries.BATCH])
    print(f"{len(batch)} forgeries of {len(genuine)}; accepted {dict(+campaign.accepted)} of {dict(campaign.tries)}")
    for fault in campaign.faults[:20]:
        print(fault)
    return 1 if campaign.faults else 0


if __name__ == "__main__":
    sys.exit(main())
