(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Size and work of a certificate of format 2, and of format 4 but for what its patches add: verify/check/FORMAT.md, section 8, whose letters these are. *)
open Grammar
open Signed_grammar
open Limits

type denominators = { of_lengths : Z.t; of_parameters : Z.t; of_weights : Z.t; of_heights : Z.t }

let coordinates f { Proved.qx; qy; qz } = f qx; f qy; f qz
let each_vector f b =
  match b.core with
  | Proved.Points l -> List.iter f l
  | Proved.Terms ts ->
    List.iter (List.iter (fun { Proved.center; axis_u; axis_v; axis_w } -> List.iter f [ center; axis_u; axis_v; axis_w ])) ts
  | Proved.Half_space _ -> ()

let parameters f b = Array.iter (List.iter (fun (_, (x, y, z)) -> List.iter (fun q -> f (ratio q)) [ x; y; z ])) b.inner.items

(* what patches add: how wide the sides are; the size, of v; the work, of n, v and u *)
type added = { widest : Z.t; size : Z.t -> Z.t; work : Z.t -> Z.t -> Z.t -> Z.t }
let nothing_added = { widest = Z.zero; size = (fun _ -> Z.zero); work = (fun _ _ _ -> Z.zero) }

let within ?(added = nothing_added) g =
  let both f = f g.a; f g.b in
  let widest_of part = Array.fold_left (fun u (x, y, z) -> largest [ u; bits x; bits y; bits z ]) Z.zero part.items in
  let vertices, facets, weights_a, weights_b =
    match g.lower with
    | Facets (v, f) -> (v, f, nothing 0, nothing 0)
    | Weights (a, b) -> (nothing 0, nothing 0, a, b)
    | None_needed -> (nothing 0, nothing 0, nothing 0, nothing 0) in
  let n = number g.a.vectors + number g.b.vectors in
  let places b = Array.fold_left (fun s l -> s + number (List.length l)) Z.zero b.inner.items in
  let i = places g.a + places g.b in
  let lineality, rays, e =
    match g.cone with
    | Some c -> (c.lineality, c.rays, count c.differences)
    | None -> (nothing 0, nothing 0, Z.zero) in
  let r = count rays and j = count g.a.heights + count g.b.heights and f = count facets in
  let k = count g.directions + r + (number 2 * count lineality) in
  let t = over (fun corners -> let k = number (Array.length corners) in k * k) facets in
  let weights = count weights_a + count weights_b in
  let vectors = n + i + count vertices + (number 3 * f) + e in
  let require = require g.end_line in
  let common = common g.end_line in
  let of_points, w = common vectors (fun f -> both (each_vector (coordinates f))) in
  let of_parameters, y = common vectors (fun f -> both (parameters f)) in
  let of_weights, x = common weights (fun f -> List.iter (fun p -> Array.iter (fun (_, q) -> f (ratio q)) p.items) [ weights_a; weights_b ]) in
  let of_heights, h = common j (fun f -> both (fun b -> Array.iter (fun q -> f (ratio q)) b.heights.items)) in
  let v = w + if Z.equal i Z.zero then Z.zero else y in
  let u = largest [ widest_of g.directions; widest_of lineality; widest_of rays; added.widest ] in
  let digits q = number 2 * (bits (Q.num q) + bits (Q.den q)) in
  let b =
    digits g.a.radius + digits g.b.radius
    + match g.claim with Depth q | Apart q -> digits q | Touching -> Z.zero | Signed_bounds (lo, hi) -> digits lo + digits hi in
  let four = number 4 in
  let long = v + u + h in
  require (Z.leq ((vectors * v) + (weights * x) + (j * h) + added.size v) most_size);
  require
    (Z.leq
       (((n + i) * k * product v u) + ((n + (four * i) + (four * t)) * product v v) + (four * (k + f) * product v b)
        + (four * weights * product (v + x) (v + x))
        + (if Z.equal j Z.zero then Z.zero else four * n * product long long)
        + (e * (r + e) * product (v + u) (v + u)) + added.work (number g.a.vectors + number g.b.vectors) v u)
       most_work);
  (* lengths: also those that do not count, of radii and half-spaces *)
  let m = ref of_points in
  let length (r : Proved.ratio) = if not (Z.divisible !m r.den) then m := Z.lcm !m r.den in
  both (fun b ->
      length (ratio b.radius);
      match b.core with Proved.Half_space (normal, offset) -> coordinates length normal; length offset | _ -> ());
  { of_lengths = !m; of_parameters; of_weights; of_heights }
