# SPDX-License-Identifier: GPL-3.0-or-later
"""The adapters of one engine of the plane, FATHOM_SUBJECT, in its modes: hello, pairs with known answers in both orders that prove the
conventions, shapes, and what they decline. Skipped where node, npm or the network is absent."""
import itertools
import math
import os
import pathlib
import unittest

import web_install
from client import HELLO, Client

ENGINE = os.environ["FATHOM_SUBJECT"]
MODES = {"planck": ["manifold"], "matter": ["sat"], "box2d": ["world"], "rapier2d": ["contact", "world"]}[ENGINE]
PRECISION = "binary64" if ENGINE in ("planck", "matter") else "binary32"
NAMES = {"planck": ["circle"], "matter": [], "box2d": ["circle", "capsule", "margin"],
         "rapier2d": ["circle", "capsule", "margin"]}[ENGINE]
MOST = {"planck": 12, "box2d": 8}.get(ENGINE)  # corners of a polygon
TOLERANCE = 1e-5

SQUARE = [[-1, -1], [1, -1], [1, 1], [-1, 1]]
DIAMOND = [[2, 0], [0, 2], [-2, 0], [0, -2]]
TRIANGLE = [[0, 0], [4, 0], [0, 3]]


def moved(points, x, y):
    return [[p[0] + x, p[1] + y] for p in points]


# Depth and way out of A; corners in any order, and points that are no corners.
PENETRATING = [
    ("side by side", SQUARE, moved(SQUARE, 1.5, 0.25), 0.5, [-1, 0]),
    ("one on the other", SQUARE, moved(SQUARE, -0.25, 1.75), 0.25, [0, -1]),
    ("far from the origin", moved(SQUARE, 100, -40), moved(SQUARE, 101.5, -40.25), 0.5, [-1, 0]),
    ("a corner in a side", SQUARE, moved(DIAMOND, 2.75, 0.125), 0.25, [-1, 0]),
    ("a slanted side", TRIANGLE, moved(SQUARE, 2.5, 2.5), 0.3, [-0.6, -0.8]),
    ("clockwise, a point within", [[0, 0], *SQUARE[::-1]], moved(SQUARE[::-1], 1.5, 0.25), 0.5, [-1, 0]),
    ("of other sizes", [[-3, -2], [3, -2], [3, 2], [-3, 2]], moved(SQUARE, 2, 2.75), 0.25, [0, -1]),
]
APART = [("side by side", SQUARE, moved(SQUARE, 2.5, 0.25), 0.5), ("across the corner", SQUARE, moved(SQUARE, 5, 6), 5),
         ("within a skin", SQUARE, moved(SQUARE, 2.015, 0.25), 0.015)]


def dot(u, v):
    return sum(x * y for x, y in zip(u, v, strict=True))


def grown(margin, *core):
    return {"vertices": [list(p) for p in core], "margin": margin}


def box(x, y, half_x, half_y):
    return [[x - half_x, y - half_y], [x + half_x, y - half_y], [x + half_x, y + half_y], [x - half_x, y + half_y]]


def grown_box(margin, *of):
    body = {"vertices": box(*of), "margin": margin}
    return {**body, "faces": [[0, 1], [1, 2], [2, 3], [3, 0]]}


SHAPES = [
    ("circles", grown(0.5, (0, 0)), grown(0.5, (0.6, 0)), 0.4, [-1, 0]),
    ("a circle on a box", grown(0.5, (0.25, 1.25)), box(0, 0, 2, 1), 0.25, [0, 1]),
    ("a capsule along x on a box", grown(0.5, (-0.75, 1.25), (1.25, 1.25)), box(0, 0, 3, 1), 0.25, [0, 1]),
    ("a capsule along y on a box", grown(0.5, (0.25, 3.25), (0.25, 1.25)), box(0, 0, 3, 1), 0.25, [0, 1]),
    ("a slanted capsule on a box", grown(0.5, (1, 3), (0.25, 1.25)), box(0, 0, 3, 1), 0.25, [0, 1]),
    ("rounded boxes", grown_box(0.25, 0, 0, 1, 1), grown_box(0.25, 0.25, 2.25, 1, 1), 0.25, [0, -1]),
]


def words_of(body):
    if isinstance(body, list):
        return []
    return [{1: "circle", 2: "capsule"}.get(len(body["vertices"]), "margin")]


def in_each_mode(test):
    def run(self):
        for mode in MODES:
            with self.subTest(mode=mode), Client(f"{ENGINE}.mjs", mode) as client:
                test(self, mode, client)
    return run


class Plane(unittest.TestCase):
    def check(self, hello, reply, depth, way):
        """The depth is right, and A leaves by the way as the conventions say."""
        self.assertIs(reply.get("overlap"), True, reply)
        sign = -1 if hello["conventions"]["depth"] == "negative" else 1
        self.assertAlmostEqual(sign * reply["depth"], depth, delta=TOLERANCE)
        moves = {"a": 1, "b": -1}[hello["conventions"]["moves"]]
        self.assertEqual(len(reply["direction"]), 2)
        self.assertAlmostEqual(moves * dot(reply["direction"], way), 1, delta=TOLERANCE)
        if "witness" in reply:
            a, b = reply["witness"]["a"], reply["witness"]["b"]
            self.assertAlmostEqual(dot([q - p for p, q in zip(a, b, strict=True)], way), depth, delta=TOLERANCE)

    def both_orders(self, client, a, b, depth, way):
        self.check(client.hello, client.ask(a, b), depth, way)
        self.check(client.hello, client.ask(b, a), depth, [-x for x in way])

    @in_each_mode
    def test_hello(self, mode, client):
        hello = client.hello
        self.assertEqual({key: hello[key] for key in HELLO}, HELLO)
        self.assertEqual((hello["name"], hello["dimension"], hello["precision"]), (f"{ENGINE}-{mode}", 2, PRECISION))
        self.assertRegex(hello["version"], r"\d\.\d")
        self.assertEqual(sorted(hello["capabilities"]["shapes"]), sorted(NAMES))
        self.assertTrue(hello["settings"]["call"])

    @in_each_mode
    def test_penetrating(self, _, client):
        for name, a, b, depth, way in PENETRATING:
            with self.subTest(name):
                self.both_orders(client, a, b, depth, way)

    @in_each_mode
    def test_apart(self, mode, client):
        for (name, *bodies, distance), order in itertools.product(APART, (1, -1)):
            with self.subTest(name, order=order):
                reply = client.ask(*bodies[::order])
                self.assertIs(reply["overlap"], False)
                self.assertEqual("distance" in reply, f"{ENGINE}-{mode}" == "rapier2d-contact")
                if "distance" in reply:
                    self.assertAlmostEqual(reply["distance"], distance, delta=TOLERANCE)

    @in_each_mode
    def test_shapes(self, _, client):
        for name, a, b, depth, way in SHAPES:
            with self.subTest(name):
                if set(words_of(a) + words_of(b)) <= set(NAMES):
                    self.both_orders(client, a, b, depth, way)

    @in_each_mode
    def test_corners(self, _, client):
        """What is above the limit of corners is declined; up to it, nothing is lost."""
        def gon(n):
            return [[math.cos(2 * math.pi * k / n), math.sin(2 * math.pi * k / n)] for k in range(n)]
        for n in range(3, 17):
            reply = client.ask(gon(n), moved(SQUARE, 1.75, 0))
            if MOST and n > MOST:
                self.assertIn("corners", reply["unsupported"])
                continue
            self.check(client.hello, reply, 0.25, [-1, 0])
            if "hull" in reply:
                self.assertEqual(len(reply["hull"]["a"]), n)

    @in_each_mode
    def test_flat_bodies(self, _, client):
        for flat in ([[0, 0], [1, 1]], [[0, 0]], [[0, 0], [1, 1], [2, 2]]):
            self.assertIn("flat", client.ask(flat, SQUARE)["unsupported"])

    def test_positions(self):
        for mode in MODES:
            if mode in ("manifold", "world"):
                with Client(f"{ENGINE}.mjs", mode, "positions=1") as client:
                    contacts = client.ask(SQUARE, moved(SQUARE, 1.5, 0.25))["contacts"]
                    self.assertEqual(len(contacts), 2)
                    for contact in contacts:
                        self.assertTrue(all(0.5 - TOLERANCE <= x <= 1 + TOLERANCE for x in contact["position"][:1]), contact)
                        self.assertAlmostEqual(abs(contact["depth"]), 0.5, delta=TOLERANCE)

    @in_each_mode
    def test_repeated(self, _, client):
        """The pairs before do not change an answer."""
        def answers():
            replies = [client.ask(a, b) for _, a, b, *_ in PENETRATING + APART]
            return [{key: value for key, value in reply.items() if key not in ("id", "microseconds")} for reply in replies]
        self.assertEqual(answers(), answers())


if __name__ == "__main__":
    web_install.main(pathlib.Path(__file__).name)
