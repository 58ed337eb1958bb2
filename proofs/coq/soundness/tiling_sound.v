(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Format 5: what the checker accepts is true.  An accepted piece is a convex polytope whose facets have the winding number 1 inside and 0
   outside; what the table sums to is the difference of the mesh's flags and the facets'. *)
Require Import Reals Lra Psatz List ZArith Lia Bool.
From Fathom.checker Require Import vector sequence table polytope verdict tiling.
From Fathom.geometry Require Import meaning space hulls faces flats facets norm unions meshes crossings tiles
  tiles_winding tilings mesh_said.
From Fathom.soundness Require Import statement booleans lower verdict_sound union_cuts.
Import ListNotations.
Open Scope R_scope.

(* the corners of a piece *)
Definition real_tile (points : list point) (q : tile) : list pt := map (point_at points) (tile_corners q).

(* ---- a piece around O ---- *)
Definition face_of (f : facet) : face :=
  match corners f with
  | p :: a :: r => Face (inj (normal f)) (IZR (offset f)) (inj (fst p)) (inj (fst a)) (map (fun c => inj (fst c)) r)
  | _ => Face (inj (normal f)) (IZR (offset f)) origin origin []
  end.
Lemma face_normal : forall f, normal_of (face_of f) = inj (normal f).
Proof. intros f. unfold face_of. destruct (corners f) as [|p [|a r]]; reflexivity. Qed.
Lemma face_height : forall f, height_of (face_of f) = IZR (offset f).
Proof. intros f. unfold face_of. destruct (corners f) as [|p [|a r]]; reflexivity. Qed.

Lemma same_sense_scal : forall u v s, inj u <> origin -> 0 < s -> inj v = scal s (inj u) -> same_sense u v = true /\ same_sense v u =
  true.
Proof.
  intros u v s Hu Hs E. assert (N := norm2_pos _ Hu). unfold same_sense.
  rewrite !andb_true_iff, !is_zero_spec, <- !inj_zero, !inj_cross, !Z.ltb_lt.
  assert (P0 : (0 < zdot u v)%Z) by (apply lt_IZR; rewrite dot_inj, E, dot_scal_r; apply Rmult_lt_0_compat; auto).
  assert (P1 : (0 < zdot v u)%Z) by (apply lt_IZR; rewrite dot_inj, E, dot_scal_l; apply Rmult_lt_0_compat; auto).
  repeat split; auto; rewrite E; pteq; ring.
Qed.

Lemma distinct_spec : forall l f k, distinct (l ++ f :: k) = true -> forall g, In g (l ++ k) ->
  same_sense (normal f) (normal g) = false \/ same_sense (normal g) (normal f) = false.
Proof.
  induction l as [|h l IH]; cbn [app distinct]; intros f k H g Hg; destruct (forallb _ _) eqn:E in H; try discriminate.
  - left. apply negb_true_iff. exact (forallb_In _ _ _ E g Hg).
  - destruct Hg as [<-|Hg]; [|exact (IH f k H g Hg)]. right. apply negb_true_iff. apply (forallb_In _ _ _ E f), in_app_iff. simpl. auto.
Qed.

Section Piece.
  Variables (ws : list zvec) (sides : list (list (N * N))).
  Let T := numbered ws.
  Let Fs := map (make_facet T) sides.
  Let Vs := map inj ws.
  Hypothesis Hok : inner_ok 0 1 Fs = true.
  Hypothesis Hsupport : supporting ws Fs = true.
  Hypothesis Hdistinct : distinct Fs = true.
  Let S := fun p => In p Vs.

  Lemma tile_corner_in : forall f x, In f Fs -> In x (corners f) -> fst x = zzero \/ S (inj (fst x)).
  Proof.
    intros f x Hf Hx. apply in_map_iff in Hf. destruct Hf as (l & <- & _). simpl in Hx. rewrite each_map in Hx.
    apply in_map_iff in Hx. destruct Hx as ([i o] & <- & _). cbn [fst]. destruct (member T i) as [w|] eqn:E; auto.
    right. apply member_in in E. apply in_map. auto.
  Qed.

  Lemma tile_facet_ok : forall f, In f Fs -> facet_ok 0 1 (numbered Fs) f = true.
  Proof. intros f Hf. unfold inner_ok in Hok. bsplit. exact (forallb_In _ _ _ H0 f Hf). Qed.

  Lemma under_below : forall x, under (map face_of Fs) x <-> below _ (fun f => inj (normal f)) (fun f => IZR (offset f)) Fs x.
  Proof.
    intros x. split.
    - intros H f Hf. specialize (H _ (in_map face_of _ _ Hf)). rewrite face_normal, face_height in H. exact H.
    - intros H g Hg. apply in_map_iff in Hg. destruct Hg as (f & <- & Hf). rewrite face_normal, face_height. exact (H f Hf).
  Qed.

  Lemma tile_faces : convex_faces Vs (map face_of Fs).
  Proof.
    assert (G : forall f, In f Fs -> exists p a b r, corners f = p :: a :: b :: r /\ 0 < IZR (offset f)
      /\ (forall v, In v (corners f) -> dot (inj (normal f)) (inj (fst v)) = IZR (offset f))
      /\ (forall u v, In (u, v) (pairs a (b :: r)) -> 0 < det (inj (fst p)) (inj (fst u)) (inj (fst v)))
      /\ forall u v x, In (u, v) (chain p (a :: b :: r) p) -> under (map face_of Fs) x -> dot (inj (normal f)) x = IZR (offset f) ->
           0 <= det (inj (fst u)) (inj (fst v)) x).
    { intros f Hf. destruct (facet_parts 0 1 S eq_refl Fs f (tile_facet_ok f Hf) Hf) as (p & a & b & r & E & C & _ & L & D & Q).
      exists p, a, b, r. split; auto. split; auto. split; auto. split; auto. intros u v x I U. apply Q; auto. apply under_below. auto. }
    assert (Cy : forall f q, In f Fs -> In q (cycle (face_of f)) -> exists v, In v (corners f) /\ q = inj (fst v)).
    { intros f q Hf Hq. destruct (G f Hf) as (p & a & b & r & E & _). unfold face_of in Hq. rewrite E in Hq |- *. unfold cycle in Hq.
      cbn [first_of second_of others_of] in Hq.
      destruct Hq as [<-|[<-|Hq]]; [exists p; simpl; auto|exists a; simpl; auto|]. apply in_map_iff in Hq. destruct Hq as (v & <- & Hv).
      exists v. split; auto. simpl in *. tauto. }
    split.
    - intros g Hg. apply in_map_iff in Hg. destruct Hg as (f & <- & Hf). rewrite face_height.
    destruct (G f Hf) as (p & a & b & r & _ & C & _). auto.
    - intros g q Hg Hq. apply in_map_iff in Hg. destruct Hg as (f & <- & Hf). rewrite face_height, face_normal.
      destruct (Cy f q Hf Hq) as (v & Hv & ->). destruct (G f Hf) as (p & a & b & r & _ & _ & L & _). auto.
    - intros g q Hg Hq. apply in_map_iff in Hg. destruct Hg as (f & <- & Hf). destruct (Cy f q Hf Hq) as (v & Hv & ->).
      destruct (G f Hf) as (p & a & b & r & _ & C & L & _). destruct (tile_corner_in f v Hf Hv) as [E|I]; auto. exfalso.
      specialize (L v Hv). rewrite E in L. unfold dot in L; simpl in L. lra.
    - intros q Hq g Hg. apply in_map_iff in Hg, Hq. destruct Hg as (f & <- & Hf). destruct Hq as (w & <- & Hw).
      rewrite face_height, face_normal, <- dot_inj. apply IZR_le, Z.leb_le.
      exact (forallb_In _ _ _ (forallb_In _ _ _ Hsupport f Hf) w Hw).
    - intros g u w Hg. apply in_map_iff in Hg. destruct Hg as (f & <- & Hf). destruct (G f Hf) as (p & a & b & r & E & _ & _ & D & _).
      unfold face_of. rewrite E. cbn [first_of second_of others_of]. rewrite (pairs_map _ _ (fun c : zvec * N => inj (fst c)) (b :: r) a).
      intros H. apply in_map_iff in H. destruct H as ([u' w'] & F & H). inversion F. subst. apply D. exact H.
    - intros g Hg. apply in_map_iff in Hg. destruct Hg as (f & <- & Hf). destruct (G f Hf) as (p & a & b & r & E & _).
      unfold face_of. rewrite E. discriminate.
    - intros g u w y Hg H U. apply in_map_iff in Hg. destruct Hg as (f & <- & Hf). rewrite face_height, face_normal.
      destruct (G f Hf) as (p & a & b & r & E & _ & _ & _ & Q). revert H. unfold face_of. rewrite E. cbn [first_of second_of others_of].
      change (inj (fst a) :: map (fun c : zvec * N => inj (fst c)) (b :: r)) with (map (fun c : zvec * N => inj (fst c)) (a :: b :: r)).
      rewrite (chain_map _ _ (fun c : zvec * N => inj (fst c)) (a :: b :: r) p p). intros H L. apply in_map_iff in H.
      destruct H as ([u' w'] & F & H). inversion F. subst. apply Q; auto.
    - intros l g k E h s Hh Hs N. assert (M := map_eq_app face_of Fs l (g :: k) E). destruct M as (l' & k0 & EF & El & Ek).
      destruct k0 as [|f k']; [discriminate|]. cbn [map] in Ek. inversion Ek. subst g k l. clear Ek.
      rewrite <- map_app in Hh. apply in_map_iff in Hh. destruct Hh as (f' & <- & Hf'). rewrite !face_normal in N.
      assert (Hf : In f Fs) by (rewrite EF; apply in_app_iff; simpl; auto).
      assert (Nf : inj (normal f) <> origin).
      { destruct (G f Hf) as (p & a & b & r & E0 & C & L & _). intros Z. specialize (L p). rewrite E0, Z in L.
        assert (L' := L (or_introl eq_refl)). unfold dot, origin in L'; simpl in L'. lra. }
      destruct (same_sense_scal _ _ s Nf Hs N) as [S1 S2]. rewrite EF in Hdistinct.
      destruct (distinct_spec l' f k' Hdistinct f' Hf') as [D|D]; congruence.
    - intros x U. apply (below_in_hull 0 1 S eq_refl Fs); auto; [exact tile_corner_in|]. apply under_below. auto.
  Qed.
End Piece.

(* ---- the table ---- *)
Section Table.
  Variables (common : list point -> Z) (slot : zvec -> zvec -> N -> positive) (points : list point).
  Let P := numbered points.
  Let spot := point_at points.

  Definition flag_of (e : entry) : flag := Flag (inj (entry_normal e)) (inj (entry_direction e)) (spot (entry_point e)).
  Definition worth (phi : flag -> Z) (t : table entry) : Z := table.sum_of (fun e => (entry_sum e * phi (flag_of e))%Z)
    t.
  (* t' is what is in the table before, and g *)
  Definition adds (before : option (table entry)) (t' : table entry) (g : (flag -> Z) -> Z) : Prop :=
    exists t, before = Some t /\ forall phi, of_flags phi -> worth phi t' = (worth phi t + g phi)%Z.

  Lemma adds_adds : forall before middle t' g h, (forall t, middle = Some t -> adds before t g) -> adds middle t' h ->
    adds before t' (fun phi => (g phi + h phi)%Z).
  Proof.
    intros before middle t' g h H (t & E & K). destruct (H t E) as (t0 & E0 & K0). exists t0. split; auto.
    intros phi Hp. rewrite K, K0 by auto. ring.
  Qed.
  Lemma adds_same : forall before t' g h, (forall phi, of_flags phi -> g phi = h phi) -> adds before t' g -> adds before t' h.
  Proof. intros before t' g h E (t & Et & K). exists t. split; auto. intros phi Hp. rewrite <- E by auto. auto. Qed.

  Lemma collinear_spec : forall u v, collinear u v = true -> exists k, k <> 0 /\ inj u = scal k (inj v).
  Proof.
    intros u v H. unfold collinear in H. bsplit. apply negb_true_iff in H, H1. apply is_zero_spec in H0.
    assert (Nu : inj u <> origin). { intros E. apply inj_zero, is_zero_spec in E. congruence. }
    assert (Nv : inj v <> origin). { intros E. apply inj_zero, is_zero_spec in E. congruence. }
    assert (C : cross (inj v) (inj u) = origin).
    { apply (f_equal inj) in H0. rewrite inj_cross in H0. apply (f_equal (scal (-1))) in H0.
      replace (scal (-1) (cross (inj u) (inj v))) with (cross (inj v) (inj u)) in H0 by (pteq; ring). rewrite H0. pteq; ring. }
    assert (E := parallel _ _ C Nv). eexists. split; [|exact E]. intros Z. rewrite Z in E. apply Nu. rewrite E. pteq; ring.
  Qed.

  Lemma add_flag_sound : forall c n d i before t', add_flag slot c n d i before = Some t' ->
    adds before t' (fun phi => (c * phi (Flag (inj n) (inj d) (spot i)))%Z).
  Proof.
    intros c n d i before t' H. unfold add_flag in H. destruct before as [t|]; [|discriminate]. exists t. split; auto. intros phi Hp.
    destruct (get (slot n d i) t) as [e|] eqn:E.
    - destruct (_ && _)%bool eqn:B in H; [|discriminate]. inversion H. subst t'. rewrite !andb_true_iff in B.
    destruct B as [[B1 B2] B3]. apply N.eqb_eq in B3. subst i.
      unfold worth. rewrite sum_put, E. cbn [entry_sum flag_of entry_normal entry_direction entry_point].
      apply collinear_spec in B1, B2. replace (phi (Flag (inj n) (inj d) (spot (entry_point e)))) with (phi (flag_of e)).
      + unfold flag_of. cbn [entry_sum entry_normal entry_direction entry_point]. ring.
      + symmetry. apply Hp. unfold alike, flag_of; simpl. auto.
    - destruct (_ && _)%bool in H; [|discriminate]. inversion H. subst t'. unfold worth. rewrite sum_put, E.
      unfold flag_of. cbn [entry_sum entry_normal entry_direction entry_point]. ring.
  Qed.

  Lemma add_edge_sound : forall c n u v before t' k l, add_edge slot c n u v before = Some t' -> k <> 0 -> l <> 0 ->
    sub (spot (fst v)) (spot (fst u)) = scal l (inj (zsub (snd v) (snd u))) ->
    adds before t' (fun phi => (c * edge_sum phi (scal k (inj n)) (spot (fst u)) (spot (fst v)))%Z).
  Proof.
    intros c n u v before t' k l H Hk Hl E. unfold add_edge in H. cbv zeta in H.
    assert (A := adds_adds _ _ _ _ _ (fun t Ht => add_flag_sound _ _ _ _ _ t Ht) (add_flag_sound _ _ _ _ _ _ H)).
    refine (adds_same _ _ _ _ _ A). intros phi Hp. cbv beta.
    rewrite <- (edge_sum_alike phi Hp (inj n) k (inj (zsub (snd v) (snd u))) l); auto. ring.
  Qed.

  Lemma spot_real : forall i p, member P i = Some p -> spot i = real p.
  Proof.
    intros i p H. unfold P in H. rewrite member_nth in H. unfold spot, point_at. apply nth_error_nth.
      apply map_nth_error. exact H.
  Qed.
  Lemma real_integral : forall m p, (0 < m)%Z -> fits m p = true -> real p = scal (/ IZR m) (inj (integral m p)).
  Proof.
    intros m p Hm H. assert (E := integral_real m [p] Hm). rewrite each_map in E. cbn [map forallb] in E. rewrite H in E.
    specialize (E eq_refl).
    assert (E' : frac m (integral m p) = real p) by congruence. rewrite <- E'. unfold frac. pteq; unfold Rdiv; ring.
  Qed.

  Lemma add_triangle_sound : forall before ijk t', add_triangle common slot P before ijk = Some t' ->
    adds before t' (fun phi => triangle_sum phi (real_triangle points ijk)).
  Proof.
    intros before [[i j] k] t' H. unfold add_triangle in H.
    destruct (member P i) as [p|] eqn:Ep; [|discriminate]. destruct (member P j) as [q|] eqn:Eq; [|discriminate].
    destruct (member P k) as [r|] eqn:Er; [|discriminate]. cbv zeta in H. set (m := common [p; q; r]) in *.
    destruct (_ && _)%bool eqn:B in H; [|discriminate]. rewrite !andb_true_iff in B. destruct B as [[[Hm F1] F2] F3].
    apply Z.ltb_lt in Hm.
    apply spot_real in Ep, Eq, Er. rewrite (real_integral m) in Ep, Eq, Er by auto.
    set (u := integral m p) in *. set (v := integral m q) in *. set (w := integral m r) in *. cbn [snd] in H.
    assert (Rm : 0 < IZR m) by (apply IZR_lt; auto). assert (Ri : 0 < / IZR m) by (apply Rinv_0_lt_compat; auto).
    set (n := zcross (zsub v u) (zsub w u)) in *.
    assert (En : front (real_triangle points (i, j, k)) = scal (/ IZR m * / IZR m) (inj n)).
    { unfold front, real_triangle. cbn [fst snd corner_1 corner_2 corner_3]. fold spot. rewrite Ep, Eq, Er. unfold n.
      rewrite inj_cross, !inj_sub. pteq; ring. }
    assert (K0 : / IZR m * / IZR m <> 0) by (assert (0 < / IZR m * / IZR m) by (apply Rmult_lt_0_compat; auto); lra).
    assert (L0 : / IZR m <> 0) by lra.
    assert (D : forall a b x y, spot a = scal (/ IZR m) (inj x) -> spot b = scal (/ IZR m) (inj y) ->
      sub (spot b) (spot a) = scal (/ IZR m) (inj (zsub y x))) by (intros a b x y -> ->; rewrite inj_sub; pteq; ring).
    destruct (is_zero n) eqn:Z.
    { apply is_zero_spec in Z. exists t'. split; auto. intros phi _. rewrite sum_flat; [ring|]. rewrite En, Z. pteq; ring. }
    assert (Nn : front (real_triangle points (i, j, k)) <> origin).
    { rewrite En. intros E. apply (f_equal (scal (IZR m * IZR m))) in E. rewrite scal_scal in E.
      replace (IZR m * IZR m * (/ IZR m * / IZR m)) with 1 in E by (field; lra). rewrite scal_1 in E.
      assert (En0 : inj n = origin) by (rewrite E; pteq; ring). apply inj_zero, is_zero_spec in En0. congruence. }
    assert (A1 := fun b t Ht => add_edge_sound 1 n (k, w) (i, u) b t _ _ Ht K0 L0 (D k i w u Er Ep)).
    assert (A2 := fun b t Ht => add_edge_sound 1 n (j, v) (k, w) b t _ _ Ht K0 L0 (D j k v w Eq Er)).
    assert (A3 := fun b t Ht => add_edge_sound 1 n (i, u) (j, v) b t _ _ Ht K0 L0 (D i j u v Ep Eq)).
    assert (A := adds_adds _ _ _ _ _ (fun t Ht => adds_adds _ _ _ _ _ (fun t0 Ht0 => A1 _ t0 Ht0) (A2 _ t Ht)) (A3 _ _ H)).
    refine (adds_same _ _ _ _ _ A). intros phi Hp. cbv beta. unfold triangle_sum. cbv zeta.
    destruct (pt_dec _ _) as [E|_]; [contradiction|]. rewrite En.
    unfold real_triangle. cbn [fst snd corner_1 corner_2 corner_3]. fold spot. ring.
  Qed.

  Lemma adds_fold : forall (X : Type) (step : option (table entry) -> X -> option (table entry)) (g : X -> (flag -> Z) -> Z) l,
    (forall before x t', In x l -> step before x = Some t' -> adds before t' (g x)) ->
    forall before t', fold_left step l before = Some t' -> adds before t' (fun phi => total (fun x => g x phi) l).
  Proof.
    intros X step g. induction l as [|x l IH]; intros H before t' E; cbn [fold_left] in E.
    - exists t'. split; auto. intros phi _. simpl. ring.
    - apply IH in E; [|intros; apply H; simpl; auto].
      exact (adds_adds _ _ _ _ _ (fun t Ht => H before x t (or_introl eq_refl) Ht) E).
  Qed.

  Lemma fold_chain_fold : forall (X Y : Type) (f : Y -> X -> X -> Y) l acc a z,
    fold_chain f acc a l z = fold_left (fun acc e => f acc (fst e) (snd e)) (chain a l z) acc.
  Proof. intros X Y f. induction l as [|b l IH]; intros acc a z; simpl; auto. Qed.

  (* ---- an accepted piece ---- *)
  Record tile_facts (L : list pt) (N : list triangle) : Prop := Tile_facts {
    tile_winding : forall x v, general N x v -> (conv L x /\ winding N x v = 1%Z) \/ (~ conv L x /\ winding N x v = 0%Z);
    tile_solid : exists p, interior (conv L) p;
    tile_closed : forall x, conv L x \/ exists e, 0 < e /\ forall y, norm2 (sub y x) < e * e -> ~ conv L y }.

  Section Moved_piece.
    Variables (Vs L : list pt) (Fs : list face) (k : R) (s : pt).
    Hypothesis Hk : 0 < k.
    Hypothesis HF : convex_faces Vs Fs.
    Hypothesis HVL : forall p, In p Vs -> In (moved k s p) L.
    Hypothesis HLV : forall p, In p L -> In (sub (scal k p) s) Vs.
    Let Pk : 0 < / k := Rinv_0_lt_compat k Hk.

    Lemma conv_moved : forall x, conv L x <-> conv Vs (sub (scal k x) s).
    Proof.
      intros x. split; intros H.
      - replace (sub (scal k x) s) with (scal (/ / k) (add x (scal (- / k) s))) by (pteq; field; lra).
        apply (moved_hull (fun p => In p L) (fun p => In p Vs) (/ k) (scal (- / k) s) x); [lra| |exact H]. intros p Hp.
        replace (scal (/ / k) (add p (scal (- / k) s))) with (sub (scal k p) s) by (pteq; field; lra). auto.
      - replace x with (scal (/ k) (add (sub (scal k x) s) s)) by (pteq; field; lra).
        apply (moved_hull (fun p => In p Vs) (fun p => In p L) k s (sub (scal k x) s)); [lra|exact HVL|exact H].
    Qed.

    Lemma moved_facts : tile_facts L (map (moved_triangle k s) (fans Fs)).
    Proof.
      split.
      - intros x v G. rewrite <- (moved_back k s Hk x) in G at 1. apply moved_general in G; auto.
        rewrite <- (moved_back k s Hk x) at 2 4. rewrite !moved_winding, conv_moved by auto. apply (piece_winding Vs Fs HF). exact G.
      - destruct (piece_solid Vs Fs HF) as (p & Hp). exists (moved k s p).
        apply (moved_interior (fun p => In p Vs) (fun p => In p L) k s); auto.
        replace (sub (scal k (moved k s p)) s) with p by (unfold moved; pteq; field; lra). exact Hp.
      - intros x. destruct (piece_closed Vs Fs HF (sub (scal k x) s)) as [C|(e & He & G)]; [left; exact (proj2 (conv_moved x) C)|right].
        exists (e / k). split; [apply Rdiv_lt_0_compat; auto|]. intros y Hy C.
        refine (G (sub (scal k y) s) _ (proj1 (conv_moved y) C)).
        replace (sub (sub (scal k y) s) (sub (scal k x) s)) with (scal k (sub y x)) by (pteq; ring). rewrite norm2_scal.
        replace (e * e) with (k * k * (e / k * (e / k))) by (field; lra). apply Rmult_lt_compat_l; auto. apply Rmult_lt_0_compat; auto.
    Qed.
  End Moved_piece.

  (* the sides of a piece: each takes away what its fan has *)
  Section Sides.
    Variables (ws : list (N * zvec)) (k : R) (s : pt).
    Hypothesis Hk : 0 < k.
    Hypothesis Hws : forall iw, In iw ws -> spot (fst iw) = moved k s (inj (snd iw)).
    Let T := numbered (map snd ws).
    Let look (u : N * N) := match member T (fst u) with Some v => v | None => zzero end.
    Let at_ (u : N * N) := moved k s (inj (look u)).

    Lemma add_side_sound : forall n u r before t' h, h <> 0 -> add_side slot (numbered ws) n (u :: r) before = Some t' ->
      adds before t' (fun phi => (- total (fun e => edge_sum phi (scal h (inj n)) (at_ (fst e)) (at_ (snd e))) (chain u r u))%Z).
    Proof.
      intros n u r before t' h Hh H. unfold add_side in H. rewrite fold_chain_fold in H.
      assert (A := adds_fold (N * N * (N * N))
        (fun t e => match member (numbered ws) (fst (fst e)), member (numbered ws) (fst (snd e)) with
                    | Some p, Some q => add_edge slot (-1) n p q t | _, _ => None end)
        (fun e phi => (- edge_sum phi (scal h (inj n)) (at_ (fst e)) (at_ (snd e)))%Z) (chain u r u)).
      eapply adds_same; [|apply A; [|exact H]].
      - intros phi _. cbv beta. clear. induction (chain u r u) as [|e l IH]; [reflexivity|]. cbn [total fold_right].
      unfold total in IH. rewrite IH. ring.
      - clear A. intros b [v w] t Hin E. cbn [fst snd] in *. destruct (member (numbered ws) (fst v)) as [p|] eqn:Ep; [|discriminate].
        destruct (member (numbered ws) (fst w)) as [q|] eqn:Eq; [|discriminate].
        assert (Lp : look v = snd p) by (unfold look, T; rewrite member_map, Ep; reflexivity).
        assert (Lq : look w = snd q) by (unfold look, T; rewrite member_map, Eq; reflexivity).
        apply member_in, Hws in Ep, Eq. unfold at_. rewrite Lp, Lq, <- Ep, <- Eq.
        assert (Nk : / k <> 0) by (apply Rinv_neq_0_compat; lra).
        assert (D : sub (spot (fst q)) (spot (fst p)) = scal (/ k) (inj (zsub (snd q) (snd p)))).
        { rewrite Ep, Eq, inj_sub. unfold moved. pteq; ring. }
        eapply adds_same; [|exact (add_edge_sound (-1) n p q b t h (/ k) E Hh Nk D)]. intros phi _. cbv beta. ring.
    Qed.

    Variable sides : list (list (N * N)).
    Let Fs := map (make_facet T) sides.
    Hypothesis HF : convex_faces (map inj (map snd ws)) (map face_of Fs).
    Hypothesis Hok : inner_ok 0 1 Fs = true.

    Lemma side_sum : forall side before t', In side sides -> add_side slot (numbered ws) (normal (make_facet T side)) side before =
      Some t' ->
      adds before t' (fun phi => (- total (triangle_sum phi) (map (moved_triangle k s) (fan_of (face_of (make_facet T side)))))%Z).
    Proof.
      intros side before t' Hs H. set (f := make_facet T side) in *. assert (Hf : In f Fs) by (apply in_map; auto).
      destruct (facet_parts 0 1 (fun _ => True) eq_refl Fs f (tile_facet_ok _ _ Hok f Hf) Hf) as (p0 & a0 & b0 & r0 & E & C & _ & L & D
        & _).
      assert (Ec : corners f = map (fun vg => (look vg, snd vg)) side) by (unfold f, make_facet; simpl; apply each_map).
      rewrite Ec in E. destruct side as [|p [|a [|b r]]]; try discriminate.
      assert (Nn : inj (normal f) <> origin).
      { intros Z. assert (L' := L (look p, snd p)). rewrite Ec, Z, dot_comm, dot_origin_r in L'. specialize (L' (or_introl eq_refl)).
      lra. }
      assert (Eq : fan_of (face_of f) = map (fun e => Triangle (inj (look p)) (inj (look (fst e))) (inj (look (snd e)))) (pairs a (b ::
        r))).
      { unfold face_of. rewrite Ec. cbn [map]. unfold fan_of. cbn [first_of second_of others_of fst].
        change (inj (look b) :: map (fun c => inj (fst c)) (map (fun vg => (look vg, snd vg)) r))
          with (map (fun c : zvec * N => inj (fst c)) (map (fun vg => (look vg, snd vg)) (b :: r))).
        rewrite map_map. cbn [fst]. rewrite (pairs_map _ _ (fun u => inj (look u)) (b :: r) a), map_map. reflexivity. }
      eapply adds_same; [|exact (add_side_sound _ _ _ _ _ 1 R1_neq_R0 H)]. intros phi Hp. cbv beta. f_equal. rewrite scal_1.
      rewrite Eq, map_map. symmetry.
      assert (FS := fan_sum phi Hp (inj (normal f)) (at_ p) (map at_ (b :: r)) (at_ a) Nn).
      rewrite (pairs_map _ _ at_ (b :: r) a), map_map in FS. cbn [fst snd] in FS.
      change (at_ a :: map at_ (b :: r)) with (map at_ (a :: b :: r)) in FS.
      rewrite (chain_map _ _ at_ (a :: b :: r) p p), !total_map in FS. rewrite total_map. cbn [fst snd] in FS. apply FS. clear FS.
      intros u w I. apply in_map_iff in I. destruct I as ([u' w'] & F & I). inversion F. subst u w.
      assert (If : In (face_of f) (map face_of Fs)) by (apply in_map; auto).
      assert (Es : first_of (face_of f) = inj (look p) /\ second_of (face_of f) = inj (look a)
        /\ others_of (face_of f) = map (fun u => inj (look u)) (b :: r)).
      { unfold face_of. rewrite Ec. cbn [map first_of second_of others_of fst]. rewrite map_map. auto. }
      destruct Es as (E1 & E2 & E3).
      assert (Ip : In (inj (look u'), inj (look w')) (pairs (second_of (face_of f)) (others_of (face_of f)))).
      { rewrite E2, E3, (pairs_map _ _ (fun u => inj (look u)) (b :: r) a). apply in_map_iff. exists (u', w'). auto. }
      assert (FF := face_front _ _ HF _ _ _ If Ip). assert (St := faces_strict _ _ HF _ _ _ If Ip). rewrite E1 in FF, St.
      rewrite face_normal, face_height in FF. set (d := det _ _ _) in *.
      exists (/ k * / k * (d / IZR (offset f))). assert (Pk : 0 < / k) by (apply Rinv_0_lt_compat; auto).
      assert (Pd : 0 < d / IZR (offset f)) by (apply Rdiv_lt_0_compat; auto). split.
      - assert (0 < / k * / k * (d / IZR (offset f))); [|lra]. apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat|]; auto.
      - rewrite <- scal_scal, <- FF, <- (moved_front k s). reflexivity.
    Qed.
  End Sides.

  Lemma numbered_points : forall is ps, every (numbered_point P) is = Some ps ->
    map fst ps = is /\ forall ip, In ip ps -> spot (fst ip) = real (snd ip).
  Proof.
    intros is ps H. apply every_spec in H. induction H as [|i [j p] is ps E _ [IH1 IH2]]; [simpl; tauto|].
    unfold numbered_point in E. destruct (member P i) as [p'|] eqn:M; [|discriminate]. inversion E. subst j p'. split.
    - cbn [map fst]. rewrite IH1. reflexivity.
    - intros ip [<-|I]; auto. cbn [fst snd]. apply spot_real. exact M.
  Qed.

  Lemma add_tile_sound : forall before q t', add_tile common slot P before q = Some t' ->
    exists N, tile_facts (real_tile points q) N /\ adds before t' (fun phi => (- total (triangle_sum phi) N)%Z).
  Proof.
    intros before q t' H. unfold add_tile in H. destruct (every (numbered_point P) (tile_corners q)) as [ps|] eqn:E; [|discriminate].
    apply numbered_points in E. destruct E as [Ec Ep]. cbv zeta in H. set (m := common (each snd ps)) in *.
    destruct (_ && _)%bool eqn:B in H; [|discriminate]. apply andb_true_iff in B. destruct B as [Hm Hf]. apply Z.ltb_lt in Hm.
    set (ws := centred m ps) in *. destruct (tile_ok ws _) eqn:B in H; [|discriminate]. unfold tile_ok, tile_facets in B, H.
    rewrite !each_map in B, H. rewrite map_map in B. cbn [snd] in B. rewrite ?(each_map _ _ snd ws) in B.
    rewrite !andb_true_iff in B. destruct B as [[[Hc Hi] Hs] Hd]. apply Z.ltb_lt in Hc.
    set (T := numbered (map snd ws)) in *. change (fun x => make_facet T x) with (make_facet T) in *.
    unfold centred in ws. set (vs := each (fun ip => integral m (snd ip)) ps) in *. set (k := count vs) in *.
    set (s := fold_left zadd vs zzero) in *.
    assert (Ek : count ws = k).
    { unfold k, vs, ws. rewrite !each_map, !count_length, !map_length. reflexivity. }
    rewrite Ek in Hc. assert (Rm : 0 < IZR m) by (apply IZR_lt; auto). assert (Rk : 0 < IZR k) by (apply IZR_lt; auto).
    assert (HK : 0 < IZR k * IZR m) by (apply Rmult_lt_0_compat; auto).
    assert (Hpt : forall ip, In ip ps -> spot (fst ip) = moved (IZR k * IZR m) (inj s) (inj (zsub (zscal k (integral m (snd ip))) s))).
    { intros ip I. rewrite Ep by auto. rewrite (real_integral m _ Hm (forallb_In _ _ _ Hf ip I)). unfold moved.
      rewrite inj_sub, inj_scal. pteq; field; lra. }
    assert (Hws : forall iw, In iw ws -> spot (fst iw) = moved (IZR k * IZR m) (inj s) (inj (snd iw))).
    { intros iw I. unfold ws in I. rewrite each_map in I. apply in_map_iff in I. destruct I as (ip & <- & I). cbn [fst snd]. auto. }
    assert (HF := tile_faces (map snd ws) (tile_sides q) Hi Hs Hd). fold T in HF.
    exists (map (moved_triangle (IZR k * IZR m) (inj s)) (fans (map face_of (map (make_facet T) (tile_sides q))))). split.
    - apply (moved_facts (map inj (map snd ws))); auto.
      + intros p I. apply in_map_iff in I. destruct I as (w & <- & I). apply in_map_iff in I. destruct I as (iw & <- & I).
        rewrite <- Hws by auto. unfold real_tile. rewrite <- Ec, map_map. unfold ws in I. rewrite each_map in I. apply in_map_iff in I.
        destruct I as (ip & <- & I). cbn [fst]. apply (in_map (fun x => point_at points (fst x)) ps ip I).
      + intros p I. unfold real_tile in I. rewrite <- Ec, map_map in I. apply in_map_iff in I. destruct I as (ip & <- & I).
        fold (spot (fst ip)). rewrite Hpt by auto. apply in_map_iff. exists (zsub (zscal k (integral m (snd ip))) s). split.
        * unfold moved. pteq; field; lra.
        * unfold ws. rewrite each_map, map_map. cbn [snd]. apply (in_map (fun x => zsub (zscal k (integral m (snd x))) s) ps ip I).
    - eapply adds_same; [|refine (adds_fold _ _ (fun lf phi => (- total (triangle_sum phi)
        (map (moved_triangle (IZR k * IZR m) (inj s)) (fan_of (face_of (snd lf)))))%Z) _ _ before t' H)].
      + intros phi _. cbv beta. unfold fans. rewrite concat_map, total_concat, !map_map, !total_map. cbn [snd]. clear.
        induction (tile_sides q) as [|side l IH]; [reflexivity|]. cbn [total fold_right]. unfold total in IH at 1 3. rewrite IH. ring.
      + intros b lf t I Hl. apply in_map_iff in I. destruct I as (side & <- & I). cbn [fst snd] in *.
        exact (side_sum ws _ _ HK Hws (tile_sides q) HF Hi side b t I Hl).
  Qed.

  Lemma add_tiles_sound : forall tiles before t', fold_left (add_tile common slot P) tiles before = Some t' ->
    exists Ns, Forall2 tile_facts (map (real_tile points) tiles) Ns
      /\ adds before t' (fun phi => (- total (triangle_sum phi) (concat Ns))%Z).
  Proof.
    induction tiles as [|q tiles IH]; intros before t' H; cbn [fold_left] in H.
    - exists []. split; [constructor|]. exists t'. split; auto. intros phi _. simpl. ring.
    - destruct (IH _ _ H) as (Ns & F & (t & E & K)). destruct (add_tile_sound before q t E) as (N & FN & A). exists (N :: Ns). split.
      + constructor; auto.
      + destruct A as (t0 & E0 & K0). exists t0. split; auto. intros phi Hp. rewrite K, K0 by auto. cbn [concat]. rewrite total_app. ring.
  Qed.
End Table.

Lemma counted_pieces : forall Ls Ns, Forall2 tile_facts Ls Ns -> forall x v, general (concat Ns) x v -> held_by Ls x (winding (concat
  Ns) x v).
Proof.
  intros Ls Ns H x v. induction H as [|L N Ls Ns F _ IH]; intros G; [reflexivity|]. cbn [concat held_by] in *.
  assert (G1 : general N x v) by (intros T HT; apply G, in_app_iff; auto).
  assert (G2 : general (concat Ns) x v) by (intros T HT; apply G, in_app_iff; auto). specialize (IH G2).
  unfold winding in *. rewrite total_app. destruct (tile_winding _ _ F x v G1) as [[C W]|[C W]]; unfold winding in W; rewrite W.
  - left. split; auto. replace (1 + _ - 1)%Z with (total (crossing x v) (concat Ns)) by ring. auto.
  - right. split; auto.
Qed.

Theorem tiling_verdict_tiled : forall common slot points mesh tiles s,
  tiling_verdict common slot points mesh tiles = Some s ->
  tiled (map (real_triangle points) mesh) (map (real_tile points) tiles)
  /\ says_tiling (map (real_triangle points) mesh) (map (real_tile points) tiles) s.
Proof.
  intros common slot points mesh tiles s H. unfold tiling_verdict, sums in H. destruct tiles as [|q0 tiles0] eqn:Et; [discriminate|].
  rewrite <- Et in *. assert (Ne : tiles <> []) by (rewrite Et; discriminate). clear Et q0 tiles0. cbv zeta in H.
  destruct (fold_left _ tiles _) as [t|] eqn:E; [|discriminate]. destruct (all_entries _ t) eqn:Z; [|discriminate].
  inversion H. subst s. clear H. unfold says_tiling. cbn [triangles_told pieces_told].
    rewrite !count_length, !map_length.
  apply add_tiles_sound in E. destruct E as (Ns & F & (t1 & E1 & K1)).
  assert (A := adds_fold points _ (add_triangle common slot (numbered points)) (fun ijk phi => triangle_sum phi (real_triangle points
    ijk)) mesh
    (fun b ijk t0 _ => add_triangle_sound common slot points b ijk t0) (Some Empty) t1 E1).
  destruct A as (t0 & E0 & K0). inversion E0. subst t0.
  assert (S : forall phi, of_flags phi -> total (triangle_sum phi) (map (real_triangle points) mesh) = total (triangle_sum phi) (concat
    Ns)).
  { intros phi Hp. assert (W : worth points phi t = 0%Z).
    { apply (sum_zero _ _ _ _ Z). intros e He. apply Z.eqb_eq in He. rewrite He. ring. }
    rewrite K1, K0 in W by auto. rewrite total_map. change (worth points phi Empty) with 0%Z in W.
      unfold numbers_of_triangle in W. cbv beta in W. lia. }
  set (Ls := map (real_tile points) tiles) in *.
  assert (FL : forall L, In L Ls -> exists N, tile_facts L N).
  { clear - F. induction F as [|L N Ls Ns FN _ IH]; [intros L []|]. intros L' [<-|HL]; eauto. }
  assert (T : tiled (map (real_triangle points) mesh) Ls).
  { apply (tiling _ (concat Ns)).
    - intros x v GM GN. rewrite (same_flags_same_winding _ _ S x v GM GN). apply counted_pieces; auto.
    - intros L x HL. destruct (FL L HL) as (N & FN). apply FN.
    - intros L HL. destruct (FL L HL) as (N & FN). apply FN. }
  split; auto. split; auto. split; auto. split; [split|apply tiled_said; exact T].
  - unfold Ls. destruct tiles; [congruence|discriminate].
  - intros L HL. destruct (FL L HL) as (N & FN). apply FN.
Qed.

Theorem tiling_verdict_sound : forall common slot points mesh tiles s,
  tiling_verdict common slot points mesh tiles = Some s ->
  says_tiling (map (real_triangle points) mesh) (map (real_tile points) tiles) s.
Proof. intros common slot points mesh tiles s H. apply (tiling_verdict_tiled common slot). exact H. Qed.
