(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* THE THEOREM about the line of a certificate of format 4: what it says is true of the bodies in
   the file. *)
Require Import Reals Lra Psatz List ZArith Lia Bool.
From Fathom.checker Require Import vector sequence table support certificate verdict body signed signed_verdict patch
  patch_verdict.
From Fathom.geometry Require Import meaning bodies space norm hulls difference scaling signed_depth rounded ways_out
  curved units gaps said.
From Fathom.geometry Require Import contact patches rates rates_overlap rates_plane rates_moving.
From Fathom.soundness Require Import statement booleans verdict_sound signed_sides signed_units
  signed_claims.
From Fathom.soundness Require Import signed_sound patch_sound.
Import ListNotations.
Open Scope R_scope.

(* the unit vector of a direction *)
Definition unit_of (n : zvec) : pt := along (inj n) 1.

Lemma scal_unit : forall n d, scal d (unit_of n) = along (inj n) d.
Proof. intros n d. unfold unit_of, along. rewrite scal_scal. f_equal. unfold Rdiv. ring. Qed.
Lemma norm2_unit : forall n, inj n <> origin -> norm2 (unit_of n) = 1.
Proof.
  intros n Hn. assert (P0 := norm_pos _ Hn). unfold unit_of, along. rewrite norm2_scal, <- norm_sqr. field. lra.
Qed.

Lemma directed_unit : forall n, inj n <> origin -> directed (real (integer_point n)) (unit_of n).
Proof.
  intros n Hn. split; [apply norm2_unit; auto|]. assert (P0 := norm_pos _ Hn). exists (1 / norm (inj n)).
  split; [apply Rdiv_lt_0_compat; lra|]. unfold unit_of, along, real, integer_point, value. cbn [qx qy qz num den].
    f_equal.
  unfold inj. f_equal; field.
Qed.

(* each direction with its patch *)
Lemma check_patches_spec : forall check ns ps done cs, check_patches check ns ps done = Some cs ->
  exists qs, cs = rev done ++ qs /\ map fst qs = ns /\ forall n ends, In (n, ends) qs -> exists p, check n p = Some
    ends.
Proof.
  intros check. induction ns as [|n ns IH]; intros [|p ps] done cs H; try discriminate; simpl in H.
  - inversion H. exists []. rewrite rev_append_rev. split; auto. split; auto. intros n ends [].
  - destruct (check n p) as [e|] eqn:E; [|discriminate]. destruct (IH _ _ _ H) as (qs & -> & F & G).
    exists ((n, e) :: qs). simpl. rewrite <- app_assoc, F. split; auto. split; auto.
    intros k ends [K|K]; [inversion K; subst; eauto|eauto].
Qed.

(* ---- the speed at a corner, along a direction ---- *)
Lemma file_point_real : forall m q, (0 < m)%Z -> 0 < IZR (snd q) -> real (file_point m q) = scal (/ IZR m) (at_quotient
  q).
Proof.
  intros m [x k] Hm Hk. assert (Pm := IZR_pos _ Hm). cbn [snd] in Hk. unfold real, file_point, at_quotient, value.
  cbn [qx qy qz num den fst snd].
  pteq; rewrite mult_IZR; field; lra.
Qed.

Section Speed.
  Variables (m : Z) (r : rate) (n : zvec) (q : quotient).
  Hypothesis Hm : (0 < m)%Z.
  Hypothesis Hq : 0 < IZR (snd q).
  Hypothesis Hn : inj n <> origin.
  Hypothesis He : (0 < rate_unit r)%Z.
  Hypothesis Hd : (0 < den (rate_square r))%Z.
  Hypothesis Fv : fits (rate_unit r) (rate_v r) = true.
  Hypothesis Fw : fits (rate_unit r) (rate_w r) = true.
  Let v := integral (rate_unit r) (rate_v r).
  Let w := integral (rate_unit r) (rate_w r).
  Let at_ := real (file_point m q).
  Let s := speed (real (rate_v r)) (real (rate_w r)) (unit_of n) at_.
  Let k := IZR (rate_unit r) * IZR m * IZR (snd q).

  Lemma zspeed_real : IZR (zspeed m v w n q) = k * norm (inj n) * s.
  Proof.
    assert (Pm := IZR_pos _ Hm). assert (Pe := IZR_pos _ He). assert (Pn := norm_pos _ Hn).
    unfold zspeed. rewrite opp_IZR, plus_IZR, !mult_IZR, dot_inj, det_inj. unfold v, w. rewrite !integral_scal by auto.
    unfold s, at_, speed, k. rewrite file_point_real by auto. unfold at_quotient, unit_of, along, det, dot. simpl.
    field. lra.
  Qed.
  Lemma square_real : IZR (signed_square (zspeed m v w n q)) = k * k * norm2 (inj n) * signed_sqr s.
  Proof.
    assert (Pm := IZR_pos _ Hm). assert (Pe := IZR_pos _ He). assert (Pn := norm_pos _ Hn).
    assert (Pk : 0 < k) by (unfold k; repeat apply Rmult_lt_0_compat; auto).
    rewrite IZR_signed_square, zspeed_real, signed_sqr_scal by (apply Rmult_le_pos; lra). rewrite <- norm_sqr. ring.
  Qed.

  Let right := (num (rate_square r) * (rate_unit r * m * snd q * (rate_unit r * m * snd q)) * zdot n n)%Z.
  Lemma right_real : IZR right = k * k * norm2 (inj n) * IZR (den (rate_square r)) * signed_sqr (signed_root (value
    (rate_square r))).
  Proof.
    assert (Pd := IZR_pos _ Hd). unfold right. rewrite signed_sqr_root, !mult_IZR, norm2_inj. unfold value, k. field.
    lra.
  Qed.
  Lemma factor_positive : 0 < k * k * norm2 (inj n) * IZR (den (rate_square r)).
  Proof.
    assert (Pm := IZR_pos _ Hm). assert (Pe := IZR_pos _ He). assert (Pd := IZR_pos _ Hd). assert (N := norm2_pos _ Hn).
    unfold k. repeat apply Rmult_lt_0_compat; auto.
  Qed.

  Lemma fast_enough : rate_against Z.geb m r v w n q = true -> signed_root (value (rate_square r)) <= s.
  Proof.
    intros H. unfold rate_against in H. cbv zeta in H. rewrite Z.geb_leb in H. apply Z.leb_le, IZR_le in H.
    fold right in H.
    rewrite right_real, mult_IZR, square_real in H. apply signed_sqr_le.
    apply Rmult_le_reg_l with (1 := factor_positive). lra.
  Qed.
  Lemma slow_enough : rate_against Z.leb m r v w n q = true -> s <= signed_root (value (rate_square r)).
  Proof.
    intros H. unfold rate_against in H. cbv zeta in H. apply Z.leb_le, IZR_le in H. fold right in H.
    rewrite right_real, mult_IZR, square_real in H. apply signed_sqr_le.
    apply Rmult_le_reg_l with (1 := factor_positive). lra.
  Qed.
End Speed.

Section Verdict.
  Variables (m : Z) (A B : body pt R) (ZA ZB : zbody).
  Hypothesis Hm : (0 < m)%Z.
  Hypothesis EA : map_body inj IZR IZR ZA = scale_body (IZR m) A.
  Hypothesis EB : map_body inj IZR IZR ZB = scale_body (IZR m) B.
  Notation za := (core_of ZA).
  Notation zb := (core_of ZB).

  Lemma in_zcore_a : forall p, in_zcore za (scal (IZR m) p) <-> in_core (core_of A) p.
  Proof.
    assert (Pm := IZR_pos _ Hm). intros p. assert (E := f_equal (@core_of _ _) EA). simpl in E. rewrite E.
    fold (scale_core (IZR m) (core_of A)).
    split; [|apply in_core_scal; auto]. intros H. apply in_core_scal_inv in H; auto. rewrite scal_inv' in H by lra.
    auto.
  Qed.
  Lemma in_zcore_b : forall p, in_zcore zb (scal (IZR m) p) <-> in_core (core_of B) p.
  Proof.
    assert (Pm := IZR_pos _ Hm). intros p. assert (E := f_equal (@core_of _ _) EB). simpl in E. rewrite E.
    fold (scale_core (IZR m) (core_of B)).
    split; [|apply in_core_scal; auto]. intros H. apply in_core_scal_inv in H; auto. rewrite scal_inv' in H by lra.
    auto.
  Qed.

  (* one direction with its patch, in the file's units *)
  Lemma patch_says : forall qn qd n p ends, (0 < qd)%Z ->
    check_patch za zb (numbered (spots za)) (numbered (spots zb)) (qn * (m * m)) qd n p = Some ends ->
    let d := signed_root (IZR qn / IZR qd) in
    inj n <> origin /\ (forall q, In q ends -> 0 < IZR (snd q))
    /\ optimal (core_gaps A B) d (unit_of n)
    /\ cornered (patch_of A B d (unit_of n)) (map real (map (file_point m) ends)).
  Proof.
    intros qn qd n p ends Hqd H d. assert (Pm := IZR_pos _ Hm).
    destruct (check_patch_sound _ _ _ _ _ _ _ Hqd H) as (Hn & Hb & P0 & C). rewrite root_in_units in * by auto.
    fold d in Hb, C.
    split; auto. split; auto. split.
    - split; [apply norm2_unit; auto|]. intros g Hg. apply (zgaps_core m A B ZA ZB Hm EA EB) in Hg. apply Hb in Hg.
      rewrite dot_scal_r in Hg.
      assert (Pn := norm_pos _ Hn). unfold unit_of, along. rewrite dot_scal_l.
      apply Rmult_le_reg_l with (IZR m * norm (inj n)); [apply Rmult_lt_0_compat; auto|].
      replace (IZR m * norm (inj n) * (1 / norm (inj n) * dot (inj n) g)) with (IZR m * dot (inj n) g) by (field; lra).
        lra.
    - assert (E : map real (map (file_point m) ends) = map (scal (/ IZR m)) (map at_quotient ends)).
      { rewrite !map_map. apply map_ext_in. intros q Iq. apply file_point_real; auto. }
      rewrite E. apply (cornered_scal (meeting (in_zcore za) (in_zcore zb) (along (inj n) (IZR m * d)))); auto; [apply
        Rinv_0_lt_compat; auto|].
      intros x. unfold patch_of, meeting. rewrite scal_unit, <- in_zcore_a, <- in_zcore_b, scal_back by auto.
      replace (scal (IZR m) (add (scal (/ IZR m) x) (along (inj n) d))) with (add x (along (inj n) (IZR m * d)));
        [tauto|].
      assert (Pn := norm_pos _ Hn). unfold along. pteq; field; lra.
  Qed.

  (* ---- the listed directions are all ---- *)
  Let normal (c : core pt R) : pt := match c with Half_space n _ => n | _ => origin end.
  Lemma whole_says : forall c qn qd ns, signed_check m ZA ZB c = true -> directions_of c = Some (qn, qd, ns, true) ->
    let d := signed_root (IZR qn / IZR qd) in at_least (core_gaps A B) d ->
    (forall n, In n ns -> optimal (core_gaps A B) d (unit_of n)) ->
    forall u, optimal (core_gaps A B) d u -> exists n, In n ns /\ u = unit_of n.
  Proof.
    intros c qn qd ns H D d L Listed u Hu. assert (Pm := IZR_pos _ Hm). unfold signed_check in H.
    apply andb_true_iff in H. destruct H as [_ H].
    destruct c as [qn' qd' complete dirs q|qn' qd' n unit WA WB all|qn' qd' n|]; try discriminate; inversion D; subst.
    - destruct za as [LA| |] eqn:CA; try discriminate. destruct zb as [LB| |] eqn:CB; try discriminate.
      assert (Hqd : (0 < qd)%Z) by (unfold check_depth in H; bsplit; auto).
      destruct (deep_sound LA LB _ _ _ _ _ H) as (Ps & _ & _ & W). rewrite root_in_units in * by auto. fold d in Ps, W.
      destruct (W eq_refl) as (_ & _ & W3). destruct Hu as [Nu Bu].
      destruct (W3 (scal (IZR m * d) u)) as (n & I0 & E).
      { split; [rewrite norm2_scal, Nu; ring|].
        apply (halfspace_not_interior _ u (IZR m * d)); [lra| |rewrite dot_scal_r; fold (norm2 u); rewrite Nu; lra].
        intros g Hg. rewrite <- CA, <- CB in Hg. apply (zgaps_back m A B ZA ZB Hm EA EB) in Hg. apply Bu in Hg.
        rewrite dot_scal_r in Hg.
        replace (dot u g) with (IZR m * (/ IZR m * dot u g)) by (field; lra). apply Rmult_le_compat_l; lra. }
      apply in_map_iff in I0. destruct I0 as (x & <- & Ix). exists (fst x).
      split; [rewrite each_map; apply in_map; auto|].
      rewrite <- scal_unit in E. rewrite <- (scal_inv' (IZR m * d) u), E, scal_inv' by lra. auto.
    - destruct za as [LA| |] eqn:CA; try discriminate. destruct zb as [LB| |] eqn:CB; try discriminate.
      assert (Hq : (0 < qn')%Z /\ (0 < qd)%Z). { match goal with K : (0 <? qn')%Z = true |- _ => apply Z.ltb_lt in K;
        split; auto end. unfold check_beside in H.
        apply andb_true_iff in H. destruct H as [H _]. bsplit. auto. }
      destruct Hq as [Hq Hqd]. exists n. split; [simpl; auto|].
      apply (optimal_nearest (core_gaps A B) d); auto; [|apply Listed; simpl; auto].
      unfold d. rewrite opp_IZR. replace (- IZR qn' / IZR qd) with (- (IZR qn' / IZR qd)) by (unfold Rdiv; ring).
      rewrite signed_root_opp.
      assert (0 < signed_root (IZR qn' / IZR qd)); [|lra]. apply Rnot_le_lt. intros K. apply signed_sqr_le in K.
      rewrite signed_sqr_root, signed_sqr_pos in K by lra. assert (0 < IZR qn' / IZR qd); [|lra].
      apply Rdiv_lt_0_compat; apply IZR_lt; auto.
    - unfold check_on_plane in H. bsplit. rename H into Hk. exists n. split; [simpl; auto|].
      assert (G : exists h c, h <> origin /\ forall x, dot h x <= c -> core_gaps A B x).
      { destruct (at_least_some _ _ L) as (g & b & a & Hb & Ha & _). assert (FA := f_equal (@core_of _ _) EA).
        assert (FB := f_equal (@core_of _ _) EB). simpl in FA, FB.
        assert (Nz : forall s o hs k h, reach s (Half_space o k) 1 hs = Some h -> inj o <> origin).
        { intros s o hs k h E. simpl in E. destruct (same_sense o s) eqn:S; [|discriminate].
          apply (same_sense_multiple o s S). }
        unfold height_root, outer_height, sum_of_fractions in H0. cbn [height_unit heights_a heights_b] in H0.
        destruct (reach n zb 1 []) as [[x e]|] eqn:RB; [|discriminate].
        destruct (reach (zneg n) za 1 []) as [[y f]|] eqn:RA; [|discriminate].
        destruct za as [LA|ta|ma oa] eqn:CA; destruct zb as [LB|tb|mb ob] eqn:CB; try discriminate.
        - apply Nz in RB. unfold core_gaps. destruct (core_of B) as [K|ts|o k]; try discriminate.
          assert (E1 := f_equal normal FB). cbn [map_core normal] in E1.
          exists o, (k - dot o a). split; [intros ->; apply RB; rewrite E1; pteq; ring|]. intros z Hz.
          apply (half_space_minus_point o k _ a); auto.
        - apply Nz in RA. unfold core_gaps. destruct (core_of A) as [K|ts|o k]; try discriminate.
          assert (E1 := f_equal normal FA). cbn [map_core normal] in E1.
          exists (scal (-1) o), (k + dot (scal (-1) o) b). split.
          + intros Z. apply RA. rewrite E1. apply norm2_zero. assert (N := norm2_scal (-1) o).
            rewrite Z, norm2_origin in N. rewrite norm2_scal.
            replace (norm2 o) with 0 by lra. ring.
          + intros z Hz. apply (point_minus_half_space o k _ b); auto. }
      destruct G as (h & c & Hh & G). rewrite (optimal_half_space (core_gaps A B) h c d u Hh G Hu).
      symmetry. apply (optimal_half_space (core_gaps A B) h c d); auto. apply Listed. simpl. auto.
  Qed.

  (* ---- rates ---- *)
  Lemma rate_says : forall d cs r, check_rate m cs r = true ->
    (forall n ends, In (n, ends) cs -> inj n <> origin /\ (forall q, In q ends -> 0 < IZR (snd q)) /\ optimal
      (core_gaps A B) d (unit_of n)
       /\ cornered (patch_of A B d (unit_of n)) (map real (map (file_point m) ends))) ->
    (forall u, optimal (core_gaps A B) d u -> exists n ends, In (n, ends) cs /\ u = unit_of n) ->
    rate_is A B d (real (rate_v r)) (real (rate_w r)) (signed_root (value (rate_square r))).
  Proof.
    intros d cs r H Each All. unfold check_rate in H. cbv zeta in H. apply andb_true_iff in H. destruct H as [H Some_].
    apply existsb_exists in Some_. destruct Some_ as ((n0 & ends0) & I1 & K1). cbn [fst snd] in K1.
    apply andb_true_iff in H. destruct H as [H Every_]. bsplit. rename H into He, H2 into Hd, H1 into Fv, H0 into Fw.
    split.
    - intros u Hu. destruct (All u Hu) as (n & ends & I0 & ->). destruct (Each n ends I0) as (Hn & P0 & _ & C & _).
      assert (K := forallb_In _ _ _ Every_ _ I0). cbn [fst snd] in K. apply existsb_exists in K.
      destruct K as (q & Iq & K).
      exists (real (file_point m q)). split; [apply C, hull_in, in_map, in_map; auto|]. apply fast_enough; auto.
    - destruct (Each n0 ends0 I1) as (Hn & P0 & O & C & _). exists (unit_of n0). split; auto. intros p Hp.
      apply C in Hp. revert p Hp. apply speed_hull.
      intros p Ip. apply in_map_iff in Ip. destruct Ip as (x & <- & Ix). apply in_map_iff in Ix.
      destruct Ix as (q & <- & Iq).
      apply slow_enough; auto. exact (forallb_In _ _ _ K1 q Iq).
  Qed.
End Verdict.

Lemma stated_root : forall rho c qn qd ns all, directions_of c = Some (qn, qd, ns, all) ->
  exists st optima cone, signed_stated rho c = Root_is st (Ratio qn qd) rho optima cone
    /\ match optima with Some k => Z.of_nat (length ns) = k | None => True end.
Proof.
  intros rho c qn qd ns all H. destruct c as [qn' qd' complete dirs q|qn' qd' n unit WA WB k|qn' qd' n|]; inversion H;
    subst; cbn [signed_stated];
    eexists; eexists; eexists; (split; [reflexivity|]); [|exact I|exact I].
  destruct all; auto. rewrite count_length, each_map, map_length. auto.
Qed.
Lemma claim_positive : forall m A B c qn qd ns all, signed_check m A B c = true -> directions_of c = Some (qn, qd, ns,
  all) -> (0 < qd)%Z.
Proof.
  intros m A B c qn qd ns all H D. unfold signed_check in H. apply andb_true_iff in H. destruct H as [_ H].
  destruct c as [qn' qd' complete dirs q|qn' qd' n unit WA WB k|qn' qd' n|]; inversion D; subst.
  - destruct (core_of A), (core_of B); try discriminate. unfold check_depth in H. bsplit. auto.
  - destruct (core_of A), (core_of B); try discriminate. unfold check_beside in H. apply andb_true_iff in H.
    destruct H as [H _]. bsplit. auto.
  - unfold check_on_plane in H. bsplit. auto.
Qed.

Theorem patched_verdict_sound : forall width m rho A B c s, patched_verdict width m rho A B c = Some s ->
  says_patched (real_body A) (real_body B) s.
Proof.
  intros width m rho A B c s H. unfold patched_verdict in H.
  destruct (signed_verdict width m rho A B (base c)) as [t|] eqn:V; [|discriminate].
  destruct (directions_of (base c)) as [[[[qn qd] ns] all]|] eqn:D; [|discriminate]. cbv zeta in H.
  destruct (check_patches _ _ _ []) as [cs|] eqn:P0; [|discriminate].
  destruct (match rates c with [] => true | _ :: _ => _ end) eqn:R0; [|discriminate]. inversion H. subst s. clear H.
  assert (Says := signed_verdict_sound _ _ _ _ _ _ _ V). unfold signed_verdict in V. cbv zeta in V.
  destruct (all_body _ _ A && all_body _ _ B && _ && _ && _ && signed_check _ _ _ _) eqn:E; [|discriminate].
  inversion V. subst t. clear V. apply andb_true_iff in E. destruct E as [E C]. apply andb_true_iff in E.
  destruct E as [E _]. bsplit.
  clear H0 H1. rename H into FA, H2 into FB.
  assert (Hm : (0 < m)%Z). { assert (C' := C). unfold signed_check in C'. apply andb_true_iff in C'.
  destruct C' as [C' _]. bsplit. auto. }
  assert (EA := in_units_real m A Hm FA). assert (EB := in_units_real m B Hm FB).
  assert (Hqd := claim_positive _ _ _ _ _ _ _ _ C D).
  destruct (stated_root rho _ _ _ _ _ D) as (st & optima & cone & St & Count).
  destruct (check_patches_spec _ _ _ _ _ P0) as (qs & -> & Fst & Each). cbn [rev app] in *. clear P0.
  set (d := signed_root (IZR qn / IZR qd)).
  assert (Patch : forall n ends, In (n, ends) qs -> inj n <> origin /\ (forall q, In q ends -> 0 < IZR (snd q))
    /\ optimal (core_gaps (real_body A) (real_body B)) d (unit_of n)
    /\ cornered (patch_of (real_body A) (real_body B) d (unit_of n)) (map real (map (file_point m) ends))).
  { intros n ends I0. destruct (Each n ends I0) as (p & K).
    apply (patch_says m _ _ (in_units m A) (in_units m B) Hm EA EB _ _ _ p); auto. }
  assert (Cores : signed_depth (core_gaps (real_body A) (real_body B)) d).
  { rewrite St in Says. destruct Says as (x & r & Ex & Cx & _). apply signed_depth_said. replace d with x; auto.
    apply signed_sqr_inj. unfold d. rewrite signed_sqr_root. exact Ex. }
  assert (Least : at_least (core_gaps (real_body A) (real_body B)) d).
  { apply Cores. }
  assert (Whole : all = true -> forall u, optimal (core_gaps (real_body A) (real_body B)) d u -> exists n ends, In (n,
    ends) qs /\ u = unit_of n).
  { intros -> u Hu. destruct (whole_says m _ _ (in_units m A) (in_units m B) Hm EA EB _ _ _ _ C D Least) with (u := u)
    as (n & I0 & Eu); auto.
    - intros n I0. rewrite <- Fst in I0. apply in_map_iff in I0. destruct I0 as ((k & ends) & <- & I0).
      destruct (Patch k ends I0) as (_ & _ & O & _). exact O.
    - rewrite <- Fst in I0. apply in_map_iff in I0. destruct I0 as ((k & ends) & <- & I0). exists k, ends. auto. }
  split; [exact Says|]. exists d. cbn [depth_says whole corners_at rates_are]. split; [apply signed_depth_said;
    exact Cores|].
  rewrite each_map. split; [|split; [|split]].
  - intros n ps I0. apply in_map_iff in I0. destruct I0 as ((k & ends) & K & I0). inversion K. subst. cbn [fst snd].
    exists (unit_of k). rewrite each_map. split; [apply directed_unit|]; apply (Patch k ends); auto.
  - intros Ha u Hu. destruct (Whole Ha u Hu) as (n & ends & I0 & ->). exists (integer_point n), (each (file_point m)
      ends). split.
    + apply in_map_iff. exists (n, ends). auto.
    + apply directed_unit, (Patch n ends). auto.
  - intros st' q rho' k cone' Eq. rewrite St in Eq. inversion Eq. subst. rewrite map_length.
      rewrite map_length in Count. auto.
  - intros r Ir. destruct (rates c) as [|r0 rs] eqn:Rc; [contradiction|]. apply andb_true_iff in R0.
    destruct R0 as [Ha R0]. exists (signed_root (value (rate_square r))). split; [apply signed_sqr_root|].
    apply (rate_says m _ _ Hm d qs); auto. exact (forallb_In _ _ _ R0 r Ir).
Qed.

Lemma half_space_height_a : forall B n o qn qd k, height_root (Half_space o k) B qn qd n = true -> inj o <> origin.
Proof.
  intros B n o qn qd k H. unfold height_root, outer_height, sum_of_fractions in H.
  cbn [height_unit heights_a heights_b] in H.
  destruct (reach n B 1 []) as [[x e]|]; [|discriminate]. cbn [reach] in H.
  destruct (same_sense o (zneg n)) eqn:E; [|discriminate]. apply (same_sense_multiple o (zneg n) E).
Qed.
Lemma radius_back : forall m b, (0 < m)%Z -> all_body (fits m) (divides m) b = true -> (0 <= radius (in_units m b))%Z ->
  0 <= radius (real_body b).
Proof.
  intros m b Hm F R0. assert (Pm := IZR_pos _ Hm). assert (E := f_equal (@radius _ _) (in_units_real m b Hm F)).
  change (IZR (radius (in_units m b)) = IZR m * radius (real_body b)) in E. apply IZR_le in R0. rewrite E in R0. nra.
Qed.

Lemma half_space_height : forall A n o qn qd k, height_root A (Half_space o k) qn qd n = true -> inj o <> origin.
Proof.
  intros A n o qn qd k H. unfold height_root, outer_height, sum_of_fractions in H.
  cbn [reach height_unit heights_b] in H.
  destruct (same_sense o n) eqn:E; [|discriminate]. apply (same_sense_multiple o n E).
Qed.

(* of an accepted rate: the claim, and what is proved of the bodies *)
Lemma accepted_rate : forall width m rho A B c s r, patched_verdict width m rho A B c = Some s -> In r (rates_are s) ->
  exists qn qd ns d, directions_of (base c) = Some (qn, qd, ns, true) /\ d = signed_root (value (Ratio qn qd))
    /\ (0 < m)%Z /\ (0 < qd)%Z /\ all_body (fits m) (divides m) A = true /\ all_body (fits m) (divides m) B = true
    /\ signed_check m (in_units m A) (in_units m B) (base c) = true
    /\ 0 <= radius (real_body A) /\ 0 <= radius (real_body B)
    /\ signed_depth (core_gaps (real_body A) (real_body B)) d
    /\ signed_depth (gaps (real_body A) (real_body B)) (d + (radius (real_body A) + radius (real_body B)))
    /\ rate_is (real_body A) (real_body B) d (real (rate_v r)) (real (rate_w r)) (signed_root (value (rate_square r))).
Proof.
  intros width m rho A B c s r H Ir. assert (Says := patched_verdict_sound _ _ _ _ _ _ _ H).
  unfold patched_verdict in H. destruct (signed_verdict width m rho _ _ (base c)) as [u|] eqn:V; [|discriminate].
  destruct (directions_of (base c)) as [[[[qn qd] ns] all]|] eqn:D; [|discriminate]. cbv zeta in H.
  destruct (check_patches _ _ _ []) as [cs|]; [|discriminate].
  destruct (match rates c with [] => true | _ :: _ => _ end) eqn:R0; [|discriminate]. inversion H. subst s. clear H.
  cbn [rates_are depth_says] in *. unfold signed_verdict in V. cbv zeta in V.
  destruct (_ && signed_check _ _ _ _) eqn:E; [|discriminate]. inversion V. subst u. clear V.
  apply andb_true_iff in E. destruct E as [E C]. assert (C' := C). unfold signed_check in C'. apply andb_true_iff in C'.
  destruct C' as [Rad _]. assert (Hm : (0 < m)%Z) by (bsplit; auto).
  assert (Ha : all = true). { destruct (rates c); [contradiction|]. apply andb_true_iff in R0. apply R0. }
  subst all. destruct (stated_root rho _ _ _ _ _ D) as (st & optima & cone & St & _).
  assert (Hqd := claim_positive _ _ _ _ _ _ _ _ C D). rewrite St in Says. destruct Says as (S1 & d & Ed & Rest).
  destruct S1 as (x & rr & Ex & S2 & -> & Erho & S3 & _). destruct Rest as (_ & _ & _ & Rates).
  destruct (Rates r Ir) as (y & Ey & Rate_y). clear Rates. apply signed_depth_said in S2, S3, Ed.
  assert (Roots : forall q z, root_is q z -> z = signed_root (value q)).
  { intros q z E0. apply signed_sqr_inj. rewrite signed_sqr_root. exact E0. }
  rewrite (signed_depth_unique _ _ _ Ed S2) in Rate_y. apply Roots in Ex, Ey. subst x y. bsplit.
  exists qn, qd, ns, (signed_root (value (Ratio qn qd))).
  repeat (split; [solve [auto | apply (radius_back m); auto]|]). auto.
Qed.

Lemma core_units_normal : forall m o k r, (0 < m)%Z -> all_body (fits m) (divides m) (Body (Half_space o k) r) = true ->
  inj (integral m o) <> origin -> real o <> origin.
Proof.
  intros m o k r Hm F Nz. unfold all_body in F. cbn [core_of] in F. bsplit. rewrite (integral_scal m o) in Nz by auto.
  intros Z. apply Nz. rewrite Z. pteq; ring.
Qed.

(* and while points move, with or without radii, each rate that is accepted is the one-sided
   derivative *)
Theorem patched_verdict_rates : forall width m rho A ra B c s r,
  patched_verdict width m rho (Body (Points A) ra) B c = Some s -> In r (rates_are s) ->
  exists d, signed_depth (gaps (real_body (Body (Points A) ra)) (real_body B)) d
    /\ grows (fun t => gaps (moved_body (real (rate_v r)) (real (rate_w r)) t (map real A) (value ra)) (real_body B)) d
         (signed_root (value (rate_square r))).
Proof.
  intros width m rho A ra B c s r H Ir.
  destruct (accepted_rate _ _ _ _ _ _ _ _ H Ir) as (qn & qd & ns & d & D & Ed & Hm & Hqd & _ & FB & C & Pa & Pb & S2 &
    S3 & R).
  assert (EX : real_body (Body (Points A) ra) = Body (Points (map real A)) (value ra))
    by reflexivity.
  exists (d + (value ra + radius (real_body B))). split; [exact S3|]. rewrite EX in *. cbn [radius] in Pa.
  unfold signed_check in C. apply andb_true_iff in C. destruct C as [_ C].
  assert (Empty : forall K, conv K = (fun p => conv K p) -> forall p, conv K p -> K <> []).
  { intros K _ p Hp Z. rewrite Z in Hp. apply (Hp (fun _ => False)); [intros x y l _ []|intros x []]. }
  destruct (at_least_some _ _ (proj1 S2)) as (g & b & a & Hb & Hx & _).
  assert (NA : map real A <> []) by (apply (Empty _ eq_refl a); exact Hx).
  destruct B as [[LB|ts|o k] rb]; cbn [core_of in_units map_body map_core] in C.
  - apply grows_bodies; auto. { left. apply (Empty _ eq_refl b). exact Hb. }
    apply rate_points; auto.
    intros Z. assert (Q := signed_sqr_root (value (Ratio qn qd))). rewrite <- Ed, Z in Q.
    unfold signed_sqr, value in Q. cbn [num den] in Q. assert (Pd := IZR_pos _ Hqd). assert (Zq : IZR qn = 0).
    { apply Rmult_eq_reg_r with (/ IZR qd); [unfold Rdiv in Q; lra|]. apply Rgt_not_eq, Rinv_0_lt_compat; auto. }
    apply (eq_IZR qn 0) in Zq.
    destruct (base c) as [qn' qd' complete dirs q|qn' qd' n unit WA WB l|qn' qd' n|]; inversion D; subst.
    + unfold check_depth in C. bsplit. lia.
    + match goal with K : (0 <? qn')%Z = true |- _ => apply Z.ltb_lt in K end. lia.
    + unfold check_on_plane in C. discriminate.
  - destruct (base c); discriminate.
  - assert (No : real o <> origin).
    { apply (core_units_normal m o k rb); auto.
      destruct (base c) as [qn' qd' complete dirs q|qn' qd' n unit WA WB l|qn' qd' n|]; try discriminate.
      unfold check_on_plane in C. bsplit. exact (half_space_height _ _ _ _ _ _ H1). }
    apply grows_bodies; auto. { right. exists (real o), (value k). auto. }
    apply rate_plane; auto.
Qed.

(* likewise while a half-space moves *)
Theorem patched_verdict_rates_half_space : forall width m rho o k ra B c s r,
  patched_verdict width m rho (Body (Half_space o k) ra) B c = Some s -> In r (rates_are s) ->
  exists d, signed_depth (gaps (real_body (Body (Half_space o k) ra)) (real_body B)) d
    /\ grows (fun t => moved_gaps (real (rate_v r)) (real (rate_w r)) t (real o) (value k) (value ra) (real_body B)) d
         (signed_root (value (rate_square r))).
Proof.
  intros width m rho o k ra B c s r H Ir.
  destruct (accepted_rate _ _ _ _ _ _ _ _ H Ir) as (qn & qd & ns & d & D & Ed & Hm & Hqd & FA & _ & C & Pa & Pb & S2 &
    S3 & R).
  exists (d + (value ra + radius (real_body B))). split; [exact S3|].
  unfold signed_check in C. apply andb_true_iff in C. destruct C as [_ C].
  destruct B as [[LB|ts|o' k'] rb]; cbn [core_of in_units map_body map_core] in C.
  - assert (No : real o <> origin).
    { apply (core_units_normal m o k ra); auto.
      destruct (base c) as [qn' qd' complete dirs q|qn' qd' n unit WA WB l|qn' qd' n|]; try discriminate.
      unfold check_on_plane in C. bsplit. exact (half_space_height_a _ _ _ _ _ _ H1). }
    assert (EY : real_body (Body (Points LB) rb) = Body (Points (map real LB)) (value rb))
      by reflexivity.
    rewrite EY in *. apply rate_half_space_moves; auto.
  - destruct (base c); discriminate.
  - destruct (base c); try discriminate.
Qed.
