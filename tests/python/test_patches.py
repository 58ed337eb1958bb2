# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact patches and derivatives: against the program, against what is known, and what is refused."""
import json
import math
import os
import pathlib
import pickle
import subprocess
import sys
from fractions import Fraction

import numpy as np
import pytest

import fathom
from fathom import _fathom

CUBE = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
CHECK = pathlib.Path(__file__).parents[2] / "verify/check/check.py"
FATHOM = os.environ.get("FATHOM_EXECUTABLE")
TWIST, TWIST_B = ["1", "-1/2", "3"], ["1/3", "2", "-1"]
TURN, TURN_B = ["0", "1/7", "-2"], ["1", "0", "5/2"]


@pytest.fixture(autouse=True)
def numbers_of_many_digits():
    """Python reads no int of more than 4300 digits, unless it is told to."""
    if not hasattr(sys, "set_int_max_str_digits"):
        yield
        return
    most = sys.get_int_max_str_digits()
    sys.set_int_max_str_digits(0)
    yield
    sys.set_int_max_str_digits(most)


def exact(texts):
    return tuple(map(Fraction, texts))


def integers(texts):
    return texts and tuple(map(int, texts))


def same_place(place, said):
    """The program says a point with a root for one along a normal, unless it is rational."""
    if len(place) == 3 and not isinstance(place[0], tuple):
        return place == exact(said)
    core, normal, distance = place
    square = sum(x * x for x in normal)
    root = math.isqrt(square)
    if distance != 0 and root * root != square:
        return said == {"core": [str(x) for x in core], "normal": [str(x) for x in normal], "distance": str(distance)}
    return tuple(c + (distance * n / root if distance else 0) for c, n in zip(core, normal)) == exact(said)


def same_patch(patch, said):
    assert (patch.rank, patch.normal, len(patch.corners)) == (said["rank"], integers(said["direction"]), len(said["corners"]))
    assert (patch.pieces, patch.optimum) == (tuple(said["pieces"]) if "pieces" in said else None, said.get("optimum", patch.optimum))
    for corner, told in zip(patch.corners, said["corners"]):
        assert same_place(corner.a, told["a"]) and same_place(corner.b, told["b"])
        assert (corner.on_a and list(corner.on_a), corner.on_b and list(corner.on_b)) == (told["on_a"], told["on_b"])
    assert same_place(patch.centroid[0], said["centroid"]["a"]) and same_place(patch.centroid[1], said["centroid"]["b"])
    if patch.rank == 0:
        assert (patch.size, patch.size_squared, said["size"]) == (0, 0, None)
    else:
        assert patch.size_squared == Fraction(said["size"]["squared"]) and said["size"]["value"] in (patch.size, None)
    assert patch.a_f64.shape == patch.b_f64.shape == (len(patch.corners), 3)
    for corner, a, b in zip(patch.corners, patch.a_f64, patch.b_f64):
        for place, nearest in ((corner.a, a), (corner.b, b)):
            if not isinstance(place[0], tuple):
                assert nearest.tolist() == [float(x) for x in place]  # Python rounds Fractions correctly


def same_derivative(found, said):
    if "left_out" in said:
        assert found == fathom.Derivative(left_out=said["left_out"])
        return
    rate, told = said["rate"], said["rate"]["exact"]
    assert (found.low, found.high, found.normal) == (rate["low"], rate["high"], integers(said["direction"]))
    assert (found.patch, found.corner, found.left_out) == (said["patch"], said["corner"], None)
    assert said["value"] in (found.value, None) and found.low <= found.value <= found.high
    assert Fraction(told["plus"]) == 0 and found.sign * found.root == told["sign"] * Fraction(told["root"])


def same_as_said(hit, line):
    said = line["manifold"]
    assert (hit.smooth, hit.left_out) == (said["smooth"], said.get("left_out"))
    assert hit.kinks is None and said["kinks"] is None or list(hit.kinks) == said["kinks"]
    patches = hit.patches
    assert len(patches) == len(said["patches"] or ())
    for patch, told in zip(patches, said["patches"] or ()):
        same_patch(patch, told)
    assert (hit.gradient is None) == (said["gradient"] is None)
    if hit.gradient:
        assert (hit.gradient.normal, hit.gradient.point) == (integers(said["gradient"]["normal"]), exact(said["gradient"]["point"]))
        assert {"v": hit.gradient.v.tolist(), "w": hit.gradient.w.tolist()} == said["gradient_f64"]
    assert (hit.vertex_weights is None) == (said["vertex_weights"] is None)
    if hit.vertex_weights:
        for weights, told in zip(hit.vertex_weights, (said["vertex_weights"]["a"], said["vertex_weights"]["b"])):
            assert list(weights.items()) == [(i, Fraction(weight)) for i, weight in told]
    assert (hit.optimal_cone is None) == ("optimal_cone" not in said)
    if hit.optimal_cone:
        told = said["optimal_cone"]
        assert hit.optimal_cone == (told["lineality"], integers(told["axis"]), tuple(map(integers, told["rays"])))
    same_derivative(hit.derivative(TWIST, TURN, TWIST_B, TURN_B), line["derivative"])


@pytest.mark.parametrize(("kind", "count"), [([], 110), (["--shapes"], 250), (["--unions"], 60)], ids=["polytopes", "shapes", "unions"])
def test_the_program_says_the_same(kind, count, tmp_path):
    if not FATHOM:
        pytest.skip("FATHOM_EXECUTABLE is not set")
    size = "3" if "--unions" in kind else "8"
    made = [subprocess.run([FATHOM, "cases", *what, *kind], capture_output=True, text=True, check=True).stdout
            for what in (["--family", "all", "--count", str(count), "--size", size], ["--catalogue"])]
    (tmp_path / "cases.jsonl").write_text("".join(made))
    command = [FATHOM, "depth", "--json", "--patch", "--twist", ",".join(TWIST + TURN), "--twist-b", ",".join(TWIST_B + TURN_B),
               str(tmp_path / "cases.jsonl")]
    said = [json.loads(line) for line in subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()]
    seen = set()
    for case, line in zip(fathom.cases(tmp_path / "cases.jsonl"), said, strict=True):
        hit = (fathom.union_depth if kind == ["--unions"] else fathom.depth)(case.a, case.b)
        try:
            same_as_said(hit, line)
        except AssertionError as fault:
            raise AssertionError(case.id) from fault
        seen |= {(hit.status, patch.rank) for patch in hit.patches} | {hit.smooth, hit.left_out} | set(hit.kinks or ())
    expected = {(status, rank) for status in ("penetrating", "touching", "disjoint") for rank in (0, 1, 2)}
    assert (expected | ({None} if kind == ["--unions"] else {True, False, "ties", "extended", "cone"})) - seen == set()


@pytest.mark.parametrize("kind", [[], ["--shapes"], ["--unions"]], ids=["polytopes", "shapes", "unions"])
def test_certificates_with_patches_are_those_of_the_program(kind, tmp_path):
    if not FATHOM:
        pytest.skip("FATHOM_EXECUTABLE is not set")
    cases = tmp_path / "cases.jsonl"
    cases.write_text(subprocess.run([FATHOM, "cases", "--catalogue", *kind], capture_output=True, text=True, check=True).stdout)
    command = [FATHOM, "depth", "--json", "--embed-certificate", "--patch", str(cases)]
    lines = subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()
    said = [json.loads(line)["certificate"] for line in lines]
    proofs = []
    for case, text in zip(fathom.cases(cases), said, strict=True):
        hit = (fathom.union_depth if kind == ["--unions"] else fathom.depth)(case.a, case.b)
        if hit.left_out or kind == ["--unions"]:  # bounds of the program are others, with fewer bits
            assert hit.certificate(case.id, patches=True) == hit.certificate(case.id), case.id
            continue
        assert hit.certificate(case.id, patches=True) == text, case.id
        if len(proofs) < 40:
            proofs.append(tmp_path / f"{len(proofs)}.cert")
            proofs[-1].write_text(text)
    again = pickle.loads(pickle.dumps(hit))
    assert again.certificate(case.id, patches=True) == hit.certificate(case.id, patches=True)
    if kind != ["--unions"]:
        checked = subprocess.run([sys.executable, str(CHECK), *map(str, proofs)], capture_output=True, text=True)
        assert (checked.returncode, checked.stdout.count("patches=")) == (0, len(proofs)), checked.stdout


def test_boxes():
    hit = fathom.depth(fathom.box((1, 1, 1)), fathom.box((1, 1, 1)), pose_b="xyz=1,1/2,1/4")
    assert (hit.smooth, hit.kinks, hit.gradient, hit.vertex_weights, hit.optimal_cone) == (False, ("extended",), None, None, None)
    [patch] = hit.patches
    assert (patch.rank, patch.size, patch.size_squared) == (2, 2.625, Fraction(441, 64))
    assert patch.a_f64.tolist() == [[1, -0.5, -0.75], [1, -0.5, 1], [1, 1, 1], [1, 1, -0.75]]
    assert (patch.b_f64 - patch.a_f64).tolist() == [hit.translation.tolist()] * 4
    assert (patch.corners[0].on_a, patch.corners[0].on_b) == ((1, 3, 5, 7), (0,))
    assert patch.centroid[0] == (1, Fraction(1, 4), Fraction(1, 8))
    assert [hit.derivative((s, 0, 0)).value for s in (1, -1)] == [1, -1] and hit.derivative(w=(0, 0, 1)).root == Fraction(1, 4)
    assert hit.derivative().value == hit.derivative((1, 2, 3), (4, 5, 6), (1, 2, 3), (4, 5, 6)).value == 0
    assert math.copysign(1, hit.derivative((0, 1, 0)).value) == 1
    assert len(fathom.depth(CUBE, CUBE).patches) == 6 and fathom.depth(CUBE, CUBE, optima=2).derivative((1, 0, 0)).left_out == "unlisted"


def test_gradients_are_the_derivatives():
    rng = np.random.default_rng(3)
    for _ in range(40):
        a, b = rng.normal(size=(2, 9, 3))
        hit = fathom.depth(a, b + rng.normal(size=3))
        assert hit.smooth
        v, w = ([Fraction(int(x), 8) for x in rng.integers(-20, 20, size=3)] for _ in "vw")
        n, p = hit.gradient.normal, hit.gradient.point
        turned = (w[1] * p[2] - w[2] * p[1], w[2] * p[0] - w[0] * p[2], w[0] * p[1] - w[1] * p[0])
        rate = -sum(m * (x + y) for m, x, y in zip(n, v, turned))
        found = hit.derivative(v, w)
        assert found.sign * found.root == rate * abs(rate) / sum(m * m for m in n)
        assert hit.derivative(v_b=v, w_b=w).sign == -found.sign and hit.derivative(v, w, v, w).root == 0
        assert math.isclose(found.value, hit.gradient.v @ np.array(v, float) + hit.gradient.w @ np.array(w, float), abs_tol=1e-12)
        for points, weights, of in ((a, hit.vertex_weights.a, hit.patch.corners[0].a), (b, hit.vertex_weights.b, None)):
            assert sum(weights.values()) == 1
            if of and hit.status == "penetrating":
                assert tuple(sum(weight * Fraction(points[i][k]) for i, weight in weights.items()) for k in range(3)) == of


def test_arrays_of_gradients():
    tip = [(0, 0, 0), (1, 2, 3), (2, 1, 3), (-1, -2, 4)]
    slab = fathom.box((9, 9, 1))
    hits = fathom.depths([(CUBE, CUBE), (slab, tip), (slab, CUBE * math.nan), (fathom.sphere(1), slab.moved("xyz=0,0,3/2"))], errors="return")
    assert hits.gradients.shape == (4, 6) and np.isnan(hits.gradients[[0, 2]]).all()
    for i in (1, 3):
        assert hits.gradients[i].tolist() == [*hits[i].gradient.v, *hits[i].gradient.w] and np.isfinite(hits.gradients[i]).all()
    assert fathom.depths([]).gradients.shape == (0, 6)


def test_curved_bodies_have_none():
    hit = fathom.depth(fathom.cone(1, 1), CUBE)
    assert (hit.left_out, hit.patches, hit.patch, hit.smooth, hit.kinks, hit.gradient) == ("curved", (), None, None, None, None)
    assert hit.derivative((1, 0, 0)) == fathom.Derivative(left_out="curved")


def test_it_is_found_once_and_when_asked_for():
    hit = fathom.depth(CUBE, CUBE + 0.5)
    kept = pickle.loads(pickle.dumps(hit))
    assert not hasattr(kept._answer, "_asked")
    assert str(kept.patches) == str(hit.patches) and hit._answer.manifold() is hit._answer.manifold()
    asked = kept._answer._asked
    assert kept.derivative((1, 2, 3)).root == hit.derivative((1, 2, 3)).root and kept._answer._asked is asked
    assert str(pickle.loads(pickle.dumps(kept)).patches) == str(hit.patches)


def test_stopped_searches_tell_nothing():
    grid = [CUBE + np.array([i, j, k]) for i in range(10) for j in range(10) for k in range(10)]
    asked = []
    hit = fathom.union_depth(grid, [cube + 0.5 for cube in grid], stop=lambda: len(asked) > 3 or asked.append(1))
    for answer in (hit, pickle.loads(pickle.dumps(hit))):
        assert not answer.complete and (answer.patches, answer.smooth, answer.left_out) == ((), None, "incomplete")
        assert answer.derivative((1, 0, 0)) == fathom.Derivative(left_out="incomplete")


@pytest.mark.parametrize("twist, fault, sentence", [
    ({"v": (1, 0)}, ValueError, "v: expected three numbers, found (1, 0)"),
    ({"w": np.zeros(6)}, ValueError, "w: expected three numbers, found array("),
    ({"v_b": (0, float("nan"), 0)}, ValueError, "v_b: expected a finite number, found nan"),
    ({"w_b": (0, 0, float("inf"))}, ValueError, "w_b: expected a finite number, found inf"),
    ({"v": (0, 0, "1/0")}, ValueError, "v: expected a number, found '1/0': the denominator is zero"),
    ({"w": "xyz"}, ValueError, "w: expected three numbers, found 'xyz'"),
    ({"v": (0, 0, 1j)}, TypeError, "v: expected a number (float, int, Fraction, Decimal or text), found 1j"),
    ({"v": None}, ValueError, "v: expected three numbers, found None"),
])
def test_twists(twist, fault, sentence):
    for hit in (fathom.depth(CUBE, CUBE + 0.5), fathom.depth(fathom.cone(1, 1), CUBE)):
        with pytest.raises(fault) as raised:
            hit.derivative(**twist)
        assert str(raised.value).startswith(sentence)


def test_manifolds_without_a_value():
    """type.__new__ makes them."""
    empty = _fathom.Manifold.__new__(_fathom.Manifold)
    with pytest.raises(TypeError):
        empty.derivative((1, 0, 0), (0, 0, 0), (0, 0, 0), (0, 0, 0))
