(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The grammar of format 6 (verify/check/FORMAT.md, section 17): from lines to a certificate as it stands there. *)
open Lines
open Grammar

type ends = { of_a : (Z.t * Q.t) part; of_b : (Z.t * Q.t) part }
type direction = Of_b of (Z.t * Z.t * Z.t) | Of_a of (Z.t * Z.t * Z.t) | Of_edges of (Z.t * Z.t * Z.t) * (Z.t * Z.t * Z.t)
type kind = Apart of direction | Near of Q.t * ends
type piece = { piece_line : int; until : Q.t; kind : kind }
type claim = Never of { grazing : bool } | Contact of Q.t * ends

type t = {
  a : Proved.point part;
  b : Proved.point part;
  motions : (Proved.point, Proved.ratio) Proved.motion * (Proved.point, Proved.ratio) Proved.motion; (* of a, of b *)
  claim : claim;
  claim_line : int;
  pieces_line : int;
  pieces : piece array;
  end_line : int;
}

let quaternion f =
  spend f 4;
  let w = rational f in blank f;
  let x = rational f in blank f;
  let y = rational f in blank f;
  (ratio w, { Proved.qx = ratio x; qy = ratio y; qz = ratio (rational f) })

(* the line at hand is its word *)
let motion r word =
  words_of r (word ^ " alone on its line") word ignore;
  let next expected item =
    advance r;
    let f = fields r expected in
    let found = item f in
    finish f;
    found in
  let turn () = next "four rationals: a quaternion" quaternion and place () = next "three rationals: a place" point in
  let scalar, axis = turn () in
  let last_scalar, last_axis = turn () in
  let spot = place () in
  let last_spot = place () in
  advance r;
  { Proved.at_start = { Proved.spot; scalar; axis }; at_end = { Proved.spot = last_spot; scalar = last_scalar; axis = last_axis } }

(* from the line at hand to the one behind *)
let weights_at r word = let found = counted r word "the number of a point and its weight" weight in advance r; found

let ends_at r =
  let of_a = weights_at r "weights_a" in
  { of_a; of_b = weights_at r "weights_b" }

let piece r =
  let piece_line = r.number in
  let f = fields r "a piece: its end, b or a and three integers, ab and six, or near and a rational" in
  let until = rational f in
  blank f;
  let after word = let found = has_prefix word (String.sub f.s f.at (String.length f.s - f.at)) in if found then literal f word; found in
  let found =
    if after "ab " then begin
      spend f 1;
      let u = direction f in blank f;
      `Apart (Of_edges (u, direction f))
    end
    else if after "a " then (spend f 1; `Apart (Of_a (direction f)))
    else if after "b " then (spend f 1; `Apart (Of_b (direction f)))
    else if after "near " then (spend f 2; `Near (rational f))
    else wrong f in
  finish f;
  advance r;
  { piece_line; until; kind = (match found with `Apart d -> Apart d | `Near delta -> Near (delta, ends_at r)) }

let claim_of r =
  let f = fields r "claim apart, grazing or contact" in
  literal f "claim ";
  let claim =
    match f.s with
    | "claim apart" -> f.at <- String.length f.s; `Never false
    | "claim grazing" -> f.at <- String.length f.s; `Never true
    | _ -> literal f "contact "; `Contact (rational f) in
  finish f;
  claim

(* the counts of a part of weights, twice *)
let counts_of ends = [ Array.length ends.of_a.items; Array.length ends.of_b.items ]

let certificate r name =
  advance r;
  name_of r name;
  let a = counted r "a" "three rationals: a point" point in
  let b = part r "b" "three rationals: a point" point in
  advance r;
  let of_a = motion r "motion_a" in
  let motions = (of_a, motion r "motion_b") in
  let claim_line = r.number in
  let claimed = claim_of r in
  advance r;
  let pieces_line = r.number in
  let count = words_of r "pieces and a count" "pieces " natural in
  advance r;
  let pieces = ref [] and got = ref 0 in
  while Z.gt count (Z.of_int !got) do
    pieces := piece r :: !pieces;
    incr got
  done;
  let claim = match claimed with `Never grazing -> Never { grazing } | `Contact t -> Contact (t, ends_at r) in
  let pieces = Array.of_list (List.rev !pieces) in
  let of_piece p = match p.kind with Near (_, ends) -> counts_of ends | Apart _ -> [] in
  footer_at r "end and all counts again"
    (Array.length a.items :: Array.length b.items :: !got
     :: (List.concat_map of_piece (Array.to_list pieces) @ match claim with Contact (_, ends) -> counts_of ends | Never _ -> []));
  { a; b; motions; claim; claim_line; pieces_line; pieces; end_line = r.number }
