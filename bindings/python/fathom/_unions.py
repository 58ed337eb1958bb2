# SPDX-License-Identifier: GPL-3.0-or-later
"""Depths of unions of convex pieces."""
from __future__ import annotations

from fractions import Fraction
from typing import Any, Callable, NamedTuple

from fathom import _fathom
from fathom._answers import PairAnswer
from fathom._types import FloatArray, Fractions, PoseLike, UnionLike


class PieceContact(NamedTuple):
    """A piece of A and a piece of B that touch."""

    pieces: tuple[int, int]  #: their indices, A's first
    direction: FloatArray  #: unit vector from B to A, correctly rounded: a plane across it has the two pieces on its two sides
    normal: tuple[int, ...]  #: the direction as integers, exact and primitive
    #: {"kind": "facet-vertex", "a": (0, 1, 2), "b": (5,)}: the features that meet, as indices of points of the pieces
    contact: dict[str, Any]
    #: of bodies made by `fathom.solid`, what of the mesh holds the contact, as {"kind": "edge", "ids": (3, 7)}: faces by their
    #: numbers, vertices and the ends of edges by their indices; else []
    mesh_a: list[dict[str, Any]]
    mesh_b: list[dict[str, Any]]


class UnionOptimum(NamedTuple):
    """One shortest way out."""

    translation: FloatArray  #: moving A by it makes the interiors disjoint; each component correctly rounded
    exact: Fractions  #: the same, exactly
    clearance: bool  #: False for an exact fit: all translations near it make the bodies overlap or touch
    contacts: list[PieceContact]  #: all pairs of pieces that touch then


class UnionDistance(NamedTuple):
    """How far apart two unions are."""

    distance: float  #: correctly rounded
    squared: Fraction
    pieces: tuple[int, int]  #: the first pair that is nearest
    translation: FloatArray  #: of A, after which the bodies touch
    witness: tuple[Fractions, Fractions]  #: a point of A and one of B that are nearest
    contact: dict[str, Any]  #: the features that are nearest
    mesh_a: list[dict[str, Any]]  #: of bodies made by `fathom.solid`, what of the mesh is nearest, as in PieceContact
    mesh_b: list[dict[str, Any]]


class UnionBounds(NamedTuple):
    """Bounds by simpler measures: the deepest pair is never deeper than the unions, their hulls never shallower."""

    deepest_pair: float  #: the depth of the deepest pair of pieces; if the search was stopped, of those that it came to
    pieces: tuple[int, int]  #: that pair, the first of several; (0, 0) if no two pieces overlap
    hulls: float  #: the depth of the convex hulls
    deepest_pair_squared: Fraction
    hulls_squared: Fraction


class UnionDepth(PairAnswer):
    """How deep two unions of convex pieces overlap, or how far apart they are. Floats are correctly rounded, Fractions exact.

    >>> import fathom
    >>> hit = fathom.union_depth(fathom.read_pieces("tests/data/key.obj"), fathom.read_pieces("tests/data/comb.obj"))
    >>> hit.status, hit.depth, hit.squared
    ('penetrating', 0.7905694150420949, Fraction(5, 8))
    >>> hit.translation, hit.bounds.deepest_pair, hit.bounds.hulls
    (array([-0.25,  0.75,  0.  ]), 0.5, 1.5)
    >>> fathom.check(hit.certificate()).accepted
    True
    """

    __slots__ = ()

    @property
    def complete(self) -> bool:
        """False if `stop` ended the search: then `low` and `high` enclose the depth."""
        return self._answer.complete

    @property
    def squared(self) -> Fraction | None:
        """depth^2. None unless complete."""
        return self.low_squared if self.complete else None

    @property
    def low(self) -> float:
        """The largest float that is at most the depth, or at most its lower bound."""
        return max(0.0, self._answer.low)

    @property
    def high(self) -> float:
        """The least float that is at least the depth, or at least its upper bound."""
        return max(0.0, self._answer.high)

    @property
    def low_squared(self) -> Fraction:
        """low_squared <= depth^2 <= high_squared: equal if the search is complete."""
        return self._answer.squares[0]

    @property
    def high_squared(self) -> Fraction:
        """The square of the length of the shortest way out that was found."""
        return self._answer.squares[1]

    @property
    def optima(self) -> list[UnionOptimum]:
        """All shortest ways out, in lexicographic order of translations; those found so far if the search was stopped. Of bodies that touch
        the one of length 0, with what touches; of disjoint ones none."""
        return [UnionOptimum(**{**fields, "contacts": [PieceContact(**met) for met in fields["contacts"]]})
                for fields in self._answer.optima]

    @property
    def apart(self) -> UnionDistance | None:
        """The distance, of disjoint bodies; else None."""
        fields = self._answer.apart
        return None if fields is None else UnionDistance(**fields)

    @property
    def bounds(self) -> UnionBounds | None:
        """The depths of the deepest pair and of the hulls; None if they were not asked for."""
        fields = self._answer.union_bounds
        return None if fields is None else UnionBounds(**fields)


def union_depth(a: UnionLike, b: UnionLike, *, pose_a: PoseLike = None, pose_b: PoseLike = None, bounds: bool = True,
                stop: Callable[[], bool] | None = None) -> UnionDepth:
    """Returns the exact penetration depth of two unions of convex pieces, with all shortest ways out; or their distance.

    a, b            a list of convex pieces, as `union` takes them; a body of `union`, `read_pieces` or `cases`; or one convex polytope
    pose_a, pose_b  exact maps of the whole bodies, as those of `depth`
    bounds          whether the depths of the deepest pair and of the hulls are found beside it
    stop            asked now and then, twenty times a second at most, whether the search is to end: then the answer is not `complete`,
                    and says between which bounds the depth lies

    The depth is the length of the shortest translation of A after which the interiors are disjoint, in the unit of the coordinates. Whether
    there is a path to it is not asked. Raises ValueError if there are no pieces, a piece has no interior (by its number), a coordinate is
    not finite or a piece is no polytope: one with a radius is refused, since the depth of unions with radii is not that of the unions plus
    the radii. Raises RuntimeError if `stop` ended the search before any bound was known. Ctrl-C raises KeyboardInterrupt, as in every call.

    >>> import fathom
    >>> walls = [fathom.box((5, 5, 5)).moved("xyz=-5,0,0"), fathom.box((5, 5, 5)).moved("xyz=6,0,0")]  # a slot as wide as the plate
    >>> plate = fathom.box(("1/2", 1, 1))
    >>> hit = fathom.union_depth(plate, walls, pose_a="xyz=5/4,0,0")
    >>> hit, hit.optima[0].exact[0], hit.optima[0].clearance
    (UnionDepth(penetrating, depth=0.75), Fraction(-3, 4), False)
    >>> [met.pieces for met in hit.optima[0].contacts]
    [(0, 0), (0, 1)]
    """
    if stop is not None and not callable(stop):
        raise TypeError(f"stop: expected a function, found {stop!r}")
    return UnionDepth(_fathom.union_depth(a, b, pose_a, pose_b, bounds, stop))
