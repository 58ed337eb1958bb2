#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# build_debs.sh OUT [--working-tree]    builds the Debian packages of the latest commit into the folder OUT, and puts them to lintian.
#
# With --working-tree what git tracks or would add is taken as it stands. It needs debhelper, dh-python and lintian besides the build
# dependencies in packaging/debian/control, and compiles everything: ten minutes or more on two cores. OUT holds the .changes file too.
set -euo pipefail
root=$(cd "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
[[ $# -ge 1 && $1 != -* ]] || { sed -n 's/^# \(build_debs.sh .*\)/usage: \1/p' "${BASH_SOURCE[0]}" >&2; exit 2; }
mkdir -p "$1"
out=$(cd "$1" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# A copy, since dpkg-buildpackage leaves its files beside the tree. A native source package would hold the build folders too.
mkdir "$work/fathom"
if [[ ${2-} == --working-tree ]]; then
  git -C "$root" ls-files -z --cached --others --exclude-standard | tar -C "$root" --null -T - -c | tar -C "$work/fathom" -x
else
  git -C "$root" archive HEAD | tar -C "$work/fathom" -x
fi
cp -R "$work/fathom/packaging/debian" "$work/fathom/debian"
(cd "$work/fathom" && dpkg-buildpackage --build=binary -us -uc)
lintian --fail-on error,warning --info "$work"/*.changes
cp "$work"/*.deb "$work"/*.changes "$work"/*.buildinfo "$out"
ls "$out"
