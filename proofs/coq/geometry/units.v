(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Bodies in other units: everything scaled by k > 0.  (scaling.v has the same for the claims of format 1.) *)
Require Import Reals Lra Psatz List.
From Fathom.checker Require Import sequence body.
From Fathom.geometry Require Import meaning bodies space norm hulls signed_depth.
Import ListNotations.
Open Scope R_scope.

Lemma interior_scal_set : forall (S T : pt -> Prop) k t, 0 < k -> (forall p, S p -> T (scal k p)) -> interior S t -> interior T (scal k t).
Proof.
  intros S T k t Hk H (e & He & G). assert (0 < / k) by (apply Rinv_0_lt_compat; auto).
  exists (k * e). split; [nra|]. intros s Hs. replace s with (scal k (scal (/ k) s)) by (rewrite scal_scal, Rinv_r by lra; apply scal_1).
  apply H, G. replace (sub (scal (/ k) s) t) with (scal (/ k) (sub s (scal k t))) by (pteq; field; lra).
  rewrite norm2_scal. apply Rmult_lt_reg_l with (k * k); [nra|].
  replace (k * k * (/ k * / k * norm2 (sub s (scal k t)))) with (norm2 (sub s (scal k t))) by (field; lra). lra.
Qed.

Lemma at_least_scal : forall (S T : pt -> Prop) k x, 0 < k -> (forall p, S p -> T (scal k p)) -> at_least S x -> at_least T (k * x).
Proof.
  intros S T k x Hk H [H0 H1]. assert (0 < / k) by (apply Rinv_0_lt_compat; auto). split.
  - intros Hx t Ht. assert (X : 0 < x) by (apply Rmult_lt_reg_l with k; lra).
    destruct (H0 X (scal (/ k) t)) as (e & He & G).
    { rewrite norm2_scal. apply Rmult_lt_reg_l with (k * k); [nra|].
      replace (k * k * (/ k * / k * norm2 t)) with (norm2 t) by (field; lra). lra. }
    rewrite <- (scal_1 t), <- (Rinv_r k), <- scal_scal by lra. apply (interior_scal_set S); auto. exists e. auto.
  - intros Hx. assert (X : x <= 0) by (apply Rmult_le_reg_l with k; lra).
    destruct (H1 X) as (p & Hp & N). exists (scal k p). split; auto. rewrite norm2_scal.
    replace (k * x * (k * x)) with (k * k * (x * x)) by ring. apply Rmult_le_compat_l; nra.
Qed.

Definition scale_core (k : R) (c : core pt R) : core pt R := map_core (scal k) (Rmult (k * k)) c.
Definition scale_body (k : R) (b : body pt R) : body pt R := map_body (scal k) (Rmult (k * k)) (Rmult k) b.

Lemma scale_back : forall k b, 0 < k -> scale_body (/ k) (scale_body k b) = b.
Proof.
  intros k [c r] Hk. assert (E : forall u, scal (/ k) (scal k u) = u) by (intros; rewrite scal_scal, Rinv_l by lra;
    apply scal_1).
  unfold scale_body, map_body. cbn [core_of radius]. f_equal; [|field; lra]. destruct c as [L|ts|n d]; cbn [map_core];
    rewrite ?each_map, ?map_map; f_equal.
  - rewrite <- (map_id L) at 2. apply map_ext. auto.
  - rewrite <- (map_id ts) at 2. apply map_ext. intros t. rewrite !each_map, map_map. rewrite <- (map_id t) at 2.
      apply map_ext.
    intros [a u v w]. unfold map_atom. cbn [center axis_u axis_v axis_w]. rewrite !E. auto.
  - auto.
  - field. lra.
Qed.

Lemma hull_scal : forall (S T : pt -> Prop) k p, (forall s, S s -> T (scal k s)) -> hull S p -> hull T (scal k p).
Proof.
  intros S T k p H Hp. apply (Hp (fun p => hull T (scal k p))).
  - intros u v l Hl Hu Hv. replace (scal k (add (scal l u) (scal (1 - l) v)))
      with (add (scal l (scal k u)) (scal (1 - l) (scal k v))) by (pteq; ring). apply hull_convex; auto.
  - intros s Hs. apply hull_in; auto.
Qed.

Lemma in_core_scal : forall k c p, 0 < k -> in_core c p -> in_core (scale_core k c) (scal k p).
Proof.
  intros k [L|ts|n d] p Hk; unfold scale_core; simpl.
  - rewrite each_map. apply hull_scal. intros s Hs. apply in_map; auto.
  - rewrite each_map. revert p. induction ts as [|t ts IH]; simpl; intros p.
    + intros ->. pteq; ring.
    + intros (s & q & Hs & Hq & ->). exists (scal k s), (scal k q). split; [|split; auto; pteq; ring].
      revert Hs. apply hull_scal. intros x (a & Ia & y & z & w & B & ->).
      exists (map_atom (scal k) a). split; [rewrite each_map; apply in_map; auto|]. exists y, z, w. split; auto. pteq; ring.
  - rewrite dot_scal_l, dot_scal_r, <- Rmult_assoc. intros H. apply Rmult_le_compat_l; [nra|auto].
Qed.

Lemma in_core_scal_inv : forall k c p, 0 < k -> in_core (scale_core k c) p -> in_core c (scal (/ k) p).
Proof.
  intros k [L|ts|n d] p Hk; unfold scale_core; simpl; assert (Hi : 0 < / k) by (apply Rinv_0_lt_compat; auto);
    assert (E : forall u, scal (/ k) (scal k u) = u) by (intros; rewrite scal_scal, Rinv_l by lra; apply scal_1).
  - rewrite each_map. apply hull_scal. intros s Hs. apply in_map_iff in Hs. destruct Hs as (x & <- & Hx). rewrite E. auto.
  - rewrite each_map. revert p. induction ts as [|t ts IH]; simpl; intros p.
    + intros ->. pteq; ring.
    + intros (s & q & Hs & Hq & ->). exists (scal (/ k) s), (scal (/ k) q). split; [|split; auto; pteq; ring].
      revert Hs. apply hull_scal. intros x (a & Ia & y & z & w & B & ->). rewrite each_map in Ia.
      apply in_map_iff in Ia. destruct Ia as (b & <- & Ib). exists b. split; auto. exists y, z, w. split; auto.
      rewrite <- (E (add (center b) _)). f_equal. pteq; ring.
  - rewrite dot_scal_l, dot_scal_r. intros H. apply Rmult_le_reg_l with (k * k); [nra|].
    replace (k * k * (/ k * dot n p)) with (k * dot n p) by (field; lra). auto.
Qed.

Lemma scal_back : forall k u, 0 < k -> scal k (scal (/ k) u) = u.
Proof. intros. rewrite scal_scal, Rinv_r by lra. apply scal_1. Qed.

Lemma scaled_difference : forall k p a b, 0 < k -> scal k p = sub b a -> p = sub (scal (/ k) b) (scal (/ k) a).
Proof.
  intros k p a b Hk E. transitivity (scal (/ k) (scal k p)); [rewrite scal_scal, Rinv_l by lra; symmetry; apply scal_1|].
  rewrite E. pteq; ring.
Qed.

Lemma core_gaps_scal : forall k A B p, 0 < k -> (core_gaps (scale_body k A) (scale_body k B) (scal k p) <-> core_gaps A B p).
Proof.
  intros k A B p Hk. split.
  - intros (b & a & Hb & Ha & E). exists (scal (/ k) b), (scal (/ k) a).
    split; [apply in_core_scal_inv; auto|]. split; [apply in_core_scal_inv; auto|]. apply scaled_difference; auto.
  - intros (b & a & Hb & Ha & ->). exists (scal k b), (scal k a). repeat split; try (apply in_core_scal; auto). pteq; ring.
Qed.

Lemma planed_scal : forall (S T : pt -> Prop) k x, 0 < k -> (forall p, T p -> S (scal k p)) -> planed S (k * x) -> planed T x.
Proof.
  intros S T k x Hk H (n & h & Hn & Hb & L). assert (Hi : 0 < / k) by (apply Rinv_0_lt_compat; auto).
  exists n, (/ k * h). split; auto. split.
  - intros p Hp. apply H, Hb in Hp. rewrite dot_scal_r in Hp.
    replace (dot n p) with (/ k * (k * dot n p)) by (field; lra). apply Rmult_le_compat_l; lra.
  - replace (x * norm n) with (/ k * (k * x * norm n)) by (field; lra). apply Rmult_le_compat_l; lra.
Qed.

Lemma comparable_scal : forall k c d, comparable (scale_core k c) (scale_core k d) -> comparable c d.
Proof.
  assert (bounded : forall k c, bounded_core (scale_core k c) -> bounded_core c).
  { intros k [L|ts|n o]; simpl; auto; rewrite each_map.
    - destruct L; auto. discriminate.
    - rewrite Forall_map. apply Forall_impl. intros t. rewrite each_map. destruct t; auto. discriminate. }
  assert (half : forall k c, half_space_core (scale_core k c) -> half_space_core c).
  { intros k [L|ts|n o] (m & d & E & Hm); try discriminate. simpl in E. inversion E; subst. exists n, o. split; auto.
    intros ->. apply Hm. pteq; ring. }
  intros k c d. unfold comparable. intros [[H1 H2]|[[H1 H2]|[H1 H2]]]; eauto 6.
Qed.
