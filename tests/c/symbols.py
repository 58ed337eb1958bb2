#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Law: the library for C shows the functions of its header, each with a version, and no other symbol. symbols.py LIBRARY HEADER SONAME"""
import pathlib
import re
import subprocess
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "layers"))
import public_functions  # noqa: E402

FIRST_VERSION = "FATHOM_1"


def printed_by(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def main(library, header, soname):
    lines = [line.split() for line in printed_by("nm", "-D", "--defined-only", library).splitlines()]
    shown = {words[-1] for words in lines if words[-2] != "A"}  # A: the name of a version
    declared = {f"{name}@@{FIRST_VERSION}" for name in public_functions.functions_of(pathlib.Path(header).read_text())}
    faults = [f"{symbol} is shown, and not declared" for symbol in sorted(shown - declared)]
    faults += [f"{symbol} is declared, and not shown" for symbol in sorted(declared - shown)]
    if not re.search(rf"SONAME.*\s\[?{re.escape(soname)}\]?$", printed_by("objdump", "-p", library), re.MULTILINE):
        faults.append(f"the name in the library is not {soname}")
    print("\n".join(faults))
    return 1 if faults or not declared else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
