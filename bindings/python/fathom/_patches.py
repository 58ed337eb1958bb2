# SPDX-License-Identifier: GPL-3.0-or-later
"""Where bodies touch once A has moved out, and how their signed depth changes with their poses."""
from __future__ import annotations

from fractions import Fraction
from typing import Any, NamedTuple

from fathom import _fathom
from fathom._types import FloatArray, Fractions, Number, Triple

AT_REST = (0, 0, 0)


class PatchCorner(NamedTuple):
    """A corner of a patch: a point of A and a point of B, which differ by the translation."""

    a: Any  #: three Fractions, in the plane two; of answers about shapes (p, n, r), which means p + r n/|n|, as in `exact.witness`
    b: Any
    on_a: tuple[int, ...] | None  #: the least face of A that holds it, by indices of points: a vertex, an edge, ...; None of a half-space
    on_b: tuple[int, ...] | None


class Patch(NamedTuple):
    """All points where the bodies touch in one direction: a point, a segment, or a convex polygon in a plane across the direction."""

    rank: int  #: the dimension: 0, 1 or 2
    direction: FloatArray  #: unit vector along which A leaves B, correctly rounded
    normal: tuple[int, ...]  #: the same as integers, exact and primitive
    corners: tuple[PatchCorner, ...]  #: counter-clockwise seen from the direction's tip; first that of the least (on_a, on_b)
    a_f64: FloatArray  #: the corners on A as an array of k x 3, in the plane k x 2, correctly rounded
    b_f64: FloatArray  #: those on B
    centroid: tuple[Any, Any]  #: a point of A and one of B, exact as the corners
    size: float  #: length of a segment, area of a polygon, 0.0 of a point, correctly rounded
    size_squared: Fraction
    optimum: int  #: which of `optima` it belongs to; 0 of bodies that touch or are apart
    pieces: tuple[int, int] | None  #: of unions, the piece of A and the piece of B that touch
    mesh_a: list[dict[str, Any]]  #: of bodies made by `fathom.solid`, what of the mesh holds the patch, as in PieceContact
    mesh_b: list[dict[str, Any]]


class Gradient(NamedTuple):
    """The gradient of the signed depth by A's pose: while points p of A move with v + w x p it changes at the rate v . self.v + w . self.w.
    That by B's pose is minus it. Both are about the origin of the world."""

    v: FloatArray  #: -n/|n|, each component correctly rounded
    w: FloatArray | float  #: -(p x n)/|n|; in the plane a number
    normal: tuple[int, ...]  #: n, exact and primitive
    point: Fractions  #: p: the one contact point, on A's core


class VertexWeights(NamedTuple):
    """The derivatives by the input points: by point i of A -weight n/|n|, by point j of B weight n/|n|, n the gradient's normal; 0 by all
    others."""

    a: dict[int, Fraction]  #: by ascending indices; those of a body sum to 1. Empty of a half-space
    b: dict[int, Fraction]


class OptimalCone(NamedTuple):
    """All directions that separate cores which touch: sums of a vector of a linear space and of rays, each times a number >= 0."""

    lineality: str  #: the linear space: "none", "line", "plane", "all"
    axis: tuple[int, ...] | None  #: the direction of the line, or the plane's normal
    rays: tuple[tuple[int, ...], ...]  #: across the linear space, primitive


class Derivative(NamedTuple):
    """The one-sided derivative sign * sqrt(root) of the signed depth.

    All is None if `left_out` gives a reason: that of the patches; "unlisted", as fewer `optima` are listed than there are; "touching",
    of unions that touch; "exact-fit", of unions that turn, where a way out leaves no gap; "many-planes", of unions that turn, where pieces
    have more than one plane between them after a way out.
    """

    value: float | None = None  #: correctly rounded to nearest
    low: float | None = None  #: rounded down
    high: float | None = None  #: rounded up
    sign: int | None = None
    root: Fraction | None = None
    direction: FloatArray | None = None  #: of the patch that decides
    normal: tuple[int, ...] | None = None
    patch: int | None = None  #: which of `patches` that is
    corner: int | None = None  #: which of its corners decides
    left_out: str | None = None


class ContactAnswer:
    """The properties of answers that describe contacts. They are computed once, when the first of them is read."""

    __slots__ = ()
    _answer: _fathom.Answer

    @property
    def patches(self) -> tuple[Patch, ...]:
        """Where the bodies touch after each shortest way out of `optima`; one patch of bodies that touch or are apart. Of unions, one for
        each two pieces that touch after a way out, or that are nearest. Empty if `left_out` says why."""
        told = self._answer.manifold()
        found = told.patches if told else []
        return tuple(Patch(**{**fields, "corners": tuple(PatchCorner(**corner) for corner in fields["corners"])}) for fields in found)

    @property
    def patch(self) -> Patch | None:
        """The first of `patches`."""
        return next(iter(self.patches), None)

    @property
    def left_out(self) -> str | None:
        """Why there are no patches: "curved", as a core is neither a polytope nor a half-space; "incomplete", as the search was stopped;
        "too-large", as a core against a half-space is a sum of too many points; else None."""
        told = self._answer.manifold()
        return told.left_out if told else "incomplete"

    @property
    def smooth(self) -> bool | None:
        """Whether the signed depth is differentiable by the poses of the bodies. None of unions and where there are no patches."""
        told = self._answer.manifold()
        return told.smooth if told else None

    @property
    def kinks(self) -> tuple[str, ...] | None:
        """Why it is not, some of: "ties", several ways out are as short; "extended", a patch is more than a point; "cone", the cores touch,
        and more than one plane separates them. None as `smooth`."""
        told = self._answer.manifold()
        return told.kinks if told else None

    @property
    def gradient(self) -> Gradient | None:
        """None unless the signed depth is smooth."""
        told = self._answer.manifold()
        return Gradient(**told.gradient) if told and told.gradient else None

    @property
    def vertex_weights(self) -> VertexWeights | None:
        """None unless the signed depth is smooth and differentiable by the input points."""
        told = self._answer.manifold()
        return VertexWeights(**told.vertex_weights) if told and told.vertex_weights else None

    @property
    def optimal_cone(self) -> OptimalCone | None:
        """None unless the cores touch; None of unions."""
        told = self._answer.manifold()
        return OptimalCone(**told.optimal_cone) if told and told.optimal_cone else None

    def derivative(self, v: Triple = AT_REST, w: Triple | Number = AT_REST, v_b: Triple = AT_REST,
                   w_b: Triple | Number = AT_REST) -> Derivative:
        """Returns how fast the signed depth changes while points p of A begin to move with v + w x p, and those of B with v_b + w_b x p.

        v, v_b  velocities, each three numbers, taken exactly as coordinates are
        w, w_b  rates of turning about the origin of the world, in radians per unit of time

        Of bodies of the plane v and v_b are two numbers, and w and w_b are one, counter-clockwise.

        It is the exact one-sided derivative, (s(t) - s(0)) / t for t -> 0 from above, whether the depth is smooth or not. Raises ValueError
        unless each has so many finite numbers, TypeError for what is no number.

        >>> import fathom
        >>> hit = fathom.depth(fathom.box((1, 1, 1)), fathom.box((1, 1, 1)), pose_b="xyz=1,1/2,1/4")
        >>> hit.derivative((1, 0, 0)).value, hit.derivative((1, 0, 0), v_b=(1, 0, 0)).value
        (1.0, 0.0)
        >>> turning = hit.derivative(w=(0, 0, -1))
        >>> turning.sign, turning.root, hit.patch.corners[turning.corner].a
        (1, Fraction(1, 1), (Fraction(1, 1), Fraction(1, 1), Fraction(1, 1)))
        """
        told = self._answer.manifold()
        return Derivative(**told.derivative(v, w, v_b, w_b)) if told else Derivative(left_out="incomplete")
