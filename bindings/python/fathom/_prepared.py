# SPDX-License-Identifier: GPL-3.0-or-later
"""Polytopes whose hull is computed once, for questions in many poses."""
from __future__ import annotations

from fathom import _fathom
from fathom._answers import Depth, _question
from fathom._types import BodyLike, Number, PoseLike


class Prepared:
    """A polytope whose hull is computed once, for any number of questions in other poses: the answers are those of `depth`, `overlap` and
    `closer_than`, sooner. Fastest are points of floats, and poses as arrays of floats.

    >>> import fathom
    >>> import numpy as np
    >>> a, b = (fathom.Prepared([(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]) for _ in "ab")
    >>> start = []
    >>> for x in (0.5, 0.75, 1.0):
    ...     pose = np.array([[1, 0, 0, x], [0, 1, 0, 0], [0, 0, 1, 0]])
    ...     print(a.depth(b, pose_b=pose, start=start))
    Depth(penetrating, depth=0.5)
    Depth(penetrating, depth=0.25)
    Depth(touching, depth=0.0)
    """

    __slots__ = ("_prepared",)

    def __init__(self, body: BodyLike) -> None:
        self._prepared = _fathom.Prepared(body)

    @property
    def body(self) -> _fathom.Body:
        """The polytope in its original pose."""
        return self._prepared.body

    @property
    def extreme_points(self) -> tuple[int, ...]:
        """The indices of its extreme points, of equal points the lowest."""
        return self._prepared.extreme_points

    def depth(self, other: Prepared, *, pose_a: PoseLike = None, pose_b: PoseLike = None, start: list[tuple[int, int]] | None = None,
              optima: int | None = None) -> Depth:
        """Returns `fathom.depth(self.body, other.body, pose_a=pose_a, pose_b=pose_b, optima=optima)`, but for its `method`, which is None.

        start  where the search begins, for a pair that moves: a list, empty for the first call, in which each call leaves what it has
               ended with: at most 8 pairs of indices of points of a and b. No answer depends on it
        """
        return Depth(self._prepared.depth(other._prepared, pose_a, pose_b, start, _question("automatic", optima, 1)[1]))

    def overlap(self, other: Prepared, *, pose_a: PoseLike = None, pose_b: PoseLike = None) -> str:
        """Returns "penetrating", "touching" or "disjoint", without finding the depth."""
        return self._prepared.overlap(other._prepared, pose_a, pose_b)

    def closer_than(self, other: Prepared, distance: Number, *, pose_a: PoseLike = None, pose_b: PoseLike = None) -> bool:
        """Returns whether a point of a and a point of b are less than `distance` apart."""
        return self._prepared.closer_than(other._prepared, distance, pose_a, pose_b)

    def __repr__(self) -> str:
        return f"Prepared({len(self.extreme_points)} extreme points)"
