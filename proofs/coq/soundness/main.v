(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* THE THEOREM: what the checker accepts is true. *)
Require Import Reals Lra Psatz List ZArith Lia Bool.
From Fathom.checker Require Import vector sequence table polytope support certificate.
From Fathom.geometry Require Import meaning space hulls difference depth scaling.
From Fathom.soundness Require Import statement booleans upper lower optima.
Import ListNotations.
Open Scope R_scope.

Section Integers.
  Variables A B : list zvec.
  Let RA := map inj A.
  Let RB := map inj B.

  Lemma check_depth_sound : forall qn qd complete dirs q, check_depth A B qn qd complete dirs q = true ->
    holds RA RB (Depth qn qd complete dirs q).
  Proof.
    intros qn qd complete dirs i H. unfold check_depth in H. bsplit.
    rename H into Hqn, H4 into Hqd, H3 into Hsome, H2 into Htangent, H1 into Hinner, H0 into Hall.
    assert (T : forall n, In n (map (fun n => inj (fst n)) dirs) -> exists h, height_is RA RB n h /\ 0 < h /\ n <> origin
        /\ h * h = IZR qn / IZR qd * norm2 n).
    { intros n Hn. apply in_map_iff in Hn. destruct Hn as (d & <- & Id).
      apply tangent_sound; auto. exact (forallb_In _ _ _ Htangent d Id). }
    assert (D : depth2_is RA RB (IZR qn / IZR qd)).
    { repeat split.
      - apply Rdiv_lt_0_compat; apply IZR_lt; auto.
      - apply (lower_sound A B qn qd Hqd (vertices i) (facets i)); auto.
      - destruct dirs as [|d dirs]; [discriminate|].
        destruct (T (inj (fst d))) as (h & Hh & Ph & Hn & E); [simpl; auto|].
        assert (N := norm2_pos _ Hn). exists (scal (h / norm2 (inj (fst d))) (inj (fst d))). split.
        + rewrite foot_norm2, E by auto. field. split; [apply Rgt_not_eq, IZR_lt; auto|lra].
        + apply (beyond_not_interior RA RB (inj (fst d)) h); auto. rewrite foot_dot; auto. lra. }
    simpl. split; [exact D|]. split.
    - intros n In0. destruct (T n In0) as (h & Hh & Ph & Hn & E).
      destruct (nearest_plane RA RB _ n h D Hn Hh E) as [F N]. split; auto.
      exists (scal (h / norm2 n) n). split; auto. exists h. auto.
    - intros ->. simpl in Hall. bsplit.
      apply (complete_sound A B qn qd Hqd (vertices i) (facets i) _ (find i)); auto.
  Qed.

  Lemma check_bounds_sound : forall ln ld hn hd n q, check_bounds A B ln ld hn hd n q = true ->
    holds RA RB (Bounds ln ld hn hd n q).
  Proof.
    intros ln ld hn hd n i H. unfold check_bounds in H. bsplit.
    rename H into Hln, H4 into Hld, H3 into Hhn, H2 into Hhd, H1 into Hwithin, H0 into Hinner.
    assert (HO := origin_interior A B ln ld Hld _ _ Hinner).
    apply depth_exists in HO. destruct HO as (q & D). exists q. split; auto. split.
    - destruct D as (_ & _ & t & Ht & NI). apply Rnot_lt_le. intros L. apply NI.
      apply (lower_sound A B ln ld Hld _ _ Hinner). rewrite Ht. auto.
    - destruct (within_sound A B hn hd n Hhd Hwithin) as (h & Hh & Ph & Hn & E).
      assert (L := depth_le_ratio _ _ _ _ _ D Hn Hh). apply ratio_le in L; [|apply norm2_pos; auto].
      assert (N := norm2_pos _ Hn). apply Rmult_le_reg_r with (norm2 (inj n)); auto. lra.
  Qed.
End Integers.

(* the same statement in units of 1/scale *)
Lemma holds_scaled : forall A B S c, (0 < S)%Z ->
  holds (map inj A) (map inj B) (match c with
    | Depth qn qd complete dirs q => Depth (qn * (S * S)) qd complete dirs q
    | Bounds ln ld hn hd n q => Bounds (ln * (S * S)) ld (hn * (S * S)) hd n q
    | _ => c end) ->
  holds (map (frac S) A) (map (frac S) B) c.
Proof.
  intros A B S c HS.
  assert (RS : 0 < IZR S) by (apply IZR_lt; auto).
  assert (Ri : 0 < / IZR S) by (apply Rinv_0_lt_compat; auto).
  assert (E : forall L, map (frac S) L = map (scal (/ IZR S)) (map inj L)).
  { intros L. rewrite map_map. apply map_ext. intros v. pteq; unfold Rdiv; ring. }
  assert (U : forall n d, / IZR S * / IZR S * (IZR (n * (S * S)) / d) = IZR n / d).
  { intros n d. rewrite !mult_IZR. unfold Rdiv.
    transitivity ((/ IZR S * IZR S) * (/ IZR S * IZR S) * (IZR n * / d)); [ring|]. rewrite Rinv_l by lra. ring. }
  rewrite !E. set (RA := map inj A). set (RB := map inj B).
  destruct c as [qn qd complete dirs q|ln ld hn hd n q|n unit WA WB|n]; cbn [holds]; intros H.
  - destruct H as (D & Hdirs & Hall).
    assert (Q : forall t, norm2 t = IZR qn / IZR qd <-> norm2 (scal (IZR S) t) = IZR (qn * (S * S)) / IZR qd).
    { intros t. rewrite norm2_scal. rewrite <- (U qn (IZR qd)). generalize (IZR (qn * (S * S)) / IZR qd).
      intros X. split; intros G.
      - rewrite G. field. lra.
      - rewrite <- G. field. lra. }
    assert (Fo : forall n t, foot (map (scal (/ IZR S)) RA) (map (scal (/ IZR S)) RB) n t <-> foot RA RB n (scal (IZR S) t)).
    { intros n t. rewrite <- (foot_scal_iff RA RB (/ IZR S) Ri). rewrite scal_inv' by lra. tauto. }
    split; [rewrite <- (U qn); apply depth_scal; auto|]. split.
    + intros n Hn. destruct (Hdirs n Hn) as (F & t & Ht & Nt). split; [apply facet_direction_scal; auto|].
      exists (scal (/ IZR S) t). rewrite Fo, Q, scal_inv by lra. auto.
    + intros Hc. destruct (Hall Hc) as (C1 & C2 & C3). split; [|split]; auto.
      * intros t Ht. apply Q in Ht. assert (G := C1 _ Ht).
        rewrite <- (interior_scal_iff RA RB (/ IZR S) Ri), scal_inv' in G by lra. rewrite G.
        split; intros (n & Hn & Hf); exists n; split; auto; apply Fo; auto.
      * intros n m t Hn Hm Fn Fm. apply (C2 n m (scal (IZR S) t)); auto; apply Fo; auto.
  - rewrite <- (U ln), <- (U hn). apply between_scal; auto.
  - apply touching_scal; auto.
  - apply disjoint_scal; auto.
Qed.

Theorem check_sound : forall c, check c = true -> meaning_of c.
Proof.
  intros [S A B c] H. unfold check in H. cbn [scale body_a body_b claimed] in H. bsplit. rename H into HS.
  unfold meaning_of. cbn [scale body_a body_b claimed]. apply holds_scaled; auto.
  destruct c as [qn qd complete dirs q|ln ld hn hd n q|n unit WA WB|n].
  - apply check_depth_sound; auto.
  - apply check_bounds_sound; auto.
  - unfold check_touching in H0. bsplit. apply negb_true_iff in H. apply (touching_sound A B n unit WA WB); auto.
  - apply (disjoint_sound A B n); auto.
Qed.
