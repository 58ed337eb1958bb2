(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Size and work of a certificate of format 6, as verify/check/FORMAT.md, section 17, has them, whose letters these are; and what the
   proved function is told: the claim with its proof. Nothing here is trusted. *)
open Grammar
open Impact_grammar
open Limits

type units = { of_points : Z.t; of_turns : Z.t; of_weights : Z.t }

let each_point f { Proved.qx; qy; qz } = f qx; f qy; f qz
let poses { motions = a, b; _ } = [ a.at_start; a.at_end; b.at_start; b.at_end ]

(* the ends of pieces that are near, and the contact *)
let each_end f g =
  Array.iter (fun p -> match p.kind with Near (_, ends) -> f ends | Apart _ -> ()) g.pieces;
  match g.claim with Contact (_, ends) -> f ends | Never _ -> ()

let within g =
  let n = count g.a + count g.b in
  let k = ref 0 and ends = ref 0 and r = ref 0 and u = ref Z.zero and b = ref Z.one in
  let take_number q = b := Z.max !b (bits (Q.num q) + bits (Q.den q)) in
  let take_vector (x, y, z) = u := largest [ !u; bits x; bits y; bits z ] in
  Array.iter
    (fun p ->
       take_number p.until;
       match p.kind with
       | Near (delta, _) -> take_number delta
       | Apart d ->
         incr k;
         (match d with Of_a v | Of_b v -> take_vector v | Of_edges (v, w) -> take_vector v; take_vector w))
    g.pieces;
  (match g.claim with Contact (t, _) -> take_number t | Never _ -> ());
  each_end (fun e -> incr ends; r := Stdlib.( + ) !r (Stdlib.( + ) (Array.length e.of_a.items) (Array.length e.of_b.items))) g;
  let four = number 4 and k = number !k and ends = number !ends and r = number !r and u = !u and b = !b in
  let of_points, w =
    common g.end_line (n + four) (fun f ->
        Array.iter (each_point f) g.a.items;
        Array.iter (each_point f) g.b.items;
        List.iter (fun (o : _ Proved.pose) -> each_point f o.spot) (poses g)) in
  let of_turns, y =
    common g.end_line four (fun f -> List.iter (fun (o : _ Proved.pose) -> f o.scalar; each_point f o.axis) (poses g)) in
  let of_weights, x =
    common g.end_line r (fun f ->
        each_end (fun e -> List.iter (fun part -> Array.iter (fun (_, q) -> f (ratio q)) part.items) [ e.of_a; e.of_b ]) g) in
  require g.end_line (Z.leq (((n + four) * w) + (four * y) + (r * x) + (number 2 * k * u)) most_size);
  let z = (number 2 * w) + (four * y) + (number 12 * b) + (number 2 * u) + number 32 in
  require g.end_line
    (Z.leq
       ((number 6 * n * k * product z w) + (((number 200 * k) + (number 8 * n * ends)) * product z z)
        + (four * r * product (z + x) (z + x)))
       most_work);
  { of_points; of_turns; of_weights }

let vector (x, y, z) = { Proved.zx = x; zy = y; zz = z }
let points_of units ends =
  { Proved.unit_of = units.of_weights; weights_of_a = Prepare.weights units.of_weights ends.of_a;
    weights_of_b = Prepare.weights units.of_weights ends.of_b }

let piece units p =
  match p.kind with
  | Apart (Of_b n) -> Proved.Apart (ratio p.until, Proved.Of_b (vector n))
  | Apart (Of_a n) -> Proved.Apart (ratio p.until, Proved.Of_a (vector n))
  | Apart (Of_edges (f, h)) -> Proved.Apart (ratio p.until, Proved.Of_edges (vector f, vector h))
  | Near (delta, ends) -> Proved.Near (ratio p.until, ratio delta, points_of units ends)

let claim units g =
  let demand = Prepare.demand in
  demand g.a.line (Array.length g.a.items > 0) "a body without points";
  demand g.b.line (Array.length g.b.items > 0) "a body without points";
  let pieces = List.map (piece units) (Array.to_list g.pieces) in
  let near = Array.exists (fun p -> match p.kind with Near _ -> true | Apart _ -> false) g.pieces in
  match g.claim with
  | Never { grazing } ->
    demand g.claim_line (near = grazing) "near goes with a claim of grazing, which has one, or of contact";
    Proved.Never pieces
  | Contact (t, ends) -> Proved.Meeting (pieces, ratio t, points_of units ends)

(* why not: only the wording of a refusal hangs on this *)
let reason units (g : t) =
  let integral f = List.map f in
  let m = units.of_points in
  let a = integral (Proved.integral m) (Array.to_list g.a.items) and b = integral (Proved.integral m) (Array.to_list g.b.items) in
  let of_a, of_b = g.motions in
  let of_a = Proved.integral_motion m units.of_turns of_a and of_b = Proved.integral_motion m units.of_turns of_b in
  let near t delta ends = Proved.near_at m a b of_a of_b (ratio t) (ratio delta) (points_of units ends) in
  let rec find s free = function
    | [] -> if free || g.pieces = [||] then (g.claim_line, "the pieces do not end where the claim says") else (g.pieces_line, "near stands last")
    | p :: rest ->
      if Q.lt p.until s || Q.gt p.until Q.one then (p.piece_line, "this piece is not behind the one before, or ends after the time 1")
      else
        match piece units p with
        | Apart (e, f) when not (Proved.apart_on a b of_a of_b (ratio s) e f) ->
          (p.piece_line, "this direction does not show that the bodies are apart on the piece")
        | Near (_, d, _) when not (free && Z.geq d.num Z.zero) -> (p.piece_line, "near stands first, or behind another, or has a negative distance")
        | Near _ when (match p.kind with Near (d, ends) -> not (near p.until d ends) | Apart _ -> false) ->
          (p.piece_line, "the weights do not yield points that are so near")
        | Apart _ -> find p.until true rest
        | Near _ -> find p.until false rest in
  match (find Q.zero false (Array.to_list g.pieces), g.claim) with
  | (line, _), Contact (t, ends) when line = g.claim_line && not (near t Q.zero ends) -> (line, "the weights do not yield a common point")
  | found, _ -> found
