# SPDX-License-Identifier: GPL-3.0-or-later
"""The law "examples": each installed header is included, and each of its functions called, by a program in examples."""
import re

NO_CODE = re.compile(r'//[^\n]*|/\*.*?\*/|^[ \t]*#[^\n]*|"(?:[^"\\\n]|\\.)*"', re.DOTALL | re.MULTILINE)
TOKEN = re.compile(r"\w+|\S")
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*[<"](fathom/[^">]+)[">]', re.MULTILINE)
CALL = re.compile(r"(\w+)(?:<[^<>()]*>)?\(")
SCOPES = {"namespace", "extern", "struct", "class"}
NO_NAMES = {"requires", "decltype", "static_assert", "noexcept", "alignas"}  # they may stand before a parenthesis


def functions_of(header):
    """The names of the functions that a header declares, members included, except for constructors, destructors and operators."""
    names, types, statement = [], set(), []
    scopes = []  # whether each open brace is that of a namespace or type, and not of a body
    parentheses = 0  # open ones
    for token in TOKEN.findall(NO_CODE.sub("", header)):
        if token == "{":
            scopes.append("(" not in statement and "=" not in statement and not SCOPES.isdisjoint(statement))
            types.update(name for word, name in zip(statement, statement[1:]) if word in ("struct", "class"))
        elif token == "}":
            scopes.pop()
        elif token == "(" and all(scopes) and not parentheses and statement and "=" not in statement:
            name = statement[-1]
            if name[0].isalpha() and name not in NO_NAMES and statement[0] != "typedef":
                if name not in types and statement[-2:-1] != ["~"]:
                    names.append(name)
                statement.append("=")  # no other name before the statement's end is a function's
        parentheses += {"(": 1, ")": -1}.get(token, 0)
        statement = [] if token in "{};" and not parentheses else [*statement, token]
    return names


def breaches(root):
    examples = [path.read_text(encoding="utf-8") for pattern in ("*.c", "*.cpp") for path in (root / "examples").glob(pattern)]
    included = {target for text in examples for target in INCLUDE.findall(text)}
    called = {name for text in examples for name in CALL.findall(NO_CODE.sub("", text))}
    for header in [*sorted((root / "include/fathom").glob("*.h*")), *(root / "verify/check").glob("check.hpp")]:
        functions = dict.fromkeys(functions_of(header.read_text(encoding="utf-8")))
        name = header.relative_to(root).as_posix()
        if functions and f"fathom/{header.name}" not in included:
            yield name, "examples", "no program in examples includes it"
        for function in functions:
            if function not in called:
                yield name, "examples", f"no program in examples calls {function}"
