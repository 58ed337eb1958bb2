#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the gallery again: docs/gallery/make.sh. The pages of cases.jsonl, of the comb and the key, and of the meshes go into
# build/gallery, pictures of them stand here. As the launchers do, it installs the Debian packages that it needs: Chromium, Node and npm, as for the tests, and
# pngquant, which makes the pictures small. FATHOM is the program, if it is not to be that of the launcher.
#
# Exit codes: those of the launchers; 1 if a picture could not be made.
set -u
here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
root=$(readlink -f -- "$here/../..") me=make.sh pages=$(readlink -f -- "$here/../..")/build/gallery
. "$root/cmake/launcher.sh"
demand_packages web browser gallery
lock
start_log
install_packages web browser gallery
exec 9>&- # ./fathom takes the lock itself
set -e
fathom=${FATHOM-$root/fathom}
mkdir -p "$pages"
grep -o '"id":"[^"]*"' "$here/cases.jsonl" | cut -d '"' -f 4 | while read -r id; do
  "$fathom" explain "$here/cases.jsonl" --case "$id" -o "$pages/$id.html"
done
"$fathom" explain --pieces "$root/tests/data/key.obj" "$root/tests/data/comb.obj" -o "$pages/comb-and-key.html"
"$fathom" explain --solid --exact-decimals --pose-a 'xyz=6.5,0,0.25 rpy=80,0,0deg' "$here/ring.off" "$here/ring.off" \
  -o "$pages/linked-rings.html"
"$fathom" explain --solid --exact-decimals --pose-a 'xyz=-1.25,1.9,0 rpy=0,0,55deg' "$here/spoon.off" "$here/mug.off" \
  -o "$pages/mug-and-spoon.html"
"$fathom" explain --solid --pose-a xyz=4/3,1,3/2 "$here/sponge.off" "$here/sponge.off" -o "$pages/sponge-in-itself.html"
"$fathom" depth "$here/cases.jsonl" --case sliding-cylinders --along 1,0,0 --steps 96 --svg "$pages/sliding-path.svg" >/dev/null
FATHOM_WORK=$pages FATHOM_DEMAND_BROWSER=1 "$root/tests/browser/node.sh" "$here/shoot.mjs" "$pages" "$here"
pngquant --force --strip --speed 1 --ext .png 64 "$here"/*.png
