#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# examples.sh PROGRAM   runs the program on each example, which says in its lines "#= .." what must come out (reasons aside).
set -u
here=$(dirname -- "$(readlink -f -- "$0")")
program=$(readlink -f -- "$1")
cd "$here/examples" || exit 1
bad=0
for file in *.cert; do
  expected=$(sed -n 's/^#= //p' "$file")
  got=$("$program" "$file"; echo "exit $?")
  got=$(printf '%s\n' "$got" | sed -E 's/^(s (REFUSED|MALFORMED) [^ ]*):[0-9]+: .*/\1/')
  [ -n "$expected" ] && [ "$got" = "$expected" ] && continue
  printf '%s: expected\n%s\nbut it is\n%s\n' "$file" "$expected" "$got"
  bad=1
done

stack='' # the program gets but so many KiB: of the system's stack, and of that which OCaml 5 has of its own
expect() { # EXIT-CODE PATTERN ARGUMENTS..; standard input is passed on
  code=$1 pattern=$2
  shift 2
  got=$([ -z "$stack" ] || { ulimit -s "$stack" && export OCAMLRUNPARAM="l=$((stack / 8))k"; } && "$program" "$@" 2>&1)
  status=$?
  if [ "$status" = "$code" ] && printf '%s\n' "$got" | grep -qE "$pattern"; then return; fi
  printf 'fathom-check-proved %s: expected exit code %s and %s, but it is %s and\n%s\n' "$*" "$code" "$pattern" "$status" "$got"
  bad=1
}

# what is no certificate at all: a verdict and an exit code, never a crash
expect 2 '^usage' </dev/null
expect 2 '^usage' --nonsense </dev/null
expect 0 '^usage' --help </dev/null
expect 2 '^s MALFORMED <stdin>:1: ' - </dev/null
expect 2 '^s MALFORMED /nowhere/50%25:0: ' /nowhere/50% </dev/null
expect 2 '^s MALFORMED /:' / </dev/null
expect 0 '^s VERIFIED penetrating depth_squared=1 optima=2 width%20of%20a%20box$' -- - <proved_width.cert
expect 2 '^s MALFORMED <stdin>:1: ' - <"$program"
expect 0 '^s VERIFIED penetrating depth_squared=1 optima=2 width%20of%20a%20box$' --width - <proved_width.cert
expect 1 '^s REFUSED apart:[0-9]+: the points of b are not those of a again$' --width -- proved_statuses.cert </dev/null
expect 2 '^usage' --width </dev/null
for words in --help proved_width.cert; do
  said=$("$program" "$words" 2>&1 >/dev/full)
  status=$?
  [ "$status" = 2 ] && [ "$said" = 'fathom-check-proved: cannot write: No space left on device' ] && continue
  printf 'fathom-check-proved %s >/dev/full: exit code %s and\n%s\n' "$words" "$status" "$said"
  bad=1
done

# a name that would pass for a longer line
expect 2 '^s MALFORMED <stdin>:2: ' - <<'CERTIFICATE'
fathom-certificate 1
id optima=1 x
a 1
0 0 0
b 1
1 0 0
claim disjoint
directions 1 some
-1 0 0
end 1 1 1 0 0
CERTIFICATE
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
printf 'fathom-certificate 1\na 1\n0 0 0\nb 1\n0/7 0 0\nclaim touching\ndirections 1 some\n1 0 0\nweights_a 1\n0 1\nweights_b 1\n0 1\nend 1 1 1 1 1\n' \
  >"$folder/optima=1 x"
expect 0 '^s VERIFIED touching depth_squared=0 .*/optima=1%20x$' --width "$folder/optima=1 x" </dev/null

# size: 100,000 points a body, doubled facets, a facet of 16,000 corners, in 256 KiB of stack
many() { yes -- "$1" | head -n "$2"; }
copies() { # COUNT, of what comes on standard input, of at most a kilobyte
  text=$(cat)
  many "$text" "$(($1 * $(printf '%s\n' "$text" | wc -l)))"
}
large() { # EXTRA-POINTS EXTRA-FACETS CORNERS-OF-THE-LAST
  points='0 0 0@3 0 0@0 2 0@3 2 0@0 0 1@3 0 1@0 2 1@3 2 1'
  echo "fathom-certificate 1"
  for body in a b; do
    echo "$body $((8 + $1))"
    printf '%s\n' "$points" | tr '@' '\n'
    many '1/3 1/2 5/7' "$1"
  done
  printf 'claim depth 1\ndirections 2 all\n0 0 -1\n0 0 1\nvertices 8\n'
  printf '%s\n' '0 7' '1 6' '2 5' '3 4' '4 3' '5 2' '6 1' '7 0'
  echo "facets $((6 + $2))"
  printf '%s\n' '4 1 3 7 5' '4 0 4 6 2' '4 2 6 7 3' '4 0 1 5 4' '4 4 5 7 6'
  many '4 4 5 7 6' "$2"
  echo "$3$(many ' 0 2 3 1' "$(($3 / 4))" | tr -d '\n')"
  echo "end $((8 + $1)) $((8 + $1)) 2 8 $((6 + $2))"
}
scratch=$folder/large
stack=256
large 100000 0 4 >"$scratch"
expect 0 '^s VERIFIED penetrating depth_squared=1 optima=2 <stdin>$' - <"$scratch"
large 0 100000 4 >"$scratch"
expect 0 '^s VERIFIED penetrating depth_squared=1 optima=2 <stdin>$' - <"$scratch"
large 0 0 16000 >"$scratch"
expect 1 '^s REFUSED <stdin>:' - <"$scratch"

# format 2: a sum of many terms, cut off and whole; many vectors of a lineality; and the file behind it is judged
terms() { # TERMS LINES-OF-A-TERM
  printf 'fathom-certificate 2\nshape_a %s\n' "$1"
  printf '%b' "$2" | copies "$1"
}
terms 600000 'term 0\n' >"$scratch"
expect 2 '^s MALFORMED .*:600003: expected .*, but the text ends$' "$scratch" proved_width.cert </dev/null
expect 2 '^s VERIFIED penetrating depth_squared=1 optima=2 width' "$scratch" proved_width.cert </dev/null
{
  terms 300000 'term 1\npoint 0 0 1\n'
  printf 'halfspace_b 0 0 1 0\nclaim signed_bounds -300000 -300000\ndirections 1 some\n0 0 1\nheights_a 300000\n'
  many -1 300000
  printf 'inner_a 1\n0 0 0 0%s\nend 300000%s 1 300000 1\n' "$(many ' 0 0 0 0' 299999 | tr -d '\n')" "$(many ' 1' 300000 | tr -d '\n')"
} >"$scratch"
expect 0 '^s VERIFIED disjoint signed_depth_in=\[-300000,-300000\] <stdin>$' - <"$scratch"
{
  printf 'fathom-certificate 2\na 1\n0 0 0\nb 1\n0 0 0\nclaim touching\ndirections 1 some\n0 0 1\nweights_a 1\n0 1\nweights_b 1\n0 1\nlineality 1000000\n'
  many '1 0 0' 1000000
  printf 'rays 0\ndifferences 0\nend 1 1 1 1 1 1000000 0 0\n'
} >"$scratch"
expect 1 '^s REFUSED <stdin>:' - <"$scratch"

# patches: many sides and rates; and many corners, all at one point
patch() { # CORNERS WEIGHTS SIDES RATES
  printf 'fathom-certificate 4\na 1\n0 0 0\nhalfspace_b 0 0 1 0\nclaim touching\ndirections 1 some\n0 0 1\npatches 1\n'
  printf 'patch %s %s\n' "$1" "$((4 * $3))"
  echo "$2$(many " 0 1/$2" "$2" | tr -d '\n') 0" | copies "$1"
  printf 'a 0 1 0 0\na -1 0 0 0\na 0 -1 0 0\na 1 0 0 0\n' | copies "$3"
  echo "rates $4"
  many '0 0 1 0 0 0 -1 1' "$4"
  echo "end 1 1 1 $1 $((4 * $3)) $4"
}
for counts in '1 50 1 1' '1 1 200000 1' '1 1 1 200000'; do
  # shellcheck disable=SC2086
  patch $counts >"$scratch"
  expect 0 "^s VERIFIED touching signed_depth=sqrt\(0\)\+0 patches=1 rates=${counts##* } <stdin>\$" - <"$scratch"
done
patch 200000 1 1 1 >"$scratch"
expect 1 '^s REFUSED <stdin>:' - <"$scratch"

# unions: many pieces, optima's separations, polytopes; a tree as deep as it is long, and one node with all the others below it
box() { # NAME LOW-X HIGH-X LOW-Y HIGH-Y LOW-Z HIGH-Z
  printf '%s 8\n' "$1"
  for z in "$6" "$7"; do for y in "$4" "$5"; do printf '%s %s %s\n' "$2" "$y" "$z" "$3" "$y" "$z"; done; done
}
slab() { # PIECES POLYTOPES SPLITS CHILDREN
  printf 'fathom-certificate 3\npieces_a %s\n' "$1"
  box a 0 1 0 1 0 1 | copies "$1"
  printf 'pieces_b 1\n'
  box b -3 4 0 4 -3 4
  printf 'claim depth 1\noptima 1\noptimum 0 -1 0\nseparations %s\n' "$1"
  echo '0 -1 0' | copies "$1"
  echo "polytopes $2"
  {
    printf 'polytope 0 0\nvertices 8\n'
    printf '%s\n' '0 7' '1 6' '2 5' '3 4' '4 3' '5 2' '6 1' '7 0' 'facets 6' '4 0 4 6 2' '4 1 3 7 5' '4 0 1 5 4' '4 2 6 7 3' \
      '4 0 2 3 1' '4 4 5 7 6'
  } | copies "$2"
  echo "tree $(($3 + $4))"
  [ "$3" = 1 ] || many 'split 0 2' "$(($3 - 1))"
  echo "split 0$(many ' 2' "$4" | tr -d '\n')"
  seq -f 'leaf %.0f' 0 "$(($4 - 1))"
  echo "end $1 $(many 8 "$1" | tr '\n' ' ')1 8 1 $1 $2 $(many '8 6' "$2" | tr '\n' ' ')$(($3 + $4))"
}
for counts in '20000 1 1 1' '1 20000 1 1' '1 1 200000 1' '1 1 1 200000'; do
  # shellcheck disable=SC2086
  slab $counts >"$scratch"
  expect 0 "^s VERIFIED penetrating depth_squared=1 optima=1 pieces=${counts%% *}x1 <stdin>\$" - <"$scratch"
done

# solids: many triangles, pieces, points
tiling() { # PIECES FLAT-TRIANGLES POINTS-THAT-NOTHING-USES
  printf 'fathom-certificate 5\nsolid_a %s\n' "$((8 + $3))"
  box a 0 1 0 1 0 1 | tail -n 8
  seq -f '%.0f 1/3 2' 1 "$3"
  echo "mesh $((12 * $1 + $2))"
  printf '%s\n' '0 4 6' '0 6 2' '1 3 7' '1 7 5' '0 1 5' '0 5 4' '2 6 7' '2 7 3' '0 2 3' '0 3 1' '4 5 7' '4 7 6' | copies "$1"
  [ "$2" = 0 ] || many '0 1 0' "$2"
  echo "pieces $1"
  printf '%s\n' 'piece 6' '4 0 4 6 2' '4 1 3 7 5' '4 0 1 5 4' '4 2 6 7 3' '4 0 2 3 1' '4 4 5 7 6' | copies "$1"
  echo "claim solid
end $((8 + $3)) $((12 * $1 + $2)) $1 $(many 6 "$1" | tr '\n' ' ' | sed 's/ $//')"
}
for counts in '20000 0 0' '1 200000 0' '1 0 200000'; do
  # shellcheck disable=SC2086
  tiling $counts >"$scratch"
  flat=${counts#* }
  expect 0 "^s VERIFIED solid triangles=$((12 * ${counts%% *} + ${flat%% *})) pieces=${counts%% *} <stdin>\$" - <"$scratch"
done
expect 2 '^s REFUSED a%20box%20in%20thirds:[0-9]+: a solid, which has no width here$' --width -- proved_tilings.cert </dev/null
exit $bad
