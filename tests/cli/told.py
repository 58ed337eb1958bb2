#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""told FIELD...: of each line of JSON on stdin that has one of them, the values of these fields, as `a.b.0` names them.

`#` is how many there are, and `*` is each of them: `optima.*.translation`. What is not there is `-`. Every line must obey
the schema that it names. For the transcripts."""
import json
import sys

from schemas import check_lines

ABSENT = object()


def at(value, steps):
    for i, step in enumerate(steps):
        if step == "*":
            return [at(each, steps[i + 1:]) for each in value]
        if step == "#":
            value = len(value)
        elif isinstance(value, list):
            value = value[int(step)]
        elif not isinstance(value, dict) or step not in value:
            return ABSENT
        else:
            value = value[step]
    return value


def shown(value):
    if value is ABSENT:
        return "-"
    return value if isinstance(value, str) else json.dumps(value, separators=(",", ":"))


for line in sys.stdin.readlines():  # all of it first: what fathom says besides is then shown before, in every run
    check_lines(line)
    told = [at(json.loads(line), field.split(".")) for field in sys.argv[1:]]
    if any(value is not ABSENT for value in told):
        print(*map(shown, told))
