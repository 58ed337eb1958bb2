#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs the tests of the page's modules by Node's own test runner; nothing is installed. Without a Node of version 18 or later this skips
# (exit code 77), except that FATHOM_DEMAND_BROWSER=1 makes that a failure.
set -u
here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
skip() {
  echo "skipped: $*" >&2
  if [[ ${FATHOM_DEMAND_BROWSER-} == 1 ]]; then exit 1; fi
  exit 77
}
command -v node >/dev/null || skip 'there is no node'
(($(node --print 'parseInt(process.versions.node)') >= 18)) || skip "Node is older than 18: $(node --version)"
exec node --test "$here"/*.test.mjs
