(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Theorem R: the signed depth of rounded bodies is that of their cores plus the sum of the radii. *)
Require Import Reals Lra Psatz List.
From Fathom.geometry Require Import meaning bodies space hulls flats facets difference depth minkowski.
Import ListNotations.
Open Scope R_scope.

(* ---- lengths ---- *)
Definition norm (u : pt) : R := sqrt (norm2 u).

Lemma norm_nonneg : forall u, 0 <= norm u.
Proof. intros. apply sqrt_pos. Qed.
Lemma norm_sqr : forall u, norm u * norm u = norm2 u.
Proof. intros. apply sqrt_sqrt, norm2_nonneg. Qed.
Lemma norm_le : forall u x, 0 <= x -> (norm2 u <= x * x <-> norm u <= x).
Proof. intros u x Hx. assert (N := norm_nonneg u). rewrite <- norm_sqr. split; intros H; [apply Rnot_lt_le; intros L|]; nra. Qed.
Lemma norm_lt : forall u x, 0 <= x -> (norm2 u < x * x <-> norm u < x).
Proof. intros u x Hx. assert (N := norm_nonneg u). rewrite <- norm_sqr. split; intros H; [apply Rnot_le_lt; intros L|]; nra. Qed.
Lemma norm_ge : forall u x, 0 <= x -> (x * x <= norm2 u <-> x <= norm u).
Proof. intros u x Hx. assert (N := norm_nonneg u). rewrite <- norm_sqr. split; intros H; [apply Rnot_lt_le; intros L|]; nra. Qed.
Lemma norm_pos : forall u, u <> origin -> 0 < norm u.
Proof. intros u H. apply sqrt_lt_R0, norm2_pos, H. Qed.
Lemma norm_triangle : forall u v, norm (add u v) <= norm u + norm v.
Proof. exact norm2_triangle. Qed.
Lemma norm_scal : forall k u, 0 <= k -> norm (scal k u) = k * norm u.
Proof.
  intros k u Hk. unfold norm. rewrite norm2_scal, sqrt_mult_alt by nra. rewrite sqrt_square; auto.
Qed.
Lemma norm_opp : forall u v, norm (sub u v) = norm (sub v u).
Proof. intros. unfold norm. f_equal. unfold norm2, dot; simpl; ring. Qed.
Lemma dot_le_norm : forall u v, dot u v <= norm u * norm v.
Proof.
  intros u v. assert (C := cauchy u v). assert (A := norm_nonneg u). assert (B := norm_nonneg v).
  rewrite <- !norm_sqr in C. assert (0 <= norm u * norm v) by nra. apply Rnot_lt_le. intros L. nra.
Qed.
Lemma norm2_origin : norm2 origin = 0.
Proof. unfold norm2, dot; simpl; ring. Qed.
Lemma dot_origin_r : forall u, dot u origin = 0.
Proof. intros. unfold dot; simpl; ring. Qed.
Lemma norm_origin : norm origin = 0.
Proof. unfold norm. rewrite norm2_origin. apply sqrt_0. Qed.
Lemma square_order : forall x y, 0 <= x -> x <= y -> x * x <= y * y.
Proof. intros. nra. Qed.

(* ---- sets ---- *)
Lemma thick_norm : forall S r p, 0 <= r -> (thick S r p <-> exists s, S s /\ norm (sub p s) <= r).
Proof. intros S r p Hr. split; intros (s & Hs & H); exists s; split; auto; apply norm_le; auto. Qed.

Lemma thick_0 : forall S p, thick S 0 p <-> S p.
Proof.
  intros S p. split.
  - intros (s & Hs & H). assert (N := norm2_nonneg (sub p s)). replace p with s; auto. symmetry. apply sub_zero. lra.
  - intros H. exists p. split; auto. unfold norm2, dot; simpl. lra.
Qed.

Lemma thick_in : forall (S : pt -> Prop) r p, S p -> thick S r p.
Proof. intros S r p H. exists p. split; auto. replace (norm2 (sub p p)) with 0 by (unfold norm2, dot; simpl; ring). nra. Qed.

(* a vector that is at most r + s long is the sum of one of at most r and one of at most s *)
Lemma split_length : forall u r s, 0 <= r -> 0 <= s -> norm u <= r + s ->
  exists v w, u = add v w /\ norm v <= r /\ norm w <= s.
Proof.
  intros u r s Hr Hs H. destruct (Req_dec (r + s) 0) as [E|E].
  - exists u, origin. rewrite norm_origin. repeat split; try lra. pteq; ring.
  - assert (P : 0 < r + s) by lra.
    assert (part : forall k, 0 <= k -> norm (scal (k / (r + s)) u) <= k).
    { intros k Hk. assert (0 <= / (r + s)) by (left; apply Rinv_0_lt_compat; auto).
      rewrite norm_scal by (apply Rmult_le_pos; auto). apply Rmult_le_reg_r with (r + s); auto.
      replace (k / (r + s) * norm u * (r + s)) with (k * norm u) by (field; lra). apply Rmult_le_compat_l; auto. }
    exists (scal (r / (r + s)) u), (scal (s / (r + s)) u). split; [pteq; field; lra|auto].
Qed.

Theorem difference_thick : forall S T r s p, 0 <= r -> 0 <= s ->
  (difference_of (thick T s) (thick S r) p <-> thick (difference_of T S) (r + s) p).
Proof.
  intros S T r s p Hr Hs. rewrite thick_norm by lra. split.
  - intros (b & a & Hb & Ha & ->). apply thick_norm in Ha, Hb; auto.
    destruct Ha as (a' & Ia & Na), Hb as (b' & Ib & Nb).
    exists (sub b' a'). split; [exists b', a'; auto|].
    replace (sub (sub b a) (sub b' a')) with (add (sub b b') (sub a' a)) by (pteq; ring).
    assert (N := norm_triangle (sub b b') (sub a' a)). rewrite (norm_opp a' a) in N. lra.
  - intros (d & (b & a & Hb & Ha & ->) & N). destruct (split_length _ _ _ Hr Hs N) as (v & w & E & V & W).
    exists (add b w), (sub a v). split; [|split].
    + apply thick_norm; auto. exists b. split; auto. replace (sub (add b w) b) with w by (pteq; ring). auto.
    + apply thick_norm; auto. exists a. split; auto. rewrite norm_opp. replace (sub a (sub a v)) with v by (pteq; ring). auto.
    + replace (sub (add b w) (sub a v)) with (add (sub b a) (add v w)) by (pteq; ring). rewrite <- E. pteq; ring.
Qed.

Lemma at_least_iff : forall S T x, (forall p, S p <-> T p) -> at_least S x -> at_least T x.
Proof.
  intros S T x E [H0 H1]. split.
  - intros Hx t Ht. apply (interior_iff S); auto.
  - intros Hx. destruct (H1 Hx) as (p & Hp & L). exists p. split; auto. apply E; auto.
Qed.
Lemma at_most_iff : forall S T x, (forall p, S p <-> T p) -> at_most S x -> at_most T x.
Proof.
  intros S T x E [H0 H1]. split.
  - intros Hx. destruct (H0 Hx) as (t & L & NI). exists t. split; auto. rewrite <- (interior_iff S); auto.
  - intros Hx p Hp. apply H1; auto. apply E; auto.
Qed.

(* ---- what "at least" and "at most" have to do with each other ---- *)
Theorem least_le_most : forall S x y, at_least S x -> at_most S y -> x <= y.
Proof.
  intros S x y [L0 L1] [M0 M1]. apply Rnot_lt_le. intros L.
  destruct (Rlt_dec 0 x) as [X|X]; destruct (Rle_dec 0 y) as [Y|Y].
  - destruct (M0 Y) as (t & Ht & NI). apply NI, L0; auto. nra.
  - assert (I := L0 X origin). rewrite norm2_origin in I. assert (S origin) by (apply interior_in, I; nra).
    specialize (M1 (Rnot_le_lt _ _ Y) origin H). rewrite norm2_origin in M1. nra.
  - lra.
  - destruct (L1 (Rnot_lt_le _ _ X)) as (p & Hp & N). specialize (M1 (Rnot_le_lt _ _ Y) p Hp). nra.
Qed.

(* the number means what it says: there is at most one *)
Theorem signed_depth_unique : forall S v w, signed_depth S v -> signed_depth S w -> v = w.
Proof. intros S v w [L M] [L' M']. apply Rle_antisym; eapply least_le_most; eauto. Qed.

Theorem signed_depth_within : forall S lo hi v, signed_depth_in S lo hi -> signed_depth S v -> lo <= v <= hi.
Proof. intros S lo hi v [L M] [L' M']. split; eapply least_le_most; eauto. Qed.

Lemma at_least_weaken : forall S x y, y <= x -> at_least S x -> at_least S y.
Proof.
  intros S x y L [H0 H1]. split.
  - intros Hy t Ht. apply H0; nra.
  - intros Hy. destruct (Rlt_dec 0 x) as [X|X].
    + exists origin. rewrite norm2_origin. split; [|nra]. apply interior_in, H0; auto. rewrite norm2_origin. nra.
    + destruct H1 as (p & Hp & N); [lra|]. exists p. split; auto. nra.
Qed.
Lemma at_most_weaken : forall S x y, x <= y -> at_most S x -> at_most S y.
Proof.
  intros S x y L [H0 H1]. split.
  - intros Hy. destruct (Rle_dec 0 x) as [X|X].
    + destruct (H0 X) as (t & Ht & NI). exists t. split; auto. nra.
    + exists origin. rewrite norm2_origin. split; [nra|]. intros I. apply interior_in in I.
      specialize (H1 (Rnot_le_lt _ _ X) origin I). rewrite norm2_origin in H1. nra.
  - intros Hy p Hp. assert (G := H1 (Rle_lt_trans _ _ _ L Hy) p Hp). nra.
Qed.

(* the status is the sign *)
Theorem least_overlap : forall S x, at_least S x -> 0 < x -> overlap S.
Proof. intros S x [H _] Hx. apply H; auto. rewrite norm2_origin. nra. Qed.
Theorem most_apart : forall S x, at_most S x -> x < 0 -> apart S.
Proof. intros S x [_ H] Hx I. specialize (H Hx origin I). rewrite norm2_origin in H. nra. Qed.
Theorem signed_depth_touch : forall S, signed_depth S 0 <-> touch S.
Proof.
  intros S. split.
  - intros [[_ L] [M _]]. destruct L as (p & Hp & N); [lra|]. destruct M as (t & Nt & NI); [lra|].
    assert (Zp := norm2_nonneg p). assert (Zt := norm2_nonneg t).
    rewrite (norm2_zero p) in Hp by lra. rewrite (norm2_zero t) in NI by lra. split; auto.
  - intros [I NI]. split; split; try lra; intros _; exists origin; rewrite norm2_origin; split; auto; lra.
Qed.

(* ---- Theorem R, the lower side: for any set ---- *)
Lemma interior_thick : forall S r u v, interior S u -> norm v <= r -> interior (thick S r) (add u v).
Proof.
  intros S r u v (e & He & H) Hv. assert (Hr := Rle_trans _ _ _ (norm_nonneg v) Hv).
  exists e. split; auto. intros s Hs. apply thick_norm; auto.
  exists (sub s v). split.
  - apply H. replace (sub (sub s v) u) with (sub s (add u v)) by (pteq; ring). auto.
  - replace (sub s (sub s v)) with v by (pteq; ring). auto.
Qed.

Theorem thick_least : forall S x r, 0 <= r -> at_least S x -> at_least (thick S r) (x + r).
Proof.
  intros S x r Hr [H0 H1]. destruct (Rlt_dec 0 x) as [X|X].
  - split; [|lra]. intros _ t Ht. apply norm_lt in Ht; [|lra].
    assert (Hd : 0 < / (x + r)) by (apply Rinv_0_lt_compat; lra).
    assert (part : forall k, 0 <= k -> norm (scal (k / (x + r)) t) * (x + r) = k * norm t).
    { intros k Hk. rewrite norm_scal by (apply Rmult_le_pos; lra). field. lra. }
    replace t with (add (scal (x / (x + r)) t) (scal (r / (x + r)) t)) by (pteq; field; lra).
    apply interior_thick.
    + apply H0; auto. apply norm_lt; [lra|]. apply Rmult_lt_reg_r with (x + r); [lra|]. rewrite part by lra. nra.
    + apply Rmult_le_reg_r with (x + r); [lra|]. rewrite part by lra. nra.
  - destruct H1 as (p & Hp & N); [lra|]. replace (x * x) with (- x * - x) in N by ring. apply norm_le in N; [|lra].
    split.
    + intros P t Ht. apply norm_lt in Ht; [|lra]. exists (x + r - norm t). split; [lra|].
      intros s Hs. apply norm_lt in Hs; [|lra]. apply thick_norm; auto. exists p. split; auto.
      replace (sub s p) with (add (sub s t) (add t (scal (-1) p))) by (pteq; ring).
      assert (T1 := norm_triangle (sub s t) (add t (scal (-1) p))). assert (T2 := norm_triangle t (scal (-1) p)).
      replace (norm (scal (-1) p)) with (norm p) in T2; [lra|].
      unfold norm. f_equal. rewrite norm2_scal. ring.
    + intros P. destruct (Rle_dec (norm p) r) as [L|L].
      * exists origin. rewrite norm2_origin. split; [|nra]. apply thick_norm; auto. exists p. split; auto.
        rewrite norm_opp. replace (sub p origin) with p by (pteq; ring). auto.
      * assert (Pp : 0 < norm p) by lra. assert (Hi : 0 < / norm p) by (apply Rinv_0_lt_compat; auto).
        assert (Hk : 0 <= r / norm p <= 1).
        { split; [apply Rmult_le_pos; lra|]. apply Rmult_le_reg_r with (norm p); auto. field_simplify; lra. }
        exists (scal (1 - r / norm p) p). split.
        -- apply thick_norm; auto. exists p. split; auto. rewrite norm_opp.
           replace (sub p (scal (1 - r / norm p) p)) with (scal (r / norm p) p) by (pteq; ring).
           rewrite norm_scal by lra. right. field. lra.
        -- replace ((x + r) * (x + r)) with (- (x + r) * - (x + r)) by ring. apply norm_le; [lra|].
           rewrite norm_scal by lra. replace ((1 - r / norm p) * norm p) with (norm p - r) by (field; lra). lra.
Qed.

(* ---- the upper side: half-spaces that hold the set ---- *)
Definition beneath (S : pt -> Prop) (n : pt) (h : R) : Prop := forall p, S p -> dot n p <= h.

Lemma beneath_thick : forall S n h r, 0 <= r -> beneath S n h -> beneath (thick S r) n (h + r * norm n).
Proof.
  intros S n h r Hr H p Hp. apply thick_norm in Hp; auto. destruct Hp as (s & Hs & N).
  replace p with (add s (sub p s)) by (pteq; ring). rewrite dot_add_r.
  assert (D := dot_le_norm n (sub p s)). assert (K := norm_nonneg n). specialize (H s Hs). nra.
Qed.

Theorem beneath_most : forall S n h x, n <> origin -> beneath S n h -> h <= x * norm n -> at_most S x.
Proof.
  intros S n h x Hn H L. assert (P := norm_pos n Hn). split.
  - intros Hx. exists (scal (x / norm n) n).
    assert (K : 0 <= x / norm n) by (apply Rmult_le_pos; auto; left; apply Rinv_0_lt_compat; auto). split.
    + apply norm_le; auto. rewrite norm_scal by auto. right. field. lra.
    + apply (halfspace_not_interior _ n h); auto.
      * apply norm2_pos. auto.
      * rewrite dot_scal_r. fold (norm2 n). rewrite <- norm_sqr. replace (x / norm n * (norm n * norm n)) with (x * norm n) by (field; lra).
        auto.
  - intros Hx p Hp. replace (x * x) with (- x * - x) by ring. apply norm_ge; [lra|].
    specialize (H p Hp). assert (D := dot_le_norm (scal (-1) n) p). rewrite dot_scal_l in D.
    replace (norm (scal (-1) n)) with (norm n) in D by (unfold norm; f_equal; rewrite norm2_scal; ring).
    apply Rmult_le_reg_l with (norm n); auto. lra.
Qed.

Theorem thick_most : forall S n h x r, 0 <= r -> n <> origin -> beneath S n h -> h <= x * norm n ->
  at_most (thick S r) (x + r).
Proof.
  intros S n h x r Hr Hn H L. apply (beneath_most _ n (h + r * norm n)); auto; [apply beneath_thick; auto|lra].
Qed.

(* ---- Theorem R for polytopes ---- *)
Lemma dot_near : forall p z l, norm2 (add (scal l z) (scal (1 - l) p)) = norm2 p - 2 * l * (norm2 p - dot p z) + l * l * norm2 (sub z p).
Proof. intros. unfold norm2, dot; simpl; ring. Qed.

(* the nearest point of a convex set has all of it beyond the plane through it *)
Lemma nearest_beneath : forall S p, convex S -> S p -> (forall s, S s -> norm2 p <= norm2 s) ->
  beneath S (scal (-1) p) (- norm2 p).
Proof.
  intros S p HC Hp H s Hs. rewrite dot_scal_l. apply Rnot_lt_le. intros L.
  assert (D : 0 < norm2 p - dot p s) by lra. set (d := norm2 p - dot p s) in *.
  assert (N := norm2_nonneg (sub s p)). set (w := norm2 (sub s p)) in *.
  set (l := d / (d + w)).
  assert (Hl : 0 < l) by (apply Rdiv_lt_0_compat; lra).
  assert (El : l * (d + w) = d) by (unfold l; field; lra).
  assert (Hl1 : l <= 1) by nra.
  assert (G := H _ (HC s p l (conj (Rlt_le _ _ Hl) Hl1) Hs Hp)). rewrite dot_near in G. fold d w in G. nra.
Qed.

Lemma P_beneath : forall A B n h, height_is A B n h -> beneath (P A B) n h.
Proof. intros A B n h [H _]. exact H. Qed.

(* O in a polytope, and not in its interior: a plane through O has the polytope on one side *)
Lemma touching_plane : forall A B, touching A B -> exists n, n <> origin /\ height_is A B n 0.
Proof.
  intros A B [HP NI]. destruct (spanning_or_flat (differences A B)) as [S|(n & h & Hn & F)].
  - destruct (finite_facets _ S) as (F & F1 & F2).
    destruct (interior_or_facet _ F F2 origin) as [I|(f & If & G)].
    + exfalso. apply NI, interior_P_conv. auto.
    + destruct (F1 f If) as (u & v & w & Hf). apply facet_plane_P in Hf. destruct Hf as [[Hn _] Hh].
      exists (fst f). split; auto. replace 0 with (snd f); auto. rewrite dot_origin_r in G.
      assert (Hh' := P_beneath _ _ _ _ Hh origin HP). rewrite dot_origin_r in Hh'. lra.
  - exists n. split; auto.
    assert (E : forall s, P A B s -> dot n s = h).
    { intros s Hs. apply Rle_antisym.
      - revert s Hs. apply hull_halfspace. intros s Hs. rewrite F; [lra|]. apply differences_in; auto.
      - apply Ropp_le_cancel. replace (- dot n s) with (dot (scal (-1) n) s) by (rewrite dot_scal_l; ring).
        revert s Hs. apply hull_halfspace. intros s Hs. rewrite dot_scal_l, F; [lra|]. apply differences_in; auto. }
    assert (Z := E origin HP). rewrite dot_origin_r in Z. split.
    + intros s Hs. rewrite E by auto. lra.
    + exists origin. rewrite dot_origin_r. auto.
Qed.

(* a signed depth of a polytope has a plane that shows it from above *)
Lemma depth_plane : forall A B v, signed_depth (P A B) v ->
  exists n h, n <> origin /\ beneath (P A B) n h /\ h <= v * norm n.
Proof.
  intros A B v H. destruct (Rtotal_order v 0) as [V|[V|V]].
  - destruct H as [[_ L] [_ M]]. destruct L as (p & Hp & N); [lra|].
    assert (E : norm2 p = v * v) by (apply Rle_antisym; auto).
    exists (scal (-1) p), (- norm2 p).
    assert (Np : norm p = - v).
    { unfold norm. rewrite E. replace (v * v) with (- v * - v) by ring. apply sqrt_square. lra. }
    assert (Nm : norm (scal (-1) p) = norm p) by (unfold norm; f_equal; rewrite norm2_scal; ring).
    split; [|split].
    + apply norm2_pos_inv. rewrite norm2_scal, E. nra.
    + apply nearest_beneath; auto. apply hull_convex. intros s Hs. rewrite E. auto.
    + rewrite Nm, Np, E. lra.
  - subst v. apply signed_depth_touch in H. destruct (touching_plane _ _ H) as (n & Hn & Hh).
    exists n, 0. split; auto. split; [apply P_beneath; auto|lra].
  - destruct H as [[L _] [M _]]. destruct M as (t & Nt & NI); [lra|].
    assert (E : norm2 t = v * v).
    { apply Rle_antisym; auto. apply Rnot_lt_le. intros G. apply NI, L; auto. }
    assert (D : depth2_is A B (v * v)) by (repeat split; [nra|auto|exists t; auto]).
    apply (nearest_points A B _ t D E) in NI. destruct NI as (n & [Hn _] & h & Hh & Ef).
    assert (P0 := height_positive _ _ _ _ (depth_interior _ _ _ D) Hn Hh).
    rewrite Ef, foot_norm2 in E by auto. assert (N := norm2_pos n Hn). assert (Q := norm_pos n Hn).
    exists n, h. split; auto. split; [apply P_beneath; auto|].
    assert (E2 : h * h = v * v * (norm n * norm n)) by (rewrite norm_sqr, <- E; field; lra).
    apply Rnot_lt_le. intros G. assert (0 < v * norm n) by (apply Rmult_lt_0_compat; auto). nra.
Qed.

Theorem theorem_R : forall A B v r, 0 <= r -> signed_depth (P A B) v -> signed_depth (thick (P A B) r) (v + r).
Proof.
  intros A B v r Hr H. split; [apply thick_least; auto; apply H|].
  destruct (depth_plane A B v H) as (n & h & Hn & Hb & L). apply (thick_most _ n h); auto.
Qed.

(* the signed depth where it is positive is the depth of format 1 *)
Theorem signed_depth_depth : forall A B v, 0 < v -> (signed_depth (P A B) v <-> depth2_is A B (v * v)).
Proof.
  intros A B v Hv. split.
  - intros [[L _] [M _]]. destruct M as (t & Nt & NI); [lra|]. repeat split; [nra|auto|].
    exists t. split; auto. apply Rle_antisym; auto. apply Rnot_lt_le. intros G. apply NI, L; auto.
  - intros (_ & L & t & Nt & NI). split; split; try lra; auto. intros _. exists t. split; auto. lra.
Qed.

(* ---- the least ways out of rounded bodies are those of the cores, longer ---- *)
(* t is v n/|n| *)
Definition along (n : pt) (v : R) : pt := scal (v / norm n) n.

Lemma norm_along : forall n v, n <> origin -> 0 <= v -> norm (along n v) = v.
Proof.
  intros n v Hn Hv. assert (N := norm_pos n Hn). unfold along.
  rewrite norm_scal by (apply Rmult_le_pos; auto; left; apply Rinv_0_lt_compat; auto). field. lra.
Qed.

Lemma beneath_along : forall S n h v, n <> origin -> beneath S n h -> h <= v * norm n -> ~ interior S (along n v).
Proof.
  intros S n h v Hn H L. apply (halfspace_not_interior _ n h); auto. { apply norm2_pos; auto. }
  unfold along. rewrite dot_scal_r. fold (norm2 n). rewrite <- norm_sqr. assert (N := norm_pos n Hn).
  replace (v / norm n * (norm n * norm n)) with (v * norm n) by (field; lra). auto.
Qed.

Theorem ways_out_overlap : forall S s r t, 0 < s -> 0 <= r -> way_out (thick S r) (s + r) t -> way_out S s (scal (s / (s + r)) t).
Proof.
  intros S s r t Hs Hr [N NI]. assert (P0 : 0 < / (s + r)) by (apply Rinv_0_lt_compat; lra).
  assert (Nt : norm t = s + r) by (unfold norm; rewrite N; apply sqrt_square; lra).
  split.
  - rewrite norm2_scal, N. field. lra.
  - intros I. apply NI. replace t with (add (scal (s / (s + r)) t) (scal (r / (s + r)) t)) by (pteq; field; lra).
    apply interior_thick; auto. rewrite norm_scal, Nt by (apply Rmult_le_pos; lra). right. field. lra.
Qed.

(* of cores that touch: exactly the directions of the polar cone *)
Theorem ways_out_touch : forall S r t, 0 < r -> convex S -> S origin ->
  (way_out (thick S r) r t <-> norm2 t = r * r /\ polar S t).
Proof.
  intros S r t Hr HC HO. split; intros [N H]; split; auto.
  - intros p Hp. apply Rnot_lt_le. intros L. apply H.
    assert (Nt : norm t = r) by (unfold norm; rewrite N; apply sqrt_square; lra).
    (* a small step from O towards p brings t nearer *)
    assert (Np := norm2_nonneg p). set (d := dot t p) in *. set (l := d / (d + norm2 p)).
    assert (Hl : 0 < l) by (apply Rdiv_lt_0_compat; lra).
    assert (El : l * (d + norm2 p) = d) by (unfold l; field; lra).
    assert (Hl1 : l <= 1) by nra.
    assert (Hs : S (scal l p)).
    { replace (scal l p) with (add (scal l p) (scal (1 - l) origin)) by (pteq; ring). apply HC; auto. lra. }
    assert (C : norm (sub t (scal l p)) < r).
    { apply norm_lt; [lra|]. replace (norm2 (sub t (scal l p))) with (norm2 t - 2 * l * d + l * l * norm2 p)
        by (unfold d, norm2, dot; simpl; ring). rewrite N. nra. }
    exists (r - norm (sub t (scal l p))). split; [lra|]. intros s Hs'. apply norm_lt in Hs'; [|lra].
    apply thick_norm; [lra|]. exists (scal l p). split; auto.
    replace (sub s (scal l p)) with (add (sub s t) (sub t (scal l p))) by (pteq; ring).
    assert (T := norm_triangle (sub s t) (sub t (scal l p))). lra.
  - assert (Nt : norm t = r) by (unfold norm; rewrite N; apply sqrt_square; lra).
    apply (halfspace_not_interior _ t (0 + r * norm t)); [nra|apply beneath_thick; [lra|exact H]|].
    fold (norm2 t). rewrite N, Nt. lra.
Qed.
