(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Unions of convex pieces have just one depth: overlapping ones a depth, those that touch 0, and
   others a distance. *)
Require Import Reals Lra Psatz List.
From Fathom.geometry Require Import meaning space hulls flats facets norm difference depth minkowski unions limits
  compact curved seams said.
Import ListNotations.
Open Scope R_scope.

(* ---- where a Lipschitz function, positive at O, is not positive for the first time ---- *)
Theorem first_exit : forall g, lipschitz 1 g -> 0 < g origin -> (exists s, g s <= 0) ->
  exists r, 0 < r /\ (forall t, norm t < r -> 0 < g t) /\ exists t, norm t = r /\ g t <= 0.
Proof.
  intros g [_ Hg] P0 (s & Hs).
  (* the least value in the ball of radius r, as a function of r *)
  assert (L : forall r, lipschitz (Rabs r) (fun u => g (scal r u))).
  { intros r. split; [apply Rabs_pos|]. intros p q. specialize (Hg (scal r p) (scal r q)).
    replace (sub (scal r p) (scal r q)) with (scal r (sub p q)) in Hg by (pteq; ring). rewrite norm_scal_abs in Hg.
      lra. }
  set (best := fun r => proj1_sig (attains_ball _ _ (L r))). set (m := fun r => g (scal r (best r))).
  assert (B : forall r, norm (best r) <= 1 /\ forall u, norm u <= 1 -> m r <= g (scal r u)).
  { intros r. unfold m, best. destruct (attains_ball _ _ (L r)) as (u & Hu & M). simpl. split; [apply unit_ball_norm;
      auto|].
    intros w Hw. apply M, unit_ball_norm. auto. }
  clearbody best. assert (near : forall r q, m r <= m q + Rabs (r - q)).
  { intros r q. destruct (B r) as [_ M]. destruct (B q) as [N _]. specialize (M (best q) N).
    specialize (Hg (scal r (best q)) (scal q (best q))).
    replace (sub (scal r (best q)) (scal q (best q))) with (scal (r - q) (best q)) in Hg by (pteq; ring).
    rewrite norm_scal_abs in Hg. assert (A := Rabs_pos (r - q)). unfold m at 2. nra. }
  assert (inside : forall r t, 0 < r -> norm t <= r -> m r <= g t).
  { intros r t Hr Ht. destruct (B r) as [_ M]. specialize (M (scal (/ r) t)).
    assert (Ri : 0 < / r) by (apply Rinv_0_lt_compat; auto). rewrite norm_scal in M by lra.
    replace (scal r (scal (/ r) t)) with t in M by (rewrite scal_scal, Rinv_r, scal_1 by lra; auto). apply M.
    apply Rmult_le_reg_l with r; auto. rewrite <- Rmult_assoc, Rinv_r by lra. lra. }
  assert (M0 : 0 < m 0). { unfold m. replace (scal 0 (best 0)) with origin by (pteq; ring). auto. }
  assert (Ns : 0 < norm s).
  { apply norm_pos. intros ->. lra. }
  assert (Ms : m (norm s) <= 0). { apply Rle_trans with (g s); auto. apply inside; auto. lra. }
  destruct (nested (fun a b => 0 <= a /\ 0 < m a /\ m b <= 0)) with (a := 0) (b := norm s) as (x & Hx); try lra.
  { intros a b Lab (A & Ma & Mb). destruct (Rlt_dec 0 (m ((a + b) / 2))) as [X|X]; [right|left]; repeat split; auto;
      lra. }
  assert (Mx : m x <= 0).
  { apply le_by_small. intros e He. destruct (Hx e He) as (c & d & _ & C & _ & W & _ & _ & Md). assert (N := near x d).
    rewrite Rabs_left1 in N by lra. lra. }
  assert (Px : 0 <= x) by (destruct (Hx 1) as (c & d & ? & ? & _ & _ & ? & _); lra).
  assert (Below : forall t, norm t < x -> 0 < g t).
  { intros t Ht. destruct (Hx ((x - norm t) / 2)) as (c & d & _ & C & _ & W & _ & Mc & _); [lra|].
    assert (N := norm_nonneg t). apply Rlt_le_trans with (m c); auto. apply inside; lra. }
  destruct (B x) as [N _]. assert (Nt : norm (scal x (best x)) <= x) by (rewrite norm_scal by auto; nra).
  assert (Et : norm (scal x (best x)) = x).
  { apply Rle_antisym; auto. apply Rnot_lt_le. intros X. apply Below in X. fold (m x) in X. lra. }
  exists x. split; [|split; auto; exists (scal x (best x)); split; auto].
  destruct (Req_dec x 0) as [Z|Z]; [|lra]. exfalso. rewrite Z in Mx. lra.
Qed.

(* ---- how deep t is in one of several intersections of half-spaces with unit normals ---- *)
Fixpoint low (F : list (pt * R)) (t : pt) : R :=
  match F with [] => 1 | f :: F' => Rmin (snd f - dot (fst f) t) (low F' t) end.
Fixpoint high (Fs : list (list (pt * R))) (t : pt) : R :=
  match Fs with [] => -1 | F :: Fs' => Rmax (low F t) (high Fs' t) end.

Lemma low_positive : forall F t, 0 < low F t <-> forall f, In f F -> dot (fst f) t < snd f.
Proof.
  induction F as [|f F IH]; intros t; simpl; [split; [intros _ f []|lra]|]. specialize (IH t). split.
  - intros H g [<-|Ig]; [assert (X := Rmin_l (snd f - dot (fst f) t) (low F t)); lra|].
    apply IH; auto. assert (X := Rmin_r (snd f - dot (fst f) t) (low F t)). lra.
  - intros H. apply Rmin_glb_lt; [specialize (H f (or_introl eq_refl)); lra|]. apply IH. auto.
Qed.
Lemma high_positive : forall Fs t, 0 < high Fs t <-> exists F, In F Fs /\ 0 < low F t.
Proof.
  induction Fs as [|F Fs IH]; intros t; simpl; [split; [lra|intros (F & [] & _)]|]. specialize (IH t). split.
  - unfold Rmax. destruct (Rle_dec _ _); intros H; [apply IH in H; destruct H as (G & I & H); exists G; auto|exists F;
      auto].
  - intros (G & [<-|I] & H); [eapply Rlt_le_trans; [exact H|apply Rmax_l]|].
    eapply Rlt_le_trans; [apply IH; exists G; eauto|apply Rmax_r].
Qed.
Lemma low_lipschitz : forall F, (forall f, In f F -> norm (fst f) = 1) -> lipschitz 1 (low F).
Proof.
  intros F H. split; [lra|]. intros p q. rewrite Rmult_1_l. assert (N := norm_nonneg (sub p q)).
  induction F as [|f F IH]; simpl; [lra|]. assert (L : low F p - low F q <= norm (sub p q)) by (apply IH; intros;
    apply H; simpl; auto).
  assert (D := dot_le_norm (fst f) (sub q p)). rewrite dot_sub_r, (norm_opp q p), (H f (or_introl eq_refl)) in D.
  unfold Rmin. repeat destruct (Rle_dec _ _); lra.
Qed.
Lemma high_lipschitz : forall Fs, (forall F f, In F Fs -> In f F -> norm (fst f) = 1) -> lipschitz 1 (high Fs).
Proof.
  intros Fs H. split; [lra|]. intros p q. rewrite Rmult_1_l. assert (N := norm_nonneg (sub p q)).
  induction Fs as [|F Fs IH]; simpl; [lra|].
  assert (L : high Fs p - high Fs q <= norm (sub p q)) by (apply IH; intros G f IG; apply H; simpl; auto).
  destruct (low_lipschitz F) as [_ D]; [intros f; apply H; simpl; auto|]. specialize (D p q).
  unfold Rmax. repeat destruct (Rle_dec _ _); lra.
Qed.

(* ---- the pairs of pieces ---- *)
Section Unions.
  Variables As Bs : list (list pt).
  Hypothesis HA : solid_pieces As.
  Hypothesis HB : solid_pieces Bs.

  Lemma pair_interior : forall A B, (exists p, interior (conv A) p) -> (exists p, interior (conv B) p) -> exists t,
    interior (P A B) t.
  Proof.
    intros A B (a & Ha) (b & Hb). exists (sub b a). apply pair_interiors; eauto. exists b. split; auto.
    apply interior_translate. replace (sub b (sub b a)) with a by (pteq; ring). auto.
  Qed.

  Lemma pair_planes : forall A B, (exists p, interior (conv A) p) -> (exists p, interior (conv B) p) ->
    exists F, (forall f, In f F -> norm (fst f) = 1) /\ forall t, interior (P A B) t <-> 0 < low F t.
  Proof.
    intros A B IA IB. destruct (pair_interior A B IA IB) as (t0 & I0).
    destruct (finite_facets _ (interior_spanning _ _ _ I0)) as (F & F1 & F2).
    assert (Pl : forall f, In f F -> fst f <> origin /\ height_is A B (fst f) (snd f)).
    { intros f If. destruct (F1 f If) as (u & v & w & K). apply facet_plane_P in K. destruct K as [[Hn _] Hh]. auto. }
    exists (map (fun f => (along (fst f) 1, snd f / norm (fst f))) F). split.
    - intros g Ig. apply in_map_iff in Ig. destruct Ig as (f & <- & If). apply norm_along; [apply Pl; auto|lra].
    - assert (E : forall f t, In f F -> (dot (along (fst f) 1) t < snd f / norm (fst f) <-> dot (fst f) t < snd f)).
      { intros f t If. assert (Pn := norm_pos _ (proj1 (Pl f If))). unfold along. rewrite dot_scal_l.
        replace (1 / norm (fst f) * dot (fst f) t) with (dot (fst f) t / norm (fst f)) by (unfold Rdiv; ring).
        assert (Pi : 0 < / norm (fst f)) by (apply Rinv_0_lt_compat; auto). unfold Rdiv. split; intros H.
        - apply Rmult_lt_reg_r in H; auto.
        - apply Rmult_lt_compat_r; auto. }
      intros t. rewrite low_positive. split.
      + intros I g Ig. apply in_map_iff in Ig. destruct Ig as (f & <- & If). simpl. apply E; auto. apply Rnot_le_lt.
          intros X.
        destruct (Pl f If) as [Hn Hh]. exact (beyond_not_interior A B (fst f) (snd f) t Hn Hh X I).
      + intros H. apply interior_P_conv. destruct (interior_or_facet _ F F2 t) as [I|(f & If & X)]; auto. exfalso.
        specialize (H _ (in_map _ _ _ If)). simpl in H. apply E in H; auto. lra.
  Qed.

  (* of all pairs at once *)
  Lemma all_planes : exists Fs, (forall F f, In F Fs -> In f F -> norm (fst f) = 1) /\ forall t,
    overlap_at As Bs t <-> 0 < high Fs t.
  Proof.
    assert (K : forall l, (forall x, In x l -> In (fst x) As /\ In (snd x) Bs) -> exists Fs, (forall F f, In F Fs ->
      In f F -> norm (fst f) = 1)
      /\ forall t, (exists x, In x l /\ interior (P (fst x) (snd x)) t) <-> 0 < high Fs t).
    { induction l as [|x l IH]; intros H.
      - exists []. split; [intros F f []|]. intros t. simpl. split; [intros (x & [] & _)|lra].
      - destruct IH as (Fs & N & E); [intros; apply H; simpl; auto|]. destruct (H x (or_introl eq_refl)) as [IA IB].
        destruct (pair_planes (fst x) (snd x)) as (F & N0 & E0); [apply HA; auto|apply HB; auto|].
        exists (F :: Fs). split; [intros G f [<-|IG] If; [auto|eauto]|]. intros t. specialize (E t). specialize (E0 t).
        rewrite high_positive in *. split.
        + intros (y & [<-|Iy] & J); [exists F; simpl; rewrite <- E0; auto|].
          destruct (proj1 E (ex_intro _ y (conj Iy J))) as (G & IG & PG). exists G. simpl. auto.
        + intros (G & [<-|IG] & PG); [exists x; simpl; rewrite E0; auto|].
          destruct (proj2 E (ex_intro _ G (conj IG PG))) as (y & Iy & J). exists y. simpl. auto. }
    destruct (K (list_prod As Bs)) as (Fs & N & E).
    { intros [A B] I. apply in_prod_iff in I. exact I. }
    exists Fs. split; auto. intros t. rewrite <- E, overlap_pairs by auto. split.
    - intros (A & B & IA & IB & I). exists (A, B). split; auto. apply in_prod_iff. auto.
    - intros ([A B] & I & J). apply in_prod_iff in I. exists A, B. simpl in J. tauto.
  Qed.

  Lemma pieces_filled : forall Ls L, solid_pieces Ls -> In L Ls -> L <> [].
  Proof.
    intros Ls L [_ H] IL ->. destruct (H [] IL) as (p & Hp). apply interior_in in Hp. apply (Hp (fun _ => False));
      [intros u v l _ []|].
    intros s [].
  Qed.

  (* the shortest of all differences *)
  Lemma nearest_pair : exists p, difference_of (union Bs) (union As) p
    /\ forall q, difference_of (union Bs) (union As) q -> norm2 p <= norm2 q.
  Proof.
    assert (K : forall l : list (list pt * list pt), l <> [] -> (forall x, In x l -> fst x <> [] /\ snd x <> []) ->
      exists p, (exists x, In x l /\ gap_set (fst x) (snd x) p) /\ forall q, (exists x, In x l
        /\ gap_set (fst x) (snd x) q) -> norm p <= norm q).
    { induction l as [|x l IH]; [congruence|]. intros _ H. destruct (H x (or_introl eq_refl)) as [NA NB].
      destruct (attains_gaps _ _ NA NB norm 1) as (p & Hp & M).
      { split; [lra|]. intros p q. assert (T := norm_triangle (sub p q) q).
          replace (add (sub p q) q) with p in T by (pteq; ring). lra. }
      destruct l as [|y l].
      - exists p. split; [exists x; simpl; auto|]. intros q (z & [<-|[]] & Hq). auto.
      - destruct IH as (p' & (z & Iz & Hz) & M'); [discriminate|intros; apply H; simpl; auto|].
        destruct (Rle_dec (norm p) (norm p')) as [L|L].
        + exists p. split; [exists x; simpl; auto|]. intros q (w & [<-|Iw] & Hq); auto.
          apply Rle_trans with (norm p'); auto. apply M'. exists w. auto.
        + exists p'. split; [exists z; simpl in *; auto|]. intros q (w & [<-|Iw] & Hq); [|apply M'; exists w; auto].
          specialize (M q Hq). lra. }
    assert (E : forall q, difference_of (union Bs) (union As) q <-> exists x, In x (list_prod As Bs)
      /\ gap_set (fst x) (snd x) q).
    { intros q. split.
      - intros (b & a & (B & IB & Hb) & (A & IA & Ha) & Eq). exists (A, B). split; [apply in_prod_iff; auto|].
          exists b, a. auto.
      - intros ([A B] & I & b & a & Hb & Ha & Eq). apply in_prod_iff in I. exists b, a. split; [exists B; tauto|].
          split; [exists A; tauto|auto]. }
    destruct (K (list_prod As Bs)) as (p & Hp & M).
    - destruct HA as [NA _], HB as [NB _]. destruct As; [congruence|]. destruct Bs; [congruence|]. discriminate.
    - intros [A B] I. apply in_prod_iff in I. split; [apply (pieces_filled As)|apply (pieces_filled Bs)]; tauto.
    - exists p. split; [apply E; auto|]. intros q Hq. apply E, M in Hq. rewrite <- !norm_sqr.
        assert (N := norm_nonneg p).
      apply Rmult_le_compat; auto.
  Qed.

  Lemma overlap_difference : forall t, overlap_at As Bs t -> difference_of (union Bs) (union As) t.
  Proof.
    intros t (p & Hp & Hq). apply interior_in in Hp, Hq. exists p, (sub p t). split; auto. split; auto. pteq; ring.
  Qed.

  (* far enough away they are apart *)
  Lemma far_apart : exists s, ~ overlap_at As Bs s.
  Proof.
    set (e := mk 1 0 0).
    assert (K : forall Ls, solid_pieces Ls \/ Ls = [] -> exists r, forall p, union Ls p -> Rabs (dot e p) <= r).
    { intros Ls _. assert (one : forall L, exists r, forall p, conv L p -> Rabs (dot e p) <= r).
      { intros L. exists (fold_right (fun s m => Rmax (Rabs (dot e s)) m) 0 L).
        assert (G : forall s, In s L -> Rabs (dot e s) <= fold_right (fun s m => Rmax (Rabs (dot e s)) m) 0 L).
        { induction L as [|u L IH]; intros s Is; [contradiction|]. simpl. destruct Is as [->|Is]; [apply Rmax_l|].
          eapply Rle_trans; [apply IH; auto|apply Rmax_r]. }
        set (r := fold_right _ 0 L) in *. intros p Hp. apply Rabs_le. split.
        - assert (X : dot (scal (-1) e) p <= r); [|rewrite dot_scal_l in X; lra].
          revert p Hp. apply hull_halfspace. intros s Is. apply G, abs_bounds in Is. rewrite dot_scal_l. lra.
        - revert p Hp. apply hull_halfspace. intros s Is. apply G, abs_bounds in Is. lra. }
      induction Ls as [|L Ls (r & IH)]; [exists 0; intros p (L & [] & _)|]. destruct (one L) as (k & Hk).
        exists (Rmax r k).
      intros p (M & [<-|IM] & Hp); [eapply Rle_trans; [apply Hk; auto|apply Rmax_r]|].
      eapply Rle_trans; [apply IH; exists M; auto|apply Rmax_l]. }
    destruct (K As (or_introl HA)) as (r & Hr). destruct (K Bs (or_introl HB)) as (k & Hk).
    exists (scal (r + k + 1) e). intros I. apply overlap_difference in I. destruct I as (b & a & Hb & Ha & E).
    apply Hr, abs_bounds in Ha. apply Hk, abs_bounds in Hb. apply (f_equal (dot e)) in E.
      rewrite dot_scal_r, dot_sub_r in E.
    assert (One : dot e e = 1) by (unfold e, dot; simpl; ring). rewrite One in E. lra.
  Qed.

  (* overlapping unions have a depth *)
  Theorem union_depth_exists : overlap_at As Bs origin <-> exists q, union_depth2_is As Bs q.
  Proof.
    split; [|intros (q & Hq & H & _); apply H; rewrite norm2_origin; auto].
    intros O. destruct all_planes as (Fs & N & E). destruct far_apart as (s & Hs).
    destruct (first_exit (high Fs)) as (r & Pr & Below & t & Nt & Ht).
    - apply high_lipschitz. auto.
    - apply E. auto.
    - exists s. apply Rnot_lt_le. intros X. apply Hs, E. auto.
    - exists (r * r). split; [nra|]. split.
      + intros u Hu. apply E, Below. apply norm_lt; auto. lra.
      + exists t. split; [rewrite <- norm_sqr, Nt; auto|]. intros X. apply E in X. lra.
  Qed.

  Theorem union_depth2_exists : exists q, depth2 (overlap_at As Bs) (difference_of (union Bs) (union As)) q.
  Proof.
    destruct all_planes as (Fs & _ & E). destruct (Rlt_dec 0 (high Fs origin)) as [L|L].
    - apply E, union_depth_exists in L. destruct L as (q & D). exists q. left. exact D.
    - assert (NO : ~ overlap_at As Bs origin) by (rewrite E; auto). destruct nearest_pair as (p & Hp & M).
      destruct (Req_dec (norm2 p) 0) as [Z|Z].
      + exists 0. right; left. split; auto. split; auto. rewrite <- (norm2_zero p Z). auto.
      + exists (- norm2 p). right; right. assert (Np := norm2_nonneg p). rewrite Ropp_involutive. split; [lra|]. split;
          auto.
        exists p. auto.
  Qed.
End Unions.
