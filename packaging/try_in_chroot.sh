#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# try_in_chroot.sh DEBS [--keep TARBALL]    installs the packages of the folder DEBS in a bare Debian, and uses each of them.
#
# The bare system is of the same release as this one, and made from its apt sources, by mmdebstrap; that needs root, and some minutes.
# --keep just writes such a system, without fathom, as a tarball: `podman import` takes it as a base image for packaging/Containerfile.
set -euo pipefail
root=$(cd "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
[[ $# -ge 1 && -d $1 ]] || { sed -n 's/^# \(try_in_chroot.sh .*\)/usage: \1/p' "${BASH_SOURCE[0]}" >&2; exit 2; }
debs=$(cd "$1" && pwd)
suite=$(. /etc/os-release && echo "$VERSION_CODENAME")
mapfile -t sources < <(find /etc/apt/sources.list /etc/apt/sources.list.d -type f \( -name '*.list' -o -name '*.sources' \) 2>/dev/null | sort)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
chmod 755 "$work"

if [[ ${2-} == --keep ]]; then
  mmdebstrap --variant=minbase "$suite" "$3" "${sources[@]}"
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
  mmdebstrap --variant=minbase --include="$(IFS=,; echo "$*")" "$suite" "$target" "${sources[@]}" "deb [trusted=yes] copy:$work/archive ./"
}

# inside FOLDER COMMAND...: runs it there, where /proc is mounted: fathom finds its adapters by it.
inside() {
  local target=$work/$1
  shift
  unshare --fork --pid --mount --root="$target" --mount-proc "$@"
}

say() { printf '== %s\n' "$*"; }

say "fathom: a depth, and its certificate"
install program fathom libccd2
cp "$root/tests/data/cube.off" "$root/tests/data/icosahedron.off" "$work/program/tmp"
inside program fathom depth --certificate /tmp/proof.cert /tmp/cube.off /tmp/icosahedron.off
inside program fathom-check /tmp/proof.cert
inside program sh -c 'fathom cases --family random_ball --count 3 | fathom certify --adapter libccd-mpr -' || (($? == 1)) # some fail

say "libfathom-dev: projects with CMake and with pkg-config, in C++ and in C"
install library libfathom-dev g++ cmake ninja-build pkg-config
mkdir "$work/library/tmp/project"
cp "$root"/packaging/consumer/* "$work/library/usr/share/doc/libfathom-dev/examples/depth.cpp" "$work/library/tmp/project"
inside library sh -ec 'cd /tmp/project
  cmake -G Ninja -S . -B build && cmake --build build && ./build/depth
  g++ -std=c++20 depth.cpp -o depth $(pkg-config --cflags --libs fathom) && ./depth
  g++ -x c -std=c99 version.c -o version $(pkg-config --cflags --libs fathom-c) && ./version'

say "python3-fathom: a depth"
install python python3-fathom
inside python python3 -c 'import fathom; print(fathom.depth(fathom.sphere(1), fathom.sphere("1/2")).depth)'

say "all of it works"
