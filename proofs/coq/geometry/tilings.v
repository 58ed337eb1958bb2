(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* If the winding number is everywhere the number of pieces that hold the point, wherever this can be said, then the mesh is closed and
  the
   pieces are its solid. *)
Require Import Reals Lra Psatz List ZArith Lia.
From Fathom.geometry Require Import meaning space hulls flats facets difference norm unions seams meshes crossings.
Import ListNotations.
Open Scope R_scope.

Lemma held_unique : forall Ls x n m, held_by Ls x n -> held_by Ls x m -> n = m.
Proof.
  induction Ls as [|L Ls IH]; intros x n m; simpl; [lia|]. intros [[C H]|[C H]] [[D K]|[D K]]; try contradiction.
  - specialize (IH x _ _ H K). lia.
  - exact (IH x _ _ H K).
Qed.
Lemma held_count : forall Ls x n, held_by Ls x n -> (0 <= n)%Z /\ (union Ls x <-> (0 < n)%Z).
Proof.
  induction Ls as [|L Ls IH]; intros x n H; simpl in H.
  - split; [lia|]. split; [intros (K & [] & _)|lia].
  - destruct H as [[C H]|[C H]]; destruct (IH x _ H) as [P U].
    + split; [lia|]. split; [lia|]. intros _. exists L. simpl. auto.
    + split; auto. rewrite <- U. split; intros (K & HK & CK); exists K; split; simpl in *; auto. destruct HK as [->|HK]; auto.
    contradiction.
Qed.

(* the same of points that are in the same hulls *)
Lemma held_same : forall Ls x y n, (forall L, In L Ls -> (conv L x <-> conv L y)) -> held_by Ls x n -> held_by Ls y n.
Proof.
  induction Ls as [|L Ls IH]; intros x y n H; simpl; auto. assert (E := H L (or_introl eq_refl)).
  assert (K : forall m, held_by Ls x m -> held_by Ls y m) by (intros m; apply IH; intros; apply H; simpl; auto).
  intros [[C D]|[C D]]; [left|right]; (split; [tauto|auto]).
Qed.

(* ---- nearby points and directions ---- *)
(* what holds near s of each of finitely many things holds of all near s *)
Lemma near_all : forall (T : Type) (good : T -> pt -> Prop) s l,
  (forall t, In t l -> exists e, 0 < e /\ forall y, norm2 (sub y s) < e * e -> good t y) ->
  exists e, 0 < e /\ forall y, norm2 (sub y s) < e * e -> forall t, In t l -> good t y.
Proof.
  intros T good s l H. destruct (all_or_some T (fun _ => False) (fun t e => forall y, norm2 (sub y s) < e * e -> good t y) l)
    as [(t & _ & [])|(e & He & G)].
  - intros t e e' He G y Hy. apply G. nra.
  - intros t Ht. right. auto.
  - exists e. split; auto.
Qed.

Lemma ball_centre : forall s e, 0 < e -> norm2 (sub s s) < e * e.
Proof. intros s e He. replace (norm2 (sub s s)) with 0 by (unfold norm2, dot; simpl; ring). apply Rmult_lt_0_compat; auto. Qed.

Definition same_sign (a b : R) : Prop := a <> 0 /\ (0 < a <-> 0 < b).
Lemma same_positive : forall a b, b <> 0 -> same_sign a b -> unit_step a = unit_step b /\ unit_step (- a) = unit_step (- b).
Proof. intros a b Hb [Ha H]. destruct (Rlt_dec 0 b) as [L|L]; [assert (0 < a) by tauto|assert (~ 0 < a) by tauto]; known; auto. Qed.

Lemma same_product : forall a b k, b <> 0 -> same_sign a b -> unit_step (a * k) = unit_step (b * k).
Proof.
  intros a b k Hb [Ha H]. destruct (Rlt_dec 0 b) as [L|L].
  - assert (0 < a) by tauto. rewrite !unit_step_times; auto.
  - assert (~ 0 < a) by tauto. replace (a * k) with (- a * - k) by ring. replace (b * k) with (- b * - k) by ring.
    rewrite !unit_step_times by lra. reflexivity.
Qed.

Lemma sign_stays : forall n c s, dot n s <> c -> exists e, 0 < e /\ forall y, norm2 (sub y s) < e * e -> same_sign (dot n y - c) (dot n
  s - c).
Proof.
  intros n c s H. destruct (Rlt_dec (dot n s) c) as [L|L].
  - destruct (stays_below n ((dot n s + c) / 2) s) as (e & He & G); [lra|]. exists e. split; auto. intros y Hy. specialize (G y Hy).
    split; [lra|split; lra].
  - destruct (stays_below (scal (-1) n) (- ((dot n s + c) / 2)) s) as (e & He & G); [rewrite dot_scal_l; lra|].
    exists e. split; auto. intros y Hy. specialize (G y Hy). rewrite dot_scal_l in G. split; [lra|split; lra].
Qed.

(* beside is affine in the point and linear in the direction *)
Lemma beside_point : forall x v p q, beside x v p q = dot (cross v (sub q p)) x - - dot v (cross p q).
Proof. intros. unfold beside, dot, cross; simpl. ring. Qed.
Lemma beside_direction : forall x v p q, beside x v p q = dot (cross (sub p x) (sub q x)) v - 0.
Proof. intros. unfold beside, dot; simpl. ring. Qed.

Definition kept (x v y w : pt) (T : triangle) : Prop :=
  front T = origin \/ clear y w T /\ crossing y w T = crossing x v T.

Lemma three_near : forall (T : triangle) (f : pt -> pt -> pt -> R) s,
  (forall p q, In (p, q) [(corner_1 T, corner_2 T); (corner_2 T, corner_3 T); (corner_3 T, corner_1 T)] ->
    exists e, 0 < e /\ forall y, norm2 (sub y s) < e * e -> same_sign (f y p q) (f s p q)) ->
  exists e, 0 < e /\ forall y, norm2 (sub y s) < e * e -> same_sign (f y (corner_1 T) (corner_2 T)) (f s (corner_1 T) (corner_2 T))
    /\ same_sign (f y (corner_2 T) (corner_3 T)) (f s (corner_2 T) (corner_3 T))
    /\ same_sign (f y (corner_3 T) (corner_1 T)) (f s (corner_3 T) (corner_1 T)).
Proof.
  intros T f s H. destruct (near_all _ (fun e y => same_sign (f y (fst e) (snd e)) (f s (fst e) (snd e))) s
    [(corner_1 T, corner_2 T); (corner_2 T, corner_3 T); (corner_3 T, corner_1 T)]) as (e & He & G).
  - intros [p q] I. apply H. exact I.
  - exists e. split; auto. intros y Hy. specialize (G y Hy). split; [|split]; [apply (G (_, _))|apply (G (_, _))|apply (G (_, _))];
    simpl; auto.
Qed.

Lemma passes_same : forall x v y w T, clear x v T -> same_sign (beside y w (corner_1 T) (corner_2 T)) (beside x v (corner_1 T)
  (corner_2 T)) ->
  same_sign (beside y w (corner_2 T) (corner_3 T)) (beside x v (corner_2 T) (corner_3 T)) ->
  same_sign (beside y w (corner_3 T) (corner_1 T)) (beside x v (corner_3 T) (corner_1 T)) -> passes y w T = passes x v T.
Proof.
  intros x v y w T (A & B & C & _) SA SB SC. apply same_positive in SA, SB, SC; auto. unfold passes. cbv zeta.
  destruct SA as [-> ->], SB as [-> ->], SC as [-> ->]. reflexivity.
Qed.

Lemma near_point : forall M x v, general M x v -> exists e, 0 < e /\ forall y, norm2 (sub y x) < e * e ->
  general M y v /\ winding M y v = winding M x v.
Proof.
  intros M x v H. destruct (near_all _ (fun T y => kept x v y v T) x M) as (e & He & G).
  - intros T HT. destruct (H T HT) as [E|C]; [exists 1; split; [lra|left; auto]|]. assert (K := C). destruct K as (A1 & A2 & A3 & A4).
    destruct (three_near T (fun y p q => beside y v p q) x) as (d & Hd & G).
    { intros p q I. assert (N : beside x v p q <> 0) by (destruct I as [I|[I|[I|[]]]]; inversion I; subst; auto).
      rewrite beside_point in N. destruct (sign_stays (cross v (sub q p)) (- dot v (cross p q)) x) as (e & He & S); [lra|].
      exists e. split; auto. intros y Hy. rewrite !beside_point. auto. }
    rewrite dot_sub_r in A4. destruct (sign_stays (front T) (dot (front T) (corner_1 T)) x) as (e & He & S); [lra|].
    assert (M1 := Rmin_l d e). assert (M2 := Rmin_r d e). assert (M0 : 0 < Rmin d e) by (apply Rmin_glb_lt; auto).
    exists (Rmin d e). split; auto. intros y Hy. assert (Y1 : norm2 (sub y x) < d * d) by nra.
    assert (Y2 : norm2 (sub y x) < e * e) by nra.
    destruct (G y Y1) as (S1 & S2 & S3). specialize (S y Y2). right. split.
    + split; [apply S1|split; [apply S2|split; [apply S3|]]]. rewrite dot_sub_r. destruct S as [S _]. lra.
    + unfold crossing. rewrite (passes_same x v y v T C S1 S2 S3). f_equal. unfold ahead.
      set (m := dot (front T) v). rewrite !dot_sub_r. set (c := dot (front T) (corner_1 T)) in *.
      replace ((c - dot (front T) y) * m) with ((dot (front T) y - c) * - m) by ring.
      replace ((c - dot (front T) x) * m) with ((dot (front T) x - c) * - m) by ring. apply same_product; auto. lra.
  - exists e. split; auto. intros y Hy. specialize (G y Hy). split.
    + intros T HT. destruct (G T HT) as [E|[C _]]; auto.
    + apply total_ext. intros T HT. destruct (G T HT) as [E|[_ C]]; auto. rewrite !crossing_flat by auto. reflexivity.
Qed.

Lemma passes_level : forall x v T, dot (front T) v = 0 -> passes x v T = 0%Z.
Proof.
  intros x v T E. assert (Z : beside x v (corner_1 T) (corner_2 T) + beside x v (corner_2 T) (corner_3 T) + beside x v (corner_3 T)
    (corner_1 T) = 0).
  { rewrite <- E. unfold beside, front, dot, cross; simpl. ring. }
  unfold passes. cbv zeta. destruct (Rlt_dec 0 (beside x v (corner_1 T) (corner_2 T))), (Rlt_dec 0 (beside x v (corner_2 T) (corner_3
    T))),
    (Rlt_dec 0 (beside x v (corner_3 T) (corner_1 T))); known; try reflexivity; try (exfalso; lra);
    unfold unit_step; repeat destruct (Rlt_dec _ _); try reflexivity; exfalso; lra.
Qed.

Lemma near_direction : forall M x v, general M x v -> exists e, 0 < e /\ forall w, norm2 (sub w v) < e * e ->
  general M x w /\ winding M x w = winding M x v.
Proof.
  intros M x v H. destruct (near_all _ (fun T w => kept x v x w T) v M) as (e & He & G).
  - intros T HT. destruct (H T HT) as [E|C]; [exists 1; split; [lra|left; auto]|]. assert (K := C). destruct K as (A1 & A2 & A3 & A4).
    destruct (three_near T (fun w p q => beside x w p q) v) as (d & Hd & G).
    { intros p q I. assert (N : beside x v p q <> 0) by (destruct I as [I|[I|[I|[]]]]; inversion I; subst; auto).
      rewrite beside_direction in N. destruct (sign_stays (cross (sub p x) (sub q x)) 0 v) as (e & He & S); [lra|].
      exists e. split; auto. intros y Hy. rewrite !beside_direction. auto. }
    destruct (Req_dec (dot (front T) v) 0) as [E|E].
    + exists d. split; auto. intros w Hw. destruct (G w Hw) as (S1 & S2 & S3). right.
    split; [split; [apply S1|split; [apply S2|split; [apply S3|auto]]]|].
      unfold crossing. rewrite (passes_same x v x w T C S1 S2 S3), (passes_level x v T E). lia.
    + destruct (sign_stays (front T) 0 v) as (e & He & S); [auto|].
      assert (M1 := Rmin_l d e). assert (M2 := Rmin_r d e). assert (M0 : 0 < Rmin d e) by (apply Rmin_glb_lt; auto).
      exists (Rmin d e). split; auto. intros w Hw. assert (Y1 : norm2 (sub w v) < d * d) by nra.
      assert (Y2 : norm2 (sub w v) < e * e) by nra.
      destruct (G w Y1) as (S1 & S2 & S3). specialize (S w Y2). rewrite !Rminus_0_r in S. right.
      split; [split; [apply S1|split; [apply S2|split; [apply S3|auto]]]|].
      unfold crossing. rewrite (passes_same x v x w T C S1 S2 S3). f_equal. unfold ahead.
      rewrite Rmult_comm, (Rmult_comm (dot (front T) (sub (corner_1 T) x)) (dot (front T) v)).
      apply same_product; auto.
  - exists e. split; auto. intros y Hy. specialize (G y Hy). split.
    + intros T HT. destruct (G T HT) as [E|[C _]]; auto.
    + apply total_ext. intros T HT. destruct (G T HT) as [E|[_ C]]; auto. rewrite !crossing_flat by auto. reflexivity.
Qed.

(* ---- general position is near ---- *)
Definition off_planes (M : list triangle) (x : pt) : Prop := forall T, In T M -> front T = origin \/ dot (front T) (sub (corner_1 T) x)
  <> 0.

Lemma off_near : forall M x e, 0 < e -> exists s, norm2 (sub s x) < e * e /\ off_planes M s.
Proof.
  intros M x e He.
  assert (G : exists F : list (pt * R), (forall f, In f F -> fst f <> origin) /\ forall T, In T M -> front T = origin \/
    In (front T, dot (front T) (corner_1 T)) F).
  { induction M as [|T M (F & F1 & F2)]; [exists []; simpl; tauto|]. destruct (origin_dec (front T)) as [E|E].
    - exists F. split; auto. intros S [<-|HS]; auto.
    - exists ((front T, dot (front T) (corner_1 T)) :: F). split; [intros f [<-|Hf]; auto|].
      intros S [<-|HS]; [right; simpl; auto|]. destruct (F2 S HS); simpl; auto. }
  destruct G as (F & F1 & F2). destruct (point_off F x e He F1) as (s & d & Hd & K). exists s.
  destruct (K s (ball_centre s d Hd)) as [K1 K2]. split; auto. intros T HT. destruct (F2 T HT) as [E|I]; auto. right.
  specialize (K2 _ I). cbn [fst snd] in K2. rewrite dot_sub_r. lra.
Qed.

Lemma general_near : forall M x v e, 0 < e -> off_planes M x -> exists w, norm2 (sub w v) < e * e /\ general M x w.
Proof.
  intros M x v e He H.
  assert (G : exists F : list (pt * R), (forall f, In f F -> fst f <> origin) /\ forall T, In T M -> front T = origin \/
    forall p q, In (p, q) [(corner_1 T, corner_2 T); (corner_2 T, corner_3 T); (corner_3 T, corner_1 T)] ->
      In (cross (sub p x) (sub q x), 0) F).
  { induction M as [|T M IH]; [exists []; simpl; tauto|]. destruct IH as (F & F1 & F2); [intros S HS; apply H; simpl; auto|].
    destruct (H T) as [E|N]; [simpl; auto| |].
    - exists F. split; auto. intros S [<-|HS]; auto.
    - exists (map (fun e => (cross (sub (fst e) x) (sub (snd e) x), 0))
        [(corner_1 T, corner_2 T); (corner_2 T, corner_3 T); (corner_3 T, corner_1 T)] ++ F). split.
      + intros f Hf. apply in_app_iff in Hf. destruct Hf as [Hf|Hf]; auto. apply in_map_iff in Hf. destruct Hf as ([p q] & <- & I).
        cbn [fst snd]. intros E. apply N.
        assert (Z : forall r, det r (sub p x) (sub q x) = 0) by (intros r; unfold det; rewrite E; apply dot_origin_r).
        destruct I as [I|[I|[I|[]]]]; inversion I; subst;
          [rewrite <- (Z (sub (corner_3 T) x))|rewrite <- (Z (sub (corner_1 T) x))|rewrite <- (Z (sub (corner_2 T) x))];
          unfold front, det, dot, cross; simpl; ring.
      + intros S [<-|HS].
        * right. intros p q I. apply in_app_iff. left. apply in_map_iff. exists (p, q). auto.
        * destruct (F2 S HS) as [E|K]; auto. right. intros p q I. apply in_app_iff. auto. }
  destruct G as (F & F1 & F2). destruct (point_off F v e He F1) as (w & d & Hd & K). exists w.
  destruct (K w (ball_centre w d Hd)) as [K1 K2]. split; auto. intros T HT. destruct (F2 T HT) as [E|I]; auto.
  assert (Z : forall p q, In (p, q) [(corner_1 T, corner_2 T); (corner_2 T, corner_3 T);
    (corner_3 T, corner_1 T)] -> beside x w p q <> 0).
  { intros p q J E. apply (K2 _ (I p q J)). cbn [fst snd]. rewrite beside_direction in E. lra. }
  destruct (H T HT) as [E|N]; auto. right. repeat split; auto; apply Z; simpl; auto.
Qed.

(* ---- the tiling ---- *)
Section Tiling.
  Variables (M N : list triangle) (Ls : list (list pt)).
  Hypothesis counted : forall x v, general M x v -> general N x v -> held_by Ls x (winding M x v).
  Hypothesis closed : forall L x, In L Ls -> conv L x \/ exists e, 0 < e /\ forall y, norm2 (sub y x) < e * e -> ~ conv L y.
  Hypothesis solid : forall L, In L Ls -> exists p, interior (conv L) p.

  Lemma off_both : forall x, off_planes (M ++ N) x -> off_planes M x /\ off_planes N x.
  Proof. intros x H. split; intros T HT; apply H, in_app_iff; auto. Qed.

  (* the direction need not be in general position for the pieces *)
  Lemma counted_anyway : forall x v, general M x v -> off_planes N x -> held_by Ls x (winding M x v).
  Proof.
    intros x v G O. destruct (near_direction M x v G) as (e & He & K).
    assert (OM : off_planes (M ++ N) x).
    { intros T HT. apply in_app_iff in HT. destruct HT as [HT|HT]; auto. destruct (G T HT) as [E|C]; auto. right. apply C. }
    destruct (general_near (M ++ N) x v e He OM) as (w & Hw & Gw). destruct (K w Hw) as [G' <-]. apply counted; auto.
    intros T HT. apply Gw, in_app_iff. auto.
  Qed.

  Lemma union_closed : forall p, union Ls p \/ exists e, 0 < e /\ forall y, norm2 (sub y p) < e * e -> ~ union Ls y.
  Proof.
    intros p. assert (D : (exists L, In L Ls /\ conv L p) \/ forall L, In L Ls -> exists e, 0 < e /\ forall y, norm2 (sub y p) < e * e
      -> ~ conv L y).
    { clear - closed. induction Ls as [|L l IH]; [right; intros L []|].
    destruct (closed L p) as [C|C]; [simpl; auto|left; exists L; simpl; auto|].
      destruct IH as [(K & HK & CK)|H]; [intros; apply closed; simpl; auto|left; exists K; simpl; auto|]. right. intros K [<-|HK]; auto. }
    destruct D as [D|D]; [left; exact D|right]. destruct (near_all _ (fun L y => ~ conv L y) p Ls D) as (e & He & G).
    exists e. split; auto. intros y Hy (L & HL & CL). exact (G y Hy L HL CL).
  Qed.

  Theorem tiling : tiled M Ls.
  Proof.
    split; [|split; [|split]].
    - intros x v w Gv Gw. destruct (near_point M x v Gv) as (d & Hd & Kv). destruct (near_point M x w Gw) as (e & He & Kw).
      assert (M1 := Rmin_l d e). assert (M2 := Rmin_r d e). assert (M0 : 0 < Rmin d e) by (apply Rmin_glb_lt; auto).
      destruct (off_near N x (Rmin d e) M0) as (s & Hs & O). assert (S1 : norm2 (sub s x) < d * d) by nra.
      assert (S2 : norm2 (sub s x) < e * e) by nra. destruct (Kv s S1) as [Gv' <-]. destruct (Kw s S2) as [Gw' <-].
      apply (held_unique Ls s); apply counted_anyway; auto.
    - intros x v G. destruct (near_point M x v G) as (d & Hd & K). destruct (off_near N x d Hd) as (s & Hs & O).
      destruct (K s Hs) as [G' <-]. apply (held_count Ls s), counted_anyway; auto.
    - intros x v G Hx. destruct (near_point M x v G) as (d & Hd & K).
      destruct (near_all _ (fun L y => conv L x <-> conv L y) x Ls) as (e & He & Q).
      { intros L HL. destruct (closed L x HL) as [C|(e & He & Q)].
        - destruct (Hx L HL C) as (e & He & Q). exists e. split; auto. intros y Hy. split; auto.
        - exists e. split; auto. intros y Hy. split; intros C; [exfalso; apply (Q x); auto; apply ball_centre;
          auto|destruct (Q y Hy C)]. }
      assert (M1 := Rmin_l d e). assert (M2 := Rmin_r d e). assert (M0 : 0 < Rmin d e) by (apply Rmin_glb_lt; auto).
      destruct (off_near N x (Rmin d e) M0) as (s & Hs & O). assert (S1 : norm2 (sub s x) < d * d) by nra.
      assert (S2 : norm2 (sub s x) < e * e) by nra. destruct (K s S1) as [G' <-].
      apply (held_same Ls s); [|apply counted_anyway; auto]. intros L HL. specialize (Q s S2 L HL). tauto.
    - intros p. split.
      + intros S. destruct (union_closed p) as [U|(e & He & U)]; auto. exfalso. destruct (S e He) as (x & v & Hx & G & W).
        destruct (near_point M x v G) as (d & Hd & K). destruct (ball_in_ball p x e He Hx) as (d' & Hd' & B).
        assert (M1 := Rmin_l d d'). assert (M2 := Rmin_r d d'). assert (M0 : 0 < Rmin d d') by (apply Rmin_glb_lt; auto).
        destruct (off_near N x (Rmin d d') M0) as (s & Hs & O). assert (S1 : norm2 (sub s x) < d * d) by nra.
        assert (S2 : norm2 (sub s x) < d' * d') by nra. destruct (K s S1) as [G' E]. apply (U s (B s S2)).
        apply (held_count Ls s (winding M s v)); [apply counted_anyway; auto|lia].
      + intros (L & HL & HC) e He. destruct (solid L HL) as (g & Hg). set (n := norm (sub g p)).
        assert (Pn : 0 <= n) by apply norm_nonneg. set (k := e / (e + n)).
        assert (Pk : 0 < k) by (apply Rdiv_lt_0_compat; lra). assert (Ek : k * (e + n) = e) by (unfold k; field; lra).
        assert (Lk : k <= 1) by nra. set (z := add p (scal k (sub g p))).
        assert (Hz : norm2 (sub z p) < e * e).
        { replace (sub z p) with (scal k (sub g p)) by (unfold z; pteq; ring). apply norm_lt; [lra|]. rewrite norm_scal by lra. fold n.
        nra. }
        assert (Iz : interior (conv L) z) by (apply step_inside; auto; apply hull_convex). destruct Iz as (d & Hd & Iz).
        destruct (ball_in_ball p z e He Hz) as (d' & Hd' & B). assert (M1 := Rmin_l d d'). assert (M2 := Rmin_r d d').
        assert (M0 : 0 < Rmin d d') by (apply Rmin_glb_lt; auto). destruct (off_near (M ++ N) z (Rmin d d') M0) as (s & Hs & O).
        assert (S1 : norm2 (sub s z) < d * d) by nra. assert (S2 : norm2 (sub s z) < d' * d') by nra.
        destruct (general_near (M ++ N) s origin 1 Rlt_0_1 O) as (v & _ & G). exists s, v. split; [auto|].
        assert (GM : general M s v) by (intros T HT; apply G, in_app_iff; auto).
        assert (GN : general N s v) by (intros T HT; apply G, in_app_iff; auto). split; auto.
        apply (held_count Ls s); [apply counted; auto|]. exists L. auto.
  Qed.
End Tiling.

(* so what is proved of the pieces is said of the solids *)
Corollary tiled_overlap : forall MA MB As Bs t, tiled MA As -> tiled MB Bs ->
  (overlap_at As Bs t <-> exists p, interior (solid_of MA) (sub p t) /\ interior (solid_of MB) p).
Proof.
  intros MA MB As Bs t (_ & _ & _ & HA) (_ & _ & _ & HB). unfold overlap_at.
  assert (EA : forall p, interior (solid_of MA) p <-> interior (union As) p) by (intros p; apply interior_iff, HA).
  assert (EB : forall p, interior (solid_of MB) p <-> interior (union Bs) p) by (intros p; apply interior_iff, HB).
  split; intros (p & Hp & Hq); exists p; (split; [apply EA|apply EB]); auto.
Qed.
