(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Format 3: a half-space that is done holds no way out but listed ones; an inner polytope splits space. *)
Require Import Reals Lra Psatz List ZArith Lia Bool.
From Fathom.checker Require Import vector sequence table polytope verdict unions.
From Fathom.geometry Require Import meaning space hulls difference depth norm.
From Fathom.soundness Require Import statement booleans lower.
Import ListNotations.
Open Scope R_scope.

Definition holds_at (h : constraint) (t : pt) : Prop := IZR (snd h) <= dot (inj (fst h)) t.

Section Cuts.
  Variables (As Bs : list (list zvec)) (qn qd unit : Z) (optima : list zvec) (at_ : constraint -> N).
  Hypothesis Hqd : (0 < qd)%Z.
  Hypothesis Hunit : (0 < unit)%Z.
  Let q := IZR qn / IZR qd.
  Let g := Target qn qd unit (numbered optima) at_.
  Let way (v : zvec) := scal (/ IZR unit) (inj v).

  (* a pair of pieces overlaps when A is moved by t *)
  Definition overlapping (t : pt) : Prop := exists A B, In A As /\ In B Bs /\ interior (P (map inj A) (map inj B)) t.
  (* of all other t that are not longer than the depth only these are to be left *)
  Definition settled (t : pt) : Prop := norm2 t = q /\ exists v, In v optima /\ t = way v.

  Lemma done_sound : forall h t, done g h = true -> norm2 t <= q -> holds_at h t -> settled t.
  Proof.
    intros [n c] t H Ht Hh. unfold done in H. cbn [fst snd g square_n square_d way_unit ways way_at] in H.
    apply andb_true_iff in H. destruct H as [Hc H]. apply Z.ltb_lt, IZR_lt in Hc. unfold holds_at in Hh. cbn [fst snd] in Hh.
    assert (Rd : 0 < IZR qd) by (apply IZR_lt; auto). assert (Ru : 0 < IZR unit) by (apply IZR_lt; auto).
    assert (C := cauchy (inj n) t). assert (N := norm2_nonneg (inj n)).
    assert (L : IZR c * IZR c <= norm2 (inj n) * norm2 t) by nra.
    assert (E : IZR qn = q * IZR qd) by (unfold q; field; lra).
    destruct (_ ?= _)%Z eqn:K; try discriminate.
    - apply Z.compare_eq in K. apply (f_equal IZR) in K. rewrite !mult_IZR, norm2_inj, E in K.
      assert (Ec : IZR c * IZR c = q * norm2 (inj n)) by (apply Rmult_eq_reg_r with (IZR qd); lra).
      assert (Pc : 0 < IZR c * IZR c) by (apply Rmult_lt_0_compat; auto).
      assert (Hn : inj n <> origin).
      { intros F. rewrite F, norm2_origin, Rmult_0_r in Ec. lra. }
      assert (Pn := norm2_pos _ Hn).
      assert (Nt : norm2 t = q). { apply Rle_antisym; auto. apply Rmult_le_reg_r with (norm2 (inj n)); lra. }
      destruct (foot_only (inj n) (IZR c) t q) as [_ F]; auto; [lra|]. split; auto.
      destruct (member _ _) as [v|] eqn:Ev in H; [|discriminate]. apply member_in in Ev. exists v. split; auto.
      apply same_vector_spec, (f_equal inj) in H. rewrite !inj_scal, norm2_inj, mult_IZR in H. unfold way.
      rewrite F. apply (f_equal (scal (/ norm2 (inj n) * / IZR unit))) in H. rewrite !scal_scal in H.
      replace (/ norm2 (inj n) * / IZR unit * norm2 (inj n)) with (/ IZR unit) in H by (field; lra). rewrite H.
      f_equal. field. lra.
    - exfalso. rewrite Z.compare_gt_iff in K. apply IZR_lt in K. rewrite !mult_IZR, norm2_inj, E in K.
      assert (q * norm2 (inj n) < IZR c * IZR c) by (apply Rmult_lt_reg_r with (IZR qd); lra). nra.
  Qed.

  Lemma not_done_spec : forall hs h, In h hs -> done g h = true \/ exists i, In (i, h) (numbered_not_done g hs).
  Proof.
    intros hs h. unfold numbered_not_done.
    set (f := fun (state : N * list (N * constraint)) (h : constraint) =>
      (N.succ (fst state), if done g h then snd state else (fst state, h) :: snd state)).
    assert (keep : forall hs s x, In x (snd s) -> In x (snd (fold_left f hs s))).
    { induction hs0 as [|k hs0 IH]; simpl; auto. intros s x Hx. apply IH. simpl. destruct (done g k); simpl; auto. }
    generalize (0%N, @nil (N * constraint)). induction hs as [|k hs IH]; simpl; intros s H; [tauto|].
    destruct H as [->|H]; [|apply IH; auto].
    destruct (done g h) eqn:E; auto. right. exists (fst s). apply keep. simpl. rewrite E. simpl. auto.
  Qed.

  (* ---- the inner polytopes ---- *)
  (* any other t is in a half-space that is done, or that a split must name *)
  Definition cuts_space (c : cut) : Prop :=
    forall t, overlapping t \/ exists h, holds_at h t /\ (done g h = true \/ exists i, In (i, h) (not_done c)).

  (* a hull of the points k v - s, moved back *)
  Lemma moved_hull : forall (S T : pt -> Prop) k s x, k <> 0 -> (forall p, S p -> T (scal (/ k) (add p s))) -> hull S x ->
    hull T (scal (/ k) (add x s)).
  Proof.
    intros S T k s x Hk H Hx. apply (Hx (fun x => hull T (scal (/ k) (add x s)))).
    - intros u v l Hl Hu Hv.
      replace (scal (/ k) (add (add (scal l u) (scal (1 - l) v)) s))
        with (add (scal l (scal (/ k) (add u s))) (scal (1 - l) (scal (/ k) (add v s)))) by (pteq; ring).
      apply hull_convex; auto.
    - intros p Hp. apply hull_in. auto.
  Qed.

  Lemma moved_interior : forall (S T : pt -> Prop) k s t, 0 < k -> (forall p, S p -> T (scal (/ k) (add p s))) ->
    interior (hull S) (sub (scal k t) s) -> interior (hull T) t.
  Proof.
    intros S T k s t Hk H (e & He & G). exists (e / k). assert (Pe : 0 < e / k) by (apply Rdiv_lt_0_compat; auto). split; auto.
    intros x Hx. replace x with (scal (/ k) (add (sub (scal k x) s) s)) by (pteq; field; lra).
    apply (moved_hull S); auto; [lra|]. apply G.
    replace (sub (sub (scal k x) s) (sub (scal k t) s)) with (scal k (sub x t)) by (pteq; ring). rewrite norm2_scal.
    replace (e * e) with (k * k * (e / k * (e / k))) by (field; lra). apply Rmult_lt_compat_l; auto. apply Rmult_lt_0_compat; auto.
  Qed.

  Lemma named_difference : forall A B lk, named (numbered A) (numbered B) lk = true ->
    diffs (map inj A) (map inj B) (inj (difference (numbered A) (numbered B) lk)).
  Proof.
    intros A B [l k] H. unfold named, difference in *. cbn [fst snd] in *.
    destruct (member (numbered B) l) as [b|] eqn:EB; [|discriminate]. destruct (member (numbered A) k) as [a|] eqn:EA; [|discriminate].
    apply member_in in EA, EB. exists (inj a), (inj b). rewrite inj_sub. split; [apply in_map; auto|split; [apply in_map; auto|auto]].
  Qed.

  Lemma table_of_tables : forall Ls i T, member (numbered (each numbered Ls)) i = Some T -> exists L : list zvec, In L Ls /\ T = numbered L.
  Proof.
    intros Ls i T H. apply member_in in H. rewrite each_map in H. apply in_map_iff in H. destruct H as (L & E & HL). exists L. auto.
  Qed.

  Lemma cut_of_sound : forall p c, cut_of g (numbered (each numbered As)) (numbered (each numbered Bs)) p = Some c -> cuts_space c.
  Proof.
    intros p c H t. unfold cut_of in H.
    destruct (member (numbered (each numbered As)) (piece_a p)) as [TA|] eqn:EA; [|discriminate].
    destruct (member (numbered (each numbered Bs)) (piece_b p)) as [TB|] eqn:EB; [|discriminate].
    apply table_of_tables in EA, EB. destruct EA as (A & IA & ->). destruct EB as (B & IB & ->).
    destruct (forallb _ (corner_points p)) eqn:EV; [|discriminate].
    set (vs := each (difference (numbered A) (numbered B)) (corner_points p)) in *. set (k := count vs) in *.
    set (s := fold_left zadd vs zzero) in *.
    set (TV := numbered (each (fun v => zsub (zscal k v) s) vs)) in *. set (Fs := each (make_facet TV) (sides p)) in *.
    destruct (_ && _)%bool eqn:E in H; [|discriminate]. apply andb_true_iff in E. destruct E as [Hk Hok]. apply Z.ltb_lt, IZR_lt in Hk.
    inversion H as [Ec]. clear H. cbn [not_done].
    set (S := fun x => diffs (map inj A) (map inj B) (scal (/ IZR k) (add x (inj s)))).
    assert (Hin : forall f x, In f Fs -> In x (corners f) -> fst x = zzero \/ S (inj (fst x))).
    { intros f x Hf Hx. unfold Fs in Hf. rewrite each_map in Hf. apply in_map_iff in Hf. destruct Hf as (l & <- & _).
      simpl in Hx. rewrite each_map in Hx. apply in_map_iff in Hx. destruct Hx as ([i o] & <- & _). cbn [fst].
      destruct (member TV i) as [x|] eqn:Ex; auto. right. apply member_in in Ex. rewrite each_map in Ex. apply in_map_iff in Ex.
      destruct Ex as (v & <- & Iv). unfold vs in Iv. rewrite each_map in Iv. apply in_map_iff in Iv. destruct Iv as (lk & <- & Il).
      unfold S. rewrite inj_sub, inj_scal.
      replace (scal (/ IZR k) (add (sub (scal (IZR k) (inj (difference (numbered A) (numbered B) lk))) (inj s)) (inj s)))
        with (inj (difference (numbered A) (numbered B) lk)) by (pteq; field; lra).
      apply named_difference. exact (forallb_In _ _ _ EV lk Il). }
    destruct (inside_or_beyond 0 1 S eq_refl Fs Hin Hok (sub (scal (IZR k) t) (inj s))) as [I|(f & If & Hf)].
    - left. exists A, B. split; auto. split; auto. apply (moved_interior S _ (IZR k) (inj s)); auto.
    - right. exists (half_space k s f). split.
      + unfold holds_at, half_space. cbn [fst snd]. rewrite dot_sub_r, dot_scal_r in Hf.
        rewrite plus_IZR, dot_inj, inj_scal, dot_scal_l. lra.
      + apply not_done_spec. rewrite each_map. apply in_map. auto.
  Qed.

  Lemma cuts_of_sound : forall ps found cuts, cuts_of g (numbered (each numbered As)) (numbered (each numbered Bs)) ps found = Some cuts ->
    (forall c, In c found -> cuts_space c) -> forall c, In c cuts -> cuts_space c.
  Proof.
    induction ps as [|p ps IH]; cbn [cuts_of]; intros found cuts H Hf c Hc.
    - inversion H. subst cuts. rewrite rev_append_rev, app_nil_r in Hc. apply in_rev in Hc. auto.
    - destruct (cut_of _ _ _ p) as [k|] eqn:E; [|discriminate]. apply (IH _ _ H); auto. intros d [<-|Hd]; auto. exact (cut_of_sound p k E).
  Qed.
End Cuts.
