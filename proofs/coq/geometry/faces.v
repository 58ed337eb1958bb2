(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What lies below the planes of all facets lies in the hull of their corners: the face lemma and the line argument.
   No topology is needed. *)
Require Import Reals Lra Psatz List.
From Fathom.checker Require Import sequence.
From Fathom.geometry Require Import meaning space hulls.
Import ListNotations.
Open Scope R_scope.

Lemma cramer_x : forall u v w x, det u v w * px x = det x v w * px u + det u x w * px v + det u v x * px w.
Proof. intros; unfold det, dot, cross; simpl; ring. Qed.
Lemma cramer_y : forall u v w x, det u v w * py x = det x v w * py u + det u x w * py v + det u v x * py w.
Proof. intros; unfold det, dot, cross; simpl; ring. Qed.
Lemma cramer_z : forall u v w x, det u v w * pz x = det x v w * pz u + det u x w * pz v + det u v x * pz w.
Proof. intros; unfold det, dot, cross; simpl; ring. Qed.
Lemma cramer_dot : forall n u v w x, det u v w * dot n x = det x v w * dot n u + det u x w * dot n v + det u v x * dot n w.
Proof. intros; unfold det, dot, cross; simpl; ring. Qed.
Lemma det_cyc : forall u v w, det u v w = det v w u.
Proof. intros; unfold det, dot, cross; simpl; ring. Qed.
Lemma det_swap : forall u v w, det u v w = - det v u w.
Proof. intros; unfold det, dot, cross; simpl; ring. Qed.

(* x on the plane (N,c) through u, v, w; M,m a half-space whose plane passes
   through u, v with w strictly below: then x is not beyond the edge u v *)
Lemma edge_side : forall N c M m u v w x,
  0 < c -> dot N u = c -> dot N v = c -> dot N w = c -> dot N x = c ->
  0 < det u v w -> dot M u = m -> dot M v = m -> dot M w < m -> dot M x <= m ->
  0 <= det u v x.
Proof.
  intros N c M m u v w x Hc Nu Nv Nw Nx D Mu Mv Mw Mx.
  assert (E1 := cramer_dot N u v w x). assert (E2 := cramer_dot M u v w x).
  rewrite Nu, Nv, Nw, Nx in E1. rewrite Mu, Mv in E2.
  assert (E3 : det u v w = det x v w + det u x w + det u v x).
  { apply Rmult_eq_reg_r with c; lra. }
  assert (E4 : det u v x * (m - dot M w) = det u v w * (m - dot M x)) by nra.
  destruct (Rle_dec 0 (det u v x)); auto. exfalso. nra.
Qed.

Section Generic.
  Variable T : Type.                 (* what the checker calls a corner *)
  Variable inj : T -> pt.

  Lemma fan : forall p x r a, r <> [] -> 0 <= det (inj p) (inj a) x ->
    (forall u v, In (u,v) (chain a r p) -> 0 <= det (inj u) (inj v) x) ->
    exists u v, In (u,v) (pairs a r) /\ 0 <= det (inj p) (inj u) x
      /\ det (inj p) (inj v) x <= 0 /\ 0 <= det (inj u) (inj v) x.
  Proof.
    intros p x. induction r as [|b r IH]; intros a Hr Ha He; [congruence|].
    destruct (Rle_dec (det (inj p) (inj b) x) 0) as [L|L].
    - exists a, b. simpl. repeat split; auto. apply He; simpl; auto.
    - destruct r as [|c r].
      + exfalso. assert (H := He b p). simpl in H.
        rewrite det_swap in H. assert (0 <= - det (inj p) (inj b) x) by auto. lra.
      + destruct (IH b) as (u & v & H & H'); [congruence|lra| |].
        * intros u v H. apply He. simpl in *. tauto.
        * exists u, v. split; auto. simpl in *. tauto.
  Qed.

  (* a facet in the plane (N,c) with corner cycle p::a::r: what lies on the
     plane and on no wrong side of an edge is in the hull of the corners *)
  Lemma polygon : forall (S : pt -> Prop) N c p a r x,
    0 < c -> r <> [] ->
    (forall v, In v (p :: a :: r) -> dot N (inj v) = c /\ hull S (inj v)) ->
    dot N x = c ->
    (forall u v, In (u,v) (pairs a r) -> 0 < det (inj p) (inj u) (inj v)) ->
    (forall u v, In (u,v) (chain p (a :: r) p) -> 0 <= det (inj u) (inj v) x) ->
    hull S x.
  Proof.
    intros S N c p a r x Hc Hr Hin Nx Hfan Hedge.
    destruct (fan p x r a) as (u & v & Huv & A & B & C); auto.
    - apply Hedge. simpl. auto.
    - intros u v H. apply Hedge. simpl. auto.
    - assert (D := Hfan _ _ Huv). apply pairs_members in Huv. destruct Huv as [Iu Iv].
      destruct (Hin p) as [Np Hp]; [simpl; auto|].
      destruct (Hin u) as [Nu Hu]; [simpl in *; tauto|].
      destruct (Hin v) as [Nv Hv]; [simpl in *; tauto|].
      assert (E := cramer_dot N (inj p) (inj u) (inj v) x). rewrite Np, Nu, Nv, Nx in E.
      apply (hull3 S (inj p) (inj u) (inj v) x (det x (inj u) (inj v)) (det (inj p) x (inj v))
               (det (inj p) (inj u) x) (det (inj p) (inj u) (inj v))); auto.
      + rewrite det_cyc. auto.
      + replace (det (inj p) x (inj v)) with (- det (inj p) (inj v) x) by (unfold det, dot, cross; simpl; ring). lra.
      + apply Rmult_eq_reg_r with c; lra.
      + apply cramer_x. + apply cramer_y. + apply cramer_z.
  Qed.
End Generic.

Section Poly.
  Variable F : Type.
  Variable nrm : F -> pt.
  Variable off : F -> R.
  Definition below (Fs : list F) (x : pt) : Prop := forall f, In f Fs -> dot (nrm f) x <= off f.

  (* how far one can go from t along d *)
  Lemma ray : forall Fs t d, below Fs t ->
    (forall f, In f Fs -> dot (nrm f) d <= 0) \/
    exists s, 0 <= s /\ below Fs (add t (scal s d))
      /\ exists f, In f Fs /\ 0 < dot (nrm f) d /\ dot (nrm f) (add t (scal s d)) = off f.
  Proof.
    assert (E : forall f t d s, dot (nrm f) (add t (scal s d)) = dot (nrm f) t + s * dot (nrm f) d)
      by (intros; unfold dot; simpl; ring).
    intros Fs t d. induction Fs as [|f Fs IH]; intros H; [left; simpl; tauto|].
    assert (Hf : dot (nrm f) t <= off f) by (apply H; simpl; auto).
    assert (HF : below Fs t) by (intros g Hg; apply H; simpl; auto).
    set (s0 := (off f - dot (nrm f) t) / dot (nrm f) d).
    destruct (Rle_dec (dot (nrm f) d) 0) as [L|L].
    - destruct (IH HF) as [IH1 | (s & S0 & S1 & g & G1 & G3 & G2)].
      + left. intros g [G|G]; subst; auto.
      + right. exists s. repeat split; auto.
        * intros h [G|G]; subst; auto. rewrite E. nra.
        * exists g; simpl; auto.
    - assert (P0 : 0 < dot (nrm f) d) by lra.
      assert (E0 : s0 * dot (nrm f) d = off f - dot (nrm f) t) by (unfold s0; field; lra).
      assert (S0 : 0 <= s0).
      { unfold s0. apply Rmult_le_pos; [lra|]. left. apply Rinv_0_lt_compat; auto. }
      assert (Hself : dot (nrm f) (add t (scal s0 d)) = off f) by (rewrite E; lra).
      right. destruct (IH HF) as [IH1 | (s & S1 & S2 & g & G1 & G3 & G2)].
      + exists s0. repeat split; auto.
        * intros h [G|G]; subst; [lra|]. rewrite E. specialize (IH1 _ G). specialize (HF _ G). nra.
        * exists f; simpl; auto.
      + destruct (Rle_dec s s0) as [C|C].
        * exists s. repeat split; auto.
          -- intros h [G|G]; subst; auto. rewrite E. nra.
          -- exists g; simpl; auto.
        * exists s0. repeat split; auto.
          -- intros h [G|G]; subst; [lra|]. specialize (S2 _ G). specialize (HF _ G).
             rewrite E in *. destruct (Rle_dec (dot (nrm h) d) 0); nra.
          -- exists f; simpl; auto.
  Qed.

  (* if every face of the polyhedron is in the hull and some direction is
     bounded both ways, the whole polyhedron is in the hull *)
  Lemma poly_in_hull : forall (S : pt -> Prop) Fs d f1 f2,
    In f1 Fs -> 0 < dot (nrm f1) d -> In f2 Fs -> dot (nrm f2) d < 0 ->
    (forall f x, In f Fs -> below Fs x -> dot (nrm f) x = off f -> hull S x) ->
    forall t, below Fs t -> hull S t.
  Proof.
    intros S Fs d f1 f2 I1 D1 I2 D2 Hface t Ht.
    destruct (ray Fs t d Ht) as [C | (s & S0 & S1 & g & G1 & G3 & G2)].
    { specialize (C _ I1). lra. }
    destruct (ray Fs t (scal (-1) d) Ht) as [C | (s' & S0' & S1' & g' & G1' & _ & G2')].
    { specialize (C _ I2). unfold dot in *. simpl in C. lra. }
    assert (X := Hface _ _ G1 S1 G2). assert (X' := Hface _ _ G1' S1' G2').
    destruct (Req_dec s 0) as [Z|Z].
    - subst s. replace t with (add t (scal 0 d)); auto. pteq; ring.
    - apply (hull_seg S _ _ t s' s X X'); simpl; try lra.
  Qed.

End Poly.
