# SPDX-License-Identifier: GPL-3.0-or-later
"""A subject that misbehaves as the first coordinate of A says, and answers about shapes with what it was told of them."""
import os

import fathom_subject
from fathom_subject import Reply, Unsupported

print("a greeting of a library", flush=True)


class Wordless(Exception):
    def __str__(self):
        raise ValueError("no text")


def solve(a, b):
    if a.shape and b.shape == a.shape:
        return Reply(True, hull=(a.rotation, b.rotation))
    if a.shape:
        along = [row["xyz".index(a.axis)] for row in a.rotation]
        return Reply(True, a.radius + a.margin, along, (a.translation, b.half if b.shape else b.vertices[-1]))
    if b.pieces:
        return Reply(True, len(b.pieces), witness=(a.vertices[0], b.pieces[-1]["vertices"][-1]))
    what = a.vertices[0][0]
    if what == 1:
        return Reply(True, float("nan"), [float("inf"), float("-inf"), -0.5])
    if what == 2:
        print("a stray line", flush=True)
        os.write(1, b"and one from below\n")
    if what == 3:
        raise ValueError('no "way" out')
    if what == 4:
        raise Unsupported("too flat")
    if what == 6:
        return Reply(True, 0.25, hull=(a.vertices, None))
    if what == 7:
        return Reply(True, 0.25, contacts=[(a.vertices[0], None), (a.vertices[1], 0.25)])
    if what == 8:
        return Reply(False, distance=float("inf"))
    if what == 9:
        raise ValueError("half a pair: \ud800")
    if what == 10:
        raise ValueError("x" * (17 << 20))
    if what == 11:
        raise Wordless()
    if what == 12:
        return Reply(True, 1, [1, 0])
    if what == 13:
        return Reply(True, microseconds=12.5)
    if what == 14:
        return Reply(True, witness=(a.vertices[1], b.vertices[1]))
    if what == 15:
        return Reply(True, derivative=a.twist[0][0] + b.twist[1][2])
    return Reply(False) if what == 5 else Reply(True, 1 / 3 + len(a.faces))


fathom_subject.run(solve, name="trial", version="7", precision={"points": "binary32", "answers": "binary64"}, touching="overlap",
                   depth="negative", moves="b", unit=False, faces=True, twist=True, shapes=["capsule", "box", "margin"], promises=["depth"],
                   settings={"limit": "3"}, rounding={"vertices": 0.1, "box": 0.25}, manifold={"most": 4, "margin": 0.125},
                   claims="separating", axis=os.environ.get("FATHOM_KIT_AXIS"),
                   dimension=2 if os.environ.get("FATHOM_KIT_PLANE") else 3)
