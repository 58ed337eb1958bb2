#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The pages tell the truth: their commands run and print what is shown, their links lead somewhere, their C++ is that of an example.

Each command of a console block (see console.py) is run by bash from a copy of the root; it must exit with 0 and, where output is shown,
print that. A comment before the block says that it is run otherwise:
    <!-- heavy -->            with FATHOM_HEAVY=1 only
    <!-- needs PROGRAM -->    only where this program has been built, by its path in the build folder
    <!-- run by TEST -->      by another test, the path of which this is
    <!-- run by hand -->      by nobody: it measures, or it changes the machine
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

from console import BLOCK, agrees, blocks, commands

EXECUTABLE = pathlib.Path(os.environ["FATHOM_EXECUTABLE"])
ROOT = pathlib.Path(os.environ["FATHOM_ROOT"])
HEAVY = os.environ.get("FATHOM_HEAVY") == "1"
CGAL = pathlib.Path("/usr/include")
PATIENCE = 1800  # seconds until a hung process is given up; no test depends on how long anything takes
COLUMNS = 100
FRONT = 120  # lines of README.md

LINK = re.compile(r"\]\(([^)\s]+)\)")
LOOSE_COMMAND = re.compile(r"^(?:    |\$ )(?:\./(?:fathom|check)|build/|cmake |ctest )")


def pages():
    """The pages that users read first."""
    return [ROOT / "README.md", *sorted(set((ROOT / "docs").glob("*.md")) - {ROOT / "docs" / name for name in ("CHANGELOG.md", "CONTRIBUTING.md")})]


def all_pages():
    folders = [folder for folder in sorted(ROOT.iterdir()) if folder.is_dir() and not folder.name.startswith((".", "build"))]
    return sorted(ROOT.glob("*.md")) + [page for folder in folders for page in sorted(folder.rglob("*.md"))]


def name(page):
    return page.relative_to(ROOT).as_posix()


def anchor(heading):
    """The anchor that GitHub gives to a heading."""
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")


def anchors(page):
    return {anchor(line.lstrip("#")) for line in re.sub(r"^```.*?^```$", "", page.read_text(), flags=re.MULTILINE | re.DOTALL).splitlines()
            if line.startswith("#")}


class Scratch:
    """A folder like the root, in which commands may write."""
    def __enter__(self):
        self.folder = tempfile.TemporaryDirectory()
        path = pathlib.Path(self.folder.name)
        for copied in ("docs/gallery", "examples", "include", "tests/data", "verify"):  # what commands read
            shutil.copytree(ROOT / copied, path / copied, ignore=shutil.ignore_patterns("*.png"))
        (path / "fathom").symlink_to(EXECUTABLE)
        (path / "build").mkdir()
        (path / "build" / "release").symlink_to(EXECUTABLE.parent)
        return path

    def __exit__(self, *_):
        self.folder.cleanup()


def unmet(comment):
    """Whether a block is not for this run."""
    if comment == "heavy":
        return not HEAVY
    if comment.startswith("needs "):
        return not (EXECUTABLE.parent / comment.removeprefix("needs ")).exists()
    return comment.startswith("run by ")


class Docs(unittest.TestCase):
    maxDiff = None

    def test_commands(self):
        for page in pages():
            with Scratch() as folder:
                for comment, language, lines in blocks(page.read_text()):
                    if language != "console" or unmet(comment):
                        continue
                    for command, shown in commands(lines):
                        with self.subTest(page=name(page), command=command):
                            done = subprocess.run(["bash", "-o", "pipefail", "-c", command], cwd=folder, timeout=PATIENCE,
                                                  stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
                            printed = done.stdout.decode()
                            self.assertEqual(done.returncode, 0, printed)
                            if shown and not agrees(shown, printed):
                                self.assertEqual("\n".join(shown), printed)

    def test_every_command_is_in_a_block(self):
        """Law: a command of the project outside of a console block would not be run."""
        for page in pages():
            text = page.read_text()
            self.assertEqual([], [line for line in BLOCK.sub("", text).splitlines() if LOOSE_COMMAND.match(line)], name(page))
            self.assertEqual([], [language for _, language, _ in blocks(text) if language in ("", "sh", "bash")], name(page))

    def test_comments_before_blocks(self):
        for page in pages():
            for comment, language, _ in blocks(page.read_text()):
                if language == "console" and comment not in ("", "heavy", "run by hand"):
                    kind, _, path = comment.rpartition(" ")
                    self.assertIn(kind, ("needs", "run by"), name(page))
                    self.assertTrue(kind == "needs" or (ROOT / path).exists(), f"{name(page)}: {comment}")

    def test_links(self):
        for page in all_pages():
            for target in LINK.findall(re.sub(r"`[^`\n]*`", "", BLOCK.sub("", page.read_text()))):
                if re.match(r"[a-z]+:", target):
                    continue
                path, _, place = target.partition("#")
                file = page.parent / path if path else page
                self.assertTrue(file.exists(), f"{name(page)}: {target} is not there")
                if place:
                    self.assertIn(place, anchors(file), f"{name(page)}: {target}")

    def test_paths(self):
        """Law: a file or folder of the project that a page names is there."""
        tops = [entry.name for entry in ROOT.iterdir() if entry.is_dir() and not entry.name.startswith((".", "build"))]
        for page in [*pages(), ROOT / "docs" / "CONTRIBUTING.md"]:
            for word in re.findall(r"`([\w.*/-]+/[\w.*/-]*)`", BLOCK.sub("", page.read_text())):
                if word.split("/")[0] in tops:
                    self.assertTrue(list(ROOT.glob(word.rstrip("/"))), f"{name(page)}: {word} is not there")

    def test_width(self):
        """Law: lines of the pages have at most 100 columns; elsewhere tables and blocks may be wider."""
        for page in pages():
            self.assertEqual([], [line for line in page.read_text().splitlines() if len(line) > COLUMNS], name(page))
        made = {ROOT / "verify/survey/RESULTS.md", ROOT / "verify/golden/NOTES.md", ROOT / "tests/data/golden/NOTES.md"}
        for page in set(all_pages()) - made:
            prose = [line for line in BLOCK.sub("", page.read_text()).splitlines() if not line.lstrip().startswith("|")
                     and line[:4] != "    "]
            self.assertEqual([], [line for line in prose if len(line) > COLUMNS], name(page))
        self.assertLessEqual(len((ROOT / "README.md").read_text().splitlines()), FRONT)

    def test_cpp(self):
        """Law: each paragraph of a block of C++ stands in one example, which a test compiles and runs."""
        stripped = lambda lines: "\n".join(line.strip() for line in lines)
        examples = [stripped(path.read_text().splitlines()) for folder in ("examples", "verify/examples", "tests/install")
                    for path in sorted((ROOT / folder).rglob("*")) if path.suffix in (".cpp", ".c", ".rs", ".txt")]
        for page in pages():
            for _, language, lines in blocks(page.read_text()):
                if language in ("cpp", "c", "cmake", "rust"):
                    paragraphs = stripped(lines).split("\n\n")
                    self.assertTrue(any(all(part in example for part in paragraphs) for example in examples), f"{name(page)}: {lines}")

    def test_citation(self):
        """Law: what is to be cited is the version that CMake builds, whose tag the page names, and the golden data of the tree."""
        version = re.search(r"^project\(fathom VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text(), re.MULTILINE)[1]
        cited = (ROOT / "CITATION.cff").read_text()
        self.assertEqual([(version, version)], re.findall(r'^version: "(.*)"  # the tag of this release is v(.*)$', cited, re.MULTILINE))
        self.assertIn(f"version {version}, whose tag is `v{version}`", (ROOT / "docs" / "golden.md").read_text())
        data = json.loads((ROOT / "tests" / "data" / "golden" / "dataset.json").read_text())
        for words in (f'title: "{data["name"]}, seed {data["generator"]["seed"]}"\n', f'version: "{data["version"]}"\n',
                      f'value: "sha256:{data["content_sha256"]}"\n', f'license: {data["licence"]}\n'):
            self.assertIn("    " + words, cited)

    def test_licences(self):
        """Law: one source of the library and the programs includes headers of CGAL that are under the GPL, which the page says."""
        found = set()
        for folder in ("bindings", "cli", "include", "kernels", "reference", "verify", "view"):
            for path in (path for path in (ROOT / folder).rglob("*") if path.suffix in (".cpp", ".hpp", ".h")):
                for header in re.findall(r"^#include <(CGAL/.+)>", path.read_text(), re.MULTILINE):
                    if "SPDX-License-Identifier: GPL" in (CGAL / header).read_text():
                        found.add((name(path), header))
        section = (ROOT / "docs" / "library.md").read_text().partition("\n## Licences\n")[2]
        self.assertEqual({("reference/polytope/hull_triangles.cpp", f"CGAL/convex_hull_{d}.h") for d in (2, 3)}, found)
        self.assertTrue(all(f"`{word}`" in section for pair in found for word in pair))

    def test_tables(self):
        """Law: the tables of the survey are those that its results make, and say so where its commands make other cases by now."""
        done = subprocess.run([sys.executable, "-B", ROOT / "verify/survey/tables.py", "--check", "--fathom", EXECUTABLE],
                              capture_output=True, text=True, timeout=PATIENCE, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""), "verify/survey/tables.py makes them anew")

    def test_every_page_is_linked(self):
        front = (ROOT / "README.md").read_text() + (ROOT / "docs" / "architecture.md").read_text()
        for page in pages()[1:]:
            self.assertIn(page.name, front)

    def test_pictures(self):
        """Law: a picture is what its script draws with this fathom's answers."""
        for script in sorted((ROOT / "docs" / "pictures").glob("*.py")):
            drawn = subprocess.run([sys.executable, "-B", script, EXECUTABLE], capture_output=True, text=True, check=True, timeout=PATIENCE)
            self.assertEqual(script.with_suffix(".svg").read_text(), drawn.stdout, name(script))


if __name__ == "__main__":
    unittest.main()
