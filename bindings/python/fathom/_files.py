# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of cases, and golden data."""
from __future__ import annotations

import difflib
import itertools
import json
import os
from fractions import Fraction
from typing import Any, Iterator, NamedTuple

from fathom import _fathom
from fathom._fathom import Body


class Case(NamedTuple):
    """Two bodies with a name."""

    id: str
    a: Body
    b: Body


def cases(path: str | os.PathLike[str]) -> Iterator[Case]:
    """Reads a file of cases, one after another: JSON Lines, or one case as a document (reference/files/case.schema.json).

    A body may be a union of convex pieces, which `union_depth` takes: then its `pieces` are not None. A case that cannot be read raises
    ValueError with file and line when its turn comes; who goes on with `next` gets the one behind it.

    >>> import fathom
    >>> [(case.id, fathom.depth(case.a, case.b).status) for case in fathom.cases("examples/shapes.jsonl")][0]
    ('pill', 'penetrating')
    """
    return itertools.starmap(Case, _fathom.Cases(os.fspath(path)))


def family(name: str, *, count: int = 1, seed: int = 1, size: int | None = None) -> Iterator[Case]:
    """Makes cases of a family, as `fathom cases --family NAME --count COUNT --seed SEED --size SIZE` prints them, the same on all machines.

    `fathom cases --list`, with --shapes or --unions, says what the families are. Case number i has the seed `seed + i`.

    size  about how many points each body has, where the family has a choice; of unions, pieces

    >>> import fathom
    >>> [case.id for case in fathom.family("capsules", count=2, seed=7)]
    ['capsules-n8-s7', 'capsules-n8-s8']
    """
    names = _fathom.family_names()
    if name not in names:
        near = ", ".join(difflib.get_close_matches(name, names)) or "none"
        raise ValueError(f"expected the name of a family, found {name!r} (nearest: {near})")
    return (Case(*_fathom.family_case(name, seed + i, size)) for i in range(count))


class Record(NamedTuple):
    """A golden record: a case with its exact answer (verify/golden/NOTES.md)."""

    id: str
    a: Body
    b: Body
    status: str
    depth_squared: Fraction | None  #: None where it may be irrational
    flags: list[str]  #: what is special about polytopes: "flat_a", "huge_coordinates", ...; of others none
    fields: dict[str, Any]  #: the whole record, as it is written


def golden(path: str | os.PathLike[str]) -> Iterator[Record]:
    """Reads a shard of golden data, a file .jsonl.zst, or all shards of a folder: of polytopes, shapes, unions or of the plane.

    A record that is none raises ValueError when its turn comes; who goes on with `next` gets the one behind it.

    >>> import fathom
    >>> sum(record.status == "touching" for record in fathom.golden("tests/data/golden")) > 50
    True
    """
    path = os.fspath(path)
    files = [path]
    if os.path.isdir(path):
        files = sorted(os.path.join(path, name) for name in os.listdir(path) if name.endswith(".jsonl.zst"))
        if not files:
            raise ValueError(f"{path}: expected files .jsonl.zst, found none")
    return itertools.starmap(_record, itertools.chain.from_iterable(map(_lines, files)))  # a bad record does not end the iteration


def _lines(file: str) -> Iterator[tuple[str, str, int]]:
    try:
        for number, line in enumerate(_fathom.ZstdLines(file), 1):
            yield line, file, number
    except ValueError as fault:
        raise ValueError(f"{file}: {fault}") from None


def _record(line: str, file: str, number: int) -> Record:
    case = Case(*_fathom.parse_case(line, file, number))
    fields = json.loads(line)
    if "expected" not in fields:
        raise ValueError(f"{file}:{number}: expected a golden record, found a case without 'expected'")
    squared = fields["expected"].get("depth", {}).get("squared")
    return Record(case.id, case.a, case.b, fields["expected"]["status"], None if squared is None else Fraction(squared),
                  fields.get("flags", []), fields)
