(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Bodies that are turned by quaternions of any length, and what directions show that two of them are apart. *)
Require Import Reals Lra Psatz.
From Fathom.geometry Require Import meaning space.
Open Scope R_scope.

(* ---- turns ---- *)
Definition rotate (r : R) (v x : pt) : pt :=
  add (scal (r * r - norm2 v) x) (scal 2 (add (scal (dot v x) v) (scal r (cross v x)))).
Definition minus (v : pt) : pt := scal (-1) v.
Notation sq r v := (r * r + norm2 v).

Lemma rotate_dot : forall r v x y, dot (rotate r v x) y = dot x (rotate r (minus v) y).
Proof. intros r [a b c] [x y z] [x' y' z']. unfold rotate, minus, norm2, dot, cross; simpl. ring. Qed.
Lemma rotate_back : forall r v x, rotate r (minus v) (rotate r v x) = scal (sq r v * sq r v) x.
Proof. intros r [a b c] [x y z]. unfold rotate, minus, norm2, dot, cross. pteq; ring. Qed.
Lemma rotate_forth : forall r v x, rotate r v (rotate r (minus v) x) = scal (sq r v * sq r v) x.
Proof. intros r [a b c] [x y z]. unfold rotate, minus, norm2, dot, cross. pteq; ring. Qed.
Lemma rotate_dots : forall r v x y, dot (rotate r v x) (rotate r v y) = sq r v * sq r v * dot x y.
Proof. intros. rewrite rotate_dot, rotate_back, dot_scal_r. reflexivity. Qed.
Lemma rotate_cross : forall r v x y, cross (rotate r v x) (rotate r v y) = scal (sq r v) (rotate r v (cross x y)).
Proof. intros r [a b c] [x y z] [x' y' z']. unfold rotate, norm2, dot, cross. pteq; ring. Qed.
Lemma rotate_scal : forall r v k x, rotate r v (scal k x) = scal k (rotate r v x).
Proof. intros r [a b c] k [x y z]. unfold rotate, norm2, dot, cross. pteq; ring. Qed.
Lemma rotate_add : forall r v x y, rotate r v (add x y) = add (rotate r v x) (rotate r v y).
Proof. intros r [a b c] [x y z] [x' y' z']. unfold rotate, norm2, dot, cross. pteq; ring. Qed.
Lemma rotate_units : forall k r v x, rotate (k * r) (scal k v) x = scal (k * k) (rotate r v x).
Proof. intros k r [a b c] [x y z]. unfold rotate, norm2, dot, cross. pteq; ring. Qed.
Lemma sq_units : forall k r v, sq (k * r) (scal k v) = k * k * sq r v.
Proof. intros. rewrite norm2_scal. ring. Qed.
Lemma sq_zero : forall r v x, ~ 0 < sq r v -> sq r v = 0 /\ rotate r v x = origin /\ rotate r (minus v) x = origin.
Proof.
  intros r v x H. assert (N := norm2_nonneg v). assert (S : 0 <= r * r) by nra.
  assert (Zr : r = 0) by nra. assert (Zv : v = origin) by (apply norm2_zero; nra). subst.
  unfold rotate, minus, norm2, dot, cross, origin. repeat split; try (pteq; ring). simpl. ring.
Qed.

Definition place (p : pt) (r : R) (v x : pt) : pt := add p (scal (/ sq r v) (rotate r v x)).

(* distances and senses are kept, and all of space is reached: so it is a rigid motion *)
Theorem placed_rigid : forall o, 0 < length2 o ->
  (forall x y, norm2 (sub (placed o x) (placed o y)) = norm2 (sub x y)) /\ forall q, exists x, placed o x = q.
Proof.
  intros o H. unfold length2 in H. split.
  - intros x y. replace (sub (placed o x) (placed o y)) with (scal (/ length2 o) (rotate (scalar o) (axis o) (sub x
    y))).
    + rewrite norm2_scal. unfold norm2 at 1. rewrite rotate_dots. unfold length2. fold (norm2 (sub x y)). field. lra.
    + unfold placed, rotate, cross, dot. pteq; ring.
  - intros q. exists (scal (/ length2 o) (rotate (scalar o) (minus (axis o)) (sub q (spot o)))).
    change (place (spot o) (scalar o) (axis o) (scal (/ length2 o) (rotate (scalar o) (minus (axis o)) (sub q (spot
      o)))) = q).
    unfold place. rewrite rotate_scal, rotate_forth, !scal_scal. unfold length2.
    replace (_ * _ * _) with 1 by (field; lra). rewrite scal_1. pteq; ring.
Qed.
Theorem placed_sense : forall o w x y, 0 < length2 o ->
  cross (sub (placed o x) (placed o w)) (sub (placed o y) (placed o w)) = sub (placed o (add w (cross (sub x w) (sub y
    w)))) (placed o w).
Proof.
  intros o w x y H. unfold length2 in H.
  assert (D : forall a b, sub (placed o a) (placed o b) = scal (/ length2 o) (rotate (scalar o) (axis o) (sub a b)))
    by (intros; unfold placed, rotate, cross, dot; pteq; ring).
  rewrite !D. replace (sub (add w (cross (sub x w) (sub y w))) w) with (cross (sub x w) (sub y w)) by (pteq; ring).
  assert (C := rotate_cross (scalar o) (axis o) (sub x w) (sub y w)). set (X := rotate _ _ (sub x w)) in *.
  set (Y := rotate _ _ (sub y w)) in *.
  set (Z := rotate _ _ (cross _ _)) in *.
  replace (cross (scal (/ length2 o) X) (scal (/ length2 o) Y)) with (scal (/ length2 o * / length2 o) (cross X Y))
    by (pteq; ring). rewrite C, scal_scal. unfold length2. f_equal. field. lra.
Qed.

(* ---- what the three kinds of directions show ---- *)
Section Directions.
  Variables (pa pb : pt) (ra rb : R) (va vb : pt).
  Let wa := sq ra va.
  Let wb := sq rb vb.
  Let d := sub pa pb.

  Definition shown (D : R) (u v : pt) : Prop := forall a b, 0 < D + dot u a - dot v b ->
    0 < wa /\ 0 < wb /\ exists n, dot n (sub (place pa ra va a) (place pb rb vb b)) > 0.
  Definition shown_by (D : R) (u v n : pt) (k : R) : Prop := 0 < wa -> 0 < wb -> 0 < k /\ forall a b,
    D + dot u a - dot v b = k * dot n (sub (place pa ra va a) (place pb rb vb b)).

  Lemma place_dot : forall n a b, 0 < wa -> 0 < wb -> wa * wb * dot n (sub (place pa ra va a) (place pb rb vb b))
    = wa * wb * dot n d + wb * dot n (rotate ra va a) - wa * dot n (rotate rb vb b).
  Proof. intros. unfold place. rewrite dot_sub_r, !dot_add_r, !dot_scal_r. unfold d. rewrite dot_sub_r. fold wa wb.
  field. lra. Qed.

  Lemma by_b : forall n, let h := rotate rb vb n in
    shown_by (wa * dot h d) (rotate ra (minus va) h) (scal (wa * wb) n) h wa.
  Proof.
    intros n h Pa Pb. split; auto. intros a b. apply Rmult_eq_reg_l with wb; [|lra].
    replace (wb * (wa * _)) with (wa * wb * dot h (sub (place pa ra va a) (place pb rb vb b))) by ring.
    rewrite place_dot by auto.
    assert (E : dot h (rotate rb vb b) = wb * wb * dot n b) by apply rotate_dots.
    assert (F : dot (rotate ra (minus va) h) a = dot h (rotate ra va a)) by (rewrite dot_comm, <- rotate_dot;
      apply dot_comm).
    rewrite E, F, dot_scal_l. ring.
  Qed.
  Lemma by_a : forall n, let h := rotate ra va n in
    shown_by (wb * dot h d) (scal (wa * wb) n) (rotate rb (minus vb) h) h wb.
  Proof.
    intros n h Pa Pb. split; auto. intros a b. apply Rmult_eq_reg_l with wa; [|lra].
    replace (wa * (wb * _)) with (wa * wb * dot h (sub (place pa ra va a) (place pb rb vb b))) by ring.
    rewrite place_dot by auto.
    assert (E : dot h (rotate ra va a) = wa * wa * dot n a) by apply rotate_dots.
    assert (F : dot (rotate rb (minus vb) h) b = dot h (rotate rb vb b)) by (rewrite dot_comm, <- rotate_dot;
      apply dot_comm).
    rewrite E, F, dot_scal_l. ring.
  Qed.
  Lemma by_edges : forall f g, let h := rotate ra va f in let k := rotate rb vb g in
    shown_by (dot (cross h k) d) (cross f (rotate ra (minus va) k)) (cross (rotate rb (minus vb) h) g) (cross h k) 1.
  Proof.
    intros f g h k Pa Pb. split; [lra|]. intros a b. apply Rmult_eq_reg_l with (wa * wb); [|nra].
    rewrite Rmult_1_l, place_dot by auto.
    assert (T : forall x y z, dot (cross x y) z = dot y (cross z x)) by (intros; unfold dot, cross; simpl; ring).
    assert (E : dot (cross h k) (rotate ra va a) = wa * dot (cross f (rotate ra (minus va) k)) a).
    { rewrite T. unfold h. rewrite rotate_cross, dot_scal_r, (dot_comm k), rotate_dot. fold wa. f_equal.
      unfold dot, cross; simpl; ring. }
    assert (F : dot (cross h k) (rotate rb vb b) = wb * dot (cross (rotate rb (minus vb) h) g) b).
    { replace (dot (cross h k) (rotate rb vb b)) with (dot h (cross k (rotate rb vb b))) by (unfold dot, cross; simpl;
      ring).
      unfold k. rewrite rotate_cross, dot_scal_r, (dot_comm h), rotate_dot. fold wb. f_equal.
      unfold dot, cross; simpl; ring. }
    rewrite E, F. ring.
  Qed.

  (* each is 0 if a quaternion is *)
  Lemma shown_ok : forall D u v n k, shown_by D u v n k ->
    (~ 0 < wa -> forall a b, D + dot u a - dot v b = 0) -> (~ 0 < wb -> forall a b,
      D + dot u a - dot v b = 0) -> shown D u v.
  Proof.
    intros D u v n k H Za Zb a b P. destruct (Rlt_dec 0 wa) as [Pa|Na]; [|rewrite Za in P by auto; lra].
    destruct (Rlt_dec 0 wb) as [Pb|Nb]; [|rewrite Zb in P by auto; lra]. split; auto. split; auto.
    destruct (H Pa Pb) as [K E]. exists n. rewrite E in P. apply Rlt_gt, Rmult_lt_reg_l with k; lra.
  Qed.

  Ltac zero := unfold dot, cross, scal, origin; simpl; ring.
  Lemma b_shows : forall n, let h := rotate rb vb n in shown (wa * dot h d) (rotate ra (minus va) h) (scal (wa * wb) n).
  Proof.
    intros n h. apply (shown_ok _ _ _ _ _ (by_b n)); intros N a b; fold h.
    - destruct (sq_zero _ _ h N) as (Z & _ & ->). fold wa in Z. rewrite Z. zero.
    - unfold h. destruct (sq_zero _ _ n N) as (Z & -> & _). fold wb in Z. rewrite Z. unfold rotate. zero.
  Qed.
  Lemma a_shows : forall n, let h := rotate ra va n in shown (wb * dot h d) (scal (wa * wb) n) (rotate rb (minus vb) h).
  Proof.
    intros n h. apply (shown_ok _ _ _ _ _ (by_a n)); intros N a b; fold h.
    - unfold h. destruct (sq_zero _ _ n N) as (Z & -> & _). fold wa in Z. rewrite Z. unfold rotate. zero.
    - destruct (sq_zero _ _ h N) as (Z & _ & ->). fold wb in Z. rewrite Z. zero.
  Qed.
  Lemma edges_show : forall f g, let h := rotate ra va f in let k := rotate rb vb g in
    shown (dot (cross h k) d) (cross f (rotate ra (minus va) k)) (cross (rotate rb (minus vb) h) g).
  Proof.
    intros f g h k. apply (shown_ok _ _ _ _ _ (by_edges f g)); intros N a b; fold h k.
    - destruct (sq_zero _ _ k N) as (_ & _ & ->). unfold h. destruct (sq_zero _ _ f N) as (_ & -> & _).
      unfold rotate. zero.
    - destruct (sq_zero _ _ h N) as (_ & _ & ->). unfold k. destruct (sq_zero _ _ g N) as (_ & -> & _).
      unfold rotate. zero.
  Qed.
End Directions.
