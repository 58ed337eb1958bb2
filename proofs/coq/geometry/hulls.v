(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Hulls, interiors, balls and half-spaces. *)
Require Import Reals Lra Psatz List.
From Fathom.geometry Require Import meaning space.
Open Scope R_scope.

Lemma hull_in : forall (S : pt -> Prop) s, S s -> hull S s.
Proof. intros S s H C _ HS. auto. Qed.
Lemma hull_convex : forall S, convex (hull S).
Proof. intros S u v l Hl Hu Hv C HC HS. apply HC; [auto|apply Hu|apply Hv]; auto. Qed.
Lemma hull_mono : forall (S T : pt -> Prop) p, (forall s, S s -> T s) -> hull S p -> hull T p.
Proof. intros S T p H Hp. apply Hp. apply hull_convex. intros; apply hull_in; auto. Qed.

(* a convex combination of three points, unnormalised *)
Lemma hull3 : forall S u v w x a b c d,
  hull S u -> hull S v -> hull S w ->
  0 <= a -> 0 <= b -> 0 <= c -> 0 < d -> a + b + c = d ->
  d * px x = a * px u + b * px v + c * px w ->
  d * py x = a * py u + b * py v + c * py w ->
  d * pz x = a * pz u + b * pz v + c * pz w ->
  hull S x.
Proof.
  intros S u v w x a b c d Hu Hv Hw Ha Hb Hc Hd E X Y Z.
  destruct (Req_dec (a + b) 0) as [H0|H0].
  - assert (a = 0) by lra. assert (b = 0) by lra. assert (c = d) by lra. subst.
    replace x with w; auto. pteq; nra.
  - assert (Hab : 0 < a + b) by lra.
    set (y := add (scal (a/(a+b)) u) (scal (1 - a/(a+b)) v)).
    assert (Hy : hull S y).
    { apply hull_convex; auto. split.
      - apply Rmult_le_pos; auto. left. apply Rinv_0_lt_compat; auto.
      - apply Rmult_le_reg_r with (a+b); auto. field_simplify; lra. }
    replace x with (add (scal ((a+b)/d) y) (scal (1 - (a+b)/d) w)).
    + apply hull_convex; auto. split.
      * apply Rmult_le_pos; [lra|]. left. apply Rinv_0_lt_compat; auto.
      * apply Rmult_le_reg_r with d; auto. field_simplify; lra.
    + assert (c = d - (a + b)) by lra. subst c.
      pteq; apply Rmult_eq_reg_l with d; try lra;
        [rewrite X|rewrite Y|rewrite Z]; field; lra.
Qed.

Lemma hull_seg : forall S u v x a b,
  hull S u -> hull S v -> 0 <= a -> 0 <= b -> 0 < a + b ->
  (a+b) * px x = a * px u + b * px v ->
  (a+b) * py x = a * py u + b * py v ->
  (a+b) * pz x = a * pz u + b * pz v ->
  hull S x.
Proof.
  intros. apply (hull3 S u v v x a b 0 (a+b)); auto; lra.
Qed.

(* a half-space bound keeps its boundary points out of the interior *)
Lemma halfspace_not_interior : forall (S : pt -> Prop) n h t,
  0 < norm2 n -> (forall s, S s -> dot n s <= h) -> h <= dot n t -> ~ interior S t.
Proof.
  intros S n h t Hn HS Ht [e [He H]].
  set (k := e / (1 + norm2 n)).
  assert (Hk : 0 < k) by (apply Rdiv_lt_0_compat; lra).
  assert (Ek : e = k * (1 + norm2 n)) by (unfold k; field; lra).
  assert (S (add t (scal k n))).
  { apply H. replace (norm2 (sub (add t (scal k n)) t)) with (k * k * norm2 n)
      by (unfold norm2, dot; simpl; ring). rewrite Ek. 
    replace (k * (1 + norm2 n) * (k * (1 + norm2 n))) with
      (k*k * norm2 n + k*k*(1 + norm2 n + norm2 n * norm2 n)) by ring.
    assert (0 < k*k) by nra. nra. }
  apply HS in H0.
  replace (dot n (add t (scal k n))) with (dot n t + k * norm2 n) in H0
    by (unfold norm2, dot; simpl; ring).
  nra.
Qed.

Lemma hull_halfspace : forall (S : pt -> Prop) n h,
  (forall s, S s -> dot n s <= h) -> forall s, hull S s -> dot n s <= h.
Proof.
  intros S n h H s Hs. apply (Hs (fun s => dot n s <= h)); auto.
  intros u v l Hl Hu Hv.
  replace (dot n (add (scal l u) (scal (1 - l) v))) with (l * dot n u + (1-l) * dot n v)
    by (unfold dot; simpl; ring). nra.
Qed.
