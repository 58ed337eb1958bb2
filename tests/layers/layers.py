#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks the laws that keep the rooms apart; prints one line per breach and exits with 1 if there is any.

order     a file includes its own room and rooms to its left, by their path from the project's root; verify/check nothing but itself, by
          name
doors     the headers of include/fathom, kernels, reference and verify/judge include only the standard library, GMP and each other
installed only the headers in INSTALLED are installed
first     a source includes the header of its name before all else: so its compilation shows that the header stands alone
cgal      only the files listed in cmake/cgal_files.txt include CGAL, Boost or a *_cgal.hpp, and each of them does
rounding  rounding modes and interval filters are touched in kernels only
licence   an SPDX line opens every source, script and CMake file
length    no source has more than 600 lines, and no function of C++ more than 60, but for a table that it returns
readers   of the headers that are not installed, few have a single reader: their text belongs into it
width     no comment of C++ has more than 100 columns, and no line of Python more than 140, but for addresses, commands and strings;
          clang-format sees to it that code ends at 120
names     no two types share a name, whatever their namespaces; tests, and what stands alone (NAMES_OF_THEIR_OWN), may use theirs again
namespace a room's names are in its own namespace inside fathom, those for users in fathom itself
examples  each installed header is included, and each of its functions called, by a program in examples
"""
import io
import pathlib
import re
import sys
import tokenize

import public_functions

# From left to right. Rooms on one line do not know each other.
ORDER = [
    ["include/fathom"],  # what users include, as "fathom/..."
    ["kernels"],
    ["reference/text"],
    ["reference/files"],
    ["reference/polytope"],
    ["reference/expanding"],
    ["reference/gaussian"],
    ["reference/chart"],
    ["reference/canonical", "reference/vertex_facet"],
    ["reference/lines"],
    ["reference/depth"],
    ["reference/solve"],
    ["reference/approximate", "reference/motion", "reference/shapes", "reference/unions"],
    ["reference/solids"],
    ["reference/curved"],
    ["reference/rounded"],
    ["reference/patch"],
    ["reference/certificate"],
    ["reference/answer"],
    ["reference/output"],
    ["verify/check", "verify/claims", "verify/digest", "verify/families", "verify/study", "verify/subjects", "verify/reports",
     "verify/examples", "examples"],
    ["view/picture"],
    ["view/plot", "view/stages"],
    ["verify/judge"],
    ["verify/harness", "verify/golden"],
    ["view/page"],
    ["cli", "bindings/python"],
    ["bindings/c"],
    ["tests"],
]
PLACE = {room: place for place, rooms in enumerate(ORDER) for room in rooms}
CLOSED = "verify/check"  # the judge's checker shares nothing
CLOSED_TO_ALL_BUT = ("verify/harness", "verify/golden", "cli", "bindings/python", "bindings/c", "tests")
# programs of their own: they know other libraries, and nothing of ours
ALONE = ("verify/subjects", "verify/reports", "verify/examples", "examples")
DOORS = ("include/fathom/", "kernels/", "reference/", "verify/judge/")
FIRST = ("kernels/", "reference/", "verify/", "view/", "cli/")
APACHE = ("verify/check/", "examples/ci/", "verify/examples/", "verify/subjects/kit/")
PUBLIC_DOMAIN = ("verify/golden/kit/", "verify/reports/")  # what exports of golden data begin with; programs for others
NAMES_OF_THEIR_OWN = ("verify/check/", "verify/subjects/", "verify/reports/", "verify/examples/", "examples/", "tests/", "proofs/")

# The namespace of a room is called like its folder, except where a public function has that name.
NAMESPACES = {"verify/judge": "judging", "verify/study": "studies", "include/fathom": ""}

# What is installed: all headers of this folder, by the file set of this target; and the checker's one header.
INSTALLED = {"fathom_headers": "include/fathom", "fathom_check": "verify/check/check.hpp"}
CGAL_DOOR = "include/fathom/cgal.hpp"  # the one installed header with CGAL: who includes it has CGAL

LISTED = "cmake/cgal_files.txt"
LINES = 600
FUNCTION_LINES = 60
COLUMNS = {".py": 140, "": 100}  # of Python, and of comments in C++
ONE_READER = 11  # headers with a single reader; whoever takes some away lowers it
SOURCE = (".cpp", ".hpp")
SCRIPTS = ("fathom", "check", ".ci/run", ".clang-format", ".clang-tidy")

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*(["<])([^">]+)[">]', re.MULTILINE)
STANDARD = re.compile(r"[a-z_]+|gmp(xx)?\.h")
NAMESPACE = re.compile(r"(?:inline )?namespace ?([\w:]*) \{")
ROOM_NAMESPACE = re.compile(r"^(?:inline )?namespace fathom::(\w+)", re.MULTILINE)
NAMESPACE_END = re.compile(r"\}  // namespace")
TYPE = re.compile(r"(?:template <.*> )?(?:struct|class|union|enum class|enum) (?:\[\[\w+\]\] |alignas\(\w+\) )*(\w+)(?![\w<:,])[^;]*(?:\{.*|$)"
                  r"|(?:template <.*> )?using (\w+) =.*")
TYPE_HEAD = re.compile(r"\s*(?:template <.*> )?(?:struct|class|union|enum)\b.*\{")
INSTALL = re.compile(r"^[ \t]*install\(([^()]*(?:\([^()]*\)[^()]*)*)\)", re.MULTILINE)
HEADER = re.compile(r"[\w*]\.h(?:pp)?\b|INCLUDEDIR|(?:^|/)include\b")
ROUNDING = re.compile(r"\bc?fenv\b|\bfe[gs]etround\b|FENV_ACCESS|\bInterval_nt\w*|Protect_FPU_rounding|\bmpfr\.h\b")


def files(root):
    """The project's files as paths from its root, build trees and hidden folders apart."""
    for top in sorted(root.iterdir()):
        if top.is_dir() and not top.name.startswith((".", "build")):
            yield from (p.relative_to(root) for p in sorted(top.rglob("*")) if p.is_file())
    yield from (pathlib.Path(name) for name in ("CMakeLists.txt", *SCRIPTS) if (root / name).is_file())


def room_of(path):
    """The room that a path lies in, or None."""
    return next((room for room in PLACE if path == room or path.startswith(room + "/")), None)


def path_of(target):
    """The path from the root of what an include in quotes names."""
    return f"include/{target}" if target.startswith("fathom/") else target


def order_breach(room, target):
    if room == target:
        return None
    if target == CLOSED and room not in CLOSED_TO_ALL_BUT:
        return f"{CLOSED} shares nothing with {room}"
    if room in ALONE or target in ALONE:
        return f"{room if room in ALONE else target} stands alone"
    return None if PLACE[target] < PLACE[room] else f"{target} is not to the left of {room}"


def with_cgal(target):
    return target.startswith(("CGAL/", "boost/")) or target.endswith("_cgal.hpp")


def include_breaches(root, path, text, listed):
    name = path.as_posix()
    room = room_of(name)
    if room is None:
        yield "order", "this folder is no known room: give it a place in tests/layers/layers.py"
        return
    door = name.endswith(".hpp") and name.startswith(DOORS) and not name.endswith("_cgal.hpp")
    for quote, target in INCLUDE.findall(text):
        if with_cgal(target) and name not in listed:
            yield "cgal", f"{target} in a file that {LISTED} does not list"
        if target.startswith(("CGAL/", "boost/")):
            continue
        if quote == "<":
            if door and not STANDARD.fullmatch(target):
                yield "doors", f"<{target}> in a door"
        elif room == CLOSED:  # the folder builds wherever it is copied
            if "/" in target or not (root / room / target).is_file():
                yield "order", f'"{target}" is no file of {CLOSED}, by its name alone'
        elif room_of(path_of(target)) is None or not (root / path_of(target)).is_file():
            yield "order", f'"{target}" is no file of a room, by its path from the root'
        elif breach := order_breach(room, room_of(path_of(target))):
            yield "order", f'"{target}": {breach}'


def first_breach(root, name, text):
    """Of a source of a room with a header beside it. The build compiles alone only the headers without such a source: cmake/rooms.cmake."""
    header = name.removesuffix(".cpp") + ".hpp"
    if not name.endswith(".cpp") or not name.startswith(FIRST) or name.startswith(CLOSED) or not (root / header).is_file():
        return None
    first = next((target for _, target in INCLUDE.findall(text)), None)
    return None if first == header else f'"{header}" is not what is included first'


def source_breaches(root, path, text, listed):
    name = path.as_posix()
    if not name.startswith("tests/install/consumer/"):  # a foreign project
        yield from include_breaches(root, path, text, listed)
    if (breach := first_breach(root, name, text)) and name not in listed:
        yield "first", breach
    if not name.startswith(("kernels/", "tests/")) and (hit := ROUNDING.search(text)):
        yield "rounding", f"{hit.group()} outside kernels"
    if (lines := text.count("\n")) > LINES:
        yield "length", f"{lines} lines, more than {LINES}"
    for line, lines in long_functions(text):
        yield "length", f"the function in line {line} has {lines} lines, more than {FUNCTION_LINES}"
    room = room_of(name)
    if room and not name.startswith(NAMES_OF_THEIR_OWN):
        own = NAMESPACES.get(room, room.rsplit("/", 1)[-1])
        for other in sorted(set(ROOM_NAMESPACE.findall(text)) - {own}):
            yield "namespace", f"fathom::{other} in {room}"


def type_names(text):
    """The qualified names of the types and aliases defined in a source, those in unnamed namespaces and inside other types apart.

    It relies on the format: what stands in a namespace is not indented, and a comment ends each namespace.
    """
    inside = []
    for line in text.splitlines():
        if opened := NAMESPACE.fullmatch(line):
            inside.append(opened.group(1) or "")
        elif NAMESPACE_END.match(line) and inside:
            inside.pop()
        elif "" not in inside and (found := TYPE.fullmatch(line)):
            yield "::".join([*inside, found.group(1) or found.group(2)])


def name_breaches(definitions):
    """`definitions`: each name of a type with the files that define it."""
    for name, where in definitions.items():
        for path in where[1:]:
            yield path, "names", f"{name} is the name of a type in {where[0]} too"


def long_functions(text):
    """(line, lines) of each function of more than FUNCTION_LINES. It relies on the format: what stands inside of a type or a function is
    indented by two more. One of a single statement or two is a table."""
    lines = text.split("\n")
    types, start = 0, 0  # those that are open, and where what stands in the innermost begins
    for number, line in enumerate(lines):
        indent = len(line) - len(line.lstrip(" "))
        if not line or indent > 2 * types or line.lstrip().startswith(("//", "#")):
            continue
        if indent < 2 * types:
            types -= line.lstrip().startswith("}")
        elif TYPE_HEAD.fullmatch(line):
            types += 1
        elif line.strip() != "}":
            start = number
        elif number - start + 1 > FUNCTION_LINES:
            inside = " " * (indent + 2)
            statements = [x for x in lines[start + 1 : number] if x.startswith(inside) and x[indent + 2] not in " }"]
            if len(statements) > 2:
                yield start + 1, number - start + 1


def install_breaches(name, text):
    """The headers that a CMake file installs, beyond those in INSTALLED."""
    for call in INSTALL.findall(text):
        words = call.split()
        if words[0] == "TARGETS":
            targets = words[1 : next((i for i, word in enumerate(words) if word in ("EXPORT", "FILE_SET", "DESTINATION")), None)]
            if "FILE_SET" in words and not set(targets) <= INSTALLED.keys():
                yield "installed", f"the headers of {' '.join(targets)} are not chosen: tests/layers/layers.py says which are"
            if "PUBLIC_HEADER" in words or "PRIVATE_HEADER" in words:
                yield "installed", "headers are installed by file sets only"
        elif words[0] in ("FILES", "PROGRAMS", "DIRECTORY") and any(HEADER.search(word) for word in words[1:]):
            yield "installed", f"install({words[0]} ...) with headers: headers are installed by file sets only"


def long_strings(text, columns):
    """Of Python the numbers of lines with a string that cannot be broken beyond the limit; docstrings can be."""
    return {token.start[0] for token in tokenize.generate_tokens(io.StringIO(text).readline)
            if token.type == tokenize.STRING and token.start[0] == token.end[0] and token.end[1] > columns and '"""' not in token.string}


def width_breaches(name, text):
    """Of Python and of comments; clang-format sees to the code of C++. What an example prints stands as it is, and so do addresses."""
    columns = COLUMNS[".py" if name.endswith(".py") else ""]
    lines = [(number, line) for number, line in enumerate(text.split("\n"), 1) if len(line) > columns and "://" not in line and not line.startswith("// g++ ")]
    if not lines:
        return
    strings = long_strings(text, columns) if name.endswith(".py") else ()
    for number, line in lines:
        comment = re.match(r"\s*(//(?!>)|/?\*\s|/\*\*)", line)
        if comment if not name.endswith(".py") else number not in strings:
            yield "width", f"line {number} has {len(line)} columns, more than {columns}"


def licence_breaches(name, text):
    lines = text.split("\n", 2)
    line = lines[1] if lines[0].startswith("#!") and len(lines) > 1 else lines[0]
    licence = "Apache-2.0" if name.startswith(APACHE) else "CC0-1.0" if name.startswith(PUBLIC_DOMAIN) else "GPL-3.0-or-later"
    if not re.fullmatch(rf"(//|#) SPDX-License-Identifier: {re.escape(licence)}", line):
        yield "licence", f"the first line is not SPDX-License-Identifier: {licence}"


def reader_breaches(readers):
    """`readers`: of each header of ours the sources that include it, those of its own name apart."""
    single = sorted(header for header, names in readers.items() if len(names) == 1)
    if len(single) > ONE_READER:
        yield single[0], "readers", f"{len(single)} headers have a single reader, more than {ONE_READER}: {' '.join(single)}"


def listed_files(root):
    lines = (root / LISTED).read_text().splitlines() if (root / LISTED).is_file() else []
    return [line for line in lines if line and not line.startswith("#")]


def list_breaches(root, listed):
    for name in listed:
        text = (root / name).read_text() if (root / name).is_file() else ""
        if not any(with_cgal(target) for _, target in INCLUDE.findall(text)):
            yield LISTED, "cgal", f"lists {name}, which does not include CGAL"
        if name.endswith(".hpp") and not name.endswith("_cgal.hpp") and name != CGAL_DOOR:
            yield LISTED, "cgal", f"lists {name}: a header with CGAL is named *_cgal.hpp"


def breaches(root):
    """All (file, law, what is wrong)."""
    listed = listed_files(root)
    found = list(list_breaches(root, listed))
    definitions, readers = {}, {}
    for path in files(root):
        name = path.as_posix()
        if path.suffix in (*SOURCE, ".h", ".c", ".py"):
            found += [(name, *breach) for breach in width_breaches(name, (root / path).read_text(encoding="utf-8"))]
        script = path.suffix in (".py", ".sh", ".cmake") or name.endswith(".cmake.in") or path.name == "CMakeLists.txt" or name in SCRIPTS
        if path.suffix not in SOURCE and not script:
            continue
        text = (root / path).read_text(encoding="utf-8")
        found += [(name, *breach) for breach in licence_breaches(name, text)]
        if path.suffix in SOURCE:
            found += [(name, *breach) for breach in source_breaches(root, path, text, listed)]
            for _, target in INCLUDE.findall(text) if not name.startswith("tests/") else ():
                if "/" in target and path_of(target).rpartition(".")[0] != name.rpartition(".")[0]:
                    readers.setdefault(target, set()).add(name)
            if not name.startswith(NAMES_OF_THEIR_OWN):
                for defined in type_names(text):
                    definitions.setdefault(defined.split("::")[-1], []).append(name)
        elif path.suffix == ".cmake" or path.name == "CMakeLists.txt":
            found += [(name, *breach) for breach in install_breaches(name, text)]
    readers = {header: names for header, names in readers.items() if room_of(header) and (root / header).is_file()}
    return found + list(name_breaches(definitions)) + list(reader_breaches(readers)) + list(public_functions.breaches(root))


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve()
    found = breaches(root)
    for name, law, what in found:
        print(f"{name}: {law}: {what}")
    if not any(True for _ in files(root)):
        print(f"{root}: no sources here")
        return 1
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
