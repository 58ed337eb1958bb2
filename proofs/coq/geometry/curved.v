(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Cores: they are convex; the bounded ones attain least values; how far they reach in a direction (Cauchy-Schwarz); points inside them. *)
Require Import Reals Lra Psatz List.
From Fathom.checker Require Import sequence body.
From Fathom.geometry Require Import meaning bodies space norm hulls minkowski signed_depth compact.
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

(* ---- bounded cores attain least values ---- *)
Lemma in_atom_convex : forall a, convex (in_atom a).
Proof.
  intros a p q l Hl (x & y & z & B & ->) (x' & y' & z' & B' & ->).
  exists (l * x + (1 - l) * x'), (l * y + (1 - l) * y'), (l * z + (1 - l) * z'). split; [|pteq; ring].
  assert (C : 2 * (x * x' + y * y' + z * z') <= 2).
  { assert (X := Rle_0_sqr (x - x')). assert (Y := Rle_0_sqr (y - y')). assert (Z := Rle_0_sqr (z - z')). unfold Rsqr in *. lra. }
  set (aa := x * x + y * y + z * z) in *. set (bb := x' * x' + y' * y' + z' * z') in *. set (ab := x * x' + y * y' + z * z') in *.
  replace (_ + _ + _) with (l * l * aa + 2 * (l * (1 - l)) * ab + (1 - l) * (1 - l) * bb) by (unfold aa, bb, ab; ring).
  assert (l * l * aa <= l * l * 1) by (apply Rmult_le_compat_l; nra).
  assert ((1 - l) * (1 - l) * bb <= (1 - l) * (1 - l) * 1) by (apply Rmult_le_compat_l; nra).
  assert (l * (1 - l) * ab <= l * (1 - l) * 1) by (apply Rmult_le_compat_l; nra). lra.
Qed.
Lemma attains_atom : forall a, attains (in_atom a).
Proof.
  intros a. assert (NU := norm_nonneg (axis_u a)). assert (NV := norm_nonneg (axis_v a)). assert (NW := norm_nonneg (axis_w a)).
  apply (attains_image unit_ball _ (fun p => add (center a) (add (scal (px p) (axis_u a)) (add (scal (py p) (axis_v a)) (scal (pz p)
    (axis_w a)))))
    (norm (axis_u a) + norm (axis_v a) + norm (axis_w a))); [lra| | |apply attains_ball].
  - intros p q. set (d := sub p q).
    match goal with |- norm ?s <= _ => replace s with (add (scal (px d) (axis_u a)) (add (scal (py d) (axis_v a)) (scal (pz d) (axis_w a))))
      by (unfold d; pteq; ring) end.
    assert (each : forall k, k * k <= norm2 d -> Rabs k <= norm d).
    { intros k Hk. apply Rsqr_incr_0; try apply norm_nonneg; try apply Rabs_pos. rewrite <- Rsqr_abs. unfold Rsqr. rewrite norm_sqr. auto. }
    assert (X : Rabs (px d) <= norm d) by (apply each; unfold norm2, dot; nra).
    assert (Y : Rabs (py d) <= norm d) by (apply each; unfold norm2, dot; nra).
    assert (Z : Rabs (pz d) <= norm d) by (apply each; unfold norm2, dot; nra).
    eapply Rle_trans; [apply norm_triangle|]. assert (T := norm_triangle (scal (py d) (axis_v a)) (scal (pz d) (axis_w a))).
    rewrite norm_scal_abs in *. rewrite !norm_scal_abs in T. nra.
  - intros p. split.
    + intros (x & y & z & B & ->). exists (mk x y z). split; auto.
    + intros ([x y z] & B & ->). exists x, y, z. auto.
Qed.
Lemma attains_core : forall c, bounded_core c -> attains (in_core c).
Proof.
  intros [L|ts|n d] H; simpl in *; [| |contradiction].
  - apply (attains_iff (hull (fun p => exists x, In x L /\ p = x))).
    + intros p. split; apply hull_mono; [intros s (x & Ix & ->); auto|intros s Is; exists s; auto].
    + apply (attains_hull _ (fun x p => p = x)); auto; [|apply attains_point]. intros x u v l _ -> ->. pteq; ring.
  - induction ts as [|t ts IH]; simpl.
    + apply attains_point.
    + apply attains_sum; [|apply IH, (Forall_inv_tail H)].
      apply attains_hull; [exact (Forall_inv H)|apply in_atom_convex|apply attains_atom].
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
