# SPDX-License-Identifier: GPL-3.0-or-later
"""fathom certify --replay: recorded replies, whole ones and others."""
import unittest

from certify_harness import CertifyTest, boxes


class Replays(CertifyTest):
    REPLY = '{"type":"reply","id":"box::0","overlap":true,"depth":0.5,"direction":[-1,0,0]}\n'

    def replay(self, replies, stream):
        return self.certify("--replay", self.file("replies.jsonl", replies), "-", stdin=stream)

    def test_whole(self):
        code, lines, err = self.replay(self.REPLY, boxes(0))
        self.assertEqual((code, self.verdicts(lines), err), (0, {"box::0": "pass"}, ""))
        self.assertEqual(lines[0]["subject"]["name"], "replay")

    def test_from_standard_input(self):
        cases = self.file("cases.jsonl", boxes(0))
        code, lines, err = self.certify("--replay", "-", cases, stdin=self.REPLY)
        self.assertEqual((code, self.verdicts(lines), err), (0, {"box::0": "pass"}, ""))
        code, _, err = self.certify("--replay", "-", cases, stdin="noise\n")
        self.assertIn("<stdin>:1: expected a JSON object, found 'noise'", err)
        self.assertIn("cannot both come from standard input", self.refused("certify", "--replay", "-", "-", stdin=self.REPLY))

    def test_hello_and_order(self):
        hello = ('{"type":"hello","protocol":"fathom/subject/1","name":"mine","version":"3","precision":"binary32",'
                 '"conventions":{"touching":"either","depth":"negative","moves":"b","unit":true}}\n')
        mirrored = self.REPLY.replace("-1,", "1,")
        replies = mirrored.replace("0.5", "-0.4").replace("::0", "::100") + mirrored.replace("0.5", "-0.5")
        code, lines, err = self.replay(hello + replies, boxes(0) + boxes(100))
        self.assertEqual((code, set(self.verdicts(lines).values()), lines[0]["subject"]["precision"]), (0, {"pass"}, "binary32"), err)

    def test_lacks_a_case(self):
        code, lines, err = self.replay(self.REPLY, boxes(0) + boxes(1))
        self.assertEqual((code, self.verdicts(lines), lines[-1]["type"]), (4, {"box::0": "pass"}, "case"))
        self.assertIn("no reply to case 'box::1'", err)

    def test_more_than_asked(self):
        code, lines, err = self.replay(self.REPLY + self.REPLY.replace("::0", "::9"), boxes(0))
        self.assertEqual((code, self.verdicts(lines)), (0, {"box::0": "pass"}))
        self.assertIn("the reply to 'box::9' is to no case", err)

    def test_two_replies(self):
        code, lines, _ = self.replay(self.REPLY + self.REPLY, boxes(0))
        self.assertEqual((code, self.verdicts(lines)), (1, {"box::0": "garbage"}))

    def test_bad_lines(self):
        code, lines, err = self.replay(self.REPLY + "noise\n" + self.REPLY[:30], boxes(0))
        self.assertEqual((code, self.verdicts(lines)), (2, {"box::0": "pass"}))
        self.assertIn("replies.jsonl:2: expected a JSON object, found 'noise'", err)
        self.assertIn("replies.jsonl:3: ", err)


if __name__ == "__main__":
    unittest.main()
