#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lets every adapter that is there answer every set of cases, and writes results.json. What is left out by --adapters or --sets keeps the
numbers that are there, with their date. What another version of a library, or of fathom, had answered before stays as `earlier`.
tables.py makes the tables of all pages from it.

Exit codes: 0 done; 2 wrong arguments; 3 a run failed, which was said; --resume goes on with what is there.
"""
import argparse
import concurrent.futures
import dataclasses
import datetime
import json
import os
import pathlib
import re
import subprocess
import sys
import time

import contacts
import history
import sets
import tally

HERE = pathlib.Path(__file__).resolve().parent
# # Exit codes of certify that do not end the survey: 1 for a failed verdict, which is expected; 2 for a case that has no form in the
# # subject's numbers; 4 if all were declined.
ENDS = (0, 1, 2, 4)
COUNTED = re.compile(r"^\d+ cases?: ", re.MULTILINE)  # at the end of the table

ATTEMPTS = 2
SCHEMA = "fathom/survey/3"


class Failed(Exception):
    """A run without a complete report."""


def say(text):
    print(f"survey: {text}", file=sys.stderr, flush=True)


def adapters(fathom):
    """Returns ([adapter], {adapter: why it is left out}) in the order of fathom's list; with descriptions."""
    listed = subprocess.run([fathom, "certify", "--list-adapters"], stdout=subprocess.PIPE, check=True, text=True).stdout
    there, missing = {}, []
    for line in listed.splitlines():
        name, description = re.fullmatch(r"(\S+)\s+(.*)", line).groups()
        if description.endswith("; not built"):
            missing.append(name)
        else:
            there[name] = description
    return there, missing


@dataclasses.dataclass(frozen=True)
class Task:
    """One run: an adapter on a set, with default or other settings."""
    name: str            # of the set
    adapter: str
    cases: int
    settings: str = ""   # KEY=VALUE,... of the adapter
    fit: str = ""        # of certify, as its policy is
    policy: str = ""
    tolerance: str = ""  # --tol-abs

    @property
    def report(self):
        other = "".join(f".{text}" for text in (self.settings, self.fit and f"fit{self.fit}", self.policy, self.tolerance) if text)
        return f"{self.name}.{self.adapter}{other.replace(':', '_').replace('/', '_')}.jsonl"

    def words(self):
        found = ["--adapter", ",".join([self.adapter, *filter(None, [self.settings])])]
        return found + ["--fit", self.fit] * bool(self.fit) + ["--policy", self.policy] * bool(self.policy) + \
            ["--tol-abs", self.tolerance] * bool(self.tolerance)


class Progress:
    """Prints what has ended, and estimates the remaining time by the pace of the cases of the same set."""

    def __init__(self, tasks):
        self.left = list(tasks)
        self.all, self.spent = len(tasks), {}

    def done(self, task, seconds, text):
        self.left.remove(task)
        per_case = self.spent.setdefault(task.name, [])
        per_case.append(seconds / task.cases)
        say(f"{self.all - len(self.left)} of {self.all}: {task.report.removesuffix('.jsonl')}: {text}; {self.time_left()}")

    def time_left(self):
        known = [each for values in self.spent.values() for each in values]
        seconds = sum(task.cases * mean(self.spent.get(task.name, known)) for task in self.left) / os.cpu_count()
        return f"{seconds / 60:.0f} min left" if seconds > 90 else f"{seconds:.0f} s left"


def mean(values):
    return sum(values) / len(values)


def certify(options, task):
    """Runs a task; returns the last line of its table. It uses one job because answers of some engines depend on earlier pairs."""
    report = options.work / task.report
    words = [options.fathom, "certify", *task.words(), "--jobs", "1", "--time-out", str(options.time_out), "--report", report,
             options.work / f"{task.name}.jsonl"]
    if not options.resume:
        report.unlink(missing_ok=True)
    for attempt in range(ATTEMPTS):
        if attempt == ATTEMPTS - 1:
            report.unlink(missing_ok=True)  # of another version, or of a subject that a busy machine did not start in time
        resume = ["--resume"] * report.exists()
        done = subprocess.run([*words, *resume], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        report.with_suffix(".log").write_text(done.stdout, encoding="utf-8")
        # A report that is there may be refused, with the exit code of a bad case: then nothing was counted.
        if done.returncode in ENDS and COUNTED.search(done.stdout) and report.exists() and tally.is_whole(report):
            return done.stdout.rstrip().rpartition("\n")[2]
    raise Failed(f"{report.name} ended with {done.returncode}; see {report.with_suffix('.log')}")


def run_all(options, tasks):
    """Runs the tasks, one for each core; returns what went wrong."""
    progress, faults = Progress(tasks), []

    def work(task):
        begin = time.monotonic()
        try:
            return task, certify(options, task), time.monotonic() - begin
        except Failed as fault:
            faults.append(str(fault))
            return task, str(fault), time.monotonic() - begin

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for future in concurrent.futures.as_completed([pool.submit(work, task) for task in tasks]):
            task, text, seconds = future.result()
            progress.done(task, seconds, f"{seconds:.0f} s, {text}")
    return faults


def as_minimum(task, options):
    """Returns the task that judges a subject by shortest translations, although it claims less; for other subjects the task itself."""
    if task.name not in (*sets.TRIED_SETS, "plane"):
        return task
    claims = tally.read(options.work / task.report)[0]["subject"]["conventions"].get("claims")
    return dataclasses.replace(task, policy="minimum") if claims == "separating" else task


def tried(options, chosen, counts):
    """Returns the tasks of every adapter with other settings and sizes of bodies, on the sets that have them."""
    return [Task(name, adapter, counts[name], settings, fit) for name in options.sets if name in sets.TRIED_SETS for adapter in chosen
            if sets.is_asked(adapter, name) for settings in ["", *sets.TRIED.get(adapter, [])] for fit in sets.FITS if settings or fit]


def of_contacts(options, chosen, counts):
    """Returns the tasks for whole manifolds, at each tolerance."""
    return [Task(name, adapter, counts[name], words, tolerance=tolerance) for name in options.sets if name in sets.CONTACTS
            for adapter, words in sets.CONTACTS[name].manifolds.items() if adapter in chosen for tolerance in sets.TOLERANCES]


def counted_contacts(options, manifolds, version, old):
    """Returns the sets of contacts; keeps the old results of those that were not run again."""
    found = {name: old[name] for name in sets.CONTACTS if name in old}
    for name in sets.CONTACTS:
        asked = [task for task in manifolds if task.name == name]
        if not asked:
            continue
        told = contacts.set_of(name, options.work / f"{name}.jsonl")
        subjects = found.get(name, {}).get("subjects", {})
        for adapter in dict.fromkeys(task.adapter for task in asked):
            reports = {task.tolerance: options.work / task.report for task in asked if task.adapter == adapter}
            made = {"date": datetime.date.today().isoformat(), "fathom": version, "cases": told["digest"]}
            subjects[adapter] = contacts.answers_of(reports, made)
        found[name] = {**told, "subjects": {adapter: subjects[adapter] for adapter in sets.CONTACTS[name].manifolds if adapter in subjects}}
    return {name: found[name] for name in sets.CONTACTS if name in found}


def before(path):
    """Returns the existing results; parts that are not run again are kept."""
    if path.exists():
        found = json.loads(path.read_text(encoding="utf-8"))
        if found.get("schema") == SCHEMA:
            return found
    return {"sets": {}, "contacts": {}, "subjects": []}


def version_of(fathom):
    return subprocess.run([fathom, "--version"], stdout=subprocess.PIPE, check=True, text=True).stdout.splitlines()[0].strip()


def passed_of(report):
    summary = tally.read(report)[-1]
    return summary["passed"]


def results(options, there, tasks, others, manifolds):
    """Returns the results of the reports, with the old ones for parts that were not run."""
    version = version_of(options.fathom)
    old, today = before(options.out / "results.json"), datetime.date.today().isoformat()
    found = {"schema": SCHEMA, "time_out": options.time_out, "groups": list(tally.GROUPS), "tolerance": old.get("tolerance"),
             "sets": {name: tally.set_of(name, options.work / f"{name}.jsonl") if name in options.sets else old["sets"][name]
                      for name in sets.SETS if name in options.sets or name in old["sets"]},
             "contacts": counted_contacts(options, manifolds, version, old.get("contacts", {}))}
    if "small_world" in old:  # world.py asks about it
        found["small_world"] = old["small_world"]
    subjects = {subject["adapter"]: subject for subject in old["subjects"]}
    for task in tasks:
        subject = subjects.setdefault(task.adapter, {"adapter": task.adapter, "tried": [], "sets": {}})
        made = {"date": today, "fathom": version, "cases": found["sets"][task.name]["digest"]}
        hello, found["tolerance"], answers = tally.answers_of(
            options.work / task.report, options.work / as_minimum(task, options).report, made, sets.SETS[task.name].by_case)
        history.keep(subject, hello, task.name, version)
        subject["hello"], subject["sets"][task.name] = hello, answers
    for task in others:
        known = subjects[task.adapter]["tried"]
        entry = next((each for each in known if (each["settings"], each["fit"]) == (task.settings, task.fit)), None)
        if entry is None:
            known.append(entry := {"settings": task.settings, "fit": task.fit, "right": {}})
        entry["right"][task.name] = passed_of(options.work / task.report)
    for name, description in there.items():
        if name in subjects:
            subjects[name]["description"] = description
    order = [*there, *(name for name in subjects if name not in there)]
    found["subjects"] = [{key: subjects[name][key] for key in ("adapter", "description", "hello", "tried", "earlier", "sets")
                          if key in subjects[name]} for name in order if name in subjects]
    for subject in found["subjects"]:
        subject["sets"] = {name: subject["sets"][name] for name in found["sets"] if name in subject["sets"]}
    return found


def parsed(words):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--fathom", default=str(sets.ROOT / "fathom"), help="the program; this project's launcher unless given")
    parser.add_argument("--adapters", type=lambda text: text.split(","), help="these alone, with commas")
    parser.add_argument("--sets", type=lambda text: text.split(","), default=list(sets.ALL), help="of " + ", ".join(sets.ALL))
    parser.add_argument("--count", action="append", default=[], metavar="SET=N", help="so many cases of a set that is generated")
    parser.add_argument("--time-out", type=float, default=30, help="seconds for each case; generous, as engines compile when they start")
    parser.add_argument("--work", type=pathlib.Path, default=sets.ROOT / "build" / "survey", help="keeps cases and reports")
    parser.add_argument("--out", type=pathlib.Path, default=HERE, help="gets results.json")
    parser.add_argument("--as-by-default", action="store_true", help="try no other settings and sizes of bodies")
    parser.add_argument("--resume", action="store_true", help="go on with the reports that are there")
    options = parser.parse_args(words)
    for text in options.count:
        name, _, count = text.partition("=")
        if name not in sets.ALL or not sets.ALL[name].count or not count.isdecimal():
            parser.error(f"--count expects SET=N with a set that is generated, found {text}")
        sets.ALL[name].count = int(count)
    for name in options.sets:
        if name not in sets.ALL:
            parser.error(f"there is no set {name} (expected {', '.join(sets.ALL)})")
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
        sets.make(sets.ALL[name], options.fathom, options.work / f"{name}.jsonl")
    counts = {name: len(sets.read_cases(options.work / f"{name}.jsonl")) for name in options.sets}
    tasks = [Task(name, adapter, counts[name]) for name in options.sets if name in sets.SETS for adapter in chosen
             if sets.is_asked(adapter, name)]
    manifolds = of_contacts(options, chosen, counts)
    others = [] if options.as_by_default else tried(options, chosen, counts)
    faults = run_all(options, [*tasks, *others, *manifolds])
    if not faults:
        faults = run_all(options, [held for task in tasks if (held := as_minimum(task, options)) != task])
    for fault in faults:
        say(fault)
    if faults:
        return 3
    found = results(options, there, tasks, others, manifolds)
    (options.out / "results.json").write_text(tally.text(found), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
