# SPDX-License-Identifier: GPL-3.0-or-later
"""Counts the findings about contacts: "contacts" of results.json, and its tables.

Of each set, a subject has `found`: for each tolerance and each family how many answers have a finding of VERDICTS.md, and `first`, for each
finding the first case that has it at the wider tolerance, or else at the usual one, with the sentence. An answer may have several.
"""
import collections

import sets
import tally

FINDINGS = ("contact-outside", "contact-too-deep", "contact-too-shallow", "misses-extent", "tips")
USUAL, WIDE = sets.TOLERANCES
TILTS = {"parallel": "0", "tilted_hair": "1e-9", "tilted_slightly": "1e-4", "tilted": "0.01"}


def findings_of(outcome):
    """Returns {finding: the sentence of the first contact that has it} for an outcome."""
    found = {}
    for fault in outcome.get("contact_faults", []):
        found.setdefault(fault["finding"], fault["sentence"])
    return found


def summary(lines):
    """Returns (number of answers with contacts, {family: {finding: count}}, {finding: [case, sentence]}) for a report."""
    told, counts, first = 0, {}, {}
    for outcome in tally.outcomes_of(lines):
        told += bool(outcome.get("reply", {}).get("contacts"))
        for finding, sentence in findings_of(outcome).items():
            counts.setdefault(tally.family_of(outcome["id"]), collections.Counter())[finding] += 1
            first.setdefault(finding, [outcome["id"], sentence])
    return told, {family: dict(each) for family, each in counts.items()}, first


def answers_of(reports, made):
    """Returns a subject of a set, by its report at each tolerance."""
    found, first = {}, {}
    for tolerance in (USUAL, WIDE):
        lines = tally.read(reports[tolerance])
        told, found[tolerance], cases = summary(lines)
        first.update(cases)
    hello = lines[0]["subject"]
    return {"made": made, "version": hello["version"], "manifold": hello.get("manifold", {}), "told": told, "found": found, "first": first}


def set_of(name, path):
    return {key: value for key, value in tally.set_of(name, path).items() if key != "by_case"}


# ---- tables ----

def count(found, finding, families=None):
    return sum(each.get(finding, 0) for family, each in found.items() if families is None or family in families)


def both(subject, finding, families=None):
    """Returns the count at the usual tolerance, and how many of these remain at the wider one."""
    usual, wide = (count(subject["found"][tolerance], finding, families) for tolerance in (USUAL, WIDE))
    return f"{usual}, {wide}" if usual or wide else ""


def rows_of(found):
    """Returns (head, rows) for a set: of faces with a column for each tilt, where contacts are to cover the whole patch."""
    of_tilt = {family.partition("_")[2]: family for family in found["rows"]}
    columns = [(f"misses extent, tilt {told}", [of_tilt[tilt]]) for tilt, told in TILTS.items() if tilt in of_tilt]
    columns = columns or [("misses extent", None)]
    head = ["subject", "most", "answers", "outside", "too deep", "too shallow", *(name for name, _ in columns), "tips"]
    rows = []
    for adapter, subject in found["subjects"].items():
        rows.append([adapter, f"{most:g}" if (most := subject["manifold"].get("most")) else "", subject["told"],
                     *(both(subject, finding) for finding in FINDINGS[:3]),
                     *(both(subject, "misses-extent", families) for _, families in columns), both(subject, "tips")])
    return head, rows


def firsts(found):
    return [[adapter, finding, case, sentence] for adapter, subject in found["subjects"].items()
            for finding, (case, sentence) in sorted(subject["first"].items(), key=lambda each: FINDINGS.index(each[0]))]
