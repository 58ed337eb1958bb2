#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# assemble.sh PROGRAM.js PAGE.html   puts the program, the scripts and the style of this folder into one page. Its policy allows the script and
#                                    the style that it holds, a worker made of the program, and nothing else.
set -euo pipefail
here=$(dirname -- "$(readlink -f -- "$0")")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

{
  printf 'const program = () => {\n'
  cat "$1"
  printf '\n};\n'
  cat "$here/judge.js"
} >"$work/program"
{
  printf "'use strict';\n"
  cat "$here/words.js" "$here/bodies.js" "$here/picture.js" "$here/page.js"
} >"$work/script"
cp "$here/page.css" "$work/style"
if grep -nE '</script|</style|<!--' "$work/program" "$work/script" "$work/style"; then
  echo "assemble.sh: an element of the page cannot hold that" >&2
  exit 1
fi

digest() { printf "$(sha256sum <"$work/$1" | cut -c 1-64 | sed 's/../\\x&/g')" | base64; }
printf "default-src 'none'; script-src 'sha256-%s'; style-src 'sha256-%s'; worker-src blob:; base-uri 'none'; form-action 'none'" \
  "$(digest script)" "$(digest style)" >"$work/policy"

# each {{name}} once, and none within what is put in
while IFS= read -r line; do
  while [[ $line =~ ^(.*)\{\{([a-z]+)\}\}(.*)$ ]]; do
    printf '%s' "${BASH_REMATCH[1]}"
    cat "$work/${BASH_REMATCH[2]}"
    line=${BASH_REMATCH[3]}
  done
  printf '%s\n' "$line"
done <"$here/page.html" >"$work/page"
mv "$work/page" "$2"
chmod 644 "$2"
