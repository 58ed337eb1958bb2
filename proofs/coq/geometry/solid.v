(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A list that spans space has a hull with interior points: the centre of a tetrahedron. *)
Require Import Reals Lra Psatz List.
From Fathom.geometry Require Import meaning space hulls flats.
Import ListNotations.
Open Scope R_scope.

Lemma hull4 : forall S a b c d x wa wb wc wd w,
  hull S a -> hull S b -> hull S c -> hull S d ->
  0 <= wa -> 0 <= wb -> 0 <= wc -> 0 <= wd -> 0 < w -> wa + wb + wc + wd = w ->
  w * px x = wa * px a + wb * px b + wc * px c + wd * px d ->
  w * py x = wa * py a + wb * py b + wc * py c + wd * py d ->
  w * pz x = wa * pz a + wb * pz b + wc * pz c + wd * pz d ->
  hull S x.
Proof.
  intros S a b c d x wa wb wc wd w Ha Hb Hc Hd A0 B0 C0 D0 W E X Y Z.
  destruct (Req_dec (wa + wb) 0) as [H0|H0].
  - assert (wa = 0) by lra. assert (wb = 0) by lra. subst wa wb.
    apply (hull_seg S c d x wc wd); auto; try lra.
    + replace (wc + wd) with w by lra. lra.
    + replace (wc + wd) with w by lra. lra.
    + replace (wc + wd) with w by lra. lra.
  - set (y := mk ((wa * px a + wb * px b) / (wa + wb)) ((wa * py a + wb * py b) / (wa + wb))
                 ((wa * pz a + wb * pz b) / (wa + wb))).
    assert (Hy : hull S y).
    { apply (hull_seg S a b y wa wb); auto; try lra; simpl; field; lra. }
    apply (hull3 S y c d x (wa + wb) wc wd w); auto; try lra; simpl.
    + rewrite X. field; lra. + rewrite Y. field; lra. + rewrite Z. field; lra.
Qed.

Lemma tetrahedron_interior : forall L a b c d, In a L -> In b L -> In c L -> In d L ->
  0 < det (sub b a) (sub c a) (sub d a) -> exists g, interior (conv L) g.
Proof.
  intros L a b c d Ia Ib Ic Id HD.
  set (u := sub b a) in *. set (v := sub c a) in *. set (w := sub d a) in *.
  set (D := det u v w) in *.
  set (lb := cross v w). set (lc := cross w u). set (ld := cross u v).
  set (la := scal (-1) (add lb (add lc ld))).
  set (M := norm2 la + norm2 lb + norm2 lc + norm2 ld).
  assert (Na := norm2_nonneg la). assert (Nb := norm2_nonneg lb).
  assert (Nc := norm2_nonneg lc). assert (Nd := norm2_nonneg ld).
  assert (HM : 0 <= M) by (unfold M; lra).
  set (g := scal (1/4) (add (add a b) (add c d))).
  set (e := D / (4 * (1 + M))).
  assert (He : 0 < e) by (apply Rdiv_lt_0_compat; lra).
  assert (Ee : D = 4 * (e * (1 + M))) by (unfold e; field; lra).
  exists g, e. split; auto. intros s Hs. set (y := sub s g) in *.
  assert (small : forall l, norm2 l <= M -> - (D / 4) <= dot l y).
  { intros l Hl. assert (C := cauchy l y). assert (Nl := norm2_nonneg l). assert (Ny := norm2_nonneg y).
    destruct (Rle_dec (- (D / 4)) (dot l y)) as [K|K]; auto. exfalso.
    assert (K1 : e * (1 + M) < - dot l y) by lra.
    assert (K2 : (e * (1 + M)) * (e * (1 + M)) < dot l y * dot l y) by nra.
    assert (K3 : norm2 l * norm2 y <= M * (e * e)) by nra.
    assert (0 < e * e) by nra. nra. }
  apply (hull4 _ a b c d s (D / 4 + dot la y) (D / 4 + dot lb y) (D / 4 + dot lc y) (D / 4 + dot ld y) D);
    try (apply hull_in; auto); auto.
  - assert (norm2 la <= M) by (unfold M; lra). assert (G := small la). lra.
  - assert (norm2 lb <= M) by (unfold M; lra). assert (G := small lb). lra.
  - assert (norm2 lc <= M) by (unfold M; lra). assert (G := small lc). lra.
  - assert (norm2 ld <= M) by (unfold M; lra). assert (G := small ld). lra.
  - unfold la, dot; simpl. lra.
  - unfold y, la, lb, lc, ld, D, g, u, v, w, det, dot, cross; simpl. field.
  - unfold y, la, lb, lc, ld, D, g, u, v, w, det, dot, cross; simpl. field.
  - unfold y, la, lb, lc, ld, D, g, u, v, w, det, dot, cross; simpl. field.
Qed.

Theorem spanning_interior : forall L, spanning L -> exists g, interior (conv L) g.
Proof.
  intros L (a & b & c & d & Ia & Ib & Ic & Id & D).
  destruct (Rlt_dec 0 (det (sub b a) (sub c a) (sub d a))) as [S|S].
  - apply (tetrahedron_interior L a b c d); auto.
  - apply (tetrahedron_interior L a c b d); auto.
    replace (det (sub c a) (sub b a) (sub d a)) with (- det (sub b a) (sub c a) (sub d a))
      by (unfold det, dot, cross; simpl; ring). lra.
Qed.
