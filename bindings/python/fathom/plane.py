# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies of the plane, with the names that cases have for them. An array of shape (n, 2), or a list of pairs, is a polygon.

`depth`, `distance`, `depths`, `union_depth`, `overlap`, `closer_than`, `ray`, `growth`, `metric`, `approx` and `judge` take two of them,
`width` one; points and vectors have two coordinates, and contacts are those of vertices and edges. The other questions are about bodies
of space, and raise ValueError.

>>> import fathom
>>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
>>> hit = fathom.depth(square, fathom.plane.circle(1), pose_b=fathom.plane.pose(translation=(1.5, 0.5)))
>>> hit.status, hit.depth, hit.translation, hit.exact.translation
('penetrating', 0.5, array([-0.5,  0. ]), ((-1, 0), Fraction(-1, 2), Fraction(1, 1)))
>>> hit.contact
{'kind': 'edge-vertex', 'a': (1, 2), 'b': (0,)}
"""
from __future__ import annotations

from fathom import _fathom
from fathom._fathom import Body, Pose
from fathom._types import BodyLike, Number, Pair

__all__ = ["box", "capsule", "circle", "halfplane", "polygon", "pose"]


def circle(radius: Number) -> Body:
    """The disc around the origin."""
    return _fathom.plane_shape("circle", {"radius": radius})


def capsule(radius: Number, half_length: Number, axis: str = "x") -> Body:
    """The points at most `radius` away from the segment from -half_length to half_length on the axis, "x" or "y"."""
    return _fathom.plane_shape("capsule", {"radius": radius, "half_length": half_length}, axis)


def box(half: Pair) -> Body:
    """The points with |x| and |y| at most these two.

    >>> import fathom
    >>> fathom.depth(fathom.plane.box((1, 2)).with_margin("1/4"), fathom.plane.circle(1)).exact.signed_depth
    Root(rational=Fraction(9, 4), root=Fraction(0, 1))
    """
    return _fathom.plane_shape("box", {"half": half})


def polygon(points: BodyLike) -> Body:
    """The convex hull of points of two coordinates.

    >>> import fathom
    >>> fathom.plane.polygon([(0, 0), (1, 0), (0, "1/3")])
    <fathom.Body of 3 points of the plane>
    """
    body = Body(points)
    if body.dimension != 2:
        raise ValueError("points: expected points of two coordinates, found some of three")
    return body


def halfplane(normal: Pair, offset: Number) -> Body:
    """The points p with <normal, p> <= offset."""
    return _fathom.plane_shape("halfplane", {"normal": normal, "offset": offset})


def pose(half_angle: Number = 0, translation: Pair = (0, 0)) -> Pose:
    """The turn by the angle whose half has this tangent, and then the translation.

    The cosine is (1 - t^2)/(1 + t^2) and the sine 2t/(1 + t^2): an exact rotation. Other exact maps are 2 rows of 3 numbers.

    >>> import fathom
    >>> fathom.plane.pose(half_angle="1/2").rows[0][:2]
    (Fraction(3, 5), Fraction(-4, 5))
    """
    if len(translation) != 2:
        raise ValueError(f"translation: expected two numbers, found {translation!r}")
    return _fathom.pose((1, 0, 0, half_angle), (translation[0], translation[1], 0))
