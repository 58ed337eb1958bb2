(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Size and work of a certificate of format 4: verify/check/FORMAT.md, section 13, whose letters
   these are. *)
open Grammar
open Patch_grammar
open Limits

let within (g : t) =
  let sum f = over (fun patch -> f patch) g.patches in
  let c = sum (fun p -> count p.corners) and s = sum (fun p -> count p.sides) and m = count g.rates in
  let weights corner = number (Array.length corner.corner_a) + number (Array.length corner.corner_b) in
  let many = sum (fun p -> over weights p.corners) in
  let most f = Array.fold_left (fun most p -> Array.fold_left (fun most x -> Z.max most (f x)) most p) Z.zero in
  let width corner =
    let each f = Array.iter (fun (_, w) -> f (ratio w)) in
    snd (common g.signed.end_line (many + (number 2 * c)) (fun f -> each f corner.corner_a; each f corner.corner_b)) in
  let x = most width (Array.map (fun p -> p.corners.items) g.patches.items) in
  let widest side = let x, y, z = side.inward in largest [ bits x; bits y; bits z ] in
  let digits rate =
    let sum = ref (bits (Q.num rate.root) + bits (Q.den rate.root)) in
    let add (q : Proved.ratio) = sum := !sum + bits q.num + bits q.den in
    List.iter (Signed_limits.coordinates add) [ rate.v; rate.w ];
    !sum in
  let r = most digits [| g.rates.items |] in
  let four = number 4 and eight = number 8 in
  let work n v u =
    let vx = v + x in
    let corner = vx + u + u and turn = vx + u + r in
    (s * n * product v u) + (four * (many + (eight * c)) * product corner corner)
    + (four * s * product (vx + u) (u + u)) + (eight * m * c * product turn turn) in
  let widest = most widest (Array.map (fun p -> p.sides.items) g.patches.items) in
  Signed_limits.within g.signed ~added:{ widest; size = (fun v -> (many + c + c) * (v + x)); work }
