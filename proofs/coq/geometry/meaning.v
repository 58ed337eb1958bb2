(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What the theorems say.  Definitions only: whoever believes these, and Coq, need read no other file. *)
Require Import Reals List.
Open Scope R_scope.

(* ---- points of R^3 ---- *)
Record pt := mk { px : R; py : R; pz : R }.
Definition dot (u v : pt) : R := px u * px v + py u * py v + pz u * pz v.
Definition norm2 (u : pt) : R := dot u u.
Definition add (u v : pt) : pt := mk (px u + px v) (py u + py v) (pz u + pz v).
Definition sub (u v : pt) : pt := mk (px u - px v) (py u - py v) (pz u - pz v).
Definition scal (k : R) (u : pt) : pt := mk (k * px u) (k * py u) (k * pz u).
Definition cross (u v : pt) : pt :=
  mk (py u * pz v - pz u * py v) (pz u * px v - px u * pz v) (px u * py v - py u * px v).
Definition origin : pt := mk 0 0 0.

(* ---- hulls and interiors ---- *)
Definition convex (C : pt -> Prop) : Prop :=
  forall u v l, 0 <= l <= 1 -> C u -> C v -> C (add (scal l u) (scal (1 - l) v)).
(* the least convex set that contains S *)
Definition hull (S : pt -> Prop) (p : pt) : Prop := forall C, convex C -> (forall s, S s -> C s) -> C p.
Definition interior (S : pt -> Prop) (t : pt) : Prop :=
  exists e, 0 < e /\ forall s, norm2 (sub s t) < e * e -> S s.

(* ---- the two bodies are the hulls of finite lists of points; P is the hull of all differences b - a ---- *)
Definition conv (L : list pt) : pt -> Prop := hull (fun p => In p L).
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
