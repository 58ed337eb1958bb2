(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Completeness in terms of facets: every facet of P at the distance of the depth has a listed direction, and no two directions are
   those of one facet. *)
Require Import Reals Lra List.
From Fathom.geometry Require Import meaning space difference depth.
From Fathom.soundness Require Import statement.
Open Scope R_scope.

Section Facets.
  Variables (A B : list pt) (q : R).
  Hypothesis D : depth2_is A B q.
  Let HO := depth_interior _ _ _ D.

  Lemma foot_multiple : forall n k t, n <> origin -> 0 < k -> foot A B n t -> foot A B (scal k n) t.
  Proof.
    intros n k t Hn Hk (h & (H & p & Hp & E) & ->). exists (k * h). split.
    - split; [|exists p; rewrite dot_scal_l, E; auto].
      intros s Hs. rewrite dot_scal_l. apply Rmult_le_compat_l; [lra|auto].
    - assert (N := norm2_pos n Hn). rewrite norm2_scal, scal_scal. f_equal. field. lra.
  Qed.

  (* the foot point of a plane that does not hold O gives back the direction *)
  Lemma foot_ray : forall n m t, n <> origin -> m <> origin -> foot A B n t -> foot A B m t -> same_ray n m.
  Proof.
    intros n m t Hn Hm (h & Hh & Et) (k & Hk & Et').
    assert (Ph := height_positive A B n h HO Hn Hh). assert (Pk := height_positive A B m k HO Hm Hk).
    assert (a : 0 < h / norm2 n) by (apply Rdiv_lt_0_compat; auto; apply norm2_pos; auto).
    assert (b : 0 < k / norm2 m) by (apply Rdiv_lt_0_compat; auto; apply norm2_pos; auto).
    exists (/ (k / norm2 m) * (h / norm2 n)). split; [apply Rmult_lt_0_compat; auto; apply Rinv_0_lt_compat; auto|].
    rewrite <- scal_scal, <- Et, Et', scal_scal, Rinv_l, scal_1 by lra. reflexivity.
  Qed.

  Variable ns : list pt.
  Hypothesis Hold : directions_hold A B q ns.
  Hypothesis Complete : directions_complete A B q ns.

  Theorem every_facet_listed : forall n, facet_at A B q n -> exists m, In m ns /\ same_ray n m.
  Proof.
    intros n (Hf & t & Ht & Nt). destruct Complete as [C _].
    assert (NI : ~ interior (P A B) t) by (apply (nearest_points A B q t D Nt); eauto).
    apply (C t Nt) in NI. destruct NI as (m & Im & Hm). exists m. split; auto.
    apply (foot_ray n m t); auto; [apply Hf|apply (Hold m Im)].
  Qed.

  Theorem no_facet_twice : forall n m, In n ns -> In m ns -> same_ray n m -> n = m.
  Proof.
    intros n m In0 Im (k & Hk & E). destruct Complete as (_ & C & _).
    destruct (Hold n In0) as (F & t & Ht & _). apply (C n m t); auto. rewrite E. apply foot_multiple; auto. apply F.
  Qed.
End Facets.
