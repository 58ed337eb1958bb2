(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The wording of Agarwal, Guibas, Har-Peled, Rabinovitch and Sharir, for an A with interior points. *)
Require Import Reals Lra Psatz List.
From Fathom.geometry Require Import meaning space hulls minkowski.
Import ListNotations.
Open Scope R_scope.

(* int(A+t) meets B  iff  t is interior to P, when A has interior points *)
Lemma meets_interior : forall A B t,
  (exists a0, interior (conv A) a0) -> B <> [] ->
  (exists p, interior (translate (conv A) t) p /\ conv B p) <-> interior (P A B) t.
Proof.
  intros A B t (a0 & e & He & Ha0) HB. split.
  - intros (p & (d & Hd & H) & Hp). exists d. split; auto. intros s Hs.
    apply P_minkowski. exists (sub p s), p. split; [|split; [auto|pteq; ring]].
    assert (G := H (add p (sub t s))). unfold translate in G.
    replace (sub (add p (sub t s)) t) with (sub p s) in G by (pteq; ring).
    apply G. replace (norm2 (sub (add p (sub t s)) p)) with (norm2 (sub s t)); auto.
    unfold norm2, dot; simpl; ring.
  - intros (d & Hd & H). destruct B as [|b0 B']; [congruence|]. set (B := b0 :: B') in *.
    assert (Hb0 : conv B b0) by (apply hull_in; simpl; auto).
    set (w := sub t (sub b0 a0)).
    set (k := d / (1 + norm2 w)).
    assert (N0 := norm2_nonneg w).
    assert (Hk : 0 < k) by (apply Rdiv_lt_0_compat; lra).
    assert (Ek : d = k * (1 + norm2 w)) by (unfold k; field; lra).
    assert (Hin : P A B (add t (scal k w))).
    { apply H. replace (sub (add t (scal k w)) t) with (scal k w) by (pteq; ring).
      rewrite norm2_scal, Ek.
      replace (k * (1 + norm2 w) * (k * (1 + norm2 w))) with
        (k*k * norm2 w + k*k*(1 + norm2 w + norm2 w * norm2 w)) by ring.
      assert (0 < k*k) by nra. nra. }
    apply P_minkowski in Hin. destruct Hin as (a1 & b1 & Ha1 & Hb1 & E).
    set (l := 1 / (1 + k)).
    assert (Hl : 0 <= l <= 1).
    { unfold l. split; [apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat; lra]|].
      apply Rmult_le_reg_r with (1 + k); [lra|]. field_simplify; lra. }
    assert (El : 1 - l = k / (1 + k)) by (unfold l; field; lra).
    assert (Hl1 : 0 < 1 - l) by (rewrite El; apply Rdiv_lt_0_compat; lra).
    exists (add (scal l b1) (scal (1 - l) b0)). split; [|apply hull_convex; auto].
    exists ((1 - l) * e). split; [nra|]. intros s Hs. unfold translate.
    (* s - t = l a1 + (1-l) a', a' near a0 *)
    set (a' := add a0 (scal (/ (1 - l)) (sub s (add (scal l b1) (scal (1 - l) b0))))).
    assert (Ha' : conv A a').
    { apply Ha0. replace (sub a' a0) with (scal (/ (1 - l)) (sub s (add (scal l b1) (scal (1 - l) b0))))
        by (pteq; ring).
      rewrite norm2_scal. set (m := 1 - l) in *.
      apply Rmult_lt_reg_l with (m * m); [nra|].
      match goal with |- m * m * (/ m * / m * ?n) < _ => replace (m * m * (/ m * / m * n)) with n by (field; lra) end.
      lra. }
    replace (sub s t) with (add (scal l a1) (scal (1 - l) a')); [apply hull_convex; auto|].
    assert (EX := f_equal px E). assert (EY := f_equal py E). assert (EZ := f_equal pz E).
    unfold w in EX, EY, EZ. simpl in EX, EY, EZ.
    assert (L1 : l * (1 + k) = 1) by (unfold l; field; lra).
    assert (Lk : l * k = 1 - l) by lra.
    pteq; rewrite Rmult_plus_distr_l, <- Rmult_assoc, Rinv_r, Rmult_1_l by lra.
    + apply (Rmult_eq_compat_l l) in EX. rewrite Rmult_plus_distr_l, <- Rmult_assoc, Lk in EX. lra.
    + apply (Rmult_eq_compat_l l) in EY. rewrite Rmult_plus_distr_l, <- Rmult_assoc, Lk in EY. lra.
    + apply (Rmult_eq_compat_l l) in EZ. rewrite Rmult_plus_distr_l, <- Rmult_assoc, Lk in EZ. lra.
Qed.

Theorem depth_AGHRS : forall A B q, (exists a0, interior (conv A) a0) -> B <> [] ->
  depth2_is A B q -> depth2_AGHRS A B q.
Proof.
  intros A B q HA HB (Hq & H1 & t & Ht & H2). split.
  - intros s Hs. apply Rnot_lt_le. intros L. apply H1 in L.
    apply meets_interior in L; auto. destruct L as (p & Hp). exact (Hs p Hp).
  - exists t. split; auto. intros p Hp. apply H2. apply meets_interior; auto. exists p; auto.
Qed.

