#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""filter.py HEADER    prints a public header as Doxygen is to read it: line for line, with what our comments leave to the reader written
out.

file     the comment that opens a header describes the file: its output, then its input
names    a comment on a line that declares several members is on each of them, one on the line of an enumeration on that
run      a comment above a function is on those that follow it too, until a blank line or another comment; so with types
equality a defaulted operator== needs no comment
C        in a header for C, comments in /* */ are docstrings, except for headings: /* ---- ... */
"""
import re
import sys

TRAILING = re.compile(r"\s*///<\s?")
DECLARATOR = re.compile(r"(.+?)\s(\*?\w+(?:\[\w+\])*(?:\s*=\s*.*|\{.*\})?)")
NOT_A_RUN = re.compile(r"\s*(?:struct|class|enum|union|template|namespace|using|typedef|public:|private:|requires|friend|#|\})")
TYPE = re.compile(r"(?:struct|class) .*\{$")
FUNCTION = re.compile(r"(?:\w|operator\S+)\(")
ENUMERATION = re.compile(r"\s*enum .*\};\s*///<")
EQUALITY = re.compile(r"\s*friend bool operator==\(.*\) = default;")


def parts(text):
    """The pieces of a declaration between the commas that stand in no brackets."""
    found, depth = [""], 0
    for letter in text:
        depth += (letter in "<([{") - (letter in ">)]}")
        if letter == "," and depth == 0:
            found.append("")
        else:
            found[-1] += letter
    return [part.strip() for part in found]


def separated(code, comment):
    """`T a, b;` with its comment on each name; None if the code is no such declaration."""
    stripped = code.strip()
    if stripped.startswith("enum "):
        return f"/** {comment} */ {stripped}"
    if not stripped.endswith(";") or stripped.startswith(("return", "using")):
        return None
    first, *others = parts(stripped[:-1])
    declared = DECLARATOR.fullmatch(first)
    if not others or declared is None or "(" in declared[1]:
        return None
    return " ".join(f"{declared[1]} {name}; /**< {comment} */" for name in (declared[2], *others))


def end_of(lines, i):
    """The last line of the function's declaration or definition that begins on line i."""
    text = ""
    for end in range(i, len(lines)):
        text += re.sub(r"//.*", "", lines[end])
        if text.rstrip().endswith((";", "}")) and text.count("(") == text.count(")") and text.count("{") == text.count("}"):
            return end
    return i


def of_c(lines):
    """Rule "C": each comment as lines that begin with /// or, after code, with ///<."""
    inside = False
    for line in lines:
        opened = re.match(r"(\s*)/\*(?! ----)", line)
        if opened or inside:
            text = re.sub(r"^\s*/?\*+(?!/)", "", line)
            inside = not text.rstrip().endswith("*/")
            yield (opened[1] if opened else "") + "///" + text.rstrip().removesuffix("*/").rstrip()
        else:
            yield re.sub(r"\s*/\*+<? (.*) \*/$", r"  ///< \1", line)


def described(lines):
    """Rule "file": the first line names the licence."""
    for i, line in enumerate(lines):
        if not line.startswith("//"):
            about = [text.lstrip("/").replace(" @file", "") for text in lines[1:i]]
            outputs = [k for k, text in enumerate(about) if text.startswith(" Output ")]
            if outputs:
                start = outputs[0]
                end = next((k for k in range(start + 1, len(about)) if not about[k].startswith("    ")), len(about))
                inputs = [about[0].replace(" Input ", " <br>**Input:** "), *about[1:start]]
                about = [about[start].removeprefix(" Output"), *about[start + 1:end], *inputs, *about[end:]]
            return ["/// \\file", *(f"///{text}" for text in about), *lines[i:]]
    return lines


def comment_of(lines, i):
    """The trailing comment of line i, and the last line of it."""
    text = TRAILING.split(lines[i], maxsplit=1)[1]
    while i + 1 < len(lines) and re.match(r"\s*///<", lines[i + 1]):
        i += 1
        text += " " + TRAILING.sub("", lines[i])
    return text, i


def written_out(lines):
    """Rules "names", "run" and "equality"."""
    found, i = [], 0
    above, used = [], False  # the docstring above, and whether a declaration has it already
    of_type = ""  # the docstring of the type whose end comes next
    while i < len(lines):
        line, end = lines[i], i
        code = re.sub(r"\s*//.*", "", line)
        if re.match(r"\s*///(?!<)", line):
            above = [*([] if used else above), line.strip()[3:].strip()]
            used = False
            found.append(line)
        elif EQUALITY.match(line):
            found.append(f"/** Compares the members. */ {line}")
        elif not code or NOT_A_RUN.match(line) and not ENUMERATION.match(line):
            if TYPE.match(line):
                after_type = i > 0 and lines[i - 1] == "};" and not above
                of_type = of_type if after_type else " ".join(above)
                found.append(f"/** {of_type} */ {line}" if after_type and of_type else line)
            else:
                found.append(line)
            above = []
        else:
            text, function = " ".join(above), FUNCTION.search(code)
            if "///<" in line:
                text, end = comment_of(lines, i)
            elif function:
                end = end_of(lines, i)
            elif used:
                text = ""
            names = separated(code, text) if text else None
            if names:
                if "///<" not in line:
                    found[-len(above):] = [""] * len(above)
                found += [names] + [""] * (end - i)
            elif text and used and function and "///<" not in line:
                found += [f"/** {text} */ {line}", *lines[i + 1:end + 1]]
            else:
                found += lines[i:end + 1]
            used = True
        i = end + 1
    return found


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        lines = file.read().splitlines()
    if sys.argv[1].endswith(".h"):
        lines = list(of_c(lines))
    print("\n".join(written_out(described(lines))))


if __name__ == "__main__":
    main()
