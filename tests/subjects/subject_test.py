# SPDX-License-Identifier: GPL-3.0-or-later
"""One adapter, FATHOM_SUBJECT, spoken to directly: its hello, pairs with known answers that prove the conventions it declares, and lines
that are not of the protocol."""
import os
import unittest

from client import HELLO, MODES, Client

PROGRAM = os.environ["FATHOM_SUBJECT"]
OWN = [mode for program, mode in MODES if program == PROGRAM]


def box(low, high):
    return [[(low, high)[i >> axis & 1][axis] for axis in range(3)] for i in range(8)]


CUBE = box([0, 0, 0], [1, 1, 1])
WEDGE = [[-4, 0, 0], [4, 0, 0], [0, -4, 4], [0, 4, 4]]  # an edge along x below, one along y on top
# name, A, B, exact depth; each has one best direction, and all coordinates are binary32 numbers.
PENETRATING = [
    ("a cube before a box, along x", CUBE, box([0.875, -0.25, -0.125], [2, 0.875, 1.25]), 0.125),
    ("a cube on a box, along y", CUBE, box([-0.25, -1.5, -0.375], [1.5, 0.25, 1.25]), 0.25),
    ("a plate under a tall box, along z", box([-2, -2, 0], [2, 2, 1]), box([-1.25, -1, 0.5], [1, 1.5, 4]), 0.5),
    ("the corner of a tetrahedron in a facet", [[0.25, 0.125, -0.25], [3, 0, 2], [-2, 2, 2], [-1, -3, 2]], box([-4, -4, -3], [4, 4.5, 0]),
     0.25),
    ("an edge across an edge", WEDGE, [[x + 0.25, y - 0.5, z - 3.5] for x, y, z in WEDGE], 0.5)]
# With their exact distances.
APART = [("apart by a quarter, along x", CUBE, box([1.25, -0.5, -0.25], [2, 0.5, 1.5]), 0.25),
         ("apart across a corner", CUBE, box([1.5, 1.25, -3], [2.5, 3, -0.5]), 0.75)]
TELL_DISTANCES = ["fcl-signed", "bullet-pair", "bullet64-pair"]
TELL_POSITIONS = ["libccd-epa", "libccd-mpr", "fcl-collide", "fcl-indep", "ode-collide", "bullet-world", "bullet64-world"]
# Of two of the library's own boxes; of hulls these answer one contact.
MANIFOLDS = {"fcl-collide": ["num_max_contacts=4"], "fcl-indep": ["num_max_contacts=4"], "ode-collide": [], "bullet-world": [],
             "bullet64-world": []}
TRIANGLE = [[0.25, 0.25, 0.75], [0.5, 1, 3], [1, 0.5, 3]]

# FCL and libccd stop within 1e-6 of these; Bullet in binary32, whose bodies are round by their margin, within 1e-4 of its own.
TOLERANCE = 5e-5 if PROGRAM == "bullet" else 2e-6


def dot(u, v):
    return sum(x * y for x, y in zip(u, v))


def check_apart(test, hello, a, b, distance, reply, tolerance):
    """The distance is right, its direction leads the moving body away from the other, and the nearest points are as far apart."""
    test.assertIs(reply["overlap"], False)
    test.assertAlmostEqual(reply["distance"], distance, delta=tolerance)
    points = reply["witness"]
    test.assertAlmostEqual(dot(*2 * [[x - y for x, y in zip(points["a"], points["b"])]])**0.5, distance, delta=tolerance)
    if "direction" not in reply:
        return
    away = [{"a": 1, "b": -1}[hello["conventions"]["moves"]] * x / dot(*2 * [reply["direction"]])**0.5 for x in reply["direction"]]
    test.assertAlmostEqual(min(dot(away, v) for v in a) - max(dot(away, v) for v in b), distance, delta=4 * tolerance)


def check_contacts(test, a, b, reply, tolerance):
    """Each position is in the boxes around both bodies, which the bodies are; the deepest contact is as deep as the answer."""
    for contact in reply["contacts"]:
        for body in (a, b):
            for axis, x in zip(zip(*body), contact["position"]):
                test.assertGreaterEqual(x, min(axis) - tolerance)
                test.assertLessEqual(x, max(axis) + tolerance)
    test.assertEqual(max(abs(contact["depth"]) for contact in reply["contacts"]), abs(reply["depth"]))


def brick(low, high):
    return {"shape": "box", "half": [(y - x) / 2 for x, y in zip(low, high)],
            "pose": {"quaternion": [1, 0, 0, 0], "translation": [(x + y) / 2 for x, y in zip(low, high)]}}


def check_manifold(test, ask, tolerance):
    """Four contacts, one at each corner of the rectangle that two faces share, half as deep in as the bodies overlap or less, and as deep
    as they overlap; in either order of the bodies."""
    below, above, depth = ([-1, -1, -1], [1, 1, 1]), ([0.25, -3, 0.875], [3, 0.5, 2]), 0.125
    for a, b in ((below, above), (above, below)):
        reply = ask(brick(*a), brick(*b))
        corners = sorted((round(c["position"][0], 3), round(c["position"][1], 3)) for c in reply["contacts"])
        test.assertEqual(corners, [(0.25, -1), (0.25, 0.5), (1, -1), (1, 0.5)])
        for contact in reply["contacts"]:
            test.assertAlmostEqual(abs(contact["depth"]), depth, delta=tolerance)
            test.assertAlmostEqual(contact["position"][2], 1 - depth / 2, delta=depth / 2 + tolerance)


class Conversation(unittest.TestCase):
    maxDiff = None

    def each_mode(self):
        self.assertTrue(OWN)
        for mode in OWN:
            with self.subTest(mode=mode), Client(PROGRAM, mode) as subject:
                yield mode, subject

    def ends(self, subject, code):
        got, talk = subject.wait()
        self.assertEqual((got, subject.line()), (code, ""), talk)
        return talk


class Hello(Conversation):
    def test_fields(self):
        for mode, subject in self.each_mode():
            hello = subject.hello
            self.assertEqual({key: hello[key] for key in HELLO}, HELLO)
            self.assertEqual(hello["name"], f"{PROGRAM}-{mode}")
            self.assertEqual(hello["library"], PROGRAM.removesuffix("64"))
            self.assertRegex(hello["version"], r"\d\.\d")
            self.assertEqual(hello["precision"], "binary32" if PROGRAM == "bullet" else "binary64")
            self.assertEqual(set(hello["conventions"]), {"touching", "depth", "moves", "unit", "claims"})
            self.assertEqual(set(hello["capabilities"]), {"faces", "shapes", "twist"})
            self.assertIs(hello["capabilities"]["faces"], PROGRAM in ("fcl", "ode"))
            self.assertTrue(hello["settings"])
            self.assertEqual({str}, {type(text) for text in hello["settings"].values()})

    def test_margins_are_told(self):
        for mode, subject in self.each_mode():
            margin = {"epa": "0", "pair": "0.04", "world": "0.04"}[mode] if PROGRAM.startswith("bullet") else None
            self.assertEqual(subject.hello["settings"].get("margin"), margin)

    def test_settings_from_the_command_line(self):
        key = {"libccd-epa": "epa_tolerance", "libccd-mpr": "mpr_tolerance", "fcl-signed": "distance_tolerance",
               "fcl-collide": "gjk_tolerance", "fcl-indep": "gjk_tolerance", "bullet-pair": "margin", "bullet64-pair": "margin",
               "bullet-world": "margin", "bullet64-world": "margin",
               "ode-collide": "contacts", "bullet-epa": "guess", "bullet64-epa": "guess"}
        for mode in OWN:
            name = key[f"{PROGRAM}-{mode}"]
            value = {"contacts": "7", "guess": "1:-2:0.5"}.get(name, "0.0009765625")
            with Client(PROGRAM, mode, f"{name}={value}") as subject:
                self.assertEqual(subject.hello["settings"][name], value)

    def test_where_a_search_starts(self):
        """A direction that was given is used: two ways out are equally short, and which is answered depends on it."""
        key, usual, given = {"libccd": ("first_direction", "1:0:0", "0.3:-0.81:0.5"), "fcl": ("guess", "1:0:0", "0.3:0.5:0.81"),
                             "bullet64": ("guess", "B-A", "1:1:1")}.get(PROGRAM, (None,) * 3)
        if key is None:
            return
        mode = {"fcl": "indep"}.get(PROGRAM, "epa")
        with Client(PROGRAM, mode) as as_usual, Client(PROGRAM, mode, f"{key}={given}") as otherwise:
            self.assertEqual((as_usual.hello["settings"][key], otherwise.hello["settings"][key]), (usual, given))
            near = [[x + 0.5, y + 0.5, z] for x, y, z in CUBE]
            replies = [client.ask(CUBE, near) for client in (as_usual, otherwise)]
            self.assertNotEqual(*({k: v for k, v in reply.items() if k != "id"} for reply in replies))
            if PROGRAM == "bullet64":
                self.assertAlmostEqual(abs(replies[1]["depth"]), 0.5, delta=TOLERANCE)
        for wrong in ("1:1", "1:1:x", "1:1:1:1", "1,1,1", "nan:0:0"):
            self.assertIn("x:y:z", self.ends(Client(PROGRAM, mode, f"{key}={wrong}"), 2))

    def test_no_limit_is_told_in_words(self):
        if PROGRAM != "libccd":
            return
        for words, told in (([], "no limit"), (["max_iterations=no limit"], "no limit"), (["max_iterations=500"], "500")):
            with Client(PROGRAM, "epa", *words) as subject:
                self.assertEqual(subject.hello["settings"]["max_iterations"], told)

    def test_wrong_command_lines(self):
        for words in ([], ["all"], [OWN[0], "speed=1"], [OWN[0], "margin"], [OWN[0], "=1"], [OWN[0], "a=1", "a=1"],
                      *([mode, key + "=x"] for mode in OWN for key in ("margin", "contacts", "epa_tolerance", "max_iterations"))):
            subject = Client(PROGRAM, *words)
            self.assertIn(f"fathom-subject-{PROGRAM}: ", self.ends(subject, 2))


class Answers(Conversation):
    def check(self, hello, a, b, depth, reply):
        """The depth is right, and A is behind a plane across the direction once it has moved as the conventions say."""
        self.assertEqual(reply["overlap"], True)
        sign = -1 if hello["conventions"]["depth"] == "negative" else 1
        self.assertAlmostEqual(sign * reply["depth"], depth, delta=TOLERANCE)
        moves = {"a": 1, "b": -1}[hello["conventions"]["moves"]]
        ways = []
        if "direction" in reply:
            self.assertAlmostEqual(dot(reply["direction"], reply["direction"]), 1, delta=TOLERANCE)
            ways.append([moves * depth * x for x in reply["direction"]])
        if "witness" in reply:
            ways.append([y - x for x, y in zip(reply["witness"]["a"], reply["witness"]["b"])])
        self.assertTrue(ways)
        for way in ways:
            length = dot(way, way)**0.5
            self.assertAlmostEqual(length, depth, delta=TOLERANCE)
            lowest, highest = min(dot(way, v) for v in a) / length + length, max(dot(way, v) for v in b) / length
            self.assertAlmostEqual(lowest, highest, delta=4 * TOLERANCE)

    def test_penetrating(self):
        for _, subject in self.each_mode():
            for name, a, b, depth in PENETRATING:
                for one, two in ((a, b), (b, a)):
                    with self.subTest(name, swapped=one is b):
                        self.check(subject.hello, one, two, depth, subject.ask(one, two))

    def test_points_that_are_no_corners(self):
        """Points inside, in a facet, in an edge, and one that comes twice change nothing."""
        _, a, b, depth = PENETRATING[0]
        more = [[0.5, 0.5, 0.5], [1, 0.5, 0.75], [0, 0, 0.5], [0, 0, 0]]
        for _, subject in self.each_mode():
            for one, two in ((more + a, b), (b, more + a)):
                self.check(subject.hello, one, two, depth, subject.ask(one, two))

    def test_apart(self):
        for mode, subject in self.each_mode():
            for name, a, b, distance in APART:
                for one, two in ((a, b), (b, a)):
                    with self.subTest(name, swapped=one is b):
                        reply = subject.ask(one, two)
                        self.assertIs(reply["overlap"], False)
                        self.assertEqual("distance" in reply, f"{PROGRAM}-{mode}" in TELL_DISTANCES)
                        if "distance" in reply:
                            check_apart(self, subject.hello, one, two, distance, reply, TOLERANCE)

    def test_positions(self):
        _, a, b, _ = PENETRATING[2]
        for mode in OWN:
            if f"{PROGRAM}-{mode}" in TELL_POSITIONS:
                with Client(PROGRAM, mode, "positions=1") as subject:
                    check_contacts(self, a, b, subject.ask(a, b), TOLERANCE)
                    check_contacts(self, b, a, subject.ask(b, a), TOLERANCE)

    def test_manifold(self):
        for mode in OWN:
            name = f"{PROGRAM}-{mode}"
            if name in MANIFOLDS:
                with Client(PROGRAM, mode, "positions=1", *MANIFOLDS[name]) as subject:
                    self.assertGreaterEqual(subject.hello["manifold"]["most"], 4)
                    check_manifold(self, subject.ask, TOLERANCE)

    def test_margin_is_undone(self):
        """Any margin gives the depth of the bodies themselves, to that margin's rounding."""
        if not PROGRAM.startswith("bullet"):
            self.skipTest("this library has none")
        for margin in ("0", "0.0625", "0.25"):
            with self.subTest(margin=margin), Client(PROGRAM, "pair", f"margin={margin}") as subject:
                for _, a, b, depth in PENETRATING:
                    self.check(subject.hello, a, b, depth, subject.ask(a, b))
                for _, a, b, _ in APART:
                    self.assertEqual(subject.ask(a, b)["overlap"], False)

    def test_flat_bodies(self):
        """Point sets are tried; a library whose bodies are made of faces is not asked."""
        for _, subject in self.each_mode():
            for a, b in ((TRIANGLE, CUBE), (CUBE, TRIANGLE)):
                reply = subject.ask(a, b)
                if subject.hello["capabilities"]["faces"]:
                    self.assertIn("flat", reply["unsupported"])
                    self.assertNotIn("overlap", reply)
                else:
                    self.assertIs(reply["overlap"], True)


class Lines(Conversation):
    def test_stop_and_end(self):
        for _, subject in self.each_mode():
            subject.ask(*APART[0][1:])
            subject.send({"type": "stop"})
            self.assertEqual(self.ends(subject, 0), "")
        for _, subject in self.each_mode():
            self.assertEqual(self.ends(subject, 0), "")

    def test_unknown_fields_and_any_id(self):
        body = {"vertices": CUBE, "faces": [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]}
        for _, subject in self.each_mode():
            subject.send({"type": "run", "id": "\u00fc \"7\"", "a": {**body, "colour": 1}, "b": body, "flags": []})
            reply = subject.receive()
            self.assertEqual((reply["id"], reply["overlap"]), ("\u00fc \"7\"", True))

    def test_lines_that_are_not_of_the_protocol(self):
        run = {"type": "run", "id": "1", "a": {"vertices": CUBE}, "b": {"vertices": CUBE}}
        with_faces = {"vertices": CUBE, "faces": [[0, 1, 8]]}
        for line in ("", "{", "[]", "7", {}, {"type": "go"}, {"type": 1}, {**HELLO, "protocol": "fathom/subject/2"},
                     {"type": "run", "id": "1"}, {**run, "b": {}}, {**run, "b": {"vertices": []}}, {**run, "b": {"vertices": [[0, 0]]}},
                     {**run, "b": {"vertices": [["x", 0, 0]]}}, {**run, "a": with_faces},
                     {**run, "a": {"vertices": CUBE, "faces": [[0, 1]]}},
                     {key: run[key] for key in ("type", "a", "b")}):
            with self.subTest(line=line), Client(PROGRAM, OWN[0]) as subject:
                subject.send(line)
                self.assertIn("line 2: ", self.ends(subject, 2))


if __name__ == "__main__":
    unittest.main()
