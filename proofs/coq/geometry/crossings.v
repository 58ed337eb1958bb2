(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The crossings of a ray with a triangle are a sum over flags: what depends on a plane, a line in it and a point on the line, none of
  them
   oriented.  So chains of triangles whose flags have the same sums have the same winding number. *)
Require Import Reals Lra Psatz List ZArith Lia.
From Fathom.checker Require Import sequence.
From Fathom.geometry Require Import meaning space hulls faces meshes norm flats facets seams.
Import ListNotations.
Open Scope R_scope.

Lemma unit_step_yes : forall x, 0 < x -> unit_step x = 1%Z.
Proof. intros x H. unfold unit_step. destruct (Rlt_dec 0 x); [reflexivity|lra]. Qed.
Lemma unit_step_no : forall x, x <= 0 -> unit_step x = 0%Z.
Proof. intros x H. unfold unit_step. destruct (Rlt_dec 0 x); [lra|reflexivity]. Qed.
Lemma unit_step_times : forall k x, 0 < k -> unit_step (k * x) = unit_step x.
Proof. intros k x H. destruct (Rlt_dec 0 x); [rewrite !unit_step_yes|rewrite !unit_step_no]; auto; nra. Qed.
Ltac known := repeat match goal with
  | |- context [unit_step ?x] => first [rewrite (unit_step_yes x) by lra|rewrite (unit_step_no x) by lra]
  end.

(* ---- in the plane: a ray from O, a triangle around it or not ---- *)
Definition inside (a b c : R) : Z := (unit_step a * unit_step b * unit_step c - unit_step (- a) * unit_step (- b) * unit_step (- c))%Z.
(* a: the determinant of an edge's ends; y, z: how far they are above the ray's line *)
Definition edge_term (a y z : R) : Z := (unit_step (a * (z - y)) * (unit_step z - unit_step y))%Z.

Lemma edge_up : forall a y z, y < 0 -> 0 < z -> edge_term a y z = unit_step a.
Proof.
  intros a y z Y Z. unfold edge_term. rewrite (unit_step_yes z), (unit_step_no y), Rmult_comm, unit_step_times by lra. lia.
Qed.
Lemma edge_down : forall a y z, 0 < y -> z < 0 -> edge_term a y z = (- unit_step (- a))%Z.
Proof.
  intros a y z Y Z. unfold edge_term. rewrite (unit_step_yes y), (unit_step_no z) by lra.
  replace (a * (z - y)) with ((y - z) * - a) by ring. rewrite unit_step_times by lra. lia.
Qed.
Lemma edge_level : forall a y z, (0 < y /\ 0 < z) \/ (y < 0 /\ z < 0) -> edge_term a y z = 0%Z.
Proof. intros a y z [[Y Z]|[Y Z]]; unfold edge_term;
  [rewrite (unit_step_yes y), (unit_step_yes z)|rewrite (unit_step_no y), (unit_step_no z)]; try lra; lia. Qed.

Lemma triangle_crossings : forall a b c p q r, p * b + q * c + r * a = 0 ->
  p <> 0 -> q <> 0 -> r <> 0 -> a <> 0 -> b <> 0 -> c <> 0 ->
  (edge_term a p q + edge_term b q r + edge_term c r p)%Z = inside a b c.
Proof.
  intros a b c p q r I P Q R A B C.
  assert (sP : p < 0 \/ 0 < p) by lra. assert (sQ : q < 0 \/ 0 < q) by lra. assert (sR : r < 0 \/ 0 < r) by lra.
  assert (sA : a < 0 \/ 0 < a) by lra. assert (sB : b < 0 \/ 0 < b) by lra. assert (sC : c < 0 \/ 0 < c) by lra.
  clear P Q R A B C. destruct sP as [P|P], sQ as [Q|Q], sR as [R|R];
    repeat first [rewrite (edge_up a p q) by lra|rewrite (edge_down a p q) by lra|rewrite (edge_level a p q) by lra
                 |rewrite (edge_up b q r) by lra|rewrite (edge_down b q r) by lra|rewrite (edge_level b q r) by lra
                 |rewrite (edge_up c r p) by lra|rewrite (edge_down c r p) by lra|rewrite (edge_level c r p) by lra];
    unfold inside; destruct sA as [A|A], sB as [B|B], sC as [C|C]; known; try reflexivity; exfalso; nra.
Qed.

(* ---- in space ---- *)
Record flag := Flag { plane_normal : pt; line_direction : pt; flag_point : pt }.
(* the same plane, line and point *)
Definition alike (f g : flag) : Prop :=
  (exists k, k <> 0 /\ plane_normal f = scal k (plane_normal g))
  /\ (exists k, k <> 0 /\ line_direction f = scal k (line_direction g)) /\ flag_point f = flag_point g.
Definition of_flags (phi : flag -> Z) : Prop := forall f g, alike f g -> phi f = phi g.

(* what an edge from p to q of a facet with normal n adds *)
Definition edge_sum (phi : flag -> Z) (n p q : pt) : Z := (phi (Flag n (sub q p) q) - phi (Flag n (sub q p) p))%Z.
(* a triangle without an area has no plane *)
Definition triangle_sum (phi : flag -> Z) (T : triangle) : Z :=
  let n := front T in
  if pt_dec n origin then 0%Z
  else (edge_sum phi n (corner_1 T) (corner_2 T) + edge_sum phi n (corner_2 T) (corner_3 T) + edge_sum phi n (corner_3 T) (corner_1 T))%Z.

Lemma minus_one : -1 <> 0.
Proof. lra. Qed.
Lemma edge_sum_back : forall phi, of_flags phi -> forall n p q, edge_sum phi n q p = (- edge_sum phi n p q)%Z.
Proof.
  intros phi H n p q. unfold edge_sum.
  assert (E : forall r, phi (Flag n (sub p q) r) = phi (Flag n (sub q p) r)).
  { intros r. apply H. unfold alike; simpl. split; [exists 1; rewrite scal_1; split; [lra|auto]|]. split; auto. exists (-1).
    split; [apply minus_one|pteq; ring]. }
  rewrite !E. ring.
Qed.
Lemma edge_sum_alike : forall phi, of_flags phi -> forall n k d l p q, k <> 0 -> l <> 0 -> sub q p = scal l d ->
  (phi (Flag n d q) - phi (Flag n d p))%Z = edge_sum phi (scal k n) p q.
Proof.
  intros phi H n k d l p q Hk Hl E. unfold edge_sum. rewrite E.
  assert (F : forall r, phi (Flag (scal k n) (scal l d) r) = phi (Flag n d r)).
  { intros r. apply H. unfold alike; simpl. split; [exists k; auto|]. split; auto. exists l. auto. }
  rewrite !F. reflexivity.
Qed.
Lemma edge_sum_scal : forall phi, of_flags phi -> forall k n p q, k <> 0 -> edge_sum phi (scal k n) p q = edge_sum phi n p q.
Proof. intros phi H k n p q Hk. symmetry. apply (edge_sum_alike phi H n k (sub q p) 1 p q Hk R1_neq_R0). rewrite scal_1. auto. Qed.

Lemma total_map : forall (T U : Type) (f : U -> Z) (g : T -> U) l, total f (map g l) = total (fun t => f (g t)) l.
Proof. intros T U f g l. induction l as [|t l IH]; simpl; [reflexivity|]. rewrite IH. reflexivity. Qed.

(* the inner edges of a fan cancel *)
Lemma fan_sum : forall phi, of_flags phi -> forall n p r a, n <> origin ->
  (forall u w, In (u, w) (pairs a r) -> exists k, k <> 0 /\ front (Triangle p u w) = scal k n) ->
  total (triangle_sum phi) (map (fun e => Triangle p (fst e) (snd e)) (pairs a r))
  = total (fun e => edge_sum phi n (fst e) (snd e)) (chain p (a :: r) p).
Proof.
  intros phi H n p r a Hn. revert a. induction r as [|b r IH]; intros a F.
  - simpl. rewrite (edge_sum_back phi H n p a). ring.
  - cbn [pairs map total fold_right fst snd]. unfold total in IH at 1. rewrite IH by (intros; apply F; simpl; auto).
    destruct (F a b) as (k & Hk & E); [simpl; auto|]. unfold triangle_sum. rewrite E. cbn [corner_1 corner_2 corner_3].
    destruct (pt_dec (scal k n) origin) as [Z|_].
    { exfalso. apply Hn. apply (f_equal (scal (/ k))) in Z. rewrite scal_scal, Rinv_l, scal_1 in Z by auto. rewrite Z. pteq; ring. }
    rewrite !edge_sum_scal by auto. cbn [chain total fold_right fst snd]. rewrite (edge_sum_back phi H n p b). ring.
Qed.

(* with a second direction u: whether the ray meets the plane; seen along v, whether the ray along u meets the line;
  and whether the point is
   above that ray's line *)
Definition seen (x v u : pt) (f : flag) : Z :=
  (ahead x v (plane_normal f) (flag_point f)
   * unit_step (det v (sub (flag_point f) x) (line_direction f) * det v u (line_direction f))
   * unit_step (det v u (sub (flag_point f) x)))%Z.

Lemma square_pos : forall k, k <> 0 -> 0 < k * k.
Proof. intros k H. nra. Qed.

Lemma seen_flags : forall x v u, of_flags (seen x v u).
Proof.
  intros x v u [n d p] [n' d' p'] ((k & Hk & En) & (l & Hl & Ed) & Ep). simpl in *. subst. unfold seen, ahead; simpl.
  replace (dot (scal k n') (sub p' x) * dot (scal k n') v) with (k * k * (dot n' (sub p' x) * dot n' v)) by (unfold dot; simpl; ring).
  replace (det v (sub p' x) (scal l d') * det v u (scal l d')) with (l * l * (det v (sub p' x) d' * det v u d'))
    by (unfold det, dot, cross; simpl; ring).
  rewrite (unit_step_times (k * k)), (unit_step_times (l * l)) by (apply square_pos; auto). reflexivity.
Qed.

Lemma edge_seen : forall x v u n p q, dot n p = dot n q ->
  edge_sum (seen x v u) n p q
  = (ahead x v n p * edge_term (beside x v p q) (det v u (sub p x)) (det v u (sub q x)))%Z.
Proof.
  intros x v u n p q E. unfold edge_sum, seen, edge_term, ahead; simpl.
  replace (dot n (sub q x)) with (dot n (sub p x)) by (rewrite !dot_sub_r; lra).
  replace (det v (sub q x) (sub q p)) with (beside x v p q) by (unfold beside, det, dot, cross; simpl; ring).
  replace (det v (sub p x) (sub q p)) with (beside x v p q) by (unfold beside, det, dot, cross; simpl; ring).
  replace (det v u (sub q p)) with (det v u (sub q x) - det v u (sub p x)) by (unfold det, dot, cross; simpl; ring).
  ring.
Qed.

Lemma front_level : forall T, dot (front T) (corner_1 T) = dot (front T) (corner_2 T)
  /\ dot (front T) (corner_2 T) = dot (front T) (corner_3 T) /\ dot (front T) (corner_3 T) = dot (front T) (corner_1 T).
Proof. intros [p q r]. unfold front, dot, cross; simpl. repeat split; ring. Qed.

Lemma ahead_level : forall x v n p q, dot n p = dot n q -> ahead x v n p = ahead x v n q.
Proof. intros x v n p q E. unfold ahead. rewrite !dot_sub_r, E. reflexivity. Qed.

Lemma crossing_sum : forall x v u T, clear x v T ->
  det v u (sub (corner_1 T) x) <> 0 -> det v u (sub (corner_2 T) x) <> 0 -> det v u (sub (corner_3 T) x) <> 0 ->
  crossing x v T = triangle_sum (seen x v u) T.
Proof.
  intros x v u T (A & B & C & D) P Q R. destruct (front_level T) as (E1 & E2 & E3). unfold triangle_sum. cbv zeta.
  destruct (pt_dec (front T) origin) as [E|_]. { exfalso. apply D. rewrite E. unfold dot; simpl. ring. }
  rewrite !edge_seen by auto. rewrite (ahead_level x v _ (corner_3 T) (corner_1 T)), (ahead_level x v _ (corner_2 T) (corner_1 T)) by
    auto.
  rewrite <- !Z.mul_add_distr_l. unfold crossing. f_equal. symmetry. apply triangle_crossings; auto.
  unfold beside, det, dot, cross; simpl; ring.
Qed.

Lemma crossing_flat : forall x v T, front T = origin -> crossing x v T = 0%Z.
Proof.
  intros x v T E. unfold crossing, ahead. rewrite E, unit_step_no; [reflexivity|]. unfold dot; simpl. lra.
Qed.
Lemma sum_flat : forall phi T, front T = origin -> triangle_sum phi T = 0%Z.
Proof. intros phi T E. unfold triangle_sum. cbv zeta. destruct (pt_dec (front T) origin); [reflexivity|contradiction]. Qed.

Lemma beside_off_line : forall x v p q, beside x v p q <> 0 -> cross (sub p x) v <> origin /\ cross (sub q x) v <> origin.
Proof.
  intros x v p q H. split; intros E; apply H.
  - transitivity (- dot (cross (sub p x) v) (sub q x)); [unfold beside, det, dot, cross; simpl; ring|].
    rewrite E. unfold dot; simpl; ring.
  - transitivity (dot (cross (sub q x) v) (sub p x)); [unfold beside, det, dot, cross; simpl; ring|].
    rewrite E. unfold dot; simpl; ring.
Qed.

(* a second direction that is in general position too *)
Lemma second_direction : forall M x v, general M x v -> exists u, forall T, In T M -> front T = origin \/
  det v u (sub (corner_1 T) x) <> 0 /\ det v u (sub (corner_2 T) x) <> 0 /\ det v u (sub (corner_3 T) x) <> 0.
Proof.
  intros M x v H.
  assert (G : exists F : list (pt * R), (forall f, In f F -> fst f <> origin) /\ forall T, In T M -> front T = origin \/
    forall p, In p [corner_1 T; corner_2 T; corner_3 T] -> In (cross (sub p x) v, 0) F).
  { induction M as [|T M IH]; [exists []; simpl; tauto|]. destruct IH as (F & F1 & F2); [intros S HS; apply H; simpl; auto|].
    destruct (H T) as [E|(A & B & C & _)]; [simpl; auto| |].
    - exists F. split; auto. intros S [<-|HS]; auto.
    - apply beside_off_line in A, B. exists (map (fun p => (cross (sub p x) v, 0)) [corner_1 T; corner_2 T; corner_3 T] ++ F). split.
      + intros f Hf. apply in_app_iff in Hf. simpl in Hf. destruct Hf as [[<-|[<-|[<-|[]]]]|Hf]; auto; simpl; tauto.
      + intros S [<-|HS].
        * right. intros p Hp. apply in_app_iff. left. apply in_map_iff. exists p. auto.
        * destruct (F2 S HS) as [E|K]; auto. right. intros p Hp. apply in_app_iff. auto. }
  destruct G as (F & F1 & F2). destruct (point_off F origin 1) as (u & d & Hd & K); [lra|auto|]. exists u. intros T HT.
  destruct (F2 T HT) as [E|G]; auto. right. destruct (K u) as [_ O].
  { replace (norm2 (sub u u)) with 0 by (unfold norm2, dot; simpl; ring). apply Rmult_lt_0_compat; auto. }
  assert (Z : forall p, In p [corner_1 T; corner_2 T; corner_3 T] -> det v u (sub p x) <> 0).
  { intros p Hp E. apply (O _ (G p Hp)). simpl. rewrite <- E. unfold det, dot, cross; simpl; ring. }
  repeat split; apply Z; simpl; auto.
Qed.

Lemma total_app : forall (T : Type) (f : T -> Z) l k, total f (l ++ k) = (total f l + total f k)%Z.
Proof. intros T f l k. induction l as [|t l IH]; simpl; [reflexivity|]. rewrite IH. ring. Qed.
Lemma total_ext : forall (T : Type) (f g : T -> Z) l, (forall t, In t l -> f t = g t) -> total f l = total g l.
Proof. intros T f g l H. induction l as [|t l IH]; simpl; [reflexivity|]. rewrite H, IH; auto; [intros; apply H|]; simpl; auto. Qed.
Lemma total_zero : forall (T : Type) (f : T -> Z) l, (forall t, In t l -> f t = 0%Z) -> total f l = 0%Z.
Proof. intros T f l H. induction l as [|t l IH]; simpl; [reflexivity|]. rewrite H, IH; auto; [intros; apply H|]; simpl; auto. Qed.
Lemma total_concat : forall (T : Type) (f : T -> Z) ls, total f (concat ls) = total (total f) ls.
Proof. intros T f ls. induction ls as [|l ls IH]; simpl; [reflexivity|]. rewrite total_app, IH. reflexivity. Qed.

(* ---- what the determinants mean ---- *)
Lemma three_weights : forall p q r y, conv [p; q; r] y -> exists a b c, 0 <= a /\ 0 <= b /\ 0 <= c /\ a + b + c = 1
  /\ y = add (scal a p) (add (scal b q) (scal c r)).
Proof.
  intros p q r y H. apply (H (fun y => exists a b c, 0 <= a /\ 0 <= b /\ 0 <= c /\ a + b + c = 1
    /\ y = add (scal a p) (add (scal b q) (scal c r)))).
  - intros u v l Hl (a & b & c & A & B & C & S & ->) (a' & b' & c' & A' & B' & C' & S' & ->).
    exists (l * a + (1 - l) * a'), (l * b + (1 - l) * b'), (l * c + (1 - l) * c'). split; [nra|]. split; [nra|]. split; [nra|].
    split; [|pteq; ring].
    replace (_ + _ + _) with (l * (a + b + c) + (1 - l) * (a' + b' + c')) by ring. rewrite S, S'. ring.
  - intros z [<-|[<-|[<-|[]]]]; [exists 1, 0, 0|exists 0, 1, 0|exists 0, 0, 1]; repeat split; try lra; pteq; ring.
Qed.

Lemma weights_meet : forall a b c al be ga, a <> 0 -> b <> 0 -> c <> 0 -> 0 <= al -> 0 <= be -> 0 <= ga -> al + be + ga = 1 ->
  be * a = ga * c -> al * a = ga * b -> al * c = be * b -> (0 < a /\ 0 < b /\ 0 < c) \/ (a < 0 /\ b < 0 /\ c < 0).
Proof.
  intros a b c al be ga A B C P Q R S E1 E2 E3. assert (ga <> 0 \/ be <> 0 \/ al <> 0) as N by lra.
  assert (sA : a < 0 \/ 0 < a) by lra. assert (sB : b < 0 \/ 0 < b) by lra. assert (sC : c < 0 \/ 0 < c) by lra.
  destruct sA, sB, sC; try tauto; exfalso; assert (ga = 0) by nra; assert (be = 0) by nra; assert (al = 0) by nra; lra.
Qed.

(* the ray meets the triangle exactly if the crossing is not 0, and its sign tells through which side it leaves *)
Theorem crossing_means : forall x v T, clear x v T ->
  let meets := exists s, 0 < s /\ conv [corner_1 T; corner_2 T; corner_3 T] (add x (scal s v)) in
  (crossing x v T = 1%Z /\ meets /\ 0 < dot (front T) v) \/ (crossing x v T = (-1)%Z /\ meets /\ dot (front T) v < 0)
  \/ (crossing x v T = 0%Z /\ ~ meets).
Proof.
  intros x v [p q r] (A & B & C & D) meets. cbn [corner_1 corner_2 corner_3] in *. set (n := front (Triangle p q r)) in *.
  set (a := beside x v p q) in *. set (b := beside x v q r) in *. set (c := beside x v r p) in *. set (t := dot n (sub p x)) in *.
  assert (Nv : dot n v = a + b + c) by (unfold n, a, b, c, front, beside, dot, cross; simpl; ring).
  assert (Et : t = det (sub p x) (sub q x) (sub r x)) by (unfold t, n, front, det, dot, cross; simpl; ring).
  assert (X := cramer_x (sub p x) (sub q x) (sub r x) v). assert (Y := cramer_y (sub p x) (sub q x) (sub r x) v).
  assert (Z := cramer_z (sub p x) (sub q x) (sub r x) v). rewrite <- Et in X, Y, Z.
  replace (det v (sub q x) (sub r x)) with b in * by reflexivity.
  replace (det (sub p x) v (sub r x)) with c in * by (unfold c, beside, det, dot, cross; simpl; ring).
  replace (det (sub p x) (sub q x) v) with a in * by (unfold a, beside, det, dot, cross; simpl; ring).
  assert (K : ((0 < a /\ 0 < b /\ 0 < c) \/ (a < 0 /\ b < 0 /\ c < 0)) -> 0 < t * dot n v -> meets).
  { intros S P0. assert (N0 : a + b + c <> 0) by lra. exists (t / (a + b + c)). split.
    - replace (t / (a + b + c)) with (t * dot n v * / (dot n v * dot n v)) by (rewrite Nv; field; auto).
      apply Rmult_lt_0_compat; auto. apply Rinv_0_lt_compat, square_pos. lra.
    - simpl in X, Y, Z. apply (hull3 _ p q r _ (b / (a + b + c)) (c / (a + b + c)) (a / (a + b + c)) 1); try (apply hull_in; simpl;
      auto); try lra.
      1-3: destruct S as [S|S]; [apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat; lra]|].
      1-3: match goal with |- 0 <= ?k / ?m => replace (k / m) with (- k * / - m) by (field; lra) end;
        apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat; lra].
      + field. auto.
      + simpl. apply Rmult_eq_reg_l with (a + b + c); auto. field_simplify; auto. lra.
      + simpl. apply Rmult_eq_reg_l with (a + b + c); auto. field_simplify; auto. lra.
      + simpl. apply Rmult_eq_reg_l with (a + b + c); auto. field_simplify; auto. lra. }
  assert (J : meets -> ((0 < a /\ 0 < b /\ 0 < c) \/ (a < 0 /\ b < 0 /\ c < 0)) /\ 0 < t * dot n v).
  { intros (s & Hs & H). apply three_weights in H. destruct H as (al & be & ga & P & Q & R & S & E).
    assert (L : forall m, al * dot m (sub p x) + be * dot m (sub q x) + ga * dot m (sub r x) = s * dot m v).
    { intros m. apply (f_equal (fun y => dot m (sub y x))) in E. rewrite <- dot_scal_r. transitivity (dot m (sub (add x (scal s v)) x)).
      - rewrite E. replace x with (scal (al + be + ga) x) at 4 by (rewrite S; apply scal_1). unfold dot; simpl. ring.
      - unfold dot; simpl. ring. }
    assert (G : (0 < a /\ 0 < b /\ 0 < c) \/ (a < 0 /\ b < 0 /\ c < 0)).
    { apply (weights_meet a b c al be ga); auto.
      - assert (M := L (cross v (sub p x))). unfold a, c, beside, dot, cross in *; simpl in *. lra.
      - assert (M := L (cross v (sub q x))). unfold a, b, beside, dot, cross in *; simpl in *. lra.
      - assert (M := L (cross v (sub r x))). unfold b, c, beside, dot, cross in *; simpl in *. lra. }
    split; auto. assert (M := L n). destruct (front_level (Triangle p q r)) as (E1 & E2 & E3). cbn [corner_1 corner_2 corner_3] in *.
    fold n in E1, E2, E3. rewrite !(dot_sub_r n) in M. unfold t. rewrite dot_sub_r.
    assert (Eq : dot n q = dot n p) by lra. assert (Er : dot n r = dot n p) by lra. rewrite Eq, Er in M.
    replace (dot n p - dot n x) with (s * dot n v).
    2: { rewrite <- M. transitivity ((al + be + ga) * (dot n p - dot n x)); [ring|rewrite S; ring]. }
    replace (s * dot n v * dot n v) with (s * (dot n v * dot n v)) by ring. apply Rmult_lt_0_compat; auto.
    apply square_pos. destruct G; lra. }
  unfold crossing, ahead, passes. cbv zeta. cbn [corner_1 corner_2 corner_3]. fold n t a b c.
  destruct (Rlt_dec 0 (t * dot n v)) as [P0|P0].
  - rewrite (unit_step_yes (t * dot n v)) by auto.
    assert (sA : a < 0 \/ 0 < a) by lra. assert (sB : b < 0 \/ 0 < b) by lra. assert (sC : c < 0 \/ 0 < c) by lra.
    destruct sA, sB, sC; known;
      try (right; right; split; [reflexivity|]; intros W; destruct (J W) as [[?|?] _]; lra).
    + right. left. split; [reflexivity|]. split; [apply K; auto|lra].
    + left. split; [reflexivity|]. split; [apply K; auto|lra].
  - rewrite (unit_step_no (t * dot n v)) by lra. right. right. split; [reflexivity|]. intros W. destruct (J W). lra.
Qed.

(* chains with the same sums have the same winding number *)
Theorem same_flags_same_winding : forall M N, (forall phi, of_flags phi -> total (triangle_sum phi) M = total (triangle_sum phi) N) ->
  forall x v, general M x v -> general N x v -> winding M x v = winding N x v.
Proof.
  intros M N H x v GM GN. assert (G : general (M ++ N) x v).
  { intros T HT. apply in_app_iff in HT. destruct HT; auto. }
  destruct (second_direction _ x v G) as (u & Hu).
  assert (K : forall L, (forall T, In T L -> In T (M ++ N)) -> winding L x v = total (triangle_sum (seen x v u)) L).
  { intros L HL. apply total_ext. intros T HT. destruct (Hu T (HL T HT)) as [E|(P & Q & R)].
    - rewrite crossing_flat, sum_flat by auto. reflexivity.
    - destruct (G T (HL T HT)) as [E|C]; [rewrite crossing_flat, sum_flat by auto; reflexivity|]. apply crossing_sum; auto. }
  rewrite (K M), (K N); [apply H, seen_flags| |]; intros T HT; apply in_app_iff; auto.
Qed.
