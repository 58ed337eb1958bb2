#!/usr/bin/env bash
# SPDX-License-Identifier: CC0-1.0
# make.sh FOLDER [FATHOM]: makes the sample in this folder, from the golden data in tests/data, by this program or by the launcher.
set -euo pipefail
tree=$(cd "$(dirname "$0")/../../.." && pwd)
mkdir -p "$1"
for format in c:h csv:csv json:json rust:rs; do
  "${2:-$tree/fathom}" golden export --format "${format%:*}" --exclude flat,huge,tiny --max-points 8 --count 50 \
    "$tree/tests/data/golden" > "$1/unfinished"
  mv "$1/unfinished" "$1/fathom_golden_sample.${format#*:}"
done
