#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs a script that drives Chromium: node.sh SCRIPT [ARGUMENTS...]. FATHOM_WORK is a folder of a build, where npm installs what
# package-lock.json names when that has changed. Without Node, npm, Chromium or a registry this skips (exit code 77), except that
# FATHOM_DEMAND_BROWSER=1 makes that a failure.
set -u
here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
skip() {
  echo "skipped: $*" >&2
  if [[ ${FATHOM_DEMAND_BROWSER-} == 1 ]]; then exit 1; fi
  exit 77
}

for command in node npm; do
  command -v "$command" >/dev/null || skip "there is no $command"
done
(($(node --print 'parseInt(process.versions.node)') >= 18)) || skip "Node is older than 18: $(node --version)"
CHROMIUM=$(command -v chromium || command -v chromium-browser || command -v google-chrome) || skip 'there is no chromium'
export CHROMIUM

mkdir -p "$FATHOM_WORK" || exit 1
exec 8>>"$FATHOM_WORK/lock" # tests run at once
flock 8
if ! cmp -s "$here/package-lock.json" "$FATHOM_WORK/installed"; then
  rm -f "$FATHOM_WORK/installed"
  cp "$here/package.json" "$here/package-lock.json" "$FATHOM_WORK" || exit 1
  (cd "$FATHOM_WORK" && npm ci --ignore-scripts --no-audit --no-fund) >"$FATHOM_WORK/npm.log" 2>&1 ||
    skip "npm could not install what tests/browser/package-lock.json names: $(tail -n 5 "$FATHOM_WORK/npm.log")"
  cp "$here/package-lock.json" "$FATHOM_WORK/installed" || exit 1
fi
exec 8>&-
exec node "$@"
