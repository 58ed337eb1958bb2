(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A rate and the derivative. Of polytopes whose points move with v + w x p the signed depth grows
   no faster than at the rate, and if they are apart it grows at the rate. *)
Require Import Reals Lra Psatz List.
From Fathom.checker Require Import body.
From Fathom.geometry Require Import meaning bodies space norm hulls farkas difference signed_depth minkowski gaps.
From Fathom.geometry Require Import contact patches.
Import ListNotations.
Open Scope R_scope.

Lemma moved_conv : forall v w s A p, conv A p -> conv (map (moved v w s) A) (moved v w s p).
Proof.
  intros v w s A p Hp. apply (Hp (fun p => conv (map (moved v w s) A) (moved v w s p))).
  - intros x y l Hl Hx Hy. replace (moved v w s (add (scal l x) (scal (1 - l) y)))
      with (add (scal l (moved v w s x)) (scal (1 - l) (moved v w s y))) by (unfold moved; pteq; ring).
    apply hull_convex; auto.
  - intros x Ix. apply hull_in, in_map. auto.
Qed.
Lemma speed_affine : forall v w n l x y,
  speed v w n (add (scal l x) (scal (1 - l) y)) = l * speed v w n x + (1 - l) * speed v w n y.
Proof. intros. unfold speed, dot; simpl; ring. Qed.

Section Rate.
  Variables (A B : list pt) (ra rb d r : R) (v w n : pt).
  Let X := Body (Points A) ra.
  Let Y := Body (Points B) rb.
  Hypothesis Opt : optimal (core_gaps X Y) d n.
  Let t := scal d n.

  (* ---- no faster ---- *)
  Section Upper.
    Hypothesis Slow : forall p, patch_of X Y d n p -> speed v w n p <= r.

    (* of a pair of points: how far it is from the translation, and from the rate *)
    Definition arrears (ab : pt * pt) : hpt := H (sub (sub (snd ab) (fst ab)) t) (r - speed v w n (fst ab)).

    Lemma cone_arrears : forall L q x, (forall a b, In (a, b) L -> In a A /\ In b B) -> cone (map arrears L) (H q x) ->
      exists k, 0 <= k /\ (k = 0 -> q = origin /\ x = 0) /\ (0 < k -> exists a b, conv A a /\ conv B b
        /\ q = scal k (sub (sub b a) t) /\ x = k * (r - speed v w n a)).
    Proof.
      induction L as [|[a b] L IH]; intros q x HL C.
      - simpl in C. inversion C. subst. exists 0. split; [lra|]. split; [auto|lra].
      - simpl in C. destruct C as (k1 & P1 & C). unfold less in C. cbn [hp hw arrears fst snd] in C.
        destruct (HL a b) as [Ia Ib]; [simpl; auto|].
        destruct (IH _ _ (fun a b I0 => HL a b (or_intror I0)) C) as (k2 & P2 & Z & K).
        assert (Ha : conv A a) by (apply hull_in; auto). assert (Hb : conv B b) by (apply hull_in; auto).
        set (g := sub (sub b a) t) in *. set (y := r - speed v w n a) in *.
        assert (back : forall u, sub q (scal k1 g) = u -> q = add u (scal k1 g)) by (intros u <-; pteq; ring).
        exists (k1 + k2). split; [lra|]. split.
        + intros E. assert (E1 : k1 = 0) by lra. destruct Z as [Zq Zx]; [lra|]. rewrite (back _ Zq), E1.
          split; [pteq; ring|]. rewrite E1 in Zx. lra.
        + intros Pk. destruct (Req_dec k2 0) as [E|E].
          * destruct (Z E) as [Zq Zx]. exists a, b. split; auto. split; auto. rewrite (back _ Zq), E. fold g y.
            split; [pteq; ring|lra].
          * destruct K as (a' & b' & Ha' & Hb' & Kq & Kx); [lra|]. set (l := k1 / (k1 + k2)).
            assert (L0 : l * (k1 + k2) = k1) by (unfold l; field; lra).
            assert (Hl : 0 <= l <= 1).
            { split; [apply Rmult_le_pos; [auto|left; apply Rinv_0_lt_compat; auto]|].
              apply Rmult_le_reg_r with (k1 + k2); lra. }
            assert (L1 : (1 - l) * (k1 + k2) = k2) by lra.
            exists (add (scal l a) (scal (1 - l) a')), (add (scal l b) (scal (1 - l) b')).
            split; [apply hull_convex; auto|]. split; [apply hull_convex; auto|]. rewrite speed_affine. split.
            -- assert (V : forall p p' q q' z, k2 * (p' - q' - z) + k1 * (p - q - z)
                 = (k1 + k2) * (l * p + (1 - l) * p' - (l * q + (1 - l) * q') - z)).
               { intros p p' q0 q' z. replace ((k1 + k2) * (l * p + (1 - l) * p' - (l * q0 + (1 - l) * q') - z))
                   with (l * (k1 + k2) * (p - q0) + (1 - l) * (k1 + k2) * (p' - q') - (k1 + k2) * z) by ring.
                 rewrite L0, L1. ring. }
               rewrite (back _ Kq). unfold g. pteq; apply V.
            -- assert (Ex : x = k2 * (r - speed v w n a') + k1 * y) by lra. rewrite Ex. unfold y.
               replace ((k1 + k2) * (r - (l * speed v w n a + (1 - l) * speed v w n a')))
                 with (l * (k1 + k2) * (r - speed v w n a) + (1 - l) * (k1 + k2) * (r - speed v w n a')) by ring.
               rewrite L0, L1. ring.
    Qed.

    (* n may be let go with a velocity y so that no pair is in arrears *)
    Lemma tilt : exists y, forall a b, In a A -> In b B -> dot (sub (sub b a) t) y + speed v w n a <= r.
    Proof.
      destruct (farkas _ (map arrears (list_prod A B)) (H origin (-1)) eq_refl) as [C|(y & Y1 & Y2)].
      - exfalso. apply cone_arrears in C; [|intros a b I0; apply in_prod_iff; auto].
        destruct C as (k & Pk & Z & K). destruct (Req_dec k 0) as [E|E]; [destruct (Z E); lra|].
        destruct K as (a & b & Ha & Hb & Kq & Kx); [lra|].
        assert (S : speed v w n a <= r); [|assert (0 <= k * (r - speed v w n a)) by (apply Rmult_le_pos; lra); lra].
        apply Slow. split; [exact Ha|]. change (in_core (core_of Y) (add a t)). replace (add a t) with b; [exact Hb|].
        apply sub_zero. replace (sub b (add a t)) with (sub (sub b a) t) by (pteq; ring).
        assert (N := norm2_scal k (sub (sub b a) t)). rewrite <- Kq, norm2_origin in N.
        apply Rmult_eq_reg_l with (k * k); [lra|]. apply Rgt_not_eq, Rmult_lt_0_compat; lra.
      - unfold hdot in Y2. cbn [hp hw] in Y2. assert (W : hw y < 0).
        { replace (dot origin (hp y)) with 0 in Y2 by (unfold dot, origin; simpl; ring). lra. }
        exists (scal (/ - hw y) (hp y)). intros a b Ia Ib.
        assert (K := Y1 (arrears (a, b)) (in_map _ _ _ (in_prod _ _ _ _ Ia Ib))). unfold hdot in K.
        cbn [hp hw arrears fst snd] in K. rewrite dot_scal_r.
        assert (P0 : 0 < / - hw y) by (apply Rinv_0_lt_compat; lra).
        assert (E : / - hw y * ((r - speed v w n a) * hw y) = - (r - speed v w n a)) by (field; lra).
        assert (/ - hw y * (dot (sub (sub b a) t) (hp y) + (r - speed v w n a) * hw y) <= 0); [|lra].
        replace 0 with (/ - hw y * 0) by ring. apply Rmult_le_compat_l; lra.
    Qed.

    Lemma bounded_on : forall (f : pt -> R) (L : list pt), exists K, 0 <= K /\ forall p, In p L -> f p <= K.
    Proof.
      intros f L. induction L as [|q L (K & P0 & HK)]; [exists 0; split; [lra|intros p []]|].
      exists (Rmax K (f q)). assert (M0 := Rmax_l K (f q)). assert (M1 := Rmax_r K (f q)). split; [lra|].
      intros p [<-|Ip]; [lra|]. specialize (HK p Ip). lra.
    Qed.

    Theorem rate_most : forall e, 0 < e -> exists s0, 0 < s0 /\ forall s, 0 < s < s0 ->
      at_most (core_gaps (moved_body v w s A ra) Y) (d + s * (r + e)).
    Proof.
      intros e He. destruct Opt as [Nn Bn]. destruct tilt as (y & Hy).
      destruct (bounded_on (fun a => - dot y (add v (cross w a))) A) as (K & PK & HK).
      set (c := dot n y). set (Q := norm2 y). assert (PQ : 0 <= Q) by apply norm2_nonneg.
      set (M := Rabs ((r + e) * c) + (Rabs d + Rabs (r + e)) * Q + K).
      assert (A1 := Rabs_pos ((r + e) * c)). assert (A2 := Rabs_pos d). assert (A3 := Rabs_pos (r + e)).
      assert (PM : 0 <= M) by (assert (0 <= (Rabs d + Rabs (r + e)) * Q) by (apply Rmult_le_pos; lra); unfold M; lra).
      set (s1 := / (2 * (Rabs c + 1))). set (s2 := e / (M + 1)). assert (Ac := Rabs_pos c).
      assert (P1 : 0 < s1) by (apply Rinv_0_lt_compat; lra). assert (P2 : 0 < s2) by (apply Rdiv_lt_0_compat; lra).
      exists (Rmin 1 (Rmin s1 s2)). split; [repeat apply Rmin_glb_lt; lra|]. intros s [Ps Ls].
      assert (L0 := Rmin_l 1 (Rmin s1 s2)). assert (L1 := Rmin_r 1 (Rmin s1 s2)).
      assert (L2 := Rmin_l s1 s2). assert (L3 := Rmin_r s1 s2).
      assert (Sc : Rabs (s * c) <= 1 / 2).
      { rewrite Rabs_mult, (Rabs_right s) by lra. assert (E : s1 * (Rabs c + 1) = 1 / 2) by (unfold s1; field; lra).
        assert (s * (Rabs c + 1) <= s1 * (Rabs c + 1)) by (apply Rmult_le_compat_r; lra). lra. }
      assert (Sm : s * M <= e).
      { assert (E : s2 * (M + 1) = e) by (unfold s2; field; lra).
        assert (s * (M + 1) <= s2 * (M + 1)) by (apply Rmult_le_compat_r; lra). lra. }
      assert (C0 : - (1 / 2) <= s * c <= 1 / 2) by (revert Sc; unfold Rabs; destruct Rcase_abs; lra).
      set (u := add n (scal s y)). assert (Nu : norm2 u = 1 + 2 * (s * c) + s * s * Q).
      { unfold u. replace (norm2 (add n (scal s y))) with (norm2 n + 2 * (s * dot n y) + s * s * norm2 y)
          by (unfold norm2, dot; simpl; ring). rewrite Nn. fold c Q. ring. }
      assert (SQ : 0 <= s * s * Q) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra|auto]).
      assert (Pu : 0 < norm2 u).
      { rewrite Nu. destruct (Req_dec (s * s * Q) 0) as [E|E]; [|lra]. rewrite E.
        assert (Cs := cauchy n y). rewrite Nn in Cs. fold c Q in Cs. nra. }
      assert (Nz : u <> origin) by (apply norm2_pos_inv; auto). assert (Pn := norm_nonneg u).
      assert (Lo : 1 + s * c <= norm u).
      { apply norm_ge; [lra|]. rewrite Nu. assert (Cs := cauchy n y). rewrite Nn in Cs. fold c Q in Cs.
        assert (s * s * (c * c) <= s * s * (1 * Q)) by (apply Rmult_le_compat_l; [apply Rmult_le_pos; lra|auto]). nra. }
      assert (Hi : norm u <= 1 + s * c + s * s * Q).
      { apply norm_le; [lra|]. rewrite Nu. nra. }
      apply (beneath_most _ u (d + s * r + s * (d * c) + s * s * K)); auto.
      - intros p (b & a & Hb & Ha & ->).
        assert (G : P (map (moved v w s) A) B (sub b a)) by (apply P_minkowski; exists a, b; auto).
        revert G. generalize (sub b a). apply hull_halfspace. intros g (a' & b' & Ia & Ib & ->).
        apply in_map_iff in Ia. destruct Ia as (a0 & <- & Ia). specialize (Hy a0 b' Ia Ib). specialize (HK a0 Ia).
        assert (F : dot n (sub b' a0) <= d) by (apply Bn; exists b', a0; split; [apply hull_in; auto|split; [apply
          hull_in; auto|auto]]).
        assert (E : dot u (sub b' (moved v w s a0)) = dot n (sub b' a0) + s * (dot (sub (sub b' a0) t) y + speed v w n
          a0)
          + s * (d * c) + s * s * - dot y (add v (cross w a0))).
        { unfold u, moved, speed, t, c, dot; simpl; ring. }
        rewrite E. assert (s * (dot (sub (sub b' a0) t) y + speed v w n a0) <= s * r) by (apply Rmult_le_compat_l; lra).
        assert (s * s * - dot y (add v (cross w a0)) <= s * s * K) by (apply Rmult_le_compat_l; [apply Rmult_le_pos;
          lra|auto]). lra.
      - set (m := d + s * (r + e)). set (h := norm u - (1 + s * c)).
        assert (H0 : 0 <= h <= s * s * Q) by (unfold h; lra).
        replace (m * norm u) with (m * (1 + s * c) + m * h) by (unfold h; ring).
        assert (Am : Rabs m <= Rabs d + Rabs (r + e)).
        { unfold m. apply Rle_trans with (1 := Rabs_triang _ _). rewrite Rabs_mult, (Rabs_right s) by lra. nra. }
        assert (Mh : - ((Rabs d + Rabs (r + e)) * (s * s * Q)) <= m * h).
        { assert (Rabs (m * h) <= (Rabs d + Rabs (r + e)) * (s * s * Q)).
          { rewrite Rabs_mult, (Rabs_right h) by lra. apply Rmult_le_compat; try lra. apply Rabs_pos. }
          assert (G := Rle_abs (- (m * h))). rewrite Rabs_Ropp in G. lra. }
        assert (Rc := Rle_abs (- ((r + e) * c))). rewrite Rabs_Ropp in Rc.
        assert (Em : m * (1 + s * c) = d + s * r + s * e + s * (d * c) + s * s * ((r + e) * c)) by (unfold m; ring).
        rewrite Em. assert (Rs : - (s * s * Rabs ((r + e) * c)) <= s * s * ((r + e) * c)).
        { assert (0 <= s * s) by (apply Rmult_le_pos; lra). nra. }
        assert (Sem : s * (s * M) <= s * e) by (apply Rmult_le_compat_l; lra).
        replace (s * (s * M)) with (s * s * Rabs ((r + e) * c) + (Rabs d + Rabs (r + e)) * (s * s * Q) + s * s * K) in
          Sem
          by (unfold M; ring). lra.
    Qed.
  End Upper.

  (* ---- no slower, if they are apart ---- *)
  Theorem rate_least_apart : forall p, d < 0 -> patch_of X Y d n p -> r <= speed v w n p ->
    forall e, 0 < e -> exists s0, 0 < s0 /\ forall s, 0 < s < s0 -> at_least (core_gaps (moved_body v w s A ra) Y) (d +
      s * (r - e)).
  Proof.
    intros p Hd [Pa Pb] Hr e He. destruct Opt as [Nn _]. set (V := add v (cross w p)). set (Q := norm2 V).
    assert (PQ : 0 <= Q) by apply norm2_nonneg. assert (A0 := Rabs_pos r).
    set (s1 := - d / (Rabs r + 1)). set (s2 := 2 * - d * e / (Q + 1)).
    assert (P1 : 0 < s1) by (apply Rdiv_lt_0_compat; lra).
    assert (P2 : 0 < s2) by (apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; lra|lra]).
    exists (Rmin s1 s2). split; [apply Rmin_glb_lt; auto|]. intros s [Ps Ls].
    assert (L1 := Rmin_l s1 s2). assert (L2 := Rmin_r s1 s2).
    assert (S1 : s * r <= - d).
    { assert (E : s1 * (Rabs r + 1) = - d) by (unfold s1; field; lra). assert (Ar := Rle_abs r).
      assert (s * (Rabs r + 1) <= s1 * (Rabs r + 1)) by (apply Rmult_le_compat_r; lra). nra. }
    assert (S2 : s * Q <= 2 * - d * e).
    { assert (E : s2 * (Q + 1) = 2 * - d * e) by (unfold s2; field; lra).
      assert (s * (Q + 1) <= s2 * (Q + 1)) by (apply Rmult_le_compat_r; lra). lra. }
    assert (Neg : d + s * (r - e) <= 0) by (assert (0 < s * e) by (apply Rmult_lt_0_compat; auto); lra).
    split; [lra|]. intros _. exists (sub (add p t) (moved v w s p)). split.
    - exists (add p t), (moved v w s p). split; [exact Pb|]. split; [apply moved_conv; exact Pa|auto].
    - assert (E : norm2 (sub (add p t) (moved v w s p)) = d * d * norm2 n + 2 * (s * (d * speed v w n p)) + s * s * Q).
      { unfold t, moved, speed, Q, V, norm2, dot; simpl; ring. }
      rewrite E, Nn. assert (d * speed v w n p <= d * r) by nra.
      assert (s * (d * speed v w n p) <= s * (d * r)) by (apply Rmult_le_compat_l; lra).
      assert (s * (s * Q) <= s * (2 * - d * e)) by (apply Rmult_le_compat_l; lra).
      assert (0 <= s * (r - e) * (s * (r - e))) by apply Rle_0_sqr.
      replace ((d + s * (r - e)) * (d + s * (r - e))) with (d * d + 2 * (s * (d * r)) + s * (2 * - d * e) + s * (r - e)
        * (s * (r - e)))
        by ring. lra.
  Qed.
End Rate.

(* the signed depth e at the time s is at most that with the rate, to first order *)
Theorem rate_bounds : forall A B ra rb d v w r, rate_is (Body (Points A) ra) (Body (Points B) rb) d v w r ->
  forall e, 0 < e -> exists s0, 0 < s0 /\ forall s x, 0 < s < s0 ->
    signed_depth (core_gaps (moved_body v w s A ra) (Body (Points B) rb)) x -> x <= d + s * (r + e).
Proof.
  intros A B ra rb d v w r [_ (n & O & Slow)] e He.
  destruct (rate_most A B ra rb d r v w n O Slow e He) as (s0 & P0 & G).
  exists s0. split; auto. intros s x Hs [L _]. apply (least_le_most _ _ _ L). apply G. auto.
Qed.

(* and if the cores are apart, the rate is the one-sided derivative *)
Theorem rate_apart : forall A B ra rb d v w r, d < 0 -> rate_is (Body (Points A) ra) (Body (Points B) rb) d v w r ->
  grows (fun s => core_gaps (moved_body v w s A ra) (Body (Points B) rb)) d r.
Proof.
  intros A B ra rb d v w r Hd R e He. destruct (rate_bounds _ _ _ _ _ _ _ _ R e He) as (s0 & P0 & G).
  destruct R as [Fast (n & O & _)]. destruct (Fast n O) as (p & Hp & Hr).
  destruct (rate_least_apart A B ra rb d r v w n O p Hd Hp Hr e He) as (s1 & P1 & K).
  exists (Rmin s0 s1). split; [apply Rmin_glb_lt; auto|]. intros s x [Ps Ls] V.
  assert (M0 := Rmin_l s0 s1). assert (M1 := Rmin_r s0 s1).
  assert (U := G s x (conj Ps (Rlt_le_trans _ _ _ Ls M0)) V).
  assert (L := least_le_most _ _ _ (K s (conj Ps (Rlt_le_trans _ _ _ Ls M1))) (proj2 V)). lra.
Qed.

(* ---- radii are added to both ---- *)
Lemma grows_bodies : forall A Y ra d v w r, A <> [] -> 0 <= ra -> 0 <= radius Y ->
  bounded_core (core_of Y) \/ half_space_core (core_of Y) ->
  grows (fun s => core_gaps (moved_body v w s A ra) Y) d r ->
  grows (fun s => gaps (moved_body v w s A ra) Y) (d + (ra + radius Y)) r.
Proof.
  intros A Y ra d v w r NA Pa Py HY D e He. destruct (D e He) as (s0 & P0 & G). exists s0. split; auto.
  intros s x Hs Hx.
  assert (C : comparable (core_of (moved_body v w s A ra)) (core_of Y)).
  { assert (K : bounded_core (core_of (moved_body v w s A ra))) by (simpl; destruct A; [congruence|discriminate]).
    unfold comparable. tauto. }
  destruct (core_gaps_planed _ _ C) as (y & Vy & _).
  assert (E := signed_depth_unique _ _ _ Hx (theorem_R _ _ y C Pa Py Vy)). cbn [moved_body radius] in E.
  specialize (G s y Hs Vy). lra.
Qed.
