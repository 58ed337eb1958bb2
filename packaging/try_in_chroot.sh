#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# try_in_chroot.sh DEBS                        installs the packages of the folder DEBS in a bare Debian, and uses each of them.
# try_in_chroot.sh DEBS --keep TARBALL         writes such a system, without fathom: `podman import` makes a base of it for packaging/Containerfile.
# try_in_chroot.sh --depth [SUITE]             what ./fathom depth builds on a bare Debian SUITE answers as this machine's does, byte for byte.
# try_in_chroot.sh --parse [SUITE]             the compilers of SUITE, g++ and clang, parse all sources but tests; a warning is an error.
# try_in_chroot.sh --check [SUITE] [ARGUMENTS] --depth of the whole program, the data of L0, and every test, by ./check ARGUMENTS.
# try_in_chroot.sh --proofs [SUITE]            the Coq and the OCaml of SUITE prove proofs/coq, build the proved checker, and make its tests.
# try_in_chroot.sh --arm64 [SUITE]             cross-builds fathom-depth, fathom-check and the library for C for arm64; under qemu they answer,
#                                              prove, check the proofs of L0, and run the examples in C.
# try_in_chroot.sh --archive FILE              in an empty root, without libc and /proc, the programs of an archive of static.sh answer as this
#                                              machine's do, certify a subject, and check; those for arm64 under qemu.
# try_in_chroot.sh --static OUT [--arm64]      a bare system makes such an archive in the folder OUT, for arm64 by cross-compiling; then the same.
#
# SUITE is the name of a release, bookworm or trixie, this machine's unless given. The bare system is made by mmdebstrap from the archives of
# this machine's apt; that needs root, their network, and some minutes. What compilers made for a SUITE is kept in ~/.cache/fathom for the
# next time. No step may take longer than its limit; whatever ends the script, nothing else is left.
#
# Exit codes: 0 all works; 2 usage, or not root; 3 no bare system can be made; others are of the step that failed.
set -euo pipefail
root=$(cd "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
usage() {
  sed -n 's/^# \(try_in_chroot.sh .*\)/usage: \1/p' "${BASH_SOURCE[0]}" >&2
  exit 2
}
say() { printf '== %s\n' "$*"; }
die() {
  local code=$1
  shift
  printf 'try_in_chroot.sh: %s\n' "$*" >&2
  exit "$code"
}
[[ $# -ge 1 ]] || usage
own=$(. /etc/os-release && echo "$VERSION_CODENAME")
mode=$1 suite=$own debs='' words=()
case $mode in
  --static | --archive)
    [[ $# == 2 || $# == 3 && $1$3 == --static--arm64 ]] || usage
    place=$2 words=("${@:3}")
    [[ $mode == --static || -f $place ]] || usage
    ;;
  --depth | --parse | --check | --proofs | --arm64)
    shift
    if [[ ${1-} =~ ^[a-z]+$ ]]; then
      suite=$1
      shift
    fi
    [[ $mode == --check || $# == 0 ]] || usage
    ;;
  *)
    [[ -d $mode ]] || usage
    debs=$(cd "$mode" && pwd)
    compgen -G "$debs/*.deb" >/dev/null || [[ ${2-} == --keep ]] || die 2 "no packages in $debs: packaging/build_debs.sh makes them"
    ;;
esac
((!EUID)) || die 2 "only root can make a bare system"
unshare --pid --mount --fork true || die 3 "root may mount nothing here (in a container: --cap-add SYS_ADMIN)"
(me=try_in_chroot.sh && . "$root/cmake/launcher.sh" && lock && start_log && install_packages chroot $([[ $mode != --static && $mode != --archive ]] || echo static)) || exit

mapfile -t archives < <(apt-get indextargets --no-release-info --format 'deb $(REPO_URI) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' |
  sort -u | sed -nE "s/ $own(-updates|-security)? / $suite\1 /p")
mapfile -t proxies < <(env | grep -iE '^[a-z]+_proxy=' || true)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT TERM
chmod 755 "$work"

limited() { timeout --foreground --kill-after=10 "$@"; }

# bare TARGET OPTIONS...: a folder or tarball with the smallest system. Options are mmdebstrap's, or further archives.
bare() {
  local target=$1
  shift
  limited 20m mmdebstrap --quiet --variant=minbase --dpkgopt=force-unsafe-io "$@" "$suite" "$target" "${archives[@]}" ||
    die 3 "mmdebstrap could not make a bare $suite; the archives were${archives[*]/#/$'\n  '}"
}

# inside FOLDER COMMAND...: runs it there, where /proc is mounted: fathom finds its adapters by it. What it started ends with it. Its 3, with
# which our launchers say that they cannot build, is a 1 here: the system was made.
inside() {
  local target=$work/$1
  shift
  limited "${limit:-30m}" unshare --kill-child --pid --mount --root="$target" --mount-proc \
    env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 CCACHE_DIR=/ccache CCACHE_MAXSIZE=2G "${proxies[@]}" "$@" ||
    return $(($? == 3 ? 1 : $?))
}

if [[ ${2-} == --keep ]]; then
  bare "$3"
  exit
fi

# bare_with_sources OPTIONS...: the same in $work/there, with our sources in /fathom, the network as it is here, and what was compiled before.
cache=${XDG_CACHE_HOME:-$HOME/.cache}/fathom/ccache-$suite
if [[ "$mode ${words[*]}" == *--arm64* ]]; then cache+=-arm64; fi
bare_with_sources() {
  local target=$work/there
  bare "$target" "$@"
  cp -L /etc/resolv.conf /etc/hosts "$target/etc"
  apt-config dump | grep -E '^Acquire::(https?|Retries)' >"$target/etc/apt/apt.conf.d/99as-there" || true
  mkdir "$target/fathom" "$target/data"
  tar -C "$root" --exclude-vcs --exclude=./build -c . | tar -C "$target/fathom" --no-same-owner -x
  if [[ -d $cache ]]; then cp -a "$cache" "$target/ccache"; fi
}

keep_compiled() {
  [[ -d $work/there/ccache ]] || return 0
  mkdir -p "${cache%/*}"
  rm -rf "$cache"
  mv "$work/there/ccache" "$cache"
}
trap 'keep_compiled; rm -rf "$work"' EXIT

# same_answers COMMAND...: the catalogues, the real cases and L0 are one stream of cases, which the program there and this machine's fathom
# answer, with every proof. The bytes are the same, and the checker accepts each proof.
same_answers() {
  local data=$work/there/data catalogue
  for catalogue in '' --shapes --unions; do "$root/fathom" cases $catalogue --catalogue; done >"$data/cases.jsonl"
  zstd -dcq "$root"/tests/data/golden/golden-L0-*.jsonl.zst | cat "$root/tests/data/real_cases.jsonl" - >>"$data/cases.jsonl"
  "$root/fathom" depth --json --embed-certificate - <"$data/cases.jsonl" >"$data/here.jsonl" 2>"$data/here.log"
  "$@" depth --json --embed-certificate - <"$data/cases.jsonl" >"$data/there.jsonl" 2>"$data/there.log" ||
    die $? "the program there ended with $?: $(tail -n 3 "$data/there.log")"
  cmp "$data/here.jsonl" "$data/there.jsonl"
  cmp "$data/here.log" "$data/there.log"
  "$root/fathom" check --results "$data/there.jsonl" >"$data/checked" || die 1 "refused: $(grep -v VERIFIED "$data/checked" | head -n 3)"
  say "the same bytes: $(wc -l <"$data/there.jsonl") answers; their proofs are accepted"
}

# same_l0 PROGRAM...: makes L0 there. Contents are compared: what zstd makes of them changes with its version.
same_l0() {
  local name
  inside there "$@" golden generate --level L0 --seed 1 --out /data/L0
  for name in "$root"/tests/data/golden/*.zst; do
    cmp <(zstd -dcq "$name") <(zstd -dcq "$work/there/data/L0/${name##*/}")
  done
  say "the same bytes: L0"
}

# Each file of the preset release is parsed; Ninja does not ask whether an object was made.
parse_all() {
  printf '#!/bin/sh\nexec "$@" -fsyntax-only\n' >"$work/there/data/parse"
  chmod +x "$work/there/data/parse"
  inside there bash -euc 'root=/fathom me=parse && . /fathom/cmake/launcher.sh && lock && start_log && install_packages depth build && cd /fathom
    apt-get -qq install -y --no-install-recommends clang >>"$log" 2>&1
    for compiler in g++ clang++; do
      cmake --preset release -B "/data/$compiler" -DFATHOM_TESTS=OFF -DFATHOM_PYTHON=OFF -DCMAKE_COMPILE_WARNING_AS_ERROR=ON \
        "-DCMAKE_CXX_COMPILER=$compiler" -DCMAKE_CXX_COMPILER_LAUNCHER=/data/parse >>"$log"
      ninja -C "/data/$compiler" -t targets all | sed -n "s/^\(.*\.o\): CXX_COMPILER.*/\1/p" >/data/objects
      xargs ninja -C "/data/$compiler" -k 0 -j "$(jobs)" --quiet </data/objects
      echo "$compiler: $(wc -l </data/objects) files"
    done'
}

# Of what the launcher asks for, the libraries are those of arm64, but for such as are of all architectures; compilers are this machine's.
bare_for_arm64() {
  local libraries
  bare_with_sources --architectures=amd64,arm64 \
    --include=crossbuild-essential-arm64,cmake,ninja-build,ccache,qemu-user,dpkg-dev,xz-utils
  mapfile -t libraries < <(. "$root/cmake/launcher.sh" && packages depth build | grep '^lib')
  inside there bash -euc 'export DEBIAN_FRONTEND=noninteractive
    apt-get -q update >/data/log
    for name; do
      if apt-cache show "$name" | grep -qx "Architecture: all"; then echo "$name"; else echo "$name:arm64"; fi
    done >/data/packages
    xargs apt-get -qq install -y --no-install-recommends </data/packages >>/data/log 2>&1 || { tail -n 5 /data/log >&2; exit 1; }' - \
    "${libraries[@]}"
}

cross_build() {
  inside there bash -euc 'cmake --preset release -S /fathom -B /data/arm64 -DFATHOM_TESTS=OFF -DFATHOM_PYTHON=OFF -DCMAKE_SYSTEM_NAME=Linux \
      -DCMAKE_SYSTEM_PROCESSOR=aarch64 -DCMAKE_C_COMPILER=aarch64-linux-gnu-gcc -DCMAKE_CXX_COMPILER=aarch64-linux-gnu-g++ >>/data/log
    ninja -C /data/arm64 --quiet fathom-check fathom-depth fathom_c'
}

# alone PROGRAM WORDS...: a program of the archive in a root where there is nothing else but what try_archive put there.
alone() {
  limited "${limit:-30m}" env -i PATH=/bin /usr/sbin/chroot "$work/empty" "${emulator[@]}" "/fathom/bin/$1" "${@:2}"
}

try_archive() {
  local archive=$1 empty=$work/empty emulator=()
  say "${archive##*/}: in an empty root"
  mkdir -p "$empty/bin" "$empty/fathom" "$work/there/data"
  tar -C "$empty/fathom" --strip-components=1 -xJf "$archive"
  if [[ $archive == *-arm64.* ]]; then
    emulator=(/qemu-aarch64-static)
    cp "/usr/bin${emulator[0]}" "$empty"
  fi
  same_answers alone fathom
  cp "$root/tests/data/cube.off" "$root/tests/data/icosahedron.off" "$empty"
  cp "$root/examples/data/stairs.gltf" "$empty"
  alone fathom depth --certificate /proof.cert /cube.off /icosahedron.off >"$work/alone"
  "$root/fathom" depth "$root/tests/data/cube.off" "$root/tests/data/icosahedron.off" | cmp - "$work/alone"
  alone fathom-check /proof.cert
  say "a subject is certified: its shell is busybox"
  cp /bin/busybox "$empty/bin/sh"
  g++ -std=c++17 -O1 -static -I "$empty/fathom/share/fathom/kit" "$empty/fathom/share/fathom/kit/example.cpp" -o "$empty/subject"
  alone fathom cases --family boxes_aligned --count 20 >"$empty/cases.jsonl"
  alone fathom certify --subject /subject /cases.jsonl
  say "no library is loaded: a file for Assimp ends with exit code 2"
  if alone fathom depth /stairs.gltf /cube.off 2>"$work/said"; then die 1 "the static program read a file that needs a library"; else (($? == 2)); fi
  grep -F 'built without Assimp' "$work/said"
}

if [[ $mode == --static || $mode == --archive ]]; then
  archive=$place
  if [[ $mode == --static ]]; then
    say "$suite: a bare system with the sources, and the archive"
    if ((${#words[@]})); then bare_for_arm64; else bare_with_sources; fi
    limit=8h inside there /fathom/packaging/static.sh /data/archives "${words[@]}"
    mkdir -p "$place"
    cp "$work"/there/data/archives/* "$place"
    archive=$(ls "$work"/there/data/archives/fathom-*-linux-*.tar.xz)
  fi
  limit=2h try_archive "$archive"
  say "all of it works"
  exit
fi

if [[ $mode == --arm64 ]]; then
  say "$suite: a bare system with the sources, and compilers for arm64"
  bare_for_arm64
  say "$suite: fathom-check, fathom-depth and the library for C are cross-built"
  limit=8h cross_build
  limit=2h
  zstd -dcq "$root"/tests/data/golden/golden-L0-*.cert.zst >"$work/there/data/L0.cert"
  inside there qemu-aarch64 /data/arm64/verify/check/fathom-check /data/L0.cert >"$work/there/data/checked"
  "$root/fathom" check "$work/there/data/L0.cert" | cmp - "$work/there/data/checked"
  say "arm64: the same bytes: $(wc -l <"$work/there/data/checked") verdicts on the proofs of L0"
  same_answers inside there qemu-aarch64 /data/arm64/fathom-depth
  inside there bash -euc 'for source in /fathom/examples/c_*.c; do
      aarch64-linux-gnu-gcc -std=c99 -I /fathom/include "$source" -o /data/example -L /data/arm64 -lfathom-c -Wl,-rpath,/data/arm64
      (cd /fathom/examples && cmake -D "PROGRAM=qemu-aarch64;/data/example" -D "SOURCE=$source" -P run.cmake)
    done'
  say "arm64: the examples in C print what they say"
  say "all of it works"
  exit
fi

if [[ -z $debs ]]; then
  say "$suite: a bare system with the sources"
  bare_with_sources
  if [[ $mode == --parse ]]; then
    say "$suite: all sources are parsed"
    limit=3h parse_all
  elif [[ $mode == --proofs ]]; then
    say "$suite: everything is proved, and the proved checker built"
    limit=2h inside there bash -euc 'root=/fathom me=proofs && . /fathom/cmake/launcher.sh && lock && start_log && install_packages proved page && cd /fathom
      make -C proofs/coq OUT=/data/proofs check page >/data/log 2>&1 || { tail -n 20 /data/log >&2; exit 1; }
      coqc --version | head -n 1'
  else
    say "$suite: the launcher builds depth"
    limit=3h inside there /fathom/fathom depth /fathom/tests/data/cube.off /fathom/tests/data/icosahedron.off
    same_answers inside there /fathom/fathom
  fi
  if [[ $mode == --check ]]; then
    limit=6h
    inside there /fathom/fathom --version
    same_answers inside there /fathom/fathom
    same_l0 /fathom/fathom
    inside there /fathom/check "$@"
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
cp "$root/packaging/consumer/CMakeLists.txt" "$root"/examples/{depth.cpp,c_overlap.c} "$work/library/tmp/project"
inside library sh -ec 'cd /tmp/project
  cmake -G Ninja -S . -B build && cmake --build build && ./build/depth
  g++ -std=c++20 depth.cpp -o depth $(pkg-config --cflags --libs fathom) && ./depth
  g++ -x c -std=c99 c_overlap.c -o overlap $(pkg-config --cflags --libs fathom-c) && ./overlap'

say "python3-fathom: a depth"
install python python3-fathom
inside python python3 -c 'import fathom; print(fathom.depth(fathom.sphere(1), fathom.sphere("1/2")).depth)'

say "all of it works"
