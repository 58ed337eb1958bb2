# SPDX-License-Identifier: Apache-2.0
"""How a project that computes penetration depths tests itself with golden cases and pytest.

fathom_golden.py and the sample, both from the golden kit, are copied beside this file; `fathom golden export --format json` makes other
cases.
"""
import itertools
import math
import pathlib

import fathom_golden
import pytest

CASES = fathom_golden.read(pathlib.Path(__file__).parent / "fathom_golden_sample.json")
TOLERANCE = {"relative": 1e-9, "absolute": 1e-12}


# ---- what stands for the project's own code: the separating axis test over all triples of points and all pairs of differences ----

def minus(p, q): return [p[i] - q[i] for i in range(3)]
def dot(p, q): return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]
def cross(p, q): return [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]


def penetration(a, b, pairs_of_edges=True):
    """(depth, direction) of two bodies that overlap, or None."""
    edges = [[minus(p, q) for p, q in itertools.combinations(body, 2)] for body in (a, b)]
    axes = [cross(minus(q, p), minus(r, p)) for body in (a, b) for p, q, r in itertools.combinations(body, 3)]
    if pairs_of_edges:
        axes += [cross(e, f) for e in edges[0] for f in edges[1]]
    best = math.inf, None
    for axis in axes:
        length = math.sqrt(dot(axis, axis))
        if length == 0:
            continue
        of_a, of_b = ([dot(axis, p) / length for p in body] for body in (a, b))
        for depth, direction in ((max(of_b) - min(of_a), axis), (max(of_a) - min(of_b), [-x for x in axis])):
            if depth < best[0]:
                best = depth, direction
    return best if best[0] > 0 else None


# ---- the tests ----

def is_right(case, **options):
    answer = penetration(case.a, case.b, **options)
    if answer is None:
        return fathom_golden.accept_apart(case, **TOLERANCE)
    depth, direction = answer
    return fathom_golden.accept(case, direction, depth, **TOLERANCE)


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)
def test_penetration(case):
    assert is_right(case)


def test_without_pairs_of_edges_it_is_found_to_be_wrong():
    assert not all(is_right(case, pairs_of_edges=False) for case in CASES)
