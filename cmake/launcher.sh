# SPDX-License-Identifier: GPL-3.0-or-later
# What the launchers ./fathom and ./check share: packages, build lock, configuring and building. Sourced by bash.
# The caller sets root (the project's top folder) and me (its own name), and preset if it is not release. Everything here talks on stderr.
#
# Exit codes: 2 packages are missing and only root may install them; 3 installing or building failed.

preset=${preset-release}
out=$root/build/$preset
log=$root/build/launcher.log
stamp=$out/launcher.stamp

say() { printf '%s: %s\n' "$me" "$*" >&2; }

die() {
  local code=$1
  shift
  say "$@"
  exit "$code"
}

# Everything that the program is built from, one line each. Any edit, addition or removal changes it.
inputs() {
  local from=(include kernels reference verify view cli bindings/c cmake CMakeLists.txt CMakePresets.json)
  (cd "$root" && find "${from[@]}" -type f -printf '%p %s %T@\n' 2>/dev/null) | LC_ALL=C sort
}

# up_to_date PROGRAM. The stamp is that of the whole program if that is there, else that of fathom-depth.
up_to_date() { [[ -x $out/$1 && $(inputs) == "$(cat "$stamp" 2>/dev/null)" ]]; }

# Whether anything can be built here. A copy that cannot be written answers as it was built.
writable() { mkdir -p "$root/build" 2>/dev/null && : 2>/dev/null >>"$root/build/lock"; }

# How many characters fit into a line of the terminal without making it scroll.
line_width() {
  local rows columns
  read -r rows columns < <(stty size <&2 2>/dev/null)
  echo $((${columns:-0} > 1 ? columns - 1 : 79))
}

start_log() {
  : >"$log"
  [[ -t 2 ]] || say "the log is $log"
}

# Shows the latest line in place. Ninja's begin with [done/all]: there the share that is done and the time left, at the pace so far, precede.
show_lines() {
  local line width start=$SECONDS finished all left
  width=$(line_width)
  while IFS= read -r line; do
    if [[ $line =~ ^\[([0-9]+)/([0-9]+)\] ]]; then
      finished=${BASH_REMATCH[1]} all=${BASH_REMATCH[2]}
      left=$(((SECONDS - start) * (all - finished) / (finished ? finished : 1)))
      if ((left < 100)); then left+=" s"; else left="$((left / 60 + 1)) min"; fi
      line="$((100 * finished / all)) %, $left left $line"
    fi
    printf '\r\033[K%s' "${line:0:width}" >&2
  done
}

# Runs a command with its output in the log; on a terminal the latest line is shown while it works.
logged() {
  if [[ ! -t 2 ]]; then
    "$@" </dev/null >>"$log" 2>&1
    return
  fi
  "$@" </dev/null 2>&1 | tee -a "$log" | show_lines
  local status=${PIPESTATUS[0]}
  printf '\r\033[K' >&2
  return "$status"
}

# A step that knows why it fails says so in a line that begins with `fathom: `; of others the last lines are shown.
logged_or_die() {
  local what=$1 why
  shift
  logged "$@" && return
  why=$(sed -n 's/^fathom: //p' "$log" | tail -n 1)
  if [[ -n $why ]]; then die 3 "$why (the whole log is $log)"; fi
  tail -n 40 "$log" >&2
  die 3 "$what failed; the whole log is $log"
}

# The packages of the given sections of packages.txt, without those whose command is there, `nodejs unless node`, and those that this
# release of Debian lacks, `clang-format-14 if known`.
packages() {
  local package condition section='' wanted=" $* "
  while read -r package condition; do
    case $package in
      '' | '#'*) ;;
      '['*']') section=${package:1:-1} ;;
      *)
        if [[ $wanted != *" $section "* ]]; then continue; fi
        case $condition in
          unless*) if command -v "${condition##* }" >/dev/null; then continue; fi ;;
          if*) apt-cache show "$package" >/dev/null 2>&1 || continue ;;
        esac
        printf '%s\n' "$package"
        ;;
    esac
  done <"$root/cmake/packages.txt"
}

# Sets `missing` to the packages of the given sections that are not installed.
find_missing() {
  local wanted installed package
  missing=()
  command -v dpkg-query >/dev/null || return 0 # no Debian: CMake will say what it cannot find
  mapfile -t wanted < <(packages "$@")
  installed=" $(dpkg-query -W -f '${db:Status-Status}=${Package} ' "${wanted[@]}" 2>/dev/null)"
  for package in "${wanted[@]}"; do
    [[ $installed == *" installed=$package "* ]] || missing+=("$package")
  done
}

# Ends with the one line that root has to run, if packages of the given sections are missing and we are not root.
demand_packages() {
  ((EUID)) || return 0
  find_missing "$@"
  ((${#missing[@]})) || return 0
  say "these Debian packages are missing; as root, run"
  printf '  apt-get update && apt-get install -y --no-install-recommends %s\n' "${missing[*]}" >&2
  exit 2
}

# Installs what is missing. Needs root, and the network only when something is.
install_packages() {
  find_missing "$@"
  ((${#missing[@]})) || return 0
  say "installing Debian packages: ${missing[*]}"
  local -x DEBIAN_FRONTEND=noninteractive
  logged_or_die "apt-get update" apt-get update 9>&-
  find_missing "$@" # now apt knows what there is
  logged_or_die "apt-get install" apt-get -o DPkg::Lock::Timeout=600 install -y --no-install-recommends "${missing[@]}" 9>&-
}

# One build at a time. The lock lies on descriptor 9: it is held until the caller ends, and by a compiler that outlives the caller.
lock() {
  writable || die 3 "cannot write to $root/build"
  exec 9>>"$root/build/lock"
  flock -n 9 && return
  say "waiting for another build to finish"
  flock 9
}

# Ninja goes by dates alone: a file that changed but kept an older date (cp -p, tar, rsync) would be missed.
freshen() {
  local line
  [[ -f $stamp ]] || return 0
  LC_ALL=C comm -13 "$stamp" <(printf '%s\n' "$1") 2>/dev/null | while IFS= read -r line; do
    line=$root/${line% * *}
    if [[ $line -ot $stamp ]]; then touch -c "$line"; fi
  done
}

# At most two compilers at once, and one where memory is short: each may take over 1 GB.
jobs() {
  local memory
  memory=$(sed -n 's/^MemTotal: *\([0-9]*\) kB/\1/p' /proc/meminfo 2>/dev/null)
  if ((${memory:-4000000} < 3000000)); then echo 1; else echo 2; fi
}

# build TESTS TARGETS [CMAKE ARGUMENTS...]: configures and builds the preset. TESTS: ON, or KEEP what an earlier call chose.
# TARGETS: words; without `all`, `fathom` and `fathom-depth` the programs may stay behind their sources. `fathom-depth` alone is configured
# without the rest, whose packages may be missing. `building`, if the caller sets it, says what is built besides a program that is there.
build() {
  local tests=$1 targets before only_depth=OFF what program=fathom cache=$out/CMakeCache.txt
  read -ra targets <<<"$2"
  shift 2
  if [[ -f $cache ]] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$cache"; then
    rm -rf "$out" # the folder was moved or copied: the cache holds the old paths
  fi
  if [[ $tests == KEEP ]]; then
    tests=OFF
    if grep -qsxF 'FATHOM_TESTS:BOOL=ON' "$cache"; then tests=ON; fi
  fi
  if [[ -x $out/fathom || ${targets[*]} == fathom-depth && -x $out/fathom-depth ]]; then
    what="building ${building:-what changed}"
  elif [[ ${targets[*]} == fathom-depth ]]; then
    what='building what depth needs, which takes some minutes; the other commands are built when one is asked for'
  elif [[ -x $out/fathom-depth ]]; then
    what='building the other commands, which takes some minutes'
  else
    what='building, which takes some minutes'
  fi
  say "$what ($preset)"
  if [[ ${targets[*]} == fathom-depth ]]; then only_depth=ON; fi
  [[ -x $out/fathom ]] || program=fathom-depth
  if ! up_to_date $program; then # else the program stays what it is, and answers others while its neighbours are built
    freshen "$(inputs)"
    rm -f "$stamp"
  fi
  before=$(inputs)
  cd "$root" || die 3 "cannot enter $root"
  logged_or_die "configuring" cmake --preset "$preset" "-DFATHOM_TESTS=$tests" "-DFATHOM_ONLY_DEPTH=$only_depth" "$@"
  logged_or_die "building" cmake --build "$out" --target "${targets[@]}" -j "$(jobs)"
  if [[ " ${targets[*]} " =~ ' '(all|fathom|fathom-depth)' ' ]]; then
    printf '%s\n' "$before" >"$stamp.new" && mv -f "$stamp.new" "$stamp" # others may read it meanwhile
  fi
}
