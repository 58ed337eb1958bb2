#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Copies the adapters of engines for the web into a folder and lets npm install their packages there, unless those of this lock file are
# there already. What fails is said in one line that begins with `fathom: `, as the launcher expects.
#
#   install.sh NODE NPM FOLDER [history]    history: with the older versions of engines
set -u
node=$1 npm=$2 to=$3
from=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")

fail() {
  printf 'fathom: %s\n' "$*" >&2
  exit 1
}

# npm tries for over a minute to reach what cannot be reached: one connection tells it in four seconds, to the proxy if there is one.
unreachable() {
  "$node" - "$1" <<'JS'
const set = process.argv[2].split('\n').map((line) => line.slice(line.indexOf('=') + 1));
const ways = [process.env.https_proxy, process.env.HTTPS_PROXY, process.env.http_proxy, process.env.HTTP_PROXY, ...set];
const {hostname, port, protocol} = new URL(ways.find((way) => /^https?:/.test(way)));
const tell = (why) => {
  console.log(`${hostname}: ${why}`);
  process.exit();
};
const socket = require('net').connect({host: hostname.replace(/^\[|\]$/g, ''), port: port || (protocol === 'http:' ? 80 : 443)});
socket.on('connect', () => process.exit());
socket.on('error', (error) => tell(error.code));
setTimeout(() => tell('no answer'), 4000);
JS
}

# Lets npm install what the lock file of a folder names. Without a network it takes what it has kept from before, if that is enough.
install_packages() {
  local lock=$1/package-lock.json there=$1/node_modules/installed way=() set away said
  if cmp -s "$lock" "$there"; then return; fi
  set=$("$npm" config get https-proxy proxy registry cache)
  away=$(unreachable "$set")
  if [[ -n $away ]]; then way=(--offline); fi
  rm -rf "$1/node_modules"
  if [[ -z $away || -d ${set##*cache=}/_cacache ]] &&
    said=$(cd "$1" && "$npm" ci --ignore-scripts --no-audit --no-fund --loglevel=error "${way[@]}" 2>&1); then
    cp "$lock" "$there"
    return
  fi
  rm -rf "$1/node_modules"
  if [[ -n $away ]]; then fail "the engines' packages come by the network, which is not there ($away)"; fi
  printf '%s\n' "$said" >&2
  fail "npm could not install the engines' packages: $(sed -n 's/^npm \(ERR!\|error\) *//p' <<<"$said" | head -n 1)"
}

why='engines for the web need node 18 or later and npm (Debian: nodejs, npm)'
command -v "$node" >/dev/null && command -v "$npm" >/dev/null || fail "$why, which are not here"
version=$("$node" --version)
[[ $version =~ ^v([0-9]+) ]] && ((BASH_REMATCH[1] >= 18)) || fail "$why; $node is $version"
mkdir -p "$to"
# npm needs a HOME that can be written: with another it fails, or reads it all.
if test=$(mktemp -d -p "${HOME-/}" 2>/dev/null); then rmdir "$test"; else export HOME=$to/home && mkdir -p "$HOME"; fi
# A file is there whole or not at all: adapters may be running.
for file in "$from"/*.mjs "$from/package.json" "$from/package-lock.json" "$from/../kit/fathom_subject.mjs"; do
  there=$to/${file##*/}
  cmp -s "$file" "$there" || { cp "$file" "$there.$$" && mv "$there.$$" "$there"; } || fail "cannot write to $to"
done
install_packages "$to"
if [[ ${4-} == history ]]; then
  cp -R "$from/history" "$to"
  install_packages "$to/history"
fi
