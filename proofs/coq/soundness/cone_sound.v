(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* An accepted cone is the set of all u with h(u) = 0. *)
Require Import Reals Lra Psatz List ZArith Lia Bool.
From Fathom.checker Require Import vector sequence table polytope support certificate cone.
From Fathom.geometry Require Import meaning bodies space norm hulls difference spans cones cones_many.
From Fathom.soundness Require Import statement booleans upper lower optima.
Import ListNotations.
Open Scope R_scope.

Lemma gather : forall (f : zvec -> bool) l, fold_left (fun l r => if f r then r :: l else l) l [] = rev (filter f l).
Proof.
  intros f l. assert (G : forall l done, fold_left (fun l r => if f r then r :: l else l) l done = rev (filter f l) ++ done).
  { induction l0 as [|a l0 IH]; simpl; intros done; auto. rewrite IH. destruct (f a); simpl; auto. rewrite <- app_assoc. auto. }
  rewrite G, app_nil_r. auto.
Qed.

Lemma first_in : forall (T : Type) (f : T -> bool) l x, first f l = Some x -> In x l.
Proof. induction l as [|a l IH]; simpl; intros x H; [discriminate|]. destruct (f a); [inversion H|]; auto. Qed.

Lemma polar_add : forall S u v, polar S u -> polar S v -> polar S (add u v).
Proof.
  intros S u v Hu Hv p Hp. rewrite dot_comm, dot_add_r, !(dot_comm p). specialize (Hu p Hp). specialize (Hv p Hp). lra.
Qed.
Lemma polar_scal : forall S k u, 0 <= k -> polar S u -> polar S (scal k u).
Proof. intros S k u Hk Hu p Hp. rewrite dot_scal_l. specialize (Hu p Hp). nra. Qed.
Lemma polar_origin : forall S, polar S origin.
Proof. intros S p _. unfold dot, origin; simpl. lra. Qed.

Lemma same_vector_refl : forall u, same_vector u u = true.
Proof. intros [a b c]. unfold same_vector. simpl. rewrite !Z.eqb_refl. auto. Qed.

Section Cone.
  Variables A B : list zvec.
  Let K := polar (P (map inj A) (map inj B)).

  Lemma level_polar : forall n, level A B n = true -> K (inj n).
  Proof.
    intros n H. apply height_is_sound in H. destruct H as (h & T & Hh & _). bsplit. subst h. intros p Hp. apply Hh; auto.
  Qed.

  Lemma difference_polar : forall ji u, K u -> dot (inj (difference (numbered A) (numbered B) ji)) u <= 0.
  Proof.
    intros ji u Hu. destruct (difference_in A B ji) as [E|D].
    - rewrite E. change (inj zzero) with origin. unfold dot, origin; simpl. lra.
    - rewrite dot_comm. apply Hu. apply hull_in. auto.
  Qed.

  Variables (ls rs ds : list zvec).
  Let rls := map inj ls.
  Let rrs := map inj rs.
  Let rds := map inj ds.
  Hypothesis Hd : forall d u, In d rds -> K u -> dot d u <= 0.
  Hypothesis Hl : forall l, In l rls -> K l /\ K (scal (-1) l).
  Hypothesis Hr : forall r, In r rrs -> K r.
  Hypothesis distinct : NoDup rs.
  Hypothesis Hind : independent ls = true.
  Hypothesis orthogonal : forall r l, In r rrs -> In l rls -> dot r l = 0.

  Lemma dot_zero : forall u v, dot (inj u) (inj v) = 0 <-> zdot u v = 0%Z.
  Proof. intros u v. rewrite <- dot_inj. split; [apply eq_IZR|intros ->; auto]. Qed.
  Lemma in_inj : forall v L, In (inj v) (map inj L) <-> In v L.
  Proof.
    intros v L. split; [|apply in_map]. intros H. apply in_map_iff in H. destruct H as (w & E & Iw). apply inj_injective in E. subst. auto.
  Qed.
  Lemma nodup_inj : NoDup rrs.
  Proof. apply FinFun.Injective_map_NoDup; auto. intros u v. apply inj_injective. Qed.

  Lemma independent_sound : linearly_independent rls.
  Proof.
    unfold rls. unfold independent in Hind. destruct ls as [|u [|v [|w [|]]]]; try discriminate; simpl.
    - intros [|] L E; [intros k []|discriminate].
    - apply independent_one. rewrite inj_zero, <- is_zero_spec. apply negb_true_iff in Hind. congruence.
    - apply independent_two. rewrite <- inj_cross, inj_zero, <- is_zero_spec. apply negb_true_iff in Hind. congruence.
    - apply independent_three. rewrite <- det_inj. apply negb_true_iff, Z.eqb_neq in Hind. apply not_0_IZR. auto.
  Qed.

  (* ---- three rays or more ---- *)
  Lemma on_plane_in : forall d r, In r (on_plane rs d) <-> In r rs /\ zdot d r = 0%Z.
  Proof. intros d r. unfold on_plane. rewrite gather, <- in_rev, filter_In, Z.eqb_eq. tauto. Qed.
  Lemma on_plane_distinct : forall d, NoDup (on_plane rs d).
  Proof. intros d. unfold on_plane. rewrite gather. apply NoDup_rev, NoDup_filter. auto. Qed.

  Lemma two_face : forall d a b, on_plane rs d = [a; b] -> In a rs /\ In b rs /\ face rrs (inj d) (inj a) (inj b).
  Proof.
    intros d a b E. assert (N := on_plane_distinct d). assert (I := on_plane_in d). rewrite E in N, I.
    destruct (proj1 (I a)) as [Ia Za]; [simpl; auto|]. destruct (proj1 (I b)) as [Ib Zb]; [simpl; auto|].
    repeat split; auto; try (apply dot_zero; auto).
    - intros X. apply inj_injective in X. subst b. inversion N as [|x l H1 H2]. apply H1. simpl; auto.
    - intros s Is Zs. unfold rrs in Is. apply in_map_iff in Is. destruct Is as (v & <- & Iv). apply dot_zero in Zs.
      destruct (proj2 (I v) (conj Iv Zs)) as [->|[->|[]]]; auto.
  Qed.
  Lemma face_swap : forall d a b, face rrs d a b -> face rrs d b a.
  Proof. intros d a b (Za & Zb & N & H). repeat split; auto. intros s Is Zs. destruct (H s Is Zs); auto. Qed.

  Lemma partner_face : forall d r a, partner r (on_plane rs d) = Some a -> In a rs /\ face rrs (inj d) (inj r) (inj a).
  Proof.
    intros d r a H. unfold partner in H. destruct (on_plane rs d) as [|x [|y [|]]] eqn:E; try discriminate.
    destruct (two_face d x y E) as (Ix & Iy & Fxy).
    destruct (same_vector r x) eqn:S; [apply same_vector_spec in S; inversion H; subst; auto|].
    destruct (same_vector r y) eqn:S'; [|discriminate]. apply same_vector_spec in S'. inversion H; subst. split; auto. apply face_swap;
      auto.
  Qed.

  Lemma many_sound : (3 <= length rs)%nat -> (forall d r, In d rds -> In r rrs -> dot d r <= 0) -> many_rays rs ds = true -> generated
    K rls rrs.
  Proof.
    intros H3 Hbelow H. unfold many_rays in H. rewrite each_map in H. bsplit.
    assert (faces : forall d, In d rds -> exists r a, In r rrs /\ In a rrs /\ face rrs d r a).
    { intros d Id. unfold rds in Id. apply in_map_iff in Id. destruct Id as (v & <- & Iv).
      assert (E := forallb_In _ _ _ H (on_plane rs v)). rewrite in_map_iff in E.
      destruct (on_plane rs v) as [|a [|b [|]]] eqn:Ev; try (discriminate E; eauto).
      destruct (two_face v a b Ev) as (Ia & Ib & Fab). exists (inj a), (inj b). unfold rrs. rewrite !in_inj. auto. }
    assert (between : forall r, In r rrs -> exists d d' a b, In d rds /\ In d' rds /\ In a rrs /\ In b rrs
        /\ face rrs d r a /\ face rrs d' r b /\ a <> b).
    { intros r Ir. unfold rrs in Ir. apply in_map_iff in Ir. destruct Ir as (v & <- & Iv).
      assert (E := forallb_In _ _ _ H0 v Iv). unfold between_two in E.
      destruct (first (has_partner v) _) as [z|] eqn:Ez; [|discriminate]. apply first_in in Ez as Iz.
      apply existsb_exists in E. destruct E as (z' & Iz' & E).
      destruct (partner v z) as [a|] eqn:Pa; [|discriminate]. destruct (partner v z') as [b|] eqn:Pb; [|discriminate].
      apply negb_true_iff in E. apply in_map_iff in Iz, Iz'. destruct Iz as (d & <- & Id). destruct Iz' as (d' & <- & Id').
      apply partner_face in Pa, Pb. destruct Pa as [Ia Fa]. destruct Pb as [Ib Fb].
      exists (inj d), (inj d'), (inj a), (inj b). unfold rds, rrs. rewrite !in_inj. repeat (split; auto).
      intros X. apply inj_injective in X. subst b. rewrite same_vector_refl in E. discriminate. }
    assert (L3 : (3 <= length rrs)%nat) by (unfold rrs; rewrite map_length; auto).
    assert (N := nodup_inj).
    split; [|split; [exact independent_sound|split; [exact orthogonal|split]]].
    - intros u. split.
      + apply (many_spanned K rls rrs rds Hd Hr N L3 Hbelow faces between).
      + apply (in_K K rls rrs (polar_add _) (polar_scal _) (polar_origin _) Hl Hr).
    - apply (many_not_opposite K rrs rds Hd Hbelow between).
    - apply (many_irredundant K rls rrs rds Hd Hl Hr N L3 Hbelow between).
  Qed.

  (* ---- at most two ---- *)
  Let lev := fold_left (fun l d => if forallb (fun r => zdot d r =? 0)%Z rs then d :: l else l) ds [].
  Lemma level_in : forall d, In d lev -> In d ds /\ forall r, In r rs -> zdot d r = 0%Z.
  Proof.
    intros d H. unfold lev in H. rewrite gather, <- in_rev, filter_In in H. destruct H as [Id H]. split; auto.
    intros r Ir. apply Z.eqb_eq. exact (forallb_In _ _ _ H r Ir).
  Qed.
  Lemma level_dot : forall d v, In d (map inj lev) -> In v (rls ++ rrs) -> dot d v = 0.
  Proof.
    intros d v Id Iv. apply in_map_iff in Id. destruct Id as (x & <- & Ix). apply level_in in Ix. destruct Ix as [Ix Zx].
    apply in_app_or in Iv. destruct Iv as [Iv|Iv].
    - apply (level_lineality K rls rds Hd Hl); auto. apply in_map; auto.
    - unfold rrs in Iv. apply in_map_iff in Iv. destruct Iv as (r & <- & Ir). apply dot_zero; auto.
  Qed.
  Lemma level_ds : forall d, In d (map inj lev) -> In d rds.
  Proof. intros d Id. apply in_map_iff in Id. destruct Id as (x & <- & Ix). apply in_map. apply level_in; auto. Qed.

  Lemma bounded_below_sound : forall r others, bounded_below ds r others = true -> exists d, In d rds /\ dot d (inj r) < 0
    /\ forall o, In o (map inj others) -> dot d o = 0.
  Proof.
    intros r others H. unfold bounded_below in H. apply existsb_exists in H. destruct H as (d & Id & H). bsplit.
    exists (inj d). split; [apply in_map; auto|]. split; [rewrite <- dot_inj; apply IZR_lt; auto|].
    intros o Io. apply in_map_iff in Io. destruct Io as (v & <- & Iv). apply dot_zero. apply Z.eqb_eq. exact (forallb_In _ _ _ H0 v Iv).
  Qed.

  (* the vectors listed are independent, if there are two or three *)
  Definition spread (vs : list pt) : Prop :=
    match vs with [u] => u <> origin | [u; v] => cross u v <> origin | [u; v; w] => det u v w <> 0 | _ => False end.

  Lemma span_sound : spread (rls ++ rrs) ->
    (match ls ++ rs with
     | [p] => match lev with [] => false | _ => true end
              && forallb (fun d => existsb (fun d' => 0 <? zdot p (zcross d d'))%Z lev) lev
     | [_; _] => existsb (fun d => existsb (fun d' => zdot d d' <? 0)%Z lev) lev
     | [_; _; _] => true
     | _ => false
     end = true) ->
    forall u, K u -> exists ks, length ks = length (rls ++ rrs) /\ u = combination ks (rls ++ rrs).
  Proof.
    assert (LD := level_dot). assert (LS := level_ds).
    replace (rls ++ rrs) with (map inj (ls ++ rs)) in * by apply map_app.
    destruct (ls ++ rs) as [|a [|b [|c [|]]]]; simpl in *; intros Hs H u Hu; try discriminate.
    - bsplit. destruct (span_one K rds Hd (map inj lev) LS (inj a) u) as (k & ->); auto.
      + destruct lev; [discriminate|simpl; discriminate].
      + intros d Id. apply in_map_iff in Id. destruct Id as (v & <- & Iv).
        assert (E := forallb_In _ _ _ H0 v Iv). simpl in E. apply existsb_exists in E. destruct E as (w & Iw & E). apply Z.ltb_lt,
          IZR_lt in E.
        exists (inj w). split; [apply in_map; auto|]. rewrite <- inj_cross, <- dot_inj. auto.
      + exists [k]. split; auto. simpl. pteq; ring.
    - apply existsb_exists in H. destruct H as (d & Id & H). apply existsb_exists in H. destruct H as (d' & Id' & H).
      apply Z.ltb_lt, IZR_lt in H. rewrite dot_inj in H.
      destruct (span_two K rds Hd (map inj lev) LS (inj a) (inj b) u (inj d) (inj d')) as (j & k & ->); auto.
      + apply in_map; auto.
      + apply in_map; auto.
      + exists [j; k]. split; auto. simpl. pteq; ring.
    - destruct (span_three (inj a) (inj b) (inj c) u Hs) as (i & j & k & ->). exists [i; j; k]. split; auto. simpl. pteq; ring.
  Qed.

  Lemma few_sound : few_rays ls rs ds = true -> generated K rls rrs.
  Proof.
    intros H. unfold few_rays in H. fold lev in H. apply andb_true_iff in H. destruct H as [Hrays Hspan].
    assert (below_ray : forall xs r ys, rrs = xs ++ r :: ys -> exists d, In d rds /\ dot d r < 0 /\ forall o, In o (xs ++ ys) -> dot d
      o = 0).
    { unfold rrs. clear Hspan. intros xs r ys E. destruct rs as [|a [|b [|]]]; try discriminate.
      - destruct xs; discriminate.
      - destruct xs as [|x [|]]; inversion E; subst. apply (bounded_below_sound a []); auto.
      - bsplit. destruct xs as [|x [|x' [|]]]; inversion E; subst.
        + apply (bounded_below_sound a [b]); auto.
        + apply (bounded_below_sound b [a]); auto. }
    assert (nonzero : forall r, In r rrs -> r <> origin).
    { intros r Ir. apply in_split in Ir. destruct Ir as (xs & ys & E). destruct (below_ray xs r ys E) as (d & _ & L & _).
      intros Z. rewrite Z, dot_origin_r in L. lra. }
    assert (Hs : spread (rls ++ rrs)).
    { assert (O := orthogonal). assert (N := nonzero). unfold rls, rrs in *. unfold independent in Hind.
      assert (nz : forall v, negb (is_zero v) = true -> inj v <> origin).
      { intros v E. apply negb_true_iff in E. rewrite inj_zero, <- is_zero_spec. congruence. }
      destruct rs as [|a [|b [|]]]; try discriminate; destruct ls as [|u [|v [|w [|]]]]; try discriminate; simpl in *; auto.
      - rewrite <- inj_cross. auto.
      - rewrite <- det_inj. apply negb_true_iff, Z.eqb_neq in Hind. apply not_0_IZR. auto.
      - apply orthogonal_cross; auto. rewrite dot_comm. auto.
      - replace (det (inj u) (inj v) (inj a)) with (det (inj a) (inj u) (inj v)) by (unfold det, dot, cross; simpl; ring).
        apply orthogonal_det; auto. rewrite <- inj_cross. auto.
      - bsplit. rewrite <- inj_cross. auto.
      - bsplit. apply orthogonal_det; auto; try (rewrite dot_comm; auto). rewrite <- inj_cross. auto. }
    assert (span := span_sound Hs Hspan).
    split; [|split; [exact independent_sound|split; [exact orthogonal|split]]].
    - intros u. split.
      + apply (few_spanned K rls rrs rds Hd Hl below_ray span).
      + apply (in_K K rls rrs (polar_add _) (polar_scal _) (polar_origin _) Hl Hr).
    - apply (few_not_opposite K rrs rds Hd below_ray).
    - apply (few_irredundant K rls rrs rds Hd Hl below_ray).
  Qed.
End Cone.

Theorem cone_sound : forall A B k, cone_ok A B k = true ->
  generated (polar (P (map inj A) (map inj B))) (map inj (lineality k)) (map (fun r => inj (fst r)) (rays k)).
Proof.
  intros A B k H. unfold cone_ok in H. rewrite !each_map in H. apply andb_true_iff in H. destruct H as [H Hcase]. bsplit.
  rename H into Hind, H2 into Hlin, H1 into Hcan, H0 into Hrays.
  rewrite <- (map_map fst inj). set (ls := lineality k) in *. set (rs := map fst (rays k)) in *.
  set (ds := map (difference (numbered A) (numbered B)) (cone.differences k)) in *.
  assert (Hd : forall d u, In d (map inj ds) -> polar (P (map inj A) (map inj B)) u -> dot d u <= 0).
  { intros d u Id Hu. apply in_map_iff in Id. destruct Id as (v & <- & Iv). unfold ds in Iv. apply in_map_iff in Iv.
    destruct Iv as (ji & <- & _). apply difference_polar; auto. }
  assert (Hl : forall l, In l (map inj ls) -> polar (P (map inj A) (map inj B)) l /\ polar (P (map inj A) (map inj B)) (scal (-1) l)).
  { intros l Il. apply in_map_iff in Il. destruct Il as (v & <- & Iv). assert (E := forallb_In _ _ _ Hlin v Iv). simpl in E. bsplit.
    split; [apply level_polar; auto|]. replace (scal (-1) (inj v)) with (inj (zneg v)); [apply level_polar; auto|].
    pteq; rewrite opp_IZR; ring. }
  assert (Hr : forall r, In r (map inj rs) -> polar (P (map inj A) (map inj B)) r).
  { intros r Ir. apply in_map_iff in Ir. destruct Ir as (v & <- & Iv). assert (E := forallb_In _ _ _ Hrays v Iv). simpl in E. bsplit.
    apply level_polar; auto. }
  assert (orth : forall r l, In r (map inj rs) -> In l (map inj ls) -> dot r l = 0).
  { intros r l Ir Il. apply in_map_iff in Ir, Il. destruct Ir as (v & <- & Iv). destruct Il as (w & <- & Iw).
    assert (E := forallb_In _ _ _ Hrays v Iv). simpl in E. bsplit. assert (E := forallb_In _ _ _ H w Iw). simpl in E. bsplit.
    rewrite <- dot_inj, E. auto. }
  assert (distinct : NoDup rs).
  { unfold rs in *. destruct (rays k) as [|d r]; [constructor|]. simpl in Hcan. unfold canonical in Hcan. bsplit.
    apply ascending_nodup in H. apply H. }
  assert (below : forall d r, In d (map inj ds) -> In r (map inj rs) -> dot d r <= 0).
  { intros d r Id Ir. apply Hd; auto. }
  destruct rs as [|a [|b [|c r]]] eqn:E.
  - apply (few_sound A B ls [] ds); auto.
  - apply (few_sound A B ls [a] ds); auto.
  - apply (few_sound A B ls [a; b] ds); auto.
  - apply (many_sound A B ls (a :: b :: c :: r) ds); auto. simpl. lia.
Qed.
