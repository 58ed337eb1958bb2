# SPDX-License-Identifier: GPL-3.0-or-later
"""Help, version, and every way to misuse the command line."""
import pathlib
import re
import subprocess
import unittest

from harness import DATA, EXECUTABLE, ROOT, VERSION, CliTest

A, B = str(DATA / "cube.off"), str(DATA / "icosahedron.off")
OPTIONS = ("--method", "--closest-lines", "--digits", "--certificate", "--embed-certificate", "--exact-decimals", "--counters", "--json",
           "--help")
COMMANDS = "depth, width, approx, ray, metric, study, stages, explain, cases, certify, check, golden, help, man, completion"


class Help(CliTest):
    def test_starts_with_examples_and_names_everything(self):
        for arguments in (["--help"], ["-h"]):
            out = self.answer(*arguments)
            self.assertTrue(out.startswith("Examples\n  fathom depth "), out)
            out = " ".join(out.split())
            for word in ("depth", "width", "approx", "ray", "metric", "study", "stages", "explain", "cases", "--version", "certify",
                         "Exit codes: 0 fine; 1 ", "130 interrupted"):
                self.assertIn(word, out)
        for command in ("depth", "width"):
            out = self.answer(command, "--help")
            self.assertTrue(out.startswith(f"Examples\n  fathom {command} "), out)
            for option in OPTIONS:
                self.assertIn(f"\n  {option} " if option != "--help" else "--help", out)

    def test_says_nothing_else(self):
        self.assertEqual(self.run_cli("--help")[2], "")
        self.assertEqual(self.run_cli("depth", "--help")[2], "")

    def test_version(self):
        for option in ("--version", "-V"):
            first, *others = self.answer(option).splitlines()
            self.assertEqual(first, f"fathom {VERSION}")
            told = dict(line.split(" ", 1) for line in others)
            data = re.search(r'data_version = "(.*)"', (ROOT / "verify/golden/shards/plan.hpp").read_text())[1]
            self.assertEqual((told["golden"], told["licence"]), (f"data {data}", "GPL-3.0-or-later"))
            if (ROOT / ".git").exists():
                subprocess.run(["git", "rev-parse", "--verify", told["commit"].removesuffix("-dirty") + "^{commit}"], cwd=ROOT, check=True,
                               capture_output=True)

    def test_help_as_a_command(self):
        self.assertEqual(self.answer("help"), self.answer("--help"))
        for command in COMMANDS.split(", "):
            for words in ([command, "--help"], [command, "-h"]):
                self.assertEqual(self.answer(*words), self.answer("help", command))
        self.assertEqual(self.answer("help", "golden", "verify"), self.answer("golden", "verify", "--help"))
        self.assertIn(f"unknown command 'nonsense' (expected {COMMANDS})\n", self.refused("help", "nonsense"))


class Outputs(CliTest):
    """Nothing that is written is something that is read, or written otherwise; nothing is opened before that is known."""

    def setUp(self):
        super().setUp()
        corners = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)]
        self.a, self.b = self.file("a.txt", corners), self.file("b.txt", corners)
        self.mesh, self.other = self.file("a.off", pathlib.Path(A).read_bytes()), self.file("b.off", pathlib.Path(B).read_bytes())
        self.pose = self.file("pose.txt", "xyz=1/2,0,0")
        self.cases = self.file("c.txt", '{"id":"1","a":{"vertices":[[0,0,0]]},"b":{"vertices":[[0,0,0]]}}\n')
        self.pieces = self.file("k.obj", (DATA / "key.obj").read_bytes())

    def all_kept(self, *arguments, **options):
        before = {path: path.read_bytes() for path in self.folder.iterdir() if path.is_file()}
        code, out, err = self.run_cli(*arguments, **options)
        self.assertEqual((code, out), (2, ""), err)
        self.assertEqual({path: path.read_bytes() for path in self.folder.iterdir() if path.is_file()}, before)
        return err

    def test_no_output_is_an_input(self):
        link, hard = self.folder / "link", self.folder / "hard"
        link.symlink_to(self.a)
        hard.hardlink_to(self.a)
        for arguments in (["depth", "--certificate", self.a, self.a, self.b], ["depth", "--svg", self.b, self.a, self.b],
                          ["depth", "--svg", link, self.a, self.b], ["depth", "--svg", hard, self.a, self.b],
                          ["depth", "--svg", f"{self.folder}/./a.txt", self.a, self.b], ["width", "--certificate", self.a, self.a],
                          ["depth", "--along", "1,0,0", "--svg", self.a, self.a, self.b], ["stages", "--svg", self.a, self.a, self.b],
                          ["depth", "--pose-a", "@" + self.pose, "--svg", self.pose, self.a, self.b],
                          ["explain", self.a, self.b, "-o", self.a],
                          ["depth", "--case", "1", "--svg", self.cases, self.cases], ["study", "--html", self.cases, self.cases],
                          ["depth", "--pieces", "--svg", self.pieces, self.pieces, self.pieces],
                          ["explain", "--pieces", self.pieces, self.pieces, "-o", self.pieces],
                          ["certify", "--subject", "true", "--html", self.cases, self.cases],
                          ["certify", "--subject", "true", "--report", self.cases, self.cases],
                          ["certify", "--replay", self.pose, "--junit", self.pose, self.cases],
                          ["certify", "--subject", "true", "--expect-fail", self.pose, "--junit", self.pose, self.cases],
                          ["certify", "diff", "--html", self.a, self.a, self.b]):
            with self.subTest(arguments):
                self.assertIn(" would write over '", self.all_kept(*arguments))

    def test_one_name_forgotten(self):
        for arguments in (["width", "--certificate", self.mesh, self.other], ["depth", "--certificate", self.mesh, self.other, self.a],
                          ["study", "--html", self.mesh, self.a, self.b]):
            self.assertIn("which is named like a mesh or like cases", self.all_kept(*arguments))
        self.answer("width", "--certificate", self.folder / "new.off", self.other)

    def test_files_of_folders(self):
        folder = self.folder / "pieces"
        folder.mkdir()
        (folder / "p.obj").write_bytes((DATA / "key.obj").read_bytes())
        (folder / "1.cert").write_text(pathlib.Path(self.cases).read_text())
        self.assertIn("would write over", self.all_kept("depth", "--pieces", "--svg", folder / "p.obj", folder, self.pieces))
        self.assertIn("would write over", self.all_kept("depth", "--certificate", folder, folder / "1.cert"))
        self.answer("depth", "--svg", folder, "--certificate", folder, self.cases)
        self.assertTrue((folder / "1.svg").exists() and (folder / "1.cert").read_text().startswith("fathom-certificate"))

    def test_no_two_outputs_are_one(self):
        one = self.folder / "one"
        for arguments in (["depth", "--certificate", one, "--svg", one, self.a, self.b],
                          ["certify", "--subject", "true", "--junit", one, "--html", one, self.cases],
                          ["certify", "--subject", "true", "--certificates", one, "--shrink", one, self.cases]):
            self.assertIn(" write to one place, ", self.all_kept(*arguments))
        out = self.folder / "out"
        with open(out, "wb") as stream:
            code, _, err = self.run_cli("depth", "--certificate", out, self.a, self.b, stdout=stream)
        self.assertEqual((code, out.read_bytes()), (2, b""))
        self.assertIn("--certificate and standard output write to one place", err)
        with open(self.cases, "rb") as stream:
            done = subprocess.run([EXECUTABLE, "study", "--html", self.cases, "-"], stdin=stream, capture_output=True, check=False)
        self.assertEqual(done.returncode, 2)
        self.assertIn(b"would write over 'standard input'", done.stderr)


class Misuse(CliTest):
    def test_no_command(self):
        err = self.refused()
        self.assertEqual(err, f"fathom: expected a command: {COMMANDS}\nFor example: fathom depth a.off b.stl\nTry: fathom --help\n")
        self.assertIn("expected a command", self.refused("--"))

    def test_unknown_words(self):
        self.assertIn(f"unknown command 'dept' (expected {COMMANDS})", self.refused("dept", A, B))
        self.assertIn("--frobnicate", self.refused("depth", "--frobnicate", A, B))
        self.assertIn("--json", self.refused("--json", "depth", A, B))

    def test_misspelt_words(self):
        for words, meant in ((["dept", A, B], "depth"), (["certfiy"], "certify"), (["golden", "verfy", "x"], "verify"),
                             (["comp"], "completion"), (["depth", "--metod", "exact", A, B], "--method"),
                             (["depth", "--metod=exact", A, B], "--method"), (["depth", "--cert", "x", A, B], "--certificate"),
                             (["width", "--jsno", A], "--json"), (["--versoin"], "--version"),
                             (["golden", "generate", "--levle", "L0", "--out", "x"], "--level"),
                             (["depth", "--method", "exat", A, B], "exact"),
                             (["study", "--counters", A, B], None), (["xyzzy"], None), (["depth", "--frobnicate", A, B], None),
                             (["depth", "--method", "fast", A, B], None), (["depth", "--method", "", A, B], None)):
            with self.subTest(words=words):
                err = self.refused(*words)
                if meant:
                    self.assertIn(f"; did you mean '{meant}'?\n", err)
                else:
                    self.assertNotIn("did you mean", err)
        self.assertIn("not expected: --json; --json stands behind the command\n", self.refused("--json", "depth", A, B))

    def test_inputs_without_a_command(self):
        self.file("a b.obj", "v 0 0 0\n")
        for words, line in (([A, B], f"depth {A} {B}"), (["a.obj", "b.stl"], "depth a.obj b.stl"),
                            (["--json", A, B], f"depth --json {A} {B}"),
                            ([A], f"width {A}"), (["cases.jsonl"], "depth cases.jsonl"), (["-"], "depth -"),
                            (["sphere:r=1", A], f"depth sphere:r=1 {A}"), (["a b.obj", "it's.off"], "depth 'a b.obj' 'it'\\''s.off'")):
            self.assertIn(f"; did you mean: fathom {line}\n", self.refused(*words))
        self.assertIn("expected a command, found the input", self.refused(A, B))

    def test_no_value_is_no_value(self):
        """Neither the next word, nor as if the option were not there."""
        for words in (["ray", "--direction=", "1,0,0", A, B], ["depth", "--certificate=", "proof.cert", A, B],
                      ["depth", "--seed=", "1", A, B], ["golden", "generate", "--out=", "folder", "--level", "L0"]):
            option = next(word for word in words if word.endswith("="))
            self.assertIn(f"'{option}' lacks its value", self.refused(*words))
        for words in (["depth", "--certificate", "", A, B], ["metric", "--ball", "", A, B], ["certify", "--report", "", "--replay", A, B],
                      ["certify", "--html", "", "--replay", A, B]):
            self.assertIn(f"{words[1]} expects a value, found nothing", self.refused(*words))
        self.assertIn("--=: expected a readable file", self.refused("depth", "--", A, "--="))

    def test_values_of_options(self):
        self.assertIn("--method: 'fast' is unknown (expected auto, exact, certificate, shallow, naive)",
                      self.refused("depth", "--method", "fast", A, B))
        for seed in ("-1", "1.5", "x", "18446744073709551616"):
            self.assertIn("--seed: expected an integer from 0 to 2^64 - 1", self.refused("depth", f"--seed={seed}", A, B))
        self.assertIn("--closest-lines: 'fast' is unknown", self.refused("depth", "--closest-lines", "fast", A, B))
        for digits in ("0", "00", "-1", "1.5", "1e3", "many", "", "1000001", "99999999999999999999"):
            self.assertIn("expected an integer from 1 to 1000000", self.refused("depth", f"--digits={digits}", A, B) if digits
                          else self.refused("depth", "--digits", "", A, B))
        self.assertIn("--digits: expected one value, once", self.refused("depth", A, B, "--digits"))
        self.assertIn("--digits: expected one value, once", self.refused("depth", A, B, "--digits", "3", "--digits", "4"))
        for method in ("naive", "shallow"):
            self.assertIn(f"cannot be combined with --method {method}",
                          self.refused("depth", "--closest-lines", "naive", "--method", method, A, B))

    def test_number_of_inputs(self):
        self.assertIn("depth expects two meshes, or one stream of cases (a JSON Lines file, or - for standard input), found 0 arguments",
                      self.refused("depth"))
        for command in ("depth", "width"):
            for inputs in ([A, B, "extra"], [A, B, "extra", A]):
                err = self.refused(command, *inputs)
                self.assertIn("not expected: ", err)
                self.assertIn("extra", err)
        self.assertIn("found the single mesh", self.refused("depth", A))
        self.assertIn("found - beside another input", self.refused("depth", A, "-"))
        for inputs in ([], [A, B]):
            self.assertIn(f"width expects one mesh, or one stream of cases (a .jsonl file, or - for standard input), "
                          f"found {len(inputs)} arguments", self.refused("width", *inputs))

    def test_what_the_user_typed_cannot_play_with_the_terminal(self):
        for arguments in (["\x1b[2J"], ["depth", "--\x1b[2J", A, B], ["depth", "--method", "\x1b[2J", A, B]):
            self.assertNotIn("\x1b", self.refused(*arguments))

    def test_names_of_files_are_free(self):
        for name in ("width", "depth", "ray", "[x]", "-x", "--certificate"):
            self.file(name, "0 0 0\n1 0 0\n0 1 0\n0 0 1\n")
            for words in [["--", name]] + [[name]] * (not name.startswith("-")):
                with self.subTest(words=words):
                    code, out, err = self.run_cli("width", *words, cwd=self.folder)
                    self.assertEqual(code, 0, err)
                    self.assertTrue(out.startswith("width "), out)


if __name__ == "__main__":
    unittest.main()
