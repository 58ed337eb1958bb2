(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What acceptance means in other words: the depth of Agarwal et al, the width, common points. *)
Require Import Reals Lra List ZArith.
From Fathom.checker Require Import vector certificate.
From Fathom.geometry Require Import meaning space hulls flats difference depth minkowski wording solid width.
From Fathom.soundness Require Import statement main.
Import ListNotations.
Open Scope R_scope.

Section Accepted.
  Variables (A B : list zvec) (S : Z).
  Let RA := map (frac S) A.
  Let RB := map (frac S) B.

  (* where conv A has interior points: the least |t|^2 such that the interior of conv A + t misses conv B *)
  Theorem check_sound_AGHRS : forall qn qd complete dirs q,
    check (Certificate S A B (Depth qn qd complete dirs q)) = true -> spanning RA ->
    depth2_AGHRS RA RB (IZR qn / IZR qd).
  Proof.
    intros qn qd complete dirs q H HA. apply check_sound in H. destruct H as [D _].
    change (depth2_is RA RB (IZR qn / IZR qd)) in D. apply depth_AGHRS; auto.
    - apply spanning_interior. auto.
    - apply (P_nonempty RA RB origin). apply interior_in, (depth_interior _ _ _ D).
  Qed.

  (* moving A by the foot point of a listed direction moves it off B *)
  Theorem check_sound_translation : forall qn qd complete dirs q n t,
    check (Certificate S A B (Depth qn qd complete dirs q)) = true -> spanning RA ->
    In n dirs -> foot RA RB (inj (fst n)) t -> separated RA RB t.
  Proof.
    intros qn qd complete dirs q n t H HA Hn (h & Hh & ->) p Hp. apply check_sound in H. destruct H as (D & Hd & _).
    assert (In' : In (inj (fst n)) (map (fun n => inj (fst n)) dirs)) by (apply in_map_iff; eauto).
    destruct (Hd _ In') as [[Hz _] _].
    apply (beyond_not_interior RA RB (inj (fst n)) h (scal (h / norm2 (inj (fst n))) (inj (fst n))) Hz Hh).
    { rewrite foot_dot; auto. lra. }
    apply meets_interior; eauto.
    - apply spanning_interior. auto.
    - apply (P_nonempty RA RB origin). apply interior_in, (depth_interior _ _ _ D).
  Qed.

  (* a depth certificate of (A, A) is one of A's width *)
  Theorem check_sound_width : forall qn qd complete dirs q,
    check (Certificate S A A (Depth qn qd complete dirs q)) = true -> width2_is RA (IZR qn / IZR qd).
  Proof.
    intros qn qd complete dirs q H. apply check_sound in H. destruct H as [D _].
    apply depth_is_width. exact D.
  Qed.

  Theorem check_sound_disjoint : forall n, check (Certificate S A B (Disjoint n)) = true ->
    ~ exists p, conv RA p /\ conv RB p.
  Proof. intros n H. apply check_sound in H. rewrite <- meet_iff. exact H. Qed.

  Theorem check_sound_touching : forall n unit WA WB, check (Certificate S A B (Touching n unit WA WB)) = true ->
    exists p, conv RA p /\ conv RB p.
  Proof. intros n unit WA WB H. apply check_sound in H. rewrite <- meet_iff. apply H. Qed.
End Accepted.

(* no two accepted certificates about the same points contradict each other *)
Theorem accepted_agree : forall A B S qn qd complete dirs q rn rd complete' dirs' r,
  check (Certificate S A B (Depth qn qd complete dirs q)) = true ->
  check (Certificate S A B (Depth rn rd complete' dirs' r)) = true -> IZR qn / IZR qd = IZR rn / IZR rd.
Proof.
  intros A B S qn qd complete dirs q rn rd complete' dirs' r H1 H2.
  apply check_sound in H1. apply check_sound in H2. destruct H1 as [D1 _]. destruct H2 as [D2 _].
  exact (depth2_unique _ _ _ _ D1 D2).
Qed.
