(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Sums of multiples of vectors: spans, cones, linear independence. *)
Require Import Reals Lra Psatz List Lia.
From Fathom.geometry Require Import meaning bodies space norm.
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
