#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lets every adapter that is there answer every set of cases, and writes results.json and RESULTS.md.

Exit codes: 0 done; 2 wrong arguments; 3 a run failed, which was said; --resume goes on with what is there.
"""
import argparse
import concurrent.futures
import datetime
import json
import os
import pathlib
import re
import subprocess
import sys
import time

import sets
import tables
import tally

HERE = pathlib.Path(__file__).resolve().parent
# Of certify: 1 is a verdict that failed, which we are here for; 2 a case that has no form in the subject's numbers; 4 that all were
# declined.
ENDS = (0, 1, 2, 4)


ATTEMPTS = 2


class Failed(Exception):
    """A run that gave no whole report."""


def say(text):
    print(f"survey: {text}", file=sys.stderr, flush=True)


def adapters(fathom):
    """([adapter], {adapter: why it is left out}) in the order of fathom's list; descriptions too."""
    listed = subprocess.run([fathom, "certify", "--list-adapters"], stdout=subprocess.PIPE, check=True, text=True).stdout
    there, missing = {}, []
    for line in listed.splitlines():
        name, description = re.fullmatch(r"(\S+)\s+(.*)", line).groups()
        if description.endswith("; not built"):
            missing.append(name)
        else:
            there[name] = description
    return there, missing


class Progress:
    """Says what has ended, and how long the rest will take at the pace of the cases of the same set."""

    def __init__(self, tasks):
        self.left = list(tasks)
        self.all, self.spent = len(tasks), {}

    def done(self, task, seconds, text):
        self.left.remove(task)
        per_case = self.spent.setdefault(task[0], [])
        per_case.append(seconds / task[2])
        say(f"{self.all - len(self.left)} of {self.all}: {task[1]} on {task[0]}: {text}; {self.time_left()}")

    def time_left(self):
        known = [each for values in self.spent.values() for each in values]
        seconds = sum(count * mean(self.spent.get(name, known)) for name, _, count in self.left) / os.cpu_count()
        return f"{seconds / 60:.0f} min left" if seconds > 90 else f"{seconds:.0f} s left"


def mean(values):
    return sum(values) / len(values)


def certify(options, name, adapter):
    """Runs one adapter on one set; returns the last line of its table. One job: some engines remember the pairs before."""
    report = options.work / f"{name}.{adapter}.jsonl"
    words = [options.fathom, "certify", "--adapter", adapter, "--jobs", "1", "--time-out", str(options.time_out), "--report", report,
             options.work / f"{name}.jsonl"]
    if not options.resume:
        report.unlink(missing_ok=True)
    for attempt in range(ATTEMPTS):
        if attempt == ATTEMPTS - 1:
            report.unlink(missing_ok=True)  # of another version, or of a subject that a busy machine did not let start
        resume = ["--resume"] * report.exists()
        done = subprocess.run([*words, *resume], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        (options.work / f"{name}.{adapter}.log").write_text(done.stdout, encoding="utf-8")
        if done.returncode in ENDS and report.exists() and tally.is_whole(report):
            return done.stdout.rstrip().rpartition("\n")[2]
    raise Failed(f"{adapter} on {name} ended with {done.returncode}; see {options.work / f'{name}.{adapter}.log'}")


def run_all(options, names):
    """Runs every adapter on every set, one run for each core."""
    tasks = [(name, adapter, len(sets.read_cases(options.work / f"{name}.jsonl"))) for name in options.sets for adapter in names]
    progress, faults = Progress(tasks), []

    def work(task):
        begin = time.monotonic()
        try:
            return task, certify(options, *task[:2]), time.monotonic() - begin
        except Failed as fault:
            return task, str(fault), time.monotonic() - begin

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for future in concurrent.futures.as_completed([pool.submit(work, task) for task in tasks]):
            task, text, seconds = future.result()
            progress.done(task, seconds, f"{seconds:.0f} s, {text}")
            if " ended with " in text:
                faults.append(text)
    return faults


def parsed(words):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--fathom", default=str(sets.ROOT / "fathom"), help="the program; this project's launcher unless given")
    parser.add_argument("--adapters", type=lambda text: text.split(","), help="these alone, with commas")
    parser.add_argument("--sets", type=lambda text: text.split(","), default=list(sets.SETS), help="of " + ", ".join(sets.SETS))
    parser.add_argument("--count", action="append", default=[], metavar="SET=N", help="so many cases of a set that is generated")
    parser.add_argument("--time-out", type=float, default=30, help="seconds for each case; generous, as engines compile when they start")
    parser.add_argument("--work", type=pathlib.Path, default=sets.ROOT / "build" / "survey", help="keeps cases and reports")
    parser.add_argument("--out", type=pathlib.Path, default=HERE, help="gets RESULTS.md and results.json")
    parser.add_argument("--resume", action="store_true", help="go on with the reports that are there")
    options = parser.parse_args(words)
    for text in options.count:
        name, _, count = text.partition("=")
        if name not in sets.SETS or sets.SETS[name].file or not count.isdecimal():
            parser.error(f"--count expects SET=N with a set that is generated, found {text}")
        sets.SETS[name].count = int(count)
    for name in options.sets:
        if name not in sets.SETS:
            parser.error(f"there is no set {name} (expected {', '.join(sets.SETS)})")
    return parser, options


def main(words=None):
    parser, options = parsed(words)
    there, missing = adapters(options.fathom)
    if unknown := set(options.adapters or ()) - set(there):
        parser.error(f"not among the adapters that are there: {', '.join(sorted(unknown))}")
    chosen = {name: text for name, text in there.items() if not options.adapters or name in options.adapters}
    if missing and not options.adapters:
        say(f"not there, and left out: {' '.join(missing)}")
    for folder in (options.work, options.out):
        folder.mkdir(parents=True, exist_ok=True)
    for name in options.sets:
        sets.make(sets.SETS[name], options.fathom, options.work / f"{name}.jsonl")
    faults = run_all(options, chosen)
    for fault in faults:
        say(fault)
    if faults:
        return 3
    version = subprocess.run([options.fathom, "--version"], stdout=subprocess.PIPE, check=True, text=True).stdout.strip()
    results = {"schema": "fathom/survey/2", "fathom": version, "date": datetime.date.today().isoformat(), "time_out": options.time_out,
               **tally.results(options.work, options.sets, chosen)}
    (options.out / "results.json").write_text(tally.text(results), encoding="utf-8")
    (options.out / "RESULTS.md").write_text(tables.page(results), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
