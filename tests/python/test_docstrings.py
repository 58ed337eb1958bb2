# SPDX-License-Identifier: GPL-3.0-or-later
"""Every example of every docstring, and the stubs name what is there."""
import ast
import doctest
import importlib
import pathlib
import pkgutil

import pytest

import fathom
from fathom import _fathom

ROOT = pathlib.Path(__file__).resolve().parents[2]
MODULES = ["fathom", *(f"fathom.{module.name}" for module in pkgutil.iter_modules(fathom.__path__) if module.name != "_fathom")]


@pytest.mark.parametrize("name", MODULES)
def test_examples(name):
    found = doctest.testmod(importlib.import_module(name), raise_on_error=False)
    assert found.failed == 0


def test_the_page():
    found = doctest.testfile(str(ROOT / "docs" / "python.md"), module_relative=False, encoding="utf-8")
    assert found.attempted > 10 and found.failed == 0


def test_there_are_examples():
    finder = doctest.DocTestFinder(exclude_empty=True)
    with_examples = {test.name.rsplit(".", 1)[-1] for name in MODULES for test in finder.find(importlib.import_module(name))
                     if test.examples}
    assert {"depth", "distance", "depths", "ray", "growth", "width", "metric", "approx", "study", "judge", "check", "cases", "golden",
            "union", "union_depth", "read_pieces", "derivative"} <= with_examples


def test_public_names_have_docstrings():
    for name in fathom.__all__:
        thing = getattr(fathom, name)
        assert isinstance(thing, str) or thing.__doc__, name


def names_of(text):
    """Classes with their members, and functions, of a stub."""
    found = set()
    for node in ast.parse(text).body:
        if isinstance(node, ast.FunctionDef):
            found.add(node.name)
        if isinstance(node, ast.ClassDef):
            found.add(node.name)
            for member in node.body:
                field = member.target.id if isinstance(member, ast.AnnAssign) else getattr(member, "name", None)
                found.add(f"{node.name}.{field}")
    return found


def test_the_stub_is_about_this_module():
    stub = names_of((pathlib.Path(fathom.__file__).parent / "_fathom.pyi").read_text(encoding="utf-8"))
    real = set()
    for name, thing in vars(_fathom).items():
        if name.startswith("_") or isinstance(thing, str):
            continue
        real.add(name)
        if isinstance(thing, type):
            real |= {f"{name}.{member}" for member in vars(thing) if not member.startswith("_")
                     or member in ("__add__", "__iter__", "__next__")}
    assert {name for name in stub if not name.endswith(".__init__")} == real
