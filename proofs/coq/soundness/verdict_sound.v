(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* THE THEOREM about the program's line: what it says is true of the points in the file. *)
Require Import Reals Lra List ZArith Lia Bool.
From Fathom.checker Require Import vector sequence certificate verdict.
From Fathom.geometry Require Import meaning space hulls flats facets difference said.
From Fathom.soundness Require Import statement booleans main facets_listed.
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
  destruct c as [qn qd complete dirs i|ln ld hn hd n i|n unit WA WB|n]; unfold says, says_of; cbv zeta; cbn [stated].
  - destruct H as (D & Hd & Hc). destruct (proj1 (depth_said _ _ _) D) as [Hq S]. split; [exact Hq|]. split; [exact S|].
    intros k E. destruct complete; [|discriminate]. inversion E. specialize (Hc eq_refl).
    apply (facets_exits _ _ _ _ D). exists (map (fun n => inj (fst n)) dirs).
    split; [rewrite count_length, map_length; reflexivity|]. split; [apply Hc|]. split; [exact Hd|]. split.
    + exact (every_facet_listed _ _ _ D _ Hd Hc).
    + exact (no_facet_twice _ _ _ _ Hd Hc).
  - destruct H as (q & D & L). exists q. apply depth_said in D. split; [apply D|]. split; [apply D|exact L].
  - apply touching_said. exact H.
  - intros X. apply H, P_gaps. exact X.
Qed.

(* with --width *)
Theorem verdict_width : forall m A B c s, verdict true m A B c = Some s ->
  says (map real A) (map real A) s /\ says_width (conv (map real A)).
Proof.
  intros m A B c s H. assert (S := verdict_sound _ _ _ _ _ _ H). apply verdict_accepts in H. destruct H as (_ & _ & E).
  rewrite <- (E eq_refl) in S. split; auto. destruct (map real A) as [|a L]; [|apply width_said; discriminate].
  intros q Hq G D. apply depth2_some in D; auto. destruct D as (b & _ & Hb & _).
  exfalso. apply (Hb (fun _ => False)); [intros u v l _ []|intros x []].
Qed.
