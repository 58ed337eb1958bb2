(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The grammar of format 2 (verify/check/FORMAT.md), and of format 4 but for its patches: from lines to a certificate as it stands there. *)
open Lines
open Grammar

type vector = Proved.point
type inner_point = (Z.t * (Q.t * Q.t * Q.t)) list

type body = {
  core : (vector, Proved.ratio) Proved.core;
  core_line : int;
  vectors : int; (* points; or centers and axes *)
  radius : Q.t;
  heights : Q.t part;
  inner : inner_point part;
}

type claim = Depth of Q.t | Touching | Apart of Q.t | Signed_bounds of Q.t * Q.t

type cone = { lineality : (Z.t * Z.t * Z.t) part; rays : (Z.t * Z.t * Z.t) part; differences : (Z.t * Z.t) part }
type lower = Facets of (Z.t * Z.t) part * Z.t array part | Weights of (Z.t * Q.t) part * (Z.t * Q.t) part | None_needed

type t = {
  plane : plane option;
  a : body;
  b : body;
  claim : claim;
  claim_line : int;
  end_line : int;
  all : bool;
  directions : (Z.t * Z.t * Z.t) part;
  lower : lower;
  cone : cone option;
}

let origin = let zero = ratio Q.zero in { Proved.qx = zero; qy = zero; qz = zero }
let starts r word = match r.text with Whole s -> has_prefix word s | _ -> false

(* a half-space's numbers are not counted *)
let uncounted_point plane f =
  let qx = rational f in blank f;
  let qy = rational f in
  let qz = if plane = None then (blank f; rational f) else Q.zero in
  { Proved.qx = ratio qx; qy = ratio qy; qz = ratio qz }

let atom vectors f =
  let rest = String.sub f.s f.at (String.length f.s - f.at) in
  let more () = blank f; incr vectors; point f in
  if has_prefix "point " rest then begin
    literal f "point";
    let center = more () in
    { Proved.center; axis_u = origin; axis_v = origin; axis_w = origin }
  end
  else if has_prefix "disc " rest then begin
    literal f "disc";
    let center = more () in let axis_u = more () in let axis_v = more () in
    { Proved.center; axis_u; axis_v; axis_w = origin }
  end
  else begin
    literal f "ball";
    let center = more () in let axis_u = more () in let axis_v = more () in let axis_w = more () in
    { Proved.center; axis_u; axis_v; axis_w }
  end

(* the core at hand; counts collects what is announced by a word, the last one first *)
let core ~shapes plane r counts vectors name =
  let announce part = counts := Array.length part.items :: !counts; Array.to_list part.items in
  if shapes && starts r "shape_" then begin
    let f = fields r ("shape_" ^ name ^ " and a count") in
    literal f ("shape_" ^ name ^ " ");
    let count = natural f in
    finish f;
    let terms = ref [] and got = ref 0 and place = !counts in
    counts := [];
    while Z.gt count (Z.of_int !got) do
      advance r;
      let f = fields r "term and a count" in
      literal f "term ";
      let atoms = natural f in
      spend f 1;
      finish f;
      terms := announce (rows r r.number atoms "point, disc or ball, and its vectors" (atom vectors)) :: !terms;
      incr got
    done;
    counts := List.rev_append (List.rev !counts) (!got :: place);
    Proved.Terms (List.rev !terms)
  end
  else if starts r "halfspace_" then begin
    let f = fields r ("halfspace_" ^ name ^ if plane = None then " and four rationals" else " and three rationals") in
    literal f ("halfspace_" ^ name ^ " ");
    let normal = uncounted_point plane f in
    blank f;
    let offset = rational f in
    finish f;
    Proved.Half_space (normal, ratio offset)
  end
  else begin
    let expected, point = points_of plane in
    let points = announce (counted r name expected point) in
    vectors := List.length points;
    Proved.Points points
  end

(* the core and its radius; leaves the line behind them at hand *)
let body ~shapes plane r counts name =
  let core_line = r.number in
  let vectors = ref 0 in
  let core = core ~shapes plane r counts vectors name in
  advance r;
  let radius =
    if starts r "radius_" then begin
      let f = fields r ("radius_" ^ name ^ " and a rational") in
      literal f ("radius_" ^ name ^ " ");
      let radius = rational f in
      finish f;
      advance r;
      radius
    end
    else Q.zero in
  { core; core_line; vectors = !vectors; radius; heights = nothing core_line; inner = nothing core_line }

let proved_body b = { Proved.core_of = b.core; radius = ratio b.radius }

let is_shape b = match b.core with Proved.Terms _ -> true | _ -> false
let is_half_space b = match b.core with Proved.Half_space _ -> true | _ -> false

let claim_of ~bounds r shapes =
  let f = fields r (if shapes then "claim signed_bounds" else "claim depth, touching" ^ if bounds then ", apart or signed_bounds" else " or apart") in
  literal f "claim ";
  let claim =
    if bounds && has_prefix "claim signed_bounds " f.s then begin
      literal f "signed_bounds ";
      let lo = rational f in blank f;
      Signed_bounds (lo, rational f)
    end
    else if shapes then wrong f
    else if f.s = "claim touching" then (f.at <- String.length f.s; Touching)
    else if has_prefix "claim apart " f.s then (literal f "apart "; Apart (rational f))
    else (literal f "depth "; Depth (rational f)) in
  finish f;
  claim

let height f = spend f 1; rational f

let inner_point terms f =
  if terms = 0 then wrong f;
  let place () =
    spend f 4;
    let i = natural f in blank f;
    let x = rational f in blank f;
    let y = rational f in blank f;
    (i, (x, y, rational f)) in
  let rec go k done_ = if k = terms then List.rev done_ else (if k > 0 then blank f; go (k + 1) (place () :: done_)) in
  go 0 []

(* all but the footer, whose line, or that of the patches, it leaves at hand; with the counts so far, the last one first *)
let all_but_footer ~patched r name =
  advance r;
  name_of r name;
  let plane = if patched then None else plane_of r in
  let counts = ref [] in
  let announced part = counts := Array.length part.items :: !counts; part in
  let body = body ~shapes:(not patched && plane = None) plane r counts in
  let a = body "a" in
  let b = body "b" in
  let claim = claim_of ~bounds:(not patched && plane = None) r (is_shape a || is_shape b) in
  let claim_line = r.number in
  let all, directions = directions_of r in
  ignore (announced directions);
  let listed word expected item = announced (part r word expected item) in
  let of_shape body word expected item = if is_shape body then listed word expected item else nothing body.core_line in
  let terms body = match body.core with Proved.Terms ts -> List.length ts | _ -> 0 in
  let heights_a = of_shape a "heights_a" "a rational: a height" height in
  let heights_b = of_shape b "heights_b" "a rational: a height" height in
  let places body = if terms body = 1 then "the number of an atom and three rationals" else "the number of an atom and three rationals, for each term" in
  let inner_a = of_shape a "inner_a" (places a) (inner_point (terms a)) in
  let inner_b = of_shape b "inner_b" (places b) (inner_point (terms b)) in
  let ahead word = advance r; starts r word in
  let weights () =
    let weights_a = announced (counted r "weights_a" "the number of a point and its weight" weight) in
    Weights (weights_a, listed "weights_b" "the number of a point and its weight" weight) in
  let facets () =
    let vertices = announced (counted r "vertices" "two numbers: a vertex" pair) in
    Facets (vertices, listed "facets" "a count and as many corners" facet) in
  let lower =
    if is_half_space a || is_half_space b then None_needed
    else
      match claim with
      | Depth _ -> advance r; facets ()
      | Touching | Apart _ -> advance r; weights ()
      | Signed_bounds _ -> if ahead "vertices" then facets () else weights () in
  advance r;
  let cone =
    if claim = Touching && lower <> None_needed && starts r "lineality" then begin
      let lineality = announced (counted r "lineality" "three integers: a vector" direction) in
      let rays = listed "rays" "three integers: a vector" direction in
      let differences = listed "differences" "two numbers: a difference" pair in
      advance r;
      Some { lineality; rays; differences }
    end
    else None in
  ( { plane; a = { a with heights = heights_a; inner = inner_a }; b = { b with heights = heights_b; inner = inner_b };
      claim; claim_line; end_line = r.number; all; directions; lower; cone },
    !counts )

let footer_behind r counts = footer_at r "end and all counts again" (List.rev counts)

let certificate r name =
  let g, counts = all_but_footer ~patched:false r name in
  footer_behind r counts;
  g

let raised g =
  match g.plane, g.b.core with
  | Some _, Proved.Points points ->
    let items = Array.of_list points in
    let { items; _ } = prism g.plane { (nothing g.b.core_line) with items } in
    { g with b = { g.b with core = Proved.Points (Array.to_list items); vectors = Array.length items } }
  | _ -> g
