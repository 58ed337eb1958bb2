(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Format 2: from integers in units of 1/m to the bodies as they stand in the file. *)
Require Import Reals Lra Psatz List ZArith Lia Bool.
From Fathom.checker Require Import vector sequence verdict body signed signed_verdict.
From Fathom.geometry Require Import meaning bodies space norm signed_depth curved units.
From Fathom.soundness Require Import statement booleans verdict_sound signed_sides.
Import ListNotations.
Open Scope R_scope.

(* ---- the file's bodies in units of 1/m ---- *)
Lemma units_real : forall m r, (0 < m)%Z -> divides m r = true -> IZR (units m r) = IZR m * value r.
Proof. intros m r Hm H. rewrite <- (units_value m r Hm H). field. apply not_0_IZR. lia. Qed.

Lemma integral_scal : forall m p, (0 < m)%Z -> fits m p = true -> inj (integral m p) = scal (IZR m) (real p).
Proof. intros m p Hm H. unfold fits in H. bsplit. pteq; apply units_real; auto. Qed.

Lemma in_units_real : forall m b, (0 < m)%Z -> all_body (fits m) (divides m) b = true ->
  map_body inj IZR IZR (in_units m b) = scale_body (IZR m) (real_body b).
Proof.
  intros m [c r] Hm H. unfold all_body in H. cbn [core_of radius] in H. apply andb_true_iff in H. destruct H as [H Hr].
  unfold in_units, scale_body, real_body, map_body. cbn [core_of radius]. f_equal; [|apply units_real; auto].
  assert (V := integral_scal m). destruct c as [L|ts|n d]; cbn [map_core]; rewrite ?each_map, ?map_map.
  - f_equal. apply map_ext_in. intros p Hp. apply V; auto. exact (forallb_In _ _ _ H p Hp).
  - f_equal. apply map_ext_in. intros t Ht. rewrite !each_map, !map_map. apply map_ext_in. intros a Ha.
    assert (E := forallb_In _ _ _ (forallb_In _ _ _ H t Ht) a Ha). unfold all_atom in E. bsplit.
    destruct a as [c u v w]. unfold map_atom, real_atom. cbn [center axis_u axis_v axis_w] in *. rewrite !V; auto.
  - bsplit. f_equal; [apply V; auto|]. rewrite mult_IZR, units_real by auto. ring.
Qed.

(* ---- from units of 1/m to the file's ---- *)
Section Units.
  Variables (m : Z) (A B : body pt R) (ZA ZB : zbody).
  Hypothesis Hm : (0 < m)%Z.
  Hypothesis EA : map_body inj IZR IZR ZA = scale_body (IZR m) A.
  Hypothesis EB : map_body inj IZR IZR ZB = scale_body (IZR m) B.
  Let G := zgaps (core_of ZA) (core_of ZB).

  Lemma zgaps_core : forall p, G (scal (IZR m) p) <-> core_gaps A B p.
  Proof.
    intros p. rewrite <- (core_gaps_scal (IZR m)) by (apply IZR_pos; auto). rewrite <- EA, <- EB. unfold core_gaps, G, zgaps. tauto.
  Qed.
  Lemma comparable_back : comparable (map_core inj IZR (core_of ZA)) (map_core inj IZR (core_of ZB)) -> comparable (core_of A) (core_of B).
  Proof.
    assert (PA := f_equal (@core_of _ _) EA). assert (PB := f_equal (@core_of _ _) EB). simpl in PA, PB.
      rewrite PA, PB. apply comparable_scal.
  Qed.
  Lemma zgaps_back : forall p, G p -> core_gaps A B (scal (/ IZR m) p).
  Proof. intros p H. apply zgaps_core. rewrite scal_back by (apply IZR_pos; auto). auto. Qed.

  Lemma least_back : forall x, at_least G (IZR m * x) -> at_least (core_gaps A B) x.
  Proof.
    intros x H. assert (P0 := IZR_pos _ Hm). apply (at_least_scal _ (core_gaps A B) (/ IZR m)) in H.
    - replace (/ IZR m * (IZR m * x)) with x in H by (field; lra). auto.
    - apply Rinv_0_lt_compat; auto.
    - apply zgaps_back.
  Qed.
  Lemma planed_back : forall x, planed G (IZR m * x) -> planed (core_gaps A B) x.
  Proof. intros x. apply planed_scal; [apply IZR_pos; auto|]. intros p. apply zgaps_core. Qed.
End Units.

Lemma root_in_units : forall m qn qd, (0 < m)%Z -> (0 < qd)%Z ->
  signed_root (IZR (qn * (m * m)) / IZR qd) = IZR m * signed_root (IZR qn / IZR qd).
Proof.
  intros m qn qd Hm Hq. assert (Pm := IZR_pos _ Hm). assert (Pq := IZR_pos _ Hq). rewrite <- signed_root_scal by lra.
  f_equal. rewrite !mult_IZR. field. lra.
Qed.
