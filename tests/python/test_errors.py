# SPDX-License-Identifier: GPL-3.0-or-later
"""Bad input raises ValueError or TypeError with a sentence; Ctrl-C ends a call; other threads go on meanwhile."""
import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import fathom
from fathom import _fathom

CUBE = fathom.box((1, 1, 1))
NAN, INF = float("nan"), float("inf")


@pytest.mark.parametrize("body, sentence", [
    (np.zeros((0, 3)), "a: expected at least one point, found none"),
    ([], "a: expected at least one point, found none"),
    (np.zeros(3), "a: expected an array of n x 3 coordinates, found one of 3"),
    (np.zeros((4, 2)), "a: expected an array of n x 3 coordinates, found one of 4 x 2"),
    (np.zeros((4, 3, 1)), "a: expected an array of n x 3 coordinates, found one of 4 x 3 x 1"),
    (np.array([[0, 0, 0], [0, NAN, 0]]), "a: expected finite coordinates, found others in row 1"),
    (np.array([[0, INF, 0]]), "a: expected finite coordinates"),
    ([(0, 0, 0), (0, 0)], "a: point 1: expected three numbers, found (0, 0)"),
    ([(0, 0, NAN)], "a: point 0: expected a finite number, found nan"),
    ([(0, 0, "1/0")], "a: point 0: expected a number, found '1/0': the denominator is zero"),
    ([(0, 0, "x")], "a: point 0: expected a number, found 'x'"),
    ([1, 2, 3], "a: point 0: expected three numbers, found 1"),
])
def test_bodies(body, sentence):
    with pytest.raises(ValueError) as fault:
        fathom.depth(body, CUBE)
    assert sentence in str(fault.value)


@pytest.mark.parametrize("body", ["cube.off", 7, None, [(0, 0, True)], [(0, 0, None)], np.zeros((2, 3), complex)])
def test_types(body):
    with pytest.raises((TypeError, ValueError)):
        fathom.depth(CUBE, body)


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
    (lambda: fathom.width(fathom.halfspace((0, 0, 1), 0)), "half-space"),
    (lambda: fathom.ray(CUBE, CUBE, (0, 0, 0)), "zero"),
    (lambda: fathom.metric(CUBE, CUBE, [(1, 0, 0)]), ""),
    (lambda: fathom.approx(CUBE, CUBE, 0), "delta"),
    (lambda: fathom.depths([(CUBE, CUBE), (CUBE,)]), "pair 1: expected two bodies"),
    (lambda: fathom.depths([(CUBE, CUBE), (CUBE, [])]), "pair 1: b: expected at least one point"),
    (lambda: fathom.depths([], threads=0), "threads: expected an integer from 1 to 1024, found 0"),
    (lambda: fathom.judge(CUBE, CUBE, overlap=True, touching="maybe"), "expected touching to be one of"),
    (lambda: fathom.read_mesh("tests/data/none.off"), "none.off"),
    (lambda: fathom.read_mesh("tests/data/cube.off", decimals="some"), "expected decimals"),
    (lambda: list(fathom.cases("tests/data/cube.off")), "cube.off"),
    (lambda: list(fathom.golden("tests/data")), "expected files .jsonl.zst, found none"),
    (lambda: list(fathom.golden("tests/data/cube.off")), "cube.off"),
])
def test_arguments(call, sentence):
    with pytest.raises(ValueError) as fault:
        call()
    assert sentence in str(fault.value)


def test_a_bad_case_does_not_end_the_file(tmp_path):
    good = '{"id": "%s", "a": {"vertices": [[0, 0, 0]]}, "b": {"vertices": [[1, 0, 0]]}}\n'
    path = tmp_path / "cases.jsonl"
    path.write_text(good % "one" + '{"id": "two"}\n' + good % "three")
    found, faults, cases = [], [], _fathom.Cases(str(path))
    while True:
        try:
            found.append(next(cases)[0])
        except StopIteration:
            break
        except ValueError as fault:
            faults.append(str(fault))
    assert found == ["one", "three"] and len(faults) == 1 and "cases.jsonl:2" in faults[0]


LONG = """
import fathom, signal, sys, threading, os, time
import numpy as np
rng = np.random.default_rng(1)
def ball(n):
    p = rng.normal(size=(n, 3))
    return p / np.linalg.norm(p, axis=1)[:, None]
a, b = ball(60000), ball(60000)
print("ready", flush=True)
try:
    fathom.{call}
    print("finished")
except KeyboardInterrupt:
    print("interrupted")
"""


@pytest.mark.parametrize("call", ["depth(a, b, method='exact')", "depths([(a, b)] * 8, method='exact')",
                                  "union_depth([ball(60) + rng.normal(size=3) for _ in range(40)], [ball(60) for _ in range(40)])"])
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
        question(a, b)
        seen = counted[0]
    finally:
        sys.setswitchinterval(before)
        stop.set()
        worker.join()
    assert seen > 0
