#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# page.sh OUT FILES...   without a browser, by Node: integers.js computes as zarith does, and the page's worker answers as the program does about
#                        the files. OUT is that of the Makefile, whose page is made first. Without Node this skips (exit code 77), except
#                        that FATHOM_DEMAND_BROWSER=1 makes that a failure.
set -u
here=$(dirname -- "$(readlink -f -- "$0")")
command -v node >/dev/null || { echo "skipped: there is no node" >&2; [ "${FATHOM_DEMAND_BROWSER-}" != 1 ]; exit $((77 - 76 * $?)); }
out=$(readlink -f -- "$1")
shift
make --no-print-directory -C "$here/../.." "OUT=$out" program page || exit 1
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT
cp "$here/integers.ml" "$here/../integers.js" "$scratch"
(
  cd "$scratch" || exit 1
  ocamlfind ocamlopt -package zarith -linkpkg integers.ml -o by_zarith && ocamlfind ocamlc -package zarith -linkpkg integers.ml -o by_bigint &&
    js_of_ocaml --Werror integers.js by_bigint -o by_bigint.js && ./by_zarith >zarith && node by_bigint.js >bigint
) || exit 1
[ "$(wc -l <"$scratch/zarith")" -gt 10000 ] || { echo "too few integers are compared"; exit 1; }
cmp "$scratch/zarith" "$scratch/bigint" || exit 1
exec node "$here/worker.mjs" "$out/fathom-check-proved.html" "$out/fathom-check-proved" "$@"
