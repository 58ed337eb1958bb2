(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Completeness of the candidates: a direction is that of a facet of P exactly if it is that of a facet of B, or of -A, or
   normal to two crossing edges.  So the naive algorithm, which tries these, finds the depth. *)
Require Import Reals Lra Psatz List.
From Fathom.geometry Require Import meaning space hulls flats facets difference depth.
Import ListNotations.
Open Scope R_scope.

(* a difference on P's supporting plane is one of extreme points *)
Lemma extreme_difference : forall A B n h a b, height_is A B n h -> In a A -> In b B -> dot n (sub b a) = h ->
  extreme A (scal (-1) n) a /\ extreme B n b.
Proof.
  intros A B n h a b [Hh _] Ia Ib E. split; split; auto; intros x Ix.
  - rewrite !dot_scal_l. assert (G := Hh (sub b x)). rewrite dot_sub_r in *.
    assert (dot n b - dot n x <= h) by (apply G; apply hull_in; exists x, b; auto). lra.
  - assert (G := Hh (sub x a)). rewrite dot_sub_r in *.
    assert (dot n x - dot n a <= h) by (apply G; apply hull_in; exists a, x; auto). lra.
Qed.

Lemma extreme_height : forall A B n a b, extreme A (scal (-1) n) a -> extreme B n b -> height_is A B n (dot n (sub b a)).
Proof.
  intros A B n a b [Ia Ea] [Ib Eb]. split; [|exists (sub b a); split; auto; apply hull_in; exists a, b; auto].
  apply hull_halfspace. intros s (x & y & Ix & Iy & ->). specialize (Ea x Ix). specialize (Eb y Iy).
  rewrite !dot_scal_l in Ea. rewrite !dot_sub_r. lra.
Qed.

Lemma extreme_equal : forall L n p q, extreme L n p -> extreme L n q -> dot n p = dot n q.
Proof. intros L n p q [Ip Ep] [Iq Eq]. specialize (Ep q Iq). specialize (Eq p Ip). lra. Qed.

Lemma extreme_exists : forall L n, L <> [] -> exists p, extreme L n p.
Proof. intros L n H. destruct (greatest_exists (fun p => dot n p) L H) as (m & Hm & M). exists m. split; auto. Qed.

Lemma cross_swap : forall u v, cross u v <> origin -> cross v u <> origin.
Proof. intros u v H E. apply H. assert (F : cross u v = scal (-1) (cross v u)) by (pteq; ring). rewrite F, E. pteq; ring. Qed.

Theorem facet_kinds : forall A B n, A <> [] -> B <> [] ->
  (facet_direction A B n <-> facet_of B n \/ facet_of A (scal (-1) n) \/ crossing_edges A B n).
Proof.
  intros A B n HA HB. split.
  - intros (Hn & h & Hh & u & v & w & (a & b & Ia & Ib & ->) & (a' & b' & Ia' & Ib' & ->) & (a'' & b'' & Ia'' & Ib'' & ->)
      & U & V & W & Hc).
    destruct (extreme_difference _ _ _ _ _ _ Hh Ia Ib U) as [Ea Eb].
    destruct (extreme_difference _ _ _ _ _ _ Hh Ia' Ib' V) as [Ea' Eb'].
    destruct (extreme_difference _ _ _ _ _ _ Hh Ia'' Ib'' W) as [Ea'' Eb''].
    set (x := sub a' a) in *. set (x' := sub a'' a) in *. set (y := sub b' b) in *. set (y' := sub b'' b) in *.
    replace (cross (sub (sub b' a') (sub b a)) (sub (sub b'' a'') (sub b a)))
      with (add (sub (cross y y') (cross x y')) (sub (cross x x') (cross y x'))) in Hc
      by (unfold x, x', y, y'; pteq; ring).
    destruct (origin_dec (cross y y')) as [Z1|Z1]; [|left; split; auto; exists b, b', b''; auto].
    destruct (origin_dec (cross x x')) as [Z2|Z2].
    2:{ right; left. split; [|exists a, a', a''; auto].
        apply norm2_pos_inv. rewrite norm2_scal. assert (N := norm2_pos n Hn). lra. }
    right; right. split; auto.
    destruct (origin_dec (cross x y')) as [Z3|Z3]; [|exists a, a', b, b''; auto].
    exists a, a'', b, b'. repeat split; try apply Ea; try apply Ea''; try apply Eb; try apply Eb'.
    apply cross_swap. intros Z4. apply Hc. fold x' y in Z4. rewrite Z1, Z2, Z3, Z4. pteq; ring.
  - intros [(Hn & b & b' & b'' & E & E' & E'' & Hc)
    |[(Hn & a & a' & a'' & E & E' & E'' & Hc)
    |(Hn & a & a' & b & b' & Ea & Ea' & Eb & Eb' & Hc)]].
    + destruct (extreme_exists A (scal (-1) n) HA) as (a & Ea). split; auto.
      exists (dot n (sub b a)). split; [apply extreme_height; auto|].
      assert (G := extreme_equal B n). assert (F' := G _ _ E E'). assert (F'' := G _ _ E E'').
      exists (sub b a), (sub b' a), (sub b'' a). rewrite !dot_sub_r.
      repeat split; try lra; try (exists a; eexists; split; [apply Ea|split; [|reflexivity]]; first [apply E|apply E'|apply E'']).
      replace (cross _ _) with (cross (sub b' b) (sub b'' b)) by (pteq; ring). auto.
    + destruct (extreme_exists B n HB) as (b & Eb).
      assert (Hn' : n <> origin). { intros ->. apply Hn. pteq; ring. }
      split; auto. exists (dot n (sub b a)). split; [apply extreme_height; auto|].
      assert (G := extreme_equal A (scal (-1) n)). assert (F' := G _ _ E E'). assert (F'' := G _ _ E E'').
      rewrite !dot_scal_l in *.
      exists (sub b a), (sub b a'), (sub b a''). rewrite !dot_sub_r.
      repeat split; try lra; try (eexists; exists b; split; [|split; [apply Eb|reflexivity]]; first [apply E|apply E'|apply E'']).
      replace (cross _ _) with (cross (sub a' a) (sub a'' a)) by (pteq; ring). auto.
    + split; auto. exists (dot n (sub b a)). split; [apply extreme_height; auto|].
      assert (F := extreme_equal _ _ _ _ Ea Ea'). assert (F' := extreme_equal _ _ _ _ Eb Eb'). rewrite !dot_scal_l in F.
      exists (sub b a), (sub b a'), (sub b' a). rewrite !dot_sub_r.
      repeat split; try lra; try (do 2 eexists; split; [|split; [|reflexivity]]; first [apply Ea|apply Ea'|apply Eb|apply Eb']).
      replace (cross _ _) with (scal (-1) (cross (sub a' a) (sub b' b))) by (pteq; ring).
      intros Z. apply Hc. apply norm2_zero. assert (Z' : norm2 (scal (-1) (cross (sub a' a) (sub b' b))) = 0)
        by (rewrite Z; unfold norm2, dot; simpl; ring). rewrite norm2_scal in Z'. lra.
Qed.

(* the least of h(n)^2 / <n,n> over the facets of B, those of -A, and the crossing pairs of edges is the depth *)
Theorem naive_algorithm : forall A B q, interior (P A B) origin ->
  (depth2_is A B q <->
    (exists n h, (facet_of B n \/ facet_of A (scal (-1) n) \/ crossing_edges A B n) /\ height_is A B n h /\ q = h * h / norm2 n)
    /\ (forall n h, facet_of B n \/ facet_of A (scal (-1) n) \/ crossing_edges A B n -> height_is A B n h ->
          q <= h * h / norm2 n)).
Proof.
  intros A B q HO. destruct (P_nonempty _ _ _ (interior_in _ _ HO)) as [HA HB].
  apply (depth_candidates A B q (fun n => facet_of B n \/ facet_of A (scal (-1) n) \/ crossing_edges A B n)); auto.
  - intros n Hn. apply facet_kinds in Hn; auto. apply Hn.
  - intros n Hn. apply facet_kinds; auto.
Qed.
