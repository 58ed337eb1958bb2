#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What can be said of the Debian packages without building them: versions agree, what the build needs is asked for, the scripts are
bash."""
import fnmatch
import os
import pathlib
import re
import subprocess
import sys
import unittest

ROOT = pathlib.Path(os.environ["FATHOM_ROOT"])
sys.path.insert(0, str(ROOT / "tests/layers"))
import layers  # noqa: E402

NOT_FOR_PACKAGES = {"g++", "ccache", "python3-pytest", "python3-pip", "python3-venv", "patchelf"}  # the first is essential to builds


def read(path):
    return (ROOT / path).read_text(encoding="utf-8")


def stanzas(text):
    """Each stanza of a Debian control file: the fields, with continuation lines."""
    for stanza in re.split(r"\n\n+", text.strip()):
        yield {name: value.strip() for name, value in re.findall(r"^(\S+?):((?:.*)(?:\n[ \t].*)*)", stanza, re.MULTILINE)}


def packages_txt(*sections):
    found, section = set(), ""
    for line in read("cmake/packages.txt").splitlines():
        if line.startswith("["):
            section = line[1:-1]
        elif line and not line.startswith("#") and section in sections:
            found.add(line)
    return found


class Packaging(unittest.TestCase):
    def test_versions(self):
        # Debian's own package fathom is another program: by the epoch apt takes ours for the newer.
        version = re.search(r"project\(fathom VERSION (\S+)", read("CMakeLists.txt"))[1]
        self.assertEqual(re.match(r"fathom \(1:([^)]+)\)", read("packaging/debian/changelog"))[1], version)
        self.assertIn('re.search(r"project\\(fathom VERSION', read("bindings/python/setup.py"))  # Python's is taken from there

    def test_recipes(self):
        version = re.search(r"project\(fathom VERSION (\S+)", read("CMakeLists.txt"))[1]
        for recipe, said in (("conda-forge/meta.yaml", f'version = "{version}"'), ("vcpkg/vcpkg.json", f'"version": "{version}"'),
                             ("vcpkg/portfile.cmake", 'FETCH_REF "v${VERSION}"'), ("homebrew/fathom.rb", f"/v{version}.tar.gz")):
            text = read(f"packaging/{recipe}")
            self.assertIn(said, text)
            self.assertIn("untried", text.lower(), recipe)

    def test_build_dependencies(self):
        source = next(stanzas(read("packaging/debian/control")))
        asked = {re.match(r"[^\s(]+", word.strip())[0] for word in source["Build-Depends"].split(",") if word.strip()}
        self.assertEqual(asked - {"debhelper-compat", "dh-python"}, packages_txt("depth", "build", "subjects", "python") - NOT_FOR_PACKAGES)

    def test_every_package_says_what_is_in_it(self):
        _, *binaries = stanzas(read("packaging/debian/control"))
        self.assertEqual({binary["Package"] for binary in binaries}, {path.stem for path in (ROOT / "packaging/debian").glob("*.install")})

    def test_development_package_depends_on_what_pkg_config_requires(self):
        required = re.search(r"^Requires: (.*)$", read("cmake/fathom.pc.in"), re.MULTILINE)[1].replace("gmpxx", "gmp").split()
        binaries = stanzas(read("packaging/debian/control"))
        depends = next(binary for binary in binaries if binary.get("Package") == "libfathom-dev")["Depends"]
        self.assertEqual([name for name in required if f"lib{name}-dev" not in depends], [])

    def test_manual_page_of_the_checker_names_its_options(self):
        shown = set(re.findall(r"\\-\\-(\w+)", read("packaging/debian/fathom-check.1")))
        sources = "".join(path.read_text() for path in (ROOT / "verify/check").glob("run.*"))
        self.assertEqual(shown - {"help"}, set(re.findall(r'"(?:  )?--(\w+)', sources)) - {"help", "version"})

    def test_copyright_names_files_that_are_there(self):
        for stanza in stanzas(read("packaging/debian/copyright")):
            for pattern in stanza.get("Files", "").split():
                self.assertTrue(list(ROOT.glob(pattern)), pattern)

    def test_files_name_the_licence_that_the_list_gives_them(self):
        listed = [(pattern, stanza["License"]) for stanza in stanzas(read("packaging/debian/copyright")) for pattern in stanza.get("Files", "").split()]
        named = {}
        for path in layers.files(ROOT):
            with open(ROOT / path, "rb") as file:
                opening = b"".join(file.readline(200) for _ in range(3)).decode(errors="replace")
            if found := re.search(r"^\W*(?:comment\W+)?SPDX-License-Identifier: ([\w.-]*\w)", opening, re.MULTILINE):
                named[path.as_posix()] = found[1]
        self.assertGreater(len(named), 100)
        given = {path: [theirs for pattern, theirs in listed if fnmatch.fnmatch(path, pattern)][-1] for path in named}  # the last one
        self.assertEqual({path: licence for path, licence in named.items() if licence.replace("-3.0-or-later", "-3+") != given[path]}, {})

    def test_scripts_are_bash(self):
        scripts = sorted((ROOT / "packaging").glob("*.sh"))
        self.assertTrue(scripts)
        for script in scripts:
            subprocess.run(["bash", "-n", script], check=True)
            self.assertTrue(os.access(script, os.X_OK), script)
            usage = subprocess.run([script], capture_output=True, text=True)
            self.assertEqual((usage.returncode, usage.stderr.split()[:2]), (2, ["usage:", script.name]))


if __name__ == "__main__":
    unittest.main()
