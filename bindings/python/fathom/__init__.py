# SPDX-License-Identifier: GPL-3.0-or-later
"""The exact penetration depth of two convex bodies, with a proof.

>>> import fathom
>>> import numpy as np
>>> cube = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
>>> hit = fathom.depth(cube, cube + [0.75, 0, 0])
>>> hit.status, hit.depth, hit.direction
('penetrating', 0.25, array([-1.,  0.,  0.]))
>>> hit.exact.translation
(Fraction(-1, 4), Fraction(0, 1), Fraction(0, 1))

A body is the convex hull of an array of points, of a list of points whose coordinates may be Fractions or texts, or of the `vertices` of
anything that has some (trimesh's meshes do); or a shape: `sphere`, `capsule`, `cylinder` and so on. Points of two coordinates make a body
of the plane, as the shapes of `fathom.plane` are. Input is never rounded: floats stand for their exact values. Every float of an answer is
the correctly rounded value; the exact values are under `.exact`.

A mesh with `faces` that is not convex is answered as its hull, with a NotConvexWarning. `union_depth` takes bodies that are not convex, as
lists of convex pieces.

Bad input raises ValueError, an argument that is no number or no body TypeError. Ctrl-C ends any call.
"""
import importlib


def _refuse_subinterpreters() -> None:
    """Raises ImportError in a subinterpreter: numpy and pybind11 support the main interpreter alone, and their import would hang."""
    for name in ("_interpreters", "_xxsubinterpreters"):
        try:
            interpreters = importlib.import_module(name)
        except ImportError:
            continue
        if interpreters.get_current() != interpreters.get_main():
            raise ImportError("fathom serves the main interpreter alone, and this is a subinterpreter")
        return


_refuse_subinterpreters()
try:
    importlib.import_module("fathom._fathom")
except ImportError as fault:
    raise ImportError("fathom._fathom cannot be loaded: is it built for this Python? docs/python.md says how") from fault

from fathom import plane
from fathom._answers import Depth, Depths, Exact, NotConvexWarning, Optimum, Root, check, Checked, depth, depths, distance, width, Width
from fathom._bodies import (Body, Convexity, Coverage, Pose, box, capsule, cone, convexity, coverage, cylinder, ellipsoid, frustum,
                            halfspace, pose, read, read_mesh, read_pieces, solid, sphere, tapered_capsule, union)
from fathom._fathom import version as __version__
from fathom._files import Case, Record, cases, family, golden
from fathom._patches import Derivative, Gradient, OptimalCone, Patch, PatchCorner, VertexWeights
from fathom._prepared import Prepared
from fathom._questions import (Approx, Growth, Impact, Judgement, Metric, Ray, Study, approx, closer_than, growth, impact, judge, metric,
                               overlap, ray, study)
from fathom._unions import PieceContact, UnionBounds, UnionDepth, UnionDistance, UnionOptimum, union_depth

__all__ = ["Approx", "Body", "Case", "Checked", "Convexity", "Coverage", "Depth", "Depths", "Derivative", "Exact", "Gradient", "Growth",
           "Impact", "Judgement", "Metric", "NotConvexWarning", "OptimalCone", "Optimum", "Patch", "PatchCorner", "PieceContact", "Pose",
           "Prepared", "Ray", "Record", "Root", "Study", "UnionBounds", "UnionDepth", "UnionDistance", "UnionOptimum", "VertexWeights",
           "Width", "approx", "box", "capsule", "cases", "check", "closer_than", "cone", "convexity", "coverage", "cylinder", "depth",
           "depths", "distance", "ellipsoid", "family", "frustum", "golden", "growth", "halfspace", "impact", "judge", "metric",
           "overlap", "plane", "pose", "ray", "read", "read_mesh", "read_pieces", "solid", "sphere", "study", "tapered_capsule", "union",
           "union_depth", "width", "__version__"]
