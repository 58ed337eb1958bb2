#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# format.sh PROJECT_ROOT         names the C++ lines that differ from what .clang-format asks for; exits with 1 if there is any.
# format.sh PROJECT_ROOT --fix   rewrites them instead.
set -uo pipefail
cd "$1" || exit 1
mapfile -d '' files < <(find include python/src examples kernels reference verify view cli c cmake tests \( -name '*.hpp' -o -name '*.cpp' \) -print0 | sort -z)
if [[ ${2-} == --fix ]]; then exec clang-format-14 --style=file -i "${files[@]}"; fi

if ! complaints=$(clang-format-14 --style=file --dry-run --Werror "${files[@]}" 2>&1); then
  grep ': error: ' <<<"$complaints" | cut -d: -f1,2 | uniq || printf '%s\n' "$complaints"
  exit 1
fi
