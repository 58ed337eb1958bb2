(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* THE THEOREM about the line of a certificate of format 2: what it says is true of the bodies in the file. *)
Require Import Reals Lra Psatz List ZArith Lia Bool.
From Fathom.checker Require Import vector sequence table polytope support certificate verdict body cone signed signed_verdict.
From Fathom.geometry Require Import meaning bodies space norm hulls difference scaling signed_depth rounded ways_out
  curved units gaps said.
From Fathom.soundness Require Import statement booleans verdict_sound signed_sides signed_units signed_claims
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
  Proof. split; [apply (f_equal (@radius _ _)) in EA; exact EA|apply (f_equal (@radius _ _)) in EB; exact EB]. Qed.
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

  Lemma root_says : forall square x optima cone, (0 < den square)%Z -> x = signed_root (value square) ->
    at_least (zgaps (core_of ZA) (core_of ZB)) (IZR m * x) -> planed (zgaps (core_of ZA) (core_of ZB)) (IZR m * x) ->
    (forall k, optima = Some k -> exits (interior (gaps A B)) ((x + value rho) * (x + value rho)) k) ->
    (signed_depth (core_gaps A B) x -> forall k l, cone = Some (k, l) -> cone_is (polar (core_gaps A B)) k l
      /\ (0 < value rho -> forall t, norm2 t = value rho * value rho -> (~ interior (gaps A B) t <-> polar (core_gaps A
        B) t))) ->
    says_signed A B (Root_is (status_of_root square rho) square rho optima cone).
  Proof.
    intros square x optima cone Hd -> L M O K. destruct radii as (PA & PB & E). destruct (both_sides _ _ L M) as [C G].
    exists (signed_root (value square)), (value rho). split; [apply signed_sqr_root|]. split; [apply signed_depth_said;
      exact C|].
    split; auto. split; auto. split; [apply signed_depth_said; exact G|]. split; auto. apply status_of_root_sound; auto.
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
      cbn [signed_stated]. apply (root_says (Ratio qn qd) (signed_root (IZR qn / IZR qd))); auto; try (rewrite CA, CB;
        auto); try discriminate.
      intros k Ek. destruct complete; [|discriminate]. inversion Ek. subst k. clear Ek.
      destruct (W eq_refl) as (W1 & W2 & W3). set (ns := map (fun n => inj (fst n)) dirs) in *.
      replace (count dirs) with (Z.of_nat (length ns)) by (unfold ns; rewrite map_length, count_length; auto).
      set (s := signed_root (value (Ratio qn qd))) in *. change (signed_root (IZR qn / IZR qd)) with s in *.
      assert (Ps' : 0 < s) by (apply Rmult_lt_reg_l with (IZR m); lra).
      assert (K : exits (interior (thick (core_gaps A B) (value rho))) ((s + value rho) * (s + value rho)) (Z.of_nat
        (length ns))).
      { apply ways_of_planes; auto; [lra| |].
        - intros n In0. destruct (W1 n In0) as [Nz Hb]. split; auto. intros p Hp. apply zg, Hb in Hp. rewrite dot_scal_r in Hp.
          apply Rmult_le_reg_l with (IZR m); lra.
        - intros t Wt. apply (way_out_scal _ (zgaps (Points LA) (Points LB)) (IZR m)) in Wt; auto; try (intros p; apply zg).
          destruct (W3 _ Wt) as (n & In0 & E). exists n. split; auto. rewrite along_scal in E.
          rewrite <- (scal_inv' (IZR m) t), E, scal_inv' by lra. auto. }
      apply (exits_same (interior (thick (core_gaps A B) (value rho)))); auto. intros t. apply interior_iff. intros p.
        rewrite Er.
      symmetry. apply gaps_thick; auto.
    - destruct (core_of ZA) as [LA| |] eqn:CA; try discriminate. destruct (core_of ZB) as [LB| |] eqn:CB; try discriminate.
      assert (Hqd : (0 < qd)%Z) by (unfold check_beside in H; bsplit; auto).
      destruct (beside_sound _ _ _ _ _ _ _ _ _ H) as (L & M & K).
      replace (- (qn * (m * m)))%Z with (- qn * (m * m))%Z in * by ring. rewrite root_in_units in * by auto.
      cbn [signed_stated]. apply (root_says (Ratio (- qn) qd) (signed_root (IZR (- qn) / IZR qd))); auto;
        try (rewrite CA, CB; auto); try discriminate.
      intros S2 k0 l0 Ek. destruct all as [k|]; [|discriminate]. inversion Ek. subst k0 l0. clear Ek.
      destruct (K k eq_refl) as (Z0 & C1 & C2 & C3 & C4 & C5).
      assert (piff : forall u, polar (zgaps (Points LA) (Points LB)) u <-> polar (core_gaps A B) u).
      { intros u. split; intros H' p Hp.
        - apply zg, H' in Hp. rewrite dot_scal_r in Hp. apply Rmult_le_reg_l with (IZR m); lra.
        - rewrite <- (scal_back (IZR m) p) by auto. rewrite dot_scal_r. rewrite <- (scal_back (IZR m) p) in Hp by auto. apply zg, H' in
          Hp. nra. }
      split.
      + replace (count (lineality k)) with (Z.of_nat (length (map inj (lineality k)))) by (rewrite map_length,
          count_length; auto).
        replace (count (rays k)) with (Z.of_nat (length (map (fun r => inj (fst r)) (rays k)))) by (rewrite map_length,
          count_length; auto).
        apply cone_said.
        split; [intros u; rewrite <- piff; auto|]. split; auto. split; auto. split; auto.
        intros r Ir Kr. apply (C4 r Ir), piff; auto.
      + intros Pr t Nt. assert (Z1 : signed_root (IZR (- qn) / IZR qd) = 0).
        { apply Rmult_eq_reg_l with (IZR m); [|lra]. rewrite Rmult_0_r. exact Z0. }
        rewrite Z1 in S2. apply signed_depth_touch in S2.
        assert (W := ways_out_touch (core_gaps A B) (value rho) t). unfold way_out in W.
        assert (iff : interior (gaps A B) t <-> interior (thick (core_gaps A B) (value rho)) t)
          by (apply interior_iff; intros; rewrite Er; apply gaps_thick; auto).
        rewrite iff. assert (W' := W Pr (difference_of_convex _ _ (in_core_convex _) (in_core_convex _)) (proj1 S2)).
          tauto.
    - assert (Hqd : (0 < qd)%Z) by (unfold check_on_plane in H; bsplit; auto).
      destruct (on_plane_sound _ _ _ _ _ H) as [L M]. rewrite root_in_units in * by auto.
      apply (root_says (Ratio qn qd) (signed_root (IZR qn / IZR qd))); auto; discriminate.
    - destruct (between_sound _ _ _ _ _ _ _ _ _ _ _ _ Hm H) as (Hld & Hhd & Comp & L & M).
      assert (Pl := IZR_pos _ Hld). assert (Ph := IZR_pos _ Hhd). destruct radius_real as [EfA EfB].
      assert (shift : forall n d, 0 < IZR d -> IZR (n * m - (radius ZA + radius ZB) * d) / IZR d = IZR m * (IZR n / IZR d - value rho)).
      { intros n' d Pd. rewrite minus_IZR, !mult_IZR, plus_IZR, EfA, EfB, Er. field. lra. }
      rewrite shift in L, M by auto. destruct (both_sides _ _ L M) as [_ G].
      replace (IZR ln / IZR ld - value rho + value rho) with (IZR ln / IZR ld) in G by ring.
      replace (IZR hn / IZR hd - value rho + value rho) with (IZR hn / IZR hd) in G by ring.
      destruct (signed_depth_exists A B (comparable_back m A B ZA ZB EA EB Comp) PA PB) as (v & V). exists v.
      assert (Bv := signed_depth_within (gaps A B) _ _ v G V). split; [apply signed_depth_said; auto|]. split; auto.
      apply status_between_sound; auto.
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

(* ---- the width ---- *)
Lemma same_atoms_eq : forall t u, same_atoms t u = true -> t = u.
Proof.
  induction t as [|a t IH]; intros [|b u] H; try discriminate; auto. simpl in H. destruct (_ && _ && _ && _) eqn:E;
    [|discriminate].
  bsplit. destruct a, b. cbn [printed.center printed.axis_u printed.axis_v printed.axis_w] in *.
  repeat match goal with K : same_vector _ _ = true |- _ => apply same_vector_spec in K end. subst. f_equal. auto.
Qed.
Lemma same_terms_eq : forall ts us, same_terms ts us = true -> ts = us.
Proof.
  induction ts as [|t ts IH]; intros [|u us] H; try discriminate; auto. simpl in H. destruct (same_atoms t u) eqn:E;
    [|discriminate].
  apply same_atoms_eq in E. f_equal; auto.
Qed.
Lemma same_body_eq : forall A B, same_body A B = true -> A = B.
Proof.
  intros [a r] [b s] H. unfold same_body in H. cbn [core_of radius] in H. apply andb_true_iff in H. destruct H as [R C].
  apply Z.eqb_eq in R. f_equal; auto. destruct a, b; try discriminate; f_equal;
    [apply same_vectors_eq|apply same_terms_eq]; auto.
Qed.

Lemma bounded_or_empty : forall c, (forall n d, c <> Half_space n d) -> bounded_core c \/ forall p, ~ in_core c p.
Proof.
  assert (None : forall S p, (forall s : pt, ~ S s) -> ~ hull S p).
  { intros S p N Hp. apply (Hp (fun _ => False)); [intros u v l _ []|exact N]. }
  intros [L|ts|n d] H; [| |destruct (H n d); auto].
  - destruct L; [right|left; discriminate]. intros p. apply None. intros s [].
  - simpl. induction ts as [|t ts IH]; [left; constructor|]. destruct t as [|a t].
    + right. intros p (x & y & Hx & _). revert Hx. apply None. intros s (b & [] & _).
    + destruct IH as [IH|IH]; [discriminate|left; constructor; auto; discriminate|]. right.
        intros p (x & y & _ & Hy & _).
      exact (IH y Hy).
Qed.

(* with --width: of bodies, round and curved ones too *)
Theorem signed_verdict_width : forall m rho A B c s, signed_verdict true m rho A B c = Some s ->
  says_signed (real_body A) (real_body A) s /\ says_width (in_body (real_body A)).
Proof.
  intros m rho A B c s H. assert (S := signed_verdict_sound _ _ _ _ _ _ _ H). unfold signed_verdict in H. cbv zeta in H.
  destruct (_ && signed_check _ _ _ _) eqn:E; [|discriminate]. clear H. apply andb_true_iff in E. destruct E as [E C].
  apply andb_true_iff in E. destruct E as [E W]. bsplit. cbn [negb orb] in W. rename H into FA, H2 into FB.
  unfold signed_check in C. apply andb_true_iff in C. destruct C as [C _]. bsplit. rename H into Hm, H3 into RA.
  assert (Pm := IZR_pos _ Hm). assert (EA := in_units_real m A Hm FA). assert (EB := in_units_real m B Hm FB).
  assert (Kind : forall n d, core_of (real_body A) <> Half_space n d).
  { intros n d. destruct A as [[L|ts|o k] r]; try discriminate. unfold same_body in W. apply andb_true_iff in W.
      destruct W as [_ W].
    discriminate. }
  apply same_body_eq in W. rewrite <- W, EA in EB. apply (f_equal (scale_body (/ IZR m))) in EB.
    rewrite !scale_back in EB by auto.
  rewrite <- EB in S. split; auto. apply body_width; [apply bounded_or_empty; auto|].
  apply (f_equal (@radius _ _)) in EA. change (IZR (radius (in_units m A)) = IZR m * radius (real_body A)) in EA.
    apply IZR_le in RA.
  rewrite EA in RA. nra.
Qed.
