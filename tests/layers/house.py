#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How large the house is, in a few numbers: `tests/layers/house.py [BUILD]`, in its root. Nothing fails by them.

Counted are the files that git tracks, as they lie in the folder. A line is a line: blank ones and comments count too.
The bundle of three.js is not ours. A header's reader is a file outside of tests that includes it; a source of the same
name is none. Headers for users are not counted there: their readers are elsewhere.

With BUILD, a folder with a build of the preset `dev`, or of another that compiles file by file, also the sources on the
way of one answer: those with a function of their own that ran in `depth --json --certificate` on two meshes, as
Callgrind (Debian: valgrind) saw it. Functions that were inlined, templates, and files that include CGAL, which every
preset joins, have no source there. A build of `release`, which joins all, ends with exit code 2."""
import collections
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile

CODE = {".cpp", ".hpp", ".ipp", ".h", ".c", ".py", ".js", ".mjs", ".rs", ".sh", ".v", ".ml", ".cmake"}
CPP = {".cpp", ".hpp", ".ipp", ".h", ".c"}


def on_the_way(root, build):
    """The sources whose functions ran; a name that several objects define says nothing."""
    joined = next((path for path in build.rglob("Unity/*.o") if not path.parts[-3].endswith("_cgal.dir")), None)
    if joined:
        print(f"{joined} holds several sources joined: build with a preset that compiles file by file, such as dev",
              file=sys.stderr)
        sys.exit(2)
    with tempfile.TemporaryDirectory() as folder:
        meshes = [root.resolve() / "examples" / "data" / name for name in ("a.off", "b.stl")]
        subprocess.run(["valgrind", "--quiet", "--tool=callgrind", "--demangle=no", f"--callgrind-out-file={folder}/ran",
                        build / "fathom", "depth", "--json", "--certificate", f"{folder}/proof", *meshes],
                       check=True, capture_output=True)
        ran = set(re.findall(r"^c?fn=\(\d+\) ([^\s']+)", pathlib.Path(folder, "ran").read_text(), re.M))
    homes = collections.defaultdict(set)
    for path in build.rglob("*.o"):
        source = str(path.relative_to(build)).rsplit(".dir/", 1)[-1].removesuffix(".o")
        if (root / source).is_file() and not source.startswith("tests/"):
            listed = subprocess.run(["nm", "--defined-only", path], check=True, capture_output=True, text=True).stdout
            for name in re.findall(r"^\w+ [tT] (\S+)$", listed, re.M):
                homes[name].add(source)
    return {source for name in ran if len(homes[name]) == 1 and not name.startswith("_GLOBAL__") for source in homes[name]}


def main(root, build):
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=root, check=True, capture_output=True, text=True).stdout
    tracked = listed.split("\0")
    paths = [pathlib.PurePath(name) for name in tracked if name and (root / name).is_file()]
    texts = {path: (root / path).read_text(errors="replace") for path in paths
             if path.suffix in CODE and "three.bundle" not in path.name}
    lines = {path: text.count("\n") for path, text in texts.items()}
    tests = {path for path in texts if path.parts[0] == "tests"}
    own = {path for path in texts if path.parts[0] not in ("tests", "docs")}
    cpp = sorted((path for path in texts.keys() - tests if path.suffix in CPP), key=lambda path: (lines[path], path))

    readers = collections.defaultdict(set)
    for path in cpp:
        for included in map(pathlib.PurePath, re.findall(r'^\s*#\s*include\s+"([^"]+)"', texts[path], re.M)):
            if included.with_suffix("") != path.with_suffix(""):
                readers[included].add(path)
    single = [path for path in cpp if path.suffix == ".hpp" and path.parts[0] != "include" and len(readers[path]) == 1]

    hidden = {path.parts[0] for path in paths if path.parts[0].startswith(".")}
    for what, number in (("own lines without tests", sum(lines[path] for path in own)),
                         ("lines of tests", sum(lines[path] for path in tests)),
                         ("C++ files without tests", len(cpp)),
                         ("median lines of such a file", statistics.median(lines[path] for path in cpp)),
                         (f"the longest, {cpp[-1]}", lines[cpp[-1]]),
                         ("headers with a single reader", len(single)),
                         ("entries at the top", len({path.parts[0] for path in paths} - hidden))):
        print(f"{number:>8}  {what}")
    if build:
        print(f"{len(on_the_way(root, build)):>8}  sources on the way of depth --json --certificate")


if __name__ == "__main__":
    main(pathlib.Path("."), pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else None)
