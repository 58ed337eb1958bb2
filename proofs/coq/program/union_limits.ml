(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Size and work of a certificate of format 3: verify/check/FORMAT.md, section 12, whose letters these are. *)
open Grammar
open Union_grammar
open Limits

type denominators = { of_points : Z.t; of_optima : Z.t; of_weights : Z.t }

let coordinates f { Proved.qx; qy; qz } = f qx; f qy; f qz
let sum f items = Array.fold_left (fun s item -> s + f item) Z.zero items

let is_leaf r = function Proved.Leaf far -> List.compare_length_with far r = 0 | Proved.Split _ -> false

let within g =
  let optima, polytopes, nodes, proof, claimed =
    match g.claim with
    | Depth (q, optima, polytopes, tree) -> (optima, polytopes, tree.items, None, q)
    | Touching p -> ([||], [||], [||], Some p, Q.zero)
    | Apart (q, p) -> ([||], [||], [||], Some p, q) in
  let lists =
    match proof with Some p -> [| p.separations |] | None -> Array.map (fun o -> o.way_separations) optima in
  let weights = match proof with Some p -> [| p.weights_a; p.weights_b |] | None -> [||] in
  let require = require g.end_line and common = common g.end_line in
  let points_a = sum count g.pieces_a and points_b = sum count g.pieces_b in
  let n = points_a + points_b and f = sum (fun p -> count p.facets) polytopes in
  let vectors = n + sum (fun p -> count p.vertices) polytopes + (number 3 * f) in
  let t = sum (fun p -> over (fun corners -> let k = number (Array.length corners) in k * k) p.facets) polytopes in
  let k = sum count lists and r = sum count weights and m = number (Array.length optima) in
  let of_points, w =
    common vectors (fun f -> List.iter (Array.iter (fun p -> Array.iter (coordinates f) p.items)) [ g.pieces_a; g.pieces_b ]) in
  let of_optima, e = common m (fun f -> Array.iter (fun o -> coordinates f o.way) optima) in
  let e = if optima = [||] then Z.zero else e in
  let of_weights, x = common r (fun f -> Array.iter (fun p -> Array.iter (fun (_, q) -> f (ratio q)) p.items) weights) in
  let widest part = Array.fold_left (fun u (x, y, z) -> largest [ u; bits x; bits y; bits z ]) Z.zero part.items in
  let u = Array.fold_left (fun u part -> Z.max u (widest part)) Z.zero lists in
  let v = w + number 32 in
  let b = match g.claim with Touching _ -> Z.zero | _ -> Z.max (bits (Q.num claimed)) (bits (Q.den claimed)) in
  let pieces part = number (Array.length part) in
  let s = number (Array.length lists) * ((pieces g.pieces_b * points_a) + (pieces g.pieces_a * points_b)) in
  let leaves r = sum (fun node -> if is_leaf r node then Z.one else Z.zero) nodes in
  let four = number 4 and sixteen = number 16 in
  let nine_v = number 9 * v in
  (* what it takes to see whether half-spaces are done that come of so many constraints *)
  let judged constraints many =
    let digits = (((number constraints * four) + number 3) * v) + b in
    sixteen * many * product digits (digits + e) in
  require (Z.leq ((vectors * v) + (k * u) + (m * e) + (r * x)) most_size);
  require
    (Z.leq
       ((s * product (w + e) u) + (sixteen * (n + t) * product v v) + (four * r * product (v + x) (v + x))
        + (number 8 * leaves 4 * product nine_v nine_v) + judged 0 f + judged 1 (leaves 1) + judged 2 (leaves 2) + judged 3 (leaves 3))
       most_work);
  { of_points; of_optima; of_weights }
