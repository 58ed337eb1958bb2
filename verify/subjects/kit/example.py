# SPDX-License-Identifier: Apache-2.0
"""A subject on fathom_subject.py: the boxes around two bodies, which are right about boxes along the axes."""
import fathom_subject


def solve(a, b):
    way = (float("inf"), None)  # how far along which axis A must go
    for axis in range(3):
        (low_a, high_a), (low_b, high_b) = ((min(p[axis] for p in body.vertices), max(p[axis] for p in body.vertices)) for body in (a, b))
        for sign, length in ((1, high_b - low_a), (-1, high_a - low_b)):
            way = min(way, (length, [sign * (i == axis) for i in range(3)]))
    return fathom_subject.Reply(way[0] > 0, *way)


fathom_subject.run(solve, name="boxes-python", version="1")
