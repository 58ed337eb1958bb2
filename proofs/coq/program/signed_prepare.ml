(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Format 2: what the proved function is told beside the bodies, and why it said no.  Nothing here is trusted, as in prepare.ml and reasons.ml. *)
open Grammar
open Signed_grammar
open Prepare

let rho g = Q.add g.a.radius g.b.radius

(* q in units of 1/unit *)
let in_units unit q = Z.mul (Q.num q) (Z.divexact unit (Q.den q))

let core_points b = match b.core with Proved.Points l -> List.length l | Proved.Terms _ -> Array.length b.inner.items | _ -> 0

let heights (d : Signed_limits.denominators) b =
  Array.to_list (Array.map (fun h -> Z.mul d.of_lengths (in_units d.of_heights h)) b.heights.items)

let inner_points (d : Signed_limits.denominators) b =
  let part = in_units d.of_parameters in
  let place (i, (x, y, z)) = (i, { Proved.zx = part x; zy = part y; zz = part z }) in
  Array.to_list (Array.map (Proved.each place) b.inner.items)

let claim g (d : Signed_limits.denominators) =
  let one () = single g.all g.directions in
  let m = core_points g.a and n = core_points g.b in
  let inner vertices facets = inner m n vertices facets g.directions in
  let positive q = demand g.claim_line (Q.sign q > 0) "what is claimed is not positive" in
  let weights = weights d.of_weights in
  let beside q a b all = Proved.Beside (Q.num q, Q.den q, one (), d.of_weights, weights a, weights b, all) in
  let cone (c : cone) =
    let within (j, i) = in_range n j && in_range m i in
    Array.iteri (fun k ji -> demand c.differences.lines_of.(k) (within ji) "a difference names a point that is not there") c.differences.items;
    { Proved.lineality = Array.to_list (Array.map (fun v -> fst (direction v)) c.lineality.items);
      rays = Array.to_list (Array.map direction c.rays.items);
      differences = Array.to_list c.differences.items } in
  match g.claim, g.lower with
  | Depth q, Facets (vertices, facets) ->
    positive q;
    Proved.Deep (Q.num q, Q.den q, g.all, Array.to_list (Array.map direction g.directions.items), inner vertices facets)
  | Depth q, _ -> positive q; Proved.On_plane (Q.num q, Q.den q, one ())
  | Touching, Weights (a, b) -> beside Q.zero a b (Option.map cone g.cone)
  | Touching, _ -> Proved.On_plane (Z.zero, Z.one, one ())
  | Apart q, Weights (a, b) -> positive q; beside q a b None
  | Apart q, _ -> positive q; Proved.On_plane (Z.neg (Q.num q), Q.den q, one ())
  | Signed_bounds (lo, hi), lower ->
    let lower =
      match lower with
      | Facets (vertices, facets) -> Proved.By_facets (inner vertices facets)
      | Weights (a, b) -> Proved.By_mean (d.of_weights, weights a, weights b)
      | None_needed -> Proved.By_half_space in
    Proved.Between
      ( Q.num lo, Q.den lo, Q.num hi, Q.den hi, one (),
        { Proved.height_unit = d.of_heights; heights_a = heights d g.a; heights_b = heights d g.b },
        { Proved.parameter_unit = d.of_parameters; inner_a = inner_points d g.a; inner_b = inner_points d g.b },
        lower )

(* ---- why not: only the wording of a refusal hangs on this ---- *)
let find ~width g m (claim : Proved.signed_claim) =
  let a = Proved.in_units m (proved_body g.a) and b = Proved.in_units m (proved_body g.b) in
  demand g.a.core_line (Q.sign g.a.radius >= 0) "a negative radius";
  demand g.b.core_line (Q.sign g.b.radius >= 0) "a negative radius";
  demand g.b.core_line (not width || Proved.same_body a b) "b is not a again";
  demand g.b.core_line (not (is_half_space g.a && is_half_space g.b)) "two half-spaces";
  let plane test = Array.iteri (fun k v -> demand g.directions.lines_of.(k) (test (fst (direction v))) "this direction's plane is not where the claim has it")
      g.directions.items in
  let units = Z.mul m m in
  let root qn qd = plane (fun n -> Proved.height_root a.core_of b.core_of (Z.mul qn units) qd n) in
  match claim with
  | Proved.Deep (qn, qd, _, _, _) -> root qn qd; demand g.directions.line (Array.length g.directions.items > 0) "no direction"
  | Proved.Beside (qn, qd, _, _, _, _, _) -> root (Z.neg qn) qd
  | Proved.On_plane (qn, qd, _) -> root qn qd
  | Proved.Between (_, _, hn, hd, _, outer, _, _) ->
    let rho = Z.add a.radius b.radius in
    plane (fun n -> Proved.height_within a.core_of b.core_of outer (Z.sub (Z.mul hn m) (Z.mul rho hd)) hd n)

let reason ~width g m claim =
  match find ~width g m claim with
  | () -> (g.claim_line, "what is inside the bodies does not prove the claim")
  | exception Refused (line, text) -> (line, text)
