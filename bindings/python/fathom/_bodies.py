# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies that are more than an array of points, and poses. Numbers may be floats, ints, Fractions, Decimals or texts, all exact."""
from __future__ import annotations

import copyreg
import math
import os
from fractions import Fraction
from typing import Any, Iterable, Mapping, NamedTuple

from fathom import _fathom
from fathom._fathom import Body, Pose
from fathom._types import BodyLike, FractionTriple, Number, Triple, UnionLike

__all__ = ["Body", "Convexity", "Coverage", "Pose", "box", "capsule", "cone", "convexity", "coverage", "cylinder", "ellipsoid", "frustum",
           "halfspace", "pose", "read", "read_mesh", "read_pieces", "solid", "sphere", "tapered_capsule", "union"]


def _body_of_state(*state: Any) -> Body:
    return _fathom.body_of_state(*state)  # pickle cannot look up a function of the C++ module by its name


copyreg.pickle(Body, lambda body: (_body_of_state, body.state))
copyreg.pickle(Pose, lambda pose: (Pose, (pose.rows,)))


def sphere(radius: Number) -> Body:
    """The ball around the origin.

    >>> import fathom
    >>> fathom.depth(fathom.sphere(1), fathom.sphere(2).moved(fathom.pose(translation=(2, 1, 0)))).exact.signed_depth
    Root(rational=Fraction(3, 1), root=Fraction(-5, 1))
    """
    return _fathom.sphere(radius)


def capsule(radius: Number, half_length: Number, axis: str = "z") -> Body:
    """The points at most `radius` away from the segment from -half_length to half_length on the axis."""
    return _fathom.capsule(radius, half_length, axis)


def tapered_capsule(radius_low: Number, radius_high: Number, half_length: Number, axis: str = "z") -> Body:
    """The convex hull of two balls, around -half_length and half_length on the axis."""
    return _fathom.tapered_capsule(radius_low, radius_high, half_length, axis)


def box(half: Triple) -> Body:
    """The points with |x|, |y|, |z| at most these three.

    >>> import fathom
    >>> fathom.box((1, 1, 1)).with_margin("0.1").is_flat
    False
    """
    return _fathom.box(half)


def cylinder(radius: Number, half_length: Number, axis: str = "z") -> Body:
    """A cylinder with its end faces at -half_length and half_length on the axis."""
    return _fathom.cylinder(radius, half_length, axis)


def cone(radius: Number, half_length: Number, axis: str = "z") -> Body:
    """A cone with its base at -half_length on the axis and its apex at half_length."""
    return _fathom.cone(radius, half_length, axis)


def frustum(radius_low: Number, radius_high: Number, half_length: Number, axis: str = "z") -> Body:
    """A cone that is cut off: the radii are those of the end faces at -half_length and half_length."""
    return _fathom.frustum(radius_low, radius_high, half_length, axis)


def ellipsoid(radii: Triple) -> Body:
    """An ellipsoid around the origin with its radii along x, y and z."""
    return _fathom.ellipsoid(radii)


def halfspace(normal: Triple, offset: Number) -> Body:
    """The points p with <normal, p> <= offset."""
    return _fathom.halfspace(normal, offset)


def pose(quaternion: Triple = (1, 0, 0, 0), translation: Triple = (0, 0, 0)) -> Pose:
    """The rotation v -> q v q^-1 of a quaternion (w, x, y, z), and then the translation.

    The rotation is exact for every quaternion but 0, which need not be a unit.

    >>> import fathom
    >>> fathom.pose(quaternion=(1, 0, 0, 1)).rows[0]
    (Fraction(0, 1), Fraction(-1, 1), Fraction(0, 1), Fraction(0, 1))
    """
    return _fathom.pose(quaternion, translation)


def read(name: str | os.PathLike[str], *, meshes: str = "hull", joints: Mapping[str, Number] | None = None,
         package_path: Iterable[str | os.PathLike[str]] = (), decimals: str = "binary64") -> Body:
    """The body that a word of the command line stands for: a file of a mesh or of the plane, a link of a robot, a shape in short words.

    So "arm.urdf#hand" is the link "hand" where its robot (docs/robots.md) puts it, in the frame of the root, and "capsule:r=0.1,h=0.5" a
    shape (docs/shapes.md). What fathom would say on stderr, as that an angle is turned by a rotation near it, is a UserWarning.

    meshes        "hull": a mesh stands for its convex hull; "pieces": for the groups of its file; "solid": for what it
                  goes around, as for `solid`. With the last two the body is a union.
    joints        values of joints by their names, in radians and lengths; other joints are at 0, or at the limit that is nearest to 0
    package_path  folders in which meshes of the form package://NAME/FILE are looked for
    decimals      what "0.1" in a text stands for: "binary64", the nearest float, as other programs read it; or "exact", 1/10

    >>> import fathom
    >>> hand = fathom.read("examples/data/arm.urdf#left", joints={"grip": "1/32"})
    >>> base = fathom.read("examples/data/arm.urdf#base")
    >>> fathom.depth(hand, base).status
    'disjoint'
    >>> fathom.read("plane:box:half=1:2,at=3:4").dimension
    2
    """
    return _fathom.read(os.fspath(name), meshes, dict(joints or {}), [os.fspath(folder) for folder in package_path], decimals)


def read_mesh(path: str, decimals: str = "binary64") -> Body:
    """The convex hull of the points of a mesh: OFF, OBJ, PLY, STL, glTF, COLLADA, 3MF, or points alone; "a.glb#name" is one of several.

    decimals  what "0.1" in a text file stands for: "binary64", the nearest float, as other programs read it; or "exact", 1/10
    """
    return _fathom.read_mesh(str(path), decimals)


def union(pieces: Iterable[BodyLike]) -> Body:
    """The union of convex pieces: of each the hull of an array of points, of a list of points, of a mesh, or a body that is a polytope.

    Pieces may overlap, abut and repeat: where two meet in a common face there is no gap. A mesh with `faces` that is not convex is taken as
    its hull, with a NotConvexWarning. `union_depth` takes the list as well; a body can be posed, and keeps what was read.

    >>> import fathom
    >>> fathom.union([fathom.box((1, 1, 1)), fathom.box((2, "1/3", 1))])
    <fathom.Body, a union of 2 pieces>
    """
    return _fathom.union(pieces)


def solid(mesh: BodyLike) -> Body:
    """The inside of a closed mesh, convex or not: the union of convex pieces into which it is cut, exactly.

    mesh  a body with faces, as `read_mesh` reads it, or anything with `vertices` and `faces`; a mesh that is not closed, or has a part
          inside out, raises ValueError with a place (docs/solids.md)

    >>> import fathom
    >>> spanner = fathom.solid(fathom.read_mesh("tests/data/decompositions/spanner.off"))
    >>> spanner
    <fathom.Body, a union of 11 pieces>
    >>> answer = fathom.union_depth(spanner, fathom.solid(fathom.read_mesh("tests/data/cube.off")))
    >>> answer.status, fathom.check(answer.certificate("one proof for both")).verdict.split()[5:7]
    ('penetrating', ['pieces=11x1', 'triangles=164x12'])
    """
    return _fathom.solid(mesh)


class Coverage(NamedTuple):
    """How far convex pieces are from tiling the solid of a mesh. Volumes are exact."""

    tiles: bool  #: whether the pieces cover the solid, lie in it and do not overlap
    same_union: bool  #: whether their union is the solid: they may overlap
    missing: Fraction  #: of the solid, what no piece covers
    outside: Fraction  #: of what pieces cover, what is not in the solid
    overlap: Fraction  #: what the volumes of the pieces sum to beyond that of their union
    outside_of: list[Fraction]  #: for each piece: of it, what is not in the solid
    most_outside: int | None  #: the first piece of which most is outside; None if nothing is
    uncovered: FractionTriple | None  #: a point inside the solid that no piece covers, if some is missing
    stray: FractionTriple | None  #: a point inside a piece that is not in the solid, if some is outside


def coverage(mesh: BodyLike, pieces: UnionLike) -> Coverage:
    """Compares the union of convex pieces, such as another program made, with what a closed mesh goes around, exactly.

    mesh  as for `solid`, or what that returned
    pieces  as for `union`; fractions are long where many of them are cut

    >>> import fathom
    >>> mesh = fathom.read_mesh("tests/data/decompositions/spanner.off")
    >>> found = fathom.coverage(mesh, fathom.read_pieces("tests/data/decompositions/spanner.obj"))
    >>> found.tiles, float(found.missing), float(found.outside), found.most_outside
    (False, 0.6111927516283405, 0.9834834002352644, 3)
    """
    return Coverage(**_fathom.coverage(mesh, pieces))


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


def _readable(number: Fraction | None) -> str:
    """Returns the value as a float, which is shorter to print."""
    try:
        return str(None if number is None else float(number))
    except OverflowError:
        return str(math.inf)


class Convexity(NamedTuple):
    """How a mesh differs from the convex hull that stands for it. The numbers are exact, and printed as floats."""

    convex: bool
    volume_ratio: Fraction | None  #: the hull's volume over the mesh's, > 1; None if the mesh is convex, or not closed
    deepest: int | None  #: the point deepest inside the hull; None if the mesh is convex, or it would take too long to find
    squared_depth: Fraction | None  #: of that point; 0: all points are on the hull

    def __repr__(self) -> str:
        return (f"Convexity(convex={self.convex}, volume_ratio={_readable(self.volume_ratio)}, deepest={self.deepest}, "
                f"squared_depth={_readable(self.squared_depth)})")


def convexity(body: BodyLike) -> Convexity | None:
    """Compares a mesh with its hull, exactly; None of what has no `faces`.

    >>> import fathom
    >>> class Dented:  # as trimesh has it
    ...     vertices = [(0, 0, 0), (4, 0, 0), (0, 4, 0), (0, 0, 4), (1, 1, 1)]
    ...     faces = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 4), (2, 3, 4), (3, 1, 4)]
    >>> fathom.convexity(Dented)
    Convexity(convex=False, volume_ratio=1.3333333333333333, deepest=4, squared_depth=0.3333333333333333)
    >>> fathom.convexity(Dented).volume_ratio
    Fraction(4, 3)
    """
    found = _fathom.convexity(body)
    return None if found is None else Convexity(*found)
