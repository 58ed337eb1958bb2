(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Format 2: the status that is printed is the sign of the signed depth; the number of optima that is printed is that of the shortest ways
   out. *)
Require Import Reals Lra Psatz List FinFun ZArith Lia Bool.
From Fathom.checker Require Import verdict body signed signed_verdict.
From Fathom.geometry Require Import meaning bodies space norm hulls difference scaling signed_depth rounded ways_out curved units.
From Fathom.soundness Require Import statement booleans signed_sides.
Import ListNotations.
Open Scope R_scope.

(* ---- the least ways out of overlapping rounded bodies ---- *)
Lemma way_out_iff : forall (S T : pt -> Prop) v t, (forall p, S p <-> T p) -> way_out S v t -> way_out T v t.
Proof. intros S T v t E [N NI]. split; auto. rewrite <- (interior_iff S); auto. Qed.

Lemma along_scal : forall n v k, along n (k * v) = scal k (along n v).
Proof. intros. unfold along. pteq; unfold Rdiv; ring. Qed.

Lemma ways_of_planes : forall S s r ns, 0 < s -> 0 <= r ->
  (forall n, In n ns -> n <> origin /\ beneath S n (s * norm n)) ->
  NoDup (map (fun n => along n 1) ns) ->
  (forall t, way_out S s t -> exists n, In n ns /\ t = along n s) ->
  exits (interior (thick S r)) ((s + r) * (s + r)) (Z.of_nat (length ns)).
Proof.
  intros S s r ns Hs Hr Hn N H. exists (map (fun n => along n (s + r)) ns). split; [rewrite map_length; auto|]. split.
  - assert (E : map (fun n => along n (s + r)) ns = map (scal (s + r)) (map (fun n => along n 1) ns)).
    { rewrite map_map. apply map_ext. intros n. rewrite <- along_scal. f_equal. ring. }
    rewrite E. apply Injective_map_NoDup; auto. intros u v E'.
    rewrite <- (scal_inv' (s + r) u), <- (scal_inv' (s + r) v), E' by lra. auto.
  - intros t. change (In t (map (fun n => along n (s + r)) ns) <-> way_out (thick S r) (s + r) t). symmetry.
      rewrite in_map_iff. split.
    + intros W. apply ways_out_overlap in W; auto. destruct (H _ W) as (n & In0 & E). exists n. split; auto.
      replace (s + r) with ((s + r) / s * s) by (field; lra). rewrite along_scal, <- E, scal_scal.
      replace ((s + r) / s * (s / (s + r))) with 1 by (field; lra). apply scal_1.
    + intros (n & <- & In0). destruct (Hn n In0) as [Nz Hb]. split.
      * rewrite <- norm_sqr, norm_along by (auto; lra). auto.
      * apply (beneath_along _ n (s * norm n + r * norm n)); auto; [apply beneath_thick; auto|lra].
Qed.

Lemma way_out_scal : forall (S T : pt -> Prop) k v t, 0 < k -> (forall p, S p -> T (scal k p)) -> (forall p, T (scal k p) -> S p) ->
  way_out S v t -> way_out T (k * v) (scal k t).
Proof.
  intros S T k v t Hk ST TS [N NI]. split; [rewrite norm2_scal, N; ring|]. intros I. apply NI.
  assert (P0 : 0 < / k) by (apply Rinv_0_lt_compat; auto).
  rewrite <- (scal_inv' k t) by lra. apply (interior_scal_set T); auto. intros p Hp. apply TS. rewrite scal_back; auto.
Qed.

(* ---- the status ---- *)
Lemma status_of_root_sound : forall s rho, (0 < den s)%Z -> (0 < den rho)%Z ->
  sign_is (status_of_root s rho) (signed_root (value s) + value rho).
Proof.
  intros [sn sd] [rn rd] Hs Hr. unfold value. cbn [num den] in *. assert (Ps := IZR_pos _ Hs).
    assert (Pr := IZR_pos _ Hr).
  unfold status_of_root. cbn [num den]. set (v := signed_root (IZR sn / IZR sd) + IZR rn / IZR rd) in *.
  (* the two signed squares over one denominator *)
  assert (X : IZR (signed_square rn * sd) = signed_sqr (IZR rn / IZR rd) * (IZR rd * IZR rd * IZR sd)).
  { rewrite mult_IZR, IZR_signed_square. replace (IZR rn) with (IZR rd * (IZR rn / IZR rd)) at 1 by (field; lra).
    rewrite signed_sqr_scal by lra. ring. }
  assert (Y : IZR (- sn * (rd * rd)) = signed_sqr (- signed_root (IZR sn / IZR sd)) * (IZR rd * IZR rd * IZR sd)).
  { rewrite <- signed_root_opp, signed_sqr_root, !mult_IZR, opp_IZR. field. lra. }
  assert (P0 : 0 < IZR rd * IZR rd * IZR sd) by (repeat apply Rmult_lt_0_compat; auto).
  destruct (_ ?= _)%Z eqn:C; cbn [sign_is].
  - apply Z.compare_eq in C. apply (f_equal IZR) in C. rewrite X, Y in C. apply Rmult_eq_reg_r in C; [|lra].
    apply signed_sqr_inj in C. unfold v. lra.
  - rewrite Z.compare_lt_iff in C. apply IZR_lt in C. rewrite X, Y in C. apply Rmult_lt_reg_r in C; auto.
    apply Rnot_le_lt. intros L.
    assert (signed_sqr (- signed_root (IZR sn / IZR sd)) <= signed_sqr (IZR rn / IZR rd)) by (apply signed_sqr_le; unfold v in L; lra). lra.
  - rewrite Z.compare_gt_iff in C. apply IZR_lt in C. rewrite X, Y in C. apply Rmult_lt_reg_r in C; auto.
    apply Rnot_le_lt. intros L.
    assert (signed_sqr (IZR rn / IZR rd) <= signed_sqr (- signed_root (IZR sn / IZR sd))) by (apply signed_sqr_le; unfold v in L; lra). lra.
Qed.

Lemma status_between_sound : forall lo hi v, (0 < den lo)%Z -> (0 < den hi)%Z -> value lo <= v <= value hi ->
  sign_is (status_between lo hi) v.
Proof.
  intros [ln ld] [hn hd] v Hl Hh B. unfold value in *. cbn [num den] in *. assert (Pl := IZR_pos _ Hl).
    assert (Ph := IZR_pos _ Hh).
  unfold status_between. cbn [num]. destruct (0 <? ln)%Z eqn:E1.
  - apply Z.ltb_lt, IZR_pos in E1. assert (0 < IZR ln / IZR ld) by (apply Rdiv_lt_0_compat; auto). simpl. lra.
  - destruct (hn <? 0)%Z eqn:E2.
    + apply Z.ltb_lt, IZR_lt in E2. assert (0 < - IZR hn / IZR hd) by (apply Rdiv_lt_0_compat; lra).
      replace (- IZR hn / IZR hd) with (- (IZR hn / IZR hd)) in H by (field; lra). simpl. lra.
    + destruct ((ln =? 0) && (hn =? 0))%Z eqn:E3; simpl; auto. bsplit. subst. unfold Rdiv in B.
        rewrite !Rmult_0_l in B. lra.
Qed.
