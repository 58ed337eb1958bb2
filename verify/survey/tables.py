# SPDX-License-Identifier: GPL-3.0-or-later
"""RESULTS.md of results.json."""
import tally

PAGE = """# What they answer

Made by `verify/survey/survey.py` on {date}, by {fathom}; every number is in `results.json`, and `verify/survey/page.py` makes a page of it.

Right: the classification is, and the depth and all that comes with it are within the larger of 1e-3 of the depth and 1e-6 of the bodies'
longer side. A binary32 subject is judged on the binary32 numbers that it sees. Each answer has one verdict, the first in the order of
[VERDICTS.md](../judge/VERDICTS.md) that holds. Declined is neither: a flat body for a library of faces, a coordinate beyond its numbers, \
a shape
that it lacks. Each case had {time_out:g} s.

## Subjects

{subjects}
{sections}"""

SECTION = """## {title}

    {command}

{about} {cases} cases. The median of the errors is relative to the depth, over all depths that were answered for bodies that overlap; the \
two
worst are in parts of the largest coordinate. Times are those of the query alone, as the subject measured it.

{groups}
{errors}"""


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
        settings = "; ".join(f"{key} {value}" for key, value in sorted(hello.get("settings", {}).items()))
        rows.append([subject["adapter"], hello["version"], tally.numbers_text(hello), subject["description"].replace("|", "\\|"), settings])
    return table(["subject", "version", "numbers", "what is asked", "settings"], rows)


def groups_table(results, name):
    used = [g for g in results["groups"] if any(g in s["sets"][name]["groups"] for s in results["subjects"])]
    subsets = [each for each in tally.SUBSETS if any(each in s["sets"][name]["subsets"] for s in results["subjects"])]
    rows = []
    for subject in results["subjects"]:
        found = subject["sets"][name]
        inside = [found["subsets"].get(each, {}) for each in subsets]
        rows.append([subject["adapter"], *(found["groups"].get(group, "") for group in used),
                     *(f"{each.get('right', 0)} of {sum(each.values())}" for each in inside)])
    return table(["subject", *used, *(f"right, {each.replace('_', '-')}" for each in subsets)], rows)


def errors_table(results, name):
    rows = []
    for subject in results["subjects"]:
        found = subject["sets"][name]
        ends = []
        for key in ("most_too_deep", "most_too_shallow"):
            end = found[key]
            ends += [number(end and end["error"]), end["case"] if end else ""]
        times = found["microseconds"] or {}
        rows.append([subject["adapter"], number(found["median_relative_error"]), *ends, number(times.get("median")),
                     number(times.get("worst"))])
    return table(["subject", "median error", "most too deep", "case", "most too shallow", "case", "median us", "worst us"], rows)


def page(results):
    sections = [SECTION.format(**found, groups=groups_table(results, name), errors=errors_table(results, name))
                for name, found in results["sets"].items()]
    return PAGE.format(date=results["date"], fathom=results["fathom"], time_out=results["time_out"],
                       subjects=subjects_table(results["subjects"]), sections="\n".join(sections))
