#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the gallery again: docs/gallery/make.sh. The pages of cases.jsonl go into build/gallery, pictures of them stand here. Needs Chromium,
# Node and npm, as the tests do, and pngquant, which makes the pictures small.
set -eu
here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
root=$here/../.. pages=$here/../../build/gallery
fathom=${FATHOM-$root/fathom}
command -v pngquant >/dev/null || {
  echo 'make.sh: pngquant is missing; as root, run: apt-get install -y pngquant' >&2
  exit 2
}
mkdir -p "$pages"
grep -o '"id":"[^"]*"' "$here/cases.jsonl" | cut -d '"' -f 4 | while read -r id; do
  "$fathom" explain "$here/cases.jsonl" --case "$id" -o "$pages/$id.html"
done
"$fathom" depth "$here/cases.jsonl" --case sliding-cylinders --along 1,0,0 --steps 96 --svg "$pages/sliding-path.svg" >/dev/null
FATHOM_WORK=$pages FATHOM_DEMAND_BROWSER=1 "$root/tests/browser/node.sh" "$here/shoot.mjs" "$pages" "$here"
pngquant --force --strip --speed 1 --ext .png 64 "$here"/*.png
