(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A rate is the derivative also where points move and the other body is a half-space. *)
Require Import Reals Lra Psatz List.
From Fathom.checker Require Import body.
From Fathom.geometry Require Import meaning bodies space norm hulls flats difference signed_depth curved gaps.
From Fathom.geometry Require Import contact patches rates.
Import ListNotations.
Open Scope R_scope.

Section Plane.
  Variables (A : list pt) (ra rb d r c : R) (v w m : pt).
  Let X := Body (Points A) ra.
  Let Y := Body (Half_space m c) rb.
  Let n := along m 1.
  Hypothesis NA : A <> [].
  Hypothesis Nm : m <> origin.
  Hypothesis Opt : optimal (core_gaps X Y) d n.
  Hypothesis Slow : forall p, patch_of X Y d n p -> speed v w n p <= r.

  Lemma normal_dot : forall p, dot m p = norm m * dot n p.
  Proof. intros p. assert (P0 := norm_pos m Nm). unfold n, along. rewrite dot_scal_l. field. lra. Qed.
  Lemma normal_speed : forall s p, dot m (moved v w s p) = dot m p - s * (norm m * speed v w n p).
  Proof.
    intros s p. assert (E := normal_dot (add v (cross w p))).
    replace (dot m (moved v w s p)) with (dot m p + s * dot m (add v (cross w p))) by (unfold moved, dot; simpl; ring).
    rewrite E. unfold speed. ring.
  Qed.
  Lemma normal_way : dot m (scal d n) = d * norm m.
  Proof. unfold n, along. rewrite !dot_scal_r. fold (norm2 m). rewrite <- norm_sqr. assert (P0 := norm_pos m Nm).
  field. lra. Qed.

  Lemma plane_near : forall p, conv A p -> c - dot m p <= d * norm m.
  Proof.
    intros p Hp. assert (P0 := norm_pos m Nm). assert (N := norm2_pos m Nm). set (b := scal (c / norm2 m) m).
    assert (Eb : dot m b = c) by (unfold b; rewrite dot_scal_r; fold (norm2 m); field; lra).
    assert (K : dot n (sub b p) <= d). { apply Opt. exists b, p. split; [simpl; lra|]. split; [exact Hp|auto]. }
    rewrite dot_sub_r in K. rewrite <- Eb, !normal_dot. nra.
  Qed.

  Theorem rate_most_plane : forall e, 0 < e -> exists s0, 0 < s0 /\ forall s, 0 < s < s0 ->
    at_most (core_gaps (moved_body v w s A ra) Y) (d + s * (r + e)).
  Proof.
    intros e He. assert (P0 := norm_pos m Nm).
    destruct (all_or_some _ (fun _ => False)
      (fun a s0 => forall s, 0 < s < s0 -> c - dot m (moved v w s a) <= (d + s * (r + e)) * norm m) A) as [(a & _ &
        [])|(s0 & Ps & G)].
    - intros a s1 s2 L H s Hs. apply H. lra.
    - intros a Ia. right. assert (Ha : conv A a) by (apply hull_in; auto). assert (L := plane_near a Ha).
      destruct (Req_dec (c - dot m a) (d * norm m)) as [E|E].
      + exists 1. split; [lra|]. intros s Hs. rewrite normal_speed.
        assert (K : speed v w n a <= r). { apply Slow. split; [exact Ha|]. simpl. rewrite dot_add_r, normal_way. lra. }
        assert (s * (norm m * speed v w n a) <= s * (norm m * r)) by (apply Rmult_le_compat_l; [lra|apply
          Rmult_le_compat_l; lra]).
        assert (0 < s * e * norm m) by (repeat apply Rmult_lt_0_compat; lra). lra.
      + set (g := d * norm m - (c - dot m a)). assert (Pg : 0 < g) by (unfold g; lra).
        set (k := norm m * (Rabs (speed v w n a - r - e) + 1)). assert (Ab := Rabs_pos (speed v w n a - r - e)).
        assert (Pk : 0 < k) by (apply Rmult_lt_0_compat; lra). exists (g / k). split; [apply Rdiv_lt_0_compat; auto|].
        intros s [Hs Ls]. rewrite normal_speed. assert (Lk : s * k <= g).
        { replace g with (g / k * k) by (field; lra). apply Rmult_le_compat_r; lra. }
        assert (Ra := Rle_abs (speed v w n a - r - e)).
        assert (norm m * (speed v w n a - r - e) <= k) by (apply Rmult_le_compat_l; lra).
        assert (s * (norm m * (speed v w n a - r - e)) <= s * k) by (apply Rmult_le_compat_l; lra). unfold g in Lk. lra.
    - exists s0. split; auto. intros s Hs. apply (beneath_most _ m ((d + s * (r + e)) * norm m)); auto; [|lra].
      intros p (b & a & Hb & Ha & ->). simpl in Hb. rewrite dot_sub_r.
      assert (K : dot (scal (-1) m) a <= (d + s * (r + e)) * norm m - c).
      { revert a Ha. apply hull_halfspace. intros q Iq. apply in_map_iff in Iq. destruct Iq as (a & <- & Ia).
        specialize (G a Ia s Hs). rewrite dot_scal_l. lra. }
      rewrite dot_scal_l in K. lra.
  Qed.

  Theorem rate_least_plane : forall p s, patch_of X Y d n p -> r <= speed v w n p -> 0 < s ->
    at_least (core_gaps (moved_body v w s A ra) Y) (d + s * r).
  Proof.
    intros p s [Pa Pb] Hr Hs. assert (P0 := norm_pos m Nm). simpl in Pb. rewrite dot_add_r, normal_way in Pb.
    apply (half_space_least _ m (c - dot m (moved v w s p))); auto.
    - intros x Hx. apply (half_space_minus_point m c _ (moved v w s p)); auto. apply moved_conv. exact Pa.
    - rewrite normal_speed.
      assert (s * (norm m * r) <= s * (norm m * speed v w n p)) by (apply Rmult_le_compat_l; [lra|apply
        Rmult_le_compat_l; lra]). lra.
  Qed.
End Plane.

Theorem rate_plane : forall A m c ra rb d v w r, A <> [] -> m <> origin ->
  rate_is (Body (Points A) ra) (Body (Half_space m c) rb) d v w r ->
  grows (fun s => core_gaps (moved_body v w s A ra) (Body (Half_space m c) rb)) d r.
Proof.
  intros A m c ra rb d v w r NA Nm [Fast (n & O & Slow)] e He. cbv beta.
  assert (En : n = along m 1).
  { destruct A as [|a A']; [congruence|]. apply (optimal_half_space (core_gaps (Body (Points (a :: A')) ra) (Body
    (Half_space m c) rb)) m (c - dot m a) d); auto.
    intros x Hx. apply (half_space_minus_point m c _ a); auto. apply hull_in. simpl. auto. }
  subst n. destruct (Fast _ O) as (p & Hp & Hr).
  destruct (rate_most_plane A ra rb d r c v w m Nm O Slow e He) as (s0 & P0 & G).
  exists s0. split; auto. intros s x Hs [L M]. assert (U := least_le_most _ _ _ L (G s Hs)).
  assert (W := least_le_most _ _ _ (rate_least_plane A ra rb d r c v w m Nm p s Hp Hr (proj1 Hs)) M).
  assert (0 < s * e) by (apply Rmult_lt_0_compat; lra). lra.
Qed.
