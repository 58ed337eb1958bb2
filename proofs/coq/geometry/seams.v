(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A common face of two pieces is no gap in their union: the interiors of two unions meet exactly if those of two pieces do. *)
Require Import Reals Lra Psatz List.
From Fathom.geometry Require Import meaning space hulls flats facets norm difference solid wording unions.
Import ListNotations.
Open Scope R_scope.

(* ---- open balls ---- *)
Lemma ball_in_ball : forall p s e, 0 < e -> norm2 (sub s p) < e * e ->
  exists d, 0 < d /\ forall x, norm2 (sub x s) < d * d -> norm2 (sub x p) < e * e.
Proof.
  intros p s e He H. apply norm_lt in H; [|lra]. exists (e - norm (sub s p)). split; [lra|]. intros x Hx.
  apply norm_lt in Hx; [|lra]. apply norm_lt; [lra|]. assert (T := norm_triangle (sub x s) (sub s p)).
  replace (add (sub x s) (sub s p)) with (sub x p) in T by (pteq; ring). lra.
Qed.

Lemma interior_near : forall (S : pt -> Prop) p e s, 0 < e -> (forall x, norm2 (sub x p) < e * e -> S x) -> norm2 (sub s p) < e * e ->
  interior S s.
Proof. intros S p e s He H Hs. destruct (ball_in_ball p s e He Hs) as (d & Hd & G). exists d. auto. Qed.

Lemma interior_translate : forall S t p, interior (translate S t) p <-> interior S (sub p t).
Proof.
  intros S t p. unfold translate. split; intros (e & He & H); exists e; split; auto; intros s Hs.
  - replace s with (sub (add s t) t) by (pteq; ring). apply H. replace (sub (add s t) p) with (sub s (sub p t)) by (pteq; ring). auto.
  - apply H. replace (sub (sub s t) (sub p t)) with (sub s p) by (pteq; ring). auto.
Qed.

(* a step from a point of a convex set towards an interior one *)
Lemma step_inside : forall S p g k, convex S -> S p -> interior S g -> 0 < k <= 1 -> interior S (add p (scal k (sub g p))).
Proof.
  intros S p g k C Hp (e & He & H) Hk. exists (k * e). split; [apply Rmult_lt_0_compat; lra|]. intros s Hs.
  set (x := add p (scal k (sub g p))) in *. set (a := add g (scal (/ k) (sub s x))).
  assert (Ha : S a).
  { apply H. replace (sub a g) with (scal (/ k) (sub s x)) by (pteq; ring). rewrite norm2_scal.
    apply Rmult_lt_reg_l with (k * k); [apply Rmult_lt_0_compat; lra|].
    replace (k * k * (/ k * / k * norm2 (sub s x))) with (norm2 (sub s x)) by (field; lra). lra. }
  replace s with (add (scal k a) (scal (1 - k) p)); [apply C; auto; lra|].
  unfold a, x. pteq; field; lra.
Qed.

(* an interior point of S that is in a convex T with an interior: some point is interior to both *)
Lemma common_interior : forall S T p g, convex T -> interior S p -> T p -> interior T g ->
  exists x, interior S x /\ interior T x.
Proof.
  intros S T p g C (d & Hd & H) Hp Hg. set (N := norm (sub g p)). assert (PN : 0 <= N) by apply norm_nonneg.
  set (k := d / (d + N)). assert (Ek : k * (d + N) = d) by (unfold k; field; lra).
  assert (Pk : 0 < k) by (apply Rdiv_lt_0_compat; lra). assert (Lk : k <= 1) by nra.
  exists (add p (scal k (sub g p))). split; [|apply step_inside; auto].
  apply (interior_near _ p d); auto. replace (sub (add p (scal k (sub g p))) p) with (scal k (sub g p)) by (pteq; ring).
  apply norm_lt; [lra|]. rewrite norm_scal by lra. fold N. nra.
Qed.

(* ---- two pieces ---- *)
Theorem pair_interiors : forall A B t, (exists p, interior (conv A) p) -> (exists p, interior (conv B) p) ->
  (interior (P A B) t <-> exists p, interior (translate (conv A) t) p /\ interior (conv B) p).
Proof.
  intros A B t HA (g & Hg).
  assert (NB : B <> []).
  { intros ->. apply interior_in in Hg. apply (Hg (fun _ => False)); [intros u v l _ []|simpl; tauto]. }
  rewrite <- meets_interior; auto. split.
  - intros (p & HAp & Hp). apply (common_interior _ _ p g); auto. apply hull_convex.
  - intros (p & HAp & HBp). exists p. split; auto. apply interior_in. auto.
Qed.

(* ---- a point off finitely many planes ---- *)
Definition off (F : list (pt * R)) (x : pt) : Prop := forall f, In f F -> dot (fst f) x <> snd f.

Lemma stays_off : forall n c s, dot n s <> c -> exists e, 0 < e /\ forall x, norm2 (sub x s) < e * e -> dot n x <> c.
Proof.
  intros n c s H. destruct (Rlt_dec (dot n s) c) as [L|L].
  - destruct (stays_below n ((dot n s + c) / 2) s) as (e & He & G); [lra|]. exists e. split; auto. intros x Hx. specialize (G x Hx). lra.
  - destruct (stays_below (scal (-1) n) (- ((dot n s + c) / 2)) s) as (e & He & G); [rewrite dot_scal_l; lra|].
    exists e. split; auto. intros x Hx. specialize (G x Hx). rewrite dot_scal_l in G. lra.
Qed.

Lemma point_off : forall F p e, 0 < e -> (forall f, In f F -> fst f <> origin) ->
  exists s d, 0 < d /\ forall x, norm2 (sub x s) < d * d -> norm2 (sub x p) < e * e /\ off F x.
Proof.
  induction F as [|[n c] F IH]; intros p e He HF.
  - exists p, e. split; auto. intros x Hx. split; auto. intros f [].
  - destruct (IH p e He) as (s & d & Hd & G); [intros f Hf; apply HF; simpl; auto|].
    assert (Hn : n <> origin) by (apply (HF (n, c)); simpl; auto). assert (N := norm2_pos n Hn). assert (Pn := norm_pos n Hn).
    assert (K : exists s', norm2 (sub s' s) < d * d /\ dot n s' <> c).
    { destruct (Req_dec (dot n s) c) as [E|E].
      - exists (add s (scal (d / (2 * norm n)) n)). split.
        + replace (sub (add s (scal (d / (2 * norm n)) n)) s) with (scal (d / (2 * norm n)) n) by (pteq; ring).
          apply norm_lt; [lra|]. assert (Pk : 0 < d / (2 * norm n)) by (apply Rdiv_lt_0_compat; lra). rewrite norm_scal by lra.
          replace (d / (2 * norm n) * norm n) with (d / 2) by (field; lra). lra.
        + rewrite dot_add_r, dot_scal_r, E. fold (norm2 n). assert (0 < d / (2 * norm n) * norm2 n).
          { apply Rmult_lt_0_compat; auto. apply Rdiv_lt_0_compat; lra. } lra.
      - exists s. split; auto. replace (norm2 (sub s s)) with 0 by (unfold norm2, dot; simpl; ring). apply Rmult_lt_0_compat; auto. }
    destruct K as (s' & Hs & E). destruct (ball_in_ball s s' d Hd Hs) as (d1 & Hd1 & G1). destruct (stays_off n c s' E) as (d2 & Hd2 & G2).
    assert (M1 := Rmin_l d1 d2). assert (M2 := Rmin_r d1 d2). assert (M0 : 0 < Rmin d1 d2) by (apply Rmin_glb_lt; auto).
    exists s', (Rmin d1 d2). split; auto. intros x Hx.
    assert (X1 : norm2 (sub x s') < d1 * d1) by nra. assert (X2 : norm2 (sub x s') < d2 * d2) by nra.
    destruct (G x (G1 x X1)) as [Gp Go]. split; auto. intros f [<-|Hf]; [apply G2; auto|apply Go; auto].
Qed.

(* ---- the pieces of a union ---- *)
(* a point of a piece that is on none of these planes is an interior one *)
Lemma planes_of : forall Ls, (forall L, In L Ls -> exists p, interior (conv L) p) ->
  exists F : list (pt * R), (forall f, In f F -> fst f <> origin)
    /\ forall L x, In L Ls -> conv L x -> off F x -> interior (conv L) x.
Proof.
  induction Ls as [|L Ls IH]; intros H; [exists []; simpl; tauto|].
  destruct IH as (F & F1 & F2); [intros K HK; apply H; simpl; auto|].
  assert (HS : spanning L).
  { destruct (spanning_or_flat L) as [S|S]; auto. destruct (H L) as (p & Hp); [simpl; auto|]. exfalso. exact (flat_no_interior _ p S Hp). }
  destruct (finite_facets L HS) as (G & G1 & G2). exists (G ++ F). split.
  - intros f Hf. apply in_app_iff in Hf. destruct Hf as [Hf|Hf]; auto. destruct (G1 f Hf) as (u & v & w & K). apply K.
  - intros K x [<-|HK] Hx Ho.
    + destruct (interior_or_facet L G G2 x) as [I|(f & Hf & E)]; auto. exfalso. apply (Ho f); [apply in_app_iff; auto|].
      destruct (G1 f Hf) as (u & v & w & _ & _ & _ & _ & _ & _ & _ & _ & B). assert (U := hull_halfspace _ _ _ B x Hx). lra.
    + apply F2; auto. intros f Hf. apply Ho, in_app_iff. auto.
Qed.

Lemma piece_interior : forall Ls L p, In L Ls -> interior (conv L) p -> interior (union Ls) p.
Proof. intros Ls L p HL (e & He & H). exists e. split; auto. intros s Hs. exists L. auto. Qed.

Theorem overlap_pairs : forall As Bs t, solid_pieces As -> solid_pieces Bs ->
  (overlap_at As Bs t <-> exists A B, In A As /\ In B Bs /\ interior (P A B) t).
Proof.
  intros As Bs t [_ HA] [_ HB]. split.
  - intros (p & Hp & Hq). destruct Hp as (d & Hd & Gd). destruct Hq as (e & He & Ge).
    destruct (planes_of As HA) as (F & F1 & F2). destruct (planes_of Bs HB) as (G & G1 & G2).
    set (F' := map (fun f => (fst f, snd f + dot (fst f) t)) F). assert (M1 := Rmin_l d e). assert (M2 := Rmin_r d e).
    assert (M0 : 0 < Rmin d e) by (apply Rmin_glb_lt; auto).
    destruct (point_off (F' ++ G) p (Rmin d e) M0) as (s & r & Hr & K).
    { intros f Hf. apply in_app_iff in Hf. destruct Hf as [Hf|Hf]; auto. apply in_map_iff in Hf. destruct Hf as (f' & <- & Hf).
      simpl. auto. }
    destruct (K s) as [Ks Ko].
    { replace (norm2 (sub s s)) with 0 by (unfold norm2, dot; simpl; ring). apply Rmult_lt_0_compat; auto. }
    assert (S1 : norm2 (sub s p) < d * d) by nra. assert (S2 : norm2 (sub s p) < e * e) by nra.
    destruct (Gd (sub s t)) as (A & IA & CA). { replace (sub (sub s t) (sub p t)) with (sub s p) by (pteq; ring). auto. }
    destruct (Ge s S2) as (B & IB & CB). exists A, B. split; auto. split; auto. apply pair_interiors; auto. exists s. split.
    + apply interior_translate. apply F2; auto. intros f Hf E. apply (Ko (fst f, snd f + dot (fst f) t)).
      * apply in_app_iff. left. apply in_map_iff. exists f. auto.
      * simpl. rewrite dot_sub_r in E. lra.
    + apply G2; auto. intros f Hf. apply Ko, in_app_iff. auto.
  - intros (A & B & IA & IB & I). apply pair_interiors in I; auto. destruct I as (p & Hp & Hq). exists p.
    apply interior_translate in Hp. split; [apply (piece_interior As A)|apply (piece_interior Bs B)]; auto.
Qed.

(* in words: exactly if the interiors of a piece of A moved by t and of a piece of B meet *)
Theorem overlap_pieces : forall As Bs t, solid_pieces As -> solid_pieces Bs ->
  (overlap_at As Bs t <-> exists A B p, In A As /\ In B Bs /\ interior (translate (conv A) t) p /\ interior (conv B) p).
Proof.
  intros As Bs t HA HB. rewrite overlap_pairs by auto. split.
  - intros (A & B & IA & IB & I). apply pair_interiors in I; [|apply HA; auto|apply HB; auto]. destruct I as (p & I). exists A, B, p. auto.
  - intros (A & B & p & IA & IB & I). exists A, B. split; auto. split; auto. apply pair_interiors; [apply HA; auto|apply HB; auto|eauto].
Qed.

Theorem union_depth2_unique : forall As Bs q r, union_depth2_is As Bs q -> union_depth2_is As Bs r -> q = r.
Proof.
  intros As Bs q r (_ & H1 & t & Ht & H2) (_ & H3 & s & Hs & H4).
  destruct (Rtotal_order q r) as [L|[E|L]]; auto; exfalso; [apply H2, H3; lra|apply H4, H1; lra].
Qed.

(* it is a matter of the bodies, not of their pieces: of convex bodies it is the depth of format 1, whatever they are cut into *)
Theorem union_depth2_whole : forall As Bs A B q, (exists p, interior (conv A) p) -> (exists p, interior (conv B) p) ->
  (forall p, union As p <-> conv A p) -> (forall p, union Bs p <-> conv B p) -> (union_depth2_is As Bs q <-> depth2_is A B q).
Proof.
  intros As Bs A B q HA HB EA EB. assert (E : forall t, overlap_at As Bs t <-> interior (P A B) t).
  { intros t. rewrite pair_interiors by auto. unfold overlap_at.
    assert (F : forall p, interior (union As) (sub p t) <-> interior (translate (conv A) t) p).
    { intros p. rewrite interior_translate. apply interior_iff, EA. }
    assert (G : forall p, interior (union Bs) p <-> interior (conv B) p) by (intros p; apply interior_iff, EB).
    split; intros (p & Hp & Hq); exists p; (split; [apply F|apply G]); auto. }
  unfold union_depth2_is, depth2_is. split; intros (Hq & H & t & Ht & N);
    (split; [auto|split; [intros s Hs; apply E; auto|exists t; split; auto]]); intros I; apply N, E; auto.
Qed.
