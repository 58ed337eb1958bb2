(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The facets of the hull of a finite list that spans space: it is the intersection of their half-spaces. *)
Require Import Reals Lra Psatz List.
From Fathom.geometry Require Import meaning space hulls faces farkas flats.
Import ListNotations.
Open Scope R_scope.

(* ---- facets ---- *)
(* (n, h) is the plane of a facet of conv L, through u, v, w *)
Definition facet_plane (L : list pt) (u v w n : pt) (h : R) : Prop :=
  In u L /\ In v L /\ In w L /\ dot n u = h /\ dot n v = h /\ dot n w = h
  /\ cross (sub v u) (sub w u) <> origin /\ n <> origin /\ forall s, In s L -> dot n s <= h.

Section Separate.
  Variables (L : list pt) (x : pt).
  Hypothesis HL : spanning L.
  Let under := below pt (fun s => sub s x) (fun _ => -1) L.

  Lemma off_plane : forall d, d <> origin -> exists s, In s L /\ dot (sub s x) d <> 0.
  Proof.
    intros d Hd. destruct (some_or_none _ (fun s => dot (sub s x) d) L) as [F|F]; auto.
    exfalso. destruct HL as (a & b & c & e & Ia & Ib & Ic & Ie & D). apply D. apply (det_flat d); auto.
    - replace (sub b a) with (sub (sub b x) (sub a x)) by (pteq; ring).
      rewrite dot_comm, dot_sub_r, !(dot_comm d), !F; auto; ring.
    - replace (sub c a) with (sub (sub c x) (sub a x)) by (pteq; ring).
      rewrite dot_comm, dot_sub_r, !(dot_comm d), !F; auto; ring.
    - replace (sub e a) with (sub (sub e x) (sub a x)) by (pteq; ring).
      rewrite dot_comm, dot_sub_r, !(dot_comm d), !F; auto; ring.
  Qed.

  (* move n along d or against it, until a further point is on the plane *)
  Lemma move : forall n d, under n -> d <> origin ->
    exists k s, under (add n (scal k d)) /\ In s L /\ dot (sub s x) d <> 0 /\ dot (sub s x) (add n (scal k d)) = -1.
  Proof.
    intros n d Hn Hd.
    destruct (ray _ _ _ L n d Hn) as [C|(k & _ & K1 & s & Is & S1 & S2)].
    2:{ exists k, s. repeat split; auto. lra. }
    destruct (ray _ _ _ L n (scal (-1) d) Hn) as [C'|(k & _ & K1 & s & Is & S1 & S2)].
    - exfalso. destruct (off_plane d Hd) as (s & Is & S). apply S.
      specialize (C s Is). specialize (C' s Is). rewrite dot_scal_r in C'. lra.
    - exists (- k), s. rewrite dot_scal_r in S1.
      replace (add n (scal (- k) d)) with (add n (scal k (scal (-1) d))) by (pteq; ring).
      repeat split; auto. lra.
  Qed.

  Lemma plane_on_three : forall n, under n -> exists m u v w,
    under m /\ In u L /\ In v L /\ In w L /\ dot (sub u x) m = -1 /\ dot (sub v x) m = -1 /\ dot (sub w x) m = -1
    /\ det (sub u x) (sub v x) (sub w x) <> 0.
  Proof.
    intros n Hn.
    destruct (move n (mk 1 0 0) Hn) as (k1 & u & N1 & Iu & _ & U1). { intros F; inversion F; lra. }
    set (n1 := add n (scal k1 (mk 1 0 0))) in *.
    assert (Hu : sub u x <> origin).
    { intros E. rewrite E in U1. unfold dot in U1; simpl in U1. lra. }
    destruct (perpendicular (sub u x)) as (d & Hd & Ed).
    destruct (move n1 d N1 Hd) as (k2 & v & N2 & Iv & V & V2).
    set (n2 := add n1 (scal k2 d)) in *.
    assert (U2 : dot (sub u x) n2 = -1) by (unfold n2; rewrite dot_add_r, dot_scal_r, Ed, U1; ring).
    set (c := cross (sub u x) (sub v x)).
    assert (Hc : c <> origin).
    { apply (perp_not_parallel d); auto; [rewrite dot_comm; auto|rewrite dot_comm; auto]. }
    destruct (move n2 c N2 Hc) as (k3 & w & N3 & Iw & W & W3).
    set (n3 := add n2 (scal k3 c)) in *.
    exists n3, u, v, w. repeat split; auto.
    - unfold n3. rewrite dot_add_r, dot_scal_r, U2.
      replace (dot (sub u x) c) with 0 by (unfold c, dot, cross; simpl; ring). ring.
    - unfold n3. rewrite dot_add_r, dot_scal_r, V2.
      replace (dot (sub v x) c) with 0 by (unfold c, dot, cross; simpl; ring). ring.
    - intros E. apply W. rewrite <- E. unfold c, det, dot, cross; simpl; ring.
  Qed.

  Lemma conv_or_beyond_facet : conv L x \/ exists u v w n h, facet_plane L u v w n h /\ h < dot n x.
  Proof.
    destruct (conv_or_separated L x) as [C|(n0 & S)]; auto. right.
    destruct (all_or_some _ (fun _ => False) (fun s e => dot n0 (sub s x) <= - e) L) as [(y & _ & [])|(e & He & G)].
    { intros; lra. }
    { intros s Hs. right. exists (- dot n0 (sub s x)). rewrite dot_sub_r. specialize (S s Hs). lra. }
    assert (Hn : under (scal (/ e) n0)).
    { intros s Hs. rewrite dot_scal_r, dot_comm. specialize (G s Hs).
      apply Rmult_le_reg_l with e; auto. rewrite <- Rmult_assoc, Rinv_r by lra. lra. }
    destruct (plane_on_three _ Hn) as (m & u & v & w & Hm & Iu & Iv & Iw & U & V & W & D).
    exists u, v, w, m, (dot m x - 1).
    assert (on : forall s, dot (sub s x) m = -1 -> dot m s = dot m x - 1).
    { intros s E. rewrite dot_comm, dot_sub_r in E. lra. }
    split; [|lra]. repeat split; auto.
    - intros E. apply D.
      replace (det (sub u x) (sub v x) (sub w x)) with (dot (sub u x) (cross (sub v u) (sub w u)))
        by (unfold det, dot, cross; simpl; ring).
      rewrite E. unfold dot; simpl; ring.
    - intros E. rewrite E in U. unfold dot in U; simpl in U. lra.
    - intros s Hs. assert (B := Hm s Hs). simpl in B. rewrite dot_comm, dot_sub_r in B. lra.
  Qed.
End Separate.

(* a facet's normal is a multiple of the cross product of two of its edges *)
Lemma facet_normal : forall L u v w n h, facet_plane L u v w n h ->
  exists k, k <> 0 /\ cross (sub v u) (sub w u) = scal k n.
Proof.
  intros L u v w n h (_ & _ & _ & U & V & W & Hc & Hn & _).
  set (a := sub v u) in *. set (b := sub w u) in *.
  assert (A : dot n a = 0) by (unfold a; rewrite dot_sub_r; lra).
  assert (B : dot n b = 0) by (unfold b; rewrite dot_sub_r; lra).
  assert (C : cross n (cross a b) = origin).
  { replace (cross n (cross a b)) with (sub (scal (dot n b) a) (scal (dot n a) b))
      by (unfold dot; pteq; ring). rewrite A, B. pteq; ring. }
  exists (dot (cross a b) n / norm2 n). assert (E := parallel n (cross a b) C Hn). split; auto.
  intros Z. apply Hc. rewrite E, Z. pteq; ring.
Qed.

(* ---- there are finitely many ---- *)
Lemma pt_dec : forall a b : pt, {a = b} + {a <> b}.
Proof.
  intros [a b c] [a' b' c']. destruct (Req_EM_T a a'), (Req_EM_T b b'), (Req_EM_T c c'); subst; auto;
    right; intros E; inversion E; auto.
Qed.

Lemma facet_plane_dec : forall L u v w n h, facet_plane L u v w n h \/ ~ facet_plane L u v w n h.
Proof.
  intros. unfold facet_plane.
  destruct (in_dec pt_dec u L); [|right; tauto]. destruct (in_dec pt_dec v L); [|right; tauto].
  destruct (in_dec pt_dec w L); [|right; tauto].
  destruct (Req_dec (dot n u) h); [|right; tauto]. destruct (Req_dec (dot n v) h); [|right; tauto].
  destruct (Req_dec (dot n w) h); [|right; tauto].
  destruct (origin_dec (cross (sub v u) (sub w u))); [right; tauto|].
  destruct (origin_dec n); [right; tauto|].
  destruct (all_le_dec (fun s => dot n s) h L) as [A|(s & Is & A)]; [left; tauto|].
  right. intros (_ & _ & _ & _ & _ & _ & _ & _ & B). specialize (B s Is). lra.
Qed.

Lemma facet_plane_scal : forall L u v w n h k, 0 < k -> facet_plane L u v w n h -> facet_plane L u v w (scal k n) (k * h).
Proof.
  intros L u v w n h k Hk (Iu & Iv & Iw & U & V & W & Hc & Hn & Hb).
  unfold facet_plane. rewrite !dot_scal_l, U, V, W. repeat split; auto.
  - apply norm2_pos_inv. rewrite norm2_scal. assert (N := norm2_pos _ Hn). repeat apply Rmult_lt_0_compat; auto.
  - intros q Hq. rewrite dot_scal_l. specialize (Hb q Hq). nra.
Qed.

Definition is_facet (L : list pt) (f : pt * R) : Prop := exists u v w, facet_plane L u v w (fst f) (snd f).

Theorem finite_facets : forall L, spanning L -> exists F : list (pt * R),
  (forall f, In f F -> is_facet L f) /\ forall x, conv L x \/ exists f, In f F /\ snd f < dot (fst f) x.
Proof.
  intros L HL.
  (* all candidates: the planes through three points, with either sense *)
  set (plane := fun x : bool * (pt * (pt * pt)) => let '(side, (u, (v, w))) := x in
    let n := scal (if side then 1 else -1) (cross (sub v u) (sub w u)) in (n, dot n u)).
  set (facet := fun x : bool * (pt * (pt * pt)) => let '(side, (u, (v, w))) := x in
    facet_plane L u v w (fst (plane x)) (snd (plane x))).
  set (all := list_prod [true; false] (list_prod L (list_prod L L))).
  destruct (keep _ facet all) as (F & F1 & F2).
  { intros (side, (u, (v, w))). apply facet_plane_dec. }
  exists (map plane F). split.
  - intros f Hf. apply in_map_iff in Hf. destruct Hf as (x & <- & Hx). specialize (F1 x Hx).
    destruct x as (side, (u, (v, w))). exists u, v, w. exact F1.
  - intros x. destruct (conv_or_beyond_facet L x HL) as [C|(u & v & w & n & h & Hf & B)]; auto. right.
    destruct (facet_normal _ _ _ _ _ _ Hf) as (k & Hk & Ek).
    set (side := if Rlt_dec 0 k then true else false).
    set (y := (side, (u, (v, w)))).
    assert (M : exists m, 0 < m /\ fst (plane y) = scal m n).
    { unfold y, side. simpl. rewrite Ek. destruct (Rlt_dec 0 k).
      - exists k. split; auto. pteq; ring.
      - exists (- k). split; [lra|]. pteq; ring. }
    destruct M as (m & Hm & Em).
    assert (Eh : snd (plane y) = m * h).
    { change (snd (plane y)) with (dot (fst (plane y)) u). rewrite Em, dot_scal_l.
      destruct Hf as (_ & _ & _ & U & _). rewrite U. auto. }
    assert (Hy : In (plane y) (map plane F)).
    { apply in_map. apply F2.
      - destruct Hf as (Iu & Iv & Iw & _). unfold all, y. apply in_prod; [|repeat apply in_prod; auto].
        unfold side. destruct (Rlt_dec 0 k); simpl; auto.
      - change (facet_plane L u v w (fst (plane y)) (snd (plane y))). rewrite Em, Eh. apply facet_plane_scal; auto. }
    exists (plane y). split; auto. rewrite Em, Eh, dot_scal_l. nra.
Qed.

(* near t, <n,.> stays below h *)
Lemma stays_below : forall n h t, dot n t < h ->
  exists e, 0 < e /\ forall s, norm2 (sub s t) < e * e -> dot n s <= h.
Proof.
  intros n h t H. assert (N := norm2_nonneg n).
  set (g := h - dot n t). exists (g / (1 + norm2 n)).
  assert (Hg : 0 < g) by (unfold g; lra).
  set (e := g / (1 + norm2 n)). assert (He : 0 < e) by (apply Rdiv_lt_0_compat; lra).
  assert (Ee : g = e * (1 + norm2 n)) by (unfold e; field; lra).
  split; auto. intros s Hs.
  destruct (Rle_dec (dot n s) h) as [C|C]; auto. exfalso.
  assert (B : g < dot n (sub s t)) by (rewrite dot_sub_r; unfold g; lra).
  assert (K := cauchy n (sub s t)). assert (M := norm2_nonneg (sub s t)).
  assert (K1 : g * g < dot n (sub s t) * dot n (sub s t)) by nra.
  assert (K2 : norm2 n * norm2 (sub s t) <= norm2 n * (e * e)) by nra.
  assert (K3 : g * g = e * e * (1 + 2 * norm2 n + norm2 n * norm2 n)) by (rewrite Ee; ring).
  assert (0 < e * e) by nra. nra.
Qed.

Lemma interior_or_facet : forall L F,
  (forall x, conv L x \/ exists f, In f F /\ snd f < dot (fst f) x) ->
  forall t, interior (conv L) t \/ exists f, In f F /\ snd f <= dot (fst f) t.
Proof.
  intros L F HF t.
  destruct (all_or_some _ (fun f => snd f <= dot (fst f) t)
    (fun f e => forall s, norm2 (sub s t) < e * e -> dot (fst f) s <= snd f) F) as [B|(e & He & G)]; auto.
  - intros f e e' He H s Hs. apply H. nra.
  - intros f _. destruct (Rle_dec (snd f) (dot (fst f) t)) as [C|C]; auto. right. apply stays_below. lra.
  - left. exists e. split; auto. intros s Hs.
    destruct (HF s) as [C|(f & If & B)]; auto. exfalso. specialize (G f If s Hs). lra.
Qed.
