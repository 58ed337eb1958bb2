#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The pages of the public headers: Doxygen makes them without a warning, whatever is public has a comment, and their links lead
somewhere."""
import html.parser
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

DOXYGEN = os.environ["FATHOM_DOXYGEN"]
DOXYFILE = pathlib.Path(os.environ["FATHOM_DOXYFILE"])
ROOT = pathlib.Path(os.environ["FATHOM_ROOT"])
API = ROOT / "docs/api"


def doxygen(output, more=""):
    """Runs Doxygen as the target `api` does, with other settings after its own."""
    return subprocess.run([DOXYGEN, "-"], cwd=API, input=f'{DOXYFILE.read_text()}\nOUTPUT_DIRECTORY = "{output}"\n{more}', text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)


def filtered(text, name="header.hpp"):
    with tempfile.TemporaryDirectory() as folder:
        header = pathlib.Path(folder) / name
        header.write_text(text)
        return subprocess.run([sys.executable, "-B", API / "filter.py", header], capture_output=True, text=True, check=True).stdout


class Page(html.parser.HTMLParser):
    """The places on a page, and where its links lead."""
    def __init__(self, path):
        super().__init__()
        self.places, self.links = set(), set()
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.places |= {values.get("id"), values.get("name")}
        self.links |= {value for value in (values.get("href"), values.get("src")) if value}


class WithoutDoxygen(unittest.TestCase):
    def test_the_target_says_what_to_install(self):
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "CMakeLists.txt").write_text(
                f'cmake_minimum_required(VERSION 3.25)\nproject(pages NONE)\nadd_subdirectory("{API}" api)\n')
            configure = ["cmake", "-G", "Ninja", "-DFATHOM_DOXYGEN=OFF", "-S", folder, "-B", f"{folder}/build"]
            subprocess.run(configure, check=True, capture_output=True)
            run = subprocess.run(["cmake", "--build", f"{folder}/build", "--target", "api"], capture_output=True, text=True)
        self.assertNotEqual(0, run.returncode)
        self.assertIn("(Debian: doxygen, python3)", run.stdout)


class ApiPages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.run_of_headers = doxygen(cls.folder.name)
        cls.pages = {path.name: Page(path) for path in pathlib.Path(cls.folder.name).glob("*.html")}

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_no_warnings(self):
        self.assertEqual("", self.run_of_headers.stdout)
        self.assertEqual(0, self.run_of_headers.returncode)

    def test_every_header_has_a_page(self):
        headers = [*(ROOT / "include/fathom").glob("*.h*"), ROOT / "verify/check/check.hpp"]
        listed = self.pages["files.html"].links
        self.assertEqual([], [header.name for header in headers if header.name.replace("_", "__").replace(".", "_8") +
                              ".html" not in listed])

    def test_links(self):
        for name, page in self.pages.items():
            for link in page.links:
                target, _, place = link.partition("#")
                if re.match(r"[a-z]+:", target):
                    continue
                self.assertTrue((pathlib.Path(self.folder.name) / target).exists(), f"{name}: {link}")
                if place and (target or name) in self.pages:
                    self.assertIn(place, self.pages[target or name].places, f"{name}: {link}")

    def test_what_has_no_comment_fails(self):
        """Law: neither a function nor a type, a member, an enumeration or a constant passes without a comment."""
        for bare in ("int bare();", "struct Bare {\n  int size;  ///< of it\n};", "/// A type.\nstruct Type {\n  int bare;\n};",
                     "enum class Bare { a };", "inline constexpr int bare = 1;", "using Bare = int;"):
            with tempfile.TemporaryDirectory() as folder, self.subTest(bare):
                header = pathlib.Path(folder) / "bare.hpp"
                header.write_text(f"// SPDX\n// A header.\n#pragma once\n\nnamespace fathom {{\n\n{bare}\n\n}}  // namespace fathom\n")
                run = doxygen(folder, f'INPUT = "{header}" "{DOXYFILE.parent}/names.dox"\nUSE_MDFILE_AS_MAINPAGE =\n')
                self.assertNotEqual(0, run.returncode)
                self.assertRegex(run.stdout, r"bare\.hpp:\d+: .*[Bb]are.* is not documented")

    def test_filter_keeps_lines(self):
        for header in sorted((ROOT / "include/fathom").glob("*.h*")):
            text = header.read_text()
            self.assertEqual(text.count("\n"), filtered(text, header.name).count("\n"), header.name)

    def test_filter(self):
        cases = {
            "// About.\n\n": "/// About.\n\n",
            "// Input   two bodies.\n// Output  a depth.\n\n": "///  a depth.\n/// <br>**Input:**   two bodies.\n\n",
            "\n  int a, b;  ///< sizes\n": "\nint a; /**< sizes */ int b; /**< sizes */\n",
            "\n  std::array<int, 2> a = {1, 2}, b;  ///< of A\n           ///< and B\n":
                "\nstd::array<int, 2> a = {1, 2}; /**< of A and B */ std::array<int, 2> b; /**< of A and B */\n\n",
            "\n/// One.\nint f();\nint f(int,\n      int);\n\nint g();\n":
                "\n/// One.\nint f();\n/** One. */ int f(int,\n      int);\n\nint g();\n",
            "\n/// One.\nint f();\nint g();  ///< two\n": "\n/// One.\nint f();\nint g();  ///< two\n",
            "\n/// One.\nstruct A {\n};\nstruct B {\n};\n\nstruct C {\n};\n":
                "\n/// One.\nstruct A {\n};\n/** One. */ struct B {\n};\n\nstruct C {\n};\n",
            "\n/// One.\nint a;\nint b;\n": "\n/// One.\nint a;\nint b;\n",
            "\nenum class Kind { a, b };  ///< of a thing\n": "\n/** of a thing */ enum class Kind { a, b };\n",
            "\n  int a, b;\n": "\n  int a, b;\n",
        }
        for text, expected in cases.items():
            self.assertEqual("/// \\file\n" + expected, filtered("// SPDX\n" + text))
        self.assertEqual("/// \\file\n/// About C.\n\n/// A call\n/// of C.\nint f(void);\n  int a;  ///< of the body\n",
                         filtered("/* SPDX */\n/* About C. */\n\n/* A call\n * of C. */\nint f(void);\n  int a; /* of the body */\n",
                                  "c.h"))


if __name__ == "__main__":
    unittest.main()
