#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A subject that tells the derivative of the depth by finite differences, on the kit, over a separating axis test in doubles.

    differences.py                  central: (depth(h) - depth(-h)) / 2h, as a numerical gradient is taken
    differences.py forwards         (depth(h) - depth(0)) / h
    differences.py central 1e-3     with another step h than 1e-6

Where the depth has a kink, as while a box lies flat on another, central differences tend to the mean of two rates, which is neither.
"""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "subjects" / "kit"))
import fathom_subject  # noqa: E402

HOW = sys.argv[1] if len(sys.argv) > 1 else "central"
STEP = float(sys.argv[2]) if len(sys.argv) > 2 else 1e-6


def minus(p, q): return [p[i] - q[i] for i in range(3)]
def dot(p, q): return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]
def cross(p, q): return [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]


def axes(bodies):
    """Facet normals and cross products of edges, of unit length; near parallel edges have none."""
    edges = [[minus(p[f[i]], p[f[i - 1]]) for f in faces for i in range(len(f)) if f[i] > f[i - 1]] for p, faces in bodies]
    for points, faces in bodies:
        for f in faces:
            edges_of_face = minus(points[f[1]], points[f[0]]), minus(points[f[2]], points[f[0]])
            normal = cross(*edges_of_face)
            yield [x / math.hypot(*normal) for x in normal]
    for e in edges[0]:
        for f in edges[1]:
            axis, length = cross(e, f), math.hypot(*cross(e, f))
            if length > 1e-9 * math.hypot(*e) * math.hypot(*f):
                yield [x / length for x in axis]


def way_out(a, b):
    """The least way of A along an axis after which a plane across it parts the bodies, and its direction."""
    least = (math.inf, None)
    for axis in axes((a, b)):
        of_a, of_b = [dot(axis, p) for p in a[0]], [dot(axis, p) for p in b[0]]
        least = min(least, (max(of_b) - min(of_a), axis), (max(of_a) - min(of_b), [-x for x in axis]))
    return least


def moved(body, time):
    """The body so long after it began to move; how it goes on does not matter to a derivative."""
    v, w = body.twist
    return [[p[i] + time * (v[i] + cross(w, p)[i]) for i in range(3)] for p in body.vertices], body.faces


def solve(a, b):
    if not a.faces or not b.faces:
        raise fathom_subject.Unsupported("a flat body")
    depth, direction = way_out((a.vertices, a.faces), (b.vertices, b.faces))
    reply = fathom_subject.Reply(depth > 0, depth, direction)
    if depth > 0 and a.twist:  # of bodies that are apart the test does not know the distance
        after = {time: way_out(moved(a, time), moved(b, time))[0] for time in (STEP, -STEP)}
        reply.derivative = (after[STEP] - after[-STEP]) / (2 * STEP) if HOW == "central" else (after[STEP] - depth) / STEP
    return reply


fathom_subject.run(solve, name="differences-" + HOW, version="1", faces=True, twist=True, settings={"step": STEP})
