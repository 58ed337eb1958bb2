# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies that need not be convex: unions of convex pieces, and their depth."""
from __future__ import annotations

import os
from fractions import Fraction
from typing import Any, Callable, Iterable, NamedTuple

from fathom import _fathom
from fathom._answers import keep
from fathom._fathom import Body
from fathom._types import BodyLike, FloatArray, FractionTriple, PoseLike, UnionLike


keep(_fathom.UnionAnswer, "union_depth")


def union(pieces: Iterable[BodyLike]) -> Body:
    """The union of convex pieces: of each the hull of an array of points, of a list of points, of a mesh, or a body that is a polytope.

    Pieces may overlap, abut and repeat: where two meet in a common face there is no gap. A mesh with `faces` that is not convex is taken as
    its hull, with a NotConvexWarning. `union_depth` takes the list as well; a body can be posed, and keeps what was read.

    >>> import fathom
    >>> fathom.union([fathom.box((1, 1, 1)), fathom.box((2, "1/3", 1))])
    <fathom.Body, a union of 2 pieces>
    """
    return _fathom.union(pieces)


def read_pieces(path: str | os.PathLike[str], decimals: str = "binary64") -> Body:
    """The union of the pieces in an OBJ file, one for each object or group with faces; or in a folder, one for each mesh file there.

    So tools for convex decomposition write them (docs/unions.md). Another mesh file is one piece. A group or file that is not convex is
    taken as its hull, with a NotConvexWarning.

    decimals  what "0.1" in a text file stands for: "binary64", the nearest float, as other programs read it; or "exact", 1/10

    >>> import fathom
    >>> key = fathom.read_pieces("tests/data/key.obj")
    >>> len(key.pieces), key.pieces[0].shape
    (3, (8, 3))
    """
    return _fathom.read_pieces(os.fspath(path), decimals)


class PieceContact(NamedTuple):
    """A piece of A and a piece of B that touch."""

    pieces: tuple[int, int]  #: their indices, A's first
    direction: FloatArray  #: unit vector from B to A, correctly rounded: a plane across it has the two pieces on its two sides
    normal: tuple[int, int, int]  #: the direction as integers, exact and primitive
    #: {"kind": "facet-vertex", "a": (0, 1, 2), "b": (5,)}: the features that meet, as indices of points of the pieces
    contact: dict[str, Any]


class UnionOptimum(NamedTuple):
    """One shortest way out."""

    translation: FloatArray  #: moving A by it makes the interiors disjoint; each component correctly rounded
    exact: FractionTriple  #: the same as three Fractions
    clearance: bool  #: False for an exact fit: all translations near it make the bodies overlap or touch
    contacts: list[PieceContact]  #: all pairs of pieces that touch then


class UnionDistance(NamedTuple):
    """How far apart two unions are."""

    distance: float  #: correctly rounded
    squared: Fraction
    pieces: tuple[int, int]  #: the first pair that is nearest
    translation: FloatArray  #: of A, after which the bodies touch
    witness: tuple[FractionTriple, FractionTriple]  #: a point of A and one of B that are nearest
    contact: dict[str, Any]  #: the features that are nearest


class UnionBounds(NamedTuple):
    """What simpler measures say: the deepest pair is never deeper than the unions, their hulls never shallower."""

    deepest_pair: float  #: the depth of the deepest pair of pieces; if the search was stopped, of those that it came to
    pieces: tuple[int, int]  #: that pair, the first of several; (0, 0) if no two pieces overlap
    hulls: float  #: the depth of the convex hulls
    deepest_pair_squared: Fraction
    hulls_squared: Fraction


class UnionDepth:
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

    __slots__ = ("_answer",)

    def __init__(self, answer: _fathom.UnionAnswer):
        self._answer = answer

    @property
    def status(self) -> str:
        """"penetrating", "touching" if the interiors are disjoint but pieces meet, or "disjoint"."""
        return self._answer.status

    @property
    def complete(self) -> bool:
        """False if `stop` ended the search: then `low` and `high` enclose the depth."""
        return self._answer.complete

    @property
    def depth(self) -> float | None:
        """The length of the shortest translation that makes the interiors disjoint: 0.0 unless the bodies penetrate. None unless
        complete."""
        return self._answer.depth

    @property
    def squared(self) -> Fraction | None:
        """depth^2. None unless complete."""
        return self._answer.low_squared if self.complete else None

    @property
    def low(self) -> float:
        """The largest float that is at most the depth, or at most its lower bound."""
        return self._answer.low

    @property
    def high(self) -> float:
        """The least float that is at least the depth, or at least its upper bound."""
        return self._answer.high

    @property
    def low_squared(self) -> Fraction:
        """low_squared <= depth^2 <= high_squared: equal if the search is complete."""
        return self._answer.low_squared

    @property
    def high_squared(self) -> Fraction:
        """The square of the length of the shortest way out that was found."""
        return self._answer.high_squared

    @property
    def distance(self) -> float:
        """0.0 unless the bodies are disjoint."""
        apart = self.apart
        return 0.0 if apart is None else apart.distance

    @property
    def translation(self) -> FloatArray:
        """The first of the shortest translations of A after which the bodies touch: zero if they touch already. If the search was stopped,
        the shortest that was found."""
        apart = self._answer.apart
        return self._answer.optima[0]["translation"] if apart is None else apart["translation"]

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
        fields = self._answer.bounds
        return None if fields is None else UnionBounds(**fields)

    @property
    def notes(self) -> list[str]:
        """What may be a slip: a pose that is no rotation, bodies of very different size."""
        return self._answer.notes

    @property
    def counters(self) -> dict[str, int]:
        """What the search did, in counts that do not depend on the machine: nodes, nearest_points, pairs, pairs_touched."""
        return self._answer.counters

    def certificate(self, id: str = "") -> str:
        """A proof of the answer as text, which `check` and two other checkers read (verify/check/FORMAT.md). Raises ValueError unless
        the search is complete."""
        if not self.complete:
            raise ValueError("there is no certificate of a search that was stopped")
        return self._answer.certificate(id)

    def __repr__(self) -> str:
        if not self.complete:
            return f"UnionDepth({self.status}, between {self.low!r} and {self.high!r})"
        number = f"distance={self.distance!r}" if self.status == "disjoint" else f"depth={self.depth!r}"
        return f"UnionDepth({self.status}, {number})"


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
