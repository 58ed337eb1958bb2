(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Size and work of a certificate as a whole, before anything is checked: verify/check/FORMAT.md, section 8, whose letters these are.  On
   the way the common denominators are found. *)
open Grammar

let most_size = Z.of_string "4000000000"
let most_work = Z.of_string "100000000000000"

type denominators = { of_points : Z.t; of_weights : Z.t }

let ( + ) = Z.add
let ( * ) = Z.mul
let number = Z.of_int
let count part = number (Array.length part.items)
let bits n = number (Z.numbits n)
let largest = List.fold_left Z.max Z.zero
let over f part = Array.fold_left (fun sum item -> sum + f item) Z.zero part.items

(* what a product of numbers of s and t digits takes *)
let product s t = (number 256 + Z.max s t) * (number 256 + Z.min (Z.min s t) (number 4000))

let require line good =
  if not good then raise (Lines.Malformed (line, "expected a certificate within the limits on size and work"))

(* The common denominator of the numbers that each_of goes through, and how many digits a number over it has.  There are to be many such
   numbers: a denominator that is too large for that is not pursued. *)
let common line many each_of =
  let m = ref Z.one and widest = ref Z.zero in
  each_of (fun (r : Proved.ratio) ->
      if not (Z.divisible !m r.den) then begin
        m := Z.lcm !m r.den;
        require line (Z.leq (many * bits !m) most_size)
      end;
      widest := Z.max !widest (bits r.num));
  (!m, bits !m + !widest)

let each_coordinate g f =
  let each { Proved.qx; qy; qz } = f qx; f qy; f qz in
  Array.iter each g.a.items;
  Array.iter each g.b.items

let each_weight g f =
  let each (_, q) = f (ratio q) in
  Array.iter each g.weights_a.items;
  Array.iter each g.weights_b.items

let widest_direction g =
  Array.fold_left (fun u (x, y, z) -> largest [ u; bits x; bits y; bits z ]) Z.zero g.directions.items

let widest_claimed g =
  let widest q = Z.max (bits (Q.num q)) (bits (Q.den q)) in
  match g.claim with
  | Depth q -> widest q
  | Bounds (lo, hi) -> Z.max (widest lo) (widest hi)
  | Touching | Disjoint -> Z.zero

let within g =
  let n = count g.a + count g.b and v = count g.vertices and k = count g.directions and f = count g.facets in
  let weights = count g.weights_a + count g.weights_b in
  let t = over (fun corners -> let k = number (Array.length corners) in k * k) g.facets in
  let vectors = n + v + (number 3 * f) in
  let of_points, w = common g.end_line vectors (each_coordinate g) in
  let of_weights, x = common g.end_line weights (each_weight g) in
  let u = widest_direction g and z = widest_claimed g and four = number 4 in
  require g.end_line (Z.leq ((vectors * w) + (weights * x)) most_size);
  require g.end_line
    (Z.leq
       ((n * k * product w u) + ((n + (four * t)) * product w w) + (four * (k + f) * product w z)
        + (four * weights * product (w + x) (w + x)))
       most_work);
  { of_points; of_weights }
