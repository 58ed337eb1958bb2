# SPDX-License-Identifier: GPL-3.0-or-later
"""fathom certify: JUnit XML and the HTML page, as a CI system and a browser's parser read them. All else: transcripts/certify_report.md."""
import html.parser
import json
import unittest
import xml.etree.ElementTree

from harness import ROOT, UNIT, CliTest, box, case

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

    def test_the_schema_names_what_is_there(self):
        report = self.folder / "r.jsonl"
        self.certify([reply("a")], "--report", report, code=0)
        header, *_, summary = [json.loads(line) for line in report.read_text().splitlines()]
        schema = json.loads((ROOT / "verify/harness/verdict.schema.json").read_text())
        # Not there: what --method and --fit put there, and what this subject does not tell.
        for line, name in ((header, "header"), (summary, "summary")):
            left_out = {"methods", "fit", "microseconds", "hulls", "unions", "relative_excess"}
            self.assertEqual(set(line) - {"relative_excess"}, set(schema["$defs"][name]["properties"]) - left_out)

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



if __name__ == "__main__":
    unittest.main()
