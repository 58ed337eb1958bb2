# SPDX-License-Identifier: GPL-3.0-or-later
"""Unions of convex pieces: against the program, against what is known, and what is refused."""
import itertools
import json
import os
import pickle
import subprocess
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction

import numpy as np
import pytest

import fathom

CUBE = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
BLOCK = [CUBE * (2, 4, 4), CUBE * (2, 4, 4) + (4, 0, 0), CUBE * (2, 4, 1) + (2, 0, 0)]  # in the shape of a U
BAR = [CUBE * (2, 2, 4) + (1, 1, 2)]  # as wide as its slot
FATHOM = os.environ.get("FATHOM_EXECUTABLE")
NAN = float("nan")


def ball(rng, points):
    p = rng.normal(size=(points, 3))
    return p / np.linalg.norm(p, axis=1)[:, None]


def cluster(pieces, points, seed=1):
    rng = np.random.default_rng(seed)
    return [ball(rng, points) + rng.normal(size=3) for _ in range(pieces)]


def exact(texts):
    return tuple(map(Fraction, texts))


def contact(said):
    return {"kind": said["kind"], "a": tuple(said["a"]), "b": tuple(said["b"])}


def same_as_said(hit, said):
    """The answer is what the program prints as JSON."""
    assert (hit.status, hit.complete, hit.squared) == (said["status"], True, Fraction(said["depth"]["squared"]))
    assert hit.low_squared == hit.high_squared == hit.squared
    assert [(o.exact, o.clearance) for o in hit.optima] == [(exact(o["translation"]), o["clearance"]) for o in said["optima"]]
    for optimum, told in zip(hit.optima, said["optima"]):
        assert optimum.translation.tolist() == list(map(float, optimum.exact))
        assert [(c.pieces, c.normal, c.contact) for c in optimum.contacts] == [
            (tuple(c["pieces"]), tuple(map(int, c["direction"])), contact(c["contact"])) for c in told["contacts"]]
    bounds = hit.bounds
    assert (bounds.deepest_pair_squared, bounds.pieces) == (Fraction(said["deepest_pair"]["depth"]["squared"]),
                                                            tuple(said["deepest_pair"]["pieces"]))
    assert bounds.hulls_squared == Fraction(said["hulls"]["squared"])
    assert hit.counters == said["counters"]
    assert (hit.apart is None) == (said["apart"] is None)
    if hit.apart:
        told = said["apart"]
        assert (hit.apart.squared, hit.apart.pieces, hit.apart.contact) == (
            Fraction(told["distance"]["squared"]), tuple(told["pieces"]), contact(told["contact"]))
        assert hit.apart.witness == (exact(told["witness"]["a"]), exact(told["witness"]["b"]))
        assert hit.translation.tolist() == hit.apart.translation.tolist() == [float(x) for x in exact(told["translation"])]


def test_the_program_says_the_same(tmp_path):
    if not FATHOM:
        pytest.skip("FATHOM_EXECUTABLE is not set")
    made = [subprocess.run([FATHOM, "cases", *what, "--unions"], capture_output=True, text=True, check=True).stdout
            for what in (["--family", "all", "--count", "90", "--size", "4"], ["--catalogue"])]
    (tmp_path / "unions.jsonl").write_text("".join(made))
    command = [FATHOM, "depth", "--json", "--embed-certificate", str(tmp_path / "unions.jsonl")]
    said = [json.loads(line) for line in subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()]
    cases = list(fathom.cases(tmp_path / "unions.jsonl"))
    assert len(cases) == len(said) > 100
    statuses = set()
    for case, told in zip(cases, said):
        hit = fathom.union_depth(case.a, case.b)
        same_as_said(hit, told)
        assert hit.certificate(case.id) == told["certificate"], case.id
        statuses.add(hit.status)
        assert fathom.union_depth(case.a, case.b, bounds=False).bounds is None
    assert statuses == {"penetrating", "touching", "disjoint"}


def test_floats_are_correctly_rounded():
    hit = fathom.union_depth(fathom.read_pieces("tests/data/key.obj"), fathom.read_pieces("tests/data/comb.obj"))
    assert hit.squared == Fraction(5, 8) and hit.low < hit.high and hit.depth in (hit.low, hit.high)
    assert Fraction(hit.low) ** 2 < hit.squared < Fraction(hit.high) ** 2
    middle = (Fraction(hit.low) + Fraction(hit.high)) / 2
    assert hit.depth == (hit.low if hit.squared < middle**2 else hit.high)
    touch = hit.optima[0].contacts[0]
    assert (touch.direction @ touch.direction) == pytest.approx(1) and np.allclose(np.cross(touch.direction, touch.normal), 0)


def test_forms_of_a_union():
    class Mesh:  # as trimesh has it
        def __init__(self, vertices):
            self.vertices = vertices

    forms = [BLOCK, tuple(BLOCK), iter(BLOCK), np.array(BLOCK), np.array(BLOCK, np.float32), [p.tolist() for p in BLOCK],
             np.array(BLOCK).tolist(), [Mesh(p) for p in BLOCK], [fathom.Body(p) for p in BLOCK], fathom.union(BLOCK),
             fathom.union(fathom.union(BLOCK)), [[[Fraction(x) for x in q] for q in p] for p in BLOCK],
             [[[str(x) for x in q] for q in p] for p in BLOCK], [BLOCK[0], Mesh(BLOCK[1]), fathom.Body(BLOCK[2])],
             np.array(BLOCK, dtype=object), BLOCK + BLOCK[:1]]
    for form in forms:
        hit = fathom.union_depth(BAR, form)
        assert (hit.depth, [o.exact for o in hit.optima], hit.optima[0].clearance) == (1.0, [(1, 0, 0)], False)
    for one in (BAR[0], BAR[0].tolist(), Mesh(BAR[0]), fathom.Body(BAR[0]), tuple(map(tuple, BAR[0])),
                [[str(x) for x in p] for p in BAR[0]]):
        assert fathom.union_depth(one, BLOCK).depth == 1.0


def test_exact_numbers_stay_exact():
    third = [[tuple(Fraction(int(x), 3) for x in p) for p in CUBE]]
    hit = fathom.union_depth(third, [CUBE, CUBE], pose_b="xyz=1/7,1/9,1/9")
    assert hit.squared == Fraction(1, 3 * 7) ** 2 * 16 and hit.optima[0].exact == (Fraction(1, 7) - Fraction(1, 3), 0, 0)
    assert fathom.union(third).pieces[0][1] == (0, 0, Fraction(1, 3))


def test_one_piece_is_the_convex_body():
    rng = np.random.default_rng(5)
    for _ in range(20):
        a, b = rng.normal(size=(2, 12, 3))
        union, convex = fathom.union_depth([a], [b]), fathom.depth(a, b)
        assert (union.status, union.depth, union.distance) == (convex.status, convex.depth, convex.distance)
        assert sorted(o.exact for o in union.optima) == sorted(o.exact for o in convex.optima)
        assert all(optimum.clearance for optimum in union.optima)


def test_cut_bodies_and_the_deepest_pair():
    halves = [CUBE * (0.5, 1, 1), CUBE * (0.5, 1, 1) + (0.5, 0, 0)]
    other = CUBE * 3 - 0.75
    assert fathom.union_depth(halves, [other]).squared == fathom.depth(CUBE, other).exact.depth_squared
    a, b = cluster(4, 8), cluster(3, 8, 2)
    hit, pairs = fathom.union_depth(a, b), {(i, j): fathom.depth(p, q).exact.depth_squared for i, p in enumerate(a) for j,
                                            q in enumerate(b)}
    assert hit.bounds.deepest_pair_squared == max(pairs.values()) == pairs[hit.bounds.pieces]
    assert hit.bounds.hulls_squared == fathom.depth(np.concatenate(a), np.concatenate(b)).exact.depth_squared
    assert pairs[hit.bounds.pieces] <= hit.squared <= hit.bounds.hulls_squared
    for optimum in hit.optima:
        moved = fathom.union_depth(a, b, pose_a=fathom.pose(translation=optimum.exact))
        assert moved.status == "touching" and [c.pieces for c in moved.optima[0].contacts] == [c.pieces for c in optimum.contacts]


def test_poses_and_bodies():
    block = fathom.union(BLOCK)
    assert repr(block) == "<fathom.Body, a union of 3 pieces>" and block.points is None and not block.is_shape and not block.is_flat
    assert block.extent.tolist() == [6, 4, 4] and all((got == given).all() for got, given in zip(block.pieces, BLOCK))
    assert fathom.Body(CUBE).pieces is None and fathom.sphere(1).pieces is None
    turn = fathom.pose((1, 0, 0, 1), ("1/3", 0, 0))
    hit = fathom.union_depth(BAR, block, pose_a=turn, pose_b=turn)
    assert hit.depth == 1.0 and fathom.union_depth(fathom.union(BAR).moved(turn),
                                                   block.moved(turn)).optima[0].exact == hit.optima[0].exact == (0, 1, 0)
    assert fathom.union_depth(BAR, BLOCK, pose_b=np.diag([2, 2, 2, 1])).notes == ["pose_b: det 8, not a rotation: the body is scaled by 2"]
    [note] = fathom.union_depth(BAR, [p * 1000 for p in BLOCK]).notes
    assert "same unit" in note
    assert fathom.union([CUBE * (1, 1, 0)]).is_flat and not fathom.union([CUBE * (1, 1, 0), CUBE]).is_flat
    scaled = fathom.read_pieces("tests/data/decompositions/mug")
    assert len(scaled.pieces) > 1 and fathom.union_depth(scaled, fathom.read_pieces("tests/data/decompositions/spanner.obj")).depth == 0.8


def test_statuses_and_text():
    touch, apart = fathom.union_depth(BAR, [CUBE + (3, 1, 2)]), fathom.union_depth(BAR, [CUBE + (7, 1, 2), CUBE + (5, 1, 2)])
    assert (touch.status, touch.depth, touch.distance, touch.translation.tolist()) == ("touching", 0.0, 0.0, [0, 0, 0])
    assert len(touch.optima) == 1 and touch.optima[0].contacts[0].contact["kind"] == "facet-facet"
    assert (apart.status, apart.depth, apart.distance, apart.translation.tolist(),
            apart.apart.pieces) == ("disjoint", 0.0, 2.0, [2, 0, 0], (0, 1))
    assert apart.optima == [] and apart.squared == 0
    assert [repr(x) for x in (touch, apart)] == ["UnionDepth(touching, depth=0.0)", "UnionDepth(disjoint, distance=2.0)"]
    for hit in (touch, apart, fathom.union_depth(BAR, BLOCK)):
        checked = fathom.check(hit.certificate("name"))
        assert checked.accepted and checked.status == hit.status and checked.verdict.endswith(" name")
    proof = fathom.union_depth(BAR, BLOCK).certificate()
    assert proof.startswith("fathom-certificate 3\n") and not fathom.check(proof.replace("depth 1", "depth 2")).accepted
    optimum = fathom.union_depth(BAR, BLOCK).optima[0]
    assert pickle.loads(pickle.dumps(optimum)).exact == optimum.exact


@pytest.mark.parametrize("a, sentence", [
    ([], "a: expected at least one convex piece, found none"),
    (np.zeros((0, 8, 3)), "a: expected at least one convex piece, found none"),
    ([CUBE, np.zeros((0, 3))], "a: piece 1: expected at least one point, found none"),
    ([CUBE, []], "a: piece 1: expected at least one point, found none"),
    ([CUBE, np.zeros((4, 4))], "a: piece 1: expected an array of n x 3 or n x 2 coordinates, found one of 4 x 4"),
    ([CUBE, CUBE[0]], "a: piece 1: expected an array of n x 3 or n x 2 coordinates, found one of 3"),
    ([[CUBE]], "a: piece 0: expected a convex body, found a list of bodies"),
    (np.zeros((2, 4, 4)), "a: piece 0: expected an array of n x 3 or n x 2 coordinates, found one of 4 x 4"),
    ([CUBE, np.where(CUBE > 0.5, NAN, CUBE)], "a: piece 1: expected finite coordinates, found others in row 1"),
    ([CUBE, [(0, 0, 0), (0, 0, "1/0")]], "a: piece 1: point 1: expected a number, found '1/0'"),
    ([CUBE, CUBE * (1, 1, 0)], "piece 1 of A is flat"),
    ([CUBE, CUBE[:3]], "piece 1 of A is flat"),
    ([CUBE, fathom.sphere(1)], "a: piece 1: expected a polytope, found another shape"),
    ([CUBE, fathom.box((1, 1, 1)).with_margin(1)], "a: piece 1: expected a polytope, found another shape"),
    (fathom.capsule(1, 1), "a: expected a polytope, found another shape"),
    ([fathom.union(BLOCK)], "a: piece 0: expected a convex body, found a union of pieces"),
])
def test_pieces_that_are_none(a, sentence):
    with pytest.raises(ValueError) as fault:
        fathom.union_depth(a, BLOCK)
    assert sentence in str(fault.value)
    with pytest.raises(ValueError) as fault:
        fathom.union_depth(BLOCK, a)
    assert sentence.replace("a: ", "b: ", 1).replace("of A", "of B") in str(fault.value)


@pytest.mark.parametrize("call, fault, sentence", [
    (lambda: fathom.union_depth("key.obj", BLOCK), TypeError, "a: expected convex pieces, or one convex body"),
    (lambda: fathom.union_depth(BLOCK, None), TypeError, "b: expected convex pieces, or one convex body"),
    (lambda: fathom.union_depth(["key.obj"], BLOCK), TypeError, "a: piece 0: expected an array of points"),
    (lambda: fathom.union_depth([CUBE, 7], BLOCK), TypeError, "a: piece 1: expected an array of points"),
    (lambda: fathom.union_depth(BAR, BLOCK, stop=7), TypeError, "stop: expected a function, found 7"),
    (lambda: fathom.union_depth(BAR, BLOCK, pose_a="xyz=1"), ValueError, "a: pose: "),
    (lambda: fathom.union_depth(BAR, BLOCK, pose_b=np.zeros((3, 4))), ValueError, "piece 0 of B is flat"),
    (lambda: fathom.union([]), ValueError, "pieces: expected at least one convex piece"),
    (lambda: fathom.union([CUBE, fathom.sphere(1)]), ValueError, "pieces: piece 1: expected a polytope"),
    (lambda: fathom.read_pieces("tests/data/none.obj"), ValueError, "none.obj"),
    (lambda: fathom.read_pieces("tests/data/key.obj", "some"), ValueError, "expected decimals"),
])
def test_arguments(call, fault, sentence):
    with pytest.raises(fault) as raised:
        call()
    assert sentence in str(raised.value)


@pytest.mark.parametrize("bodies", [BLOCK, [fathom.union(BLOCK)], [fathom.sphere(1), CUBE], [CUBE.tolist()], BLOCK[:1] * 3])
def test_a_list_of_bodies_is_no_convex_body(bodies):
    with pytest.raises(ValueError, match="a: expected a convex body, found a list of bodies: union_depth takes such a list"):
        fathom.depth(bodies, CUBE)


UNION = fathom.union(BLOCK)


@pytest.mark.parametrize("call, why", [
    (lambda: fathom.depth(UNION, CUBE), "union_depth takes those"), (lambda: fathom.distance(CUBE, UNION), "union_depth takes those"),
    (lambda: fathom.depths([(CUBE, UNION)]), "union_depth takes those"), (lambda: fathom.width(UNION), "its width is that of the hull"),
    (lambda: fathom.ray(UNION, CUBE, (1, 0, 0)), "how far it must move in one direction is not answered about those"),
    (lambda: fathom.growth(UNION, CUBE), "by which factor it must grow is not answered about those"),
    (lambda: fathom.metric(CUBE, UNION, CUBE - 0.5), "union_depth answers about those, in Euclid's norm"),
    (lambda: fathom.metric(CUBE, CUBE, UNION), "the unit ball of a norm is convex"),
    (lambda: fathom.approx(UNION, CUBE), "union_depth answers about those, exactly"),
    (lambda: fathom.study(UNION, CUBE), "the coincidences of a study are those of two convex bodies"),
    (lambda: fathom.convexity(UNION), ""), (lambda: UNION.with_margin(1), ""), (lambda: UNION + fathom.sphere(1), ""),
    (lambda: fathom.sphere(1) + UNION, ""), (lambda: fathom.Body(UNION), ""),
])
def test_who_takes_convex_bodies_says_so(call, why):
    with pytest.raises(ValueError, match="expected a convex body, found a union of pieces: " + why):
        call()


def test_judgements_of_unions():
    slot = fathom.union([fathom.box((1, 1, 1)), CUBE])
    found = fathom.judge(fathom.box((1, 1, 1)), slot, overlap=False, distance=2.0, pose_a="xyz=4,0,0")
    assert found.passed and found.separating_distance is None and found.hulls_squared is None
    with pytest.raises(ValueError, match="a shape that is no polytope is no union of pieces"):
        fathom.judge(slot, fathom.sphere(1), overlap=True)


class Tent:  # a tetrahedron with one face pushed in
    vertices = np.array([[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4], [1, 1, 1]], float)
    faces = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 4], [2, 3, 4], [3, 1, 4]])


def test_solids_tell_what_touches_by_their_meshes():
    tent, box = fathom.solid(Tent), [CUBE * (0.25, 0.25, 0.5) + (1, 1, -0.375)]
    base, pose = [{"kind": "face", "ids": (0,)}], "xyz=1,2,3 rpy=10,20,30deg"
    for hit in (fathom.union_depth(tent, box), fathom.union_depth(pickle.loads(pickle.dumps(tent)), box),
                fathom.union_depth(tent, box, pose_a=pose, pose_b=pose)):
        assert hit.squared == Fraction(1, 64)
        assert [met.mesh_a for met in hit.optima[0].contacts] == [base] * len(hit.optima[0].contacts)
        assert [met.mesh_b for met in hit.optima[0].contacts] == [[]] * len(hit.optima[0].contacts)
        assert {(str(patch.mesh_a), str(patch.mesh_b)) for patch in hit.patches} == {(str(base), "[]")}
    assert fathom.union_depth(box, tent, pose_b="xyz=5,0,0").apart.mesh_b == [{"kind": "face", "ids": (2,)}]


def test_meshes_that_are_not_convex():
    with pytest.warns(fathom.NotConvexWarning, match="^piece 1 of B is not convex, its hull is 33 % larger") as told:
        fathom.union_depth(BAR, [CUBE, Tent])
    assert len(told) == 1 and told[0].filename == __file__
    with pytest.warns(fathom.NotConvexWarning, match="^A is not convex"):
        fathom.union_depth(Tent, BAR)
    with pytest.warns(fathom.NotConvexWarning, match="^piece 0 of the body is not convex"):
        fathom.union([Tent])


# ---- long work ----

LONG = cluster(40, 60)


def test_a_search_can_be_stopped():
    asked = []
    hit = fathom.union_depth(LONG, LONG, stop=lambda: len(asked) > 9 or asked.append(1))
    assert len(asked) == 10 and not hit.complete and hit.status == "penetrating"
    assert hit.depth is None and hit.squared is None and 0 < hit.low < hit.high and hit.bounds.deepest_pair_squared <= hit.low_squared
    assert hit.high_squared <= hit.bounds.hulls_squared and sum(x * x for x in hit.optima[0].exact) == hit.high_squared
    assert "between" in repr(hit)
    with pytest.raises(ValueError, match="no certificate"):
        hit.certificate()


def test_stopped_before_anything_is_known():
    rng = np.random.default_rng(1)
    a, b = [ball(rng, 60000)], [ball(rng, 60000)]
    with pytest.raises(RuntimeError, match="stopped before anything was known"):
        fathom.union_depth(a, b, stop=lambda: True)


def test_what_stop_raises_comes_out():
    def stop():
        raise LookupError("no clock")

    with pytest.raises(LookupError, match="no clock"):
        fathom.union_depth(LONG, LONG, stop=stop)


def test_threads():
    """Threads share bodies."""
    a, b = fathom.union(cluster(6, 10)), fathom.union(cluster(6, 10, 2))
    alone = fathom.union_depth(a, b)
    with ThreadPoolExecutor(4) as pool:
        found = list(pool.map(lambda _: fathom.union_depth(a, b), range(16)))
    assert all(hit.squared == alone.squared and [o.exact for o in hit.optima] == [o.exact for o in alone.optima] for hit in found)


def test_unions_have_what_every_answer_has():
    blocks, cube = fathom.union([fathom.box((1, 1, 1)), fathom.box((1, 1, 1)).moved("xyz=3,0,0")]), fathom.box((1, 1, 1))
    hit, touching, apart = (fathom.union_depth(blocks, cube, pose_b=f"xyz={x},0,0") for x in ("-3/2", "-2", "25/4"))
    assert (hit.signed_depth, hit.distance, hit.direction.tolist()) == (0.5, 0.0, [1, 0, 0])
    assert hit.exact.signed_depth == fathom.Root(Fraction(1, 2), Fraction(0)) and hit.exact.translation == (Fraction(1, 2), 0, 0)
    assert (touching.signed_depth, touching.distance, touching.direction) == (0.0, 0.0, None)
    assert (apart.signed_depth, apart.distance, apart.direction.tolist()) == (-1.25, 1.25, [-1, 0, 0])
    assert (apart.witness[1] - apart.witness[0]).tolist() == apart.translation.tolist() == [1.25, 0, 0]
