(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The lower side: an accepted inner polytope is inside P, and the ball is inside it. *)
Require Import Reals Lra Psatz List ZArith Lia Bool.
From Fathom.checker Require Import vector sequence table polytope.
From Fathom.geometry Require Import meaning space hulls faces flats facets difference depth.
From Fathom.soundness Require Import statement booleans.
Import ListNotations.

(* of any polytope whose facets' corners are points of S *)
Section Polytope.
  Variables (qn qd : Z) (S : pt -> Prop).
  Hypothesis Hqd : (0 < qd)%Z.
  Let q := (IZR qn / IZR qd)%R.
  Let nrm (f : facet) := inj (normal f).
  Let off (f : facet) := IZR (offset f).
  Open Scope R_scope.

  (* what the check of a facet says: of the corners; of the points of its plane below all planes, which lie on no wrong side of an edge *)
  Lemma facet_parts : forall Fs f, facet_ok qn qd (numbered Fs) f = true -> In f Fs ->
    exists p a b r, corners f = p :: a :: b :: r /\ 0 < off f /\ q * norm2 (nrm f) <= off f * off f
    /\ (forall v, In v (corners f) -> dot (nrm f) (inj (fst v)) = off f)
    /\ (forall u v, In (u, v) (pairs a (b :: r)) -> 0 < det (inj (fst p)) (inj (fst u)) (inj (fst v)))
    /\ forall u v x, In (u, v) (chain p (a :: b :: r) p) -> below _ nrm off Fs x -> dot (nrm f) x = off f ->
         0 <= det (inj (fst u)) (inj (fst v)) x.
  Proof.
    intros Fs f H Hf. unfold facet_ok in H.
    destruct (corners f) as [|p [|a [|b r]]] eqn:Ecorners; try discriminate.
    bsplit. rename H0 into Hedge, H1 into Hfan, H2 into Hplane, H3 into Hfar. exists p, a, b, r. split; auto.
    assert (Hc : 0 < off f) by (apply IZR_lt; auto).
    assert (Rqd : 0 < IZR qd) by (apply IZR_lt; auto).
    assert (Hplane' : forall v, In v (p :: a :: b :: r) -> dot (nrm f) (inj (fst v)) = off f).
    { intros v Hv. unfold nrm, off. rewrite <- dot_inj. f_equal. apply Z.eqb_eq. exact (forallb_In _ _ _ Hplane v Hv). }
    split; auto. split; [|split; [exact Hplane'|split]].
    - apply IZR_le in Hfar. rewrite !mult_IZR, norm2_inj in Hfar. fold (nrm f) (off f) in Hfar.
      apply Rmult_le_reg_r with (IZR qd); auto. unfold q.
      replace (IZR qn / IZR qd * norm2 (nrm f) * IZR qd) with (IZR qn * norm2 (nrm f)) by (field; lra). lra.
    - intros u v Huv. rewrite <- det_inj. apply IZR_lt, Z.ltb_lt. exact (along_pairs_spec _ _ _ _ Hfan _ _ Huv).
    - intros u v x Huv Hx Nx. assert (E := along_chain_spec _ _ _ _ _ Hedge _ _ Huv). unfold edge_ok in E.
      set (g := match member (numbered Fs) (snd u) with Some g => g | None => f end) in *.
      assert (Hg : In g Fs).
      { unfold g. destruct (member (numbered Fs) (snd u)) as [g0|] eqn:Eg; auto. apply member_in in Eg. auto. }
      bsplit. rename x0 into w.
      apply chain_members in Huv. destruct Huv as [Iu Iv].
      assert (Iv' : In v (p :: a :: b :: r)) by (destruct Iv as [Iv| ->]; simpl in *; tauto).
      apply (edge_side (nrm f) (off f) (nrm g) (off g) (inj (fst u)) (inj (fst v)) (inj (fst w)) x); auto.
      + apply Hplane'. rewrite <- Ecorners. auto.
      + rewrite <- det_inj. apply IZR_lt; auto.
      + unfold nrm, off. rewrite <- dot_inj. f_equal; auto.
      + unfold nrm, off. rewrite <- dot_inj. f_equal; auto.
      + unfold nrm, off. rewrite <- dot_inj. apply IZR_lt; auto.
  Qed.

  Lemma facet_sound : forall Fs f, In f Fs ->
    (forall x, In x (corners f) -> fst x = zzero \/ S (inj (fst x))) ->
    facet_ok qn qd (numbered Fs) f = true ->
    (0 < off f /\ q * norm2 (nrm f) <= off f * off f)
    /\ forall x, below _ nrm off Fs x -> dot (nrm f) x = off f -> hull S x.
  Proof.
    intros Fs f Hf Hin H. destruct (facet_parts Fs f H Hf) as (p & a & b & r & E & Hc & Hfar & Hplane & Hfan & Hedge). split; auto.
    rewrite E in Hplane, Hin. intros x Hx Nx.
    apply (polygon corner (fun v => inj (fst v)) S (nrm f) (off f) p a (b :: r)); auto; [congruence|].
    intros v Hv. split; auto. apply hull_in. destruct (Hin v Hv) as [Z|Z]; auto.
    exfalso. specialize (Hplane v Hv). rewrite Z in Hplane. unfold dot in Hplane; simpl in Hplane. lra.
  Qed.

  Variable Fs : list facet.
  Hypothesis Hin : forall f x, In f Fs -> In x (corners f) -> fst x = zzero \/ S (inj (fst x)).
  Hypothesis Hok : inner_ok qn qd Fs = true.

  Lemma facet_beyond : forall f, In f Fs -> 0 < off f /\ q * norm2 (nrm f) <= off f * off f.
  Proof.
    intros f Hf. unfold inner_ok in Hok. bsplit. apply (facet_sound Fs); auto; [intros x; apply Hin; auto|].
    exact (forallb_In _ _ _ H0 f Hf).
  Qed.

  (* what lies below all planes is in the hull *)
  Lemma below_in_hull : forall x, below _ nrm off Fs x -> hull S x.
  Proof.
    intros x Hx. assert (H := Hok). unfold inner_ok in H. apply andb_true_iff in H. destruct H as [H Hall].
    unfold bounded in H. destruct Fs as [|f0 Fs']; [discriminate|]. bsplit. rename x0 into g.
    apply (poly_in_hull _ nrm off S (f0 :: Fs') (nrm f0) f0 g); auto.
    - simpl; auto.
    - unfold nrm. rewrite <- dot_inj. apply IZR_lt; auto.
    - unfold nrm. rewrite <- dot_inj. apply IZR_lt; auto.
    - intros f y Hf. apply facet_sound; auto. { intros c. apply Hin. auto. } exact (forallb_In _ _ _ Hall f Hf).
  Qed.

  Lemma inside_or_beyond : forall t, interior (hull S) t \/ exists f, In f Fs /\ off f <= dot (nrm f) t.
  Proof.
    intros t.
    destruct (all_or_some _ (fun f => off f <= dot (nrm f) t)
      (fun f e => forall s, norm2 (sub s t) < e * e -> dot (nrm f) s <= off f) Fs) as [T|(e & He & G)]; auto.
    - intros f e e' He H s Hs. apply H. nra.
    - intros f _. destruct (Rle_dec (off f) (dot (nrm f) t)) as [C|C]; auto. right. apply stays_below. lra.
    - left. exists e. split; auto. intros s Hs. apply below_in_hull. intros f Hf. apply G; auto.
  Qed.
End Polytope.

Section Lower.
  Variables (A B : list zvec) (qn qd : Z).
  Hypothesis Hqd : (0 < qd)%Z.
  Let S := diffs (map inj A) (map inj B).
  Let q := (IZR qn / IZR qd)%R.
  Let nrm (f : facet) := inj (normal f).
  Let off (f : facet) := IZR (offset f).

  Lemma difference_in : forall ji,
    difference (numbered A) (numbered B) ji = zzero \/ S (inj (difference (numbered A) (numbered B) ji)).
  Proof.
    intros [j i]. unfold difference; simpl.
    destruct (member (numbered B) j) as [b|] eqn:EB; auto.
    destruct (member (numbered A) i) as [a|] eqn:EA; auto.
    right. apply member_in in EA. apply member_in in EB.
    exists (inj a), (inj b). rewrite inj_sub. repeat split; auto; apply in_map; auto.
  Qed.

  (* a corner is a point of P, or O where the file names no such point *)
  Lemma corner_in : forall V F f x, In f (make_facets A B V F) -> In x (corners f) -> fst x = zzero \/ S (inj (fst x)).
  Proof.
    intros V F f x Hf Hx. unfold make_facets in Hf. rewrite !each_map in Hf.
    apply in_map_iff in Hf. destruct Hf as (l & <- & _). simpl in Hx. rewrite each_map in Hx.
    apply in_map_iff in Hx. destruct Hx as ([v g] & <- & _). simpl.
    destruct (member _ v) as [p|] eqn:E; auto.
    apply member_in in E. apply in_map_iff in E. destruct E as (ji & <- & _). apply difference_in.
  Qed.

  Open Scope R_scope.

  Section Accepted.
    Variables (V : list (N * N)) (F : list (list (N * N))).
    Let Fs := make_facets A B V F.
    Hypothesis Hok : inner_ok qn qd Fs = true.

    Lemma facet_far : forall f, In f Fs -> 0 < off f /\ q * norm2 (nrm f) <= off f * off f.
    Proof. apply (facet_beyond qn qd S Hqd Fs); auto. intros f x. apply (corner_in V F). Qed.

    Lemma interior_or_tight : forall t, interior (P (map inj A) (map inj B)) t \/ exists f, In f Fs /\ off f <= dot (nrm f) t.
    Proof. apply (inside_or_beyond qn qd S Hqd Fs); auto. intros f x. apply (corner_in V F). Qed.

    Lemma origin_interior : interior (P (map inj A) (map inj B)) origin.
    Proof.
      destruct (interior_or_tight origin) as [I|(f & If & G)]; auto. exfalso.
      destruct (facet_far f If) as [Hc _]. replace (dot (nrm f) origin) with 0 in G by (unfold dot, origin; simpl; ring). lra.
    Qed.

    Lemma tight_nonzero : forall f t, In f Fs -> off f <= dot (nrm f) t -> nrm f <> origin.
    Proof.
      intros f t If G E. destruct (facet_far f If) as [Hc _]. rewrite E in G. unfold dot, origin in G; simpl in G. lra.
    Qed.

    Lemma lower_sound : forall t, norm2 t < q -> interior (P (map inj A) (map inj B)) t.
    Proof.
      intros t Ht. destruct (interior_or_tight t) as [I|(f & If & G)]; auto. exfalso.
      assert (Hn := tight_nonzero f t If G). destruct (facet_far f If) as [Hc Hf].
      assert (R := beyond_ratio _ _ _ Hn Hc G). apply ratio_le in Hf; [|apply norm2_pos; auto]. lra.
    Qed.

    (* a point at the ball's distance that is not interior is the foot point of a facet of Q *)
    Lemma tight_facet : forall t, norm2 t = q -> ~ interior (P (map inj A) (map inj B)) t ->
      exists f, In f Fs /\ nrm f <> origin /\ 0 < off f /\ off f * off f = q * norm2 (nrm f)
        /\ t = scal (off f / norm2 (nrm f)) (nrm f).
    Proof.
      intros t Ht NI. destruct (interior_or_tight t) as [I|(f & If & G)]; [contradiction|].
      assert (Hn := tight_nonzero f t If G). destruct (facet_far f If) as [Hc Hf].
      destruct (foot_only _ _ _ _ Hn Hc Ht Hf G) as [E1 E2]. exists f. auto.
    Qed.
  End Accepted.
End Lower.
