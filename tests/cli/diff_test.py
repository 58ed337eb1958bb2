# SPDX-License-Identifier: GPL-3.0-or-later
"""fathom certify diff: reports of replays whose changes are known, as text, JSON under its schema and a page."""
import html.parser
import json
import unittest

import jsonschema  # Debian: python3-jsonschema
from harness import ROOT, UNIT, CliTest, box, case

SCHEMA = jsonschema.Draft202012Validator(json.loads((ROOT / "verify/harness/diff.schema.json").read_text()))
RIGHT, DEEP, DEEPER, SHALLOW, NONE, DECLINED = 0.5, 0.75, 1, 0.25, None, "declined"


def hello(version="1", precision="binary64", **settings):
    return json.dumps({"type": "hello", "protocol": "fathom/subject/1", "name": "demo <&>", "version": version, "precision": precision,
                       "conventions": {"touching": "either", "depth": "positive", "moves": "a", "unit": True}, "settings": settings}) + "\n"


def reply(name, depth):
    answer = {"unsupported": "no"} if depth is DECLINED else {"overlap": False} if depth is NONE else {"overlap": True, "depth": depth}
    return json.dumps({"type": "reply", "id": name, **answer}) + "\n"


class Diff(CliTest):
    def report(self, name, depths, greeting=None, shift=0.5):
        """The report of a replay with these depths about cubes that overlap by 1/2, the largest coordinate being 3/2."""
        path = self.folder / name
        cases = "".join(case(box([shift, 0, 0], [1.5, 1, 1]), UNIT, id=each) for each in depths)
        replies = (greeting or hello()) + "".join(reply(each, depth) for each, depth in depths.items())
        code, _, err = self.run_cli("certify", "--replay", self.file("replies.jsonl", replies), "--report", path,
                                    self.file("cases.jsonl", cases))
        self.assertLess(code, 2, err)
        return path

    def diff(self, old, new, code):
        got, out, err = self.run_cli("certify", "diff", "--json", old, new)
        self.assertEqual(got, code, err)
        value = json.loads(out)
        SCHEMA.validate(value)
        return value

    def test_changes(self):
        old = self.report("old", {"f::a": RIGHT, "f::b": RIGHT, "f::c": DEEP, "f::d": DEEP, "f::e": DEEP, "f::old": RIGHT, "f::g": RIGHT},
                          hello(margin="0"))
        new = self.report("new", {"f::a": SHALLOW, "f::b": RIGHT, "f::c": RIGHT, "f::d": SHALLOW, "f::e": DEEPER, "f::n1": RIGHT,
                                  "f::n2": DEEP, "f::g": NONE}, hello("2", margin="0.5"))
        value = self.diff(old, new, 1)
        names = {key: [(each["id"], each["old"], each["new"]) for each in value[key]]
                 for key in ("newly_failing", "newly_passing", "another_verdict", "largest_changes")}
        self.assertEqual(names, {"newly_failing": [("f::a", "pass", "too-shallow"), ("f::g", "pass", "false-separation")],
                                 "newly_passing": [("f::c", "too-deep", "pass")], "another_verdict": [("f::d", "too-deep", "too-shallow")],
                                 "largest_changes": [("f::e", "too-deep", "too-deep")]})
        worst = value["largest_changes"][0]
        self.assertEqual((worst["old_error"], worst["new_error"]), (0.25 / 1.5, 0.5 / 1.5))
        self.assertNotIn("new_error", value["newly_failing"][1])
        self.assertEqual((value["both"], value["only_old"], value["only_new"], value["other_points"]), (6, 1, 2, 0))
        self.assertEqual(value["verdicts"], {"false-separation": {"old": 0, "new": 1}, "too-deep": {"old": 3, "new": 1},
                                             "too-shallow": {"old": 0, "new": 2}, "pass": {"old": 3, "new": 2}})
        self.assertEqual(value["header"], {"subject.version": {"old": "1", "new": "2"},
                                           "subject.settings.margin": {"old": "0", "new": "0.5"}})
        back = self.diff(new, old, 0 if not names["newly_passing"] else 1)
        self.assertEqual([each["id"] for each in back["newly_failing"]], ["f::c"])
        self.assertEqual([each["id"] for each in back["newly_passing"]], ["f::a", "f::g"])

    def test_declined(self):
        """What was declined before can newly fail or pass; what is declined now is no failure."""
        depths = {"f::a": DECLINED, "f::b": DECLINED, "f::c": DEEP, "f::d": RIGHT}
        old = self.report("old", depths)
        value = self.diff(old, self.report("new", {"f::a": DEEP, "f::b": RIGHT, "f::c": DECLINED, "f::d": DECLINED}, hello(margin="1")), 1)
        self.assertEqual([[each["id"] for each in value[key]] for key in ("newly_failing", "newly_passing", "another_verdict")],
                         [["f::a"], ["f::b"], ["f::c", "f::d"]])
        self.assertEqual(value["header"], {"subject.settings.margin": {"old": "", "new": "1"}})

    def test_variants(self):
        """A variant of a case is compared with the same variant."""
        def with_variants(name, depth, of_variant):
            case_line = self.report(name, {"f::a": depth}).read_text().splitlines(keepends=True)
            variant = self.report(name + " variant", {"f::a": of_variant}).read_text().splitlines(keepends=True)[1]
            return self.file(name + " both", "".join([*case_line[:2], variant.replace('"id":"f::a"', '"id":"f::a","variant":"swap"')]))
        value = self.diff(with_variants("old", RIGHT, DEEP), with_variants("new", RIGHT, RIGHT), 0)
        self.assertEqual([(each["id"], each["variant"]) for each in value["newly_passing"]], [("f::a", "swap")])
        self.assertEqual((value["newly_failing"], value["both"]), ([], 2))

    def test_nothing_changed(self):
        old, new = self.report("old", {"f::a": RIGHT, "f::b": DEEP}), self.report("new", {"f::b": DEEP, "f::a": RIGHT})
        value = self.diff(old, new, 0)
        self.assertEqual((value["header"], value["newly_failing"], value["largest_changes"]), ({}, [], []))
        self.assertIn("0 newly failing, 0 newly passing, 0 with another verdict; 2 in both\n", self.answer("certify", "diff", old, new))

    def test_other_points(self):
        """A case that another precision, or another stream, shows differently is still compared, and counted."""
        old = self.report("old", {"f::a": RIGHT})
        moved = self.report("moved", {"f::a": DEEP}, shift=0.25)
        self.assertEqual(self.diff(old, moved, 0)["other_points"], 1)
        single = self.report("single", {"f::a": DEEP}, hello(precision="binary32"))
        value = self.diff(old, single, 1)
        self.assertEqual(value["newly_failing"][0]["new_error"], 0.25 / 1.5, "in parts of R, whatever the precision")
        self.assertEqual(value["header"], {"subject.precision": {"old": "binary64", "new": "binary32"}})

    def test_cut_short(self):
        """A report of a run that was killed, whose last line is torn, and a case that was run again."""
        old = self.report("old", {"f::a": RIGHT, "f::b": RIGHT})
        lines = old.read_text().splitlines(keepends=True)
        again = self.report("again", {"f::a": DEEP}).read_text().splitlines(keepends=True)[1]
        torn = self.file("torn", "".join([*lines[:3], again, lines[1][:40]]))
        value = self.diff(old, torn, 1)
        self.assertEqual([each["id"] for each in value["newly_failing"]], ["f::a"])
        self.assertEqual((value["new"]["whole"], value["old"]["whole"], value["new"]["repeated"], value["both"]), (False, True, 1, 2))
        code, out, _ = self.run_cli("certify", "diff", old, torn)
        self.assertEqual(code, 1)
        self.assertIn("cut short: it has no summary", out)

    def test_bad_input(self):
        old = self.report("old", {"f::a": RIGHT})
        text = old.read_text()
        for content, words in (("", "it is empty: expected a report"),
                               ("{}\n", ":1: expected the header of a report, schema fathom/verdict/1"),
                               (text.replace('"verdict":"pass"', '"verdict":"fine"', 1), ":2: expected a line of schema fathom/verdict/1"),
                               ("\n" + text, ":1: expected the header")):
            self.assertIn(words, self.refused("certify", "diff", old, self.file("bad", content)))
        self.assertIn("none of this name", self.refused("certify", "diff", self.folder / "missing", old))
        for words, said in (([old], "found 1 argument"), ([old, old, old], "found 3 arguments"), ([], "found 0 arguments"),
                            (["--html=", old, old], "--html"), (["--html", "-", old, old], "--html writes a file"),
                            (["--jsn", old, old], "did you mean '--json'?")):
            self.assertIn(said, self.refused("certify", "diff", *words))

    def test_page(self):
        old = self.report("old", {"<b>::a": RIGHT, "f::c": DEEP}, hello(margin="<i>"))
        new = self.report("new", {"<b>::a": DEEP, "f::c": RIGHT}, hello("2"))
        page = self.folder / "page.html"
        self.assertEqual(self.run_cli("certify", "diff", "--html", page, old, new)[0], 1)
        texts = []

        class Reader(html.parser.HTMLParser):
            def handle_data(self, data):
                texts.append(data)
        Reader().feed(page.read_text())
        for expected in ("demo <&> 2", "<b>::a", "subject.settings.margin", "<i>", "Newly failing", "f::c"):
            self.assertIn(expected, " ".join(texts))
        self.assertIn("Content-Security-Policy", page.read_text())
        self.assertIn("1 newly failing, 1 newly passing, 0 with another verdict; 2 in both", " ".join(texts))

    def test_help(self):
        self.assertEqual(self.answer("help", "certify", "diff"), self.answer("certify", "diff", "--help"))
        self.assertIn("diff  What changed between two reports.", self.answer("certify", "--help"))


if __name__ == "__main__":
    unittest.main()
