# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies of the plane: against thick prisms in space, in numbers of two coordinates; and what takes none says so."""
import pickle
from fractions import Fraction

import numpy as np
import pytest

import fathom
from fathom import plane

SQUARE = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], float)
CUBE = fathom.box((1, 1, 1))
MIXED = "a body of the plane and one of space are given: both must be of one of them"


def polygons(seed):
    random = np.random.default_rng(seed)
    return random.integers(-9, 10, (5, 2)), random.integers(-9, 10, (6, 2)) + random.integers(0, 16, 2)


def prism(points, height):
    return np.concatenate([np.column_stack([points, np.full(len(points), z)]) for z in (-height, height)])


@pytest.mark.parametrize("seed", range(100))
def test_as_of_prisms(seed):
    a, b = polygons(seed)
    flat, thick = fathom.depth(a, b), fathom.depth(prism(a, 64), prism(b, 64))
    assert flat.status == thick.status
    assert flat.exact.signed_depth == thick.exact.signed_depth
    assert {way.normal for way in flat.optima} == {way.normal[:2] for way in thick.optima}
    assert flat.optima_count == thick.optima_count


def test_two_coordinates():
    hit = fathom.depth(SQUARE, SQUARE + [0.75, 0.25])
    assert hit.direction.tolist() == [-1, 0] and hit.translation.tolist() == [-0.25, 0]
    assert hit.exact.normal == (-1, 0) and hit.exact.translation == (Fraction(-1, 4), 0)
    assert [p.shape for p in hit.witness] == [(2,), (2,)] and [len(p) for p in hit.exact.witness] == [2, 2]
    [way] = hit.optima
    assert way.normal == (-1, 0) and way.exact == (Fraction(-1, 4), 0) and way.direction.shape == way.translation.shape == (2,)
    assert way.contact == {"kind": "edge-edge", "a": (1, 2), "b": (0, 3)} == hit.contact
    assert hit.flat == (False, False) and fathom.depth(SQUARE, SQUARE[:2]).flat == (False, True)
    assert pickle.loads(pickle.dumps(hit)).direction.tolist() == [-1, 0]


def test_rounded_bodies():
    apart = fathom.distance(plane.circle(1), plane.capsule(1, "1/2", "y"), pose_b=[[1, 0, 4], [0, 1, 0]])
    assert apart.distance == 2 and [len(p) for p in apart.witness] == [2, 2]
    assert apart.translation.tolist() == [2, 0] and apart.exact.translation[0] == (-1, 0)
    assert fathom.depth(plane.halfplane((0, 1), 0), plane.circle(1)).exact.signed_depth == (1, 0)
    assert fathom.overlap(plane.box((1, 2)), plane.circle(1), pose_b=plane.pose(translation=(2, 0))) == "touching"
    assert fathom.closer_than(plane.box((1, 2)), [(3, 0)], 2) is False


def test_poses():
    quarter = plane.pose(1, (2, 0))
    assert plane.polygon([(1, 0)]).moved(quarter).points == [(2, 1)]
    for pose in ([[0, -1, 2], [1, 0, 0]], np.array([[0, -1, 2], [1, 0, 0], [0, 0, 1]]), "xyz=2,0,0 rpy=0,0,90deg"):
        assert plane.polygon([(1, 0)]).moved(pose).points == [(2, 1)]
    for pose, sentence in [("xyz=0,0,1", "expected a pose in the plane"), ([[1, 0, 0], [0, 1]], "2 or 3 rows of 3 numbers"),
                           ([[1, 0, 0], [0, 1, 0], [0, 1, 1]], "expected 0 0 1 as the last row")]:
        with pytest.raises(ValueError, match=sentence):
            plane.polygon([(1, 0)]).moved(pose)
    with pytest.raises(ValueError, match="expected two numbers"):
        plane.pose(translation=(1, 2, 3))
    for rows in (np.eye(3), np.eye(2, 3)):  # a rotation of space has no such form
        with pytest.raises(ValueError, match="expected a pose of 3 or 4 rows of 4 numbers"):
            CUBE.moved(rows)


def test_unions():
    slot = [plane.box((5, 5)).moved(plane.pose(translation=(x, 0))) for x in (-5, 6)]
    hit = fathom.union_depth([(0.75, -1), (1.75, -1), (1.75, 1), (0.75, 1)], slot)
    assert hit.squared == Fraction(9, 16) and hit.translation.tolist() == [-0.75, 0] and hit.optima[0].exact == (Fraction(-3, 4), 0)
    assert [(met.normal, met.contact["kind"]) for met in hit.optima[0].contacts] == [((1, 0), "edge-edge"), ((-1, 0), "edge-edge")]
    apart = fathom.union_depth([[(20, 0), (21, 0), (20, 1)]], fathom.union(slot)).apart
    assert apart.distance == 9 and [len(p) for p in (*apart.witness, apart.translation)] == [2, 2, 2]
    with pytest.raises(ValueError, match="pieces: piece 1: expected bodies that are all of the plane, or all of space"):
        fathom.union([SQUARE, CUBE])


@pytest.mark.parametrize("hit", [
    fathom.depth(SQUARE, SQUARE + [0.75, 0.25]), fathom.distance(SQUARE, SQUARE + 4), fathom.depth(SQUARE, SQUARE + [1, 0]),
    fathom.depth(SQUARE, plane.circle(1)), fathom.depth(plane.halfplane((1, 2), 1), plane.capsule(1, 2)),
    fathom.union_depth([SQUARE], [SQUARE + 0.5, SQUARE + 0.75])])
def test_certificates(hit):
    proof = hit.certificate("p")
    found = fathom.check(proof)
    assert found.accepted and found.status == hit.status and "dimension=2" in found.verdict
    assert fathom.check(pickle.loads(pickle.dumps(hit)).certificate("p")) == found
    assert not fathom.check(proof.replace("plane", "plain", 1)).accepted


def test_many_pairs():
    hits = fathom.depths(SQUARE, SQUARE + np.array([[0.5, 0], [1, 0], [0, 2]])[:, None])
    assert hits.signed_depth.tolist() == [0.5, 0, -1] and hits.direction.tolist() == [[-1, 0], [-1, 0], [0, -1]]
    poses = np.array([[[1, 0, 0.5], [0, 1, 0]], [[1, 0, 3], [0, 1, 0]]])
    assert fathom.depths(SQUARE, SQUARE, poses_b=poses).signed_depth.tolist() == [0.5, -2]
    assert fathom.depths([(SQUARE, SQUARE), (SQUARE, CUBE)], errors="return").direction.shape == (2, 2)
    with pytest.raises(ValueError, match="pair 0: a body of the plane and one of space"):
        fathom.depths([(SQUARE, CUBE)])
    with pytest.raises(ValueError, match="all of the plane, or all of space"):
        _ = fathom.depths([(SQUARE, SQUARE), (CUBE, CUBE)]).direction


@pytest.mark.parametrize("body", [
    plane.polygon([(0, 0), ("1/3", 1)]), plane.circle("1/3"), plane.capsule(1, 2, "y"), plane.box((1, "1/7")), plane.halfplane((3, 4), 5),
    plane.box((1, 2)).with_margin(1), plane.box((1, 2)) + plane.capsule(1, 1), fathom.union([SQUARE, SQUARE + 5])])
def test_bodies_are_kept(body):
    again = pickle.loads(pickle.dumps(body))
    assert again.dimension == 2 and again.description == body.description and repr(again) == repr(body)
    ask = fathom.union_depth if body.pieces else fathom.depth
    answers = [ask(one, SQUARE * 3 + 1).exact.signed_depth for one in (body, again)]
    assert answers[0] == answers[1]


def test_properties_of_bodies():
    assert fathom.Body(SQUARE).points.shape == (4, 2) and fathom.Body(SQUARE).extent.tolist() == [1, 1]
    assert fathom.Body([(0, 0), ("1/3", 0)]).points == [(0, 0), (Fraction(1, 3), 0)]
    assert [fathom.Body(points).is_flat for points in (SQUARE, SQUARE[:2], SQUARE[[0, 2, 2]])] == [False, True, True]
    assert not plane.circle(1).is_flat and not fathom.union([SQUARE, SQUARE[:2]]).is_flat and fathom.union([SQUARE[:2]]).is_flat
    assert fathom.union([SQUARE]).pieces[0].shape == (4, 2)
    assert CUBE.dimension == 3 and fathom.Body(SQUARE).description == {"vertices": [[0, 0], [1, 0], [1, 1], [0, 1]]}


def test_widths_and_rays():
    wide = fathom.width([(0, 0), (3, 0), (3, 4)])
    assert wide.squared == Fraction(144, 25) and fathom.width(plane.circle("1/3")).width == 2 / 3
    assert fathom.width(SQUARE, pose=plane.pose(1)).squared == 1
    hit = fathom.ray(SQUARE, SQUARE + [0.75, 0.25], (2, 0))
    assert hit.factor == Fraction(7, 8) and hit.translation == (Fraction(7, 4), 0) and hit.direction.tolist() == [1, 0]
    assert hit.contact["kind"] == "edge-edge" and [len(p) for p in hit.witness] == [2, 2]
    grown = fathom.growth(SQUARE, SQUARE + [3, 0])
    assert grown.growth == 3 and grown.centers == ((Fraction(1, 2), Fraction(1, 2)), (Fraction(7, 2), Fraction(1, 2)))
    assert grown.normal == (-1, 0) and sum(grown.weights[1].values()) == 1 and set(grown.weights[1]) <= {0, 3}
    assert fathom.growth(SQUARE, SQUARE + [3, 0], (0.5, 0), (3, 0.5)).growth == 5
    short = fathom.metric(SQUARE, SQUARE + [0.75, 0.25], [(1, 0), (0, 1), (-1, 0), (0, -1)])
    assert short.depth == Fraction(1, 4) and short.direction.tolist() == [-1, 0] and short.optima[0]["translation"] == (Fraction(-1, 4), 0)
    near = fathom.approx(SQUARE, SQUARE + [0.75, 0.25], "1/10")
    assert near.low <= 0.25 <= near.high <= 1.1 * near.low and len(near.translation) == 2


@pytest.mark.parametrize("ask, sentence", [
    (lambda: fathom.ray(SQUARE, SQUARE, (1, 0, 0)), "expected two numbers"), (lambda: fathom.ray(CUBE, CUBE, (1, 0)), "expected three numbers"),
    (lambda: fathom.ray(SQUARE, plane.circle(1), (1, 0)), "expected"), (lambda: fathom.growth(SQUARE, SQUARE, (0, 0, 0)), "expected two numbers"),
    (lambda: fathom.metric(CUBE, CUBE, SQUARE * 2 - 1), "all of the plane, or all of space"),
    (lambda: fathom.metric(SQUARE, SQUARE, SQUARE), "O on its boundary"), (lambda: fathom.metric(SQUARE, SQUARE, SQUARE[:2]), "lie on one line"),
    (lambda: fathom.width(plane.halfplane((1, 0), 1)), "no width"), (lambda: fathom.approx(SQUARE, SQUARE, 0), "delta")])
def test_rays_that_are_refused(ask, sentence):
    with pytest.raises(ValueError, match=sentence):
        ask()


@pytest.mark.parametrize("ask", [fathom.depth, fathom.distance, fathom.union_depth, fathom.overlap, fathom.growth,
                                 lambda a, b: fathom.closer_than(a, b, 1), lambda a, b: fathom.approx(a, b, 1)])
def test_one_of_each(ask):
    for a, b in [(SQUARE, CUBE), (CUBE, SQUARE)]:
        with pytest.raises(ValueError, match=MIXED):
            ask(a, b)


@pytest.mark.parametrize("name, ask", [
    ("study", lambda: fathom.study(SQUARE, SQUARE)),
    ("Prepared", lambda: fathom.Prepared(SQUARE)),
    ("solid", lambda: fathom.solid(SQUARE)),
    ("coverage", lambda: fathom.coverage(SQUARE, SQUARE)),
])
def test_what_takes_none(name, ask):
    with pytest.raises(ValueError, match=f"{name} takes bodies of space, found a body of the plane"):
        ask()


class Triangulated:
    vertices, faces = SQUARE, [(0, 1, 2)]


@pytest.mark.parametrize("body, sentence", [
    ([(0, 0), (0, 0, 0)], "a: point 1: expected two numbers, found"),
    ([(0, 0, 0), (0, 0)], "a: point 1: expected three numbers, found"),
    ([(0, "x")], "a: point 0: expected a number, found 'x'"),
    (np.array([[0, np.nan]]), "a: expected finite coordinates, found others in row 0"),
    (np.zeros((0, 2)), "a: expected at least one point, found none"),
    (np.zeros((4, 1)), "a: expected an array of n x 3 or n x 2 coordinates, found one of 4 x 1"),
    (Triangulated, "a: expected no faces beside points of two coordinates"),
])
def test_bad_bodies(body, sentence):
    with pytest.raises(ValueError) as fault:
        fathom.depth(body, SQUARE)
    assert sentence in str(fault.value)


def test_bad_shapes():
    for make, sentence in [(lambda: plane.circle(-1), "radius"), (lambda: plane.box((1, 0)), "the half lengths of a box are > 0"),
                           (lambda: plane.box((1, 1, 1)), "expected two numbers"), (lambda: plane.halfplane((0, 0), 1), "normal"),
                           (lambda: plane.polygon(np.eye(3)), "expected points of two coordinates"),
                           (lambda: plane.capsule(1, 1, "z"), "z"),
                           (lambda: plane.box((1, 1)) + CUBE, "all of the plane, or all of space")]:
        with pytest.raises(ValueError, match=sentence):
            make()



@pytest.mark.parametrize("seed", range(40))
def test_patches_and_rates_as_of_prisms(seed):
    a, b = polygons(seed)
    flat, thick = fathom.depth(a, b), fathom.depth(prism(a, 64), prism(b, 64))
    ways = {patch.normal[:2]: {(*corner.b[:2],) for corner in patch.corners} for patch in thick.patches}
    assert {patch.normal: {corner.b for corner in patch.corners} for patch in flat.patches} == ways
    assert all(patch.rank < 2 and patch.a_f64.shape == (len(patch.corners), 2) and len(patch.centroid[0]) == 2 for patch in flat.patches)
    rate, space = flat.derivative((1, 2), -1, v_b=(0, 1), w_b="1/3"), thick.derivative((1, 2, 0), (0, 0, -1), (0, 1, 0), (0, 0, "1/3"))
    assert (rate.sign, rate.root) == (space.sign, space.root) and len(rate.normal) == 2
    assert flat.derivative().sign == 0


def test_gradients():
    hit = fathom.depth([(0, -1), (3, 3), (-3, 3)], SQUARE * 9 - 9 + [4, 0])
    assert hit.smooth and hit.gradient.v.tolist() == [0, -1] and hit.gradient.w == 0 and hit.gradient.point == (0, -1)
    assert hit.derivative((0, 2), 9).value == -2
    with pytest.raises(ValueError, match="v: expected two numbers"):
        hit.derivative((0, 2, 1))
    with pytest.raises(TypeError, match="w: "):
        hit.derivative((0, 2), (0, 0, 1))
    touching = fathom.depth(SQUARE, SQUARE + [1, 1])
    assert touching.optimal_cone.rays == ((-1, 0), (0, -1)) and touching.kinks == ("cone",)


def test_judge():
    there = SQUARE + [0.75, 0.25]
    right = fathom.judge(SQUARE, there, overlap=True, depth=0.25, direction=(-1, 0), witness=((1, 0.5), (0.75, 0.5)))
    assert right.passed and right.depth_squared == Fraction(1, 16)
    assert fathom.judge(SQUARE, there, overlap=True, depth=0.75, direction=(0, -1)).verdict == "too-deep"
    assert fathom.judge(SQUARE, there, overlap=False).verdict == "false-separation"
    assert fathom.judge(SQUARE, SQUARE + 3, overlap=False, distance=1.0).verdict == "too-near"
    rate = fathom.judge(SQUARE, there, overlap=True, depth=0.25, derivative=1.0, v=(1, 0), w=0)
    assert rate.passed and rate.derivative["squared"] == 1
    assert fathom.judge(SQUARE, there, overlap=True, derivative=-1.0, v=(1, 0)).verdict == "wrong-derivative"
    discs = fathom.judge(plane.circle(1), plane.circle(1), overlap=True, depth=2.0, direction=(0, 1))
    assert discs.passed and fathom.judge(fathom.union([SQUARE]), fathom.union([there]), overlap=True, depth=0.25, direction=(-1, 0)).passed
    contacts = [((0.75, 0.25), 0.25), ((1, 1), 0.25)]
    assert fathom.judge(SQUARE, there, overlap=True, depth=0.25, direction=(-1, 0), contacts=contacts, manifold=(2, 0)).passed
    for field in ("direction", "witness"):
        with pytest.raises(ValueError, match=f"{field}: expected two numbers"):
            fathom.judge(SQUARE, there, overlap=True, depth=0.25, **{field: (1, 0, 0) if field == "direction" else ((0, 0, 0), (0, 0, 0))})
    with pytest.raises(ValueError, match=MIXED):
        fathom.judge(SQUARE, CUBE, overlap=True)
