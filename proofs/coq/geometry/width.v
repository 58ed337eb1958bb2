(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Proposition 2.1: the squared width of A is the squared depth of (A, A). *)
Require Import Reals Lra Psatz List.
From Fathom.geometry Require Import meaning space hulls flats facets difference depth.
Import ListNotations.
Open Scope R_scope.

(* the tightest slab in direction n is as thick as the support function of A - A is high *)
Lemma slab_of_height : forall A n h, n <> origin -> height_is A A n h -> exists lo hi, enclosed A n lo hi /\ hi - lo = h.
Proof.
  intros A n h Hn Hh. destruct Hh as [H1 (p & Hp & Ep)].
  destruct (P_nonempty A A p Hp) as [HA _].
  destruct (greatest_exists (fun s => dot n s) A HA) as (b & Ib & Mb).
  destruct (greatest_exists (fun s => dot (scal (-1) n) s) A HA) as (a & Ia & Ma).
  assert (Ma' : forall s, In s A -> dot n a <= dot n s).
  { intros s Hs. specialize (Ma s Hs). simpl in Ma. rewrite !dot_scal_l in Ma. lra. }
  exists (dot n a), (dot n b). split.
  - split; auto. split; [apply Ma'; auto|]. intros s Hs. split.
    + assert (G : dot (scal (-1) n) s <= dot (scal (-1) n) a) by (revert s Hs; apply hull_halfspace; auto).
      rewrite !dot_scal_l in G. lra.
    + revert s Hs. apply hull_halfspace. auto.
  - apply Rle_antisym.
    + rewrite <- dot_sub_r. apply H1. apply hull_in. exists a, b. auto.
    + rewrite <- Ep. revert p Hp Ep. intros p Hp _. revert p Hp. apply hull_halfspace.
      intros s (x & y & Ix & Iy & ->). rewrite dot_sub_r. specialize (Mb y Iy). specialize (Ma' x Ix). simpl in Mb. lra.
Qed.

Lemma height_of_slab : forall A n lo hi p, enclosed A n lo hi -> P A A p -> dot n p <= hi - lo.
Proof.
  intros A n lo hi p (_ & _ & H). revert p. apply hull_halfspace. intros s (x & y & Ix & Iy & ->).
  rewrite dot_sub_r. assert (X := H x (hull_in _ _ Ix)). assert (Y := H y (hull_in _ _ Iy)). lra.
Qed.

Lemma depth_is_width : forall A q, depth2_is A A q -> width2_is A q.
Proof.
  intros A q D. split.
  - intros n lo hi E. assert (Hn := proj1 E). assert (Hl := proj1 (proj2 E)).
    assert (HO := depth_interior _ _ _ D). destruct (P_nonempty _ _ _ (interior_in _ _ HO)) as [HA _].
    destruct (height_exists A A n HA HA) as (h & Hh).
    assert (L := depth_le_ratio A A q n h D Hn Hh). assert (Ph := height_positive A A n h HO Hn Hh).
    destruct Hh as [_ (p & Hp & Ep)]. assert (S := height_of_slab A n lo hi p E Hp). assert (N := norm2_pos n Hn).
    apply ratio_le; auto. apply ratio_le in L; auto. nra.
  - assert (HO := depth_interior _ _ _ D). apply (depth_minimum A A q HO) in D.
    destruct D as ((n & h & Hn & Hh & E) & _). destruct (slab_of_height A n h (proj1 Hn) Hh) as (lo & hi & S & Eh).
    exists n, lo, hi. split; auto. rewrite Eh. auto.
Qed.

Lemma width_unique : forall A w w', width2_is A w -> width2_is A w' -> w = w'.
Proof.
  intros A w w' [H1 (n & lo & hi & S & E)] [H2 (n' & lo' & hi' & S' & E')].
  specialize (H1 _ _ _ S'). specialize (H2 _ _ _ S). lra.
Qed.

(* a slab of thickness 0 if O is not interior to A - A *)
Lemma width_interior : forall A q, 0 < q -> width2_is A q -> interior (P A A) origin.
Proof.
  intros A q Hq [H _].
  assert (flat_zero : flat A -> False).
  { intros (n & h & Hn & F). assert (G := H n h h). replace ((h - h) * (h - h) / norm2 n) with 0 in G
      by (field; assert (N := norm2_pos n Hn); lra).
    assert (q <= 0); [|lra]. apply G. split; auto. split; [lra|]. intros a Ha. split.
    - assert (K : dot (scal (-1) n) a <= - h).
      { revert a Ha. apply hull_halfspace. intros s Hs. rewrite dot_scal_l, F by auto. lra. }
      rewrite dot_scal_l in K. lra.
    - revert a Ha. apply hull_halfspace. intros s Hs. rewrite F by auto. lra. }
  destruct (spanning_or_flat A) as [S|S]; [|exfalso; auto].
  destruct S as (a & b & c & d & Ia & Ib & Ic & Id & S).
  assert (HD : spanning (differences A A)).
  { exists (sub a a), (sub b a), (sub c a), (sub d a). rewrite !differences_in.
    repeat split; try (exists a; eexists; split; [auto|split; [|reflexivity]]; auto).
    replace (sub (sub b a) (sub a a)) with (sub b a) by (pteq; ring).
    replace (sub (sub c a) (sub a a)) with (sub c a) by (pteq; ring).
    replace (sub (sub d a) (sub a a)) with (sub d a) by (pteq; ring). auto. }
  destruct (finite_facets _ HD) as (F & F1 & F2).
  apply interior_P_conv. destruct (interior_or_facet _ F F2 origin) as [I|(f & If & G)]; auto.
  exfalso. destruct (F1 f If) as (u & v & w & Hf). apply facet_plane_P in Hf. destruct Hf as [[Hn _] Hh].
  replace (dot (fst f) origin) with 0 in G by (unfold dot, origin; simpl; ring).
  assert (Z : snd f = 0).
  { apply Rle_antisym; auto. destruct Hh as [Hh _].
    replace 0 with (dot (fst f) (sub a a)) by (unfold dot; simpl; ring). apply Hh. apply hull_in. exists a, a. auto. }
  destruct (slab_of_height A (fst f) (snd f) Hn Hh) as (lo & hi & S' & E).
  specialize (H _ _ _ S'). rewrite E, Z in H. unfold Rdiv in H. lra.
Qed.

Theorem width_depth : forall A q, 0 < q -> (width2_is A q <-> depth2_is A A q).
Proof.
  intros A q Hq. split; [|apply depth_is_width].
  intros W. assert (HO := width_interior A q Hq W). apply depth_exists in HO. destruct HO as (r & D).
  rewrite (width_unique A q r W (depth_is_width A r D)). auto.
Qed.
