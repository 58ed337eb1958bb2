(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Curved bodies: how far they reach in a direction (Cauchy-Schwarz), points inside them, half-spaces, other units. *)
Require Import Reals Lra Psatz List.
From Fathom.checker Require Import sequence body.
From Fathom.geometry Require Import meaning bodies space hulls difference minkowski rounded.
Import ListNotations.
Open Scope R_scope.

(* ---- cores are convex ---- *)
Lemma sum_of_convex : forall S T, convex S -> convex T -> convex (sum_of S T).
Proof.
  intros S T HS HT u v l Hl (a & b & Ha & Hb & ->) (a' & b' & Ha' & Hb' & ->).
  exists (add (scal l a) (scal (1 - l) a')), (add (scal l b) (scal (1 - l) b')). repeat split; auto. pteq; ring.
Qed.
Lemma difference_of_convex : forall S T, convex S -> convex T -> convex (difference_of S T).
Proof.
  intros S T HS HT u v l Hl (a & b & Ha & Hb & ->) (a' & b' & Ha' & Hb' & ->).
  exists (add (scal l a) (scal (1 - l) a')), (add (scal l b) (scal (1 - l) b')). repeat split; auto. pteq; ring.
Qed.
Lemma in_terms_convex : forall ts, convex (in_terms ts).
Proof.
  induction ts as [|t ts IH]; simpl.
  - intros u v l _ -> ->. pteq; ring.
  - apply sum_of_convex; auto. apply hull_convex.
Qed.
Lemma in_core_convex : forall c, convex (in_core c).
Proof.
  intros [L|ts|n d]; simpl; [apply hull_convex|apply in_terms_convex|].
  intros u v l Hl Hu Hv. rewrite dot_add_r, !dot_scal_r. nra.
Qed.

(* ---- how far they reach ---- *)
(* the plane <s, x> = h is beyond the atom: its distance from the center is at least the atom's reach *)
Definition atom_beneath (s : pt) (h : R) (a : atom pt) : Prop :=
  let g := h - dot s (center a) in
  let u := dot s (axis_u a) in let v := dot s (axis_v a) in let w := dot s (axis_w a) in
  0 <= g /\ u * u + v * v + w * w <= g * g.

Lemma in_atom_beneath : forall s h a, atom_beneath s h a -> beneath (in_atom a) s h.
Proof.
  intros s h a [G0 G1] p (x & y & z & B & ->). rewrite !dot_add_r, !dot_scal_r.
  set (g := h - dot s (center a)) in *. set (u := dot s (axis_u a)) in *.
  set (v := dot s (axis_v a)) in *. set (w := dot s (axis_w a)) in *.
  assert (C := cauchy (mk x y z) (mk u v w)). unfold norm2, dot in C; simpl in C.
  set (d := x * u + y * v + z * w) in *.
  assert (Q : 0 <= u * u + v * v + w * w) by nra.
  assert (d * d <= g * g) by nra.
  assert (d <= g) by (apply Rnot_lt_le; intros L; nra).
  unfold d, g in *. lra.
Qed.

Lemma in_term_beneath : forall s h t, (forall a, In a t -> atom_beneath s h a) -> beneath (in_term t) s h.
Proof.
  intros s h t H p Hp. revert p Hp. apply hull_halfspace. intros p (a & Ia & Hp). apply (in_atom_beneath s h a); auto.
Qed.

Lemma sum_of_beneath : forall S T n h k, beneath S n h -> beneath T n k -> beneath (sum_of S T) n (h + k).
Proof. intros S T n h k HS HT p (s & t & Hs & Ht & ->). rewrite dot_add_r. apply Rplus_le_compat; auto. Qed.

Lemma in_terms_beneath : forall n ts hs, Forall2 (fun t h => beneath (in_term t) n h) ts hs ->
  beneath (in_terms ts) n (fold_right Rplus 0 hs).
Proof.
  intros n ts hs H. induction H as [|t h ts hs H _ IH]; simpl.
  - intros p ->. rewrite dot_origin_r. lra.
  - apply sum_of_beneath; auto.
Qed.

Lemma difference_of_beneath : forall S T n h k, beneath T n h -> beneath S (scal (-1) n) k ->
  beneath (difference_of T S) n (h + k).
Proof.
  intros S T n h k HT HS p (t & s & Ht & Hs & ->). rewrite dot_sub_r.
  specialize (HT t Ht). specialize (HS s Hs). rewrite dot_scal_l in HS. lra.
Qed.

(* ---- points inside ---- *)
Lemma in_term_atom : forall t a p, In a t -> in_atom a p -> in_term t p.
Proof. intros t a p Ia Hp. apply hull_in. exists a. auto. Qed.

Lemma at_least_mono : forall (S T : pt -> Prop) x, (forall p, S p -> T p) -> at_least S x -> at_least T x.
Proof.
  intros S T x H [H0 H1]. split.
  - intros Hx t Ht. destruct (H0 Hx t Ht) as (e & He & G). exists e. auto.
  - intros Hx. destruct (H1 Hx) as (p & Hp & N). exists p. auto.
Qed.

Lemma conv_in_convex : forall L (S : pt -> Prop), convex S -> (forall p, In p L -> S p) -> forall p, conv L p -> S p.
Proof. intros L S HS H p Hp. apply Hp; auto. Qed.

Lemma P_in_difference : forall A B S T, convex S -> convex T -> (forall p, In p A -> S p) -> (forall p, In p B -> T p) ->
  forall p, P A B p -> difference_of T S p.
Proof.
  intros A B S T HS HT HA HB p Hp. apply P_minkowski in Hp. destruct Hp as (a & b & Ha & Hb & ->).
  exists b, a. repeat split; [apply (conv_in_convex B)|apply (conv_in_convex A)]; auto.
Qed.

(* one point of S at most -x away from O *)
Lemma point_least : forall (S : pt -> Prop) p x, S p -> x <= 0 -> norm2 p <= x * x -> at_least S x.
Proof. intros S p x Hp Hx N. split; [lra|]. intros _. exists p. auto. Qed.

(* ---- half-spaces ---- *)
Lemma half_space_least : forall (S : pt -> Prop) n c x, n <> origin -> (forall p, dot n p <= c -> S p) -> x * norm n <= c ->
  at_least S x.
Proof.
  intros S n c x Hn H L. assert (P0 := norm_pos n Hn). split.
  - intros Hx t Ht. exists (x - norm t). apply norm_lt in Ht; [|lra]. split; [lra|].
    intros s Hs. apply norm_lt in Hs; [|lra]. apply H.
    assert (T := norm_triangle (sub s t) t). replace (add (sub s t) t) with s in T by (pteq; ring).
    assert (D := dot_le_norm n s). nra.
  - intros Hx. exists (along n x). unfold along. split.
    + apply H. rewrite dot_scal_r. fold (norm2 n). rewrite <- norm_sqr.
      replace (x / norm n * (norm n * norm n)) with (x * norm n) by (field; lra). auto.
    + rewrite norm2_scal, <- norm_sqr. right. field. lra.
Qed.

(* a half-space without a body that holds p: what is below the plane moved by p *)
Lemma half_space_minus_point : forall n d (S : pt -> Prop) p, S p ->
  forall x, dot n x <= d - dot n p -> difference_of (fun y => dot n y <= d) S x.
Proof. intros n d S p Hp x H. exists (add x p), p. split; [rewrite dot_add_r; lra|]. split; auto. pteq; ring. Qed.
Lemma point_minus_half_space : forall n d (S : pt -> Prop) p, S p ->
  forall x, dot (scal (-1) n) x <= d + dot (scal (-1) n) p -> difference_of S (fun y => dot n y <= d) x.
Proof.
  intros n d S p Hp x H. exists p, (sub p x). rewrite !dot_scal_l in H. split; auto.
  split; [rewrite dot_sub_r; lra|]. pteq; ring.
Qed.

(* ---- other units ---- *)
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

Lemma at_most_scal : forall (S T : pt -> Prop) k x, 0 < k -> (forall p, T (scal k p) -> S p) -> at_most S x -> at_most T (k * x).
Proof.
  intros S T k x Hk H [H0 H1]. assert (0 < / k) by (apply Rinv_0_lt_compat; auto). split.
  - intros Hx. assert (X : 0 <= x) by (apply Rmult_le_reg_l with k; lra).
    destruct (H0 X) as (t & Nt & NI). exists (scal k t). split.
    + rewrite norm2_scal. replace (k * x * (k * x)) with (k * k * (x * x)) by ring. apply Rmult_le_compat_l; nra.
    + intros (e & He & G). apply NI. exists (/ k * e). split; [nra|]. intros s Hs. apply H, G.
      replace (sub (scal k s) (scal k t)) with (scal k (sub s t)) by (pteq; ring). rewrite norm2_scal.
      replace (e * e) with (k * k * ((/ k * e) * (/ k * e))) by (field; lra). apply Rmult_lt_compat_l; [nra|auto].
  - intros Hx p Hp. assert (X : x < 0) by (apply Rmult_lt_reg_l with k; lra).
    assert (E : p = scal k (scal (/ k) p)) by (rewrite scal_scal, Rinv_r by lra; symmetry; apply scal_1).
    rewrite E in Hp. apply H in Hp. specialize (H1 X _ Hp). rewrite E, norm2_scal.
    replace (k * x * (k * x)) with (k * k * (x * x)) by ring. apply Rmult_le_compat_l; nra.
Qed.

Definition scale_core (k : R) (c : core pt R) : core pt R := map_core (scal k) (Rmult (k * k)) c.
Definition scale_body (k : R) (b : body pt R) : body pt R := map_body (scal k) (Rmult (k * k)) (Rmult k) b.

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

Lemma in_body_scal : forall k b p, 0 < k -> (in_body (scale_body k b) (scal k p) <-> in_body b p).
Proof.
  intros k [c r] p Hk. assert (Hi : 0 < / k) by (apply Rinv_0_lt_compat; auto). unfold scale_body, in_body. cbn [map_body core_of radius].
  split; intros (s & Hs & N).
  - exists (scal (/ k) s). split; [apply in_core_scal_inv; auto|].
    replace (sub p (scal (/ k) s)) with (scal (/ k) (sub (scal k p) s)) by (pteq; field; lra). rewrite norm2_scal.
    replace (r * r) with (/ k * / k * (k * r * (k * r))) by (field; lra). apply Rmult_le_compat_l; [nra|auto].
  - exists (scal k s). split; [apply in_core_scal; auto|].
    replace (sub (scal k p) (scal k s)) with (scal k (sub p s)) by (pteq; ring). rewrite norm2_scal.
    replace (k * r * (k * r)) with (k * k * (r * r)) by ring. apply Rmult_le_compat_l; [nra|auto].
Qed.

Lemma scal_back : forall k u, 0 < k -> scal k (scal (/ k) u) = u.
Proof. intros. rewrite scal_scal, Rinv_r by lra. apply scal_1. Qed.

Lemma scaled_difference : forall k p a b, 0 < k -> scal k p = sub b a -> p = sub (scal (/ k) b) (scal (/ k) a).
Proof.
  intros k p a b Hk E. transitivity (scal (/ k) (scal k p)); [rewrite scal_scal, Rinv_l by lra; symmetry; apply scal_1|].
  rewrite E. pteq; ring.
Qed.

Lemma gaps_scal : forall k A B p, 0 < k -> (gaps (scale_body k A) (scale_body k B) (scal k p) <-> gaps A B p).
Proof.
  intros k A B p Hk. split.
  - intros (b & a & Hb & Ha & E). exists (scal (/ k) b), (scal (/ k) a).
    rewrite <- (in_body_scal k B), <- (in_body_scal k A), !scal_back by auto. repeat split; auto. apply scaled_difference; auto.
  - intros (b & a & Hb & Ha & ->). exists (scal k b), (scal k a). rewrite !in_body_scal by auto. repeat split; auto. pteq; ring.
Qed.
Lemma core_gaps_scal : forall k A B p, 0 < k -> (core_gaps (scale_body k A) (scale_body k B) (scal k p) <-> core_gaps A B p).
Proof.
  intros k A B p Hk. split.
  - intros (b & a & Hb & Ha & E). exists (scal (/ k) b), (scal (/ k) a).
    split; [apply in_core_scal_inv; auto|]. split; [apply in_core_scal_inv; auto|]. apply scaled_difference; auto.
  - intros (b & a & Hb & Ha & ->). exists (scal k b), (scal k a). repeat split; try (apply in_core_scal; auto). pteq; ring.
Qed.

(* the gaps of rounded bodies are those of their cores, rounded: Theorem R's two sides for any bodies *)
Lemma gaps_thick : forall A B p, 0 <= radius A -> 0 <= radius B ->
  (gaps A B p <-> thick (core_gaps A B) (radius A + radius B) p).
Proof. intros A B p HA HB. apply difference_thick; auto. Qed.

(* a half-space shows that the signed depth of S is at most x *)
Definition planed (S : pt -> Prop) (x : R) : Prop := exists n h, n <> origin /\ beneath S n h /\ h <= x * norm n.

Lemma planed_most : forall S x, planed S x -> at_most S x.
Proof. intros S x (n & h & Hn & Hb & L). apply (beneath_most S n h); auto. Qed.

Lemma planed_scal : forall (S T : pt -> Prop) k x, 0 < k -> (forall p, T p -> S (scal k p)) -> planed S (k * x) -> planed T x.
Proof.
  intros S T k x Hk H (n & h & Hn & Hb & L). assert (Hi : 0 < / k) by (apply Rinv_0_lt_compat; auto).
  exists n, (/ k * h). split; auto. split.
  - intros p Hp. apply H, Hb in Hp. rewrite dot_scal_r in Hp.
    replace (dot n p) with (/ k * (k * dot n p)) by (field; lra). apply Rmult_le_compat_l; lra.
  - replace (x * norm n) with (/ k * (k * x * norm n)) by (field; lra). apply Rmult_le_compat_l; lra.
Qed.

(* Theorem R for any bodies: what is shown of the cores, by a half-space from above, holds of the bodies *)
Theorem R_least : forall A B x, 0 <= radius A -> 0 <= radius B -> at_least (core_gaps A B) x ->
  at_least (gaps A B) (x + (radius A + radius B)).
Proof.
  intros A B x HA HB H. apply (at_least_iff (thick (core_gaps A B) (radius A + radius B))).
  - intros p. rewrite gaps_thick by auto. tauto.
  - apply thick_least; auto. lra.
Qed.
Theorem R_most : forall A B x, 0 <= radius A -> 0 <= radius B -> planed (core_gaps A B) x ->
  at_most (gaps A B) (x + (radius A + radius B)).
Proof.
  intros A B x HA HB (n & h & Hn & H & L). apply (at_most_iff (thick (core_gaps A B) (radius A + radius B))).
  - intros p. rewrite gaps_thick by auto. tauto.
  - apply (thick_most _ n h); auto. lra.
Qed.

(* ---- signed squares ---- *)
Definition signed_sqr (x : R) : R := x * Rabs x.

Lemma signed_sqr_pos : forall x, 0 <= x -> signed_sqr x = x * x.
Proof. intros x H. unfold signed_sqr. rewrite Rabs_right; lra. Qed.
Lemma signed_sqr_neg : forall x, x <= 0 -> signed_sqr x = - (x * x).
Proof. intros x H. unfold signed_sqr. rewrite Rabs_left1; lra. Qed.
Lemma signed_sqr_le : forall x y, signed_sqr x <= signed_sqr y <-> x <= y.
Proof.
  intros x y. destruct (Rle_dec 0 x) as [X|X]; [rewrite (signed_sqr_pos x) by lra|rewrite (signed_sqr_neg x) by lra];
    (destruct (Rle_dec 0 y) as [Y|Y]; [rewrite (signed_sqr_pos y) by lra|rewrite (signed_sqr_neg y) by lra]);
    split; intros H; try nra; apply Rnot_lt_le; intros L; nra.
Qed.
Lemma signed_sqr_inj : forall x y, signed_sqr x = signed_sqr y -> x = y.
Proof. intros x y H. apply Rle_antisym; apply signed_sqr_le; lra. Qed.
Lemma signed_sqr_scal : forall k x, 0 <= k -> signed_sqr (k * x) = k * k * signed_sqr x.
Proof. intros k x Hk. unfold signed_sqr. rewrite Rabs_mult, (Rabs_right k) by lra. ring. Qed.
Lemma signed_sqr_root : forall x, signed_sqr (signed_root x) = x.
Proof.
  intros x. unfold signed_root. destruct (Rle_dec 0 x) as [H|H].
  - rewrite signed_sqr_pos by apply sqrt_pos. apply sqrt_sqrt. auto.
  - assert (P := sqrt_pos (- x)). rewrite signed_sqr_neg by lra. replace (- sqrt (- x) * - sqrt (- x)) with (sqrt (- x) * sqrt (- x))
    by ring.
    rewrite sqrt_sqrt; lra.
Qed.
Lemma signed_root_scal : forall k x, 0 <= k -> signed_root (k * k * x) = k * signed_root x.
Proof. intros k x Hk. apply signed_sqr_inj. rewrite signed_sqr_scal, !signed_sqr_root; auto. Qed.
Lemma signed_root_opp : forall x, signed_root (- x) = - signed_root x.
Proof. intros x. apply signed_sqr_inj. rewrite signed_sqr_root. unfold signed_sqr. rewrite Rabs_Ropp, <- (signed_sqr_root x) at 1.
  unfold signed_sqr. ring. Qed.
