(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What an accepted certificate says.  Definitions only; with geometry/meaning.v this is all that a reader has to believe. *)
Require Import Reals List ZArith.
From Fathom.checker Require Import vector polytope certificate.
From Fathom.geometry Require Import meaning.
Open Scope R_scope.

(* integer vectors as points, and as points in units of 1/scale *)
Definition inj (v : zvec) : pt := mk (IZR (zx v)) (IZR (zy v)) (IZR (zz v)).
Definition frac (S : Z) (v : zvec) : pt := mk (IZR (zx v) / IZR S) (IZR (zy v) / IZR S) (IZR (zz v) / IZR S).

(* the directions listed are those of facets of P at squared distance q from O *)
Definition directions_hold (A B : list pt) (q : R) (dirs : list pt) : Prop :=
  forall n, In n dirs -> facet_direction A B n /\ exists t, foot A B n t /\ norm2 t = q.

(* they give all points of P's boundary at that distance, and each but once *)
Definition directions_complete (A B : list pt) (q : R) (dirs : list pt) : Prop :=
  (forall t, norm2 t = q -> (~ interior (P A B) t <-> exists n, In n dirs /\ foot A B n t))
  /\ (forall n m t, In n dirs -> In m dirs -> foot A B n t -> foot A B m t -> n = m)
  /\ NoDup dirs.

Definition holds (A B : list pt) (c : claim) : Prop :=
  match c with
  | Depth qn qd complete dirs _ =>
      let q := IZR qn / IZR qd in
      let ns := map (fun n => inj (fst n)) dirs in
      depth2_is A B q /\ directions_hold A B q ns /\ (complete = true -> directions_complete A B q ns)
  | Bounds ln ld hn hd _ _ => depth2_between A B (IZR ln / IZR ld) (IZR hn / IZR hd)
  | Touching _ _ _ _ => touching A B
  | Disjoint _ => disjoint A B
  end.

Definition meaning_of (c : certificate) : Prop :=
  holds (map (frac (scale c)) (body_a c)) (map (frac (scale c)) (body_b c)) (claimed c).
