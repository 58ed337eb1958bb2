#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""How many of the known faults of certificates a checker finds: true certificates and false ones, each false one named by the format
and the rule of FORMAT.md that it breaks.

score.py CHECKER [WORD..]     runs CHECKER WORD.. FILE on each certificate, one after another
score.py --files FOLDER       writes the certificates into files of those names instead, and nothing else

A checker accepts with the exit code 0, refuses with 1, and says malformed with 2. If it prints lines as section 7 of FORMAT.md has them,
the worst of them must say the same. All else (a crash, no end in a minute) is no answer. Exit codes: 0 the score is 100 %; 1 it is less;
2 usage.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

WORDS = ("VERIFIED", "REFUSED", "MALFORMED")  # by exit code
PATIENCE = 60
DATA = pathlib.Path(__file__).parent / ".." / ".." / "tests" / "data" / "certificates"


def kind_of(text, row):
    """The part of the format: format5-solid and format5-two-bodies are two, since a checker may read one of them alone."""
    header = re.search(r"^fathom-certificate ([1-6])$", text, re.MULTILINE)
    if not header:
        return "no-format"
    return "format" + header[1] + {"5": "-two-bodies" if "two_bodies" in row["of"] else "-solid"}.get(header[1], "")


def rule_of(text, row):
    """The name of what a row is about, of what its checker says: format1-refused-a-weight-is-positive-this-one-is-not."""
    word = row["says"].split()[1]
    said = row["says"].split()[2] if word == "VERIFIED" else re.sub(r", found .*", "", row["says"].split(": ", 1)[1])
    said = re.sub(r"[^A-Za-z_%]+", "-", re.sub(r"\d+", "", said)).strip("-").lower()
    return f"{kind_of(text, row)}-{word.lower()}-{said}"


def corpus(folder):
    """[(kind, rule, name, text, word)]: each text once. `faults.jsonl` says what is edited in which certificate, and the line that is
    said then."""
    found, texts, names = [], set(), {}
    for line in (folder / "faults.jsonl").read_text().splitlines():
        row = json.loads(line)
        text = (folder / row["of"]).read_bytes().decode("latin-1") if row["of"] else ""
        for before, after in row["edits"]:
            before, after = (part.encode().decode("latin-1") for part in (before, after))
            text = text.replace(before, after, 1)
        if text not in texts:
            texts.add(text)
            rule = rule_of(text, row)
            names[rule] = names.get(rule, 0) + 1
            found.append((kind_of(text, row), rule, f"{rule}-{names[rule]}.cert", text.encode("latin-1"), row["says"].split()[1]))
    return found


def answer(checker, path):
    """The word that a checker says of one file, or what else happened."""
    try:
        done = subprocess.run([*checker, str(path)], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                              timeout=PATIENCE, check=False)
    except subprocess.TimeoutExpired:
        return "nothing in a minute"
    if done.returncode not in range(len(WORDS)):
        return f"exit code {done.returncode}"
    said = re.findall(rb"^s (VERIFIED|REFUSED|MALFORMED) ", done.stdout, re.MULTILINE)
    worst = max((WORDS.index(word.decode()) for word in said), default=done.returncode)
    return WORDS[worst] if worst == done.returncode else f"{WORDS[worst]}, but exit code {done.returncode}"


def score(checker, rows):
    """Prints the score; returns whether it is whole."""
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as threads:
        paths = [pathlib.Path(folder) / name for _, _, name, _, _ in rows]
        for path, (_, _, _, text, _) in zip(paths, rows):
            path.write_bytes(text)
        answers = list(threads.map(lambda path: answer(checker, path), paths))
    kinds, wrong = {}, set()
    for (kind, rule, name, _, word), said in zip(rows, answers):
        kinds.setdefault(kind, set()).add(rule)
        if said != word:
            wrong.add(rule)
            print(f"{name}: expected {word}, found {said}")
    for kind, rules in sorted(kinds.items()):
        print(f"{kind:<20}{len(rules - wrong):4} of {len(rules):3} rules")
    right = sum(said == row[-1] for row, said in zip(rows, answers))
    false = sum(said == "VERIFIED" != row[-1] for row, said in zip(rows, answers))
    print(f"{right} of {len(rows)} certificates, {100 * right // len(rows)} %; {false} false ones accepted")
    return right == len(rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--data", type=pathlib.Path, default=DATA, help="the certificates and faults.jsonl (those of fathom's tests)")
    parser.add_argument("--without", action="append", default=[], metavar="KIND", help="leave these out: format3, format5-two-bodies ..")
    parser.add_argument("--files", type=pathlib.Path, help="write the certificates into this folder")
    parser.add_argument("checker", nargs=argparse.REMAINDER)
    options = parser.parse_args()
    try:
        rows = [row for row in corpus(options.data) if row[0] not in options.without]
    except OSError as error:
        parser.error(str(error))
    if not rows or bool(options.files) == bool(options.checker):
        parser.error("expected a checker or --files, and certificates that are left")
    if not options.files:
        return 0 if score(options.checker, rows) else 1
    options.files.mkdir(parents=True, exist_ok=True)
    for _, _, name, text, _ in rows:
        (options.files / name).write_bytes(text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
