#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Puts the small world to adapters, every pair of tetrahedra with corners in {0, 1, 2}^3, and counts the verdicts by kind of pair.

    verify/survey/world.py --adapters bullet-epa,ode-collide     asks them, and goes on where an earlier run ended
    verify/survey/world.py --until 10                            the same, for ten minutes
    verify/survey/world.py --merge                               writes what is there into results.json

The pairs are asked in shards; each leaves a line in build/survey/world/ADAPTER.jsonl, so an interruption loses one shard at most. A kind is
one of `fathom cases --small-world N`; every pair counts as `all` too, and as `nothing_special` if nothing about it is. Only what was really
asked is counted: `asked` says which pairs. Exit codes: 0 done; 2 wrong arguments; 3 a run failed, which was said; 4 time is up.
"""
import argparse
import collections
import datetime
import json
import pathlib
import re
import subprocess
import sys
import time

import sets
import survey
import tally

ALL, ORDINARY = "all", "nothing_special"
# # The ways to meet of pairs in general position; with any further word a pair is special.
GENERAL = ("disjoint", "contact_facet_vertex", "contact_vertex_facet", "contact_edge_edge")
CASE = re.compile(rb'"id":"small_world::(\d+)".*"kinds":"([a-z_ ]+)"')
VERDICT = re.compile(rb'"type":"case","id":"small_world::(\d+)".*?"verdict":"([a-z-]+)"')
MOST_RANGES = 3  # that a table names
QUICK = 10  # seconds for a case of two tetrahedra


def kinds_of(words):
    kinds = words.split()
    return [ALL, *kinds, *[ORDINARY] * (len(kinds) == 1 and kinds[0] in GENERAL)]


def last_number(fathom):
    """Returns the number of the last pair, as the program names it."""
    done = subprocess.run([fathom, "cases", "--small-world", str(2**64 - 1)], stderr=subprocess.PIPE, text=True, check=False)
    return int(re.search(r"from 0 to (\d+)", done.stderr)[1])


def counted(cases, report):
    """Returns ({kind: {verdict: count}}, {kind: {verdict: the first pair}}) of a shard."""
    kinds = {int(found[1]): found[2].decode() for line in cases.open("rb") if (found := CASE.search(line))}
    verdicts = {int(found[1]): found[2].decode() for line in report.open("rb") if (found := VERDICT.search(line))}
    if kinds.keys() != verdicts.keys():
        raise survey.Failed(f"{report}: {len(verdicts)} verdicts on {len(kinds)} pairs")
    counts, first = collections.defaultdict(collections.Counter), collections.defaultdict(dict)
    for number in sorted(kinds):
        for kind in kinds_of(kinds[number]):
            counts[kind][verdicts[number]] += 1
            first[kind].setdefault(verdicts[number], number)
    return counts, first


def ask(options, adapter, begin, count):
    """Asks an adapter about a shard; returns the line on it."""
    cases, report = options.work / f"{adapter}.cases.jsonl", options.work / f"{adapter}.report.jsonl"
    with cases.open("wb") as file:
        subprocess.run([options.fathom, "cases", "--small-world", str(begin), "--count", str(count)], stdout=file, check=True)
    report.unlink(missing_ok=True)
    words = [options.fathom, "certify", "--adapter", adapter, "--jobs", "1", "--time-out", str(QUICK), "--report", report, cases]
    done = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    if done.returncode not in survey.ENDS or not report.exists() or not tally.is_whole(report):
        raise survey.Failed(f"{adapter}, pairs from {begin}: certify ended with {done.returncode}: {done.stdout[-1000:]}")
    with report.open(encoding="utf-8") as file:
        head = json.loads(file.readline())
    counts, first = counted(cases, report)
    cases.unlink()
    report.unlink()
    hello = {key: head["subject"][key] for key in ("name", "version", "precision", "conventions", "settings")}
    return {"begin": begin, "end": begin + count, "date": datetime.date.today().isoformat(), "fathom": options.version, "hello": hello,
            "tolerance": head["tolerance"], "counts": counts, "first": first}


def shards_of(options, adapter):
    """Returns the lines of an adapter, ascending; removes a last one that was cut off."""
    path = options.work / f"{adapter}.jsonl"
    text = path.read_text(encoding="utf-8") if path.exists() else ""
    whole = text[:text.rfind("\n") + 1]
    if whole != text:
        path.write_text(whole, encoding="utf-8")
    return sorted(map(json.loads, whole.splitlines()), key=lambda shard: shard["begin"])


def run(options, end):
    """Asks until nothing is left (0), something failed (3) or the time is up (4)."""
    begun = time.monotonic()
    for adapter in options.adapters:
        known = shards_of(options, adapter)
        wanted = {begin: min(begin + options.shard, end) for begin in range(options.first, end, options.shard * options.every)}
        if any(wanted.get(shard["begin"]) != shard["end"] for shard in known
               if any(begin < shard["end"] and shard["begin"] < stop for begin, stop in wanted.items())):
            survey.say(f"{adapter} was asked in other shards: go on with their size, or in another folder")
            return 3
        begins = [begin for begin in wanted if begin not in {shard["begin"] for shard in known}]
        started = time.monotonic()
        for done, begin in enumerate(begins):
            if options.until and time.monotonic() - begun > 60 * options.until:
                return 4
            try:
                line = ask(options, adapter, begin, min(options.shard, end - begin))
            except survey.Failed as fault:
                survey.say(fault)
                return 3
            with (options.work / f"{adapter}.jsonl").open("a", encoding="utf-8") as file:
                file.write(json.dumps(line) + "\n")
            left = (time.monotonic() - started) / (done + 1) * (len(begins) - done - 1)
            survey.say(f"{adapter}: pairs up to {line['end']} of {end}, {left / 60:.0f} min left")
    return 0


def joined(ranges):
    """Returns ascending ranges, those that meet as one."""
    result = []
    for begin, end in ranges:
        if result and result[-1][1] == begin:
            result[-1][1] = end
        else:
            result.append([begin, end])
    return result


def summed(shards):
    """Returns what is known of one subject."""
    counts, first = collections.defaultdict(collections.Counter), collections.defaultdict(dict)
    for shard in shards:
        if (shard["hello"], shard["tolerance"]) != (shards[0]["hello"], shards[0]["tolerance"]):
            raise survey.Failed(f"{shards[0]['hello']['name']}: its shards are of different versions or settings; remove those of one")
        for kind, found in shard["counts"].items():
            counts[kind].update(found)
        for kind, found in shard["first"].items():
            for verdict, number in found.items():
                first[kind].setdefault(verdict, number)
    failing = {kind: {verdict: number for verdict, number in found.items() if tally.group_of(verdict) not in ("right", "declined")}
               for kind, found in first.items()}
    dates = [shard["date"] for shard in shards]
    return {"made": {"date": max(dates), "fathom": shards[0]["fathom"]}, "hello": shards[0]["hello"], "tolerance": shards[0]["tolerance"],
            "asked": joined([shard["begin"], shard["end"]] for shard in shards),
            "kinds": {kind: {"n": dict(sorted(counts[kind].items())), "first": failing[kind]} for kind in sorted(counts)}}


# ---- tables ----


def asked_text(subject, pairs):
    """Returns "all 6463188", or which pairs were asked."""
    if subject["asked"] == [[0, pairs]]:
        return f"all {pairs}"
    if len(subject["asked"]) > MOST_RANGES:
        asked = sum(end - begin for begin, end in subject["asked"])
        return f"{asked} of {pairs}, in {len(subject['asked'])} runs from {subject['asked'][0][0]} to {subject['asked'][-1][1] - 1}"
    return ", ".join(f"{begin} to {end - 1}" for begin, end in subject["asked"])


def least_failing(cell):
    """Returns "too-deep 17": the least failing pair of a kind, with its verdict; or nothing."""
    number, verdict = min(((number, verdict) for verdict, number in cell["first"].items()), default=("", ""))
    return f"{verdict} {number}".strip()


def rows_of(subject):
    """Returns (head, rows) about a subject: for each kind the pairs, the groups of verdicts that occur, and the least failing pair."""
    counts = {}
    for kind, cell in subject["kinds"].items():
        counts[kind] = collections.Counter()
        for verdict, count in cell["n"].items():
            counts[kind][tally.group_of(verdict)] += count
    used = [group for group in tally.GROUPS if any(counts[kind][group] for kind in counts)]
    order = sorted(counts, key=lambda kind: (kind != ALL, kind != ORDINARY, kind))
    return (["kind of pair", "pairs", *used, "least failing pair"],
            [[kind, sum(counts[kind].values()), *(counts[kind][group] or "" for group in used), least_failing(subject["kinds"][kind])]
             for kind in order])


# ---- the results ----


def merge(options, end):
    """Writes the small world into results.json: subjects that were asked here, and those that are there already."""
    path = options.out / "results.json"
    results = json.loads(path.read_text(encoding="utf-8"))
    old = results.get("small_world", {})
    subjects = dict(old.get("subjects", {}))
    for adapter in options.adapters:
        if shards := shards_of(options, adapter):
            subjects[adapter] = summed(shards)
    order = [subject["adapter"] for subject in results["subjects"]]
    results["small_world"] = {"command": "fathom cases --small-world 0 --count " + str(end), "pairs": end,
                              "subjects": dict(sorted(subjects.items(), key=lambda each: order.index(each[0])))}
    path.write_text(tally.text(results), encoding="utf-8")
    return 0


def main(words=None):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--fathom", default=str(sets.ROOT / "fathom"), help="the program; this project's launcher unless given")
    parser.add_argument("--adapters", type=lambda text: text.split(","), help="these, one after another, with commas; all unless given")
    parser.add_argument("--shard", type=int, default=50_000, help="pairs at once")
    parser.add_argument("--every", type=int, default=1, metavar="K", help="of the shards only each K-th; without it later, the others too")
    parser.add_argument("--first", type=int, default=0, help="the first pair")
    parser.add_argument("--end", type=int, help="the pair after the last one")
    parser.add_argument("--until", type=float, default=0, help="minutes after which no further shard is begun")
    parser.add_argument("--merge", action="store_true", help="ask nobody: write what is there into results.json")
    parser.add_argument("--work", type=pathlib.Path, default=sets.ROOT / "build" / "survey" / "world", help="keeps what was counted")
    parser.add_argument("--out", type=pathlib.Path, default=survey.HERE, help="has results.json")
    options = parser.parse_args(words)
    there, _ = survey.adapters(options.fathom)
    options.adapters = options.adapters or list(there)
    if unknown := set(options.adapters) - set(there):
        parser.error(f"not among the adapters that are there: {', '.join(sorted(unknown))}")
    told = subprocess.run([options.fathom, "--version"], stdout=subprocess.PIPE, check=True, text=True).stdout
    options.version = told.splitlines()[0].strip()
    options.work.mkdir(parents=True, exist_ok=True)
    end = last_number(options.fathom) + 1
    if options.merge:
        return merge(options, end)
    return run(options, min(end, options.end or end))


if __name__ == "__main__":
    sys.exit(main())
