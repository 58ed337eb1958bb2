(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What is said of unions survives a change of units: all pieces scaled by k > 0. *)
Require Import Reals Lra Psatz List.
From Fathom.geometry Require Import meaning space hulls difference scaling units unions.
Import ListNotations.
Open Scope R_scope.

Notation scaled_pieces k Ls := (map (map (scal k)) Ls).

Lemma pieces_back : forall k Ls, k <> 0 -> scaled_pieces (/ k) (scaled_pieces k Ls) = Ls.
Proof. intros k Ls Hk. rewrite map_map. rewrite <- (map_id Ls) at 2. apply map_ext. intros L. apply map_scal_inv. auto. Qed.

Lemma conv_scal : forall k L p, conv L p -> conv (scaled k L) (scal k p).
Proof. intros k L p. apply hull_scal. intros s. apply in_map. Qed.
Lemma union_scal : forall k Ls p, union Ls p -> union (scaled_pieces k Ls) (scal k p).
Proof. intros k Ls p (L & HL & Hp). exists (scaled k L). split; [apply in_map; auto|apply conv_scal; auto]. Qed.

Lemma overlap_scal : forall k As Bs t, 0 < k -> overlap_at As Bs t -> overlap_at (scaled_pieces k As) (scaled_pieces k Bs) (scal k t).
Proof.
  intros k As Bs t Hk (p & Hp & Hq). exists (scal k p). split.
  - replace (sub (scal k p) (scal k t)) with (scal k (sub p t)) by (pteq; ring).
    apply (interior_scal_set (union As)); auto. intros x. apply union_scal.
  - apply (interior_scal_set (union Bs)); auto. intros x. apply union_scal.
Qed.

Lemma solid_scal : forall k Ls, 0 < k -> solid_pieces Ls -> solid_pieces (scaled_pieces k Ls).
Proof.
  intros k Ls Hk [N H]. split; [destruct Ls; [congruence|discriminate]|]. intros L HL. apply in_map_iff in HL.
  destruct HL as (K & <- & HK). destruct (H K HK) as (p & Hp). exists (scal k p).
  apply (interior_scal_set (conv K)); auto. intros x. apply conv_scal.
Qed.

Section Scale.
  Variables (As Bs : list (list pt)) (k : R).
  Hypothesis Hk : 0 < k.
  Let As' := scaled_pieces k As.
  Let Bs' := scaled_pieces k Bs.
  Let Hi : 0 < / k := Rinv_0_lt_compat k Hk.

  Lemma overlap_scal_iff : forall t, overlap_at As' Bs' (scal k t) <-> overlap_at As Bs t.
  Proof.
    intros t. split; [|apply overlap_scal; auto]. intros H. apply (overlap_scal (/ k)) in H; auto.
    unfold As', Bs' in H. rewrite !pieces_back, scal_inv' in H by lra. auto.
  Qed.
  Lemma union_back : forall Ls p, union (scaled_pieces k Ls) p -> union Ls (scal (/ k) p).
  Proof. intros Ls p H. apply (union_scal (/ k)) in H. rewrite pieces_back in H by lra. auto. Qed.

  Lemma norm2_times : forall t q, norm2 (scal k t) = k * k * q <-> norm2 t = q.
  Proof.
    assert (P0 : 0 < k * k) by (apply Rmult_lt_0_compat; auto). intros t q. rewrite norm2_scal.
    split; intros H; [apply Rmult_eq_reg_l with (k * k); lra|rewrite H; auto].
  Qed.

  Lemma way_out_scal_iff : forall q t, shortest_way_out As' Bs' (k * k * q) (scal k t) <-> shortest_way_out As Bs q t.
  Proof. intros q t. unfold shortest_way_out. rewrite norm2_times, overlap_scal_iff. tauto. Qed.

  Lemma union_depth_scal : forall q, union_depth2_is As Bs q -> union_depth2_is As' Bs' (k * k * q).
  Proof.
    intros q (Hq & H & t & W). assert (P0 : 0 < k * k) by (apply Rmult_lt_0_compat; auto). split; [apply Rmult_lt_0_compat; auto|]. split.
    - intros s Hs. rewrite <- (scal_inv k s) by lra. apply overlap_scal_iff, H. rewrite norm2_scal.
      apply Rmult_lt_reg_l with (k * k); auto. replace (k * k * (/ k * / k * norm2 s)) with (norm2 s) by (field; lra). auto.
    - exists (scal k t). apply way_out_scal_iff. exact W.
  Qed.

  Lemma unions_touch_scal : unions_touch As Bs -> unions_touch As' Bs'.
  Proof.
    intros [(p & Hp & Hq) N]. split; [exists (scal k p); split; apply union_scal; auto|].
    rewrite <- (origin_scal k), overlap_scal_iff. auto.
  Qed.

  Lemma distance_scal : forall q, unions_distance2_is As Bs q -> unions_distance2_is As' Bs' (k * k * q).
  Proof.
    intros q (Hq & H & a & b & Ha & Hb & E). assert (P0 : 0 < k * k) by (apply Rmult_lt_0_compat; auto).
    split; [apply Rmult_lt_0_compat; auto|]. split.
    - intros x y Hx Hy. apply union_back in Hx, Hy. specialize (H _ _ Hx Hy).
      replace (sub (scal (/ k) y) (scal (/ k) x)) with (scal (/ k) (sub y x)) in H by (pteq; ring). rewrite norm2_scal in H.
      apply Rmult_le_compat_l with (r := k * k) in H; [|lra].
      replace (k * k * (/ k * / k * norm2 (sub y x))) with (norm2 (sub y x)) in H by (field; lra). auto.
    - exists (scal k a), (scal k b). split; [apply union_scal; auto|]. split; [apply union_scal; auto|].
      replace (sub (scal k b) (scal k a)) with (scal k (sub b a)) by (pteq; ring). apply norm2_times. auto.
  Qed.
End Scale.
