#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# gaps.sh FOLDER   names every place in a Coq source where something could be taken on trust; exit code 1 if there is one.
#                  (Variables and hypotheses of sections are no gaps: they become premises. assumptions.sh finds what is left.)
words='Admitted|admit|Axiom|Axioms|Parameter|Parameters|Conjecture|Conjectures|give_up|bypass_check|Guard Checking|Positivity Checking'
words="$words|Universe Checking|Extract Constant|Extract Inductive|Extract Inlined Constant"
cd "$1" || exit 1
[ -n "$(find . -name '*.v' | head -n 1)" ] || { echo "no Coq source in $1"; exit 1; }
found=$(find . -path ./build -prune -o -name '*.v' -exec grep -nHwE "$words" {} +)
[ -z "$found" ] && exit 0
printf '%s\n' "$found"
exit 1
