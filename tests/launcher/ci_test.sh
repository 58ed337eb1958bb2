#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Tries .ci/run and packaging/try_in_chroot.sh where everything else is a stand-in: ci_test.sh PROJECT_ROOT
# Each `law` names what the next steps show; the first broken one ends the test.
set -u
project=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
law='' talk=''

broken() {
  printf 'broken law: %s\n%s\nstderr was: %s\n' "$law" "$1" "$talk" >&2
  exit 1
}

# expect CODE COMMAND...   what it says on stderr is kept in $talk
expect() {
  local code=$1 status
  shift
  "$@" >"$work/out" 2>"$work/talk"
  status=$?
  talk=$(<"$work/talk")
  [[ $status == "$code" ]] || broken "exit code $status instead of $code"
}

# stand_in FILE LINES...   a program of these lines
stand_in() {
  local file=$1
  shift
  mkdir -p "${file%/*}"
  printf '%s\n' '#!/bin/bash' "$@" >"$file"
  chmod +x "$file"
}

tree=$work/tree
mkdir -p "$tree/.ci" "$tree/packaging"
cp "$project/.ci/run" "$tree/.ci"
stand_in "$tree/check" 'echo "check $*" >>"$STEPS"; exit "${CHECK-0}"'
stand_in "$tree/packaging/try_in_chroot.sh" 'echo "try $*" >>"$STEPS"; exit "${TRIED-0}"'
export STEPS=$work/steps
steps() { [[ $(<"$STEPS") == "$1" ]] || broken "the steps were: $(<"$STEPS")"; }

law='every test, the quick ones of rooms that compute under sanitizers, and depth on Debian 13 as the last step'
expect 0 "$tree/.ci/run"
grep -q -- '--room kernels --room polytope .*--room check --room c --room plane$' "$STEPS" || broken "the steps were: $(<"$STEPS")"
sed -i 's/ --room [a-z_]*//g' "$STEPS"
steps $'check \ncheck --preset asan-ubsan --quick\ntry --depth trixie'
[[ -z $talk ]] || broken 'stderr should be empty'

law='a machine that can make no bare system says so in one line, and goes on'
TRIED=3 expect 0 "$tree/.ci/run"
[[ $talk == '.ci/run: Debian 13 was not tried: no bare system of it can be made here' ]] || broken 'no such line'

law='whatever else fails is a failure'
TRIED=1 expect 1 "$tree/.ci/run"
TRIED=2 expect 2 "$tree/.ci/run"
CHECK=3 expect 3 "$tree/.ci/run"

law='the nightly script begins with the proofs, made with the Coq of Debian 13, and the static archives'
mkdir -p "$tree/tests/nightly"
cp "$project/tests/nightly/nightly.sh" "$tree/tests/nightly"
for program in fathom fathom-two-ways; do stand_in "$tree/build/release/$program" "echo $program >>\"\$STEPS\""; done
: >"$STEPS"
expect 0 "$tree/tests/nightly/nightly.sh"
archives=$tree/build/nightly/archives
steps $'check --room nightly\ntry --proofs trixie\n'"try --static $archives"$'\n'"try --static $archives --arm64"$'\nfathom\nfathom\nfathom-two-ways'
TRIED=3 expect 0 "$tree/tests/nightly/nightly.sh"
[[ $talk == 'nightly: the proofs were not tried with the Coq of Debian 13: no bare system of it can be made here'* ]] ||
  broken 'no such line'
TRIED=1 expect 3 "$tree/tests/nightly/nightly.sh"

law='a warning of clang is an error under sanitizers'
python3 - "$project/CMakePresets.json" <<'PYTHON' || broken 'it is none'
import json, sys
presets = {preset["name"]: preset["cacheVariables"] for preset in json.load(open(sys.argv[1]))["configurePresets"]}
sanitized = presets["asan-ubsan"]
sys.exit((sanitized["CMAKE_CXX_COMPILER"], sanitized.get("CMAKE_COMPILE_WARNING_AS_ERROR")) != ("clang++", "ON"))
PYTHON

if ((!EUID)); then
  law='3 means that no bare system can be made; a launcher that ends with 3 there has failed, and what it compiled is kept'
  mkdir -p "$tree/cmake" "$tree/tests/data"
  cp "$project/packaging/try_in_chroot.sh" "$tree/packaging"
  stand_in "$tree/cmake/launcher.sh" 'lock() { :; }; start_log() { :; }; install_packages() { :; }'
  stand_in "$work/bin/apt-get" 'exit 0'
  stand_in "$work/bin/apt-config" 'exit 0'
  stand_in "$work/bin/mmdebstrap" 'for last; do [[ $last == "$HOME"* || $last != /* ]] || target=$last; done
    (( ${BARE-0} )) && exit "$BARE"; mkdir -p "$target/etc/apt/apt.conf.d" "$target/ccache"; echo kept >"$target/ccache/object"'
  stand_in "$work/bin/unshare" '[[ $* != *--root=* ]] || exit "${INSIDE-0}"; exit "${MOUNT-0}"'
  try() {
    expect "$1" env PATH="$work/bin:$PATH" HOME="$work" XDG_CACHE_HOME="$work/cache" "${@:2}" \
      "$tree/packaging/try_in_chroot.sh" "${mode---depth}" trixie
  }
  try 3 MOUNT=1
  try 3 BARE=1
  [[ $talk == *'mmdebstrap could not make a bare trixie'* ]] || broken 'no such sentence'
  try 1 INSIDE=3
  try 2 INSIDE=2
  [[ -f $work/cache/fathom/ccache-trixie/object ]] || broken 'nothing was kept'
  mode=--proofs try 0
  mode=--proofs try 1 INSIDE=1
fi
echo 'every law holds'
