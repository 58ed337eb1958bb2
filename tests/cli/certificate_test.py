# SPDX-License-Identifier: GPL-3.0-or-later
"""--certificate and --embed-certificate: what is written where, and that nothing else is."""
import hashlib
import json
import os
import stat
import subprocess
import unittest

from harness import EXECUTABLE, UNIT, CliTest, box, case

SHIFTED = box([0.75, 0.25, 0.125], [1.75, 1.25, 1.125])
FAR = box([5, 5, 5], [6, 6, 6])
GOOD = case(UNIT, SHIFTED, id="good")


class Single(CliTest):
    def setUp(self):
        super().setUp()
        self.a, self.b = self.file("a.xyz", UNIT), self.file("b.xyz", SHIFTED)
        self.proof = self.folder / "proof.cert"

    def test_file_holds_the_proof_and_the_answer_stays(self):
        plain = self.answer("depth", self.a, self.b)
        self.assertEqual(self.answer("depth", "--certificate", self.proof, self.a, self.b), plain)
        lines = self.proof.read_text().splitlines()
        self.assertEqual(lines[:3], ["fathom-certificate 1", f"id {self.a}%20{self.b}", "a 8"])
        self.assertIn("claim depth 1/16", lines)
        self.assertIn("directions 1 all", lines)
        self.assertEqual(lines[-1].split()[:4], ["end", "8", "8", "1"])
        self.assertEqual(sorted(os.listdir(self.folder)), ["a.xyz", "b.xyz", "proof.cert"])

    def test_result_and_certificate_agree_on_a_name_that_is_no_utf8(self):
        odd = os.fsencode(self.folder) + b"/a\xff.xyz"
        os.link(self.a, odd)
        run = lambda *arguments, **given: subprocess.run([EXECUTABLE, *arguments], capture_output=True, check=True, **given).stdout
        result = run("depth", "--json", "--embed-certificate", odd, self.b)
        self.assertTrue(run("check", "--results", "-", input=result).startswith(b"s VERIFIED penetrating"))

    def test_statuses(self):
        for other, claim in ((FAR, "apart 48"), (box([1, 0, 0], [2, 1, 1]), "touching")):
            self.answer("depth", "--certificate", self.proof, self.a, self.file("c.xyz", other))
            self.assertIn(f"claim {claim}\n", self.proof.read_text())

    def test_methods_agree(self):
        answers = {method: self.result("depth", "--method", method, self.a, self.b) for method in ("exact", "certificate", "naive")}
        for method, answer in answers.items():
            self.assertEqual(answer.pop("method"), method)
        self.assertEqual(answers["certificate"], answers["exact"])
        for method in answers:
            self.answer("depth", "--method", method, "--certificate", self.proof, self.a, self.b)
            self.assertIn("claim depth 1/16\n", self.proof.read_text())

    def test_width(self):
        self.answer("width", "--certificate", self.proof, self.a)
        lines = self.proof.read_text().splitlines()
        self.assertIn("claim depth 1", lines)
        self.assertEqual(lines[lines.index("a 8") + 1:lines.index("b 8")], lines[lines.index("b 8") + 1:lines.index("b 8") + 9])

    def test_replaces_a_file_at_once(self):
        self.proof.write_text("old")
        link = self.folder / "link"
        link.symlink_to(self.proof)
        self.answer("depth", "--certificate", link, self.a, self.b)
        self.assertTrue(link.is_symlink())
        self.assertTrue(self.proof.read_text().startswith("fathom-certificate 1\n"))
        self.assertEqual(stat.S_IMODE(self.proof.stat().st_mode) & 0o111, 0)

    def test_a_link_to_a_file_that_is_not_there_yet_stays_a_link(self):
        folder = self.folder / "proofs"
        folder.mkdir()
        link, second = self.folder / "link", self.folder / "second"
        link.symlink_to("second")
        second.symlink_to("proofs/new.cert")
        self.answer("depth", "--certificate", link, self.a, self.b)
        self.assertTrue(link.is_symlink() and second.is_symlink())
        self.assertEqual(os.listdir(folder), ["new.cert"])
        self.assertTrue((folder / "new.cert").read_text().startswith("fathom-certificate 1\n"))
        for place in ("missing/new.cert", "link"):
            link.unlink()
            link.symlink_to(place)
            code, out, err = self.run_cli("depth", "--certificate", link, self.a, self.b)
            self.assertEqual((code, out), (2, ""))
            self.assertIn(f"{link}: cannot write a certificate: ", err)
            self.assertTrue(link.is_symlink())

    def test_what_a_killed_process_left_is_in_nobodys_way(self):
        """Containers give out the same process ids again and again."""
        shell = 'for n in "" -0 -1; do echo left > .fathom-$$$n.tmp; done; exec "$@"'
        done = subprocess.run(["sh", "-c", shell, "sh", EXECUTABLE, "depth", "--certificate", self.proof, self.a, self.b],
                              cwd=self.folder, capture_output=True)
        self.assertEqual((done.returncode, done.stderr), (0, b""))
        self.assertTrue(self.proof.read_text().startswith("fathom-certificate 1\n"))
        left = [path for path in self.folder.iterdir() if path.suffix == ".tmp"]
        self.assertEqual([path.read_text() for path in left], ["left\n"] * 3)

    def test_a_device_is_written_to_and_stays_one(self):
        self.answer("depth", "--certificate", "/dev/null", self.a, self.b)
        self.assertTrue(stat.S_ISCHR(os.stat("/dev/null").st_mode))

    def test_old_file_survives_a_bad_input(self):
        self.proof.write_text("old")
        code, _, _ = self.run_cli("depth", "--certificate", self.proof, self.a, self.folder / "missing.xyz")
        self.assertEqual((code, self.proof.read_text()), (2, "old"))

    def test_places_that_cannot_be_written(self):
        for place in (self.folder, self.folder / "missing" / "proof.cert"):
            code, out, err = self.run_cli("depth", "--certificate", place, self.a, self.b)
            self.assertEqual((code, out), (2, ""))
            self.assertIn(f"{place}: cannot write a certificate: ", err)

    def test_a_folder_that_cannot_be_reached(self):
        loop = self.folder / "loop"
        loop.symlink_to("loop")
        cases = self.file("c.jsonl", case(UNIT, UNIT))
        for arguments in (["depth", "--certificate", loop / "x", cases], ["depth", "--svg", loop / "x", cases],
                          ["golden", "generate", "--level", "L0", "--out", loop / "x"],
                          ["certify", "--subject", "true", "--certificates", loop / "x", cases]):
            code, out, err = self.run_cli(*arguments)
            self.assertEqual((code in (2, 3), out), (True, ""), err)
            self.assertIn("Too many levels of symbolic links", err)
            self.assertNotIn("internal error", err)

    def test_a_full_disk_is_no_success(self):
        code, out, err = self.run_cli("depth", "--certificate", "/dev/full", self.a, self.b)
        self.assertEqual((code, out), (3, ""))
        self.assertIn("/dev/full: cannot write the certificate: ", err)

    def test_a_proof_that_no_checker_would_read(self):
        self.proof.write_text("old")
        wide = self.file("wide.xyz", [[0, 0, 0], ["1" + "0" * 100_000, 0, 0], [0, 1, 0], [0, 0, 1]])
        self.answer("depth", wide, self.b)
        for option in (["--certificate", self.proof], ["--json", "--embed-certificate"]):
            code, out, err = self.run_cli("depth", *option, wide, self.b)
            self.assertEqual((code, out, self.proof.read_text()), (3, "", "old"))
            self.assertIn(f"{wide} {self.b}: no certificate is written, since all checkers would refuse to read it: a number of more "
                          "digits than the limit, 100000. Narrower numbers", " ".join(err.split()))
            self.assertNotIn("internal error", err)

    def test_what_does_not_go_together(self):
        for arguments, words in ((["--embed-certificate"], "needs --json"), (["--certificate", "-"], "--embed-certificate writes"),
                                 (["--certificate"], "--certificate"),
                                 (["--certificate", ""], "--certificate expects a value, found nothing"),
                                 (["--method", "certificate", "--closest-lines", "naive"], "cannot be combined with --method certificate")):
            code, out, err = self.run_cli("depth", self.a, self.b, *arguments)
            self.assertEqual((code, out), (2, ""))
            self.assertIn(words, err)

    def test_embedded(self):
        self.answer("depth", "--certificate", self.proof, self.a, self.b)
        result = self.result("depth", "--embed-certificate", self.a, self.b)
        self.assertEqual(result["certificate"], self.proof.read_text())
        self.assertNotIn("certificate", self.result("depth", self.a, self.b))


class Streams(CliTest):
    def setUp(self):
        super().setUp()
        self.proofs = self.folder / "proofs"

    def names(self):
        return sorted(os.listdir(self.proofs))

    def test_one_file_for_each_case(self):
        lines = GOOD + case(UNIT, FAR, id="far") + case(UNIT, UNIT)
        plain = self.answer("depth", "--json", "-", stdin=lines)
        self.assertEqual(self.answer("depth", "--json", "--certificate", self.proofs, "-", stdin=lines), plain)
        self.assertEqual(self.names(), ["3.cert", "far.cert", "good.cert"])
        self.assertIn("claim apart ", (self.proofs / "far.cert").read_text())
        self.answer("depth", "--certificate", self.proofs, "-", stdin=lines)  # a second run replaces them
        self.assertEqual(self.names(), ["3.cert", "far.cert", "good.cert"])

    def test_unsafe_ids(self):
        ids = ["../up", ".", "..", "", "a b", "A/b", "100%", "new\nline", "é", ".hidden", "x.cert"]
        names = ["%2E.%2Fup.cert", "%2E.cert", "%2E..cert", "%.cert", "a%20b.cert", "A%2Fb.cert", "100%25.cert",
                 "new%0Aline.cert", "%C3%A9.cert", "%2Ehidden.cert", "x.cert.cert"]
        self.answer("depth", "--certificate", self.proofs, "-", stdin="".join(case(UNIT, SHIFTED, id=i) for i in ids))
        self.assertEqual(self.names(), sorted(names))
        self.assertEqual(sorted(os.listdir(self.folder)), ["proofs"])

    def test_an_id_that_comes_twice(self):
        lines = GOOD + GOOD + case(UNIT, FAR, id="other")
        code, out, _ = self.run_cli("depth", "--json", "--certificate", self.proofs, "-", stdin=lines)
        self.assertEqual(code, 2)
        results = [json.loads(line) for line in out.splitlines()]
        self.assertEqual(["error" in r for r in results], [False, True, False])
        self.assertIn("an earlier case with the same id", results[1]["error"])
        self.assertEqual(self.names(), ["good.cert", "other.cert"])

    def test_ids_too_long_for_a_name(self):
        longest, longer, escaped = "n" * 250, "n" * 251, "é" * 100
        self.answer("depth", "--certificate", self.proofs, "-",
                    stdin="".join(case(UNIT, FAR, id=i) for i in (longest, longer, longer + "n", escaped)))
        hashed = {i: hashlib.sha256(i.encode()).hexdigest() for i in (longer, longer + "n", escaped)}
        self.assertEqual(self.names(),
                         sorted([f"{longest}.cert", f"{180 * 'n'}~{hashed[longer]}.cert", f"{180 * 'n'}~{hashed[longer + 'n']}.cert",
                                 f"{30 * '%C3%A9'}~{hashed[escaped]}.cert"]))
        for name in self.names():
            self.assertTrue(self.answer("check", self.proofs / name).startswith("s VERIFIED"))

    def test_bad_cases_leave_nothing(self):
        code, _, _ = self.run_cli("depth", "--certificate", self.proofs, "-", stdin='{"id": "bad"}\n' + GOOD)
        self.assertEqual(code, 2)
        self.assertEqual(self.names(), ["good.cert"])

    def test_a_proof_that_no_checker_would_read(self):
        wide = case([["0", "0", "0"], ["1" + "0" * 100_000, "0", "0"], ["0", "1", "0"], ["0", "0", "1"]], SHIFTED, id="wide")
        code, out, err = self.run_cli("depth", "--certificate", self.proofs, "-", stdin=wide + GOOD)
        self.assertEqual((code, self.names()), (3, ["good.cert"]))
        self.assertTrue(out.startswith("good: penetrating"), out)
        self.assertIn("<stdin>:1: wide: no certificate is written", " ".join(err.split()))
        code, out, _ = self.run_cli("depth", "--json", "--embed-certificate", "-", stdin=wide + GOOD)
        bad, good = map(json.loads, out.splitlines())
        self.assertEqual((code, good["id"]), (3, "good"))
        self.assertIn("a number of more digits than the limit", bad["error"])

    def test_needs_a_folder(self):
        file = self.file("file", "old")
        for place in (file, self.folder / "no" / "proofs"):
            code, out, err = self.run_cli("depth", "--certificate", place, "-", stdin=GOOD)
            self.assertEqual((code, out), (2, ""))
            self.assertIn(f"{place}: cannot write a certificate: ", err)

    def test_embedded(self):
        self.answer("depth", "--certificate", self.proofs, "-", stdin=GOOD)
        result = json.loads(self.answer("depth", "--json", "--embed-certificate", "-", stdin=GOOD))
        self.assertEqual(result["certificate"], (self.proofs / "good.cert").read_text())


if __name__ == "__main__":
    unittest.main()
