(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Of contact patches and rates, what the theorems say beside what is said in printed.v.
   Definitions only. *)
Require Import Reals List.
From Fathom.checker Require Import body.
From Fathom.geometry Require Import meaning bodies.
Open Scope R_scope.

(* the points of S that are in T when S has been moved by t *)
Definition meeting (S T : pt -> Prop) (t p : pt) : Prop := S p /\ T (add p t).

(* the patch of the bodies themselves, whose signed depth is e *)
Definition body_patch (A B : body pt R) (e : R) (n : pt) : pt -> Prop := meeting (in_body A) (in_body B) (scal e n).

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
