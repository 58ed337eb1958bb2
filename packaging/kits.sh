#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# kits.sh OUT FATHOM...    makes the packages of the kits in the folder OUT: fathom-subject-VERSION.tgz and fathom-golden-VERSION.tgz by npm pack,
#                          fathom_golden-VERSION-py3-none-any.whl by pip wheel. The command FATHOM makes the sample of golden cases.
set -euo pipefail
root=$(cd "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
if [[ $# -lt 2 || $1 == -* ]]; then
  sed -n 's/^# \(kits.sh .*\)/usage: \1/p' "${BASH_SOURCE[0]}" >&2
  exit 2
fi
mkdir -p "$1"
out=$(cd "$1" && pwd)
shift
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
version=$(sed -n 's/^project(fathom VERSION \([^ ]*\).*/\1/p' "$root/CMakeLists.txt")

# stage NAME LICENCE FILE...: what a package is made of, in $work/NAME.
stage() {
  local name=$1 licence=$2 file
  shift 2
  mkdir "$work/$name"
  cp "$@" "$work/$name"
  cp "$root/LICENSES/$licence.txt" "$work/$name/LICENSE"
  for file in "$root/packaging/kits/$name"/*; do
    sed "s/@VERSION@/$version/" "$file" >"$work/$name/${file##*/}"
  done
}

kit=$root/verify/subjects/kit golden=$root/verify/golden/kit
stage fathom-subject Apache-2.0 "$kit/fathom_subject.mjs" "$kit/example.mjs"
"$golden/make.sh" "$work/sample" "$@"
stage fathom-golden CC0-1.0 "$golden/fathom_golden.mjs" "$work/sample/fathom_golden_sample.json"
mkdir "$work/fathom-golden/fathom_golden"
cp "$golden/fathom_golden.py" "$work/fathom-golden/fathom_golden/__init__.py"
cp "$work/sample/fathom_golden_sample.json" "$work/fathom-golden/fathom_golden"
(cd "$out" && npm pack --silent "$work/fathom-subject" "$work/fathom-golden")
/usr/bin/python3 -m pip -q wheel --no-build-isolation --no-deps --no-index -w "$out" "$work/fathom-golden"
