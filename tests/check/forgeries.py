#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Forges certificates by the thousand, and demands that all checkers agree on each and accept none whose claim is untrue.

forgeries.py --checker COMMAND [--checker COMMAND].. [--oracle FATHOM] [--count N] [--share K] [--seed S] PATH..

PATH        a genuine certificate, or a folder of them (*.cert)
--checker   a program that takes certificates as arguments and prints verdict lines; the first one sees every forgery
--share K   the further ones see every K-th forgery (default 1: all)
--solids N  besides, N certificates of format 2 that random_solids.py makes
--patches N N certificates of format 4 that patches.py makes; and of the others those that can have patches, with patches
--oracle    the program fathom, which re-solves the points of accepted forgeries whose points or claim are others than the genuine ones;
            those of formats 2 and 4 are judged by definition
--count N   forgeries in all, at least

Exit codes: 0 fine; 1 a disagreement, or an untrue claim was accepted; 2 usage, or a genuine certificate is not accepted.
"""
import argparse
import collections
import json
import os
import pathlib
import random
import re
import shlex
import subprocess
import sys
import tempfile
from fractions import Fraction

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parent))
import forging  # noqa: E402
import patches  # noqa: E402
import random_solids  # noqa: E402
import solids  # noqa: E402
from parts import Parts  # noqa: E402

getattr(sys, "set_int_max_str_digits", int)(0)
BATCH = 1000  # files a process
VERDICT = re.compile(r"s (?:(VERIFIED) (.*) (\S+)|(REFUSED|MALFORMED) (\S+?):\d+: .*)")
EXIT = {"VERIFIED": 0, "REFUSED": 1, "MALFORMED": 2}


def run_checker(command, folder, names):
    """name -> the verdicts on that file, in order: ("VERIFIED depth_squared=1",) or ("REFUSED",) or ..; the exit code must be the worst."""
    done = subprocess.run([*shlex.split(command), *names], cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE)
    found = {name: () for name in names}
    for line in done.stdout.decode().splitlines():
        if not line.startswith("s "):
            continue
        match = VERDICT.fullmatch(line)
        if not match or (match[3] or match[5]) not in found:
            raise SystemExit(f"{command}: no verdict line: {line[:200]}")
        name = match[3] or match[5]
        found[name] += (f"VERIFIED {match[2]}" if match[1] else match[4],)
    worst = max((EXIT[v.split()[0]] for verdicts in found.values() for v in verdicts), default=2)
    if done.returncode != worst:
        raise SystemExit(f"{command}: exit code {done.returncode} where the verdicts say {worst}")
    return found


def verdicts_of(options, folder, texts, fault):
    """name -> what the first checker says of that text; a fault for each of which another one, which sees every share-th, says else."""
    names = [f"f{k}" for k in range(len(texts))]
    for name, text in zip(names, texts):
        (pathlib.Path(folder) / name).write_bytes(text.encode())
    first, *others = options.checker
    found = run_checker(first, folder, names)
    for checker in others:
        for name, verdict in run_checker(checker, folder, names[::options.share]).items():
            if verdict != found[name]:
                fault(f"{first} says {found[name]}, {checker} says {verdict}", texts[int(name[1:])])
    return found


def statement(text):
    """What a certificate claims, as exact values: two equal ones are true together."""
    parts = Parts(text)
    if parts.format in ("2", "4"):
        proof = ["heights", "inner", "weights", "vertices", "facets", "differences", "patches", "rates"]
        proof += ["directions"] if parts.which == "some" and parts.format == "2" else []
        return (parts.claim, parts.which, {part: rows for part, rows in parts.rows.items() if not part.startswith(tuple(proof))},
                patches.claimed(parts) if parts.format == "4" else None)
    points = [[[Fraction(x) for x in row] for row in parts.rows[body]] for body in "ab"]
    directions = sorted(tuple(map(int, row)) for row in parts.rows["directions"]) if parts.which == "all" else None
    return points, parts.claim[0], [Fraction(x) for x in parts.claim[1:]], directions


def solved(oracle, statements):
    """The oracle's result for the points of each statement."""
    cases = ""
    for number, (points, *_) in enumerate(statements):
        a, b = ({"vertices": [[str(x) for x in p] for p in body]} for body in points)
        cases += json.dumps({"schema": "fathom/case/1", "id": str(number), "a": a, "b": b}) + "\n"
    done = subprocess.run([*shlex.split(oracle), "depth", "--json", "-"], input=cases.encode(), stdout=subprocess.PIPE)
    return [json.loads(line) for line in done.stdout.decode().splitlines()]


def is_true(claim, result):
    _, word, bounds, directions = claim
    if word in ("touching", "disjoint"):
        return result["status"] == word
    squared = Fraction(result["depth"]["squared"])
    if result["status"] != "penetrating" or not bounds[0] <= squared <= bounds[-1]:
        return False
    return directions is None or directions == sorted(tuple(map(int, o["direction"])) for o in result["optima"])


class Campaign:
    def __init__(self, options):
        self.options, self.faults = options, []
        self.kinds, self.outcomes = collections.Counter(), collections.Counter()
        self.accepted, self.same = [], 0

    def fault(self, sentence, text):
        """Keeps the forgery, so that it can be looked at."""
        path = pathlib.Path(tempfile.gettempdir()) / f"forgery_{os.getpid()}_{len(self.faults)}.cert"
        path.write_text(text)
        self.faults.append(f"{sentence}: {path}")

    def judge_batch(self, batch):
        """batch: (kind, forged text, genuine text)."""
        with tempfile.TemporaryDirectory(dir="/dev/shm" if os.access("/dev/shm", os.W_OK) else None) as folder:
            verdicts = verdicts_of(self.options, folder, [forged for _, forged, _ in batch], self.fault)
        for name, (kind, forged, genuine) in zip(verdicts, batch):
            self.kinds[kind] += 1
            self.outcomes[max(verdicts[name], key=lambda v: EXIT[v.split()[0]], default="none").split()[0]] += 1
            if any(verdict.startswith("VERIFIED") for verdict in verdicts[name]):
                if kind in forging.NEVER_ACCEPTED:
                    self.fault(f"{kind}: accepted, though it never is a proof", forged)
                self.take_accepted(forged, genuine, verdicts[name])

    def take_accepted(self, forged, genuine, verdicts):
        """Finds the accepted certificates among the pieces of a forged file: each header begins a piece, with one verdict; and what
        follows a complete certificate within its piece has one of its own."""
        verdicts = list(verdicts)
        for piece in filter(None, re.split(r"^(?=fathom-certificate)", forged, flags=re.MULTILINE)):
            verdict = verdicts.pop(0) if verdicts else "MALFORMED"
            end = re.search(r"^end .*\n", piece, re.MULTILINE)
            if verdict != "MALFORMED" and re.search(r"^[^#]", piece[end.end():], re.MULTILINE):
                verdicts.pop(0)
            if not verdict.startswith("VERIFIED"):
                continue
            claim = statement(piece[:end.end()])
            if claim == statement(genuine):
                self.same += 1
            else:
                self.accepted.append((claim, forged, piece[:end.end()]))
        if verdicts:
            self.fault(f"more verdicts than certificates, {verdicts}", forged)

    def judge_accepted(self):
        polytopes = [(claim, forged) for claim, forged, piece in self.accepted if piece.startswith("fathom-certificate 1")]
        for _, forged, piece in self.accepted:
            if not piece.startswith("fathom-certificate 1") and not self.is_true_by_definition(Parts(piece)):
                self.fault("an untrue claim is accepted", forged)
        if polytopes and not self.options.oracle:
            return [self.fault("accepted, and no oracle to ask", forged) for _, forged in polytopes]
        for k in range(0, len(polytopes), BATCH):
            part = polytopes[k:k + BATCH]
            results = solved(self.options.oracle, [claim for claim, _ in part])
            if len(results) != len(part):
                raise SystemExit("the oracle did not answer every case")
            for (claim, forged), result in zip(part, results):
                if not is_true(claim, result):
                    self.fault("an untrue claim is accepted", forged)
        return None

    @staticmethod
    def is_true_by_definition(parts):
        return solids.is_true(parts) and (parts.format != "4" or patches.is_true(parts))

    def report(self):
        total = sum(self.kinds.values())
        print(f"{total} forgeries: " + ", ".join(f"{kind} {count}" for kind, count in sorted(self.kinds.items())))
        print(", ".join(f"{count} {outcome}" for outcome, count in sorted(self.outcomes.items())) +
              f"; of the accepted {self.same} claim what the genuine one does, {len(self.accepted)} were re-solved")
        for fault in self.faults:
            print(fault)
        return 1 if self.faults or total < self.options.count else 0


def genuine_texts(options):
    paths = [path for given in map(pathlib.Path, options.path) for path in (sorted(given.glob("*.cert")) if given.is_dir() else [given])]
    texts = []
    for path in paths:
        for text in re.split(r"^(?=fathom-certificate)", path.read_text(), flags=re.MULTILINE):
            if text.startswith("fathom-certificate"):
                texts.append(Parts(text).text())
    texts += [Parts(text).text() for _, text, _ in random_solids.genuine(options.solids, options.seed)]
    if not options.patches:
        return texts
    rng = random.Random(options.seed)
    texts = [text if text.startswith("fathom-certificate 4") else patches.with_patches(text, rng) for text in texts
             if patches.can_have_patches(text)]
    return texts + list(patches.genuine(options.patches, options.seed))


def campaign_arguments(count):
    """A parser of what all programs with forgeries are told."""
    parser = argparse.ArgumentParser(description=sys.modules["__main__"].__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--checker", action="append", required=True)
    parser.add_argument("--count", type=int, default=count)
    parser.add_argument("--share", type=int, default=1)
    parser.add_argument("--seed", type=int, default=1)
    return parser


def main():
    parser = campaign_arguments(20000)
    parser.add_argument("--oracle")
    parser.add_argument("--solids", type=int, default=0)
    parser.add_argument("--patches", type=int, default=0)
    parser.add_argument("path", nargs="*")
    options = parser.parse_args()
    texts = genuine_texts(options)
    campaign, batch = Campaign(options), []
    with tempfile.TemporaryDirectory() as folder:
        names = [f"g{k}" for k in range(len(texts))]
        for name, text in zip(names, texts):
            (pathlib.Path(folder) / name).write_text(text)
        for checker in options.checker:
            found = run_checker(checker, folder, names) if names else {}
            if not found or any(len(v) != 1 or not v[0].startswith("VERIFIED") for v in found.values()):
                print(f"{checker}: genuine certificates are not accepted, or there are none")
                return 2
    others = [Parts(text) for text in texts]
    each = -(-options.count * 3 // (2 * len(texts)))  # some forgeries come out genuine, some ways do not apply
    for number, text in enumerate(texts):
        for kind, forged in forging.forgeries(text, others, each, f"{options.seed}/{number}"):
            batch.append((kind, forged, text))
            if len(batch) == BATCH:
                campaign.judge_batch(batch)
                batch = []
    if batch:
        campaign.judge_batch(batch)
    campaign.judge_accepted()
    return campaign.report()


if __name__ == "__main__":
    sys.exit(main())
