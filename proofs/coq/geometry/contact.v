(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What certificates of format 4 are about: where two bodies touch when they are just parted or
   brought together, and how fast their depth changes.  Definitions only: to be read and believed,
   with bodies.v. *)
Require Import Reals List.
From Fathom.checker Require Import body.
From Fathom.geometry Require Import meaning bodies.
Open Scope R_scope.

(* the points of S that are in T when S has been moved by t *)
Definition meeting (S T : pt -> Prop) (t p : pt) : Prop := S p /\ T (add p t).

(* C is the hull of ps; none of these is there twice, and none is in the hull of the others *)
Definition cornered (C : pt -> Prop) (ps : list pt) : Prop :=
  (forall p, C p <-> conv ps p)
  /\ NoDup ps
  /\ (forall p, In p ps -> ~ hull (fun q => In q ps /\ q <> p) p).

(* S, which has the signed depth d, is in the half-space <n, x> <= d, and n is a unit vector: d n is
   a way out, or the nearest point *)
Definition optimal (S : pt -> Prop) (d : R) (n : pt) : Prop := norm2 n = 1 /\ forall p, S p -> dot n p <= d.

(* the patch, of the cores, whose signed depth is d: the points of A's core that are in B's when A
   has been moved by d n *)
Definition patch_of (A B : body pt R) (d : R) (n : pt) : pt -> Prop :=
  meeting (in_core (core_of A)) (in_core (core_of B)) (scal d n).
(* and of the bodies themselves, whose signed depth is e *)
Definition body_patch (A B : body pt R) (e : R) (n : pt) : pt -> Prop := meeting (in_body A) (in_body B) (scal e n).

(* A moves: its point p has the velocity v + w x p. How fast the plane with the normal n is left
   behind there *)
Definition speed (v w n p : pt) : R := - dot n (add v (cross w p)).
(* r is the least value, over all optimal n, of the greatest speed on the patch *)
Definition rate_is (A B : body pt R) (d : R) (v w : pt) (r : R) : Prop :=
  (forall n, optimal (core_gaps A B) d n -> exists p, patch_of A B d n p /\ r <= speed v w n p)
  /\ (exists n, optimal (core_gaps A B) d n /\ forall p, patch_of A B d n p -> speed v w n p <= r).

(* where p is at the time s; the hull of the points A, with the radius r, when they have moved *)
Definition moved (v w : pt) (s : R) (p : pt) : pt := add p (scal s (add v (cross w p))).
Definition moved_body (v w : pt) (s : R) (A : list pt) (r : R) : body pt R := Body (Points (map (moved v w s) A)) r.
(* likewise of a half-space with the radius r: b - a for all points of B and of the moved body *)
Definition moved_set (v w : pt) (s : R) (C : pt -> Prop) (q : pt) : Prop := exists p, C p /\ q = moved v w s p.
Definition moved_gaps (v w : pt) (s : R) (m : pt) (c r : R) (B : body pt R) : pt -> Prop :=
  difference_of (in_body B) (thick (moved_set v w s (fun p => dot m p <= c)) r).
(* from d on the signed depth of G s grows at the rate r: this is its one-sided derivative at s = 0
   *)
Definition grows (G : R -> pt -> Prop) (d r : R) : Prop := forall e, 0 < e -> exists s0, 0 < s0 /\
  forall s x, 0 < s < s0 -> signed_depth (G s) x -> s * (r - e) <= x - d <= s * (r + e).
