(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* From boolean tests on integers to statements about reals. *)
Require Import Reals List ZArith Lia Bool.
From Fathom.checker Require Import vector.
From Fathom.geometry Require Import meaning space.
From Fathom.soundness Require Import statement.

Lemma dot_inj : forall u v, IZR (zdot u v) = dot (inj u) (inj v).
Proof. intros. unfold zdot, dot; simpl. rewrite !plus_IZR, !mult_IZR. reflexivity. Qed.
Lemma det_inj : forall u v w, IZR (zdet u v w) = det (inj u) (inj v) (inj w).
Proof.
  intros. unfold zdet, zcross, zdot, det, dot, cross; simpl.
  rewrite !plus_IZR, !mult_IZR, !minus_IZR, !mult_IZR. ring.
Qed.
Lemma norm2_inj : forall u, IZR (zdot u u) = norm2 (inj u).
Proof. intros. apply dot_inj. Qed.
Lemma inj_sub : forall u v, inj (zsub u v) = sub (inj u) (inj v).
Proof. intros. pteq; apply minus_IZR. Qed.
Lemma inj_add : forall u v, inj (zadd u v) = add (inj u) (inj v).
Proof. intros. pteq; apply plus_IZR. Qed.
Lemma inj_scal : forall k u, inj (zscal k u) = scal (IZR k) (inj u).
Proof. intros. pteq; apply mult_IZR. Qed.
Lemma inj_cross : forall u v, inj (zcross u v) = cross (inj u) (inj v).
Proof. intros. pteq; rewrite minus_IZR, !mult_IZR; ring. Qed.
Lemma inj_injective : forall u v, inj u = inj v -> u = v.
Proof.
  intros [a b c] [d e f] H. inversion H. f_equal; apply eq_IZR; auto.
Qed.

Lemma is_zero_spec : forall v, is_zero v = true <-> v = zzero.
Proof.
  intros [a b c]. unfold is_zero, zzero. simpl. rewrite !andb_true_iff, !Z.eqb_eq. split; [intros [[-> ->] ->]; auto|].
  intros H. inversion H. auto.
Qed.
Lemma same_vector_spec : forall u v, same_vector u v = true -> u = v.
Proof.
  intros [a b c] [d e f]. unfold same_vector. simpl. rewrite !andb_true_iff, !Z.eqb_eq. intros [[-> ->] ->]. auto.
Qed.
Lemma inj_zero : forall v, inj v = origin <-> v = zzero.
Proof. intros v. split; [intros H; apply inj_injective; exact H|intros ->; reflexivity]. Qed.

Lemma forallb_In : forall (T : Type) (f : T -> bool) l, forallb f l = true -> forall x, In x l -> f x = true.
Proof. intros T f l H. apply forallb_forall. exact H. Qed.

Ltac bsplit := repeat match goal with
  | H : (_ && _)%bool = true |- _ => apply andb_true_iff in H; destruct H
  | H : (_ <? _)%Z = true |- _ => apply Z.ltb_lt in H
  | H : (_ <=? _)%Z = true |- _ => apply Z.leb_le in H
  | H : (_ =? _)%Z = true |- _ => apply Z.eqb_eq in H
  | H : existsb _ _ = true |- _ => apply existsb_exists in H; destruct H as (? & ? & ?)
  end.
