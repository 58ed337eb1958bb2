#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""fathom-check and check.py as programs: lines, exit codes, streams, and what only fathom-check can: --case, --results, --echo."""
import json
import os
import pathlib
import re
import resource
import subprocess
import tempfile
import unittest

CHECK = [os.environ["FATHOM_CHECK"]]
ROOT = pathlib.Path(os.environ["FATHOM_ROOT"])
READER = [os.environ["PYTHON"], "-B", str(ROOT / "verify" / "check" / "check.py")]
DATA = ROOT / "tests" / "data" / "certificates"
PATIENCE = 300
CUBES = (DATA / "depth_cubes.cert").read_text()
APART = (DATA / "disjoint_cubes.cert").read_text()
FALSE = CUBES.replace("claim depth 1", "claim depth 2")
LENGTH = APART.count("\n")
CUBES_OK = "s VERIFIED penetrating depth_squared=1 optima=1 two%20cubes"
APART_OK = "s VERIFIED disjoint depth_squared=0 disjoint%20cubes"


def reason(line):
    """Of a refusal, without the file."""
    return line.split(": ", 1)[1].split(" (in ")[0]


class ProgramTest(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def file(self, name, content):
        (self.folder / name).write_bytes(content if isinstance(content, bytes) else content.encode())
        return str(self.folder / name)

    def run_program(self, program, *words, stdin="", **options):
        """(exit code, lines on stdout, stderr)"""
        done = subprocess.run([*program, *map(str, words)], input=stdin.encode(), stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              timeout=PATIENCE, **options)
        return done.returncode, done.stdout.decode().splitlines(), done.stderr.decode()

    def both(self, *words, stdin=""):
        """(exit code, lines) on which both programs agree, up to reasons and the lines of refusals."""
        answers = []
        for program in (CHECK, READER):
            code, lines, _ = self.run_program(program, *words, stdin=stdin)
            lines = [line for line in lines if line.startswith("s ")]
            lines = [re.sub(r"(REFUSED .*?):\d+: .*", r"\1", re.sub(r"(MALFORMED .*?:\d+): .*", r"\1", line)) for line in lines]
            answers.append((code, lines))
        self.assertEqual(answers[0], answers[1])
        return answers[0]


class Certificates(ProgramTest):
    def test_accepted(self):
        files = sorted(DATA.glob("*.cert"))
        code, lines = self.both(*files)
        self.assertEqual((code, len(lines)), (0, len(files) + 1))
        self.assertTrue(all(line.startswith("s VERIFIED ") for line in lines), lines)

    def test_accepted_of_format_2(self):
        files = sorted((DATA / "format_2").glob("*.cert"))
        code, lines = self.both(*files)
        self.assertEqual((code, len(lines)), (0, len(files)))
        self.assertTrue(all(line.startswith("s VERIFIED ") for line in lines), lines)
        self.assertEqual(self.both("-", stdin=CUBES + files[0].read_text() + CUBES)[1][::2], [CUBES_OK] * 2)

    def test_accepted_of_format_4(self):
        files = sorted((DATA / "format_4").glob("*.cert"))
        self.assertEqual(self.both(*files), (0, [
            "s VERIFIED touching signed_depth=-sqrt(1/4)+1/2 patches=2 rates=2 capsule%20on%20the%20floor",
            "s VERIFIED penetrating signed_depth=sqrt(0)+1 cone=0+4 patches=1 tip%20to%20tip",
            "s VERIFIED disjoint signed_depth=-sqrt(1)+0 patches=1 rods",
            "s VERIFIED penetrating signed_depth=sqrt(1)+0 optima=1 patches=4 rates=2 two%20cubes",
            "s VERIFIED penetrating signed_depth=sqrt(1)+0 optima=2 patches=5+5 rates=3 two%20ways%20out"]))

    def test_accepted_of_format_5(self):
        files = sorted((DATA / "format_5").glob("*.cert"))
        self.assertEqual(self.both(*files), (0, [
            "s VERIFIED solid triangles=24 pieces=6 a%20cube%20with%20a%20cavity",
            "s VERIFIED solid triangles=24 pieces=2 a%20cube%20twice",
            "s VERIFIED solid triangles=20 pieces=2 an%20L",
            "s VERIFIED solid triangles=15 pieces=1 a%20cube%20with%20a%20T-junction%20and%20a%20flap",
            "s VERIFIED solid triangles=24 pieces=2 boxes%20that%20share%20an%20edge",
            "s VERIFIED solid triangles=4 pieces=2 two%20tetrahedra"]))
        files = sorted((DATA / "format_5" / "two_bodies").glob("*.cert"))
        self.assertEqual(self.both(*files), (0, [
            "s VERIFIED penetrating depth_squared=1 optima=1 pieces=2x2 triangles=24x- a%20bar%20across%20a%20beam",
            "s VERIFIED disjoint distance_squared=1 pieces=2x1 triangles=4x- beside%20two%20tetrahedra",
            "s VERIFIED disjoint distance_squared=1/4 pieces=6x1 triangles=24x12 a%20cube%20in%20a%20cavity",
            "s VERIFIED touching depth_squared=0 pieces=2x2 triangles=24x24 a%20bar%20on%20a%20beam"]))

    def test_accepted_of_the_plane(self):
        self.assertEqual(self.both(*sorted((DATA / "plane").rglob("*.cert"))), (0, [f"s VERIFIED {line}" for line in (
            "disjoint signed_depth=-sqrt(13)+0 dimension=2 apart",
            "penetrating depth_squared_in=[1/2,3/2] dimension=2 bounds",
            "disjoint signed_depth=-sqrt(25)+4 dimension=2 circles",
            "penetrating signed_depth=sqrt(0)+1 cone=0+2 dimension=2 corner%20on%20corner",
            "disjoint depth_squared=0 dimension=2 disjoint",
            "penetrating depth_squared=16 optima=4 dimension=2 four%20ways%20out",
            "penetrating signed_depth=sqrt(1)+0 dimension=2 half%20plane",
            "disjoint signed_depth=-sqrt(16)+1 dimension=2 half%20plane%20apart",
            "penetrating depth_squared=1 optima=1 pieces=2x1 dimension=2 pieces",
            "disjoint distance_squared=2 pieces=2x1 dimension=2 pieces%20apart",
            "touching depth_squared=0 pieces=2x1 dimension=2 pieces%20touching",
            "penetrating signed_depth=sqrt(1)+1 optima=1 dimension=2 rounded",
            "penetrating depth_squared=1 optima=1 dimension=2 squares",
            "touching depth_squared=0 dimension=2 touching",
            "disjoint distance_squared=9 pieces=2x1 triangles=-x- dimension=2 two%20unions")]))

    def test_accepted_of_format_6(self):
        files = sorted((DATA / "format_6").glob("*.cert"))
        self.assertEqual(self.both(*files), (0, [
            "s VERIFIED apart until=1 two%20planes",
            "s VERIFIED contact at=0 overlapping%20at%20the%20beginning",
            "s VERIFIED contact until=29/128 at=15/64 both%20turn",
            "s VERIFIED contact until=551/1024 at=591/1024 a%20corner%20in%20a%20box",
            "s VERIFIED grazing until=1 near=(7/16,9/16):11/10 past%20the%20end%20of%20a%20rod",
            "s VERIFIED contact until=1/4 at=1/2 a%20turning%20rod"]))
        rod = DATA / "format_6" / "rod.cert"
        self.assertEqual(reason(self.run_program(CHECK, "--width", rod)[1][0]), "bodies in motion have no width")
        self.assertIn("c motion_a\nc 1 0 0 0\nc 1 0 0 1\nc 0 0 0", "\n".join(self.run_program(CHECK, "--echo", rod)[1]))

    def test_the_plane(self):
        squares, pieces = DATA / "plane" / "squares.cert", DATA / "plane" / "pieces.cert"
        code, lines, _ = self.run_program(CHECK, "--echo", squares, DATA / "plane" / "half_plane.cert", pieces)
        self.assertEqual((code, lines[:8], lines[12], lines[20:23], lines[24:28]),
                         (0, ["c id squares", "c plane 8", "c a 4", "c 0 0", "c 2 0", "c 0 2", "c 2 2", "c b 4"], "c claim depth 1",
                          ["c 2 2", "c halfspace_b 1 0 1", "c claim depth 1"], ["c id pieces", "c plane 8", "c pieces_a 2", "c a 4"]))
        code, lines, _ = self.run_program(CHECK, "--width", squares)
        self.assertEqual((code, reason(lines[0])), (1, "bodies of the plane have no width here"))

        def compared(a, b, certificate=squares, **more):
            case = self.file("case.json", json.dumps({"dimension": 2, "a": a, "b": b, **more}))
            code, lines, _ = self.run_program(CHECK, "--case", case, certificate)
            return code, reason(lines[0]) if code == 1 else ""

        def square(low, high):
            return [[x, y] for y in (0, 2) for x in (low, high)]

        a, b, whole = ({"vertices": square(*ends)} for ends in ((0, 2), (1, 3), (0, 2)))
        self.assertEqual(compared(a, b), (0, ""))
        self.assertEqual(compared(a, {**a, "pose": [[1, 0, 1], [0, 1, 0]]}), (0, ""))
        self.assertEqual(compared(a, a), (1, "point 0 of b is not that of the case"))
        self.assertEqual(compared(a, {"vertices": b["vertices"][:3]}), (1, "the case has 3 points in b, the certificate 4"))
        self.assertEqual(compared({"pieces": [square(0, 1), {"vertices": square(1, 2)}]}, b, pieces), (0, ""))
        self.assertEqual(compared({"pieces": [square(0, 1), square(1, 3)]}, b, pieces),
                         (1, "point 1 of piece 1 of a is not that of the case"))
        flat = {"vertices": [[*p, 0] for p in whole["vertices"]]}
        self.assertEqual(compared(flat, flat, dimension=3), (1, "the case is of space, the certificate of the plane"))
        self.assertEqual(compared(a, b, DATA / "depth_cubes.cert"), (1, "the case is of the plane, the certificate of space"))
        for wrong in ({"a": flat}, {"dimension": 4}, {"dimension": "2"}, {"a": {**a, "pose": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]}}):
            self.assertEqual(compared(**{"a": a, "b": b, **wrong})[0], 2, wrong)

    def test_two_bodies(self):
        beside, across = (DATA / "format_5" / "two_bodies" / f"{name}.cert" for name in ("beside", "across"))
        code, lines, _ = self.run_program(CHECK, "--echo", beside)
        self.assertEqual((code, lines[1:3], lines[7], lines[12:14], lines[-2]),
                         (0, ["c solid_a 5", "c 0 0 0"], "c mesh 4", ["c pieces_b 1", "c b 4"], "c claim apart 1"))
        code, lines, _ = self.run_program(CHECK, "--width", beside)
        self.assertEqual((code, reason(lines[0])), (1, "solids have no width here: it is that of a convex body"))
        points = {"vertices": [[3, 0, 0], [4, 0, 0], [3, 1, 0], [3, 0, 1]]}
        case = self.file("case.json", json.dumps({"a": points, "b": points}))
        code, lines, _ = self.run_program(CHECK, "--case", case, beside)
        self.assertEqual((code, reason(lines[0])), (1, "a solid is not what a case holds"))

        def code_of(file, **fields):
            text = re.sub("id .*\n", "", file.read_text())
            return self.run_program(CHECK, "--results", "-", stdin=json.dumps({"id": "x", "certificate": text, **fields}))[0]

        self.assertEqual(code_of(beside, status="disjoint", depth={"squared": "0"}, distance={"squared": "1"}), 0)
        self.assertEqual(code_of(beside, distance={"squared": "2"}), 1)
        self.assertEqual(code_of(across, status="penetrating", depth={"squared": "1"}), 0)
        self.assertEqual(code_of(across, depth={"squared": "2"}), 1)
        self.assertEqual(code_of(across, bound={"squared": "1"}), 1)

    def test_the_faults_of_formats_4_to_6_and_the_plane(self):
        """Those of faults.jsonl, as check.py sees them too."""
        for row in map(json.loads, (DATA / "faults.jsonl").read_text().splitlines()):
            if row["of"].startswith(("format_4/", "format_5/", "format_6/", "plane/")) or "fathom-certificate 4" in str(row["edits"]):
                text = (DATA / row["of"]).read_text() if row["of"] else ""
                for before, after in row["edits"]:
                    text = text.replace(before, after, 1)
                said = re.sub(r"(REFUSED .*?):\d+: .*", r"\1", re.sub(r"(MALFORMED .*?:\d+): .*", r"\1", row["says"]))
                self.assertEqual(self.both("-", stdin=text)[1], [said], row["edits"])

    def test_the_examples_of_the_page(self):
        """Each certificate that FORMAT.md shows, remarks aside, is the file that it names or one of the data."""
        page = (ROOT / "verify" / "check" / "FORMAT.md").read_text()
        blocks = [block for block in re.findall(r"(?:^    .+\n)+", page, re.MULTILINE) if block.startswith("    fathom-certificate")]
        files = [re.sub("^#.*\n", "", file.read_text(), flags=re.MULTILINE) for file in DATA.rglob("*.cert")]
        self.assertEqual(len(blocks), 8)
        for block in blocks:
            text = "".join(re.sub("  .*", "", line[4:]) + "\n" for line in block.splitlines())
            found = [file for file in files if re.sub("^id .*\n", "", file,
                                                      flags=re.MULTILINE) == re.sub("^id .*\n", "", text, flags=re.MULTILINE)]
            self.assertEqual(len(found), 1, text[:200])
            self.assertEqual(self.both("-", stdin=text)[0], 0)
        patch = re.search(r"(?:^    .+\n)+", page[page.index("    patches 1 "):], re.MULTILINE)[0]
        self.assertIn("".join(re.sub("  .*", "", line[4:]) + "\n" for line in patch.splitlines()),
                      (DATA / "format_4" / "two_cubes.cert").read_text())

    def test_refused(self):
        files = sorted((DATA / "refused").glob("*.cert"))
        code, lines = self.both(*files)
        self.assertEqual((code, len(lines)), (1, len(files)))
        self.assertTrue(all(line.startswith("s REFUSED ") for line in lines), lines)

    def test_the_worst_counts(self):
        good, bad, cut = self.file("good", CUBES), self.file("bad", FALSE), self.file("cut", CUBES[:-1])
        self.assertEqual(self.both(good, good), (0, [CUBES_OK] * 2))
        self.assertEqual(self.both(bad, good), (1, ["s REFUSED two%20cubes", CUBES_OK]))
        self.assertEqual(self.both(cut, bad, good), (2, ["s MALFORMED two%20cubes:40", "s REFUSED two%20cubes", CUBES_OK]))

    def test_nothing_is_not_fine(self):
        for content, line in (("", 1), ("\n", 1), ("#\n", 2), ("# cut off", 1), ("garbage\n", 1)):
            path = self.file("empty", content)
            self.assertEqual(self.both(path), (2, [f"s MALFORMED {path}:{line}"]), content)
        for program in (CHECK, READER):
            code, lines, err = self.run_program(program)
            self.assertEqual((code, lines), (2, []))
            self.assertIn("expected certificates: files, or - for standard input", err)

    def test_unreadable(self):
        for path in (self.folder, self.folder / "missing"):
            for program in (CHECK, READER):
                code, lines, _ = self.run_program(program, path, self.file("good", CUBES))
                self.assertEqual((code, lines[-1]), (2, CUBES_OK))
                self.assertTrue(lines[-2].startswith(f"s MALFORMED {path}:0: "), lines)

    def test_output_that_cannot_be_written(self):
        for program in (CHECK, READER):
            for where in (">/dev/full", ">&-"):
                done = subprocess.run(["sh", "-c", '"$@" ' + where, "sh", *program, DATA / "depth_cubes.cert"], stderr=subprocess.PIPE)
                self.assertEqual(done.returncode, 2, (program, where))
                self.assertIn(b"standard output", done.stderr)
                self.assertNotIn(b"Traceback", done.stderr)

    def test_a_refusal_names_the_file(self):
        bad = self.file("bad one.cert", CUBES.replace("claim depth 1", "claim depth 2"))
        for program in (CHECK, READER):
            code, (line,), _ = self.run_program(program, bad)
            self.assertEqual((code, line[:22], line[-15:]), (1, "s REFUSED two%20cubes:", "bad%20one.cert)"))
            self.assertIn("FILE", self.run_program(program, "--help")[1][0])

    def test_streams(self):
        self.assertEqual(self.both("-", stdin=CUBES + "# between\n" + APART), (0, [CUBES_OK, APART_OK]))
        self.assertEqual(self.both("-", stdin=re.sub("id .*\n", "", APART)), (0, ["s VERIFIED disjoint depth_squared=0 <stdin>"]))

    def test_goes_on_after_a_malformed_certificate(self):
        begin = CUBES.index("claim")
        self.assertEqual(self.both("-", stdin=CUBES[:begin] + APART), (2, ["s MALFORMED two%20cubes:21", APART_OK]))
        self.assertEqual(self.both("-", stdin=CUBES[:begin] + "claim depth\n1 2 3\n# x\n" + APART),
                         (2, ["s MALFORMED two%20cubes:21", APART_OK]))
        self.assertEqual(self.both("-", stdin="x\ny\n" + APART + "z\n" + APART),
                         (2, ["s MALFORMED <stdin>:1", APART_OK, f"s MALFORMED <stdin>:{LENGTH + 3}", APART_OK]))
        self.assertEqual(self.both("-", stdin="fathom-certificate 7\nid x\n" + APART), (2, ["s MALFORMED <stdin>:1", APART_OK]))
        self.assertEqual(self.both("-", stdin="fathom-certificate 2\nid x\n" + APART), (2, ["s MALFORMED x:3", APART_OK]))
        self.assertEqual(self.both("-", stdin=APART + "fathom-certificate 1"), (2, [APART_OK, f"s MALFORMED <stdin>:{LENGTH + 1}"]))

    def test_a_name_cannot_forge_words_of_a_verdict(self):
        some = (DATA / "one_direction.cert").read_text()
        path = self.file("x optima=1 y", re.sub("id .*\n", "id optima=1 x\n", some))
        name = f"{self.folder}/x%20optima=1%20y"
        self.assertEqual(self.both(path)[1][0], f"s MALFORMED {name}:{some[:some.index('id ')].count(chr(10)) + 1}")
        path = self.file("x optima=1 y", re.sub("id .*\n", "", some))
        self.assertEqual(self.both(path), (0, [f"s VERIFIED penetrating depth_squared=1/12 {name}"]))

    def test_a_name_cannot_forge_a_line(self):
        path = self.file("x\ns VERIFIED %", "garbage\n")
        self.assertEqual(self.both(path), (2, [f"s MALFORMED {self.folder}/x%0As%20VERIFIED%20%25:1"]))

    def test_each_verdict_before_the_next_certificate(self):
        process = subprocess.Popen([*CHECK, "-"], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        for _ in range(3):
            process.stdin.write(APART.encode())
            process.stdin.flush()
            self.assertEqual(process.stdout.readline().decode(), APART_OK + "\n")
        process.stdin.close()
        self.assertEqual((process.stdout.read(), process.wait()), (b"", 0))
        process.stdout.close()


class Options(ProgramTest):
    def test_misuse(self):
        for words in (["--what", "x"], ["--case"], ["--case", "a", "--case", "b", "x"], ["--results"], ["--echo"], ["-x"]):
            code, lines, err = self.run_program(CHECK, *words)
            self.assertEqual((code, lines), (2, []))
            self.assertTrue(err.startswith("fathom-check: ") and "--help" in err, err)
        self.assertEqual(self.run_program(CHECK, "--help")[0], 0)
        self.file("--echo", CUBES)
        self.assertEqual(self.run_program(CHECK, "--", "--echo", cwd=self.folder)[:2], (0, [CUBES_OK]))

    def test_echo(self):
        code, lines, _ = self.run_program(CHECK, "--echo", DATA / "point_tetrahedron.cert")
        self.assertEqual(code, 0)
        self.assertEqual(lines[:8], ["c id a%20point%20in%20a%20tetrahedron", "c a 1", "c 0 0 0", "c b 4", "c 1/2 1/2 1/2",
                                     "c 1/2 -1/2 -1/2", "c -1/2 1/2 -1/2", "c -1/2 -1/2 1/2"])
        self.assertEqual(lines[8], "c claim depth 1/12")

    def test_echo_of_format_2(self):
        code, lines, _ = self.run_program(CHECK, "--echo", DATA / "format_2" / "cylinder_on_floor.cert")
        self.assertEqual((code, lines[:-1]), (0, ["c id can%20on%20the%20floor", "c shape_a 1", "c term 2", "c disc 0 0 0 1 0 0 0 1 0",
                                                  "c disc 0 0 3 1 0 0 0 1 0", "c halfspace_b 0 0 1 0", "c claim signed_bounds 0 0"]))
        code, lines, _ = self.run_program(CHECK, "--echo", DATA / "format_2" / "sphere_capsule.cert")
        self.assertEqual((code, lines[1:-1]), (0, ["c a 1", "c 0 0 0", "c radius_a 2", "c b 2", "c 5 -1 0", "c 5 1 0", "c radius_b 3",
                                                   "c claim apart 25"]))

    def test_echo_of_format_4(self):
        code, lines, _ = self.run_program(CHECK, "--echo", DATA / "format_4" / "two_cubes.cert")
        self.assertEqual((code, lines[19:-1]), (0, [
            "c claim depth 1", "c patch 4", "c a 2 0 0 b 1 0 0", "c a 2 0 2 b 1 0 2", "c a 2 2 2 b 1 2 2", "c a 2 2 0 b 1 2 0",
            "c rate 1 0 0 0 0 0 1 1", "c rate 0 0 0 0 1 0 1 4"]))
        code, lines, _ = self.run_program(CHECK, "--echo", DATA / "format_4" / "capsule_on_floor.cert")
        self.assertEqual((code, lines[7:10]), (0, ["c patch 2", "c a 0 0 1/2", "c a 2 0 1/2"]))

    def test_a_solid_is_compared_with_nothing(self):
        solid = DATA / "format_5" / "two_tetrahedra.cert"
        code, lines, _ = self.run_program(CHECK, "--echo", solid)
        self.assertEqual((code, lines[:3], lines[6:-1]), (0, ["c id two%20tetrahedra", "c solid_a 5", "c 0 0 0"], [
            "c 2 0 0", "c mesh 4", "c 0 2 4", "c 0 4 1", "c 0 1 2", "c 1 4 2", "c claim solid"]))
        case = self.file("case.json", json.dumps({"a": {"vertices": [[0, 0, 0]]}, "b": {"vertices": [[0, 0, 0]]}}))
        results = self.file("results.jsonl", json.dumps({"status": "solid", "certificate": solid.read_text()}))
        for words, expected in ((["--width", solid], "solids have no width here: it is that of a convex body"),
                                (["--case", case, solid], "a solid is not what a case holds"),
                                (["--results", results], "a solid is no result")):
            code, lines, _ = self.run_program(CHECK, *words)
            self.assertEqual((code, reason(lines[0])), (1, expected))

    def test_case_of_format_2(self):
        folder = DATA / "format_2"
        case = self.file("case.json", json.dumps({"a": {"vertices": [[0, 0, 0]]}, "b": {"vertices": [[5, -1, 0], [5, 1, 0]]}}))
        without = self.file("without", re.sub("radius_.*\n", "", (folder / "sphere_capsule.cert").read_text()))
        self.assertEqual(self.run_program(CHECK, "--case", case, without)[:2],
                         (0, ["s VERIFIED disjoint signed_depth=-sqrt(25)+0 sphere%20and%20capsule"]))
        for name, expected in (("sphere_capsule", "the case has no radius around a, the certificate has one"),
                               ("cylinder_on_floor", "the case has points in a: only points can be compared with it")):
            code, lines, _ = self.run_program(CHECK, "--case", case, folder / f"{name}.cert")
            self.assertEqual((code, reason(lines[0])), (1, expected))

    def test_width_of_format_2(self):
        ball = "shape_%s 1\nterm 1\nball 0 0 0 1 0 0 0 1 0 0 0 1\n%s"
        end = "claim signed_bounds 0 2\ndirections 1 some\n1 0 0\nheights_a 1\n1\nheights_b 1\n1\ninner_a 1\n0 0 0 0\ninner_b 1\n0 0 0 0\n"
        end += "weights_a 1\n0 1\nweights_b 1\n0 1\nend 1 1 1 1 1 1 1 1 1 1 1\n"
        for more, code in (("", 0), ("radius_b 1\n", 1)):
            text = "fathom-certificate 2\n" + ball % ("a", "") + ball % ("b", more) + (end.replace("0 2", "0 3") if more else end)
            self.assertEqual(self.run_program(CHECK, "-", stdin=text)[0], 0)
            self.assertEqual(self.run_program(CHECK, "--width", "-", stdin=text)[0], code)

    def test_case(self):
        cube = [[x, y, z] for z in (0, 2) for y in (0, 2) for x in (0, 2)]
        case = {"schema": "fathom/case/1", "id": "two cubes", "a": {"vertices": cube},
                "b": {"vertices": cube, "pose": [[1, 0, 0, 1], [0, 1, 0, 0], [0, 0, 1, 0]]}}
        certificate = DATA / "depth_cubes.cert"
        own = self.file("case.json", json.dumps(case, indent=1))
        self.assertEqual(self.run_program(CHECK, "--case", own, certificate)[:2], (0, [CUBES_OK]))
        case["b"]["pose"][0][3] = 1.0000000000000002
        moved = self.file("moved.json", json.dumps(case))
        code, lines, _ = self.run_program(CHECK, "--case", moved, certificate)
        self.assertEqual((code, reason(lines[0])), (1, "point 0 of b is not that of the case"))
        code, lines, err = self.run_program(CHECK, "--case", self.file("bad.json", "{\n}"), certificate)
        self.assertEqual((code, lines), (2, []))
        self.assertIn("bad.json:1: expected", err)

    def test_width(self):
        rows = "0 0 0\n6/2 0 0\n0 0 3\n"
        text = f"fathom-certificate 1\na 3\n{rows}b 3\n{rows.replace('6/2', '3')}claim touching\ndirections 1 some\n0 1 0\n"
        text += "weights_a 1\n0 1\nweights_b 1\n0 1\nend 3 3 1 1 1\n"
        case = self.file("case.json", '{"a": {"vertices": [[0,0,0],[3,0,0],[0,0,3]]}, "b": {"vertices": [[7,7,7]]}}')
        self.assertEqual(self.run_program(CHECK, "--width", "--case", case, "-", stdin=text)[0], 0)
        self.assertEqual(self.run_program(CHECK, "--case", case, "-", stdin=text)[0], 1)
        self.assertEqual(self.run_program(CHECK, "--width", "-", stdin=text.replace("6/2", "4"))[0], 1)
        code, lines, _ = self.run_program(CHECK, "--width", DATA / "touching_cubes.cert")
        self.assertEqual((code, lines[0][:31]), (1, "s REFUSED touching%20cubes:12: "))

    def test_results(self):
        result = {"id": "é", "status": "penetrating", "depth": {"squared": "1"}, "certificate": re.sub("id .*\n", "", CUBES)}
        lines = [json.dumps(result), json.dumps({**result, "depth": {"squared": "2"}}), "", json.dumps({**result, "status": "touching"}),
                 json.dumps({"id": "error", "error": "x"}), "{", json.dumps({"certificate": CUBES + CUBES}),
                 json.dumps({"certificate": CUBES})]
        path = self.file("results.jsonl", "\n".join(lines))
        code, found, _ = self.run_program(CHECK, "--results", path)
        self.assertEqual(code, 2)
        self.assertEqual([re.sub(r":\d+: .*", "", line) for line in found],
                         ["s VERIFIED penetrating depth_squared=1 optima=1 %C3%A9", "s REFUSED %C3%A9", "s REFUSED %C3%A9",
                          "s MALFORMED error", f"s MALFORMED {path}:6", f"s MALFORMED {path}:7", CUBES_OK])
        self.assertEqual(self.run_program(CHECK, "--results", "-", stdin=lines[0])[0], 0)
        self.assertEqual(self.run_program(CHECK, "--results", self.file("none", "\n"))[0], 2)

    def test_results_of_format_2(self):
        text = {name: re.sub("^#.*\n|id .*\n", "", (DATA / "format_2" / f"{name}.cert").read_text(), flags=re.MULTILINE)
                for name in ("rounded_cubes", "balls", "crossing_capsules")}
        text["apart"] = re.sub("radius_b.*\n", "", (DATA / "format_2" / "sphere_capsule.cert").read_text())

        def code(name, **fields):
            return self.run_program(CHECK, "--results", "-", stdin=json.dumps({"certificate": text[name], **fields}))[0]

        def number(low, high, *exact):
            value = {"low": low, "high": high}
            return {"signed_depth": {**value, "exact": dict(zip(("sign", "root", "plus"), exact))} if exact else value}

        exact = [("rounded_cubes", 1.3, (1, "1", "3/10")), ("crossing_capsules", 0.75, (0, "0", "3/4")), ("apart", -3.0, (-1, "25", "2"))]
        for name, value, parts in exact:
            self.assertEqual(code(name, **number(value - 1e-15, value + 1e-15, *parts)), 0)
            self.assertEqual(code(name, **number(value + 1e-15, value + 1)), 1)
            self.assertEqual(code(name, **number(value - 1, value - 1e-15)), 1)
            self.assertEqual(code(name, **number(None, None)), 0)
            self.assertEqual(code(name, **number(value - 1, None, parts[0], parts[1], "1/7")), 1)
            self.assertEqual(code(name, **number(value - 1, None, parts[0], "2", parts[2])), 1)
            self.assertEqual(code(name, depth={"squared": "1"}), 1)
        self.assertEqual(code("apart", **number(-3, -3, 1, "25", "2")), 1)
        self.assertEqual(code("apart", status="disjoint"), 0)
        self.assertEqual(code("apart", status="touching"), 1)
        self.assertEqual(code("balls", status="penetrating", **number(2, 3)), 0)
        self.assertEqual(code("balls", **number(2, 2.5)), 1)
        self.assertEqual(code("balls", **number(2.5, 3)), 1)
        self.assertEqual(code("balls", **number(2, 3, 0, "0", "2")), 1)
        for right in ({"squared": "9"}, {"squared": None}):
            self.assertEqual(code("apart", distance=right), 0, right)
        for wrong in ({"squared": "25"}, {"squared": "5929"}, {"squared": "0"}):
            self.assertEqual(code("apart", distance=wrong), 1, wrong)
        self.assertEqual(code("rounded_cubes", distance={"squared": "169/100"}), 1, "they penetrate")
        self.assertEqual(code("apart", distance="9"), 2)
        for wrong in ({"low": 2}, {"low": "2", "high": 3}, {"low": 2, "high": 1e999}, 2, None, {"low": 2, "high": 3, "exact": {"sign": 0}}):
            self.assertEqual(code("balls", signed_depth=wrong), 2, wrong)

    def test_results_of_format_4(self):
        for name, right, wrong in (("two_cubes", {"status": "penetrating", "depth": {"squared": "1"}}, {"depth": {"squared": "2"}}),
                                   ("rods_apart", {"status": "disjoint", "distance": {"squared": "1"}}, {"distance": {"squared": "2"}}),
                                   ("two_ways_out", {"depth": {"squared": "1"}}, {"bound": {"squared": "1"}})):
            text = (DATA / "format_4" / f"{name}.cert").read_text()
            for fields, expected in ((right, 0), ({**right, **wrong}, 1)):
                fields = json.dumps({**fields, "certificate": text})
                self.assertEqual(self.run_program(CHECK, "--results", "-", stdin=fields)[0], expected, (name, fields))

    def test_what_is_said_of_a_distance_is_proved_or_refused(self):
        text = (DATA / "disjoint_cubes.cert").read_text()  # format 1: it proves that they are disjoint

        def said(**fields):
            code, lines, _ = self.run_program(CHECK, "--results", "-", stdin=json.dumps({"certificate": text, **fields}))
            return code, lines[0]

        self.assertEqual(said(status="disjoint", depth={"squared": "0"})[0], 0)
        for low, high in ((None, 0), (None, None), (None, 1)):
            self.assertEqual(said(signed_depth={"low": low, "high": high})[0], 0)
        minus_one = {"sign": -1, "root": "1", "plus": "0"}
        for fields in ({"distance": {"squared": "1"}}, {"distance": {"squared": "5929"}}, {"distance": {"squared": None}},
                       {"signed_depth": {"low": -1, "high": -1, "exact": minus_one}}, {"signed_depth": {"low": -1, "high": 0}},
                       {"signed_depth": {"low": None, "high": -1}}, {"signed_depth": {"low": -1, "high": -2}},
                       {"signed_depth": {"low": None, "high": None, "exact": {**minus_one, "plus": "77"}}}):
            code, line = said(**fields)
            self.assertEqual((code, "distance not proved" in line), (1, True), (fields, line))

    def test_a_result_is_about_its_own_case(self):
        def case(name, x):
            cube = [[x + i, j, k] for k in (0, 2) for j in (0, 2) for i in (0, 2)]
            return json.dumps({"id": name, "a": {"vertices": cube}, "b": {"vertices": [[i + 1, j, k] for i, j, k in cube]}})

        def checked(cases, **fields):
            own, results = self.file("own.jsonl", "\n".join(cases)), self.file("results.jsonl",
                                                                               json.dumps({**fields, "certificate": CUBES}))
            code, lines, _ = self.run_program(CHECK, "--results", results, "--case", own)
            return code, re.sub(r":\d+: .*", "", lines[0])

        both = [case("two cubes", 0), case("Y", 5)]
        self.assertEqual(checked(both, id="two cubes"), (0, CUBES_OK))
        self.assertEqual(checked(both), (0, CUBES_OK))
        self.assertEqual(checked(both, id="Y"), (1, "s REFUSED Y"))
        self.assertEqual(checked(both, id="two%20cubes"), (1, "s REFUSED two%2520cubes"))
        self.assertEqual(checked(both[:1], id="two cubes"), (0, CUBES_OK))
        self.assertEqual(checked([case("Y", 0)], id="two cubes"), (1, "s REFUSED two%20cubes"))
        self.assertEqual(checked([case("Y", 0)]), (0, CUBES_OK))


class Hostile(ProgramTest):
    def small_memory(self):
        resource.setrlimit(resource.RLIMIT_AS, (100 << 20, 100 << 20))

    def test_endless_line(self):
        with open("/dev/zero", "rb") as zeros:
            done = subprocess.run([*CHECK, "-"], input=zeros.read(100 << 20), stdout=subprocess.PIPE, timeout=PATIENCE)
        self.assertEqual(done.returncode, 2)
        self.assertEqual(done.stdout.count(b"\n"), 1)

    @unittest.skipIf("asan" in os.environ.get("FATHOM_CHECK", ""), "address space limits do not go with AddressSanitizer")
    def test_memory_that_ends(self):
        number = "7" * 40
        text = "fathom-certificate 1\na 500000\n" + f"{number} {number} {number}\n" * 400_000
        code, lines, _ = self.run_program(CHECK, "-", stdin=text, preexec_fn=self.small_memory)
        self.assertEqual(code, 2)
        self.assertLessEqual(len(lines), 1)


if __name__ == "__main__":
    unittest.main()
