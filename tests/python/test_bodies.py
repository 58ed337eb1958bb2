# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies: what they are called, how large they are, whether a mesh is its hull; and what pickle keeps of them."""
import copy
import json
import math
import os
import pathlib
import pickle
import shutil
import subprocess
import sys
from fractions import Fraction

import numpy as np
import pytest

import fathom

CUBE = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)


class Tent:  # as trimesh has it: a tetrahedron with one face pushed in
    vertices = np.array([[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4], [1, 1, 1]], float)
    faces = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 4], [2, 3, 4], [3, 1, 4]])


def test_meshes_that_are_not_convex():
    with pytest.warns(fathom.NotConvexWarning, match="^A is not convex, its hull is 33 % larger, its deepest point 0.577 inside the hull$"):
        hit = fathom.depth(Tent, CUBE)
    assert hit.notes and hit.status == "penetrating"
    with pytest.warns(fathom.NotConvexWarning, match="B is not convex"):
        fathom.depths([(CUBE, Tent)])
    flat = Tent()
    flat.vertices = Tent.vertices[[0, 1, 2, 3, 0]]
    flat.faces = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
    assert fathom.convexity(flat) == (True, None, None, None) and fathom.convexity(CUBE) is None
    for faces in (np.array(flat.faces, np.uint64), np.array(flat.faces, np.int8)):
        flat.faces = faces
        assert fathom.convexity(flat).convex
    for faces in (None, [], np.zeros((0, 3), int)):
        flat.faces = faces
        assert fathom.convexity(flat) is None
    quads = Tent()
    quads.vertices, quads.faces = CUBE, [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    assert fathom.convexity(quads) == (True, None, None, None)
    for faces in ("x", [(0.0, 1.0, 2.0)], [(0, 1), (1, 2)], [(0, 1), (1, 2, 3)]):
        flat.faces = faces
        with pytest.raises(ValueError, match="a: expected faces as an array of integers, n x 3"):
            fathom.depth(flat, CUBE)
    flat.faces = [(0, 1, 5)]
    with pytest.raises(ValueError, match="a: face 0: expected an index below 5, found 5"):
        fathom.depth(flat, CUBE)


@pytest.mark.parametrize("ask", [
    fathom.depth, fathom.distance, fathom.overlap, fathom.growth, fathom.approx, fathom.study, fathom.union_depth,
    lambda a, b: fathom.closer_than(a, b, 1), lambda a, b: fathom.ray(a, b, (1, 0, 0)), lambda a, b: fathom.metric(a, b, CUBE - 0.5),
    lambda a, b: fathom.judge(a, b, overlap=True), lambda a, b: fathom.depths([(a, b)])])
def test_no_question_is_about_a_hull_by_silence(ask):
    with pytest.warns(fathom.NotConvexWarning, match="^A is not convex, its hull is 33 % larger") as told:
        ask(Tent, CUBE)
    assert len(told) == 1 and told[0].filename == __file__
    with pytest.warns(fathom.NotConvexWarning, match="^B is open"):
        lid = Tent()
        lid.vertices, lid.faces = Tent.vertices[:4], Tent.faces[:3]
        ask(CUBE, lid)


def test_prepared_meshes_are_told_of():
    with pytest.warns(fathom.NotConvexWarning, match="^the body is not convex"):
        fathom.Prepared(Tent)


def test_extents():
    assert fathom.cylinder(1, 2).extent.tolist() == [2, 2, 4] and fathom.halfspace((0, 0, 1), 0).extent is None
    assert fathom.Body(CUBE).extent.tolist() == [1, 1, 1]


BOX, PILL = fathom.box((1, 2, "1/3")), fathom.capsule("0.1", 1, axis="x")
TURN = fathom.pose((1, 0, 0, 1), ("1/3", 0, 0))


@pytest.mark.parametrize("body, description", [
    (fathom.sphere(1), {"shape": "sphere", "radius": 1}),
    (PILL, {"shape": "capsule", "radius": "1/10", "half_length": 1, "axis": "x"}),
    (BOX, {"shape": "box", "half": [1, 2, "1/3"]}),
    (fathom.tapered_capsule(1, 2, 3), {"shape": "tapered_capsule", "radius_low": 1, "radius_high": 2, "half_length": 3}),
    (fathom.frustum(1, 2, 3, "y"), {"shape": "frustum", "radius_low": 1, "radius_high": 2, "half_length": 3, "axis": "y"}),
    (fathom.cylinder(1, 2), {"shape": "cylinder", "radius": 1, "half_length": 2}),
    (fathom.cone(1, 2), {"shape": "cone", "radius": 1, "half_length": 2}),
    (fathom.ellipsoid((1, 2, 3)), {"shape": "ellipsoid", "radii": [1, 2, 3]}),
    (fathom.halfspace((0, 0, 1), 0.5), {"shape": "halfspace", "normal": [0, 0, 1], "offset": 0.5}),
    (fathom.Body([(0, 0, "1/3")]), {"vertices": [[0, 0, "1/3"]]}),
    (fathom.Body(CUBE[:2] + 0.5), {"vertices": [[0.5, 0.5, 0.5], [0.5, 0.5, 1.5]]}),
    (fathom.union([CUBE[:2], CUBE[2:4]]), {"pieces": [{"vertices": [[0, 0, 0], [0, 0, 1]]}, {"vertices": [[0, 1, 0], [0, 1, 1]]}]}),
    (BOX.moved(TURN), {"shape": "box", "half": [1, 2, "1/3"], "pose": {"quaternion": [1, 0, 0, 1], "translation": ["1/3", 0, 0]}}),
    (PILL.moved("xyz=1,0,0").moved(np.diag([2, 3, 4, 1])), {"shape": "capsule", "radius": "1/10", "half_length": 1, "axis": "x",
                                                            "pose": [[2, 0, 0, 2], [0, 3, 0, 0], [0, 0, 4, 0]]}),
    (BOX.with_margin("1/2").with_margin(1), {"shape": "rounded_box", "half": [1, 2, "1/3"], "margin": 1.5}),
    (fathom.Body([(1, 2, 3)]).with_margin(2), {"shape": "rounded_hull", "vertices": [[1, 2, 3]], "margin": 2}),
    (fathom.sphere(1) + BOX.moved("xyz=1,0,0"), {"shape": "sum", "terms": [
        {"shape": "sphere", "radius": 1},
        {"shape": "box", "half": [1, 2, "1/3"], "pose": {"quaternion": [1, 0, 0, 0], "translation": [1, 0, 0]}}]}),
    (BOX.moved(np.diag([1, 1, 0, 1])), {"vertices": [[x, y, 0] for _ in range(2) for y in (-2, 2) for x in (-1, 1)]}),
])
def test_descriptions(body, description, tmp_path):
    """They are those of cases, and what pickle keeps is the same body."""
    assert body.description == description
    (tmp_path / "case.json").write_text(json.dumps({"a": body.description, "b": body.description}))
    [case] = fathom.cases(tmp_path / "case.json")
    for again in (case.a, pickle.loads(pickle.dumps(body)), copy.deepcopy(body)):
        assert again.description == description and repr(again) == repr(body)
        if body.pieces is None:
            other = fathom.box((3, 3, 3)).moved("xyz=4,1/5,1/7")
            one, two = fathom.depth(again, other), fathom.depth(body, other)
            assert (one.low, one.high, one.exact.normal, one.exact.witness) == (two.low, two.high, two.exact.normal, two.exact.witness)


@pytest.mark.parametrize("name, size", [("capsules", None), ("near_ties", 20), ("shapes_mixed", None), ("box_unions", 3)])
def test_families_are_those_of_the_program(name, size, tmp_path):
    sized = [] if size is None else ["--size", str(size)]
    words = [os.environ["FATHOM_EXECUTABLE"], "cases", "--family", name, "--count", "5", "--seed", "7", *sized]
    (tmp_path / "cases.jsonl").write_bytes(subprocess.run(words, stdout=subprocess.PIPE, check=True).stdout)
    told = [(case.id, case.a.description, case.b.description) for case in fathom.cases(tmp_path / "cases.jsonl")]
    assert [(case.id, case.a.description, case.b.description) for case in fathom.family(name, count=5, seed=7, size=size)] == told
    assert len(told) == 5


def test_a_module_that_is_not_built_says_so(tmp_path):
    shutil.copytree(pathlib.Path(fathom.__file__).parent, tmp_path / "fathom", ignore=shutil.ignore_patterns("_fathom*"))
    done = subprocess.run([sys.executable, "-c", "import fathom"], env={**os.environ, "PYTHONPATH": str(tmp_path)}, stderr=subprocess.PIPE,
                          text=True, check=False)
    assert done.returncode == 1 and done.stderr.splitlines()[-1].startswith("ImportError: fathom._fathom cannot be loaded: is it built")


def test_meshes_and_poses_can_be_pickled():
    mesh = pickle.loads(pickle.dumps(fathom.Body(Tent)))
    assert fathom.convexity(mesh) == fathom.convexity(Tent)
    assert pickle.loads(pickle.dumps(TURN)).rows == TURN.rows


def test_convexity_is_found_once():
    """Of a Body: by how long it takes nothing is decided here, but what was found stays true where the body is moved or copied."""
    dented, cube = fathom.Body(Tent), fathom.read_mesh("tests/data/cube.off")
    for _ in range(2):
        assert fathom.convexity(dented).squared_depth == Fraction(1, 3) and fathom.convexity(cube).convex
        assert fathom.convexity(dented.moved(np.diag([2, 2, 2, 1]))).squared_depth == Fraction(4, 3)
        assert fathom.convexity(cube.moved(np.diag([2, 3, 4, 1]))).convex
    assert str(fathom.convexity(dented)) == ("Convexity(convex=False, volume_ratio=1.3333333333333333, deepest=4, "
                                             "squared_depth=0.3333333333333333)")


def test_what_the_command_line_reads(tmp_path):
    cube = fathom.read("tests/data/cube.off")
    assert (cube.points == fathom.read_mesh("tests/data/cube.off").points).all()
    assert len(fathom.read("tests/data/key.obj", meshes="pieces").pieces) == 3
    assert fathom.read("box:half=1:2:3", meshes="solid").pieces[0].shape == (8, 3)
    spanner = fathom.read("tests/data/decompositions/spanner.off", meshes="solid")
    assert len(spanner.pieces) == len(fathom.solid(fathom.read_mesh("tests/data/decompositions/spanner.off")).pieces)
    assert fathom.depth(fathom.read("sphere:r=0.1", decimals="exact"), fathom.sphere("0.1")).exact.signed_depth.rational == Fraction(1, 5)
    circle, plate = fathom.read("plane:circle:r=1"), fathom.read("examples/data/plate.svg")
    assert circle.dimension == plate.dimension == 2
    for joint in (Fraction(1, 32), "1/32", 0.03125):  # law: numbers are taken exactly
        left = fathom.read("examples/data/arm.urdf#left", joints={"grip": joint})
        assert fathom.depth(left, fathom.read("examples/data/arm.urdf#right", joints={"grip": joint})).signed_depth == -0.0625
    with pytest.warns(UserWarning, match="1 angle that is not 0, each turned by an exact rotation"):
        forearm = fathom.read("examples/data/arm.urdf#forearm", joints={"elbow": math.pi})
    assert fathom.depth(forearm, fathom.read("examples/data/arm.urdf#base")).depth == 0.25
    robot = '<robot name="r"><link name="l"><collision><geometry><mesh filename="package://parts/cube.off"/></geometry></collision></link></robot>'
    (tmp_path / "robots").mkdir()
    (tmp_path / "parts").mkdir()
    (tmp_path / "robots" / "r.urdf").write_text(robot)
    (tmp_path / "parts" / "cube.off").write_bytes(pathlib.Path("tests/data/cube.off").read_bytes())
    assert len(fathom.read(tmp_path / "robots" / "r.urdf#l", package_path=[tmp_path]).points) == 8
    with pytest.raises(ValueError, match="parts/cube.off"):
        fathom.read(tmp_path / "robots" / "r.urdf#l")
