#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Puts the small world to adapters, every pair of tetrahedra with corners in {0, 1, 2}^3, and counts the verdicts by kind of pair.

    verify/survey/world.py --adapters bullet-epa,ode-collide     asks them, and goes on where an earlier run ended
    verify/survey/world.py --until 10                            the same, for ten minutes
    verify/survey/world.py --merge                               writes what is there into results.json

The pairs are asked in shards, each by all adapters before the next is made. What an adapter said to a shard is a line in
build/survey/world/ADAPTER.jsonl, so an interruption loses one at most. A kind is one of `fathom cases --small-world N`; every pair counts
as `all` too, and as `nothing_special` if nothing about it is. Only what was really asked is counted: `asked` says which pairs. Exit codes:
0 done; 2 wrong arguments; 3 a run failed, which was said; 4 time is up.
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


def counted(kinds, report):
    """Returns ({kind: {verdict: count}}, {kind: {verdict: the first pair}}) of a shard, whose pairs are of these kinds."""
    verdicts = {int(found[1]): found[2].decode() for line in report.open("rb") if (found := VERDICT.search(line))}
    if kinds.keys() != verdicts.keys():
        raise survey.Failed(f"{report}: {len(verdicts)} verdicts on {len(kinds)} pairs")
    counts, first = collections.defaultdict(collections.Counter), collections.defaultdict(dict)
    for number in sorted(kinds):
        for kind in kinds[number]:
            counts[kind][verdicts[number]] += 1
            first[kind].setdefault(verdicts[number], number)
    return counts, first


def make(options, begin, end):
    """Makes the cases of a shard; returns their file, and their kinds by number."""
    path = options.work / f"{options.adapters[0]}.cases.jsonl"
    with path.open("wb") as file:
        subprocess.run([options.fathom, "cases", "--small-world", str(begin), "--count", str(end - begin)], stdout=file, check=True)
    return path, {int(found[1]): kinds_of(found[2].decode()) for line in path.open("rb") if (found := CASE.search(line))}


def ask(options, adapter, begin, end, cases, kinds):
    """Asks an adapter about a shard; returns the line on it."""
    report = options.work / f"{adapter}.report.jsonl"
    report.unlink(missing_ok=True)
    words = [options.fathom, "certify", "--adapter", adapter, "--jobs", "1", "--time-out", str(QUICK), "--report", report, cases]
    done = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    if done.returncode not in survey.ENDS or not report.exists() or not tally.is_whole(report):
        raise survey.Failed(f"{adapter}, pairs from {begin}: certify ended with {done.returncode}: {done.stdout[-1000:]}")
    with report.open(encoding="utf-8") as file:
        head = json.loads(file.readline())
    counts, first = counted(kinds, report)
    report.unlink()
    hello = {key: head["subject"][key] for key in ("name", "version", "precision", "conventions", "settings")}
    return {"begin": begin, "end": end, "date": datetime.date.today().isoformat(), "fathom": options.version, "hello": hello,
            "tolerance": head["tolerance"], "counts": counts, "first": first}


def shards_of(options, adapter):
    """Returns the lines of an adapter, ascending; removes a last one that was cut off."""
    path = options.work / f"{adapter}.jsonl"
    text = path.read_text(encoding="utf-8") if path.exists() else ""
    whole = text[:text.rfind("\n") + 1]
    if whole != text:
        path.write_text(whole, encoding="utf-8")
    return sorted(map(json.loads, whole.splitlines()), key=lambda shard: shard["begin"])


def left_to_ask(options, end):
    """Returns [(begin, end, adapters)] of the shards that are wanted, ascending; None if one was asked in other shards, which is said."""
    wanted = {begin: min(begin + options.shard, end) for begin in range(options.first, end, options.shard * options.every)}
    known = {adapter: {shard["begin"]: shard["end"] for shard in shards_of(options, adapter)} for adapter in options.adapters}
    for adapter, shards in known.items():
        if any(wanted.get(begin) != stop for begin, stop in shards.items()
               if any(other < stop and begin < last for other, last in wanted.items())):
            survey.say(f"{adapter} was asked in other shards: go on with their size, or in another folder")
            return None
    left = [(begin, stop, [adapter for adapter in options.adapters if begin not in known[adapter]]) for begin, stop in wanted.items()]
    return [shard for shard in left if shard[2]]


def run(options, end):
    """Asks until nothing is left (0), something failed (3) or the time is up (4)."""
    begun = time.monotonic()
    left = left_to_ask(options, end)
    if left is None:
        return 3
    for done, (begin, stop, adapters) in enumerate(left):
        if options.until and time.monotonic() - begun > 60 * options.until:
            return 4
        try:
            cases, kinds = make(options, begin, stop)
            for adapter in adapters:
                line = ask(options, adapter, begin, stop, cases, kinds)
                with (options.work / f"{adapter}.jsonl").open("a", encoding="utf-8") as file:
                    file.write(json.dumps(line) + "\n")
        except survey.Failed as fault:
            survey.say(fault)
            return 3
        cases.unlink()
        minutes = (time.monotonic() - begun) / (done + 1) * (len(left) - done - 1) / 60
        survey.say(f"{', '.join(adapters)}: pairs up to {stop} of {end}, {minutes:.0f} min left")
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
