# SPDX-License-Identifier: GPL-3.0-or-later
"""fathom certify: the table, JUnit XML, the list of known failures and the HTML page, as a CI system and a browser's parser read them."""
import html.parser
import json
import unittest
import xml.etree.ElementTree

from harness import UNIT, CliTest, box, case

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
        self.certify(replies, "--write-expect-fail", known, code=1)
        self.assertEqual(known.read_text().splitlines()[1:3], ["nan <b>&\"'%00%1b]]>%0a%09%20é\U0001f600%7e%25#", "too-deep a::2"])
        self.certify(replies, "--expect-fail", known, "--junit", junit, code=0)
        root = self.junit(junit)
        self.assertEqual((root.get("failures"), root.get("skipped")), ("0", "3"))

        fixed = [reply("a::1"), reply("a::2"), reply("an id", DEEP), reply(HOSTILE, "nan")]
        _, err = self.certify(fixed, "--expect-fail", known, "--junit", junit, code=1)
        self.assertIn("known.txt:3: a::2 is listed as too-deep, but passes now", err)
        self.assertIn("an%20id is listed as too-shallow, but is too-deep now", err)
        self.assertEqual([f.get("type") for f in self.junit(junit).iter("failure")], ["too-deep", "unexpected-pass"])
        _, err = self.certify(replies[:2], "--expect-fail", known, "--junit", junit, code=1)
        self.assertIn("an%20id is listed as too-shallow, but no such case was run", err)
        self.assertEqual([f.get("type") for f in self.junit(junit).iter("failure")], ["not-met", "not-met"])
        _, err = self.certify([*replies, reply("new", DEEP)], "--expect-fail", known, code=1)
        self.assertIn("new is too-deep, and is not listed", err)

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
        self.assertEqual({"script", "link", "img"} & set(page.tags), set())
        texts = " ".join(page.texts)
        for what in ["3 cases: 1 pass, 2 fail", "a::2", "too-deep", "(0.6, 0.8, 0)", "depth^2 = 1/4", "tolerance = 1e-4"]:
            self.assertIn(what, texts)
        for proof in proofs.iterdir():
            self.assertIn(proof.name, texts)
        xml.etree.ElementTree.fromstring(text.split("\n", 1)[1])  # well-formed as XML too


if __name__ == "__main__":
    unittest.main()
