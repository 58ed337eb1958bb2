(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* All claims survive a change of units: both bodies scaled by k > 0. *)
Require Import Reals Lra Psatz List.
From Fathom.geometry Require Import meaning space hulls difference.
Import ListNotations.
Open Scope R_scope.

Notation scaled k L := (map (scal k) L).

Lemma map_scal_inv : forall k L, k <> 0 -> scaled (/ k) (scaled k L) = L.
Proof.
  intros k L Hk. rewrite map_map. rewrite <- (map_id L) at 2. apply map_ext. intros u.
  rewrite scal_scal, Rinv_l by auto. apply scal_1.
Qed.
Lemma scal_inv : forall k u, k <> 0 -> scal k (scal (/ k) u) = u.
Proof. intros. rewrite scal_scal, Rinv_r by auto. apply scal_1. Qed.
Lemma scal_inv' : forall k u, k <> 0 -> scal (/ k) (scal k u) = u.
Proof. intros. rewrite scal_scal, Rinv_l by auto. apply scal_1. Qed.

Lemma P_scal : forall A B k p, P A B p -> P (scaled k A) (scaled k B) (scal k p).
Proof.
  intros A B k p H. apply H.
  - intros u v l Hl Hu Hv.
    replace (scal k (add (scal l u) (scal (1 - l) v)))
      with (add (scal l (scal k u)) (scal (1 - l) (scal k v))) by (pteq; ring).
    apply hull_convex; auto.
  - intros s (a & b & Ia & Ib & ->). apply hull_in. exists (scal k a), (scal k b).
    repeat split; try (apply in_map; auto). pteq; ring.
Qed.

Section Scale.
  Variables (A B : list pt) (k : R).
  Hypothesis Hk : 0 < k.
  Let A' := scaled k A.
  Let B' := scaled k B.

  Lemma P_scal_inv : forall p, P A' B' p -> P A B (scal (/ k) p).
  Proof.
    intros p H. apply (P_scal _ _ (/ k)) in H. unfold A', B' in H. rewrite !map_scal_inv in H by lra. auto.
  Qed.

  Lemma interior_scal : forall t, interior (P A B) t -> interior (P A' B') (scal k t).
  Proof.
    intros t (e & He & H). exists (k * e). split; [nra|].
    intros s Hs. rewrite <- (scal_inv k s) by lra. apply P_scal. apply H.
    replace (sub (scal (/ k) s) t) with (scal (/ k) (sub s (scal k t))) by (pteq; field; lra).
    rewrite norm2_scal. apply Rmult_lt_reg_l with (k * k); [nra|].
    replace (k * k * (/ k * / k * norm2 (sub s (scal k t)))) with (norm2 (sub s (scal k t))) by (field; lra).
    lra.
  Qed.

  Lemma diffs_scal : forall p, diffs A B p -> diffs A' B' (scal k p).
  Proof.
    intros p (a & b & Ia & Ib & ->). exists (scal k a), (scal k b).
    repeat split; try (apply in_map; auto). pteq; ring.
  Qed.

  Lemma height_scal : forall n h, height_is A B n h -> height_is A' B' n (k * h).
  Proof.
    intros n h (H & p & Hp & E). split.
    - intros s Hs. apply P_scal_inv in Hs. specialize (H _ Hs). rewrite dot_scal_r in H.
      apply Rmult_le_reg_l with (/ k); [apply Rinv_0_lt_compat; auto|]. rewrite <- Rmult_assoc, Rinv_l by lra. lra.
    - exists (scal k p). split; [apply P_scal; auto|]. rewrite dot_scal_r, E. auto.
  Qed.

  Lemma foot_scal : forall n t, foot A B n t -> foot A' B' n (scal k t).
  Proof.
    intros n t (h & Hh & ->). exists (k * h). split; [apply height_scal; auto|].
    rewrite scal_scal. unfold Rdiv. rewrite Rmult_assoc. auto.
  Qed.

  Lemma facet_direction_scal : forall n, facet_direction A B n -> facet_direction A' B' n.
  Proof.
    intros n (Hn & h & Hh & u & v & w & Du & Dv & Dw & U & V & W & Hc). split; auto.
    exists (k * h). split; [apply height_scal; auto|].
    exists (scal k u), (scal k v), (scal k w). rewrite !dot_scal_r, U, V, W.
    repeat split; try (apply diffs_scal; auto).
    replace (cross (sub (scal k v) (scal k u)) (sub (scal k w) (scal k u)))
      with (scal (k * k) (cross (sub v u) (sub w u))) by (pteq; ring).
    apply norm2_pos_inv. rewrite norm2_scal. assert (N := norm2_pos _ Hc). repeat apply Rmult_lt_0_compat; auto.
  Qed.
End Scale.

Section Claims.
  Variables (A B : list pt) (k : R).
  Hypothesis Hk : 0 < k.
  Let Hi : 0 < / k := Rinv_0_lt_compat k Hk.

  Lemma interior_scal_iff : forall t, interior (P (scaled k A) (scaled k B)) (scal k t) <-> interior (P A B) t.
  Proof.
    intros t. split; [|apply interior_scal; auto]. intros H.
    apply (interior_scal _ _ (/ k)) in H; auto. rewrite !map_scal_inv, scal_inv' in H by lra. auto.
  Qed.
  Lemma P_scal_iff : forall t, P (scaled k A) (scaled k B) (scal k t) <-> P A B t.
  Proof.
    intros t. split; [|apply P_scal]. intros H. apply P_scal_inv in H; auto. rewrite scal_inv' in H by lra. auto.
  Qed.
  Lemma foot_scal_iff : forall n t, foot (scaled k A) (scaled k B) n (scal k t) <-> foot A B n t.
  Proof.
    intros n t. split; [|apply foot_scal; auto]. intros H.
    apply (foot_scal _ _ (/ k)) in H; auto. rewrite !map_scal_inv, scal_inv' in H by lra. auto.
  Qed.

  Lemma depth_scal : forall q, depth2_is A B q -> depth2_is (scaled k A) (scaled k B) (k * k * q).
  Proof.
    intros q (Hq & H1 & t & Ht & H2). repeat split.
    - repeat apply Rmult_lt_0_compat; auto.
    - intros s Hs. rewrite <- (scal_inv k s) by lra. apply interior_scal_iff. apply H1. rewrite norm2_scal.
      apply Rmult_lt_reg_l with (k * k); [nra|].
      replace (k * k * (/ k * / k * norm2 s)) with (norm2 s) by (field; lra). auto.
    - exists (scal k t). split; [rewrite norm2_scal, Ht; auto|]. rewrite interior_scal_iff. auto.
  Qed.

  Lemma between_scal : forall lo hi, depth2_between A B lo hi ->
    depth2_between (scaled k A) (scaled k B) (k * k * lo) (k * k * hi).
  Proof.
    intros lo hi (q & D & L). exists (k * k * q). split; [apply depth_scal; auto|].
    assert (0 < k * k) by nra. split; nra.
  Qed.

  Lemma origin_scal : scal k origin = origin.
  Proof. pteq; ring. Qed.
  Lemma touching_scal : touching A B -> touching (scaled k A) (scaled k B).
  Proof. intros [H1 H2]. split; rewrite <- origin_scal; [apply P_scal_iff|rewrite interior_scal_iff]; auto. Qed.
  Lemma disjoint_scal : disjoint A B -> disjoint (scaled k A) (scaled k B).
  Proof. intros H1 H2. apply H1. apply P_scal_iff. rewrite origin_scal. auto. Qed.
End Claims.
