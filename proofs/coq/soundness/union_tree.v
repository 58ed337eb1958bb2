(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Format 3: going down the tree; what it leaves of the ball is among the optima. *)
Require Import Reals Lra List ZArith Lia Bool.
From Fathom.checker Require Import vector sequence table unions.
From Fathom.geometry Require Import meaning space norm.
From Fathom.soundness Require Import statement booleans union_cuts.
Import ListNotations.
Open Scope R_scope.

(* t is where the constraints of the path say *)
Definition inside_cell (c : cell) (t : pt) : Prop := forall k h, get k (held c) = Some h -> holds_at h t.

Lemma inside_space : forall t, inside_cell all_of_space t.
Proof. intros t k h H. destruct k; discriminate. Qed.

Lemma inside_part : forall c h t, inside_cell c t -> holds_at h t -> inside_cell (part c h) t.
Proof. intros c h t Hc Hh k h' H. apply get_put in H. destruct H as [->|H]; [auto|exact (Hc k h' H)]. Qed.

Lemma holds_opposite : forall h t, ~ holds_at h t -> holds_at (opposite h) t.
Proof.
  intros [n c] t H. unfold holds_at, opposite in *. cbn [fst snd] in *. rewrite opp_IZR.
  replace (inj (zneg n)) with (scal (-1) (inj n)) by (pteq; rewrite opp_IZR; ring). rewrite dot_scal_l. lra.
Qed.

Lemma members_in : forall hs is found l, members hs is found = Some l ->
  forall h, In h l -> In h found \/ exists k, get k hs = Some h.
Proof.
  induction is as [|i is IH]; cbn [members]; intros found l H h Hh.
  - inversion H. subst l. rewrite rev_append_rev, app_nil_r in Hh. apply in_rev in Hh. auto.
  - destruct (member hs i) as [h'|] eqn:E; [|discriminate]. destruct (IH _ _ H h Hh) as [[<-|K]|K]; auto. right. eexists. exact E.
Qed.

Lemma combined_holds : forall hs ls sum h t, combined hs ls sum = Some h -> (forall h', In h' hs -> holds_at h' t) -> holds_at sum t ->
  holds_at h t.
Proof.
  induction hs as [|k hs IH]; intros [|l ls] sum h t H Hhs Hsum; try discriminate; cbn [combined] in H; [inversion H; subst; auto|].
  destruct (0 <=? l)%Z eqn:E; [|discriminate]. apply Z.leb_le, IZR_le in E. apply (IH ls _ h t H); [intros h' Hh; apply Hhs; simpl; auto|].
  assert (K := Hhs k (or_introl eq_refl)). unfold holds_at in *. cbn [fst snd] in *.
  rewrite plus_IZR, mult_IZR, inj_add, inj_scal, dot_comm, dot_add_r, dot_scal_r, !(dot_comm t). nra.
Qed.

Section Tree.
  Variables (As Bs : list (list zvec)) (qn qd unit : Z) (optima : list zvec) (at_ : constraint -> N).
  Hypothesis Hqd : (0 < qd)%Z.
  Hypothesis Hunit : (0 < unit)%Z.
  Let q := IZR qn / IZR qd.
  Let g := Target qn qd unit (numbered optima) at_.

  Definition resolved (c : cell) : Prop :=
    forall t, norm2 t <= q -> inside_cell c t -> overlapping As Bs t \/ settled qn qd unit optima t.

  Lemma far_away_sound : forall multipliers c is, far_away g multipliers c is = true -> resolved c.
  Proof.
    intros multipliers c is H t Ht Hc. right. unfold far_away in H.
    destruct (members (held c) is []) as [hs|] eqn:E; [|discriminate].
    destruct (combined hs (multipliers hs) (zzero, 0%Z)) as [h|] eqn:F; [|discriminate].
    apply (done_sound qn qd unit optima at_ Hqd Hunit h); auto. apply (combined_holds _ _ _ _ t F).
    - intros h' Hh. destruct (members_in _ _ _ _ E h' Hh) as [[]|(k & K)]. exact (Hc k h' K).
    - unfold holds_at. cbn [fst snd]. unfold dot; simpl. lra.
  Qed.

  Lemma children_kept : forall hs fs c cells marks cells' marks', children_of hs c fs cells marks = Some (cells', marks') ->
    forall d, In d cells -> In d cells'.
  Proof.
    induction fs as [|f fs IH]; cbn [children_of]; intros c cells marks cells' marks' H d Hd; [inversion H; subst; auto|].
    destruct (member hs f) as [h|]; [|discriminate]. apply (IH _ _ _ _ _ H). simpl. auto.
  Qed.

  (* a point of the cell is in a child, or in none of the half-spaces that have one *)
  Lemma children_of_sound : forall hs fs c cells marks cells' marks' t, children_of hs c fs cells marks = Some (cells', marks') ->
    inside_cell c t -> (forall k h, get k marks = Some h -> ~ holds_at h t) ->
    (exists d, In d cells' /\ inside_cell d t) \/ forall k h, get k marks' = Some h -> ~ holds_at h t.
  Proof.
    induction fs as [|f fs IH]; cbn [children_of]; intros c cells marks cells' marks' t H Hc Hm; [inversion H; subst; auto|].
    destruct (member hs f) as [h|] eqn:E; [|discriminate]. destruct (Rle_dec (IZR (snd h)) (dot (inj (fst h)) t)) as [K|K].
    - left. exists (part c h). split; [apply (children_kept _ _ _ _ _ _ _ H); simpl; auto|apply inside_part; auto].
    - apply (IH _ _ _ _ _ t H).
      + apply inside_part; auto. apply holds_opposite. exact K.
      + intros k h' Hk. apply get_put in Hk. destruct Hk as [->|Hk]; [exact K|exact (Hm k h' Hk)].
  Qed.

  Section Walk.
    Variables (cuts : list cut) (multipliers : list constraint -> list Z).
    Hypothesis Hcuts : forall c, In c cuts -> cuts_space As Bs qn qd unit optima at_ c.

    Lemma step_sound : forall n cells cells', step g (numbered cuts) multipliers cells n = Some cells' ->
      (forall c, In c cells' -> resolved c) -> forall c, In c cells -> resolved c.
    Proof.
      intros n cells cells' H G c Hc. unfold step in H. destruct n as [s fs|is], cells as [|d cells]; try discriminate.
      - destruct (member (numbered cuts) s) as [k|] eqn:Ek; [|discriminate]. apply member_in, Hcuts in Ek.
        destruct (children_of (beyond k) d fs [] Empty) as [[children marks]|] eqn:E; [|discriminate].
        destruct (forallb (marked marks) (not_done k)) eqn:M; [|discriminate].
        inversion H. subst cells'. clear H. rewrite rev_append_rev in G.
        destruct Hc as [<-|Hc]; [|apply G, in_app_iff; auto]. intros t Ht Hd.
        destruct (children_of_sound _ _ _ _ _ _ _ t E Hd) as [(e & Ie & He)|N].
        { intros j h Hj. destruct j; discriminate. }
        { apply (G e); auto. apply in_app_iff. left. apply in_rev in Ie. auto. }
        destruct (Ek t) as [O|(h & Hh & [D|(i & Hi)])]; auto; [right; apply (done_sound qn qd unit optima at_ Hqd Hunit h); auto|].
        exfalso. assert (L := forallb_In _ _ _ M _ Hi). unfold marked in L. cbn [fst snd] in L.
        destruct (member marks i) as [h'|] eqn:Em; [|discriminate]. apply (N _ _ Em). bsplit. apply same_vector_spec in H.
        unfold holds_at in *. rewrite H, H0. auto.
      - destruct (far_away g multipliers d is) eqn:E; [|discriminate]. inversion H. subst cells'.
        destruct Hc as [<-|Hc]; [exact (far_away_sound _ _ _ E)|auto].
    Qed.

    Lemma walk_sound : forall nodes cells, walk g (numbered cuts) multipliers cells nodes = true -> forall c, In c cells -> resolved c.
    Proof.
      induction nodes as [|n nodes IH]; intros cells H; cbn [walk] in H.
      - destruct cells; [intros c []|discriminate].
      - destruct (step g (numbered cuts) multipliers cells n) as [cells'|] eqn:E; [|discriminate].
        apply (step_sound n cells cells' E). apply IH. exact H.
    Qed.
  End Walk.
End Tree.
