(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Completeness of the optima: if every facet of Q at the ball's distance has a listed direction, all nearest points of P's
   boundary are foot points of listed directions; primitive, strictly ascending directions give different points. *)
Require Import Reals Lra Psatz List ZArith Lia Bool Sorting.
From Fathom.checker Require Import vector sequence table polytope support certificate.
From Fathom.geometry Require Import meaning space hulls flats difference depth.
From Fathom.soundness Require Import statement booleans upper lower.
Import ListNotations.
Open Scope Z_scope.

(* ---- lexicographic order ---- *)
Lemma before_spec : forall u v, before u v = true ->
  zx u < zx v \/ zx u = zx v /\ (zy u < zy v \/ zy u = zy v /\ zz u < zz v).
Proof.
  intros u v. unfold before. rewrite !orb_true_iff, !andb_true_iff, !orb_true_iff, !andb_true_iff, !Z.ltb_lt, !Z.eqb_eq. tauto.
Qed.
Definition Before u v := zx u < zx v \/ zx u = zx v /\ (zy u < zy v \/ zy u = zy v /\ zz u < zz v).
Lemma Before_trans : forall u v w, Before u v -> Before v w -> Before u w.
Proof. unfold Before. intros. lia. Qed.

Lemma ascending_nodup : forall (T : Type) (r : list (zvec * T)) d, along_pairs (fun u v => before (fst u) (fst v)) d r = true ->
  NoDup (map fst (d :: r)) /\ forall e, In e r -> Before (fst d) (fst e).
Proof.
  intros T. induction r as [|e r IH]; intros d H.
  - split; [|simpl; tauto]. simpl. constructor; [simpl; tauto|constructor].
  - simpl in H. destruct (before (fst d) (fst e)) eqn:E; [|discriminate]. apply before_spec in E.
    destruct (IH e H) as [N L].
    assert (L' : forall x, In x (e :: r) -> Before (fst d) (fst x)).
    { intros x [<-|Hx]; [exact E|]. apply (Before_trans _ (fst e)); [exact E|auto]. }
    split; auto. cbn [map]. constructor; auto. intros Hd.
    change (In (fst d) (map fst (e :: r))) in Hd. apply in_map_iff in Hd. destruct Hd as (x & Ex & Ix).
    specialize (L' x Ix). rewrite Ex in L'. unfold Before in L'. lia.
Qed.

(* ---- primitive vectors that are parallel, in the same sense, are equal ---- *)
Lemma primitive_equal : forall n n' m m', zdot n n' = 1 -> zdot m m' = 1 -> zcross n m = zzero -> 0 < zdot n m -> n = m.
Proof.
  intros [a b c] [a' b' c'] [d e f] [d' e' f']. unfold zdot, zcross, zzero. simpl. intros N M C D.
  assert (X := f_equal zx C). assert (Y := f_equal zy C). assert (Z := f_equal zz C). simpl in X, Y, Z. clear C.
  set (k := d * a' + e * b' + f * c').
  assert (K1 : d = k * a).
  { transitivity (d * 1); [ring|]. rewrite <- N. unfold k.
    assert (b' * (a * e - b * d) = 0) by (rewrite Z; ring). assert (c' * (c * d - a * f) = 0) by (rewrite Y; ring). lia. }
  assert (K2 : e = k * b).
  { transitivity (e * 1); [ring|]. rewrite <- N. unfold k.
    assert (a' * (a * e - b * d) = 0) by (rewrite Z; ring). assert (c' * (b * f - c * e) = 0) by (rewrite X; ring). lia. }
  assert (K3 : f = k * c).
  { transitivity (f * 1); [ring|]. rewrite <- N. unfold k.
    assert (a' * (c * d - a * f) = 0) by (rewrite Y; ring). assert (b' * (b * f - c * e) = 0) by (rewrite X; ring). lia. }
  clearbody k. subst d e f. clear X Y Z.
  assert (U : k * (a * d' + b * e' + c * f') = 1) by (rewrite <- M; ring).
  assert (P : 0 < k).
  { replace (a * (k * a) + b * (k * b) + c * (k * c)) with (k * (a * a + b * b + c * c)) in D by ring. clear - D. nia. }
  assert (K : k = 1) by (destruct (Z.mul_eq_1 _ _ U); lia). subst k. f_equal; ring.
Qed.

Section Optima.
  Variables (A B : list zvec) (qn qd : Z).
  Hypothesis Hqd : 0 < qd.
  Variables (V : list (N * N)) (F : list (list (N * N))).
  Let RA := map inj A.
  Let RB := map inj B.
  Let Fs := make_facets A B V F.
  Let q := (IZR qn / IZR qd)%R.
  Open Scope R_scope.

  (* parallel in the same sense: the foot points at the same distance are equal *)
  Lemma same_foot : forall n m h k, m <> origin -> 0 < h -> 0 < k -> h * h = q * norm2 n -> k * k = q * norm2 m ->
    cross n m = origin -> 0 < dot n m -> scal (h / norm2 n) n = scal (k / norm2 m) m.
  Proof.
    intros n m h k Hm Hh Hk En Em C D. assert (M := norm2_pos m Hm).
    assert (C' : cross m n = origin).
    { replace (cross m n) with (scal (-1) (cross n m)) by (pteq; ring). rewrite C. pteq; ring. }
    assert (E := parallel m n C' Hm). set (c := dot n m / norm2 m) in *.
    assert (Pc : 0 < c) by (apply Rdiv_lt_0_compat; auto).
    assert (N : norm2 n = c * c * norm2 m) by (rewrite E, norm2_scal; auto).
    assert (Ehk : h = c * k).
    { assert (h * h = (c * k) * (c * k)) by (rewrite En, N; replace (c * k * (c * k)) with (c * c * (k * k)) by ring; rewrite Em; ring).
      assert (0 < c * k) by (apply Rmult_lt_0_compat; auto). nra. }
    rewrite N, Ehk, E, scal_scal. f_equal. field. split; lra.
  Qed.

  Lemma complete_sound : forall dirs find,
    inner_ok qn qd Fs = true -> forallb (fun n => tangent A B qn qd (fst n)) dirs = true ->
    depth2_is RA RB q -> canonical dirs = true -> forallb (listed qn qd (numbered (each fst dirs)) find) Fs = true ->
    directions_complete RA RB q (map (fun n => inj (fst n)) dirs).
  Proof.
    intros dirs find Hinner Htangent D Hcan Hlisted.
    assert (T : forall d, In d dirs -> exists h, height_is RA RB (inj (fst d)) h /\ 0 < h /\ inj (fst d) <> origin
        /\ h * h = q * norm2 (inj (fst d))).
    { intros d Id. apply tangent_sound; auto. exact (forallb_In _ _ _ Htangent d Id). }
    unfold canonical in Hcan. apply andb_true_iff in Hcan. destruct Hcan as [Hasc Hprim].
    assert (ND : NoDup (map fst dirs)).
    { destruct dirs as [|d r]; [constructor|]. apply ascending_nodup in Hasc. tauto. }
    split; [|split].
    - intros t Ht. split.
      + intros NI. destruct (tight_facet A B qn qd Hqd V F Hinner t Ht NI) as (f & If & Hn & Hc & E & Et).
        assert (L := forallb_In _ _ _ Hlisted f If). unfold listed in L. apply orb_true_iff in L.
        assert (Rqd : 0 < IZR qd) by (apply IZR_lt; auto).
        destruct L as [L|L].
        { exfalso. apply negb_true_iff, Z.eqb_neq in L. apply L. apply eq_IZR. rewrite !mult_IZR, norm2_inj, E.
          unfold q. field. lra. }
        destruct (member _ _) as [n|] eqn:En in L; [|discriminate]. assert (In0 := member_in _ _ _ _ En). rewrite each_map in In0.
        apply in_map_iff in In0. destruct In0 as (d & <- & Id).
        unfold same_sense in L. apply andb_true_iff in L. destruct L as [L1 L2].
        apply is_zero_spec in L1. apply Z.ltb_lt, IZR_lt in L2. rewrite dot_inj in L2.
        destruct (T d Id) as (h & Hh & Ph & Hd & Eh).
        exists (inj (fst d)). split; [apply in_map_iff; eauto|]. exists h. split; auto.
        rewrite Et. symmetry. apply same_foot; auto.
        rewrite <- inj_cross, L1. reflexivity.
      + intros (n & In0 & h & Hh & ->). apply in_map_iff in In0. destruct In0 as (d & <- & Id).
        destruct (T d Id) as (h' & Hh' & Ph & Hd & Eh).
        apply (beyond_not_interior RA RB (inj (fst d)) h); auto. rewrite foot_dot; auto. lra.
    - intros n m t Hn Hm (h & Hh & Et) (k & Hk & Et').
      apply in_map_iff in Hn. destruct Hn as (d & <- & Id). apply in_map_iff in Hm. destruct Hm as (e & <- & Ie).
      f_equal. apply (primitive_equal _ (snd d) _ (snd e)).
      + apply Z.eqb_eq. exact (forallb_In _ _ _ Hprim d Id).
      + apply Z.eqb_eq. exact (forallb_In _ _ _ Hprim e Ie).
      + destruct (T d Id) as (h' & Hh' & Ph & Hd & Eh). destruct (T e Ie) as (k' & Hk' & Pk & He & Ek).
        rewrite (height_unique _ _ _ _ _ Hh Hh') in Et. rewrite (height_unique _ _ _ _ _ Hk Hk') in Et'.
        assert (N := norm2_pos _ Hd). assert (a0 : 0 < h' / norm2 (inj (fst d))) by (apply Rdiv_lt_0_compat; auto).
        apply inj_injective. rewrite inj_cross. change (inj zzero) with origin.
        apply cross_zero_scal with (h' / norm2 (inj (fst d))); [lra|]. rewrite <- Et, Et'. pteq; ring.
      + destruct (T d Id) as (h' & Hh' & Ph & Hd & Eh). destruct (T e Ie) as (k' & Hk' & Pk & He & Ek).
        rewrite (height_unique _ _ _ _ _ Hh Hh') in Et. rewrite (height_unique _ _ _ _ _ Hk Hk') in Et'.
        assert (N := norm2_pos _ Hd). assert (a0 : 0 < h' / norm2 (inj (fst d))) by (apply Rdiv_lt_0_compat; auto).
        apply lt_IZR. rewrite dot_inj.
        assert (G : dot (inj (fst e)) t = k') by (rewrite Et'; apply foot_dot; auto).
        rewrite Et, dot_scal_r, dot_comm in G. simpl. nra.
    - rewrite <- (map_map (@fst zvec zvec) inj). apply FinFun.Injective_map_NoDup; auto. intros u v. apply inj_injective.
  Qed.
End Optima.
