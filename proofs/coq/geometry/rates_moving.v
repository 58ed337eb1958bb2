(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A rate is the derivative also where a half-space moves and the other core is points: the moved
   half-space is one again, and its normal is known. *)
Require Import Reals Lra Psatz List.
From Fathom.checker Require Import body.
From Fathom.geometry Require Import meaning bodies space norm hulls flats difference signed_depth rounded curved gaps.
From Fathom.geometry Require Import contact patches rates.
Import ListNotations.
Open Scope R_scope.

Section Moving.
  Variables (B : list pt) (d r g : R) (v w k : pt).
  Hypothesis Nk : norm2 k = 1.
  Let C p := dot k p <= g.
  Let n := scal (-1) k.
  Let T s := difference_of (conv B) (moved_set v w s C).
  Let wk := cross w k.
  Let l := dot w k.
  (* the moved half-space's normal *)
  Definition turned (s : R) : pt := add k (add (scal s wk) (scal (s * s * l) w)).
  Definition reach_of (b : pt) (s : R) : R := (1 + s * s * norm2 w) * g - dot (turned s) b + s * dot (turned s) v.

  Lemma turned_dot : forall s a, dot (turned s) (moved v w s a) = (1 + s * s * norm2 w) * dot k a + s * dot (turned s)
    v.
  Proof. intros. unfold turned, moved, wk, l, norm2, dot; simpl; ring. Qed.

  Lemma moved_onto : forall s q, exists a, moved v w s a = q.
  Proof.
    intros s q. assert (P0 : 0 < 1 + s * s * norm2 w).
    { assert (0 <= s * s * norm2 w) by (apply Rmult_le_pos; [apply Rle_0_sqr|apply norm2_nonneg]). lra. }
    set (y := sub q (scal s v)).
    exists (scal (/ (1 + s * s * norm2 w)) (add y (add (scal (- s) (cross w y)) (scal (s * s * dot w y) w)))).
    unfold moved, y. revert P0. unfold norm2, dot. simpl. intros P0. pteq; field; lra.
  Qed.

  Lemma moved_half_space : forall s z, T s z <-> exists b, conv B b /\ dot (scal (-1) (turned s)) z <= reach_of b s.
  Proof.
    intros s z. assert (P0 : 0 < 1 + s * s * norm2 w).
    { assert (0 <= s * s * norm2 w) by (apply Rmult_le_pos; [apply Rle_0_sqr|apply norm2_nonneg]). lra. }
    unfold reach_of. split.
    - intros (b & q & Hb & (a & Ha & ->) & ->). exists b. split; auto. rewrite dot_scal_l, dot_sub_r, turned_dot.
      assert ((1 + s * s * norm2 w) * dot k a <= (1 + s * s * norm2 w) * g) by (apply Rmult_le_compat_l; [lra|exact
        Ha]). lra.
    - intros (b & Hb & H). destruct (moved_onto s (sub b z)) as (a & E). exists b, (sub b z). split; auto.
      split; [|pteq; ring]. exists a. split; [|auto]. assert (K := turned_dot s a). rewrite E, dot_sub_r in K.
      rewrite dot_scal_l in H. unfold C. apply Rmult_le_reg_l with (1 + s * s * norm2 w); auto. lra.
  Qed.

  (* ---- to first order ---- *)
  Definition rest (b : pt) : R := Rabs (norm2 w * g) + Rabs (l * dot w b) + Rabs (dot wk v) + Rabs (l * dot w v).
  Lemma reach_near : forall b s, 0 < s <= 1 ->
    - (s * s * rest b) <= reach_of b s - (g - dot k b + s * speed v w n b) <= s * s * rest b.
  Proof.
    intros b s Hs.
    assert (E : reach_of b s - (g - dot k b + s * speed v w n b)
      = s * s * (norm2 w * g - l * dot w b + dot wk v + s * (l * dot w v))).
    { unfold reach_of, turned, speed, n, wk, l, norm2, dot; simpl; ring. }
    assert (A1 := Rle_abs (norm2 w * g)). assert (A2 := Rle_abs (- (norm2 w * g))). rewrite Rabs_Ropp in A2.
    assert (B1 := Rle_abs (l * dot w b)). assert (B2 := Rle_abs (- (l * dot w b))). rewrite Rabs_Ropp in B2.
    assert (C1 := Rle_abs (dot wk v)). assert (C2 := Rle_abs (- dot wk v)). rewrite Rabs_Ropp in C2.
    assert (D1 := Rle_abs (l * dot w v)). assert (D2 := Rle_abs (- (l * dot w v))). rewrite Rabs_Ropp in D2.
    assert (D0 := Rabs_pos (l * dot w v)).
    assert (D3 : - Rabs (l * dot w v) <= s * (l * dot w v) <= Rabs (l * dot w v)) by (split; nra).
    assert (S2 : 0 <= s * s) by (apply Rmult_le_pos; lra). rewrite E. unfold rest. split.
    - rewrite Ropp_mult_distr_r. apply Rmult_le_compat_l; lra.
    - apply Rmult_le_compat_l; lra.
  Qed.

  Let Q := norm2 wk + 2 * (l * l) + l * l * norm2 w.
  Lemma Q_nonneg : 0 <= Q.
  Proof.
    assert (A := norm2_nonneg wk). assert (B0 := norm2_nonneg w). assert (L := Rle_0_sqr l). unfold Rsqr in L.
    assert (0 <= l * l * norm2 w) by (apply Rmult_le_pos; auto). unfold Q. lra.
  Qed.
  Lemma turned_norm : forall s, 0 < s <= 1 -> 1 <= norm (turned s) <= 1 + s * s * Q.
  Proof.
    intros s Hs. assert (PQ := Q_nonneg). assert (L := Rle_0_sqr l). unfold Rsqr in L. assert (W := norm2_nonneg w).
    assert (K := norm2_nonneg wk). assert (S2 : 0 <= s * s <= 1) by (split; nra).
    assert (E : norm2 (turned s) = norm2 k + s * s * (norm2 wk + 2 * (l * l) + s * s * (l * l * norm2 w))).
    { unfold turned, wk, l, norm2, dot; simpl; ring. }
    rewrite Nk in E. assert (LW : 0 <= l * l * norm2 w) by (apply Rmult_le_pos; auto).
    assert (0 <= s * s * (l * l * norm2 w) <= l * l * norm2 w) by (split; nra).
    assert (0 <= s * s * (norm2 wk + 2 * (l * l) + s * s * (l * l * norm2 w)) <= s * s * Q).
    { split; [apply Rmult_le_pos; lra|apply Rmult_le_compat_l; [lra|unfold Q; lra]]. }
    assert (SQ : 0 <= s * s * Q) by (apply Rmult_le_pos; lra).
    split; [apply norm_ge; lra|apply norm_le; [lra|]]. rewrite E. nra.
  Qed.
  Lemma product_near : forall D m s, 0 < s <= 1 -> Rabs m <= D ->
    - (s * s * (D * Q)) <= m * norm (turned s) - m <= s * s * (D * Q).
  Proof.
    intros D m s Hs Hm. destruct (turned_norm s Hs) as [L0 L1]. set (h := norm (turned s) - 1).
    assert (H0 : 0 <= h <= s * s * Q) by (unfold h; lra).
    replace (m * norm (turned s) - m) with (m * h) by (unfold h; ring).
    assert (K : Rabs (m * h) <= D * (s * s * Q)).
    { rewrite Rabs_mult, (Rabs_right h) by lra. apply Rmult_le_compat; try lra. apply Rabs_pos. }
    assert (A1 := Rle_abs (m * h)). assert (A2 := Rle_abs (- (m * h))). rewrite Rabs_Ropp in A2. lra.
  Qed.

  Hypothesis Opt : forall b, conv B b -> g - dot k b <= d.
  Hypothesis Slow : forall b, conv B b -> dot k b = g - d -> speed v w n b <= r.
  Hypothesis Fast : exists b, conv B b /\ dot k b <= g - d /\ r <= speed v w n b.

  Lemma rate_size : forall e s, 0 < e -> 0 < s <= 1 ->
    Rabs (d + s * (r + e)) <= Rabs d + Rabs r + e /\ Rabs (d + s * (r - e)) <= Rabs d + Rabs r + e.
  Proof.
    intros e s He Hs. assert (A1 := Rle_abs d). assert (A2 := Rle_abs (- d)). rewrite Rabs_Ropp in A2.
    assert (B1 := Rle_abs r). assert (B2 := Rle_abs (- r)). rewrite Rabs_Ropp in B2. assert (P0 := Rabs_pos r).
    assert (- Rabs r <= s * r <= Rabs r) by (split; nra). assert (0 <= s * e <= e) by (split; nra).
    split; apply Rabs_le; lra.
  Qed.

  Theorem rate_moving : forall q, 0 <= q -> grows (fun s => thick (T s) q) (d + q) r.
  Proof.
    intros q Pq e He. set (D := Rabs d + Rabs r + e). assert (PQ := Q_nonneg).
    assert (PD : 0 <= D) by (assert (X := Rabs_pos d); assert (Y := Rabs_pos r); unfold D; lra).
    assert (PDQ : 0 <= D * Q) by (apply Rmult_le_pos; auto).
    assert (Pr : forall b, 0 <= rest b).
    { intros b. unfold rest. assert (X1 := Rabs_pos (norm2 w * g)). assert (X2 := Rabs_pos (l * dot w b)).
      assert (X3 := Rabs_pos (dot wk v)). assert (X4 := Rabs_pos (l * dot w v)). lra. }
    assert (small : forall b s, 0 < s -> s < e / (rest b + D * Q + 1) -> s * s * rest b + s * s * (D * Q) <= s * e).
    { intros b s Hs L. specialize (Pr b). set (M := rest b + D * Q + 1) in *.
      assert (Lm : s * M <= e). { replace e with (e / M * M) by (field; unfold M; lra).
      apply Rmult_le_compat_r; unfold M in *; lra. }
      assert (s * (s * M) <= s * e) by (apply Rmult_le_compat_l; lra). unfold M in H. nra. }
    destruct Fast as (b0 & Hb0 & G0 & S0).
    destruct (all_or_some _ (fun _ => False)
      (fun b s0 => forall s, 0 < s < s0 -> reach_of b s <= (d + s * (r + e)) * norm (turned s)) B) as [(b & _ & [])|(s1
        & P1 & G)].
    - intros b s1 s2 L H s Hs. apply H. lra.
    - intros b Ib. right. assert (Hb : conv B b) by (apply hull_in; auto). assert (Ob := Opt b Hb). specialize (Pr b).
      set (M := rest b + D * Q + 1). assert (PM : 0 < e / M) by (apply Rdiv_lt_0_compat; unfold M; lra).
      assert (Main : forall s, 0 < s <= 1 -> s < e / M -> g - dot k b + s * speed v w n b <= d + s * r ->
        reach_of b s <= (d + s * (r + e)) * norm (turned s)).
      { intros s Hs L H. assert (N1 := reach_near b s Hs).
        assert (N2 := product_near D _ s Hs (proj1 (rate_size e s He Hs))).
        assert (N3 := small b s (proj1 Hs) L). lra. }
      destruct (Req_dec (g - dot k b) d) as [E|E].
      + exists (Rmin 1 (e / M)). split; [apply Rmin_glb_lt; lra|]. intros s [Hs Ls].
        assert (M0 := Rmin_l 1 (e / M)). assert (M1 := Rmin_r 1 (e / M)). apply Main; try lra.
        assert (K : speed v w n b <= r) by (apply Slow; [auto|lra]). rewrite E.
        assert (s * speed v w n b <= s * r) by (apply Rmult_le_compat_l; lra). lra.
      + set (h := d - (g - dot k b)). assert (Ph : 0 < h) by (unfold h; lra). set (u := Rabs (speed v w n b - r) + 1).
        assert (Au := Rabs_pos (speed v w n b - r)). assert (Pu : 0 < h / u) by (apply Rdiv_lt_0_compat; unfold u; lra).
        exists (Rmin 1 (Rmin (e / M) (h / u))). split; [repeat apply Rmin_glb_lt; lra|]. intros s [Hs Ls].
        assert (M0 := Rmin_l 1 (Rmin (e / M) (h / u))). assert (M1 := Rmin_r 1 (Rmin (e / M) (h / u))).
        assert (M2 := Rmin_l (e / M) (h / u)). assert (M3 := Rmin_r (e / M) (h / u)). apply Main; try lra.
        assert (Lu : s * u <= h). { replace h with (h / u * u) by (field; unfold u; lra).
        apply Rmult_le_compat_r; unfold u in *; lra. }
        assert (Ra := Rle_abs (speed v w n b - r)).
        assert (s * (speed v w n b - r) <= s * u) by (apply Rmult_le_compat_l; unfold u; lra). unfold h in Lu. lra.
    - set (M := rest b0 + D * Q + 1). assert (PM : 0 < e / M) by (apply Rdiv_lt_0_compat; [auto|specialize (Pr b0);
      unfold M; lra]).
      exists (Rmin 1 (Rmin s1 (e / M))). split; [repeat apply Rmin_glb_lt; lra|]. intros s x [Hs Ls] V.
      assert (M0 := Rmin_l 1 (Rmin s1 (e / M))). assert (M1 := Rmin_r 1 (Rmin s1 (e / M))).
      assert (M2 := Rmin_l s1 (e / M)). assert (M3 := Rmin_r s1 (e / M)). assert (Hs1 : 0 < s <= 1) by lra.
      assert (Nt := proj1 (turned_norm s Hs1)). assert (Nz : scal (-1) (turned s) <> origin).
      { intros Z. assert (N := norm_minus (turned s)). rewrite Z, norm_origin in N. lra. }
      assert (Low : at_least (T s) (d + s * (r - e))).
      { apply (half_space_least _ (scal (-1) (turned s)) (reach_of b0 s)); auto.
        - intros z Hz. apply moved_half_space. exists b0. auto.
        - rewrite norm_minus. assert (N1 := reach_near b0 s Hs1).
          assert (N2 := product_near D _ s Hs1 (proj2 (rate_size e s He Hs1))).
          assert (N3 := small b0 s Hs ltac:(unfold M in *; lra)).
          assert (s * r <= s * speed v w n b0) by (apply Rmult_le_compat_l; lra). lra. }
      assert (High : at_most (thick (T s) q) (d + s * (r + e) + q)).
      { apply (thick_most _ (scal (-1) (turned s)) ((d + s * (r + e)) * norm (turned s))); auto; [|rewrite norm_minus;
        lra].
        intros z Hz. apply moved_half_space in Hz. destruct Hz as (b & Hb & Hz). apply Rle_trans with (1 := Hz).
        assert (K : dot (scal (-1) (turned s)) b <= (d + s * (r + e)) * norm (turned s) - (1 + s * s * norm2 w) * g - s
          * dot (turned s) v).
        { revert b Hb Hz. intros b Hb _. revert b Hb. apply hull_halfspace. intros b Ib. rewrite dot_scal_l.
          assert (G' := G b Ib s ltac:(lra)). unfold reach_of in G'. lra. }
        unfold reach_of. rewrite dot_scal_l in K. lra. }
      assert (Low' : at_least (thick (T s) q) (d + s * (r - e) + q)).
      { apply thick_least; auto. }
      assert (U := least_le_most _ _ _ Low' (proj2 V)). assert (L := least_le_most _ _ _ (proj1 V) High). lra.
  Qed.
End Moving.

Theorem rate_half_space_moves : forall m c ra B rb d v w r, m <> origin -> 0 <= ra -> 0 <= rb ->
  rate_is (Body (Half_space m c) ra) (Body (Points B) rb) d v w r ->
  grows (fun s => moved_gaps v w s m c ra (Body (Points B) rb)) (d + (ra + rb)) r.
Proof.
  intros m c ra B rb d v w r Nm Pa Pb [Fast (n & O & Slow)] e He. assert (P0 := norm_pos m Nm).
  set (k := along m 1). assert (Nk : norm2 k = 1) by (unfold k, along; rewrite norm2_scal, <- norm_sqr; field; lra).
  set (g := c / norm m).
  assert (Half : forall p, dot m p <= c <-> dot k p <= g).
  { intros p. assert (E : dot m p = norm m * dot k p) by (unfold k, along; rewrite dot_scal_l; field; lra).
    assert (Ec : c = norm m * g) by (unfold g; field; lra). rewrite E, Ec.
    split; intros L; [apply Rmult_le_reg_l with (norm m); auto|apply Rmult_le_compat_l; lra]. }
  destruct (Fast n O) as (p0 & [Hp0 Hq0] & Hr0). simpl in Hp0, Hq0.
  assert (En : n = scal (-1) k).
  { replace (scal (-1) k) with (along (scal (-1) m) 1) by (unfold k, along; rewrite norm_minus; pteq; field; lra).
    apply (optimal_half_space (core_gaps (Body (Half_space m c) ra) (Body (Points B) rb)) _
      (c + dot (scal (-1) m) (add p0 (scal d n))) d); auto.
    - intros Z. assert (N := norm_minus m). rewrite Z, norm_origin in N. lra.
    - intros x Hx. apply (point_minus_half_space m c _ (add p0 (scal d n))); auto. }
  subst n. assert (Nc : forall b, dot k (add b (scal d k)) = dot k b + d).
  { intros b. rewrite dot_add_r, dot_scal_r. fold (norm2 k). rewrite Nk. ring. }
  assert (Same : forall b, speed v w (scal (-1) k) (add b (scal d k)) = speed v w (scal (-1) k) b).
  { intros b. unfold speed, dot; simpl; ring. }
  assert (Back : forall b, add (add b (scal d k)) (scal d (scal (-1) k)) = b) by (intros; pteq; ring).
  assert (Forth : forall b, add (add b (scal d (scal (-1) k))) (scal d k) = b) by (intros; pteq; ring).
  assert (Kb : forall b, conv B b -> g - dot k b <= d).
  { intros b Hb. assert (Eg : dot k (scal g k) = g) by (rewrite dot_scal_r; fold (norm2 k); rewrite Nk; ring).
    assert (G : dot (scal (-1) k) (sub b (scal g k)) <= d).
    { apply O. exists b, (scal g k). split; [exact Hb|]. split; [simpl; apply Half; lra|auto]. }
    rewrite dot_scal_l, dot_sub_r, Eg in G. lra. }
  assert (Ks : forall b, conv B b -> dot k b = g - d -> speed v w (scal (-1) k) b <= r).
  { intros b Hb E. rewrite <- Same. apply Slow. split; [simpl; apply Half; rewrite Nc; lra|]. rewrite Back. exact Hb. }
  assert (Kf : exists b, conv B b /\ dot k b <= g - d /\ r <= speed v w (scal (-1) k) b).
  { exists (add p0 (scal d (scal (-1) k))). split; auto. split.
    - rewrite <- (Forth p0) in Hp0. apply Half in Hp0. rewrite Nc in Hp0. lra.
    - rewrite <- Same, Forth. auto. }
  destruct (rate_moving B d r g v w k Nk Kb Ks Kf (ra + rb)) with (e := e) as (s0 & Ps & G); auto; try lra.
  exists s0. split; auto. intros s x Hs V. apply G; auto.
  assert (iff : forall z, moved_gaps v w s m c ra (Body (Points B) rb) z <->
    thick (difference_of (conv B) (moved_set v w s (fun p => dot k p <= g))) (ra + rb) z).
  { intros z. unfold moved_gaps, in_body. cbn [core_of radius in_core]. rewrite difference_thick by auto.
    assert (D : forall y, difference_of (conv B) (moved_set v w s (fun p => dot m p <= c)) y <->
      difference_of (conv B) (moved_set v w s (fun p => dot k p <= g)) y).
    { intros y. split; intros (b & q & Hb & (a & Ha & Ea) & E); exists b, q; split; auto; split; auto; exists a; split;
      auto;
        apply Half; auto. }
    unfold thick. split; intros (y & Hy & L); exists y; split; auto; apply D; auto. }
  split; [apply (at_least_iff _ _ _ iff), V|apply (at_most_iff _ _ _ iff), V].
Qed.
