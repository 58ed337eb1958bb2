# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a page for each family, or case, on which a subject fails: the subjects and their verdicts, and of each the worst case with its
picture, its proof, and commands that show it again."""
import base64
import json
import pathlib
import re
import subprocess
import tempfile

import sets
from markup import document, e, file_name, told


def output_name(case, ending):
    """Returns the name of fathom's file about a case."""
    name = "".join(c if re.match(r"[A-Za-z0-9._-]", c) else "".join(f"%{byte:02X}" for byte in c.encode()) for c in case)
    return ("%2E" + name[1:] if name.startswith(".") else name) + ending


def drawn(cases, fathom, folder):
    """Returns {case: (result, picture, certificate)} for lines of cases, computed by fathom."""
    stream = folder / "cases.jsonl"
    stream.write_text("".join(line + "\n" for line in cases.values()), encoding="utf-8")
    done = subprocess.run([fathom, "depth", "--json", "--svg", folder / "svg", "--certificate", folder / "cert", stream],
                          stdout=subprocess.PIPE, check=False)
    results = {result["id"]: result for result in map(json.loads, done.stdout.decode().splitlines()) if "id" in result}

    def text(kind, case):
        path = folder / kind / output_name(case, "." + kind)
        return path.read_text(encoding="utf-8") if path.exists() else ""
    return {case: (results.get(case, {}), text("svg", case), text("cert", case)) for case in cases}


def truth(result):
    """Returns fathom's answer in one line."""
    if "status" not in result:
        return ""
    depth = result.get("depth", {}).get("value") if isinstance(result.get("depth"), dict) else None
    return result["status"] + (f", depth {depth}" if depth and result["status"] == "penetrating" else "")


def is_of_plane(line):
    return json.loads(line).get("dimension") == 2


def reproducer(line, adapters):
    commands = [f"fathom certify --adapter {adapter} --html {adapter}.html --certificates proofs case.jsonl" for adapter in adapters]
    commands.append(f"fathom certify --adapter {adapters[0]} --shrink small case.jsonl")
    return "\n".join(["cat > case.jsonl <<'END'", line, "END", "fathom depth --svg pictures --certificate proofs case.jsonl", *commands])


def case_article(case, line, what, failing, certificate):
    result, picture, _ = what
    image = ""
    if picture:
        data = base64.b64encode(picture.encode()).decode()
        seen = "in the plane" if is_of_plane(line) else "across the shortest way out"
        image = f'<img alt="{e(case)}: both bodies {seen}" src="data:image/svg+xml;base64,{data}">'
    items = "".join(f"<li><b>{adapter}</b> <code>{verdict}</code>: {e(said)}</li>" for adapter, verdict, said in failing)
    proof = f'<p><a href="{certificate}">The certificate</a>, for <code>fathom check</code>.</p>' if certificate else ""
    return (f'<article id="c-{file_name(case)}"><h3>{e(case)}</h3>\n<div class="beside"><div>{image}</div><div><p>fathom: {e(truth(result))}.</p>'
            f"{proof}<ul>{items}</ul>\n<details><summary>Show it again</summary><pre tabindex=\"0\">"
            f"{e(reproducer(line, [adapter for adapter, _, _ in failing]))}</pre></details></div></div></article>\n")


def table(name, row, results):
    rows = []
    for subject in results["subjects"]:
        found = subject["sets"].get(name, {"cells": {}})["cells"].get(row)
        if not found:
            continue
        worst = found.get("worst")
        counts = ", ".join(f"{count} {verdict}" for verdict, count in sorted(found["n"].items(), key=lambda each: -each[1]))
        case = f'<a href="#c-{file_name(worst[0])}">{e(worst[0])}</a>' if worst else ""
        rows.append(f'<tr id="{subject["adapter"]}"><th scope="row"><a href="../../index.html#s-{subject["adapter"]}">{subject["adapter"]}</a> '
                    f'<span class="soft">{e(told(subject))}</span></th><td class="text">{counts}</td><td class="text">{case}</td></tr>')
    return ('<div class="wide" tabindex="0" role="region" aria-label="Subjects"><table class="facts"><thead><tr><th scope="col">subject</th>'
            '<th scope="col">verdicts</th><th scope="col">worst case</th></tr></thead><tbody>' + "\n".join(rows) +
            "</tbody></table></div>\n")


def worst_cases(name, row, results):
    """Returns {case: [(adapter, verdict, sentence)]} in the order of the subjects."""
    found = {}
    for subject in results["subjects"]:
        if worst := subject["sets"].get(name, {"cells": {}})["cells"].get(row, {}).get("worst"):
            found.setdefault(worst[0], []).append((subject["adapter"], worst[2], worst[3]))
    return found


def write(results, fathom, out):
    """Writes cells/SET/ROW.html and the certificates beside; returns how many pages. Cases that the commands no longer make are left
    out."""
    made = 0
    for name, found in results["sets"].items():
        folder = out / "cells" / name
        folder.mkdir(parents=True, exist_ok=True)
        failing = {row: cases for row in found["rows"] if (cases := worst_cases(name, row, results))}
        with tempfile.TemporaryDirectory() as work:
            stream = pathlib.Path(work) / "set.jsonl"
            stream.write_bytes(cases_of(found, fathom))
            lines = sets.read_cases(stream)
            wanted = {case: lines[case] for cases in failing.values() for case in cases if case in lines}
            pictures = drawn(wanted, fathom, pathlib.Path(work))
        for row, cases in failing.items():
            (folder / f"{file_name(row)}.html").write_text(page(name, row, results, cases, wanted, pictures, folder), encoding="utf-8")
            made += 1
    return made


def cases_of(found, fathom):
    """Returns the output of the set's command."""
    program = f'fathom() {{ "{fathom}" "$@"; }}; '
    return subprocess.run(["bash", "-c", program + found["command"]], cwd=sets.ROOT, stdout=subprocess.PIPE, check=True).stdout


def page(name, row, results, cases, lines, pictures, folder):
    found, articles = results["sets"][name], []
    for case, failing in cases.items():
        if case not in lines:
            continue
        certificate = ""
        if pictures[case][2]:
            certificate = file_name(case) + ".cert"
            (folder / certificate).write_text(pictures[case][2], encoding="utf-8")
        articles.append(case_article(case, lines[case], pictures[case], failing, certificate))
    body = (f'<header><p class="small"><a href="../../index.html">Collision libraries, judged exactly</a></p><h1>{e(row or name)}</h1>\n'
            f'<p class="soft">{e(found["title"])}: {found["rows"][row]} of {found["cases"]} cases. '
            f'<code>{e(found["command"])}</code></p></header>\n<main>{table(name, row, results)}<h2>The worst cases</h2>\n'
            '<p class="soft small">Pictures and certificates are of the numbers as given; a binary32 subject is judged on the rounded ones, '
            "of which <code>certify --certificates</code> writes the proof.</p>\n" + "".join(articles) + "</main>\n")
    return document(f"{row or name}: {found['title']}", body)
