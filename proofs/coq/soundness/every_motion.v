(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What a printed depth says of all motions of A, turns among them: some point of A moves by at least
   that much. The theorems of geometry/motions.v, for what the checker accepts. *)
Require Import Reals Lra List.
From Fathom.checker Require Import sequence verdict body signed_verdict.
From Fathom.geometry Require Import meaning bodies norm signed_depth said motions.
From Fathom.soundness Require Import booleans verdict_sound signed_sound.
Open Scope R_scope.

(* ---- format 1: the depth, or its lower bound, is q ---- *)
Definition says_at_least (s : statement) (q : ratio) : Prop :=
  (exists k, s = Depth_is q k) \/ (exists hi, s = Depth_between q hi).

Lemma verdict_depth : forall width m A B c s q, verdict width m A B c = Some s -> says_at_least s q ->
  exists r, depth2_is (map real A) (map real B) r /\ value q <= r.
Proof.
  intros width m A B c s q H E. apply verdict_sound in H. destruct E as [(k & ->)|(hi & ->)].
  - exists (value q). split; [apply depth_said; split; apply H|lra].
  - destruct H as (r & P0 & D & L). exists r. split; [apply depth_said; auto|apply L].
Qed.

(* f is any map of A's corners, and some plane parts their hull from B *)
Theorem verdict_every_map : forall width m A B c s q f, verdict width m A B c = Some s -> says_at_least s q ->
  parted (conv (map f (map real A))) (conv (map real B)) ->
  exists a, In a (map real A) /\ value q <= norm2 (sub (f a) a).
Proof.
  intros width m A B c s q f H E C. destruct (verdict_depth _ _ _ _ _ _ _ H E) as (r & D & L).
  destruct (depth_every_map _ _ _ _ D C) as (a & Ia & N). exists a. split; auto. lra.
Qed.

(* f is rigid, A has an interior, and none of its interior points gets into B *)
Theorem verdict_every_motion : forall width m A B c s q f, verdict width m A B c = Some s -> says_at_least s q ->
  (exists g, interior (conv (map real A)) g) -> rigid f -> clear_of (image f (conv (map real A))) (conv (map real B)) ->
  exists a, In a (map real A) /\ value q <= norm2 (sub (f a) a).
Proof.
  intros width m A B c s q f H E HA Hf C. destruct (verdict_depth _ _ _ _ _ _ _ H E) as (r & D & L).
  destruct (depth_every_motion _ _ _ _ D HA Hf C) as (a & Ia & N). exists a. split; auto. lra.
Qed.

(* ---- format 2: the signed depth, or its lower bound ---- *)
Definition least_depth (s : signed_statement) : R :=
  match s with
  | Root_is _ square rho _ _ => signed_root (value square) + value rho
  | Root_between _ lo _ => value lo
  end.

Lemma says_least : forall A B s, says_signed A B s -> at_least (gaps A B) (least_depth s).
Proof.
  intros A B [st lo hi|st square rho k cone] H; simpl in *.
  - destruct H as (v & V & B0 & _). apply signed_depth_said in V. apply (at_least_weaken _ v); [apply B0|apply V].
  - destruct H as (x & r & E & _ & _ & -> & V & _). replace (signed_root (value square)) with x.
    + apply signed_depth_said in V. apply V.
    + apply signed_sqr_inj. rewrite signed_sqr_root. exact E.
Qed.

Theorem signed_verdict_every_map : forall width m rho A B c s f, signed_verdict width m rho A B c = Some s ->
  0 < least_depth s -> bounded_core (core_of (real_body A)) ->
  parted (image f (in_body (real_body A))) (in_body (real_body B)) ->
  exists a, in_body (real_body A) a /\ least_depth s * least_depth s <= norm2 (sub (f a) a).
Proof.
  intros width m rho A B c s f H P0 HA. apply signed_verdict_sound, says_least in H. apply body_every_map; auto.
Qed.

(* f is any map of the corners of A, which is a hull with a radius *)
Theorem signed_verdict_every_corner : forall width m rho A r B c s f,
  signed_verdict width m rho (Body (Points A) r) B c = Some s -> 0 < least_depth s ->
  parted (in_body (Body (Points (map f (map real A))) (value r))) (in_body (real_body B)) ->
  exists a, In a (map real A) /\ least_depth s * least_depth s <= norm2 (sub (f a) a).
Proof.
  intros width m rho A r B c s f H P0. apply signed_verdict_sound, says_least in H.
  apply corners_every_map; auto.
Qed.

Theorem signed_verdict_every_motion : forall width m rho A B c s f, signed_verdict width m rho A B c = Some s ->
  0 < least_depth s -> bounded_core (core_of (real_body A)) ->
  bounded_core (core_of (real_body B)) \/ half_space_core (core_of (real_body B)) ->
  (exists g, interior (in_body (real_body A)) g) -> rigid f ->
  clear_of (image f (in_body (real_body A))) (in_body (real_body B)) ->
  exists a, in_body (real_body A) a /\ least_depth s * least_depth s <= norm2 (sub (f a) a).
Proof.
  intros width m rho A B c s f H P0 HA HB. apply signed_verdict_sound, says_least in H.
  apply body_every_motion; auto.
Qed.
