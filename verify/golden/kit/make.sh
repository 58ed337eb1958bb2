#!/usr/bin/env bash
# SPDX-License-Identifier: CC0-1.0
# make.sh: makes the sample again, from the golden data in tests/data.
set -euo pipefail
cd "$(dirname "$0")/../../.."
for format in c:h csv:csv json:json rust:rs; do
  ./fathom golden export --format "${format%:*}" --exclude flat,huge,tiny --max-points 8 --count 50 tests/data/golden \
    > "verify/golden/kit/fathom_golden_sample.${format#*:}"
done
