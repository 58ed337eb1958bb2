# SPDX-License-Identifier: GPL-3.0-or-later
"""The adapters of one engine for the web, FATHOM_SUBJECT, in its modes: hello, pairs with known answers that prove the conventions, shapes,
wrong command lines, and the verdicts on the real cases, which the table of verify/subjects/web/README.md tells. Skipped where node, npm or
the network is absent."""
import json
import os
import pathlib
import re
import subprocess
import unittest
from itertools import islice

import shapes_test as shapes
import web_install
from client import HELLO, ROOT, Client
from subject_test import APART, CUBE, PENETRATING, TRIANGLE, check_apart, check_contacts, check_manifold, dot

ENGINE = os.environ["FATHOM_SUBJECT"]
README = web_install.WEB / "README.md"
MODES = {"jolt": ["radius0", "radius", "world"], "rapier": ["contact", "world"], "physx": ["gjk", "sweep", "scene"], "havok": ["proximity"],
         "mujoco": ["native", "single", "libccd", "distance"], "cannon": ["sat", "contact"]}[ENGINE]
PRECISION = {"cannon": "binary64", "mujoco": {"points": "binary32", "answers": "binary64"}}.get(ENGINE, "binary32")
ROUND = ["sphere", "box", "capsule"]
NAMES = {"jolt": [*ROUND, "cylinder", "frustum", "cone", "tapered_capsule"], "rapier": [*ROUND, "cylinder", "cone", "margin"],
         "physx": [*ROUND, "cylinder", "cone", "ellipsoid", "margin"], "havok": [*ROUND, "cylinder"],
         "mujoco": [*ROUND, "cylinder", "ellipsoid"], "cannon": ["box"], "physx-sweep": ROUND}
# How far from the exact depth of a simple pair a mode may be; where it rounds its hulls, how much it takes off.
TOLERANCES = {"jolt-radius": 0.05, "havok-proximity": 2e-2, "rapier-world": 5e-3, "cannon-contact": 5e-3}
# Which share of the simple pairs of shapes a mode must know the depth of, to a quarter. What is below 1 was measured, and is rounded down.
SHARES = {"rapier-contact": 0.98, "rapier-world": 0.98, "mujoco-libccd": 0.98}
TELL_DISTANCES = ["rapier-contact", "physx-gjk", "havok-proximity", "mujoco-distance"]
TELL_HULLS = ["jolt-radius0", "jolt-world", *(f"physx-{mode}" for mode in MODES), *(f"mujoco-{mode}" for mode in MODES)]
TELL_POSITIONS = ["jolt-world", "rapier-world", "physx-scene", "mujoco-native", "mujoco-single", "cannon-contact"]
# A step's contact report is a manifold and no minimum translation: it misses the way out across two edges.
NO_EDGES = ["physx-scene"]
EVERY = 3  # of the pairs of shapes, so that the test ends soon; both orders and all bodies are among them
MODULE = pathlib.Path(__file__).name


def subject(mode, *settings):
    return Client(f"{ENGINE}.mjs", mode, *settings)


def in_each_mode(test):
    """test(self, mode, client), once for each mode."""
    def run(self):
        for mode in MODES:
            with self.subTest(mode=mode), subject(mode) as client:
                test(self, mode, client)
    return run


class Web(unittest.TestCase):
    maxDiff = None

    @staticmethod
    def declared(mode):
        return NAMES.get(f"{ENGINE}-{mode}", NAMES[ENGINE])

    def check(self, hello, a, b, depth, reply, tolerance):
        """The depth is right, and A is behind a plane across the direction once it has moved as the conventions say."""
        self.assertEqual(reply.get("overlap"), True, reply)
        sign = -1 if hello["conventions"]["depth"] == "negative" else 1
        self.assertAlmostEqual(sign * reply["depth"], depth, delta=tolerance)
        self.assertGreaterEqual(reply["microseconds"], 0)
        moves = {"a": 1, "b": -1}[hello["conventions"]["moves"]]
        ways = []
        if "direction" in reply:
            length = dot(reply["direction"], reply["direction"])**0.5
            if hello["conventions"]["unit"]:
                self.assertAlmostEqual(length, 1, delta=1e-5)
            ways.append([moves * x / length for x in reply["direction"]])
        if "witness" in reply:
            way = [y - x for x, y in zip(reply["witness"]["a"], reply["witness"]["b"])]
            length = dot(way, way)**0.5
            self.assertAlmostEqual(length, depth, delta=tolerance)
            ways.append([x / length for x in way])
        self.assertTrue(ways)
        for way in ways:
            lowest, highest = min(dot(way, v) for v in a) + depth, max(dot(way, v) for v in b)
            self.assertAlmostEqual(lowest, highest, delta=20 * tolerance)

    @in_each_mode
    def test_hello(self, mode, client):
        hello = client.hello
        self.assertEqual({key: hello[key] for key in HELLO}, HELLO)
        self.assertEqual(hello["name"], f"{ENGINE}-{mode}")
        self.assertEqual(hello["precision"], PRECISION)
        self.assertRegex(hello["version"], r"\d\.\d")
        self.assertEqual(sorted(hello["capabilities"]["shapes"]), sorted(self.declared(mode)))
        self.assertIs(hello["capabilities"]["faces"], True)
        self.assertEqual({str}, {type(text) for text in hello["settings"].values()})
        self.assertTrue(hello["settings"]["call"])

    @in_each_mode
    def test_penetrating(self, mode, client):
        tolerance = TOLERANCES.get(f"{ENGINE}-{mode}", 1e-4)
        for name, a, b, depth in PENETRATING[:-1] if f"{ENGINE}-{mode}" in NO_EDGES else PENETRATING:
            for one, two in ((a, b), (b, a)):
                with self.subTest(name, swapped=one is b):
                    self.check(client.hello, one, two, depth, client.ask(one, two), tolerance)

    @in_each_mode
    def test_apart(self, mode, client):
        for name, a, b, distance in APART:
            for one, two in ((a, b), (b, a)):
                with self.subTest(name, swapped=one is b):
                    reply = client.ask(one, two)
                    self.assertIs(reply["overlap"], False)
                    self.assertEqual("distance" in reply, f"{ENGINE}-{mode}" in TELL_DISTANCES)
                    if "distance" in reply:
                        check_apart(self, client.hello, one, two, distance, reply, TOLERANCES.get(f"{ENGINE}-{mode}", 1e-4))

    def test_positions(self):
        _, a, b, _ = PENETRATING[2]
        for mode in MODES:
            if f"{ENGINE}-{mode}" in TELL_POSITIONS:
                with subject(mode, "positions=1") as client:
                    check_contacts(self, a, b, client.ask(a, b), 1e-4)
                    check_contacts(self, b, a, client.ask(b, a), 1e-4)
                    check_manifold(self, client.ask, 1e-4)
                    self.assertIn("manifold", client.hello)

    @in_each_mode
    def test_hulls(self, mode, client):
        """The hull of a cube and a point inside it, placed elsewhere, has the cube's corners, to the rounding of a frame; a shape has
        none."""
        corners = [[x + 5, y + 2, z - 7] for x, y, z in CUBE]
        reply = client.ask([[5.5, 2.25, -6.5], *corners], CUBE)
        self.assertEqual("hull" in reply, f"{ENGINE}-{mode}" in TELL_HULLS)
        if "hull" not in reply:
            return
        for used, asked in ((reply["hull"]["a"], corners), (reply["hull"]["b"], CUBE)):
            for (one, two) in zip(sorted(used, key=lambda v: [round(x) for x in v]), sorted(asked), strict=True):
                for x, y in zip(one, two):
                    self.assertAlmostEqual(x, y, delta=2e-6)
        self.assertEqual(set(client.ask(CUBE, shapes.BRICK)["hull"]), {"a"})

    @in_each_mode
    def test_flat_bodies(self, mode, client):
        """What an engine makes of a flat body is its own; it declines or answers, and answers the next pair all the same."""
        for a, b in ((TRIANGLE, CUBE), (CUBE, TRIANGLE)):
            reply = client.ask(a, b)
            self.assertTrue("overlap" in reply or "flat" in reply.get("unsupported", ""), reply)
            name, one, two, depth = PENETRATING[0]
            with self.subTest(name):
                self.check(client.hello, one, two, depth, client.ask(one, two), TOLERANCES.get(f"{ENGINE}-{mode}", 1e-4))

    @in_each_mode
    def test_repeated(self, _, client):
        """The pairs before do not change an answer."""
        questions = [(a, b) for _, a, b, *_ in PENETRATING + APART]
        first = [client.ask(a, b) for a, b in questions]
        again = [client.ask(a, b) for a, b in reversed(questions)]
        for one, two in zip(first, reversed(again)):
            self.assertEqual(*({k: v for k, v in reply.items() if k not in ("id", "microseconds")} for reply in (one, two)))

    @in_each_mode
    def test_shapes(self, mode, client):
        names, right, asked = self.declared(mode), 0, 0
        for a, b, away, _ in islice(shapes.pairs(names, shapes.DEPTH), 0, None, EVERY):
            reply, asked = client.ask(a, b), asked + 1
            right += self.knows(client.hello, reply, away)
        self.assertGreater(asked, 0)
        self.assertGreaterEqual(right, SHARES.get(f"{ENGINE}-{mode}", 1) * asked, f"{right} of {asked}")
        for a, b, _, _ in islice(shapes.pairs(names, -shapes.DEPTH), 0, None, EVERY):
            with self.subTest(a=a, b=b):
                self.assertIs(client.ask(a, b).get("overlap"), False)

    @staticmethod
    def knows(hello, reply, away):
        if reply.get("overlap") is not True:
            return False
        sign, moves = -1 if hello["conventions"]["depth"] == "negative" else 1, {"a": -1, "b": 1}[hello["conventions"]["moves"]]
        near = abs(sign * reply["depth"] - shapes.DEPTH) < shapes.DEPTH / 4
        if "direction" not in reply:
            way = [x - y for x, y in zip(reply["witness"]["a"], reply["witness"]["b"])]
            return near and dot(way, away) > 0.8 * shapes.DEPTH
        return near and moves * dot(reply["direction"], away) > 0.8 * dot(reply["direction"], reply["direction"])**0.5

    @in_each_mode
    def test_margin(self, mode, client):
        brick, slab = shapes.BRICK, shapes.posed(shape="box", half=[8, 8, 4], translation=[0, 0, 4])
        low = {**shapes.moved(brick, [0, 0, -0.5 - 1.5]), "margin": 0.5 + shapes.DEPTH}
        if "margin" in self.declared(mode):
            self.assertTrue(self.knows(client.hello, client.ask(low, slab), [0, 0, 1]))
            self.assertIs(client.ask({**low, "margin": 0.5 - shapes.DEPTH}, slab)["overlap"], False)
        else:
            self.assertIn("margin", client.ask(low, slab)["unsupported"])

    @in_each_mode
    def test_declined(self, mode, client):
        turned = {**shapes.BRICK, "pose": [[2, 0, 0, 0], [0, 2, 0, 0], [0, 0, 2, 0]]}
        mirrored = {**shapes.BRICK, "pose": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, -1, 0]]}
        for word, body in (("sum", shapes.posed(shape="sum", terms=[])), ("rotation", turned), ("rotation", mirrored)):
            self.assertIn(word, client.ask(body, shapes.BRICK)["unsupported"])
        for shape in (shapes.HAT, shapes.EGG, shapes.CAP):
            self.assertEqual("unsupported" in client.ask(shapes.BRICK, shape), shape["shape"] not in self.declared(mode))

    def test_wrong_command_lines(self):
        for words in ([], ["all"], [MODES[0], "speed=1"], [MODES[0], "margin"], [MODES[0], "=1"], [MODES[0], "a=1", "a=1"]):
            client = Client(f"{ENGINE}.mjs", *words)
            code, talk = client.wait()
            self.assertEqual((code, client.line()), (2, ""), talk)
            self.assertIn(f"{ENGINE}: ", talk)

    def test_real_cases(self):
        """The passes of the table, as hulls and as reported, as given and fitted, from what users run; exact, as WebAssembly answers alike
        on every machine."""
        for mode in MODES:
            name = ENGINE if mode in ("radius0", "proximity") else f"{ENGINE}-{mode}"
            row = re.search(rf"^\| {name} \|.*$", README.read_text(encoding="utf-8"), re.MULTILINE)
            runs = [(cases, options) for cases in ("real_cases.jsonl", "real_shapes.jsonl") for options in ([], ["--fit", "64"])]
            for told, (cases, options) in zip(map(int, row.group().strip("| ").split("|")[-4:]), runs, strict=True):
                with self.subTest(adapter=name, cases=cases, options=options):
                    done = subprocess.run([os.environ["FATHOM_EXECUTABLE"], "certify", "--jobs", "1", *options, "--adapter", name, "--json",
                                           ROOT / "tests" / "data" / cases], capture_output=True, text=True, check=False)
                    self.assertIn(done.returncode, (0, 1), done.stderr)
                    lines = [json.loads(line) for line in done.stdout.splitlines()]
                    self.assertEqual((lines[-1]["type"], lines[-1]["cases"], lines[-1]["unattributed"]), ("summary", 63, 0))
                    self.assertEqual(lines[-1]["passed"], told)


if __name__ == "__main__":
    web_install.main(MODULE)
