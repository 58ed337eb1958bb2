# SPDX-License-Identifier: GPL-3.0-or-later
"""What changed from version to version, of a library or of fathom. `earlier` of a subject in results.json has what it answered before, the
oldest first: an entry for each version of the library by each version of fathom, with the counts and the outcomes of its sets, but without
the worst cases. What a version answered stays as it was judged then."""
import tally
from markup import e

MOST_NAMED = 8
KEPT = ("made", "cases", "groups", "verdicts", "outcomes")
FAILING = set(tally.LETTERS.values()) - {tally.LETTERS["right"], tally.LETTERS["declined"]}
HEAD = ["subject", "version before", "version", "set", "right", "counts that moved", "fail now", "pass now"]


def entry(hello, answers, released=""):
    """Returns what is kept of {set: answers}. `released`: the day on which the version came out, if that is known."""
    kept = {name: {**{field: found[field] for field in KEPT}, "cells": {row: {"n": cell["n"]} for row, cell in found["cells"].items()}}
            for name, found in answers.items()}
    return {"hello": hello, **({"released": released} if released else {}), "sets": kept}


def keep(subject, hello, name, fathom):
    """Moves the answers that others replace into `earlier`, when this fathom has asked the set of a subject with this hello: all that are
    of another version of the library, and those to the set that another fathom judged."""
    if "hello" not in subject:
        return
    other = subject["hello"]["version"] != hello["version"]
    for old in list(subject["sets"]):
        made = subject["sets"][old]["made"]["fathom"]
        if not other and (old != name or made == fathom):
            continue
        kept = entry(subject["hello"], {old: subject["sets"].pop(old)})
        earlier = subject.setdefault("earlier", [])
        place = next((each for each in earlier if key_of(each) == key_of(kept)), None)
        if place is None:
            earlier.append(kept)
        else:
            place["sets"].update(kept["sets"])


def key_of(kept):
    """Returns the versions of the library and of fathom."""
    return kept["hello"]["version"], next(found["made"]["fathom"] for found in kept["sets"].values())


def version_text(stage, other, name):
    """Returns the version of the library, and that of fathom where the other stage has a different one for the set; with the day of its
    release if that is known, else of its answers."""
    made, others = (each["sets"][name]["made"] for each in (stage, other))
    by = f" by {made['fathom']}" if made["fathom"] != others["fathom"] else ""
    return f"{stage['hello']['version']}{by}, " + (f"of {stage['released']}" if "released" in stage else f"answered {made['date']}")


def failing(found):
    """Returns {row: how many of its cases fail}."""
    return {row: sum(count for verdict, count in cell["n"].items() if tally.LETTERS[tally.group_of(verdict)] in FAILING)
            for row, cell in found["cells"].items()}


def counted(before, after):
    """Returns how many cases fail in `after` alone, and the names of the rows of which more do."""
    number = sum(new in FAILING and old not in FAILING for old, new in zip(before["outcomes"], after["outcomes"], strict=True))
    old = failing(before)
    rows = [row.rpartition("::")[2] for row, count in failing(after).items() if count > old.get(row, 0)]
    more = f" and {len(rows) - MOST_NAMED} more" if len(rows) > MOST_NAMED else ""
    names = f": {', '.join(rows[:MOST_NAMED])}{more}" if rows else ""
    return f"{number}{names}" if number else ""


def compared(before, after):
    """Returns the last four cells of a row: two versions about one set."""
    right = [found["groups"].get("right", 0) for found in (before, after)]
    if before["made"]["cases"] != after["made"]["cases"]:
        return [f"{right[0]} of {before['cases']}, {right[1]} of {after['cases']}", "not compared: the cases are others", "", ""]
    moved = [f"{group} {old} to {new}" for group in tally.GROUPS if group != "right"
             and (old := before["groups"].get(group, 0)) != (new := after["groups"].get(group, 0))]
    return [f"{right[0]} to {right[1]} of {after['cases']}", "; ".join(moved), counted(before, after), counted(after, before)]


def rows_of(results):
    """Returns a row for each set that a version answered, and the version before it as well."""
    rows = []
    for subject in results["subjects"]:
        stages = [*subject.get("earlier", []), *([subject] if subject["sets"] else [])]
        for number, stage in enumerate(stages):
            for name, found in stage["sets"].items():
                before = next((each for each in reversed(stages[:number]) if name in each["sets"]), None)
                if before:
                    rows.append([subject["adapter"], version_text(before, stage, name), version_text(stage, before, name), name,
                                 *compared(before["sets"][name], found)])
    return rows


def section(results):
    """Returns the rows as a part of the page; nothing if no subject was asked twice."""
    rows = rows_of(results)
    if not rows:
        return ""
    head = "".join(f'<th scope="col">{e(cell)}</th>' for cell in HEAD)
    cells = "\n".join(f'<tr><th scope="row">{e(row[0])}</th>{"".join(f"<td>{e(cell)}</td>" for cell in row[1:])}</tr>' for row in rows)
    return ('<section><h2>What changed</h2>\n<p>From each version to the next, about the same cases, as fathom judged both.</p>\n<div class="wide" '
            f'tabindex="0" role="region" aria-label="What changed"><table class="facts"><thead><tr>{head}</tr></thead><tbody>{cells}</tbody>'
            "</table></div></section>\n")
