(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Size and work of a certificate of format 5: verify/check/FORMAT.md, section 14, whose letters these are. *)
open Grammar
open Tiling_grammar
open Limits

let common_denominator { Proved.qx; qy; qz } = Z.lcm qx.den (Z.lcm qy.den qz.den)

let width p =
  let d = common_denominator p in
  let over (x : Proved.ratio) = bits (Z.mul x.num (Z.divexact d x.den)) in
  bits d + largest [ over p.qx; over p.qy; over p.qz ]

module Numbers = Set.Make (Z)

(* the corners of a piece, each once, in ascending order *)
let corners_of piece = Array.fold_left (Array.fold_left (fun found k -> Numbers.add k found)) Numbers.empty piece.items

let within g =
  let n = count g.points and f = count g.mesh in
  let sum f = Array.fold_left (fun sum piece -> sum + f piece) Z.zero g.pieces in
  let c = sum (over (fun corners -> number (Array.length corners))) in
  let named piece = Numbers.fold (fun k named -> if Z.lt k n then named + Z.one else named) (corners_of piece) Z.zero in
  let s = sum (fun piece -> count piece * named piece) in
  let h = Array.fold_left (fun h p -> Z.max h (width p)) Z.zero g.points.items in
  let four_h = number 4 * h in
  require g.end_line (Z.leq ((n + (number 10 * f) + (number 4 * c)) * h) most_size);
  require g.end_line
    (Z.leq ((number 3 * ((number 3 * f) + c) * product four_h four_h) + (s * product (number 5 * h) h)) most_work)
