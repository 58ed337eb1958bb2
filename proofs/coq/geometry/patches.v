(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A convex set in a plane is the hull of its corners if planes that turn round once, or more often,
   touch it there.  Rates. *)
Require Import Reals Lra Psatz List FinFun.
From Fathom.checker Require Import sequence body.
From Fathom.geometry Require Import meaning bodies space norm hulls farkas difference scaling signed_depth units.
From Fathom.geometry Require Import contact.
Import ListNotations.
Open Scope R_scope.

(* ---- vectors that turn round, seen from the tip of n ---- *)
Section Turning.
  Variable n : pt.
  Notation turn u v := (det n u v).

  Lemma turn_transitive : forall z u v w, 0 < turn u z -> 0 < turn v z -> 0 < turn w z -> 0 < turn u v -> 0 < turn v w
    -> 0 < turn u w.
  Proof.
    intros z u v w Hu Hv Hw Huv Hvw.
    assert (E : turn u w * turn v z = turn u v * turn w z + turn v w * turn u z) by (unfold det, dot; simpl; ring).
    apply Rmult_lt_reg_r with (turn v z); auto. rewrite Rmult_0_l, E.
    apply Rplus_lt_0_compat; apply Rmult_lt_0_compat; auto.
  Qed.

  Lemma turn_all : forall z l a b, (forall u v, In (u, v) (chain a l b) -> 0 < turn u v) ->
    (forall u, In u (a :: l) \/ u = b -> 0 < turn u z) -> 0 < turn a b.
  Proof.
    intros z. induction l as [|c l IH]; intros a b H P0; [apply H; simpl; auto|].
    apply (turn_transitive z a c b); try (apply P0; simpl; tauto).
    - apply H; simpl; auto.
    - apply IH; [intros u v I0; apply H; simpl; auto|intros u [I0|I0]; apply P0; simpl in *; tauto].
  Qed.

  Lemma chain_back : forall (f : pt -> R) l a b, (forall u v, In (u, v) (chain a l b) -> f u < 0 \/ 0 < f v) -> f b < 0
    ->
    forall u, In u (a :: l) -> f u < 0.
  Proof.
    intros f. induction l as [|c l IH]; intros a b H N u I0.
    - destruct I0 as [<-|[]]. destruct (H a b); simpl; auto; lra.
    - assert (G : forall u, In u (c :: l) -> f u < 0) by (apply (IH c b); auto; intros x y Ixy; apply H; simpl; auto).
      destruct I0 as [<-|I0]; [|apply G; auto]. destruct (H a c); simpl; auto. specialize (G c (or_introl eq_refl)).
      lra.
  Qed.
  Lemma chain_on : forall (f : pt -> R) l a b, (forall u v, In (u, v) (chain a l b) -> f u < 0 \/ 0 < f v) -> 0 <= f a
    ->
    forall u, In u l \/ u = b -> 0 < f u.
  Proof.
    intros f. induction l as [|c l IH]; intros a b H N u I0.
    - destruct I0 as [[]| ->]. destruct (H a b); simpl; auto; lra.
    - assert (Pc : 0 < f c) by (destruct (H a c); simpl; auto; lra). destruct I0 as [[<-|I0]|I0]; auto;
        (apply (IH c b); auto; [intros x y Ixy; apply H; simpl; auto|lra]).
  Qed.

  Lemma pair_dec : forall (f : pt -> R) (l : list (pt * pt)),
    (exists u v, In (u, v) l /\ 0 <= f u /\ f v <= 0) \/ (forall u v, In (u, v) l -> f u < 0 \/ 0 < f v).
  Proof.
    intros f. induction l as [|[u v] l IH]; [right; simpl; tauto|].
    destruct (Rlt_dec (f u) 0) as [U|U]; [|destruct (Rlt_dec 0 (f v)) as [V|V]; [|left; exists u, v; simpl; split;
      auto; lra]];
      (destruct IH as [(x & y & I0 & X)|IH]; [left; exists x, y; simpl; auto|right; intros x y [E|I0]; [inversion E;
        subst; auto|auto]]).
  Qed.

  (* each vector is between two that follow each other *)
  Lemma between_two : forall a l z, (forall u v, In (u, v) (chain a l a) -> 0 < turn u v) ->
    exists u v, In (u, v) (chain a l a) /\ 0 <= turn u z /\ turn v z <= 0.
  Proof.
    intros a l z H. destruct (pair_dec (fun u => turn u z) (chain a l a)) as [G|G]; auto. exfalso.
    assert (Z : turn a a = 0) by (unfold det, dot; simpl; ring).
    destruct (Rle_dec 0 (turn a z)) as [P0|P0].
    - assert (K := chain_on (fun u => turn u z) l a a G P0).
      assert (0 < turn a a); [|lra]. apply (turn_all z l); auto. intros u [[<-|I0]|I0]; apply K; auto.
    - assert (N0 : turn a z < 0) by lra. assert (K := chain_back (fun u => turn u z) l a a G N0).
      assert (0 < turn a a); [|lra]. apply (turn_all (scal (-1) z) l); auto.
      intros u I0. replace (turn u (scal (-1) z)) with (- turn u z) by (unfold det, dot; simpl; ring).
      assert (turn u z < 0); [|lra]. destruct I0 as [I0| ->]; [apply K; auto|auto].
  Qed.

  Lemma cramer : forall z u v d, dot n d = 0 -> turn u v * dot z d = turn u z * dot v d - turn v z * dot u d.
  Proof.
    intros z u v d E.
    assert (C : turn u v * dot z d = det z u v * dot n d + turn u z * dot v d - turn v z * dot u d) by (unfold det,
      dot; simpl; ring).
    rewrite C, E. ring.
  Qed.
  Lemma only_zero : forall u v d, 0 < turn u v -> dot n d = 0 -> dot u d = 0 -> dot v d = 0 -> d = origin.
  Proof.
    intros u v d H E U V. apply norm2_zero. unfold norm2. assert (C := cramer d u v d E). rewrite U, V in C.
    apply Rmult_eq_reg_l with (turn u v); lra.
  Qed.
End Turning.

Lemma chain_first : forall (T : Type) (l : list T) a z s, In s (a :: l) -> exists s', In (s, s') (chain a l z).
Proof.
  induction l as [|b l IH]; intros a z s H.
  - destruct H as [<-|[]]. exists z. simpl. auto.
  - destruct H as [<-|H]; [exists b; simpl; auto|]. destruct (IH b z s H) as (s' & I0). exists s'. simpl. auto.
Qed.
Lemma chain_map : forall (T U : Type) (f : T -> U) l a z,
  chain (f a) (map f l) (f z) = map (fun e => (f (fst e), f (snd e))) (chain a l z).
Proof. induction l as [|b l IH]; intros a z; simpl; [auto|]. rewrite IH. auto. Qed.

(* ---- sides (m, p): the plane through p with the normal m touches C, and so does the plane of the
   next side's normal ---- *)
Definition touches (C : pt -> Prop) (m p : pt) : Prop := forall x, C x -> dot m p <= dot m x.
Definition round (C : pt -> Prop) (n : pt) (a : pt * pt) (l : list (pt * pt)) : Prop := forall s s', In (s, s') (chain
  a l a) ->
  0 < det n (fst s) (fst s') /\ C (snd s) /\ touches C (fst s) (snd s) /\ touches C (fst s') (snd s).

Section Round.
  Variables (C : pt -> Prop) (n : pt) (c : R) (a : pt * pt) (l : list (pt * pt)) (ps : list pt).
  Hypothesis Convex : convex C.
  Hypothesis Flat : forall x, C x -> dot n x = c.
  Hypothesis Round : round C n a l.
  Hypothesis Named : forall p, In p ps -> exists s, In s (a :: l) /\ snd s = p.
  Hypothesis Corner : forall s, In s (a :: l) -> In (snd s) ps.

  Lemma corner_in : forall p, In p ps -> C p.
  Proof.
    intros p Ip. destruct (Named p Ip) as (s & Is & <-). destruct (chain_first _ l a a s Is) as (s' & I0).
    apply (Round s s' I0).
  Qed.

  (* whatever the direction, some corner is as low as any point *)
  Lemma lowest_corner : forall z, exists p, In p ps /\ touches C z p.
  Proof.
    intros z. destruct (between_two n (fst a) (map fst l) z) as (u & v & I0 & U & V).
    - intros u v I0. rewrite chain_map in I0. apply in_map_iff in I0. destruct I0 as ((s & s') & E & I0).
      inversion E; subst. apply Round; auto.
    - rewrite chain_map in I0. apply in_map_iff in I0. destruct I0 as ((s & s') & E & I0). inversion E; subst.
      clear E. cbn [fst snd] in *.
      destruct (Round s s' I0) as (P0 & Cp & T0 & T1). exists (snd s).
      split; [apply Corner, (chain_members _ l a a s s' I0)|].
      intros x Cx. specialize (T0 x Cx). specialize (T1 x Cx).
      assert (E : dot n (sub x (snd s)) = 0) by (rewrite dot_sub_r, !Flat; auto; lra).
      assert (K := cramer n z _ _ _ E : det n (fst s) (fst s') * _ = _). rewrite !dot_sub_r in K.
      assert (G : 0 <= det n (fst s) (fst s') * (dot z x - dot z (snd s))).
      { rewrite K. assert (0 <= det n (fst s) z * (dot (fst s') x - dot (fst s') (snd s))) by (apply Rmult_le_pos; lra).
        assert (0 <= - det n (fst s') z * (dot (fst s) x - dot (fst s) (snd s))) by (apply Rmult_le_pos; lra). lra. }
      apply Rnot_lt_le. intros L. assert (0 < det n (fst s) (fst s') * (dot z (snd s) - dot z x)) by (apply
        Rmult_lt_0_compat; lra). lra.
  Qed.

  Theorem round_hull : forall x, C x <-> conv ps x.
  Proof.
    intros x. split; [intros Cx|intros Hx; apply Hx; auto; apply corner_in].
    destruct (conv_or_separated ps x) as [H|(y & H)]; auto. exfalso.
    destruct (lowest_corner (scal (-1) y)) as (p & Ip & T). specialize (T x Cx). specialize (H p Ip).
    rewrite !dot_scal_l in T. lra.
  Qed.

  (* of all points of C only the corner is on both planes *)
  Theorem round_extreme : forall p, In p ps -> ~ hull (fun q => In q ps /\ q <> p) p.
  Proof.
    intros p Ip Hp. destruct (Named p Ip) as (s & Is & E). destruct (chain_first _ l a a s Is) as (s' & I0).
    destruct (Round s s' I0) as (P0 & Cp & T0 & T1). rewrite E in *. set (m := add (fst s) (fst s')).
    assert (F : dot m p < dot m p); [|lra]. apply (Hp (fun q => dot m p < dot m q)).
    - intros u v k Hk Hu Hv. rewrite dot_add_r, !dot_scal_r. set (d := dot m p) in *. clearbody d.
      destruct (Req_dec k 0) as [->|Nk]; [lra|]. destruct (Req_dec k 1) as [->|Nk']; [lra|].
      assert (0 < k * (dot m u - d)) by (apply Rmult_lt_0_compat; lra).
      assert (0 < (1 - k) * (dot m v - d)) by (apply Rmult_lt_0_compat; lra). lra.
    - intros q [Iq Nq]. apply corner_in in Iq. assert (X := T0 q Iq). assert (Y := T1 q Iq).
      assert (M : forall x, dot m x = dot (fst s) x + dot (fst s') x) by (intros; unfold m, dot; simpl; ring).
      rewrite !M.
      apply Rnot_le_lt. intros L. apply Nq. apply sub_zero.
      assert (Z : sub q p = origin); [|rewrite Z; apply norm2_origin].
      apply (only_zero n (fst s) (fst s')); auto; rewrite dot_sub_r; [rewrite !Flat; auto; lra|lra|lra].
  Qed.

  Theorem round_cornered : NoDup ps -> cornered C ps.
  Proof. intros N. split; [apply round_hull|]. split; [auto|apply round_extreme]. Qed.
End Round.

(* ---- in other units ---- *)
Lemma cornered_scal : forall (C D : pt -> Prop) k ps, 0 < k -> (forall p, C p <-> D (scal k p)) -> cornered C ps ->
  cornered D (map (scal k) ps).
Proof.
  intros C D k ps Hk E (H & N & X). assert (Hi : 0 < / k) by (apply Rinv_0_lt_compat; auto).
  assert (back : forall p, scal k (scal (/ k) p) = p) by (intros; apply scal_inv; lra).
  assert (forth : forall p, scal (/ k) (scal k p) = p) by (intros; apply scal_inv'; lra).
  split; [|split].
  - intros p. rewrite <- (back p), <- E, H. split; intros G.
    + revert G. apply hull_scal. intros s Is. apply in_map; auto.
    + apply (hull_scal _ (fun p => In p ps) (/ k)) in G; [rewrite forth in G; auto|].
      intros s Is. apply in_map_iff in Is. destruct Is as (q & <- & Iq). rewrite forth. auto.
  - apply Injective_map_NoDup; auto. intros p q F. rewrite <- (forth p), F. auto.
  - intros p Ip G. apply in_map_iff in Ip. destruct Ip as (q & <- & Iq). apply (X q Iq).
    apply (hull_scal _ (fun p => In p ps /\ p <> q) (/ k)) in G; [rewrite forth in G; auto|].
    intros s [Is Ns]. apply in_map_iff in Is. destruct Is as (r & <- & Ir). rewrite forth. split; auto. intros ->. auto.
Qed.

(* ---- the optimal directions ---- *)
Lemma at_least_some : forall S d, at_least S d -> exists p, S p.
Proof.
  intros S d [H0 H1]. destruct (Rlt_dec 0 d) as [P0|P0].
  - exists origin. apply interior_in, H0; auto. rewrite norm2_origin. nra.
  - destruct H1 as (p & Hp & _); [lra|]. exists p. auto.
Qed.

(* of sets that are apart there is but one: that of the nearest point *)
Lemma optimal_nearest : forall (S : pt -> Prop) d u v, d < 0 -> at_least S d -> optimal S d u -> optimal S d v -> u = v.
Proof.
  intros S d u v Hd [_ H] Hu Hv. destruct H as (z & Hz & N); [lra|].
  assert (G : forall u, optimal S d u -> z = scal d u).
  { intros w [Nw Bw]. specialize (Bw z Hz). apply sub_zero. assert (P0 := norm2_nonneg (sub z (scal d w))).
    rewrite norm2_sub, dot_scal_r, norm2_scal, Nw, (dot_comm z w) in *. nra. }
  rewrite <- (scal_inv' d u), <- (scal_inv' d v), <- (G u), <- (G v) by (auto; lra). auto.
Qed.

(* and of a set that holds a half-space *)
Lemma optimal_half_space : forall (S : pt -> Prop) m c d u, m <> origin -> (forall x, dot m x <= c -> S x) -> optimal S
  d u -> u = along m 1.
Proof.
  intros S m c d u Hm H [Nu Bu]. assert (N := norm2_pos m Hm). assert (Pm := norm_pos m Hm).
  set (k := dot u m / norm2 m). set (e := sub u (scal k m)). set (y := scal (c / norm2 m) m).
  assert (Y : dot m y = c) by (unfold y; rewrite dot_scal_r; fold (norm2 m); field; lra).
  assert (Me : dot m e = 0). { unfold e, k. rewrite dot_sub_r, dot_scal_r, (dot_comm m u). fold (norm2 m). field. lra. }
  assert (Ue : dot u e = norm2 e).
  { replace (dot u e) with (norm2 e + k * dot m e) by (unfold e, norm2, dot; simpl; ring). rewrite Me. ring. }
  assert (E : e = origin).
  { destruct (origin_dec e) as [Z|Z]; auto. exfalso. assert (Ne := norm2_pos e Z).
    set (l := (d - dot u y + 1) / norm2 e).
    assert (K := Bu (add y (scal l e))). rewrite dot_add_r, dot_scal_r, Ue in K.
    assert (El : l * norm2 e = d - dot u y + 1) by (unfold l; field; lra).
    assert (dot u y + l * norm2 e <= d); [|lra]. apply K, H. rewrite dot_add_r, dot_scal_r, Me, Y. lra. }
  assert (Eu : u = scal k m).
  { unfold e in E. assert (X := f_equal px E). assert (Y' := f_equal py E). assert (Z := f_equal pz E). simpl in *.
    pteq; lra. }
  assert (Um : dot u m = k * norm2 m) by (unfold k; field; lra).
  assert (Pk : 0 <= k).
  { apply Rnot_lt_le. intros L. set (l := (Rmax 0 (d - dot u y) + 1) / (- k * norm2 m)).
    assert (P0 : 0 < - k * norm2 m) by (apply Rmult_lt_0_compat; lra). assert (M0 := Rmax_l 0 (d - dot u y)).
    assert (M1 := Rmax_r 0 (d - dot u y)).
    assert (El : l * (- k * norm2 m) = Rmax 0 (d - dot u y) + 1) by (unfold l; field; split; lra).
    assert (Pl : 0 <= l) by (apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat; auto]).
    assert (K := Bu (sub y (scal l m))). rewrite dot_sub_r, dot_scal_r, Um in K.
    assert (dot u y - l * (k * norm2 m) <= d); [|nra]. apply K, H. rewrite dot_sub_r, dot_scal_r, Y. fold (norm2 m).
    nra. }
  rewrite Eu. unfold along. f_equal. rewrite Eu, norm2_scal, <- norm_sqr in Nu.
  apply Rmult_eq_reg_r with (norm m); [|lra].
  replace (1 / norm m * norm m) with 1 by (field; lra). assert (0 <= k * norm m) by (apply Rmult_le_pos; lra). nra.
Qed.

(* ---- the patch of rounded bodies is that of their cores, moved ---- *)
Theorem body_patch_moved : forall A B d n x, 0 <= radius A -> 0 <= radius B -> optimal (core_gaps A B) d n ->
  (body_patch A B (d + (radius A + radius B)) n x <-> patch_of A B d n (add x (scal (radius A) n))).
Proof.
  intros A B d n x RA RB [Nn Bn]. unfold body_patch, patch_of, meeting, in_body. set (r := radius A) in *.
  set (s := radius B) in *.
  assert (N1 : norm n = 1) by (apply norm_unique; lra). split.
  - intros [(a & Ha & La) (b & Hb & Lb)]. set (e := sub x a) in *. set (f := sub (add x (scal (d + (r + s)) n)) b) in *.
    assert (G : dot n (sub b a) <= d) by (apply Bn; exists b, a; auto).
    assert (E : dot n (sub b a) = d + (r + s) + dot n e - dot n f).
    { replace (sub b a) with (sub (add (scal (d + (r + s)) n) e) f) by (unfold e, f; pteq; ring).
      rewrite dot_sub_r, dot_add_r, dot_scal_r. fold (norm2 n). rewrite Nn. ring. }
    assert (De := dot_le_norm (scal (-1) n) e). rewrite dot_scal_l, norm_minus, N1 in De.
    assert (Df := dot_le_norm n f). rewrite N1 in Df.
    apply norm_le in La; auto. apply norm_le in Lb; auto.
    assert (Fe : e = scal (- r) n).
    { apply sub_zero. assert (P0 := norm2_nonneg (sub e (scal (- r) n))).
      assert (Le : norm2 e <= r * r) by (apply norm_le; auto).
      rewrite norm2_sub, dot_scal_r, norm2_scal, Nn, (dot_comm e n) in *. assert (dot n e <= - r) by lra. nra. }
    assert (Ff : f = scal s n).
    { apply sub_zero. assert (P0 := norm2_nonneg (sub f (scal s n))).
      assert (Lf : norm2 f <= s * s) by (apply norm_le; auto).
      rewrite norm2_sub, dot_scal_r, norm2_scal, Nn, (dot_comm f n) in *. assert (s <= dot n f) by lra. nra. }
    assert (Ea : add x (scal r n) = a).
    { assert (X := f_equal px Fe). assert (Y := f_equal py Fe). assert (Z := f_equal pz Fe). unfold e in *.
      simpl in *. pteq; lra. }
    rewrite Ea. split; auto. replace (add a (scal d n)) with b; auto. rewrite <- Ea.
    assert (X := f_equal px Ff). assert (Y := f_equal py Ff). assert (Z := f_equal pz Ff). unfold f in *. simpl in *.
    pteq; lra.
  - intros [Ha Hb]. split; eexists; (split; [eassumption|]).
    + replace (sub x (add x (scal r n))) with (scal (- r) n) by (pteq; ring). rewrite norm2_scal, Nn. nra.
    + replace (sub (add x (scal (d + (r + s)) n)) (add (add x (scal r n)) (scal d n))) with (scal s n) by (pteq; ring).
      rewrite norm2_scal, Nn. nra.
Qed.

(* ---- a greatest value on a hull is at a corner ---- *)
Lemma speed_hull : forall v w n ps r, (forall p, In p ps -> speed v w n p <= r) -> forall p, conv ps p -> speed v w n p
  <= r.
Proof.
  intros v w n ps r H p Hp. apply (Hp (fun p => speed v w n p <= r)); auto.
  intros x y k Hk Hx Hy. replace (speed v w n (add (scal k x) (scal (1 - k) y))) with (k * speed v w n x + (1 - k) *
    speed v w n y)
    by (unfold speed, dot; simpl; ring). nra.
Qed.

Theorem rate_unique : forall A B d v w r s, rate_is A B d v w r -> rate_is A B d v w s -> r = s.
Proof.
  intros A B d v w.
  assert (G : forall r s, rate_is A B d v w r -> rate_is A B d v w s -> r <= s).
  { intros r s [H _] [_ (n & Hn & L)]. destruct (H n Hn) as (p & Hp & K). specialize (L p Hp). lra. }
  intros r s R S. apply Rle_antisym; auto.
Qed.
