(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Format 2: the two sides of a claim, in units of 1/scale.  The height is beyond P; what the proof names is inside. *)
Require Import Reals Lra Psatz List ZArith Lia Bool.
From Fathom.checker Require Import vector sequence table polytope support certificate body signed.
From Fathom.geometry Require Import meaning bodies space norm hulls flats difference minkowski scaling signed_depth curved units.
From Fathom.soundness Require Import statement booleans upper lower.
Import ListNotations.
Open Scope R_scope.

Notation in_zcore c := (in_core (map_core inj IZR c)).
(* b - a for points of two cores *)
Definition zgaps (A B : zcore) : pt -> Prop := difference_of (in_zcore B) (in_zcore A).

Lemma IZR_signed_square : forall x, IZR (signed_square x) = signed_sqr (IZR x).
Proof. intros. unfold signed_square, signed_sqr. rewrite mult_IZR, abs_IZR. auto. Qed.
Lemma inj_neg : forall v, inj (zneg v) = scal (-1) (inj v).
Proof. intros. pteq; rewrite opp_IZR; ring. Qed.
Lemma IZR_pos : forall z, (0 < z)%Z -> 0 < IZR z.
Proof. intros z. apply IZR_lt. Qed.
Lemma quotient_le : forall a b d, 0 < d -> a <= b * d -> a / d <= b.
Proof. intros a b d Hd H. apply Rmult_le_reg_r with d; auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. Qed.
Lemma quotient_ge : forall a b d, 0 < d -> a * d <= b -> a <= b / d.
Proof. intros a b d Hd H. apply Rmult_le_reg_r with d; auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. Qed.
Lemma nonzero_inj : forall n, is_zero n = false -> inj n <> origin.
Proof. intros n H. rewrite inj_zero, <- is_zero_spec, H. discriminate. Qed.

(* ---- the outer side ---- *)
Lemma tall_sound : forall s unit h a, (0 < unit)%Z -> tall s unit h a = true ->
  atom_beneath (inj s) (IZR h / IZR unit) (map_atom inj a).
Proof.
  intros s unit h a Hu H. unfold tall in H. bsplit. apply IZR_pos in Hu. apply IZR_le in H, H0.
  rewrite !mult_IZR, !plus_IZR, !mult_IZR, !dot_inj, minus_IZR, mult_IZR, dot_inj in *.
  unfold atom_beneath, map_atom. cbn [center axis_u axis_v axis_w].
  set (c := dot (inj s) (inj (center a))) in *. set (u := dot (inj s) (inj (axis_u a))) in *.
  set (v := dot (inj s) (inj (axis_v a))) in *. set (w := dot (inj s) (inj (axis_w a))) in *.
  assert (E : IZR h - IZR unit * c = IZR unit * (IZR h / IZR unit - c)) by (field; lra). rewrite E in *.
  set (g := IZR h / IZR unit - c) in *. split.
  - apply Rmult_le_reg_l with (IZR unit); lra.
  - apply Rmult_le_reg_l with (IZR unit * IZR unit); nra.
Qed.

Lemma all_tall_sound : forall s unit ts hs, (0 < unit)%Z -> all_tall s unit ts hs = true ->
  Forall2 (fun t h => beneath (in_term t) (inj s) h) (map (map (map_atom inj)) ts) (map (fun h => IZR h / IZR unit) hs).
Proof.
  intros s unit ts. induction ts as [|t ts IH]; intros [|h hs] Hu H; try discriminate; simpl; constructor.
  - simpl in H. apply in_term_beneath. intros a Ia. apply in_map_iff in Ia. destruct Ia as (b & <- & Ib).
    apply tall_sound; auto. destruct t as [|a0 t]; [contradiction|].
    destruct (forallb (tall s unit h) (a0 :: t)) eqn:E; [|discriminate]. exact (forallb_In _ _ _ E b Ib).
  - simpl in H. apply IH; auto. destruct (match t with [] => false | _ => forallb (tall s unit h) t end); [auto|discriminate].
Qed.

Lemma sum_heights : forall unit hs, 0 < IZR unit ->
  fold_right Rplus 0 (map (fun h => IZR h / IZR unit) hs) = IZR (fold_left Z.add hs 0%Z) / IZR unit.
Proof.
  intros unit hs Hu.
  assert (G : forall l a, IZR (fold_left Z.add l a) / IZR unit = IZR a / IZR unit + fold_right Rplus 0 (map (fun h => IZR h / IZR unit) l)).
  { induction l as [|h l IH]; simpl; intros a; [lra|]. rewrite IH, plus_IZR. field. lra. }
  rewrite G. simpl. field. lra.
Qed.

Lemma greatest_beneath : forall s L h, greatest s L = Some h -> beneath (conv (map inj L)) (inj s) (IZR h).
Proof.
  intros s L h H. apply greatest_spec in H. destruct H as [_ H]. intros p Hp. revert p Hp. apply hull_halfspace.
  intros p Ip. apply in_map_iff in Ip. destruct Ip as (v & <- & Iv). rewrite <- dot_inj. apply IZR_le. auto.
Qed.

(* a half-space by a multiple of its normal *)
Lemma same_sense_multiple : forall n s, same_sense n s = true -> inj n <> origin /\ 0 < dot (inj n) (inj s)
  /\ inj s = scal (dot (inj n) (inj s) / norm2 (inj n)) (inj n).
Proof.
  intros n s H. unfold same_sense in H. bsplit. apply is_zero_spec in H. apply IZR_pos in H0. rewrite dot_inj in H0.
  assert (Hn : inj n <> origin).
  { intros E. rewrite E in H0. unfold dot, origin in H0. simpl in H0. lra. }
  repeat split; auto. rewrite (dot_comm (inj n)). apply parallel; auto. rewrite <- inj_cross, H. reflexivity.
Qed.

Lemma half_space_multiple : forall n s d x, same_sense n s = true ->
  (dot (inj n) x <= d <-> dot (inj s) x <= dot (inj n) (inj s) * d / norm2 (inj n)).
Proof.
  intros n s d x H. destruct (same_sense_multiple n s H) as (Hn & P0 & E). assert (N := norm2_pos _ Hn).
  set (k := dot (inj n) (inj s)) in *. rewrite E, dot_scal_l.
  replace (k * d / norm2 (inj n)) with (k / norm2 (inj n) * d) by (field; lra).
  assert (Pk : 0 < k / norm2 (inj n)) by (apply Rdiv_lt_0_compat; auto).
  split; intros L; [apply Rmult_le_compat_l; lra|apply Rmult_le_reg_l with (k / norm2 (inj n)); auto].
Qed.

Lemma reach_sound : forall s c unit hs h d, reach s c unit hs = Some (h, d) ->
  0 < IZR d /\ beneath (in_zcore c) (inj s) (IZR h / IZR d).
Proof.
  intros s [L|[|t ts]|n o] unit hs h d H; simpl in H.
  - destruct (greatest s L) as [g|] eqn:E; [|discriminate]. inversion H; subst. split; [lra|].
    simpl. rewrite each_map. replace (IZR h / 1) with (IZR h) by field. apply greatest_beneath; auto.
  - discriminate.
  - destruct (0 <? unit)%Z eqn:U; [|discriminate]. apply Z.ltb_lt in U.
    destruct (all_tall s unit (t :: ts) hs) eqn:E; [|simpl in E; simpl in H; rewrite E in H; discriminate].
    assert (H' : Some (fold_left Z.add hs 0%Z, unit) = Some (h, d)) by (simpl in E; simpl in H; rewrite E in H; exact H).
    inversion H'; subst. assert (P0 := IZR_pos _ U). split; auto.
    rewrite <- sum_heights by auto. cbn [map_core in_core]. rewrite each_map, (map_ext _ (map (map_atom inj))) by (intros; apply each_map).
    apply in_terms_beneath. apply all_tall_sound; auto.
  - destruct (same_sense n s) eqn:E; [|discriminate]. inversion H; subst.
    destruct (same_sense_multiple n s E) as (Hn & P0 & _). rewrite norm2_inj, mult_IZR, dot_inj. split; [apply norm2_pos; auto|].
    intros x Hx. apply half_space_multiple; auto.
Qed.

Lemma outer_height_sound : forall A B H n h d, outer_height A B H n = Some (h, d) ->
  0 < IZR d /\ beneath (zgaps A B) (inj n) (IZR h / IZR d).
Proof.
  intros A B [unit HA HB] n h d H. unfold outer_height, sum_of_fractions in H. simpl in H.
  destruct (reach n B unit HB) as [[x e]|] eqn:EB; [|discriminate].
  destruct (reach (zneg n) A unit HA) as [[y f]|] eqn:EA; [|discriminate]. inversion H; subst. clear H.
  apply reach_sound in EB. apply reach_sound in EA. destruct EB as [Pe Ke]. destruct EA as [Pf Kf].
  rewrite mult_IZR, plus_IZR, !mult_IZR. split; [apply Rmult_lt_0_compat; auto|].
  replace ((IZR x * IZR f + IZR y * IZR e) / (IZR e * IZR f)) with (IZR x / IZR e + IZR y / IZR f) by (field; lra).
  apply difference_of_beneath; auto. rewrite <- inj_neg. auto.
Qed.

(* H/|n| as a signed root *)
Lemma root_height : forall h d s n, 0 < d -> 0 < norm n -> signed_sqr h = s * (d * d) * norm2 n -> h / d = signed_root s * norm n.
Proof.
  intros h d s n Hd Hn E. apply signed_sqr_inj. assert (Di : 0 < / d) by (apply Rinv_0_lt_compat; auto).
  replace (h / d) with (/ d * h) by (unfold Rdiv; ring). rewrite (Rmult_comm (signed_root s)).
  rewrite !signed_sqr_scal, signed_sqr_root, E, <- norm_sqr by lra. field. lra.
Qed.

Lemma height_root_sound : forall A B qn qd n, (0 < qd)%Z -> height_root A B qn qd n = true ->
  exists h d, outer_height A B (Heights 1 [] []) n = Some (h, d) /\ 0 < IZR d /\ inj n <> origin
    /\ beneath (zgaps A B) (inj n) (IZR h / IZR d) /\ IZR h / IZR d = signed_root (IZR qn / IZR qd) * norm (inj n).
Proof.
  intros A B qn qd n Hqd H. unfold height_root in H. destruct (outer_height A B _ n) as [[h d]|] eqn:E; [|discriminate].
  bsplit. apply negb_true_iff, nonzero_inj in H. destruct (outer_height_sound _ _ _ _ _ _ E) as [Pd Hb].
  exists h, d. repeat split; auto. apply root_height; auto; [apply norm_pos; auto|].
  apply IZR_pos in Hqd. apply Rmult_eq_reg_r with (IZR qd); [|lra].
  rewrite <- IZR_signed_square, <- mult_IZR, H0, !mult_IZR, norm2_inj. field. lra.
Qed.

Lemma height_within_sound : forall A B H x y n, (0 < y)%Z -> height_within A B H x y n = true -> planed (zgaps A B) (IZR x / IZR y).
Proof.
  intros A B H x y n Hy K. unfold height_within in K. destruct (outer_height A B H n) as [[h d]|] eqn:E; [|discriminate].
  bsplit. apply negb_true_iff, nonzero_inj in H0. destruct (outer_height_sound _ _ _ _ _ _ E) as [Pd Hb].
  exists (inj n), (IZR h / IZR d). repeat split; auto. apply IZR_pos in Hy. assert (Pn := norm_pos _ H0).
  apply IZR_le in H1. rewrite !mult_IZR, !IZR_signed_square, norm2_inj, <- norm_sqr in H1.
  apply quotient_le; auto. replace (IZR x / IZR y * norm (inj n) * IZR d) with (/ IZR y * (IZR d * norm (inj n) * IZR x)) by (field; lra).
  replace (IZR h) with (/ IZR y * (IZR y * IZR h)) by (field; lra).
  apply Rmult_le_compat_l; [left; apply Rinv_0_lt_compat; auto|]. apply signed_sqr_le.
  rewrite !signed_sqr_scal; nra.
Qed.

(* a height is of bodies that have a depth *)
Lemma reach_kind : forall s c unit hs h d, reach s c unit hs = Some (h, d) ->
  bounded_core (map_core inj IZR c) \/ half_space_core (map_core inj IZR c) /\ exists n o, c = Half_space n o.
Proof.
  intros s [L|ts|n o] unit hs h d H; simpl in H; simpl.
  - left. rewrite each_map. destruct L; discriminate.
  - left. rewrite each_map. destruct ts as [|t0 ts0]; [discriminate|].
    destruct (0 <? unit)%Z; [|discriminate]. assert (K : all_tall s unit (t0 :: ts0) hs = true).
    { destruct (all_tall s unit (t0 :: ts0) hs) eqn:E; auto. discriminate. }
    clear H. generalize dependent (t0 :: ts0). clear t0 ts0. intros ts K. revert hs K.
    induction ts as [|t ts IH]; intros hs K; constructor; destruct hs as [|k hs]; try discriminate; simpl in K.
    + rewrite each_map. destruct t; discriminate.
    + apply (IH hs). destruct (match t with [] => false | _ => forallb (tall s unit k) t end); [auto|discriminate].
  - right. destruct (same_sense n s) eqn:E; [|discriminate]. split; [|eauto]. exists (inj n), (IZR o). split; auto.
    apply (same_sense_multiple n s E).
Qed.

Lemma height_within_comparable : forall A B H x y n, height_within A B H x y n = true ->
  match A, B with Half_space _ _, Half_space _ _ => False | _, _ => True end -> comparable (map_core inj IZR A) (map_core inj IZR B).
Proof.
  intros A B [unit HA HB] x y n K One. unfold height_within, outer_height, sum_of_fractions in K. simpl in K.
  destruct (reach n B unit HB) as [[g e]|] eqn:EB; [|discriminate]. destruct (reach (zneg n) A unit HA) as [[k f]|] eqn:EA; [|discriminate].
  apply reach_kind in EB. apply reach_kind in EA. unfold comparable.
  destruct EA as [PA|[PA (na & oa & ->)]], EB as [PB|[PB (nb & ob & ->)]]; auto.
Qed.

(* ---- the inner side ---- *)
Lemma place_sound : forall unit ts l p q (S : pt -> Prop), (0 < unit)%Z -> place unit (map numbered ts) l p = Some q ->
  S (scal (/ IZR unit) (inj p)) -> sum_of S (in_terms (map (map (map_atom inj)) ts)) (scal (/ IZR unit) (inj q)).
Proof.
  intros unit ts. induction ts as [|t ts IH]; intros [|[i y] l] p q S Hu H HS; try discriminate.
  - simpl in H. inversion H; subst. exists (scal (/ IZR unit) (inj q)), origin. repeat split; auto. pteq; ring.
  - simpl in H. destruct (member (numbered t) i) as [a|] eqn:E; [|discriminate].
    destruct (zdot y y <=? unit * unit)%Z eqn:Y; [|discriminate]. apply Z.leb_le in Y. apply IZR_le in Y.
    apply member_in in E. assert (P0 := IZR_pos _ Hu). assert (Pi : 0 < / IZR unit) by (apply Rinv_0_lt_compat; auto).
    rewrite norm2_inj, mult_IZR in Y. unfold norm2, dot in Y. simpl in Y.
    assert (A0 : in_term (map (map_atom inj) t) (scal (/ IZR unit) (inj (zadd (zscal unit (center a))
      (zadd (zscal (zx y) (axis_u a)) (zadd (zscal (zy y) (axis_v a)) (zscal (zz y) (axis_w a)))))))).
    { apply (in_term_atom _ (map_atom inj a)); [apply in_map; auto|].
      exists (/ IZR unit * IZR (zx y)), (/ IZR unit * IZR (zy y)), (/ IZR unit * IZR (zz y)). split.
      - apply Rmult_le_reg_l with (IZR unit * IZR unit); [nra|].
        replace (IZR unit * IZR unit * (/ IZR unit * IZR (zx y) * (/ IZR unit * IZR (zx y)) + / IZR unit * IZR (zy y) * (/ IZR unit *
          IZR (zy y)) +
          / IZR unit * IZR (zz y) * (/ IZR unit * IZR (zz y)))) with (IZR (zx y) * IZR (zx y) + IZR (zy y) * IZR (zy y) + IZR (zz y) *
            IZR (zz y))
          by (field; lra). lra.
      - rewrite !inj_add, !inj_scal. pteq; field; lra. }
    apply (IH l _ _ (sum_of S (in_term (map (map_atom inj) t))) Hu) in H.
    + destruct H as (s & r & (u & v & Hu' & Hv & ->) & Hr & ->).
      exists u, (add v r). split; auto. split; [exists v, r; auto|]. pteq; ring.
    + exists (scal (/ IZR unit) (inj p)). eexists. split; [exact HS|]. split; [exact A0|]. rewrite inj_add. pteq; ring.
Qed.

Lemma places_sound : forall unit ts ls L, (0 < unit)%Z -> places unit (map numbered ts) ls = Some L ->
  forall p, In p L -> in_terms (map (map (map_atom inj)) ts) (scal (/ IZR unit) (inj p)).
Proof.
  intros unit ts ls L Hu H p Hp. destruct (every_in _ _ _ _ _ _ H Hp) as (l & _ & E).
  apply (place_sound unit ts l zzero p (fun p => p = origin) Hu) in E; [|pteq; ring].
  destruct E as (s & t & -> & Ht & E). rewrite E. replace (add origin t) with t by (pteq; ring). auto.
Qed.

Lemma core_points_sound : forall c unit ls L, (0 < unit)%Z -> core_points c unit ls = Some L ->
  forall p, In p L -> in_zcore c (scal (/ IZR unit) (inj p)).
Proof.
  intros [K|ts|n d] unit ls L Hu H p Hp; simpl in H; [|cbn [map_core in_core]|discriminate].
  - inversion H; subst. rewrite each_map in Hp. apply in_map_iff in Hp. destruct Hp as (v & <- & Iv).
    simpl. rewrite each_map, inj_scal, scal_scal, Rinv_l by (apply not_0_IZR; lia). rewrite scal_1. apply hull_in, in_map. auto.
  - rewrite each_map in H. rewrite each_map, (map_ext _ (map (map_atom inj))) by (intros; apply each_map).
    apply (places_sound unit ts ls L); auto.
Qed.

(* lists of points in the cores, in units of 1/unit *)
Definition inside (c : zcore) (unit : Z) (L : list zvec) : Prop := forall p, In p L -> in_zcore c (scal (/ IZR unit) (inj p)).

Lemma inside_conv : forall c unit L p, (0 < unit)%Z -> inside c unit L -> conv (map inj L) p -> in_zcore c (scal (/ IZR unit) p).
Proof.
  intros c unit L p Hu H Hp. apply (Hp (fun p => in_zcore c (scal (/ IZR unit) p))).
  - intros u v l Hl Hu' Hv. replace (scal (/ IZR unit) (add (scal l u) (scal (1 - l) v)))
      with (add (scal l (scal (/ IZR unit) u)) (scal (1 - l) (scal (/ IZR unit) v))) by (pteq; ring). apply in_core_convex; auto.
  - intros s Hs. apply in_map_iff in Hs. destruct Hs as (v & <- & Iv). auto.
Qed.

Lemma inside_P : forall A B unit LA LB p, (0 < unit)%Z -> inside A unit LA -> inside B unit LB -> P (map inj LA) (map inj LB) p ->
  zgaps A B (scal (/ IZR unit) p).
Proof.
  intros A B unit LA LB p Hu HA HB Hp. apply P_minkowski in Hp. destruct Hp as (a & b & Ha & Hb & ->).
  exists (scal (/ IZR unit) b), (scal (/ IZR unit) a). split; [apply (inside_conv B unit LB); auto|].
  split; [apply (inside_conv A unit LA); auto|]. pteq; ring.
Qed.

Lemma facets_least : forall A B unit LA LB least ld V F, (0 < unit)%Z -> (0 <= least)%Z -> (0 < ld)%Z ->
  inside A unit LA -> inside B unit LB -> inner_ok (least * least) (ld * ld) (make_facets LA LB V F) = true ->
  at_least (zgaps A B) (/ IZR unit * (IZR least / IZR ld)).
Proof.
  intros A B unit LA LB least ld V F Hu Hl Hd HA HB H. assert (Pu := IZR_pos _ Hu). assert (Pd := IZR_pos _ Hd).
  assert (Pi : 0 < / IZR unit) by (apply Rinv_0_lt_compat; auto).
  assert (Hdd : (0 < ld * ld)%Z) by lia. apply IZR_le in Hl.
  apply (at_least_scal (P (map inj LA) (map inj LB))); auto.
  { intros p. apply (inside_P A B unit LA LB); auto. }
  split.
  - intros _ t Ht. apply (lower_sound LA LB (least * least) (ld * ld) Hdd V F H). rewrite !mult_IZR.
    replace (IZR least * IZR least / (IZR ld * IZR ld)) with (IZR least / IZR ld * (IZR least / IZR ld)) by (field; lra). auto.
  - intros _. exists origin. rewrite norm2_origin. split; [|apply Rle_0_sqr].
    apply interior_in, (origin_interior LA LB (least * least) (ld * ld) Hdd V F H).
Qed.

(* the difference of the weighted means *)
Lemma mean_is_sound : forall test A B k LA LB unit WA WB, (0 < k)%Z -> inside A k LA -> inside B k LB ->
  mean_is test LA LB unit WA WB = true ->
  exists z, test z = true /\ (0 < unit)%Z /\ zgaps A B (scal (/ (IZR unit * IZR k)) (inj z)).
Proof.
  intros test A B k LA LB unit WA WB Hk HA HB H. unfold mean_is in H.
  destruct (weighed (numbered LA) WA) as [[s x]|] eqn:EA; [|discriminate].
  destruct (weighed (numbered LB) WB) as [[t y]|] eqn:EB; [|discriminate].
  bsplit. subst s t. assert (Pu := IZR_pos _ H). assert (Pk := IZR_pos _ Hk).
  exists (zsub y x). repeat split; auto.
  apply weighed_sound in EA, EB; auto. apply (inside_conv A k LA) in EA; auto. apply (inside_conv B k LB) in EB; auto.
  eexists _, _. split; [exact EB|]. split; [exact EA|]. rewrite inj_sub. pteq; field; lra.
Qed.

(* a half-space, and points of the other core *)
Lemma greatest_attained : forall s L h, greatest s L = Some h -> exists p, In p L /\ IZR h = dot (inj s) (inj p).
Proof. intros s L h H. apply greatest_spec in H. destruct H as [(v & Iv & E) _]. exists v. rewrite <- dot_inj, E. auto. Qed.

(* the core is no half-space *)
Definition no_half_space (c : zcore) : Prop := match c with Half_space _ _ => False | _ => True end.

Lemma inner_reach_point : forall c s k q g e, (0 < k)%Z -> no_half_space c -> (forall L, q = Some L -> inside c k L) ->
  inner_reach s c k q = Some (g, e) -> 0 < IZR e /\ exists p, in_zcore c p /\ dot (inj s) p = IZR g / IZR e.
Proof.
  intros c s k q g e Hk Hc HL E. assert (Pk := IZR_pos _ Hk).
  assert (K : exists L, q = Some L /\ match greatest s L with Some h => Some (h, k) | None => None end = Some (g, e)).
  { destruct c as [K|ts|n d]; try contradiction; destruct q as [L|]; try discriminate; exists L; auto. }
  destruct K as (L & -> & E'). destruct (greatest s L) as [h|] eqn:G; [|discriminate]. inversion E'; subst. split; auto.
  apply greatest_attained in G. destruct G as (p & Ip & Ep).
  exists (scal (/ IZR e) (inj p)). split; [apply (HL L); auto|]. rewrite dot_scal_r, Ep. unfold Rdiv. ring.
Qed.

Lemma half_space_reach : forall s n o g e, reach s (Half_space n o) 1 [] = Some (g, e) ->
  0 < IZR e /\ forall x, dot (inj s) x <= IZR g / IZR e -> dot (inj n) x <= IZR o.
Proof.
  intros s n o g e H. assert (P0 := proj1 (reach_sound _ _ _ _ _ _ H)). split; auto. simpl in H.
  destruct (same_sense n s) eqn:E; [|discriminate]. inversion H; subst. rewrite norm2_inj, mult_IZR, dot_inj.
  intros x Hx. apply (half_space_multiple n s); auto.
Qed.

Lemma half_space_sound : forall A B n k pa pb l d, (0 < k)%Z -> one_half_space A B = true ->
  (forall L, pa = Some L -> inside A k L) -> (forall L, pb = Some L -> inside B k L) ->
  sum_of_fractions (inner_reach n B k pb) (inner_reach (zneg n) A k pa) = Some (l, d) ->
  0 < IZR d /\ forall x, dot (inj n) x <= IZR l / IZR d -> zgaps A B x.
Proof.
  intros A B n k pa pb l d Hk Hone Ha Hb H. unfold sum_of_fractions in H.
  destruct (inner_reach n B k pb) as [[x e]|] eqn:EB; [|discriminate].
  destruct (inner_reach (zneg n) A k pa) as [[y f]|] eqn:EA; [|discriminate]. inversion H; subst. clear H.
  assert (add_up : 0 < IZR e -> 0 < IZR f -> 0 < IZR (e * f) /\ IZR (x * f + y * e) / IZR (e * f) = IZR x / IZR e + IZR y / IZR f).
  { intros Pe Pf. rewrite mult_IZR, plus_IZR, !mult_IZR. split; [apply Rmult_lt_0_compat; auto|field; lra]. }
  assert (K : (no_half_space A /\ exists m o, B = Half_space m o) \/ (no_half_space B /\ exists m o, A = Half_space m o)).
  { destruct A; destruct B; try discriminate; simpl; eauto. }
  destruct K as [[HA (m & o & ->)]|[HB (m & o & ->)]].
  - destruct (inner_reach_point _ _ _ _ _ _ Hk HA Ha EA) as [Pf (p & Hp & Ep)].
    destruct (half_space_reach n m o x e EB) as [Pe G]. destruct (add_up Pe Pf) as [Pd E]. split; auto. intros z Hz. rewrite E in Hz.
    rewrite inj_neg, dot_scal_l in Ep. exists (add z p), p. split; [|split; auto; pteq; ring].
    simpl. apply G. rewrite dot_add_r. lra.
  - destruct (inner_reach_point _ _ _ _ _ _ Hk HB Hb EB) as [Pe (p & Hp & Ep)].
    destruct (half_space_reach (zneg n) m o y f EA) as [Pf G]. destruct (add_up Pe Pf) as [Pd E]. split; auto. intros z Hz. rewrite E in Hz.
    exists p, (sub p z). split; auto. split; [|pteq; ring].
    simpl. apply G. rewrite inj_neg, dot_scal_l, dot_sub_r. lra.
Qed.
