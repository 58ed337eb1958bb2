(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Format 6: bodies that move, and when they meet. Integers and lists only. A polynomial stands for its coefficients, those of v^(n-k) u^k:
   it is homogeneous in v = 1 - u and u, which go from 0 to 1 as the time goes from the begin to the end of a piece. *)
Require Import List ZArith Bool.
From Fathom Require Import printed.
From Fathom.checker Require Import vector sequence table support verdict.
Import ListNotations.
Open Scope Z_scope.

(* ---- polynomials, of at most six coefficients ---- *)
Definition poly := list Z.
Fixpoint padd (p q : poly) : poly := match p, q with a :: p', b :: q' => (a + b) :: padd p' q' | _, _ => [] end.
Definition pscale (k : Z) (p : poly) : poly := map (Z.mul k) p.
Fixpoint pmul (p q : poly) : poly :=
  match p with
  | [] => []
  | [a] => pscale a q
  | a :: p' => padd (pscale a q ++ repeat 0 (length p')) (0 :: pmul p' q)
  end.

(* vectors of them *)
Record pvec := Pvec { pvx : poly; pvy : poly; pvz : poly }.
Definition constant (n : zvec) : pvec := Pvec [zx n] [zy n] [zz n].
Definition vadd u v := Pvec (padd (pvx u) (pvx v)) (padd (pvy u) (pvy v)) (padd (pvz u) (pvz v)).
Definition vscale p v := Pvec (pmul p (pvx v)) (pmul p (pvy v)) (pmul p (pvz v)).
Definition vneg v := Pvec (pscale (-1) (pvx v)) (pscale (-1) (pvy v)) (pscale (-1) (pvz v)).
Definition vdot u v := padd (padd (pmul (pvx u) (pvx v)) (pmul (pvy u) (pvy v))) (pmul (pvz u) (pvz v)).
Definition minor a b c d := padd (pmul a d) (pscale (-1) (pmul b c)).
Definition vcross u v := Pvec (minor (pvy u) (pvz u) (pvy v) (pvz v)) (minor (pvz u) (pvx u) (pvz v) (pvx v))
  (minor (pvx u) (pvy u) (pvx v) (pvy v)).
(* its values at k = 0, 1, ..: the vectors of the coefficients *)
Fixpoint rows (xs ys zs : poly) : list zvec :=
  match xs, ys, zs with x :: xs', y :: ys', z :: zs' => Zvec x y z :: rows xs' ys' zs' | _, _, _ => [] end.
Definition coefficients v := rows (pvx v) (pvy v) (pvz v).

(* x turned by the quaternion r + v, times its squared length *)
Definition protate (r : poly) (v x : pvec) : pvec :=
  vadd (vscale (padd (pmul r r) (pscale (-1) (vdot v v))) x) (vscale [2] (vadd (vscale (vdot v x) v) (vscale r (vcross v x)))).
Definition plength2 (r : poly) (v : pvec) : poly := padd (pmul r r) (vdot v v).
Definition zrotate (r : Z) (v x : zvec) : zvec :=
  zadd (zscal (r * r - zdot v v) x) (zscal 2 (zadd (zscal (zdot v x) v) (zscal r (zcross v x)))).
Definition zlength2 (r : Z) (v : zvec) : Z := r * r + zdot v v.

(* ---- times ---- *)
Definition later (s e : ratio) : bool := (0 <? den s) && (0 <? den e) && (num s * den e <=? num e * den s).
Definition strictly_later (s e : ratio) : bool := (0 <? den s) && (0 <? den e) && (num s * den e <? num e * den s).
Definition zero_ratio := Ratio 0 1.
Definition one_ratio := Ratio 1 1.

(* the number that goes from x to y as the time goes from 0 to 1: on [s, e], times the denominators of s and e; and at t, times its own *)
Definition on_piece (s e : ratio) (x y : Z) : poly :=
  [den e * ((den s - num s) * x + num s * y); den s * ((den e - num e) * x + num e * y)].
Definition vectors_on (s e : ratio) (x y : zvec) : pvec :=
  Pvec (on_piece s e (zx x) (zx y)) (on_piece s e (zy x) (zy y)) (on_piece s e (zz x) (zz y)).
Definition at_moment (t : ratio) (x y : Z) : Z := (den t - num t) * x + num t * y.
Definition vector_at (t : ratio) (x y : zvec) : zvec := zadd (zscal (den t - num t) x) (zscal (num t) y).

(* ---- what holds on a piece ---- *)
Inductive feature := Of_b (n : zvec) | Of_a (n : zvec) | Of_edges (f g : zvec).
(* hints in Near and in the claim: a unit of the weights *)
Record pair_of_points := Pair_of_points { unit_of : Z; weights_of_a : list (N * Z); weights_of_b : list (N * Z) }.
Inductive piece := Apart (e : ratio) (f : feature) | Near (e d : ratio) (w : pair_of_points).

Section Bodies.
  (* both in units of 1/m *)
  Variables (m : Z) (A B : list zvec) (MA MB : motion zvec Z).

  Definition scalar_on s e (M : motion zvec Z) := on_piece s e (scalar (at_start M)) (scalar (at_end M)).
  Definition axis_on s e (M : motion zvec Z) := vectors_on s e (axis (at_start M)) (axis (at_end M)).
  Definition spot_on s e (M : motion zvec Z) := vectors_on s e (spot (at_start M)) (spot (at_end M)).

  (* D, u and v: where D + <u, a> - <v, b> > 0 for all a and b the bodies are apart *)
  Definition conditions (s e : ratio) (f : feature) : poly * pvec * pvec :=
    let ra := scalar_on s e MA in let va := axis_on s e MA in
    let rb := scalar_on s e MB in let vb := axis_on s e MB in
    let wa := plength2 ra va in let wb := plength2 rb vb in
    let d := vadd (spot_on s e MA) (vneg (spot_on s e MB)) in
    let raised := vscale [1; 1] in
    match f with
    | Of_b n =>
        let h := protate rb vb (constant n) in
        (pmul wa (vdot h d), raised (protate ra (vneg va) h), raised (vscale (pmul wa wb) (constant n)))
    | Of_a n =>
        let h := protate ra va (constant n) in
        (pmul wb (vdot h d), raised (vscale (pmul wa wb) (constant n)), raised (protate rb (vneg vb) h))
    | Of_edges f g =>
        let h := protate ra va (constant f) in
        let k := protate rb vb (constant g) in
        (vdot (vcross h k) d, raised (vcross (constant f) (protate ra (vneg va) k)),
         raised (vcross (protate rb (vneg vb) h) (constant g)))
    end.

  (* for each coefficient the least over all a and b; L: the units of D *)
  Definition positive_at (L : Z) (D : Z) (u v : zvec) : bool :=
    match greatest (zneg u) A, greatest v B with Some x, Some y => 0 <? D - L * (x + y) | _, _ => false end.
  Fixpoint all_positive (L : Z) (D : poly) (us vs : list zvec) : bool :=
    match D, us, vs with
    | d :: D', u :: us', v :: vs' => if positive_at L d u v then all_positive L D' us' vs' else false
    | [], [], [] => true
    | _, _, _ => false
    end.
  Definition apart_on (s e : ratio) (f : feature) : bool :=
    let '(D, u, v) := conditions s e f in all_positive (den s * den e) D (coefficients u) (coefficients v).

  (* the points of A at the time t, times k, in units of 1 / (m * den t * the squared length of the quaternion) *)
  Definition placed_points (t : ratio) (k : Z) (M : motion zvec Z) (L : list zvec) : list zvec :=
    let r := at_moment t (scalar (at_start M)) (scalar (at_end M)) in
    let v := vector_at t (axis (at_start M)) (axis (at_end M)) in
    let p := zscal (zlength2 r v) (vector_at t (spot (at_start M)) (spot (at_end M))) in
    each (fun x => zscal k (zadd p (zscal (den t) (zrotate r v x)))) L.
  Definition length_at (t : ratio) (M : motion zvec Z) : Z :=
    zlength2 (at_moment t (scalar (at_start M)) (scalar (at_end M))) (vector_at t (axis (at_start M)) (axis (at_end M))).
  Definition near_at (t d : ratio) (w : pair_of_points) : bool :=
    let wa := length_at t MA in let wb := length_at t MB in
    later zero_ratio t && later t one_ratio && (0 <? wa) && (0 <? wb) && (0 <? unit_of w) && (0 <? den d) && (0 <=? num d) &&
    match weighed (numbered (placed_points t wb MA A)) (weights_of_a w), weighed (numbered (placed_points t wa MB B)) (weights_of_b w) with
    | Some (i, x), Some (j, y) =>
        let z := zsub x y in
        let k := num d * (unit_of w * (m * (den t * (wa * wb)))) in
        (i =? unit_of w) && (j =? unit_of w) && (zdot z z * (den d * den d) <=? k * k)
    | _, _ => false
    end.

  (* from the time s on; free: it is shown of s. The last time, and the pieces where nothing is shown *)
  Fixpoint walk (s : ratio) (free : bool) (ps : list piece) (found : list (ratio * ratio * ratio)) :
      option (ratio * list (ratio * ratio * ratio)) :=
    match ps with
    | [] => if free then Some (s, found) else None
    | Apart e f :: ps' => if later s e && apart_on s e f then walk e true ps' found else None
    | Near e d w :: ps' => if free && later s e && near_at e d w then walk e false ps' ((s, e, d) :: found) else None
    end.
End Bodies.

(* ---- the claims ---- *)
Inductive impact_claim :=
| Never (ps : list piece)
| Meeting (ps : list piece) (t : ratio) (w : pair_of_points).

Definition integral_pose (m k : Z) (o : pose point ratio) : pose zvec Z :=
  Pose (integral m (spot o)) (units k (scalar o)) (integral k (axis o)).
Definition integral_motion (m k : Z) (M : motion point ratio) : motion zvec Z :=
  Motion (integral_pose m k (at_start M)) (integral_pose m k (at_end M)).
Definition fits_pose (m k : Z) (o : pose point ratio) : bool := fits m (spot o) && divides k (scalar o) && fits k (axis o).
Definition fits_motion (m k : Z) (M : motion point ratio) : bool := fits_pose m k (at_start M) && fits_pose m k (at_end M).

(* m: a common denominator of all lengths; k: of the quaternions *)
Definition impact_verdict (m k : Z) (A B : list point) (M N : motion point ratio) (c : impact_claim) : option impact_statement :=
  let A' := each (integral m) A in
  let B' := each (integral m) B in
  let M' := integral_motion m k M in
  let N' := integral_motion m k N in
  if (0 <? m) && (0 <? k) && forallb (fits m) A && forallb (fits m) B && fits_motion m k M && fits_motion m k N
  then
    match c with
    | Never ps =>
        match walk m A' B' M' N' zero_ratio false ps [] with
        | Some (e, found) => if later one_ratio e && later e one_ratio then Some (Impact (Some e) None (rev_append found [])) else None
        | None => None
        end
    | Meeting [] t w =>
        if later t zero_ratio && later zero_ratio t && near_at m A' B' M' N' t zero_ratio w then Some (Impact None (Some t) []) else None
    | Meeting ps t w =>
        match walk m A' B' M' N' zero_ratio false ps [] with
        | Some (e, found) =>
            if strictly_later e t && later t one_ratio && near_at m A' B' M' N' t zero_ratio w
            then Some (Impact (Some e) (Some t) (rev_append found [])) else None
        | None => None
        end
    end
  else None.
