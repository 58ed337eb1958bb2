(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What the line says that the program prints, about the points as they stand in the file.  Definitions only: to be read and believed,
   like statement.v. *)
Require Import Reals List ZArith.
From Fathom.checker Require Import verdict.
From Fathom.geometry Require Import meaning.
Open Scope R_scope.

Definition value (r : ratio) : R := IZR (num r) / IZR (den r).
Definition real (p : point) : pt := mk (value (qx p)) (value (qy p)) (value (qz p)).

(* n is the outward normal of a facet of P whose plane is at squared distance q from O *)
Definition facet_at (A B : list pt) (q : R) (n : pt) : Prop :=
  facet_direction A B n /\ exists t, foot A B n t /\ norm2 t = q.
Definition same_ray (n m : pt) : Prop := exists k, 0 < k /\ m = scal k n.

(* P has exactly k facets at that distance: these are the directions of k, none twice, and any other is one of them *)
Definition facets_number (A B : list pt) (q : R) (k : Z) : Prop :=
  exists ns, Z.of_nat (length ns) = k /\ NoDup ns
    /\ (forall n, In n ns -> facet_at A B q n)
    /\ (forall n, facet_at A B q n -> exists m, In m ns /\ same_ray n m)
    /\ (forall n m, In n ns -> In m ns -> same_ray n m -> n = m).

Definition says (A B : list pt) (s : statement) : Prop :=
  match s with
  | Depth_is q optima =>
      depth2_is A B (value q) /\ match optima with Some k => facets_number A B (value q) k | None => True end
  | Depth_between lo hi => depth2_between A B (value lo) (value hi)
  | They_touch => touching A B
  | They_are_apart => disjoint A B
  end.

(* and with --width: the same, as the width of A *)
Definition says_width (A : list pt) (s : statement) : Prop :=
  match s with
  | Depth_is q _ => width2_is A (value q)
  | Depth_between lo hi => exists w, width2_is A w /\ value lo <= w <= value hi
  | They_touch => width2_is A 0
  | They_are_apart => False
  end.
