(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Theorem R: rounding a set by r adds r to its signed depth.  From below for any set, from above by a half-space that holds it. *)
Require Import Reals Lra Psatz List.
From Fathom.geometry Require Import meaning bodies space norm hulls signed_depth.
Open Scope R_scope.

(* ---- rounded sets ---- *)
Lemma thick_norm : forall S r p, 0 <= r -> (thick S r p <-> exists s, S s /\ norm (sub p s) <= r).
Proof. intros S r p Hr. split; intros (s & Hs & H); exists s; split; auto; apply norm_le; auto. Qed.

(* a vector that is at most r + s long is the sum of one of at most r and one of at most s *)
Lemma split_length : forall u r s, 0 <= r -> 0 <= s -> norm u <= r + s ->
  exists v w, u = add v w /\ norm v <= r /\ norm w <= s.
Proof.
  intros u r s Hr Hs H. destruct (Req_dec (r + s) 0) as [E|E].
  - exists u, origin. rewrite norm_origin. repeat split; try lra. pteq; ring.
  - assert (P : 0 < r + s) by lra.
    assert (part : forall k, 0 <= k -> norm (scal (k / (r + s)) u) <= k).
    { intros k Hk. assert (0 <= / (r + s)) by (left; apply Rinv_0_lt_compat; auto).
      rewrite norm_scal by (apply Rmult_le_pos; auto). apply Rmult_le_reg_r with (r + s); auto.
      replace (k / (r + s) * norm u * (r + s)) with (k * norm u) by (field; lra). apply Rmult_le_compat_l; auto. }
    exists (scal (r / (r + s)) u), (scal (s / (r + s)) u). split; [pteq; field; lra|auto].
Qed.

Theorem difference_thick : forall S T r s p, 0 <= r -> 0 <= s ->
  (difference_of (thick T s) (thick S r) p <-> thick (difference_of T S) (r + s) p).
Proof.
  intros S T r s p Hr Hs. rewrite thick_norm by lra. split.
  - intros (b & a & Hb & Ha & ->). apply thick_norm in Ha, Hb; auto.
    destruct Ha as (a' & Ia & Na), Hb as (b' & Ib & Nb).
    exists (sub b' a'). split; [exists b', a'; auto|].
    replace (sub (sub b a) (sub b' a')) with (add (sub b b') (sub a' a)) by (pteq; ring).
    assert (N := norm_triangle (sub b b') (sub a' a)). rewrite (norm_opp a' a) in N. lra.
  - intros (d & (b & a & Hb & Ha & ->) & N). destruct (split_length _ _ _ Hr Hs N) as (v & w & E & V & W).
    exists (add b w), (sub a v). split; [|split].
    + apply thick_norm; auto. exists b. split; auto. replace (sub (add b w) b) with w by (pteq; ring). auto.
    + apply thick_norm; auto. exists a. split; auto. rewrite norm_opp. replace (sub a (sub a v)) with v by (pteq; ring). auto.
    + replace (sub (add b w) (sub a v)) with (add (sub b a) (add v w)) by (pteq; ring). rewrite <- E. pteq; ring.
Qed.

(* ---- from below ---- *)
Lemma interior_thick : forall S r u v, interior S u -> norm v <= r -> interior (thick S r) (add u v).
Proof.
  intros S r u v (e & He & H) Hv. assert (Hr := Rle_trans _ _ _ (norm_nonneg v) Hv).
  exists e. split; auto. intros s Hs. apply thick_norm; auto.
  exists (sub s v). split.
  - apply H. replace (sub (sub s v) u) with (sub s (add u v)) by (pteq; ring). auto.
  - replace (sub s (sub s v)) with v by (pteq; ring). auto.
Qed.

Theorem thick_least : forall S x r, 0 <= r -> at_least S x -> at_least (thick S r) (x + r).
Proof.
  intros S x r Hr [H0 H1]. destruct (Rlt_dec 0 x) as [X|X].
  - split; [|lra]. intros _ t Ht. apply norm_lt in Ht; [|lra].
    assert (Hd : 0 < / (x + r)) by (apply Rinv_0_lt_compat; lra).
    assert (part : forall k, 0 <= k -> norm (scal (k / (x + r)) t) * (x + r) = k * norm t).
    { intros k Hk. rewrite norm_scal by (apply Rmult_le_pos; lra). field. lra. }
    replace t with (add (scal (x / (x + r)) t) (scal (r / (x + r)) t)) by (pteq; field; lra).
    apply interior_thick.
    + apply H0; auto. apply norm_lt; [lra|]. apply Rmult_lt_reg_r with (x + r); [lra|]. rewrite part by lra. nra.
    + apply Rmult_le_reg_r with (x + r); [lra|]. rewrite part by lra. nra.
  - destruct H1 as (p & Hp & N); [lra|]. replace (x * x) with (- x * - x) in N by ring. apply norm_le in N; [|lra].
    split.
    + intros P t Ht. apply norm_lt in Ht; [|lra]. exists (x + r - norm t). split; [lra|].
      intros s Hs. apply norm_lt in Hs; [|lra]. apply thick_norm; auto. exists p. split; auto.
      replace (sub s p) with (add (sub s t) (add t (scal (-1) p))) by (pteq; ring).
      assert (T1 := norm_triangle (sub s t) (add t (scal (-1) p))). assert (T2 := norm_triangle t (scal (-1) p)).
      replace (norm (scal (-1) p)) with (norm p) in T2; [lra|].
      unfold norm. f_equal. rewrite norm2_scal. ring.
    + intros P. destruct (Rle_dec (norm p) r) as [L|L].
      * exists origin. rewrite norm2_origin. split; [|nra]. apply thick_norm; auto. exists p. split; auto.
        rewrite norm_opp. replace (sub p origin) with p by (pteq; ring). auto.
      * assert (Pp : 0 < norm p) by lra. assert (Hi : 0 < / norm p) by (apply Rinv_0_lt_compat; auto).
        assert (Hk : 0 <= r / norm p <= 1).
        { split; [apply Rmult_le_pos; lra|]. apply Rmult_le_reg_r with (norm p); auto. field_simplify; lra. }
        exists (scal (1 - r / norm p) p). split.
        -- apply thick_norm; auto. exists p. split; auto. rewrite norm_opp.
           replace (sub p (scal (1 - r / norm p) p)) with (scal (r / norm p) p) by (pteq; ring).
           rewrite norm_scal by lra. right. field. lra.
        -- replace ((x + r) * (x + r)) with (- (x + r) * - (x + r)) by ring. apply norm_le; [lra|].
           rewrite norm_scal by lra. replace ((1 - r / norm p) * norm p) with (norm p - r) by (field; lra). lra.
Qed.

(* ---- from above ---- *)
Lemma beneath_thick : forall S n h r, 0 <= r -> beneath S n h -> beneath (thick S r) n (h + r * norm n).
Proof.
  intros S n h r Hr H p Hp. apply thick_norm in Hp; auto. destruct Hp as (s & Hs & N).
  replace p with (add s (sub p s)) by (pteq; ring). rewrite dot_add_r.
  assert (D := dot_le_norm n (sub p s)). assert (K := norm_nonneg n). specialize (H s Hs). nra.
Qed.

Theorem thick_most : forall S n h x r, 0 <= r -> n <> origin -> beneath S n h -> h <= x * norm n ->
  at_most (thick S r) (x + r).
Proof.
  intros S n h x r Hr Hn H L. apply (beneath_most _ n (h + r * norm n)); auto; [apply beneath_thick; auto|lra].
Qed.
