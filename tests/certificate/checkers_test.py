#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every case of every family, the catalogue and the real cases: `fathom depth` certifies it, and all checkers accept the certificate, with
the answer that was printed. So they do with the cases of public reports."""
import json
import os
import pathlib
import tempfile
import unittest

from pairs import CHECKERS, FATHOM, ROOT, accepted_answers, families, run


def all_cases():
    yield run(FATHOM, "cases", "--catalogue")
    yield (ROOT / "tests" / "data" / "real_cases.jsonl").read_text()
    for family in families():
        yield run(FATHOM, "cases", "--family", family, "--count", 2, "--seed", 5, "--size", 9)
        yield run(FATHOM, "cases", "--family", family, "--count", 1, "--seed", 50, "--size", 22)


def expected(result, name):
    if result["status"] == "disjoint":
        return f"s VERIFIED disjoint signed_depth=-sqrt({result['distance']['squared']})+0 {name}"
    line = f"s VERIFIED {result['status']} depth_squared={result['depth']['squared']}"
    return line + (f" optima={len(result['optima'])}" if result["optima"] else "") + f" {name}"


class Checkers(unittest.TestCase):
    maxDiff = None

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.cases = "".join(all_cases())
        cls.lines = run(FATHOM, "depth", "--json", "--embed-certificate", "--certificate", cls.folder.name, "-", stdin=cls.cases)
        cls.results = {result["id"]: result for result in map(json.loads, cls.lines.splitlines())}

    def test_one_certificate_for_each_case(self):
        self.assertGreater(len(self.results), 300)
        self.assertEqual(len(os.listdir(self.folder.name)), len(self.results))
        for result in self.results.values():
            self.assertTrue(result["certificate"].startswith(f"fathom-certificate {2 if result['status'] == 'disjoint' else 1}\n"))

    def test_all_checkers_accept_all_of_them(self):
        paths = sorted(str(path) for path in pathlib.Path(self.folder.name).iterdir())
        ids = list(self.results)
        stream = pathlib.Path(self.folder.name).parent / (pathlib.Path(self.folder.name).name + ".all")
        self.addCleanup(stream.unlink)
        stream.write_text("".join(self.results[i]["certificate"] for i in ids))
        wanted = [expected(self.results[i], i) for i in ids]
        for name, command in CHECKERS.items():
            with self.subTest(checker=name):
                self.assertEqual(run(*command, stream).splitlines(), wanted)
        self.assertEqual(len(run(*CHECKERS["fathom-check"], *paths).splitlines()), len(ids))

    def test_results_carry_them(self):
        path = pathlib.Path(self.folder.name).parent / (pathlib.Path(self.folder.name).name + ".jsonl")
        self.addCleanup(path.unlink)
        path.write_text(self.lines)
        self.assertEqual(run(*CHECKERS["fathom-check"], "--results", path).splitlines(),
                         [expected(result, i) for i, result in self.results.items()])

    def test_the_method_proves_the_same(self):
        lines = run(FATHOM, "depth", "--json", "--embed-certificate", "--method", "certificate", "-", stdin=self.cases)
        for result in map(json.loads, lines.splitlines()):
            other = dict(self.results[result["id"]], method=result["method"])
            self.assertEqual(result, other)

    def test_reports_of_all_kinds_of_bodies(self):
        cases = "".join((ROOT / "tests" / "data" / name).read_text() for name in ("report_cases.jsonl", "report_solids.jsonl"))
        results = accepted_answers(self, cases)
        self.assertEqual([(result["id"], result["status"]) for result in results],
                         [(case["id"], case["answer"]["status"]) for case in map(json.loads, cases.splitlines())])


if __name__ == "__main__":
    unittest.main()
