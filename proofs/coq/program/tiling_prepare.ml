(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Format 5: what the proved function is told beside the points, the mesh and the pieces' corners, and why it said no.  Nothing here is
   trusted, as in prepare.ml and reasons.ml. *)
open Grammar
open Tiling_grammar
open Prepare

(* ---- hints ---- *)
(* a common denominator of some points *)
let common points = List.fold_left (fun m p -> Z.lcm m (Tiling_limits.common_denominator p)) Z.one points

(* the coordinates of one vector for all that are parallel *)
let axis { Proved.zx; zy; zz } =
  let first = List.find_opt (fun x -> Z.sign x <> 0) [ zx; zy; zz ] in
  let d = Z.gcd (Z.gcd zx zy) zz in
  match first with
  | None -> []
  | Some x -> let d = if Z.sign x < 0 then Z.neg d else d in [ Z.divexact zx d; Z.divexact zy d; Z.divexact zz d ]

module Flags = Map.Make (struct type t = Z.t list let compare = List.compare Z.compare end)

(* a number for each flag, the same for the same *)
let slots () =
  let known = ref Flags.empty and next = ref Z.one in
  (* the same facet asks for each of its corners *)
  let last = ref None in
  let normal n =
    match !last with
    | Some (m, found) when m == n -> found
    | _ -> let found = axis n in last := Some (n, found); found in
  fun n d i ->
    let flag = i :: axis d @ normal n in
    match Flags.find_opt flag !known with
    | Some slot -> slot
    | None ->
      let slot = !next in
      known := Flags.add flag slot !known;
      next := Z.succ slot;
      slot

(* ---- the pieces ---- *)
let tile g piece =
  let n = Array.length g.points.items in
  Array.iteri
    (fun k corners ->
       let line = piece.lines_of.(k) in
       demand line (Array.length corners >= 3) "a facet has fewer than three corners";
       demand line (Array.for_all (in_range n) corners) "a facet names a point that is not there")
    piece.items;
  let corners = Array.of_list (Tiling_limits.Numbers.elements (Tiling_limits.corners_of piece)) in
  let place = Hashtbl.create ~random:true 64 in
  Array.iteri (fun k i -> Hashtbl.replace place (Z.to_int i) (Z.of_int k)) corners;
  let m = common (Array.to_list (Array.map (fun i -> g.points.items.(Z.to_int i)) corners)) in
  demand piece.line (Z.leq (Z.mul (Limits.number (Array.length corners)) (Limits.bits m)) Limits.most_size)
    "the common denominator of this piece's points is too large";
  { Proved.tile_corners = Array.to_list corners;
    tile_sides = hinted (Array.map (Array.map (fun i -> Hashtbl.find place (Z.to_int i))) piece.items) }

let tiles g =
  let n = Array.length g.points.items in
  demand g.line_of_pieces (Array.length g.pieces > 0) "a solid without pieces";
  Array.iteri
    (fun k ((i, j), l) -> demand g.mesh.lines_of.(k) (List.for_all (in_range n) [ i; j; l ]) "a triangle names a point that is not there")
    g.mesh.items;
  ignore (Array.fold_left
      (fun (k, seen) { Proved.qx; qy; qz } ->
         let q (x : Proved.ratio) = { Q.num = x.num; den = x.den } in
         let p = (q qx, q qy, q qz) in
         demand g.points.lines_of.(k) (not (Union_prepare.Places.mem p seen)) "this point has been there before";
         (k + 1, Union_prepare.Places.add p () seen))
      (0, Union_prepare.Places.empty) g.points.items);
  Array.map (tile g) g.pieces

(* ---- why not: only the wording of a refusal hangs on this ---- *)
let find g tiles =
  let table = Proved.numbered (Array.to_list g.points.items) in
  Array.iteri
    (fun k (tile : Proved.tile) ->
       let piece = g.pieces.(k) in
       demand piece.line (tile.tile_sides <> []) "a piece without facets";
       match Proved.every (Proved.numbered_point table) tile.tile_corners with
       | None -> ()
       | Some corners ->
         let moved = Proved.centred (common (Proved.each snd corners)) corners in
         let facets = Proved.each snd (Proved.tile_facets moved tile.tile_sides) and moved = Proved.each snd moved in
         let all = Proved.numbered facets in
         List.iteri
           (fun j (f : Proved.facet) ->
              let line = piece.lines_of.(j) in
              demand line (Z.sign f.offset > 0) "the mean of the piece's corners is not strictly below this facet";
              demand line (Proved.facet_ok Z.zero Z.one all f)
                "this facet's corners are not on one plane or not in order, or it is not convex across an edge";
              demand line (Proved.supporting moved [ f ]) "a corner of the piece is above this facet")
           facets;
         demand piece.line (Proved.bounded facets) "no two facets face opposite sides";
         demand piece.line (Proved.distinct facets) "two facets of this piece lie in the same plane")
    tiles

let reason g tiles =
  match find g tiles with
  | () -> (g.line_of_pieces, "the pieces do not tile what the mesh encloses")
  | exception Refused (line, text) -> (line, text)
