#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes RESULTS.md and results.json of the reports that survey.sh let `fathom certify` write."""
import argparse
import collections
import json
import pathlib
import re
import statistics
import sys

SETS = {"real": "Real cases", "generated": "Generated cases"}
PASSES = ("pass", "touching-by-convention")
# In order of rank, as fathom certify names them.
VERDICTS = ("crash", "time-out", "silent", "garbage", "failed", "nan", "false-separation", "false-overlap", "not-a-direction", "wrong-sign",
            "too-deep", "too-shallow", "not-separating", "inconsistent", "witness-off", "unsupported", *PASSES)
# The same in few columns.
GROUPS = {"too deep": ("too-deep",), "too shallow": ("too-shallow",), "wrongly apart or overlapping": ("false-separation", "false-overlap"),
          "direction or points wrong": ("not-a-direction", "wrong-sign", "not-separating", "inconsistent", "witness-off"),
          "no answer": ("crash", "time-out", "silent", "garbage", "failed", "nan"), "declined": ("unsupported",)}
CLASSES = ("correctly rounded", "4 ulp", "16 uR", "1e-6", "tolerance")


def family_of(case):
    """The family that an id names, as fathom's own tables group them."""
    found = re.fullmatch(r"(.+?)(?:::.*|-n\d+-s\d+)", case)
    return found.group(1) if found else ""


def read_report(path):
    """(header, outcomes) of a report that is whole."""
    lines = [json.loads(line) for line in path.read_text(encoding="utf-8").splitlines()]
    if not lines or lines[0]["type"] != "header" or lines[-1]["type"] != "summary":
        raise ValueError(f"{path}: expected a whole report")
    outcomes = {}  # a case that was run again counts once
    for line in lines:
        if line["type"] == "case":
            outcomes[line["id"]] = line
    return lines[0], list(outcomes.values())


def counts(values, order):
    """{value: how often}, in the given order, without zeros."""
    found = collections.Counter(values)
    if unknown := set(found) - set(order):
        raise ValueError(f"not expected in a report: {unknown}")
    return {value: found[value] for value in order if found[value]}


def numbers(outcomes, residual):
    """[(that residual, outcome)] of the depths that were answered where it is defined; below 0 for too shallow."""
    judged = [(o["judgement"][residual], o) for o in outcomes if residual in o.get("judgement", {})]
    return [(value, o) for value, o in judged if not isinstance(value, str)]


def worst(errors, verdict, sign):
    """Of the answers with that verdict, the one that is the farthest off on that side."""
    of_verdict = [(sign * error, o["id"]) for error, o in errors if o["verdict"] == verdict]
    if not of_verdict:
        return None
    error, case = max(of_verdict)
    return {"error": sign * error, "case": case}


def tally(outcomes, precision):
    unit = {"binary32": 2.0**-24, "binary64": 2.0**-53}[precision]
    relative = [abs(error) for error, _ in numbers(outcomes, "error_relative")]
    of_side = [(unit * error, o) for error, o in numbers(outcomes, "error_u_r")]
    families = collections.defaultdict(list)
    for outcome in outcomes:
        families[family_of(outcome["id"])].append(outcome["verdict"])
    pairs = collections.defaultdict(set)
    for outcome in outcomes:
        pairs[family_of(outcome["id"])].add(outcome["digest"])
    return {"cases": len(outcomes),
            "different": len(set().union(*pairs.values())),
            "one_pair_families": sorted(family for family, digests in pairs.items() if len(digests) == 1 < len(families[family])),
            "verdicts": counts([o["verdict"] for o in outcomes], VERDICTS),
            "accuracy": counts([o["judgement"]["accuracy"] for o in outcomes if "accuracy" in o.get("judgement", {})], CLASSES),
            "median_relative_error": statistics.median(relative) if relative else None,
            "worst_too_deep": worst(of_side, "too-deep", 1),
            "worst_too_shallow": worst(of_side, "too-shallow", -1),
            "families": {family: counts(verdicts, VERDICTS) for family, verdicts in sorted(families.items())}}


def failures(verdicts):
    return sum(count for verdict, count in verdicts.items() if verdict not in PASSES and verdict != "unsupported")


def table(head, rows):
    def line(cells):
        return "| " + " | ".join(str(cell) for cell in cells) + " |"
    return "\n".join([line(head), line("---" for _ in head), *map(line, rows)]) + "\n"


def number(value):
    return "" if value is None else f"{value:.2g}"


def subjects_table(subjects):
    rows = []
    for subject in subjects:
        hello = subject["hello"]
        settings = "; ".join(f"{key} {value}" for key, value in sorted(hello["settings"].items()))
        rows.append([hello["name"], hello["version"], hello["precision"], settings])
    return table(["subject", "version", "numbers", "settings"], rows)


def short_table(subjects):
    rows = []
    for subject in subjects:
        real, generated = (subject["sets"][name]["verdicts"] for name in SETS)
        passed = [sum(verdicts.get(v, 0) for v in PASSES) for verdicts in (real, generated)]
        rows.append([subject["hello"]["name"], *passed, *(sum(generated.get(v, 0) for v in group) or "" for group in GROUPS.values())])
    totals = [subjects[0]["sets"][name]["cases"] for name in SETS]
    return table(["subject", f"real: pass of {totals[0]}", f"generated: pass of {totals[1]}", *GROUPS], rows)


def verdict_table(subjects, name):
    present = [v for v in VERDICTS if v not in PASSES and any(v in s["sets"][name]["verdicts"] for s in subjects)]
    rows = []
    for subject in subjects:
        found = subject["sets"][name]
        verdicts = found["verdicts"]
        rows.append([subject["hello"]["name"], found["cases"], sum(verdicts.get(v, 0) for v in PASSES), failures(verdicts),
                     *(verdicts.get(v, "") for v in present)])
    return table(["subject", "cases", "pass", "fail", *present], rows)


def error_table(subjects, name):
    rows = []
    for subject in subjects:
        found = subject["sets"][name]
        ends = []
        for key in ("worst_too_deep", "worst_too_shallow"):
            end = found[key]
            ends += [number(end and end["error"]), end["case"] if end else ""]
        rows.append([subject["hello"]["name"], number(found["median_relative_error"]), *ends])
    return table(["subject", "median error", "most too deep", "case", "most too shallow", "case"], rows)


def accuracy_table(subjects, name):
    rows = [[s["hello"]["name"], *(s["sets"][name]["accuracy"].get(c, "") for c in CLASSES)] for s in subjects]
    return table(["subject", *CLASSES], rows)


def family_table(subjects, name):
    """How many fail; of those that a subject declines, in brackets how many."""
    rows = []
    for family in subjects[0]["sets"][name]["families"]:
        cells, cases = [], 0
        for subject in subjects:
            verdicts = subject["sets"][name]["families"].get(family, {})
            cases = max(cases, sum(verdicts.values()))
            declined = verdicts.get("unsupported", 0)
            failed = failures(verdicts)
            cells.append(" ".join([str(failed)] * (failed > 0) + [f"({declined})"] * (declined > 0)))
        rows.append([family, cases, *cells])
    return table(["family", "cases", *(s["hello"]["name"] for s in subjects)], rows)


PAGE = """# What four libraries answer

Made by `verify/survey/survey.sh`, which any machine with the Debian packages can run again; every number here is in `results.json`.
{fathom}; each case had {time_out} s.

Pass: the classification is right, and the depth and all that comes with it within the larger of 1e-3 of the depth and 1e-6 of the bodies'
longer side. A binary32 subject is judged on the binary32 numbers that it sees. One answer has one verdict, the first of its row's that
holds; [VERDICTS.md](../judge/VERDICTS.md) says what each means. `unsupported` is neither pass nor fail: a flat body for a library of faces, or a
coordinate beyond binary32 for a binary32 subject.

## In short

The columns behind the passes are of the generated cases.

{short}
## Subjects

{subjects}
## Real cases

The pairs of tests/data/real_cases.jsonl, from issue trackers and test suites of such libraries: a sample of trouble, not of daily use.

{real}
The median of the errors is relative to the depth, over all depths that were answered for bodies that overlap. The two worst are relative
to the bodies' longer side, of the answers that are too deep or too shallow.

{real_errors}
## Generated cases

    {generated}

All of fathom's families in turn, most of them degenerate or nearly so by intent. {different}

{verdicts}
{errors}
The best class that each passing depth meets (u is the unit roundoff of the subject's numbers, R the longer side):

{accuracy}
### Failing cases by family

In brackets: declined as unsupported.

{families}"""


def page(results):
    subjects = results["subjects"]
    most = max((s["sets"]["generated"] for s in subjects), key=lambda found: found["different"])
    different = f"{most['different']} of the pairs are different in binary64."
    if most["one_pair_families"]:
        different += f"\nNothing is left to chance in {' and '.join(most['one_pair_families'])}: that is one pair each, however often."
    return PAGE.format(fathom=results["fathom"], time_out=results["time_out"], generated=results["generated"],
                       different=different,
                       subjects=subjects_table(subjects), short=short_table(subjects),
                       real=verdict_table(subjects, "real"), real_errors=error_table(subjects, "real"),
                       verdicts=verdict_table(subjects, "generated"), errors=error_table(subjects, "generated"),
                       accuracy=accuracy_table(subjects, "generated"), families=family_table(subjects, "generated"))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("work", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    for option in ("--generated", "--time-out", "--fathom"):
        parser.add_argument(option, required=True)
    parser.add_argument("--adapters", nargs="+", required=True)
    options = parser.parse_args()
    subjects = []
    for adapter in options.adapters:
        subject = {"sets": {}}
        for name in SETS:
            header, outcomes = read_report(options.work / f"{name}.{adapter}.jsonl")
            subject["hello"], tolerance = header["subject"], header["tolerance"]
            subject["sets"][name] = tally(outcomes, header["subject"]["precision"])
        subjects.append(subject)
    results = {"schema": "fathom/survey/1", "fathom": options.fathom, "generated": options.generated, "time_out": options.time_out,
               "tolerance": tolerance, "subjects": subjects}
    (options.out / "results.json").write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")
    (options.out / "RESULTS.md").write_text(page(results), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
