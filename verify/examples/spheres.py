#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A subject that takes balls as balls, on the kit: it is right about two of them, and declines everything else."""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "subjects" / "kit"))
import fathom_subject  # noqa: E402


def solve(a, b):
    if a.shape != "sphere" or b.shape != "sphere":
        raise fathom_subject.Unsupported("only balls")
    way = [p - q for p, q in zip(a.translation, b.translation)]  # A leaves away from B's centre
    distance = math.hypot(*way)
    depth = a.radius + a.margin + b.radius + b.margin - distance
    return fathom_subject.Reply(depth > 0, depth, [x / distance for x in way] if distance else [1, 0, 0])


fathom_subject.run(solve, name="spheres", version="1", shapes=["sphere", "margin"])
