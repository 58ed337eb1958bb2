(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A convex set that attains least values has a signed depth: minus the distance of its nearest point, or the least of its heights. *)
Require Import Reals Lra Psatz List.
From Fathom.geometry Require Import meaning bodies space norm hulls signed_depth compact.
Open Scope R_scope.

Lemma dot_near : forall p z l, norm2 (add (scal l z) (scal (1 - l) p)) = norm2 p - 2 * l * (norm2 p - dot p z) + l * l * norm2 (sub z p).
Proof. intros. unfold norm2, dot; simpl; ring. Qed.

(* the nearest point of a convex set has all of it beyond the plane through it *)
Lemma nearest_beneath : forall S p, convex S -> S p -> (forall s, S s -> norm2 p <= norm2 s) ->
  beneath S (scal (-1) p) (- norm2 p).
Proof.
  intros S p HC Hp H s Hs. rewrite dot_scal_l. apply Rnot_lt_le. intros L.
  assert (D : 0 < norm2 p - dot p s) by lra. set (d := norm2 p - dot p s) in *.
  assert (N := norm2_nonneg (sub s p)). set (w := norm2 (sub s p)) in *.
  set (l := d / (d + w)).
  assert (Hl : 0 < l) by (apply Rdiv_lt_0_compat; lra).
  assert (El : l * (d + w) = d) by (unfold l; field; lra).
  assert (Hl1 : l <= 1) by nra.
  assert (G := H _ (HC s p l (conj (Rlt_le _ _ Hl) Hl1) Hs Hp)). rewrite dot_near in G. fold d w in G. nra.
Qed.

(* a convex set's nearest point to x, which is not in it: a plane between them *)
Lemma separating_plane : forall S x, convex S -> attains S -> ~ S x -> exists n h, n <> origin /\ beneath S n h /\ h < dot n x.
Proof.
  intros S x C H Nx. destruct (H (fun p => norm (sub p x)) 1) as (p & Hp & M).
  - split; [lra|]. intros p q. assert (T := norm_triangle (sub p q) (sub q x)).
    replace (add (sub p q) (sub q x)) with (sub p x) in T by (pteq; ring). lra.
  - exists (sub x p), (dot (sub x p) x - norm2 (sub x p)).
    assert (Hn : sub x p <> origin).
    { intros E. apply Nx. replace x with p; auto. symmetry. apply sub_zero. rewrite E. apply norm2_origin. }
    assert (Pn := norm2_pos _ Hn). split; auto. split; [|lra].
    set (S' := fun s => S (add s x)).
    assert (B : beneath S' (scal (-1) (sub p x)) (- norm2 (sub p x))).
    { apply nearest_beneath.
      - intros u v l Hl Hu Hv. unfold S'. replace (add (add (scal l u) (scal (1 - l) v)) x)
          with (add (scal l (add u x)) (scal (1 - l) (add v x))) by (pteq; ring). apply C; auto.
      - unfold S'. replace (add (sub p x) x) with p by (pteq; ring). auto.
      - intros s Hs. specialize (M _ Hs). replace (sub (add s x) x) with s in M by (pteq; ring).
        assert (N := norm_nonneg (sub p x)). rewrite <- !norm_sqr. apply Rmult_le_compat; auto. }
    intros s Hs. assert (I : S' (sub s x)) by (unfold S'; replace (add (sub s x) x) with s by (pteq; ring); auto).
    apply B in I. replace (scal (-1) (sub p x)) with (sub x p) in I by (pteq; ring).
    replace (norm2 (sub p x)) with (norm2 (sub x p)) in I by (unfold norm2, dot; simpl; ring). rewrite dot_sub_r in I. lra.
Qed.

(* heights above a set, in all directions at once *)
Definition heights_of (S : pt -> Prop) (h : pt -> R) : Prop := forall n, beneath S n (h n) /\ exists p, S p /\ dot n p = h n.

Lemma heights_exist : forall S, attains S -> { h | heights_of S h }.
Proof.
  intros S H. assert (L : forall n, lipschitz (norm n) (fun p => - dot n p)).
  { intros n. split; [apply norm_nonneg|]. intros p q. assert (D := dot_le_norm n (sub q p)). rewrite dot_sub_r, norm_opp in D. lra. }
  exists (fun n => dot n (proj1_sig (H _ _ (L n)))). intros n. destruct (proj2_sig (H _ _ (L n))) as [I M].
  split; [|exists (proj1_sig (H _ _ (L n))); auto]. intros p Hp. specialize (M p Hp). simpl in M. lra.
Qed.

(* the least height of all unit vectors: that of the unit ball, at a price for what is shorter *)
Lemma least_height : forall S h, attains S -> heights_of S h -> exists n, norm n = 1 /\ forall u, norm u = 1 -> h n <= h u.
Proof.
  intros S h H Hh. destruct (attains_bounded S H) as (r & Pr & Br).
  assert (Hr : forall u, h u <= r * norm u).
  { intros u. destruct (Hh u) as [_ (p & Hp & <-)]. assert (D := dot_le_norm u p). assert (N := norm_nonneg u). specialize (Br p Hp). nra. }
  assert (Hs : forall k u, 0 <= k -> h (scal k u) = k * h u).
  { intros k u Hk. destruct (Hh u) as [B (p & Hp & E)]. destruct (Hh (scal k u)) as [B' (q & Hq & E')].
    apply Rle_antisym.
    - rewrite <- E', dot_scal_l. apply Rmult_le_compat_l; auto.
    - rewrite <- E, <- dot_scal_l. auto. }
  destruct (attains_ball (fun u => h u + r * (1 - norm u)) (2 * r)) as (n & Hn & M).
  - split; [lra|]. intros u v. assert (D : h u - h v <= r * norm (sub u v)).
    { destruct (Hh u) as [_ (p & Hp & <-)]. destruct (Hh v) as [B _]. specialize (B p Hp). specialize (Br p Hp).
      assert (E := dot_le_norm (sub u v) p). replace (dot (sub u v) p) with (dot u p - dot v p) in E by (unfold dot; simpl; ring).
      assert (N := norm_nonneg (sub u v)). nra. }
    assert (T := norm_triangle (sub v u) u). replace (add (sub v u) u) with v in T by (pteq; ring). rewrite (norm_opp v u) in T.
    assert (r * (norm v - norm u) <= r * norm (sub u v)) by (apply Rmult_le_compat_l; lra). lra.
  - apply unit_ball_norm in Hn.
    assert (U : forall u, norm u = 1 -> h n + r * (1 - norm n) <= h u).
    { intros u Hu. assert (Iu : unit_ball u) by (apply unit_ball_norm; lra). specialize (M u Iu). simpl in M. rewrite Hu in M. lra. }
    destruct (origin_dec n) as [->|Nn].
    + assert (E : norm (mk 1 0 0) = 1) by (apply norm_unique; [lra|unfold norm2, dot; simpl; ring]).
      exists (mk 1 0 0). split; auto. intros u Hu. specialize (U u Hu). specialize (Hs 0 origin (Rle_refl 0)).
      replace (scal 0 origin) with origin in Hs by (pteq; ring). rewrite norm_origin in U. specialize (Hr (mk 1 0 0)). rewrite E in Hr. lra.
    + assert (P := norm_pos n Nn). assert (E : n = scal (norm n) (along n 1)) by (unfold along; pteq; field; lra).
      exists (along n 1). split; [apply norm_along; auto; lra|]. intros u Hu. specialize (U u Hu).
      specialize (Hs (norm n) (along n 1) (Rlt_le _ _ P)). rewrite <- E in Hs. specialize (Hr (along n 1)).
      rewrite norm_along in Hr; auto; [|lra].
      nra.
Qed.

Theorem signed_depth_planed : forall S, convex S -> attains S -> exists v, signed_depth S v /\ planed S v.
Proof.
  intros S C H. destruct (H norm 1) as (p & Hp & M).
  { split; [lra|]. intros p q. assert (T := norm_triangle (sub p q) q). replace (add (sub p q) q) with p in T by (pteq; ring). lra. }
  assert (Np := norm_nonneg p). destruct (Req_dec (norm p) 0) as [Z|Z].
  - assert (O : S origin). { replace origin with p; auto. apply norm2_zero. rewrite <- norm_sqr, Z. ring. }
    destruct (heights_exist S H) as (h & Hh). destruct (least_height S h H Hh) as (n & Un & Ln).
    assert (Nn : n <> origin). { intros E. rewrite E, norm_origin in Un. lra. }
    assert (P0 : 0 <= h n). { destruct (Hh n) as [B _]. specialize (B origin O). rewrite dot_origin_r in B. auto. }
    assert (Pl : planed S (h n)). { exists n, (h n). split; auto. split; [apply Hh|rewrite Un; lra]. }
    exists (h n). split; auto. split; [|apply planed_most; auto]. split.
    + intros V. assert (In_S : forall t, norm t < h n -> S t \/ ~ S t -> S t).
      { intros t Ht [I|I]; auto. exfalso. destruct (separating_plane S t C H I) as (m & k & Nm & Bm & Lm).
        assert (Pm := norm_pos m Nm). specialize (Ln (along m 1)). rewrite norm_along in Ln by (auto; lra).
        destruct (Hh (along m 1)) as [_ (q & Hq & Eq)]. specialize (Bm q Hq).
        assert (E : dot m q = norm m * h (along m 1)) by (rewrite <- Eq; unfold along; rewrite dot_scal_l; field; lra).
        assert (D := dot_le_norm m t). assert (h n <= h (along m 1)) by (apply Ln; auto). nra. }
      intros t Ht. apply norm_lt in Ht; [|lra]. exists (h n - norm t). split; [lra|]. intros s Hs. apply norm_lt in Hs; [|lra].
      assert (T := norm_triangle (sub s t) t). replace (add (sub s t) t) with s in T by (pteq; ring).
      apply In_S; [lra|]. exact (member_or_not S s H).
    + intros _. exists origin. rewrite norm2_origin. split; auto. apply Rle_0_sqr.
  - assert (E : - norm p * - norm p = norm2 p) by (rewrite <- norm_sqr; ring).
    assert (Least : forall s, S s -> norm2 p <= norm2 s).
    { intros s Hs. rewrite <- !norm_sqr. specialize (M s Hs). apply Rmult_le_compat; auto. }
    assert (Pl : planed S (- norm p)).
    { exists (scal (-1) p), (- norm2 p). split; [|split].
      - apply norm2_pos_inv. rewrite norm2_scal, <- norm_sqr. nra.
      - apply nearest_beneath; auto.
      - rewrite norm_minus, <- norm_sqr. lra. }
    exists (- norm p). split; auto. split; [|apply planed_most; auto]. split; [lra|]. intros _. exists p. rewrite E. split; auto.
Qed.

(* so each signed depth is shown by a plane *)
Theorem depth_plane : forall S v, convex S -> attains S -> signed_depth S v -> planed S v.
Proof.
  intros S v C H V. destruct (signed_depth_planed S C H) as (w & W & Pl). rewrite (signed_depth_unique S v w); auto.
Qed.
