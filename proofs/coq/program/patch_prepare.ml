(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Format 4: what the proved function is told beside the bodies: patches, rates, and hints: which
   side names a corner, and the order of the corners.  Nothing here is trusted, as in prepare.ml;
   nor are the reasons of a refusal. *)
open Grammar
open Patch_grammar
open Prepare

let denominator all = Array.fold_left (fun unit (_, w) -> Z.lcm unit (Q.den w)) Z.one all

let weights unit = Array.map (fun (i, w) -> (i, Z.mul (Q.num w) (Z.divexact unit (Q.den w))))

(* the point that the weights say, in units of 1/(m unit); points: in units of 1/m *)
let mean points line all =
  Array.fold_left
    (fun { Proved.zx; zy; zz } (i, w) ->
       demand line (in_range (Array.length points) i) "a corner names a point that is not there";
       let p : Proved.zvec = points.(Z.to_int i) in
       { Proved.zx = Z.add zx (Z.mul w p.zx); zy = Z.add zy (Z.mul w p.zy); zz = Z.add zz (Z.mul w p.zz) })
    { Proved.zx = Z.zero; zy = Z.zero; zz = Z.zero } all

(* lexicographic, of x/k and y/l *)
let compare_ends ((x : Proved.zvec), k) ((y : Proved.zvec), l) =
  let first = Z.compare (Z.mul l x.zx) (Z.mul k y.zx) in
  if first <> 0 then first
  else
    let second = Z.compare (Z.mul l x.zy) (Z.mul k y.zy) in
    if second <> 0 then second else Z.compare (Z.mul l x.zz) (Z.mul k y.zz)

let patch a b (p : patch) =
  let c = Array.length p.corners.items in
  let none = Z.of_int (Array.length p.sides.items) in
  let named = Array.make c none in
  Array.iteri
    (fun k side ->
       demand p.sides.lines_of.(k) (in_range c side.at) "a side names a corner that is not there";
       named.(Z.to_int side.at) <- Z.of_int k)
    p.sides.items;
  let corner k { corner_a; corner_b } =
    let line = p.corners.lines_of.(k) in
    let unit = Z.lcm (denominator corner_a) (denominator corner_b) in
    let of_a = weights unit corner_a and of_b = weights unit corner_b in
    let end_a = mean a line of_a and end_b = mean b line of_b in
    ( { Proved.corner_unit = unit; corner_a = Array.to_list of_a; corner_b = Array.to_list of_b; named_by = named.(k) },
      ((if Array.length a = 0 then end_b else end_a), unit) ) in
  let corners = Array.mapi corner p.corners.items in
  let order = Array.init c (fun k -> k) in
  Array.stable_sort (fun i k -> compare_ends (snd corners.(i)) (snd corners.(k))) order;
  let side { of_b; inward; at } = { Proved.of_b; inward = fst (direction inward); side_corner = at } in
  { Proved.patch_corners = Array.to_list (Array.map fst corners);
    patch_sides = Array.to_list (Array.map side p.sides.items);
    ascending = Array.to_list (Array.map Z.of_int order) }

let rate (part : rate part) k { v; w; sign; root } =
  let good = Z.leq (Z.abs sign) Z.one && Q.sign root = abs (Z.sign sign) in
  demand part.lines_of.(k) good "the sign and the root of a rate do not go together";
  let unit = ref Z.one in
  List.iter (Signed_limits.coordinates (fun (q : Proved.ratio) -> unit := Z.lcm !unit q.den)) [ v; w ];
  { Proved.rate_v = v; rate_w = w; rate_square = ratio (Q.mul (Q.of_bigint sign) root); rate_unit = !unit }

let core m body = (Proved.in_units m (Signed_grammar.proved_body body)).core_of

let points m body = Array.of_list (Proved.spots (core m body))

let claim (g : t) (d : Signed_limits.denominators) =
  let base = Signed_prepare.claim g.signed d in
  let a = points d.of_lengths g.signed.a and b = points d.of_lengths g.signed.b in
  { Proved.base;
    patches = Array.to_list (Array.map (patch a b) g.patches.items);
    rates = Array.to_list (Array.mapi (rate g.rates) g.rates.items) }

(* ---- why not: only the wording of a refusal hangs on this ---- *)
let find (g : t) m (claim : Proved.patched_claim) =
  let a = core m g.signed.a and b = core m g.signed.b in
  match Proved.directions_of claim.base with
  | None -> ()
  | Some (((qn, qd), ns), whole) ->
    demand g.patches.line (List.compare_lengths ns claim.patches = 0) "there is not one patch for each direction";
    let table core = Proved.numbered (Proved.spots core) in
    let check = Proved.check_patch a b (table a) (table b) (Z.mul qn (Z.mul m m)) qd in
    let line = ref 0 in
    let ends n patch =
      let at = g.patches.lines_of.(!line) in
      incr line;
      match check n patch with
      | Some ends -> (n, ends)
      | None -> raise (Refused (at, "these corners and sides are not those of the patch of its direction")) in
    let contacts = List.rev (List.rev_map2 ends ns claim.patches) in
    demand g.rates.line (whole || claim.rates = []) "a rate needs all optimal directions, which are not proved here";
    List.iteri
      (fun k rate ->
         demand g.rates.lines_of.(k) (Proved.check_rate m contacts rate)
           "the signed depth changes at another rate than claimed")
      claim.rates

let reason ~width (g : t) m (claim : Proved.patched_claim) base_holds =
  if not base_holds then Signed_prepare.reason ~width g.signed m claim.base
  else
    match find g m claim with
    | () -> (g.patches.line, "the patches and rates are not proved")
    | exception Refused (line, text) -> (line, text)
