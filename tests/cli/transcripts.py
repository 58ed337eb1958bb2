#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A transcript says what fathom answers: each command of a console block is run, and prints what is shown.

The commands of a page run in turn in a folder of its own, which holds the files of tests/cli/data and tests/data.
What fathom writes to stderr is marked by "! ", and an exit code other than 0 is shown as [exit 2]; "..." stands for
any text in a line, and alone for any lines. `refused fathom ...` shows of a usual refusal its sentence alone: no
output, exit code 2, one line that begins "fathom: ", and at most the line that names the page of help. Of anything
else it shows all. `told FIELD...` shows fields of lines of JSON (told.py), and cases.sh makes cases. The version of the
program is VERSION.

    transcripts.py PAGE...            the differences, and exit code 1 if there are some
    transcripts.py --write PAGE...    makes the pages show what is printed now: read the change before it is committed
"""
import difflib
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(os.environ["FATHOM_ROOT"])
sys.path.insert(0, str(ROOT / "tests" / "docs"))
from console import rewritten  # noqa: E402

VERSION = os.environ["FATHOM_VERSION"]
PATIENCE = 300  # seconds until a hung process is given up; no test depends on how long anything takes
PROGRAMS = {"fathom": "FATHOM_EXECUTABLE", "fathom-depth": "FATHOM_DEPTH_EXECUTABLE", "fathom-check": "FATHOM_CHECK"}

# Cases, and `told`. A program of fathom: its stderr and its exit code follow what it prints, past pipes and redirections of its stdout.
PRELUDE = f"""
told() {{ "{sys.executable}" -B "$FATHOM_ROOT/tests/cli/told.py" "$@"; }}
. "$FATHOM_ROOT/tests/cli/cases.sh"
""" + r"""
heard() {
  local code=0 line notes=$HEARD.$BASHPID
  command "$@" 2>"$notes" 9>&- || code=$?
  while IFS= read -r line || [ "$line" ]; do printf '! %s\n' "$line"; done <"$notes" >&9
  if ((code)); then echo "[exit $code]" >&9; fi
  return $code
}
refused() {
  local all sentence
  all=$({ "$@"; } 9>&1)
  sentence=$(sed -E '/^! Try: fathom [a-z ]*--help$/d; $d' <<<"$all")
  if [[ $sentence == '! fathom: '* && $sentence != *$'\n'* && $all == *$'\n[exit 2]' ]]; then all=$sentence; fi
  printf '%s\n' "$all"
}
""" + "".join(f'{name}() {{ heard "${variable}" "$@"; }}\n' for name, variable in PROGRAMS.items())


def said(command, folder, notes):
    """What a command prints, and its exit code unless that is 0 or is said already."""
    environment = {**os.environ, "HEARD": str(notes), "COLUMNS": "", "LC_ALL": "C.UTF-8"}
    done = subprocess.run(["bash", "-o", "pipefail", "-c", f"exec 9>&1\n{PRELUDE}\n{command}"], cwd=folder,
                          env=environment, timeout=PATIENCE, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT)
    shown = done.stdout.decode(errors="backslashreplace").replace(f'"fathom":"{VERSION}"', '"fathom":"VERSION"')
    shown = shown.replace(f"fathom {VERSION}", "fathom VERSION")
    lines = shown.removesuffix("\n").split("\n") if shown else []
    code = f"[exit {done.returncode}]"
    return "\n".join(lines + [code] * (done.returncode != 0 and code not in lines))


def now(page):
    """The page as it is, and as it would be."""
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place) / "work"
        folder.mkdir()
        for data in (ROOT / "tests/data", ROOT / "tests/cli/data"):
            for path in data.iterdir():
                (shutil.copy if path.is_file() else shutil.copytree)(path, folder / path.name)
        text = page.read_text(encoding="utf-8")
        return text, rewritten(text, lambda command: said(command, folder, pathlib.Path(place) / "heard"))


def main(words):
    writes = words[:1] == ["--write"]
    differ = False
    for page in map(pathlib.Path, words[writes:]):
        old, new = now(page)
        differ |= old != new
        if writes:
            page.write_text(new, encoding="utf-8")
        lines = difflib.unified_diff(old.splitlines(True), new.splitlines(True), str(page), "what is printed")
        sys.stdout.writelines(lines)
    return differ and not writes


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
