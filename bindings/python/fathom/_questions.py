# SPDX-License-Identifier: GPL-3.0-or-later
"""Other questions about two bodies: where they are; depths along a direction, in a metric, within a factor; growth; study; the judge."""
from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from typing import Any, Literal, NamedTuple, overload

from fathom import _fathom
from fathom._answers import Depth
from fathom._patches import AT_REST
from fathom._types import BodyLike, FloatArray, Number, PoseLike, Triple


@overload
def overlap(a: BodyLike, b: BodyLike, *, proof: Literal[False] = False, pose_a: PoseLike = None, pose_b: PoseLike = None) -> str: ...
@overload
def overlap(a: BodyLike, b: BodyLike, *, proof: Literal[True], pose_a: PoseLike = None,
            pose_b: PoseLike = None) -> tuple[str, dict[str, Any]]: ...


def overlap(a: BodyLike, b: BodyLike, *, proof: bool = False, pose_a: PoseLike = None, pose_b: PoseLike = None) -> Any:
    """Returns "penetrating", "touching", "disjoint", or "undecided" of curved shapes alone: of polytopes without finding their depth.

    proof  if True, for polytopes: returns also what proves it, all exact. "common", a point of both; "normal", a direction n with
           max <n,b> - min <n,a> at most 0; "around", indices of points of a and b whose differences b - a surround the origin

    >>> import fathom
    >>> fathom.overlap(fathom.box((1, 1, 1)), fathom.box((1, 1, 1)), pose_b="xyz=2,0,0", proof=True)
    ('touching', {'common': (Fraction(1, 1), Fraction(-1, 1), Fraction(-1, 1)), 'normal': (-1, 0, 0)})
    """
    return _fathom.overlap(a, b, proof, pose_a, pose_b)


@overload
def closer_than(a: BodyLike, b: BodyLike, distance: Number, *, proof: Literal[False] = False, pose_a: PoseLike = None,
                pose_b: PoseLike = None) -> bool | None: ...
@overload
def closer_than(a: BodyLike, b: BodyLike, distance: Number, *, proof: Literal[True], pose_a: PoseLike = None,
                pose_b: PoseLike = None) -> tuple[bool, dict[str, Any]]: ...


def closer_than(a: BodyLike, b: BodyLike, distance: Number, *, proof: bool = False, pose_a: PoseLike = None,
                pose_b: PoseLike = None) -> Any:
    """Returns whether a point of a and a point of b are less than `distance` apart; None where bounds of curved shapes leave it open.

    proof  if True, for polytopes: returns also "points", two such points, or "normal", a direction n with
           max <n,b> - min <n,a> at most -distance |n|

    >>> import fathom
    >>> fathom.closer_than(fathom.box((1, 1, 1)), fathom.box((1, 1, 1)), 1, pose_b="xyz=3,0,0", proof=True)
    (False, {'normal': (-1, 0, 0)})
    """
    return _fathom.closer_than(a, b, distance, proof, pose_a, pose_b)


class Ray(NamedTuple):
    """The shortest translation of A along a direction after which the interiors are disjoint."""

    status: str
    factor: Fraction  #: of the direction as it was given; 0 unless the bodies penetrate
    translation: tuple[Fraction, Fraction, Fraction]
    length: float  #: of the translation, correctly rounded
    direction: FloatArray  #: unit normal of the facet where the ray leaves, or of a plane between the bodies
    contact: dict[str, Any] | None
    witness: Any


def ray(a: BodyLike, b: BodyLike, direction: Triple, *, pose_a: PoseLike = None, pose_b: PoseLike = None) -> Ray:
    """Returns how far A must move along `direction`, of any length but 0, until the interiors are disjoint.

    >>> import fathom
    >>> fathom.ray(fathom.box((1, 1, 1)), fathom.box((1, 1, 1)), (2, 1, 0)).translation
    (Fraction(2, 1), Fraction(1, 1), Fraction(0, 1))
    """
    found = _fathom.ray(a, b, direction, pose_a, pose_b)
    return Ray(found["status"], found["factor"], found["translation"], found["length"], found["normal"][0], found.get("contact"),
               found.get("witness"))


class Growth(NamedTuple):
    """The factor by which two bodies grow, or shrink, about their centers until they touch."""

    status: str
    growth: Fraction  #: below 1 the bodies penetrate, at 1 they touch, above 1 they are disjoint
    centers: tuple[tuple[Fraction, Fraction, Fraction], tuple[Fraction, Fraction, Fraction]]  #: as given, or means of the corners
    normal: tuple[int, int, int] | None  #: exact; proves that no less suffices. Like the rest None if the centers coincide
    contact: dict[str, Any] | None
    weights: tuple[dict[int, Fraction], dict[int, Fraction]] | None  #: shares of points of A, and of B, that combine to the witness
    witness: Any  #: points a and b, exact, with center_a + growth (a - center_a) = center_b + growth (b - center_b)


def growth(a: BodyLike, b: BodyLike, center_a: Triple | None = None, center_b: Triple | None = None, *, pose_a: PoseLike = None,
           pose_b: PoseLike = None) -> Growth:
    """Returns the growth distance: the least factor by which both bodies are scaled about their centers so that they touch.

    center_a, center_b  points, which poses do not move; the means of the bodies' corners unless given. center_b - center_a
                        must be inside B - A: ValueError otherwise

    >>> import fathom
    >>> fathom.growth(fathom.box((1, 1, 1)), fathom.box((1, 1, 1)), pose_b="xyz=3,0,0").growth
    Fraction(3, 2)
    """
    found = _fathom.growth(a, b, center_a, center_b, pose_a, pose_b)
    return Growth(found["status"], found["growth"], found["centers"], found.get("normal"), found.get("contact"), found.get("weights"),
                  found.get("witness"))


class Impact(NamedTuple):
    """When two bodies that turn and move meet first."""

    status: str  #: "apart", "contact", "grazing" or "at the beginning"
    pieces: list[dict[str, Any]]  #: of the time, each "until" its end: "plane" and "directions" that separate the bodies, or a "gap"
    times: tuple[Fraction, Fraction] | None  #: t0 and t1 of a contact: apart up to t0; a point in common at t1 = t0 + 2**-bits
    points: tuple[Any, Any, Any] | None  #: that point in the world, in the frame of A, in the frame of B; exact
    normal: tuple[int, int, int] | None  #: from B to A, of the plane that separates the bodies at t0
    contact: dict[str, Any] | None  #: the faces nearest to that plane
    weights: tuple[dict[int, Fraction], dict[int, Fraction]] | None  #: shares of points of A, and of B, that combine to the point
    beginning: tuple[str, Fraction] | None  #: status and squared depth at t = 0, if they meet there
    certificate: str | None  #: if it was asked for


def impact(a: BodyLike, b: BodyLike, motion_a: Sequence[PoseLike] | None = None, motion_b: Sequence[PoseLike] | None = None, *,
           bits: int = 40, delta: Number | None = None, certificate: bool = False) -> Impact:
    """Returns when two polytopes meet first while t goes from 0 to 1, with planes that separate them until then. Exact.

    motion_a, motion_b  where a body is at t = 0 and at t = 1: two poses, by a quaternion or angles and a translation; at rest if None.
                        The place is (1 - t) p0 + t p1, the rotation that of (1 - t) q0 + t q1, the shorter way
    bits                t1 - t0 is 2**-bits, from 1 to 1000
    delta               bodies that come so near, and cannot be shown to be apart, graze; 2**-bits of the extent if None
    certificate         if True, adds the text of a certificate

    >>> import fathom
    >>> cube = fathom.box((1, 1, 1))
    >>> fathom.impact(cube, cube, motion_a=("xyz=0,0,4", "xyz=0,0,0"), bits=3).times
    (Fraction(3, 8), Fraction(1, 2))
    """
    found = _fathom.impact(a, b, motion_a, motion_b, bits, delta, certificate)
    return Impact(found["status"], found["pieces"], found.get("times"), found.get("points"), found.get("normal"), found.get("contact"),
                  found.get("weights"), found.get("beginning"), found.get("certificate"))


class Metric(NamedTuple):
    """A depth in the metric of a polytope."""

    status: str
    depth: Fraction  #: 0 unless the bodies penetrate
    optima: list[dict[str, Any]]  #: vertex, translation, normal, contact of each shortest way out along a vertex of the ball
    direction: FloatArray


def metric(a: BodyLike, b: BodyLike, ball: BodyLike, *, pose_a: PoseLike = None, pose_b: PoseLike = None) -> Metric:
    """Returns the depth where a polytope around the origin, symmetric or not, is the unit ball.

    >>> import fathom
    >>> cube, octahedron = fathom.box((1, 1, 1)), [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    >>> fathom.metric(cube, cube, octahedron).depth
    Fraction(2, 1)
    """
    found = _fathom.metric(a, b, ball, pose_a, pose_b)
    return Metric(found["status"], found["depth"], found["optima"], found["normal"][0])


class Approx(NamedTuple):
    """A depth within a factor."""

    status: str
    low: float  #: at most the depth, rounded down
    high: float  #: at least the depth: the length of the translation, rounded up
    low_squared: Fraction
    high_squared: Fraction
    translation: tuple[Fraction, Fraction, Fraction]  #: makes the interiors disjoint
    direction: FloatArray


def approx(a: BodyLike, b: BodyLike, delta: Number = "1/100", *, pose_a: PoseLike = None, pose_b: PoseLike = None) -> Approx:
    """Returns a translation that separates the bodies, at most 1 + delta times as long as the shortest one.

    >>> import fathom
    >>> found = fathom.approx(fathom.box((1, 1, 1)), fathom.box((1, 1, 2)), "1/10")
    >>> found.low <= 2 <= found.high <= 1.1 * found.low
    True
    """
    found = _fathom.approx(a, b, delta, pose_a, pose_b)
    return Approx(found["status"], found["low"], found["high"], found["low_squared"], found["high_squared"], found["translation"],
                  found["normal"][0])


class Study(NamedTuple):
    """The degeneracies of two bodies."""

    depth: Depth
    coincidences: dict[str, dict[str, Any]]  #: by name: how many, and the first of them with their features
    predicates: dict[str, dict[str, Any]]  #: by name: calls, how many met an exact zero, and which monomial decided; empty of shapes
    a: dict[str, Any]  #: rank, vertices, edges, facets; of shapes half_space, terms, points, discs, balls, radius
    b: dict[str, Any]

    @property
    def names(self) -> list[str]:
        """The names of what coincides."""
        return [name for name, found in self.coincidences.items() if found["count"]]


def study(a: BodyLike, b: BodyLike, *, listed: int = 20, pose_a: PoseLike = None, pose_b: PoseLike = None) -> Study:
    """Names what coincides: parallel edges, coplanar facets, ties and so on; of shapes, axes, radii, faces (docs/command_line.md).

    >>> import fathom
    >>> "coincident_normals" in fathom.study(fathom.box((1, 1, 1)), fathom.box((1, 2, 3))).names
    True
    """
    found = _fathom.study(a, b, listed, pose_a, pose_b)
    return Study(Depth(found["answer"]), found["coincidences"], found["predicates"], found["a"], found["b"])


class Judgement(NamedTuple):
    """What is right and wrong about an answer (verify/judge/VERDICTS.md)."""

    passed: bool
    verdict: str  #: the first of the findings, or a pass: "pass", "too-deep", "false-separation", ...
    status: str  #: the truth; "undecided" of shapes only
    signed_depth: tuple[float, float] | None  #: the truth about shapes, rounded outward; None of polytopes and unions
    depth_squared: Fraction | None  #: the truth about polytopes and unions, as is distance_squared; None of shapes
    distance_squared: Fraction | None
    findings: list[str]  #: everything that is wrong, in order of rank
    accuracy: str | None  #: the best class of a pass with a depth or a distance
    error: float | None  #: claimed depth or distance less the true one, correctly rounded
    error_ulps: float | None
    error_relative: float | None
    error_u_r: float | None  #: in units of roundoff times the largest coordinate
    separating_distance_squared: Fraction | None  #: along the claimed direction, to a plane across it; negative of bodies apart
    exit_distance_squared: Fraction | None  #: the shortest way along it after which the interiors are disjoint
    separating_distance: tuple[float, float] | None  #: of shapes: along the claimed direction, to a plane across it, rounded outward
    inconsistency: float | None  #: claimed depth less separating distance; of unions minus the overlap that is left, or the gap
    overlap_left: float | None  #: after the claimed translation
    witness_a_squared: Fraction | None  #: squared distances of the claimed points from their bodies
    witness_b_squared: Fraction | None
    witness_a_distance: tuple[float, float] | None  #: of shapes, rounded outward
    witness_b_distance: tuple[float, float] | None
    witness_gap: float | None  #: by how much the difference of the points misses the translation
    contact_a_squared: Fraction | None  #: of the contact that is farthest from A, and of that from B
    contact_b_squared: Fraction | None
    contact_a_distance: tuple[float, float] | None  #: of shapes, rounded outward
    contact_b_distance: tuple[float, float] | None
    deepest: float | None  #: the largest depth of a contact less the claimed depth
    extent_missed: float | None  #: with a slack: how far a corner of the patch is from the hull of the contacts, at most
    extent_missed_squared: Fraction | None
    extent_covered: float | None  #: the share of its area, or of its length, in that hull; None of a point
    extent_covered_squared: Fraction | None
    relative_excess: float | None  #: the separating distance over the depth, less 1
    excess_allowed: bool  #: whether the depth would be too deep, but for the policy
    deepest_pair: dict[str, Any] | None  #: of unions that overlap: squared, and the two pieces, from 0
    hulls_squared: Fraction | None  #: the squared depth of the hulls of these unions
    deeper_than_pair: float | None  #: their depth over that of the deepest pair, correctly rounded
    deeper: float | None  #: their depth over the claimed one, correctly rounded
    deeper_squared: Fraction | None
    derivative: dict[str, Any] | None  #: of a claimed one: claimed, squared (the true one's), left_out, kinks, error, sentence
    sentence: str  #: for people

def judge(a: BodyLike, b: BodyLike, *, overlap: bool, depth: float | None = None, direction: Any = None, witness: Any = None,
          contacts: Iterable[Any] = (), distance: float | None = None, touching: str = "either", sign: str = "positive", moves: str = "a",
          unit: bool = True, claims: str = "minimum", manifold: tuple[int | None, float] | None = None, policy: str = "declared",
          precision: str = "binary64", answers: str | None = None, relative: Number = "1/1000", absolute: Number = "1/1000000",
          patch_slack: Number | None = None, derivative: float | None = None, v: Triple = AT_REST, w: Triple | Number = AT_REST,
          v_b: Triple = AT_REST, w_b: Triple | Number = AT_REST,
          pose_a: PoseLike = None, pose_b: PoseLike = None) -> Judgement:
    """Judges what another program answered about two bodies, by exact comparison; about shapes, by proved bounds.

    Bodies may be unions of convex pieces (`fathom.union`): a claimed translation is judged by what it leaves. Of bodies of the plane
    points and vectors have two numbers, and w and w_b are one.

    overlap, depth, direction, witness  its answer: |depth| * direction takes the bodies apart; witness is a point of A and one of B
    distance   of bodies that are said to be apart: witness then is a pair of nearest points, and along direction they go farther apart
    contacts   pairs of a point of both bodies and the depth there, or None; the largest is the depth
    touching   what it says of bodies that touch: "overlap", "separate", "either"
    sign       of its depths: "positive" or "negative"; `conventions.depth` in the protocol
    moves      which body the direction moves: "a" or "b"
    unit       whether it promises directions of length 1
    manifold   that its contacts reach as far as the bodies touch: how many there are at most, or None, and how much less deep than the
               answer those without a depth may be
    claims     "minimum", or "separating": no more than that its translation separates, at the separating distance of its direction
    policy     "declared", as it claims; "minimum", "separating", or "within=5%": or at most so much above the depth
    precision  "binary64" or "binary32": points are rounded to it first, the numbers of shapes are not
    answers    the precision of the answer's numbers; as that of points if None
    relative, absolute  how wrong an answer may be, of the depth and of the bodies' extent
    derivative  how fast it says that the signed depth grows, deeper being more, as A begins to move, its point p with the velocity
               v + w x p, and B with v_b + w_b x p; it is judged exactly, from one side
    patch_slack  a length: contacts are to reach all lines along which the bodies overlap by the depth less it, not the exact patch

    >>> import fathom
    >>> cube = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    >>> fathom.judge(cube, cube, overlap=True, depth=1.25, direction=(1, 0, 0)).verdict
    'too-deep'
    >>> fathom.judge(cube, cube, overlap=True, depth=1.0, direction=(0, 0, 1)).passed
    True
    >>> fathom.judge(cube, [(2, 0, 0), (3, 0, 0)], overlap=False, distance=1.5).sentence
    'too far by 0.5: 1.5 is claimed, the distance is 1'
    >>> found = fathom.judge(cube, cube, overlap=True, derivative=0.0, v=(1, 0, 0))
    >>> found.verdict, found.derivative["squared"], found.derivative["kinks"]
    ('wrong-derivative', Fraction(-1, 1), ['ties', 'extended'])
    >>> brick = [(2 * x, y, z) for x, y, z in cube]
    >>> found = fathom.judge(brick, brick, overlap=True, depth=2.0, direction=(1, 0, 0), claims="separating")
    >>> found.passed, found.relative_excess
    (True, 1.0)
    """
    claim = {"overlap": overlap, "depth": depth, "direction": direction, "witness": witness, "distance": distance,
             "contacts": contacts, "touching": touching, "sign": sign, "moves": moves, "unit": unit,
             "claims": claims, "manifold": manifold, "policy": policy, "precision": precision, "answers": answers, "relative": relative, "absolute": absolute,
             "patch_slack": patch_slack, "derivative": derivative, "v": v, "w": w, "v_b": v_b, "w_b": w_b}
    found = _fathom.judge(a, b, claim, pose_a, pose_b)
    return Judgement(**found)
