(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The signed depth of any set: there is at most one; it lies between each lower and each upper bound; its sign is the status.  A half-space
   that holds the set bounds it from above; a half-space, or a point, in the set from below. *)
Require Import Reals Lra Psatz List.
From Fathom.geometry Require Import meaning bodies space norm hulls flats difference.
Open Scope R_scope.

Lemma at_least_iff : forall S T x, (forall p, S p <-> T p) -> at_least S x -> at_least T x.
Proof.
  intros S T x E [H0 H1]. split.
  - intros Hx t Ht. apply (interior_iff S); auto.
  - intros Hx. destruct (H1 Hx) as (p & Hp & L). exists p. split; auto. apply E; auto.
Qed.
Lemma at_most_iff : forall S T x, (forall p, S p <-> T p) -> at_most S x -> at_most T x.
Proof.
  intros S T x E [H0 H1]. split.
  - intros Hx. destruct (H0 Hx) as (t & L & NI). exists t. split; auto. rewrite <- (interior_iff S); auto.
  - intros Hx p Hp. apply H1; auto. apply E; auto.
Qed.

(* ---- what "at least" and "at most" have to do with each other ---- *)
Theorem least_le_most : forall S x y, at_least S x -> at_most S y -> x <= y.
Proof.
  intros S x y [L0 L1] [M0 M1]. apply Rnot_lt_le. intros L.
  destruct (Rlt_dec 0 x) as [X|X]; destruct (Rle_dec 0 y) as [Y|Y].
  - destruct (M0 Y) as (t & Ht & NI). apply NI, L0; auto. nra.
  - assert (I := L0 X origin). rewrite norm2_origin in I. assert (S origin) by (apply interior_in, I; nra).
    specialize (M1 (Rnot_le_lt _ _ Y) origin H). rewrite norm2_origin in M1. nra.
  - lra.
  - destruct (L1 (Rnot_lt_le _ _ X)) as (p & Hp & N). specialize (M1 (Rnot_le_lt _ _ Y) p Hp). nra.
Qed.

(* the number means what it says: there is at most one *)
Theorem signed_depth_unique : forall S v w, signed_depth S v -> signed_depth S w -> v = w.
Proof. intros S v w [L M] [L' M']. apply Rle_antisym; eapply least_le_most; eauto. Qed.

Theorem signed_depth_within : forall S lo hi v, signed_depth_in S lo hi -> signed_depth S v -> lo <= v <= hi.
Proof. intros S lo hi v [L M] [L' M']. split; eapply least_le_most; eauto. Qed.

Lemma at_least_weaken : forall S x y, y <= x -> at_least S x -> at_least S y.
Proof.
  intros S x y L [H0 H1]. split.
  - intros Hy t Ht. apply H0; nra.
  - intros Hy. destruct (Rlt_dec 0 x) as [X|X].
    + exists origin. rewrite norm2_origin. split; [|nra]. apply interior_in, H0; auto. rewrite norm2_origin. nra.
    + destruct H1 as (p & Hp & N); [lra|]. exists p. split; auto. nra.
Qed.

(* the status is the sign *)
Theorem least_overlap : forall S x, at_least S x -> 0 < x -> overlap S.
Proof. intros S x [H _] Hx. apply H; auto. rewrite norm2_origin. nra. Qed.
Theorem most_apart : forall S x, at_most S x -> x < 0 -> apart S.
Proof. intros S x [_ H] Hx I. specialize (H Hx origin I). rewrite norm2_origin in H. nra. Qed.
Theorem signed_depth_touch : forall S, signed_depth S 0 <-> touch S.
Proof.
  intros S. split.
  - intros [[_ L] [M _]]. destruct L as (p & Hp & N); [lra|]. destruct M as (t & Nt & NI); [lra|].
    assert (Zp := norm2_nonneg p). assert (Zt := norm2_nonneg t).
    rewrite (norm2_zero p) in Hp by lra. rewrite (norm2_zero t) in NI by lra. split; auto.
  - intros [I NI]. split; split; try lra; intros _; exists origin; rewrite norm2_origin; split; auto; lra.
Qed.

(* ---- what bounds it from below ---- *)
(* one point of S at most -x away from O *)
Lemma point_least : forall (S : pt -> Prop) p x, S p -> x <= 0 -> norm2 p <= x * x -> at_least S x.
Proof. intros S p x Hp Hx N. split; [lra|]. intros _. exists p. auto. Qed.

Lemma half_space_least : forall (S : pt -> Prop) n c x, n <> origin -> (forall p, dot n p <= c -> S p) -> x * norm n <= c ->
  at_least S x.
Proof.
  intros S n c x Hn H L. assert (P0 := norm_pos n Hn). split.
  - intros Hx t Ht. exists (x - norm t). apply norm_lt in Ht; [|lra]. split; [lra|].
    intros s Hs. apply norm_lt in Hs; [|lra]. apply H.
    assert (T := norm_triangle (sub s t) t). replace (add (sub s t) t) with s in T by (pteq; ring).
    assert (D := dot_le_norm n s). nra.
  - intros Hx. exists (along n x). unfold along. split.
    + apply H. rewrite dot_scal_r. fold (norm2 n). rewrite <- norm_sqr.
      replace (x / norm n * (norm n * norm n)) with (x * norm n) by (field; lra). auto.
    + rewrite norm2_scal, <- norm_sqr. right. field. lra.
Qed.

(* ---- what bounds it from above: half-spaces that hold the set ---- *)
Definition beneath (S : pt -> Prop) (n : pt) (h : R) : Prop := forall p, S p -> dot n p <= h.

Theorem beneath_most : forall S n h x, n <> origin -> beneath S n h -> h <= x * norm n -> at_most S x.
Proof.
  intros S n h x Hn H L. assert (P := norm_pos n Hn). split.
  - intros Hx. exists (scal (x / norm n) n).
    assert (K : 0 <= x / norm n) by (apply Rmult_le_pos; auto; left; apply Rinv_0_lt_compat; auto). split.
    + apply norm_le; auto. rewrite norm_scal by auto. right. field. lra.
    + apply (halfspace_not_interior _ n h); auto.
      * apply norm2_pos. auto.
      * rewrite dot_scal_r. fold (norm2 n). rewrite <- norm_sqr. replace (x / norm n * (norm n * norm n)) with (x * norm n) by (field; lra).
        auto.
  - intros Hx p Hp. replace (x * x) with (- x * - x) by ring. apply norm_ge; [lra|].
    specialize (H p Hp). assert (D := dot_le_norm (scal (-1) n) p). rewrite dot_scal_l in D.
    replace (norm (scal (-1) n)) with (norm n) in D by (unfold norm; f_equal; rewrite norm2_scal; ring).
    apply Rmult_le_reg_l with (norm n); auto. lra.
Qed.

(* a half-space shows that the signed depth of S is at most x *)
Definition planed (S : pt -> Prop) (x : R) : Prop := exists n h, n <> origin /\ beneath S n h /\ h <= x * norm n.

Lemma planed_most : forall S x, planed S x -> at_most S x.
Proof. intros S x (n & h & Hn & Hb & L). apply (beneath_most S n h); auto. Qed.

(* the signed depth where it is positive is the depth of format 1 *)
Theorem signed_depth_depth : forall A B v, 0 < v -> (signed_depth (P A B) v <-> depth2_is A B (v * v)).
Proof.
  intros A B v Hv. split.
  - intros [[L _] [M _]]. destruct M as (t & Nt & NI); [lra|]. repeat split; [nra|auto|].
    exists t. split; auto. apply Rle_antisym; auto. apply Rnot_lt_le. intros G. apply NI, L; auto.
  - intros (_ & L & t & Nt & NI). split; split; try lra; auto. intros _. exists t. split; auto. lra.
Qed.

