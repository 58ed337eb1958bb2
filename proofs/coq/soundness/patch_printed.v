(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What a line about a certificate of format 4 says, about the bodies as they stand in the file.
   Definitions only: to be read and believed, with geometry/contact.v and signed_printed.v. *)
Require Import Reals List ZArith.
From Fathom.checker Require Import vector verdict body signed_verdict patch_verdict.
From Fathom.geometry Require Import meaning bodies norm contact.
From Fathom.soundness Require Import statement printed signed_printed.
Open Scope R_scope.

(* the unit vector of a direction *)
Definition unit_of (n : zvec) : pt := along (inj n) 1.

Definition says_patched (A B : body pt R) (s : patched_statement) : Prop :=
  says_signed A B (depth_says s)
  /\ match depth_says s with
     | Root_is _ square _ optima _ =>
         let d := signed_root (value square) in
         (forall n ps, In (n, ps) (corners_at s) ->
            optimal (core_gaps A B) d (unit_of n) /\ cornered (patch_of A B d (unit_of n)) (map real ps))
         /\ (whole s = true -> forall u, optimal (core_gaps A B) d u ->
               exists n ps, In (n, ps) (corners_at s) /\ u = unit_of n)
         /\ match optima with Some k => Z.of_nat (length (corners_at s)) = k | None => True end
         /\ (forall r, In r (rates_are s) ->
               rate_is A B d (real (rate_v r)) (real (rate_w r)) (signed_root (value (rate_square r))))
     | Root_between _ _ _ => False
     end.
