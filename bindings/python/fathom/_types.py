# SPDX-License-Identifier: GPL-3.0-or-later
"""The types of arguments."""
from __future__ import annotations

from decimal import Decimal
from fractions import Fraction
from typing import Any, Iterable, Protocol, Sequence, Union

import numpy as np
import numpy.typing as npt

from fathom import _fathom

Number = Union[int, float, Fraction, Decimal, str, "np.number[Any]"]
Triple = Union[Sequence[Number], npt.NDArray[Any]]
Pair = Triple


class HasVertices(Protocol):
    """Anything with vertices, such as a mesh of trimesh."""

    @property
    def vertices(self) -> Any: ...


BodyLike = Union["_fathom.Body", npt.NDArray[Any], Sequence[Triple], HasVertices]
UnionLike = Union[BodyLike, Iterable[BodyLike]]
PoseLike = Union["_fathom.Pose", str, npt.NDArray[Any], Sequence[Sequence[Number]], None]
FloatArray = npt.NDArray[np.float64]
FractionTriple = "tuple[Fraction, Fraction, Fraction]"
Fractions = "tuple[Fraction, ...]"  #: three, or two of bodies of the plane
