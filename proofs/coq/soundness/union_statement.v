(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What an accepted certificate of format 3 says.  Definitions only; with geometry/meaning.v and geometry/unions.v this is all that a reader
   has to believe. *)
Require Import Reals List ZArith.
From Fathom.checker Require Import vector unions.
From Fathom.geometry Require Import meaning unions.
From Fathom.soundness Require Import statement.
Open Scope R_scope.

(* the optima are integer vectors in units of 1/(m unit) *)
Definition union_holds (m : Z) (As Bs : list (list pt)) (c : union_claim) : Prop :=
  match c with
  | Union_deep qn qd unit optima _ _ _ _ =>
      let q := IZR qn / IZR qd in
      let ts := map (fun o => frac (m * unit) (fst o)) optima in
      union_depth2_is As Bs q
      /\ NoDup ts
      /\ forall t, shortest_way_out As Bs q t <-> In t ts
  | Union_touching _ _ => unions_touch As Bs
  | Union_apart qn qd _ _ => unions_distance2_is As Bs (IZR qn / IZR qd)
  end.

(* the pieces are integer points in units of 1/m *)
Definition union_meaning (m : Z) (As Bs : list (list zvec)) (c : union_claim) : Prop :=
  let RA := map (map (frac m)) As in
  let RB := map (map (frac m)) Bs in
  solid_pieces RA /\ solid_pieces RB /\ union_holds m RA RB c.
