# SPDX-License-Identifier: GPL-3.0-or-later
"""The rows of tests/data/judged.jsonl by `fathom.judge`: findings and fields are those of tests/doors/judged_test.cpp."""
import json
import math
import pathlib
from fractions import Fraction

import fathom

ROWS = pathlib.Path("tests/data/judged.jsonl")
WORDS = {"depth": "sign"}  # of a declaration, where Python has another word


def number(value):
    return None if value is None else float(value)


def reply_of(reply):
    point = lambda p: None if p is None else tuple(map(float, p))
    witness = tuple(point(reply["witness"].get(body)) for body in "ab") if "witness" in reply else None
    contacts = [(point(each["position"]), number(each.get("depth"))) for each in reply.get("contacts", [])]
    return {"overlap": reply["overlap"], "depth": number(reply.get("depth")), "distance": number(reply.get("distance")),
            "direction": point(reply.get("direction")), "witness": witness, "contacts": contacts}


def written(value):
    """As a report has it."""
    if isinstance(value, dict):
        return {name: written(each) for name, each in value.items()}
    return list(value) if isinstance(value, tuple) else str(value) if isinstance(value, Fraction) or value == math.inf else value


def test_every_row(tmp_path):
    pairs, judged = {}, 0
    for line in ROWS.read_text().splitlines():
        row = json.loads(line)
        if "pair" in row:
            (tmp_path / "pair.jsonl").write_text(line + "\n")
            [pairs[row["pair"]]] = fathom.cases(tmp_path / "pair.jsonl")
            continue
        by, reply = dict(row.get("by", {})), row["reply"]
        if by.pop("ulps", 0) or len(reply.get("witness", "ab")) < 2:  # which Python's judge has not
            continue
        declared = {WORDS.get(name, name): value for name, value in row.get("declared", {}).items()}
        if "manifold" in declared:
            declared["manifold"] = (declared["manifold"].get("most"), 0)
        pair = pairs[row["of"]]
        found = fathom.judge(pair.a, pair.b, **reply_of(reply), **declared, **by)
        assert found.findings == row["found"], line
        for name, value in row.get("told", {}).items():
            assert written(getattr(found, name)) == value, (name, line)
        judged += 1
    assert judged > 250
