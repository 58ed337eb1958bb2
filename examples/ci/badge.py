#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes a badge of a report of `fathom certify`: badge.py REPORT BADGE.svg. It says how many of the judged answers are right.

Exit codes: 0 done; 2 wrong arguments, or a report that is not complete.
"""
import json
import pathlib
import sys

NAME = "penetration depth"
RIGHT, WRONG = "#2b7a3b", "#a33a2a"
HEIGHT, PADDING, PER_LETTER = 20, 6, 6.6  # pixels, of text of 11


def summary_of(path):
    """Returns the last line of a complete report; None of another file."""
    lines = path.read_text(encoding="utf-8").splitlines() if path.is_file() else []
    try:
        last = json.loads(lines[-1])
    except (IndexError, ValueError):
        return None
    return last if isinstance(last, dict) and last.get("type") == "summary" else None


def badge(summary):
    right, judged = summary["passed"], summary["passed"] + summary["failed"]
    texts = (NAME, f"{right} of {judged} right")
    widths = [round(len(text) * PER_LETTER + 2 * PADDING) for text in texts]
    boxes, x = [], 0
    for text, width, colour in zip(texts, widths, ("#444444", RIGHT if right == judged else WRONG)):
        boxes.append(f'<rect x="{x}" width="{width}" height="{HEIGHT}" fill="{colour}"/>'
                     f'<text x="{x + width / 2:g}" y="14" fill="#ffffff" text-anchor="middle">{text}</text>')
        x += width
    label = ": ".join(texts)
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{x}" height="{HEIGHT}" role="img" aria-label="{label}" '
            f'font-family="Verdana, DejaVu Sans, sans-serif" font-size="11"><title>{label}</title>{"".join(boxes)}</svg>\n')


def main(words):
    if len(words) != 2:
        print("badge.py expects a report and the badge to write", file=sys.stderr)
        return 2
    summary = summary_of(pathlib.Path(words[0]))
    if summary is None:
        print(f"badge.py: {words[0]}: expected a report of fathom certify that ends with its summary", file=sys.stderr)
        return 2
    pathlib.Path(words[1]).write_text(badge(summary), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
