(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The winding number of a convex polytope's facets is 1 inside and 0 outside. *)
Require Import Reals Lra Psatz List ZArith Lia.
From Fathom.checker Require Import sequence.
From Fathom.geometry Require Import meaning space hulls faces flats facets difference meshes crossings tiles.
Import ListNotations.
Open Scope R_scope.

Section Piece.
  Variables (Vs : list pt) (Fs : list face).
  Hypothesis Hfaces : convex_faces Vs Fs.
  Let raised := faces_raised Vs Fs Hfaces.
  Let level := faces_level Vs Fs Hfaces.
  Let strict := faces_strict Vs Fs Hfaces.
  Let proper := faces_proper Vs Fs Hfaces.
  Let alone := hit_alone Vs Fs Hfaces.
  Let passing := facet_passes Vs Fs Hfaces.
  Let filled := faces_filled Vs Fs Hfaces.

  Lemma under_conv : forall x, conv Vs x -> under Fs x.
  Proof.
    intros x Hx f Hf. apply (hull_halfspace (fun p => In p Vs)); auto. intros p Hp. exact (faces_support Vs Fs Hfaces p Hp f Hf).
  Qed.

  (* ---- all facets and a ray ---- *)
  Definition face_crossing (x v : pt) (f : face) : Z := (ahead x v (normal_of f) (first_of f) * total (passes x v) (fan_of f))%Z.

  (* all triangles of a fan look the same way *)
  Lemma face_front : forall f u w, In f Fs -> In (u, w) (pairs (second_of f) (others_of f)) ->
    front (Triangle (first_of f) u w) = scal (det (first_of f) u w / height_of f) (normal_of f).
  Proof.
    intros f u w Hf H. assert (D := strict f u w Hf H). destruct (pair_in_cycle f u w H) as [Hu Hw]. assert (C := raised f Hf).
    set (T := Triangle (first_of f) u w). destruct (front_level T) as (E1 & E2 & E3). cbn [corner_1 corner_2 corner_3 T] in *.
    assert (Eh : dot (front T) (first_of f) = det (first_of f) u w) by (unfold T, front, det, dot, cross; simpl; ring).
    apply dot_ext. intros z. assert (K := same_form (front T) (det (first_of f) u w) (normal_of f) (height_of f) (first_of f) u w z).
    rewrite dot_scal_l. apply Rmult_eq_reg_l with (height_of f); [|lra]. rewrite K; auto; try lra; try (apply level; simpl; auto).
    field. lra.
  Qed.

  Lemma crossing_face : forall x v f, In f Fs -> total (crossing x v) (fan_of f) = face_crossing x v f.
  Proof.
    intros x v f Hf. unfold face_crossing.
    assert (G : forall T, In T (fan_of f) -> crossing x v T = (ahead x v (normal_of f) (first_of f) * passes x v T)%Z).
    { intros T HT. apply in_map_iff in HT. destruct HT as ([u w] & <- & H). cbn [fst snd]. unfold crossing, ahead. f_equal.
      cbn [corner_1]. rewrite (face_front f u w Hf H), !dot_scal_l. set (k := det (first_of f) u w / height_of f).
      assert (Pk : 0 < k) by (apply Rdiv_lt_0_compat; auto). set (a := dot _ (sub _ _)). set (b := dot _ v).
      replace (k * a * (k * b)) with (k * k * (a * b)) by ring. apply unit_step_times. apply Rmult_lt_0_compat; auto. }
    revert G. induction (fan_of f) as [|T l IH]; intros G; [simpl; lia|]. cbn [total fold_right].
    unfold total in IH. rewrite IH by (intros; apply G; simpl; auto). rewrite (G T) by (simpl; auto). ring.
  Qed.

  Lemma winding_faces : forall x v, winding (fans Fs) x v = total (face_crossing x v) Fs.
  Proof. intros x v. unfold winding, fans. rewrite total_concat, total_map. apply total_ext. intros f Hf. apply crossing_face. auto. Qed.

  Definition strictly (x : pt) : Prop := forall f, In f Fs -> dot (normal_of f) x < height_of f.
  Definition line_clear (x v : pt) : Prop := forall f T, In f Fs -> In T (fan_of f) -> threads x v T.

  Lemma some_ahead : forall x v, under Fs x -> v <> origin -> exists f, In f Fs /\ 0 < dot (normal_of f) v.
  Proof.
    intros x v Hx Hv. destruct (ray _ normal_of height_of Fs x v Hx) as [A|(s & _ & _ & f & Hf & P0 & _)]; [|eauto]. exfalso.
    assert (N := norm2_pos v Hv). assert (V : Vs <> []).
    { intros E. assert (C := filled x Hx). rewrite E in C. apply (C (fun _ => False)); [intros a b l _ []|simpl; tauto]. }
    destruct (greatest_exists (fun p => dot v p) Vs V) as (m & _ & M).
    set (s := (dot v m - dot v x) / norm2 v + 1).
    assert (U : forall s, 0 <= s -> dot v (add x (scal s v)) <= dot v m).
    { intros t Ht. apply (hull_halfspace (fun p => In p Vs)); auto. apply filled. intros f Hf.
      rewrite dot_add_r, dot_scal_r. specialize (A f Hf). specialize (Hx f Hf). nra. }
    assert (0 <= dot v m - dot v x). { assert (U0 := U 0 (Rle_refl 0)). rewrite dot_add_r, dot_scal_r in U0. lra. }
    assert (0 <= (dot v m - dot v x) / norm2 v) by (apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat; auto]).
    assert (S0 : 0 <= s) by (unfold s; lra). specialize (U s S0). rewrite dot_add_r, dot_scal_r in U.
    change (dot v v) with (norm2 v) in U.
    assert (E : s * norm2 v = dot v m - dot v x + norm2 v) by (unfold s; field; lra). rewrite E in U. lra.
  Qed.

  (* inside, there is one way out *)
  Lemma inside_once : forall x v, strictly x -> v <> origin -> line_clear x v -> total (face_crossing x v) Fs = 1%Z.
  Proof.
    intros x v Hx Hv Hl. assert (Ux : under Fs x) by (intros f Hf; specialize (Hx f Hf); lra).
    destruct (some_ahead x v Ux Hv) as (f0 & Hf0 & P0).
    destruct (ray _ normal_of height_of Fs x v Ux) as [A|(s & S0 & U & f & Hf & Pv & E)]; [specialize (A f0 Hf0); lra|].
    assert (Es : hit x v f = add x (scal s v)).
    { unfold hit. f_equal. f_equal. rewrite dot_add_r, dot_scal_r in E. rewrite dot_sub_r, (level f (first_of f)) by (simpl; auto).
      rewrite <- E. field. lra. }
    assert (I : total (passes x v) (fan_of f) = 1%Z). { apply (facet_inside Vs Fs Hfaces); auto; [intros T; apply Hl; auto|].
    rewrite Es. exact U. }
    destruct (in_split f Fs Hf) as (l & k & EF). assert (N : total (passes x v) (fan_of f) <> 0%Z) by lia.
    assert (Al := alone x v l f k EF (fun T => Hl f T Hf) N).
    assert (F1 : face_crossing x v f = 1%Z).
    { unfold face_crossing, ahead. rewrite I, unit_step_yes; [reflexivity|]. rewrite dot_sub_r, (level f (first_of f)) by (simpl; auto).
      specialize (Hx f Hf). apply Rmult_lt_0_compat; lra. }
    assert (O : forall g, In g (l ++ k) -> face_crossing x v g = 0%Z).
    { intros g Ig. assert (Hg : In g Fs). { rewrite EF. apply in_app_iff in Ig. apply in_app_iff. simpl. tauto. }
      unfold face_crossing. destruct (Z.eq_dec (total (passes x v) (fan_of g)) 0) as [Z|Z]; [rewrite Z; lia|].
      destruct (passing x v g Hg (fun T => Hl g T Hg) Z) as (Gv & Gu & _).
      unfold ahead. rewrite unit_step_no; [reflexivity|]. rewrite dot_sub_r, (level g (first_of g)) by (simpl; auto).
      specialize (Hx g Hg). destruct (Rlt_dec 0 (dot (normal_of g) v)) as [L|L].
      2: { assert (0 <= (height_of g - dot (normal_of g) x) * - dot (normal_of g) v) by (apply Rmult_le_pos; lra). lra. }
      exfalso.
      specialize (Al g Ig). rewrite Es, dot_add_r, dot_scal_r in Al.
      set (t := dot (normal_of g) (sub (first_of g) x) / dot (normal_of g) v).
      assert (Et : dot (normal_of g) x + t * dot (normal_of g) v = height_of g).
      { unfold t. rewrite dot_sub_r, (level g (first_of g)) by (simpl; auto). field. lra. }
      assert (s < t) by nra. specialize (Gu f Hf). unfold hit in Gu. fold t in Gu. rewrite dot_add_r, dot_scal_r in E, Gu. nra. }
    rewrite EF, total_app. cbn [total fold_right]. change (fold_right _ 0%Z k) with (total (face_crossing x v) k).
    rewrite F1, !total_zero; [reflexivity| |]; intros g Ig; apply O, in_app_iff; auto.
  Qed.

  Lemma in_parts : forall (l : list face) f k, Fs = l ++ f :: k -> forall g, In g Fs -> g = f \/ In g (l ++ k).
  Proof. intros l f k -> g H. apply in_app_iff in H. simpl in H. destruct H as [H|[H|H]]; auto; right; apply in_app_iff; auto. Qed.

  Lemma passes_of_z : forall x v s f, total (passes (add x (scal s v)) v) (fan_of f) = total (passes x v) (fan_of f).
  Proof. intros x v s f. apply total_ext. intros T _. apply passes_along. Qed.
  Lemma clear_along : forall x v s, line_clear x v -> line_clear (add x (scal s v)) v.
  Proof. intros x v s H f T Hf HT. destruct (H f T Hf HT) as (A & B & C). unfold threads. rewrite !beside_along. auto. Qed.
  Lemma clear_back : forall x v, line_clear x v -> line_clear x (scal (-1) v).
  Proof. intros x v H f T Hf HT. apply threads_back. eauto. Qed.

  (* a line through a point inside goes out and in: all its crossings sum to nothing *)
  Lemma line_cancels : forall z v, strictly z -> v <> origin -> line_clear z v -> total (fun f => total (passes z v) (fan_of f)) Fs = 0%Z.
  Proof.
    intros z v Hz Hv Hl. assert (Hv' : scal (-1) v <> origin).
    { intros E. apply Hv. apply (f_equal (scal (-1))) in E. rewrite scal_scal in E. replace (-1 * -1) with 1 in E by ring.
    rewrite scal_1 in E.
      rewrite E. pteq; ring. }
    assert (I := inside_once z v Hz Hv Hl). assert (J := inside_once z (scal (-1) v) Hz Hv' (clear_back z v Hl)).
    assert (G : forall l, (forall g, In g l -> In g Fs) -> total (fun f => total (passes z v) (fan_of f)) l
      = (total (face_crossing z v) l - total (face_crossing z (scal (-1) v)) l)%Z).
    { induction l as [|g l IH]; intros H; [reflexivity|]. cbn [total fold_right]. unfold total in IH at 1 3 4.
      rewrite IH by (intros; apply H; simpl; auto). assert (Hg : In g Fs) by (apply H; simpl; auto).
      assert (K : total (passes z v) (fan_of g) = (face_crossing z v g - face_crossing z (scal (-1) v) g)%Z); [|unfold total in *; lia].
      unfold face_crossing. rewrite total_back. destruct (Z.eq_dec (total (passes z v) (fan_of g)) 0) as [Z|Z]; [rewrite Z; lia|].
      destruct (passing z v g Hg (fun T => Hl g T Hg) Z) as (Nv & _). specialize (Hz g Hg). unfold ahead.
      rewrite dot_scal_r, dot_sub_r, (level g (first_of g)) by (simpl; auto). set (d := height_of g - dot (normal_of g) z) in *.
      assert (Pd : 0 < d) by (unfold d; lra). rewrite !unit_step_times by auto.
      destruct (Rlt_dec 0 (dot (normal_of g) v)); known; lia. }
    rewrite G, I, J by auto. reflexivity.
  Qed.

  Lemma outside_none : forall x v, ~ under Fs x -> v <> origin -> line_clear x v -> total (face_crossing x v) Fs = 0%Z.
  Proof.
    intros x v Hx Hv Hl.
    assert (D : (forall f, In f Fs -> face_crossing x v f = 0%Z) \/ exists f, In f Fs /\ face_crossing x v f <> 0%Z).
    { clear. induction Fs as [|f l IH]; [left; intros f []|]. destruct (Z.eq_dec (face_crossing x v f) 0) as [E|E].
      - destruct IH as [H|(g & Hg & H)]; [left; intros g [<-|Hg]; auto|right; exists g; simpl; auto].
      - right. exists f. simpl. auto. }
    destruct D as [D|(f & Hf & Nf)]; [apply total_zero; auto|]. unfold face_crossing in Nf.
    assert (N : total (passes x v) (fan_of f) <> 0%Z) by (intros E; apply Nf; rewrite E; lia).
    assert (Af : 0 < dot (normal_of f) (sub (first_of f) x) * dot (normal_of f) v).
    { destruct (Rlt_dec 0 (dot (normal_of f) (sub (first_of f) x) * dot (normal_of f) v)) as [L|L]; auto. exfalso. apply Nf.
      unfold ahead. rewrite unit_step_no by lra. lia. }
    destruct (in_split f Fs Hf) as (l & k & EF). assert (Al := alone x v l f k EF (fun T => Hl f T Hf) N).
    destruct (passing x v f Hf (fun T => Hl f T Hf) N) as (Nv & Uf & _).
    set (t := dot (normal_of f) (sub (first_of f) x) / dot (normal_of f) v).
    assert (Et : dot (normal_of f) (sub (first_of f) x) = t * dot (normal_of f) v) by (unfold t; field; auto).
    assert (Pt : 0 < t) by (rewrite Et in Af; nra).
    assert (Ey : hit x v f = add x (scal t v)) by reflexivity.
    assert (S : exists s, strictly (add x (scal s v))).
    { assert (Q : exists r, r * dot (normal_of f) v < 0).
      { destruct (Rlt_dec 0 (dot (normal_of f) v)); [exists (-1)|exists 1]; lra. }
      destruct Q as (r & Hr). set (d := scal r v). assert (Hd : dot (normal_of f) d < 0) by (unfold d; rewrite dot_scal_r; auto).
      assert (Nd : d <> origin). { intros E. rewrite E in Hd. unfold dot, origin in Hd; simpl in Hd. lra. }
      destruct (some_ahead _ d Uf Nd) as (f0 & Hf0 & P0).
      destruct (ray _ normal_of height_of Fs _ d Uf) as [A|(s & S0 & U & g & Hg & Pg & E)]; [specialize (A f0 Hf0); lra|].
      assert (Ps : 0 < s).
      { destruct (Req_dec s 0) as [Z|Z]; [|lra]. exfalso. destruct (in_parts l f k EF g Hg) as [->|Ig]; [lra|].
        specialize (Al g Ig). rewrite Z, dot_add_r, dot_scal_r in E. lra. }
      exists (t + s / 2 * r). intros h Hh. replace (add x (scal (t + s / 2 * r) v)) with (add (hit x v f) (scal (s / 2) d))
        by (rewrite Ey; unfold d; pteq; ring).
      specialize (U h Hh). rewrite dot_add_r, dot_scal_r in U |- *. destruct (in_parts l f k EF h Hh) as [->|Ih].
      - rewrite (hit_level Vs Fs Hfaces) by auto. assert (0 < s / 2 * - dot (normal_of f) d) by (apply Rmult_lt_0_compat; lra). lra.
      - specialize (Al h Ih). lra. }
    destruct S as (s & Hs). assert (Z := line_cancels _ v Hs Hv (clear_along x v s Hl)).
    assert (E : forall g, In g Fs -> face_crossing x v g = total (passes (add x (scal s v)) v) (fan_of g)).
    { intros g Hg. rewrite passes_of_z. unfold face_crossing. destruct (Z.eq_dec (total (passes x v) (fan_of g)) 0) as [Q|Q];
      [rewrite Q; lia|].
      destruct (passing x v g Hg (fun T => Hl g T Hg) Q) as (Gv & Ug & _).
      set (r := dot (normal_of g) (sub (first_of g) x) / dot (normal_of g) v).
      assert (Er : dot (normal_of g) (sub (first_of g) x) = r * dot (normal_of g) v) by (unfold r; field; auto).
      destruct (Rlt_dec 0 r) as [L|L].
      - unfold ahead. rewrite Er, unit_step_yes; [lia|]. replace (r * dot (normal_of g) v * dot (normal_of g) v) with (r * (dot
        (normal_of g) v * dot (normal_of g) v)) by ring.
        apply Rmult_lt_0_compat; auto. apply square_pos. auto.
      - exfalso. apply Hx. intros h Hh. assert (U1 := Uf h Hh). assert (U2 := Ug h Hh). rewrite Ey in U1. unfold hit in U2. fold r in U2.
        rewrite dot_add_r, dot_scal_r in U1, U2. apply Rmult_le_reg_l with (t - r); [lra|].
        assert (W1 : t * (dot (normal_of h) x + r * dot (normal_of h) v) <= t * height_of h) by (apply Rmult_le_compat_l; lra).
        assert (W2 : - r * (dot (normal_of h) x + t * dot (normal_of h) v) <= - r * height_of h) by (apply Rmult_le_compat_l; lra). lra. }
    rewrite (total_ext _ _ _ Fs E). exact Z.
  Qed.

  Lemma general_clear : forall x v, general (fans Fs) x v -> line_clear x v /\ (under Fs x -> strictly x).
  Proof.
    intros x v G. assert (C : forall f u w, In f Fs -> In (u, w) (pairs (second_of f) (others_of f)) -> clear x v (Triangle (first_of
      f) u w)).
    { intros f u w Hf H. assert (D := strict f u w Hf H). destruct (G (Triangle (first_of f) u w)) as [E|C]; auto.
      - apply in_concat. exists (fan_of f). split; [apply in_map; auto|]. apply in_map_iff. exists (u, w). auto.
      - exfalso. replace (det (first_of f) u w) with (dot (front (Triangle (first_of f) u w)) (first_of f)) in D
          by (unfold front, det, dot, cross; simpl; ring). rewrite E in D. unfold dot in D; simpl in D. lra. }
    split.
    - intros f T Hf HT. apply in_map_iff in HT. destruct HT as ([u w] & <- & H). destruct (C f u w Hf H) as (A1 & A2 & A3 & _).
      unfold threads. auto.
    - intros U f Hf. specialize (U f Hf). destruct (Req_dec (dot (normal_of f) x) (height_of f)) as [E|E]; [|lra]. exfalso.
      assert (R := proper f Hf). destruct (others_of f) as [|b r] eqn:Er; [congruence|].
      assert (I : In (second_of f, b) (pairs (second_of f) (others_of f))) by (rewrite Er; simpl; auto).
      assert (D := strict f _ _ Hf I). destruct (pair_in_cycle f _ _ I) as [Ha Hb]. destruct (C f _ _ Hf I) as (_ & _ & _ & Q). apply Q.
      cbn [corner_1]. set (T := Triangle (first_of f) (second_of f) b) in *. destruct (front_level T) as (E1 & E2 & E3).
      cbn [corner_1 corner_2 corner_3 T] in *.
      assert (K := same_form (front T) (dot (front T) (first_of f)) (normal_of f) (height_of f) (first_of f) (second_of f) b (sub
        (first_of f) x)
        (Rgt_not_eq _ _ D) eq_refl (eq_sym E1) E3 (level f _ Hf (or_introl eq_refl)) (level f _ Hf Ha) (level f _ Hf Hb)).
      rewrite (dot_sub_r (normal_of f)), (level f (first_of f)), E in K by (simpl; auto). assert (Q' := raised f Hf). nra.
  Qed.

  (* for x and v in general position *)
  Theorem piece_winding : forall x v, general (fans Fs) x v ->
    (conv Vs x /\ winding (fans Fs) x v = 1%Z) \/ (~ conv Vs x /\ winding (fans Fs) x v = 0%Z).
  Proof.
    intros x v G. destruct (general_clear x v G) as [Hl Hs]. rewrite winding_faces. assert (Hv : v <> origin).
    { intros ->. assert (D : (exists f, In f Fs) \/ forall f, ~ In f Fs) by (destruct Fs as [|f l]; [right; auto|left; exists f; simpl;
      auto]).
      destruct D as [(f & Hf)|D].
      - assert (R := proper f Hf). destruct (others_of f) as [|b r] eqn:Er; [congruence|].
        destruct (Hl f (Triangle (first_of f) (second_of f) b) Hf) as (A & _).
        + unfold fan_of. rewrite Er. simpl. auto.
        + apply A. unfold beside, dot; simpl. ring.
      - destruct (some_ahead x (mk 1 0 0)) as (f & Hf & _); [intros f Hf; destruct (D f Hf)| |exact (D f Hf)]. intros E. inversion E.
      lra. }
    destruct (under_dec Fs x) as [U|(f & Hf & U)].
    - left. split; [apply filled; auto|]. apply inside_once; auto.
    - assert (N : ~ under Fs x) by (intros K; specialize (K f Hf); lra). right. split; [intros K; apply N, under_conv; auto|].
      apply outside_none; auto.
  Qed.

  Lemma piece_solid : exists p, interior (conv Vs) p.
  Proof.
    exists origin. destruct (all_or_some _ (fun _ : face => False) (fun f e => forall s, norm2 (sub s origin) < e * e ->
      dot (normal_of f) s <= height_of f) Fs) as [(f & _ & [])|(e & He & G)].
    - intros f e e' He H s Hs. apply H. nra.
    - intros f Hf. right. apply stays_below. rewrite dot_comm. unfold dot; simpl. assert (Q := raised f Hf). lra.
    - exists e. split; auto. intros s Hs. apply filled. intros f Hf. auto.
  Qed.

  Lemma piece_closed : forall x, conv Vs x \/ exists e, 0 < e /\ forall y, norm2 (sub y x) < e * e -> ~ conv Vs y.
  Proof.
    intros x. destruct (under_dec Fs x) as [U|(f & Hf & U)]; [left; apply filled; auto|right].
    set (h := (height_of f + dot (normal_of f) x) / 2).
    destruct (stays_below (scal (-1) (normal_of f)) (- h) x) as (e & He & G); [rewrite dot_scal_l; unfold h; lra|].
    exists e. split; auto. intros y Hy K. specialize (G y Hy). apply under_conv in K. specialize (K f Hf). rewrite dot_scal_l in G.
    unfold h in G. lra.
  Qed.
End Piece.

(* ---- moved and scaled: y goes to (y + s)/k ---- *)
Section Moved.
  Variables (k : R) (s : pt).
  Hypothesis Hk : 0 < k.
  Definition moved (y : pt) : pt := scal (/ k) (add y s).
  Definition moved_triangle (T : triangle) : triangle := Triangle (moved (corner_1 T)) (moved (corner_2 T)) (moved (corner_3 T)).

  Let Pk : 0 < / k := Rinv_0_lt_compat k Hk.
  Let Pk2 : 0 < / k * / k := Rmult_lt_0_compat _ _ Pk Pk.

  Lemma moved_front : forall T, front (moved_triangle T) = scal (/ k * / k) (front T).
  Proof. intros [p q r]. unfold front, moved_triangle, moved; simpl. pteq; ring. Qed.
  Lemma moved_beside : forall y v p q, beside (moved y) v (moved p) (moved q) = / k * / k * beside y v p q.
  Proof. intros. unfold beside, moved, dot, cross; simpl. ring. Qed.
  Lemma moved_ahead : forall y n p, dot (scal (/ k * / k) n) (sub (moved p) (moved y)) = / k * / k * / k * dot n (sub p y).
  Proof. intros. unfold moved, dot; simpl. ring. Qed.

  Lemma moved_crossing : forall y v T, crossing (moved y) v (moved_triangle T) = crossing y v T.
  Proof.
    intros y v T. unfold crossing. f_equal.
    - unfold ahead. rewrite moved_front. cbn [moved_triangle corner_1]. rewrite moved_ahead, dot_scal_l.
      replace (/ k * / k * / k * dot (front T) (sub (corner_1 T) y) * (/ k * / k * dot (front T) v))
        with (/ k * / k * / k * (/ k * / k) * (dot (front T) (sub (corner_1 T) y) * dot (front T) v)) by ring.
      apply unit_step_times. repeat apply Rmult_lt_0_compat; auto.
    - unfold passes. cbn [moved_triangle corner_1 corner_2 corner_3]. rewrite !moved_beside, !Ropp_mult_distr_r, !unit_step_times; auto.
  Qed.

  Lemma moved_winding : forall N y v, winding (map moved_triangle N) (moved y) v = winding N y v.
  Proof. intros N y v. unfold winding. rewrite total_map. apply total_ext. intros T _. apply moved_crossing. Qed.

  Lemma moved_general : forall N y v, general (map moved_triangle N) (moved y) v -> general N y v.
  Proof.
    intros N y v G T HT. destruct (G (moved_triangle T)) as [E|C]; [apply in_map; auto| |].
    - left. rewrite moved_front in E. apply (f_equal (scal (k * k))) in E. rewrite scal_scal in E.
      replace (k * k * (/ k * / k)) with 1 in E by (field; lra). rewrite scal_1 in E. rewrite E. pteq; ring.
    - right. destruct C as (A & B & C & D). rewrite moved_front in D. cbn [moved_triangle corner_1 corner_2 corner_3] in *.
      rewrite moved_ahead in D. rewrite moved_beside in *. repeat split; intros E; [apply A|apply B|apply C|apply D]; rewrite E; ring.
  Qed.

  Lemma moved_back : forall x, moved (sub (scal k x) s) = x.
  Proof. intros x. unfold moved. pteq; field; lra. Qed.
End Moved.
