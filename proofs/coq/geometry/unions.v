(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Of unions of convex pieces, what the theorems say beside what is said in printed.v.
   Definitions only. *)
Require Import Reals List.
From Fathom.geometry Require Import meaning.
Open Scope R_scope.

(* the least |t|^2 for which they have none *)
Definition union_depth2_is (As Bs : list (list pt)) (q : R) : Prop :=
  0 < q
  /\ (forall t, norm2 t < q -> overlap_at As Bs t)
  /\ (exists t, norm2 t = q /\ ~ overlap_at As Bs t).
(* t is one of the shortest translations that leave them none *)
Definition shortest_way_out (As Bs : list (list pt)) (q : R) (t : pt) : Prop := norm2 t = q /\ ~ overlap_at As Bs t.

(* they have a point in common, but no interior point *)
Definition unions_touch (As Bs : list (list pt)) : Prop :=
  (exists p, union As p /\ union Bs p) /\ ~ overlap_at As Bs origin.
(* they have no point in common, and q is the least squared distance of two points *)
Definition unions_distance2_is (As Bs : list (list pt)) (q : R) : Prop :=
  0 < q
  /\ (forall a b, union As a -> union Bs b -> q <= norm2 (sub b a))
  /\ (exists a b, union As a /\ union Bs b /\ norm2 (sub b a) = q).
