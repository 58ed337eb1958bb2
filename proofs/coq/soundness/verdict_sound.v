(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* THE THEOREM about the program's line: what it says is true of the points in the file. *)
Require Import Reals Lra List ZArith Lia Bool.
From Fathom.checker Require Import vector sequence certificate verdict.
From Fathom.geometry Require Import meaning space hulls flats facets difference depth width.
From Fathom.soundness Require Import statement booleans main printed facets_listed.
Import ListNotations.
Open Scope R_scope.

(* ---- integers over m are the file's rationals ---- *)
Lemma units_value : forall m r, (0 < m)%Z -> divides m r = true -> IZR (units m r) / IZR m = value r.
Proof.
  intros m [n d] Hm H. unfold divides, units, value in *. cbn [num den] in *. bsplit. rename H into Hd, H0 into E.
  set (k := (m / d)%Z) in *. clearbody k. subst m. assert (Hk : (0 < k)%Z) by nia.
  assert (Rd : 0 < IZR d) by (apply IZR_lt; auto). assert (Rk : 0 < IZR k) by (apply IZR_lt; auto).
  rewrite !mult_IZR. field. lra.
Qed.

Lemma integral_real : forall m L, (0 < m)%Z -> forallb (fits m) L = true ->
  map (frac m) (each (integral m) L) = map real L.
Proof.
  intros m L Hm H. rewrite each_map, map_map. apply map_ext_in. intros p Hp.
  assert (F := forallb_In _ _ _ H p Hp). unfold fits in F. bsplit.
  unfold real. pteq; apply units_value; auto.
Qed.

Lemma same_vectors_eq : forall A B, same_vectors A B = true -> A = B.
Proof.
  induction A as [|u A IH]; intros [|v B] H; try discriminate; auto. simpl in H.
  destruct (same_vector u v) eqn:E; [|discriminate]. apply same_vector_spec in E. f_equal; auto.
Qed.

Lemma count_length : forall (T : Type) (l : list T), count l = Z.of_nat (length l).
Proof.
  intros T l. unfold count. assert (G : forall l n, fold_left (fun n (_ : T) => (n + 1)%Z) l n = (n + Z.of_nat (length l))%Z).
  { induction l0 as [|a l0 IH]; intros n; [simpl; lia|]. cbn [fold_left length]. rewrite IH. lia. }
  rewrite G. lia.
Qed.

Lemma verdict_accepts : forall width m A B c s, verdict width m A B c = Some s ->
  s = stated c /\ holds (map real A) (map real B) c /\ (width = true -> map real A = map real B).
Proof.
  intros width m A B c s H. unfold verdict in H. cbv zeta in H.
  destruct (forallb (fits m) A && forallb (fits m) B && _ && check _) eqn:E; [|discriminate].
  inversion H as [S]. clear H S. bsplit. rename H into FA, H2 into FB, H1 into W, H0 into C.
  assert (Hm : (0 < m)%Z) by (unfold check in C; bsplit; auto).
  split; auto. split.
  - apply check_sound in C. unfold meaning_of in C. cbn [with_integers scale body_a body_b claimed] in C.
    rewrite !integral_real in C; auto.
  - intros ->. cbn [negb orb] in W. apply same_vectors_eq in W. cbn [with_integers body_a body_b] in W.
    rewrite <- (integral_real m A), <- (integral_real m B), W; auto.
Qed.

Theorem verdict_sound : forall width m A B c s, verdict width m A B c = Some s -> says (map real A) (map real B) s.
Proof.
  intros width m A B c s H. apply verdict_accepts in H. destruct H as (-> & H & _).
  destruct c as [qn qd complete dirs i|ln ld hn hd n i|n unit WA WB|n]; auto.
  destruct H as (D & Hd & Hc). split; auto. destruct complete; auto. specialize (Hc eq_refl).
  exists (map (fun n => inj (fst n)) dirs). split; [rewrite count_length, map_length; reflexivity|].
  split; [apply Hc|]. split; [exact Hd|]. split.
  - exact (every_facet_listed _ _ _ D _ Hd Hc).
  - exact (no_facet_twice _ _ _ _ Hd Hc).
Qed.

(* ---- the width ---- *)
(* A lies in a plane if O is in A - A, but not inside *)
Lemma flat_width : forall A, touching A A -> width2_is A 0.
Proof.
  intros A [HP NI]. destruct (P_nonempty A A origin HP) as [HA _]. split.
  - intros n lo hi (Hn & _ & _). apply ratio_le; [apply norm2_pos; auto|]. rewrite Rmult_0_l. apply Rle_0_sqr.
  - assert (F : exists n, n <> origin /\ height_is A A n 0).
    { destruct (spanning_or_flat (differences A A)) as [S|(n & h & Hn & F)].
      - destruct (finite_facets _ S) as (F & F1 & F2).
        destruct (interior_or_facet _ F F2 origin) as [I|(f & If & G)].
        + exfalso. apply NI, interior_P_conv. auto.
        + destruct (F1 f If) as (u & v & w & Hf). apply facet_plane_P in Hf. destruct Hf as [[Hn _] Hh].
          exists (fst f). split; auto. replace 0 with (snd f); auto.
          assert (Z : dot (fst f) origin = 0) by (unfold dot, origin; simpl; ring).
          destruct Hh as [Hh _]. specialize (Hh origin HP). lra.
      - exists n. split; auto.
        assert (Z : forall s, diffs A A s -> dot n s = 0).
        { assert (E : h = 0).
          { destruct A as [|a A']; [congruence|]. rewrite <- (F (sub a a)).
            - unfold dot; simpl; ring.
            - apply differences_in. exists a, a. simpl; auto. }
          intros s Hs. rewrite <- E. apply F, differences_in. auto. }
        split; [|exists origin; split; auto; unfold dot, origin; simpl; ring].
        apply hull_halfspace. intros s Hs. rewrite Z by auto. lra. }
    destruct F as (n & Hn & Hh). destruct (slab_of_height A n 0 Hn Hh) as (lo & hi & E & W).
    exists n, lo, hi. split; auto. rewrite W. field. assert (N := norm2_pos n Hn). lra.
Qed.

Theorem verdict_width : forall m A B c s, verdict true m A B c = Some s -> says_width (map real A) s.
Proof.
  intros m A B c s H. assert (S := verdict_sound _ _ _ _ _ _ H).
  assert (N : s = They_are_apart -> map real A <> []).
  { intros -> E. apply verdict_accepts in H as H'. destruct H' as (Es & _ & _).
    destruct A as [|a A']; [|discriminate]. clear E. destruct c; try discriminate.
    unfold verdict, check, check_disjoint, support.height_is, support.height in H. simpl in H.
    destruct (support.greatest n _); simpl in H; rewrite ?andb_false_r in H; discriminate. }
  apply verdict_accepts in H. destruct H as (_ & _ & E). rewrite <- (E eq_refl) in S.
  destruct s as [q k|lo hi| |]; cbn [says says_width] in *.
  - apply depth_is_width, S.
  - destruct S as (w & D & L). exists w. split; auto. apply depth_is_width. auto.
  - apply flat_width. auto.
  - destruct (map real A) as [|a L] eqn:EA; [apply N; auto|]. apply S. apply hull_in. exists a, a.
    simpl. split; auto. split; auto. pteq; ring.
Qed.
