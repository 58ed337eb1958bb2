# SPDX-License-Identifier: GPL-3.0-or-later
"""Bad input raises ValueError or TypeError with a sentence; Ctrl-C ends a call; other threads go on meanwhile."""
import os
import signal
import subprocess
import sys
import threading
import time
import types
from decimal import Decimal
from fractions import Fraction
from unittest.mock import MagicMock

import numpy as np
import pytest

import fathom
from fathom import _fathom

CUBE = fathom.box((1, 1, 1))
NAN, INF = float("nan"), float("inf")
WIDE, BELOW = [("1e60000", 0, 0), (0, 1, 0), (0, 0, 1), (-1, -1, -1)], [(0, 0, 0), (1, 1, 1), (1, 0, 0), (0, 1, 0)]


@pytest.mark.parametrize("body, sentence", [
    (np.zeros((0, 3)), "a: expected at least one point, found none"),
    ([], "a: expected at least one point, found none"),
    (np.zeros(3), "a: expected an array of n x 3 or n x 2 coordinates, found one of 3"),
    (np.zeros((4, 4)), "a: expected an array of n x 3 or n x 2 coordinates, found one of 4 x 4"),
    (np.zeros((4, 3, 1)), "a: expected an array of n x 3 or n x 2 coordinates, found one of 4 x 3 x 1"),
    (np.array([[0, 0, 0], [0, NAN, 0]]), "a: expected finite coordinates, found others in row 1"),
    (np.array([[0, INF, 0]]), "a: expected finite coordinates"),
    ([(0, 0, 0), (0, 0)], "a: point 1: expected three numbers, found (0, 0)"),
    ([(0, 0, NAN)], "a: point 0: expected a finite number, found nan"),
    ([(0, 0, "1/0")], "a: point 0: expected a number, found '1/0': the denominator is zero"),
    ([(0, 0, "x")], "a: point 0: expected a number, found 'x'"),
    ([1, 2, 3], "a: point 0: expected three numbers, found 1"),
    ([(0, 0, Decimal("inf"))], "a: point 0: expected a finite number, found Decimal('Infinity')"),
    ([(0, 0, Decimal("nan"))], "a: point 0: expected a finite number, found Decimal('NaN')"),
    ([(0, 0, Decimal("1E+999999999"))], "a: point 0: expected a number, found '1E+999999999'"),
    ([(0, 0, Decimal("-1E-999999999"))], "a: point 0: expected a number, found '-1E-999999999'"),
    ([(0, 0, np.float32("inf"))], "a: point 0: expected a finite number, found inf"),
    (np.array([[0, 0, INF]], np.longdouble), "a: point 0: expected a finite number, found "),
    (np.array([[0, 0, NAN]], np.longdouble), "a: point 0: expected a finite number, found "),
    ([(0, 0, "\ud800")], "a: point 0: expected a text of whole characters, found '\\ud800'"),
    ([(0, 0, "\u00e9" * 100)], "a: point 0: expected a number, found"),
    (np.ma.array([[0, 0, 0], [0, 0, 9.0]], mask=[[0, 0, 0], [0, 0, 1]]), "a: expected an array without a mask"),
    (np.ma.array([[0, 0, 0], [0, 0, 9]], mask=[[0, 0, 0], [0, 0, 1]]), "a: expected an array without a mask"),
    (np.ma.array(np.zeros((2, 3), object), mask=True), "a: expected an array without a mask"),
    (types.SimpleNamespace(vertices=np.ma.array(np.zeros((2, 3)), mask=True)), "a: expected an array without a mask"),
    (types.SimpleNamespace(vertices=np.eye(3), faces=np.ma.array([[0, 1, 2]], mask=[[0, 0, 1]])), "a: expected an array without a mask"),
])
def test_bodies(body, sentence):
    with pytest.raises(ValueError) as fault:
        fathom.depth(body, CUBE)
    assert sentence in str(fault.value)


class Ratio:
    """Says that it is this number."""

    def __init__(self, ratio):
        self.ratio = ratio

    def as_integer_ratio(self):
        return self.ratio


class Rational:
    """Says so in other words."""

    def __init__(self, numerator, denominator):
        self.numerator, self.denominator = numerator, denominator


class ItsOwnVertices:
    @property
    def vertices(self):
        return self


class Unspeakable:
    def __repr__(self):
        raise RuntimeError("no words")


def chain(links):
    mesh = np.zeros((1, 3))
    for _ in range(links):
        mesh = types.SimpleNamespace(vertices=mesh)
    return mesh


@pytest.mark.parametrize("body", ["cube.off", 7, None, [(0, 0, True)], [(0, 0, None)], np.zeros((2, 3), complex)])
def test_types(body):
    with pytest.raises((TypeError, ValueError)):
        fathom.depth(CUBE, body)


@pytest.mark.parametrize("body", [
    MagicMock(), ItsOwnVertices(), chain(2), chain(5000), types.SimpleNamespace(vertices=None), [(0, 0, Ratio("x"))],
    [(0, 0, Ratio((1, 2, 3)))], [(0, 0, Ratio((1.0, 2)))], [(0, 0, MagicMock())], [(0, 0, Rational(1.0, 2))],
    [(0, 0, Rational(1, "x"))], [(0, 0, np.ma.masked)],
    [(0, 0, Unspeakable())],
], ids=lambda body: type(body).__name__)
def test_objects_that_are_no_bodies(body):
    for call in (lambda: fathom.depth(CUBE, body), lambda: fathom.depths([(body, CUBE)]), lambda: fathom.union_depth(body, CUBE),
                 lambda: fathom.Body(body)):
        with pytest.raises(TypeError):
            call()


@pytest.mark.parametrize("number", [Ratio((1, 0)), Rational(1, 0), Rational(np.int64(1), np.int64(0))])
def test_numbers_over_zero(number):
    for call in (lambda: fathom.depth(CUBE, [(0, 0, number)]), lambda: fathom.sphere(number), lambda: fathom.pose((1, 0, 0, number))):
        with pytest.raises(ValueError, match="the denominator is zero"):
            call()
    assert fathom.distance([(0, 0, 0)], [(0, Ratio((-3, -6)), Rational(np.int64(2), -4))]).exact.distance_squared == Fraction(1, 2)


def test_a_mask_without_masked_numbers_is_none():
    corners = np.ma.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
    for body in (corners, corners.astype(float), np.ma.array(corners, mask=np.zeros((8, 3)))):
        assert fathom.depth(body, CUBE).depth == 2


@pytest.mark.parametrize("made", [_fathom.Body, _fathom.Pose, _fathom.Answer, _fathom.Manifold, _fathom.Cases, _fathom.ZstdLines])
def test_objects_without_a_value(made):
    """type.__new__ makes them."""
    empty = made.__new__(made)
    for name in [name for name, member in vars(made).items() if isinstance(member, property)]:
        with pytest.raises(TypeError):
            getattr(empty, name)
    if made is _fathom.Body:
        assert pytest.raises(TypeError, fathom.depth, empty, CUBE) and pytest.raises(TypeError, lambda: empty + CUBE)
    if made in (_fathom.Cases, _fathom.ZstdLines):
        assert pytest.raises(TypeError, next, empty)
    if made is _fathom.Pose:
        assert pytest.raises(TypeError, fathom.depth, CUBE, CUBE, pose_a=empty)


@pytest.mark.parametrize("call, sentence", [
    (lambda: fathom.depth(CUBE, CUBE, method="best"), "expected method 'automatic'"),
    (lambda: fathom.depth(CUBE, CUBE, optima=0), "optima: expected an integer from 1 to "),
    (lambda: fathom.depth(CUBE, CUBE, bits=-1), "bits: expected an integer from 1 to 1000, found -1"),
    (lambda: fathom.width(CUBE, bits=1001), "bits: expected an integer from 1 to 1000, found 1001"),
    (lambda: fathom.depth(CUBE, CUBE, pose_a=np.eye(3)), "a: expected a pose of 3 or 4 rows of 4 numbers"),
    (lambda: fathom.depth(CUBE, CUBE, pose_b=np.diag([1, 1, 1, 2])), "b: pose: expected the last row 0 0 0 1"),
    (lambda: fathom.depth(CUBE, CUBE, pose_b=fathom.pose((0, 0, 0, 0))), "0"),
    (lambda: fathom.depth(fathom.cylinder(1, 1), CUBE, pose_a=np.zeros((3, 4))), "singular"),
    (lambda: fathom.sphere(0), "radius"),
    (lambda: fathom.sphere(-1), "radius"),
    (lambda: fathom.capsule(1, 1, axis="w"), "expected the axis"),
    (lambda: fathom.halfspace((0, 0, 0), 1), "normal"),
    (lambda: fathom.depth(fathom.halfspace((0, 0, 1), 1), fathom.halfspace((0, 0, 1), 1)), "half-space"),
    (lambda: fathom.ray(CUBE, fathom.sphere(1), (1, 0, 0)), "b: expected a polytope"),
    (lambda: fathom.width(fathom.halfspace((0, 0, 1), 0)), "a half-space has no width: it is infinite"),
    (lambda: fathom.ray(CUBE, CUBE, (0, 0, 0)), "zero"),
    (lambda: fathom.metric(CUBE, CUBE, [(1, 0, 0)]), ""),
    (lambda: fathom.approx(CUBE, CUBE, 0), "delta"),
    (lambda: fathom.depths([(CUBE, CUBE), (CUBE,)]), "pair 1: expected two bodies"),
    (lambda: fathom.depths([(CUBE, CUBE), (CUBE, [])]), "pair 1: b: expected at least one point"),
    (lambda: fathom.depths([], threads=0), "threads: expected an integer from 1 to 1024, found 0"),
    (lambda: fathom.judge(CUBE, CUBE, overlap=True, touching="maybe"), "expected touching to be one of"),
    (lambda: fathom.read_mesh("tests/data/none.off"), "none.off"),
    (lambda: fathom.read("tests/data/none.off"), "none.off"),
    (lambda: fathom.read("examples/data/arm.urdf#hand"), "expected FILE.urdf#LINK with a link of the robot"),
    (lambda: fathom.read("examples/data/arm.urdf#base", joints={"neck": 1}), "neck"),
    (lambda: fathom.read("examples/data/arm.urdf#base", joints={"elbow": 4}), "joint 'elbow': expected a value from -3.2 to 3.2"),
    (lambda: fathom.read("examples/data/arm.urdf#base", joints={"elbow": "near"}), "joints: expected a number"),
    (lambda: fathom.read("sphere:r=1", joints={"elbow": 0}), "elbow"),
    (lambda: fathom.read("sphere:r=1", meshes="pieces"), "expected a polytope, found a shape that is none"),
    (lambda: fathom.read("sphere:r=1", meshes="some"), "expected meshes to be one of"),
    (lambda: fathom.read("sphere:r=1", decimals="some"), "expected decimals"),
    (lambda: fathom.read("circle:r=1"), "plane:circle:..."),
    (lambda: fathom.read_mesh("tests/data/cube.off", decimals="some"), "expected decimals"),
    (lambda: fathom.judge(CUBE, CUBE, overlap=True, direction=(1, 0)), "direction: expected three numbers, found (1, 0)"),
    (lambda: fathom.judge(CUBE, CUBE, overlap=True, depth=10**400), "depth: expected a number within binary64"),
    (lambda: fathom.judge(CUBE, CUBE, overlap=True, witness=(1, 2, 3)), "expected a witness of two points, found (1, 2, 3)"),
    (lambda: fathom.judge(CUBE, CUBE, overlap=True, contacts=[1]), "expected each contact to be a position and a depth"),
    (lambda: fathom.judge(CUBE, CUBE, overlap=True, manifold=(0, 0)), "manifold: expected a number of contacts from 1, found 0"),
    (lambda: fathom.judge(CUBE, CUBE, overlap=True, patch_slack=-1), "patch_slack: expected a length of at least 0, found -1"),
    (lambda: fathom.judge(CUBE, CUBE, overlap=True, manifold=(4, -1)), "manifold: expected a margin of at least 0, found -1"),
    (lambda: fathom.depth(CUBE, CUBE, pose_a="xyz=\ud800"), "a: expected a text of whole characters"),
    (lambda: fathom.depth(CUBE, CUBE, pose_a=np.full((3, 4), np.float32("inf"))), "a: expected a finite number"),
    (lambda: fathom.family("capsule"), "nearest: capsules"),
    (lambda: fathom.depth(WIDE, BELOW).certificate(), "all checkers would refuse to read it"),
    (lambda: fathom.union_depth(WIDE, BELOW).certificate(), "all checkers would refuse to read it"),
    (lambda: list(fathom.cases("tests/data/cube.off")), "cube.off"),
    (lambda: list(fathom.golden("tests/data")), "expected files .jsonl.zst, found none"),
    (lambda: list(fathom.golden("tests/data/cube.off")), "cube.off"),
])
def test_arguments(call, sentence):
    with pytest.raises(ValueError) as fault:
        call()
    assert sentence in str(fault.value)


@pytest.mark.parametrize("call, sentence", [
    (lambda: fathom.judge(CUBE, CUBE, overlap=True, depth="1"), "depth: expected a number, found '1'"),
    (lambda: fathom.judge(CUBE, CUBE, overlap=True, direction="abc"), "direction: expected three numbers, found 'abc'"),
    (lambda: fathom.judge(CUBE, CUBE, overlap=True, direction=("a", "b", "c")), "direction: expected a number, found 'a'"),
    (lambda: fathom.judge(CUBE, CUBE, overlap=True, contacts=[((0, 0, 0), "1")]), "contacts: expected a number, found '1'"),
    (lambda: fathom.judge(CUBE, CUBE, overlap="yes"), "overlap: expected True or False, found 'yes'"),
    (lambda: fathom.judge(CUBE, CUBE, overlap=True, policy=1), "policy: expected a text, found 1"),
    (lambda: fathom.judge(CUBE, CUBE, overlap=True, touching="\ud800"), "touching: expected a text, found '\\ud800'"),
    (lambda: fathom.depth(CUBE, CUBE, method=1), "incompatible function arguments"),
    (lambda: fathom.depth(CUBE, CUBE, pose_a=np.ma.array(np.eye(4), mask=True)), "expected a number"),
])
def test_types_of_arguments(call, sentence):
    with pytest.raises((TypeError, ValueError)) as fault:
        call()
    assert sentence in str(fault.value)


def read_on(items):
    """What is read, and what is said of the rest."""
    found, faults = [], []
    while True:
        try:
            found.append(next(items).id)
        except StopIteration:
            return found, faults
        except ValueError as fault:
            faults.append(str(fault))


def test_a_bad_case_does_not_end_the_file(tmp_path):
    good = '{"id": "%s", "a": {"vertices": [[0, 0, 0]]}, "b": {"vertices": [[1, 0, 0]]}}\n'
    path = tmp_path / "cases.jsonl"
    path.write_text(good % "one" + '{"id": "two"}\n' + good % "three" + "{\n" + good % "four")
    found, faults = read_on(fathom.cases(path))
    assert found == ["one", "three", "four"] and [fault.split(": ")[0] for fault in faults] == [f"{path}:2", f"{path}:4"]


def test_a_bad_record_does_not_end_the_data(tmp_path):
    case = '{"id": "%s", "a": {"vertices": [[0, 0, 0]]}, "b": {"vertices": [[1, 0, 0]]}%s}\n'
    record = case % ("%s", ', "expected": {"status": "disjoint"}')
    for name, text in (("1", record % "one" + case % ("two", "") + record % "three"), ("3", record % "four")):
        subprocess.run(["zstd", "-q", "-o", tmp_path / f"{name}.jsonl.zst"], input=text.encode(), check=True)
    (tmp_path / "2.jsonl.zst").write_bytes((tmp_path / "1.jsonl.zst").read_bytes()[:-9])
    found, faults = read_on(fathom.golden(tmp_path))
    assert found == ["one", "three", "four"] and [fault.split(": ")[0] for fault in faults] == [f"{tmp_path}/1.jsonl.zst:2",
                                                                                                 f"{tmp_path}/2.jsonl.zst"]


def test_subinterpreters():
    """numpy and pybind11 would wait for ever."""
    program = """
try:
    import _interpreters as interpreters
except ImportError:
    import _xxsubinterpreters as interpreters
interpreters.run_string(interpreters.create(), '''
try:
    import fathom
except ImportError as fault:
    print(fault, flush=True)
''')
"""
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=60)
    assert run.stdout == "fathom serves the main interpreter alone, and this is a subinterpreter\n", run.stderr


LONG = """
import fathom, signal, sys, threading, os, time
import numpy as np
rng = np.random.default_rng(1)
def ball(n):
    p = rng.normal(size=(n, 3))
    return p / np.linalg.norm(p, axis=1)[:, None]
a, b = ball(60000), ball(60000)
def grid(at):
    cube = np.array([(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)])
    return [cube + (i + at, j + at, k + at) for i in range(10) for j in range(10) for k in range(10)]
print("ready", flush=True)
try:
    fathom.{call}
    print("finished")
except KeyboardInterrupt:
    print("interrupted")
"""


@pytest.mark.parametrize("call", ["depth(a, b, method='exact')", "depths([(a, b)] * 8, method='exact')",
                                  "union_depth(grid(0), grid(0.5))"])
def test_interrupts(call):
    process = subprocess.Popen([sys.executable, "-c", LONG.format(call=call)], stdout=subprocess.PIPE, text=True, env=os.environ)
    assert process.stdout.readline() == "ready\n"
    time.sleep(0.5)
    process.send_signal(signal.SIGINT)
    out, _ = process.communicate(timeout=120)
    assert out == "interrupted\n"


def cloud(points, seed):
    return np.random.default_rng(seed).normal(size=(points, 3))


def cluster(seed):
    return [cloud(20, seed + i) / 2 + cloud(1, seed + i) for i in range(10)]


@pytest.mark.parametrize("question, a, b", [
    (lambda a, b: fathom.depth(a, b, method="exact"), cloud(3000, 1), cloud(3000, 2)),
    (fathom.union_depth, cluster(100), cluster(200)),
])
def test_other_threads_go_on(question, a, b):
    """The lock is let go: another thread works while a depth is found."""
    counted, stop = [0], threading.Event()

    def count():
        while not stop.wait(0.0005):
            counted[0] += 1

    worker = threading.Thread(target=count)
    before = sys.getswitchinterval()
    worker.start()
    sys.setswitchinterval(1000)  # who holds the lock keeps it, unless it lets go
    try:
        for _ in range(20):  # the other thread may have to wait for a processor
            question(a, b)
            if counted[0] > 0:
                break
        seen = counted[0]
    finally:
        sys.setswitchinterval(before)
        stop.set()
        worker.join()
    assert seen > 0
