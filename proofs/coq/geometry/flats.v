(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Finite searches; and a finite list of points either spans space or lies in a plane. *)
Require Import Reals Lra Psatz List.
From Fathom.geometry Require Import meaning space hulls.
Import ListNotations.
Open Scope R_scope.

(* ---- finite searches ---- *)
Lemma some_or_none : forall (X : Type) (f : X -> R) (l : list X),
  (exists x, In x l /\ f x <> 0) \/ (forall x, In x l -> f x = 0).
Proof.
  induction l as [|x l IH]; [right; simpl; tauto|].
  destruct (Req_dec (f x) 0) as [E|E]; [|left; exists x; simpl; auto].
  destruct IH as [(y & Hy & Ey)|IH]; [left; exists y; simpl; auto|].
  right. intros y [<-|Hy]; auto.
Qed.

Lemma all_or_some : forall (X : Type) (bad : X -> Prop) (good : X -> R -> Prop) (l : list X),
  (forall x e e', 0 < e' <= e -> good x e -> good x e') ->
  (forall x, In x l -> bad x \/ exists e, 0 < e /\ good x e) ->
  (exists x, In x l /\ bad x) \/ exists e, 0 < e /\ forall x, In x l -> good x e.
Proof.
  intros X bad good l mono. induction l as [|x l IH]; intros Hl.
  - right. exists 1. split; [lra|simpl; tauto].
  - destruct (Hl x (or_introl eq_refl)) as [B|(e & He & G)]; [left; exists x; simpl; auto|].
    destruct IH as [(y & Hy & B)|(e' & He' & G')]; [intros y Hy; apply Hl; simpl; auto|left; exists y; simpl; auto|].
    right. exists (Rmin e e'). split; [apply Rmin_glb_lt; auto|].
    assert (M1 := Rmin_l e e'). assert (M2 := Rmin_r e e').
    assert (0 < Rmin e e') by (apply Rmin_glb_lt; auto).
    intros y [<-|Hy]; [apply (mono x e)|apply (mono y e')]; auto; lra.
Qed.

Lemma keep : forall (X : Type) (p : X -> Prop) (l : list X), (forall x, p x \/ ~ p x) ->
  exists F, (forall x, In x F -> p x) /\ (forall x, In x l -> p x -> In x F).
Proof.
  intros X p l dec. induction l as [|x l (F & F1 & F2)]; [exists []; simpl; tauto|].
  destruct (dec x) as [D|D].
  - exists (x :: F). split; [intros y [<-|Hy]; auto|]. intros y [<-|Hy] Py; simpl; auto.
  - exists F. split; auto. intros y [<-|Hy] Py; [contradiction|auto].
Qed.

Lemma all_le_dec : forall (f : pt -> R) c l, (forall s, In s l -> f s <= c) \/ (exists s, In s l /\ c < f s).
Proof.
  induction l as [|x l IH]; [left; simpl; tauto|].
  destruct (Rle_dec (f x) c) as [L|L]; [|right; exists x; simpl; split; auto; lra].
  destruct IH as [IH|(y & Hy & Ly)]; [left|right; exists y; simpl; auto].
  intros y [<-|Hy]; auto.
Qed.

(* ---- flat or spanning ---- *)
Definition spanning (L : list pt) : Prop :=
  exists a b c d, In a L /\ In b L /\ In c L /\ In d L /\ det (sub b a) (sub c a) (sub d a) <> 0.
Definition flat (L : list pt) : Prop := exists n h, n <> origin /\ forall s, In s L -> dot n s = h.

Lemma perpendicular : forall u, exists d, d <> origin /\ dot u d = 0.
Proof.
  intros [x y z]. destruct (Req_dec (x * x + y * y) 0) as [E|E].
  - exists (mk 1 0 0). split.
    + intros F. inversion F. lra.
    + assert (x = 0) by nra. unfold dot; simpl; subst; ring.
  - exists (mk (- y) x 0). split.
    + intros F. inversion F. subst. apply E. assert (y = 0) by lra. subst. ring.
    + unfold dot; simpl; ring.
Qed.

(* three vectors in one plane through O *)
Lemma det_flat : forall d u v w, d <> origin -> dot u d = 0 -> dot v d = 0 -> dot w d = 0 -> det u v w = 0.
Proof.
  intros d u v w Hd U V W. assert (N := norm2_pos _ Hd).
  assert (E : norm2 d * det u v w
    = dot u d * dot d (cross v w) + dot v d * dot d (cross w u) + dot w d * dot d (cross u v)).
  { unfold norm2, det, dot, cross; simpl; ring. }
  rewrite U, V, W in E. apply Rmult_eq_reg_l with (norm2 d); lra.
Qed.

Lemma parallel : forall u v, cross u v = origin -> u <> origin -> v = scal (dot v u / norm2 u) u.
Proof.
  intros u v Hc Hu. assert (N := norm2_pos _ Hu).
  assert (X := f_equal px Hc). assert (Y := f_equal py Hc). assert (Z := f_equal pz Hc).
  unfold cross, origin in *. simpl in *. unfold norm2, dot in *.
  destruct u as [a b c], v as [d e f]. simpl in *.
  assert (G : forall p q, (a * a + b * b + c * c) * p = (d * a + e * b + f * c) * q ->
    p = (d * a + e * b + f * c) / (a * a + b * b + c * c) * q).
  { intros p q E. apply Rmult_eq_reg_l with (a * a + b * b + c * c); [|lra]. rewrite E. field. lra. }
  pteq; apply G.
  - assert (b * (a * e - b * d) = 0) by (rewrite Z; ring). assert (c * (c * d - a * f) = 0) by (rewrite Y; ring). lra.
  - assert (a * (a * e - b * d) = 0) by (rewrite Z; ring). assert (c * (b * f - c * e) = 0) by (rewrite X; ring). lra.
  - assert (a * (c * d - a * f) = 0) by (rewrite Y; ring). assert (b * (b * f - c * e) = 0) by (rewrite X; ring). lra.
Qed.

Lemma perp_not_parallel : forall n u v, dot n u = 0 -> u <> origin -> dot n v <> 0 -> cross u v <> origin.
Proof.
  intros n u v E Hu Hv Hc. apply Hv. rewrite (parallel u v Hc Hu), dot_scal_r, E. ring.
Qed.

Lemma spanning_or_flat : forall L, spanning L \/ flat L.
Proof.
  intros [|a L].
  { right. exists (mk 1 0 0), 0. split; [intros F; inversion F; lra|simpl; tauto]. }
  set (M := a :: L). assert (Ia : In a M) by (simpl; auto).
  assert (look : forall n, n <> origin -> (exists s, In s M /\ dot n (sub s a) <> 0) \/ flat M).
  { intros n Hn. destruct (some_or_none _ (fun s => dot n (sub s a)) M) as [F|F]; auto.
    right. exists n, (dot n a). split; auto. intros s Hs. specialize (F s Hs). simpl in F.
    rewrite dot_sub_r in F. lra. }
  destruct (look (mk 1 0 0)) as [(b & Ib & B)|F]; auto. { intros F; inversion F; lra. }
  assert (Hb : sub b a <> origin).
  { intros E. apply B. rewrite E. unfold dot; simpl; ring. }
  destruct (perpendicular (sub b a)) as (n & Hn & En).
  destruct (look n Hn) as [(c & Ic & C)|F]; auto.
  assert (Hc : cross (sub b a) (sub c a) <> origin).
  { apply (perp_not_parallel n); auto. rewrite dot_comm; auto. }
  destruct (look _ Hc) as [(d & Id & D)|F]; auto.
  left. exists a, b, c, d. repeat split; auto. intros E. apply D. rewrite <- E.
  unfold det, dot, cross; simpl; ring.
Qed.

Lemma flat_no_interior : forall L t, flat L -> ~ interior (conv L) t.
Proof.
  intros L t (n & h & Hn & HL) Hi. destruct (Rle_dec h (dot n t)) as [C|C].
  - revert Hi. apply (halfspace_not_interior _ n h); auto. { apply norm2_pos; auto. }
    apply hull_halfspace. intros s Hs. rewrite HL by auto. lra.
  - revert Hi. apply (halfspace_not_interior _ (scal (-1) n) (- h)).
    + rewrite norm2_scal. assert (N := norm2_pos _ Hn). lra.
    + apply hull_halfspace. intros s Hs. rewrite dot_scal_l, HL by auto. lra.
    + rewrite dot_scal_l. lra.
Qed.

