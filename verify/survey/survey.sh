#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# verify/survey/survey.sh [--fathom PROGRAM] [--count N] [--work DIR] [--out DIR] [--resume]
#
# Certifies every adapter that is built on the real cases and on N (10000) generated ones, all families in turn with 20 points a body, and writes
# RESULTS.md and results.json to --out (this folder). PROGRAM is the launcher of this project unless given. DIR (build/survey) keeps the cases
# and every verdict; --resume goes on with what is there. Takes some ten minutes on two cores.
#
# Exit codes: 0 done; 2 wrong arguments; 3 something that this script needs failed, and said so.
set -u
here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
root=$(readlink -f -- "$here/../..")
fathom=$root/fathom count=10000 work=$root/build/survey out=$here resume=
size=20 seed=1 time_out=2

die() {
  printf 'survey: %s\n' "$2" >&2
  exit "$1"
}

while (($#)); do
  case $1 in
    --resume) resume=--resume && shift ;;
    --fathom | --count | --work | --out)
      (($# > 1)) || die 2 "$1 expects a value"
      declare "${1#--}=$2" && shift 2
      ;;
    *) die 2 "not expected: $1" ;;
  esac
done

mkdir -p -- "$work" "$out" || die 3 "cannot write to $work"
[[ -n $resume ]] || rm -f -- "$work"/{real,generated}.*
listed=$("$fathom" certify --list-adapters) || die 3 "$fathom certify --list-adapters failed"
mapfile -t adapters < <(grep -v '; not built$' <<<"$listed" | cut -d' ' -f1)
left_out=$(grep '; not built$' <<<"$listed" | cut -d' ' -f1 | paste -sd' ')
[[ -z $left_out ]] || printf 'survey: not there, and left out: %s\n' "$left_out" >&2

generate=(cases --family all --count "$count" --size "$size" --seed "$seed")
"$fathom" "${generate[@]}" >"$work/generated.jsonl" || die 3 "the cases could not be generated"
cp -- "$root/tests/data/real_cases.jsonl" "$work/real.jsonl" || die 3 "the real cases could not be copied"

# A verdict that failed is what we are here for: exit code 1. A case that has no form in the subject's numbers is left out: exit code 2.
for set in real generated; do
  for adapter in "${adapters[@]}"; do
    report=$work/$set.$adapter.jsonl log=$work/$set.$adapter.log
    begin=$SECONDS
    "$fathom" certify --adapter "$adapter" --time-out "$time_out" --report "$report" $resume "$work/$set.jsonl" >"$log" 2>&1
    code=$?
    ((code <= 2)) || die 3 "$adapter on $set ended with $code; see $log"
    printf 'survey: %s on %s: %d s\n' "$adapter" "$set" $((SECONDS - begin)) >&2
  done
done

/usr/bin/env python3 -B "$here/survey.py" "$work" "$out" --generated "fathom ${generate[*]}" --time-out "$time_out" \
  --fathom "$("$fathom" --version)" --adapters "${adapters[@]}" || die 3 "the tables could not be made"
