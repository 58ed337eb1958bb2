(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Format 3: what the checker accepts is true, and so is the line that is printed. *)
Require Import Reals Lra List ZArith Lia Bool.
From Fathom.checker Require Import vector sequence certificate verdict signed unions union_verdict.
From Fathom.geometry Require Import meaning unions space scaling seams pieces.
From Fathom.soundness Require Import statement booleans verdict_sound union_statement union_claims.
Import ListNotations.
Open Scope R_scope.

Theorem union_check_sound : forall m As Bs c, union_check m As Bs c = true -> union_meaning m As Bs c.
Proof.
  intros m As Bs c H. unfold union_check in H. apply andb_true_iff in H. destruct H as [H Hc]. bsplit.
  rename H into Hm, H1 into SA, H0 into SB. apply all_solid_sound in SA, SB.
  assert (Rm : 0 < IZR m) by (apply IZR_lt; auto). assert (Ri : 0 < / IZR m) by (apply Rinv_0_lt_compat; auto).
  assert (E : forall Ls, map (map (frac m)) Ls = scaled_pieces (/ IZR m) (real_union Ls)).
  { intros Ls. rewrite map_map. apply map_ext. intros L. rewrite map_map. apply map_ext. intros v. pteq; unfold Rdiv; ring. }
  assert (U : forall n d, / IZR m * / IZR m * (IZR (n * (m * m)) / d) = IZR n / d).
  { intros n d. rewrite !mult_IZR. unfold Rdiv.
    transitivity ((/ IZR m * IZR m) * (/ IZR m * IZR m) * (IZR n * / d)); [ring|]. rewrite Rinv_l by lra. ring. }
  unfold union_meaning. cbv zeta. rewrite !E. split; [apply solid_scal; auto|]. split; [apply solid_scal; auto|].
  destruct c as [qn qd unit optima at_ polytopes tree multipliers|us p|qn qd us p]; cbn [union_holds]; cbv zeta.
  - apply deep_pieces_sound in Hc; auto. destruct Hc as (Hu & D & N & W). rewrite <- (U qn). set (q := _ / IZR qd) in *.
    assert (Ru : 0 < IZR unit) by (apply IZR_lt; auto).
    set (ts := map (fun o => scal (/ IZR unit) (inj (fst o))) optima) in *.
    assert (Et : map (fun o => frac (m * unit) (fst o)) optima = map (scal (/ IZR m)) ts).
    { unfold ts. rewrite map_map. apply map_ext. intros o. unfold frac. rewrite mult_IZR. pteq; field; lra. }
    rewrite Et. split; [apply union_depth_scal; auto|]. split.
    + apply FinFun.Injective_map_NoDup; auto. intros u v F. apply (f_equal (scal (IZR m))) in F. rewrite !scal_inv in F by lra. auto.
    + intros t. rewrite in_map_iff. rewrite <- (scal_inv' (IZR m) t) at 1 by lra. rewrite way_out_scal_iff, W by auto. split.
      * intros I. exists (scal (IZR m) t). rewrite scal_inv' by lra. auto.
      * intros (s & <- & I). rewrite scal_inv by lra. auto.
  - bsplit. apply unions_touch_scal; auto. apply (touching_pieces_sound As Bs SA SB us p); auto.
  - bsplit. rewrite <- (U qn). apply distance_scal; auto. apply (apart_pieces_sound As Bs _ _ us p); auto.
    apply Z.mul_pos_pos; auto. apply Z.mul_pos_pos; auto.
Qed.

(* the pieces as they stand in the file *)
Definition real_pieces (Ls : list (list point)) : list (list pt) := map (map real) Ls.

Lemma pieces_real : forall m Ls, (0 < m)%Z -> forallb (forallb (fits m)) Ls = true ->
  map (map (frac m)) (each (each (integral m)) Ls) = real_pieces Ls.
Proof.
  intros m Ls Hm H. rewrite each_map, map_map. apply map_ext_in. intros L HL. apply integral_real; auto.
  exact (forallb_In _ _ _ H L HL).
Qed.

Theorem union_verdict_sound : forall m As Bs c s, union_verdict m As Bs c = Some s -> says_union (real_pieces As) (real_pieces Bs) s.
Proof.
  intros m As Bs c s H. unfold union_verdict in H. destruct (_ && _ && union_check _ _ _ _)%bool eqn:E; [|discriminate].
  inversion H; subst. clear H. bsplit. rename H into FA, H1 into FB, H0 into C.
  assert (Hm : (0 < m)%Z) by (unfold union_check in C; bsplit; auto).
  apply union_check_sound in C. unfold union_meaning in C. cbv zeta in C. rewrite !pieces_real in C by auto. destruct C as (SA & SB & C).
  split; auto. split; auto. cbn [pieces_a pieces_b union_says].
  unfold real_pieces. split; [rewrite count_length, map_length; auto|]. split; [rewrite count_length, map_length; auto|].
  destruct c as [qn qd unit optima at_ polytopes tree multipliers|us p|qn qd us p];
    cbn [union_stated says_of union_holds] in *.
  - destruct C as (D & N & W). split; [apply D|]. split; [left; exact D|]. intros k E. inversion E. eexists.
    split; [|split; [exact N|]]; [rewrite count_length, map_length; auto|]. intros t. symmetry. apply W.
  - destruct C as [(x & Ha & Hb) N]. right; left. split; auto. split; auto. exists x, x. split; auto. split; auto.
      pteq; ring.
  - destruct C as (Hq & H & a & b & Ha & Hb & E). split; auto. right; right. rewrite Ropp_involutive. split;
      [unfold value; cbn [num den]; lra|]. split.
    + intros t (b' & a' & Hb' & Ha' & ->). apply H; auto.
    + exists (sub b a). split; [exact E|]. exists b, a. auto.
Qed.

(* in words about the pieces: whatever is shorter than the depth leaves two pieces that overlap, and of all moves of its length just the
   optima leave none *)
Corollary union_deep_pairs : forall m As Bs qn qd unit optima at_ polytopes tree multipliers,
  union_check m As Bs (Union_deep qn qd unit optima at_ polytopes tree multipliers) = true ->
  let overlap A B t := exists p, interior (translate (conv A) t) p /\ interior (conv B) p in
  let RA := map (map (frac m)) As in
  let RB := map (map (frac m)) Bs in
  let q := IZR qn / IZR qd in
  let ts := map (fun o => frac (m * unit) (fst o)) optima in
  (forall t, norm2 t < q -> exists A B, In A RA /\ In B RB /\ overlap A B t)
  /\ (forall t, In t ts -> norm2 t = q /\ forall A B, In A RA -> In B RB -> ~ overlap A B t)
  /\ (forall t, norm2 t = q -> (forall A B, In A RA -> In B RB -> ~ overlap A B t) -> In t ts)
  /\ NoDup ts.
Proof.
  intros m As Bs qn qd unit optima at_ polytopes tree multipliers H overlap RA RB q ts. apply union_check_sound in H.
  destruct H as (SA & SB & (_ & D & _) & N & W). fold RA RB in SA, SB, D, W. fold q in D, W. fold ts in N, W.
  split; [|split; [|split]]; auto.
  - intros t Ht. apply D, overlap_pieces in Ht; auto. destruct Ht as (A & B & p & IA & IB & I). exists A, B. split; auto. split; auto.
    exists p. auto.
  - intros t It. apply W in It. destruct It as [E O]. split; auto. intros A B IA IB (p & I). apply O, overlap_pieces; auto.
    exists A, B, p. tauto.
  - intros t E O. apply W. split; auto. intros I. apply overlap_pieces in I; auto. destruct I as (A & B & p & IA & IB & I).
    apply (O A B); auto. exists p. auto.
Qed.
