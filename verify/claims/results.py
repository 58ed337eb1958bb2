#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the table of judged claims to standard output.  results.py FATHOM CLAIMS.jsonl... > RESULTS.md"""
import collections
import json
import pathlib
import subprocess
import sys


def cell(text):
    return text.replace("|", "\\|").replace("\n", " ")


def verdicts(results):
    count = collections.Counter(result["verdict"] for result in results)
    return (f"{len(results)} claims: {count['right']} right, {count['wrong']} wrong, {count['undecided']} undecided, "
            f"{count['not-judgeable']} not judgeable.")


def tables(results, column, text):
    """One table for each verdict; the last column is that, with the text of each result."""
    for verdict, title in (("wrong", "Wrong"), ("undecided", "Undecided"), ("right", "Right"), ("not-judgeable", "Not judgeable")):
        chosen = [result for result in results if result["verdict"] == verdict]
        if not chosen:
            continue
        print(f"\n### {title}\n\n| claim | source | stated | verdict | truth | {column} |\n|---|---|---|---|---|---|")
        for result in chosen:
            shown = [s for s in result["statements"] if s["finding"] == verdict] or result["statements"]
            print("| " + " | ".join(cell(part) for part in (
                result["id"], result["source"], "; ".join(s["text"] for s in shown), verdict, "; ".join(s["truth"] for s in shown),
                text(result))) + " |")


def main():
    fathom, *paths = map(pathlib.Path, sys.argv[1:])
    judged = {}
    for path in paths:
        lines = subprocess.run([fathom, "certify", "--claims", path, "--json"], stdout=subprocess.PIPE, check=False).stdout
        judged[path] = [json.loads(line) for line in lines.decode().splitlines()]
    print("# Published claims, judged\n")
    print("Made by `verify/claims/results.py`; what a claim may state, and how it is judged, says\n[README.md](README.md).\n")
    print(verdicts([result for results in judged.values() for result in results]))
    for path, results in judged.items():
        shows = {claim["id"]: claim.get("shows", "") for claim in map(json.loads, path.read_text(encoding="utf-8").splitlines())}
        print(f"\n## {path.name}\n\n{verdicts(results)}")
        if any(shows.values()):
            tables(results, "what the report shows", lambda result: shows[result["id"]])
        else:
            tables(results, "in doubles", lambda result: f"{result['numeric']:.6g}" if "numeric" in result else "")
    print("\n\"In doubles\" is the signed depth that was found in floating point when the claims were collected:\nit is shown, and not used.")


if __name__ == "__main__":
    main()
