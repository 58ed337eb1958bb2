#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the table of judged claims to standard output.  results.py FATHOM CLAIMS.jsonl > RESULTS.md"""
import collections
import json
import subprocess
import sys


def cell(text):
    return text.replace("|", "\\|").replace("\n", " ")


def main():
    fathom, claims = sys.argv[1:]
    lines = subprocess.run([fathom, "certify", "--claims", claims, "--json"], stdout=subprocess.PIPE,
                           check=False).stdout.decode().splitlines()
    results = [json.loads(line) for line in lines]
    count = collections.Counter(result["verdict"] for result in results)
    print("# Published claims, judged\n")
    print("Made by `verify/claims/results.py`; what a claim may state, and how it is judged, says\n[README.md](README.md).\n")
    print(f"{len(results)} claims: {count['right']} right, {count['wrong']} wrong, {count['undecided']} undecided, {count['not-judgeable']} not judgeable.")
    for verdict, title in (("wrong", "Wrong"), ("undecided", "Undecided"), ("right", "Right"), ("not-judgeable", "Not judgeable")):
        chosen = [result for result in results if result["verdict"] == verdict]
        if not chosen:
            continue
        print(f"\n## {title}\n\n| claim | source | stated | verdict | truth | in doubles |\n|---|---|---|---|---|---|")
        for result in chosen:
            shown = [s for s in result["statements"] if s["finding"] == verdict] or result["statements"]
            print("| " + " | ".join(cell(text) for text in (
                result["id"], result["source"], "; ".join(s["text"] for s in shown), verdict, "; ".join(s["truth"] for s in shown),
                f"{result['numeric']:.6g}" if "numeric" in result else "")) + " |")
    print("\n\"In doubles\" is the signed depth that was found in floating point when the claims were collected:\nit is shown, and not used.")


if __name__ == "__main__":
    main()
