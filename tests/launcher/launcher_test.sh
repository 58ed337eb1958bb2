#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Tries the launchers on a small project of its own: launcher_test.sh PROJECT_ROOT
# Each `law` names what the next steps show; the first broken one ends the test.
set -u
project=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
chmod 755 "$work"
tree="$work/a tree"
law='' talk=''

broken() {
  printf 'broken law: %s\n%s\nstderr was: %s\n' "$law" "$1" "$talk" >&2
  cat "$tree/build/launcher.log" >&2
  exit 1
}

# expect CODE STDOUT COMMAND...   what it says on stderr is kept in $talk
expect() {
  local code=$1 wanted=$2 got status
  shift 2
  got=$("$@" 2>"$work/talk")
  status=$?
  talk=$(<"$work/talk")
  [[ $status == "$code" ]] || broken "exit code $status instead of $code"
  [[ $got == "$wanted" ]] || broken "printed '$got' instead of '$wanted'"
}
expect_silence() { [[ -z $talk ]] || broken 'stderr should be empty'; }
expect_talk() { [[ $talk == *"$1"* ]] || broken "stderr should hold '$1'"; }

# A program that prints its answer, its arguments, its standard input if one is "-", and exits with their number. Behind --part it says what
# part it needs: `certify --adapter some` adapters that are built, `certify --adapter engine` one for the web.
program() {
  cat <<CPP
#include <iostream>
#include <string>
int main(int n, char** arguments) {
  if (n > 1 && std::string(arguments[1]) == "--part") {
    const bool adapter = n == 5 && std::string(arguments[3]) == "--adapter";
    std::cout << (!adapter ? "" : std::string(arguments[4]) == "engine" ? "web" : "subjects");
    return 0;
  }
  std::cout << "$1";
  for (int i = 1; i < n; ++i) std::cout << "|" << (std::string(arguments[i]) == "-" ? std::string(1, char(std::cin.get())) : arguments[i]);
  return n - 1;
}
CPP
}

mkdir -p "$tree/cmake" "$tree/cli" "$tree/kernels" "$tree/verify/subjects/web" "$tree/verify/subjects/kit" "$work/elsewhere"
cp "$project/fathom" "$project/check" "$tree"
cp "$project/cmake/launcher.sh" "$project/cmake/settings.cmake" "$tree/cmake"
cat >"$tree/CMakePresets.json" <<'JSON'
{"version": 6, "configurePresets": [
  {"name": "release", "generator": "Ninja", "binaryDir": "${sourceDir}/build/release"},
  {"name": "other", "generator": "Ninja", "binaryDir": "${sourceDir}/build/other"}]}
JSON
cat >"$tree/CMakeLists.txt" <<'CMAKE'
cmake_minimum_required(VERSION 3.25)
project(small LANGUAGES CXX)
include(cmake/settings.cmake)
execute_process(COMMAND cat OUTPUT_QUIET) # eats the standard input it gets
option(FATHOM_TESTS "" ON)
option(FATHOM_ONLY_DEPTH "" OFF)
add_executable(fathom-depth kernels/depth.cpp)
if(FATHOM_ONLY_DEPTH)
  return()
endif()
if(NOT EXISTS ${CMAKE_SOURCE_DIR}/packages_of_the_rest)
  message(FATAL_ERROR "a package is missing")
endif()
file(GLOB sources CONFIGURE_DEPENDS cli/*.cpp)
add_executable(fathom ${sources})
add_dependencies(fathom fathom-depth)
add_custom_target(fathom-subjects COMMAND touch part_begun && until [ -e part_may_end ] \; do sleep 0.1 \; done && touch fathom-subjects.stamp)
add_custom_target(fathom-web-subjects COMMAND echo "fathom: no network" && false)
if(FATHOM_TESTS)
  enable_testing()
  add_test(NAME runs COMMAND fathom)
  add_test(NAME fails COMMAND fathom argument)
  add_executable(room ${sources})
  add_custom_target(tests_kernels DEPENDS room)
  add_test(NAME in_a_room COMMAND room)
  set_tests_properties(in_a_room PROPERTIES LABELS kernels)
endif()
CMAKE
program one >"$tree/cli/main.cpp"
program small >"$tree/kernels/depth.cpp"
packages() {
  printf '# comment\n[depth]\nbash\n%s\n[build]\nbash\n%s\n[test]\n%s\n[subjects]\n%s\n[python]\n%s\n' "${@:1:5}" >"$tree/cmake/packages.txt"
  printf '[browser]\nbash\n' >>"$tree/cmake/packages.txt"
}
packages no-such-package no-such-build-package no-such-test-package bash no-such-python-package

law='without root, missing packages give one apt line and exit code 2, even where nothing can be written'
ordinary=()
((EUID)) || ordinary=(setpriv --reuid=65534 --regid=65534 --clear-groups)
expect 2 '' ${ordinary[@]+"${ordinary[@]}"} "$tree/check"
expect_talk 'apt-get install -y --no-install-recommends no-such-package no-such-build-package no-such-test-package no-such-python-package'
expect 2 '' ${ordinary[@]+"${ordinary[@]}"} "$tree/fathom"
expect_talk 'apt-get install -y --no-install-recommends no-such-package no-such-build-package'
[[ $talk != *bash* && $talk != *test-package* && $talk != *python-package* ]] || broken 'more packages are named than are needed and missing'
expect 2 '' ${ordinary[@]+"${ordinary[@]}"} "$tree/fathom" depth
expect_talk 'apt-get install -y --no-install-recommends no-such-package'
[[ $talk != *build-package* ]] || broken 'depth asks for packages that it does not need'
[[ ! -e $tree/build ]] || broken 'something was built'

law='a package is not asked for where its command is there, and by its own name where it is not'
packages bash bash bash bash bash
printf '%s\n' 'no-such-shell unless bash' 'no-such-node  unless  no-such-command' '# no-such-comment' >>"$tree/cmake/packages.txt"
expect 2 '' ${ordinary[@]+"${ordinary[@]}"} "$tree/check"
[[ $talk == *'apt-get install -y --no-install-recommends no-such-node' ]] || broken 'other packages than no-such-node'

law='a package that only some releases have is asked for where apt knows it'
packages bash bash bash bash bash
printf '%s\n' 'no-such-new-package if known' 'no-such-old-package  if known' >>"$tree/cmake/packages.txt"
mkdir "$work/apt"
printf '#!/bin/sh\n[ "$*" = "show no-such-new-package" ]\n' >"$work/apt/apt-cache"
chmod 755 "$work/apt" "$work/apt/apt-cache"
expect 2 '' env PATH="$work/apt:$PATH" ${ordinary[@]+"${ordinary[@]}"} "$tree/check"
[[ $talk == *'apt-get install -y --no-install-recommends no-such-new-package' ]] || broken 'other packages than no-such-new-package'

law='the first answer of depth builds, without the packages of the rest, what depth needs, says so, and says where the log is'
packages bash no-such-build-package no-such-test-package bash
expect 2 'small|depth|a' "$tree/fathom" depth a
expect_talk 'building what depth needs'
expect_talk "the log is $tree/build/launcher.log"
[[ ! -e $tree/build/release/fathom ]] || broken 'all was built'
expect 2 'small|depth|a' "$tree/fathom" depth a
expect_silence
program tiny >"$tree/kernels/depth.cpp"
expect 1 'tiny|depth' "$tree/fathom" depth
expect_talk 'building what changed'

law='another command builds the rest, and says so; then that answers depth too'
packages bash bash no-such-test-package bash
touch "$tree/packages_of_the_rest"
expect 0 one "$tree/fathom"
expect_talk 'building the other commands'
expect 1 'one|depth' "$tree/fathom" depth
expect_silence
law='a lost program is not answered for by an older one'
program small >"$tree/kernels/depth.cpp"
expect 0 one "$tree/fathom"
rm "$tree/build/release/fathom"
expect 1 'small|depth' "$tree/fathom" depth
expect_silence
rm -r "$tree/build"

law='the first use builds, says so on stderr, and runs, even where HOME cannot be written'
expect 0 one env -u CCACHE_DIR -u XDG_CACHE_HOME HOME=/proc "$tree/fathom"
expect_talk 'building, which takes'

law='the second use is quiet; arguments, standard input and exit code pass untouched'
expect 3 'one|a b||*' "$tree/fathom" 'a b' '' '*'
expect_silence
expect 1 'one|x' "$tree/fathom" - <<<'x'
expect_silence

law='it works from another folder and through a symbolic link'
ln -s "../a tree/fathom" "$work/elsewhere/link"
cd "$work/elsewhere" || exit 1
expect 0 one ./link
expect_silence

law='a changed source is rebuilt, and a build leaves standard input alone'
program two >"$tree/cli/main.cpp"
expect 1 'two|y' ./link - <<<'y'
expect_talk building
law='a source that changed but carries an old date is rebuilt'
program three >"$tree/cli/main.cpp"
touch -d '2001-01-01' "$tree/cli/main.cpp"
expect 0 three ./link
law='an added source is rebuilt; a failing build shows its log and exits with 3'
program four >"$tree/cli/second.cpp"
expect 3 '' ./link
expect_talk 'multiple definition'
law='a failed build is tried again; a deleted source is rebuilt'
expect 3 '' ./link
rm "$tree/cli/second.cpp"
expect 0 three ./link
law='a changed CMake file is rebuilt'
echo 'target_compile_definitions(fathom PRIVATE three=four)' >>"$tree/CMakeLists.txt"
sed -i 's/"three"/NAME(three)/; 1i #define TEXT(x) #x\n#define NAME(x) TEXT(x)' "$tree/cli/main.cpp"
expect 0 four ./link
law='a lost program is built again'
rm "$tree/build/release/fathom"
expect 0 four ./link

law='the lines shown on a terminal fit into its width'
program four >"$tree/cli/main.cpp"
script -qec "stty cols 40; './link'" /dev/null >"$work/terminal" </dev/null || broken 'no answer on a terminal'
tr '\r' '\n' <"$work/terminal" | sed -n 's/^\x1b\[K//p' >"$work/shown"
[[ $(wc -L <"$work/shown") == 39 ]] || broken "the longest line has not 39 characters: $(cat "$work/shown")"
law='on a terminal the share that is done and the time left are shown, and no path'
grep -qxE '100 %, 0 s left \[([0-9]+)/\1\].*' "$work/shown" || broken "no share of what is done: $(cat "$work/shown")"
! grep -q 'launcher.log' "$work/terminal" || broken "the log is named: $(cat "$work/terminal")"

law='two calls at once: one builds, the other waits, both answer'
program five >"$tree/cli/main.cpp"
./link >"$work/left" 2>"$work/talk.left" &
./link >"$work/right" 2>"$work/talk.right"
wait $! || broken 'the first of two calls failed'
[[ $(<"$work/left")$(<"$work/right") == fivefive ]] || broken "printed '$(<"$work/left")' and '$(<"$work/right")'"
[[ $(cat "$work"/talk.* | grep -c 'building') == 1 ]] || broken "both built: $(cat "$work"/talk.*)"

law='a copy of the tree, build and all, answers where it is, and is built there when a source changes'
cp -a "$tree" "$work/copy"
rm -r "$tree/cli"
expect 0 five "$work/copy/fathom"
expect_silence
cp -a "$work/copy/cli" "$tree/cli"
law='a copy that cannot be written answers too, and says so where it may be older than its sources'
expect 0 five ${ordinary[@]+"${ordinary[@]}"} "$work/copy/fathom"
expect_silence
program copied >"$work/copy/cli/main.cpp"
chmod -R a-w "$work/copy"
expect 0 five ${ordinary[@]+"${ordinary[@]}"} "$work/copy/fathom"
expect_talk "cannot write to $work/copy/build: fathom may be older than its sources"
chmod -R u+w "$work/copy"
expect 0 copied "$work/copy/fathom"
expect_talk 'building'

law='check builds with tests, prints what ctest says, passes arguments on and exits with 1 when a test fails'
packages bash bash bash bash
"$tree/check" >"$work/out" 2>"$work/talk" && broken 'a failing test went unnoticed'
[[ $? == 1 ]] || broken "exit code is not 1: $(cat "$work/out")"
grep -q '67% tests passed, 1 tests failed out of 3' "$work/out" || broken "closing lines are missing: $(cat "$work/out")"
"$tree/check" -R runs >"$work/out" 2>"$work/talk" || broken "the passing test failed: $(cat "$work/out")"
grep -q '100% tests passed, 0 tests failed out of 1' "$work/out" || broken "closing lines are missing: $(cat "$work/out")"
"$tree/check" -R no-such-test >"$work/out" 2>"$work/talk" && broken 'no test at all is no success'

law='check builds one room in another preset, runs its tests alone, and leaves the release build alone'
"$tree/check" --preset other --room kernels >"$work/out" 2>"$work/talk" || broken "the room's test failed: $(cat "$work/out" "$work/talk")"
grep -q '100% tests passed, 0 tests failed out of 1' "$work/out" || broken "not one test: $(cat "$work/out")"
[[ -x $tree/build/other/room && ! -e $tree/build/other/fathom ]] || broken 'more than the room was built'
expect 2 '' "$tree/check" --room
expect_talk 'expected a name after --room'
expect 0 five "$tree/fathom"
expect_silence
law='building one room does not count as building the program'
program six >"$tree/cli/main.cpp"
"$tree/check" --room kernels >"$work/out" 2>"$work/talk" || broken "the room's test failed: $(cat "$work/out" "$work/talk")"
expect 0 six "$tree/fathom"
program five >"$tree/cli/main.cpp"
expect 0 five "$tree/fathom"

law='a part with packages of its own is built when the program says that it needs it, and its packages are asked for before that'
packages bash bash bash no-such-adapter-package
expect 0 five "$tree/fathom"
expect 2 '' ${ordinary[@]+"${ordinary[@]}"} "$tree/fathom" certify --adapter some
expect_talk 'apt-get install -y --no-install-recommends no-such-adapter-package'
expect 3 'five|certify|--subject|some' "$tree/fathom" certify --subject some
expect_silence

law='while a part is built, what is up to date answers and does not wait'
packages bash bash bash bash
"$tree/fathom" certify --adapter some >"$work/left" 2>"$work/talk.left" &
part=$!
until [[ -e $tree/build/release/part_begun ]]; do
  kill -0 $part || broken "the part was not begun: $(cat "$work/talk.left")"
  sleep 0.1
done
expect 1 'five|depth' "$tree/fathom" depth
expect_silence
touch "$tree/build/release/part_may_end"
wait $part
[[ $(<"$work/left") == 'five|certify|--adapter|some' ]] || broken "printed '$(<"$work/left")'"
law='it is said what is built'
grep -q 'building the adapters of other libraries' "$work/talk.left" || broken "said: $(cat "$work/talk.left")"

law='a step that knows why it fails is quoted, without what ninja and CMake say'
expect 3 '' "$tree/fathom" certify --adapter engine
expect_talk 'fathom: no network (the whole log is'
[[ $talk != *ninja* && $talk != *CMake* && $talk != *FAILED* ]] || broken 'more is said than the sentence'
expect 0 five "$tree/fathom"
expect_silence
law='so does the installation of the engines for the web, where there is no network, and where HOME cannot be written'
expect 1 '' env HOME=/proc npm_config_registry=http://127.0.0.1:9/ "$project/verify/subjects/web/install.sh" node npm "$work/web"
[[ $talk == "fathom: the engines' packages come by the network, which is not there (127.0.0.1: ECONNREFUSED)" ]] || broken 'no such sentence'

law='after check, fathom has nothing to do'
expect 0 five "$tree/fathom"
expect_silence
echo 'every law holds'
