(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Why the proved function said no: its parts are asked one after the other.  Only the wording of a refusal hangs on this. *)
open Grammar
open Prepare

let directions_reason g test reason =
  Array.iteri
    (fun k n ->
       let n = fst (direction n) in
       let zero = List.for_all (Z.equal Z.zero) [ n.Proved.zx; n.Proved.zy; n.Proved.zz ] in
       let line = g.directions.lines_of.(k) in
       demand line (not zero) "a direction is zero: that proves nothing";
       demand line (test n) reason)
    g.directions.items

let inner_reason g (c : Proved.certificate) qn qd inner extra =
  demand g.facets.line (Array.length g.facets.items > 0) "the inner polytope has no facets";
  let fs = Proved.make_facets c.body_a c.body_b inner.Proved.vertices inner.Proved.facets in
  let table = Proved.numbered fs in
  List.iteri
    (fun k (f : Proved.facet) ->
       let line = g.facets.lines_of.(k) in
       let square = Z.mul f.offset f.offset in
       demand line (Z.sign f.offset > 0) "O is not strictly below this facet's plane";
       demand line
         (Z.leq (Z.mul qn (Proved.zdot f.normal f.normal)) (Z.mul square qd)) "this facet's plane is nearer than the claim";
       demand line (Proved.facet_ok qn qd table f)
         "this facet's corners are not on one plane or not in order, or it is not convex across an edge";
       extra line f)
    fs;
  demand g.facets.line (Proved.bounded fs) "no two facets face opposite sides"

let find ~width g (c : Proved.certificate) =
  demand g.b.line (not width || Proved.same_vectors c.body_a c.body_b) "the points of b are not those of a again";
  let square n = Z.mul n (Z.mul c.scale c.scale) in
  let a = c.body_a and b = c.body_b in
  match c.claimed with
  | Proved.Depth (qn, qd, complete, dirs, inner) ->
    let qn = square qn in
    demand g.claim_line (Z.sign qn > 0) "the squared depth is not positive";
    demand g.directions.line (dirs <> []) "no direction";
    directions_reason g (Proved.tangent a b qn qd) "this direction's plane is not at the depth claimed";
    if complete then demand g.directions.line (Proved.canonical dirs) "the directions are not primitive and strictly ascending";
    let listed = Proved.numbered (List.rev (List.rev_map fst dirs)) in
    inner_reason g c qn qd inner (fun line f ->
        if complete then demand line (Proved.listed qn qd listed inner.find f) "this facet is a nearest one, and its direction is not listed")
  | Proved.Bounds (ln, ld, hn, hd, _, inner) ->
    demand g.claim_line (Z.sign ln >= 0 && Z.sign hn > 0) "the bounds are not those of a depth";
    directions_reason g (Proved.within a b (square hn) hd) "this direction's plane is not within the upper bound";
    inner_reason g c (square ln) ld inner (fun _ _ -> ())
  | Proved.Touching (n, unit, wa, wb) ->
    directions_reason g (fun n -> match Proved.height a b n with Some h -> Z.sign h = 0 | None -> false)
      "the plane through O with this normal does not touch P";
    ignore n;
    demand g.weights_a.line (Proved.common_point a b unit wa wb) "the weights are not those of one common point"
  | Proved.Disjoint _ -> directions_reason g (fun _ -> false) "no plane with this normal lies between the bodies"

let reason ~width g c =
  match find ~width g c with
  | () -> (g.claim_line, "the claim is not proved")
  | exception Refused (line, text) -> (line, text)
