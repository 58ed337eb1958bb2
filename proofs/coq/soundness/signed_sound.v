(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* THE THEOREM about the line of a certificate of format 2: what it says is true of the bodies in the file. *)
Require Import Reals Lra Psatz List ZArith Lia Bool.
From Fathom.checker Require Import vector sequence table polytope support certificate verdict body cone signed signed_verdict.
From Fathom.geometry Require Import meaning bodies space norm hulls difference scaling signed_depth rounded ways_out curved units gaps.
From Fathom.soundness Require Import statement booleans printed verdict_sound signed_sides signed_printed signed_units signed_claims
  signed_status.
Import ListNotations.
Open Scope R_scope.

(* what is proved of the cores, and of the bodies *)
Section Verdict.
  Variables (m : Z) (rho : ratio) (A B : body pt R) (ZA ZB : zbody).
  Hypothesis Hm : (0 < m)%Z.
  Hypothesis EA : map_body inj IZR IZR ZA = scale_body (IZR m) A.
  Hypothesis EB : map_body inj IZR IZR ZB = scale_body (IZR m) B.
  Hypothesis Hrho : (0 < den rho)%Z.
  Hypothesis Erho : ((radius ZA + radius ZB) * den rho)%Z = (num rho * m)%Z.
  Hypothesis RA : (0 <= radius ZA)%Z.
  Hypothesis RB : (0 <= radius ZB)%Z.

  Lemma radius_real : IZR (radius ZA) = IZR m * radius A /\ IZR (radius ZB) = IZR m * radius B.
  Proof. split; [apply (f_equal radius) in EA; exact EA|apply (f_equal radius) in EB; exact EB]. Qed.
  Lemma radii : 0 <= radius A /\ 0 <= radius B /\ value rho = radius A + radius B.
  Proof.
    destruct radius_real as [E F]. assert (Pm := IZR_pos _ Hm). assert (Pr := IZR_pos _ Hrho).
    apply IZR_le in RA, RB. rewrite E in RA. rewrite F in RB. split; [nra|]. split; [nra|].
    apply (f_equal IZR) in Erho. rewrite !mult_IZR, plus_IZR, E, F in Erho. unfold value.
    apply Rmult_eq_reg_r with (IZR m * IZR (den rho)); [|apply Rgt_not_eq, Rmult_lt_0_compat; auto].
    replace (IZR (num rho) / IZR (den rho) * (IZR m * IZR (den rho))) with (IZR (num rho) * IZR m) by (field; lra). lra.
  Qed.

  Lemma both_sides : forall x y, at_least (zgaps (core_of ZA) (core_of ZB)) (IZR m * x) -> planed (zgaps (core_of ZA) (core_of ZB))
    (IZR m * y) ->
    signed_depth_in (core_gaps A B) x y /\ signed_depth_in (gaps A B) (x + value rho) (y + value rho).
  Proof.
    intros x y L M. destruct radii as (PA & PB & E). apply (least_back m A B ZA ZB Hm EA EB) in L. apply (planed_back m A B ZA ZB Hm EA
      EB) in M.
    split; split; auto; [apply planed_most; auto|rewrite E; apply R_least; auto|rewrite E; apply R_most; auto].
  Qed.

  Lemma root_says : forall square x, (0 < den square)%Z -> x = signed_root (value square) ->
    at_least (zgaps (core_of ZA) (core_of ZB)) (IZR m * x) -> planed (zgaps (core_of ZA) (core_of ZB)) (IZR m * x) ->
    says_signed A B (Root_is (status_of_root square rho) square rho None None).
  Proof.
    intros square x Hd -> L M. destruct radii as (PA & PB & E). destruct (both_sides _ _ L M) as [C G].
    split; auto. split; auto. split; auto. split; auto. apply status_of_root_sound; auto.
  Qed.

  Theorem check_says : forall c, signed_check m ZA ZB c = true -> says_signed A B (signed_stated rho c).
  Proof.
    assert (Pm := IZR_pos _ Hm). destruct radii as (PA & PB & Er).
    assert (zg := zgaps_core m A B ZA ZB Hm EA EB).
    intros c H. unfold signed_check in H. apply andb_true_iff in H. destruct H as [_ H].
    destruct c as [qn qd complete dirs q|qn qd n unit WA WB all|qn qd n|ln ld hn hd n outer inside proof].
    - destruct (core_of ZA) as [LA| |] eqn:CA; try discriminate. destruct (core_of ZB) as [LB| |] eqn:CB; try discriminate.
      assert (Hqd : (0 < qd)%Z) by (unfold check_depth in H; bsplit; auto).
      destruct (deep_sound LA LB _ _ _ _ _ H) as (Ps & L & M & W). rewrite root_in_units in * by auto.
      assert (S := root_says (Ratio qn qd) _ Hqd eq_refl). unfold value at 2 in S. cbn [num den] in S. rewrite CA, CB in S. specialize
        (S L M).
      destruct S as (S1 & S2 & S3 & S4 & _). cbn [signed_stated says_signed].
      split; auto. split; auto. split; auto. split; auto. split; auto. destruct complete; auto.
      destruct (W eq_refl) as (W1 & W2 & W3). set (ns := map (fun n => inj (fst n)) dirs) in *.
      replace (count dirs) with (Z.of_nat (length ns)) by (unfold ns; rewrite map_length, count_length; auto).
      set (s := signed_root (value (Ratio qn qd))) in *. change (signed_root (IZR qn / IZR qd)) with s in *.
      assert (Ps' : 0 < s) by (apply Rmult_lt_reg_l with (IZR m); lra).
      assert (K : ways_number (thick (core_gaps A B) (value rho)) (s + value rho) (Z.of_nat (length ns))).
      { apply ways_of_planes; auto; [lra| |].
        - intros n In0. destruct (W1 n In0) as [Nz Hb]. split; auto. intros p Hp. apply zg, Hb in Hp. rewrite dot_scal_r in Hp.
          apply Rmult_le_reg_l with (IZR m); lra.
        - intros t Wt. apply (way_out_scal _ (zgaps (Points LA) (Points LB)) (IZR m)) in Wt; auto; try (intros p; apply zg).
          destruct (W3 _ Wt) as (n & In0 & E). exists n. split; auto. rewrite along_scal in E.
          rewrite <- (scal_inv' (IZR m) t), E, scal_inv' by lra. auto. }
      destruct K as (ts & K1 & K2 & K3). exists ts. split; auto. split; auto. intros t. rewrite <- K3.
      assert (iff : forall p, gaps A B p <-> thick (core_gaps A B) (value rho) p) by (intros; rewrite Er; apply gaps_thick; auto).
      split; apply way_out_iff; intros p; rewrite iff; tauto.
    - destruct (core_of ZA) as [LA| |] eqn:CA; try discriminate. destruct (core_of ZB) as [LB| |] eqn:CB; try discriminate.
      assert (Hqd : (0 < qd)%Z) by (unfold check_beside in H; bsplit; auto).
      destruct (beside_sound _ _ _ _ _ _ _ _ _ H) as (L & M & K).
      replace (- (qn * (m * m)))%Z with (- qn * (m * m))%Z in * by ring. rewrite root_in_units in * by auto.
      assert (S := root_says (Ratio (- qn) qd) _ Hqd eq_refl). unfold value at 2 in S. cbn [num den] in S. rewrite CA, CB in S.
        specialize (S L M).
      destruct S as (S1 & S2 & S3 & S4 & _). cbn [signed_stated says_signed].
      split; auto. split; auto. split; auto. split; auto. split; auto. destruct all as [k|]; auto.
      destruct (K k eq_refl) as (Z0 & C1 & C2 & C3 & C4 & C5).
      assert (piff : forall u, polar (zgaps (Points LA) (Points LB)) u <-> polar (core_gaps A B) u).
      { intros u. split; intros H' p Hp.
        - apply zg, H' in Hp. rewrite dot_scal_r in Hp. apply Rmult_le_reg_l with (IZR m); lra.
        - rewrite <- (scal_back (IZR m) p) by auto. rewrite dot_scal_r. rewrite <- (scal_back (IZR m) p) in Hp by auto. apply zg, H' in
          Hp. nra. }
      split.
      + exists (map inj (lineality k)), (map (fun r => inj (fst r)) (rays k)). rewrite !map_length, !count_length.
        split; auto. split; auto. split; [intros u; rewrite <- piff; auto|]. split; auto. split; auto. split; auto.
        intros r Ir Kr. apply (C4 r Ir), piff; auto.
      + intros Pr t. assert (Z1 : signed_root (value (Ratio (- qn) qd)) = 0).
        { apply Rmult_eq_reg_l with (IZR m); [|lra]. rewrite Rmult_0_r. exact Z0. }
        rewrite Z1 in S2. apply signed_depth_touch in S2.
        rewrite <- ways_out_touch; auto.
        * assert (iff : forall p, gaps A B p <-> thick (core_gaps A B) (value rho) p) by (intros; rewrite Er; apply gaps_thick; auto).
          split; apply way_out_iff; intros p; rewrite iff; tauto.
        * apply difference_of_convex; apply in_core_convex.
        * apply S2.
    - assert (Hqd : (0 < qd)%Z) by (unfold check_on_plane in H; bsplit; auto).
      destruct (on_plane_sound _ _ _ _ _ H) as [L M]. rewrite root_in_units in * by auto.
      apply (root_says (Ratio qn qd) _ Hqd eq_refl); auto.
    - destruct (between_sound _ _ _ _ _ _ _ _ _ _ _ _ Hm H) as (Hld & Hhd & Comp & L & M).
      assert (Pl := IZR_pos _ Hld). assert (Ph := IZR_pos _ Hhd). destruct radius_real as [EfA EfB].
      assert (shift : forall n d, 0 < IZR d -> IZR (n * m - (radius ZA + radius ZB) * d) / IZR d = IZR m * (IZR n / IZR d - value rho)).
      { intros n' d Pd. rewrite minus_IZR, !mult_IZR, plus_IZR, EfA, EfB, Er. field. lra. }
      rewrite shift in L, M by auto. destruct (both_sides _ _ L M) as [_ G].
      replace (IZR ln / IZR ld - value rho + value rho) with (IZR ln / IZR ld) in G by ring.
      replace (IZR hn / IZR hd - value rho + value rho) with (IZR hn / IZR hd) in G by ring.
      split; [|apply status_between_sound; auto].
      destruct (signed_depth_exists A B (comparable_back m A B ZA ZB EA EB Comp) PA PB) as (v & V). exists v. split; auto.
      apply (signed_depth_within (gaps A B)); auto.
  Qed.
End Verdict.

Theorem signed_verdict_sound : forall width m rho A B c s, signed_verdict width m rho A B c = Some s ->
  says_signed (real_body A) (real_body B) s.
Proof.
  intros width m rho A B c s H. unfold signed_verdict in H. cbv zeta in H.
  destruct (all_body _ _ A && all_body _ _ B && _ && _ && _ && signed_check _ _ _ _) eqn:E; [|discriminate].
  inversion H; subst. clear H. apply andb_true_iff in E. destruct E as [E C]. apply andb_true_iff in E. destruct E as [E _]. bsplit.
  rename H into FA, H2 into FB, H1 into Hr, H0 into Er.
  assert (K : (0 < m)%Z /\ (0 <= radius (in_units m A))%Z /\ (0 <= radius (in_units m B))%Z).
  { unfold signed_check in C. apply andb_true_iff in C. destruct C as [C _]. bsplit. auto. }
  destruct K as (Hm & HA & HB). apply (check_says m rho _ _ (in_units m A) (in_units m B)); auto; apply in_units_real; auto.
Qed.
