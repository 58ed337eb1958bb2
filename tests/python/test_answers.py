# SPDX-License-Identifier: GPL-3.0-or-later
"""Answers: against values known by construction, against each other, and against the program."""
import copy
import decimal
import json
import math
import os
import pickle
import subprocess
from fractions import Fraction

import numpy as np
import pytest

import fathom

CUBE = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
FATHOM = os.environ.get("FATHOM_EXECUTABLE")


def test_forms_of_a_body():
    class Mesh:  # as trimesh has it
        vertices = CUBE + [0.5, 0, 0]

    other = CUBE + [0.5, 0, 0]
    forms = [other, other.astype(np.float32), np.asfortranarray(other), other.tolist(), Mesh(), fathom.Body(other), other[::-1][::-1],
             [[Fraction(x) for x in p] for p in other], [[str(x) for x in p] for p in other],
             [[decimal.Decimal(x) for x in p] for p in other],
             np.array(other, dtype=object), (2 * other).astype(int) * 0.5]
    for form in forms:
        hit = fathom.depth(CUBE, form)
        assert (hit.status, hit.depth, hit.exact.depth_squared) == ("penetrating", 0.5, Fraction(1, 4))


def test_integers_are_exact():
    big = 2**70 + 1
    assert fathom.distance([(0, 0, 0)], [(big, 0, 0)]).exact.distance_squared == big**2
    assert fathom.distance([(0, 0, 0)], np.array([[2**53 + 1, 0, 0]])).exact.distance_squared == (2**53 + 1) ** 2


def test_arrays_are_not_kept():
    cube = CUBE.copy()
    hit = fathom.depth(cube, CUBE + [0.5, 0, 0])
    cube += 7
    assert fathom.check(hit.certificate()).accepted
    assert hit.exact.witness[0][0] <= 1


@pytest.mark.parametrize("method", ["automatic", "exact", "naive", "certificate"])
def test_methods_agree(method):
    hit = fathom.depth(CUBE, CUBE * 2 + [0.25, 0.25, 0.75], method=method)
    assert hit.exact.depth_squared == Fraction(1, 16)
    assert hit.optima_count == len(hit.optima) == 1
    assert hit.optima[0].contact == {"kind": "facet-facet", "a": (1, 3, 5, 7), "b": (0, 2, 4, 6)}


def test_optima_are_all_there():
    hit = fathom.depth(CUBE, CUBE)
    assert sorted(o.normal for o in hit.optima) == sorted([(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)])
    few = fathom.depth(CUBE, CUBE, optima=2)
    assert (len(few.optima), few.optima_count) == (2, 6)
    for optimum in hit.optima:
        assert fathom.depth(CUBE + optimum.translation, CUBE).status == "touching"


def test_statuses():
    touch = fathom.depth(CUBE, CUBE + [1, 0, 0])
    assert (touch.status, touch.depth, touch.distance, touch.signed_depth) == ("touching", 0.0, 0.0, 0.0)
    assert touch.optima == [] and touch.translation.tolist() == [0, 0, 0]
    apart = fathom.depth(CUBE, CUBE + [2, 0, 0])
    assert (apart.status, apart.depth, apart.distance, apart.signed_depth) == ("disjoint", 0.0, 1.0, -1.0)
    a, b = apart.witness
    assert (b - a).tolist() == apart.translation.tolist() == [1, 0, 0]


def test_floats_are_correctly_rounded():
    rng = np.random.default_rng(1)
    for _ in range(50):
        a, b = rng.normal(size=(2, 12, 3))
        hit = fathom.depth(a, b)
        value = hit.exact.signed_depth
        assert value.rational == 0
        nearest = abs(hit.signed_depth)
        below, above = Fraction(math.nextafter(nearest, 0)), Fraction(math.nextafter(nearest, math.inf))
        middle_low, middle_high = (below + Fraction(nearest)) / 2, (above + Fraction(nearest)) / 2
        assert middle_low**2 <= abs(value.root) <= middle_high**2
        assert Fraction(hit.low) ** 2 * (1 if hit.low > 0 else -1) <= value.root <= Fraction(hit.high) ** 2 * (1 if hit.high > 0 else -1)
        n = hit.exact.normal
        square = sum(c * c for c in n)
        for component, c in zip(hit.direction, n):
            low, high = (Fraction(math.nextafter(abs(component), to)) for to in (0, math.inf))
            assert ((low + Fraction(abs(component))) / 2) ** 2 <= Fraction(c * c, square) <= ((high + Fraction(abs(component))) / 2) ** 2
        for got, exact in zip(hit.translation, hit.exact.translation):
            assert got == float(exact)  # Python rounds Fractions correctly


def test_poses_are_exact():
    turn = fathom.pose(quaternion=(1, 0, 0, 1), translation=("1/3", 0, 0))
    assert fathom.depth(CUBE, CUBE, pose_b=turn).exact.depth_squared == Fraction(1, 9)
    matrix = np.array([[0, -1, 0, 0.5], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1.0]])
    assert fathom.depth(CUBE, CUBE, pose_b=matrix).depth == fathom.depth(CUBE, CUBE @ matrix[:3, :3].T + matrix[:3, 3]).depth
    assert fathom.depth(CUBE, CUBE, pose_a=matrix.tolist()[:3], pose_b=matrix).depth == 1
    capsule = fathom.capsule(1, 2)
    assert fathom.depth(capsule, capsule, pose_b=fathom.pose((1, 1, 0, 0), (0, 0, 3))).exact.signed_depth == (1, 0)


def test_shapes():
    sphere = fathom.sphere("1/2")
    assert fathom.depth(sphere, sphere, pose_b=fathom.pose(translation=(1, 1, 0))).exact.signed_depth == (Fraction(1), Fraction(-2))
    rounded = fathom.box((1, 1, 1)).with_margin(Fraction(1, 10))
    hit = fathom.depth(rounded, rounded.moved(fathom.pose(translation=(2, 0, 0))))
    assert (hit.status, hit.depth, hit.exact.signed_depth.rational) == ("penetrating", 0.2, Fraction(1, 5))
    drum = fathom.depth(fathom.cylinder(1, 1), fathom.ellipsoid((1, 2, 3)), pose_b=fathom.pose((3, 1, 1, 0), (0.5, 0, 1.25)))
    low, high = drum.exact.bounds
    assert drum.status == "penetrating" and 0 < drum.low <= low <= high <= drum.high and drum.high - drum.low < 1e-11
    assert fathom.check(drum.certificate("drum")).accepted
    assert fathom.depth(fathom.halfspace((0, 0, 1), 0), fathom.cone(1, 1)).depth == 1
    assert (fathom.box((1, 1, 1)) + fathom.sphere(1)).is_shape and not fathom.box((1, 1, 1)).is_shape


def test_bounds_without_a_float():
    rough = fathom.depth(fathom.ellipsoid((1, 2, 3)), fathom.ellipsoid((3, 2, 1)), pose_b=fathom.pose((1, 2, 3, 4), (1, 0, 0)), bits=8)
    assert rough.signed_depth is None and rough.depth is None and rough.low < rough.high
    assert "between" in repr(rough)


def test_the_program_says_the_same():
    if not FATHOM:
        pytest.skip("FATHOM_EXECUTABLE is not set")
    cases = subprocess.run([FATHOM, "cases", "--family", "all", "--count", "150", "--size", "10"], capture_output=True, text=True,
                           check=True).stdout
    said = subprocess.run([FATHOM, "depth", "--json", "-"], input=cases, capture_output=True, text=True, check=True).stdout.splitlines()
    found = 0
    for case, answer in zip(map(json.loads, cases.splitlines()), map(json.loads, said)):
        hit = fathom.depth(case["a"]["vertices"], case["b"]["vertices"], pose_a=case["a"].get("pose"), pose_b=case["b"].get("pose"))
        if case.get("pose_rounding"):
            continue
        found += 1
        assert hit.status == answer["status"], case["id"]
        assert str(hit.exact.depth_squared) == answer["depth"]["squared"], case["id"]
        assert hit.low == float(answer["signed_depth"]["low"]) and hit.high == float(answer["signed_depth"]["high"]), case["id"]
    assert found > 100


def ways_out(translations):
    """As case files have them: (0, 0, 0) if there is none."""
    return sorted([str(x) for x in t] for t in translations) or [["0"] * 3]


@pytest.mark.parametrize(("name", "count"), [("real_cases", 63), ("report_cases", 141)])
def test_real_cases_have_the_stated_answers(name, count):
    path = f"tests/data/{name}.jsonl"
    with open(path, encoding="utf-8") as file:
        lines = list(map(json.loads, file))
    for line, case in zip(lines, fathom.cases(path), strict=True):
        stated = line.get("answer") or line["expected"]
        squared, value = stated["depth_squared"], stated.get("signed_depth")
        assert case.id == line["id"]
        if case.a.pieces or case.b.pieces:
            hit = fathom.union_depth(case.a, case.b)
            signed = -hit.apart.distance if hit.apart else hit.depth
            assert (hit.status, str(hit.squared), ways_out(o.exact for o in hit.optima)) == (
                stated["status"], squared, stated["translations"]), case.id
            assert value["low"] <= signed <= value["high"], case.id
            continue
        for method in ("automatic", "exact", "naive"):
            hit = fathom.depth(case.a, case.b, method=method, bits=40)
            assert hit.status == stated["status"], case.id
            if not case.a.is_shape and not case.b.is_shape:
                assert (str(hit.exact.depth_squared), ways_out(o.exact for o in hit.optima)) == (
                    squared, sorted(stated["translations"])), case.id
            if value:
                exact = value.get("exact")
                root = exact and (Fraction(exact["plus"]), exact["sign"] * Fraction(exact["root"]))
                assert (hit.low, hit.high, hit._answer.exact_value) == (value["low"], value["high"], root), case.id
    assert len(lines) == count


def test_impact():
    cube = fathom.box((1, 1, 1))
    fall = ("xyz=0,0,4", fathom.pose(quaternion=(1, "1/2", 0, 0)))
    found = fathom.impact(cube, cube, fall, bits=30, certificate=True)
    t0, t1 = found.times
    lowest = [(3 - 4 * t) * (4 + t * t) - (4 - t * t) - 4 * t for t in (t0, t1)]  # above B, by its angle, times 4 + t^2
    assert (found.status, found.normal, t1 - t0, lowest[0] > 0, lowest[1] <= 0) == ("contact", (0, 0, 1), Fraction(1, 2**30), True, True)
    assert found.pieces == [{"until": t0, "plane": "face of B", "directions": ((0, 0, 1),)}]
    assert found.points[0] == found.points[2] and sum(found.weights[0].values()) == 1
    assert found.certificate.startswith("fathom-certificate 6\n")
    assert fathom.impact(cube, cube, motion_b=("xyz=5,0,0", "xyz=3,0,0")).status == "apart"
    assert fathom.impact(cube, cube, motion_b=("xyz=1,0,0", "xyz=3,0,0")).beginning == ("penetrating", 1)
    with pytest.raises(ValueError, match="motion_a: expected two poses"):
        fathom.impact(cube, cube, "xyz=0,0,1")
    with pytest.raises(ValueError, match="found a matrix"):
        fathom.impact(cube, cube, (np.eye(4), None))
    with pytest.raises(ValueError, match="bits of a time"):
        fathom.impact(cube, cube, fall, bits=0)


def test_other_questions():
    box, other = fathom.box((1, 1, 1)), fathom.box((1, 1, 1)).moved(fathom.pose(translation=(1, 0, 0)))
    ray = fathom.ray(box, other, (-2, 0, 0))
    assert (ray.factor, ray.length, ray.contact["kind"]) == (Fraction(1, 2), 1.0, "facet-facet")
    growth = fathom.growth(box, other, center_b=(3, 0, "1/3"), pose_b="xyz=2,0,0")
    assert (growth.status, growth.growth, growth.normal) == ("disjoint", Fraction(3, 2), (-1, 0, 0))
    assert growth.centers == ((0, 0, 0), (3, 0, Fraction(1, 3)))
    assert all(sum(shares.values()) == 1 for shares in growth.weights)
    a, b = growth.witness
    assert growth.growth * a[0] == 3 + growth.growth * (b[0] - 3)
    same = fathom.growth(box, box)
    assert (same.growth, same.normal, same.weights, same.witness) == (0, None, None, None)
    with pytest.raises(ValueError, match="inside B - A, found it outside"):
        fathom.growth(box, box, center_a=(3, 0, 0))
    metric = fathom.metric(box, other, [(s, t, u) for s in (-1, 1) for t in (-1, 1) for u in (-1, 1)])
    assert (metric.depth, metric.status) == (1, "penetrating")
    near = fathom.approx(box, other, Fraction(1, 100))
    assert near.low_squared <= 1 <= near.high_squared <= near.low_squared * Fraction(101, 100) ** 2
    assert fathom.width(box).width == 2.0
    drum = fathom.width(fathom.cylinder(1, 3))
    assert drum.low <= 2 <= drum.high and drum.high - drum.low < 1e-3 and fathom.width([(0, 0, 0), (1, 0, 0)]).width == 0.0
    study = fathom.study(box, other)
    assert study.coincidences["coplanar_facets"]["count"] >= 4 and study.depth.depth == 1 and study.a["facets"] == 6
    judged = fathom.judge(box, other, overlap=True, depth=-1.0, direction=(-1, 0, 0), witness=((1, 0, 0), (0, 0, 0)), sign="negative")
    assert judged.passed and judged.separating_distance_squared == 1 and judged.error == 0.0


def test_judgements_of_contacts():
    corners = [((0.75, y, 0), 0.5) for y in (0, 1)]
    def judged(**measured):
        return fathom.judge(CUBE, CUBE + [0.5, 0, 0], overlap=True, depth=0.5, direction=(-1, 0, 0), contacts=corners, **measured)
    assert judged().passed and judged().extent_missed is None
    beside = judged(patch_slack="1/100")
    assert beside.passed and (beside.extent_missed, beside.extent_missed_squared, beside.extent_covered) == (1.0, 1, 0.0)


def test_judgements_of_derivatives():
    def judged(rate, **moving):
        return fathom.judge(CUBE, CUBE + [0.5, 0, 0], overlap=True, depth=0.5, derivative=rate, **moving)
    assert judged(2.0, v=(3, 0, 0), v_b=(1, 0, 0)).passed and judged(0.0, w=(0, 0, 1)).passed
    wrong = judged(0.0, v=("1/3", 0, 0))
    assert wrong.findings == ["wrong-derivative"] and wrong.derivative["squared"] == Fraction(1, 9) and wrong.derivative["kinks"] == ["extended"]
    assert judged(math.nan, v=(1, 0, 0)).verdict == "nan" and fathom.judge(CUBE, CUBE, overlap=True).derivative is None


def test_studies_and_judgements_of_shapes():
    ball, cylinder = fathom.sphere(1), fathom.cylinder(1, 2)
    study = fathom.study(ball, cylinder)
    assert study.depth.low <= 2 <= study.depth.high and {"concentric", "equal_radii"} <= set(study.names) and study.b["discs"] == 2
    judged = fathom.judge(ball, cylinder, overlap=True, depth=2.0, direction=(1, 0, 0))
    assert judged.passed and judged.status == "penetrating" and judged.depth_squared is None
    assert judged.signed_depth[0] <= 2 <= judged.signed_depth[1] and judged.separating_distance[0] <= 2 <= judged.separating_distance[1]


def test_texts_of_poses():
    matrix = [[0, -1, 0, Fraction(1, 3)], [1, 0, 0, 0], [0, 0, 1, 0]]
    for text in ("xyz=1/3,0,0 rpy=0,0,90deg", "quat=1,0,0,1 xyz=1/3,0,0", "0 -1 0 1/3 1 0 0 0 0 0 1 0"):
        assert fathom.Pose(text).rows == tuple(map(tuple, matrix))
        assert fathom.depth(CUBE, CUBE, pose_b=text).exact.depth_squared == Fraction(1, 9)
    assert fathom.Pose(matrix).note == "" and "reflection" in fathom.Pose(np.diag([1, 1, -1, 1])).note


def test_notes():
    assert fathom.depth(CUBE, CUBE).notes == []
    [note] = fathom.depth(CUBE, CUBE * 1000).notes
    assert "same unit" in note
    turned = fathom.depth(CUBE, CUBE, pose_b=np.array([[1, 0, 0, 5], [0, 1, 0, 6], [0, 0, 1, 7], [0, 0, 0, 1.0]]).T)
    assert turned.notes == ["pose_b: the last column is 0 0 0 1: this 4 x 4 is read as transposed"]
    assert turned.exact.distance_squared == 4**2 + 5**2 + 6**2


def test_contacts_and_counters():
    apart = fathom.depth(CUBE, CUBE + [2, 2, 2])
    assert apart.contact == {"kind": "vertex-vertex", "a": (7,), "b": (0,)}
    rounded = fathom.depth(fathom.box((1, 1, 1)).with_margin(1), fathom.sphere(1), pose_b="xyz=0,0,5/2")
    assert rounded.contact["kind"] == "facet-vertex"
    assert fathom.depth(fathom.cylinder(1, 1), CUBE).contact is None
    for far in ("0,0,0", "0,0,1/2", "0,0,2", "0,0,5/2"):  # cores that overlap, touch and are apart
        hit = fathom.depth(fathom.box((1, 1, 1)).with_margin(1), fathom.sphere(1), pose_b=f"xyz={far}")
        assert hit.contact and hit.optima[0].contact == hit.contact
    exact = fathom.depth(CUBE, CUBE + [0.5, 0.25, 0], method="exact")
    assert exact.counters["vertices_a"] == 8 and "closest lines" in exact.counters["stages"]
    assert exact.counters["predicates"]["x_order"]["calls"] > 0
    assert fathom.depth(fathom.cylinder(1, 1), CUBE).counters["support_calls"] > 0


ANSWERS = [
    fathom.depth(CUBE, CUBE, optima=2), fathom.depth(CUBE, CUBE + [1, 0, 0]), fathom.depth(CUBE, [("7/3", 0, 0)], method="exact"),
    fathom.depth(fathom.sphere("1/3"), fathom.capsule(1, 2).moved("xyz=1,1,0")), fathom.depth(fathom.cylinder(1, 1), CUBE, bits=20),
    fathom.depth(CUBE, CUBE, pose_a=np.diag([2, 2, 2, 1])), fathom.width(CUBE), fathom.width(fathom.cone(1, 1)),
    fathom.study(fathom.sphere(1), fathom.cylinder(1, 2)).depth, fathom.union_depth([CUBE, CUBE + 1], [CUBE + 0.5]),
    fathom.union_depth([CUBE], [CUBE + 3]), fathom.depth(CUBE, CUBE + 0.25).exact,
]


def told(thing):
    """All that an answer tells but for what it is asked for, as a text; numbers in full."""
    fields = [name for name in dir(type(thing)) if not name.startswith("_") and name not in ("certificate", "exact", "derivative")]
    parts = [f"{name}={getattr(thing, name)!r}" for name in fields] + [repr(thing)]
    if isinstance(thing, fathom.Depth):
        parts += [told(thing.exact), str([(o.normal, o.exact, o.contact) for o in thing.optima])]
    return "\n".join(parts)


@pytest.mark.parametrize("answer", ANSWERS, ids=repr)
def test_answers_can_be_pickled(answer):
    for again in (pickle.loads(pickle.dumps(answer)), copy.deepcopy(answer), pickle.loads(pickle.dumps(copy.copy(answer)))):
        assert told(again) == told(answer)
        if hasattr(answer, "certificate"):
            assert again.certificate("name") == answer.certificate("name")
            assert fathom.check(again.certificate("name")).accepted


def test_exact_answers_show_their_numbers():
    shown = repr(fathom.depth(CUBE, CUBE + [0.5, 0, 0]).exact)
    assert shown.startswith("Exact(signed_depth=Root(rational=Fraction(1, 2), root=Fraction(0, 1)), ")
    assert repr(fathom.depth(fathom.ellipsoid((1, 2, 3)), CUBE).exact).startswith("Exact(bounds=(Fraction(")


def golden_data(folder, level):
    if FATHOM is None:
        pytest.skip("no FATHOM_EXECUTABLE")
    subprocess.run([FATHOM, "golden", "generate", "--level", level, "--out", folder], check=True, stdout=subprocess.PIPE)
    return fathom.golden(folder)


def test_golden_records_of_shapes_have_no_flags(tmp_path):
    records = list(golden_data(tmp_path, "P0"))
    assert len(records) > 800
    assert all(record.flags == [] and record.depth_squared is None for record in records)


def test_golden_records_of_unions(tmp_path):
    records = list(golden_data(tmp_path, "U0"))
    assert len(records) > 100
    for record in records:
        hit = fathom.union_depth(record.a, record.b)
        assert (hit.status, hit.squared) == (record.status, record.depth_squared), record.id


def test_golden_records_of_the_plane(tmp_path):
    records = list(golden_data(tmp_path, "F0"))
    assert len(records) > 200
    for record in records:
        hit, value = fathom.depth(record.a, record.b), record.fields["expected"]["signed_depth"]
        assert (hit.status, hit.direction.shape) == (record.status, (2,)), record.id
        assert hit.signed_depth == float.fromhex(value["f64"]["rn"]), record.id


def test_overlap_needs_no_depth():
    for shift in (-2, -1, -0.5, 0, 0.5, 1, 2):
        other = CUBE + [shift, 0.25, 0]
        status, proof = fathom.overlap(CUBE, other, proof=True)
        assert status == fathom.overlap(CUBE, other) == fathom.depth(CUBE, other).status
        assert set(proof) == {"penetrating": {"common", "around"}, "touching": {"common", "normal"}, "disjoint": {"normal"}}[status]
    assert fathom.overlap(fathom.sphere(1), CUBE) == "penetrating"
    assert fathom.overlap(fathom.union([CUBE, CUBE + [5, 0, 0]]), CUBE + [6.5, 0, 0]) == "disjoint"
    with pytest.raises(ValueError, match="polytopes"):
        fathom.overlap(fathom.sphere(1), CUBE, proof=True)


def test_closer_than_excludes_the_distance():
    far = CUBE + [1 + 0.5, 0, 0]
    assert fathom.closer_than(CUBE, far, 0.5, proof=True) == (False, {"normal": (-1, 0, 0)})
    assert fathom.closer_than(CUBE, far, Fraction(1, 2) + Fraction(1, 10**30)) is True
    closer, proof = fathom.closer_than(CUBE, far, "3/5", proof=True)
    assert closer and proof["points"][1][0] - proof["points"][0][0] == Fraction(1, 2)
    assert fathom.closer_than(fathom.sphere(1), fathom.sphere(1), 1, pose_b="xyz=3,0,0") is False
    with pytest.raises(ValueError, match="above 0"):
        fathom.closer_than(CUBE, far, 0)


def test_prepared_bodies_answer_as_others_do():
    rng = np.random.default_rng(5)
    points_a, points_b = rng.normal(size=(12, 3)), rng.normal(size=(30, 3))
    a, b = fathom.Prepared(points_a), fathom.Prepared(points_b)
    assert b.extreme_points == tuple(sorted(b.extreme_points)) and len(b.extreme_points) < 30
    start = []
    for step in range(6):
        pose = np.eye(4) + 0.01 * step * rng.normal(size=(4, 4))
        pose[:, 3] = 0.6 * step, 0, 0, 1
        pose[3] = 0, 0, 0, 1
        other = fathom.pose((3, 1, step, 0), (0, 0, 0.25))
        found, plain = a.depth(b, pose_a=pose, pose_b=other, start=start), fathom.depth(points_a, points_b, pose_a=pose, pose_b=other)
        assert found.exact.signed_depth == plain.exact.signed_depth and found.contact == plain.contact and found.status == plain.status
        assert found.certificate("walk") == plain.certificate("walk") and str(found.patches) == str(plain.patches)
        assert found.method is None and pickle.loads(pickle.dumps(found)).exact.translation == plain.exact.translation
        assert a.overlap(b, pose_a=pose[:3], pose_b=other) == plain.status
        closer = fathom.closer_than(points_a, points_b, "1/4", pose_a=pose, pose_b=other)
        assert a.closer_than(b, "1/4", pose_a=pose, pose_b=other) == closer
    assert 0 < len(start) <= 8
    with pytest.raises(ValueError, match="^a warm start names the points 0 and 30, but the bodies have 12 and 30"):
        a.depth(b, start=[(0, 30)])
    with pytest.raises(TypeError, match="^start: expected a list of pairs of indices"):
        a.depth(b, start=[(0, -1)])
    with pytest.raises(ValueError, match="^pose_b: "):
        a.depth(b, pose_b=[[1, 2, 3]])
    with pytest.raises(ValueError, match="only a polytope"):
        fathom.Prepared(fathom.sphere(1))
