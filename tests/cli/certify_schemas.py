# SPDX-License-Identifier: GPL-3.0-or-later
"""The schemas that `fathom certify` obeys, and validators of their parts."""
import json

import jsonschema  # Debian: python3-jsonschema
from harness import ROOT

CASE, SUBJECT, VERDICT = (json.loads(next(ROOT.glob(f"*/*/{name}.schema.json")).read_text()) for name in ("case", "subject", "verdict"))


def validator(schema, part=None):
    base = "https://schemas.invalid/"  # nothing is fetched
    store = {base + "subject.schema.json": SUBJECT, base + "case.schema.json": CASE}
    part = {**schema, "oneOf": [{"$ref": f"#/$defs/{name}"} for name in part]} if part else schema
    return jsonschema.Draft202012Validator(part, resolver=jsonschema.RefResolver(base, part, store=store))
