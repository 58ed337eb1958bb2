# SPDX-License-Identifier: GPL-3.0-or-later
"""Reports of `fathom certify` as numbers: results.json of schema fathom/survey/3.

Each set of each subject says when, by which fathom and about which cases it was `made`, as parts of the survey are run again alone. It has
cells, one for each family or, where every case has a row of its own, for each case: `n` counts verdicts, and `worst` is the worst failing
answer as [case, digest, verdict, sentence]. `outcomes` has a letter for each case, in the order of the cases. `alone` counts the answers
that are right in status and depth, whatever else is wrong with them. Errors are the claimed depth less the true one, in parts of R, the
largest coordinate. `tried` has how many were right with other settings, or sizes of bodies.
"""
import collections
import json
import re
import statistics

import sets

PASSES = ("pass", "touching-by-convention")
CLASSES = ("correctly rounded", "4 ulp", "16 uR", "1e-6", "tolerance")
# # The groups of verdicts, in the order of the tables.
GROUPS = {"right": PASSES, "too deep": ("too-deep",), "too shallow": ("too-shallow",),
          "wrong status": ("false-separation", "false-overlap"),
          "other wrong": ("not-a-direction", "wrong-sign", "too-far", "too-near", "not-separating", "inconsistent", "witness-off",
                          "contact-outside", "contact-too-deep", "contact-too-shallow", "misses-extent", "tips", "wrong-derivative",
                          "not-invariant", "nan"),
          "no answer": ("crash", "time-out", "silent", "garbage", "failed"), "declined": ("unsupported",)}
GROUP_OF = {verdict: group for group, verdicts in GROUPS.items() for verdict in verdicts}
LETTERS = {"right": ".", "too deep": "D", "too shallow": "S", "wrong status": "X", "other wrong": "W", "no answer": "N", "declined": "-"}
# # Findings about answers whose status and depth are right: on the direction, the points, the distance of bodies that are apart.
BEYOND_DEPTH = {"not-a-direction", "not-separating", "inconsistent", "witness-off", "contact-outside", "contact-too-deep",
                "contact-too-shallow", "misses-extent", "tips", "wrong-derivative", "too-far", "too-near"}
BADNESS = ("wrong status", "too shallow", "too deep", "other wrong", "no answer")  # of equal errors, and where there is none
SUBSETS = ("solid", "metre_sized")  # fields of a report's line that are true or false
LONGEST = 160  # characters of a sentence


def group_of(verdict):
    return GROUP_OF.get(verdict, "other wrong")


def family_of(case):
    """Returns the family in an id, as fathom's own tables group the cases."""
    found = re.fullmatch(r"(.+?)(?:::.*|-n\d+-s\d+)", case)
    return found.group(1) if found else ""


def read(path):
    return [json.loads(line) for line in path.read_text(encoding="utf-8").splitlines()]


def numbers_of(hello):
    """Returns (the precision of points, that of answers)."""
    precision = hello["precision"]
    return (precision["points"], precision["answers"]) if isinstance(precision, dict) else (precision, precision)


def numbers_text(hello):
    points, answers = numbers_of(hello)
    return points if points == answers else f"{points}, answers {answers}"


def is_whole(path):
    with path.open("rb") as file:
        file.seek(max(0, path.stat().st_size - 4096))
        last = file.read().splitlines()[-1:]
    return bool(last) and last[0].startswith(b'{"schema":"fathom/verdict/1","type":"summary"')


def outcomes_of(lines):
    """Returns the outcomes; of a case that was run again only the last."""
    return list({line["id"]: line for line in lines if line["type"] == "case"}.values())


def error_of(outcome, unit_roundoff):
    """Returns the error in parts of R; None without a claimed depth."""
    value = outcome.get("judgement", {}).get("error_u_r")
    return None if value is None or isinstance(value, str) else value * unit_roundoff


def sentence_of(outcome):
    text = outcome.get("judgement", {}).get("sentence") or outcome.get("detail", "")
    while len(text) > LONGEST and "; " in text:
        text = text.rpartition("; ")[0]
    return text if len(text) <= LONGEST else text[:LONGEST - 3] + "..."


def worst_of(outcomes, unit_roundoff):
    """Returns the failing outcome with the largest error; wrong answers rank before missing ones."""
    failing = [o for o in outcomes if group_of(o["verdict"]) in BADNESS]
    if not failing:
        return None

    def rank(outcome):
        group = group_of(outcome["verdict"])
        return group != "no answer", abs(error_of(outcome, unit_roundoff) or 0), -BADNESS.index(group), outcome["id"]
    return max(failing, key=rank)


def groups(outcomes):
    counts = collections.Counter(group_of(o["verdict"]) for o in outcomes)
    return {group: counts[group] for group in GROUPS if counts[group]}


def cell(outcomes, unit_roundoff):
    found = {"n": dict(collections.Counter(o["verdict"] for o in outcomes))}
    if worst := worst_of(outcomes, unit_roundoff):
        found["worst"] = [worst["id"], worst["digest"], worst["verdict"], sentence_of(worst)]
    return found


def microseconds(outcomes):
    """Returns the median and the worst of the times that subjects measured themselves."""
    times = [t for o in outcomes if (t := o.get("microseconds", o.get("reply", {}).get("microseconds"))) is not None]
    return {"median": statistics.median(times), "worst": max(times), "timed": len(times)} if times else None


def extreme(outcomes, unit_roundoff, verdict, sign):
    """Returns the answer with that verdict whose error is the largest in that direction."""
    found = [(sign * (error_of(o, unit_roundoff) or 0), o["id"]) for o in outcomes if o["verdict"] == verdict]
    if not found:
        return None
    error, case = max(found)
    return {"error": sign * error, "case": case}


def is_right_alone(outcome):
    """Returns whether the status is right, and the depth if there is one."""
    judgement = outcome.get("judgement", {})
    return outcome["verdict"] in PASSES or bool(judgement) and set(judgement["findings"]) <= BEYOND_DEPTH


def judged(line):
    """Returns how many answers of a report had each field and were judged by it. Every answer has a status."""
    return {name: line["judged"][name] for name in ("overlapping", "depth", "direction", "witness", "distance")}


def summary(lines, unit_roundoff, by_case, as_minimum):
    """`as_minimum`: the lines of the same report; for a subject that claims less than shortest translations, of one judged by these."""
    outcomes = outcomes_of(lines)
    cells = collections.defaultdict(list)
    for outcome in outcomes:
        cells[outcome["id"] if by_case else family_of(outcome["id"])].append(outcome)
    relative = [abs(value) for o in outcomes if isinstance(value := o.get("judgement", {}).get("error_relative"), (int, float))]
    accuracy = collections.Counter(o["judgement"]["accuracy"] for o in outcomes if "accuracy" in o.get("judgement", {}))
    result = {"cases": len(outcomes), "groups": groups(outcomes), "verdicts": dict(collections.Counter(o["verdict"] for o in outcomes)),
              "judged": judged(lines[-1]), "alone": sum(map(is_right_alone, outcomes_of(as_minimum))),
              "accuracy": {name: accuracy[name] for name in CLASSES if accuracy[name]},
              "median_relative_error": statistics.median(relative) if relative else None,
              "most_too_deep": extreme(outcomes, unit_roundoff, "too-deep", 1),
              "most_too_shallow": extreme(outcomes, unit_roundoff, "too-shallow", -1), "microseconds": microseconds(outcomes),
              "subsets": {name: groups(chosen) for name in SUBSETS if (chosen := [o for o in outcomes if o.get(name) is True])},
              "outcomes": "".join(LETTERS[group_of(o["verdict"])] for o in outcomes)}
    result["cells"] = {name: cell(found, unit_roundoff) for name, found in cells.items()}
    return result


def set_of(name, path):
    """Returns a set for the results: its command, its cases, and the number of cases in each row of its tables."""
    chosen, cases = sets.ALL[name], sets.read_cases(path)
    rows = collections.Counter(case if chosen.by_case else family_of(case) for case in cases)
    return {"title": chosen.title, "about": chosen.about, "command": chosen.command(), "cases": len(cases), "digest": sets.digest(path),
            "by_case": chosen.by_case, "rows": dict(sorted(rows.items()) if not chosen.by_case else rows)}


def answers_of(report, as_minimum, made, by_case):
    """Returns (hello, tolerance, the set of a subject) of a report."""
    lines = read(report)
    hello = {key: value for key, value in lines[0]["subject"].items() if key not in ("type", "protocol")}
    unit_roundoff = 2.0**-24 if numbers_of(hello)[0] == "binary32" else 2.0**-53
    return hello, lines[0]["tolerance"], {"made": made, **summary(lines, unit_roundoff, by_case, read(as_minimum))}


def compact(values):
    """Returns an object of JSON with a line for each of its values."""
    return "{\n  " + ",\n  ".join(f"{json.dumps(name)}:{json.dumps(found, separators=(',', ':'))}" for name, found in values.items()) + "}"


def text(results_):
    """Returns JSON with a line for each set of each subject: compact, and with small differences between versions."""
    def with_lines(values, key):
        head = json.dumps({name: value for name, value in values.items() if name != key})[:-1]
        return f'{head}, "{key}": {compact(values[key])}}}'
    subjects = [with_lines(subject, "sets") for subject in results_["subjects"]]
    contacts = [f"{json.dumps(name)}: {with_lines(found, 'subjects')}" for name, found in results_["contacts"].items()]
    head = json.dumps({key: value for key, value in results_.items() if key not in ("subjects", "contacts", "small_world")}, indent=1)[:-2]
    if small := results_.get("small_world"):
        of_subjects = [f"{json.dumps(name)}: {with_lines(found, 'kinds')}" for name, found in small["subjects"].items()]
        rest = json.dumps({key: value for key, value in small.items() if key != "subjects"})[:-1]
        head += f',\n "small_world": {rest}, "subjects": {{\n' + ",\n".join(of_subjects) + "}}"
    return f'{head},\n "contacts": {{\n' + ",\n".join(contacts) + '},\n "subjects": [\n' + ",\n".join(subjects) + "\n]}\n"
