#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# try_in_chroot.sh DEBS                        installs the packages of the folder DEBS in a bare Debian, and uses each of them.
# try_in_chroot.sh DEBS --keep TARBALL         writes such a system, without fathom: `podman import` makes a base of it for packaging/Containerfile.
# try_in_chroot.sh --depth [SUITE]             what ./fathom depth builds on a bare Debian SUITE answers as this machine's does, byte for byte;
#                                              the sources of all else are parsed by the compiler of SUITE.
# try_in_chroot.sh --check [SUITE] [ARGUMENTS] the same of the whole program and of the data of L0, and every test, by ./check ARGUMENTS.
#
# SUITE is the name of a release, bookworm or trixie, this machine's unless given. The bare system is made by mmdebstrap from the archives of
# this machine's apt; that needs root, and some minutes. No step may take longer than its limit; whatever ends the script, nothing is left.
set -euo pipefail
root=$(cd "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
usage() {
  sed -n 's/^# \(try_in_chroot.sh .*\)/usage: \1/p' "${BASH_SOURCE[0]}" >&2
  exit 2
}
[[ $# -ge 1 ]] || usage
own=$(. /etc/os-release && echo "$VERSION_CODENAME")
mode=$1 suite=$own debs=''
case $mode in
  --depth | --check)
    shift
    if [[ ${1-} =~ ^[a-z]+$ ]]; then
      suite=$1
      shift
    fi
    ;;
  *)
    [[ -d $mode ]] || usage
    debs=$(cd "$mode" && pwd)
    ;;
esac
mapfile -t archives < <(apt-get indextargets --no-release-info --format 'deb $(REPO_URI) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' |
  sort -u | sed -nE "s/ $own(-updates|-security)? / $suite\1 /p")
mapfile -t proxies < <(env | grep -iE '^[a-z]+_proxy=' || true)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT TERM
chmod 755 "$work"

say() { printf '== %s\n' "$*"; }
limited() { timeout --foreground --kill-after=10 "$@"; }

# bare TARGET OPTIONS...: a folder or tarball with the smallest system. Options are mmdebstrap's, or further archives.
bare() {
  local target=$1
  shift
  limited 20m mmdebstrap --quiet --variant=minbase "$@" "$suite" "$target" "${archives[@]}"
}

# inside FOLDER COMMAND...: runs it there, where /proc is mounted: fathom finds its adapters by it. What it started ends with it.
inside() {
  local target=$work/$1
  shift
  limited "${limit:-30m}" unshare --kill-child --pid --mount --root="$target" --mount-proc \
    env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 "${proxies[@]}" "$@"
}

if [[ ${2-} == --keep ]]; then
  bare "$3"
  exit
fi

# bare_with_sources FOLDER OPTIONS...: the same with our sources in /fathom, and the network as it is here.
bare_with_sources() {
  local target=$work/$1
  shift
  bare "$target" "$@"
  cp -L /etc/resolv.conf /etc/hosts "$target/etc"
  apt-config dump | grep -E '^Acquire::(https?|Retries)' >"$target/etc/apt/apt.conf.d/99as-there" || true
  mkdir "$target/fathom" "$target/data"
  tar -C "$root" --exclude-vcs --exclude=./build -c . | tar -C "$target/fathom" --no-same-owner -x
}

# The catalogues, the real cases and L0 as one stream of cases; and what this machine's fathom answers, with every proof.
ask_here() {
  local target=$work/$1/data catalogue
  for catalogue in '' --shapes --unions; do "$root/fathom" cases $catalogue --catalogue; done >"$target/cases.jsonl"
  zstd -dcq "$root"/tests/data/golden/golden-L0-*.jsonl.zst | cat "$root/tests/data/real_cases.jsonl" - >>"$target/cases.jsonl"
  "$root/fathom" depth --json --embed-certificate - <"$target/cases.jsonl" >"$target/here.jsonl" 2>/dev/null
}

# same_answers FOLDER PROGRAM...
same_answers() {
  local folder=$1 data=$work/$1/data
  shift
  inside "$folder" "$@" depth --json --embed-certificate - <"$data/cases.jsonl" >"$data/there.jsonl" 2>/dev/null
  cmp "$data/here.jsonl" "$data/there.jsonl"
  say "the same bytes: $(wc -l <"$data/there.jsonl") answers with their proofs"
}

# same_l0 FOLDER PROGRAM...: makes L0 there. Contents are compared: what zstd makes of them changes with its version.
same_l0() {
  local folder=$1 name
  shift
  inside "$folder" "$@" golden generate --level L0 --seed 1 --out /data/L0
  for name in "$root"/tests/data/golden/*.zst; do
    cmp <(zstd -dcq "$name") <(zstd -dcq "$work/$folder/data/L0/${name##*/}")
  done
  say "the same bytes: L0"
}

# Each file of the preset release is parsed; Ninja does not ask whether an object was made.
parse_all() {
  printf '#!/bin/sh\nexec "$@" -fsyntax-only\n' >"$work/$1/data/parse"
  chmod +x "$work/$1/data/parse"
  inside "$1" bash -euc 'root=/fathom me=parse && . /fathom/cmake/launcher.sh && start_log && install_packages depth build && cd /fathom
    cmake --preset release -B /data/parsed -DFATHOM_TESTS=OFF -DCMAKE_CXX_COMPILER_LAUNCHER=/data/parse >>"$log"
    ninja -C /data/parsed -t targets all | sed -n "s/^\(.*\.o\): CXX_COMPILER.*/\1/p" >/data/objects
    xargs ninja -C /data/parsed -k 0 -j "$(jobs)" --quiet </data/objects && wc -l </data/objects'
}

if [[ -z $debs ]]; then
  say "$suite: a bare system with the sources"
  bare_with_sources native
  say "$suite: the launcher builds depth"
  inside native /fathom/fathom depth /fathom/tests/data/cube.off /fathom/tests/data/icosahedron.off
  ask_here native
  same_answers native /fathom/fathom
  if [[ $mode == --depth ]]; then
    say "$suite: all sources are parsed"
    parse_all native
  else
    limit=6h
    inside native /fathom/fathom --version
    same_l0 native /fathom/fathom
    inside native /fathom/check "$@"
  fi
  say "all of it works"
  exit
fi

# The packages as an archive of their own, from which apt takes them with all that they need.
mkdir "$work/archive"
cp "$debs"/*.deb "$work/archive"
rm -f "$work"/archive/*-dbgsym_*.deb
(cd "$work/archive" && dpkg-scanpackages . >Packages 2>/dev/null)

# install FOLDER PACKAGES: a bare system with these.
install() {
  local target=$work/$1
  shift
  archives+=("deb [trusted=yes] copy:$work/archive ./") bare "$target" --include="$(IFS=,; echo "$*")"
}

say "fathom: a depth, and its certificate"
install program fathom libccd2
cp "$root/tests/data/cube.off" "$root/tests/data/icosahedron.off" "$work/program/tmp"
inside program fathom depth --certificate /tmp/proof.cert /tmp/cube.off /tmp/icosahedron.off
inside program fathom-check /tmp/proof.cert
inside program sh -c 'fathom cases --family random_ball --count 3 | fathom certify --adapter libccd-mpr -' || (($? == 1)) # some fail

say "libfathom-dev: projects with CMake and with pkg-config, in C++ and in C"
install library libfathom-dev g++ cmake ninja-build pkg-config
mkdir "$work/library/tmp/project"
cp "$root"/packaging/consumer/* "$root/examples/depth.cpp" "$work/library/tmp/project"
inside library sh -ec 'cd /tmp/project
  cmake -G Ninja -S . -B build && cmake --build build && ./build/depth
  g++ -std=c++20 depth.cpp -o depth $(pkg-config --cflags --libs fathom) && ./depth
  g++ -x c -std=c99 version.c -o version $(pkg-config --cflags --libs fathom-c) && ./version'

say "python3-fathom: a depth"
install python python3-fathom
inside python python3 -c 'import fathom; print(fathom.depth(fathom.sphere(1), fathom.sphere("1/2")).depth)'

say "all of it works"
