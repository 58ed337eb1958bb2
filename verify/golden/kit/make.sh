#!/usr/bin/env bash
# SPDX-License-Identifier: CC0-1.0
# make.sh FOLDER [FATHOM...]: makes the sample in this folder, from the golden data in tests/data, by this command or by the launcher.
set -euo pipefail
tree=$(cd "$(dirname "$0")/../../.." && pwd)
folder=$1
shift
(($#)) || set -- "$tree/fathom"
mkdir -p "$folder"
for format in c:h csv:csv json:json rust:rs; do
  "$@" golden export --format "${format%:*}" --exclude flat,huge,tiny --max-points 8 --count 50 \
    "$tree/tests/data/golden" > "$folder/unfinished"
  mv "$folder/unfinished" "$folder/fathom_golden_sample.${format#*:}"
done
