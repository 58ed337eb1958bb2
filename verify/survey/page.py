#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the pages of the survey from results.json: index.html, which works without scripts and network, and a page for each failing cell.

The cases are generated again and drawn by fathom. Exit codes: 0 done; 2 wrong arguments.
"""
import argparse
import json
import pathlib
import re
import sys

import cell_pages
import history
import sets
import tables
import tally
import world
from markup import FAILING, GROUP_CLASS, bar, document, e, file_name, key, time_text, told

HERE = pathlib.Path(__file__).resolve().parent
SUBSET_NAMES = {"solid": "solid bodies", "metre_sized": "metre-sized bodies"}
STEPS = (.1, .3, .6)  # shares of failing cases at which a cell becomes darker


def filters(results):
    """Returns the choice of a set, and of a part of it; style rules alone apply it."""
    def choices(group, legend, options):
        labels = "".join(f'<label><input type="radio" name="{group}" id="{group}-{value}"{" checked" * (not i)}>{e(text)}</label>'
                         for i, (value, text) in enumerate(options.items()))
        return f"<fieldset><legend>{legend}</legend>{labels}</fieldset>"
    text = choices("set", "cases", {name: found["title"] for name, found in results["sets"].items()})
    if present := subsets(results):
        text += choices("part", "of", {"all": "all bodies", **{name: SUBSET_NAMES[name] for name in present}})
    return f'<form class="filter">{text}</form>\n'


def subsets(results):
    return [name for name in tally.SUBSETS if any(name in found["subsets"] for s in results["subjects"] for found in s["sets"].values())]


def filter_style(results):
    """Returns style rules that hide what is not chosen, in browsers with :has; others show everything."""
    rules = [f'body:has(#set-{name}:checked) section.set:not(#of-{name})' for name in results["sets"]]
    rules += [f"body:has(#part-{name}:checked) .part:not(.of-{name})" for name in ("all", *subsets(results))] * bool(subsets(results))
    return "@media screen { " + ", ".join(rules) + " { display: none; } }\n"


def engine_of(subject):
    return subject["adapter"].split("-")[0].rstrip("64")


def bars(results, name, part):
    rows, before = [], None
    for subject in results["subjects"]:
        found = subject["sets"].get(name)
        if found is None:
            continue
        groups = found["groups"] if part == "all" else found["subsets"].get(part, {})
        label = f"{subject['adapter']}: " + ", ".join(f"{count} {group}" for group, count in groups.items())
        times = found["microseconds"] if part == "all" else None
        cells = "".join(f'<td data-l="{group}">{"<b>" * (group == "right")}{groups.get(group, "")}{"</b>" * (group == "right")}</td>'
                        for group in GROUP_CLASS)
        cells += f'<td data-l="median us">{time_text(times["median"]) if times else ""}</td>'
        first = ' class="first"' if engine_of(subject) != before else ""
        before = engine_of(subject)
        rows.append(f'<tr{first}><th scope="row"><a href="#s-{subject["adapter"]}">{subject["adapter"]}</a> '
                    f'<span class="soft">{e(told(subject))}</span></th><td class="bar">{bar(groups, label)}</td>{cells}</tr>')
    head = "".join(f'<th scope="col">{group}</th>' for group in GROUP_CLASS)
    return (f'<div class="part of-{part}"><table class="bars"><thead><tr><th scope="col">subject</th><th scope="col"><span class="soft">'
            f'{"all cases" if part == "all" else SUBSET_NAMES[part]}</span></th>{head}<th scope="col">median us</th></tr></thead>\n<tbody>'
            + "\n".join(rows) + "</tbody></table></div>\n")


def map_cell(results, name, row, subject):
    """Returns the number of the row's failing cases, or for a single case a letter for its verdict."""
    found = subject["sets"].get(name, {"cells": {}})["cells"].get(row, {"n": {}})
    counts = {}
    for verdict, count in found["n"].items():
        counts[tally.group_of(verdict)] = counts.get(tally.group_of(verdict), 0) + count
    total, failing = sum(counts.values()), sum(counts.get(group, 0) for group in FAILING)
    if not failing:
        return '<td class="d">·</td>' if counts.get("declined", 0) == total else "<td></td>"
    if results["sets"][name]["by_case"]:
        group = next(group for group in FAILING if group in counts)
        style, text = GROUP_CLASS[group].replace("g", "k"), tally.LETTERS[group]
    else:
        style, text = f"s{1 + sum(failing / total > least for least in STEPS)}", failing
    said = f"{subject['adapter']} on {row}: {failing} of {total} fail; worst: {found['worst'][2]}"
    link = f"cells/{name}/{file_name(row)}.html#{subject['adapter']}"
    return f'<td class="{style}"><a href="{link}" title="{e(said)}">{text}</a></td>'


def dates(results, name):
    return ", ".join(sorted({s["sets"][name]["made"]["date"] for s in results["subjects"] if name in s["sets"]}))


def result_map(results, name):
    found, asked = results["sets"][name], [s for s in results["subjects"] if name in s["sets"]]
    head = "".join(f'<th scope="col"><a href="#s-{s["adapter"]}">{s["adapter"]}</a></th>' for s in asked)
    rows = []
    for row, count in found["rows"].items():
        cells = "".join(map_cell(results, name, row, subject) for subject in asked)
        if "<a " in cells:
            shown = row.removeprefix("real::")
            rows.append(f'<tr><th scope="row">{e(shown)}</th>{"" if found["by_case"] else f"<td class=count>{count}</td>"}{cells}</tr>')
    left = len(found["rows"]) - len(rows)
    what, each = ("case", "D: too deep, S: too shallow, X: wrong status, W: otherwise wrong, N: no answer, a dot: declined") if found[
        "by_case"] else ("family", "How many cases fail; the darker, the larger their share; a dot: all declined")
    plural = {"case": "cases", "family": "families"}[what]
    return (f'<h3>By {what}</h3><p class="small soft">{each}. Each leads to the worst case, '
            f"its picture, proof, and commands that show it.{f' {left} {plural} that nobody fails are left out.' if left else ''}</p>\n"
            f'<div class="wide" tabindex="0" role="region" aria-label="{e(found["title"])} by {what}"><table class="map"><thead><tr>'
            f'<th scope="col">{what}</th>{"" if found["by_case"] else "<th scope=col>cases</th>"}{head}</tr></thead>\n<tbody>'
            + "\n".join(rows) + "</tbody></table></div>\n")


def section(results, name):
    found = results["sets"][name]
    parts = "".join(bars(results, name, part) for part in ("all", *subsets(results)))
    return (f'<section class="set" id="of-{name}"><h2>{e(found["title"])}</h2>\n<p>{e(found["about"])} {found["cases"]} cases, '
            f'answered {e(dates(results, name))}: <code>{e(found["command"])}</code></p>\n{key()}{parts}{result_map(results, name)}'
            "</section>\n")


def both_ways(results):
    """Returns the real cases as hulls and as in their reports, by what was judged and by the best settings found, as in RESULTS.md."""
    text = "<section><h2>Real cases, both ways</h2>\n"
    for legend, (head, rows) in ((tables.LEGEND, tables.real_table(tables.of_space(results))),
                                  (tables.BEST_LEGEND, tables.best_table(tables.of_space(results)))):
        cells = "\n".join(f'<tr><th scope="row">{e(row[0])}</th>{"".join(f"<td>{e(cell)}</td>" for cell in row[1:])}</tr>' for row in rows)
        text += (f'<p class="small soft">{e(legend).replace("`", "")}</p>\n<div class="wide" tabindex="0" role="region" aria-label="Both ways">'
                 f'<table class="facts"><thead><tr>{"".join(f"""<th scope="col">{e(cell)}</th>""" for cell in head)}</tr></thead><tbody>'
                 f"{cells}</tbody></table></div>\n")
    return text + "</section>\n"


def small_world(results):
    """Returns the tables of the small world, one for each subject that was asked about it, folded."""
    found = results.get("small_world")
    if not found:
        return ""
    parts = []
    for adapter, subject in found["subjects"].items():
        head, rows = world.rows_of(subject)
        cells = "\n".join(f'<tr><th scope="row">{e(row[0])}</th>{"".join(f"<td>{e(cell)}</td>" for cell in row[1:])}</tr>' for row in rows)
        parts.append(f'<details><summary>{e(adapter)} <span class="soft">{e(subject["hello"]["version"])}, pairs '
                     f'{e(world.asked_text(subject, found["pairs"]))}, asked {e(subject["made"]["date"])}</span></summary>\n'
                     f'<div class="wide" tabindex="0" role="region" aria-label="The small world, {e(adapter)}"><table class="facts"><thead><tr>'
                     f'{"".join(f"""<th scope="col">{e(cell)}</th>""" for cell in head)}</tr></thead><tbody>{cells}</tbody></table></div>'
                     "</details>\n")
    return (f'<section><h2>The small world</h2>\n<p>Every pair of tetrahedra with corners in {{0, 1, 2}}³, once up to symmetry: '
            f'{found["pairs"]} pairs, <code>{e(found["command"])}</code>. Each subject is counted on the pairs that it was asked about; the '
            f'least failing pair has the number N of <code>fathom cases --small-world N</code>.</p>\n{"".join(parts)}</section>\n')


def subject_cards(results):
    cards = []
    for subject in results["subjects"]:
        hello = subject["hello"]
        settings = "".join(f"<dt>{e(name)}</dt><dd>{e(value)}</dd>" for name, value in sorted(hello.get("settings", {}).items()))
        shapes = ", ".join(hello.get("capabilities", {}).get("shapes", [])) or "none"
        cards.append(f'<article id="s-{subject["adapter"]}"><h3>{subject["adapter"]} <span class="soft">{e(hello["version"])}</span></h3>\n'
                     f'<p class="small">{e(subject["description"])}</p><dl><dt>numbers</dt><dd>{tally.numbers_text(hello)}</dd><dt>shapes</dt>'
                     f"<dd>{e(shapes)}</dd>{settings}</dl></article>")
    return '<section><h2>Subjects</h2>\n<p>Versions and settings are what each says of itself, as by default.</p>\n' \
        f'<div class="subjects">{"".join(cards)}</div></section>\n'


def index(results):
    questions = sum(found["cases"] for subject in results["subjects"] for found in subject["sets"].values())
    tolerance = results["tolerance"]
    head = (f"<header><h1>Collision libraries, judged exactly</h1>\n<p>{len(results['subjects'])} ways to ask for a penetration depth, "
            f"{questions} answers, each compared with the exact truth, which comes with a proof.</p>\n<p class=\"soft small\">Right: the bodies overlap or not as said, and depth, direction and points are "
            f"within the larger of {tolerance['relative']} of the depth and {tolerance['absolute']} of the longer side; a binary32 subject is "
            "judged on the numbers that it sees. The families are made to find errors: they say where a method breaks, not how often a user "
            "meets it. A contact manifold claims to separate the bodies, and is judged by that. Declined is neither right nor wrong.</p>"
            "</header>\n")
    both = both_ways(results) if all(name in results["sets"] for name in sets.TRIED_SETS) else ""
    body = head + filters(results) + "<main>\n" + both + "".join(section(results, name) for name in results["sets"])
    body += small_world(results) + history.section(results) + subject_cards(results) + "</main>\n"
    body += ('<footer><p class="soft small">Times are medians of the query alone in microseconds, as each subject measured it, hulls made '
             "before. How it is made: <code>verify/survey</code> of fathom.</p></footer>\n")
    return document("Collision libraries, judged exactly", body, filter_style(results))


def main(words=None):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--fathom", default=str(sets.ROOT / "fathom"), help="the program; this project's launcher unless given")
    parser.add_argument("--results", type=pathlib.Path, default=HERE / "results.json")
    parser.add_argument("--out", type=pathlib.Path, default=sets.ROOT / "build" / "survey" / "page")
    options = parser.parse_args(words)
    results = json.loads(options.results.read_text(encoding="utf-8"))
    if not re.fullmatch(r"fathom/survey/3", results.get("schema", "")):
        parser.error(f"{options.results}: expected the schema fathom/survey/3")
    options.out.mkdir(parents=True, exist_ok=True)
    (options.out / "index.html").write_text(index(results), encoding="utf-8")
    made = cell_pages.write(results, options.fathom, options.out)
    print(f"page: {options.out / 'index.html'}, and {made} pages of cells", file=sys.stderr)
    return 0


if __name__ == "__main__":
    sys.exit(main())
