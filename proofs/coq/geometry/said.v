(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What printed.v says of depth, width and cones, in the words of the proofs. There is just one depth,
   and that of a body and itself is its width. *)
Require Import Reals Lra Psatz List ZArith FinFun.
From Fathom.geometry Require Import meaning bodies space norm hulls flats difference depth minkowski width signed_depth
  compact existence rounded curved gaps spans.
Import ListNotations.
Open Scope R_scope.

(* ---- the depth ---- *)
Theorem depth2_once : forall (U G : pt -> Prop) q r, (forall t, U t -> G t) -> depth2 U G q -> depth2 U G r -> q = r.
Proof.
  assert (K : forall (U G : pt -> Prop) q r, (forall t, U t -> G t) -> depth2 U G q -> depth2 U G r -> q <= r).
  { intros U G q r UG D E. apply Rnot_lt_le. intros L. assert (O := norm2_origin).
    destruct D as [(Hq & I & _)|[(-> & I & _)|(Hq & _ & u & T & J)]].
    - destruct E as [(Hr & _ & t & <- & N)|[(-> & _ & N)|(Hr & F & _)]].
      + apply N, I. lra.
      + apply N, I. lra.
      + assert (X := F origin (UG _ (I origin ltac:(lra)))). lra.
    - destruct E as [(Hr & _)|[(-> & _)|(Hr & F & _)]]; try lra. specialize (F origin I). lra.
    - destruct E as [(Hr & _)|[(-> & _)|(Hr & F & _)]]; try lra. specialize (F u J). lra. }
  intros U G q r UG D E. apply Rle_antisym; apply (K U G); auto.
Qed.

Lemma depth2_same : forall (U V G H : pt -> Prop) q, (forall t, U t <-> V t) -> (forall t, G t <-> H t) ->
  depth2 U G q -> depth2 V H q.
Proof.
  intros U V G H q E F [(Hq & I & t & T & N)|[(Hq & I & N)|(Hq & I & t & T & J)]].
  - left. split; auto. split; [intros s Hs; apply E; auto|]. exists t. rewrite <- E. auto.
  - right; left. rewrite <- E, <- F. auto.
  - right; right. split; auto. split; [intros s Hs; apply I, F, Hs|]. exists t. rewrite <- F. auto.
Qed.
Lemma exits_same : forall (U V : pt -> Prop) q k, (forall t, U t <-> V t) -> exits U q k -> exits V q k.
Proof.
  intros U V q k E (ts & L & N & H). exists ts. split; auto. split; auto. intros t. rewrite H, E. tauto.
Qed.

Theorem signed_depth_said : forall S v, signed_depth S v <-> signed_depth_is S v.
Proof.
  intros S v. unfold signed_depth_is. destruct (Rtotal_order v 0) as [V|[->|V]].
  - unfold depth2, signed_depth, at_least, at_most. assert (E : v * Rabs v = - (v * v)) by (rewrite Rabs_left by auto;
      ring). rewrite E. assert (P0 : 0 < v * v) by nra. split.
    + intros [[_ L] [_ M]]. right; right. destruct L as (p & Hp & N); [lra|]. split; [lra|]. rewrite Ropp_involutive.
      split; auto. exists p. split; auto. apply Rle_antisym; auto.
    + intros [(? & _)|[(? & _)|(_ & M & p & N & Hp)]]; try lra. rewrite Ropp_involutive in *.
      split; split; intros Hv; try lra; auto. exists p. split; auto. lra.
  - rewrite Rabs_R0, Rmult_0_r, signed_depth_touch. unfold touch, depth2.
    split; [intros [I N]; right; left; auto|]. intros [(? & _)|[(_ & T)|(? & _)]]; try lra; auto.
  - unfold depth2, signed_depth, at_least, at_most. assert (E : v * Rabs v = v * v) by (rewrite Rabs_right by lra;
      ring). rewrite E. assert (P0 : 0 < v * v) by nra. split.
    + intros [[L _] [M _]]. left. split; auto. split; auto. destruct M as (t & T & N); [lra|]. exists t. split; auto.
      apply Rle_antisym; auto. apply Rnot_lt_le. intros X. apply N, L; auto.
    + intros [(_ & L & t & T & N)|[(? & _)|(? & _)]]; try lra. split; split; intros Hv; try lra; auto. exists t. split;
        auto. lra.
Qed.

(* ---- polytopes ---- *)
Notation gap_set A B := (difference_of (conv B) (conv A)).

Lemma P_gaps : forall A B p, P A B p <-> gap_set A B p.
Proof.
  intros A B p. rewrite P_minkowski. unfold difference_of. split; intros (a & b & Ha & Hb & E); exists b, a; auto.
Qed.
Lemma interior_gaps : forall A B p, interior (P A B) p <-> interior (gap_set A B) p.
Proof. intros A B p. apply interior_iff, P_gaps. Qed.

Theorem depth_said : forall A B q, depth2_is A B q <-> 0 < q /\ depth2 (interior (gap_set A B)) (gap_set A B) q.
Proof.
  intros A B q. split.
  - intros D. split; [apply D|]. apply (depth2_same (interior (P A B)) _ (P A B)); [apply interior_gaps|apply P_gaps|].
      left. exact D.
  - intros [Hq D]. apply (depth2_same _ (interior (P A B)) _ (P A B)) in D.
    + destruct D as [D|[(? & _)|(? & _)]]; try lra. exact D.
    + intros t. symmetry. apply interior_gaps.
    + intros t. symmetry. apply P_gaps.
Qed.
Theorem touching_said : forall A B, touching A B <-> depth2 (interior (gap_set A B)) (gap_set A B) 0.
Proof.
  intros A B. unfold touching, depth2. rewrite P_gaps, interior_gaps. split; [intros [I N]; right; left; auto|].
  intros [(? & _)|[(_ & T)|(? & _)]]; try lra. exact T.
Qed.

Lemma attains_gaps : forall A B, A <> [] -> B <> [] -> attains (gap_set A B).
Proof.
  intros A B HA HB. apply attains_difference; [apply (attains_core (Points B))|apply (attains_core (Points A))]; auto.
Qed.
Lemma gaps_convex : forall A B, convex (gap_set A B).
Proof. intros A B. apply difference_of_convex; apply hull_convex. Qed.

Theorem depth2_exists : forall A B, A <> [] -> B <> [] -> exists q, depth2 (interior (gap_set A B)) (gap_set A B) q.
Proof.
  intros A B HA HB. destruct (signed_depth_planed _ (gaps_convex A B) (attains_gaps A B HA HB)) as (v & V & _).
  exists (v * Rabs v). apply signed_depth_said. exact V.
Qed.

(* as many facets are at the distance of the depth as there are shortest ways out *)
Lemma foot_along : forall A B q n t, depth2_is A B q -> n <> origin -> foot A B n t -> norm2 t = q ->
  t = along n (root q).
Proof.
  intros A B q n t D Hn (h & Hh & ->) N. assert (P0 := height_positive A B n h (depth_interior _ _ _ D) Hn Hh).
  assert (Pn := norm_pos n Hn). rewrite foot_norm2 in N by auto. unfold along. f_equal.
  rewrite (root_unique q (h / norm n)).
  - rewrite <- norm_sqr. field. lra.
  - apply Rlt_le, Rdiv_lt_0_compat; auto.
  - rewrite <- N, <- norm_sqr. field. lra.
Qed.

Theorem facets_exits : forall A B q k, depth2_is A B q ->
  (facets_number A B q k <-> exits (interior (gap_set A B)) q k).
Proof.
  intros A B q k D. assert (Hq := proj1 D).
  assert (near : forall t, norm2 t = q -> (~ interior (gap_set A B) t <-> exists n, facet_direction A B n
    /\ foot A B n t)).
  { intros t Ht. rewrite <- interior_gaps. apply (nearest_points A B q); auto. }
  split.
  - intros (ns & L & N & F & All & One). exists (map (fun n => along n (root q)) ns). split; [rewrite map_length;
      auto|]. split.
    + clear - N One Hq F. assert (inj' : forall n m, In n ns -> In m ns -> along n (root q) = along m (root q) -> n =
        m).
      { intros n m In0 Im E. apply One; auto. destruct (F n In0) as [[Hn _] _]. destruct (F m Im) as [[Hm _] _].
        assert (Pr := root_positive q Hq). assert (Pn := norm_pos n Hn). assert (Pm := norm_pos m Hm).
        exists (norm m / norm n). split; [apply Rdiv_lt_0_compat; auto|]. unfold along in E.
        transitivity (scal (norm m / root q) (scal (root q / norm m) m)).
        - rewrite scal_scal. replace (norm m / root q * (root q / norm m)) with 1 by (field; lra). symmetry.
            apply scal_1.
        - rewrite <- E, scal_scal. f_equal. field. lra. }
      clear - N inj'. induction N as [|n ns H N IH]; [constructor|]. simpl. constructor.
      * intros I. apply in_map_iff in I. destruct I as (m & E & Im). apply H. rewrite (inj' n m); simpl; auto.
      * apply IH. intros; apply inj'; simpl; auto.
    + intros t. rewrite in_map_iff. split.
      * intros (n & <- & In0). destruct (F n In0) as [Fn (t & Ft & Nt)]. rewrite <- (foot_along A B q n t); auto;
          [|apply Fn].
        split; auto. apply near; auto. exists n. auto.
      * intros [Nt X]. apply near in X; auto. destruct X as (n & Fn & Ft). destruct (All n) as (m & Im & (c & Pc & ->)).
        { split; auto. exists t. auto. }
        exists (scal c n). split; auto. rewrite (foot_along A B q n t); auto; [|apply Fn].
        assert (Hn := proj1 Fn). assert (Pn := norm_pos n Hn). unfold along. rewrite norm_scal, scal_scal by lra.
          f_equal. field. lra.
  - intros (ts & L & N & H). exists ts. split; auto. split; auto.
    assert (facet : forall t, In t ts -> facet_at A B q t /\ foot A B t t).
    { intros t It. apply H in It. destruct It as [Nt X]. apply near in X; auto. destruct X as (n & Fn & Ft).
        assert (Hn := proj1 Fn).
      assert (Et := foot_along A B q n t D Hn Ft Nt). assert (Pn := norm_pos n Hn). assert (Pr := root_positive q Hq).
      assert (Pk : 0 < root q / norm n) by (apply Rdiv_lt_0_compat; auto). unfold along in Et.
      assert (Ff : foot A B t t).
      { destruct Ft as (h & (H1 & p & Hp & Ep) & E0). exists (root q / norm n * h). rewrite Et. split.
        - split; [intros s Hs; rewrite dot_scal_l; apply Rmult_le_compat_l; [lra|auto]|]. exists p.
            rewrite dot_scal_l, Ep. auto.
        - rewrite <- Et at 1. rewrite E0 at 1. assert (Z := norm2_pos n Hn). rewrite norm2_scal, scal_scal. f_equal.
            field. lra. }
      split; auto. split; [rewrite Et; apply facet_direction_multiple; auto|]. exists t. auto. }
    split; [intros t It; apply facet; auto|]. split.
    + intros n (Fn & t & Ft & Nt). assert (Hn := proj1 Fn). exists t. split; [apply H; split; auto; apply near; eauto|].
      rewrite (foot_along A B q n t); auto. assert (Pr := root_positive q Hq). assert (Pn := norm_pos n Hn).
      exists (root q / norm n). split; auto. apply Rdiv_lt_0_compat; auto.
    + intros t u It Iu (c & Pc & ->). apply H in It, Iu. destruct It as [Nt _]. destruct Iu as [Nu _].
        rewrite norm2_scal, Nt in Nu.
      assert (c = 1); [|subst; symmetry; apply scal_1]. assert (Z : (c - 1) * ((c + 1) * q) = 0) by lra.
      apply Rmult_integral in Z. destruct Z as [Z|Z]; [lra|]. apply Rmult_integral in Z. lra.
Qed.

(* ---- the width ---- *)
Lemma width2_once : forall S v w, width2 S v -> width2 S w -> v = w.
Proof. intros S v w [(n & H) L] [(m & K) M]. apply Rle_antisym; eauto. Qed.

Theorem depth_width : forall S v, 0 <= v -> at_least (difference_of S S) v -> planed (difference_of S S) v ->
  width2 S (v * v).
Proof.
  intros S v Hv [L0 L1] (n & h & Hn & Hb & Hh). assert (Pn := norm_pos n Hn). split.
  - exists n. split; auto. intros a b Ha Hb'. rewrite <- norm_sqr.
    assert (X : dot n (sub b a) <= v * norm n) by (apply Rle_trans with h; auto; apply Hb; exists b, a; auto).
    assert (Y : dot n (sub a b) <= v * norm n) by (apply Rle_trans with h; auto; apply Hb; exists a, b; auto).
    rewrite dot_sub_r in *. nra.
  - intros m w [Hm Hs]. assert (Pm := norm2_pos m Hm). destruct (Req_dec v 0) as [->|Nv].
    + destruct L1 as (p & (a & b & Ha & Hb' & ->) & _); [lra|]. specialize (Hs a a Ha Ha).
      assert (Z : dot m (sub a a) = 0) by (unfold dot; simpl; ring). rewrite Z in Hs. nra.
    + apply Rnot_lt_le. intros L. set (k := root (Rmax 0 w)). assert (Pk : 0 <= k) by apply root_pos.
      assert (Ek : k * k = Rmax 0 w) by apply root_sqr, Rmax_l. assert (Mw := Rmax_r 0 w).
      assert (Lk : k < v) by (apply Rnot_le_lt; intros X; unfold Rmax in Ek; destruct (Rle_dec 0 w); nra).
      assert (Nm : 0 < norm m) by (apply norm_pos; auto).
      assert (I : difference_of S S (along m ((k + v) / 2))).
      { apply interior_in, L0; [lra|]. rewrite <- norm_sqr, norm_along by (auto; lra). nra. }
      destruct I as (a & b & Ha & Hb' & E). specialize (Hs b a Hb' Ha). rewrite <- E, dot_along in Hs by auto.
      rewrite <- norm_sqr in Hs, Pm.
      assert (X : (k + v) / 2 * ((k + v) / 2) * (norm m * norm m) <= w * (norm m * norm m)) by lra.
      apply Rmult_le_reg_r in X; auto. nra.
Qed.

(* of polytopes, and of bodies *)
Lemma signed_depth_root : forall S q, 0 <= q -> depth2 (interior S) S q -> signed_depth S (root q).
Proof.
  intros S q Hq D. apply signed_depth_said. unfold signed_depth_is. rewrite Rabs_right by (apply Rle_ge, root_pos).
    rewrite root_sqr; auto.
Qed.
Lemma depth2_some : forall (S : pt -> Prop) q, 0 <= q -> depth2 (interior S) S q -> S origin.
Proof.
  intros S q Hq [(P0 & I & _)|[(_ & I & _)|(N & _)]]; auto; [|lra]. apply interior_in, I. rewrite norm2_origin. auto.
Qed.

Theorem width_said : forall A, A <> [] -> says_width (conv A) /\ forall q, width2 (conv A) q ->
  depth2 (interior (gap_set A A)) (gap_set A A) q.
Proof.
  intros A HA. assert (K : says_width (conv A)).
  { intros q Hq G D. apply signed_depth_root in D; auto. rewrite <- (root_sqr q Hq).
    apply depth_width; [apply root_pos|apply D|]. apply depth_plane; auto; [apply gaps_convex|apply attains_gaps;
      auto]. }
  split; auto. intros q W. destruct (depth2_exists A A HA HA) as (r & D). assert (Hr : 0 <= r).
  { destruct D as [(? & _)|[(-> & _)|(N & F & _)]]; try lra. destruct A as [|a A]; [congruence|].
    assert (Z : norm2 (sub a a) = 0) by (unfold norm2, dot; simpl; ring).
    assert (- r <= norm2 (sub a a)); [|lra]. apply F. exists a, a. repeat split; apply hull_in; simpl; auto. }
  rewrite (width2_once _ _ _ W (K r Hr D)). exact D.
Qed.

Theorem body_width : forall A, (bounded_core (core_of A) \/ forall p, ~ in_core (core_of A) p) -> 0 <= radius A ->
  says_width (in_body A).
Proof.
  intros A HA Hr q Hq G D. destruct HA as [HA|HA].
  - apply signed_depth_root in D; auto. rewrite <- (root_sqr q Hq). apply depth_width; [apply root_pos|apply D|].
    assert (C : comparable (core_of A) (core_of A)) by (left; auto). destruct (core_gaps_planed A A C) as (w & W & n &
      h & Hn & Hb & Hh).
    rewrite (signed_depth_unique _ (root q) _ D (theorem_R A A w C Hr Hr W)).
    exists n, (h + (radius A + radius A) * norm n). split; auto. split; [|nra].
    intros p Hp. apply gaps_thick in Hp; auto. revert p Hp. apply beneath_thick; auto. lra.
  - exfalso. apply depth2_some in D; auto. destruct D as (a & _ & (p & Hp & _) & _). exact (HA p Hp).
Qed.

(* ---- cones ---- *)
Lemma sums_spanned : forall ls rs u, sums_of ls rs u <-> spanned ls rs u.
Proof.
  intros ls rs u. split.
  - induction 1 as [|k l u Il _ IH|k r u Pk Ir _ IH]; [apply spanned_origin| |apply spanned_add; auto;
      apply spanned_ray; auto].
    apply spanned_add; auto. destruct (combination_zero rs) as (cs & Lc & Ec & Nc).
    assert (One : exists ks, length ks = length ls /\ combination ks ls = scal k l).
    { clear - Il. induction ls as [|m ls IH]; [contradiction|]. destruct Il as [->|Il].
      - destruct (combination_zero ls) as (ks & L & E & _). exists (k :: ks). simpl. rewrite E, L. split; auto. pteq;
          ring.
      - destruct (IH Il) as (ks & L & E). exists (0 :: ks). simpl. rewrite E, L. split; auto. pteq; ring. }
    destruct One as (ks & Lk & Ek). exists ks, cs. split; auto. split; auto. split; auto. rewrite Ek, Ec. pteq; ring.
  - intros (ks & cs & Lk & Lc & N & ->).
    assert (G : forall v ws cs, (forall w, In w ws -> In w rs) -> length cs = length ws -> (forall c, In c cs ->
      0 <= c) ->
      sums_of ls rs v -> sums_of ls rs (add v (combination cs ws))).
    { intros v. induction ws as [|w ws IH]; intros [|c cs'] Hw L Hc Hv; try discriminate; simpl.
      - replace (add v origin) with v by (pteq; ring). auto.
      - replace (add v (add (scal c w) (combination cs' ws))) with (add (scal c w) (add v (combination cs' ws))) by
          (pteq; ring).
        apply ray_sum; [apply Hc; simpl; auto|apply Hw; simpl; auto|]. apply IH; auto; intros; [apply Hw|apply Hc];
          simpl; auto. }
    apply G; auto. clear - Lk.
    assert (G : forall ws ks, (forall w, In w ws -> In w ls) -> length ks = length ws ->
      sums_of ls rs (combination ks ws)).
    { induction ws as [|w ws IH]; intros [|c cs'] Hw L; try discriminate; simpl; [constructor|].
      apply line_sum; [apply Hw; simpl; auto|]. apply IH; auto. intros; apply Hw; simpl; auto. }
    apply G; auto.
Qed.

Theorem cone_said : forall K ls rs, generated K ls rs -> cone_is K (Z.of_nat (length ls)) (Z.of_nat (length rs)).
Proof.
  intros K ls rs (G & I & _ & N & S). exists ls, rs. split; auto. split; auto. split; [intros u; rewrite sums_spanned;
    auto|]. split.
  - intros xs l ys -> X. apply sums_spanned in X. destruct X as (ks & [|c cs] & Lk & Lc & _ & E); [|discriminate].
    rewrite app_length in Lk. set (a := firstn (length xs) ks). set (b := skipn (length xs) ks).
    assert (La : length a = length xs) by (unfold a; rewrite firstn_length; apply Nat.min_l; rewrite Lk;
      apply Nat.le_add_r).
    assert (Lb : length b = length ys) by (unfold b; rewrite skipn_length, Lk, Nat.add_comm; apply Nat.add_sub).
    assert (Z : -1 = 0); [|lra]. apply (I (a ++ -1 :: b)); [rewrite !app_length; simpl; rewrite La, Lb;
      auto| |apply in_app_iff; simpl; auto].
    rewrite combination_app by auto. simpl in E |- *. replace ks with (a ++ b) in E by apply firstn_skipn.
    rewrite combination_app in E by auto. rewrite E. pteq; ring.
  - intros xs q ys E. split; [rewrite sums_spanned; eauto|]. apply N. rewrite E. apply in_app_iff. simpl. auto.
Qed.
