(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* THE THEOREM about the line of a certificate of format 2: what it says is true of the bodies in the file. *)
Require Import Reals Lra Psatz List ZArith Lia Bool.
From Fathom.checker Require Import vector sequence table polytope support certificate verdict body cone signed signed_verdict.
From Fathom.geometry Require Import meaning bodies space hulls difference depth minkowski scaling rounded curved cones.
From Fathom.soundness Require Import statement booleans upper lower optima main printed verdict_sound signed_sides cone_sound
  signed_printed.
Import ListNotations.
Open Scope R_scope.

(* ---- the file's bodies in units of 1/m ---- *)
Lemma units_real : forall m r, (0 < m)%Z -> divides m r = true -> IZR (units m r) = IZR m * value r.
Proof. intros m r Hm H. rewrite <- (units_value m r Hm H). field. apply not_0_IZR. lia. Qed.

Lemma integral_scal : forall m p, (0 < m)%Z -> fits m p = true -> inj (integral m p) = scal (IZR m) (real p).
Proof. intros m p Hm H. unfold fits in H. bsplit. pteq; apply units_real; auto. Qed.

Lemma in_units_real : forall m b, (0 < m)%Z -> all_body (fits m) (divides m) b = true ->
  map_body inj IZR IZR (in_units m b) = scale_body (IZR m) (real_body b).
Proof.
  intros m [c r] Hm H. unfold all_body in H. cbn [core_of radius] in H. apply andb_true_iff in H. destruct H as [H Hr].
  unfold in_units, scale_body, real_body, map_body. cbn [core_of radius]. f_equal; [|apply units_real; auto].
  assert (V := integral_scal m). destruct c as [L|ts|n d]; cbn [map_core]; rewrite ?each_map, ?map_map.
  - f_equal. apply map_ext_in. intros p Hp. apply V; auto. exact (forallb_In _ _ _ H p Hp).
  - f_equal. apply map_ext_in. intros t Ht. rewrite !each_map, !map_map. apply map_ext_in. intros a Ha.
    assert (E := forallb_In _ _ _ (forallb_In _ _ _ H t Ht) a Ha). unfold all_atom in E. bsplit.
    unfold map_atom. cbn [center axis_u axis_v axis_w]. rewrite !V; auto.
  - bsplit. f_equal; [apply V; auto|]. rewrite mult_IZR, units_real by auto. ring.
Qed.

(* ---- from units of 1/m to the file's ---- *)
Section Units.
  Variables (m : Z) (A B : body pt R) (ZA ZB : zbody).
  Hypothesis Hm : (0 < m)%Z.
  Hypothesis EA : map_body inj IZR IZR ZA = scale_body (IZR m) A.
  Hypothesis EB : map_body inj IZR IZR ZB = scale_body (IZR m) B.
  Let G := zgaps (core_of ZA) (core_of ZB).

  Lemma zgaps_core : forall p, G (scal (IZR m) p) <-> core_gaps A B p.
  Proof.
    intros p. rewrite <- (core_gaps_scal (IZR m)) by (apply IZR_pos; auto). rewrite <- EA, <- EB. unfold core_gaps, G, zgaps. tauto.
  Qed.
  Lemma zgaps_back : forall p, G p -> core_gaps A B (scal (/ IZR m) p).
  Proof. intros p H. apply zgaps_core. rewrite scal_back by (apply IZR_pos; auto). auto. Qed.

  Lemma least_back : forall x, at_least G (IZR m * x) -> at_least (core_gaps A B) x.
  Proof.
    intros x H. assert (P0 := IZR_pos _ Hm). apply (at_least_scal _ (core_gaps A B) (/ IZR m)) in H.
    - replace (/ IZR m * (IZR m * x)) with x in H by (field; lra). auto.
    - apply Rinv_0_lt_compat; auto.
    - apply zgaps_back.
  Qed.
  Lemma planed_back : forall x, planed G (IZR m * x) -> planed (core_gaps A B) x.
  Proof. intros x. apply planed_scal; [apply IZR_pos; auto|]. intros p. apply zgaps_core. Qed.
End Units.

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
  assert (Px := proj1 D). assert (Es : s = sqrt x). { unfold s, signed_root. destruct (Rle_dec 0 x); [auto|lra]. }
  assert (Ps : 0 < s) by (rewrite Es; apply sqrt_lt_R0; auto).
  assert (Ess : s * s = x) by (rewrite Es; apply sqrt_sqrt; lra).
  assert (SD : signed_depth (P (map inj LA) (map inj LB)) s) by (apply signed_depth_depth; [auto|rewrite Ess; auto]).
  assert (iff : forall p, P (map inj LA) (map inj LB) p <-> zgaps (Points LA) (Points LB) p) by (intros; symmetry; apply zgaps_points).
  split; auto. split; [apply (at_least_iff _ _ _ iff); apply SD|]. split.
  - destruct (depth_plane _ _ _ SD) as (n & h & Hn & Hb & L). exists n, h. repeat split; auto. intros p Hp. apply Hb, iff. auto.
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
  (0 < ld)%Z /\ (0 < hd)%Z /\ at_least (zgaps A B) (IZR (ln * m - rho * ld) / IZR ld) /\ planed (zgaps A B) (IZR (hn * m - rho * hd) /
    IZR hd).
Proof.
  intros m rho A B ln ld hn hd n outer inside proof Hm H. unfold check_between in H. cbv zeta in H.
  set (lo := (ln * m - rho * ld)%Z) in *. set (hi := (hn * m - rho * hd)%Z) in *. set (k := parameter_unit inside) in *.
  apply andb_true_iff in H. destruct H as [H Hproof]. bsplit. rename H into Hld, H3 into Hhd, H1 into Hk, H0 into Hh. clear H2.
  split; auto. split; auto. split; [|apply (height_within_sound A B outer hi hd n); auto].
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

(* ---- the least ways out of overlapping rounded bodies ---- *)
Lemma way_out_iff : forall (S T : pt -> Prop) v t, (forall p, S p <-> T p) -> way_out S v t -> way_out T v t.
Proof. intros S T v t E [N NI]. split; auto. rewrite <- (interior_iff S); auto. Qed.

Lemma along_scal : forall n v k, along n (k * v) = scal k (along n v).
Proof. intros. unfold along. pteq; unfold Rdiv; ring. Qed.

Lemma ways_of_planes : forall S s r ns, 0 < s -> 0 <= r ->
  (forall n, In n ns -> n <> origin /\ beneath S n (s * norm n)) ->
  NoDup (map (fun n => along n 1) ns) ->
  (forall t, way_out S s t -> exists n, In n ns /\ t = along n s) ->
  ways_number (thick S r) (s + r) (Z.of_nat (length ns)).
Proof.
  intros S s r ns Hs Hr Hn N H. exists (map (fun n => along n (s + r)) ns). split; [rewrite map_length; auto|]. split.
  - assert (E : map (fun n => along n (s + r)) ns = map (scal (s + r)) (map (fun n => along n 1) ns)).
    { rewrite map_map. apply map_ext. intros n. rewrite <- along_scal. f_equal. ring. }
    rewrite E. apply FinFun.Injective_map_NoDup; auto. intros u v E'.
    rewrite <- (scal_inv' (s + r) u), <- (scal_inv' (s + r) v), E' by lra. auto.
  - intros t. rewrite in_map_iff. split.
    + intros W. apply ways_out_overlap in W; auto. destruct (H _ W) as (n & In0 & E). exists n. split; auto.
      replace (s + r) with ((s + r) / s * s) by (field; lra). rewrite along_scal, <- E, scal_scal.
      replace ((s + r) / s * (s / (s + r))) with 1 by (field; lra). apply scal_1.
    + intros (n & <- & In0). destruct (Hn n In0) as [Nz Hb]. split.
      * rewrite <- norm_sqr, norm_along by (auto; lra). auto.
      * apply (beneath_along _ n (s * norm n + r * norm n)); auto; [apply beneath_thick; auto|lra].
Qed.

Lemma way_out_scal : forall (S T : pt -> Prop) k v t, 0 < k -> (forall p, S p -> T (scal k p)) -> (forall p, T (scal k p) -> S p) ->
  way_out S v t -> way_out T (k * v) (scal k t).
Proof.
  intros S T k v t Hk ST TS [N NI]. split; [rewrite norm2_scal, N; ring|]. intros I. apply NI.
  assert (P0 : 0 < / k) by (apply Rinv_0_lt_compat; auto).
  rewrite <- (scal_inv' k t) by lra. apply (interior_scal_set T); auto. intros p Hp. apply TS. rewrite scal_back; auto.
Qed.

(* ---- the statement ---- *)
Lemma status_of_root_sound : forall S s rho, (0 < den s)%Z -> (0 < den rho)%Z ->
  signed_depth S (signed_root (value s) + value rho) -> status_holds S (status_of_root s rho).
Proof.
  intros S [sn sd] [rn rd] Hs Hr D. unfold value in D. cbn [num den] in *. assert (Ps := IZR_pos _ Hs). assert (Pr := IZR_pos _ Hr).
  unfold status_of_root. cbn [num den]. set (v := signed_root (IZR sn / IZR sd) + IZR rn / IZR rd) in *.
  (* the two signed squares over one denominator *)
  assert (X : IZR (signed_square rn * sd) = signed_sqr (IZR rn / IZR rd) * (IZR rd * IZR rd * IZR sd)).
  { rewrite mult_IZR, IZR_signed_square. replace (IZR rn) with (IZR rd * (IZR rn / IZR rd)) at 1 by (field; lra).
    rewrite signed_sqr_scal by lra. ring. }
  assert (Y : IZR (- sn * (rd * rd)) = signed_sqr (- signed_root (IZR sn / IZR sd)) * (IZR rd * IZR rd * IZR sd)).
  { rewrite <- signed_root_opp, signed_sqr_root, !mult_IZR, opp_IZR. field. lra. }
  assert (P0 : 0 < IZR rd * IZR rd * IZR sd) by (repeat apply Rmult_lt_0_compat; auto).
  destruct (_ ?= _)%Z eqn:C; cbn [status_holds].
  - apply Z.compare_eq in C. apply (f_equal IZR) in C. rewrite X, Y in C. apply Rmult_eq_reg_r in C; [|lra].
    apply signed_sqr_inj in C. apply signed_depth_touch. replace 0 with v; auto. unfold v. lra.
  - rewrite Z.compare_lt_iff in C. apply IZR_lt in C. rewrite X, Y in C. apply Rmult_lt_reg_r in C; auto.
    apply (most_apart S v); [apply D|]. apply Rnot_le_lt. intros L.
    assert (signed_sqr (- signed_root (IZR sn / IZR sd)) <= signed_sqr (IZR rn / IZR rd)) by (apply signed_sqr_le; unfold v in L; lra). lra.
  - rewrite Z.compare_gt_iff in C. apply IZR_lt in C. rewrite X, Y in C. apply Rmult_lt_reg_r in C; auto.
    apply (least_overlap S v); [apply D|]. apply Rnot_le_lt. intros L.
    assert (signed_sqr (IZR rn / IZR rd) <= signed_sqr (- signed_root (IZR sn / IZR sd))) by (apply signed_sqr_le; unfold v in L; lra). lra.
Qed.

Lemma status_between_sound : forall S lo hi, (0 < den lo)%Z -> (0 < den hi)%Z -> signed_depth_in S (value lo) (value hi) ->
  status_holds S (status_between lo hi).
Proof.
  intros S [ln ld] [hn hd] Hl Hh [L M]. unfold value in *. cbn [num den] in *. assert (Pl := IZR_pos _ Hl). assert (Ph := IZR_pos _ Hh).
  unfold status_between. cbn [num]. destruct (0 <? ln)%Z eqn:E1.
  - apply Z.ltb_lt, IZR_pos in E1. apply (least_overlap S _ L). apply Rdiv_lt_0_compat; auto.
  - destruct (hn <? 0)%Z eqn:E2.
    + apply Z.ltb_lt, IZR_lt in E2. apply (most_apart S _ M). apply Ropp_lt_cancel. rewrite Ropp_0.
      replace (- (IZR hn / IZR hd)) with (- IZR hn / IZR hd) by (field; lra). apply Rdiv_lt_0_compat; lra.
    + destruct ((ln =? 0) && (hn =? 0))%Z eqn:E3; simpl; auto. bsplit. subst. apply signed_depth_touch.
      replace (0 / IZR ld) with 0 in L by (field; lra). replace (0 / IZR hd) with 0 in M by (field; lra). split; auto.
Qed.

Lemma root_in_units : forall m qn qd, (0 < m)%Z -> (0 < qd)%Z ->
  signed_root (IZR (qn * (m * m)) / IZR qd) = IZR m * signed_root (IZR qn / IZR qd).
Proof.
  intros m qn qd Hm Hq. assert (Pm := IZR_pos _ Hm). assert (Pq := IZR_pos _ Hq). rewrite <- signed_root_scal by lra.
  f_equal. rewrite !mult_IZR. field. lra.
Qed.

(* what is proved of the cores, and of the bodies *)
Section Verdict.
  Variables (m : Z) (rho : ratio) (A B : body pt R) (ZA ZB : zbody).
  Hypothesis Hm : (0 < m)%Z.
  Hypothesis EA : map_body inj IZR IZR ZA = scale_body (IZR m) A.
  Hypothesis EB : map_body inj IZR IZR ZB = scale_body (IZR m) B.
  Hypothesis Hrho : (0 < den rho)%Z.
  Hypothesis Erho : ((radius ZA + radius ZB) * den rho)%Z = (num rho * m)%Z.
  Hypothesis RA : (0 <= radius ZA)%Z.
  Hypothesis RB : (0 <= radius ZB)%Z.

  Lemma radius_real : IZR (radius ZA) = IZR m * radius A /\ IZR (radius ZB) = IZR m * radius B.
  Proof. split; [apply (f_equal radius) in EA; exact EA|apply (f_equal radius) in EB; exact EB]. Qed.
  Lemma radii : 0 <= radius A /\ 0 <= radius B /\ value rho = radius A + radius B.
  Proof.
    destruct radius_real as [E F]. assert (Pm := IZR_pos _ Hm). assert (Pr := IZR_pos _ Hrho).
    apply IZR_le in RA, RB. rewrite E in RA. rewrite F in RB. split; [nra|]. split; [nra|].
    apply (f_equal IZR) in Erho. rewrite !mult_IZR, plus_IZR, E, F in Erho. unfold value.
    apply Rmult_eq_reg_r with (IZR m * IZR (den rho)); [|apply Rgt_not_eq, Rmult_lt_0_compat; auto].
    replace (IZR (num rho) / IZR (den rho) * (IZR m * IZR (den rho))) with (IZR (num rho) * IZR m) by (field; lra). lra.
  Qed.

  Lemma both_sides : forall x y, at_least (zgaps (core_of ZA) (core_of ZB)) (IZR m * x) -> planed (zgaps (core_of ZA) (core_of ZB))
    (IZR m * y) ->
    signed_depth_in (core_gaps A B) x y /\ signed_depth_in (gaps A B) (x + value rho) (y + value rho).
  Proof.
    intros x y L M. destruct radii as (PA & PB & E). apply (least_back m A B ZA ZB Hm EA EB) in L. apply (planed_back m A B ZA ZB Hm EA
      EB) in M.
    split; split; auto; [apply planed_most; auto|rewrite E; apply R_least; auto|rewrite E; apply R_most; auto].
  Qed.

  Lemma root_says : forall square x, (0 < den square)%Z -> x = signed_root (value square) ->
    at_least (zgaps (core_of ZA) (core_of ZB)) (IZR m * x) -> planed (zgaps (core_of ZA) (core_of ZB)) (IZR m * x) ->
    says_signed A B (Root_is (status_of_root square rho) square rho None None).
  Proof.
    intros square x Hd -> L M. destruct radii as (PA & PB & E). destruct (both_sides _ _ L M) as [C G].
    split; auto. split; auto. split; auto. split; auto. apply status_of_root_sound; auto.
  Qed.

  Theorem check_says : forall c, signed_check m ZA ZB c = true -> says_signed A B (signed_stated rho c).
  Proof.
    assert (Pm := IZR_pos _ Hm). destruct radii as (PA & PB & Er).
    assert (zg := zgaps_core m A B ZA ZB Hm EA EB).
    intros c H. unfold signed_check in H. apply andb_true_iff in H. destruct H as [_ H].
    destruct c as [qn qd complete dirs q|qn qd n unit WA WB all|qn qd n|ln ld hn hd n outer inside proof].
    - destruct (core_of ZA) as [LA| |] eqn:CA; try discriminate. destruct (core_of ZB) as [LB| |] eqn:CB; try discriminate.
      assert (Hqd : (0 < qd)%Z) by (unfold check_depth in H; bsplit; auto).
      destruct (deep_sound LA LB _ _ _ _ _ H) as (Ps & L & M & W). rewrite root_in_units in * by auto.
      assert (S := root_says (Ratio qn qd) _ Hqd eq_refl). unfold value at 2 in S. cbn [num den] in S. rewrite CA, CB in S. specialize
        (S L M).
      destruct S as (S1 & S2 & S3 & S4 & _). cbn [signed_stated says_signed].
      split; auto. split; auto. split; auto. split; auto. split; auto. destruct complete; auto.
      destruct (W eq_refl) as (W1 & W2 & W3). set (ns := map (fun n => inj (fst n)) dirs) in *.
      replace (count dirs) with (Z.of_nat (length ns)) by (unfold ns; rewrite map_length, count_length; auto).
      set (s := signed_root (value (Ratio qn qd))) in *. change (signed_root (IZR qn / IZR qd)) with s in *.
      assert (Ps' : 0 < s) by (apply Rmult_lt_reg_l with (IZR m); lra).
      assert (K : ways_number (thick (core_gaps A B) (value rho)) (s + value rho) (Z.of_nat (length ns))).
      { apply ways_of_planes; auto; [lra| |].
        - intros n In0. destruct (W1 n In0) as [Nz Hb]. split; auto. intros p Hp. apply zg, Hb in Hp. rewrite dot_scal_r in Hp.
          apply Rmult_le_reg_l with (IZR m); lra.
        - intros t Wt. apply (way_out_scal _ (zgaps (Points LA) (Points LB)) (IZR m)) in Wt; auto; try (intros p; apply zg).
          destruct (W3 _ Wt) as (n & In0 & E). exists n. split; auto. rewrite along_scal in E.
          rewrite <- (scal_inv' (IZR m) t), E, scal_inv' by lra. auto. }
      destruct K as (ts & K1 & K2 & K3). exists ts. split; auto. split; auto. intros t. rewrite <- K3.
      assert (iff : forall p, gaps A B p <-> thick (core_gaps A B) (value rho) p) by (intros; rewrite Er; apply gaps_thick; auto).
      split; apply way_out_iff; intros p; rewrite iff; tauto.
    - destruct (core_of ZA) as [LA| |] eqn:CA; try discriminate. destruct (core_of ZB) as [LB| |] eqn:CB; try discriminate.
      assert (Hqd : (0 < qd)%Z) by (unfold check_beside in H; bsplit; auto).
      destruct (beside_sound _ _ _ _ _ _ _ _ _ H) as (L & M & K).
      replace (- (qn * (m * m)))%Z with (- qn * (m * m))%Z in * by ring. rewrite root_in_units in * by auto.
      assert (S := root_says (Ratio (- qn) qd) _ Hqd eq_refl). unfold value at 2 in S. cbn [num den] in S. rewrite CA, CB in S.
        specialize (S L M).
      destruct S as (S1 & S2 & S3 & S4 & _). cbn [signed_stated says_signed].
      split; auto. split; auto. split; auto. split; auto. split; auto. destruct all as [k|]; auto.
      destruct (K k eq_refl) as (Z0 & C1 & C2 & C3 & C4 & C5).
      assert (piff : forall u, polar (zgaps (Points LA) (Points LB)) u <-> polar (core_gaps A B) u).
      { intros u. split; intros H' p Hp.
        - apply zg, H' in Hp. rewrite dot_scal_r in Hp. apply Rmult_le_reg_l with (IZR m); lra.
        - rewrite <- (scal_back (IZR m) p) by auto. rewrite dot_scal_r. rewrite <- (scal_back (IZR m) p) in Hp by auto. apply zg, H' in
          Hp. nra. }
      split.
      + exists (map inj (lineality k)), (map (fun r => inj (fst r)) (rays k)). rewrite !map_length, !count_length.
        split; auto. split; auto. split; [intros u; rewrite <- piff; auto|]. split; auto. split; auto. split; auto.
        intros r Ir Kr. apply (C4 r Ir), piff; auto.
      + intros Pr t. assert (Z1 : signed_root (value (Ratio (- qn) qd)) = 0).
        { apply Rmult_eq_reg_l with (IZR m); [|lra]. rewrite Rmult_0_r. exact Z0. }
        rewrite Z1 in S2. apply signed_depth_touch in S2.
        rewrite <- ways_out_touch; auto.
        * assert (iff : forall p, gaps A B p <-> thick (core_gaps A B) (value rho) p) by (intros; rewrite Er; apply gaps_thick; auto).
          split; apply way_out_iff; intros p; rewrite iff; tauto.
        * apply difference_of_convex; apply in_core_convex.
        * apply S2.
    - assert (Hqd : (0 < qd)%Z) by (unfold check_on_plane in H; bsplit; auto).
      destruct (on_plane_sound _ _ _ _ _ H) as [L M]. rewrite root_in_units in * by auto.
      apply (root_says (Ratio qn qd) _ Hqd eq_refl); auto.
    - destruct (between_sound _ _ _ _ _ _ _ _ _ _ _ _ Hm H) as (Hld & Hhd & L & M).
      assert (Pl := IZR_pos _ Hld). assert (Ph := IZR_pos _ Hhd). destruct radius_real as [EfA EfB].
      assert (shift : forall n d, 0 < IZR d -> IZR (n * m - (radius ZA + radius ZB) * d) / IZR d = IZR m * (IZR n / IZR d - value rho)).
      { intros n' d Pd. rewrite minus_IZR, !mult_IZR, plus_IZR, EfA, EfB, Er. field. lra. }
      rewrite shift in L, M by auto. destruct (both_sides _ _ L M) as [_ G].
      replace (IZR ln / IZR ld - value rho + value rho) with (IZR ln / IZR ld) in G by ring.
      replace (IZR hn / IZR hd - value rho + value rho) with (IZR hn / IZR hd) in G by ring.
      split; [exact G|]. apply status_between_sound; auto.
  Qed.
End Verdict.

Theorem signed_verdict_sound : forall width m rho A B c s, signed_verdict width m rho A B c = Some s ->
  says_signed (real_body A) (real_body B) s.
Proof.
  intros width m rho A B c s H. unfold signed_verdict in H. cbv zeta in H.
  destruct (all_body _ _ A && all_body _ _ B && _ && _ && _ && signed_check _ _ _ _) eqn:E; [|discriminate].
  inversion H; subst. clear H. apply andb_true_iff in E. destruct E as [E C]. apply andb_true_iff in E. destruct E as [E _]. bsplit.
  rename H into FA, H2 into FB, H1 into Hr, H0 into Er.
  assert (K : (0 < m)%Z /\ (0 <= radius (in_units m A))%Z /\ (0 <= radius (in_units m B))%Z).
  { unfold signed_check in C. apply andb_true_iff in C. destruct C as [C _]. bsplit. auto. }
  destruct K as (Hm & HA & HB). apply (check_says m rho _ _ (in_units m A) (in_units m B)); auto; apply in_units_real; auto.
Qed.
