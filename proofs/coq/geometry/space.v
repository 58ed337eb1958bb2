(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Algebra of points: determinants, Cauchy-Schwarz. *)
Require Import Reals Lra Psatz List.
From Fathom.geometry Require Import meaning.
Open Scope R_scope.

Definition det (u v w : pt) : R := dot u (cross v w).

Lemma pt_eq : forall u v, px u = px v -> py u = py v -> pz u = pz v -> u = v.
Proof. intros [] []; simpl; intros; subst; reflexivity. Qed.
Ltac pteq := apply pt_eq; simpl.

Lemma scal_scal : forall a b u, scal a (scal b u) = scal (a * b) u.
Proof. intros. pteq; ring. Qed.
Lemma scal_1 : forall u, scal 1 u = u.
Proof. intros. pteq; ring. Qed.
Lemma norm2_scal : forall k u, norm2 (scal k u) = k * k * norm2 u.
Proof. intros. unfold norm2, dot; simpl; ring. Qed.
Lemma dot_scal_l : forall k u v, dot (scal k u) v = k * dot u v.
Proof. intros. unfold dot; simpl; ring. Qed.
Lemma dot_scal_r : forall k u v, dot u (scal k v) = k * dot u v.
Proof. intros. unfold dot; simpl; ring. Qed.
Lemma dot_add_r : forall n u v, dot n (add u v) = dot n u + dot n v.
Proof. intros. unfold dot; simpl; ring. Qed.
Lemma dot_sub_r : forall n u v, dot n (sub u v) = dot n u - dot n v.
Proof. intros. unfold dot; simpl; ring. Qed.
Lemma dot_comm : forall u v, dot u v = dot v u.
Proof. intros. unfold dot; ring. Qed.
Lemma norm2_sub : forall u v, norm2 (sub u v) = norm2 u - 2 * dot u v + norm2 v.
Proof. intros. unfold norm2, dot; simpl; ring. Qed.

Lemma cauchy : forall u v, dot u v * dot u v <= norm2 u * norm2 v.
Proof.
  intros [a b c] [d e f]. unfold norm2, dot; simpl.
  assert (H1 := Rle_0_sqr (a*e-b*d)). assert (H2 := Rle_0_sqr (a*f-c*d)).
  assert (H3 := Rle_0_sqr (b*f-c*e)). unfold Rsqr in *. nra.
Qed.

Lemma norm2_nonneg : forall u, 0 <= norm2 u.
Proof. intros [a b c]; unfold norm2, dot; simpl; nra. Qed.
Lemma norm2_zero : forall u, norm2 u = 0 -> u = origin.
Proof.
  intros [a b c] H. unfold norm2, dot in H; simpl in H.
  assert (a = 0) by nra. assert (b = 0) by nra. assert (c = 0) by nra. subst. reflexivity.
Qed.
Lemma norm2_pos : forall u, u <> origin -> 0 < norm2 u.
Proof.
  intros u H. assert (N := norm2_nonneg u). destruct (Req_dec (norm2 u) 0) as [E|E]; [|lra].
  exfalso. apply H. apply norm2_zero. auto.
Qed.
Lemma norm2_pos_inv : forall u, 0 < norm2 u -> u <> origin.
Proof. intros u H ->. unfold norm2, dot in H; simpl in H. lra. Qed.
Lemma sub_zero : forall u v, norm2 (sub u v) = 0 -> u = v.
Proof.
  intros u v H. apply norm2_zero in H. destruct u, v. unfold sub, origin in H. simpl in H. inversion H.
  pteq; lra.
Qed.
Lemma origin_dec : forall u : pt, u = origin \/ u <> origin.
Proof.
  intros u. destruct (Req_dec (norm2 u) 0) as [E|E]; [left; apply norm2_zero; auto|].
  right. intros ->. apply E. unfold norm2, dot; simpl; ring.
Qed.
Lemma cross_zero_scal : forall k u v, k <> 0 -> cross (scal k u) v = origin -> cross u v = origin.
Proof.
  intros k u v Hk H. apply norm2_zero.
  assert (E : norm2 (cross (scal k u) v) = k * k * norm2 (cross u v)) by (unfold norm2, dot; simpl; ring).
  rewrite H in E. replace (norm2 origin) with 0 in E by (unfold norm2, dot; simpl; ring).
  assert (0 < k * k) by nra. assert (N := norm2_nonneg (cross u v)). nra.
Qed.
