(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The shortest ways out of a rounded set are those of the set, longer; if O is on its boundary, they are the vectors of length r in the
   polar cone. *)
Require Import Reals Lra Psatz List.
From Fathom.geometry Require Import meaning bodies space norm hulls signed_depth rounded.
Open Scope R_scope.

Lemma beneath_along : forall S n h v, n <> origin -> beneath S n h -> h <= v * norm n -> ~ interior S (along n v).
Proof.
  intros S n h v Hn H L. apply (halfspace_not_interior _ n h); auto. { apply norm2_pos; auto. }
  unfold along. rewrite dot_scal_r. fold (norm2 n). rewrite <- norm_sqr. assert (N := norm_pos n Hn).
  replace (v / norm n * (norm n * norm n)) with (v * norm n) by (field; lra). auto.
Qed.

Theorem ways_out_overlap : forall S s r t, 0 < s -> 0 <= r -> way_out (thick S r) (s + r) t -> way_out S s (scal (s / (s + r)) t).
Proof.
  intros S s r t Hs Hr [N NI]. assert (P0 : 0 < / (s + r)) by (apply Rinv_0_lt_compat; lra).
  assert (Nt : norm t = s + r) by (apply norm_unique; [lra|auto]).
  split.
  - rewrite norm2_scal, N. field. lra.
  - intros I. apply NI. replace t with (add (scal (s / (s + r)) t) (scal (r / (s + r)) t)) by (pteq; field; lra).
    apply interior_thick; auto. rewrite norm_scal, Nt by (apply Rmult_le_pos; lra). right. field. lra.
Qed.

(* of cores that touch: exactly the directions of the polar cone *)
Theorem ways_out_touch : forall S r t, 0 < r -> convex S -> S origin ->
  (way_out (thick S r) r t <-> norm2 t = r * r /\ polar S t).
Proof.
  intros S r t Hr HC HO. split; intros [N H]; split; auto.
  - intros p Hp. apply Rnot_lt_le. intros L. apply H.
    assert (Nt : norm t = r) by (apply norm_unique; [lra|auto]).
    (* a small step from O towards p brings t nearer *)
    assert (Np := norm2_nonneg p). set (d := dot t p) in *. set (l := d / (d + norm2 p)).
    assert (Hl : 0 < l) by (apply Rdiv_lt_0_compat; lra).
    assert (El : l * (d + norm2 p) = d) by (unfold l; field; lra).
    assert (Hl1 : l <= 1) by nra.
    assert (Hs : S (scal l p)).
    { replace (scal l p) with (add (scal l p) (scal (1 - l) origin)) by (pteq; ring). apply HC; auto. lra. }
    assert (C : norm (sub t (scal l p)) < r).
    { apply norm_lt; [lra|]. replace (norm2 (sub t (scal l p))) with (norm2 t - 2 * l * d + l * l * norm2 p)
        by (unfold d, norm2, dot; simpl; ring). rewrite N. nra. }
    exists (r - norm (sub t (scal l p))). split; [lra|]. intros s Hs'. apply norm_lt in Hs'; [|lra].
    apply thick_norm; [lra|]. exists (scal l p). split; auto.
    replace (sub s (scal l p)) with (add (sub s t) (sub t (scal l p))) by (pteq; ring).
    assert (T := norm_triangle (sub s t) (sub t (scal l p))). lra.
  - assert (Nt : norm t = r) by (apply norm_unique; [lra|auto]).
    apply (halfspace_not_interior _ t (0 + r * norm t)); [nra|apply beneath_thick; [lra|exact H]|].
    fold (norm2 t). rewrite N, Nt. lra.
Qed.
