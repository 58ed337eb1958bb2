(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What the theorems say beside what is said in printed.v.  Definitions only. *)
Require Import Reals List ZArith.
From Fathom Require Export printed.
Open Scope R_scope.

(* P is the hull of all differences b - a *)
Definition diffs (A B : list pt) (p : pt) : Prop := exists a b, In a A /\ In b B /\ p = sub b a.
Definition P (A B : list pt) : pt -> Prop := hull (diffs A B).

(* ---- the four claims ---- *)
(* A and B penetrate and the squared depth is q: P holds the open ball of squared radius q, in its interior,
   and some point at that distance is not interior *)
Definition depth2_is (A B : list pt) (q : R) : Prop :=
  0 < q
  /\ (forall t, norm2 t < q -> interior (P A B) t)
  /\ (exists t, norm2 t = q /\ ~ interior (P A B) t).
Definition depth2_between (A B : list pt) (lo hi : R) : Prop := exists q, depth2_is A B q /\ lo <= q <= hi.
Definition touching (A B : list pt) : Prop := P A B origin /\ ~ interior (P A B) origin.
Definition disjoint (A B : list pt) : Prop := ~ P A B origin.

(* ---- directions and optimal translations ---- *)
(* h is the value of P's support function in direction n *)
Definition height_is (A B : list pt) (n : pt) (h : R) : Prop :=
  (forall p, P A B p -> dot n p <= h) /\ (exists p, P A B p /\ dot n p = h).
(* t is the foot point of O on the supporting plane with outward normal n *)
Definition foot (A B : list pt) (n t : pt) : Prop := exists h, height_is A B n h /\ t = scal (h / norm2 n) n.
(* n is the outward normal of a facet of P: the points of diffs A B on the supporting plane span it *)
Definition facet_direction (A B : list pt) (n : pt) : Prop :=
  n <> origin /\ exists h, height_is A B n h /\ exists u v w,
    diffs A B u /\ diffs A B v /\ diffs A B w /\ dot n u = h /\ dot n v = h /\ dot n w = h
    /\ cross (sub v u) (sub w u) <> origin.

(* n is the outward normal of a facet of P whose plane is at squared distance q from O *)
Definition facet_at (A B : list pt) (q : R) (n : pt) : Prop :=
  facet_direction A B n /\ exists t, foot A B n t /\ norm2 t = q.
Definition same_ray (n m : pt) : Prop := exists k, 0 < k /\ m = scal k n.
(* P has exactly k facets at that distance: these are the directions of k, none twice, and any
   other is one of them *)
Definition facets_number (A B : list pt) (q : R) (k : Z) : Prop :=
  exists ns, Z.of_nat (length ns) = k /\ NoDup ns
    /\ (forall n, In n ns -> facet_at A B q n)
    /\ (forall n, facet_at A B q n -> exists m, In m ns /\ same_ray n m)
    /\ (forall n m, In n ns -> In m ns -> same_ray n m -> n = m).

(* ---- the wording of Agarwal et al: the least |t|^2 such that the interior of conv A + t misses conv B ---- *)
Definition translate (S : pt -> Prop) (t p : pt) : Prop := S (sub p t).
Definition separated (A B : list pt) (t : pt) : Prop :=
  forall p, ~ (interior (translate (conv A) t) p /\ conv B p).
Definition depth2_AGHRS (A B : list pt) (q : R) : Prop :=
  (forall t, separated A B t -> q <= norm2 t) /\ (exists t, norm2 t = q /\ separated A B t).

(* ---- width: the least distance of two parallel planes that enclose A ---- *)
Definition enclosed (A : list pt) (n : pt) (lo hi : R) : Prop :=
  n <> origin /\ lo <= hi /\ forall a, conv A a -> lo <= dot n a <= hi.
Definition width2_is (A : list pt) (w : R) : Prop :=
  (forall n lo hi, enclosed A n lo hi -> w <= (hi - lo) * (hi - lo) / norm2 n)
  /\ (exists n lo hi, enclosed A n lo hi /\ w = (hi - lo) * (hi - lo) / norm2 n).

(* ---- the three kinds of direction that the naive algorithm tries ---- *)
(* p is one of the points of L that are extreme in direction n *)
Definition extreme (L : list pt) (n p : pt) : Prop := In p L /\ forall q, In q L -> dot n q <= dot n p.
(* n is the outward normal of a facet of conv L *)
Definition facet_of (L : list pt) (n : pt) : Prop := n <> origin /\ exists u v w,
  extreme L n u /\ extreme L n v /\ extreme L n w /\ cross (sub v u) (sub w u) <> origin.
(* a segment in A's face and one in B's face, not parallel: crossing arcs of the Gaussian diagrams *)
Definition crossing_edges (A B : list pt) (n : pt) : Prop := n <> origin /\ exists a a' b b',
  extreme A (scal (-1) n) a /\ extreme A (scal (-1) n) a' /\ extreme B n b /\ extreme B n b'
  /\ cross (sub a' a) (sub b' b) <> origin.
