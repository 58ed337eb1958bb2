(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The set K of all u with <d,u> <= 0 for every d of a set: when vectors and rays generate it, shown by finitely many d. *)
Require Import Reals Lra Psatz List Lia.
From Fathom.geometry Require Import meaning bodies space hulls faces farkas flats facets rounded.
Import ListNotations.
Open Scope R_scope.

(* ---- sums of multiples ---- *)
Lemma combination_app : forall ks vs cs ws, length ks = length vs ->
  combination (ks ++ cs) (vs ++ ws) = add (combination ks vs) (combination cs ws).
Proof.
  induction ks as [|k ks IH]; intros [|v vs] cs ws H; try discriminate; simpl.
  - pteq; ring.
  - rewrite IH by (simpl in H; lia). pteq; ring.
Qed.
Lemma combination_add : forall vs ks cs, length ks = length vs -> length cs = length vs -> exists ts, length ts = length vs
  /\ combination ts vs = add (combination ks vs) (combination cs vs)
  /\ ((forall k, In k ks -> 0 <= k) -> (forall c, In c cs -> 0 <= c) -> forall t, In t ts -> 0 <= t).
Proof.
  induction vs as [|v vs IH]; intros [|k ks] [|c cs] Hk Hc; try discriminate.
  - exists []. repeat split; simpl; try tauto. pteq; ring.
  - destruct (IH ks cs) as (ts & L & E & N); try (simpl in *; lia).
    exists (k + c :: ts). simpl. split; [lia|]. split; [rewrite E; pteq; ring|].
    intros Pk Pc t [<-|Ht]; [apply Rplus_le_le_0_compat; auto|]. apply N; auto.
Qed.
Lemma combination_zero : forall vs, exists ks, length ks = length vs /\ combination ks vs = origin /\ forall k, In k ks -> 0 <= k.
Proof.
  induction vs as [|v vs (ks & L & E & N)]; [exists []; simpl; tauto|].
  exists (0 :: ks). simpl. split; [lia|]. split; [rewrite E; pteq; ring|]. intros k [<-|Hk]; [lra|auto].
Qed.
Lemma combination_one : forall vs v c, In v vs -> 0 <= c -> exists ks, length ks = length vs /\ combination ks vs = scal c v
  /\ forall k, In k ks -> 0 <= k.
Proof.
  induction vs as [|w vs IH]; intros v c Hv Hc; [contradiction|]. destruct Hv as [->|Hv].
  - destruct (combination_zero vs) as (ks & L & E & N). exists (c :: ks). simpl.
    split; [lia|]. split; [rewrite E; pteq; ring|]. intros k [<-|Hk]; auto.
  - destruct (IH v c Hv Hc) as (ks & L & E & N). exists (0 :: ks). simpl.
    split; [lia|]. split; [rewrite E; pteq; ring|]. intros k [<-|Hk]; [lra|auto].
Qed.
Lemma dot_combination_zero : forall d vs ks, (forall v, In v vs -> dot d v = 0) -> dot d (combination ks vs) = 0.
Proof.
  intros d. induction vs as [|v vs IH]; intros [|k ks] H; simpl; try apply dot_origin_r.
  rewrite dot_add_r, dot_scal_r, H by (simpl; auto). rewrite IH by (intros; apply H; simpl; auto). ring.
Qed.

Lemma dot_combination_below : forall d vs cs, (forall v, In v vs -> dot d v <= 0) -> (forall c, In c cs -> 0 <= c) ->
  dot d (combination cs vs) <= 0.
Proof.
  intros d. induction vs as [|v vs IH]; intros [|c cs] B N; simpl; try (rewrite dot_origin_r; lra).
  rewrite dot_add_r, dot_scal_r. assert (dot d v <= 0) by (apply B; simpl; auto). assert (0 <= c) by (apply N; simpl; auto).
  assert (dot d (combination cs vs) <= 0) by (apply IH; intros; [apply B|apply N]; simpl; auto). nra.
Qed.

(* ---- spanned ---- *)
Section Spanned.
  Variables ls rs : list pt.
  Lemma spanned_add : forall u v, spanned ls rs u -> spanned ls rs v -> spanned ls rs (add u v).
  Proof.
    intros u v (ks & cs & Lk & Lc & N & ->) (ks' & cs' & Lk' & Lc' & N' & ->).
    destruct (combination_add ls ks ks' Lk Lk') as (t & Lt & Et & _).
    destruct (combination_add rs cs cs' Lc Lc') as (t' & Lt' & Et' & Nt). exists t, t'. split; auto. split; auto. split; [exact (Nt N N')|].
    rewrite Et, Et'. pteq; ring.
  Qed.
  Lemma spanned_origin : spanned ls rs origin.
  Proof.
    destruct (combination_zero ls) as (ks & L & E & _). destruct (combination_zero rs) as (cs & L' & E' & N).
    exists ks, cs. split; auto. split; auto. split; auto. rewrite E, E'. pteq; ring.
  Qed.
  Lemma spanned_ray : forall r c, In r rs -> 0 <= c -> spanned ls rs (scal c r).
  Proof.
    intros r c Hr Hc. destruct (combination_zero ls) as (ks & L & E & _). destruct (combination_one rs r c Hr Hc) as (cs & L' & E' & N).
    exists ks, cs. split; auto. split; auto. split; auto. rewrite E, E'. pteq; ring.
  Qed.
End Spanned.

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

  (* ---- three rays or more ---- *)
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
      { intros g Ig. rewrite Er at 1. rewrite dot_add_r, dot_combination_zero; [ring|]. intros l Il. apply level_lineality; auto. }
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
      destruct (other_face a r Ia Ir) as (g & Ig & _ & Lg); auto. apply (not_opposite g); auto.
    Qed.
  End Many.

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

(* ---- linear independence ---- *)
Lemma independent_one : forall u, u <> origin -> linearly_independent [u].
Proof.
  intros u Hu [|k [|]] L E; try discriminate. simpl in E. intros x [<-|[]].
  destruct (Req_dec k 0) as [Z|Z]; auto. exfalso. apply Hu.
  transitivity (scal (/ k) (add (scal k u) origin)); [|rewrite E; pteq; ring]. pteq; field; auto.
Qed.
Lemma independent_two : forall u v, cross u v <> origin -> linearly_independent [u; v].
Proof.
  intros u v Hc [|k [|j [|]]] L E; try discriminate. simpl in E.
  assert (Pw := norm2_pos _ Hc). set (w := cross u v) in *.
  assert (E1 : k * norm2 w = 0).
  { transitivity (dot w (cross (add (scal k u) (add (scal j v) origin)) v)); [unfold w, norm2, dot; simpl; ring|].
    rewrite E. unfold dot; simpl; ring. }
  assert (E2 : j * norm2 w = 0).
  { transitivity (dot w (cross u (add (scal k u) (add (scal j v) origin)))); [unfold w, norm2, dot; simpl; ring|].
    rewrite E. unfold dot; simpl; ring. }
  intros x [<-|[<-|[]]]; [apply Rmult_integral in E1; lra|apply Rmult_integral in E2; lra].
Qed.
Lemma independent_three : forall u v w, det u v w <> 0 -> linearly_independent [u; v; w].
Proof.
  intros u v w D [|i [|j [|k [|]]]] L E; try discriminate. simpl in E.
  set (s := add (scal i u) (add (scal j v) (add (scal k w) origin))) in *.
  assert (E1 : i * det u v w = 0) by (transitivity (det s v w); [unfold s, det, dot, cross; simpl; ring|rewrite E; unfold det, dot;
    simpl; ring]).
  assert (E2 : j * det u v w = 0) by (transitivity (det u s w); [unfold s, det, dot, cross; simpl; ring|rewrite E; unfold det, dot;
    simpl; ring]).
  assert (E3 : k * det u v w = 0) by (transitivity (det u v s); [unfold s, det, dot, cross; simpl; ring|rewrite E; unfold det, dot;
    simpl; ring]).
  apply Rmult_integral in E1, E2, E3. intros x [<-|[<-|[<-|[]]]]; tauto.
Qed.
Lemma orthogonal_cross : forall u v, u <> origin -> v <> origin -> dot u v = 0 -> cross u v <> origin.
Proof.
  intros u v Hu Hv Z E. assert (I : norm2 (cross u v) = norm2 u * norm2 v - dot u v * dot u v) by (unfold norm2, dot; simpl; ring).
  rewrite E, Z, norm2_origin in I. assert (Pu := norm2_pos u Hu). assert (Pv := norm2_pos v Hv). nra.
Qed.
Lemma orthogonal_det : forall l u v, l <> origin -> cross u v <> origin -> dot l u = 0 -> dot l v = 0 -> det l u v <> 0.
Proof.
  intros l u v Hl Hw Zu Zv E.
  assert (I : det l u v * det l u v + norm2 (sub (scal (dot l v) u) (scal (dot l u) v)) = norm2 l * norm2 (cross u v))
    by (unfold det, norm2, dot; simpl; ring).
  rewrite E, Zu, Zv in I. assert (Pl := norm2_pos l Hl). assert (Pw := norm2_pos _ Hw).
  replace (norm2 (sub (scal 0 u) (scal 0 v))) with 0 in I by (unfold norm2, dot; simpl; ring). nra.
Qed.
