(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Limits of real numbers, by what Coq's library proves of Cauchy sequences without an axiom.  Its least upper bounds, and so its roots,
   rest on sig_not_dec; nothing here does.  A search halves an interval for ever; each number >= 0 has a root;
     a Lipschitz function on an interval
   attains its least value. *)
Require Import Reals Lra Psatz.
From Coq Require Import QArith_base ConstructiveCauchyReals ConstructiveCauchyRealsMult ConstructiveCauchyAbs ConstructiveRcomplete.
Open Scope R_scope.

(* ---- small numbers ---- *)
(* 1/p *)
Definition part (p : positive) : R := Rabst (inject_Q (1 # p)).

Lemma part_repr : forall p, (Rrepr (part p) == inject_Q (1 # p))%CReal.
Proof. intros. apply Rquot2. Qed.
Lemma part_times : forall p, IZR (Zpos p) * part p = 1.
Proof.
  intros p. apply Rquot1. rewrite Rrepr_mult, Rrepr_IZR, part_repr, Rrepr_1. unfold inject_Z. rewrite <- inject_Q_mult.
  apply inject_Q_morph. unfold Qeq. simpl. lia.
Qed.
Lemma part_small : forall e, 0 < e -> exists p, part p < e.
Proof.
  intros e He. assert (A := archimed (/ e)). assert (Hi : 0 < / e) by (apply Rinv_0_lt_compat; auto).
  destruct (up (/ e)) as [|p|p]; destruct A as [A _]; try lra.
  - exists p. assert (E := part_times p). apply Rmult_lt_reg_l with (IZR (Zpos p)); [lra|]. rewrite E.
    apply Rmult_lt_reg_l with (/ e); auto. replace (/ e * (IZR (Z.pos p) * e)) with (IZR (Zpos p)) by (field; lra). lra.
  - assert (IZR (Zneg p) < 0) by (apply IZR_lt; lia). lra.
Qed.

Definition half_power (n : nat) : R := (/ 2) ^ n.

Lemma half_power_pos : forall n, 0 < half_power n.
Proof. intros. apply pow_lt. lra. Qed.
Lemma half_power_S : forall n, half_power (S n) = half_power n / 2.
Proof. intros. unfold half_power. simpl. lra. Qed.
Lemma half_power_decreases : forall n m, (n <= m)%nat -> half_power m <= half_power n.
Proof. intros n m H. induction H; [lra|]. rewrite half_power_S. assert (P := half_power_pos m). lra. Qed.
Lemma half_power_part : forall p, half_power (Pos.to_nat p) <= part p.
Proof.
  intros p. assert (E := part_times p). assert (H : forall n, INR n * half_power n <= 1).
  { induction n as [|n IH]; [simpl; lra|]. rewrite half_power_S, S_INR. assert (P := half_power_decreases 0 n (Nat.le_0_l n)).
    change (half_power 0) with 1 in P. lra. }
  specialize (H (Pos.to_nat p)). rewrite INR_IPR in H. change (IPR p) with (IZR (Zpos p)) in H.
  assert (0 < IZR (Zpos p)) by (apply IZR_lt; lia). apply Rmult_le_reg_l with (IZR (Zpos p)); lra.
Qed.
Lemma half_power_small : forall c e, 0 < e -> exists n, c * half_power n <= e.
Proof.
  intros c e He. destruct (Rle_dec c 0) as [C|C].
  - exists O. unfold half_power. simpl. lra.
  - destruct (part_small (e / c)) as (p & Hp). { apply Rdiv_lt_0_compat; lra. }
    exists (Pos.to_nat p). assert (H := half_power_part p). apply Rle_trans with (c * (e / c)); [apply Rmult_le_compat_l; lra|].
    right. field. lra.
Qed.

Lemma le_by_small : forall x y, (forall e, 0 < e -> x <= y + e) -> x <= y.
Proof. intros x y H. apply Rnot_lt_le. intros L. specialize (H ((x - y) / 2)). lra. Qed.
Lemma abs_bounds : forall x y, Rabs x <= y -> - y <= x <= y.
Proof.
  intros x y H. split; [|eapply Rle_trans; [apply Rle_abs|exact H]].
  rewrite <- Rabs_Ropp in H. assert (L := Rle_trans _ _ _ (Rle_abs _) H). lra.
Qed.

(* ---- fast Cauchy sequences converge ---- *)
Theorem limit : forall u : nat -> R, (forall n m, (n <= m)%nat -> Rabs (u m - u n) <= half_power n) ->
  { l | forall n, Rabs (u n - l) <= half_power n }.
Proof.
  intros u H. destruct (CRealComplete (fun n => Rrepr (u n))) as (l & Hl).
  - intros p. exists (Pos.to_nat p). intros i j Hi Hj.
    assert (G : forall i j, (Pos.to_nat p <= i)%nat -> (i <= j)%nat -> Rabs (u j - u i) <= part p).
    { clear i j Hi Hj. intros i j Hi Hj. apply Rle_trans with (half_power i); auto. apply Rle_trans with (half_power (Pos.to_nat p)).
      - apply half_power_decreases; auto.
      - apply half_power_part. }
    assert (G' : Rabs (u i - u j) <= part p) by (destruct (Nat.le_ge_cases i j) as [L|L]; [rewrite Rabs_minus_sym|]; apply G; auto).
    apply abs_bounds in G'. apply CReal_abs_le. rewrite <- part_repr.
    change (Rrepr (u i) + - Rrepr (u j))%CReal with (Rrepr (u i) - Rrepr (u j))%CReal.
    rewrite <- Rrepr_minus, <- Rrepr_opp. split; apply Rrepr_le; lra.
  - exists (Rabst l). intros n. apply le_by_small. intros e He. destruct (part_small e He) as (p & Hp).
    destruct (Hl p) as (k & Hk). set (i := Nat.max n k). specialize (Hk i (Nat.le_max_r _ _)).
    assert (Hn := H n i (Nat.le_max_l _ _)).
    apply CReal_abs_def2 in Hk. destruct Hk as [K1 K2]. rewrite <- part_repr in K1, K2. rewrite <- (Rquot2 l) in K1, K2.
    change (Rrepr (u i) + - Rrepr (Rabst l))%CReal with (Rrepr (u i) - Rrepr (Rabst l))%CReal in K1, K2.
    rewrite <- Rrepr_minus in K1, K2. rewrite <- Rrepr_opp in K2. apply Rrepr_le in K1, K2.
    replace (u n - Rabst l) with (- (u i - u n) + (u i - Rabst l)) by ring.
    eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. assert (Rabs (u i - Rabst l) <= part p) by (apply Rabs_le; lra). lra.
Qed.

(* ---- a search that halves an interval ---- *)
Section Halving.
  Variable Q : R -> R -> Prop.
  Hypothesis halve : forall a b, a <= b -> Q a b -> {Q a ((a + b) / 2)} + {Q ((a + b) / 2) b}.

  Record interval := { from : R; to : R; ordered : from <= to; good : Q from to }.
  Lemma step : forall i, { j | from i <= from j /\ to j <= to i /\ to j - from j = (to i - from i) / 2 }.
  Proof.
    intros [a b L G]. destruct (halve a b L G) as [H|H].
    - assert (L' : a <= (a + b) / 2) by lra. exists (Build_interval _ _ L' H). simpl. lra.
    - assert (L' : (a + b) / 2 <= b) by lra. exists (Build_interval _ _ L' H). simpl. lra.
  Qed.
  Fixpoint steps (i : interval) (n : nat) : interval := match n with O => i | S n => proj1_sig (step (steps i n)) end.

  Lemma steps_inside : forall i n m, (n <= m)%nat -> from (steps i n) <= from (steps i m) /\ to (steps i m) <= to (steps i n).
  Proof. intros i n m H. induction H; [lra|]. simpl. assert (F := proj2_sig (step (steps i m))). simpl in F. lra. Qed.
  Lemma steps_length : forall i n, to (steps i n) - from (steps i n) = (to i - from i) * half_power n.
  Proof.
    intros i n. induction n; [unfold half_power; simpl; lra|]. simpl. assert (F := proj2_sig (step (steps i n))). simpl in F.
    rewrite half_power_S. lra.
  Qed.

  Theorem nested : forall a b, a <= b -> Q a b ->
    { x | forall e, 0 < e -> exists c d, a <= c /\ c <= x <= d /\ d <= b /\ d - c <= e /\ Q c d }.
  Proof.
    intros a b L G. set (i := Build_interval a b L G). set (w := b - a).
    destruct (Rle_dec w 0) as [W|W].
    { exists a. intros e He. exists a, b. unfold w in W. repeat split; auto; lra. }
    assert (W0 : 0 < / w) by (apply Rinv_0_lt_compat; lra).
    assert (len : forall n, to (steps i n) - from (steps i n) = w * half_power n) by (intros; apply steps_length).
    destruct (limit (fun n => from (steps i n) * / w)) as (l & Hl).
    - intros n m H. assert (F := steps_inside i n m H). assert (F' := ordered (steps i m)). assert (E := len n).
      rewrite <- Rmult_minus_distr_r.
      rewrite Rabs_right by (apply Rle_ge, Rmult_le_pos; lra). apply Rmult_le_reg_r with w; [lra|].
      rewrite Rmult_assoc, Rinv_l by lra. lra.
    - exists (l * w).
      assert (near : forall n, - (w * half_power n) <= from (steps i n) - l * w <= w * half_power n).
      { intros n. replace (from (steps i n) - l * w) with (w * (from (steps i n) * / w - l)) by (field; lra).
        apply abs_bounds. rewrite Rabs_mult, (Rabs_right w) by lra. apply Rmult_le_compat_l; [lra|auto]. }
      assert (bound : forall n, from (steps i n) <= l * w <= to (steps i n)).
      { intros n. split; apply le_by_small; intros e He; [|assert (N := near n); assert (E := len n); lra].
        destruct (half_power_small w e He) as (k & Hk). set (m := Nat.max n k). assert (F := steps_inside i n m (Nat.le_max_l _ _)).
        assert (N := near m). assert (D := half_power_decreases k m (Nat.le_max_r _ _)).
        assert (w * half_power m <= w * half_power k) by (apply Rmult_le_compat_l; lra). lra. }
      intros e He. destruct (half_power_small w e He) as (n & Hn). exists (from (steps i n)), (to (steps i n)).
      assert (F := steps_inside i O n (Nat.le_0_l n)). simpl in F. rewrite len. repeat split; auto; try apply bound; try lra. apply good.
  Qed.
End Halving.

(* ---- roots ---- *)
Theorem root_exists : forall x, 0 <= x -> { y | 0 <= y /\ y * y = x }.
Proof.
  intros x Hx.
  destruct (nested (fun a b => a * a <= x <= b * b)) with (a := 0) (b := 1 + x) as (y & Hy); try nra.
  - intros a b _ H. destruct (Rle_dec ((a + b) / 2 * ((a + b) / 2)) x) as [L|L]; [right|left]; lra.
  - exists y. assert (Y : 0 <= y <= 1 + x) by (destruct (Hy 1) as (c & d & H); lra). split; [lra|].
    assert (near : forall e, 0 < e -> y * y - x <= e /\ x - y * y <= e).
    { intros e He. destruct (Hy (e / (2 * (1 + x)))) as (c & d & C & B & D & W & G). { apply Rdiv_lt_0_compat; lra. }
      assert (W' : (d - c) * (2 * (1 + x)) <= e).
      { apply (Rmult_le_compat_r (2 * (1 + x))) in W; [|lra]. replace (e / (2 * (1 + x)) * (2 * (1 + x))) with e in W by (field; lra).
        auto. }
      nra. }
    apply Rle_antisym; apply le_by_small; intros e He; destruct (near e He); lra.
Qed.

(* ---- a Lipschitz function on an interval attains its least value ---- *)
Section Least.
  Variables (f : R -> R) (c : R).
  Hypothesis Hc : 0 <= c.
  Hypothesis Hf : forall x y, f x - f y <= c * Rabs (x - y).

  (* the least value on a grid *)
  Fixpoint sampled (n : nat) (a b : R) : R :=
    match n with O => f a | S n => Rmin (sampled n a ((a + b) / 2)) (sampled n ((a + b) / 2) b) end.

  Lemma sampled_value : forall n a b, a <= b -> exists x, a <= x <= b /\ sampled n a b = f x.
  Proof.
    induction n as [|n IH]; intros a b L; [exists a; simpl; lra|]. simpl. unfold Rmin. destruct (Rle_dec _ _).
    - destruct (IH a ((a + b) / 2)) as (x & B & E); [lra|]. exists x. split; auto. lra.
    - destruct (IH ((a + b) / 2) b) as (x & B & E); [lra|]. exists x. split; auto. lra.
  Qed.
  Lemma sampled_below : forall n a b x, a <= x <= b -> sampled n a b <= f x + c * (b - a) * half_power n.
  Proof.
    induction n as [|n IH]; intros a b x B; simpl.
    - assert (H := Hf a x). rewrite Rabs_left1 in H by lra. unfold half_power. simpl. nra.
    - rewrite half_power_S. destruct (Rle_dec x ((a + b) / 2)) as [X|X].
      + specialize (IH a ((a + b) / 2) x). eapply Rle_trans; [apply Rmin_l|]. lra.
      + specialize (IH ((a + b) / 2) b x). eapply Rle_trans; [apply Rmin_r|]. lra.
  Qed.

  Lemma infimum : forall a b, a <= b -> { v | (forall x, a <= x <= b -> v <= f x) /\ forall e, 0 < e -> exists x, a <= x <= b /\
    f x <= v + e }.
  Proof.
    intros a b L. set (w := c * (b - a) + 1). assert (W : 0 < w) by (unfold w; nra).
    assert (Wi : 0 < / w) by (apply Rinv_0_lt_compat; auto).
    assert (below : forall n x, a <= x <= b -> sampled n a b <= f x + w * half_power n).
    { intros n x B. assert (H := sampled_below n a b x B). assert (P := half_power_pos n). unfold w. lra. }
    destruct (limit (fun n => sampled n a b * / w)) as (l & Hl).
    - intros n m H. apply half_power_decreases in H. rewrite <- Rmult_minus_distr_r, Rabs_mult, (Rabs_right (/ w)) by lra.
      apply Rmult_le_reg_r with w; auto. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
      destruct (sampled_value n a b L) as (x & Bx & Ex). destruct (sampled_value m a b L) as (y & By & Ey).
      assert (H1 := below n y By). assert (H2 := below m x Bx).
      assert (w * half_power m <= w * half_power n) by (apply Rmult_le_compat_l; lra).
      apply Rabs_le. lra.
    - assert (near : forall n, - (w * half_power n) <= sampled n a b - l * w <= w * half_power n).
      { intros n. replace (sampled n a b - l * w) with (w * (sampled n a b * / w - l)) by (field; lra).
        apply abs_bounds. rewrite Rabs_mult, (Rabs_right w) by lra. apply Rmult_le_compat_l; [lra|auto]. }
      exists (l * w). split.
      + intros x B. apply le_by_small. intros e He. destruct (half_power_small (2 * w) e He) as (n & Hn).
        assert (H := below n x B). assert (N := near n). lra.
      + intros e He. destruct (half_power_small w e He) as (n & Hn). destruct (sampled_value n a b L) as (x & B & E). exists x. split; auto.
        assert (N := near n). lra.
  Qed.

  Theorem least_attained : forall a b, a <= b -> { x | a <= x <= b /\ forall y, a <= y <= b -> f x <= f y }.
  Proof.
    intros a b L. destruct (infimum a b L) as (v & V & V').
    destruct (nested (fun p q => forall e, 0 < e -> exists x, p <= x <= q /\ f x <= v + e)) with (a := a) (b := b) as (x & Hx); auto.
    - intros p q O G. destruct (infimum p ((p + q) / 2)) as (s & S & S'); [lra|]. destruct (Rle_dec s v) as [C|C].
      + left. intros e He. destruct (S' e He) as (x & B & E). exists x. split; auto. lra.
      + right. intros e He. destruct (G (Rmin e ((s - v) / 2))) as (x & B & E); [apply Rmin_pos; lra|].
        assert (M1 := Rmin_l e ((s - v) / 2)). assert (M2 := Rmin_r e ((s - v) / 2)). exists x. split; [|lra].
        destruct (Rle_dec x ((p + q) / 2)) as [X|X]; [|lra]. specialize (S x). lra.
    - exists x. assert (B : a <= x <= b) by (destruct (Hx 1) as (p & q & H); lra). split; auto.
      intros y Hy. apply Rle_trans with v; auto. apply le_by_small. intros e He.
      destruct (Hx (e / (2 * (1 + c)))) as (p & q & P1 & B1 & P2 & W & G). { apply Rdiv_lt_0_compat; lra. }
      destruct (G (e / 2)) as (z & Bz & Ez); [lra|]. assert (F := Hf x z).
      assert (A : Rabs (x - z) <= q - p) by (apply Rabs_le; lra).
      assert (K : c * Rabs (x - z) <= c * (e / (2 * (1 + c)))) by (apply Rmult_le_compat_l; lra).
      assert (K' : c * (e / (2 * (1 + c))) <= e / 2).
      { apply Rmult_le_reg_r with (2 * (1 + c)); [lra|]. replace (c * (e / (2 * (1 + c))) * (2 * (1 + c))) with (c * e) by (field; lra).
        nra. }
      lra.
  Qed.
End Least.
