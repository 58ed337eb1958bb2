(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The example of verify/check/FORMAT.md, section 17, checked inside Coq: a rod of length 6 turns about its end, and meets the point (3,4,0).
   And forgeries, which are refused. *)
Require Import Reals List ZArith.
From Fathom Require Import printed.
From Fathom.checker Require Import vector sequence table support verdict impact.
From Fathom.soundness Require Import impact_sound.
Import ListNotations.
Open Scope Z_scope.

Definition number (n : Z) := Ratio n 1.
Definition whole (x y z : Z) := Point (number x) (number y) (number z).
Definition rod := [whole 0 0 0; whole 6 0 0].
Definition nail := [whole 3 4 0].
(* from no turn to the quaternion w x y z *)
Definition turning (w x y z : Z) :=
  Motion (Pose (whole 0 0 0) (number 1) (whole 0 0 0)) (Pose (whole 0 0 0) (number w) (whole x y z)).
Definition at_rest := turning 1 0 0 0.
Definition quarter := turning 1 0 0 1.
(* the side of the rod, as it turns *)
Definition side := Of_a (Zvec 0 (-1) 0).
Definition touch (w w' : Z) := Pair_of_points 6 [(0%N, w); (1%N, w')] [(0%N, 6)].
Definition told (e t : ratio) f w := impact_verdict 1 1 rod nail quarter at_rest (Meeting [Apart e f] t w).

Lemma rod_verdict : told (Ratio 1 4) (Ratio 1 2) side (touch 1 5) = Some (Impact (Some (Ratio 1 4)) (Some (Ratio 1 2)) []).
Proof. vm_compute. reflexivity. Qed.
(* at each real time up to 1/4 they are apart, and at 1/2 they meet *)
Theorem rod_meets : says_impact (map real rod) (map real nail) (real_motion quarter) (real_motion at_rest)
  (Impact (Some (Ratio 1 4)) (Some (Ratio 1 2)) []).
Proof. exact (impact_verdict_sound _ _ _ _ _ _ _ _ rod_verdict). Qed.

(* a piece up to the contact; the plane's other side; no direction; edges that are parallel at the beginning; a time, and a weight, at which
   there is no contact; a contact before the end of the piece; a quaternion that vanishes; no pieces *)
Definition motions_forged := [
  told (Ratio 1 2) (Ratio 5 8) side (touch 1 5);
  told (Ratio 1 4) (Ratio 1 2) (Of_a (Zvec 0 1 0)) (touch 1 5);
  told (Ratio 1 4) (Ratio 1 2) (Of_a zzero) (touch 1 5);
  told (Ratio 1 4) (Ratio 1 2) (Of_edges (Zvec 1 0 0) (Zvec 1 0 0)) (touch 1 5);
  told (Ratio 1 4) (Ratio 3 8) side (touch 1 5);
  told (Ratio 1 4) (Ratio 1 2) side (touch 2 4);
  told (Ratio 1 4) (Ratio 1 8) side (touch 1 5);
  impact_verdict 1 1 rod nail (turning (-7) 0 0 0) at_rest (Never [Apart (Ratio 1 1) (Of_b (Zvec 0 (-1) 0))]);
  impact_verdict 1 1 rod nail quarter at_rest (Meeting [] (Ratio 1 2) (touch 1 5));
  impact_verdict 1 1 rod nail quarter at_rest (Never [])].
Lemma motions_refused : forall found, In found motions_forged -> found = None.
Proof.
  assert (H : forallb (fun found => match found with Some _ => false | None => true end) motions_forged = true)
    by (vm_compute; reflexivity).
  intros found I. assert (F := proj1 (forallb_forall _ _) H found I). destruct found; [discriminate|reflexivity].
Qed.
