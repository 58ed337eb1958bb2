#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# pip_test.sh PROJECT FOLDER: what docs/python.md says of pip, into an environment of its own in FOLDER.
set -eu
project=$1 folder=$2
rm -rf "$folder"
/usr/bin/python3 -m venv --system-site-packages --without-pip "$folder"
cd "$project"
"$folder/bin/python3" -m pip install --no-build-isolation --no-deps --no-index --disable-pip-version-check --root-user-action=ignore ./bindings/python >"$folder/log" 2>&1 ||
  { tail -50 "$folder/log"; exit 1; }
cd "$folder"
found=$("$folder/bin/python3" -c 'import fathom; print(fathom.__file__, fathom.depth(fathom.box((1, 1, 1)), fathom.sphere(1)).depth)')
[[ $found == "$folder"/*/fathom/__init__.py\ 2.0 ]] || { echo "$found"; exit 1; }
rm -rf "$folder"
