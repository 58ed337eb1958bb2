(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Roots and lengths.  The root is that of limits.v, not the library's sqrt, which rests on one axiom more. *)
Require Import Reals Lra Psatz.
From Fathom.geometry Require Import limits meaning bodies space.
Open Scope R_scope.

(* ---- roots ---- *)
Lemma root_pos : forall x, 0 <= root x.
Proof. intros x. unfold root. destruct (Rle_dec 0 x) as [H|H]; [apply (proj2_sig (root_exists x H))|lra]. Qed.
Lemma root_sqr : forall x, 0 <= x -> root x * root x = x.
Proof. intros x Hx. unfold root. destruct (Rle_dec 0 x) as [H|H]; [apply (proj2_sig (root_exists x H))|lra]. Qed.
Lemma root_unique : forall x y, 0 <= y -> y * y = x -> root x = y.
Proof. intros x y Hy E. assert (P := root_pos x). assert (S := root_sqr x). subst x. assert (Q := S (Rle_0_sqr y)). nra. Qed.
Lemma root_positive : forall x, 0 < x -> 0 < root x.
Proof. intros x Hx. assert (P := root_pos x). assert (S := root_sqr x). nra. Qed.

Definition signed_sqr (x : R) : R := x * Rabs x.

Lemma signed_sqr_pos : forall x, 0 <= x -> signed_sqr x = x * x.
Proof. intros x H. unfold signed_sqr. rewrite Rabs_right; lra. Qed.
Lemma signed_sqr_neg : forall x, x <= 0 -> signed_sqr x = - (x * x).
Proof. intros x H. unfold signed_sqr. rewrite Rabs_left1; lra. Qed.
Lemma signed_sqr_le : forall x y, signed_sqr x <= signed_sqr y <-> x <= y.
Proof.
  intros x y. destruct (Rle_dec 0 x) as [X|X]; [rewrite (signed_sqr_pos x) by lra|rewrite (signed_sqr_neg x) by lra];
    (destruct (Rle_dec 0 y) as [Y|Y]; [rewrite (signed_sqr_pos y) by lra|rewrite (signed_sqr_neg y) by lra]);
    split; intros H; try nra; apply Rnot_lt_le; intros L; nra.
Qed.
Lemma signed_sqr_inj : forall x y, signed_sqr x = signed_sqr y -> x = y.
Proof. intros x y H. apply Rle_antisym; apply signed_sqr_le; lra. Qed.
Lemma signed_sqr_scal : forall k x, 0 <= k -> signed_sqr (k * x) = k * k * signed_sqr x.
Proof. intros k x Hk. unfold signed_sqr. rewrite Rabs_mult, (Rabs_right k) by lra. ring. Qed.
Lemma signed_sqr_root : forall x, signed_sqr (signed_root x) = x.
Proof.
  intros x. unfold signed_root. destruct (Rle_dec 0 x) as [H|H].
  - rewrite signed_sqr_pos by apply root_pos. apply root_sqr. auto.
  - assert (P := root_pos (- x)). assert (S := root_sqr (- x)). rewrite signed_sqr_neg by lra. lra.
Qed.
Lemma signed_root_scal : forall k x, 0 <= k -> signed_root (k * k * x) = k * signed_root x.
Proof. intros k x Hk. apply signed_sqr_inj. rewrite signed_sqr_scal, !signed_sqr_root; auto. Qed.
Lemma signed_root_opp : forall x, signed_root (- x) = - signed_root x.
Proof.
  intros x. apply signed_sqr_inj. rewrite signed_sqr_root. unfold signed_sqr. rewrite Rabs_Ropp, <- (signed_sqr_root x) at 1.
  unfold signed_sqr. ring.
Qed.

(* ---- lengths ---- *)
Definition norm (u : pt) : R := root (norm2 u).

Lemma norm_nonneg : forall u, 0 <= norm u.
Proof. intros. apply root_pos. Qed.
Lemma norm_sqr : forall u, norm u * norm u = norm2 u.
Proof. intros. apply root_sqr, norm2_nonneg. Qed.
Lemma norm_unique : forall u x, 0 <= x -> norm2 u = x * x -> norm u = x.
Proof. intros u x Hx E. apply root_unique; auto. Qed.
Lemma norm_le : forall u x, 0 <= x -> (norm2 u <= x * x <-> norm u <= x).
Proof. intros u x Hx. assert (N := norm_nonneg u). rewrite <- norm_sqr. split; intros H; [apply Rnot_lt_le; intros L|]; nra. Qed.
Lemma norm_lt : forall u x, 0 <= x -> (norm2 u < x * x <-> norm u < x).
Proof. intros u x Hx. assert (N := norm_nonneg u). rewrite <- norm_sqr. split; intros H; [apply Rnot_le_lt; intros L|]; nra. Qed.
Lemma norm_ge : forall u x, 0 <= x -> (x * x <= norm2 u <-> x <= norm u).
Proof. intros u x Hx. assert (N := norm_nonneg u). rewrite <- norm_sqr. split; intros H; [apply Rnot_lt_le; intros L|]; nra. Qed.
Lemma norm_pos : forall u, u <> origin -> 0 < norm u.
Proof. intros u H. apply root_positive, norm2_pos, H. Qed.
Lemma norm_scal : forall k u, 0 <= k -> norm (scal k u) = k * norm u.
Proof.
  intros k u Hk. assert (N := norm_nonneg u). apply norm_unique; [apply Rmult_le_pos; auto|].
  rewrite norm2_scal, <- norm_sqr. ring.
Qed.
Lemma norm_minus : forall u, norm (scal (-1) u) = norm u.
Proof. intros u. unfold norm. f_equal. rewrite norm2_scal. ring. Qed.
Lemma norm_scal_abs : forall k u, norm (scal k u) = Rabs k * norm u.
Proof.
  intros k u. unfold Rabs. destruct (Rcase_abs k); [|apply norm_scal; lra]. rewrite <- norm_minus, scal_scal, norm_scal by lra. ring.
Qed.
Lemma norm_opp : forall u v, norm (sub u v) = norm (sub v u).
Proof. intros. unfold norm. f_equal. unfold norm2, dot; simpl; ring. Qed.
Lemma dot_le_norm : forall u v, dot u v <= norm u * norm v.
Proof.
  intros u v. assert (C := cauchy u v). assert (A := norm_nonneg u). assert (B := norm_nonneg v).
  rewrite <- !norm_sqr in C. assert (0 <= norm u * norm v) by nra. apply Rnot_lt_le. intros L. nra.
Qed.
Lemma norm_triangle : forall u v, norm (add u v) <= norm u + norm v.
Proof.
  intros u v. assert (A := norm_nonneg u). assert (B := norm_nonneg v). assert (D := dot_le_norm u v). apply norm_le; [lra|].
  replace (norm2 (add u v)) with (norm2 u + norm2 v + 2 * dot u v) by (unfold norm2, dot; simpl; ring).
  rewrite <- (norm_sqr u), <- (norm_sqr v). lra.
Qed.
Lemma norm2_origin : norm2 origin = 0.
Proof. unfold norm2, dot; simpl; ring. Qed.
Lemma norm_origin : norm origin = 0.
Proof. apply norm_unique; [lra|]. rewrite norm2_origin. ring. Qed.
Lemma dot_origin_r : forall u, dot u origin = 0.
Proof. intros. unfold dot; simpl; ring. Qed.

(* ---- v n/|n| ---- *)
Definition along (n : pt) (v : R) : pt := scal (v / norm n) n.

Lemma norm_along : forall n v, n <> origin -> 0 <= v -> norm (along n v) = v.
Proof.
  intros n v Hn Hv. assert (N := norm_pos n Hn). unfold along.
  rewrite norm_scal by (apply Rmult_le_pos; auto; left; apply Rinv_0_lt_compat; auto). field. lra.
Qed.
Lemma dot_along : forall n v, n <> origin -> dot n (along n v) = v * norm n.
Proof.
  intros n v Hn. assert (N := norm_pos n Hn). unfold along. rewrite dot_scal_r. fold (norm2 n). rewrite <- norm_sqr. field. lra.
Qed.
