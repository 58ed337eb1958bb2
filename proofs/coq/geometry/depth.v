(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The depth exists, is unique, and is the least distance of a facet's plane from O; its optima are foot points on facets. *)
Require Import Reals Lra Psatz List.
From Fathom.geometry Require Import meaning space hulls flats facets difference.
Import ListNotations.
Open Scope R_scope.

Theorem depth2_unique : forall A B q r, depth2_is A B q -> depth2_is A B r -> q = r.
Proof.
  intros A B q r (_ & H1 & t & Ht & H2) (_ & H3 & s & Hs & H4).
  destruct (Rtotal_order q r) as [L|[E|L]]; auto; exfalso.
  - apply H2, H3. lra.
  - apply H4, H1. lra.
Qed.

Lemma depth_interior : forall A B q, depth2_is A B q -> interior (P A B) origin.
Proof. intros A B q (Hq & H & _). apply H. unfold norm2, dot; simpl. lra. Qed.

(* with O interior, every point is interior or beyond the plane of one of finitely many facets *)
Lemma facet_list : forall A B, interior (P A B) origin -> exists F : list (pt * R),
  (forall f, In f F -> facet_direction A B (fst f) /\ height_is A B (fst f) (snd f))
  /\ forall t, interior (P A B) t \/ exists f, In f F /\ snd f <= dot (fst f) t.
Proof.
  intros A B HO. destruct (finite_facets _ (interior_spanning _ _ _ HO)) as (F & F1 & F2).
  exists F. split.
  - intros f Hf. destruct (F1 f Hf) as (u & v & w & G). apply facet_plane_P in G. auto.
  - intros t. rewrite interior_P_conv. apply interior_or_facet. auto.
Qed.

Lemma height_positive : forall A B n h, interior (P A B) origin -> n <> origin -> height_is A B n h -> 0 < h.
Proof.
  intros A B n h HO Hn Hh. apply Rnot_le_lt. intros L. revert HO. apply (beyond_not_interior A B n h); auto.
  unfold dot, origin; simpl. lra.
Qed.

Lemma foot_norm2 : forall n h, n <> origin -> norm2 (scal (h / norm2 n) n) = h * h / norm2 n.
Proof. intros n h Hn. rewrite norm2_scal. field. assert (N := norm2_pos n Hn). lra. Qed.
Lemma foot_dot : forall n h, n <> origin -> dot n (scal (h / norm2 n) n) = h.
Proof. intros n h Hn. rewrite dot_scal_r. fold (norm2 n). field. assert (N := norm2_pos n Hn). lra. Qed.

Lemma ratio_le : forall h N q, 0 < N -> (q <= h * h / N <-> q * N <= h * h).
Proof.
  intros h N q HN. assert (E : h * h / N * N = h * h) by (field; lra). split; intros H.
  - rewrite <- E. nra.
  - apply Rmult_le_reg_r with N; lra.
Qed.

(* a plane with P on one side is not nearer than the depth *)
Lemma depth_le_ratio : forall A B q n h, depth2_is A B q -> n <> origin -> height_is A B n h -> q <= h * h / norm2 n.
Proof.
  intros A B q n h (_ & H & _) Hn Hh. apply Rnot_lt_le. intros L.
  apply (beyond_not_interior A B n h (scal (h / norm2 n) n)); auto.
  - rewrite foot_dot; auto. lra.
  - apply H. rewrite foot_norm2; auto.
Qed.

(* a point that is not interior is beyond a facet, which it bounds the distance of *)
Lemma beyond_ratio : forall n h t, n <> origin -> 0 < h -> h <= dot n t -> h * h / norm2 n <= norm2 t.
Proof.
  intros n h t Hn Hh Ht. assert (N := norm2_pos n Hn). assert (C := cauchy n t).
  apply Rmult_le_reg_r with (norm2 n); auto.
  replace (h * h / norm2 n * norm2 n) with (h * h) by (field; lra). nra.
Qed.

Lemma nearest_in : forall F : list (pt * R), F = [] \/ exists f, In f F /\ forall g, In g F ->
  snd f * snd f / norm2 (fst f) <= snd g * snd g / norm2 (fst g).
Proof.
  induction F as [|f F IH]; auto. right. destruct IH as [->|(m & Hm & M)].
  - exists f. split; [simpl; auto|]. intros g [<-|[]]. lra.
  - destruct (Rle_dec (snd f * snd f / norm2 (fst f)) (snd m * snd m / norm2 (fst m))) as [L|L].
    + exists f. split; [simpl; auto|]. intros g [<-|Hg]; [lra|]. specialize (M g Hg). lra.
    + exists m. split; [simpl; auto|]. intros g [<-|Hg]; [lra|auto].
Qed.

Theorem depth_exists : forall A B, interior (P A B) origin <-> exists q, depth2_is A B q.
Proof.
  intros A B. split; [|intros (q & H); apply (depth_interior _ _ _ H)].
  intros HO. destruct (facet_list A B HO) as (F & F1 & F2).
  assert (pos : forall f, In f F -> fst f <> origin /\ 0 < snd f).
  { intros f Hf. destruct (F1 f Hf) as [[Hn _] Hh]. split; auto. apply (height_positive A B (fst f)); auto. }
  destruct (nearest_in F) as [->|(f & If & M)].
  - exfalso. destruct (P_nonempty A B origin (interior_in _ _ HO)) as [HA HB].
    destruct (height_exists A B (mk 1 0 0) HA HB) as (h & Hh).
    destruct (F2 (scal h (mk 1 0 0))) as [I|(f & [] & _)].
    revert I. apply (beyond_not_interior A B (mk 1 0 0) h); auto.
    + intros E. inversion E. lra.
    + unfold dot; simpl. lra.
  - destruct (pos f If) as [Hn Hh]. destruct (F1 f If) as [_ Hf].
    assert (N := norm2_pos _ Hn).
    exists (snd f * snd f / norm2 (fst f)). repeat split.
    + apply Rdiv_lt_0_compat; auto. nra.
    + intros t Ht. destruct (F2 t) as [I|(g & Ig & G)]; auto. exfalso.
      destruct (pos g Ig) as [Gn Gh]. specialize (M g Ig).
      assert (R := beyond_ratio (fst g) (snd g) t Gn Gh G). lra.
    + exists (scal (snd f / norm2 (fst f)) (fst f)). split; [apply foot_norm2; auto|].
      apply (beyond_not_interior A B (fst f) (snd f)); auto. rewrite foot_dot; auto. lra.
Qed.

(* equality in Cauchy-Schwarz: a point at the distance of a plane, not below it, is its foot point *)
Lemma foot_only : forall n h t q, n <> origin -> 0 < h -> norm2 t = q -> q * norm2 n <= h * h -> h <= dot n t ->
  h * h = q * norm2 n /\ t = scal (h / norm2 n) n.
Proof.
  intros n h t q Hn Hh Ht Hq Hd. assert (N := norm2_pos n Hn). assert (C := cauchy n t). rewrite Ht in C.
  assert (E : dot n t = h) by nra.
  assert (Eq : h * h = q * norm2 n) by (rewrite E in C; lra). split; auto.
  apply sub_zero. rewrite norm2_sub, dot_scal_r, (dot_comm t n), E, foot_norm2, Ht by auto.
  apply Rmult_eq_reg_r with (norm2 n); [|lra].
  replace ((q - 2 * (h / norm2 n * h) + h * h / norm2 n) * norm2 n) with (q * norm2 n - h * h) by (field; lra). lra.
Qed.

(* the nearest points of P's boundary are the foot points on its nearest facets' planes *)
Theorem nearest_points : forall A B q t, depth2_is A B q -> norm2 t = q ->
  (~ interior (P A B) t <-> exists n, facet_direction A B n /\ foot A B n t).
Proof.
  intros A B q t D Ht. assert (HO := depth_interior _ _ _ D). split.
  - intros NI. destruct (facet_list A B HO) as (F & F1 & F2).
    destruct (F2 t) as [I|(f & If & G)]; [contradiction|].
    destruct (F1 f If) as [Hf Hh]. assert (Hn := proj1 Hf).
    assert (Ph := height_positive A B _ _ HO Hn Hh).
    assert (L := depth_le_ratio A B q _ _ D Hn Hh). apply ratio_le in L; [|apply norm2_pos; auto].
    destruct (foot_only _ _ _ _ Hn Ph Ht L G) as [_ E].
    exists (fst f). split; auto. exists (snd f). auto.
  - intros (n & [Hn _] & h & Hh & ->). apply (beyond_not_interior A B n h); auto. rewrite foot_dot; auto. lra.
Qed.

Lemma facet_direction_multiple : forall A B n k, 0 < k -> facet_direction A B n -> facet_direction A B (scal k n).
Proof.
  intros A B n k Hk (Hn & h & Hh & u & v & w & Du & Dv & Dw & U & V & W & Hc). split.
  - apply norm2_pos_inv. rewrite norm2_scal. assert (N := norm2_pos n Hn). repeat apply Rmult_lt_0_compat; auto.
  - exists (k * h). split.
    + destruct Hh as (H & p & Hp & E). split; [|exists p; rewrite dot_scal_l, E; auto].
      intros s Hs. rewrite dot_scal_l. specialize (H s Hs). nra.
    + exists u, v, w. rewrite !dot_scal_l, U, V, W. auto 10.
Qed.

(* a supporting plane at the distance of the depth is that of a facet *)
Theorem nearest_plane : forall A B q n h, depth2_is A B q -> n <> origin -> height_is A B n h -> h * h = q * norm2 n ->
  facet_direction A B n /\ norm2 (scal (h / norm2 n) n) = q.
Proof.
  intros A B q n h D Hn Hh E. assert (N := norm2_pos n Hn). assert (HO := depth_interior _ _ _ D).
  assert (Ph := height_positive A B n h HO Hn Hh).
  assert (Et : norm2 (scal (h / norm2 n) n) = q).
  { rewrite foot_norm2, E by auto. field. lra. }
  split; auto.
  assert (NI : ~ interior (P A B) (scal (h / norm2 n) n)).
  { apply (beyond_not_interior A B n h); auto. rewrite foot_dot; auto. lra. }
  apply (nearest_points A B q _ D Et) in NI. destruct NI as (m & Hm & k & Hk & Ek).
  assert (Pk := height_positive A B m k HO (proj1 Hm) Hk). assert (M := norm2_pos m (proj1 Hm)).
  assert (Pa : 0 < h / norm2 n) by (apply Rdiv_lt_0_compat; auto).
  assert (Pb : 0 < k / norm2 m) by (apply Rdiv_lt_0_compat; auto).
  replace n with (scal (/ (h / norm2 n) * (k / norm2 m)) m).
  - apply facet_direction_multiple; auto. apply Rmult_lt_0_compat; auto. apply Rinv_0_lt_compat; auto.
  - rewrite <- scal_scal, <- Ek, scal_scal, Rinv_l by lra. apply scal_1.
Qed.

(* the naive algorithm: the depth is the least h^2/|n|^2 over the directions of facets of P *)
Theorem depth_minimum : forall A B q, interior (P A B) origin ->
  (depth2_is A B q <->
    (exists n h, facet_direction A B n /\ height_is A B n h /\ q = h * h / norm2 n)
    /\ (forall n h, facet_direction A B n -> height_is A B n h -> q <= h * h / norm2 n)).
Proof.
  assert (fwd : forall A B q, depth2_is A B q ->
    (exists n h, facet_direction A B n /\ height_is A B n h /\ q = h * h / norm2 n)
    /\ (forall n h, facet_direction A B n -> height_is A B n h -> q <= h * h / norm2 n)).
  { intros A B q D. split; [|intros n h [Hn _] Hh; apply (depth_le_ratio A B); auto].
    assert (D' := D). destruct D' as (_ & _ & t & Ht & NI).
    apply (nearest_points A B q t D Ht) in NI. destruct NI as (n & Hn & h & Hh & Et).
    exists n, h. repeat split; auto; try apply Hn; try apply Hh. rewrite <- Ht, Et, foot_norm2; auto. apply Hn. }
  intros A B q HO. split; [apply fwd|]. intros ((n & h & Hn & Hh & E) & L).
  apply depth_exists in HO. destruct HO as (r & D). destruct (fwd A B r D) as ((m & k & Hm & Hk & Er) & M).
  assert (L1 := L m k Hm Hk). assert (L2 := M n h Hn Hh). replace q with r; auto. lra.
Qed.

(* whatever planes are tried beside those of the facets do no harm *)
Theorem depth_candidates : forall A B q (candidate : pt -> Prop), interior (P A B) origin ->
  (forall n, candidate n -> n <> origin) -> (forall n, facet_direction A B n -> candidate n) ->
  (depth2_is A B q <->
    (exists n h, candidate n /\ height_is A B n h /\ q = h * h / norm2 n)
    /\ (forall n h, candidate n -> height_is A B n h -> q <= h * h / norm2 n)).
Proof.
  intros A B q candidate HO C0 C1. split.
  - intros D. split; [|intros n h Hn Hh; apply (depth_le_ratio A B); auto].
    apply depth_minimum in D; auto. destruct D as ((n & h & Hn & Hh & E) & _). exists n, h. auto.
  - intros ((n & h & Hn & Hh & E) & L). assert (HO' := HO). apply depth_exists in HO'. destruct HO' as (r & D).
    assert (L2 := depth_le_ratio A B r n h D (C0 n Hn) Hh).
    assert (D' := D). apply depth_minimum in D'; auto. destruct D' as ((m & k & Hm & Hk & Er) & M).
    assert (L1 := L m k (C1 m Hm) Hk). replace q with r by lra. exact D.
Qed.
