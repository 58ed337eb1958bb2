# SPDX-License-Identifier: GPL-3.0-or-later
"""fathom certify: the table, JUnit XML, the list of known failures and the HTML page, as a CI system and a browser's parser read them."""
import html.parser
import json
import shlex
import unittest
import xml.etree.ElementTree

from harness import ROOT, UNIT, VERSION, CliTest, box, case

HELLO = json.dumps({"type": "hello", "protocol": "fathom/subject/1", "name": "demo <&>", "version": "1", "precision": "binary64",
                    "conventions": {"touching": "either", "depth": "positive", "moves": "a", "unit": True},
                    "settings": {"tolerance": "1e-4"}}) + "\n"
HOSTILE = "<b>&\"'\u0000\u001b]]>\n\t é\U0001f600~%#"
RIGHT, DEEP, SHALLOW = 0.5, 0.75, 0.25


def reply(name, depth=RIGHT, **fields):
    return json.dumps({"type": "reply", "id": name, "overlap": True, "depth": depth, **fields}) + "\n"


class Page(html.parser.HTMLParser):
    """Tags in order, texts, and what an element refers to."""

    def __init__(self, text):
        super().__init__()
        self.tags, self.texts, self.references = [], [], []
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attrs):
        self.tags.append(tag)
        self.references += [value for name, value in attrs if name in ("src", "href", "srcset", "data", "action")]

    def handle_data(self, data):
        self.texts.append(data)


class Reports(CliTest):
    def certify(self, replies, *options, code, ids=None):
        """stdout and stderr of a run over cubes that overlap by 1/2, one for each reply."""
        ids = [json.loads(line)["id"] for line in replies] if ids is None else ids
        cases = "".join(case(box([0.5, 0, 0], [1.5, 1, 1]), UNIT, id=name) for name in ids)
        got, out, err = self.run_cli("certify", "--replay", self.file("replies.jsonl", HELLO + "".join(replies)), *options,
                                     self.file("cases.jsonl", cases))
        self.assertEqual(got, code, out + err)
        return out, err

    def junit(self, path):
        """The root, its structure checked as the JUnit schema has it."""
        root = xml.etree.ElementTree.parse(path).getroot()
        self.assertEqual(root.tag, "testsuites")
        for suite in root:
            self.assertEqual(suite.tag, "testsuite")
            self.assertEqual([child.tag for child in suite][0], "properties")
            self.assertEqual({child.tag for child in suite} - {"properties", "testcase"}, set())
            tests = suite.findall("testcase")
            for test in tests:
                self.assertLessEqual({"name", "classname", "time"}, set(test.attrib))
                self.assertIn([child.tag for child in test], [[], ["failure"], ["error"], ["skipped"]])
            for attribute, tag in [("failures", "failure"), ("errors", "error"), ("skipped", "skipped")]:
                self.assertEqual(int(suite.get(attribute)), len(suite.findall(f"testcase/{tag}")))
            self.assertEqual(int(suite.get("tests")), len(tests))
        for attribute in ("tests", "failures", "errors", "skipped"):
            self.assertEqual(int(root.get(attribute)), sum(int(suite.get(attribute)) for suite in root))
        return root

    def test_table(self):
        out, _ = self.certify([reply("a::1"), reply("a::2", DEEP), reply("b-n8-s1", SHALLOW)], code=1)
        self.assertIn("demo <&> 1 (binary64)", out)
        rows = {line.split()[0]: line.split()[1:] for line in out.splitlines() if line.strip()}
        self.assertEqual(rows["a"][:4], ["2", "1", "1", "."])
        self.assertEqual(rows["b"][:4], ["1", ".", ".", "1"])
        self.assertEqual(rows["all"][:6], ["3", "1", "1", "1", "0.5", "0.5"])
        self.assertEqual(out.splitlines()[-1], "3 cases: 1 pass, 2 fail")

    def test_what_was_judged(self):
        """A misspelt field passes, so the run must say what it did not judge."""
        misspelt = [json.dumps({"type": "reply", "id": f"a::{i}", "overlap": True, "depht": 99, "direction": [1, 0, 0],
                                "witness": {"a": [0, 0, 0], "B": [0, 0, 0]}}) + "\n" for i in range(9)]
        path = self.folder / "page.html"
        out, err = self.certify(misspelt, "--html", path, "--jobs", "1", code=0)  # one thread: the order is that of the cases
        self.assertIn("\njudged       overlap in 9 of 9 cases; depth in 0 of 9 said to overlap; direction in 0; witness in 0\n", out)
        warning = ('depth judged 0 of 9: no answer that says the bodies overlap has a "depth", and without one no direction and no witness '
                   "is judged")
        self.assertIn("fathom: " + warning, err)
        self.assertIn("fathom: a::0: the field 'depht' is not read: is 'depth' meant?; the field 'B' is not read: is 'b' meant?\n", err)
        self.assertIn("misspelt fields: 4 more like these", err)
        texts = " ".join(Page(path.read_text()).texts)
        self.assertIn(warning, texts)
        self.assertIn("depth in 0 of 9 said to overlap", texts)

        out, err = self.certify([*misspelt, reply("b")], "--json", "--jobs", "1", code=0)
        lines = [json.loads(line) for line in out.splitlines()]
        self.assertEqual(lines[-1]["judged"], {"overlap": 10, "overlapping": 10, "depth": 1, "direction": 0, "witness": 0, "contacts": 0,
                                               "distance": 0})
        self.assertEqual(lines[1]["detail"][:36], "the field 'depht' is not read: is 'd")
        self.assertNotIn("depth judged", err)
        whole = reply("c", direction=[1, 0, 0], witness={"a": [0.5, 0, 0], "b": [1, 0, 0]})
        apart = json.dumps({"type": "reply", "id": "d", "overlap": False, "depth": 1}) + "\n"
        out, err = self.certify([whole, apart, json.dumps({"type": "reply", "id": "e", "failed": "x"}) + "\n"], code=1)
        self.assertIn("\njudged       overlap in 2 of 3 cases; depth in 1 of 1 said to overlap; direction in 1; witness in 1\n", out)
        self.assertEqual(err, "")

    def test_the_table_names_failing_cases(self):
        replies = [reply(f"a::{i}", RIGHT + i / 100) for i in range(1, 8)] + [reply("b::\x1b[2J", SHALLOW)]
        report, page = self.folder / "r.jsonl", self.folder / "page.html"
        out, _ = self.certify(replies, code=1)
        self.assertIn("\nfailing cases, the worst of each verdict first\n"
                      "  too-deep          a::7; a::6; a::5; a::4; a::3; 2 more\n"
                      "  too-shallow       b::\\x1b[2J\n"
                      "see          --report FILE holds every verdict with its numbers; --html FILE shows the failures in pictures\n", out)
        out, _ = self.certify(replies, "--report", report, "--html", page, code=1)
        self.assertIn(f"{report} for every verdict", out)
        self.assertIn(f"{page} for pictures", out)
        out, _ = self.certify([reply("a")], code=0)
        self.assertNotIn("failing", out)
        self.assertNotIn("--report", out)

    def test_where_it_comes_from(self):
        """Version and command are in every report; a resumed run is the same run whatever else it is asked for."""
        report, page, junit = self.folder / "r.jsonl", self.folder / "page.html", self.folder / "junit.xml"
        words = ["--report", report, "--html", page, "--junit", junit, "--tol-rel", "1/7", "--certificates", self.folder / "a 'proof'"]
        self.certify([reply("a")], *words, code=0)
        header, *_, summary = [json.loads(line) for line in report.read_text().splitlines()]
        self.assertEqual(header["fathom"], VERSION)
        self.assertEqual(shlex.split(header["command"]), ["fathom", "certify", "--replay", str(self.folder / "replies.jsonl"),
                                                          *map(str, words), str(self.folder / "cases.jsonl")])
        texts = " ".join(Page(page.read_text()).texts)
        self.assertIn(f"Judged by fathom {VERSION}.", texts)
        self.assertIn(header["command"].replace(f"{self.folder}/", ""), texts)
        properties = {p.get("name"): p.get("value") for p in self.junit(junit).iter("property")}
        self.assertEqual((properties["fathom"], properties["command"]), (VERSION, header["command"]))
        schema = json.loads((ROOT / "verify/harness/verdict.schema.json").read_text())
        # Not there: what --method and --fit put there, and what this subject does not tell.
        for line, name in ((header, "header"), (summary, "summary")):
            left_out = {"methods", "fit", "microseconds", "hulls", "unions", "dearer"}
            self.assertEqual(set(line) - {"dearer"}, set(schema["$defs"][name]["properties"]) - left_out)

        before = report.read_text()
        self.certify([reply("a")], "--report", report, "--resume", "--tol-rel", "1/7", code=0)
        self.assertEqual(report.read_text(), before)
        for old, new in ((f'"fathom":"{VERSION}"', '"fathom":"0.0.0"'), ('"type":"header"', '"type":"case"')):
            report.write_text(before.replace(old, new, 1))
            _, err = self.certify([reply("a")], "--report", report, "--resume", "--tol-rel", "1/7", code=2)
            self.assertIn("r.jsonl:1: this report is of another", err)

    def test_lines_are_ascii(self):
        """A terminal may obey what is no ASCII: U+009B begins an escape sequence."""
        name = "é\x9b2J\x7f\x1b"
        out, _ = self.certify([reply(name)], "--json", code=0)
        self.assertTrue(out.isascii())
        self.assertEqual([c for c in out if c != "\n" and not c.isprintable()], [])
        self.assertEqual(json.loads(out.splitlines()[1])["id"], name)

    def test_junit(self):
        path = self.folder / "junit.xml"
        replies = [reply("a::1"), reply("a::2", DEEP), reply("b-n8-s1", "nan"), reply(HOSTILE, SHALLOW),
                   json.dumps({"type": "reply", "id": "a::3", "unsupported": "flat <body>"}) + "\n",
                   json.dumps({"type": "reply", "id": "a::4", "failed": "std::logic_error: <&>"}) + "\n"]
        self.certify(replies, "--junit", path, code=1)
        root = self.junit(path)
        self.assertEqual((root.get("tests"), root.get("failures"), root.get("errors"), root.get("skipped")), ("6", "3", "1", "1"))
        self.assertEqual([suite.get("name") for suite in root], ["demo <&>", "demo <&>.a", "demo <&>.b"])
        children = {test.get("name"): test[0] for test in root.iter("testcase") if len(test)}
        self.assertEqual(children["a::2"].get("type"), "too-deep")
        self.assertEqual(children["b-n8-s1"].get("type"), "nan")
        self.assertIn("std::logic_error: <&>", children["a::4"].get("message"))
        self.assertIn("flat <body>", children["a::3"].get("message"))
        shown = HOSTILE.replace("\u0000", "\\x00").replace("\u001b", "\\x1b")
        self.assertEqual(children[shown].get("type"), "too-shallow")

    def test_known_failures(self):
        known, junit = self.folder / "known.txt", self.folder / "junit.xml"
        replies = [reply("a::1"), reply("a::2", DEEP), reply("an id", SHALLOW), reply(HOSTILE, "nan")]
        self.certify(replies, "--write-expect-fail", known, code=0)
        self.assertEqual(known.read_text().splitlines()[1:3], ["nan <b>&\"'%00%1b]]>%0a%09%20é\U0001f600%7e%25#", "too-deep a::2"])
        self.certify(replies, "--expect-fail", known, "--junit", junit, code=0)
        root = self.junit(junit)
        self.assertEqual((root.get("failures"), root.get("skipped")), ("0", "3"))

        fixed = [reply("a::1"), reply("a::2"), reply("an id", DEEP), reply(HOSTILE, "nan")]
        _, err = self.certify(fixed, "--expect-fail", known, "--junit", junit, code=1)
        self.assertIn("known.txt:3: a::2 is listed as too-deep, but passes now", err)
        self.assertEqual(err.count(f"--write-expect-fail {known} brings the list up to date\n"), 1, err)
        self.assertIn("an%20id is listed as too-shallow, but is too-deep now", err)
        self.assertEqual([f.get("type") for f in self.junit(junit).iter("failure")], ["too-deep", "unexpected-pass"])
        _, err = self.certify(replies[:2], "--expect-fail", known, "--junit", junit, code=1)
        self.assertIn("an%20id is listed as too-shallow, but no such case was run", err)
        self.assertEqual([f.get("type") for f in self.junit(junit).iter("failure")], ["not-met", "not-met"])
        _, err = self.certify([*replies, reply("new", DEEP)], "--expect-fail", known, code=1)
        self.assertIn("new is too-deep, and is not listed", err)

    def test_comments_of_the_list_stay(self):
        old = ("# Known failures of demo 0, for fathom certify --expect-fail. A line: verdict, id, perhaps a comment.\n"
               "# All of them are told upstream.\n\ntoo-deep b   # ticket 7\r\ntoo-deep  a # ticket 8\n  # the odd ones\n"
               "too-deep gone # ticket 9\nnan a%20%63#x # ticket 10\ntoo-deep c # ticket 11\n# the end")
        known = self.file("known.txt", old)
        replies = [reply("z", DEEP), reply("a", DEEP), reply("b", DEEP), reply("gone"), reply("a c#x", "nan"), reply("c", SHALLOW)]
        self.certify(replies, "--write-expect-fail", known, code=0)
        new = ("# Known failures of demo <&> 1 (binary64), for fathom certify --expect-fail. A line: verdict, id, perhaps a comment.\n"
               "# All of them are told upstream.\n\ntoo-deep b   # ticket 7\ntoo-deep  a # ticket 8\n  # the odd ones\n"
               "nan a%20%63#x # ticket 10\n# the end\ntoo-deep z\ntoo-shallow c\n")
        with open(known, encoding="utf-8") as file:
            self.assertEqual(file.read(), new)
        self.certify(replies, "--expect-fail", known, "--write-expect-fail", known, code=0)
        with open(known, encoding="utf-8") as file:
            self.assertEqual(file.read(), new, "as it was")

        notes = self.file("notes.txt", "buy milk\n")
        _, err = self.certify(replies, "--write-expect-fail", notes, code=2)
        self.assertIn("notes.txt:1: expected a verdict", err)
        with open(notes, encoding="utf-8") as file:
            self.assertEqual(file.read(), "buy milk\n", "no list, so not ours to replace")

    def test_bad_list(self):
        for content in ["too-deep\n", "pass a\n", "wrong a\n", "nan an id\n", b"nan \xff%\n"]:
            _, err = self.certify([reply("a")], "--expect-fail", self.file("known.txt", content), code=2)
            self.assertIn("known.txt:1: ", err)

    def test_html(self):
        path, proofs = self.folder / "page.html", self.folder / "proofs"
        self.certify([reply("a::1"), reply("a::2", DEEP, direction=[0.6, 0.8, 0]), reply(HOSTILE, SHALLOW)], "--html", path,
                     "--certificates", proofs, code=1)
        text = path.read_text()
        page = Page(text)
        self.assertEqual(page.tags.count("article"), 2)
        self.assertGreaterEqual(page.tags.count("svg"), 4)
        self.assertEqual([reference for reference in page.references if not reference.startswith("#")], [])
        self.assertEqual((page.tags.count("script"), {"link", "img", "iframe"} & set(page.tags)), (1, set()))
        self.assertIn("<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'sha256-", text)
        self.assertNotIn("http:", text)
        self.assertNotIn("https:", text)
        texts = " ".join(page.texts)
        for what in ["3 cases: 1 pass, 2 fail", "a::2", "too-deep", "(0.6, 0.8, 0)", "depth^2 = 1/4", "tolerance = 1e-4"]:
            self.assertIn(what, texts)
        for proof in proofs.iterdir():
            self.assertIn(proof.name, texts)
        xml.etree.ElementTree.fromstring(text.split("\n", 1)[1])  # well-formed as XML too
        self.assertIn("direction in which A moves", texts)
        self.assertNotIn("the subject moves B", texts)
        self.assertNotIn(str(self.folder), text, "files are named without their folders")

    def test_html_says_whose_direction_it_is(self):
        path = self.folder / "page.html"
        hello = HELLO.replace('"moves": "a"', '"moves": "b"').replace("positive", "negative")
        replies = self.file("replies.jsonl", hello + reply("a::2", -DEEP, direction=[-0.6, -0.8, 0]))
        code, _, err = self.run_cli("certify", "--replay", replies, "--html", path, "-",
                                    stdin=case(box([0.5, 0, 0], [1.5, 1, 1]), UNIT, id="a::2"))
        self.assertEqual(code, 1, err)
        texts = " ".join(Page(path.read_text()).texts)
        for what in ("direction in which B moves", "depth, negative where they overlap", "(-0.6, -0.8, 0)", "B moves;",
                     "the translation of A that is claimed, which is that of B turned round: the subject moves B"):
            self.assertIn(what, texts)


if __name__ == "__main__":
    unittest.main()
