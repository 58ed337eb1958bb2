#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# assumptions.sh OUT   prints one line for each theorem named in assumptions.v: what it rests on beside Coq's logic. OUT holds the compiled
#                      development.
set -eu
here=$(dirname -- "$(readlink -f -- "$0")")
cp "$here/assumptions.v" "$1/assumptions.v"
cd "$1"
coqc -R . Fathom assumptions.v >assumptions.out
sed -n 's/^Print Assumptions \(.*\)\.$/\1/p' assumptions.v >assumptions.names
# each theorem that printed.v names beside a definition is among them
for name in $(grep -oE '\[[A-Za-z0-9_, ;]+\]\.? \*\)' printed.v | tr -d '[],;.*)'); do
  grep -qx "$name" assumptions.names || { echo "printed.v names $name: not in assumptions.v"; exit 1; }
done
# one answer after the other: "Closed under the global context", or "Axioms:" and then a name at the start of each entry
awk '
  /^Axioms:/ { answer[++n] = ""; next }
  /^Closed under/ { answer[++n] = " nothing"; next }
  /^[A-Za-z]/ { answer[n] = answer[n] " " $1; next }
  /^ / { next }
  { print "unexpected: " $0; bad = 1 }
  END {
    while ((getline name < "assumptions.names") > 0) { ++k; print name ":" (k in answer ? answer[k] : " no answer") }
    if (bad || k != n) exit 1
  }' assumptions.out
