# SPDX-License-Identifier: GPL-3.0-or-later
import pathlib

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]


@pytest.fixture(autouse=True)
def in_the_root(monkeypatch):
    """Examples name files of the project by their path from its root."""
    monkeypatch.chdir(ROOT)
