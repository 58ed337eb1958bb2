# SPDX-License-Identifier: GPL-3.0-or-later
"""The common parts of the survey's pages: each is one file with one style, no script, and a policy that allows no loading."""
import base64
import hashlib
import html
import pathlib
import re

import sets
import tally

GROUP_CLASS = {"right": "g0", "too deep": "g1", "too shallow": "g2", "wrong status": "g3", "other wrong": "g4", "no answer": "g5",
               "declined": "g6"}
FAILING = ("too deep", "too shallow", "wrong status", "other wrong", "no answer")


def e(text):
    return html.escape(str(text))


def file_name(key):
    """Returns the name of a cell's page; different keys have different names."""
    return re.sub(r"[^\w.-]", lambda found: f"%{ord(found[0]):02X}", key).replace("%", "_") or "none"


def told(subject):
    """Returns the text of a row after the subject's name: its version, its numbers, and the settings that affect accuracy."""
    hello = subject["hello"]
    decides = [f"{key} {hello['settings'][key]}" for key in sets.deciding(subject["adapter"]) if key in hello.get("settings", {})]
    return ", ".join([hello["version"], tally.numbers_text(hello), *decides[:1]])


def document(title, body, more_style=""):
    style = pathlib.Path(__file__).with_name("page.css").read_text(encoding="utf-8") + more_style
    digest = base64.b64encode(hashlib.sha256(style.encode()).digest()).decode()
    policy = f"default-src 'none'; style-src 'sha256-{digest}'; img-src data:; base-uri 'none'; form-action 'none'"
    return (f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><meta http-equiv="Content-Security-Policy" content="{policy}">'
            f'<meta name="viewport" content="width=device-width, initial-scale=1"><title>{e(title)}</title><style>{style}</style></head>\n'
            f"<body>\n{body}</body></html>\n")


def bar(groups, label):
    """Returns a bar of all groups that are not empty, as wide as the cell."""
    total, before, rects = sum(groups.values()), 0, []
    for group, css in GROUP_CLASS.items():
        if count := groups.get(group, 0):
            x, width = (f"{100 * part / total:.3f}%" for part in (before, count))
            rects.append(f'<rect class="{css}" x="{x}" width="{width}" height="100%"><title>{count} {group}</title></rect>')
            before += count
    return f'<svg role="img" aria-label="{e(label)}">{"".join(rects)}</svg>'


def key():
    return ('<ul class="key">' + "".join(f'<li><i class="{css}"></i>{group}</li>' for group, css in GROUP_CLASS.items()) + "</ul>\n")


def time_text(microseconds):
    return f"{microseconds:.3g}" if microseconds < 100 else f"{microseconds:.0f}"
