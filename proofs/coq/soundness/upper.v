(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The upper side: the computed height is P's support function; touching and disjoint follow from its sign. *)
Require Import Reals Lra Psatz List ZArith Lia Bool.
From Fathom.checker Require Import vector table support.
From Fathom.geometry Require Import meaning space hulls difference kinds minkowski.
From Fathom.soundness Require Import statement booleans.
Import ListNotations.
Open Scope Z_scope.

Lemma greatest_spec : forall n l m, greatest n l = Some m ->
  (exists v, In v l /\ zdot n v = m) /\ forall v, In v l -> zdot n v <= m.
Proof.
  intros n [|p l] m H; [discriminate|]. simpl in H. inversion H as [E]. clear H.
  assert (G : forall l a, let m := fold_left (fun m v => Z.max m (zdot n v)) l a in
    (m = a \/ exists v, In v l /\ zdot n v = m) /\ a <= m /\ forall v, In v l -> zdot n v <= m).
  { induction l0 as [|b l0 IH]; simpl; intros a.
    - split; auto. split; [lia|tauto].
    - destruct (IH (Z.max a (zdot n b))) as (I1 & I2 & I3). split; [|split; [lia|]].
      + destruct I1 as [I1|(v & Iv & Ev)]; [|right; eauto]. rewrite I1.
        destruct (Z.max_spec a (zdot n b)) as [[_ M]|[_ M]]; rewrite M; eauto.
      + intros v [<-|Hv]; auto. lia. }
  specialize (G l (zdot n p)). simpl in G. destruct G as (G1 & G2 & G3). split.
  - destruct G1 as [G1|(v & Iv & Ev)]; [exists p|exists v]; simpl; auto.
  - intros v [<-|Hv]; auto.
Qed.

Section Upper.
  Variables A B : list zvec.
  Let RA := map inj A.
  Let RB := map inj B.

  Lemma height_sound : forall n h, height A B n = Some h -> height_is RA RB (inj n) (IZR h).
  Proof.
    intros n h H. unfold height in H.
    destruct (greatest n B) as [x|] eqn:EB; [|discriminate].
    destruct (greatest (zneg n) A) as [y|] eqn:EA; [|discriminate].
    inversion H as [E]. clear H. apply greatest_spec in EB. apply greatest_spec in EA.
    destruct EB as ((b & Ib & Eb) & Mb). destruct EA as ((a & Ia & Ea) & Ma).
    assert (N : forall v, dot (scal (-1) (inj n)) (inj v) = IZR (zdot (zneg n) v)).
    { intros v. rewrite dot_inj. f_equal. unfold zneg. pteq; rewrite opp_IZR; ring. }
    replace (IZR (x + y)) with (dot (inj n) (sub (inj b) (inj a))).
    - apply extreme_height.
      + split; [apply in_map; auto|]. intros q Iq. apply in_map_iff in Iq. destruct Iq as (v & <- & Iv).
        rewrite !N. apply IZR_le. rewrite Ea. auto.
      + split; [apply in_map; auto|]. intros q Iq. apply in_map_iff in Iq. destruct Iq as (v & <- & Iv).
        rewrite <- !dot_inj. apply IZR_le. rewrite Eb. auto.
    - rewrite <- inj_sub, <- dot_inj. f_equal. rewrite <- Eb, <- Ea. unfold zdot, zneg, zsub; simpl. ring.
  Qed.

  Lemma height_is_sound : forall test n, support.height_is test A B n = true ->
    exists h, test h = true /\ height_is RA RB (inj n) (IZR h).
  Proof.
    intros test n H. unfold support.height_is in H. destruct (height A B n) as [h|] eqn:E; [|discriminate].
    exists h. split; auto. apply height_sound. auto.
  Qed.

  Open Scope R_scope.

  Lemma nonzero_by_height : forall n h, height_is RA RB n h -> 0 < h -> n <> origin.
  Proof.
    intros n h (_ & p & _ & E) Hh ->. replace (dot origin p) with 0 in E by (unfold dot, origin; simpl; ring). lra.
  Qed.

  Lemma tangent_sound : forall qn qd n, (0 < qd)%Z -> tangent A B qn qd n = true ->
    exists h, height_is RA RB (inj n) h /\ 0 < h /\ inj n <> origin /\ h * h = IZR qn / IZR qd * norm2 (inj n).
  Proof.
    intros qn qd n Hqd H. apply height_is_sound in H. destruct H as (h & T & Hh). bsplit.
    assert (Rqd : 0 < IZR qd) by (apply IZR_lt; auto). assert (Rh : 0 < IZR h) by (apply IZR_lt; auto).
    exists (IZR h). repeat split; auto; try apply Hh. { apply (nonzero_by_height _ (IZR h)); auto. }
    apply Rmult_eq_reg_r with (IZR qd); [|lra].
    replace (IZR qn / IZR qd * norm2 (inj n) * IZR qd) with (IZR qn * norm2 (inj n)) by (field; lra).
    rewrite <- norm2_inj, <- !mult_IZR. f_equal. auto.
  Qed.

  Lemma within_sound : forall qn qd n, (0 < qd)%Z -> within A B qn qd n = true ->
    exists h, height_is RA RB (inj n) h /\ 0 < h /\ inj n <> origin /\ h * h <= IZR qn / IZR qd * norm2 (inj n).
  Proof.
    intros qn qd n Hqd H. apply height_is_sound in H. destruct H as (h & T & Hh). bsplit.
    assert (Rqd : 0 < IZR qd) by (apply IZR_lt; auto). assert (Rh : 0 < IZR h) by (apply IZR_lt; auto).
    exists (IZR h). repeat split; auto; try apply Hh. { apply (nonzero_by_height _ (IZR h)); auto. }
    apply Rmult_le_reg_r with (IZR qd); auto.
    replace (IZR qn / IZR qd * norm2 (inj n) * IZR qd) with (IZR qn * norm2 (inj n)) by (field; lra).
    rewrite <- norm2_inj, <- !mult_IZR. apply IZR_le. auto.
  Qed.

  (* a weighted mean is a point of the hull *)
  Lemma weighed_sound : forall (L : list zvec) W s x, weighed (numbered L) W = Some (s, x) -> (0 < s)%Z ->
    conv (map inj L) (scal (/ IZR s) (inj x)).
  Proof.
    intros L W s x. unfold weighed.
    set (f := fun (acc : option (Z * zvec)) (iw : N * Z) => match acc, member (numbered L) (fst iw) with
      | Some (s, x), Some p => if (0 <? snd iw)%Z then Some (s + snd iw, zadd x (zscal (snd iw) p))%Z else None
      | _, _ => None end).
    set (good := fun sx : Z * zvec => (fst sx = 0%Z /\ snd sx = zzero) \/
      ((0 < fst sx)%Z /\ conv (map inj L) (scal (/ IZR (fst sx)) (inj (snd sx))))).
    assert (none : forall W, fold_left f W None = None) by (induction W0; simpl; auto).
    assert (G : forall W sx ty, good sx -> fold_left f W (Some sx) = Some ty -> good ty).
    { induction W0 as [|(i, w) W0 IH]; simpl; intros (s0, x0) ty G H; [inversion H; subst; auto|].
      destruct (member (numbered L) i) as [p|] eqn:E; [|rewrite none in H; discriminate].
      destruct (0 <? w)%Z eqn:Ew; [|rewrite none in H; discriminate].
      apply Z.ltb_lt in Ew. apply member_in in E.
      assert (Hp : conv (map inj L) (inj p)) by (apply hull_in, in_map; auto).
      assert (Rw : 0 < IZR w) by (apply IZR_lt; auto).
      apply (IH _ _) in H; auto. right. unfold good in G. cbn [fst snd] in *. destruct G as [[-> ->]|[Hs Hx]].
      - split; [lia|]. replace (scal _ _) with (inj p); auto.
        rewrite inj_add, inj_scal. pteq; field; lra.
      - split; [lia|]. assert (Rs : 0 < IZR s0) by (apply IZR_lt; auto). rewrite inj_add, inj_scal, plus_IZR.
        apply (hull_seg _ (scal (/ IZR s0) (inj x0)) (inj p) _ (IZR s0) (IZR w)); auto; try lra; simpl; field; lra. }
    intros H Hs. apply (G _ (0%Z, zzero)) in H; [|left; auto].
    destruct H as [[E _]|[_ H]]; auto. simpl in E. lia.
  Qed.

  Lemma common_point_sound : forall unit WA WB, common_point A B unit WA WB = true -> P RA RB origin.
  Proof.
    intros unit WA WB H. unfold common_point in H.
    destruct (weighed (numbered A) WA) as [[s x]|] eqn:EA; [|discriminate].
    destruct (weighed (numbered B) WB) as [[t y]|] eqn:EB; [|discriminate].
    bsplit. subst s t. apply same_vector_spec in H0. subst y.
    apply weighed_sound in EA; auto. apply weighed_sound in EB; auto.
    apply meet_iff. exists (scal (/ IZR unit) (inj x)). auto.
  Qed.

  Lemma touching_sound : forall n unit WA WB,
    is_zero n = false -> support.height_is (fun h => h =? 0)%Z A B n = true -> common_point A B unit WA WB = true ->
    touching RA RB.
  Proof.
    intros n unit WA WB Hz Hh Hc. split; [apply (common_point_sound unit WA WB); auto|].
    apply height_is_sound in Hh. destruct Hh as (h & T & Hh). bsplit. subst h.
    apply (beyond_not_interior RA RB (inj n) 0); auto.
    - rewrite inj_zero, <- is_zero_spec, Hz. discriminate.
    - unfold dot, origin; simpl. lra.
  Qed.

  Lemma disjoint_sound : forall n, support.height_is (fun h => h <? 0)%Z A B n = true -> disjoint RA RB.
  Proof.
    intros n H. apply height_is_sound in H. destruct H as (h & T & Hh & _). bsplit. apply IZR_lt in T.
    intros HO. specialize (Hh origin HO). replace (dot (inj n) origin) with 0 in Hh by (unfold dot, origin; simpl; ring). lra.
  Qed.
End Upper.
