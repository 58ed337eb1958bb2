#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes every table that tells of the survey, in all pages, from results.json: RESULTS.md, and in other pages what stands between
"<!-- table NAME, by verify/survey/tables.py -->" and "<!-- end of table NAME -->".

Where the commands of a set make other cases today than those that were answered, the table says so. Exit codes: 0 done; 1 with --check, if
a page is older; 2 wrong arguments.
"""
import argparse
import json
import pathlib
import sys
import tempfile
import textwrap

import contacts
import history
import sets
import tally
import world

COLUMNS = 100
PAGE = """# What they answer

Made by `verify/survey/survey.py` and `verify/survey/tables.py`; every number is in `results.json`, and `verify/survey/page.py` makes a
page of it, but for contacts. {made}

Right: the classification is, and the depth and all that comes with it are within the larger of 1e-3 of the depth and 1e-6 of the bodies'
longer side. A binary32 subject is judged on the binary32 numbers that it sees. Each answer has one verdict, the first in the order of
[VERDICTS.md](../judge/VERDICTS.md) that holds. Declined is neither: a flat body for a library of faces, a coordinate beyond its numbers, \
a shape
that it lacks. Each case had {time_out:g} s.

## Subjects

{subjects}
## Real cases, both ways

{legend}

{real}
{best_legend}

{best}
{sections}
{changes}{small_world}{contacts}"""

SECTION = """## {title}

    {command}

{about} {cases} cases. The median of the errors is relative to the depth, over all depths that were answered for bodies that overlap; the \
two
worst are in parts of the largest coordinate. Times are those of the query alone, as the subject measured it.

{groups}
{errors}"""

CHANGES = """## What changed

From each version of a library, or of fathom, to the next, about the same cases. Cases that fail now and did not before are counted one
by one; named are those of which a set has a row, or the families of which more cases fail. What a version answered stays as it was judged
then.

{table}
"""

SMALL_WORLD = """## The small world

    {command}

Every pair of tetrahedra with corners in {{0, 1, 2}}^3, flat ones included, once up to the symmetries of that cube: {pairs} pairs, generated
and not stored. A pair is of one way to meet (`disjoint`, `touching_...`, `contact_...` of its one optimum, `ties`) and of every further
kind that holds. The least failing pair of a kind is the first of those asked, by its number: `fathom cases --small-world N` makes
it. A subject that was asked about a part of the world is counted on that part alone; `verify/survey/world.py` asks on.

{sections}
"""
SMALL_WORLD_SECTION = """### {adapter}

{version}; {settings}. Asked on {date}, by {fathom}: {asked}.

{table}"""

CONTACTS = """## Contacts

Whole manifolds, each contact by itself and all together, as [VERDICTS.md](../judge/VERDICTS.md#contacts) says: a contact is outside \
where no
line along the answer's normal near it meets both bodies, too deep or too shallow where along all of them the bodies overlap less, or more;
together they are to reach as far as the bodies touch after the shortest way out. How many answers have such a finding: with the usual
tolerance, and where positions and depths may be wrong by a thousandth of the longer side. `most`: so many contacts an answer has at most,
as the subject declares; it may then leave out what the best choice of so many leaves out. Answers along a normal that is no shortest way
out are not asked how far they reach. [README.md](README.md#contacts) says what follows from these numbers, and what does not.

{made}

{sections}"""
CONTACTS_SECTION = """### {title}

    {command}

{about} {cases} cases.

{counts}
The first case of each, with the sentence; at a thousandth of the longer side, where there is one:

{firsts}"""

LEGEND = ("`bits`: of the numbers, 32 or 64 (32/64: of points and answers); `settings`: what decides, as by default. `judged`: what the "
          "answers hold besides the status, and are judged by: d the depth, n the direction, p points on both bodies, g the distance of "
          "bodies that are apart; m: a manifold, whose depth is judged as the separating distance of its own normal. Who claims less is asked less: "
          "`depth`, once for hulls and once as reported, counts the answers that are right in status and depth alone, of a manifold as a "
          "shortest translation. In brackets: "
          "declined.")
BEST_LEGEND = ("As by default, and after the comma with the settings of those tried (verify/survey/sets.py has them; each with the bodies "
               "as given, `--fit 1` and `--fit 64`) by which a subject has the most of both sets right. They were picked afterwards, "
               "knowing the cases: a bound for what settings can do, and no fair rate.")


def table(head, rows):
    def line(cells):
        return "| " + " | ".join(str(cell) for cell in cells) + " |"
    return "\n".join([line(head), line("---" for _ in head), *map(line, rows)]) + "\n"


def number(value):
    return "" if value is None else f"{value:.2g}"


def bits(subject):
    points, answers = (text.removeprefix("binary") for text in tally.numbers_of(subject["hello"]))
    return points if points == answers else f"{points}/{answers}"


def settings(subject, most=None):
    """Returns the values of the settings that affect accuracy; the first `most` of them."""
    in_force = subject["hello"].get("settings", {})
    return "; ".join(f"{key} {in_force[key]}" for key in sets.deciding(subject["adapter"])[:most] if key in in_force)


def right(found):
    """Returns "57 (3)": the numbers of right answers and of declined cases."""
    if found is None:
        return ""
    declined = found["groups"].get("declined", 0)
    return f"{found['groups'].get('right', 0)}" + (f" ({declined})" if declined else "")


def judged(subject, name):
    found = subject["sets"].get(name, {}).get("judged", {})
    letters = ["m"] * (subject["hello"]["conventions"].get("claims") == "separating")
    return " ".join(letters + [letter for letter, field in zip("dnpg", ("depth", "direction", "witness", "distance")) if found.get(field)])


def made(results, names, today):
    """Returns the dates of the answers to these sets, and whether the cases have changed since."""
    return dates({name: {subject["adapter"]: found["made"] for subject in results["subjects"] if (found := subject["sets"].get(name))}
                  for name in names}, today)


def dates(answered, today):
    """Returns the same for {set: {subject: made}}, the newest first."""
    of_date, older = {}, [name for name, who in answered.items() if any(each["cases"] != today[name] for each in who.values())]
    for name, subjects in answered.items():
        for subject, each in subjects.items():
            of_date.setdefault((each["date"], each["fathom"]), {}).setdefault(name, []).append(subject)
    parts, told = [], set()
    for (date, fathom), found in sorted(of_date.items(), reverse=True):
        of_subjects = {}
        for name, who in found.items():
            some = ", ".join(who) if len(who) < len(answered[name]) else ""
            if some and name in told and sum(name in other for other in of_date.values()) == 2:
                some = "the others"
            of_subjects.setdefault(some, []).append(name)
            told.add(name)
        named = [", ".join(names) + f" of {some}" if some else "; ".join(names) for some, names in of_subjects.items()]
        parts.append(f"{date}, by {fathom}: {'; '.join(named)}.")
    note = f" The commands make other cases by now than were answered in: {', '.join(older)}." if older else ""
    return "Answered on " + " Answered on ".join(parts) + note


def versions(results):
    found = {}
    for subject in results["subjects"]:
        found.setdefault(f"{subject['adapter'].split('-')[0].removesuffix('64')} {subject['hello']['version']}")
    return "Versions: " + ", ".join(found) + "."


def wrapped(text):
    return textwrap.fill(text, COLUMNS, break_long_words=False, break_on_hyphens=False) + "\n"


def subjects_table(subjects):
    rows = []
    for subject in subjects:
        hello = subject["hello"]
        in_force = "; ".join(f"{key} {value}" for key, value in sorted(hello.get("settings", {}).items()))
        rows.append([subject["adapter"], hello["version"], tally.numbers_text(hello), subject["description"].replace("|", "\\|"), in_force])
    return table(["subject", "version", "numbers", "what is asked", "settings"], rows)


def real_table(results):
    """Returns (head, rows) of the real cases both ways, judged by everything and by status and depth alone, as page.py shows them too."""
    rows = []
    for subject in results["subjects"]:
        both = [subject["sets"].get(name) for name in sets.TRIED_SETS]
        rows.append([subject["adapter"], bits(subject), settings(subject, 1), judged(subject, "real"), *map(right, both),
                     *(found["alone"] if found else "" for found in both)])
    counts = [results["sets"][name]["cases"] for name in sets.TRIED_SETS]
    return ["subject", "bits", "settings", "judged", f"hulls: {counts[0]}", f"as reported: {counts[1]}",
            "depth", "depth"], rows


def tries(subject):
    """Returns {(settings, fit): {set: right}}, the defaults first."""
    return {("", ""): {name: subject["sets"][name]["groups"].get("right", 0) for name in sets.TRIED_SETS if name in subject["sets"]},
            **{(each["settings"], each["fit"]): each["right"] for each in subject["tried"]}}


def best_table(results):
    rows = []
    for subject in results["subjects"]:
        known = tries(subject)
        chosen = max(known, key=lambda each: sum(known[each].values()))  # the first of equal ones
        told = ", ".join(filter(None, [chosen[0], chosen[1] and f"--fit {chosen[1]}"])) or "as by default"
        rows.append([subject["adapter"], bits(subject), settings(subject, 1).replace("_tolerance", "").replace("0.0001", "1e-4"),
                     *(f"{known['', ''].get(name, '')}, {known[chosen].get(name, '')}" for name in sets.TRIED_SETS), told])
    return ["subject", "bits", "settings", "hulls", "as reported", "best settings found"], rows


def fits_table(results):
    rows = []
    for subject in results["subjects"]:
        known = tries(subject)
        rows.append([subject["adapter"], bits(subject), settings(subject),
                     *(known.get(("", fit), {}).get(name, "") for name in sets.TRIED_SETS for fit in sets.FITS)])
    return table(["subject", "bits", "settings", *(f"{title}{fit and f', `--fit {fit}`'}" for title in ("hulls", "as reported")
                                                   for fit in sets.FITS)], rows)


def tried_table(results):
    """Returns a table of all settings that were tried, with bodies in their own size."""
    rows = [[subject["adapter"], bits(subject), given or "as by default", *(counts.get(name, "") for name in sets.TRIED_SETS)]
            for subject in results["subjects"] for (given, fit), counts in tries(subject).items() if not fit]
    return table(["subject", "bits", "settings", "hulls", "as reported"], rows)


def in_one_table(results):
    """Returns the sets without a table of their own."""
    return [name for name in results["sets"] if name not in (*sets.TRIED_SETS, "worst", "plane")]


def of_space(results):
    """Returns the results of the subjects that take bodies of space."""
    return {**results, "subjects": [subject for subject in results["subjects"] if subject["adapter"] not in sets.PLANE]}


def plane_table(results):
    """Returns a table of the engines of the plane, what each family comes to, and what is called."""
    subjects = [subject for subject in results["subjects"] if "plane" in subject["sets"]]
    rows = [["version", *(subject["hello"]["version"] for subject in subjects)],
            ["bits", *map(bits, subjects)], ["judged", *(judged(subject, "plane") for subject in subjects)]]
    for family, cases in results["sets"]["plane"]["rows"].items():
        counts = [subject["sets"]["plane"]["cells"][family]["n"] for subject in subjects]
        asked = [sum(n for verdict, n in count.items() if verdict != "unsupported") for count in counts]
        rows.append([f"{family}: {cases}", *(f"{sum(count.get(verdict, 0) for verdict in tally.PASSES)} of {all_}" if all_ else ""
                                             for count, all_ in zip(counts, asked))])
    for group in results["groups"]:
        rows.append([f"all, {group}", *(subject["sets"]["plane"]["groups"].get(group, "") for subject in subjects)])
    rows.append(["all, right in status and depth", *(subject["sets"]["plane"]["alone"] for subject in subjects)])
    calls = "; ".join(f"{subject['adapter']} `{subject['hello']['settings']['call']}`" for subject in subjects)
    return table(["", *(subject["adapter"] for subject in subjects)], rows) + "\n" + wrapped(f"The calls: {calls}.")


def sets_table(results):
    names = in_one_table(results)
    rows = [[subject["adapter"], bits(subject), settings(subject, 1), *(right(subject["sets"].get(name)) for name in names)]
            for subject in results["subjects"]]
    return table(["subject", "bits", "settings", *(f"{name}: {results['sets'][name]['cases']}" for name in names)], rows)


SHORT = {"spheres": "sphere", "capsules": "capsule", "capsule_box": "with box", "rounded_boxes": "rounded", "cylinders": "cylinder",
         "cones": "cone", "ellipsoids": "ellipsoid"}


def primitives_table(results):
    rows = []
    for subject in results["subjects"]:
        cells = []
        for family in sets.PRIMITIVES:
            counts = subject["sets"].get("primitives", {}).get("cells", {}).get(family, {}).get("n", {})
            asked = sum(count for verdict, count in counts.items() if verdict != "unsupported")
            cells.append(sum(counts.get(verdict, 0) for verdict in tally.PASSES) if asked else "")
        if any(cell != "" for cell in cells):
            rows.append([subject["adapter"], bits(subject), settings(subject, 1), *cells])
    return table(["subject", "bits", "settings", *(SHORT[family] for family in sets.PRIMITIVES)], rows)


def web_table(results):
    """Returns a table of the engines for the web: their functions, their conventions, and their results on the real cases in two sizes."""
    rows = []
    for subject in results["subjects"]:
        hello, known = subject["hello"], tries(subject)
        if "call" not in hello["settings"]:
            continue
        rows.append([subject["adapter"], f"`{hello['settings']['call']}`", bits(subject), settings(subject, 1),
                     {"positive": "+", "negative": "-"}[hello["conventions"]["depth"]], hello["conventions"]["moves"],
                     *(known.get(("", fit), {}).get(name, "") for name in sets.TRIED_SETS for fit in ("", "64"))])
    return table(["adapter", "call", "bits", "settings", "depth", "moves", "hulls", "hulls, fitted", "as reported", "as reported, fitted"],
                 rows)


def length_of(answer):
    """Returns the depth or the distance in words, to six digits as far as it is known."""
    signed = answer["signed_depth"]
    values = list(dict.fromkeys(f"{abs(signed[end]):.6g}" for end in ("low", "high")))
    return "touching" if values == ["0"] else " to ".join(values) + {"penetrating": " deep", "disjoint": " apart"}[answer["status"]]


def worst_table(results):
    """Returns a table of the worst cases: what each shows, its answer, which subjects are wrong about it here, and what its source says."""
    rows, subjects = [], [subject for subject in results["subjects"] if "worst" in subject["sets"]]
    for number_, case in enumerate(results["sets"]["worst"]["rows"]):
        path = sets.ROOT / "verify" / "worst" / f"{case.removeprefix('worst::')}.json"
        file = json.loads(path.read_text(encoding="utf-8"))
        wrong = {}
        for subject in subjects:
            wrong.setdefault(subject["sets"]["worst"]["outcomes"][number_], []).append(subject["adapter"])
        told = [f"*{group}* {', '.join(wrong[letter])}" for group, letter in tally.LETTERS.items()
                if letter in wrong and group not in ("right", "declined")]
        name = file["source"]["name"]
        source = f"[{name}]({file['source']['url']})" if "url" in file["source"] else (
            f"[{name}](../../{name})" if (sets.ROOT / name).exists() else name)
        rows.append([f"[{path.stem}]({path.name})", file["shows"], length_of(file["answer"]), "; ".join(told) or "nobody",
                     ": ".join(filter(None, [source, file.get("stated")]))])
    return table(["case", "what it is", "exact answer", "wrong here", "source, and what it says is wrong"], rows)


def groups_table(results, name):
    subjects = [subject for subject in results["subjects"] if name in subject["sets"]]
    used = [g for g in results["groups"] if any(g in s["sets"][name]["groups"] for s in subjects)]
    subsets = [each for each in tally.SUBSETS if any(each in s["sets"][name]["subsets"] for s in subjects)]
    rows = []
    for subject in subjects:
        found = subject["sets"][name]
        inside = [found["subsets"].get(each, {}) for each in subsets]
        rows.append([subject["adapter"], bits(subject), settings(subject), judged(subject, name),
                     *(found["groups"].get(group, "") for group in used),
                     *(f"{each.get('right', 0)} of {sum(each.values())}" for each in inside)])
    return table(["subject", "bits", "settings", "judged", *used, *(f"right, {each.replace('_', '-')}" for each in subsets)], rows)


def errors_table(results, name):
    rows = []
    for subject in results["subjects"]:
        if name not in subject["sets"]:
            continue
        found = subject["sets"][name]
        ends = []
        for key in ("most_too_deep", "most_too_shallow"):
            end = found[key]
            ends += [number(end and end["error"]), end["case"] if end else ""]
        times = found["microseconds"] or {}
        rows.append([subject["adapter"], bits(subject), settings(subject), number(found["median_relative_error"]), *ends,
                     number(times.get("median")), number(times.get("worst"))])
    return table(["subject", "bits", "settings", "median error", "most too deep", "case", "most too shallow", "case", "median us",
                  "worst us"], rows)


def contacts_page(results, today):
    found = results["contacts"]
    answered = {name: {adapter: subject["made"] for adapter, subject in each["subjects"].items()} for name, each in found.items()}
    return CONTACTS.format(made=dates(answered, today), sections="\n".join(CONTACTS_SECTION.format(
        **each, counts=table(*contacts.rows_of(each)), firsts=table(["subject", "finding", "case", "what is wrong"], contacts.firsts(each)))
        for each in found.values()))


def small_world_page(results):
    found = results.get("small_world")
    if not found:
        return ""
    sections = [SMALL_WORLD_SECTION.format(
        adapter=adapter, version=subject["hello"]["version"], asked="pairs " + world.asked_text(subject, found["pairs"]), **subject["made"],
        settings="; ".join(f"{key} {value}" for key, value in sorted(subject["hello"]["settings"].items())) or "no settings",
        table=table(*world.rows_of(subject))) for adapter, subject in found["subjects"].items()]
    return SMALL_WORLD.format(command=found["command"], pairs=found["pairs"], sections="\n".join(sections))


def changes_page(results):
    rows = history.rows_of(results)
    return CHANGES.format(table=table(history.HEAD, rows)) if rows else ""


def page(results, today):
    sections = [SECTION.format(**found, groups=groups_table(results, name), errors=errors_table(results, name))
                for name, found in results["sets"].items()]
    return PAGE.format(made=made(results, results["sets"], today), time_out=results["time_out"], legend=LEGEND, best_legend=BEST_LEGEND,
                       subjects=subjects_table(results["subjects"]), real=table(*real_table(of_space(results))),
                       best=table(*best_table(of_space(results))), sections="\n".join(sections),
                       changes=changes_page(results), small_world=small_world_page(results), contacts=contacts_page(results, today))


def blocks(results, today):
    """Returns {page: {name of a table: its text}} for pages that are written by hand except for their tables."""
    plane = plane_table(results) + "\n" + wrapped(made(results, ["plane"], today))
    results = of_space(results)
    other = in_one_table(results)
    both = wrapped(made(results, sets.TRIED_SETS, today))
    return {
        "docs/certify.md": {
            "real": wrapped(versions(results)) + "\n" + wrapped(LEGEND) + "\n" + table(*real_table(results)) + "\n" + both,
            "best": wrapped(BEST_LEGEND) + "\n" + table(*best_table(results)),
            "sets": sets_table(results) + "\n" + wrapped(made(results, other, today)),
            "primitives": primitives_table(results) + "\n" + wrapped(made(results, ["primitives"], today))},
        "docs/results.md": {"plane": plane},
        "verify/survey/README.md": {"fits": fits_table(results) + "\n" + both, "tried": tried_table(results)},
        "verify/subjects/web/README.md": {"web": web_table(results) + "\n" + both},
        "verify/worst/README.md": {"worst": worst_table(results) + "\n" + wrapped(made(results, ["worst"], today))}}


def pages(results, today):
    """Returns {path: the text that a page should have}."""
    found = {sets.ROOT / "verify/survey/RESULTS.md": page(results, today)}
    for path, tables_ in blocks(results, today).items():
        text = (sets.ROOT / path).read_text(encoding="utf-8")
        for name, made_ in tables_.items():
            begin, end = f"<!-- table {name}, by verify/survey/tables.py -->\n", f"\n<!-- end of table {name} -->"
            if not (begin in text and end in text.partition(begin)[2]):
                raise ValueError(f"{path}: expected {begin.strip()} and {end.strip()}")
            before, _, rest = text.partition(begin)
            text = before + begin + "\n" + made_ + end + rest.partition(end)[2]
        found[sets.ROOT / path] = text
    return found


def digests(fathom, names):
    """Returns {set: the digest of the cases that its command makes today}."""
    with tempfile.TemporaryDirectory() as folder:
        path, found = pathlib.Path(folder) / "cases.jsonl", {}
        for name in names:
            sets.make(sets.ALL[name], fathom, path)
            found[name] = sets.digest(path)
    return found


def main(words=None):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--fathom", default=str(sets.ROOT / "fathom"), help="the program; this project's launcher unless given")
    parser.add_argument("--check", action="store_true", help="write nothing; name the pages that are older than the results")
    options = parser.parse_args(words)
    results = json.loads(pathlib.Path(__file__).with_name("results.json").read_text(encoding="utf-8"))
    old = [(path, text) for path, text in pages(results, digests(options.fathom, [*results["sets"], *results["contacts"]])).items()
           if text != path.read_text(encoding="utf-8")]
    for path, text in old:
        print(f"tables: {path.relative_to(sets.ROOT)}" + (" is older than the results" if options.check else ""), file=sys.stderr)
        if not options.check:
            path.write_text(text, encoding="utf-8")
    return 1 if options.check and old else 0


if __name__ == "__main__":
    sys.exit(main())
