#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Puts sets of cases to the older versions of one engine, MuJoCo, and writes them into results.json as what it answered earlier. Versions
are those of verify/subjects/web/history, installed by the first use. The newest is what survey.py asks. Takes the options of survey.py;
the sets are those whose cases stay the same, unless given.

Exit codes: as survey.py."""
import datetime
import json
import sys

import history
import sets
import survey
import tally

ADAPTER = "mujoco-native"
SETS = ("real", "shapes", "claims", "worst")
# # Release dates from the project's own list of changes, which lacks 3.3.8; for the two newest, the day on which the package was
# # published.
RELEASED = {"3.9.0": "2026-05-27", "3.10.0": "2026-06-22", "3.12.0": "2026-08-20", "3.13.0": "2026-09-10"}


def versions():
    """Returns the older versions, the oldest first."""
    package = sets.ROOT / "verify" / "subjects" / "web" / "history" / "package.json"
    return [name.removeprefix("mujoco-") for name in json.loads(package.read_text(encoding="utf-8"))["dependencies"]]


def main(words=None):
    parser, options = survey.parsed(["--sets", ",".join(SETS), *(sys.argv[1:] if words is None else words)])
    results = survey.before(options.out / "results.json")
    subject = next((each for each in results["subjects"] if each["adapter"] == ADAPTER), None)
    if subject is None:
        parser.error(f"{options.out / 'results.json'} has no answers of {ADAPTER}")
    options.work.mkdir(parents=True, exist_ok=True)
    for name in options.sets:
        sets.make(sets.SETS[name], options.fathom, options.work / f"{name}.jsonl")
    counts = {name: len(sets.read_cases(options.work / f"{name}.jsonl")) for name in options.sets}
    tasks = {version: [survey.Task(name, ADAPTER, counts[name], f"version={version}") for name in options.sets] for version in versions()}
    faults = survey.run_all(options, [task for each in tasks.values() for task in each])
    for fault in faults:
        survey.say(fault)
    if faults:
        return 3
    before = subject.get("earlier", [])
    known = {history.key_of(kept): kept["sets"] for kept in before}
    newer = [kept for kept in before if kept["hello"]["version"] not in tasks]
    subject["earlier"] = []
    for version, asked in tasks.items():
        answers, hello = {}, {}
        for task in asked:
            report = options.work / task.report
            made = {"date": datetime.date.today().isoformat(), "fathom": survey.version_of(options.fathom),
                    "cases": sets.digest(options.work / f"{task.name}.jsonl")}
            hello, _, answers[task.name] = tally.answers_of(report, report, made, sets.SETS[task.name].by_case)
        kept = history.entry(hello, answers, RELEASED.get(version, ""))
        kept["sets"] = {**known.get(history.key_of(kept), {}), **kept["sets"]}
        subject["earlier"].append(kept)
    subject["earlier"] += newer
    (options.out / "results.json").write_text(tally.text(results), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
