# SPDX-License-Identifier: GPL-3.0-or-later
"""verify/survey/survey.py, small: it finds of each case what the committed results say, goes on, and keeps what it does not ask again.
verify/survey/page.py makes pages of that in which every link leads somewhere."""
import copy
import html.parser
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import urllib.parse

import jsonschema  # Debian: python3-jsonschema

ROOT = pathlib.Path(__file__).resolve().parents[2]
SURVEY = ROOT / "verify" / "survey"
FATHOM = os.environ["FATHOM_EXECUTABLE"]
PATIENCE = 600  # seconds until a hung run is given up
sys.path.insert(0, str(SURVEY))
import history  # noqa: E402
import page  # noqa: E402
import sets  # noqa: E402
import tables  # noqa: E402

LIBRARIES = ("libccd", "fcl", "bullet", "bullet64", "ode")
COUNT, PRIMITIVES = 92, 70
CASES = {"real": 63, "shapes": 63, "worst": 26, "20": COUNT, "primitives": PRIMITIVES}
CONTACTS = {"boxes": 100, "real-boxes": 47}


def run(program, *arguments):
    return subprocess.run([sys.executable, "-B", SURVEY / program, "--fathom", FATHOM, *map(str, arguments)], capture_output=True,
                          text=True, timeout=PATIENCE, check=False)


class Links(html.parser.HTMLParser):
    """Where a page leads, what can be led to, and what it would load."""

    def __init__(self, path):
        super().__init__()
        self.targets, self.ids, self.loaded, self.tags = [], set(), [], set()
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attrs):
        self.tags.add(tag)
        for name, value in attrs:
            if name == "href":
                self.targets.append(value)
            elif name == "id":
                self.ids.add(value)
            elif name == "src":
                self.loaded.append(value[:11])


class Changes(unittest.TestCase):
    """What changed from version to version, by a history that is made here: library 1.0, then 1.1, then the same by another fathom."""

    HELLO = {"name": "engine", "precision": "binary64", "conventions": {}}

    @staticmethod
    def answers(fathom, date, outcomes, cases="0123456789abcdef"):
        """Answers about two families of two cases, by a letter a case."""
        verdicts = [{".": "pass", "D": "too-deep", "N": "crash", "-": "unsupported"}[letter] for letter in outcomes]
        groups = {".": "right", "D": "too deep", "N": "no answer", "-": "declined"}
        return {"made": {"date": date, "fathom": fathom, "cases": cases}, "cases": len(outcomes), "outcomes": outcomes,
                "groups": {groups[letter]: outcomes.count(letter) for letter in groups if letter in outcomes},
                "verdicts": {verdict: verdicts.count(verdict) for verdict in verdicts}, "more": 1,
                "cells": {family: {"n": {verdict: part.count(verdict) for verdict in part}, "worst": ["a", "b", "c", "d"]}
                          for family, part in (("thin<", verdicts[:2]), ("real::flat", verdicts[2:]))}}

    def asked(self, *steps):
        """A subject after these runs, each (version, set, answers), as survey.py takes them up."""
        subject = {"adapter": "engine-way", "description": "", "tried": [], "sets": {}}
        for version, name, answers in steps:
            hello = {**self.HELLO, "version": version}
            history.keep(subject, hello, name, answers["made"]["fathom"])
            subject["hello"], subject["sets"][name] = hello, answers
        return subject

    def test_rows(self):
        first, then = self.answers("fathom 1", "2026-01-01", "..D-"), self.answers("fathom 1", "2026-02-02", "DN..")
        last = self.answers("fathom 2", "2026-03-03", "DN.N")
        subject = self.asked(("1.0", "real", first), ("1.0", "20", first), ("1.1", "real", then), ("1.1", "real", last))
        self.assertEqual([(history.key_of(each), list(each["sets"])) for each in subject["earlier"]],
                         [(("1.0", "fathom 1"), ["real", "20"]), (("1.1", "fathom 1"), ["real"])])
        self.assertEqual((list(subject["sets"]), subject["sets"]["real"]), (["real"], last))
        self.assertEqual(subject["earlier"][0]["sets"]["real"]["cells"]["thin<"], {"n": {"pass": 2}})
        rows = history.rows_of({"subjects": [subject]})
        self.assertEqual(rows, [
            ["engine-way", "1.0, answered 2026-01-01", "1.1, answered 2026-02-02", "real", "2 to 2 of 4",
             "no answer 0 to 1; declined 1 to 0", "2: thin<", "1: flat"],
            ["engine-way", "1.1 by fathom 1, answered 2026-02-02", "1.1 by fathom 2, answered 2026-03-03", "real", "2 to 1 of 4",
             "no answer 1 to 2", "1: flat", ""]])
        results = {"subjects": [subject]}
        self.assertIn("| engine-way | 1.0, answered 2026-01-01 | 1.1, answered 2026-02-02 | real | 2 to 2 of 4 |",
                      tables.changes_page(results))
        self.assertIn("<td>2: thin&lt;</td>", history.section(results))

    def test_sets_of_two(self):
        """Law: a row says who judged its set, whoever judged the other sets; of families with as many failures as before none is named."""
        first, then = self.answers("fathom 1", "2026-01-01", "..D-"), self.answers("fathom 1", "2026-02-02", "...D")
        last = self.answers("fathom 2", "2026-03-03", "...D")
        subject = self.asked(("1.0", "20", first), ("1.1", "20", then), ("1.1", "real", then), ("1.1", "real", last))
        self.assertEqual(list(subject["sets"]), ["20", "real"])
        self.assertEqual(history.rows_of({"subjects": [subject]}), [
            ["engine-way", "1.0, answered 2026-01-01", "1.1, answered 2026-02-02", "20", "2 to 3 of 4", "declined 1 to 0", "1", "1"],
            ["engine-way", "1.1 by fathom 1, answered 2026-02-02", "1.1 by fathom 2, answered 2026-03-03", "real", "3 to 3 of 4", "", "",
             ""]])

    def test_nothing(self):
        """Law: who was asked by one version, once or again, has nothing earlier; and neither page has a section."""
        one = self.answers("fathom 1", "2026-01-01", "..D-")
        results = {"subjects": [self.asked(("1.0", "real", one), ("1.0", "real", one), ("1.0", "20", one))]}
        self.assertNotIn("earlier", results["subjects"][0])
        self.assertEqual((history.rows_of(results), tables.changes_page(results), history.section(results)), ([], "", ""))

    def test_other_cases(self):
        """Law: what was asked about other cases is not compared case by case."""
        old, new = self.answers("fathom 1", "2026-01-01", "..D-"), self.answers("fathom 1", "2026-02-02", "....", "f" * 16)
        row, = history.rows_of({"subjects": [self.asked(("1.0", "20", old), ("1.1", "20", new))]})
        self.assertEqual(row[4:], ["2 of 4, 4 of 4", "not compared: the cases are others", "", ""])

    def test_committed(self):
        """Law: every version of results.json is in the pages that are made of it."""
        results = json.loads((SURVEY / "results.json").read_text(encoding="utf-8"))
        rows, text = history.rows_of(results), page.index(results)
        self.assertGreater(len(rows), 0)
        for row in rows:
            self.assertIn("| " + " | ".join(row) + " |", (SURVEY / "RESULTS.md").read_text(encoding="utf-8"))
            self.assertIn(f"<td>{row[2]}</td><td>{row[3]}</td><td>{row[4]}</td>", text)


class Survey(unittest.TestCase):
    maxDiff = None

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.out = cls.folder / "out"
        listed = subprocess.run([FATHOM, "certify", "--list-adapters"], stdout=subprocess.PIPE, check=True, text=True).stdout.splitlines()
        there = [line.split()[0] for line in listed if not line.endswith("; not built")]
        chosen = [name for name in there if name.split("-")[0] in LIBRARIES] + [name for name in there if name == "jolt"]
        cls.words = ["--adapters", ",".join(chosen), "--sets", ",".join([*CASES, *CONTACTS]), "--count", f"20={COUNT}", "--count",
                     f"primitives={PRIMITIVES}", "--as-by-default", "--work", cls.folder / "work", "--out", cls.out]
        done = run("survey.py", *cls.words)
        cls.talk, cls.adapters = done.stderr, chosen
        assert done.returncode == 0, done.stderr
        cls.results = json.loads((cls.out / "results.json").read_text())

    def test_results(self):
        self.assertEqual([subject["adapter"] for subject in self.results["subjects"]], self.adapters)
        for subject in self.results["subjects"]:
            for name, cases in CASES.items():
                found = subject["sets"][name]
                counted = sum(count for cell in found["cells"].values() for count in cell["n"].values())
                self.assertEqual((found["cases"], sum(found["groups"].values()), counted, len(found["outcomes"])), (cases,) * 4)
                self.assertGreaterEqual(found["alone"], found["groups"]["right"], subject["adapter"])
        manifolds = [adapter for adapter in sets.OF_BOXES if adapter in self.adapters]
        runs = len(CASES) * len(self.adapters) + len(CONTACTS) * len(sets.TOLERANCES) * len(manifolds)
        self.assertIn(f"survey: {runs} of {runs}: ", self.talk)

    def test_schema(self):
        """Law: the results, and those that are committed, obey their schema, which refuses what is wrong."""
        check = jsonschema.Draft202012Validator(json.loads((SURVEY / "survey.schema.json").read_text()))
        for results in (self.results, json.loads((SURVEY / "results.json").read_text())):
            check.validate(results)
        for path, value in ((["schema"], "fathom/survey/2"), (["more"], 1), (["groups", 0], "fine"), (["tolerance", "relative"], 0.001),
                            (["sets", "real", "digest"], "?"), (["sets", "real", "by_case"], None), (["contacts", "boxes", "cases"], -1),
                            (["contacts", "boxes", "by_case"], 1), (["subjects", 0, "hello", "version"], None),
                            (["subjects", 0, "sets", "real", "made", "date"], "today"), (["subjects", 0, "sets", "real", "outcomes"], "?"),
                            (["subjects", 0, "sets", "real", "groups"], {"fine": 1}), (["subjects", 0, "sets", "real", "more"], 1)):
            wrong = copy.deepcopy(self.results)
            place = wrong
            for step in path[:-1]:
                place = place[step]
            place[path[-1]] = value
            self.assertFalse(check.is_valid(wrong), path)

    def test_committed(self):
        """Law: the committed results are what the judge of today says of the libraries that are here, case by case: who changes the judge
        or an adapter sees here which set is older, and runs the survey of it again. Results of a set whose families have grown since are
        not compared; tables.py says below their tables that they are of older ones."""
        committed = json.loads((SURVEY / "results.json").read_text())
        of_adapter = {subject["adapter"]: subject for subject in committed["subjects"]}
        compared = 0
        for name in CASES:
            asked, known_cases = list(sets.read_cases(self.folder / "work" / f"{name}.jsonl")), self.all_cases(name)
            today = sets.digest(self.folder / f"{name}.jsonl")
            for subject in self.results["subjects"]:
                known = of_adapter[subject["adapter"]]
                if subject["hello"]["version"] != known["hello"]["version"] or name not in known["sets"]:
                    continue
                self.assertEqual(subject["hello"], known["hello"], "the adapter is newer than the results")
                if today == known["sets"][name]["made"]["cases"]:
                    then = dict(zip(known_cases, known["sets"][name]["outcomes"], strict=True))
                    now = dict(zip(asked, subject["sets"][name]["outcomes"], strict=True))
                    self.assertEqual(now, {case: then[case] for case in now}, f"{subject['adapter']} on {name}")
                    compared += len(now)
        self.assertGreater(compared, 0)

    def test_committed_contacts(self):
        """The same of contacts, count by count: of boxes each library that is here answers several, at both tolerances."""
        committed, compared = json.loads((SURVEY / "results.json").read_text())["contacts"], 0
        for name, cases in CONTACTS.items():
            found, known = self.results["contacts"][name], committed[name]
            self.assertEqual((found["cases"], found["digest"], found["command"]), (cases, known["digest"], known["command"]))
            for adapter, subject in found["subjects"].items():
                self.assertGreater(subject["told"], cases * 3 / 4)
                if subject["version"] == known["subjects"][adapter]["version"]:
                    compared += 1
                    for field in ("manifold", "told", "found", "first"):
                        self.assertEqual(subject[field], known["subjects"][adapter][field], f"{adapter} on {name}")
        self.assertGreater(compared, 0)

    def all_cases(self, name):
        """The ids of the cases that the committed results are about."""
        path = self.folder / f"{name}.jsonl"
        sets.make(sets.SETS[name], FATHOM, path)
        return list(sets.read_cases(path))

    def test_another_version(self):
        """Law: where another version had answered, its answers stay as earlier ones, and the schema has them; the rest is as it was."""
        out = self.folder / "again"
        out.mkdir()
        old = copy.deepcopy(self.results)
        subject = next(each for each in old["subjects"] if each["adapter"] == "ode-collide")
        version, subject["hello"]["version"] = subject["hello"]["version"], "0.1"
        (out / "results.json").write_text(json.dumps(old))
        done = run("survey.py", "--adapters", "ode-collide", "--sets", "real", "--as-by-default", "--resume", "--work",
                   self.folder / "work", "--out", out)
        self.assertEqual(done.returncode, 0, done.stderr)
        made = json.loads((out / "results.json").read_text())
        jsonschema.Draft202012Validator(json.loads((SURVEY / "survey.schema.json").read_text())).validate(made)
        chosen = next(each for each in made["subjects"] if each["adapter"] == "ode-collide")
        kept, = chosen["earlier"]
        self.assertEqual((kept["hello"]["version"], chosen["hello"]["version"], list(chosen["sets"])), ("0.1", version, ["real"]))
        self.assertEqual({name: found["outcomes"] for name, found in kept["sets"].items()},
                         {name: found["outcomes"] for name, found in subject["sets"].items()})
        row, = history.rows_of(made)
        self.assertEqual((row[3], row[5:]), ("real", ["", "", ""]))

    def test_other_settings(self):
        """Of one adapter, also with other settings and sizes; all else that the results have stays."""
        out = self.folder / "tried"
        out.mkdir()
        (out / "results.json").write_bytes((self.out / "results.json").read_bytes())
        done = run("survey.py", "--adapters", "bullet64-epa", "--sets", "real", "--work", self.folder / "work", "--out", out)
        self.assertEqual(done.returncode, 0, done.stderr)
        made = json.loads((out / "results.json").read_text())
        chosen = next(subject for subject in made["subjects"] if subject["adapter"] == "bullet64-epa")
        known = {(each["settings"], each["fit"]): each["right"]["real"] for each in chosen["tried"]}
        self.assertEqual(len(known), len(sets.FITS) * (1 + len(sets.TRIED["bullet64-epa"])) - 1)
        self.assertEqual(known["guess=1:1:1", ""], 63)
        chosen["tried"] = []
        self.assertEqual(made, self.results)

    def test_resume(self):
        reports = {path: path.stat().st_mtime_ns for path in (self.folder / "work").glob("*.jsonl")}
        before = (self.out / "results.json").read_bytes()
        torn = self.folder / "work" / f"20.{self.adapters[0]}.jsonl"
        torn.write_bytes(torn.read_bytes()[:5000])
        other = self.folder / "work" / f"real.{self.adapters[0]}.jsonl"
        other.write_text(other.read_text().replace('"version":"', '"version":"another ', 1))
        again = run("survey.py", *self.words, "--resume")
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertEqual((self.out / "results.json").read_bytes(), before)
        self.assertEqual(len(reports), len(list((self.folder / "work").glob("*.jsonl"))))

    def test_the_small_world(self):
        """Two shards of it, the second after an interruption; the tables count them, and every other part of the results stays."""
        out, work, chosen = self.folder / "small", self.folder / "world", "libccd-epa,ode-collide"
        out.mkdir()
        (out / "results.json").write_bytes((self.out / "results.json").read_bytes())
        words = ["--adapters", chosen, "--first", 1_500_000, "--shard", 30, "--work", work, "--out", out]
        for end in (1_500_030, 1_500_060):
            done = run("world.py", *words, "--end", end)
            self.assertEqual(done.returncode, 0, done.stderr)
            with (work / "ode-collide.jsonl").open("a", encoding="utf-8") as file:
                file.write('{"begin": 1500060, "cut o')
        self.assertNotIn("pairs up to 1500030", done.stderr)
        other = run("world.py", *words, "--end", 1_500_060, "--shard", 20)
        self.assertEqual((other.returncode, "in other shards" in other.stderr), (3, True))
        done = run("world.py", *words, "--merge")
        self.assertEqual(done.returncode, 0, done.stderr)
        made = json.loads((out / "results.json").read_text())
        jsonschema.Draft202012Validator(json.loads((SURVEY / "survey.schema.json").read_text())).validate(made)
        small = made.pop("small_world")
        self.assertEqual(made, self.results)
        self.assertEqual((small["pairs"], list(small["subjects"])), (6_463_188, chosen.split(",")))
        for adapter, subject in small["subjects"].items():
            self.assertEqual(subject["asked"], [[1_500_000, 1_500_060]])
            self.assertEqual(sum(subject["kinds"]["all"]["n"].values()), 60)
            self.assertEqual(sum(sum(found["n"].values()) for kind, found in subject["kinds"].items()
                                 if kind.startswith(("touching_", "contact_", "disjoint", "ties"))), 60, "of one way to meet each")
            for verdict, number in subject["kinds"]["all"]["first"].items():
                self.assertEqual(self.verdict(adapter, number), verdict)

    def verdict(self, adapter, number):
        """The verdict on pair `number` of the small world today."""
        pair = subprocess.run([FATHOM, "cases", "--small-world", str(number)], stdout=subprocess.PIPE, check=True).stdout
        done = subprocess.run([FATHOM, "certify", "--adapter", adapter, "--json", "-"], input=pair, stdout=subprocess.PIPE, check=False)
        return json.loads(done.stdout.splitlines()[1])["verdict"]

    def test_committed_small_world(self):
        """Law: the least failing pairs of the committed results fail today in the same way."""
        small, compared = json.loads((SURVEY / "results.json").read_text()).get("small_world", {"subjects": {}}), 0
        for subject in self.results["subjects"]:
            known = small["subjects"].get(subject["adapter"])
            if known and known["hello"]["version"] == subject["hello"]["version"]:
                for verdict, number in known["kinds"]["all"]["first"].items():
                    self.assertEqual(self.verdict(subject["adapter"], number), verdict, f"{subject['adapter']}, pair {number}")
                    compared += 1
        self.assertGreater(compared, 0)

    def test_pages(self):
        pages = self.folder / "pages"
        done = run("page.py", "--results", self.out / "results.json", "--out", pages)
        self.assertEqual(done.returncode, 0, done.stderr)
        made = {path: Links(path) for path in pages.rglob("*.html")}
        self.assertGreater(len(made), 20)
        certificates = set()
        for path, links in made.items():
            self.assertLessEqual(set(links.loaded), {"data:image/"})
            self.assertNotIn("script", links.tags)
            for target in links.targets:
                place, _, anchor = target.partition("#")
                file = (path.parent / urllib.parse.unquote(place)).resolve() if place else path
                self.assertTrue(file.exists(), f"{path}: {target}")
                if file.suffix == ".cert":
                    certificates.add(file)
                if anchor:
                    self.assertIn(anchor, made[file].ids, f"{path}: {target}")
        self.assertGreater(len(certificates), 20)
        for certificate in list(certificates)[:5]:
            self.assertEqual(subprocess.run([FATHOM, "check", certificate], capture_output=True, check=False).returncode, 0, certificate)

    def test_wrong_arguments(self):
        for words, said in ((["--counts", 3], "unrecognized"), (["--count", "20"], "SET=N"), (["--count", "real=3"], "SET=N"),
                            (["--sets", "all"], "no set all"), (["--adapters", "nobody"], "nobody")):
            done = run("survey.py", "--work", self.folder / "none", "--out", self.folder / "none", *words)
            self.assertEqual(done.returncode, 2)
            self.assertIn(said, done.stderr)
        other = self.folder / "other.json"
        other.write_text('{"schema": "fathom/survey/2"}')
        done = run("page.py", "--results", other, "--out", self.folder / "none")
        self.assertEqual((done.returncode, "expected the schema fathom/survey/3" in done.stderr), (2, True))
        self.assertFalse((self.folder / "none").exists())


if __name__ == "__main__":
    unittest.main()
