(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* P is the Minkowski difference conv B - conv A; and what the claims say about the two bodies themselves. *)
Require Import Reals Lra Psatz List.
From Fathom.geometry Require Import meaning space hulls flats facets farkas difference depth.
Import ListNotations.
Open Scope R_scope.

Lemma P_minkowski : forall A B p, P A B p <-> exists a b, conv A a /\ conv B b /\ p = sub b a.
Proof.
  intros A B p. split.
  - intros H. apply H.
    + intros u v l Hl (a & b & Ha & Hb & ->) (a' & b' & Ha' & Hb' & ->).
      exists (add (scal l a) (scal (1 - l) a')), (add (scal l b) (scal (1 - l) b')).
      repeat split; try (apply hull_convex; auto). pteq; ring.
    + intros s (a & b & Ia & Ib & ->). exists a, b. repeat split; apply hull_in; auto.
  - intros (a & b & Ha & Hb & ->).
    apply (Hb (fun b => P A B (sub b a))).
    { intros u v l Hl Hu Hv.
      replace (sub (add (scal l u) (scal (1 - l) v)) a)
        with (add (scal l (sub u a)) (scal (1 - l) (sub v a))) by (pteq; ring).
      apply hull_convex; auto. }
    intros b0 Ib. apply (Ha (fun a => P A B (sub b0 a))).
    { intros u v l Hl Hu Hv.
      replace (sub b0 (add (scal l u) (scal (1 - l) v)))
        with (add (scal l (sub b0 u)) (scal (1 - l) (sub b0 v))) by (pteq; ring).
      apply hull_convex; auto. }
    intros a0 Ia. apply hull_in. exists a0, b0. auto.
Qed.

(* the bodies meet exactly if O is in P *)
Theorem meet_iff : forall A B, P A B origin <-> exists p, conv A p /\ conv B p.
Proof.
  intros A B. rewrite P_minkowski. split.
  - intros (a & b & Ha & Hb & E). exists a. split; auto.
    replace a with b; auto. inversion E. pteq; lra.
  - intros (p & Ha & Hb). exists p, p. repeat split; auto. pteq; ring.
Qed.

(* the three states exclude each other, and there is no fourth *)
Theorem three_states : forall A B,
  ((exists q, depth2_is A B q) \/ touching A B \/ disjoint A B)
  /\ ~ ((exists q, depth2_is A B q) /\ touching A B)
  /\ ~ ((exists q, depth2_is A B q) /\ disjoint A B)
  /\ ~ (touching A B /\ disjoint A B).
Proof.
  intros A B. rewrite <- depth_exists. unfold touching, disjoint. split; [|split; [|split]].
  2:{ intros [H1 [_ H2]]. auto. }
  2:{ intros [H1 H2]. apply H2, interior_in, H1. }
  2:{ intros [[H1 _] H2]. auto. }
  destruct (conv_or_separated (differences A B) origin) as [C|(n & S)].
  - apply P_conv in C. destruct (spanning_or_flat (differences A B)) as [HS|HF].
    + destruct (finite_facets _ HS) as (F & F1 & F2).
      destruct (interior_or_facet _ F F2 origin) as [I|(f & If & G)].
      * left. apply interior_P_conv. auto.
      * right; left. split; auto. destruct (F1 f If) as (u & v & w & K). apply facet_plane_P in K. destruct K as [[Hn _] Hh].
        apply (beyond_not_interior A B (fst f) (snd f)); auto.
    + right; left. split; auto. rewrite interior_P_conv. apply flat_no_interior. auto.
  - right; right. intros C. apply P_conv in C.
    assert (K : forall s, In s (differences A B) -> dot (scal (-1) n) s >= 0 /\ dot n s < 0).
    { intros s Hs. specialize (S s Hs). rewrite dot_scal_l. replace (dot n origin) with 0 in S by (unfold dot, origin; simpl; ring). lra. }
    destruct (P_nonempty A B origin) as [HA HB]; [apply P_conv; auto|].
    destruct (greatest_exists (fun s => dot n s) (differences A B)) as (m & Hm & M).
    { destruct A; [congruence|]. destruct B; [congruence|]. discriminate. }
    assert (L : dot n origin <= dot n m) by (revert C; apply hull_halfspace; auto).
    specialize (K m Hm). replace (dot n origin) with 0 in L by (unfold dot, origin; simpl; ring). lra.
Qed.
