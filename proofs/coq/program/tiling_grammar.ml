(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The grammar of format 5 about one solid (verify/check/FORMAT.md, section 14): from lines to a certificate as it stands there. *)
open Lines
open Grammar

type triangle = (Z.t * Z.t) * Z.t

type t = {
  points : Proved.point part;
  mesh : triangle part;
  line_of_pieces : int;
  pieces : Z.t array part array;
  claim_line : int;
  end_line : int;
}

let triangle f =
  spend f 3;
  let i = natural f in blank f;
  let j = natural f in blank f;
  ((i, j), natural f)

(* section 15 is about two bodies, of which nothing is proved here *)
let only_one r word =
  match r.text with
  | Whole s when has_prefix word s ->
    raise (Malformed (r.number, "a certificate about two bodies, which are solids or unions, is not read by this checker: use fathom-check"))
  | _ -> ()

let certificate r name =
  advance r;
  name_of r name;
  only_one r "plane ";
  only_one r "pieces_a ";
  let points = counted r "solid_a" "three rationals: a point" point in
  let mesh = part r "mesh" "three numbers: a triangle" triangle in
  advance r;
  let line_of_pieces = r.number in
  let count = words_of r "pieces and a count" "pieces " natural in
  let pieces = ref [] and got = ref 0 in
  while Z.gt count (Z.of_int !got) do
    advance r;
    spend (fields r "piece and a count") 1;
    pieces := counted r "piece" "a count and as many corners" facet :: !pieces;
    incr got
  done;
  advance r;
  only_one r "solid_b ";
  only_one r "pieces_b ";
  words_of r "claim solid" "claim solid" ignore;
  let claim_line = r.number in
  let size p = Array.length p.items in
  let pieces = Array.of_list (List.rev !pieces) in
  advance r;
  footer_at r "end and all counts again"
    (size points :: size mesh :: !got :: Array.to_list (Array.map size pieces));
  { points; mesh; line_of_pieces; pieces; claim_line; end_line = r.number }
