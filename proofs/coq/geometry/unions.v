(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What certificates of format 3 are about: bodies that are unions of convex pieces.  Definitions only: with meaning.v to be read and
   believed. *)
Require Import Reals List.
From Fathom.geometry Require Import meaning.
Open Scope R_scope.

(* the points that are in the hull of one of the lists at least *)
Definition union (Ls : list (list pt)) (p : pt) : Prop := exists L, In L Ls /\ conv L p.
(* there are pieces, and each has an interior *)
Definition solid_pieces (Ls : list (list pt)) : Prop := Ls <> nil /\ forall L, In L Ls -> exists p, interior (conv L) p.

(* A moved by t and B have an interior point in common.  These are the interiors of the bodies as a whole: where two pieces of a body meet
   there is no gap in it. *)
Definition overlap_at (As Bs : list (list pt)) (t : pt) : Prop :=
  exists p, interior (translate (union As) t) p /\ interior (union Bs) p.

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
