(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Theorem R for bodies: their signed depth exists, and is that of their cores plus the sum of the radii.  What the signed
   depth says of moving A. *)
Require Import Reals Lra Psatz List.
From Fathom.checker Require Import body.
From Fathom.geometry Require Import meaning bodies space norm hulls difference minkowski signed_depth rounded compact existence curved.
Import ListNotations.
Open Scope R_scope.

Theorem gaps_meet : forall A B t, gaps A B t <-> moved_meets A B t.
Proof.
  intros A B t. split.
  - intros (b & a & Hb & Ha & ->). exists b. split; auto. unfold translate. replace (sub b (sub b a)) with a by (pteq; ring). auto.
  - intros (p & Ha & Hb). exists p, (sub p t). split; auto. split; auto. pteq; ring.
Qed.

(* the gaps of rounded bodies are those of their cores, rounded: Theorem R's two sides for any bodies *)
Lemma gaps_thick : forall A B p, 0 <= radius A -> 0 <= radius B ->
  (gaps A B p <-> thick (core_gaps A B) (radius A + radius B) p).
Proof. intros A B p HA HB. apply difference_thick; auto. Qed.

(* ---- what is shown of the cores holds of the bodies ---- *)
Theorem R_least : forall A B x, 0 <= radius A -> 0 <= radius B -> at_least (core_gaps A B) x ->
  at_least (gaps A B) (x + (radius A + radius B)).
Proof.
  intros A B x HA HB H. apply (at_least_iff (thick (core_gaps A B) (radius A + radius B))).
  - intros p. rewrite gaps_thick by auto. tauto.
  - apply thick_least; auto. lra.
Qed.
Theorem R_most : forall A B x, 0 <= radius A -> 0 <= radius B -> planed (core_gaps A B) x ->
  at_most (gaps A B) (x + (radius A + radius B)).
Proof.
  intros A B x HA HB (n & h & Hn & H & L). apply (at_most_iff (thick (core_gaps A B) (radius A + radius B))).
  - intros p. rewrite gaps_thick by auto. tauto.
  - apply (thick_most _ n h); auto. lra.
Qed.

(* ---- the signed depth exists ---- *)
Lemma core_gaps_convex : forall A B, convex (core_gaps A B).
Proof. intros. apply difference_of_convex; apply in_core_convex. Qed.

(* a half-space that is the set of gaps *)
Lemma half_space_signed_depth : forall (S : pt -> Prop) n c, n <> origin -> (forall p, S p <-> dot n p <= c) ->
  exists v, signed_depth S v /\ planed S v.
Proof.
  intros S n c Hn H. assert (N := norm_pos n Hn). assert (E : c / norm n * norm n = c) by (field; lra).
  assert (Pl : planed S (c / norm n)). { exists n, c. split; auto. split; [intros p; apply H|lra]. }
  exists (c / norm n). split; auto. split; [|apply planed_most; auto]. apply (half_space_least S n c); auto; [intros p; apply H|lra].
Qed.

Theorem core_gaps_planed : forall A B, comparable (core_of A) (core_of B) -> exists v, signed_depth (core_gaps A B) v /\
  planed (core_gaps A B) v.
Proof.
  intros A B H. unfold core_gaps. destruct H as [[HA HB]|[[HA (n & d & EB & Hn)]|[(n & d & EA & Hn) HB]]].
  - apply signed_depth_planed; [apply core_gaps_convex|]. apply attains_difference; apply attains_core; auto.
  - rewrite EB. destruct (heights_exist _ (attains_core _ HA)) as (h & Hh). destruct (Hh (scal (-1) n)) as [Top (p & Hp & E)].
    apply (half_space_signed_depth _ n (d - dot n p)); auto. intros x. split; [|apply half_space_minus_point; auto].
    intros (b & a & Hb & Ha & ->). simpl in Hb. specialize (Top a Ha). rewrite <- E, !dot_scal_l in Top. rewrite dot_sub_r. lra.
  - rewrite EA. destruct (heights_exist _ (attains_core _ HB)) as (h & Hh). destruct (Hh (scal (-1) n)) as [Top (p & Hp & E)].
    apply (half_space_signed_depth _ (scal (-1) n) (d + dot (scal (-1) n) p)).
    + apply norm2_pos_inv. rewrite norm2_scal. assert (N := norm2_pos n Hn). lra.
    + intros x. split; [|apply point_minus_half_space; auto].
      intros (b & a & Hb & Ha & ->). simpl in Ha. specialize (Top b Hb). rewrite <- E, !dot_scal_l in Top. rewrite !dot_scal_l, dot_sub_r.
      lra.
Qed.

Theorem theorem_R : forall A B v, comparable (core_of A) (core_of B) -> 0 <= radius A -> 0 <= radius B ->
  signed_depth (core_gaps A B) v -> signed_depth (gaps A B) (v + (radius A + radius B)).
Proof.
  intros A B v C HA HB V. destruct (core_gaps_planed A B C) as (w & W & Pl). rewrite (signed_depth_unique _ v w V W).
  split; [apply R_least; auto; apply W|apply R_most; auto].
Qed.

Theorem signed_depth_exists : forall A B, comparable (core_of A) (core_of B) -> 0 <= radius A -> 0 <= radius B ->
  exists v, signed_depth (gaps A B) v.
Proof.
  intros A B C HA HB. destruct (core_gaps_planed A B C) as (v & V & _). eexists. apply theorem_R; eauto.
Qed.

(* in words about A and B: what the shortest translations do *)
Theorem shortest_translation : forall A B v, comparable (core_of A) (core_of B) -> 0 <= radius A -> 0 <= radius B ->
  signed_depth (gaps A B) v ->
  (0 < v -> forall t, norm2 t < v * v -> moved_meets A B t)
  /\ (0 <= v -> forall e, 0 < e -> exists t, norm2 t = (v + e) * (v + e) /\ ~ moved_meets A B t)
  /\ (v < 0 -> forall t, norm2 t < v * v -> ~ moved_meets A B t)
  /\ (v <= 0 -> exists t, norm2 t = v * v /\ moved_meets A B t).
Proof.
  intros A B v C HA HB V. assert (V' := V). destruct V' as [[L0 L1] [M0 M1]]. split; [|split; [|split]].
  - intros Hv t Ht. apply gaps_meet, interior_in, L0; auto.
  - intros Hv e He. destruct (core_gaps_planed A B C) as (w & W & n & h & Hn & Hb & L).
    assert (E := signed_depth_unique _ _ _ V (theorem_R A B w C HA HB W)). exists (along n (v + e)).
    split; [rewrite <- norm_sqr, norm_along by (auto; lra); auto|]. intros I. apply gaps_meet, gaps_thick in I; auto.
    assert (R0 : 0 <= radius A + radius B) by lra. apply (beneath_thick _ n h _ R0 Hb) in I. rewrite dot_along in I by auto.
    assert (N := norm_pos n Hn). nra.
  - intros Hv t Ht I. apply gaps_meet in I. specialize (M1 Hv t I). lra.
  - intros Hv. destruct (L1 Hv) as (p & Hp & N). exists p. split; [|apply gaps_meet; auto]. apply Rle_antisym; auto.
    destruct (Req_dec v 0) as [->|Nv]; [rewrite Rmult_0_r; apply norm2_nonneg|]. apply M1; auto. lra.
Qed.

(* ---- polytopes ---- *)
Lemma polytope_planed : forall A B v, A <> [] -> B <> [] -> signed_depth (P A B) v -> planed (P A B) v.
Proof.
  intros A B v HA HB. apply depth_plane; [apply hull_convex|].
  apply (attains_iff (difference_of (conv B) (conv A))).
  - intros p. rewrite P_minkowski. unfold difference_of. split.
    + intros (b & a & Hb & Ha & E). exists a, b. auto.
    + intros (a & b & Ha & Hb & E). exists b, a. auto.
  - apply attains_difference; [apply (attains_core (Points B))|apply (attains_core (Points A))]; auto.
Qed.
