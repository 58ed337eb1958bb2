(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What printed.v says of meshes, in the words of the proofs: its winding number is the sum of
   signs that the other files are about. *)
Require Import Reals Lra Psatz List ZArith Lia.
From Fathom.geometry Require Import meaning space unions meshes crossings tilings.
Import ListNotations.
Open Scope R_scope.

Lemma beside_back : forall x v p q, beside x v q p = - beside x v p q.
Proof. intros. unfold beside, dot, cross; simpl; ring. Qed.

Lemma front_distinct : forall T, front T <> origin ->
  corner_1 T <> corner_2 T /\ corner_2 T <> corner_3 T /\ corner_3 T <> corner_1 T.
Proof.
  intros [p q r] H. unfold front in H. cbn [corner_1 corner_2 corner_3] in *.
  repeat split; intros E; apply H; subst; unfold origin; pteq; ring.
Qed.

Lemma generic_said : forall M x v, generic M x v <-> general M x v.
Proof.
  intros M x v. split; intros H T HT; destruct (H T HT) as [E|C]; auto; destruct (origin_dec (front T)) as [Z|N]; auto;
    right.
  - destruct C as [F C]. destruct (front_distinct T N) as (N1 & N2 & N3). unfold clear. rewrite <- !and_assoc. split;
      auto.
    unfold tips in C. simpl in C. assert (K : forall p q, p <> q -> (corner_1 T = p \/ corner_2 T = p \/ corner_3 T = p
      \/ False) ->
      (corner_1 T = q \/ corner_2 T = q \/ corner_3 T = q \/ False) -> beside x v p q <> 0).
    { intros p q Npq Hp Hq. destruct (C p q Hp Hq); [contradiction|auto]. }
    split; [split|]; apply K; auto.
  - destruct C as (A & B & C & F). split; auto. intros p q Hp Hq.
    assert (flip : forall p q, beside x v p q <> 0 -> beside x v q p <> 0) by (intros; rewrite beside_back; lra).
    change (p = q \/ beside x v p q <> 0). destruct Hp as [<-|[<-|[<-|[]]]], Hq as [<-|[<-|[<-|[]]]]; auto.
Qed.

Lemma crossing_said : forall x v T k, front T = origin \/ clear x v T -> (crossing_is x v T k <-> k = crossing x v T).
Proof.
  intros x v T k [E|C]; unfold crossing_is; cbv zeta.
  - rewrite crossing_flat, E by auto. replace (dot origin v) with 0 by (unfold dot; simpl; ring).
    split; [intros [(_ & _ & L)|[(_ & _ & L)|[H _]]]; try lra; auto|]. intros ->. right; right. split; auto.
      intros [_ H]. auto.
  - destruct (crossing_means x v T C) as [(E & H & L)|[(E & H & L)|(E & H)]]; rewrite E; fold (tips T) in H;
      fold (hits x v T) in H.
    + split; [|intros ->; left; auto]. intros [(K & _)|[(_ & _ & L')|(_ & N)]]; auto; [lra|]. exfalso. apply N. split;
        auto. lra.
    + split; [|intros ->; right; left; auto]. intros [(_ & _ & L')|[(K & _)|(_ & N)]]; auto; [lra|]. exfalso. apply N.
        split; auto. lra.
    + split; [|intros ->; right; right; tauto]. intros [(_ & N & _)|[(_ & N & _)|(K & _)]]; auto; contradiction.
Qed.

Theorem winding_said : forall M x v n, generic M x v -> (winding_is M x v n <-> n = winding M x v).
Proof.
  intros M x v n G. apply generic_said in G. unfold winding_is, winding. revert n.
  induction M as [|T M IH]; intros n; simpl; [tauto|].
  assert (C : forall k, crossing_is x v T k <-> k = crossing x v T) by (intros k; apply crossing_said, G; simpl; auto).
  assert (IH' := IH (fun T' H => G T' (or_intror H))). split.
  - intros (k & K & S). apply C in K. apply IH' in S. lia.
  - intros ->. exists (crossing x v T). split; [apply C; auto|]. apply IH'. lia.
Qed.
Corollary winding_exists : forall M x v, generic M x v -> exists n, winding_is M x v n.
Proof. intros M x v G. exists (winding M x v). apply winding_said; auto. Qed.

Lemma held_said : forall Ls x n, held_by Ls x n -> sum_is (is_in x) Ls n.
Proof.
  induction Ls as [|L Ls IH]; intros x n H; simpl in *; auto. destruct H as [[C H]|[C H]].
  - exists 1%Z. split; [left; auto|]. apply IH. auto.
  - exists 0%Z. split; [right; auto|]. apply IH. rewrite Z.sub_0_r. auto.
Qed.

Theorem tiled_said : forall M Ps, tiled M Ps ->
  (forall x v w n, generic M x v -> generic M x w -> winding_is M x v n -> winding_is M x w n /\ (0 <= n)%Z)
  /\ (forall x v n, generic M x v -> (forall L, In L Ps -> conv L x -> interior (conv L) x) ->
        winding_is M x v n -> sum_is (is_in x) Ps n)
  /\ (forall p, union Ps p <-> forall e, 0 < e -> exists x v n,
        norm2 (sub x p) < e * e /\ generic M x v /\ winding_is M x v n /\ (0 < n)%Z).
Proof.
  intros M Ps (C & O & N & S). split; [|split].
  - intros x v w n Gv Gw W. apply winding_said in W; auto. subst n. rewrite generic_said in Gv, Gw. split; [|apply O;
      auto].
    apply winding_said; [apply generic_said; auto|]. apply C; auto.
  - intros x v n G I W. apply winding_said in W; auto. subst n. apply held_said, N; auto. apply generic_said. auto.
  - intros p. rewrite <- S. unfold solid_of. split; intros H e He; destruct (H e He) as (x & v & R).
    + destruct R as (D & G & P0). apply generic_said in G. exists x, v, (winding M x v). split; auto. split; auto.
        split; auto.
      apply winding_said; auto.
    + destruct R as (n & D & G & W & P0). exists x, v. apply winding_said in W; auto. subst n. split; auto. split; auto.
      apply generic_said. auto.
Qed.
