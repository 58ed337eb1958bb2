# SPDX-License-Identifier: GPL-3.0-or-later
"""Depths and distances, their certificates, and the checker."""
from __future__ import annotations

import copyreg
import math
import operator
import types
import warnings
from fractions import Fraction
from typing import Any, Callable, Iterable, NamedTuple, Sequence

import numpy as np

from fathom import _fathom
from fathom._patches import ContactAnswer
from fathom._types import BodyLike, FloatArray, PoseLike

DEFAULT_BITS, MOST_BITS, MOST_THREADS = 64, 1000, 1024


class NotConvexWarning(UserWarning):
    """A mesh is not convex, or is open: the answer is that of its hull; `fathom.solid(mesh)` is the mesh itself.

    `warnings.simplefilter("error", fathom.NotConvexWarning)` makes it an error.
    """


class Root(NamedTuple):
    """The number rational + sqrt(root), or rational - sqrt(-root) if root is negative. Of a rational number the root is 0."""

    rational: Fraction
    root: Fraction


def _simplified(rational: Fraction, root: Fraction) -> Root:
    above, below = math.isqrt(abs(root.numerator)), math.isqrt(root.denominator)
    if above * above != abs(root.numerator) or below * below != root.denominator:
        return Root(rational, root)
    return Root(rational + Fraction(above, below) * (1 if root > 0 else -1), Fraction(0))


class _Kept(types.SimpleNamespace):
    """The fields of an answer, without the answer of C++: what pickle keeps. Methods compute the answer again."""

    __slots__ = ("_asked",)  # not pickled

    def certificate(self, id: str, patches: bool) -> str:
        """Returns the certificate of the answer that is computed again."""
        return self._again().certificate(id, patches)

    def manifold(self) -> _fathom.Manifold | None:
        """Returns the manifold of the answer that is computed again; None if its search was stopped."""
        return self._again().manifold() if self.complete else None

    def _again(self) -> _fathom.Answer:
        """Returns the answer to the same question, computed again at the first call."""
        if not hasattr(self, "_asked"):
            ask, *arguments = self.question
            self._asked: _fathom.Answer = getattr(_fathom, ask)(*arguments)
        return self._asked


_FIELDS = [name for name, member in vars(_fathom.Answer).items() if isinstance(member, property)]
copyreg.pickle(_fathom.Answer, lambda found: (_Kept, (), {name: getattr(found, name) for name in _FIELDS}))


class Optimum:
    """One shortest way out.

    direction    unit vector, each component correctly rounded
    translation  moving A by it makes the interiors disjoint
    normal       the direction as integers, exact and primitive
    contact      {"kind": "facet-vertex", "a": (0, 1, 2), "b": (5,)}: the features that touch then, as indices of points; or None
    exact        the translation, as Fractions; of shapes (n, alpha, beta), for alpha n + beta n/|n|
    """

    __slots__ = ("direction", "translation", "normal", "contact", "exact")

    def __init__(self, fields: dict[str, Any]):
        self.direction: FloatArray = fields["direction"]
        self.translation: FloatArray = fields["translation"]
        self.normal: tuple[int, ...] = fields["normal"]
        self.contact: dict[str, Any] | None = fields["contact"]
        self.exact = fields["exact_translation"]

    def __repr__(self) -> str:
        return f"Optimum(translation={self.translation.tolist()})"


class Exact:
    """The exact numbers of an answer, as Fractions and ints."""

    __slots__ = ("_answer",)

    def __init__(self, answer: _fathom.Answer):
        self._answer = answer

    @property
    def signed_depth(self) -> Root | None:
        """depth > 0, 0 for bodies that touch, -distance < 0; None if only bounds are known."""
        value = self._answer.exact_value
        return None if value is None else _simplified(*value)

    @property
    def bounds(self) -> tuple[Fraction, Fraction] | None:
        """Proved bounds of the signed depth; None if its exact value is known."""
        return self._answer.bounds

    @property
    def depth_squared(self) -> Fraction | None:
        """depth^2 of polytopes, 0 unless they penetrate; None where it may be irrational."""
        value = self._answer.exact_value
        return None if value is None or value[0] != 0 else max(value[1], Fraction(0))

    @property
    def distance_squared(self) -> Fraction | None:
        """distance^2 of polytopes, 0 unless they are disjoint; None where it may be irrational."""
        value = self._answer.exact_value
        return None if value is None or value[0] != 0 else max(-value[1], Fraction(0))

    @property
    def normal(self) -> tuple[int, ...]:
        """The direction as primitive integers."""
        return self._answer.normal

    @property
    def around(self) -> tuple[int, ...] | None:
        """The axis of bodies of revolution, if every rotation about it maps the direction to one that is as good; else None."""
        return self._answer.around

    @property
    def translation(self) -> Any:
        """Fractions; of shapes (n, alpha, beta), which means alpha n + beta n/|n|; None if only bounds are known."""
        return self._answer.exact_translation

    @property
    def witness(self) -> Any:
        """A point of A and one of B, as Fractions; of shapes (p, n, r) each, which means p + r n/|n|; or None."""
        return self._answer.exact_witness

    def __repr__(self) -> str:
        if self.signed_depth is None:
            return f"Exact(bounds={self.bounds})"
        return f"Exact(signed_depth={self.signed_depth}, translation={self.translation})"


class _Answer:
    """A number that is known exactly, or enclosed by bounds."""

    __slots__ = ("_answer",)

    def __init__(self, answer: _fathom.Answer):
        self._answer = answer

    @property
    def low(self) -> float:
        """The largest float that is at most the signed depth, or the width, or at most its lower bound."""
        return self._answer.low

    @property
    def high(self) -> float:
        """The least float that is at least the signed depth, or the width, or at least its upper bound."""
        return self._answer.high


class PairAnswer(_Answer, ContactAnswer):
    """The properties of answers about two bodies of any kind."""

    __slots__ = ()

    @property
    def status(self) -> str:
        """"penetrating", "touching" if the interiors are disjoint but the bodies meet, or "disjoint"; of cylinders and the like also
        "undecided", if the bounds leave it open."""
        return self._answer.status

    @property
    def depth(self) -> float | None:
        """The length of the shortest translation that makes the interiors disjoint: 0.0 unless the bodies penetrate. None if there are
        bounds that have not the same nearest float, or the search for it was stopped."""
        value = self._answer.nearest
        return None if value is None else max(0.0, value)

    @property
    def signed_depth(self) -> float | None:
        """depth > 0, 0.0 for bodies that touch, -distance < 0. None if there are bounds that have not the same nearest float: more `bits`
        bring them closer."""
        return self._answer.nearest

    @property
    def distance(self) -> float | None:
        """0.0 unless the bodies are disjoint. None as `depth`."""
        value = self.signed_depth
        return None if value is None else max(0.0, -value)

    @property
    def direction(self) -> FloatArray | None:
        """Unit vector along which A leaves B; of disjoint bodies it is the one from B to A along the shortest distance. None of unions that
        touch."""
        return self._answer.direction

    @property
    def translation(self) -> FloatArray | None:
        """The shortest translation of A after which the bodies touch, the first of several: zero if they touch already. None if only bounds
        are known; of unions whose search was stopped the shortest that was found."""
        return self._answer.translation

    @property
    def witness(self) -> tuple[FloatArray, FloatArray] | None:
        """A point of A and one of B that differ by the translation: b - a = translation. None if only bounds are known, and of unions that
        are not disjoint."""
        return self._answer.witness

    @property
    def exact(self) -> Exact:
        """The same in Fractions."""
        return Exact(self._answer)

    @property
    def notes(self) -> list[str]:
        """Warnings about the input: a pose that is no rotation, bodies of very different size, a mesh that is not convex."""
        return self._answer.notes

    @property
    def counters(self) -> dict[str, Any]:
        """Counts of the work, which do not depend on the machine; "stages": those that ran, "predicates": their calls. Of unions
        nodes, nearest_points, pairs, pairs_touched."""
        return self._answer.counters

    def certificate(self, id: str = "", patches: bool = False) -> str:
        """A proof of the answer as text, which `check` and two other checkers read (verify/check/FORMAT.md). With `patches` it proves these
        too, unless they are of unions or of the plane, or `left_out` says why there are none. Raises ValueError if the search was
        stopped."""
        if not self._answer.complete:
            raise ValueError("there is no certificate of a search that was stopped")
        return self._answer.certificate(id, patches)

    def __repr__(self) -> str:
        name, value = type(self).__name__, self._answer.nearest
        if value is None:
            return f"{name}({self.status}, between {self.low!r} and {self.high!r})"
        number = f"distance={-value!r}" if self.status == "disjoint" else f"depth={max(0.0, value)!r}"
        return f"{name}({self.status}, {number})"


class Depth(PairAnswer):
    """How deep two bodies overlap, or how far apart they are.

    >>> import fathom
    >>> apart = fathom.depth([(0, 0, 0)], [(3, 4, 0)])
    >>> apart.status, apart.distance, apart.signed_depth
    ('disjoint', 5.0, -5.0)
    >>> apart.direction, apart.translation
    (array([-0.6, -0.8,  0. ]), array([3., 4., 0.]))
    >>> fathom.check(apart.certificate()).accepted
    True
    """

    __slots__ = ()

    @property
    def optima(self) -> list[Optimum]:
        """All shortest ways out, or as many as were asked for. Empty unless the bodies penetrate and more than bounds is known."""
        return [Optimum(fields) for fields in self._answer.optima] if self.status == "penetrating" else []

    @property
    def optima_count(self) -> int:
        """How many shortest ways out there are, listed or not."""
        return self._answer.optima_count if self.status == "penetrating" else 0

    @property
    def flat(self) -> tuple[bool, bool]:
        """Whether A and B have no interior."""
        return self._answer.flat

    @property
    def contact(self) -> dict[str, Any] | None:
        """The features that face each other in `direction`, as indices of points: {"kind": "facet-vertex", "a": (0, 1, 2), "b": (5,)}. Of
        rounded bodies those of their cores; None for cylinders and the like."""
        return self._answer.contact

    @property
    def method(self) -> str | None:
        """The method that found the answer: "certificate", "exact" or "naive". None for cylinders and the like."""
        return self._answer.method


def _integer(name: str, value: Any, most: int) -> int:
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"{name}: expected an integer, found {value!r}") from None
    if not 1 <= number <= most:
        raise ValueError(f"{name}: expected an integer from 1 to {most}, found {number}")
    return number


def _question(method: str, optima: int | None, bits: int) -> tuple[str, int | None, int]:
    return method, None if optima is None else _integer("optima", optima, 2**63 - 1), _integer("bits", bits, MOST_BITS)


def _told(answer: _fathom.Answer) -> Depth:
    if answer.dents:
        warnings.warn(answer.dents, NotConvexWarning, stacklevel=3)
    return Depth(answer)


def depth(a: BodyLike, b: BodyLike, *, pose_a: PoseLike = None, pose_b: PoseLike = None, method: str = "automatic",
          optima: int | None = None, bits: int = DEFAULT_BITS) -> Depth:
    """Returns the exact penetration depth of two convex bodies, or their distance.

    a, b            bodies: see the module
    pose_a, pose_b  exact maps of the bodies: rows of 3 x 4 or 4 x 4 numbers, in the plane 2 x 3 or 3 x 3, `fathom.pose(...)`, or a text as
                    on the command line: "xyz=0,0,1.5 rpy=0,0,45deg". Rotations of floats are hardly ever exact: what is answered is the
                    body under that matrix
    method          "automatic", "exact", "naive", "certificate": the answer is the same
    optima          at most so many shortest ways out are listed; all are counted
    bits            of the bounds, for cylinders, cones, ellipsoids and half-spaces against them

    >>> import fathom
    >>> fathom.depth(fathom.cylinder(1, 2), fathom.box((1, 1, 1)), pose_b=fathom.pose(translation=(0, 0, 2.5)))
    Depth(penetrating, depth=0.5)
    >>> fathom.depth(fathom.box((1, 1, 1)), fathom.sphere(1), pose_a=[[2, 0, 0, 0], [0, 2, 0, 0], [0, 0, 2, 0]]).notes
    ['pose_a: det 8, not a rotation: the body is scaled by 2']
    >>> fathom.depth([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [("1/10", "1/10", "0.1"), (1, 1, 1)]).exact.depth_squared
    Fraction(49, 300)
    """
    return _told(_fathom.depth(a, b, pose_a, pose_b, *_question(method, optima, bits)))


def distance(a: BodyLike, b: BodyLike, *, pose_a: PoseLike = None, pose_b: PoseLike = None, bits: int = DEFAULT_BITS) -> Depth:
    """Returns the answer of `depth`, for callers who need the distance: see its `distance`, `witness` and `direction`.

    >>> import fathom
    >>> fathom.distance(fathom.sphere(1), fathom.sphere(1), pose_b=fathom.pose(translation=(3, 0, 0))).distance
    1.0
    """
    return _told(_fathom.depth(a, b, pose_a, pose_b, *_question("automatic", None, bits)))


class Depths(list["Depth | Exception"]):
    """The answers about many pairs, in their order, as a list; and their numbers as arrays, with a place for each pair.

    The numbers are those of `Depth`. They are NaN where bounds leave a number open, and for a pair that was wrong, in whose place the list
    has the exception.

    >>> import fathom, numpy as np
    >>> cube = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)])
    >>> hits = fathom.depths([(cube, cube + [0.75, 0, 0]), (cube, cube * np.nan), (cube, cube + [0, 0, 3])], errors="return")
    >>> hits.status, hits.signed_depth
    (array(['penetrating', 'failed', 'disjoint'], dtype='<U11'), array([ 0.25,   nan, -2.  ]))
    >>> hits.direction
    array([[-1.,  0.,  0.],
           [nan, nan, nan],
           [ 0.,  0., -1.]])
    """

    __slots__ = ()

    @property
    def status(self) -> Any:
        """Texts: that of the answer, or "failed"."""
        return np.array([hit.status if isinstance(hit, Depth) else "failed" for hit in self], dtype="U11")

    @property
    def signed_depth(self) -> FloatArray:
        """depth > 0, 0.0 for bodies that touch, -distance < 0."""
        return self._numbers("signed_depth")

    @property
    def depth(self) -> FloatArray:
        """0.0 unless the bodies penetrate."""
        return self._numbers("depth")

    @property
    def distance(self) -> FloatArray:
        """0.0 unless the bodies are disjoint."""
        return self._numbers("distance")

    @property
    def low(self) -> FloatArray:
        """The largest floats that are at most the signed depth, or its lower bound."""
        return self._numbers("low")

    @property
    def high(self) -> FloatArray:
        """The least floats that are at least the signed depth, or its upper bound."""
        return self._numbers("high")

    @property
    def direction(self) -> FloatArray:
        """Unit vectors, of shape (n, 3); (n, 2) of bodies of the plane."""
        lengths = {len(hit.direction) for hit in self if isinstance(hit, Depth)} or {3}
        if len(lengths) > 1:
            raise ValueError("expected pairs that are all of the plane, or all of space, found some of each")
        none = np.full(*lengths, np.nan)
        return np.array([hit.direction if isinstance(hit, Depth) else none for hit in self]).reshape(-1, *lengths)

    @property
    def gradients(self) -> FloatArray:
        """The gradients by A's poses, v and w of `Depth.gradient` in a row, of shape (n, 6). NaN where the signed depth is not smooth."""
        return np.array([self._gradient(hit) for hit in self]).reshape(-1, 6)

    @staticmethod
    def _gradient(hit: Depth | Exception) -> FloatArray:
        found = hit.gradient if isinstance(hit, Depth) else None
        return np.full(6, np.nan) if found is None else np.concatenate([found.v, found.w])

    def _numbers(self, name: str) -> FloatArray:
        return np.array([getattr(hit, name, None) for hit in self], dtype=float)  # None is NaN


def depths(pairs: Iterable[tuple[BodyLike, BodyLike]] | BodyLike, b: BodyLike | None = None, *,
           poses_a: Sequence[PoseLike] | FloatArray | None = None, poses_b: Sequence[PoseLike] | FloatArray | None = None,
           threads: int | None = None, method: str = "automatic", optima: int | None = None, bits: int = DEFAULT_BITS,
           errors: str = "raise", progress: Callable[[int, int], Any] | None = None) -> Depths:
    """Answers many pairs: `depths(pairs)`; two bodies in many places: `depths(a, b, poses_b=poses)`; or arrays of bodies: `depths(a, b)`.

    pairs             pairs of bodies
    a, b              a body for all pairs, or an array of shape (n, m, 3), in the plane (n, m, 2), with n bodies of m points each: where
                      both are arrays, the first of a with the first of b, and so on. Nothing is made of Python between an array of
                      floats and the answers
    poses_a, poses_b  poses of a and of b, an array of shape (n, 4, 4) or (n, 3, 4), in the plane (n, 2, 3), or any sequence: where both are
                      given, as many of both
    threads           how many, or all cores; fewer where the system gives no more
    method, optima, bits  as for `depth`
    errors            "raise": the first pair that is wrong, by its place, raises ValueError or TypeError. "return": a wrong pair has its
                      exception in the list, and the others are answered
    progress          called now and then, twenty times a second at most, with how many pairs are answered and how many there are; at last
                      with both equal. What it raises ends the call

    >>> import fathom, numpy as np
    >>> cube = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)])
    >>> [hit.depth for hit in fathom.depths((cube, cube + [0, 0, 1 - s]) for s in (0.5, 0.25, 0.125))]
    [0.5, 0.25, 0.125]
    >>> poses = np.tile(np.eye(4), (3, 1, 1))
    >>> poses[:, 0, 3] = 0.5, 1, 1.5
    >>> fathom.depths(cube, cube, poses_b=poses).signed_depth
    array([ 0.5,  0. , -0.5])
    >>> fathom.depths(cube, cube + poses[:, None, :3, 3]).signed_depth
    array([ 0.5,  0. , -0.5])
    """
    if b is None and (poses_a is not None or poses_b is not None):
        raise TypeError("expected poses with two bodies, as depths(a, b, poses_b=poses), found them with pairs")
    if errors not in ("raise", "return"):
        raise ValueError(f"errors: expected 'raise' or 'return', found {errors!r}")
    if progress is not None and not callable(progress):
        raise TypeError(f"progress: expected a function, found {progress!r}")
    asked = _question(method, optima, bits)
    threads = 0 if threads is None else _integer("threads", threads, MOST_THREADS)
    found = _fathom.depths(pairs, b, poses_a, poses_b, *asked, threads, errors == "return", progress)
    result = Depths()
    for hit in found:
        result.append(hit if isinstance(hit, Exception) else _told(hit))
    return result


class Width(_Answer):
    """The width of a body: the least distance of two parallel planes that hold it between them."""

    __slots__ = ()

    @property
    def width(self) -> float | None:
        """0.0 for a flat body. None if there are bounds that have not the same nearest float: more `bits` bring them closer."""
        return self._answer.nearest

    @property
    def squared(self) -> Fraction | None:
        """The exact square, of polytopes; None where it may be irrational."""
        return Exact(self._answer).depth_squared

    @property
    def direction(self) -> FloatArray:
        """Unit normal of the two planes."""
        return self._answer.direction

    @property
    def optima(self) -> list[Optimum]:
        """Each pair of planes, with both signs of its normal."""
        return [Optimum(fields) for fields in self._answer.optima]

    def __repr__(self) -> str:
        return f"Width(between {self.low!r} and {self.high!r})" if self.width is None else f"Width({self.width!r})"


def width(body: BodyLike, *, pose: PoseLike = None, bits: int = DEFAULT_BITS) -> Width:
    """Returns the width of a body: exact of polytopes and rounded ones, else between proved bounds, with so many `bits`.

    >>> import fathom
    >>> fathom.width([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]).squared
    Fraction(1, 3)
    >>> fathom.width(fathom.capsule(1, 2))
    Width(2.0)
    """
    return Width(_fathom.width(body, pose, _integer("bits", bits, MOST_BITS)))


class Checked(NamedTuple):
    """The verdict of the checker on a certificate."""

    accepted: bool
    status: str  #: of the bodies, if it is accepted
    verdict: str  #: the line that the program fathom-check prints
    reason: str  #: why not, if it is not accepted
    line: int  #: the line of the certificate where that was found


def check(certificate: str) -> Checked:
    """Checks a certificate, by the independent checker.

    >>> import fathom
    >>> proof = fathom.depth(fathom.box((1, 1, 1)), fathom.box((1, 1, 2))).certificate("boxes")
    >>> fathom.check(proof).verdict
    's VERIFIED penetrating depth_squared=4 optima=4 boxes'
    >>> fathom.check(proof.replace("depth 4", "depth 5")).accepted
    False
    """
    found = _fathom.check(certificate)
    return Checked(found["accepted"], found["status"], found["verdict"], found["reason"], found["line_number"])
