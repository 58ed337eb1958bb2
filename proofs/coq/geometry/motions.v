(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What the depth says of all motions, turns among them: some point moves at least as far. The
   theorem for polytopes is that of Zhang, Kim, Varadhan and Manocha, Generalized penetration depth
   computation (2007). *)
Require Import Reals Lra Psatz List.
From Fathom.checker Require Import body.
From Fathom.geometry Require Import meaning bodies space norm hulls difference depth minkowski width wording.
From Fathom.geometry Require Import signed_depth rounded compact existence curved gaps unions seams.
Import ListNotations.
Open Scope R_scope.

(* ---- what the theorems speak of ---- *)
(* where f takes the points of S *)
Definition image (f : pt -> pt) (S : pt -> Prop) (p : pt) : Prop := exists s, S s /\ p = f s.
(* f keeps all distances, and takes space onto itself: a rigid motion, or the mirror image of one *)
Definition rigid (f : pt -> pt) : Prop :=
  (forall u v, norm2 (sub (f u) (f v)) = norm2 (sub u v)) /\ forall q, exists p, f p = q.
(* some plane has S on one side, and T on the other *)
Definition parted (S T : pt -> Prop) : Prop :=
  exists n, n <> origin /\ forall s t, S s -> T t -> dot n t <= dot n s.
(* no interior point of S is in T *)
Definition clear_of (S T : pt -> Prop) : Prop := forall p, ~ (interior S p /\ T p).

(* ---- the argument ---- *)
(* a is lowest of S, and goes to where all of T is no higher *)
Lemma moved_far : forall S T v n a m, at_least (difference_of T S) v -> 0 < v -> n <> origin ->
  (forall s, S s -> dot n a <= dot n s) -> (forall t, T t -> dot n t <= dot n m) -> v <= norm (sub m a).
Proof.
  intros S T v n a m [L _] Hv Hn Low High. apply Rnot_lt_le. intros G.
  assert (N := norm_nonneg (sub m a)). assert (Pn := norm_pos n Hn). set (w := (norm (sub m a) + v) / 2).
  assert (I : difference_of T S (along n w)).
  { apply interior_in, L; auto. apply norm_lt; [lra|]. rewrite norm_along by (auto; unfold w; lra). unfold w. lra. }
  destruct I as (t & s & Ht & Hs & E). assert (D := dot_along n w Hn). rewrite E, dot_sub_r in D.
  specialize (Low s Hs). specialize (High t Ht). assert (C := dot_le_norm n (sub m a)). rewrite dot_sub_r in C.
  assert (w * norm n <= norm (sub m a) * norm n) by lra. apply Rmult_le_reg_r in H; auto. unfold w in H. lra.
Qed.

Lemma lowest_corner_of : forall A n, A <> [] -> exists a, In a A /\ forall s, conv A s -> dot n a <= dot n s.
Proof.
  intros A n HA. destruct (greatest_exists (fun s => dot (scal (-1) n) s) A HA) as (a & Ia & M).
  exists a. split; auto. intros s Hs.
  assert (G : dot (scal (-1) n) s <= dot (scal (-1) n) a) by (revert s Hs; apply hull_halfspace; auto).
  rewrite !dot_scal_l in G. lra.
Qed.

Lemma P_least : forall A B q, depth2_is A B q -> at_least (difference_of (conv B) (conv A)) (root q) /\ 0 < root q.
Proof.
  intros A B q D. assert (Pq := proj1 D). assert (Pr := root_positive q Pq). split; auto.
  rewrite <- (root_sqr q) in D by lra. apply signed_depth_depth in D; auto. destruct D as [D _].
  apply (at_least_iff (P A B)); auto. intros p. rewrite P_minkowski. unfold difference_of.
  split; [intros (a & b & Ha & Hb & E)|intros (b & a & Hb & Ha & E)]; eauto 6.
Qed.

(* ---- polytopes: f need be known at the corners only ---- *)
Theorem depth_every_map : forall A B q f, depth2_is A B q -> parted (conv (map f A)) (conv B) ->
  exists a, In a A /\ q <= norm2 (sub (f a) a).
Proof.
  intros A B q f D (n & Hn & H). destruct (P_least A B q D) as [L Pr].
  destruct (P_nonempty A B origin) as [HA _]; [apply interior_in, (depth_interior _ _ _ D)|].
  destruct (lowest_corner_of A n HA) as (a & Ia & Low). exists a. split; auto.
  rewrite <- (root_sqr q) by (assert (Pq := proj1 D); lra). apply norm_ge; [lra|].
  apply (moved_far (conv A) (conv B) _ n); auto. intros t Ht. apply H; auto. apply hull_in, in_map. auto.
Qed.

(* the same of the width: of its own old place A gets clear by no less *)
Theorem width_every_map : forall A w f, 0 < w -> width2_is A w -> parted (conv (map f A)) (conv A) ->
  exists a, In a A /\ w <= norm2 (sub (f a) a).
Proof. intros A w f Hw W. apply depth_every_map, width_depth; auto. Qed.

(* ---- a plane parts what has no common point, interior to the one ---- *)
Lemma clear_parted : forall S T g, convex S -> convex T -> attains S -> attains T -> interior S g -> clear_of S T ->
  parted S T.
Proof.
  intros S T g CS CT AS AT Hg H.
  destruct (signed_depth_planed (difference_of T S)) as (v & [[V _] _] & n & h & Hn & Hb & Lh);
    [apply difference_of_convex; auto|apply attains_difference; auto|].
  assert (Pn := norm_pos n Hn). exists n. split; auto. intros s t Hs Ht.
  assert (B := Hb (sub t s) (ex_intro _ t (ex_intro _ s (conj Ht (conj Hs eq_refl))))). rewrite dot_sub_r in B.
  destruct (Rle_dec v 0) as [Z|Z]; [assert (v * norm n <= 0) by nra; lra|]. exfalso.
  (* else O is inside: with l (t1 - s1) = (1 - l) (g - t) the mean of t1 and t is that of s1 and g *)
  set (d := norm (sub g t)). assert (Nd : 0 <= d) by apply norm_nonneg. assert (Pv : 0 < v) by lra.
  set (k := v / (v + d) / 2). assert (Pi : 0 < / (v + d)) by (apply Rinv_0_lt_compat; lra).
  assert (Ek : 2 * k * (v + d) = v) by (unfold k; field; lra).
  assert (Pk : 0 < k) by (unfold k; repeat apply Rmult_lt_0_compat; lra).
  assert (I : difference_of T S (scal k (sub g t))).
  { apply interior_in, V; auto. apply norm_lt; [lra|]. rewrite norm_scal by lra. fold d. nra. }
  destruct I as (t1 & s1 & Ht1 & Hs1 & E). set (l := / (1 + k)).
  assert (Pl : 0 < l) by (apply Rinv_0_lt_compat; lra). assert (El : l * (1 + k) = 1) by (unfold l; field; lra).
  apply (H (add (scal l t1) (scal (1 - l) t))). split; [|apply CT; auto; nra].
  replace (add (scal l t1) (scal (1 - l) t)) with (add s1 (scal (1 - l) (sub g s1)));
    [apply step_inside; auto; nra|].
  assert (F : forall x y u w, k * (x - y) = u - w -> w + (1 - l) * (x - w) = l * u + (1 - l) * y).
  { intros x y u w F. replace (1 - l) with (l * k) by lra. replace u with (w + k * (x - y)) by lra.
    transitivity ((l * (1 + k)) * w + l * k * x - l * k * w + (1 - l * (1 + k)) * w); [ring|].
    transitivity (l * w + l * k * x); [|ring]. rewrite El. replace (l * k) with (1 - l) by lra. ring. }
  pteq; apply F; [apply (f_equal px) in E|apply (f_equal py) in E|apply (f_equal pz) in E]; exact E.
Qed.

(* ---- rigid motions ---- *)
Lemma mean_distance : forall x u v l, norm2 (sub x (add (scal l u) (scal (1 - l) v)))
  = l * norm2 (sub x u) + (1 - l) * norm2 (sub x v) - l * (1 - l) * norm2 (sub u v).
Proof. intros. unfold norm2, dot; simpl; ring. Qed.

Lemma rigid_affine : forall f u v l, rigid f ->
  f (add (scal l u) (scal (1 - l) v)) = add (scal l (f u)) (scal (1 - l) (f v)).
Proof.
  intros f u v l [H _]. apply sub_zero. rewrite mean_distance, !H, <- mean_distance.
  unfold norm2, dot; simpl; ring.
Qed.

Lemma image_convex : forall f S, rigid f -> convex S -> convex (image f S).
Proof.
  intros f S H C u v l Hl (s & Hs & ->) (t & Ht & ->). exists (add (scal l s) (scal (1 - l) t)). split; auto.
  symmetry. apply rigid_affine. auto.
Qed.

Lemma image_interior : forall f S g, rigid f -> interior S g -> interior (image f S) (f g).
Proof.
  intros f S g [H O] (e & He & B). exists e. split; auto. intros s Hs. destruct (O s) as (p & <-).
  rewrite H in Hs. exists p. auto.
Qed.

Lemma attains_rigid : forall f S, rigid f -> attains S -> attains (image f S).
Proof.
  intros f S [H _] A. apply (attains_image S _ f 1); [lra| |unfold image; tauto|auto].
  intros p q. unfold norm. rewrite H. lra.
Qed.

(* the hull of the corners' new places is where the corners' hull goes *)
Lemma parted_corners : forall f A T, parted (image f (conv A)) T -> parted (conv (map f A)) T.
Proof.
  intros f A T (n & Hn & H). exists n. split; auto. intros s t Hs Ht.
  assert (G : dot (scal (-1) n) s <= - dot n t); [|rewrite dot_scal_l in G; lra].
  revert s Hs. apply hull_halfspace. intros s Hs. apply in_map_iff in Hs. destruct Hs as (a & <- & Ia).
  rewrite dot_scal_l. assert (K := H (f a) t (ex_intro _ a (conj (hull_in _ _ Ia) eq_refl)) Ht). lra.
Qed.

(* if A has an interior, no rigid motion takes it off B with each corner moving less; and a translation
   does it with all points moving just as far *)
Theorem depth_every_motion : forall A B q f, depth2_is A B q -> (exists g, interior (conv A) g) -> rigid f ->
  clear_of (image f (conv A)) (conv B) -> exists a, In a A /\ q <= norm2 (sub (f a) a).
Proof.
  intros A B q f D (g & Hg) Hf C. apply (depth_every_map A B); auto. apply parted_corners.
  destruct (P_nonempty A B origin) as [HA HB]; [apply interior_in, (depth_interior _ _ _ D)|].
  apply (clear_parted _ _ (f g)); auto; [apply image_convex; auto; apply hull_convex|apply hull_convex| |
    apply (attains_core (Points B)); auto|apply image_interior; auto].
  apply attains_rigid; auto. apply (attains_core (Points A)). auto.
Qed.

Theorem depth_some_motion : forall A B q, depth2_is A B q -> (exists g, interior (conv A) g) ->
  exists f, rigid f /\ clear_of (image f (conv A)) (conv B) /\ forall p, norm2 (sub (f p) p) = q.
Proof.
  intros A B q D HA. destruct (P_nonempty A B origin) as [_ HB]; [apply interior_in, (depth_interior _ _ _ D)|].
  destruct (depth_AGHRS A B q HA HB D) as [_ (t & Nt & H)]. exists (fun p => add p t). split; [|split].
  - split; [intros u v; unfold norm2, dot; simpl; ring|]. intros p. exists (sub p t). pteq; ring.
  - intros p [Hp Bp]. apply (H p). split; auto. revert Hp. apply (interior_iff (image _ (conv A))).
    intros s. unfold translate. split.
    + intros (a & Ha & ->). replace (sub (add a t) t) with a by (pteq; ring). auto.
    + intros Hs. exists (sub s t). split; auto. pteq; ring.
  - intros p. replace (sub (add p t) p) with t by (pteq; ring). auto.
Qed.

(* of unions it holds of each pair of pieces, the deepest one included; of their own depth it does not
   (proofs/README.md) *)
Theorem pieces_every_motion : forall As Bs A B q f, solid_pieces As -> solid_pieces Bs -> In A As -> In B Bs ->
  depth2_is A B q -> rigid f -> (forall p, ~ (interior (image f (union As)) p /\ interior (union Bs) p)) ->
  exists a, In a A /\ q <= norm2 (sub (f a) a).
Proof.
  intros As Bs A B q f [_ SA] [_ SB] IA IB D Hf H. apply (depth_every_motion A B); auto. intros p [Hp Bp].
  destruct (SB B IB) as (g & Hg).
  destruct (common_interior _ _ p g (hull_convex _) Hp Bp Hg) as (x & (e & He & X) & Xb).
  apply (H x). split; [|apply (piece_interior Bs B); auto]. exists e. split; auto. intros s Hs.
  destruct (X s Hs) as (a & Ha & ->). exists a. split; auto. exists A. auto.
Qed.

(* ---- rounded and curved bodies ---- *)
Definition ball (r : R) (p : pt) : Prop := norm2 p <= r * r.

Lemma ball_norm : forall r p, ball r p <-> norm p <= Rabs r.
Proof.
  intros r p. unfold ball. rewrite <- norm_le by apply Rabs_pos. rewrite <- Rabs_mult, Rabs_right; [tauto|].
  apply Rle_ge, Rle_0_sqr.
Qed.
Lemma thick_sum : forall S r p, thick S r p <-> sum_of S (ball r) p.
Proof.
  intros S r p. split.
  - intros (s & Hs & N). exists s, (sub p s). split; auto. split; auto. pteq; ring.
  - intros (s & d & Hs & N & ->). exists s. replace (sub (add s d) s) with d by (pteq; ring). auto.
Qed.
Lemma attains_ball_of : forall r, attains (ball r).
Proof.
  intros r. apply (attains_iff (fun q => exists p, unit_ball p /\ q = scal r p)); [|apply attains_scal, attains_ball].
  intros q. unfold ball, unit_ball. split.
  - intros (p & Hp & ->). rewrite norm2_scal. assert (0 <= r * r) by apply Rle_0_sqr. nra.
  - intros Hq. destruct (Req_dec r 0) as [->|Z].
    + exists origin. rewrite norm2_origin. split; [lra|]. rewrite (norm2_zero q); [pteq; ring|].
      assert (N := norm2_nonneg q). lra.
    + exists (scal (/ r) q). split; [|pteq; field; auto]. rewrite norm2_scal. assert (Pr : 0 < r * r) by nra.
      apply Rmult_le_reg_l with (r * r); auto.
      replace (r * r * (/ r * / r * norm2 q)) with (norm2 q) by (field; auto). lra.
Qed.
Lemma ball_convex : forall r, convex (ball r).
Proof.
  intros r u v l Hl Hu Hv. apply ball_norm. apply ball_norm in Hu, Hv.
  assert (T := norm_triangle (scal l u) (scal (1 - l) v)). rewrite !norm_scal in T by lra. nra.
Qed.

Lemma body_convex : forall B, convex (in_body B).
Proof.
  intros B u v l Hl Hu Hv. unfold in_body in *. rewrite thick_sum in *.
  apply (sum_of_convex _ _ (in_core_convex (core_of B)) (ball_convex (radius B))); auto.
Qed.
Lemma attains_body : forall B, bounded_core (core_of B) -> attains (in_body B).
Proof.
  intros B H. apply (attains_iff (sum_of (in_core (core_of B)) (ball (radius B)))).
  - intros p. unfold in_body. rewrite thick_sum. tauto.
  - apply attains_sum; [apply attains_core; auto|apply attains_ball_of].
Qed.

(* a map of all points of A *)
Theorem body_every_map : forall A B v f, bounded_core (core_of A) -> at_least (gaps A B) v -> 0 < v ->
  parted (image f (in_body A)) (in_body B) -> exists a, in_body A a /\ v * v <= norm2 (sub (f a) a).
Proof.
  intros A B v f HA L Hv (n & Hn & H). destruct (attains_body A HA (dot n) (norm n)) as (a & Ha & Low).
  - split; [apply norm_nonneg|]. intros p q. assert (D := dot_le_norm n (sub p q)). rewrite dot_sub_r in D. lra.
  - exists a. split; auto. apply norm_ge; [lra|]. apply (moved_far (in_body A) (in_body B) _ n); auto.
    intros t Ht. apply H; auto. exists a. auto.
Qed.

(* a map of the corners of A, which is their hull with a radius and remains that *)
Theorem corners_every_map : forall A r B v f, at_least (gaps (Body (Points A) r) B) v -> 0 < v ->
  parted (in_body (Body (Points (map f A)) r)) (in_body B) -> exists a, In a A /\ v * v <= norm2 (sub (f a) a).
Proof.
  intros A r B v f L Hv (n & Hn & H). assert (Pn := norm_pos n Hn).
  assert (HA : A <> []).
  { assert (I : gaps (Body (Points A) r) B origin) by (apply interior_in, L; auto; rewrite norm2_origin; nra).
    intros ->. destruct I as (b & a & _ & (s & Hs & _) & _).
    apply (Hs (fun _ => False)); [intros u w l _ []|simpl; tauto]. }
  destruct (lowest_corner_of A n HA) as (a & Ia & Low). exists a. split; auto. apply norm_ge; [lra|].
  set (d := along n (Rabs r)). assert (Hd : dot n d = Rabs r * norm n) by (apply dot_along; auto).
  replace (sub (f a) a) with (sub (sub (f a) d) (sub a d)) by (pteq; ring).
  apply (moved_far (in_body (Body (Points A) r)) (in_body B) _ n); auto.
  - intros s Hs. apply thick_sum in Hs. destruct Hs as (c & e & Hc & He & ->). apply ball_norm in He.
    cbn [radius] in He. specialize (Low c Hc). assert (D := dot_le_norm n (scal (-1) e)).
    rewrite norm_minus, dot_scal_r in D.
    rewrite dot_sub_r, dot_add_r, Hd. nra.
  - intros t Ht. apply H; auto. apply thick_sum. exists (f a), (scal (-1) d).
    split; [apply hull_in, in_map; auto|]. split; [|pteq; ring]. apply ball_norm. rewrite norm_minus. unfold d.
    rewrite norm_along by (auto; apply Rabs_pos). apply Rle_refl.
Qed.

(* what a set with an interior is clear of is a half-space: its plane parts them *)
Lemma clear_half_space : forall S m c r g, convex S -> m <> origin -> interior S g ->
  clear_of S (thick (fun x => dot m x <= c) r) -> parted S (thick (fun x => dot m x <= c) r).
Proof.
  intros S m c r g CS Hm Hg H. assert (Pm := norm_pos m Hm). set (d := along m (Rabs r)).
  assert (Hd : dot m d = Rabs r * norm m) by (apply dot_along; auto).
  assert (I : forall x, dot m x <= c + Rabs r * norm m -> thick (fun x => dot m x <= c) r x).
  { intros x Hx. apply thick_sum. exists (sub x d), d. rewrite dot_sub_r. split; [lra|]. split; [|pteq; ring].
    apply ball_norm. unfold d. rewrite norm_along by (auto; apply Rabs_pos). lra. }
  exists m. split; auto. intros s t Hs Ht. apply thick_sum in Ht. destruct Ht as (x & e & Hx & He & ->).
  apply ball_norm in He. assert (D := dot_le_norm m e). rewrite dot_add_r. apply Rnot_lt_le. intros L.
  assert (Ls : dot m s < c + Rabs r * norm m) by nra. set (y := Rabs (dot m (sub g s))).
  assert (Py : dot m (sub g s) <= y) by apply Rle_abs. assert (Ny : 0 <= y) by apply Rabs_pos.
  set (z := c + Rabs r * norm m - dot m s) in *. assert (Pz : 0 < z) by (unfold z; lra). set (k := z / (z + y)).
  assert (Ek : k * (z + y) = z) by (unfold k; field; lra).
  assert (Pk : 0 < k) by (apply Rdiv_lt_0_compat; lra).
  apply (H (add s (scal k (sub g s)))). split; [apply step_inside; auto; nra|]. apply I.
  rewrite dot_add_r, dot_scal_r. fold z in Ls. assert (k * dot m (sub g s) <= k * y) by (apply Rmult_le_compat_l; lra).
  assert (k * y <= z) by nra. unfold z in *. lra.
Qed.

(* no rigid motion takes a body with an interior off another one with each point moving less *)
Theorem body_every_motion : forall A B v f, bounded_core (core_of A) ->
  bounded_core (core_of B) \/ half_space_core (core_of B) -> at_least (gaps A B) v -> 0 < v ->
  (exists g, interior (in_body A) g) -> rigid f -> clear_of (image f (in_body A)) (in_body B) ->
  exists a, in_body A a /\ v * v <= norm2 (sub (f a) a).
Proof.
  intros A B v f HA HB L Hv (g & Hg) Hf C. apply (body_every_map A B v f HA L Hv).
  assert (CA := image_convex f _ Hf (body_convex A)). assert (IA := image_interior f _ g Hf Hg).
  destruct HB as [HB|(n & d & E & Hn)].
  - apply (clear_parted _ _ (f g)); auto; [apply body_convex|apply attains_rigid; auto; apply attains_body; auto|].
    apply attains_body. auto.
  - unfold in_body in *. rewrite E in *. apply (clear_half_space _ _ _ _ (f g)); auto.
Qed.
