#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# check_fuzz.sh ROOT FOLDER [SECONDS]   builds the checker's fuzz target in FOLDER and runs it on the committed corpus, for a minute unless
# told otherwise. Only the checker is compiled: it builds alone, in seconds.
#
# Exit codes: 0 nothing was found; 77 there is no clang++ with libFuzzer (Debian: clang, libclang-rt-14-dev); any other, a finding.
set -u
root=$(cd "$1" && pwd) || exit 1
mkdir -p "$2" && cd "$2" || exit 1
seconds=${3-60}

sources=("$root"/verify/check/*.cpp)
flags=(-std=c++17 -O1 -g -fsanitize=address,undefined,fuzzer -fno-sanitize-recover=all -I"$root")
probe='extern "C" int LLVMFuzzerTestOneInput(const unsigned char*, unsigned long) { return 0; }'
if ! clang++ -x c++ -fsanitize=fuzzer - -o probe <<<"$probe"; then
  echo "clang++ with libFuzzer is missing (Debian: clang, libclang-rt-14-dev)"
  exit 77
fi
mapfile -t library < <(printf '%s\n' "${sources[@]}" | grep -v '/main\.cpp$')
clang++ "${flags[@]}" "$root/tests/fuzz/check_fuzz.cpp" "${library[@]}" -lgmpxx -lgmp -o check_fuzz || exit 1
rm -rf found && mkdir found
./check_fuzz -max_total_time="$seconds" -seed=1 -max_len=4096 -rss_limit_mb=3000 -verbosity=0 -print_final_stats=1 \
  found "$root/tests/fuzz/corpus/check"
