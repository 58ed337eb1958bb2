# SPDX-License-Identifier: GPL-3.0-or-later
"""Ten thousand broken files of scenes: each is answered or refused, and none crashes fathom. In the preset asan-ubsan under ASan."""
import os
import unittest

os.environ.setdefault("FATHOM_MUTANTS", "10000")

from scenes_test import Scenes  # noqa: E402: it reads the number

if __name__ == "__main__":
    unittest.main(argv=["scene_mutants_test", "Scenes.test_mutants_crash_nothing"])
