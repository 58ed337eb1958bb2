(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Farkas' lemma, by Bartl's short induction on the number of vectors; and from it: a point is in the hull of a finite list,
   or some direction separates it from the list. *)
Require Import Reals Lra Psatz List.
From Fathom.geometry Require Import meaning space hulls.
Import ListNotations.
Open Scope R_scope.

(* points with a weight: vectors of R^4 *)
Record hpt := H { hp : pt; hw : R }.
Definition hdot u v := dot (hp u) (hp v) + hw u * hw v.
(* u - k v *)
Definition less (u : hpt) (k : R) (v : hpt) := H (sub (hp u) (scal k (hp v))) (hw u - k * hw v).

Lemma hpt_eq : forall u v, hp u = hp v -> hw u = hw v -> u = v.
Proof. intros [] []; simpl; intros; subst; auto. Qed.
Ltac heq := apply hpt_eq; simpl; [pteq|]; try ring.

Lemma hdot_less_l : forall u k v y, hdot (less u k v) y = hdot u y - k * hdot v y.
Proof. intros. unfold hdot, dot; simpl; ring. Qed.
Lemma hdot_less_r : forall u k v y, hdot y (less u k v) = hdot y u - k * hdot y v.
Proof. intros. unfold hdot, dot; simpl; ring. Qed.

(* b is a combination of the members of L with weights that are not negative *)
Fixpoint cone (L : list hpt) (b : hpt) : Prop :=
  match L with
  | [] => b = H origin 0
  | a :: L' => exists k, 0 <= k /\ cone L' (less b k a)
  end.

Lemma cone_shear : forall a x L c, (forall l, In l L -> hdot l x <= 0) ->
  cone (map (fun l => less l (hdot l x) a) L) c -> exists k, 0 <= k /\ cone L (less c k a).
Proof.
  intros a x. induction L as [|l L IH]; simpl; intros c HL Hc.
  - subst. exists 0. split; [lra|]. heq.
  - destruct Hc as (w & Hw & Hc). apply IH in Hc; auto. destruct Hc as (k & Hk & Hc).
    assert (Hl := HL l (or_introl eq_refl)).
    exists (k - w * hdot l x). split; [nra|]. exists w. split; auto.
    replace (less (less c (k - w * hdot l x) a) w l) with (less (less c w (less l (hdot l x) a)) k a); auto.
    heq.
Qed.

Lemma farkas : forall m L b, length L = m ->
  cone L b \/ exists y, (forall l, In l L -> hdot l y <= 0) /\ 0 < hdot b y.
Proof.
  induction m as [|m IH]; intros [|a L] b HL; try discriminate.
  - destruct (Req_dec (hdot b b) 0) as [E|E].
    + left. simpl. assert (N := norm2_nonneg (hp b)). assert (W := Rle_0_sqr (hw b)).
      unfold hdot in E. fold (norm2 (hp b)) in E. unfold Rsqr in W.
      apply hpt_eq; simpl; [apply norm2_zero; lra|]. assert (hw b * hw b = 0) by lra. nra.
    + right. exists b. split; [simpl; tauto|].
      assert (N := norm2_nonneg (hp b)). assert (W := Rle_0_sqr (hw b)).
      unfold hdot in *. fold (norm2 (hp b)) in *. unfold Rsqr in W. lra.
  - simpl in HL. inversion HL as [HL'].
    destruct (IH L b HL') as [C|(x & X1 & X2)].
    + left. exists 0. split; [lra|]. replace (less b 0 a) with b; auto. heq.
    + destruct (Rle_dec (hdot a x) 0) as [Ha|Ha].
      * right. exists x. split; auto. intros l [<-|Hl]; auto.
      * set (z := less (H origin 0) (- / hdot a x) x).
        assert (Ez : forall u, hdot u z = / hdot a x * hdot u x).
        { intros u. unfold z. rewrite hdot_less_r. unfold hdot, dot; simpl; ring. }
        assert (P0 : 0 < / hdot a x) by (apply Rinv_0_lt_compat; lra).
        assert (Za : hdot a z = 1) by (rewrite Ez; field; lra).
        assert (ZL : forall l, In l L -> hdot l z <= 0).
        { intros l Hl. rewrite Ez. specialize (X1 _ Hl). nra. }
        assert (Zb : 0 < hdot b z) by (rewrite Ez; apply Rmult_lt_0_compat; lra).
        destruct (IH (map (fun l => less l (hdot l z) a) L) (less b (hdot b z) a)) as [C|(y & Y1 & Y2)].
        { rewrite map_length. auto. }
        -- left. apply cone_shear in C; auto. destruct C as (k & Hk & C).
           exists (hdot b z + k). split; [lra|].
           replace (less b (hdot b z + k) a) with (less (less b (hdot b z) a) k a); auto. heq.
        -- right. exists (less y (hdot a y) z). split.
           ++ intros l [<-|Hl]; rewrite hdot_less_r; [rewrite Za; lra|].
              assert (G := Y1 (less l (hdot l z) a)). rewrite hdot_less_l in G.
              assert (hdot l y - hdot l z * hdot a y <= 0) by (apply G; apply in_map_iff; eauto). lra.
           ++ rewrite hdot_less_r. rewrite hdot_less_l in Y2. lra.
Qed.

Lemma cone_hull : forall (S : pt -> Prop) L p w, (forall s, In s L -> S s) -> cone (map (fun s => H s 1) L) (H p w) ->
  0 <= w /\ (w = 0 -> p = origin) /\ (0 < w -> hull S (scal (/ w) p)).
Proof.
  intros S. induction L as [|a L IH]; simpl; intros p w HL Hc.
  - inversion Hc. subst. repeat split; auto; lra.
  - destruct Hc as (k & Hk & Hc). unfold less in Hc; simpl in Hc. rewrite Rmult_1_r in Hc.
    destruct (IH _ _ (fun s Hs => HL s (or_intror Hs)) Hc) as (W & Z & C).
    assert (Ha : hull S a) by (apply hull_in; auto).
    assert (back : forall q : pt, sub p (scal k a) = q -> p = add q (scal k a)).
    { intros q <-. pteq; ring. }
    split; [lra|]. split.
    + intros ->. assert (E : k = 0) by lra. rewrite (back origin) by (apply Z; lra). rewrite E. pteq; ring.
    + intros Hw. destruct (Req_dec (w - k) 0) as [E|E].
      * rewrite (back _ (Z E)). replace k with w by lra.
        replace (scal (/ w) (add origin (scal w a))) with a; auto. pteq; field; lra.
      * assert (Hwk : 0 < w - k) by lra. specialize (C Hwk).
        apply (hull_seg S _ a _ (w - k) k C Ha); simpl; try lra; field; lra.
Qed.

Theorem conv_or_separated : forall L x, conv L x \/ exists n, forall s, In s L -> dot n s < dot n x.
Proof.
  intros L x. destruct (farkas _ (map (fun s => H s 1) L) (H x 1) eq_refl) as [C|(y & Y1 & Y2)].
  - left. apply (cone_hull (fun p => In p L)) in C; auto. destruct C as (_ & _ & C).
    replace x with (scal (/ 1) x) by (rewrite Rinv_1; apply scal_1). apply C. lra.
  - right. exists (hp y). intros s Hs. specialize (Y1 (H s 1)).
    unfold hdot in *; simpl in *. assert (dot s (hp y) + 1 * hw y <= 0).
    { apply Y1. apply in_map_iff. eauto. }
    rewrite (dot_comm _ s), (dot_comm _ x). lra.
Qed.
