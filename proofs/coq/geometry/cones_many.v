(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The set K of all u with <d,u> <= 0 for every d of a set, third case: three rays or more generate it, if they go around it in a cycle of
   faces, each on the plane of a d that has just two of them. *)
Require Import Reals Lra Psatz List Lia.
From Fathom.geometry Require Import meaning bodies space norm hulls faces farkas flats facets spans cones.
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

  Let level := level_lineality K ls ds Hd Hl.
  Let below_not_opposite := not_opposite K ds Hd.

  Definition face (d r a : pt) : Prop := dot d r = 0 /\ dot d a = 0 /\ r <> a /\ forall s, In s rs -> dot d s = 0 -> s = r \/ s = a.

  Section Many.
    Hypothesis distinct : NoDup rs.
    Hypothesis three : (3 <= length rs)%nat.
    Hypothesis below_rays : forall d r, In d ds -> In r rs -> dot d r <= 0.
    Hypothesis faces : forall d, In d ds -> exists r a, In r rs /\ In a rs /\ face d r a.
    Hypothesis between : forall r, In r rs -> exists d d' a b, In d ds /\ In d' ds /\ In a rs /\ In b rs /\ face d r a /\ face d' r b
      /\ a <> b.

    (* a face at r that does not hold a *)
    Lemma other_face : forall r a, In r rs -> In a rs -> a <> r -> exists d, In d ds /\ dot d r = 0 /\ dot d a < 0.
    Proof.
      assert (G : forall d r a b, In d ds -> In a rs -> face d r b -> a <> r -> a <> b -> dot d a < 0).
      { intros d r a b Id Ia (_ & _ & _ & F) N1 N2. assert (L := below_rays d a Id Ia).
        destruct (Req_dec (dot d a) 0) as [Z|Z]; [|lra]. destruct (F a Ia Z); contradiction. }
      intros r a Ir Ia N. destruct (between r Ir) as (d & d' & b & b' & Id & Id' & _ & _ & F & F' & Nb).
      destruct (pt_dec a b) as [->|E].
      - exists d'. split; auto. split; [apply F'|]. apply (G d' r b b'); auto.
      - exists d. split; auto. split; [apply F|]. apply (G d r a b); auto.
    Qed.

    Lemma below_one : forall d, In d ds -> exists s, In s rs /\ dot d s < 0.
    Proof.
      intros d Id. destruct (some_or_none _ (fun s => dot d s) rs) as [(s & Is & N)|Z].
      - exists s. split; auto. assert (L := below_rays d s Id Is). lra.
      - exfalso. destruct (faces d Id) as (r & a & _ & _ & (_ & _ & _ & F)).
        assert (G : incl rs [r; a]). { intros s Is. destruct (F s Is (Z s Is)) as [->| ->]; simpl; auto. }
        apply (NoDup_incl_length distinct) in G. simpl in G. lia.
    Qed.

    Let e := fold_right add origin rs.

    Lemma below_sum : forall d, In d ds -> dot d e < 0.
    Proof.
      intros d Id. destruct (below_one d Id) as (s & Is & L). unfold e.
      assert (B : forall r, In r rs -> dot d r <= 0) by auto. clear -Is L B. induction rs as [|r l IH]; [contradiction|].
      simpl. rewrite dot_add_r. assert (B0 := B r (or_introl eq_refl)).
      assert (G : dot d (fold_right add origin l) <= 0).
      { clear IH Is. assert (B' : forall r, In r l -> dot d r <= 0) by (intros; apply B; simpl; auto). clear -B'.
        induction l as [|x l IH]; simpl; [rewrite dot_origin_r; lra|]. rewrite dot_add_r.
        assert (dot d x <= 0) by (apply B'; simpl; auto). assert (dot d (fold_right add origin l) <= 0) by (apply IH; intros; apply B';
          simpl; auto). lra. }
      destruct Is as [->|Is]; [lra|]. assert (dot d (fold_right add origin l) < 0) by (apply IH; auto; intros; apply B; simpl; auto). lra.
    Qed.

    Lemma spanned_sum : forall c, 0 <= c -> spanned ls rs (scal c e).
    Proof.
      intros c Hc. unfold e. assert (G : forall l, incl l rs -> spanned ls rs (scal c (fold_right add origin l))).
      { induction l as [|r l IH]; intros H; simpl.
        - replace (scal c origin) with origin by (pteq; ring). apply spanned_origin.
        - replace (scal c (add r (fold_right add origin l))) with (add (scal c r) (scal c (fold_right add origin l))) by (pteq; ring).
          apply spanned_add; [apply spanned_ray; auto; apply H; simpl; auto|]. apply IH. intros x Hx. apply H. simpl; auto. }
      apply G, incl_refl.
    Qed.

    (* the least of a quotient over a list *)
    Lemma least_quotient : forall (f g : pt -> R) l, l <> [] -> exists m, In m l /\ forall x, In x l -> f m / g m <= f x / g x.
    Proof.
      induction l as [|a l IH]; intros H; [congruence|]. destruct l as [|b l].
      - exists a. split; [simpl; auto|]. intros x [<-|[]]. lra.
      - destruct IH as (m & Im & M); [congruence|]. destruct (Rle_dec (f a / g a) (f m / g m)) as [L|L].
        + exists a. split; [simpl; auto|]. intros x [<-|Hx]; [lra|]. specialize (M x Hx). lra.
        + exists m. split; [simpl; auto|]. intros x [<-|Hx]; [lra|auto].
    Qed.

    Theorem many_spanned : forall u, K u -> spanned ls rs u.
    Proof.
      intros u Hu.
      assert (Hds : ds <> []).
      { destruct rs as [|r l] eqn:E; [simpl in three; lia|]. destruct (between r) as (d & _ & _ & _ & Id & _); [simpl; auto|].
        intros Z. rewrite Z in Id. exact Id. }
      destruct (least_quotient (fun d => dot d u) (fun d => dot d e) ds Hds) as (d0 & I0 & M).
      set (c := dot d0 u / dot d0 e) in *. assert (E0 := below_sum d0 I0).
      assert (Hc : 0 <= c).
      { unfold c. assert (L := Hd d0 u I0 Hu). replace (dot d0 u / dot d0 e) with (- dot d0 u / - dot d0 e) by (field; lra).
        apply Rmult_le_pos; [lra|]. left. apply Rinv_0_lt_compat. lra. }
      set (x := sub u (scal c e)).
      assert (X : forall d, In d ds -> dot d x <= 0).
      { intros d Id. unfold x. rewrite dot_sub_r, dot_scal_r. assert (E1 := below_sum d Id). assert (M1 := M d Id).
        assert (dot d u = dot d u / dot d e * dot d e) by (field; lra). nra. }
      assert (X0 : dot d0 x = 0).
      { unfold x, c. rewrite dot_sub_r, dot_scal_r. field. lra. }
      replace u with (add (scal c e) x) by (unfold x; pteq; ring). apply spanned_add; [apply spanned_sum; auto|].
      destruct (faces d0 I0) as (r & a & Ir & Ia & (Zr & Za & N & _)).
      destruct (other_face r a Ir Ia) as (d1 & I1 & R1 & A1); [congruence|].
      destruct (other_face a r Ia Ir) as (d2 & I2 & A2 & R2); [congruence|].
      assert (Nr : r <> origin). { intros Z. rewrite Z, dot_origin_r in R2. lra. }
      set (w := cross r a).
      assert (Nw : w <> origin).
      { intros Z. assert (Ea := parallel r a Z Nr). rewrite Ea, dot_scal_r, R1 in A1. lra. }
      destruct (below_one d0 I0) as (s & Is & Ls).
      assert (N0 : d0 <> origin). { intros Z. rewrite Z in Ls. unfold dot, origin in Ls. simpl in Ls. lra. }
      assert (D : dot x w = 0).
      { change (det x r a = 0). apply (det_flat d0); auto; rewrite dot_comm; auto. }
      assert (Pw := norm2_pos w Nw).
      set (al := dot (cross x a) w / norm2 w). set (be := dot (cross r x) w / norm2 w).
      assert (Ex : x = add (scal al r) (scal be a)).
      { assert (I : scal (norm2 w) x = add (add (scal (dot (cross x a) w) r) (scal (dot (cross r x) w) a)) (scal (dot x w) w)).
        { unfold w, norm2, dot; pteq; ring. }
        rewrite D in I. replace x with (scal (/ norm2 w) (scal (norm2 w) x)).
        - rewrite I. unfold al, be. pteq; field; lra.
        - rewrite scal_scal, Rinv_l by lra. apply scal_1. }
      assert (L1 := X d1 I1). assert (L2 := X d2 I2). rewrite Ex, dot_add_r, !dot_scal_r in L1, L2. rewrite R1 in L1. rewrite A2 in L2.
      assert (0 <= be) by (apply Rnot_lt_le; intros L; nra). assert (0 <= al) by (apply Rnot_lt_le; intros L; nra).
      rewrite Ex. apply spanned_add; apply spanned_ray; auto.
    Qed.

    Lemma each_zero : forall d vs cs, length cs = length vs -> (forall v, In v vs -> dot d v <= 0) -> (forall c, In c cs -> 0 <= c) ->
      0 <= dot d (combination cs vs) -> forall c v, In (c, v) (combine cs vs) -> c * dot d v = 0.
    Proof.
      intros d. induction vs as [|v vs IH]; intros [|c cs] L B N Z c' v' I'; try discriminate; simpl in *; [contradiction|].
      rewrite dot_add_r, dot_scal_r in Z.
      assert (T : dot d (combination cs vs) <= 0).
      { apply dot_combination_below; auto. }
      assert (B0 := B v (or_introl eq_refl)). assert (N0 := N c (or_introl eq_refl)).
      assert (c * dot d v <= 0) by nra.
      destruct I' as [I'|I']; [inversion I'; subst; lra|]. apply (IH cs); auto; lra.
    Qed.

    Lemma all_zero_combination : forall (vs : list pt) cs, length cs = length vs -> (forall c v, In (c, v) (combine cs vs) -> c = 0) ->
      combination cs vs = origin.
    Proof.
      induction vs as [|v vs IH]; intros [|c cs] L H; try discriminate; auto. simpl.
      rewrite (H c v) by (simpl; auto). rewrite IH; [pteq; ring|simpl in L; lia|intros c' v' H'; apply (H c' v'); simpl; auto].
    Qed.

    Theorem many_irredundant : forall xs r ys, rs = xs ++ r :: ys -> ~ spanned ls (xs ++ ys) r.
    Proof.
      intros xs r ys E (ks & cs & Lk & Lc & N & Er).
      assert (Ir : In r rs) by (rewrite E; apply in_or_app; simpl; auto).
      assert (sub0 : forall v, In v (xs ++ ys) -> In v rs).
      { intros v Hv. rewrite E. apply in_or_app. apply in_app_or in Hv. simpl. tauto. }
      assert (Nr : ~ In r (xs ++ ys)). { apply NoDup_remove_2. rewrite <- E. auto. }
      destruct (between r Ir) as (d & d' & a & b & Id & Id' & Ia & Ib & F & F' & Nab).
      assert (value : forall g, In g ds -> dot g r = dot g (combination cs (xs ++ ys))).
      { intros g Ig. rewrite Er at 1. rewrite dot_add_r, dot_combination_zero; [ring|]. intros l Il. apply level; auto. }
      assert (zero : forall c v, In (c, v) (combine cs (xs ++ ys)) -> c = 0).
      { intros c v Icv. assert (Iv := in_combine_r _ _ _ _ Icv).
        assert (go : forall g p, In g ds -> face g r p -> v <> p -> c = 0).
        { intros g p Ig (Z & _ & _ & Fz) Np.
          assert (Q : c * dot g v = 0).
          { apply (each_zero g (xs ++ ys) cs); auto. rewrite <- value, Z; auto. lra. }
          destruct (Req_dec (dot g v) 0) as [Zv|Zv].
          - destruct (Fz v (sub0 v Iv) Zv); [subst; contradiction|contradiction].
          - apply Rmult_integral in Q. tauto. }
        destruct (pt_dec v a) as [->|Na]; [apply (go d' b); auto|apply (go d a); auto]. }
      destruct F as (_ & _ & Nra & _).
      destruct (other_face a r Ia Ir) as (g & Ig & _ & Lg); [auto|].
      rewrite value, (all_zero_combination _ _ Lc zero), dot_origin_r in Lg; auto. lra.
    Qed.

    Theorem many_not_opposite : forall r, In r rs -> ~ K (scal (-1) r).
    Proof.
      intros r Ir. destruct (between r Ir) as (d & d' & a & b & _ & _ & Ia & _ & (_ & _ & N & _) & _).
      destruct (other_face a r Ia Ir) as (g & Ig & _ & Lg); auto. apply (below_not_opposite g); auto.
    Qed.
  End Many.
End Cone.
