(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The grammar of format 3 (verify/check/FORMAT.md, section 12): from lines to a certificate as it stands there. *)
open Lines
open Grammar

type vector = Z.t * Z.t * Z.t

type optimum = { optimum_line : int; way : Proved.point; way_separations : vector part }
type polytope = { polytope_line : int; pair : Z.t * Z.t; vertices : (Z.t * Z.t) part; facets : Z.t array part }
type proof = { separations : vector part; near_line : int; near : Z.t * Z.t; weights_a : (Z.t * Q.t) part; weights_b : (Z.t * Q.t) part }

type claim =
  | Depth of Q.t * optimum array * polytope array * Proved.node part
  | Touching of proof
  | Apart of Q.t * proof

type t = {
  plane : plane option;
  line_a : int;
  pieces_a : Proved.point part array;
  line_b : int;
  pieces_b : Proved.point part array;
  claim : claim;
  claim_line : int;
  end_line : int;
}

let node f =
  let rest () =
    let found = ref [] in
    while not (at_end f) do blank f; spend f 1; found := natural f :: !found done;
    List.rev !found in
  spend f 1;
  if has_prefix "split" f.s then begin
    literal f "split ";
    spend f 1;
    let by = natural f in
    Proved.Split (by, rest ())
  end
  else (literal f "leaf"; Proved.Leaf (rest ()))

let pair_behind r word = words_of r (word ^ " and two numbers") (word ^ " ") pair

let certificate r name =
  advance r;
  name_of r name;
  (* what was announced, the last one first: 0 until all of it is there *)
  let plane = plane_of r in
  let expected, of_a_body = points_of plane in
  let counts = ref [] in
  let announce n = counts := n :: !counts in
  let listed word expected item =
    let found = counted r word expected item in
    announce (Array.length found.items);
    advance r;
    found in
  (* things of several lines each: item leaves the line behind it at hand *)
  let several word item =
    let count = words_of r (word ^ " and a count") (word ^ " ") natural in
    let above = !counts in
    counts := [];
    advance r;
    let found = ref [] and got = ref 0 in
    while Z.gt count (Z.of_int !got) do
      found := item () :: !found;
      incr got
    done;
    counts := List.rev_append (List.rev !counts) (!got :: above);
    Array.of_list (List.rev !found) in
  let pieces x =
    let line = r.number in
    (line, several ("pieces_" ^ x) (fun () -> spend (fields r (x ^ " and a count")) 1; listed x expected of_a_body)) in
  let line_a, pieces_a = pieces "a" in
  let line_b, pieces_b = pieces "b" in
  let claim_line = r.number in
  let stated = words_of r "claim depth, touching or apart" "claim " (fun f ->
      match f.s with
      | "claim touching" -> f.at <- String.length f.s; None
      | s when has_prefix "claim apart " s -> literal f "apart "; Some (false, rational f)
      | _ -> literal f "depth "; Some (true, rational f)) in
  advance r;
  let separations () = listed "separations" "three integers: a separation" direction in
  let optimum () =
    let optimum_line = r.number in
    let way = words_of r "optimum and three rationals" "optimum " point in
    advance r;
    { optimum_line; way; way_separations = separations () } in
  let polytope () =
    let polytope_line = r.number in
    let pair = pair_behind r "polytope" in
    advance r;
    let vertices = listed "vertices" "two numbers: a vertex" Grammar.pair in
    { polytope_line; pair; vertices; facets = listed "facets" "a count and as many corners" facet } in
  let proof () =
    let separations = separations () in
    let near_line = r.number in
    let near = pair_behind r "nearest" in
    advance r;
    let weights_a = listed "weights_a" "the number of a point and its weight" weight in
    { separations; near_line; near; weights_a; weights_b = listed "weights_b" "the number of a point and its weight" weight } in
  let claim =
    match stated with
    | Some (true, q) ->
      let optima = several "optima" optimum in
      let polytopes = several "polytopes" polytope in
      Depth (q, optima, polytopes, listed "tree" "split and numbers, or leaf and numbers" node)
    | None -> Touching (proof ())
    | Some (false, q) -> Apart (q, proof ()) in
  footer_at r "end and all counts again" (List.rev !counts);
  { plane; line_a; pieces_a; line_b; pieces_b; claim; claim_line; end_line = r.number }

let raised g = { g with pieces_a = Array.map (prism g.plane) g.pieces_a; pieces_b = Array.map (prism g.plane) g.pieces_b }
