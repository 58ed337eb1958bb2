(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Of polytopes that overlap a rate is the derivative too: a direction that is nearly as near as the
   optimal ones is near to one of them, since the way out ends inside of a facet. *)
Require Import Reals Lra Psatz List.
From Fathom.checker Require Import body.
From Fathom.geometry Require Import meaning bodies space norm hulls flats facets difference depth signed_depth minkowski
  gaps.
From Fathom.geometry Require Import contact patches rates.
Import ListNotations.
Open Scope R_scope.

Section Overlap.
  Variables (A B : list pt) (ra rb d r : R) (v w : pt).
  Let X := Body (Points A) ra.
  Let Y := Body (Points B) rb.
  Let S := core_gaps X Y.
  Hypothesis Hd : 0 < d.
  Hypothesis Depth : signed_depth S d.

  Lemma S_iff : forall p, S p <-> P A B p.
  Proof.
    intros p. rewrite P_minkowski. split.
    - intros (b & a & Hb & Ha & E). exists a, b. auto.
    - intros (a & b & Ha & Hb & E). exists b, a. auto.
  Qed.

  (* the facets' planes, with unit normals *)
  Lemma unit_facets : exists F : list (pt * R),
    (forall f, In f F -> norm2 (fst f) = 1 /\ beneath S (fst f) (snd f) /\ d <= snd f)
    /\ forall x, S x \/ exists f, In f F /\ snd f < dot (fst f) x.
  Proof.
    assert (I0 : interior (P A B) origin).
    { rewrite <- (interior_iff S) by apply S_iff. apply (proj1 Depth); auto. rewrite norm2_origin. nra. }
    destruct (finite_facets _ (interior_spanning _ _ _ I0)) as (F & F1 & F2).
    assert (G : forall f, In f F -> fst f <> origin /\ beneath S (fst f) (snd f)).
    { intros f If. destruct (F1 f If) as (u & x & y & Hf). apply facet_plane_P in Hf. destruct Hf as [[Nz _] [Hh _]].
      split; auto. intros p Hp. apply Hh, S_iff. auto. }
    exists (map (fun f => (along (fst f) 1, snd f / norm (fst f))) F). split.
    - intros f If. apply in_map_iff in If. destruct If as (g & <- & Ig). destruct (G g Ig) as [Nz Hb]. cbn [fst snd].
      assert (Pn := norm_pos _ Nz). split; [|split].
      + unfold along. rewrite norm2_scal, <- norm_sqr. field. lra.
      + intros p Hp. unfold along. rewrite dot_scal_l. apply Rmult_le_reg_l with (norm (fst g)); auto.
        replace (norm (fst g) * (1 / norm (fst g) * dot (fst g) p)) with (dot (fst g) p) by (field; lra).
        replace (norm (fst g) * (snd g / norm (fst g))) with (snd g) by (field; lra). auto.
      + apply (least_le_most S _ _ (proj1 Depth)). apply (beneath_most S (fst g) (snd g)); auto.
        right. field. lra.
    - intros x. destruct (F2 x) as [C|(f & If & L)]; [left; apply S_iff, P_conv; auto|right].
      exists (along (fst f) 1, snd f / norm (fst f)). split; [apply in_map_iff; exists f; auto|]. cbn [fst snd].
      destruct (G f If) as [Nz _]. assert (Pn := norm_pos _ Nz). unfold along. rewrite dot_scal_l.
      apply Rmult_lt_reg_l with (norm (fst f)); auto.
      replace (norm (fst f) * (1 / norm (fst f) * dot (fst f) x)) with (dot (fst f) x) by (field; lra).
      replace (norm (fst f) * (snd f / norm (fst f))) with (snd f) by (field; lra). auto.
  Qed.

  Lemma unit_equal : forall m n, norm2 m = 1 -> norm2 n = 1 -> 1 <= dot m n -> m = n.
  Proof.
    intros m n Nm Nn L. apply sub_zero. assert (P0 := norm2_nonneg (sub m n)). rewrite norm2_sub, Nm, Nn in *. lra.
  Qed.
  Lemma unit_dot : forall m n, norm2 m = 1 -> norm2 n = 1 -> dot m n <= 1.
  Proof. intros m n Nm Nn. assert (P0 := norm2_nonneg (sub m n)). rewrite norm2_sub, Nm, Nn in *. lra. Qed.

  (* a way out ends in the middle of a disc in P's boundary *)
  Definition disc (n : pt) (e : R) : Prop := forall y, dot n y = 0 -> norm y <= e -> S (add (scal d n) y).

  Lemma near_facets : exists F e, 0 < e
    /\ (forall f, In f F -> norm2 (fst f) = 1 /\ beneath S (fst f) (snd f) /\ (snd f = d \/ d + e <= snd f)
          /\ (snd f = d -> disc (fst f) e))
    /\ forall x, S x \/ exists f, In f F /\ snd f < dot (fst f) x.
  Proof.
    destruct unit_facets as (F & F1 & F2). exists F.
    destruct (all_or_some _ (fun _ => False) (fun f e => (snd f = d \/ d + e <= snd f) /\ (snd f = d -> disc (fst f)
      e)) F)
      as [(f & _ & [])|(e & He & G)].
    - intros f e e' He [H1 H2]. split; [destruct H1; [auto|right; lra]|]. intros E y Dy Ny. apply (H2 E); auto. lra.
    - intros f If. right. destruct (F1 f If) as (Nf & _ & Lf).
      assert (K : exists e, 0 < e /\ (snd f = d -> disc (fst f) e)).
      { destruct (all_or_some _ (fun _ => False)
          (fun g e => fst g = fst f \/ dot (fst g) (scal d (fst f)) + e <= snd g) F) as [(g & _ & [])|(e & He & G)].
        - intros g e e' He [H1|H1]; [auto|right; lra].
        - intros g Ig. right. destruct (F1 g Ig) as (Ng & _ & Lg). assert (U := unit_dot _ _ Ng Nf). rewrite dot_scal_r.
          destruct (Rlt_dec (dot (fst g) (fst f)) 1) as [L|L].
          + exists (d * (1 - dot (fst g) (fst f))). split; [apply Rmult_lt_0_compat; lra|]. right. lra.
          + exists 1. split; [lra|]. left. apply unit_equal; auto. lra.
        - exists e. split; auto. intros E y Dy Ny. destruct (F2 (add (scal d (fst f)) y)) as [C|(g & Ig & L)]; auto.
          exfalso.
          destruct (F1 g Ig) as (Ng & _ & Lg). rewrite dot_add_r in L. destruct (G g Ig) as [Eg|Lg'].
          + rewrite Eg, Dy, dot_scal_r in L. fold (norm2 (fst f)) in L. rewrite Nf in L. lra.
          + assert (D := dot_le_norm (fst g) y). rewrite (norm_unique (fst g) 1) in D by lra. lra. }
      destruct K as (e1 & P1 & K). destruct (Req_dec (snd f) d) as [E|E].
      + exists e1. auto.
      + exists (snd f - d). split; [lra|]. split; [right; lra|]. intros F0. contradiction.
    - exists e. split; auto. split; auto. intros f If. destruct (F1 f If) as (Nf & Bf & _). destruct (G f If). auto.
  Qed.

  (* a direction in which P reaches hardly farther than d is near to an optimal one *)
  Lemma near_optimal : exists q, 0 < q /\ forall u e, norm2 u = 1 -> 0 < e -> 2 * e < q -> 16 * d * e <= q * q ->
    beneath S u (d + e) ->
    exists n, optimal S d n /\ 0 <= dot n u /\ norm2 (sub u (scal (dot n u) n)) <= 2 * e / q * (2 * e / q)
      /\ 1 - dot n u <= norm2 (sub u (scal (dot n u) n)).
  Proof.
    destruct near_facets as (F & q & Pq & F1 & F2). exists q. split; auto. intros u e Nu He Small Tiny Bu.
    destruct (F2 (scal (d + 2 * e) u)) as [C|(f & If & L)].
    { exfalso. apply Bu in C. rewrite dot_scal_r in C. fold (norm2 u) in C. rewrite Nu in C. lra. }
    destruct (F1 f If) as (Nf & Bf & Cf & Df). set (n := fst f) in *. rewrite dot_scal_r in L. set (k := dot n u) in *.
    assert (K1 : k <= 1) by (apply unit_dot; auto).
    assert (E : snd f = d). { destruct Cf as [E|Cf]; auto. exfalso.
    assert ((d + 2 * e) * k <= (d + 2 * e) * 1) by (apply Rmult_le_compat_l; lra). lra. }
    rewrite E in L, Bf. specialize (Df E). assert (K0 : 0 < k).
    { apply Rnot_le_lt. intros Le. assert ((d + 2 * e) * k <= (d + 2 * e) * 0) by (apply Rmult_le_compat_l; lra). lra. }
    exists n. split; [split; auto|]. fold k. split; [lra|]. set (y := sub u (scal k n)).
    assert (Ny : norm2 y = 1 - k * k).
    { unfold y. rewrite norm2_sub, dot_scal_r, norm2_scal, Nu, Nf, (dot_comm u n). fold k. ring. }
    assert (Dy : dot n y = 0) by (unfold y; rewrite dot_sub_r, dot_scal_r; fold k (norm2 n); rewrite Nf; ring).
    assert (Uy : dot u y = norm2 y).
    { unfold y at 1. rewrite dot_sub_r, dot_scal_r, (dot_comm u n). fold k (norm2 u). rewrite Nu, Ny. ring. }
    assert (M : 1 - k <= norm2 y) by (rewrite Ny; nra). split; auto.
    set (g := norm y). assert (Pg : 0 <= g) by apply norm_nonneg. assert (Gg : g * g = norm2 y) by apply norm_sqr.
    assert (Lg : g <= 2 * e / q); [|rewrite <- Gg; apply Rmult_le_compat; auto].
    destruct (Req_dec g 0) as [Z|Z]; [rewrite Z; apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat; auto]|].
    assert (I0 : S (add (scal d n) (scal (q / g) y))).
    { apply Df; [rewrite dot_scal_r, Dy; ring|].
      rewrite norm_scal by (apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat; lra]). fold g. right. field. auto. }
    apply Bu in I0. rewrite dot_add_r, !dot_scal_r, Uy, (dot_comm u n) in I0. fold k in I0. rewrite <- Gg in I0.
    replace (q / g * (g * g)) with (q * g) in I0 by (field; auto).
    (* q g <= e + d (1 - k) <= e + d g g, and g is so small that half of q g is more than the last
       term *)
    assert (S1 : d * (1 - k) <= d * (g * g)) by (apply Rmult_le_compat_l; lra).
    assert (S2 : g * g * d <= 4 * e).
    { rewrite Gg, Ny. assert (d * (1 - k) <= 2 * e) by nra. nra. }
    assert (S3 : 2 * d * g <= q).
    { apply Rnot_lt_le. intros L'. assert (q * q < 2 * d * g * (2 * d * g)) by nra.
      assert (4 * d * (g * g * d) <= 4 * d * (4 * e)) by (apply Rmult_le_compat_l; lra). lra. }
    assert (S4 : 2 * (d * (g * g)) <= q * g) by nra.
    apply Rmult_le_reg_l with q; auto. replace (q * (2 * e / q)) with (2 * e) by (field; lra). lra.
  Qed.

  (* ---- the lower side ---- *)
  Hypothesis Fast : forall n, optimal S d n -> exists p, patch_of X Y d n p /\ r <= speed v w n p.
  Notation V p := (add v (cross w p)).

  Lemma velocity_bounded : exists K, 0 <= K /\ forall p, conv A p -> norm (V p) <= K.
  Proof.
    destruct (bounded_on (fun p => norm (V p)) A) as (K & P0 & HK). exists K. split; auto. intros p Hp.
    apply (Hp (fun p => norm (V p) <= K)); auto. intros x y l Hl Hx Hy.
    replace (V (add (scal l x) (scal (1 - l) y))) with (add (scal l (V x)) (scal (1 - l) (V y))) by (pteq; ring).
    apply Rle_trans with (1 := norm_triangle _ _). rewrite !norm_scal by lra. nra.
  Qed.

  Theorem rate_least_overlap : forall e, 0 < e -> exists s0, 0 < s0 /\ forall s x, 0 < s < s0 ->
    signed_depth (core_gaps (moved_body v w s A ra) Y) x -> d + s * (r - e) <= x.
  Proof.
    intros e He. destruct near_optimal as (q & Pq & Near). destruct velocity_bounded as (K & PK & HK).
    assert (Ar := Rabs_pos r). set (k := K + Rabs r + 1). assert (Pk : 0 < k) by (unfold k; lra).
    set (c := 2 * k / q). assert (Pc : 0 < c) by (apply Rdiv_lt_0_compat; lra).
    set (M := d * (c * c) + 2 * c * K). assert (PM : 0 <= M).
    { unfold M. assert (0 < d * (c * c)) by (apply Rmult_lt_0_compat; [auto|apply Rmult_lt_0_compat; auto]).
      assert (0 <= 2 * c * K) by (apply Rmult_le_pos; lra). lra. }
    set (s1 := q / (4 * k)). set (s2 := q * q / (16 * d * k)). set (s3 := e / (M + 1)).
    assert (P1 : 0 < s1) by (apply Rdiv_lt_0_compat; lra).
    assert (Pdk : 0 < 16 * d * k) by (apply Rmult_lt_0_compat; lra).
    assert (P2 : 0 < s2) by (apply Rdiv_lt_0_compat; auto; apply Rmult_lt_0_compat; auto).
    assert (P3 : 0 < s3) by (apply Rdiv_lt_0_compat; lra).
    exists (Rmin s1 (Rmin s2 s3)). split; [repeat apply Rmin_glb_lt; auto|]. intros s x [Ps Ls] Hx.
    assert (L0 := Rmin_l s1 (Rmin s2 s3)). assert (L1 := Rmin_r s1 (Rmin s2 s3)).
    assert (L2 := Rmin_l s2 s3). assert (L3 := Rmin_r s2 s3).
    apply Rnot_lt_le. intros Less. set (T := core_gaps (moved_body v w s A ra) Y) in *.
    (* a unit vector u in whose direction all is below x *)
    assert (NE : A <> [] /\ B <> []).
    { destruct (at_least_some _ _ (proj1 Depth)) as (g & Hg). apply S_iff in Hg. apply (P_nonempty _ _ _ Hg). }
    destruct NE as [NA NB].
    assert (Pl : planed (P (map (moved v w s) A) B) x).
    { assert (iff : forall p, T p <-> P (map (moved v w s) A) B p).
      { intros p. rewrite P_minkowski. split.
        - intros (b & a & Hb & Ha & E). exists a, b. auto.
        - intros (a & b & Ha & Hb & E). exists b, a. auto. }
      apply polytope_planed; auto; [destruct A; [congruence|discriminate]|].
      split; [apply (at_least_iff _ _ _ iff), Hx|apply (at_most_iff _ _ _ iff), Hx]. }
    destruct Pl as (m & h & Nm & Bm & Lm). set (u := along m 1). assert (Pm := norm_pos _ Nm).
    assert (Nu : norm2 u = 1) by (unfold u, along; rewrite norm2_scal, <- norm_sqr; field; lra).
    assert (Bu : forall a b, conv A a -> conv B b -> dot u (sub b (moved v w s a)) <= x).
    { intros a b Ha Hb. assert (G : P (map (moved v w s) A) B (sub b (moved v w s a))).
      { apply P_minkowski. exists (moved v w s a), b. split; [apply moved_conv; auto|auto]. }
      apply Bm in G. unfold u, along. rewrite dot_scal_l. apply Rmult_le_reg_l with (norm m); auto.
      replace (norm m * (1 / norm m * dot m (sub b (moved v w s a)))) with (dot m (sub b (moved v w s a))) by (field;
        lra). lra. }
    assert (N1 : norm u = 1) by (apply norm_unique; lra).
    destruct (Near u (s * k)) as (n & O & C0 & Cn & Cm); auto.
    - apply Rmult_lt_0_compat; auto.
    - assert (E : s1 * (4 * k) = q) by (unfold s1; field; lra).
      assert (s * (4 * k) < s1 * (4 * k)) by (apply Rmult_lt_compat_r; lra). lra.
    - assert (E : s2 * (16 * d * k) = q * q) by (unfold s2; field; split; lra).
      assert (s * (16 * d * k) <= s2 * (16 * d * k)) by (apply Rmult_le_compat_r; lra). lra.
    - intros g (b & a & Hb & Ha & ->). specialize (Bu a b Ha Hb).
      assert (E : dot u (sub b a) = dot u (sub b (moved v w s a)) + s * dot u (V a)) by (unfold moved, dot; simpl;
        ring).
      assert (D := dot_le_norm u (V a)). rewrite N1 in D. specialize (HK a Ha). assert (Rr := Rle_abs r).
      assert (s * dot u (V a) <= s * K) by (apply Rmult_le_compat_l; lra).
      assert (s * r <= s * Rabs r) by (apply Rmult_le_compat_l; lra).
      assert (0 < s * e) by (apply Rmult_lt_0_compat; auto). unfold k. lra.
    - destruct (Fast n O) as (p & [Pa Pb] & Hr). destruct O as [Nn _]. specialize (Bu p (add p (scal d n)) Pa Pb).
      set (y := sub u (scal (dot n u) n)) in *. set (g := dot n u) in *.
      replace (2 * (s * k) / q) with (s * c) in Cn by (unfold c; field; lra).
      assert (E : dot u (sub (add p (scal d n)) (moved v w s p)) = d * g + s * (speed v w n p - dot (sub u n) (V p))).
      { unfold moved, speed, g, dot; simpl; ring. }
      rewrite E in Bu. assert (D := dot_le_norm (sub u n) (V p)).
      assert (Sc : 0 <= s * c) by (apply Rmult_le_pos; lra).
      assert (Un : norm (sub u n) <= 2 * (s * c)).
      { apply norm_le; [lra|]. rewrite norm2_sub, Nu, Nn, (dot_comm u n). fold g. nra. }
      assert (Dv : dot (sub u n) (V p) <= 2 * (s * c) * K).
      { apply Rle_trans with (1 := D). apply Rmult_le_compat; auto; apply norm_nonneg. }
      assert (G1 : d * (1 - g) <= d * (s * c * (s * c))) by (apply Rmult_le_compat_l; lra).
      assert (G2 : s * (r - 2 * (s * c) * K) <= s * (speed v w n p - dot (sub u n) (V p))) by (apply Rmult_le_compat_l;
        lra).
      assert (G3 : s * (s * M) <= s * e).
      { apply Rmult_le_compat_l; [lra|]. assert (E3 : s3 * (M + 1) = e) by (unfold s3; field; lra).
        assert (s * (M + 1) <= s3 * (M + 1)) by (apply Rmult_le_compat_r; lra). lra. }
      replace (s * (s * M)) with (d * (s * c * (s * c)) + s * (2 * (s * c) * K)) in G3 by (unfold M; ring).
      lra.
  Qed.
End Overlap.

(* ---- a rate is the one-sided derivative ---- *)
Theorem rate_points : forall A B ra rb d v w r, d <> 0 ->
  signed_depth (core_gaps (Body (Points A) ra) (Body (Points B) rb)) d ->
  rate_is (Body (Points A) ra) (Body (Points B) rb) d v w r ->
  grows (fun s => core_gaps (moved_body v w s A ra) (Body (Points B) rb)) d r.
Proof.
  intros A B ra rb d v w r Hd D R. destruct (Rtotal_order d 0) as [L|[E|L]]; [apply rate_apart; auto|contradiction|].
  intros e He. destruct (rate_bounds _ _ _ _ _ _ _ _ R e He) as (s0 & P0 & G).
  destruct (rate_least_overlap A B ra rb d r v w L D (proj1 R) e He) as (s1 & P1 & K).
  exists (Rmin s0 s1). split; [apply Rmin_glb_lt; auto|]. intros s x [Ps Ls] Hx.
  assert (M0 := Rmin_l s0 s1). assert (M1 := Rmin_r s0 s1).
  assert (U := G s x (conj Ps (Rlt_le_trans _ _ _ Ls M0)) Hx).
  assert (W := K s x (conj Ps (Rlt_le_trans _ _ _ Ls M1)) Hx). lra.
Qed.
