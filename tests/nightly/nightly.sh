#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# tests/nightly/nightly.sh [--until 10min | --cases N] [--seed N] [--from K] [--level L1] [--work DIR] [--built DIR]
#
# Computes everything in two ways that share nothing, and compares every field: the golden data of L1, made and verified by the exact method
# too; then a random stream of cases of all families for 10 minutes, or as long as one likes. Every fifth case is one of unions, whose second
# way are pairs of pieces, convex wholes and a naive search. The seed is printed; --seed and --from go on with a stream, and golden data that
# is there already is not made again. The first difference is made small and kept as DIR/differences/difference.case.json; DIR is
# build/nightly unless given. Builds what it needs, makes the proofs with the Coq of Debian 13 too, and the static archives for x86-64 and
# arm64 in DIR/archives, unless --built names a folder with the programs.
#
# Exit codes: 0 all agree; 1 a difference, and what was printed says where; 2 wrong arguments; 3 something that this script needs failed.
set -u
here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
root=$(readlink -f -- "$here/../..")
level=L1 work=$root/build/nightly built='' stream=() limit=(--until 10min)

die() {
  printf 'nightly: %s\n' "$2" >&2
  exit "$1"
}

while (($#)); do
  case $1 in
    -h | --help)
      sed -n '3,12s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
      exit 0
      ;;
    --level | --work | --built | --seed | --from | --until | --cases) (($# > 1)) || die 2 "$1 expects a value" ;;&
    --level | --work | --built) declare "${1#--}=$2" ;;
    --seed | --from) stream+=("$1" "$2") ;;
    --until | --cases) limit=("$1" "$2") ;;
    *) die 2 "not expected: $1" ;;
  esac
  shift 2
done

if [[ -z $built ]]; then
  "$root/check" --room nightly || die 3 "the programs could not be built, or their own test failed"
  built=$root/build/release
  "$root/packaging/try_in_chroot.sh" --proofs trixie
  case $? in
    0) ;;
    2 | 3) echo 'nightly: the proofs were not tried with the Coq of Debian 13: no bare system of it can be made here' >&2 ;;
    *) die 3 'the proofs fail with the Coq of Debian 13' ;;
  esac
  for architecture in '' --arm64; do
    "$root/packaging/try_in_chroot.sh" --static "$work/archives" $architecture
    case $? in
      0) ;;
      2 | 3) echo 'nightly: no static archive was tried: no bare system can be made here' >&2 ;;
      *) die 3 'a static archive cannot be made, or does not answer as fathom does' ;;
    esac
  done
fi
two_ways=$built/fathom-two-ways
[[ -x $two_ways ]] || two_ways=$built/tests/nightly/fathom-two-ways
mkdir -p -- "$work" || die 3 "cannot write to $work"

difference=0
"$built/fathom" golden generate --level "$level" --seed 1 --out "$work/golden-$level" || die 3 "the golden data could not be made"
"$built/fathom" golden verify --method exact "$work/golden-$level"
case $? in
  0) ;;
  1) difference=1 ;;
  *) die 3 "the golden data could not be verified" ;;
esac
"$two_ways" "${stream[@]}" "${limit[@]}" --keep "$work/differences"
case $? in
  0) ;;
  1) difference=1 ;;
  2) exit 2 ;;
  *) die 3 "the stream ended early" ;;
esac
exit "$difference"
