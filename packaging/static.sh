#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# static.sh OUT            builds fathom-VERSION-linux-x86_64.tar.xz in the folder OUT: programs that need no library of the system, the
#                          kits, the pages, licences; and fathom-VERSION-source.tar.xz, which lies beside it wherever it is handed out.
# static.sh OUT --arm64    fathom-VERSION-linux-arm64.tar.xz, by cross-compiling.
#
# It needs Debian 12 and root, for the packages in cmake/packages.txt; with --arm64 those of that architecture have to be there, as
# try_in_chroot.sh --static makes them. Libraries that Debian has as shared ones only are built before, from its sources. The same sources
# in the same folder make the same bytes.
#
# Exit codes: 2 usage, or packages are missing and only root may install them; 3 installing or building failed.
set -euo pipefail
root=$(cd "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
me=static.sh
if [[ $# -lt 1 || $1 == -* || $# -gt 2 || ${2---arm64} != --arm64 ]]; then
  sed -n 's/^# \(static.sh .*\)/usage: \1/p' "${BASH_SOURCE[0]}" >&2
  exit 2
fi
. "$root/cmake/launcher.sh"
mkdir -p "$1"
to=$(cd "$1" && pwd)
arch=x86_64 debian=amd64 tools='' cross=()
if (($# > 1)); then
  arch=arm64 debian=arm64 tools=aarch64-linux-gnu-
  cross=(-DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=aarch64 -DCMAKE_C_COMPILER=aarch64-linux-gnu-gcc
    -DCMAKE_CXX_COMPILER=aarch64-linux-gnu-g++ -DCMAKE_CROSSCOMPILING_EMULATOR=qemu-aarch64)
fi
version=$(sed -n 's/^project(fathom VERSION \([^ ]*\).*/\1/p' "$root/CMakeLists.txt")
date=$(dpkg-parsechangelog -l "$root/packaging/debian/changelog" -S Timestamp)
built=$root/build/static-$arch # as deep as build/release: ccache knows what was compiled there
work=$built.work
shared_only=(fmtlib onetbb mimalloc)

# Debian's sources of the libraries that it does not have as archives; its apt checks their signatures.
fetch_sources() {
  local lists=$work/apt options
  mkdir -p "$lists/lists/partial" "$lists/cache/archives/partial"
  logged apt-get -q update
  apt-get indextargets --format 'deb-src $(REPO_URI) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' 'Origin: Debian' |
    sort -u >"$lists/sources.list"
  options=(-q -o "Dir::Etc::SourceList=$lists/sources.list" -o Dir::Etc::SourceParts=/dev/null -o "Dir::State::Lists=$lists/lists"
    -o "Dir::Cache=$lists/cache" -o APT::Sandbox::User=root)
  logged apt-get "${options[@]}" update
  (cd "$work/sources" && logged apt-get "${options[@]}" source "${shared_only[@]}")
}

build_libraries() {
  local name
  [[ ! -e $work/libraries/done ]] || return 0
  rm -rf "$work/sources" "$work/libraries"
  mkdir -p "$work/sources" "$work/libraries"
  fetch_sources || die 3 "Debian's sources cannot be fetched; the whole log is $log"
  for name in "${shared_only[@]}"; do
    # TBB without its hooks for a profiler, which would load a library.
    logged_or_die "configuring $name" cmake -G Ninja -S "$work/sources/$name"-*/ -B "$work/sources/$name" "${cross[@]}" \
      -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=OFF -DCMAKE_CXX_FLAGS=-U__TBB_USE_ITT_NOTIFY -DFMT_TEST=OFF -DFMT_DOC=OFF \
      -DTBB_TEST=OFF -DTBB_STRICT=OFF -DTBBMALLOC_BUILD=OFF -DMI_BUILD_SHARED=OFF -DMI_BUILD_OBJECT=OFF -DMI_BUILD_TESTS=OFF
    logged_or_die "building $name" cmake --build "$work/sources/$name" -j "$(jobs)"
    find "$work/sources/$name" -name 'lib*.a' -exec cp {} "$work/libraries" \;
  done
  "${tools}objcopy" --wildcard --weaken-symbol='_Z*' "$work/libraries/libmimalloc.a" # fathom has an operator new of its own
  touch "$work/libraries/done"
}

# pack NAME FOLDER...: an archive in the order of names, of the date of this version, of no user.
pack() {
  local name=$1
  shift
  tar --sort=name --mtime="@$date" --owner=0 --group=0 --numeric-owner --mode=u+w,go-w,a+rX -c "$@" | xz -T1 -6 >"$to/$name.partial"
  mv "$to/$name.partial" "$to/$name"
  say "$(cd "$to" && sha256sum "$name")"
}

# What is linked, with its licences: of each library the name that Debian gives its source, and what Debian says of its copyright.
tell_sources() {
  local stage=$1 package qualified
  mkdir -p "$stage/share/doc/fathom/libraries"
  cp "$root/packaging/static_readme.md" "$stage/README.md"
  for package in $( (packages depth build | grep '^lib' | grep -v assimp && printf '%s\n' libboost1.74-dev libc6-dev libstdc++-12-dev) | sort); do
    qualified=$package:$debian
    dpkg-query -W "$qualified" >/dev/null 2>&1 || qualified=$package
    dpkg-query -W -f '    ${source:Package} ${source:Version}\n' "$qualified"
    cp -L "/usr/share/doc/$package/copyright" "$stage/share/doc/fathom/libraries/$package.txt"
  done | sort -u >>"$stage/README.md"
}

source_archive() {
  local copy=$work/copy/fathom-$version
  rm -rf "$work/copy"
  mkdir -p "$copy"
  if git -C "$root" rev-parse HEAD >/dev/null 2>&1; then
    git -C "$root" ls-files -z
  else
    (cd "$root" && find . -path ./build -prune -o -type f -print0)
  fi | tar -C "$root" --null -T - -c | tar -C "$copy" -x
  (cd "$work/copy" && pack "fathom-$version-source.tar.xz" "fathom-$version")
}

lock
start_log
if ((!${#cross[@]})); then
  demand_packages depth build static
  install_packages depth build static
fi
say "building the libraries that Debian has as shared ones only"
build_libraries
say "building fathom and fathom-check for $arch, which takes some minutes"
cd "$root"
logged_or_die configuring cmake --preset release -B "$built" -DFATHOM_TESTS=OFF -DFATHOM_PYTHON=OFF -DFATHOM_STATIC=ON "${cross[@]}" \
  "-DCMAKE_LIBRARY_PATH=$work/libraries"
logged_or_die building cmake --build "$built" --target installed -j "$(jobs)"
name=fathom-$version-linux-$arch
rm -rf "$work/stage"
logged_or_die installing cmake --install "$built" --prefix "$work/stage/$name" --strip
tell_sources "$work/stage/$name"
(cd "$work/stage" && pack "$name.tar.xz" "$name")
source_archive
