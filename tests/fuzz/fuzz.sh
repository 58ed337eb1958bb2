#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# fuzz.sh ROOT FOLDER [SECONDS]   builds the fuzz targets of the preset `fuzz` in FOLDER and runs each of them, the certificate checker on
# its committed corpus, the readers of meshes and cases on the files of tests/data; for a quarter of a minute each unless told otherwise.
#
# Exit codes: 0 nothing was found; 77 there is no clang++ with libFuzzer (Debian: clang, libclang-rt-dev); any other, a finding.
set -u
root=$(cd "$1" && pwd) || exit 1
mkdir -p "$2" && cd "$2" || exit 1
folder=$PWD
seconds=${3-15}

probe='extern "C" int LLVMFuzzerTestOneInput(const unsigned char*, unsigned long) { return 0; }'
if ! clang++ -x c++ -fsanitize=fuzzer - -o probe <<<"$probe"; then
  echo "clang++ with libFuzzer is missing (Debian: clang, libclang-rt-dev)"
  exit 77
fi
(cd "$root" && cmake --preset fuzz -B "$folder/build" && cmake --build "$folder/build" --target fuzz -j 2) || exit 1

# The readers take their options from a first byte: each file is given once for each of them.
with_a_first_byte() {
  local into=$1 file byte
  shift
  mkdir -p "$into"
  for file; do
    for byte in {0..13}; do
      { printf "\\x$(printf %x "$byte")" && cat "$file"; } >"$into/$byte-${file##*/}"
    done
  done
}
rm -rf found corpus
with_a_first_byte corpus/mesh "$root"/tests/data/wedge* "$root/examples/data/plate.svg"
mapfile -t cases < <(find "$root/tests/data" -maxdepth 1 -name '*.json*' -size -20k)
with_a_first_byte corpus/cases "${cases[@]}" "$root/examples/shapes.jsonl" "$root/examples/data/plane.jsonl"
mkdir -p corpus/check && cp "$root"/tests/fuzz/corpus/check/* "$root"/tests/data/certificates/format_[2345]/* corpus/check

run() {
  local target=$1 corpus=$2
  mkdir -p "found/$target"
  "build/tests/fuzz/$target" -max_total_time="$seconds" -seed=1 -max_len=4096 -rss_limit_mb=3000 -verbosity=0 -print_final_stats=1 \
    "found/$target" "$corpus" || exit 1
}
run check_fuzz corpus/check
run mesh_fuzz corpus/mesh
run cases_fuzz corpus/cases
