# SPDX-License-Identifier: GPL-3.0-or-later
"""What is refused, and how it is said: refusals.jsonl has a row for each wrong command line, whose words follow `fathom`.

It is asked in a folder of its own, which holds links to what is in tests/data, and the files of the row. It must end with
exit code 2 (or that of the row), print nothing, and say the row's sentence, and behind it at most which page of help to
read; and all files stay as they were. `refusals_test.py --write` makes the sentences again."""
import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import unittest

from harness import DATA, EXECUTABLE, PATIENCE, ROOT

TABLE = pathlib.Path(__file__).with_name("refusals.jsonl")


def asked(row):
    """The row, as it would be now."""
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place)
        for path in DATA.iterdir():
            (folder / path.name).symlink_to(path)
        files = row.get("files", {})
        for name, content in files.items():
            (folder / name).unlink(missing_ok=True)
            (folder / name).write_text(content)
        there = set(folder.rglob("*"))
        words = [word.replace("ROOT", str(ROOT)) for word in shlex.split(row["ask"])]
        done = subprocess.run([EXECUTABLE, *words], input=row.get("stdin", "").encode(), cwd=folder, capture_output=True,
                              timeout=PATIENCE, env={**os.environ, "COLUMNS": ""})
        assert set(folder.rglob("*")) == there, f"{row['ask']}: files were made, or are gone"
        assert all((folder / name).read_text() == content for name, content in files.items()), f"{row['ask']}: it wrote"
        assert done.stdout == b"", f"{row['ask']}: {done.stdout}"
    says = done.stderr.decode().replace(place, "PLACE").replace(str(ROOT), "ROOT")
    says = re.sub(r"Try: fathom [a-z ]*--help\n\Z", "", says)
    now = {**row, "says": says.removesuffix("\n")}
    if done.returncode != 2:
        now["code"] = done.returncode
    return now


def rows():
    return [json.loads(line) for line in TABLE.read_text().splitlines()]


def all_asked():
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        return list(pool.map(asked, rows()))


class Refusals(unittest.TestCase):
    maxDiff = None

    def test_every_row(self):
        for row, now in zip(rows(), all_asked(), strict=True):
            with self.subTest(row["ask"]):
                self.assertEqual(now, row)
                self.assertTrue(now["says"].startswith("fathom: "), now)


if __name__ == "__main__":
    if sys.argv[1:] == ["--write"]:
        TABLE.write_text("".join(json.dumps(row) + "\n" for row in all_asked()))
    else:
        unittest.main()
