#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# gaps.sh finds every way to leave a gap, and nothing where there is none.
set -u
here=$(dirname -- "$(readlink -f -- "$0")")
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT
bad=0
while read -r line; do
  printf 'Lemma l : True.\n%s\n' "$line" >"$scratch/file.v"
  if "$here/gaps.sh" "$scratch" >"$scratch/out"; then
    echo "not found: $line"
    bad=1
  fi
done <<'LINES'
Admitted.
Proof. admit. Qed.
Proof. give_up. Qed.
Axiom a : False.
Parameter p : nat.
Parameters p q : nat.
Conjecture c : False.
Unset Guard Checking.
#[bypass_check(guard)] Fixpoint f (n : nat) : nat := f n.
Extract Constant check => "fun _ -> true".
Extract Inductive bool => "bool" ["false" "true"].
LINES
printf 'Section S. Variable T : Type. Hypothesis H : True. Lemma axiomatic : True. Proof. exact H. Qed. End S.\n' >"$scratch/file.v"
"$here/gaps.sh" "$scratch" || { echo "found where nothing is"; bad=1; }
# what has to be believed: too long, too wide, too much of polytopes, or resting on another file
cp "$here/printed.v" "$scratch"
"$here/gaps.sh" "$scratch" || { echo "printed.v breaks its law"; bad=1; }
for change in '$a\(* one line more *)' '2s/$/ (* a comment at the end of a line, which makes it wider than it may be *)/' \
  '9,40{p;}; 110,160d' '5s/^/From Fathom Require Import norm. /'; do
  sed "$change" "$here/printed.v" >"$scratch/printed.v"
  ! "$here/gaps.sh" "$scratch" >"$scratch/out" || { echo "not found in printed.v: $change"; bad=1; }
done
exit $bad
