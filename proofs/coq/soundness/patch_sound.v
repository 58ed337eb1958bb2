(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Format 4: the corners that pass the check are those of the patch, of the cores in units of 1/m.
   *)
Require Import Reals Lra Psatz List ZArith Lia Bool.
From Fathom.checker Require Import vector sequence table support verdict body signed patch.
From Fathom.geometry Require Import meaning bodies space norm hulls difference signed_depth curved contact patches.
From Fathom.soundness Require Import statement booleans upper optima signed_sides verdict_sound.
Import ListNotations.
Open Scope R_scope.

Definition at_quotient (p : quotient) : pt := scal (/ IZR (snd p)) (inj (fst p)).

(* ---- faces ---- *)
Lemma face_spec : forall s L g, greatest s L = Some g -> forall p, In p (face s L) <-> In p L /\ zdot s p = g.
Proof.
  intros s L g E p. unfold face. rewrite E. clear E.
  assert (G : forall L done, In p (fold_left (fun l p => if (zdot s p =? g)%Z then p :: l else l) L done) <->
    (In p L /\ zdot s p = g) \/ In p done).
  { induction L0 as [|q L0 IH]; intros done; simpl; [tauto|]. rewrite IH.
    destruct (zdot s q =? g)%Z eqn:E; [apply Z.eqb_eq in E|apply Z.eqb_neq in E]; simpl; intuition subst; auto.
    contradiction. }
  rewrite G. simpl. tauto.
Qed.
Lemma face_level : forall s L x u, level_with s (face (s) L) x u = true -> exists g, greatest s L = Some g /\ zdot s x
  = (u * g)%Z.
Proof.
  intros s L x u H. unfold level_with in H.
  destruct (greatest s L) as [g|] eqn:E; [|unfold face in H; rewrite E in H; discriminate].
  exists g. split; auto. destruct (face s L) as [|p F] eqn:Ef; [discriminate|]. apply Z.eqb_eq in H.
  assert (K := face_spec s L g E p). rewrite Ef in K. destruct K as [K _]. destruct K as [_ K]; [simpl; auto|].
  rewrite K in H. auto.
Qed.
Lemma greatest_opp_level : forall n L x u, level_with n (face (zneg n) L) x u = true ->
  exists g, greatest (zneg n) L = Some g /\ zdot n x = (u * - g)%Z.
Proof.
  intros n L x u H. destruct (face_level (zneg n) L (x) u) as (g & E & K).
  - unfold level_with in *. destruct (face (zneg n) L) as [|p F]; [discriminate|]. apply Z.eqb_eq in H. apply Z.eqb_eq.
    replace (zdot (zneg n) x) with (- zdot n x)%Z by (unfold zdot, zneg; simpl; ring).
    replace (zdot (zneg n) p) with (- zdot n p)%Z by (unfold zdot, zneg; simpl; ring). lia.
  - exists g. split; auto. replace (zdot (zneg n) x) with (- zdot n x)%Z in K by (unfold zdot, zneg; simpl; ring). lia.
Qed.

(* a point of the hull that is on the plane of a face is no lower than its points *)
Lemma face_low : forall s L g m l x, greatest s L = Some g -> greatest (zneg m) (face s L) = Some l -> conv (map inj L)
  x ->
  dot (inj s) x = IZR g -> IZR (- l) <= dot (inj m) x.
Proof.
  intros s L g m l x Eg El Hx.
  assert (K : dot (inj s) x <= IZR g /\ (dot (inj s) x = IZR g -> IZR (- l) <= dot (inj m) x)); [|tauto].
  apply (Hx (fun x => dot (inj s) x <= IZR g /\ (dot (inj s) x = IZR g -> IZR (- l) <= dot (inj m) x))).
  - intros u v k Hk [Lu Mu] [Lv Mv]. rewrite !dot_add_r, !dot_scal_r. split; [nra|]. intros E.
    destruct (Req_dec k 0) as [->|N0]; [rewrite !Rmult_0_l in *; replace (1 - 0) with 1 in * by lra; apply Rle_trans
      with (dot (inj m) v);
      [apply Mv; lra|lra]|].
    destruct (Req_dec k 1) as [->|N1]; [apply Rle_trans with (dot (inj m) u); [apply Mu; lra|lra]|].
    assert (Eu : dot (inj s) u = IZR g) by nra. assert (Ev : dot (inj s) v = IZR g) by nra.
    specialize (Mu Eu). specialize (Mv Ev). nra.
  - intros p Ip. apply in_map_iff in Ip. destruct Ip as (q & <- & Iq). rewrite <- !dot_inj.
    assert (G := greatest_spec s L g Eg). split; [apply IZR_le, G; auto|]. intros E. apply eq_IZR in E.
    assert (If : In q (face s L)) by (apply (face_spec s L g Eg); auto).
    apply IZR_le. assert (G' := proj2 (greatest_spec _ _ _ El) q If).
    replace (zdot (zneg m) q) with (- zdot m q)%Z in G' by (unfold zdot, zneg; simpl; ring). lia.
Qed.

Lemma spots_core : forall c L, spots c = L -> L <> [] -> c = Points L.
Proof. intros [K|ts|m o] L; simpl; intros <- N; congruence. Qed.
Lemma in_points : forall L x, in_zcore (Points L) x <-> conv (map inj L) x.
Proof. intros L x. simpl. rewrite each_map. tauto. Qed.

Section Direction.
  Variables (A B : zcore) (n : zvec) (h d : Z).
  Hypothesis H0 : outer_height A B (Heights 1 [] []) n = Some (h, d).
  Hypothesis Hn : inj n <> origin.
  Let TA := numbered (spots A).
  Let TB := numbered (spots B).
  Let FA := face (zneg n) (spots A).
  Let FB := face n (spots B).
  Let H := IZR h / IZR d.
  Let t := scal (H / norm2 (inj n)) (inj n).
  Let C := meeting (in_zcore A) (in_zcore B) t.

  Lemma heights_split : exists x e y f, reach n B 1 [] = Some (x, e) /\ reach (zneg n) A 1 [] = Some (y, f)
    /\ 0 < IZR e /\ 0 < IZR f /\ 0 < IZR d /\ H = IZR x / IZR e + IZR y / IZR f.
  Proof.
    assert (K := H0). unfold outer_height, sum_of_fractions in K. cbn [height_unit heights_a heights_b] in K.
    destruct (reach n B 1 []) as [[x e]|] eqn:EB; [|discriminate].
    destruct (reach (zneg n) A 1 []) as [[y f]|] eqn:EA; [|discriminate].
    inversion K as [[Eh Ed]]. exists x, e, y, f.
    destruct (reach_sound _ _ _ _ _ _ EB) as [Pe _]. destruct (reach_sound _ _ _ _ _ _ EA) as [Pf _].
    split; auto. split; auto. split; auto. split; auto. unfold H. rewrite <- Eh, <- Ed, mult_IZR, plus_IZR, !mult_IZR.
    split; [apply Rmult_lt_0_compat; auto|field; lra].
  Qed.

  Lemma dot_t : dot (inj n) t = H.
  Proof. unfold t. rewrite dot_scal_r. fold (norm2 (inj n)). field. apply Rgt_not_eq, norm2_pos; auto. Qed.
  Lemma dot_t_side : forall m, zdot n m = 0%Z -> dot (inj m) t = 0.
  Proof.
    intros m E. unfold t. rewrite dot_scal_r, dot_comm, <- dot_inj, E. ring.
  Qed.

  (* the patch is level at both bodies *)
  Lemma patch_level : forall x e y f p, reach n B 1 [] = Some (x, e) -> reach (zneg n) A 1 [] = Some (y, f) -> C p ->
    dot (inj n) p = - (IZR y / IZR f) /\ dot (inj n) (add p t) = IZR x / IZR e.
  Proof.
    intros x e y f p EB EA [PA PB]. destruct heights_split as (x' & e' & y' & f' & EB' & EA' & _ & _ & _ & E).
    rewrite EB in EB'. rewrite EA in EA'. inversion EB'. inversion EA'. subst x' e' y' f'.
    apply reach_sound in EB. apply reach_sound in EA. destruct EB as [_ KB]. destruct EA as [_ KA].
    specialize (KB _ PB). specialize (KA _ PA). rewrite inj_neg, dot_scal_l in KA. rewrite dot_add_r, dot_t in *. lra.
  Qed.

  Lemma patch_flat : exists c, forall p, C p -> dot (inj n) p = c.
  Proof.
    destruct heights_split as (x & e & y & f & EB & EA & _). exists (- (IZR y / IZR f)). intros p Cp.
    apply (patch_level x e y f p EB EA Cp).
  Qed.

  Lemma patch_convex : convex C.
  Proof.
    intros u v l Hl [UA UB] [VA VB]. split; [apply in_core_convex; auto|].
    replace (add (add (scal l u) (scal (1 - l) v)) t) with (add (scal l (add u t)) (scal (1 - l) (add v t))) by (pteq;
      ring).
    apply in_core_convex; auto.
  Qed.

  (* ---- corners ---- *)
  Lemma end_sound : forall c p, end_of A B TA TB n h d FA FB c = Some p -> 0 < IZR (snd p) /\ C (at_quotient p).
  Proof.
    intros [u WA WB i] p E. unfold end_of in E. cbn [corner_unit corner_a corner_b] in E.
    destruct (weighed TA WA) as [[s x]|] eqn:XA; [|discriminate].
    destruct (weighed TB WB) as [[s' y]|] eqn:XB; [|discriminate].
    destruct heights_split as (g & e & k & f & EB & EA & Pe & Pf & Pd & EH). assert (N0 := norm2_pos _ Hn).
    destruct A as [LA|ta|ma oa] eqn:EqA; destruct B as [LB|tb|mb ob] eqn:EqB; try discriminate.
    - (* points and points *)
      destruct (_ && _ && _ && _) eqn:Q in E; [|discriminate]. inversion E. subst p. clear E. bsplit. subst s s'.
      rename H1 into Hu, H2 into Hv. apply same_vector_spec in Hv.
      apply weighed_sound in XA; auto. apply weighed_sound in XB; auto. cbn [spots] in XA, XB.
      assert (Pu := IZR_pos _ Hu).
      unfold at_quotient. cbn [fst snd]. split; auto. split; [apply in_points; auto|]. apply in_points.
      replace (add (scal (/ IZR u) (inj x)) t) with (scal (/ IZR u) (inj y)); auto.
      apply (f_equal inj) in Hv. rewrite !inj_scal, inj_sub, !mult_IZR, norm2_inj in Hv. unfold t, H.
      assert (V : forall a b c : R, IZR d * norm2 (inj n) * (a - b) = IZR u * IZR h * c ->
        / IZR u * a = / IZR u * b + IZR h / IZR d / norm2 (inj n) * c).
      { intros a b c K. apply Rmult_eq_reg_l with (IZR d * norm2 (inj n) * IZR u); [|apply Rgt_not_eq; repeat apply
        Rmult_lt_0_compat; auto].
        replace (IZR d * norm2 (inj n) * IZR u * (/ IZR u * a)) with (IZR d * norm2 (inj n) * (a - b) + IZR d * norm2
          (inj n) * b) by (field; lra).
        rewrite K. field. lra. }
      assert (X := f_equal px Hv). assert (Y := f_equal py Hv). assert (Z := f_equal pz Hv). simpl in X, Y, Z.
      pteq; apply V; auto.
    - (* points and a half-space *)
      destruct (_ && _ && _) eqn:Q in E; [|discriminate]. inversion E. subst p. clear E. bsplit.
      rename H1 into Hu, H2 into Hl. subst s.
      destruct (greatest_opp_level _ _ _ _ Hl) as (l & El & Lx). cbn [spots] in El. simpl in EA. rewrite El in EA.
      inversion EA. subst k f.
      apply weighed_sound in XA; auto. cbn [spots] in XA. assert (Pu := IZR_pos _ Hu). unfold at_quotient.
      cbn [fst snd].
      split; auto. split; [apply in_points; auto|]. simpl in EB. destruct (same_sense mb n) eqn:S; [|discriminate].
      inversion EB. subst g e.
      cbn [map_core in_core]. apply (half_space_multiple mb n (IZR ob) _ S).
      rewrite dot_add_r, dot_t, dot_scal_r, <- dot_inj, Lx, mult_IZR, opp_IZR, EH, mult_IZR, !dot_inj.
      fold (norm2 (inj mb)).
      replace (/ IZR u * (IZR u * - IZR l)) with (- IZR l) by (field; lra). right. field.
      rewrite dot_inj in Pe. fold (norm2 (inj mb)) in Pe. lra.
    - (* a half-space and points *)
      destruct (_ && _ && _) eqn:Q in E; [|discriminate]. inversion E. subst p. clear E. bsplit.
      rename H1 into Hu, H2 into Hl. subst s'.
      destruct (face_level _ _ _ _ Hl) as (l & El & Lx). cbn [spots] in El. simpl in EB. rewrite El in EB.
      inversion EB. subst g e.
      apply weighed_sound in XB; auto. cbn [spots] in XB. assert (Pu := IZR_pos _ Hu). unfold at_quotient.
      cbn [fst snd].
      rewrite !mult_IZR, norm2_inj. assert (Pk : 0 < IZR u * (IZR d * norm2 (inj n))) by (repeat apply
        Rmult_lt_0_compat; auto).
      split; auto. assert (Et : add (scal (/ (IZR u * (IZR d * norm2 (inj n)))) (inj (zsub (zscal (d * zdot n n) y)
        (zscal (u * h) n)))) t
        = scal (/ IZR u) (inj y)).
      { rewrite inj_sub, !inj_scal, !mult_IZR, norm2_inj. unfold t, H. pteq; field; lra. }
      split; [|rewrite Et; apply in_points; auto].
      simpl in EA. destruct (same_sense ma (zneg n)) eqn:S; [|discriminate]. inversion EA. subst k f.
      cbn [map_core in_core]. apply (half_space_multiple ma (zneg n) (IZR oa) _ S).
      set (p := scal _ (inj (zsub _ _))) in *. rewrite inj_neg, dot_scal_l, dot_scal_r.
      assert (K := f_equal (dot (inj n)) Et). rewrite dot_add_r, dot_t, dot_scal_r, <- dot_inj, Lx, mult_IZR, EH in K.
      rewrite dot_inj in Pf, EH, K. rewrite mult_IZR, dot_inj, inj_neg, dot_scal_r in K. fold (norm2 (inj ma)) in K, Pf.
      replace (/ IZR u * (IZR u * IZR l)) with (IZR l) in K by (field; lra).
      replace (IZR l / 1) with (IZR l) in K by field. lra.
  Qed.

  (* ---- sides ---- *)
  Lemma flank_low : forall s ends f, flank_of n FA FB ends s = Some f ->
    (forall p, C p -> IZR (level_of f) <= dot (inj (normal_of f)) p) /\ member ends (side_corner s) = Some (end_at f).
  Proof.
    intros [b m i] ends f E. unfold flank_of in E. cbn [of_b inward side_corner] in E.
    destruct (greatest (zneg m) (if b then FB else FA)) as [l|] eqn:El; [|discriminate].
    destruct (member ends i) as [q|] eqn:Em; [|discriminate]. destruct (zdot n m =? 0)%Z eqn:Z0; [|discriminate].
    apply Z.eqb_eq in Z0. inversion E. subst f. clear E. cbn [normal_of level_of end_at side_corner]. split; auto.
    intros p Cp.
    destruct heights_split as (g & e & k & f & EB & EA & _). destruct (patch_level g e k f p EB EA Cp) as [LA LB].
    destruct Cp as [PA PB]. destruct b.
    - assert (F : exists L, B = Points L).
      { unfold FB, face in El. destruct B as [L|ts|o r]; [exists L; auto| |]; discriminate. }
      destruct F as [L F]. unfold FB in El. rewrite F in *. cbn [spots] in El. apply in_points in PB. simpl in EB.
      destruct (greatest n L) as [g'|] eqn:Eg; [|discriminate]. inversion EB. subst g' e.
      replace (dot (inj m) p) with (dot (inj m) (add p t)) by (rewrite dot_add_r, dot_t_side; auto; ring).
      apply (face_low n L g m l); auto. rewrite LB. field.
    - assert (F : exists L, A = Points L).
      { unfold FA, face in El. destruct A as [L|ts|o r]; [exists L; auto| |]; discriminate. }
      destruct F as [L F]. unfold FA in El. rewrite F in *. cbn [spots] in El. apply in_points in PA. simpl in EA.
      destruct (greatest (zneg n) L) as [g'|] eqn:Eg; [|discriminate]. inversion EA. subst g' f.
      apply (face_low (zneg n) L k m l); auto. rewrite inj_neg, dot_scal_l, LA. field.
  Qed.

  Lemma through_low : forall f p, 0 < IZR (snd p) -> through f p = true -> IZR (level_of f) = dot (inj (normal_of f))
    (at_quotient p).
  Proof.
    intros f p P0 E. unfold through in E. apply Z.eqb_eq in E. unfold at_quotient.
    rewrite dot_scal_r, <- dot_inj, E, mult_IZR. field. lra.
  Qed.
End Direction.

(* ---- no corner twice ---- *)
Definition R_before (p q : pt) := px p < px q \/ px p = px q /\ (py p < py q \/ py p = py q /\ pz p < pz q).

Lemma quotient_before_spec : forall p q, 0 < IZR (snd p) -> 0 < IZR (snd q) -> quotient_before p q = true ->
  R_before (at_quotient p) (at_quotient q).
Proof.
  intros [u k] [v l] Pk Pl H. cbn [fst snd] in *. unfold quotient_before in H. cbn [fst snd] in H.
  apply before_spec in H.
  assert (Lt : forall a b, (l * a < k * b)%Z -> / IZR k * IZR a < / IZR l * IZR b).
  { intros a b L. apply IZR_lt in L. rewrite !mult_IZR in L.
    apply Rmult_lt_reg_l with (IZR k * IZR l); [apply Rmult_lt_0_compat; auto|].
    replace (IZR k * IZR l * (/ IZR k * IZR a)) with (IZR l * IZR a) by (field; lra).
    replace (IZR k * IZR l * (/ IZR l * IZR b)) with (IZR k * IZR b) by (field; lra). auto. }
  assert (Eq : forall a b, (l * a = k * b)%Z -> / IZR k * IZR a = / IZR l * IZR b).
  { intros a b L. apply (f_equal IZR) in L. rewrite !mult_IZR in L.
    apply Rmult_eq_reg_l with (IZR k * IZR l); [|apply Rgt_not_eq, Rmult_lt_0_compat; auto].
    replace (IZR k * IZR l * (/ IZR k * IZR a)) with (IZR l * IZR a) by (field; lra).
    replace (IZR k * IZR l * (/ IZR l * IZR b)) with (IZR k * IZR b) by (field; lra). auto. }
  unfold R_before, at_quotient. simpl in *. destruct H as [H|[H1 [H|[H2 H]]]]; auto 10.
Qed.

Lemma R_before_trans : forall u v w, R_before u v -> R_before v w -> R_before u w.
Proof. unfold R_before. intros u v w [H|[H1 [H|[H2 H]]]] [K|[K1 [K|[K2 K]]]]; lra. Qed.

Lemma ascending_different : forall l p, (forall q, In q (p :: l) -> 0 < IZR (snd q)) -> along_pairs quotient_before p l
  = true ->
  NoDup (map at_quotient (p :: l)) /\ forall q, In q l -> R_before (at_quotient p) (at_quotient q).
Proof.
  induction l as [|q l IH]; intros p P0 H; simpl in H.
  - split; [|simpl; tauto]. constructor; [simpl; tauto|constructor].
  - destruct (quotient_before p q) eqn:E; [|discriminate]. apply quotient_before_spec in E; try (apply P0; simpl; auto).
    destruct (IH q) as [N L]; auto. { intros r Ir. apply P0. simpl in *; tauto. }
    assert (L' : forall r, In r (q :: l) -> R_before (at_quotient p) (at_quotient r)).
    { intros r [<-|Ir]; auto. apply (R_before_trans _ (at_quotient q)); auto. }
    split; auto. cbn [map]. constructor; auto. intros I0.
    change (In (at_quotient p) (map at_quotient (q :: l))) in I0. apply in_map_iff in I0. destruct I0 as (r & Er & Ir).
    specialize (L' r Ir). rewrite Er in L'. unfold R_before in L'. lra.
Qed.

Lemma all_different_sound : forall ends order, (forall q, In q ends -> 0 < IZR (snd q)) -> all_different ends order =
  true ->
  NoDup (map at_quotient ends).
Proof.
  intros ends order P0 H. unfold all_different in H. destruct (every _ order) as [[|p l]|] eqn:E; try discriminate.
  bsplit.
  rewrite !count_length in H0. assert (Sub : forall q, In q (p :: l) -> In q ends).
  { intros q Iq. destruct (every_in _ _ _ _ _ _ E Iq) as (i & _ & Em). apply member_in in Em. auto. }
  destruct (ascending_different l p) as [N _]; auto. apply NoDup_incl_NoDup with (map at_quotient (p :: l)); auto.
  - rewrite !map_length. lia.
  - intros x Ix. apply in_map_iff in Ix. destruct Ix as (q & <- & Iq). apply in_map. auto.
Qed.

Lemma all_named_sound : forall flanks cs ends, all_named (numbered flanks) cs ends = true -> forall p, In p ends ->
  exists f, In f flanks /\ end_at f = p.
Proof.
  intros flanks. induction cs as [|c cs IH]; intros [|p ends] H q Iq; try discriminate; try contradiction.
  simpl in H. destruct (member (numbered flanks) (named_by c)) as [f|] eqn:E; [|discriminate].
  destruct (same_vector (fst (end_at f)) (fst p) && (snd (end_at f) =? snd p)%Z) eqn:S; [|discriminate].
  destruct Iq as [<-|Iq]; [|apply (IH ends); auto]. bsplit. apply same_vector_spec in H0. exists f.
  split; [apply (member_in _ _ _ _ E)|].
  destruct (end_at f), p. simpl in *. subst. auto.
Qed.

(* ---- the patch ---- *)
Theorem check_patch_sound : forall A B qn qd n p ends, (0 < qd)%Z ->
  check_patch A B (numbered (spots A)) (numbered (spots B)) qn qd n p = Some ends ->
  let s := signed_root (IZR qn / IZR qd) in
  inj n <> origin /\ beneath (zgaps A B) (inj n) (s * norm (inj n))
  /\ (forall q, In q ends -> 0 < IZR (snd q))
  /\ cornered (meeting (in_zcore A) (in_zcore B) (along (inj n) s)) (map at_quotient ends).
Proof.
  intros A B qn qd n p ends Hqd H s. unfold check_patch in H.
  destruct (outer_height A B (Heights 1 [] []) n) as [[h d]|] eqn:E0; [|discriminate].
  destruct (negb (is_zero n) && _) eqn:T; [|discriminate].
  assert (R0 : height_root A B qn qd n = true) by (unfold height_root; rewrite E0; auto).
  destruct (height_root_sound A B qn qd n Hqd R0) as (h' & d' & E & Pd & Hn & Hb & Eh). rewrite E0 in E. inversion E.
  subst h' d'. clear E T R0.
  fold s in Eh. rewrite Eh in Hb. split; auto. split; auto.
  assert (Et : along (inj n) s = scal (IZR h / IZR d / norm2 (inj n)) (inj n)).
  { unfold along. f_equal. rewrite Eh, <- norm_sqr. field. apply Rgt_not_eq, norm_pos; auto. }
  rewrite Et. set (C := meeting _ _ _). unfold ends_of in H. set (FA := face (zneg n) (spots A)) in *.
  set (FB := face n (spots B)) in *.
  destruct (every (end_of _ _ _ _ _ _ _ _ _) (patch_corners p)) as [es|] eqn:Ee; [|discriminate].
  destruct (every (flank_of _ _ _ _) (patch_sides p)) as [[|f fs]|] eqn:Ef; try discriminate.
  destruct (_ && _ && _) eqn:T in H; [|discriminate]. inversion H. subst es. clear H. bsplit.
  rename H into Turn, H1 into Name, H0 into Diff.
  assert (Ends : forall q, In q ends -> 0 < IZR (snd q) /\ C (at_quotient q)).
  { intros q Iq. destruct (every_in _ _ _ _ _ _ Ee Iq) as (c & _ & Ec). apply (end_sound A B n h d E0 Hn c q Ec). }
  split; [intros q Iq; apply Ends; auto|].
  assert (Flanks : forall g, In g (f :: fs) -> In (end_at g) ends /\ forall x, C x -> IZR (level_of g) <= dot (inj
    (normal_of g)) x).
  { intros g Ig. destruct (every_in _ _ _ _ _ _ Ef Ig) as (sd & _ & Eg).
    destruct (flank_low A B n h d E0 Hn _ _ _ Eg) as [L M].
    split; auto. apply (member_in _ _ _ _ M). }
  destruct (patch_flat A B n h d E0 Hn) as (c & Flat).
  set (side := fun g => (inj (normal_of g), at_quotient (end_at g))).
  apply (round_cornered C (inj n) c (side f) (map side fs)); auto.
  - apply (patch_convex A B n h d).
  - intros u v I0. rewrite chain_map in I0. apply in_map_iff in I0. destruct I0 as ((g & g') & Eg & I0). inversion Eg.
    subst u v. clear Eg.
    assert (Tg := along_chain_spec _ _ _ _ _ Turn _ _ I0). unfold turns in Tg. bsplit.
    rename H into D, H1 into G, H0 into G'.
    destruct (chain_members _ _ _ _ _ _ I0) as [Ig Ig'].
    assert (Ig2 : In g' (f :: fs)) by (destruct Ig' as [I1| ->]; simpl; auto).
    destruct (Flanks g Ig) as [Ie L]. destruct (Flanks g' Ig2) as [_ L']. destruct (Ends _ Ie) as [P0 Ce].
    unfold side. cbn [fst snd]. split; [rewrite <- det_inj; apply IZR_lt; auto|]. split; auto.
    split; intros x Cx; [rewrite <- (through_low g); auto|rewrite <- (through_low g'); auto].
  - intros x Ix. apply in_map_iff in Ix. destruct Ix as (q & <- & Iq).
    destruct (all_named_sound _ _ _ Name q Iq) as (g & Ig & Eg).
    exists (side g). split; [change (side f :: map side fs) with (map side (f :: fs)); apply in_map; auto|].
    unfold side. cbn [snd]. rewrite Eg. auto.
  - intros x Ix. change (side f :: map side fs) with (map side (f :: fs)) in Ix. apply in_map_iff in Ix.
    destruct Ix as (g & <- & Ig).
    unfold side. cbn [snd]. apply in_map. apply Flanks. auto.
  - apply (all_different_sound ends (ascending p)); auto. intros q Iq. apply Ends. auto.
Qed.
