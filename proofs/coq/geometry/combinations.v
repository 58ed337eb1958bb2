(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Sanity of the definition of hull: it is the set of finite convex combinations. *)
Require Import Reals Lra Psatz List.
From Fathom.geometry Require Import meaning space hulls.
Import ListNotations.
Open Scope R_scope.

Definition wsum (l : list (R * pt)) : R := fold_right (fun e a => fst e + a) 0 l.
Definition lin (l : list (R * pt)) : pt := fold_right (fun e a => add (scal (fst e) (snd e)) a) (mk 0 0 0) l.
Definition comb (S : pt -> Prop) (p : pt) : Prop :=
  exists l, (forall e, In e l -> 0 <= fst e /\ S (snd e)) /\ wsum l = 1 /\ p = lin l.

Definition sc (k : R) (e : R * pt) := (k * fst e, snd e).
Lemma wsum_app : forall l m, wsum (l ++ m) = wsum l + wsum m.
Proof. induction l; simpl; intros; [lra|]. rewrite IHl. lra. Qed.
Lemma lin_app : forall l m, lin (l ++ m) = add (lin l) (lin m).
Proof. induction l; simpl; intros; [pteq; ring|]. rewrite IHl. pteq; ring. Qed.
Lemma wsum_sc : forall k l, wsum (map (sc k) l) = k * wsum l.
Proof. induction l; simpl; [lra|]. rewrite IHl. lra. Qed.
Lemma lin_sc : forall k l, lin (map (sc k) l) = scal k (lin l).
Proof. induction l; simpl; [pteq; ring|]. rewrite IHl. pteq; ring. Qed.
Lemma wsum_nonneg : forall (S : pt -> Prop) l, (forall e, In e l -> 0 <= fst e /\ S (snd e)) -> 0 <= wsum l.
Proof. induction l; simpl; intros H; [lra|]. destruct (H a); auto. assert (0 <= wsum l) by auto. lra. Qed.
Lemma wsum_zero : forall (S : pt -> Prop) l, (forall e, In e l -> 0 <= fst e /\ S (snd e)) -> wsum l = 0 -> lin l = mk 0 0 0.
Proof.
  induction l as [|a l IH]; simpl; intros H E; auto. destruct (H a); auto.
  assert (0 <= wsum l) by (apply (wsum_nonneg S); auto).
  rewrite IH by (auto; lra). replace (fst a) with 0 by lra. pteq; ring.
Qed.

Theorem hull_comb : forall S p, hull S p <-> comb S p.
Proof.
  intros S p. split.
  - intros H. apply H.
    + intros u v t Ht (l & Hl & El & ->) (m & Hm & Em & ->).
      exists (map (sc t) l ++ map (sc (1 - t)) m). split; [|split].
      * intros e He. apply in_app_or in He.
        destruct He as [He|He]; apply in_map_iff in He; destruct He as (d & <- & Hd); simpl;
          [destruct (Hl _ Hd)|destruct (Hm _ Hd)]; split; auto; apply Rmult_le_pos; lra.
      * rewrite wsum_app, !wsum_sc, El, Em. ring.
      * rewrite lin_app, !lin_sc. reflexivity.
    + intros s Hs. exists [(1, s)]. split; [|split].
      * simpl. intros e [<-|[]]. simpl. split; [lra|auto].
      * simpl. lra.
      * pteq; ring.
  - intros (l & Hl & El & ->).
    assert (G : forall l, (forall e, In e l -> 0 <= fst e /\ S (snd e)) -> 0 < wsum l ->
                hull S (scal (/ wsum l) (lin l))).
    { clear. induction l as [|[w v] l IH]; simpl; intros H Hw; [lra|].
      destruct (H (w, v)) as [Hw0 Hv]; [auto|]. simpl in *.
      assert (H0 : 0 <= wsum l) by (apply (wsum_nonneg S); auto).
      destruct (Req_dec (wsum l) 0) as [Z|Z].
      - rewrite (wsum_zero S l); auto. rewrite Z in *.
        replace (scal (/ (w + 0)) (add (scal w v) (mk 0 0 0))) with v by (pteq; field; lra).
        apply hull_in; auto.
      - assert (IH' : hull S (scal (/ wsum l) (lin l))) by (apply IH; auto; lra).
        apply (hull_seg S v (scal (/ wsum l) (lin l)) _ w (wsum l)); auto; simpl; try lra.
        + apply hull_in; auto.
        + field; lra. + field; lra. + field; lra. }
    specialize (G l Hl). rewrite El in G. replace (lin l) with (scal (/ 1) (lin l)); [apply G; lra|].
    rewrite Rinv_1. apply scal_1.
Qed.

