#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Certificates of some 200 cases, a few of every family and the whole catalogue, made by fathom; then forgeries of them.

forge_families.py FATHOM FOLDER FORGERIES_COMMAND..   the folder's path is added to the command
"""
import pathlib
import shutil
import subprocess
import sys

EACH = 4  # cases of a family


def main(fathom, folder, *command):
    folder = pathlib.Path(folder)
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    listed = subprocess.run([fathom, "cases", "--list"], check=True, stdout=subprocess.PIPE).stdout.decode()
    sources = [["--catalogue"]] + [["--family", line.split()[0], "--count", str(EACH), "--size", "8"] for line in listed.splitlines()]
    with open(folder / "cases.jsonl", "wb") as cases:
        for source in sources:
            subprocess.run([fathom, "cases", *source], check=True, stdout=cases)
    subprocess.run([fathom, "depth", "--certificate", folder / "certificates", folder / "cases.jsonl"], check=True,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    count = len(list((folder / "certificates").glob("*.cert")))
    print(f"{count} genuine certificates")
    if count < 200:
        return 1
    return subprocess.run([*command, folder / "certificates"], check=False).returncode


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
