(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Format 6: what the checker of motions accepts is true, at every time. *)
Require Import Reals Lra Psatz List ZArith Lia Bool.
From Fathom.checker Require Import vector sequence table support verdict impact.
From Fathom.geometry Require Import meaning space hulls turns.
From Fathom.soundness Require Import statement booleans upper verdict_sound.
Import ListNotations.
Open Scope R_scope.

(* ---- polynomials ---- *)
Section Values.
  Variables v u : R.

  Fixpoint ev (p : poly) : R := match p with [] => 0 | c :: r => IZR c * v ^ length r + u * ev r end.
  Definition evv (x : pvec) : pt := mk (ev (pvx x)) (ev (pvy x)) (ev (pvz x)).
  Definition deg (n : nat) (p : poly) : Prop := length p = S n.
  Definition vdeg (n : nat) (x : pvec) : Prop := deg n (pvx x) /\ deg n (pvy x) /\ deg n (pvz x).

  Lemma ev_add_same : forall p q, length p = length q -> ev (padd p q) = ev p + ev q /\ length (padd p q) = length p.
  Proof.
    induction p as [|a p IH]; intros [|b q] H; try discriminate; simpl in *; [split; [ring|auto]|].
    destruct (IH q) as [E L]; [lia|]. rewrite E, L, plus_IZR. replace (length q) with (length p) by lia.
    split; [ring|auto].
  Qed.
  Lemma ev_scale : forall k p, ev (pscale k p) = IZR k * ev p /\ length (pscale k p) = length p.
  Proof.
    intros k p. unfold pscale. rewrite map_length. split; auto.
    induction p as [|a p IH]; simpl; [ring|]. rewrite map_length, IH, mult_IZR. ring.
  Qed.
  Lemma ev_zeros : forall p n, ev (p ++ repeat 0%Z n) = v ^ n * ev p.
  Proof.
    induction p as [|a p IH]; intros n; simpl.
    - rewrite Rmult_0_r. induction n as [|n IH]; simpl; [auto|]. rewrite IH. ring.
    - rewrite IH, app_length, repeat_length, pow_add. ring.
  Qed.
  Lemma ev_mul_same : forall p q, q <> [] -> ev (pmul p q) = ev p * ev q /\
    (p <> [] -> length (pmul p q) = (length p + length q - 1)%nat).
  Proof.
    intros p q Nq. assert (Lq : (0 < length q)%nat) by (destruct q; [congruence|simpl; lia]).
    induction p as [|a p IH]; [simpl; split; [ring|congruence]|]. destruct p as [|b p].
    - cbn [pmul ev length]. destruct (ev_scale a q) as [E L]. rewrite E, L. simpl. split; [ring|lia].
    - destruct IH as [E L]. specialize (L ltac:(discriminate)). destruct (ev_scale a q) as [Es Ls].
      change (pmul (a :: b :: p) q) with (padd (pscale a q ++ repeat 0%Z (length (b :: p))) (0%Z :: pmul (b :: p) q)).
      destruct (ev_add_same (pscale a q ++ repeat 0%Z (length (b :: p))) (0%Z :: pmul (b :: p) q)) as [Ea La].
      { rewrite app_length, repeat_length, Ls. cbn [length] in *. lia. }
      rewrite Ea, La, ev_zeros, Es, app_length, repeat_length, Ls. cbn [ev] in *. rewrite E. cbn [length].
      split; [ring|intros _; lia].
  Qed.

  Lemma ev_add : forall n p q, deg n p -> deg n q -> ev (padd p q) = ev p + ev q /\ deg n (padd p q).
  Proof. unfold deg. intros n p q Hp Hq. destruct (ev_add_same p q) as [E L]; [congruence|]. rewrite L. auto. Qed.
  Lemma ev_mul : forall m n p q, deg m p -> deg n q -> ev (pmul p q) = ev p * ev q /\ deg (m + n) (pmul p q).
  Proof.
    unfold deg. intros m n p q Hp Hq. destruct (ev_mul_same p q) as [E L]; [intros ->; discriminate|].
    rewrite L by (intros ->; discriminate). split; auto. lia.
  Qed.
  Lemma ev_neg : forall n p, deg n p -> ev (pscale (-1) p) = - ev p /\ deg n (pscale (-1) p).
  Proof. unfold deg. intros n p H. destruct (ev_scale (-1) p) as [E L]. rewrite E, L. split; [ring|auto]. Qed.

  Lemma ev_vadd : forall n x y, vdeg n x -> vdeg n y -> evv (vadd x y) = add (evv x) (evv y) /\ vdeg n (vadd x y).
  Proof.
    intros n x y (X1 & X2 & X3) (Y1 & Y2 & Y3). unfold evv, vadd, vdeg, add; cbn [pvx pvy pvz px py pz].
    destruct (ev_add n _ _ X1 Y1) as [-> ?], (ev_add n _ _ X2 Y2) as [-> ?], (ev_add n _ _ X3 Y3) as [-> ?]. auto.
  Qed.
  Lemma ev_vscale : forall m n p x,
    deg m p -> vdeg n x -> evv (vscale p x) = scal (ev p) (evv x) /\ vdeg (m + n) (vscale p x).
  Proof.
    intros m n p x Hp (X1 & X2 & X3). unfold evv, vscale, vdeg, scal; cbn [pvx pvy pvz px py pz].
    destruct (ev_mul m n _ _ Hp X1) as [-> ?], (ev_mul m n _ _ Hp X2) as [-> ?], (ev_mul m n _ _ Hp X3) as [-> ?]. auto.
  Qed.
  Lemma ev_vneg : forall n x, vdeg n x -> evv (vneg x) = minus (evv x) /\ vdeg n (vneg x).
  Proof.
    intros n x (X1 & X2 & X3). unfold evv, vneg, vdeg, minus, scal; cbn [pvx pvy pvz px py pz].
    destruct (ev_neg n _ X1) as [-> ?], (ev_neg n _ X2) as [-> ?], (ev_neg n _ X3) as [-> ?]. split; [pteq; ring|auto].
  Qed.
  Lemma ev_vdot : forall m n x y, vdeg m x -> vdeg n y -> ev (vdot x y) = dot (evv x) (evv y) /\ deg (m + n) (vdot x y).
  Proof.
    intros m n x y (X1 & X2 & X3) (Y1 & Y2 & Y3). unfold evv, vdot, dot; cbn [px py pz].
    destruct (ev_mul m n _ _ X1 Y1) as [E1 D1], (ev_mul m n _ _ X2 Y2) as [E2 D2], (ev_mul m n _ _ X3 Y3) as [E3 D3].
    destruct (ev_add (m + n) _ _ D1 D2) as [E4 D4], (ev_add (m + n) _ _ D4 D3) as [E5 D5].
    rewrite E5, E4, E1, E2, E3. auto.
  Qed.
  Lemma ev_minor : forall m n a b c d, deg m a -> deg m b -> deg n c -> deg n d ->
    ev (minor a b c d) = ev a * ev d - ev b * ev c /\ deg (m + n) (minor a b c d).
  Proof.
    intros m n a b c d Ha Hb Hc Hd. unfold minor.
    destruct (ev_mul m n _ _ Ha Hd) as [E1 D1], (ev_mul m n _ _ Hb Hc) as [E2 D2].
    destruct (ev_neg _ _ D2) as [E3 D3], (ev_add _ _ _ D1 D3) as [E4 D4]. rewrite E4, E3, E1, E2. split; [ring|auto].
  Qed.
  Lemma ev_vcross : forall m n x y,
    vdeg m x -> vdeg n y -> evv (vcross x y) = cross (evv x) (evv y) /\ vdeg (m + n) (vcross x y).
  Proof.
    intros m n x y (X1 & X2 & X3) (Y1 & Y2 & Y3). unfold evv, vcross, vdeg, cross; cbn [pvx pvy pvz px py pz].
    destruct (ev_minor m n _ _ _ _ X2 X3 Y2 Y3) as [-> ?], (ev_minor m n _ _ _ _ X3 X1 Y3 Y1) as [-> ?],
      (ev_minor m n _ _ _ _ X1 X2 Y1 Y2) as [-> ?].
    auto.
  Qed.
  Lemma ev_plength2 : forall r x, deg 1 r -> vdeg 1 x -> ev (plength2 r x) = sq (ev r) (evv x) /\ deg 2 (plength2 r x).
  Proof.
    intros r x Hr Hx. unfold plength2, norm2.
    destruct (ev_mul 1 1 _ _ Hr Hr) as [E1 D1], (ev_vdot 1 1 _ _ Hx Hx) as [E2 D2].
    destruct (ev_add 2 _ _ D1 D2) as [E3 D3]. rewrite E3, E1, E2. auto.
  Qed.
  Lemma ev_rotate : forall n r x y, deg 1 r -> vdeg 1 x -> vdeg n y ->
    evv (protate r x y) = rotate (ev r) (evv x) (evv y) /\ vdeg (2 + n) (protate r x y).
  Proof.
    intros n r x y Hr Hx Hy. unfold protate, rotate.
    destruct (ev_mul 1 1 _ _ Hr Hr) as [E1 D1], (ev_vdot 1 1 _ _ Hx Hx) as [E2 D2], (ev_neg 2 _ D2) as [E3 D3],
      (ev_add 2 _ _ D1 D3) as [E4 D4].
    destruct (ev_vscale 2 n _ _ D4 Hy) as [E5 D5]. destruct (ev_vdot 1 n _ _ Hx Hy) as [E6 D6].
    destruct (ev_vscale (1 + n) 1 _ _ D6 Hx) as [E7 D7]. destruct (ev_vcross 1 n _ _ Hx Hy) as [E8 D8].
    destruct (ev_vscale 1 (1 + n) _ _ Hr D8) as [E9 D9].
    replace (1 + n + 1)%nat with (2 + n)%nat in D7 by lia. replace (1 + (1 + n))%nat with (2 + n)%nat in D9 by lia.
    destruct (ev_vadd (2 + n) _ _ D7 D9) as [E10 D10]. assert (D2' : deg 0 [2%Z]) by reflexivity.
    destruct (ev_vscale 0 (2 + n) _ _ D2' D10) as [E11 D11]. cbn [Nat.add] in *.
    destruct (ev_vadd _ _ _ D5 D11) as [E12 D12].
    rewrite E12, E11, E10, E9, E8, E7, E6, E5, E4, E3, E2, E1. split; auto.
    apply f_equal2; [apply f_equal2; [unfold norm2; ring|reflexivity]|apply f_equal2; [simpl; ring|reflexivity]].
  Qed.
  Lemma ev_constant : forall n, evv (constant n) = inj n /\ vdeg 0 (constant n).
  Proof. intros n. split; [unfold evv, constant, inj; cbn [pvx pvy pvz ev]; f_equal; simpl; ring|repeat split]. Qed.

  (* of one sign, so is the value *)
  Lemma ev_positive : forall p, 0 <= v -> 0 <= u -> 0 < v + u -> p <> [] -> (forall c, In c p -> (0 < c)%Z) -> 0 < ev p.
  Proof.
    induction p as [|c p IH]; intros Hv Hu S N H; [congruence|]. simpl.
    assert (Pc : 0 < IZR c) by (apply IZR_lt, H; simpl; auto). destruct p as [|d p]; [simpl; lra|].
    assert (P : 0 < ev (d :: p)) by (apply IH; auto; [discriminate|intros x I; apply H; right; exact I]).
    assert (V : 0 <= v ^ length (d :: p)) by (apply pow_le; auto).
    destruct (Req_dec u 0) as [Z|Z].
    - assert (0 < v ^ length (d :: p)) by (apply pow_lt; lra). nra.
    - assert (0 < u * ev (d :: p)) by (apply Rmult_lt_0_compat; lra). nra.
  Qed.
End Values.

(* the coefficients of D + L (<us, a> - <vs, b>) *)
Fixpoint combined (L : Z) (D : poly) (us vs : list zvec) (a b : zvec) : poly :=
  match D, us, vs with
  | d :: D', p :: us', q :: vs' => (d + L * (zdot p a - zdot q b))%Z :: combined L D' us' vs' a b
  | _, _, _ => []
  end.

Lemma ev_combined : forall v u L a b D xs ys zs xs' ys' zs',
  length xs = length D -> length ys = length D -> length zs = length D ->
  length xs' = length D -> length ys' = length D -> length zs' = length D ->
  ev v u (combined L D (rows xs ys zs) (rows xs' ys' zs') a b)
    = ev v u D + IZR L * (dot (evv v u (Pvec xs ys zs)) (inj a) - dot (evv v u (Pvec xs' ys' zs')) (inj b))
  /\ length (combined L D (rows xs ys zs) (rows xs' ys' zs') a b) = length D.
Proof.
  intros v u L a b. induction D as [|d D IH];
    intros [|x xs] [|y ys] [|z zs] [|x' xs'] [|y' ys'] [|z' zs'] H1 H2 H3 H4 H5 H6; try discriminate.
  - split; auto. unfold dot; simpl. ring.
  - cbn [length] in *. destruct (IH xs ys zs xs' ys' zs') as [E Ln]; try lia.
    cbn [rows combined ev evv pvx pvy pvz length]. rewrite E, Ln. split; auto.
    unfold zdot, dot, evv, inj; cbn [zx zy zz px py pz pvx pvy pvz ev].
    replace (length xs) with (length D) by lia. replace (length ys) with (length D) by lia.
    replace (length zs) with (length D) by lia.
    replace (length xs') with (length D) by lia. replace (length ys') with (length D) by lia.
    replace (length zs') with (length D) by lia.
    rewrite !plus_IZR, !mult_IZR, !minus_IZR, !plus_IZR, !mult_IZR. ring.
Qed.

Lemma all_positive_spec : forall A B L a b, (0 < L)%Z -> In a A -> In b B -> forall D us vs,
  all_positive A B L D us vs = true ->
  forall c, In c (combined L D us vs a b) -> (0 < c)%Z.
Proof.
  intros A B L a b HL Ia Ib. induction D as [|d D IH]; intros [|p us] [|q vs] H c I; try contradiction.
  cbn [all_positive] in H. destruct (positive_at A B L d p q) eqn:E; [|discriminate]. cbn [combined In] in I.
  destruct I as [<-|I]; [|eauto]. unfold positive_at in E.
  destruct (greatest (zneg p) A) as [x|] eqn:Ex; [|discriminate].
  destruct (greatest q B) as [y|] eqn:Ey; [|discriminate].
  apply greatest_spec in Ex. apply greatest_spec in Ey. destruct Ex as [_ Mx]. destruct Ey as [_ My].
  specialize (Mx a Ia). specialize (My b Ib).
  bsplit. assert (N : zdot (zneg p) a = (- zdot p a)%Z) by (unfold zdot, zneg; simpl; ring). rewrite N in Mx. nia.
Qed.

(* ---- on a piece ---- *)
Lemma later_value : forall s e, later s e = true -> value s <= value e /\ 0 < IZR (den s) /\ 0 < IZR (den e).
Proof.
  intros [a b] [c d] H. unfold later in H. bsplit. cbn [num den] in *. unfold value; cbn [num den].
  assert (Pb : 0 < IZR b) by (apply IZR_lt; auto). assert (Pd : 0 < IZR d) by (apply IZR_lt; auto). split; auto.
  apply IZR_le in H0. rewrite !mult_IZR in H0. apply Rmult_le_reg_r with (IZR b * IZR d); [nra|].
  replace (IZR a / IZR b * (IZR b * IZR d)) with (IZR a * IZR d) by (field; lra).
  replace (IZR c / IZR d * (IZR b * IZR d)) with (IZR c * IZR b) by (field; lra). auto.
Qed.

(* a time of [s, e] as a mean *)
Lemma time_mean : forall s e t, s <= t <= e -> exists v u, 0 <= v /\ 0 <= u /\ v + u = 1 /\ t = v * s + u * e.
Proof.
  intros s e t H. destruct (Req_dec s e) as [<-|N].
  - exists 1, 0. repeat split; lra.
  - exists ((e - t) / (e - s)), ((t - s) / (e - s)). assert (P : 0 < / (e - s)) by (apply Rinv_0_lt_compat; lra).
    split; [apply Rmult_le_pos; lra|]. split; [apply Rmult_le_pos; lra|]. split; field; lra.
Qed.

Lemma mean_positive : forall l x y, 0 <= l <= 1 -> 0 < x -> 0 < y -> 0 < l * x + (1 - l) * y.
Proof.
  intros l x y Hl Hx Hy. destruct (Req_dec l 0) as [->|N]; [lra|]. assert (0 < l * x) by (apply Rmult_lt_0_compat; lra).
  assert (0 <= (1 - l) * y) by (apply Rmult_le_pos; lra). lra.
Qed.

Section Piece.
  Variables (s e : ratio) (t v u : R).
  Hypothesis Hs : 0 < IZR (den s).
  Hypothesis He : 0 < IZR (den e).
  Hypothesis Ht : t = v * value s + u * value e.
  Hypothesis Hu : v + u = 1.
  Let L : R := IZR (den s * den e).

  Lemma L_positive : 0 < L.
  Proof. unfold L. rewrite mult_IZR. apply Rmult_lt_0_compat; auto. Qed.
  Lemma on_piece_value : forall x y, ev v u (on_piece s e x y) = L * ((1 - t) * IZR x + t * IZR y).
  Proof.
    intros x y. unfold on_piece, L, value in *. cbn [ev length]. rewrite Ht.
    rewrite !mult_IZR, !plus_IZR, !mult_IZR, !minus_IZR. replace v with (1 - u) by lra. simpl pow. field. lra.
  Qed.
  Lemma vectors_value : forall x y,
    evv v u (vectors_on s e x y) = scal L (mean t (inj x) (inj y)) /\ vdeg 1 (vectors_on s e x y).
  Proof.
    intros x y. split; [|repeat split]. unfold evv, vectors_on; cbn [pvx pvy pvz]. rewrite !on_piece_value. pteq; ring.
  Qed.

  Variables (m k : Z) (A B : list zvec) (MA MB : motion zvec Z).
  Hypothesis Hm : 0 < IZR m.
  Hypothesis Hk : 0 < IZR k.
  (* the motion that these integers stand for *)
  Definition unit_pose (o : pose zvec Z) : pose pt R := Pose (frac m (spot o)) (IZR (scalar o) / IZR k) (frac k (axis
    o)).
  Definition unit_motion (M : motion zvec Z) : motion pt R := Motion (unit_pose (at_start M)) (unit_pose (at_end M)).

  Lemma frac_scal : forall n x, 0 < IZR n -> frac n x = scal (/ IZR n) (inj x).
  Proof. intros n x H. unfold frac, inj. pteq; field; lra. Qed.
  Lemma mean_scal : forall c x y, mean t (scal c x) (scal c y) = scal c (mean t x y).
  Proof. intros. unfold mean. pteq; ring. Qed.

  (* in units: the same place *)
  Lemma placed_units : forall M x, let o := pose_at (unit_motion M) t in
    let r := ev v u (scalar_on s e M) in let w := evv v u (axis_on s e M) in let p := evv v u (spot_on s e M) in
    (0 < sq r w -> 0 < length2 o) /\ (0 < sq r w ->
    scal (L * IZR m) (placed o x) = place p r w (scal (L * IZR m) x)).
  Proof.
    intros M x o r w p. assert (PL := L_positive).
    assert (Er : r = L * IZR k * scalar o).
    { unfold r, scalar_on, o. rewrite on_piece_value. cbn. field. lra. }
    assert (Ew : w = scal (L * IZR k) (axis o)).
    { unfold w, axis_on, o. destruct (vectors_value (axis (at_start M)) (axis (at_end M))) as [-> _].
      cbn [pose_at unit_motion unit_pose axis at_start at_end].
      rewrite !frac_scal, mean_scal, scal_scal by auto. f_equal. field. lra. }
    assert (Ep : p = scal (L * IZR m) (spot o)).
    { unfold p, spot_on, o. destruct (vectors_value (spot (at_start M)) (spot (at_end M))) as [-> _].
      cbn [pose_at unit_motion unit_pose spot at_start at_end].
      rewrite !frac_scal, mean_scal, scal_scal by auto. f_equal. field. lra. }
    assert (Es : sq r w = L * IZR k * (L * IZR k) * length2 o) by (rewrite Er, Ew, sq_units; reflexivity).
    assert (PK : 0 < L * IZR k) by (apply Rmult_lt_0_compat; auto).
    assert (PQ : 0 < L * IZR k * (L * IZR k)) by (apply Rmult_lt_0_compat; auto).
    assert (P1 : 0 < sq r w -> 0 < length2 o) by (rewrite Es; intros P;
      apply Rmult_lt_reg_l with (L * IZR k * (L * IZR k)); lra).
    split; auto. intros P. specialize (P1 P). unfold place. rewrite Es, Er, Ew, Ep, rotate_units, rotate_scal.
    change (placed o) with (place (spot o) (scalar o) (axis o)). unfold place. fold (length2 o).
    generalize (rotate (scalar o) (axis o) x). intros X. pteq; field; repeat split; lra.
  Qed.

  Hypothesis Pv : 0 <= v.
  Hypothesis Pu : 0 <= u.

  Lemma conditions_value : forall f D U V, conditions MA MB s e f = (D, U, V) ->
    shown (evv v u (spot_on s e MA)) (evv v u (spot_on s e MB)) (ev v u (scalar_on s e MA)) (ev v u (scalar_on s e MB))
      (evv v u (axis_on s e MA)) (evv v u (axis_on s e MB)) (ev v u D) (evv v u U) (evv v u V) /\ deg 5 D /\ vdeg 5 U
        /\ vdeg 5 V.
  Proof.
    intros f D U V H. unfold conditions in H. cbv zeta in H.
    set (ra := scalar_on s e MA) in *. set (rb := scalar_on s e MB) in *.
    set (va := axis_on s e MA) in *. set (vb := axis_on s e MB) in *. set (pa := spot_on s e MA) in *.
    set (pb := spot_on s e MB) in *.
    assert (Dra : deg 1 ra) by reflexivity. assert (Drb : deg 1 rb) by reflexivity.
    assert (Dva : vdeg 1 va) by (repeat split). assert (Dvb : vdeg 1 vb) by (repeat split).
    assert (Dpa : vdeg 1 pa) by (repeat split). assert (Dpb : vdeg 1 pb) by (repeat split).
    destruct (ev_vneg v u 1 va Dva) as [Ena Dna], (ev_vneg v u 1 vb Dvb) as [Enb Dnb].
    destruct (ev_plength2 v u ra va Dra Dva) as [Ewa Dwa], (ev_plength2 v u rb vb Drb Dvb) as [Ewb Dwb].
    destruct (ev_vneg v u 1 pb Dpb) as [Epb Dpb'], (ev_vadd v u 1 pa (vneg pb) Dpa Dpb') as [Ed Dd].
    assert (Ed' : evv v u (vadd pa (vneg pb)) = sub (evv v u pa) (evv v u pb)) by (rewrite Ed, Epb; pteq; ring).
    destruct (ev_mul v u 2 2 _ _ Dwa Dwb) as [Ew Dw]. cbn [Nat.add] in *.
    assert (D1 : deg 1 [1; 1]%Z) by reflexivity.
    assert (R : forall X, vdeg 4 X -> evv v u (vscale [1; 1]%Z X) = evv v u X /\ vdeg 5 (vscale [1; 1]%Z X)).
    { intros X DX. destruct (ev_vscale v u 1 4 [1; 1]%Z X D1 DX) as [E DE]. split; auto. rewrite E.
      replace (ev v u [1; 1]%Z) with 1 by (cbn; lra). apply scal_1. }
    destruct f as [n|n|f g]; cbv iota beta in H; apply pair_equal_spec in H; destruct H as [H <-];
      apply pair_equal_spec in H; destruct H as [<- <-].
    - destruct (ev_constant v u n) as [En Dn]. destruct (ev_rotate v u 0 rb vb (constant n) Drb Dvb Dn) as [Eh Dh].
      cbn [Nat.add] in Dh.
      set (h := protate rb vb (constant n)) in *. destruct (ev_vdot v u 2 1 h _ Dh Dd) as [E1 F1].
      destruct (ev_mul v u 2 3 _ _ Dwa F1) as [E2 F2].
      destruct (ev_rotate v u 2 ra (vneg va) h Dra Dna Dh) as [E3 F3]. destruct (R _ F3) as [E4 F4].
      destruct (ev_vscale v u 4 0 _ _ Dw Dn) as [E5 F5]. destruct (R _ F5) as [E6 F6].
      rewrite E2, E1, E4, E3, E6, E5, Ew, Ewa, Ewb, Ed', Ena, Eh, En.
      split; [|split; [exact F2|split; [exact F4|exact F6]]].
      apply b_shows.
    - destruct (ev_constant v u n) as [En Dn]. destruct (ev_rotate v u 0 ra va (constant n) Dra Dva Dn) as [Eh Dh].
      cbn [Nat.add] in Dh.
      set (h := protate ra va (constant n)) in *. destruct (ev_vdot v u 2 1 h _ Dh Dd) as [E1 F1].
      destruct (ev_mul v u 2 3 _ _ Dwb F1) as [E2 F2].
      destruct (ev_rotate v u 2 rb (vneg vb) h Drb Dnb Dh) as [E3 F3]. destruct (R _ F3) as [E4 F4].
      destruct (ev_vscale v u 4 0 _ _ Dw Dn) as [E5 F5]. destruct (R _ F5) as [E6 F6].
      rewrite E2, E1, E4, E3, E6, E5, Ew, Ewa, Ewb, Ed', Enb, Eh, En.
      split; [|split; [exact F2|split; [exact F4|exact F6]]].
      apply a_shows.
    - destruct (ev_constant v u f) as [Ef Df], (ev_constant v u g) as [Eg Dg].
      destruct (ev_rotate v u 0 ra va (constant f) Dra Dva Df) as [Eh Dh],
        (ev_rotate v u 0 rb vb (constant g) Drb Dvb Dg) as [Ek Dk].
      cbn [Nat.add] in Dh, Dk. set (h := protate ra va (constant f)) in *. set (j := protate rb vb (constant g)) in *.
      destruct (ev_vcross v u 2 2 h j Dh Dk) as [E1 F1]. destruct (ev_vdot v u 4 1 _ _ F1 Dd) as [E2 F2].
      destruct (ev_rotate v u 2 ra (vneg va) j Dra Dna Dk) as [E3 F3],
        (ev_rotate v u 2 rb (vneg vb) h Drb Dnb Dh) as [E4 F4].
      destruct (ev_vcross v u 0 4 _ _ Df F3) as [E5 F5], (ev_vcross v u 4 0 _ _ F4 Dg) as [E6 F6].
      destruct (R _ F5) as [E7 F7], (R _ F6) as [E8 F8].
      rewrite E2, E1, E7, E5, E3, E8, E6, E4, Ed', Ena, Enb, Eh, Ek, Ef, Eg.
      split; [|split; [exact F2|split; [exact F7|exact F8]]].
      apply edges_show.
  Qed.

  Lemma apart_on_sound : forall f, apart_on A B MA MB s e f = true ->
    (exists a, In a A) -> (exists b,
      In b B) -> let oA := pose_at (unit_motion MA) t in let oB := pose_at (unit_motion MB) t in
    0 < length2 oA /\ 0 < length2 oB /\
    forall x y, conv (map (frac m) A) x -> conv (map (frac m) B) y -> 0 < norm2 (sub (placed oA x) (placed oB y)).
  Proof.
    intros f H (a0 & Ia0) (b0 & Ib0) oA oB. unfold apart_on in H. destruct (conditions MA MB s e f) as [[D U] V] eqn:E.
    destruct (conditions_value f D U V E) as (S & DD & (DU1 & DU2 & DU3) & (DV1 & DV2 & DV3)).
    assert (PL := L_positive). assert (PZ : (0 < den s * den e)%Z) by (apply lt_IZR; exact PL). set (K := L * IZR m).
    assert (PK : 0 < K) by (apply Rmult_lt_0_compat; auto).
    set (F := fun x y => ev v u D + dot (evv v u U) (scal K x) - dot (evv v u V) (scal K y)).
    assert (FP : forall a b, In a A -> In b B -> 0 < F (frac m a) (frac m b)).
    { intros a b Ia Ib. assert (C := all_positive_spec A B _ a b PZ Ia Ib _ _ _ H). unfold coefficients in C.
      destruct (ev_combined v u (den s * den e) a b D (pvx U) (pvy U) (pvz U) (pvx V) (pvy V) (pvz V)) as [Ev Ln];
        try (unfold deg in *; congruence).
      assert (P : 0 < ev v u (combined (den s * den e) D (rows (pvx U) (pvy U) (pvz U)) (rows (pvx V) (pvy V) (pvz V))
        a b)).
      { apply ev_positive; auto; [lra|]. intros Z. rewrite Z in Ln. unfold deg in DD. rewrite DD in Ln. discriminate. }
      rewrite Ev in P. unfold F. rewrite !frac_scal, !scal_scal by auto.
      replace (K * / IZR m) with L by (unfold K; field; lra).
      rewrite !dot_scal_r. fold L in P. destruct U as [u1 u2 u3], V as [v1 v2 v3]. cbn [pvx pvy pvz] in P. lra. }
    assert (FH : forall x y, conv (map (frac m) A) x -> conv (map (frac m) B) y -> 0 < F x y).
    { intros x y Hx Hy. apply (Hx (fun x => 0 < F x y)).
      - intros p q l Hl Hp Hq. replace (F _ y) with (l * F p y + (1 - l) * F q y) by (unfold F; rewrite !dot_scal_r,
        dot_add_r, !dot_scal_r; ring).
        apply mean_positive; auto.
      - intros a Ia. apply in_map_iff in Ia. destruct Ia as (a' & <- & Ia). apply (Hy (fun y => 0 < F (frac m a') y)).
        + intros p q l Hl Hp Hq. replace (F (frac m a') (add (scal l p) (scal (1 - l) q))) with (l * F (frac m a') p +
          (1 - l) * F (frac m a') q)
            by (unfold F; rewrite !dot_scal_r, dot_add_r, !dot_scal_r; ring). apply mean_positive; auto.
        + intros b Ib. apply in_map_iff in Ib. destruct Ib as (b' & <- & Ib). auto. }
    assert (W : forall x y, 0 < F x y -> 0 < length2 oA /\ 0 < length2 oB /\ 0 < norm2 (sub (placed oA x) (placed oB
      y))).
    { intros x y P. destruct (S (scal K x) (scal K y) P) as (Wa & Wb & n & N).
      destruct (placed_units MA x) as [QA RA], (placed_units MB y) as [QB RB]. specialize (QA Wa). specialize (QB Wb).
      specialize (RA Wa). specialize (RB Wb). fold oA in QA, RA. fold oB in QB, RB. fold K in RA, RB.
      rewrite <- RA, <- RB in N.
      split; auto. split; auto. apply norm2_pos. intros Z.
      assert (X : dot n (sub (scal K (placed oA x)) (scal K (placed oB y))) = K * dot n (sub (placed oA x)
        (placed oB y))) by (rewrite !dot_sub_r, !dot_scal_r; ring).
      rewrite X, Z in N. unfold dot, origin in N; simpl in N. lra. }
    destruct (W _ _ (FP a0 b0 Ia0 Ib0)) as (W1 & W2 & _). split; auto. split; auto. intros x y Hx Hy.
    apply (W x y), FH; auto.
  Qed.
End Piece.

(* ---- at one time ---- *)
Lemma hull_image : forall (f : pt -> pt) L p, (forall x y l,
  f (add (scal l x) (scal (1 - l) y)) = add (scal l (f x)) (scal (1 - l) (f y))) ->
  conv (map f L) p -> exists x, conv L x /\ f x = p.
Proof.
  intros f L p H Hp. apply (Hp (fun p => exists x, conv L x /\ f x = p)).
  - intros x y l Hl (x' & Hx & <-) (y' & Hy & <-). exists (add (scal l x') (scal (1 - l) y')). split; auto.
    apply hull_convex; auto.
  - intros q Iq. apply in_map_iff in Iq. destruct Iq as (x & <- & Ix). exists x. split; auto. apply hull_in. auto.
Qed.
Lemma placed_mean : forall o x y l,
  placed o (add (scal l x) (scal (1 - l) y)) = add (scal l (placed o x)) (scal (1 - l) (placed o y)).
Proof. intros. unfold placed, dot, cross. pteq; ring. Qed.
Lemma inj_rotate : forall r v x, inj (zrotate r v x) = rotate (IZR r) (inj v) (inj x).
Proof.
  intros. unfold zrotate, rotate.
  rewrite inj_add, !inj_scal, inj_add, !inj_scal, inj_cross, minus_IZR, mult_IZR, norm2_inj, dot_inj. reflexivity.
Qed.

Section Moment.
  Variables (t : ratio) (m k : Z).
  Hypothesis Ht : 0 < IZR (den t).
  Hypothesis Hm : 0 < IZR m.
  Hypothesis Hk : 0 < IZR k.

  Lemma at_moment_value : forall x y, IZR (at_moment t x y) = IZR (den t) * ((1 - value t) * IZR x + value t * IZR y).
  Proof. intros. unfold at_moment, value. rewrite plus_IZR, !mult_IZR, minus_IZR. field. lra. Qed.
  Lemma vector_at_value : forall x y, inj (vector_at t x y) = scal (IZR (den t)) (mean (value t) (inj x) (inj y)).
  Proof. intros. unfold vector_at, value. rewrite inj_add, !inj_scal, minus_IZR. pteq; field; lra. Qed.

  Lemma moment_points : forall M c, (0 < length_at t M)%Z -> let o := pose_at (unit_motion m k M) (value t) in
    let K := IZR c * (IZR m * (IZR (den t) * IZR (length_at t M))) in
    0 < length2 o /\ forall L, map inj (placed_points t c M L) = map (fun x => scal K (placed o x)) (map (frac m) L).
  Proof.
    intros M c H o K. apply IZR_lt in H. set (D := IZR (den t)) in *.
    set (r := at_moment t (scalar (at_start M)) (scalar (at_end M))).
    set (v := vector_at t (axis (at_start M)) (axis (at_end M))).
    assert (Er : IZR r = D * IZR k * scalar o) by (unfold r, o; rewrite at_moment_value; cbn; fold D; field; lra).
    assert (Ev : inj v = scal (D * IZR k) (axis o)).
    { unfold v, o. rewrite vector_at_value. cbn [pose_at unit_motion unit_pose axis at_start at_end].
      rewrite !frac_scal, mean_scal, scal_scal by auto. fold D. f_equal. field. lra. }
    assert (Ep : inj (vector_at t (spot (at_start M)) (spot (at_end M))) = scal (D * IZR m) (spot o)).
    { unfold o. rewrite vector_at_value. cbn [pose_at unit_motion unit_pose spot at_start at_end].
      rewrite !frac_scal, mean_scal, scal_scal by auto. fold D. f_equal. field. lra. }
    assert (El : IZR (length_at t M) = D * IZR k * (D * IZR k) * length2 o).
    { unfold length_at, zlength2. fold r v. rewrite plus_IZR, mult_IZR, norm2_inj, Er, Ev, norm2_scal.
      unfold length2. ring. }
    assert (PK : 0 < D * IZR k) by (apply Rmult_lt_0_compat; auto).
    assert (PQ : 0 < D * IZR k * (D * IZR k)) by (apply Rmult_lt_0_compat; auto).
    assert (P : 0 < length2 o) by (apply Rmult_lt_reg_l with (D * IZR k * (D * IZR k)); lra).
    split; auto. intros L. unfold placed_points. fold r v. rewrite each_map, !map_map. apply map_ext. intros x.
    rewrite inj_scal, inj_add, !inj_scal, inj_rotate. change (zlength2 r v) with (length_at t M).
    rewrite Ep, Er, Ev, rotate_units. fold D.
    replace (inj x) with (scal (IZR m) (frac m x)) by (rewrite frac_scal, scal_scal by auto;
      replace (IZR m * / IZR m) with 1 by (field; lra); apply scal_1).
    rewrite rotate_scal. change (placed o) with (place (spot o) (scalar o) (axis o)). unfold place, K. rewrite El.
    fold (length2 o).
    generalize (rotate (scalar o) (axis o) (frac m x)). intros X. pteq; field; lra.
  Qed.

  Variables (A B : list zvec) (MA MB : motion zvec Z).
  Lemma near_at_sound : forall d w, near_at m A B MA MB t d w = true ->
    have_place (unit_motion m k MA) (unit_motion m k MB) (value t)
    /\ as_near (map (frac m) A) (map (frac m) B) (unit_motion m k MA) (unit_motion m k MB) (value t) (value d).
  Proof.
    intros d w H. unfold near_at in H. cbv zeta in H. apply andb_true_iff in H. destruct H as [H N].
    do 6 (apply andb_true_iff in H; let X := fresh "X" in destruct H as [H X]). apply later_value in H.
    apply later_value in X4.
    apply Z.ltb_lt in X3, X2, X1, X0. apply Z.leb_le in X.
    destruct (weighed (numbered (placed_points t (length_at t MB) MA A)) _) as [[i x]|] eqn:EA; [|discriminate].
    destruct (weighed (numbered (placed_points t (length_at t MA) MB B)) _) as [[j y]|] eqn:EB; [|discriminate].
    bsplit. subst i j. apply weighed_sound in EA; auto. apply weighed_sound in EB; auto.
    destruct (moment_points MA (length_at t MB) X3) as [PA QA].
    destruct (moment_points MB (length_at t MA) X2) as [PB QB].
    rewrite QA in EA. rewrite QB in EB.
    apply hull_image in EA; [|intros; rewrite placed_mean; pteq; ring].
    apply hull_image in EB; [|intros; rewrite placed_mean; pteq; ring].
    destruct EA as (a & Ha & Ea). destruct EB as (b & Hb & Eb).
    apply IZR_lt in X3, X2, X1, X0. set (U := IZR (unit_of w)) in *. set (wa := IZR (length_at t MA)) in *.
    set (wb := IZR (length_at t MB)) in *.
    set (oA := pose_at (unit_motion m k MA) (value t)) in *. set (oB := pose_at (unit_motion m k MB) (value t)) in *.
    split.
    - split; [|auto]. split; [destruct H as [H _]|destruct X4 as [X4 _]]; unfold value in *;
      cbn [num den zero_ratio one_ratio] in *; lra.
    - exists a, b. split; auto. split; auto. fold oA oB. set (K := IZR m * (IZR (den t) * (wa * wb))).
      assert (PK : 0 < K) by (unfold K; repeat apply Rmult_lt_0_compat; auto).
      assert (Ed : inj (zsub x y) = scal (U * K) (sub (placed oA a) (placed oB b))).
      { rewrite inj_sub. replace (inj x) with (scal U (scal (/ U) (inj x))) by (rewrite scal_scal;
        replace (U * / U) with 1 by (field; lra); apply scal_1).
        replace (inj y) with (scal U (scal (/ U) (inj y))) by (rewrite scal_scal; replace (U * / U) with 1 by (field;
          lra); apply scal_1).
        rewrite <- Ea, <- Eb. unfold K. pteq; ring. }
      match goal with Q : (zdot _ _ * _ <= _)%Z |- _ => apply IZR_le in Q; rewrite !mult_IZR, norm2_inj, Ed,
        norm2_scal in Q; fold U wa wb in Q; rename Q into Q0 end.
      set (z := norm2 (sub (placed oA a) (placed oB b))) in *. unfold value.
      assert (PUK : 0 < U * K) by (apply Rmult_lt_0_compat; auto). set (c := IZR (den d)) in *.
      set (g := IZR (num d)) in *.
      assert (Pc : 0 < c) by auto. apply Rmult_le_reg_r with (U * K * (U * K) * (c * c));
        [repeat apply Rmult_lt_0_compat; auto|].
      replace (g / c * (g / c) * (U * K * (U * K) * (c * c))) with (g * (U * K) * (g * (U * K))) by (field; lra).
      unfold K in Q0 |- *. lra.
  Qed.
End Moment.

(* ---- the claim ---- *)
Section Walk.
  Variables (m k : Z) (A B : list zvec) (MA MB : motion zvec Z).
  Hypothesis Hm : 0 < IZR m.
  Hypothesis Hk : 0 < IZR k.
  Hypothesis HA : exists a, In a A.
  Hypothesis HB : exists b, In b B.
  Let M := unit_motion m k MA.
  Let N := unit_motion m k MB.
  Let RA := map (frac m) A.
  Let RB := map (frac m) B.
  Definition lengths_positive (t : R) : Prop := 0 < length2 (pose_at M t) /\ 0 < length2 (pose_at N t).
  Definition apart_at (t : R) : Prop := lengths_positive t /\ ~ as_near RA RB M N t 0.
  Definition near_fact (x : ratio * ratio * ratio) : Prop :=
    have_place M N (value (snd (fst x))) /\ as_near RA RB M N (value (snd (fst x))) (value (snd x)).

  Lemma piece_apart : forall s e f, later s e = true -> apart_on A B MA MB s e f = true ->
    forall t, value s <= t <= value e -> apart_at t.
  Proof.
    intros s e f L H t Ht. apply later_value in L. destruct L as (_ & Ps & Pe).
    destruct (time_mean _ _ _ Ht) as (v & u & Pv & Pu & S & E).
    destruct (apart_on_sound s e t v u Ps Pe E S m k A B MA MB Hm Hk Pv Pu f H HA HB) as (W1 & W2 & F).
    split; [split; auto|]. intros (a & b & Ha & Hb & Q). specialize (F a b Ha Hb). unfold M, N in Q. lra.
  Qed.

  Lemma walk_sound : forall ps s free found e found', walk m A B MA MB s free ps found = Some (e, found') ->
    (free = true -> apart_at (value s)) -> (forall x, In x found -> near_fact x) ->
    (forall x, In x found -> In x found') /\ (forall x, In x found' -> near_fact x) /\
    forall t, value s <= t <= value e -> apart_at t \/ exists i j d, In (i, j, d) found' /\ value i < t < value j.
  Proof.
    induction ps as [|[e1 f|e1 d w] ps IH]; intros s free found e found' H Hs Hf; cbn [walk] in H.
    - destruct free; [|discriminate]. inversion H; subst. split; auto. split; auto. intros t Ht. left.
      replace t with (value e) by lra. auto.
    - destruct (later s e1 && apart_on A B MA MB s e1 f)%bool eqn:E; [|discriminate]. apply andb_true_iff in E.
      destruct E as [L P].
      assert (C := piece_apart s e1 f L P). assert (Le := proj1 (later_value _ _ L)).
      destruct (IH _ _ _ _ _ H) as (I1 & I2 & I3); auto; [intros _; apply C; lra|]. split; auto. split; auto.
      intros t Ht. destruct (Rle_dec t (value e1)) as [T|T]; [left; apply C; lra|apply I3; lra].
    - destruct (free && later s e1 && near_at m A B MA MB e1 d w)%bool eqn:E; [|discriminate].
      apply andb_true_iff in E. destruct E as [E P].
      apply andb_true_iff in E. destruct E as [F L]. destruct (later_value _ _ L) as (Le & _ & Pe).
      destruct (IH _ _ _ _ _ H) as (I1 & I2 & I3); [discriminate| |].
      + intros x [<-|Ix]; auto. unfold near_fact. cbn [fst snd]. apply (near_at_sound e1 m k Pe Hm Hk A B MA MB d w P).
      + split; [intros x Ix; apply I1; right; exact Ix|]. split; auto. intros t Ht.
        destruct (Rle_dec (value e1) t) as [T|T]; [apply I3; lra|].
        destruct (Req_dec t (value s)) as [->|T']; [left; auto|].
        right. exists s, e1, d. split; [apply I1; left; reflexivity|lra].
  Qed.
End Walk.

Lemma unit_integral_pose : forall m k o,
  (0 < m)%Z -> (0 < k)%Z -> fits_pose m k o = true -> unit_pose m k (integral_pose m k o) = real_pose o.
Proof.
  intros m k [p r x] Hm Hk H. unfold fits_pose in H. cbn [spot scalar axis] in H. apply andb_true_iff in H.
  destruct H as [H F3].
  apply andb_true_iff in H. destruct H as [F1 F2]. unfold unit_pose, integral_pose, real_pose. cbn [spot scalar axis].
  assert (G : forall n q, (0 < n)%Z -> fits n q = true -> frac n (integral n q) = real q).
  { intros n q Hn F. assert (F' : forallb (fits n) [q] = true) by (cbn; rewrite F; auto).
    exact (f_equal (hd origin) (integral_real n [q] Hn F')). }
  rewrite !G, (units_value k r) by auto. reflexivity.
Qed.
Lemma unit_integral_motion : forall m k M, (0 < m)%Z -> (0 < k)%Z -> fits_motion m k M = true ->
  unit_motion m k (integral_motion m k M) = real_motion M.
Proof.
  intros m k [o e] Hm Hk H. unfold fits_motion in H. cbn [at_start at_end] in H. apply andb_true_iff in H.
  destruct H as [Fo Fe].
  unfold unit_motion, integral_motion, real_motion. cbn [at_start at_end]. rewrite !unit_integral_pose by auto.
  reflexivity.
Qed.

Lemma one_value : forall e, later one_ratio e = true -> later e one_ratio = true -> value e = 1.
Proof. intros e H1 H2. apply later_value in H1, H2. unfold value in *. cbn [one_ratio num den] in *. lra. Qed.

Theorem impact_verdict_sound : forall m k A B M N c s, impact_verdict m k A B M N c = Some s ->
  says_impact (map real A) (map real B) (real_motion M) (real_motion N) s.
Proof.
  intros m k A B M N c s H. unfold impact_verdict in H. cbv zeta in H.
  destruct (_ && _)%bool eqn:G in H; [|discriminate].
  repeat (apply andb_true_iff in G; let X := fresh "F" in destruct G as [G X]).
  apply Z.ltb_lt in G, F3. set (A' := each (integral m) A) in *. set (B' := each (integral m) B) in *.
  set (MA := integral_motion m k M) in *. set (MB := integral_motion m k N) in *.
  assert (EA : map (frac m) A' = map real A) by (apply integral_real; auto).
  assert (EB : map (frac m) B' = map real B) by (apply integral_real; auto).
  assert (EM : unit_motion m k MA = real_motion M) by (apply unit_integral_motion; auto).
  assert (EN : unit_motion m k MB = real_motion N) by (apply unit_integral_motion; auto).
  rewrite <- EA, <- EB, <- EM, <- EN. assert (Pm := IZR_lt _ _ G). assert (Pk := IZR_lt _ _ F3).
  assert (NM : forall t d w, near_at m A' B' MA MB t d w = true -> have_place (unit_motion m k MA) (unit_motion m k
    MB) (value t)
    /\ as_near (map (frac m) A') (map (frac m) B') (unit_motion m k MA) (unit_motion m k MB) (value t) (value d)).
  { intros t d w E. apply near_at_sound with w; auto. unfold near_at in E. cbv zeta in E.
    do 7 (apply andb_true_iff in E; destruct E as [E _]). apply later_value in E. apply E. }
  assert (Z0 : forall z, value zero_ratio = z -> z = 0) by (intros z <-; unfold value; cbn; lra).
  specialize (Z0 _ eq_refl).
  assert (WS : forall ps e found, walk m A' B' MA MB zero_ratio false ps [] = Some (e, found) -> value e <= 1 ->
    (exists a, In a A') /\ (exists b, In b B') ->
    (forall t, 0 <= t <= value e -> have_place (unit_motion m k MA) (unit_motion m k MB) t /\
      ~ as_near (map (frac m) A') (map (frac m) B') (unit_motion m k MA) (unit_motion m k MB) t 0
      \/ exists i j d, In (i, j, d) (rev_append found []) /\ value i < t < value j)
    /\ forall i j d, In (i, j, d) (rev_append found []) -> have_place (unit_motion m k MA) (unit_motion m k MB) (value
      j)
      /\ as_near (map (frac m) A') (map (frac m) B') (unit_motion m k MA) (unit_motion m k MB) (value j) (value d)).
  { intros ps e found W L1 [HA HB]. assert (Rv : forall x, In x (rev_append found []) <-> In x found).
    { intros x. rewrite rev_append_rev, app_nil_r. symmetry. apply in_rev. }
    destruct (walk_sound m k A' B' MA MB Pm Pk HA HB _ _ _ _ _ _ W) as (_ & I2 & I3); [discriminate|intros x []|].
    split.
    - intros t Ht. destruct (I3 t) as [[C1 C2]|(i & j & d & I & T)]; [lra| |].
      + left. split; auto. split; auto. lra.
      + right. exists i, j, d. rewrite Rv. auto.
    - intros i j d I. apply Rv in I. apply (I2 _ I). }
  assert (NE : forall ps e found, walk m A' B' MA MB zero_ratio false ps [] = Some (e, found) -> (exists a,
    In a A') /\ (exists b, In b B')).
  { intros [|[e1 f|e1 d w] ps] e found W; cbn [walk] in W; try discriminate.
    destruct (later zero_ratio e1 && _)%bool eqn:E; [|discriminate]. apply andb_true_iff in E. destruct E as [_ E].
    unfold apart_on in E.
    destruct (conditions _ _ _ _ _) as [[D U] V] eqn:EC. destruct D as [|d0 D].
    - exfalso. unfold conditions in EC. cbv zeta in EC.
      destruct f; cbv iota beta in EC; apply pair_equal_spec in EC; destruct EC as [EC _];
        apply pair_equal_spec in EC; destruct EC as [EC _]; discriminate EC.
    - cbn [all_positive] in E. destruct (coefficients U) as [|p us]; [discriminate|].
      destruct (coefficients V) as [|q vs]; [discriminate|].
      unfold positive_at in E. destruct A' as [|a A'']; [discriminate|].
      destruct B' as [|b B'']; [destruct (greatest (zneg p) (a :: A'')); discriminate|].
      split; [exists a|exists b]; simpl; auto. }
  destruct c as [ps|[|p ps] t w].
  - destruct (walk _ _ _ _ _ _ _ ps []) as [[e found]|] eqn:W; [|discriminate].
    destruct (later one_ratio e && later e one_ratio)%bool eqn:E; [|discriminate]. apply andb_true_iff in E.
    destruct E as [E1 E2].
    inversion H; subst s. assert (V := one_value e E1 E2). destruct (WS ps e found W) as [C1 C2]; [lra|eauto|].
    split; [|split]; cbn [until meet_at near_in]; [intros e' E; inversion E; subst e'; exact C1|discriminate|exact C2].
  - destruct (_ && _)%bool eqn:E in H; [|discriminate]. apply andb_true_iff in E. destruct E as [_ E].
    inversion H; subst s.
    apply NM in E. rewrite Z0 in E. split; [|split]; cbn [until meet_at near_in]; [discriminate| |intros i j d []].
    intros t' E'. inversion E'; subst t'. exact E.
  - destruct (walk _ _ _ _ _ _ _ (p :: ps) []) as [[e found]|] eqn:W; [|discriminate].
    destruct (_ && _)%bool eqn:E in H; [|discriminate]. apply andb_true_iff in E. destruct E as [E N1].
    apply andb_true_iff in E.
    destruct E as [E1 E2]. inversion H; subst s. apply NM in N1. rewrite Z0 in N1.
    assert (L1 : value e <= 1).
    { apply later_value in E2. unfold strictly_later in E1. apply andb_true_iff in E1. destruct E1 as [E1 E3].
      apply andb_true_iff in E1.
      destruct E1 as [E0 E1]. assert (L : later e t = true) by (unfold later; rewrite E0, E1; simpl; apply Z.leb_le;
        apply Z.ltb_lt in E3; lia).
      apply later_value in L. unfold value at 2 in E2. cbn [one_ratio num den] in E2. lra. }
    destruct (WS (p :: ps) e found W L1) as [C1 C2]; [eauto|].
    split; [|split]; cbn [until meet_at near_in]; [intros e' E; inversion E; subst e'; exact C1| |exact C2].
    intros t' E'. inversion E'; subst t'. exact N1.
Qed.
