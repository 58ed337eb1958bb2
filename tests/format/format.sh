#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# format.sh PROJECT_ROOT         names the lines of C++ and C that differ from what .clang-format asks for; exits with 1 if there is any.
# format.sh PROJECT_ROOT --fix   rewrites them instead.
#
# Exit code 77: there is no clang-format-14 (Debian 12 has it); other versions break lines in other places.
set -uo pipefail
cd "$1" || exit 1
if ! command -v clang-format-14 >/dev/null; then
  echo "clang-format-14 is missing (Debian 12 has it)"
  exit 77
fi
mapfile -d '' files < <(find include bindings examples kernels reference verify view cli cmake tests \( -name '*.hpp' -o -name '*.cpp' -o -name '*.c' \) -print0 | sort -z)
if [[ ${2-} == --fix ]]; then exec clang-format-14 --style=file -i "${files[@]}"; fi

if ! complaints=$(clang-format-14 --style=file --dry-run --Werror "${files[@]}" 2>&1); then
  grep ': error: ' <<<"$complaints" | cut -d: -f1,2 | uniq || printf '%s\n' "$complaints"
  exit 1
fi
