(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Bodies of the plane: what is true of upright ones without an end is true of flat ones and prisms, if these are high enough.  And the
   upright ones have the depth, and the ways out, that there are in the plane. *)
Require Import Reals Lra Psatz List ZArith.
From Fathom.geometry Require Import meaning space norm hulls difference said seams.
Import ListNotations.
Open Scope R_scope.

Definition at_level (z : R) (p : pt) := mk (px p) (py p) z.

Lemma upright_level : forall S p z, upright S (at_level z p) <-> upright S p.
Proof. intros S p z. unfold upright. simpl. tauto. Qed.
Lemma upright_in : forall (S : pt -> Prop) p, S p -> upright S p.
Proof. intros S [x y z] H. exists z. auto. Qed.

(* ---- bodies that are raised ---- *)
(* S as it is drawn in the plane z = 0, and as a prism of all heights up to h *)
Definition drawn (S S' : pt -> Prop) :=
  (forall p, S' p -> upright S p) /\ forall p, upright S p -> S' (at_level 0 p).
Definition raised (h : R) (S S' : pt -> Prop) :=
  (forall p, S' p -> upright S p) /\ forall p, upright S p -> - h <= pz p <= h -> S' p.

Lemma raised_drawn : forall h S S', 0 <= h -> raised h S S' -> drawn S S'.
Proof. intros h S S' Hh [U D]. split; auto. intros p Hp. apply D; [apply upright_level; auto|simpl; lra]. Qed.

Lemma raised_difference : forall h S S' T T', drawn S S' -> raised h T T' ->
  raised h (difference_of T S) (difference_of T' S').
Proof.
  intros h S S' T T' [US DS] [UT DT]. split.
  - intros p (b & a & Hb & Ha & ->). apply UT in Hb. apply US in Ha. destruct Hb as (z & Hb), Ha as (w & Ha).
    exists (z - w), (mk (px b) (py b) z), (mk (px a) (py a) w). auto.
  - intros p (z & b & a & Hb & Ha & E) Hz. exists (at_level (pz p) b), (at_level 0 a).
    split; [apply DT; [apply upright_level, upright_in; auto|auto]|]. split; [apply DS, upright_in; auto|].
    inversion E. pteq; lra.
Qed.

Lemma level_nearer : forall p s z, norm2 (sub (at_level z p) (at_level z s)) <= norm2 (sub p s).
Proof. intros p s z. unfold norm2, dot. simpl. assert (X := Rle_0_sqr (pz p - pz s)). unfold Rsqr in X. lra. Qed.

Lemma drawn_thick : forall S S' r, drawn S S' -> drawn (thick S r) (thick S' r).
Proof.
  intros S S' r [U D]. split.
  - intros p (s & Hs & N). apply U in Hs. destruct Hs as (z & Hs). exists z, (at_level z s). split; auto.
    apply Rle_trans with (norm2 (sub p s)); auto. apply (level_nearer p s z).
  - intros p (z & s & Hs & N). exists (at_level 0 s). split; [apply D, upright_in; auto|].
    apply Rle_trans with (norm2 (sub (mk (px p) (py p) z) s)); auto. apply (level_nearer (mk (px p) (py p) z) s 0).
Qed.
Lemma raised_thick : forall h S S' r, raised h S S' -> raised h (thick S r) (thick S' r).
Proof.
  intros h S S' r [U D]. split.
  - intros p (s & Hs & N). apply U in Hs. destruct Hs as (z & Hs). exists z, (at_level z s). split; auto.
    apply Rle_trans with (norm2 (sub p s)); auto. apply (level_nearer p s z).
  - intros p (z & s & Hs & N) Hz. exists (at_level (pz p) s). split; [apply D; [apply upright_level, upright_in; auto|auto]|].
    apply Rle_trans with (norm2 (sub (mk (px p) (py p) z) s)); auto.
    assert (L := level_nearer (mk (px p) (py p) z) s (pz p)). destruct p. exact L.
Qed.

(* ---- hulls ---- *)
Lemma upright_convex : forall S, convex S -> convex (upright S).
Proof.
  intros S C u v l Hl (z & Hu) (w & Hv). exists (l * z + (1 - l) * w). exact (C _ _ l Hl Hu Hv).
Qed.

Lemma drawn_hull : forall L, drawn (conv L) (conv (map (at_level 0) L)).
Proof.
  intros L. split.
  - intros p Hp. apply Hp; [apply upright_convex, hull_convex|]. intros s Is. apply in_map_iff in Is.
    destruct Is as (q & <- & Iq). apply upright_level, upright_in, hull_in, Iq.
  - intros p (z & Hp). change (conv (map (at_level 0) L) (at_level 0 (mk (px p) (py p) z))).
    apply (Hp (fun q => conv (map (at_level 0) L) (at_level 0 q))).
    + intros u v l Hl Hu Hv. replace (at_level 0 (add (scal l u) (scal (1 - l) v)))
        with (add (scal l (at_level 0 u)) (scal (1 - l) (at_level 0 v))) by (pteq; ring). apply hull_convex; auto.
    + intros s Is. apply hull_in, in_map, Is.
Qed.

Lemma raised_hull : forall h L, 0 < h -> raised h (conv L) (conv (map (at_level (- h)) L ++ map (at_level h) L)).
Proof.
  intros h L Hh. set (K := map (at_level (- h)) L ++ map (at_level h) L). split.
  - intros p Hp. apply Hp; [apply upright_convex, hull_convex|]. intros s Is. apply in_app_iff in Is.
    destruct Is as [Is|Is]; apply in_map_iff in Is; destruct Is as (q & <- & Iq); apply upright_level, upright_in, hull_in, Iq.
  - intros p (z & Hp) Hz. replace p with (at_level (pz p) (mk (px p) (py p) z)) by (destruct p; reflexivity).
    apply (Hp (fun q => conv K (at_level (pz p) q))).
    + intros u v l Hl Hu Hv. replace (at_level (pz p) (add (scal l u) (scal (1 - l) v)))
        with (add (scal l (at_level (pz p) u)) (scal (1 - l) (at_level (pz p) v))) by (pteq; ring). apply hull_convex; auto.
    + intros s Is. apply (hull_seg _ (at_level (- h) s) (at_level h s) _ (h - pz p) (h + pz p)); simpl; try lra;
        apply hull_in, in_app_iff; [left|right]; apply in_map, Is.
Qed.

Lemma raised_half_space : forall n d h, pz n = 0 -> let S p := dot n p <= d in drawn S S /\ raised h S S.
Proof.
  intros n d h Z S. assert (F : forall p z, S (at_level z p) <-> S p).
  { intros p z. unfold S, dot. simpl. rewrite Z. lra. }
  assert (G : forall p, upright S p <-> S p).
  { intros p. split; [|apply upright_in]. intros (z & H). apply (F p z). exact H. }
  split; split; intros p; rewrite ?G, ?F; auto.
Qed.

(* ---- interiors ---- *)
Lemma interior_mono : forall (S T : pt -> Prop) t, (forall p, S p -> T p) -> interior S t -> interior T t.
Proof. intros S T t H (e & He & I). exists e. auto. Qed.

Lemma interior_level : forall S t z, interior (upright S) t -> interior (upright S) (at_level z t).
Proof.
  intros S t z (e & He & I). exists e. split; auto. intros s Hs.
  change (upright S (at_level (pz t + (pz s - z)) s)). apply I. unfold norm2, dot in *. simpl in *. nra.
Qed.

Lemma interior_raised : forall h S S' t, raised h S S' -> interior (upright S) t -> - h < pz t < h -> interior S' t.
Proof.
  intros h S S' t [_ D] (e & He & I) Hz. set (k := Rmin e (Rmin (h - pz t) (h + pz t))).
  assert (Pk : 0 < k) by (unfold k; repeat apply Rmin_glb_lt; lra).
  assert (Ke : k <= e) by apply Rmin_l.
  assert (Kh : k <= h - pz t) by (apply Rle_trans with (Rmin (h - pz t) (h + pz t)); [apply Rmin_r|apply Rmin_l]).
  assert (Kl : k <= h + pz t) by (apply Rle_trans with (Rmin (h - pz t) (h + pz t)); [apply Rmin_r|apply Rmin_r]).
  clearbody k. exists k. split; auto. intros s Hs. apply D.
  - apply I. apply Rlt_le_trans with (k * k); auto. apply Rmult_le_compat; lra.
  - unfold norm2, dot in Hs. simpl in Hs. assert (X := Rle_0_sqr (px s - px t)). assert (X' := Rle_0_sqr (py s - py t)). unfold Rsqr in X, X'.
    assert (Hd : (pz s - pz t) * (pz s - pz t) < k * k) by lra.
    assert (pz s - pz t < k) by (apply Rnot_le_lt; intros Y; nra).
    assert (- (pz s - pz t) < k) by (apply Rnot_le_lt; intros Y; nra). lra.
Qed.

(* ---- the depth of what is raised ---- *)
Section Depth.
  Variables (h : R) (U U' G G' : pt -> Prop).
  Hypothesis Hh : 0 < h.
  Hypothesis UU : forall t, U' t -> U t.
  Hypothesis DU : forall t, U t -> - h < pz t < h -> U' t.
  Hypothesis RG : raised h G G'.

  Lemma level_within : forall t q, norm2 t <= q -> q < h * h -> - h < pz t < h.
  Proof.
    intros t q N Hq. unfold norm2, dot in N. assert (Hd : pz t * pz t < h * h) by nra.
    split; apply Rnot_le_lt; intros Y; nra.
  Qed.
  Lemma same_below : forall t q, norm2 t <= q -> q < h * h -> (U' t <-> U t).
  Proof. intros t q N Hq. split; auto. intros H. apply DU; auto. apply (level_within t q); auto. Qed.

  Theorem raised_depth : forall q, q < h * h -> depth2 U' G' q -> depth2 U (upright G) q.
  Proof.
    intros q Hq [(Pq & I & t & N & X)|[(-> & I & X)|(Nq & I & t & N & X)]].
    - left. split; auto. split; [auto|]. exists t. split; auto. rewrite <- (same_below t q); auto. lra.
    - right; left. split; auto. split; [apply RG; auto|]. rewrite <- (same_below origin 0); auto.
      unfold norm2, dot, origin. simpl. lra.
    - right; right. split; auto.
      assert (L : forall s, upright G s -> - q <= norm2 (at_level 0 s)).
      { intros s Hs. apply I. apply RG; [apply upright_level; auto|simpl; lra]. }
      assert (M : forall s, norm2 (at_level 0 s) <= norm2 s) by (intros s; unfold norm2, dot; simpl; nra).
      split; [intros s Hs; apply Rle_trans with (norm2 (at_level 0 s)); auto|].
      exists t. split; auto. apply RG; auto.
  Qed.
  Theorem raised_exits : forall q k, q < h * h -> exits U' q k -> exits U q k.
  Proof.
    intros q k Hq (ts & L & N & E). exists ts. split; auto. split; auto. intros t. rewrite E.
    split; intros [Nt X]; split; auto; intros Y; apply X; apply (same_below t q); auto; lra.
  Qed.
End Depth.

(* ---- what is said of upright bodies is said of the plane ---- *)
(* the interior as it is seen in the plane z = 0 *)
Definition inside (S : pt -> Prop) (t : pt) :=
  exists e, 0 < e /\ forall s, pz s = 0 -> norm2 (sub s t) < e * e -> S s.

Lemma inside_upright : forall S t, pz t = 0 -> (inside (upright S) t <-> interior (upright S) t).
Proof.
  intros S t Z. split; intros (e & He & I); exists e; split; auto. intros s Hs.
  change (upright S (at_level 0 s)). apply I; auto. unfold norm2, dot in *. simpl in *. rewrite Z in *. nra.
Qed.

Theorem plane_depth : forall (G : pt -> Prop) q, (forall g, G g -> pz g = 0) ->
  (depth2 (interior (upright G)) (upright G) q <->
   0 < q /\ (forall t, pz t = 0 -> norm2 t < q -> inside G t) /\ (exists t, pz t = 0 /\ norm2 t = q /\ ~ inside G t)
   \/ q = 0 /\ G origin /\ ~ inside G origin
   \/ q < 0 /\ (forall t, G t -> - q <= norm2 t) /\ (exists t, norm2 t = - q /\ G t)).
Proof.
  intros G q F.
  assert (E : forall s, pz s = 0 -> (upright G s <-> G s)).
  { intros [x y z] Z. simpl in Z. subst. split; [|apply upright_in]. intros (z & H). assert (X := F _ H). simpl in *. subst. exact H. }
  assert (I : forall t, pz t = 0 -> (inside G t <-> interior (upright G) t)).
  { intros t Z. rewrite <- inside_upright by auto. split; intros (e & He & H); exists e; split; auto; intros s Zs Hs;
      apply (E s Zs); auto. }
  assert (M : forall t, norm2 (at_level 0 t) <= norm2 t) by (intros t; unfold norm2, dot; simpl; nra).
  assert (B : forall t, interior (upright G) (at_level 0 t) -> interior (upright G) t).
  { intros t H. apply (interior_level _ _ (pz t)) in H. destruct t. exact H. }
  split.
  - intros [(Pq & H & t & N & X)|[(-> & H & X)|(Nq & H & t & N & X)]].
    + left. split; auto. split; [intros s Z Hs; apply I; auto|]. exists (at_level 0 t). split; auto.
      assert (Y : ~ interior (upright G) (at_level 0 t)) by (intros Y; auto). split.
      * apply Rle_antisym; [rewrite <- N; auto|]. apply Rnot_lt_le. intros L. apply Y, H, L.
      * rewrite I by auto. auto.
    + right; left. split; auto. rewrite <- E, I by auto. auto.
    + right; right. split; auto. split; [intros s Hs; apply H, upright_in, Hs|]. exists (at_level 0 t).
      assert (Y : G (at_level 0 t)) by (apply E; auto; apply upright_level; auto). split; auto.
      apply Rle_antisym; [rewrite <- N; auto|]. apply H, upright_in, Y.
  - intros [(Pq & H & t & Z & N & X)|[(-> & H & X)|(Nq & H & t & N & X)]].
    + left. split; auto. split.
      * intros s Hs. apply B. apply I; auto. apply H; auto. apply Rle_lt_trans with (norm2 s); auto.
      * exists t. split; auto. rewrite <- I by auto. auto.
    + right; left. split; auto. rewrite E, <- I by auto. auto.
    + right; right. split; auto. split.
      * intros s Hs. apply Rle_trans with (norm2 (at_level 0 s)); auto. apply H, E; auto.
      * exists t. split; auto. apply upright_in, X.
Qed.

(* the ways out do not leave the plane *)
Theorem plane_exits : forall (G : pt -> Prop) q t, (forall s, norm2 s < q -> interior (upright G) s) -> norm2 t = q ->
  ~ interior (upright G) t -> pz t = 0.
Proof.
  intros G q t H N X. destruct (Req_dec (pz t) 0) as [Z|Z]; auto. exfalso. apply X.
  assert (Y : interior (upright G) (at_level 0 t)).
  { apply H. rewrite <- N. unfold norm2, dot. simpl. assert (0 < pz t * pz t) by nra. lra. }
  apply (interior_level _ _ (pz t)) in Y. destruct t. exact Y.
Qed.
