(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* THE THEOREMS about the lines of bodies of the plane: what they say is true of the bodies in the file. *)
Require Import Reals Lra Psatz List ZArith Lia Bool.
From Fathom.checker Require Import sequence certificate verdict body signed signed_verdict unions union_verdict plane.
From Fathom.geometry Require Import meaning unions space norm hulls difference rounded gaps said plane.
From Fathom.soundness Require Import statement booleans verdict_sound signed_sound union_sound.
Import ListNotations.
Open Scope R_scope.

(* ---- the numbers ---- *)
Lemma height_value : forall h, is_height h = true -> 0 < value h /\ 0 < IZR (den h).
Proof.
  intros h H. unfold is_height in H. bsplit. assert (N := IZR_lt _ _ H). assert (D := IZR_lt _ _ H0).
  split; auto. unfold value. apply Rdiv_lt_0_compat; auto.
Qed.
Lemma below_value : forall h q, is_height h = true -> below h q = true -> value q < value h * value h.
Proof.
  intros h q H B. destruct (height_value h H) as [P D]. unfold below in B. bsplit. rename H0 into Dq, H1 into L.
  apply IZR_lt in Dq, L. rewrite !mult_IZR in L. unfold value.
  replace (IZR (num h) / IZR (den h) * (IZR (num h) / IZR (den h)))
    with (IZR (num h) * IZR (num h) * IZR (den q) / (IZR (den h) * IZR (den h)) / IZR (den q)) by (field; lra).
  unfold Rdiv at 1 2. apply Rmult_lt_compat_r; [apply Rinv_0_lt_compat; auto|].
  apply Rmult_lt_reg_r with (IZR (den h) * IZR (den h)); [apply Rmult_lt_0_compat; auto|].
  unfold Rdiv. rewrite Rmult_assoc, Rinv_l; [lra|]. apply Rgt_not_eq, Rmult_lt_0_compat; auto.
Qed.

Lemma real_leveled : forall z p, real (leveled z p) = at_level (value z) (real p).
Proof. reflexivity. Qed.
Lemma real_flat : forall L, map real (flat L) = map (at_level 0) (map real L).
Proof.
  intros L. unfold flat. rewrite each_map, !map_map. apply map_ext. intros p. rewrite real_leveled.
  unfold value. cbn [num den]. f_equal. lra.
Qed.
Definition upper_and_lower (h : R) (L : list pt) := map (at_level (- h)) L ++ map (at_level h) L.
Lemma real_prism : forall h L, map real (prism h L) = upper_and_lower (value h) (map real L).
Proof.
  intros h L. unfold prism, upper_and_lower. rewrite !rev_append_rev, app_nil_r, rev_involutive, !each_map, map_app, !map_map.
  f_equal; apply map_ext; intros p; rewrite real_leveled; auto.
  f_equal. unfold value. cbn [num den]. rewrite opp_IZR. unfold Rdiv. ring.
Qed.

(* ---- what is said ---- *)
Section Said.
  Variables (h : ratio) (U U' G G' : pt -> Prop).
  Hypothesis UU : forall t, U' t -> U t.
  Hypothesis DU : forall t, U t -> - value h < pz t < value h -> U' t.
  Hypothesis RG : raised (value h) G G'.

  Lemma raised_says : forall s, statement_below h s = true -> says_of U' G' s -> says_of U (upright G) s.
  Proof.
    intros s H S. unfold statement_below in H. apply andb_true_iff in H. destruct H as [H L].
    destruct (height_value h H) as [P _]. assert (Q : 0 < value h * value h) by (apply Rmult_lt_0_compat; auto).
    destruct s as [q optima|lo hi| | |q]; cbn [says_of] in *.
    - apply below_value in L; auto. destruct S as (Pq & D & E). split; auto.
      split; [apply (raised_depth (value h) U U' G G'); auto|]. intros k K. apply (raised_exits (value h) U U'); auto.
    - apply below_value in L; auto. destruct S as (q & Pq & D & E). exists q. split; auto. split; auto.
      apply (raised_depth (value h) U U' G G'); auto. lra.
    - apply (raised_depth (value h) U U' G G'); auto.
    - intros X. apply S. apply RG; auto. simpl. lra.
    - destruct S as [Pq D]. split; auto. apply (raised_depth (value h) U U' G G'); auto. lra.
  Qed.
End Said.

Lemma raised_interior : forall h G G', raised h G G' -> (forall t, interior G' t -> interior (upright G) t)
  /\ forall t, interior (upright G) t -> - h < pz t < h -> interior G' t.
Proof.
  intros h G G' R. split; [intros t; apply interior_mono, R|]. intros t. apply interior_raised. exact R.
Qed.

(* ---- polytopes ---- *)
Theorem plane_verdict_sound : forall m h A B c s, plane_verdict m h A B c = Some s -> says_plane (map real A) (map real B) s.
Proof.
  intros m h A B c s H. unfold plane_verdict in H. destruct (verdict _ _ _ _ _) as [s'|] eqn:V; [|discriminate].
  destruct (statement_below h s') eqn:L; [|discriminate]. inversion H; subst. clear H. apply verdict_sound in V.
  assert (P : 0 < value h) by (unfold statement_below in L; apply andb_true_iff in L; apply height_value; tauto).
  unfold says in V. cbv zeta in V. rewrite real_flat, real_prism in V.
  assert (R := raised_difference (value h) _ _ _ _ (drawn_hull (map real A)) (raised_hull (value h) (map real B) P)).
  destruct (raised_interior _ _ _ R) as [I J]. exact (raised_says h _ _ _ _ I J R s L V).
Qed.

(* ---- unions ---- *)
Lemma raised_union : forall h Ls, 0 < h -> raised h (union Ls) (union (map (upper_and_lower h) Ls)).
Proof.
  intros h Ls P. split.
  - intros p (K & IK & Hp). apply in_map_iff in IK. destruct IK as (L & <- & IL). apply raised_hull in Hp; auto.
    destruct Hp as (z & Hp). exists z, L. auto.
  - intros p (z & L & IL & Hp) Hz. exists (upper_and_lower h L). split; [apply in_map; auto|].
    apply raised_hull; auto. exists z. exact Hp.
Qed.

Lemma real_prisms : forall h Ls, real_pieces (each (prism h) Ls) = map (upper_and_lower (value h)) (real_pieces Ls).
Proof. intros h Ls. unfold real_pieces. rewrite each_map, !map_map. apply map_ext. intros L. apply real_prism. Qed.

Lemma solid_raised : forall h Ls, 0 < h -> solid_pieces (map (upper_and_lower h) Ls) -> solid_up Ls.
Proof.
  intros h Ls P [N S]. split; [intros ->; apply N; auto|]. intros L IL.
  destruct (S (upper_and_lower h L)) as (p & I); [apply in_map; auto|]. exists p. revert I. apply interior_mono.
  apply raised_hull. exact P.
Qed.

Theorem plane_union_verdict_sound : forall m h As Bs c s, plane_union_verdict m h As Bs c = Some s ->
  says_plane_union (real_pieces As) (real_pieces Bs) s.
Proof.
  intros m h As Bs c s H. unfold plane_union_verdict in H. destruct (union_verdict _ _ _ _) as [s'|] eqn:V; [|discriminate].
  destruct (statement_below h (union_says s')) eqn:L; [|discriminate]. inversion H; subst. clear H. apply union_verdict_sound in V.
  assert (P : 0 < value h) by (unfold statement_below in L; apply andb_true_iff in L; apply height_value; tauto).
  rewrite !real_prisms in V. destruct V as (SA & SB & CA & CB & V). rewrite map_length in CA, CB.
  split; [revert SA; apply solid_raised; auto|]. split; [revert SB; apply solid_raised; auto|]. split; auto. split; auto.
  assert (RA := raised_union (value h) (real_pieces As) P). assert (RB := raised_union (value h) (real_pieces Bs) P).
  destruct (raised_interior _ _ _ RA) as [IA JA]. destruct (raised_interior _ _ _ RB) as [IB JB].
  refine (raised_says h _ _ _ _ _ _ (raised_difference (value h) _ _ _ _ (raised_drawn (value h) _ _ _ RA) RB) _ L V); [| |lra].
  - intros t (p & Ha & Hb). exists p. auto.
  - intros t (p & Ha & Hb) Hz. exists (at_level 0 p). split.
    + apply JA; [|simpl; lra]. apply (interior_level _ _ (0 - pz t)) in Ha. exact Ha.
    + apply JB; [|simpl; lra]. apply interior_level. exact Hb.
Qed.

(* ---- rounded bodies, and half-planes ---- *)
Lemma raised_body_real : forall f b b', raised_body f b = Some b' -> exists c', real_body b' = Body c' (radius (real_body b))
  /\ ((exists L, core_of (real_body b) = Points (map real L) /\ c' = Points (map real (f L)))
      \/ exists n d, pz n = 0 /\ core_of (real_body b) = Half_space n d /\ c' = Half_space n d).
Proof.
  intros f [c r] b' H. unfold raised_body in H. cbn [core_of radius] in H. destruct c as [L|ts|n d]; [| discriminate|].
  - inversion H; subst. eexists. split; [reflexivity|]. left. exists L. auto.
  - destruct (num (qz n) =? 0)%Z eqn:E; [|discriminate]. inversion H; subst. eexists. split; [reflexivity|]. right.
    exists (real n), (value d). split; auto. apply Z.eqb_eq in E. unfold real, value. simpl. rewrite E. unfold Rdiv. ring.
Qed.

Lemma drawn_body : forall b b', raised_body flat b = Some b' -> radius (real_body b') = radius (real_body b)
  /\ drawn (in_core (core_of (real_body b))) (in_core (core_of (real_body b'))).
Proof.
  intros b b' H. apply raised_body_real in H. destruct H as (c' & -> & [(L & -> & ->)|(n & d & Z & -> & ->)]); split; auto.
  - cbn [core_of in_core]. rewrite real_flat. apply drawn_hull.
  - apply (raised_half_space n d 0 Z).
Qed.
Lemma prism_body : forall h b b', 0 < value h -> raised_body (prism h) b = Some b' -> radius (real_body b') = radius (real_body b)
  /\ raised (value h) (in_core (core_of (real_body b))) (in_core (core_of (real_body b'))).
Proof.
  intros h b b' P H. apply raised_body_real in H. destruct H as (c' & -> & [(L & -> & ->)|(n & d & Z & -> & ->)]); split; auto.
  - cbn [core_of in_core]. rewrite real_prism. apply raised_hull. exact P.
  - apply (raised_half_space n d (value h) Z).
Qed.

(* what is not longer than a height below which the roots are *)
Lemma signed_square_below : forall v h, 0 < h -> v < h -> v * Rabs v < h * h.
Proof.
  intros v h P L. destruct (Rle_dec 0 v) as [V|V]; [rewrite Rabs_right by lra; nra|]. rewrite Rabs_left by lra. nra.
Qed.
Lemma root_below : forall v h, 0 < h -> v * Rabs v < h * h -> v < h.
Proof.
  intros v h P L. apply Rnot_le_lt. intros V. rewrite Rabs_right in L by lra. nra.
Qed.

Lemma raised_polar : forall h C C', 0 < h -> raised h C C' -> C' origin -> forall u, polar C' u <-> polar (upright C) u.
Proof.
  intros h C C' P [U D] O u. apply U in O. split.
  - intros H g Hg.
    assert (T : forall z, - h <= z <= h -> pz u * z <= 0).
    { intros z Hz. assert (X := H (at_level z origin)). unfold dot in X. simpl in X.
      assert (Y : C' (at_level z origin)) by (apply D; [apply upright_level; auto|auto]). specialize (X Y). lra. }
    assert (T1 := T h). assert (T2 := T (- h)). assert (Z : pz u = 0) by nra.
    assert (X := H (at_level 0 g)). assert (Y : C' (at_level 0 g)) by (apply D; [apply upright_level; auto|simpl; lra]).
    specialize (X Y). unfold dot in *. simpl in X. rewrite Z in *. lra.
  - intros H g Hg. apply H, U, Hg.
Qed.

Lemma cone_is_same : forall K K' k r, (forall u, K u <-> K' u) -> cone_is K k r -> cone_is K' k r.
Proof.
  intros K K' k r E (ls & rs & A & B & G & L & R). exists ls, rs. split; auto. split; auto. split; [intros u; rewrite <- E; auto|].
  split; auto. intros xs q ys Eq. rewrite <- E. apply (R xs q ys Eq).
Qed.

Section Signed.
  Variables (h : ratio) (C C' G G' : pt -> Prop) (r : R).
  Hypothesis RC : raised (value h) C C'.
  Hypothesis RG : raised (value h) G G'.

  Lemma raised_says_gaps : forall s, signed_below h s = true -> says_gaps C' G' r s ->
    says_gaps (upright C) (upright G) r s.
  Proof.
    intros [st lo hi|st q rho optima cone] H S; [discriminate|]. unfold signed_below in H. cbv zeta in H.
    set (left := Ratio (num h * den rho - num rho * den h) (den h * den rho)) in *.
    apply andb_true_iff in H. destruct H as [H HC]. apply andb_true_iff in H. destruct H as [H HO].
    apply andb_true_iff in H. destruct H as [H HB]. apply andb_true_iff in H. destruct H as [H HL].
    apply andb_true_iff in H. destruct H as [H HR]. apply andb_true_iff in H. destruct H as [H HD].
    apply Z.ltb_lt in HD. apply Z.leb_le in HR. apply IZR_lt in HD. apply IZR_le in HR.
    destruct (height_value h H) as [P Dh]. destruct (height_value left HL) as [PL _].
    assert (Dq : (0 < den q)%Z) by (unfold below in HB; bsplit; auto). apply IZR_lt in Dq. apply below_value in HB; auto.
    assert (EL : value left = value h - value rho).
    { unfold value, left. cbn [num den]. rewrite minus_IZR, !mult_IZR. field. lra. }
    assert (PR : 0 <= value rho) by (unfold value; apply Rmult_le_pos; [auto|left; apply Rinv_0_lt_compat; auto]).
    destruct S as (x & r' & Q & DC & -> & ER & DG & SG & E & K). rewrite ER in *.
    unfold root_is in Q. rewrite <- Q in HB. assert (Lx : x < value h - r) by (rewrite <- EL; apply root_below; auto; lra).
    destruct (raised_interior _ _ _ RC) as [IC JC]. destruct (raised_interior _ _ _ RG) as [IG JG].
    exists x, r. split; auto. split; [|split; [auto|split; [auto|split; [|split; [auto|split]]]]].
    - apply (raised_depth (value h) _ _ C C' P IC JC RC); auto. apply signed_square_below; lra.
    - apply (raised_depth (value h) _ _ G G' P IG JG RG); auto. apply signed_square_below; lra.
    - intros k Ek. subst optima. apply Z.ltb_lt, IZR_lt in HO. specialize (E k eq_refl).
      assert (Px : 0 < x).
      { apply Rnot_le_lt. intros X. assert (A := Rabs_pos x).
        assert (0 < value q) by (unfold value; apply Rdiv_lt_0_compat; auto). nra. }
      apply (raised_exits (value h) _ (interior G')); auto. nra.
    - intros k m Ek. subst cone. destruct (K k m eq_refl) as [K1 K2]. apply Z.eqb_eq in HC.
      assert (Zx : x = 0).
      { assert (Zq : x * Rabs x = 0) by (rewrite Q; unfold value; rewrite HC; unfold Rdiv; ring).
        apply Rmult_integral in Zq. destruct Zq as [Zq|Zq]; auto. destruct (Req_dec x 0) as [N|N]; auto. apply Rabs_no_R0 in N. contradiction. }
      assert (O : C' origin).
      { rewrite Zx in DC. unfold signed_depth_is in DC. rewrite Rabs_R0, Rmult_0_r in DC. apply (depth2_some C' 0); [lra|exact DC]. }
      assert (PK := raised_polar (value h) C C' P RC O). split; [apply (cone_is_same (polar C')); auto|].
      intros Pr t Nt. rewrite <- PK, <- K2 by auto. assert (S := same_below (value h) _ _ P IG JG t (r * r)).
      rewrite S; [tauto|lra|nra].
  Qed.
End Signed.

Theorem plane_signed_verdict_sound : forall m rho h A B c s, plane_signed_verdict m rho h A B c = Some s ->
  says_plane_signed (real_body A) (real_body B) s.
Proof.
  intros m rho h A B c s H. unfold plane_signed_verdict in H. destruct (raised_body flat A) as [a|] eqn:EA; [|discriminate].
  destruct (raised_body (prism h) B) as [b|] eqn:EB; [|discriminate].
  destruct (signed_verdict _ _ _ _ _ _) as [s'|] eqn:V; [|discriminate]. destruct (signed_below h s') eqn:L; [|discriminate].
  inversion H; subst. clear H. apply signed_verdict_sound in V. unfold says_signed in V.
  assert (P : 0 < value h).
  { destruct s as [|st q rho' optima cone]; [discriminate|]. unfold signed_below in L. cbv zeta in L.
    do 6 (apply andb_true_iff in L; destruct L as [L _]). apply height_value. exact L. }
  apply drawn_body in EA. apply prism_body in EB; auto. destruct EA as [RA DA], EB as [RB DB]. rewrite RA, RB in V.
  revert L V. apply raised_says_gaps.
  - apply raised_difference; auto.
  - unfold gaps, in_body. rewrite RA, RB. apply raised_difference; [apply drawn_thick; auto|apply raised_thick; auto].
Qed.
