(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What the proved function is told beside the points: the claim with its proof, and hints: for each edge which facet lies across it, for
   each facet whose direction it has, for each direction why it is primitive.  Nothing here is trusted: what is printed is what the function accepts, of the points that it is given. *)
open Grammar

exception Refused of int * string

let demand line good reason = if not good then raise (Refused (line, reason))

let weights unit part =
  Array.to_list (Array.map (fun (i, w) -> (i, Z.mul (Q.num w) (Z.divexact unit (Q.den w)))) part.items)

(* what the proved function demands of a height, beside the width, which is not proved of the plane *)
let demand_height ~width plane rho highest =
  Option.iter
    (fun { height; height_line } ->
       demand height_line (not width) "bodies of the plane, whose width is not proved here";
       let left = Q.sub height rho in
       demand height_line (Q.sign left > 0) "the height is not above the sum of the radii";
       demand height_line (Q.lt highest (Q.mul left left)) "the height is not above the depth")
    plane

(* ---- directions ---- *)
(* g = a s + b t is the greatest common divisor *)
let bezout a b =
  if Z.equal a Z.zero then (Z.abs b, Z.zero, Z.of_int (Z.sign b))
  else if Z.equal b Z.zero then (Z.abs a, Z.of_int (Z.sign a), Z.zero)
  else Z.gcdext a b

(* the multiplier shows that the direction is primitive, where it is *)
let direction (x, y, z) =
  let g, s, t = bezout x y in
  let _, u, v = bezout g z in
  ({ Proved.zx = x; zy = y; zz = z }, { Proved.zx = Z.mul u s; zy = Z.mul u t; zz = v })

(* ---- the inner polytope ---- *)
let in_range n i = Z.lt i (Z.of_int n)

(* m and n: how many points there are of a and of b *)
let demand_ranges m n vertices facets =
  let v = Array.length vertices.items in
  Array.iteri
    (fun k (j, i) -> demand vertices.lines_of.(k) (in_range n j && in_range m i) "a vertex names a point that is not there")
    vertices.items;
  Array.iteri
    (fun k corners ->
       let line = facets.lines_of.(k) in
       demand line (Array.length corners >= 3) "a facet has fewer than three corners";
       demand line (Array.for_all (in_range v) corners) "a facet names a vertex that is not there")
    facets.items

let hinted (facets : Z.t array array) =
  let facets = Array.map (Array.map Z.to_int) facets in
  let across = Hashtbl.create ~random:true 1024 in
  let edges corners f =
    let k = Array.length corners in
    Array.iteri (fun i u -> f u corners.(if i + 1 = k then 0 else i + 1)) corners in
  (* of several facets with the same edge the first counts *)
  Array.iteri (fun g corners -> edges corners (fun u v -> if not (Hashtbl.mem across (u, v)) then Hashtbl.add across (u, v) g)) facets;
  let none = Z.of_int (Array.length facets) in
  let hint corners =
    let result = ref [] in
    edges corners (fun u v ->
        let g = match Hashtbl.find_opt across (v, u) with Some g -> Z.of_int g | None -> none in
        result := (Z.of_int u, g) :: !result);
    List.rev !result in
  Array.to_list (Array.map hint facets)

module Rays = Map.Make (struct
  type t = Z.t * Z.t * Z.t
  let compare (a, b, c) (x, y, z) =
    let first = Z.compare a x in
    if first <> 0 then first else let second = Z.compare b y in if second <> 0 then second else Z.compare c z
end)

(* the number of the primitive direction that a vector is a multiple of *)
let finder directions =
  let none = Z.of_int (Array.length directions) in
  let numbered = ref Rays.empty in
  Array.iteri (fun k n -> numbered := Rays.add n (Z.of_int k) !numbered) directions;
  fun { Proved.zx; zy; zz } ->
    let common = Z.gcd (Z.gcd zx zy) zz in
    if Z.equal common Z.zero then none
    else
      let part = Z.divexact in
      Option.value ~default:none (Rays.find_opt (part zx common, part zy common, part zz common) !numbered)

let inner m n vertices facets directions =
  demand_ranges m n vertices facets;
  { Proved.vertices = Array.to_list vertices.items; facets = hinted facets.items; find = finder directions.items }

(* ---- all of it ---- *)
let single all directions =
  demand directions.line ((not all) && Array.length directions.items = 1) "this claim takes exactly one direction, and some";
  fst (direction directions.items.(0))

let claim g (denominators : Limits.denominators) =
  demand g.a.line (Array.length g.a.items > 0) "a body without points";
  demand g.b.line (Array.length g.b.items > 0) "a body without points";
  let inner g = inner (Array.length g.a.items) (Array.length g.b.items) g.vertices g.facets g.directions in
  match g.claim with
  | Depth q ->
    Proved.Depth (Q.num q, Q.den q, g.all, Array.to_list (Array.map direction g.directions.items), inner g)
  | Bounds (lo, hi) ->
    let n = single g.all g.directions in
    Proved.Bounds (Q.num lo, Q.den lo, Q.num hi, Q.den hi, n, inner g)
  | Touching ->
    let n = single g.all g.directions in
    let unit = denominators.of_weights in
    Proved.Touching (n, unit, weights unit g.weights_a, weights unit g.weights_b)
  | Disjoint -> Proved.Disjoint (single g.all g.directions)
