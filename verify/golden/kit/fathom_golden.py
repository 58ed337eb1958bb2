# SPDX-License-Identifier: CC0-1.0
"""Golden cases of fathom, and whether an answer to one is right. Reads what `fathom golden export --format json` or csv writes.

For a vector u, h(u) is the greatest <u,b> less the least <u,a>, over the points b of B and a of A; its separating distance is h(u)/|u|.
Moved that far along u, A lies behind a plane across u and B before it. The least separating distance of all directions is the signed
depth: of bodies that overlap the penetration depth, of bodies that touch 0, of bodies that are apart minus their distance. Python 3.8,
without packages.
"""
import csv
import json
import math
import os
import sys
from fractions import Fraction
from typing import List, NamedTuple, Optional, Sequence, Union


class Case(NamedTuple):
    """The bodies are the convex hulls of the points."""

    name: str
    status: str  #: "penetrating", "touching" or "disjoint"
    signed_depth: float  #: correctly rounded to nearest
    squared: Fraction  #: its square, exact
    flags: List[str]  #: what is special about the case
    size: float  #: the longest side of the bodies' boxes, correctly rounded
    largest: float  #: the largest magnitude of a coordinate
    a: List[List[float]]  #: exact
    b: List[List[float]]
    #: Unit vectors, rounded: all whose separating distance is the depth. Of bodies that touch one whose is 0; of bodies that are apart
    #: that of the distance, from B to A.
    directions: List[List[float]]
    family: str = ""  #: where it is from: a family of cases, "catalogue", "real", or "own"
    formats: Sequence[str] = ()  #: that hold the points: "binary64", and "binary32" if that does too
    contacts: Sequence[str] = ()  #: the kinds of contact of the shortest ways out, A's feature first: "edge-edge"
    #: Of cases of contacts, for each direction: the corners, on A, of all points where the bodies touch once A is moved that way, rounded:
    #: one of a point, two of a segment.
    patches: Sequence[List[List[float]]] = ()
    #: Of these, where the signed depth is smooth, rounded. A moves with v + w x p at its points p: the first times v and the second times w
    #: are its rate.
    gradient: Optional[List[List[float]]] = None
    dimension: int = 3  #: 2 of bodies of the plane: then points and directions have two coordinates


def read(path: Union[str, "os.PathLike[str]"]) -> List[Case]:
    """Returns the cases of an export: of a CSV if its name ends so, else of JSON."""
    with open(path, encoding="utf-8", newline="") as file:
        if os.fspath(path).endswith(".csv"):
            csv.field_size_limit(sys.maxsize)
            return [_from_row(row) for row in csv.DictReader(file)]
        return [_from_object(case) for case in json.load(file)["cases"]]


def sample() -> List[Case]:
    """Returns the sample of fifty cases, which lies beside this file."""
    return read(os.path.join(os.path.dirname(os.path.abspath(__file__)), "fathom_golden_sample.json"))


def _from_object(case):
    return Case(**{field: case[field] for field in Case._fields if field in case})._replace(squared=Fraction(case["squared"]))


def _from_row(row):
    dimension = int(row.get("dimension") or 3)

    def points(text):
        numbers = [float(word) for word in text.split()]
        return [numbers[i:i + dimension] for i in range(0, len(numbers), dimension)]

    return Case(row["name"], row["status"], float(row["signed_depth"]), Fraction(row["squared"]), row["flags"].split(), float(row["size"]),
                float(row["largest"]), points(row["a"]), points(row["b"]), points(row["directions"]),
                row.get("family", ""), row.get("formats", "").split(), row.get("contacts", "").split(),
                [points(patch) for patch in row["patches"].split(";")] if row.get("patches") else (),
                points(row["gradient"]) if row.get("gradient") else None, dimension)


def _dot(u, p):
    plane = u[0] * p[0] + u[1] * p[1]
    return plane + u[2] * p[2] if len(u) == 3 else plane


def separating_distance(case: Case, direction: Sequence[float]) -> float:
    """Returns the separating distance of a direction of any length; infinite if it is zero, infinite or NaN.

    It is off by less than 2^-47 of the largest coordinate (and 2^-1068). Raises ValueError if it has not as many numbers as a point.
    """
    if len(direction) != case.dimension:
        raise ValueError(f"expected a direction of {case.dimension} numbers, found {len(direction)}")
    longest = max(abs(x) for x in direction)
    if longest == 0 or not all(math.isfinite(x) for x in direction):
        return math.inf
    u = [x / longest / 8 for x in direction]  # an eighth, so that no sum overflows
    values = [[_dot(u, p) for p in body] for body in (case.a, case.b)]
    return (max(values[1]) - min(values[0])) / math.sqrt(_dot(u, u))


def allowance(case: Case, relative: float, absolute: float) -> float:
    """Returns by how much an answer may be off: the tolerance, and what rounding costs it and the separating distance."""
    wrong = max(relative * abs(case.signed_depth), absolute * case.size)
    return wrong + 32 * sys.float_info.epsilon * case.largest + 64 * sys.float_info.epsilon * sys.float_info.min


def accept(case: Case, direction: Optional[Sequence[float]], depth: float, *, relative: float, absolute: float = 0.0) -> bool:
    """Whether "A and B overlap by `depth`; A gets free along `direction`" is right.

    Neither the depth nor the separating distance of the direction may be off by more than the larger of relative * depth (or distance) and
    absolute * size, and what rounding costs. Any direction that is good enough is right, not only the best. A distance is a depth below
    0. The direction may have any length; None if none is claimed.
    """
    allowed = allowance(case, relative, absolute)
    if not abs(depth - case.signed_depth) <= allowed:
        return False
    return direction is None or separating_distance(case, direction) - case.signed_depth <= allowed


def accept_apart(case: Case, *, relative: float, absolute: float = 0.0) -> bool:
    """Whether "A and B do not overlap" is right, without a distance."""
    return case.signed_depth <= allowance(case, relative, absolute)
