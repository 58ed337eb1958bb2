(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The set K of all u with <d,u> <= 0 for every d of a set, in two cases: what vectors and rays generate lies in K; at most two rays
   generate it, if for each there is a d below it and level with the rest, and if all of K lies in their span. *)
Require Import Reals Lra Psatz List Lia.
From Fathom.geometry Require Import meaning bodies space norm hulls faces farkas flats facets spans.
Import ListNotations.
Open Scope R_scope.

Section Cone.
  Variables (K : pt -> Prop) (ls rs ds : list pt).
  Hypothesis K_add : forall u v, K u -> K v -> K (add u v).
  Hypothesis K_scal : forall k u, 0 <= k -> K u -> K (scal k u).
  Hypothesis K_origin : K origin.
  Hypothesis Hd : forall d u, In d ds -> K u -> dot d u <= 0.
  Hypothesis Hl : forall l, In l ls -> K l /\ K (scal (-1) l).
  Hypothesis Hr : forall r, In r rs -> K r.

  Lemma in_K : forall u, spanned ls rs u -> K u.
  Proof.
    intros u (ks & cs & Lk & Lc & N & ->). apply K_add.
    - clear Lc N. assert (G : forall vs ks, (forall v, In v vs -> K v /\ K (scal (-1) v)) -> K (combination ks vs)).
      { clear -K_add K_scal K_origin. induction vs as [|v vs IH]; intros [|k ks] H; simpl; auto. apply K_add; [|apply IH; intros; apply
        H; simpl; auto].
        destruct (H v) as [H1 H2]; [simpl; auto|]. destruct (Rle_dec 0 k) as [P0|P0]; auto.
        replace (scal k v) with (scal (- k) (scal (-1) v)) by (pteq; ring). apply K_scal; auto. lra. }
      apply G. auto.
    - assert (G : forall vs cs, (forall v, In v vs -> K v) -> (forall c, In c cs -> 0 <= c) -> K (combination cs vs)).
      { clear -K_add K_scal K_origin. induction vs as [|v vs IH]; intros [|k ks] H N; simpl; auto.
        apply K_add; [apply K_scal; [apply N|apply H]; simpl; auto|apply IH; intros; [apply H|apply N]; simpl; auto]. }
      apply G; auto.
  Qed.

  Lemma level_lineality : forall d l, In d ds -> In l ls -> dot d l = 0.
  Proof.
    intros d l Id Il. destruct (Hl l Il) as [H1 H2]. apply (Hd d) in H1, H2; auto. rewrite dot_scal_r in H2. lra.
  Qed.

  Lemma not_opposite : forall d r, In d ds -> dot d r < 0 -> ~ K (scal (-1) r).
  Proof. intros d r Id L H. apply (Hd d) in H; auto. rewrite dot_scal_r in H. lra. Qed.

  (* ---- at most two rays ---- *)
  Section Few.
    (* below each ray there is a d that is level with the others *)
    Hypothesis below_ray : forall xs r ys, rs = xs ++ r :: ys -> exists d, In d ds /\ dot d r < 0 /\ forall o, In o (xs ++ ys) -> dot d
      o = 0.
    Hypothesis span : forall u, K u -> exists ks, length ks = length (ls ++ rs) /\ u = combination ks (ls ++ rs).

    Lemma split_at_value : forall (vs : list pt) (cs : list R) c, length cs = length vs -> In c cs ->
      exists cs1 cs2 xs v ys, vs = xs ++ v :: ys /\ cs = cs1 ++ c :: cs2 /\ length cs1 = length xs.
    Proof.
      induction vs as [|v vs IH]; intros [|k cs] c L H; try discriminate; [contradiction|]. destruct H as [->|H].
      - exists [], cs, [], v, vs. auto.
      - destruct (IH cs c) as (cs1 & cs2 & xs & w & ys & -> & -> & E); [simpl in L; lia|auto|].
        exists (k :: cs1), cs2, (v :: xs), w, ys. simpl. auto.
    Qed.

    Lemma length_split : forall (ks : list R) n m, length ks = (n + m)%nat -> exists a b, ks = a ++ b /\ length a = n /\ length b = m.
    Proof.
      intros ks n m H. exists (firstn n ks), (skipn n ks). rewrite firstn_skipn, firstn_length, skipn_length. split; auto. lia.
    Qed.

    Theorem few_spanned : forall u, K u -> spanned ls rs u.
    Proof.
      intros u Hu. destruct (span u Hu) as (ks & L & E). rewrite app_length in L.
      destruct (length_split ks _ _ L) as (k1 & k2 & -> & L1 & L2). rewrite combination_app in E by auto.
      exists k1, k2. split; auto. split; auto. split; auto. intros c Ic.
      destruct (split_at_value rs k2 c L2 Ic) as (c1 & c2 & xs & r & ys & Ers & Ek & Lx).
      destruct (below_ray xs r ys Ers) as (d & Id & Lr & Z). assert (G := Hd d u Id Hu).
      rewrite E, dot_add_r, dot_combination_zero in G by (intros l Il; apply level_lineality; auto).
      rewrite Ers, Ek, combination_app in G by auto. simpl in G.
      rewrite !dot_add_r, dot_scal_r, !dot_combination_zero in G by (intros; apply Z; apply in_or_app; auto). nra.
    Qed.

    Theorem few_irredundant : forall xs r ys, rs = xs ++ r :: ys -> ~ spanned ls (xs ++ ys) r.
    Proof.
      intros xs r ys E (ks & cs & Lk & Lc & N & Er). destruct (below_ray xs r ys E) as (d & Id & Lr & Z).
      rewrite Er, dot_add_r, !dot_combination_zero in Lr; auto; [lra|]. intros l Il. apply level_lineality; auto.
    Qed.

    Theorem few_not_opposite : forall r, In r rs -> ~ K (scal (-1) r).
    Proof.
      intros r Ir. apply in_split in Ir. destruct Ir as (xs & ys & E). destruct (below_ray xs r ys E) as (d & Id & Lr & _).
      apply (not_opposite d); auto.
    Qed.
  End Few.

  (* ---- where few vectors span: the members of F are level with them ---- *)
  Variable F : list pt.
  Hypothesis HF : forall d, In d F -> In d ds.

  (* one vector p: going around p from any member of F a further one comes before half a turn *)
  Lemma span_one : forall p u, p <> origin -> F <> [] -> (forall d, In d F -> dot d p = 0) ->
    (forall d, In d F -> exists d', In d' F /\ 0 < dot p (cross d d')) -> K u -> exists k, u = scal k p.
  Proof.
    intros p u Hp HFn Lp Turn Hu. exists (dot u p / norm2 p). assert (Np := norm2_pos p Hp).
    set (v := sub u (scal (dot u p / norm2 p) p)). apply sub_zero. fold v.
    destruct (origin_dec v) as [E|Hv]; [rewrite E; apply norm2_origin|]. exfalso.
    assert (Vp : dot p v = 0).
    { unfold v. rewrite dot_sub_r, dot_scal_r, (dot_comm p u). fold (norm2 p). field. lra. }
    assert (X : forall d, In d F -> dot d v <= 0).
    { intros d Id. unfold v. rewrite dot_sub_r, dot_scal_r, (Lp d Id). assert (G := Hd d u (HF d Id) Hu). lra. }
    set (y := fun d => dot d (cross p v)).
    assert (left : forall d d', 0 < dot p (cross d d') -> 0 < dot d v * y d' - y d * dot d' v).
    { intros d d' L. replace (dot d v * y d' - y d * dot d' v) with (norm2 v * dot p (cross d d') - dot p v * dot v (cross d d'))
        by (unfold y, norm2, dot; simpl; ring). rewrite Vp. assert (Nv := norm2_pos v Hv).
      assert (0 < norm2 v * dot p (cross d d')) by (apply Rmult_lt_0_compat; auto). lra. }
    (* on the half-plane's edge only one side has members *)
    assert (edge : forall d, In d F -> dot d v = 0 -> 0 < y d).
    { intros d Id Z. destruct (Turn d Id) as (d' & Id' & L). apply left in L. rewrite Z in L. assert (G := X d' Id').
      apply Rnot_le_lt. intros L'. nra. }
    (* strictly inside there is a member, and a last one *)
    assert (HM : exists d, In d F /\ dot d v < 0).
    { destruct F as [|d F'] eqn:EF; [congruence|]. assert (Id : In d (d :: F')) by (simpl; auto).
      destruct (Req_dec (dot d v) 0) as [Z|Z]; [|exists d; split; auto; assert (G := X d Id); lra].
      assert (P0 := edge d Id Z). destruct (Turn d Id) as (d' & Id' & L). apply left in L. rewrite Z in L.
      exists d'. split; auto. assert (G := X d' Id'). apply Rnot_le_lt. intros L'. assert (dot d' v = 0) by lra. nra. }
    assert (HM' : exists m, In m F /\ dot m v < 0 /\ forall d, In d F -> dot d v < 0 -> y d / dot d v <= y m / dot m v).
    { clear -HM. destruct HM as (d0 & I0 & L0). revert d0 I0 L0. generalize F. induction F0 as [|a G IH]; intros d0 I0 L0; [contradiction|].
      assert (Hsome : (exists d, In d G /\ dot d v < 0) \/ (forall d, In d G -> ~ dot d v < 0)).
      { clear. induction G as [|b G [(d & Id & L)|IH]]; [right; simpl; tauto|left; exists d; simpl; auto|].
        destruct (Rlt_dec (dot b v) 0); [left; exists b; simpl; auto|right; intros d [<-|Id]; auto]. }
      destruct Hsome as [(d & Id & L)|None].
      - destruct (IH d Id L) as (m & Im & Lm & M). destruct (Rlt_dec (dot a v) 0) as [La|La].
        + destruct (Rle_dec (y a / dot a v) (y m / dot m v)) as [C|C].
          * exists m. split; [simpl; auto|]. split; auto. intros x [<-|Ix] Lx; auto.
          * exists a. split; [simpl; auto|]. split; auto. intros x [<-|Ix] Lx; [lra|]. specialize (M x Ix Lx). lra.
        + exists m. split; [simpl; auto|]. split; auto. intros x [<-|Ix] Lx; [contradiction|auto].
      - destruct I0 as [->|I0]; [|exfalso; apply (None d0); auto].
        exists d0. split; [simpl; auto|]. split; auto. intros x [<-|Ix] Lx; [lra|]. exfalso; apply (None x); auto. }
    destruct HM' as (m & Im & Lm & Last). destruct (Turn m Im) as (d & Id & L). apply left in L. assert (G := X d Id).
    destruct (Req_dec (dot d v) 0) as [Z|Z].
    - rewrite Z in L. assert (P0 := edge d Id Z). nra.
    - assert (Ld : dot d v < 0) by lra. assert (C := Last d Id Ld).
      assert (Pxx : 0 < dot m v * dot d v) by nra.
      assert (E : (y m / dot m v - y d / dot d v) * (dot m v * dot d v) = y m * dot d v - y d * dot m v) by (field; lra).
      nra.
  Qed.

  Lemma span_two : forall a b u d d', cross a b <> origin -> In d F -> In d' F -> (forall d, In d F -> dot d a = 0 /\ dot d b = 0) ->
    dot d d' < 0 -> K u -> exists j k, u = add (scal j a) (scal k b).
  Proof.
    intros a b u d d' Hw Id Id' Lv Opp Hu. set (w := cross a b) in *. assert (Pw := norm2_pos w Hw).
    assert (G := Hd d u (HF d Id) Hu). assert (G' := Hd d' u (HF d' Id') Hu).
    assert (multiple : forall x, In x F -> x = scal (dot x w / norm2 w) w).
    { intros x Ix. destruct (Lv x Ix) as [Za Zb]. apply parallel; auto.
      replace (cross w x) with (sub (scal (dot x a) b) (scal (dot x b) a)) by (unfold w, dot; pteq; ring).
      rewrite Za, Zb. pteq; ring. }
    rewrite (multiple d Id), (multiple d' Id') in *. set (s := dot d w / norm2 w) in *. set (t := dot d' w / norm2 w) in *.
    rewrite !dot_scal_l in G, G'. rewrite dot_scal_l, dot_scal_r in Opp. fold (norm2 w) in Opp.
    assert (D : dot w u = 0).
    { assert (s * t < 0) by (apply Rnot_le_lt; intros L; nra). assert (s * dot w u <= 0) by auto. assert (t * dot w u <= 0) by auto.
      destruct (Rtotal_order s 0) as [S|[S|S]]; [|subst; nra|]; nra. }
    exists (dot (cross u b) w / norm2 w), (dot (cross a u) w / norm2 w).
    assert (I : scal (norm2 w) u = add (add (scal (dot (cross u b) w) a) (scal (dot (cross a u) w) b)) (scal (dot w u) w)).
    { unfold w, norm2, dot; pteq; ring. }
    rewrite D in I. transitivity (scal (/ norm2 w) (scal (norm2 w) u)); [rewrite scal_scal, Rinv_l, scal_1 by lra; auto|].
    rewrite I. pteq; field; lra.
  Qed.

  Lemma span_three : forall a b c u, det a b c <> 0 -> exists i j k, u = add (scal i a) (add (scal j b) (scal k c)).
  Proof.
    intros a b c u D. exists (det u b c / det a b c), (det a u c / det a b c), (det a b u / det a b c).
    assert (X := cramer_x a b c u). assert (Y := cramer_y a b c u). assert (Z := cramer_z a b c u).
    pteq; apply Rmult_eq_reg_l with (det a b c); auto; [rewrite X|rewrite Y|rewrite Z]; field; auto.
  Qed.
End Cone.
