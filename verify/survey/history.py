# SPDX-License-Identifier: GPL-3.0-or-later
"""history.json: how the versions of one engine answered the same cases, each compared with the one before by `fathom certify diff`.

    {"engine": "MuJoCo", "versions": [{"version": "3.3.8", "date": "2025-11-01", "passes": {"real": 53}, "cases": {"real": 63},
     "newly_failing": {"real": ["id"]}, "newly_passing": {"real": ["id"]}}]}, the oldest first; dates may be missing.
"""
import json

from markup import bar, e

MOST_NAMED = 8


def read(path):
    """Returns the value in the file; None if the file is missing."""
    return json.loads(path.read_text(encoding="utf-8")) if path.exists() else None


def named(ids):
    text = ", ".join(e(each.removeprefix("real::")) for each in ids[:MOST_NAMED])
    return text + (f" and {len(ids) - MOST_NAMED} more" if len(ids) > MOST_NAMED else "")


def changes(version, field):
    """Returns the cases of all sets by id."""
    ids = [case for cases in version.get(field, {}).values() for case in cases]
    return f"{len(ids)}: {named(ids)}" if ids else ""


def row(version, sets):
    cells = ""
    for name in sets:
        right, cases = version["passes"].get(name), version["cases"].get(name)
        if right is None:
            cells += "<td></td>"
            continue
        groups = {"right": right, "other wrong": cases - right}
        cells += f'<td class="n">{right} of {cases}{bar(groups, f"{right} of {cases} right")}</td>'
    return (f'<tr><th scope="row">{e(version["version"])} <span class="soft">{e(version.get("date", ""))}</span></th>{cells}'
            f'<td class="text">{changes(version, "newly_failing")}</td><td class="text">{changes(version, "newly_passing")}</td></tr>')


def section(history):
    if not history:
        return ""
    sets = list(dict.fromkeys(name for version in history["versions"] for name in version["passes"]))
    head = "".join(f'<th scope="col">right: {e(name)}</th>' for name in sets)
    rows = "\n".join(row(version, sets) for version in history["versions"])
    return (f'<section><h2>{e(history["engine"])}, version by version</h2>\n<p>Each version answered the same cases; changes are those from '
            'the version before, as <code>fathom certify diff</code> finds them.</p>\n<div class="wide" tabindex="0" role="region" '
            f'aria-label="Versions"><table class="facts history"><thead><tr><th scope="col">version</th>{head}<th scope="col">fails now</th>'
            f'<th scope="col">passes now</th></tr></thead><tbody>{rows}</tbody></table></div></section>\n')
