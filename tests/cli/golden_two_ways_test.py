# SPDX-License-Identifier: GPL-3.0-or-later
"""`fathom golden verify --method`: every value computed again, and the page on which a release says so."""
import copy
import json
import shutil
import unittest

import jsonschema  # Debian: python3-jsonschema
from golden_release import COMMITTED, CONTENTS, GoldenTest, contents, page, sha256
from harness import ROOT

PAGE = "agreement.json"


class TwoWays(GoldenTest):
    def verified(self, folder, *options):
        return self.answer("golden", "verify", *options, folder)

    def refusal(self, folder, reason):
        code, out, err = self.run_cli("golden", "verify", folder)
        self.assertEqual((code, err), (1, ""), out)
        self.assertRegex(out, rf"^s REFUSED {PAGE}: .*{reason}")

    def stated(self):
        """A release with its page."""
        folder = self.folder / "stated"
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(self.release, folder)
        self.verified(folder, "--method", "exact", "--method", "naive", "--state")
        return folder

    def test_the_committed_release_is_what_its_page_says(self):
        """By the exact method, which shares nothing with the way that made it; and by the naive one."""
        methods = json.loads((COMMITTED / PAGE).read_text())["methods"]
        self.assertIn("exact", methods)
        out = self.verified(COMMITTED, *(word for method in methods for word in ("--method", method)))
        self.assertTrue(out.startswith("s VERIFIED L0 version=1.3.0 seed=1 "), out)
        self.assertIn(f" agreed={','.join(methods)} ", out)

    def test_page(self):
        folder = self.stated()
        value = json.loads((folder / PAGE).read_text())
        records = json.loads((folder / "dataset.json").read_text())["records"]
        self.assertEqual(value, {"schema": "fathom/golden-agreement/2", "content_sha256": sha256((folder / CONTENTS).read_bytes()),
                                 "records": records, "methods": ["exact", "naive"]})
        schema = json.loads((ROOT / "verify/golden/agreement.schema.json").read_text())
        jsonschema.Draft202012Validator.check_schema(schema)
        validator = jsonschema.Draft202012Validator(schema)
        validator.validate(value)
        for field in value:
            self.assertFalse(validator.is_valid({**value, field: None}), field)
        self.assertFalse(validator.is_valid({**value, "methods": []}))
        self.assertNotIn("agreed=", self.verified(folder))
        without = contents(folder)
        del without[PAGE]
        self.assertEqual(without, contents(self.release))

    def test_page_about_something_else(self):
        folder = self.stated()
        good = json.loads((folder / PAGE).read_text())
        for field, value, reason in (("content_sha256", 64 * "0", "about another release"),
                                     ("records", good["records"] + 1, "about another"),
                                     ("methods", [], "not a page"), ("methods", ["certificate"], "not a page"),
                                     ("schema", "x", "not a page"), ("more", 1, "not a page")):
            (folder / PAGE).write_bytes(page({**copy.deepcopy(good), field: value}))
            self.refusal(folder, reason)
        (folder / PAGE).write_bytes(b"")
        self.refusal(folder, "not a page")
        (folder / PAGE).unlink()
        (folder / PAGE).mkdir()
        self.refusal(folder, "")

    def test_page_and_generate(self):
        """A whole release keeps its page; one that is made again loses it."""
        folder = self.stated()
        self.assertEqual(self.generate(folder)[0], 0)
        self.assertTrue((folder / PAGE).exists())
        (folder / (self.shards[0] + ".json")).unlink()
        self.assertEqual(self.generate(folder)[0], 0)
        self.same_as_release(folder)

    def test_no_page_without_acceptance(self):
        folder = self.folder / "damaged"
        shutil.copytree(self.release, folder)
        (folder / "NOTES.md").write_text("x")
        code, out, _ = self.run_cli("golden", "verify", "--method", "exact", "--state", folder)
        self.assertEqual(code, 1, out)
        self.assertFalse((folder / PAGE).exists())


if __name__ == "__main__":
    unittest.main()
