(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What the proved function is told beside the points: a common denominator, the claim, and for each edge a hint which facet lies across
   it.  Nothing here is trusted: what is printed is what the function accepts, of the points that it is given. *)
open Grammar

exception Refused of int * string

let demand line good reason = if not good then raise (Refused (line, reason))

(* ---- a common denominator ---- *)
let widen line count m d =
  if Z.divisible m d then m
  else begin
    let m = Z.lcm m d in
    if Z.numbits m > 8 * most_memory / (count + 1) then
      raise (Lines.Malformed (line, "expected points whose common denominator is smaller: this checker cannot hold them"));
    m
  end

let common_denominator g =
  let count = 3 * (Array.length g.a.items + Array.length g.b.items) in
  let of_points m (p : Proved.point part) =
    Array.fold_left (fun m { Proved.qx; qy; qz } -> List.fold_left (widen p.line count) m [ qx.den; qy.den; qz.den ]) m p.items in
  of_points (of_points Z.one g.a) g.b

let weights a b =
  let count = Array.length a.items + Array.length b.items in
  let of_weights m p = Array.fold_left (fun m (_, w) -> widen p.line count m (Q.den w)) m p.items in
  let unit = of_weights (of_weights Z.one a) b in
  let scaled m q = Z.mul (Q.num q) (Z.divexact m (Q.den q)) in
  let list p = Array.to_list (Array.map (fun (i, w) -> (i, scaled unit w)) p.items) in
  (unit, list a, list b)

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

let demand_ranges g =
  let m = Array.length g.a.items and n = Array.length g.b.items and v = Array.length g.vertices.items in
  Array.iteri
    (fun k (j, i) -> demand g.vertices.lines_of.(k) (in_range n j && in_range m i) "a vertex names a point that is not there")
    g.vertices.items;
  Array.iteri
    (fun k corners ->
       let line = g.facets.lines_of.(k) in
       demand line (Array.length corners >= 3) "a facet has fewer than three corners";
       demand line (Array.for_all (in_range v) corners) "a facet names a vertex that is not there")
    g.facets.items

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

let inner g =
  demand_ranges g;
  { Proved.vertices = Array.to_list g.vertices.items; facets = hinted g.facets.items }

(* ---- all of it ---- *)
let single g =
  demand g.directions.line ((not g.all) && Array.length g.directions.items = 1) "this claim takes exactly one direction, and some";
  fst (direction g.directions.items.(0))

let claim g =
  demand g.a.line (Array.length g.a.items > 0) "a body without points";
  demand g.b.line (Array.length g.b.items > 0) "a body without points";
  match g.claim with
  | Depth q ->
    Proved.Depth (Q.num q, Q.den q, g.all, Array.to_list (Array.map direction g.directions.items), inner g)
  | Bounds (lo, hi) ->
    let n = single g in
    Proved.Bounds (Q.num lo, Q.den lo, Q.num hi, Q.den hi, n, inner g)
  | Touching ->
    let n = single g in
    let unit, a, b = weights g.weights_a g.weights_b in
    Proved.Touching (n, unit, a, b)
  | Disjoint -> Proved.Disjoint (single g)
