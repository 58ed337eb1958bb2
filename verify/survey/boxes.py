#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pairs of boxes by name, as the shapes that libraries have colliders of their own for, one case a line:

    verify/survey/boxes.py tilted    a box on a box, 25 of each: exactly parallel, and tilted by 1e-9, 1e-4 and 0.01
    verify/survey/boxes.py real      the 47 of tests/data/real_shapes.jsonl

Numbers are sums and products of short ones alone, so that they are the same on every machine.
"""
import json
import pathlib
import random
import sys

REAL = pathlib.Path(__file__).resolve().parents[2] / "tests" / "data" / "real_shapes.jsonl"
TILTS = {"boxes_parallel": 0, "boxes_tilted_hair": 1e-9, "boxes_tilted_slightly": 1e-4, "boxes_tilted": 0.01}
COUNT = 25
AXES = ((1, 0), (0, 1), (0.6, 0.8), (-0.8, 0.6))


def product(p, q):
    (a, b, c, d), (e, f, g, h) = p, q
    return [a * e - b * f - c * g - d * h, a * f + b * e + c * h - d * g, a * g - b * h + c * e + d * f, a * h + b * g - c * f + d * e]


def pair(seed, tilt):
    """Puts A on B: turned about the vertical, by any angle or not at all, then about a horizontal line through its middle, 2^-k deep."""
    chance = random.Random(seed)
    a, b = ([chance.randint(8, 32) / 32 for _ in "xyz"] for _ in "ab")
    x, y = chance.choice(AXES)
    turn = [1, 0, 0, 0] if chance.random() < 0.5 else [chance.randint(1, 8), 0, 0, chance.randint(1, 8)]
    place = [chance.randint(-12, 12) / 32, chance.randint(-12, 12) / 32, a[2] + b[2] - 2.0**-chance.randint(5, 10)]
    return {"a": {"shape": "box", "half": a, "pose": {"quaternion": product([1, tilt / 2 * x, tilt / 2 * y, 0], turn),
                                                      "translation": place}}, "b": {"shape": "box", "half": b}}


def tilted():
    for family, tilt in TILTS.items():
        for seed in range(COUNT):
            yield json.dumps({"schema": "fathom/case/1", "id": f"{family}::{seed}", **pair(seed, tilt)})


def real():
    for line in REAL.read_text(encoding="utf-8").splitlines():
        case = json.loads(line)
        if case["a"].get("shape") == case["b"].get("shape") == "box":
            yield line


if __name__ == "__main__":
    if sys.argv[1:] not in (["tilted"], ["real"]):
        sys.exit(__doc__)
    print("\n".join(tilted() if sys.argv[1] == "tilted" else real()))
