(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Of round and curved bodies, what the theorems say beside what is said in printed.v.
   Definitions only. *)
Require Import Reals List.
From Fathom.checker Require Import body.
From Fathom.geometry Require Import limits meaning.
Import ListNotations.
Open Scope R_scope.

(* the bodies that have a depth: no hull is one of nothing, and at most one core is a half-space *)
Definition bounded_core (c : core pt R) : Prop :=
  match c with Points L => L <> [] | Terms ts => Forall (fun t => t <> []) ts | Half_space _ _ => False end.
Definition half_space_core (c : core pt R) : Prop := exists n d, c = Half_space n d /\ n <> origin.
Definition comparable (c d : core pt R) : Prop :=
  (bounded_core c /\ bounded_core d) \/ (bounded_core c /\ half_space_core d) \/ (half_space_core c /\ bounded_core d).

(* A moved by t has a point in common with B *)
Definition moved_meets (A B : body pt R) (t : pt) : Prop := exists p, translate (in_body A) t p /\ in_body B p.

(* ---- signed depth: the distance from O to what is outside of S; or minus the distance from O to S ---- *)
Definition at_least (S : pt -> Prop) (x : R) : Prop :=
  (0 < x -> forall t, norm2 t < x * x -> interior S t)
  /\ (x <= 0 -> exists p, S p /\ norm2 p <= x * x).
Definition at_most (S : pt -> Prop) (x : R) : Prop :=
  (0 <= x -> exists t, norm2 t <= x * x /\ ~ interior S t)
  /\ (x < 0 -> forall p, S p -> x * x <= norm2 p).
Definition signed_depth (S : pt -> Prop) (v : R) : Prop := at_least S v /\ at_most S v.
(* wherever there is a signed depth, it is between them *)
Definition signed_depth_in (S : pt -> Prop) (lo hi : R) : Prop := at_least S lo /\ at_most S hi.

(* the number y >= 0 with y y = x, for x >= 0; the type of root_exists says that there is one *)
Definition root (x : R) : R := match Rle_dec 0 x with left H => proj1_sig (root_exists x H) | right _ => 0 end.
(* the root of |x| with the sign of x *)
Definition signed_root (x : R) : R := if Rle_dec 0 x then root x else - root (- x).

(* ---- status ---- *)
Definition overlap (S : pt -> Prop) : Prop := interior S origin.
Definition touch (S : pt -> Prop) : Prop := S origin /\ ~ interior S origin.
Definition apart (S : pt -> Prop) : Prop := ~ S origin.

(* ---- the least ways out of S, which holds O ---- *)
Definition way_out (S : pt -> Prop) (v : R) (t : pt) : Prop := norm2 t = v * v /\ ~ interior S t.

(* ---- cones ---- *)
Fixpoint combination (ks : list R) (vs : list pt) : pt :=
  match ks, vs with k :: ks', v :: vs' => add (scal k v) (combination ks' vs') | _, _ => origin end.
(* a sum of multiples of the first list, and multiples >= 0 of the second *)
Definition spanned (ls rs : list pt) (u : pt) : Prop := exists ks cs,
  length ks = length ls /\ length cs = length rs /\ (forall c, In c cs -> 0 <= c) /\ u = add (combination ks ls) (combination cs rs).
Definition linearly_independent (vs : list pt) : Prop := forall ks,
  length ks = length vs -> combination ks vs = origin -> forall k, In k ks -> k = 0.
(* the vectors ls and the rays rs generate K, and none of them could be spared: the ls are a basis of the largest linear space in K, and the
   rays, which are orthogonal to it, are the extreme ones *)
Definition generated (K : pt -> Prop) (ls rs : list pt) : Prop :=
  (forall u, K u <-> spanned ls rs u)
  /\ linearly_independent ls
  /\ (forall r l, In r rs -> In l ls -> dot r l = 0)
  /\ (forall r, In r rs -> ~ K (scal (-1) r))
  /\ (forall xs r ys, rs = xs ++ r :: ys -> ~ spanned ls (xs ++ ys) r).
