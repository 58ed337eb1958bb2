#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# gaps.sh FOLDER   names every place in a Coq source where something could be taken on trust; exit code 1 if there is one.
#                  (Variables and hypotheses of sections are no gaps: they become premises. assumptions.sh finds what is left.)
#                  And what has to be believed, printed.v, stays short (251 lines of 100 columns; of polytopes 90) and rests on no other file.
words='Admitted|admit|Axiom|Axioms|Parameter|Parameters|Conjecture|Conjectures|give_up|bypass_check|Guard Checking|Positivity Checking'
words="$words|Universe Checking|Extract Constant|Extract Inductive|Extract Inlined Constant"
cd "$1" || exit 1
[ -n "$(find . -name '*.v' | head -n 1)" ] || { echo "no Coq source in $1"; exit 1; }
found=$(find . -path ./build -prune -o -name '*.v' -exec grep -nHwE "$words" {} +)
if [ -f printed.v ]; then
  long=$(awk -v OFS=: 'length > 100 || NR > 251 || /From Fathom/ { print "./printed.v", NR, $0 } /=== 2\./ && NR > 90 { print "./printed.v", NR, $0 }' printed.v)
  found="$found$long"
fi
[ -z "$found" ] && exit 0
printf '%s\n' "$found"
exit 1
