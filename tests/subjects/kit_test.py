# SPDX-License-Identifier: GPL-3.0-or-later
"""The subject kit in C++, Python, JavaScript and Rust: the same subject in each says the same, whatever goes wrong inside it.
FATHOM_KIT_TRIAL is the one in C++; those in JavaScript and Rust, and the one in C++ on libc++, are left out where there is no node,
no rustc or no libc++."""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

ROOT = pathlib.Path(__file__).resolve().parents[2]
KIT = ROOT / "verify/subjects/kit"
TRIALS = ROOT / "tests/subjects/kit"

SUBJECTS = {"C++": [os.environ["FATHOM_KIT_TRIAL"]], "Python": [sys.executable, "-B", TRIALS / "trial.py"]}
if shutil.which("node"):
    SUBJECTS["JavaScript"] = ["node", TRIALS / "trial.mjs"]
STRICT = ["-Wall", "-Wextra", "-Wconversion", "-Werror", "-pedantic", "-I", KIT]
RUSTC = shutil.which("rustc") or shutil.which(os.path.expanduser("~/.cargo/bin/rustc"))
BUILT = tempfile.TemporaryDirectory()
unittest.addModuleCleanup(BUILT.cleanup)


def has_libcxx():
    probe = ["clang++", "-stdlib=libc++", "-fsyntax-only", "-x", "c++", "-"]
    return shutil.which("clang++") and subprocess.run(probe, input=b"#include <vector>", capture_output=True, check=False).returncode == 0


def setUpModule():
    if has_libcxx():
        SUBJECTS["C++ on libc++"] = [BUILT.name + "/trial_libcxx"]
        compiler = ["clang++", "-std=c++20", "-stdlib=libc++"]
        subprocess.run([*compiler, *STRICT, TRIALS / "trial.cpp", "-o", *SUBJECTS["C++ on libc++"]], check=True)
    if RUSTC:
        SUBJECTS["Rust"] = [BUILT.name + "/trial_rust"]
        subprocess.run([RUSTC, "--edition", "2021", "-D", "warnings", TRIALS / "trial.rs", "-o", *SUBJECTS["Rust"]], check=True)


POINTS = {"vertices": [[0, 0, 0], [1e-310, 1, 0], [2, 0, 0.1], [0, 0, 1.7976931348623157e+308]], "faces": [[0, 1, 2], [0, 2, 3]]}
CAPSULE = {"shape": "capsule", "radius": 0.1, "half_length": 2, "axis": "x", "margin": 0.2,
           "pose": {"quaternion": [2, 0, 0, 2], "translation": [1, 2, 3.25]}}
BOX = {"shape": "box", "half": [1, 2, 3], "pose": {"quaternion": [1, 0, 0, 0], "translation": [0, 0, 0]}}
TURNED = {"shape": "capsule", "radius": 1, "half_length": 2, "axis": "z", "pose": [[0, 0, 1, 4], [0, 1, 0, 5], [-1, 0, 0, 6]]}


# The one in Rust leaves shapes as they came, and has no unions, hulls and contacts.
SHAPES = ("C++", "C++ on libc++", "Python", "JavaScript")


def marked(what):
    return {"vertices": [[what, 0, 0], [1, 1, 1]]}


class Kit(unittest.TestCase):
    def talk(self, lines, languages=(), axis=None):
        """What each subject answers, and what it prints elsewhere."""
        text = "".join((line if isinstance(line, str) else json.dumps(line)) + "\n" for line in lines)
        for language, command in SUBJECTS.items():
            if languages and language not in languages:
                continue
            with self.subTest(language=language):
                environment = {**os.environ, "PYTHONPATH": str(KIT), "FATHOM_KIT": str(KIT / "fathom_subject.mjs"), "LC_ALL": "C.UTF-8"}
                if axis:
                    environment["FATHOM_KIT_AXIS"] = axis
                done = subprocess.run(command, input=text, capture_output=True, text=True, env=environment, timeout=60, check=False)
                yield done

    def replies(self, *pairs, **options):
        lines = [{"type": "run", "id": f"x{i}", "a": a, "b": b, **dict(zip(["twist"], twist))} for i, (a, b, *twist) in enumerate(pairs)]
        for done in self.talk([*lines, {"type": "stop"}, "never read"], **options):
            self.assertEqual(done.returncode, 0, done.stderr)
            replies = [json.loads(line) for line in done.stdout.splitlines()]
            self.assertEqual([(r.pop("type"), r.pop("id")) for r in replies], [("reply", f"x{i}") for i in range(len(pairs))])
            yield replies, done.stderr

    def test_what_is_there(self):
        for language in ("JavaScript", "Rust", "C++ on libc++"):
            with self.subTest(language=language):
                if language not in SUBJECTS:
                    self.skipTest("its compiler is not here: this kit is not tested")

    def test_compilers(self):
        """The one in C++ asks for nothing but the standard that it promises."""
        compilers = [[name] for name in ("g++", "clang++") if shutil.which(name)] + [["clang++", "-stdlib=libc++"]] * bool(has_libcxx())
        for compiler in compilers:
            for standard in ("17", "20", "2b"):
                with self.subTest(compiler=compiler, standard=standard):
                    done = subprocess.run([*compiler, f"-std=c++{standard}", "-fsyntax-only", *STRICT, TRIALS / "trial.cpp"],
                                          capture_output=True, text=True, check=False)
                    self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_hello(self):
        for done in self.talk([{"type": "hello", "protocol": "fathom/subject/1"}]):
            self.assertEqual(json.loads(done.stdout),
                             {"type": "hello", "protocol": "fathom/subject/1", "name": "trial", "version": "7",
                              "precision": {"points": "binary32", "answers": "binary64"},
                              "conventions": {"touching": "overlap", "depth": "negative", "moves": "b", "unit": False,
                                              "claims": "separating"},
                              "capabilities": {"faces": True, "shapes": ["capsule", "box", "margin"], "twist": True}, "promises": ["depth"],
                              "rounding": {"vertices": 0.1, "box": 0.25}, "manifold": {"most": 4, "margin": 0.125},
                              "settings": {"limit": "3"}})

    def test_any_manifold(self):
        """An empty one is promised too; in C++ it is not the same as none."""
        with unittest.mock.patch.dict(os.environ, {"FATHOM_KIT_ANY_MANIFOLD": "1"}):
            for done in self.talk([{"type": "hello", "protocol": "fathom/subject/1"}], languages=["C++"]):
                self.assertEqual(json.loads(done.stdout)["manifold"], {})

    def test_plane(self):
        """In the plane points have two coordinates, both ways, and edges are faces."""
        triangle = {"vertices": [[14, 0], [1, 2.5], [-1, 0.1]], "faces": [[0, 1], [1, 2], [2, 0]]}
        grown = {"vertices": [[20, 0]], "margin": 0.5}
        with unittest.mock.patch.dict(os.environ, {"FATHOM_KIT_PLANE": "1"}):
            for done in self.talk([{"type": "hello", "protocol": "fathom/subject/1"}]):
                self.assertEqual(json.loads(done.stdout)["dimension"], 2)
            corner = {**triangle, "vertices": [[0, 0], [1, 0], [0, 1]]}
            for [apart, disc, other], _ in self.replies((triangle, triangle), (grown, grown), (corner, grown)):
                self.assertEqual(apart["witness"], {"a": [1, 2.5], "b": [1, 2.5]})
                self.assertEqual((disc["depth"], other["depth"]), (1 / 3, 1 / 3 + 3))

    def test_numbers_are_kept_and_timed(self):
        for [(reply)], _ in self.replies((POINTS, POINTS)):
            self.assertGreater(reply.pop("microseconds"), 0)
            self.assertEqual(reply, {"overlap": True, "depth": 1 / 3 + 2})

    def test_the_least_and_the_greatest_numbers(self):
        ends = [[5e-324, -1e-310, 2.225073858507201e-308], [1.7976931348623157e+308, -0.1, 1e23]]
        a, b = ({"vertices": [[14, 0, 0], end]} for end in ends)
        for [reply], _ in self.replies((a, b)):
            self.assertEqual(reply["witness"], {"a": ends[0], "b": ends[1]})

    def test_time_of_its_own(self):
        for [reply], _ in self.replies((marked(13), POINTS)):
            self.assertEqual(reply, {"overlap": True, "microseconds": 12.5})

    def test_no_number(self):
        for [reply], _ in self.replies((marked(1), POINTS)):
            self.assertEqual((reply["depth"], reply["direction"]), ("nan", ["inf", "-inf", -0.5]))

    def test_stray_prints_go_elsewhere(self):
        for [reply], stderr in self.replies((marked(2), POINTS)):
            self.assertEqual(reply["depth"], 1 / 3)
            self.assertIn("a stray line", stderr)
            self.assertIn("and one from below", stderr)

    def test_a_library_that_greets(self):
        """What is printed when it is loaded does not stand before the hello."""
        for done in self.talk([{"type": "hello", "protocol": "fathom/subject/1"}], languages=[each for each in SUBJECTS if each != "Rust"]):
            self.assertEqual(json.loads(done.stdout)["type"], "hello")
            self.assertIn("a greeting of a library", done.stderr)

    def test_whatever_an_exception_says(self):
        for [surrogate, long, wordless, last], _ in self.replies(*((marked(what), POINTS) for what in (9, 10, 11, 5))):
            self.assertIn("half a pair: ", surrogate["failed"])
            surrogate["failed"].encode()
            self.assertIn("xxxx", long["failed"])
            self.assertLess(len(long["failed"]), 1100)
            self.assertEqual(list(wordless), ["failed"])
            self.assertFalse(last["overlap"])

    def test_a_direction_of_two_numbers(self):
        for [reply], _ in self.replies((marked(12), POINTS), languages=("Python", "JavaScript")):
            self.assertEqual(list(reply), ["failed"])

    def test_exceptions_are_answers(self):
        for [failed, unsupported, apart], _ in self.replies((marked(3), POINTS), (marked(4), POINTS), (marked(5), POINTS)):
            self.assertIn('no "way" out', failed["failed"])
            self.assertEqual(unsupported, {"unsupported": "too flat"})
            self.assertEqual((apart.pop("microseconds") > 0, apart), (True, {"overlap": False}))

    def test_shapes_turned_to_the_declared_axis(self):
        """A cyclic exchange of axes before the rotation of the case, also in the quaternion: +z of the library is +axis of the case."""
        poses = [{"quaternion": [1, 2, -3, 0.5], "translation": [0, 0, 0]}, TURNED["pose"]]
        capsules = [{**CAPSULE, "pose": pose, "axis": axis} for pose in poses for axis in "xyz"]
        given = {}
        for axis in (None, "x", "y", "z"):
            for replies, _ in self.replies(*((c, c) for c in capsules), (BOX, BOX), languages=SHAPES, axis=axis):
                given.setdefault(axis, [reply["hull"] for reply in replies])
                for i, (reply, capsule) in enumerate(zip(replies, capsules)):
                    by = "xyz".index(capsule["axis"]) - "xyz".index(axis or capsule["axis"])
                    for got in reply["hull"].values():
                        for row, asked in zip(got, given[None][i]["a"]):
                            for k in range(3):
                                self.assertAlmostEqual(row[k], asked[(k + by) % 3])
                self.assertEqual(replies[-1]["hull"], {"a": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "b": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]})

    def test_shapes(self):
        for [capsule, matrix], _ in self.replies((CAPSULE, BOX), (TURNED, POINTS), languages=SHAPES):
            self.assertAlmostEqual(capsule["depth"], 0.3)
            for got, expected in zip(capsule["direction"], [0, 1, 0]):
                self.assertAlmostEqual(got, expected)
            self.assertEqual(capsule["witness"], {"a": [1, 2, 3.25], "b": [1, 2, 3]})
            self.assertEqual((matrix["depth"], matrix["direction"]), (1, [1, 0, 0]))
            self.assertEqual(matrix["witness"], {"a": [4, 5, 6], "b": POINTS["vertices"][-1]})

    def test_pieces(self):
        for [reply], _ in self.replies((POINTS, {"pieces": [marked(1), marked(9), marked(4)]}), languages=SHAPES):
            self.assertGreater(reply.pop("microseconds"), 0)
            self.assertEqual(reply, {"overlap": True, "depth": 3, "witness": {"a": [0, 0, 0], "b": [1, 1, 1]}})

    def test_hulls(self):
        for [reply], _ in self.replies((marked(6), POINTS), languages=SHAPES):
            self.assertGreater(reply.pop("microseconds"), 0)
            self.assertEqual(reply, {"overlap": True, "depth": 0.25, "hull": {"a": [[6, 0, 0], [1, 1, 1]]}})

    def test_contacts(self):
        for [reply], _ in self.replies((marked(7), POINTS), languages=SHAPES):
            del reply["microseconds"]
            contacts = [{"position": [7, 0, 0]}, {"position": [1, 1, 1], "depth": 0.25}]
            self.assertEqual(reply, {"overlap": True, "depth": 0.25, "contacts": contacts})

    def test_distances(self):
        for [reply], _ in self.replies((marked(8), POINTS)):
            del reply["microseconds"]
            self.assertEqual(reply, {"overlap": False, "distance": "inf"})

    def test_twists(self):
        twist = {"a": {"v": [0.5, 2, 3], "w": [4, 5, 6]}, "b": {"v": [7, 8, 9], "w": [10, 11, 0.25]}}
        for [reply], _ in self.replies((marked(15), POINTS, twist)):
            del reply["microseconds"]
            self.assertEqual(reply, {"overlap": True, "derivative": 0.75})
        for [reply], _ in self.replies((marked(15), POINTS)):
            self.assertEqual(list(reply), ["failed"], "bodies at rest have no twist")

    def test_what_is_no_message_ends_it(self):
        for done in self.talk(['{"type":"run","id":"1","a":']):
            self.assertNotEqual(done.returncode, 0)
            self.assertEqual(done.stdout, "")
            self.assertNotEqual(done.stderr, "")


class Examples(unittest.TestCase):
    """The examples are right about boxes along the axes, and certify says so."""

    def test_boxes(self):
        fathom = os.environ["FATHOM_EXECUTABLE"]
        examples = {"C++": os.environ["FATHOM_KIT_EXAMPLE"], "Python": f"'{sys.executable}' -B '{KIT}/example.py'"}
        if "JavaScript" in SUBJECTS:
            examples["JavaScript"] = f"node '{KIT}/example.mjs'"
        if RUSTC:
            examples["Rust"] = f"{BUILT.name}/example"
            subprocess.run([RUSTC, "--edition", "2021", "-D", "warnings", "-O", KIT / "example.rs", "-o", examples["Rust"]], check=True)
        cases = subprocess.run([fathom, "cases", "--family", "boxes_aligned", "--count", "60"], capture_output=True, check=True).stdout
        for language, command in examples.items():
            with self.subTest(language=language):
                done = subprocess.run([fathom, "certify", "--subject", command, "--json", "-"], input=cases, capture_output=True,
                                      check=False)
                self.assertEqual(done.returncode, 0, done.stderr.decode())
                verdicts = [json.loads(line) for line in done.stdout.splitlines()]
                passed = [v for v in verdicts if v.get("verdict") in ("pass", "touching-by-convention")]
                self.assertEqual(len(passed), 60)
                self.assertTrue(any(v["reply"].get("depth") for v in passed))


if __name__ == "__main__":
    unittest.main()
