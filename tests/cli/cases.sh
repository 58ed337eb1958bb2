# SPDX-License-Identifier: GPL-3.0-or-later
# What the transcripts make cases of: `box x y z X Y Z` is a body, its first corner first; `pair ID A B` is a line.
box() {
  local x y z all=
  for z in "$3" "$6"; do for y in "$2" "$5"; do for x in "$1" "$4"; do all+=,[$x,$y,$z]; done; done; done
  echo "{\"vertices\":[${all#,}]}"
}
pair() { echo "{\"schema\":\"fathom/case/1\",\"id\":\"$1\",\"a\":$2,\"b\":$3}"; }
pieces() { local IFS=,; echo "{\"pieces\":[$*]}"; }

# Two boxes that are 1/2 - N/1000 deep; `boxes N 1000` is one that liar.py knows. `liar WAY [SECONDS]` is the command that runs it.
boxes() { pair "box::$1" "$(box $((${2:-0} + 1)) 0 0 "${2:-0}" 1 1)" "$(box "${2:-0}.$((500 + $1))" 0 0 $((${2:-0} + 2)) 1 1)"; }
liar() { echo "exec python3 -B '$FATHOM_ROOT/tests/harness/liar.py' $*"; }

# Boxes as the tools for convex decomposition write them: a group each, with vertices of its own.
obj() {
  local k=0 x y z box
  for box in "$@"; do
    read -ra box <<<"$box"
    echo "${GROUP:-o} convex_$k"
    for z in 2 5; do for y in 1 4; do for x in 0 3; do echo "v ${box[x]} ${box[y]} ${box[z]}"; done; done; done
    for face in '1 3 4 2' '5 6 8 7' '1 2 6 5' '3 7 8 4' '1 5 7 3' '2 4 8 6'; do
      read -ra face <<<"$face"
      echo "f $((8 * k + face[0])) $((8 * k + face[1])) $((8 * k + face[2])) $((8 * k + face[3]))"
    done
    k=$((k + 1))
  done
}
