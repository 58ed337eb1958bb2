# SPDX-License-Identifier: GPL-3.0-or-later
"""Many pairs, and one pair in many places: answers, faults, progress, arrays."""
import math
import pickle
import resource
import subprocess
import sys

import numpy as np
import pytest

import fathom

CUBE = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
WALL = fathom.halfspace((1, 0, 0), 0)


def test_batches():
    rng = np.random.default_rng(2)
    pairs = [tuple(rng.normal(size=(2, 20, 3))) for _ in range(300)]
    alone = [fathom.depth(a, b) for a, b in pairs]
    for threads in (None, 1, 3):
        together = fathom.depths(iter(pairs), threads=threads)
        assert [hit.exact.signed_depth for hit in together] == [hit.exact.signed_depth for hit in alone]
        assert [hit.exact.translation for hit in together] == [hit.exact.translation for hit in alone]
    assert fathom.depths([]) == [] and fathom.depths([]).direction.shape == (0, 3)


def ball(points, seed=1):
    p = np.random.default_rng(seed).normal(size=(points, 3))
    return p / np.linalg.norm(p, axis=1)[:, None]


def test_the_first_fault_is_raised_whatever_else_runs():
    """Another pair is still being answered when it comes; nobody pressed a key."""
    large = ball(20000)
    for threads in (None, 2, 4):
        with pytest.raises(ValueError, match="^pair 1: two half-spaces"):
            fathom.depths([(large, large + 0.3), (WALL, WALL)], threads=threads)
        with pytest.raises(ValueError, match="^pair 1: two half-spaces"):
            fathom.depths([(large[:5000], large[:5000] + 0.3), (WALL, WALL), (WALL, WALL)] + [(CUBE, CUBE)] * 20, threads=threads)


def test_faults_are_returned():
    pairs = [(CUBE, CUBE), (CUBE, CUBE * math.nan), (WALL, WALL), (CUBE,), (CUBE, "cube"), (CUBE, [("1/0", 0, 0)]), (CUBE, CUBE + 0.5)]
    hits = fathom.depths(pairs, errors="return")
    assert [type(hit) for hit in hits] == [fathom.Depth, ValueError, ValueError, ValueError, TypeError, ValueError, fathom.Depth]
    assert [str(hit).split(":")[0] for hit in hits[1:6]] == [f"pair {i}" for i in range(1, 6)]
    assert hits.status.tolist() == ["penetrating", "failed", "failed", "failed", "failed", "failed", "penetrating"]
    assert hits[0].depth == hits.depth[0] == 1 and hits[6].depth == hits.depth[6] == 0.5 and np.isnan(hits.depth[1:6]).all()
    for wrong in range(1, 6):
        with pytest.raises(type(hits[wrong]), match=f"^pair {wrong - 1}: "):
            fathom.depths(pairs[1:6][wrong - 1:] if wrong == 1 else [pairs[0]] * (wrong - 1) + [pairs[wrong]])


def test_one_pair_in_many_places():
    rng = np.random.default_rng(3)
    poses = np.tile(np.eye(4), (40, 1, 1))
    poses[:, :3, 3] = rng.normal(size=(40, 3))
    drum = fathom.cylinder(1, "1/2")
    for a, b in ((CUBE, CUBE), (CUBE, fathom.sphere(1)), (drum, CUBE)):
        alone = [fathom.depth(a, b, pose_b=pose) for pose in poses]
        for given in (poses, poses[:, :3], poses.tolist(), [fathom.Pose(pose) for pose in poses]):
            hits = fathom.depths(a, b, poses_b=given)
            assert [hit.low for hit in hits] == [hit.low for hit in alone] and [hit.status for hit in hits] == [hit.status for hit in alone]
        assert fathom.depths(b, a, poses_a=poses).low.tolist() == hits.low.tolist()
        both = fathom.depths(a, b, poses_a=poses, poses_b=poses)
        assert set(both.low) == {fathom.depth(a, b).low} or a is drum
    assert fathom.depths(CUBE, CUBE)[0].depth == 1 and fathom.depths(CUBE, CUBE, poses_b=[]) == []
    assert fathom.depths(CUBE, CUBE, poses_b=["xyz=1/2,0,0", np.diag([2, 2, 2, 1])])[1].notes == [
        "pose_b: det 8, not a rotation: the body is scaled by 2"]


def test_bodies_in_arrays():
    """The naive twin is a list of pairs."""
    rng = np.random.default_rng(4)
    a, b = rng.normal(size=(2, 50, 12, 3))
    alone = fathom.depths(list(zip(a, b)))
    for given in ((a, b), (a.copy(order="F"), b), (np.repeat(a, 2, axis=1)[:, ::2], b)):
        hits = fathom.depths(*given)
        assert [hit.exact.signed_depth for hit in hits] == [hit.exact.signed_depth for hit in alone]
        assert [hit.exact.witness for hit in hits] == [hit.exact.witness for hit in alone]
    for kind in (np.float32, np.int32):
        many = (100 * a).astype(kind)
        assert fathom.depths(many, CUBE).low.tolist() == fathom.depths([(one, CUBE) for one in many]).low.tolist()
        assert fathom.depths(fathom.sphere(1), many).low.tolist() == fathom.depths([(fathom.sphere(1), one) for one in many]).low.tolist()
    poses = np.tile(np.eye(4), (50, 1, 1))
    poses[:, :3, 3] = rng.normal(size=(50, 3))
    moved = fathom.depths(a, b, poses_b=poses)
    assert moved.low.tolist() == [fathom.depth(x, y, pose_b=pose).low for x, y, pose in zip(a, b, poses)]
    b[7, 3, 1] = math.nan
    hits = fathom.depths(a, b, errors="return")
    assert hits.status.tolist().count("failed") == 1 and str(hits[7]) == "pair 7: b: expected finite coordinates, found others in row 3"
    assert fathom.depths(a[:0], CUBE) == []


@pytest.mark.parametrize("call, fault, sentence", [
    (lambda: fathom.depths(np.zeros((2, 4, 3)), np.zeros((3, 4, 3))), ValueError, "as many bodies of a as of b, found 2 and 3"),
    (lambda: fathom.depths(np.zeros((2, 4, 3)), CUBE, poses_a=[np.eye(4)]), ValueError, "as many bodies of a as poses of a, found 2 and 1"),
    (lambda: fathom.depths(np.zeros((2, 4, 3)), CUBE, poses_b=[np.eye(4)]), ValueError, "as many bodies of a as poses of b, found 2 and 1"),
    (lambda: fathom.depths(np.zeros((2, 4, 4)), CUBE), ValueError, "a: expected an array of n x m x 3 or n x m x 2 coordinates, found one of 2 x 4 x 4"),
    (lambda: fathom.depths(CUBE, np.zeros((2, 0, 3))), ValueError, "pair 0: b: expected at least one point, found none"),
    (lambda: fathom.depths([(CUBE, CUBE)], poses_b=[np.eye(4)]), TypeError, "expected poses with two bodies"),
    (lambda: fathom.depths(CUBE, CUBE, poses_b=7), TypeError, "poses_b: expected a sequence of poses"),
    (lambda: fathom.depths(CUBE, CUBE, poses_b="xyz=1,2,3"), TypeError, "poses_b: expected a sequence of poses"),
    (lambda: fathom.depths(CUBE, CUBE, poses_b=np.eye(4)), ValueError, "pair 0: b: expected a pose of 3 or 4 rows of 4 numbers"),
    (lambda: fathom.depths(CUBE, CUBE, poses_a=[np.eye(4)] * 2, poses_b=[np.eye(4)]), ValueError, "found 2 and 1"),
    (lambda: fathom.depths(CUBE, CUBE, poses_b=[np.eye(4), np.eye(4) * math.nan]), ValueError, "pair 1: b: expected a finite number"),
    (lambda: fathom.depths(WALL, CUBE, poses_a=[np.eye(4), np.zeros((3, 4))]), ValueError, "pair 1: a: "),
    (lambda: fathom.depths(CUBE, [], poses_a=[np.eye(4)]), ValueError, "b: expected at least one point"),
    (lambda: fathom.depths([], errors="ignore"), ValueError, "errors: expected 'raise' or 'return'"),
    (lambda: fathom.depths([], progress=7), TypeError, "progress: expected a function, found 7"),
])
def test_arguments(call, fault, sentence):
    with pytest.raises(fault) as raised:
        call()
    assert sentence in str(raised.value)


def test_progress():
    heard = []
    fathom.depths([(ball(3000), ball(3000, 2))] * 12, method="exact", progress=lambda done, total: heard.append((done, total)))
    assert heard[-1] == (12, 12) and heard == sorted(heard) and {total for _, total in heard} == {12} and len(heard) > 1
    heard.clear()
    fathom.depths([], progress=lambda *told: heard.append(told))
    assert heard == [(0, 0)]

    def stop(done, total):
        raise LookupError("enough")

    with pytest.raises(LookupError, match="enough"):
        fathom.depths([(ball(20000), ball(20000, 2))] * 100, progress=stop)


def test_arrays():
    drum = fathom.ellipsoid((1, 2, 3))
    hits = fathom.depths([(CUBE, CUBE), (CUBE, CUBE + [1, 0, 0]), (CUBE, CUBE + [3, 4, 0]), (drum, drum.moved("xyz=1/2,1/3,0"))], bits=8)
    assert hits.status.tolist() == [hit.status for hit in hits]
    for name in ("signed_depth", "depth", "distance", "low", "high"):
        column, values = getattr(hits, name), [getattr(hit, name) for hit in hits]
        assert column.dtype == float and [None if math.isnan(x) else x for x in column] == values
    assert math.isnan(hits.signed_depth[3]) and hits.direction.tolist() == [hit.direction.tolist() for hit in hits]
    again = pickle.loads(pickle.dumps(hits))
    assert isinstance(again, fathom.Depths) and again.low.tolist() == hits.low.tolist()


def test_a_mesh_that_is_not_convex_is_told_of_by_the_caller():
    class Tent:
        vertices = np.array([[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4], [1, 1, 1]], float)
        faces = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 4], [2, 3, 4], [3, 1, 4]])

    with pytest.warns(fathom.NotConvexWarning, match="^A is not convex, its hull is 33 %") as told:
        fathom.depths(Tent, CUBE, poses_b=[np.eye(4)] * 3)
    assert {warning.filename for warning in told} == {__file__}


def test_threads_that_cannot_be_made():
    """A thread takes address space for its stack: with little of it few are made, or none, and all pairs are answered."""
    program = """
import resource, fathom
used = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
resource.setrlimit(resource.RLIMIT_AS, (used + {more}, used + {more}))
hits = fathom.depths([([[0, 0, 0]], [[i, 0, 0]]) for i in range(1100)], threads=1024)
assert [hit.distance for hit in hits] == list(range(1100))
print("answered")
"""
    stack, other, most = 256 << 20, 200 << 20, resource.getrlimit(resource.RLIMIT_STACK)[1]
    for threads in (0, 1, 3):
        more = threads * stack + other
        run = subprocess.run([sys.executable, "-c", program.format(more=more)], capture_output=True, text=True,
                             preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_STACK, (stack, most)))
        assert (run.stdout, run.returncode) == ("answered\n", 0), run.stderr
