# SPDX-License-Identifier: Apache-2.0
"""Lets `fathom certify` put cases to your code: one function that answers a pair of bodies. Copy this file; it needs Python 3.8 alone.

    import fathom_subject

    def solve(a, b):
        hit = my_library.collide(a.vertices, b.vertices)
        return fathom_subject.Reply(hit.overlap, hit.depth, hit.normal)

    fathom_subject.run(solve, name="my library", version="1.0")

and then `fathom certify --subject 'python3 my_subject.py' cases.jsonl`. It speaks the protocol fathom/subject/1 (verify/PROTOCOL.md):
lines are flushed, NaN and infinities are written so that they are judged, whatever your code prints once this file is imported goes to
standard error, its exceptions become the answer `failed`, and each answer says how many microseconds it took.
"""
import json
import math
import os
import sys
import time

PROTOCOL = "fathom/subject/1"


class Unsupported(Exception):
    """Raise it for a pair that your code does not take: the case is not judged then. Any other exception is a failure to answer."""


class Body:
    """One body of a case: the convex hull of `vertices`; or a shape, if your subject declared some.

    vertices     [[x, y, z], ...]; of a shape, only hulls and triangles have them
    faces        [[i, j, k, ...], ...]: facets of the hull, counter-clockwise from outside; [] unless asked for, or of a flat body
    shape        "sphere", "cylinder", ...; None for a body of vertices
    axis         "x", "y" or "z": along which a shape lies before it is placed; the declared one, if one was declared
    pieces       [{"vertices": ...}, ...]: of a union, if your subject declared "pieces"; [] of any other body
    margin       the radius of the ball that is added around a shape; 0 if there is none
    rotation     3 x 3, rows; a shape's point p is at rotation p + translation. Exactly what the case says, up to rounding
    translation  [x, y, z]
    twist        (v, w): its point p begins to move with the velocity v + w x p, w about the origin of the world; None unless your subject
                 declared "twist" and the case has one

    In the plane vertices are [[x, y], ...], the body is their hull, grown by `margin`, and `faces` are edges, one behind the other.

    The other fields of a shape, `radius`, `half_length`, `half`, `radii`, `normal`, `offset` and so on, are attributes too.
    docs/shapes.md says what they mean.
    """

    def __init__(self, message, axis=None, twist=None):
        self.vertices, self.faces, self.pieces, self.shape, self.margin = [], [], [], None, 0
        self.rotation, self.translation = [[1, 0, 0], [0, 1, 0], [0, 0, 1]], [0, 0, 0]
        self.twist = (twist["v"], twist["w"]) if twist else None
        for field, value in message.items():
            if field != "pose":
                setattr(self, field, value)
        pose = message.get("pose")
        if isinstance(pose, dict):
            self.translation = pose.get("translation", self.translation)
            self.rotation = rotation_of(pose["quaternion"])
        elif pose:
            self.rotation, self.translation = [row[:3] for row in pose], [row[3] for row in pose]
        if axis and "axis" in message:  # a cyclic exchange of axes goes before the rotation
            by = "xyz".index(self.axis) - "xyz".index(axis)
            self.axis, self.rotation = axis, [[row[(i + by) % 3] for i in range(3)] for row in self.rotation]


def rotation_of(quaternion):
    """Returns the matrix of v -> q v q^-1, for a quaternion [w, x, y, z] of any length but 0."""
    largest = max(map(abs, quaternion))
    w, x, y, z = (c / largest for c in quaternion)
    s = 2 / (w * w + x * x + y * y + z * z)
    return [[1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)],
            [s * (x * y + w * z), 1 - s * (x * x + z * z), s * (y * z - w * x)],
            [s * (x * z - w * y), s * (y * z + w * x), 1 - s * (x * x + y * y)]]


class Reply:
    """What your code answers. Only `overlap` is needed, and what is there is judged. Numbers may be anything that float() takes.

    depth         how deep, with the sign that `run` declares
    direction     moving the declared body by |depth| * direction takes the bodies apart
    witness       a point of A and one of B, which differ by that translation of A
    distance      how far apart; direction then leads the declared body farther away, and witness is a pair of nearest points
    contacts      of a manifold: pairs of a point of both bodies and the depth there, or None; the largest is the depth
    derivative    of bodies with a twist: how fast the signed depth grows as they begin to move, from then on. Deeper is positive, whatever
                  sign depths have; minus the distance counts of bodies apart
    hull          the vertices of A's and of B's hull that your code really used, where they may be others than the asked ones; None for
                  either whose are not known
    microseconds  how long it took, if you timed a part of your function yourself
    """

    def __init__(self, overlap, depth=None, direction=None, witness=None, hull=None, distance=None, contacts=(), microseconds=None,
                 derivative=None):
        self.overlap, self.depth, self.direction, self.witness, self.hull = overlap, depth, direction, witness, hull
        self.distance, self.contacts, self.microseconds, self.derivative = distance, contacts, microseconds, derivative

    def fields(self):
        found = {"overlap": bool(self.overlap)}
        if self.depth is not None:
            found["depth"] = _number(self.depth)
        if self.direction is not None:
            found["direction"] = _vector(self.direction)
        if self.witness is not None:
            a, b = self.witness
            found["witness"] = {"a": _vector(a), "b": _vector(b)}
        if self.distance is not None:
            found["distance"] = _number(self.distance)
        if self.contacts:
            found["contacts"] = [{"position": _vector(p), **({} if depth is None else {"depth": _number(depth)})} for p,
                                 depth in self.contacts]
        if self.derivative is not None:
            found["derivative"] = _number(self.derivative)
        if self.hull is not None:
            found["hull"] = {name: [_vector(v) for v in hull] for name, hull in zip("ab", self.hull) if hull is not None}
        if self.microseconds is not None:
            found["microseconds"] = _number(self.microseconds)
        return found


def _number(x):
    x = float(x)
    return x if math.isfinite(x) else str(x)


_dimension = [3]


def _vector(v):
    numbers = [_number(x) for x in v]
    if len(numbers) != _dimension[0]:
        raise ValueError(f"{len(numbers)} numbers in the place of {_dimension[0]}")
    return numbers


def _diverted():
    """The stream for answers. Behind it standard output is standard error, also for libraries in C. A lone surrogate goes as "?"."""
    stream = os.fdopen(os.dup(1), "w", encoding="utf-8", errors="replace")
    os.dup2(2, 1)
    sys.stdout.flush()
    return stream


_answers = _diverted()  # at import: many a library prints when it is loaded


def _said(why):
    """The text of an exception, whatever it is."""
    try:
        return str(why)[:1000]
    except Exception:
        return "a text that cannot be made"


def _answer(solve, message, axis):
    twists = message.get("twist", {})
    a, b = (Body(message[name], axis, twists.get(name)) for name in "ab")
    start = time.perf_counter_ns()
    try:
        reply = solve(a, b)
        spent = (time.perf_counter_ns() - start) / 1000
        return {"microseconds": spent, **reply.fields()}
    except Unsupported as why:
        return {"unsupported": _said(why)}
    except Exception as why:  # whatever the code under test throws is its answer
        return {"failed": f"{type(why).__name__}: {_said(why)}"}


def run(solve, *, name, version, precision="binary64", touching="either", depth="positive", moves="a", unit=True,
        faces=False, shapes=(), promises=(), settings=None, rounding=None, manifold=None, claims="minimum", axis=None,
        twist=False, dimension=3):
    """Answers cases until there are no more: solve(a, b) returns a Reply for two Body values.

    name, version   of what is tested
    precision       "binary64" or "binary32": in which it computes. Bodies are rounded to it before they are sent. Or
                    {"points": ..., "answers": ...}, if points are seen in one and answers are of the other
    touching        what it says of bodies that touch: "overlap", "separate", or "either" if it makes no promise
    depth           the sign of the depth of bodies that overlap: "positive" or "negative"
    moves           which body |depth| * direction moves apart: "a" or "b"
    unit            whether directions are promised to have length 1
    faces           whether bodies of vertices need faces
    shapes          names of the shapes that it takes, "margin" if they may have one, "pieces" if it takes unions; others come as vertices,
                    unions in pairs of pieces, or not at all
    promises        which of "depth", "direction", "witness", "contacts" each answer holds that says "overlap"; "distance" of the
                    others; and "derivative" of all about bodies with a twist
    settings        {"iterations": 100, ...}: shown beside the verdicts
    rounding        a radius by which it rounds all bodies, or {"vertices": 0.01, "box": ...}, by the names of shapes
    manifold        {"most": 4, "margin": 0.01}: how many contacts an answer has at most, how much less deep those without a depth may be
    claims          "minimum": no translation is shorter than depth * direction; or "separating": no more than that this one separates
    axis            "x", "y" or "z": along which the library's own shapes lie. Bodies then come turned to it; None: as the case has them
    twist           whether bodies come with their twists, to be asked for the derivative
    dimension       2 for bodies of the plane: points and directions then have two coordinates, and the shapes are of "circle", "capsule",
                    "margin" (of polygons) and "pieces"
    """
    _dimension[0] = dimension
    hello = {"type": "hello", "protocol": PROTOCOL, "name": name, "version": version, "precision": precision,
             "conventions": {"touching": touching, "depth": depth, "moves": moves, "unit": unit, "claims": claims},
             "capabilities": {"faces": faces, "shapes": list(shapes), "twist": twist}, "promises": list(promises),
             "settings": settings or {}}
    if dimension == 2:
        hello["dimension"] = dimension
    if rounding is not None:
        hello["rounding"] = rounding
    if manifold is not None:
        hello["manifold"] = manifold
    for line in sys.stdin:
        message = json.loads(line)
        if message["type"] == "hello":
            answer = hello
        elif message["type"] == "run":
            answer = {"type": "reply", "id": message["id"], **_answer(solve, message, axis)}
        else:
            break
        _answers.write(json.dumps(answer, allow_nan=False, ensure_ascii=False) + "\n")
        _answers.flush()
