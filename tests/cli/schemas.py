# SPDX-License-Identifier: GPL-3.0-or-later
"""The schemas of what fathom writes, and the check that every line of JSON obeys the one that it names."""
import functools
import json
import os
import pathlib

import jsonschema  # Debian: python3-jsonschema

ROOT = pathlib.Path(os.environ["FATHOM_ROOT"])
FILES = [path for path in sorted(ROOT.glob("*/*/*.schema.json")) if "data" not in path.parts]
SCHEMAS = {path.name: json.loads(path.read_text()) for path in FILES}
NAMES = {f"fathom/{name}": name.split("/")[0] for name in (
    "result/2", "case/1", "ray/1", "growth/1", "metric/1", "impact/1", "solid/1", "robot/1", "study/1", "along/1", "union/1", "diff/1", "stages/1", "union_stages/1", "verdict/1",
    "claim/1")}
# Judged by the tests of golden data.
OTHERS = {f"fathom/{name}" for name in (
    "golden/1", "golden-shapes/1", "golden-unions/1", "golden-shard/1", "golden-dataset/1", "golden-agreement/2", "golden-export/1")}
PREFIX = "https://schemas.invalid/"  # nothing is fetched


@functools.cache
def validator(name):
    schema = SCHEMAS[f"{name}.schema.json"]
    store = {where + file: each for where in (PREFIX, "") for file, each in SCHEMAS.items()}
    return jsonschema.Draft202012Validator(schema, resolver=jsonschema.RefResolver(PREFIX, schema, store=store))


def check_lines(text):
    """Each line that is an object with a schema of ours."""
    for line in text.splitlines():
        if line.startswith('{"schema":"fathom/'):
            value = json.loads(line)
            if value["schema"] not in OTHERS:
                validator(NAMES[value["schema"]]).validate(value)  # KeyError: no schema has this name
