#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# mutants.sh OUT   falsifies, in one way after another, what the front end tells the proved function beside the points, and demands that the
#                  program so built prints nothing untrue all the same. OUT holds the compiled program.
set -u
here=$(dirname -- "$(readlink -f -- "$0")")
out=$(readlink -f -- "$1")/program
forgeries=$here/examples/proved_forgeries.cert
cubes=$here/../../tests/data/certificates
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT
bad=0
complain() { echo "mutants.sh: $*"; bad=1; }

build() { # SED-SCRIPT
  rm -rf "$scratch/program" && mkdir "$scratch/program" && cd "$scratch/program" || exit 1
  cp "$here"/program/*.ml "$out"/proved.cmi "$out"/proved.cmx "$out"/proved.o .
  told="limits.ml prepare.ml signed_limits.ml signed_prepare.ml patch_prepare.ml union_limits.ml union_prepare.ml tiling_prepare.ml impact_prepare.ml"
  # shellcheck disable=SC2086
  cat $told >before
  # shellcheck disable=SC2086
  sed -i "$1" $told
  # shellcheck disable=SC2086
  ! cat $told | cmp -s - before || complain "nothing to falsify: $1"
  # shellcheck disable=SC2046
  ocamlfind ocamlopt -w -a -package zarith -linkpkg proved.cmx $(ocamlfind ocamldep -sort ./*.ml) -o mutant || complain "cannot be built: $1"
}

# the certificates come on standard input; a line with the name has the first pattern behind s, and none has the second
mutant() { # SED-SCRIPT NAME TRUE FORGED
  build "$1"
  lines=$(./mutant - | grep -E "[ ]$2(:|\$)")
  printf '%s\n' "$lines" | grep -qE "^s $3" || complain "with $1 expected $3, but it is: $lines"
  ! printf '%s\n' "$lines" | grep -E "^s VERIFIED $4" || complain "with $1 an untrue line is printed"
}

# seven of the eight nearest facets are listed as all
mutant 's/g\.all, Array/false, Array/' an%20optimum%20missing 'VERIFIED penetrating depth_squared=1/3 an' '.*optima=' <"$forgeries"
mutant 's/Rays\.find_opt (/(fun _ _ -> Some Z.zero) (/' an%20optimum%20missing REFUSED '' <"$forgeries"
# 334/1000 is claimed where it is 1/3
mutant 's/Proved\.Depth (Q\.num q, Q\.den q/Proved.Depth (Z.one, Z.of_int 3/' more%20than%20the%20depth \
  'VERIFIED penetrating depth_squared=1/3 more' '.*depth_squared=167/500' <"$forgeries"
# two cubes of squared depth 1 are said to have at most 3/4
sed 's,^claim bounds .*,claim bounds 1/2 3/4,' "$cubes/bounds_cubes.cert" >"$scratch/bounds"
mutant 's/Q\.num hi, Q\.den hi/Z.of_int 16, Z.of_int 5/' '[^ ]*' 'VERIFIED penetrating depth_squared_in=\[1/2,16/5\]' '.*,3/4\]' <"$scratch/bounds"
# two cubes that are apart are said to touch
sed 's/^claim disjoint/claim touching/; s/^end .*/weights_a 1\n0 1\nweights_b 1\n0 1\nend 8 8 1 1 1/' "$cubes/disjoint_cubes.cert" >"$scratch/touching"
mutant 's/^  | Touching ->/  | Touching -> Proved.Disjoint (single g.all g.directions) | Touching ->/' '[^ ]*' 'VERIFIED disjoint' 'touching' <"$scratch/touching"
# two points that a wrong common denominator would move to the same place
{
  printf 'fathom-certificate 1\na 1\n1/3 0 0\nb 1\n-1/2 0 0\nclaim touching\ndirections 1 some\n1 0 0\n'
  printf 'weights_a 1\n0 1\nweights_b 1\n0 1\nend 1 1 1 1 1\n'
} >"$scratch/points"
mutant 's/{ of_points;/{ of_points = Z.one;/' '[^ ]*' REFUSED '' <"$scratch/points"
# format 2: a wrong unit, a wrong sum of the radii, another distance than is claimed, an optimum left out
signed=$here/examples/proved_signed.cert
mutant 's/of_lengths = !m/of_lengths = Z.one/' rounded%20cubes REFUSED '' <"$signed"
mutant 's/Q\.add g\.a\.radius g\.b\.radius/Q.add Q.one g.b.radius/' touching%20spheres REFUSED '' <"$signed"
mutant 's/beside q a b None/beside (Q.of_int 25) a b None/' farther%20than%20they%20are \
  'VERIFIED touching signed_depth=-sqrt\(25\)\+5 ' '.*26' <"$signed"
mutant 's/map direction c\.rays\.items/map direction (Array.sub c.rays.items 0 (max 0 (Array.length c.rays.items - 1)))/' tip%20to%20tip REFUSED '' <"$signed"
# format 4: a wrong unit of a corner or of a rate, another rate than is claimed, a corner twice that the order leaves out, a corner whose
# side is another one's
patches=$here/examples/proved_patches.cert
mutant 's/corner_unit = unit/corner_unit = Z.one/' rods REFUSED '' <"$patches"
mutant 's/rate_unit = !unit/rate_unit = Z.one/' rods REFUSED '' <"$patches"
mutant 's/rate_square = ratio (.*); rate_unit/rate_square = ratio Q.one; rate_unit/' rods REFUSED '' <"$patches"
mutant 's/Z\.of_int order)/Z.of_int (Array.sub order (min 1 c) (max 0 (Int.pred c))))/' a%20corner%20twice REFUSED '' <"$patches"
mutant 's/named_by = named\.(k)/named_by = Z.zero/' a%20corner%20that%20no%20side%20names REFUSED '' <"$patches"
# format 3: wrong units of the points and of the optima, another depth or distance than is claimed, an optimum or a node left out,
# wrong hints
unions=$here/examples/proved_unions.cert
mutant 's/{ of_points; of_optima;/{ of_points = Z.one; of_optima;/' a%20seam%20in%20thirds REFUSED '' <"$unions"
mutant 's/( Q\.num q, Q\.den q, d\.of_optima/( Q.num q, Q.den q, Z.one/' a%20seam%20in%20thirds REFUSED '' <"$unions"
sed '/^id a%20seam%20in%20thirds/,/^end/s,^claim depth 1/9,claim depth 1/8,' "$unions" >"$scratch/thirds"
mutant 's/( Q\.num q, Q\.den q, d\.of_optima/( Z.one, Z.of_int 9, d.of_optima/' a%20seam%20in%20thirds \
  'VERIFIED penetrating depth_squared=1/9 optima=1 pieces=2x1 a' '.*depth_squared=1/8' <"$scratch/thirds"
mutant 's/Union_apart (Q\.num q/Union_apart (Z.of_int 9/' farther%20than%20they%20are \
  'VERIFIED disjoint distance_squared=9 pieces=2x2 farther' '.*=10' <"$unions"
mutant 's/:: l) \[\] optima) in$/:: l) [] (Array.sub optima 0 (max 0 (Array.length optima - 1)))) in/' \
  five%20ways%20out REFUSED '' <"$unions"
mutant 's/Array\.to_list tree\.items/[]/' five%20ways%20out REFUSED '' <"$unions"
mutant 's/Some column -> Array\.to_list column/Some column -> Array.to_list (Array.map Z.neg column)/' a%20cell%20of%20nothing REFUSED '' <"$unions"
mutant 's/if r > 4 then \[\]/if r > 1 then List.map (fun _ -> Z.minus_one) half_spaces/' where%20three%20planes%20meet REFUSED '' <"$unions"
mutant 's/Places\.find_opt (/(fun _ _ -> Some Z.zero) (/' five%20ways%20out REFUSED '' <"$unions"
mutant 's/  demand_ranges (size.*/  ();/' a%20vertex%20of%20no%20point REFUSED '' <"$unions"
# the plane: a height that is not looked at
planes=$here/examples/proved_planes.cert
mutant 's/^    plane$/    None/' 'as%20low%20as[^ :]*' REFUSED '' <"$planes"
# format 5: a wrong unit, flags taken for one another or not found again, facets across an edge that are not, a piece left out
tilings=$here/examples/proved_tilings.cert
mutant 's/Z\.lcm m (Tiling_limits/Z.mul Z.zero (Tiling_limits/' a%20box%20in%20thirds REFUSED '' <"$tilings"
mutant 's/next := Z\.succ slot/next := slot/' a%20box%20in%20thirds REFUSED '' <"$tilings"
mutant 's/Flags\.find_opt flag !known/(if true then None else Flags.find_opt flag !known)/' a%20box%20in%20thirds REFUSED '' <"$tilings"
mutant 's/Some g -> Z\.of_int g | None/Some g -> Z.of_int (g mod 2) | None/' a%20box%20in%20thirds REFUSED '' <"$tilings"
mutant 's/Array\.map (tile g) g\.pieces/Array.map (tile g) (Array.sub g.pieces 0 1)/' a%20box%20in%20thirds REFUSED '' <"$tilings"
# format 6: wrong units, another time or distance than is claimed, pieces left out
motions=$here/examples/proved_motions.cert
mutant 's/{ of_points; of_turns;/{ of_points = Z.one; of_turns;/' a%20rod%20in%20thirds REFUSED '' <"$motions"
mutant 's/{ of_points; of_turns;/{ of_points; of_turns = Z.one;/' a%20rod%20in%20thirds REFUSED '' <"$motions"
mutant 's/Proved\.unit_of = units\.of_weights/Proved.unit_of = Z.one/' a%20rod%20in%20thirds REFUSED '' <"$motions"
mutant 's/Proved\.Meeting (pieces, ratio t/Proved.Meeting (pieces, ratio (Q.of_ints 5 8)/' a%20turning%20rod REFUSED '' <"$motions"
mutant 's/Proved\.Near (ratio p\.until, ratio delta/Proved.Near (ratio p.until, ratio (Q.of_int 2)/' farther%20than%20said \
  'VERIFIED grazing until=1 near=\(7\/16,9\/16\):2 farther' '.*:1 ' <"$motions"
mutant 's/List\.map (piece units) (Array\.to_list g\.pieces)/[]/' a%20turning%20rod REFUSED '' <"$motions"
exit $bad
