(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Compactness, as far as depths need it: a set attains the least value of each Lipschitz function.  Points, segments, balls, affine images,
   sums and hulls of finitely many such sets do; the points of the unit sphere too. *)
Require Import Reals Lra Psatz List.
From Fathom.geometry Require Import limits meaning bodies space norm hulls.
Import ListNotations.
Open Scope R_scope.

Definition lipschitz (c : R) (f : pt -> R) : Prop := 0 <= c /\ forall p q, f p - f q <= c * norm (sub p q).
(* what has the least value is found, not only there: so a minimum of minima is a function again *)
Definition attains (S : pt -> Prop) : Type := forall f c, lipschitz c f -> { p | S p /\ forall q, S q -> f p <= f q }.

Lemma attains_iff : forall S T, (forall p, S p <-> T p) -> attains S -> attains T.
Proof.
  intros S T E H f c Hf. destruct (H f c Hf) as (p & Hp & M). exists p. split; [apply E; auto|]. intros q Hq. apply M, E; auto.
Qed.
Lemma attains_point : forall p, attains (fun q => q = p).
Proof. intros p f c Hf. exists p. split; auto. intros q ->. lra. Qed.

(* ---- images, sums ---- *)
Lemma attains_image : forall (S T : pt -> Prop) (g : pt -> pt) k, 0 <= k -> (forall p q, norm (sub (g p) (g q)) <= k * norm (sub p q)) ->
  (forall q, T q <-> exists p, S p /\ q = g p) -> attains S -> attains T.
Proof.
  intros S T g k Hk G E H f c [Hc Hf]. destruct (H (fun p => f (g p)) (c * k)) as (p & Hp & M).
  - split; [apply Rmult_le_pos; auto|]. intros p q. eapply Rle_trans; [apply Hf|]. rewrite Rmult_assoc. apply Rmult_le_compat_l; auto.
  - exists (g p). split; [apply E; exists p; auto|]. intros q Hq. apply E in Hq. destruct Hq as (r & Hr & ->). auto.
Qed.

Lemma attains_scal : forall S k, attains S -> attains (fun q => exists p, S p /\ q = scal k p).
Proof.
  intros S k. apply (attains_image S _ (scal k) (Rabs k)); [apply Rabs_pos| |tauto]. intros p q.
  replace (sub (scal k p) (scal k q)) with (scal k (sub p q)) by (pteq; ring).
  rewrite norm_scal_abs. lra.
Qed.

Lemma attains_sum : forall S T, attains S -> attains T -> attains (sum_of S T).
Proof.
  intros S T HS HT f c [Hc Hf].
  assert (Hg : forall s, lipschitz c (fun t => f (add s t))).
  { intros s. split; auto. intros p q. replace (sub p q) with (sub (add s p) (add s q)) by (pteq; ring). apply Hf. }
  set (best := fun s => proj1_sig (HT _ c (Hg s))).
  assert (B : forall s, T (best s) /\ forall t, T t -> f (add s (best s)) <= f (add s t)) by (intros s; exact (proj2_sig (HT _ c (Hg s)))).
  clearbody best. destruct (HS (fun s => f (add s (best s))) c) as (s & Is & M).
  - split; auto. intros p q. destruct (B p) as [_ L]. destruct (B q) as [Iq _]. specialize (L _ Iq).
    specialize (Hf (add p (best q)) (add q (best q))). replace (sub (add p (best q)) (add q (best q))) with (sub p q) in Hf by (pteq;
      ring). lra.
  - exists (add s (best s)). split; [exists s, (best s); split; auto; split; auto; apply B|].
    intros q (x & y & Ix & Iy & ->). specialize (M x Ix). simpl in M. destruct (B x) as [_ L]. specialize (L y Iy). lra.
Qed.

Lemma attains_difference : forall S T, attains S -> attains T -> attains (difference_of S T).
Proof.
  intros S T HS HT. apply (attains_iff (sum_of S (fun q => exists p, T p /\ q = scal (-1) p))).
  - intros p. split.
    + intros (s & t & Hs & (q & Hq & ->) & ->). exists s, q. repeat split; auto. pteq; ring.
    + intros (s & t & Hs & Ht & ->). exists s, (scal (-1) t). split; auto. split; [exists t; auto|pteq; ring].
  - apply attains_sum; auto. apply attains_scal; auto.
Qed.

(* ---- balls ---- *)
Lemma attains_segment : forall v, attains (fun q => exists t, -1 <= t <= 1 /\ q = scal t v).
Proof.
  intros v f c [Hc Hf]. destruct (least_attained (fun t => f (scal t v)) (c * norm v)) with (a := -1) (b := 1) as (t & B & M); try lra.
  - apply Rmult_le_pos; auto. apply norm_nonneg.
  - intros x y. eapply Rle_trans; [apply Hf|]. rewrite Rmult_assoc. apply Rmult_le_compat_l; auto.
    replace (sub (scal x v) (scal y v)) with (scal (x - y) v) by (pteq; ring). rewrite norm_scal_abs. lra.
  - exists (scal t v). split; [exists t; auto|]. intros q (s & Hs & ->). auto.
Qed.

Definition unit_ball (p : pt) : Prop := norm2 p <= 1.
Lemma unit_ball_norm : forall p, unit_ball p <-> norm p <= 1.
Proof. intros p. unfold unit_ball. rewrite <- (norm_le p 1) by lra. rewrite Rmult_1_r. tauto. Qed.

(* the part of a cube, by a price for what is outside *)
Theorem attains_ball : attains unit_ball.
Proof.
  intros f c [Hc Hf].
  set (cube := sum_of (fun q => exists t, -1 <= t <= 1 /\ q = scal t (mk 1 0 0))
    (sum_of (fun q => exists t, -1 <= t <= 1 /\ q = scal t (mk 0 1 0)) (fun q => exists t, -1 <= t <= 1 /\ q = scal t (mk 0 0 1)))).
  assert (H : attains cube) by (repeat apply attains_sum; apply attains_segment).
  set (over := fun p => Rmax 0 (norm p - 1)).
  assert (inside : forall p, unit_ball p -> cube p /\ over p = 0).
  { intros p Hp. split.
    - destruct p as [x y z]. unfold unit_ball, norm2, dot in Hp. simpl in Hp.
      exists (scal x (mk 1 0 0)), (add (scal y (mk 0 1 0)) (scal z (mk 0 0 1))).
      split; [exists x; split; auto; nra|]. split; [|pteq; ring]. eexists _, _. split; [exists y; split; [nra|reflexivity]|].
      split; [exists z; split; [nra|reflexivity]|reflexivity].
    - apply unit_ball_norm in Hp. unfold over. apply Rmax_left. lra. }
  destruct (H (fun p => f p + c * over p) (2 * c)) as (p & Hp & M).
  - split; [lra|]. intros p q. specialize (Hf p q).
    assert (T := norm_triangle (sub p q) q). replace (add (sub p q) q) with p in T by (pteq; ring).
    assert (O : over p - over q <= norm (sub p q)).
    { assert (N := norm_nonneg (sub p q)). unfold over, Rmax. destruct (Rle_dec 0 (norm p - 1)), (Rle_dec 0 (norm q - 1)); lra. }
    assert (c * (over p - over q) <= c * norm (sub p q)) by (apply Rmult_le_compat_l; auto). lra.
  - destruct (Rle_dec (norm p) 1) as [L|L].
    + exists p. split; [apply unit_ball_norm; auto|]. intros q Hq. destruct (inside q Hq) as [Iq Oq]. specialize (M q Iq).
      destruct (inside p) as [_ Op]; [apply unit_ball_norm; auto|]. rewrite Op, Oq in M. lra.
    + assert (P : 0 < norm p) by lra. assert (Hi : 0 < / norm p) by (apply Rinv_0_lt_compat; auto).
      exists (scal (/ norm p) p). split; [apply unit_ball_norm; rewrite norm_scal by lra; right; field; lra|].
      intros q Hq. destruct (inside q Hq) as [Iq Oq]. specialize (M q Iq). rewrite Oq in M.
      specialize (Hf (scal (/ norm p) p) p). assert (E : norm (sub (scal (/ norm p) p) p) = norm p - 1).
      { rewrite norm_opp. replace (sub p (scal (/ norm p) p)) with (scal (1 - / norm p) p) by (pteq; ring).
        assert (/ norm p < 1) by (rewrite <- Rinv_1; apply Rinv_lt_contravar; lra). rewrite norm_scal by lra. field. lra. }
      rewrite E in Hf. assert (over p = norm p - 1) by (apply Rmax_right; lra). nra.
Qed.

Lemma attains_bounded : forall S, attains S -> { r | 0 <= r /\ forall p, S p -> norm p <= r }.
Proof.
  intros S H. destruct (H (fun p => - norm p) 1) as (p & _ & M).
  - split; [lra|]. intros p q. assert (T := norm_triangle (sub q p) p). replace (add (sub q p) p) with q in T by (pteq; ring).
    rewrite (norm_opp p q). lra.
  - exists (norm p). split; [apply norm_nonneg|]. intros q Hq. specialize (M q Hq). lra.
Qed.

(* whether a point is in such a set is decided: by its distance *)
Lemma member_or_not : forall S p, attains S -> S p \/ ~ S p.
Proof.
  intros S p H. destruct (H (fun q => norm (sub q p)) 1) as (q & Hq & M).
  - split; [lra|]. intros q r. assert (T := norm_triangle (sub q r) (sub r p)).
    replace (add (sub q r) (sub r p)) with (sub q p) in T by (pteq; ring). lra.
  - destruct (origin_dec (sub q p)) as [E|E].
    + left. replace p with q; auto. apply sub_zero. rewrite E. apply norm2_origin.
    + right. intros I. specialize (M p I). simpl in M. assert (P := norm_pos _ E).
      replace (sub p p) with origin in M by (pteq; ring). rewrite norm_origin in M. lra.
Qed.

(* ---- hulls of finitely many sets ---- *)
Definition join (S T : pt -> Prop) (q : pt) : Prop := exists l s t, 0 <= l <= 1 /\ S s /\ T t /\ q = add (scal l s) (scal (1 - l) t).

Lemma attains_join : forall S T, attains S -> attains T -> attains (join S T).
Proof.
  intros S T HS HT f c [Hc Hf].
  destruct (attains_bounded S HS) as (r & Pr & Br). destruct (attains_bounded T HT) as (k & Pk & Bk).
  set (mix := fun l => sum_of (fun q => exists p, S p /\ q = scal l p) (fun q => exists p, T p /\ q = scal (1 - l) p)).
  assert (G : forall l, attains (mix l)) by (intros; apply attains_sum; apply attains_scal; auto).
  set (best := fun l => proj1_sig (G l f c (conj Hc Hf))).
  assert (B : forall l, mix l (best l) /\ forall q, mix l q -> f (best l) <= f q) by (intros l; exact (proj2_sig (G l f c (conj Hc Hf)))).
  clearbody best. assert (mixed : forall l s t, S s -> T t -> mix l (add (scal l s) (scal (1 - l) t))).
  { intros l s t Hs Ht. eexists _, _. split; [exists s; eauto|]. split; [exists t; eauto|reflexivity]. }
  destruct (least_attained (fun l => f (best l)) (c * (r + k))) with (a := 0) (b := 1) as (l & Bl & M); try lra.
  - apply Rmult_le_pos; lra.
  - intros x y. destruct (B y) as [(s & t & (s' & Hs & ->) & (t' & Ht & ->) & E) _]. rewrite E.
    destruct (B x) as [_ L]. specialize (L _ (mixed x s' t' Hs Ht)).
    specialize (Hf (add (scal x s') (scal (1 - x) t')) (add (scal y s') (scal (1 - y) t'))).
    replace (sub (add (scal x s') (scal (1 - x) t')) (add (scal y s') (scal (1 - y) t'))) with (scal (x - y) (sub s' t')) in Hf by (pteq;
      ring).
    assert (D : norm (sub s' t') <= r + k).
    { assert (Tr := norm_triangle s' (scal (-1) t')). rewrite norm_minus in Tr.
      replace (add s' (scal (-1) t')) with (sub s' t') in Tr by (pteq; ring). specialize (Br s' Hs). specialize (Bk t' Ht). lra. }
    assert (N : c * norm (scal (x - y) (sub s' t')) <= c * ((r + k) * Rabs (x - y))).
    { apply Rmult_le_compat_l; auto. rewrite norm_scal_abs, Rmult_comm. apply Rmult_le_compat_r; auto. apply Rabs_pos. }
    lra.
  - exists (best l). split.
    + destruct (B l) as [(s & t & (s' & Hs & ->) & (t' & Ht & ->) & E) _]. exists l, s', t'. auto.
    + intros q (m & s & t & Bm & Hs & Ht & ->). specialize (M m Bm). simpl in M. destruct (B m) as [_ L].
      specialize (L _ (mixed m s t Hs Ht)). lra.
Qed.

(* a x + b y in a convex set's multiple by a + b *)
Lemma convex_sum : forall (S : pt -> Prop) x y a b, convex S -> S x -> S y -> 0 <= a -> 0 <= b ->
  exists z, S z /\ add (scal a x) (scal b y) = scal (a + b) z.
Proof.
  intros S x y a b C Hx Hy Ha Hb. destruct (Req_dec (a + b) 0) as [Z|Z].
  - exists x. split; auto. assert (a = 0) by lra. assert (b = 0) by lra. subst. pteq; ring.
  - assert (P : 0 < / (a + b)) by (apply Rinv_0_lt_compat; lra).
    exists (add (scal (a / (a + b)) x) (scal (1 - a / (a + b)) y)). split; [|pteq; field; lra]. apply C; auto.
    split; [apply Rmult_le_pos; lra|]. apply Rmult_le_reg_r with (a + b); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra.
Qed.

Lemma join_convex : forall S T, convex S -> convex T -> convex (join S T).
Proof.
  intros S T CS CT u v m Hm (l & s & t & Hl & Hs & Ht & ->) (l' & s' & t' & Hl' & Hs' & Ht' & ->).
  destruct (convex_sum S s s' (m * l) ((1 - m) * l')) as (x & Hx & Ex); auto; try (apply Rmult_le_pos; lra).
  destruct (convex_sum T t t' (m * (1 - l)) ((1 - m) * (1 - l'))) as (y & Hy & Ey); auto; try (apply Rmult_le_pos; lra).
  exists (m * l + (1 - m) * l'), x, y. split; [nra|]. split; auto. split; auto.
  rewrite <- Ex. replace (1 - (m * l + (1 - m) * l')) with (m * (1 - l) + (1 - m) * (1 - l')) by ring. rewrite <- Ey. pteq; ring.
Qed.

Theorem attains_hull : forall (X : Type) (F : X -> pt -> Prop) l, l <> [] -> (forall x, convex (F x)) -> (forall x, attains (F x)) ->
  attains (hull (fun p => exists x, In x l /\ F x p)).
Proof.
  intros X F l Hl C H. induction l as [|x l IH]; [congruence|]. clear Hl.
  assert (mono : forall p, hull (fun p => exists y, In y l /\ F y p) p -> hull (fun p => exists y, In y (x :: l) /\ F y p) p).
  { intros p. apply hull_mono. intros s (y & Iy & Hy). exists y. simpl. auto. }
  destruct l as [|x' l].
  - apply (attains_iff (F x)); auto. intros p. split.
    + intros Hp. apply hull_in. exists x. simpl. auto.
    + intros Hp. apply Hp; auto. intros s (y & [<-|[]] & Hy). auto.
  - apply (attains_iff (join (F x) (hull (fun p => exists y, In y (x' :: l) /\ F y p)))).
    + intros p. split.
      * intros (k & s & t & Hk & Hs & Ht & ->). apply hull_convex; auto. apply hull_in. exists x. simpl. auto.
      * intros Hp. assert (some : exists s, F x s) by (destruct (H x (fun _ => 0) 0) as (s & Is & _); [split; intros; lra|exists s; auto]).
        destruct some as (s0 & H0).
        assert (some : exists t, F x' t) by (destruct (H x' (fun _ => 0) 0) as (t & It & _); [split; intros; lra|exists t; auto]).
        destruct some as (t0 & H1).
        apply Hp; [apply join_convex; auto; apply hull_convex|]. intros s (y & [<-|Iy] & Hy).
        -- exists 1, s, t0. split; [lra|]. split; auto. split; [apply hull_in; exists x'; simpl; auto|pteq; ring].
        -- exists 0, s0, s. split; [lra|]. split; auto. split; [apply hull_in; exists y; auto|pteq; ring].
    + apply attains_join; auto. apply IH. discriminate.
Qed.
