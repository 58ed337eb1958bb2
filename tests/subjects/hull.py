# SPDX-License-Identifier: GPL-3.0-or-later
"""The facets of the convex hull of a few points, found exactly: every plane through three of them is tried. In the plane they are edges."""
import fractions
import itertools
import math


def cross(u, v):
    return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]


def dot(u, v):
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


def minus(u, v):
    return [x - y for x, y in zip(u, v)]


def integers(points):
    """The same points, all multiplied by one power of two that makes them whole."""
    exact = [[fractions.Fraction(x) for x in point] for point in points]
    scale = math.lcm(*(x.denominator for point in exact for x in point))
    return [[int(x * scale) for x in point] for point in exact]


def around(corners, normal, points):
    """The extreme ones of the coplanar `corners`, counter-clockwise seen from the side that the normal points to."""
    start = min(corners, key=lambda i: points[i])
    ring, at = [start], start
    while True:
        ahead = None
        for i in corners:  # gift wrapping: all others to the left; of those in line the farthest
            if points[i] == points[at]:
                continue
            if ahead is not None:
                to_i, to_ahead = minus(points[i], points[at]), minus(points[ahead], points[at])
                turn = dot(normal, cross(to_ahead, to_i))
                if turn > 0 or (turn == 0 and dot(to_i, to_i) <= dot(to_ahead, to_ahead)):
                    continue
            ahead = i
        if points[ahead] == points[start]:
            return ring
        ring.append(ahead)
        at = ahead


def one_side(points, indices, normal, offset):
    """(the side of the plane that all points are on: -1, 1, 0 for in it, None for both; those in it)"""
    side, corners = 0, []
    for i in indices:
        height = dot(normal, points[i]) - offset
        if height == 0:
            corners.append(i)
        elif side == 0:
            side = 1 if height > 0 else -1
        elif (height > 0) != (side > 0):
            return None, ()
    return side, tuple(corners)


def edges(points):
    up = [0, 0, 1]
    if not any(dot(up, cross(minus(p, points[0]), minus(q, points[0]))) for p, q in itertools.combinations(points, 2)):
        return []
    ring = around(range(len(points)), up, points)
    return [list(edge) for edge in zip(ring, ring[1:] + ring[:1])]


def facets(points):
    """Lists of indices, counter-clockwise from outside, one for each facet; [] for a body that is flat. Points that are no corners, and
    all but one of equal points, are in none. In the plane: the edges, each from corner to corner, one behind the other."""
    if len(points[0]) == 2:
        return edges(integers([[*point, 0] for point in points]))
    points = integers(points)
    first = {}
    for i, point in enumerate(points):
        first.setdefault(tuple(point), i)
    indices = sorted(first.values())
    found, seen = [], set()
    for i, j, k in itertools.combinations(indices, 3):
        normal = cross(minus(points[j], points[i]), minus(points[k], points[i]))
        if not any(normal):
            continue
        side, corners = one_side(points, indices, normal, dot(normal, points[i]))
        if side == 0:
            return []
        if side is None or corners in seen:
            continue
        seen.add(corners)
        found.append(around(corners, [-side * x for x in normal], points))
    return found
