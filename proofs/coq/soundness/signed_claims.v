(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Format 2: each claim that passes its check is true of the cores, in units of 1/scale. *)
Require Import Reals Lra Psatz List ZArith Lia Bool.
From Fathom.checker Require Import vector sequence table polytope support certificate body cone signed.
From Fathom.geometry Require Import meaning bodies space norm hulls difference depth minkowski signed_depth rounded curved gaps cones.
From Fathom.soundness Require Import statement booleans upper lower optima main signed_sides cone_sound.
Import ListNotations.
Open Scope R_scope.

(* ---- each claim, of the cores in units of 1/m ---- *)
Lemma height_root_planed : forall A B qn qd n, (0 < qd)%Z -> height_root A B qn qd n = true ->
  planed (zgaps A B) (signed_root (IZR qn / IZR qd)).
Proof.
  intros A B qn qd n Hqd H. destruct (height_root_sound A B qn qd n Hqd H) as (h & d & _ & _ & Hn & Hb & E).
  exists (inj n), (IZR h / IZR d). rewrite E in *. repeat split; auto. lra.
Qed.

Lemma zgaps_points : forall LA LB p, zgaps (Points LA) (Points LB) p <-> P (map inj LA) (map inj LB) p.
Proof.
  intros LA LB p. rewrite P_minkowski. unfold zgaps. simpl. rewrite !each_map. split.
  - intros (b & a & Hb & Ha & E). exists a, b. auto.
  - intros (a & b & Ha & Hb & E). exists b, a. auto.
Qed.

Lemma nodup_map : forall (T U : Type) (f : T -> U) l, (forall x y, In x l -> In y l -> f x = f y -> x = y) -> NoDup l -> NoDup (map f l).
Proof.
  induction l as [|a l IH]; intros H N; simpl; constructor; inversion N; subst.
  - intros I0. apply in_map_iff in I0. destruct I0 as (y & E & Iy). apply H in E; simpl; auto. subst. contradiction.
  - apply IH; auto. intros x y Ix Iy. apply H; simpl; auto.
Qed.

(* format 1's claim, in the words of format 2 *)
Lemma deep_sound : forall LA LB qn qd complete dirs q, check_depth LA LB qn qd complete dirs q = true ->
  let s := signed_root (IZR qn / IZR qd) in
  0 < s /\ at_least (zgaps (Points LA) (Points LB)) s /\ planed (zgaps (Points LA) (Points LB)) s
  /\ (complete = true -> let ns := map (fun n => inj (fst n)) dirs in
        (forall n, In n ns -> n <> origin /\ beneath (zgaps (Points LA) (Points LB)) n (s * norm n))
        /\ NoDup (map (fun n => along n 1) ns)
        /\ forall t, way_out (zgaps (Points LA) (Points LB)) s t -> exists n, In n ns /\ t = along n s).
Proof.
  intros LA LB qn qd complete dirs q H s. assert (D := check_depth_sound LA LB qn qd complete dirs q H).
  destruct D as (D & Hdirs & Hall). set (x := IZR qn / IZR qd) in *.
  assert (Px := proj1 D). assert (Es : s = root x). { unfold s, signed_root. destruct (Rle_dec 0 x); [auto|lra]. }
  assert (Ps : 0 < s) by (rewrite Es; apply root_positive; auto).
  assert (Ess : s * s = x) by (rewrite Es; apply root_sqr; lra).
  assert (SD : signed_depth (P (map inj LA) (map inj LB)) s) by (apply signed_depth_depth; [auto|rewrite Ess; auto]).
  assert (iff : forall p, P (map inj LA) (map inj LB) p <-> zgaps (Points LA) (Points LB) p) by (intros; symmetry; apply zgaps_points).
  split; auto. split; [apply (at_least_iff _ _ _ iff); apply SD|]. split.
  - destruct (P_nonempty _ _ _ (interior_in _ _ (depth_interior _ _ _ D))) as [NA NB].
    destruct (polytope_planed _ _ _ NA NB SD) as (n & h & Hn & Hb & L). exists n, h. repeat split; auto. intros p Hp. apply Hb, iff. auto.
  - intros Hc ns. specialize (Hall Hc). fold ns in Hall, Hdirs. destruct Hall as (C1 & C2 & C3).
    assert (plane : forall n, In n ns -> n <> origin /\ exists h, height_is (map inj LA) (map inj LB) n h /\ h = s * norm n
        /\ scal (h / norm2 n) n = along n s).
    { intros n Hn. destruct (Hdirs n Hn) as ((Nz & _) & t & (h & Hh & Et) & Nt). split; auto. exists h. split; auto.
      assert (Ph := height_positive _ _ n h (depth_interior _ _ _ D) Nz Hh). assert (Pn := norm_pos n Nz).
      rewrite Et, foot_norm2 in Nt by auto.
      assert (E : h = s * norm n).
      { apply signed_sqr_inj. rewrite !signed_sqr_pos by (try apply Rmult_le_pos; lra).
        replace (s * norm n * (s * norm n)) with (s * s * (norm n * norm n)) by ring. rewrite Ess, norm_sqr, <- Nt. field.
        apply Rgt_not_eq, norm2_pos. auto. }
      split; auto. unfold along. f_equal. rewrite E, <- norm_sqr. field. lra. }
    split; [|split].
    + intros n Hn. destruct (plane n Hn) as (Nz & h & Hh & E & _). split; auto. intros p Hp. rewrite <- E. apply Hh, iff. auto.
    + apply nodup_map; auto. intros n k Hn Hk E. apply (C2 n k (along n s)); auto.
      * destruct (plane n Hn) as (_ & h & Hh & _ & Ea). exists h. auto.
      * destruct (plane k Hk) as (_ & h & Hh & _ & Ea). exists h. split; auto. rewrite Ea.
        replace (along n s) with (scal s (along n 1)) by (unfold along; pteq; unfold Rdiv; ring).
        rewrite E. unfold along. pteq; unfold Rdiv; ring.
    + intros t [Nt NI]. rewrite Ess in Nt.
      assert (NI' : ~ interior (P (map inj LA) (map inj LB)) t) by (rewrite (interior_iff _ _ _ iff); auto).
      apply (C1 t Nt) in NI'. destruct NI' as (n & Hn & h & Hh & Et). exists n. split; auto.
      destruct (plane n Hn) as (_ & h' & Hh' & _ & Ea). rewrite Et, (height_unique _ _ _ _ _ Hh Hh'). auto.
Qed.

Lemma inside_self : forall L, inside (Points L) 1 L.
Proof.
  intros L p Ip. simpl. rewrite each_map. replace (scal (/ 1) (inj p)) with (inj p) by (pteq; field). apply hull_in, in_map. auto.
Qed.

Lemma beside_sound : forall LA LB qn qd n unit WA WB all, check_beside (Points LA) (Points LB) qn qd n unit WA WB all = true ->
  let s := signed_root (IZR (- qn) / IZR qd) in
  at_least (zgaps (Points LA) (Points LB)) s /\ planed (zgaps (Points LA) (Points LB)) s
  /\ forall k, all = Some k -> s = 0 /\ generated (polar (zgaps (Points LA) (Points LB))) (map inj (lineality k)) (map (fun r => inj
    (fst r)) (rays k)).
Proof.
  intros LA LB qn qd n unit WA WB all H s. unfold check_beside in H. apply andb_true_iff in H. destruct H as [H Hall].
  apply andb_true_iff in H. destruct H as [H Hmean]. bsplit. rename H into Hqn, H1 into Hqd, H0 into Hh.
  assert (Pd := IZR_pos _ Hqd). apply IZR_le in Hqn as Rn.
  assert (E : signed_sqr s = - (IZR qn / IZR qd)).
  { unfold s. rewrite signed_sqr_root, opp_IZR. unfold Rdiv. ring. }
  assert (Q : 0 <= IZR qn / IZR qd) by (apply Rmult_le_pos; [auto|left; apply Rinv_0_lt_compat; auto]).
  assert (S0 : s <= 0). { apply signed_sqr_le. rewrite E, signed_sqr_pos by lra. lra. }
  split; [|split; [apply (height_root_planed _ _ _ _ n); auto|]].
  - destruct (mean_is_sound _ (Points LA) (Points LB) 1 LA LB unit WA WB eq_refl (inside_self LA) (inside_self LB) Hmean) as (z & T &
    Hu & Hz).
    apply Z.eqb_eq in T. apply (f_equal IZR) in T. rewrite !mult_IZR, norm2_inj in T. assert (Pu := IZR_pos _ Hu).
    apply (point_least _ _ _ Hz); auto. rewrite signed_sqr_neg in E by auto. rewrite norm2_scal.
    replace (s * s) with (IZR qn / IZR qd) by lra. right. apply Rmult_eq_reg_r with (IZR unit * IZR unit * IZR qd); [|apply Rgt_not_eq;
      repeat apply Rmult_lt_0_compat; auto].
    replace (/ (IZR unit * 1) * / (IZR unit * 1) * norm2 (inj z) * (IZR unit * IZR unit * IZR qd)) with (norm2 (inj z) * IZR qd) by
      (field; lra).
    rewrite T. field. lra.
  - intros k ->. bsplit. split.
    + apply signed_sqr_inj. rewrite E, H, signed_sqr_pos by lra. unfold Rdiv. ring.
    + assert (C := cone_sound LA LB k H0). destruct C as (C1 & C2 & C3 & C4 & C5).
      assert (iff : forall u, polar (zgaps (Points LA) (Points LB)) u <-> polar (P (map inj LA) (map inj LB)) u).
      { intros u. split; intros H' p Hp; apply H'; apply zgaps_points; auto. }
      split; [intros u; rewrite iff; auto|]. split; auto. split; auto. split; auto. intros r Ir K. apply (C4 r Ir). apply iff. auto.
Qed.

Lemma on_plane_sound : forall A B qn qd n, check_on_plane A B qn qd n = true ->
  let s := signed_root (IZR qn / IZR qd) in at_least (zgaps A B) s /\ planed (zgaps A B) s.
Proof.
  intros A B qn qd n H s. unfold check_on_plane in H. bsplit. rename H into Hkind, H1 into Hqd, H0 into Hh.
  split; [|apply (height_root_planed _ _ _ _ n); auto].
  destruct (height_root_sound A B qn qd n Hqd Hh) as (h & d & E & Pd & Hn & _ & Eh). fold s in Eh.
  apply (half_space_least _ (inj n) (IZR h / IZR d)); [auto| |lra].
  set (listed := fun c : zcore => match c with Points L => Some L | _ => None end).
  assert (I : forall c L, listed c = Some L -> inside c 1 L).
  { intros [K|ts|m o] L F; inversion F. subst. apply inside_self. }
  apply (half_space_sound A B n 1 (listed A) (listed B) h d eq_refl); auto.
  - destruct A, B; try discriminate; auto.
  - rewrite <- E. unfold outer_height. destruct A, B; try discriminate; auto.
Qed.

Lemma between_sound : forall m rho A B ln ld hn hd n outer inside proof, (0 < m)%Z ->
  check_between m rho A B ln ld hn hd n outer inside proof = true ->
  (0 < ld)%Z /\ (0 < hd)%Z /\ comparable (map_core inj IZR A) (map_core inj IZR B)
  /\ at_least (zgaps A B) (IZR (ln * m - rho * ld) / IZR ld) /\ planed (zgaps A B) (IZR (hn * m - rho * hd) / IZR hd).
Proof.
  intros m rho A B ln ld hn hd n outer inside proof Hm H. unfold check_between in H. cbv zeta in H.
  set (lo := (ln * m - rho * ld)%Z) in *. set (hi := (hn * m - rho * hd)%Z) in *. set (k := parameter_unit inside) in *.
  apply andb_true_iff in H. destruct H as [H Hproof]. bsplit. rename H into Hld, H3 into Hhd, H1 into Hk, H0 into Hh. clear H2.
  split; auto. split; auto. split.
  { apply (height_within_comparable A B outer hi hd n Hh). destruct A, B; auto. destruct proof; simpl in Hproof; discriminate. }
  split; [|apply (height_within_sound A B outer hi hd n); auto].
  assert (Pl := IZR_pos _ Hld). assert (Pk := IZR_pos _ Hk).
  assert (IA : forall L, core_points A k (inner_a inside) = Some L -> signed_sides.inside A k L).
  { intros L E p Hp. exact (core_points_sound A k _ L Hk E p Hp). }
  assert (IB : forall L, core_points B k (inner_b inside) = Some L -> signed_sides.inside B k L).
  { intros L E p Hp. exact (core_points_sound B k _ L Hk E p Hp). }
  destruct proof as [q|unit WA WB|].
  - destruct (core_points A k _) as [LA|]; [|discriminate]. destruct (core_points B k _) as [LB|]; [|discriminate].
    apply at_least_weaken with (/ IZR k * (IZR (k * Z.max 0 lo) / IZR ld)).
    + rewrite mult_IZR. replace (/ IZR k * (IZR k * IZR (Z.max 0 lo) / IZR ld)) with (IZR (Z.max 0 lo) / IZR ld) by (field; lra).
      apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; auto|]. apply IZR_le. lia.
    + apply (facets_least A B k LA LB (k * Z.max 0 lo) ld (vertices q) (facets q)); auto. apply Z.mul_nonneg_nonneg; lia.
  - destruct (core_points A k _) as [LA|]; [|discriminate]. destruct (core_points B k _) as [LB|]; [|discriminate].
    destruct (mean_is_sound _ A B k LA LB unit WA WB Hk (IA LA eq_refl) (IB LB eq_refl) Hproof) as (z & T & Hu & Hz).
    apply Z.leb_le, IZR_le in T. rewrite !mult_IZR, norm2_inj, IZR_signed_square in T. assert (Pu := IZR_pos _ Hu).
    assert (Nz := norm2_nonneg (inj z)). set (N := norm2 (inj z)) in *. set (w := IZR unit * IZR k) in *.
    assert (Pw : 0 < w) by (apply Rmult_lt_0_compat; auto). assert (Pww : 0 < w * w) by (apply Rmult_lt_0_compat; auto).
    assert (Pll : 0 < IZR ld * IZR ld) by (apply Rmult_lt_0_compat; auto).
    assert (L0 : IZR lo <= 0).
    { apply Rnot_lt_le. intros L. rewrite opp_IZR, signed_sqr_neg in T by lra. assert (0 <= N * (IZR ld * IZR ld)) by (apply
      Rmult_le_pos; lra).
      assert (0 < IZR lo * IZR lo * (w * w)) by (repeat apply Rmult_lt_0_compat; auto). lra. }
    rewrite opp_IZR, signed_sqr_pos in T by lra.
    apply (point_least _ _ _ Hz); [apply quotient_le; lra|].
    rewrite norm2_scal. fold N. apply Rmult_le_reg_r with (w * w * (IZR ld * IZR ld)); [apply Rmult_lt_0_compat; auto|].
    replace (/ w * / w * N * (w * w * (IZR ld * IZR ld))) with (N * (IZR ld * IZR ld)) by (field; lra).
    replace (IZR lo / IZR ld * (IZR lo / IZR ld) * (w * w * (IZR ld * IZR ld))) with (- IZR lo * - IZR lo * (w * w)) by (field; lra). auto.
  - bsplit. rename H into Hone, H0 into HL.
    destruct (sum_of_fractions _ _) as [[l d]|] eqn:E; [|discriminate]. apply Z.leb_le, IZR_le in HL.
    rewrite !mult_IZR, !IZR_signed_square, norm2_inj, <- norm_sqr in HL.
    assert (Hn : inj n <> origin).
    { unfold height_within in Hh. destruct (outer_height A B outer n) as [[h e]|]; [|discriminate]. bsplit.
      apply negb_true_iff in H. apply nonzero_inj; auto. }
    destruct (half_space_sound A B n k _ _ l d Hk Hone IA IB E) as [Pd G].
    apply (half_space_least _ (inj n) (IZR l / IZR d)); auto.
    assert (Pn := norm_pos _ Hn). apply quotient_ge; auto.
    replace (IZR lo / IZR ld * norm (inj n) * IZR d) with (/ IZR ld * (IZR d * norm (inj n) * IZR lo)) by (field; lra).
    replace (IZR l) with (/ IZR ld * (IZR ld * IZR l)) by (field; lra).
    apply Rmult_le_compat_l; [left; apply Rinv_0_lt_compat; auto|]. apply signed_sqr_le.
    rewrite !signed_sqr_scal; nra.
Qed.
