(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Format 3: each claim that passes its check is true of the pieces, in their units. *)
Require Import Reals Lra Psatz List ZArith Lia Bool.
From Fathom.checker Require Import vector sequence table support certificate cone signed unions.
From Fathom.geometry Require Import meaning unions space hulls flats norm difference minkowski solid seams.
From Fathom.soundness Require Import statement booleans upper optima signed_sides cone_sound union_cuts union_tree.
Import ListNotations.
Open Scope R_scope.

Notation real_union Ls := (map (map inj) Ls).

(* ---- each piece has an interior ---- *)
Lemma first_true : forall (T : Type) (f : T -> bool) l x, first f l = Some x -> f x = true.
Proof. induction l as [|y l IH]; simpl; intros x H; [discriminate|]. destruct (f y) eqn:E; [inversion H; subst; auto|auto]. Qed.

Lemma solid_sound : forall L, solid L = true -> exists p, interior (conv (map inj L)) p.
Proof.
  intros L H. apply spanning_interior. unfold solid in H. destruct L as [|a L']; [discriminate|]. set (L := a :: L') in *.
  destruct (first _ L) as [b|] eqn:Eb in H; [|discriminate]. apply first_in in Eb.
  destruct (first _ L) as [c|] eqn:Ec in H; [|discriminate]. apply first_in in Ec. bsplit. rename x into d.
  apply negb_true_iff, Z.eqb_neq in H0. exists (inj a), (inj b), (inj c), (inj d).
  repeat split; try (apply in_map; auto); [simpl; auto|]. intros E. apply H0, eq_IZR. rewrite det_inj, !inj_sub. exact E.
Qed.

Lemma all_solid_sound : forall Ls, all_solid Ls = true -> solid_pieces (real_union Ls).
Proof.
  intros Ls H. destruct Ls as [|L Ls]; [discriminate|]. split; [discriminate|]. intros K HK. apply in_map_iff in HK.
  destruct HK as (K' & <- & HK). apply solid_sound. exact (forallb_In _ _ _ H K' HK).
Qed.

(* ---- separations ---- *)
Lemma row_sound : forall test A Bs us us', row test A Bs us = Some us' -> forall B, In B Bs -> exists u, test A B u = true.
Proof.
  induction Bs as [|B Bs IH]; intros us us' H K HK; [destruct HK|]. cbn [row] in H. destruct us as [|u us]; [discriminate|].
  destruct (test A B u) eqn:E; [|discriminate]. destruct HK as [<-|HK]; [exists u; auto|exact (IH _ _ H K HK)].
Qed.
Lemma all_pairs_sound : forall test As Bs us, all_pairs test As Bs us = true ->
  forall A B, In A As -> In B Bs -> exists u, test A B u = true.
Proof.
  induction As as [|A As IH]; intros Bs us H K B HK HB; [destruct HK|]. cbn [all_pairs] in H.
  destruct (row test A Bs us) as [us'|] eqn:E; [|discriminate].
  destruct HK as [<-|HK]; [exact (row_sound _ _ _ _ _ E B HB)|exact (IH _ _ H K B HK HB)].
Qed.

Section Integers.
  Variables As Bs : list (list zvec).
  Hypothesis HA : solid_pieces (real_union As).
  Hypothesis HB : solid_pieces (real_union Bs).

  Lemma overlapping_overlap : forall t, overlapping As Bs t <-> overlap_at (real_union As) (real_union Bs) t.
  Proof.
    intros t. rewrite overlap_pairs by auto. split.
    - intros (A & B & IA & IB & I). exists (map inj A), (map inj B). split; [apply in_map; auto|]. split; [apply in_map; auto|auto].
    - intros (A & B & IA & IB & I). apply in_map_iff in IA, IB. destruct IA as (A' & <- & IA). destruct IB as (B' & <- & IB).
      exists A', B'. auto.
  Qed.

  Lemma keeps_out_sound : forall unit v us, (0 < unit)%Z -> all_pairs (keeps_out unit v) As Bs us = true ->
    ~ overlap_at (real_union As) (real_union Bs) (scal (/ IZR unit) (inj v)).
  Proof.
    intros unit v us Hu H. rewrite <- overlapping_overlap. intros (A & B & IA & IB & I).
    destruct (all_pairs_sound _ _ _ _ H A B IA IB) as (u & U). unfold keeps_out in U. bsplit. apply negb_true_iff in H0.
    apply height_is_sound in H1. destruct H1 as (h & T & Hh). bsplit. apply IZR_le in T. rewrite mult_IZR, dot_inj in T.
    assert (Pu : 0 < IZR unit) by (apply IZR_lt; auto). revert I. apply (beyond_not_interior _ _ (inj u) (IZR h)); auto.
    - rewrite inj_zero, <- is_zero_spec, H0. discriminate.
    - rewrite dot_scal_r. apply Rmult_le_reg_l with (IZR unit); auto. rewrite <- Rmult_assoc, Rinv_r, Rmult_1_l by lra. lra.
  Qed.

  Lemma deep_pieces_sound : forall qn qd unit optima at_ polytopes tree multipliers,
    check_union_deep As Bs qn qd unit optima at_ polytopes tree multipliers = true ->
    let q := IZR qn / IZR qd in
    let ts := map (fun o => scal (/ IZR unit) (inj (fst o))) optima in
    (0 < unit)%Z
    /\ union_depth2_is (real_union As) (real_union Bs) q
    /\ NoDup ts
    /\ forall t, shortest_way_out (real_union As) (real_union Bs) q t <-> In t ts.
  Proof.
    intros qn qd unit optima at_ polytopes tree multipliers H q ts. unfold check_union_deep in H. cbv zeta in H. bsplit.
    rename H into Hqn, H4 into Hqd, H3 into Hu, H2 into Hasc, H1 into Hout, H0 into Hin.
    assert (Rd : 0 < IZR qd) by (apply IZR_lt; auto). assert (Ru : 0 < IZR unit) by (apply IZR_lt; auto).
    rewrite each_map in Hin. destruct (cuts_of _ _ _ polytopes []) as [cuts|] eqn:EC; [|discriminate].
    assert (HC : forall c, In c cuts -> cuts_space As Bs qn qd unit (map fst optima) at_ c).
    { apply (cuts_of_sound As Bs qn qd unit _ at_ _ _ _ EC). intros c []. }
    assert (W := walk_sound As Bs qn qd unit _ at_ Hqd Hu cuts multipliers HC tree _ Hin all_of_space (or_introl eq_refl)).
    assert (In1 : forall t, norm2 t <= q -> overlap_at (real_union As) (real_union Bs) t \/ norm2 t = q /\ In t ts).
    { intros t Ht. destruct (W t Ht (inside_space t)) as [O|(E & v & Iv & Ev)]; [left; apply overlapping_overlap; auto|].
      right. split; auto. apply in_map_iff in Iv. destruct Iv as (o & <- & Io). apply in_map_iff. exists o. auto. }
    assert (Out : forall t, In t ts -> shortest_way_out (real_union As) (real_union Bs) q t).
    { intros t It. apply in_map_iff in It. destruct It as ([v us] & <- & Io). assert (K := forallb_In _ _ _ Hout _ Io). cbn [fst snd] in *.
      bsplit. apply (f_equal IZR) in H. rewrite !mult_IZR, norm2_inj in H. split; [|apply (keeps_out_sound _ _ us); auto].
      rewrite norm2_scal. unfold q. apply Rmult_eq_reg_r with (IZR unit * IZR unit * IZR qd); [|apply Rgt_not_eq; repeat apply
        Rmult_lt_0_compat; auto].
      replace (/ IZR unit * / IZR unit * norm2 (inj v) * (IZR unit * IZR unit * IZR qd)) with (norm2 (inj v) * IZR qd) by (field; lra).
      rewrite H. field. lra. }
    split; auto. split; [|split].
    - split; [apply Rdiv_lt_0_compat; auto; apply IZR_lt; auto|]. split.
      + intros t Ht. destruct (In1 t) as [O|[E _]]; auto; lra.
      + destruct optima as [|o os]; [discriminate|]. exists (scal (/ IZR unit) (inj (fst o))). apply Out. simpl. auto.
    - destruct optima as [|o os]; [discriminate|]. apply ascending_nodup in Hasc. destruct Hasc as [N _].
      unfold ts. rewrite <- (map_map fst (fun v => scal (/ IZR unit) (inj v))). apply FinFun.Injective_map_NoDup; auto.
      intros u v E. apply inj_injective. apply (f_equal (scal (IZR unit))) in E. rewrite !scal_scal, Rinv_r, !scal_1 in E by lra. auto.
    - intros t. split; auto. intros [E N]. destruct (In1 t) as [O|[_ I]]; auto; [lra|contradiction].
  Qed.

  (* points of two pieces whose difference passes the test *)
  Lemma near_is_sound : forall test p, near_is test As Bs p = true ->
    exists z a b, test (weight_unit p) z = true /\ (0 < weight_unit p)%Z /\ union (real_union As) a /\ union (real_union Bs) b
      /\ sub b a = scal (/ IZR (weight_unit p)) (inj z).
  Proof.
    intros test p H. unfold near_is in H.
    destruct (member (numbered As) (near_a p)) as [A|] eqn:EA; [|discriminate].
    destruct (member (numbered Bs) (near_b p)) as [B|] eqn:EB; [|discriminate]. apply member_in in EA, EB. unfold mean_is in H.
    destruct (weighed (numbered A) _) as [[s x]|] eqn:WA; [|discriminate].
    destruct (weighed (numbered B) _) as [[t y]|] eqn:WB; [|discriminate]. bsplit. subst s t.
    apply weighed_sound in WA, WB; auto. set (w := IZR (weight_unit p)) in *.
    exists (zsub y x), (scal (/ w) (inj x)), (scal (/ w) (inj y)). split; auto. split; auto.
    split; [exists (map inj A); split; auto; apply in_map; auto|]. split; [exists (map inj B); split; auto; apply in_map; auto|].
    rewrite inj_sub. pteq; ring.
  Qed.

  Lemma touching_pieces_sound : forall us p, all_pairs (keeps_out 1 zzero) As Bs us = true -> near_is (fun _ => is_zero) As Bs p = true ->
    unions_touch (real_union As) (real_union Bs).
  Proof.
    intros us p Hs Hp. split.
    - apply near_is_sound in Hp. destruct Hp as (z & a & b & T & _ & Ha & Hb & E). apply is_zero_spec in T. subst z.
      exists a. split; auto. replace a with b; auto. apply sub_zero. rewrite E, norm2_scal. unfold norm2, dot; simpl. ring.
    - apply keeps_out_sound in Hs; [|lia]. replace (scal (/ 1) (inj zzero)) with origin in Hs by (pteq; ring). auto.
  Qed.

  Lemma apart_pieces_sound : forall qn qd us p, (0 < qn)%Z -> (0 < qd)%Z -> all_pairs (keeps_apart qn qd) As Bs us = true ->
    near_is (fun unit z => zdot z z * qd =? qn * (unit * unit))%Z As Bs p = true ->
    unions_distance2_is (real_union As) (real_union Bs) (IZR qn / IZR qd).
  Proof.
    intros qn qd us p Hqn Hqd Hs Hp. assert (Rd : 0 < IZR qd) by (apply IZR_lt; auto). assert (Rn : 0 < IZR qn) by (apply IZR_lt; auto).
    assert (Pq : 0 < IZR qn / IZR qd) by (apply Rdiv_lt_0_compat; auto).
    split; auto. split.
    - intros a b (A & IA & Ha) (B & IB & Hb). apply in_map_iff in IA, IB. destruct IA as (A' & <- & IA). destruct IB as (B' & <- & IB).
      destruct (all_pairs_sound _ _ _ _ Hs A' B' IA IB) as (u & U). unfold keeps_apart in U. bsplit.
      apply height_is_sound in H0. destruct H0 as (h & T & Hh & _). bsplit.
      assert (D : dot (inj u) (sub b a) <= IZR h). { apply Hh. apply P_minkowski. exists a, b. auto. }
      apply negb_true_iff in H. assert (Hu : inj u <> origin) by (rewrite inj_zero, <- is_zero_spec, H; discriminate).
      assert (N := norm2_pos _ Hu). apply IZR_le in T. rewrite !mult_IZR, opp_IZR, norm2_inj, IZR_signed_square in T.
      assert (Neg : IZR h < 0).
      { apply Rnot_le_lt. intros L. rewrite signed_sqr_pos in T by auto.
        assert (0 < IZR qn * norm2 (inj u)) by (apply Rmult_lt_0_compat; auto).
        assert (0 <= IZR h * IZR h * IZR qd) by (apply Rmult_le_pos; [nra|lra]). lra. }
      rewrite signed_sqr_neg in T by lra. assert (C := cauchy (inj u) (sub b a)).
      assert (K : IZR h * IZR h <= norm2 (inj u) * norm2 (sub b a)) by nra.
      apply Rmult_le_reg_r with (norm2 (inj u) * IZR qd); [apply Rmult_lt_0_compat; auto|].
      replace (IZR qn / IZR qd * (norm2 (inj u) * IZR qd)) with (IZR qn * norm2 (inj u)) by (field; lra). nra.
    - apply near_is_sound in Hp. destruct Hp as (z & a & b & T & Hw & Ha & Hb & E). exists a, b. split; auto. split; auto.
      apply Z.eqb_eq, (f_equal IZR) in T. rewrite !mult_IZR, norm2_inj in T. assert (Rw : 0 < IZR (weight_unit p)) by (apply IZR_lt; auto).
      rewrite E, norm2_scal. set (w := IZR (weight_unit p)) in *.
      apply Rmult_eq_reg_r with (w * w * IZR qd); [|apply Rgt_not_eq; repeat apply Rmult_lt_0_compat; auto].
      replace (/ w * / w * norm2 (inj z) * (w * w * IZR qd)) with (norm2 (inj z) * IZR qd) by (field; lra). rewrite T. field. lra.
  Qed.
End Integers.
