#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Puts the same cases to the versions of one engine, MuJoCo, and writes what changed from one to the next: history.json.

    verify/survey/versions.py [--fathom ./fathom] [--out verify/survey/history.json] [--reports DIR] [--count 368]

Each version answers the real cases and generated ones through its own adapter, one subject at a time; `fathom certify diff` compares each
report with that of the version before. The reports stay where --reports says. Versions are those of verify/subjects/web/history, installed
by the first use, and the newest.

    {"engine", "adapter", "commands": {set: text}, "versions": [{"version", "date", "package", "passes": {set: count},
     "cases": {set: count}, "newly_failing": {set: [id]}, "newly_passing": {set: [id]}}]}, the oldest first
"""
import argparse
import json
import pathlib
import shlex
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
ADAPTER = "mujoco-native"
# # Release dates from the project's own list of changes, which lacks 3.3.8; for the two newest, the day on which the package was
# # published.
RELEASED = {"3.9.0": "2026-05-27", "3.10.0": "2026-06-22", "3.12.0": "2026-08-20", "3.13.0": "2026-09-10", "3.14.0": "2026-09-23"}


def packages():
    """Returns {version: package@version of npm}, the oldest first; the newest is the one that the adapter uses without a setting."""
    web = ROOT / "verify" / "subjects" / "web"
    old = json.loads((web / "history" / "package.json").read_text(encoding="utf-8"))["dependencies"]
    newest = json.loads((web / "package.json").read_text(encoding="utf-8"))["dependencies"]["@mujoco/mujoco"]
    found = {name.removeprefix("mujoco-"): package.removeprefix("npm:") for name, package in old.items()}
    return {**found, newest: f"@mujoco/mujoco@{newest}"}


def run(command, allowed=(0, 1)):
    done = subprocess.run(command, cwd=ROOT, stdout=subprocess.PIPE, check=False)
    if done.returncode not in allowed:
        sys.exit(f"versions.py: exit code {done.returncode} of {shlex.join(map(str, command))}")
    return done.stdout


def ask(fathom, adapter, cases, report):
    """Writes the report; returns the counts of its summary."""
    run([fathom, "certify", "--jobs", "1", "--adapter", adapter, "--report", report, cases])
    summary = json.loads(report.read_text(encoding="utf-8").splitlines()[-1])
    return summary["passed"], summary["cases"]


def changed(fathom, old, new):
    difference = json.loads(run([fathom, "certify", "diff", "--json", old, new]))
    return [sorted(change["id"] for change in difference[field]) for field in ("newly_failing", "newly_passing")]


def history(fathom, count, reports):
    made = reports / "generated.jsonl"
    command = ["cases", "--family", "all", "--count", str(count), "--size", "20", "--seed", "1"]
    made.write_bytes(run([fathom, *command]))
    sets = {"real": ROOT / "tests" / "data" / "real_cases.jsonl", "generated": made}
    versions, before = [], {}
    known = packages()
    for version, package in known.items():
        entry = {"version": version, "date": RELEASED.get(version, ""), "package": package, "passes": {}, "cases": {}, "newly_failing": {},
                 "newly_passing": {}}
        adapter = ADAPTER if version == list(known)[-1] else f"{ADAPTER},version={version}"
        for name, cases in sets.items():
            report = reports / f"{version}-{name}.jsonl"
            entry["passes"][name], entry["cases"][name] = ask(fathom, adapter, cases, report)
            if name in before:
                entry["newly_failing"][name], entry["newly_passing"][name] = changed(fathom, before[name], report)
            before[name] = report
        print(f"{version}: {entry['passes']} right of {entry['cases']}", file=sys.stderr)
        versions.append(entry)
    commands = {"real": "cat tests/data/real_cases.jsonl", "generated": shlex.join(["fathom", *command])}
    return {"engine": "MuJoCo", "adapter": ADAPTER, "commands": commands, "versions": versions}


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--fathom", type=pathlib.Path, default=ROOT / "fathom")
    options.add_argument("--out", type=pathlib.Path, default=ROOT / "verify" / "survey" / "history.json")
    options.add_argument("--reports", type=pathlib.Path)
    options.add_argument("--count", type=int, default=368)
    given = options.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        reports = (given.reports or pathlib.Path(scratch)).absolute()
        reports.mkdir(parents=True, exist_ok=True)
        found = history(given.fathom.absolute(), given.count, reports)
    given.out.write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
